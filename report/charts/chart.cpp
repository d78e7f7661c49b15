#include "report/charts/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "reference/text.hpp"
#include "report/charts/axes.hpp"
#include "report/charts/chart_parts.hpp"
#include "report/charts/labels.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

// ---- parts of a chart -------------------------------------------------------------------------------------

/// A curve with its colour, mark and label.
struct Curve {
  const MethodResult* method;
  int slot;
  std::string label;
};

/// The points as text, rounded to about 2 %: curves with equal texts look the same.
std::string seen(const Frame& frame, const MethodResult& m) {
  std::string text;
  const auto place = [](double x) { return std::to_string(std::lround(100 * std::log10(x))) + " "; };
  for (const TimedTrial& t : m.trials) text += place(frame.x(t)) + place(frame.y(t));
  return text;
}

/// The first method of each family has the family's colour in every chart; the others get the remaining
/// colours.
std::vector<int> slots_of(const std::vector<const MethodResult*>& methods) {
  constexpr int none = -1;
  std::vector<int> slots(methods.size(), none);
  const auto is_taken = [&](int slot) { return std::ranges::find(slots, slot) != slots.end(); };
  for (std::size_t i = 0; i < methods.size(); ++i)
    if (const int own = static_cast<int>(family_of(methods[i]->algorithm)) - 1; own != none && !is_taken(own))
      slots[i] = own;
  int next = 0;  // colours repeat after the last
  for (int& slot : slots)
    if (slot == none) {
      while (next < svg_slots && is_taken(next)) ++next;
      slot = next++;
    }
  return slots;
}

/// Curves with their labels; the label of a curve that coincides with an earlier one names it.
std::vector<Curve> curves_of(const QuantityResult& q, const Frame& frame,
                             const std::vector<std::size_t>& chosen) {
  std::vector<const MethodResult*> methods;
  for (std::size_t i : chosen)
    if (frame.shows(q.methods[i])) methods.push_back(&q.methods[i]);
  const bool one_model =
      std::ranges::all_of(methods, [&](const MethodResult* m) { return m->model == methods.front()->model; });
  const auto name = [&](const MethodResult& m) {
    return one_model ? m.algorithm : m.algorithm == "closed form" ? m.model : m.model + ", " + m.algorithm;
  };
  const std::vector<int> slots = slots_of(methods);
  std::map<std::string, const MethodResult*> drawn;
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const MethodResult& m = *methods[i];
    const auto [same, first] = drawn.try_emplace(seen(frame, m), &m);
    const std::string fitted = with_powers(shown_fit(m, fit(q, m)));
    const std::string said = !first           ? ": as " + name(*same->second)
                             : fitted.empty() ? ""
                                              : " (" + fitted + ")";
    const bool fits = !first || name(m).size() + said.size() <= longest_label;
    curves.push_back({&m, slots[i], name(m) + (fits ? said : "")});
  }
  return curves;
}

Plot plot_of(const Frame& frame, double top, double height) {
  const bool log_x = !frame.linear;
  const double room = frame.across == Across::setting ? 1 : 1.15;
  return {{log_x ? frame.abscissas.low / room : frame.abscissas.low, frame.abscissas.high * room, plot_left,
           plot_right, log_x},
          {frame.errors.low / 1.5, frame.top() * 1.2, top + height, top, true}};
}

std::vector<Pixel> places(const Frame& frame, const Plot& plot, const MethodResult& m, bool within) {
  std::vector<Pixel> points;
  for (const TimedTrial& t : m.trials)
    if (frame.within(t) == within && std::isfinite(frame.x(t)))
      points.push_back(plot(frame.x(t), frame.y(t)));
  if (frame.is_line(m) && within && !points.empty()) points.push_back({plot.x.to, points.back().y});
  return points;
}

/// Draws a horizontal line with its name above the left end.
void add_level(Svg& svg, const Plot& plot, double level, const std::string& name, std::string_view line,
               std::string_view text) {
  if (level <= plot.y.low || level >= plot.y.high) return;
  svg.line({plot.x.from, plot.y(level)}, {plot.x.to, plot.y(level)}, line);
  svg.text({plot.x.from + 5, plot.y(level) - 4}, name, text);
}

/// Draws the front as steps up to the right edge; returns the y of its end.
std::optional<double> add_front(Svg& svg, const QuantityResult& q, const Frame& frame, const Plot& plot) {
  if (frame.across == Across::setting) return std::nullopt;
  const std::vector<bool> front = pareto_front(q, cost_of(frame.across));
  std::vector<std::pair<double, double>> points;
  std::size_t next = 0;
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials)
      if (front[next++] && frame.within(t)) points.emplace_back(frame.x(t), frame.y(t));
  if (points.empty()) return std::nullopt;
  std::ranges::sort(points);
  std::vector<Pixel> steps;
  for (const auto& [x, y] : points) {
    if (!steps.empty()) steps.push_back({plot.x(x), steps.back().y});
    steps.push_back(plot(x, y));
  }
  steps.push_back({plot.x.to, steps.back().y});
  svg.curve(steps, "front");
  return steps.back().y;
}

