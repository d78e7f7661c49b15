#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "chapters/03_rigid_body_motion/lagrangian.hpp"
#include "chapters/03_rigid_body_motion/listed_runge_kutta.hpp"
#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "solvers/ode/events.hpp"

/// A mass on a rod that turns about the x3-axis at 45 degrees to it, starting in the (x1, x3)-plane, and a
/// spring from (c, 0, 0) to the mass: its Lagrangian, and its models, whose observables are the position.
///   s  distance from the origin along the rod (the book's lambda)    w  angular speed of the rod
///   K  stiffness and  ell  rest length of the spring                 r  length of the spring
namespace oddity::turning_rod {

inline const double root_half = std::sqrt(0.5);

// ---- the Lagrangian ---------------------------------------------------------------------------------------

/// The rod's direction after turning by an angle: Rodrigues' formula for (1, 0, 1)/sqrt(2) about k.
template <class T>
std::array<T, 3> direction(const T& angle) {
  using std::cos, std::sin;
  const std::array<double, 3> d{root_half, 0, root_half}, k{0, 0, 1};
  const std::array<double, 3> side{k[1] * d[2] - k[2] * d[1], k[2] * d[0] - k[0] * d[2],
                                   k[0] * d[1] - k[1] * d[0]};
  const double along = k[0] * d[0] + k[1] * d[1] + k[2] * d[2];
  const T c = cos(angle), s = sin(angle);
  const auto component = [&](std::size_t i) -> T {
    return d[i] * c + side[i] * s + k[i] * along * (1.0 - c);
  };
  return {component(0), component(1), component(2)};
}

template <class T>
std::array<T, 3> position(const T& s, const T& t, double w) {
  const auto D = direction(T(w * t));
  return {s * D[0], s * D[1], s * D[2]};
}

/// The mass's velocity for s' = v.
template <class T>
std::array<T, 3> velocity(const T& s, const T& v, const T& t, double w) {
  const auto x = position(Dual<T>(s, v), Dual<T>(t, T(1.0)), w);
  return {x[0].slope, x[1].slope, x[2].slope};
}

struct KineticEnergy {
  double m, w;
  template <class T>
  T operator()(const T& s, const T& v, const T& t) const {
    const auto u = velocity(s, v, t, w);
    return 0.5 * m * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  }
};

struct Spring {
  double c, K, ell;
  /// The energy when the other end is at x.
  template <class T>
  T energy(const std::array<T, 3>& x) const {
    using std::sqrt;
    const T stretch = sqrt((x[0] - c) * (x[0] - c) + x[1] * x[1] + x[2] * x[2]) - ell;
    return 0.5 * K * stretch * stretch;
  }
  /// Minus the gradient of the energy, by dual numbers.
  std::array<double, 3> force(const std::array<double, 3>& x) const {
    std::array<double, 3> f;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<Dual<double>, 3> y{x[0], x[1], x[2]};
      y[i].slope = 1;
      f[i] = -energy(y).slope;
    }
    return f;
  }
};

struct Lagrangian {
  double m, w;
  Spring spring;
  template <class T>
  T operator()(const T& s, const T& v, const T& t) const {
    return KineticEnergy{m, w}(s, v, t) - spring.energy(position(s, t, w));
  }
};

// ---- the models -------------------------------------------------------------------------------------------

struct Rod {
  double m, c, K, w, s0;
  double ell = std::sqrt(s0 * s0 - std::numbers::sqrt2 * c * s0 + c * c);

  std::array<double, 3> place(double s, double t) const {
    const double across = root_half * s;
    return {across * std::cos(w * t), across * std::sin(w * t), across};
  }
};

struct NoSpring : Rod {
  std::array<double, 3> at(double t) const { return place(s0 * std::cosh(w * root_half * t), t); }
};

/// The spring's fixed end at the origin: linear.
struct EndOnTheAxis : Rod {
  std::array<double, 3> at(double t) const {
    const double pull = K / m - w * w / 2, rest = K / m * s0 / pull, frequency = std::sqrt(std::abs(pull));
    return place(rest + (s0 - rest) * (pull > 0 ? std::cos(frequency * t) : std::cosh(frequency * t)), t);
  }
};

