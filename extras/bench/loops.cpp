#include "extras/bench/loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "extras/bench/models.hpp"
#include "report/study/parallel.hpp"
#include "solvers/ode/all.hpp"

namespace oddity {

namespace {

// ---- by hand ------------------------------------------------------------------------------------------

/// Calls f(0), ..., f(N - 1) with the loop unrolled.
template <std::size_t N, class F>
[[gnu::always_inline]] inline void unrolled(const F& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (f(I), ...); }
  (std::make_index_sequence<N>());
}

struct PendulumByHand {
  static constexpr std::size_t half = 1;
  double minus_g_over_L;
  void force(const double* q, double* a) const { a[0] = minus_g_over_L * std::sin(q[0]); }
  void rhs(const double* x, double* d) const { d[0] = x[1], force(x, d + 1); }

  void runge_kutta_4(double* x, double h, long steps) const {
    double q = x[0], v = x[1];
    for (long i = 0; i < steps; ++i) {
      const double q1 = v, v1 = minus_g_over_L * std::sin(q);
      const double q2 = v + h / 2 * v1, v2 = minus_g_over_L * std::sin(q + h / 2 * q1);
      const double q3 = v + h / 2 * v2, v3 = minus_g_over_L * std::sin(q + h / 2 * q2);
      const double q4 = v + h * v3, v4 = minus_g_over_L * std::sin(q + h * q3);
      q = q + h / 6 * q1 + h / 3 * q2 + h / 3 * q3 + h / 6 * q4;
      v = v + h / 6 * v1 + h / 3 * v2 + h / 3 * v3 + h / 6 * v4;
    }
    x[0] = q, x[1] = v;
  }
};

struct PlanarKeplerByHand {
  static constexpr std::size_t half = 2;
  double mu;
  double pull(double x, double y) const {
    const double square = x * x + y * y;
    return -mu / (square * std::sqrt(square));
  }
  void force(const double* q, double* a) const {
    const double p = pull(q[0], q[1]);
    a[0] = p * q[0], a[1] = p * q[1];
  }
  void rhs(const double* x, double* d) const { d[0] = x[2], d[1] = x[3], force(x, d + 2); }

  void runge_kutta_4(double* s, double h, long steps) const {
    double x = s[0], y = s[1], u = s[2], v = s[3];
    for (long i = 0; i < steps; ++i) {
      const double p1 = pull(x, y), x1 = u, y1 = v, u1 = p1 * x, v1 = p1 * y;
      const double xa = x + h / 2 * x1, ya = y + h / 2 * y1, p2 = pull(xa, ya);
      const double x2 = u + h / 2 * u1, y2 = v + h / 2 * v1, u2 = p2 * xa, v2 = p2 * ya;
      const double xb = x + h / 2 * x2, yb = y + h / 2 * y2, p3 = pull(xb, yb);
      const double x3 = u + h / 2 * u2, y3 = v + h / 2 * v2, u3 = p3 * xb, v3 = p3 * yb;
      const double xc = x + h * x3, yc = y + h * y3, p4 = pull(xc, yc);
      const double x4 = u + h * u3, y4 = v + h * v3, u4 = p4 * xc, v4 = p4 * yc;
      x = x + h / 6 * x1 + h / 3 * x2 + h / 3 * x3 + h / 6 * x4;
      y = y + h / 6 * y1 + h / 3 * y2 + h / 3 * y3 + h / 6 * y4;
      u = u + h / 6 * u1 + h / 3 * u2 + h / 3 * u3 + h / 6 * u4;
      v = v + h / 6 * v1 + h / 3 * v2 + h / 3 * v3 + h / 6 * v4;
    }
    s[0] = x, s[1] = y, s[2] = u, s[3] = v;
  }
};

struct SpatialKeplerByHand {
  static constexpr std::size_t half = 3;
  double mu;
  double pull(double x, double y, double z) const {
    const double square = x * x + y * y + z * z;
    return -mu / (square * std::sqrt(square));
  }
  void force(const double* q, double* a) const {
    const double p = pull(q[0], q[1], q[2]);
    a[0] = p * q[0], a[1] = p * q[1], a[2] = p * q[2];
  }
  void rhs(const double* x, double* d) const { d[0] = x[3], d[1] = x[4], d[2] = x[5], force(x, d + 3); }

