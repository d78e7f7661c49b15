// The claims of exercise 3.11. The text's equations are compared with Lagrange's, the Lagrangian
// differentiated by nested dual numbers from the hill's height alone; its statements about paths are tried on
// integrated motions.

#include "chapters/provable_claims.hpp"

#include <cmath>

#include "chapters/03_rigid_body_motion/11_paraboloid_hill/paraboloid_hill.hpp"
#include "chapters/03_rigid_body_motion/shared/height_field.hpp"
#include "reference/text.hpp"

namespace oddity::ex03_11 {

using namespace paraboloid_hill;
using std::abs;

// ---- the equations ----------------------------------------------------------------------------------------

/// A hill, a place, a velocity, an acceleration, and a time.
template <class T>
struct SampleOf {
  Hill<T> hill;
  T g, t;
  Two<T> x, v, a;

  SampleOf() = default;
  explicit SampleOf(Random& random)
      : hill{random.between(0.5, 3), random.between(0.5, 3)},
        g(random.between(0.5, 20)),
        t(random.magnitude(0.1, 3)),
        x{random.magnitude(0.1, 3), random.magnitude(0.1, 3)},
        v{random.magnitude(0.1, 3), random.magnitude(0.1, 3)},
        a{random.magnitude(0.1, 3), random.magnitude(0.1, 3)} {}
  std::array<T*, 10> letters() {
    return {&hill.a1, &hill.a2, &g, &t, &x[0], &x[1], &v[0], &v[1], &a[0], &a[1]};
  }
  std::string where() const {
    return "$a$ = (" + format_significant(hill.a1, 4) + ", " + format_significant(hill.a2, 4) + "), $v$ = (" +
           format_significant(v[0], 4) + ", " + format_significant(v[1], 4) +
           "), $t$ = " + format_significant(t, 4);
  }
  TypesetLetters typeset() const {
    return {{"a_1", hill.a1},
            {"a_2", hill.a2},
            {"g", g},
            {"t", t},
            {"x_1", x[0]},
            {"v_1", v[0]},
            {"v_2", v[1]},
            {R"(\ddot x_1)", a[0]},
            {"B", (x[0] * a[0] + v[0] * v[0]) / A1() + (x[1] * a[1] + v[1] * v[1]) / A2()}};
  }
  T A1() const { return hill.a1 * hill.a1; }
  T A2() const { return hill.a2 * hill.a2; }
  T K() const { return v[0] * v[0] / A1() + v[1] * v[1] / A2(); }
  /// Zero by Lagrange's equations.
  Two<T> lagrange(const Two<T>& at, const Two<T>& acceleration) const {
    return lagrange_left_side(height_field::Lagrangian<Hill<T>, T>{hill, g}, at, v, acceleration);
  }
  Two<T> on_line() const { return lagrange({v[0] * t, v[1] * t}, {T(0), T(0)}); }
  /// The velocity along v with which the line is straight.
  Two<T> right() const { return from_the_top<T>({hill.a1, hill.a2, g, v[0], v[1], T(1)}).v; }
};
using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;

void equations(Table& table, const std::vector<Sample>& samples) {
  table.formula(
      "derivatives", 1543, "the first two derivatives of $(v_1t,v_2t)$", samples,
      {.truth = {"dual numbers",
                 [](const auto& s) {
                   const auto x = [&](std::size_t i) {
                     return [&s, i](const auto& t) { return s.v[i] * t; };
                   };
                   return values(derivative(x(0), s.t), derivative(x(1), s.t), second_derivative(x(0), s.t),
                                 second_derivative(x(1), s.t));
                 }},
       .printed = {"$(v_1,v_2)$ and $(0,0)$", [](const auto& s) { return values(s.v[0], s.v[1], 0, 0); }},
       .near_misses = {{"$(v_1t,v_2t)$ and $(v_1,v_2)$",
                        [](const auto& s) { return values(s.v[0] * s.t, s.v[1] * s.t, s.v[0], s.v[1]); }}}});

  const std::string lagrange =
      R"($\frac d{dt}\frac{\partial L}{\partial\dot x_1}-\frac{\partial L}{\partial x_1}$ )"
      "by nested dual numbers";
  /// `power` of a1 below 4 x1; `squares` of the speeds in the bracket.
  const auto equation = [](std::string text, double sign, int power,
                           double squares) -> ProvableFormula<SampleOf> {
    return {std::move(text), [=](const auto& s) {
              return s.a[0] +
                     sign * 4 * s.x[0] / (power == 1 ? s.hill.a1 : s.A1()) *
                         ((s.x[0] * s.a[0] + squares * s.v[0] * s.v[0]) / s.A1() +
                          (s.x[1] * s.a[1] + squares * s.v[1] * s.v[1]) / s.A2()) -
                     2 * s.g * s.x[0] / s.A1();
            }};
  };
  table.formula(
      "first_equation", 1545,
      R"(the first equation of motion, $B$ being )"
      R"($\frac{x_1\ddot x_1+\dot x_1^2}{a_1^2}+\frac{x_2\ddot x_2+\dot x_2^2}{a_2^2}$)",
      samples,
      {.quantity = "what is zero by the first equation of motion",
       .truth = {lagrange, [](const auto& s) { return s.lagrange(s.x, s.a)[0]; }},
       .printed = equation(R"($0=\ddot x_1+\frac{4x_1}{a_1}B-\frac{2gx_1}{a_1^2}$)", 1, 1, 1),
       .meant = equation(R"($0=\ddot x_1+\frac{4x_1}{a_1^2}B-\frac{2gx_1}{a_1^2}$)", 1, 2, 1),
       .near_misses = {equation(R"($0=\ddot x_1-\frac{4x_1}{a_1^2}B-\frac{2gx_1}{a_1^2}$)", -1, 2, 1),
                       equation("without the squares of the speeds", 1, 2, 0)},
       .kind = Fault::formula,
       .why =
           R"(The factor before the bracket is $4x_1/a_1^2$, as the next line has it; with the hill )"
           R"($x_3=-x_1^2/a_1^2-x_2^2/a_2^2$ this is Lagrange's equation to the last digit. On a hill with )"
           R"($a_1=2$ the printed factor is twice too large.)"});

  const auto on_line = [](std::string text, double gravity) -> ProvableFormula<SampleOf> {
    return {std::move(text), [=](const auto& s) {
              return 4 * s.v[0] * s.t / s.A1() * s.K() - gravity * s.g * s.v[0] * s.t / s.A1();
            }};
  };
  table.formula(
      "substituted", 1563, "the first equation on $(v_1t,v_2t)$", samples,
      {.quantity = "what is zero by the first equation on $(v_1t,v_2t)$",
       .truth = {lagrange, [](const auto& s) { return s.on_line()[0]; }},
       .printed = {R"($0=0+4v_1t\,a_1^2(v_1^2a_1^2+v_2^2a_2^2)-2gv_1t/a_1^2$, as products)",
                   [](const auto& s) {
                     return 4 * s.v[0] * s.t * s.A1() *
                                (s.v[0] * s.v[0] * s.A1() + s.v[1] * s.v[1] * s.A2()) -
                            2 * s.g * s.v[0] * s.t / s.A1();
                   }},
       .meant = on_line(
           R"($0=0+\frac{4v_1t}{a_1^2}\Big(\frac{v_1^2}{a_1^2}+\frac{v_2^2}{a_2^2}\Big)-\frac{2gv_1t}{a_1^2}$)",
           2),
       .near_misses = {on_line("$g$ for $2g$ in the last term", 1), on_line("plus the last term", -2)},
       .kind = Fault::lost_typography,
       .why =
           R"(The bars of the first term's three fractions are lost in the text at hand; the last term has its )"
           R"(own. As products the terms cannot be added: on a hill twice as wide, $a_1$ and $a_2$ doubled, )"
           R"(the first one should shrink to a sixteenth, and grows sixteenfold.)"});
}

// ---- what follows from them -------------------------------------------------------------------------------

/// Starts from the top: any direction, along either axis, or at rest; at the condition or off it.
struct FromTop : Sample {
  explicit FromTop(Random& random) : Sample(random) {
    const int kind = random.below(4);
    if (kind == 1 || kind == 3) v[0] = 0;
    if (kind == 2 || kind == 3) v[1] = 0;
    if (kind == 0 && random.unit() < 0.5) v = right();
  }
  /// Whether this is g/2.
  bool is_half_g(double left) const { return abs(left - g / 2) <= rounding(left + g / 2).allowed; }
  bool condition() const { return is_half_g(K()); }
  /// Whether (v1 t, v2 t) satisfies equation i.
  bool satisfied(std::size_t i) const {
    const auto left = [&](const std::array<double, 6>& letters) {
      FromTop moved = *this;
      const auto [a1, a2, gravity, time, v1, v2] = letters;
      moved.hill = {a1, a2}, moved.g = gravity, moved.t = time, moved.v = {v1, v2};
      return Value(moved.on_line()[i]);
    };
    const std::array letters{hill.a1, hill.a2, g, t, v[0], v[1]};
    return size_of(left(letters)) <= rounding(size_of_terms(left, letters)).allowed;
  }
  bool both() const { return satisfied(0) && satisfied(1); }
};

/// Pushed by the hill on (v1 t, v2 t) at the right speed, and flying off at a higher one.
struct Free : Sample {
  Free(const Sample& sample, double by) : Sample(sample), faster(by) {}
  double faster;
  double size() const { return g; }
  double push() const {
    const Pair u = right();
    return g + second_derivative([&](const auto& s) { return hill.height(u[0] * s, u[1] * s); }, t);
  }
  bool above() const {
    const Pair u = right();
    return -g * t * t / 2 > hill.height(faster * u[0] * t, faster * u[1] * t);
  }
};

void conditions(Claims& claims, double seed) {
  const auto samples = draw<FromTop>(400, seed);
  const std::string half = R"($v_1^2/a_1^2+v_2^2/a_2^2=g/2$)";
  claims.statement<FromTop>(
      "condition", 1573, R"(the first equation holds for $v_1\ne0$ exactly at a condition)", samples,
      {.printed = {R"($v_1^2a_1^2+v_2^2a_2^2=g/2$, as products)",
                   [](const FromTop& s) {
                     const double a = s.hill.a1 * s.v[0], b = s.hill.a2 * s.v[1];
                     return s.v[0] == 0 || s.satisfied(0) == s.is_half_g(a * a + b * b);
                   }},
       .meant = {half + " and nowhere else",
                 [](const FromTop& s) { return s.v[0] == 0 || s.satisfied(0) == s.condition(); }},
       .near_misses = {{half + " for $v_1=0$ as well",
                        [](const FromTop& s) { return !s.satisfied(0) || s.condition(); }}},
       .kind = Fault::lost_typography,
       .why =
           R"(The bars of the two fractions are lost in the text at hand. On the default hill, $a_1=1$, )"
           R"($a_2=2$, $g=10$, the condition is 2 m/s in each direction for $v_1=v_2$, and with the products )"
           R"(1 m/s, at which the particle does not keep to a uniform motion.)"});
  claims.statement<FromTop>(
      "second_equation", 1581, R"(the second equation gives the same condition for $v_2\ne0$)", samples,
      {.printed = {half + " and nowhere else",
                   [](const FromTop& s) { return s.v[1] == 0 || s.satisfied(1) == s.condition(); }},
       .near_misses = {{half + " for $v_2=0$ as well",
                        [](const FromTop& s) { return !s.satisfied(1) || s.condition(); }}}});

  std::vector<Free> falls;
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const Sample s(random);
    falls.emplace_back(s, random.between(1.01, 2));
  }
  const auto in_starts = [&](std::string text, const std::function<bool(const FromTop&)>& holds) -> Reading {
    return {text, {in_all(text, samples, holds)}};
  };
  Reading or_at_rest =
      in_starts("exactly if " + half + ", or if the particle is at rest on the top",
                [](const FromTop& s) { return s.both() == (s.condition() || (s.v[0] == 0 && s.v[1] == 0)); });
  or_at_rest.checks.push_back(compare<Free>("the hill's vertical force over the mass on $(v_1t,v_2t)$",
                                            {R"($g+\ddot x_3$ by dual numbers)", &Free::push},
                                            {"none", [](const Free&) { return 0.0; }}, falls));
  or_at_rest.checks.push_back(in_all<Free>("a faster particle flies above the hill", falls, &Free::above));
  claims.add(
      "only_way", 1581, "when $(v_1t,v_2t)$ is a solution",
      {.printed = in_starts("only if " + half, [](const FromTop& s) { return !s.both() || s.condition(); }),
       .corrected = or_at_rest,
       .near_misses = {in_starts(
           "exactly if " + half + ", or if $v_1=0$",
           [](const FromTop& s) { return s.both() == (s.condition() || s.v[0] == 0); })},
       .why =
           R"(The algebra divides by $v_1t$ and by $v_2t$. With $v_1=0$ the first equation reads $0=0$, and the )"
           R"(second decides; with $v_1=v_2=0$ neither does. All other motions $(v_1t,v_2t)$ need the )"
           R"(condition, and they are free falls: the hill does not push. A faster particle flies off, over )"
           R"(the same line and as uniformly. A game that keeps it on the hill by these equations has to pull )"
           R"(it down: at twice the speed, on the top, with three times its weight.)",
       .kind = Fault::left_out,
       .root = "a particle at rest"});
}

