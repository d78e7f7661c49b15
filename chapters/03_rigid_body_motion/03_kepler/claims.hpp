#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/03_rigid_body_motion/03_kepler/kepler.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/quadrature.hpp"

/// The published lines of exercise 3.3, judged on random orbits. What is true comes from Newton's law alone:
/// the path is integrated in Cartesian coordinates, its acceleration is the slope of G M/|r| by dual numbers,
/// and r, theta, V with their derivatives are taken along it by second-order dual numbers. The constants of
/// equation (3) are found from two later positions on the path, not from the start.
namespace oddity::kepler {

using std::cos, std::sin, std::sqrt, std::abs, std::pow, std::numbers::pi;

using Twice = Dual<Dual<double>>;

/// Distance and angle along a path, with two derivatives in time.
struct Path {
  Twice r, theta;

  Path(const std::array<double, 2>& q, const std::array<double, 2>& v, const std::array<double, 2>& a) {
    const Twice t(Dual<double>(0, 1), Dual<double>(1, 0));
    const Twice x = Twice(q[0]) + t * (Twice(v[0]) + t * Twice(a[0] / 2));
    const Twice y = Twice(q[1]) + t * (Twice(v[1]) + t * Twice(a[1] / 2));
    r = sqrt(x * x + y * y);
    theta = atan2(y, x);
  }
};

/// The slope of G M/|r| in each direction of space.
template <std::size_t N>
std::array<double, N> gravity(double mu, const std::array<double, N>& q) {
  std::array<double, N> a{};
  for (std::size_t i = 0; i < N; ++i) {
    Dual<double> square = 0.0;
    for (std::size_t j = 0; j < N; ++j) {
      const Dual<double> z(q[j], i == j ? 1 : 0);
      square += z * z;
    }
    a[i] = (mu / sqrt(square)).slope;
  }
  return a;
}

/// A random orbit at a later time.
struct Sample {
  Start s;
  double m;                         ///< the planet's mass
  double t, theta, x, y, vx, vy;    ///< the angle goes on beyond a turn
  std::array<double, 2> a, pushed;  ///< by gravity; by something else
  Path p, free;                     ///< with the one and with the other
  double c0, c1;                    ///< of equation (3), from two other positions

