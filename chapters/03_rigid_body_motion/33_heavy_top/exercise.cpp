// Exercise 3.33: the Lagrangian equations of a heavy symmetric top whose tip is fixed.
//   T = mu1/2 (phi'^2 + theta'^2 sin^2 phi) + mu3/2 (psi' + theta' cos phi)^2,   V = m g l cos phi
//   psi' + theta' cos phi = c,   mu1 theta' sin^2 phi + c mu3 cos phi = gamma,   u = cos phi:
//   u'^2 = (e - 2 alpha u)(1 - u^2) - (b - a u)^2,   alpha = m g l/mu1, a = mu3 c/mu1, b = gamma/mu1
// The formulas are judged against tops made of point masses (top_of_points.hpp), whose energies and forces
// come from the points' positions by dual numbers. top_models.hpp has the models, top_quantities.hpp the
// quantities.

#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/03_rigid_body_motion/shared/top_of_points.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace ex03_33 {

using namespace top;
using std::cos, std::sin;

constexpr Parameter parameters[] = {
    {"m", 1, "kg", "mass", 0.1, 10},
    {"l", 0.25, "m", "from the tip to the center of mass", 0.01, 1},
    {"mu1", 0.125, "kg m^2", "moment across the axis, about the tip", 0.01, 10},
    {"mu3", 0.0625, "kg m^2", "moment about the axis", 0.001, 10},
    {"g", 9.81, "m/s^2", "gravity", 0.1, 30},
    {"theta", 0.25, "rad", "precession angle at the start", -10, 10},
    {"phi", 0.5, "rad", "tilt at the start", 0.1, 3},
    {"psi", 0.75, "rad", "spin angle at the start", -10, 10},
    {"dtheta", 0.5, "rad/s", "its rate", -10, 10},
    {"dphi", 0.25, "rad/s", "its rate", -10, 10},
    {"dpsi", 30, "rad/s", "its rate", 1, 100},
    {"seed", 333, "", "seed of the random samples", 0, 1e9, whole_number},
};

using S = const Sample&;

// ---- the text's formulas, generic in their number type ----------------------------------------------------

/// Angular velocity in body coordinates; `second` is the angle in its second component's first term.
Value rates(S s, double second) {
  const auto [theta, phi, psi] = s.q;
  const auto [dtheta, dphi, dpsi] = s.v;
  return {dphi * cos(psi) + dtheta * sin(psi) * sin(phi), -dphi * sin(second) + dtheta * cos(psi) * sin(phi),
          dpsi + dtheta * cos(phi)};
}

double half_wJw(S s, const Value& w, double mu1) {
  return mu1 / 2 * (w[0] * w[0] + w[1] * w[1]) + s.mu3 / 2 * w[2] * w[2];
}

constexpr auto spin = [](const auto& q, const auto& v) { return v[2] + v[0] * cos(q[1]); };

auto kinetic(S s) {
  return [&s](const auto& q, const auto& v) {
    const auto total = spin(q, v);
    return s.mu1 / 2 * (v[1] * v[1] + v[0] * v[0] * sin(q[1]) * sin(q[1])) + s.mu3 / 2 * total * total;
  };
}

double total(S s) { return spin(s.q, s.v); }
double dT_dphi(S s) {
  return s.mu1 * s.v[0] * s.v[0] * sin(s.q[1]) * cos(s.q[1]) + s.mu3 * total(s) * (-s.v[0] * sin(s.q[1]));
}

/// The text's momenta: of theta with the factor `sign` before mu3, of phi, of psi.
auto momentum(S s, std::size_t k, double sign = 1) {
  return [&s, k, sign](const auto& q, const auto& v) {
    const auto about_axis = s.mu3 * (v[2] + v[0] * cos(q[1]));
    if (k == 0) return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + sign * (about_axis * cos(q[1]));
    return k == 1 ? s.mu1 * v[1] : about_axis;
  };
}

/// T by the definition: the points' masses and velocities.
double true_kinetic(S s) { return s.body.kinetic(s.q, s.v, s.t); }

