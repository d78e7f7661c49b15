#include "report/charts/axes.hpp"

#include <algorithm>
#include <cmath>

#include "reference/text.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

std::vector<double> decades(const Scale& s, int about) {
  const double first = std::ceil(std::log10(s.low) - 1e-9), last = std::floor(std::log10(s.high) + 1e-9);
  const double every = std::max(1.0, std::ceil((last - first) / about));
  std::vector<double> found;
  for (double power = first; power <= last; power += every) found.push_back(std::pow(10, power));
  return found;
}

/// 1, 2 and 5 of each decade.
std::vector<double> parts_of_decades(const Scale& s) {
  std::vector<double> found;
  for (double power = std::floor(std::log10(s.low)); power <= std::log10(s.high); ++power)
    for (double part : {1.0, 2.0, 5.0})
      if (const double x = part * std::pow(10, power); x >= s.low && x <= s.high) found.push_back(x);
  return found;
}

std::vector<double> evenly(const Scale& s, int about) {
  const double rough = (s.high - s.low) / about, decade = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * decade;
  for (double part : {5.0, 2.0, 1.0})
    if (part * decade >= rough) step = part * decade;
  std::vector<double> found;
  for (double i = std::ceil(s.low / step - 1e-9); i * step <= s.high + 1e-9 * step; ++i)
    found.push_back(i == 0 ? 0 : i * step);
  return found;
}

}  // namespace

double Scale::operator()(double x) const {
  const double part = logarithmic ? std::log(x / low) / std::log(high / low) : (x - low) / (high - low);
  return from + part * (to - from);
}

std::vector<double> ticks(const Scale& s, int about) {
  if (!s.logarithmic) return evenly(s, about);
  return s.high / s.low > 50 ? decades(s, about) : parts_of_decades(s);
}

std::string tick_label(const Scale& s, double tick) {
  const double power = std::round(std::log10(std::abs(tick)));
  if (s.logarithmic && s.high / s.low > 50 && std::abs(power) > 2)
    return with_powers("1e" + std::string(power < 0 ? "-" : "+") + format_shortest(std::abs(power)))
        .substr(std::string("1×").size());
  return with_powers(format_significant(tick, 4));
}

void add_axes(Svg& svg, const Plot& plot, const std::string& across, const std::string& upward) {
  constexpr double letter = 4;  // pixels from a line's middle to the baseline
  for (double tick : ticks(plot.y, std::max(2, static_cast<int>(plot.height() / 30)))) {
    const double y = plot.y(tick);
    svg.line({plot.x.from, y}, {plot.x.to, y}, "grid");
    svg.text({plot.x.from - 6, y + letter}, tick_label(plot.y, tick), "dim", Svg::Anchor::end);
  }
  for (double tick : ticks(plot.x, std::max(2, static_cast<int>(plot.width() / 60)))) {
    const double x = plot.x(tick);
    svg.line({x, plot.y.from}, {x, plot.y.to}, "grid");
    if (!across.empty())
      svg.text({x, plot.y.from + 16}, tick_label(plot.x, tick), "dim", Svg::Anchor::middle);
  }
  svg.path("M" + px(plot.x.from) + " " + px(plot.y.to) + "V" + px(plot.y.from) + "H" + px(plot.x.to), "axis");
  if (!across.empty())
    svg.text({(plot.x.from + plot.x.to) / 2, plot.y.from + 36}, across, "t", Svg::Anchor::middle);
  svg.upward_text({16, (plot.y.from + plot.y.to) / 2}, upward, "t");
}

}  // namespace oddity
