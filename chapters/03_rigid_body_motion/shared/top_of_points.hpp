#pragma once

// A top made of point masses: energies, forces and equations of motion from the points' positions alone,
// by dual numbers. Rings of equally spaced points about the third body axis, the tip at the body's origin.

#include <algorithm>
#include <concepts>
#include <numbers>
#include <vector>

#include "chapters/03_rigid_body_motion/33_heavy_top/models.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "chapters/03_rigid_body_motion/shared/top_proofs.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"

namespace oddity::top {

using heavy_top::Matrix, heavy_top::Vector, heavy_top::rotation;

template <class T>
struct PointOf {
  T m;
  Vector<T> x;
};

/// T and V of the points, for angles q = (theta, phi, psi), rates v and time t. Recorded without points, they
/// are those of any top made of rings.
template <class T>
struct PointsOf {
  std::vector<PointOf<T>> points;
  T g, A, lambda;

  template <class X>
  std::array<X, 3> position(const PointOf<T>& p, const Matrix<X>& r, const X& t) const {
    using std::sin;
    std::array<X, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = r[i][0] * p.x[0] + r[i][1] * p.x[1] + r[i][2] * p.x[2];
    at[0] = at[0] + A * sin(lambda * t);
    return at;
  }
  /// Sums over the points; add(all, point) adds a point's contribution to a number or an array.
  template <class X, class Add>
  X sum(const Add& add) const {
    X all{};
    if constexpr (std::same_as<T, Shortened>)
      if (points.empty()) {
        add(all, PointOf<T>{T::letter("m"), {T::letter("x"), T::letter("y"), T::letter("z")}});
        return total(all);
      }
    for (const PointOf<T>& p : points) add(all, p);
    return all;
  }
  template <class X>
  X kinetic(const std::array<X, 3>& q, const std::array<X, 3>& v, const X& t) const {
    using D = Dual<X>;
    const auto r = rotation(D(q[0], v[0]), D(q[1], v[1]), D(q[2], v[2]));
    return 0.5 * sum<X>([&](X& twice, const PointOf<T>& p) {
             for (const D& x : position(p, r, D(t, X(1.0)))) twice = twice + p.m * x.slope * x.slope;
           });
  }
  template <class X>
  X potential(const std::array<X, 3>& q, const X& t) const {
    const auto r = rotation(q[0], q[1], q[2]);
    return sum<X>([&](X& all, const PointOf<T>& p) { all = all + p.m * g * position(p, r, t)[2]; });
  }
};

/// A random top at an instant of a motion with any accelerations, away from the vertical.
template <class T>
struct SampleOf {
  PointsOf<T> body;
  Vector<T> q, v, a;
  T t;
  T m = T(0), l = T(0), mu1 = T(0), mu3 = T(0);
  Vector<T> truth;    ///< the accelerations of Lagrange's equations
  Vector<T> kinetic;  ///< d/dt dT/dv - dT/dq along the accelerations a

  SampleOf() = default;
  explicit SampleOf(Random& random, double shake = 0)
      : body{{}, random.between(1, 10), shake * random.between(0.1, 1), random.between(0.5, 4)},
        q{random.between(-3, 3), random.between(0.3, 2.8), random.between(-3, 3)},
        v(random.point(3)),
        a(random.point(3)),
        t(random.between(0, 5)) {
    for (int corners : {1, 3, 4}) {
      const double height = random.between(0.2, 1.5), mass = random.between(0.2, 1),
                   radius = corners == 1 ? 0 : random.between(0.2, 1), turned = random.between(0, 3);
      for (int i = 0; i < corners; ++i) {
        const double angle = turned + 2 * std::numbers::pi * i / corners;
        body.points.push_back({mass, {radius * std::cos(angle), radius * std::sin(angle), height}});
        m += mass;
        l += mass * height;
        mu3 += mass * radius * radius;
        mu1 += mass * (radius * radius / 2 + height * height);
      }
    }
    l /= m;
    kinetic = left_side(a, false);
    truth = lagrange_accelerations(lagrangian(), q, v, {}, t);
  }

  auto lagrangian() const {
    return [this](const auto& x, const auto& dx, const auto& s) {
      return this->body.kinetic(x, dx, s) - this->body.potential(x, s);
    };
  }
  /// d/dt df/dv - df/dq of T, or of T - V, along a motion with these accelerations.
  Vector<T> left_side(const Vector<T>& accelerations, bool with_potential) const {
    if (with_potential) return lagrange_left_side(lagrangian(), q, v, accelerations, t);
    return lagrange_left_side(
        [this](const auto& x, const auto& dx, const auto& s) { return this->body.kinetic(x, dx, s); }, q, v,
        accelerations, t);
  }

