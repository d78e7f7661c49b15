// The claims of exercise 3.31: about a program that is not available.

#include "chapters/claims.hpp"
#include "chapters/03_rigid_body_motion/31_rough_box/rough_box.hpp"

namespace oddity::ex03_31 {

std::vector<Claim> claims() {
  const std::string why =
      "the program is on the book's CD-ROM; the text gives neither its equations nor a listing";
  return Claims("3.31")
      .add("rough_friction", 2949,
           "The program `RoughPlaneSolidBox` is an implementation that uses rough friction",
           {.not_checkable = why})
      .add("no_static_friction", 2949, "The program does not incorporate static friction",
           {.not_checkable = why})
      .add("easily_modified", 2949, "The program may easily be modified to have static friction",
           {.not_checkable = why})
      .in_order();
}

}  // namespace oddity::ex03_31
