// The scenes' models in lanes: a body moves as it does alone, to the bit, on each instruction set of this
// machine.

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "chapters/03_rigid_body_motion/03_kepler/models.hpp"
#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "extras/lanes/batch.hpp"
#include "extras/lanes/integrate.hpp"
#include "report/plain/runge_kutta_4.hpp"
#include "report/plain/velocity_verlet.hpp"
#include "report/verify/catch.hpp"
#include "solvers/stop.hpp"

using namespace oddity;
using lanes::Batch, lanes::Fixed, lanes::Registers, lanes::SceneInLanes;

namespace {

constexpr std::size_t bodies = 37;  // not a multiple of any width
constexpr double a_bit = 1e-3;

const Exercise& exercise_of(const SceneInLanes& scene) {
  return std::ranges::find(registry(), exercise_number(scene.number), &Entry::number)->exercise;
}

std::vector<double> parameters_of(const SceneInLanes& scene, std::size_t count = bodies) {
  return lanes::apart(scene, exercise_of(scene).parameters, count, a_bit);
}

std::vector<Registers> wide_ones() {
  std::vector<Registers> all;
  for (Registers r : {Registers::baseline, Registers::avx2, Registers::avx512})
    if (lanes::can(r)) all.push_back(r);
  return all;
}

/// Calls f(scene, model, precision, its batch) for every model in both precisions.
template <class F>
void for_every_model(const F& f) {
  for (const SceneInLanes& scene : lanes::scenes_in_lanes()) {
    const auto names = lanes::model_names(scene);
    for (std::size_t model = 0; model < scene.models; ++model)
      for (Precision precision : {Precision::in_double, Precision::in_float}) {
        INFO(scene.number << ", " << names[model] << ", " << name_of(precision));
        Batch batch(scene, model, precision, parameters_of(scene));
        f(scene, model, precision, batch);
      }
  }
}

/// Number of bodies whose states differ from those of `alone`.
std::size_t different(const Batch& together, const Batch& alone) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < alone.size(); ++i)
    count += !std::ranges::equal(together.state(i), alone.state(i));
  return count;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

template <class Number>
struct OneIsNaN {
  std::size_t ill;
  using State = std::array<Number, 3>;
  void operator()(const State&, State& dxdt, const Number&) const {
    dxdt = {Number(1), Number(1), Number(1)};
    dxdt[ill] = Number(std::numeric_limits<double>::quiet_NaN());
  }
};

}  // namespace

TEST_CASE("the scenes of lanes are those of the book, with their models", "[lanes]") {
  std::set<std::string_view> numbers;
  std::size_t models = 0;
  for (const SceneInLanes& scene : lanes::scenes_in_lanes()) {
    INFO(scene.number);
    CHECK(exercise_of(scene).scene);
    CHECK(exercise_of(scene).parameters.size() >= scene.parameters);
    CHECK(lanes::model_names(scene).size() == scene.models);
    numbers.insert(scene.number);
    models += scene.models;
  }
  CHECK(numbers.size() >= 18);
  CHECK(models >= 86);
  CHECK(lanes::can(Registers::one));
  CHECK(lanes::can(lanes::widest()));
}

TEST_CASE("with fixed steps every body has the same bits in lanes as alone", "[lanes]") {
  constexpr long steps = 8;
  int compared = 0;
  for_every_model([&](const SceneInLanes& scene, std::size_t model, Precision, Batch& batch) {
    const double h = exercise_of(scene).scene->horizon / 200 / steps;
    if (batch.closed_form()) return;
    for (Fixed algorithm : {Fixed::runge_kutta_4, Fixed::velocity_verlet, Fixed::symplectic_euler}) {
      if (!batch.has(algorithm)) continue;
      INFO(lanes::name_of(algorithm));
      Batch alone = batch;
      alone.steps(Registers::one, algorithm, 0, h, steps);
      // A bead let go at rest stays there by its energy equation.
      const bool rests = lanes::model_names(scene)[model] == "energy in q";
      CHECK(different(alone, batch) == (rests ? 0 : bodies));
      for (Registers registers : wide_ones()) {
        INFO(lanes::name_of(registers));
        Batch together = batch;
        together.steps(registers, algorithm, 0, h, steps);
        CHECK(different(together, alone) == 0);
        ++compared;
      }
    }
  });
  CHECK(compared >= 150 * static_cast<int>(wide_ones().size()));
}

