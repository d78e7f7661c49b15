// Exercise 3.1: the orbit r = e rho / (1 + e cos theta), focus at the origin, is an ellipse:
//   (x + c)^2/a^2 + y^2/b^2 = 1,   a = e rho/(1 - e^2),   b = a sqrt(1 - e^2),   c = a e.
// The published algebra squares twice. It is judged line by line at points computed from the polar equation;
// its result also by what no line of it uses: the sum of the distances to the foci, the apsides, the highest
// point of the orbit (d(r sin theta)/d theta = 0 by dual numbers and Brent's method).

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/roots.hpp"

namespace oddity {

namespace ex03_01 {

using std::cos, std::sin, std::sqrt, std::abs, std::hypot, std::pow, std::numbers::pi;

constexpr Parameter parameters[] = {
    {"e", 0.625, "", "eccentricity; from 1 on the orbit is open", 1e-3, 1.25},
    {"rho", 1.5, "", "distance from the focus to the directrix", 1e-3, 1e3},
    {"theta", 2.25, "rad", "polar angle", -2.4, 2.4},
    {"seed", 1, "", "of the random points", 0, 1e6, whole_number},
};

template <class T>
T orbit(double e, double rho, const T& theta) {
  return e * rho / (1.0 + e * cos(theta));
}

/// A point of sign 1 lies on the orbit, of sign -1 on the mirror image r = e rho / (1 - e cos theta), of sign
/// 0 anywhere: there only rewritings hold.
struct Point {
  double e, rho, r, x, y, s;
  double q = (1 - e) * (1 + e), a = e * rho / q, b = a * sqrt(q), c = e * e * rho / q;
  double size = r + e * (rho + abs(x));
  double nearest = e * rho / (1 + e), farthest = e * rho / (1 - e);

