#include "chapters/03_rigid_body_motion/21_pipe_and_disk/pipe_and_disk.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ex03_21 {

template <class T>
using Vector = std::array<T, 3>;

/// A rigid disk on a pipe, in any motion.
template <class T>
struct SampleOf {
  T m, L, mu2, mu3, phi, g;
  Two<T> q, v;  ///< (theta, psi) and their speeds
  Vector<T> F;

  SampleOf() = default;
  explicit SampleOf(Random& random) {
    for (const auto& letter : table())
      for (std::size_t i = 0; i < letter.count; ++i) letter.first[i] = letter.from.draw(random);
    mu3 *= mu2;
  }
  /// mu3 is drawn in parts of mu2: 2 for a flat disk, less for a longer one.
  Letters<T> table() {
    return {{"m", m, {0.2, 3}},
            {"L", L, {0.3, 3}},
            {R"(\mu_2)", mu2, {0.1, 2}},
            {R"(\mu_3)", mu3, {0.1, 2}},
            {R"(\phi)", phi, {0.2, 2.9}},
            {"g", g, {0.5, 20}},
            {R"(\theta)", q[0], {-3, 3}},
            {R"(\psi)", q[1], {-3, 3}},
            {R"(\dot\theta)", v[0], either_sign(0.1, 3), "omega"},
            {R"(\dot\psi)", v[1], either_sign(0.1, 3), "spin"},
            {"F", F, {-5, 5}, "f"}};
  }
  TypesetIn<T> typeset() const {
    const Two<T> a = accelerations(0, g);
    return {{"t", T(span)},
            {R"(\ddot\theta)", a[0]},
            {R"(\ddot\psi)", a[1]},
            {"u", axes(q[0], q[1])[2]},
            {R"(\dot u)", turning()},
            {R"(F_\theta)", force()},
            {R"(\imath)", {1, 0, 0}},
            {"k", {0, 0, 1}},
            {R"(\partial X/\partial\theta)", lever()}};
  }
  T inertia(const T& moment) const { return (m * L * L + moment) * sin(phi) * sin(phi); }
  double size() const {
    return 8 * (1 + m * L * (L + g) + mu2 + L * 5) * (1 + v[0] * v[0] + v[1] * v[1]) * (1 + 1 / inertia(mu2));
  }
  std::string where() const {
    return listed({{R"(\phi)", phi}, {R"(\theta)", q[0]}, {R"(\dot\theta)", v[0]}, {R"(\dot\psi)", v[1]}}, 4);
  }

  /// The disk's two diameters and the pipe's direction: the columns of R.
  template <class X>
  std::array<Vector<X>, 3> axes(const X& theta, const X& psi) const {
    const X c = cos(theta), s = sin(theta), a = cos(psi), b = sin(psi), C(cos(phi)), S(sin(phi));
    const Vector<X> down{c * C, s * C, -S}, side{-s, c, X(0.0)}, pipe{c * S, s * S, C};
    Vector<X> e, f;
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = a * down[i] + b * side[i];
      f[i] = a * side[i] - b * down[i];
    }
    return {e, f, pipe};
  }
  /// The Lagrangian, with `weight` as gravity per mass.
  auto lagrangian(const T& weight) const {
    return [*this, weight]<class X>(const Two<X>& at, const Two<X>& speed) {
      const auto r = axes(Dual<X>(at[0], speed[0]), Dual<X>(at[1], speed[1]));
      const T moments[] = {mu3 / 2, mu3 / 2, mu2 - mu3 / 2};
      X energy = X(0.0);
      for (std::size_t k = 0; k < 3; ++k)
        for (const Dual<X>& component : r[k]) {
          const X rate = component.slope;
          energy = energy + X(moments[k] / 2 + (k == 2 ? m * L * L / 2 : T(0))) * rate * rate;
        }
      return energy - X(m * weight * L) * r[2][2].value;
    };
  }
  /// Accelerations under gravity and a generalized force on theta.
  Two<T> accelerations(const T& force, const T& weight) const {
    return lagrange_accelerations(lagrangian(weight), q, v, {force, T(0)});
  }
  /// Rate of the pipe's direction at theta' = `speed`.
  Vector<T> turning(const T& speed) const {
    const auto pipe = axes(Dual<T>(q[0], speed), Dual<T>(q[1]))[2];
    return {pipe[0].slope, pipe[1].slope, pipe[2].slope};
  }
  Vector<T> turning() const { return turning(v[0]); }
  /// dX/dtheta of the center X.
  Vector<T> lever() const {
    const auto rate = turning(T(1));
    return {L * rate[0], L * rate[1], L * rate[2]};
  }
  T force() const { return dot(F, lever()); }
  static constexpr double span = 2;  ///< s
  /// (theta, psi, theta', psi') after the span, under gravity.
  std::array<double, 4> after_the_span() const {
    const auto rhs = [&](const std::array<double, 4>& x, std::array<double, 4>& dxdt, double) {
      SampleOf now = *this;
      now.q = {x[0], x[1]}, now.v = {x[2], x[3]};
      const Pair a = now.accelerations(0, g);
      dxdt = {x[2], x[3], a[0], a[1]};
    };
    return ode::integrate<ode::RungeKutta4>(rhs, std::array{q[0], q[1], v[0], v[1]}, 0, span, 0.05).value;
  }
};
using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;

