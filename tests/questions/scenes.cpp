// The 18 scenes, each by its masses, its potential energy, and its observables, in the exercises' words. None
// of the equations of motion that follow from them is used.

#include "tests/questions/scenes.hpp"

#include <numbers>

#include "tests/questions/follow.hpp"

namespace questions {

namespace {

constexpr Real pi = std::numbers::pi_v<Real>;

template <class X>
using Vector = std::array<X, 3>;
template <class X>
X dot(const Vector<X>& a, const Vector<X>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class X>
Vector<X> cross(const Vector<X>& a, const Vector<X>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class X>
X square(const X& x) {
  return x * x;
}
using std::cos, std::sin, std::sqrt;

template <class X>
using Points = std::array<Moving<X>, 3>;
/// A point of this mass.
template <class X>
Points<X> point(Real mass, const Vector<X>& at) {
  return {{{mass, at[0]}, {mass, at[1]}, {mass, at[2]}}};
}
template <std::size_t n>
Values values(const std::array<Real, n>& x) {
  return {x.begin(), x.end()};
}
template <std::size_t n>
std::array<Real, n> first(const Real* q) {
  std::array<Real, n> x;
  std::copy(q, q + n, x.begin());
  return x;
}

// 2.7: a sphere turns as the frame (r, u, r x u) of a curve r(t) on it, u = r'/|r'|.
Motion curve_on_sphere(const Parameters& p) {
  const Real pace = p.at("pace");
  return {{}, {}, {}, [pace](const Real*, Real time) -> Values {
            const auto t = Jet<1>::variable(pace * time, 0);
            const auto height = t * t, flat = Jet<1>(1) - height, turn = Jet<1>(pi) * t;
            const auto size = sqrt(flat * flat + height * height);
            const Vector<Jet<1>> r{flat * cos(turn) / size, flat * sin(turn) / size, height / size};
            Vector<Real> at, u;
            for (std::size_t i = 0; i < 3; ++i) at[i] = r[i].x, u[i] = r[i].d[0];
            const Real speed = std::sqrt(dot(u, u));
            for (Real& x : u) x /= speed;
            const auto across = cross(at, u);
            return {at[0], u[0], across[0], at[1], u[1], across[1], at[2], u[2], across[2]};
          }};
}

// 3.3 and 3.27: a body about a fixed sun, G times whose mass is mu; (r, angle) and their rates at the start.
struct Orbit : Coordinates<2> {
  Real mu;
  explicit Orbit(Real m) : mu(m) {}
  template <class X>
  std::array<Moving<X>, 2> moving(const std::array<X, 2>& q, const X&) const {
    return {{{1, q[0]}, {1, q[1]}}};
  }
  template <class X>
  X potential(const std::array<X, 2>& q, const X&) const {
    return X(-mu) / sqrt(q[0] * q[0] + q[1] * q[1]);
  }
  Values observe(const Real* q, Real) const { return {q[0], q[1]}; }
};
Motion orbit(Real mu, Real r, Real r_dot, Real angle, Real angle_dot) {
  const Real c = cos(angle), s = sin(angle), across = r * angle_dot;
  return motion_of(Orbit(mu), {r * c, r * s}, {r_dot * c - across * s, r_dot * s + across * c});
}

// 3.5: a pendulum let go at rest.
struct Pendulum : Coordinates<1> {
  Real L, g;
  Pendulum(Real length, Real gravity) : L(length), g(gravity) {}
  template <class X>
  std::array<Moving<X>, 2> moving(const std::array<X, 1>& q, const X&) const {
    return {{{1, X(L) * sin(q[0])}, {1, X(-L) * cos(q[0])}}};
  }
  template <class X>
  X potential(const std::array<X, 1>& q, const X&) const {
    return X(-g * L) * cos(q[0]);
  }
  Values observe(const Real* q, Real) const { return {q[0]}; }
};

// 3.7: a bead on the curve (q, q^2, q^3), let go at rest.
struct Bead : Coordinates<1> {
  Real g;
  explicit Bead(Real gravity) : g(gravity) {}
  template <class X>
  Points<X> moving(const std::array<X, 1>& q, const X&) const {
    return point(1, Vector<X>{q[0], q[0] * q[0], q[0] * q[0] * q[0]});
  }
  template <class X>
  X potential(const std::array<X, 1>& q, const X&) const {
    return X(g) * (q[0] * q[0] * q[0]);
  }
  Values observe(const Real* q, Real) const { return {q[0], q[0] * q[0], q[0] * q[0] * q[0]}; }
};

// 3.9: a ball in the plane on a spring of rest length zero, with viscous friction.
struct Ball : Coordinates<2> {
  Real m, c, a;
  Ball(Real mass, Real spring, Real friction) : m(mass), c(spring), a(friction) {}
  template <class X>
  std::array<Moving<X>, 2> moving(const std::array<X, 2>& q, const X&) const {
    return {{{m, q[0], a}, {m, q[1], a}}};
  }
  template <class X>
  X potential(const std::array<X, 2>& q, const X&) const {
    return X(c / 2) * (q[0] * q[0] + q[1] * q[1]);
  }
  Values observe(const Real* q, Real) const { return {q[0], q[1]}; }
};

// 3.11: a particle on the hill x3 = -x1^2/a1^2 - x2^2/a2^2.
struct Hill : Coordinates<2> {
  Real a1, a2, g;
  Hill(Real first_axis, Real second_axis, Real gravity) : a1(first_axis), a2(second_axis), g(gravity) {}
  template <class X>
  X height(const X& x1, const X& x2) const {
    return X(-1 / (a1 * a1)) * (x1 * x1) + X(-1 / (a2 * a2)) * (x2 * x2);
  }
  template <class X>
  Points<X> moving(const std::array<X, 2>& q, const X&) const {
    return point(1, Vector<X>{q[0], q[1], height(q[0], q[1])});
  }
  template <class X>
  X potential(const std::array<X, 2>& q, const X&) const {
    return X(g) * height(q[0], q[1]);
  }
  Values observe(const Real* q, Real) const { return {q[0], q[1], height(q[0], q[1])}; }
};
// From the top, at `factor` times the speed at which the hill does not push on the path along (v1, v2).
Motion on_hill(const Parameters& p) {
  const Hill hill(p.at("a1"), p.at("a2"), p.at("g"));
  const Real v1 = p.at("v1"), v2 = p.at("v2");
  const Real free = sqrt(hill.g / 2 / (square(v1 / hill.a1) + square(v2 / hill.a2))) * p.at("factor");
  return motion_of(hill, {0, 0}, {free * v1, free * v2});
}

// 3.13: a ball in a cylinder of radius R about an axis that falls by H over its length L. Coordinates: the
// way down the axis, and the angle about it from the lowest line.
struct Chute : Coordinates<2> {
  Real R, g, s, c;
  Chute(Real radius, Real L, Real H, Real gravity)
      : R(radius), g(gravity), s(H / L), c(sqrt((L - H) * (L + H)) / L) {}
  template <class X>
  Vector<X> at(const X& along, const X& phi) const {
    const X up = X(R) * (X(1) - cos(phi));
    return {X(c) * along + X(s) * up, X(R) * sin(phi), X(c) * up - X(s) * along};
  }
  template <class X>
  Points<X> moving(const std::array<X, 2>& q, const X&) const {
    return point(1, at(q[0], q[1]));
  }
  template <class X>
  X potential(const std::array<X, 2>& q, const X&) const {
    return X(g) * at(q[0], q[1])[2];
  }
  Values observe(const Real* q, Real) const { return values(at(q[0], q[1])); }
};

// 3.15: a mass at the distance s along a rod at 45 degrees that turns about x3 with w. A spring, relaxed at
// the start, joins it to (c, 0, 0).
struct Rod : Coordinates<1> {
  Real m, c, K, w, ell;
  Rod(Real mass, Real foot, Real stiffness, Real turn, Real start)
      : m(mass), c(foot), K(stiffness), w(turn), ell(0) {
    const auto x = at(start, Real(0));
    ell = sqrt(square(x[0] - c) + square(x[1]) + square(x[2]));
  }
  template <class X>
  Vector<X> at(const X& s, const X& t) const {
    const X side = X(sqrt(Real(0.5))) * s, turn = X(w) * t;
    return {side * cos(turn), side * sin(turn), side};
  }
  template <class X>
  Points<X> moving(const std::array<X, 1>& q, const X& t) const {
    return point(m, at(q[0], t));
  }
  template <class X>
  X potential(const std::array<X, 1>& q, const X& t) const {
    const auto x = at(q[0], t);
    return X(K / 2) * square(sqrt(square(x[0] - X(c)) + square(x[1]) + square(x[2])) - X(ell));
  }
  Values observe(const Real* q, Real t) const { return values(at(q[0], t)); }
};

// 3.17: a bob at the distance L from a pivot on an Earth that turns; x west, y north, z down. In axes that do
// not turn it is at r turned about w; the plumb line's weight is along z.
struct Foucault : Coordinates<3> {
  static constexpr std::size_t constraints = 1;
  Real lambda, L, omega, g;
  explicit Foucault(const Parameters& p)
      : lambda(p.at("lambda")), L(p.at("L")), omega(p.at("omega")), g(p.at("g")) {}
  template <class X>
  Points<X> moving(const Vector<X>& r, const X& t) const {
    const Vector<X> axis{X(0), X(cos(lambda)), X(-sin(lambda))}, side = cross(axis, r);
    const X turn = X(omega) * t, C = cos(turn), S = sin(turn), along = dot(axis, r) * (X(1) - C);
    Vector<X> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = C * r[i] + S * side[i] + along * axis[i];
    return point(1, at);
  }
  template <class X>
  X potential(const Vector<X>& r, const X&) const {
    return X(-g) * r[2];
  }
  template <class X>
  std::array<X, 1> held(const Vector<X>& r, const X&) const {
    return {dot(r, r) - X(L * L)};
  }
  Values observe(const Real* q, Real) const { return {q[0], q[1]}; }
};
Motion foucault(const Parameters& p) {
  const auto theta = Jet<2>::variable(p.at("theta"), 0), phi = Jet<2>::variable(p.at("phi"), 1);
  const Jet<2> L(p.at("L"));
  Values q, v;
  for (const auto& x : {L * cos(theta) * sin(phi), L * sin(theta) * sin(phi), L * cos(phi)}) {
    q.push_back(x.x);
    v.push_back(x.d[0] * p.at("theta_dot") + x.d[1] * p.at("phi_dot"));
  }
  return motion_of(Foucault(p), q, v);
}

// 3.19: depth y2 of a pulley (m2, I2, R2) that hangs from a rope over a fixed pulley (I1, R1) to a spring
// (c1, L1). Depth y3 of a mass (m3) on a rope over the first pulley to a spring (c2, L2). The ropes do not
// slip.
struct Pulleys : Coordinates<2> {
  Parameters p;
  explicit Pulleys(const Parameters& all) : p(all) {}
  Real m2 = p.at("m2"), m3 = p.at("m3"), I1 = p.at("I1"), I2 = p.at("I2"), R1 = p.at("R1"), R2 = p.at("R2"),
       c1 = p.at("c1"), c2 = p.at("c2"), slack1 = p.at("K1") - p.at("L1"), slack2 = p.at("K2") - p.at("L2"),
       g = p.at("g");
  template <class X>
  std::array<Moving<X>, 4> moving(const std::array<X, 2>& y, const X&) const {
    return {{{m2, y[0]}, {m3, y[1]}, {I1, y[0] * X(1 / R1)}, {I2, (y[1] - y[0]) * X(1 / R2)}}};
  }
  template <class X>
  X potential(const std::array<X, 2>& y, const X&) const {
    const X first_stretch = y[0] + X(slack1), second_stretch = y[1] - X(2) * y[0] + X(slack2);
    return X(c1 / 2) * square(first_stretch) + X(c2 / 2) * square(second_stretch) - X(m2 * g) * y[0] -
           X(m3 * g) * y[1];
  }
  Values observe(const Real* q, Real) const { return {q[0], q[1]}; }
};

// 3.21: a disk (m, r) at the end of a pipe of length L at a fixed inclination phi. The pipe turns (theta)
// about the vertical, the disk turns (psi) about the pipe; a force f along x and friction k act on its
// center.
struct Disk : Coordinates<2> {
  Real m, L, r, phi, f, k;
  explicit Disk(const Parameters& p)
      : m(p.at("m")), L(p.at("L")), r(p.at("r")), phi(p.at("phi")), f(p.at("f")), k(p.at("k")) {}
  Real arm() const { return L * sin(phi); }
  template <class X>
  std::array<Moving<X>, 4> moving(const std::array<X, 2>& q, const X&) const {
    const X across = X(sin(phi)) * q[0], about = q[1] + X(cos(phi)) * q[0];
    return {{{m, X(arm()) * cos(q[0]), k},
             {m, X(arm()) * sin(q[0]), k},
             {m * r * r / 4, across},
             {m * r * r / 2, about}}};
  }
  template <class X>
  X potential(const std::array<X, 2>& q, const X&) const {
    return X(-f * arm()) * cos(q[0]);
  }
  Values observe(const Real* q, Real) const { return {arm() * cos(q[0]), arm() * sin(q[0]), q[1]}; }
};

// 3.23: a mass at the distance r on a bar about the origin; a spring from (s, -h) supports the bar at s.
struct Bar : Coordinates<1> {
  Real m, r, s, c, h, g, ell;
  explicit Bar(const Parameters& p)
      : m(p.at("m")),
        r(p.at("r")),
        s(p.at("s")),
        c(p.at("c")),
        h(p.at("h")),
        g(p.at("g")),
        ell(p.at("ell")) {}
  template <class X>
  std::array<Moving<X>, 2> moving(const std::array<X, 1>& q, const X&) const {
    return {{{m, X(r) * cos(q[0])}, {m, X(r) * sin(q[0])}}};
  }
  template <class X>
  X potential(const std::array<X, 1>& q, const X&) const {
    const X length = sqrt(square(X(s) * cos(q[0]) - X(s)) + square(X(s) * sin(q[0]) + X(h)));
    return X(m * g * r) * sin(q[0]) + X(c / 2) * square(length - X(ell));
  }
  Values observe(const Real* q, Real) const { return {r * cos(q[0]), r * sin(q[0])}; }
};

// 3.25: three masses on massless rods, hung one from the other from (0, h); angles from the downward
// vertical.
struct Chain : Coordinates<3> {
  std::array<Real, 3> m, r;
  Real g, h;
  explicit Chain(const Parameters& p)
      : m{p.at("m1"), p.at("m2"), p.at("m3")},
        r{p.at("r1"), p.at("r2"), p.at("r3")},
        g(p.at("g")),
        h(p.at("h")) {}
  template <class X>
  std::array<X, 6> at(const std::array<X, 3>& q) const {
    std::array<X, 6> x;
    for (std::size_t k = 0; k < 3; ++k) {
      x[2 * k] = (k ? x[2 * k - 2] : X(0)) + X(r[k]) * sin(q[k]);
      x[2 * k + 1] = (k ? x[2 * k - 1] : X(h)) - X(r[k]) * cos(q[k]);
    }
    return x;
  }
  template <class X>
  std::array<Moving<X>, 6> moving(const std::array<X, 3>& q, const X&) const {
    const auto x = at(q);
    return {{{m[0], x[0]}, {m[0], x[1]}, {m[1], x[2]}, {m[1], x[3]}, {m[2], x[4]}, {m[2], x[5]}}};
  }
  template <class X>
  X potential(const std::array<X, 3>& q, const X&) const {
    const auto x = at(q);
    return X(g * m[0]) * x[1] + X(g * m[1]) * x[3] + X(g * m[2]) * x[5];
  }
  Values observe(const Real* q, Real) const { return values(at(first<3>(q))); }
};

// 3.29: the wire y = x^2 from 0 to q, thrown from its center of mass, turning; its first end is watched.
struct Wire : Coordinates<3> {
  Real mass = 0, inertia = 0, g, end_x = 0, end_y = 0;
  Wire(Real q, Real density, Real gravity) : g(gravity) {
    static const Gauss gauss(24);
    constexpr int panels = 64;
    Real x1 = 0, y1 = 0, square2 = 0;
    for (int panel = 0; panel < panels; ++panel)
      for (std::size_t i = 0; i < gauss.at.size(); ++i) {
        const Real x = (panel + gauss.at[i]) / panels * q, y = x * x;
        const Real dm = density * sqrt(1 + 4 * x * x) * gauss.weight[i] / panels * q;
        mass += dm;
        x1 += dm * x;
        y1 += dm * y;
        square2 += dm * (x * x + y * y);
      }
    end_x = -x1 / mass;
    end_y = -y1 / mass;
    inertia = square2 - mass * (end_x * end_x + end_y * end_y);
  }
  template <class X>
  std::array<Moving<X>, 3> moving(const std::array<X, 3>& q, const X&) const {
    return {{{mass, q[0]}, {mass, q[1]}, {inertia, q[2]}}};
  }
  template <class X>
  X potential(const std::array<X, 3>& q, const X&) const {
    return X(mass * g) * q[1];
  }
  Values observe(const Real* q, Real) const {
    const Real C = cos(q[2]), S = sin(q[2]);
    return {q[0] + C * end_x - S * end_y, q[1] + S * end_x + C * end_y};
  }
};

// 3.31: a box of half sides a and b on a rough level plane under uniform pressure. Friction at a point acts
// against its velocity.
struct Box : Coordinates<3> {
  Real a, b, mu_g;
  Box(Real half_length, Real half_width, Real friction) : a(half_length), b(half_width), mu_g(friction) {}
  Real inertia() const { return (a * a + b * b) / 3; }
  template <class X>
  std::array<Moving<X>, 3> moving(const std::array<X, 3>& q, const X&) const {
    return {{{1, q[0]}, {1, q[1]}, {inertia(), q[2]}}};
  }
  template <class X>
  X potential(const std::array<X, 3>&, const X&) const {
    return X(0);
  }
  std::array<Real, 3> push(const Real* q, const Real* v, Real) const {
    const Real C = cos(q[2]), S = sin(q[2]);
    const auto mean = mean_direction(C * v[0] + S * v[1], C * v[1] - S * v[0], v[2]);
    return {-mu_g * (C * mean[0] - S * mean[1]), -mu_g * (S * mean[0] + C * mean[1]), -mu_g * mean[2]};
  }
  /// Means over the foot, in its axes, of the velocity's direction and of its moment.
  std::array<Real, 3> mean_direction(Real u, Real v, Real w) const {
    std::array<Real, 3> mean{};
    if (u == 0 && v == 0 && w == 0) return mean;
    if (std::hypot(u, v) > 6 * std::abs(w) * std::hypot(a, b)) {  // far from the center of turning: smooth
      static const Gauss gauss(16);
      for (std::size_t i = 0; i < gauss.at.size(); ++i)
        for (std::size_t j = 0; j < gauss.at.size(); ++j) {
          const Real x = a * (2 * gauss.at[i] - 1), y = b * (2 * gauss.at[j] - 1);
          const Real vx = u - w * y, vy = v + w * x;
          const Real part = gauss.weight[i] * gauss.weight[j] / sqrt(vx * vx + vy * vy);
          mean[0] += part * vx;
          mean[1] += part * vy;
          mean[2] += part * (x * vy - y * vx);
        }
      return mean;
    }
    // The foot as four signed triangles from the center of turning c. The edge of one is at the distance k
    // along its normal n, from y1 to y2 along s. An element is r dr dphi = r dr k dy/(k^2 + y^2). The
    // direction is (k s - y n)/sqrt(k^2 + y^2).
    const Real cx = -v / w, cy = u / w;
    Real along_x = 0, along_y = 0, radial = 0;
    const auto edge = [&](Real nx, Real ny, Real k, Real y1, Real y2) {
      if (k == 0) return;
      const Real r1 = std::hypot(k, y1), r2 = std::hypot(k, y2);
      const Real turned = std::asinh(y2 / std::abs(k)) - std::asinh(y1 / std::abs(k));
      along_x += k / 2 * (k * -ny * turned - nx * (r2 - r1));
      along_y += k / 2 * (k * nx * turned - ny * (r2 - r1));
      radial += k / 6 * (y2 * r2 - y1 * r1 + k * k * turned);
    };
    edge(1, 0, a - cx, -b - cy, b - cy);
    edge(0, 1, b - cy, cx - a, cx + a);
    edge(-1, 0, a + cx, cy - b, cy + b);
    edge(0, -1, b + cy, -a - cx, a - cx);
    const Real part = (w > 0 ? 1 : -1) / (4 * a * b);
    return {part * along_x, part * along_y, part * (cx * along_y - cy * along_x + radial)};
  }
  Values observe(const Real* q, Real) const { return {q[0], q[1], q[2]}; }
};
Motion rough_box(const Parameters& p) {
  const Box box(p.at("a"), p.at("b"), p.at("mu") * p.at("g"));
  Motion motion = motion_of(box, {0, 0, 0}, {p.at("u0"), p.at("v0"), p.at("w0")});
  const auto speed = [J = box.inertia()](const Real* v) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + J * v[2] * v[2]);
  };
  motion.at_rest = [speed, still = 1e-8L * speed(motion.v.data())](const Real* v) {
    return speed(v) <= still;
  };
  motion.tolerance = 1e-14L;  // friction has no second derivative where the center of turning crosses an edge
  return motion;
}

// 3.33 and 3.35: the axis d of a top about its tip, which may be shaken along x as A sin(lambda t). Its spin
// S about the axis is constant. The rest of its inertia is that of a point mass mu1 at d, which S deflects.
struct Top : Coordinates<3> {
  static constexpr std::size_t constraints = 1;
  Real m, l, mu1, mu3, g, A = 0, lambda = 0, S = 0;
  explicit Top(const Parameters& p)
      : m(p.at("m")), l(p.at("l")), mu1(p.at("mu1")), mu3(p.at("mu3")), g(p.at("g")) {
    if (p.contains("A")) A = p.at("A"), lambda = p.at("lambda");
    S = mu3 * (p.at("dpsi") + p.at("dtheta") * cos(p.at("phi")));
  }
  template <class X>
  Points<X> moving(const Vector<X>& d, const X&) const {
    return point(mu1, d);
  }
  template <class X>
  X potential(const Vector<X>& d, const X& t) const {  // weight, and the force of inertia from the tip's
                                                       // acceleration
    return X(m * l) * (X(g) * d[2] - X(A * lambda * lambda) * sin(X(lambda) * t) * d[0]);
  }
  template <class X>
  std::array<X, 1> held(const Vector<X>& d, const X&) const {
    return {dot(d, d) - X(1)};
  }
  std::array<Real, 3> push(const Real* q, const Real* v, Real) const {
    auto turned = cross(first<3>(q), first<3>(v));
    for (Real& x : turned) x *= S;
    return turned;
  }
  Values observe(const Real* q, Real) const { return values(first<3>(q)); }
};
Motion top(const Parameters& p) {
  const auto theta = Jet<2>::variable(p.at("theta"), 0), phi = Jet<2>::variable(p.at("phi"), 1);
  Values q, v;
  for (const auto& x : {sin(theta) * sin(phi), -cos(theta) * sin(phi), cos(phi)}) {
    q.push_back(x.x);
    v.push_back(x.d[0] * p.at("dtheta") + x.d[1] * p.at("dphi"));
  }
  return motion_of(Top(p), q, v);
}

Real distance(const Values& x, std::size_t i, Real from_x, Real from_y) {
  return std::hypot(x[i] - from_x, x[i + 1] - from_y);
}

/// Half the sum of squares of `count` rates, which come after n observables, starting at `from`.
Real half_square(const Values& x, std::size_t n, std::size_t from, std::size_t count) {
  Real sum = 0;
  for (std::size_t i = n + from; i < n + from + count; ++i) sum += x[i] * x[i] / 2;
  return sum;
}
Energy energy(Real kinetic, Real potential) { return {kinetic + potential, kinetic}; }
Energy orbit_energy(Real mu, const Values& x) {
  return energy(half_square(x, 2, 0, 2), -mu / std::hypot(x[0], x[1]));
}
/// Energy of a point in space.
Energy point_energy(const Parameters& p, const Values& x) {
  return energy(half_square(x, 3, 0, 3), p.at("g") * x[2]);
}
Energy top_energy(const Parameters& p, const Values& x) {  // the spin's is constant
  return energy(p.at("mu1") * half_square(x, 3, 0, 3), p.at("m") * p.at("g") * p.at("l") * x[2]);
}

using P = Parameters;
const Scene all[] = {
    {"2.7", 4, {{"rad", {0, 3, 6}}, {"rad", {1, 4, 7}}, {"rad", {2, 5, 8}}}, curve_on_sphere},
    {"3.3",
     2,
     {{"AU", {0, 1}}},
     [](const P& p) {
       return orbit(p.at("G") * p.at("M"), p.at("r0"), p.at("r0_dot"), p.at("theta0"), p.at("theta0_dot"));
     },
     {},
     [](const P& p, const Values& x) { return orbit_energy(p.at("G") * p.at("M"), x); }},
    {"3.5",
     10,
     {{"rad", {0}}},
     [](const P& p) { return motion_of(Pendulum(p.at("L"), p.at("g")), {p.at("a")}, {0}); },
     {},
     [](const P& p, const Values& x) {
       return energy(square(p.at("L") * x[1]) / 2, 2 * p.at("g") * p.at("L") * square(sin(x[0] / 2)));
     }},
    {"3.7",
     4,
     {{"m", {0, 1, 2}}},
     [](const P& p) { return motion_of(Bead(p.at("g")), {p.at("q0")}, {0}); },
     [](const P&, const Values& x, Real) {  // from the curve's point with the same x
       return std::hypot(x[1] - x[0] * x[0], x[2] - x[0] * x[0] * x[0]);
     },
     point_energy},
    {"3.9",
     5,
     {{"m", {0, 1}}},
     [](const P& p) {
       return motion_of(Ball(p.at("m"), p.at("c"), p.at("a")), {p.at("p1"), p.at("p2")},
                        {p.at("v1"), p.at("v2")});
     },
     {},
     [](const P& p, const Values& x) {
       return energy(p.at("m") * half_square(x, 2, 0, 2), p.at("c") / 2 * (x[0] * x[0] + x[1] * x[1]));
     }},
    {"3.11",
     2,
     {{"m", {0, 1, 2}}},
     on_hill,
     [](const P& p, const Values& x, Real) {
       return std::abs(x[2] - Hill(p.at("a1"), p.at("a2"), p.at("g")).height(x[0], x[1]));
     },
     point_energy},
    {"3.13",
     4,
     {{"m", {0, 1, 2}}},
     [](const P& p) {
       return motion_of(Chute(p.at("R"), p.at("L"), p.at("H"), p.at("g")), {0, p.at("phi")}, {p.at("u"), 0});
     },
     [](const P& p, const Values& x, Real) {
       const Chute chute(p.at("R"), p.at("L"), p.at("H"), p.at("g"));
       const Real up = chute.s * x[0] + chute.c * x[2] - chute.R;  // from the axis, normal to it
       return std::abs(std::hypot(up, x[1]) - chute.R);
     },
     point_energy},
    {"3.15",
     2,
     {{"m", {0, 1, 2}}},
     [](const P& p) {
       return motion_of(Rod(p.at("m"), p.at("c"), p.at("K"), p.at("w"), p.at("s")), {p.at("s")}, {0});
     },
     [](const P& p, const Values& x, Real t) {
       const Real C = cos(p.at("w") * t), S = sin(p.at("w") * t);
       return std::hypot(C * x[1] - S * x[0], (C * x[0] + S * x[1] - x[2]) * sqrt(Real(0.5)));
     },
     [](const P& p, const Values& x) {
       const Rod rod(p.at("m"), p.at("c"), p.at("K"), p.at("w"), p.at("s"));
       return energy(rod.m * half_square(x, 3, 0, 3),
                     rod.K / 2 * square(std::hypot(x[0] - rod.c, x[1], x[2]) - rod.ell));
     }},
    {"3.17", 16, {{"m", {0, 1}}}, foucault},
    {"3.19",
     8,
     {{"m", {0}}, {"m", {1}}},
     [](const P& p) {
       return motion_of(Pulleys(p), {p.at("y2"), p.at("y3")}, {p.at("v2"), p.at("v3")});
     },
     {},
     [](const P& p, const Values& x) {
       const Pulleys rig(p);
       Real kinetic = 0;
       for (const auto& [mass, u, friction] : rig.moving(std::array{x[2], x[3]}, Real(0)))
         kinetic += mass * u * u / 2;
       return energy(kinetic, rig.potential(std::array{x[0], x[1]}, Real(0)));
     }},
    {"3.21",
     8,
     {{"m", {0, 1}}, {"rad", {2}}},
     [](const P& p) {
       return motion_of(Disk(p), {p.at("theta"), 0}, {p.at("theta_dot"), p.at("psi_dot")});
     },
     [](const P& p, const Values& x, Real) { return std::abs(distance(x, 0, 0, 0) - Disk(p).arm()); },
     [](const P& p, const Values& x) {
       const Disk disk(p);
       const Real turn = (x[0] * x[4] - x[1] * x[3]) / (x[0] * x[0] + x[1] * x[1]), r = disk.r / disk.L;
       return energy(disk.m * ((1 + r * r / 4) * half_square(x, 3, 0, 2) +
                               disk.r * disk.r / 4 * square(x[5] + turn * cos(disk.phi))),
                     -disk.f * x[0]);
     }},
    {"3.23",
     4,
     {{"m", {0, 1}}},
     [](const P& p) { return motion_of(Bar(p), {p.at("theta0")}, {p.at("w0")}); },
     [](const P& p, const Values& x, Real) { return std::abs(distance(x, 0, 0, 0) - p.at("r")); },
     [](const P& p, const Values& x) {
       const Bar bar(p);
       const Real part = bar.s / bar.r, length = std::hypot(part * x[0] - bar.s, part * x[1] + bar.h);
       return energy(bar.m * half_square(x, 2, 0, 2),
                     bar.m * bar.g * x[1] + bar.c / 2 * square(length - bar.ell));
     }},
    {"3.25",
     4,
     {{"m", {0, 1}}, {"m", {2, 3}}, {"m", {4, 5}}},
     [](const P& p) {
       return motion_of(Chain(p), {p.at("theta1"), p.at("theta2"), p.at("theta3")},
                        {p.at("omega1"), p.at("omega2"), p.at("omega3")});
     },
     [](const P& p, const Values& x, Real) {
       return std::max({std::abs(distance(x, 0, 0, p.at("h")) - p.at("r1")),
                        std::abs(distance(x, 2, x[0], x[1]) - p.at("r2")),
                        std::abs(distance(x, 4, x[2], x[3]) - p.at("r3"))});
     },
     [](const P& p, const Values& x) {
       Energy sum{0, 0};
       for (std::size_t k = 0; k < 3; ++k) {
         const Real m = p.at("m" + std::to_string(k + 1)), kinetic = m * half_square(x, 6, 2 * k, 2);
         sum.kinetic += kinetic;
         sum.whole += kinetic + m * p.at("g") * (x[2 * k + 1] - p.at("h"));
       }
       return sum;
     }},
    {"3.27",
     4,
     {{"m", {0, 1}}},
     [](const P& p) {
       return orbit(p.at("G") * (p.at("m1") + p.at("m2")), p.at("r0"), p.at("r0_dot"), p.at("phi0"),
                    p.at("phi0_dot"));
     },
     {},
     [](const P& p, const Values& x) { return orbit_energy(p.at("G") * (p.at("m1") + p.at("m2")), x); }},
    {"3.29",
     2,
     {{"m", {0, 1}}},
     [](const P& p) {
       return motion_of(Wire(p.at("q"), p.at("d"), p.at("g")), {0, 0, 0}, {p.at("u"), p.at("v"), p.at("w")});
     }},
    {"3.31",
     1.25,
     {{"m", {0, 1}}, {"rad", {2}}},
     rough_box,
     {},
     [](const P& p, const Values& x) {
       return energy(
           half_square(x, 3, 0, 2) + Box(p.at("a"), p.at("b"), 0).inertia() * half_square(x, 3, 2, 1), 0);
     }},
    {"3.33",
     2,
     {{"rad", {0, 1, 2}}},
     top,
     [](const P& p, const Values& x, Real) { return p.at("l") * std::abs(std::hypot(x[0], x[1], x[2]) - 1); },
     top_energy},
    {"3.35",
     2,
     {{"rad", {0, 1, 2}}},
     top,
     [](const P& p, const Values& x, Real) { return p.at("l") * std::abs(std::hypot(x[0], x[1], x[2]) - 1); },
     top_energy},
};

}  // namespace

std::span<const Scene> scenes() { return all; }

}  // namespace questions
