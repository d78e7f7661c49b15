#include "chapters/proofs.hpp"

#include "chapters/03_rigid_body_motion/17_foucault/cone.hpp"

namespace oddity::ex03_17 {

namespace {

/// Of the cone with r = h = 1 above z: the volume, each slice of it times a weight.
template <class Weight>
Expression integral_above(const Expression& z, const Weight& weight) {
  const Expression one = 1;
  return integral(
      [&](const Expression& x) {
        const Expression rho = radius(one, one, x);
        return Expression::pi() * rho * rho * weight(x);
      },
      z, one);
}

/// Zero where `height` is that of the center of mass.
Expression moment_about(const Expression& height) {
  return integral_above(0, [&](const Expression& z) { return z - height; });
}

}  // namespace

std::vector<Proof> proofs() {
  using Kind = Proof::Kind;
  const Expression quarter = Expression(1) / 4, volume = Expression::pi() / 3,
                   printed = printed_length<Expression>();
  const Expression above = integral_above(quarter, [](const Expression&) { return Expression(1); });
  const std::string nearly = "0.0000000001", cone = " of the cone with r = h = 1 ";
  const std::string moment = "the moment" + cone + "about the center of mass, ",
                    part = "the volume" + cone + "above h/4, and ";
  return {
      {"3.17-center_halves", "printed", Kind::far, part + "1/2 of the whole", {}, above, volume / 2, "0.08"},
      {"3.17-center_halves",
       "corrected",
       Kind::near,
       part + "27/64 of the whole",
       {},
       above,
       above_center<Expression>() * volume,
       nearly},
      {"3.17-center_height",
       "printed",
       Kind::far,
       moment + "were it at 1 - 1/cbrt(2), and zero",
       {},
       moment_about(halving_height<Expression>()),
       0,
       "0.045"},
      {"3.17-center_height",
       "corrected",
       Kind::near,
       moment + "at 1/4, and zero",
       {},
       moment_about(quarter),
       0,
       nearly},
      {"3.17-L",
       "printed",
       Kind::far,
       moment + "were it 1/cbrt(2) from the vertex, and zero",
       {},
       moment_about(1 - printed),
       0,
       "0.045"},
      {"3.17-L",
       "corrected",
       Kind::near,
       moment + "3/4 from the vertex, and zero",
       {},
       moment_about(1 - Expression(3) / 4),
       0,
       nearly}};
}

}  // namespace oddity::ex03_17
