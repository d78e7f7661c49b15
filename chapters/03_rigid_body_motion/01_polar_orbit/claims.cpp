// The claims of exercise 3.1. The published algebra squares twice. It is checked line by line at points
// computed from the polar equation. Its result is also checked by properties that no line uses: the sum of
// the distances to the foci, the apsides, and the orbit's highest point. There d(r sin theta)/d theta = 0,
// solved by dual numbers and Brent's method.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

#include "chapters/02_basic_concepts/shared/recorded_functions.hpp"
#include "chapters/03_rigid_body_motion/01_polar_orbit/polar_orbit.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/roots.hpp"

namespace oddity::ex03_01 {

using std::abs, std::atan2, std::cos, std::hypot, std::pow, std::sin, std::sqrt, std::numbers::pi;

/// A point of sign 1 is on the orbit, of sign -1 on the mirror image r = e rho / (1 - e cos theta). A point
/// of sign 0 is anywhere: only rewritten lines hold there.
template <class T>
struct PointOf : EllipseOf<T> {
  using EllipseOf<T>::e, EllipseOf<T>::rho;
  T r, x, y;
  double s;

  std::array<T*, 5> letters() { return {&e, &rho, &r, &x, &y}; }
  TypesetIn<T> typeset() const {
    return {{"e", e},         {R"(\rho)", rho}, {"r", r},
            {"x", x},         {"y", y},         {R"(\theta)", atan2(y, x)},
            {"a", this->a()}, {"b", this->b()}, {"c", this->c()},
            {R"(\pm)", s}};
  }
  std::string where() const {
    return "$e$ = " + format_shortest(e) + R"(, $\rho$ = )" + format_shortest(rho) +
           ", $x$ = " + format_shortest(x) + ", $y$ = " + format_shortest(y) +
           (s > 0   ? ", on the orbit"
            : s < 0 ? ", on its mirror image"
                    : "");
  }

  T nearest() const { return e * rho / (1 + e); }
  T farthest() const { return e * rho / (1 - e); }
  /// The distance at the polar angles 0 and pi.
  T at_zero() const { return e * rho / (1 + s * e); }
  T at_pi() const { return e * rho / (1 - s * e); }
  T half_length() const { return (nearest() + farthest()) / 2; }
  T to_middle() const { return (farthest() - nearest()) / 2; }
  template <class Angle>
  Angle height(const Angle& theta) const {
    return orbit(e, rho, theta) * sin(theta);
  }
  T slope_of_height(const T& theta) const {
    return derivative([&](const auto& angle) { return height(angle); }, theta);
  }
  /// r sin theta at the zero of its derivative; in proofs this is at the angle `top`.
  T half_height() const {
    if constexpr (std::same_as<T, Shortened>)
      return height(T::letter("top"));
    else
      return height(brent([&](const T& theta) { return slope_of_height(theta); }, 0, pi, 1e-15).value);
  }
};
using Point = PointOf<double>;
using Line = ProvableFormula<PointOf>;

enum class On { orbit, both, anywhere };

std::vector<Point> points(double seed, On on) {
  Random random(seed);
  std::vector<Point> all;
  for (int i = 0; i < 200; ++i) {
    const double e = i % 8 < 2   ? abs(random.magnitude(1e-6, 1))
                     : i % 8 < 4 ? 1 - abs(random.magnitude(1e-4, 1))
                                 : random.between(0.05, 0.95);
    const double rho = abs(random.magnitude(0.1, 10)) / e, theta = random.between(-pi, pi);
    const double s = on == On::anywhere ? 0 : on == On::both && i % 3 ? -1 : 1;
    const double r = s == 0 ? abs(random.magnitude(0.1, 10)) : orbit(s * e, s * rho, theta);
    all.push_back({{e, rho}, r, r * cos(theta), r * sin(theta), s});
  }
  return all;
}

// ---- line by line -----------------------------------------------------------------------------------------

/// Two sides of a line that are equal on a curve.
struct Stated {
  std::string slug;
  On on;
  Line printed, truth;
};

const Line zero{"zero", []<class T>(const PointOf<T>&) { return T(0); }};

/// The claims, and those of their lines that can be proved.
struct Table {
  double seed;
  Claims claims{"3.1"};
  std::vector<Point> orbit_alone = points(seed, On::orbit), both = points(seed, On::both),
                     anywhere = points(seed, On::anywhere);
  std::vector<Stated> stated = {};

