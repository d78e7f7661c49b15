#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "report/charts/chart.hpp"
#include "report/text/svg.hpp"

/// What the charts of trials share: where things stand, ranges, and names at the ends of curves.
namespace oddity {

// Pixels.
inline constexpr double chart_width = 960, plot_left = 70, plot_right = 570, label_left = 596,
                        label_height = 17;
inline constexpr double least_plot_height = 300, below_plot = 56;

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

Cost cost_of(Across);
/// The knob of a chart over settings: the one of most methods, a tolerance only if there is no other.
std::string main_knob(const QuantityResult&);

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

  Frame(const QuantityResult&, Across);

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

/// A name beside the end of its curve.
struct Label {
  Pixel end;
  std::string text;
  int slot;  ///< -1: of no curve
};
inline constexpr std::size_t longest_label = 50;  // letters

/// The names one beneath the other, each with a thin line to its end.
void add_labels(Svg&, const std::vector<Label>&, double top, double bottom);

/// "Runge-Kutta 4 (one angle)".
std::string named(const TimedTrial&);
/// "1,234,567".
std::string with_commas(long);

}  // namespace oddity
