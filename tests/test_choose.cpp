// Choosing, on a made-up scene whose truth is a = x(t) for all t and whose methods err by known amounts.

#include <cmath>

#include "reference/bad_input.hpp"
#include "report/choose.hpp"
#include "tests/catch.hpp"
#include "tests/complaint.hpp"

using namespace oddity;

namespace {

constexpr Parameter parameters[] = {{"a", 1, "m", "where it stays", 0, 10}};

/// x = a (1 + error), of that many evaluations.
Method method(std::string model, std::string algorithm, Knob knob, double a,
              std::function<double(double)> error, std::function<long(double)> evaluations) {
  return {std::move(model), std::move(algorithm), std::move(knob), [=](double setting) {
            return Answer{Value(a * (1 + error(setting))), evaluations(setting)};
          }};
}

/// "coarse": off by a tenth of (a - 1). "stepping": off by its step. "rich": right, at a hundred evaluations.
Quantity motion(const Parameters& p, const Horizon& horizon, const Reference&) {
  const double a = p["a"];
  Quantity q{"place", "m", "", {"exact", a}, 1e-16, {1e-6, ""}, {}, {}};
  const auto one = [](double) { return 1L; };
  q.add(method(
      "coarse", "closed form", no_knob(), a, [a](double) { return std::abs(a - 1) / 10 + 1e-4; }, one));
  q.add(method(
      "stepping", "explicit", halving("step", 1, 4), a, [](double h) { return h; },
      [=](double h) { return std::lround(horizon.end / h); }));
  q.add(method(
      "rich", "everything", tolerances(), a, [](double e) { return e * 1e-4 + 1e-14; },
      [](double e) { return std::lround(-100 * std::log10(e)); }));
  q.add({"absent", "raises", no_knob(), [](double) -> Answer { throw std::runtime_error("not here"); }});
  return q;
}

const Entry entry{
    {3, 99}, "", {"made up", "", parameters, Scene{motion, 10, 0.01, "a", {1, 2}, {"a"}}, nullptr}};

double counted_cost(const Method&, double, const Trial& trial) {
  return static_cast<double>(trial.answer.evaluations) * 1e-9;
}

Choice choose_for(const Need& need, double a = 1) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Task task(entry);
  task.parameters.set("a", a);
  return choose(task, need, truth, counted_cost);
}

}  // namespace

TEST_CASE("the cheapest method that holds is chosen, and tested elsewhere", "[choose]") {
  const Choice choice = choose_for({0.05, false, 10, 10});
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "coarse");
  CHECK(choice.chosen->evaluations_a_frame == 0.01);
  CHECK(choice.margin() > 1);
  CHECK(choice.seen.size() == 3);
  CHECK(choice.unseen.size() == 3);
  CHECK(choice.seen != choice.unseen);
  CHECK_FALSE(choice.next_cheaper);
  REQUIRE(choice.next_richer);
  CHECK(choice.next_richer->model == "rich");
}

TEST_CASE("a coarse model that fails beside the start asked for is not chosen", "[choose]") {
  const Choice choice = choose_for({0.005, false, 1, 10});
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "rich");
  REQUIRE(choice.next_cheaper);
  CHECK(choice.next_cheaper->model == "stepping");
  CHECK(choice.next_cheaper->outcome == Outcome::inaccurate);
}

TEST_CASE("steps divide the frame, and the first that holds is taken", "[choose]") {
  const Choice choice = choose_for({0.06, false, 0.1, 10}, 5);
  const auto stepping = std::ranges::find(choice.tried, "stepping", &Tried::model);
  REQUIRE(stepping != choice.tried.end());
  CHECK(stepping->holds());
  CHECK(std::round(1 / (stepping->setting * 10)) == 10);
}

TEST_CASE("a need relative to the motion is the same at any size", "[choose]") {
  for (double a : {1.0, 8.0}) {
    const Choice choice = choose_for({2e-8, true, 10, 10}, a);
    REQUIRE(choice.chosen);
    CHECK(choice.chosen->model == "rich");
    CHECK(choice.chosen->setting == 1e-4);
  }
}

TEST_CASE("a need that nothing meets is said, with the nearest miss", "[choose]") {
  const Choice poor = choose_for({1e-9, false, 10, 10, 1e-9});
  CHECK_FALSE(poor.chosen);
  REQUIRE(poor.nearest_miss);
  CHECK(poor.nearest_miss->holds());
  CHECK(poor.nearest_miss->seconds_a_frame > 1e-9);
  CHECK(choice_text(poor).find("times the budget") != std::string::npos);

  const Choice impossible = choose_for({1e-15, false, 10, 10});
  CHECK_FALSE(impossible.chosen);
  REQUIRE(impossible.nearest_miss);
  CHECK(impossible.nearest_miss->model == "rich");
  CHECK(choice_text(impossible).find("Nothing here meets that") != std::string::npos);
}

TEST_CASE("what cannot be chosen for is refused", "[choose]") {
  CHECK(complaint([] { choose_for({0}); }).find("the error must be positive") != std::string::npos);
  CHECK(complaint([] {
          choose_for({0.1, false, 1e-3, 10});
        }).find("shorter than a frame") != std::string::npos);
  CHECK(complaint([] { choose_for({1e-30}); }).find("known to") != std::string::npos);
  const Entry still{{7, 99}, "", {"still", "", parameters, {}, nullptr}};
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  CHECK(complaint([&] { choose(Task(still), {0.1}, truth); }).find("has no motion") != std::string::npos);
}
