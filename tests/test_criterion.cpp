// Definitions of the criteria, by the observed motion.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "report/cli/asked.hpp"
#include "report/pages/choose_view.hpp"
#include "report/pages/is_enough_view.hpp"
#include "report/study/choose.hpp"
#include "report/study/criterion.hpp"
#include "report/study/findings.hpp"
#include "report/study/is_enough.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

const Reference& tables() {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  return truth;
}

Time counted(const Method& m, double setting) {
  return {1e-9 * static_cast<double>(m.run(setting).evaluations), 0};
}

Choice chosen(const std::string& exercise, const AskedNeed& asked,
              const std::vector<std::string>& parameters = {}) {
  const Task task = task_of(exercise, parameters);
  return choose(task, need_of(task, asked), tables(), counted);
}

/// A need by a criterion, at its error, over a horizon in the scene's unit of time.
AskedNeed asked_by(const std::string& criterion, const std::string& error, const std::string& horizon) {
  AskedNeed asked;
  asked.criterion = criterion;
  asked.error = error;
  asked.horizon = horizon;
  return asked;
}

Quantity motion_of(const std::string& exercise, const Horizon& horizon, const Reference& truth) {
  const Entry& entry = entry_of(exercise);
  return motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), horizon, truth);
}

double off(Criterion criterion, const Quantity& seen, const Method& method, double setting,
           const TrueEnergy* energy = nullptr) {
  const Trial trial = run(seen, method, setting);
  return off_by(criterion, seen, method, trial, trial.errors, energy).error;
}

const Method& required(const Quantity& seen, std::string_view model, std::string_view algorithm) {
  const Method* found = method_of(seen, model, algorithm);
  REQUIRE(found);
  return *found;
}

/// A model with the right path must satisfy all laws of its scene.
void keeps_its_laws(const Entry& entry) {
  const Scene& scene = *entry.exercise.scene;
  const Quantity seen = motion(scene, Parameters(entry.exercise.parameters),
                               {scene.horizon / 4, 1, 32 / scene.horizon}, tables());
  if (!seen.energy && !seen.off) return;
  const TrueEnergy energy = seen.energy ? true_energy(seen) : TrueEnergy{};
  if (seen.energy) CHECK(energy.known_to < 1e-7);
  for (const Method& m : seen.methods) {
    const bool is_fine = m.algorithm == "Fehlberg 7(8)" || m.resolution.settings.size() == 1;
    if (!is_fine || m.expected != Outcome::ok) continue;
    const double setting = m.algorithm == "Fehlberg 7(8)" ? 1e-12 : m.resolution.settings.back();
    INFO(m.model << " by " << m.algorithm);
    if (seen.energy) {
      CHECK(m.places_and_rates);
      CHECK(off(Criterion::energy, seen, m, setting, &energy) < 1e-6);
    }
    if (seen.off) CHECK(off(Criterion::constraint, seen, m, setting) < 1e-6);
  }
}

[[maybe_unused]] const bool registered = [] {
  for (const Entry& entry : registry())
    if (entry.exercise.scene)
      register_test([&entry] { keeps_its_laws(entry); },
                    to_string(entry.number) +
                        ": a model with the right path has the true energy and keeps its constraint",
                    "[criterion][" + to_string(entry.number) + "]");
  return true;
}();

}  // namespace

TEST_CASE("a straight tangent leaves its wire, though the model has no constraint", "[criterion]") {
  const Quantity seen = motion_of("3.7", {10, 1, 60}, tables());
  const Method& tangent = required(seen, "straight tangent", "closed form");
  CHECK_FALSE(tangent.off_constraint);
  CHECK(off(Criterion::constraint, seen, tangent, 0) > 0.066);
  const Choice held = chosen("3.7", asked_by("constraint", "0.139mm", "2"));
  REQUIRE(held.chosen);
  CHECK(held.chosen->model != "straight tangent");
}

