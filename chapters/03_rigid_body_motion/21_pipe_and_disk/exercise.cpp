// Exercise 3.21: a disk of mass m turns about a pipe of length L, whose other end is a joint and whose
// inclination phi is held; psi is the disk's angle about the pipe, theta the pipe's about the vertical. What
// does gravity do?
//   theta'' = F_theta/((m L^2 + mu2) sin(phi)^2), psi'' = -F_theta cos(phi)/((m L^2 + mu2) sin(phi)^2)
// The equations judged are compared with Lagrange's for the rigid disk: its kinetic energy is taken from the
// motion of its center and of its rotation matrix, tr(R' J R'^T)/2, differentiated by nested dual numbers.
// mu2 is the moment about a diameter, mu3 that about the pipe; J has the second moments of mass, (mu3/2,
// mu3/2, mu2 - mu3/2). It takes phi constant; with phi free gravity would turn the pipe like a top.

#include "chapters/03_rigid_body_motion/21_pipe_and_disk/pipe_and_disk.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex03_21 {

using namespace pipe_and_disk;

constexpr Parameter parameters[] = {
    {"m", 1, "kg", "mass of the disk", 0.2, 100},
    {"L", 2, "m", "length of the pipe", 0.5, 10},
    {"r", 0.5, "m", "radius of the disk", 0.01, 10},
    {"phi", 1, "rad", "inclination of the pipe from the vertical", 0.05, 3},
    {"f", 3, "N", "horizontal force on the disk's center", 0.1, 10},
    {"k", 0.2, "N s/m", "friction of the disk's center", 0, 2},
    {"theta", 2, "rad", "start: angle of the pipe from the force", -3, 3},
    {"theta_dot", 0.5, "rad/s", "start: its speed", -10, 10},
    {"psi_dot", 10, "rad/s", "start: the disk's speed about the pipe", -1000, 1000},
    {"seed", 321, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the rigid disk ---------------------------------------------------------------------------------------

template <class T>
using Vector = std::array<T, 3>;

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Sample {
  double m, L, mu2, mu3, phi, g;
  Pair q, v;  ///< (theta, psi) and their speeds
  Vector<double> F;

  explicit Sample(Random& random)
      : m(random.between(0.2, 3)),
        L(random.between(0.3, 3)),
        mu2(random.between(0.1, 2)),
        mu3(mu2 * random.between(0.1, 0.9)),
        phi(random.between(0.2, 2.9)),
        g(random.between(0.5, 20)),
        q{random.between(-3, 3), random.between(-3, 3)},
        v{random.magnitude(0.1, 3), random.magnitude(0.1, 3)},
        F{random.point(5)} {}
  std::array<double*, 13> letters() {
    return {&m, &L, &mu2, &mu3, &phi, &g, &q[0], &q[1], &v[0], &v[1], &F[0], &F[1], &F[2]};
  }
  double inertia() const { return (m * L * L + mu2) * std::sin(phi) * std::sin(phi); }
  double size() const {
    return 8 * (1 + m * L * (L + g) + mu2 + L * 5) * (1 + dot<double>({v[0], v[1], 0}, {v[0], v[1], 0})) *
           (1 + 1 / inertia());
  }
  std::string where() const {
    return "phi = " + rounded(phi, 4) + ", theta = " + rounded(q[0], 4) + ", theta' = " + rounded(v[0], 4) +
           ", psi' = " + rounded(v[1], 4);
  }

  /// The disk's two diameters and the pipe's direction: the columns of R.
  template <class T>
  std::array<Vector<T>, 3> axes(const T& theta, const T& psi) const {
    using std::cos, std::sin;
    const T c = cos(theta), s = sin(theta), a = cos(psi), b = sin(psi), C(std::cos(phi)), S(std::sin(phi));
    const Vector<T> down{c * C, s * C, -S}, side{-s, c, T(0.0)}, pipe{c * S, s * S, C};
    Vector<T> e, f;
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = a * down[i] + b * side[i];
      f[i] = a * side[i] - b * down[i];
    }
    return {e, f, pipe};
  }
  /// The Lagrangian, gravity being `weight` over the mass.
  template <class T>
  T lagrangian(const Two<T>& at, const Two<T>& speed, double weight) const {
    const auto r = axes(Dual<T>(at[0], speed[0]), Dual<T>(at[1], speed[1]));
    const double moments[] = {mu3 / 2, mu3 / 2, mu2 - mu3 / 2};
    T energy = T(0.0);
    for (std::size_t k = 0; k < 3; ++k)
      for (const Dual<T>& component : r[k]) {
        const T rate = component.slope;
        energy = energy + T(moments[k] / 2 + (k == 2 ? m * L * L / 2 : 0)) * rate * rate;
      }
    return energy - T(m * weight * L) * r[2][2].value;
  }
  /// Accelerations under gravity and a generalized force on theta.
  Pair accelerations(double force, double weight) const {
    const auto L_of = [&](const auto& at, const auto& speed) { return lagrangian(at, speed, weight); };
    return lagrange_accelerations(L_of, q, v, {force, 0});
  }
  /// dX/dtheta, X the center.
  Vector<double> lever() const {
    const auto pipe = axes(Dual<double>(q[0], 1), Dual<double>(q[1]))[2];
    return {L * pipe[0].slope, L * pipe[1].slope, L * pipe[2].slope};
  }
  double force() const { return dot(F, lever()); }
};

using S = const Sample&;
using V = Version<Sample>;

// ---- the claims -------------------------------------------------------------------------------------------

std::vector<Claim> equations(double seed) {
  const V lagrange{"Lagrange's equations of the rigid disk by nested dual numbers",
                   [](S s) { return Value(s.accelerations(s.force(), 0)); }};
  const V first{lagrange.text, [](S s) { return values(s.accelerations(s.force(), 0)[0]); }};
  const V second{lagrange.text, [](S s) { return values(s.accelerations(s.force(), 0)[1]); }};
  const auto over = [](S s, double moment) {
    return s.force() / ((s.m * s.L * s.L + moment) * std::sin(s.phi) * std::sin(s.phi));
  };
  const Claim theta = formula_claim<Sample>(
      "3.21-theta", 2559, "theta''", seed,
      {"F_theta/((m L^2 + mu2) sin(phi)^2)", [=](S s) { return values(over(s, s.mu2)); }}, first,
      {{"the moment about the pipe for mu2", [=](S s) { return values(over(s, s.mu3)); }},
       {"sin(phi) for its square", [=](S s) { return values(over(s, s.mu2) * std::sin(s.phi)); }}});
  const Claim psi =
      formula_claim<Sample>("3.21-psi", 2561, "psi''", seed,
                            {"-F_theta cos(phi)/((m L^2 + mu2) sin(phi)^2)",
                             [=](S s) { return values(-over(s, s.mu2) * std::cos(s.phi)); }},
                            second,
                            {{"plus", [=](S s) { return values(over(s, s.mu2) * std::cos(s.phi)); }},
                             {"zero", [](S) { return values(0); }}});
  const auto product = [](double sign, double third) {
    return [=](S s) {
      const double sine = std::sin(s.phi), c = std::cos(s.q[0]), w = std::sin(s.q[0]);
      return values(s.L * (-sign * s.F[0] * w * sine + s.F[1] * c * sine + third * s.F[2] * std::cos(s.phi)));
    };
  };
  const Claim force = formula_claim<Sample>(
      "3.21-force", 2569, "the generalized force on theta", seed,
      {"F.L(-sin(theta) sin(phi), cos(theta) sin(phi), 0)", product(1, 0)},
      {"F.dX/dtheta by dual numbers", [](S s) { return values(s.force()); }},
      {{"+sin(theta)", product(-1, 0)}, {"cos(phi) as the third component", product(1, 1)}});
  return {theta, psi, force};
}

/// A vector of the sample against zero.
template <class Of>
Check vanishes(const std::string& what, const std::string& by, double seed, const Of& of) {
  Worst worst(what, by, "zero");
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const Sample s(random);
    const Value seen = of(s);
    worst.see(seen, Value(std::vector<double>(seen.size(), 0.0)), s.size(), s.where());
  }
  return worst.check();
}