  void line(const std::string& slug, int at, std::string says, On on, const Line& truth, const Line& printed,
            std::string quantity = {}) {
    stated.push_back({slug, on, printed, truth});
    claims.formula<Point>(slug, at, std::move(says),
                          on == On::orbit  ? orbit_alone
                          : on == On::both ? both
                                           : anywhere,
                          {.quantity = std::move(quantity), .truth = truth, .printed = printed});
  }
  /// Claims a line of the page at points from the polar equation: two sides are equal, or the first equals
  /// each of several. `first` is an independent route to the first side.
  void equation(const std::string& slug, int at, const std::string& before, On on,
                const std::vector<std::string>& sides, const std::string& after = {},
                const Line& first = {}) {
    const bool two = sides.size() == 2;
    std::string whole = sides[0], others;
    for (std::size_t i = 1; i < sides.size(); ++i) {
      whole += "=" + sides[i];
      others += (i == 1 ? "" : R"(,\ )") + sides[i];
    }
    const Line left = "$" + sides[0] + "$";
    line(slug, at, before + "$" + whole + "$" + after, on,
         !first.text.empty() ? first
         : two               ? zero
                             : left,
         two ? "$" + whole + "$" : "$(" + others + ")$", two ? "" : left.text);
  }
};

void to_the_second_squaring(Table& t) {
  t.equation("multiplied", 857, R"(Multiplied by its denominator, with $x=r\cos\theta$: )", On::orbit,
             {R"(e\rho)", R"(r(1+e\cos\theta))", "r+ex"});
  t.equation("squared", 861, "Squared: ", On::orbit, {R"(e^2\rho^2)", "r^2+2exr+e^2x^2"});
  t.equation("solved", 863, "Solved for the middle term: ", On::orbit, {"2exr", R"(e^2(\rho^2-x^2)-r^2)"});
  t.equation("distance", 865, "", On::orbit, {"r", R"(\sqrt{x^2+y^2})"}, "",
             {"$r$ by the polar equation", [](const auto& p) { return p.r; }});
  t.equation("squared_again", 869, "Squared again: ", On::both,
             {"4e^2x^2r^2", R"([e^2(\rho^2-x^2)-r^2]^2)", R"([e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2-x^2)r^2)"},
             "",
             {"$4e^2x^2r^2$ at the point", [](const auto& p) { return 4 * pow(p.e * p.x * p.r, 2); },
              [](const Point& p) { return pow(p.e * p.e * (p.rho * p.rho - p.x * p.x), 2) + pow(p.r, 4); }});
}

/// Lines that rewrite the one before: everywhere they are one product, which is zero on both curves.
void rewritten(Table& t) {
  std::ranges::copy(t.both, std::back_inserter(t.anywhere));
  const Line both_curves{R"($(e^2\rho^2-(r+ex)^2)(e^2\rho^2-(r-ex)^2)$)", [](const auto& p) {
                           const auto product = [&](double sign) {
                             const auto root = p.r + sign * p.e * p.x;
                             return p.e * p.e * p.rho * p.rho - root * root;
                           };
                           return product(1) * product(-1);
                         }};
  const auto line = [&](const std::string& slug, int number, const std::string& before,
                        const std::string& text) {
    t.line(slug, number, before + text, On::anywhere, both_curves, text, "the line, zero on both curves");
    t.stated.push_back({slug, On::both, text, zero});
  };
  line("subtracted", 873, "$4e^2x^2r^2$ subtracted: ", R"($0=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)");
  line("regrouped", 875, "", R"($0=[e^2(\rho^2+x^2)-2e^2x^2]^2+r^4-2e^2(\rho^2+x^2)r^2$)");
  line("opened", 877, "The square opened: ",
       R"($0=[e^2(\rho^2+x^2)]^2-4e^4x^2(\rho^2+x^2)+4e^4x^4+r^4-2e^2(\rho^2+x^2)r^2$)");
  line("gathered", 879,
       "Its terms gathered: ", R"($0=[e^2(\rho^2+x^2)]^2-4e^4\rho^2x^2+r^4-2e^2(\rho^2+x^2)r^2$)");
  line("closed", 881, "A square completed again: ", R"($0=[e^2(\rho^2+x^2)-r^2]^2-4e^4\rho^2x^2$)");
}

const Line half_sizes{"half the way between the apsides, and the highest point by Brent's method",
                      [](const auto& p) { return values(p.half_length(), p.half_height()); }};
const Line semi_axes = R"($(e\rho/(1-e^2),\ a\sqrt{1-e^2})$)";
const Line square_of_sizes{"the apsides and the highest point by Brent's method",
                           [](const auto& p) { return pow(p.half_length() / p.half_height(), 2); }};
const Line square_of_axes = "$1/(1-e^2)$";

/// The ellipse's point at the eccentric anomaly whose cosine is x/r.
template <class T>
std::array<T, 2> on_ellipse(const PointOf<T>& p, double sign) {
  return {-sign * p.c() + p.a() * p.x / p.r, p.b() * p.y / p.r};
}
Line distance_on_ellipse(double sign) {
  return {sign > 0 ? "points of the ellipse of the plus sign" : "points of the ellipse of the minus sign",
          [=](const auto& p) { return hypot(on_ellipse(p, sign)[0], on_ellipse(p, sign)[1]); }};
}
Line orbit_at_angle(double sign) {
  return {"the polar equation at their angles", [=](const auto& p) {
            return orbit(p.e, p.rho, atan2(on_ellipse(p, sign)[1], on_ellipse(p, sign)[0]));
          }};
}

const Line to_middle_of_apsides{R"(from the origin to the middle of the apsides, $r(0)$ and $r(\pi)$)",
                                [](const auto& p) { return p.to_middle(); }, &Point::farthest};

void to_the_ellipse(Table& t) {
  t.equation("moved", 883, "", On::both, {R"(4e^4\rho^2x^2)", R"([e^2(\rho^2+x^2)-r^2]^2)"});
  t.equation("root", 885, "", On::both, {R"(\pm2e^2\rho x)", R"(e^2(\rho^2+x^2)-r^2)"},
             " (our reading, here and below: $+$ on the orbit, $-$ on its mirror image)");
  t.equation("collected", 889, "", On::both,
             {R"((1-e^2)x^2\pm2e^2\rho x+y^2)", R"(r^2-e^2x^2\pm2e^2\rho x)", R"(e^2\rho^2)"});
  t.equation("divided", 893, "Divided by $1-e^2$ (our condition: $0<e<1$): ", On::both,
             {R"(x^2\pm\frac{2e^2\rho}{1-e^2}x+\frac{y^2}{1-e^2})", R"(\frac{e^2\rho^2}{1-e^2})"});
  t.equation("completed", 905, "The square completed: ", On::both,
             {R"(\left(x\pm\frac{e^2\rho}{1-e^2}\right)^2+\frac{y^2}{1-e^2})",
              R"(\frac{e^2\rho^2}{1-e^2}+\frac{e^4\rho^2}{(1-e^2)^2})", R"(\frac{e^2\rho^2}{(1-e^2)^2})"});
  t.claims.formula<Point>(
      "axes", 927,
      R"(The book defines $a=e\rho/(1-e^2)$ and $b=a\sqrt{1-e^2}$ (our check: they are half the length and half )"
      R"(the height of the orbit).)",
      t.orbit_alone, {.truth = half_sizes, .printed = semi_axes});
  t.claims.formula<Point>("ratio", 929, "$a^2/b^2=1/(1-e^2)$", t.orbit_alone,
                          {.truth = square_of_sizes, .printed = square_of_axes});
  t.equation("c", 929, "", On::orbit, {"c", "ae", R"(e^2\rho/(1-e^2))"}, "", to_middle_of_apsides);
  t.equation("scaled", 931, "", On::both, {R"((x\pm c)^2+(a^2/b^2)y^2)", "a^2"});
  t.equation("ellipse", 935, "", On::both, {R"((x\pm c)^2/a^2+y^2/b^2)", "1"},
             ", the standard formula of an ellipse along the axes");

  const auto fits = [&](double sign) {
    return compare<Point>("distance from the origin", distance_on_ellipse(sign), orbit_at_angle(sign),
                          t.orbit_alone);
  };
  t.claims.add(
      "two_solutions", 887,
      R"(The sign in $\pm2e^2\rho x$ indicates that there are two possible solutions (our reading: of the polar )"
      R"(equation, the orbit).)",
      {.printed = {R"($\pm2e^2\rho x=e^2(\rho^2+x^2)-r^2$ is the orbit with either sign)",
                   {fits(1), fits(-1)}},
       .corrected = {R"($2e^2\rho x=e^2(\rho^2+x^2)-r^2$, the plus sign alone, is the orbit)", {fits(1)}},
       .near_misses = {{R"($-2e^2\rho x=e^2(\rho^2+x^2)-r^2$ is the orbit)", {fits(-1)}}},
       .why =
           R"(The second squaring adds the mirror image $r=e\rho/(1-e\cos\theta)$. Of the ellipse with the )"
           R"(minus sign only the two points $(0,\pm e\rho)$ satisfy the polar equation; the orbit is the )"
           R"(one with the plus sign.)",
       .kind = Fault::counterexample,
       .root = "the mirror image"});
}

// ---- statements about the ellipse -------------------------------------------------------------------------

const Line middle_of_apsides{"the middle of the apsides",
                             [](const auto& p) { return values((p.at_zero() - p.at_pi()) / 2, 0); },
                             &Point::farthest};
const Line printed_center = R"($(\pm c,0)$)", center = R"($(\mp c,0)$)";

const Point shown{{0.625, 1.5}, 0, 0, 0, 1};

const Line all_apart{R"($r(0)+r(\pi)$)", [](const auto& p) { return p.nearest() + p.farthest(); }};
const Line printed_foci = R"($r+\sqrt{(x\mp2c)^2+y^2}$)", foci = R"($r+\sqrt{(x\pm2c)^2+y^2}$)",
           foci_of_orbit = R"($r+\sqrt{(x+2c)^2+y^2}$)";

const Line sizes{R"($r(0)+r(\pi)$, and twice the highest point by Brent's method)",
                 [](const auto& p) { return values(p.nearest() + p.farthest(), 2 * p.half_height()); }};
const Line printed_axes = "$(a,b)$", axes = "$(2a,2b)$";

void about_the_ellipse(Table& t) {
  Claims& claims = t.claims;
  const std::vector<Point>& samples = t.orbit_alone;
  claims.statement<Point>(
      "positive", 941,
      "The ellipse has $a>0$ and $b>0$ (our condition: $0<e<1$; for $e=0$ the polar equation "
      "is $r=0$, and from $e=1$ on its curve is no ellipse).",
      samples, {.printed = {"$(a,b)>0$"}, .near_misses = {{R"($(a-\rho,b)>0$)"}, {"$(a,b-c)>0$"}}});
  claims.formula<Point>(
      "center", 941, R"(The center of the ellipse $(x\pm c)^2/a^2+y^2/b^2=1$ is $(\pm c,0)$.)", t.both,
      {.quantity = R"(the center of the orbit or of its mirror image)",
       .truth = middle_of_apsides,
       .printed = printed_center,
       .corrected = center,
       .kind = Fault::formula,
       .root = "the sign of the center",
       .why =
           R"($(x\pm c)^2$ is zero at $x=\mp c$. The orbit has the plus sign: its center, midway between the )"
           R"(apsides, is $(-c,0)$, away from the perihelion at $\theta=0$.)"});
  claims.formula<Point>(
      "major_axis", 941, "The length of the major axis is $a$, that of the minor axis $b$.", samples,
      {.truth = sizes,
       .printed = printed_axes,
       .corrected = axes,
       .kind = Fault::term,
       .root = "axes for semi-axes",
       .why =
           R"($a$ and $b$ are the semi-axes: $r(0)+r(\pi)=2e\rho/(1-e^2)=2a$. (The solution of 3.3 has $2a$ )"
           R"(and $2b$.))"});
  t.line("focal_distance", 943,
         "The distance from the center to a focus is $c$: the origin has this distance from the center.",
         On::orbit, to_middle_of_apsides, "$c$");
  t.line("origin_is_focus", 943,
         "The origin is a focal point: the distances to it and to another point have a constant sum.",
         On::orbit, all_apart, foci_of_orbit, "sum of the distances to the origin and $(-2c,0)$");
  claims.formula<Point>(
      "other_focus", 943, R"(The other focal point is $(\pm2c,0)$.)", t.both,
      {.quantity = R"(sum of the distances to the origin and the other focus)",
       .truth = all_apart,
       .printed = printed_foci,
       .corrected = foci,
       .kind = Fault::formula,
       .root = "the sign of the center",
       .why = filled(
           R"(For $e=@3$, $\rho=@2$ the distances to the origin and $(2c,0)$ add up to @3 at the aphelion. Those )"
           R"(to the origin and $(-2c,0)$ add up to $2a$ there and everywhere, which is @3.)",
           {shown.e, shown.rho, 2 * (shown.farthest() + shown.c()), 2 * shown.half_length()})});
}

Table table(double seed) {
  Table t{seed};
  to_the_second_squaring(t);
  rewritten(t);
  to_the_ellipse(t);
  about_the_ellipse(t);
  return t;
}

std::vector<Claim> claims(double seed) { return table(seed).claims.in_order(); }

std::vector<Root> roots() {
  const double near = shown.nearest(), far = shown.farthest(), a = shown.half_length();
  return {
      {"the mirror image",
       filled(
           R"(For $e=@3$, $\rho=@2$ the minus sign puts the planet @2 from the sun at $\theta=0$, where it )"
           R"(should be at its nearest, @3.)",
           {shown.e, shown.rho, far, near})},
      {"the sign of the center",
       filled(R"(An ellipse drawn about $(c,0)$ has the sun in the wrong focus: for $e=@3$, $\rho=@2$ its )"
              R"(perihelion is @3 too far out, at @2 instead of @3.)",
              {shown.e, shown.rho, far - near, far, near})},
      {"axes for semi-axes",
       filled(R"(Drawn with a major axis of length $a$ the orbit is half as large: for $e=@3$, $\rho=@2$ it )"
              R"(is @3 long instead of @3.)",
              {shown.e, shown.rho, a, 2 * a})}};
}

}  // namespace oddity::ex03_01

