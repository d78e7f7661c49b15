#include <algorithm>
#include <iterator>

#include "chapters/03_rigid_body_motion/17_foucault/cone.hpp"
#include "chapters/03_rigid_body_motion/17_foucault/foucault.hpp"
#include "chapters/provable.hpp"

namespace oddity::ex03_17 {

Provables proofs() {
  Provables all = pendulum_proofs();
  std::ranges::move(cone_proofs(), std::back_inserter(all));
  all.push_back({"3.17-L_decimals",
                 "the cube root is 0.7937 to its last digit",
                 {{.name = "printed",
                   .follows = {near(printed_length<Expression>(), 0.7937, 5e-5)},
                   .tactic = "interval"}}});
  return all;
}

}  // namespace oddity::ex03_17
