#include "report/charts/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "reference/text.hpp"
#include "report/charts/axes.hpp"
#include "report/charts/svg.hpp"
#include "report/pages/markup.hpp"
#include "report/pages/text_view.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace {

constexpr std::size_t most_curves = 8;
constexpr std::size_t longest_label = 50;  // letters

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void see(double x) { low = std::min(low, x), high = std::max(high, x); }
  bool empty() const { return high == 0; }
  /// The whole decades around, at least one.
  Range decades() const {
    const double from = std::floor(std::log10(low) + 1e-9), to = std::ceil(std::log10(high) - 1e-9);
    return {std::pow(10, from), std::pow(10, std::max(to, from + 1))};
  }
  double count() const { return std::round(std::log10(high / low)); }
};

Cost cost_of(Across across) { return across == Across::time ? Cost::time : Cost::evaluations; }

/// The knob of a chart over settings: the one of most methods, a tolerance only if there is no other.
std::string main_knob(const QuantityResult& q) {
  std::map<std::string, int> methods;
  for (const MethodResult& m : q.methods) ++methods[m.trials.front().knob];
  std::string most;
  for (const auto& [knob, count] : methods)
    if (!knob.empty() &&
        (most.empty() || most == "tolerance" || (knob != "tolerance" && count > methods[most])))
      most = knob;
  return most;
}

/// Where a quantity's trials lie: the range of what they are drawn against, and the decades of error up to a
/// thousand times the true value's size or ten times the need.
struct Frame {
  Across across;
  std::string knob;
  double floor;
  Range abscissas, errors;
  bool linear = false;   ///< the abscissa: a count over a short range
  bool strip = false;    ///< some trials have no number or are off the scale
  bool floored = false;  ///< some errors are below the floor

  Frame(const QuantityResult& q, Across a) : across(a), knob(main_knob(q)), floor(error_floor(q)) {
    const double top = std::max(1e3 * size_of(q.reference.value), 10 * q.need.allowed);
    errors.see(q.need.allowed > 0 ? q.need.allowed : floor);
    for (const MethodResult& m : q.methods) {
      if (!shows(m)) continue;
      for (const TimedTrial& t : m.trials) {
        if (abscissa(t) > 0 && std::isfinite(abscissa(t))) abscissas.see(abscissa(t));
        floored |= t.error < floor;
        if (t.error <= top)
          errors.see(std::max(t.error, floor));
        else
          strip = true;
      }
    }
    if (abscissas.empty()) abscissas.see(1);
    linear = across == Across::setting && abscissas.low >= 1 && abscissas.high < 100;
    if (across == Across::setting)
      abscissas = linear ? Range{abscissas.low - 1, abscissas.high + 1}
                         : Range{abscissas.low / 1.5, abscissas.high * 1.5};
    else
      abscissas = abscissas.decades();
    errors = errors.decades();
  }

  double abscissa(const TimedTrial& t) const {
    if (across != Across::setting) return cost(t, cost_of(across));
    return t.knob == knob ? t.setting : std::numeric_limits<double>::quiet_NaN();
  }
  /// A method without a knob is a line across a chart over settings.
  bool is_line(const MethodResult& m) const {
    return across == Across::setting && m.trials.front().knob.empty();
  }
  bool shows(const MethodResult& m) const {
    return across != Across::setting || is_line(m) || m.trials.front().knob == knob;
  }
  /// Within the strip, `part` of its height up.
  double above(double part) const { return errors.high * std::pow(10, 0.075 * part * errors.count()); }
  double top() const { return strip ? above(1) : errors.high; }
  double x(const TimedTrial& t) const {
    const double at = abscissa(t);
    return std::isfinite(at) ? std::max(at, abscissas.low) : abscissas.low;
  }
  bool within(const TimedTrial& t) const { return t.error <= errors.high; }
  double y(const TimedTrial& t) const { return within(t) ? std::max(t.error, floor) : above(0.5); }
};

