#pragma once

#include <string>
#include <vector>

#include "report/text/svg.hpp"

/// Scales and axes of a plot.
namespace oddity {

/// Numbers from `low` to `high` on pixels from `from` to `to`.
struct Scale {
  double low, high;
  double from, to;
  bool logarithmic = false;

  double operator()(double x) const;
};

/// Round numbers on a scale, about so many: decades, or 1, 2 and 5 of each.
std::vector<double> ticks(const Scale&, int about);
/// "10⁻⁶" for a power of ten on a logarithmic scale; else as numbers are written.
std::string tick_label(const Scale&, double tick);

/// The rectangle of a plot.
struct Plot {
  Scale x, y;

  Pixel operator()(double at_x, double at_y) const { return {x(at_x), y(at_y)}; }
  double width() const { return x.to - x.from; }
  double height() const { return y.from - y.to; }
};

/// Grid, axes with numbers, and their names. Without a name the axis across has no numbers.
void add_axes(Svg&, const Plot&, const std::string& across, const std::string& upward);

}  // namespace oddity
