#include "report/charts/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "reference/text.hpp"
#include "report/charts/gnuplot.hpp"
#include "report/pages/text_view.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace {

constexpr std::size_t crowded = 8;  // methods

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

std::string row(const Frame& frame, const TimedTrial& t, double y) {
  const double x = frame.x(t);
  std::string text = shortest(x) + " " + shortest(y);
  if (frame.across == Across::time)
    text += " " + shortest(std::isfinite(t.time.spread) ? std::min(t.time.spread, 0.9 * x) : 0);
  return text + "\n";
}

/// gnuplot's data blocks and the parts of its plot command.
struct Plot {
  std::string data, parts;
  std::size_t entries = 0;  ///< of the legend

  void add(const std::string& part) { parts += (parts.empty() ? "plot " : ", \\\n  ") + part; }
  void add(const std::string& part, const std::string& enhanced_title) {
    ++entries;
    add(part + " title " + quoted(enhanced_title));
  }
};

// ---- what is worth seeing ---------------------------------------------------------------------------------

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

/// Two points of the front that the eye takes for one.
bool look_alike(const Frame& frame, const TimedTrial& a, const TimedTrial& b) {
  return std::abs(std::log10(frame.x(a) / frame.x(b))) < 0.05 &&
         std::abs(std::log10(frame.y(a) / frame.y(b))) < 0.3;
}

/// Which methods are drawn in colour.
std::vector<bool> highlighted(const QuantityResult& q, const Frame& frame) {
  std::vector<bool> chosen(q.methods.size(), true);
  if (std::ranges::count_if(q.methods, [&](const auto& m) { return frame.shows(m); }) <=
      static_cast<std::ptrdiff_t>(crowded))
    return chosen;
  const Cost kind = cost_of(frame.across);
  const std::vector<bool> front = pareto_front(q, kind);
  std::map<std::string, std::size_t> of_model;
  std::map<Family, std::size_t> of_family;
  const auto keep_best = [&](auto& best, const auto& key, std::size_t i) {
    const auto [place, first] = best.try_emplace(key, i);
    if (!first && preferable(best_of(q.methods[i], kind), best_of(q.methods[place->second], kind), kind))
      place->second = i;
  };
  std::size_t trial = 0;
  std::vector<const TimedTrial*> seen_on_front;
  for (std::size_t i = 0; i < q.methods.size(); ++i) {
    const MethodResult& m = q.methods[i];
    chosen[i] = false;
    for (const TimedTrial& t : m.trials) {
      const bool on_front =
          front[trial++] && std::ranges::none_of(seen_on_front, [&](const TimedTrial* other) {
            return look_alike(frame, t, *other);
          });
      if (on_front && frame.across != Across::setting) {
        chosen[i] = true;
        seen_on_front.push_back(&t);
      }
    }
    if (!frame.shows(m)) continue;
    keep_best(of_model, m.model, i);
    if (family_of(m.algorithm) != Family::none && best_of(m, kind).outcome == Outcome::ok)
      keep_best(of_family, family_of(m.algorithm), i);
  }
  for (const auto& [model, i] : of_model) chosen[i] = true;
  for (const auto& [family, i] : of_family) chosen[i] = true;
  return chosen;
}

// ---- parts of a chart -------------------------------------------------------------------------------------

void add_front(const QuantityResult& q, const Frame& frame, Plot& plot) {
  if (frame.across == Across::setting) return;
  const std::vector<bool> front = pareto_front(q, cost_of(frame.across));
  std::vector<std::pair<double, double>> points;
  std::size_t next = 0;
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials)
      if (front[next++]) points.emplace_back(frame.x(t), frame.y(t));
  if (points.empty()) return;
  std::ranges::sort(points);
  points.emplace_back(frame.abscissas.high * 1.2, points.back().second);
  std::string rows;
  for (const auto& [x, y] : points) rows += shortest(x) + " " + shortest(y) + "\n";
  plot.data += block("$front", rows);
  plot.add("$front using 1:2 with steps lc rgb '#aaaaaa' lw 2.5", "Pareto front");
}

/// The data of a method: `$d3` within the frame, `$d3s` in the strip.
std::string data_of(const QuantityResult& q, const MethodResult& m) {
  return "$d" + std::to_string(&m - q.methods.data());
}

