#pragma once

// The claims of exercise 3.17 about the cone, whose base is on the plane z = 0 about the origin, whose vertex
// is at (0, 0, h), and whose density is one.

#include "chapters/03_rigid_body_motion/17_foucault/claims.hpp"

namespace oddity::foucault {

using std::numbers::pi;
using Density = std::function<double(double x, double y, double z)>;

struct ConeSample {
  Cone cone;
  double height;  ///< any, of a plane across
  Sample motion;

  explicit ConeSample(Random& random)
      : cone{random.between(0.5, 2), random.between(0.5, 2)},
        height(random.between(0.1, 0.9) * cone.h),
        motion(random) {
    motion.p.L = cone.L();
  }
  double h() const { return cone.h; }
  double r() const { return cone.r; }
  double mass() const { return pi * r() * r() * h() / 3; }
  double size() const { return mass() * (1 + h() * h() + r() * r()); }
  std::string where() const {
    return "h = " + rounded(h(), 4) + ", r = " + rounded(r(), 4) + ", " + motion.where();
  }
  double rho(double z) const { return r() * (1 - z / h()); }

  /// Over the cone from z = low on, in cylindrical coordinates by Gauss's rule.
  double integral(const Density& f, double low = 0) const {
    const Rule rule = [](FunctionOfOne g, double a, double b) { return gauss_legendre(g, a, b, 24); };
    return nested(
               rule, [&](double z, double t, double s) { return s * f(s * std::cos(t), s * std::sin(t), z); },
               low, h(), [](double) { return 0.0; }, [](double) { return 2 * pi; },
               [](double, double) { return 0.0; }, [&](double z, double) { return rho(z); })
        .value;
  }
  /// The same in the book's Cartesian limits, or with x as wide as y, by QAGS.
  double cartesian_integral(const Density& f, bool square = false) const {
    const Rule rule = [](FunctionOfOne g, double a, double b) { return qags(g, a, b, 1e-12); };
    const auto half = [&](double z, double y) {
      return square ? rho(z) : std::sqrt(std::max(0.0, rho(z) * rho(z) - y * y));
    };
    return nested(
               rule, [&](double z, double y, double x) { return f(x, y, z); }, 0, h(),
               [&](double z) { return -rho(z); }, [&](double z) { return rho(z); },
               [&](double z, double y) { return -half(z, y); }, half)
        .value;
  }
  double along(const std::function<double(double z)>& f) const { return qag(f, 0, h(), 1e-13).value; }
  double over_y(double z, const std::function<double(double y)>& f) const {
    return qags(f, -rho(z), rho(z), 1e-12).value;
  }
  double Ixx() const {
    return integral([](double, double y, double z) { return y * y + z * z; });
  }
  double Izz() const {
    return integral([](double x, double y, double) { return x * x + y * y; });
  }
  double center() const {
    return integral([](double, double, double z) { return z; }) /
           integral([](double, double, double) { return 1.0; });
  }
  /// (a, b, c) in the axes P, Q, R.
  Space<double> in_world(double a, double b, double c) const {
    const auto A = motion.axes();
    return sum(sum(times(a, A.P), times(b, A.Q)), times(c, A.R));
  }
  /// u.J v about the base's center, the cone's axis along R.
  double inertia(const Space<double>& u, const Space<double>& v) const {
    return integral([&](double x, double y, double z) {
      const auto at = in_world(x, y, z);
      return inner(at, at) * inner(u, v) - inner(at, u) * inner(at, v);
    });
  }
  /// Of the swing about the vertex, the cone not turning about its own axis, in the turning axes.
  double kinetic_energy() const {
    const auto spin = outer(motion.axes().R, axis_velocity(motion.q, motion.v));
    return integral([&](double x, double y, double z) {
      const auto u = outer(spin, in_world(x, y, h() - z));
      return inner(u, u) / 2;
    });
  }
};

using C = const ConeSample&;
using W = Version<ConeSample>;

inline Check compare_cones(const std::string& what, const W& left, const W& right, double seed,
                           double relative) {
  Worst worst(what, left.text, right.text);
  Random random(seed);
  const int samples = relative > 1e-13 ? 2 : 3;  // adaptive rules are slow
  for (int i = 0; i < samples; ++i) {
    const ConeSample s(random);
    const Tolerance tolerance{relative * s.size(), "the quadratures' tolerance, relative to the terms"};
    worst.see(left.of(s), right.of(s), tolerance, s.size(), s.where());
  }
  return worst.check();
}

inline Reading cone_reading(const Claim& claim, const W& left, const W& right, double seed, double relative) {
  return {left.text, {compare_cones(claim.says, left, right, seed, relative)}};
}

inline Claim cone_claim(const char* id, int line, const char* what, double seed, const W& printed,
                        const W& truth, const std::vector<W>& near, double relative = 1e-13) {
  Claim claim{std::string("3.17-") + id, line, what};
  claim.printed = cone_reading(claim, printed, truth, seed, relative);
  for (const W& each : near) claim.near_misses.push_back(cone_reading(claim, each, truth, seed, relative));
  return claim;
}

inline double square(double x) { return x * x; }

inline std::vector<Claim> center_of_mass(double seed) {
  const double halving = 1 - 1 / std::cbrt(2.0);
  std::vector<Claim> all;
  all.push_back(cone_claim(
      "cone_mass", 2299, "the cone's volume", seed,
      {"pi r^2 h/3", [](C s) { return values(pi * s.r() * s.r() * s.h() / 3); }},
      {"quadrature", [](C s) { return values(s.integral([](double, double, double) { return 1.0; })); }},
      {{"pi r^2 h/2", [](C s) { return values(pi * s.r() * s.r() * s.h() / 2); }}}));
  const auto first = [](C s, bool high) {
    return s.integral([high](double x, double, double z) { return high ? z : x; });
  };
  all.push_back(cone_claim(
      "center_on_axis", 2305, "the center of mass is on the axis", seed,
      {"the moments of x and y by quadrature",
       [=](C s) { return values(first(s, false), s.integral([](double, double y, double) { return y; })); }},
      {"(0, 0)", [](C) { return values(0, 0); }},
      {{"those of x and z", [=](C s) { return values(first(s, false), first(s, true)); }}}));
  const auto cut = [](int power) {
    return [power](C s) {
      const double left = 1 - s.height / s.h();
      return values(pi * s.r() * s.r() * std::pow(left, power) * (s.h() - s.height) / 3);
    };
  };
  const auto above = [](C s, double z) { return s.integral([](double, double, double) { return 1.0; }, z); };
  all.push_back(cone_claim("upper_part", 2305, "the volume of the part above a plane z", seed,
                           {"pi r^2 (1 - z/h)^2 (h - z)/3", cut(2)},
                           {"quadrature", [=](C s) { return values(above(s, s.height)); }},
                           {{"1 - z/h to the first power", cut(1)}}));
  all.push_back(cone_claim("halving_height", 2315, "the plane z = h (1 - 2^(-1/3)) halves the volume", seed,
                           {"half the volume above it", [](C s) { return values(s.mass() / 2); }},
                           {"quadrature", [=](C s) { return values(above(s, halving * s.h())); }},
                           {{"so does h (1 - 2^(-1/2))", [=](C s) {
                               return values(s.mass() / 2 + above(s, halving * s.h()) -
                                             above(s, (1 - std::sqrt(0.5)) * s.h()));
                             }}}));

  Claim halves = cone_claim("center_halves", 2305, "half the volume lies above the center of mass", seed,
                            {"1/2", [](C s) { return values(s.mass() / 2); }},
                            {"the part above the center of mass, both by quadrature",
                             [=](C s) { return values(above(s, s.center())); }},
                            {{"9/16", [](C s) { return values(s.mass() * 9 / 16); }}});
  halves.corrected = cone_reading(halves, {"27/64", [](C s) { return values(s.mass() * 27 / 64); }},
                                  {"the part above the center of mass, both by quadrature",
                                   [=](C s) { return values(above(s, s.center())); }},
                                  seed, 1e-13);
  halves.why =
      "The center of mass balances moments, not volumes: the parts above and below have equal moments "
      "$\\int (z-\\bar z)\\,dV$. Above it lies $(3/4)^3 = 27/64 = 0.42$ of the cone.";
  all.push_back(halves);

  const W center{"the moment of z by the volume, quadrature", [](C s) { return values(s.center()); }};
  Claim height =
      cone_claim("center_height", 2315, "the center of mass is at the height h (1 - 2^(-1/3)) = 0.2063 h",
                 seed, {"h (1 - 2^(-1/3)) = 0.2063 h", [=](C s) { return values(halving * s.h()); }}, center,
                 {{"h/3", [](C s) { return values(s.h() / 3); }}});
  height.corrected =
      cone_reading(height, {"h/4", [](C s) { return values(s.h() / 4); }}, center, seed, 1e-13);
  height.why = "$0.2063\\,h$ is where the volume is halved; the center of mass is at $h/4$.";
  all.push_back(height);

  const W below{"from the vertex to the center of mass, quadrature",
                [](C s) { return values(s.h() - s.center()); }};
  Claim L = cone_claim("L", 2319, "L = h/2^(1/3) from the joint, which is the vertex, to the center of mass",
                       seed, {"h/2^(1/3)", [](C s) { return values(s.h() / std::cbrt(2.0)); }}, below,
                       {{"2h/3", [](C s) { return values(2 * s.h() / 3); }}});
  L.corrected = cone_reading(L, {"3h/4", [](C s) { return values(3 * s.h() / 4); }}, below, seed, 1e-13);
  L.why = "$L = 3h/4 = 0.75\\,h$, not $0.7937\\,h$: the volume was halved, not its moment.";
  all.push_back(L);

  Claim decimals{"3.17-L_decimals", 2321, "2^(-1/3) is 0.7937"};
  const auto digits = [](double x) {
    return Reading{rounded(x, 4),
                   {{"2^(-1/3)", {"as printed", x}, {"cube root", 1 / std::cbrt(2.0)}, printed_decimals(4)}}};
  };
  decimals.printed = digits(0.7937);
  decimals.near_misses = {digits(0.7938)};
  all.push_back(decimals);
  return all;
}

inline std::vector<Claim> moments(double seed) {
  std::vector<Claim> all;
  const W Ixx{"quadrature in cylindrical coordinates", [](C s) { return values(s.Ixx()); }};
  const auto y2z2 = [](double, double y, double z) { return y * y + z * z; };
  all.push_back(cone_claim(
      "Ixx_limits", 2329, "Ixx as a triple integral, and its limits", seed,
      {"y^2 + z^2 over |x| < sqrt(rho^2 - y^2), |y| < rho, 0 < z < h",
       [=](C s) { return values(s.cartesian_integral(y2z2)); }},
      Ixx, {{"over |x| < rho", [=](C s) { return values(s.cartesian_integral(y2z2, true)); }}}, 1e-12));
  const auto width = [](C s, double z, double y) {
    return std::sqrt(std::max(0.0, square(s.rho(z)) - y * y));
  };
  const auto after_x = [=](double factor) {
    return [=](C s) {
      return values(s.along([&](double z) {
        return s.over_y(z, [&](double y) { return factor * (y * y + z * z) * width(s, z, y); });
      }));
    };
  };
  all.push_back(cone_claim("Ixx_after_x", 2335, "Ixx after integrating over x", seed,
                           {"2 (y^2 + z^2) sqrt(rho^2 - y^2)", after_x(2)}, Ixx,
                           {{"without the 2", after_x(1)}}, 1e-12));
  const auto split = [=](double factor) {
    return [=](C s) {
      return values(s.along([&](double z) {
        return s.over_y(z, [&](double y) { return 2 * y * y * width(s, z, y); }) +
               z * z * s.over_y(z, [&](double y) { return factor * width(s, z, y); });
      }));
    };
  };
  Claim parts =
      cone_claim("Ixx_split", 2341, "Ixx split into two integrals over y", seed,
                 {"2 y^2 sqrt(...) and z^2 times sqrt(...)", split(1)}, Ixx,
                 {{"2 before neither",
                   [=](C s) { return values(split(1)(s)[0] / 2 + (split(1)(s)[0] - split(0)(s)[0]) / 2); }}},
                 1e-12);
  parts.meant = cone_reading(parts, {"2 sqrt(...) in the second, too", split(2)}, Ixx, seed, 1e-12);
  parts.says =
      "of the two integrals over y that make Ixx the first has 2 y^2 sqrt(...), the second sqrt(...)";
  parts.why =
      "The factor 2 of the line before is lost in the second integral; $\\int\\sqrt{\\rho^2-y^2}\\,dy = "
      "\\pi\\rho^2/2$, and the next line, with $\\pi\\rho^2z^2$, has it again.";
  all.push_back(parts);
  const auto over_z = [](double factor) {
    return [factor](C s) {
      return values(s.along(
          [&](double z) { return pi * std::pow(s.rho(z), 4) * factor + pi * square(s.rho(z)) * z * z; }));
    };
  };
  all.push_back(cone_claim("Ixx_over_z", 2355, "Ixx as an integral over z", seed,
                           {"pi rho^4/4 + pi rho^2 z^2", over_z(0.25)}, Ixx, {{"pi rho^4/2", over_z(0.5)}}));
  const auto factored = [](int power) {
    return [power](C s) {
      return values(pi * s.along([&](double z) {
        const double u = 1 - z / s.h();
        return std::pow(s.r() * u, 4) / 4 + std::pow(s.r(), power) * square(z * u);
      }));
    };
  };
  Claim out = cone_claim("Ixx_factored", 2357, "Ixx with pi before the integral", seed,
                         {"r^4 (1 - z/h)^4/4 + z^2 (1 - z/h)^2", factored(0)}, Ixx,
                         {{"r z^2 (1 - z/h)^2", factored(1)}});
  out.meant = cone_reading(out, {"r^2 z^2 (1 - z/h)^2", factored(2)}, Ixx, seed, 1e-13);
  out.says = "Ixx is pi times the integral of r^4 (1 - z/h)^4/4 + z^2 (1 - z/h)^2";
  out.why =
      "The second term is $\\rho^2z^2 = r^2z^2(1-z/h)^2$; its $r^2$ is lost, and back in the next line.";
  all.push_back(out);
  const auto closed = [](double by) {
    return [by](C s) {
      return values(pi * s.r() * s.r() * s.h() * (2 * s.h() * s.h() + 3 * s.r() * s.r()) * by);
    };
  };
  Claim whole = cone_claim("Ixx_closed", 2363, "Ixx in closed form", seed,
                           {"pi r^2 h (2h^2 + 3r^2) 60", closed(60)}, Ixx, {{"/30", closed(1.0 / 30)}});
  whole.meant = cone_reading(whole, {"pi r^2 h (2h^2 + 3r^2)/60", closed(1.0 / 60)}, Ixx, seed, 1e-13);
  whole.says = "Ixx = pi r^2 h (2h^2 + 3r^2) 60";
  whole.why = "The bar over 60 is lost.";
  all.push_back(whole);
  const auto by_mass = [](double a, double b, double by) {
    return [=](C s) { return values(s.mass() * (a * s.h() * s.h() + b * s.r() * s.r()) / by); };
  };
  all.push_back(cone_claim("Ixx", 2365, "Ixx by the mass, about the base's center", seed,
                           {"m (2h^2 + 3r^2)/20", by_mass(2, 3, 20)}, Ixx,
                           {{"m (3h^2 + 2r^2)/20", by_mass(3, 2, 20)}}));
  all.push_back(cone_claim(
      "Iyy", 2371, "Iyy is Ixx", seed, {"m (2h^2 + 3r^2)/20", by_mass(2, 3, 20)},
      {"quadrature",
       [](C s) { return values(s.integral([](double x, double, double z) { return x * x + z * z; })); }},
      {{"m 3r^2/10", by_mass(0, 3, 10)}}));
  const auto products = [](bool all_three) {
    return [all_three](C s) {
      return values(s.integral([=](double x, double y, double) { return all_three ? x * y : x * x; }),
                    s.integral([](double x, double, double z) { return x * z; }),
                    s.integral([](double, double y, double z) { return y * z; }));
    };
  };
  all.push_back(cone_claim("products", 2375, "the products of inertia are zero", seed,
                           {"of xy, xz, yz by quadrature", products(true)},
                           {"(0, 0, 0)", [](C) { return values(0, 0, 0); }},
                           {{"of xx, xz, yz", products(false)}}));
  const auto cylindrical = [](int power) {
    return [power](C s) {
      return values(s.along([&](double z) {
        return 2 * pi * gauss_legendre([&](double u) { return std::pow(u, power); }, 0, s.rho(z), 8).value;
      }));
    };
  };
  all.push_back(cone_claim(
      "Izz_cylindrical", 2389, "Izz in cylindrical coordinates", seed, {"s^3 ds dtheta dz", cylindrical(3)},
      {"x^2 + y^2 in Cartesian coordinates by QAGS",
       [](C s) {
         return values(s.cartesian_integral([](double x, double y, double) { return x * x + y * y; }));
       }},
      {{"s^2 ds dtheta dz", cylindrical(2)}}, 1e-12));
  const W Izz{"quadrature", [](C s) { return values(s.Izz()); }};
  const auto turning = [](double by) {
    return [by](C s) { return values(pi * std::pow(s.r(), 4) * s.h() * by); };
  };
  Claim spin = cone_claim("Izz_closed", 2393, "Izz in closed form", seed, {"pi r^4 h 10", turning(10)}, Izz,
                          {{"/5", turning(0.2)}});
  spin.meant = cone_reading(spin, {"pi r^4 h/10", turning(0.1)}, Izz, seed, 1e-13);
  spin.says = "Izz = pi r^4 h 10";
  spin.why = "The bar over 10 is lost.";
  all.push_back(spin);
  all.push_back(cone_claim("Izz", 2395, "Izz by the mass", seed, {"m 3r^2/10", by_mass(0, 3, 10)}, Izz,
                           {{"m 3r^2/5", by_mass(0, 3, 5)}}));
  return all;
}

inline std::vector<Claim> tensor(double seed) {
  std::vector<Claim> all;
  const auto six = [](const auto& entry) {
    const Space<double> e[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return values(entry(e[0], e[0]), entry(e[1], e[1]), entry(e[2], e[2]), entry(e[0], e[1]),
                  entry(e[0], e[2]), entry(e[1], e[2]));
  };
  const auto by_axes = [=](bool swapped) {
    return [=](C s) {
      const double x = s.Ixx(), z = s.Izz();
      const auto A = s.motion.axes();
      return six([&](const auto& u, const auto& v) {
        return (swapped ? z : x) * (inner(A.P, u) * inner(A.P, v) + inner(A.Q, u) * inner(A.Q, v)) +
               (swapped ? x : z) * inner(A.R, u) * inner(A.R, v);
      });
    };
  };
  all.push_back(
      cone_claim("J_world", 2417, "J in world coordinates, about the base's center", seed,
                 {"Ixx (P P^T + Q Q^T) + Izz R R^T", by_axes(false)},
                 {"quadrature over the turned cone",
                  [=](C s) { return six([&](const auto& u, const auto& v) { return s.inertia(u, v); }); }},
                 {{"Ixx and Izz exchanged", by_axes(true)}}));
  all.push_back(cone_claim("principal", 2297, "P, Q and R are principal directions", seed,
                           {"(P.JR, Q.JR, P.JQ) by quadrature",
                            [](C s) {
                              const auto A = s.motion.axes();
                              return values(s.inertia(A.P, A.R), s.inertia(A.Q, A.R), s.inertia(A.P, A.Q));
                            }},
                           {"(0, 0, 0)", [](C) { return values(0, 0, 0); }},
                           {{"for (P + R)/sqrt 2 and (P - R)/sqrt 2", [](C s) {
                               const auto A = s.motion.axes();
                               return values((s.inertia(A.P, A.P) - s.inertia(A.R, A.R)) / 2,
                                             s.inertia(A.P, A.Q), 0);
                             }}}));
  const W direct{"w.J w by quadrature", [](C s) { return values(s.inertia(s.motion.w(), s.motion.w())); }};
  const auto by_parts = [=](bool once) {
    return [=](C s) {
      const auto A = s.motion.axes();
      const auto w = s.motion.w();
      return values(s.Ixx() * ((once ? 0 : 1) * square(inner(A.P, w)) + square(inner(A.Q, w))) +
                    s.Izz() * square(inner(A.R, w)));
    };
  };
  all.push_back(cone_claim("wJw", 2421, "w.J w by the components along P, Q, R", seed,
                           {"Ixx ((P.w)^2 + (Q.w)^2) + Izz (R.w)^2", by_parts(false)}, direct,
                           {{"without (P.w)^2", by_parts(true)}}));
  const auto expanded = [](double up, bool west) {
    return [=](C s) {
      const auto& p = s.motion.p;
      const double c = std::cos(p.lambda), l = up * std::sin(p.lambda), f = s.motion.q[1];
      const double st = west ? std::cos(s.motion.q[0]) : std::sin(s.motion.q[0]);
      const double ct = west ? std::sin(s.motion.q[0]) : std::cos(s.motion.q[0]);
      return values(square(p.omega) *
                    (s.Ixx() * (square(c * ct) + square(c * st * std::cos(f) + l * std::sin(f))) +
                     s.Izz() * square(c * st * std::sin(f) - l * std::cos(f))));
    };
  };
  all.push_back(cone_claim(
      "wJw_angles", 2425, "w.J w in the angles, w = omega (cos lambda north - sin lambda down)", seed,
      {"as printed", expanded(1, false)}, direct,
      {{"sin lambda flipped", expanded(-1, false)}, {"cos lambda to the west", expanded(1, true)}}));

  const W about_center{
      "quadrature about the center of mass", [](C s) {
        const double z0 = s.center();
        return values(s.integral([=](double, double y, double z) { return y * y + square(z - z0); }));
      }};
  Claim moment = cone_claim(
      "J_in_T", 2401, "J, added to the energy of the center of mass, has Ixx = m (2h^2 + 3r^2)/20", seed,
      {"m (2h^2 + 3r^2)/20",
       [](C s) { return values(s.mass() * (2 * square(s.h()) + 3 * square(s.r())) / 20); }},
      about_center, {{"3m (h^2 + 2r^2)/80", [](C s) {
                        return values(s.mass() * 3 * (square(s.h()) + 2 * square(s.r())) / 80);
                      }}});
  moment.corrected =
      cone_reading(moment,
                   {"3m (h^2 + 4r^2)/80",
                    [](C s) { return values(s.mass() * 3 * (square(s.h()) + 4 * square(s.r())) / 80); }},
                   about_center, seed, 1e-13);
  moment.why =
      "The integrals are about the center of the base. With $m|v|^2/2$ of the center of mass belongs the "
      "tensor about the center of mass, $I_{xx} = 3m(h^2+4r^2)/80$, less by $m(h/4)^2$.";
  all.push_back(moment);

  const W swing{"|velocity|^2/2 integrated over a cone that hangs by its vertex and swings",
                [](C s) { return values(s.kinetic_energy()); }};
  const auto energy = [](bool book_values, double turning, double earth) {
    return [=](C s) {
      const Cone& k = s.cone;
      const BookCone c = book_values ? book_cone(k) : BookCone{k.L(), k.across(), 3 * k.r * k.r / 10};
      BookEnergy T{c, s.motion.w(), turning};
      T.w = times(earth, T.w);
      return values(s.mass() * T(s.motion.q, s.motion.v));
    };
  };
  Claim cone{"3.17-cone_energy", 2287, "the cone has the kinetic energy m |v|^2/2 + w.J w/2"};
  cone.printed =
      cone_reading(cone, {"m |v|^2/2 + w.J w/2, w the Earth's", energy(true, 0, 1)}, swing, seed, 1e-13);
  cone.corrected = cone_reading(
      cone,
      {"m |v|^2/2 + W.J W/2, W = R x R' the cone's own turning, J about its center", energy(false, 1, 0)},
      swing, seed, 1e-13);
  cone.near_misses = {
      cone_reading(cone, {"as printed, with L = 3h/4 and J about the center", energy(false, 0, 1)}, swing,
                   seed, 1e-13),
      cone_reading(cone, {"m |v|^2/2 alone", energy(false, 0, 0)}, swing, seed, 1e-13)};
  cone.why =
      "The cone turns as it swings: its angular velocity on the Earth is $R\\times\\dot R$, "
      "not $w$, and its energy has $\\frac12 I_{xx}(\\dot\\theta^2\\sin^2\\phi+\\dot\\phi^2)$. What the text "
      "adds, "
      "$\\frac12 w^TJw$, has no velocities in it and is of order $\\omega^2$: like the centrifugal force, "
      "which "
      "the equations leave out.";
  all.push_back(cone);
  return all;
}

inline Claim cone_equations(double seed) {
  const auto residual = [](const auto& T, double lever_squared) {
    return [=](C s) {
      const auto& m = s.motion;
      const double L = T(s).L;
      Pair force = coriolis(std::sqrt(lever_squared < 0 ? L * L : s.cone.L() * s.cone.equivalent_length()),
                            m.w(), m.q, m.v);
      force[1] -= m.p.g * L * m.sin_phi();
      return Value(euler_lagrange(T(s), m.q, m.v, m.a) - force);
    };
  };
  const auto book = [](C s) { return BookEnergy{book_cone(s.cone), s.motion.w()}; };
  const auto swinging = [](C s) {
    const Cone& k = s.cone;
    return BookEnergy{{k.L(), k.across(), 3 * k.r * k.r / 10}, {0, 0, 0}, 1};
  };
  const W truth{"Lagrange's equations of a point mass at (L^2 + Ixx)/L on the turning Earth, linear in omega",
                [](C s) {
                  Sample point = s.motion;
                  point.m = 1;
                  point.p.L = s.cone.equivalent_length();
                  const Pair e = point.to_first_order();
                  const double scale = s.cone.L() / point.p.L;
                  return values(scale * e[0], scale * e[1]);
                }};
  const auto reading = [&](const std::string& text, const auto& T, double lever) {
    Worst worst("d/dt dT/dq' - dT/dq - F, for theta and phi", text, truth.text, 512);
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
      const ConeSample s(random);
      worst.see(residual(T, lever)(s), truth.of(s), s.motion.size(), s.where());
    }
    return Reading{text, {worst.check()}};
  };
  Claim claim{"3.17-cone_equations", 2429, "the cone's equations are those of the point with w.J w/2 in T"};
  claim.printed = reading("the derivatives of w.J w/2 appended", book, -1);
  claim.corrected =
      reading("L^2 + Ixx for L^2, Ixx about the center of mass, in T and in the Coriolis force", swinging, 1);
  claim.near_misses = {reading("L^2 + Ixx in T, the Coriolis force that of a point", swinging, -1)};
  claim.why =
      "To first order in $\\omega$ the appended terms vanish, and the cone's own inertia is missing. It "
      "swings as "
      "a point mass at $(L^2+I_{xx}/m)/L = \\frac45h + r^2/(5h)$, its center of oscillation; the published "
      "equations put the point at $0.7937\\,h$. With $h=r$ that swings 12 % too fast: the default cone's "
      "axis, a unit vector, is off by 0.42 within 16 s.";
  return claim;
}

}  // namespace oddity::foucault