/// The spring a bar of its rest length: the distance along the rod is a matter of geometry. Raised where the
/// bar does not reach the rod.
struct RigidSpring : Rod {
  std::array<double, 3> at(double t) const {
    const double p = c * root_half * std::cos(w * t), square = ell * ell - c * c + p * p;
    if (square < 0) throw std::domain_error("a bar as long as the spring does not reach the rod");
    return place(p + std::sqrt(square), t);
  }
};

/// (s, s').
struct AlongTheRod : Rod {
  using State = std::array<double, 2>;
  State start() const { return {s0, 0}; }
  double acceleration(double s, double t) const {
    const double p = c * root_half * std::cos(w * t);
    const double r = std::sqrt(s * s - 2 * p * s + c * c);
    return w * w / 2 * s - K / m * (1 - ell / r) * (s - p);
  }
  void operator()(const State& x, State& dxdt, double t) const { dxdt = {x[1], acceleration(x[0], t)}; }
  std::array<double, 3> observe(const State& x, double t) const { return place(x[0], t); }
};

/// (s, s', work): for the rod the spring's end turns, and does this work; the energy seen from the rod less
/// it is conserved.
struct AlongTheRodWithWork : Rod {
  using State = std::array<double, 3>;
  State start() const { return {s0, 0, 0}; }
  double length(double s, double t) const {
    return std::sqrt(s * s - std::numbers::sqrt2 * c * std::cos(w * t) * s + c * c);
  }
  void operator()(const State& x, State& dxdt, double t) const {
    const double pull = K * (1 - ell / length(x[0], t));
    dxdt = {x[1], AlongTheRod{*this}.acceleration(x[0], t),
            pull * c * root_half * x[0] * w * std::sin(w * t)};
  }
  std::array<double, 3> observe(const State& x, double t) const { return place(x[0], t); }
  OneConserved conserved(const State& x, double t) const {
    const double stretch = length(x[0], t) - ell;
    return energy_of(m * x[1] * x[1] / 2, K * stretch * stretch / 2 - m * w * w * x[0] * x[0] / 4 - x[2]);
  }
};