  /// R and R' of the motion.
  std::array<Matrix<T>, 2> turning() const {
    using D = Dual<T>;
    const auto r = rotation(D(q[0], v[0]), D(q[1], v[1]), D(q[2], v[2]));
    std::array<Matrix<T>, 2> both{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) both[0][i][k] = r[i][k].value, both[1][i][k] = r[i][k].slope;
    return both;
  }
  /// R^T R', which contains the angular velocity in body coordinates.
  Matrix<T> body_spin() const {
    const auto [r, rate] = turning();
    Matrix<T> w{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) w[i][j] += r[k][i] * rate[k][j];
    return w;
  }
  Vector<T> body_rates() const {
    const auto w = body_spin();
    return {w[2][1], w[0][2], w[1][0]};
  }
  /// The sample's numbers as expressions, with its accelerations.
  SampleOf<Shortened> recorded() const {
    const auto of = [](const Vector<T>& x) { return Vector<Shortened>{x[0], x[1], x[2]}; };
    SampleOf<Shortened> same;
    for (const PointOf<T>& p : body.points) same.body.points.push_back({p.m, of(p.x)});
    same.body.g = body.g, same.body.A = body.A, same.body.lambda = body.lambda;
    same.q = of(q), same.v = of(v), same.a = of(a), same.t = t;
    same.m = m, same.l = l, same.mu1 = mu1, same.mu3 = mu3, same.truth = of(truth);
    return same;
  }
  heavy_top::Top<T> top() const {
    return {{m, l, mu1, mu3, body.g, q[0], q[1], q[2], v[0], v[1], v[2]}, body.A, body.lambda};
  }

