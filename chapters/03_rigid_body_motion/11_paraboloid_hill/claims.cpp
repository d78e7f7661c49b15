// The claims of exercise 3.11. The text's equations are compared with Lagrange's, whose Lagrangian is
// differentiated by nested dual numbers from the hill's height alone. Its statements about paths are tried on
// integrated motions.

#include "chapters/provable_claims.hpp"

#include <cmath>
#include <ranges>

#include "chapters/03_rigid_body_motion/11_paraboloid_hill/paraboloid_hill.hpp"
#include "chapters/03_rigid_body_motion/shared/height_field.hpp"
#include "reference/text.hpp"

namespace oddity::ex03_11 {

using namespace paraboloid_hill;
using std::abs;

// ---- the equations ----------------------------------------------------------------------------------------

/// A hill, a position, a velocity, an acceleration, and a time.
template <class T>
struct SampleOf {
  Hill<T> hill;
  T g{}, t{};
  Two<T> x{}, v{}, a{};

  Letters<T> table() {
    const Range any = either_sign(0.1, 3);
    return {{"a_1", hill.a1, {0.5, 3}},  {"a_2", hill.a2, {0.5, 3}}, {"g", g, {0.5, 20}}, {"t", t, any},
            {"x_1", x[0], any},          {"x_2", x[1], any},         {"v_1", v[0], any},  {"v_2", v[1], any},
            {R"(\ddot x_1)", a[0], any}, {R"(\ddot x_2)", a[1], any}};
  }
  TypesetIn<T> typeset() const { return {{R"(\dot x_1)", v[0]}, {R"(\dot x_2)", v[1]}}; }
  std::string where() const {
    return filled("$a$ = (@4, @4), $v$ = (@4, @4), $t$ = @4", {hill.a1, hill.a2, v[0], v[1], t});
  }
  T A1() const { return hill.a1 * hill.a1; }
  T A2() const { return hill.a2 * hill.a2; }
  T K() const { return v[0] * v[0] / A1() + v[1] * v[1] / A2(); }
  /// The left side of Lagrange's equations, zero for a motion.
  Two<T> lagrange(const Two<T>& at, const Two<T>& acceleration) const {
    return lagrange_left_side(height_field::Lagrangian<Hill<T>, T>{hill, g}, at, v, acceleration);
  }
  Two<T> on_line() const { return lagrange({v[0] * t, v[1] * t}, {T(0), T(0)}); }
  /// The hill's vertical force per mass on (v1 t, v2 t).
  T push() const {
    return g + second_derivative([this](const auto& s) { return hill.height(v[0] * s, v[1] * s); }, t);
  }
  /// The acceleration at the point t v, where the hill pushes a unit mass upward with g - 2K.
  Two<T> acceleration() const {
    const Two<T> slope{-2 * v[0] * t / A1(), -2 * v[1] * t / A2()};
    const T along = -(g - 2 * K()) / (1 + slope[0] * slope[0] + slope[1] * slope[1]);
    return {along * slope[0], along * slope[1]};
  }
  /// The velocity along v that makes the path straight.
  Two<T> right() const { return from_the_top<T>({hill.a1, hill.a2, g, v[0], v[1], T(1)}).v; }
};
using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;

/// On the default hill along (1, 1), at this fraction of the speed that makes the path straight.
Case<double> along_both(double part) { return from_the_top<double>({1, 2, 10, 1, 1, part}); }

const std::string half = R"($v_1^2/a_1^2+v_2^2/a_2^2=g/2$)";

void equations(Table& table, const std::vector<Sample>& samples) {
  const auto position = [](const auto& s, std::size_t i) {
    return [&s, i](const auto& t) { return s.v[i] * t; };
  };
  const auto claim = table.over(samples);
  claim("velocity", 1543, R"($(\dot x_1,\dot x_2)=(v_1,v_2)$ for $(x_1,x_2)=(v_1t,v_2t)$)",
        {"dual numbers",
         [=](const auto& s) {
           return values(derivative(position(s, 0), s.t), derivative(position(s, 1), s.t));
         }},
        "$(v_1,v_2)$", "the first derivative of $(v_1t,v_2t)$");
  claim("acceleration", 1543, R"($(\ddot x_1,\ddot x_2)=(0,0)$ for $(x_1,x_2)=(v_1t,v_2t)$)",
        {"dual numbers",
         [=](const auto& s) {
           return values(second_derivative(position(s, 0), s.t), second_derivative(position(s, 1), s.t));
         },
         [](const Sample& s) { return size_of(s.v) / abs(s.t); }},
        "$(0,0)$", "the second derivative of $(v_1t,v_2t)$");

  const std::string lagrange =
      R"($\frac d{dt}\frac{\partial L}{\partial\dot x_1}-\frac{\partial L}{\partial x_1}$ )"
      "by nested dual numbers";
  const auto equation = [](const std::string& square) {
    return R"($0=\ddot x_1+\frac{4x_1}{)" + square +
           R"(}\left(\frac{x_1\ddot x_1+\dot x_1^2}{a_1^2}+\frac{x_2\ddot x_2+\dot x_2^2}{a_2^2}\right))"
           R"(-\frac{2gx_1}{a_1^2}$)";
  };
  claim(
      "first_equation", 1545,
      R"(The first equation of motion is $0=\ddot x_1+\frac{4x_1}{a_1}B-\frac{2gx_1}{a_1^2}$, $B$ being )"
      R"($\frac{x_1\ddot x_1+\dot x_1^2}{a_1^2}+\frac{x_2\ddot x_2+\dot x_2^2}{a_2^2}$)",
      {.quantity = "the expression that the first equation of motion sets to zero",
       .truth = {lagrange, [](const auto& s) { return s.lagrange(s.x, s.a)[0]; }},
       .printed = equation("a_1"),
       .meant = equation("a_1^2"),
       .kind = Fault::formula,
       .why = filled(
           R"(The factor before the bracket is $4x_1/a_1^2$, as in the next line; with the hill )"
           R"($x_3=-x_1^2/a_1^2-x_2^2/a_2^2$ this is Lagrange's equation to the last digit. The text at hand )"
           R"(keeps the squares of the display's other denominators, so that this one is not lost on the way: )"
           R"(it was not printed. On a hill with $a_1=2$ the printed factor is @1 times the right one.)",
           {(4 / 2.0) / (4 / (2.0 * 2.0))})});

  const Sample narrow{.hill = {1, 2}, .t = 1, .v = {1, 1}}, wider{.hill = {2, 4}, .t = 1, .v = {1, 1}};
  const std::string products = R"(4v_1t\,a_1^2(v_1^2a_1^2+v_2^2a_2^2))",
                    quotients = R"(\frac{4v_1t}{a_1^2}\Big(\frac{v_1^2}{a_1^2}+\frac{v_2^2}{a_2^2}\Big))",
                    last = R"(-\frac{2gv_1t}{a_1^2}$)";
  const auto growth = [&](const std::string& term) {
    const TypesetFormula first("$" + term + "$");
    return first(typeset_of(wider))[0] / first(typeset_of(narrow))[0];
  };
  claim(
      "substituted", 1563,
      R"(On $(v_1t,v_2t)$ the first equation is $0=0+)" + quotients + last + ", three fraction bars lost",
      {.quantity = "the expression that the first equation sets to zero on $(v_1t,v_2t)$",
       .truth = {lagrange, [](const auto& s) { return s.on_line()[0]; }},
       .printed = "$0=0+" + products + last,
       .meant = "$0=0+" + quotients + last,
       .why = filled(
           R"(The bars of the first term's three fractions are lost in the text at hand; the last term has )"
           R"(its own. As products the terms cannot be added. On a hill twice as wide, with $a_1$ and $a_2$ )"
           R"(doubled, the first one should change by the factor @2, and changes by @2.)",
           {growth(quotients), growth(products)})});

  const auto by_factor = [](std::size_t i) -> ProvableFormula<SampleOf> {
    return {R"(the equation's left side over $4v_it/a_i^2$, by nested dual numbers)",
            [=](const auto& s) { return s.on_line()[i] * (i == 0 ? s.A1() : s.A2()) / (4 * s.v[i] * s.t); }};
  };
  claim("condition", 1573,
        "The first equation holds, for $v_1\\ne0$ (our condition), exactly if " + half +
            ", two fraction bars lost",
        {.quantity = "the first equation's left side, by a factor that is not zero",
         .truth = by_factor(0),
         .printed = "$v_1^2a_1^2+v_2^2a_2^2=g/2$",
         .meant = half,
         .why = filled(
             "The bars of the two fractions are lost in the text at hand. On the default hill, $a_1=1$, "
             "$a_2=2$, $g=10$, the condition is @2 m/s in each direction for $v_1=v_2$. With the products it "
             "is @2 m/s, at which the particle does not keep to a uniform motion.",
             {along_both(1).v[0], std::sqrt(10 / 2.0 / (1 * 1 + 2 * 2))})});
  claim("second_equation", 1581,
        "The second equation holds, for $v_2\\ne0$ (our condition), exactly if " + half + " too",
        by_factor(1), half, "the second equation's left side, by a factor that is not zero");
}

// ---- consequences -----------------------------------------------------------------------------------------

/// Starts at the top: in any direction or along an axis, with the condition satisfied or not; or at rest.
struct FromTop : Sample {
  explicit FromTop(Random& random) : Sample(drawn<Sample>(random)) {
    const int kind = random.below(4);
    if (kind == 1 || kind == 3) v[0] = 0;
    if (kind == 2 || kind == 3) v[1] = 0;
    if (kind != 3 && random.unit() < 0.5) v = right();
  }
  bool at_rest() const { return v[0] == 0 && v[1] == 0; }
  bool condition() const { return abs(K() - g / 2) <= rounding(K() + g / 2).allowed; }
  /// Whether (v1 t, v2 t) satisfies equation i.
  bool satisfied(std::size_t i) const {
    const Formula<FromTop> left{"left side", [=](const FromTop& s) { return Value(s.on_line()[i]); }};
    return size_of(left.of(*this)) <= rounding(size_of_terms(left, *this)).allowed;
  }
  bool both() const { return satisfied(0) && satisfied(1); }
};

/// Flies off along (v1 t, v2 t), faster than the condition by this factor.
struct Faster : Sample {
  double factor;
  explicit Faster(Random& random) : Sample(drawn<Sample>(random)), factor(random.between(1.01, 2)) {}
  bool above(double times) const {
    const Pair u = right();
    return -g * t * t / 2 > hill.height(times * u[0] * t, times * u[1] * t);
  }
};

void conditions(Claims& claims, double seed) {
  const auto samples = draw<FromTop>(400, seed);
  const auto [hill, g, top, fast] = along_both(2);
  const Sample twice_as_fast{.hill = hill, .g = g, .v = fast};
  const auto in_starts = [&](std::string text, const std::function<bool(const FromTop&)>& holds) -> Reading {
    return {text, {in_all(text, samples, holds)}};
  };
  Reading exactly = in_starts("exactly if " + half + ", or if the particle is at rest on the top",
                              [](const FromTop& s) { return s.both() == (s.condition() || s.at_rest()); });
  exactly.checks.push_back(compare<FromTop>(
      "the hill's vertical force over the mass on $(v_1t,v_2t)$",
      {"$g-2(v_1^2/a_1^2+v_2^2/a_2^2)$, nothing at the condition",
       [](const FromTop& s) { return Value(s.g - 2 * s.K()); }},
      {R"($g+\ddot x_3$ by dual numbers)", [](const FromTop& s) { return Value(s.push()); }}, samples));
  exactly.checks.push_back(in_all<Faster>(
      "a particle faster than the condition's speed is above the hill at all times in free fall",
      draw<Faster>(200, seed), [](const Faster& s) { return s.above(s.factor); }));
  claims.add(
      "only_way", 1581, "$(v_1t,v_2t)$ is a solution only if " + half,
      {.printed =
           in_starts("for all $v_1$ and $v_2$", [](const FromTop& s) { return !s.both() || s.condition(); }),
       .corrected = exactly,
       .in_view = in_starts("for a particle that moves",
                            [](const FromTop& s) { return !s.both() || s.condition() || s.at_rest(); }),
       .near_misses = {in_starts(
           "exactly if " + half + ", or if $v_1=0$",
           [](const FromTop& s) { return s.both() == (s.condition() || s.v[0] == 0); })},
       .why = filled(
           R"(The algebra divides by $v_1t$ and by $v_2t$. With $v_1=0$ the first equation reads $0=0$, and the )"
           R"(second decides; with $v_1=v_2=0$ neither does. All other motions $(v_1t,v_2t)$ need the )"
           R"(condition, and they are free falls: the hill does not push. A faster particle flies off, over )"
           R"(the same line and as uniformly. A game that keeps it on the hill by these equations has to pull )"
           R"(it down: at twice the speed, on the top, with @1 times its weight.)",
           {-twice_as_fast.push() / twice_as_fast.g}),
       .root = "a particle at rest"});
}

// ---- straight paths ---------------------------------------------------------------------------------------

/// A path from the top, on the hill by the equations of motion. `stray` is its largest deviation from the
/// line of its initial velocity, relative to the distance from the top.
struct Path {
  Hill<double> hill;
  double g;
  Pair v;
  bool condition, axis;
  double stray;

