#include <algorithm>
#include <iterator>

#include "chapters/03_rigid_body_motion/17_foucault/cone.hpp"
#include "chapters/03_rigid_body_motion/17_foucault/foucault.hpp"
#include "chapters/provable.hpp"

namespace oddity {

Provables proofs_3_17() {
  Provables all = ex03_17::pendulum_proofs();
  std::ranges::move(ex03_17::cone_proofs(), std::back_inserter(all));
  all.push_back({"3.17-L_decimals",
                 "the cube root is 0.7937 to its last digit",
                 {{.name = "printed",
                   .follows = {near(ex03_17::printed_length<Expression>(), 0.7937, 5e-5)},
                   .tactic = "interval"}}});
  return all;
}

}  // namespace oddity
