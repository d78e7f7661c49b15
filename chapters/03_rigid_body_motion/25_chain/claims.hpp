#pragma once

// The claims of exercise 3.25. Positions are turned rods; velocities, forces and Lagrange's equations come
// from the positions alone by nested dual numbers.

#include <Eigen/Core>
#include <complex>
#include <numbers>

#include "chapters/03_rigid_body_motion/25_chain/chain.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "chapters/random.hpp"
#include "reference/text.hpp"
#include "solvers/linear.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_25 {

using chain::by_tensions;

/// The letters of a random chain of n masses.
struct Sample {
  std::vector<double> m, r, theta, omega;
  double g, h;

  explicit Sample(Random& random, int n = 3) : g(random.between(1, 10)), h(random.between(1, 5)) {
    for (int k = 0; k < n; ++k) {
      m.push_back(random.between(0.3, 3));
      r.push_back(random.between(0.3, 2));
      theta.push_back(random.between(-3, 3));
      omega.push_back(random.between(-3, 3));
    }
  }
  /// The terms of positions, velocities and energies, added up.
  double size() const {
    double mass = 0, reach = h, speed = 0;
    for (std::size_t k = 0; k < m.size(); ++k) {
      mass += m[k];
      reach += r[k];
      speed += r[k] * std::abs(omega[k]);
    }
    return reach + speed + mass * (speed * speed + g * reach);
  }
  std::string where() const {
    return "theta = (" + rounded(theta[0], 4) + ", ...), omega = (" + rounded(omega[0], 4) + ", ...)";
  }

  /// The rod k pointing down, turned by theta, as a complex number x + i y.
  std::complex<double> rod(std::size_t k) const { return std::polar(r[k], theta[k] - std::numbers::pi / 2); }
  /// (x_1, y_1, ...) in any number type.
  template <class X>
  std::vector<X> at(const std::vector<X>& q) const {
    using std::cos, std::sin;
    std::vector<X> all;
    X x(0.0), y(h);
    for (std::size_t k = 0; k < r.size(); ++k) {
      x += X(r[k]) * sin(q[k]);
      y -= X(r[k]) * cos(q[k]);
      all.push_back(x);
      all.push_back(y);
    }
    return all;
  }
  /// (x_1', y_1', ...) by dual numbers.
  template <class X>
  std::vector<X> velocities(const std::vector<X>& q, const std::vector<X>& v) const {
    std::vector<Dual<X>> moving;
    for (std::size_t k = 0; k < q.size(); ++k) moving.emplace_back(q[k], v[k]);
    std::vector<X> all;
    for (const auto& p : at(moving)) all.push_back(p.slope);
    return all;
  }
  std::vector<double> velocities() const { return velocities(theta, omega); }
  template <class X>
  X kinetic(const std::vector<X>& q, const std::vector<X>& v) const {
    X T(0.0);
    const auto u = velocities(q, v);
    for (std::size_t i = 0; i < u.size(); ++i) T += X(m[i / 2] / 2) * u[i] * u[i];
    return T;
  }
  template <class X>
  X potential(const std::vector<X>& q) const {
    X V(0.0);
    const auto p = at(q);
    for (std::size_t k = 0; k < m.size(); ++k) V += X(m[k] * g) * p[2 * k + 1];
    return V;
  }
  /// The kinetic energy as that of the centre of mass and of the masses' speeds relative to each other
  /// [Koenig].
  double kinetic_by_pairs() const {
    const auto v = velocities();
    double all = 0, px = 0, py = 0, pairs = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      all += m[i];
      px += m[i] * v[2 * i];
      py += m[i] * v[2 * i + 1];
      for (std::size_t j = 0; j < i; ++j)
        pairs += m[i] * m[j] * (std::pow(v[2 * i] - v[2 * j], 2) + std::pow(v[2 * i + 1] - v[2 * j + 1], 2));
    }
    return (px * px + py * py + pairs) / (2 * all);
  }
  /// theta'' from d/dt dL/dtheta_i' - sign dL/dtheta_i = 0, L = T - v_sign V, by nested dual numbers.
  std::vector<double> lagrange(double sign = 1, double v_sign = 1) const {
    using Along = Dual<double>;
    using Outer = Dual<Along>;
    const std::size_t n = m.size();
    const auto value = [&](std::size_t i, bool by_speed, const std::vector<double>& a, bool moving) {
      std::vector<Outer> q, v;
      for (std::size_t k = 0; k < n; ++k) {
        const double one = k == i;
        q.emplace_back(Along(theta[k], moving ? omega[k] : 0), Along(by_speed ? 0 : one));
        v.emplace_back(Along(omega[k], moving ? a[k] : 0), Along(by_speed ? one : 0));
      }
      return (kinetic(q, v) - Outer(v_sign) * potential(q)).slope;
    };
    const auto left_side = [&](std::size_t i, const std::vector<double>& a) {
      return value(i, true, a, true).slope - sign * value(i, false, a, false).value;
    };
    const auto size = static_cast<Eigen::Index>(n);
    Eigen::MatrixXd M(size, size);
    Eigen::VectorXd f(size);
    std::vector<double> a(n, 0);
    for (std::size_t i = 0; i < n; ++i) f(static_cast<Eigen::Index>(i)) = -left_side(i, a);
    for (std::size_t j = 0; j < n; ++j) {
      a[j] = 1;
      for (std::size_t i = 0; i < n; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        M(row, static_cast<Eigen::Index>(j)) = left_side(i, a) + f(row);
      }
      a[j] = 0;
    }
    const Eigen::VectorXd alpha = solve(Factorization::partial_pivot_lu, M, f).value;
    return {alpha.begin(), alpha.end()};
  }
  std::vector<double> newton() const {
    std::vector<double> alpha(m.size());
    by_tensions(m, r, g, theta, omega, alpha);
    return alpha;
  }
  /// The work of gravity on the way of the angles from zero, all in proportion.
  double work_of_gravity() const {
    const auto power = [&](double s) {
      std::vector<double> q = theta;
      for (double& x : q) x *= s;
      const auto v = velocities(q, theta);
      double sum = 0;
      for (std::size_t k = 0; k < m.size(); ++k) sum -= m[k] * g * v[2 * k + 1];
      return sum;
    };
    return gauss_legendre(power, 0, 1, 32).value;
  }
};