/// (s, y, s', y', work) in the plane that turns with the rod and holds it and the horizontal across it:
/// centrifugal and Coriolis force, and the rod's push across that keeps y without acceleration. The spring's
/// end turns backward, and does the work.
struct InTheTurningPlane : Rod {
  using State = std::array<double, 5>;
  State start() const { return {s0, 0, 0, 0, 0}; }
  /// From the spring's end to (s, y): along the rod, across it, and out of the plane.
  std::array<double, 3> spring(double s, double y, double t) const {
    const double p = root_half * c * std::cos(w * t);
    return {s - p, y + c * std::sin(w * t), p};
  }
  void operator()(const State& x, State& dxdt, double t) const {
    const auto d = spring(x[0], x[1], t);
    const double pull = -K / m * (1 - ell / std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    const double along = pull * d[0] + w * w / 2 * x[0] + 2 * w * root_half * x[3];
    const double across = pull * d[1] + w * w * x[1] - 2 * w * root_half * x[2], push = -across;
    const double C = std::cos(w * t), S = std::sin(w * t);
    const double by_end = -m * pull * c * w * (root_half * S * (d[0] - d[2]) + C * d[1]);
    dxdt = {x[2], x[3], along, across + push, by_end + m * push * x[3]};
  }
  std::array<double, 3> observe(const State& x, double t) const {
    const auto r = place(x[0], t);
    return {r[0] - x[1] * std::sin(w * t), r[1] + x[1] * std::cos(w * t), r[2]};
  }
  OneConserved conserved(const State& x, double t) const {
    const auto d = spring(x[0], x[1], t);
    const double stretch = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - ell;
    const double speeds = x[2] * x[2] + x[3] * x[3], turned = x[0] * x[0] / 2 + x[1] * x[1];
    return energy_of(m * speeds / 2, K * stretch * stretch / 2 - m * w * w * turned / 2 - x[4]);
  }
};

/// (x, x', work): two forces normal to the rod keep x . n1 and x . n2 without acceleration, and do this work.
struct CartesianWithConstraints : Rod {
  using State = std::array<double, 7>;
  State start() const { return {root_half * s0, 0, root_half * s0, 0, root_half * s0 * w, 0, 0}; }
  void operator()(const State& x, State& dxdt, double t) const {
    const double C = std::cos(w * t), S = std::sin(w * t), h = root_half;
    const double y = x[0] - c, pull = -K / m * (1 - ell / std::sqrt(y * y + x[1] * x[1] + x[2] * x[2]));
    const std::array f{pull * y, pull * x[1], pull * x[2]};
    const double m1 = S * f[0] - C * f[1] + 2 * w * (C * x[3] + S * x[4]) + w * w * (C * x[1] - S * x[0]);
    const double m2 =
        h * (f[2] - C * f[0] - S * f[1] + 2 * w * (S * x[3] - C * x[4]) + w * w * (C * x[0] + S * x[1]));
    const std::array n{-S * m1 + h * C * m2, C * m1 + h * S * m2, -h * m2};
    dxdt = {x[3],
            x[4],
            x[5],
            f[0] + n[0],
            f[1] + n[1],
            f[2] + n[2],
            m * (n[0] * x[3] + n[1] * x[4] + n[2] * x[5])};
  }
  std::array<double, 3> observe(const State& x, double) const { return {x[0], x[1], x[2]}; }
  OneConserved conserved(const State& x, double) const {
    return energy_of(m * (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2,
                     Spring{c, K, ell}.energy(observe(x, 0)) - x[6]);
  }
};

// ---- the book's listing -----------------------------------------------------------------------------------

/// (lambda, lambda'), the listing's arithmetic; `factor` is what it multiplies the time by inside the cosine.
struct Listing : Rod {
  using State = std::array<double, 2>;
  double factor = root_half;
  State start() const { return {s0, 0}; }
  void operator()(const State& state, State& output, double time) const {
    const double tmp0 = c * root_half * std::cos(factor * time);
    const double tmp1 = state[0] - tmp0;
    const double tmp2 = state[0] - 2.0 * tmp0;
    const double tmp3 = state[0] * tmp2 + c * c;
    const double tmp4 = 1.0 - ell * (1 / std::sqrt(tmp3));
    output = {state[1], std::numbers::pi * std::numbers::pi / 32.0 * state[0] - K / m * tmp4 * tmp1};
  }
  std::array<double, 3> observe(const State& x, double t) const { return place(x[0], t); }
};

// ---- random states ----------------------------------------------------------------------------------------

/// A rod to (a, 0, a), a spring of any rest length, a start (b, 0, b), and a mass anywhere, with any s''.
struct Sample {
  double m, a, b, c, K, w, ell, s, v, A, t;
  explicit Sample(Random& random)
      : m(random.between(0.1, 5)),
        a(random.between(1, 5)),
        b(random.between(0.1, 5)),
        c(random.between(0.1, 5)),
        K(random.between(0.1, 10)),
        w(random.magnitude(0.1, 5)),
        ell(random.between(0.1, 5)),
        s(random.between(0.1, 7)),
        v(random.magnitude(0.1, 5)),
        A(random.magnitude(0.1, 5)),
        t(random.between(-5, 5)) {}
  std::array<double*, 11> letters() { return {&m, &a, &b, &c, &K, &w, &ell, &s, &v, &A, &t}; }
  std::string where() const {
    return "c = " + shortest(c) + ", w = " + shortest(w) + ", ell = " + shortest(ell) +
           ", s = " + shortest(s) + ", s' = " + shortest(v) + ", t = " + shortest(t);
  }
  Spring spring() const { return {c, K, ell}; }
  Lagrangian L() const { return {m, w, spring()}; }
  KineticEnergy T() const { return {m, w}; }
  std::array<double, 3> x() const { return position(s, t, w); }
  std::array<double, 3> velocity() const { return turning_rod::velocity(s, v, t, w); }
};

// ---- the methods ------------------------------------------------------------------------------------------

inline std::vector<double> inputs(const Rod& rod) { return {rod.m, rod.c, rod.K, rod.w, rod.s0}; }

inline Quantity slide(const Rod& rod, const Horizon& horizon, const Reference& truth) {
  Quantity place = quantity("slide", "m", "position at " + times_up_to(horizon),
                            trajectory(truth, "03_15_slide", inputs(rod), horizon), {});
  place.need = {5e-7 * size_of(place.reference.value), "six digits, as many as are printed"};
  const double b = root_half * rod.s0;
  const Listing printed{rod};
  Listing other_length{rod, std::numbers::pi / 4};
  other_length.ell = std::hypot(b - rod.c, rod.c);
  Ladder(place, horizon, halving("step", 0.125, 9), tolerances())
      .closed_form("no spring", NoSpring{rod}, Outcome::inaccurate, "the spring does most of the work")
      .closed_form("spring's end on the axis", EndOnTheAxis{rod}, Outcome::inaccurate,
                   "it is the turning of the spring's end that pulls the mass down")
      .closed_form("rigid spring", RigidSpring{rod}, Outcome::inaccurate, "the spring gives way")
      .by<ode::RungeKutta4>("listing as printed", printed, Outcome::inaccurate,
                            "it multiplies the time by 1/sqrt(2) where the rod turns by pi/4 a second")
      .by<ode::RungeKutta4>("listing with the other rest length", other_length, Outcome::inaccurate,
                            "with sqrt((b-c)^2 + c^2) the spring is stretched from the start")
      .by_common("along the rod", AlongTheRod{rod})
      .by_others("along the rod", AlongTheRod{rod},
                 {{"linearly implicit Euler", Outcome::inaccurate,
                   "its order is too low for this need at this step"}})
      .by_few("along the rod, with the work", AlongTheRodWithWork{rod})
      .by_common("in the turning plane", InTheTurningPlane{rod})
      .by_common("Cartesian with constraints", CartesianWithConstraints{rod});
  return place;
}

/// The same rod with a stiff spring: a geometric motion and a tremor about it.
inline Quantity stiff_spring(const Rod& rod, const Horizon& horizon, const Reference& truth) {
  Quantity place = quantity("stiff_spring", "m", "position at " + times_up_to(horizon) + ", the spring stiff",
                            trajectory(truth, "03_15_slide", inputs(rod), horizon), {1e-3, "a millimetre"});
  const AlongTheRod along{rod};
  const std::string name = "along the rod", rigid = "rigid spring";
  Ladder(place, horizon, halving("step", 0.0625, 6), tolerances())
      .closed_form(rigid, RigidSpring{rod})
      .by<ode::RungeKutta4>(name, along)
      .by<ode::DormandPrince54>(name, along)
      .by<ode::Fehlberg78>(name, along)
      .by<ode::BulirschStoer>(name, along);
  const std::string runge_kutta = name + ", " + std::string(ode::brief<ode::RungeKutta4>().name);
  place.add(Breakdown{
      "The spring's tremor, about sqrt(K/m), must be resolved though nobody sees it: beyond a step of 2.83 "
      "over that frequency Runge-Kutta 4 blows it up. A smaller step cures it.",
      runge_kutta, 0.0625, Outcome::diverged, runge_kutta, 0.015625});
  place.add(Breakdown{
      "Nor is the tremor worth its cost: the spring taken as a bar of its rest length is right to a "
      "millimetre, in closed form.",
      runge_kutta, 0.0625, Outcome::diverged, rigid + ", closed form", 0});
  return place;
}

/// s'/s after some e-foldings of the runaway.
template <class Algorithm>
Answer late_rate(const AlongTheRod& rod, double rate, double foldings, double setting) {
  return answer(ode::integrate<Algorithm>(rod, rod.start(), 0, foldings / rate, setting),
                [](const AlongTheRod::State& x) { return x[1] / x[0]; });
}

/// Beyond w = sqrt(2K/m) the centrifugal force grows faster along the rod than the spring's.
inline Quantity runaway(const Rod& rod) {
  const double rate = std::sqrt(rod.w * rod.w / 2 - rod.K / rod.m);
  Quantity growth{"runaway",
                  "1/s",
                  "rate at which the distance grows in the end, beyond the speed sqrt(2K/m)",
                  {"sqrt(w^2/2 - K/m)", rate},
                  1e-15 * rate,
                  {1e-8 * rate, "eight digits"}};
  const AlongTheRod along{rod};
  const Knob foldings = doubling("e-foldings", 2, 5);
  growth.add({"no spring", "closed form", no_knob(),
              [=](double) {
                return Answer{rod.w * root_half, 1};
              },
              Outcome::inaccurate, "the spring holds back in proportion"});
  growth.add({"along the rod", std::string(ode::brief<ode::RungeKutta4>().name), foldings,
              [=](double n) { return late_rate<ode::RungeKutta4>(along, rate, n, 1 / (64 * rate)); }});
  growth.add({"along the rod", std::string(ode::brief<ode::Fehlberg78>().name), foldings,
              [=](double n) { return late_rate<ode::Fehlberg78>(along, rate, n, 1e-12); }});
  return growth;
}

}  // namespace oddity::turning_rod