double true_derivative(S s, std::size_t k, bool rate) {
  return by_angle(
      s, k,
      [&](const auto& q, const auto& v) {
        return s.body.kinetic(q, v, std::remove_cvref_t<decltype(q[0])>(s.t));
      },
      rate);
}

/// The derivative of the center of mass by an angle, by dual numbers.
Value arm(S s, std::size_t k) {
  std::array<Dual<double>, 3> q;
  for (std::size_t i = 0; i < 3; ++i) q[i] = {s.q[i], i == k ? 1.0 : 0.0};
  const auto r = rotation(q[0], q[1], q[2]);
  return {s.l * r[0][2].slope, s.l * r[1][2].slope, s.l * r[2][2].slope};
}

/// The generalized force of gravity on every point: minus the slope of the potential.
double true_force(S s, std::size_t k) {
  return -by_angle(s, k, [&](const auto& q, const auto&) {
    return s.body.potential(q, std::remove_cvref_t<decltype(q[0])>(s.t));
  });
}

Value world_velocity_in_body(S s) {
  const Matrix<double> w = s.body_spin();
  return {s.l * w[0][2], s.l * w[1][2], s.l * w[2][2]};
}

// ---- the claims -------------------------------------------------------------------------------------------

using V = Judge::Version;

std::vector<Claim> energy_claims(const Judge& judge) {
  const V at_points{"sum of m |x'|^2/2 over the points", [](S s) { return true_kinetic(s); }};

  Claim center = judge.claim("center_of_mass", 2953, "the center of mass is l xi3",
                             {"(0, 0, l)", [](S s) { return values(0, 0, s.l); }},
                             {"sum of m x over the points, in body coordinates",
                              [](S s) {
                                Vector<double> sum{};
                                for (const Point& p : s.body.points)
                                  for (std::size_t i = 0; i < 3; ++i) sum[i] += p.m * p.x[i] / s.m;
                                return sum;
                              }},
                             {{"2l", [](S s) { return values(0, 0, 2 * s.l); }}});

  Claim moves = judge.claim(
      "center_of_mass_at_rest", 2953, "the velocity of the center of mass is zero in body coordinates",
      {"zero", [](S) { return values(0, 0, 0); }}, {"R^T r', by dual numbers", world_velocity_in_body},
      {{"l (-w2, w1, 0)", [](S s) {
          const Value w = rates(s, s.q[2]);
          return values(-s.l * w[1], s.l * w[0], 0);
        }}});
  moves.corrected = {"l (w2, -w1, 0), w the angular velocity in body coordinates",
                     {judge.compare("velocity of the center of mass in body coordinates",
                                    {"w x l xi3, w from the text's rates with sin(psi)",
                                     [](S s) {
                                       const Value w = rates(s, s.q[2]);
                                       return values(s.l * w[1], -s.l * w[0], 0);
                                     }},
                                    {"R^T r', by dual numbers", world_velocity_in_body})}};
  moves.why =
      "What does not change are the body coordinates of the center of mass. Its velocity has the body "
      "components $\\ell(w_2,-w_1,0)$: the center runs on a sphere about the tip and has the kinetic energy "
      "$\\frac12m\\ell^2(w_1^2+w_2^2)$. The final $T$ is right only because $\\mu_1$ is taken about the tip, "
      "which has that energy in it; with the moment about the center of mass it is wrong by just this term.";

  const auto change_of_axis = [](S s, double turning) {
    const Matrix<double> world = s.body_spin();
    const Value w = rates(s, s.q[2]);
    return values(world[0][2] - turning * w[1], world[1][2] + turning * w[0], world[2][2]);
  };
  Claim fixed_axis = judge.claim("axis_unchanging", 2953, "xi3 does not change in body coordinates",
                                 {"its rate in the world less w x xi3, w by the rates of the angles",
                                  [=](S s) { return change_of_axis(s, 1); }},
                                 {"zero", [](S) { return values(0, 0, 0); }},
                                 {{"its rate in the world", [=](S s) { return change_of_axis(s, 0); }}});

  Claim energy = judge.claim(
      "kinetic_energy", 2955, "T = w^T J w/2",
      {"J about the tip, w from R^T R'", [](S s) { return half_wJw(s, s.body_rates(), s.mu1); }}, at_points,
      {{"J about the center of mass",
        [](S s) { return half_wJw(s, s.body_rates(), s.mu1 - s.m * s.l * s.l); }}});

  const auto in_the_tensor = [](double factor) {
    return [factor](S s) { return 2 * factor * half_wJw(s, s.body_rates(), s.mu1); };
  };
  Claim again = judge.claim("kinetic_energy_again", 2971, "T by the tensor and w",
                            {"w^T J w/2", in_the_tensor(0.5)}, at_points, {{"w^T J w", in_the_tensor(1)}});
  again = lost_bar(
      std::move(again),
      {"12 w^T J w", {judge.compare("T by the tensor and w", {"12 w^T J w", in_the_tensor(12)}, at_points)}},
      "The fraction bar of $\\tfrac12$ is lost in the text at hand. Line 2959 has it on two lines, "
      "and the $\\mu_1/2$ of the next lines come from it. As it stands the top has 24 times its "
      "energy.");
  again.says = "T = 12 w^T J w";

  const V inertia{"from the points", [](S s) {
                    Value J(std::vector<double>(9, 0.0));
                    for (const Point& p : s.body.points)
                      for (std::size_t i = 0; i < 3; ++i)
                        for (std::size_t k = 0; k < 3; ++k)
                          J[3 * i + k] += p.m * ((i == k ? dot(p.x, p.x) : 0) - p.x[i] * p.x[k]);
                    return J;
                  }};
  Claim diagonal = judge.claim(
      "inertia", 2961, "the inertia tensor in body coordinates",
      {"Diag(mu1, mu1, mu3)", [](S s) { return values(s.mu1, 0, 0, 0, s.mu1, 0, 0, 0, s.mu3); }}, inertia,
      {{"Diag(mu1, mu3, mu3)", [](S s) { return values(s.mu1, 0, 0, 0, s.mu3, 0, 0, 0, s.mu3); }}});

  const V of_R{"R^T R', R = Rz(theta) Rx(phi) Rz(psi), by dual numbers", [](S s) { return s.body_rates(); }};
  const V meant{"-phi' sin(psi) + theta' cos(psi) sin(phi)", [](S s) { return rates(s, s.q[2]); }};
  Claim omega = judge.claim(
      "angular_velocity", 2967, "the angular velocity in body coordinates",
      {"second component -phi' sin(phi) + theta' cos(psi) sin(phi)", [](S s) { return rates(s, s.q[1]); }},
      of_R, {{"+phi' sin(psi) in the second component", [](S s) { return rates(s, -s.q[2]); }}});
  omega.meant = {meant.text, {judge.compare(omega.says, meant, of_R)}};
  omega.says = "in body coordinates w2 = -phi' sin(phi) + theta' cos(psi) sin(phi)";
  omega.why =
      "The second component begins with $-\\dot\\phi\\sin\\psi$; printed is the angle $\\phi$. With it "
      "$w_1^2+w_2^2$ would depend on $\\psi$, and the text's own next line would not follow. The angles are "
      "those of $R=R_z(\\theta)R_x(\\phi)R_z(\\psi)$: of this order the rates in body coordinates have the "
      "signs printed.";

  Claim components = judge.claim(
      "energy_by_components", 2973, "T by the components of w",
      {"with -phi' sin(phi) in the second square", [](S s) { return half_wJw(s, rates(s, s.q[1]), s.mu1); }},
      at_points, {{"with +phi' sin(psi) in the second square", [](S s) {
                     return half_wJw(s, rates(s, -s.q[2]), s.mu1);
                   }}});
  components.meant = {meant.text,
                      {judge.compare("T",
                                     {"with -phi' sin(psi) in the second square",
                                      [](S s) { return half_wJw(s, rates(s, s.q[2]), s.mu1); }},
                                     at_points)}};
  components.says = "the second square in T is that of -phi' sin(phi) + theta' cos(psi) sin(phi)";
  components.why = "The same letter: $\\phi$ stands for $\\psi$ in the second square.";

  Claim reduced = judge.claim("energy_reduced", 2981, "T in the angles",
                              {"mu1/2 (phi'^2 + theta'^2 sin^2 phi) + mu3/2 (psi' + theta' cos phi)^2",
                               [](S s) { return kinetic(s)(s.q, s.v); }},
                              at_points, {{"cos^2 phi for sin^2 phi", [](S s) {
                                             const double c = cos(s.q[1]);
                                             return s.mu1 / 2 * (s.v[1] * s.v[1] + s.v[0] * s.v[0] * c * c) +
                                                    s.mu3 / 2 * total(s) * total(s);
                                           }}});
  return {center, moves, fixed_axis, energy, diagonal, omega, again, components, reduced};
}

