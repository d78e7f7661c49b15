#include "extras/engines/chart.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "extras/engines/labels.hpp"
#include "report/charts/axes.hpp"
#include "report/charts/chart_parts.hpp"

namespace oddity {

namespace {

constexpr double least_error = 1e-6;  ///< in tolerances; smaller errors are drawn there
constexpr std::size_t most_curves = svg_slots;

struct NamedCurve {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< error in tolerances over the abscissa

  double last() const { return points.back().second; }
};

/// Whether the errors are within a tenth of each other at every rate.
bool alike(const NamedCurve& a, const NamedCurve& b) {
  return std::ranges::equal(a.points, b.points, [](const auto& p, const auto& q) {
    return p.first == q.first && std::abs(p.second - q.second) <= 0.1 * std::max(p.second, q.second);
  });
}

template <class Across>
NamedCurve curve_of(const EngineSeries& s, const Across& across) {
  NamedCurve curve{full_name(s), {}};
  for (const EngineTrial& t : s.trials)
    if (std::isfinite(t.in_needs) && across(t) > 0) curve.points.emplace_back(across(t), t.in_needs);
  return curve;
}

std::vector<NamedCurve> own_curves(const EngineContest& contest, const std::vector<OwnSteps>& own) {
  std::vector<NamedCurve> curves;
  for (const OwnSteps& steps : own) {
    NamedCurve curve{"our models by " + steps.algorithm, {}};
    for (const auto& [count, error] : steps.errors)
      if (std::isfinite(error)) curve.points.emplace_back(count * contest.frames_per_second, error);
    if (!curve.points.empty()) curves.push_back(std::move(curve));
  }
  return curves;
}

/// Curves of the defaults, in order of increasing error.
std::vector<NamedCurve> default_curves(const EngineContest& contest) {
  std::vector<NamedCurve> curves;
  for (const EngineSeries& s : contest.series) {
    if (!s.defaults || !s.cannot.empty()) continue;
    NamedCurve curve =
        curve_of(s, [&](const EngineTrial& t) { return t.steps_per_frame * contest.frames_per_second; });
    if (curve.points.empty()) continue;
    const auto same = std::ranges::find_if(curves, [&](const NamedCurve& c) { return alike(c, curve); });
    if (same == curves.end())
      curves.push_back(std::move(curve));
    else
      same->name += ", " + curve.name;
  }
  std::ranges::stable_sort(curves, {}, &NamedCurve::last);
  return curves;
}

std::size_t places(const std::vector<OwnSteps>& own, const EngineContest& contest) {
  return most_curves - std::min(most_curves, own_curves(contest, own).size());
}

/// Curves below the tolerance, with their names at their ends.
std::string drawn(const std::vector<NamedCurve>& curves, const std::string& says, const std::string& of,
                  const std::string& across) {
  Range abscissas, errors;
  errors.see(1);
  for (const NamedCurve& curve : curves)
    for (const auto& [x, y] : curve.points) abscissas.see(x), errors.see(std::max(y, least_error));
  if (abscissas.empty()) abscissas.see(1);
  errors = errors.decades();
  const double height = least_plot_height + 90;
  Svg svg(chart_width, height + below_plot, of + ". " + says);
  const double top = svg.headline(says, of);
  const Plot plot{{abscissas.low / 1.2, abscissas.high * 1.2, plot_left, plot_right, true},
                  {errors.low / 1.3, errors.high * 1.3, height, top, true}};
  svg.rectangle({plot_left, plot.y(1)}, plot_right - plot_left, height - plot.y(1), "good");
  add_axes(svg, plot, across, "worst error / allowed error");
  svg.line({plot_left, plot.y(1)}, {plot_right, plot.y(1)}, "need");
  std::vector<Label> labels;
  int slot = 0;
  for (const NamedCurve& curve : curves) {
    std::vector<Pixel> points;
    for (const auto& [x, y] : curve.points) points.push_back(plot(x, std::max(y, least_error)));
    svg.curve(points, "curve " + colour_class(slot));
    svg.marks(points, slot, "mark");
    labels.push_back({points.back(), curve.name, slot++});
  }
  add_labels(svg, labels, top, height);
  return svg.str();
}

std::string title_of(const EngineContest& contest) { return contest.scene + " " + contest.title; }

/// "At 60 Hz 4 of 13 engines are within 1 deg by their defaults".
std::string finding_of(const EngineContest& contest) {
  int all = 0, enough = 0;
  for (const EngineSeries& s : contest.series) {
    if (!s.defaults || s.trials.empty()) continue;
    ++all;
    enough += s.trials.front().outcome == Outcome::ok;
  }
  return "At 60 Hz " + std::to_string(enough) + " of " + std::to_string(all) + " engines are within " +
         pictured(contest.needs, contest.units) + " by their defaults";
}

}  // namespace

std::string engine_rates_svg(const EngineContest& contest, const std::vector<OwnSteps>& own) {
  std::vector<NamedCurve> curves = default_curves(contest);
  curves.resize(std::min(curves.size(), places(own, contest)));
  std::ranges::move(own_curves(contest, own), std::back_inserter(curves));
  return drawn(curves, finding_of(contest), title_of(contest), "steps a second");
}

namespace {

/// Orders first those that meet the tolerance, by time, then the others by error.
bool pays_less(const EngineSeries* a, const EngineSeries* b) {
  const auto price = [](const EngineSeries* s) {
    const EngineTrial* enough = s->first_enough();
    return std::pair(enough ? enough->seconds_per_frame : std::numeric_limits<double>::infinity(), s->floor);
  };
  return price(a) < price(b);
}

NamedCurve choice_curve(const EngineContest& contest) {
  double error = 0;
  for (std::size_t i = 0; i < contest.needs.size(); ++i)
    error = std::max(error, contest.least->errors[i] / contest.needs[i]);
  return {contest.least->says, {{contest.least->seconds_per_frame, error}}};
}

}  // namespace

std::string engine_times_svg(const EngineContest& contest, bool webassembly) {
  std::vector<const EngineSeries*> series;
  for (const EngineSeries& s : contest.series)
    if (s.webassembly == webassembly && s.cannot.empty()) series.push_back(&s);
  std::ranges::stable_sort(series, pays_less);
  const bool ours = contest.least && !webassembly;
  series.resize(std::min(series.size(), most_curves - ours));
  std::vector<NamedCurve> curves;
  for (const EngineSeries* s : series)
    curves.push_back(curve_of(*s, [](const EngineTrial& t) { return t.seconds_per_frame; }));
  if (ours) curves.push_back(choice_curve(contest));
  std::erase_if(curves, [](const NamedCurve& c) { return c.points.empty(); });
  return drawn(curves,
               webassembly ? "Behind WebAssembly: times that no native program has"
                           : "The fastest native variants that are accurate enough",
               title_of(contest) + "; beyond 240 Hz one run each", "seconds a frame");
}

}  // namespace oddity
