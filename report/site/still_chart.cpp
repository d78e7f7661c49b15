#include "report/site/still_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/text.hpp"
#include "report/charts/axes.hpp"
#include "report/charts/chart.hpp"
#include "report/charts/labels.hpp"
#include "report/site/page.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;

constexpr double left = 46, right = 600, top = 8, bottom = 218;

struct Curve {
  const MethodResult* method;
  std::vector<Pixel> points;  ///< from coarse to fine
  std::vector<Pixel> ok;      ///< the ok ones
};

std::string whole_pixel(double x) { return std::to_string(std::lround(x)); }
std::string place(Pixel p) { return whole_pixel(p.x) + " " + whole_pixel(p.y); }

struct Decades {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void see(double x) {
    if (x > 0) low = std::min(low, x), high = std::max(high, x);
  }
  Scale on(double from, double to) const {
    if (high == 0) return {1, 10, from, to, true};
    const double first = std::floor(std::log10(low) + 1e-9), last = std::ceil(std::log10(high) - 1e-9);
    return {std::pow(10, first), std::pow(10, std::max(last, first + 1)), from, to, true};
  }
};

/// The error of the methods worth showing, against the work or the setting.
class Chart {
 public:
  Chart(const QuantityResult& q, Across across) : q_(q), across_(across), floor_(error_floor(q)) {
    const double far = std::max(1e3 * size_of(q.reference.value), 10 * q.need.allowed);
    Decades x, y;
    y.see(q.need.allowed);
    const auto shown = worth_seeing(q, across);
    for (std::size_t i : shown)
      for (const TimedTrial& t : q.methods[i].trials) {
        x.see(abscissa(t));
        if (t.error <= far) y.see(std::max(t.error, floor_));
      }
    plot_ = {x.on(left, right), y.on(bottom, top)};
    for (std::size_t i : shown) curves_.push_back(curve_of(q.methods[i]));
  }

  std::string svg() const {
    std::string text = "<svg viewBox=\"0 0 620 250\" role=\"img\" aria-label=\"Error against " + axis() +
                       "; the table below has numbers.\">" + grid();
    const double need = q_.need.allowed;
    if (need >= plot_.y.low && need <= plot_.y.high)
      text += path(" class=\"need\"",
                   "M" + whole_pixel(left) + " " + whole_pixel(plot_.y(need)) + "H" + whole_pixel(right));
    std::vector<double> ends;
    for (const Curve& curve : curves_) ends.push_back(curve.points.empty() ? top : curve.points.back().y);
    const std::vector<double> keys = spread(ends, 11, top, bottom);
    for (std::size_t i = 0; i < curves_.size(); ++i) text += drawn(curves_[i], i + 1, keys[i] + 4);
    return text + "</svg>";
  }

 private:
  static std::string path(const std::string& attributes, const std::string& data) {
    return "<path" + attributes + " d=\"" + data + "\"/>";
  }
  double abscissa(const TimedTrial& t) const {
    if (across_ == Across::evaluations) return static_cast<double>(t.evaluations);
    return t.resolution.empty() ? std::numeric_limits<double>::quiet_NaN() : t.setting;
  }
  std::string axis() const {
    if (across_ == Across::evaluations) return q_.in_operations ? "operations" : "evaluations";
    for (const Curve& curve : curves_)
      if (const std::string& resolution = curve.method->trials.front().resolution; !resolution.empty())
        return in_xml(resolution);
    return "setting";
  }
  /// Errors without a number, or far off, are at the upper edge.
  Curve curve_of(const MethodResult& m) const {
    Curve curve{&m, {}, {}};
    for (const TimedTrial& t : m.trials) {
      const double x = abscissa(t), y = std::isfinite(t.error) ? std::max(t.error, floor_) : plot_.y.high;
      const Pixel at{std::isnan(x) ? left : plot_.x(std::max(x, plot_.x.low)),
                     plot_.y(std::min(y, plot_.y.high))};
      curve.points.push_back(at);
      if (t.outcome == Outcome::ok) curve.ok.push_back(at);
    }
    return curve;
  }
  std::string grid() const {
    std::string lines, numbers;
    const auto number = [&](Pixel at, const std::string& words) {
      numbers += "<text x=\"" + whole_pixel(at.x) + "\" y=\"" + whole_pixel(at.y) + "\">" + words + "</text>";
    };
    for (double tick : ticks(plot_.y, 6)) {
      lines += "M" + whole_pixel(left) + " " + whole_pixel(plot_.y(tick)) + "H" + whole_pixel(right);
      number({left - 16, plot_.y(tick) + 4}, tick_label(plot_.y, tick));
    }
    for (double tick : ticks(plot_.x, 8)) {
      lines += "M" + whole_pixel(plot_.x(tick)) + " " + whole_pixel(top) + "V" + whole_pixel(bottom);
      number({plot_.x(tick), bottom + 14}, tick_label(plot_.x, tick));
    }
    const std::string unit = q_.unit.empty() || q_.unit == "1" ? "" : " [" + in_xml(q_.unit) + "]";
    number({(left + right) / 2, bottom + 28}, "error" + unit + " against " + axis());
    return path("", lines) + numbers;
  }
  /// Dots where it is ok, and its number in the table at its end.
  static std::string drawn(const Curve& curve, std::size_t key, double height) {
    std::string line, dots;
    for (const Pixel& p : curve.points) line += (line.empty() ? "M" : "L") + place(p);
    for (const Pixel& p : curve.ok) dots += "M" + place(p) + "h0";
    const double end = curve.points.empty() ? left : curve.points.back().x + 6;
    return "<g class=\"s" + std::to_string(key) + "\">" + path("", line) +
           (dots.empty() ? "" : path(" class=\"ok\"", dots)) + "<text x=\"" + whole_pixel(end) + "\" y=\"" +
           whole_pixel(height) + "\">" + std::to_string(key) + "</text></g>";
  }

