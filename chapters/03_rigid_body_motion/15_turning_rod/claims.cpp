#include "chapters/provable_claims.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/02_basic_concepts/shared/recorded_functions.hpp"
#include "chapters/03_rigid_body_motion/15_turning_rod/turning_rod.hpp"
#include "chapters/03_rigid_body_motion/shared/book_runge_kutta_4.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/events.hpp"

namespace oddity::ex03_15 {

namespace {

using namespace turning_rod;
using std::numbers::pi, std::numbers::sqrt2;
template <class T>
using SpaceOf = std::array<T, 3>;
using Space = SpaceOf<double>;

using std::abs;

constexpr double quarter = pi / 4;
const Rod<double> book{{1, 1, 10, quarter, 2}};

template <class T>
T length(const SpaceOf<T>& x) {
  return sqrt(dot(x, x));
}
template <class T>
SpaceOf<T> times(const std::type_identity_t<T>& factor, const SpaceOf<T>& x) {
  return {factor * x[0], factor * x[1], factor * x[2]};
}

/// The listing's motion with another initial condition and another spring.
AlongTheRod<double> along(double s, double m, double K, double w = quarter) {
  return {{{m, book.c, K, w, s}}};
}
double lambda_at_2(const auto& rod) {
  return ode::integrate<ode::Fehlberg78>(rod, rod.start(), 0, 2, 1e-9).value[0];
}
double lambda_at_2() { return lambda_at_2(along(book.s0, book.m, book.K)); }
/// The spring's length when the mass arrives.
double length_at_2() { return book.length(lambda_at_2(), 0.0); }
/// The first time at which lambda is an end of the segment.
double time_of(double end, double s, double K) {
  const auto rod = along(s, 1, K);
  const auto beyond = [=](const auto& x, double) { return x[0] - end; };
  return ode::find_event<ode::Fehlberg78>(rod, rod.start(), 0, 3, 1e-12, beyond).value.time;
}

/// The listing's mass on a spring that always pulls, with the same strength as the listing's, even if it is
/// short.
struct AlwaysPulls {
  std::array<double, 2> start() const { return {book.s0, 0}; }
  void operator()(const std::array<double, 2>& x, std::array<double, 2>& dxdt, double t) const {
    const double p = book.end_along(t), pull = book.pull * abs(1 - book.ell / book.length(x[0], p));
    dxdt = {x[1], book.w * book.w / 2 * x[0] - pull * (x[0] - p)};
  }
};
/// In mm, at the end.
double off_by_pulling() { return 1e3 * abs(lambda_at_2(AlwaysPulls{}) - lambda_at_2()); }

// ---- the Lagrangian ---------------------------------------------------------------------------------------

/// The rod's direction after a rotation by `angle`: Rodrigues' formula for (1, 0, 1)/sqrt(2) about k.
template <class T>
SpaceOf<T> direction(const T& angle) {
  const T h = sqrt(T(2)) / 2, none = T(0);
  const SpaceOf<T> d{h, none, h}, k{none, none, T(1)}, side = cross(k, d);
  const T c = cos(angle), s = sin(angle);
  const auto component = [&](std::size_t i) -> T {
    return d[i] * c + side[i] * s + k[i] * dot(k, d) * (1.0 - c);
  };
  return {component(0), component(1), component(2)};
}

template <class T, class Speed>
SpaceOf<T> position(const T& s, const T& t, const Speed& w) {
  const auto D = direction(T(w * t));
  return {s * D[0], s * D[1], s * D[2]};
}

/// The mass's velocity for s' = v, by dual numbers.
template <class T, class Speed>
SpaceOf<T> velocity(const T& s, const T& v, const T& t, const Speed& w) {
  const auto x = position(Dual<T>(s, v), Dual<T>(t, T(1.0)), w);
  return {x[0].slope, x[1].slope, x[2].slope};
}

/// Minus the gradient of the spring's energy, by dual numbers.
template <class T>
SpaceOf<T> force_of(const Rod<T>& spring, const SpaceOf<T>& x) {
  SpaceOf<T> f;
  for (std::size_t i = 0; i < 3; ++i) f[i] = -spring.energy(toward(x, i)).slope;
  return f;
}

}  // namespace

/// A rod to (a, 0, a), a spring of any rest length, a start at (b, 0, b), and a mass anywhere, with any s''.
template <class T>
struct SampleOf {
  T m, a, b, c, K, w, ell, s, v, A, t;
  Letters<T> table() {
    return {{"m", m, {0.1, 5}},
            {"a", a, {1, 5}},
            {"b", b, {0.1, 5}},
            {"c", c, {0.1, 5}},
            {"K", K, {0.1, 10}},
            {R"(\omega)", w, either_sign(0.1, 5), "w"},
            {R"(\ell)", ell, {0.1, 5}},
            {R"(\lambda)", s, {0.1, 7}, "s"},
            {R"(\dot\lambda)", v, either_sign(0.1, 5), "v"},
            {R"(\ddot\lambda)", A, either_sign(0.1, 5), "A"},
            {"t", t, {-5, 5}}};
  }
  std::string where() const { return listed({{"c", c}, {R"(\omega)", w}, {R"(\lambda)", s}, {"t", t}}, 4); }
  TypesetIn<T> typeset() const {
    return {{"x", x()},
            {R"(\dot x)", velocity()},
            {R"(\imath)", {1, 0, 0}},
            {"r", spring_length()},
            {"r_0", initial_length()},
            {"p", c * direction(T(w * t))[0]},
            {"F", F()},
            {R"(\mathbf F)", force_of(spring(ell), x())},
            {"L", length(segment())},
            {"D", {cos(w * t) / root2(), sin(w * t) / root2(), 1 / root2()}},
            {R"(\dot D)", {-w * sin(w * t) / root2(), w * cos(w * t) / root2(), 0}}};
  }
  static T number(double x) { return T(x); }
  static T pi() { return pi_of<T>(); }
  static T root2() { return sqrt(T(2)); }

