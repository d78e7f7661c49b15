#include <algorithm>
#include <array>
#include <cmath>

#include "reference/text.hpp"
#include "report/gnuplot.hpp"
#include "report/stability.hpp"

namespace oddity {

namespace {

/// Of those by Okabe and Ito, which colour-blind readers can tell apart; in the order of `outcomes_of_a_map`.
constexpr std::array<std::string_view, 8> colours{"009E73", "F0E442", "E69F00", "D55E00",
                                                  "CC79A7", "56B4E9", "999999", "0072B2"};

std::string colour_of(Outcome outcome) {
  const auto place = std::ranges::find(outcomes_of_a_map, outcome) - outcomes_of_a_map.begin();
  return std::string(colours[static_cast<std::size_t>(place)]);
}

// Pixels.
constexpr int cell_width = 34, cell_height = 17, panel_gap = 22, title_height = 76;
constexpr int left_edge = 96, upper_edge = 74, lower_edge = 40, key_width = 150;

/// Each name once, in the order of first appearance.
template <class T, class Name>
auto each_once(const std::vector<T>& items, Name T::*name) {
  std::vector<Name> names;
  for (const T& item : items)
    if (std::ranges::find(names, item.*name) == names.end()) names.push_back(item.*name);
  return names;
}

/// The panels of a map: models down, algorithms across, and in each the values across and the steps down.
struct Layout {
  std::vector<std::string> models, algorithms;
  std::vector<double> values;
  int panel_width, panel_height, width, height;

  explicit Layout(const Stability& s)
      : models(each_once(s.map, &MapRow::model)),
        algorithms(each_once(s.map, &MapRow::algorithm)),
        values(each_once(s.map, &MapRow::value)),
        panel_width(cell_width * static_cast<int>(values.size())),
        panel_height(cell_height * static_cast<int>(s.steps.size())),
        width(left_edge + static_cast<int>(algorithms.size()) * (panel_width + panel_gap) + key_width),
        height(upper_edge + static_cast<int>(models.size()) * (panel_height + title_height) - title_height +
               lower_edge) {}

  std::string x(int pixels) const { return shortest(static_cast<double>(pixels) / width); }
  std::string y(int pixels) const { return shortest(1 - static_cast<double>(pixels) / height); }
  std::string at(int across, int down) const { return "screen " + x(across) + ", screen " + y(down); }

