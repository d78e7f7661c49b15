#pragma once

#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "solvers/counted_calls.hpp"

/// A function whose second derivatives exist everywhere and are not continuous at the origin:
///   p(x, y) = x y (x^2 - y^2) / (x^2 + y^2), p(0, 0) = 0   [Peano]
/// There d/dx (dp/dy) = 1 and d/dy (dp/dx) = -1, since dp/dy (x, 0) = x and dp/dx (0, y) = -y.
/// [Peano] G. Peano in A. Genocchi, Calcolo differenziale, 1884.
namespace oddity::fields {

inline constexpr auto peano = []<class T>(const Triple<T>& x) {
  const T a = x[0] * x[0], b = x[1] * x[1];
  return x[0] * x[1] * (a - b) / (a + b);
};

/// Difference quotients of Peano's slopes at the origin, by x of dp/dy and by y of dp/dx, down to 2^-400.
inline Check peano_orders() {
  Worst worst("second derivatives at the origin", "by y, then by x", "by x, then by y");
  for (int k = 10; k <= 400; k += 10) {
    const double t = std::ldexp(1.0, -k);
    worst.see(along(peano, Point{t, 0, 0}, axes[1]) / t, along(peano, Point{0, t, 0}, axes[0]) / t, 1,
              "quotient over 2^-" + std::to_string(k));
  }
  return worst.check();
}

inline Quantity peano_curl() {
  Quantity q{"peano_curl",
             "1",
             "curl grad p, component 2, at the origin, for Peano's p",
             {"1 - (-1): the slopes dp/dy = x on the x axis and dp/dx = -y on the y axis", 2.0},
             0,
             {1e-9, "nine digits"},
             {},
             {}};
  q.add({"p", "nested dual numbers", no_knob(),
         [](double) {
           long calls = 0;
           const double twist = curl(gradient(counted_calls(peano, calls)))(Point{})[2];
           return Answer{twist, calls};
         },
         Outcome::non_finite, "p is 0/0 at the origin, and dual numbers take no limits"});
  q.add({"slopes by dual numbers", "central differences 2", steps(15), [](double h) {
           ByDifferences<2> way{h};
           const double one = way.along(partial(peano, 1), Point{}, axes[0]);
           return Answer{one - way.along(partial(peano, 0), Point{}, axes[1]), way.calls};
         }});
  const auto nested = [](double h, double k) {
    ByDifferences<2> outer{h}, inner{k};
    const auto slope = [&](std::size_t j) {
      return [&inner, j](const Point& y) { return inner.along(peano, y, axes[j]); };
    };
    const double one = outer.along(slope(1), Point{}, axes[0]);
    return Answer{one - outer.along(slope(0), Point{}, axes[1]), inner.calls};
  };
  q.add({"p", "equal steps h", steps(15), [=](double h) { return nested(h, h); }, Outcome::inaccurate,
         "p is zero at all four corners (+-h, +-h), so that the difference of differences is zero for every "
         "h"});
  q.add({"p", "inner step h 2^-20", steps(15), [=](double h) { return nested(h, h * 0x1p-20); }});
  q.add(Breakdown{
      "A symmetric second difference with equal steps shows a curl of zero at every step, as if the order "
      "did not matter; the iterated limit needs an inner step much finer than the outer one.",
      "p, equal steps h", 0x1p-15, Outcome::inaccurate, "p, inner step h 2^-20", 0x1p-15});
  q.add(Breakdown{
      "Dual numbers cannot pass through 0/0 at the origin. Their slopes beside it can be differenced.",
      "p, nested dual numbers", 0, Outcome::non_finite, "slopes by dual numbers, central differences 2",
      0x1p-3});
  return q;
}

}  // namespace oddity::fields