TEST_CASE("in float redundant coordinates have the same constraint as in double", "[criterion]") {
  for (const std::string exercise : {"3.5", "3.23"}) {
    const Quantity seen = motion_of(exercise, {10, 1, 60}, tables());
    const Method &in_double = required(seen, "Cartesian with constraint", "explicit Euler"),
                 &single = required(seen, "Cartesian with constraint", "explicit Euler in float");
    REQUIRE(single.off_constraint);
    const double step = 1.0 / 60;
    CHECK(in_double.off_constraint(step) > 0.1);
    CHECK(near(single.off_constraint(step), in_double.off_constraint(step), 1e-2));
  }
}

TEST_CASE("a true energy is constant where nothing takes any, and known everywhere", "[criterion]") {
  for (const Entry& entry : registry()) {
    if (!of_the_book(entry.number) || !entry.exercise.scene || !entry.exercise.scene->laws.energy) continue;
    const std::string number = to_string(entry.number);
    INFO(number);
    const TrueEnergy energy = true_energy(motion_of(number, {2, 1, 30}, tables()));
    CHECK(energy.known_to < 1e-9);
    const bool is_driven = number == "3.15" || number == "3.35",
               rubs = number == "3.9" || number == "3.21" || number == "3.31";
    const auto [least, most] = std::ranges::minmax(energy.whole);
    if (!is_driven && !rubs) CHECK(most - least <= 1e-9 * energy.moves);
    if (rubs) CHECK(std::ranges::is_sorted(energy.whole, std::greater<>()));
  }
}

TEST_CASE("a top's energy is the whole one, whatever a model itself conserves", "[criterion]") {
  const Quantity seen = motion_of("3.33", {10, 1, 30}, tables());
  const TrueEnergy energy = true_energy(seen);
  const Method& momentum = required(seen, "axis and angular momentum", "Runge-Kutta 4");
  const double error = off(Criterion::energy, seen, momentum, 1.0 / 30, &energy);
  CHECK(momentum.run(1.0 / 30).drift < 1e-4);
  CHECK(near(error, 7.9e-3, 2e-4));  // relative to the kinetic energy; as tests/questions measures it
}

TEST_CASE("a growing swing does not meet a need by its period", "[criterion]") {
  const auto swing = [](double growth) {
    std::vector<double> x;
    for (int k = 1; k <= 600; ++k)
      x.push_back(std::exp(growth * k / 600) * std::cos(2 * std::numbers::pi * k / 60));
    return Value(std::move(x));
  };
  Quantity seen{"x", "m", "", {"by hand", swing(0)}, 1e-16, {0.1, ""}};
  seen.samples = 600;
  CHECK(off_by_observed(Criterion::period, seen, swing(0.05), {}).error < 1e-3);
  const Off grown = off_by_observed(Criterion::period, seen, swing(0.8), {});
  CHECK(std::isinf(grown.error));
  CHECK(grown.why.find("its swing is 2.2 times the true one") == 0);
  CHECK(std::isinf(off_by_observed(Criterion::period, seen, swing(-0.8), {}).error));
}

TEST_CASE("a bounded motion stays within ten times the true motion's size", "[criterion]") {
  Quantity seen{"x", "m", "", {"by hand", Value{1, -2}}, 1e-16, {0.1, ""}};
  seen.samples = 2;
  CHECK(off_by_observed(Criterion::bounded, seen, Value{20, 0}, {}).error == 1);
  CHECK(off_by_observed(Criterion::bounded, seen, Value{0, -30}, {}).error == 1.5);
  Choice choice;
  choice.need.criterion = Criterion::bounded;
  Candidate candidate;
  candidate.by[Criterion::bounded] = 1;
  CHECK(shown_errors(candidate, choice) == "bounded");
  candidate.by[Criterion::bounded] = 1.5;
  CHECK(shown_errors(candidate, choice) == "not bounded");
}