void add_data(const QuantityResult& q, const Frame& frame, Plot& plot) {
  for (const MethodResult& m : q.methods) {
    if (!frame.shows(m)) continue;
    std::string inside, strip;
    for (const TimedTrial& t : m.trials) (frame.within(t) ? inside : strip) += row(frame, t, frame.y(t));
    if (frame.is_line(m) && !inside.empty())
      inside += shortest(frame.abscissas.high) + " " + shortest(frame.y(m.trials.front())) + "\n";
    plot.data += block(data_of(q, m), inside);
    if (!strip.empty()) plot.data += block(data_of(q, m) + "s", strip);
  }
}

bool in_strip(const Frame& frame, const MethodResult& m) {
  return std::ranges::any_of(m.trials, [&](const TimedTrial& t) { return !frame.within(t); });
}

void add_pale(const QuantityResult& q, const Frame& frame, const std::vector<bool>& coloured, Plot& plot) {
  std::vector<const MethodResult*> pale;
  for (const MethodResult& m : q.methods)
    if (!coloured[static_cast<std::size_t>(&m - q.methods.data())] && frame.shows(m)) pale.push_back(&m);
  for (const MethodResult* m : pale) {
    const std::string style = " lc rgb '#d4d4d4' pt 7 ps 0.3 lw 0.9";
    const std::string part = data_of(q, *m) + " using 1:2 with linespoints" + style;
    if (m == pale.front())
      plot.add(part, std::to_string(pale.size()) + " others: see the table");
    else
      plot.add(part + " notitle");
    if (in_strip(frame, *m)) plot.add(data_of(q, *m) + "s using 1:2 with points" + style + " notitle");
  }
}

/// The points as they can be seen, to one part in fifty.
std::string seen(const Frame& frame, const MethodResult& m) {
  std::string text;
  const auto place = [](double x) { return std::to_string(std::lround(100 * std::log10(x))) + " "; };
  for (const TimedTrial& t : m.trials) text += place(frame.x(t)) + place(frame.y(t));
  return text;
}

/// One model's methods, under its name when there are several. A curve that lies on another says so.
void add_model(const QuantityResult& q, const std::string& model, const Frame& frame, const Styles& styles,
               const std::vector<bool>& coloured, std::map<std::string, const MethodResult*>& drawn,
               Plot& plot) {
  constexpr std::size_t widest = 44;  // letters of the legend
  std::vector<const MethodResult*> methods;
  for (const MethodResult& m : q.methods)
    if (m.model == model && frame.shows(m) && coloured[static_cast<std::size_t>(&m - q.methods.data())])
      methods.push_back(&m);
  std::vector<std::string> titles;
  for (const MethodResult* m : methods) {
    const auto [same, first] = drawn.try_emplace(seen(frame, *m), m);
    const MethodResult& other = *same->second;
    const std::string fitted = shown_fit(*m, fit(q, *m));
    titles.push_back(m->algorithm + (!first ? ": as " + (other.algorithm == m->algorithm ? "in " + other.model
                                                                                         : other.algorithm)
                                     : fitted.empty() ? ""
                                                      : " (" + fitted + ")"));
  }
  const std::string colour = styles.colour(model);
  const bool own_line =
      methods.size() > 1 || (methods.size() == 1 && model.size() + titles[0].size() > widest - 4);
  if (own_line) plot.add("keyentry with lines " + colour + " lw 5", bold(shortened(model, widest - 4)));
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const MethodResult& m = *methods[i];
    const std::string style = colour + " " + styles.mark(m.algorithm) + " ps 0.7 lw 1.2";
    plot.add(data_of(q, m) +
                 (frame.across == Across::time ? " using 1:2:3 with xerrorlines "
                                               : " using 1:2 with linespoints ") +
                 style,
             (own_line ? "" : bold(model) + ", ") + plain(shortened(titles[i], widest)));
    if (in_strip(frame, m)) plot.add(data_of(q, m) + "s using 1:2 with points " + style + " notitle");
  }
}

/// Failed trials under the letters that the maps of stability have. `inaccurate` has none: such a trial is
/// above the line of the need.
void add_failures(const QuantityResult& q, const Frame& frame, const std::vector<bool>& coloured,
                  Plot& plot) {
  for (Outcome outcome : outcomes_of_a_map) {
    if (outcome == Outcome::ok || outcome == Outcome::inaccurate) continue;
    std::string rows, pale_rows;
    for (const MethodResult& m : q.methods)
      if (frame.shows(m))
        for (const TimedTrial& t : m.trials)
          if (t.outcome == outcome)
            (coloured[static_cast<std::size_t>(&m - q.methods.data())] ? rows : pale_rows) +=
                row(frame, t, frame.y(t));
    if (rows.empty() && pale_rows.empty()) continue;
    const std::string letter(1, letter_of(outcome));
    const auto add = [&](const std::string& name, const std::string& points, const std::string& colour) {
      if (points.empty()) return;
      plot.data += block(name, points);
      plot.add(name + " using 1:2:('" + letter + "') with labels font ',11' offset 0.9,0.45 tc rgb '" +
               colour + "' notitle");
    };
    add("$pale_" + letter, pale_rows, "#999999");
    add("$failed_" + letter, rows, "#000000");
    plot.add("keyentry with points pt '" + letter + "' lc rgb '#000000' font ',11'",
             std::string(name_of(outcome)));
  }
}

