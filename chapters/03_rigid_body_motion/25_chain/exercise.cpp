// Exercise 3.25: three masses on rigid massless rods, hung one from the other: energies, equations of motion;
// and a chain of n masses.
//   pattern    sum_j mu_max(i,j) r_i r_j (cos(theta_i - theta_j) theta_j'' + sin(theta_i - theta_j)
//   theta_j'^2)
//                = -mu_i g r_i sin(theta_i),   mu_k the mass from k on
//   tensions   (1/m_k + 1/m_(k-1)) t_k - c_k t_(k-1)/m_(k-1) - c_(k+1) t_(k+1)/m_k = r_k theta_k'^2 (+ g cos
//              theta_1 for k = 1), c_k = cos(theta_k - theta_(k-1)): tridiagonal, so linear in n
// The claims are judged against Lagrange's equations by nested dual numbers of the positions alone, and
// against Newton's law with tensions. References: 60-digit Taylor series in Cartesian coordinates against
// extrapolation in the angles. Masses, lengths and starts are dyadic, so that every precision starts from the
// same state.

#include "chapters/03_rigid_body_motion/25_chain/claims.hpp"
#include "chapters/03_rigid_body_motion/25_chain/chain_prediction.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"

namespace oddity {

namespace ex03_25 {

using namespace chain;
using enum Outcome;

constexpr Parameter parameters[] = {
    {"m1", 1, "kg", "mass next to the pivot", 1e-2, 1e2},
    {"m2", 0.75, "kg", "mass in the middle", 1e-2, 1e2},
    {"m3", 0.5, "kg", "mass at the end", 1e-2, 1e2},
    {"r1", 1, "m", "length of the rod at the pivot", 0.1, 10},
    {"r2", 0.75, "m", "length of the rod in the middle", 0.1, 10},
    {"r3", 0.5, "m", "length of the rod at the end", 0.1, 10},
    {"g", 9.8125, "m/s^2", "gravity", 0.1, 30},
    {"h", 2.5, "m", "height of the pivot", -1e3, 1e3},
    {"theta1", 0.25, "rad", "angle at the start, from the downward vertical", -7, 7},
    {"theta2", 0.375, "rad", "angle at the start", -7, 7},
    {"theta3", 0.5, "rad", "angle at the start", -7, 7},
    {"omega1", 0, "rad/s", "angular velocity at the start", -10, 10},
    {"omega2", 0, "rad/s", "angular velocity at the start", -10, 10},
    {"omega3", 0, "rad/s", "angular velocity at the start", -10, 10},
    {"seed", 325, "", "of the random samples", 0, 1e9, whole_number},
};

constexpr Triple chaotic{{1, 0.75, 0.5}, {1, 0.75, 0.5}, 9.8125, 2.5, {2, 2.5, 3}, {0, 0, 0}};

// ---- the motion -------------------------------------------------------------------------------------------

Triple asked(const Parameters& p) {
  return {{p["m1"], p["m2"], p["m3"]},
          {p["r1"], p["r2"], p["r3"]},
          p["g"],
          p["h"],
          {p["theta1"], p["theta2"], p["theta3"]},
          {p["omega1"], p["omega2"], p["omega3"]}};
}

Quantity hanging(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const Triple start = asked(p);
  Quantity q = quantity("motion", "m", "positions of the masses at four times",
                        trajectory(truth, "03_25_chain", start.inputs(), horizon), {1e-6, "a micrometre"});
  Ladder(q, horizon, halving("step", 0x1p-4, 9), tolerances(3, 11))
      .closed_form("normal modes", NormalModes(start), inaccurate, "the angles are not small")
      .by_common("dense mass matrix", Angles<Equations::dense>{start}, inaccurate, ok)
      .by_common("tensions", Angles<Equations::tensions>{start}, inaccurate, ok)
      .by_others("tensions", Angles<Equations::tensions>{start},
                 {{"linearly implicit Euler", inaccurate, "of order 1, and it damps every swing"}});
  return q.add(Breakdown{
      "Independent normal modes describe small angles only: at a quarter to half a radian they are off "
      "by centimetres within four seconds.",
      "normal modes, closed form", 0, inaccurate, "tensions, Dormand-Prince 5(4)", 1e-9});
}

Scene scene() {
  return {hanging,
          4,
          centimeter,
          "theta1",
          {0.0625, 0.25, 0.5, 1, 1.5},
          {"theta1", "theta2", "theta3"},
          {{"x1", "y1", "x2", "y2", "x3", "y3"}, "s", {{"m", {0, 1}}, {"m", {2, 3}}, {"m", {4, 5}}}},
          {{"chapters/03_rigid_body_motion/25_chain/models.hpp"},
           {{"dense mass matrix",
             "chain::Angles<chain::Equations::dense>{{{m1, m2, m3}, {r1, r2, r3}, g, h, {theta1, theta2, "
             "theta3}, {omega1, omega2, omega3}}}"},
            {"tensions",
             "chain::Angles<chain::Equations::tensions>{{{m1, m2, m3}, {r1, r2, r3}, g, h, {theta1, theta2, "
             "theta3}, {omega1, omega2, omega3}}}"}},
           {{"normal modes", "which needs GSL's eigenvalues"}}}};
}

Quantity small_swing(const Triple& like, const Reference& truth) {
  const Horizon horizon{4};
  Triple start = like;
  start.theta = {0x1p-10, 0x1.8p-10, 0x1p-9};
  start.omega = {0, 0, 0};
  Quantity q = quantity("small_swing", "m", "the same from angles of a thousandth",
                        trajectory(truth, "03_25_chain", start.inputs(), horizon), {1e-6, "a micrometre"});
  Ladder(q, horizon, halving("step", 0x1p-4, 7), tolerances(3, 9))
      .closed_form("normal modes", NormalModes(start))
      .by<ode::RungeKutta4>("tensions", Angles<Equations::tensions>{start})
      .by<ode::DormandPrince54>("tensions", Angles<Equations::tensions>{start});
  return q;
}

Quantity mode_frequencies(const Triple& c, const Reference& truth) {
  std::vector<double> inputs = c.inputs();
  inputs.resize(7);
  const Known known = truth("03_25_modes", inputs);
  const double size = size_of(known.value);
  Quantity q = quantity("mode_frequencies", "rad/s", "angular frequencies of the three small oscillations",
                        known, {1e-10 * size, "ten digits of the fastest"});
  q.add({"dense pair (K, M)", "GSL, Cholesky and QR", no_knob(), [=](double) {
           return Answer{Value(NormalModes(c).w), 1};
         }});
  q.add(
      {"tensions at rest", "one link's accelerations by dual numbers, then GSL's QR", no_knob(), [=](double) {
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

// ---- chaos ------------------------------------------------------------------------------------------------

/// How each precision ends when all that is left of its error is rounding.
struct Predicts {
  Outcome in_float, in_double, in_long_double;
};

Quantity prediction(double t, const Reference& truth, const Predicts& expected) {
  const Horizon once{t, 1};
  const std::string seconds = shortest(t) + " s";
  Quantity q = quantity("chaos_" + shortest(t) + "s", "m",
                        "positions " + seconds + " after rest at (2, 2.5, 3) rad, in three precisions",
                        trajectory(truth, "03_25_chain", chaotic.inputs(), once), {1e-2, "a centimetre"});
  const Knob steps = halving("step", 0x1p-3, 4);
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

/// log |d(position)/d(theta1)| of the chaotic start at t.
Known parting(double t, const Reference& truth) {
  std::vector<double> inputs = chaotic.inputs();
  inputs.push_back(t);
  Known known = truth("03_25_growth", inputs);
  known.value[0] *= t;
  return known;
}

/// What the digits from the precision A to B buy, against the rate at which neighbours part from t0 to t1.
template <class A, class B>
Quantity horizon_by_digits(const std::string& name, const std::string& from_A_to_B, double t0, double t1,
                           const Reference& truth) {
  constexpr double close = 1e-2;
  const Horizon seconds{12, 12};
  Known rate = parting(t1, truth);
  const double per_digit = std::numbers::ln10 * (t1 - t0) / (rate.value[0] - parting(t0, truth).value[0]);
  rate.error *= per_digit * per_digit * t1 / (std::numbers::ln10 * (t1 - t0));
  rate.value = {per_digit};
  rate.source = "ln(10) over the growth rate of neighbours from " + shortest(t0) + " to " + shortest(t1) +
                " s, " + rate.source;
  Quantity q =
      quantity(name, "s",
               "how much further ahead, to a centimetre, each decimal digit " + from_A_to_B +
                   " predicts the start at rest at (2, 2.5, 3) rad",
               rate, {0.25 * per_digit, "a quarter: neighbours do not part evenly along the motion"});
  const Value all = trajectory(truth, "03_25_chain", chaotic.inputs(), seconds).value;
  q.add({from_A_to_B, "extrapolated midpoint, order 20", halving("step", 0x1p-5, 3),
         [=](double step) { return seconds_per_digit<A, B>(chaotic, seconds, all, close, step); }});
  return q;
}

/// How each algorithm ends at its finest setting.
struct AlgorithmsPredict {
  Outcome runge_kutta, dormand_prince, fehlberg, bulirsch_stoer;
};

Quantity by_algorithm(double t, const Reference& truth, const AlgorithmsPredict& expected) {
  const Horizon once{t, 1};
  Quantity q = quantity("chaos_" + shortest(t) + "s_by_algorithm", "m",
                        "positions " + shortest(t) + " s after rest at (2, 2.5, 3) rad, by algorithm",
                        trajectory(truth, "03_25_chain", chaotic.inputs(), once), {1e-2, "a centimetre"});
  const auto why = [](Outcome outcome) {
    return outcome == ok ? "" : "what it errs by at first has grown to the size of the motion";
  };
  const Angles<Equations::tensions> model{chaotic};
  Ladder(q, once, halving("step", 0x1p-6, 6), tolerances(5, 13))
      .by<ode::RungeKutta4>("tensions", model, expected.runge_kutta, why(expected.runge_kutta))
      .by<ode::DormandPrince54>("tensions", model, expected.dormand_prince, why(expected.dormand_prince))
      .by<ode::Fehlberg78>("tensions", model, expected.fehlberg, why(expected.fehlberg))
      .by<ode::BulirschStoer>("tensions", model, expected.bulirsch_stoer, why(expected.bulirsch_stoer));
  return q;
}

Quantity growth(double t, const Reference& truth) {
  std::vector<double> inputs = chaotic.inputs();
  inputs.push_back(t);
  Quantity q = quantity("growth", "1/s",
                        "rate at which a change of theta1 grows within " + shortest(t) +
                            " s of rest at (2, 2.5, 3) rad: log |d(position)/d(theta1)| / t",
                        truth("03_25_growth", inputs), {1e-3, "a thousandth per second"});
  q.add({"variational equation", "Fehlberg 7(8)", tolerances(6, 14),
         [=](double tolerance) { return growth_by_variation(chaotic, t, tolerance); }});
  q.add({"two neighbours",
         "Fehlberg 7(8), their distance",
         {"apart", {1e-2, 1e-4, 1e-6, 1e-8}},
         [=](double apart) { return growth_by_neighbours(chaotic, t, apart); }});
  return q.add(Breakdown{
      "Two neighbours measure the growth only while they are neighbours: a hundredth of a radian apart they "
      "are "
      "as far apart as the pendulum is long within seconds. Dual numbers carry the derivative itself.",
      "two neighbours, Fehlberg 7(8), their distance", 1e-2, inaccurate,
      "variational equation, Fehlberg 7(8)", 1e-10});
}

// ---- n masses ---------------------------------------------------------------------------------------------

std::vector<Counted<double>> counted(const std::vector<double>& x) { return {x.begin(), x.end()}; }

/// What it costs to write down the dense equations, and to solve the tridiagonal ones.
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
    q.add({"dense mass matrix", std::move(algorithm), no_knob(), [=](double) {
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
  q.add({"tensions", "tridiagonal elimination", no_knob(), [=](double) {
           std::vector<double> alpha(p.m.size());
           by_tensions(p.m, p.r, g, p.theta, p.omega, alpha);
           return Answer{chosen(alpha, n), recursion};
         }});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Triple start = asked(p);
  Quantity lost = prediction(8, truth, {inaccurate, inaccurate, ok});
  lost.add(Breakdown{
      "Neighbours part up to seventyfold a second: whatever the algorithm, double is decimetres off after "
      "eight seconds, and no shorter step helps. Digits do: each buys half a second or more.",
      "double, extrapolated midpoint, order 20", 0x1p-6, inaccurate,
      "long double, extrapolated midpoint, order 20", 0x1p-6});
  return {claims(p["seed"]),
          {motion(scene(), p, truth), small_swing(start, truth), mode_frequencies(start, truth),
           prediction(2, truth, {ok, ok, ok}), prediction(4, truth, {inaccurate, ok, ok}), lost,
           prediction(12, truth, {inaccurate, inaccurate, inaccurate}),
           horizon_by_digits<float, double>("seconds_per_digit", "from float to double", 4, 8, truth),
           horizon_by_digits<double, long double>("seconds_per_digit_beyond", "from double to long double", 8,
                                                  12, truth),
           by_algorithm(4, truth, {ok, ok, ok, ok}), by_algorithm(6, truth, {ok, ok, ok, ok}),
           by_algorithm(10, truth, {inaccurate, inaccurate, inaccurate, inaccurate}), growth(4, truth),
           cost(10, p["g"], truth), cost(100, p["g"], truth), cost(1000, p["g"], truth)}};
}

}  // namespace ex03_25

Exercise exercise_3_25() {
  using namespace ex03_25;
  return {"Triple pendulum and a chain of n masses",
          "Three masses hang one from the other by rigid massless rods. Find the kinetic and the potential "
          "energy and the equations of motion in the angles $\\theta_1,\\theta_2,\\theta_3$; what becomes of "
          "them for $n$ masses?",
          parameters, scene(), study};
}

}  // namespace oddity
