// The claims of exercise 3.1. The published algebra squares twice. It is judged line by line at points
// computed from the polar equation; its result also by what no line of it uses: the sum of the distances to
// the foci, the apsides, the highest point of the orbit (d(r sin theta)/d theta = 0 by dual numbers and
// Brent's method).

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>
#include <type_traits>

#include "chapters/02_basic_concepts/shared/recorded_functions.hpp"
#include "chapters/03_rigid_body_motion/01_polar_orbit/polar_orbit.hpp"
#include "chapters/claims.hpp"
#include "chapters/recorded.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/roots.hpp"

namespace oddity::ex03_01 {

using std::abs, std::atan2, std::cos, std::hypot, std::pow, std::sin, std::sqrt, std::numbers::pi;

inline Expression hypot(const Expression& x, const Expression& y) { return sqrt(x * x + y * y); }
inline Expression atan2(const Expression& y, const Expression& x) {
  return oddity::atan2(Shortened(y), Shortened(x)).expression();
}

/// A point of sign 1 lies on the orbit, of sign -1 on the mirror image r = e rho / (1 - e cos theta), of sign
/// 0 anywhere: there only rewritings hold.
template <class T>
struct PointOf : EllipseOf<T> {
  using EllipseOf<T>::e, EllipseOf<T>::rho;
  T r, x, y;
  double s;

  std::array<T*, 5> letters() { return {&e, &rho, &r, &x, &y}; }
  TypesetLetters typeset() const {
    const T a = e * rho / (1 - e * e);
    return {{"e", e},     {R"(\rho)", rho},
            {"r", r},     {"x", x},
            {"y", y},     {R"(\theta)", std::atan2(y, x)},
            {"a", a},     {"b", a * sqrt(1 - e * e)},
            {"c", a * e}, {R"(\pm)", s}};
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
  T half_length() const { return (nearest() + farthest()) / 2; }
  T to_middle() const { return (farthest() - nearest()) / 2; }
  template <class Angle>
  Angle height(const Angle& theta) const {
    return orbit(e, rho, theta) * sin(theta);
  }
  T slope_of_height(const T& theta) const {
    return derivative([&](const auto& angle) { return height(angle); }, theta);
  }
  /// r sin theta where its derivative is zero, which proofs have at the angle `top`.
  T half_height() const {
    if constexpr (std::same_as<T, Expression>)
      return height(T::letter("top"));
    else
      return height(brent([&](const T& theta) { return slope_of_height(theta); }, 0, pi, 1e-15).value);
  }
  T sum_with_focus(const T& focus) const { return r + hypot(x - focus, y); }

  T r2() const { return s == 0 ? x * x + y * y : r * r; }
  T e4() const { return e * e * e * e; }
  T sum() const { return e * e * (rho * rho + x * x); }
  T difference() const { return e * e * (rho * rho - x * x); }
  T linear() const { return s * 2 * e * e * rho * x; }
  // What is zero on both curves, line by line; `square` is the first of its terms.
  T last() const { return 2 * sum() * r2(); }
  T of_square(const T& square) const { return square * square + r2() * r2() - last(); }
  T opened(double fourth) const {
    return sum() * sum() - 4 * e4() * x * x * (rho * rho + x * x) + fourth * e4() * pow(x, 4) + r2() * r2() -
           last();
  }
  T gathered(double factor) const {
    return sum() * sum() - factor * e4() * rho * rho * x * x + r2() * r2() - last();
  }
  T closed(double sign) const { return pow(sum() + sign * r2(), 2) - 4 * e4() * rho * rho * x * x; }
  T expanded(double sign) const {
    return pow(difference(), 2) + r2() * r2() - sign * 2 * difference() * r2();
  }
};
using Point = PointOf<double>;
using Line = Recorded<PointOf>;

Line written(std::string text, const auto& of, std::function<double(const Point&)> terms = {}) {
  Line made = recorded<PointOf>(std::move(text), of);
  made.terms = std::move(terms);
  return made;
}

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

template <class T>
std::array<T, 2> twice(const T& x) {
  return {x, x};
}
template <class T>
std::array<T, 2> two(const T& x, const std::type_identity_t<T>& y) {
  return {x, y};
}

// ---- line by line -----------------------------------------------------------------------------------------

/// Two sides of a line that are equal on a curve.
struct Stated {
  std::string slug;
  On on;
  Line printed, truth;
};

/// The claims, and those of their lines that can be proved.
struct Table {
  double seed;
  Claims claims{"3.1"};
  std::vector<Point> orbit_alone = points(seed, On::orbit), both = points(seed, On::both),
                     anywhere = points(seed, On::anywhere);
  std::vector<Stated> stated = {};

