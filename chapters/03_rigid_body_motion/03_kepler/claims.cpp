// The published lines of exercise 3.3, checked on random orbits. The reference uses Newton's law alone. The
// path is integrated in Cartesian coordinates, with the slope of G M/|r| by dual numbers as its acceleration.
// The path gives r, theta, V and their derivatives by second-order dual numbers. The constants of equation
// (3) come from two later positions on the path, not from the initial condition.

#include "chapters/provable_claims.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "chapters/02_basic_concepts/shared/recorded_functions.hpp"
#include "chapters/03_rigid_body_motion/03_kepler/kepler.hpp"
#include "chapters/integral_proofs.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::kepler {

// ---- samples ----------------------------------------------------------------------------------------------

/// The slope of G M/|r| in each direction of space.
template <class T, std::size_t n>
std::array<T, n> gravity(const T& mu, const std::array<T, n>& q) {
  std::array<T, n> a{};
  for (std::size_t i = 0; i < n; ++i) {
    Dual<T> square = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
      const Dual<T> z(q[j], i == j ? 1 : 0);
      square += z * z;
    }
    a[i] = (mu / sqrt(square)).slope;
  }
  return a;
}

template <class T>
struct AlongOf;

/// A planet of mass m at one moment. It moves by gravity, or by another acceleration, the push.
template <class T, bool is_pushed>
struct PlanetOf {
  T G, M, m, x, y, vx, vy, push_x, push_y;

  std::array<T*, 9> letters() { return {&G, &M, &m, &x, &y, &vx, &vy, &push_x, &push_y}; }
  std::string where() const {
    return listed({{"G", G}, {"M", M}, {"x", x}, {"y", y}, {R"(\dot x)", vx}, {R"(\dot y)", vy}}, 6);
  }
  TypesetIn<T> typeset() const { return AlongOf<T>(*this).typeset(); }
};
template <class T>
using MomentOf = PlanetOf<T, false>;
template <class T>
using PushedOf = PlanetOf<T, true>;

/// r, theta and V = -GM/r at a moment. Time derivatives along the path are by second-order dual numbers; V',
/// V'' by the angle follow from these.
template <class T>
struct AlongOf {
  T G, M, m, mu, x, y, vx, vy, ax, ay, r, r_dot, r_dot_dot, angle, w, w_dot, c, s, h;
  T V, V_dot, V1, V1_dot, V2;  ///< V1 = V', V2 = V''

  template <bool is_pushed>
  explicit AlongOf(const PlanetOf<T, is_pushed>& k)
      : G(k.G), M(k.M), m(k.m), mu(G * M), x(k.x), y(k.y), vx(k.vx), vy(k.vy) {
    const auto pull = gravity(mu, std::array{x, y});
    ax = is_pushed ? k.push_x : pull[0], ay = is_pushed ? k.push_y : pull[1];
    using Twice = Dual<Dual<T>>;
    const Twice t(Dual<T>(0, 1), Dual<T>(1, 0));
    const Twice along_x = x + t * (Twice(vx) + t * Twice(ax / 2)),
                along_y = y + t * (Twice(vy) + t * Twice(ay / 2));
    const Twice R = sqrt(along_x * along_x + along_y * along_y), theta = atan2(along_y, along_x);
    const Twice energy = -mu / R;
    r = R.value.value, r_dot = R.slope.value, r_dot_dot = R.slope.slope;
    angle = theta.value.value, w = theta.slope.value, w_dot = theta.slope.slope;
    c = cos(angle), s = sin(angle), h = x * vy - y * vx;
    V = energy.value.value, V_dot = energy.slope.value, V1 = V_dot / w;
    V1_dot = (energy.slope.slope * w - V_dot * w_dot) / (w * w), V2 = V1_dot / w;
  }
  // Sizes of terms that cancel for any letters: of the velocity's moment, of r'' and r theta'', of V''.
  T of_moment() const { return vx * vx + vy * vy; }
  T of_rates() const { return of_moment() / r; }
  T of_bend() const { return of_rates() * mu / pow(r * w, 2); }
  /// `\alpha_c` is alpha of the circular orbit through the position.
  TypesetIn<T> typeset() const {
    return {{"G", G},
            {"M", M},
            {"m", m},
            {"r", r},
            {R"(\dot r)", r_dot},
            {R"(\ddot r)", r_dot_dot},
            {R"(\dot\theta)", w},
            {R"(\ddot\theta)", w_dot},
            {R"(\mathbf r)", {x, y, 0}},
            {R"(\mathbf R)", {c, s, 0}},
            {R"(\mathbf P)", {-s, c, 0}},
            {R"(\mathbf k)", {0, 0, 1}},
            {R"(\lambda)", {0, -1, 1, 0}},
            {R"(\alpha)", M * (r * r * w)},
            {R"(\alpha_c)", M * sqrt(mu * r)},
            {"V", V},
            {"V'", V1},
            {"V''", V2},
            {R"(\dot V)", V_dot},
            {"dV/dt", V_dot},
            {"dV'/dt", V1_dot},
            {R"(dV/d\theta)", V1},
            {"dV/dr", derivative([&](auto z) { return -mu / z; }, r)}};
  }
};

namespace {

using std::numbers::pi;
using Moment = MomentOf<double>;
using Along = AlongOf<double>;
using Pushed = PushedOf<double>;
using Table = ProvableClaims<MomentOf>;
using PushedTable = ProvableClaims<PushedOf>;

// For the Earth in a `why`, in astronomical units, years and solar masses.
constexpr double days_per_year = 365.25;
constexpr double suns_per_earth = 1.32712440018e20 / 3.986004418e14;  // ratio of G times mass, m^3/s^2
/// 2 pi AU a year, in km/s.
constexpr double earths_speed = 2 * pi * 149597870.7 / (days_per_year * 86400);
/// The fall from rest at the Earth's distance into the sun.
const double days_of_fall = days_per_year * pi / (2 * sqrt(2)) / sqrt(four_pi_squared);

using Terms = double (Along::*)() const;

template <template <class> class Of = MomentOf, class F>
ProvableFormula<Of> along(std::string text, const F& of, Terms terms = nullptr) {
  ProvableFormula<Of> formula{std::move(text),
                              [=](const auto& k) -> decltype(of(AlongOf(k))) { return of(AlongOf(k)); }};
  if (terms) formula.terms = [=](const Of<double>& k) { return (Along(k).*terms)(); };
  return formula;
}
/// For an equation, which is checked as a difference of its sides.
auto zero(Terms terms) {
  return along(
      "zero", []<class T>(const AlongOf<T>&) { return T(0); }, terms);
}

/// A vector of the orbit's plane, repeated.
template <class T>
std::vector<T> in_plane(const T& x, const T& y, int times = 1) {
  std::vector<T> all;
  for (int i = 0; i < times; ++i) all.insert(all.end(), {x, y, T(0)});
  return all;
}

}  // namespace

