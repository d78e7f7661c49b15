// Exercise 2.7: a rigid sphere whose orientation is [r u r x u] along the curve r(t) on it, u = r'/|r'|: find
// the angular velocity w, Skew(w) = R' R^T.
//   w = r x r' + (r.(r' x r'')/|r'|^2) r          w = Unskew(r' r^T + u' u^T + (r x u')(r x u)^T)
// The text's formulas and its listing need r, r', r''. The other route differentiates the frame itself by
// dual numbers, or takes w from the formula on the left, which follows from r' = w x r and (r x u).u' = w.r
// alone. The scene carries the orientation along R' = Skew(w) R and compares with the frame.

#include <type_traits>

#include "chapters/02_basic_concepts/07_curve_on_sphere/curve_on_sphere.hpp"
#include "chapters/random.hpp"
#include "solvers/roots.hpp"

namespace oddity {

namespace ex02_07 {

using namespace curve_on_sphere;

constexpr Parameter parameters[] = {
    {"pace", 1, "1/s", "units of the curve's time a second", 0.1, 16},
    {"t", 0.75, "1", "time at which w is computed", -8, 8},
    {"T", 4, "s", "time until which the orientation is carried on from t = 0", 0.25, 64},
    {"seed", 1, "", "of the random times", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

struct Sample {
  double t;
  Motion<double> m = motion_of(position, t);
  Matrix3 R, R_dot;  ///< the frame and its derivative by dual numbers
  Vector3 u, b, u_dot, b_dot, w;
  double speed = length(m.v), pull = length(m.a);
  double size;  ///< of the terms in R'

  explicit Sample(double time) : t(time) {
    const Matrix<Dual<double>> both = frame(Dual<double>(t, 1));
    R = value_of(both), R_dot = slope_of(both);
    u = R.column(1), b = R.column(2), u_dot = R_dot.column(1), b_dot = R_dot.column(2);
    w = angular_velocity(m), size = 4 * (speed + pull / speed);
  }
  std::string where() const { return "t = " + shortest(t); }
};
using S = const Sample&;

/// The printed sum of three outer products, the last weighted.
Matrix3 outer_sum(S s, double k) {
  return outer(s.m.v, s.m.r) + outer(s.u_dot, s.u) + k * outer(cross(s.m.r, s.u_dot), s.b);
}

/// The listing's two functions, WFunction with the call mended.
using Vec = Vector3&;
void compute_terms(double t, Vec R, Vec V, Vec U, Vec UDot) {
  const Motion m = motion_of(position, t);
  R = m.r, V = m.v, U = V / length(V), UDot = listed_u_dot(m, false);
}
Vector3 w_function(double t) {
  Vector3 R, V, U, UDot;
  compute_terms(t, R, V, U, UDot);
  return listed_w({R, V, {}}, UDot);
}
template <class... Arguments>
Check callable(const char* arguments) {
  return {"ComputeTerms(" + std::string(arguments) + ") can be called",
          {"the text", 1},
          {"the declared function", std::is_invocable_v<decltype(compute_terms), Arguments...> ? 1.0 : 0.0},
          exact()};
}

/// The times at which the printed listing returns w: zeros of its error, by Brent's method, against the
/// numbers named.
Check right_at_seven_times() {
  const auto slope = [](double t) {
    const Motion m = motion_of(position, t);
    return dot(m.a, m.v);
  };
  const auto off = [](double t) { return distance(w_function(t), angular_velocity(motion_of(position, t))); };
  std::vector<double> zeros{-1, 0, 1};
  for (double side : {-1.0, 1.0})
    for (double t : {0.6, 1.2}) zeros.push_back(brent(slope, side * t, side * (t + 0.1), 1e-15).value);
  std::ranges::sort(zeros);
  std::vector<double> errors;
  for (double t : zeros) errors.push_back(off(t));
  return {"error of the printed listing at t = 0, 0.6851, 1, 1.2289 and their negatives",
          {"the listing's arithmetic", errors},
          {"0", std::vector<double>(zeros.size())},
          rounding(40),
          3};
}

/// The letters by which a sentence calls the position, the velocity and the acceleration.
Check letters(const std::vector<std::string>& names) {
  const std::vector<std::string> vectors{"r", "v", "a"};
  long other = 0;
  for (std::size_t i = 0; i < 3; ++i) other += names[i] != vectors[i];
  return never("names that are not the vector's letter, r, v or a", other, 3);
}

std::vector<Claim> claims(double seed) {
  Random random(seed);
  std::vector<Sample> all{Sample(0.5), Sample(0), Sample(1), Sample(-1), Sample(20), Sample(-1000)};
  for (int i = 0; i < 200; ++i) all.emplace_back(random.between(-3, 3));
  const std::string duals = "dual numbers", of_frame = "the frame by dual numbers",
                    route = "r x r' + kappa r";
  const auto u_dot = [&](const char* text, auto factor) {
    return reading(text, "u'", duals, all, [&](S s) {
      return Sides{(s.m.a - factor(s) * s.u) / s.speed, s.u_dot, s.size};
    });
  };
  const auto perpendicular = [&](const char* text, bool velocity) {
    return reading(text, "the part across r", duals, all, [&](S s) {
      const Vector3& x = velocity ? s.m.v : s.m.a;
      return Sides{x, cross(s.m.r, cross(x, s.m.r)), s.speed + s.pull};
    });
  };

  Claim listed_derivative{"2.7-listing_u_dot", 561, "the listing's UDot = (A - R.Dot(U) U)/length is u'"};
  listed_derivative.printed = reading("R.Dot(U)", "u'", duals, all, [](S s) {
    return Sides{listed_u_dot(s.m, false), s.u_dot, s.size};
  });
  listed_derivative.corrected = reading("A.Dot(U)", "u'", duals, all, [](S s) {
    return Sides{listed_u_dot(s.m, true), s.u_dot, s.size};
  });
  listed_derivative.why =
      "The formula above the listing takes the acceleration's component, $(\\ddot{\\mathbf "
      "r}\\cdot\\mathbf u)\\mathbf u$. The listing takes the position's, which is zero: its UDot is "
      "$\\ddot{\\mathbf r}/|\\dot{\\mathbf r}|$, not even perpendicular to $\\mathbf u$: at $t=0.75$ the two "
      "have the dot product $-0.72$. It should "
      "read `A.Dot(U)`.";

  listed_derivative.near_misses = {reading("A.Dot(R)", "u'", duals, all, [](S s) {
    return Sides{(s.m.a - dot(s.m.a, s.m.r) * s.u) / s.speed, s.u_dot, s.size};
  })};

  Claim call{"2.7-listing_call", 571, "WFunction can call ComputeTerms(t, R, V, A, U, UDot)"};
  call.printed = {"six arguments", {callable<double, Vec, Vec, Vec, Vec, Vec>("t, R, V, A, U, UDot")}};
  call.meant = {"five arguments", {callable<double, Vec, Vec, Vec, Vec>("t, R, V, U, UDot")}};
  call.why =
      "ComputeTerms is declared with five parameters, and WFunction has no A: the listing does not "
      "compile. Without the A it does.";
  call.near_misses = {{"four arguments", {callable<double, Vec, Vec, Vec>("t, R, V, U")}}};

  Claim name{"2.7-name_of_velocity", 537, "the functions needed are those of r, 'V ectorv' and a"};
  name.printed = {"r, V ectorv, a", {letters({"r", "V ectorv", "a"})}};
  name.meant = {"r, v, a", {letters({"r", "v", "a"})}};
  name.near_misses = {{"r, u, a", {letters({"r", "u", "a"})}}};
  name.why =
      "What looks like the name of a typesetting command, Vector, is printed before its letter: one of the "
      "three functions is that of the velocity $\\mathbf v=\\dot{\\mathbf r}$, VFunction in the listing.";

  Claim result{"2.7-listing_result", 585, "WFunction returns the angular velocity"};
  result.printed = reading("as printed", "W", route, all, [](S s) {
    return Sides{w_function(s.t), s.w, s.size};
  });
  result.corrected = reading("with A.Dot(U)", "W", route, all, [](S s) {
    return Sides{listed_w(s.m, listed_u_dot(s.m, true)), s.w, s.size};
  });
  result.corrected.checks.push_back(
      compare("W as printed", "the listing's arithmetic",
              "w + c (r_y r_z, -r_x r_z, r_x r_y), c = r''.u/|r'|", all, [](S s) {
                const auto [x, y, z] = s.m.r.e;
                const double c = dot(s.m.a, s.u) / s.speed;
                return Sides{w_function(s.t), s.w + c * Vector3{y * z, -x * z, x * y}, s.size};
              }));
  result.why =
      "The signs and the pairing of the components are right, but UDot is not (see 2.7-listing_u_dot). "
      "What it adds to $\\dot RR^T$ is symmetric, so that the three entries picked are no longer those of "
      "a skew matrix: the result is off by $c\\,(r_yr_z,-r_xr_z,r_xr_y)$, $c=\\ddot{\\mathbf "
      "r}\\cdot\\mathbf u/|\\dot{\\mathbf r}|$. At $t=0.75$ the listing gives $(0.9696,2.7156,4.8642)$, "
      "and $\\mathbf w=(1.2157,2.9617,4.7289)$. It is right at seven times only: where the speed is "
      "stationary, $c=0$ at $t=0$, $\\pm0.6851$ and $\\pm1.2289$, and at the pole, $\\mathbf r=\\mathbf k$ "
      "at "
      "$t=\\pm1$; between them it is off by up to 0.74.";
  result.corrected.checks.push_back(right_at_seven_times());
  result.near_misses = {reading("with A.Dot(U), and + for - in W.Z", "W", route, all, [](S s) {
    Vector3 W = listed_w(s.m, listed_u_dot(s.m, true));
    W[2] = -W[2];
    return Sides{W, s.w, s.size};
  })};

  const auto flat_and_height = [](double t) { return std::array{1 - t * t, t * t}; };
  const auto given = [=](S s, double power) {
    const auto [flat, height] = flat_and_height(s.t);
    const double turned = std::numbers::pi * s.t, polar = std::atan2(flat, height);
    const Vector3 on_sphere{std::sin(polar) * std::cos(turned), std::sin(polar) * std::sin(turned),
                            std::cos(polar)};
    const Vector3 r{flat * std::cos(turned), flat * std::sin(turned), height};
    return Sides{1 / std::pow(flat * flat + height * height, power) * r, on_sphere, 1 + std::abs(turned)};
  };
  const std::string by_angles = "the point at the angles atan2(1 - t^2, t^2) and pi t";
  return {
      lost_bar(
          formula("2.7-position", 481,
                  "the position is ((1 - t^2) cos(pi t), (1 - t^2) sin(pi t), t^2) by its length", "r",
                  by_angles, all, 0.5, 1, given),
          reading("times sqrt((1 - t^2)^2 + t^4)", "r", by_angles, all, [=](S s) { return given(s, -0.5); }),
          "The bar above the root is lost in the text at hand: the three numbers are divided by their "
          "length. Multiplied by it they leave the unit sphere, of which the next lines speak, at every "
          "$t$ but 0 and $\\pm1$: at $t=2$ they are 25 from the origin."),
      formula("2.7-on_the_sphere", 485, "|r| = 1 for all t", "|r|", "the unit sphere", all, 0.5, 1,
              [](S s, double k) {
                const double height = s.t * s.t, flat = 1 - height;
                return Sides{std::hypot(flat, height) / std::pow(flat * flat + height * height, k), 1};
              }),
      claim("2.7-velocity_perpendicular", 485, "r.r' = 0 for all t",
            perpendicular("r' has no part along r", true), {perpendicular("r'' has no part along r", false)}),
      formula("2.7-rotation", 485, "R = [r u r x u] is a rotation matrix", "R^T R, det R", "a rotation", all,
              1, -1,
              [](S s, double k) {
                const Vector3 u = s.m.v / s.speed;
                const Matrix3 R = Matrix3::columns(s.m.r, u, k * cross(s.m.r, u));
                return Sides{joined(transpose(R) * R, determinant(R)), joined(identity(), 1), 4};
              }),
      claim("2.7-skew_of_w", 493, "Skew(w) = R' R^T",
            reading("R' R^T", "Skew(w)", route, all,
                    [](S s) {
                      return Sides{s.R_dot * transpose(s.R), skew(s.w), s.size};
                    }),
            {reading("R^T R', which has w in the body's frame", "Skew(w)", route, all,
                     [](S s) {
                       return Sides{transpose(s.R) * s.R_dot, skew(s.w), s.size};
                     })}),
      formula("2.7-quotient_rule", 499, "u' = (|r'|^2 r'' - (r'.r'') r')/|r'|^3", "u'", duals, all, 1, -1,
              [](S s, double k) {
                const double v = s.speed;
                return Sides{(v * v * s.m.a - k * dot(s.m.v, s.m.a) * s.m.v) / (v * v * v), s.u_dot, s.size};
              }),
      claim("2.7-u_dot", 503, "u' = (r'' - (r''.u) u)/|r'|",
            u_dot("the acceleration's component", [](S s) { return dot(s.m.a, s.u); }),
            {u_dot("the position's component", [](S s) { return dot(s.m.r, s.u); }),
             u_dot("the velocity's component", [](S s) { return dot(s.m.v, s.u); })}),
      formula("2.7-product_rule", 509, "d(r x u)/dt = r' x u + r x u'", "(r x u)'", duals, all, 1, -1,
              [](S s, double k) {
                return Sides{cross(s.m.v, s.u) + k * cross(s.m.r, s.u_dot), s.b_dot, s.size};
              }),
      formula("2.7-parallel", 511, "r' x u = 0, they being parallel: d(r x u)/dt = r x u'",
              "r' x u, (r x u)'", "zero, dual numbers", all, 1, 0,
              [](S s, double k) {
                const Vector3 gone = cross(s.m.v, s.u), left = cross(s.m.r, s.u_dot);
                return Sides{k == 1 ? joined(gone, left) : joined(left, gone), joined(Vector3{}, s.b_dot),
                             s.size};
              }),
      formula("2.7-columns", 515, "R' = [r' u' r x u']", "R'", of_frame, all, 1, -1,
              [](S s, double k) {
                return Sides{Matrix3::columns(s.m.v, s.u_dot, k * cross(s.m.r, s.u_dot)), s.R_dot, s.size};
              }),
      formula("2.7-outer_products", 531, "R' R^T = r' r^T + u' u^T + (r x u')(r x u)^T", "R' R^T", of_frame,
              all, 1, 0,
              [](S s, double k) {
                return Sides{outer_sum(s, k), s.R_dot * transpose(s.R), s.size};
              }),
      formula("2.7-unskew_is_inverse", 533, "Unskew is the inverse of Skew", "Skew(Unskew(R' R^T))",
              "R' R^T, the frame by dual numbers", all, 1, -1,
              [](S s, double k) {
                const Matrix3 skewed = s.R_dot * transpose(s.R);
                return Sides{skew(k * unskew(skewed)), skewed, s.size};
              }),
      formula("2.7-angular_velocity", 535, "w = Unskew(r' r^T + u' u^T + (r x u')(r x u)^T)", "w", route, all,
              1, 0,
              [](S s, double k) {
                return Sides{unskew(outer_sum(s, k)), s.w, s.size};
              }),
      formula("2.7-only_r_v_a", 537, "functions for r, r' and r'' are all that w needs", "w", of_frame, all,
              1, 0,
              [](S s, double k) {
                return Sides{angular_velocity<double>({s.m.r, s.m.v, k * s.m.a}),
                             unskew(s.R_dot * transpose(s.R)), s.size};
              }),
      name,
      listed_derivative,
      call,
      formula("2.7-listing_signs", 579, "the listing picks w out of R' R^T with the signs -, +, -",
              "W, UDot being right", route, all, 1, -1,
              [](S s, double k) {
                const Vector3 W = listed_w(s.m, s.u_dot);
                return Sides{{W[0], k * W[1], W[2]}, s.w, s.size};
              }),
      result,
  };
}

Scene scene() {
  return {orientation,
          4,
          degree,
          "pace",
          {0.25, 0.5, 1, 2, 4, 8},
          {"pace"},
          {{"r_x", "u_x", "rxu_x", "r_y", "u_y", "rxu_y", "r_z", "u_z", "rxu_z"},
           "s",
           {{"rad", {0, 3, 6}}, {"rad", {1, 4, 7}}, {"rad", {2, 5, 8}}}},
          {{"chapters/02_basic_concepts/07_curve_on_sphere/models.hpp"},
           {{"frame", "curve_on_sphere::Frame<double>{{pace}}"},
            {"matrix", "curve_on_sphere::AsMatrix<double>{{{pace}}}"},
            {"quaternion", "curve_on_sphere::AsQuaternion<double>{{{pace}}}"},
            {"matrix, w of the printed listing", "curve_on_sphere::AsMatrix<double>{{{pace}, true}}"}},
           {{"matrix, orthonormalized", "which repairs the orientation after each step"},
            {"quaternion, normalized", "which repairs the orientation after each step"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Quantity carried = orientation(p, {p["T"]}, truth);
  return {claims(p["seed"]), {angular_velocity_at(p["t"], truth), carried, orthogonality(carried)}};
}

}  // namespace ex02_07

Exercise exercise_2_7() {
  using namespace ex02_07;
  return {"Orientation along a curve on a sphere",
          "A rigid sphere is turned so that a point of it follows $((1-t^2)\\cos\\pi t,(1-t^2)\\sin\\pi "
          "t,t^2)/\\sqrt{(1-t^2)^2+t^4}$: choose an orientation matrix and find the angular velocity.",
          parameters, scene(), study};
}

}  // namespace oddity