TEST_CASE("an energy error below the known accuracy is refused", "[criterion]") {
  CHECK(complaint([] { chosen("3.5", asked_by("energy", "1e-24", "1")); }).find("energy is known to") !=
        std::string::npos);
  CHECK(complaint([] {
          chosen("2.7", asked_by("energy", "0.01", "1"));
        }).find("do not determine an energy") != std::string::npos);
}

TEST_CASE("a step out of range is refused with the scene's unit of time", "[criterion][is_enough]") {
  AskedNeed asked;
  asked.error = "0.01";
  asked.method = "semi-implicit Euler@60Hz";
  const Task task = task_of("3.3", {});
  const Need need = need_of(task, asked);
  CHECK(complaint([&] { method_of(task, asked, need); }).find("time is in yr: a step is @60/yr or @1/60") !=
        std::string::npos);
  asked.method = "semi-implicit Euler@60/yr";
  CHECK(near_ulps(method_of(task, asked, need).setting, 1.0 / 60, 64));
}

TEST_CASE("a period or a constraint error below the known accuracy is refused", "[criterion]") {
  AskedNeed asked = asked_by("path", "1cm", "4");
  asked.only = {"angle about the axis"};
  asked.constraint = "1e-20m";
  CHECK(complaint([&] { chosen("3.13", asked); }).find("constraints are known to") == 0);
  asked.constraint = "";
  asked.period = "1e-20";
  CHECK(complaint([&] {
          chosen("3.13", asked);
        }).find("relative to its size; the requested error of the period") != std::string::npos);
}

TEST_CASE("several criteria must hold at once, and the worst of them decides", "[criterion]") {
  AskedNeed asked;
  asked.error = "0.5deg";
  asked.horizon = "4";
  asked.only = {"Cartesian"};
  const Choice path = chosen("3.5", asked);
  asked.constraint = "1e-6mm";
  asked.energy = "1%";
  const Choice both = chosen("3.5", asked);
  REQUIRE(path.chosen);
  REQUIRE(both.chosen);
  CHECK(both.chosen->evaluations_per_frame > path.chosen->evaluations_per_frame);
  CHECK(both.chosen->by.at(Criterion::constraint) <= 1e-9);
  CHECK(both.chosen->by.at(Criterion::energy) <= 0.01);
  CHECK(asked_text(both).find("with its energy right to 1 %") != std::string::npos);
  CHECK(choice_json(both).find("\"also\"") != std::string::npos);
  CHECK(choice_csv(both).find("energy [1]") != std::string::npos);
  asked.criterion = "energy";
  asked.error = "1%";
  CHECK(complaint([&] { chosen("3.5", asked); }).find("--energy: --criterion selects this measure already") ==
        0);
}

TEST_CASE("a criterion that a useless motion would meet comes with a warning first", "[criterion]") {
  AskedNeed asked = asked_by("constraint", "1mm", "10");
  asked.starts = "1";
  const Choice swing = chosen("3.5", asked, {"a=60deg"});
  REQUIRE(swing.chosen);
  CHECK(answer_text(swing).find("By constraint alone this motion holds, but its path is off by") == 0);
}

TEST_CASE("the column of errors shows the criterion's own", "[criterion]") {
  AskedNeed asked = asked_by("energy", "1%", "2");
  asked.only = {"Runge-Kutta 4"};
  const Choice choice = chosen("3.33", asked);
  CHECK(choice_csv(choice).find("setting,error [1],path [rad],holds") != std::string::npos);
}

TEST_CASE("exact closed forms are candidates by their energy", "[criterion]") {
  AskedNeed asked = asked_by("energy", "1%", "5");
  asked.only = {"closed form"};
  const Choice choice = chosen("3.9", asked);
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->algorithm == "closed form");
}

