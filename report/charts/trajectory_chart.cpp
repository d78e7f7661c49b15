#include <algorithm>
#include <cmath>
#include <numeric>

#include "reference/text.hpp"
#include "report/charts/axes.hpp"
#include "report/charts/chart.hpp"
#include "report/charts/labels.hpp"
#include "report/text/markup.hpp"
#include "report/text/svg.hpp"

namespace oddity {

namespace {

/// Names of the observables with their units; a quantity has one unit for all or a list.
std::vector<std::string> axis_labels(const QuantityResult& q, std::size_t count) {
  std::vector<std::string> units;
  for (std::size_t from = 0; from <= q.unit.size();) {
    const std::size_t to = std::min(q.unit.find(", ", from), q.unit.size());
    units.push_back(typeset_unit(q.unit.substr(from, to - from)));
    from = to + 2;
  }
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& names = q.trajectory->observables;
    const std::string name = i < names.size() ? names[i] : "observable " + std::to_string(i + 1);
    const std::string& unit = units.size() == count ? units[i] : units.front();
    labels.push_back(unit.empty() || unit == "1" ? name : name + " [" + unit + "]");
  }
  return labels;
}

/// Range of the true motion in one observable.
struct Span {
  double low = INFINITY, high = -INFINITY;

  void see(double x) { low = std::min(low, x), high = std::max(high, x); }
  /// Widened by a quarter on either side.
  Span widened() const {
    const double margin = high > low ? (high - low) / 4 : std::max(std::abs(high), 1e-9) / 4;
    return {low - margin, high + margin};
  }
};

/// Indices of the paths: first the most accurate, last the least accurate, which is drawn on top.
std::vector<std::size_t> by_error(const Trajectory& t) {
  std::vector<std::size_t> order(t.paths.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::size_t i) {
    return i == t.truest ? -1 : std::isfinite(t.paths[i].error) ? t.paths[i].error : INFINITY;
  };
  std::ranges::stable_sort(order, {}, key);
  return order;
}

/// Largest difference of two motions, relative to the range of each observable.
double apart(const Value& a, const Value& b, const std::vector<Span>& spans) {
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const Span& span = spans[i % spans.size()];
    if (span.high > span.low) largest = std::max(largest, std::abs(a[i] - b[i]) / (span.high - span.low));
  }
  return a.size() == b.size() ? largest : INFINITY;
}

/// The first later path that hides this one, as the eye cannot distinguish them; nullptr otherwise.
const Path* cover_of(const Trajectory& t, const std::vector<std::size_t>& order, std::size_t place,
                     const std::vector<Span>& spans) {
  constexpr double width_of_a_line = 0.003;
  for (std::size_t later = place + 1; later < order.size(); ++later)
    if (apart(t.paths[order[place]].value, t.paths[order[later]].value, spans) < width_of_a_line)
      return &t.paths[order[later]];
  return nullptr;
}

/// A path's largest error, at the drawn times (as far as seven digits show it) and at the reference's. NaN if
/// the motion broke off.
double largest_error(const Trajectory& t, const Path& p) {
  const Value& truth = t.paths[t.truest].value;
  const double drawn = distance(p.value, truth);
  return drawn > 1e-6 * size_of(truth) || std::isnan(drawn) ? std::max(drawn, p.error) : p.error;
}

/// "off by up to 0.2", "diverged".
std::string how_wrong(const Trajectory& t, const Path& p, const std::string& unit = "") {
  const double error = largest_error(t, p);
  return std::isfinite(error) ? "off by up to " + with_powers(shown_error(error)) + unit
                              : std::string(name_of(p.outcome));
}

/// Legend of a path: its accuracy, and the path that hides it.
std::string legend_of(const Trajectory& t, const std::vector<std::size_t>& order, std::size_t place,
                      const std::vector<Span>& spans) {
  const Path& p = t.paths[order[place]];
  const bool truest = order[place] == t.truest;
  const Path* cover = truest ? nullptr : cover_of(t, order, place, spans);
  return p.algorithm + ": " + (truest ? "true to " + with_powers(shown_error(p.error)) : how_wrong(t, p)) +
         (cover ? ", hidden by '" + cover->model + "'" : "");
}

std::string unit_of(const QuantityResult& q) {
  return q.unit.empty() || q.unit == "1" || q.unit.find(',') != std::string::npos
             ? ""
             : " " + typeset_unit(q.unit);
}

// Pixels.
constexpr double picture_width = 960, motion_left = 70, motion_right = 600, legend_left = 624,
                 entry_height = 40;
constexpr double under_axis = 46;

/// The true motion is drawn broad and without colour; the others take the colours in turn.
int slot_of(std::size_t place) { return static_cast<int>(place) - 1; }