TEST_CASE("bodies stay side by side from call to call, and have the same states when observed in between",
          "[lanes]") {
  for_every_model([&](const SceneInLanes&, std::size_t, Precision, Batch& batch) {
    if (batch.closed_form()) return;
    constexpr double h = 1e-3;
    Batch alone = batch, together = batch;
    alone.steps(Registers::one, Fixed::runge_kutta_4, 0, h, 3);
    alone.steps(Registers::one, Fixed::runge_kutta_4, 3 * h, h, 2);
    together.steps(lanes::widest(), Fixed::runge_kutta_4, 0, h, 3);
    CHECK(different(together, batch) == different(alone, batch));
    together.steps(lanes::widest(), Fixed::runge_kutta_4, 3 * h, h, 2);
    CHECK(different(together, alone) == 0);
    for (Batch* one : {&alone, &together}) {  // continues with other steps, and from the start again
      one->steps(Registers::baseline, Fixed::runge_kutta_4, 5 * h, h, 2);
      one->own_steps(Registers::one, 7 * h, 9 * h, 1e-5, h);
      one->steps(lanes::widest(), Fixed::runge_kutta_4, 9 * h, h, 1);
    }
    CHECK(different(together, alone) == 0);
    together.begin_again();
    CHECK(different(together, batch) == 0);
  });
}

TEST_CASE("with variable steps every body has the same bits in lanes as alone", "[lanes]") {
  for_every_model([&](const SceneInLanes& scene, std::size_t, Precision precision, Batch& batch) {
    if (batch.closed_form()) return;
    const double end = exercise_of(scene).scene->horizon / 40;
    const double tolerance = precision == Precision::in_double ? 1e-8 : 1e-4;
    Batch alone = batch;
    std::vector<lanes::Ended> expected, ended;
    const bool reached = alone.own_steps(Registers::one, 0, end, tolerance, end / 1000, &expected);
    for (Registers registers : wide_ones()) {
      INFO(lanes::name_of(registers));
      Batch together = batch;
      CHECK(together.own_steps(registers, 0, end, tolerance, end / 1000, &ended) == reached);
      CHECK(different(together, alone) == 0);
      REQUIRE(ended.size() == bodies);
      for (std::size_t i = 0; i < bodies; ++i) {
        CHECK(ended[i].steps == expected[i].steps);
        CHECK(ended[i].reached == expected[i].reached);
      }
    }
  });
}

TEST_CASE("closed forms have the same bits in lanes as alone", "[lanes]") {
  for_every_model([&](const SceneInLanes& scene, std::size_t, Precision, Batch& batch) {
    if (!batch.closed_form()) return;
    for (double share : {0.01, 0.7}) {
      const double t = share * exercise_of(scene).scene->horizon;
      const auto alone = batch.observed(Registers::one, t);
      for (Registers registers : wide_ones()) {
        INFO(lanes::name_of(registers) << " at " << t);
        CHECK(same(batch.observed(registers, t), alone));
      }
    }
  });
}