/// Draws the time of a scene's type-erased calls alone, with the fewest calls that reach each error. Returns
/// the line's end.
std::optional<Pixel> add_seam(Svg& svg, const QuantityResult& q, const Frame& frame, const Plot& plot,
                              double seam) {
  if (frame.across != Across::time || !q.trajectory || !(seam > 0)) return std::nullopt;
  std::vector<std::pair<double, double>> calls;
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials)
      if ((t.resolution == "step" || t.resolution == "tolerance") && frame.within(t))
        calls.emplace_back(seam * static_cast<double>(t.evaluations), frame.y(t));
  std::ranges::sort(calls);
  std::vector<Pixel> line;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [seconds, error] : calls)
    if (error < least) {
      least = error;
      if (seconds > plot.x.low) line.push_back(plot(seconds, error));
    }
  if (line.size() < 2) return std::nullopt;
  svg.curve(line, "floor");
  return line.back();
}

void add_spread(Svg& svg, const Frame& frame, const Plot& plot, const Curve& curve) {
  if (frame.across != Across::time) return;
  std::string data;
  for (const TimedTrial& t : curve.method->trials) {
    if (!std::isfinite(t.time.spread) || !frame.within(t)) continue;
    const double x = frame.x(t), from = std::max(x - t.time.spread, plot.x.low);
    data += "M" + px(plot.x(from)) + " " + px(plot.y(frame.y(t))) + "H" + px(plot.x(x + t.time.spread));
  }
  if (!data.empty()) svg.path(data, "curve thin " + colour_class(curve.slot));
}

void add_curve(Svg& svg, const Frame& frame, const Plot& plot, const Curve& curve) {
  const MethodResult& m = *curve.method;
  svg.curve(places(frame, plot, m, true), "curve " + colour_class(curve.slot));
  add_spread(svg, frame, plot, curve);
  std::vector<Pixel> full, open;
  for (const TimedTrial& t : m.trials)
    if (std::isfinite(frame.x(t)))
      (t.outcome == Outcome::ok ? full : open).push_back(plot(frame.x(t), frame.y(t)));
  svg.marks(full, curve.slot, "mark");
  svg.marks(open, curve.slot, "hollow");
  for (const TimedTrial& t : m.trials)
    if (t.outcome != Outcome::ok && t.outcome != Outcome::inaccurate && std::isfinite(frame.x(t)))
      svg.text({plot.x(frame.x(t)) + 6, plot.y(frame.y(t)) - 5}, std::string(1, letter_of(t.outcome)),
               "t small");
}

/// Legend of the marks: the letters of the failures shown, and the number of methods not drawn.
std::string key_of(const std::vector<Curve>& curves, std::size_t left_out) {
  std::string text;
  bool open = false;
  for (Outcome outcome : outcomes_of_a_map) {
    const bool there = std::ranges::any_of(curves, [outcome](const Curve& c) {
      return std::ranges::any_of(c.method->trials,
                                 [outcome](const TimedTrial& t) { return t.outcome == outcome; });
    });
    if (!there || outcome == Outcome::ok) continue;
    open = true;
    if (outcome != Outcome::inaccurate)
      text += std::string(", ") + letter_of(outcome) + " " + std::string(name_of(outcome));
  }
  text = open ? "open mark: the trial fails" + text : "";
  if (left_out > 0)
    text += (text.empty() ? "" : "; ") + std::to_string(left_out) +
            (left_out == 1 ? " method is" : " methods are") + " not drawn";
  return text;
}

/// Names the evaluations that are counted, judging by the methods' settings.
std::string counted(const QuantityResult& q) {
  if (q.in_operations) return "multiplications, divisions and functions";
  bool steps = false, nodes = false, differences = false;
  for (const MethodResult& m : q.methods) {
    const std::string& resolution = m.trials.front().resolution;
    const bool differs = m.algorithm.find("difference") != std::string::npos;
    differences |= differs;
    steps |= resolution == "step" && !differs;
    nodes |= resolution == "panels" || resolution == "points";
  }
  if (differences) return "evaluations of the function";
  if (steps && nodes) return "evaluations of the right-hand side or integrand";
  if (steps) return "evaluations of the right-hand side";
  return nodes ? "evaluations of the integrand" : "evaluations";
}

std::string in_unit(const std::string& number, const QuantityResult& q) {
  return with_powers(number) + (q.unit.empty() || q.unit == "1" || q.unit.find(',') != std::string::npos
                                    ? ""
                                    : " " + typeset_unit(q.unit));
}

