#pragma once

// The claims of exercise 3.17 about the point mass.

#include "chapters/03_rigid_body_motion/17_foucault/foucault.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "reference/text.hpp"

namespace oddity::foucault {

/// T - V of a mass m at L R(q) in axes that turn with omega k: |r' + w x r| is its speed in axes that do not.
struct Lagrangian : Given<double> {
  double m;
  template <class T>
  T operator()(const Two<T>& q, const Two<T>& v) const {
    const Axes<T> axes(q);
    const Space<T> turning{T(0.0), T(w()[1]), T(w()[2])};
    const Space<T> u = sum(axis_velocity(q, v), outer(turning, axes.R));
    return 0.5 * m * L * L * inner(u, u) + m * g * L * axes.R[2];
  }
};

/// T in the turning axes alone.
struct KineticEnergy {
  double m, L;
  template <class T>
  T operator()(const Two<T>& q, const Two<T>& v) const {
    const Space<T> u = axis_velocity(q, v);
    return 0.5 * m * L * L * inner(u, u);
  }
};

inline Pair operator-(const Pair& a, const Pair& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// d/dt dL/dv - dL/dq.
template <class L>
Pair euler_lagrange(const L& lagrangian, const Pair& q, const Pair& v, const Pair& a) {
  return rate_of_df_dv(lagrangian, q, v, a) - df_dq(lagrangian, q, v);
}

/// A pendulum anywhere in any motion.
struct Sample {
  Given<double> p;
  double m;
  Pair q, v, a;
  Space<double> free_r, free_v, free_a;  ///< a point in any motion

  explicit Sample(Random& random)
      : p{random.between(-1.5, 1.5), random.between(0.3, 3),  random.between(0.2, 2),
          random.between(1, 10),     random.between(-3, 3),   random.between(0.1, 3),
          random.magnitude(0.1, 2),  random.magnitude(0.1, 2)},
        m(random.between(0.3, 3)),
        q{p.theta, p.phi},
        v{p.theta_dot, p.phi_dot},
        a{random.magnitude(0.1, 2), random.magnitude(0.1, 2)},
        free_r(random.point()),
        free_v(random.point()),
        free_a(random.point()) {}
  /// The terms of the equations, added up, also after their division by sin phi.
  double size() const {
    const double rates = std::abs(v[0]) + std::abs(v[1]) + p.omega, size = p.L * (1 + p.L);
    const double accelerations = std::abs(a[0]) + std::abs(a[1]) + rates * rates + p.g / p.L;
    const double free = std::sqrt(3) * (1 + rates) * (1 + rates);
    return free + (1 + m) * (1 + size * accelerations) / std::abs(std::sin(q[1]));
  }
  std::string where() const {
    return "lambda = " + rounded(p.lambda, 4) + ", omega = " + rounded(p.omega, 4) +
           ", theta = " + rounded(q[0], 4) + ", phi = " + rounded(q[1], 4) +
           ", theta' = " + rounded(v[0], 4) + ", phi' = " + rounded(v[1], 4);
  }
  Axes<double> axes() const { return Axes<double>(q); }
  Space<double> w() const { return p.w(); }
  /// The book's bracket, with its sign.
  double bracket() const {
    return -std::cos(p.lambda) * std::sin(q[0]) * std::sin(q[1]) + std::sin(p.lambda) * std::cos(q[1]);
  }
  double sin_phi() const { return std::sin(q[1]); }
  double cos_phi() const { return std::cos(q[1]); }

  /// Lagrange's equations, left side less right side, at a multiple of omega.
  Pair equations(double times) const {
    Lagrangian turned{p, m};
    turned.omega *= times;
    return euler_lagrange(turned, q, v, a);
  }
  /// The same without the terms in omega^2: they are quadratic in omega, and the odd part is the linear one.
  Pair to_first_order() const {
    const Pair still = equations(0), there = equations(1), back = equations(-1);
    return {still[0] + (there[0] - back[0]) / 2, still[1] + (there[1] - back[1]) / 2};
  }
  Pair generalized_force() const { return euler_lagrange(KineticEnergy{m, p.L}, q, v, a) - to_first_order(); }
  /// The second time derivative of r(t), given in the turning axes, in axes that do not turn.
  Space<double> inertial_acceleration(double times) const {
    using Along = Dual<double>;
    using Twice = Dual<Along>;
    const double rate = times * p.omega, c = std::cos(p.lambda), s = std::sin(p.lambda);
    Space<Twice> r;
    for (std::size_t i = 0; i < 3; ++i)
      r[i] = Twice(Along(free_r[i], free_v[i]), Along(free_v[i], free_a[i]));
    const Twice angle(Along(0, rate), Along(rate, 0)), co = cos(angle), si = sin(angle);
    const Twice along = (r[1] * c - r[2] * s) * (1.0 - co);
    const Space<Twice> x{r[0] * co + (c * r[2] + s * r[1]) * si, r[1] * co - s * r[0] * si + c * along,
                         r[2] * co - c * r[0] * si - s * along};
    return {x[0].slope.slope, x[1].slope.slope, x[2].slope.slope};
  }
  /// (L R)'' by dual numbers.
  Space<double> acceleration() const {
    const auto u = axis_velocity(moving(q, v), moving(v, a));
    return {p.L * u[0].slope, p.L * u[1].slope, p.L * u[2].slope};
  }
};

using S = const Sample&;
using V = Version<Sample>;

inline Value vector(const Space<double>& a) { return {a[0], a[1], a[2]}; }

inline std::vector<Claim> geometry(double seed) {
  std::vector<Claim> all;
  const auto says = [&](const char* id, int line, const char* what, const V& printed, const V& truth,
                        const std::vector<V>& near) {
    all.push_back(formula_claim(std::string("3.17-") + id, line, what, seed, printed, truth, near));
  };
  const auto products = [](const Space<double>& P, const Space<double>& Q, const Space<double>& R) {
    return values(inner(P, P), inner(Q, Q), inner(R, R), inner(P, Q), inner(P, R), inner(Q, R));
  };
  says("axes", 2189, "P, Q and R are coordinate axes: orthonormal",
       {"P.P, Q.Q, R.R, P.Q, P.R, Q.R as printed",
        [=](S s) { return products(s.axes().P, s.axes().Q, s.axes().R); }},
       {"(1, 1, 1, 0, 0, 0)", [](S) { return values(1, 1, 1, 0, 0, 0); }},
       {{"Q with -sin phi", [=](S s) {
           auto Q = s.axes().Q;
           Q[2] = -Q[2];
           return products(s.axes().P, Q, s.axes().R);
         }}});
  const auto velocity = [](double sign) {
    return [sign](S s) {
      return vector(
          times(s.p.L, sum(times(s.v[0] * s.sin_phi(), s.axes().P), times(-sign * s.v[1], s.axes().Q))));
    };
  };
  says("velocity", 2197, "the velocity in the turning axes", {"L (theta' sin phi P - phi' Q)", velocity(1)},
       {"(L R)' by dual numbers", [](S s) { return vector(times(s.p.L, axis_velocity(s.q, s.v))); }},
       {{"+ phi' Q", velocity(-1)}});
  const auto T = [](int power) {
    return [power](S s) {
      const double mL2 = s.m * s.p.L * s.p.L;
      return values(mL2 / 2 * (s.v[0] * s.v[0] * std::pow(s.sin_phi(), power) + s.v[1] * s.v[1]));
    };
  };
  says("kinetic_energy", 2205, "T in the angles", {"m L^2/2 (theta'^2 sin^2 phi + phi'^2)", T(2)},
       {"m |(L R)'|^2/2 by dual numbers",
        [](S s) {
          return values(KineticEnergy{s.m, s.p.L}(s.q, s.v));
        }},
       {{"sin phi for sin^2 phi", T(1)}});
  const auto slopes = [](double twice) {
    return [twice](S s) {
      const double mL2 = s.m * s.p.L * s.p.L, t = s.v[0], sp = s.sin_phi();
      return values(twice * mL2 * t * t * sp * s.cos_phi(), mL2 * t * sp * sp, mL2 * s.v[1]);
    };
  };
  says("dT_dtheta", 2215, "T does not depend on theta",
       {"dual numbers",
        [](S s) {
          return values(df_dq(KineticEnergy{s.m, s.p.L}, s.q, s.v)[0]);
        }},
       {"0", [](S) { return values(0); }}, {{"of the Lagrangian on the turning Earth", [](S s) {
                                               return values(df_dq(Lagrangian{s.p, s.m}, s.q, s.v)[0]);
                                             }}});
  says("derivatives", 2217, "dT/dphi, dT/dtheta', dT/dphi'",
       {"m L^2 (theta'^2 sin phi cos phi, theta' sin^2 phi, phi')", slopes(1)},
       {"dual numbers",
        [](S s) {
          const KineticEnergy k{s.m, s.p.L};
          const Pair dv = df_dv(k, s.q, s.v);
          return values(df_dq(k, s.q, s.v)[1], dv[0], dv[1]);
        }},
       {{"dT/dphi twice that", slopes(2)}});
  const auto rates = [](double twice, int power) {
    return [=](S s) {
      const double mL2 = s.m * s.p.L * s.p.L, sp = s.sin_phi();
      return values(mL2 * (s.a[0] * std::pow(sp, power) + twice * s.v[0] * s.v[1] * sp * s.cos_phi()),
                    mL2 * s.a[1]);
    };
  };
  says("momentum_rates", 2223, "the time derivatives of dT/dtheta' and dT/dphi'",
       {"m L^2 (theta'' sin^2 phi + 2 theta' phi' sin phi cos phi, phi'')", rates(2, 2)},
       {"nested dual numbers",
        [](S s) {
          return Value(rate_of_df_dv(KineticEnergy{s.m, s.p.L}, s.q, s.v, s.a));
        }},
       {{"1 for 2", rates(1, 2)}, {"sin phi for sin^2 phi", rates(2, 1)}});
  const auto lagrange = [](double sign) {
    return [sign](S s) {
      const double mL2 = s.m * s.p.L * s.p.L, sp = s.sin_phi(), t = s.v[0];
      return values(mL2 * (s.a[0] * sp * sp + 2 * t * s.v[1] * sp * s.cos_phi()),
                    mL2 * (s.a[1] - sign * t * t * sp * s.cos_phi()));
    };
  };
  says("left_sides", 2237, "the left sides of Lagrange's equations",
       {"m L^2 (theta'' sin^2 phi + 2 theta' phi' sin phi cos phi, phi'' - theta'^2 sin phi cos phi)",
        lagrange(1)},
       {"nested dual numbers",
        [](S s) {
          return Value(euler_lagrange(KineticEnergy{s.m, s.p.L}, s.q, s.v, s.a));
        }},
       {{"+ theta'^2 sin phi cos phi", lagrange(-1)}});
  says("dR", 2257, "dR/dtheta is sin phi P, dR/dphi is -Q",
       {"(sin phi P, -Q)",
        [](S s) {
          const auto A = s.axes();
          const double sp = s.sin_phi();
          return values(sp * A.P[0], sp * A.P[1], sp * A.P[2], -A.Q[0], -A.Q[1], -A.Q[2]);
        }},
       {"dual numbers",
        [](S s) {
          const auto t = axis_velocity(s.q, Pair{1, 0}), f = axis_velocity(s.q, Pair{0, 1});
          return values(t[0], t[1], t[2], f[0], f[1], f[2]);
        }},
       {{"(P, -Q)", [](S s) {
           const auto A = s.axes();
           return values(A.P[0], A.P[1], A.P[2], -A.Q[0], -A.Q[1], -A.Q[2]);
         }}});
  return all;
}

inline std::vector<Claim> point_forces(double seed) {
  std::vector<Claim> all;
  const auto says = [&](const char* id, int line, const char* what, const V& printed, const V& truth,
                        const std::vector<V>& near) {
    all.push_back(formula_claim(std::string("3.17-") + id, line, what, seed, printed, truth, near));
  };
  const auto coriolis_term = [](double factor) {
    return [factor](S s) { return vector(times(factor, outer(s.w(), s.free_v))); };
  };
  const V exact{"r'' less the acceleration in axes that do not turn, exactly",
                [](S s) { return vector(sum(s.free_a, times(-1.0, s.inertial_acceleration(1)))); }};
  says(
      "force", 2241,
      "the turning axes add -2 w x r' to the forces (gravity and rod), to first order in omega",
      {"-2 w x r'", coriolis_term(-2)},
      {"r'' less the acceleration in axes that do not turn, its part linear in omega",
       [](S s) {
         return vector(times(0.5, sum(s.inertial_acceleration(-1), times(-1.0, s.inertial_acceleration(1)))));
       }},
      {{"+2 w x r'", coriolis_term(2)}, {"-w x r'", coriolis_term(-1)}});
  all.back().near_misses.push_back(
      {"-2 w x r' alone, to all orders in omega",
       {compare<Sample>("what the turning axes add", {"-2 w x r'", coriolis_term(-2)}, exact, seed)}});
  const auto second_difference = [](int power) {
    return [power](S s) {
      const auto at = [&](double t) {
        return sum(s.free_r, sum(times(t, s.free_v), times(t * t / 2, s.free_a)));
      };
      constexpr double Dt = 0.5;
      const auto D2r = sum(sum(at(Dt), at(-Dt)), times(-2.0, at(0)));
      return vector(times(std::pow(Dt, -power), D2r));
    };
  };
  const V in_the_axes{"r'' in the turning axes", [](S s) { return vector(s.free_a); }};
  says("second_derivative", 2243, "the acceleration",
       {"D^2 r/Dt, by differences with Dt = 1/2", second_difference(1)}, in_the_axes,
       {{"D^2 r/Dt^3", second_difference(3)}});
  all.back().meant = {
      "D^2 r/Dt^2",
      {compare<Sample>("the acceleration", {"D^2 r/Dt^2, by differences", second_difference(2)}, in_the_axes,
                       seed)}};
  all.back().says = "the force on the mass is m D^2 r/Dt";
  all.back().why =
      "The square of $Dt$ is missing, here and in lines 2263 and 2273: the acceleration is $D^2r/Dt^2$. A "
      "second difference over a single $Dt$ has the unit of a velocity, and goes to zero with $Dt$.";

  const auto with_earth = [](double west, double north) {
    return [=](S s) {
      const double c = std::cos(s.p.lambda), d = -std::sin(s.p.lambda);
      return vector(times(2 * s.p.omega, outer(Space<double>{west * c, north * c, d}, s.free_v)));
    };
  };
  const V coriolis{
      "the acceleration in axes that do not turn, its part linear in omega", [](S s) {
        return vector(times(0.5, sum(s.inertial_acceleration(1), times(-1.0, s.inertial_acceleration(-1)))));
      }};
  says("earth_rotation", 2419, "2 w x r'", {"w = omega (0, 0, -sin lambda)", with_earth(0, 0)}, coriolis,
       {{"w = omega (cos lambda i - sin lambda k), i to the west", with_earth(1, 0)}});
  all.back().meant = {"w = omega (cos lambda j - sin lambda k), j to the north",
                      {compare<Sample>("2 w x r'", {"with j", with_earth(0, 1)}, coriolis, seed)}};
  all.back().says = "w = omega [(cos lambda) - (sin lambda) k], the cosine without a direction";
  all.back().why =
      "The unit vector $\\jmath$, to the north, is lost in the text at hand, and a number less a vector is "
      "nothing. The components of line 2425 have it: $P\\cdot w=\\omega\\cos\\lambda\\cos\\theta$. Left out "
      "altogether, what falls would fall straight, and not to the east.";

  const auto force_theta = [](double sign) {
    return [sign](S s) {
      return values(s.m * s.p.L * s.sin_phi() * 2 * s.p.L * s.p.omega * s.v[1] * sign * s.bracket());
    };
  };
  says("force_theta", 2257, "the generalized force on theta",
       {"(m L sin phi) 2 L omega phi' (-cos lambda sin theta sin phi + sin lambda cos phi)", force_theta(1)},
       {"Lagrange's equations on the turning Earth, less their kinetic part, linear in omega",
        [](S s) { return values(s.generalized_force()[0]); }},
       {{"flipped sign", force_theta(-1)}});
  const auto force_phi = [](double sign, double weight) {
    return [=](S s) {
      return values(
          -s.m * s.p.L *
          (2 * s.p.L * s.p.omega * s.v[0] * s.sin_phi() * sign * s.bracket() + weight * s.p.g * s.sin_phi()));
    };
  };
  says("force_phi", 2273, "the generalized force on phi",
       {"(-m L)(2 L omega theta' sin phi (-cos lambda sin theta sin phi + sin lambda cos phi) + g sin phi)",
        force_phi(1, 1)},
       {"Lagrange's equations on the turning Earth, less their kinetic part, linear in omega",
        [](S s) { return values(s.generalized_force()[1]); }},
       {{"Coriolis force flipped", force_phi(-1, 1)}, {"gravity flipped", force_phi(1, -1)}});

  const V by_lagrange_theta{"Lagrange's equation, linear in omega, by m L^2 sin phi", [](S s) {
                              return values(s.to_first_order()[0] / (s.m * s.p.L * s.p.L * s.sin_phi()));
                            }};
  const V by_lagrange_phi{"Lagrange's equation, linear in omega, by m L^2",
                          [](S s) { return values(s.to_first_order()[1] / (s.m * s.p.L * s.p.L)); }};
  const auto equation_theta = [](double sign) {
    return [sign](S s) {
      return values(s.a[0] * s.sin_phi() + 2 * s.v[0] * s.v[1] * s.cos_phi() -
                    sign * 2 * s.p.omega * s.v[1] * s.bracket());
    };
  };
  says("equation_theta", 2279, "the first equation of motion, left side less right side",
       {"theta'' sin phi + 2 theta' phi' cos phi - 2 omega phi' (...)", equation_theta(1)}, by_lagrange_theta,
       {{"+ 2 omega phi' (...)", equation_theta(-1)}});
  // Every fourth motion at the lowest point, if asked for; theta'' by the equation before, where it says one.
  const auto cancelled = [seed](const std::string& text, bool lowest_too, int power) {
    Random random(seed);
    long violations = 0;
    for (int i = 0; i < 200; ++i) {
      Sample s(random);
      const double rounded_off = 1e-10 * s.size();
      if (lowest_too && i % 4 == 0) s.q[1] = 0;
      const double sine = s.sin_phi(), inertia = s.m * s.p.L * s.p.L * sine * sine;
      if (sine != 0) s.a[0] -= s.to_first_order()[0] / inertia;
      const bool before = std::abs(s.to_first_order()[0]) < rounded_off;
      const double after = s.a[0] * std::pow(sine, 2 - power) + 2 * s.v[0] * s.v[1] * s.cos_phi() -
                           2 * s.p.omega * s.v[1] * s.bracket();
      violations += before && !(std::abs(after) < rounded_off);
    }
    return Reading{
        text, {never("the equation holds, and what is left after cancelling does not", violations, 200)}};
  };
  Claim lowest{"3.17-cancelled_sine", 2277, "m L^2 sin phi can be canceled from the first equation"};
  lowest.printed = cancelled("at any phi", true, 1);
  lowest.corrected = cancelled("where sin phi is not zero", false, 1);
  lowest.near_misses = {cancelled("m L^2 sin^2 phi from the first term", false, 2)};
  lowest.why =
      "At the lowest point $\\sin\\phi=0$: the equation before says $0=0$ there, and the one that is left "
      "asks "
      "for $\\dot\\theta=\\omega\\sin\\lambda$, and has no $\\ddot\\theta$. A program that solves it for "
      "$\\ddot\\theta$ divides by zero in a pendulum that hangs at rest or swings through the middle, and "
      "needs "
      "very short steps in one that passes close by. In Cartesian coordinates the point is like any other.";
  all.push_back(lowest);
  const auto equation_phi = [](double sign, const auto& pull) {
    return [=](S s) {
      return values(s.a[1] - s.v[0] * s.v[0] * s.sin_phi() * s.cos_phi() +
                    sign * 2 * s.p.omega * s.v[0] * s.sin_phi() * s.bracket() + pull(s) * s.sin_phi());
    };
  };
  const auto product = [](S s) { return s.p.g * s.p.L; };
  const auto quotient = [](S s) { return s.p.g / s.p.L; };
  says("equation_phi", 2281, "the second equation of motion, left side less right side",
       {"phi'' - theta'^2 sin phi cos phi + 2 omega theta' sin phi (...) + g L sin phi",
        equation_phi(1, product)},
       by_lagrange_phi, {{"g/L, Coriolis force flipped", equation_phi(-1, quotient)}});
  all.back().meant = {
      "g/L for g L",
      {compare<Sample>(all.back().says, {"the same with g/L sin phi", equation_phi(1, quotient)},
                       by_lagrange_phi, seed)}};
  all.back().says = "phi'' - theta'^2 sin phi cos phi = -2 omega theta' sin phi (...) - g L sin phi";
  all.back().why =
      "$gL\\sin\\phi$ is $(g/L)\\sin\\phi$, its bar lost: the force before has $g\\sin\\phi$, and is divided "
      "by $mL^2$.";

  const auto newton = [](double turning) {
    return [turning](S s) {
      auto r = sum(s.acceleration(), times(turning, outer(s.w(), times(s.p.L, axis_velocity(s.q, s.v)))));
      r[2] -= s.p.g;
      return values(inner(r, s.axes().P) / s.p.L, -inner(r, s.axes().Q) / s.p.L);
    };
  };
  says("newton", 2283, "they are the equations of Newton's law along P and Q",
       {"both equations, left side less right side",
        [=](S s) { return values(equation_theta(1)(s)[0], equation_phi(1, quotient)(s)[0]); }},
       {"(r'' + 2 w x r' - g k).(P, -Q)/L, r'' by dual numbers", newton(2)}, {});
  all.back().near_misses.push_back(
      {"w x r' once",
       {compare<Sample>(
           "the same",
           {"both equations",
            [=](S s) { return values(equation_theta(1)(s)[0], equation_phi(1, quotient)(s)[0]); }},
           {"(r'' + w x r' - g k).(P, -Q)/L", newton(1)}, seed)}});
  return all;
}

}  // namespace oddity::foucault
