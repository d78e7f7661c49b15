// Exercise 5.3: div (x / |x|^3) = 0 away from the origin.
// Left side: the field, x over the cube of sqrt(x.x), is differentiated by dual numbers along a randomly
// rotated frame. Right side: the published quotients of powers of x.x. Sizes of x range over a hundred orders
// of magnitude. The flux through closed surfaces shows the effect of the origin.

#include "chapters/05_fluids_and_gases/03_inverse_square_field/inverse_square_field.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex05_03 {

constexpr Parameter parameters[] = {
    {"x0", 0.3, "m", "where the divergence is taken", -2, 2},
    {"x1", -0.7, "m", "where the divergence is taken", -2, 2},
    {"x2", 0.9, "m", "where the divergence is taken", -2, 2},
    {"R", 1.5, "m", "radius of the sphere", 0.5, 10},
    {"a", 1, "m", "equatorial semi-axis of the spheroids", 0.1, 10},
    {"b", 2, "m", "polar semi-axis of the spheroids", 0.1, 10},
    {"inside", 0.25, "", "centre of the sphere and the spheroid around the origin, in radii or $b$", 0, 0.9},
    {"outside", 1.5, "", "centre of the spheroid that does not enclose the origin, in $b$", 1.1, 10},
    {"close", 0.9921875, "", "centre of the spheroid whose pole is close to the origin, in $b$", 0.9, 0.998},
    {"h", 1, "m", "half side of the cube", 0.1, 10},
    {"seed", 5, "", "seed of the random points of the claims", 0, 9e15, whole_number},
};

Findings study(const Parameters& p, const Reference& truth) {
  const Point x{p["x0"], p["x1"], p["x2"]};
  if (fields::length(x) == 0) throw BadInput("x / |x|^3 is not defined at x = 0");
  constexpr double closest = 1e-50;
  if (!(fields::length(x) > closest))
    throw BadInput("so close to x = 0 powers of |x| underflow: |x| must be above " +
                   format_shortest(closest) + " m");
  const auto away = [&](int k) {
    return Point{std::ldexp(x[0], k), std::ldexp(x[1], k), std::ldexp(x[2], k)};
  };
  Quantity here =
      partials("partials",
               R"($\frac{\partial}{\partial x_i}\frac{x_i}{|\mathbf x|^3}$, $i=0,1,2$, and their sum, times )"
               R"($|\mathbf x|^3$)",
               x, truth);
  Quantity near =
      partials("partials_near", R"(the same a million times closer to the origin, at $2^{-20}\mathbf x$)",
               away(-20), truth);
  near.add(
      Breakdown{"Near the origin a step of $2^{@2}$ straddles it: the difference knows nothing of the "
                R"(field at $\mathbf x$. A step in proportion to $|\mathbf x|$ does.)",
                "field, step h, central differences 4",
                0x1p-11,
                Outcome::inaccurate,
                "field, step h |x|, central differences 4",
                0x1p-11,
                {power_of_two_of(Side::broken)}});
  Quantity far = partials("partials_far", R"(the same at $2^{180}\mathbf x$)", away(180), truth);
  if (by_quotient_rule(away(180)).outcome == Outcome::inaccurate)
    far.add(Breakdown{
        "The quotient rule as printed has $|\\mathbf x|^6$ below: it overflows, and the derivative is "
        "taken for zero. With the factor $|\\mathbf x|$ cancelled it is right.",
        "published derivatives, quotient rule", 0, Outcome::inaccurate, "published derivatives, simplified",
        0});
  Quantity close = spheroid_flux("flux_close", "flux through a spheroid whose pole is close to the origin",
                                 p["a"], p["b"], p["close"] * p["b"], truth, true);
  close.add(Breakdown{
      "Close to the surface the origin makes the density a peak, which rules with fixed points miss "
      "or hit by chance. The adaptive rule finds it.",
      "cos(theta), phi, Gauss-Legendre by trapezoid", 128, Outcome::inaccurate, "theta, phi, QAGS", 1e-8});
  return {claims(Random(p["seed"]), truth),
          {here, near, far,
           spheroid_flux("flux_sphere", "flux through a sphere around the origin", p["R"], p["R"],
                         p["inside"] * p["R"], truth),
           spheroid_flux("flux_spheroid", "flux through a spheroid around the origin", p["a"], p["b"],
                         p["inside"] * p["b"], truth),
           spheroid_flux("flux_outside", "flux through a spheroid that does not enclose the origin", p["a"],
                         p["b"], p["outside"] * p["b"], truth),
           close, cube_flux(p["h"], truth)},
          roots(),
          R"(The proof is right {{the origin|everywhere but at the origin}}.)"};
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
      study,
      proofs};
}

}  // namespace oddity
