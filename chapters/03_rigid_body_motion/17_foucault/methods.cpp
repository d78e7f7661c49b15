#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "chapters/03_rigid_body_motion/17_foucault/foucault.hpp"
#include "chapters/scene.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_17 {

using namespace foucault;

namespace {

// ---- the direction of the swing ---------------------------------------------------------------------------

/// The direction of the major axis of the small-amplitude ellipse through (x, y, x', y').
double major_axis(const std::array<double, 4>& s, double seconds_squared) {
  return 0.5 * std::atan2(2 * (s[0] * s[1] + seconds_squared * s[2] * s[3]),
                          s[0] * s[0] - s[1] * s[1] + seconds_squared * (s[2] * s[2] - s[3] * s[3]));
}

/// The swing's axis of a pendulum released at rest turns at omega sin lambda. The release makes the swing an
/// ellipse with the minor axis phi omega sin lambda / sqrt(g/L). To order phi^2 it turns the axis back by 3/8
/// phi^2 of that rate [Airy 1851].
struct AxisTurning : Given<double> {
  double back = 0;
  std::array<double, 1> at(double t) const {
    return {theta + omega * std::sin(lambda) * (1 - back * phi * phi) * t};
  }
};

template <class Model>
struct SeenAsAxis : Model {
  std::array<double, 1> observe(const typename Model::State& x, double) const {
    return {major_axis(this->flat(x), this->p.L / this->p.g)};
  }
};

/// The published energy and forces, integrated in the two angles.
struct BookSwing : Given<double> {
  BookEnergy T;
  using State = std::array<double, 4>;
  State start() const { return {theta, phi, theta_dot, phi_dot}; }
  void operator()(const State& x, State& dxdt, double) const {
    const Pair q{x[0], x[1]}, v{x[2], x[3]};
    Pair force = coriolis(T.L, T.w, q, v);
    force[1] -= g * T.L * std::sin(q[1]);
    const Pair a = lagrange_accelerations(T, q, v, force);
    dxdt = {v[0], v[1], a[0], a[1]};
  }
  Pair observe(const State& x, double) const {
    const auto R = Axes<double>({x[0], x[1]}).R;
    return {R[0], R[1]};
  }
};

/// A point mass that observes only its direction.
struct Direction : Cartesian<double> {
  Pair observe(const State& s, double) const { return {s[0] / p.L, s[1] / p.L}; }
};

// ---- the quantities ---------------------------------------------------------------------------------------

const std::string cartesian = "Cartesian with constraint", angles = "two angles",
                  published = "two angles as published", no_centrifugal = "the centrifugal force is left out",
                  low_order = "its order is too low for this need at this step",
                  small = "the period grows with the amplitude, and ellipses turn by themselves";

const std::string turns_at_once =
    R"(each pass by the lowest point turns $\theta$ by half a turn, too fast for these steps)";

/// Whether the centrifugal force moves the bob by more than `need` at one of the times; looks at a long
/// motion's beginning first.
bool centrifugal_force_matters(const Given<double>& p, const Horizon& horizon, double need) {
  constexpr int few = 512;
  std::vector<Horizon> parts{horizon};
  if (horizon.count() > few) parts.insert(parts.begin(), {horizon.times()[few], few});
  return std::ranges::any_of(parts, [&](const Horizon& part) {
    const auto seen = [&](double centrifugal) {
      return observe_integrated<ode::Fehlberg78>(TwoAngles<double>{p, centrifugal}, part, 1e-11).value;
    };
    return !(distance(seen(1), seen(0)) <= need);
  });
}

}  // namespace

Quantity bob(const Given<double>& p, const Horizon& horizon, const Reference& truth) {
  constexpr double need = 1e-6;
  const bool matters = centrifugal_force_matters(p, horizon, need);
  const Outcome without = matters ? Outcome::inaccurate : Outcome::ok;
  const std::string why = matters ? no_centrifugal : "";
  Quantity q = quantity("bob", "m", "horizontal position at " + times_up_to(horizon),
                        trajectory(truth, "03_17_bob", p.inputs(), horizon), {need, "a micrometre"});
  SceneMethods(q, horizon, halving("step", 0.125, 8), tolerances(3, 11))
      .closed_form("averaged", SmallAngle<double>{p, true}, Outcome::inaccurate, small)
      .closed_form("small angle", SmallAngle<double>{p}, Outcome::inaccurate, small)
      .by<ode::ExplicitEuler>(published, TwoAngles<double>{p, 0}, Outcome::drifted, low_order)
      .by<ode::RungeKutta4>(published, TwoAngles<double>{p, 0}, without, why)
      .by<ode::DormandPrince54>(published, TwoAngles<double>{p, 0}, without, why)
      .by<ode::Fehlberg78>(published, TwoAngles<double>{p, 0}, without, why)
      .by_engine_integrators(angles, TwoAngles<double>{p}, Outcome::drifted)
      .by_remaining_integrators(
          angles, TwoAngles<double>{p},
          {{"modified midpoint", Outcome::inaccurate, low_order},
           {"linearly implicit Euler", Outcome::drifted, "a first-order method that damps every swing"}})
      .by_engine_integrators(cartesian, Cartesian<double>{p}, Outcome::drifted);
  if (!matters) return q;
  return q.add(
      Breakdown{R"(The published equations leave out the centrifugal force. At $\omega=@3$ rad/s, one turn )"
                "in @3 s, it moves the bob by up to @1 m within @2 s.",
                published + ", Fehlberg 7(8)",
                1e-11,
                Outcome::inaccurate,
                angles + ", Fehlberg 7(8)",
                1e-11,
                {p.omega, 2 * std::numbers::pi / p.omega, error_of(Side::broken), horizon.end}});
}

