#include <algorithm>
#include <iterator>

#include "chapters/03_rigid_body_motion/17_foucault/cone.hpp"
#include "chapters/03_rigid_body_motion/17_foucault/foucault.hpp"
#include "chapters/provable.hpp"

// Of the cone with r = h = 1, whose volume is pi/3.
namespace oddity {

namespace ex03_17 {

namespace {

/// Above z, each slice times a weight.
template <class Weight>
Expression integral_above(const Expression& z, const Weight& weight) {
  return integral(
      [&](const Expression& x) {
        const Expression rho = radius<Expression>(1, 1, x);
        return pi_in_coq() * rho * rho * weight(x);
      },
      z, 1, "z");
}

/// Zero where `height` is that of the center of mass.
Expression moment_about(const Expression& height) {
  return integral_above(0, [&](const Expression& z) { return z - height; });
}

Lemma within(const Expression& x, const Expression& y) {
  return {.name = "corrected", .follows = {near(x, y, 1e-10)}, .tactic = "integral"};
}
Lemma beyond(const Expression& x, const Expression& y, double margin) {
  return {.name = "printed_differs", .follows = {apart(x, y, margin)}, .tactic = "integral"};
}

}  // namespace

Provables proofs() {
  const Expression volume = pi_in_coq() / 3;
  const Expression quarter = Expression(1) / 4, three_quarters = Expression(3) / 4;
  const Expression above = integral_above(quarter, [](const Expression&) { return Expression(1); });
  const std::string moment =
      "the moment of volume about the corrected center is zero, about the printed one not";
  return {{"3.17-center_halves",
           "above the center of mass are 27/64 of the volume, and not a half",
           {within(above, above_center<Expression>() * volume), beyond(above, volume / 2, 0.08)},
           0.08},
          {"3.17-center_height",
           moment,
           {within(moment_about(quarter), 0), beyond(moment_about(halving_height<Expression>()), 0, 0.045)},
           0.045},
          {"3.17-L",
           moment,
           {within(moment_about(1 - three_quarters), 0),
            beyond(moment_about(1 - printed_length<Expression>()), 0, 0.045)},
           0.045},
          {"3.17-L_decimals",
           "the cube root is 0.7937 to its last digit",
           {{.name = "printed",
             .follows = {near(printed_length<Expression>(), 0.7937, 5e-5)},
             .tactic = "interval"}}}};
}

}  // namespace ex03_17

Provables proofs_3_17() {
  Provables all = ex03_17::pendulum_proofs();
  std::ranges::move(ex03_17::proofs(), std::back_inserter(all));
  return all;
}

}  // namespace oddity