std::vector<Claim> derivative_claims(const Judge& judge) {
  const auto of_T = [](std::size_t k, bool rate) {
    return V{"the points' T, by dual numbers", [=](S s) { return true_derivative(s, k, rate); }};
  };
  const auto zero = [](S) { return values(0); };
  const auto p = [](const char* text, std::size_t k, double sign = 1) {
    return V{text, [=](S s) { return momentum(s, k, sign)(s.q, s.v); }};
  };
  std::vector<Claim> all;
  // A published zero stands on the right.
  all.push_back(judge.claim("dT_dtheta", 2989, "T does not depend on theta", of_T(0, false), {"0", zero},
                            {{"nor on phi", of_T(1, false).of}}));
  all.push_back(judge.claim(
      "dT_dphi", 2993, "dT/dphi",
      {"mu1 theta'^2 sin phi cos phi - mu3 (psi' + theta' cos phi) theta' sin phi", dT_dphi}, of_T(1, false),
      {{"+mu3 (...)",
        [](S s) { return 2 * s.mu1 * s.v[0] * s.v[0] * sin(s.q[1]) * cos(s.q[1]) - dT_dphi(s); }}}));
  all.push_back(judge.claim("dT_dpsi", 2997, "T does not depend on psi", of_T(2, false), {"0", zero},
                            {{"nor on phi", of_T(1, false).of}}));
  all.push_back(judge.claim("dT_dtheta_dot", 3001, "dT/dtheta'",
                            p("mu1 theta' sin^2 phi + mu3 (psi' + theta' cos phi) cos phi", 0), of_T(0, true),
                            {p("mu1 theta' sin^2 phi - mu3 (...) cos phi", 0, -1)}));
  all.push_back(judge.claim("dT_dphi_dot", 3005, "dT/dphi'", p("mu1 phi'", 1), of_T(1, true),
                            {{"mu3 phi'", [](S s) { return s.mu3 * s.v[1]; }}}));
  all.push_back(judge.claim("dT_dpsi_dot", 3009, "dT/dpsi'", p("mu3 (psi' + theta' cos phi)", 2),
                            of_T(2, true), {{"mu3 psi'", [](S s) { return s.mu3 * s.v[2]; }}}));

  const auto left = [](std::size_t k) {
    return V{"nested dual numbers on the points' T", [k](S s) { return s.kinetic[k]; }};
  };
  const auto rate = [](S s, std::size_t k, double sign = 1) { return rate_of(s, s.a, momentum(s, k, sign)); };
  all.push_back(judge.claim(
      "lagrange_theta", 3015, "left side of the equation of theta",
      {"d/dt (mu1 theta' sin^2 phi + mu3 (psi' + theta' cos phi) cos phi)", [=](S s) { return rate(s, 0); }},
      left(0), {{"-mu3 (...)", [=](S s) { return rate(s, 0, -1); }}}));
  all.push_back(
      judge.claim("lagrange_phi", 3021, "left side of the equation of phi",
                  {"mu1 phi'' - mu1 theta'^2 sin phi cos phi + mu3 (psi' + theta' cos phi) theta' sin phi",
                   [=](S s) { return rate(s, 1) - dT_dphi(s); }},
                  left(1), {{"without the last two terms", [=](S s) { return rate(s, 1); }}}));
  all.push_back(judge.claim("lagrange_psi", 3029, "left side of the equation of psi",
                            {"d/dt (mu3 (psi' + theta' cos phi))", [=](S s) { return rate(s, 2); }}, left(2),
                            {{"mu3 psi''", [](S s) { return s.mu3 * s.a[2]; }}}));
  return all;
}

