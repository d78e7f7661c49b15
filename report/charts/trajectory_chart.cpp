#include <algorithm>
#include <cmath>
#include <numeric>

#include "reference/text.hpp"
#include "report/charts/chart.hpp"
#include "report/charts/gnuplot.hpp"
#include "report/pages/text_view.hpp"

namespace oddity {

namespace {

/// Names of the observables, each with its unit; a quantity's unit is one for all or a list.
std::vector<std::string> axis_labels(const QuantityResult& q, std::size_t count) {
  std::vector<std::string> units;
  for (std::size_t from = 0; from <= q.unit.size();) {
    const std::size_t to = std::min(q.unit.find(", ", from), q.unit.size());
    units.push_back(q.unit.substr(from, to - from));
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

/// The span of the true motion in one observable, and a quarter of it on either side.
struct Span {
  double low = INFINITY, high = -INFINITY;

  void see(double x) { low = std::min(low, x), high = std::max(high, x); }
  std::string range() const {
    const double margin = high > low ? (high - low) / 4 : std::max(std::abs(high), 1e-9) / 4;
    return "[" + shortest(low - margin) + ":" + shortest(high + margin) + "]";
  }
};

/// Rows of time and observables, as far as the motion goes.
std::string rows(const std::vector<double>& times, const Value& value, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < times.size() && (i + 1) * count <= value.size(); ++i) {
    text += shortest(times[i]);
    for (std::size_t k = 0; k < count; ++k)
      text += std::isfinite(value[i * count + k]) ? " " + rounded(value[i * count + k], 7) : " NaN";
    text += "\n";
  }
  return text;
}

/// The paths from the truest to the most wrong, which is drawn on top of all.
std::vector<std::size_t> by_error(const Trajectory& t) {
  std::vector<std::size_t> order(t.paths.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::size_t i) {
    return i == t.truest ? -1 : std::isfinite(t.paths[i].error) ? t.paths[i].error : INFINITY;
  };
  std::ranges::stable_sort(order, {}, key);
  return order;
}

/// How far apart two motions are on the whole, in parts of the span of each observable.
double apart(const Value& a, const Value& b, const std::vector<Span>& spans) {
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const Span& span = spans[i % spans.size()];
    if (span.high > span.low) largest = std::max(largest, std::abs(a[i] - b[i]) / (span.high - span.low));
  }
  return a.size() == b.size() ? largest : INFINITY;
}

/// A path that hides another, because the eye cannot tell them apart: the first drawn after it.
const Path* cover_of(const Trajectory& t, const std::vector<std::size_t>& order, std::size_t place,
                     const std::vector<Span>& spans) {
  constexpr double width_of_a_line = 0.003;
  for (std::size_t later = place + 1; later < order.size(); ++later)
    if (apart(t.paths[order[place]].value, t.paths[order[later]].value, spans) < width_of_a_line)
      return &t.paths[order[later]];
  return nullptr;
}

/// A path's largest error: over all times drawn, as far as its seven digits tell, and at the reference's. NaN
/// where the motion broke off.
double largest_error(const Trajectory& t, const Path& p) {
  const Value& truth = t.paths[t.truest].value;
  const double drawn = distance(p.value, truth);
  return drawn > 1e-6 * size_of(truth) || std::isnan(drawn) ? std::max(drawn, p.error) : p.error;
}

/// "off by 0.2", "diverged".
std::string how_wrong(const Trajectory& t, const Path& p, const std::string& unit = "") {
  const double error = largest_error(t, p);
  return std::isfinite(error) ? "off by up to " + shown_error(error) + unit : std::string(name_of(p.outcome));
}

/// The legend's line of a path: how true it is, and what it is hidden by.
std::string title_of(const Trajectory& t, const std::vector<std::size_t>& order, std::size_t place,
                     const std::vector<Span>& spans) {
  const Path& p = t.paths[order[place]];
  const bool truest = order[place] == t.truest;
  std::string how = truest ? ": true to " + shown_error(p.error) : ": " + how_wrong(t, p);
  const Path* cover = truest ? nullptr : cover_of(t, order, place, spans);
  if (cover) how += ", hidden by '" + cover->model + "'";
  return bold(p.model) + ", " + plain(shortened(p.algorithm + how, 96));
}

/// A line for each path: the truest broad and grey beneath, the others in their models' colours, the
/// reference as rings. With `dots`, each path has one at the reference's times.
std::string lines(const Trajectory& t, const std::string& columns, const std::vector<Span>& spans,
                  const Styles& styles, bool titled, bool dots = false) {
  const std::size_t every = t.times.size() / t.judged_at.size();
  const auto order = by_error(t);
  std::string text = "plot ";
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t i = order[place];
    const bool truest = i == t.truest;
    const std::string colour = styles.colour(t.paths[i].model);
    const std::string data = "$p" + std::to_string(i) + " using " + columns;
    text += data + " with lines " + (truest ? "lc rgb '#bbbbbb' lw 6" : colour + " lw 1.5") +
            (titled ? " title " + quoted(title_of(t, order, place, spans)) : " notitle") + ", \\\n  ";
    if (dots && !truest)
      text += data + " every " + std::to_string(every) + "::" + std::to_string(every - 1) + " with points " +
              colour + " pt 7 ps 0.7 notitle, \\\n  ";
  }
  return text + "$reference using " + columns + " with points lc rgb '#000000' pt 6 ps 1.1 lw 1.3 " +
         (titled ? "title 'reference'\n" : "notitle\n");
}

/// How far a path is from the truest, over time, where it is at least so far: of all observables the largest
/// distance.
std::string distance_rows(const Trajectory& t, const Path& p, std::size_t count, double least) {
  const Value& truth = t.paths[t.truest].value;
  std::string text;
  for (std::size_t i = 0; i < t.times.size() && (i + 1) * count <= p.value.size(); ++i) {
    double largest = 0;
    for (std::size_t k = i * count; k < (i + 1) * count; ++k) {
      const double difference = std::abs(p.value[k] - truth[k]);
      largest = std::isfinite(difference) ? std::max(largest, difference) : INFINITY;
    }
    if (largest >= least && std::isfinite(largest))
      text += shortest(t.times[i]) + " " + rounded(largest, 4) + "\n";
  }
  return text;
}

std::string unit_of(const QuantityResult& q) {
  return q.unit.empty() || q.unit == "1" || q.unit.find(',') != std::string::npos ? "" : " " + q.unit;
}

constexpr double line_height = 21, headline_height = 62, time_axis_height = 62;

/// The legend lies below the plots, a line for each path.
std::string key_below(double height, std::size_t entries) {
  return "set key at screen 0.06, screen " +
         shortest((line_height * static_cast<double>(entries) + 8) / height) +
         " left top vertical maxcols 1 Left reverse enhanced spacing 1.15 samplen 2 font ',12'\n";
}

std::string path_script(const QuantityResult& q, const std::vector<Span>& spans, const Styles& styles) {
  constexpr double flattest = 2;
  const auto labels = axis_labels(q, 2);
  const double ratio = (spans[1].high - spans[1].low) / (spans[0].high - spans[0].low);
  const bool to_scale = ratio < flattest && ratio > 1 / flattest;
  return std::string(to_scale ? "set size ratio -1\n" : "") + "set xrange " + spans[0].range() +
         "\nset yrange " + spans[1].range() + "\nset xlabel " +
         quoted(labels[0] + (to_scale ? "" : ", not to the scale of y")) + " noenhanced\nset ylabel " +
         quoted(labels[1]) + " noenhanced\n" + lines(*q.trajectory, "2:3", spans, styles, true, true);
}

/// Paths are kept to seven digits: what differs by less is not drawn.
std::string distance_script(const QuantityResult& q, std::size_t count, const Styles& styles) {
  const Trajectory& t = *q.trajectory;
  const double least = 1e-6 * size_of(t.paths[t.truest].value);
  std::string data,
      text = "set logscale y\nset format y '10^{%L}'\nset xrange [0:" + shortest(t.times.back()) +
             "]\nset yrange [" + shortest(least) + ":*]\nset xlabel " +
             quoted(plain("time [" + t.time_unit + "]")) + "\nset ylabel " +
             quoted("largest error of " + std::to_string(count) + " components" +
                    (unit_of(q).empty() ? "" : " [" + unit_of(q).substr(1) + "]")) +
             "\nplot ";
  for (std::size_t i : by_error(t)) {
    const Path& p = t.paths[i];
    const std::string rows = distance_rows(t, p, count, least);
    const std::string how = ": " + how_wrong(t, p);
    data += block("$e" + std::to_string(i), rows);
    text += "$e" + std::to_string(i) + " using 1:2 with lines " + styles.colour(p.model) + " lw 1.5 title " +
            quoted(bold(p.model) + ", " +
                   plain(shortened(p.algorithm + how + (rows.empty() ? ", below the frame" : ""), 96))) +
            ", \\\n  ";
  }
  return data + text + shortest(t.close) + " with lines lc rgb '#666666' dt 5 lw 1.2 title " +
         quoted(plain("enough for a game: " + shown_error(t.close) + unit_of(q))) + "\n";
}

std::string panels_script(const QuantityResult& q, const std::vector<Span>& spans, double panel,
                          double bottom, double height, const Styles& styles) {
  const Trajectory& t = *q.trajectory;
  const auto labels = axis_labels(q, spans.size());
  // gnuplot breaks a legend that is higher than its plot into columns, so that it has a plot of its own.
  std::string text =
      "set multiplot\nset tmargin at screen " + shortest((bottom - time_axis_height + 8) / height) +
      "\nset bmargin at screen 0\nunset border\nunset tics\nset xrange [0:1]\nset yrange [0:1]\n" +
      lines(t, "(NaN):(NaN)", spans, styles, true) +
      "unset key\nunset label 1\nunset label 2\nset border 3\nset xtics nomirror\nset ytics nomirror\n";
  for (std::size_t k = 0; k < spans.size(); ++k) {
    const double top = height - headline_height - panel * static_cast<double>(k);
    const bool last = k + 1 == spans.size();
    text += "set tmargin at screen " + shortest(top / height) + "\nset bmargin at screen " +
            shortest((last ? bottom : top - panel + 18) / height) +
            "\nset xrange [0:" + shortest(t.times.back()) + "]\nset yrange " + spans[k].range() +
            "\nset ylabel " + quoted(labels[k]) + " noenhanced\n" +
            (last ? "set format x '%g'\nset xlabel " + quoted(plain("time [" + t.time_unit + "]")) + "\n"
                  : "set format x ''\n") +
            lines(t, "1:" + std::to_string(k + 2), spans, styles, false);
  }
  return text + "unset multiplot\n";
}

}  // namespace