  void line(const std::string& slug, int at, std::string says, On on, const Line& truth, const Line& printed,
            const Line& near, std::string quantity = {}) {
    stated.push_back({slug, on, printed, truth});
    claims.formula<Point>(
        slug, at, std::move(says), on == On::orbit ? orbit_alone : both,
        {.quantity = std::move(quantity), .truth = truth, .printed = printed, .near_misses = {near}});
  }
};

void to_the_second_squaring(Table& t) {
  t.line("multiplied", 857,
         R"(Multiplied by its denominator, with $x=r\cos\theta$: $e\rho=r(1+e\cos\theta)=r+ex$)", On::orbit,
         written(R"($e\rho$)", [](const auto& p) { return twice(p.e * p.rho); }),
         written(R"($e\rho=r(1+e\cos\theta)=r+ex$)",
                 [](const auto& p) { return two(p.r * (1 + p.e * cos(atan2(p.y, p.x))), p.r + p.e * p.x); }),
         written(R"($r-ex$)", [](const auto& p) { return twice(p.r - p.e * p.x); }));
  const auto squared = [](std::string text, double middle) {
    return written(
        std::move(text),
        [=](const auto& p) { return p.r * p.r + middle * p.e * p.x * p.r + p.e * p.e * p.x * p.x; },
        [](const Point& p) { return p.r * p.r + p.e * p.e * p.x * p.x; });
  };
  t.line("squared", 861, R"(Squared: $e^2\rho^2=r^2+2exr+e^2x^2$)", On::orbit,
         written(R"($e^2\rho^2$)", [](const auto& p) { return p.e * p.e * p.rho * p.rho; }),
         squared(R"($e^2\rho^2=r^2+2exr+e^2x^2$)", 2), squared(R"($e^2\rho^2=r^2+exr+e^2x^2$)", 1));
  t.line("solved", 863, R"(Solved for the middle term: $2exr=e^2(\rho^2-x^2)-r^2$)", On::orbit,
         written("$2exr$ at the point", [](const auto& p) { return 2 * p.e * p.x * p.r; }),
         written(R"($2exr=e^2(\rho^2-x^2)-r^2$)", [](const auto& p) { return p.difference() - p.r2(); }),
         written(R"($2exr=e^2(\rho^2+x^2)-r^2$)", [](const auto& p) { return p.sum() - p.r2(); }));
  t.line("distance", 865, R"($r=\sqrt{x^2+y^2}$)", On::orbit,
         written("$r$ by the polar equation", [](const auto& p) { return p.r; }),
         written(R"($\sqrt{x^2+y^2}$)", [](const auto& p) { return sqrt(p.x * p.x + p.y * p.y); }),
         written("$|x|+|y|$", [](const auto& p) { return abs(p.x) + abs(p.y); }));
  t.line("squared_again", 869,
         R"(Squared again: $4e^2x^2r^2=[e^2(\rho^2-x^2)-r^2]^2=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2-x^2)r^2$)",
         On::both,
         written("$4e^2x^2r^2$ at the point",
                 [](const auto& p) { return twice(4 * p.e * p.e * p.x * p.x * p.r2()); }),
         written(R"($[e^2(\rho^2-x^2)-r^2]^2=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2-x^2)r^2$)",
                 [](const auto& p) { return two(pow(p.difference() - p.r2(), 2), p.expanded(1)); },
                 [](const Point& p) { return pow(p.difference(), 2) + p.r2() * p.r2(); }),
         written(R"($[e^2(\rho^2-x^2)+r^2]^2=[e^2(\rho^2-x^2)]^2+r^4+2e^2(\rho^2-x^2)r^2$)",
                 [](const auto& p) { return two(pow(p.difference() + p.r2(), 2), p.expanded(-1)); }));
}

/// Lines that rewrite the one before: anywhere they equal it, and on both curves they are zero.
void rewritten(Table& t) {
  const Line nothing = written("0", [](const auto& p) { return 0 * p.e; });
  const auto line = [&](const std::string& slug, int number, std::string says, const Line& before,
                        const Line& printed, const Line& near) {
    t.stated.push_back({slug, On::anywhere, printed, before});
    t.stated.push_back({slug, On::both, printed, nothing});
    const auto reading = [&](Formula<Point> now) -> Reading {
      now.terms = [](const auto& p) { return p.sum() * p.sum() + p.r2() * p.r2(); };
      const bool read = is_as_typeset(compare_typeset(now, t.anywhere));
      return {now.text,
              {compare<Point>("the line", now, before, t.anywhere),
               compare<Point>("zero on both curves, its last term set apart",
                              {R"(all terms but $2e^2(\rho^2+x^2)r^2$)",
                               [of = now.of](const auto& p) { return of(p)[0] + p.last(); }},
                              {"that term", [](const auto& p) { return p.last(); }}, t.both)},
              read};
    };
    t.claims.add(slug, number, std::move(says),
                 {.printed = reading(printed), .near_misses = {reading(near)}});
  };
  const std::string before = "the line before";
  const auto regrouped = [](double factor) {
    return [=](const auto& p) { return p.of_square(p.sum() - factor * p.e * p.e * p.x * p.x); };
  };
  line("subtracted", 873, R"($4e^2x^2r^2$ subtracted: $0=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)",
       written("the line before, less $4e^2x^2r^2$",
               [](const auto& p) { return p.expanded(1) - 4 * p.e * p.e * p.x * p.x * p.r2(); }),
       written(R"($0=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)",
               [](const auto& p) { return p.of_square(p.difference()); }),
       written(R"($0=[e^2(\rho^2-x^2)]^2+r^4-2e^2(\rho^2-x^2)r^2$)",
               [](const auto& p) { return p.expanded(1); }));
  line("regrouped", 875, R"($0=[e^2(\rho^2+x^2)-2e^2x^2]^2+r^4-2e^2(\rho^2+x^2)r^2$)",
       written(before, [](const auto& p) { return p.of_square(p.difference()); }),
       written(R"($0=[e^2(\rho^2+x^2-2x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)", regrouped(2)),
       written(R"($0=[e^2(\rho^2+x^2-x^2)]^2+r^4-2e^2(\rho^2+x^2)r^2$)", regrouped(1)));
  const auto opened = [](double fourth) { return [=](const auto& p) { return p.opened(fourth); }; };
  line("opened", 877,
       R"(The square opened: $0=[e^2(\rho^2+x^2)]^2-4e^4x^2(\rho^2+x^2)+4e^4x^4+r^4-2e^2(\rho^2+x^2)r^2$)",
       written(before, regrouped(2)),
       written(R"($0=e^4(\rho^2+x^2)^2-4e^4x^2(\rho^2+x^2)+4e^4x^4+r^4-2e^2(\rho^2+x^2)r^2$)", opened(4)),
       written(R"($0=e^4(\rho^2+x^2)^2-4e^4x^2(\rho^2+x^2)-4e^4x^4+r^4-2e^2(\rho^2+x^2)r^2$)", opened(-4)));
  const auto gathered = [](double factor) { return [=](const auto& p) { return p.gathered(factor); }; };
  line("gathered", 879,
       R"(Its terms gathered: $0=[e^2(\rho^2+x^2)]^2-4e^4\rho^2x^2+r^4-2e^2(\rho^2+x^2)r^2$)",
       written(before, opened(4)),
       written(R"($0=e^4(\rho^2+x^2)^2-4e^4\rho^2x^2+r^4-2e^2(\rho^2+x^2)r^2$)", gathered(4)),
       written(R"($0=e^4(\rho^2+x^2)^2-2e^4\rho^2x^2+r^4-2e^2(\rho^2+x^2)r^2$)", gathered(2)));
  line("closed", 881, R"(A square completed again: $0=[e^2(\rho^2+x^2)-r^2]^2-4e^4\rho^2x^2$)",
       written(before, gathered(4)),
       written(R"($0=[e^2(\rho^2+x^2)-r^2]^2-4e^4\rho^2x^2$)", [](const auto& p) { return p.closed(-1); }),
       written(R"($0=[e^2(\rho^2+x^2)+r^2]^2-4e^4\rho^2x^2$)", [](const auto& p) { return p.closed(1); }));
}

const Line half_sizes = written("half the way between the apsides, and the highest point by Brent's method",
                                [](const auto& p) { return two(p.half_length(), p.half_height()); });
const Line semi_axes =
    written(R"($a=e\rho/(1-e^2)$, $b=a\sqrt{1-e^2}$)", [](const auto& p) { return two(p.a(), p.b()); });
const Line square_of_sizes = written("the apsides and the highest point by Brent's method",
                                     [](const auto& p) { return pow(p.half_length() / p.half_height(), 2); });
const Line square_of_axes = written("$1/(1-e^2)$", [](const auto& p) { return 1 / p.q(); });

/// The ellipse's point at the eccentric anomaly of which x/r is the cosine.
template <class T>
std::array<T, 2> on_ellipse(const PointOf<T>& p, double sign) {
  return {-sign * p.c() + p.a() * p.x / p.r, p.b() * p.y / p.r};
}
Line distance_on_ellipse(double sign) {
  return written(
      sign > 0 ? "points of the ellipse of the plus sign" : "points of the ellipse of the minus sign",
      [=](const auto& p) { return hypot(on_ellipse(p, sign)[0], on_ellipse(p, sign)[1]); });
}
Line orbit_at_angle(double sign) {
  return written("the polar equation at their angles", [=](const auto& p) {
    return orbit(p.e, p.rho, atan2(on_ellipse(p, sign)[1], on_ellipse(p, sign)[0]));
  });
}

void to_the_ellipse(Table& t) {
  t.line("moved", 883, R"($4e^4\rho^2x^2=[e^2(\rho^2+x^2)-r^2]^2$)", On::both,
         written(R"($4e^4\rho^2x^2$ at the point)",
                 [](const auto& p) { return 4 * p.e4() * p.rho * p.rho * p.x * p.x; }),
         written(R"($4e^4\rho^2x^2=[e^2(\rho^2+x^2)-r^2]^2$)",
                 [](const auto& p) { return pow(p.sum() - p.r2(), 2); }),
         written(R"($4e^4\rho^2x^2=[e^2(\rho^2-x^2)-r^2]^2$)",
                 [](const auto& p) { return pow(p.difference() - p.r2(), 2); }));
  t.line("root", 885, R"($\pm2e^2\rho x=e^2(\rho^2+x^2)-r^2$ ($+$ on the orbit, $-$ on its mirror image))",
         On::both, written(R"($\pm2e^2\rho x$ at the point)", [](const auto& p) { return p.linear(); }),
         written(R"($\pm2e^2\rho x=e^2(\rho^2+x^2)-r^2$)", [](const auto& p) { return p.sum() - p.r2(); }),
         written(R"($\mp2e^2\rho x=e^2(\rho^2+x^2)-r^2$)", [](const auto& p) { return p.r2() - p.sum(); }));

  const auto both_sizes = [](std::string text, bool squared) {
    return written(std::move(text),
                   [=](const auto& p) { return twice((squared ? p.e * p.e : 1) * p.rho * p.rho); });
  };
  t.line("collected", 889, R"($(1-e^2)x^2\pm2e^2\rho x+y^2=r^2-e^2x^2\pm2e^2\rho x=e^2\rho^2$)", On::both,
         written("the two sums at the point",
                 [](const auto& p) {
                   return two(p.q() * p.x * p.x + p.linear() + p.y * p.y,
                              p.r2() - p.e * p.e * p.x * p.x + p.linear());
                 }),
         both_sizes(R"($=e^2\rho^2$)", true), both_sizes(R"($=\rho^2$)", false),
         R"($(1-e^2)x^2\pm2e^2\rho x+y^2=r^2-e^2x^2\pm2e^2\rho x$)");
  const auto constant = [](std::string text, double sign) {
    return written(std::move(text), [=](const auto& p) {
      return p.e * p.e * p.rho * p.rho / (sign < 0 ? p.q() : 1 + p.e * p.e);
    });
  };
  t.line("divided", 891,
         R"(Divided by $1-e^2$: $x^2\pm\frac{2e^2\rho}{1-e^2}x+\frac{y^2}{1-e^2}=\frac{e^2\rho^2}{1-e^2}$)",
         On::both,
         written("the sum at the point",
                 [](const auto& p) { return p.x * p.x + p.linear() / p.q() + p.y * p.y / p.q(); }),
         constant(R"($=\frac{e^2\rho^2}{1-e^2}$)", -1), constant(R"($=\frac{e^2\rho^2}{1+e^2}$)", 1),
         R"($x^2\pm\frac{2e^2\rho}{1-e^2}x+\frac{y^2}{1-e^2}$)");
  const auto fourth = [](const auto& p) { return p.e4() * p.rho * p.rho / (p.q() * p.q()); };
  t.line(
      "completed", 905,
      R"(The square completed: $\left(x\pm\frac{e^2\rho}{1-e^2}\right)^2+\frac{y^2}{1-e^2}=\frac{e^2\rho^2}{(1-e^2)^2}$)",
      On::both,
      written("the sum of squares at the point",
              [](const auto& p) { return twice(pow(p.x + p.s * p.c(), 2) + p.y * p.y / p.q()); }),
      written(R"($=\frac{e^2\rho^2}{1-e^2}+\frac{e^4\rho^2}{(1-e^2)^2}=\frac{e^2\rho^2}{(1-e^2)^2}$)",
              [=](const auto& p) {
                const auto square = p.e * p.e * p.rho * p.rho;
                return two(square / p.q() + fourth(p), square / (p.q() * p.q()));
              }),
      written(R"($=\frac{e^4\rho^2}{(1-e^2)^2}$)", [=](const auto& p) { return twice(fourth(p)); }),
      R"($\Big(x\pm\frac{e^2\rho}{1-e^2}\Big)^2+\frac{y^2}{1-e^2}$)");
  t.claims.formula<Point>(
      "axes", 927,
      R"($a=e\rho/(1-e^2)$ and $b=a\sqrt{1-e^2}$ are half the length and half the height of the orbit.)",
      t.orbit_alone,
      {.truth = half_sizes,
       .printed = semi_axes,
       .near_misses = {{R"($a=e\rho/(1-e^2)$, $b=a(1-e^2)$)",
                        [](const auto& p) { return values(p.a(), p.a() * p.q()); }}}});
  t.claims.formula<Point>(
      "ratio", 929, "$a^2/b^2=1/(1-e^2)$", t.orbit_alone,
      {.truth = square_of_sizes, .printed = square_of_axes, .near_misses = {{"$1/(1+e^2)$"}}});
  t.line("c", 929, R"($c=ae=e^2\rho/(1-e^2)$)", On::orbit,
         written(R"(from the origin to the middle of the apsides, $r(0)$ and $r(\pi)$)",
                 [](const auto& p) { return twice(p.to_middle()); }, &Point::farthest),
         written(R"($ae=e^2\rho/(1-e^2)$)", [](const auto& p) { return two(p.a() * p.e, p.c()); }),
         written("$ae^2$", [](const auto& p) { return twice(p.a() * p.e * p.e); }));
  t.line("scaled", 931, R"($(x\pm c)^2+(a^2/b^2)y^2=a^2$)", On::both,
         written("the sum at the point",
                 [](const auto& p) {
                   return pow(p.x + p.s * p.c(), 2) + p.a() * p.a() / (p.b() * p.b()) * p.y * p.y;
                 }),
         written("$a^2$", [](const auto& p) { return p.a() * p.a(); }),
         written("$b^2$", [](const auto& p) { return p.b() * p.b(); }));
  const auto ellipse = [](std::string text, double sign) {
    return written(std::move(text), [=](const auto& p) {
      return pow((p.x + sign * p.s * p.c()) / p.a(), 2) + p.y * p.y / (p.b() * p.b());
    });
  };
  t.line("ellipse", 935, R"($(x\pm c)^2/a^2+y^2/b^2=1$, the standard formula of an ellipse along the axes)",
         On::both, written("1", [](const auto& p) { return decltype(p.r)(1); }),
         ellipse(R"($(x\pm c)^2/a^2+y^2/b^2=1$)", 1), ellipse(R"($(x\mp c)^2/a^2+y^2/b^2=1$)", -1));

  const auto fits = [&](double sign) {
    return compare<Point>("distance from the origin", distance_on_ellipse(sign), orbit_at_angle(sign),
                          t.orbit_alone);
  };
  t.claims.add(
      "two_solutions", 887, R"(The sign in $\pm2e^2\rho x$ indicates that there are two possible solutions.)",
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

// ---- what is said about it --------------------------------------------------------------------------------

const Line middle_of_apsides = written(
    "the middle of the apsides", [](const auto& p) { return two(-p.to_middle(), 0); }, &Point::farthest);

Line on_the_axis(std::string text, double factor) {
  return written(std::move(text), [=](const auto& p) { return two(factor * p.c(), 0); });
}

const Point shown{{0.625, 1.5}, 0, 0, 0, 1};

const Line all_apart = written(R"($r(0)+r(\pi)$)", [](const auto& p) { return p.nearest() + p.farthest(); });

Line foci(std::string text, double other) {
  return written(std::move(text), [=](const auto& p) { return p.sum_with_focus(other * p.c()); });
}

const Line sizes =
    written(R"($r(0)+r(\pi)$, and twice the highest point by Brent's method)",
            [](const auto& p) { return two(p.nearest() + p.farthest(), 2 * p.half_height()); });
Line axes(std::string text, double factor) {
  return written(std::move(text), [=](const auto& p) { return two(factor * p.a(), factor * p.b()); });
}

void about_the_ellipse(Table& t) {
  Claims& claims = t.claims;
  const std::vector<Point>& samples = t.orbit_alone;
  const auto positive = [](std::string text, double factor) -> Statement<Point> {
    return {std::move(text), [=](const auto& p) {
              const Ellipse ellipse{factor * p.e, p.rho};
              return ellipse.a() > 0 && ellipse.b() > 0;
            }};
  };
  const auto divisor = [](const std::string& text, double factor) -> Statement<Point> {
    return {text, [=](const auto& p) { return 1 - pow(factor * p.e, 2) > 0; }};
  };
  claims.statement<Point>("divisor", 891, "One can divide by $1-e^2$ ($0<e<1$ is our condition).", samples,
                          {.printed = divisor("for $0<e<1$ it is positive", 1),
                           .near_misses = {divisor("for $0<e<1.25$ it is positive", 1.25)}});
  claims.statement<Point>(
      "positive", 941,
      "The ellipse has $a>0$ and $b>0$ ($0<e<1$ is our condition: for $e=0$ the polar equation "
      "is $r=0$, and from $e=1$ on its curve is no ellipse).",
      samples,
      {.printed = positive("for $0<e<1$", 1),
       .near_misses = {positive("for $0<e<1.25$", 1.25), positive("for $e=0$", 0)}});
  claims.formula<Point>(
      "center", 941, R"(The center of the ellipse $(x\pm c)^2/a^2+y^2/b^2=1$ is $(\pm c,0)$.)", samples,
      {.quantity = R"(the center of the orbit, $(x+c)^2/a^2+y^2/b^2=1$)",
       .truth = middle_of_apsides,
       .printed = {"$(c,0)$"},
       .corrected = {"$(-c,0)$"},
       .kind = Fault::formula,
       .root = "the sign of the center",
       .why =
           R"($(x\pm c)^2$ is zero at $x=\mp c$. The orbit has the plus sign: its center, midway between the )"
           R"(apsides, is $(-c,0)$, away from the perihelion at $\theta=0$.)"});
  claims.formula<Point>(
      "major_axis", 941, "The length of the major axis is $a$, that of the minor axis $b$.", samples,
      {.truth = sizes,
       .printed = axes("$a$ and $b$", 1),
       .corrected = axes("$2a$ and $2b$", 2),
       .near_misses = {{"$2a$ and $2a(1-e^2)$",
                        [](const Point& p) { return values(2 * p.a(), 2 * p.a() * p.q()); }}},
       .kind = Fault::term,
       .root = "axes for semi-axes",
       .why =
           R"($a$ and $b$ are the semi-axes: $r(0)+r(\pi)=2e\rho/(1-e^2)=2a$. (The solution of 3.3 has $2a$ )"
           R"(and $2b$.))"});
  t.line("focal_distance", 943,
         "The distance from the center to a focus is $c$: the origin is so far from the center.", On::orbit,
         written(
             "from the origin to the middle of the apsides", [](const auto& p) { return p.to_middle(); },
             &Point::farthest),
         written("$c$", [](const auto& p) { return p.c(); }),
         written("$b$", [](const auto& p) { return p.b(); }));
  t.line("origin_is_focus", 943,
         "The origin is a focal point: the distances to it and to another point have a constant sum.",
         On::orbit, all_apart, foci("with its mirror in the center, $(-2c,0)$", -2),
         foci("with the center, $(-c,0)$", -1), "sum of the distances to the two");
  claims.formula<Point>(
      "other_focus", 943, R"(The other focal point is $(\pm2c,0)$.)", samples,
      {.quantity = "sum of the distances to the two foci",
       .truth = all_apart,
       .printed = foci("at $(2c,0)$", 2),
       .corrected = foci("at $(-2c,0)$", -2),
       .near_misses = {foci("at $(-c,0)$", -1)},
       .kind = Fault::formula,
       .root = "the sign of the center",
       .why = filled(
           R"(For $e=0.625$, $\rho=1.5$ the distances to the origin and $(2c,0)$ add up to @3 at the aphelion. Those )"
           R"(to the origin and $(-2c,0)$ add up to $2a$ there and everywhere, which is @3.)",
           {2 * (shown.farthest() + shown.c()), 2 * shown.half_length()})});
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
           R"(For $e=0.625$, $\rho=1.5$ the minus sign puts the planet @2 from the sun at $\theta=0$, where it )"
           R"(should be at its nearest, @3.)",
           {far, near})},
      {"the sign of the center",
       filled(
           R"(An ellipse drawn about $(c,0)$ has the sun in the wrong focus: for $e=0.625$, $\rho=1.5$ its )"
           R"(perihelion is @3 too far out, at @2 instead of @3.)",
           {far - near, far, near})},
      {"axes for semi-axes",
       filled(
           R"(Drawn with a major axis of length $a$ the orbit is half as large: for $e=0.625$, $\rho=1.5$ it )"
           R"(is @3 long instead of @3.)",
           {a, 2 * a})}};
}

}  // namespace oddity::ex03_01