/// A motion's picture being drawn.
struct Frames {
  const QuantityResult& q;
  const Trajectory& t;
  std::vector<std::size_t> order;
  std::vector<Span> spans;
  std::size_t count;  ///< number of observables

  explicit Frames(const QuantityResult& quantity) : q(quantity), t(*quantity.trajectory), order(by_error(t)) {
    const Value& truth = t.paths[t.truest].value;
    count = truth.size() / t.times.size();
    spans.resize(count);
    for (std::size_t i = 0; i < truth.size(); ++i) spans[i % count].see(truth[i]);
  }

  std::size_t times_of(const Path& p) const { return std::min(t.times.size(), p.value.size() / count); }

  /// Points of an observable over another, or over time if `across` is empty; not finite outside the plot.
  std::vector<Pixel> way(const Path& p, const Plot& plot, std::optional<std::size_t> across,
                         std::size_t upward) const {
    std::vector<Pixel> points;
    for (std::size_t i = 0; i < times_of(p); ++i) {
      const double x = across ? p.value[i * count + *across] : t.times[i];
      const Pixel at = plot(x, p.value[i * count + upward]);
      const bool inside = at.x >= plot.x.from - 1 && at.x <= plot.x.to + 1 && at.y <= plot.y.from + 1 &&
                          at.y >= plot.y.to - 1;
      points.push_back(inside ? at : Pixel{NAN, NAN});
    }
    return points;
  }

  void add_ways(Svg& svg, const Plot& plot, std::optional<std::size_t> across, std::size_t upward) const {
    for (std::size_t place = 0; place < order.size(); ++place)
      svg.curve(way(t.paths[order[place]], plot, across, upward),
                place == 0 ? "truth" : "curve " + colour_class(slot_of(place)));
    std::string rings;
    for (std::size_t i = 0; i < t.judged_at.size() && (i + 1) * count <= q.reference.value.size(); ++i) {
      const Pixel at = plot(across ? q.reference.value[i * count + *across] : t.judged_at[i],
                            q.reference.value[i * count + upward]);
      if (std::isfinite(at.x) && std::isfinite(at.y))
        rings += "M" + px(at.x - 4) + " " + px(at.y) + "a4 4 0 108 0a4 4 0 10-8 0z";
    }
    if (!rings.empty()) svg.path(rings, "known");
  }

  void add_legend(Svg& svg, double top) const {
    for (std::size_t place = 0; place < order.size(); ++place, top += entry_height) {
      const bool truth = place == 0;
      svg.line({legend_left, top + 8}, {legend_left + 18, top + 8},
               truth ? "truth" : "curve " + colour_class(slot_of(place)));
      svg.text({legend_left + 25, top + 12}, shortened(t.paths[order[place]].model, 40), "t b");
      svg.text({legend_left + 25, top + 27}, shortened(legend_of(t, order, place, spans), 48), "dim small");
    }
    svg.path("M" + px(legend_left + 5) + " " + px(top + 8) + "a4 4 0 108 0a4 4 0 10-8 0z", "known");
    svg.text({legend_left + 25, top + 12}, "the reference", "t");
  }

  double legend_height() const { return entry_height * static_cast<double>(order.size()) + 20; }
};

std::string path_svg(const Frames& f, const std::string& title) {
  constexpr double flattest = 2, height = 440;
  const auto labels = axis_labels(f.q, 2);
  Span x = f.spans[0].widened(), y = f.spans[1].widened();
  const double ratio = (f.spans[1].high - f.spans[1].low) / (f.spans[0].high - f.spans[0].low);
  const bool to_scale = ratio < flattest && ratio > 1 / flattest;
  const double whole = std::max(height, f.legend_height());
  Svg svg(picture_width, whole + 66 + under_axis, title + ". " + motion_finding(f.q));
  const double top = svg.headline(motion_finding(f.q), title), bottom = whole + 66;
  if (to_scale) {  // widen the narrower one
    const double per_x = (motion_right - motion_left) / (x.high - x.low),
                 per_y = (bottom - top) / (y.high - y.low);
    Span& wide = per_x > per_y ? x : y;
    const double pixels = per_x > per_y ? motion_right - motion_left : bottom - top;
    const double more = (pixels / std::min(per_x, per_y) - (wide.high - wide.low)) / 2;
    wide.low -= more, wide.high += more;
  }
  const Plot plot{{x.low, x.high, motion_left, motion_right}, {y.low, y.high, bottom, top}};
  add_axes(svg, plot, labels[0] + (to_scale ? "" : ", not to the scale of y"), labels[1]);
  f.add_ways(svg, plot, 0, 1);
  f.add_legend(svg, top);
  return svg.str();
}