// ---- straight paths ---------------------------------------------------------------------------------------

/// A path from the top: how far it strays from the line of its first velocity, over its length.
struct Path {
  Hill<double> hill;
  double g;
  Pair v;
  bool condition, axis;
  double stray;

  Path(const Sample& s, const Pair& start, bool right_speed)
      : hill(s.hill), g(s.g), v(start), condition(right_speed), axis(v[0] == 0 || v[1] == 0), stray(0) {
    const auto path = ode::integrate<ode::Fehlberg78>(in_plane<double>({hill, g, {0, 0}, v}),
                                                      std::array{0.0, 0.0, v[0], v[1]}, 0, 2, 1e-12);
    const auto& x = path.value;
    stray = path.reached()
                ? abs(x[0] * v[1] - x[1] * v[0]) / (std::hypot(x[0], x[1]) * std::hypot(v[0], v[1]))
                : std::numeric_limits<double>::quiet_NaN();
  }
  std::string where() const {
    return "$a$ = (" + format_significant(hill.a1, 4) + ", " + format_significant(hill.a2, 4) + "), $v$ = (" +
           format_significant(v[0], 4) + ", " + format_significant(v[1], 4) + ")";
  }
  bool round() const { return hill.a1 == hill.a2; }
  bool is(bool straight) const { return straight ? stray < 1e-9 : stray > 1e-6; }
};

