// Exercise 5.3: div (x / |x|^3) = 0 away from the origin.
// Left side: the field is differentiated as it stands, x over the cube of sqrt(x.x), by dual numbers along a
// frame turned at random. Right side: the published quotients of powers of x.x. Sizes of x run over a hundred
// orders of magnitude. What happens at the origin shows in the flux through closed surfaces.

#include <numbers>

#include "chapters/05_fluids_and_gases/03_inverse_square_field/flux.hpp"
#include "chapters/05_fluids_and_gases/03_inverse_square_field/inverse_square.hpp"
#include "reference/bad_input.hpp"

namespace oddity {

namespace ex05_03 {

using namespace fields;

constexpr Parameter parameters[] = {
    {"x0", 0.3, "m", "where the divergence is taken", -2, 2},
    {"x1", -0.7, "m", "where the divergence is taken", -2, 2},
    {"x2", 0.9, "m", "where the divergence is taken", -2, 2},
    {"R", 1.5, "m", "radius of the sphere", 0.5, 10},
    {"a", 1, "m", "equatorial semi-axis of the spheroids", 0.1, 10},
    {"b", 2, "m", "polar semi-axis of the spheroids", 0.1, 10},
    {"inside", 0.25, "", "centre of the sphere and the spheroid around the origin, in radii or b", 0, 0.9},
    {"outside", 1.5, "", "centre of the spheroid that does not enclose the origin, in b", 1.1, 10},
    {"close", 0.9921875, "", "centre of the spheroid whose pole is close to the origin, in b", 0.9, 0.998},
    {"h", 1, "m", "half side of the cube", 0.1, 10},
    {"seed", 5, "", "of the random points of the claims", 0, 9e15, whole_number},
};

// ---- the published formulas
// ---------------------------------------------------------------------------------

/// The three derivatives that are summed: by x0 of x_i / |x|^3, by x1 of x_1 / |x|^3, by x2 of x_2 / |x|^3.
Check summands(std::size_t i, Random random) {
  Worst worst("the derivatives that make up the divergence", "dual numbers along a turned frame",
              "the three that are printed, x_i being x_" + std::to_string(i));
  for (int n = 0; n < 256; ++n) {
    const double r = std::abs(random.magnitude(1e-30, 1e30));
    const Point u = random.direction(), x{r * u[0], r * u[1], r * u[2]};
    const Matrix<double> d = jacobian(inverse_square, x);
    worst.see(own_slopes(x, random_frame(random)), Value{d[i][0], d[1][1], d[2][2]}, 1 / dot(x, x) / r,
              "|x| = " + shortest(r));
  }
  return worst.check();
}

/// The numerator over the common denominator, in integers.
Check numerator(long factor, Random random) {
  long violations = 0;
  const int samples = 1000;
  for (int n = 0; n < samples; ++n) {
    const long x = random.below(2000001) - 1000000, y = random.below(2000001) - 1000000,
               z = random.below(2000001) - 1000000;
    const long s = x * x + y * y + z * z;
    violations += (s - factor * x * x) + (s - factor * y * y) + (s - factor * z * z) != 0;
  }
  return never("integer points at which the numerator is not zero", violations, samples);
}

/// The divergence of a field at |x| from 1/range to range, where its slopes are of size |x|^-power.
template <class Field>
Check divergence_is_zero(const std::string& name, const Field& field, double power, double range,
                         Random random) {
  Worst worst("div " + name, "dual numbers along a turned frame", "zero");
  for (int n = 0; n < 256; ++n) {
    const double r = std::abs(random.magnitude(1 / range, range));
    const Point u = random.direction(), x{r * u[0], r * u[1], r * u[2]};
    worst.see(divergence(field, random_frame(random))(x), 0.0, std::pow(r, -power), "|x| = " + shortest(r));
  }
  return worst.check();
}
Check divergence_of_power(double power, Random random) {
  const auto field = [power](const auto& x) {
    using std::pow;
    const auto scale = pow(dot(x, x), -power / 2);
    return std::array{x[0] * scale, x[1] * scale, x[2] * scale};
  };
  return divergence_is_zero("x / |x|^" + shortest(power), field, power, 1e40, random);
}

std::vector<Claim> claims(Random random, const Reference& truth) {
  const Random r = random;
  Claim summed{"5.3-divergence", 3191,
               "the divergence is the sum of three derivatives, the first one of x_i / |x|^3"};
  summed.printed = {"d/dx_0 of x_i / |x|^3, for any i", {summands(0, r), summands(1, r), summands(2, r)}};
  summed.meant = {"d/dx_0 of x_0 / |x|^3", {summands(0, r)}};
  summed.near_misses = {{"d/dx_0 of x_1 / |x|^3", {summands(1, r)}}};
  summed.why =
      "The first derivative is printed of $x_i/|\\mathbf x|^3$, an index that nothing sums and nothing else "
      "has: it "
      "must be $x_0$, which the next line has. At the point (0.3, -0.7, 0.9), times $|\\mathbf x|^3$, the "
      "three "
      "derivatives are 0.8058, -0.0576 and -0.7482, which add up to zero; with $x_1$ in the first one it is "
      "0.4532.";

  Claim zero{"5.3-zero", 3267, "the divergence is zero, where the field is defined"};
  zero.printed = {"div (x / |x|^3) = 0", {divergence_is_zero("x / |x|^3", inverse_square, 3, 1e60, r)}};
  const Known flux = truth("05_03_spheroid_flux", {1.5, 1.5, 0.375});
  zero.near_misses = {
      {"div (x / |x|^2) = 0", {divergence_of_power(2, r)}},
      {"div (x / |x|^4) = 0", {divergence_of_power(4, r)}},
      {"and at the origin too: a sphere around it has no flux",
       {{"flux through a sphere", {flux.source, flux.value}, {"zero", 0.0}, {1e-10, "ten decimals"}, 1}}}};

  Claim origin{"5.3-origin", 3267, "the divergence is zero, no point being left out"};
  const auto out_of_a_ball = [&](const char* text, double said) {
    return Reading{text,
                   {{"flux out of a ball around the origin",
                     {flux.source, flux.value},
                     {"the divergence over the ball", said},
                     rounding(4 * std::numbers::pi),
                     4 * std::numbers::pi}}};
  };
  origin.printed = out_of_a_ball("zero everywhere: no flux out of any ball", 0);
  origin.corrected = out_of_a_ball("zero but at the origin: a flux of 4 pi around it", 4 * std::numbers::pi);
  origin.corrected.checks.push_back(zero.printed.checks[0]);
  origin.near_misses = {out_of_a_ball("a flux of 2 pi", 2 * std::numbers::pi)};
  origin.why =
      "At $\\mathbf x=0$ the text divides by zero, and its lines say nothing about that point. It matters: "
      "$4\\pi=12.566$ flows out of every sphere around the origin, however small, so that the divergence is "
      "$4\\pi\\delta(\\mathbf x)$, and Gauss's theorem with a divergence of zero gives 0.";

  Claim numerators{"5.3-numerator", 3267, "the sum of the brackets is zero"};
  numerators.printed = {"the sum of |x|^2 - 3 x_i^2 is zero", {numerator(3, r)}};
  numerators.near_misses = {{"the sum of |x|^2 - 2 x_i^2 is zero", {numerator(2, r)}}};

  Claim quotients{"5.3-quotient_rule", 3135, "the quotient rule for x_i / (x.x)^(3/2)"};
  quotients.printed = reading("(|x|^3 - 3 x_i^2 |x|) / |x|^6", each<quotient>, 1e45, r);
  quotients.near_misses = {reading("a factor 2 for 3", each<quotient_factor_2>, 1e45, r),
                           reading("a plus sign", each<quotient_plus>, 1e45, r)};

  Claim cancelled{"5.3-simplified", 3173, "a factor |x| cancels"};
  cancelled.printed = reading("(|x|^2 - 3 x_i^2) / |x|^5", each<simplified>, 1e55, r);
  cancelled.near_misses = {reading("a plus sign", each<simplified_plus>, 1e55, r),
                           reading("without the second term", each<simplified_dropped>, 1e55, r)};

  Claim common{"5.3-common_denominator", 3239, "the three summands over the common denominator |x|^5"};
  common.printed = reading("brackets with 3 x_0^2, 3 x_1^2, 3 x_2^2", brackets, 1e55, r);
  common.near_misses = {reading("the first bracket twice", brackets_first_twice, 1e55, r)};
  return {quotients, cancelled, summed, common, numerators, zero, origin};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Point x{p["x0"], p["x1"], p["x2"]};
  if (length(x) == 0) throw BadInput("x / |x|^3 is not defined at x = 0");
  const auto away = [&](int k) {
    return Point{std::ldexp(x[0], k), std::ldexp(x[1], k), std::ldexp(x[2], k)};
  };
  Quantity here = partials("partials", "d/dx_i (x_i / |x|^3), i = 0, 1, 2, and their sum, times |x|^3", x,
                           truth, Outcome::ok, {});
  Quantity near = partials(
      "partials_near", "the same a million times closer to the origin, at 2^-20 x", away(-20), truth,
      Outcome::ok, {Outcome::inaccurate, Outcome::ok, "even the finest step is too coarse beside |x|"});
  near.add(Breakdown{
      "Beside the origin a step of $2^{-11}$ straddles it: the difference knows nothing of the field "
      "at $\\mathbf x$. A step in proportion to $|\\mathbf x|$ does.",
      "field, step h, central differences 4", 0x1p-11, Outcome::inaccurate,
      "field, step h |x|, central differences 4", 0x1p-11});
  Quantity far = partials("partials_far", "the same at 2^180 x", away(180), truth, Outcome::inaccurate,
                          {Outcome::inaccurate, Outcome::inaccurate, "x + h is x"});
  far.add(Breakdown{
      "The quotient rule as it stands has $|\\mathbf x|^6$ below: it overflows, and the derivative is "
      "taken for zero. With the factor $|\\mathbf x|$ cancelled it is right.",
      "published derivatives, quotient rule", 0, Outcome::inaccurate, "published derivatives, simplified",
      0});
  Quantity close = spheroid_flux("flux_close", "flux through a spheroid whose pole is close to the origin",
                                 {p["a"], p["b"], p["close"] * p["b"]}, truth, true);
  close.add(Breakdown{
      "Close to the surface the origin makes the density a peak, which rules with fixed points miss "
      "or hit by chance. The adaptive rule finds it.",
      "cos(theta), phi, Gauss-Legendre by trapezoid", 128, Outcome::inaccurate, "theta, phi, QAGS", 1e-8});
  return {claims(Random(p["seed"]), truth),
          {here, near, far,
           spheroid_flux("flux_sphere", "flux through a sphere around the origin",
                         {p["R"], p["R"], p["inside"] * p["R"]}, truth),
           spheroid_flux("flux_spheroid", "flux through a spheroid around the origin",
                         {p["a"], p["b"], p["inside"] * p["b"]}, truth),
           spheroid_flux("flux_outside", "flux through a spheroid that does not enclose the origin",
                         {p["a"], p["b"], p["outside"] * p["b"]}, truth),
           close, cube_flux({p["h"], {0.25 * p["h"], -0.5 * p["h"], 0.125 * p["h"]}}, truth)}};
}

}  // namespace ex05_03

Exercise exercise_5_3() {
  using namespace ex05_03;
  return {
      "Divergence of the inverse-square field",
      "Show that $\\nabla\\cdot(\\mathbf x/|\\mathbf x|^3) = 0$. The origin, where the field is not defined, "
      "shows in the flux through a closed surface: $4\\pi$ around it, zero otherwise.",
      parameters,
      {},
      study};
}

}  // namespace oddity
