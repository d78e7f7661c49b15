// Exercise 3.29: a rigid curve moves in the plane; what replaces the thin rod's position, kinetic energy and
// generalized forces?
//   r = c + R(theta) b(s), int b delta ds = 0;  T = mu0/2 |c'|^2 + mu2/2 theta'^2, mu2 = int |b|^2 delta ds
//   |r'|^2 = |c'|^2 + theta'^2 |b|^2 + 2 theta' c'.(dR/dtheta b), whose last term vanishes only in the
//   integral
// Positions are compared with complex multiplication, derivatives with dual numbers, integrals with the
// primitives for three wires, the energy with a sum over particles, forces with the slope of the total
// potential energy.

#include <complex>
#include <functional>

#include "chapters/03_rigid_body_motion/29_planar_wire/planar_wire.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"

namespace oddity {

namespace ex03_29 {

using std::cos, std::sin;

constexpr Parameter parameters[] = {
    {"q", 1, "m", "size of the wires", 0.1, 10},
    {"d", 2, "kg/m", "their density", 0.01, 100},
    {"u", 2, "m/s", "velocity of the center at the start, level", -20, 20},
    {"v", 5, "m/s", "velocity of the center at the start, upward", -20, 20},
    {"w", 6, "rad/s", "angular velocity", -20, 20},
    {"g", 9.81, "m/s^2", "gravity", 0, 100},
    {"seed", 29, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- samples ----------------------------------------------------------------------------------------------

/// A random wire in a random motion, and a point of it at the parameter at.
struct Sample {
  Wire wire;
  double x, y, theta, vx, vy, w, at;
  Point center;
  double mu0;

  explicit Sample(Random& random)
      : wire{static_cast<Shape>(random.below(3)), random.between(0.5, 2), random.between(0.3, 3),
             random.between(0.5, 2)},
        x(random.between(-3, 3)),
        y(random.between(-3, 3)),
        theta(random.between(-3, 3)),
        vx(random.magnitude(0.5, 3)),
        vy(random.magnitude(0.5, 3)),
        w(random.magnitude(0.5, 3)),
        at(wire.end() * random.between(0.02, 0.98)),
        center(wire.center()),
        mu0(wire.over_mass([](double) { return 1; })) {}

  /// The terms of lengths, velocities, energies and forces, added up.
  double size() const {
    const double extent = wire.q + wire.q * wire.q, reach = std::abs(x) + std::abs(y) + extent,
                 speed = std::abs(vx) + std::abs(vy) + std::abs(w) * extent;
    return reach + speed + (1 + mu0) * (1 + speed * speed + (11 + reach * reach) * (1 + extent));
  }
  std::string where() const {
    return std::string(wire.shape == Shape::straight     ? "straight"
                       : wire.shape == Shape::semicircle ? "semicircle"
                                                         : "parabola") +
           ", q = " + rounded(wire.q, 4) + ", density " + rounded(wire.d0, 4) + " (1 + " +
           rounded(wire.k, 4) + " s/L), theta = " + rounded(theta, 4);
  }
  Point body(double u) const {
    const Point p = wire.point(u);
    return {p[0] - center[0], p[1] - center[1]};
  }
  Point b() const { return body(at); }
  /// Position and velocity by complex numbers c + exp(i theta) b along the motion; p is the body's point.
  Value position(Point p) const {
    const auto z = std::complex(x, y) + std::polar(1.0, theta) * std::complex(p[0], p[1]);
    return {z.real(), z.imag()};
  }
  /// By dual numbers in the time.
  Point velocity(Point p) const {
    const Dual<double> angle(theta, w);
    return {(Dual<double>(x, vx) + p[0] * cos(angle) - p[1] * sin(angle)).slope,
            (Dual<double>(y, vy) + p[0] * sin(angle) + p[1] * cos(angle)).slope};
  }
  /// The kinetic energy of 2000 particles.
  double of_particles() const {
    constexpr int n = 2000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const double u = wire.end() * (i + 0.5) / n;
      const Point v = velocity(body(u));
      sum += wire.density(u) * wire.stretch(u) * wire.end() / n * (v[0] * v[0] + v[1] * v[1]) / 2;
    }
    return sum;
  }
  double integrated(const std::function<double(Point, Point)>& of) const {
    return wire.over_mass([&](double u) {
      const Point p = body(u);
      return of(p, velocity(p));
    });
  }
  double mu2(Point about = {0, 0}) const {
    return integrated([&](Point p, Point) {
      return (p[0] - about[0]) * (p[0] - about[0]) + (p[1] - about[1]) * (p[1] - about[1]);
    });
  }
};
using S = const Sample&;

/// A force per mass with a potential: phi(X, Y) = X^2 Y/4 + 10 Y + sin(X).
template <class T>
T phi(const T& X, const T& Y) {
  using std::sin;
  return 0.25 * X * X * Y + 10.0 * Y + sin(X);
}
Point force(const Value& r) { return {-0.5 * r[0] * r[1] - cos(r[0]), -0.25 * r[0] * r[0] - 10}; }

/// Minus the slope of the total potential energy by a generalized coordinate: 0, 1, 2 for x, y, theta.
double slope_of_potential(S s, int coordinate) {
  using D = Dual<double>;
  const D X(s.x, coordinate == 0), Y(s.y, coordinate == 1), angle(s.theta, coordinate == 2);
  const D C = cos(angle), Z = sin(angle);
  return -s.integrated(
      [&](Point p, Point) { return phi(X + C * p[0] - Z * p[1], Y + Z * p[0] + C * p[1]).slope; });
}

/// The integral of the force times a direction that may depend on the body's point.
double generalized(S s, const std::function<Point(Point)>& direction) {
  return s.integrated([&](Point p, Point) {
    const Point f = force(s.position(p)), d = direction(p);
    return f[0] * d[0] + f[1] * d[1];
  });
}

Point turned(S s, Point p, double sign = 1) {
  return {-sign * p[0] * sin(s.theta) - p[1] * cos(s.theta),
          p[0] * cos(s.theta) - sign * p[1] * sin(s.theta)};
}

// ---- the claims -------------------------------------------------------------------------------------------

Value placed(S s, Point p, double sign = 1) {
  return {s.x + cos(s.theta) * p[0] - sign * sin(s.theta) * p[1],
          s.y + sign * sin(s.theta) * p[0] + cos(s.theta) * p[1]};
}

Value moved(S s, double sign) {
  const Point b = s.b();
  return {s.vx - s.w * (b[0] * sin(s.theta) + sign * b[1] * cos(s.theta)),
          s.vy + s.w * (b[0] * cos(s.theta) - sign * b[1] * sin(s.theta))};
}

double squared(S s, double cross) {
  const Point b = s.b(), d = turned(s, b);
  return s.vx * s.vx + s.vy * s.vy + s.w * s.w * (b[0] * b[0] + b[1] * b[1]) +
         cross * 2 * s.w * (s.vx * d[0] + s.vy * d[1]);
}

double energy(S s, double mu2) { return s.mu0 / 2 * (s.vx * s.vx + s.vy * s.vy) + mu2 / 2 * s.w * s.w; }

/// mu0 and mu2 by integration against the primitives, density uniform.
Check against_primitives(const std::string& what, std::size_t component, bool centered, bool by_length,
                         double seed) {
  Random random(seed);
  Worst worst(what, "integral along the curve", "primitives");
  for (int i = 0; i < 60; ++i) {
    Sample s(random);
    s.wire.k = 0;
    s.center = s.wire.center();
    const Inertia exact = by_primitives(s.wire);
    const double mass =
        by_length ? s.wire.over_mass([](double) { return 1; })
                  : gauss_legendre([&](double u) { return s.wire.density(u); }, 0, s.wire.end(), 32).value;
    worst.see(component == 0 ? mass : s.mu2(centered ? Point{} : Point{-s.center[0], -s.center[1]}),
              exact[component], 1 + s.size(), s.where());
  }
  return worst.check();
}

/// Rough friction of size 1 a mass against the velocity of every point, its velocities times `speed`: the
/// integrand of its moment about the center of mass.
double friction_at(S s, double u, double speed) {
  const Point p = s.body(u), v = s.velocity(p), d = turned(s, p);
  const double vx = speed * v[0], vy = speed * v[1];
  return -(vx * d[0] + vy * d[1]) / std::hypot(vx, vy) * s.wire.density(u) * s.wire.stretch(u);
}

Check friction_moment(double seed, int panels) {
  Random random(seed);
  Worst worst("moment of rough friction on a moving wire", "Simpson, " + std::to_string(panels) + " panels",
              "QAG");
  for (int i = 0; i < 30; ++i) {
    const Sample s(random);
    const auto f = [&](double u) { return friction_at(s, u, 1); };
    worst.see(simpson(f, 0, s.wire.end(), panels).value, qag(f, 0, s.wire.end(), 1e-12).value,
              {1e-6, "the truncation of Simpson's rule where a point of the wire all but rests"}, 1,
              s.where());
  }
  return worst.check();
}

/// The moment at a multiple of the sample's velocities against `part` of that at the velocities themselves.
Check friction_at_speed(const std::string& by, double seed, double speed, double part) {
  Random random(seed);
  Worst worst("moment of rough friction", by + ", by Gauss and Legendre",
              shortest(part) + " times that of the moving wire, by Gauss and Legendre");
  for (int i = 0; i < 30; ++i) {
    const Sample s(random);
    const auto moment = [&](double times) {
      return gauss_legendre([&](double u) { return friction_at(s, u, times); }, 0, s.wire.end(), 64).value;
    };
    worst.see(moment(speed), part * moment(1), s.mu0 * s.wire.q * (1 + s.wire.q), s.where());
  }
  return worst.check();
}

Claim friction_at_rest(double seed) {
  Claim claim{"3.29-friction_at_rest", 2945,
              "with rough friction the generalized forces are integrals, which can be computed numerically"};
  claim.printed = {"for a wire at rest, too", {friction_at_speed("at rest", seed, 0, 0)}};
  claim.corrected = {"for a wire in motion, whatever its speed; at rest the integrand is 0/0",
                     {friction_at_speed("a billion times slower", seed, 1e-9, 1),
                      friction_at_speed("a billion times slower, the other way", seed, -1e-9, -1)}};
  claim.near_misses = {
      {"half the friction at half the speed", {friction_at_speed("half as fast", seed, 0.5, 0.5)}}};
  claim.why =
      "Rough friction has the direction $-v/|v|$, and a wire at rest has none: every rule that evaluates the "
      "integrand returns NaN. Nor is there a limit: friction of 1 N a kilogram on a rod of 1 m and 2 kg that "
      "turns about its center has a moment of $-0.5$ or $+0.5$ N m, by the sense of the turn, however slow "
      "it "
      "is. At rest it takes what holds the rod, up to a bound: that is static friction, which the integral "
      "does "
      "not have.";
  return claim;
}

std::vector<Claim> claims(double seed) {
  std::vector<Claim> all;
  const auto says = [&](const char* id, int line, const char* what, const Version<Sample>& printed,
                        const Version<Sample>& truth, const std::vector<Version<Sample>>& near) {
    all.push_back(formula_claim(std::string("3.29-") + id, line, what, seed, printed, truth, near));
  };
  const auto check = [&](const char* id, int line, const char* what, const Check& holds,
                         const std::vector<Check>& near) {
    Claim claim{std::string("3.29-") + id, line, what};
    claim.printed = {holds.quantity + ": " + holds.left.by, {holds}};
    for (const Check& miss : near) claim.near_misses.push_back({miss.quantity + ": " + miss.left.by, {miss}});
    all.push_back(std::move(claim));
  };
  const auto rod = [](S s) { return Point{s.b()[0], 0}; };

  says("thin_rod", 2791, "a point of the rod",
       {"(x, y) + L (cos, sin)",
        [=](S s) { return values(s.x + rod(s)[0] * cos(s.theta), s.y + rod(s)[0] * sin(s.theta)); }},
       {"complex multiplication", [=](S s) { return s.position(rod(s)); }},
       {{"(x, y) + L (sin, cos)",
         [=](S s) { return values(s.x + rod(s)[0] * sin(s.theta), s.y + rod(s)[0] * cos(s.theta)); }}});
  says("thin_rod_matrix", 2795, "the same by the matrix",
       {"(x, y) + R (L, 0)", [=](S s) { return placed(s, rod(s)); }},
       {"complex multiplication", [=](S s) { return s.position(rod(s)); }},
       {{"R transposed", [=](S s) { return placed(s, rod(s), -1); }}});
  const auto first_moments = [](S s, Point from) {
    return values(s.mu0 + s.wire.over_mass([&](double u) { return s.wire.point(u)[0] - from[0]; }),
                  s.mu0 + s.wire.over_mass([&](double u) { return s.wire.point(u)[1] - from[1]; }));
  };
  says("body_space", 2823, "the center of mass is the origin of body space",
       {"mu0 + int b delta ds, b from the center of mass", [=](S s) { return first_moments(s, s.center); }},
       {"(mu0, mu0)", [](S s) { return values(s.mu0, s.mu0); }}, {{"b from the start of the curve", [=](S s) {
                                                                     return first_moments(s, {0, 0});
                                                                   }}});
  says("rotates_about_origin", 2823, "R rotates about the origin",
       {"R b and its length",
        [](S s) {
          const Value r = placed(s, s.b());
          return values(r[0] - s.x, r[1] - s.y, std::hypot(r[0] - s.x, r[1] - s.y));
        }},
       {"exp(i theta) b, |b|",
        [](S s) {
          const auto z = std::polar(1.0, s.theta) * std::complex(s.b()[0], s.b()[1]);
          return values(z.real(), z.imag(), std::hypot(s.b()[0], s.b()[1]));
        }},
       {{"R transposed", [](S s) {
           const Value r = placed(s, s.b(), -1);
           return values(r[0] - s.x, r[1] - s.y, std::hypot(s.b()[0], s.b()[1]));
         }}});
  const auto reoriented = [](S s, double angle, double shift) {
    return s.integrated([&](Point p, Point) {
      const auto z = std::polar(1.0, angle) * std::complex(p[0], p[1]) + shift;
      return std::norm(z);
    });
  };
  says("reorient_or_not", 2825, "turning the curve in body space changes nothing; mu2",
       {"turned by 1 radian", [=](S s) { return reoriented(s, 1, 0); }},
       {"as it is", [](S s) { return s.mu2(); }},
       {{"turned and shifted by 0.1", [=](S s) { return reoriented(s, 1, 0.1); }}});
  says("arc_length", 2825, "the total length",
       {"the arc length's range, int ds", [](S s) { return s.wire.along([](double) { return 1; }); }},
       {"primitive of ds", [](S s) { return s.wire.arc_length(s.wire.end()); }},
       {{"its chord", [](S s) {
           const Point a = s.wire.point(0), b = s.wire.point(s.wire.end());
           return std::hypot(b[0] - a[0], b[1] - a[1]);
         }}});
  says("position", 2827, "r", {"c + R(theta) b", [](S s) { return placed(s, s.b()); }},
       {"complex multiplication", [](S s) { return s.position(s.b()); }},
       {{"c + R(-theta) b", [](S s) { return placed(s, s.b(), -1); }}});
  const auto by_matrix = [](double factor) {
    return [factor](S s) {
      const Point d = turned(s, s.b());
      return values(s.vx + factor * d[0], s.vy + factor * d[1]);
    };
  };
  const Version<Sample> differentiated{"dual numbers in the time",
                                       [](S s) { return Value(s.velocity(s.b())); }};
  says("velocity", 2831, "v", {"c' + theta' (dR/dtheta) b", [=](S s) { return by_matrix(s.w)(s); }},
       differentiated,
       {{"c' - theta' (dR/dtheta) b", [=](S s) { return by_matrix(-s.w)(s); }},
        {"c' + (dR/dtheta) b", by_matrix(1)}});
  says("dR_dtheta", 2847, "dR/dtheta by rows",
       {"(-sin, -cos; cos, -sin)",
        [](S s) { return values(-sin(s.theta), -cos(s.theta), cos(s.theta), -sin(s.theta)); }},
       {"dual numbers",
        [](S s) {
          const Dual<double> angle(s.theta, 1), C = cos(angle), Z = sin(angle);
          return values(C.slope, -Z.slope, Z.slope, C.slope);
        }},
       {{"its transpose",
         [](S s) { return values(-sin(s.theta), cos(s.theta), -cos(s.theta), -sin(s.theta)); }}});
  says("velocity_components", 2857, "v by components",
       {"(x' - theta' (b0 sin + b1 cos), y' + theta' (b0 cos - b1 sin))", [](S s) { return moved(s, 1); }},
       differentiated, {{"the sign of b1 flipped", [](S s) { return moved(s, -1); }}});
  check("mass", 2867, "mu0 is the integral of the density over the length",
        against_primitives("mu0", 0, true, true, seed),
        {against_primitives("int delta du, u not the arc length", 0, true, false, seed)});
  const auto half_square = [](double factor) {
    return [factor](S s) {
      return factor * s.integrated([](Point, Point v) { return v[0] * v[0] + v[1] * v[1]; });
    };
  };
  const Version<Sample> by_integral{"int |v|^2/2 delta ds, v by dual numbers", half_square(0.5)};
  {
    Claim claim{"3.29-kinetic_energy", 2883, "T is the integral of |v|^2 delta/2"};
    const auto particles = [&](const std::string& by, double factor) {
      Random random(seed);
      Worst worst("T", by, "2000 particles");
      for (int i = 0; i < 30; ++i) {
        const Sample s(random);
        worst.see(half_square(factor)(s), s.of_particles(), {1e-4, "the midpoint rule's truncation"}, 1,
                  s.where());
      }
      return worst.check();
    };
    claim.printed = {"half of int |v|^2 delta ds", {particles("half of int |v|^2 delta ds", 0.5)}};
    claim.near_misses = {{"without the half", {particles("int |v|^2 delta ds", 1)}}};
    all.push_back(claim);
  }
  says("speed_squared", 2901, "each point has |v|^2 = x'^2 + y'^2 + theta'^2 (b0^2 + b1^2)",
       {"x'^2 + y'^2 + theta'^2 (b0^2 + b1^2)", [](S s) { return squared(s, 0); }},
       {"dual numbers in the time",
        [](S s) {
          const Point v = s.velocity(s.b());
          return v[0] * v[0] + v[1] * v[1];
        }},
       {{"the cross term's sign flipped", [](S s) { return squared(s, -1); }}});
  all.back().corrected = {
      "x'^2 + y'^2 + theta'^2 (b0^2 + b1^2) + 2 theta' (x', y').(dR/dtheta b)",
      {compare<Sample>("|v|^2", {"with the cross term", [](S s) { return squared(s, 1); }},
                       {"dual numbers in the time",
                        [](S s) {
                          const Point v = s.velocity(s.b());
                          return v[0] * v[0] + v[1] * v[1];
                        }},
                       seed)}};
  all.back().why =
      "The cross term $2\\dot\\theta\\,(\\dot x,\\dot y)\\cdot\\frac{dR}{d\\theta}b$ is missing. A wheel "
      "that "
      "rolls shows it: with $\\dot x=1$, $\\dot\\theta=-1$ and $b=(0,-1)$ at $\\theta=0$ the point rests, "
      "and "
      "the formula gives 2. The term vanishes in the integral alone, because $\\int b\\,\\delta\\,ds=0$; the "
      "kinetic energy that follows is right.";
  says("kinetic_energy_formula", 2905, "T",
       {"mu0/2 (x'^2 + y'^2) + mu2/2 theta'^2", [](S s) { return energy(s, s.mu2()); }}, by_integral,
       {{"mu2 about the start of the curve",
         [](S s) {
           return energy(s, s.mu2({-s.center[0], -s.center[1]}));
         }},
        {"mu2 for mu2/2", [](S s) { return energy(s, 2 * s.mu2()); }}});
  check("mu2", 2915, "mu2 is the integral of |b|^2 delta",
        against_primitives("mu2, |b|^2 from the center of mass", 3, true, true, seed),
        {against_primitives("mu2, |b|^2 from the start of the curve", 3, false, true, seed)});
  /// A uniform rod of the mass mu0 and the length l, its energy by quadrature.
  const auto of_rod = [](S s, double l) {
    const auto f = [&](double L) {
      const Point v = s.velocity({L, 0});
      return s.mu0 / l * (v[0] * v[0] + v[1] * v[1]) / 2;
    };
    return gauss_legendre(f, -l / 2, l / 2, 4).value;
  };
  says(
      "only_differences", 2923, "nothing but mu0 and mu2 tells the curve from a rod; T",
      {"of a rod with the same mu0 and mu2", [=](S s) { return of_rod(s, std::sqrt(12 * s.mu2() / s.mu0)); }},
      by_integral, {{"of a rod with the same mu0 and length", [=](S s) {
                       return of_rod(s, s.wire.arc_length(s.wire.end()));
                     }}});
  const auto potential = [](int coordinate) {
    return Version<Sample>{"minus the slope of the total potential energy, by dual numbers",
                           [coordinate](S s) { return slope_of_potential(s, coordinate); }};
  };
  const auto along = [](Point d) { return [d](S s) { return generalized(s, [d](Point) { return d; }); }; };
  const Version<Sample> Fx{"int F.i delta ds", along({1, 0})}, Fy{"int F.j delta ds", along({0, 1})};
  says("force_x", 2927, "Fx", Fx, potential(0), {Fy});
  says("force_y", 2933, "Fy", Fy, potential(1), {Fx});
  Claim& upward = all.back();
  upward.meant = std::move(upward.printed);
  upward.printed = {
      "int F delta ds, a vector",
      {compare<Sample>("Fy", {"int F delta ds", [=](S s) { return values(Fx.of(s)[0], Fy.of(s)[0]); }},
                       potential(1), seed)}};
  upward.says = "Fy is int F . delta ds, its unit vector missing";
  upward.why =
      "The unit vector $\\jmath$ after the dot is lost in the text at hand; line 2931, on $F_x$, has its "
      "$\\imath$. Without it what is integrated is the force, a vector, and not its component.";
  says("force_theta", 2939, "Ftheta",
       {"int F.(dR/dtheta b) delta ds",
        [](S s) { return generalized(s, [&](Point p) { return turned(s, p); }); }},
       potential(2),
       {{"int F.(R b) delta ds",
         [](S s) {
           return generalized(s, [&](Point p) {
             const Value r = placed(s, p);
             return Point{r[0] - s.x, r[1] - s.y};
           });
         }},
        {"dR/dtheta at -theta",
         [](S s) { return generalized(s, [&](Point p) { return turned(s, p, -1); }); }}});
  all.back().printed.checks.push_back(
      compare<Sample>("(Fx, Fy, Ftheta) of gravity",
                      {"integrals of (0, -g)",
                       [](S s) {
                         return values(0, -9.81 * s.integrated([](Point, Point) { return 1; }),
                                       -9.81 * s.integrated([&](Point p, Point) { return turned(s, p)[1]; }));
                       }},
                      {"(0, -mu0 g, 0)", [](S s) { return values(0, -9.81 * s.mu0, 0); }}, seed));
  check("numerical_integration", 2945,
        "numerical integration serves for rough friction too, on a moving wire",
        friction_moment(seed, 1 << 15), {friction_moment(seed, 2)});
  all.push_back(friction_at_rest(seed));
  return all;
}

Given asked(const Parameters& p) { return {p["q"], p["d"], p["u"], p["v"], p["w"], p["g"]}; }

Quantity fall_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return fall(asked(p), horizon, truth);
}

Scene scene() {
  return {
      fall_of,
      2,
      centimeter,
      "w",
      {1, 3, 6, 10, 20},
      {"u", "v", "w"},
      {{"x", "y"}, "s", {{"m", {0, 1}}}},
      {{"chapters/03_rigid_body_motion/29_planar_wire/models.hpp"},
       {{"center alone", "planar_wire::PointMass<double>{planar_wire::thrown<double>({q, d, u, v, w, g})}"},
        {"free fall", "planar_wire::FreeFall<double>{planar_wire::thrown<double>({q, d, u, v, w, g})}"},
        {"x, y, theta", "planar_wire::Generalized<double>{planar_wire::thrown<double>({q, d, u, v, w, g})}"},
        {"two particles and a rod",
         "planar_wire::TwoParticles<double>{planar_wire::thrown<double>({q, d, u, v, w, g})}"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  Findings found{claims(p["seed"]), inertias(asked(p), truth)};
  found.quantities.push_back(motion(scene(), p, truth));
  found.quantities.back().add(
      Breakdown{"Particles and a rod: explicit Euler lets the rod grow and the energy with it. With "
                "the angle as a coordinate there is no rod to keep, and Verlet's method is exact.",
                "two particles and a rod, explicit Euler", 0.125, Outcome::drifted,
                "x, y, theta, velocity Verlet", 0.125});
  return found;
}

}  // namespace ex03_29

Exercise exercise_3_29() {
  using namespace ex03_29;
  return {"Rigid curve in the plane",
          "A rigid wire of any shape moves in the plane. Find its position, kinetic energy and generalized "
          "forces, as for a thin rod.",
          parameters, scene(), study};
}

}  // namespace oddity
