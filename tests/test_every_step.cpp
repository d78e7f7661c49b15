// A breakdown's statement about every step is true at every step, not only in the two trials that it shows.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "chapters/03_rigid_body_motion/29_planar_wire/models.hpp"
#include "chapters/03_rigid_body_motion/31_rough_box/models.hpp"
#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"

using namespace oddity;

namespace {

Parameters defaults_of(Number number) {
  return Parameters(std::ranges::find(registry(), number, &Entry::number)->exercise.parameters);
}

/// The states after each step.
template <class Algorithm, class Model>
auto steps_of(const Model& model, double step, int count) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(i * step);
  return ode::integrate<Algorithm>(model, model.start(), std::span<const double>(times), step).value;
}

}  // namespace

TEST_CASE("explicit Euler lets the rod of two particles grow, and the energy, at every step",
          "[claims][3.29]") {
  const Parameters p = defaults_of({3, 29});
  const planar_wire::TwoParticles<double> rod{
      planar_wire::thrown<double>({p["q"], p["d"], p["u"], p["v"], p["w"], p["g"]})};
  double longest = 2 * rod.k(), most = -INFINITY;
  for (const auto& x : steps_of<ode::ExplicitEuler>(rod, 0.125, 16)) {
    const double length = std::hypot(x[0] - x[2], x[1] - x[3]), energy = rod.conserved(x, 0.0)[0].value;
    CHECK(length >= longest * (1 - 0x1p-50));
    CHECK(energy > most);
    longest = length, most = energy;
  }
  CHECK(longest > 2.1 * rod.k());
}

TEST_CASE("Peano's function shows no curl by equal steps, at every one", "[claims][5.9]") {
  const Entry& entry = *std::ranges::find(registry(), Number{5, 9}, &Entry::number);
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  int steps = 0;
  for (const Quantity& q : entry.exercise.study(defaults_of({5, 9}), truth).quantities)
    for (const Method& m : q.methods)
      for (double h : m.algorithm == "equal steps h" ? m.resolution.settings : std::vector<double>{}) {
        CHECK(m.run(h).value[0] == 0);
        ++steps;
      }
  CHECK(steps > 5);
}

TEST_CASE("full friction reverses within every step of a box that should rest, which creeps on",
          "[claims][3.31]") {
  const Parameters p = defaults_of({3, 31});
  const rough_box::InTime<double> box{{{p["a"], p["b"]}, p["mu"], p["g"], p["u0"], p["v0"], p["w0"]}};
  constexpr double step = 0x1p-8;
  const auto path = steps_of<ode::RungeKutta4>(box, step, 1024);
  for (std::size_t k = 700; k < path.size(); ++k) {
    auto x = path[k], first = x, second = x;
    box(x, first, 0.0);
    for (std::size_t i = 3; i < 6; ++i) x[i] += step / 2 * first[i];
    box(x, second, 0.0);
    CHECK(first[3] * second[3] + first[4] * second[4] + box.p.J() * first[5] * second[5] < 0);
  }
  CHECK(box.speed(path.back()) > 0.9 * box.speed(path[700]));
}