  double mean() const { return pow(s.mu() / s.h(), 2); }  ///< G^2 M^4/alpha^2
  double distance_at(double angle) const { return -s.mu() / (c0 * sin(angle) + c1 * cos(angle) - mean()); }
  /// The time from one angle to another, dt = r^2 d theta/h.
  double time_between(double from, double to) const {
    return qag([&](double angle) { return pow(distance_at(angle), 2) / s.h(); }, from, to, 1e-13).value;
  }
  std::string shown() const {
    return "G = " + shortest(s.G) + ", M = " + shortest(s.M) + ", r0 = " + shortest(s.r0) +
           ", r0' = " + shortest(s.r0_dot) + ", theta0 = " + shortest(s.theta0) +
           ", theta0' = " + shortest(s.theta0_dot) + ", t = " + shortest(t);
  }
};

/// A start at `transverse` and `radial` times the circular speed.
inline Start random_start(Random& random, double transverse, double radial) {
  const double G = abs(random.magnitude(0.2, 5)), M = abs(random.magnitude(0.2, 5));
  const double r0 = abs(random.magnitude(0.3, 3)), circular = sqrt(G * M / r0);
  return {G, M, r0, radial * circular, random.between(-pi, pi), transverse * circular / r0};
}

/// Bound orbits of eccentricity up to 0.95, of either sense, each followed in so many pieces.
constexpr std::size_t pieces = 64;

inline std::vector<Sample> samples(double seed) {
  Random random(seed);
  std::vector<Sample> all;
  for (int i = 0; i < 40; ++i) {
    const Start s =
        random_start(random, random.between(0.5, 1.3) * (i % 4 ? 1 : -1), random.between(-0.5, 0.5));
    const double span = sqrt(pow(s.r0, 3) / s.mu()), end = random.between(3, 6) * span;
    std::vector<double> times(pieces + 1), angles(pieces + 1, s.theta0);
    for (std::size_t j = 0; j <= pieces; ++j) times[j] = end * static_cast<double>(j) / pieces;
    const Cartesian<double> model{s};
    const auto states =
        ode::integrate<ode::Fehlberg78>(model, model.start(), std::span<const double>(times), 1e-13).value;
    if (states.size() != times.size()) throw std::runtime_error("a sample orbit was not integrated");
    for (std::size_t j = 1; j <= pieces; ++j) {
      const auto &from = states[j - 1], &to = states[j];
      angles[j] =
          angles[j - 1] + std::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
    }
    const std::array q{states.back()[0], states.back()[1]}, v{states.back()[2], states.back()[3]};
    const std::array pushed{random.normal(), random.normal()};
    const auto a = gravity(s.mu(), q);
    Sample k{s,
             abs(random.magnitude(1e-3, 1e3)),
             end,
             angles.back(),
             q[0],
             q[1],
             v[0],
             v[1],
             a,
             pushed,
             Path(q, v, a),
             Path(q, v, pushed),
             0,
             0};
    double best = 0;
    for (std::size_t one = pieces / 8; one < pieces; one += pieces / 8)
      for (std::size_t two = one + pieces / 8; two < pieces; two += pieces / 8) {
        const double determinant = sin(angles[one] - angles[two]);
        if (abs(determinant) <= best) continue;
        best = abs(determinant);
        const double v1 = k.mean() - s.mu() / std::hypot(states[one][0], states[one][1]);
        const double v2 = k.mean() - s.mu() / std::hypot(states[two][0], states[two][1]);
        k.c0 = (v1 * cos(angles[two]) - v2 * cos(angles[one])) / determinant;
        k.c1 = (v2 * sin(angles[one]) - v1 * sin(angles[two])) / determinant;
      }
    all.push_back(std::move(k));
  }
  return all;
}

// ---- the lines --------------------------------------------------------------------------------------------

/// What becomes of the other form that every line has: a near miss, what was meant, or what is true.
enum class Other { near_miss, meant, corrected };

struct Line {
  std::string_view slug;
  int number;
  std::string_view says;
  std::string_view from_path, as_written;  ///< the two routes that are compared
  std::string_view other;
  Other as = Other::near_miss;
  std::string_view why = {};
  std::string_view miss = {};  ///< the near miss of a line that is not confirmed
};

/// Lines about one moment of the motion.
constexpr Line at_one_moment[] = {
    {"unit_vector", 945, "r = r R, and R is of length 1 and points from the sun to the planet",
     "the planet's coordinates", "r R", "R is P"},
    {"acceleration", 949, "a = (r'' - r theta'^2) R + (r theta'' + 2 r' theta') P", "any acceleration",
     "its polar form, derivatives by dual numbers", "+ r theta'^2"},
    {"equation_number", 949, "equation (3.2) is the polar form of any acceleration", "any acceleration",
     "what follows from equation (3.2)",
     "another equation is it: a = (r'' - r theta'^2) R + (r theta'' + 2 r' theta') P", Other::meant,
     "Exercise 3.1 (857) and the end of this one (1229) give the number (3.2) to the orbit, "
     "$r=e\\rho/(1+e\\cos\\theta)$, which knows no acceleration but $-GM/r^2$ towards the sun. The polar "
     "form "
     "is another equation of the book: whoever looks (3.2) up for it finds the orbit.",
     "that other equation, r' theta' without its 2"},
    {"gravity", 953, "a = -GM r^3 r (the distance cubed, times the vector) = -GM r^2 R = -(GM/r^2) R + 0 P",
     "slope of GM/|r| by dual numbers", "the two products", "-(GM/r^3) r and -(GM/r^2) R", Other::meant,
     "The fraction bars are lost: read as they stand, $GMr^3$ and $GMr^2$ make a planet twice as far away "
     "feel "
     "four times the pull instead of a quarter of it. The last form of the line has its bar.",
     "+(GM/r^3) r and +(GM/r^2) R"},
    {"radial", 967, "r'' - r theta'^2 = -GM r^2", "r'' - r theta'^2 by dual numbers", "the right-hand side",
     "-GM/r^2", Other::meant, "The fraction bar is lost; equation (2), made from this line, has it.",
     "-GM/r^3"},
    {"transverse", 967, "r theta'' + 2 r' theta' = 0", "r theta'' by dual numbers", "-2 r' theta'",
     "r theta'' + r' theta'"},
    {"areal", 973, "r (r theta'' + 2 r' theta') = r^2 theta'' + 2 r r' theta' = d/dt (r^2 theta')",
     "r times the transverse acceleration, and x y'' - y x''", "r^2 theta'' + 2 r r' theta'",
     "r^2 theta'' + r r' theta'"},
    {"angular_momentum", 979, "alpha = M r^2 theta' is the angular momentum",
     "dL/d theta' by dual numbers, L = T - V of a planet of mass m", "M r^2 theta'",
     "m r^2 theta', m the planet's mass", Other::corrected,
     "$M$ is the mass that attracts, the sun's: $\\partial L/\\partial\\theta'$ is $mr^2\\theta'$ with the "
     "mass of the planet, for the Earth 1/333000 of it. $\\alpha$ is constant all the same, and every later "
     "line uses no more than that: only $\\alpha/M = r^2\\theta'$ ever enters.",
     "m r theta'"},
    {"radial_equation", 995,
     "-GM/r^2 = r'' - r theta'^2 = r'' - r (alpha/(M r^2))^2 = r'' - alpha^2/(M^2 r^3) (2)", "-GM/r^2",
     "the three forms, r'' by dual numbers", "+ alpha^2/(M^2 r^3)"},
    {"singular", 1007, "the right-hand side of (2) has a singularity at r = 0, here: of the third order",
     "r'' at 1e-6 of the distance with the same alpha, over r'' at twice that: Cartesian, by dual numbers",
     "2^3", "of the second order"},
    {"potential_energy", 1009, "V = -GM/r is the potential energy",
     "force on a planet of mass m, by dual numbers", "-dV/dr",
     "-GM/r is the potential energy per unit mass of the planet", Other::corrected,
     "The force on a planet of mass $m$ is $-GMm/r^2$; $-GM/r$ is its energy divided by $m$. With "
     "$\\alpha=Mr^2\\theta'$ the text divides the momentum by $m$ and multiplies it by $M$, so that $V$ and "
     "$\\alpha$ belong to different masses; the orbit depends on neither, only a display of energies in "
     "joules "
     "is off by the factor $m$.",
     "times half the planet's mass"},
    {"power_rule", 1017, "r' = d/dt (-GM V) = (GM/V^2) dV/dt", "r' by dual numbers",
     "the derivative of the product by dual numbers, and (GM/V^2) dV/dt", "d/dt (-GM/V) = (GM/V^2) dV/dt",
     Other::meant,
     "The fraction bar of $-GM/V$ is lost. The product $-GMV=G^2M^2/r$ is no distance, and shrinks where the "
     "distance grows.",
     "(GM/V) dV/dt"},
    {"chain_rule", 1023, "= GM V^2 (dV/d theta) theta'", "r' by dual numbers", "the product",
     "(GM/V^2) (dV/d theta) theta'", Other::meant,
     "The fraction bar is lost; the line before has it. For the Earth, in astronomical units and years, the "
     "product $GMV^2$ is 61500 where the quotient is 0.025.",
     "the quotient without theta'"},
    {"r_dot", 1031, "= GM (-GM/r)^2 V' (alpha M r^2) = alpha V'/(G M^2)", "r' by dual numbers",
     "the product, and the last form", "GM/(-GM/r)^2 V' alpha/(M r^2) = alpha V'/(G M^2)", Other::meant,
     "The bars of the first form's two fractions are lost. As products the powers of $r$ cancel as well, and "
     "what is left is $G^3M^4\\alpha V'$ for $\\alpha V'/(GM^2)$.",
     "alpha V'/(G M)"},
    {"second_chain_rule", 1041, "r'' = alpha G M^2 dV'/dt = alpha G M^2 V'' theta'", "r'' by dual numbers",
     "the two products", "alpha/(G M^2) dV'/dt = alpha/(G M^2) V'' theta'", Other::meant,
     "The fraction bar is lost, here and in line 1049: line 1037, which is differentiated, has it.",
     "V' theta'"},
    {"r_dot_dot", 1055, "= alpha G M^2 V'' (alpha M r^2) = alpha^2 V''/(G M^3 r^2)", "r'' by dual numbers",
     "the product, and the last form", "alpha/(G M^2) V'' alpha/(M r^2) = alpha^2 V''/(G M^3 r^2)",
     Other::meant,
     "The bars of $\\alpha/(GM^2)$ and of $\\dot\\theta=\\alpha/(Mr^2)$ are lost; the last form of the line "
     "has one for both.",
     "alpha^2 V''/(G M^2 r^2)"},
    {"r_dot_dot_by_V", 1063, "= alpha^2 V''/(G M^3 (-GM/V)^2) = alpha^2 V'' V^2/(G^3 M^5)",
     "r'' by dual numbers", "the two forms", "alpha^2 V'' V^2/(G^3 M^4)"},
    {"substituted", 1077, "-GM (-GM/V)^2 = alpha^2 V'' V^2/(G^3 M^5) - alpha^2/(M^2 (-GM/V)^3)",
     "the two terms on the right, V'' by dual numbers", "the product on the left", "-GM/(-GM/V)^2",
     Other::meant,
     "The bar of the left side is lost, as at line 953: $GM(-GM/V)^2$ is $GMr^2$, a pull that grows with the "
     "distance. The next line, $-V^2/(GM)$, is the quotient.",
     "+GM/(-GM/V)^2"},
    {"simplified", 1083, "-V^2/(GM) = alpha^2 V'' V^2/(G^3 M^5) + alpha^2 V^3/(G^3 M^5)", "-V^2/(GM)",
     "the other two terms, V'' by dual numbers", "- alpha^2 V^3/..."},
    {"potential_equation", 1091, "-G^2 M^4/alpha^2 = V'' + V", "-G^2 M^4/alpha^2",
     "V'' + V, V'' by dual numbers", "V'' - V"},
    {"characteristic", 1095, "lambda^2 + 1 = 0 has the roots +-i",
     "V'' on the path, by dual numbers (real and imaginary part)",
     "lambda^2 (V + G^2 M^4/alpha^2) for a root lambda", "+-1"},
    {"independent", 1095, "sin and cos solve V'' + V = 0, linearly independent",
     "Wronski's determinant by dual numbers", "-1, which is not zero", "zero: sin and sin(theta + pi)"},
    {"particular", 1101, "V_p = -G^2 M^4/alpha^2 has V_p'' + V_p = 0 - G^2 M^4/alpha^2",
     "(V, V', V'') on a circle, where V is constant, by dual numbers", "(-G^2 M^4/alpha^2, 0, 0)",
     "+ G^2 M^4/alpha^2"},
    {"rate_by_V", 1201, "theta' = alpha/(M r^2) = alpha/(M (-GM/V)^2) = alpha V^2/(G^2 M^3) (6)",
     "theta' by dual numbers", "the three forms", "alpha V^2/(G^2 M^2)"},
    {"velocity", 1235, "v = r' R + r theta' P", "the path's velocity",
     "its polar form, r' and theta' by dual numbers", "r' R - r theta' P"},
    {"moment", 1237, "r x v = (r R) x (r' R + r theta' P) = r^2 theta' k", "x y' - y x'", "the two forms",
     "r theta' k"},
    {"v_cross_c0", 1245,
     "v x c0 = (r' R + r theta' P) x (r^2 theta') k = (r^2 r' theta') R x k + (r^3 theta'^2) P x k = -(r^2 "
     "r' theta') P + (r^3 theta'^2) R",
     "v x c0 in Cartesian coordinates", "the three forms", "+ (r^2 r' theta') P"},
};

/// Lines that take a later moment from the start.
constexpr Line from_the_start[] = {
    {"conserved", 979, "r^2 theta' is constant, and so is alpha = M r^2 theta' = M r0^2 theta0'",
     "r^2 theta' and M r^2 theta' later on the path", "r0^2 theta0' and M r0^2 theta0'", "r0 theta0'"},
    {"rate", 981, "theta' = alpha/(M r^2) = r0^2 theta0' r^2 (1)", "theta' later on the path",
     "alpha/(M r^2) and the product", "alpha/(M r^2) = r0^2 theta0'/r^2", Other::meant,
     "The bar of the second fraction is lost: as it stands, a planet that has come to twice its distance "
     "goes "
     "round four times as fast, and not at a quarter of its rate. The first form has its bar.",
     "r0 theta0'/r"},
    {"invertible", 987, "t is a function of theta, and r(f^-1(theta)) is the distance as a function of theta",
     "t and r later on the path", "the integral of r^2/h over theta, and r(theta)",
     "a function at half the angle"},
    {"constant", 1095, "-G^2 M^4/alpha^2 is a constant", "-G^2 M^4/alpha^2 later on the path",
     "the same at the start", "so is V"},
    {"homogeneous", 1097, "V_h = c0 sin theta + c1 cos theta has V_h'' + V_h = 0",
     "V_h'' by dual numbers, c0 and c1 from two places on the path",
     "-(V + G^2 M^4/alpha^2) at a third place", "V_h'' - V_h"},
    {"potential", 1107, "V = c0 sin theta + c1 cos theta - G^2 M^4/alpha^2 (3)", "V later on the path",
     "equation (3), c0 and c1 from two other places", "+ G^2 M^4/alpha^2"},
    {"potential_slope", 1113, "V' = c0 cos theta - c1 sin theta", "r' GM/(r^2 theta') later on the path",
     "c0 cos theta - c1 sin theta", "+ c1 sin theta"},
    {"system", 1117,
     "at theta0: c0 sin theta0 + c1 cos theta0 = V0 + G^2 M^4/alpha^2, c0 cos theta0 - c1 sin theta = V0'",
     "V0 + G^2 M^4/alpha^2 and V0' at the start, by dual numbers", "the two sums",
     "sin theta0 in the second equation", Other::meant,
     "The second equation stands at the initial angle like the first; its sine has lost the index 0, and the "
     "solution given next has it.",
     "sin theta0 with a plus in the second equation"},
    {"system_solved", 1123,
     "c0 = (V0 + G^2 M^4/alpha^2) sin theta0 + V0' cos theta0, c1 = (...) cos theta0 - V0' sin theta0",
     "c0 and c1 from two later places on the path", "the solution, V0 and V0' by dual numbers",
     "V0' with the other sign"},
    {"V0", 1143, "V0 = V(theta0) = GM/r0", "V of equation (3) at theta0", "GM/r0", "V0 = -GM/r0",
     Other::corrected,
     "$V=-GM/r$ by definition (line 1009), so $V_0=-GM/r_0$. The sign is carried on into (4) and (5), and "
     "turns the planet's orbit into one on which it stops.",
     "-GM/(2 r0)"},
    {"V0_slope", 1149, "V0' = G M^2 r0' alpha", "V' of equation (3) at theta0", "G M^2 r0' and alpha",
     "G M^2 r0'/alpha", Other::meant,
     "The fraction bar is lost: what stands there is the product $GM^2r_0'\\alpha$. Line 1031, from which it "
     "comes, is $r'=\\alpha V'/(GM^2)$.",
     "G M r0'/alpha"},
    {"mass_cancels", 1171,
     "G^2 M^4/(M r0^2 theta0')^2 = G^2 M^2/(r0^4 theta0'^2), and the term in r0' is G M r0' r0^2 theta0'",
     "the left-hand terms, M r^2 theta' taken later on the path", "the terms without alpha",
     "quotients: G M r0'/(r0^2 theta0')", Other::meant,
     "The bars of the terms in $r_0'$ are lost in both lines: what stands there is "
     "$GM\\,r_0'\\,r_0^2\\theta_0'$. "
     "At the start of the scene below that is 23, and the quotient 0.59.",
     "G^2 M^3 and G M^2"},
    {"c0", 1171,
     "c0 = (GM/r0 + G^2 M^2/(r0^4 theta0'^2)) sin theta0 + (GM r0'/(r0^2 theta0')) cos theta0 (4)",
     "c0 from two later places on the path", "(4)", "-GM/r0 for GM/r0 in the bracket", Other::corrected,
     "The first term is $V_0=-GM/r_0$. On a circle ($r_0^3\\theta_0'^2=GM$) the bracket must vanish; as "
     "printed it is $2GM/r_0$.",
     "-GM/r0, and the last term with the other sign"},
    {"c1", 1187,
     "c1 = (GM/r0 + G^2 M^2/(r0^4 theta0'^2)) cos theta0 - (GM r0'/(r0^2 theta0')) sin theta0 (5)",
     "c1 from two later places on the path", "(5)", "-GM/r0 for GM/r0 in the bracket", Other::corrected,
     "As in (4), the first term is $V_0=-GM/r_0$: on a circle $c_1$ must be zero, and as printed it is "
     "$2GM\\cos\\theta_0/r_0$.",
     "-GM/r0, and the last term with the other sign"},
    {"rate_by_angle", 1215, "theta' = alpha/(G^2 M^3) (c0 sin theta + c1 cos theta - G^2 M^4/alpha^2)^2 (7)",
     "theta' later on the path", "(7), c0 and c1 from two other places", "+ G^2 M^4/alpha^2"},
    {"constants_of_rate", 1227, "the constants of (7) are those of (4) and (5)", "theta' later on the path",
     "(7) with these constants", "those with V0 = -GM/r0", Other::corrected,
     "At the start the bracket is $V_0$, and (7) squares it: the planet sets off with the right $\\theta_0'$ "
     "whichever the sign, and the error shows only later. With the printed sign the bracket reaches zero "
     "where $c_0\\sin\\theta+c_1\\cos\\theta=G^2M^4/\\alpha^2$; there $\\theta'=0$, and the planet never "
     "comes round. (A nearly circular orbit ends 60 degrees from its start.)",
     "those with V0 = -GM/(2 r0)"},
    {"e_and_rho", 1229, "e = gamma1/(GM), rho = gamma0^2/gamma1",
     "e, and p/e with the semi-latus rectum p, by the energy and the angular momentum",
     "gamma1/(GM), gamma0^2/gamma1", "rho = gamma0/gamma1"},
    {"orbit", 1229, "with theta from (7) the distance is r = e rho/(1 + e cos theta)", "r later on the path",
     "the polar orbit at its angle", "r = e rho/(1 + e cos(theta - omega)), omega the angle of the vector c1",
     Other::corrected,
     "The polar equation measures the angle from the perihelion, the direction of the vector $c_1$; (7) "
     "measures it from the axis that $\\theta_0$ is given in. They agree only when the user's start has its "
     "perihelion at $\\theta=0$: in general $r(\\theta_0)\\ne r_0$. The application draws the orbit of "
     "`eccentric_path` below turned by $73^\\circ$, and starts the planet on it 0.30 AU from the sun instead "
     "of 1.75. "
     "Either subtract $\\omega=\\arg c_1$, or use $r=-GM/V(\\theta)$.",
     "cos(theta + omega)"},
    {"laplace", 1231, "v x c0 = GM R + c1 with a constant vector c1", "v x c0 - GM R later on the path",
     "the same at the start", "-GM R + c1"},
    {"gamma0", 1241, "c0 = r0^2 theta0' k, of length gamma0 = r0^2 |theta0'|",
     "x y' - y x' later on the path, and its size", "r0^2 theta0' and r0^2 |theta0'|",
     "r0^2 theta0' without the bars"},
    {"c1_vector", 1253,
     "c1 = (r0^3 theta0'^2) R0 - (r0^2 r0' theta0') P0 - GM R0 = (r0^3 theta0'^2 - GM) R0 - (r0^2 r0' "
     "theta0') P0",
     "v x c0 - GM R later on the path", "the two forms", "+ GM R0"},
    {"gamma1", 1259, "gamma1 = sqrt((r0^3 theta0'^2 - GM)^2 + (r0^2 r0' theta0')^2)",
     "|v x c0 - GM R| later on the path", "the root", "r0^3 theta0'^2 + GM"},
    {"period", 1267, "T = 2 pi a^(3/2) sqrt(GM), 2a being the length of the ellipse",
     "the integral of r^2/h over a turn", "the product of 2 pi a^(3/2) and sqrt(GM)", "2 pi a^(3/2)/sqrt(GM)",
     Other::meant,
     "The fraction bar is lost: what stands there is a product with $\\sqrt{GM}$. For the Earth, in "
     "astronomical units and years, it is 39.5 years.",
     "2 pi a^(3/2)/(sqrt(G) M)"},
    {"major_axis", 1269, "in T, a is the length of the major axis", "the integral of r^2/h over a turn",
     "2 pi a^(3/2)/sqrt(GM)", "a is half of that length", Other::corrected,
     "With the whole axis for $a$ the period is $2^{3/2}=2.83$ times too long. The next sentence has it "
     "right: the axis is $2a$.",
     "a is half the length of the minor axis"},
    {"a", 1269, "2a = 2 rho e/(1 - e^2)", "the two apsides by the energy and the angular momentum",
     "2 rho e/(1 - e^2)", "2 rho/(1 - e^2)"},
    {"b", 1269, "the minor axis is 2b = 2a sqrt(1 - e^2)",
     "the area law, pi a b = h T/2, with the integral of r^2/h over a turn", "2a sqrt(1 - e^2)",
     "2a (1 - e^2)"},
};

/// Errata in which the text at hand has lost fraction bars besides.
constexpr std::string_view bars_restored[] = {"c0", "c1"};

/// What the path gives, the line as printed and in its other form, the size of its terms where they cancel,
/// and the line's near miss when the other form is what is right.
struct Sides {
  Value path, printed, other;
  double scale = 0;
  Value miss = {};
};

inline Value repeated(const Value& v, int times) {
  std::vector<double> all;
  for (int i = 0; i < times; ++i) all.insert(all.end(), v.begin(), v.end());
  return all;
}

/// The lines about the equations of motion and the potential, at one moment.
inline Sides equations(std::string_view line, const Sample& k) {
  const double G = k.s.G, M = k.s.M, mu = G * M, x = k.x, y = k.y, vx = k.vx, vy = k.vy;
  const bool is_free = line == "acceleration" || line == "areal" || line == "equation_number";
  const Path& p = is_free ? k.free : k.p;
  const double angle = p.theta.value.value, c = cos(angle), s = sin(angle);
  const double r = p.r.value.value, rd = p.r.slope.value, rdd = p.r.slope.slope;
  const double w = p.theta.slope.value, wd = p.theta.slope.slope;
  const double al = M * r * r * w, M2 = M * M, G3M5 = pow(G, 3) * pow(M, 5);
  const Twice V_along = -mu / p.r;
  const double V = V_along.value.value, V_dot = V_along.slope.value, slope = V_dot / w;
  const double slope_dot = (V_along.slope.slope * w - V_dot * wd) / (w * w), bend = slope_dot / w;
  const double speed = std::hypot(vx, vy), pull = r * w * w + mu / (r * r) + 4 * rd * rd / r;
  const double factor = al / (G * M2), equation_size = pull * mu / pow(r * w, 2) + abs(V);

  if (line == "unit_vector") return {{x, y}, {r * c, r * s}, {-r * s, r * c}};
  if (line == "acceleration") {
    const double A = rdd - r * w * w, wrong = rdd + r * w * w, B = r * wd + 2 * rd * w;
    return {k.pushed,
            {A * c - B * s, A * s + B * c},
            {wrong * c - B * s, wrong * s + B * c},
            speed * speed / r + 1};
  }
  if (line == "equation_number") {
    const double A = rdd - r * w * w, B = r * wd + 2 * rd * w, wrong = r * wd + rd * w;
    return {k.pushed,
            {-mu / (r * r) * c, -mu / (r * r) * s},
            {A * c - B * s, A * s + B * c},
            speed * speed / r + 1,
            {A * c - wrong * s, A * s + wrong * c}};
  }
  if (line == "gravity") {
    const double f = mu * r * r * r, g = mu * r * r, F = mu / (r * r * r), H = mu / (r * r);
    return {repeated(k.a, 2),
            {-f * x, -f * y, -g * c, -g * s},
            {-F * x, -F * y, -H * c, -H * s},
            0,
            {F * x, F * y, H * c, H * s}};
  }
  if (line == "radial") return {rdd - r * w * w, -mu * r * r, -mu / (r * r), pull, -mu / (r * r * r)};
  if (line == "transverse") return {r * wd, -2 * rd * w, -rd * w, speed * speed / r};
  if (line == "areal")
    return {{r * (r * wd + 2 * rd * w), x * k.pushed[1] - y * k.pushed[0]},
            repeated(r * r * wd + 2 * r * rd * w, 2),
            repeated(r * r * wd + r * rd * w, 2),
            speed * speed + r};
  if (line == "angular_momentum") {
    const auto lagrangian = [&](auto rate) {
      return k.m / 2 * (rd * rd + r * r * (rate * rate)) + k.m * mu / r;
    };
    return {derivative(lagrangian, w), M * r * r * w, k.m * r * r * w, 0, k.m * r * w};
  }
  if (line == "radial_equation")
    return {repeated(-mu / (r * r), 3),
            {rdd - r * w * w, rdd - r * pow(al / (M * r * r), 2), rdd - al * al / (M2 * r * r * r)},
            repeated(rdd + al * al / (M2 * r * r * r), 3),
            pull};
  if (line == "singular") {
    const auto r_dot_dot = [&](double z) {
      const Path fall({z, 0}, {0, r * r * w / z}, gravity(mu, std::array{z, 0.0}));
      return fall.r.slope.slope;
    };
    return {r_dot_dot(r * 0x1p-21) / r_dot_dot(r * 0x1p-20), 8.0, 4.0, 8 * (1 + speed * speed * 0x1p40)};
  }
  if (line == "potential_energy") {
    const double force = derivative([&](auto z) { return mu / z; }, r);
    return {k.m * (k.a[0] * c + k.a[1] * s), force, k.m * force, 0, k.m / 2 * force};
  }
  if (line == "power_rule") {
    const double last = mu / (V * V) * V_dot;
    return {repeated(rd, 2),
            {(-mu * V_along).slope.value, last},
            {(-mu / V_along).slope.value, last},
            speed,
            repeated(mu / V * V_dot, 2)};
  }
  if (line == "chain_rule")
    return {rd, mu * (V * V) * slope * w, mu / (V * V) * slope * w, speed, mu / (V * V) * slope};
  if (line == "r_dot") {
    const double last = factor * slope;
    return {repeated(rd, 2),
            {mu * pow(-mu / r, 2) * slope * (al * M * r * r), last},
            {mu / pow(-mu / r, 2) * slope * al / (M * r * r), last},
            speed,
            repeated(al * slope / (G * M), 2)};
  }
  if (line == "second_chain_rule") {
    const double product = al * G * M2;
    return {repeated(rdd, 2),
            {product * slope_dot, product * bend * w},
            {factor * slope_dot, factor * bend * w},
            pull,
            repeated(factor * slope * w, 2)};
  }
  if (line == "r_dot_dot") {
    const double last = al * al * bend / (G * M2 * M * r * r);
    return {repeated(rdd, 2),
            {al * G * M2 * bend * (al * M * r * r), last},
            {factor * bend * (al / (M * r * r)), last},
            pull,
            repeated(al * al * bend / (G * M2 * r * r), 2)};
  }
  if (line == "r_dot_dot_by_V")
    return {repeated(rdd, 2),
            {al * al * bend / (G * M2 * M * pow(-mu / V, 2)), al * al * bend * V * V / G3M5},
            repeated(al * al * bend * V * V / (G3M5 / M), 2),
            pull};
  if (line == "substituted") {
    const double first = al * al * bend * V * V / G3M5, second = al * al / (M2 * pow(-mu / V, 3));
    const double square = pow(-mu / V, 2);
    return {first - second, -mu * square, -mu / square, pull, mu / square};
  }
  if (line == "simplified") {
    const double first = al * al * bend * V * V / G3M5, second = al * al * V * V * V / G3M5;
    return {-V * V / mu, first + second, first - second, pull};
  }
  if (line == "potential_equation") return {-pow(G * M2 / al, 2), bend + V, bend - V, equation_size};
  if (line == "characteristic") {
    const auto curvature = [&](std::complex<double> root) {
      const std::complex<double> by_root = root * root * (V + pow(G * M2 / al, 2));
      return Value{by_root.real(), by_root.imag()};
    };
    return {{bend, 0}, curvature({0, angle < 0 ? -1.0 : 1.0}), curvature(1), equation_size};
  }
  if (line == "independent") {
    const auto sine = [](auto z) { return sin(z); };
    const auto cosine = [](auto z) { return cos(z); };
    return {sin(angle) * derivative(cosine, angle) - cos(angle) * derivative(sine, angle), -1.0, 0.0};
  }
  if (line == "particular") {
    const double rate = sqrt(mu / (r * r * r));
    const std::array<double, 2> q{r * c, r * s};
    const Path circle(q, {-rate * q[1], rate * q[0]}, gravity(mu, q));
    const Twice V_circle = -mu / circle.r;
    const double constant = G * G * pow(M, 4) / pow(M * r * r * rate, 2);
    return {{V_circle.value.value, V_circle.slope.value / rate, V_circle.slope.slope / (rate * rate)},
            {-constant, 0, 0},
            {constant, 0, 0}};
  }
  if (line == "rate_by_V")
    return {repeated(w, 3),
            {al / (M * r * r), al / (M * pow(-mu / V, 2)), al * V * V / (G * G * M2 * M)},
            repeated(al * V * V / (G * G * M2), 3)};
  if (line == "velocity")
    return {{vx, vy}, {rd * c - r * w * s, rd * s + r * w * c}, {rd * c + r * w * s, rd * s - r * w * c}};
  const double vx_polar = rd * c - r * w * s, vy_polar = rd * s + r * w * c, h = r * r * w;
  if (line == "moment")
    return {repeated(x * vy - y * vx, 2),
            {r * c * vy_polar - r * s * vx_polar, h},
            repeated(r * w, 2),
            r * speed};
  if (line == "v_cross_c0") {
    const double A = r * r * rd * w, B = r * r * r * w * w;  // R x k = (s, -c), P x k = (c, s)
    return {repeated({vy * h, -vx * h}, 3),
            {vy_polar * h, -vx_polar * h, A * s + B * c, -A * c + B * s, A * s + B * c, -A * c + B * s},
            repeated({-A * s + B * c, A * c + B * s}, 3),
            speed * abs(h)};
  }
  throw std::logic_error("no line " + std::string(line));
}

/// The lines that go from the start to a later moment.
inline Sides later(std::string_view line, const Sample& k) {
  const auto& [G, M, r0, r0_dot, theta0, w0] = k.s;
  const double mu = G * M, r = std::hypot(k.x, k.y), h = k.x * k.vy - k.y * k.vx, w = h / (r * r),
               V = -mu / r;
  const double c = cos(k.theta), s = sin(k.theta), cc = cos(theta0), ss = sin(theta0), h0 = r0 * r0 * w0;
  const double al0 = M * h0, B = k.mean(), C0 = k.c0, C1 = k.c1, potential = C0 * s + C1 * c,
               size = B + mu / r0;
  const Path start(k.s.position(), k.s.velocity(), gravity(mu, k.s.position()));
  const Twice V_along = -mu / start.r;
  const double V0 = V_along.value.value, V0_slope = V_along.slope.value / start.theta.slope.value;
  const Value constants{C0, C1};

  if (line == "conserved") return {{h, M * r * r * w}, {h0, al0}, {r0 * w0, al0}};
  if (line == "rate")
    return {{w, w},
            {al0 / (M * r * r), h0 * (r * r)},
            {al0 / (M * r * r), h0 / (r * r)},
            0,
            repeated(r0 * w0 / r, 2)};
  if (line == "invertible") {
    const double half = (theta0 + k.theta) / 2;
    return {{k.t, r},
            {k.time_between(theta0, k.theta), k.distance_at(k.theta)},
            {k.time_between(theta0, half), k.distance_at(half)}};
  }
  if (line == "constant") return {-pow(G * M * M / (M * h), 2), -pow(G * M * M / al0, 2), V};
  if (line == "homogeneous") {
    const double curvature = second_derivative([&](auto z) { return C0 * sin(z) + C1 * cos(z); }, k.theta);
    return {curvature, -(V + B), V + B, size};
  }
  if (line == "potential") return {V, potential - B, potential + B, size};
  if (line == "potential_slope")
    return {k.p.r.slope.value * mu / (r * r) / w, C0 * c - C1 * s, C0 * c + C1 * s, size};
  if (line == "system")
    return {{V0 + B, V0_slope},
            {C0 * ss + C1 * cc, C0 * cc - C1 * s},
            {C0 * ss + C1 * cc, C0 * cc - C1 * ss},
            size,
            {C0 * ss + C1 * cc, C0 * cc + C1 * ss}};
  if (line == "system_solved")
    return {constants,
            {(V0 + B) * ss + V0_slope * cc, (V0 + B) * cc - V0_slope * ss},
            {(V0 + B) * ss - V0_slope * cc, (V0 + B) * cc + V0_slope * ss},
            size};
  if (line == "V0") return {C0 * ss + C1 * cc - B, mu / r0, -mu / r0, size, -mu / (2 * r0)};
  if (line == "V0_slope")
    return {C0 * cc - C1 * ss, G * M * M * r0_dot * al0, G * M * M * r0_dot / al0, size,
            G * M * r0_dot / al0};
  const double squares = G * G * M * M / (pow(r0, 4) * w0 * w0), tilt = G * M * r0_dot / (r0 * r0 * w0);
  if (line == "mass_cancels")
    return {{pow(G * M * M / (M * h), 2), G * M * M * r0_dot / (M * h)},
            {squares, G * M * r0_dot * r0 * r0 * w0},
            {squares, tilt},
            0,
            {squares * M, tilt * M}};
  if (line == "c0")
    return {C0, (mu / r0 + squares) * ss + tilt * cc, (-mu / r0 + squares) * ss + tilt * cc, size,
            (-mu / r0 + squares) * ss - tilt * cc};
  if (line == "c1")
    return {C1, (mu / r0 + squares) * cc - tilt * ss, (-mu / r0 + squares) * cc - tilt * ss, size,
            (-mu / r0 + squares) * cc + tilt * ss};
  const double to_rate = al0 / (G * G * pow(M, 3));
  if (line == "rate_by_angle") return {w, to_rate * pow(potential - B, 2), to_rate * pow(potential + B, 2)};
  if (line == "constants_of_rate") {
    const auto rate = [&](double V_start) { return to_rate * pow(OneAngle<double>(k.s, V_start).V(k.theta), 2); };
    return {w, rate(mu / r0), rate(-mu / r0), 0, rate(-mu / (2 * r0))};
  }

  const double gamma0 = r0 * r0 * abs(w0), A1 = pow(r0, 3) * w0 * w0 - mu, A2 = r0 * r0 * r0_dot * w0;
  const double gamma1 = sqrt(A1 * A1 + A2 * A2), e = gamma1 / mu, rho = gamma0 * gamma0 / gamma1;
  const Value now{k.vy * h - mu * c, -k.vx * h - mu * s};
  const Value then{A1 * cc + A2 * ss, A1 * ss - A2 * cc};
  if (line == "laplace") {
    const auto v0 = k.s.velocity();
    return {now,
            {v0[1] * h0 - mu * cc, -v0[0] * h0 - mu * ss},
            {v0[1] * h0 + mu * cc, -v0[0] * h0 + mu * ss},
            mu};
  }
  if (line == "gamma0") return {{h, abs(h)}, {h0, gamma0}, {h0, h0}};
  if (line == "c1_vector") {
    const double B1 = A1 + mu;
    return {repeated(now, 2),
            {B1 * cc + A2 * ss - mu * cc, B1 * ss - A2 * cc - mu * ss, then[0], then[1]},
            repeated({B1 * cc + A2 * ss + mu * cc, B1 * ss - A2 * cc + mu * ss}, 2),
            mu};
  }
  if (line == "gamma1") return {std::hypot(now[0], now[1]), gamma1, std::hypot(A1 + 2 * mu, A2), mu};
  if (line == "orbit") {
    const double omega = std::atan2(then[1], then[0]);
    const auto orbit = [&](double angle) { return e * rho / (1 + e * cos(angle)); };
    return {r, orbit(k.theta), orbit(k.theta - omega), r / (1 - e), orbit(k.theta + omega)};
  }

  const double energy = (k.vx * k.vx + k.vy * k.vy) / 2 - mu / r, root = sqrt(mu * mu + 2 * energy * h * h);
  const double nearest = (mu - root) / (-2 * energy), farthest = (mu + root) / (-2 * energy);
  const double half = (nearest + farthest) / 2, a = rho * e / (1 - e * e);
  if (line == "e_and_rho") {
    const double ratio = (farthest - nearest) / (farthest + nearest),
                 p = 2 * nearest * farthest / (nearest + farthest);
    return {{ratio, p / ratio}, {e, rho}, {e, gamma0 / gamma1}, rho / e};
  }
  if (line == "a") return {2 * half, 2 * a, 2 * rho / (1 - e * e), a / (1 - e)};
  const double turn =
      trapezoid([&](double z) { return pow(k.distance_at(z), 2) / abs(h0); }, 0, 2 * pi, 512).value;
  const double n = 2 * pi / sqrt(mu);
  if (line == "period")
    return {turn, 2 * pi * pow(half, 1.5) * sqrt(mu), n * pow(half, 1.5), turn / (1 - e),
            2 * pi * pow(half, 1.5) / (sqrt(G) * M)};
  if (line == "major_axis")
    return {turn, n * pow(2 * half, 1.5), n * pow(half, 1.5), turn / (1 - e),
            n * pow(half * sqrt(1 - e * e), 1.5)};
  if (line == "b")  // the area law: pi a b = h T/2
    return {abs(h) * turn / (pi * half), 2 * a * sqrt(1 - e * e), 2 * a * (1 - e * e), a / (1 - e)};
  throw std::logic_error("no line " + std::string(line));
}

inline Claim claim_of(const Line& line, Sides (*sides)(std::string_view, const Sample&), bool integrated,
                      const std::vector<Sample>& all) {
  const auto reading = [&](std::string_view text, Value Sides::*form) {
    const std::string path(line.from_path), printed(line.as_written), other(text);
    const bool right = form == &Sides::other && line.as != Other::near_miss;
    Worst worst(path + " against " + printed, path,
                form == &Sides::printed ? printed
                : right                 ? other
                                        : printed + ", but " + other);
    for (const Sample& k : all) {
      const Sides both = sides(line.slug, k);
      const double size = std::max(both.scale, std::max(size_of(both.path), size_of(both.*form)));
      const Tolerance allowed{1e-10 * size, "a thousand tolerances of the path's integration"};
      worst.see(both.path, both.*form, integrated ? allowed : rounding(size, 256), size, k.shown());
    }
    return Reading{std::string(text), {worst.check()}};
  };
  const bool restored = std::ranges::find(bars_restored, line.slug) != std::end(bars_restored);
  Claim claim{"3.3-" + std::string(line.slug), line.number,
              std::string(line.says) + (restored ? " (the bars of its fractions restored)" : "")};
  claim.printed = reading("as printed", &Sides::printed);
  const Reading other = reading(line.other, &Sides::other);
  if (line.as == Other::near_miss) claim.near_misses = {other};
  if (line.as == Other::meant) claim.meant = other;
  if (line.as == Other::corrected) claim.corrected = other;
  if (line.as != Other::near_miss) claim.near_misses = {reading(line.miss, &Sides::miss)};
  claim.why = line.why;
  return claim;
}

// ---- statements -------------------------------------------------------------------------------------------

/// d/dt (r x v) = r x a in space, for the acceleration of gravity less `drag` times the velocity.
inline Reading constant_normal(std::string text, double drag, double seed) {
  Random random(seed);
  Worst worst("r x a, the rate of r x v", "first products", "second products");
  for (int i = 0; i < 100; ++i) {
    const auto r = random.point(), v = random.point();
    auto a = gravity(abs(random.magnitude(0.1, 10)), r);
    for (std::size_t j = 0; j < 3; ++j) a[j] -= drag * v[j];
    const double size = std::hypot(r[0], r[1], r[2]) * std::hypot(a[0], a[1], a[2]);
    worst.see({r[1] * a[2], r[2] * a[0], r[0] * a[1]}, {r[2] * a[1], r[0] * a[2], r[1] * a[0]}, size,
              "sample " + std::to_string(i));
  }
  return {std::move(text), {worst.check()}};
}

inline Reading increasing(std::string text, const std::vector<Sample>& all, double sense) {
  long violations = 0, count = 0;
  for (const Sample& k : all) {
    if (k.s.theta0_dot * sense <= 0) continue;
    ++count;
    violations += !(k.x * k.vy - k.y * k.vx > 0 && k.theta > k.s.theta0);
  }
  return {std::move(text), {never("theta' > 0 and theta > theta0", violations, count)}};
}

/// Whether the planet falls to a thousandth of its first distance, from starts at up to 1.3 times the
/// circular speed across and 0.5 times along; every tenth moves straight when `straight`.
inline Reading reaches_the_sun(std::string text, bool straight, double seed) {
  Random random(seed);
  long violations = 0;
  constexpr int count = 40;
  for (int i = 0; i < count; ++i) {
    const double across = straight && i % 10 == 0 ? 0 : random.between(0.5, 1.3);
    const Start s = random_start(random, across, random.between(-0.5, 0.5));
    const auto system = [&](const std::array<double, 2>& z, std::array<double, 2>& d, double) {
      d = {z[1], s.h() * s.h() / pow(z[0], 3) - s.mu() / (z[0] * z[0])};
    };
    const auto falls = [&](double, const auto&, double, const std::array<double, 2>& z) {
      return z[0] < 1e-3 * s.r0;
    };
    const double span = sqrt(pow(s.r0, 3) / s.mu());
    const std::array times{0.0, 10 * span};
    const auto states = ode::integrate<ode::RungeKutta4>(system, std::array{s.r0, s.r0_dot},
                                                         std::span<const double>(times), 1e-3 * span, falls);
    violations += !(states.value.back()[0] >= 1e-3 * s.r0);
  }
  return {std::move(text), {never("r falls to r0/1000", violations, count)}};
}

/// Whether the path through a start of up to twice the circular speed is an ellipse, gamma1 < GM, for squares
/// of the speed below so many GM/r0.
inline Reading elliptical(std::string text, double below, double seed) {
  Random random(seed);
  long violations = 0, count = 0;
  for (int i = 0; i < 200; ++i) {
    const double across = random.between(0.1, 2), along = random.between(-1, 1);
    const Start s = random_start(random, across, along);
    if (across * across + along * along >= below) continue;
    const double gamma1 = std::hypot(s.h() * s.h() / s.r0 - s.mu(), s.h() * s.r0_dot);
    ++count;
    violations += !(gamma1 < s.mu());
  }
  return {std::move(text), {never("e = gamma1/(GM) < 1", violations, count)}};
}

inline Claim momentum(const std::vector<Sample>& all) {
  Claim claim{"3.3-momentum", 1197, "conservation of momentum says that alpha = M r^2 theta' is constant"};
  Worst linear("(x', y')", "later on the path", "at the start"),
      angular("x y' - y x'", "later on the path", "at the start"),
      radial("x x' + y y'", "later on the path", "at the start");
  for (const Sample& k : all) {
    const auto r = k.s.position(), v = k.s.velocity();
    const double size = std::hypot(k.x, k.y) * std::hypot(k.vx, k.vy);
    const Tolerance allowed{1e-10 * size, "a thousand tolerances of the path's integration"};
    linear.see({k.vx, k.vy}, v, allowed, size, k.shown());
    angular.see(k.x * k.vy - k.y * k.vx, r[0] * v[1] - r[1] * v[0], allowed, size, k.shown());
    radial.see(k.x * k.vx + k.y * k.vy, r[0] * v[0] + r[1] * v[1], allowed, size, k.shown());
  }
  claim.printed = {"the momentum is conserved", {linear.check()}};
  claim.meant = {"the angular momentum is conserved", {angular.check()}};
  claim.near_misses = {{"r . v is conserved", {radial.check()}}};
  claim.why =
      "The word *angular* is left out. The planet's momentum turns through a full circle with every orbit: "
      "the "
      "Earth's velocity changes by 60 km/s in half a year. What is constant is its moment about the sun.";
  return claim;
}

/// V(theta0) by equation (3) with (4) and (5), V0 being -GM/r0 times `sign`, against -GM/r0; from rest as
/// well or not.
inline Reading constants_at_start(std::string text, bool at_rest, double sign, double seed) {
  Random random(seed);
  Worst worst("V(theta0) over GM/r0", "equation (3) with the constants of the start", "-1");
  for (int i = 0; i < 100; ++i) {
    const double across = at_rest && i % 10 == 0 ? 0 : random.between(0.5, 1.3);
    const Start s = random_start(random, across, at_rest && i % 20 == 0 ? 0 : random.between(-0.5, 0.5));
    const double V0 = s.mu() / s.r0, size = 2 + 2 / (across * across);
    worst.see(OneAngle<double>(s, -sign * V0).V(s.theta0) / V0, -1, rounding(size), size,
              "r0' = " + shortest(s.r0_dot) + ", theta0' = " + shortest(s.theta0_dot));
  }
  return {std::move(text), {worst.check()}};
}

inline Claim any_start(double seed) {
  Claim claim{"3.3-constants_of_any_start", 1171,
              "(4) and (5) give c0 and c1 for any r0, r0', theta0, theta0'"};
  claim.printed = constants_at_start("any theta0', V0 = -GM/r0", true, 1, seed);
  claim.corrected = constants_at_start("theta0' not zero, V0 = -GM/r0", false, 1, seed);
  claim.near_misses = {constants_at_start("theta0' not zero, V0 = GM/r0", false, -1, seed)};
  claim.why =
      "Both divide by $\\theta_0'$. A planet that starts at rest, or straight towards the sun or away from "
      "it, "
      "has $\\alpha=0$; then $c_0$ and $c_1$ are infinite or not a number, and so is every angle that (7) "
      "gives. "
      "The planet stays on its ray: from rest at $r_0$ it falls into the sun within "
      "$\\tfrac{\\pi}{2\\sqrt2}\\sqrt{r_0^3/GM}$, the Earth in 65 days. The application takes $\\theta_0'$ "
      "from "
      "the user and has to treat zero apart.";
  return claim;
}

/// On the circle G = M = 2, r0 = 4, theta0' = 1/4, whose numbers are exact in binary.
inline Claim circle() {
  const Start s{2, 2, 4, 0, 0, 0.25};
  const double gamma0 = s.h(), gamma1 = abs(pow(s.r0, 3) * s.theta0_dot * s.theta0_dot - s.mu());
  const double e = gamma1 / s.mu(), rho = gamma0 * gamma0 / gamma1;
  const auto radius = [&](std::string text, double p) {
    const double r = p / (1 + e * cos(1.0));
    return Reading{
        text,
        {{"r at theta = 1", {text, r}, {"the circle", s.r0}, exact(), 0, "GM = 4, r0 = 4, theta0' = 1/4"}}};
  };
  Claim claim{"3.3-rho_of_a_circle", 1229, "rho = gamma0^2/gamma1 serves for the orbit of any start"};
  claim.printed = radius("e rho = (gamma1/(GM)) (gamma0^2/gamma1)", e * rho);
  claim.corrected = radius("e rho = gamma0^2/(GM)", gamma0 * gamma0 / s.mu());
  claim.near_misses = {radius("e rho = gamma0/(GM)", gamma0 / s.mu())};
  claim.why =
      "A circle ($r_0'=0$, $r_0^3\\theta_0'^2=GM$) has $\\gamma_1=0$: $\\rho$ is a division by zero, and "
      "$e\\rho$ is "
      "zero times infinity. The application, which computes $r=e\\rho/(1+e\\cos\\theta)$ and $2a=2\\rho "
      "e/(1-e^2)$, "
      "gets no number for either and draws nothing, of all orbits for the simplest. Without $\\rho$ it does: "
      "$e\\rho=\\gamma_0^2/(GM)$.";
  return claim;
}

inline std::vector<Claim> claims(double seed) {
  const std::vector<Sample> all = samples(seed);
  std::vector<Claim> claims;
  for (const Line& line : at_one_moment) claims.push_back(claim_of(line, equations, false, all));
  for (const Line& line : from_the_start) claims.push_back(claim_of(line, later, true, all));

  Claim normal{"3.3-plane", 945,
               "the normal c0 = r x v is constant: the motion stays in the plane of r and v"};
  normal.printed = constant_normal("under gravity", 0, seed);
  normal.near_misses = {constant_normal("with drag", 0.1, seed)};

  Claim unique{"3.3-orbit_for_all_time", 945,
               "a start whose r and v span a plane determines an orbit for all t >= 0"};
  unique.printed = reaches_the_sun("r and v span a plane", false, seed);
  unique.near_misses = {reaches_the_sun("some of the r and v in line", true, seed)};

  Claim grows{"3.3-increasing", 987, "for theta0' > 0 the angle increases strictly for all time"};
  grows.printed = increasing("theta0' > 0", all, 1);
  grows.near_misses = {increasing("theta0' < 0", all, -1)};

  Claim ellipse{"3.3-elliptical_path", 1229, "the path is an ellipse for the inputs that a user specifies"};
  ellipse.printed = elliptical("any start", std::numeric_limits<double>::infinity(), seed);
  ellipse.corrected = elliptical("r0'^2 + r0^2 theta0'^2 < 2 GM/r0", 2, seed);
  ellipse.near_misses = {elliptical("r0'^2 + r0^2 theta0'^2 < 2.5 GM/r0", 2.5, seed)};
  ellipse.why =
      "Only below the speed of escape, $r_0'^2+r_0^2\\theta_0'^2 < 2GM/r_0$, at the Earth's distance 42 "
      "km/s. Above it $e\\ge1$; then $a$ and "
      "$T$ of the last paragraph do not exist ($1-e^2\\le0$), and $\\theta$ tends to a limit.";

  claims.insert(claims.end(), {normal, unique, grows, ellipse, momentum(all), any_start(seed), circle()});
  std::ranges::stable_sort(claims, {}, &Claim::line);
  return claims;
}

}  // namespace oddity::kepler
