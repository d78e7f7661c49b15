// The claims of exercise 3.33, checked on tops made of point masses, whose energies and forces come from the
// points' positions by dual numbers.

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

// ---- sums over the points ---------------------------------------------------------------------------------

/// The derivative of the points' kinetic energy by an angle or by its rate.
Reader slope_of_T(std::size_t k, bool rate) {
  return {"the points' $T$, by dual numbers", [=](const auto& s) {
            const auto T = [&](const auto& q, const auto& v) {
              return s.body.kinetic(q, v, std::remove_cvref_t<decltype(q[0])>(s.t));
            };
            return by_angle(s, k, T, rate);
          }};
}

/// The derivative of the center of mass by an angle.
Reader arm(std::size_t k) {
  return {R"(derivative of $\sum m\mathbf x/m$ over the points, by dual numbers)",
          [k](const auto& s) { return s.arm(k); }};
}

/// The generalized force of gravity on all points.
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

// ---- shared by several formulas ---------------------------------------------------------------------------

const std::string about_axis = R"(\mu_3(\dot\psi+\dot\theta\cos\phi))",
                  spin = R"(\dot\psi+\dot\theta\cos\phi)",
                  about_vertical = R"(\mu_1\dot\theta\sin^2\phi+)" + about_axis + R"(\cos\phi)",
                  tilting = R"(\mu_1\ddot\phi-\mu_1\dot\theta^2\sin\phi\cos\phi+)" + about_axis +
                            R"(\dot\theta\sin\phi)",
                  of_zero = "a multiple of zero is zero";

/// The angular velocity in body coordinates; `second` is the angle in its second component's first term.
std::string omega(const std::string& second) {
  return R"((\dot\phi\cos\psi+\dot\theta\sin\psi\sin\phi,\ -\dot\phi\sin)" + second +
         R"(+\dot\theta\cos\psi\sin\phi,\ \dot\psi+\dot\theta\cos\phi))";
}

std::string math(const std::string& text) { return "$" + text + "$"; }
std::string rate(const std::string& text) { return R"(\frac{d}{dt}()" + text + ")"; }

// ---- the energy -------------------------------------------------------------------------------------------

