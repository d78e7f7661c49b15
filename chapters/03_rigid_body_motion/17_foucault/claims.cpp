#include "chapters/provable_claims.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chapters/02_basic_concepts/shared/vectors.hpp"
#include "chapters/03_rigid_body_motion/17_foucault/cone.hpp"
#include "chapters/03_rigid_body_motion/17_foucault/foucault.hpp"
#include "chapters/integral_proofs.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_17 {

using std::numbers::pi;
using namespace basic_vectors;

// ---- the point mass ---------------------------------------------------------------------------------------

/// T - V of a mass m at L R(q) in axes that rotate with w = p.w(); |r' + w x r| is its speed in axes that do
/// not.
template <class N>
struct Lagrangian {
  Given<N> p;
  N m;
  template <class T>
  T operator()(const Two<T>& q, const Two<T>& v) const {
    const Axes<T> axes(q);
    const auto w = p.w();
    const Space<T> turning{T(0.0), T(w[1]), T(w[2])};
    const Space<T> u = axis_velocity(q, v) + cross(turning, axes.R);
    return 0.5 * m * p.L * p.L * dot(u, u) + m * p.g * p.L * axes.R[2];
  }
};

/// West, north and down on a sphere, in axes along its equator and its pole.
template <class T>
std::array<Space<T>, 3> local_axes(const T& latitude, const T& longitude) {
  const T c = cos(latitude), s = sin(latitude), C = cos(longitude), S = sin(longitude);
  return {{{S, -C, T(0.0)}, {-s * C, -s * S, c}, {-c * C, -c * S, -s}}};
}

// Functions of a position.
constexpr auto product = [](std::size_t i, std::size_t k) {
  return [=](const auto& x) { return x[i] * x[k]; };
};
constexpr auto squares = [](std::size_t i, std::size_t k) {
  return [=](const auto& x) { return x[i] * x[i] + x[k] * x[k]; };
};

/// A pendulum at any position in any motion.
template <class T>
struct SampleOf {
  Given<T> p{};
  T m;
  Two<T> q, v, a;
  Space<T> free_r, free_v, free_a;  ///< a point in any motion

  Letters<T> table() {
    return {{R"(\lambda)", p.lambda, {-1.5, 1.5}},
            {"L", p.L, {0.3, 3}},
            {R"(\omega)", p.omega, {0.2, 2}},
            {"g", p.g, {1, 10}},
            {R"(\theta)", q[0], {-3, 3}},
            {R"(\phi)", q[1], {0.1, 3}},
            {R"(\dot\theta)", v[0], either_sign(0.1, 2), "v1"},
            {R"(\dot\phi)", v[1], either_sign(0.1, 2), "v2"},
            {"m", m, {0.3, 3}},
            {R"(\ddot\theta)", a[0], either_sign(0.1, 2), "a1"},
            {R"(\ddot\phi)", a[1], either_sign(0.1, 2), "a2"},
            {R"(\tilde r)", free_r, {-1, 1}, "r"},
            {R"(\dot r)", free_v, {-1, 1}, "u"},
            {R"(\ddot r)", free_a, {-1, 1}, "w"}};
  }
  /// Size of the equations' terms, also after division by sin phi.
  double size() const {
    const double rates = abs(v[0]) + abs(v[1]) + p.omega, size = p.L * (1 + p.L);
    const double accelerations = abs(a[0]) + abs(a[1]) + rates * rates + p.g / p.L;
    const double free = sqrt(3.0) * (1 + rates) * (1 + rates);
    return free + (1 + m) * (1 + size * accelerations) / abs(sin_phi());
  }
  std::string where() const { return listed(typeset_of(*this), 8); }
  TypesetIn<T> typeset() const {
    const double Dt = 0.5;
    const auto A = axes();
    return {{"b", b()},
            {"P", A.P},
            {"Q", A.Q},
            {"R", A.R},
            {R"(\dot R)", axis_velocity(q, v)},
            {"w", w()},
            {R"(\jmath)", {0, 1, 0}},
            {"k", {0, 0, 1}},
            {"D^2r", Dt * Dt * free_a},
            {"Dt", Dt}};
  }
  Axes<T> axes() const { return Axes<T>(q); }
  Space<T> w() const { return p.w(); }
  T sin_phi() const { return sin(q[1]); }
  T mL2() const { return m * p.L * p.L; }
  /// The book's b = -cos lambda sin theta sin phi + sin lambda cos phi.
  T b() const { return -cos(p.lambda) * sin(q[0]) * sin_phi() + sin(p.lambda) * cos(q[1]); }

  /// The kinetic energy in the rotating axes alone.
  Lagrangian<T> kinetic() const {
    Lagrangian<T> still{p, m};
    still.p.omega = still.p.g = T(0.0);
    return still;
  }
  /// Lagrange's equations at a multiple of omega: left side minus right side.
  Two<T> equations(double times) const {
    Lagrangian<T> turned{p, m};
    turned.p.omega *= times;
    return lagrange_left_side(turned, q, v, a);
  }
  /// Lagrange's equations without the terms in omega^2: the odd part is the linear one.
  Two<T> to_first_order() const { return equations(0) + 0.5 * (equations(1) - equations(-1)); }
  Two<T> generalized_force() const { return lagrange_left_side(kinetic(), q, v, a) - to_first_order(); }
  /// The second time derivative in space, along the local axes at that moment, of a point with these
  /// coordinates, rates and accelerations in them. The axes are carried to the east at this multiple of
  /// omega.
  Space<T> inertial_acceleration(const Space<T>& r, const Space<T>& rate, const Space<T>& acceleration,
                                 double multiple) const {
    using Along = Dual<T>;
    using Twice = Dual<Along>;
    const T turning = multiple * p.omega;
    const auto here = local_axes(p.lambda, T(0.0));
    const auto there = local_axes(Twice(p.lambda), Twice(Along(T(0.0), turning), Along(turning, T(0.0))));
    Space<T> second;
    for (std::size_t i = 0; i < 3; ++i) {
      Twice along(Along(T(0.0)));
      for (std::size_t k = 0; k < 3; ++k)
        along += Twice(Along(r[k], rate[k]), Along(rate[k], acceleration[k])) * there[k][i];
      second[i] = along.slope.slope;
    }
    return {dot(second, here[0]), dot(second, here[1]), dot(second, here[2])};
  }
  /// The part of inertial_acceleration() linear in omega, times `sign`.
  Space<T> coriolis_acceleration(double sign) const {
    const auto at = [&](double multiple) { return inertial_acceleration(free_r, free_v, free_a, multiple); };
    return 0.5 * (at(sign) - at(-sign));
  }
  /// R'' by dual numbers.
  Space<T> axis_second_rate() const {
    const auto u = axis_velocity(moving(q, v), moving(v, a));
    return {u[0].slope, u[1].slope, u[2].slope};
  }
  /// The acceleration of R in space without its terms in omega^2.
  Space<T> axis_acceleration() const {
    const auto at = [&](double multiple) {
      return inertial_acceleration(axes().R, axis_velocity(q, v), axis_second_rate(), multiple);
    };
    return at(0) + 0.5 * (at(1) - at(-1));
  }
};
using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;