using S = const Sample&;

/// The accelerations under gravity and a force of 0.1 on theta.
Pair with_force(S s) { return s.accelerations(0.1, s.g); }

/// Two accelerations that an upright pipe may have.
inline constexpr auto any_turn = []<class T>(const SampleOf<T>& up) { return Two<T>{up.F[0], -up.F[0]}; };

/// Left sides of Lagrange's equations for an upright pipe under gravity.
auto in_lagrange(const auto& accelerations) {
  return [=]<class T>(const SampleOf<T>& s) -> Two<T> {
    auto up = s;
    up.phi = 0.0;
    return lagrange_left_side(up.lagrangian(up.g), up.q, up.v, accelerations(up));
  };
}

void equations(Table& table, const std::vector<Sample>& samples) {
  const auto claim = table.over(samples);
  const std::string lagrange = "Lagrange's equations of the rigid disk, by nested dual numbers";

  claim("theta", 2559, R"(The pipe's acceleration is $\ddot\theta=F_\theta/((mL^2+\mu_2)\sin^2\phi)$)",
        {lagrange, [](const auto& s) { return s.accelerations(s.force(), 0)[0]; }},
        R"($F_\theta/((mL^2+\mu_2)\sin^2\phi)$)");
  claim("psi", 2561, R"(The disk's acceleration is $\ddot\psi=-F_\theta\cos\phi/((mL^2+\mu_2)\sin^2\phi)$)",
        {lagrange, [](const auto& s) { return s.accelerations(s.force(), 0)[1]; }},
        R"($-F_\theta\cos\phi/((mL^2+\mu_2)\sin^2\phi)$)");
  claim("force", 2569,
        R"(The generalized force on $\theta$ is $F\cdot L(-\sin\theta\sin\phi,\ \cos\theta\sin\phi,\ 0)$)",
        {R"($F\cdot\partial X/\partial\theta$ of the center $X$, by dual numbers)",
         [](const auto& s) { return s.force(); }},
        R"($F\cdot L(-\sin\theta\sin\phi,\ \cos\theta\sin\phi,\ 0)$)");
  claim("gravity_force", 2571, R"(Gravity has no generalized force on $\theta$: $F_\theta=0$ for all time)",
        {.quantity = R"($F_\theta$)",
         .truth = {"zero", []<class T>(const SampleOf<T>&) { return values(T(0)); }},
         .printed = R"($-mgk\cdot\partial X/\partial\theta$)",
         .near_misses = {R"($-mg\imath\cdot\partial X/\partial\theta$)"},
         .changes_that_hold = R"($k$ and $\partial X/\partial\theta$ are perpendicular)"});
  const std::string no_sign = "zero has no sign";
  claim("no_acceleration", 2573, R"(Gravity makes $\ddot\theta=0$ and $\ddot\psi=0$)",
        {.quantity = R"($(\ddot\theta,\ddot\psi)$)",
         .truth = {lagrange, [](const auto& s) { return s.accelerations(0, s.g); }},
         .printed = "$0$",
         .near_misses = {{R"(with a force of 0.1 on $\theta$)", with_force}},
         .changes_that_hold = no_sign});
  claim(
      "angular_accelerations", 2575,
      "Pipe and disk have no angular acceleration (our reading: the pipe about the vertical, the disk about the pipe)",
      {.quantity = R"($\ddot\theta$, $\ddot\psi$, and the component along the pipe of the rate of )"
                   R"($\dot\theta k+\dot\psi u$)",
       .truth = {"Lagrange's equations under gravity, and dual numbers",
                 [](const auto& s) {
                   const auto a = s.accelerations(0, s.g);
                   return values(a[0], a[1], s.v[1] * dot(s.turning(), s.axes(s.q[0], s.q[1])[2]));
                 }},
       .printed = "$0$",
       .near_misses = {{R"(the rate of the disk's whole angular velocity $\dot\theta k+\dot\psi u$)",
                        [](S s) {
                          const auto rate = s.turning();
                          return values(s.v[1] * rate[0], s.v[1] * rate[1], s.v[1] * rate[2]);
                        }}},
       .changes_that_hold = no_sign});
}