void claim_energy(Table& table, const Samples& tops) {
  const auto claim = table.over(tops);
  claim("center_of_mass", 2953, R"(the center of mass is at $\mathbf r=\ell\boldsymbol\xi_3$)",
        {R"($\sum m\mathbf x/m$ over the points)",
         []<class T>(const SampleOf<T>& s) {
           return s.body.template sum<Vector<T>>([&](Vector<T>& sum, const PointOf<T>& p) {
             for (std::size_t i = 0; i < 3; ++i) sum[i] += p.m * p.x[i] / s.m;
           });
         }},
        R"($(0,0,\ell)$)", "center of mass in body coordinates");
  claim(
      "center_of_mass_at_rest", 2953,
      "the velocity of the center of mass is zero in body coordinates (our reading: its components along the "
      "body axes are)",
      {.quantity = "velocity of the center of mass in body coordinates",
       .truth = {R"($R^T\dot{\mathbf r}$, by dual numbers)",
                 [](const auto& s) {
                   const auto w = s.body_spin();
                   return values(s.l * w[0][2], s.l * w[1][2], s.l * w[2][2]);
                 }},
       .printed = "$(0,0,0)$",
       .corrected = math(omega(R"(\psi)") + R"(\times(0,0,\ell))"),
       .kind = Fault::term,
       .root = "velocity for position",
       .why =
           R"(The body coordinates of the center of mass do not change. In body coordinates a )"
           R"(velocity has components along the body axes, as the text's $\mathbf w$ has; seen from the body, )"
           R"($\mathbf w$ would be zero as well. The velocity of the center of mass has the body )"
           R"(components $\ell(w_2,-w_1,0)$: the center runs on a sphere about the tip and has the kinetic energy )"
           R"($\frac12m\ell^2(w_1^2+w_2^2)$. The final $T$ is right only because $\mu_1$ is taken about the tip, )"
           R"(which has that energy in it. With the moment about the center of mass it is wrong by just )"
           R"(this term.)"});
  claim("kinetic_energy", 2955,
        R"(the angular velocity's part of the kinetic energy is )"
        R"($T=\frac12\mathbf w^TJ\mathbf w$ (our reading: all of it, $J$ being about the tip))",
        {.quantity = R"($T$, $J$ about the tip)",
         .truth = points_T,
         .printed = R"($\frac12\mathbf w^TJ\mathbf w$)",
         .near_misses = {R"($\frac12\mathbf w^T(J-m\ell^2\mathrm{Diag}(1,1,0))\mathbf w$)"}});
  claim("inertia", 2963, R"($J=\mathrm{Diag}(\mu_1,\mu_1,\mu_3)$ in body coordinates)",
        {R"($\sum m(|\mathbf x|^2-\mathbf x\mathbf x^T)$ over the points)",
         []<class T>(const SampleOf<T>& s) {
           using Tensor = std::array<T, 9>;
           return s.body.template sum<Tensor>([](Tensor& J, const PointOf<T>& p) {
             for (std::size_t i = 0; i < 3; ++i)
               for (std::size_t k = 0; k < 3; ++k)
                 J[3 * i + k] += p.m * ((i == k ? dot(p.x, p.x) : T(0)) - p.x[i] * p.x[k]);
           });
         }},
        R"($J=\mathrm{Diag}(\mu_1,\mu_1,\mu_3)$)", "inertia tensor in body coordinates, about the tip");
  claim(
      "angular_velocity", 2967, R"($\mathbf w=)" + omega(R"(\phi)") + "$ in body coordinates",
      {.quantity = R"($\mathbf w$)",
       .truth = {R"($R^T\dot R$, by dual numbers)", [](const auto& s) { return s.body_rates(); }},
       .printed = math(R"(\mathbf w=)" + omega(R"(\phi)")),
       .meant = math(R"(\mathbf w=)" + omega(R"(\psi)")),
       .kind = Fault::formula,
       .why =
           R"(The second component begins with $-\dot\phi\sin\psi$; printed is the angle $\phi$. With it )"
           R"($w_1^2+w_2^2$ would depend on $\psi$, and the text's own last line of $T$ would not follow. With the )"
           R"(angles of $R=R_z(\theta)R_x(\phi)R_z(\psi)$, as the text's $\partial\mathbf r/\partial\theta$ has )"
           R"(them, the rates in body coordinates have the signs printed.)"});
  claim(
      "kinetic_energy_again", 2971, R"($T=\frac12\mathbf w^TJ\mathbf w$, the fraction bar lost)",
      {.quantity = "$T$",
       .truth = points_T,
       .printed = R"($12\,\mathbf w^TJ\mathbf w$)",
       .meant = R"($\frac12\mathbf w^TJ\mathbf w$)",
       .why = filled(
           R"(The fraction bar of $\tfrac12$ is lost in the text at hand; lines 2957 and 2959 have its two halves, and the )"
           R"($\mu_1/2$ of the next lines comes from it. Without the bar the top has @2 times its energy.)",
           {12 / 0.5})});
  const auto squares = [](const std::string& second) {
    return R"($T=\frac{\mu_1}2(\dot\phi\cos\psi+\dot\theta\sin\psi\sin\phi)^2+\frac{\mu_1}2(-\dot\phi\sin)" +
           second + R"(+\dot\theta\cos\psi\sin\phi)^2+\frac{\mu_3}2(\dot\psi+\dot\theta\cos\phi)^2$)";
  };
  claim("energy_by_components", 2973, squares(R"(\phi)"),
        {.quantity = "$T$",
         .truth = points_T,
         .printed = squares(R"(\phi)"),
         .meant = squares(R"(\psi)"),
         .kind = Fault::formula,
         .why = R"(Here too $\phi$ is printed for $\psi$ in the second square.)"});
  claim.equation(
      "energy_reduced", 2981,
      R"($T=\frac{\mu_1}2(\dot\phi^2+\dot\theta^2\sin^2\phi)+\frac{\mu_3}2(\dot\psi+\dot\theta\cos\phi)^2$)",
      points_T);
}

// ---- its derivatives --------------------------------------------------------------------------------------