  Rod<T> spring(const T& rest_length) const { return {{m, c, K, w, s}, rest_length}; }
  auto kinetic() const {
    return [m = m, w = w]<class X>(const X& at, const X& rate, const X& time) {
      const auto u = ex03_15::velocity(at, rate, time, w);
      return 0.5 * m * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    };
  }
  auto lagrangian() const {
    return [*this]<class X>(const X& at, const X& rate, const X& time) {
      return kinetic()(at, rate, time) - spring(ell).energy(position(at, time, w));
    };
  }
  SpaceOf<T> x() const { return position(s, t, w); }
  T spring_length() const { return length_at(s, t); }
  /// The distance from (c, 0, 0) to the mass at the start, by Rodrigues' rotation.
  T initial_length() const { return length_at(root2() * b, T(0)); }
  T length_at(const T& at, const T& time) const {
    auto x = position(at, time, w);
    x[0] -= c;
    return length(x);
  }
  SpaceOf<T> velocity() const { return ex03_15::velocity(s, v, t, w); }
  /// The text's initial condition: at rest on the segment.
  SpaceOf<T> start_velocity() const { return ex03_15::velocity(T(root2() * b), T(0), T(0), T(pi() / 4)); }
  SpaceOf<T> segment() const { return {a, T(0), a}; }
  /// The generalized force of the spring, by dual numbers.
  T F() const { return df_dq(lagrangian(), s, 0, t) - df_dq(kinetic(), s, 0, t); }
};

namespace {

using Sample = SampleOf<double>;
using Samples = std::vector<Sample>;
using Table = ProvableClaims<SampleOf>;

// ---- formulas ---------------------------------------------------------------------------------------------

const std::string dual = "dual numbers";

void geometry(Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  const std::string rodrigues = "Rodrigues' rotation about $k$";

  claim("angle", 1741, R"(The angle between the segment and the vertical axis is $\pi/4$)",
        {"that of $(a,0,a)$", [](const auto& s) { return acos(s.a / hypot(s.a, s.a)); }}, R"($\pi/4$)",
        "the angle between the segment and the axis");
  claim("initial_direction", 1741, R"(The initial direction of the segment is $D_0=(1,0,1)/\sqrt2$)",
        {"$(a,0,a)$ over its length",
         [](const auto& s) { return times(1 / length(s.segment()), s.segment()); }},
        R"($(1,0,1)/\sqrt2$)", "the initial direction");
  claim("towards", 1745,
        R"(The segment turns towards the $(x_2,x_3)$-plane (our check: after a quarter turn it is in it, )"
        R"(along $(0,1,1)/\sqrt2$))",
        {rodrigues, [](const auto& s) { return direction(s.pi() / 2); }}, R"($(0,1,1)/\sqrt2$)",
        "the direction after a quarter turn");
  claim("direction", 1747, R"($D(t)=(\cos\omega t,\sin\omega t,1)/\sqrt2$)",
        {rodrigues, [](const auto& s) { return direction(s.w * s.t); }},
        R"($(\cos\omega t,\sin\omega t,1)/\sqrt2$)");
  claim("lambda_start", 1755, R"($\lambda(0)=bL/a$ puts the mass at $x(0)=(b,0,b)$)",
        {R"($\lambda(0)D(0)$ with $L=|(a,0,a)|$ and $D$ by Rodrigues' rotation)",
         [](const auto& s) { return position(s.b * length(s.segment()) / s.a, s.number(0), s.w); }},
        "$(b,0,b)$", R"($x(0)$, with $\lambda(0)=bL/a$)");
  claim("velocity", 1765, R"(The velocity is $\dot x=\dot\lambda D+\lambda\dot D$)",
        {dual, [](const auto& s) { return s.velocity(); }}, R"($\dot\lambda D+\lambda\dot D$)",
        R"(the velocity $\dot x$)");
  claim.equation("direction_rate", 1767, R"($\dot D=\omega(-\sin\omega t,\cos\omega t,0)/\sqrt2$)",
                 {dual, [](const auto& s) { return velocity(s.number(1), s.number(0), s.t, s.w); }});
  claim("segment_length", 1919, R"($a=L/\sqrt2$, where $L$ is the length of the segment)",
        {"$a$", [](const auto& s) { return s.a; }}, R"($L/\sqrt2$)",
        "$a$, $L$ being the length of $(a,0,a)$");

  claim(
      "direction_again", 1845, R"(In the formula for $\dot\lambda(0)$ the direction $D(0)$ is $(a,0,a)$)",
      {.quantity = R"($D(0)$ in the formula for $\dot\lambda(0)$)",
       .truth = {rodrigues, [](const auto& s) { return direction(s.number(0)); }},
       .printed = "$(a,0,a)$",
       .meant = R"($(1,0,1)/\sqrt2$)",
       .kind = Fault::formula,
       .why = filled(
           R"($D$ is a unit vector (1741), and $(a,0,a)$ has the length $L$, @1 in the listing. For a mass )"
           R"(at rest it makes no difference; one thrown along the segment would have @1 times its speed.)",
           {2 * book.s0, 2 * book.s0})});
  claim(
      "starts_at_rest", 1843, R"(The mass has the initial velocity $\dot x(0)=(0,0,0)$)",
      {.quantity = R"($\dot x(0)$)",
       .truth = {dual, [](const auto& s) { return s.start_velocity(); }},
       .printed = "$(0,0,0)$",
       .corrected = R"($(0,\pi b/4,0)$)",
       .root = "at rest in space",
       .why = filled(
           R"(The segment turns from the start and takes the mass along: by the text's own formula (1765) )"
           R"($\dot x(0)=\lambda(0)\dot D(0)=(0,\pi b/4,0)$, @3 m/s in the listing. The mass is at rest on the )"
           R"(segment only, which is the meaning of $\dot\lambda(0)=0$.)",
           {quarter * book.s0 / sqrt2})});
  claim.equation("lambda_dot", 1843, R"($\dot\lambda=D\cdot\dot x$)",
                 {R"($\dot\lambda$ of the motion)", [](const auto& s) { return s.v; }});
  claim("lambda_dot_start", 1845, R"($\dot\lambda(0)=0$)",
        {R"($D(0)\cdot\dot x(0)$ of a mass at rest on the segment, by Rodrigues' rotation and dual numbers)",
         [](const auto& s) { return dot(direction(s.number(0)), s.start_velocity()); },
         [](const auto& s) { return s.pi() * s.b / 4; }},
        R"($(a,0,a)\cdot(0,0,0)$)", R"($\dot\lambda(0)$)");
}

void energies(Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  claim.equation(
      "kinetic_energy", 1787, R"($T=\frac m2(\omega^2\lambda^2/2+\dot\lambda^2)$)",
      {R"($\frac m2|\dot x|^2$ by dual numbers)", [](const auto& s) { return s.kinetic()(s.s, s.v, s.t); }});
  claim.equation("dT_dlambda", 1793, R"($\partial T/\partial\lambda=m\omega^2\lambda/2$)",
                 {dual, [](const auto& s) { return df_dq(s.kinetic(), s.s, s.v, s.t); }});
  claim.equation("dT_dlambdadot", 1799, R"($\partial T/\partial\dot\lambda=m\dot\lambda$)",
                 {dual, [](const auto& s) { return df_dv(s.kinetic(), s.s, s.v, s.t); }});
  claim.equation(
      "momentum_rate", 1803, R"($\frac{d}{dt}(\partial T/\partial\dot\lambda)=m\ddot\lambda$)",
      {"nested dual numbers", [](const auto& s) { return rate_of_df_dv(s.kinetic(), s.s, s.v, s.A, s.t); },
       [](const auto& s) { return s.m * abs(s.w) * (abs(s.v) + abs(s.w) * s.s); }});
}

void spring(Claims& claims, Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  const std::string right = R"($\sqrt{(b-c)^2+b^2}$)";
  const ProvableFormula<SampleOf> distance{
      R"(the distance from $(c,0,0)$ to the mass at $\lambda(0)=\sqrt2b$, by Rodrigues' rotation)",
      [](const auto& s) { return s.initial_length(); }};
  claim("rest_length", 1817, R"(The rest length is $\ell=\sqrt{(b-c)^2+b^2}$)", distance, right,
        R"(the rest length $\ell$)");
  claim("rest_length_again", 1869, R"(The summary has the rest length $\ell=\sqrt{(b-c)^2+c^2}$)",
        {.quantity = R"(the rest length $\ell$ in the summary)",
         .truth = distance,
         .printed = R"($\sqrt{(b-c)^2+c^2}$)",
         .meant = right,
         .kind = Fault::formula,
         .why = filled(
             "Line 1817 has " + right +
                 R"(, and the listing takes the distance itself. Whoever codes this )"
                 R"(summary starts with a stretched spring: the mass arrives at $\lambda(2)=@3$ for @3.)",
             {lambda_at_2(listed_with_other_rest_length<double>(book)), lambda_at_2()})});

  claim(
      "force", 1821, R"(The force of the spring is $-K(r-\ell)(x-c\imath)\,r$ with $r=|x-c\imath|$)",
      {.quantity = "the force of the spring",
       .truth = {"minus the gradient of the spring's energy, by dual numbers",
                 [](const auto& s) { return force_of(s.spring(s.ell), s.x()); }},
       .printed = R"($-K(r-\ell)(x-c\imath)\,r$)",
       .meant = R"($-K(r-\ell)(x-c\imath)/r$)",
       .why = filled(
           R"(The fraction bar is lost: $(x-c\imath)/|x-c\imath|$ is a direction. Multiplied by its length the )"
           R"(force is $r^2$ times as large, @3 times where the motion of the text ends, at $r=@4$.)",
           {length_at_2() * length_at_2(), length_at_2()})});
  claim(
      "unstretched", 1823,
      R"(At the start the spring is unstretched, and $\mathbf F(0)=0$ (our check: its length $r_0$ is $\ell$ then))",
      {"zero", []<class T>(const SampleOf<T>&) { return T(0); }},
      R"($K\left(r_0-\sqrt{(b-c)^2+b^2}\right)=0$)",
      R"($K(r_0-\ell)$, the strength of the force at the start)",
      "a factor of zero may have any size and sign");
  claims.statement<Sample>(
      "force_towards", 1819, "The force on the mass is towards $(c,0,0)$", samples,
      {.printed = {R"($\mathbf F\cdot(c\imath-x)>0$)"},
       .corrected = {R"($(r-\ell)\,\mathbf F\cdot(c\imath-x)>0$)"},
       .in_view = {"where the spring is stretched",
                   [](const Sample& s) { return s.spring_length() > s.ell; }},
       .near_misses = {{R"($(\ell-r)\,\mathbf F\cdot(c\imath-x)>0$)"}},
       .root = "a spring that always pulls",
       .why = filled(
           R"(A compressed spring pushes. It does so at the end of this very motion, where $r=@4$ is less )"
           R"(than $\ell=@4$. The formula (1821) is right. With a spring that always pulls the mass is @2 mm )"
           R"(off at $t=2$.)",
           {length_at_2(), book.ell, off_by_pulling()})});
}

void equations(Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  const std::string root = R"(\sqrt{\lambda^2-\sqrt2c\cos(\omega t)\lambda+c^2})",
                    arm = R"(\left(\lambda-\frac{c\cos(\omega t)}{\sqrt2}\right)$)";
  const std::string product = R"($-K\left(1-\ell)" + root + R"(\right))" + arm,
                    quotient = R"($-K\left(1-\frac\ell{)" + root + R"(}\right))";
  claim(
      "generalized_force", 1829, "The generalized force is " + product,
      {.quantity = "the generalized force",
       .truth = {R"(minus the derivative of the spring's energy by $\lambda$, by dual numbers)",
                 [](const auto& s) { return s.F(); }},
       .printed = product,
       .meant = quotient + arm,
       .why = filled(
           R"(The bar under $\ell$ is lost. At rest length the bracket is 0, and $1-\ell^2$ of the product: the )"
           R"(mass of the listing starts with a push of @2 N that is not there.)",
           {book.K * (book.ell * book.ell - 1) * (book.s0 - book.foot)})});
  claim("equation", 1839, R"(The equation of motion is $m\ddot\lambda-m\omega^2\lambda/2-F=0$)",
        {R"($\frac{d}{dt}\frac{\partial L}{\partial\dot\lambda}-\frac{\partial L}{\partial\lambda}$ )"
         R"(by nested dual numbers)",
         [](const auto& s) {
           return rate_of_df_dv(s.lagrangian(), s.s, s.v, s.A, s.t) - df_dq(s.lagrangian(), s.s, s.v, s.t);
         }},
        R"($m\ddot\lambda-m\omega^2\lambda/2-F$)", "the difference of the sides of the equation of motion");
  const auto summed_up = [](const std::string& bracket) {
    return R"($\ddot\lambda=\frac{\pi^2}{32}\lambda-\frac Km\left(1-)" + bracket +
           R"(\right)\left(\lambda-\cos(\pi t/4)\frac c{\sqrt2}\right)$)";
  };
  const std::string root_at_end = R"(\sqrt{\lambda^2-2\lambda\cos(\pi t/4)\frac c{\sqrt2}+c^2})",
                    as_product = summed_up(R"(\ell)" + root_at_end);
  claim(
      "summary", 1853, as_product,
      {.quantity = R"($\ddot\lambda$)",
       .truth = {R"(Lagrange's equation at $\omega=\pi/4$, by nested dual numbers)",
                 [](auto s) {
                   s.w = s.pi() / 4;
                   return lagrange_acceleration(s.lagrangian(), s.s, s.v, s.t);
                 }},
       .printed = as_product,
       .meant = summed_up(R"(\frac\ell{)" + root_at_end + "}"),
       .why =
           R"(The bar under $\ell$ is lost, as in the generalized force above. Besides, the $\sqrt2$ inside )"
           R"(the root is printed as the word sqrt.)"});

  claim(
      "listing_cosine", 2079,
      R"(`tmp0`, which is `aux[3]*Cos(aux[0]*time)`, `aux[0]` being $1/\sqrt2$, is the component of $c\imath$ along the )"
      R"(rod)",
      {.quantity = "`tmp0`",
       .truth = {R"($c\imath\cdot D$ with $\omega=\pi/4$, by Rodrigues' rotation)",
                 [](const auto& s) { return s.c * direction(s.pi() / 4 * s.t)[0]; }},
       .printed = R"($c\cos(t/\sqrt2)/\sqrt2$)",
       .corrected = R"($c\cos(\pi t/4)/\sqrt2$)",
       .kind = Fault::listing,
       .root = "`aux[0]` for `aux[1]`",
       .why = filled(
           R"(It should take `aux[1]`, which is $\pi/4$. In the code's equation of motion the spring sees the rod )"
           R"(turn by @2 degrees, while the positions that it prints turn by @2.)",
           {sqrt2 * 180 / pi, 2 * quarter * 180 / pi})});
  claim(
      "comment_root", 2093,
      R"(The comment on `tmp4` has $r^2=\lambda(\lambda-2p+c^2)$, $p=c\cos(\omega t)/\sqrt2$)",
      {.quantity = "$r^2$ in the comment on `tmp4`",
       .truth = {R"(the square of the distance from $(c,0,0)$ to $x$)",
                 [](const auto& s) { return s.spring_length() * s.spring_length(); }},
       .printed = R"($\lambda(\lambda-2p+c^2)$)",
       .meant = R"($\lambda(\lambda-2p)+c^2$)",
       .kind = Fault::formula,
       .why = filled(
           R"(A parenthesis closes too late: $r^2$ at the listing's start would be @3, not @3. The code below )"
           "is right.",
           {book.s0 * (book.s0 - 2 * book.foot + book.c * book.c), book.ell * book.ell})});
}

void formulas(Claims& claims, Table& table, const Samples& samples) {
  geometry(table, samples);
  energies(table, samples);
  spring(claims, table, samples);
  equations(table, samples);
}

// ---- the motion -------------------------------------------------------------------------------------------

/// Numbers of one motion, with the tolerance of those that they are compared with.
struct Output {
  TypesetLetters letters_of_text;
  Tolerance allowed;
  TypesetLetters typeset() const { return letters_of_text; }
  std::string where() const { return "in the book's motion"; }
  Tolerance tolerance(double) const { return allowed; }
};
Formula<Output> known(std::string by, Value value) {
  return {std::move(by), [value = std::move(value)](const Output&) { return value; }};
}

/// A start from rest at lambda = s on the segment of length 4, with a spring of stiffness K.
struct Launch {
  static constexpr double segment = 4;
  double s, K;