  void runge_kutta_4(double* s, double h, long steps) const {
    double x = s[0], y = s[1], z = s[2], u = s[3], v = s[4], w = s[5];
    for (long i = 0; i < steps; ++i) {
      const double p1 = pull(x, y, z), x1 = u, y1 = v, z1 = w, u1 = p1 * x, v1 = p1 * y, w1 = p1 * z;
      const double xa = x + h / 2 * x1, ya = y + h / 2 * y1, za = z + h / 2 * z1, p2 = pull(xa, ya, za);
      const double x2 = u + h / 2 * u1, y2 = v + h / 2 * v1, z2 = w + h / 2 * w1;
      const double u2 = p2 * xa, v2 = p2 * ya, w2 = p2 * za;
      const double xb = x + h / 2 * x2, yb = y + h / 2 * y2, zb = z + h / 2 * z2, p3 = pull(xb, yb, zb);
      const double x3 = u + h / 2 * u2, y3 = v + h / 2 * v2, z3 = w + h / 2 * w2;
      const double u3 = p3 * xb, v3 = p3 * yb, w3 = p3 * zb;
      const double xc = x + h * x3, yc = y + h * y3, zc = z + h * z3, p4 = pull(xc, yc, zc);
      const double x4 = u + h * u3, y4 = v + h * v3, z4 = w + h * w3;
      const double u4 = p4 * xc, v4 = p4 * yc, w4 = p4 * zc;
      x = x + h / 6 * x1 + h / 3 * x2 + h / 3 * x3 + h / 6 * x4;
      y = y + h / 6 * y1 + h / 3 * y2 + h / 3 * y3 + h / 6 * y4;
      z = z + h / 6 * z1 + h / 3 * z2 + h / 3 * z3 + h / 6 * z4;
      u = u + h / 6 * u1 + h / 3 * u2 + h / 3 * u3 + h / 6 * u4;
      v = v + h / 6 * v1 + h / 3 * v2 + h / 3 * v3 + h / 6 * v4;
      w = w + h / 6 * w1 + h / 3 * w2 + h / 3 * w3 + h / 6 * w4;
    }
    s[0] = x, s[1] = y, s[2] = z, s[3] = u, s[4] = v, s[5] = w;
  }
};

template <class Hand>
void explicit_euler(const Hand& model, double* out, double h, long steps) {
  constexpr std::size_t n = 2 * Hand::half;
  double x[n], k[n];
  unrolled<n>([&](auto i) { x[i] = out[i]; });
  for (long s = 0; s < steps; ++s) {
    model.rhs(x, k);
    unrolled<n>([&](auto i) { x[i] = x[i] + h * k[i]; });
  }
  unrolled<n>([&](auto i) { out[i] = x[i]; });
}

template <class Hand>
void symplectic_euler(const Hand& model, double* out, double h, long steps) {
  constexpr std::size_t n = Hand::half;
  double q[n], v[n], a[n];
  unrolled<n>([&](auto i) { q[i] = out[i], v[i] = out[n + i]; });
  for (long s = 0; s < steps; ++s) {
    model.force(q, a);
    unrolled<n>([&](auto i) { v[i] = v[i] + h * a[i]; });
    unrolled<n>([&](auto i) { q[i] = q[i] + h * v[i]; });
  }
  unrolled<n>([&](auto i) { out[i] = q[i], out[n + i] = v[i]; });
}

template <class Hand>
void velocity_verlet(const Hand& model, double* out, double h, long steps) {
  constexpr std::size_t n = Hand::half;
  double q[n], v[n], a[n], a_next[n];
  unrolled<n>([&](auto i) { q[i] = out[i], v[i] = out[n + i]; });
  model.force(q, a);
  for (long s = 0; s < steps; ++s) {
    unrolled<n>([&](auto i) { q[i] = q[i] + h * v[i] + h * h / 2 * a[i]; });
    model.force(q, a_next);
    unrolled<n>([&](auto i) { v[i] = v[i] + h / 2 * a[i] + h / 2 * a_next[i], a[i] = a_next[i]; });
  }
  unrolled<n>([&](auto i) { out[i] = q[i], out[n + i] = v[i]; });
}

/// Fehlberg 7(8) with Odeint's step control; the zeros of the tableau are left out.
template <class Hand>
long fehlberg_78(const Hand& model, double* out, double span, double tolerance) {
  constexpr std::size_t n = 2 * Hand::half;
  double x[n], y[n], k1[n], k2[n], k3[n], k4[n], k5[n], k6[n], k7[n], k8[n], k9[n], k10[n], k11[n], k12[n],
      k13[n];
  unrolled<n>([&](auto i) { x[i] = out[i]; });
  const auto stage = [&](double* k, const auto& sum) __attribute__((always_inline)) {
    unrolled<n>([&](auto i) { y[i] = sum(i); });
    model.rhs(y, k);
  };
  long evaluations = 0;
  double t = 0, next = span / 1000;
  while (t != span) {
    const bool last = next >= span - t;
    const double h = last ? span - t : next;
    model.rhs(x, k1);
    // clang-format off
    stage(k2, [&](auto i) { return x[i] + h * (2. / 27) * k1[i]; });
    stage(k3, [&](auto i) { return x[i] + h * (1. / 36) * k1[i] + h * (1. / 12) * k2[i]; });
    stage(k4, [&](auto i) { return x[i] + h * (1. / 24) * k1[i] + h * (1. / 8) * k3[i]; });
    stage(k5, [&](auto i) { return x[i] + h * (5. / 12) * k1[i] + h * (-25. / 16) * k3[i] + h * (25. / 16) * k4[i]; });
    stage(k6, [&](auto i) { return x[i] + h * (1. / 20) * k1[i] + h * (1. / 4) * k4[i] + h * (1. / 5) * k5[i]; });
    stage(k7, [&](auto i) {
      return x[i] + h * (-25. / 108) * k1[i] + h * (125. / 108) * k4[i] + h * (-65. / 27) * k5[i] + h * (125. / 54) * k6[i]; });
    stage(k8, [&](auto i) {
      return x[i] + h * (31. / 300) * k1[i] + h * (61. / 225) * k5[i] + h * (-2. / 9) * k6[i] + h * (13. / 900) * k7[i]; });
    stage(k9, [&](auto i) {
      return x[i] + h * 2. * k1[i] + h * (-53. / 6) * k4[i] + h * (704. / 45) * k5[i] + h * (-107. / 9) * k6[i]
             + h * (67. / 90) * k7[i] + h * 3. * k8[i]; });
    stage(k10, [&](auto i) {
      return x[i] + h * (-91. / 108) * k1[i] + h * (23. / 108) * k4[i] + h * (-976. / 135) * k5[i] + h * (311. / 54) * k6[i]
             + h * (-19. / 60) * k7[i] + h * (17. / 6) * k8[i] + h * (-1. / 12) * k9[i]; });
    stage(k11, [&](auto i) {
      return x[i] + h * (2383. / 4100) * k1[i] + h * (-341. / 164) * k4[i] + h * (4496. / 1025) * k5[i] + h * (-301. / 82) * k6[i]
             + h * (2133. / 4100) * k7[i] + h * (45. / 82) * k8[i] + h * (45. / 164) * k9[i] + h * (18. / 41) * k10[i]; });
    stage(k12, [&](auto i) {
      return x[i] + h * (3. / 205) * k1[i] + h * (-6. / 41) * k6[i] + h * (-3. / 205) * k7[i] + h * (-3. / 41) * k8[i]
             + h * (3. / 41) * k9[i] + h * (6. / 41) * k10[i]; });
    stage(k13, [&](auto i) {
      return x[i] + h * (-1777. / 4100) * k1[i] + h * (-341. / 164) * k4[i] + h * (4496. / 1025) * k5[i] + h * (-289. / 82) * k6[i]
             + h * (2193. / 4100) * k7[i] + h * (51. / 82) * k8[i] + h * (33. / 164) * k9[i] + h * (12. / 41) * k10[i] + h * k12[i]; });
    // clang-format on
    evaluations += 13;
    double error = 0;
    unrolled<n>([&](auto i) {
      y[i] = x[i] + h * (34. / 105) * k6[i] + h * (9. / 35) * k7[i] + h * (9. / 35) * k8[i] +
             h * (9. / 280) * k9[i] + h * (9. / 280) * k10[i] + h * (41. / 840) * k12[i] +
             h * (41. / 840) * k13[i];
      const double estimate = h * (-41. / 840) * k1[i] + h * (-41. / 840) * k11[i] +
                              h * (41. / 840) * k12[i] + h * (41. / 840) * k13[i];
      const double size = std::abs(x[i]) + std::abs(h) * std::abs(k1[i]);
      error = std::max(error, std::abs(estimate) / (tolerance + tolerance * size));
    });
    if (error > 1) {
      next = h * std::max(0.9 * std::pow(error, -1. / 6), 0.2);
      continue;
    }
    t = last ? span : t + h;
    const double wider = error < 0.5 ? h * 0.9 * std::pow(std::max(std::pow(5., -8), error), -1. / 8) : h;
    next = last ? std::max(next, wider) : wider;
    unrolled<n>([&](auto i) { x[i] = y[i]; });
  }
  unrolled<n>([&](auto i) { out[i] = x[i]; });
  return evaluations;
}

// ---- the races --------------------------------------------------------------------------------------------

using raced::span, raced::step, raced::tolerance;
constexpr long steps = 2048;
static_assert(static_cast<double>(steps) * step == span);

template <class Algorithm, class Model>
std::function<Run()> inlined(const Model& model, const typename Model::State& start) {
  return [=] {
    const std::array times{0.0, span};
    const auto path = ode::integrate_inlined<Algorithm>(model, start, std::span<const double>(times),
                                                        raced::setting(Algorithm::kind));
    return Run{{path.value.back().begin(), path.value.back().end()}, path.evaluations};
  };
}

/// loop(x) advances x over the span and returns its evaluations.
template <class State, class Loop>
std::function<Run()> by_hand(const State& start, const Loop& loop) {
  return [=] {
    State x = start;
    const long evaluations = loop(x.data());
    return Run{{x.begin(), x.end()}, evaluations};
  };
}

template <class Model, class Hand>
void add_races(std::vector<Race>& all, const std::string& name, const Model& model, const Hand& hand,
               const typename Model::State& start) {
  const auto race = [&]<class Algorithm>(double limit, const auto& loop) {
    all.push_back({name, static_cast<int>(start.size()), std::string(Algorithm::name), limit,
                   by_hand(start, loop), inlined<Algorithm>(model, start),
                   raced::precompiled(model, start, Algorithm::name, Algorithm::kind)});
  };
  race.template operator()<ode::ExplicitEuler>(0, [=](double* x) {
    explicit_euler(hand, x, step, steps);
    return steps;
  });
  race.template operator()<ode::SymplecticEuler>(1.1, [=](double* x) {
    symplectic_euler(hand, x, step, steps);
    return steps;
  });
  race.template operator()<ode::VelocityVerlet>(1.1, [=](double* x) {
    velocity_verlet(hand, x, step, steps);
    return steps + 1;
  });
  race.template operator()<ode::RungeKutta4>(1.02, [=](double* x) {
    hand.runge_kutta_4(x, step, steps);
    return 4 * steps;
  });
  race.template operator()<ode::Fehlberg78>(1.5,
                                            [=](double* x) { return fehlberg_78(hand, x, span, tolerance); });
}

}  // namespace