void paths(Claims& claims, double seed) {
  std::vector<Path> all;
  Random random(seed);
  for (int i = 0; i < 50; ++i) {
    Sample s(random);
    const double off = random.between(0.3, 0.9);
    const Pair right = s.right(), slow = {right[0] * off, right[1] * off};
    all.emplace_back(s, right, true);
    all.emplace_back(s, Pair{slow[0], 0}, false);
    all.emplace_back(s, Pair{0, slow[1]}, false);
    if (abs(s.hill.a1 - s.hill.a2) > 0.1 && std::min(abs(slow[0]), abs(slow[1])) > 0.05)
      all.emplace_back(s, slow, false);
    s.hill.a2 = s.hill.a1;
    all.emplace_back(s, slow, false);
  }
  claims.statement<Path>(
      "not_straight", 1581, "which paths from the top are straight", all,
      {.printed = {"none, unless $v_1^2/a_1^2+v_2^2/a_2^2=g/2$",
                   [](const Path& p) { return p.condition || p.is(false); }},
       .corrected = {"those with $v_1^2/a_1^2+v_2^2/a_2^2=g/2$, along an axis, or on a round hill; no others",
                     [](const Path& p) { return p.is(p.condition || p.axis || p.round()); }},
       .near_misses = {{"those with $v_1^2/a_1^2+v_2^2/a_2^2=g/2$, or on a round hill; no others",
                        [](const Path& p) { return p.is(p.condition || p.round()); }}},
       .kind = Fault::counterexample,
       .root = "straight at any speed",
       .why =
           R"(A particle sent off along an axis stays above it at any speed, and on a round hill, $a_1=a_2$, )"
           R"(every path through the top is straight; only its speed is not constant. What fails without )"
           R"(the condition is the motion $(v_1t,v_2t)$, not the line: for a point on the line )"
           R"($\dot x_1\ddot x_2-\dot x_2\ddot x_1$ is proportional to )"
           R"($(g-2K)\,v_1v_2\,(a_1^{-2}-a_2^{-2})$ with $K=v_1^2/a_1^2+v_2^2/a_2^2$.)"});
}

