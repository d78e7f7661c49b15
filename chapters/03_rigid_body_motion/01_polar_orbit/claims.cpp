// The claims of exercise 3.1. The published algebra squares twice. It is judged line by line at points
// computed from the polar equation; its result also by what no line of it uses: the sum of the distances to
// the foci, the apsides, the highest point of the orbit (d(r sin theta)/d theta = 0 by dual numbers and
// Brent's method).

#include "chapters/claims.hpp"

#include <cmath>
#include <numbers>

#include "chapters/03_rigid_body_motion/01_polar_orbit/polar_orbit.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/roots.hpp"

namespace oddity::ex03_01 {

using std::abs, std::cos, std::hypot, std::pow, std::sin, std::sqrt, std::numbers::pi;

/// A point of sign 1 lies on the orbit, of sign -1 on the mirror image r = e rho / (1 - e cos theta), of sign
/// 0 anywhere: there only rewritings hold.
struct Point : Ellipse {
  double r, x, y, s;

  std::array<double*, 5> letters() { return {&e, &rho, &r, &x, &y}; }
  std::string where() const {
    return "$e$ = " + format_shortest(e) + R"(, $\rho$ = )" + format_shortest(rho) +
           ", $x$ = " + format_shortest(x) + ", $y$ = " + format_shortest(y) +
           (s > 0   ? ", on the orbit"
            : s < 0 ? ", on its mirror image"
                    : "");
  }

  double nearest() const { return e * rho / (1 + e); }
  double farthest() const { return e * rho / (1 - e); }
  double half_length() const { return (nearest() + farthest()) / 2; }
  double to_middle() const { return (farthest() - nearest()) / 2; }
  /// r sin theta where its derivative is zero.
  double half_height() const {
    const auto height = [&](auto theta) { return orbit(e, rho, theta) * sin(theta); };
    return height(brent([&](double theta) { return derivative(height, theta); }, 0, pi, 1e-15).value);
  }
  double sum_with_focus(double focus) const { return r + hypot(x - focus, y); }