TEST_CASE("a body does not depend on the others in its register", "[lanes]") {
  constexpr std::size_t ill = 3;
  for_every_model([&](const SceneInLanes& scene, std::size_t model, Precision precision, Batch& well) {
    if (well.closed_form()) return;
    auto parameters = parameters_of(scene);
    for (std::size_t k = 0; k < scene.parameters; ++k)
      parameters[ill * scene.parameters + k] = std::numeric_limits<double>::quiet_NaN();
    Batch with_ill(scene, model, precision, parameters);
    const double end = exercise_of(scene).scene->horizon / 400;
    for (bool own : {false, true}) {
      for (Batch* batch : {&with_ill, &well}) {
        batch->begin_again();
        if (own)
          batch->own_steps(lanes::widest(), 0, end, 1e-4, end / 100);
        else
          batch->steps(lanes::widest(), Fixed::runge_kutta_4, 0, end / 4, 4);
      }
      for (std::size_t i = 0; i < bodies; ++i)
        CHECK((i == ill || std::ranges::equal(with_ill.state(i), well.state(i))));
    }
  });
}

TEST_CASE("a body that cannot reach the end is reported, and the others reach it", "[lanes]") {
  const SceneInLanes& scene = lanes::scene_in_lanes("3.5");
  auto parameters = parameters_of(scene);
  parameters[7 * scene.parameters] = std::numeric_limits<double>::quiet_NaN();
  Batch batch(scene, 3, Precision::in_double, parameters);
  std::vector<lanes::Ended> ended;
  CHECK_FALSE(batch.own_steps(lanes::widest(), 0, 10, 1e-6, 1e-3, &ended));
  for (std::size_t i = 0; i < bodies; ++i) {
    CHECK(ended[i].reached == (i != 7));
    CHECK(ended[i].steps > 10);
  }
}

TEST_CASE("many bodies check for a stop on their way", "[lanes]") {
  const SceneInLanes& scene = lanes::scene_in_lanes("3.5");
  Batch batch(scene, 3, Precision::in_double, parameters_of(scene, 5000));
  Stop stop;
  const Stoppable here(&stop);
  CHECK(batch.own_steps(lanes::widest(), 0, 0.1, 1e-6, 1e-3));
  stop.request();
  CHECK_THROWS_AS(batch.own_steps(lanes::widest(), 0.1, 0.2, 1e-6, 1e-3), Stopped);
  CHECK_THROWS_AS(batch.steps(lanes::widest(), lanes::Fixed::runge_kutta_4, 0.1, 0.01, 10), Stopped);
}

TEST_CASE("bodies with an end in the past, now or NaN end at once", "[lanes]") {
  const SceneInLanes& scene = lanes::scene_in_lanes("3.5");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (Registers registers : {Registers::one, Registers::baseline, lanes::widest()})
    for (double end : {1.0, 0.5, nan}) {
      INFO(lanes::name_of(registers) << " from 1 to " << end);
      Batch batch(scene, 3, Precision::in_double, parameters_of(scene));
      const Batch before = batch;
      std::vector<lanes::Ended> ended;
      CHECK(batch.own_steps(registers, 1, end, 1e-6, 1e-3, &ended) == (end == 1));
      CHECK(different(batch, before) == 0);
      for (const lanes::Ended& one : ended) {
        CHECK(one.steps == 0);
        CHECK(one.reached == (end == 1));
      }
    }
}

TEST_CASE("no step is taken if any of its numbers is NaN", "[lanes]") {
  const auto check = []<class Number>(Number, std::size_t ill) {
    const OneIsNaN<Number> model{ill};
    lanes::OwnSteps<OneIsNaN<Number>> steps(0, 1, 1e-6, 0.125);
    std::array<Number, 3> x{Number(1), Number(1), Number(1)};
    lanes::Room<OneIsNaN<Number>> room;
    room.model = model;
    CHECK_FALSE(steps.run(&room, &x, 1, nullptr));
    for (const Number& one : x) CHECK(one[0] == 1);
  };
  for (std::size_t ill : {0u, 1u, 2u}) {
    check(Lanes<double, lanes::One, 1>(), ill);
    check(Lanes<double, lanes::Baseline, 2>(), ill);
  }
}

/// A spring with its own stiffness that counts its evaluations.
template <class Number>
struct CountedSpring {
  using State = std::array<Number, 2>;
  Number stiffness;
  inline static long asked = 0;
  void operator()(const State& x, State& dxdt, const Number&) const {
    ++asked;
    dxdt = {x[1], -stiffness * x[0]};
  }
};

