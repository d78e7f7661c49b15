#pragma once

// The claims of exercise 3.27.

#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "chapters/03_rigid_body_motion/27_two_bodies/two_bodies.hpp"
#include "chapters/random.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/linear.hpp"

namespace oddity::two_bodies {

/// Random bodies and a state (q, v) of q = (r, theta, phi).
struct Sample {
  double G, m1, m2;
  std::array<double, 3> q, v;

  explicit Sample(Random& random)
      : G(random.between(0.5, 2)),
        m1(random.between(0.3, 3)),
        m2(random.between(0.3, 3)),
        q{random.between(0.5, 2), random.between(-3, 3), random.between(0.4, 2.7)},
        v{random.between(-2, 2), 0, random.between(-2, 2)} {}
  /// The terms of the equations over r and theta's inertia, which is r^2 sin^2 phi.
  double size() const {
    const double r = q[0], speed = std::abs(v[0]) + r * std::abs(v[2]), sine = std::sin(q[2]);
    const double forces = speed * speed / r + gamma() / (r * r) + m1 + m2 + G * m1 * m2;
    return forces * (1 + speed) * (1 + 1 / (r * r)) / (sine * sine);
  }
  std::string where() const {
    return "m1 = " + rounded(m1, 4) + ", m2 = " + rounded(m2, 4) + ", r = " + rounded(q[0], 4) +
           ", phi' = " + rounded(v[2], 4);
  }

  double beta() const { return q[0] * q[0] * v[2]; }
  double gamma() const { return G * (m1 + m2); }

