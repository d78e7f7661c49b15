// The book's scenes as problems' files: a file's motions, errors, outcomes and answers are those of the same
// scene in C++.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "chapters/scene.hpp"
#include "problem/scene.hpp"
#include "reference/text.hpp"
#include "report/cli/new_exercise.hpp"
#include "report/study/choose.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

/// A scene, the models that its file also has, and other parameters to try.
struct Twin {
  std::string number;
  std::vector<std::string> models;
  std::vector<std::pair<std::string, double>> other;
};

const std::vector<Twin>& twins() {
  static const std::vector<Twin> all{
      {"3.5", {"one angle", "Cartesian with constraint"}, {{"a", 2.5}}},
      {"3.7", {"one coordinate", "Cartesian with constraints"}, {{"q0", 0.75}}},
      {"3.9", {"plane", "plane, with the work"}, {{"a", 4}, {"c", 9}}},
      {"3.11", {"height field", "Cartesian with constraint"}, {{"factor", 0.5}, {"a2", 1.5}}},
      {"3.13",
       {"angle about the axis", "Cartesian with constraint", "small angle"},
       {{"phi", 0.5}, {"u", 0.25}}},
      {"3.17", {"two angles", "Cartesian with constraint"}, {{"omega", 0.25}, {"theta_dot", 3}}},
      {"3.19", {"two coordinates"}, {{"c1", 160}, {"y3", 2}}},
      {"3.21", {"one angle", "two angles"}, {{"phi", 0.5}, {"k", 0.5}}},
      {"3.23",
       {"one angle", "Cartesian with constraint", "small oscillation"},
       {{"theta0", 0.1}, {"c", 200}}},
      {"3.25", {"dense mass matrix"}, {{"theta1", 0.5}, {"m2", 2}}},
      {"3.27", {"two bodies", "(r, u, phi)"}, {{"phi0_dot", 1}, {"m2", 0.5}}},
      {"3.29", {"x, y, theta", "center alone", "free fall"}, {{"w", 3}, {"q", 2}}},
      {"3.33", {"one angle, precession by quadrature", "Euler angles"}, {{"dpsi", 20}, {"phi", 0.75}}}};
  return all;
}

const Entry& own_of(const Twin& twin) {
  static std::map<std::string, const Entry*> read;
  const Entry*& entry = read[twin.number];
  if (!entry) entry = &problem::entry_of_text(twin.number + ".toml", std::string(scene_as_file(twin.number)));
  return *entry;
}
const Entry& book_of(const Twin& twin) {
  return *std::ranges::find(registry(), exercise_number(twin.number), &Entry::number);
}
Reference tables() { return Reference(std::filesystem::path(ODDITY_SOURCE) / "reference"); }

/// A model's algorithms in double.
std::set<std::string> algorithms(const Quantity& of, const std::string& model) {
  std::set<std::string> all;
  for (const Method& method : of.methods)
    if (method.model == model) all.insert(method.algorithm);
  return all;
}

}  // namespace

TEST_CASE("Each scene with a file has the parameters, the horizon and the observables of its exercise",
          "[problem][scenes]") {
  CHECK(twins().size() >= 12);
  CHECK(twins().size() == embedded_scenes().size());
  for (const Twin& twin : twins()) {
    INFO(twin.number);
    const Entry &own = own_of(twin), &book = book_of(twin);
    CHECK(own.exercise.title == book.exercise.title);
    for (const Parameter& p : own.exercise.parameters) {
      INFO(p.name);
      const auto theirs = std::ranges::find(book.exercise.parameters, p.name, &Parameter::name);
      REQUIRE(theirs != book.exercise.parameters.end());
      CHECK(p.value == theirs->value);
      CHECK(p.unit == theirs->unit);
      CHECK(p.least == theirs->least);
      CHECK(p.most == theirs->most);
    }
    const Scene &mine = *own.exercise.scene, &theirs = *book.exercise.scene;
    CHECK(mine.horizon == theirs.horizon);
    CHECK(mine.axes.observables == theirs.axes.observables);
    CHECK(mine.sweep_parameter == theirs.sweep_parameter);
    CHECK(mine.sweep_values == theirs.sweep_values);
    CHECK(mine.perturbed_parameters == theirs.perturbed_parameters);
  }
}