/// The quotients without a force; for an upright pipe they divide zero by zero.
Two<double> quotients(const Sample& s) {
  const double a = -s.m * s.g * s.lever()[2] / s.inertia(s.mu2);
  return {a, -a * cos(s.phi)};
}

void upright(Claims& claims, const std::vector<Sample>& samples) {
  const Formula<Sample> zero{"zero", [](S) { return values(0, 0); }};
  const auto reading = [&](std::string text, const auto& accelerations) -> Reading {
    const auto left = in_lagrange(accelerations);
    return {text,
            {compare<Sample>("Lagrange's left sides of an upright pipe under gravity",
                             {text, [=](S s) { return Value(left(s)); }}, zero, samples)}};
  };
  auto steep = usual;
  steep.phi = nearly_upright;
  const std::string quotient = R"($\ddot\theta=F_\theta/((mL^2+\mu_2)\sin^2\phi))";
  claims.add(
      "upright", 2559,
      quotient + R"($, and so without a force zero (our reading: for a pipe of any inclination))",
      {.printed = reading(quotient + R"($ at every $\phi$, 0 as well)", [](S up) { return quotients(up); }),
       .corrected = reading(quotient + R"($ where $\sin\phi\ne0$; for $\phi=0$ it is any number, and )"
                                       R"($\ddot\psi=-\ddot\theta$)",
                            any_turn),
       .in_view = {"for an inclined pipe",
                   {compare<Sample>(
                       R"($(\ddot\theta,\ddot\psi)$ under gravity)",
                       {"the quotients", [](S s) { return Value(quotients(s)); }},
                       {"Lagrange's equations", [](S s) { return Value(s.accelerations(0, s.g)); }},
                       samples)}},
       .near_misses = {reading(R"(upright $\ddot\theta$ is any number, and $\ddot\psi=0$)",
                               [](S up) {
                                 return Two<double>{up.F[0], 0};
                               })},
       .why = filled(
           R"(For an upright pipe the quotient is 0/0 without any force. Both angles turn the disk about the )"
           R"(same line then, and the equations fix their sum alone. At $\phi=@1$ the default disk has only @2 )"
           R"(kg m$^2$ under the bar, and a small force already makes large accelerations.)",
           {steep.phi, steep.inertia()}),
       .root = "division by an upright pipe"});
}

/// The disk's angular acceleration as a vector.
void turning_axis(Claims& claims, const std::vector<Sample>& samples) {
  claims.over(samples)(
      "disk_vector", 2575, "The angular acceleration of the disk (our reading: the vector) is zero",
      {.quantity = "the angular acceleration",
       .truth = {"zero", [](S) { return values(0); }},
       .printed = {R"($\frac d{dt}(\dot\theta k+\dot\psi u)=0$)"},
       .meant = {R"($(\ddot\theta,\ddot\psi)=(0,0)$)"},
       .near_misses = {{R"($(\ddot\theta,\ddot\psi)$ with a force of 0.1 on $\theta$)", with_force}},
       .changes_that_hold = R"($\ddot\theta$ and $\ddot\psi$ are both zero)",
       .kind = Fault::term,
       .why = filled(
           R"(The disk's angular velocity, $\dot\theta k+\dot\psi u$ with $u$ along the pipe, turns with the )"
           R"(pipe. Its rate is $\dot\theta\dot\psi\,k\times u$, of the size @3 rad/s$^2$ in the default )"
           R"(motion, and the bearings have to bring the torque for it.)",
           {usual.theta_dot * usual.psi_dot * std::sin(usual.phi)})});
}

/// Claims about motions under gravity that are integrated.
void motions(Claims& claims, const std::vector<Sample>& samples) {
  const auto claim = claims.over(samples);
  const auto later = [](std::size_t first) -> Formula<Sample> {
    return {"Lagrange's equations under gravity, integrated", [=](S s) {
              const auto x = s.after_the_span();
              return values(x[first], x[first + 1]);
            }};
  };
  claim("integrated", 2575, R"(Integrated, the equations give $\theta(t)=\theta_0$ and $\psi(t)=\psi(0)$)",
        {.quantity = filled(R"($(\theta,\psi)$ after $t=@1$ s)", {Sample::span}),
         .truth = later(0),
         .printed = {R"($(\theta,\psi)$)"},
         .meant = {R"($(\theta+\dot\theta t,\ \psi+\dot\psi t)$)"},
         .why = R"(The dots are lost: zero accelerations keep the speeds, $\dot\theta(t)=\dot\theta_0$ and )"
                R"($\dot\psi(t)=\dot\psi(0)$, as the next sentence states; the angles grow with time.)"});
  claim("constant_speeds", 2575, R"(The angular speeds $\dot\theta$ and $\dot\psi$ are constant)", later(2),
        {R"($(\dot\theta,\dot\psi)$)"}, filled(R"($(\dot\theta,\dot\psi)$ after @1 s)", {Sample::span}));
}

