#include "report/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "reference/text.hpp"
#include "report/gnuplot.hpp"
#include "report/text_view.hpp"

namespace oddity {

namespace {

/// Marks of gnuplot's svg terminal that stay apart when small.
constexpr std::array marks{7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14};
constexpr auto sign_colour = "#8B0000";

/// How trials fail, and the sign over their marks. `inaccurate` has none: it is above the line of the need.
struct FailureSign {
  Outcome outcome;
  int mark;
  double size;
};
constexpr std::array<FailureSign, 6> failure_signs{{{Outcome::drifted, 6, 1.25},
                                                    {Outcome::diverged, 2, 1.2},
                                                    {Outcome::non_finite, 1, 1.2},
                                                    {Outcome::stalled, 3, 1.2},
                                                    {Outcome::deceived, 12, 1.6},
                                                    {Outcome::raised, 8, 1.5}}};

/// Each name's place in the order of first appearance.
class Order {
 public:
  std::size_t operator()(const std::string& name) {
    const auto found = std::ranges::find(names_, name);
    if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
    names_.push_back(name);
    return names_.size() - 1;
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void see(double x) { low = std::min(low, x), high = std::max(high, x); }
  /// The whole decades around, at least one.
  Range decades() const {
    const double from = std::floor(std::log10(low) + 1e-9), to = std::ceil(std::log10(high) - 1e-9);
    return {std::pow(10, from), std::pow(10, std::max(to, from + 1))};
  }
  double count() const { return std::round(std::log10(high / low)); }
};

/// Where a quantity's trials lie: the decades of cost, and those of error up to a thousand times the true
/// value's size or ten times the need.
struct Frame {
  Cost kind;
  double floor;
  Range costs, errors;
  bool strip = false;    ///< some trials have no number or are off the scale
  bool floored = false;  ///< some errors are below the floor

  Frame(const QuantityResult& q, Cost c) : kind(c), floor(error_floor(q)) {
    const double top = std::max(1e3 * size_of(q.reference.value), 10 * q.need.allowed);
    errors.see(q.need.allowed > 0 ? q.need.allowed : floor);
    for (const MethodResult& m : q.methods)
      for (const TimedTrial& t : m.trials) {
        if (std::isfinite(cost(t, kind)) && cost(t, kind) > 0) costs.see(cost(t, kind));
        floored |= t.error < floor;
        if (t.error <= top)
          errors.see(std::max(t.error, floor));
        else
          strip = true;
      }
    if (costs.high == 0) costs.see(1);
    costs = costs.decades();
    errors = errors.decades();
  }

  /// Within the strip, `part` of its height up.
  double above(double part) const { return errors.high * std::pow(10, 0.075 * part * errors.count()); }
  double top() const { return strip ? above(1) : errors.high; }
  double x(const TimedTrial& t) const {
    return std::isfinite(cost(t, kind)) ? std::max(cost(t, kind), costs.low) : costs.low;
  }
  bool within(const TimedTrial& t) const { return t.error <= errors.high; }
  double y(const TimedTrial& t) const { return within(t) ? std::max(t.error, floor) : above(0.5); }
};

std::string row(const Frame& frame, const TimedTrial& t, double y) {
  const double x = frame.x(t);
  std::string text = shortest(x) + " " + shortest(y);
  if (frame.kind == Cost::time)
    text += " " + shortest(std::isfinite(t.time.spread) ? std::min(t.time.spread, 0.9 * x) : 0);
  return text + "\n";
}

/// gnuplot's data blocks and the parts of its plot command.
struct Plot {
  std::string data, parts;