Quantity bob_on_earth(const Horizon& horizon, const Reference& truth) {
  Quantity q = quantity(
      "bob_on_earth", "m",
      filled("position of the Pantheon's pendulum: @2 m, let go @1 m aside", {pantheon.L, let_go_aside()}),
      trajectory(truth, "03_17_bob", pantheon.inputs(), horizon),
      {1e-5, filled(R"(a hundredth of a millimetre; the centrifugal force is worth @2 of it, )"
                    R"($2\omega^2L^2\sin\lambda\cos\lambda/g$)",
                    {pantheon.omega * pantheon.omega * pantheon.L * pantheon.L *
                     std::sin(2 * pantheon.lambda) / pantheon.g / 1e-5})});
  SceneMethods(q, horizon, halving("step", 0.125, 8), tolerances(3, 11))
      .closed_form("averaged", SmallAngle<double>{pantheon, true}, Outcome::inaccurate, small)
      .closed_form("small angle", SmallAngle<double>{pantheon}, Outcome::inaccurate, small)
      .by<ode::RungeKutta4>(cartesian, Cartesian<double>{pantheon})
      .by<ode::Fehlberg78>(cartesian, Cartesian<double>{pantheon})
      .by<ode::Fehlberg78>(published, TwoAngles<double>{pantheon, 0});
  return q;
}

/// Pushed from the lowest point, where theta is undefined.
Quantity push(Given<double> p, const Horizon& horizon, const Reference& truth) {
  p.phi = p.theta_dot = 0;
  p.phi_dot = 0.75;
  Quantity q =
      quantity("pushed_from_below", "m",
               filled(R"(position after a push from the lowest point by $\dot\phi=@2$ rad/s)", {p.phi_dot}),
               trajectory(truth, "03_17_bob", p.inputs(), horizon), {1e-6, "a micrometre"});
  const std::string why = R"(at the lowest point the first equation is divided by $\sin\phi=0$)";
  SceneMethods(q, horizon, halving("step", 0.125, 8), tolerances(3, 11))
      .by<ode::RungeKutta4>(angles, TwoAngles<double>{p}, Outcome::non_finite, why)
      .by<ode::Fehlberg78>(angles, TwoAngles<double>{p}, Outcome::non_finite, why)
      .by<ode::RungeKutta4>(cartesian, Cartesian<double>{p})
      .by<ode::Fehlberg78>(cartesian, Cartesian<double>{p});
  return q.add(
      Breakdown{"The angle $\\theta$ has no value at the lowest point, and its equation divides by zero "
                "there. Position and velocity in three coordinates have no such point.",
                angles + ", Runge-Kutta 4", 0.001953125, Outcome::non_finite, cartesian + ", Runge-Kutta 4",
                0.001953125});
}

Quantity hours(const Reference& truth) {
  const Horizon horizon{3600, 1};
  constexpr double degrees = 180 / std::numbers::pi;
  Quantity q =
      quantity("plane_of_swing", "rad",
               filled("direction of the Pantheon's pendulum (@2 m, @1 m aside, at rest) after an hour",
                      {pantheon.L, let_go_aside()}),
               trajectory(truth, "03_17_axis", pantheon.inputs(), horizon),
               {1e-3, filled(R"(@1 degrees; theory: $\omega\sin\lambda$, @3 degrees an hour)",
                             {1e-3 * degrees, 3600 * pantheon.omega * std::sin(pantheon.lambda) * degrees})});
  const SeenAsAxis<Cartesian<double>> full{{pantheon}};
  const SeenAsAxis<TwoAngles<double>> two{{pantheon}};
  const Resolution steps = halving("step", 1, 4);
  SceneMethods(q, horizon, steps, tolerances(5, 9))
      .closed_form("averaged", AxisTurning{pantheon})
      .closed_form("averaged, with Airy's term", AxisTurning{pantheon, 3.0 / 8})
      .by<ode::RungeKutta4>(cartesian, full)
      .by<ode::DormandPrince54>(cartesian, full)
      .by<ode::Fehlberg78>(cartesian, full)
      .by<ode::RungeKutta4>(angles, two, Outcome::non_finite, turns_at_once);
  SceneMethods(q, horizon, steps, tolerances(7, 7)).by<ode::Fehlberg78>(angles, two);
  // A small ellipse; its half axes have the ratio of the rates of precession and swing.
  const double nearest = passes_at(), fastest = let_go_aside() * std::sqrt(pantheon.g / pantheon.L);
  return q.add(
      Breakdown{R"(Let go at rest, the bob passes the lowest point at a distance of @1 mm, where $\theta$ )"
                "changes by half a turn within about @1 ms. Steps that serve the swing overflow there; "
                "error control finds its way.",
                angles + ", Runge-Kutta 4",
                0.125,
                Outcome::non_finite,
                cartesian + ", Runge-Kutta 4",
                0.125,
                {1000 * nearest, 1000 * std::numbers::pi * nearest / fastest}});
}