using S = const Sample&;

/// r_k theta_k' times the cosine or sine of theta_k.
inline double cx(S s, std::size_t k) { return s.r[k] * s.omega[k] * std::cos(s.theta[k]); }
inline double sy(S s, std::size_t k) { return s.r[k] * s.omega[k] * std::sin(s.theta[k]); }
inline double square(double x) { return x * x; }

/// The bracket of mass n in the expanded energy; turn = -1 is the text's, +1 a near miss.
inline double bracket(S s, std::size_t n, double turn = -1) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += square(s.r[i] * s.omega[i]);
    for (std::size_t j = 0; j < i; ++j)
      sum += 2 * s.r[i] * s.r[j] * s.omega[i] * s.omega[j] * std::cos(s.theta[j] + turn * s.theta[i]);
  }
  return s.m[n - 1] / 2 * sum;
}

/// Two routes to n accelerations. Solving loses what the mass matrix's condition allows.
template <class Left, class Right>
Check accelerations(const std::string& left, const std::string& right, double seed, int least, int most,
                    const Left& by_left, const Right& by_right) {
  Random random(seed);
  Worst worst("theta''", left, right);
  for (int i = 0; i < 60; ++i) {
    const int n = least + i % (most - least + 1);
    const Sample s(random, n);
    const Value expected = by_right(s);
    const double size = std::max(size_of(expected), 10.0);
    worst.see(by_left(s), expected, {1e-10 * size, "a ten-thousandth of a millionth: condition 1e4 or less"},
              size, "n = " + std::to_string(n) + ", " + s.where());
  }
  return worst.check();
}

/// The pattern's accelerations, its tail mass taken from the later of the two links, or from the earlier one.
inline std::vector<double> by_pattern(S s, bool later, double sine_sign) {
  const auto n = static_cast<Eigen::Index>(s.m.size());
  const auto mu = mass_from_here_on(s.m);
  Eigen::MatrixXd M(n, n);
  Eigen::VectorXd f(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto a = static_cast<std::size_t>(i);
    f(i) = -mu[a] * s.g * s.r[a] * std::sin(s.theta[a]);
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto b = static_cast<std::size_t>(j);
      const double weight = mu[later ? std::max(a, b) : std::min(a, b)] * s.r[a] * s.r[b];
      M(i, j) = weight * std::cos(s.theta[a] - s.theta[b]);
      f(i) -= sine_sign * weight * std::sin(s.theta[a] - s.theta[b]) * square(s.omega[b]);
    }
  }
  const Eigen::VectorXd alpha = solve(Factorization::partial_pivot_lu, M, f).value;
  return {alpha.begin(), alpha.end()};
}

