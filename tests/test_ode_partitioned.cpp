// Purpose of symplectic Euler and velocity Verlet. Over a long time the energy oscillates and does not drift,
// the area in phase space is conserved, and Verlet can be run back step by step.

#include "report/verify/catch.hpp"
#include "tests/near.hpp"
#include "tests/ode_algorithms.hpp"

using namespace oddity::ode;
using namespace problems;

namespace {

/// A planet in the plane, GM = 1: (x, y, x', y').
struct Kepler {
  using Orbit = std::array<double, 4>;

  void operator()(const Orbit& x, Orbit& dxdt, double) const {
    std::array<double, 2> a{};
    acceleration({x[0], x[1]}, a);
    dxdt = {x[2], x[3], a[0], a[1]};
  }
  void acceleration(const std::array<double, 2>& q, std::array<double, 2>& a) const {
    const double r = std::hypot(q[0], q[1]);
    a = {-q[0] / (r * r * r), -q[1] / (r * r * r)};
  }

  /// Start at the near end of an orbit of semi-axis 1.
  static Orbit start(double eccentricity) {
    return {1 - eccentricity, 0, 0, std::sqrt((1 + eccentricity) / (1 - eccentricity))};
  }
  static double energy(const Orbit& x) {
    return (x[2] * x[2] + x[3] * x[3]) / 2 - 1 / std::hypot(x[0], x[1]);
  }
  static double angular_momentum(const Orbit& x) { return x[0] * x[3] - x[1] * x[2]; }
};

struct Drift {
  double first_half = 0, second_half = 0, momentum = 0;
};

/// The largest change of the energy in either half of 1e5 steps, and of the angular momentum.
template <class Algorithm>
Drift drift(double step) {
  Drift drift;
  const auto start = Kepler::start(0.5);
  const double end = 1e5 * step;
  const auto watch = [&](double, const Kepler::Orbit&, double t, const Kepler::Orbit& x) {
    double& worst = t < end / 2 ? drift.first_half : drift.second_half;
    worst = std::max(worst, std::abs(Kepler::energy(x) - Kepler::energy(start)));
    drift.momentum =
        std::max(drift.momentum, std::abs(Kepler::angular_momentum(x) - Kepler::angular_momentum(start)));
    return false;
  };
  const std::array times{0.0, end};
  CHECK(integrate<Algorithm>(Kepler(), start, std::span<const double>(times), step, watch).reached());
  return drift;
}

}  // namespace

TEST_CASE("the energy of an orbit is bounded over 1e5 steps of the symplectic methods", "[solvers]") {
  const Drift verlet = drift<VelocityVerlet>(0.01), euler = drift<SymplecticEuler>(0.01);
  CHECK(within(verlet.first_half, 1e-5, 1e-3));
  CHECK(near(verlet.second_half / verlet.first_half, 1, 0.01));
  CHECK(within(euler.first_half, 1e-3, 1e-1));
  CHECK(near(euler.second_half / euler.first_half, 1, 0.05));
  const Drift mclachlan = drift<McLachlan4>(0.04);
  CHECK(within(mclachlan.first_half, 1e-7, 1e-4));
  CHECK(near(mclachlan.second_half / mclachlan.first_half, 1, 0.05));
}

TEST_CASE("explicit Euler's energy drifts over the same time", "[solvers]") {
  const Drift euler = drift<ExplicitEuler>(0.01);
  CHECK(euler.second_half > 1.01 * euler.first_half);
  CHECK(euler.second_half > 0.3);
}

TEST_CASE("the symplectic methods conserve the angular momentum to rounding", "[solvers]") {
  CHECK(drift<VelocityVerlet>(0.01).momentum < 1e-12);
  CHECK(drift<SymplecticEuler>(0.01).momentum < 1e-12);
  CHECK(drift<McLachlan4>(0.01).momentum < 1e-12);
}

TEST_CASE("the energy's oscillation shrinks with the order of the method", "[solvers]") {
  CHECK(near(std::log2(drift<VelocityVerlet>(0.01).first_half / drift<VelocityVerlet>(0.005).first_half), 2,
             0.1));
  CHECK(near(std::log2(drift<SymplecticEuler>(0.01).first_half / drift<SymplecticEuler>(0.005).first_half), 1,
             0.1));
}

TEST_CASE("Verlet and McLachlan run back step by step to their start; symplectic Euler does not",
          "[solvers]") {
  const auto there_and_back = []<class Algorithm>() {
    const auto start = Kepler::start(0.5);
    const auto there = integrate<Algorithm>(Kepler(), start, 0, 20, 0.01);
    const auto back = integrate<Algorithm>(Kepler(), there.value, 20, 0, 0.01);
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, std::abs(back.value[i] - start[i]));
    return worst;
  };
  CHECK(there_and_back.operator()<VelocityVerlet>() < 1e-11);
  CHECK(there_and_back.operator()<McLachlan4>() < 1e-11);
  CHECK(there_and_back.operator()<SymplecticEuler>() > 1e-4);
}

TEST_CASE("a symplectic step conserves the area in phase space, explicit Euler's grows", "[solvers]") {
  // The determinant of a pendulum's step, by differences of its map.
  const auto area = []<class Algorithm>() {
    const double d = 1e-5;
    const auto step = [](double q, double v) {
      return fixed_steps<Algorithm>(separatrix.system, {q, v}, 0, 0.3, 1).back();
    };
    const State right = step(1 + d, 0.5), left = step(1 - d, 0.5), up = step(1, 0.5 + d),
                down = step(1, 0.5 - d);
    return ((right[0] - left[0]) * (up[1] - down[1]) - (up[0] - down[0]) * (right[1] - left[1])) /
           (4 * d * d);
  };
  CHECK(near(area.operator()<VelocityVerlet>(), 1, 1e-9));
  CHECK(near(area.operator()<McLachlan4>(), 1, 1e-9));
  CHECK(near(area.operator()<SymplecticEuler>(), 1, 1e-9));
  CHECK(near(area.operator()<ExplicitEuler>(), 1 + 0.09 * std::cos(1.0), 1e-9));
}