/// d/dt of the disk's angular velocity theta' k + psi' u, both speeds constant.
Value angular_acceleration(S s) {
  const auto pipe = s.axes(Dual<double>(s.q[0], s.v[0]), Dual<double>(s.q[1]))[2];
  return values(s.v[1] * pipe[0].slope, s.v[1] * pipe[1].slope, s.v[1] * pipe[2].slope);
}

/// (theta, psi, theta', psi') after 2 s by Lagrange's equations, from the disk's energies alone.
std::array<double, 4> after_two_seconds(S s, double along_x) {
  const auto rhs = [&](const std::array<double, 4>& x, std::array<double, 4>& dxdt, double) {
    Sample now = s;
    now.q = {x[0], x[1]};
    now.v = {x[2], x[3]};
    const Pair a = now.accelerations(along_x * now.lever()[0], s.g);
    dxdt = {x[2], x[3], a[0], a[1]};
  };
  return ode::integrate<ode::RungeKutta4>(rhs, std::array{s.q[0], s.q[1], s.v[0], s.v[1]}, 0, 2, 0.05).value;
}

Check unchanged(const std::string& what, double seed, std::size_t first, double along_x) {
  const Version<Sample> later{"Lagrange's equations under gravity, integrated", [=](S s) {
                                const auto x = after_two_seconds(s, along_x);
                                return values(x[first], x[first + 1]);
                              }};
  Worst worst(what + " after 2 s", later.text, "at the start", 512);
  Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const Sample s(random);
    const std::array start{s.q[0], s.q[1], s.v[0], s.v[1]};
    worst.see(later.of(s), {start[first], start[first + 1]}, size_of_terms(later, s), s.where());
  }
  return worst.check();
}

