#include <algorithm>
#include <cmath>

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

/// A line for each path: the truest broad and grey beneath, the others in their models' colours, the
/// reference as rings.
std::string lines(const Trajectory& t, const std::string& columns, bool titled) {
  const auto title = [&](const std::string& text) { return titled ? "title " + quoted(text) : "notitle"; };
  const auto name = [](const Path& p) { return bold(p.model) + ", " + plain(p.algorithm); };
  const Path& true_path = t.paths[t.truest];
  std::string text = "plot $p" + std::to_string(t.truest) + " using " + columns +
                     " with lines lc rgb '#bbbbbb' lw 6 " +
                     title(name(true_path) + ": true to " + shown_error(true_path.error));
  for (std::size_t i = 0; i < t.paths.size(); ++i) {
    if (i == t.truest) continue;
    const Path& p = t.paths[i];
    text +=
        ", \\\n  $p" + std::to_string(i) + " using " + columns + " with lines " + model_line(i) + " lw 1.4 " +
        title(name(p) + ": " +
              (std::isfinite(p.error) ? "off by " + shown_error(p.error) : std::string(name_of(p.outcome))));
  }
  return text + ", \\\n  $reference using " + columns + " with points lc rgb '#000000' pt 6 ps 1.1 lw 1.3 " +
         title("reference") + "\n";
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
          "set key Left reverse enhanced spacing 1.1 samplen 2 font ',11'\n";
  if (plane)
    return text + "set title " + quoted(title) +
           " noenhanced font ',14'\nset key outside right top vertical maxcols 1\n" +
           "set size ratio -1\nset xrange " + spans[0].range() + "\nset yrange " + spans[1].range() +
           "\nset xlabel " + quoted(labels[0]) + " noenhanced\nset ylabel " + quoted(labels[1]) +
           " noenhanced\n" + lines(t, "2:3", true) + "unset output\n";

  const double total = std::max(height, legend);
  text += "set multiplot\nset lmargin at screen 0.09\nset rmargin at screen 0.6\nset label 1 " +
          quoted(title) + " at screen 0.345, screen " + shortest(1 - 24 / total) +
          " center noenhanced font ',14'\n" + "set key at screen 0.62, screen " + shortest(1 - 45 / total) +
          " left top vertical maxcols 1\nset xrange [0:" + shortest(t.times.back()) + "]\n";
  for (std::size_t k = 0; k < count; ++k) {
    const double top = total - 50 - panel * static_cast<double>(k);
    text += "set tmargin at screen " + shortest(top / total) + "\nset bmargin at screen " +
            shortest((top - panel + 18) / total) + "\nset yrange " + spans[k].range() + "\nset ylabel " +
            quoted(labels[k]) + " noenhanced\n" +
            (k + 1 == count ? "set format x '%g'\nset xlabel 'time [" + t.time_unit + "]'\n"
                            : "set format x ''\n") +
            lines(t, "1:" + std::to_string(k + 2), k == 0) + "unset label 1\nunset key\n";
  }
  return text + "unset multiplot\nunset output\n";
}

}  // namespace oddity
