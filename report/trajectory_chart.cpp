#include <algorithm>
#include <cmath>
#include <numeric>

#include "reference/text.hpp"
#include "report/chart.hpp"
#include "report/gnuplot.hpp"
#include "report/text_view.hpp"

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

/// A line for each path: the truest broad and grey beneath, the others in their models' colours, the
/// reference as rings. With `dots`, each path has one at the reference's times.
std::string lines(const Trajectory& t, const std::string& columns, bool titled, bool dots = false) {
  const std::size_t every = t.times.size() / t.judged_at.size();
  std::string text = "plot ";
  for (std::size_t i : by_error(t)) {
    const Path& p = t.paths[i];
    const bool truest = i == t.truest;
    const std::string how = truest                   ? ": true to " + shown_error(p.error)
                            : std::isfinite(p.error) ? ": off by " + shown_error(p.error)
                                                     : ": " + std::string(name_of(p.outcome));
    const std::string data = "$p" + std::to_string(i) + " using " + columns;
    text += data + " with lines " + (truest ? "lc rgb '#bbbbbb' lw 6" : model_line(i) + " lw 1.4") +
            (titled ? " title " + quoted(bold(p.model) + ", " + plain(p.algorithm + how)) : " notitle") +
            ", \\\n  ";
    if (dots && !truest)
      text += data + " every " + std::to_string(every) + "::" + std::to_string(every - 1) + " with points " +
              model_line(i) + " pt 7 ps 0.7 notitle, \\\n  ";
  }
  return text + "$reference using " + columns + " with points lc rgb '#000000' pt 6 ps 1.1 lw 1.3 " +
         (titled ? "title 'reference'\n" : "notitle\n");
}

}  // namespace

std::string trajectory_script(const QuantityResult& q, const std::string& title,
                              const std::filesystem::path& file) {
  const Trajectory& t = *q.trajectory;
  const Value& truth = t.paths[t.truest].value;
  const std::size_t count = truth.size() / t.times.size();
  const auto labels = axis_labels(q, count);
  std::vector<Span> spans(count);
  for (std::size_t i = 0; i < truth.size(); ++i) spans[i % count].see(truth[i]);

  std::string text = "reset session\n" + block("$reference", rows(t.judged_at, q.reference.value, count));
  for (std::size_t i = 0; i < t.paths.size(); ++i)
    text += block("$p" + std::to_string(i), rows(t.times, t.paths[i].value, count));
  const bool plane = t.observables == std::vector<std::string>{"x", "y"};
  const double panel = count == 1 ? 340 : count <= 3 ? 190 : 130;
  const double height = plane ? 560 : 100 + panel * static_cast<double>(count);
  const double legend = 70 + 18 * static_cast<double>(t.paths.size() + 1);
  text += svg(std::max(height, legend), file) +
          "set border 3 lc rgb '#444444'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.6\n"
          "set key Left reverse enhanced spacing 1.1 samplen 2 font ',10'\n";
  if (plane)
    return text + "set title " + quoted(title) +
           " noenhanced font ',14'\nset key outside right top vertical maxcols 1\n" +
           "set size ratio -1\nset xrange " + spans[0].range() + "\nset yrange " + spans[1].range() +
           "\nset xlabel " + quoted(labels[0]) + " noenhanced\nset ylabel " + quoted(labels[1]) +
           " noenhanced\n" + lines(t, "2:3", true, true) + "unset output\n";

  const double total = std::max(height, legend);
  text += "set multiplot\nset label 1 " + quoted(title) + " at screen 0.315, screen " +
          shortest(1 - 24 / total) +
          " center noenhanced font ',14'\nset lmargin at screen 0.56\nset rmargin at screen 1\n"
          "set tmargin at screen " +
          shortest(1 - 45 / total) +
          "\nset bmargin at screen 0\nset key left top\nunset border\nunset tics\nset xrange [0:1]\n"
          "set yrange [0:1]\n" +
          lines(t, "(NaN):(NaN)", true) +
          "unset label 1\nunset key\nset border 3\nset xtics nomirror\nset ytics nomirror\n"
          "set lmargin at screen 0.09\nset rmargin at screen 0.54\nset xrange [0:" +
          shortest(t.times.back()) + "]\n";
  for (std::size_t k = 0; k < count; ++k) {
    const double top = total - 50 - panel * static_cast<double>(k);
    text += "set tmargin at screen " + shortest(top / total) + "\nset bmargin at screen " +
            shortest((top - panel + 18) / total) + "\nset yrange " + spans[k].range() + "\nset ylabel " +
            quoted(labels[k]) + " noenhanced\n" +
            (k + 1 == count
                 ? "set format x '%g'\nset xlabel " + quoted("time [" + t.time_unit + "]") + " noenhanced\n"
                 : "set format x ''\n") +
            lines(t, "1:" + std::to_string(k + 2), false);
  }
  return text + "unset multiplot\nunset output\n";
}

}  // namespace oddity
