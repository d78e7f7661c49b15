// Exercise 3.19: a rope from a spring (c1, L1) over a fixed pulley (I1, R1) carries a second pulley (m2, I2,
// R2). A rope from another spring (c2, L2) over that one carries a mass m3. Depths below the ceiling: y2, y3.
//   S1 = y2 + K1, S2 = y3 - 2 y2 + K2 are the ropes' lengths.
//   (m2 + I1/R1^2 + I2/R2^2) y2'' - I2/R2^2 y3'' = m2 g - c1 (S1 - L1) + 2 c2 (S2 - L2).
//   (m3 + I2/R2^2) y3'' - I2/R2^2 y2'' = m3 g - c2 (S2 - L2).
// The text's derivation is compared with Lagrange's equations from the two energies, by dual numbers, and
// with Newton's laws for each body and the tensions at the ropes' four ends.

#include <Eigen/Core>
#include <cmath>
#include <complex>

#include "chapters/03_rigid_body_motion/19_two_pulleys/drawing.hpp"
#include "chapters/03_rigid_body_motion/19_two_pulleys/two_pulleys.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "solvers/linear.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_19 {

using namespace two_pulleys;

constexpr Parameter parameters[] = {
    {"m2", 1, "kg", "mass of the small pulley", 1e-6, 1e6},
    {"m3", 2, "kg", "mass at the end", 1e-6, 1e6},
    {"I1", 0.5, "kg m^2", "moment of inertia of the large pulley", 1e-9, 1e6},
    {"I2", 0.25, "kg m^2", "moment of inertia of the small pulley", 1e-9, 1e6},
    {"R1", 0.5, "m", "radius of the large pulley", 1e-3, 1e3},
    {"R2", 0.5, "m", "radius of the small pulley", 1e-3, 1e3},
    {"c1", 40, "N/m", "constant of the first spring", 1e-3, 1e6},
    {"c2", 30, "N/m", "constant of the second spring", 1e-3, 1e6},
    {"L1", 1, "m", "length at rest of the first spring", 0, 1e5},
    {"L2", 1, "m", "length at rest of the second spring", 0, 1e5},
    {"K1", 1, "m", "$S_1-y_2$", -1e5, 1e5},
    {"K2", 1.5, "m", "$S_2-y_3+2y_2$", -1e5, 1e5},
    {"g", 9.81, "m/s^2", "gravity", 0, 1e4},
    {"y2", 1, "m", "depth of the small pulley at the start", -1e5, 1e5},
    {"y3", 2.5, "m", "depth of the mass at the start", -1e5, 1e5},
    {"v2", 0.25, "m/s", R"($\dot y_2$ at the start)", -1e3, 1e3},
    {"v3", -0.5, "m/s", R"($\dot y_3$ at the start)", -1e3, 1e3},
    {"seed", 319, "", "seed of the random samples", 0, 1e9, whole_number},
};

Given<double> asked(const Parameters& p) {
  return {p["m2"], p["m3"], p["I1"], p["I2"], p["R1"], p["R2"], p["c1"], p["c2"], p["L1"],
          p["L2"], p["K1"], p["K2"], p["g"],  p["y2"], p["y3"], p["v2"], p["v3"]};
}

// ---- the normal modes -------------------------------------------------------------------------------------

Eigen::Matrix2d as_eigen(const Given<double>::Matrix& a) {
  return Eigen::Matrix2d{{a[0][0], a[0][1]}, {a[1][0], a[1][1]}};
}

/// The angular frequencies of the modes, the lower first, from the matrices in the order (y2, y3), or
/// `turned`, (y3, y2).
std::array<double, 2> frequencies(const Given<double>& p, bool turned) {
  Eigen::Matrix2d k = as_eigen(p.stiffness()), m = as_eigen(p.mass_matrix());
  if (turned) k = k.reverse().eval(), m = m.reverse().eval();
  const Eigen::VectorXd w = modes(k, m).squares.cwiseSqrt();
  return {w[0], w[1]};
}