// ---- what is worth seeing ---------------------------------------------------------------------------------

/// Two points of the front that the eye takes for one.
bool look_alike(const Frame& frame, const TimedTrial& a, const TimedTrial& b) {
  return std::abs(std::log10(frame.x(a) / frame.x(b))) < 0.05 &&
         std::abs(std::log10(frame.y(a) / frame.y(b))) < 0.3;
}

/// The front's trials, the preferable ones first, each with its method; of those that look alike one.
std::vector<std::size_t> methods_on_front(const QuantityResult& q, const Frame& frame, Cost kind) {
  const std::vector<bool> front = pareto_front(q, kind);
  std::vector<std::pair<const TimedTrial*, std::size_t>> seen;
  std::size_t trial = 0;
  for (std::size_t i = 0; i < q.methods.size(); ++i)
    for (const TimedTrial& t : q.methods[i].trials)
      if (front[trial++] &&
          std::ranges::none_of(seen, [&](const auto& other) { return look_alike(frame, t, *other.first); }))
        seen.emplace_back(&t, i);
  std::ranges::stable_sort(
      seen, [kind](const auto& a, const auto& b) { return preferable(*a.first, *b.first, kind); });
  std::vector<std::size_t> methods;
  for (const auto& [t, i] : seen) methods.push_back(i);
  return methods;
}

/// The best method of each key, in the order of first appearance.
template <class Key>
std::vector<std::size_t> best_of_each(const QuantityResult& q, const std::vector<std::size_t>& among,
                                      Cost kind, const Key& key) {
  std::vector<std::size_t> best;
  for (std::size_t i : among) {
    const auto same = std::ranges::find_if(
        best, [&](std::size_t other) { return key(q.methods[other]) == key(q.methods[i]); });
    if (same == best.end())
      best.push_back(i);
    else if (preferable(best_of(q.methods[i], kind), best_of(q.methods[*same], kind), kind))
      *same = i;
  }
  return best;
}

// ---- parts of a chart -------------------------------------------------------------------------------------

/// A curve of a chart, under its own colour and mark.
struct Curve {
  const MethodResult* method;
  int slot;
  std::string label;
};

/// The points as they can be seen, to one part in fifty.
std::string seen(const Frame& frame, const MethodResult& m) {
  std::string text;
  const auto place = [](double x) { return std::to_string(std::lround(100 * std::log10(x))) + " "; };
  for (const TimedTrial& t : m.trials) text += place(frame.x(t)) + place(frame.y(t));
  return text;
}

/// The first of each family has the same colour in every chart; the others have what is left.
std::vector<int> slots_of(const std::vector<const MethodResult*>& methods) {
  constexpr int none = -1;
  std::vector<int> slots(methods.size(), none);
  const auto is_taken = [&](int slot) { return std::ranges::find(slots, slot) != slots.end(); };
  for (std::size_t i = 0; i < methods.size(); ++i)
    if (const int own = static_cast<int>(family_of(methods[i]->algorithm)) - 1; own != none && !is_taken(own))
      slots[i] = own;
  int next = 0;  // beyond the last, colours begin anew
  for (int& slot : slots)
    if (slot == none) {
      while (next < svg_slots && is_taken(next)) ++next;
      slot = next++;
    }
  return slots;
}

/// A curve that lies on another says so.
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

// Pixels.
constexpr double chart_width = 960, plot_left = 70, plot_right = 570, label_left = 596, label_height = 17;
constexpr double least_plot_height = 300, below_plot = 56;

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

/// A line of the chart with its name at its left end, above it.
void add_level(Svg& svg, const Plot& plot, double level, const std::string& name, std::string_view line,
               std::string_view text) {
  if (level <= plot.y.low || level >= plot.y.high) return;
  svg.line({plot.x.from, plot.y(level)}, {plot.x.to, plot.y(level)}, line);
  svg.text({plot.x.from + 5, plot.y(level) - 4}, name, text);
}