  /// Amplification of roundings by solving the equations for the accelerations.
  double conditioning() const { return 1 / (std::sin(q[1]) * std::sin(q[1])); }
  /// Size of the terms of lengths, rates, energies and forces, and of the resulting accelerations.
  double size() const {
    const double sine = std::sin(q[1]), shaken = body.A * body.lambda * (1 + body.lambda);
    const double rates = 1 + dot(v, v) + std::sqrt(dot(a, a));
    const double terms =
        1 + l + body.A + (mu1 + mu3) * rates + m * (l + 1) * (body.g + shaken + shaken * shaken);
    return terms + (terms + std::sqrt(dot(truth, truth))) / (std::min({1.0, mu1, mu3}) * sine * sine);
  }
  TypesetIn<T> typeset() const {
    using std::cos;
    const auto slope = [&](std::size_t k, const auto& f) {
      return by_angle(*this, k, [&](const auto& x, const auto& dx) {
        return f(x, dx, std::remove_cvref_t<decltype(x[0])>(t));
      });
    };
    const auto rows = [](const Matrix<T>& r) {
      std::array<T, 9> all;
      for (std::size_t i = 0; i < 9; ++i) all[i] = r[i / 3][i % 3];
      return all;
    };
    const auto [r, rate] = turning();
    const T zero(0);
    TypesetIn<T> all{{"m", m},
                     {"g", body.g},
                     {R"(\ell)", l},
                     {R"(\mu_1)", mu1},
                     {R"(\mu_3)", mu3},
                     {R"(\mathbf w)", body_rates()},
                     {"J", std::array<T, 9>{mu1, zero, zero, zero, mu1, zero, zero, zero, mu3}},
                     {"R", rows(r)},
                     {R"(\dot R)", rows(rate)},
                     {"c", v[2] + v[0] * cos(q[1])},
                     {R"(\alpha)", m * body.g * l / mu1}};
    const std::array<std::string, 3> angles{R"(\theta)", R"(\phi)", R"(\psi)"};
    for (std::size_t k = 0; k < 3; ++k) {
      all.emplace_back(angles[k], q[k]);
      all.emplace_back(R"(\dot)" + angles[k], v[k]);
      all.emplace_back(R"(\ddot)" + angles[k], a[k]);
      all.emplace_back("F_" + angles[k], -slope(k, [&](const auto& x, const auto&, const auto& time) {
                         return body.potential(x, time);
                       }));
      all.emplace_back(R"(\partial T/\partial)" + angles[k],
                       slope(k, [&](const auto& x, const auto& dx, const auto& time) {
                         return body.kinetic(x, dx, time);
                       }));
      all.emplace_back(R"(\partial\mathbf r/\partial)" + angles[k], arm(k));
    }
    return all;
  }
  /// The derivative of the points' center of mass by an angle.
  Vector<T> arm(std::size_t k) const {
    const auto x = toward(q, k);
    const auto r = rotation(x[0], x[1], x[2]);
    return body.template sum<Vector<T>>([&](Vector<T>& all, const PointOf<T>& p) {
      for (std::size_t i = 0; i < 3; ++i) {
        T along(0);
        for (std::size_t j = 0; j < 3; ++j) along = along + r[i][j].slope * p.x[j];
        all[i] += p.m * along / m;
      }
    });
  }
  std::string where() const {
    return R"($\theta,\phi,\psi$ = )" + format_significant(q[0], 4) + ", " + format_significant(q[1], 4) +
           ", " + format_significant(q[2], 4) + R"(, $\ell$ = )" + format_significant(l, 4) +
           R"(, $\mu_1$ = )" + format_significant(mu1, 4) + R"(, $\mu_3$ = )" + format_significant(mu3, 4);
  }
};

using Sample = SampleOf<double>;

/// The time derivative, along the motion with the accelerations a, of f(q, v).
template <class T, class F>
T rate_of(const SampleOf<T>& s, const Vector<T>& a, const F& f) {
  return f(moving(s.q, s.v), moving(s.v, a)).slope;
}

/// The derivative of f(q, v) by the k-th angle, or by its rate.
template <class T, class F>
T by_angle(const SampleOf<T>& s, std::size_t k, const F& f, bool rate = false) {
  return (rate ? f(still(s.q), toward(s.v, k)) : f(toward(s.q, k), still(s.v))).slope;
}

/// A hundred tops; `shake` is the tip's largest amplitude.
inline std::vector<Sample> random_tops(double seed, double shake = 0) {
  Random random(seed);
  std::vector<Sample> tops;
  for (int i = 0; i < 100; ++i) tops.emplace_back(random, shake);
  return tops;
}

/// Four points around the axis, at rest.
inline Sample four_points(double g, double A, double lambda) {
  Sample s;
  s.body = {{{1, {1, 0, 1}}, {1, {0, 1, 1}}, {1, {-1, 0, 1}}, {1, {0, -1, 1}}}, g, A, lambda};
  s.q = {0.5, 1, 0.25}, s.v = s.a = s.truth = {}, s.t = 0;
  s.m = 4, s.l = 1, s.mu1 = 6, s.mu3 = 4;
  return s;
}

/// A top of any rings in letters, with its tip fixed or moving, and with accelerations that are letters too.
struct AnyTop {
  SampleOf<Shortened> top;
  std::string letters;
  std::vector<Proposition> given;
};
inline AnyTop any_top(bool moving) {
  SampleOf<Shortened> any;
  std::vector<std::string> names;
  const auto letter = [&](Shortened& x, const char* name) {
    x = Shortened::letter(name), names.push_back(name);
  };
  const char* const angles[][3] = {
      {"theta", "phi", "psi"}, {"dtheta", "dphi", "dpsi"}, {"ddtheta", "ddphi", "ddpsi"}};
  for (std::size_t i = 0; i < 3; ++i) letter(any.q[i], angles[0][i]);
  for (std::size_t i = 0; i < 3; ++i) letter(any.v[i], angles[1][i]);
  letter(any.m, "mass"), letter(any.l, "ell"), letter(any.mu1, "mu1"), letter(any.mu3, "mu3");
  letter(any.body.g, "g");
  if (moving) letter(any.body.A, "A0"), letter(any.body.lambda, "lambda"), letter(any.t, "t");
  for (std::size_t i = 0; i < 3; ++i) letter(any.a[i], angles[2][i]);
  any.truth = any.a;
  std::vector<Proposition> given = positive({any.m, any.mu1, any.mu3});
  given.insert(given.begin(), {"top l mass ell mu1 mu3"});
  return {any, "(l : list (nat * R * R * R * R)) " + quantified(names), given};
}
/// Assumes Lagrange's equations of theta, phi and psi that have a factor. Returns these factors.
inline std::vector<std::string> assume_equations(Lemma& lemma, const SampleOf<Shortened>& any,
                                                 const std::array<std::string, 3>& factors) {
  const auto left = any.left_side(any.truth, true);
  std::vector<std::string> used;
  for (std::size_t k = 0; k < 3; ++k)
    if (!factors[k].empty()) {
      lemma.given.push_back(left[k].expression() == 0);
      used.push_back(factors[k]);
    }
  return used;
}

}  // namespace oddity::top
