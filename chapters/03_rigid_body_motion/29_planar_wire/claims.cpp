// The claims of exercise 3.29. Positions are compared with complex multiplication, derivatives with dual
// numbers, integrals with the primitives for three wires, the energy with a sum over particles, forces with
// the slope of the total potential energy.

#include <complex>
#include <functional>

#include "chapters/03_rigid_body_motion/29_planar_wire/planar_wire.hpp"
#include "chapters/claims.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_29 {

using std::cos, std::sin;

namespace {

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
           ", $q$ = " + format_significant(wire.q, 4) + ", density " + format_significant(wire.d0, 4) +
           " (1 + " + format_significant(wire.k, 4) + R"( $s/L$), $\theta$ = )" +
           format_significant(theta, 4);
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

using Reader = Formula<Sample>;

/// A force per mass with a potential: phi(X, Y) = X^2 Y/4 + 10 Y + sin(X).
template <class T>
T phi(const T& X, const T& Y) {
  using std::sin;
  return 0.25 * X * X * Y + 10.0 * Y + sin(X);
}
Point force(const Value& r) { return {-0.5 * r[0] * r[1] - cos(r[0]), -0.25 * r[0] * r[0] - 10}; }

/// Minus the slope of the total potential energy by a generalized coordinate: 0, 1, 2 for x, y, theta.
double slope_of_potential(const Sample& s, int coordinate) {
  using D = Dual<double>;
  const D X(s.x, coordinate == 0), Y(s.y, coordinate == 1), angle(s.theta, coordinate == 2);
  const D C = cos(angle), Z = sin(angle);
  return -s.integrated(
      [&](Point p, Point) { return phi(X + C * p[0] - Z * p[1], Y + Z * p[0] + C * p[1]).slope; });
}

/// The integral of the force times a direction that may depend on the body's point.
double generalized(const Sample& s, const std::function<Point(Point)>& direction) {
  return s.integrated([&](Point p, Point) {
    const Point f = force(s.position(p)), d = direction(p);
    return f[0] * d[0] + f[1] * d[1];
  });
}

Point turned(const Sample& s, Point p, double sign = 1) {
  return {-sign * p[0] * sin(s.theta) - p[1] * cos(s.theta),
          p[0] * cos(s.theta) - sign * p[1] * sin(s.theta)};
}

// ---- the text's formulas ----------------------------------------------------------------------------------

Value placed(const Sample& s, Point p, double sign = 1) {
  return {s.x + cos(s.theta) * p[0] - sign * sin(s.theta) * p[1],
          s.y + sign * sin(s.theta) * p[0] + cos(s.theta) * p[1]};
}
Reader at_point(const std::string& text, double sign, double across = 1) {
  return {text, [=](const Sample& s) { return placed(s, {s.b()[0], across * s.b()[1]}, sign); }};
}

/// v with factors of theta' and of b1 sin and b1 cos.
Reader moved(const std::string& text, double turning, double sign, bool rate = true) {
  return {text, [=](const Sample& s) {
            const Point b = s.b();
            const double w = turning * (rate ? s.w : 1);
            return values(s.vx - w * (b[0] * sin(s.theta) + sign * b[1] * cos(s.theta)),
                          s.vy + w * (b[0] * cos(s.theta) - sign * b[1] * sin(s.theta)));
          }};
}

Reader squared(const std::string& text, double cross) {
  return {text, [cross](const Sample& s) {
            const Point b = s.b(), d = turned(s, b);
            return s.vx * s.vx + s.vy * s.vy + s.w * s.w * (b[0] * b[0] + b[1] * b[1]) +
                   cross * 2 * s.w * (s.vx * d[0] + s.vy * d[1]);
          }};
}

double energy(const Sample& s, double mu2) {
  return s.mu0 / 2 * (s.vx * s.vx + s.vy * s.vy) + mu2 / 2 * s.w * s.w;
}

double integrated_energy(const Sample& s, double factor) {
  return factor * s.integrated([](Point, Point v) { return v[0] * v[0] + v[1] * v[1]; });
}

/// The kinetic energy of a uniform rod of the same mass and the length l, by quadrature.
double energy_of_rod(const Sample& s, double l) {
  const auto f = [&](double L) {
    const Point v = s.velocity({L, 0});
    return s.mu0 / l * (v[0] * v[0] + v[1] * v[1]) / 2;
  };
  return gauss_legendre(f, -l / 2, l / 2, 4).value;
}

/// mu0 or mu2 by integration against the primitives, density uniform.
Reading against_primitives(const std::string& text, std::size_t component, bool centered, bool by_length,
                           double seed) {
  Random random(seed);
  WorstSample worst(component == 0 ? R"($\mu_0$)" : R"($\mu_2$)", text, "primitives of the moments");
  for (int i = 0; i < 60; ++i) {
    Sample s(random);
    s.wire.k = 0;
    s.center = s.wire.center();
    const Inertia exact = by_primitives(s.wire);
    const double mass =
        by_length ? s.wire.over_mass([](double) { return 1; })
                  : gauss_legendre([&](double u) { return s.wire.density(u); }, 0, s.wire.end(), 32).value;
    worst.add(component == 0 ? mass : s.mu2(centered ? Point{} : Point{-s.center[0], -s.center[1]}),
              exact[component], 1 + s.size(), s.where());
  }
  return {text, {worst.check()}};
}

/// A multiple of the integral of |v|^2 against the energy of 2000 particles.
Reading of_particles(const std::string& text, double factor, double seed) {
  Random random(seed);
  WorstSample worst("$T$", text, "2000 particles");
  for (int i = 0; i < 30; ++i) {
    const Sample s(random);
    worst.add(integrated_energy(s, factor), s.of_particles(), {1e-4, "the midpoint rule's truncation"}, 1,
              s.where());
  }
  return {text, {worst.check()}};
}

/// Rough friction of size 1 a mass against the velocity of every point, its velocities times `speed`: the
/// integrand of its moment about the center of mass.
double friction_at(const Sample& s, double u, double speed) {
  const Point p = s.body(u), v = s.velocity(p), d = turned(s, p);
  const double vx = speed * v[0], vy = speed * v[1];
  return -(vx * d[0] + vy * d[1]) / std::hypot(vx, vy) * s.wire.density(u) * s.wire.stretch(u);
}

Reading friction_moment(double seed, int panels) {
  Random random(seed);
  const std::string text = "Simpson's rule, " + std::to_string(panels) + " panels";
  WorstSample worst("moment of rough friction on a moving wire", text, "QAG");
  for (int i = 0; i < 30; ++i) {
    const Sample s(random);
    const auto f = [&](double u) { return friction_at(s, u, 1); };
    worst.add(simpson(f, 0, s.wire.end(), panels).value, qag(f, 0, s.wire.end(), 1e-12).value,
              {1e-6, "the truncation of Simpson's rule where a point of the wire all but rests"}, 1,
              s.where());
  }
  return {text, {worst.check()}};
}

/// The moment at a multiple of the sample's velocities against `part` of that at the velocities themselves.
Check friction_at_speed(const std::string& by, double seed, double speed, double part) {
  Random random(seed);
  WorstSample worst("moment of rough friction", by + ", by Gauss and Legendre",
                    format_shortest(part) + " times that of the moving wire, by Gauss and Legendre");
  for (int i = 0; i < 30; ++i) {
    const Sample s(random);
    const auto moment = [&](double times) {
      return gauss_legendre([&](double u) { return friction_at(s, u, times); }, 0, s.wire.end(), 64).value;
    };
    worst.add(moment(speed), part * moment(1), s.mu0 * s.wire.q * (1 + s.wire.q), s.where());
  }
  return worst.check();
}

const std::string cross_term = "cross term left out", at_rest = "friction at rest";

}  // namespace

