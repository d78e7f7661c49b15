#pragma once

#include "chapters/03_rigid_body_motion/15_turning_rod/turning_rod.hpp"

/// The formulas of the book about the mass on the turning rod, each compared with what the Lagrangian gives.
namespace oddity::turning_rod {

using std::abs, std::cos, std::pow, std::sin, std::sqrt, std::numbers::pi, std::numbers::sqrt2;

inline constexpr double quarter = pi / 4;

using S = const Sample&;
using Versions = std::vector<Version<Sample>>;

inline Value sum(const Value& x, double by, const Value& y) {
  Value z = x;
  for (std::size_t i = 0; i < z.size(); ++i) z[i] += by * y[i];
  return z;
}
inline double dot(const std::array<double, 3>& x, const std::array<double, 3>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
inline double length(const std::array<double, 3>& x) { return sqrt(dot(x, x)); }

// What the text prints, letter by letter.
inline Value D(S s) { return values(cos(s.w * s.t) / sqrt2, sin(s.w * s.t) / sqrt2, 1 / sqrt2); }
inline Value D_rate(S s) { return values(-s.w * sin(s.w * s.t) / sqrt2, s.w * cos(s.w * s.t) / sqrt2, 0); }
inline double first_length(S s) { return sqrt((s.b - s.c) * (s.b - s.c) + s.b * s.b); }
inline double outer_length(S s) { return sqrt((s.b + s.c) * (s.b + s.c) + s.b * s.b); }
inline double second_length(S s) { return sqrt((s.b - s.c) * (s.b - s.c) + s.c * s.c); }
/// The generalized force, the projection of (c, 0, 0) on the rod being p; `power` is that of the root.
inline double F_lambda(S s, double p, int power = -1) {
  return -s.K * (1 - s.ell * pow(sqrt(s.s * s.s - 2 * p * s.s + s.c * s.c), power)) * (s.s - p);
}
inline double p(S s) { return s.c * cos(s.w * s.t) / sqrt2; }

/// Collects claims about formulas.
struct Formulas {
  double seed;
  std::vector<Claim> claims = {};
  Claim& add(const char* id, int line, const char* what, const Version<Sample>& printed,
             const Version<Sample>& truth, const Versions& near) {
    claims.push_back(formula_claim(std::string("3.15-") + id, line, what, seed, printed, truth, near));
    claims.back().says = std::string(what) + " is " + printed.text;
    return claims.back();
  }
  Reading reading(const Version<Sample>& version, const Version<Sample>& truth) const {
    return {version.text, {compare(claims.back().printed.checks[0].quantity, version, truth, seed)}};
  }
};

inline std::vector<Claim> geometry(double seed) {
  Formulas f{seed};
  f.add("angle", 1741, "the angle between the segment and the axis", {"pi/4", [](S) { return pi / 4; }},
        {"that of (a, 0, a)", [](S s) { return std::acos(s.a / std::hypot(s.a, s.a)); }},
        {{"pi/3", [](S) { return pi / 3; }}});
  f.add("initial_direction", 1741, "the initial direction",
        {"(1, 0, 1)/sqrt(2)", [](S) { return values(1 / sqrt2, 0, 1 / sqrt2); }},
        {"(a, 0, a) over its length",
         [](S s) { return values(s.a / std::hypot(s.a, s.a), 0, s.a / std::hypot(s.a, s.a)); }},
        {{"(1, 0, 1)", [](S) { return values(1, 0, 1); }}});
  f.add("towards", 1745, "the direction after a quarter turn",
        {"in the (x2, x3)-plane", [](S) { return values(0, 1 / sqrt2, 1 / sqrt2); }},
        {"Rodrigues", [](S) { return direction(pi / 2); }},
        {{"on the other side", [](S) { return values(0, -1 / sqrt2, 1 / sqrt2); }}});
  f.add("direction", 1747, "D(t)", {"(cos, sin, 1)/sqrt(2)", D},
        {"Rodrigues", [](S s) { return direction(s.w * s.t); }},
        {{"(cos, -sin, 1)/sqrt(2)", [](S s) { return values(D(s)[0], -D(s)[1], D(s)[2]); }}});
  f.add("lambda_start", 1755, "x(0), with lambda(0) = b L/a,",
        {"(b, 0, b)", [](S s) { return values(s.b, 0, s.b); }},
        {"lambda(0) D(0), L = |(a, 0, a)|",
         [](S s) { return position(s.b * std::hypot(s.a, s.a) / s.a, 0.0, s.w); }},
        {{"lambda(0) = b", [](S s) { return sum(values(0, 0, 0), s.b, direction(0.0)); }}});
  f.add("velocity", 1765, "x'",
        {"lambda' D + lambda D'", [](S s) { return sum(sum(values(0, 0, 0), s.v, D(s)), s.s, D_rate(s)); }},
        {"dual numbers", &Sample::velocity},
        {{"lambda' D", [](S s) { return sum(values(0, 0, 0), s.v, D(s)); }}});
  f.add("direction_rate", 1767, "D'", {"w (-sin, cos, 0)/sqrt(2)", D_rate},
        {"dual numbers", [](S s) { return velocity(1.0, 0.0, s.t, s.w); }},
        {{"w missing", [](S s) { return sum(values(0, 0, 0), 1 / s.w, D_rate(s)); }}});
  f.add("segment_length", 1919, "a",
        {"L/sqrt(2)",
         [](S s) {
           return length({s.a, 0, s.a}) / sqrt2;
         }},
        {"a, L being the length of (a, 0, a)", [](S s) { return s.a; }}, {{"L/2", [](S s) {
                                                                             return length({s.a, 0, s.a}) / 2;
                                                                           }}});
  return f.claims;
}

inline std::vector<Claim> dynamics(double seed) {
  Formulas f{seed};
  f.add("kinetic_energy", 1787, "T",
        {"(m/2) (w^2 lambda^2 / 2 + lambda'^2)",
         [](S s) { return s.m / 2 * (s.w * s.w * s.s * s.s / 2 + s.v * s.v); }},
        {"(m/2) |x'|^2 by dual numbers", [](S s) { return s.T()(s.s, s.v, s.t); }},
        {{"w^2 lambda^2 whole", [](S s) { return s.m / 2 * (s.w * s.w * s.s * s.s + s.v * s.v); }}});
  f.add("dT_dlambda", 1793, "the derivative of T by lambda",
        {"m w^2 lambda / 2", [](S s) { return s.m * s.w * s.w / 2 * s.s; }},
        {"dual numbers", [](S s) { return d_dq(s.T(), s.s, s.v, s.t); }},
        {{"m w^2 lambda", [](S s) { return s.m * s.w * s.w * s.s; }}});
  f.add("dT_dlambdadot", 1799, "the derivative of T by lambda'", {"m lambda'", [](S s) { return s.m * s.v; }},
        {"dual numbers", [](S s) { return d_dv(s.T(), s.s, s.v, s.t); }},
        {{"half of it", [](S s) { return s.m * s.v / 2; }}});
  f.add("momentum_rate", 1803, "the time derivative of dT/dlambda'",
        {"m lambda''", [](S s) { return s.m * s.A; }},
        {"nested dual numbers", [](S s) { return momentum_rate(s.T(), s.s, s.v, s.A, s.t); },
         [](S s) { return s.m * abs(s.w) * (abs(s.v) + abs(s.w) * s.s); }},
        {{"with a Coriolis term", [](S s) { return s.m * (s.A + s.w * s.v); }}});
  const Version<Sample> distance{"from (c, 0, 0) to (b, 0, b)", [](S s) {
                                   return length({s.b - s.c, 0, s.b});
                                 }};
  f.add("rest_length", 1817, "the rest length", {"sqrt((b-c)^2 + b^2)", first_length}, distance,
        {{"sqrt((b-c)^2 + c^2)", second_length}});
  const Version<Sample> force{"minus the gradient of the spring's energy, dual numbers",
                              [](S s) { return force_of(s.spring(), s.x()); }};
  const auto hooke = [](S s, double sign, double ell, int power = -1) {
    const double r = length({s.x()[0] - s.c, s.x()[1], s.x()[2]}), k = sign * s.K * (r - ell) * pow(r, power);
    return values(k * (s.x()[0] - s.c), k * s.x()[1], k * s.x()[2]);
  };
  f.add("force", 1821, "the force of the spring",
        {"-K (r - ell) (x - c i)/r", [=](S s) { return hooke(s, -1, s.ell); }}, force,
        {{"+K", [=](S s) { return hooke(s, 1, s.ell); }},
         {"ell missing", [=](S s) { return hooke(s, -1, 0); }}});
  bars_lost(
      f.claims.back(), "the force of the spring is -K (r - ell) (x - c i) r", seed,
      {"times r", [=](S s) { return hooke(s, -1, s.ell, 1); }}, force,
      "The fraction bar is lost in the text at hand: $(x-c\\imath)/|x-c\\imath|$ is a direction, of length "
      "1. Multiplied by its length the force is $r^2$ times as large: twice where the motion of the text "
      "ends, at $r=1.410$.");
  const Version<Sample> at_rest{"zero", [](S) { return values(0, 0, 0); },
                                [](S s) { return s.K * (s.b + s.c); }};
  const auto first_force = [](S s, double ell) {
    return force_of(Rod<double>{{s.m, s.c, s.K, s.w, s.s}, ell}, {s.b, 0, s.b});
  };
  f.add("unstretched", 1823, "the force at the start",
        {"with the rest length of line 1817", [=](S s) { return first_force(s, first_length(s)); }}, at_rest,
        {{"with the rest length of line 1869", [=](S s) { return first_force(s, second_length(s)); }}})
      .says = "the force at the start is zero";
  const Version<Sample> by_energy{"minus the spring's energy's derivative by lambda",
                                  [](S s) { return d_dq(s.L(), s.s, 0, s.t) - d_dq(s.T(), s.s, 0, s.t); }};
  f.add("generalized_force", 1829, "the generalized force",
        {"-K (1 - ell/sqrt(...)) (lambda - c cos(wt)/sqrt(2))", [](S s) { return F_lambda(s, p(s)); }},
        by_energy, {{"c cos(wt) for c cos(wt)/sqrt(2)", [](S s) { return F_lambda(s, sqrt2 * p(s)); }}});
  bars_lost(
      f.claims.back(), "the generalized force is -K (1 - ell sqrt(...)) (lambda - c cos(wt)/sqrt(2))", seed,
      {"1 - ell sqrt(...), as a product", [](S s) { return F_lambda(s, p(s), 1); }}, by_energy,
      "The bar under $\\ell$ is lost in the text at hand. The quotient is 1 where the spring is at rest, and "
      "the bracket 0; of the product the bracket is $1-\\ell^2$, and the mass of the listing starts with a "
      "push of 15 N that is not there.");
  f.add("equation", 1839, "the difference of the sides of the equation of motion",
        {"m lambda'' - m w^2 lambda / 2 - F",
         [](S s) { return s.m * s.A - s.m * s.w * s.w / 2 * s.s - F_lambda(s, p(s)); }},
        {"d/dt dL/dlambda' - dL/dlambda by nested dual numbers",
         [](S s) { return momentum_rate(s.L(), s.s, s.v, s.A, s.t) - d_dq(s.L(), s.s, s.v, s.t); }},
        {{"m w^2 lambda", [](S s) { return s.m * s.A - s.m * s.w * s.w * s.s - F_lambda(s, p(s)); }},
         {"no centrifugal term", [](S s) { return s.m * s.A - F_lambda(s, p(s)); }}});
  f.add(
      "lambda_dot", 1843, "lambda'",
      {"D . x'",
       [](S s) { return D(s)[0] * s.velocity()[0] + D(s)[1] * s.velocity()[1] + D(s)[2] * s.velocity()[2]; }},
      {"lambda'", [](S s) { return s.v; }},
      {{"L D . x'", [](S s) { return sqrt2 * s.a * dot(direction(s.w * s.t), s.velocity()); }}});
  return f.claims;
}

/// Formulas, most of them wrong as they stand.
inline std::vector<Claim> slips(double seed) {
  Formulas f{seed};
  const Version<Sample> distance{"from (c, 0, 0) to (b, 0, b)", [](S s) {
                                   return length({s.b - s.c, 0, s.b});
                                 }};
  Claim& again =
      f.add("rest_length_again", 1869, "the rest length in the summary",
            {"sqrt((b-c)^2 + c^2)", second_length}, distance, {{"sqrt((b+c)^2 + b^2)", outer_length}});
  again.meant = f.reading({"sqrt((b-c)^2 + b^2)", first_length}, distance);
  again.why =
      "Line 1817 has $\\sqrt{(b-c)^2+b^2}$, and the listing takes the distance itself. Whoever codes this "
      "summary "
      "starts with a stretched spring, and gets $\\lambda(2)=0.188$ for 0.994: the mass arrives 0.8 m too "
      "far down "
      "the segment.";

  const Version<Sample> start{"Rodrigues", [](S) { return direction(0.0); }};
  Claim& D0 = f.add("direction_again", 1845, "D(0) in the formula for lambda'(0)",
                    {"(a, 0, a)", [](S s) { return values(s.a, 0, s.a); }}, start,
                    {{"(1, 0, 1)/2", [](S) { return values(0.5, 0, 0.5); }}});
  D0.meant = f.reading({"(1, 0, 1)/sqrt(2)", [](S) { return values(1 / sqrt2, 0, 1 / sqrt2); }}, start);
  D0.why =
      "$D$ is a unit vector (1741), and $(a,0,a)$ has the length $L$, 4 in the listing. Multiplied by zero "
      "it "
      "does no harm; for a mass that is thrown along the segment $\\lambda'(0)$ would be four times too "
      "large.";

  const Version<Sample> moving{"dual numbers", [](S s) { return velocity(sqrt2 * s.b, 0.0, 0.0, quarter); }};
  Claim& rest = f.add("starts_at_rest", 1843, "x'(0)", {"(0, 0, 0)", [](S) { return values(0, 0, 0); }},
                      moving, {{"(0, -pi b/4, 0)", [](S s) { return values(0, -pi * s.b / 4, 0); }}});
  rest.corrected = f.reading({"(0, pi b/4, 0)", [](S s) { return values(0, pi * s.b / 4, 0); }}, moving);
  rest.why =
      "The segment turns at a constant speed from the start and takes the mass along: by the text's own "
      "formula (1765) $x'(0)=\\lambda(0)D'(0)=(0,\\pi b/4,0)$, 1.11 m/s. The mass is at rest on the "
      "segment only, and that is what $\\lambda'(0)=0$ says.";

  const Version<Sample> resting{
      "D(0) . x'(0) by Rodrigues and dual numbers, at rest on the segment",
      [](S s) { return dot(direction(0.0), velocity(sqrt2 * s.b, 0.0, 0.0, quarter)); },
      [](S s) { return pi * s.b / 4; }};
  f.add("lambda_dot_start", 1845, "lambda'(0)",
        {"(a, 0, a) . (0, 0, 0)",
         [](S s) {
           return dot({s.a, 0, s.a}, {0, 0, 0});
         }},
        resting, {{"the speed |x'(0)|", [](S s) { return pi * s.b / 4; }}});

  const Version<Sample> lagrange{
      "Lagrange's equation by nested dual numbers, w = pi/4", [](S s) {
        return lagrange_acceleration(Lagrangian{s.m, quarter, s.spring()}, s.s, s.v, s.t);
      }};
  const auto summary = [](S s, double square, int power = -1) {
    const double cosine = cos(pi * s.t / 4);
    const double r = sqrt(s.s * s.s - 2 * s.s * cosine * s.c / sqrt2 + s.c * s.c);
    return square / 32 * s.s - s.K / s.m * (1 - s.ell * pow(r, power)) * (s.s - cosine * s.c / sqrt2);
  };
  f.add("summary", 1853, "lambda''",
        {"pi^2 lambda/32 - (K/m) (1 - ell/sqrt(...)) (...)", [=](S s) { return summary(s, pi * pi); }},
        lagrange, {{"pi^2 lambda/16", [=](S s) { return summary(s, 2 * pi * pi); }}});
  bars_lost(
      f.claims.back(), "lambda'' is pi^2 lambda/32 - (K/m) (1 - ell sqrt(...)) (...)", seed,
      {"1 - ell sqrt(...), as a product", [=](S s) { return summary(s, pi * pi, 1); }}, lagrange,
      "The bar under $\\ell$ is lost in the text at hand, as in the generalized force above. Besides, the "
      "$\\sqrt2$ inside the root is printed as the word sqrt.");

  const Version<Sample> tmp0{"c cos(pi t/4)/sqrt(2)", [](S s) { return s.c * cos(pi * s.t / 4) / sqrt2; }};
  const auto code = [](S s, double factor) { return s.c * sqrt(0.5) * cos(factor * s.t); };
  Claim& cosine =
      f.add("listing_cosine", 2079, "tmp0 of the listing",
            {"Cos(aux[0]*time), aux[0] = 1/sqrt(2)", [=](S s) { return code(s, sqrt(0.5)); }}, tmp0,
            {{"Cos(aux[2]*time), aux[2] = pi^2/32", [=](S s) { return code(s, pi * pi / 32); }}});
  cosine.says = "tmp0, which is aux[3]*Cos(aux[0]*time), is c cos(pi t/4)/sqrt(2)";
  cosine.corrected =
      f.reading({"Cos(aux[1]*time), aux[1] = pi/4", [=](S s) { return code(s, 0.25 * pi); }}, tmp0);
  cosine.why =
      "The code takes `aux[0]`, which is $1/\\sqrt2$, for `aux[1]`, which is $\\pi/4$: in its equation of "
      "motion the spring sees the rod turn by 81 degrees, while the positions that it prints turn by 90.";

  const Version<Sample> square{"r^2", [](S s) {
                                 const double r = length({s.x()[0] - s.c, s.x()[1], s.x()[2]});
                                 return r * r;
                               }};
  Claim& root =
      f.add("comment_root", 2093, "r^2 in the comment on tmp4",
            {"lambda (lambda - 2p + c^2)", [](S s) { return s.s * (s.s - 2 * p(s) + s.c * s.c); }}, square,
            {{"lambda (lambda - p) + c^2", [](S s) { return s.s * (s.s - p(s)) + s.c * s.c; }}});
  root.meant = f.reading(
      {"lambda (lambda - 2p) + c^2", [](S s) { return s.s * (s.s - 2 * p(s)) + s.c * s.c; }}, square);
  root.why =
      "A parenthesis closes too late: read so, $r^2$ at the start would be 3.17, not 2.17, as $c=1$ and "
      "$\\lambda=2$ have it. The code below is right.";
  return f.claims;
}

}  // namespace oddity::turning_rod