/// One of the two frequencies of the published equations; if they are complex, that of the growing mode. From
/// the matrix of the accelerations, which are linear in the depths.
std::complex<double> published_frequency(const Given<double>& p) {
  const TwoCoordinates<double> published{p, 0};
  std::array<double, 2> none, first, second;
  published.acceleration({0, 0}, none), published.acceleration({1, 0}, first);
  published.acceleration({0, 1}, second);
  const double half_trace = -(first[0] - none[0] + second[1] - none[1]) / 2,
               det = (first[0] - none[0]) * (second[1] - none[1]) -
                     (first[1] - none[1]) * (second[0] - none[0]);
  return std::sqrt(half_trace + std::sqrt(std::complex<double>(half_trace * half_trace - det)));
}

Given<double> without_inertia(Given<double> p) {
  p.I1 = p.I2 = 0;
  return p;
}

/// The factor of the energy in one step of explicit Euler from a displacement along one mode.
double growth_by_euler(const Given<double>& p, int mode, double step) {
  const Eigen::VectorXd shape = modes(as_eigen(p.stiffness()), as_eigen(p.mass_matrix())).shapes.col(mode);
  const std::array<double, 2> rest = p.at_rest();
  const std::array start{rest[0] + shape[0], rest[1] + shape[1], 0.0, 0.0};
  const auto energy = [&](const std::array<double, 4>& x) {
    return p.kinetic_energy(std::array{x[2], x[3]}) + p.potential_energy(std::array{x[0], x[1]}) -
           p.potential_energy(rest);
  };
  const auto after = ode::integrate<ode::ExplicitEuler>(TwoCoordinates<double>{p}, start, 0, step, step);
  return energy(after.value) / energy(start);
}

// ---- the quantities ---------------------------------------------------------------------------------------

Quantity swing(const Parameters& given, const Horizon& horizon, const Reference& truth) {
  const Given<double> p = asked(given);
  const std::vector<double> inputs{p.m2, p.m3, p.I1, p.I2, p.R1, p.R2, p.c1, p.c2, p.L1,
                                   p.L2, p.K1, p.K2, p.g,  p.y2, p.y3, p.v2, p.v3};
  Quantity y =
      quantity("depths", "m", "depth of the small pulley and of the mass at " + times_up_to(horizon),
               trajectory(truth, "03_19_pulleys", inputs, horizon), {1e-8, "a hundredth of a micrometre"});
  const std::string published = "published equations", why = "the second spring does not pull the pulley";
  SceneMethods(y, horizon, halving("step", 0.125, 11), tolerances(3, 11))
      .closed_form("normal modes", two_pulleys::Modes<double>(p))
      .closed_form("normal modes, pulleys without inertia", two_pulleys::Modes<double>(without_inertia(p)),
                   Outcome::inaccurate, "the pulleys' inertia slows the oscillation")
      .by_engine_integrators("two coordinates", TwoCoordinates<double>{p}, Outcome::drifted,
                             Outcome::inaccurate)
      .by_remaining_integrators(
          "two coordinates", TwoCoordinates<double>{p},
          {{"modified midpoint", Outcome::inaccurate, "its order is too low for this need at this step"},
           {"linearly implicit Euler", Outcome::drifted, "a first-order method that damps every swing"}})
      .by_core_integrators("four coordinates with tensions", FourCoordinates<double>{p}, Outcome::drifted,
                           Outcome::inaccurate)
      .by<ode::RungeKutta4>(published, TwoCoordinates<double>{p, 0}, Outcome::diverged, why)
      .by<ode::Fehlberg78>(published, TwoCoordinates<double>{p, 0}, Outcome::diverged, why);
  const std::complex<double> w = published_frequency(p);
  y.add(Breakdown{
      R"(The published equations do not conserve energy however small the tolerance: it changes at the rate )"
      R"($-2c_2(S_2-L_2)\dot y_2$. Their two frequencies are complex, $@3\pm@3\,i$ per second, and the swing )"
      R"(grows by a factor of $@1$ )"
      "within @2 s. With the second spring's pull on the pulley, $2c_2(S_2-L_2)$, both are real.",
      published + ", Fehlberg 7(8)",
      1e-11,
      Outcome::diverged,
      "two coordinates, Fehlberg 7(8)",
      1e-11,
      {w.real(), w.imag(), std::exp(w.imag() * horizon.end), horizon.end}});
  constexpr double step = 0.125;
  y.add(
      Breakdown{"Each step of explicit Euler multiplies the slower mode's energy by @3, the faster's by @3.",
                "two coordinates, explicit Euler",
                step,
                Outcome::diverged,
                "two coordinates, Runge-Kutta 4",
                0.001953125,
                {growth_by_euler(p, 0, step), growth_by_euler(p, 1, step)}});
  return with_float(std::move(y), horizon, p,
                    {published, "two coordinates", "four coordinates with tensions"});
}

