#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "reference/text.hpp"
#include "report/charts/chart_style.hpp"
#include "report/charts/gnuplot.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace {

// Pixels. The picture is as wide as the column of a page, so that its letters are read in their own size.
constexpr int map_width = 900, cell_width = 38, cell_height = 17, panel_gap = 16;
constexpr int left_edge = 76, upper_edge = 96, model_height = 44, axis_height = 40;

/// A method's panel: the values across and the steps down.
struct Panel {
  std::vector<const MapRow*> columns;
  int across, down;  ///< its upper left corner
  bool first;        ///< of its line: it names the steps
};

/// The panels in lines. A model's stand together under its name, after those of the model before where all of
/// them fit.
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

  std::string x(int pixels) const { return shortest(static_cast<double>(pixels) / map_width); }
  std::string y(int pixels) const { return shortest(1 - static_cast<double>(pixels) / height); }
  std::string at(int across, int down) const { return "screen " + x(across) + ", screen " + y(down); }

  std::string margins(const Panel& p) const {
    const int right = p.across + cell_width * static_cast<int>(p.columns.size());
    return "set lmargin at screen " + x(p.across) + "\nset rmargin at screen " + x(right) +
           "\nset tmargin at screen " + y(p.down) + "\nset bmargin at screen " + y(p.down + panel_height) +
           "\n";
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
        {shortened(group[0][0]->model, group.size() > 1 ? 60 : 24), across, height - model_height});
    for (const auto& columns : group) {
      if (across + wide(columns) > map_width) begin_line();
      panels.push_back({columns, across, height, across == left_edge});
      across = right_of(panels.back());
    }
  }
};

std::string tics(const std::vector<double>& numbers, int direction) {
  std::string list;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    list += (i ? ", " : "") + quoted(rounded(numbers[i], 3)) + " " +
            std::to_string(direction * static_cast<int>(i));
  return "(" + list + ")";
}

/// The cells of one panel as gnuplot's data: column, row, colour, letter and the letter's colour; then
/// theory's limits as lines, those beyond the steps shown along the edge.
std::string panel_data(const std::vector<const MapRow*>& columns, const Stability& s) {
  const auto number = [](std::string_view colour) { return " 0x" + std::string(colour.substr(1)); };
  std::string cells, theory;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const MapRow& row = *columns[column];
    for (std::size_t k = 0; k < row.outcomes.size(); ++k)
      cells += std::to_string(column) + " -" + std::to_string(k) + number(colour_of(row.outcomes[k])) + " " +
               letter_of(row.outcomes[k]) + number(colour_on(row.outcomes[k])) + "\n";
    const double top_edge = 0.5, bottom_edge = top_edge - static_cast<double>(s.steps.size());
    const double height = std::clamp(std::log2(row.theory / s.steps.front()), bottom_edge, top_edge);
    theory += shortest(static_cast<double>(column) - 0.5) + " " + rounded(height, 5) + " 1 0\n";
  }
  return "$cells << EOD\n" + cells + "EOD\n$theory << EOD\n" + theory + "EOD\n";
}

/// The outcomes that the map has, in a line above the panels.
std::string legend_text(const Stability& s, const Layout& layout) {
  constexpr int y = 60, wide = 102;
  std::string text;
  int x = 12;
  for (Outcome outcome : outcomes_of_a_map) {
    if (std::ranges::none_of(s.map, [&](const MapRow& row) {
          return std::ranges::find(row.outcomes, outcome) != row.outcomes.end();
        }))
      continue;
    text += "set object rectangle from " + layout.at(x, y) + " to " + layout.at(x + 20, y + 17) +
            " fc rgb '" + std::string(colour_of(outcome)) + "' fs solid 1 noborder\nset label '" +
            letter_of(outcome) + "' at " + layout.at(x + 10, y + 8) + " center font ',12' tc rgb '" +
            std::string(colour_on(outcome)) + "' front\nset label '" + std::string(name_of(outcome)) +
            "' at " + layout.at(x + 25, y + 8) + " left font ',12'\n";
    x += wide;
  }
  return text + "set arrow from " + layout.at(x, y + 8) + " to " + layout.at(x + 20, y + 8) +
         " nohead lw 3 lc rgb '#000000'\nset label 'limit of linear theory' at " + layout.at(x + 25, y + 8) +
         " left font ',12'\n";
}