void claim_derivatives(Table& table, const Samples& tops) {
  const auto claim = table.over(tops);
  const auto is_zero = [&](std::string_view slug, int line, const std::string& slope) {
    claim(slug, line, math(slope + "=0"),
          {.quantity = math(slope) + " by dual numbers, with the points' $T$",
           .truth = zero,
           .printed = math(slope + "=0"),
           .near_misses = {R"($\partial T/\partial\phi=0$)"},
           .changes_that_hold = of_zero});
  };
  is_zero("dT_dtheta", 2989, R"(\partial T/\partial\theta)");
  claim.equation("dT_dphi", 2993,
                 R"($\partial T/\partial\phi=\mu_1\dot\theta^2\sin\phi\cos\phi-)" + about_axis +
                     R"(\dot\theta\sin\phi$)",
                 slope_of_T(1, false));
  is_zero("dT_dpsi", 2997, R"(\partial T/\partial\psi)");
  claim.equation("dT_dtheta_dot", 3001, R"($\partial T/\partial\dot\theta=)" + about_vertical + "$",
                 slope_of_T(0, true));
  claim.equation("dT_dphi_dot", 3005, R"($\partial T/\partial\dot\phi=\mu_1\dot\phi$)", slope_of_T(1, true));
  claim.equation("dT_dpsi_dot", 3009, R"($\partial T/\partial\dot\psi=)" + about_axis + "$",
                 slope_of_T(2, true));

  const auto lagrange = [&](std::string_view slug, int line, std::size_t k, const std::string& angle,
                            const std::string& left) {
    claim(slug, line, math(left + "=F_" + angle) + " is Lagrange's equation of " + math(angle),
          {"nested dual numbers on the points' $T$", [k](const auto& s) { return s.kinetic[k]; }}, math(left),
          math(R"(\frac{d}{dt}\frac{\partial T}{\partial\dot)" + angle + R"(}-\frac{\partial T}{\partial)" +
               angle + "}"));
  };
  lagrange("lagrange_theta", 3015, 0, R"(\theta)", rate(about_vertical));
  lagrange("lagrange_phi", 3021, 1, R"(\phi)", tilting);
  lagrange("lagrange_psi", 3029, 2, R"(\psi)", rate(about_axis));
}

// ---- the forces -------------------------------------------------------------------------------------------

void claim_forces(Table& table, const Samples& tops) {
  const auto claim = table.over(tops);
  claim.equation("dr_dtheta", 3037,
                 R"($\partial\mathbf r/\partial\theta=\ell(\cos\theta\sin\phi,\sin\theta\sin\phi,0)$)",
                 arm(0));
  claim.equation("dr_dphi", 3043,
                 R"($\partial\mathbf r/\partial\phi=\ell(\sin\theta\cos\phi,-\cos\theta\cos\phi,-\sin\phi)$)",
                 arm(1));
  const auto no_force = [&](std::string_view slug, int line, std::size_t k, const std::string& angle,
                            const std::string& holding = {}) {
    const std::string force_of = "F_" + angle;
    claim(slug, line, math(force_of + "=0"),
          {.quantity = "the generalized force of " + math(angle),
           .truth = force(k),
           .printed = math(force_of + "=0"),
           .near_misses = {math(force_of + R"(=mg\ell\sin\phi)")},
           .changes_that_hold = holding});
  };
  no_force("force_theta", 3039, 0, R"(\theta)");
  claim("force_phi", 3045, R"($F_\phi=mg\ell\sin\phi$)", force(1), R"($F_\phi=mg\ell\sin\phi$)",
        R"(the generalized force of $\phi$)");
  no_force("force_psi", 3051, 2, R"(\psi)", of_zero);
  claim(
      "dr_dpsi", 3049,
      R"(all components of $\partial\mathbf r/\partial\psi$ are zero (printed: $\partial\mathbf r/\partial\theta$))",
      {.quantity = R"($\partial\mathbf r/\partial\psi$)",
       .truth = none,
       .printed = R"($\partial\mathbf r/\partial\theta=(0,0,0)$)",
       .meant = R"($\partial\mathbf r/\partial\psi=(0,0,0)$)",
       .near_misses = {R"($\partial\mathbf r/\partial\phi=(0,0,0)$)"},
       .changes_that_hold = of_zero,
       .kind = Fault::formula,
       .why = R"(Printed is $\partial\mathbf r/\partial\theta$ again, which has just been given and is not )"
              R"(zero. The zeros are those of $\partial\mathbf r/\partial\psi$: a spin about the axis moves )"
              R"(no point of it.)"});
}

// ---- the motion -------------------------------------------------------------------------------------------

