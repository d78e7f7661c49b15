// The claims of exercise 3.33, judged against tops made of point masses, whose energies and forces come from
// the points' positions by dual numbers.

#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/03_rigid_body_motion/shared/top_of_points.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ex03_33 {

using namespace top;
using std::cos, std::sin;

namespace {

using Reader = Formula<Sample>;
using Samples = std::vector<Sample>;

// ---- the text's formulas, generic in their number type ----------------------------------------------------

/// Angular velocity in body coordinates; `second` is the angle in its second component's first term.
Value rates(const Sample& s, double second) {
  const auto [theta, phi, psi] = s.q;
  const auto [dtheta, dphi, dpsi] = s.v;
  return {dphi * cos(psi) + dtheta * sin(psi) * sin(phi), -dphi * sin(second) + dtheta * cos(psi) * sin(phi),
          dpsi + dtheta * cos(phi)};
}

/// Of half the tensor, when J is diagonal.
double half_wJw(const Sample& s, const Value& w, double mu1) {
  return mu1 / 2 * (w[0] * w[0] + w[1] * w[1]) + s.mu3 / 2 * w[2] * w[2];
}

constexpr auto spin = [](const auto& q, const auto& v) { return v[2] + v[0] * cos(q[1]); };
double spin_of(const Sample& s) { return spin(s.q, s.v); }

/// T in the angles, with sin(phi) or another function of the tilt.
double kinetic(const Sample& s, double across) {
  const double c = spin_of(s);
  return s.mu1 / 2 * (s.v[1] * s.v[1] + s.v[0] * s.v[0] * across * across) + s.mu3 / 2 * c * c;
}

double dT_dphi(const Sample& s, double sign = 1) {
  return s.mu1 * s.v[0] * s.v[0] * sin(s.q[1]) * cos(s.q[1]) +
         sign * s.mu3 * spin_of(s) * (-s.v[0] * sin(s.q[1]));
}

/// The text's momenta: of theta with the factor `sign` before mu3, of phi, of psi.
auto momentum(const Sample& s, std::size_t k, double sign = 1) {
  return [&s, k, sign](const auto& q, const auto& v) {
    const auto about_axis = s.mu3 * (v[2] + v[0] * cos(q[1]));
    if (k == 0) return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + sign * (about_axis * cos(q[1]));
    return k == 1 ? s.mu1 * v[1] : about_axis;
  };
}
Reader momentum(const std::string& text, std::size_t k, double sign = 1) {
  return {text, [=](const Sample& s) { return momentum(s, k, sign)(s.q, s.v); }};
}

// ---- the points' ------------------------------------------------------------------------------------------

/// Their kinetic energy's derivative by an angle or by its rate.
Reader slope_of_T(std::size_t k, bool rate) {
  return {"the points' $T$, by dual numbers", [=](const Sample& s) {
            return by_angle(
                s, k,
                [&](const auto& q, const auto& v) {
                  return s.body.kinetic(q, v, std::remove_cvref_t<decltype(q[0])>(s.t));
                },
                rate);
          }};
}

/// The derivative of the center of mass by an angle.
Reader arm(std::size_t k) {
  return {R"(derivative of $\ell R\mathbf k$, by dual numbers)", [k](const Sample& s) {
            std::array<Dual<double>, 3> q;
            for (std::size_t i = 0; i < 3; ++i) q[i] = {s.q[i], i == k ? 1.0 : 0.0};
            const auto r = rotation(q[0], q[1], q[2]);
            return values(s.l * r[0][2].slope, s.l * r[1][2].slope, s.l * r[2][2].slope);
          }};
}

/// The generalized force of gravity on every point.
Reader force(std::size_t k) {
  return {"minus the slope of the points' potential", [k](const Sample& s) {
            return -by_angle(s, k, [&](const auto& q, const auto&) {
              return s.body.potential(q, std::remove_cvref_t<decltype(q[0])>(s.t));
            });
          }};
}

const Reader points_T{R"($\sum m|\dot{\mathbf x}|^2/2$ over the points)",
                      [](const Sample&s) { return s.body.kinetic(s.q, s.v, s.t); }},
    zero{"zero", [](const Sample&) { return values(0); }},
    none{"zero", [](const Sample&) { return values(0, 0, 0); }};

// ---- the energy -------------------------------------------------------------------------------------------

void claim_energy(Claims& claims, const Samples& tops) {
  claims.formula(
      "center_of_mass", 2953, R"(the center of mass is $\ell\boldsymbol\xi_3$)", tops,
      {.quantity = "center of mass in body coordinates",
       .truth = {R"($\sum m\mathbf x/m$ over the points)",
                 [](const Sample& s) {
                   Vector<double> sum{};
                   for (const Point& p : s.body.points)
                     for (std::size_t i = 0; i < 3; ++i) sum[i] += p.m * p.x[i] / s.m;
                   return sum;
                 }},
       .printed = {R"($(0,0,\ell)$)", [](const Sample& s) { return values(0, 0, s.l); }},
       .near_misses = {{R"($(0,0,2\ell)$)", [](const Sample& s) { return values(0, 0, 2 * s.l); }}}});

  const auto turned = [](const std::string& text, double sign) {
    return Reader{text, [sign](const Sample& s) {
                    const Value w = rates(s, s.q[2]);
                    return values(sign * s.l * w[1], -sign * s.l * w[0], 0);
                  }};
  };
  claims.formula(
      "center_of_mass_at_rest", 2953, "the velocity of the center of mass is zero in body coordinates", tops,
      {.quantity = "velocity of the center of mass in body coordinates",
       .truth = {R"($R^T\dot{\mathbf r}$, by dual numbers)",
                 [](const Sample& s) {
                   const Matrix<double> w = s.body_spin();
                   return values(s.l * w[0][2], s.l * w[1][2], s.l * w[2][2]);
                 }},
       .printed = none,
       .corrected =
           turned(R"($\mathbf w\times\ell\boldsymbol\xi_3=\ell(w_2,-w_1,0)$, $\mathbf w$ by the text's )"
                  R"(formulas with $\sin\psi$)",
                  1),
       .near_misses = {turned(R"($\ell(-w_2,w_1,0)$)", -1)},
       .kind = Fault::term,
       .root = "velocity for position",
       .why =
           R"(What does not change are the body coordinates of the center of mass. Its velocity has the body )"
           R"(components $\ell(w_2,-w_1,0)$: the center runs on a sphere about the tip and has the kinetic energy )"
           R"($\frac12m\ell^2(w_1^2+w_2^2)$. The final $T$ is right only because $\mu_1$ is taken about the tip, )"
           R"(which has that energy in it; with the moment about the center of mass it is wrong by just this )"
           R"(term.)"});

  const auto change_of_axis = [](const std::string& text, double turning) {
    return Reader{text, [turning](const Sample& s) {
                    const Matrix<double> world = s.body_spin();
                    const Value w = rates(s, s.q[2]);
                    return values(world[0][2] - turning * w[1], world[1][2] + turning * w[0], world[2][2]);
                  }};
  };
  claims.formula(
      "axis_unchanging", 2953, R"($\boldsymbol\xi_3$ does not change in body coordinates)", tops,
      {.truth = none,
       .printed = change_of_axis(R"(its rate in the world less $\mathbf w\times\boldsymbol\xi_3$, zero)", 1),
       .near_misses = {change_of_axis("its rate in the world, zero", 0)}});

  claims.formula("kinetic_energy", 2955, R"(the kinetic energy is $T=\frac12\mathbf w^TJ\mathbf w$)", tops,
                 {.quantity = "$T$",
                  .truth = points_T,
                  .printed = {R"($J$ about the tip, $\mathbf w$ from $R^T\dot R$)",
                              [](const Sample& s) { return half_wJw(s, s.body_rates(), s.mu1); }},
                  .near_misses = {{"$J$ about the center of mass", [](const Sample& s) {
                                     return half_wJw(s, s.body_rates(), s.mu1 - s.m * s.l * s.l);
                                   }}}});

  const auto diagonal = [](const std::string& text, double Sample::*second) {
    return Reader{text,
                  [second](const Sample& s) { return values(s.mu1, 0, 0, 0, s.*second, 0, 0, 0, s.mu3); }};
  };
  claims.formula("inertia", 2961, "the inertia tensor in body coordinates", tops,
                 {.truth = {R"($\sum m(|\mathbf x|^2-\mathbf x\mathbf x^T)$ over the points)",
                            [](const Sample& s) {
                              Value J(std::vector<double>(9, 0.0));
                              for (const Point& p : s.body.points)
                                for (std::size_t i = 0; i < 3; ++i)
                                  for (std::size_t k = 0; k < 3; ++k)
                                    J[3 * i + k] += p.m * ((i == k ? dot(p.x, p.x) : 0) - p.x[i] * p.x[k]);
                              return J;
                            }},
                  .printed = diagonal(R"($J=\mathrm{Diag}(\mu_1,\mu_1,\mu_3)$)", &Sample::mu1),
                  .near_misses = {diagonal(R"($\mathrm{Diag}(\mu_1,\mu_3,\mu_3)$)", &Sample::mu3)}});

  const auto omega = [](const std::string& text, auto angle) {
    return Reader{text, [angle](const Sample& s) { return rates(s, angle(s)); }};
  };
  const auto energy = [](const std::string& text, auto angle) {
    return Reader{text, [angle](const Sample& s) { return half_wJw(s, rates(s, angle(s)), s.mu1); }};
  };
  const auto by_phi = [](const Sample& s) { return s.q[1]; };
  const auto by_psi = [](const Sample& s) { return s.q[2]; };
  const auto by_minus_psi = [](const Sample& s) { return -s.q[2]; };
  const std::string rest = R"(+\dot\theta\cos\psi\sin\phi$)";
  claims.formula(
      "angular_velocity", 2967, R"(the second component of $\mathbf w$ in body coordinates)", tops,
      {.quantity = R"($\mathbf w$)",
       .truth = {R"($R^T\dot R$, by dual numbers)", [](const Sample& s) { return s.body_rates(); }},
       .printed = omega(R"($w_2=-\dot\phi\sin\phi)" + rest, by_phi),
       .meant = omega(R"($w_2=-\dot\phi\sin\psi)" + rest, by_psi),
       .near_misses = {omega(R"($w_2=+\dot\phi\sin\psi)" + rest, by_minus_psi)},
       .kind = Fault::formula,
       .why =
           R"(The second component begins with $-\dot\phi\sin\psi$; printed is the angle $\phi$. With it )"
           R"($w_1^2+w_2^2$ would depend on $\psi$, and the text's own next line would not follow. The angles are )"
           R"(those of $R=R_z(\theta)R_x(\phi)R_z(\psi)$: of this order the rates in body coordinates have the )"
           R"(signs printed.)"});

  const auto tensor = [](const std::string& text, double factor) {
    return Reader{text,
                  [factor](const Sample& s) { return 2 * factor * half_wJw(s, s.body_rates(), s.mu1); }};
  };
  claims.formula(
      "kinetic_energy_again", 2971, R"($T$ by the tensor and $\mathbf w$)", tops,
      {.quantity = "$T$",
       .truth = points_T,
       .printed = tensor(R"($12\,\mathbf w^TJ\mathbf w$)", 12),
       .meant = tensor(R"($\frac12\mathbf w^TJ\mathbf w$)", 0.5),
       .near_misses = {tensor(R"($\mathbf w^TJ\mathbf w$)", 1)},
       .kind = Fault::lost_typography,
       .why =
           R"(The fraction bar of $\tfrac12$ is lost in the text at hand. Line 2959 has it on two lines, and the )"
           R"($\mu_1/2$ of the next lines come from it. As it stands the top has 24 times its energy.)"});

  claims.formula("energy_by_components", 2973, R"(the second square in $T$ by the components of $\mathbf w$)",
                 tops,
                 {.quantity = "$T$",
                  .truth = points_T,
                  .printed = energy(R"(that of $-\dot\phi\sin\phi)" + rest, by_phi),
                  .meant = energy(R"(that of $-\dot\phi\sin\psi)" + rest, by_psi),
                  .near_misses = {energy(R"(that of $+\dot\phi\sin\psi)" + rest, by_minus_psi)},
                  .kind = Fault::formula,
                  .why = R"(The same letter: $\phi$ stands for $\psi$ in the second square.)"});

  claims.formula(
      "energy_reduced", 2981, "$T$ in the angles", tops,
      {.truth = points_T,
       .printed =
           {R"($\frac{\mu_1}2(\dot\phi^2+\dot\theta^2\sin^2\phi)+\frac{\mu_3}2(\dot\psi+\dot\theta\cos\phi)^2$)",
            [](const Sample& s) { return kinetic(s, sin(s.q[1])); }},
       .near_misses = {
           {R"($\cos^2\phi$ for $\sin^2\phi$)", [](const Sample& s) { return kinetic(s, cos(s.q[1])); }}}});
}

// ---- its derivatives --------------------------------------------------------------------------------------

void claim_derivatives(Claims& claims, const Samples& tops) {
  const Reader at_phi{R"($\partial T/\partial\phi=0$)", slope_of_T(1, false).of};
  const auto zero_of = [](std::size_t k, const std::string& text) {
    return Reader{text, slope_of_T(k, false).of};
  };
  // A published zero stands on the right.
  claims.formula("dT_dtheta", 2989, R"($T$ does not depend on $\theta$)", tops,
                 {.quantity = R"($\partial T/\partial\theta$ of the points' $T$, by dual numbers)",
                  .truth = zero,
                  .printed = zero_of(0, R"($\partial T/\partial\theta=0$)"),
                  .near_misses = {at_phi}});
  const auto by_phi = [](const std::string& sign, double factor) {
    return Reader{R"($\mu_1\dot\theta^2\sin\phi\cos\phi)" + sign +
                      R"(\mu_3(\dot\psi+\dot\theta\cos\phi)\dot\theta\sin\phi$)",
                  [factor](const Sample& s) { return dT_dphi(s, factor); }};
  };
  claims.formula(
      "dT_dphi", 2993, R"($\partial T/\partial\phi$)", tops,
      {.truth = slope_of_T(1, false), .printed = by_phi("-", 1), .near_misses = {by_phi("+", -1)}});
  claims.formula("dT_dpsi", 2997, R"($T$ does not depend on $\psi$)", tops,
                 {.quantity = R"($\partial T/\partial\psi$ of the points' $T$, by dual numbers)",
                  .truth = zero,
                  .printed = zero_of(2, R"($\partial T/\partial\psi=0$)"),
                  .near_misses = {at_phi}});
  const std::string about_axis = R"(\mu_3(\dot\psi+\dot\theta\cos\phi))";
  const auto of_theta = [&](const std::string& sign, double factor) {
    return momentum(R"($\mu_1\dot\theta\sin^2\phi)" + sign + about_axis + R"(\cos\phi$)", 0, factor);
  };
  claims.formula(
      "dT_dtheta_dot", 3001, R"($\partial T/\partial\dot\theta$)", tops,
      {.truth = slope_of_T(0, true), .printed = of_theta("+", 1), .near_misses = {of_theta("-", -1)}});
  claims.formula("dT_dphi_dot", 3005, R"($\partial T/\partial\dot\phi$)", tops,
                 {.truth = slope_of_T(1, true),
                  .printed = momentum(R"($\mu_1\dot\phi$)", 1),
                  .near_misses = {{R"($\mu_3\dot\phi$)", [](const Sample& s) { return s.mu3 * s.v[1]; }}}});
  claims.formula("dT_dpsi_dot", 3009, R"($\partial T/\partial\dot\psi$)", tops,
                 {.truth = slope_of_T(2, true),
                  .printed = momentum("$" + about_axis + "$", 2),
                  .near_misses = {{R"($\mu_3\dot\psi$)", [](const Sample& s) { return s.mu3 * s.v[2]; }}}});

  const auto expression = [](const std::string& angle) {
    return R"($\frac{d}{dt}\frac{\partial T}{\partial\dot)" + angle + R"(}-\frac{\partial T}{\partial)" +
           angle + "}$";
  };
  const auto points = [](std::size_t k) {
    return Reader{"nested dual numbers on the points' $T$", [k](const Sample& s) { return s.kinetic[k]; }};
  };
  const auto rate = [](const std::string& text, std::size_t k, double sign = 1) {
    return Reader{text, [=](const Sample& s) { return rate_of(s, s.a, momentum(s, k, sign)); }};
  };
  const auto rate_of_theta = [&](const std::string& sign, double factor) {
    return rate(R"($\frac{d}{dt}(\mu_1\dot\theta\sin^2\phi)" + sign + about_axis + R"(\cos\phi)$)", 0,
                factor);
  };
  claims.formula("lagrange_theta", 3015, R"(Lagrange's expression for $\theta$, )" + expression(R"(\theta)"),
                 tops,
                 {.quantity = expression(R"(\theta)"),
                  .truth = points(0),
                  .printed = rate_of_theta("+", 1),
                  .near_misses = {rate_of_theta("-", -1)}});
  claims.formula("lagrange_phi", 3021, R"(Lagrange's expression for $\phi$, )" + expression(R"(\phi)"), tops,
                 {.quantity = expression(R"(\phi)"),
                  .truth = points(1),
                  .printed = {R"($\mu_1\ddot\phi-\mu_1\dot\theta^2\sin\phi\cos\phi+)" + about_axis +
                                  R"(\dot\theta\sin\phi$)",
                              [](const Sample& s) { return rate_of(s, s.a, momentum(s, 1)) - dT_dphi(s); }},
                  .near_misses = {rate(R"($\mu_1\ddot\phi$ alone)", 1)}});
  claims.formula("lagrange_psi", 3029, R"(Lagrange's expression for $\psi$, )" + expression(R"(\psi)"), tops,
                 {.quantity = expression(R"(\psi)"),
                  .truth = points(2),
                  .printed = rate(R"($\frac{d}{dt}()" + about_axis + ")$", 2),
                  .near_misses = {{R"($\mu_3\ddot\psi$)", [](const Sample& s) { return s.mu3 * s.a[2]; }}}});
}

// ---- the forces -------------------------------------------------------------------------------------------

void claim_forces(Claims& claims, const Samples& tops) {
  const auto by_theta = [](const std::string& text, double second) {
    return Reader{text, [second](const Sample& s) {
                    return values(s.l * cos(s.q[0]) * sin(s.q[1]), second * s.l * sin(s.q[0]) * sin(s.q[1]),
                                  0);
                  }};
  };
  claims.formula("dr_dtheta", 3037, R"($\partial\mathbf r/\partial\theta$)", tops,
                 {.truth = arm(0),
                  .printed = by_theta(R"($\ell(\cos\theta\sin\phi,\sin\theta\sin\phi,0)$)", 1),
                  .near_misses = {by_theta(R"($\ell(\cos\theta\sin\phi,-\sin\theta\sin\phi,0)$)", -1)}});
  claims.formula(
      "force_theta", 3039, R"(the generalized force of $\theta$)", tops,
      {.quantity = R"(the generalized force of $\theta$, minus the slope of the points' potential)",
       .truth = zero,
       .printed = {"$F_\\theta=0$", force(0).of},
       .near_misses = {{R"($F_\phi=0$)", force(1).of}}});
  const auto by_phi = [](const std::string& text, double second) {
    return Reader{text, [second](const Sample& s) {
                    return values(s.l * sin(s.q[0]) * cos(s.q[1]), second * s.l * cos(s.q[0]) * cos(s.q[1]),
                                  -s.l * sin(s.q[1]));
                  }};
  };
  claims.formula("dr_dphi", 3043, R"($\partial\mathbf r/\partial\phi$)", tops,
                 {.truth = arm(1),
                  .printed = by_phi(R"($\ell(\sin\theta\cos\phi,-\cos\theta\cos\phi,-\sin\phi)$)", -1),
                  .near_misses = {by_phi(R"($\ell(\sin\theta\cos\phi,\cos\theta\cos\phi,-\sin\phi)$)", 1)}});
  const auto weight = [](const std::string& text, double sign) {
    return Reader{text, [sign](const Sample& s) { return sign * s.m * s.body.g * s.l * sin(s.q[1]); }};
  };
  claims.formula("force_phi", 3045, R"(the generalized force of $\phi$)", tops,
                 {.truth = force(1),
                  .printed = weight(R"($F_\phi=mg\ell\sin\phi$)", 1),
                  .near_misses = {weight(R"($F_\phi=-mg\ell\sin\phi$)", -1)}});
  const auto arm_is_zero = [&](const std::string& angle, std::size_t k) {
    return compare(R"($\partial\mathbf r/\partial)" + angle + "$", arm(k), none, tops);
  };
  claims.add(
      "dr_dpsi", 3049, R"(the force of $\psi$ is zero, as its arm is)",
      {.printed = {R"($-mg\mathbf k\cdot\partial\mathbf r/\partial\theta=0$, the arm zero)",
                   {arm_is_zero(R"(\theta)", 0)}},
       .meant = {R"($-mg\mathbf k\cdot\partial\mathbf r/\partial\psi=0$, the arm zero)",
                 {arm_is_zero(R"(\psi)", 2), compare(R"(the force of $\psi$)", force(2), zero, tops)}},
       .near_misses = {{R"($-mg\mathbf k\cdot\partial\mathbf r/\partial\phi=0$, the arm zero)",
                        {arm_is_zero(R"(\phi)", 1)}}},
       .why = R"(Printed is $\partial\mathbf r/\partial\theta$ again, which has just been given and is not )"
              R"(zero. The zeros are those of $\partial\mathbf r/\partial\psi$: a spin about the axis moves )"
              R"(no point of it.)",
       .kind = Fault::formula});
}

// ---- the motion -------------------------------------------------------------------------------------------

/// (c, gamma) of the rigid body after 4 s against the start's, by the text's formulas.
Check along_the_motion(const Top& start) {
  const heavy_top::RigidBody<double> body{{start}};
  const auto run = ode::integrate<ode::Fehlberg78>(body, body.start(), 0, 4, 1e-12);
  const auto [q, i, j, k, w1, w2, w3] = run.value;
  const double up1 = 2 * (i * k - q * j), up2 = 2 * (j * k + q * i), up3 = 1 - 2 * (i * i + j * j);
  const double sine = sin(start.phi), c = start.dpsi + start.dtheta * cos(start.phi);
  const double gamma = start.mu1 * start.dtheta * sine * sine + c * start.mu3 * cos(start.phi);
  return {R"($(c,\gamma)$, $\gamma=\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi$)",
          {"rigid body after 4 s", {w3, start.mu1 * (up1 * w1 + up2 * w2) + start.mu3 * up3 * w3}},
          {"the text's formulas at the start", {c, gamma}},
          {1e-11 * std::abs(c), "ten tolerances of the integration"}};
}

/// Euler's third equation, the moments and the torque of gravity summed over the points.
double spin_rate_by_euler(const Sample& s, const Vector<double>& w) {
  const auto r = rotation(s.q[0], s.q[1], s.q[2]);
  double J1 = 0, J2 = 0, torque = 0;
  for (const Point& p : s.body.points) {
    J1 += p.m * (p.x[1] * p.x[1] + p.x[2] * p.x[2]);
    J2 += p.m * (p.x[0] * p.x[0] + p.x[2] * p.x[2]);
    torque -= p.m * s.body.g * (p.x[0] * r[2][1] - p.x[1] * r[2][0]);
  }
  return ((J1 - J2) * w[0] * w[1] + torque) / s.mu3;
}

/// The middle equation's right side, with factors of its last and of its first term.
double tilting(const Sample& s, double turning, double weight) {
  const double c = spin_of(s), sine = sin(s.q[1]);
  return weight * s.m * s.body.g * s.l / s.mu1 * sine + s.v[0] * s.v[0] * sine * cos(s.q[1]) -
         turning * c * s.mu3 / s.mu1 * s.v[0] * sine;
}

void claim_motion(Claims& claims, const Samples& tops, const Top& start) {
  const std::string about_axis = R"(\mu_3(\dot\psi+\dot\theta\cos\phi))";
  const auto along = [](const std::string& text, std::size_t k, double sign = 1) {
    return Reader{text, [=](const Sample& s) { return rate_of(s, s.truth, momentum(s, k, sign)); }};
  };
  const auto of_theta = [&](const std::string& sign, double factor) {
    return along(R"($\frac{d}{dt}(\mu_1\dot\theta\sin^2\phi)" + sign + about_axis + R"(\cos\phi)=0$)", 0,
                 factor);
  };
  const std::string by_lagrange = ", along Lagrange's accelerations";
  claims.formula("motion_theta", 3055, R"(the equation of motion of $\theta$)", tops,
                 {.quantity = R"(the rate of $\theta$'s momentum)" + by_lagrange,
                  .truth = zero,
                  .printed = of_theta("+", 1),
                  .near_misses = {of_theta("-", -1)}});
  const auto of_phi = [&](const std::string& sign, double factor) {
    return Reader{R"($\mu_1\ddot\phi)" + sign + R"(\mu_1\dot\theta^2\sin\phi\cos\phi+)" + about_axis +
                      R"(\dot\theta\sin\phi=mg\ell\sin\phi$)",
                  [factor](const Sample& s) {
                    return rate_of(s, s.truth, momentum(s, 1)) - dT_dphi(s) +
                           factor * s.mu1 * s.v[0] * s.v[0] * sin(s.q[1]) * cos(s.q[1]);
                  }};
  };
  claims.formula(
      "motion_phi", 3061, R"(the equation of motion of $\phi$)", tops,
      {.quantity = R"(the terms of the angles' rates)" + by_lagrange,
       .truth = {R"($mg\ell\sin\phi$)", [](const Sample& s) { return s.m * s.body.g * s.l * sin(s.q[1]); }},
       .printed = of_phi("-", 0),
       .near_misses = {of_phi("+", 2)}});
  claims.formula("motion_psi", 3069, R"(the equation of motion of $\psi$)", tops,
                 {.quantity = R"(the rate of $\psi$'s momentum)" + by_lagrange,
                  .truth = zero,
                  .printed = along(R"($\frac{d}{dt}()" + about_axis + ")=0$", 2),
                  .near_misses = {{R"($\frac{d}{dt}(\mu_3\dot\psi)=0$)",
                                   [](const Sample& s) { return s.mu3 * s.truth[2]; }}}});
  claims.formula("spin_constant", 3075, "what the equation of $\\psi$ keeps constant", tops,
                 {.quantity = "its rate" + by_lagrange,
                  .truth = zero,
                  .printed = {R"($\dot\psi+\dot\theta\cos\phi$)",
                              [](const Sample& s) { return rate_of(s, s.truth, spin); }},
                  .near_misses = {{R"($\dot\psi-\dot\theta\cos\phi$)", [](const Sample& s) {
                                     return rate_of(s, s.truth, [](const auto& q, const auto& v) {
                                       return v[2] - v[0] * cos(q[1]);
                                     });
                                   }}}});
  const auto kept = [&](const std::string& text, double factor) {
    const Reader gamma{"its rate" + by_lagrange, [factor](const Sample& s) {
                         const double c = spin_of(s);
                         return rate_of(s, s.truth, [&](const auto& q, const auto& v) {
                           return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + factor * c * s.mu3 * cos(q[1]);
                         });
                       }};
    return Reading{text, {compare(text, gamma, zero, tops)}};
  };
  Reading both = kept(R"($\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi$, $c$ the constant spin)", 1);
  both.checks.push_back(along_the_motion(start));
  claims.add("vertical_constant", 3079, R"(what the equation of $\theta$ keeps constant)",
             {.printed = both, .near_misses = {kept(R"($\mu_1\dot\theta\sin^2\phi$)", 0)}});
  const auto constants = [](const std::string& text, auto first) {
    return Reader{text, [first](const Sample& s) {
                    return values(first(s), momentum(s, 0)(s.q, s.v), rate_of(s, s.truth, spin));
                  }};
  };
  claims.formula(
      "as_by_euler", 3081, "both constants are those of Euler's equations", tops,
      {.quantity = R"($(c,\gamma,\dot c)$)",
       .truth = {R"($w_3$, the vertical part of $RJ\mathbf w$, and $\dot w_3$ of Euler's equations)",
                 [](const Sample& s) {
                   const auto r = rotation(s.q[0], s.q[1], s.q[2]);
                   const Vector<double> w = s.body_rates();
                   return values(w[2], s.mu1 * (r[2][0] * w[0] + r[2][1] * w[1]) + s.mu3 * r[2][2] * w[2],
                                 spin_rate_by_euler(s, w));
                 }},
       .printed = constants(
           R"($c=\dot\psi+\dot\theta\cos\phi$, $\gamma=\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi$)",
           spin_of),
       .near_misses = {constants(R"($c=\dot\psi$)", [](const Sample& s) { return s.v[2]; })}});
  const Reader lagrange{"nested dual numbers on the points' $T-V$",
                        [](const Sample& s) { return s.truth[1]; }};
  const auto middle = [](const std::string& sign, double factor) {
    return Reader{R"($\ddot\phi=\alpha\sin\phi+\dot\theta^2\sin\phi\cos\phi)" + sign +
                      R"(\frac{c\mu_3}{\mu_1}\dot\theta\sin\phi$)",
                  [factor](const Sample& s) { return tilting(s, factor, 1); }};
  };
  claims.formula("middle_equation", 3083, R"(the equation of $\phi$ with the spin put in)", tops,
                 {.quantity = R"($\ddot\phi$)",
                  .truth = lagrange,
                  .printed = middle("-", 1),
                  .near_misses = {middle("+", -1)}});
  const auto alpha = [](const std::string& text, double Sample::*moment) {
    return Reader{text,
                  [moment](const Sample& s) { return s.m * s.body.g * s.l / (s.*moment) * sin(s.q[1]); }};
  };
  claims.formula(
      "alpha", 3087, R"($\alpha$ makes the tilting force $\mu_1\alpha\sin\phi$)", tops,
      {.quantity = R"($\alpha\sin\phi$)",
       .truth = {R"($\ddot\phi$ by nested dual numbers on the points' $T-V$, less its other terms)",
                 [](const Sample& s) { return s.truth[1] - tilting(s, 1, 0); }},
       .printed = alpha(R"($\alpha=mg\ell/\mu_1$)", &Sample::mu1),
       .near_misses = {alpha(R"($\alpha=mg\ell/\mu_3$)", &Sample::mu3)}});
}

}  // namespace

std::vector<Claim> claims(double seed, const Top& start) {
  const Samples tops = random_tops(seed);
  Claims claims("3.33");
  claim_energy(claims, tops);
  claim_derivatives(claims, tops);
  claim_forces(claims, tops);
  claim_motion(claims, tops, start);
  return claims.in_order();
}

std::vector<Root> roots() {
  return {
      {"velocity for position",
       R"(A game that takes the center of mass for one at rest, and so the moment 0.0625 kg m$^2$ about it for the )"
       R"(0.125 kg m$^2$ about the tip, has the top here nod 4.5 times a second, not 2.0.)"}};
}

}  // namespace oddity::ex03_33