// ---- proofs -----------------------------------------------------------------------------------------------

namespace oddity {

namespace ex03_01 {

namespace {

/// With r by the polar equation of its curve.
PointOf<Expression> any_point(double sign) {
  const auto letter = Expression::letter;
  PointOf<Expression> p{{letter("e"), letter("rho")}, letter("r"), letter("x"), letter("y"), sign};
  if (sign != 0) p.r = p.e * p.rho - sign * p.e * p.x;
  return p;
}

/// A field's equation, knowing y^2 and the square of the root of 1 - e^2.
std::string by_squares(const Expression& q) {
  const std::string root = sqrt(q).coq(), positive = "sqrt_lt_R0, Rmult_lt_0_compat; lra);\n  ";
  return "\n  assert (root : " + root + " * " + root + " = " + q.coq() +
         ") by (apply sqrt_sqrt, Rlt_le, Rmult_lt_0_compat; lra);\n  assert (" + root +
         " <> 0) by (apply Rgt_not_eq, " + positive + "field [H2 root]; repeat split; lra";
}

Lemma on_curve(std::string name, const Line& left, const Line& right, double sign) {
  const PointOf<Expression> p = any_point(sign);
  Lemma lemma{.name = std::move(name),
              .letters = "(e rho r x y : R)",
              .given = {above(p.e, 0), above(1 - p.e, 0), above(p.rho, 0)},
              .follows = equal(left.recorded(p), right.recorded(p)),
              .tactic = "field; repeat split; lra"};
  if (sign == 0) return lemma;
  lemma.given.push_back(p.y * p.y == p.r * p.r - p.x * p.x);
  lemma.tactic = by_squares(p.q());
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
Ltac by_distance :=
  match goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, C : ?y * ?y = _ - ?x * ?x |- _ =>
    rewrite ?Rmult_1_l in *; destruct (on_orbit e rho x y E U P C) as [far below];
    assert (square : x * x + y * y = (e * rho - e * x) * (e * rho - e * x)) by lra;
    try rewrite cos_atan2 by (rewrite square; apply Rmult_lt_0_compat; lra);
    rewrite ?square, ?sqrt_square by lra;
    try (match goal with |- context [sqrt ?q] =>
      replace q with ((e * rho / (1 + e) + e * rho / (1 - e) - (e * rho - e * x)) * (e * rho / (1 + e) + e * rho / (1 - e) - (e * rho - e * x)))
        by (field [C]; repeat split; lra);
      rewrite sqrt_square by (apply Rmult_le_reg_r with (1 - e); [lra |];
        assert (e * rho / (1 + e) > 0) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra);
        replace ((e * rho / (1 + e) + e * rho / (1 - e) - (e * rho - e * x)) * (1 - e)) with
          (e * rho / (1 + e) * (1 - e) + (e * rho - (1 - e) * (e * rho - e * x))) by (field; lra); nra) end);
    field; repeat split; lra end.
)";

Provable by_distance(Provable provable) {
  provable.preamble = atan2_in_coq + distances_in_coq;
  for (Lemma& lemma : provable.lemmas)
    if (lemma.tactic != "interval") lemma.tactic = "by_distance";
  return provable;
}

Provable proof_of_center() {
  const PointOf<Expression> p{{0.5, 1}, 0, 0, 0, 0};
  const Expression printed = on_the_axis("", 1).recorded(p)[0], right = middle_of_apsides.recorded(p)[0];
  return {
      "3.1-center",
      "the corrected center is in the middle of the apsides of every orbit; for e = 1/2 and rho = 1 the printed "
      "one is off",
      {on_curve("corrected", on_the_axis("", -1), middle_of_apsides, 0),
       {.name = "printed_differs", .follows = {apart(printed, right, 0.6)}, .tactic = "interval"}},
      0.6};
}

/// Of the ellipse's focus, at a point of e = 1/2 and rho = 1.
Provable proof_of_other_focus() {
  const PointOf<Expression> p{{0.5, 1}, 0.375, 0.25, sqrt(Expression(5.0) / 64), 1};
  return {"3.1-other_focus",
          "the corrected point is a focus of every orbit; for e = 1/2 and rho = 1 the printed one is off",
          {on_curve("corrected", foci("", -2), all_apart, 1),
           {.name = "printed_differs",
            .follows = {apart(foci("", 2).recorded(p)[0], all_apart.recorded(p)[0], 0.45)},
            .tactic = "interval"}},
          0.45};
}

/// For claims about the highest point, of the angle `top`.
const std::string heights_in_coq = R"(
Lemma on_orbits : forall e t, e > 0 -> 1 - e > 0 ->
  1 + e * cos t > 0 /\ sin t * sin t = 1 - cos t * cos t.
Proof.
  intros e t E U. pose proof (COS_bound t). pose proof (sin2_cos2 t) as C. unfold Rsqr in C. split; nra.
Qed.
Ltac by_height :=
  lazymatch goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, T : ?top > 0, B : PI - ?top > 0, F : _ = 0 |-
      _ =>
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

PointOf<Expression> any_orbit() { return {{Expression::letter("e"), Expression::letter("rho")}, 0, 0, 0, 1}; }

Lemma at_the_top(std::string name, const Line& left, const Line& right) {
  const PointOf<Expression> p = any_orbit();
  const Expression top = Expression::letter("top");
  return {.name = std::move(name),
          .letters = "(e rho top : R)",
          .given = {above(p.e, 0), above(1 - p.e, 0), above(p.rho, 0), above(top, 0),
                    above(pi_in_coq() - top, 0), p.slope_of_height(top) == 0},
          .follows = equal(left.recorded(p), right.recorded(p)),
          .tactic = "by_height"};
}

/// That there is a highest point.
Lemma top_there_is() {
  const PointOf<Expression> p = any_orbit();
  const Expression top = function("acos", -p.e), angle = Expression::letter("theta");
  return {.name = "highest",
          .letters = "(e rho theta : R)",
          .given = {above(p.e, 0), above(1 - p.e, 0), above(p.rho, 0)},
          .follows = {above(top, 0),
                      above(pi_in_coq() - top, 0),
                      p.slope_of_height(top) == 0,
                      {p.height(angle).coq() + " <= " + p.height(top).coq()}},
          .tactic = "by_top"};
}

Provables proofs_of_axes() {
  const PointOf<Expression> p{{0.5, 1}, 0, 0, 0, 1};
  const Expression length = axes("", 1).recorded(p)[0], right = p.nearest() + p.farthest();
  Provables all{
      {"3.1-axes",
       "it holds on every orbit, and every orbit has a highest point",
       {at_the_top("printed", semi_axes, half_sizes), top_there_is()}},
      {"3.1-ratio", "it holds on every orbit", {at_the_top("printed", square_of_axes, square_of_sizes)}},
      {"3.1-major_axis",
       "as corrected it holds on every orbit; for e = 1/2 and rho = 1 what is printed is off",
       {at_the_top("corrected", axes("", 2), sizes),
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
  const PointOf<Expression> p{{0.5, 1}, 1, 0.6, 0.8, 0};
  Lemma holds = on_curve("corrected", distance_on_ellipse(1), orbit_at_angle(1), 0);
  const PointOf<Expression> any = any_point(0);
  holds.given.push_back(above(any.r, 0));
  holds.given.push_back(any.y * any.y == any.r * any.r - any.x * any.x);
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