// ---- proofs -----------------------------------------------------------------------------------------------

namespace oddity {

namespace ex03_01 {

namespace {

/// A point with r from the polar equation of its curve.
PointOf<Shortened> any_point(double sign) {
  const auto letter = Shortened::letter;
  PointOf<Shortened> p{{letter("e"), letter("rho")}, letter("r"), letter("x"), letter("y"), sign};
  if (sign != 0) p.r = p.e * p.rho - sign * p.e * p.x;
  return p;
}

/// Denominators are (1 - e) (1 + e), which is positive.
const std::string by_factors = "try replace (1 - e ^ 2) with ((1 - e) * (1 + e)) by ring;\n  ";

/// Solves an equation by `field`, with y^2 and the square of the root of 1 - e^2 known.
std::string by_squares(const Expression& q) {
  const std::string root = sqrt(q).coq(), positive = "sqrt_lt_R0, Rmult_lt_0_compat; lra);\n  ";
  return by_factors + "assert (root : " + root + " * " + root + " = " + q.coq() +
         ") by (apply sqrt_sqrt, Rlt_le, Rmult_lt_0_compat; lra);\n  assert (" + root +
         " <> 0) by (apply Rgt_not_eq, " + positive + "field [H2 root]; repeat split; lra";
}

Proposition is(const Shortened& left, const Shortened& right) {
  return left.expression() == right.expression();
}

/// A single right side is equal to each of the left sides.
std::vector<Proposition> in_rows(Expressions left, Expressions right) {
  in_a_row(left, right);
  return equal(left, right);
}

std::vector<Proposition> orbits(const PointOf<Shortened>& p) {
  return {above(p.e.expression(), 0), above((1 - p.e).expression(), 0), above(p.rho.expression(), 0)};
}

Lemma on_curve(std::string name, const Line& left, const Line& right, double sign) {
  const PointOf<Shortened> p = any_point(sign);
  Lemma lemma{.name = std::move(name),
              .letters = "(e rho r x y : R)",
              .given = orbits(p),
              .follows = in_rows(left.recorded(p), right.recorded(p)),
              .tactic = "field; repeat split; lra"};
  if (sign == 0) return lemma;
  lemma.given.push_back(is(p.y * p.y, p.r * p.r - p.x * p.x));
  lemma.tactic = by_squares(p.q().expression());
  return lemma;
}

std::vector<Lemma> lemmas_of(const Stated& s) {
  if (s.on == On::anywhere) return {on_curve("anywhere", s.printed, s.truth, 0)};
  std::vector<Lemma> all{on_curve("orbit", s.printed, s.truth, 1)};
  if (s.on == On::both) all.push_back(on_curve("mirror_image", s.printed, s.truth, -1));
  return all;
}

/// For claims about distances and the angle.
const std::string distances_in_coq = R"(
(* r > 0 on the orbit, and below the farthest. *)
Lemma on_orbit : forall e rho x y, e > 0 -> 1 - e > 0 -> rho > 0 ->
  y * y = (e * rho - e * x) * (e * rho - e * x) - x * x -> e * rho - e * x > 0 /\ (1 - e) * (e * rho - e * x) <= e * rho.
Proof.
  intros e rho x y E U P C. set (r := e * rho - e * x) in *.
  assert (M : e * rho > 0) by (apply Rmult_lt_0_compat; lra). assert (R : r + e * x = e * rho) by (unfold r; ring).
  assert (B : x * x <= r * r) by nra. clearbody r.
  assert (far : r > 0).
  { destruct (Rlt_le_dec 0 r) as [|N]; trivial. assert (0 < x) by nra. assert (- r < x) by nra. nra. }
  split; trivial. assert (- r <= x) by (destruct (Rle_lt_dec (- r) x) as [|N]; trivial; nra). nra.
Qed.
(* From the orbit's other focus, the only root there is. *)
Ltac other_distance e rho x C :=
  let d := constr:(e * rho / (1 + e) + e * rho / (1 - e) - (e * rho - e * x)) in
  match goal with |- context [sqrt ?q] =>
    replace q with (d * d) by (field [C]; repeat split; lra);
    rewrite sqrt_square by (apply Rmult_le_reg_r with (1 - e); [lra |];
      assert (e * rho / (1 + e) > 0) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra);
      replace (d * (1 - e)) with (e * rho / (1 + e) * (1 - e) + (e * rho - (1 - e) * (e * rho - e * x)))
        by (field; lra); nra) end.
Ltac by_distance :=
  match goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, C : ?y * ?y = _ - ?x * ?x |- _ =>
    try replace (x ^ 2 + y ^ 2) with (x * x + y * y) by ring;
    try replace (1 - e ^ 2) with ((1 - e) * (1 + e)) by ring;
    destruct (on_orbit e rho x y E U P C) as [far below];
    assert (square : x * x + y * y = (e * rho - e * x) * (e * rho - e * x)) by lra;
    try rewrite cos_atan2 by (rewrite square; apply Rmult_lt_0_compat; lra);
    rewrite ?square, ?sqrt_square by lra;
    try other_distance e rho x C;
    field; repeat split; lra end.
Ltac by_mirrored_distance :=
  match goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, C : ?y * ?y = _ - ?x * ?x |- _ =>
    replace (1 - e ^ 2) with ((1 - e) * (1 + e)) by ring;
    assert (M : y * y = (e * rho - e * - x) * (e * rho - e * - x) - - x * - x) by (rewrite C; ring);
    destruct (on_orbit e rho (- x) y E U P M) as [far below];
    other_distance e rho (- x) M; field; repeat split; lra end.
)";

Provable by_distance(Provable provable) {
  provable.preamble = atan2_in_coq + distances_in_coq;
  for (Lemma& lemma : provable.lemmas)
    if (lemma.tactic != "interval")
      lemma.tactic = lemma.name == "mirror_image" ? "by_mirrored_distance" : "by_distance";
  return provable;
}

Provable proof_of_center() {
  const PointOf<Shortened> p{{0.5, 1}, 0, 0, 0, 1};
  const Expression printed = printed_center.recorded(p)[0], right = middle_of_apsides.recorded(p)[0];
  return {
      "3.1-center",
      "the corrected center is in the middle of the apsides of every orbit and its mirror image; for e = 1/2 "
      "and rho = 1 the printed one is off",
      {on_curve("corrected", center, middle_of_apsides, 1),
       on_curve("mirror_image", center, middle_of_apsides, -1),
       {.name = "printed_differs", .follows = {apart(printed, right, 0.6)}, .tactic = "interval"}},
      0.6};
}

/// Proof for the ellipse's other focus, with an example at a point of e = 1/2 and rho = 1.
Provable proof_of_other_focus() {
  const PointOf<Shortened> p{{0.5, 1}, 0.375, 0.25, sqrt(Shortened(5.0) / 64), 1};
  return {"3.1-other_focus",
          "the corrected point is a focus of every orbit and its mirror image; for e = 1/2 and rho = 1 the "
          "printed one is off",
          {on_curve("corrected", foci, all_apart, 1),
           on_curve("mirror_image", foci, all_apart, -1),
           {.name = "printed_differs",
            .follows = {apart(printed_foci.recorded(p)[0], all_apart.recorded(p)[0], 0.45)},
            .tactic = "interval"}},
          0.45};
}

/// Lemmas for claims about the highest point, at the angle `top`.
const std::string heights_in_coq = R"(
Lemma on_orbits : forall e t, e > 0 -> 1 - e > 0 ->
  1 + e * cos t > 0 /\ sin t * sin t = 1 - cos t * cos t.
Proof.
  intros e t E U. pose proof (COS_bound t). pose proof (sin2_cos2 t) as C. unfold Rsqr in C. split; nra.
Qed.
Ltac by_height :=
  lazymatch goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, T : ?top > 0, B : PI - ?top > 0, F : _ = 0 |-
      _ =>
    try replace (1 - e ^ 2) with ((1 - e) * (1 + e)) by ring;
    destruct (on_orbits e top E U) as [D C]; assert (S : sin top > 0) by (apply sin_gt_0; lra);
    remember (cos top) as c eqn:is_c; remember (sin top) as s eqn:is_s; clear is_c is_s T B top;
    apply (f_equal (fun z => z * ((1 + e * c) * (1 + e * c) / (e * rho)))) in F; cbv beta in F; rewrite
        Rmult_0_l in F;
    match type of F with ?l = _ => replace l with (c + e * (c * c + s * s)) in F by (field; repeat split; lra)
        end;
    assert (is_c : c = - e) by (replace (c * c + s * s) with 1 in F by (rewrite C; ring); lra); subst c; clear
        F;
    assert (sine : s * s = (1 - e) * (1 + e)) by (rewrite C; ring);
    assert (root : sqrt ((1 - e) * (1 + e)) = s) by (apply sqrt_lem_1; [rewrite <- sine; apply Rle_0_sqr | lra
        | exact sine]);
    try rewrite root; try (replace (1 / ((1 - e) * (1 + e))) with (1 / (s * s)) by (rewrite C; f_equal;
        ring));
    field [sine]; repeat split; lra end.
Ltac by_top :=
  lazymatch goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0 |- _ =>
    assert (C : cos (acos (- e)) = - e) by (apply cos_acos; lra);
    assert (B : 0 < acos (- e) < PI) by (apply acos_bound_lt; lra);
    try lra;
    assert (S : sin (acos (- e)) > 0) by (apply sin_gt_0; lra);
    destruct (on_orbits e (acos (- e)) E U) as [_ Q]; rewrite C in *;
    remember (sin (acos (- e))) as s eqn:is_s; clear is_s B C;
    match goal with
    | |- _ = 0 => field [Q]; nra
    | |- context [cos ?t] =>
      destruct (on_orbits e t E U) as [D R]; remember (cos t) as c eqn:is_c; remember (sin t) as d eqn:is_d;
          clear is_c is_d;
      assert (q : 1 - e * e > 0) by nra;
      assert (L : d * (1 - e * e) <= s * (1 + e * c)) by (apply Rsqr_incr_0_var; [unfold Rsqr;
        replace (s * (1 + e * c) * (s * (1 + e * c))) with (s * s * ((1 + e * c) * (1 + e * c))) by ring;
            rewrite Q;
        replace (d * (1 - e * e) * (d * (1 - e * e))) with (d * d * ((1 - e * e) * (1 - e * e))) by ring;
            rewrite R;
        pose proof (Rle_0_sqr (c + e)) as N; unfold Rsqr in N;
        assert (0 <= (1 - e * e) * ((c + e) * (c + e))) by (apply Rmult_le_pos; lra); lra | apply Rlt_le,
            Rmult_lt_0_compat; lra]);
      assert (w : 0 < e * rho / ((1 + e * c) * (1 - e * e)))
        by (apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra);
      replace (e * rho / (1 + e * c) * d) with (e * rho / ((1 + e * c) * (1 - e * e)) * (d * (1 - e * e)))
        by (field; split; lra);
      replace (e * rho / (1 + e * - e) * s) with (e * rho / ((1 + e * c) * (1 - e * e)) * (s * (1 + e * c)))
        by (field; repeat split; lra);
      apply Rmult_le_compat_l; lra
    end end.
)";

PointOf<Shortened> any_orbit() { return {{Shortened::letter("e"), Shortened::letter("rho")}, 0, 0, 0, 1}; }

Lemma at_the_top(std::string name, const Line& left, const Line& right) {
  const PointOf<Shortened> p = any_orbit();
  const Shortened top = Shortened::letter("top");
  Lemma lemma{.name = std::move(name),
              .letters = "(e rho top : R)",
              .given = orbits(p),
              .follows = equal(left.recorded(p), right.recorded(p)),
              .tactic = "by_height"};
  for (const Shortened& positive : {top, pi_of<Shortened>() - top})
    lemma.given.push_back(above(positive.expression(), 0));
  lemma.given.push_back(is(p.slope_of_height(top), 0));
  return lemma;
}

/// Proves that there is a highest point.
Lemma top_there_is() {
  const PointOf<Shortened> p = any_orbit();
  const Shortened top = acos(-p.e), angle = Shortened::letter("theta");
  return {.name = "highest",
          .letters = "(e rho theta : R)",
          .given = orbits(p),
          .follows = {above(top.expression(), 0),
                      above((pi_of<Shortened>() - top).expression(), 0),
                      is(p.slope_of_height(top), 0),
                      {p.height(angle).expression().coq() + " <= " + p.height(top).expression().coq()}},
          .tactic = "by_top"};
}

Provables proofs_of_axes() {
  const PointOf<Shortened> p{{0.5, 1}, 0, 0, 0, 1};
  const Expression length = printed_axes.recorded(p)[0], right = sizes.recorded(p)[0];
  Provables all{
      {"3.1-axes",
       "it holds on every orbit, and every orbit has a highest point",
       {at_the_top("printed", semi_axes, half_sizes), top_there_is()}},
      {"3.1-ratio", "it holds on every orbit", {at_the_top("printed", square_of_axes, square_of_sizes)}},
      {"3.1-major_axis",
       "as corrected it holds on every orbit; for e = 1/2 and rho = 1 the printed equation is off",
       {at_the_top("corrected", axes, sizes),
        {.name = "printed_differs", .follows = {apart(length, right, 0.66)}, .tactic = "interval"}},
       0.66}};
  for (Provable& one : all) one.preamble = heights_in_coq;
  return all;
}

const std::string anomalies_in_coq = R"(
(* The ellipse's points by the cosine k and the sine l of their eccentric anomaly. *)
Ltac by_anomaly :=
  lazymatch goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, far : ?r > 0, C : ?y * ?y = _ - ?x * ?x |- _
      =>
    assert (is_q : (1 - e) * (1 + e) > 0) by (apply Rmult_lt_0_compat; lra);
    pose proof (sqrt_sqrt _ (Rlt_le _ _ is_q)) as root;
    assert (near : x <= r) by nra;
    assert (positive : e * rho / ((1 - e) * (1 + e)) * (1 - e * (x / r)) > 0)
      by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra |
        assert (x / r <= 1) by (apply Rmult_le_reg_r with r; [| replace (x / r * r) with x by (field; lra)];
            lra); nra]);
    match goal with |- context [atan2 ?v ?u] =>
      assert (square : u * u + v * v = e * rho / ((1 - e) * (1 + e)) * (1 - e * (x / r)) * (e * rho / ((1 - e)
          * (1 + e)) * (1 - e * (x / r))))
        by (remember (sqrt ((1 - e) * (1 + e))) as s eqn:is_s; clear is_s; field [root C]; repeat split; lra);
      assert (off : u * u + v * v > 0) by (rewrite square; now apply Rmult_lt_0_compat);
      rewrite (cos_atan2 v u off), square, sqrt_square by (apply Rlt_le, positive);
      assert (sum : e * rho / ((1 - e) * (1 + e)) * (1 - e * (x / r)) + e * u = e * rho) by (field; repeat
          split; lra);
      remember (e * rho / ((1 - e) * (1 + e)) * (1 - e * (x / r))) as d eqn:is_d; clear is_d square off;
      replace (1 + e * (u / d)) with ((d + e * u) / d) by (generalize u; intro; field; lra); rewrite sum end;
    field; repeat split; lra
  end.
)";