std::vector<Claim> claims(double seed) {
  const auto samples = draw<Sample>(200, seed);
  Claims claims("3.29");
  const std::string complex = "complex multiplication", by_dual = "dual numbers in the time";

  const auto on_rod = [](const std::string& text, bool swapped) {
    return Reader{text, [swapped](const Sample& s) {
                    const double L = s.b()[0], C = L * cos(s.theta), S = L * sin(s.theta);
                    return values(s.x + (swapped ? S : C), s.y + (swapped ? C : S));
                  }};
  };
  const Reader rod{complex, [](const Sample& s) { return s.position({s.b()[0], 0}); }};
  claims.formula("thin_rod", 2791, "a point of the rod, $L$ from its center $(x,y)$", samples,
                 {.truth = rod,
                  .printed = on_rod(R"($(x,y)+L(\cos\theta,\sin\theta)$)", false),
                  .near_misses = {on_rod(R"($(x,y)+L(\sin\theta,\cos\theta)$)", true)}});
  claims.formula("thin_rod_matrix", 2795, "the same by the matrix $R$", samples,
                 {.truth = rod,
                  .printed = at_point("$(x,y)+R\\,(L,0)$", 1, 0),
                  .near_misses = {at_point("$(x,y)+R^T(L,0)$", -1, 0)}});
  const auto first_moments = [](const std::string& text, bool centered) {
    return Reader{text, [centered](const Sample& s) {
                    const Point from = centered ? s.center : Point{0, 0};
                    return values(
                        s.mu0 + s.wire.over_mass([&](double u) { return s.wire.point(u)[0] - from[0]; }),
                        s.mu0 + s.wire.over_mass([&](double u) { return s.wire.point(u)[1] - from[1]; }));
                  }};
  };
  claims.formula("body_space", 2823, R"($\int b\,\delta\,ds=0$ in body space)", samples,
                 {.quantity = R"($(\mu_0,\mu_0)+\int b\,\delta\,ds$)",
                  .truth = {R"($(\mu_0,\mu_0)$)", [](const Sample& s) { return values(s.mu0, s.mu0); }},
                  .printed = first_moments("$b$ from the center of mass", true),
                  .near_misses = {first_moments("$b$ from the start of the curve", false)}});
  const auto rotated = [](const std::string& text, double sign) {
    return Reader{text, [sign](const Sample& s) {
                    const Value r = placed(s, s.b(), sign);
                    return values(r[0] - s.x, r[1] - s.y, std::hypot(r[0] - s.x, r[1] - s.y));
                  }};
  };
  claims.formula("rotates_about_origin", 2823, "the rotation about the origin of body space", samples,
                 {.quantity = "the point $b$ turned, and its distance from the origin",
                  .truth = {R"($e^{i\theta}b$ and $|b|$)",
                            [](const Sample& s) {
                              const auto z = std::polar(1.0, s.theta) * std::complex(s.b()[0], s.b()[1]);
                              return values(z.real(), z.imag(), std::hypot(s.b()[0], s.b()[1]));
                            }},
                  .printed = rotated("$Rb$", 1),
                  .near_misses = {rotated("$R^Tb$", -1)}});
  const auto reoriented = [](const std::string& text, double shift) {
    return Reader{text, [shift](const Sample& s) {
                    return s.integrated([&](Point p, Point) {
                      return std::norm(std::polar(1.0, 1.0) * std::complex(p[0], p[1]) + shift);
                    });
                  }};
  };
  claims.formula("reorient_or_not", 2825, "the curve may be turned in body space", samples,
                 {.quantity = R"($\mu_2$)",
                  .truth = {"of the curve as it is", [](const Sample& s) { return s.mu2(); }},
                  .printed = reoriented("turned by 1 radian", 0),
                  .near_misses = {reoriented("turned by 1 radian and shifted by 0.1", 0.1)}});
  claims.formula(
      "arc_length", 2825, "the arc length runs up to the total length", samples,
      {.quantity = "the total length",
       .truth = {"the primitive of $ds$", [](const Sample& s) { return s.wire.arc_length(s.wire.end()); }},
       .printed = {R"($\int ds$)", [](const Sample& s) { return s.wire.along([](double) { return 1; }); }},
       .near_misses = {{"the chord", [](const Sample& s) {
                          const Point a = s.wire.point(0), b = s.wire.point(s.wire.end());
                          return std::hypot(b[0] - a[0], b[1] - a[1]);
                        }}}});
  claims.formula("position", 2827, "the position $r$ of the point $b$, $c$ the center of mass", samples,
                 {.truth = {complex, [](const Sample& s) { return s.position(s.b()); }},
                  .printed = at_point(R"($c+R(\theta)b$)", 1),
                  .near_misses = {at_point(R"($c+R(-\theta)b$)", -1)}});
  const Reader velocity{by_dual, [](const Sample& s) { return s.velocity(s.b()); }};
  claims.formula("velocity", 2831, "its velocity $v$", samples,
                 {.truth = velocity,
                  .printed = moved(R"($\dot c+\dot\theta\frac{dR}{d\theta}b$)", 1, 1),
                  .near_misses = {moved(R"($\dot c-\dot\theta\frac{dR}{d\theta}b$)", -1, 1),
                                  moved(R"($\dot c+\frac{dR}{d\theta}b$)", 1, 1, false)}});
  const auto by_rows = [](const std::string& text, double sign) {
    return Reader{text, [sign](const Sample& s) {
                    const double C = cos(s.theta), S = sin(s.theta);
                    return values(-S, -sign * C, sign * C, -S);
                  }};
  };
  claims.formula("dR_dtheta", 2847, R"($\frac{dR}{d\theta}$ by rows)", samples,
                 {.truth = {"dual numbers in the angle",
                            [](const Sample& s) {
                              const Dual<double> angle(s.theta, 1), C = cos(angle), S = sin(angle);
                              return values(C.slope, -S.slope, S.slope, C.slope);
                            }},
                  .printed = by_rows(R"($(-\sin\theta,-\cos\theta;\ \cos\theta,-\sin\theta)$)", 1),
                  .near_misses = {by_rows("its transpose", -1)}});
  claims.formula(
      "velocity_components", 2857, "$v$ by components", samples,
      {.truth = velocity,
       .printed = moved(
           R"($(\dot x-\dot\theta(b_0\sin\theta+b_1\cos\theta),\ \dot y+\dot\theta(b_0\cos\theta-b_1\sin\theta))$)",
           1, 1),
       .near_misses = {moved("with the sign of $b_1$ flipped", 1, -1)}});
  claims.add("mass", 2867, R"($\mu_0$ is the integral of the density over the length)",
             {.printed = against_primitives(R"($\mu_0=\int\delta\,ds$)", 0, true, true, seed),
              .near_misses = {against_primitives(R"($\mu_0=\int\delta\,du$, $u$ not the arc length)", 0, true,
                                                 false, seed)}});
  claims.add("kinetic_energy", 2883, "the kinetic energy $T$ is the integral of the points'",
             {.printed = of_particles(R"($T=\int\frac12|v|^2\delta\,ds$)", 0.5, seed),
              .near_misses = {of_particles(R"($T=\int|v|^2\delta\,ds$)", 1, seed)}});
  const std::string sum = R"($|v|^2=\dot x^2+\dot y^2+\dot\theta^2(b_0^2+b_1^2))",
                    cross = R"(2\dot\theta\,(\dot x,\dot y)\cdot\frac{dR}{d\theta}b$)";
  claims.formula(
      "speed_squared", 2901, "the squared speed of each point", samples,
      {.quantity = "$|v|^2$",
       .truth = {by_dual,
                 [](const Sample& s) {
                   const Point v = s.velocity(s.b());
                   return v[0] * v[0] + v[1] * v[1];
                 }},
       .printed = squared(sum + "$", 0),
       .corrected = squared(sum + "+" + cross, 1),
       .near_misses = {squared(sum + "-" + cross, -1)},
       .kind = Fault::formula,
       .root = cross_term,
       .why = R"(The cross term $2\dot\theta\,(\dot x,\dot y)\cdot\frac{dR}{d\theta}b$ is missing. A )"
              R"(wheel that rolls shows it: with $\dot x=1$, $\dot\theta=-1$ and $b=(0,-1)$ at )"
              R"($\theta=0$ the point rests, and the formula gives 2. The term vanishes in the integral )"
              R"(alone, because $\int b\,\delta\,ds=0$; the kinetic energy that follows is right.)"});
  const Reader by_integral{R"($\int\frac12|v|^2\delta\,ds$, $v$ by dual numbers)",
                           [](const Sample& s) { return integrated_energy(s, 0.5); }};
  claims.formula("kinetic_energy_formula", 2905, R"($T$ by $\mu_0$ and $\mu_2$)", samples,
                 {.quantity = "$T$",
                  .truth = by_integral,
                  .printed = {R"($\frac{\mu_0}2(\dot x^2+\dot y^2)+\frac{\mu_2}2\dot\theta^2$)",
                              [](const Sample& s) { return energy(s, s.mu2()); }},
                  .near_misses = {
                      {R"($\mu_2$ about the start of the curve)",
                       [](const Sample& s) {
                         return energy(s, s.mu2({-s.center[0], -s.center[1]}));
                       }},
                      {R"($\mu_2$ for $\mu_2/2$)", [](const Sample& s) { return energy(s, 2 * s.mu2()); }}}});
  claims.add("mu2", 2915, R"($\mu_2$ is the integral of $|b|^2\delta$)",
             {.printed = against_primitives(R"($\mu_2=\int|b|^2\delta\,ds$, $b$ from the center of mass)", 3,
                                            true, true, seed),
              .near_misses = {against_primitives(
                  R"($\mu_2=\int|b|^2\delta\,ds$, $b$ from the start of the curve)", 3, false, true, seed)}});
  claims.formula(
      "only_differences", 2923, R"(nothing but $\mu_0$ and $\mu_2$ tells the curve from a rod)", samples,
      {.quantity = "$T$",
       .truth = by_integral,
       .printed = {R"(of a rod with the same $\mu_0$ and $\mu_2$)",
                   [](const Sample& s) { return energy_of_rod(s, std::sqrt(12 * s.mu2() / s.mu0)); }},
       .near_misses = {{R"(of a rod with the same $\mu_0$ and length)",
                        [](const Sample& s) { return energy_of_rod(s, s.wire.arc_length(s.wire.end())); }}}});

  const auto slope = [](int coordinate) {
    return Reader{"minus the slope of the total potential energy, by dual numbers",
                  [coordinate](const Sample& s) { return slope_of_potential(s, coordinate); }};
  };
  const auto along = [](const std::string& text, Point d) {
    return Reader{text, [d](const Sample& s) { return generalized(s, [d](Point) { return d; }); }};
  };
  const Reader Fx = along(R"($\int F\cdot\imath\,\delta\,ds$)", {1, 0}),
               Fy = along(R"($\int F\cdot\jmath\,\delta\,ds$)", {0, 1});
  claims.formula("force_x", 2927, "the generalized force $F_x$ of a force $F$ on each unit of mass", samples,
                 {.truth = slope(0), .printed = Fx, .near_misses = {Fy}});
  claims.formula(
      "force_y", 2933, "the generalized force $F_y$", samples,
      {.truth = slope(1),
       .printed = {R"($\int F\cdot\delta\,ds$, a vector)",
                   [=](const Sample& s) { return values(Fx.of(s)[0], Fy.of(s)[0]); }},
       .meant = Fy,
       .near_misses = {Fx},
       .kind = Fault::lost_typography,
       .why = R"(The unit vector $\jmath$ after the dot is lost in the text at hand; line 2931, on $F_x$, )"
              R"(has its $\imath$. Without it what is integrated is the force, a vector, and not its )"
              R"(component.)"});
  const auto turning = [&](const std::string& text, auto direction) {
    return Reading{text,
                   {compare(R"($F_\theta$)",
                            Reader{text,
                                   [=](const Sample& s) {
                                     return generalized(s, [&](Point p) { return direction(s, p); });
                                   }},
                            slope(2), samples)}};
  };
  Reading moment = turning(R"($F_\theta=\int F\cdot\frac{dR}{d\theta}b\,\delta\,ds$)",
                           [](const Sample& s, Point p) { return turned(s, p); });
  moment.checks.push_back(compare(
      R"($(F_x,F_y,F_\theta)$ of gravity)",
      Reader{"the integrals of $(0,-g)$",
             [](const Sample& s) {
               return values(0, -9.81 * s.integrated([](Point, Point) { return 1; }),
                             -9.81 * s.integrated([&](Point p, Point) { return turned(s, p)[1]; }));
             }},
      Reader{R"($(0,-\mu_0g,0)$)", [](const Sample& s) { return values(0, -9.81 * s.mu0, 0); }}, samples));
  claims.add("force_theta", 2939, R"(the generalized force $F_\theta$)",
             {.printed = moment,
              .near_misses = {turning(R"($\int F\cdot Rb\,\delta\,ds$)",
                                      [](const Sample& s, Point p) {
                                        const Value r = placed(s, p);
                                        return Point{r[0] - s.x, r[1] - s.y};
                                      }),
                              turning(R"($\frac{dR}{d\theta}$ at $-\theta$)",
                                      [](const Sample& s, Point p) { return turned(s, p, -1); })}});
  claims.add("numerical_integration", 2945,
             "numerical integration serves for rough friction too, on a moving wire",
             {.printed = friction_moment(seed, 1 << 15), .near_misses = {friction_moment(seed, 2)}});
  claims.add(
      "friction_at_rest", 2945,
      "with rough friction the generalized forces are integrals, which can be computed numerically",
      {.printed = {"for a wire at rest, too", {friction_at_speed("at rest", seed, 0, 0)}},
       .corrected = {"for a wire in motion, whatever its speed; at rest the integrand is $0/0$",
                     {friction_at_speed("a billion times slower", seed, 1e-9, 1),
                      friction_at_speed("a billion times slower, the other way", seed, -1e-9, -1)}},
       .near_misses = {{"half the friction at half the speed",
                        {friction_at_speed("half as fast", seed, 0.5, 0.5)}}},
       .why =
           R"(Rough friction has the direction $-v/|v|$, and a wire at rest has none: every rule that evaluates )"
           R"(the integrand returns NaN. Nor is there a limit: friction of 1 N a kilogram on a rod of 1 m and 2 kg )"
           R"(that turns about its center has a moment of $-0.5$ or $+0.5$ N m, by the sense of the turn, however )"
           R"(slow it is. At rest it takes what holds the rod, up to a bound: that is static friction, which the )"
           R"(integral does not have.)",
       .kind = Fault::left_out,
       .root = at_rest});
  return claims.in_order();
}

std::vector<Root> roots() {
  return {
      {cross_term,
       R"(The lowest point of a wheel that rolls at 1 m/s rests on the ground; by the published formula it slides )"
       R"(at $\sqrt2=1.41$ m/s, and a game that leaves skid marks by the speed of contact has every rolling wheel )"
       R"(leave them.)"},
      {at_rest,
       R"(A rod of 1 m and 2 kg that lies still on ground of 1 N a kilogram gets NaN for its moment in the first )"
       R"(frame; one whose turn has all but stopped gets 0.5 N m to one side or the other, whichever way its last )"
       R"(rounding error turns it.)"}};
}

}  // namespace oddity::ex03_29
