// Cost of lanes: `bench --lanes` and `choose --bodies`, without the clock.

#include "extras/bench/lanes.hpp"
#include "extras/lanes/price.hpp"
#include "report/pages/choose_view.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

LanesResult measured(lanes::Registers registers, std::string algorithm, double share,
                     std::size_t same = 512) {
  return {"3.5", "one angle",  std::move(algorithm), Precision::in_double, registers,
          4,     {4e-8, 1e-9}, {1e-8, 1e-10},        {share, 0.01},        0.9,
          512,   same};
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Method method_of(std::string model, std::string algorithm, Precision precision = Precision::in_double) {
  Method method{
      std::move(model), std::move(algorithm), {"step", {1.0 / 60}}, [](double) { return Answer{}; }};
  method.precision = precision;
  return method;
}

}  // namespace

TEST_CASE("a limit on the share of the width holds or is broken by more than its spread, and by a single bit",
          "[lanes]") {
  const auto of = [](double share, std::size_t same = 512) {
    return measured(lanes::Registers::avx2, "Runge-Kutta 4", share, same);
  };
  CHECK(of(0.92).holds());
  CHECK_FALSE(of(0.905).holds());
  CHECK_FALSE(of(0.905).broken());
  CHECK(of(0.88).broken());
  CHECK(of(0.92, 511).broken());
  const auto by_every_processor = [](double share, std::size_t same = 512) {
    return measured(lanes::Registers::baseline, "Runge-Kutta 4", share, same);
  };
  CHECK_FALSE(by_every_processor(0.3).broken());
  CHECK_FALSE(by_every_processor(0.3).holds());
  CHECK(by_every_processor(0.92, 511).broken());
  CHECK(to_csv(lanes_table({lanes::Registers::avx2, {by_every_processor(0.3)}})).find(",not asked,512,512") !=
        std::string::npos);
  CHECK(LanesBench{lanes::Registers::avx2, {of(0.92), of(0.88)}}.broken());
  CHECK_FALSE(LanesBench{lanes::Registers::avx2, {of(0.92), of(0.905)}}.broken());
}

TEST_CASE(
    "where a wider register's instructions take longer, its lanes must reach the measured arithmetic only",
    "[lanes]") {
  using lanes::Registers;
  const ArithmeticResult whole{
      Registers::avx2, Precision::in_double, 4, {{4.1, 0.1}, {4, 0.1}, {3, 0.1}, {3, 0.1}}};
  const ArithmeticResult half{
      Registers::avx512, Precision::in_double, 8, {{3.9, 0.1}, {4, 0.1}, {3.5, 0.1}, {4.3, 0.1}}};
  CHECK(whole.ceiling() == 1);
  CHECK(near(half.ceiling(), 0.55, 1e-12));
  LanesResult r = measured(Registers::avx512, "Runge-Kutta 4", 0.6);
  CHECK(r.broken());
  r.ceiling = half.ceiling();
  CHECK_FALSE(r.holds());
  CHECK(r.holds_of_arithmetic());
  CHECK_FALSE(r.broken());
  r.share.median = 0.4;
  CHECK(r.broken());
  const std::string view = lanes_view({Registers::avx512, {r}, {half}});
  INFO(view);
  CHECK(has(view, "AVX-512: adds 3.9, multiplies 4, divides 3.5, roots 4.3 at once, of 8 doubles"));
}

TEST_CASE("the view of lanes counts the limits that hold, and the equal bits", "[lanes]") {
  using lanes::Registers;
  const LanesBench bench{
      Registers::avx512,
      {measured(Registers::avx2, "Runge-Kutta 4", 1.25), measured(Registers::avx512, "Runge-Kutta 4", 0.5),
       measured(Registers::avx2, "Dormand-Prince 5(4)", 1.5),
       measured(Registers::avx512, "Dormand-Prince 5(4)", 0.95, 500)}};
  const std::string view = lanes_view(bench);
  INFO(view);
  CHECK(has(view, "10 ns, 1.2 +- 0.01"));
  CHECK(has(view, "500 of 512"));
  CHECK(has(view, "Taken on this machine: AVX-512."));
  CHECK(has(view, "AVX2, fixed steps: a share of at least 0.9 in 1 of 1"));
  CHECK(has(view, "AVX-512, fixed steps: a share of at least 0.9 in 0 of 1"));
  CHECK(has(view, "2036 of 2048 bodies have the bits"));
  const std::string csv = to_csv(lanes_table(bench));
  CHECK(has(csv, "Runge-Kutta 4,double,AVX2,4,no,"));
  CHECK(has(csv, "Runge-Kutta 4,double,AVX-512,4,yes,"));
  CHECK(has(csv, ",BROKEN,512,500"));
  CHECK(has(csv, ",holds,512,512"));
}