namespace {

using S = const Sample&;
using Samples = std::vector<Sample>;

const std::string b_is = R"(, $b=-\cos\lambda\sin\theta\sin\phi+\sin\lambda\cos\phi$)";

void geometry(Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  const std::string dual = "dual numbers", nested = "nested dual numbers";
  claim("axes", 2189,
        R"($P=(-\sin\theta,\cos\theta,0)$, $Q=(-\cos\theta\cos\phi,-\sin\theta\cos\phi,\sin\phi)$ and )"
        R"($R=(\cos\theta\sin\phi,\sin\theta\sin\phi,\cos\phi)$ are orthonormal coordinate axes)",
        {.quantity = "the axes' products",
         .truth = {"those of orthonormal axes", [](const auto&) { return values(1, 1, 1, 0, 0, 0); }},
         .printed = R"($(P\cdot P,\ Q\cdot Q,\ R\cdot R,\ P\cdot Q,\ P\cdot R,\ Q\cdot R)$)",
         .changes_that_hold = "these products are all one or zero"});
  claim("velocity", 2197, R"(The velocity is $v=L(\dot\theta\sin\phi\,P-\dot\phi\,Q)$)",
        {R"($\frac{d}{dt}(LR)$ by dual numbers)",
         [](const auto& s) { return s.p.L * axis_velocity(s.q, s.v); }},
        R"($L(\dot\theta\sin\phi\,P-\dot\phi\,Q)$)", "the velocity in the turning axes");
  claim.equation("kinetic_energy", 2205, R"($T=\frac{mL^2}2(\dot\theta^2\sin^2\phi+\dot\phi^2)$)",
                 {R"($\frac m2|\frac{d}{dt}(LR)|^2$ by dual numbers)",
                  [](const auto& s) { return s.kinetic()(s.q, s.v); }});
  claim("dT_dtheta", 2215, R"($\partial T/\partial\theta=0$)",
        {.truth = {dual, [](const auto& s) { return values(df_dq(s.kinetic(), s.q, s.v)[0]); }},
         .printed = "$0$",
         .near_misses = {{R"($\partial L/\partial\theta$ of the Lagrangian on the turning Earth)", [](S s) {
                            return df_dq(Lagrangian<double>{s.p, s.m}, s.q, s.v)[0];
                          }}}});
  claim("derivatives", 2217,
        R"($\partial T/\partial\phi$, $\partial T/\partial\dot\theta$ and $\partial T/\partial\dot\phi$ )"
        R"(are $mL^2\dot\theta^2\sin\phi\cos\phi$, $mL^2\dot\theta\sin^2\phi$, $mL^2\dot\phi$)",
        {dual,
         [](const auto& s) {
           const auto dv = df_dv(s.kinetic(), s.q, s.v);
           return values(df_dq(s.kinetic(), s.q, s.v)[1], dv[0], dv[1]);
         }},
        R"($(mL^2\dot\theta^2\sin\phi\cos\phi,\ mL^2\dot\theta\sin^2\phi,\ mL^2\dot\phi)$)");
  const std::string of_theta = R"(mL^2(\ddot\theta\sin^2\phi+2\dot\theta\dot\phi\sin\phi\cos\phi))",
                    of_phi = R"(mL^2(\ddot\phi-\dot\theta^2\sin\phi\cos\phi))";
  claim("momentum_rates", 2223,
        R"(The time derivatives of $\partial T/\partial\dot\theta$ and $\partial T/\partial\dot\phi$ are $)" +
            of_theta + R"($, $mL^2\ddot\phi$)",
        {nested, [](const auto& s) { return rate_of_df_dv(s.kinetic(), s.q, s.v, s.a); }},
        "$(" + of_theta + R"(,\ mL^2\ddot\phi)$)");
  claim("left_sides", 2237, "Lagrange's equations have the left sides $" + of_theta + "$, $" + of_phi + "$",
        {nested, [](const auto& s) { return lagrange_left_side(s.kinetic(), s.q, s.v, s.a); }},
        "$(" + of_theta + R"(,\ )" + of_phi + ")$");
  claim(
      "dR", 2253, R"($\partial R/\partial\theta$ and $\partial R/\partial\phi$ are $\sin\phi\,P$ and $-Q$)",
      {dual,
       [](const auto& s) {
         const auto a = axis_velocity(s.q, decltype(s.q){1, 0}), b = axis_velocity(s.q, decltype(s.q){0, 1});
         return values(a[0], a[1], a[2], b[0], b[1], b[2]);
       }},
      R"($(\sin\phi\,P,\ -Q)$)");
}

void forces(Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  claim("force", 2243,
        R"(The turning axes add $-2w\times\dot r$ to the acceleration by gravity and rod, to first order )"
        R"(in $\omega$ (our condition))",
        {R"($\ddot r$ less the acceleration in axes that do not turn, its part linear in $\omega$)",
         [](const auto& s) { return s.coriolis_acceleration(-1); }},
        R"($-2w\times\dot r$)");
  claim(
      "second_derivative", 2243, R"(The force on the mass is $m\,D^2r/Dt$)",
      {.quantity = "the acceleration",
       .truth = {R"($\ddot r$ in the turning axes)", [](const auto& s) { return s.free_a; }},
       .printed = "$D^2r/Dt$",
       .meant = "$D^2r/Dt^2$",
       .kind = Fault::formula,
       .why =
           R"(The square of $Dt$ is missing, here and in lines 2259 and 2271: the acceleration is )"
           R"($D^2r/Dt^2$. A second difference over a single $Dt$ has the unit of a velocity, and goes to zero )"
           R"(with $Dt$.)"});
  claim(
      "earth_rotation", 2419, R"(The Earth turns with $w=\omega[(\cos\lambda)-(\sin\lambda)k]$)",
      {.quantity = R"($2w\times\dot r$)",
       .truth = {R"(the acceleration in space of a point in axes to the west, north and down that a sphere )"
                 R"(carries to the east, its part linear in $\omega$)",
                 [](const auto& s) { return s.coriolis_acceleration(1); }},
       .printed = R"($2\omega(-\sin\lambda\,k)\times\dot r$)",
       .meant = R"($2\omega(\cos\lambda\,\jmath-\sin\lambda\,k)\times\dot r$)",
       .why =
           R"(The unit vector $\jmath$, to the north, is lost in the text at hand; the components )"
           R"(of line 2425 show it: $P\cdot w=\omega\cos\lambda\cos\theta$. Without the term a body would )"
           R"(fall straight, and not to the east.)"});

  const auto force = [](std::size_t i) -> ProvableFormula<SampleOf> {
    return {R"(Lagrange's equations on the turning Earth less their kinetic part, linear in $\omega$)",
            [=](const auto& s) { return s.generalized_force()[i]; }};
  };
  claim.equation("force_theta", 2261, R"($F_\theta=(mL\sin\phi)\,2L\omega\dot\phi\,b$)" + b_is, force(0));
  claim.equation("force_phi", 2273, R"($F_\phi=-mL(2L\omega\dot\theta\sin\phi\,b+g\sin\phi)$)" + b_is,
                 force(1));
}

/// A motion that satisfies the first equation before its sine is canceled, unless it is at the lowest point.
struct Passing : Sample {
  Passing(Random& random, bool lowest) : Sample(drawn<Sample>(random)) {
    if (lowest)
      q[1] = 0;
    else
      a[0] -= to_first_order()[0] / (mL2() * sin_phi() * sin_phi());
  }
};

void cancellation(Claims& claims, double seed) {
  Random random(seed);
  std::vector<Passing> passing;
  for (int i = 0; i < 200; ++i) passing.emplace_back(random, i % 4 == 0);
  const std::string right = R"(2\dot\theta\dot\phi\cos\phi=2\omega\dot\phi\,b$)",
                    cancelled = R"($\ddot\theta\sin\phi+)" + right;
  const auto holds = computed(Statement<Passing>{cancelled}).holds;
  const auto swings = [](const Passing& s) { return s.q[1] != 0; };
  claims.statement<Passing>(
      "cancelled_sine", 2277, R"($mL^2\sin\phi$ can be canceled from the first equation)", passing,
      {.printed = {cancelled},
       .corrected = {cancelled + R"( where $\sin\phi\ne0$)",
                     [=](const Passing& s) { return !swings(s) || holds(s); }},
       .in_view = {"away from the lowest point", swings},
       .near_misses = {{R"($\ddot\theta+)" + right}},
       .root = "division at the lowest point",
       .why =
           R"(At the lowest point $\sin\phi=0$. The equation before is $0=0$ there; the remaining one has no )"
           R"($\ddot\theta$, and requires $\dot\theta=\omega\sin\lambda$ wherever $\dot\phi$ is not zero. A )"
           R"(program that solves it for $\ddot\theta$ divides by zero where the pendulum hangs at rest or )"
           R"(swings through the middle. In Cartesian coordinates the point is like any other.)"});
}

void equations(Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  const std::string theta = R"(\ddot\theta\sin\phi+2\dot\theta\dot\phi\cos\phi-2\omega\dot\phi\,b)",
                    phi = R"(\ddot\phi-\dot\theta^2\sin\phi\cos\phi+2\omega\dot\theta\sin\phi\,b+)",
                    pull = R"((g/L)\sin\phi)";
  claim("equation_theta", 2279,
        R"($\ddot\theta\sin\phi+2\dot\theta\dot\phi\cos\phi=2\omega\dot\phi\,b$)" + b_is,
        {R"(Lagrange's equation for $\theta$, linear in $\omega$, by $mL^2\sin\phi$)",
         [](const auto& s) { return s.to_first_order()[0] / (s.mL2() * s.sin_phi()); }},
        "$" + theta + "$", "the first equation of motion, left side less right side");
  claim(
      "equation_phi", 2281,
      R"($\ddot\phi-\dot\theta^2\sin\phi\cos\phi=-2\omega\dot\theta\sin\phi\,b-gL\sin\phi$)" + b_is,
      {.quantity = "the second equation of motion, left side less right side",
       .truth = {R"(Lagrange's equation for $\phi$, linear in $\omega$, by $mL^2$)",
                 [](const auto& s) { return s.to_first_order()[1] / s.mL2(); }},
       .printed = "$" + phi + R"(gL\sin\phi$)",
       .meant = "$" + phi + pull + "$",
       .why =
           R"($gL\sin\phi$ is $(g/L)\sin\phi$, its bar lost: the force before has $g\sin\phi$, and is divided )"
           R"(by $mL^2$.)"});
  claim("newton", 2283, "The two equations are those of Newton's law along $P$ and $Q$",
        {R"($(\ddot r+2w\times\dot r-gk)\cdot(P,-Q)/L$, the acceleration by dual numbers)",
         [](const auto& s) {
           auto r = s.p.L * s.axis_second_rate() + 2 * cross(s.w(), s.p.L * axis_velocity(s.q, s.v));
           r[2] -= s.p.g;
           return values(dot(r, s.axes().P) / s.p.L, -dot(r, s.axes().Q) / s.p.L);
         }},
        R"($\left()" + theta + R"(,\ )" + phi + pull + R"(\right)$)",
        "both equations, left side less right side");
}

// ---- the cone ---------------------------------------------------------------------------------------------

}  // namespace

