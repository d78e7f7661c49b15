// The claims of exercise 2.7: the text's formulas and its listing, against the frame differentiated by dual
// numbers and against w = r x r' + (r.(r' x r'')/|r'|^2) r.

#include "chapters/claims.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "chapters/02_basic_concepts/07_curve_on_sphere/curve_on_sphere.hpp"
#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "reference/text.hpp"
#include "solvers/roots.hpp"

namespace oddity::curve_on_sphere {

namespace {

using space::Vector3, space::Matrix3, space::identity, limits::joined;

struct Sample {
  double t;
  Motion<double> m = space::motion_of(position, t);
  Matrix3 R, R_dot;  ///< the frame and its derivative by dual numbers
  Vector3 u, b, u_dot, b_dot, w;
  double speed = length(m.v);

  explicit Sample(double time) : t(time) {
    const Matrix<Dual<double>> both = frame(Dual<double>(t, 1));
    R = value_of(both), R_dot = slope_of(both);
    u = R.column(1), b = R.column(2), u_dot = R_dot.column(1), b_dot = R_dot.column(2);
    w = angular_velocity(m);
  }
  std::string where() const { return "$t$ = " + format_shortest(t); }
};
using AtTime = Formula<Sample>;

const AtTime u_dot_by_duals{"dual numbers", [](const Sample& s) { return Value(s.u_dot); }};
const AtTime w_by_frame{
    R"($\mathbf r\times\dot{\mathbf r}+(\mathbf r\cdot(\dot{\mathbf r}\times\ddot{\mathbf r})/)"
    R"(|\dot{\mathbf r}|^2)\,\mathbf r$)",
    [](const Sample& s) { return Value(s.w); }};

void curve_and_frame(Claims& claims, const std::vector<Sample>& all) {
  const auto given = [](double power) {
    return [=](const Sample& s) {
      const double height = s.t * s.t, flat = 1 - height, turn = std::numbers::pi * s.t;
      const Vector3 r{flat * cos(turn), flat * sin(turn), height};
      return Value(pow(flat * flat + height * height, power) * r);
    };
  };
  claims.formula(
      "position", 481,
      R"(the position is $((1-t^2)\cos\pi t,(1-t^2)\sin\pi t,t^2)$ times $\sqrt{(1-t^2)^2+t^4}$)", all,
      {.quantity = R"($\mathbf r$)",
       .truth = {R"(the point at the angles atan2 of $1-t^2$ and $t^2$, and $\pi t$)",
                 [](const Sample& s) {
                   const double turn = std::numbers::pi * s.t, polar = std::atan2(1 - s.t * s.t, s.t * s.t);
                   return Value{sin(polar) * cos(turn), sin(polar) * sin(turn), cos(polar)};
                 },
                 [](const Sample& s) { return std::numbers::pi * std::abs(s.t); }},
       .printed = {R"(times $\sqrt{(1-t^2)^2+t^4}$)", given(0.5)},
       .meant = {R"(over $\sqrt{(1-t^2)^2+t^4}$)", given(-0.5)},
       .near_misses = {{R"(over $(1-t^2)^2+t^4$)", given(-1)}},
       .kind = Fault::lost_typography,
       .why =
           R"(The bar above the root is lost in the text at hand: the three numbers are divided by their length. )"
           R"(Multiplied by it they leave the unit sphere, of which the next lines speak, at every $t$ but 0 and )"
           R"($\pm1$: at $t=2$ they are 25 from the origin.)"});
  const auto size = [=](double power) {
    return [=](const Sample& s) {
      const Value r = given(power)(s);
      return hypot(r[0], r[1], r[2]);
    };
  };
  claims.formula("on_the_sphere", 485, R"($|\mathbf r|=1$ for all $t$)", all,
                 {.quantity = R"($|\mathbf r|$)",
                  .truth = {"the unit sphere", [](const Sample&) { return 1.0; }},
                  .printed = {R"(the numbers over their length)", size(-0.5)},
                  .near_misses = {{R"(the numbers over its square)", size(-1)}}});
  const auto across = [&](const std::string& text, const std::string& what, Vector3 Motion<double>::*of) {
    return Reading{text,
                   {compare(what, {"as it is", [=](const Sample& s) { return Value(s.m.*of); }},
                            {R"(its part across $\mathbf r$)",
                             [=](const Sample& s) { return Value(cross(s.m.r, cross(s.m.*of, s.m.r))); }},
                            all)}};
  };
  claims.add("velocity_perpendicular", 485, R"($\mathbf r\cdot\dot{\mathbf r}=0$ for all $t$)",
             {.printed = across(R"($\dot{\mathbf r}$ has no part along $\mathbf r$)", R"($\dot{\mathbf r}$)",
                                &Motion<double>::v),
              .near_misses = {across(R"($\ddot{\mathbf r}$ has no part along $\mathbf r$)",
                                     R"($\ddot{\mathbf r}$)", &Motion<double>::a)}});
  const auto rotation = [](double sign) {
    return [=](const Sample& s) {
      const Vector3 u = s.m.v / s.speed;
      const Matrix3 R = Matrix3::columns(s.m.r, u, sign * cross(s.m.r, u));
      return joined(transpose(R) * R, determinant(R));
    };
  };
  claims.formula("rotation", 485,
                 R"($R=[\mathbf r\ \mathbf u\ \mathbf r\times\mathbf u]$ is a rotation matrix)", all,
                 {.quantity = R"($R^TR$ and $\det R$)",
                  .truth = {"the unit matrix and 1", [](const Sample&) { return joined(identity(), 1); }},
                  .printed = {R"($[\mathbf r\ \mathbf u\ \mathbf r\times\mathbf u]$)", rotation(1)},
                  .near_misses = {{R"($[\mathbf r\ \mathbf u\ \mathbf u\times\mathbf r]$)", rotation(-1)}}});
  claims.formula(
      "skew_of_w", 493, R"($\mathrm{Skew}(\mathbf w)=\dot RR^T$)", all,
      {.truth = {R"(Skew of )" + w_by_frame.text, [](const Sample& s) { return Value(skew(s.w)); }},
       .printed = {R"($\dot RR^T$)", [](const Sample& s) { return Value(s.R_dot * transpose(s.R)); }},
       .near_misses = {{R"($R^T\dot R$, which has $\mathbf w$ in the body's frame)",
                        [](const Sample& s) { return Value(transpose(s.R) * s.R_dot); }}}});
}

void derivative_of_frame(Claims& claims, const std::vector<Sample>& all) {
  const auto quotient = [](double sign) {
    return [=](const Sample& s) {
      const double v = s.speed;
      return Value((v * v * s.m.a - sign * dot(s.m.v, s.m.a) * s.m.v) / (v * v * v));
    };
  };
  claims.formula(
      "quotient_rule", 499,
      R"($\dot{\mathbf u}=(|\dot{\mathbf r}|^2\ddot{\mathbf r}-(\dot{\mathbf r}\cdot\ddot{\mathbf r})\dot{\mathbf r})/|\dot{\mathbf r}|^3$)",
      all,
      {.quantity = R"($\dot{\mathbf u}$)",
       .truth = u_dot_by_duals,
       .printed = {"the quotient", quotient(1)},
       .near_misses = {
           {R"(the quotient with $+(\dot{\mathbf r}\cdot\ddot{\mathbf r})\dot{\mathbf r}$)", quotient(-1)}}});
  const auto without = [](Vector3 Motion<double>::*of) {
    return [=](const Sample& s) { return Value((s.m.a - dot(s.m.*of, s.u) * s.u) / s.speed); };
  };
  claims.formula(
      "u_dot", 503,
      R"($\dot{\mathbf u}=(\ddot{\mathbf r}-(\ddot{\mathbf r}\cdot\mathbf u)\mathbf u)/|\dot{\mathbf r}|$)",
      all,
      {.quantity = R"($\dot{\mathbf u}$)",
       .truth = u_dot_by_duals,
       .printed = {"with the acceleration's component", without(&Motion<double>::a)},
       .near_misses = {{"with the position's component", without(&Motion<double>::r)},
                       {"with the velocity's component", without(&Motion<double>::v)}}});
  const auto product = [](double sign) {
    return [=](const Sample& s) { return Value(cross(s.m.v, s.u) + sign * cross(s.m.r, s.u_dot)); };
  };
  claims.formula(
      "product_rule", 509,
      R"($\frac{d}{dt}(\mathbf r\times\mathbf u)=\dot{\mathbf r}\times\mathbf u+\mathbf r\times\dot{\mathbf u}$)",
      all,
      {.truth = {"dual numbers", [](const Sample& s) { return Value(s.b_dot); }},
       .printed = {R"($\dot{\mathbf r}\times\mathbf u+\mathbf r\times\dot{\mathbf u}$)", product(1)},
       .near_misses = {{R"($\dot{\mathbf r}\times\mathbf u-\mathbf r\times\dot{\mathbf u}$)", product(-1)}}});
  claims.formula(
      "parallel", 511,
      R"($\dot{\mathbf r}\times\mathbf u=0$, they being parallel: $\frac{d}{dt}(\mathbf r\times\mathbf u)=\mathbf r\times\dot{\mathbf u}$)",
      all,
      {.quantity = R"($\dot{\mathbf r}\times\mathbf u$ and $\frac{d}{dt}(\mathbf r\times\mathbf u)$)",
       .truth = {"zero, and dual numbers", [](const Sample& s) { return joined(Vector3{}, s.b_dot); }},
       .printed = {R"($\dot{\mathbf r}\times\mathbf u$ and $\mathbf r\times\dot{\mathbf u}$)",
                   [](const Sample& s) { return joined(cross(s.m.v, s.u), cross(s.m.r, s.u_dot)); }},
       .near_misses = {{R"($\mathbf r\times\dot{\mathbf u}$ and $\dot{\mathbf r}\times\mathbf u$)",
                        [](const Sample& s) { return joined(cross(s.m.r, s.u_dot), cross(s.m.v, s.u)); }}}});
  const auto columns = [](double sign) {
    return [=](const Sample& s) {
      return Value(Matrix3::columns(s.m.v, s.u_dot, sign * cross(s.m.r, s.u_dot)));
    };
  };
  claims.formula(
      "columns", 515, R"($\dot R=[\dot{\mathbf r}\ \dot{\mathbf u}\ \mathbf r\times\dot{\mathbf u}]$)", all,
      {.quantity = R"($\dot R$)",
       .truth = {"the frame by dual numbers", [](const Sample& s) { return Value(s.R_dot); }},
       .printed = {R"($[\dot{\mathbf r}\ \dot{\mathbf u}\ \mathbf r\times\dot{\mathbf u}]$)", columns(1)},
       .near_misses = {
           {R"($[\dot{\mathbf r}\ \dot{\mathbf u}\ \dot{\mathbf u}\times\mathbf r]$)", columns(-1)}}});

  const AtTime product_of_frames{R"($\dot RR^T$, the frame by dual numbers)",
                                 [](const Sample& s) { return Value(s.R_dot * transpose(s.R)); }};
  const auto sum = [](const Sample& s, double last) {
    return outer(s.m.v, s.m.r) + outer(s.u_dot, s.u) + last * outer(cross(s.m.r, s.u_dot), s.b);
  };
  const std::string products =
      R"(\dot{\mathbf r}\mathbf r^T+\dot{\mathbf u}\mathbf u^T+(\mathbf r\times\dot{\mathbf u})(\mathbf r\times\mathbf u)^T)";
  claims.formula(
      "outer_products", 531, R"($\dot RR^T=)" + products + "$", all,
      {.quantity = R"($\dot RR^T$)",
       .truth = product_of_frames,
       .printed = {"the sum of the three products", [=](const Sample& s) { return Value(sum(s, 1)); }},
       .near_misses = {{"the first two products", [=](const Sample& s) { return Value(sum(s, 0)); }}}});
  const auto inverse = [](double sign) {
    return [=](const Sample& s) { return Value(skew(sign * unskew(s.R_dot * transpose(s.R)))); };
  };
  claims.formula("unskew_is_inverse", 533, "Unskew is the inverse of Skew", all,
                 {.quantity = R"($\dot RR^T$)",
                  .truth = product_of_frames,
                  .printed = {R"($\mathrm{Skew}(\mathrm{Unskew}(\dot RR^T))$)", inverse(1)},
                  .near_misses = {{R"($\mathrm{Skew}(-\mathrm{Unskew}(\dot RR^T))$)", inverse(-1)}}});
  claims.formula(
      "angular_velocity", 535, R"($\mathbf w=\mathrm{Unskew}()" + products + ")$", all,
      {.quantity = R"($\mathbf w$)",
       .truth = w_by_frame,
       .printed = {"Unskew of the three products", [=](const Sample& s) { return Value(unskew(sum(s, 1))); }},
       .near_misses = {
           {"Unskew of the first two", [=](const Sample& s) { return Value(unskew(sum(s, 0))); }}}});
  const auto from = [](double share) {
    return [=](const Sample& s) { return Value(angular_velocity<double>({s.m.r, s.m.v, share * s.m.a})); };
  };
  claims.formula(
      "only_r_v_a", 537,
      R"(functions for $\mathbf r$, $\dot{\mathbf r}$ and $\ddot{\mathbf r}$ are all that $\mathbf w$ needs)",
      all,
      {.quantity = R"($\mathbf w$)",
       .truth = {R"($\mathrm{Unskew}(\dot RR^T)$, the frame by dual numbers)",
                 [](const Sample& s) { return Value(unskew(s.R_dot * transpose(s.R))); }},
       .printed = {"from the three", from(1)},
       .near_misses = {{R"(from $\mathbf r$ and $\dot{\mathbf r}$ alone)", from(0)}}});
}

// ---- the listing ------------------------------------------------------------------------------------------

/// The listing's two functions, WFunction with the call mended.
void compute_terms(double t, Vector3& R, Vector3& V, Vector3& U, Vector3& UDot) {
  const auto m = space::motion_of(position, t);
  R = m.r, V = m.v, U = V / length(V), UDot = listed_u_dot(m, false);
}
Vector3 w_function(double t) {
  Vector3 R, V, U, UDot;
  compute_terms(t, R, V, U, UDot);
  return listed_w<double>({R, V, {}}, UDot);
}
template <class... Arguments>
Reading callable(const std::string& text, const std::string& arguments) {
  return {text,
          {{"`ComputeTerms(" + arguments + ")` can be called",
            {"the text", 1},
            {"the declared function", std::is_invocable_v<decltype(compute_terms), Arguments...> ? 1.0 : 0.0},
            exact()}}};
}

/// The times at which the printed listing returns w: zeros of its error, by Brent's method, against the
/// numbers named.
Check right_at_seven_times() {
  const auto slope = [](double t) {
    const auto m = space::motion_of(position, t);
    return dot(m.a, m.v);
  };
  std::vector<double> zeros{-1, 0, 1}, errors;
  for (double side : {-1.0, 1.0})
    for (double t : {0.6, 1.2}) zeros.push_back(brent(slope, side * t, side * (t + 0.1), 1e-15).value);
  std::ranges::sort(zeros);
  for (double t : zeros)
    errors.push_back(distance(w_function(t), angular_velocity(space::motion_of(position, t))));
  return {R"(error of the printed listing at $t=0,0.6851,1,1.2289$ and their negatives)",
          {"the listing's arithmetic", errors},
          {"zero", std::vector<double>(zeros.size())},
          rounding(40),
          3};
}

/// The letters by which a sentence calls the position, the velocity and the acceleration.
Reading letters(const std::string& text, const std::vector<std::string>& names) {
  const std::vector<std::string> vectors{"r", "v", "a"};
  long other = 0;
  for (std::size_t i = 0; i < 3; ++i) other += names[i] != vectors[i];
  return {text,
          {no_violations(R"(names that are not the vector's letter, $\mathbf r$, $\mathbf v$ or $\mathbf a$)",
                         other, 3)}};
}

void listing(Claims& claims, const std::vector<Sample>& all) {
  claims.add(
      "name_of_velocity", 537, R"(the functions needed are those of $\mathbf r$, 'V ectorv' and $\mathbf a$)",
      {.printed = letters(R"($\mathbf r$, V ectorv, $\mathbf a$)", {"r", "V ectorv", "a"}),
       .meant = letters(R"($\mathbf r$, $\mathbf v$, $\mathbf a$)", {"r", "v", "a"}),
       .near_misses = {letters(R"($\mathbf r$, $\mathbf u$, $\mathbf a$)", {"r", "u", "a"})},
       .why =
           R"(What looks like the name of a typesetting command, Vector, is printed before its letter: one )"
           R"(of the three functions is that of the velocity $\mathbf v=\dot{\mathbf r}$, `VFunction` in the )"
           R"(listing.)",
       .kind = Fault::lost_typography});
  const auto u_dot = [](bool mended) {
    return [=](const Sample& s) { return Value(listed_u_dot(s.m, mended)); };
  };
  claims.formula(
      "listing_u_dot", 561, R"(the listing's `UDot = (A - R.Dot(U)*U)/length` is $\dot{\mathbf u}$)", all,
      {.quantity = R"($\dot{\mathbf u}$)",
       .truth = u_dot_by_duals,
       .printed = {"with `R.Dot(U)`", u_dot(false)},
       .corrected = {"with `A.Dot(U)`", u_dot(true)},
       .near_misses = {{"with `A.Dot(R)`",
                        [](const Sample& s) { return Value((s.m.a - dot(s.m.a, s.m.r) * s.u) / s.speed); }}},
       .kind = Fault::listing,
       .root = "R.Dot(U) for A.Dot(U)",
       .why =
           R"(The formula above the listing takes the acceleration's component, )"
           R"($(\ddot{\mathbf r}\cdot\mathbf u)\mathbf u$. The listing takes the position's, which is zero: its )"
           R"(`UDot` is $\ddot{\mathbf r}/|\dot{\mathbf r}|$, not even perpendicular to $\mathbf u$: at $t=0.75$ the )"
           R"(two have the dot product $-0.72$. It should read `A.Dot(U)`.)"});
  using Out = Vector3&;
  claims.add(
      "listing_call", 571, "`WFunction` can call `ComputeTerms(t, R, V, A, U, UDot)`",
      {.printed = callable<double, Out, Out, Out, Out, Out>("six arguments", "t, R, V, A, U, UDot"),
       .meant = callable<double, Out, Out, Out, Out>("five arguments", "t, R, V, U, UDot"),
       .near_misses = {callable<double, Out, Out, Out>("four arguments", "t, R, V, U")},
       .why = "`ComputeTerms` is declared with five parameters, and `WFunction` has no `A`: the listing does "
              "not compile. Without the `A` it does.",
       .kind = Fault::listing});
  const auto signs = [](double middle) {
    return [=](const Sample& s) {
      const Vector3 W = listed_w(s.m, s.u_dot);
      return Value{W[0], middle * W[1], W[2]};
    };
  };
  claims.formula("listing_signs", 579,
                 R"(the listing picks $\mathbf w$ out of $\dot RR^T$ with the signs $-$, $+$, $-$)", all,
                 {.quantity = R"(`W` for the right `UDot`)",
                  .truth = w_by_frame,
                  .printed = {R"($-$, $+$, $-$)", signs(1)},
                  .near_misses = {{R"($-$, $-$, $-$)", signs(-1)}}});
  const AtTime listed{"`W` as printed", [](const Sample& s) { return Value(w_function(s.t)); }};
  const auto mended = [](double last) {
    return [=](const Sample& s) {
      const Vector3 W = listed_w(s.m, listed_u_dot(s.m, true));
      return Value{W[0], W[1], last * W[2]};
    };
  };
  const auto read = [&](const std::string& text, const AtTime& formula) {
    return Reading{text, {compare("`W`", formula, w_by_frame, all)}};
  };
  Reading corrected = read("with `A.Dot(U)`", {"`W` with `A.Dot(U)`", mended(1)});
  corrected.checks.push_back(compare(
      "`W` as printed", listed,
      {R"($\mathbf w+c\,(r_yr_z,-r_xr_z,r_xr_y)$, $c=\ddot{\mathbf r}\cdot\mathbf u/|\dot{\mathbf r}|$)",
       [](const Sample& s) {
         const auto [x, y, z] = s.m.r.e;
         return Value(s.w + dot(s.m.a, s.u) / s.speed * Vector3{y * z, -x * z, x * y});
       }},
      all));
  corrected.checks.push_back(right_at_seven_times());
  claims.add(
      "listing_result", 585, "`WFunction` returns the angular velocity",
      {.printed = read("as printed", listed),
       .corrected = corrected,
       .near_misses = {read("with `A.Dot(U)`, and + for - in `W.Z`",
                            {"`W` with another sign in `W.Z`", mended(-1)})},
       .why =
           R"(The signs and the pairing of the components are right, but `UDot` is not (see `2.7-listing_u_dot`). )"
           R"(What it adds to $\dot RR^T$ is symmetric, so that the three entries picked are no longer those of a skew )"
           R"(matrix: the result is off by $c\,(r_yr_z,-r_xr_z,r_xr_y)$, )"
           R"($c=\ddot{\mathbf r}\cdot\mathbf u/|\dot{\mathbf r}|$. At $t=0.75$ the listing gives )"
           R"($(0.9696,2.7156,4.8642)$, and $\mathbf w=(1.2157,2.9617,4.7289)$. It is right at seven times only: )"
           R"(where the speed is stationary, $c=0$ at $t=0$, $\pm0.6851$ and $\pm1.2289$, and at the pole, )"
           R"($\mathbf r=\mathbf k$ at $t=\pm1$; between them it is off by up to 0.74.)",
       .kind = Fault::listing,
       .root = "R.Dot(U) for A.Dot(U)"});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Random random(seed);
  std::vector<Sample> all{Sample(0.5), Sample(0), Sample(1), Sample(-1), Sample(20), Sample(-1000)};
  for (int i = 0; i < 200; ++i) all.emplace_back(random.between(-3, 3));
  Claims claims("2.7");
  curve_and_frame(claims, all);
  derivative_of_frame(claims, all);
  listing(claims, all);
  return claims.in_order();
}

std::vector<Root> roots() {
  return {
      {"R.Dot(U) for A.Dot(U)",
       R"(A sphere turned by the listing leaves its curve: at $t=0.75$ the velocity is off by 0.37 in 5.71, )"
       R"(nearly four degrees for every radian that the sphere turns.)"}};
}

}  // namespace oddity::curve_on_sphere