  /// Both bodies' positions, the centre of mass in the origin.
  template <class X>
  std::array<X, 6> bodies(const std::array<X, 3>& at) const {
    using std::cos, std::sin;
    const std::array<X, 3> P{at[0] * sin(at[2]) * cos(at[1]), at[0] * sin(at[2]) * sin(at[1]),
                             at[0] * cos(at[2])};
    const X a(-m2 / (m1 + m2)), b(m1 / (m1 + m2));
    return {a * P[0], a * P[1], a * P[2], b * P[0], b * P[1], b * P[2]};
  }
  template <class X>
  X kinetic(const std::array<X, 3>& at, const std::array<X, 3>& speed) const {
    std::array<Dual<X>, 3> moving;
    for (std::size_t i = 0; i < 3; ++i) moving[i] = {at[i], speed[i]};
    X T(0.0);
    const auto x = bodies(moving);
    for (std::size_t i = 0; i < 6; ++i) T += X((i < 3 ? m1 : m2) / 2) * x[i].slope * x[i].slope;
    return T;
  }
  template <class X>
  X potential(const std::array<X, 3>& at) const {
    using std::sqrt;
    const auto x = bodies(at);
    X square(0.0);
    for (std::size_t i = 0; i < 3; ++i) square += (x[i + 3] - x[i]) * (x[i + 3] - x[i]);
    return X(-G * m1 * m2) / sqrt(square);
  }
  /// d/dt dT/dv_i - d(T - V)/dq_i along a motion with the accelerations a.
  double left_side(std::size_t i, const std::array<double, 3>& a, const std::array<double, 3>& speed) const {
    using Along = Dual<double>;
    using Outer = Dual<Along>;
    std::array<Outer, 3> by_speed, with_speed, by_place, still;
    for (std::size_t k = 0; k < 3; ++k) {
      const double one = k == i;
      by_speed[k] = Outer(Along(q[k], speed[k]));
      with_speed[k] = Outer(Along(speed[k], a[k]), Along(one));
      by_place[k] = Outer(Along(q[k]), Along(one));
      still[k] = Outer(Along(speed[k]));
    }
    return kinetic(by_speed, with_speed).slope.slope -
           (kinetic(by_place, still) - potential(by_place)).slope.value;
  }
  /// (r'', theta'', phi'') by Lagrange's equations, nested dual numbers.
  std::array<double, 3> lagrange(const std::array<double, 3>& speed) const {
    Eigen::MatrixXd M(3, 3);
    Eigen::VectorXd f(3);
    for (int i = 0; i < 3; ++i) f(i) = -left_side(static_cast<std::size_t>(i), {0, 0, 0}, speed);
    for (int j = 0; j < 3; ++j) {
      std::array<double, 3> a{0, 0, 0};
      a[static_cast<std::size_t>(j)] = 1;
      for (int i = 0; i < 3; ++i) M(i, j) = left_side(static_cast<std::size_t>(i), a, speed) + f(i);
    }
    const Eigen::VectorXd a = solve(Factorization::partial_pivot_lu, M, f).value;
    return {a(0), a(1), a(2)};
  }
  std::array<double, 3> lagrange() const { return lagrange(v); }
};

using S = const Sample&;

/// r^2 phi' after a while, both bodies moved in Cartesian coordinates, for starts like the default one.
template <class Published>
Check later(const std::string& quantity, const std::string& as, double seed, const Published& published,
            bool state) {
  Random random(seed);
  Worst worst(quantity, as, "both bodies in Cartesian coordinates, Fehlberg 7(8)");
  for (int i = 0; i < 20; ++i) {
    const Bodies b{random.between(0.5, 2),  random.between(0.5, 2), random.between(0.5, 2),
                   random.between(1, 2),    random.between(-1, 1),  random.between(-3, 3),
                   random.between(0.5, 1.5)};
    const BothBodies<double> model{b};
    const auto x = ode::integrate<ode::Fehlberg78>(model, model.start(), 0, 1, 1e-13).value;
    const double dx = x[2] - x[0], dy = x[3] - x[1], vx = x[6] - x[4], vy = x[7] - x[5];
    const double r = std::hypot(dx, dy);
    const Value seen = state ? Value{dx, dy, (dx * vx + dy * vy) / r} : Value{dx * vy - dy * vx};
    worst.see(published(b), seen, {1e-10, "a thousand tolerances of the integration"}, 1,
              "m1 = " + rounded(b.m1, 4) + ", m2 = " + rounded(b.m2, 4) + ", r0 = " + rounded(b.r0, 4));
  }
  return worst.check();
}

/// (x, y, u) at t = 1 by the published system with other letters, or with its bars over r^2 lost.
inline Value by_system(const Bodies& b, double beta, double gamma, bool bars = true) {
  const auto rhs = [=](const std::array<double, 3>& x, std::array<double, 3>& dxdt, double) {
    const double square = x[0] * x[0], over = bars ? 1 / square : square;
    dxdt = {x[1], beta * beta / (square * x[0]) - gamma * over, beta * over};
  };
  const auto x = ode::integrate<ode::Fehlberg78>(rhs, std::array{b.r0, b.r0_dot, b.phi0}, 0, 1, 1e-13).value;
  return {x[0] * std::cos(x[2]), x[0] * std::sin(x[2]), x[1]};
}

/// The second body seen from the first after a second, in space: placed by the published system on the
/// meridian theta, against Cartesian coordinates. It starts on the meridian theta0 and passes the pole.
template <class Theta, class Phi>
Reading in_space(const std::string& text, double seed, const Theta& theta, const Phi& phi) {
  Random random(seed);
  Worst worst("(x, y, z) at t = 1", text, "the relative motion in Cartesian coordinates, Fehlberg 7(8)");
  for (int i = 0; i < 20; ++i) {
    const Bodies b{random.between(0.5, 2),    random.between(0.5, 2), random.between(0.5, 2),
                   random.between(1, 2),      random.between(-1, 1),  random.between(0.1, 0.3),
                   random.between(-1.5, -0.5)};
    const double theta0 = random.between(0.5, 2.5), gamma = b.G * (b.m1 + b.m2);
    const double c = std::cos(b.phi0), s = std::sin(b.phi0), across = b.r0_dot * s + b.r0 * b.phi0_dot * c;
    const std::array start{
        b.r0 * s * std::cos(theta0), b.r0 * s * std::sin(theta0), b.r0 * c,
        across * std::cos(theta0),   across * std::sin(theta0),   b.r0_dot * c - b.r0 * b.phi0_dot * s};
    const auto rhs = [=](const std::array<double, 6>& x, std::array<double, 6>& dxdt, double) {
      const double r = std::hypot(x[0], x[1], x[2]), pull = -gamma / (r * r * r);
      dxdt = {x[3], x[4], x[5], pull * x[0], pull * x[1], pull * x[2]};
    };
    const auto x = ode::integrate<ode::Fehlberg78>(rhs, start, 0, 1, 1e-13).value;
    const Value flat = by_system(b, b.r0 * b.r0 * b.phi0_dot, gamma);
    const double from_axis = phi(flat[1]), meridian = theta(theta0);
    worst.see({from_axis * std::cos(meridian), from_axis * std::sin(meridian), flat[0]}, {x[0], x[1], x[2]},
              {1e-10, "a thousand tolerances of the integration"}, 1,
              "theta0 = " + rounded(theta0, 4) + ", phi0 = " + rounded(b.phi0, 4));
  }
  return {text, {worst.check()}};
}

inline Claim initial_conditions(double seed) {
  const auto as_it_is = [](double x) { return x; };
  const auto none = [](double) { return 0.0; };
  Claim claim{"3.27-initial_conditions", 2787, "the initial conditions are r0, r0', phi0 and phi0'"};
  claim.printed = in_space("these four, theta being nowhere set", seed, none, as_it_is);
  claim.meant = in_space("these four and theta0", seed, as_it_is, as_it_is);
  claim.near_misses = {in_space(
      "these four and -theta0", seed, [](double x) { return -x; }, as_it_is)};
  claim.why =
      "The list lacks $\\theta_0$, which the first line says has to be specified. The motion in its plane "
      "does "
      "not need it, the place in space does: without it every orbit lies on the meridian $\\theta=0$, for "
      "$\\theta_0=\\pi/2$ turned by 90 degrees out of its plane.";
  return claim;
}

inline Claim freedoms(double seed) {
  Claim three{"3.27-three_degrees", 2755, "r, theta and phi are the three degrees of freedom"};
  Random random(seed);
  long not_three = 0, not_two = 0;
  for (int i = 0; i < 100; ++i) {
    const Sample s(random);
    Eigen::MatrixXd by(6, 3);
    for (int j = 0; j < 3; ++j) {
      std::array<Dual<double>, 3> q;
      for (std::size_t k = 0; k < 3; ++k) q[k] = {s.q[k], k == static_cast<std::size_t>(j) ? 1.0 : 0.0};
      const auto x = s.bodies(q);
      for (int k = 0; k < 6; ++k) by(k, j) = x[static_cast<std::size_t>(k)].slope;
    }
    not_three += rank(by) != 3;
    not_two += rank(by) != 2;
  }
  three.printed = {"the positions move in three independent ways",
                   {never("another rank than 3", not_three, 100)}};
  three.near_misses = {{"in two", {never("another rank than 2", not_two, 100)}}};
  return three;
}

inline std::vector<Claim> claims(double seed) {
  std::vector<Claim> all{freedoms(seed)};
  using F = Version<Sample>;
  const auto says = [&](const char* id, int line, const char* what, const F& printed, const F& truth,
                        const std::vector<F>& near) {
    all.push_back(formula_claim(std::string("3.27-") + id, line, what, seed, printed, truth, near));
  };
  const std::string by_lagrange = "Lagrange's equations of both bodies by nested dual numbers";
  // The text's "theta_0 = 0" has lost its overdot: theta counts round the pole, and the plane is any
  // meridian.
  Claim constant{"3.27-theta_constant", 2755, "with theta' = 0 at the start theta keeps its value"};
  const auto turning = [](S s, double rate) { return s.lagrange({s.v[0], rate, s.v[2]})[1]; };
  const auto stays = [&](const std::string& text, double rate) {
    return compare<Sample>("theta''", {text + ": " + by_lagrange, [=](S s) { return turning(s, rate); }},
                           {"zero", [](S) { return 0.0; }}, seed);
  };
  constant.printed = {"theta'' = 0 where theta' = 0", {stays("theta' = 0", 0)}};
  const auto as_it_is = [](double x) { return x; };
  constant.printed.checks.push_back(
      in_space("theta = theta0 also beyond the pole, phi running on below 0", seed, as_it_is, as_it_is)
          .checks[0]);
  constant.near_misses = {
      {"theta'' = 0 also where theta' = 1", {stays("theta' = 1", 1)}},
      in_space("phi kept between 0 and pi", seed, as_it_is, [](double x) { return std::abs(x); })};
  all.push_back(constant);

  const auto radial = [](S s, double power_sign, double gamma) {
    return s.beta() * s.beta() / std::pow(s.q[0], 3) - power_sign * gamma / (s.q[0] * s.q[0]);
  };
  says("radial_equation", 2757, "r'' = beta^2/r^3 - gamma/r^2",
       {"as stated", [=](S s) { return radial(s, 1, s.gamma()); }},
       {by_lagrange, [](S s) { return s.lagrange()[0]; }},
       {{"plus gamma/r^2", [=](S s) { return radial(s, -1, s.gamma()); }},
        {"beta/r^3", [=](S s) { return s.beta() / std::pow(s.q[0], 3) - s.gamma() / (s.q[0] * s.q[0]); }}});
  Claim beta{"3.27-beta", 2765, "beta = r0^2 phi0', and r^2 phi' keeps this value"};
  beta.printed = {"r0^2 phi0'",
                  {later(
                      "r^2 phi' at t = 1", "r0^2 phi0'", seed,
                      [](const Bodies& b) { return Value(b.r0 * b.r0 * b.phi0_dot); }, false)}};
  beta.near_misses = {{"r0 phi0'",
                       {later(
                           "r^2 phi' at t = 1", "r0 phi0'", seed,
                           [](const Bodies& b) { return Value(b.r0 * b.phi0_dot); }, false)}}};
  all.push_back(beta);
  const auto c1 = [](S s) {
    const auto along = [&](const auto& x) {
      using X = std::decay_t<decltype(x)>;
      return s.kinetic<X>({X(s.q[0]), X(s.q[1]), X(s.q[2])}, {x, X(0.0), X(s.v[2])});
    };
    return second_derivative(along, s.v[0]);
  };
  const auto c2 = [](S s) { return -s.potential(s.q) * s.q[0]; };
  says("gamma_constants", 2767, "c1 = m1 m2/(m1 + m2), the reduced mass, and c2 = G m1 m2",
       {"as stated", [](S s) { return values(s.m1 * s.m2 / (s.m1 + s.m2), s.G * s.m1 * s.m2); }},
       {"d^2T/dr'^2 and -r V by dual numbers", [=](S s) { return values(c1(s), c2(s)); }},
       {{"c1 = m1 + m2", [](S s) { return values(s.m1 + s.m2, s.G * s.m1 * s.m2); }}});
  says("gamma", 2769, "gamma = c2/c1 = G (m1 + m2)", {"as stated", [](S s) { return s.gamma(); }},
       {"the ratio by dual numbers", [=](S s) { return c2(s) / c1(s); }},
       {{"G m1 m2 (m1 + m2)", [](S s) { return s.gamma() * s.m1 * s.m2; }},
        {"G m1", [](S s) { return s.G * s.m1; }}});
  Claim angle{"3.27-phi_equation", 2773, "phi' = beta/r^2"};
  const auto dbeta = [](S s, double power) {
    return -power * s.beta() / std::pow(s.q[0], power + 1) * s.v[0];
  };
  const auto phi_rate = [&](const std::string& text, double power) {
    return Reading{text,
                   {compare<Sample>(
                       "phi''", {text + ", differentiated with r' = u", [=](S s) { return dbeta(s, power); }},
                       {by_lagrange, [](S s) { return s.lagrange()[2]; }}, seed)}};
  };
  angle.printed = phi_rate("beta/r^2", 2);
  angle.near_misses = {phi_rate("beta/r", 1), phi_rate("beta/r^3", 3)};
  all.push_back(angle);

  Claim system{"3.27-first_order_system", 2779,
               "r' = u, u' = beta^2/r^3 - gamma r^2, phi' = beta r^2 from (r0, r0', phi0) is the motion"};
  const auto moved = [&](const std::string& text, const auto& beta_of, const auto& gamma_of,
                         bool bars = true) {
    return Reading{text,
                   {later(
                       "(x, y, u) at t = 1", text, seed,
                       [=](const Bodies& b) { return by_system(b, beta_of(b), gamma_of(b), bars); }, true)}};
  };
  const auto right_beta = [](const Bodies& b) { return b.r0 * b.r0 * b.phi0_dot; };
  const auto right_gamma = [](const Bodies& b) { return b.G * (b.m1 + b.m2); };
  system.printed = moved("u' = beta^2/r^3 - gamma r^2, phi' = beta r^2", right_beta, right_gamma, false);
  system.meant = moved("u' = beta^2/r^3 - gamma/r^2, phi' = beta/r^2", right_beta, right_gamma);
  system.why =
      "The bars over $r^2$ are lost in lines 2783 and 2785, where the text at hand reads $\\gamma r^2$ and "
      "$\\beta r^2$. The equations of lines 2757 and 2773, which are written as a system here, have them.";
  system.near_misses = {
      moved("gamma = G m1", right_beta, [](const Bodies& b) { return b.G * b.m1; }),
      moved(
          "beta = r0 phi0'", [](const Bodies& b) { return b.r0 * b.phi0_dot; }, right_gamma)};
  all.push_back(system);
  all.push_back(initial_conditions(seed));
  return all;
}

}  // namespace oddity::two_bodies