std::vector<Claim> claims(double seed) {
  Claims all("3.11");
  Table table(all);
  equations(table, draw<Sample>(200, seed));
  conditions(all, seed);
  paths(all, seed);
  return all.in_order();
}

Provables proofs() {
  Claims claims("3.11");
  Table table(claims);
  equations(table, {});
  const std::vector<std::string> names{"a1", "a2", "g", "t", "x1", "x2", "v1", "v2", "w1", "w2"};
  ForAll<SampleOf> all{.any = lettered<SampleOf>(names),
                       .letters = quantified(names),
                       .tactic = std::string("field; repeat split; ") + by_positive_terms,
                       .says = "it holds for any particle on any such hill"};
  all.given = {above(all.any.hill.a1.expression(), 0), above(all.any.hill.a2.expression(), 0)};
  double x = 1;
  for (double* letter : all.example.letters()) *letter = x += 0.25;
  Provables proved = table.proofs("3.11", all);
  const auto derivative_of = [](const Shortened& of, const Shortened& rate) -> Proposition {
    return {"derivable_pt_lim (fun t => " + of.expression().coq() + ") t (" + rate.expression().coq() + ")"};
  };
  const auto& s = all.any;
  std::vector<Proposition> twice;
  for (const Shortened& v : s.v) twice.push_back(derivative_of(v * s.t, v));
  for (const Shortened& v : s.v) twice.push_back(derivative_of(v, 0.0));
  proved.push_back(
      {"3.11-derivatives",
       "it holds for any velocity",
       {{"printed", all.letters, {}, twice, "apply is_derive_Reals; auto_derive; first [exact I | ring]"}},
       0,
       "From Coquelicot Require Import AutoDerive.\n"});
  return proved;
}

std::vector<Root> roots() {
  return {
      {"a particle at rest",
       R"(A ball set down on the top of the default hill stays there; by the sentence nothing that keeps to )"
       R"($(v_1t,v_2t)$ is slower than 2.24 m/s.)"},
      {"straight at any speed",
       R"(On the default hill, at three quarters of the right speed, a ball sent off along $(1,1)$ strays 0.51 m )"
       R"(from its line within two seconds, one along an axis not at all: a game that takes the sentence for a )"
       R"(test bends the path of a ball that rolls straight down a ridge.)"}};
}

}  // namespace oddity::ex03_11

namespace oddity {

Provables proofs_3_11() { return ex03_11::proofs(); }

}  // namespace oddity