/// Compares (c, gamma) of the rigid body after `duration` with their initial values, by the text's formulas.
Check along_the_motion(const Top& start) {
  constexpr double tolerance = 1e-12;
  const heavy_top::RigidBody<double> body{{start}};
  const auto run = ode::integrate<ode::Fehlberg78>(body, body.start(), 0, duration, tolerance);
  const auto [q, i, j, k, w1, w2, w3] = run.value;
  const double up1 = 2 * (i * k - q * j), up2 = 2 * (j * k + q * i), up3 = 1 - 2 * (i * i + j * j);
  const double sine = sin(start.phi), c = start.dpsi + start.dtheta * cos(start.phi);
  const double gamma = start.mu1 * start.dtheta * sine * sine + c * start.mu3 * cos(start.phi);
  return {R"($(c,\gamma)$, $\gamma=\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi$)",
          {filled("rigid body after @1 s", {duration}),
           {w3, start.mu1 * (up1 * w1 + up2 * w2) + start.mu3 * up3 * w3}},
          {"the text's formulas at the start", {c, gamma}},
          {10 * tolerance * std::abs(c), "ten tolerances of the integration"}};
}

/// Euler's third equation, with the moments and the torque of gravity summed over the points.
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

/// The vertical part of gravity's torque on the points, which is summed in body coordinates.
template <class T>
T vertical_torque(const SampleOf<T>& s) {
  const auto up = rotation(s.q[0], s.q[1], s.q[2])[2];
  const auto torque = s.body.template sum<Vector<T>>([&](Vector<T>& all, const PointOf<T>& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      all[i] += p.m * s.body.g * (up[j] * p.x[k] - up[k] * p.x[j]);
    }
  });
  return up[0] * torque[0] + up[1] * torque[1] + up[2] * torque[2];
}

const std::string by_lagrange = ", along Lagrange's accelerations";

/// `c` is the constant spin.
const std::string vertical = math(rate(R"(\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi)") + "=0");

void claim_vertical_constant(Claims& claims, const Samples& tops, const Top& start) {
  const auto conserved = [&](const std::string& text) {
    const Formula<Sample> stated = computed(Formula<Sample>{text});
    return Reading{text,
                   {compare("its rate" + by_lagrange, stated, zero, tops)},
                   is_as_typeset(compare_typeset(stated, tops))};
  };
  Reading both = conserved(vertical);
  both.checks.push_back(along_the_motion(start));
  claims.add(
      "vertical_constant", 3079, R"($\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi=\gamma$, a constant)",
      {.printed = both, .near_misses = {conserved(math(rate(R"(\mu_1\dot\theta\sin^2\phi)") + "=0"))}});
}

void claim_motion(Table& table, const Samples& tops) {
  const auto claim = table.over(tops);
  const auto constant = [&](std::string_view slug, int line, const std::string& momentum,
                            const std::string& whose, const std::string& after = {}) {
    const std::string stated = math(rate(momentum) + "=0");
    claim(slug, line, stated + after, zero, stated, whose + by_lagrange, of_zero);
  };
  constant("motion_theta", 3055, about_vertical, R"(the rate of $\theta$'s momentum)");
  const std::string of_phi = math(tilting + R"(=mg\ell\sin\phi)");
  claim("motion_phi", 3061, of_phi, zero, of_phi, "the difference of its sides" + by_lagrange);
  constant("motion_psi", 3069, about_axis, R"(the rate of $\psi$'s momentum)");
  constant("spin_constant", 3075, spin, "its rate", ", so that " + math(spin + "=c") + ", a constant");
  claim("spin_by_euler", 3077,
        R"(the constant $c$ is that of the Eulerian approach (our reading, as example 3.19 is not in the )"
        R"(solutions: the spin $w_3$))",
        {R"($w_3$, and $\dot w_3$ of Euler's equations)",
         [](const auto& s) {
           const auto w = s.body_rates();
           return values(w[2], spin_rate_by_euler(s, w));
         }},
        math("(" + spin + R"(,\ )" + rate(spin) + ")"), R"($(c,\dot c)$)");
  claim(
      "vertical_by_euler", 3081,
      R"(the constant $\gamma$ is that of the Eulerian approach (our reading: the vertical angular momentum))",
      {R"(the vertical parts of $RJ\mathbf w$ and of gravity's torque on the points)",
       [](const auto& s) {
         const auto up = rotation(s.q[0], s.q[1], s.q[2])[2];
         const auto w = s.body_rates();
         return values(s.mu1 * (up[0] * w[0] + up[1] * w[1]) + s.mu3 * up[2] * w[2], vertical_torque(s));
       }},
      math("(" + about_vertical + R"(,\ )" + rate(about_vertical) + ")"), R"($(\gamma,\dot\gamma)$)");
  const std::string middle =
      R"($\ddot\phi=\alpha\sin\phi+\dot\theta^2\sin\phi\cos\phi-\frac{c\mu_3}{\mu_1}\dot\theta\sin\phi$)";
  claim("middle_equation", 3083, middle + " by the middle equation",
        {"nested dual numbers on the points' $T-V$", [](const auto& s) { return s.truth[1]; }}, middle,
        R"($\ddot\phi$)");
}