Quantity cone_swing(Given<double> p, const Cone& cone, const Horizon& horizon, const Reference& truth) {
  p.L = cone.equivalent_length();
  Known known = trajectory(truth, "03_17_bob", p.inputs(), horizon);
  for (double& x : known.value) x /= p.L;
  Quantity q =
      quantity("cone", "1", "direction of a cone hung by its vertex (west, north) at " + times_up_to(horizon),
               known, {1e-6, "a millionth"});
  Given<double> point = p, book = p;
  point.L = cone.L();
  book.L = book_cone(cone).L;
  const std::string why = "the cone's own turning has inertia";
  SceneMethods(q, horizon, halving("step", 0.125, 8), tolerances(3, 11))
      .by<ode::RungeKutta4>("point mass at (L^2 + Ixx)/L", Direction{{p}})
      .by<ode::Fehlberg78>("point mass at (L^2 + Ixx)/L", Direction{{p}})
      .by<ode::Fehlberg78>("point mass at the center of mass", Direction{{point}}, Outcome::inaccurate, why)
      .by<ode::DormandPrince54>("published energy", BookSwing{book, {book_cone(cone), p.w()}},
                                Outcome::inaccurate, why + "; its $L$ and $J$ are not the cone's");
  return q;
}

/// Ixx and Izz about the base's center, in the text's limits (x inside, z outside) or in cylindrical
/// coordinates.
Answer cone_moments(const Cone& cone, bool cartesian_limits, const Rule& rule) {
  const auto rho = [=](double z) { return cone.r * (1 - z / cone.h); };
  const auto over = [&](const std::function<double(double, double, double)>& f) {
    if (!cartesian_limits)
      return nested(
          rule, [&](double z, double t, double s) { return s * f(s * std::cos(t), s * std::sin(t), z); }, 0,
          cone.h, [](double) { return 0.0; }, [](double) { return 2 * std::numbers::pi; },
          [](double, double) { return 0.0; }, [&](double z, double) { return rho(z); });
    const auto half = [&](double z, double y) { return std::sqrt(std::max(0.0, rho(z) * rho(z) - y * y)); };
    return nested(
        rule, [&](double z, double y, double x) { return f(x, y, z); }, 0, cone.h,
        [&](double z) { return -rho(z); }, rho, [&](double z, double y) { return -half(z, y); }, half);
  };
  const auto across = over([](double, double y, double z) { return y * y + z * z; });
  const auto along = over([](double x, double y, double) { return x * x + y * y; });
  return {Value{across.value, along.value}, across.evaluations + along.evaluations};
}

Quantity inertia(const Cone& cone) {
  const double h = cone.h, r = cone.r, r2h = std::numbers::pi * r * r * h;
  const Value exact{r2h * (2 * h * h + 3 * r * r) / 60, r2h * r * r / 10};
  Quantity q{"inertia",
             "m^5",
             "$I_{xx}$ and $I_{zz}$ of the cone about its base's center, its density one",
             {"closed form", exact},
             4e-16 * size_of(exact),
             {1e-10 * size_of(exact), "ten digits of the larger"}};
  const auto gauss = [=](bool cartesian_limits) {
    return [=](double n) {
      return cone_moments(cone, cartesian_limits, [n](FunctionOfOne f, double a, double b) {
        return gauss_legendre(f, a, b, static_cast<int>(n));
      });
    };
  };
  q.add({"cylindrical coordinates", "Gauss-Legendre", doubling("points", 2, 4), gauss(false)});
  q.add({"the text's limits", "Gauss-Legendre", doubling("points", 2, 5), gauss(true), Outcome::inaccurate,
         R"(the width $\sqrt{\rho^2-y^2}$ has infinite slopes at its ends)"});
  q.add({"the text's limits", "QAGS", tolerances(6, 9, 3), [=](double e) {
           return cone_moments(cone, true,
                               [e](FunctionOfOne f, double a, double b) { return qags(f, a, b, e); });
         }});
  return q.add(
      Breakdown{"In the text's Cartesian limits the middle integrand has infinite slopes at its ends, and "
                "Gauss's rule converges slowly; cylindrical coordinates have none.",
                "the text's limits, Gauss-Legendre", 32, Outcome::inaccurate,
                "cylindrical coordinates, Gauss-Legendre", 16});
}

}  // namespace oddity::ex03_17
