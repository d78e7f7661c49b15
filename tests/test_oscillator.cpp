// The lesson's oscillator: its closed form, and the orders of its methods compared with it.

#include "chapters/examples/oscillator/scene.hpp"
#include "report/study/results.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

TEST_CASE("the oscillator's circle has its energy, and methods converge to it with their orders",
          "[oscillator]") {
  const oscillator::Circle<double> circle{{2, 1, 3}};
  for (const double t : {0.0, 0.3, 5.0}) {
    const auto [x, v] = circle.at(t);
    CHECK(near(v * v + 4 * x * x, 13, 1e-13));
  }
  const Quantity motion =
      oddity::motion(oscillator::scene(), Parameters(oscillator::parameters), Reference::nothing());
  const auto error = [&](const std::string& algorithm, double step) {
    for (const Method& m : motion.methods)
      if (m.algorithm == algorithm) return run(motion, m, step).error;
    return not_a_number;
  };
  CHECK(error("Runge-Kutta 4", 1.0 / 256) < 1e-7);
  CHECK(near(error("Runge-Kutta 4", 1.0 / 64) / error("Runge-Kutta 4", 1.0 / 128), 16, 0.5));
  CHECK(near(error("velocity Verlet", 1.0 / 64) / error("velocity Verlet", 1.0 / 128), 4, 0.1));
}