/// The front as steps to the right edge; where it ends.
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

/// A name beside the end of its curve, with a thin line to it.
struct Label {
  Pixel end;
  std::string text;
  int slot;  ///< -1: of no curve
};

void add_labels(Svg& svg, const std::vector<Label>& labels, double top, double bottom) {
  std::vector<double> wanted;
  for (const Label& label : labels) wanted.push_back(label.end.y);
  const std::vector<double> heights = spread(wanted, label_height, top + 6, bottom - 4);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    svg.line({label.end.x + 5, label.end.y}, {label_left - 4, heights[i]}, "lead");
    if (label.slot >= 0) svg.marks({{label_left + 3, heights[i]}}, label.slot, "mark");
    svg.text({label_left + 12, heights[i] + 4}, shortened(label.text, longest_label),
             label.slot < 0 ? "t b" : "t");
  }
}

/// The letters of the failures that are shown, and what they say; what else has to be said of the marks.
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

/// What is counted, as far as the knobs tell.
std::string counted(const QuantityResult& q) {
  bool steps = false, nodes = false, differences = false;
  for (const MethodResult& m : q.methods) {
    const std::string& knob = m.trials.front().knob;
    const bool differs = m.algorithm.find("difference") != std::string::npos;
    differences |= differs;
    steps |= knob == "step" && !differs;
    nodes |= knob == "panels" || knob == "points";
  }
  return std::string("evaluations") + (differences      ? " of the function"
                                       : steps && nodes ? " of the right-hand side or integrand"
                                       : steps          ? " of the right-hand side"
                                       : nodes          ? " of the integrand"
                                                        : "");
}

std::string in_unit(const std::string& number, const QuantityResult& q) {
  return with_powers(number) +
         (q.unit.empty() || q.unit == "1" || q.unit.find(',') != std::string::npos ? "" : " " + typeset_unit(q.unit));
}

std::string abscissa_name(const QuantityResult& q, const Frame& frame) {
  if (frame.across == Across::time) return "time [s], with half the interquartile range";
  if (frame.across == Across::evaluations) return counted(q);
  const bool of_time = frame.knob == "step" && q.trajectory;
  return frame.knob + (of_time ? " [" + q.trajectory->time_unit + "]" : "");
}

std::string error_name(const QuantityResult& q) {
  return q.unit == "1" || q.unit.empty() ? "error" : "error [" + typeset_unit(q.unit) + "]";
}

/// "1,234,567".
std::string with_commas(long n) {
  std::string text = std::to_string(n);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

std::string named(const TimedTrial& t) { return t.algorithm + " (" + t.model + ")"; }

/// The size at the end of a name, "chain_of_100", or 0.
long size_in_name(const std::string& name) {
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  return digits == 0 || digits == name.size() || name[digits - 1] != '_' ? 0 : std::stol(name.substr(digits));
}

std::string without_size(const std::string& name) {
  return name.substr(0, name.find_last_not_of("0123456789") + 1);
}

}  // namespace

bool preferable(const TimedTrial& a, const TimedTrial& b, Cost kind) {
  const bool a_ok = a.outcome == Outcome::ok, b_ok = b.outcome == Outcome::ok;
  if (a_ok != b_ok) return a_ok;
  if (!a_ok) return a.error < b.error || (std::isfinite(a.error) && !std::isfinite(b.error));
  return std::pair(cost(a, kind), a.error) < std::pair(cost(b, kind), b.error);
}

const TimedTrial& best_of(const MethodResult& m, Cost kind) {
  return *std::ranges::min_element(
      m.trials, [kind](const TimedTrial& a, const TimedTrial& b) { return preferable(a, b, kind); });
}

