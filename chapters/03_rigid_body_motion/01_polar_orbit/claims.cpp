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
  PointOf<Shortened> recorded() const { return {{e, rho}, r, x, y, s}; }
  TypesetIn<T> typeset() const {
    return {{"e", e},         {R"(\rho)", rho}, {"r", r},
            {"x", x},         {"y", y},         {R"(\theta)", atan2(y, x)},
            {"a", this->a()}, {"b", this->b()}, {"c", this->c()},
            {R"(\pm)", s}};
  }
  std::string where() const {
    return listed(typeset(), 5) + (s > 0 ? ", on the orbit" : s < 0 ? ", on its mirror image" : "");
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

/// Points with these signs in turn.
std::vector<Point> points(double seed, const std::vector<double>& signs) {
  Random random(seed);
  std::vector<Point> all;
  for (int i = 0; i < 200; ++i) {
    const double e = i % 8 < 2   ? abs(random.magnitude(1e-6, 1))
                     : i % 8 < 4 ? 1 - abs(random.magnitude(1e-4, 1))
                                 : random.between(0.05, 0.95);
    const double rho = abs(random.magnitude(0.1, 10)) / e, theta = random.between(-pi, pi),
                 s = signs[static_cast<std::size_t>(i) % signs.size()];
    const double r = s == 0 ? abs(random.magnitude(0.1, 10)) : orbit(s * e, s * rho, theta);
    all.push_back({{e, rho}, r, r * cos(theta), r * sin(theta), s});
  }
  return all;
}

// ---- line by line -----------------------------------------------------------------------------------------

const Line zero{"zero", []<class T>(const PointOf<T>&) { return T(0); }};

/// Claims about the points of a curve.
struct Curve : ProvableClaims<PointOf> {
  std::vector<Point> points;

  explicit Curve(Claims& claims, std::vector<Point> on = {})
      : ProvableClaims(claims), points(std::move(on)) {}
  auto over_points() { return over(points); }
  /// Claims a line of the page at points from the polar equation: two sides are equal, or the first equals
  /// each of several. `first` is an independent route to the first side.
  void equation(std::string_view slug, int line, const std::string& before, const std::string& text,
                const std::string& after = {}, const Line& first = {}) {
    const auto [left, right] = sides_of_equation(text);
    const bool two = formula::sides_of(text.substr(1, text.size() - 2)).sides.size() == 2;
    over_points()(slug, line, before + text + after,
                  !first.text.empty() ? first
                  : two               ? zero
                                      : Line(left),
                  two ? text : right, two ? "" : left);
  }
};

/// `zeros` has lines of `anywhere` again, which are zero on both curves.
struct Curves {
  Claims claims{"3.1"}, unused{"3.1"};
  Curve orbit, both, anywhere, top, zeros;

  explicit Curves(double seed)
      : orbit(claims, points(seed, {1})),
        both(claims, points(seed, {1, -1, -1})),
        anywhere(claims, points(seed, {0})),
        top(claims, orbit.points),
        zeros(unused) {
    anywhere.points.insert(anywhere.points.end(), both.points.begin(), both.points.end());
  }
};

void to_the_second_squaring(Curves& t) {
  t.orbit.equation("multiplied", 857, R"(Multiplied by its denominator, with $x=r\cos\theta$: )",
                   R"($e\rho=r(1+e\cos\theta)=r+ex$)");
  t.orbit.equation("squared", 861, "Squared: ", R"($e^2\rho^2=r^2+2exr+e^2x^2$)");
  t.orbit.equation("solved", 863, "Solved for the middle term: ", R"($2exr=e^2(\rho^2-x^2)-r^2$)");
  t.orbit.equation("distance", 865, "", R"($r=\sqrt{x^2+y^2}$)", "",
                   {"$r$ by the polar equation", [](const auto& p) { return p.r; }});
  t.both.equation(
      "squared_again", 869, "Squared again: ",
      R"($4e^2x^2r^2=[e^2(\rho^2-x^2)-r^2]^2=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2-x^2)r^2$)", "",
      {"$4e^2x^2r^2$ at the point", [](const auto& p) { return 4 * pow(p.e * p.x * p.r, 2); },
       [](const Point& p) { return pow(p.e * p.e * (p.rho * p.rho - p.x * p.x), 2) + pow(p.r, 4); }});
}

/// Lines that rewrite the one before: everywhere they are one product, which is zero on both curves.
void rewritten(Curves& t) {
  const Line both_curves = R"($(e^2\rho^2-(r+ex)^2)(e^2\rho^2-(r-ex)^2)$)";
  const auto line = [&](std::string_view slug, int number, const std::string& before,
                        const std::string& text) {
    t.anywhere.over_points()(slug, number, before + text, both_curves, text, "the line, zero on both curves");
    t.zeros.over_points()(slug, number, text, zero, text);
  };
  line("subtracted", 873, "$4e^2x^2r^2$ subtracted: ", R"($0=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)");
  line("regrouped", 875, "", R"($0=[e^2(\rho^2+x^2)-2e^2x^2]^2+r^4-2e^2(\rho^2+x^2)r^2$)");
  line("opened", 877, "The square opened: ",
       R"($0=[e^2(\rho^2+x^2)]^2-4e^4x^2(\rho^2+x^2)+4e^4x^4+r^4-2e^2(\rho^2+x^2)r^2$)");
  line("gathered", 879,
       "Its terms gathered: ", R"($0=[e^2(\rho^2+x^2)]^2-4e^4\rho^2x^2+r^4-2e^2(\rho^2+x^2)r^2$)");
  line("closed", 881, "A square completed again: ", R"($0=[e^2(\rho^2+x^2)-r^2]^2-4e^4\rho^2x^2$)");
}

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

void to_the_ellipse(Curves& t) {
  t.both.equation("moved", 883, "", R"($4e^4\rho^2x^2=[e^2(\rho^2+x^2)-r^2]^2$)");
  t.both.equation("root", 885, "", R"($\pm2e^2\rho x=e^2(\rho^2+x^2)-r^2$)",
                  " (our reading, here and below: $+$ on the orbit, $-$ on its mirror image)");
  t.both.equation("collected", 889, "", R"($(1-e^2)x^2\pm2e^2\rho x+y^2=r^2-e^2x^2\pm2e^2\rho x=e^2\rho^2$)");
  t.both.equation("divided", 893, "Divided by $1-e^2$ (our condition: $0<e<1$): ",
                  R"($x^2\pm\frac{2e^2\rho}{1-e^2}x+\frac{y^2}{1-e^2}=\frac{e^2\rho^2}{1-e^2}$)");
  t.both.equation("completed", 905, "The square completed: ",
                  R"($\left(x\pm\frac{e^2\rho}{1-e^2}\right)^2+\frac{y^2}{1-e^2})"
                  R"(=\frac{e^2\rho^2}{1-e^2}+\frac{e^4\rho^2}{(1-e^2)^2}=\frac{e^2\rho^2}{(1-e^2)^2}$)");
  const auto of_top = t.top.over_points();
  of_top(
      "axes", 927,
      R"(The book defines $a=e\rho/(1-e^2)$ and $b=a\sqrt{1-e^2}$ (our check: they are half the length and half )"
      R"(the height of the orbit).)",
      {"half the way between the apsides, and the highest point by Brent's method",
       [](const auto& p) { return values(p.half_length(), p.half_height()); }},
      R"($(e\rho/(1-e^2),\ a\sqrt{1-e^2})$)");
  of_top("ratio", 929, "$a^2/b^2=1/(1-e^2)$",
         {"the apsides and the highest point by Brent's method",
          [](const auto& p) { return pow(p.half_length() / p.half_height(), 2); }},
         "$1/(1-e^2)$");
  t.orbit.equation("c", 929, "", R"($c=ae=e^2\rho/(1-e^2)$)", "", to_middle_of_apsides);
  t.both.equation("scaled", 931, "", R"($(x\pm c)^2+(a^2/b^2)y^2=a^2$)");
  t.both.equation("ellipse", 935, "", R"($(x\pm c)^2/a^2+y^2/b^2=1$)",
                  ", the standard formula of an ellipse along the axes");

  const auto fits = [&](double sign) {
    return compare<Point>("distance from the origin", distance_on_ellipse(sign), orbit_at_angle(sign),
                          t.orbit.points);
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

const Point shown{{0.625, 1.5}, 0, 0, 0, 1};

const Line all_apart{R"($r(0)+r(\pi)$)", [](const auto& p) { return p.nearest() + p.farthest(); }};
void about_the_ellipse(Curves& t) {
  t.claims.statement<Point>(
      "positive", 941,
      "The ellipse has $a>0$ and $b>0$ (our condition: $0<e<1$; for $e=0$ the polar equation "
      "is $r=0$, and from $e=1$ on its curve is no ellipse).",
      t.orbit.points, {.printed = {"$(a,b)>0$"}, .near_misses = {{R"($(a-\rho,b)>0$)"}, {"$(a,b-c)>0$"}}});
  t.both.over_points()(
      "center", 941, R"(The center of the ellipse $(x\pm c)^2/a^2+y^2/b^2=1$ is $(\pm c,0)$.)",
      {.quantity = R"(the center of the orbit or of its mirror image)",
       .truth = {"the middle of the apsides",
                 [](const auto& p) { return values((p.at_zero() - p.at_pi()) / 2, 0); }, &Point::farthest},
       .printed = R"($(\pm c,0)$)",
       .corrected = R"($(\mp c,0)$)",
       .root = "the sign of the center",
       .why =
           R"($(x\pm c)^2$ is zero at $x=\mp c$. The orbit has the plus sign: its center, midway between the )"
           R"(apsides, is $(-c,0)$, away from the perihelion at $\theta=0$.)"});
  t.top.over_points()(
      "major_axis", 941, "The length of the major axis is $a$, that of the minor axis $b$.",
      {.truth = {R"($r(0)+r(\pi)$, and twice the highest point by Brent's method)",
                 [](const auto& p) { return values(p.nearest() + p.farthest(), 2 * p.half_height()); }},
       .printed = "$(a,b)$",
       .corrected = "$(2a,2b)$",
       .kind = Fault::term,
       .root = "axes for semi-axes",
       .why =
           R"($a$ and $b$ are the semi-axes: $r(0)+r(\pi)=2e\rho/(1-e^2)=2a$. (The solution of 3.3 has $2a$ )"
           R"(and $2b$.))"});
  const auto of_orbit = t.orbit.over_points();
  of_orbit("focal_distance", 943,
           "The distance from the center to a focus is $c$: the origin has this distance from the center.",
           to_middle_of_apsides, "$c$");
  of_orbit("origin_is_focus", 943,
           "The origin is a focal point: the distances to it and to another point have a constant sum.",
           all_apart, R"($r+\sqrt{(x+2c)^2+y^2}$)", "sum of the distances to the origin and $(-2c,0)$");
  t.both.over_points()(
      "other_focus", 943, R"(The other focal point is $(\pm2c,0)$.)",
      {.quantity = R"(sum of the distances to the origin and the other focus)",
       .truth = all_apart,
       .printed = R"($r+\sqrt{(x\mp2c)^2+y^2}$)",
       .corrected = R"($r+\sqrt{(x\pm2c)^2+y^2}$)",
       .root = "the sign of the center",
       .why = filled(
           R"(For $e=@3$, $\rho=@2$ the distances to the origin and $(2c,0)$ add up to @3 at the aphelion. Those )"
           R"(to the origin and $(-2c,0)$ add up to $2a$ there and everywhere, which is @3.)",
           {shown.e, shown.rho, 2 * (shown.farthest() + shown.c()), 2 * shown.half_length()})});
}

void claim(Curves& t) {
  to_the_second_squaring(t);
  rewritten(t);
  to_the_ellipse(t);
  about_the_ellipse(t);
}

std::vector<Claim> claims(double seed) {
  Curves t(seed);
  claim(t);
  return t.claims.in_order();
}

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

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

/// A point with r from the polar equation of its curve.
PointOf<Shortened> any_point(double sign) {
  const auto letter = Shortened::letter;
  PointOf<Shortened> p{{letter("e"), letter("rho")}, letter("r"), letter("x"), letter("y"), sign};
  if (sign != 0) p.r = p.e * p.rho - sign * p.e * p.x;
  return p;
}

Proposition is(const Shortened& left, const Shortened& right) {
  return left.expression() == right.expression();
}

std::vector<Proposition> orbits(const PointOf<Shortened>& p) { return positive({p.e, 1 - p.e, p.rho}); }

/// For the orbit, its mirror image, or any point if the sign is 0. The example is the farthest point.
ForAll<PointOf> on_curve(double sign, const std::string& says) {
  const PointOf<Shortened> p = any_point(sign);
  ForAll<PointOf> all{.any = p,
                      .letters = "(e rho r x y : R)",
                      .given = orbits(p),
                      .tactic = "field; repeat split; lra",
                      .says = says,
                      .example = {{0.5, 1}, 1, -1, 0, 1},
                      .preamble = coq_source({"distances"})};
  if (sign == 0) return all;
  all.given.push_back(is(p.y * p.y, p.r * p.r - p.x * p.x));
  all.tactic = "by_squares";
  return all;
}

/// The height has no slope at this angle, which is above the axis.
std::vector<Proposition> is_top(const PointOf<Shortened>& p, const Shortened& top) {
  return {above(top.expression(), 0), above((pi_of<Shortened>() - top).expression(), 0),
          is(p.slope_of_height(top), 0)};
}

ForAll<PointOf> at_the_top(const std::string& says) {
  const PointOf<Shortened> p = any_point(0);
  ForAll<PointOf> all{.any = p,
                      .letters = "(e rho top : R)",
                      .given = orbits(p),
                      .tactic = "by_height",
                      .says = says,
                      .example = {{0.5, 1}, 0, 0, 0, 1},
                      .preamble = coq_source({"heights"})};
  for (const Proposition& one : is_top(p, Shortened::letter("top"))) all.given.push_back(one);
  return all;
}

/// Proves that there is a highest point.
Lemma top_there_is() {
  const PointOf<Shortened> p = any_point(0);
  const Shortened top = acos(-p.e), angle = Shortened::letter("theta");
  Lemma all{"highest", "(e rho theta : R)", orbits(p), is_top(p, top), "by_top"};
  all.follows.push_back({p.height(angle).expression().coq() + " <= " + p.height(top).expression().coq()});
  return all;
}

Provable proof_of_solutions() {
  const PointOf<Shortened> p{{0.5, 1}, 1, 0.6, 0.8, 0};
  const PointOf<Shortened> any = any_point(0);
  Lemma holds{"corrected", "(e rho r x y : R)", orbits(any),
              equal(distance_on_ellipse(1).recorded(any), orbit_at_angle(1).recorded(any)), "by_anomaly"};
  holds.given.push_back(above(any.r.expression(), 0));
  holds.given.push_back(is(any.y * any.y, any.r * any.r - any.x * any.x));
  return {
      "3.1-two_solutions",
      "with the plus sign all points of the ellipse are solutions; with the minus sign there is one that is not",
      {holds,
       {.name = "printed_differs",
        .follows = {apart(distance_on_ellipse(-1).recorded(p)[0], orbit_at_angle(-1).recorded(p)[0], 0.4)},
        .tactic = "rewrite cos_atan2 by interval; interval"}},
      0.4,
      coq_source({"anomalies"})};
}

}  // namespace

Provables proofs() {
  Curves t(1);
  claim(t);
  Provables all{proof_of_solutions()};
  const auto add = [&](Provables more, const char* lemma = "") {
    for (Provable& one : more) {
      const auto known = std::ranges::find(all, one.claim, &Provable::claim);
      if (known == all.end()) {
        all.push_back(std::move(one));
      } else {
        one.lemmas[0].name = lemma;
        known->says = one.says;
        known->lemmas.push_back(std::move(one.lemmas[0]));
      }
    }
  };
  const std::string on_orbits = "it holds on every orbit", on_both = on_orbits + " and its mirror image";
  add(t.orbit.proofs("3.1", on_curve(1, on_orbits)));
  add(t.anywhere.proofs("3.1", on_curve(0, on_both)));
  for (const Curve* curve : {&t.both, &t.zeros}) {
    add(curve->proofs("3.1", on_curve(1, on_both)), "orbit");
    add(curve->proofs("3.1", on_curve(-1, on_both)), "mirror_image");
  }
  add(t.top.proofs("3.1", at_the_top(on_orbits)));
  add({{"3.1-axes", on_orbits + ", and every orbit has a highest point", {top_there_is()}}}, "highest");
  for (const char* slug : {"multiplied", "distance", "origin_is_focus", "other_focus"}) {
    for (Lemma& lemma : proof_of(all, "3.1-" + std::string(slug)).lemmas)
      if (lemma.tactic != "interval")
        lemma.tactic = lemma.name == "mirror_image" ? "by_mirrored_distance" : "by_distance";
  }
  return all;
}

}  // namespace oddity::ex03_01
