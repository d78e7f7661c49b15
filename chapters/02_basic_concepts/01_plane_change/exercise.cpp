// Exercise 2.1: which of r, v, a, speed, T and N of r(t) = (t, t^3, 0) for t < 0, (t, 0, t^3) for t >= 0 are
// continuous at t = 0?
// The text's formulas are checked by dual numbers, its limits by Richardson extrapolation. N is T rotated by
// a right angle in the plane of its piece (the book's (2.5)). The independent route is the principal normal,
// along (v x a) x v [do Carmo, Differential Geometry of Curves and Surfaces, 1-5], which is -N before 0. A
// unit normal not in that plane need not jump [Bishop, Amer. Math. Monthly 82 (1975) 246].

#include <cmath>

#include "chapters/02_basic_concepts/01_plane_change/plane_change.hpp"
#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "chapters/02_basic_concepts/shared/space.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex02_01 {

using limits::joined, limits::limit_at_zero;

constexpr Parameter parameters[] = {
    {"h", 0.25, "1", "distance from $t=0$ at which a numerical limit starts", 1e-3, 0.5},
    {"seed", 1, "", "seed of the random times", 0, 1e9, whole_number},
};

// ---- the curve --------------------------------------------------------------------------------------------

Value all_of(const Local& l) { return joined(l.r, l.v, l.a, l.speed, l.T, l.N); }

/// v and a from positions alone: differences of step h, on one side of 0 or across it.
Value from_positions(int side, double h, bool across) {
  const auto r = [&](double t) { return piece(t < 0 || (t == 0 && side < 0) ? before : after)(t); };
  const double s = side * h;
  const Vector3 near = r(s), far = across ? r(-s) : r(0), far2 = r(2 * s);
  const Vector3 v = across ? (near - far) / (2 * s) : (near - far) / s;
  const Vector3 a = across ? (near - 2.0 * r(0) + far) / (h * h) : (far2 - 2.0 * near + r(0)) / (h * h);
  const Vector3 T = unit(v), normal = unit(a - dot(a, T) * T);
  return all_of({near, v, a, T, double(side) * normal, length(v)});
}

Quantity one_sided_limits(double h) {
  const Value at_zero{0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0};
  Quantity limits{
      "one_sided_limits",
      "1",
      R"($\mathbf r$, $\mathbf v$, $\mathbf a$, speed, $\mathbf T$ and $\mathbf N$ as $t\to0$ from below, )"
      R"(then from above)",
      {R"(polynomials at 0, and $\mathbf T$ turned in the plane of its piece)",
       joined(at_zero, Vector3{0, 1, 0}, at_zero, Vector3{0, 0, 1})},
      0,
      {1e-10, "ten decimals of numbers of size one"}};
  const auto both = [](auto f) { return [f](double s) { return joined(f(before, s), f(after, s)); }; };
  const auto pieces = both([](int side, double s) { return all_of(local(side, side * s)); });
  const auto one_sided = both([](int side, double s) { return from_positions(side, s, false); });
  const auto central = both([](int side, double s) { return from_positions(side, s, true); });
  const Resolution halvings{"halvings", {2, 4, 6, 8, 10}};
  const std::string derivatives = "derivatives of each piece";
  const auto richardson = [=](auto f) {
    return [=](double n) { return limit_at_zero(f, h, static_cast<int>(n)); };
  };
  const Resolution distances{"distance", {h, h * 0x1p-5, h * 0x1p-10, h * 0x1p-15, h * 0x1p-20}};
  limits.add({derivatives, "value at a distance", distances,
              [=](double s) {
                return Answer{pieces(s), 1};
              },
              Outcome::inaccurate,
              filled("the acceleration is still @1 distances away",
                     {distance(pieces(h * 0x1p-20), limits.reference.value) / (h * 0x1p-20)})});
  limits.add({derivatives, "Richardson", halvings, richardson(pieces)});
  limits.add({"differences of positions, one side", "Richardson", halvings, richardson(one_sided)});
  limits.add({"differences of positions across 0", "Richardson", halvings, richardson(central),
              Outcome::deceived, R"(they see one normal, $(0,-1,1)/\sqrt2$, at every $h$)"});
  limits.add(Breakdown{
      R"(Central differences are the better ones inside a piece. Across the joint they give )"
      R"($(0,-1,1)/\sqrt2$ for the normal, half-way between $-\mathbf N$ before and $\mathbf N$ after, )"
      R"(however small the step.)",
      "differences of positions across 0, Richardson", 10, Outcome::deceived,
      "differences of positions, one side, Richardson", 10});
  return limits;
}

}  // namespace ex02_01

Exercise exercise_2_1() {
  using namespace ex02_01;
  return {"Curve that changes its plane",
          R"(The curve $\mathbf r(t)=(t,t^3,0)$ for $t<0$, $(t,0,t^3)$ for $t\ge0$: show that position, )"
          R"(velocity and acceleration are continuous at $t=0$, and that the normal $\mathbf N$ is not.)",
          parameters,
          {},
          [](const Parameters& p, const Reference&) {
            return Findings{claims(p["h"], p["seed"]), {one_sided_limits(p["h"])}};
          },
          proofs,
          Expected::in_whole_ranges};
}

}  // namespace oddity