std::vector<Claim> claims(double seed) {
  Claims claims("3.21");
  Table table(claims);
  const auto samples = draw<Sample>(200, seed);
  equations(table, samples);
  upright(claims, samples);
  turning_axis(claims, samples);
  motions(claims, draw<Sample>(20, seed));
  return claims.in_order();
}

namespace {

/// The weight has no lever: the derivative of the center's height is zero.
Provable weightless(const SampleOf<Shortened>& s, const std::string& letters) {
  const auto pipe = s.axes(s.q[0], s.q[1])[2], lever = s.lever();
  const auto derivative = [](const Shortened& of, const Shortened& is) -> Proposition {
    return {"derivable_pt_lim (fun theta => " + of.expression().coq() + ") theta (" + is.expression().coq() +
            ")"};
  };
  std::vector<Proposition> all;
  for (std::size_t i = 0; i < 3; ++i) all.push_back(derivative(s.L * pipe[i], lever[i]));
  all.push_back(derivative(s.m * s.g * (s.L * pipe[2]), 0.0));
  return {
      "3.21-gravity_force",
      "the lever is the derivative of the center's place by theta, and that of the potential energy is zero",
      {{"printed", letters, {}, all, "apply is_derive_Reals; auto_derive; first [exact I | ring]"}},
      0,
      coq_source({"motions"})};
}

std::vector<Proposition> inclined(const SampleOf<Shortened>& s) {
  return positive({s.m, s.L, s.mu2, s.mu3, sin(s.phi)});
}

/// For all functions of time whose second derivatives satisfy Lagrange's equations.
Provables along_motions() {
  const std::vector<std::string> names{"m",       "L",         "mu2",      "mu3", "phi", "g", "(theta t)",
                                       "(psi t)", "(omega t)", "(spin t)", "f1",  "f2",  "f3"};
  const SampleOf<Shortened> s = lettered<SampleOf>(names);
  const Two<Shortened> a = s.accelerations(0.0, s.g);
  const std::vector<Proposition> given = inclined(s);
  const std::string equations =
      "(forall t, is_derive theta t (omega t) /\\ is_derive psi t (spin t) /\\\n    is_derive omega t (" +
      a[0].expression().coq() + ") /\\\n    is_derive spin t (" + a[1].expression().coq() + "))";
  std::vector<Proposition> moving = given;
  moving.push_back({equations});
  const std::string letters = "(m L mu2 mu3 phi g : R)", functions = "(theta psi omega spin : R -> R)";
  const auto constant = [&](const std::string& speed) -> Lemma {
    const Proposition stays{"(forall t, " + speed + " t = " + speed + " 0)"};
    return {speed, letters + " " + functions, moving, {stays}, "keeps_speed phi theta psi H4 t"};
  };
  const Proposition turns{"(exists " + functions + ",\n  " + equations +
                          " /\\ Rabs (theta 2 - theta 0) >= 2)"};
  const Lemma omega = constant("omega"), spin = constant("spin"),
              angle{"printed_differs", letters, given, {turns}, "turns_at_one phi"};
  const std::string under = "under gravity any motion of any disk on any inclined pipe keeps its speeds",
                    preamble = coq_source({"motions"});
  return {{"3.21-constant_speeds", under, {omega, spin}, 0, preamble},
          {"3.21-integrated",
           "as meant: " + under + "; as printed it is off after two seconds at a speed of one",
           {omega, spin, angle},
           2,
           preamble}};
}

}  // namespace

Provables proofs() {
  Claims claims("3.21");
  Table table(claims);
  equations(table, {});
  auto all = for_all<SampleOf>("on_pipe phi theta psi", "it holds for any disk on any inclined pipe");
  const auto& s = all.any;
  all.given = inclined(s);
  all.preamble = coq_source({"pipe"});
  Provables proved = table.proofs("3.21", all);
  const Expressions left = detail::recorded_value(in_lagrange(any_turn)(s));
  proved.push_back({"3.21-upright",
                    "as corrected it holds for any upright pipe",
                    {{"corrected", all.letters, {}, equal(left, {0.0, 0.0}), all.tactic}},
                    0,
                    all.preamble});
  append(proved, along_motions());
  proved.push_back(weightless(s, all.letters));
  return proved;
}

std::vector<Root> roots() {
  return {
      {"division by an upright pipe",
       filled("With the default disk's pipe upright, a program that divides gets NaN for both angles in its "
              "first step. The disk vanishes from the screen, where it should spin on at @3 rad/s.",
              {usual.psi_dot + usual.theta_dot})}};
}

}  // namespace oddity::ex03_21