std::string motion_finding(const QuantityResult& q) {
  const Trajectory& t = *q.trajectory;
  const auto holds = [&](const Path& p) { return largest_error(t, p) <= t.close; };
  const auto good = std::ranges::count_if(t.paths, holds);
  const std::string need = shown_error(t.close) + unit_of(q) + " of the truth for " +
                           rounded(t.times.back(), 3) + " " + t.time_unit;
  if (t.paths.size() == 1) return t.paths[0].model + " is the only model";
  if (good == static_cast<std::ptrdiff_t>(t.paths.size()))
    return "All " + std::to_string(good) + " models stay within " + need;
  const auto worst = std::ranges::max_element(t.paths, {}, [&](const Path& p) {
    const double error = largest_error(t, p);
    return std::isfinite(error) ? error : INFINITY;
  });
  return std::to_string(good) + " of " + std::to_string(t.paths.size()) + " models stay within " + need +
         "; '" + worst->model + "': " + how_wrong(t, *worst, unit_of(q));
}

std::string trajectory_script(const QuantityResult& q, const std::string& title,
                              const std::filesystem::path& file, const Styles& styles) {
  constexpr std::size_t most_panels = 6;
  const Trajectory& t = *q.trajectory;
  const Value& truth = t.paths[t.truest].value;
  const std::size_t count = truth.size() / t.times.size();
  std::vector<Span> spans(count);
  for (std::size_t i = 0; i < truth.size(); ++i) spans[i % count].see(truth[i]);

  const bool plane = t.observables == std::vector<std::string>{"x", "y"},
             panels = !plane && count <= most_panels;
  const double panel = count == 1 ? 340 : count <= 3 ? 190 : 130;
  const std::size_t entries = t.paths.size() + 1;
  const double bottom = line_height * static_cast<double>(entries) + time_axis_height;
  const double height = headline_height + (panels ? panel * static_cast<double>(count) : 500) + bottom;
  std::string text = "reset session\n" + block("$reference", rows(t.judged_at, q.reference.value, count));
  for (std::size_t i = 0; i < t.paths.size(); ++i)
    text += block("$p" + std::to_string(i), rows(t.times, t.paths[i].value, count));
  text += svg(height, file) + headline(motion_finding(q), title, height) +
          "set border 3 lc rgb '#444444'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.6\n"
          "set lmargin at screen 0.09\nset rmargin at screen 0.98\nset bmargin at screen " +
          shortest(bottom / height) + "\n" + key_below(height, entries);
  text += plane    ? path_script(q, spans, styles)
          : panels ? panels_script(q, spans, panel, bottom, height, styles)
                   : distance_script(q, count, styles);
  return text + "unset output\n";
}

}  // namespace oddity
