#pragma once

#include "chapters/02_basic_concepts/shared/sides.hpp"
#include "chapters/02_basic_concepts/shared/space.hpp"

/// Exercise 2.1: the curve (t, t^3, 0) for t < 0, (t, 0, t^3) from 0 on, and its one-sided limits at 0.
namespace oddity::plane_change {

using namespace identities;
using namespace space;

constexpr int before = -1, after = 1;

/// (x, y, 0) in the plane of the piece before 0, (x, 0, y) in that of the piece after.
template <class T>
Vector<T> in_plane(int side, const T& x, const T& y) {
  return side < 0 ? Vector<T>{x, y, T(0.0)} : Vector<T>{x, T(0.0), y};
}
inline auto piece(int side) {
  return [side](const auto& t) { return in_plane(side, t, t * t * t); };
}
/// The polynomial of degree n-1 through n points of a piece.
inline Vector3 interpolated(int side, double t, int n) {
  Vector3 sum{};
  for (int i = 0; i < n; ++i) {
    double weight = 1;
    for (int j = 0; j < n; ++j)
      if (j != i) weight *= (t - 0.5 * j) / (0.5 * (i - j));
    sum = sum + weight * piece(side)(0.5 * i);
  }
  return sum;
}
/// A vector of the piece's plane turned by a right angle.
inline Vector3 turned(int side, const Vector3& T) { return in_plane(side, -(side < 0 ? T[1] : T[2]), T[0]); }

struct Sample {
  double t;
  int side() const { return t < 0 ? before : after; }
  std::string where() const { return "t = " + shortest(t); }
};

struct Local {
  Vector3 r, v, a, T, N;
  double speed;
};
inline Local local(int side, double t) {
  const Motion m = motion_of(piece(side), t);
  const Vector3 T = unit(m.v);
  return {m.r, m.v, m.a, T, turned(side, T), length(m.v)};
}
inline Local local(const Sample& s) { return local(s.side(), s.t); }
inline Value all_of(const Local& l) { return joined(l.r, l.v, l.a, l.speed, l.T, l.N); }

/// From positions alone: differences of step h, on the side of the limit or across 0.
inline Value from_positions(int side, double h, bool across) {
  const auto r = [&](double t) { return piece(t < 0 || (t == 0 && side < 0) ? before : after)(t); };
  const double s = side * h;
  const Vector3 near = r(s), far = across ? r(-s) : r(0), far2 = r(2 * s);
  const Vector3 v = across ? (near - far) / (2 * s) : (near - far) / s;
  const Vector3 a = across ? (near - 2.0 * r(0) + far) / (h * h) : (far2 - 2.0 * near + r(0)) / (h * h);
  const Vector3 T = unit(v), normal = unit(a - dot(a, T) * T);
  return all_of({near, v, a, T, double(side) * normal, length(v)});
}

inline Quantity one_sided_limits(double h) {
  const Value at_zero{0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0};
  Quantity limits{"one_sided_limits",
                  "1",
                  "r, v, a, speed, T and N as t -> 0 from below, then from above",
                  {"polynomials at 0, and T turned in the plane of its piece",
                   joined(at_zero, Vector3{0, 1, 0}, at_zero, Vector3{0, 0, 1})},
                  0,
                  {1e-10, "ten decimals of numbers of size one"}};
  const auto both = [](auto f) { return [f](double s) { return joined(f(before, s), f(after, s)); }; };
  const auto pieces = both([](int side, double s) { return all_of(local(side, side * s)); });
  const auto one_sided = both([](int side, double s) { return from_positions(side, s, false); });
  const auto central = both([](int side, double s) { return from_positions(side, s, true); });
  const Knob halvings{"halvings", {2, 4, 6, 8, 10}};
  const std::string derivatives = "derivatives of each piece";
  const auto richardson = [=](auto f) {
    return [=](double n) { return limit_at_zero(f, h, static_cast<int>(n)); };
  };
  const Knob distances{"distance", {h, h * 0x1p-5, h * 0x1p-10, h * 0x1p-15, h * 0x1p-20}};
  limits.add({derivatives, "value at a distance", distances,
              [=](double s) {
                return Answer{pieces(s), 1};
              },
              Outcome::inaccurate, "the acceleration is still 6 distances away"});
  limits.add({derivatives, "Richardson", halvings, richardson(pieces)});
  limits.add({"differences of positions, one side", "Richardson", halvings, richardson(one_sided)});
  limits.add({"differences of positions across 0", "Richardson", halvings, richardson(central),
              Outcome::deceived, "they see one normal, (0, -1, 1)/sqrt(2), at every h"});
  limits.add(
      Breakdown{"Central differences are the better ones inside a piece. Across the joint they give (0, -1, "
                "1)/sqrt(2) for the normal, half-way between -N before and N after, however small the step.",
                "differences of positions across 0, Richardson", 10, Outcome::deceived,
                "differences of positions, one side, Richardson", 10});
  return limits;
}

}  // namespace oddity::plane_change