  const QuantityResult& q_;
  Across across_;
  double floor_;
  Plot plot_{};
  std::vector<Curve> curves_;
};

std::string cell(const std::string& content) { return element("td", "", content); }

/// The methods worth showing, each at its best setting.
std::string table_of(const QuantityResult& q, const std::vector<std::size_t>& shown, bool keyed) {
  std::string rows;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const MethodResult& m = q.methods[shown[i]];
    const TimedTrial& t = best_of(m, Cost::evaluations);
    const std::string key = std::to_string(i + 1);
    rows += "<tr>" +
            element("th", "",
                    (keyed ? "<b class=\"s" + key + "\">" + key + "</b> " : "") +
                        in_xml(m.model + ", " + m.algorithm)) +
            cell(t.resolution.empty() ? "" : in_xml(with_powers(shown_resolution(t)))) +
            cell(in_xml(with_powers(shown_error(t.error)))) + cell(std::to_string(t.evaluations)) +
            cell(std::string(name_of(t.outcome))) + "</tr>\n";
  }
  const std::size_t others = q.methods.size() - shown.size();
  return "<div class=\"wide\"><table class=\"still\"><tr><th>method</th><th>setting</th><th>error</th><th>evaluations</th>"
         "<th>ends</th></tr>\n" +
         rows + "</table></div>" +
         (others > 0 ? element("p", "", std::to_string(others) + " more were tried.") : "");
}

/// The letters of a row; those that roundings decide are bold.
std::string marked_letters(const MapRow& row) {
  std::string text;
  for (std::size_t k = 0; k < row.outcomes.size(); ++k) {
    const std::string letter(1, letter_of(row.outcomes[k]));
    text += row.fragile[k] ? element("b", "", letter) : letter;
  }
  return text;
}

}  // namespace

std::string still_chart(const QuantityResult& q) {
  const auto charts = charts_of(q);
  const Across across = charts.empty() ? Across::evaluations : charts.front();
  std::string text;
  if (!charts.empty())
    text = element("div", " class=\"still\"",
                   Chart(q, across).svg() + element("p", "", in_xml(finding(q, across)) + "."));
  return "<noscript>" + text + table_of(q, worth_seeing(q, across), !charts.empty()) + "</noscript>";
}

std::string still_map(const Stability& s) {
  if (s.map.empty() || s.steps.empty()) return "";
  std::string key, head, rows;
  for (Outcome outcome : outcomes_of_a_map) {
    const bool there = std::ranges::any_of(s.map, [&](const MapRow& row) {
      return std::ranges::find(row.outcomes, outcome) != row.outcomes.end();
    });
    if (there)
      key +=
          std::string(key.empty() ? ": " : ", ") + letter_of(outcome) + " " + std::string(name_of(outcome));
  }
  const auto same = [](const MapRow& a, const MapRow& b) {
    return a.model == b.model && a.algorithm == b.algorithm;
  };
  for (const MapRow& row : s.map)
    if (same(row, s.map.front())) head += element("th", "", format_significant(row.value, 3));
  for (std::size_t i = 0; i < s.map.size(); ++i) {
    const MapRow& row = s.map[i];
    if (i == 0 || !same(row, s.map[i - 1]))
      rows += (i == 0 ? "<tr>" : "</tr>\n<tr>") + element("th", "", in_xml(row.model + ", " + row.algorithm));
    rows += cell(element("code", "", marked_letters(row)));
  }
  const std::string unit = s.time_unit.empty() ? "" : " " + in_xml(s.time_unit);
  const bool fragile =
      std::ranges::any_of(s.map, [](const MapRow& row) { return !fragile_cells(row).empty(); });
  const std::string in_bold = fragile ? " Bold: a few roundings at the start decide." : "";
  return "<noscript>" +
         element("p", "",
                 "How each trial ends over <var>" + in_xml(s.parameter) + "</var>: a letter a step, from " +
                     format_significant(s.steps.front(), 3) + unit + " to " +
                     format_significant(s.steps.back(), 3) + unit + key + "." + in_bold) +
         "<div class=\"wide\"><table class=\"still\"><tr><th>method</th>" + head + "</tr>\n" + rows +
         "</tr></table></div></noscript>";
}

}  // namespace oddity
