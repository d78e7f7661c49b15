#pragma once

#include <vector>

#include "chapters/02_basic_concepts/shared/space.hpp"
#include "chapters/exercise.hpp"

/// The curve of exercise 2.1, and its claims.
namespace oddity::ex02_01 {

using namespace space;

inline constexpr int before = -1, after = 1;

/// (x, y, 0) in the plane of the piece before 0, (x, 0, y) in the plane of the piece after 0.
template <class T>
Vector<T> in_plane(int side, const T& x, const T& y) {
  return side < 0 ? Vector<T>{x, y, T(0.0)} : Vector<T>{x, T(0.0), y};
}
inline auto piece(int side) {
  return [side](const auto& t) { return in_plane(side, t, t * t * t); };
}

template <class Number>
struct LocalOf {
  Vector<Number> r, v, a, T, N;
  Number speed;
};
using Local = LocalOf<double>;
template <class Number>
LocalOf<Number> local(int side, const Number& t) {
  const auto m = motion_of(piece(side), t);
  const Vector<Number> T = unit(m.v), N = in_plane<Number>(side, -(side < 0 ? T[1] : T[2]), T[0]);
  return {m.r, m.v, m.a, T, N, length(m.v)};
}

std::vector<Claim> claims(double h, double seed);
Provables proofs();

}  // namespace oddity::ex02_01