template <class T>
TypesetIn<T> letters_of(const Given<T>& s, const TypesetIn<T>& more = {}) {
  TypesetIn<T> all{{"G", s.G},
                   {"M", s.M},
                   {"r_0", s.r0},
                   {R"(\dot r_0)", s.r0_dot},
                   {R"(\theta_0)", s.theta0},
                   {R"(\dot\theta_0)", s.theta0_dot}};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The orbit's elements by the lines that use the initial condition.
template <class T>
struct Elements {
  T mu, squared, tilted;  ///< r0^3 theta0'^2, r0^2 r0' theta0'
  T gamma0, gamma1, e, rho, omega;

  explicit Elements(const Given<T>& start) : mu(start.mu()) {
    const auto& [G, M, r0, r0_dot, theta0, w0] = start;
    squared = r0 * r0 * r0 * w0 * w0, tilted = r0 * r0 * r0_dot * w0, gamma0 = r0 * r0 * abs(w0);
    gamma1 = sqrt(pow(squared - mu, 2) + tilted * tilted), e = gamma1 / mu, rho = gamma0 * gamma0 / gamma1;
    omega = theta0 - atan2(tilted, squared - mu);
  }
  T as_printed(const T& theta) const { return e * rho / (1 + e * cos(theta)); }
};

/// A random orbit at its initial condition and at a later moment.
template <class T>
struct LaterOf {
  Given<T> start;
  MomentOf<T> now;
  T t, theta;  ///< the angle is not reduced to one turn
  T c0, c1;    ///< from equation (3) at two other positions

  std::array<T*, 14> letters() {
    auto& [G, M, r0, r0_dot, theta0, theta0_dot] = start;
    return {&G,     &M,      &r0,     &r0_dot, &theta0, &theta0_dot, &now.x,
            &now.y, &now.vx, &now.vy, &t,      &theta,  &c0,         &c1};
  }
  std::string where() const { return listed(letters_of(start), 6) + ", $t$ = " + format_shortest(t); }
  Tolerance tolerance(double size) const {
    return {1e-10 * size, "a thousand tolerances of the path's integration"};
  }

  T r() const { return hypot(now.x, now.y); }
  T h() const { return now.x * now.vy - now.y * now.vx; }
  T w() const { return h() / (r() * r()); }
  T V() const { return -start.mu() / r(); }
  T mean() const { return pow(start.mu() / start.h(), 2); }  ///< G^2 M^4/alpha^2
  T potential(const T& angle) const { return c0 * sin(angle) + c1 * cos(angle); }
  T slope(const T& angle) const { return c0 * cos(angle) - c1 * sin(angle); }
  T distance(const T& angle) const { return -start.mu() / (potential(angle) - mean()); }
  /// The time from one angle to another, dt = r^2 d theta/h.
  T time_between(const T& from, const T& to, const T& area_rate) const {
    const auto slowness = [&](const T& angle) { return pow(distance(angle), 2) / area_rate; };
    if constexpr (std::same_as<T, Shortened>)
      return recorded_integral(slowness, from, to);
    else
      return qag(slowness, from, to, 1e-13).value;
  }
  /// The period.
  T turn() const { return time_between(0, 2 * pi_of<T>(), abs(start.h())); }
  /// The initial moment.
  AlongOf<T> first() const {
    const auto q = start.position(), v = start.velocity();
    return AlongOf<T>(MomentOf<T>{start.G, start.M, 1, q[0], q[1], v[0], v[1], 0, 0});
  }
  /// v x c0 - GM R.
  auto laplace() const {
    const T pull = start.mu() / r();
    return values(now.vy * h() - pull * now.x, -now.vx * h() - pull * now.y, 0);
  }
  struct Apsides {
    T nearest, farthest, half_axis;
  };
  /// By the energy and the angular momentum of the later moment.
  Apsides apsides() const {
    const T mu = start.mu(), energy = (pow(now.vx, 2) + pow(now.vy, 2)) / 2 - mu / r();
    const T root = sqrt(mu * mu + 2 * energy * h() * h());
    const T nearest = (mu - root) / (-2 * energy), farthest = (mu + root) / (-2 * energy);
    return {nearest, farthest, (nearest + farthest) / 2};
  }
  /// V_0 and V_0' are by dual numbers at the start, `a` by the apsides of the later moment.
  TypesetIn<T> typeset() const {
    const Elements<T> of(start);
    const AlongOf<T> at_start = first();
    const T c = cos(start.theta0), s = sin(start.theta0);
    return letters_of(start, {{"r", r()},
                              {R"(\alpha)", start.M * start.h()},
                              {R"(\theta)", theta},
                              {R"(\dot\theta)", w()},
                              {"V", V()},
                              {"V_0", at_start.V},
                              {"V_0'", at_start.V1},
                              {"c_0", c0},
                              {"c_1", c1},
                              {R"(\mathbf r)", {now.x, now.y, 0}},
                              {R"(\mathbf v)", {now.vx, now.vy, 0}},
                              {R"(\mathbf r_0)", {at_start.x, at_start.y, 0}},
                              {R"(\mathbf v_0)", {at_start.vx, at_start.vy, 0}},
                              {R"(\mathbf c_0)", {0, 0, start.h()}},
                              {R"(\mathbf R_0)", {c, s, 0}},
                              {R"(\mathbf P_0)", {-s, c, 0}},
                              {R"(\gamma_0)", of.gamma0},
                              {R"(\gamma_1)", of.gamma1},
                              {"e", of.e},
                              {R"(\rho)", of.rho},
                              {R"(\omega)", of.omega},
                              {"a", apsides().half_axis}});
  }
  /// All numbers of the sample, with angles as exact multiples of pi.
  LaterOf<Shortened> recorded() const requires std::same_as<T, double> {
    const auto angle = [](double x) { return pi_of<Shortened>() * (x / std::numbers::pi); };
    const auto& [G, M, r0, r0_dot, theta0, theta0_dot] = start;
    return {{G, M, r0, r0_dot, angle(theta0), theta0_dot},
            {G, M, now.m, now.x, now.y, now.vx, now.vy, now.push_x, now.push_y},
            t,
            angle(theta),
            c0,
            c1};
  }
};

/// A position and a velocity in space, with an acceleration by gravity.
template <class T>
struct InSpaceOf {
  std::array<T, 3> q, v;
  T mu;

  Letters<T> table() {
    return {{R"(\mathbf r)", q, {-1, 1}, "q"},
            {R"(\mathbf v)", v, {-1, 1}, "v"},
            {"GM", mu, positive_size(0.1, 10)}};
  }
  TypesetIn<T> typeset() const { return {{R"(\mathbf a)", gravity(mu, q)}}; }
};

namespace {

using Later = LaterOf<double>;
using OfStart = ProvableFormula<LaterOf>;
using LaterTable = ProvableClaims<LaterOf>;
using SpaceTable = ProvableClaims<InSpaceOf>;

/// Initial condition with `transverse` and `radial` times the circular speed.
Start random_start(Random& random, double transverse, double radial) {
  const double G = abs(random.magnitude(0.2, 5)), M = abs(random.magnitude(0.2, 5));
  const double r0 = abs(random.magnitude(0.3, 3)), circular = sqrt(G * M / r0);
  return {G, M, r0, radial * circular, random.between(-pi, pi), transverse * circular / r0};
}

/// Bound orbits of eccentricity up to 0.95, in either sense, each split into this many pieces.
constexpr std::size_t pieces = 64;

std::vector<Later> orbits(double seed) {
  Random random(seed);
  std::vector<Later> all;
  for (int i = 0; i < 40; ++i) {
    const double radial = random.between(-0.5, 0.5), transverse = random.between(0.5, 1.3);
    const Start s = random_start(random, transverse * (i % 4 ? 1 : -1), radial);
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
    const double push_x = random.normal(), push_y = random.normal(), m = abs(random.magnitude(1e-3, 1e3));
    const auto& [x, y, vx, vy] = states.back();
    Later k{s, {s.G, s.M, m, x, y, vx, vy, push_x, push_y}, end, angles.back(), 0, 0};
    double best = 0;
    for (std::size_t one = pieces / 8; one < pieces; one += pieces / 8)
      for (std::size_t two = one + pieces / 8; two < pieces; two += pieces / 8) {
        const double determinant = sin(angles[one] - angles[two]);
        if (abs(determinant) <= best) continue;
        best = abs(determinant);
        const double v1 = k.mean() - s.mu() / hypot(states[one][0], states[one][1]);
        const double v2 = k.mean() - s.mu() / hypot(states[two][0], states[two][1]);
        k.c0 = (v1 * cos(angles[two]) - v2 * cos(angles[one])) / determinant;
        k.c1 = (v2 * sin(angles[one]) - v1 * sin(angles[two])) / determinant;
      }
    all.push_back(std::move(k));
  }
  return all;
}

/// A random initial condition. Its speeds across and along the radius are in units of the speed on a circle.
struct AnyStart {
  double across, along;
  Start start;

  std::string where() const { return listed(letters_of(start), 6); }

  /// Whether r falls to a thousandth of r0 within ten times the time of a radian on a circle.
  bool falls() const {
    const Distance<double> model{start};
    const auto near = [&](double, const auto&, double, const Distance<double>::State& now) {
      return now[0] < 1e-3 * start.r0;
    };
    const double span = sqrt(pow(start.r0, 3) / start.mu());
    const std::array times{0.0, 10 * span};
    const auto states = ode::integrate<ode::RungeKutta4>(model, model.start(), std::span<const double>(times),
                                                         1e-3 * span, near);
    return !(states.value.back()[0] >= 1e-3 * start.r0);
  }
  TypesetLetters typeset() const {
    const OneAngle<double> by_start(start);
    return letters_of(start, {{"e", {Elements(start).e}},
                              {"c_0", {by_start.c0}},
                              {"c_1", {by_start.c1}},
                              {R"(\alpha)", {by_start.alpha}}});
  }
};

/// Random initial conditions, every other one with the opposite sense.
std::vector<AnyStart> starts(int count, double seed, double least, double most, double most_along) {
  Random random(seed);
  std::vector<AnyStart> all;
  for (int i = 0; i < count; ++i) {
    const double across = random.between(least, most) * (i % 2 ? -1 : 1),
                 along = random.between(-most_along, most_along);
    all.push_back({across, along, random_start(random, across, along)});
  }
  return all;
}

/// Adds every tenth again without angular momentum, half of these at rest.
std::vector<AnyStart> and_straight(std::vector<AnyStart> all) {
  for (std::size_t i = 0, count = all.size(); i < count; i += 10) {
    AnyStart k = all[i];
    k.across = k.start.theta0_dot = 0;
    if (i % 20 == 0) k.along = k.start.r0_dot = 0;
    all.push_back(k);
  }
  return all;
}

/// Claims an equation by the difference of its sides: as printed, and as meant where its bars are lost.
template <class Claim, class Truth>
void whole(const Claim& claim, std::string_view slug, int line, const Truth& no_difference,
           const std::string& text, const std::string& meant = {}, const std::string& why = {}) {
  claim(slug, line, text, {.truth = no_difference, .printed = text, .meant = meant, .why = why});
}

const std::string of_zero = "a multiple of zero is zero";

// ---- Newton's law in polar coordinates: lines 945 to 1007 -------------------------------------------------

void plane(SpaceTable& table, const std::vector<InSpaceOf<double>>& samples) {
  table.over(samples)(
      "plane", 945,
      R"(The normal $\mathbf c_0=\mathbf r\times\mathbf v$ is constant: the motion stays in the )"
      R"(plane of $\mathbf r$ and $\mathbf v$.)",
      {.quantity = R"($\mathbf r\times\mathbf a$, the rate of $\mathbf r\times\mathbf v$)",
       .truth = "$0$",
       .printed = R"($\mathbf r\times\mathbf a=(0,\ 0,\ 0)$)",
       .near_misses = {R"($\mathbf r\times(\mathbf a-0.1\,\mathbf v)=(0,\ 0,\ 0)$)"},
       .changes_that_hold = of_zero});
}

void motion_in_a_plane(Claims& claims, const std::vector<Later>& orbits, double seed) {
  claims.statement<AnyStart>(
      "orbit_for_all_time", 945,
      R"(A start whose $\mathbf r$ and $\mathbf v$ span a plane determines an orbit for all $t\ge0$.)",
      and_straight(starts(40, seed, 0.5, 1.3, 0.5)),
      {.printed = {R"($\mathbf r$ and $\mathbf v$ span a plane, and $r$ stays above $r_0/1000$)",
                   [](const AnyStart& k) { return k.across == 0 || !k.falls(); }},
       .near_misses = {{R"($r$ stays above $r_0/1000$ also where $\mathbf r$ and $\mathbf v$ are in line)",
                        [](const AnyStart& k) { return !k.falls(); }}}});
  std::vector<Later> forward = orbits;
  std::erase_if(forward, [](const Later& k) { return k.start.theta0_dot <= 0; });
  claims.statement<Later>("increasing", 987,
                          R"(For $\dot\theta_0>0$ the angle increases strictly for all time.)", forward,
                          {.printed = {R"($(\dot\theta,\ \theta)>(0,\ \theta_0)$)"},
                           .near_misses = {{R"($(\dot\theta,\ \theta)>(\dot\theta_0,\ \theta_0)$)"}}});
}

void polar_acceleration(PushedTable& table, const std::vector<Pushed>& moments) {
  const auto claim = table.over(moments);
  const auto acceleration =
      along<PushedOf>(R"($\ddot{\mathbf r}$, any acceleration in Cartesian coordinates)",
                      [](const auto& k) { return in_plane(k.ax, k.ay); }, &Along::of_rates);
  const std::string polar =
      R"($\mathbf a=(\ddot r-r\dot\theta^2)\mathbf R+(r\ddot\theta+2\dot r\dot\theta)\mathbf P$)";
  claim.equation("acceleration", 949, polar, acceleration);
  claim(
      "equation_number", 947, "Equation (3.2) is the polar form of any acceleration.",
      {.quantity = R"($\mathbf a$, which is $-(GM/r^2)\mathbf R$ by equation (3.2))",
       .truth = acceleration,
       .printed = R"($-(GM/r^2)\mathbf R$)",
       .meant = polar,
       .kind = Fault::number,
       .why =
           R"(Exercise 3.1 (855) and the end of this one (1229) give the number (3.2) to the orbit, )"
           R"($r=e\rho/(1+e\cos\theta)$, whose only acceleration is $-GM/r^2$ towards the sun. The polar form )"
           R"(is another equation of the book: whoever looks (3.2) up for it finds the orbit.)"});
  claim(
      "areal", 973,
      R"($r(r\ddot\theta+2\dot r\dot\theta)=r^2\ddot\theta+2r\dot r\dot\theta=\frac{d}{dt}(r^2\dot\theta)$)",
      along<PushedOf>(R"($x\ddot y-y\ddot x$)", [](const auto& k) { return k.x * k.ay - k.y * k.ax; },
                      &Along::of_moment),
      R"($(r(r\ddot\theta+2\dot r\dot\theta),\ r^2\ddot\theta+2r\dot r\dot\theta,\ \frac{d}{dt}(r^2\dot\theta))$)");
}

void equations_of_motion(Table& table, const std::vector<Moment>& moments) {
  const auto claim = table.over(moments);
  claim("unit_vector", 945,
        R"($\mathbf r=r\mathbf R$, and $\mathbf R$ is of length 1 and points from the sun to the planet.)",
        along("the planet's coordinates", [](const auto& k) { return in_plane(k.x, k.y); }),
        R"($\mathbf r=r\mathbf R$)");
  claim(
      "gravity", 953,
      R"($\mathbf a=-GM\,r^3\,\mathbf r$ (the distance cubed, times the vector) )"
      R"($=-GM\,r^2\,\mathbf R=-(GM/r^2)\mathbf R+0\,\mathbf P$)",
      {.quantity = R"($\mathbf a$, three times)",
       .truth = along(R"(the slope of $GM/|\mathbf r|$ by dual numbers)",
                      [](const auto& k) { return in_plane(k.ax, k.ay, 3); }),
       .printed = R"($(-GM\,r^3\,\mathbf r,\ -GM\,r^2\,\mathbf R,\ -(GM/r^2)\mathbf R+0\,\mathbf P)$)",
       .meant = R"($(-(GM/r^3)\,\mathbf r,\ -(GM/r^2)\,\mathbf R,\ -(GM/r^2)\mathbf R+0\,\mathbf P)$)",
       .why = filled(
           R"(The fraction bars are lost; the last form has its bar. Without them the first form multiplies )"
           R"(the pull on a planet twice as far away by @2 and the second by @1, instead of by @2.)",
           {pow(2, 4), pow(2, 2), pow(2, -2)})});
  const auto no_rest = zero(&Along::of_rates);
  whole(claim, "radial", 967, no_rest, R"($\ddot r-r\dot\theta^2=-GM\,r^2$)",
        R"($\ddot r-r\dot\theta^2=-GM/r^2$)",
        "The fraction bar is lost; equation (2), which follows from this line, shows it.");
  claim("transverse", 967, R"($r\ddot\theta+2\dot r\dot\theta=0$)", no_rest,
        R"($r\ddot\theta+2\dot r\dot\theta=0$)", "the left side", of_zero);
  claim(
      "angular_momentum", 979, R"($\alpha=Mr^2\dot\theta$ is the angular momentum.)",
      {.quantity = R"($\partial L/\partial\dot\theta$ of a planet of mass $m$)",
       .truth = along(R"($L=T-V$ differentiated by dual numbers)",
                      [](const auto& k) {
                        const auto lagrangian = [&](auto rate) {
                          return k.m / 2 * (k.r_dot * k.r_dot + k.r * k.r * (rate * rate)) + k.m * k.mu / k.r;
                        };
                        return derivative(lagrangian, k.w);
                      }),
       .printed = R"($Mr^2\dot\theta$)",
       .corrected = R"($mr^2\dot\theta$)",
       .root = "the sun's mass for the planet's",
       .why = filled(
           R"($M$ is the mass that attracts, the sun's. By Lagrange's function $L=T-V$ of the planet it is )"
           R"($\partial L/\partial\dot\theta=mr^2\dot\theta$ with the planet's mass, for the Earth 1/@6 of the )"
           R"(sun's. $\alpha$ is constant all the same, and the later lines use no more: only )"
           R"($\alpha/M=r^2\dot\theta$ ever enters.)",
           {suns_per_earth})});
  claim.equation(
      "radial_equation", 995,
      R"($-GM/r^2=\ddot r-r\dot\theta^2=\ddot r-r(\alpha/(Mr^2))^2=\ddot r-\alpha^2/(M^2r^3)$ (2))",
      along(R"($-GM/r^2$)", [](const auto& k) { return -k.mu / (k.r * k.r); }, &Along::of_rates));
}

/// A moment whose acceleration is also taken near the sun, alpha being the same.
struct NearTheSun : Moment {
  double z() const { return hypot(x, y) * 0x1p-21; }
  double h() const { return x * vy - y * vx; }
  double fall(double r) const { return Along(Moment{G, M, m, r, 0, 0, h() / r, 0, 0}).r_dot_dot; }
  Tolerance tolerance(double) const {
    return {16 * G * M * z() / (h() * h()) + 1e-12, R"(twice the pull's share there, $GMz/h^2$)"};
  }
};

void singularity(Claims& claims, const std::vector<Moment>& moments) {
  const std::vector<NearTheSun> near(moments.begin(), moments.end());
  claims.over(near)(
      "singular", 1007, R"(The right-hand side of (2) has a singularity at $r=0$.)",
      {"Cartesian, by dual numbers", [](const NearTheSun& k) { return k.fall(k.z()) / k.fall(2 * k.z()); }},
      {"$2^3$"}, R"($\ddot r$ at $z$ over $\ddot r$ at $2z$, $z=2^{-21}r$, if it grows like $1/r^3$)");
}

// ---- the potential as a function of the angle: lines 1009 to 1101 -----------------------------------------

void equation_of_the_potential(Table& table, const std::vector<Moment>& moments) {
  const auto claim = table.over(moments);
  claim(
      "potential_energy", 1009, R"($V=-GM/r$ is the potential energy.)",
      {.quantity = R"(the force on a planet of mass $m$, with $dV/dr$ of this $V$ by dual numbers)",
       .truth = along(R"($m$ times the slope of $GM/|\mathbf r|$ by dual numbers)",
                      [](const auto& k) { return k.m * (k.ax * k.c + k.ay * k.s); }),
       .printed = "$-dV/dr$",
       .corrected = R"($-m\,dV/dr$)",
       .root = "the sun's mass for the planet's",
       .why =
           R"(The force on a planet of mass $m$ is $-GMm/r^2$; $-GM/r$ is its energy divided by $m$, and )"
           R"($\alpha=Mr^2\dot\theta$ its momentum times $M/m$: $V$ and $\alpha$ belong to different masses. The )"
           R"(orbit depends on neither; only a display of energies in joules is off by the factor $m$.)"});
  const auto rate = along(R"($\dot r$ by dual numbers)", [](const auto& k) { return k.r_dot; });
  claim.lost(
      "power_rule", 1013, R"($\dot r=\frac{d}{dt}(-GM\,V)=(GM/V^2)\,dV/dt$)", rate,
      R"($\dot r=\frac{d}{dt}(-GM/V)=(GM/V^2)\,dV/dt$)",
      R"(The fraction bar of $-GM/V$ is lost. The product $-GMV=G^2M^2/r$ is no distance, and shrinks )"
      R"(where the distance grows.)");
  claim.lost(
      "chain_rule", 1021, R"($\dot r=GM\,V^2\,(dV/d\theta)\,\dot\theta$)", rate,
      R"($\dot r=(GM/V^2)\,(dV/d\theta)\,\dot\theta$)",
      filled(
          R"(The fraction bar is lost; the line before shows it. For the Earth, in astronomical units and )"
          R"(years, the product $GMV^2$ is @5 where the quotient is @2.)",
          {pow(four_pi_squared, 3), 1 / four_pi_squared}));
  claim.lost(
      "r_dot", 1031, R"($\dot r=GM\,(-GM/r)^2\,V'\,(\alpha\,Mr^2)=\alpha V'/(GM^2)$)", rate,
      R"($\dot r=GM/(-GM/r)^2\,V'\,(\alpha/(Mr^2))=\alpha V'/(GM^2)$)",
      R"(The bars of the first form's two fractions are lost. As products, the powers of $r$ cancel as )"
      R"(well, and the result is $G^3M^4\alpha V'$ for $\alpha V'/(GM^2)$.)");
  const auto second_rate =
      along(R"($\ddot r$ by dual numbers)", [](const auto& k) { return k.r_dot_dot; }, &Along::of_rates);
  claim.lost(
      "second_chain_rule", 1041, R"($\ddot r=\alpha\,GM^2\,dV'/dt=\alpha\,GM^2\,V''\dot\theta$)", second_rate,
      R"($\ddot r=\alpha/(GM^2)\,dV'/dt=\alpha/(GM^2)\,V''\dot\theta$)",
      "The fraction bar is lost, here and in line 1049: line 1037, which is differentiated, shows it.");
  claim.lost(
      "r_dot_dot", 1055, R"($\ddot r=\alpha\,GM^2\,V''\,(\alpha\,Mr^2)=\alpha^2V''/(GM^3r^2)$)", second_rate,
      R"($\ddot r=\alpha/(GM^2)\,V''\,(\alpha/(Mr^2))=\alpha^2V''/(GM^3r^2)$)",
      R"(The bars of $\alpha/(GM^2)$ and of $\dot\theta=\alpha/(Mr^2)$ are lost; the last form of the )"
      R"(line has one for both.)");
  claim.equation("r_dot_dot_by_V", 1063, R"($\ddot r=\alpha^2V''/(GM^3(-GM/V)^2)=\alpha^2V''V^2/(G^3M^5)$)",
                 second_rate);
  const auto no_rest = zero(&Along::of_rates);
  whole(claim, "radial_equation_again", 1073, no_rest, R"($-GM\,r^2=\ddot r-\alpha^2/(M^2r^3)$)",
        R"($-GM/r^2=\ddot r-\alpha^2/(M^2r^3)$)",
        "The fraction bar is lost; equation (2), which the line repeats, shows it.");
  whole(claim, "substituted", 1077, no_rest,
        R"($-GM\,(-GM/V)^2=\alpha^2V''V^2/(G^3M^5)-\alpha^2/(M^2(-GM/V)^3)$)",
        R"($-GM/(-GM/V)^2=\alpha^2V''V^2/(G^3M^5)-\alpha^2/(M^2(-GM/V)^3)$)",
        R"(The bar of the left side is lost, as at line 953: $GM(-GM/V)^2$ is $GMr^2$, a pull that grows )"
        R"(with the distance. The next line, $-V^2/(GM)$, is the quotient.)");
  whole(claim, "simplified", 1083, no_rest, R"($-V^2/(GM)=\alpha^2V''V^2/(G^3M^5)+\alpha^2V^3/(G^3M^5)$)");
  whole(claim, "potential_equation", 1091, zero(&Along::of_bend), R"($-G^2M^4/\alpha^2=V''+V$)");
  claim("characteristic", 1095, R"($\lambda^2+1=0$ has the roots $\lambda=\pm i$.)",
        along(
            "$V''$ by dual numbers", [](const auto& k) { return values(k.V2, 0, 0, k.V2); }, &Along::of_bend),
        R"($\lambda\lambda(V+G^2M^4/\alpha^2)$)",
        R"($V''$ times the unit matrix, $\lambda=i$ being the matrix of a quarter turn)");
  claim("independent", 1095,
        R"($\sin\theta$ and $\cos\theta$ are linearly independent solutions of $V''+V=0$.)",
        along("the determinant by dual numbers",
              [](const auto& k) {
                return k.s * derivative([](auto z) { return cos(z); }, k.angle) -
                       k.c * derivative([](auto z) { return sin(z); }, k.angle);
              }),
        "$-1$", "Wronski's determinant, which must not be zero");
  claim("particular", 1101, R"($V_p=-G^2M^4/\alpha^2$ has $V_p''+V_p=0-G^2M^4/\alpha^2$)",
        along("$V$, $V'$ and $V''$ on a circle, by dual numbers",
              []<class T>(const AlongOf<T>& k) {
                const auto w = sqrt(k.mu / (k.r * k.r * k.r)), x = k.r * k.c, y = k.r * k.s;
                const AlongOf circle(MomentOf<T>{k.G, k.M, k.m, x, y, -w * y, w * x, 0, 0});
                return values(circle.V, circle.V1, circle.V2);
              }),
        R"($(-G^2M^4/\alpha_c^2,\ 0,\ 0)$)",
        R"($(V,V',V'')$ on a circle, where $V$ is constant and $\alpha$ is $\alpha_c$)");
}

// ---- from the start to a later moment: lines 979 to 1227 --------------------------------------------------

void time_by_angle(LaterTable& table, const std::vector<Later>& orbits) {
  const auto at = [](const auto& k, const auto& angle) {
    return values(k.time_between(k.start.theta0, angle, k.start.h()), k.distance(angle));
  };
  table.over(orbits)(
      "invertible", 987,
      R"($t$ is a function of $\theta$, $t=f^{-1}(\theta)$, and $r(f^{-1}(\theta))$ is the distance as a function of the angle.)",
      {.quantity = R"($(t,r)$)",
       .truth = {"time and distance on a path by Newton's law",
                 [](const auto& k) { return values(k.t, k.r()); }},
       .printed =
           {R"($\int r^2d\theta/(r_0^2\dot\theta_0)$ and $r(\theta)$, by $c_0$ and $c_1$ from two other places)",
            [=](const auto& k) { return at(k, k.theta); }},
       .near_misses = {{"both functions at half the angle",
                        [=](const Later& k) { return at(k, (k.start.theta0 + k.theta) / 2); }}}});
}

/// A quantity from two places on the path that are neither the start nor the later moment.
template <class F>
OfStart by_two_places(const std::string& text, const F& of) {
  return {text + ", $c_0$ and $c_1$ from two later places on the path", of};
}

void constants_of_motion(LaterTable& table, const std::vector<Later>& orbits) {
  const auto claim = table.over(orbits);
  const OfStart rate{R"($\dot\theta$ later on a path by Newton's law)", [](const auto& k) { return k.w(); }};
  claim("conserved", 979,
        R"($r^2\dot\theta$ is constant, and so is $\alpha=Mr^2\dot\theta=Mr_0^2\dot\theta_0$.)",
        {R"($x\dot y-y\dot x$ later on a path by Newton's law, and $M$ times it)",
         [](const auto& k) { return values(k.h(), k.start.M * k.h()); }},
        R"($(r_0^2\dot\theta_0,\ Mr_0^2\dot\theta_0)$)");
  claim.lost(
      "rate", 981, R"($\dot\theta=\alpha/(Mr^2)=r_0^2\dot\theta_0\,r^2$ (1))", rate,
      R"($\dot\theta=\alpha/(Mr^2)=r_0^2\dot\theta_0/r^2$)",
      filled(R"(The bar of the second fraction is lost; the first form has its bar. Without it, a planet )"
             R"(that has come to twice its distance goes round at @1 times its rate instead of @2 of it.)",
             {pow(2, 2), pow(2, -2)}));
  claim("constant", 1095, R"(The left-hand side $-G^2M^4/\alpha^2$ is a constant.)",
        {R"($-G^2M^4/\alpha^2$ by the angular momentum later on a path by Newton's law)",
         [](const auto& k) { return -pow(k.start.mu() / k.h(), 2); }},
        R"($-G^2M^4/\alpha^2$)");
  claim("homogeneous", 1097, R"($V_h=c_0\sin\theta+c_1\cos\theta$ has $V_h''+V_h=0$)",
        {R"($V_h''$ by dual numbers, $c_0$ and $c_1$ from two places on the path)",
         [](const auto& k) {
           return second_derivative([&](auto z) { return k.c0 * sin(z) + k.c1 * cos(z); }, k.theta);
         }},
        R"($V_h''=-(V+G^2M^4/\alpha^2)$)", R"($V_h''$, $V_h$ being $V-V_p$ at a third place)");
  claim.equation("potential", 1107, R"($V=c_0\sin\theta+c_1\cos\theta-G^2M^4/\alpha^2$ (3))",
                 {R"($-GM/r$ later on a path by Newton's law)", [](const auto& k) { return k.V(); }});
  claim.equation("potential_slope", 1113, R"($V'=c_0\cos\theta-c_1\sin\theta$)",
                 {R"($\dot V/\dot\theta$ later on the path, by dual numbers)",
                  [](const auto& k) { return AlongOf(k.now).V1; }});
  claim(
      "system", 1117,
      R"(At $\theta_0$: $c_0\sin\theta_0+c_1\cos\theta_0=V_0+G^2M^4/\alpha^2$, $c_0\cos\theta_0-c_1\sin\theta=V_0'$)",
      {.quantity = R"($V_0+G^2M^4/\alpha^2$ and $V_0'$)",
       .truth = {R"($-GM/r_0+G^2M^4/\alpha^2$ and $\dot V/\dot\theta$ at the start, by dual numbers)",
                 [](const auto& k) { return values(k.first().V + k.mean(), k.first().V1); }},
       .printed = R"($(c_0\sin\theta_0+c_1\cos\theta_0,\ c_0\cos\theta_0-c_1\sin\theta)$)",
       .meant = R"($(c_0\sin\theta_0+c_1\cos\theta_0,\ c_0\cos\theta_0-c_1\sin\theta_0)$)",
       .kind = Fault::formula,
       .why = "Both equations are at the initial angle. The second sine has lost its index 0, which the "
              "solution given next shows."});
  const std::string bracket = R"((V_0+G^2M^4/\alpha^2))", c0 = bracket + R"(\sin\theta_0+V_0'\cos\theta_0)",
                    c1 = bracket + R"(\cos\theta_0-V_0'\sin\theta_0)";
  claim("system_solved", 1123, "$c_0=" + c0 + "$, $c_1=" + c1 + "$",
        {R"($c_0$ and $c_1$ from two later places on the path)",
         [](const auto& k) { return values(k.c0, k.c1); }},
        "$(" + c0 + R"(,\ )" + c1 + ")$", R"($(c_0,c_1)$, $V_0$ and $V_0'$ by dual numbers)");
  claim.lost("V0_slope", 1149, R"($V_0'=GM^2\dot r_0\,\alpha$)",
             by_two_places("(3) differentiated", [](const auto& k) { return k.slope(k.start.theta0); }),
             R"($V_0'=GM^2\dot r_0/\alpha$)",
             R"(The fraction bar is lost; line 1031, from which it comes, is $\dot r=\alpha V'/(GM^2)$.)");
  claim(
      "mass_cancels", 1171,
      R"($G^2M^4/(Mr_0^2\dot\theta_0)^2=G^2M^2/(r_0^4\dot\theta_0^2)$, and the term in $\dot r_0$ is $GM\,\dot r_0\,r_0^2\dot\theta_0$)",
      {.quantity = R"($G^2M^4/\alpha^2$ and $GM^2\dot r_0/\alpha$)",
       .truth = {R"($\alpha=Mr^2\dot\theta$ taken later on the path)",
                 [](const auto& k) {
                   const auto mu = k.start.mu(), alpha = k.start.M * k.h();
                   return values(pow(mu / k.h(), 2), mu * k.start.M * k.start.r0_dot / alpha);
                 }},
       .printed = R"($(G^2M^2/(r_0^4\dot\theta_0^2),\ GM\,\dot r_0\,r_0^2\dot\theta_0)$)",
       .meant = R"($(G^2M^2/(r_0^4\dot\theta_0^2),\ GM\,\dot r_0/(r_0^2\dot\theta_0))$)",
       .why =
           filled(R"(The bars of the terms in $\dot r_0$ are lost in both lines. At the start of the scene )"
                  R"(below the second's $GM\,\dot r_0\,r_0^2\dot\theta_0$ is @2, and the quotient @2.)",
                  {near_earth.mu() * near_earth.r0_dot * near_earth.h(),
                   near_earth.mu() * near_earth.r0_dot / near_earth.h()})});
  claim("last_term_of_c1", 1187, R"(The last term of (5) is $GM\,\dot r_0\,r_0^2\dot\theta_0\sin\theta_0$.)",
        {.quantity = R"($V_0'\sin\theta_0$)",
         .truth = by_two_places("(3) differentiated",
                                [](const auto& k) { return k.slope(k.start.theta0) * sin(k.start.theta0); }),
         .printed = R"($GM\,\dot r_0\,r_0^2\dot\theta_0\sin\theta_0$)",
         .meant = R"($GM\,\dot r_0/(r_0^2\dot\theta_0)\,\sin\theta_0$)",
         .why = "The fraction bar is lost, as in (4)."});
  claim("V0_put_in", 1159, R"(Put into $c_0$ and $c_1$, $V_0$ is $GM\,r_0$.)",
        {.quantity = R"(the first term of the brackets, whose sign is judged at `V0`)",
         .truth = by_two_places(R"($-V(\theta_0)$ by (3))",
                                [](const auto& k) { return k.mean() - k.potential(k.start.theta0); }),
         .printed = R"($GM\,r_0$)",
         .meant = R"($GM/r_0$)",
         .why =
             R"(The fraction bar is lost here and at lines 1171 and 1187; line 1143, which is put in, shows )"
             R"(it. The sign of $V_0$ is wrong in all of them.)"});

  /// A sign is missing at the @.
  const auto with = [](std::string text, const char* sign) { return text.replace(text.find('@'), 1, sign); };
  const auto wrong_sign = [&](std::string_view slug, int line, const std::string& says,
                              const std::string& text, const OfStart& truth, const std::string& why) {
    claim(slug, line, says,
          {.quantity = sides_of_equation(text).first,
           .truth = truth,
           .printed = with(text, ""),
           .corrected = with(text, "-"),
           .root = "sign of the potential at the start",
           .why = why});
  };
  /// (4), (5) or the bracket of (7), by the factors of its terms.
  const auto constant = [](const std::string& first, const std::string& last) {
    return R"(\left(@\frac{GM}{r_0}+\frac{G^2M^2}{r_0^4\dot\theta_0^2}\right))" + first +
           R"(\frac{GM\dot r_0}{r_0^2\dot\theta_0})" + last;
  };
  const std::string fourth = "$c_0=" + constant(R"(\sin\theta_0+)", R"(\cos\theta_0)") + "$",
                    fifth = "$c_1=" + constant(R"(\cos\theta_0-)", R"(\sin\theta_0)") + "$";
  wrong_sign(
      "V0", 1143, R"($V_0=V(\theta_0)=GM/r_0$)", "$V_0=@GM/r_0$",
      by_two_places("(3)", [](const auto& k) { return k.potential(k.start.theta0) - k.mean(); }),
      R"($V=-GM/r$ by definition (line 1009), so $V_0=-GM/r_0$. The sign is carried on into (4) and (5), and )"
      R"(turns the planet's orbit into one on which it stops.)");
  wrong_sign(
      "c0", 1171, with(fourth, "") + " (4)", fourth,
      {"$c_0$ from two later places on the path", [](const auto& k) { return k.c0; }},
      R"(The first term is $V_0=-GM/r_0$. On a circle ($r_0^3\dot\theta_0^2=GM$) the bracket must vanish; as )"
      R"(printed it is $2GM/r_0$. The bars that our copy has lost are judged at `V0_put_in` and `mass_cancels`.)");
  wrong_sign(
      "c1", 1187, with(fifth, "") + " (5)", fifth,
      {"$c_1$ from two later places on the path", [](const auto& k) { return k.c1; }},
      R"(As in (4), the first term is $V_0=-GM/r_0$: on a circle $c_1$ must be zero, and as printed it is )"
      R"($2GM\cos\theta_0/r_0$.)");
  claim.equation("rate_by_angle", 1215,
                 R"($\dot\theta=\frac{\alpha}{G^2M^3}(c_0\sin\theta+c_1\cos\theta-G^2M^4/\alpha^2)^2$ (7))",
                 rate);
  const OneAngle<double> printed_circle({4, 1, 1, 0, 0, 2}, 4);  // GM = 4, V0 = +4
  wrong_sign(
      "constants_of_rate", 1227, "The constants of (7) are those of (4) and (5).",
      R"($\dot\theta=\frac{\alpha}{G^2M^3}\left()" +
          constant(R"(\cos(\theta-\theta_0)+)", R"(\sin(\theta-\theta_0))") +
          R"(-\frac{G^2M^4}{\alpha^2}\right)^2$)",
      rate,
      filled(
          R"(With (4) and (5) the bracket of (7) is $V_0$ at the start. It is squared, so the planet starts with )"
          R"(the right $\dot\theta_0$ for either sign, and the error shows only later. With the printed sign the )"
          R"(bracket reaches zero where $c_0\sin\theta+c_1\cos\theta=G^2M^4/\alpha^2$; there $\dot\theta=0$, and the planet )"
          R"(never comes round. (A nearly circular orbit ends $@2^\circ$ from its start.))",
          {180 / pi * acos(printed_circle.mean / hypot(printed_circle.c0, printed_circle.c1))}));
}

/// Relative error of the initial potential by (3), (4) and (5), which should be -GM/r0.
template <class T>
T off_at_start(const Given<T>& start, double sign) {
  const T V0 = start.mu() / start.r0;
  return OneAngle<T>(start, sign * V0).V(start.theta0) / V0 + 1;
}

void any_start(Claims& claims, double seed) {
  const auto turning = [](const AnyStart& k) { return k.across != 0; };
  const auto with_sign = [=](const std::string& text, double sign) {
    return Formula<AnyStart>{text,
                             [=](const AnyStart& k) { return turning(k) ? off_at_start(k.start, sign) : 0; },
                             [=](const AnyStart& k) { return turning(k) ? 2 + 2 / pow(k.across, 2) : 0; }};
  };
  const std::string sum = R"($c_0\sin\theta_0+c_1\cos\theta_0-G^2M^4/\alpha^2=-GM/r_0$)";
  claims.formula<AnyStart>(
      "constants_of_any_start", 1171,
      R"((4) and (5) give $c_0$ and $c_1$ for any $r_0,\dot r_0,\theta_0,\dot\theta_0$ (except for the sign )"
      R"(of $V_0$))",
      and_straight(starts(100, seed, 0.5, 1.3, 0.5)),
      {.quantity = "the difference of the sides",
       .truth = {"zero", [](const AnyStart&) { return 0.0; }},
       .printed = {sum},
       .corrected = with_sign(sum + R"( for $\dot\theta_0\ne0$)", -1),
       .in_view = {R"(for a planet that goes round, $\dot\theta_0\ne0$)", turning},
       .near_misses = {with_sign(R"(this sum for $\dot\theta_0\ne0$, with $+GM/r_0$ in (4) and (5))", 1)},
       .root = "a start without angular momentum",
       .why =
           R"(Both divide by $\dot\theta_0$. A planet that starts at rest, or straight towards the sun or away from )"
           R"(it, has $\alpha=0$; then $c_0$ and $c_1$ are infinite or not a number, and so is every angle that (7) )"
           R"(gives. The planet stays on its ray: from rest at $r_0$ it falls into the sun within )"
           R"($\tfrac{\pi}{2\sqrt2}\sqrt{r_0^3/GM}$. A program that takes $\dot\theta_0$ from the user has to )"
           R"(treat zero apart.)"});
}

// ---- solved numerically: lines 47 and 1007 ----------------------------------------------------------------

/// A planet after a whole number of turns from its aphelion, by Runge-Kutta 4 with equal steps. The errors
/// are those of its position by (3.1) in Cartesian coordinates, by (2) and by (7), relative to the semi-major
/// axis.
struct Turned {
  static constexpr double turns = 10, steps = 365, fine_steps = 3650;
  double e, direct, distance, angle;
  double fine_angle;  ///< by (7) with the fine steps

  Turned(Random& random, double eccentricity) : e(eccentricity) {
    const double G = abs(random.magnitude(0.2, 5)), M = abs(random.magnitude(0.2, 5)), a = 1 / (1 + e);
    const double at_aphelion = sqrt(G * M / a * (1 - e) / (1 + e));
    const Start start{G, M, 1, 0, random.between(-pi, pi), at_aphelion};
    const auto q = start.position();
    const double turn = 2 * pi * sqrt(a * a * a / (G * M));
    const auto off = [&](const auto& model, double steps_a_turn) {
      const auto end =
          ode::integrate<ode::RungeKutta4>(model, model.start(), 0, turns * turn, turn / steps_a_turn).value;
      const auto seen = model.observe(end, 0.0);
      return hypot(seen[0] - q[0], seen[1] - q[1]) / a;
    };
    direct = off(Cartesian<double>{start}, steps);
    distance = off(Distance<double>{start}, steps);
    angle = off(OneAngle<double>(start), steps);
    fine_angle = off(OneAngle<double>(start), fine_steps);
  }
  std::string where() const { return "$e$ = " + format_significant(e, 3); }
};
/// NaN is lost as well.
bool is_lost(double off) { return !(off < 0.1); }

constexpr double earths_eccentricity = 0.0167;

void solved_numerically(Claims& claims, double seed) {
  using K = const Turned&;
  constexpr double turns = Turned::turns, steps = Turned::steps, fine_steps = Turned::fine_steps;
  constexpr double comets_from = 0.94, comets_to = 0.96, most = 0.95, closest = 0.99, round_to = 0.7;
  Random random(seed);
  std::vector<Turned> comets, all, close;
  for (int i = 0; i < 20; ++i) comets.emplace_back(random, random.between(comets_from, comets_to));
  for (int i = 0; i < 20; ++i) all.emplace_back(random, random.between(0, most));
  for (int i = 0; i < 20; ++i) close.emplace_back(random, random.between(most, closest));
  const auto lost = [](const std::vector<Turned>& of) {
    return static_cast<double>(std::ranges::count_if(of, [](K k) { return is_lost(k.direct); }));
  };
  std::vector<Turned> any = all;
  any.emplace_back(random, earths_eccentricity);
  any.insert(any.end(), comets.begin(), comets.end());
  claims.statement<Turned>(
      "direct_solution", 47,
      R"(A solver that is given (3.1), $\ddot{\mathbf r}=-GM\,\mathbf r/r^3$, directly will likely have severe problems with stability.)",
      any,
      {.printed = {filled("Runge-Kutta 4 with @3 steps a turn loses the planet by (3.1) within @2 turns",
                          {steps, turns}),
                   [](K k) { return is_lost(k.direct); }},
       .corrected =
           {filled(
                "it loses the planet where $@2<e<@2$, and comes round to a hundredth of the orbit where $e<@1$",
                {comets_from, comets_to, round_to}),
            [](K k) {
              return (k.e <= comets_from || is_lost(k.direct)) && (k.e >= round_to || k.direct < 1e-2);
            }},
       .near_misses = {{"it loses every planet with $e>0.5$",
                        [](K k) { return k.e <= 0.5 || is_lost(k.direct); }}},
       .kind = Fault::counterexample,
       .root = "any orbit for an eccentric one",
       .why = filled(
           "The Earth, which the text mentions, comes round. Of @2 orbits with $e<@2$ Runge-Kutta 4 with @3 "
           "steps a turn on (3.1) loses @1. The difficult orbits are eccentric: equal steps are too long at the "
           "perihelion. Of @2 orbits with $@2<e<@2$ it loses @2.",
           {static_cast<double>(all.size()), most, steps, lost(all), static_cast<double>(comets.size()),
            comets_from, comets_to, lost(comets)})});
  std::vector<Turned> to_close = all;
  to_close.insert(to_close.end(), close.begin(), close.end());
  claims.statement<Turned>(
      "stable_reformulation", 47,
      filled(
          "Reformulated, as (7), the problem can be solved in a numerically stable manner (our conditions: with "
          "$e<@2$, or with shorter steps up to $e=@2$).",
          {most, closest}),
      to_close,
      {.printed =
           {filled("Runge-Kutta 4 on (7) errs by less than 1 % of the orbit after @2 turns: with @3 steps a "
                   "turn for $e<@2$, with @4 up to $e=@2$ (our conditions)",
                   {turns, steps, most, fine_steps, closest}),
            [](K k) { return (k.e > most || k.angle < 1e-2) && k.fine_angle < 1e-2; }},
       .near_misses = {{"on (3.1) likewise", [](K k) { return k.direct < 1e-2; }},
                       {filled("with @3 steps a turn up to $e=@2$", {steps, closest}),
                        [](K k) { return k.angle < 1e-2; }}}});
  claims.statement<Turned>(
      "singular_in_practice", 1007, "The singularity of (2) at $r=0$ can cause problems for a solver.",
      comets,
      {.printed =
           {filled(
                "for instance: where $@2<e<@2$ Runge-Kutta 4 with @3 steps a turn loses the planet by (2), and "
                "does not by (7)",
                {comets_from, comets_to, steps}),
            [](K k) { return is_lost(k.distance) && !is_lost(k.angle); }},
       .near_misses = {{"it loses it by (7) too", [](K k) { return is_lost(k.angle); }}}});
}

/// An orbit and another from the same position, with four times the mass and twice the velocity.
struct Faster : Later {
  Later other() const {
    Later fast = *this;
    fast.start.M *= 4, fast.start.r0_dot *= 2, fast.start.theta0_dot *= 2, fast.c0 *= 4, fast.c1 *= 4;
    return fast;
  }
  Tolerance tolerance(double) const { return {1e-12, "the quadrature of the periods"}; }
};

void timing(Claims& claims, const std::vector<Later>& orbits) {
  const std::vector<Faster> all(orbits.begin(), orbits.end());
  claims.formula<Faster>(
      "no_timing", 47,
      R"((3.2), $r=e\rho/(1+e\cos\theta)$, gives no clue about how the angle varies with time.)", all,
      {.quantity =
           R"($(e_1-e,\ \rho_1/\rho,\ T_1/T)$, the index for four times the mass and twice the velocity)",
       .truth = {"the elements by the start, the periods by $c_0$ and $c_1$",
                 [](const Faster& k) {
                   const Elements slow(k.start), quick(k.other().start);
                   return values(quick.e - slow.e, quick.rho / slow.rho, k.other().turn() / k.turn());
                 }},
       .printed = {R"($(0,\ 1,\ \frac12)$)"}});
}

void application(Claims& claims) {
  const std::string why = "the program is on the book's CD-ROM; the text has no listing of it";
  claims.add("textbook_end", 47, "Textbooks end with (3.2).", {.not_checkable = "it is about other books"})
      .add("kepler_polar_form", 1229, "The application `KeplerPolarForm` solves (7) numerically.",
           {.not_checkable = why})
      .add("draws_path", 1229, "The application draws the path for the inputs that a user specifies.",
           {.not_checkable = why})
      .add("verifies_period", 1265, "The application verifies the equation of the period.",
           {.not_checkable = why})
      .add("computes_axes", 1271, "The application computes $a$, $b$ and $T$.", {.not_checkable = why});
}

// ---- the orbit: lines 1199 and 1229 to 1269 ---------------------------------------------------------------

void momentum(Claims& claims, const std::vector<Later>& orbits) {
  claims.over(orbits)(
      "momentum", 1199, R"(Conservation of momentum is represented by $\alpha=Mr^2\dot\theta$, a constant.)",
      {.quantity = "the change from the start to a later moment on a path by Newton's law",
       .truth = {"$0$"},
       .printed = {R"($\mathbf v-\mathbf v_0=(0,\ 0,\ 0)$)"},
       .meant = {R"($\mathbf r\times\mathbf v=\mathbf r_0\times\mathbf v_0$)"},
       .kind = Fault::term,
       .why = filled("The word *angular* is left out. The planet's momentum turns through a full circle with "
                     "every orbit: the Earth's velocity changes by @2 km/s in half a year. Its moment about "
                     "the sun is constant.",
                     {2 * earths_speed})});
}

void moments_of_the_velocity(Table& table, const std::vector<Moment>& moments) {
  const auto claim = table.over(moments);
  claim.equation("rate_by_V", 1201,
                 R"($\dot\theta=\alpha/(Mr^2)=\alpha/(M(-GM/V)^2)=\alpha V^2/(G^2M^3)$ (6))",
                 along(R"($\dot\theta$ by dual numbers)", [](const auto& k) { return k.w; }));
  claim.equation("velocity", 1235, R"($\mathbf v=\dot r\mathbf R+r\dot\theta\mathbf P$)",
                 along("the path's velocity", [](const auto& k) { return in_plane(k.vx, k.vy); }));
  claim.equation(
      "moment", 1237,
      R"($\mathbf r\times\mathbf v=(r\mathbf R)\times(\dot r\mathbf R+r\dot\theta\mathbf P)=r^2\dot\theta\,\mathbf k$)",
      along(R"($(0,0,x\dot y-y\dot x)$)", [](const auto& k) { return values(0, 0, k.h, 0, 0, k.h); }));
  claim.equation(
      "v_cross_c0", 1245,
      R"($\mathbf v\times\mathbf c_0=(\dot r\mathbf R+r\dot\theta\mathbf P)\times(r^2\dot\theta)\mathbf k)"
      R"(=(r^2\dot r\dot\theta)\mathbf R\times\mathbf k+(r^3\dot\theta^2)\mathbf P\times\mathbf k)"
      R"(=-(r^2\dot r\dot\theta)\mathbf P+(r^3\dot\theta^2)\mathbf R$)",
      along(R"($\mathbf v\times\mathbf c_0$ in Cartesian coordinates)",
            [](const auto& k) { return in_plane(k.vy * k.h, -k.vx * k.h, 3); }));
}

void vectors(LaterTable& table, const std::vector<Later>& orbits) {
  const auto claim = table.over(orbits);
  const std::string later = R"($\mathbf v\times\mathbf c_0-GM\,\mathbf R$ later on the path)";
  claim("laplace", 1231,
        R"($\mathbf v\times\mathbf c_0=GM\,\mathbf R+\mathbf c_1$ with a constant vector $\mathbf c_1$)",
        {later, [](const auto& k) { return k.laplace(); }},
        R"($\mathbf v_0\times\mathbf c_0-GM\,\mathbf R_0$)");
  claim("gamma0", 1241,
        R"($\mathbf c_0=r_0^2\dot\theta_0\,\mathbf k$, of length $\gamma_0=r_0^2|\dot\theta_0|$)",
        {R"($x\dot y-y\dot x$ later on the path, and its size)",
         [](const auto& k) { return values(k.h(), abs(k.h())); }},
        R"($(r_0^2\dot\theta_0,\ r_0^2|\dot\theta_0|)$)");
  claim.equation(
      "c1_vector", 1253,
      R"($\mathbf c_1=(r_0^3\dot\theta_0^2)\mathbf R_0-(r_0^2\dot r_0\dot\theta_0)\mathbf P_0-GM\,\mathbf R_0)"
      R"(=(r_0^3\dot\theta_0^2-GM)\mathbf R_0-(r_0^2\dot r_0\dot\theta_0)\mathbf P_0$)",
      {later, [](const auto& k) { return in_plane(k.laplace()[0], k.laplace()[1], 2); }});
  claim.equation("gamma1", 1259,
                 R"($\gamma_1=\sqrt{(r_0^3\dot\theta_0^2-GM)^2+(r_0^2\dot r_0\dot\theta_0)^2}$)",
                 {later, [](const auto& k) { return hypot(k.laplace()[0], k.laplace()[1]); }});
}

void polar_orbit(LaterTable& table, const std::vector<Later>& orbits) {
  const auto claim = table.over(orbits);
  claim(
      "e_and_rho", 1229,
      R"($e=\gamma_1/(GM)$, $\rho=\gamma_0^2/\gamma_1$ with the lengths $\gamma_0=|\mathbf c_0|$, $\gamma_1=|\mathbf c_1|$)",
      {"the apsides by the energy and the angular momentum later on the path",
       [](const auto& k) {
         const auto [nearest, farthest, half] = k.apsides();
         const auto e = (farthest - nearest) / (farthest + nearest);
         return values(e, 2 * nearest * farthest / (nearest + farthest) / e);
       }},
      R"($(\gamma_1/(GM),\ \gamma_0^2/\gamma_1)$)", R"($e$ and $p/e$, $p$ the semi-latus rectum)");
  claim(
      "orbit", 1229, R"(With $\theta$ from (7) the distance is $r=e\rho/(1+e\cos\theta)$.)",
      {.quantity = "$r$",
       .truth = {"$r$ later on a path by Newton's law", [](const auto& k) { return k.r(); }},
       .printed = R"($r=e\rho/(1+e\cos\theta)$)",
       .corrected = R"($r=e\rho/(1+e\cos(\theta-\omega))$)",
       .root = "angle from the axis for the angle from the perihelion",
       .why =
           R"(The polar equation measures the angle from the perihelion, the direction of the constant )"
           R"(vector $\mathbf c_1=\mathbf v\times\mathbf c_0-GM\,\mathbf R$, $\mathbf c_0=\mathbf r\times\mathbf v$; )"
           R"((7) measures it from the axis of $\theta_0$. Unless the perihelion is at $\theta=0$, in general )"
           R"($r(\theta_0)\ne r_0$. Either subtract $\omega=\arg\mathbf c_1$, or use $r=-GM/V(\theta)$.)"});
}

void period_and_axes(LaterTable& table, const std::vector<Later>& orbits) {
  const auto claim = table.over(orbits);
  const OfStart turn{R"(the integral of $r^2d\theta/(r_0^2|\dot\theta_0|)$ over a turn, by $c_0$ and $c_1$)",
                     [](const auto& k) { return k.turn(); }};
  claim.lost("period", 1267, R"($T=2\pi a^{3/2}\sqrt{GM}$, $2a$ being the length of the ellipse)", turn,
             R"($T=2\pi a^{3/2}/\sqrt{GM}$)",
             filled(R"(The fraction bar is lost: without it, $\sqrt{GM}$ is a factor. For the Earth, in )"
                    R"(astronomical units and years, the product is @3 years.)",
                    {2 * pi * sqrt(four_pi_squared)}));
  claim(
      "major_axis", 1269, R"(In $T$, $a$ is the length of the major axis.)",
      {.quantity = R"($T$, $2a$ being the length of the major axis)",
       .truth = turn,
       .printed = R"($2\pi(2a)^{3/2}/\sqrt{GM}$)",
       .meant = R"($2\pi a^{3/2}/\sqrt{GM}$)",
       .kind = Fault::term,
       .why = filled(
           R"(With the whole axis for $a$ the period is $2^{3/2}=@3$ times too long, the Earth's year @4 days. The )"
           R"(next sentence is right: the axis is $2a$, so that half of it was meant.)",
           {pow(2, 1.5), pow(2, 1.5) * days_per_year})});
  claim.equation("a", 1269, R"($2a=2\rho e/(1-e^2)$)",
                 {"the two apsides by the energy and the angular momentum later on the path",
                  [](const auto& k) { return 2 * k.apsides().half_axis; }});
  claim("b", 1269, R"(The length of the minor axis is $2b=2a\sqrt{1-e^2}$.)",
        {R"(the area law, $\pi ab=\tfrac12r^2\dot\theta\,T$ with the integral for $T$)",
         []<class T>(const LaterOf<T>& k) {
           return abs(k.h()) * k.turn() / (pi_of<T>() * k.apsides().half_axis);
         }},
        R"($2a\sqrt{1-e^2}$)");
}

/// An orbit, or a circle whose numbers are exact in binary.
struct OrCircle : Later {
  Tolerance tolerance(double size) const { return c0 == 0 && c1 == 0 ? exact() : Later::tolerance(size); }
};

void inputs_of_the_orbit(Claims& claims, const std::vector<Later>& orbits, double seed) {
  const auto speed = [](const AnyStart& k) { return pow(k.across, 2) + pow(k.along, 2); };
  const auto below = [=](double square) {
    return [=](const AnyStart& k) { return speed(k) >= square || Elements(k.start).e < 1; };
  };
  claims.statement<AnyStart>(
      "elliptical_path", 1229, "The path is an ellipse for the inputs that a user specifies.",
      starts(200, seed, 0.1, 2, 1),
      {.printed = {"$e<1$"},
       .corrected = {R"($\dot r_0^2+r_0^2\dot\theta_0^2<2GM/r_0$ has $e<1$)", below(2)},
       .in_view = {R"(for a planet that is slower than escape, as the Earth is)",
                   [=](const AnyStart& k) { return speed(k) < 2; }},
       .near_misses = {{R"($\dot r_0^2+r_0^2\dot\theta_0^2<2.5\,GM/r_0$ has $e<1$)", below(2.5)}},
       .root = "faster than escape",
       .why = filled(
           R"(Only below the speed of escape, $\dot r_0^2+r_0^2\dot\theta_0^2<2GM/r_0$, at the Earth's distance @2 )"
           R"(km/s. Above it $e\ge1$; then $a$ and $T$ of the last paragraph do not exist ($1-e^2\le0$), and )"
           R"($\theta$ tends to a limit.)",
           {sqrt(2) * earths_speed})});

  std::vector<OrCircle> all(orbits.begin(), orbits.end());
  all.push_back({{{2, 2, 4, 0, 0, 0.25}, {2, 2, 1, 0, 4, -1, 0, 0, 0}, 2 * pi, pi / 2, 0, 0}});
  claims.formula<OrCircle>(
      "rho_of_a_circle", 1229,
      R"($\rho=\gamma_0^2/\gamma_1$, of the lengths of $\mathbf c_0$ and $\mathbf c_1$, serves for the orbit of any start.)",
      all,
      {.quantity = "$r$",
       .truth = {"$r$ later on a path by Newton's law", &OrCircle::r},
       .printed = {R"($r=\frac{e(\gamma_0^2/\gamma_1)}{1+e\cos(\theta-\omega)}$)"},
       .corrected = {R"($r=\frac{\gamma_0^2/(GM)}{1+e\cos(\theta-\omega)}$)"},
       .in_view = {"for an ellipse that is no circle",
                   [](const Later& k) { return Elements(k.start).gamma1 > 0; }},
       .root = "a circle divides by zero",
       .why =
           R"(A circle ($\dot r_0=0$, $r_0^3\dot\theta_0^2=GM$) has $\gamma_1=0$: $\rho$ is a division by zero, and )"
           R"($e\rho$ is zero times infinity. For the simplest of all orbits a program gets no number for )"
           R"($r=e\rho/(1+e\cos\theta)$ and $2a=2\rho e/(1-e^2)$. Without $\rho$ it does: $e\rho=\gamma_0^2/(GM)$.)"});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const std::vector<Later> all = orbits(seed);
  std::vector<Moment> moments;
  std::vector<Pushed> pushed;
  for (const Later& k : all) {
    const auto& [G, M, m, x, y, vx, vy, push_x, push_y] = k.now;
    moments.push_back(k.now), pushed.push_back({G, M, m, x, y, vx, vy, push_x, push_y});
  }
  Claims claims("3.3");
  Table table(claims);
  PushedTable pushed_table(claims);
  SpaceTable in_space(claims);
  LaterTable later(claims);
  plane(in_space, draw<InSpaceOf<double>>(100, seed));
  motion_in_a_plane(claims, all, seed);
  polar_acceleration(pushed_table, pushed);
  for (auto* part : {equations_of_motion, equation_of_the_potential, moments_of_the_velocity})
    part(table, moments);
  singularity(claims, moments);
  for (auto* part : {time_by_angle, constants_of_motion, vectors, polar_orbit, period_and_axes})
    part(later, all);
  any_start(claims, seed);
  momentum(claims, all);
  inputs_of_the_orbit(claims, all, seed);
  solved_numerically(claims, seed);
  timing(claims, all);
  application(claims);
  return claims.in_order();
}

std::vector<Root> roots() {
  constexpr double degrees = 180 / pi, suns_kilograms = 1.32712440018e20 / 6.6743e-11,
                   square_meters_per_second = 149597870.7e3 * 1e3 * earths_speed;
  const auto turned = [&](const OneAngle<double>& model, double years) {
    return degrees *
           (ode::integrate<ode::Fehlberg78>(model, model.start(), 0, years, 1e-10).value[0] - model.p.theta0);
  };
  const OneAngle<double> right(near_earth), printed(near_earth, near_earth.mu() / near_earth.r0);
  const Elements drawn(eccentric);
  constexpr double early = 0.25;
  constexpr double fast = 45;
  const double e_of_fast = pow(fast / earths_speed, 2) - 1;
  Random random(1);
  return {
      {"the sun's mass for the planet's",
       filled(
           R"(A display shows the Earth's angular momentum as $@2\cdot10^{45}\,\mathrm{kg\,m^2/s}$, @6 times )"
           R"(too large; the orbit is right.)",
           {suns_kilograms * square_meters_per_second / 1e45, suns_per_earth})},
      {"sign of the potential at the start",
       filled(
           R"(The scene's planet slows down instead of going round. It has turned by $@2^\circ$ instead of )"
           R"($@2^\circ$ after @2 years, and by $@2^\circ$ after the year in which it should be back.)",
           {turned(printed, early), turned(right, early), early, turned(printed, 1)})},
      {"a start without angular momentum",
       filled(
           "A planet let go at rest at the Earth's distance, which should be in the sun after @2 days, is at "
           "NaN from the first frame.",
           {days_of_fall})},
      {"angle from the axis for the angle from the perihelion",
       filled(
           R"(The comet of `eccentric_path` is drawn @2 AU from the sun where the user put it at @3, on an )"
           R"(ellipse that is turned by $@2^\circ$.)",
           {drawn.as_printed(eccentric.theta0), eccentric.r0,
            degrees * abs(std::remainder(drawn.omega, 2 * pi))})},
      {"faster than escape",
       filled(
           R"(A body that leaves the Earth's place at @2 km/s, at right angles to the sun, never turns beyond )"
           R"($@3^\circ$ from its perihelion. Its period is the root of a negative number.)",
           {fast, degrees * acos(-1 / e_of_fast)})},
      {"a circle divides by zero",
       filled(R"(A planet at exactly its circular speed, @3 km/s at the Earth's distance, is drawn )"
              R"(nowhere: $0\cdot\infty$.)",
              {earths_speed})},
      {"any orbit for an eccentric one",
       filled(
           "With @3 steps a year the Earth comes round by (3.1) to within @2 millionths of its orbit after @2 "
           "years: no stability is missing there.",
           {Turned::steps, 1e6 * Turned(random, earths_eccentricity).direct, Turned::turns})}};
}

/// The complex roots of lambda^2 + 1 = 0.
const Lemma roots_of_minus_one{
    .name = "roots",
    .letters = "(a b : R)",
    .follows = {{R"(a * a - b * b + 1 = 0 /\ a * b + b * a = 0 <-> a = 0 /\ (b = 1 \/ b = -1))"}},
    .tactic = by_factors};

/// Proofs of the claims of these parts.
template <template <class> class Of, class... Parts>
Provables proofs_of(const ForAll<Of>& all, const Parts&... parts) {
  Claims claims("3.3");
  ProvableClaims<Of> table(claims);
  (parts(table, {}), ...);
  return table.proofs("3.3", all);
}

/// Proofs of a table's claims at any moment.
template <template <class> class Of, class... Parts>
Provables at_any_moment(const Parts&... parts) {
  auto all =
      for_all<Of>({"G", "M", "m", "x", "y", "vx", "vy", "px", "py"}, by_distance,
                  "it holds at any moment of any orbit", {0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25});
  const auto& k = all.any;
  all.given = positive({k.G, k.M, k.x * k.x + k.y * k.y});
  all.given.push_back(not_zero((k.x * k.vy - k.y * k.vx).expression()));
  all.preamble = coq_source({"root", "atan2"}), all.bounds = by_bounds;
  return proofs_of(all, parts...);
}

Provables proofs_at_a_moment() {
  Provables proved =
      at_any_moment<MomentOf>(equations_of_motion, equation_of_the_potential, moments_of_the_velocity);
  append(proved, at_any_moment<PushedOf>(polar_acceleration));
  Provable& characteristic = proof_of(proved, "3.3-characteristic");
  characteristic.says = "they are all its roots; by i, as a matrix, it holds at any moment of any orbit";
  characteristic.lemmas.push_back(roots_of_minus_one);
  return proved;
}

/// An ellipse with its start at theta = 0, a quarter of a turn later; the time is not used.
const Later quarter_of_a_turn{{2, 5, 1, 1, 0, 2}, {2, 5, 1, 0, 0.5, -4, -3, 0, 0}, 0, pi / 2, 5, 15};
/// This ellipse with its start at theta = pi/2, half a turn later.
const Later half_a_turn{{2, 5, 1, 1, pi / 2, 2}, {2, 5, 1, 0, -0.25, 8, 1, 0, 0}, 0, 3 * pi / 2, 15, -5};

/// Proofs on the path from any initial condition to any moment, at the angle `theta`; c0 and c1 are
/// determined by two other positions.
ForAll<LaterOf> on_any_path(const std::string& theta) {
  ForAll<LaterOf> all{.any = lettered<LaterOf>({"G", "M", "r0", "rd", "th0", "w0", "(x t)", "(y t)", "(u t)",
                                                "(v t)", "t", theta, "c0", "c1"}),
                      .letters = "(G M r0 rd th0 w0 t th c0 c1 t1 th1 t2 th2 : R) (x y u v : R -> R)",
                      .tactic = "by_start",
                      .says = "it holds on any path by Newton's law, c0 and c1 given by two other places",
                      .example = quarter_of_a_turn};
  auto& [start, now, t, angle, c0, c1] = all.any;
  now.G = start.G, now.M = start.M;
  all.given = positive({start.G, start.M, start.r0});
  const auto given = [&](Proposition p) { all.given.push_back(std::move(p)); };
  given(not_zero(start.theta0_dot.expression()));
  given({"newton (G * M) x y u v"});
  const auto q = start.position(), v = start.velocity();
  for (const auto& [at_start, x] :
       {std::pair{"(x 0)", q[0]}, {"(y 0)", q[1]}, {"(u 0)", v[0]}, {"(v 0)", v[1]}})
    given(Expression::letter(at_start) == x.expression());
  for (const std::string i : {"", "1", "2"}) given({"at_angle x y t" + i + " th" + i});
  given(not_zero(sin(Shortened::letter("(th1 - th2)")).expression()));
  for (const std::string i : {"1", "2"}) {
    const Shortened V = -start.mu() / Shortened::letter("(distance x y t" + i + ")");
    given((V + all.any.mean()).expression() == all.any.potential(Shortened::letter("th" + i)).expression());
  }
  return all;
}

Provables proofs_from_a_start() {
  ForAll<LaterOf> all = on_any_path("th");
  all.preamble = coq_source({"orbits"});
  ForAll<LaterOf> half = all;
  half.without = {"V0_put_in"}, half.example = half_a_turn;
  // as printed these are right a quarter of a turn later, and V0_put_in is right if r0 = 1
  all.without = {"c0", "constants_of_rate", "last_term_of_c1", "V0_put_in"};
  Provables proved = proofs_of(all, constants_of_motion, vectors),
            later = proofs_of(half, constants_of_motion);
  for (const char* claim : {"3.3-c0", "3.3-constants_of_rate", "3.3-last_term_of_c1"})
    proved.push_back(proof_of(later, claim));
  return proved;
}

/// For orbits that have a perihelion.
Provables proofs_of_the_orbit() {
  ForAll<LaterOf> all = on_any_path("th");
  for (const auto& x : positive({-all.any.start.energy(), Elements(all.any.start).gamma1}))
    all.given.push_back(x);
  all.tactic = "by_ellipse";
  all.says = "it holds on any ellipse by Newton's law that is no circle, c0 and c1 given by two other places";
  all.preamble = coq_source({"turns"}), all.bounds = "first [interval | integral]";
  return proofs_of(all, polar_orbit, period_and_axes);
}

/// The angle is a function of the time.
Provables proofs_of_the_time() {
  ForAll<LaterOf> all = on_any_path("(angle t)");
  all.letters += " (angle : R -> R)";
  all.given.push_back({"angle 0 = th0"});
  all.given.push_back({"(forall s, at_angle x y s (angle s) /\\ ex_derive angle s)"});
  all.tactic = "by_time";
  all.says += "; the angle is a differentiable function of the time";
  all.preamble = coq_source({"times"});
  return proofs_of(all, time_by_angle);
}

/// The printed formulas divide by zero.
Provables proofs_of_divisors() {
  const ForAll<LaterOf> all = on_any_path("th");
  const LaterOf<Shortened>& k = all.any;
  const Given<Shortened>& start = k.start;
  const Elements of(start);
  const std::string letters = "(G M r0 rd th0 w0 th : R)";
  const auto zero = [](const Shortened& x) { return x.expression() == 0; };
  const auto where = [&](std::vector<Proposition> more) {
    more.insert(more.begin(), all.given.begin(), all.given.begin() + 3);  // G, M and r0 are positive
    return more;
  };
  const auto circle = where({zero(start.r0_dot), of.squared.expression() == of.mu.expression()});
  const Shortened radius = of.gamma0 * of.gamma0 / of.mu / (1 + of.e * cos(k.theta));
  return {{"3.3-constants_of_any_start",
           "as corrected it holds for any start that turns; for one that does not, the printed formula "
           "divides by zero",
           {{"corrected",
             letters,
             where({not_zero(start.theta0_dot.expression())}),
             {zero(off_at_start(start, -1))},
             by_angles({"th0"}) + "; repeat split; lra"},
            {"printed_divides_by_zero",
             letters,
             where({zero(start.theta0_dot)}),
             {zero(OneAngle<Shortened>(start, -start.mu() / start.r0).alpha)},
             "rewrite H2; ring"}}},
          {"3.3-rho_of_a_circle",
           "as corrected it holds for any circle; the printed formula divides by zero",
           {{"corrected", letters, circle, {radius.expression() == start.r0.expression()}, by_circle},
            {"printed_divides_by_zero", letters, circle, {zero(of.gamma1)}, by_circle}}}};
}

Provables proof_of_plane() {
  return proofs_of(for_all<InSpaceOf>("set (r := sqrt _) in *; clearbody r; unfold Rdiv; ring",
                                      "under gravity the rate of the normal is zero at any place, with "
                                      "any velocity"),
                   plane);
}

Provables proofs() {
  Provables all;
  for (auto* part : {proofs_at_a_moment, proofs_from_a_start, proofs_of_the_orbit, proofs_of_the_time,
                     proofs_of_divisors, proof_of_plane})
    append(all, part());
  return all;
}

}  // namespace oddity::kepler