void add_line(const Frame& frame, double y, const std::string& style, const std::string& title, Plot& plot) {
  if (y >= frame.errors.low && y <= frame.errors.high)
    plot.add(shortest(y) + " with lines " + style, plain(title));
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
  return number +
         (q.unit.empty() || q.unit == "1" || q.unit.find(',') != std::string::npos ? "" : " " + q.unit);
}

std::string abscissa_name(const QuantityResult& q, const Frame& frame) {
  if (frame.across == Across::time) return "time [s], with half the interquartile range";
  if (frame.across == Across::evaluations) return counted(q);
  const bool of_time = frame.knob == "step" && q.trajectory;
  return frame.knob + (of_time ? " [" + q.trajectory->time_unit + "]" : "");
}

/// gnuplot 5.4 sets `set xtics 10` beside the decades where the range begins between two of them.
constexpr auto every_decade = "set xtics 1e-15,10,1e15\n";

/// Everything but the data: a title in two lines, axes, and the legend beside.
std::string header(const QuantityResult& q, const std::string& title, const Frame& frame, std::size_t entries,
                   const std::filesystem::path& file) {
  const double every = std::max(1.0, std::ceil(frame.errors.count() / 12));
  const double height = std::max(480.0, 160 + 20 * static_cast<double>(entries));
  const bool decades = !frame.linear && frame.abscissas.high / frame.abscissas.low > 30;
  std::string ranges;
  if (frame.across == Across::setting)
    ranges = "[" + shortest(frame.abscissas.low) + ":" + shortest(frame.abscissas.high) + "]";
  else
    ranges = "[" + shortest(frame.abscissas.low / 1.5) + ":" + shortest(frame.abscissas.high * 1.2) + "]";
  return svg(height, file) + headline(finding(q, frame.across), title, height) +
         "set lmargin at screen 0.09\nset rmargin at screen 0.64\nset logscale " +
         (frame.linear ? "y" : "xy") + "\nset format x '" + (decades ? "10^{%L}" : "%g") + "'\n" +
         (decades ? every_decade : "") + "set format y '10^{%L}'\nset ytics " + shortest(frame.errors.low) +
         "," + shortest(std::pow(10, every)) + "," + shortest(frame.errors.high * (frame.strip ? 0.5 : 1)) +
         "\nunset mytics\nset xlabel " + quoted(abscissa_name(q, frame)) + " noenhanced\nset ylabel " +
         quoted(q.unit == "1" || q.unit.empty() ? "error" : "error [" + q.unit + "]") +
         " noenhanced\nset key at screen 0.655, screen " + shortest(1 - 50 / height) +
         " left top vertical maxcols 1 Left reverse enhanced spacing 1.1 samplen 1.6 font ',12'\n"
         "set grid xtics ytics lc rgb '#dddddd' lw 0.6\nset border 3 lc rgb '#444444'\nset tics nomirror\n"
         "set xrange " +
         ranges + "\nset yrange [" + shortest(frame.errors.low / 1.5) + ":" + shortest(frame.top() * 1.2) +
         "]\n";
}

std::string strip_text(const Frame& frame) {
  if (!frame.strip) return "";
  return "set arrow from graph 0, first " + shortest(frame.above(0.1)) + " to graph 1, first " +
         shortest(frame.above(0.1)) +
         " nohead lc rgb '#888888' lw 0.8\nset label \"no number,\\noff the scale\" at graph -0.01, first " +
         shortest(frame.above(0.65)) + " right font ',10' tc rgb '#444444'\n";
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
           shown_knob(*best);
  if (best->outcome != Outcome::ok)
    return "No method reaches " + needed + "; the closest is " + named(*best) + ": " +
           in_unit(shown_error(best->error), q);
  const std::string work =
      across == Across::time
          ? shown_time(best->time.seconds)
          : with_commas(best->evaluations) + (best->evaluations == 1 ? " evaluation" : " evaluations");
  return named(*best) + " reaches " + needed + " with the least work: " + work;
}

