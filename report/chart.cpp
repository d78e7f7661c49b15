#include "report/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "reference/text.hpp"
#include "report/settings.hpp"
#include "report/text_view.hpp"

namespace oddity {

namespace {

/// Okabe and Ito's colours, which colour-blind readers can tell apart; black last.
constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
/// Marks of gnuplot's svg terminal that stay apart when small.
constexpr std::array marks{7, 5, 9, 11, 13, 6, 4, 10, 15, 14};

/// How trials fail that have no place of their own among the errors.
struct FailureMark {
  Outcome outcome;
  int mark;
};
constexpr std::array<FailureMark, 5> failure_marks{{{Outcome::diverged, 2},
                                                    {Outcome::non_finite, 1},
                                                    {Outcome::stalled, 3},
                                                    {Outcome::deceived, 12},
                                                    {Outcome::raised, 8}}};

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

/// Each name's place in the order of first appearance.
class Order {
 public:
  std::size_t operator()(const std::string& name) {
    const auto found = std::ranges::find(names_, name);
    if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
    names_.push_back(name);
    return names_.size() - 1;
  }

 private:
  std::vector<std::string> names_;
};

/// No error is shown below this: the reference's own error, or rounding.
double floor_of(const QuantityResult& q) {
  const double rounding = std::max(size_of(q.reference.value), 1e-3 * q.need.allowed) * 0x1p-53;
  return std::max({q.reference_error, rounding, std::numeric_limits<double>::min()});
}

bool has_error(const TimedTrial& t) {
  return std::isfinite(t.error) && t.outcome != Outcome::raised && t.outcome != Outcome::non_finite;
}

struct Decades {
  double low, high;
};

/// The decades that hold every error and the need; errors beyond a thousand times the true value's size are
/// cut off.
Decades error_decades(const QuantityResult& q) {
  const double floor = floor_of(q), ceiling = std::max(1e3 * size_of(q.reference.value), 10 * q.need.allowed);
  double low = q.need.allowed > 0 ? q.need.allowed : floor, high = low;
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials)
      if (has_error(t)) {
        low = std::min(low, std::max(t.error, floor));
        high = std::max(high, t.error);
      }
  if (ceiling > low) high = std::min(high, ceiling);
  return {std::pow(10, std::floor(std::log10(low))), std::pow(10, std::ceil(std::log10(high)) + 1)};
}

}  // namespace

std::string chart_script(const QuantityResult& q, const std::string& title,
                         const std::filesystem::path& file) {
  Order model, algorithm;
  const auto [low, high] = error_decades(q);
  std::string data, plot;
  std::array<std::string, failure_marks.size()> failures;
  for (const MethodResult& m : q.methods) {
    const std::size_t colour = model(m.model) % colours.size(), mark = algorithm(m.algorithm) % marks.size();
    const std::string name = "$d" + std::to_string(&m - q.methods.data());
    std::string points;
    for (const TimedTrial& t : m.trials) {
      const std::string x = std::to_string(std::max(t.evaluations, 1L));
      const std::string y = shortest(has_error(t) ? std::clamp(t.error, floor_of(q), high) : high);
      if (has_error(t)) points += x + " " + y + "\n";
      for (std::size_t i = 0; i < failure_marks.size(); ++i)
        if (failure_marks[i].outcome == t.outcome) failures[i] += x + " " + y + "\n";
    }
    if (points.empty()) points = "1 NaN\n";
    data += name + " << EOD\n" + points + "EOD\n";
    plot += ", \\\n  " + name + " using 1:2 with linespoints lc rgb '" + colours[colour] + "' pt " +
            std::to_string(marks[mark]) + " ps 0.7 lw 1.2 title " + quoted(m.model + ", " + m.algorithm);
  }
  for (std::size_t i = 0; i < failures.size(); ++i) {
    if (failures[i].empty()) continue;
    const std::string name = "$f" + std::to_string(i);
    data += name + " << EOD\n" + failures[i] + "EOD\n";
    plot += ", \\\n  " + name + " using 1:2 with points lc rgb '#b00020' pt " +
            std::to_string(failure_marks[i].mark) + " ps 1.1 lw 1.6 title " +
            quoted(std::string(name_of(failure_marks[i].outcome)));
  }
  const int height = std::max(420, 170 + 20 * static_cast<int>(q.methods.size() + failure_marks.size()));
  return "reset session\n" + data + "set terminal svg size 980," + std::to_string(height) +
         " dynamic font 'Helvetica,12' background '#ffffff'\n"
         "set output " +
         quoted(file.string()) +
         "\n"
         "set title " +
         quoted(title) +
         " noenhanced font ',14'\n"
         "set logscale xy\nset format x '10^{%L}'\nset xtics 10\nset format y '10^{%L}'\n"
         "set xlabel 'evaluations'\nset ylabel " +
         quoted(q.unit == "1" ? "error" : "error [" + q.unit + "]") +
         " noenhanced\n"
         "set key outside right top vertical maxcols 1 Left reverse noenhanced spacing 1.15 samplen 1.5 font "
         "',11'\n"
         "set grid xtics ytics lc rgb '#dddddd' lw 0.6\nset border 3 lc rgb '#444444'\nset tics nomirror\n"
         "set yrange [" +
         shortest(low) + ":" + shortest(high * 2) +
         "]\nset offsets graph 0.02, graph 0.05\n"
         "plot " +
         shortest(q.need.allowed) + " with lines lc rgb '#888888' dt 2 lw 1.2 title " +
         quoted("needed: " + shown_error(q.need.allowed)) + plot + "\nunset output\n";
}

void draw(const std::vector<std::string>& scripts) {
  if (scripts.empty()) return;
  std::FILE* pipe = popen((gnuplot() + " 2>/dev/null").c_str(), "w");
  if (!pipe) throw std::runtime_error("cannot run " + gnuplot());
  for (const std::string& script : scripts) std::fwrite(script.data(), 1, script.size(), pipe);
  if (pclose(pipe) != 0) throw std::runtime_error(gnuplot() + " could not draw the charts");
}

}  // namespace oddity