inline Claim degrees_of_freedom(double seed) {
  Claim free{"3.25-three_free_variables", 2643, "of the six coordinates only three are free: the angles"};
  Random random(seed);
  long not_three = 0, not_four = 0;
  for (int i = 0; i < 100; ++i) {
    const Sample s(random);
    Eigen::MatrixXd constraints = Eigen::MatrixXd::Zero(3, 6);  // gradients of |p_k - p_(k-1)|^2
    for (int k = 0; k < 3; ++k) {
      const auto d = s.rod(static_cast<std::size_t>(k));
      constraints(k, 2 * k) = d.real();
      constraints(k, 2 * k + 1) = d.imag();
      if (k == 0) continue;
      constraints(k, 2 * k - 2) = -d.real();
      constraints(k, 2 * k - 1) = -d.imag();
    }
    const int left = 6 - rank(constraints);
    not_three += left != 3;
    not_four += left != 4;
  }
  free.printed = {"6 - rank of the rods' constraints = 3", {never("another number than 3", not_three, 100)}};
  free.near_misses = {{"four free", {never("another number than 4", not_four, 100)}}};
  return free;
}

inline std::vector<Claim> claims(double seed) {
  std::vector<Claim> all;
  using F = Version<Sample>;
  const auto says = [&](const char* id, int line, const char* what, const F& printed, const F& truth,
                        const std::vector<F>& near) -> Claim& {
    all.push_back(formula_claim(std::string("3.25-") + id, line, what, seed, printed, truth, near));
    return all.back();
  };
  const F by_pairs{"Koenig: the centre of mass, and the speeds of the masses relative to each other",
                   &Sample::kinetic_by_pairs};
  const auto sum = [](S s, double third) {
    const auto v = s.velocities();
    double T = 0;
    for (std::size_t i = 0; i < 6; ++i) T += (i < 4 ? 0.5 : third) * s.m[i / 2] * v[i] * v[i];
    return T;
  };
  says("kinetic_sum", 2629, "T is the sum of m_k (x_k'^2 + y_k'^2)/2",
       {"as stated", [=](S s) { return sum(s, 0.5); }}, by_pairs,
       {{"m3 for m3/2", [=](S s) { return sum(s, 1); }}});
  all.push_back(degrees_of_freedom(seed));
  const auto down = [](S s) { return s.rod(0) + s.rod(1) + s.rod(2); };
  const auto across = [](S s) {
    return s.r[0] * std::sin(s.theta[0]) + s.r[1] * std::sin(s.theta[1]) + s.r[2] * std::sin(s.theta[2]);
  };
  const auto drop = [](S s) {
    return s.r[0] * std::cos(s.theta[0]) + s.r[1] * std::cos(s.theta[1]) + s.r[2] * std::cos(s.theta[2]);
  };
  says("x3", 2645, "x3 = r1 sin theta1 + r2 sin theta2 + r3 sin theta3", {"as stated", across},
       {"three turned rods, by complex numbers", [=](S s) { return down(s).real(); }}, {{"cosines", drop}});
  says("y3", 2647, "y3 = h - r1 cos theta1 - r2 cos theta2 - r3 cos theta3",
       {"as stated", [=](S s) { return s.h - drop(s); }},
       {"three turned rods, by complex numbers", [=](S s) { return s.h + down(s).imag(); }},
       {{"h + ...", [=](S s) { return s.h + drop(s); }}});
  const F x_rate{"dual numbers", [](S s) { return s.velocities()[4]; }};
  const F y_rate{"dual numbers", [](S s) { return s.velocities()[5]; }};
  const auto cosines = [](S s) { return cx(s, 0) + cx(s, 1) + cx(s, 2); };
  const auto sines = [](S s) { return sy(s, 0) + sy(s, 1) + sy(s, 2); };
  says("x3_rate", 2651, "x3' = r1 theta1' cos theta1 + ... + r3 theta3' cos theta3", {"as stated", cosines},
       x_rate, {{"the opposite", [=](S s) { return -cosines(s); }}, {"sines", sines}});
  says("y3_rate", 2653, "y3' = r1 theta1' sin theta1 + ... + r3 theta3' sin theta3", {"as stated", sines},
       y_rate, {{"the opposite", [=](S s) { return -sines(s); }}, {"cosines", cosines}});
  const auto substituted = [](S s, std::size_t first_of_3) {
    double T = 0;
    for (std::size_t n = 0; n < 3; ++n) {
      double x = 0, y = 0;
      for (std::size_t k = n == 2 ? first_of_3 : 0; k <= n; ++k) {
        x += cx(s, k);
        y += sy(s, k);
      }
      T += s.m[n] / 2 * (x * x + y * y);
    }
    return T;
  };
  says("kinetic_substituted", 2657, "T with the derivatives put in",
       {"as stated", [=](S s) { return substituted(s, 0); }}, by_pairs,
       {{"the third bracket without r1", [=](S s) { return substituted(s, 1); }}});
  Claim& expanded = says(
      "kinetic_expanded", 2679, "T expanded: squares, and a cosine of each difference of angles",
      {"the second and the third bracket multiplied: the plus sign between them stands inside the second",
       [](S s) { return bracket(s, 1) + bracket(s, 2) * bracket(s, 3); }},
      by_pairs,
      {{"cos(theta_i + theta_j)", [](S s) { return bracket(s, 1, 1) + bracket(s, 2, 1) + bracket(s, 3, 1); }},
       {"no factor 2", [](S s) {
          double T = 0;
          for (std::size_t n = 1; n <= 3; ++n)
            for (std::size_t i = 0; i < n; ++i) {
              T += s.m[n - 1] / 4 * square(s.r[i] * s.omega[i]);
            }
          return T + (bracket(s, 1) + bracket(s, 2) + bracket(s, 3)) / 2;
        }}});
  expanded.meant = {
      "the three brackets added",
      {compare<Sample>(expanded.says,
                       {"the sum", [](S s) { return bracket(s, 1) + bracket(s, 2) + bracket(s, 3); }},
                       by_pairs, seed)}};
  expanded.why =
      "The plus sign that should join the second and the third term stands inside the second's parenthesis, "
      "after its last "
      "cosine: as it stands the two are multiplied. Every term of the sum is right.";
  const auto published = [](S s, const std::vector<double>& q, double y_sign) {
    const auto p = s.at(q);
    double V = 0;
    for (std::size_t k = 0; k < 3; ++k) V += -s.m[k] * s.g * (s.h - y_sign * p[2 * k + 1]);
    return V;
  };
  const auto rise = [=](S s, double y_sign) {
    return published(s, s.theta, y_sign) - published(s, {0, 0, 0}, y_sign);
  };
  says("potential", 2713, "V = -m1 g (h - y1) - m2 g (h - y2) - m3 g (h - y3)",
       {"V less V at rest, as stated", [=](S s) { return rise(s, 1); }},
       {"minus gravity's work on the way, by quadrature", [](S s) { return -s.work_of_gravity(); }},
       {{"h + y", [=](S s) { return rise(s, -1); }}, {"m3 left out", [=](S s) {
                                                        const double y3 = s.h - drop(s),
                                                                     rest = s.h - s.r[0] - s.r[1] - s.r[2];
                                                        return rise(s, 1) - s.m[2] * s.g * (y3 - rest);
                                                      }}});

  const auto newton = [](S s) { return s.newton(); };
  Claim equations{"3.25-equations", 2715,
                  "with L = T - V, d/dt dL/dtheta_i' - dL/dtheta_i = 0 for each angle"};
  const auto equation = [&](const std::string& text, double sign, double v_sign) {
    return Reading{
        text,
        {accelerations(
            "Lagrange's equations by nested dual numbers: " + text, "Newton's law with the rods' tensions",
            seed, 3, 3, [=](S s) { return s.lagrange(sign, v_sign); }, newton)}};
  };
  equations.printed = equation("L = T - V", 1, 1);
  equations.near_misses = {equation("L = T + V", 1, -1), equation("plus dL/dtheta_i", -1, 1)};
  all.push_back(equations);

  Claim pattern{"3.25-pattern", 2753, "for n masses the derivatives follow a pattern that can be coded"};
  const auto by = [&](const std::string& text, bool later, double sine_sign) {
    return Reading{
        text,
        {accelerations(
             text, "Lagrange's equations by nested dual numbers", seed, 1, 5,
             [=](S s) { return by_pattern(s, later, sine_sign); }, [](S s) { return s.lagrange(); }),
         accelerations(
             text, "Newton's law with the rods' tensions", seed, 20, 30,
             [=](S s) { return by_pattern(s, later, sine_sign); }, newton)}};
  };
  pattern.printed =
      by("sum_j mu_max(i,j) r_i r_j (cos(theta_i - theta_j) theta_j'' + sin(theta_i - theta_j) theta_j'^2) = "
         "-mu_i g r_i sin(theta_i)",
         true, 1);
  pattern.near_misses = {by("mu_min(i,j)", false, 1), by("minus the sines", true, -1)};
  all.push_back(pattern);
  return all;
}

}  // namespace oddity::ex03_25