TEST_CASE("bodies that have far to go are regrouped, with the bits that each has alone", "[lanes]") {
  using Number = Lanes<double, lanes::Baseline, 2>;
  using Single = Lanes<double, lanes::One, 1>;
  using Together = CountedSpring<Number>;
  constexpr std::size_t width = Number::size(), groups = 3 * width;
  std::vector<lanes::Room<Together>> models(groups);
  std::vector<Together::State> states(groups, {Number(1.0), Number(0.0)});
  for (std::size_t i = 0; i < groups; ++i) {
    models[i].model.stiffness = Number(1.0);
    models[i].model.stiffness.set(i % width, 1e4 + static_cast<double>(i));  // one of each group is late
  }
  std::vector<lanes::Ended> ended(groups * width);
  lanes::OwnSteps<Together> steps(0, 1, 1e-9, 0.01);
  Together::asked = 0;
  CHECK(steps.run(models.data(), states.data(), groups, ended.data()));
  long most = 0;
  for (std::size_t i = 0; i < groups; ++i)
    for (std::size_t lane = 0; lane < width; ++lane) {
      lanes::Room<CountedSpring<Single>> model;
      model.model.stiffness = Single(models[i].model.stiffness[lane]);
      CountedSpring<Single>::State x{Single(1.0), Single(0.0)};
      lanes::Ended alone{};
      lanes::OwnSteps<CountedSpring<Single>> own(0, 1, 1e-9, 0.01);
      CHECK(own.run(&model, &x, 1, &alone));
      const lanes::Ended& one = ended[i * width + lane];
      CHECK(one.steps == alone.steps);
      CHECK(one.reached);
      CHECK(states[i][0][lane] == x[0][0]);
      CHECK(states[i][1][lane] == x[1][0]);
      most = std::max(most, one.steps);
    }
  CHECK(most > 500);
  // If each group waited for its late body, there would be six evaluations per step of it, times the groups.
  CHECK(Together::asked < 6 * most * static_cast<long>(groups) / 2);
}

TEST_CASE("bodies in one register that take more and fewer steps wait for each other", "[lanes]") {
  const SceneInLanes& scene = lanes::scene_in_lanes("3.5");
  auto parameters = parameters_of(scene);
  for (std::size_t i = 0; i < bodies; ++i)
    parameters[i * scene.parameters + 1] *= 1 + static_cast<double>(i * 7 % bodies);
  Batch alone(scene, 3, Precision::in_double, parameters), together = alone;
  std::vector<lanes::Ended> expected, ended;
  CHECK(alone.own_steps(Registers::one, 0, 3, 1e-8, 1e-3, &expected));
  CHECK(together.own_steps(lanes::widest(), 0, 3, 1e-8, 1e-3, &ended));
  CHECK(different(together, alone) == 0);
  std::set<long> steps;
  for (std::size_t i = 0; i < bodies; ++i) {
    CHECK(ended[i].steps == expected[i].steps);
    steps.insert(ended[i].steps);
  }
  CHECK(steps.size() > 10);
}

TEST_CASE("a few bodies, or one, have the same bits as many", "[lanes]") {
  const SceneInLanes& scene = lanes::scene_in_lanes("3.3");
  for (std::size_t count : {1u, 2u, 15u, 16u, 17u, 33u}) {
    Batch alone(scene, 5, Precision::in_double, parameters_of(scene, count)), together = alone;
    alone.own_steps(Registers::one, 0, 1, 1e-8, 1e-3);
    together.own_steps(lanes::widest(), 0, 1, 1e-8, 1e-3);
    CHECK(different(together, alone) == 0);
    alone.steps(Registers::one, Fixed::velocity_verlet, 0, 0.01, 10);
    together.steps(lanes::widest(), Fixed::velocity_verlet, 0, 0.01, 10);
    CHECK(different(together, alone) == 0);
  }
}

