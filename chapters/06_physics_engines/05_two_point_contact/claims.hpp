#pragma once

#include "chapters/06_physics_engines/05_two_point_contact/contact.hpp"
#include "chapters/exercise.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

/// The displayed lines of the two-point contact, on random bodies.
namespace oddity::contact {

struct Sample {
  Body body;
  Hit hit;
  Vector3d normal;
  double f;

  Vector3d arm(const Vector3d& p) const { return p - body.center; }
  /// The size of v and w, of the impulse's part of them and of the arms.
  double scale() const { return body.v.norm() + body.w.norm() + kick() + twist(); }
  /// What the impulse does to v, and at most to w.
  double kick() const { return std::abs(f) / body.mass; }
  double twist() const { return yielding() * angular_impulse(); }
  double angular_impulse() const { return std::abs(f) * std::max(arm(hit.p0).norm(), arm(hit.p1).norm()); }
  /// The size of J^-1.
  double yielding() const { return inverse(body.inertia).cwiseAbs().sum(); }
};

template <class MakeBody>
std::vector<Sample> samples(double seed, int count, const MakeBody& make_body) {
  Random random(seed);
  std::vector<Sample> all;
  for (int n = 0; n < count; ++n) {
    const Body body = make_body(random);
    const Vector3d normal = vector(random.direction());
    const double f = random.magnitude(0.1, 3);
    all.push_back({body, {vector(random.point(2)), vector(random.point(2)), f * normal}, normal, f});
  }
  return all;
}

template <class Left, class Right>
Check compare(const std::vector<Sample>& all, std::string what, const std::string& by_left,
              const std::string& by_right, const Left& left, const Right& right) {
  Worst worst(std::move(what) + ", " + by_left + " against " + by_right, by_left, by_right);
  for (const Sample& s : all) worst.see(Value(left(s)), Value(right(s)), s.scale(), "f = " + rounded(s.f, 6));
  return worst.check();
}

// ---- the delta function -----------------------------------------------------------------------------------

constexpr double width = 1e-3;

/// The mean of g over a cube of half side `width` about p, by Gauss-Legendre: a delta function in the making.
template <class G>
double near_point(const G& g, const Vector3d& p) {
  const Rule rule = [](FunctionOfOne f, double a, double b) { return gauss_legendre(f, a, b, 2); };
  const auto low = [](double y) { return [y](double) { return y - width; }; };
  const auto high = [](double y) { return [y](double) { return y + width; }; };
  const double volume = 8 * width * width * width;
  const auto integral = nested(
      rule, [&](double x, double y, double z) { return g(Vector3d(x, y, z)); }, p[0] - width, p[0] + width,
      low(p[1]), high(p[1]), [&](double, double) { return p[2] - width; },
      [&](double, double) { return p[2] + width; });
  return integral.value / volume;
}

/// The integral of g with `weight` of a delta function at either point.
template <class G>
double sifted(const G& g, const Hit& hit, double weight = 0.5) {
  return weight * near_point(g, hit.p0) + weight * near_point(g, hit.p1);
}

inline double smooth(const Vector3d& x) { return std::exp(0.5 * x[0]) * std::cos(x[1]) + x[2] * x[2] * x[0]; }

inline Check property(const std::vector<Sample>& all, double weight, bool at_midpoint) {
  Worst worst("integral of G(X) delta(X, S)", "narrow cubes about both points, weight " + shortest(weight),
              at_midpoint ? "G(M)" : "(G(P0) + G(P1))/2");
  for (const Sample& s : all) {
    const double right =
        at_midpoint ? smooth((s.hit.p0 + s.hit.p1) / 2) : (smooth(s.hit.p0) + smooth(s.hit.p1)) / 2;
    worst.see(
        sifted(smooth, s.hit, weight), right,
        {width * width, "the cube's half side squared times a sixth of G's Laplacian, which is below 6"}, 3,
        "P0 = (" + rounded(s.hit.p0[0], 4) + ", ...)");
  }
  return worst.check();
}

inline Claim delta(const std::vector<Sample>& all) {
  return {"6.5-delta",
          3743,
          "the average of two delta functions gives the average of G at the two points",
          {"(G(P0) + G(P1))/2", {property(all, 0.5, false)}},
          {},
          {},
          {{"their sum", {property(all, 1, false)}}, {"G at the midpoint", {property(all, 0.5, true)}}}};
}

// ---- the velocities ---------------------------------------------------------------------------------------

constexpr double pulse = 1e-6;

/// What a pulse shared evenly by the two points, moving with the body, does to v (from 0) or to w (from 3).
inline Vector3d by_motion(const Sample& s, std::size_t from, double first = 0.5) {
  Hit hit = s.hit;
  hit.first = first;
  const auto after = after_pulse(s.body, hit, pulse).value;
  return {after[from], after[from + 1], after[from + 2]};
}

/// What the pulse's 128 steps leave out of its integral, by the first term of Simpson's error at the half
/// steps: 630 t^4 (1 - t)^4 has the fifth derivatives -+302400 at its ends.
inline constexpr double steps_leave = 604800 / 1512.0 * 0x1p-48;

/// A pulse turns no velocity: what differs is its integral, and the narrow cubes' rounded bounds.
inline Tolerance of_v(const Sample& s) {
  return {(steps_leave + 64 * 0x1p-52 / width) * s.kick() + 16 * 0x1p-52 * s.body.v.norm(),
          "1.4e-12 of the impulse by the steps of the pulse, 1.4e-11 by the rounded ends of the cubes"};
}

/// While the pulse acts the body turns by no more than |w| and the impulse make of 1e-6 s, and arms and
/// inertia turn with it.
inline Tolerance of_w(const Sample& s) {
  const double turn = pulse * (s.body.w.norm() + s.twist());
  const double momentum = (s.body.inertia * s.body.w).norm() + s.angular_impulse();
  return {2 * turn * s.yielding() * momentum + of_v(s).allowed,
          "in a pulse of 1e-6 s the body turns by 1e-6 |w|, its arms and its inertia with it"};
}

template <class Formula>
Check against_motion(const std::vector<Sample>& all, const std::string& what, const std::string& by,
                     std::size_t from, const Formula& formula) {
  const std::string motion = "motion under half the pulse at either point";
  Worst worst(what + ", " + by + " against " + motion, by, motion);
  for (const Sample& s : all) {
    const double scale = from == 0 ? s.body.v.norm() + s.kick() : s.body.w.norm() + s.twist();
    worst.see(Value(formula(s)), Value(by_motion(s, from)), from == 0 ? of_v(s) : of_w(s), scale,
              "f = " + rounded(s.f, 6));
  }
  return worst.check();
}

inline Vector3d linear(const Sample& s, double impulses) {
  return s.body.v + impulses * s.f * s.normal / s.body.mass;
}

/// The double integral of the first line, the delta functions narrow.
inline Vector3d linear_integral(const Sample& s, double weight) {
  Vector3d v = s.body.v;
  for (long k = 0; k < 3; ++k)
    v[k] += sifted([&](const Vector3d&) { return s.f * s.normal[k]; }, s.hit, weight) / s.body.mass;
  return v;
}

inline Vector3d angular_integral(const Sample& s, double weight) {
  Vector3d momentum;
  for (long k = 0; k < 3; ++k)
    momentum[k] =
        sifted([&](const Vector3d& x) { return cross(s.arm(x), s.f * s.normal)[k]; }, s.hit, weight);
  return s.body.w + turned(s.body.inertia, momentum);
}

inline Vector3d angular_mean(const Sample& s, double share = 0.5, double sign = 1) {
  const Vector3d both = cross(s.arm(s.hit.p0), s.f * s.normal) + cross(s.arm(s.hit.p1), s.f * s.normal);
  return s.body.w + sign * turned(s.body.inertia, share * both);
}

inline Vector3d at(const Sample& s, const Vector3d& arm) {
  return s.body.w + turned(s.body.inertia, cross(arm, s.f * s.normal));
}

inline Vector3d midpoint(const Sample& s) { return at(s, s.arm((s.hit.p0 + s.hit.p1) / 2)); }

inline std::vector<Claim> linear_lines(const std::vector<Sample>& all) {
  const auto motion = [&](const char* by, const auto& formula) {
    return against_motion(all, "v+", by, 0, formula);
  };
  const Check integral = motion("integral over two narrow delta functions",
                                [](const Sample& s) { return linear_integral(s, 0.5); });
  const Check sum = motion("their sum", [](const Sample& s) { return linear_integral(s, 1); });
  const auto means = [&](double share) {
    Worst worst("v+, against the integral over two narrow delta functions",
                "v- + " + shortest(share) + " (fN + fN)/m", "integral over two narrow delta functions");
    for (const Sample& s : all)
      worst.see(Value(linear(s, 2 * share)), Value(linear_integral(s, 0.5)),
                rounding((s.body.v.norm() + 2 * s.kick()) / width, 16), s.body.v.norm() + s.kick(),
                "f = " + rounded(s.f, 6));
    return worst.check();
  };
  const auto result = [&](const char* by, double impulses) {
    return motion(by, [=](const Sample& s) { return linear(s, impulses); });
  };
  return {{"6.5-linear_integral",
           3753,
           "v+ from the impulse integrated with the delta function of both points",
           {"as printed", {integral}},
           {},
           {},
           {{"the sum of two delta functions", {sum}}}},
          {"6.5-linear_mean",
           3757,
           "the integral is (fN + fN)/2",
           {"divided by 2", {means(0.5)}},
           {},
           {},
           {{"not divided", {means(1)}}}},
          {"6.5-linear_result",
           3761,
           "v+ = v- + f N / m",
           {"f N / m", {result("v- + f N / m", 1)}},
           {},
           {},
           {{"2 f N / m", {result("v- + 2 f N / m", 2)}},
            {"the other direction", {result("v- - f N / m", -1)}}}}};
}

inline std::vector<Claim> angular_lines(const std::vector<Sample>& all) {
  const auto motion = [&](const char* by, const auto& formula) {
    return against_motion(all, "w+", by, 3, formula);
  };
  const auto integral = [&](double weight) {
    return motion("J^-1 times the integral over two narrow delta functions",
                  [=](const Sample& s) { return angular_integral(s, weight); });
  };
  const auto mean = [&](const char* by, double share, double sign) {
    return motion(by, [=](const Sample& s) { return angular_mean(s, share, sign); });
  };
  const auto same = [&](std::string by, const auto& formula) {
    return compare(all, "w+", std::move(by), "J^-1 times the mean of r(P0) x fN and r(P1) x fN", formula,
                   [](const Sample& s) { return angular_mean(s); });
  };
  const Check half_difference = same("half the difference for the mean",
                                     [](const Sample& s) { return at(s, (s.hit.p1 - s.hit.p0) / 2); });
  const Check one_end = same("r(P0)", [](const Sample& s) { return at(s, s.arm(s.hit.p0)); });
  const auto mean_of_arms = [](const Sample& s) { return at(s, (s.arm(s.hit.p0) + s.arm(s.hit.p1)) / 2); };
  const Check unequal = compare(all, "w+", "midpoint", "three quarters of the impulse at P0", midpoint,
                                [](const Sample& s) { return by_motion(s, 3, 0.75); });
  const Check two_normals = compare(
      all, "w+", "midpoint with the mean normal", "another normal at P1",
      [](const Sample& s) {
        const Vector3d other(s.normal[1], s.normal[2], s.normal[0]);
        const Vector3d r = s.arm((s.hit.p0 + s.hit.p1) / 2);
        return Vector3d(s.body.w + turned(s.body.inertia, cross(r, s.f * (s.normal + other) / 2)));
      },
      [](const Sample& s) {
        const Vector3d other(s.normal[1], s.normal[2], s.normal[0]);
        const Vector3d both = cross(s.arm(s.hit.p0), s.f * s.normal) + cross(s.arm(s.hit.p1), s.f * other);
        return Vector3d(s.body.w + turned(s.body.inertia, both / 2));
      });
  return {
      {"6.5-angular_integral",
       3767,
       "w+ from the torques integrated with the delta function of both points, at t0",
       {"as printed", {integral(0.5)}},
       {},
       {},
       {{"the sum of two delta functions", {integral(1)}}}},
      {"6.5-angular_mean",
       3771,
       "the integral is the mean of r(P0) x fN and r(P1) x fN",
       {"divided by 2", {mean("mean torque", 0.5, 1)}},
       {},
       {},
       {{"not divided", {mean("summed torque", 1, 1)}}, {"fN x r", {mean("factors exchanged", 0.5, -1)}}}},
      {"6.5-angular_mean_arm",
       3777,
       "the mean of the two arms takes the place of the mean torque",
       {"(r(P0) + r(P1))/2", {same("mean arm", mean_of_arms)}},
       {},
       {},
       {{"(r(P1) - r(P0))/2", {half_difference}}}},
      {"6.5-angular_midpoint",
       3783,
       "that is the arm of the midpoint M = (P0 + P1)/2",
       {"r(M)", {same("r(M)", midpoint), against_motion(all, "w+", "r(M)", 3, midpoint)}},
       {},
       {},
       {{"r(P0)", {one_end}},
        {"also for unequal impulses", {unequal}},
        {"also for two normals", {two_normals}}}}};
}

}  // namespace oddity::contact
