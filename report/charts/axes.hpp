#pragma once

#include <string>
#include <vector>

#include "report/text/svg.hpp"

/// Scales and axes of a plot.
namespace oddity {

/// Maps numbers from `low` to `high` to pixels from `from` to `to`.
struct Scale {
  double low, high;
  double from, to;
  bool logarithmic = false;

  double operator()(double x) const;
};

/// Round numbers on a scale, about `about` of them: powers of ten, or 1, 2 and 5 times these.
std::vector<double> ticks(const Scale&, int about);
/// "10⁻⁶" for a power of ten on a logarithmic scale, otherwise a plain number.
std::string tick_label(const Scale&, double tick);

/// The rectangle of a plot.
struct Plot {
  Scale x, y;

  Pixel operator()(double at_x, double at_y) const { return {x(at_x), y(at_y)}; }
  double width() const { return x.to - x.from; }
  double height() const { return y.from - y.to; }
};

/// Draws the grid and both axes with numbers and names. If `across` is empty, the horizontal axis has no
/// numbers.
void add_axes(Svg&, const Plot&, const std::string& across, const std::string& upward);

}  // namespace oddity
