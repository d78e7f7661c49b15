#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "reference/text.hpp"
#include "report/charts/chart_style.hpp"
#include "report/charts/stability_map.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"
#include "report/text/svg.hpp"

namespace oddity {

namespace {

// Pixels. The picture is as wide as a page's column, so that its letters are not scaled.
constexpr int map_width = 900, cell_width = 38, cell_height = 17, panel_gap = 16;
constexpr int left_edge = 76, upper_edge = 112, model_height = 44, axis_height = 40;

/// A method's panel: parameter values across, steps down.
struct Panel {
  std::vector<const MapRow*> columns;
  int across, down;  ///< its upper left corner
  bool first;        ///< in its line: it labels the steps
};

/// The panels in lines. A model's panels are together under its name, in the line of the model before if all
/// of them fit.
struct Layout {
  std::vector<Panel> panels;
  struct Name {
    std::string model;
    int across, down;
  };
  std::vector<Name> models;
  int panel_height, height = upper_edge;

  explicit Layout(const Stability& s) : panel_height(cell_height * static_cast<int>(s.steps.size())) {
    std::vector<std::vector<std::vector<const MapRow*>>> groups;  // by model, by method
    for (const MapRow& row : s.map) {
      const auto group =
          std::ranges::find_if(groups, [&](const auto& g) { return g[0][0]->model == row.model; });
      if (group == groups.end()) {
        groups.push_back({{&row}});
        continue;
      }
      const auto method =
          std::ranges::find_if(*group, [&](const auto& m) { return m[0]->algorithm == row.algorithm; });
      if (method == group->end())
        group->push_back({&row});
      else
        method->push_back(&row);
    }
    for (const auto& group : groups) place(group);
    height += panel_height + axis_height;
  }

