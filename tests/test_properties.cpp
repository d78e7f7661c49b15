// What holds at all parameters of a single scene: its limits and its symmetries.

#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/03_rigid_body_motion/09_damped_ball/models.hpp"
#include "chapters/examples/bouncing_ball/models.hpp"
#include "chapters/scene.hpp"
#include "tests/properties.hpp"

using namespace oddity;
using properties::entry_of;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::string more_than(double off, double allowed, double t) {
  return off <= allowed ? ""
                        : "at t = " + format_shortest(t) + " by " + format_shortest(off) + ", more than " +
                              format_shortest(allowed);
}

}  // namespace

TEST_CASE("a small swing is the small angle's, but for its longer period", "[properties]") {
  properties::check(
      entry_of("3.5"), "a hundredth of the angle swings like a cosine", 100, [](const Parameters& p) {
        const double a = p["a"] / 100, w = std::sqrt(p["g"] / p["L"]);
        const pendulum::Given<double> given{a, p["L"], p["g"]};
        const pendulum::FourierSeries<double> exact(given);
        const pendulum::SmallAngle<double> small{given};
        std::string wrong;
        for (double turns = 1; turns <= 64 && wrong.empty(); turns *= 1.7) {
          // The frequency is less by the part a^2 / 16, the shape other by a^3 / 192.
          const double allowed = 1.1 * a * a * a * (turns / 16 + 1.0 / 192) + 256 * epsilon * a * turns;
          wrong = more_than(std::abs(exact.at(turns / w)[0] - small.at(turns / w)[0]), allowed, turns / w);
        }
        return wrong;
      });
}

TEST_CASE("without friction the ball goes round an ellipse, and from the other side the other way",
          "[properties]") {
  properties::check(
      entry_of("3.9"), "it is two cosines, mirrored with its start", 100, [](const Parameters& p) {
        const double w = std::sqrt(p["c"] / p["m"]);
        const damped_ball::Given<double> free{p["m"], p["c"], 0, p["p1"], p["p2"], p["v1"], p["v2"]};
        const damped_ball::Given<double> rubbed{p["m"], p["c"], p["a"], p["p1"], p["p2"], p["v1"], p["v2"]};
        const damped_ball::Given<double> mirrored{p["m"],   p["c"],   p["a"],  -p["p1"],
                                                  -p["p2"], -p["v1"], -p["v2"]};
        std::string wrong;
        for (double turns = 0.3; turns <= 64 && wrong.empty(); turns *= 1.7) {
          const double t = turns / w, size = std::abs(p["p1"]) + std::abs(p["v1"]) / w;
          const double x = damped_ball::OneForm<double>{free}.at(t)[0];
          wrong = more_than(std::abs(x - (p["p1"] * std::cos(turns) + p["v1"] / w * std::sin(turns))),
                            64 * epsilon * size * (1 + turns), t);
          const auto here = damped_ball::OneForm<double>{rubbed}.at(t),
                     there = damped_ball::OneForm<double>{mirrored}.at(t);
          if (here[0] != -there[0] || here[1] != -there[1])
            wrong = "at t = " + format_shortest(t) + " it is not mirrored";
        }
        return wrong;
      });
}

TEST_CASE("a ball's bounces come in their order, each where the flights before it end", "[properties]") {
  Random random(properties::in_environment("ODDITY_SEED", 1));
  for (int set = 0; set < properties::in_environment("ODDITY_SETS", 20); ++set) {
    const bouncing_ball::Given<double> given{random.between(0.1, 10), random.between(0.5, 50),
                                             random.between(0.1, 0.9)};
    const double end = 0.8 * given.rest();
    const Answer found =
        type_erased(bouncing_ball::Ball<double>{given})->run("Fehlberg 7(8)", {end, 16}, 1e-11);
    INFO("y0 = " << given.y0 << ", g = " << given.g << ", e = " << given.e);
    REQUIRE(found.reached());
    for (int i = 0; i < 16; ++i)
      CHECK(std::abs(found.value[static_cast<std::size_t>(i)] -
                     bouncing_ball::Flights<double>{given}.at(end * (i + 1) / 16)[0]) <= 1e-7 * given.y0);
  }
}