Provable proof_of_solutions() {
  const PointOf<Shortened> p{{0.5, 1}, 1, 0.6, 0.8, 0};
  Lemma holds = on_curve("corrected", distance_on_ellipse(1), orbit_at_angle(1), 0);
  const PointOf<Shortened> any = any_point(0);
  holds.given.push_back(above(any.r.expression(), 0));
  holds.given.push_back(is(any.y * any.y, any.r * any.r - any.x * any.x));
  holds.tactic = "by_anomaly";
  return {
      "3.1-two_solutions",
      "with the plus sign all points of the ellipse are solutions; with the minus sign there is one that is not",
      {holds,
       {.name = "printed_differs",
        .follows = {apart(distance_on_ellipse(-1).recorded(p)[0], orbit_at_angle(-1).recorded(p)[0], 0.4)},
        .tactic = "rewrite cos_atan2 by interval; interval"}},
      0.4,
      atan2_in_coq + anomalies_in_coq};
}

}  // namespace

Provables proofs() {
  Provables all{proof_of_center(), proof_of_other_focus(), proof_of_solutions()};
  std::ranges::move(proofs_of_axes(), std::back_inserter(all));
  for (const Stated& s : table(1).stated) {
    const std::string claim = "3.1-" + s.slug;
    auto found = std::ranges::find(all, claim, &Provable::claim);
    if (found == all.end()) {
      all.push_back({claim, s.on == On::orbit ? "it holds on every orbit"
                                              : "it holds on every orbit and its mirror image"});
      found = all.end() - 1;
    }
    for (Lemma& lemma : lemmas_of(s)) found->lemmas.push_back(std::move(lemma));
  }
  for (Provable& p : all)
    for (const char* slug : {"multiplied", "distance", "origin_is_focus", "other_focus"})
      if (p.claim == "3.1-" + std::string(slug)) p = by_distance(std::move(p));
  return all;
}

}  // namespace ex03_01

Provables proofs_3_1() { return ex03_01::proofs(); }

}  // namespace oddity