std::vector<Claim> gravity(double seed) {
  Claim none{"3.21-gravity_force", 2571, "gravity has no generalized force on theta, at any time"};
  const auto weight = [&](const std::string& by, std::size_t axis) {
    return vanishes("F_theta", by, seed, [=](S s) { return values(-s.m * s.g * s.lever()[axis]); });
  };
  none.printed = {"F = -m g k: F_theta = 0", {weight("-m g k.dX/dtheta by dual numbers", 2)}};
  none.near_misses = {{"gravity along -i", {weight("-m g i.dX/dtheta by dual numbers", 0)}}};

  Claim accelerations{"3.21-no_acceleration", 2573, "theta'' = 0 and psi'' = 0"};
  const auto at_rest = [&](double force) {
    return vanishes("(theta'', psi'')", "Lagrange's equations with gravity", seed,
                    [=](S s) { return Value(s.accelerations(force, s.g)); });
  };
  accelerations.printed = {"(0, 0)", {at_rest(0)}};
  accelerations.near_misses = {{"with a horizontal force", {at_rest(0.1)}}};

  Claim angular{"3.21-angular_accelerations", 2575,
                "pipe and disk turn without angular acceleration, each about its own axis"};
  angular.printed = {"of the pipe about the vertical, and of the disk about the pipe",
                     {at_rest(0), vanishes("d/dt of the disk's angular velocity along the pipe",
                                           "dual numbers", seed, [](S s) {
                                             const Value a = angular_acceleration(s);
                                             const auto pipe = s.axes(s.q[0], s.q[1])[2];
                                             return values(a[0] * pipe[0] + a[1] * pipe[1] + a[2] * pipe[2]);
                                           })}};
  angular.near_misses = {
      {"the disk's angular velocity, as a vector, is constant",
       {vanishes("d/dt of the disk's angular velocity", "dual numbers", seed, angular_acceleration)}}};

  Claim integrated{"3.21-integrated", 2575, "integrated: theta(t) = theta_0 and psi(t) = psi(0)"};
  integrated.printed = {"the angles keep their values", {unchanged("(theta, psi)", seed, 0, 0)}};
  integrated.meant = {"the speeds keep theirs: theta'(t) = theta'(0), psi'(t) = psi'(0)",
                      {unchanged("(theta', psi')", seed, 2, 0)}};
  integrated.near_misses = {
      {"the speeds under a horizontal force", {unchanged("(theta', psi')", seed, 2, 0.1)}}};
  integrated.why =
      "The dots are lost: zero accelerations keep the speeds $\\dot\\theta$ and $\\dot\\psi$, as the next "
      "sentence "
      "says; the angles grow with time.";

  Claim constant_speeds{"3.21-constant_speeds", 2575, "the angular speeds are constant"};
  constant_speeds.printed = {"(theta', psi') constant", {unchanged("(theta', psi')", seed, 2, 0)}};
  constant_speeds.near_misses = {
      {"also under a horizontal force", {unchanged("(theta', psi')", seed, 2, 1)}}};
  return {none, accelerations, angular, integrated, constant_speeds};
}

