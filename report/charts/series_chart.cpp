// Charts of the work at growing sizes.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "reference/text.hpp"
#include "report/charts/axes.hpp"
#include "report/charts/chart_parts.hpp"

namespace oddity {

namespace {

/// The size at the end of a name, "chain_of_100", or 0.
long size_in_name(const std::string& name) {
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  if (digits == 0 || digits == name.size() || name[digits - 1] != '_') return 0;
  long size = 0;  // stays 0 if there are too many digits
  std::from_chars(name.data() + digits, name.data() + name.size(), size);
  return size;
}

std::string without_size(const std::string& name) {
  return name.substr(0, name.find_last_not_of("0123456789") + 1);
}

/// A method's work at growing sizes.
struct Growth {
  const MethodResult* method;
  std::vector<std::pair<double, double>> points;

  /// "work ~ n^2".
  std::string law() const {
    if (points.size() < 2) return "";
    const auto& [size, work] = points.back();
    const auto& [first_size, first_work] = points.front();
    return " (work ~ n^" + format_significant(std::log(work / first_work) / std::log(size / first_size), 3) +
           ")";
  }
};

std::vector<Growth> growths(const std::vector<const QuantityResult*>& series) {
  std::vector<Growth> all;
  for (const QuantityResult* q : series)
    for (const MethodResult& m : q->methods) {
      auto found = std::ranges::find_if(all, [&](const Growth& g) {
        return g.method->model == m.model && g.method->algorithm == m.algorithm;
      });
      if (found == all.end()) found = all.insert(all.end(), {&m, {}});
      found->points.emplace_back(static_cast<double>(size_in_name(q->name)),
                                 cost(m.trials.back(), Cost::evaluations));
    }
  return all;
}

}  // namespace

std::vector<std::vector<const QuantityResult*>> series_of(const ExerciseResult& e) {
  std::vector<std::vector<const QuantityResult*>> all;
  for (const QuantityResult& q : e.quantities) {
    if (size_in_name(q.name) == 0 || has_chart(q)) continue;
    const auto same = std::ranges::find_if(
        all, [&](const auto& series) { return without_size(series[0]->name) == without_size(q.name); });
    if (same == all.end())
      all.push_back({&q});
    else
      same->push_back(&q);
  }
  std::erase_if(all, [](const auto& series) { return series.size() < 3; });
  for (auto& series : all)
    std::ranges::sort(series, {}, [](const QuantityResult* q) { return size_in_name(q->name); });
  return all;
}

std::string series_finding(const std::vector<const QuantityResult*>& series) {
  std::pair<double, std::string> cheapest{INFINITY, ""};
  for (const Growth& g : growths(series)) {
    const auto& [size, work] = g.points.back();
    cheapest = std::min(cheapest, {work / size, named(g.method->trials.back()) + " needs the least work: " +
                                                    with_commas(std::lround(work)) +
                                                    " for n = " + format_significant(size, 6)});
  }
  return cheapest.second;
}

std::string series_svg(const std::vector<const QuantityResult*>& series, const std::string& title) {
  const std::vector<Growth> all = growths(series);
  Range sizes, works;
  for (const Growth& g : all)
    for (const auto& [size, work] : g.points) sizes.see(size), works.see(work);
  sizes = sizes.decades(), works = works.decades();
  Svg svg(chart_width, least_plot_height + 70 + below_plot, title + ". " + series_finding(series));
  const double top = svg.headline(series_finding(series), title), bottom = least_plot_height + 70;
  const Plot plot{{sizes.low / 1.1, sizes.high * 1.1, plot_left, plot_right, true},
                  {works.low / 1.2, works.high * 1.2, bottom, top, true}};
  add_axes(svg, plot, "n", "counted work");
  std::vector<Label> labels;
  int slot = 0;
  for (const Growth& g : all) {
    std::vector<Pixel> points;
    for (const auto& [size, work] : g.points) points.push_back(plot(size, work));
    svg.curve(points, "curve " + colour_class(slot));
    svg.marks(points, slot, "mark");
    labels.push_back({points.back(), g.method->model + ", " + g.method->algorithm + g.law(), slot++});
  }
  add_labels(svg, labels, top, bottom);
  return svg.str();
}

}  // namespace oddity
