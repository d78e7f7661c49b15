#pragma once

#include "chapters/03_rigid_body_motion/03_kepler/kepler.hpp"
#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/scene.hpp"
#include "extras/bench/loops.hpp"

/// The timed models, and how the scenes run them.
namespace oddity::raced {

constexpr double step = 0x1p-9, span = 4, tolerance = 1e-10;

constexpr double setting(ode::Kind kind) { return ode::has_tolerance(kind) ? tolerance : step; }

/// A planet in space, (x, y, z, x', y', z').
struct SpatialKepler {
  double mu;
  using State = std::array<double, 6>;
  void acceleration(const std::array<double, 3>& q, std::array<double, 3>& a) const {
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2], pull = -mu / (square * std::sqrt(square));
    a = {pull * q[0], pull * q[1], pull * q[2]};
  }
  void operator()(const State& x, State& dxdt, double) const {
    std::array<double, 3> a{};
    acceleration({x[0], x[1], x[2]}, a);
    dxdt = {x[3], x[4], x[5], a[0], a[1], a[2]};
  }
};

/// The algorithm and the model compiled apart, with the flags of the scenes.
std::function<Run()> precompiled(const pendulum::OneAngle<double>&, const std::array<double, 2>& start,
                                 std::string_view algorithm, ode::Kind);
std::function<Run()> precompiled(const kepler::Cartesian<double>&, const std::array<double, 4>& start,
                                 std::string_view algorithm, ode::Kind);
std::function<Run()> precompiled(const SpatialKepler&, const std::array<double, 6>& start,
                                 std::string_view algorithm, ode::Kind);

}  // namespace oddity::raced