std::string chart_script(const QuantityResult& q, const std::string& title, Across across,
                         const std::filesystem::path& file, const Styles& styles) {
  const Frame frame(q, across);
  const std::vector<bool> coloured = highlighted(q, frame);
  Plot plot;
  add_data(q, frame, plot);
  if (q.need.allowed > 0)
    add_line(frame, q.need.allowed, "lc rgb '#666666' dt 2 lw 1.2",
             "needed: " + in_unit(shown_error(q.need.allowed), q), plot);
  if (q.trajectory)
    add_line(frame, q.trajectory->close, "lc rgb '#666666' dt 5 lw 1.2",
             "enough for a game: " + in_unit(shown_error(q.trajectory->close), q), plot);
  if (frame.floored)
    add_line(frame, frame.floor, "lc rgb '#666666' dt 3 lw 1.2",
             "truth known to " + in_unit(shown_error(frame.floor), q), plot);
  add_pale(q, frame, coloured, plot);
  add_front(q, frame, plot);
  std::vector<std::string> models;
  for (const MethodResult& m : q.methods)
    if (std::ranges::find(models, m.model) == models.end()) models.push_back(m.model);
  std::map<std::string, const MethodResult*> drawn;
  for (const std::string& model : models) add_model(q, model, frame, styles, coloured, drawn, plot);
  add_failures(q, frame, coloured, plot);
  return "reset session\n" + plot.data + header(q, title, frame, plot.entries, file) + strip_text(frame) +
         plot.parts + "\nunset output\n";
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

std::string series_script(const std::vector<const QuantityResult*>& series, const std::string& title,
                          const std::filesystem::path& file, const Styles& styles) {
  struct Curve {
    std::string rows;
    double first_size, first_cost, size, cost;
    int points = 0;
  };
  std::vector<std::pair<const MethodResult*, Curve>> curves;
  for (const QuantityResult* q : series)
    for (const MethodResult& m : q->methods) {
      auto found = std::ranges::find_if(curves, [&](const auto& c) {
        return c.first->model == m.model && c.first->algorithm == m.algorithm;
      });
      const auto size = static_cast<double>(size_in_name(q->name));
      const double work = cost(m.trials.back(), Cost::evaluations);
      if (found == curves.end()) {
        curves.push_back({&m, {"", size, work, size, work}});
        found = curves.end() - 1;
      }
      Curve& curve = found->second;
      curve.rows += shortest(size) + " " + shortest(work) + "\n";
      curve.size = size, curve.cost = work, ++curve.points;
    }
  Plot plot;
  std::pair<double, std::string> cheapest{INFINITY, ""};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& [method, curve] = curves[i];
    const std::string name = "$d" + std::to_string(i);
    plot.data += block(name, curve.rows);
    std::string growth;
    if (curve.points > 1)
      growth = "work ~ n^" +
               rounded(std::log(curve.cost / curve.first_cost) / std::log(curve.size / curve.first_size), 3);
    cheapest = std::min(cheapest, {curve.cost / curve.size,
                                   method->algorithm + " (" + method->model +
                                       ") needs the least work: " + with_commas(std::lround(curve.cost)) +
                                       " for n = " + rounded(curve.size, 6)});
    if (i == 0 || curves[i - 1].first->model != method->model)
      plot.add("keyentry with lines " + styles.colour(method->model) + " lw 5", bold(method->model));
    plot.add(name + " using 1:2 with linespoints " + styles.colour(method->model) + " " +
                 styles.mark(method->algorithm) + " ps 0.9 lw 1.4",
             plain(method->algorithm + (growth.empty() ? "" : " (" + growth + ")")));
  }
  const double height = 480;
  return "reset session\n" + plot.data + svg(height, file) + headline(cheapest.second, title, height) +
         "set lmargin at screen 0.09\nset rmargin at screen 0.64\nset logscale xy\nset format x '10^{%L}'\n"
         "set format y '10^{%L}'\nset xtics 1,10,1e15\nset ytics 1,10,1e15\nset xlabel 'n'\nset ylabel "
         "'counted work'\n"
         "set key at screen 0.655, screen 0.89 left top vertical maxcols 1 Left reverse enhanced spacing 1.1 "
         "samplen 1.6 font ',12'\nset grid xtics ytics lc rgb '#dddddd' lw 0.6\n"
         "set border 3 lc rgb '#444444'\nset tics nomirror\nset offsets graph 0.05, graph 0.05, graph 0.05, "
         "graph 0.05\n" +
         plot.parts + "\nunset output\n";
}

}  // namespace oddity