/// A cone with its base in the plane z = 0 about the origin, its vertex at (0, 0, h), and density one.
template <class T>
struct ConeSampleOf {
  ConeOf<T> cone;
  T height;  ///< a random horizontal plane
  SampleOf<T> motion;
  double relative = 1e-13;

  ConeSampleOf() = default;
  explicit ConeSampleOf(Random& random)
      : cone{random.between(0.5, 2), random.between(0.5, 2)},
        height(random.between(0.1, 0.9) * cone.h),
        motion(drawn<SampleOf<T>>(random)) {
    motion.p.L = cone.L();
  }
  std::array<T*, 12> quantities() {
    auto& [p, m, q, v, a, free_r, free_v, free_a] = motion;
    return {&cone.h, &cone.r, &height, &p.lambda, &p.omega, &p.g, &q[0], &q[1], &v[0], &v[1], &a[0], &a[1]};
  }
  const T& h() const { return cone.h; }
  const T& r() const { return cone.r; }
  T mass() const { return pi_of<T>() * r() * r() * h() / 3; }
  double size() const { return mass() * (1 + h() * h() + r() * r()); }
  Tolerance tolerance(double terms) const {
    return {relative * terms, "the quadratures' tolerance, relative to the terms"};
  }
  std::string where() const { return listed({{"h", h()}, {"r", r()}}, 2) + ", " + motion.where(); }
  TypesetIn<T> typeset() const {
    return with_motion(
        {{"m", mass()}, {"h", h()}, {"r", r()}, {"z", height}, {"I_{xx}", Ixx()}, {"I_{zz}", Izz()}});
  }
  /// These letters, and those of the motion but m and L.
  TypesetIn<T> with_motion(TypesetIn<T> all) const {
    for (const auto& letter : typeset_of(motion))
      if (letter.first != "m" && letter.first != "L") all.push_back(letter);
    return all;
  }
  T rho(const T& z) const { return radius(r(), h(), z); }

