#include "chapters/03_rigid_body_motion/pendulum_models.hpp"
#include "tests/models_in_numbers.hpp"
TEST_CASE("The models of 3.5 in every number", "[models]") {
  oddity::models_test::Scene<oddity::pendulum::Given>("3.5").in_every_number();
}
