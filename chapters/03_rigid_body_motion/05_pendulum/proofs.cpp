#include "chapters/proofs.hpp"

#include "chapters/03_rigid_body_motion/05_pendulum/quarter_period.hpp"

namespace oddity::ex03_05 {

std::vector<Proof> proofs() {
  using Kind = Proof::Kind;
  const Expression pi = Expression::pi(), time = integral(legendre_integrand(pi / 6), Expression(0), pi / 2);
  const std::string says = "the quarter period from 30 degrees, by Legendre's substitution, and ";
  return {{"3.5-value",
           "corrected",
           Kind::near,
           says + "2.260114",
           {},
           time,
           Expression::decimal("2.260114"),
           "0.0000005"},
          {"3.5-value",
           "printed",
           Kind::far,
           says + "0.800275",
           {},
           time,
           Expression::decimal("0.800275"),
           "1.459838"}};
}

}  // namespace oddity::ex03_05