 private:
  static int right_of(const Panel& p) {
    return p.across + cell_width * static_cast<int>(p.columns.size()) + panel_gap;
  }
  void place(const std::vector<std::vector<const MapRow*>>& group) {
    const auto wide = [](const auto& columns) { return cell_width * static_cast<int>(columns.size()); };
    int across = panels.empty() ? map_width : right_of(panels.back()), all = -panel_gap;
    for (const auto& columns : group) all += wide(columns) + panel_gap;
    const auto begin_line = [&] {
      if (!panels.empty()) height += panel_height + axis_height;
      height += model_height;
      across = left_edge;
    };
    if (across + all > map_width) begin_line();
    models.push_back(
        {shortened(group[0][0]->model, group.size() > 1 ? 60 : 32), across, height - model_height});
    for (const auto& columns : group) {
      if (across + wide(columns) > map_width) begin_line();
      panels.push_back({columns, across, height, across == left_edge});
      across = right_of(panels.back());
    }
  }
};

/// Styles that give the cells the colours of their outcomes, on dark pages too.
std::string cell_styles() {
  std::string css;
  for (Outcome outcome : outcomes_of_a_map)
    css += std::string(".") + letter_of(outcome) + "{fill:" + std::string(colour_of(outcome)) + "}.on-" +
           letter_of(outcome) + "{fill:" + std::string(colour_on(outcome)) + "}";
  return css;
}

/// The middle of a cell.
double middle_of(int edge, std::size_t place, int size) {
  return edge + size * (static_cast<double>(place) + 0.5);
}

/// Draws a panel's cells of one outcome, with their letters.
void add_cells(Svg& svg, const Panel& p, const Stability& s, Outcome outcome) {
  const char letter = letter_of(outcome);
  std::vector<Pixel> places;
  std::string cells;
  for (std::size_t k = 0; k < s.steps.size(); ++k)
    for (std::size_t column = 0; column < p.columns.size(); ++column) {
      if (p.columns[column]->outcomes[k] != outcome) continue;
      const double middle = middle_of(p.across, column, cell_width);
      places.push_back({middle, middle_of(p.down, k, cell_height) + 4});
      cells += "M" + px(middle - cell_width / 2.0 + 0.5) + " " +
               px(p.down + cell_height * static_cast<double>(k) + 0.5) + "h" + px(cell_width - 1) + "v" +
               px(cell_height - 1) + "h-" + px(cell_width - 1) + "z";
    }
  if (!cells.empty()) svg.path(cells, std::string(1, letter));
  if (outcome != Outcome::ok) svg.letters(places, letter, std::string("on-") + letter);
}

/// Marks a cell, given its upper right corner, in the colour of its letter.
void add_corner(Svg& svg, Pixel at, Outcome outcome) {
  constexpr double side = 6;
  svg.area({{at.x - side, at.y}, at, {at.x, at.y + side}}, std::string("on-") + letter_of(outcome));
}

/// Marks the cells whose outcome rounding errors decide.
void add_corners(Svg& svg, const Panel& p) {
  for (std::size_t column = 0; column < p.columns.size(); ++column)
    for (std::size_t k = 0; k < p.columns[column]->fragile.size(); ++k)
      if (p.columns[column]->fragile[k])
        add_corner(svg,
                   {p.across + cell_width * static_cast<double>(column + 1) - 0.5,
                    p.down + cell_height * static_cast<double>(k) + 0.5},
                   p.columns[column]->outcomes[k]);
}

/// Theory's limits as lines; limits beyond the steps shown are drawn along the edge.
std::string theory_lines(const Panel& p, const Stability& s) {
  std::string data;
  for (std::size_t column = 0; column < p.columns.size(); ++column) {
    const auto last = static_cast<double>(s.steps.size());
    const double down = std::clamp(0.5 - std::log2(p.columns[column]->theory / s.steps.front()), 0.0, last);
    data += "M" + px(p.across + cell_width * static_cast<double>(column)) + " " +
            px(p.down + cell_height * down) + "h" + px(cell_width);
  }
  return data;
}

std::string axis_name(const std::string& name, const std::string& unit) {
  return name + (unit.empty() || unit == "1" ? "" : " [" + typeset_unit(unit) + "]");
}

void add_panel(Svg& svg, const Panel& p, const Stability& s, int height) {
  const int width = cell_width * static_cast<int>(p.columns.size());
  svg.text({p.across + width / 2.0, p.down - 6.0}, p.columns[0]->algorithm, "t", Svg::Anchor::middle);
  for (Outcome outcome : outcomes_of_a_map) add_cells(svg, p, s, outcome);
  add_corners(svg, p);
  const std::string theory = theory_lines(p, s);
  svg.path(theory, "rim");
  svg.path(theory, "theory");
  for (std::size_t i = 0; i < p.columns.size(); ++i)
    svg.text({middle_of(p.across, i, cell_width), p.down + height + 14.0},
             with_powers(format_significant(p.columns[i]->value, 3)), "dim small", Svg::Anchor::middle);
  svg.text({p.across + width / 2.0, p.down + height + 30.0}, axis_name(s.parameter, s.parameter_unit),
           "dim small", Svg::Anchor::middle);
  if (!p.first) return;
  for (std::size_t k = 0; k < s.steps.size(); ++k)
    svg.text({p.across - 6.0, middle_of(p.down, k, cell_height) + 4},
             with_powers(format_significant(s.steps[k], 3)), "dim small", Svg::Anchor::end);
  svg.upward_text({14, p.down + height / 2.0}, axis_name("step", s.time_unit), "t");
}

/// Outcome of the first cell that rounding errors decide, if there is one.
std::optional<Outcome> first_fragile(const Stability& s) {
  for (const MapRow& row : s.map)
    for (std::size_t k = 0; k < row.fragile.size(); ++k)
      if (row.fragile[k]) return row.outcomes[k];
  return std::nullopt;
}

/// Draws the legend of the map's outcomes in a line above the panels.
void add_legend(Svg& svg, const Stability& s) {
  constexpr double y = 76, wide = 100;
  double x = 12;
  for (Outcome outcome : outcomes_of_a_map) {
    if (std::ranges::none_of(s.map, [&](const MapRow& row) {
          return std::ranges::find(row.outcomes, outcome) != row.outcomes.end();
        }))
      continue;
    svg.rectangle({x, y}, 20, 17, std::string(1, letter_of(outcome)));
    if (outcome != Outcome::ok)
      svg.letters({{x + 10, y + 13}}, letter_of(outcome), std::string("on-") + letter_of(outcome));
    svg.text({x + 25, y + 13}, std::string(name_of(outcome)), "t");
    x += wide;
  }
  svg.line({x, y + 8}, {x + 20, y + 8}, "rim");
  svg.line({x, y + 8}, {x + 20, y + 8}, "theory");
  svg.text({x + 25, y + 13}, "limit of linear theory", "t");
  if (const auto ends = first_fragile(s)) {
    x += 160;
    svg.rectangle({x, y}, 20, 17, std::string(1, letter_of(*ends)));
    add_corner(svg, {x + 20, y}, *ends);
    svg.text({x + 25, y + 13}, "roundings decide", "t");
  }
}

/// The longest step up to which a method ends ok at every value of the parameter; 0 if none does.
double longest_ok(const Panel& p, const Stability& s) {
  double longest = 0;
  for (std::size_t k = s.steps.size(); k-- > 0; longest = s.steps[k])
    if (std::ranges::any_of(p.columns, [&](const MapRow* row) { return row->outcomes[k] != Outcome::ok; }))
      break;
  return longest;
}

std::string finding_of(const Layout& layout, const Stability& s) {
  const auto best =
      std::ranges::max_element(layout.panels, {}, [&](const Panel& p) { return longest_ok(p, s); });
  const std::string everywhere = "ok at every " + s.parameter;
  if (best == layout.panels.end() || longest_ok(*best, s) == 0) return "No method is " + everywhere;
  return best->columns[0]->algorithm + " (" + best->columns[0]->model + ") is " + everywhere +
         " up to the longest step, " + format_significant(longest_ok(*best, s), 3) + " " + s.time_unit;
}

}  // namespace

std::string map_svg(const ExerciseResult& e) {
  const Stability& s = *e.stability;
  const Layout layout(s);
  const std::string says = finding_of(layout, s);
  Svg svg(map_width, layout.height, map_title(e) + ". " + says, cell_styles());
  svg.headline(says, map_title(e));
  add_legend(svg, s);
  for (const auto& [model, across, down] : layout.models)
    svg.text({static_cast<double>(across), down + 16.0}, model, "t b");
  for (const Panel& p : layout.panels) add_panel(svg, p, s, layout.panel_height);
  return svg.str();
}

std::string map_finding(const ExerciseResult& e) { return finding_of(Layout(*e.stability), *e.stability); }

std::string map_title(const ExerciseResult& e) {
  return to_string(e.number) + " " + e.title + ": how each method ends over step and " +
         e.stability->parameter;
}

}  // namespace oddity