TEST_CASE("A scene's file has its motion to twelve digits, and its methods' errors and outcomes",
          "[problem][scenes]") {
  const Reference truth = tables();
  for (const Twin& twin : twins())
    for (const bool other : {false, true}) {
      const Entry &own = own_of(twin), &book = book_of(twin);
      Parameters own_p(own.exercise.parameters), book_p(book.exercise.parameters);
      if (other)
        for (const auto& [name, value] : twin.other) own_p.set(name, value), book_p.set(name, value);
      const Horizon horizon{std::min(own.exercise.scene->horizon, 4.0), 1, 16};
      const Quantity theirs = motion(*book.exercise.scene, book_p, horizon, truth);
      Quantity mine = motion(*own.exercise.scene, own_p, horizon, truth);
      INFO(twin.number << (other ? ", other parameters" : ""));
      REQUIRE(mine.reference.value.size() == theirs.reference.value.size());
      CHECK(distance(mine.reference.value, theirs.reference.value) <=
            1e-12 * std::max(1.0, size_of(theirs.reference.value)));
      mine.need = theirs.need;
      mine.needs = theirs.needs;
      int compared = 0;
      for (const std::string& model : twin.models)
        for (const Method& method : mine.methods) {
          if (method.model != model) continue;
          const Method* same = method_of(theirs, method.model, method.algorithm);
          if (!same) continue;
          ++compared;
          for (const std::size_t place :
               {method.resolution.settings.size() / 4, method.resolution.settings.size() / 2}) {
            const double setting = method.resolution.settings[place];
            const Trial one = run(mine, method, setting), two = run(theirs, *same, setting);
            INFO(method.model << ", " << method.algorithm << ", " << setting);
            CHECK(one.outcome == two.outcome);
            // A Taylor series chooses its steps by the operations, which a file writes in another order.
            // Where a method has lost the motion, roundings grow as well.
            const bool comparable =
                method.algorithm != "Taylor series" && two.error < size_of(theirs.reference.value) / 2;
            if (comparable) CHECK(near(one.error, two.error, 1e-3 * two.error + 1e-10));
          }
        }
      CHECK(compared >= 7);
    }
}

TEST_CASE("A scene's file gets the same answer as its exercise", "[problem][scenes]") {
  const Reference truth = tables();
  // Costs in evaluations, so that no clock decides.
  const Price price = [](const Method& method, double setting) {
    return Time{static_cast<double>(method.run(setting).evaluations), 0};
  };
  int questions = 0;
  for (const Twin& twin : twins()) {
    const Entry &own = own_of(twin), &book = book_of(twin);
    const Horizon few{1, 1};
    const auto mine = algorithms(motion(*own.exercise.scene, Parameters(own.exercise.parameters), few,
                                        Reference::nothing()),
                                 twin.models[0]),
               theirs = algorithms(motion(*book.exercise.scene, Parameters(book.exercise.parameters), few,
                                          Reference::nothing()),
                                   twin.models[0]);
    std::vector<std::string> not_in_both{"in float"};
    for (std::size_t i = 1; i < twin.models.size(); ++i) not_in_both.push_back(twin.models[i]);
    std::ranges::set_symmetric_difference(mine, theirs, std::back_inserter(not_in_both));
    for (const bool other : {false, true})
      for (const double error : {0.02, 1e-3, 1e-5, 1e-7}) {
        Need need{.error = error, .horizon = 2};
        need.only = {twin.models[0]};
        need.exclude = not_in_both;
        need.objective = error == 1e-3 ? Objective::cheapest : Objective::simple;
        Task one(own), two(book);
        if (other)
          for (const auto& [name, value] : twin.other)
            one.parameters.set(name, value), two.parameters.set(name, value);
        const Choice mine_is = choose(one, need, truth, price), theirs_is = choose(two, need, truth, price);
        INFO(twin.number << ", error " << error << (other ? ", other parameters" : ""));
        ++questions;
        REQUIRE(mine_is.chosen.has_value() == theirs_is.chosen.has_value());
        if (!mine_is.chosen) continue;
        CHECK(mine_is.chosen->model == theirs_is.chosen->model);
        CHECK(mine_is.chosen->algorithm == theirs_is.chosen->algorithm);
        CHECK(mine_is.chosen->setting == theirs_is.chosen->setting);
        // In tolerances, to three digits; below that each reference has its own bound, of 1e-12.
        const double size = 1e-3 * theirs_is.chosen->error + 2e-12 / error;
        CHECK(near(mine_is.chosen->error, theirs_is.chosen->error, size));
      }
  }
  CHECK(questions >= 100);
}

TEST_CASE("new writes a scene of the book as a problem's file", "[problem][scenes][commands]") {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "mine.toml").string();
  CHECK(program::run("new --from-exercise 3.7 " + file).status == 0);
  CHECK(text_of(file) == scene_as_file("3.7"));
  CHECK(program::printed("choose " + file + " q0=2m").status == 0);
  const auto none = program::run("new --from-exercise 3.31 " + (scratch.path() / "other.toml").string());
  CHECK(none.status == 2);
  CHECK(program::says(none, "there is one of:"));
  const auto planet = program::run("new --from-exercise 3.3 " + (scratch.path() / "planet.toml").string());
  CHECK(planet.status == 2);
  CHECK(program::says(planet, "there is no file of exercise 3.3; there is one of: 3.5, 3.7, 3.9,"));
  CHECK(program::run("new --from-exercise 3.7 3.2 spring").status == 2);
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "other.toml"));
}
