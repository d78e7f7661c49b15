// Errors in an exercise's parameters that the compiler misses: two of them exchanged in the models, or one
// that nothing uses.

#include <algorithm>

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "report/study/letters.hpp"
#include "report/study/settings.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

constexpr Parameter pulleys[] = {
    {"I1", 1, "1", ""}, {"L1", 1, "m", ""}, {"L2", 1, "m", ""}, {"K1", 1, "", ""}};

std::string exchanged(const std::string& members) {
  return exchanged_letters(
      "template <class T>\nstruct Given {\n" + members + "\n  T h() const { T K1, I1; }\n};\n", pulleys);
}

/// A motion x = a t, and a parameter b that nothing uses.
constexpr Parameter of_a_line[] = {{"a", 1, "m/s", "", 0, 10}, {"b", 2, "m", "", 0, 10}};

struct Line {
  double a;
  std::array<double, 1> at(double t) const { return {a * t}; }
};

Quantity line(const Parameters& p, const Horizon& horizon, const Reference&) {
  Quantity x;
  SceneMethods(x, horizon, halving("step", 1, 2), tolerances()).closed_form("line", Line{p["a"]});
  return x;
}

}  // namespace

TEST_CASE("letters of Given in another order than the parameters' are detected", "[parameters]") {
  CHECK(exchanged("  T I1, L1, L2, K1;") == "");
  CHECK(exchanged("  T I1, L2, L1, K1;") == "L2 before L1");
  CHECK(exchanged("  T I1;\n  T other, K1;\n  std::array<T, 2> L;") == "K1 before L1");
  CHECK(exchanged("  T I1;\n  std::array<T, 2> L;\n  T K1;") == "");
  CHECK(exchanged_letters("no models", pulleys) == "");
}

TEST_CASE("no scene's letters are exchanged", "[parameters]") {
  for (const Entry& e : registry()) {
    INFO(to_string(e.number));
    CHECK(exchanged_letters(e) == "");
  }
  Entry two_pulleys = *std::ranges::find(registry(), Number{3, 19}, &Entry::number);
  std::vector<Parameter> exchanged(two_pulleys.exercise.parameters.begin(),
                                   two_pulleys.exercise.parameters.end());
  const auto named = [&](std::string_view name) {
    return std::ranges::find(exchanged, name, &Parameter::name);
  };
  std::iter_swap(named("L1"), named("L2"));
  two_pulleys.exercise.parameters = exchanged;
  CHECK(exchanged_letters(two_pulleys) == "L1 before L2");
}

TEST_CASE("every quantity of the book has its table's unit, and another unit is detected", "[parameters]") {
  const Reference truth(source_folder() / "reference");
  for (const Entry& e : registry())
    if (e.exercise.scene)
      CHECK(other_units(e, {{}, {motion(*e.exercise.scene, Parameters(e.exercise.parameters), truth)}}) ==
            std::vector<std::string>());
  const Entry& pendulum = *std::ranges::find(registry(), Number{3, 5}, &Entry::number);
  const Parameters parameters(pendulum.exercise.parameters);
  Findings found{{}, {motion(*pendulum.exercise.scene, parameters, truth)}};
  for (Quantity& q : found.quantities) {
    q.norms.clear();
    q.unit = "deg";
  }
  CHECK(other_units(pendulum, found).back() == "swing is in deg, its table 03_05_swing in rad");
}

TEST_CASE("a parameter that nothing uses is detected", "[parameters]") {
  Scene scene;
  scene.motion = line;
  scene.horizon = 1;
  const Entry entry{
      {20, 1}, "", {"Line", "", of_a_line, scene, [](const Parameters& p, const Reference& truth) {
                      return Findings{{}, {line(p, {1}, truth)}};
                    }}};
  CHECK(unused_parameters(entry, Reference::nothing()) == std::vector<std::string>{"b"});
}

TEST_CASE("every parameter of every exercise is used", "[parameters]") {
  const Reference truth(source_folder() / "reference");
  for (const Entry& e : registry()) {
    INFO(to_string(e.number));
    std::vector<std::string> unused;
    // Off-diagonal numbers do not change a triangular matrix's determinant, as 7.11 shows.
    if (e.number == Number{7, 11}) unused = {"u12", "u13", "u14", "u23", "u24", "u34"};
    CHECK(unused_parameters(e, truth) == unused);
  }
}