std::vector<Claim> force_claims(const Judge& judge) {
  const auto by_dual = [](std::size_t k) {
    return V{"derivative of l R(theta, phi, psi) k, by dual numbers", [k](S s) { return arm(s, k); }};
  };
  const auto slope = [](std::size_t k) {
    return V{"minus the slope of the points' potential", [k](S s) { return true_force(s, k); }};
  };
  const auto zero = V{"0", [](S) { return values(0); }};
  std::vector<Claim> all;
  all.push_back(judge.claim(
      "dr_dtheta", 3037, "the derivative of r by theta",
      {"l (cos theta sin phi, sin theta sin phi, 0)",
       [](S s) { return values(s.l * cos(s.q[0]) * sin(s.q[1]), s.l * sin(s.q[0]) * sin(s.q[1]), 0); }},
      by_dual(0), {{"-sin theta sin phi", [](S s) {
                      return values(s.l * cos(s.q[0]) * sin(s.q[1]), -s.l * sin(s.q[0]) * sin(s.q[1]), 0);
                    }}}));
  all.push_back(judge.claim("force_theta", 3039, "the generalized force of theta is 0", slope(0), zero,
                            {{"that of phi is", slope(1).of}}));
  const auto by_phi = [](S s, double second) {
    return values(s.l * sin(s.q[0]) * cos(s.q[1]), second * s.l * cos(s.q[0]) * cos(s.q[1]),
                  -s.l * sin(s.q[1]));
  };
  all.push_back(
      judge.claim("dr_dphi", 3043, "the derivative of r by phi",
                  {"l (sin theta cos phi, -cos theta cos phi, -sin phi)", [=](S s) { return by_phi(s, -1); }},
                  by_dual(1), {{"+cos theta cos phi", [=](S s) { return by_phi(s, 1); }}}));
  all.push_back(judge.claim("force_phi", 3045, "the generalized force of phi",
                            {"m g l sin phi", [](S s) { return s.m * s.body.g * s.l * sin(s.q[1]); }},
                            slope(1),
                            {{"-m g l sin phi", [](S s) { return -s.m * s.body.g * s.l * sin(s.q[1]); }}}));
  all.push_back(judge.claim("dr_dpsi", 3049, "the arm of the force of psi is zero, and so is the force",
                            {"dr/dtheta", [](S s) { return arm(s, 0); }},
                            {"(0, 0, 0)", [](S) { return values(0, 0, 0); }}, {}));
  all.back().meant = {
      "dr/dpsi, and the slope of the potential by psi",
      {judge.compare("the arm of psi", by_dual(2), {"(0, 0, 0)", [](S) { return values(0, 0, 0); }}),
       judge.compare("the force of psi", slope(2), zero)}};
  all.back().near_misses = {
      {"dr/dphi",
       {judge.compare("the arm of phi", by_dual(1), {"(0, 0, 0)", [](S) { return values(0, 0, 0); }})}}};
  all.back().says = "the force of psi is (-m g k) . dr/dtheta = 0";
  all.back().why =
      "Printed is $\\partial\\mathbf r/\\partial\\theta$ again, which has just been given and is not zero. "
      "The zeros are those of $\\partial\\mathbf r/\\partial\\psi$: a spin about the axis moves no point of "
      "it.";
  return all;
}