std::string panels_svg(const Frames& f, const std::string& title) {
  const double panel = f.count == 1 ? 300 : f.count <= 3 ? 170 : 120, gap = 12;
  const auto n = static_cast<double>(f.count);
  const double whole = std::max(panel * n, f.legend_height());
  Svg svg(picture_width, whole + 66 + under_axis, title + ". " + motion_finding(f.q));
  const double top = svg.headline(motion_finding(f.q), title), each = (whole + 66 - top) / n;
  const auto labels = axis_labels(f.q, f.count);
  for (std::size_t k = 0; k < f.count; ++k) {
    const Span y = f.spans[k].widened();
    const double from = top + each * static_cast<double>(k);
    const Plot plot{{0, f.t.times.back(), motion_left, motion_right},
                    {y.low, y.high, from + each - gap, from}};
    add_axes(svg, plot, k + 1 == f.count ? "time [" + f.t.time_unit + "]" : "", labels[k]);
    f.add_ways(svg, plot, std::nullopt, k);
  }
  f.add_legend(svg, top);
  return svg.str();
}

/// Largest distance of a path from the most accurate one at one time, over all observables.
double distance_at(const Frames& f, const Path& p, std::size_t i) {
  const Value& truth = f.t.paths[f.t.truest].value;
  double largest = 0;
  for (std::size_t k = i * f.count; k < (i + 1) * f.count; ++k) {
    const double difference = std::abs(p.value[k] - truth[k]);
    largest = std::isfinite(difference) ? std::max(largest, difference) : INFINITY;
  }
  return largest;
}

/// Paths are stored with seven digits, so smaller distances are not drawn.
std::string distance_svg(const Frames& f, const std::string& title) {
  const double whole = std::max(360.0, f.legend_height());
  const double least = 1e-6 * size_of(f.t.paths[f.t.truest].value);
  double most = f.t.close;
  for (const Path& p : f.t.paths)
    for (std::size_t i = 0; i < f.times_of(p); ++i)
      if (const double d = distance_at(f, p, i); std::isfinite(d)) most = std::max(most, d);
  Svg svg(picture_width, whole + 66 + under_axis, title + ". " + motion_finding(f.q));
  const double top = svg.headline(motion_finding(f.q), title), bottom = whole + 66;
  const Plot plot{{0, f.t.times.back(), motion_left, motion_right},
                  {least, std::max(2 * most, 10 * least), bottom, top, true}};
  add_axes(svg, plot, "time [" + f.t.time_unit + "]",
           "largest error of " + std::to_string(f.count) + " components" +
               (unit_of(f.q).empty() ? "" : " [" + unit_of(f.q).substr(1) + "]"));
  for (std::size_t place = 1; place < f.order.size(); ++place) {
    const Path& p = f.t.paths[f.order[place]];
    std::vector<Pixel> points;
    for (std::size_t i = 0; i < f.times_of(p); ++i) {
      const double d = distance_at(f, p, i);
      points.push_back(d >= least && std::isfinite(d) ? plot(f.t.times[i], d) : Pixel{NAN, NAN});
    }
    svg.curve(points, "curve " + colour_class(slot_of(place)));
  }
  if (f.t.close > least) {
    svg.line({plot.x.from, plot.y(f.t.close)}, {plot.x.to, plot.y(f.t.close)}, "game");
    svg.text({plot.x.from + 5, plot.y(f.t.close) - 4},
             "enough for a game: " + with_powers(shown_error(f.t.close)) + unit_of(f.q), "dim halo");
  }
  f.add_legend(svg, top);
  return svg.str();
}

}  // namespace

std::string motion_finding(const QuantityResult& q) {
  const Trajectory& t = *q.trajectory;
  const auto holds = [&](const Path& p) { return largest_error(t, p) <= t.close; };
  const auto good = std::ranges::count_if(t.paths, holds);
  const std::string need = with_powers(shown_error(t.close)) + unit_of(q) + " for " +
                           format_significant(t.times.back(), 3) + " " + t.time_unit;
  if (t.paths.size() == 1) return t.paths[0].model + " is the only model";
  if (good == static_cast<std::ptrdiff_t>(t.paths.size()))
    return "All " + std::to_string(good) + " models follow the truth within " + need;
  const auto worst = std::ranges::max_element(t.paths, {}, [&](const Path& p) {
    const double error = largest_error(t, p);
    return std::isfinite(error) ? error : INFINITY;
  });
  return std::to_string(good) + " of " + std::to_string(t.paths.size()) + " models follow the truth within " +
         need + "; '" + worst->model + "': " + how_wrong(t, *worst, unit_of(q));
}

std::string trajectory_svg(const QuantityResult& q, const std::string& title) {
  constexpr std::size_t most_panels = 6;
  const Frames frames(q);
  if (frames.t.observables == std::vector<std::string>{"x", "y"}) return path_svg(frames, title);
  return frames.count <= most_panels ? panels_svg(frames, title) : distance_svg(frames, title);
}

}  // namespace oddity