  double part() const { return s / segment; }
  std::string text() const {
    return R"(from $\lambda=)" + format_shortest(s) + "$ with $K=" + format_shortest(K) + "$";
  }
};
/// From the first the mass leaves over the upper end, from the second over the lower one.
constexpr Launch weak{3, 1}, stiff{1, 20};
/// Another initial lambda for the listing's parameters.
constexpr double other_start = 1;

/// Checks that the motion from lambda = s stays on the segment up to t = 2.
Check stays_on(const std::string& start, double s, double K, double w = quarter) {
  const auto rod = along(s, 1, K, w);
  const auto states =
      ode::integrate<ode::DormandPrince54>(rod, rod.start(), Horizon{2, 200}.times(), 1e-10).value;
  const auto off = [](const auto& x) { return !(0 <= x[0] && x[0] <= Launch::segment); };
  return no_violations(R"($0\le\lambda\le L$ )" + start, std::ranges::count_if(states, off),
                       static_cast<long>(states.size()));
}

Check stays_on(const Launch& launch) { return stays_on(launch.text(), launch.s, launch.K); }

/// Checks that the mass passes an end of the segment at the stated time.
Check passes(double end, const Launch& from, const std::string& time) {
  return as_written(R"(the time at which $\lambda=$ )" + format_shortest(end) + R"(, from $\lambda=$ )" +
                        format_shortest(from.s) + " with $K=$ " + format_shortest(from.K),
                    time, {"the equation of motion and its event", time_of(end, from.s, from.K)});
}

void motion(Claims& claims, const Value& end) {
  const Tolerance integrated{1e-10, "a hundred tolerances of the integration"};
  const CartesianWithConstraints<double> cartesian{book};

  const Check middle = stays_on("from the middle with $K=10$, as in the listing", 2, 10);
  claims.add(
      "on_the_segment", 1755, R"(The mass is on the segment: $0\le\lambda(t)\le L$)",
      {.printed = {"at any time, from any start", {middle, stays_on(weak), stays_on(stiff)}},
       .corrected = {"in the listing's motion; the equations themselves know no end of the segment",
                     {middle, passes(Launch::segment, weak, "1.700"), passes(0, stiff, "1.892")}},
       .in_view = {"in the listing's motion", {middle}},
       .near_misses = {{R"(at any speed, such as $1.5\sqrt{2K/m}$)",
                        {stays_on(R"(from the middle at $\omega=1.5\sqrt{2K/m}$)", 2, 10,
                                  1.5 * sqrt(20.0))}}},
       .why = filled(
           R"(Nothing in the equation of motion stops the mass at $0$ or at $L$. With the listing's $L=4$, )"
           R"($c=m=1$ a weak spring, $K=@1$, lets it slide off the upper end after @3 s when it starts at @2 of )"
           R"(the segment, and $\lambda(2)=@3$. A stiff one, $K=@2$, draws it through the lower end after @3 s )"
           R"(when it starts at @2 of the segment, and $\lambda(2)=@2$. A game has to look for both events.)",
           {weak.K, time_of(Launch::segment, weak.s, weak.K), weak.part(),
            lambda_at_2(along(weak.s, 1, weak.K)), stiff.K, time_of(0, stiff.s, stiff.K), stiff.part(),
            lambda_at_2(along(stiff.s, 1, stiff.K))}),
       .root = "a segment without ends"});

  const auto x1 = [](const auto& x, double) { return x[0]; };
  const double arrival =
      ode::find_event<ode::Fehlberg78>(cartesian, cartesian.start(), 0, 5, 1e-12, x1).value.time;
  claims.over(std::vector<Output>{{{{"t", arrival}}, integrated}})(
      "arrival_time", 1849, "The mass arrives in the $(x_2,x_3)$-plane at $t=2$",
      known("the Cartesian motion's first $x_1=0$", arrival), {"$2$"}, "the time of arrival");

  const auto by_fehlberg = [&](const std::string& text, double t) -> Reading {
    const auto state = ode::integrate<ode::Fehlberg78>(cartesian, cartesian.start(), 0, t, 1e-12).value;
    return {text,
            {{"$x(2)$",
              {"the Cartesian motion " + text, cartesian.observe(state, t)},
              {"table", end},
              integrated}}};
  };
  claims.add("by_numbers", 1847, "A numerical method gives the position at $t=2$",
             {.printed = by_fehlberg("by Fehlberg 7(8)", 2),
              .near_misses = {by_fehlberg("by Fehlberg 7(8), up to a step of the listing before", 1.99)}});

  claims.add("no_closed_form", 1847, "The equation has no solution in closed form",
             {.not_checkable = "numbers do not show that there is no formula"});
  claims.add("only_hope", 1847, "A numerical approach is the only hope",
             {.not_checkable = "numbers do not show that there is no other way"});

  // the segment's length only matters through the start b
  const auto same = [&](const std::string& text, const std::string& another, double b, double m,
                        double K) -> Reading {
    const auto end_of = [](double start, double mass, double stiffness) {
      const auto rod = along(sqrt2 * start, mass, stiffness);
      return ode::integrate<ode::Fehlberg78>(rod, rod.start(), 0, 2, 1e-14).value[0];
    };
    return {text,
            {{R"($\lambda(2)$, $c$ being 1 in both)",
              {R"($L=4$, $m=1$, $K=10$, $b=\sqrt2$)", end_of(book.s0 / sqrt2, 1, 10)},
              {another, end_of(b, m, K)},
              {1e-12, "a hundred tolerances of the integration"}}}};
  };
  const double half = book.s0 / sqrt2;
  claims.add(
      "parameters", 1867, "The parameters to select are $L$, $c$, $m$ and $K$",
      {.printed = same("$L$, $c$, $m$, $K$", R"($L=4$, $m=1$, $K=10$, $b=1/\sqrt2$)", half / 2, 1, 10),
       .corrected = same("$b$, $c$ and $K/m$", R"($L=8$, $m=3$, $K=30$, $b=\sqrt2$)", half, 3, 30),
       .in_view = {"where the start $b$ is the middle of the segment, as in the listing",
                   {{R"($\lambda(2)$)",
                     {"$L$, $c$, $m$ and $K$ of the listing", lambda_at_2()},
                     {"$|x(2)|$ of the table", length(Space{end[0], end[1], end[2]})},
                     {1e-8, "ten tolerances of the integration"}}}},
       .near_misses = {same("$b$, $c$ and $K$", R"($L=8$, $m=3$, $K=10$, $b=\sqrt2$)", half, 3, 10)},
       .why = filled(
           R"(The start $b$ is missing, on which $\lambda(0)=bL/a=\sqrt2\,b$ and $\ell$ depend. From @2 of )"
           R"(the segment instead of its middle, with the same $L$, $c$, $m$ and $K$, $\lambda(2)$ is @3 and )"
           R"(not @3. The length $L$ decides nothing else, and $m$ and $K$ only by $K/m$. The listing has $b$ )"
           R"(as the initial `lambda`.)",
           {other_start / Launch::segment, lambda_at_2(along(other_start, 1, book.K)), lambda_at_2()}),
       .root = "the start is no parameter"});
}

// ---- the listing and its output ---------------------------------------------------------------------------

struct Run {
  std::vector<double> lambda;
  double time = 0;
};

/// The listing's 200 steps.
Run listing(double factor) {
  const AsListed<double> rod{book, factor};
  auto state = rod.start();
  Run run{{state[0]}};
  for (int i = 0; i < 200; ++i) {
    listed_step(rod, state, run.time, 0.01);
    run.lambda.push_back(state[0]);
  }
  return run;
}

/// cos(x) near pi/2 as computed by FCOS: the distance from its own pi/2, which has 66 bits.
double fcos_near_half_pi(double x) { return 0x234Cp-67 - (x - pi / 2); }

void output(Claims& claims, const Value& end) {
  const Run run = listing(root_half<double>()), mended = listing(quarter);
  const double s = run.lambda.back(), angle = quarter * run.time;
  const auto listed = [](const Value& x) { return known("the listing's arithmetic", x); };
  const auto digits = [&](int decimals) -> std::vector<Output> {
    return {{{{"t", run.time}}, printed_decimals(decimals)}};
  };

  const auto middle = position(2.0, 0.0, quarter);
  claims.over(digits(5))(
      "first_line", 2177, R"(The output begins with $\lambda=2$, $x_1=x_3=1.41421$, $x_2=0$)",
      known("the middle of the segment of length 4", {4 / 2, middle[0], middle[1], middle[2]}),
      {"$(2,\\ 1.41421,\\ 0,\\ 1.41421)$"}, R"($(\lambda,x_1,x_2,x_3)$)");
  claims.over(digits(5))("listing_output", 2179, R"(The output ends with $\lambda=1.15214$)", listed(s),
                         {"$1.15214$"}, R"($\lambda$)");
  const double along_x3 = root_half<double>() * s;
  claims.over(digits(6))("listing_place", 2179, "The output ends with $x_2=x_3=0.814683$",
                         listed({along_x3 * std::sin(angle), along_x3}), {"$0.814683$"}, "$(x_2,x_3)$");
  claims.over(digits(21))(
      "listing_x1", 2179, R"(The output ends with $x_1=-8.54596\cdot10^{-16}$)",
      known(R"(the x87's FCOS, whose $\pi$ has 66 bits)", along_x3 * fcos_near_half_pi(angle)),
      {R"($-8.54596\cdot10^{-16}$)"}, "$x_1$");

  const auto x1_after = [&](const std::string& text, int steps) -> Reading {
    return {text,
            {{"$x_1$ after step " + std::to_string(steps),
              {"the listing", root_half<double>() * s * cos(angle * steps / 200)},
              {"zero", 0.0},
              {200 * 0x1p-53 * 2, "the rounding of a clock that adds 200 steps"},
              1}}};
  };
  claims.add("in_the_plane", 2181, "At the end $x_1$ is effectively zero",
             {.printed = x1_after("zero except for the clock's rounding", 200),
              .near_misses = {x1_after("effectively zero one step before", 199)}});

  const auto starts_at = [](const std::string& text, double t) -> Reading {
    return {text,
            {{"the position after `Initialize(1, 0.01, 2, 0)`",
              {R"($\lambda=2$ at $t=1$)", book.place(2, 1)},
              {R"($\lambda=2$ at the clock's time)", position(2.0, t, quarter)},
              rounding(2)}}};
  };
  claims.add(
      "initial_time", 1995, "`Initialize(time, ...)` starts the clock at the time that it is given",
      {.printed = starts_at("`mTime = 0.0`", 0),
       .corrected = starts_at("`mTime = time`", 1),
       .near_misses = {starts_at("`mTime = deltaTime`", 0.01)},
       .why = filled(
           R"(The argument `time` is not used; the main program passes 0. Whoever resumes a saved motion at )"
           R"($t=1$ finds the segment turned back by $@2^\circ$, and the mass at $\lambda=2$ is @3 m from its )"
           R"(place. With `mTime = time` the rest length must be kept as well: `mAux[6]` takes the spring's )"
           R"(length at that moment, @3 for @3.)",
           {quarter * 180 / pi, 2 * sqrt2 * std::sin(quarter / 2), book.length(2.0, book.end_along(1.0)),
            book.ell}),
       .kind = Fault::listing,
       .root = "a clock set to zero"});

  const double lambda = length(Space{end[0], end[1], end[2]}), d = end[1];
  claims.over(digits(5))(
      "lambda_value", 2179, R"($\lambda(2)=1.15214$)",
      {.quantity = R"($\lambda(2)$)",
       .truth = known("$|x(2)|$ of the table", lambda),
       .other_routes = {known("the listing with `aux[1]`", mended.lambda.back())},
       .printed = {"$1.15214$"},
       .corrected = {"$0.99421$"},
       .kind = Fault::listing,
       .root = "`aux[0]` for `aux[1]`",
       .why = filled(
           R"(The output belongs to the slip of the listing (2079), not to the equation of the text, whose )"
           R"($\lambda(2)$ is @6: the printed number is @2 percent too large.)",
           {lambda, 100 * (1.15214 / lambda - 1)})});
  claims.over(digits(6))(
      "d_value", 2181, "The value to compute is $d=0.814683$: the mass arrives at $(0,d,d)$",
      {.quantity = "$d$",
       .truth = known("$x_2(2)$ of the table", d),
       .printed = {"$0.814683$"},
       .corrected = {"$0.703013$"},
       .kind = Fault::listing,
       .root = "`aux[0]` for `aux[1]`",
       .why = filled(
           "It comes from the slip of the listing (2079). The mass arrives at $(0,d,d)$ with $d=@6$, @2 m "
           "nearer to the origin along the segment.",
           {d, sqrt2 * (0.814683 - d)})});
  claims.over(std::vector<Output>{{{{R"(\lambda(2))", lambda}}, rounding(1)}})(
      "d_is_lambda", 1849, R"(The number to solve for is $d=\lambda(2)$)",
      {.quantity = "$d$",
       .truth = known("$x_2(2)$ of the table", d),
       .printed = {R"($d=\lambda(2)$)"},
       .meant = {R"($d=\lambda(2)/\sqrt2$)"},
       .kind = Fault::formula,
       .why = filled(
           R"($\lambda$ is a distance along the segment and $d$ a coordinate: the output has @6 and @6. Taken at )"
           R"(its word it places the mass @2 m too far along the segment. The summary repeats it (1869).)",
           {s, along_x3, sqrt2 * lambda - lambda})});

  std::vector<Output> ends;
  for (const double by : {s, mended.lambda.back(), lambda})
    ends.push_back({{{R"(\lambda(0))", book.s0}, {R"(\lambda(2))", by}}, {}});
  claims.statement<Output>(
      "slipped", 2181,
      R"($\lambda$ has decreased: the mass has slipped down the segment (our check: by the listing, by the mended one, )"
      R"(by the table))",
      ends, {.printed = {R"($\lambda(2)<\lambda(0)$)"}, .near_misses = {{R"($\lambda(2)<\lambda(0)/2$)"}}});
}

}  // namespace

std::vector<Claim> claims(double seed, const Reference& truth) {
  Claims claims("3.15");
  Table table(claims);
  const Value end = truth("03_15_slide", {book.m, book.c, book.K, book.w, book.s0, 2}).value;
  formulas(claims, table, draw<Sample>(200, seed));
  motion(claims, end);
  output(claims, end);
  return claims.in_order();
}

std::vector<Root> roots() {
  constexpr double frames = 60;
  const auto [lambdas, last_time] = listing(root_half<double>());
  const double by_listing = lambdas.back();
  return {
      {"`aux[0]` for `aux[1]`",
       filled(
           "The listing puts the mass @2 cm too far out on the segment after @1 s, at @4 m instead of @3 m.",
           {100 * (by_listing - lambda_at_2()), last_time, by_listing, lambda_at_2()})},
      {"at rest in space",
       filled(
           "A mass started at rest in space is @2 cm off the segment after the first of @2 frames a second: the "
           "segment leaves it at @3 m/s.",
           {100 * quarter * book.s0 / sqrt2 / frames, frames, quarter * book.s0 / sqrt2})},
      {"a spring that always pulls",
       filled("A spring that pulls where it is compressed has the mass @2 mm off at the end of the motion.",
              {off_by_pulling()})},
      {"a segment without ends",
       filled(
           "On a spring of @1 N/m, started at @2 of the segment, the mass leaves its upper end after @3 s. "
           "At the end of the motion it is drawn @2 m beyond the segment.",
           {weak.K, weak.part(), time_of(Launch::segment, weak.s, weak.K),
            lambda_at_2(along(weak.s, 1, weak.K)) - Launch::segment})},
      {"the start is no parameter",
       filled(
           "Started at @2 of the segment instead of its middle, all parameters named being the same, the mass "
           "arrives at @3 m for @3 m.",
           {other_start / Launch::segment, lambda_at_2(along(other_start, 1, book.K)), lambda_at_2()})},
      {"a clock set to zero",
       filled(
           R"(Whoever loads a motion saved at $t=1$ and $\lambda=2$ sees the mass jump by @3 m, as the segment is turned )"
           R"(back by $@2^\circ$.)",
           {2 * sqrt2 * std::sin(quarter / 2), quarter * 180 / pi})}};
}

Provables proofs() {
  Claims claims("3.15");
  Table table(claims);
  formulas(claims, table, {});
  auto all = for_all<SampleOf>("by_rod a b c w s t", "it holds for any mass on the rod and any spring",
                               {0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3});
  all.given = positive({all.any.m, all.any.a, all.any.b, all.any.c});
  all.preamble = coq_source({"rod"});
  Provables proved = table.proofs("3.15", all);
  for (const auto& [claim, tactic] : {std::pair{"3.15-angle", "by_half_right_angle a"},
                                      {"3.15-rest_length", "by_start"},
                                      {"3.15-rest_length_again", "by_start"},
                                      {"3.15-unstretched", "by_rest"},
                                      {"3.15-summary", "by_rate c s t"}})
    proof_of(proved, claim).lemmas.at(0).tactic = tactic;
  return proved;
}

}  // namespace oddity::ex03_15