/// (c, gamma) of the rigid body after 4 s against the start's, by the text's formulas.
Check along_the_motion(const Top& start) {
  const heavy_top::RigidBody<double> body{{start}};
  const auto run = ode::integrate<ode::Fehlberg78>(body, body.start(), 0, 4, 1e-12);
  const auto [q, i, j, k, w1, w2, w3] = run.value;
  const double up1 = 2 * (i * k - q * j), up2 = 2 * (j * k + q * i), up3 = 1 - 2 * (i * i + j * j);
  const double sine = sin(start.phi), c = start.dpsi + start.dtheta * cos(start.phi);
  const double gamma = start.mu1 * start.dtheta * sine * sine + c * start.mu3 * cos(start.phi);
  return {"(c, gamma)",
          {"rigid body after 4 s", {w3, start.mu1 * (up1 * w1 + up2 * w2) + start.mu3 * up3 * w3}},
          {"the text's formulas at the start", {c, gamma}},
          {1e-11 * std::abs(c), "ten tolerances of the integration"}};
}

/// Euler's third equation, the moments and the torque of gravity summed over the points.
double spin_rate_by_euler(S s, const Vector<double>& w) {
  const auto r = rotation(s.q[0], s.q[1], s.q[2]);
  double J1 = 0, J2 = 0, torque = 0;
  for (const Point& p : s.body.points) {
    J1 += p.m * (p.x[1] * p.x[1] + p.x[2] * p.x[2]);
    J2 += p.m * (p.x[0] * p.x[0] + p.x[2] * p.x[2]);
    torque -= p.m * s.body.g * (p.x[0] * r[2][1] - p.x[1] * r[2][0]);
  }
  return ((J1 - J2) * w[0] * w[1] + torque) / s.mu3;
}

