#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "report/charts/chart.hpp"
#include "report/text/svg.hpp"

/// Shared parts of the charts of trials: layout, ranges, and names at the ends of curves.
namespace oddity {

// Pixels.
inline constexpr double chart_width = 960, plot_left = 70, plot_right = 570, label_left = 596,
                        label_height = 17;
inline constexpr double least_plot_height = 300, below_plot = 56;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void see(double x) { low = std::min(low, x), high = std::max(high, x); }
  bool empty() const { return high == 0; }
  /// The enclosing whole decades, at least one.
  Range decades() const {
    const double from = std::floor(std::log10(low) + 1e-9), to = std::ceil(std::log10(high) - 1e-9);
    return {std::pow(10, from), std::pow(10, std::max(to, from + 1))};
  }
  double count() const { return std::round(std::log10(high / low)); }
};

Cost cost_of(Across);
/// The kind of setting in a chart over settings: that of most methods, a tolerance only if there is no other.
std::string main_resolution(const QuantityResult&);

/// Ranges of a quantity's chart. Errors are shown up to a thousand times the size of the true value or ten
/// times the need, whichever is larger.
struct Frame {
  Across across;
  std::string resolution;
  double floor;
  Range abscissas, errors;
  bool linear = false;   ///< linear abscissa, for a count over a short range
  bool strip = false;    ///< some trials have no number or are off the scale
  bool floored = false;  ///< some errors are below the floor

  Frame(const QuantityResult&, Across);

  double abscissa(const TimedTrial& t) const {
    if (across != Across::setting) return cost(t, cost_of(across));
    return t.resolution == resolution ? t.setting : std::numeric_limits<double>::quiet_NaN();
  }
  /// Whether the method has no setting: it is a horizontal line in a chart over settings.
  bool is_line(const MethodResult& m) const {
    return across == Across::setting && m.trials.front().resolution.empty();
  }
  bool shows(const MethodResult& m) const {
    return across != Across::setting || is_line(m) || m.trials.front().resolution == resolution;
  }
  /// The ordinate at a fraction of the strip's height.
  double above(double part) const { return errors.high * std::pow(10, 0.075 * part * errors.count()); }
  double top() const { return strip ? above(1) : errors.high; }
  double x(const TimedTrial& t) const {
    const double at = abscissa(t);
    return std::isfinite(at) ? std::max(at, abscissas.low) : abscissas.low;
  }
  bool within(const TimedTrial& t) const { return t.error <= errors.high; }
  double y(const TimedTrial& t) const { return within(t) ? std::max(t.error, floor) : above(0.5); }
};

/// A name next to the end of its curve.
struct Label {
  Pixel end;
  std::string text;
  int slot;  ///< -1: not the name of a curve
};
inline constexpr std::size_t longest_label = 50;  // characters

/// Draws the names one below another, each with a thin line to its end.
void add_labels(Svg&, const std::vector<Label>&, double top, double bottom);

/// "Runge-Kutta 4 (one angle)".
std::string named(const TimedTrial&);
/// "1,234,567".
std::string with_commas(long);

}  // namespace oddity