std::string axis_name(const std::string& name, const std::string& unit) {
  return quoted(name + (unit.empty() || unit == "1" ? "" : " [" + unit + "]")) + " noenhanced";
}

std::string panel_text(const Panel& p, const Stability& s) {
  std::vector<double> values;
  for (const MapRow* row : p.columns) values.push_back(row->value);
  return panel_data(p.columns, s) + "set title " + quoted(p.columns[0]->algorithm) +
         " noenhanced font ',12' offset 0,-0.7\nset xrange [-0.5:" +
         shortest(static_cast<double>(values.size()) - 0.5) + "]\nset xtics " + tics(values, 1) +
         "\nset xlabel " + axis_name(s.parameter, s.parameter_unit) +
         " noenhanced font ',12' offset 0,0.7\nset ytics " + (p.first ? tics(s.steps, -1) : "('' 0)") +
         "\nset ylabel " + (p.first ? axis_name("step", s.time_unit) : "''") +
         " font ',12'\nplot $cells using 1:2:(0.49):(0.48):3 with boxxyerror lc rgb variable, "
         "$theory using 1:2:3:4 with vectors nohead lw 5 lc rgb '#ffffff', "
         "$theory using 1:2:3:4 with vectors nohead lw 2.5 lc rgb '#000000', "
         "$cells using 1:2:4:5 with labels font ',12' tc rgb variable\nunset label\nunset object\nunset "
         "arrow\n";
}

/// The longest step from which on a method ends ok at every value of the parameter; 0: none.
double longest_ok(const Panel& p, const Stability& s) {
  double longest = 0;
  for (std::size_t k = s.steps.size(); k-- > 0; longest = s.steps[k])
    if (std::ranges::any_of(p.columns, [&](const MapRow* row) { return row->outcomes[k] != Outcome::ok; }))
      break;
  return longest;
}

std::string map_finding(const Layout& layout, const Stability& s) {
  const auto best =
      std::ranges::max_element(layout.panels, {}, [&](const Panel& p) { return longest_ok(p, s); });
  const std::string everywhere = "ok at every " + s.parameter;
  if (best == layout.panels.end() || longest_ok(*best, s) == 0) return "No method is " + everywhere;
  return best->columns[0]->algorithm + " (" + best->columns[0]->model + ") is " + everywhere +
         " up to the longest step, " + rounded(longest_ok(*best, s), 3) + " " + s.time_unit;
}

}  // namespace

std::string map_script(const ExerciseResult& e, const std::string& file) {
  const Stability& s = *e.stability;
  const Layout layout(s);
  std::string text = "reset session\nset terminal svg size " + std::to_string(map_width) + "," +
                     std::to_string(layout.height) + " dynamic font 'Helvetica,12' background '#ffffff'\n" +
                     set_output(file) +
                     "set multiplot\nunset key\nset border 0\nset tics scale 0 nomirror font ',11'\n"
                     "set style fill solid 1 noborder\nset yrange [" +
                     shortest(0.5 - static_cast<double>(s.steps.size())) + ":0.5]\n" +
                     headline(map_finding(layout, s), map_title(e), layout.height) + legend_text(s, layout);
  for (const auto& [model, across, down] : layout.models)
    text += "set label " + quoted(bold(model)) + " at " + layout.at(across, down + 12) + " left font ',13'\n";
  for (const Panel& p : layout.panels) text += layout.margins(p) + panel_text(p, s);
  return text + "unset multiplot\nunset output\n";
}

std::string map_title(const ExerciseResult& e) {
  return to_string(e.number) + " " + e.title + ": how each method ends over step and " +
         e.stability->parameter;
}

}  // namespace oddity