/// The roots of a s^2 - b s + c by the textbook formula, with the smaller one by subtraction or, by Vieta,
/// from the product; c = c1 c2 without subtraction.
std::array<double, 2> by_quadratic(const Given<double>& p, bool vieta) {
  const auto m = p.mass_matrix(), k = p.stiffness();
  const double a = m[0][0] * m[1][1] - m[0][1] * m[1][0],
               b = m[0][0] * k[1][1] + m[1][1] * k[0][0] - 2 * m[0][1] * k[0][1], c = p.c1 * p.c2,
               root = std::sqrt(b * b - 4 * a * c), larger = (b + root) / (2 * a);
  return {std::sqrt(vieta ? c / (a * larger) : (b - root) / (2 * a)), std::sqrt(larger)};
}

/// Ratios to the true frequencies; `graded`: very different springs, so that the frequencies differ as much.
Quantity frequencies(const std::string& name, const std::string& says, const Given<double>& p, bool graded,
                     const Reference& truth) {
  const Known w = truth("03_19_frequencies", {p.m2, p.m3, p.I1, p.I2, p.R1, p.R2, p.c1, p.c2});
  Quantity q{name, "1", says, {"one, " + w.source, {1, 1}}, 1e-16, {1e-12, "twelve digits of each"}};
  const auto ratios = [w](const std::array<double, 2>& by) {
    return Answer{Value{by[0] / w.value[0], by[1] / w.value[1]}, 1};
  };
  const Outcome small = graded ? Outcome::inaccurate : Outcome::ok;
  const std::string why =
                        graded ? "the smaller root is a difference of two numbers of the larger's size" : "",
                    order =
                        graded
                            ? "with the stiff coordinate first it errs by roundings of the larger eigenvalue"
                            : "";
  q.add({"generalized eigenproblem", "GSL, self-adjoint", no_resolution(),
         [=](double) { return ratios(frequencies(p, false)); }, small, order});
  q.add({"generalized eigenproblem, $y_3$ first", "GSL, self-adjoint", no_resolution(),
         [=](double) { return ratios(frequencies(p, true)); }});
  q.add({"det(K - s M) = 0", "quadratic formula", no_resolution(),
         [=](double) { return ratios(by_quadratic(p, false)); }, small, why});
  q.add({"det(K - s M) = 0", "larger root and product", no_resolution(),
         [=](double) { return ratios(by_quadratic(p, true)); }});
  return q;
}

/// The pulleys' rotations become inertia of two sliders: the small pulley, and the mass relative to it.
engines::Staging staging(const Parameters& given) {
  using namespace engines;
  const Given<double> p = asked(given);
  const auto falling = [](double mass, double depth, double speed) {
    Body body{mass, {1, 1, 1}};
    body.start.position[1] = -depth;
    body.start.velocity[1] = -speed;
    return body;
  };
  const Vector down{0, -1, 0};
  return {
      {.gravity = p.g * down,
       .bodies = {falling(p.m2, p.y2, p.v2), falling(p.m3, p.y3, p.v3)},
       .joints = {{.kind = Joint::slide, .axis = down, .wheel = p.inertia_over_square_1()},
                  {.kind = Joint::slide, .a = 0, .b = 1, .axis = down, .wheel = p.inertia_over_square_2()}},
       .ropes = {{{{0, 1}}, p.y2 + p.K1, p.c1, p.L1},
                 {{{1, 1}, {0, -1}}, p.y3 - 2 * p.y2 + p.K2, p.c2, p.L2}}},
      [](std::span<const State> seen, double) {
        return std::vector{-seen[0].position[1], -seen[1].position[1]};
      }};
}