  /// Integral over the cone for z >= low, in cylindrical coordinates by Gauss-Legendre.
  template <class F>
  T integral(const F& f, const T& low = T(0.0)) const {
    if constexpr (std::same_as<T, Shortened>) {
      return recorded("over_cone", "(" + low.expression().coq() + ") ", f);
    } else {
      const Rule rule = [](FunctionOfOne g, double a, double b) { return gauss_legendre(g, a, b, 24); };
      return nested(
                 rule,
                 [&](double z, double t, double s) {
                   return s * f(Space<T>{s * cos(t), s * sin(t), z});
                 },
                 low, h(), [](double) { return 0.0; }, [](double) { return 2 * pi; },
                 [](double, double) { return 0.0; }, [&](double z, double) { return rho(z); })
          .value;
    }
  }
  /// Integral in the book's Cartesian limits, by QAGS.
  template <class F>
  T cartesian_integral(const F& f) const {
    if constexpr (std::same_as<T, Shortened>)
      return recorded("within_limits", "", f);
    else
      return cartesian_integral(f, [&](double z, double y) { return width(z, y); });
  }
  /// Integral with `half` in place of the half width in x.
  double cartesian_integral(const auto& f, const auto& half) const {
    const Rule rule = [](FunctionOfOne g, double a, double b) { return qags(g, a, b, 1e-12); };
    return nested(
               rule,
               [&](double z, double y, double x) {
                 return f(Space<T>{x, y, z});
               },
               0, h(), [&](double z) { return -rho(z); }, [&](double z) { return rho(z); },
               [&](double z, double y) { return -half(z, y); }, half)
        .value;
  }
  T width(const T& z, const T& y) const {
    const T square = rho(z) * rho(z) - y * y;
    if constexpr (std::same_as<T, Shortened>)
      return sqrt(square);
    else
      return sqrt(std::max(0.0, square));
  }
  /// Integral of (y2 y^2 + z2 z^2) sqrt(rho^2 - y^2) over y and z.
  T over_chords(double y2, double z2) const {
    const auto f = [&](const T& z, const T& y) { return (y2 * y * y + z2 * z * z) * width(z, y); };
    if constexpr (std::same_as<T, Shortened>) {
      const auto slice = [&](const T& z) {
        return recorded_integral([&](const T& y) { return f(z, y); }, -rho(z), rho(z));
      };
      return recorded_integral(slice, 0.0, h());
    } else {
      const auto slice = [&](double z) {
        return qags([&](double y) { return f(z, y); }, -rho(z), rho(z), 1e-12).value;
      };
      return qag(slice, 0, h(), 1e-13).value;
    }
  }
  T volume_above(const T& z) const {
    return integral([](const Space<T>&) { return T(1.0); }, z);
  }
  T Ixx() const { return integral(squares(1, 2)); }
  T Izz() const { return integral(squares(0, 1)); }
  T center() const {
    return integral([](const auto& x) { return x[2]; }) / volume_above(0.0);
  }
  /// Moment of inertia across the axis about its point at the height z0.
  T across(const T& z0) const {
    return integral([&](const auto& x) {
      const T z = x[2] - z0;
      return x[1] * x[1] + z * z;
    });
  }
  /// A position of the cone, turned so that its axis is along R.
  Space<T> turned(const Space<T>& x) const {
    const auto A = motion.axes();
    return x[0] * A.P + x[1] * A.Q + x[2] * A.R;
  }
  /// u.J v about the base's center of the turned cone.
  T inertia(const Space<T>& u, const Space<T>& v) const {
    return integral([&](const Space<T>& x) {
      const auto at = turned(x);
      return dot(at, at) * dot(u, v) - dot(at, u) * dot(at, v);
    });
  }
  /// The entries of J by the axes' numbers: 0 for P, 1 for Q, 2 for R.
  std::vector<T> inertia(const std::vector<std::pair<std::size_t, std::size_t>>& entries) const {
    const auto A = motion.axes();
    const std::array axes{A.P, A.Q, A.R};
    std::vector<T> all;
    for (const auto& [i, k] : entries) all.push_back(inertia(axes[i], axes[k]));
    return all;
  }
  /// Kinetic energy of the swing about the vertex in the rotating axes, if the cone does not spin about its
  /// axis.
  T kinetic_energy() const {
    const auto spin = cross(motion.axes().R, axis_velocity(motion.q, motion.v));
    return integral([&](const Space<T>& x) {
      const auto u = cross(spin, turned({x[0], x[1], h() - x[2]}));
      return dot(u, u) / 2;
    });
  }