std::vector<Claim> motion_claims(const Judge& judge, const Top& start) {
  const V zero{"0", [](S) { return values(0); }};
  const auto along = [](const char* text, std::size_t k, double sign = 1) {
    return V{text, [=](S s) { return rate_of(s, s.truth, momentum(s, k, sign)); }};
  };
  const V lagrange{"nested dual numbers on the points' T - V", [](S s) { return s.truth[1]; }};
  const auto middle = [](S s, double sign, double weight) {
    const double c = total(s), sine = sin(s.q[1]);
    return weight * s.m * s.body.g * s.l / s.mu1 * sine + s.v[0] * s.v[0] * sine * cos(s.q[1]) -
           sign * c * s.mu3 / s.mu1 * s.v[0] * sine;
  };
  std::vector<Claim> all;
  all.push_back(judge.claim("motion_theta", 3055, "the equation of motion of theta",
                            along("d/dt (mu1 theta' sin^2 phi + mu3 (psi' + theta' cos phi) cos phi)", 0),
                            zero, {along("with -mu3", 0, -1)}));
  all.push_back(judge.claim(
      "motion_phi", 3061, "the equation of motion of phi",
      {"mu1 phi'' - mu1 theta'^2 sin phi cos phi + mu3 (psi' + theta' cos phi) theta' sin phi",
       [](S s) { return rate_of(s, s.truth, momentum(s, 1)) - dT_dphi(s); }},
      {"m g l sin phi", [](S s) { return s.m * s.body.g * s.l * sin(s.q[1]); }},
      {{"+mu1 theta'^2 sin phi cos phi", [](S s) {
          return s.mu1 * s.truth[1] - dT_dphi(s) + 2 * s.mu1 * s.v[0] * s.v[0] * sin(s.q[1]) * cos(s.q[1]);
        }}}));
  all.push_back(judge.claim("motion_psi", 3069, "the equation of motion of psi",
                            along("d/dt (mu3 (psi' + theta' cos phi))", 2), zero,
                            {{"d/dt (mu3 psi')", [](S s) { return s.mu3 * s.truth[2]; }}}));
  all.push_back(judge.claim("spin_constant", 3075, "psi' + theta' cos phi is a constant",
                            {"its rate along the motion", [](S s) { return rate_of(s, s.truth, spin); }},
                            zero, {{"psi' - theta' cos phi", [](S s) {
                                      return rate_of(s, s.truth, [](const auto& q, const auto& v) {
                                        return v[2] - v[0] * cos(q[1]);
                                      });
                                    }}}));
  const auto gamma = [](S s, double factor) {
    const double c = total(s);
    return rate_of(s, s.truth, [&](const auto& q, const auto& v) {
      return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + factor * c * s.mu3 * cos(q[1]);
    });
  };
  all.push_back(judge.claim("vertical_constant", 3079, "mu1 theta' sin^2 phi + c mu3 cos phi is a constant",
                            {"its rate along the motion", [=](S s) { return gamma(s, 1); }}, zero,
                            {{"without c mu3 cos phi", [=](S s) { return gamma(s, 0); }}}));
  all.back().printed.checks.push_back(along_the_motion(start));
  all.push_back(judge.claim(
      "as_by_euler", 3081, "both constants are those of Euler's equations",
      {"(c, gamma), their formulas",
       [](S s) { return values(total(s), momentum(s, 0)(s.q, s.v), rate_of(s, s.truth, spin)); }},
      {"(w3, vertical part of R J w, w3' of Euler's equations)",
       [](S s) {
         const auto r = rotation(s.q[0], s.q[1], s.q[2]);
         const Vector<double> w = s.body_rates();
         return values(w[2], s.mu1 * (r[2][0] * w[0] + r[2][1] * w[1]) + s.mu3 * r[2][2] * w[2],
                       spin_rate_by_euler(s, w));
       }},
      {{"(psi', ...)",
        [](S s) { return values(s.v[2], momentum(s, 0)(s.q, s.v), rate_of(s, s.truth, spin)); }}}));
  all.push_back(judge.claim("middle_equation", 3083, "phi'' with the spin put in",
                            {"alpha sin phi + theta'^2 sin phi cos phi - (c mu3/mu1) theta' sin phi",
                             [=](S s) { return middle(s, 1, 1); }},
                            lagrange,
                            {{"+(c mu3/mu1) theta' sin phi", [=](S s) { return middle(s, -1, 1); }}}));
  all.push_back(judge.claim(
      "alpha", 3087, "alpha = m g l/mu1 makes the tilting force",
      {"mu1 phi'' less its other terms, by alpha sin phi",
       [=](S s) { return s.m * s.body.g * s.l / s.mu1 * sin(s.q[1]); }},
      {"nested dual numbers on the points' T - V", [=](S s) { return s.truth[1] - middle(s, 1, 0); }},
      {{"m g l/mu3", [](S s) { return s.m * s.body.g * s.l / s.mu3 * sin(s.q[1]); }}}));
  return all;
}