  void add(const std::string& part) { parts += (parts.empty() ? "plot " : ", \\\n  ") + part; }
};

void add_front(const QuantityResult& q, const Frame& frame, Plot& plot) {
  const std::vector<bool> front = pareto_front(q, frame.kind);
  std::vector<std::pair<double, double>> points;
  std::size_t next = 0;
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials)
      if (front[next++]) points.emplace_back(frame.x(t), frame.y(t));
  if (points.empty()) return;
  std::ranges::sort(points);
  points.emplace_back(frame.costs.high * 1.2, points.back().second);
  std::string rows;
  for (const auto& [x, y] : points) rows += shortest(x) + " " + shortest(y) + "\n";
  plot.data += block("$front", rows);
  plot.add("$front using 1:2 with steps lc rgb '#999999' lw 2.5 title 'Pareto front'");
}

/// One model's methods, under its name when there are several. Where the marks begin again, lines are dashed.
void add_model(const QuantityResult& q, const std::string& model, std::size_t index, const Frame& frame,
               Order& algorithm, Plot& plot) {
  const std::string colour = model_line(index);
  const auto methods = std::ranges::count(q.methods, model, &MethodResult::model);
  if (methods > 1) plot.add("keyentry with lines " + colour + " lw 5 title " + quoted(bold(model)));
  for (const MethodResult& m : q.methods) {
    if (m.model != model) continue;
    const std::string name = "$d" + std::to_string(&m - q.methods.data());
    std::string inside, strip;
    for (const TimedTrial& t : m.trials) (frame.within(t) ? inside : strip) += row(frame, t, frame.y(t));
    const std::size_t place = algorithm(m.algorithm);
    const std::string style = colour + " pt " + std::to_string(marks[place % marks.size()]) +
                              (place < marks.size() ? "" : " dt 4") + " ps 0.6 lw 1.1 ";
    const std::string fitted = shown_fit(m, fit(q, m));
    const std::string title = m.algorithm + (fitted.empty() ? "" : " (" + fitted + ")");
    plot.data += block(name, inside);
    plot.add(name +
             (frame.kind == Cost::time ? " using 1:2:3 with xerrorlines " : " using 1:2 with linespoints ") +
             style + "title " +
             (methods > 1 ? quoted(plain(title)) : quoted(bold(model) + ", " + plain(title))));
    if (strip.empty()) continue;
    plot.data += block(name + "s", strip);
    plot.add(name + "s using 1:2 with points " + style + "notitle");
  }
}

void add_failures(const QuantityResult& q, const Frame& frame, Plot& plot) {
  for (const FailureSign& sign : failure_signs) {
    std::string rows;
    for (const MethodResult& m : q.methods)
      for (const TimedTrial& t : m.trials)
        if (t.outcome == sign.outcome) rows += row(frame, t, frame.y(t));
    if (rows.empty()) continue;
    const std::string name = "$f" + std::to_string(&sign - failure_signs.data());
    plot.data += block(name, rows);
    plot.add(name + " using 1:2 with points lc rgb '" + sign_colour + "' pt " + std::to_string(sign.mark) +
             " ps " + shortest(sign.size) + " lw 1.3 title " + quoted(std::string(name_of(sign.outcome))));
  }
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

std::string line_across(double y, const std::string& style, const std::string& title) {
  return shortest(y) + " with lines " + style + " title " + quoted(plain(title));
}

std::string header(const QuantityResult& q, const std::string& title, const Frame& frame, std::size_t entries,
                   const std::filesystem::path& file) {
  const double decades = frame.errors.count();
  const double every = std::max(1.0, std::ceil(decades / 12));
  const double height = std::max(480.0, 90 + 17 * static_cast<double>(entries));
  return svg(height, file) + "set title " + quoted(title) +
         " noenhanced font ',14'\nset logscale xy\n"
         "set format x '10^{%L}'\nset xtics 10\nset format y '10^{%L}'\nset ytics " +
         shortest(frame.errors.low) + "," + shortest(std::pow(10, every)) + "," +
         shortest(frame.errors.high * (frame.strip ? 0.5 : 1)) + "\nunset mytics\nset xlabel " +
         quoted(frame.kind == Cost::time ? "time [s], with half the distance of its quartiles" : counted(q)) +
         "\nset ylabel " + quoted(q.unit == "1" || q.unit.empty() ? "error" : "error [" + q.unit + "]") +
         " noenhanced\n"
         "set key outside right top vertical maxcols 1 Left reverse enhanced spacing 1.05 samplen 1.6 font "
         "',11'\n"
         "set grid xtics ytics lc rgb '#dddddd' lw 0.6\nset border 3 lc rgb '#444444'\nset tics nomirror\n"
         "set xrange [" +
         shortest(frame.costs.low / 1.5) + ":" + shortest(frame.costs.high * 1.2) + "]\nset yrange [" +
         shortest(frame.errors.low / 1.5) + ":" + shortest(frame.top() * 1.2) + "]\n";
}

std::string strip_text(const Frame& frame) {
  if (!frame.strip) return "";
  return "set arrow from graph 0, first " + shortest(frame.above(0.1)) + " to graph 1, first " +
         shortest(frame.above(0.1)) +
         " nohead lc rgb '#888888' lw 0.8\nset label \"no number,\\noff the scale\" at graph -0.01, first " +
         shortest(frame.above(0.65)) + " right font ',9' tc rgb '#444444'\n";
}

}  // namespace

std::string chart_script(const QuantityResult& q, const std::string& title, Cost kind,
                         const std::filesystem::path& file) {
  const Frame frame(q, kind);
  Order model, algorithm;
  Plot plot;
  for (const MethodResult& m : q.methods) model(m.model);
  if (q.need.allowed > 0)
    plot.add(line_across(q.need.allowed, "lc rgb '#666666' dt 2 lw 1.2",
                         "needed: " + shown_error(q.need.allowed)));
  if (frame.floored)
    plot.add(line_across(frame.floor, "lc rgb '#666666' dt 3 lw 1.2",
                         "truth known to " + shown_error(frame.floor)));
  add_front(q, frame, plot);
  for (std::size_t i = 0; i < model.names().size(); ++i)
    add_model(q, model.names()[i], i, frame, algorithm, plot);
  add_failures(q, frame, plot);
  const std::size_t entries = q.methods.size() + model.names().size() + failure_signs.size() + 3;
  return "reset session\n" + plot.data + header(q, title, frame, entries, file) + strip_text(frame) +
         plot.parts + "\nunset output\n";
}

}  // namespace oddity
