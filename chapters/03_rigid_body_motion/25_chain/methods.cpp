// The quantities of exercise 3.25: the motion, how far ahead it can be predicted, and a chain of n.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "chapters/03_rigid_body_motion/25_chain/chain.hpp"
#include "chapters/scene.hpp"
#include "chapters/stops.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"
#include "solvers/counted_calls.hpp"
#include "solvers/dual.hpp"
#include "solvers/linear.hpp"
#include "solvers/ode/steps_in.hpp"

namespace oddity::ex03_25 {

using namespace chain;
using enum Outcome;

namespace {

using Tensions = Angles<double, Equations::tensions>;
using Dense = Angles<double, Equations::dense>;
using Three = std::array<double, 3>;

std::vector<double> inputs(const Triple& c) {
  return {c.m[0], c.m[1],     c.m[2],     c.r[0],     c.r[1],     c.r[2],     c.g,
          c.h,    c.theta[0], c.theta[1], c.theta[2], c.omega[0], c.omega[1], c.omega[2]};
}

using SmallAngles = chain::Modes<double>;

Eigen::Matrix3d as_eigen(const SmallAngles::Matrix& a) {
  Eigen::Matrix3d whole;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) whole(i, j) = a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return whole;
}

constexpr Triple chaotic{{1, 0.75, 0.5}, {1, 0.75, 0.5}, 9.8125, 2.5, {2, 2.5, 3}, {0, 0, 0}};

Quantity small_swing(const Triple& like, const Reference& truth) {
  const Horizon horizon{4};
  Triple start = like;
  start.theta = {0x1p-10, 0x1.8p-10, 0x1p-9};
  start.omega = {0, 0, 0};
  Quantity q = quantity("small_swing", "m", "the masses' positions from angles of thousandths",
                        trajectory(truth, "03_25_chain", inputs(start), horizon), {1e-6, "a micrometre"});
  SceneMethods(q, horizon, halving("step", 0x1p-4, 7), tolerances(3, 9))
      .closed_form("normal modes", SmallAngles(start))
      .by<ode::RungeKutta4>("tensions", Tensions{start})
      .by<ode::DormandPrince54>("tensions", Tensions{start});
  return q;
}

Quantity mode_frequencies(const Triple& c, const Reference& truth) {
  std::vector<double> at = inputs(c);
  at.resize(7);
  const Known known = truth("03_25_modes", at);
  const double size = size_of(known.value);
  Quantity q = quantity("mode_frequencies", "rad/s", "angular frequencies of the three small oscillations",
                        known, {1e-10 * size, "ten digits of the fastest"});
  q.add({"dense pair (K, M)", "GSL, Cholesky and QR", no_resolution(), [=](double) {
           const oddity::Modes all =
               modes(as_eigen(SmallAngles::stiffness(c)), as_eigen(SmallAngles::mass_matrix(c)));
           return Answer{Value(all.squares.cwiseSqrt()), 1};
         }});
  q.add({"tensions at rest", "one link's accelerations by dual numbers, then GSL's QR", no_resolution(),
         [=](double) {
           Eigen::Matrix3d minus;
           long accelerations = 0;
           for (int j = 0; j < 3; ++j, ++accelerations) {
             std::array<Dual<double>, 3> theta{}, omega{}, alpha{};
             theta[static_cast<std::size_t>(j)].slope = 1;
             by_tensions(c.m, c.r, c.g, theta, omega, alpha);
             for (int i = 0; i < 3; ++i) minus(i, j) = -alpha[static_cast<std::size_t>(i)].slope;
           }
           std::vector<double> w;
           for (const auto& square : eigenvalues(minus)) w.push_back(std::sqrt(square.real()));
           std::ranges::sort(w);
           return Answer{Value(w), accelerations};
         }});
  return q;
}

// ---- in other precisions ----------------------------------------------------------------------------------

/// Gragg's modified midpoint rule with 2, 4, ..., 20 substeps, extrapolated: order 20 in the number type T,
/// and 120 evaluations per step. The remaining error is rounding.
template <class T, std::size_t N, class Rhs>
void extrapolated_step(const Rhs& system, std::array<T, N>& x, T step, long& evaluations) {
  const auto rhs = counted_calls(system, evaluations);
  constexpr int columns = 10;
  std::array<std::array<T, N>, columns> table;
  for (int k = 1; k <= columns; ++k) {
    const T h = step / static_cast<T>(2 * k);
    std::array<T, N> before = x, now = x, slope{};
    rhs(x, slope, T(0));
    for (std::size_t i = 0; i < N; ++i) now[i] += h * slope[i];
    for (int j = 1; j <= 2 * k; ++j) {
      rhs(now, slope, T(0));
      for (std::size_t i = 0; i < N; ++i) {
        const T next = before[i] + (j < 2 * k ? 2 * h : h) * slope[i];
        before[i] = now[i];
        now[i] = next;
      }
    }
    auto& row = table[static_cast<std::size_t>(k - 1)];
    for (std::size_t i = 0; i < N; ++i) row[i] = (now[i] + before[i]) / 2;
    for (int j = k - 1; j > 0; --j) {
      const T ratio = static_cast<T>(k) / static_cast<T>(j), less = 1 / (ratio * ratio - 1);
      const auto c = static_cast<std::size_t>(j - 1);
      for (std::size_t i = 0; i < N; ++i)
        table[c][i] = table[c + 1][i] + (table[c + 1][i] - table[c][i]) * less;
    }
  }
  x = table[0];
}

/// Positions at the horizon's times, with the state in T.
template <class T>
Answer in_precision(const Triple& c, const Horizon& horizon, double step) {
  const Tensions model{c};
  std::array<T, 6> x;
  for (std::size_t i = 0; i < 6; ++i) x[i] = static_cast<T>(model.start()[i]);
  Answer answer;
  std::vector<double> seen;
  const auto go_on = [&](double from, double to) {
    const int steps = static_cast<int>(ode::steps_in(from, to, step));
    for (int i = 0; i < steps; ++i)
      extrapolated_step(model, x, static_cast<T>(to - from) / static_cast<T>(steps), answer.evaluations);
    return true;
  };
  through_times(horizon, go_on, [&](double) {
    for (const T& y : c.positions(x)) seen.push_back(static_cast<double>(y));
  });
  answer.value = Value(std::move(seen));
  return answer;
}

/// The time at which the positions in T, at whole seconds, have an error of `close`. The error's logarithm is
/// interpolated linearly between seconds.
template <class T>
double predicted_until(const Triple& c, const Horizon& seconds, const Value& truth, double close, double step,
                       long& evaluations) {
  const Answer answer = in_precision<T>(c, seconds, step);
  evaluations += answer.evaluations;
  const auto times = seconds.times();
  double before = std::numeric_limits<T>::epsilon();
  for (std::size_t i = 1; i < times.size(); ++i) {
    double error = 0;
    for (std::size_t k = 6 * (i - 1); k < 6 * i; ++k)
      error = std::max(error, std::abs(answer.value[k] - truth[k]));
    if (error > close)
      return times[i - 1] + (times[i] - times[i - 1]) * std::log(close / before) / std::log(error / before);
    before = std::max(error, before);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Seconds that each decimal digit adds to the prediction, from the precision A to B: the mean over several
/// steps next to this one, since each has different roundings.
template <class A, class B>
Answer seconds_per_digit(const Triple& c, const Horizon& seconds, const Value& truth, double close,
                         double step) {
  constexpr int runs = 8;
  Answer answer;
  double more = 0;
  for (int i = 0; i < runs; ++i) {
    const double h = 1 / (1 / step + i);
    more += (predicted_until<B>(c, seconds, truth, close, h, answer.evaluations) -
             predicted_until<A>(c, seconds, truth, close, h, answer.evaluations)) /
            runs;
  }
  answer.value = more / std::log10(static_cast<double>(std::numeric_limits<A>::epsilon()) /
                                   static_cast<double>(std::numeric_limits<B>::epsilon()));
  return answer;
}

// ---- how fast neighbours diverge --------------------------------------------------------------------------

/// The state and its derivative by theta1(0), integrated by dual numbers.
struct Variational {
  Tensions along;
  using State = std::array<double, 12>;
  void operator()(const State& x, State& dxdt, double t) const {
    std::array<Dual<double>, 6> y, slope;
    for (std::size_t i = 0; i < 6; ++i) y[i] = {x[i], x[i + 6]};
    along(y, slope, Dual<double>(t));
    for (std::size_t i = 0; i < 6; ++i) {
      dxdt[i] = slope[i].value;
      dxdt[i + 6] = slope[i].slope;
    }
  }
};

double rate_of(const Value& change, double t) { return std::log(size_of(change)) / t; }

Answer growth_by_variation(const Triple& c, double t, double tolerance) {
  const Variational model{{c}};
  Variational::State x{};
  for (std::size_t i = 0; i < 6; ++i) x[i] = model.along.start()[i];
  x[6] = 1;
  const auto end = ode::integrate<ode::Fehlberg78>(model, x, 0, t, tolerance);
  return answer(end, [&](const Variational::State& y) {
    std::array<Dual<double>, 3> q;
    for (std::size_t i = 0; i < 3; ++i) q[i] = {y[i], y[i + 6]};
    std::vector<double> change;
    for (const auto& p : c.positions(q)) change.push_back(p.slope);
    return rate_of(change, t);
  });
}

Answer growth_by_neighbours(const Triple& c, double t, double apart) {
  const auto end = [&](double by) {
    Tensions model{c};
    model.p.theta[0] += by;
    return ode::integrate<ode::Fehlberg78>(model, model.start(), 0, t, 1e-14);
  };
  const auto above = end(apart / 2), below = end(-apart / 2);
  const auto p = c.positions(above.value), q = c.positions(below.value);
  std::vector<double> change;
  for (std::size_t i = 0; i < 6; ++i) change.push_back((p[i] - q[i]) / apart);
  return {rate_of(change, t), above.evaluations + below.evaluations};
}

// ---- chaos ------------------------------------------------------------------------------------------------

/// Expected outcome of each precision if its only error is rounding.
struct Predicts {
  Outcome in_float, in_double, in_long_double;
};

Quantity prediction(double t, const Reference& truth, const Predicts& expected,
                    const Tolerance& needed = {1e-2, "a centimetre"}) {
  const Horizon once{t, 1};
  const std::string seconds = format_shortest(t) + " s";
  Quantity q = quantity("chaos_" + format_shortest(t) + "s", "m",
                        "positions " + seconds + " after rest at (2, 2.5, 3) rad, in three precisions",
                        trajectory(truth, "03_25_chain", inputs(chaotic), once), needed);
  const Resolution steps = halving("step", 0x1p-3, 4);
  const std::string why = "its roundings have grown to the size of the motion";
  const auto add = [&](std::string model, auto number, Outcome outcome) {
    q.add({std::move(model), "extrapolated midpoint, order 20", steps,
           [once](double step) { return in_precision<decltype(number)>(chaotic, once, step); }, outcome,
           outcome == ok ? "" : why});
  };
  add("float", 0.0f, expected.in_float);
  add("double", 0.0, expected.in_double);
  add("long double", 0.0L, expected.in_long_double);
  return q;
}

/// log |d(position)/d(theta1)| of the chaotic initial condition at t.
Known parting(double t, const Reference& truth) {
  std::vector<double> at = inputs(chaotic);
  at.push_back(t);
  Known known = truth("03_25_growth", at);
  known.value[0] *= t;
  return known;
}

/// The time gained by each digit from the precision A to B, compared with the rate of divergence from t0 to
/// t1.
template <class A, class B>
Quantity horizon_by_digits(const std::string& name, const std::string& from_A_to_B, double t0, double t1,
                           const Reference& truth) {
  constexpr double close = 1e-2;
  const Horizon seconds{12, 12};
  Known rate = parting(t1, truth);
  const double per_digit = std::numbers::ln10 * (t1 - t0) / (rate.value[0] - parting(t0, truth).value[0]);
  rate.error *= per_digit * per_digit * t1 / (std::numbers::ln10 * (t1 - t0));
  rate.value = {per_digit};
  rate.source = R"($\ln10$ over the growth rate of neighbours from )" + format_shortest(t0) + " to " +
                format_shortest(t1) + " s, " + rate.source;
  Quantity q = quantity(
      name, "s",
      "how much longer the motion from rest at (2, 2.5, 3) rad can be predicted to a centimetre with each "
      "further decimal digit, " +
          from_A_to_B,
      rate, {0.25 * per_digit, "a quarter: neighbours do not part evenly along the motion"});
  const Value all = trajectory(truth, "03_25_chain", inputs(chaotic), seconds).value;
  q.add({from_A_to_B, "extrapolated midpoint, order 20", halving("step", 0x1p-5, 3),
         [=](double step) { return seconds_per_digit<A, B>(chaotic, seconds, all, close, step); }});
  return q;
}

/// Expected outcome of each algorithm at its finest setting.
struct AlgorithmsPredict {
  Outcome runge_kutta, dormand_prince, fehlberg, bulirsch_stoer;
};

Quantity by_algorithm(double t, const Reference& truth, const AlgorithmsPredict& expected) {
  const Horizon once{t, 1};
  Quantity q = quantity("chaos_" + format_shortest(t) + "s_by_algorithm", "m",
                        "positions " + format_shortest(t) + " s after rest at (2, 2.5, 3) rad, by algorithm",
                        trajectory(truth, "03_25_chain", inputs(chaotic), once), {1e-2, "a centimetre"});
  const auto why = [](Outcome outcome) {
    return outcome == ok ? "" : "its first errors have grown to the size of the motion";
  };
  const Tensions model{chaotic};
  SceneMethods(q, once, halving("step", 0x1p-6, 6), tolerances(5, 13))
      .by<ode::RungeKutta4>("tensions", model, expected.runge_kutta, why(expected.runge_kutta))
      .by<ode::DormandPrince54>("tensions", model, expected.dormand_prince, why(expected.dormand_prince))
      .by<ode::Fehlberg78>("tensions", model, expected.fehlberg, why(expected.fehlberg))
      .by<ode::BulirschStoer>("tensions", model, expected.bulirsch_stoer, why(expected.bulirsch_stoer));
  return q;
}

Quantity growth(double t, const Reference& truth) {
  std::vector<double> at = inputs(chaotic);
  at.push_back(t);
  Quantity q = quantity(
      "growth", "1/s",
      "rate at which a change of theta1 grows within " + format_shortest(t) +
          R"( s of rest at (2, 2.5, 3) rad: $\ln|\partial\mathbf x/\partial\theta_1|/t$, $\mathbf x$ the )"
          R"(position)",
      truth("03_25_growth", at), {1e-3, "a thousandth per second"});
  q.add({"variational equation", "Fehlberg 7(8)", tolerances(6, 14),
         [=](double tolerance) { return growth_by_variation(chaotic, t, tolerance); }});
  q.add({"two neighbours",
         "Fehlberg 7(8), their distance",
         {"apart", {1e-2, 1e-4, 1e-6, 1e-8}},
         [=](double apart) { return growth_by_neighbours(chaotic, t, apart); }});
  return q.add(
      Breakdown{"Two neighbours measure the growth only while they are neighbours: @1 rad apart at first "
                "they are as far apart as the pendulum is long within seconds. Dual numbers carry the "
                "derivative itself.",
                "two neighbours, Fehlberg 7(8), their distance",
                1e-2,
                inaccurate,
                "variational equation, Fehlberg 7(8)",
                1e-10,
                {setting_of(Side::broken)}});
}

// ---- n masses ---------------------------------------------------------------------------------------------

/// theta'' from the dense mass matrix for any n, by one of the library's factorizations.
Solved<Eigen::VectorXd> by_factorization(Factorization how, const std::vector<double>& m,
                                         const std::vector<double>& r, double g,
                                         const std::vector<double>& theta, const std::vector<double>& omega) {
  const auto n = static_cast<Eigen::Index>(m.size());
  const auto mu = mass_from_here_on(m);
  Eigen::MatrixXd M(n, n);
  Eigen::VectorXd f(n);
  for (Eigen::Index i = 0; i < n; ++i)
    dense_row(static_cast<std::size_t>(i), mu, r, g, theta, omega, M.col(i).data(), f(i));
  return solve(how, M, f);
}

/// The first, the middle and the last acceleration.
template <class Accelerations>
Value chosen(const Accelerations& alpha, int n) {
  const auto i = static_cast<decltype(alpha.size())>(n);
  return {alpha[0], alpha[(i - 1) / 2], alpha[i - 1]};
}

std::vector<Counted<double>> counted(const std::vector<double>& x) { return {x.begin(), x.end()}; }

/// Cost of assembling the dense equations, and of solving the tridiagonal ones.
Operations work_of_assembly(const Pattern& p, double g) {
  const auto mu = counted(mass_from_here_on(p.m)), r = counted(p.r), theta = counted(p.theta),
             omega = counted(p.omega);
  std::vector<Counted<double>> row(r.size()), right(r.size());
  return operations_of([&] {
    for (std::size_t i = 0; i < r.size(); ++i) dense_row(i, mu, r, g, theta, omega, row.data(), right[i]);
    return right[0];
  });
}
Operations work_of_tensions(const Pattern& p, double g) {
  const auto m = counted(p.m), r = counted(p.r), theta = counted(p.theta), omega = counted(p.omega);
  std::vector<Counted<double>> alpha(r.size());
  return operations_of([&] {
    by_tensions(m, r, g, theta, omega, alpha);
    return alpha[0];
  });
}

Quantity cost(int n, double g, const Reference& truth) {
  const Known known = truth("03_25_accelerations", {static_cast<double>(n), g});
  const double size = size_of(known.value);
  Quantity q =
      quantity("chain_of_" + std::to_string(n), "rad/s^2",
               "angular accelerations of the first, the middle and the last of " + std::to_string(n) +
                   " links; cost in multiplications, divisions and circular functions",
               known, {1e-9 * size, "nine digits"});
  const Pattern p(n);
  const long assembly = work_of_assembly(p, g).all_but_additions(),
             recursion = work_of_tensions(p, g).all_but_additions();
  const auto dense = [&](std::string algorithm, Factorization how) {
    q.add({"dense mass matrix", std::move(algorithm), no_resolution(), [=](double) {
             const auto solved = by_factorization(how, p.m, p.r, g, p.theta, p.omega);
             Answer all = answer(solved, [=](const Eigen::VectorXd& alpha) {
               return chosen(std::vector<double>(alpha.begin(), alpha.end()), n);
             });
             all.evaluations += assembly;
             return all;
           }});
  };
  dense("Cholesky", Factorization::cholesky);
  if (n <= 100) dense("LU with partial pivoting", Factorization::partial_pivot_lu);
  q.add({"tensions", "tridiagonal elimination", no_resolution(), [=](double) {
           std::vector<double> alpha(p.m.size());
           by_tensions(p.m, p.r, g, p.theta, p.omega, alpha);
           return Answer{chosen(alpha, n), recursion};
         }});
  return q;
}

}  // namespace

Quantity hanging(const Triple& start, const Horizon& horizon, const Reference& truth) {
  Quantity q = quantity("motion", "m", "positions of the masses at four times",
                        trajectory(truth, "03_25_chain", inputs(start), horizon), {1e-6, "a micrometre"});
  SceneMethods(q, horizon, halving("step", 0x1p-4, 9), tolerances(3, 11))
      .closed_form("normal modes", SmallAngles(start), inaccurate, "the angles are not small")
      .by_engine_integrators("dense mass matrix", Dense{start}, inaccurate, ok)
      .by_engine_integrators("tensions", Tensions{start}, inaccurate, ok)
      .by_remaining_integrators(
          "tensions", Tensions{start},
          {{"linearly implicit Euler", inaccurate, "a first-order method that damps every swing"}});
  const auto [least, most] = std::ranges::minmax(start.theta, {}, [](double x) { return std::abs(x); });
  return q.add(
      Breakdown{"Independent normal modes describe small angles only: at @2 to @2 rad they are off by up "
                "to @1 m within @2 s.",
                "normal modes, closed form",
                0,
                inaccurate,
                "tensions, Dormand-Prince 5(4)",
                1e-9,
                {std::abs(least), std::abs(most), error_of(Side::broken), horizon.end}});
}

std::vector<Quantity> quantities(const Triple& start, const Reference& truth) {
  constexpr int late = 8;
  Quantity lost = prediction(late, truth, {inaccurate, inaccurate, ok},
                             {1e-3, "a millimetre: wrong motions come within a centimetre by chance"});
  lost.add(
      Breakdown{"Neighbours diverge: double is off by @1 m after @2 s, and neither another algorithm nor a "
                "shorter step helps. Digits do, each by the time that `seconds_per_digit` shows.",
                "double, extrapolated midpoint, order 20",
                0x1p-6,
                inaccurate,
                "long double, extrapolated midpoint, order 20",
                0x1p-6,
                {error_of(Side::broken), late}});
  return {small_swing(start, truth),
          mode_frequencies(start, truth),
          prediction(2, truth, {ok, ok, ok}),
          prediction(4, truth, {inaccurate, ok, ok}),
          lost,
          prediction(12, truth, {inaccurate, inaccurate, inaccurate}),
          horizon_by_digits<float, double>("seconds_per_digit", "from float to double", 4, 8, truth),
          horizon_by_digits<double, long double>("seconds_per_digit_beyond", "from double to long double", 8,
                                                 12, truth),
          by_algorithm(4, truth, {ok, ok, ok, ok}),
          by_algorithm(6, truth, {ok, ok, ok, ok}),
          by_algorithm(10, truth, {inaccurate, inaccurate, inaccurate, inaccurate}),
          growth(4, truth),
          cost(10, start.g, truth),
          cost(100, start.g, truth),
          cost(1000, start.g, truth)};
}

}  // namespace oddity::ex03_25