TEST_CASE("without elementary functions lanes have the bits of plain doubles", "[lanes]") {
  const SceneInLanes& scene = lanes::scene_in_lanes("3.3");
  const auto all = parameters_of(scene);
  constexpr double h = 0x1p-8;
  constexpr int steps = 100;
  const auto check = [&]<class Stepper>(Fixed algorithm) {
    Batch batch(scene, 5, Precision::in_double, all);
    const Batch begun = batch;
    batch.steps(lanes::widest(), algorithm, 0, h, steps);
    for (std::size_t i = 0; i < bodies; ++i) {
      const double* p = &all[i * scene.parameters];
      const kepler::Cartesian<double> model{{p[0], p[1], p[2], p[3], p[4], p[5]}};
      // The start has a sine and a cosine, for which lanes have their own functions.
      auto x = model.start();
      std::memcpy(x.data(), begun.state(i).data(), sizeof x);
      Stepper stepper;
      for (int step = 0; step < steps; ++step) stepper.step(model, x, step * h, h);
      CHECK(std::memcmp(x.data(), batch.state(i).data(), sizeof x) == 0);
    }
  };
  check.operator()<plain::RungeKutta4<kepler::Cartesian<double>>>(Fixed::runge_kutta_4);
  check.operator()<plain::VelocityVerlet<kepler::Cartesian<double>>>(Fixed::velocity_verlet);
}

TEST_CASE("lanes move like the scenes' own methods", "[lanes]") {
  int compared = 0;
  for (const SceneInLanes& scene : lanes::scenes_in_lanes()) {
    const Scene& moving = *exercise_of(scene).scene;
    const double end = moving.horizon / 50;
    constexpr long steps = 16;
    const Quantity quantity =
        motion(moving, Parameters(exercise_of(scene).parameters), Horizon{end, 1}, Reference::nothing());
    const auto names = lanes::model_names(scene);
    for (std::size_t model = 0; model < scene.models; ++model) {
      Batch batch(scene, model, Precision::in_double, parameters_of(scene, 1));
      if (batch.closed_form() || scene.beginnings[model].has_own_time) continue;
      for (Fixed algorithm : {Fixed::runge_kutta_4, Fixed::velocity_verlet, Fixed::symplectic_euler}) {
        const auto method = std::ranges::find_if(quantity.methods, [&](const Method& m) {
          return m.model == names[model] && m.algorithm == lanes::name_of(algorithm);
        });
        if (method == quantity.methods.end() || !batch.has(algorithm)) continue;
        INFO(scene.number << ", " << names[model] << ", " << lanes::name_of(algorithm));
        const Value expected = method->run(end / steps).value;
        batch.begin_again();
        batch.steps(lanes::widest(), algorithm, 0, end / steps, steps);
        const auto seen = batch.observed(Registers::one, end);
        REQUIRE(seen.size() == expected.size());
        double scale = 0;
        for (double x : expected) scale = std::max(scale, std::abs(x));
        for (std::size_t k = 0; k < seen.size(); ++k) CHECK(std::abs(seen[k] - expected[k]) <= 1e-12 * scale);
        ++compared;
      }
      if (scene.beginnings[model].has_events) continue;
      const auto method = std::ranges::find_if(quantity.methods, [&](const Method& m) {
        return m.model == names[model] && m.algorithm == lanes::own_steps_name;
      });
      if (method == quantity.methods.end()) continue;
      INFO(scene.number << ", " << names[model] << ", by own steps");
      const Value expected = method->run(1e-10).value;
      batch.begin_again();
      CHECK(batch.own_steps(lanes::widest(), 0, end, 1e-10, end / 1000));
      const auto seen = batch.observed(Registers::one, end);
      double scale = 0;
      for (double x : expected) scale = std::max(scale, std::abs(x));
      for (std::size_t k = 0; k < seen.size(); ++k) CHECK(std::abs(seen[k] - expected[k]) <= 1e-7 * scale);
    }
  }
  CHECK(compared >= 50);
}
