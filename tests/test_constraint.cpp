// Constraints of motions in redundant coordinates: how much each method violates them.

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "report/cli/asked.hpp"
#include "report/pages/choose_view.hpp"
#include "report/study/choose.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

Quantity motion_of(const std::string& exercise, const Horizon& horizon) {
  const Entry& entry = entry_of(exercise);
  return motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), horizon, Reference::nothing());
}

/// The pendulum of 3.5 on its rod by a separate classical Runge-Kutta rule: largest error of the rod at
/// `frames` times, with one step between them.
double rod_off(double h, int frames) {
  constexpr double g = 9.81, L = 1;
  using State = std::array<double, 4>;
  const auto slope = [](const State& x) -> State {
    const double along =
        (x[2] * x[2] + x[3] * x[3] - g * x[1]) / (x[0] * x[0] + x[1] * x[1]);  // the rod's pull
    return {x[2], x[3], -along * x[0], -along * x[1] - g};
  };
  const auto moved = [](State x, double by, const State& v) {
    for (std::size_t i = 0; i < 4; ++i) x[i] += by * v[i];
    return x;
  };
  const double a = Parameters(entry_of("3.5").exercise.parameters)["a"];
  State x{L * std::sin(a), -L * std::cos(a), 0, 0};
  double most = 0;
  for (int k = 0; k < frames; ++k) {
    const State v1 = slope(x), v2 = slope(moved(x, h / 2, v1)), v3 = slope(moved(x, h / 2, v2)),
                v4 = slope(moved(x, h, v3));
    for (std::size_t i = 0; i < 4; ++i) x[i] += h / 6 * (v1[i] + 2 * v2[i] + 2 * v3[i] + v4[i]);
    most = std::max(most, std::abs(std::sqrt(x[0] * x[0] + x[1] * x[1]) - L));
  }
  return most;
}

Choice chosen(std::vector<std::string> only, const std::string& exercise, const std::string& error) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  AskedNeed asked;
  asked.error = error;
  asked.criterion = "constraint";
  asked.horizon = "1";
  asked.only = std::move(only);
  const Task task = task_of(exercise, {});
  return choose(task, need_of(task, asked), truth, [](const Method& m, double setting) -> Time {
    return {1e-9 * static_cast<double>(m.run(setting).evaluations), 0};
  });
}

}  // namespace

TEST_CASE("the error of a pendulum's rod matches a separate integration", "[constraint]") {
  const Quantity swing = motion_of("3.5", {2, 1, 20});
  const Method* cartesian = method_of(swing, "Cartesian with constraint", "Runge-Kutta 4");
  REQUIRE(cartesian);
  REQUIRE(cartesian->off_constraint);
  const double off = rod_off(0.05, 40);
  CHECK(off > 1e-6);
  CHECK(near(cartesian->off_constraint(0.05), off, 1e-12));
  CHECK_FALSE(method_of(swing, "one angle", "Runge-Kutta 4")->off_constraint);
}

namespace {

/// The models that can violate a constraint.
const std::map<std::string, std::set<std::string>> constrained{
    {"3.5", {"Cartesian with constraint"}},
    {"3.7", {"Cartesian with constraints"}},
    {"3.11", {"Cartesian with constraint"}},
    {"3.13", {"Cartesian with constraint"}},
    {"3.15", {"in the turning plane", "Cartesian with constraints"}},
    {"3.17", {"Cartesian with constraint"}},
    {"3.19", {"four coordinates with tensions"}},
    {"3.21", {"Cartesian center"}},
    {"3.23", {"Cartesian with constraint"}},
    {"3.29", {"two particles and a rod"}},
    {"3.33", {"axis and angular momentum"}},
    {"3.35", {"axis and angular momentum", "fixed tip, as proposed"}},
};

void keeps_to_its_constraint(const std::string& number) {
  std::set<std::string> found;
  for (const Method& method : motion_of(number, {1, 1, 16}).methods) {
    if (!method.off_constraint) continue;
    found.insert(method.model);
    INFO(method.model << " by " << method.algorithm);
    if (method.algorithm == "Fehlberg 7(8)") CHECK(method.off_constraint(1e-13) < 1e-9);
    // Any algorithm keeps states on a line, except for rounding.
    const bool line = number == "3.19" || method.model == "in the turning plane";
    if (method.algorithm == "explicit Euler") CHECK((method.off_constraint(1.0 / 16) < 1e-12) == line);
  }
  const auto expected = constrained.find(number);
  CHECK(found == (expected == constrained.end() ? std::set<std::string>() : expected->second));
}

[[maybe_unused]] const bool registered = [] {
  for (const Entry& entry : registry())
    if (entry.exercise.scene)
      register_test(
          [&entry] { keeps_to_its_constraint(to_string(entry.number)); },
          to_string(entry.number) +
              ": redundant coordinates keep to their constraint as far as the algorithm is accurate",
          "[constraint][" + to_string(entry.number) + "]");
  return true;
}();

}  // namespace

TEST_CASE("choosing by a constraint: a length at every frame, or by construction", "[constraint]") {
  const Choice held = chosen({"Cartesian"}, "3.5", "1mm");
  REQUIRE(held.chosen);
  CHECK(held.chosen->by.at(Criterion::constraint) > held.rounding);
  const std::string text = choice_text(held, true);
  INFO(text);
  CHECK(text.find("with its constraints off by 1 mm at most, at every frame") != std::string::npos);
  CHECK(text.find(" mm") != std::string::npos);
  CHECK(text.substr(0, text.find("Each method")).find("held by construction") == std::string::npos);
  const auto euler = std::ranges::find(held.candidates, "explicit Euler", &Candidate::algorithm);
  REQUIRE(euler != held.candidates.end());
  CHECK(euler->evaluations_per_frame > held.chosen->evaluations_per_frame);

  const Choice all = chosen({}, "3.5", "1mm");
  REQUIRE(all.chosen);
  CHECK(all.chosen->by.at(Criterion::constraint) <= all.rounding);
  CHECK(choice_text(all, false).find("held by construction") != std::string::npos);
  CHECK(choice_json(all).find("\"criterion\": \"constraint\"") != std::string::npos);
}

TEST_CASE("a constraint that does not exist, or has no length, is refused", "[constraint]") {
  CHECK(complaint([] { chosen({}, "3.27", "1mm"); }).find("no model here has a constraint") !=
        std::string::npos);
  CHECK(complaint([] { chosen({"one angle"}, "3.5", "1mm"); }).find("no model left has a constraint") !=
        std::string::npos);
  CHECK(complaint([] { chosen({}, "3.5", ""); }).find("needs --error, a length such as 1mm") !=
        std::string::npos);
  CHECK(complaint([] { chosen({}, "3.5", "1deg"); }).find("--error") != std::string::npos);
}