 private:
  template <class F>
  Shortened recorded(const std::string& name, const std::string& low, const F& f) const {
    const auto letter = [](const char* of) { return Shortened::letter(of); };
    const auto in_coq = [](const std::string& letters, const Shortened& x) {
      return "(fun " + letters + " => " + x.expression().coq() + ")";
    };
    const std::string density = in_coq("x y z", f(Space<Shortened>{letter("x"), letter("y"), letter("z")}));
    return Expression::letter("(" + name + " " + in_coq("z", rho(letter("z"))) + " " + low + "(" +
                              h().expression().coq() + ") " + density + ")");
  }
};

namespace {

using ConeSample = ConeSampleOf<double>;
using ConeTable = ProvableClaims<ConeSampleOf>;
using OfCone = ProvableFormula<ConeSampleOf>;
using C = const ConeSample&;
using Cones = std::vector<ConeSample>;

/// Factor by which the published cone swings faster than the true one, for r = h.
double too_fast() { return sqrt((0.8 + 0.2) / printed_length<double>()); }

/// Integrals over the cone in one row.
template <class... F>
auto integrals(const F&... f) {
  return [=](const auto& s) { return values(s.integral(f)...); };
}
constexpr auto moment = [](std::size_t i) { return [=](const auto& x) { return x[i]; }; };

/// A claim that integrals are zero.
void no_integrals(const auto& claim, std::string_view slug, int line, const std::string& says,
                  const std::string& quantity, const OfCone& truth, const OfCone& near_miss) {
  claim(slug, line, says,
        {.quantity = quantity,
         .truth = truth,
         .printed = "$0$",
         .near_misses = {near_miss},
         .changes_that_hold = "zero has no sign"});
}

void center_of_mass(ConeTable& table, const Cones& cones) {
  const auto claim = table.over(cones);
  const std::string root = "a center of mass that halves the volume";
  claim("cone_mass", 2299, R"(The cone's mass, its density being 1, is $m=\pi r^2h/3$)",
        {"quadrature", [](const auto& s) { return s.volume_above(0.0); }}, R"($\pi r^2h/3$)");
  no_integrals(claim, "center_on_axis", 2305, R"(The center of mass is on the axis: $\bar x=\bar y=0$)",
               "the moments of $x$ and $y$", {"quadrature", integrals(moment(0), moment(1))},
               {"the moment of $z$", integrals(moment(2))});
  claim("upper_part", 2305, R"(Above a plane $z$ lies the volume $\pi r^2(1-z/h)^2(h-z)/3$)",
        {"quadrature", [](const auto& s) { return s.volume_above(s.height); }},
        R"($\pi r^2(1-z/h)^2(h-z)/3$)");
  claim(
      "center_halves", 2305,
      R"(Half the volume lies above the center of mass: )"
      R"($\pi r^2(1-\bar z/h)^2(h-\bar z)/3=\frac12\,\pi r^2h/3$)",
      {.quantity = "the volume above the center of mass",
       .truth = {"volume and center of mass by quadrature",
                 [](const auto& s) { return s.volume_above(s.center()); }},
       .printed = R"($\frac12\,\pi r^2h/3$)",
       .corrected = R"($\frac{27}{64}\,\pi r^2h/3$)",
       .kind = Fault::counterexample,
       .root = root,
       .why = filled(
           R"(The center of mass balances moments, not volumes: the parts above and below have equal moments )"
           R"($\int(z-\bar z)\,dV$. Above it lies $(3/4)^3=27/64=@2$ of the cone.)",
           {above_center<double>()})});
  claim("halving_height", 2315, "The plane that halves the volume is $z=h(1-2^{-1/3})$",
        {"quadrature",
         []<class T>(const ConeSampleOf<T>& s) { return s.volume_above(halving_height<T>() * s.h()); }},
        R"($\frac12\,\pi r^2h/3$)", "the volume above the plane $z=h(1-2^{-1/3})$");
  claim("center_height", 2315, R"(The center of mass is at the height $\bar z=h(1-2^{-1/3})$)",
        {.truth = {"the moment of $z$ by the volume, both by quadrature",
                   [](const auto& s) { return s.center(); }},
         .printed = "$h(1-2^{-1/3})$",
         .corrected = "$h/4$",
         .root = root,
         .why =
             filled(R"($h(1-2^{-1/3})=@4\,h$ is where the volume is halved; the center of mass is at $h/4$.)",
                    {halving_height<double>()})});
  claim("L", 2319, "From the vertex, which is the joint, to the center of mass it is $L=h/2^{1/3}$",
        {.quantity = "$L$, from the joint, which is the vertex, to the center of mass",
         .truth = {"$h$ less the height of the center of mass by quadrature",
                   [](const auto& s) { return s.h() - s.center(); }},
         .printed = "$h/2^{1/3}$",
         .corrected = "$3h/4$",
         .root = root,
         .why = filled(R"($L=3h/4=0.75\,h$, not $@4\,h$: the volume was halved, not its moment.)",
                       {printed_length<double>()})});
}

void decimals(Claims& claims) {
  claims.number("L_decimals", 2321, "$2^{-1/3}=0.7937$ to four decimals",
                {.quantity = "$2^{-1/3}$",
                 .truth = {"the inverse of 2's cube root", 1 / std::cbrt(2.0)},
                 .printed = "0.7937",
                 .near_misses = {"0.7938"}});
}

/// Claims the integrals of lines 2329 to 2341, checked by QAGS.
void moments(ConeTable& table, const Cones& cones, const Cones& by_qags) {
  const auto claim = table.over(cones), by_adaptive = table.over(by_qags);
  const OfCone Ixx{"quadrature in cylindrical coordinates", [](const auto&s) { return s.Ixx(); }},
      Izz{"quadrature", [](const auto&s) { return s.Izz(); }};
  const auto over_chords = [](double y2, double z2) {
    return [=](const auto& s) { return s.over_chords(y2, z2); };
  };
  by_adaptive("Ixx_limits", 2329,
              R"($I_{xx}$ is the integral of $y^2+z^2$ over $|x|<\sqrt{\rho^2-y^2}$, $|y|<\rho$, $0<z<h$)",
              {.quantity = "$I_{xx}$ as a triple integral, and its limits",
               .truth = Ixx,
               .printed = {R"(of $y^2+z^2$ over $|x|<\sqrt{\rho^2-y^2}$, $|y|<\rho$, $0<z<h$)",
                           [=](const auto& s) { return s.cartesian_integral(squares(1, 2)); }},
               .near_misses = {{R"(of $y^2+z^2$ over $|x|<\rho$, $|y|<\rho$, $0<z<h$)", [=](C s) {
                                  return s.cartesian_integral(squares(1, 2),
                                                              [&](double z, double) { return s.rho(z); });
                                }}}});
  by_adaptive(
      "Ixx_after_x", 2335,
      R"(Integrated over $x$, $I_{xx}$ is the integral of $2(y^2+z^2)\sqrt{\rho^2-y^2}$ over $y$ and $z$)",
      {.quantity = "$I_{xx}$ after integrating over $x$",
       .truth = Ixx,
       .printed = {R"(of $2(y^2+z^2)\sqrt{\rho^2-y^2}$)", over_chords(2, 2)},
       .near_misses = {{R"(of $(y^2+z^2)\sqrt{\rho^2-y^2}$)", over_chords(1, 1)}}});
  by_adaptive(
      "Ixx_split", 2341,
      R"(The first integral over $y$ in $I_{xx}$ has $2y^2\sqrt{\rho^2-y^2}$, the second )"
      R"($z^2\sqrt{\rho^2-y^2}$)",
      {.quantity = "$I_{xx}$",
       .truth = Ixx,
       .printed = {R"(of $2y^2\sqrt{\rho^2-y^2}$ and of $z^2\sqrt{\rho^2-y^2}$)", over_chords(2, 1)},
       .meant = {R"(of $2y^2\sqrt{\rho^2-y^2}$ and of $2z^2\sqrt{\rho^2-y^2}$)", over_chords(2, 2)},
       .near_misses = {{R"(of $y^2\sqrt{\rho^2-y^2}$ and of $z^2\sqrt{\rho^2-y^2}$)", over_chords(1, 1)}},
       .kind = Fault::formula,
       .why =
           R"(The factor 2 of the line before is lost in the second integral. The next line shows it again: )"
           R"(with $\int\sqrt{\rho^2-y^2}\,dy=\pi\rho^2/2$ it has $\pi\rho^2z^2$.)"});
  claim("Ixx_over_z", 2355, R"($I_{xx}$ is the integral of $\pi\rho^4/4+\pi\rho^2z^2$ over $z$)", Ixx,
        R"($\int_0^h(\pi(r(1-z/h))^4/4+\pi(r(1-z/h))^2z^2)\,dz$)",
        R"($I_{xx}$ as an integral over $z$, with $\rho=r(1-z/h)$)");
  const auto over_height = [](const std::string& factor) {
    return R"($\pi\int_0^h(\frac14r^4(1-z/h)^4+)" + factor + R"((1-z/h)^2)\,dz$)";
  };
  claim(
      "Ixx_factored", 2357,
      R"($I_{xx}$ is $\pi$ times the integral of $\frac14r^4(1-z/h)^4+z^2(1-z/h)^2$ over $z$)",
      {.quantity = "$I_{xx}$",
       .truth = Ixx,
       .printed = over_height("z^2"),
       .meant = over_height("r^2z^2"),
       .kind = Fault::formula,
       .why =
           R"(The second term is $\rho^2z^2=r^2z^2(1-z/h)^2$; its $r^2$ is missing here and is back in the next line.)"});
  claim.lost("Ixx_closed", 2363, R"($I_{xx}=\pi r^2h(2h^2+3r^2)\,60$)", Ixx,
             R"($I_{xx}=\pi r^2h(2h^2+3r^2)/60$)", "The bar over 60 is lost.");
  const std::string by_mass = "$m(2h^2+3r^2)/20$";
  claim("Ixx", 2365, "About the base's center $I_{xx}=m(2h^2+3r^2)/20$", Ixx, by_mass);
  claim("Iyy", 2371, "$I_{yy}=I_{xx}=m(2h^2+3r^2)/20$", {"quadrature", integrals(squares(0, 2))}, by_mass);
  no_integrals(claim, "products", 2375, "The products of inertia are zero: $I_{xy}=I_{xz}=I_{yz}=0$",
               "$(I_{xy},I_{xz},I_{yz})$",
               {"quadrature", integrals(product(0, 1), product(0, 2), product(1, 2))},
               {"the integral of $x^2$", integrals(product(0, 0))});
  by_adaptive("Izz_cylindrical", 2389,
              R"(In cylindrical coordinates $I_{zz}$ is the integral of $s^3\,ds\,d\theta\,dz$)",
              {"the integral of $x^2+y^2$ in Cartesian coordinates, by QAGS",
               [](const auto& s) { return s.cartesian_integral(squares(0, 1)); }},
              R"($\int_0^h2\pi\int_0^{r(1-z/h)}s^3\,ds\,dz$)", "$I_{zz}$ in cylindrical coordinates");
  claim.lost("Izz_closed", 2393, R"($I_{zz}=\pi r^4h\,10$)", Izz, R"($I_{zz}=\pi r^4h/10$)",
             "The bar over 10 is lost.");
  claim.equation("Izz", 2395, "$I_{zz}=3mr^2/10$", Izz);
}

void tensor(ConeTable& table, const Cones& cones) {
  const auto claim = table.over(cones);
  const std::string by_axes = "I_{xx}(PP^T+QQ^T)+I_{zz}RR^T";
  claim("J_world", 2417, "In world coordinates $J=" + by_axes + "$ (our condition: about the base's center)",
        {"quadrature over the turned cone",
         []<class T>(const ConeSampleOf<T>& s) {
           const Space<T> e[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
           std::array<T, 9> J;
           for (std::size_t i = 0; i < 9; ++i) J[i] = s.inertia(e[i / 3], e[i % 3]);
           return J;
         }},
        "$" + by_axes + "$");
  const OfCone turned{R"(with $(P+R)/\sqrt2$ and $(P-R)/\sqrt2$ in place of $P$ and $R$)", [](C s) {
                        const auto A = s.motion.axes();
                        return (s.inertia(A.P, A.P) - s.inertia(A.R, A.R)) / 2;
                      }};
  no_integrals(claim, "principal", 2297, "The cone's axis is along $R$, and is a principal direction",
               R"($P\cdot JR$ and $Q\cdot JR$, zero for a principal direction $R$)",
               {"quadrature",
                [](const auto& s) {
                  return s.inertia({{0, 2}, {1, 2}});
                }},
               turned);
  no_integrals(claim, "other_principal", 2297, "$P$ and $Q$ are two other principal directions",
               R"($P\cdot JQ$, $P\cdot JR$ and $Q\cdot JR$, zero for principal directions $P$ and $Q$)",
               {"quadrature",
                [](const auto& s) {
                  return s.inertia({{0, 1}, {0, 2}, {1, 2}});
                }},
               turned);
  const OfCone wJw{R"($w\cdot Jw$ by quadrature)",
                   [](const auto& s) { return s.inertia(s.motion.w(), s.motion.w()); }};
  const std::string by_angles = R"(\omega^2I_{xx}(\cos^2\lambda\cos^2\theta+(\cos\lambda\sin\theta\cos\phi)"
                                R"(+\sin\lambda\sin\phi)^2)+\omega^2I_{zz}(\cos\lambda\sin\theta\sin\phi)"
                                R"(-\sin\lambda\cos\phi)^2$)";
  claim.equation("wJw", 2421, R"($w\cdot Jw=I_{xx}((P\cdot w)^2+(Q\cdot w)^2)+I_{zz}(R\cdot w)^2$)", wJw);
  claim("wJw_angles", 2425, R"($w\cdot Jw=)" + by_angles, wJw, "$" + by_angles,
        R"($w\cdot Jw$ in the angles, $w=\omega(\cos\lambda\,\jmath-\sin\lambda\,k)$)");
  claim(
      "J_in_T", 2401, "The tensor $J$ in the kinetic energy has $I_{xx}=m(2h^2+3r^2)/20$",
      {.quantity = "$I_{xx}$ of the tensor $J$ that is added to the energy of the center of mass",
       .truth = {"quadrature about the center of mass", [](const auto& s) { return s.across(s.center()); }},
       .printed = "$m(2h^2+3r^2)/20$",
       .corrected = "$3m(h^2+4r^2)/80$",
       .root = "moments about the base",
       .why =
           R"(The integrals are about the center of the base. With $m|v|^2/2$ of the center of mass belongs )"
           R"(the tensor about the center of mass, $I_{xx}=3m(h^2+4r^2)/80$, less by $m(h/4)^2$.)"});
  claim(
      "cone_energy", 2287, R"(The cone has the kinetic energy $\frac m2|v|^2+\frac12w\cdot Jw$)",
      {.truth = {"half the speed's square over a cone that hangs by its vertex and swings, by quadrature",
                 [](const auto& s) { return s.kinetic_energy(); }},
       .printed =
           R"($\frac m2\left(\frac h{2^{1/3}}\right)^2\dot R\cdot\dot R+\frac12w\cdot()" + by_axes + ")w$",
       .corrected = R"($\frac m2\left(\frac{3h}4\right)^2\dot R\cdot\dot R)"
                    R"(+\frac m2\,\frac{3(h^2+4r^2)}{80}(R\times\dot R)\cdot(R\times\dot R)$)",
       .root = "the cone's own turning",
       .why =
           R"(The cone turns as it swings: its angular velocity on the Earth is $R\times\dot R$, not $w$, )"
           R"(and its energy has $\frac12I_{xx}(\dot\theta^2\sin^2\phi+\dot\phi^2)$. The added term of the )"
           R"(text, $\frac12w^TJw$, has no velocities in it and is of order $\omega^2$: like the )"
           R"(centrifugal force, which the equations leave out.)"});
}

}  // namespace

/// A cone in any motion, compared to within the roundings of its equations.
template <class T>
struct SwingingOf : ConeSampleOf<T> {
  using ConeSampleOf<T>::ConeSampleOf;
  double size() const { return this->motion.size(); }
  Tolerance tolerance(double) const { return rounding(size(), 512); }
  TypesetIn<T> typeset() const {
    return this->with_motion({{"K", this->cone.L() * this->cone.equivalent_length()}, {"L", this->cone.L()}});
  }
};

namespace {

using Swinging = SwingingOf<double>;
using SwingTable = ProvableClaims<SwingingOf>;

void cone_equations(SwingTable& table, const std::vector<Swinging>& samples) {
  const auto claim = table.over(samples);
  const auto appended = []<class T>(const SwingingOf<T>& s) {
    const auto& m = s.motion;
    const BookEnergyOf<T> energy{book_cone(s.cone), m.w()};
    Two<T> force = coriolis(energy.L, m.w(), m.q, m.v);
    force[1] -= m.p.g * energy.L * m.sin_phi();
    return lagrange_left_side(energy, m.q, m.v, m.a) - force;
  };
  const auto about_joint = [](const Swinging& s) {
    const auto A = s.motion.axes();
    const Space<double> k{0, 0, 1};
    const auto unbalanced = s.across(s.h()) / s.volume_above(0) * cross(A.R, s.motion.axis_acceleration()) -
                            s.motion.p.g * (s.h() - s.center()) * cross(A.R, k);
    return values(dot(unbalanced, k), dot(unbalanced, A.P));
  };
  const auto of_point = [](const auto& s) {
    auto point = s.motion;
    point.m = 1;
    point.p.L = s.cone.equivalent_length();
    return s.cone.L() / point.p.L * point.to_first_order();
  };
  claim(
      "cone_equations", 2429,
      R"(The cone's equations are those of the point with the derivatives of $\frac12w\cdot Jw$ appended)",
      {.quantity = R"(Lagrange's equations, left sides less right sides, for $\theta$ and $\phi$, with )"
                   R"($K=L^2+I_{xx}/m$, $I_{xx}$ about the center of mass)",
       .truth =
           {R"(the angular momentum's rate in space about the joint of a cone that does not spin )"
            R"(about its axis, less gravity's torque, along $k$ and $P$, linear in $\omega$. The moments are )"
            R"(by quadrature; the proof has a point mass at $(L^2+I_{xx}/m)/L$)",
            [=]<class T>(const SwingingOf<T>& s) {
              if constexpr (std::same_as<T, double>)
                return about_joint(s);
              else
                return of_point(s);
            }},
       .printed =
           {R"($\frac d{dt}\frac{\partial T}{\partial\dot\theta}-\frac{\partial T}{\partial\theta}=F_\theta$ )"
            R"(and the same for $\phi$, $T=\frac m2|v|^2+\frac12w\cdot Jw$ and the point's $F$)",
            appended},
       .corrected =
           R"($\left(K(\ddot\theta\sin^2\phi+2\dot\theta\dot\phi\sin\phi\cos\phi)-2K\omega\dot\phi\sin\phi\,b,\ )"
           R"(K(\ddot\phi-\dot\theta^2\sin\phi\cos\phi)+2K\omega\dot\theta\sin\phi\,b+gL\sin\phi\right)$)",
       .kind = Fault::formula,
       .root = "the cone's own turning",
       .why = filled(
           R"(To first order in $\omega$ the appended terms vanish, and the cone's own inertia is missing. It )"
           R"(swings as a point mass at $(L^2+I_{xx}/m)/L=\frac45h+r^2/(5h)$, its center of oscillation; the )"
           R"(published equations put the point at $@4\,h$.)",
           {printed_length<double>()})});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("3.17");
  const auto samples = draw<Sample>(200, seed);
  Table table(claims);
  for (auto* section : {geometry, forces, equations}) section(table, samples);
  cancellation(claims, seed);

  const auto cones = draw<ConeSample>(3, seed);
  Cones by_qags(cones.begin(), cones.begin() + 2);  // adaptive rules are slow
  for (ConeSample& cone : by_qags) cone.relative = 1e-12;
  ConeTable of_cone(claims);
  SwingTable of_swing(claims);
  center_of_mass(of_cone, cones);
  decimals(claims);
  moments(of_cone, cones, by_qags);
  tensor(of_cone, cones);
  cone_equations(of_swing, draw<Swinging>(100, seed));
  return claims.in_order();
}

Provables pendulum_proofs() {
  Claims claims("3.17");
  Table table(claims);
  for (auto* section : {geometry, forces, equations}) section(table, {});
  auto all = for_all<SampleOf>("rewrite ?cos_0, ?sin_0; " + by_angles({"lambda", "theta", "phi"}) +
                                   "; repeat split; first [ assumption | apply Rgt_not_eq; lra ]",
                               "it holds for every pendulum in any motion, but at its lowest point");
  all.given = positive({all.any.p.L, all.any.m});
  all.given.push_back(not_zero(sin(all.any.q[1]).expression()));
  double x = 0;
  for (double* letter : letters_of(all.example)) *letter = x += 0.125;
  return table.proofs("3.17", all);
}

Provables cone_proofs() {
  Claims claims("3.17");
  ConeTable table(claims);
  SwingTable of_swing(claims);
  center_of_mass(table, {});
  moments(table, {}, {});
  tensor(table, {});
  cone_equations(of_swing, {});
  const std::vector<std::string> names{"h",     "r",   "height", "lambda", "omega", "g",
                                       "theta", "phi", "v1",     "v2",     "a1",    "a2"};
  const std::string by_turns =
      by_angles({"lambda", "theta", "phi"}) +
      "; repeat split; first [ assumption | lra | apply PI_neq0 | apply Rgt_not_eq; nra ]";
  auto all = for_all<ConeSampleOf>(names, "no_integrals; first [ by_cube_root | " + by_turns + " ]",
                                   "it holds for every cone");
  auto swinging = for_all<SwingingOf>(names, by_turns, "it holds for every cone in any motion");
  all.given = swinging.given = positive({all.any.h(), all.any.r()});
  all.preamble = swinging.preamble = coq_source({"cone"});
  all.bounds = swinging.bounds = "no_integrals; interval";
  double x = 0;
  for (double* letter : all.example.quantities()) *letter = x += 0.125;
  static_cast<ConeSample&>(swinging.example) = all.example;
  Provables proved = table.proofs("3.17", all);
  append(proved, of_swing.proofs("3.17", swinging));
  return proved;
}

std::vector<Root> roots() {
  const Cone cone{1.25, 1.25};  // the default one
  const auto book = book_cone(cone);
  constexpr double swings = 10;
  return {
      {"division at the lowest point",
       filled(
           "A pendulum pushed from its lowest point has NaN in the first step. The Pantheon's, @2 m long and "
           "let go at rest @1 m aside, passes the point at @1 mm.",
           {pantheon.L, let_go_aside(), 1e3 * passes_at()})},
      {"a center of mass that halves the volume",
       filled(
           "The default cone, @3 m high, is drawn with its center of mass @2 cm too far below the joint, at "
           "@2 m instead of @2 m.",
           {cone.h, 100 * (book.L - cone.L()), book.L, cone.L()})},
      {"moments about the base",
       filled(
           "Thrown, the default cone would turn end over end as if it were @2 % heavier to turn: with @2 kg "
           "m$^2$ per kilogram instead of @2.",
           {100 * (book.Ixx / cone.across() - 1), book.Ixx, cone.across()})},
      {"the cone's own turning",
       filled(
           "The default cone swings @2 % too fast: when it has swung @2 times, the published one has swung @3 times.",
           {100 * (too_fast() - 1), swings, swings * too_fast()})}};
}

}  // namespace oddity::ex03_17