  std::string margins(std::size_t model, std::size_t algorithm) const {
    const int across = left_edge + static_cast<int>(algorithm) * (panel_width + panel_gap);
    const int down = upper_edge + static_cast<int>(model) * (panel_height + title_height);
    return "set lmargin at screen " + x(across) + "\nset rmargin at screen " + x(across + panel_width) +
           "\nset tmargin at screen " + y(down) + "\nset bmargin at screen " + y(down + panel_height) + "\n";
  }
};

std::string tics(const std::vector<double>& numbers, int direction) {
  std::string list;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    list += (i ? ", " : "") + quoted(rounded(numbers[i], 3)) + " " +
            std::to_string(direction * static_cast<int>(i));
  return "(" + list + ")";
}

/// The cells of one panel as gnuplot's data: column, row, colour, letter; then theory's limits as lines,
/// those beyond the steps shown along the edge.
std::string panel_data(const std::vector<const MapRow*>& columns, const Stability& s) {
  std::string cells, theory;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const MapRow& row = *columns[column];
    for (std::size_t k = 0; k < row.outcomes.size(); ++k)
      cells += std::to_string(column) + " -" + std::to_string(k) + " 0x" + colour_of(row.outcomes[k]) + " " +
               letter_of(row.outcomes[k]) + "\n";
    const double top_edge = 0.5, bottom_edge = top_edge - static_cast<double>(s.steps.size());
    const double height = std::clamp(std::log2(row.theory / s.steps.front()), bottom_edge, top_edge);
    theory += shortest(static_cast<double>(column) - 0.5) + " " + rounded(height, 5) + " 1 0\n";
  }
  return "$cells << EOD\n" + cells + "EOD\n$theory << EOD\n" + theory + "EOD\n";
}

std::string legend_text(const Layout& layout) {
  const int x = layout.width - key_width + 8;
  std::string text;
  int y = upper_edge;
  for (Outcome outcome : outcomes_of_a_map) {
    text += "set object rectangle from " + layout.at(x, y) + " to " + layout.at(x + 22, y + 16) +
            " fc rgb '#" + colour_of(outcome) + "' fs solid 1 noborder\nset label '" + letter_of(outcome) +
            "' at " + layout.at(x + 11, y + 8) + " center font ',10' front\nset label '" +
            std::string(name_of(outcome)) + "' at " + layout.at(x + 30, y + 8) + " left font ',11'\n";
    y += 20;
  }
  return text + "set arrow from " + layout.at(x, y + 15) + " to " + layout.at(x + 22, y + 15) +
         " nohead lw 3 lc rgb '#000000'\nset label \"limit of\\nlinear theory\" at " +
         layout.at(x + 30, y + 8) + " left font ',11'\n";
}

std::string axis_name(const std::string& name, const std::string& unit) {
  return quoted(name + (unit.empty() || unit == "1" ? "" : " [" + unit + "]")) + " noenhanced";
}

/// One method's panel; the first of a row names the steps.
std::string panel(const std::vector<const MapRow*>& columns, const Stability& s, const Layout& layout,
                  bool first) {
  return panel_data(columns, s) + "set title " + quoted(columns[0]->model + "\n" + columns[0]->algorithm) +
         " noenhanced font ',11' offset 0,-0.6\nset xtics " + tics(layout.values, 1) + "\nset xlabel " +
         axis_name(s.parameter, s.parameter_unit) + " font ',10' offset 0,0.7\nset ytics " +
         (first ? tics(s.steps, -1) : "('' 0)") + "\nset ylabel " +
         (first ? axis_name("step", s.time_unit) : "''") +
         " font ',11'\nplot $cells using 1:2:(0.49):(0.48):3 with boxxyerror lc rgb variable, $cells using "
         "1:2:4 with labels font ',9', $theory using 1:2:3:4 with vectors nohead lw 3 lc rgb '#000000'\n"
         "unset label\nunset object\nunset arrow\n";
}

}  // namespace

std::string map_script(const ExerciseResult& e, const std::string& file) {
  const Stability& s = *e.stability;
  const Layout layout(s);
  std::string text =
      "reset session\nset terminal svg size " + std::to_string(layout.width) + "," +
      std::to_string(layout.height) + " dynamic font 'Helvetica,12' background '#ffffff'\n" +
      set_output(file) +
      "set multiplot\nunset key\nset border 0\nset tics scale 0 nomirror font ',10'\n"
      "set style fill solid 1 noborder\nset xrange [-0.5:" +
      shortest(static_cast<double>(layout.values.size()) - 0.5) + "]\nset yrange [" +
      shortest(0.5 - static_cast<double>(s.steps.size())) + ":0.5]\nset label " +
      quoted(to_string(e.number) + " " + e.title + ": how each method ends over step and " + s.parameter) +
      " at " + layout.at(layout.width / 2, 18) + " center noenhanced font ',14'\n" + legend_text(layout);
  for (std::size_t m = 0; m < layout.models.size(); ++m) {
    bool first = true;
    for (std::size_t a = 0; a < layout.algorithms.size(); ++a) {
      std::vector<const MapRow*> columns;
      for (const MapRow& row : s.map)
        if (row.model == layout.models[m] && row.algorithm == layout.algorithms[a]) columns.push_back(&row);
      if (columns.empty()) continue;
      text += layout.margins(m, a) + panel(columns, s, layout, first);
      first = false;
    }
  }
  return text + "unset multiplot\nunset output\n";
}

}  // namespace oddity