std::vector<std::size_t> worth_seeing(const QuantityResult& q, Across across) {
  constexpr std::size_t most_of_front = 4;
  const Cost kind = cost_of(across);
  const Frame frame(q, across);
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < q.methods.size(); ++i)
    if (frame.shows(q.methods[i])) shown.push_back(i);
  if (shown.size() <= most_curves) return shown;
  std::vector<std::size_t> wanted;
  if (across != Across::setting) wanted = methods_on_front(q, frame, kind);
  if (wanted.size() > most_of_front) wanted.resize(most_of_front);
  const auto append = [&](const std::vector<std::size_t>& more) {
    wanted.insert(wanted.end(), more.begin(), more.end());
  };
  append(best_of_each(q, shown, kind, [](const MethodResult& m) { return m.model; }));
  std::vector<std::size_t> good;
  for (std::size_t i : shown)
    if (family_of(q.methods[i].algorithm) != Family::none &&
        best_of(q.methods[i], kind).outcome == Outcome::ok)
      good.push_back(i);
  append(best_of_each(q, good, kind, [](const MethodResult& m) { return family_of(m.algorithm); }));
  std::set<std::size_t> chosen;
  for (std::size_t i : wanted)
    if (chosen.size() < most_curves) chosen.insert(i);
  return {chosen.begin(), chosen.end()};
}

bool has_chart(const QuantityResult& q) {
  std::set<double> errors;
  bool whole = true, curves = false;
  for (const MethodResult& m : q.methods) {
    curves |= m.trials.size() > 2;
    for (const TimedTrial& t : m.trials)
      if (std::isfinite(t.error)) {
        errors.insert(t.error);
        whole &= t.error == std::round(t.error);
      }
  }
  return curves && !whole && errors.size() > 3;
}

std::vector<Across> charts_of(const QuantityResult& q) {
  if (!has_chart(q)) return {};
  const auto with_knob = std::ranges::count_if(q.methods, [](const auto& m) { return m.trials.size() > 1; });
  const auto varying = std::ranges::count_if(q.methods, [](const MethodResult& m) {
    return std::ranges::any_of(
        m.trials, [&](const TimedTrial& t) { return t.evaluations != m.trials.front().evaluations; });
  });
  const bool work_varies = 2 * varying >= with_knob;
  if (!work_varies) return {Across::setting};
  const bool steps = q.trajectory && main_knob(q) == "step";
  return steps ? std::vector{Across::evaluations, Across::setting, Across::time}
               : std::vector{Across::evaluations, Across::time};
}

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
    return std::string("Of the methods with a ") + (frame.knob == "step" ? "step" : "setting") + ", " +
           named(*best) + " is the most accurate: " + in_unit(shown_error(best->error), q) + " at " +
           with_powers(shown_knob(*best));
  if (best->outcome != Outcome::ok)
    return "No method reaches " + needed + "; the closest is " + named(*best) + ": " +
           in_unit(shown_error(best->error), q);
  const std::string work =
      across == Across::time
          ? shown_time(best->time.seconds)
          : with_commas(best->evaluations) + (best->evaluations == 1 ? " evaluation" : " evaluations");
  return named(*best) + " reaches " + needed + " with the least work: " + work;
}

std::string chart_svg(const QuantityResult& q, const std::string& title, Across across, Curves which) {
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

namespace {

/// A method's work at growing sizes.
struct Growth {
  const MethodResult* method;
  std::vector<std::pair<double, double>> points;

  /// "work ~ n^2".
  std::string law() const {
    if (points.size() < 2) return "";
    const auto& [size, work] = points.back();
    const auto& [first_size, first_work] = points.front();
    return " (work ~ n^" + rounded(std::log(work / first_work) / std::log(size / first_size), 3) + ")";
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

std::string series_finding(const std::vector<const QuantityResult*>& series) {
  std::pair<double, std::string> cheapest{INFINITY, ""};
  for (const Growth& g : growths(series)) {
    const auto& [size, work] = g.points.back();
    cheapest = std::min(cheapest,
                        {work / size, named(g.method->trials.back()) + " needs the least work: " +
                                          with_commas(std::lround(work)) + " for n = " + rounded(size, 6)});
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
