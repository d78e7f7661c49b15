// The claims of exercise 3.27. The equations are derived from T and V of the two bodies in space by nested
// dual numbers. Positions are in the book's coordinates, P = x2 - x1 = r (sin phi cos theta, sin phi sin
// theta, cos phi). Whole motions are compared with Cartesian coordinates.

#include "chapters/provable_claims.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "chapters/03_rigid_body_motion/27_two_bodies/two_bodies.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "chapters/scene.hpp"
#include "solvers/dual.hpp"
#include "solvers/linear.hpp"

namespace oddity::two_bodies {

/// Random bodies and a state (q, v) of q = (r, theta, phi).
template <class T>
struct SampleOf {
  T G, m1, m2;
  std::array<T, 3> q, v;

  Letters<T> table() {
    return {{"G", G, {0.5, 2.0}},         {"m_1", m1, {0.3, 3}},
            {"m_2", m2, {0.3, 3}},        {"r", q[0], {0.5, 2}},
            {R"(\theta)", q[1], {-3, 3}}, {R"(\varphi)", q[2], {0.4, 2.7}, "phi"},
            {R"(\dot r)", v[0], {-2, 2}}, {R"(\dot\varphi)", v[2], {-2, 2}}};
  }
  /// Size of the equations' terms divided by r and by theta's inertia, which is r^2 sin^2 phi.
  double size() const {
    const double r = q[0], speed = std::abs(v[0]) + r * std::abs(v[2]), sine = std::sin(q[2]);
    const double forces = speed * speed / r + gamma() / (r * r) + m1 + m2 + G * m1 * m2;
    return forces * (1 + speed) * (1 + 1 / (r * r)) / (sine * sine);
  }
  TypesetIn<T> typeset() const {
    return {{"c_1", m1 * m2 / (m1 + m2)}, {"c_2", G * m1 * m2}, {R"(\beta)", beta()}, {R"(\gamma)", gamma()}};
  }
  /// Size of the terms of r'' that do not always cancel.
  double terms() const {
    const double speed = std::abs(v[0]) + q[0] * std::abs(v[2]);
    return speed * speed / q[0] + gamma() / (q[0] * q[0]);
  }
  T beta() const { return q[0] * q[0] * v[2]; }
  T gamma() const { return G * (m1 + m2); }

  /// Both bodies' positions, with the centre of mass at the origin.
  template <class X>
  std::array<X, 6> bodies(const std::array<X, 3>& at) const {
    const std::array<X, 3> P{at[0] * sin(at[2]) * cos(at[1]), at[0] * sin(at[2]) * sin(at[1]),
                             at[0] * cos(at[2])};
    const X a(-m2 / (m1 + m2)), b(m1 / (m1 + m2));
    return {a * P[0], a * P[1], a * P[2], b * P[0], b * P[1], b * P[2]};
  }
  template <class X>
  X kinetic(const std::array<X, 3>& at, const std::array<X, 3>& speed) const {
    X sum(0.0);
    const auto x = bodies(moving(at, speed));
    for (std::size_t i = 0; i < 6; ++i) sum += X((i < 3 ? m1 : m2) / 2) * x[i].slope * x[i].slope;
    return sum;
  }
  template <class X>
  X potential(const std::array<X, 3>& at) const {
    const auto x = bodies(at);
    X square(0.0);
    for (std::size_t i = 0; i < 3; ++i) square += (x[i + 3] - x[i]) * (x[i + 3] - x[i]);
    return X(-G * m1 * m2) / sqrt(square);
  }
  /// (r'', theta'', phi'') by Lagrange's equations.
  std::array<T, 3> lagrange(const std::array<T, 3>& speed) const {
    return lagrange_accelerations(
        [this](const auto& at, const auto& rates) { return this->kinetic(at, rates) - this->potential(at); },
        q, speed);
  }
  /// The number of independent directions in which r, theta and phi move the positions.
  int freedoms() const {
    Eigen::MatrixXd by(6, 3);
    for (int j = 0; j < 3; ++j) {
      const auto x = bodies(toward(q, static_cast<std::size_t>(j)));
      for (int k = 0; k < 6; ++k) by(k, j) = x[static_cast<std::size_t>(k)].slope;
    }
    return static_cast<int>(rank(by));
  }
};

using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;

namespace {

/// Tolerance of the compared integrations.
constexpr double integrated_to = 1e-13;
const Tolerance by_integration{1000 * integrated_to, "a thousand tolerances of the integration"};

/// (x, y, u) at t = 1 by the published system with another gamma, or without its fraction bars over r^2.
Value by_system(const Bodies& b, double gamma, bool bars = true) {
  const double beta = Published<double>{b}.beta();
  const auto rhs = [=](const std::array<double, 3>& x, std::array<double, 3>& dxdt, double) {
    const double square = x[0] * x[0], over = bars ? 1 / square : square;
    dxdt = {x[1], beta * beta / (square * x[0]) - gamma * over, beta * over};
  };
  const auto x =
      ode::integrate<ode::Fehlberg78>(rhs, std::array{b.r0, b.r0_dot, b.phi0}, 0, 1, integrated_to).value;
  return {x[0] * std::cos(x[2]), x[0] * std::sin(x[2]), x[1]};
}

/// A random initial condition similar to the default, and both bodies a second later in Cartesian
/// coordinates.
struct Later {
  Bodies b;
  double dx, dy, vx, vy;

