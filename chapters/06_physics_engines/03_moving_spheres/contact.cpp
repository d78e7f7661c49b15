// The user's two moving spheres: when do they first touch? With relative position d and relative velocity v
// they touch when |d + t v| is the sum R of the radii:
//   v.v t^2 + 2 d.v t + d.d - R^2 = 0.
// The independent route is geometry, in long double. The path of d passes the origin at |d x v| / |v|, and
// the contact is half a chord of the sphere R before that.

#include <algorithm>
#include <cmath>
#include <limits>

#include "chapters/06_physics_engines/03_moving_spheres/moving_spheres.hpp"
#include "chapters/inputs.hpp"

namespace oddity::ex06_03 {

namespace {

template <class T>
using Vector = std::array<T, 3>;

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Relative position and velocity of the second center, and the sum of the radii.
template <class T>
struct Approach {
  Vector<T> d, v;
  T R;

  T gap_at(T t) const {
    T squared = 0;
    for (std::size_t i = 0; i < 3; ++i) squared += (d[i] + t * v[i]) * (d[i] + t * v[i]);
    return std::sqrt(squared) - R;
  }
};

template <class T>
Approach<T> approach(const Parameters& p) {
  Approach<T> a{{}, {}, static_cast<T>(p["r1"]) + static_cast<T>(p["r2"])};
  const auto c1 = point_of(p, "c1"), c2 = point_of(p, "c2"), v1 = point_of(p, "v1"), v2 = point_of(p, "v2");
  for (std::size_t i = 0; i < 3; ++i) {
    a.d[i] = static_cast<T>(c2[i]) - static_cast<T>(c1[i]);
    a.v[i] = static_cast<T>(v2[i]) - static_cast<T>(v1[i]);
  }
  return a;
}

constexpr double most_frames = 1e6;  ///< hours of a game

/// NaN: they never touch. 0: they touch from the start.
long double by_geometry(const Approach<long double>& a) {
  if (a.gap_at(0) <= 0) return 0;
  const Vector<long double> across{a.d[1] * a.v[2] - a.d[2] * a.v[1], a.d[2] * a.v[0] - a.d[0] * a.v[2],
                                   a.d[0] * a.v[1] - a.d[1] * a.v[0]};
  const long double speed = std::sqrt(dot(a.v, a.v)), nearest = std::sqrt(dot(across, across)) / speed;
  const long double along = -dot(a.d, a.v) / speed;
  if (!(speed > 0 && along > 0 && nearest <= a.R)) return std::numeric_limits<long double>::quiet_NaN();
  return (along - std::sqrt((a.R - nearest) * (a.R + nearest))) / speed;
}

}  // namespace

std::optional<Quantity> first_contact(const Parameters& p) {
  const long double truth = by_geometry(approach<long double>(p));
  if (!std::isfinite(truth) || truth == 0) return std::nullopt;
  const Approach<double> a = approach<double>(p);
  const double t = static_cast<double>(truth);
  Quantity q{"first_contact",
             "frames",
             "time at which the two spheres that you choose first touch",
             {"geometry, in long double", t},
             4e-16 * t,
             {1e-9 * t, "nine digits"},
             {},
             {}};
  const double A = dot(a.v, a.v), B = dot(a.d, a.v), C = dot(a.d, a.d) - a.R * a.R;
  q.add({"quadratic equation", "textbook root", no_resolution(), [=](double) {
           return Answer{(-B - std::sqrt(B * B - A * C)) / A, 1};
         }});
  q.add({"quadratic equation", "root without cancellation", no_resolution(), [=](double) {
           return Answer{C / (-B + std::sqrt(B * B - A * C)), 1};
         }});
  q.add({"gap", "bisection from the nearest approach", doubling("steps", 8, 4), [=](double steps) {
           double low = 0, high = -B / A;
           for (int i = 0; i < static_cast<int>(steps); ++i) {
             const double middle = (low + high) / 2;
             (a.gap_at(middle) > 0 ? low : high) = middle;
           }
           return Answer{high, static_cast<long>(steps)};
         }});
  q.add({"gap", "looked at in every frame", no_resolution(),
         [=](double) {
           const double last = std::min(2 * t + 2, most_frames);
           double frame = 0;
           while (a.gap_at(frame) > 0 && frame < last) ++frame;
           return Answer{frame, static_cast<long>(frame) + 1};
         },
         Outcome::inaccurate, "it sees the contact a part of a frame late, or not at all"});
  return q;
}

}  // namespace oddity::ex06_03
