#pragma once

#include <array>
#include <cmath>

#include "chapters/03_rigid_body_motion/15_turning_rod/models.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "chapters/03_rigid_body_motion/shared/listed_runge_kutta.hpp"
#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "solvers/ode/events.hpp"

/// A mass on a turning rod: its Lagrangian, and the quantities of exercise 3.15.
namespace oddity::turning_rod {

// ---- the Lagrangian ---------------------------------------------------------------------------------------

/// The rod's direction after turning by an angle: Rodrigues' formula for (1, 0, 1)/sqrt(2) about k.
template <class T>
std::array<T, 3> direction(const T& angle) {
  using std::cos, std::sin;
  const std::array<double, 3> d{root_half<double>, 0, root_half<double>}, k{0, 0, 1};
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

/// Minus the gradient of the spring's energy, by dual numbers.
inline std::array<double, 3> force_of(const Rod<double>& spring, const std::array<double, 3>& x) {
  std::array<double, 3> f;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Dual<double>, 3> y{x[0], x[1], x[2]};
    y[i].slope = 1;
    f[i] = -spring.energy(y).slope;
  }
  return f;
}

struct Lagrangian {
  double m, w;
  Rod<double> spring;
  template <class T>
  T operator()(const T& s, const T& v, const T& t) const {
    return KineticEnergy{m, w}(s, v, t) - spring.energy(position(s, t, w));
  }
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
  Rod<double> spring() const { return {{m, c, K, w, s}, ell}; }
  Lagrangian L() const { return {m, w, spring()}; }
  KineticEnergy T() const { return {m, w}; }
  std::array<double, 3> x() const { return position(s, t, w); }
  std::array<double, 3> velocity() const { return turning_rod::velocity(s, v, t, w); }
};

// ---- the methods ------------------------------------------------------------------------------------------

inline std::vector<double> inputs(const Given<double>& rod) { return {rod.m, rod.c, rod.K, rod.w, rod.s0}; }

inline Quantity slide(const Given<double>& rod, const Horizon& horizon, const Reference& truth) {
  Quantity place = quantity("slide", "m", "position at " + times_up_to(horizon),
                            trajectory(truth, "03_15_slide", inputs(rod), horizon), {});
  place.need = {5e-7 * size_of(place.reference.value), "six digits, as many as are printed"};
  Ladder(place, horizon, halving("step", 0.125, 9), tolerances())
      .closed_form("no spring", NoSpring<double>{{rod}}, Outcome::inaccurate,
                   "the spring does most of the work")
      .closed_form("spring's end on the axis", EndOnTheAxis<double>{{rod}}, Outcome::inaccurate,
                   "it is the turning of the spring's end that pulls the mass down")
      .closed_form("rigid spring", RigidSpring<double>{{rod}}, Outcome::inaccurate, "the spring gives way")
      .by<ode::RungeKutta4>("listing as printed", AsListed<double>{{rod}}, Outcome::inaccurate,
                            "it multiplies the time by 1/sqrt(2) where the rod turns by pi/4 a second")
      .by<ode::RungeKutta4>("listing with the other rest length", listed_with_other_rest_length(rod),
                            Outcome::inaccurate,
                            "with sqrt((b-c)^2 + c^2) the spring is stretched from the start")
      .by_common("along the rod", AlongTheRod<double>{{rod}})
      .by_others("along the rod", AlongTheRod<double>{{rod}},
                 {{"linearly implicit Euler", Outcome::inaccurate,
                   "its order is too low for this need at this step"}})
      .by_few("along the rod, with the work", AlongTheRodWithWork<double>{{rod}})
      .by_common("in the turning plane", InTheTurningPlane<double>{{rod}})
      .by_common("Cartesian with constraints", CartesianWithConstraints<double>{{rod}});
  return place;
}

/// The same rod with a stiff spring: a geometric motion and a tremor about it.
inline Quantity stiff_spring(const Given<double>& rod, const Horizon& horizon, const Reference& truth) {
  Quantity place = quantity("stiff_spring", "m", "position at " + times_up_to(horizon) + ", the spring stiff",
                            trajectory(truth, "03_15_slide", inputs(rod), horizon), {1e-3, "a millimetre"});
  const AlongTheRod<double> along{{rod}};
  const std::string name = "along the rod", rigid = "rigid spring";
  Ladder(place, horizon, halving("step", 0.0625, 6), tolerances())
      .closed_form(rigid, RigidSpring<double>{{rod}})
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
Answer late_rate(const AlongTheRod<double>& rod, double rate, double foldings, double setting) {
  return answer(ode::integrate<Algorithm>(rod, rod.start(), 0, foldings / rate, setting),
                [](const AlongTheRod<double>::State& x) { return x[1] / x[0]; });
}

/// Beyond w = sqrt(2K/m) the centrifugal force grows faster along the rod than the spring's.
inline Quantity runaway(const Given<double>& rod) {
  const double rate = std::sqrt(rod.w * rod.w / 2 - rod.K / rod.m);
  Quantity growth{"runaway",
                  "1/s",
                  "rate at which the distance grows in the end, beyond the speed sqrt(2K/m)",
                  {"sqrt(w^2/2 - K/m)", rate},
                  1e-15 * rate,
                  {1e-8 * rate, "eight digits"}};
  const AlongTheRod<double> along{{rod}};
  const Knob foldings = doubling("e-foldings", 2, 5);
  growth.add({"no spring", "closed form", no_knob(),
              [=](double) {
                return Answer{rod.w * root_half<double>, 1};
              },
              Outcome::inaccurate, "the spring holds back in proportion"});
  growth.add({"along the rod", std::string(ode::brief<ode::RungeKutta4>().name), foldings,
              [=](double n) { return late_rate<ode::RungeKutta4>(along, rate, n, 1 / (64 * rate)); }});
  growth.add({"along the rod", std::string(ode::brief<ode::Fehlberg78>().name), foldings,
              [=](double n) { return late_rate<ode::Fehlberg78>(along, rate, n, 1e-12); }});
  return growth;
}

}  // namespace oddity::turning_rod