std::string abscissa_name(const QuantityResult& q, const Frame& frame) {
  if (frame.across == Across::time) return "time [s], with half the interquartile range";
  if (frame.across == Across::evaluations) return counted(q);
  const bool of_time = frame.resolution == "step" && q.trajectory;
  return frame.resolution + (of_time ? " [" + q.trajectory->time_unit + "]" : "");
}

std::string error_name(const QuantityResult& q) {
  return q.unit == "1" || q.unit.empty() ? "error (dimensionless)" : "error [" + typeset_unit(q.unit) + "]";
}

}  // namespace

std::string finding(const QuantityResult& q, Across across) {
  const TimedTrial* best = nullptr;
  const Frame frame(q, across);
  for (const MethodResult& m : q.methods) {
    if (!frame.shows(m) || (across == Across::setting && frame.is_line(m))) continue;
    for (const TimedTrial& t : m.trials)
      if (!best || (across == Across::setting ? usable(t) && !(t.error >= best->error)
                                              : preferable(t, *best, cost_of(across))))
        best = &t;
  }
  if (!best) return q.name;
  const std::string needed = in_unit(shown_error(q.need.allowed), q);
  if (across == Across::setting)
    return named(*best) + " is the most accurate of the methods with a " +
           (frame.resolution == "step" ? "step" : "setting") + ": " + in_unit(shown_error(best->error), q) +
           " at " + with_powers(shown_resolution(*best));
  if (best->outcome != Outcome::ok)
    return "No method reaches " + needed + "; the closest is " + named(*best) + ": " +
           in_unit(shown_error(best->error), q);
  const std::string work = across == Across::time ? shown_time(best->time.seconds)
                                                  : with_commas(best->evaluations) +
                                                        (q.in_operations ? " operation" : " evaluation") +
                                                        (best->evaluations == 1 ? "" : "s");
  return named(*best) + " reaches " + needed + " with the least work: " + work;
}

std::string chart_svg(const QuantityResult& q, const std::string& title, Across across, Curves which,
                      double seam) {
  const Frame frame(q, across);
  std::vector<std::size_t> chosen = worth_seeing(q, across);
  const auto shown = static_cast<std::size_t>(
      std::ranges::count_if(q.methods, [&](const MethodResult& m) { return frame.shows(m); }));
  if (which == Curves::all) {
    chosen.clear();
    for (std::size_t i = 0; i < q.methods.size(); ++i) chosen.push_back(i);
  }
  const std::vector<Curve> curves = curves_of(q, frame, chosen);
  constexpr double head = 70;  // at most
  const double height = std::max(least_plot_height, label_height * static_cast<double>(curves.size() + 1));
  Svg svg(chart_width, head + height + below_plot, title + ". " + finding(q, across));
  const double top = svg.headline(finding(q, across), title);
  const double bottom = head + height;
  const Plot plot = plot_of(frame, top, bottom - top);
  const double need = std::min(q.need.allowed, plot.y.high);
  if (need > plot.y.low)
    svg.rectangle({plot.x.from, plot.y(need)}, plot.width(), bottom - plot.y(need), "good");
  add_axes(svg, plot, abscissa_name(q, frame), error_name(q));
  if (frame.strip) {
    const double y = plot.y(frame.above(0.1));
    svg.line({plot.x.from, y}, {plot.x.to, y}, "axis");
    svg.text({plot.x.from + 5, y - 5}, "no number, or off the scale", "dim small");
  }
  std::vector<Label> labels;
  if (const auto end = add_front(svg, q, frame, plot))
    labels.push_back({{plot.x.to, *end}, "Pareto front: none is cheaper and truer", -1});
  add_level(svg, plot, q.need.allowed, "needed: " + in_unit(shown_error(q.need.allowed), q), "need",
            "needed b halo");
  if (const auto end = add_seam(svg, q, frame, plot, seam))
    labels.push_back({*end, "type-erased calls alone, " + shown_time(seam) + " a call", -1});
  if (q.trajectory)
    add_level(svg, plot, q.trajectory->close,
              "enough for a game: " + in_unit(shown_error(q.trajectory->close), q), "game", "dim halo");
  if (frame.floored)
    add_level(svg, plot, frame.floor, "truth known to " + in_unit(shown_error(frame.floor), q), "floor",
              "dim halo");
  for (const Curve& curve : curves) {
    add_curve(svg, frame, plot, curve);
    std::vector<Pixel> ends = places(frame, plot, *curve.method, true);
    if (ends.empty()) ends = places(frame, plot, *curve.method, false);
    if (!ends.empty())
      labels.push_back({*std::ranges::max_element(ends, {}, &Pixel::x), curve.label, curve.slot});
  }
  add_labels(svg, labels, top, bottom);
  svg.text({chart_width - 12, bottom + 46}, key_of(curves, shown - std::min(shown, curves.size())),
           "dim small", Svg::Anchor::end);
  return svg.str();
}

}  // namespace oddity