// ---- proofs -----------------------------------------------------------------------------------------------

Sample example() {
  Sample s = four_points(10, 0, 0);
  s.v = {1, 2, 3};
  return s;
}

ForAll<SampleOf> all_tops() {
  auto [any, letters, given] = any_top(false);
  any.kinetic = any.left_side(any.a, false);
  return {.any = any,
          .letters = letters,
          .given = given,
          .tactic = by_points({"theta", "phi", "psi"}),
          .says = "it holds of any top of rings of points",
          .example = example(),
          .preamble = coq_source({"tops"})};
}

/// Factors of Lagrange's equations of theta, phi and psi whose sum is the claim.
const std::map<std::string, std::array<std::string, 3>> from_equations{
    {"3.33-motion_theta", {"1", "", ""}},
    {"3.33-motion_phi", {"", "1", ""}},
    {"3.33-motion_psi", {"", "", "1"}},
    {"3.33-spin_constant", {"", "", "1 / (2 * A)"}},
    {"3.33-vertical_constant", {"1", "", "- cos phi"}},
    {"3.33-spin_by_euler", {"", "", "1 / (2 * A)"}},
    {"3.33-vertical_by_euler", {"1", "", ""}},
    {"3.33-middle_equation", {"", "- 1 / (A + C)", ""}}};

void follow_from_equations(Provable& p, const SampleOf<Shortened>& any) {
  Lemma& lemma = p.lemmas.front();
  const auto factors = assume_equations(lemma, any, from_equations.at(p.claim));
  lemma.tactic = by_equations_if_need_be({"theta", "phi", "psi"}, factors, 4);
  p.says = "it follows from Lagrange's equations of any top of rings of points";
}

}  // namespace

Provables proofs() {
  Claims claims("3.33");
  Table table(claims);
  for (auto* part : {claim_energy, claim_derivatives, claim_forces, claim_motion}) part(table, {});
  const ForAll<SampleOf> all = all_tops();
  Provables proved = table.proofs("3.33", all);
  // The recorded potential does not contain theta.
  const std::string V = all.any.body.potential(all.any.q, all.any.t).expression().coq();
  const Expression force = Expression::letter("(- Derive (fun theta => " + V + ") theta)");
  proved.push_back({"3.33-force_theta",
                    "minus the derivative of the potential of any top of rings of points is zero",
                    {{"printed", all.letters, all.given, {force == 0}, "rewrite Derive_const; ring"}}});
  proved.push_back({"3.33-vertical_constant",
                    all.says,
                    {{"printed", all.letters, all.given,
                      equal(Reader(vertical).recorded(all.any), zero.recorded(all.any)), all.tactic}}});
  for (Provable& p : proved) {
    if (from_equations.contains(p.claim)) follow_from_equations(p, all.any);
    p.preamble = coq_source({"tops"});
  }
  return proved;
}

std::vector<Claim> claims(double seed, const Top& start) {
  const Samples tops = draw<Sample>(100, seed);
  Claims claims("3.33");
  Table table(claims);
  for (auto* part : {claim_energy, claim_derivatives, claim_forces}) part(table, tops);
  Samples moving = tops;  // by Lagrange's equations
  for (Sample& s : moving) s.a = s.truth;
  claim_motion(table, moving);
  claim_vertical_constant(claims, moving, start);
  return claims.in_order();
}

std::vector<Root> roots(const Top& top) {
  Top at_rest = top;
  at_rest.mu1 -= top.m * top.l * top.l;
  return {
      {"velocity for position",
       filled(
           R"(A game that takes the center of mass for one at rest uses the moment about it, @3 kg m$^2$, )"
           R"(for the @3 kg m$^2$ about the tip. The top here then nods @2 times a second, not @2.)",
           {at_rest.mu1, top.mu1, nods_a_second(at_rest), nods_a_second(top)})}};
}

}  // namespace oddity::ex03_33