TEST_CASE("a model that its scene's page shows to be wrong is not chosen", "[criterion]") {
  AskedNeed asked;
  asked.error = "0.1m";
  asked.horizon = "1";
  asked.starts = "1";
  asked.only = {"two angles as published"};
  const Choice none = chosen("3.17", asked, {"omega=0.001"});
  CHECK_FALSE(none.chosen);
  CHECK_FALSE(none.nearest_miss);
  CHECK_FALSE(none.on_asked);
  CHECK(choice_text(none, true).find("its page shows it wrong") != std::string::npos);
  CHECK(choice_text(none, true).find("holds here, but the scene's page shows that it is wrong") !=
        std::string::npos);
}

TEST_CASE("a model that its page shows to be wrong makes no method good enough", "[criterion][is_enough]") {
  AskedNeed asked;
  asked.error = "0.1m";
  asked.horizon = "1";
  asked.starts = "1";
  asked.method = "RK4@60Hz";
  const Task task = task_of("3.17", {"omega=0.001"});
  const Need need = need_of(task, asked);
  const Price price = [](const Method& m, double setting) { return counted(m, setting); };
  const IsEnough found = is_enough(task, need, method_of(task, asked, need), tables(), price);
  CHECK(found.models.size() > 1);
  CHECK_FALSE(found.models.front().faulted);
  CHECK(found.models.back().faulted);
  CHECK(is_enough_text(found).find("two angles as published, which its page shows to be wrong: holds") !=
        std::string::npos);
}

TEST_CASE("a model of the book that its page shows to be wrong is known as such", "[criterion]") {
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    const Scene& scene = *entry.exercise.scene;
    for (const Method& m : motion_of(to_string(entry.number), {scene.horizon}, Reference::nothing()).methods)
      if (is_published(m.model)) {
        INFO(to_string(entry.number) << ": " << m.model);
        CHECK(std::ranges::find(scene.faulted, m.model) != scene.faulted.end());
      }
  }
}

TEST_CASE("starts next to an ellipse are ellipses, and omissions are reported", "[criterion]") {
  AskedNeed asked;
  asked.error = "0.01";
  asked.horizon = "1";
  asked.only = {"Kepler"};
  const Choice choice = chosen("3.3", asked, {"r0=1", "r0_dot=0", "theta0=0", "theta0_dot=8.4"});
  REQUIRE(choice.chosen);
  CHECK(choice.seen.size() == 3);
  REQUIRE(choice.left_out.contains("a hyperbola"));
  CHECK(choice_text(choice, false).find("nearby whose motion is a hyperbola") != std::string::npos);
}

TEST_CASE("a neighbouring start without two periods is left out, and drawn again", "[criterion]") {
  AskedNeed asked = asked_by("period", "0.01", "10");
  asked.frames_per_second = "144";
  asked.only = {"Kepler"};
  const Choice choice = chosen("3.3", asked, {"M=1.05215", "theta0_dot=8.43"});
  REQUIRE(choice.chosen);
  CHECK(choice.left_out.contains("without two periods within the horizon"));
  CHECK(choice.seen.size() > 1);
  asked.horizon = "3";
  CHECK(complaint([&] {
          chosen("3.3", asked, {"M=1.05215", "theta0_dot=8.43"});
        }).find("no two periods") != std::string::npos);
}

TEST_CASE("a linear motion is not chaotic, over any horizon", "[criterion]") {
  AskedNeed asked;
  asked.error = "1cm";
  asked.horizon = "15";
  CHECK_FALSE(chosen("3.19", asked).predictable);
}

TEST_CASE("the share of starts that hold in chaos has its confidence interval", "[criterion]") {
  Choice choice;
  choice.tried_in_chaos = choice.holding_in_chaos = 3;
  CHECK(near(choice.share_in_chaos().first, 0.4385, 1e-3));
  CHECK(near(choice.share_in_chaos().second, 1.0, 1e-9));
  choice.tried_in_chaos = 10;
  choice.holding_in_chaos = 5;
  CHECK(near(choice.share_in_chaos().first, 0.2366, 1e-3));
  CHECK(near(choice.share_in_chaos().second, 0.7634, 1e-3));
}
