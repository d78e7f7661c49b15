// Exercise 2.1: which of r, v, a, speed, T and N of r(t) = (t, t^3, 0) for t < 0, (t, 0, t^3) for t >= 0 pass
// continuously through t = 0?
// The formulas of the text are held against dual numbers, its limits against Richardson's extrapolation from
// a distance. N is T turned by a right angle in the plane of its piece (the book's (2.5)); the other route to
// it is the principal normal, along (v x a) x v [do Carmo, Differential Geometry of Curves and Surfaces,
// 1-5], which is -N before 0. A unit normal out of that plane need not jump [Bishop, Amer. Math. Monthly 82
// (1975) 246].

#include <numbers>

#include "chapters/02_basic_concepts/01_plane_change/plane_change.hpp"
#include "chapters/random.hpp"

namespace oddity {

namespace ex02_01 {

using namespace plane_change;
using std::numbers::sqrt2;

constexpr Parameter parameters[] = {
    {"h", 0.25, "1", "distance from t = 0 at which a numerical limit starts", 1e-3, 0.5},
    {"seed", 1, "", "of the random times", 0, 1e9, whole_number},
};

double root(double t) { return std::sqrt(1 + 9 * t * t * t * t); }

using S = const Sample&;

std::vector<Claim> claims(double h, double seed) {
  Random random(seed);
  std::vector<Sample> left{{-0.75}}, right{{0.75}}, all;
  for (int i = 0; i < 200; ++i) {
    const Sample s{random.magnitude(1e-3, 1e2)};
    (s.t < 0 ? left : right).push_back(s);
  }
  for (const auto& side : {left, right}) all.insert(all.end(), side.begin(), side.end());

  const auto r = [](int side, double t) { return local(side, t).r; };
  const auto v = [](int side, double t) { return local(side, t).v; };
  const auto a = [](int side, double t) { return local(side, t).a; };
  const auto N = [](int side, double t) { return local(side, t).N; };
  const auto text_T = [](S s, double k) {
    return Sides{1 / root(s.t) * in_plane(s.side(), 1.0, k * s.t * s.t), local(s).T};
  };
  const auto text_N = [](S s, double k) {
    const Local l = local(s);
    const Vector3 n = 1 / root(s.t) * in_plane(s.side(), -k * s.t * s.t, 1.0);
    const Vector3 principal = unit(cross(cross(l.v, l.a), l.v));
    return Sides{joined(n, length(n), dot(n, l.T)), joined(double(s.side()) * principal, 1, 0), 1};
  };

  // As the text at hand has them, the root a factor.
  const std::string lost =
      "The bar above the root is lost in the text at hand: the root divides. As it stands the vector is "
      "multiplied by it, and at $t=\\pm1$ its length is 10, not 1.";
  const auto product = [&](const char* text, bool normal, const std::vector<Sample>& samples) {
    return reading(text, normal ? "N" : "T", "dual numbers", samples, [=](S s) {
      const double t2 = 3 * s.t * s.t, d = root(s.t);
      const Local l = local(s);
      return normal ? Sides{d * in_plane(s.side(), -t2, 1.0), l.N}
                    : Sides{d * in_plane(s.side(), 1.0, t2), l.T};
    });
  };

  const auto tends = [&](const std::string& what, std::initializer_list<int> sides, const Vector3& to,
                         auto f) {
    Reading reading{what + " -> (" + shortest(to[0]) + ", " + shortest(to[1]) + ", " + shortest(to[2]) + ")",
                    {}};
    for (int side : sides)
      reading.checks.push_back(limit(what + (side < 0 ? " from below" : " from above"), to, h,
                                     [=](double s) { return f(side, side * s); }));
    return reading;
  };
  const auto evaluated = [&](double t) {
    Reading reading{"N at t = " + shortest(t), {}};
    for (int side : {before, after})
      reading.checks.push_back(limit("N", 1 / root(t) * in_plane(side, -3 * t * t, 1.0), h,
                                     [=](double s) { return N(side, side * s); }));
    return reading;
  };
  const auto jump = [&](double sign, double said) {
    return limit(sign > 0 ? "|N+ - N-|" : "|N+ + N-|", said, h,
                 [=](double s) { return length(N(after, s) - sign * N(before, -s)); });
  };
  const auto right_angle = [&](const char* text, auto normal_after) {
    const auto cosine = [=](double s) { return dot(normal_after(s), N(before, -s)); };
    return Reading{text, {limit("cosine of the normals at t and -t", 0, h, cosine)}};
  };
  const Vector3 zero{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  Claim velocity = formula("2.1-velocity", 69, "v = (1, 3t^2, 0) before 0 and (1, 0, 3t^2) from 0 on", "v",
                           "dual numbers", all, 3, 2, [](S s, double k) {
                             return Sides{in_plane(s.side(), 1.0, k * s.t * s.t), local(s).v};
                           });
  for (const Check& c : tends("(r(t) - r(0))/t", {before, after}, x, [=](int side, double t) {
                          return r(side, t) / t;
                        }).checks)
    velocity.printed.checks.push_back(c);
  Claim acceleration = formula("2.1-acceleration", 77, "a = (0, 6t, 0) before 0 and (0, 0, 6t) from 0 on",
                               "a", "dual numbers", all, 6, 3, [](S s, double k) {
                                 return Sides{in_plane(s.side(), 0.0, k * s.t), local(s).a};
                               });
  for (const Check& c : tends("(v(t) - v(0))/t", {before, after}, zero, [=](int side, double t) {
                          return (v(side, t) - x) / t;
                        }).checks)
    acceleration.printed.checks.push_back(c);

  return {
      velocity,
      acceleration,
      claim("2.1-position_from_below", 87, "r tends to 0 from below", tends("r", {before}, zero, r),
            {tends("r", {before}, 1e-6 * y, r)}),
      formula("2.1-polynomials", 103, "the components are polynomials (of degree 3), hence continuous", "r",
              "the cubic through four of its points", all, 4, 3,
              [](S s, double n) {
                return Sides{piece(s.side())(s.t), interpolated(s.side(), s.t, static_cast<int>(n)),
                             10 * (1 + std::abs(s.t * s.t * s.t))};
              }),
      claim("2.1-position_from_above", 105, "r tends to 0 from above", tends("r", {after}, zero, r),
            {tends("r", {after}, 1e-6 * z, r)}),
      claim("2.1-velocity_limit", 121, "v tends to (1, 0, 0) from both sides",
            tends("v", {before, after}, x, v), {tends("v", {before, after}, x + y, v)}),
      claim("2.1-acceleration_limit", 121, "a tends to 0 from both sides",
            tends("a", {before, after}, zero, a), {tends("a", {before, after}, 6.0 * y, a)}),
      formula("2.1-speed", 123, "the speed is sqrt(1 + 9t^4) on both sides", "|v|", "dual numbers", all, 9, 3,
              [](S s, double k) {
                return Sides{std::sqrt(1 + k * std::pow(s.t, 4)), local(s).speed};
              }),
      lost_bar(formula("2.1-tangent_before", 135, "T = (1, 3t^2, 0)/sqrt(1 + 9t^4) before 0", "T",
                       "v/|v| by dual numbers", left, 3, -3, text_T),
               product("T = (1, 3t^2, 0) sqrt(1 + 9t^4)", false, left), lost),
      lost_bar(
          formula("2.1-normal_before", 141, "N = (-3t^2, 1, 0)/sqrt(1 + 9t^4) is a unit normal before 0",
                  "N, |N|, N.T", "minus the principal normal by dual numbers, 1, 0", left, 3, -3, text_N),
          product("N = (-3t^2, 1, 0) sqrt(1 + 9t^4)", true, left), lost),
      claim("2.1-normal_from_below", 147, "N tends to (0, 1, 0) from below", tends("N", {before}, y, N),
            {tends("N", {before}, z, N), tends("N", {before}, -y, N)}),
      claim("2.1-normal_by_evaluation", 155, "the limits of N are its formulas' values at 0", evaluated(0),
            {evaluated(1e-3)}),
      lost_bar(formula("2.1-tangent_after", 161, "T = (1, 0, 3t^2)/sqrt(1 + 9t^4) from 0 on", "T",
                       "v/|v| by dual numbers", right, 3, -3, text_T),
               product("T = (1, 0, 3t^2) sqrt(1 + 9t^4)", false, right), lost),
      lost_bar(formula("2.1-normal_after", 167, "N = (-3t^2, 0, 1)/sqrt(1 + 9t^4) is a unit normal from 0 on",
                       "N, |N|, N.T", "the principal normal by dual numbers, 1, 0", right, 3, -3, text_N),
               product("N = (-3t^2, 0, 1) sqrt(1 + 9t^4)", true, right), lost),
      claim("2.1-normal_from_above", 173, "N tends to (0, 0, 1) from above", tends("N", {after}, z, N),
            {tends("N", {after}, y, N), tends("N", {after}, -z, N)}),
      claim("2.1-no_sign_helps", 181, "the two limits of N differ, and so do they with one sign changed",
            {"both jumps are sqrt(2)", {jump(1, sqrt2), jump(-1, sqrt2)}},
            {{"the limits are equal", {jump(1, 0)}}, {"they are opposite", {jump(-1, 0)}}}),
      claim("2.1-no_continuous_normal", 181, "no function for the curve's normal is continuous at 0",
            right_angle("the normal in the curve's own plane, of either sign: a right angle remains",
                        [=](double t) { return N(after, t); }),
            {right_angle("every unit vector perpendicular to T: but (0, 1, 0) continues N for t >= 0",
                         [=](double) { return y; })}),
  };
}

}  // namespace ex02_01

Exercise exercise_2_1() {
  using namespace ex02_01;
  return {"Curve that changes its plane",
          "The curve $\\mathbf r(t)=(t,t^3,0)$ for $t<0$, $(t,0,t^3)$ for $t\\ge0$: show that position, "
          "velocity and acceleration are continuous at $t=0$, and that the normal $\\mathbf N$ is not.",
          parameters,
          {},
          [](const Parameters& p, const Reference&) {
            return Findings{claims(p["h"], p["seed"]), {one_sided_limits(p["h"])}};
          }};
}

}  // namespace oddity
