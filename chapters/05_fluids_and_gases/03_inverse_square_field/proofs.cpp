// Proofs of the field's slopes anywhere but at the origin, its divergence along any frame, and its flux
// through spheres.
#include "chapters/05_fluids_and_gases/03_inverse_square_field/inverse_square_field.hpp"
#include "chapters/05_fluids_and_gases/shared/smooth_fields.hpp"
#include "chapters/integral_proofs.hpp"
#include "chapters/provable.hpp"

namespace oddity::ex05_03 {

namespace {

using namespace fields;
using Letters = Triple<Shortened>;

Shortened letter(const char* name) { return Shortened::letter(name); }
Shortened derivative_in_coq(const Shortened& f, const Shortened& at) {
  return Shortened::letter("(Derive (fun t => " + f.expression().coq() + ") (" + at.expression().coq() +
                           "))");
}

/// The derivative of component i by x_j.
Shortened slope(const Letters& x, std::size_t i, std::size_t j) {
  Letters varied = x;
  varied[j] = letter("t");
  return derivative_in_coq(inverse_square(varied)[i], x[j]);
}
Expressions own_slopes(const Letters& x) {
  Expressions all;
  for (std::size_t i = 0; i < 3; ++i) all.push_back(slope(x, i, i).expression());
  return all;
}

/// The sum over the frame r of each vector's dot product with the derivative along it.
Expression divergence_in_frame(const Letters& x) {
  Shortened sum;
  for (const Letters& u : {numbers("r 0%nat"), numbers("r 1%nat"), numbers("r 2%nat")}) {
    const Shortened t = letter("t");
    const Letters along = inverse_square(Letters{x[0] + t * u[0], x[1] + t * u[1], x[2] + t * u[2]});
    sum += dot(u, Letters{derivative_in_coq(along[0], 0.0), derivative_in_coq(along[1], 0.0),
                          derivative_in_coq(along[2], 0.0)});
  }
  return sum.expression();
}

/// The flux through the sphere of this radius around the origin, integrated over both angles.
Expression flux(const Shortened& radius) {
  const Shortened theta = letter("theta"), phi = letter("phi");
  const Letters n{sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)};
  const Shortened density = radius * radius * sin(theta) *
                            dot(inverse_square(Letters{radius * n[0], radius * n[1], radius * n[2]}), n);
  const Expression circle =
      integral([&](const Expression&) { return density.expression(); }, 0, pi_in_coq(), "theta");
  return integral([&](const Expression&) { return circle; }, 0, 2 * pi_in_coq(), "phi");
}

}  // namespace

Provables proofs() {
  const Letters x{letter("x0"), letter("x1"), letter("x2")};
  const Shortened s = dot(x, x);
  const std::string coordinates = "(x0 x1 x2 : R)", of_frame = "(r : nat -> nat -> R) (x0 x1 x2 : R)";
  const Proposition away = above(s.expression(), 0), right_handed{"frame r"};
  const std::string preamble = coq_source({"slopes"});
  const auto all = [](const Letters& v) {
    return Expressions{v[0].expression(), v[1].expression(), v[2].expression()};
  };
  const auto each_by = [&](Shortened (*of)(Shortened, Shortened)) {
    return all({of(s, x[0]), of(s, x[1]), of(s, x[2])});
  };
  Provables proved;
  const auto add = [&](const std::string& slug, const std::string& says, const std::vector<Lemma>& lemmas) {
    proved.push_back({"5.3-" + slug, says, lemmas, 0, preamble});
  };
  const auto slopes = [&](const std::string& slug, const Expressions& printed) {
    add(slug, "they are the derivatives at every point but the origin",
        {{"printed", coordinates, {away}, equal(printed, own_slopes(x)), "symmetry; at_distance H"}});
  };
  slopes("quotient_rule", each_by(quotient));
  slopes("simplified", each_by(simplified));
  slopes("common_denominator", all(brackets(x)));

  const Expressions own = own_slopes(x);
  const Letters example{0.3, -0.7, 0.9};
  add("divergence",
      "as meant it is the divergence along any frame at every point but the origin; as printed it is off at an "
      "example",
      {{"meant",
        of_frame,
        {right_handed, away},
        {divergence_in_frame(x) == own[0] + own[1] + own[2]},
        "transitivity 0; [divergence_is_zero r x0 x1 x2 H H0 |];\n"
        "  rewrite slope_0, slope_1, slope_2 by exact H0; field; apply Rgt_not_eq, sqrt_lt_R0, H0"},
       {"printed_differs",
        "",
        {},
        {apart(slope(example, 1, 0).expression(), slope(example, 0, 0).expression(), 0.2)},
        "rewrite ?slope_beside, ?slope_0 by lra; interval"}});
  proved.back().margin = 0.2;

  add("numerator", "it holds for all coordinates",
      {{"printed", coordinates, {}, {sum_of_brackets(x, Shortened(3.0)).expression() == 0}, "ring"}});
  const Lemma zero{"printed",
                   of_frame,
                   {right_handed, away},
                   {divergence_in_frame(x) == 0},
                   "divergence_is_zero r x0 x1 x2 H H0"};
  add("zero", "it holds along any frame at every point but the origin", {zero});

  const std::string by_angles = "flux_is a theta phi H";
  const Lemma around{"corrected_flux",
                     "(a : R)",
                     {above(letter("a").expression(), 0)},
                     {flux(letter("a")) == 4 * pi_in_coq()},
                     by_angles};
  Lemma away_from_it = zero;
  away_from_it.name = "corrected_away";
  add("origin",
      "as corrected the divergence is zero but at the origin, and the flux through every sphere around it is "
      "four pi; as printed it is off",
      {away_from_it,
       around,
       {"printed_differs",
        "(a : R)",
        {above(letter("a").expression(), 0)},
        {apart(0, flux(letter("a")), 12.5)},
        "match goal with |- context [RInt ?f ?low ?high] => let is := fresh in\n"
        "    assert (is : RInt f low high = 4 * PI) by (" +
            by_angles + "); rewrite is end; interval"}});
  proved.back().margin = 12.5;
  proved.back().preamble = coq_source({"flux"});
  return proved;
}

}  // namespace oddity::ex05_03
