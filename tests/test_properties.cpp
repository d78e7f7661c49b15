// Properties of single scenes at all parameters: their limits and symmetries.

#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/03_rigid_body_motion/09_damped_ball/models.hpp"
#include "chapters/03_rigid_body_motion/19_two_pulleys/models.hpp"
#include "chapters/03_rigid_body_motion/23_spring_bar/models.hpp"
#include "chapters/03_rigid_body_motion/25_chain/models.hpp"
#include "chapters/03_rigid_body_motion/27_two_bodies/models.hpp"
#include "chapters/examples/bouncing_ball/models.hpp"
#include "chapters/scene.hpp"
#include "tests/models_in_numbers.hpp"
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

/// Factors of the parameters, the time and the observables that map a motion to another.
struct Map {
  std::vector<double> parameters;
  double time;
  std::vector<double> observables;
};

/// Powers of the units of mass, length and time.
using Dimensions = std::array<int, 3>;

/// A factor that is a power of two, with roots that are powers of two as well, so that not a bit changes.
double in_other_units(const Dimensions& d) { return std::ldexp(1, 4 * d[0] + 8 * d[1] - 12 * d[2]); }

Map other_units(const std::vector<Dimensions>& parameters, const std::vector<Dimensions>& observables) {
  Map map{{}, in_other_units({0, 0, 1}), {}};
  for (const Dimensions& d : parameters) map.parameters.push_back(in_other_units(d));
  for (const Dimensions& d : observables) map.observables.push_back(in_other_units(d));
  return map;
}

/// Every model of a scene gives the mapped motion from the mapped parameters, in every bit.
template <template <class> class Given>
void check_map(std::string_view number, const std::string& says, const Map& map) {
  const Entry& entry = entry_of(number);
  properties::check(entry, says, 20, [&](const Parameters& p) {
    std::vector<double> values, mapped;
    for (std::size_t i = 0; i < map.parameters.size(); ++i) {
      values.push_back(p[entry.exercise.parameters[i].name]);
      mapped.push_back(map.parameters[i] * values[i]);
    }
    const double end = entry.exercise.scene->horizon / 200;
    std::string wrong;
    const auto look = [&](const auto& model, const auto& other) {
      const auto here = models_test::at_end<double>(model, end),
                 there = models_test::at_end<double>(other, map.time * end);
      for (std::size_t k = 0; k < map.observables.size() && wrong.empty(); ++k)
        if (const double expected = map.observables[k] * here[k];
            there[k] != expected && !(std::isnan(there[k]) && std::isnan(expected)))
          wrong = "observable " + std::to_string(k + 1) + " is " + format_shortest(there[k]) + " and not " +
                  format_shortest(expected);
    };
    std::apply(
        [&](const auto&... model) {
          std::apply([&](const auto&... other) { (look(model, other), ...); },
                     models(models_test::given<Given, double>(mapped)));
        },
        models(models_test::given<Given, double>(values)));
    return wrong;
  });
}

constexpr Dimensions number{}, mass{1, 0, 0}, length{0, 1, 0}, speed{0, 1, -1}, acceleration{0, 1, -2},
    angular_speed{0, 0, -1}, stiffness{1, 0, -2}, damping{1, 0, -1}, inertia{1, 2, 0};

}  // namespace

TEST_CASE("in other units a motion is the same, in every bit", "[properties]") {
  const std::string says = "numbers in other units give the motion in these";
  check_map<pendulum::Given>("3.5", says, other_units({number, length, acceleration}, {number}));
  check_map<damped_ball::Given>(
      "3.9", says, other_units({mass, stiffness, damping, length, length, speed, speed}, {length, length}));
  check_map<two_pulleys::Given>(
      "3.19", says,
      other_units({mass, mass, inertia, inertia, length, length, stiffness, stiffness, length, length, length,
                   length, acceleration, length, length, speed, speed},
                  {length, length}));
  check_map<chain::Given>("3.25", says,
                          other_units({mass, mass, mass, length, length, length, acceleration, length, number,
                                       number, number, angular_speed, angular_speed, angular_speed},
                                      {length, length, length, length, length, length}));
  check_map<two_bodies::Given>(
      "3.27", says,
      other_units({{-1, 3, -2}, mass, mass, length, speed, number, angular_speed}, {length, length}));
}

TEST_CASE("a mirrored start gives the mirrored motion, in every bit", "[properties]") {
  const std::string says = "mirrored at the start, it is mirrored for ever";
  check_map<chain::Given>("3.25", says,
                          {{1, 1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1}, 1, {-1, 1, -1, 1, -1, 1}});
  check_map<two_bodies::Given>("3.27", says, {{1, 1, 1, 1, 1, -1, -1}, 1, {1, -1}});
}

TEST_CASE("a small swing is the small angle's, except for its longer period", "[properties]") {
  properties::check(
      entry_of("3.5"), "a hundredth of the angle swings like a cosine", 100, [](const Parameters& p) {
        const double a = p["a"] / 100, w = std::sqrt(p["g"] / p["L"]);
        const pendulum::Given<double> given{a, p["L"], p["g"]};
        const pendulum::FourierSeries<double> exact(given);
        const pendulum::SmallAngle<double> small{given};
        std::string wrong;
        for (double turns = 1; turns <= 64 && wrong.empty(); turns *= 1.7) {
          // The frequency is lower by the part a^2 / 16, and the shape differs by a^3 / 192.
          const double allowed = 1.1 * a * a * a * (turns / 16 + 1.0 / 192) + 256 * epsilon * a * turns;
          wrong = more_than(std::abs(exact.at(turns / w)[0] - small.at(turns / w)[0]), allowed, turns / w);
        }
        return wrong;
      });
}

TEST_CASE("a small oscillation of the bar starts like the bar, also if it is pushed", "[properties][3.23]") {
  properties::check(
      entry_of("3.23"), "angle, angular speed and acceleration are the same", 100, [](const Parameters& p) {
        const spring_bar::Given<double> given{
            p["m"], p["r"], p["s"], p["c"], p["h"], p["g"], p["ell"], 1e-6 * p["theta0"], p["w0"]};
        const double w = given.frequency(), dt = 0x1p-10 / w;
        const auto angle = [&](double t) {
          const auto x = spring_bar::SmallOscillation<double>{given}.at(t);
          return std::atan2(x[1], x[0]);
        };
        const double before = angle(-dt), now = angle(0), after = angle(dt);
        const double pull = spring_bar::OneAngle<double>{given}.acceleration_at(given.theta0);
        // The angles that are added, and their first and second derivatives.
        const double size = std::abs(pull) / (w * w) + std::abs(given.w0) / w + std::abs(given.theta0);
        std::string wrong = more_than(std::abs(now - given.theta0), 8 * epsilon * size, 0);
        if (wrong.empty())
          wrong = more_than(std::abs((after - before) / (2 * dt) - given.w0), 1e-6 * size * w, 0);
        if (wrong.empty())
          wrong = more_than(std::abs((after - 2 * now + before) / (dt * dt) - pull), 1e-5 * size * w * w, 0);
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

TEST_CASE("a ball's bounces come in order, each where the flight before it ends", "[properties]") {
  Random random(in_environment("ODDITY_SEED", 1));
  for (int set = 0; set < in_environment("ODDITY_SETS", 20); ++set) {
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