std::vector<Race> races() {
  std::vector<Race> all;
  const pendulum::OneAngle<double> swing{{std::numbers::pi / 6, 1, 9.81}};
  add_races(all, "pendulum", swing, PendulumByHand{-9.81}, swing.start());
  const kepler::Cartesian<double> planet{{1, 1, 1, 0, 0, 1.2}};
  add_races(all, "planet in its plane", planet, PlanarKeplerByHand{1}, planet.start());
  add_races(all, "planet in space", raced::SpatialKepler{1}, SpatialKeplerByHand{1}, {1, 0, 0, 0, 1.1, 0.4});
  return all;
}

namespace {

constexpr int samples = 32;

/// Observables at the horizon's times, one known value after the other; the times are computed in parallel.
template <class At>
Known gathered(const Horizon& horizon, const At& at) {
  const auto times = horizon.times();
  std::vector<Known> known(times.size());
  in_parallel(times.size(), [&](std::size_t i) {
    if (times[i] > 0) known[i] = at(times[i]);
  });
  Known all;
  for (const Known& one : known) {
    all.value.insert(all.value.end(), one.value.begin(), one.value.end());
    all.error = std::max(all.error, one.error);
    all.source = one.source;
  }
  return all;
}

Resolution half_decades() {
  Resolution resolution{"tolerance", {}};
  for (int k = 8; k <= 26; ++k) resolution.settings.push_back(std::pow(10, -k / 2.0));
  return resolution;
}

/// The model by several algorithms, each compiled into it.
template <class Model>
Quantity motion(const std::string& name, const Model& model, const Known& known, const Horizon& horizon) {
  Quantity quantity = oddity::quantity(name, "1", name, known, {1e-9, "nine decimals"});
  quantity.samples = horizon.samples;
  const auto by = [&]<class Algorithm>(Resolution resolution) {
    const auto run = [model, times = horizon.times()](double setting) {
      const auto path =
          ode::integrate_inlined<Algorithm>(model, model.start(), std::span<const double>(times), setting);
      std::vector<double> seen;
      for (std::size_t i = 1; i < path.value.size(); ++i)
        for (double x : model.observe(path.value[i], times[i])) seen.push_back(x);
      return Answer{
          Value(std::move(seen)), path.evaluations, path.error_estimate, 0, path.ending, path.message};
    };
    quantity.add(Method{name, std::string(Algorithm::name), std::move(resolution), run});
  };
  by.template operator()<ode::RungeKutta4>(halving("step", 0x1p-6, 10));
  by.template operator()<ode::CashKarp54>(half_decades());
  by.template operator()<ode::DormandPrince54>(half_decades());
  by.template operator()<ode::Fehlberg78>(half_decades());
  by.template operator()<ode::BulirschStoer>(half_decades());
  by.template operator()<ode::Taylor>(half_decades());
  return quantity;
}

/// The known observables at the last of all times.
Known last_of(const Known& all, std::size_t observables) {
  return {
      {all.value.end() - static_cast<std::ptrdiff_t>(observables), all.value.end()}, all.error, all.source};
}

Contest pendulum_contest(const Reference& truth) {
  const pendulum::Given<double> start{std::numbers::pi / 6, 1, 9.81};
  const Horizon through{10, samples}, to_end{through.end, 1};
  const Known known = gathered(through, [&](double t) {
    return truth("03_05_swing", {start.a, start.L, start.g, t});
  });
  const pendulum::OneAngle<double> model{start};
  const pendulum::FourierSeries<double> exact(start);
  return {.says = "pendulum from 30 degrees over 10 s",
          .hand = "pendulum",
          .to_end = motion("one angle", model, last_of(known, 1), to_end),
          .through = motion("one angle", model, known, through),
          .limit = 1400,
          .closed_form = "Jacobi's function by its Fourier series",
          .at = [exact](double t) { return exact.at(t)[0]; },
          .closed_limit = 20,
          .end = through.end};
}

/// Semiaxis and G M are 1, the motion starts at the perihelion; M = t is folded into [0, pi] for the table.
Contest kepler_contest(const Reference& truth) {
  constexpr double e = 0.9, pi = std::numbers::pi;
  const double minor = std::sqrt(1 - e * e);
  const kepler::Start start{1, 1, 1 - e, 0, 0, minor / ((1 - e) * (1 - e))};
  const Horizon through{3.2 * 2 * pi, samples}, to_end{through.end, 1};
  const Known known = gathered(through, [&](double t) {
    const double M = std::remainder(t, 2 * pi);
    Known E = truth("03_03_eccentric_anomaly", {e, std::abs(M)});
    E.value = {std::cos(E.value[0]) - e, std::copysign(minor * std::sin(E.value[0]), M)};
    return E;
  });
  const kepler::Cartesian<double> model{start};
  const kepler::ByKeplersEquation<double> exact(start);
  return {.says = "planet with e = 0.9 over 3.2 orbits",
          .hand = "planet in its plane",
          .to_end = motion("Cartesian", model, last_of(known, 2), to_end),
          .through = motion("Cartesian", model, known, through),
          .limit = 6000,
          .closed_form = "Kepler's equation by Newton's method",
          .at = [exact](double t) { return exact.at(t)[0]; },
          .closed_limit = 20,
          .end = through.end};
}

}  // namespace

std::vector<Contest> contests(const Reference& truth) {
  return {pendulum_contest(truth), kepler_contest(truth)};
}

}  // namespace oddity