Top asked(const Parameters& p) {
  return {p["m"],   p["l"],   p["mu1"],    p["mu3"],  p["g"],   p["theta"],
          p["phi"], p["psi"], p["dtheta"], p["dphi"], p["dpsi"]};
}

Quantity axis_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return axis(asked(p), horizon, truth);
}

Scene scene() {
  return {
      axis_of,
      duration,
      degree,
      "dpsi",
      {5, 10, 20, 30, 60, 100},
      {"phi", "dtheta", "dpsi"},
      {{"x", "y", "z"}, "s", {{"rad", {0, 1, 2}}}},
      {{"chapters/03_rigid_body_motion/33_heavy_top/models.hpp"},
       {{"mean precession of a fast top",
         "heavy_top::MeanPrecession<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"},
        {"one angle, precession by quadrature",
         "heavy_top::OneAngle<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"},
        {"Euler angles",
         "heavy_top::EulerAngles<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"},
        {"rigid body, quaternion",
         "heavy_top::RigidBody<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"},
        {"axis and angular momentum",
         "heavy_top::AxisAndMomentum<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Top start = asked(p);
  const Judge judge("3.33", p["seed"]);
  Findings found;
  for (const auto& part :
       {energy_claims(judge), derivative_claims(judge), force_claims(judge), motion_claims(judge, start)})
    found.claims.insert(found.claims.end(), part.begin(), part.end());
  found.quantities = quantities(start, truth);
  found.quantities.insert(found.quantities.begin(), motion(scene(), p, truth));
  return found;
}

}  // namespace ex03_33

Exercise exercise_3_33() {
  using namespace ex03_33;
  return {"Heavy symmetric top",
          "A top symmetric about its axis stands with its tip fixed under gravity. Find its equations of "
          "motion by Lagrange's method, in the angles $\\theta$ (precession), $\\phi$ (tilt) and $\\psi$ "
          "(spin).",
          parameters, scene(), study};
}

}  // namespace oddity