Energy energy(const Parameters& p, std::span<const double> x) {
  const Given<double> rig = asked(p);
  return energy_seen(rig.kinetic_energy(std::array{x[2], x[3]}),
                     rig.potential_energy(std::array{x[0], x[1]}));
}

Scene scene() {
  return {
      .motion = swing,
      .horizon = 8,
      .game_tolerance = centimeter,
      .sweep_parameter = "c1",
      .sweep_values = {10, 40, 160, 1000, 10000},
      .perturbed_parameters = {"y2", "y3", "v2"},
      .axes = {{"y2", "y3"}, "s", {{"m", {0}}, {"m", {1}}}},
      .listing =
          {{"chapters/03_rigid_body_motion/19_two_pulleys/models.hpp"},
           {{"two coordinates",
             "two_pulleys::TwoCoordinates<double>{{m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}}"},
            {"four coordinates with tensions",
             "two_pulleys::FourCoordinates<double>{{m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}}"},
            {"published equations",
             "two_pulleys::TwoCoordinates<double>{{m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, "
             "v2, v3}, 0}"},
            {"normal modes",
             "two_pulleys::Modes<double>({m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3})"},
            {"normal modes, pulleys without inertia",
             "two_pulleys::Modes<double>({m2, m3, 0, 0, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3})"}}},
      .draw = two_pulleys::draw<Parameters>,
      .staging = staging,
      .laws = {energy},
      .faulted = {"published equations"},
      .is_linear = true,
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Given<double> pulleys = asked(p);
  Given<double> stiff = pulleys;
  stiff.c1 *= 0x1p30;
  Quantity graded =
      frequencies("graded_frequencies", "both frequencies with the first spring $2^{30}$ times as stiff",
                  stiff, true, truth);
  graded.add(Breakdown{
      "With the stiff coordinate $y_2$ first the eigenvalue solver errs by roundings of the larger eigenvalue. "
      "With $y_3$ first the same solver does not: it is the order that decides.",
      "generalized eigenproblem, GSL, self-adjoint", 0, Outcome::inaccurate,
      "generalized eigenproblem, $y_3$ first, GSL, self-adjoint", 0});
  graded.add(
      Breakdown{"The quadratic formula subtracts two nearly equal numbers. The product of the roots is "
                "$c_1c_2/\\det M$, without subtraction.",
                "det(K - s M) = 0, quadratic formula", 0, Outcome::inaccurate,
                "det(K - s M) = 0, larger root and product", 0});
  return {
      claims(p["seed"]),
      {motion(scene(), p, truth),
       frequencies("frequencies", "angular frequencies of the two modes, by their true values", pulleys,
                   false, truth),
       graded},
      roots(),
      R"(The kinematics is right, the equations of motion are not: {{the second spring on the pulley|the second spring's pull on the small pulley is missing}}. Of the forces on the bodies, {{the small pulley's inertia|both lack the pulleys' inertia}}, and {{a rope that pushes|a rope pushes}}. {{a spring that must get shorter|The second spring need not get shorter}} when both bodies go down.)"};
}

}  // namespace ex03_19

Exercise exercise_3_19() {
  using namespace ex03_19;
  return {
      "Two pulleys and two springs",
      "A spring holds, by a rope over a fixed pulley, a second pulley; another spring holds, by a rope over "
      "that one, a mass. Find the equations of motion for the depths $y_2$ of the second pulley and $y_3$ of "
      "the mass.",
      parameters,
      scene(),
      study,
      proofs};
}

}  // namespace oddity