TEST_CASE("every model with steps is in the benchmark of lanes, and every body has the bits of a single one",
          "[lanes]") {
  const LanesBench bench = bench_lanes({"3.5"}, 1);
  const std::size_t kinds = 1 + lanes::can(lanes::Registers::avx2) + lanes::can(lanes::Registers::avx512);
  CHECK(bench.taken == lanes::widest());
  CHECK(bench.results.size() == 12 * kinds);  // four algorithms and two, in two precisions
  for (const LanesResult& r : bench.results) {
    INFO(r.model << ", " << r.algorithm << ", " << lanes::name_of(r.registers));
    CHECK(r.same == r.bodies);
    CHECK(r.in_lanes.median > 0);
  }
}

TEST_CASE("lanes have the models without events by some algorithms", "[lanes]") {
  const auto in_lanes = [](const char* scene, const char* model, const std::string& algorithm) {
    return lanes::registers_of(scene, model, algorithm).has_value();
  };
  CHECK(lanes::registers_of("3.5", "one angle", "Runge-Kutta 4") == lanes::widest());
  CHECK(in_lanes("3.5", "one angle", in_float("velocity Verlet")));
  CHECK(in_lanes("3.5", "one angle", "Dormand-Prince 5(4)"));
  CHECK(in_lanes("3.5", "Cartesian with constraint", "Runge-Kutta 4"));
  CHECK_FALSE(in_lanes("3.5", "Cartesian with constraint", "velocity Verlet"));
  CHECK_FALSE(in_lanes("3.5", "one angle", "Adams-Bashforth 4"));
  CHECK_FALSE(in_lanes("3.5", "small angle", "closed form"));
  CHECK_FALSE(in_lanes("3.31", "stopped by event", "Runge-Kutta 4"));
  CHECK_FALSE(in_lanes("3.1", "one angle", "Runge-Kutta 4"));
}

TEST_CASE("a batch has a price, in lanes and one body after the other", "[lanes]") {
  const Task task(*std::ranges::find(registry(), exercise_number("3.5"), &Entry::number));
  Need need{.error = 1};
  need.horizon = 0.1;
  need.bodies = 100;
  const Price price = lanes::price_of_all(task, need);
  for (const char* algorithm : {"Runge-Kutta 4", "Dormand-Prince 5(4)", "Adams-Bashforth 4"}) {
    const Time time = price(method_of("one angle", algorithm), 1e-3);
    INFO(algorithm);
    CHECK(time.seconds > 0);
    CHECK(time.spread >= 0);
  }
  CHECK(price(method_of("one angle", in_float("Runge-Kutta 4"), Precision::in_float), 1e-3).seconds > 0);
}

TEST_CASE("the choice lists how many bodies run in lanes", "[lanes]") {
  Choice choice;
  choice.exercise = "3.5", choice.time_unit = "s";
  choice.need.bodies = 10000;
  choice.chosen.emplace();
  choice.chosen->model = "one angle", choice.chosen->algorithm = "Runge-Kutta 4";
  choice.chosen->seconds_per_frame = 1e-4;
  choice.registers = lanes::bodies_in_lanes().registers(choice);
  const std::string text = answer_text(choice), json = choice_json(choice);
  INFO(text << json);
  CHECK(has(text, "10000 bodies: side by side in lanes of " + std::string(lanes::name_of(lanes::widest())) +
                      ", 10 ns and no state each"));
  CHECK(has(json, "\"bodies\": 10000"));
  CHECK(has(json, "\"lanes\": \"" + std::string(lanes::name_of(lanes::widest())) + "\""));
  choice.chosen->algorithm = "Adams-Bashforth 4";
  choice.registers = lanes::bodies_in_lanes().registers(choice);
  CHECK(has(answer_text(choice), "10000 bodies: one after the other"));
  CHECK(has(choice_json(choice), "\"lanes\": null"));
  choice.need.bodies = 1;
  CHECK_FALSE(has(answer_text(choice), "bodies"));
}
