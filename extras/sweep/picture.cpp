#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "extras/sweep/merge.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/charts/axes.hpp"
#include "report/charts/chart_style.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"

namespace oddity::sweep {

namespace {

// Pixels.
constexpr double picture_width = 900, left = 80, right = 620, legend_left = 644, legend_height = 24,
                 plot_size = 520, least_plot_height = 60;

constexpr std::string_view unknown = "#8c959f";
/// From dark to bright in perceptually even steps, also for the colour-blind [van der Walt and Smith's
/// viridis, 2015].
constexpr std::array<std::string_view, 10> shades{"#440154", "#482878", "#3e4989", "#31688e", "#26828e",
                                                  "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"};
/// Colours of chosen methods.
constexpr std::array<std::string_view, 10> hues{"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9",
                                                "#d55e00", "#f0e442", "#7a1f52", "#50565d", "#b2df8a"};

/// A kind of cell: its colour, its text, and their number.
struct Kind {
  std::string_view colour;
  std::string says;
  long cells = 0;
};

/// The kind of each cell of a map.
struct Kinds {
  std::vector<Kind> kinds;
  std::vector<std::uint16_t> of_cell;

  void count() {
    for (std::uint16_t kind : of_cell) ++kinds[kind].cells;
  }
};

Kinds by_ending(const Map& map) {
  Kinds all{{}, map.ended};
  std::size_t hue = 0;
  for (const std::string& ending : map.endings) {
    const auto outcome =
        std::ranges::find(outcomes_of_a_map, ending, [](Outcome o) { return std::string(name_of(o)); });
    all.kinds.push_back(
        {outcome == outcomes_of_a_map.end() ? hues[hue++ % hues.size()] : colour_of(*outcome), ending});
  }
  all.count();
  return all;
}

/// At most ten kinds, each a whole number of decades.
Kinds by_decades(const std::vector<double>& numbers) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (double x : numbers)
    if (x > 0 && std::isfinite(x))
      least = std::min(least, std::log10(x)), most = std::max(most, std::log10(x));
  if (!(least <= most)) throw BadInput("no cell has a number to show");
  const double from = std::floor(least);
  const double decades = std::max(1.0, std::ceil((most - from) / static_cast<double>(shades.size())));
  const auto decade = [&](std::size_t i) {
    const double power = from + decades * static_cast<double>(i);
    return with_powers("1e" + std::string(power < 0 ? "" : "+") + format_shortest(power));
  };
  Kinds all;
  for (std::size_t i = 0; i < shades.size(); ++i)
    all.kinds.push_back({shades[i], decade(i) + " to " + decade(i + 1)});
  all.kinds.push_back({unknown, "none, or not finite"});
  for (double x : numbers) {
    const double shade = x == 0 ? 0 : std::floor((std::log10(x) - from) / decades);
    const auto last = static_cast<double>(shades.size() - 1);
    all.of_cell.push_back(
        static_cast<std::uint16_t>(std::isfinite(shade) ? std::clamp(shade, 0.0, last) : last + 1));
  }
  all.count();
  return all;
}

Kinds kinds_of(const Map& map, Shown shown) {
  if (shown == Shown::outcome) return by_ending(map);
  if (std::ranges::find(map.looked, 0) != map.looked.end())
    throw BadInput(
        "only the cells where neighbours end differently were looked at: a sweep planned with "
        "--every-cell has errors and costs to show");
  return by_decades(shown == Shown::error ? map.error : map.evaluations);
}

Scale scale_of(const Axis& axis, double from, double to) {
  return {axis.from, axis.to, from, to, axis.by_factor};
}

std::string name_of_axis(const Axis& axis) {
  return axis.name + (axis.unit.empty() || axis.unit == "1" ? "" : " [" + typeset_unit(axis.unit) + "]");
}

/// Draws runs of cells of one kind, row by row.
void add_cells(Svg& svg, const Map& map, const Kinds& kinds, double top, double height) {
  const double wide = (right - left) / map.width, high = height / map.height;
  std::vector<std::string> data(kinds.kinds.size());
  for (int y = 0; y < map.height; ++y)
    for (int x = 0, run = 0; x < map.width; x += run) {
      const std::uint16_t kind = kinds.of_cell[map.place(x, y)];
      for (run = 1; x + run < map.width && kinds.of_cell[map.place(x + run, y)] == kind;) ++run;
      data[kind] += "M" + format_significant(left + wide * x, 6) + " " +
                    format_significant(top + high * (map.height - 1 - y), 6) + "h" +
                    format_significant(wide * run, 5) + "v" + format_significant(high, 5) + "h-" +
                    format_significant(wide * run, 5) + "z";
    }
  for (std::size_t kind = 0; kind < data.size(); ++kind)
    if (!data[kind].empty()) svg.path(data[kind], "k" + std::to_string(kind));
}

void add_legend(Svg& svg, const Kinds& kinds, double top) {
  for (std::size_t kind = 0; kind < kinds.kinds.size(); ++kind) {
    const Kind& k = kinds.kinds[kind];
    if (k.cells == 0) continue;
    svg.rectangle({legend_left, top}, 20, 17, "k" + std::to_string(kind));
    const double part = 100 * static_cast<double>(k.cells) / static_cast<double>(kinds.of_cell.size());
    svg.text({legend_left + 26, top + 13}, shortened(k.says, 30) + ", " + format_significant(part, 3) + " %",
             "t");
    top += legend_height;
  }
}

std::string subject(const Map& map) {
  const Asked& asked = map.asked;
  return asked.exercise + ", " +
         (asked.algorithm.empty() ? "what to choose" : asked.model + ", " + asked.algorithm);
}

}  // namespace

std::string picture(const Map& map, Shown shown) {
  const Kinds kinds = kinds_of(map, shown);
  std::string css;
  for (std::size_t kind = 0; kind < kinds.kinds.size(); ++kind)
    css += ".k" + std::to_string(kind) + "{fill:" + std::string(kinds.kinds[kind].colour) +
           ";shape-rendering:crispEdges}";
  const std::string what = shown == Shown::outcome ? "how each cell ends"
                           : shown == Shown::error ? "the error, in needs"
                                                   : "the work, in evaluations";
  const double height = map.height == 1 ? least_plot_height : plot_size;
  Svg svg(picture_width, height + 150, subject(map) + ": " + what, css);
  const double top = svg.headline(subject(map) + ": " + what, summary(map)) + 12;
  add_cells(svg, map, kinds, top, height);
  const Scale across = scale_of(map.asked.axes[0], left, right);
  const Scale upward =
      map.height == 1 ? Scale{0, 1, top + height, top} : scale_of(map.asked.axes[1], top + height, top);
  for (double tick : ticks(across, 8)) {
    svg.line({across(tick), top + height}, {across(tick), top + height + 5}, "axis");
    svg.text({across(tick), top + height + 18}, tick_label(across, tick), "dim", Svg::Anchor::middle);
  }
  svg.text({(left + right) / 2, top + height + 40}, name_of_axis(map.asked.axes[0]), "t",
           Svg::Anchor::middle);
  if (map.height > 1) {
    for (double tick : ticks(upward, 12)) {
      svg.line({left - 5, upward(tick)}, {left, upward(tick)}, "axis");
      svg.text({left - 8, upward(tick) + 4}, tick_label(upward, tick), "dim", Svg::Anchor::end);
    }
    svg.upward_text({16, top + height / 2}, name_of_axis(map.asked.axes[1]), "t");
  }
  add_legend(svg, kinds, top);
  return svg.str();
}

}  // namespace oddity::sweep