  /// r sin theta where its derivative is zero.
  double half_height() const {
    const auto height = [&](auto theta) { return orbit(e, rho, theta) * sin(theta); };
    return height(brent([&](double theta) { return derivative(height, theta); }, 0, pi, 1e-15).value);
  }
  std::string shown() const {
    return "e = " + shortest(e) + ", rho = " + shortest(rho) + ", x = " + shortest(x) +
           ", y = " + shortest(y) +
           (s > 0   ? ", on the orbit"
            : s < 0 ? ", on its mirror image"
                    : "");
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
    all.push_back({e, rho, r, r * cos(theta), r * sin(theta), s});
  }
  return all;
}

// ---- line by line -----------------------------------------------------------------------------------------

/// A line of the text: where it holds, the degree of its terms in lengths, how often 1 - e^2 divides them,
/// and what is compared with what. Of an erratum `other` is what is true, and `miss` the near miss; else
/// `other` is the near miss. A line that rewrites the one before it is compared with that one.
struct Line {
  std::string_view slug;
  int number;
  std::string_view says;
  On on;
  int degree, divisions;
  std::string_view one, another, other, why = {}, miss = {};
};

constexpr Line lines[] = {
    {"multiplied", 857, "e rho = r (1 + e cos theta) = r + e x", On::orbit, 1, 0, "e rho",
     "r (1 + e cos theta) and r + e x at the point", "r - e x"},
    {"squared", 861, "e^2 rho^2 = r^2 + 2 e x r + e^2 x^2", On::orbit, 2, 0, "e^2 rho^2",
     "the three terms at the point", "e x r without the 2"},
    {"solved", 863, "2 e x r = e^2 (rho^2 - x^2) - r^2", On::orbit, 2, 0, "2 e x r at the point",
     "e^2 (rho^2 - x^2) - r^2", "e^2 (rho^2 + x^2) - r^2"},
    {"distance", 865, "r = sqrt(x^2 + y^2)", On::orbit, 1, 0, "r by the polar equation", "by the coordinates",
     "|x| + |y|"},
    {"squared_again", 869, "4 e^2 x^2 r^2 = [e^2 (rho^2 - x^2) - r^2]^2, and the three terms of that",
     On::both, 4, 0, "4 e^2 x^2 r^2 at the point", "the square, and its three terms",
     "+ 2 e^2 (rho^2 - x^2) r^2"},
    {"subtracted", 873, "0 = [e^2 (rho^2 - x^2)]^2 + r^4 - 2 e^2 (rho^2 + x^2) r^2", On::anywhere, 4, 0,
     "the line before, 4 e^2 x^2 r^2 subtracted", "the three terms", "rho^2 - x^2 in the last term"},
    {"regrouped", 875, "rho^2 - x^2 there is rho^2 + x^2 - 2 x^2", On::anywhere, 4, 0, "the line before",
     "the terms regrouped", "rho^2 + x^2 - x^2"},
    {"opened", 877, "the square opened: - 4 e^4 x^2 (rho^2 + x^2) + 4 e^4 x^4", On::anywhere, 4, 0,
     "the line before", "the square multiplied out", "- 4 e^4 x^4"},
    {"gathered", 879, "of these - 4 e^4 rho^2 x^2 is left", On::anywhere, 4, 0, "the line before",
     "the terms gathered", "- 2 e^4 rho^2 x^2"},
    {"closed", 881, "0 = [e^2 (rho^2 + x^2) - r^2]^2 - 4 e^4 rho^2 x^2", On::anywhere, 4, 0,
     "the line before", "a square less a square", "e^2 (rho^2 + x^2) + r^2"},
    {"moved", 883, "4 e^4 rho^2 x^2 = [e^2 (rho^2 + x^2) - r^2]^2", On::both, 4, 0,
     "4 e^4 rho^2 x^2 at the point", "the square", "e^2 (rho^2 - x^2) - r^2"},
    {"root", 885, "+-2 e^2 rho x = e^2 (rho^2 + x^2) - r^2: + on the orbit, - on its mirror image", On::both,
     2, 0, "+-2 e^2 rho x at the point", "e^2 (rho^2 + x^2) - r^2", "the other sign"},
    {"collected", 889, "(1 - e^2) x^2 +- 2 e^2 rho x + y^2 = r^2 - e^2 x^2 +- 2 e^2 rho x = e^2 rho^2",
     On::both, 2, 0, "the two sums at the point", "e^2 rho^2", "= rho^2"},
    {"divided", 891, "x^2 +- 2 e^2 rho x/(1 - e^2) + y^2/(1 - e^2) = e^2 rho^2/(1 - e^2)", On::both, 2, 1,
     "the sum at the point", "e^2 rho^2/(1 - e^2)", "= e^2 rho^2/(1 + e^2)"},
    {"completed", 905,
     "(x +- e^2 rho/(1 - e^2))^2 + y^2/(1 - e^2) = e^2 rho^2/(1 - e^2) + e^4 rho^2/(1 - e^2)^2 = e^2 "
     "rho^2/(1 - e^2)^2",
     On::both, 2, 2, "the sum of squares at the point", "the two constants", "= e^4 rho^2/(1 - e^2)^2"},
    {"axes", 927, "half the length is a = e rho/(1 - e^2), half the height b = a sqrt(1 - e^2)", On::orbit, 1,
     1, "half the way between the apsides, and the highest point by Brent's method", "a and b",
     "b = a (1 - e^2)"},
    {"ratio", 929, "a^2/b^2 = 1/(1 - e^2)", On::orbit, 0, 2,
     "the squares of half the way between the apsides and of the highest point by Brent's method",
     "1/(1 - e^2)", "1/(1 + e^2)"},
    {"c", 929, "c = a e = e^2 rho/(1 - e^2)", On::orbit, 1, 1,
     "from the origin to the middle of the apsides, r(0) and r(pi)", "a e and e^2 rho/(1 - e^2)", "a e^2"},
    {"scaled", 931, "(x +- c)^2 + a^2 y^2/b^2 = a^2", On::both, 2, 2, "the sum at the point", "a^2", "= b^2"},
    {"ellipse", 935, "(x +- c)^2/a^2 + y^2/b^2 = 1", On::both, 2, 2, "1", "the sum at the point", "x -+ c"},
    {"center", 941, "the center is (+-c, 0): that of (x + c)^2 is (c, 0)", On::orbit, 1, 1,
     "the middle of the apsides", "(c, 0)", "(-c, 0)",
     "$(x\\pm c)^2$ is zero at $x=\\mp c$. The orbit has the plus sign: its center, midway between the "
     "apsides, is $(-c,0)$, away from the perihelion at $\\theta=0$. An ellipse drawn about $(c,0)$ has the "
     "sun "
     "in the wrong focus: its perihelion is $2c$ too far out.",
     "(-2c, 0)"},
    {"major_axis", 941, "the major axis is of length a, the minor axis of length b", On::orbit, 1, 1,
     "r(0) + r(pi), and twice the highest point by Brent's method", "the lengths", "2a and 2b",
     "$a$ and $b$ are the semi-axes: $r(0)+r(\\pi)=2e\\rho/(1-e^2)=2a$. (The solution of 3.3 has $2a$ and "
     "$2b$.)",
     "2a and 2a (1 - e^2)"},
    {"focal_distance", 943, "c is the distance from the center to the origin", On::orbit, 1, 1,
     "from the origin to the middle of the apsides", "c", "b"},
    {"origin_is_focus", 943, "the origin is a focus: its mirror in the center completes a constant sum",
     On::orbit, 1, 1, "r(0) + r(pi)", "the distances from the point to the origin and to (-2c, 0)",
     "the center completes it"},
    {"other_focus", 943, "the other focus is (+-2c, 0): that of (x + c)^2 is (2c, 0)", On::orbit, 1, 1,
     "r(0) + r(pi)", "the distances from the point to the two foci", "(-2c, 0)",
     "The distances to the origin and $(2c,0)$ add up to $2a+4c$ at the aphelion and, for $e<1/3$, to "
     "$2a-4c$ at the perihelion; those to the origin and $(-2c,0)$ add up to $2a$ everywhere.",
     "(-c, 0)"},
};

/// The two routes of a line as printed, the second one in its other form, and in its near miss.
struct Sides {
  Value left, right, other, miss = {};
};

Sides sides(std::string_view slug, const Point& p) {
  const auto& [e, rho, r, x, y, s, q, a, b, c, size, nearest, farthest] = p;
  const double e2 = e * e, e4 = e2 * e2, p2 = rho * rho, x2 = x * x, y2 = y * y;
  const double r2 = s == 0 ? x2 + y2 : r * r, r4 = r2 * r2;
  const double sum = e2 * (p2 + x2), difference = e2 * (p2 - x2), linear = s * 2 * e2 * rho * x;
  const double expanded = pow(difference, 2) + r4 - 2 * difference * r2;
  const double subtracted = pow(difference, 2) + r4 - 2 * sum * r2;
  const double regrouped = pow(sum - 2 * e2 * x2, 2) + r4 - 2 * sum * r2;
  const double opened = sum * sum - 4 * e4 * x2 * (p2 + x2) + 4 * e4 * x2 * x2 + r4 - 2 * sum * r2;
  const double gathered = sum * sum - 4 * e4 * p2 * x2 + r4 - 2 * sum * r2;
  const double closed = pow(sum - r2, 2) - 4 * e4 * p2 * x2;
  const auto twice = [](double z) { return Value{z, z}; };
  const auto sum_with = [&p](double focus) { return p.r + hypot(p.x - focus, p.y); };

  if (slug == "multiplied")
    return {twice(e * rho), {r * (1 + e * cos(std::atan2(y, x))), r + e * x}, twice(r - e * x)};
  if (slug == "squared") return {e2 * p2, r2 + 2 * e * x * r + e2 * x2, r2 + e * x * r + e2 * x2};
  if (slug == "solved") return {2 * e * x * r, difference - r2, sum - r2};
  if (slug == "distance") return {r, sqrt(x * x + y * y), abs(x) + abs(y)};
  if (slug == "squared_again")
    return {twice(4 * e2 * x2 * r2), {pow(difference - r2, 2), expanded}, twice(pow(difference + r2, 2))};
  if (slug == "subtracted") return {expanded - 4 * e2 * x2 * r2, subtracted, expanded};
  if (slug == "regrouped") return {subtracted, regrouped, pow(sum - e2 * x2, 2) + r4 - 2 * sum * r2};
  if (slug == "opened") return {regrouped, opened, opened - 8 * e4 * x2 * x2};
  if (slug == "gathered") return {opened, gathered, gathered + 2 * e4 * p2 * x2};
  if (slug == "closed") return {gathered, closed, pow(sum + r2, 2) - 4 * e4 * p2 * x2};
  if (slug == "moved") return {4 * e4 * p2 * x2, pow(sum - r2, 2), pow(difference - r2, 2)};
  if (slug == "root") return {linear, sum - r2, r2 - sum};
  if (slug == "collected") return {{q * x2 + linear + y2, r2 - e2 * x2 + linear}, twice(e2 * p2), twice(p2)};
  if (slug == "divided") return {x2 + linear / q + y2 / q, e2 * p2 / q, e2 * p2 / (1 + e2)};
  if (slug == "completed")
    return {twice(pow(x + s * e2 * rho / q, 2) + y2 / q),
            {e2 * p2 / q + e4 * p2 / (q * q), e2 * p2 / (q * q)},
            twice(e4 * p2 / (q * q))};
  if (slug == "axes") return {{(nearest + farthest) / 2, p.half_height()}, {a, b}, {a, a * q}};
  if (slug == "ratio") return {pow((nearest + farthest) / (2 * p.half_height()), 2), 1 / q, 1 / (1 + e2)};
  if (slug == "c") return {twice((farthest - nearest) / 2), {a * e, e2 * rho / q}, twice(a * e2)};
  if (slug == "scaled") return {pow(x + s * c, 2) + a * a / (b * b) * y2, a * a, b * b};
  if (slug == "ellipse")
    return {1.0, pow((x + s * c) / a, 2) + y2 / (b * b), pow((x - s * c) / a, 2) + y2 / (b * b)};
  if (slug == "center") return {{(nearest - farthest) / 2, 0}, {c, 0}, {-c, 0}, {-2 * c, 0}};
  if (slug == "major_axis")
    return {{nearest + farthest, 2 * p.half_height()}, {a, b}, {2 * a, 2 * b}, {2 * a, 2 * a * q}};
  if (slug == "focal_distance") return {(farthest - nearest) / 2, c, b};
  if (slug == "origin_is_focus") return {nearest + farthest, sum_with(-2 * c), sum_with(-c)};
  if (slug == "other_focus") return {nearest + farthest, sum_with(2 * c), sum_with(-2 * c), sum_with(-c)};
  throw std::logic_error("no line " + std::string(slug));
}

/// The line as printed, in its other form or in its near miss. A rewritten line is also zero on both curves:
/// seen with its last term, 2 e^2 (rho^2 + x^2) r^2, on the other side.
std::vector<Check> checks(const Line& line, std::string_view form, Value Sides::*side, double seed) {
  const std::string one(line.one), another(line.another), other(form);
  const bool right = !line.why.empty() && side == &Sides::other;
  Worst equation(one + " against " + another, one,
                 side == &Sides::right ? another
                 : right               ? other
                                       : another + ", but " + other),
      zero("zero on both curves", "all terms but 2 e^2 (rho^2 + x^2) r^2", "that term");
  const auto scale = [&](const Point& p) {
    const bool pure = line.slug == "ellipse";
    return pow(pure ? p.size / p.a : p.size, line.degree) / pow(p.q, line.divisions);
  };
  for (const Point& p : points(seed, line.on)) {
    const Sides both = sides(line.slug, p);
    equation.see(both.left, both.*side, scale(p), p.shown());
  }
  if (line.on != On::anywhere) return {equation.check()};
  for (const Point& p : points(seed, On::both)) {
    const double term = 2 * p.e * p.e * (p.rho * p.rho + p.x * p.x) * p.r * p.r;
    zero.see((sides(line.slug, p).*side)[0] + term, term, scale(p), p.shown());
  }
  return {equation.check(), zero.check()};
}

/// Points of the ellipses (x + s c)^2/a^2 + y^2/b^2 = 1 in the polar equation.
Reading on_the_orbit(std::string text, double seed, std::initializer_list<double> signs) {
  Worst worst("distance from the origin", "point of the ellipse", "polar equation at its angle");
  for (const Point& p : points(seed, On::orbit))
    for (double s : signs) {
      const double x = -s * p.c + p.a * p.x / p.r, y = p.b * p.y / p.r;
      worst.see(hypot(x, y), orbit(p.e, p.rho, std::atan2(y, x)), p.a / (1 - p.e), p.shown());
    }
  return {std::move(text), {worst.check()}};
}

Reading positive(std::string text, double seed, double factor) {
  long violations = 0, samples = 0;
  for (const Point& p : points(seed, On::orbit)) {
    const double e = factor * p.e, a = e * p.rho / (1 - e * e), b = a * sqrt(1 - e * e);
    ++samples;
    violations += !(a > 0 && b > 0);
  }
  return {std::move(text), {never("a > 0 and b > 0", violations, samples)}};
}

std::vector<Claim> claims(double seed) {
  std::vector<Claim> all;
  for (const Line& line : lines) {
    Claim claim{"3.1-" + std::string(line.slug), line.number, std::string(line.says)};
    const auto reading = [&](std::string_view text, Value Sides::*form) {
      return Reading{std::string(text), checks(line, text, form, seed)};
    };
    claim.printed = reading("as printed", &Sides::right);
    if (line.why.empty()) {
      claim.near_misses = {reading(line.other, &Sides::other)};
    } else {
      claim.corrected = reading(line.other, &Sides::other);
      claim.near_misses = {reading(line.miss, &Sides::miss)};
    }
    claim.why = line.why;
    all.push_back(std::move(claim));
  }
  Claim two{"3.1-two_solutions", 887, "both signs of the root are possible solutions"};
  two.printed = on_the_orbit("both ellipses", seed, {1, -1});
  two.corrected = on_the_orbit("the ellipse of the plus sign alone", seed, {1});
  two.near_misses = {on_the_orbit("the ellipse of the minus sign alone", seed, {-1})};
  two.why =
      "The second squaring adds the mirror image $r=e\\rho/(1-e\\cos\\theta)$. Of the ellipse with the minus "
      "sign only the two points $(0,\\pm e\\rho)$ satisfy the polar equation; the orbit is the one with the "
      "plus sign.";
  Claim sizes{"3.1-positive", 941, "a > 0 and b > 0, e being between 0 and 1"};
  sizes.printed = positive("0 < e < 1", seed, 1);
  sizes.near_misses = {positive("0 < e < 1.25", seed, 1.25), positive("e = 0", seed, 0)};
  all.insert(all.end(), {two, sizes});
  return all;
}

// ---- the radius by several equations of the curve ---------------------------------------------------------

struct Conic {
  double e, rho, p, theta;
};

/// The positive root of A r^2 + B r = C, the least where there are two.
double textbook_root(double A, double B, double C) { return (-B + sqrt(B * B + 4 * A * C)) / (2 * A); }
double stable_root(double A, double B, double C) {
  return B > 0 ? 2 * C / (B + sqrt(B * B + 4 * A * C)) : textbook_root(A, B, C);
}

double by_conic(const Conic& k, double (*root)(double, double, double)) {
  const double x = cos(k.theta), y = sin(k.theta);
  return root((1 - k.e * k.e) * x * x + y * y, 2 * k.e * k.p * x, k.p * k.p);
}
/// The ellipse of center (-sign c, 0).
double by_standard_ellipse(const Conic& k, double sign) {
  const Point p{k.e, k.rho, 0, 0, 0, 0};
  const double x = cos(k.theta), y = sin(k.theta), a2 = p.a * p.a;
  return stable_root(x * x / a2 + y * y / (p.b * p.b), sign * 2 * p.c * x / a2, 1 - p.c * p.c / a2);
}
double by_eccentric_anomaly(const Conic& k) {
  const double E = 2 * std::atan(sqrt((1 - k.e) / (1 + k.e)) * std::tan(k.theta / 2));
  return k.e * k.rho / (1 - k.e * k.e) * (1 - k.e * cos(E));
}

struct Expected {
  Outcome polar = Outcome::ok, textbook = Outcome::ok, ellipse = Outcome::ok;
  std::string why = {};
};

Quantity radius(const std::string& name, std::string says, const Conic& k, const Reference& truth,
                const Expected& as) {
  Quantity r = quantity(name, "unit of rho", std::move(says), truth("03_01_radius", {k.e, k.p, k.theta}),
                        {1e-12 * k.p, "twelve digits of the semi-latus rectum"});
  const auto add = [&](std::string equation, std::string algorithm, auto value,
                       Outcome expected = Outcome::ok) {
    r.add({std::move(equation), std::move(algorithm), no_knob(),
           [=](double) {
             return Answer{value(k), 1};
           },
           expected, expected == Outcome::ok ? "" : as.why});
  };
  const std::string stable = "root without cancellation";
  add(
      "polar, e and rho", "formula", [](auto& c) { return orbit(c.e, c.rho, c.theta); }, as.polar);
  add("polar, e and p = e rho", "formula", [](auto& c) { return c.p / (1 + c.e * cos(c.theta)); });
  add(
      "before the division", "textbook root", [](auto& c) { return by_conic(c, textbook_root); },
      as.textbook);
  add("before the division", stable, [](auto& c) { return by_conic(c, stable_root); });
  add(
      "standard ellipse", stable, [](auto& c) { return by_standard_ellipse(c, 1); }, as.ellipse);
  add("standard ellipse", "eccentric anomaly", by_eccentric_anomaly, as.ellipse);
  return r;
}

std::vector<Quantity> radii(const Parameters& p, const Reference& truth) {
  const Conic asked{p["e"], p["rho"], p["e"] * p["rho"], p["theta"]};
  const double almost = 1 - 0x1p-30;
  const Outcome ok = Outcome::ok, lost = Outcome::inaccurate, none = Outcome::non_finite;
  const std::string cure = "before the division, root without cancellation";
  const std::string no_ellipse = "a is not positive, and b the root of a negative number";
  Quantity any = radius("radius", "distance from the focus at the angle theta", asked, truth,
                        {ok, ok, asked.e < 1 ? ok : none, no_ellipse});
  any.add({"ellipse of the minus sign", "root without cancellation", no_knob(),
           [=](double) {
             return Answer{by_standard_ellipse(asked, -1), 1};
           },
           lost, "it is the mirror image"});
  Quantity circle = radius("radius_of_circle", "e = 0, rho infinite", {0, HUGE_VAL, 1.5, 2.25}, truth,
                           {none, ok, none, "e rho is zero times infinity"});
  circle.add(
      Breakdown{"A circle has no directrix: with e and rho its radius is zero times infinity. The semi-latus "
                "rectum p = e rho is its radius.",
                "polar, e and rho, formula", 0, none, "polar, e and p = e rho, formula", 0});
  Quantity narrow =
      radius("radius_of_narrow_ellipse", "e = 63/64", {0.984375, 0.25 / 0.984375, 0.25, 3}, truth, {});
  Quantity near =
      radius("radius_near_parabola", "e = 1 - 2^-30", {almost, 1 / almost, 1, 1.5}, truth,
             {ok, ok, lost, "a and c are 5e8 times r, which is found as the difference of such numbers"});
  near.add(
      Breakdown{"The division by 1 - e^2 moves the center away; from one that is 5e8 radii off, half of the "
                "digits are lost. Before the division nothing is.",
                "standard ellipse, eccentric anomaly", 0, lost, cure, 0});
  Quantity parabola =
      radius("radius_of_parabola", "e = 1, close to the axis", {1, 1, 1, 0x1p-10}, truth,
             {ok, lost, none, "1 - e^2 = 0 is divided by; the textbook root subtracts what is nearly equal"});
  parabola.add(
      Breakdown{"At e = 1 the division by 1 - e^2 is one by zero: no center, no ellipse. The line before it "
                "is the parabola.",
                "standard ellipse, root without cancellation", 0, none, cure, 0});
  parabola.add(
      Breakdown{"Near the axis the parabola's second crossing is far away, and the textbook's root of the "
                "quadratic equation cancels.",
                "before the division, textbook root", 0, lost, cure, 0});
  Quantity hyperbola =
      radius("radius_of_hyperbola", "e = 3/2", {1.5, 1 / 1.5, 1, 1.25}, truth, {ok, ok, none, no_ellipse});
  return {any, circle, narrow, near, parabola, hyperbola};
}

Findings study(const Parameters& p, const Reference& truth) { return {claims(p["seed"]), radii(p, truth)}; }

}  // namespace ex03_01

Exercise exercise_3_1() {
  using namespace ex03_01;
  return {"The polar equation of an orbit is an ellipse",
          "Show that the orbit $r = e\\rho/(1+e\\cos\\theta)$ satisfies the equation of an ellipse with one "
          "focus at the origin.",
          parameters,
          {},
          study};
}

}  // namespace oddity