  Path(const Sample& s, const Pair& start, bool right_speed)
      : hill(s.hill), g(s.g), v(start), condition(right_speed), axis(v[0] == 0 || v[1] == 0), stray(0) {
    const auto path = ode::integrate<ode::Fehlberg78>(in_plane<double>({hill, g, {0, 0}, v}),
                                                      std::array{0.0, 0.0, v[0], v[1]},
                                                      std::array{0.0, 0.25, 0.5, 1.0, 1.5, 2.0}, 1e-12);
    if (!path.reached()) stray = std::numeric_limits<double>::quiet_NaN();
    for (const auto& x : path.value | std::views::drop(1))
      stray =
          std::max(stray, abs(x[0] * v[1] - x[1] * v[0]) / (std::hypot(x[0], x[1]) * std::hypot(v[0], v[1])));
  }
  std::string where() const {
    return filled("$a$ = (@4, @4), $v$ = (@4, @4)", {hill.a1, hill.a2, v[0], v[1]});
  }
  bool round() const { return hill.a1 == hill.a2; }
  bool is(bool straight) const { return straight ? stray < 1e-9 : stray > 1e-6; }
};

void paths(Claims& claims, double seed) {
  std::vector<Path> all;
  Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const auto s = drawn<Sample>(random);
    const Pair right = s.right();
    all.emplace_back(s, right, true);
    for (const double part : {random.between(0.3, 0.9), random.between(1.1, 2)}) {
      Sample on = s;
      const Pair off{right[0] * part, right[1] * part};
      all.emplace_back(on, Pair{off[0], 0}, false);
      all.emplace_back(on, Pair{0, off[1]}, false);
      if (abs(on.hill.a1 - on.hill.a2) > 0.1 && std::min(abs(off[0]), abs(off[1])) > 0.05)
        all.emplace_back(on, off, false);
      on.hill.a2 = on.hill.a1;
      all.emplace_back(on, off, false);
    }
  }
  const auto of_all = [&](std::string text, const std::function<bool(const Path&)>& holds) -> Reading {
    return {text, {in_all(text, all, holds)}};
  };
  const std::string held = "for paths from the top, held to the hill: those with " + half;
  const auto samples = draw<Sample>(200, seed);
  Reading straight = of_all(held + ", along an axis, or on a round hill; no others",
                            [](const Path& p) { return p.is(p.condition || p.axis || p.round()); });
  straight.checks.push_back(compare<Sample>(
      "decrease of Lagrange's left sides by the acceleration at a point $tv$",
      {R"(with $\ddot x=-(g-2K)\,n/(1+n\cdot n)$, $n$ the slope $-2t(v_1/a_1^2,\,v_2/a_2^2)$)",
       [](const Sample& s) {
         const Pair without = s.on_line(), with = s.lagrange({s.v[0] * s.t, s.v[1] * s.t}, s.acceleration());
         return values(without[0] - with[0], without[1] - with[1]);
       }},
      {"their values without acceleration, by nested dual numbers",
       [](const Sample& s) { return Value(s.on_line()); }},
      samples));
  straight.checks.push_back(compare<Sample>(
      R"($\dot x_1\ddot x_2-\dot x_2\ddot x_1$ there)",
      {R"($-2t\,(g-2K)v_1v_2(a_1^{-2}-a_2^{-2})/(1+n\cdot n)$)",
       [](const Sample& s) {
         return -2 * s.t * (s.g - 2 * s.K()) * s.v[0] * s.v[1] * (1 / s.A1() - 1 / s.A2()) /
                (1 +
                 4 * s.t * s.t * (s.v[0] * s.v[0] / (s.A1() * s.A1()) + s.v[1] * s.v[1] / (s.A2() * s.A2())));
       }},
      {"from that acceleration",
       [](const Sample& s) { return s.v[0] * s.acceleration()[1] - s.v[1] * s.acceleration()[0]; }},
      samples));
  claims.add(
      "not_straight", 1581,
      "If the condition is not satisfied, the path in the $(x_1,x_2)$-plane of a particle from the top, held to "
      "the hill (our condition), is no straight line",
      {.printed = of_all("none from the top, held to the hill, unless " + half,
                         [](const Path& p) { return p.condition || p.is(false); }),
       .corrected = straight,
       .near_misses = {of_all(held + ", or on a round hill; no others",
                              [](const Path& p) { return p.is(p.condition || p.round()); })},
       .why =
           R"(A particle sent off from the top along an axis stays above it at any speed, and on a round hill, )"
           R"($a_1=a_2$, every path through the top is straight; only its speed is not constant. Too fast a )"
           R"(particle flies off along the same line, unless it is held to the hill (our condition). What fails )"
           R"(without the condition is the motion $(v_1t,v_2t)$, not the line: for a point on the line )"
           R"($\dot x_1\ddot x_2-\dot x_2\ddot x_1$ is proportional to )"
           R"($(g-2K)\,v_1v_2\,(a_1^{-2}-a_2^{-2})$ with $K=v_1^2/a_1^2+v_2^2/a_2^2$.)",
       .kind = Fault::counterexample,
       .root = "straight at any speed"});
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
  auto all = for_all<SampleOf>(std::string("field; repeat split; try assumption; ") + by_positive_terms,
                               "it holds for any particle on any such hill",
                               {1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.25, 3.5});
  const auto& s = all.any;
  all.given = positive({s.hill.a1, s.hill.a2});
  for (const Shortened& x : {s.t, s.v[0], s.v[1]}) all.given.push_back(not_zero(x.expression()));
  Provables proved = table.proofs("3.11", all);
  const auto derivative_of = [](const Shortened& of, const Shortened& rate) -> Proposition {
    return {"derivable_pt_lim (fun t => " + of.expression().coq() + ") t (" + rate.expression().coq() + ")"};
  };
  std::vector<Proposition> once, twice;
  for (const Shortened& v : s.v)
    once.push_back(derivative_of(v * s.t, v)), twice.push_back(derivative_of(v, 0.0));
  for (const auto& [slug, rates] : {std::pair{"velocity", once}, {"acceleration", twice}})
    proved.push_back(
        {std::string("3.11-") + slug,
         "it holds for any velocity",
         {{"printed", all.letters, {}, rates, "apply is_derive_Reals; auto_derive; first [exact I | ring]"}},
         0,
         "From Coquelicot Require Import AutoDerive.\n"});
  return proved;
}

std::vector<Root> roots() {
  constexpr double factor = 0.75, span = 2;
  const Case<double> slow = along_both(factor);
  const auto end =
      ode::integrate<ode::Fehlberg78>(in_plane(slow), in_plane(slow).start(), 0, span, 1e-10).value;
  return {
      {"a particle at rest",
       filled(
           R"(A ball set down on the top of the default hill stays there; by the sentence nothing that keeps to )"
           R"($(v_1t,v_2t)$ is slower than @3 m/s.)",
           {along_both(1).hill.a1 * std::sqrt(along_both(1).g / 2)})},
      {"straight at any speed",
       filled(
           R"(On the default hill, at @2 times the right speed, a ball sent off along $(1,1)$ strays @2 m )"
           R"(from its line within @1 s. One along an axis does not stray at all. A game that uses the )"
           R"(sentence as a test bends the path of a ball that rolls straight down a ridge.)",
           {factor, abs(end[0] - end[1]) / std::sqrt(2.0), span})}};
}

}  // namespace oddity::ex03_11
