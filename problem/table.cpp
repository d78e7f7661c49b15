#include "problem/table.hpp"

#include <algorithm>
#include <cmath>

namespace oddity::problem {

namespace {

using Values = std::vector<double>;

Values differences(const Values& x) {
  Values all;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) all.push_back(x[i + 1] - x[i]);
  return all;
}

/// Slopes of the curve whose second derivative is continuous, and zero at the ends. `h` and `slope` are from
/// knot to knot.
Values natural_slopes(const Values& h, const Values& slope) {
  const std::size_t last = h.size();
  Values diagonal{2}, above{1}, right{3 * slope[0]};
  for (std::size_t i = 1; i <= last; ++i) {
    const bool ends = i == last;
    const double below = ends ? 1 : h[i], factor = below / diagonal.back();
    diagonal.push_back((ends ? 2 : 2 * (h[i - 1] + h[i])) - factor * above.back());
    right.push_back((ends ? 3 * slope[i - 1] : 3 * (h[i] * slope[i - 1] + h[i - 1] * slope[i])) -
                    factor * right.back());
    above.push_back(ends ? 0 : h[i - 1]);
  }
  Values at_knots(last + 1);
  for (std::size_t i = last + 1; i-- > 0;)
    at_knots[i] = (right[i] - (i == last ? 0 : above[i] * at_knots[i + 1])) / diagonal[i];
  return at_knots;
}

/// M. Steffen, Astronomy and Astrophysics 239, 443 (1990), equation 11.
Values steffens_slopes(const Values& h, const Values& slope) {
  Values at_knots{slope.front()};
  for (std::size_t i = 1; i < h.size(); ++i) {
    const double before = slope[i - 1], after = slope[i];
    const double through = (before * h[i] + after * h[i - 1]) / (h[i - 1] + h[i]);
    const double size = std::min({std::abs(before), std::abs(after), std::abs(through) / 2});
    at_knots.push_back(before * after > 0 ? std::copysign(2 * size, before) : 0);
  }
  at_knots.push_back(slope.back());
  return at_knots;
}

}  // namespace

std::size_t fewest_rows(Spline spline) { return spline == Spline::linear ? 2 : 3; }

std::vector<Table::Piece> pieces_of(Spline spline, const std::vector<double>& x,
                                    const std::vector<double>& y) {
  const Values h = differences(x), rise = differences(y);
  Values slope;
  for (std::size_t i = 0; i < h.size(); ++i) slope.push_back(rise[i] / h[i]);
  std::vector<Table::Piece> pieces;
  if (spline == Spline::linear) {
    for (std::size_t i = 0; i < h.size(); ++i) pieces.push_back({x[i], {y[i], slope[i], 0, 0}});
    return pieces;
  }
  const Values at = spline == Spline::cubic ? natural_slopes(h, slope) : steffens_slopes(h, slope);
  for (std::size_t i = 0; i < h.size(); ++i)
    pieces.push_back({x[i],
                      {y[i], at[i], (3 * slope[i] - 2 * at[i] - at[i + 1]) / h[i],
                       (at[i] + at[i + 1] - 2 * slope[i]) / (h[i] * h[i])}});
  return pieces;
}

}  // namespace oddity::problem