  double r2() const { return s == 0 ? x * x + y * y : r * r; }
  double e4() const { return e * e * e * e; }
  double sum() const { return e * e * (rho * rho + x * x); }
  double difference() const { return e * e * (rho * rho - x * x); }
  double linear() const { return s * 2 * e * e * rho * x; }
  // What is zero on both curves, line by line; `square` is the first of its terms.
  double last() const { return 2 * sum() * r2(); }
  double of_square(double square) const { return square * square + r2() * r2() - last(); }
  double opened(double fourth) const {
    return sum() * sum() - 4 * e4() * x * x * (rho * rho + x * x) + fourth * e4() * pow(x, 4) + r2() * r2() -
           last();
  }
  double gathered(double factor) const {
    return sum() * sum() - factor * e4() * rho * rho * x * x + r2() * r2() - last();
  }
  double closed(double sign) const { return pow(sum() + sign * r2(), 2) - 4 * e4() * rho * rho * x * x; }
  double expanded(double sign) const {
    return pow(difference(), 2) + r2() * r2() - sign * 2 * difference() * r2();
  }
};

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

Value twice(double x) { return {x, x}; }

// ---- line by line -----------------------------------------------------------------------------------------

void to_the_second_squaring(Claims& claims, const std::vector<Point>& orbit_alone,
                            const std::vector<Point>& both) {
  using P = const Point&;
  claims.formula<Point>(
      "multiplied", 857, R"(the polar equation multiplied out, $x=r\cos\theta$)", orbit_alone,
      {.truth = {R"($e\rho$)", [](P p) { return twice(p.e * p.rho); }},
       .printed = {R"($e\rho=r(1+e\cos\theta)=r+ex$)",
                   [](P p) { return values(p.r * (1 + p.e * cos(std::atan2(p.y, p.x))), p.r + p.e * p.x); }},
       .near_misses = {{R"($e\rho=r-ex$)", [](P p) { return twice(p.r - p.e * p.x); }}}});
  const auto squared = [](std::string text, double middle) -> Formula<Point> {
    return {std::move(text),
            [=](P p) { return p.r * p.r + middle * p.e * p.x * p.r + p.e * p.e * p.x * p.x; },
            [](P p) { return p.r * p.r + p.e * p.e * p.x * p.x; }};
  };
  claims.formula<Point>("squared", 861, "its square", orbit_alone,
                        {.truth = {R"($e^2\rho^2$)", [](P p) { return p.e * p.e * p.rho * p.rho; }},
                         .printed = squared(R"($e^2\rho^2=r^2+2exr+e^2x^2$)", 2),
                         .near_misses = {squared(R"($e^2\rho^2=r^2+exr+e^2x^2$)", 1)}});
  claims.formula<Point>(
      "solved", 863, "this solved for the middle term", orbit_alone,
      {.truth = {"$2exr$ at the point", [](P p) { return 2 * p.e * p.x * p.r; }},
       .printed = {R"($2exr=e^2(\rho^2-x^2)-r^2$)", [](P p) { return p.difference() - p.r2(); }},
       .near_misses = {{R"($2exr=e^2(\rho^2+x^2)-r^2$)", [](P p) { return p.sum() - p.r2(); }}}});
  claims.formula<Point>("distance", 865, "$r$ by the coordinates", orbit_alone,
                        {.truth = {"$r$ by the polar equation", [](P p) { return p.r; }},
                         .printed = {R"($\sqrt{x^2+y^2}$)", [](P p) { return sqrt(p.x * p.x + p.y * p.y); }},
                         .near_misses = {{"$|x|+|y|$", [](P p) { return abs(p.x) + abs(p.y); }}}});
  claims.formula<Point>(
      "squared_again", 869, "the square of $2exr$, and its three terms", both,
      {.truth = {"$4e^2x^2r^2$ at the point", [](P p) { return twice(4 * p.e * p.e * p.x * p.x * p.r2()); }},
       .printed = {R"($[e^2(\rho^2-x^2)-r^2]^2=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2-x^2)r^2$)",
                   [](P p) { return values(pow(p.difference() - p.r2(), 2), p.expanded(1)); },
                   [](P p) { return pow(p.difference(), 2) + p.r2() * p.r2(); }},
       .near_misses = {{R"($[e^2(\rho^2-x^2)+r^2]^2=[e^2(\rho^2-x^2)]^2+r^4+2e^2(\rho^2-x^2)r^2$)",
                        [](P p) { return values(pow(p.difference() + p.r2(), 2), p.expanded(-1)); }}}});
}

/// Lines that rewrite the one before: anywhere they equal it, and on both curves they are zero.
void rewritten(Claims& claims, const std::vector<Point>& anywhere, const std::vector<Point>& both) {
  using P = const Point&;
  const auto line = [&](std::string_view slug, int number, std::string says, const Formula<Point>& before,
                        const Formula<Point>& printed, const Formula<Point>& near) {
    const auto reading = [&](Formula<Point> now) -> Reading {
      now.terms = [](P p) { return p.sum() * p.sum() + p.r2() * p.r2(); };
      return {now.text,
              {compare("the line", now, before, anywhere),
               compare<Point>("zero on both curves, its last term set apart",
                              {R"(all terms but $2e^2(\rho^2+x^2)r^2$)",
                               [of = now.of](P p) { return of(p)[0] + p.last(); }},
                              {"that term", [](P p) { return p.last(); }}, both)}};
    };
    claims.add(slug, number, std::move(says), {.printed = reading(printed), .near_misses = {reading(near)}});
  };
  const std::string before = "the line before";
  const auto regrouped = [](double factor) {
    return [=](P p) { return p.of_square(p.sum() - factor * p.e * p.e * p.x * p.x); };
  };
  line(
      "subtracted", 873, "$4e^2x^2r^2$ subtracted from the square",
      {"the line before, less $4e^2x^2r^2$",
       [](P p) { return p.expanded(1) - 4 * p.e * p.e * p.x * p.x * p.r2(); }},
      {R"($0=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)", [](P p) { return p.of_square(p.difference()); }},
      {R"($0=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2-x^2)r^2$)", [](P p) { return p.expanded(1); }});
  line("regrouped", 875, R"($\rho^2-x^2$ regrouped)",
       {before, [](P p) { return p.of_square(p.difference()); }},
       {R"($0=[e^2(\rho^2+x^2-2x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)", regrouped(2)},
       {R"($0=[e^2(\rho^2+x^2-x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)", regrouped(1)});
  const auto opened = [](double fourth) { return [=](P p) { return p.opened(fourth); }; };
  line("opened", 877, "the square opened", {before, regrouped(2)},
       {R"($0=e^4(\rho^2+x^2)^2-4e^4x^2(\rho^2+x^2)+4e^4x^4+r^4-2e^2(\rho^2+x^2)r^2$)", opened(4)},
       {R"($0=e^4(\rho^2+x^2)^2-4e^4x^2(\rho^2+x^2)-4e^4x^4+r^4-2e^2(\rho^2+x^2)r^2$)", opened(-4)});
  const auto gathered = [](double factor) { return [=](P p) { return p.gathered(factor); }; };
  line("gathered", 879, "its terms gathered", {before, opened(4)},
       {R"($0=e^4(\rho^2+x^2)^2-4e^4\rho^2x^2+r^4-2e^2(\rho^2+x^2)r^2$)", gathered(4)},
       {R"($0=e^4(\rho^2+x^2)^2-2e^4\rho^2x^2+r^4-2e^2(\rho^2+x^2)r^2$)", gathered(2)});
  line("closed", 881, "a square completed again", {before, gathered(4)},
       {R"($0=[e^2(\rho^2+x^2)-r^2]^2-4e^4\rho^2x^2$)", [](P p) { return p.closed(-1); }},
       {R"($0=[e^2(\rho^2+x^2)+r^2]^2-4e^4\rho^2x^2$)", [](P p) { return p.closed(1); }});
}

void to_the_ellipse(Claims& claims, const std::vector<Point>& orbit_alone, const std::vector<Point>& both) {
  using P = const Point&;
  claims.formula<Point>("moved", 883, "its last term moved", both,
                        {.truth = {R"($4e^4\rho^2x^2$ at the point)",
                                   [](P p) { return 4 * p.e4() * p.rho * p.rho * p.x * p.x; }},
                         .printed = {R"($4e^4\rho^2x^2=[e^2(\rho^2+x^2)-r^2]^2$)",
                                     [](P p) { return pow(p.sum() - p.r2(), 2); }},
                         .near_misses = {{R"($4e^4\rho^2x^2=[e^2(\rho^2-x^2)-r^2]^2$)",
                                          [](P p) { return pow(p.difference() - p.r2(), 2); }}}});
  claims.formula<Point>(
      "root", 885, "the root of that, with $+$ on the orbit and $-$ on its mirror image", both,
      {.truth = {R"($\pm2e^2\rho x$ at the point)", [](P p) { return p.linear(); }},
       .printed = {R"($\pm2e^2\rho x=e^2(\rho^2+x^2)-r^2$)", [](P p) { return p.sum() - p.r2(); }},
       .near_misses = {{R"($\mp2e^2\rho x=e^2(\rho^2+x^2)-r^2$)", [](P p) { return p.r2() - p.sum(); }}}});

  const auto both_sizes = [](bool squared) {
    return [=](P p) { return twice((squared ? p.e * p.e : 1) * p.rho * p.rho); };
  };
  claims.formula<Point>("collected", 889, "the terms collected", both,
                        {.quantity = R"($(1-e^2)x^2\pm2e^2\rho x+y^2=r^2-e^2x^2\pm2e^2\rho x$)",
                         .truth = {"the two sums at the point",
                                   [](P p) {
                                     return values(p.q() * p.x * p.x + p.linear() + p.y * p.y,
                                                   p.r2() - p.e * p.e * p.x * p.x + p.linear());
                                   }},
                         .printed = {R"($=e^2\rho^2$)", both_sizes(true)},
                         .near_misses = {{R"($=\rho^2$)", both_sizes(false)}}});
  const auto constant = [](double sign) {
    return [=](P p) { return p.e * p.e * p.rho * p.rho / (sign < 0 ? p.q() : 1 + p.e * p.e); };
  };
  claims.formula<Point>("divided", 891, "these divided by $1-e^2$", both,
                        {.quantity = R"($x^2\pm\frac{2e^2\rho}{1-e^2}x+\frac{y^2}{1-e^2}$)",
                         .truth = {"the sum at the point",
                                   [](P p) { return p.x * p.x + p.linear() / p.q() + p.y * p.y / p.q(); }},
                         .printed = {R"($=\frac{e^2\rho^2}{1-e^2}$)", constant(-1)},
                         .near_misses = {{R"($=\frac{e^2\rho^2}{1+e^2}$)", constant(1)}}});
  const auto fourth = [](P p) { return p.e4() * p.rho * p.rho / (p.q() * p.q()); };
  claims.formula<Point>(
      "completed", 905, "the square completed", both,
      {.quantity = R"($\Big(x\pm\frac{e^2\rho}{1-e^2}\Big)^2+\frac{y^2}{1-e^2}$)",
       .truth = {"the sum of squares at the point",
                 [](P p) { return twice(pow(p.x + p.s * p.c(), 2) + p.y * p.y / p.q()); }},
       .printed = {R"($=\frac{e^2\rho^2}{1-e^2}+\frac{e^4\rho^2}{(1-e^2)^2}=\frac{e^2\rho^2}{(1-e^2)^2}$)",
                   [=](P p) {
                     const double square = p.e * p.e * p.rho * p.rho;
                     return values(square / p.q() + fourth(p), square / (p.q() * p.q()));
                   }},
       .near_misses = {{R"($=\frac{e^4\rho^2}{(1-e^2)^2}$)", [=](P p) { return twice(fourth(p)); }}}});
  claims.formula<Point>(
      "axes", 927, "half the length $a$ and half the height $b$ of the orbit", orbit_alone,
      {.truth = {"half the way between the apsides, and the highest point by Brent's method",
                 [](P p) { return values(p.half_length(), p.half_height()); }},
       .printed = {R"($a=e\rho/(1-e^2)$, $b=a\sqrt{1-e^2}$)", [](P p) { return values(p.a(), p.b()); }},
       .near_misses = {
           {R"($a=e\rho/(1-e^2)$, $b=a(1-e^2)$)", [](P p) { return values(p.a(), p.a() * p.q()); }}}});
  claims.formula<Point>("ratio", 929, "$a^2/b^2$", orbit_alone,
                        {.truth = {"the apsides and the highest point by Brent's method",
                                   [](P p) { return pow(p.half_length() / p.half_height(), 2); }},
                         .printed = {"$1/(1-e^2)$", [](P p) { return 1 / p.q(); }},
                         .near_misses = {{"$1/(1+e^2)$", [](P p) { return 1 / (1 + p.e * p.e); }}}});
  claims.formula<Point>(
      "c", 929, "the length $c$", orbit_alone,
      {.truth = {R"(from the origin to the middle of the apsides, $r(0)$ and $r(\pi)$)",
                 [](P p) { return twice(p.to_middle()); }, &Point::farthest},
       .printed = {R"($ae=e^2\rho/(1-e^2)$)", [](P p) { return values(p.a() * p.e, p.c()); }},
       .near_misses = {{"$ae^2$", [](P p) { return twice(p.a() * p.e * p.e); }}}});
  claims.formula<Point>(
      "scaled", 931, R"($(x\pm c)^2+a^2y^2/b^2$)", both,
      {.truth = {"the sum at the point",
                 [](P p) { return pow(p.x + p.s * p.c(), 2) + p.a() * p.a() / (p.b() * p.b()) * p.y * p.y; }},
       .printed = {"$a^2$", [](P p) { return p.a() * p.a(); }},
       .near_misses = {{"$b^2$", [](P p) { return p.b() * p.b(); }}}});
  const auto ellipse = [](double sign) {
    return [=](P p) { return pow((p.x + sign * p.s * p.c()) / p.a(), 2) + p.y * p.y / (p.b() * p.b()); };
  };
  claims.formula<Point>("ellipse", 935, "the ellipse", both,
                        {.truth = {"1", [](P) { return 1.0; }},
                         .printed = {R"($(x\pm c)^2/a^2+y^2/b^2=1$)", ellipse(1)},
                         .near_misses = {{R"($(x\mp c)^2/a^2+y^2/b^2=1$)", ellipse(-1)}}});

  /// A point of the ellipse of this sign in the polar equation.
  const auto fits = [&](double sign) {
    const auto there = [=](P p) { return std::pair(-sign * p.c() + p.a() * p.x / p.r, p.b() * p.y / p.r); };
    return compare<Point>(
        "distance from the origin",
        {sign > 0 ? "points of the ellipse of the plus sign" : "points of the ellipse of the minus sign",
         [=](P p) {
           const auto [x, y] = there(p);
           return hypot(x, y);
         }},
        {"the polar equation at their angles",
         [=](P p) {
           const auto [x, y] = there(p);
           return orbit(p.e, p.rho, std::atan2(y, x));
         }},
        orbit_alone);
  };
  claims.add(
      "two_solutions", 887, "the signs of the root that are solutions",
      {.printed = {"both", {fits(1), fits(-1)}},
       .corrected = {"the plus sign alone", {fits(1)}},
       .near_misses = {{"the minus sign alone", {fits(-1)}}},
       .why =
           R"(The second squaring adds the mirror image $r=e\rho/(1-e\cos\theta)$. Of the ellipse with the )"
           R"(minus sign only the two points $(0,\pm e\rho)$ satisfy the polar equation; the orbit is the )"
           R"(one with the plus sign.)",
       .kind = Fault::counterexample,
       .root = "the mirror image"});
}

// ---- what is said about it --------------------------------------------------------------------------------

void about_the_ellipse(Claims& claims, const std::vector<Point>& samples) {
  using P = const Point&;
  const auto positive = [](std::string text, double factor) -> Statement<Point> {
    return {std::move(text), [=](P p) {
              const Ellipse ellipse{factor * p.e, p.rho};
              return ellipse.a() > 0 && ellipse.b() > 0;
            }};
  };
  claims.statement<Point>("positive", 941, "$a>0$ and $b>0$", samples,
                          {.printed = positive("for $0<e<1$", 1),
                           .near_misses = {positive("for $0<e<1.25$", 1.25), positive("for $e=0$", 0)}});
  const auto at = [](std::string text, double factor) -> Formula<Point> {
    return {std::move(text), [=](P p) { return values(factor * p.c(), 0); }};
  };
  claims.formula<Point>(
      "center", 941, "the center of the ellipse $(x+c)^2/a^2+y^2/b^2=1$", samples,
      {.truth = {"the middle of the apsides", [](P p) { return values(-p.to_middle(), 0); },
                 &Point::farthest},
       .printed = at("$(c,0)$", 1),
       .corrected = at("$(-c,0)$", -1),
       .near_misses = {at("$(-2c,0)$", -2)},
       .kind = Fault::formula,
       .root = "the sign of the center",
       .why =
           R"($(x\pm c)^2$ is zero at $x=\mp c$. The orbit has the plus sign: its center, midway between the )"
           R"(apsides, is $(-c,0)$, away from the perihelion at $\theta=0$.)"});
  const auto axes = [](std::string text, double length, double (*height)(P)) -> Formula<Point> {
    return {std::move(text), [=](P p) { return values(length * p.a(), height(p)); }};
  };
  claims.formula<Point>(
      "major_axis", 941, "the lengths of the major and the minor axis", samples,
      {.truth = {R"($r(0)+r(\pi)$, and twice the highest point by Brent's method)",
                 [](P p) { return values(p.nearest() + p.farthest(), 2 * p.half_height()); }},
       .printed = axes("$a$ and $b$", 1, [](P p) { return p.b(); }),
       .corrected = axes("$2a$ and $2b$", 2, [](P p) { return 2 * p.b(); }),
       .near_misses = {axes("$2a$ and $2a(1-e^2)$", 2, [](P p) { return 2 * p.a() * p.q(); })},
       .kind = Fault::term,
       .root = "axes for semi-axes",
       .why =
           R"($a$ and $b$ are the semi-axes: $r(0)+r(\pi)=2e\rho/(1-e^2)=2a$. (The solution of 3.3 has $2a$ )"
           R"(and $2b$.))"});
  claims.formula<Point>(
      "focal_distance", 943, "the distance from the center to the origin", samples,
      {.truth = {"from the origin to the middle of the apsides", &Point::to_middle, &Point::farthest},
       .printed = {"$c$", [](P p) { return p.c(); }},
       .near_misses = {{"$b$", [](P p) { return p.b(); }}}});
  const Formula<Point> apart{R"($r(0)+r(\pi)$)", [](P p) { return p.nearest() + p.farthest(); }};
  const auto foci = [](std::string text, double other) -> Formula<Point> {
    return {std::move(text), [=](P p) { return p.sum_with_focus(other * p.c()); }};
  };
  claims.formula<Point>("origin_is_focus", 943,
                        "the origin is a focus: with another point it completes a constant sum", samples,
                        {.quantity = "sum of the distances to the two",
                         .truth = apart,
                         .printed = foci("with its mirror in the center, $(-2c,0)$", -2),
                         .near_misses = {foci("with the center, $(-c,0)$", -1)}});
  claims.formula<Point>(
      "other_focus", 943, "the other focus of the ellipse $(x+c)^2/a^2+y^2/b^2=1$", samples,
      {.quantity = "sum of the distances to the two foci",
       .truth = apart,
       .printed = foci("$(2c,0)$", 2),
       .corrected = foci("$(-2c,0)$", -2),
       .near_misses = {foci("$(-c,0)$", -1)},
       .kind = Fault::formula,
       .root = "the sign of the center",
       .why =
           R"(The distances to the origin and $(2c,0)$ add up to $2a+4c$ at the aphelion and, for $e<1/3$, to )"
           R"($2a-4c$ at the perihelion; those to the origin and $(-2c,0)$ add up to $2a$ everywhere.)"});
}

std::vector<Claim> claims(double seed) {
  Claims all("3.1");
  const auto orbit_alone = points(seed, On::orbit), both = points(seed, On::both);
  to_the_second_squaring(all, orbit_alone, both);
  rewritten(all, points(seed, On::anywhere), both);
  to_the_ellipse(all, orbit_alone, both);
  about_the_ellipse(all, orbit_alone);
  return all.in_order();
}

std::vector<Root> roots() {
  return {
      {"the mirror image",
       R"(For $e=0.625$, $\rho=1.5$ the minus sign puts the planet 2.5 from the sun at $\theta=0$, where it )"
       R"(should be at its nearest, 0.577.)"},
      {"the sign of the center",
       R"(An ellipse drawn about $(c,0)$ has the sun in the wrong focus: for $e=0.625$, $\rho=1.5$ its perihelion is )"
       R"(1.92 too far out, at 2.5 instead of 0.577.)"},
      {"axes for semi-axes",
       R"(Drawn with a major axis of length $a$ the orbit is half as large: for $e=0.625$, $\rho=1.5$ it is 1.54 long )"
       R"(instead of 3.08.)"}};
}

}  // namespace oddity::ex03_01