  explicit Later(Random& random)
      : b{random.between(0.5, 2), random.between(0.5, 2), random.between(0.5, 2),    random.between(1, 2),
          random.between(-1, 1),  random.between(-3, 3),  random.magnitude(0.5, 1.5)} {
    const BothBodies<double> model{b};
    const auto x = ode::integrate<ode::Fehlberg78>(model, model.start(), 0, 1, integrated_to).value;
    dx = x[2] - x[0], dy = x[3] - x[1], vx = x[6] - x[4], vy = x[7] - x[5];
  }
  Tolerance tolerance(double) const { return by_integration; }
  TypesetLetters typeset() const { return {{"r_0", b.r0}, {R"(\dot\varphi_0)", b.phi0_dot}}; }
};

/// An initial condition in space on the meridian theta0, near one of the poles, which it passes. The second
/// body relative to the first a second later, in Cartesian coordinates and in the plane of the published
/// system.
struct PastThePole {
  double theta0;
  Bodies b;
  std::array<double, 6> x;
  Value flat;

  explicit PastThePole(Random& random) {
    b = {random.between(0.5, 2), random.between(0.5, 2),   random.between(0.5, 2),    random.between(1, 2),
         random.between(-1, 1),  random.between(0.1, 0.3), random.between(-1.5, -0.5)};
    if (random.unit() < 0.5) b.phi0 = std::numbers::pi - b.phi0, b.phi0_dot = -b.phi0_dot;
    theta0 = random.magnitude(0.5, 2.5);
    const double gamma = b.G * (b.m1 + b.m2), c = std::cos(b.phi0), s = std::sin(b.phi0);
    const double across = b.r0_dot * s + b.r0 * b.phi0_dot * c, ct = std::cos(theta0), st = std::sin(theta0);
    const std::array start{b.r0 * s * ct, b.r0 * s * st, b.r0 * c,
                           across * ct,   across * st,   b.r0_dot * c - b.r0 * b.phi0_dot * s};
    const auto rhs = [=](const std::array<double, 6>& now, std::array<double, 6>& dxdt, double) {
      const double r = std::hypot(now[0], now[1], now[2]), pull = -gamma / (r * r * r);
      dxdt = {now[3], now[4], now[5], pull * now[0], pull * now[1], pull * now[2]};
    };
    x = ode::integrate<ode::Fehlberg78>(rhs, start, 0, 1, integrated_to).value;
    flat = by_system(b, gamma);
  }
  Tolerance tolerance(double) const { return by_integration; }
  /// The distances from the axis and from the equator's plane, by the published system.
  TypesetLetters typeset() const { return {{R"(\theta_0)", theta0}, {R"(\rho)", flat[1]}, {"z", flat[0]}}; }
};

const std::string by_lagrange = "Lagrange's equations of both bodies by nested dual numbers";

void accelerations(Table& table, const std::vector<Sample>& all) {
  const auto claim = table.over(all);
  const std::string radial = R"($\ddot r=\beta^2/r^3-\gamma/r^2$)";
  claim("radial_equation", 2757, radial,
        {by_lagrange, [](const auto& k) { return k.lagrange(k.v)[0]; }, &Sample::terms}, radial,
        R"($\ddot r$)");
  claim("phi_equation", 2773,
        R"($\dot\varphi=\beta/r^2$ (our check: its rate, $\ddot\varphi=\frac{d}{dt}(\beta/r^2)$))",
        {by_lagrange, [](const auto& k) { return k.lagrange(k.v)[2]; },
         [](const Sample& k) { return k.terms() / k.q[0]; }},
        R"($\ddot\varphi=\frac{d}{dt}(\beta/r^2)$)", R"($\ddot\varphi$)");
}

/// Claims about the constants in T and V.
void constants(Table& table, const std::vector<Sample>& all) {
  const auto c1 = [](const auto& k) {
    const auto along = [&]<class X>(const X& x) {
      return k.template kinetic<X>({X(k.q[0]), X(k.q[1]), X(k.q[2])}, {x, X(0.0), X(k.v[2])});
    };
    return second_derivative(along, k.v[0]);
  };
  const auto c2 = [](const auto& k) { return -k.potential(k.q) * k.q[0]; };
  const auto claim = table.over(all);
  claim("gamma_constants", 2767, "The constants are $c_1=m_1m_2/(m_1+m_2)$ and $c_2=Gm_1m_2$",
        {R"($\partial^2T/\partial\dot r^2$ and $-rV$ by dual numbers)",
         [=](const auto& k) { return values(c1(k), c2(k)); }},
        R"($(m_1m_2/(m_1+m_2),\ Gm_1m_2)$)", R"($(c_1,c_2)$)");
  constexpr Bodies b = usual;
  const auto row = [](const std::string& first) {
    return "$(" + first + R"(,\ Gm_1m_2/(m_1m_2/(m_1+m_2)),\ G(m_1+m_2))$)";
  };
  claim(
      "gamma", 2765, R"($\gamma=c_2c_1=Gm_1m_2/(m_1m_2/(m_1+m_2))=G(m_1+m_2)$)",
      {.quantity = R"($\gamma$)",
       .truth = {R"($c_2/c_1$ by dual numbers of $V$ and $T$)", [=](const auto& k) { return c2(k) / c1(k); }},
       .printed = row("c_2c_1"),
       .meant = row("c_2/c_1"),
       .why = filled(
           R"(The bar of $c_2/c_1$ is lost, as is that of the quotient that follows, whose parts are on two lines. )"
           R"(Of the scene's bodies, $m_1=@1$ and $m_2=@1$ with $G=@1$, the product is @3 and $\gamma=@1$.)",
           {b.m1, b.m2, b.G, b.G * b.m1 * b.m2 * (b.m1 * b.m2 / (b.m1 + b.m2)), b.G * (b.m1 + b.m2)})});
}

void equations(Claims& claims, const std::vector<Sample>& all, const std::vector<PastThePole>& passing) {
  using K = const Sample&;
  const std::vector<Sample> first(all.begin(), all.begin() + 100);
  claims.statement<Sample>("three_degrees", 2755,
                           R"(The three degrees of freedom are $r$, $\theta$ and $\varphi$)", first,
                           {.printed = {"the positions move with them in three independent ways",
                                        [](K k) { return k.freedoms() == 3; }},
                            .near_misses = {{"in two", [](K k) { return k.freedoms() == 2; }}}});

  const auto stays = [&](double rate) {
    const Formula<Sample> turning{by_lagrange, [=](K k) { return k.lagrange({k.v[0], rate, k.v[2]})[1]; }};
    return compare(R"($\ddot\theta$)", turning, {"zero", [](K) { return 0.0; }}, all);
  };
  const Formula<PastThePole> in_space{"the relative motion in Cartesian coordinates, Fehlberg 7(8)",
                                      [](const PastThePole& k) { return values(k.x[0], k.x[1], k.x[2]); }};
  const std::string place = "$(x,y,z)$ at $t=1$",
                    on_meridian = R"($(\rho\cos\theta_0,\ \rho\sin\theta_0,\ z)$)";
  // The text's "theta_0 = 0" has lost its overdot: theta is the angle about the pole, and the plane can be
  // any meridian.
  claims.add("theta_constant", 2755, R"(With $\dot\theta=0$ at the start $\theta$ keeps its value)",
             {.printed = {R"($\ddot\theta=0$ where $\dot\theta=0$)",
                          {stays(0), compare<PastThePole>(place, computed(Formula<PastThePole>{on_meridian}),
                                                          in_space, passing)}},
              .near_misses = {{R"($\ddot\theta=0$ also where $\dot\theta=1$)", {stays(1)}}}});
  claims.over(passing)(
      "initial_conditions", 2787,
      R"(The initial conditions are $r_0,\dot r_0,\varphi_0$ and $\dot\varphi_0$ (our check: the place that they )"
      R"(determine, $\rho=r\sin\varphi$ from the axis))",
      {.quantity = place,
       .truth = in_space,
       .printed = {R"($(\rho,\ 0,\ z)$)"},
       .meant = {on_meridian},
       .kind = Fault::left_out,
       .why =
           R"(The list lacks $\theta_0$, which by the first line has to be specified. The motion in its )"
           R"(plane does not need it, the place in space does: without it every orbit lies on the meridian )"
           R"($\theta=0$, turned by $\theta_0$ out of its plane.)"});
}

void motions(Claims& claims, const std::vector<Later>& all) {
  using K = const Later&;
  const std::string cartesian = "both bodies in Cartesian coordinates, Fehlberg 7(8)";
  const auto gamma = [](K k) { return k.b.G * (k.b.m1 + k.b.m2); };
  const auto claim = claims.over(all);
  claim("beta", 2765, R"($\beta=r_0^2\dot\varphi_0$ (our check: $r^2\dot\varphi$ keeps this value))",
        {cartesian, [](K k) { return k.dx * k.vy - k.dy * k.vx; }}, {R"($r_0^2\dot\varphi_0$)"},
        R"($r^2\dot\varphi$ at $t=1$)");
  claim(
      "first_order_system", 2779,
      R"(The motion is that of $\dot r=u$, $\dot u=\beta^2/r^3-\gamma r^2$, $\dot\varphi=\beta r^2$ from )"
      R"($(r_0,\dot r_0,\varphi_0)$)",
      {.quantity = R"($(x,y,u)$ at $t=1$)",
       .truth = {cartesian,
                 [](K k) {
                   return values(k.dx, k.dy, (k.dx * k.vx + k.dy * k.vy) / std::hypot(k.dx, k.dy));
                 }},
       .printed = {R"($\dot u=\beta^2/r^3-\gamma r^2$, $\dot\varphi=\beta r^2$)",
                   [=](K k) { return by_system(k.b, gamma(k), false); }},
       .meant = {R"($\dot u=\beta^2/r^3-\gamma/r^2$, $\dot\varphi=\beta/r^2$)",
                 [=](K k) { return by_system(k.b, gamma(k)); }},
       .near_misses = {{R"(as meant, with $\gamma=Gm_1$)",
                        [=](K k) { return by_system(k.b, k.b.G * k.b.m1); }}},
       .why =
           R"(The bars over $r^2$ are lost in lines 2783 and 2785; the equations in lines 2757 and 2773 have the )"
           R"(parts of each fraction on two lines. The text at hand reads $\gamma r^2$ and $\beta r^2$.)"});
}

/// The three unknowns from the data that the text lists, with beta and gamma computed from them, compared
/// with the tabulated path, which uses neither.
void state_and_data(Claims& claims, const Reference& truth) {
  constexpr Bodies b = usual;
  constexpr double tolerance = 1e-12;
  const Horizon horizon{seconds};
  const std::string path = filled("path at four times to @1 s", {seconds});
  const Route known{"Kepler's equation in universal variables",
                    trajectory(truth, "03_27_two_bodies", inputs(b), horizon).value};
  const auto compared = [&](const std::string& text, const std::string& by, const Value& found,
                            const Tolerance& allowed) {
    return Reading{text, {Check{path, {R"($r,u,\varphi$ )" + by, found}, known, allowed, 1}}};
  };
  const auto from = [&](const std::string& text, const Bodies& data) {
    return compared(text, "integrated",
                    observe_integrated<ode::Fehlberg78>(Published<double>{data}, horizon, tolerance).value,
                    {1000 * tolerance, "a thousand tolerances of the integration"});
  };
  Bodies still = b;
  still.r0_dot = 0;
  claims.add(
      "state_and_data", 2787,
      R"(The state is $r,u,\varphi$, the data are $m_1,m_2,G$ with the four initial values, and $\beta$ and )"
      R"($\gamma$ follow from them (our reading: these determine the motion in its plane))",
      {.printed = from("the motion from these alone", b),
       .near_misses = {from(R"(without the rate $\dot r_0$)", still)}});

  // the program as the solution of 3.15 lists it: a state of numbers, and fixed steps of Runge-Kutta 4
  const auto in_steps = [&](double step) {
    const std::string by = "Runge-Kutta 4 in steps of " + format_shortest(step) + " s";
    return compared(by, "by " + by,
                    observe_integrated<ode::RungeKutta4>(Published<double>{b}, horizon, step).value,
                    {need, "the scene's need, a micrometre"});
  };
  claims.add(
      "module_pattern", 2787,
      "The pattern of the `PhysicsModule` files may be used here (our reading: equal steps of Runge-Kutta 4)",
      {.printed = in_steps(0.01), .near_misses = {in_steps(0.25)}});
}

}  // namespace

std::vector<double> inputs(const Bodies& b) { return {b.G, b.m1, b.m2, b.r0, b.r0_dot, b.phi0, b.phi0_dot}; }

std::vector<Claim> claims(double seed, const Reference& truth) {
  Claims claims("3.27");
  Table table(claims);
  const auto samples = draw<Sample>(200, seed);
  equations(claims, samples, draw<PastThePole>(20, seed));
  constants(table, samples);
  accelerations(table, samples);
  motions(claims, draw<Later>(20, seed));
  state_and_data(claims, truth);
  return claims.in_order();
}

Provables proofs() {
  Claims claims("3.27");
  Table table(claims);
  constants(table, {});
  auto all =
      for_all<SampleOf>("by_distance m1 m2 r theta phi", "it holds for any two bodies wherever they are",
                        {0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25});
  all.given = positive({all.any.G, all.any.m1, all.any.m2, all.any.q[0]});
  all.preamble = coq_source({"bodies"});
  Provables proved = table.proofs("3.27", all);
  Table of_motion(claims);
  accelerations(of_motion, {});
  all.given.push_back(not_zero(sin(all.any.q[2].expression())));
  all.says = "it holds for any two bodies off the axis";
  append(proved, of_motion.proofs("3.27", all));
  return proved;
}

}  // namespace oddity::two_bodies
