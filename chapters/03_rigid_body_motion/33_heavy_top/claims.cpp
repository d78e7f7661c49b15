// The claims of exercise 3.33, judged against tops made of point masses, whose energies and forces come from
// the points' positions by dual numbers.

#include <map>
#include <string>
#include <vector>

#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/03_rigid_body_motion/shared/top_of_points.hpp"
#include "chapters/provable_claims.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ex03_33 {

using namespace top;
using std::cos, std::sin;

namespace {

using Reader = ProvableFormula<SampleOf>;
using Table = ProvableClaims<SampleOf>;
using Samples = std::vector<Sample>;

// ---- the text's formulas, generic in their number type ----------------------------------------------------

/// Angular velocity in body coordinates; `second` is the angle in its second component's first term.
template <class T>
auto rates(const SampleOf<T>& s, const T& second) {
  const auto& [theta, phi, psi] = s.q;
  const auto& [dtheta, dphi, dpsi] = s.v;
  return values(dphi * cos(psi) + dtheta * sin(psi) * sin(phi),
                -dphi * sin(second) + dtheta * cos(psi) * sin(phi), dpsi + dtheta * cos(phi));
}

/// Of half the tensor, when J is diagonal.
template <class T>
T half_wJw(const SampleOf<T>& s, const auto& w, const T& mu1) {
  return mu1 / 2 * (w[0] * w[0] + w[1] * w[1]) + s.mu3 / 2 * w[2] * w[2];
}

constexpr auto spin = [](const auto& q, const auto& v) { return v[2] + v[0] * cos(q[1]); };
template <class T>
T spin_of(const SampleOf<T>& s) {
  return spin(s.q, s.v);
}

/// T in the angles, with sin(phi) or another function of the tilt.
template <class T>
T kinetic(const SampleOf<T>& s, const T& across) {
  const T c = spin_of(s);
  return s.mu1 / 2 * (s.v[1] * s.v[1] + s.v[0] * s.v[0] * across * across) + s.mu3 / 2 * c * c;
}

template <class T>
T dT_dphi(const SampleOf<T>& s, double sign = 1) {
  return s.mu1 * s.v[0] * s.v[0] * sin(s.q[1]) * cos(s.q[1]) +
         sign * s.mu3 * spin_of(s) * (-s.v[0] * sin(s.q[1]));
}

/// The text's momenta: of theta with the factor `sign` before mu3, of phi, of psi.
template <class T>
auto momentum(const SampleOf<T>& s, std::size_t k, double sign = 1) {
  return [&s, k, sign](const auto& q, const auto& v) {
    const auto about_axis = s.mu3 * (v[2] + v[0] * cos(q[1]));
    if (k == 0) return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + sign * (about_axis * cos(q[1]));
    return k == 1 ? s.mu1 * v[1] : about_axis;
  };
}
Reader momentum(const std::string& text, std::size_t k, double sign = 1) {
  return {text, [=](const auto& s) { return momentum(s, k, sign)(s.q, s.v); }};
}

// ---- the points' ------------------------------------------------------------------------------------------

/// Their kinetic energy's derivative by an angle or by its rate.
Reader slope_of_T(std::size_t k, bool rate) {
  return {"the points' $T$, by dual numbers", [=](const auto& s) {
            return by_angle(
                s, k,
                [&](const auto& q, const auto& v) {
                  return s.body.kinetic(q, v, std::remove_cvref_t<decltype(q[0])>(s.t));
                },
                rate);
          }};
}

Reader titled(std::string text, Reader formula) {
  formula.text = std::move(text);
  return formula;
}

/// The derivative of the center of mass by an angle.
Reader arm(std::size_t k) {
  return {R"(derivative of $\ell R\mathbf k$, by dual numbers)", [k](const auto& s) {
            const auto q = toward(s.q, k);
            const auto r = rotation(q[0], q[1], q[2]);
            return values(s.l * r[0][2].slope, s.l * r[1][2].slope, s.l * r[2][2].slope);
          }};
}

/// The generalized force of gravity on every point.
Reader force(std::size_t k) {
  return {"minus the slope of the points' potential", [k](const auto& s) {
            return -by_angle(s, k, [&](const auto& q, const auto&) {
              return s.body.potential(q, std::remove_cvref_t<decltype(q[0])>(s.t));
            });
          }};
}

const Reader points_T{R"($\sum m|\dot{\mathbf x}|^2/2$ over the points)",
                      [](const auto&s) { return s.body.kinetic(s.q, s.v, s.t); }},
    zero{"zero", []<class T>(const SampleOf<T>&) { return T(0); }},
    none{"zero", []<class T>(const SampleOf<T>&) { return values(T(0), T(0), T(0)); }};

// ---- the energy -------------------------------------------------------------------------------------------

void claim_energy(Table& table, const Samples& tops) {
  table.formula("center_of_mass", 2953, R"(the center of mass is at $\mathbf r=\ell\boldsymbol\xi_3$)", tops,
                {.quantity = "center of mass in body coordinates",
                 .truth = {R"($\sum m\mathbf x/m$ over the points)",
                           []<class T>(const SampleOf<T>& s) {
                             return s.body.template sum<Vector<T>>([&](Vector<T>& sum, const PointOf<T>& p) {
                               for (std::size_t i = 0; i < 3; ++i) sum[i] += p.m * p.x[i] / s.m;
                             });
                           }},
                 .printed = {R"($(0,0,\ell)$)", [](const auto& s) { return values(0, 0, s.l); }},
                 .near_misses = {{R"($(0,0,2\ell)$)"}}});

  const auto turned = [](const std::string& text, double sign) {
    return Reader{text, [sign](const auto& s) {
                    const auto w = rates(s, s.q[2]);
                    return values(sign * s.l * w[1], -sign * s.l * w[0], 0);
                  }};
  };
  table.formula(
      "center_of_mass_at_rest", 2953, "the velocity of the center of mass is zero in body coordinates", tops,
      {.quantity = "velocity of the center of mass in body coordinates",
       .truth = {R"($R^T\dot{\mathbf r}$, by dual numbers)",
                 [](const auto& s) {
                   const auto w = s.body_spin();
                   return values(s.l * w[0][2], s.l * w[1][2], s.l * w[2][2]);
                 }},
       .printed = none,
       .corrected =
           turned(R"($\mathbf w\times\ell\boldsymbol\xi_3=\ell(w_2,-w_1,0)$, $\mathbf w$ by the text's )"
                  R"(formulas with $\sin\psi$)",
                  1),
       .near_misses = {R"($-\mathbf w\times(0,0,\ell)$)"},
       .kind = Fault::term,
       .root = "velocity for position",
       .why =
           R"(What does not change are the body coordinates of the center of mass. Its velocity has the body )"
           R"(components $\ell(w_2,-w_1,0)$: the center runs on a sphere about the tip and has the kinetic energy )"
           R"($\frac12m\ell^2(w_1^2+w_2^2)$. The final $T$ is right only because $\mu_1$ is taken about the tip, )"
           R"(which has that energy in it; with the moment about the center of mass it is wrong by just this )"
           R"(term.)"});

  const auto change_of_axis = [](const std::string& text, double turning) {
    return Reader{text, [turning](const auto& s) {
                    const auto world = s.body_spin();
                    const auto w = rates(s, s.q[2]);
                    return values(world[0][2] - turning * w[1], world[1][2] + turning * w[0], world[2][2]);
                  }};
  };
  table.formula(
      "axis_unchanging", 2953, R"($\boldsymbol\xi_3$ does not change in body coordinates)", tops,
      {.truth = none,
       .printed = change_of_axis(R"(its rate in the world less $\mathbf w\times\boldsymbol\xi_3$, zero)", 1),
       .near_misses = {change_of_axis("its rate in the world, zero", 0)}});

  table.formula("kinetic_energy", 2955, R"(the kinetic energy is $T=\frac12\mathbf w^TJ\mathbf w$)", tops,
                {.quantity = "$T$",
                 .truth = points_T,
                 .printed = {R"($J$ about the tip, $\mathbf w$ from $R^T\dot R$)",
                             [](const auto& s) { return half_wJw(s, s.body_rates(), s.mu1); }},
                 .near_misses = {{"$J$ about the center of mass", [](const auto& s) {
                                    return half_wJw(s, s.body_rates(), s.mu1 - s.m * s.l * s.l);
                                  }}}});

  table.formula("inertia", 2963, R"($J=\mathrm{Diag}(\mu_1,\mu_1,\mu_3)$ in body coordinates)", tops,
                {.quantity = "inertia tensor in body coordinates",
                 .truth = {R"($\sum m(|\mathbf x|^2-\mathbf x\mathbf x^T)$ over the points)",
                           []<class T>(const SampleOf<T>& s) {
                             using Tensor = std::array<T, 9>;
                             return s.body.template sum<Tensor>([](Tensor& J, const PointOf<T>& p) {
                               for (std::size_t i = 0; i < 3; ++i)
                                 for (std::size_t k = 0; k < 3; ++k)
                                   J[3 * i + k] += p.m * ((i == k ? dot(p.x, p.x) : T(0)) - p.x[i] * p.x[k]);
                             });
                           }},
                 .printed = {R"($J=\mathrm{Diag}(\mu_1,\mu_1,\mu_3)$)",
                             [](const auto& s) { return values(s.mu1, 0, 0, 0, s.mu1, 0, 0, 0, s.mu3); }},
                 .near_misses = {R"($\mathrm{Diag}(\mu_1,\mu_3,\mu_3)$)"}});

  const auto omega = [](const std::string& second, auto angle) {
    return Reader{R"($\mathbf w=(\dot\phi\cos\psi+\dot\theta\sin\psi\sin\phi,\ )" + second +
                      R"(+\dot\theta\cos\psi\sin\phi,\ \dot\psi+\dot\theta\cos\phi)$)",
                  [angle](const auto& s) { return rates(s, angle(s)); }};
  };
  const auto energy = [](const std::string& text, auto angle) {
    return Reader{text, [angle](const auto& s) { return half_wJw(s, rates(s, angle(s)), s.mu1); }};
  };
  const auto by_phi = [](const auto& s) { return s.q[1]; };
  const auto by_psi = [](const auto& s) { return s.q[2]; };
  const auto by_minus_psi = [](const auto& s) { return -s.q[2]; };
  const auto squares = [](const std::string& second) {
    return R"($\frac{\mu_1}2(\dot\phi\cos\psi+\dot\theta\sin\psi\sin\phi)^2+\frac{\mu_1}2()" + second +
           R"(+\dot\theta\cos\psi\sin\phi)^2+\frac{\mu_3}2(\dot\psi+\dot\theta\cos\phi)^2$)";
  };
  table.formula(
      "angular_velocity", 2967,
      R"($\mathbf w=(\dot\phi\cos\psi+\dot\theta\sin\psi\sin\phi,\ -\dot\phi\sin\phi+\dot\theta\cos\psi\sin\phi,)"
      R"(\ \dot\psi+\dot\theta\cos\phi)$ in body coordinates)",
      tops,
      {.quantity = R"($\mathbf w$)",
       .truth = {R"($R^T\dot R$, by dual numbers)", [](const auto& s) { return s.body_rates(); }},
       .printed = omega(R"(-\dot\phi\sin\phi)", by_phi),
       .meant = omega(R"(-\dot\phi\sin\psi)", by_psi),
       .near_misses = {omega(R"(\dot\phi\sin\psi)", by_minus_psi)},
       .kind = Fault::formula,
       .why =
           R"(The second component begins with $-\dot\phi\sin\psi$; printed is the angle $\phi$. With it )"
           R"($w_1^2+w_2^2$ would depend on $\psi$, and the text's own next line would not follow. The angles are )"
           R"(those of $R=R_z(\theta)R_x(\phi)R_z(\psi)$: of this order the rates in body coordinates have the )"
           R"(signs printed.)"});

  const auto tensor = [](const std::string& text, double factor) {
    return Reader{text, [factor](const auto& s) { return 2 * factor * half_wJw(s, s.body_rates(), s.mu1); }};
  };
  table.formula(
      "kinetic_energy_again", 2971, R"($T=\frac12\mathbf w^TJ\mathbf w$, the fraction bar lost)", tops,
      {.quantity = "$T$",
       .truth = points_T,
       .printed = tensor(R"($12\,\mathbf w^TJ\mathbf w$)", 12),
       .meant = tensor(R"($\frac12\mathbf w^TJ\mathbf w$)", 0.5),
       .near_misses = {R"($\mathbf w^TJ\mathbf w$)"},
       .kind = Fault::lost_typography,
       .why = filled(
           R"(The fraction bar of $\tfrac12$ is lost in the text at hand. Line 2959 has it on two lines, and the )"
           R"($\mu_1/2$ of the next lines come from it. As it stands the top has @2 times its energy.)",
           {12 / 0.5})});

  table.formula("energy_by_components", 2973, "$T=" + squares(R"(-\dot\phi\sin\phi)").substr(1), tops,
                {.quantity = "$T$",
                 .truth = points_T,
                 .printed = energy(squares(R"(-\dot\phi\sin\phi)"), by_phi),
                 .meant = energy(squares(R"(-\dot\phi\sin\psi)"), by_psi),
                 .near_misses = {energy(squares(R"(\dot\phi\sin\psi)"), by_minus_psi)},
                 .kind = Fault::formula,
                 .why = R"(Here too $\phi$ stands for $\psi$ in the second square.)"});

  table.formula(
      "energy_reduced", 2981,
      R"($T=\frac{\mu_1}2(\dot\phi^2+\dot\theta^2\sin^2\phi)+\frac{\mu_3}2(\dot\psi+\dot\theta\cos\phi)^2$)",
      tops,
      {.quantity = "$T$",
       .truth = points_T,
       .printed =
           {R"($\frac{\mu_1}2(\dot\phi^2+\dot\theta^2\sin^2\phi)+\frac{\mu_3}2(\dot\psi+\dot\theta\cos\phi)^2$)",
            [](const auto& s) { return kinetic(s, sin(s.q[1])); }},
       .near_misses = {
           {R"($\cos^2\phi$ for $\sin^2\phi$)", [](const auto& s) { return kinetic(s, cos(s.q[1])); }}}});
}

// ---- its derivatives --------------------------------------------------------------------------------------

void claim_derivatives(Table& table, const Samples& tops) {
  const auto zero_of = [](std::size_t k, const std::string& text) {
    return titled(text, slope_of_T(k, false));
  };
  const Reader at_phi = zero_of(1, R"($\partial T/\partial\phi=0$)");
  // A published zero stands on the right.
  table.formula("dT_dtheta", 2989, R"($\partial T/\partial\theta=0$)", tops,
                {.quantity = R"($\partial T/\partial\theta$ of the points' $T$, by dual numbers)",
                 .truth = zero,
                 .printed = zero_of(0, R"($\partial T/\partial\theta=0$)"),
                 .near_misses = {at_phi}});
  const auto by_phi = [](const std::string& sign, double factor) {
    return Reader{R"($\mu_1\dot\theta^2\sin\phi\cos\phi)" + sign +
                      R"(\mu_3(\dot\psi+\dot\theta\cos\phi)\dot\theta\sin\phi$)",
                  [factor](const auto& s) { return dT_dphi(s, factor); }};
  };
  table.formula("dT_dphi", 2993,
                R"($\partial T/\partial\phi=\mu_1\dot\theta^2\sin\phi\cos\phi)"
                R"(-\mu_3(\dot\psi+\dot\theta\cos\phi)\dot\theta\sin\phi$)",
                tops,
                {.quantity = R"($\partial T/\partial\phi$)",
                 .truth = slope_of_T(1, false),
                 .printed = by_phi("-", 1),
                 .near_misses = {by_phi("+", -1)}});
  table.formula("dT_dpsi", 2997, R"($\partial T/\partial\psi=0$)", tops,
                {.quantity = R"($\partial T/\partial\psi$ of the points' $T$, by dual numbers)",
                 .truth = zero,
                 .printed = zero_of(2, R"($\partial T/\partial\psi=0$)"),
                 .near_misses = {at_phi}});
  const std::string about_axis = R"(\mu_3(\dot\psi+\dot\theta\cos\phi))";
  const auto of_theta = [&](const std::string& sign, double factor) {
    return momentum(R"($\mu_1\dot\theta\sin^2\phi)" + sign + about_axis + R"(\cos\phi$)", 0, factor);
  };
  table.formula("dT_dtheta_dot", 3001,
                R"($\partial T/\partial\dot\theta=\mu_1\dot\theta\sin^2\phi+)" + about_axis + R"(\cos\phi$)",
                tops,
                {.quantity = R"($\partial T/\partial\dot\theta$)",
                 .truth = slope_of_T(0, true),
                 .printed = of_theta("+", 1),
                 .near_misses = {of_theta("-", -1)}});
  table.formula("dT_dphi_dot", 3005, R"($\partial T/\partial\dot\phi=\mu_1\dot\phi$)", tops,
                {.quantity = R"($\partial T/\partial\dot\phi$)",
                 .truth = slope_of_T(1, true),
                 .printed = momentum(R"($\mu_1\dot\phi$)", 1),
                 .near_misses = {{R"($\mu_3\dot\phi$)"}}});
  table.formula("dT_dpsi_dot", 3009, R"($\partial T/\partial\dot\psi=)" + about_axis + "$", tops,
                {.quantity = R"($\partial T/\partial\dot\psi$)",
                 .truth = slope_of_T(2, true),
                 .printed = momentum("$" + about_axis + "$", 2),
                 .near_misses = {{R"($\mu_3\dot\psi$)"}}});

  const auto expression = [](const std::string& angle) {
    return R"($\frac{d}{dt}\frac{\partial T}{\partial\dot)" + angle + R"(}-\frac{\partial T}{\partial)" +
           angle + "}$";
  };
  const auto points = [](std::size_t k) {
    return Reader{"nested dual numbers on the points' $T$", [k](const auto& s) { return s.kinetic[k]; }};
  };
  const auto rate = [](const std::string& text, std::size_t k, double sign = 1) {
    return Reader{text, [=](const auto& s) { return rate_of(s, s.a, momentum(s, k, sign)); }};
  };
  const auto rate_of_theta = [&](const std::string& sign, double factor) {
    return rate(R"($\frac{d}{dt}(\mu_1\dot\theta\sin^2\phi)" + sign + about_axis + R"(\cos\phi)$)", 0,
                factor);
  };
  table.formula("lagrange_theta", 3015,
                R"($\frac{d}{dt}(\mu_1\dot\theta\sin^2\phi+)" + about_axis +
                    R"(\cos\phi)=F_\theta$ is Lagrange's equation of $\theta$)",
                tops,
                {.quantity = expression(R"(\theta)"),
                 .truth = points(0),
                 .printed = rate_of_theta("+", 1),
                 .near_misses = {rate_of_theta("-", -1)}});
  table.formula("lagrange_phi", 3021,
                R"($\mu_1\ddot\phi-\mu_1\dot\theta^2\sin\phi\cos\phi+)" + about_axis +
                    R"(\dot\theta\sin\phi=F_\phi$ is Lagrange's equation of $\phi$)",
                tops,
                {.quantity = expression(R"(\phi)"),
                 .truth = points(1),
                 .printed = {R"($\mu_1\ddot\phi-\mu_1\dot\theta^2\sin\phi\cos\phi+)" + about_axis +
                                 R"(\dot\theta\sin\phi$)",
                             [](const auto& s) { return rate_of(s, s.a, momentum(s, 1)) - dT_dphi(s); }},
                 .near_misses = {rate(R"($\mu_1\ddot\phi$ alone)", 1)}});
  table.formula("lagrange_psi", 3029,
                R"($\frac{d}{dt}()" + about_axis + R"()=F_\psi$ is Lagrange's equation of $\psi$)", tops,
                {.quantity = expression(R"(\psi)"),
                 .truth = points(2),
                 .printed = rate(R"($\frac{d}{dt}()" + about_axis + ")$", 2),
                 .near_misses = {{R"($\mu_3\ddot\psi$)"}}});
}

// ---- the forces -------------------------------------------------------------------------------------------

void claim_forces(Table& table, const Samples& tops) {
  table.formula("dr_dtheta", 3037,
                R"($\partial\mathbf r/\partial\theta=\ell(\cos\theta\sin\phi,\sin\theta\sin\phi,0)$)", tops,
                {.quantity = R"($\partial\mathbf r/\partial\theta$)",
                 .truth = arm(0),
                 .printed = {R"($\ell(\cos\theta\sin\phi,\sin\theta\sin\phi,0)$)",
                             [](const auto& s) {
                               return values(s.l * cos(s.q[0]) * sin(s.q[1]), s.l * sin(s.q[0]) * sin(s.q[1]),
                                             0);
                             }},
                 .near_misses = {R"($\ell(\cos\theta\sin\phi,-\sin\theta\sin\phi,0)$)"}});
  table.formula("force_theta", 3039, R"($F_\theta=0$)", tops,
                {.quantity = R"(the generalized force of $\theta$, minus the slope of the points' potential)",
                 .truth = zero,
                 .printed = titled("$F_\\theta=0$", force(0)),
                 .near_misses = {titled(R"($F_\phi=0$)", force(1))}});
  const auto by_phi = [](const std::string& text, double second) {
    return Reader{text, [second](const auto& s) {
                    return values(s.l * sin(s.q[0]) * cos(s.q[1]), second * s.l * cos(s.q[0]) * cos(s.q[1]),
                                  -s.l * sin(s.q[1]));
                  }};
  };
  table.formula("dr_dphi", 3043,
                R"($\partial\mathbf r/\partial\phi=\ell(\sin\theta\cos\phi,-\cos\theta\cos\phi,-\sin\phi)$)",
                tops,
                {.quantity = R"($\partial\mathbf r/\partial\phi$)",
                 .truth = arm(1),
                 .printed = by_phi(R"($\ell(\sin\theta\cos\phi,-\cos\theta\cos\phi,-\sin\phi)$)", -1),
                 .near_misses = {R"($\ell(\sin\theta\cos\phi,\cos\theta\cos\phi,-\sin\phi)$)"}});
  table.formula("force_phi", 3045, R"($F_\phi=mg\ell\sin\phi$)", tops,
                {.quantity = R"(the generalized force of $\phi$)",
                 .truth = force(1),
                 .printed = {R"($F_\phi=mg\ell\sin\phi$)",
                             [](const auto& s) { return s.m * s.body.g * s.l * sin(s.q[1]); }},
                 .near_misses = {R"($F_\phi=-mg\ell\sin\phi$)"}});
}

void claim_no_force_of_psi(Claims& claims, const Samples& tops) {
  const auto arm_is_zero = [&](const std::string& angle, std::size_t k) {
    return compare(R"($\partial\mathbf r/\partial)" + angle + "$", none, arm(k), tops);
  };
  claims.add(
      "dr_dpsi", 3049,
      R"($F_\psi=-mg\boldsymbol\eta_3\cdot\partial\mathbf r/\partial\psi=0$, printed with $\partial\mathbf r/\partial\theta$)",
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
template <class T>
T spin_rate_by_euler(const SampleOf<T>& s, const Vector<T>& w) {
  const auto r = rotation(s.q[0], s.q[1], s.q[2]);
  const auto [J1, J2, torque] = s.body.template sum<Vector<T>>([&](Vector<T>& all, const PointOf<T>& p) {
    all[0] += p.m * (p.x[1] * p.x[1] + p.x[2] * p.x[2]);
    all[1] += p.m * (p.x[0] * p.x[0] + p.x[2] * p.x[2]);
    all[2] -= p.m * s.body.g * (r[2][1] * p.x[0] - r[2][0] * p.x[1]);
  });
  return ((J1 - J2) * w[0] * w[1] + torque) / s.mu3;
}

/// The middle equation's right side, with factors of its last and of its first term.
template <class T>
T tilting(const SampleOf<T>& s, double turning, double weight) {
  const T c = spin_of(s), sine = sin(s.q[1]);
  return weight * s.m * s.body.g * s.l / s.mu1 * sine + s.v[0] * s.v[0] * sine * cos(s.q[1]) -
         turning * c * s.mu3 / s.mu1 * s.v[0] * sine;
}

const std::string by_lagrange = ", along Lagrange's accelerations";

/// Of mu1 theta' sin(phi)^2 + c mu3 cos(phi), with a factor of the last term.
Reader rate_of_vertical(double factor) {
  return {"its rate" + by_lagrange, [factor](const auto& s) {
            const auto c = spin_of(s);
            return rate_of(s, s.truth, [&](const auto& q, const auto& v) {
              return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + factor * c * s.mu3 * cos(q[1]);
            });
          }};
}

void claim_vertical_constant(Claims& claims, const Samples& tops, const Top& start) {
  const auto conserved = [&](const std::string& text, double factor) {
    return Reading{text, {compare(text, rate_of_vertical(factor), zero, tops)}};
  };
  Reading both = conserved(R"($\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi$, $c$ the constant spin)", 1);
  both.checks.push_back(along_the_motion(start));
  claims.add("vertical_constant", 3079, R"($\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi=\gamma$, a constant)",
             {.printed = both, .near_misses = {conserved(R"($\mu_1\dot\theta\sin^2\phi$ alone)", 0)}});
}

/// With these accelerations.
Samples along_lagrange(Samples tops) {
  for (Sample& s : tops) s.a = s.truth;
  return tops;
}

void claim_motion(Table& table, const Samples& tops) {
  const std::string about_axis = R"(\mu_3(\dot\psi+\dot\theta\cos\phi))";
  const auto along = [](const std::string& text, std::size_t k, double sign = 1) {
    return Reader{text, [=](const auto& s) { return rate_of(s, s.truth, momentum(s, k, sign)); }};
  };
  const auto of_theta = [&](const std::string& sign, double factor) {
    return along(R"($\frac{d}{dt}(\mu_1\dot\theta\sin^2\phi)" + sign + about_axis + R"(\cos\phi)=0$)", 0,
                 factor);
  };
  table.formula("motion_theta", 3055,
                R"($\frac{d}{dt}(\mu_1\dot\theta\sin^2\phi+)" + about_axis + R"(\cos\phi)=0$)", tops,
                {.quantity = R"(the rate of $\theta$'s momentum)" + by_lagrange,
                 .truth = zero,
                 .printed = of_theta("+", 1),
                 .near_misses = {of_theta("-", -1)}});
  const auto of_phi = [&](const std::string& sign, double factor) {
    return Reader{R"($\mu_1\ddot\phi)" + sign + R"(\mu_1\dot\theta^2\sin\phi\cos\phi+)" + about_axis +
                      R"(\dot\theta\sin\phi=mg\ell\sin\phi$)",
                  [factor](const auto& s) {
                    return rate_of(s, s.truth, momentum(s, 1)) - dT_dphi(s) +
                           factor * s.mu1 * s.v[0] * s.v[0] * sin(s.q[1]) * cos(s.q[1]);
                  }};
  };
  table.formula(
      "motion_phi", 3061,
      R"($\mu_1\ddot\phi-\mu_1\dot\theta^2\sin\phi\cos\phi+)" + about_axis +
          R"(\dot\theta\sin\phi=mg\ell\sin\phi$)",
      tops,
      {.quantity = R"(the terms of the angles' rates)" + by_lagrange,
       .truth = {R"($mg\ell\sin\phi$)", [](const auto& s) { return s.m * s.body.g * s.l * sin(s.q[1]); }},
       .printed = of_phi("-", 0),
       .near_misses = {of_phi("+", 2)}});
  table.formula("motion_psi", 3069, R"($\frac{d}{dt}()" + about_axis + ")=0$", tops,
                {.quantity = R"(the rate of $\psi$'s momentum)" + by_lagrange,
                 .truth = zero,
                 .printed = along(R"($\frac{d}{dt}()" + about_axis + ")=0$", 2),
                 .near_misses = {{R"($\frac{d}{dt}(\mu_3\dot\psi)=0$)"}}});
  table.formula(
      "spin_constant", 3075,
      R"($\frac{d}{dt}(\dot\psi+\dot\theta\cos\phi)=0$, so that $\dot\psi+\dot\theta\cos\phi=c$, a constant)",
      tops,
      {.quantity = "its rate" + by_lagrange,
       .truth = zero,
       .printed = {R"($\frac{d}{dt}(\dot\psi+\dot\theta\cos\phi)$)",
                   [](const auto& s) { return rate_of(s, s.truth, spin); }},
       .near_misses = {{R"($\frac{d}{dt}(\dot\psi-\dot\theta\cos\phi)$)"}}});
  const auto constants = [](const std::string& text, auto first) {
    return Reader{text, [first](const auto& s) {
                    return values(first(s), momentum(s, 0)(s.q, s.v), rate_of(s, s.truth, spin));
                  }};
  };
  table.formula(
      "as_by_euler", 3081, "the constants $c$ and $\\gamma$ are those of the Eulerian approach", tops,
      {.quantity = R"($(c,\gamma,\dot c)$)",
       .truth = {R"($w_3$, the vertical part of $RJ\mathbf w$, and $\dot w_3$ of Euler's equations)",
                 [](const auto& s) {
                   const auto r = rotation(s.q[0], s.q[1], s.q[2]);
                   const auto w = s.body_rates();
                   return values(w[2], s.mu1 * (r[2][0] * w[0] + r[2][1] * w[1]) + s.mu3 * r[2][2] * w[2],
                                 spin_rate_by_euler(s, w));
                 }},
       .printed = constants(
           R"($c=\dot\psi+\dot\theta\cos\phi$, $\gamma=\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi$)",
           [](const auto& s) { return spin_of(s); }),
       .near_misses = {constants(R"(with $c=\dot\psi$)", [](const auto& s) { return s.v[2]; })}});
  const Reader lagrange{"nested dual numbers on the points' $T-V$", [](const auto& s) { return s.truth[1]; }};
  const auto middle = [](const std::string& sign, double factor) {
    return Reader{R"($\ddot\phi=\alpha\sin\phi+\dot\theta^2\sin\phi\cos\phi)" + sign +
                      R"(\frac{c\mu_3}{\mu_1}\dot\theta\sin\phi$)",
                  [factor](const auto& s) { return tilting(s, factor, 1); }};
  };
  table.formula(
      "middle_equation", 3083,
      R"($\ddot\phi=\alpha\sin\phi+\dot\theta^2\sin\phi\cos\phi-\frac{c\mu_3}{\mu_1}\dot\theta\sin\phi$ by the middle equation)",
      tops,
      {.quantity = R"($\ddot\phi$)",
       .truth = lagrange,
       .printed = middle("-", 1),
       .near_misses = {middle("+", -1)}});
  table.formula("alpha", 3087,
                R"($\alpha=mg\ell/\mu_1$, so that $\alpha\sin\phi=\frac{mg\ell}{\mu_1}\sin\phi$)", tops,
                {.quantity = R"($\alpha\sin\phi$)",
                 .truth = {R"($\ddot\phi$ by nested dual numbers on the points' $T-V$, less its other terms)",
                           [](const auto& s) { return s.truth[1] - tilting(s, 1, 0); }},
                 .printed = {R"($\frac{mg\ell}{\mu_1}\sin\phi$)",
                             [](const auto& s) { return s.m * s.body.g * s.l / s.mu1 * sin(s.q[1]); }},
                 .near_misses = {R"($\frac{mg\ell}{\mu_3}\sin\phi$)"}});
}

// ---- proofs -----------------------------------------------------------------------------------------------

const std::string any_top = "it holds of any top of rings of points";

/// Four points around the axis.
Sample example() {
  Sample s;
  s.body = {{{1, {1, 0, 1}}, {1, {0, 1, 1}}, {1, {-1, 0, 1}}, {1, {0, -1, 1}}}, 10, 0, 0};
  s.q = {0.5, 1, 0.25}, s.v = {1, 2, 3}, s.a = s.truth = {}, s.t = 0;
  s.m = 4, s.l = 1, s.mu1 = 6, s.mu3 = 4;
  return s;
}

ForAll<SampleOf> all_tops() {
  const std::vector<std::string> names{"theta", "phi", "psi", "dtheta", "dphi",    "dpsi",  "mass",
                                       "ell",   "mu1", "mu3", "g",      "ddtheta", "ddphi", "ddpsi"};
  SampleOf<Shortened> any;
  std::size_t i = 0;
  for (Vector<Shortened>* three : {&any.q, &any.v})
    for (Shortened& x : *three) x = Shortened::letter(names[i++]);
  for (Shortened* x : {&any.m, &any.l, &any.mu1, &any.mu3, &any.body.g}) *x = Shortened::letter(names[i++]);
  for (Shortened& x : any.a) x = Shortened::letter(names[i++]);
  any.truth = any.a;
  any.kinetic = any.left_side(any.a, false);
  return {.any = any,
          .letters = "(l : list (nat * R * R * R * R)) " + quantified(names),
          .given = {{"top l mass ell mu1 mu3"},
                    above(any.m.expression(), 0),
                    above(any.mu1.expression(), 0),
                    above(any.mu3.expression(), 0)},
          .tactic = by_points({"theta", "phi", "psi"}),
          .says = any_top,
          .example = example()};
}

/// How what is said of the motion follows from Lagrange's equations of theta, phi and psi: times what.
const std::map<std::string, std::array<std::string, 3>> from_equations{
    {"3.33-motion_theta", {"1", "", ""}},
    {"3.33-motion_phi", {"", "1", ""}},
    {"3.33-motion_psi", {"", "", "1"}},
    {"3.33-spin_constant", {"", "", "1 / (2 * A)"}},
    {"3.33-vertical_constant", {"1", "", "- cos phi"}},
    {"3.33-as_by_euler", {"", "", "1 / (2 * A)"}},
    {"3.33-middle_equation", {"", "- 1 / (A + C)", ""}},
    {"3.33-alpha", {"", "- 1 / (A + C)", ""}}};

void follow_from_equations(Provable& p, const SampleOf<Shortened>& any) {
  Lemma& lemma = p.lemmas.front();
  const auto left = any.left_side(any.truth, true);
  std::vector<std::string> factors;
  for (std::size_t k = 0; k < 3; ++k)
    if (const std::string& factor = from_equations.at(p.claim)[k]; !factor.empty()) {
      lemma.given.push_back(left[k].expression() == 0);
      factors.push_back(factor);
    }
  lemma.tactic = by_equations_if_need_be({"theta", "phi", "psi"}, factors, 4);
  p.says = "it follows from Lagrange's equations of any top of rings of points";
}

/// Where no formula is stated, but checks.
Provable no_force_of_psi(const ForAll<SampleOf>& all) {
  const auto both = [&](const SampleOf<Shortened>& s, std::size_t k) {
    Expressions arm_and_force = arm(k).recorded(s);
    arm_and_force.push_back(force(k).recorded(s)[0]);
    return arm_and_force;
  };
  double margin = 0;
  const Sample s = example();
  const Expressions zeros(3, Expression(0.0));
  const Lemma off = off_at(arm(0).recorded(s.recorded()), zeros, arm(0).of(s), margin);
  return {"3.33-dr_dpsi",
          "as meant " + any_top + "; as printed it is off at an example",
          {{"meant", all.letters, all.given, equal(both(all.any, 2), Expressions(4, Expression(0.0))),
            all.tactic},
           off},
          margin};
}
/// In what is recorded of the potential no theta stands.
Provable no_force_of_theta(const ForAll<SampleOf>& all) {
  const Shortened V = all.any.body.potential(all.any.q, all.any.t);
  const Expression force = Expression::letter("(- Derive (fun theta => " + V.expression().coq() + ") theta)");
  return {"3.33-force_theta",
          "minus the derivative of the potential of any top of rings of points is zero",
          {{"printed", all.letters, all.given, {force == 0}, "rewrite Derive_const; ring"}}};
}
Provable vertical_constant(const ForAll<SampleOf>& all) {
  return {"3.33-vertical_constant",
          any_top,
          {{"printed", all.letters, all.given,
            equal(rate_of_vertical(1).recorded(all.any), zero.recorded(all.any)), all.tactic}}};
}

}  // namespace

Provables proofs() {
  Claims claims("3.33");
  Table table(claims);
  claim_energy(table, {});
  claim_derivatives(table, {});
  claim_forces(table, {});
  claim_motion(table, {});
  const ForAll<SampleOf> all = all_tops();
  Provables proved = table.proofs("3.33", all);
  proved.push_back(no_force_of_psi(all));
  proved.push_back(no_force_of_theta(all));
  proved.push_back(vertical_constant(all));
  for (Provable& p : proved) {
    if (from_equations.contains(p.claim)) follow_from_equations(p, all.any);
    p.preamble = tops_in_coq;
  }
  return proved;
}

std::vector<Claim> claims(double seed, const Top& start) {
  const Samples tops = random_tops(seed);
  Claims claims("3.33");
  Table table(claims);
  claim_energy(table, tops);
  claim_derivatives(table, tops);
  claim_forces(table, tops);
  claim_no_force_of_psi(claims, tops);
  claim_motion(table, along_lagrange(tops));
  claim_vertical_constant(claims, tops, start);
  return claims.in_order();
}

std::vector<Root> roots(const Top& top) {
  Top at_rest = top;
  at_rest.mu1 -= top.m * top.l * top.l;
  return {
      {"velocity for position",
       filled(
           R"(A game that takes the center of mass for one at rest, and so the moment @3 kg m$^2$ about it )"
           R"(for the @3 kg m$^2$ about the tip, has the top here nod @2 times a second, not @2.)",
           {at_rest.mu1, top.mu1, nods_a_second(at_rest), nods_a_second(top)})}};
}

}  // namespace oddity::ex03_33

namespace oddity {

Provables proofs_3_33() { return ex03_33::proofs(); }

}  // namespace oddity