/// Upright the printed quotient is 0/0. Lagrange's left sides vanish there for theta'' = -psi'', whatever it
/// is.
Claim upright_pipe(double seed) {
  const auto left_sides = [&](const std::string& by, double psi) {
    return vanishes("Lagrange's left sides of an upright pipe", by, seed, [=](S s) {
      Sample up = s;
      up.phi = 0;
      const auto L_of = [&](const auto& at, const auto& speed) { return up.lagrangian(at, speed, up.g); };
      return Value(lagrange_left_side(L_of, up.q, up.v, {s.F[0], psi * s.F[0]}));
    });
  };
  Claim claim{"3.21-upright", 2559,
              "theta'' = F_theta/((m L^2 + mu2) sin^2 phi), and so under gravity 0, at every inclination"};
  claim.printed = {"of an upright pipe, too",
                   {vanishes("theta'' of an upright pipe", "the quotient", seed, [](S s) {
                     Sample up = s;
                     up.phi = 0;
                     return values(-up.m * up.g * up.lever()[2] / up.inertia());
                   })}};
  claim.corrected = {"only where the pipe is inclined; upright (theta + psi)'' = 0 is all that holds",
                     {left_sides("theta'' any, psi'' = -theta''", -1)}};
  claim.near_misses = {
      {"upright theta'' may be anything, whatever psi''", {left_sides("theta'' any, psi'' = 0", 0)}}};
  claim.why =
      "An upright pipe has $\\sin\\phi=0$: the quotient is 0/0 without any force, and a program that divides "
      "has "
      "NaN in its first step. Both angles turn the disk about the same line then, and the equations fix "
      "their "
      "sum alone. The default disk has $4.1\\cdot10^{-4}$ kg m$^2$ under the bar at $\\phi=0.01$, where a "
      "small "
      "force already makes large accelerations.";
  return claim;
}

Given<double> asked(const Parameters& p) {
  return {p["m"], p["L"], p["r"], p["phi"], p["f"], p["k"], p["theta"], p["theta_dot"], p["psi_dot"]};
}

Quantity wind(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return under_force("wind", "center and spin at four times, under a horizontal force and friction", asked(p),
                     {Outcome::inaccurate, Outcome::inaccurate}, horizon, truth, Tried::whole_catalog);
}

Scene scene() {
  return {
      wind,
      seconds,
      centimeter,
      "phi",
      {1.5, 1, 0.5, 0.2, 0.1, 0.05},
      {"theta", "theta_dot", "psi_dot"},
      {{"x", "y", "psi"}, "s", {{"m", {0, 1}}, {"rad", {2}}}},
      {{"chapters/03_rigid_body_motion/21_pipe_and_disk/models.hpp"},
       {{"constant speeds",
         "pipe_and_disk::ConstantSpeeds<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}}"},
        {"one angle", "pipe_and_disk::OneAngle<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}}"},
        {"two angles", "pipe_and_disk::TwoAngles<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}}"},
        {"Cartesian center",
         "pipe_and_disk::Center<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}}"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Given<double> pushed = asked(p);
  const Horizon horizon{seconds};
  Given<double> free = pushed, frictionless = pushed, steep = pushed;
  free.f = free.k = frictionless.k = 0;
  steep.phi = 0.01;
  std::vector<Claim> claims = equations(p["seed"]);
  for (const Claim& claim : gravity(p["seed"])) claims.push_back(claim);
  claims.push_back(upright_pipe(p["seed"]));
  Quantity fast = under_force("nearly_upright", "the same with the pipe at 0.01 rad from the vertical", steep,
                              {Outcome::inaccurate, Outcome::inaccurate}, horizon, truth);
  fast.add(Breakdown{
      "Where the pipe is nearly upright the division by $\\sin^2\\varphi$ makes a slow swing a quick one: "
      "explicit "
      "Euler at eight steps a second gains energy and whirls round. Runge-Kutta's stability reaches up the "
      "imaginary axis.",
      two + ", explicit Euler", 0.125, Outcome::drifted, two + ", Runge-Kutta 4", 0.0009765625});
  fast.add(Breakdown{
      "In Cartesian coordinates nothing calls the center back to its circle: at steps that are long for its "
      "small "
      "radius even Runge-Kutta's center leaves for infinity. An angle cannot leave the circle.",
      cartesian + ", Runge-Kutta 4", 0.125, Outcome::non_finite, one + ", Runge-Kutta 4", 0.0009765625});
  return {claims,
          {under_gravity(free, truth), motion(scene(), p, truth),
           under_force("frictionless", "the same with the force alone", frictionless,
                       {Outcome::inaccurate, Outcome::inaccurate}, horizon, truth),
           fast, upright(pushed, truth)}};
}

}  // namespace ex03_21

Exercise exercise_3_21() {
  using namespace ex03_21;
  return {"Pipe and disk",
          "A disk spins about a pipe that is held at the inclination $\\varphi$ and free to turn about the "
          "vertical. "
          "How do the two angles move under gravity? Under a horizontal force?",
          parameters, scene(), study};
}

}  // namespace oddity
