// Exercise 2.13: the six inertia components of the lamina x^2 <= y <= 1, z = 0, of density 1.
//   J w = int r x (w x r) dm;  Ixx = ex . J ex, ..., Ixy = -ex . J ey, ...   the definition
//   int x^p y^q over the lamina = 4 / ((p+1)(p+2q+3)) for p even, 0 for p odd   by rows of constant y
// The text integrates columns (dy dx). The other routes integrate rows (dx dy), where no formula of the text
// occurs: exactly in rational numbers, or numerically from the definition. For the integrands the lamina is
// also cut off at x = left, moved to the height z and given the density rho, so that no component vanishes.

#include <array>
#include <cmath>
#include <numeric>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/quadrature.hpp"

namespace oddity {

namespace {

using std::abs, std::sqrt;
using Vector = std::array<double, 3>;
using Six = std::array<double, 6>;
using Integrand = std::function<double(double x, double y)>;

constexpr Parameter parameters[] = {
    {"left", -1, "", "left end of the lamina; the whole parabola begins at -1", -1, 0.9},
    {"z", 0, "", "height of the lamina's plane", -10, 10},
    {"rho", 1, "", "mass of a unit area", 1e-3, 1e3},
    {"seed", 13, "", "of the random samples", 0, 1e9},
};

constexpr std::string_view names[] = {"Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"};

struct Lamina {
  double left, z, rho;
  Six at(double x, double y) const {
    return {rho * (y * y + z * z), rho * (x * x + z * z), rho * (x * x + y * y),
            rho * x * y,           rho * x * z,           rho * y * z};
  }
};

// ---- the ways to integrate --------------------------------------------------------------------------------

Integral operator+(Integral a, const Integral& b) {
  a.value += b.value;
  a.evaluations += b.evaluations;
  a.error_estimate += b.error_estimate;
  if (a.reached()) a.ending = b.ending, a.message = b.message;
  return a;
}

/// x from `left` to 1, y from the parabola to the top.
Integral columns(const Rule& rule, const Integrand& f, double left) {
  return nested(
      rule, f, left, 1, [](double x) { return x * x; }, [](double) { return 1.0; });
}

/// y from 0 to 1, x between the ends of the row; or, `by_root`, over u = sqrt(y), dy = 2 u du.
Integral rows(const Rule& rule, const Integrand& f, double left, bool by_root) {
  const auto weighted = [&](double u, double x) { return by_root ? 2 * u * f(x, u * u) : f(x, u); };
  const Bound right_end = [=](double u) { return by_root ? u : sqrt(u); };
  const Bound left_end = [=](double u) { return by_root ? -u : -sqrt(u); };
  const double corner = by_root ? abs(left) : left * left;
  Integral sum{0, 0, 0};
  if (corner < 1)
    sum = nested(
        rule, weighted, corner, 1, [=](double) { return left; }, right_end);
  if (left < 0) sum = sum + nested(rule, weighted, 0, corner, left_end, right_end);
  return sum;
}

/// Component k by Green's theorem: the integral of f is that of Q dy around the boundary, dQ/dx = f. The top
/// has dy = 0; the parabola has dy = 2 x dx.
Integral boundary(const Rule& rule, const Lamina& l, std::size_t k) {
  const auto primitive = [&](double x, double y) {
    const double zz = l.z * l.z;
    const Six q{x * y * y + x * zz, x * x * x / 3 + x * zz, x * x * x / 3 + x * y * y,
                x * x * y / 2,      x * x * l.z / 2,        x * y * l.z};
    return l.rho * q[k];
  };
  const Integral parabola = rule([&](double x) { return primitive(x, x * x) * 2 * x; }, l.left, 1);
  const double corner = l.left * l.left;
  if (!(corner < 1)) return parabola;
  return parabola + rule([&](double y) { return -primitive(l.left, y); }, corner, 1);
}

/// All six components, each by `integrate(k)`: the work added up, the largest error estimate, the first
/// failure.
template <class Integrate>
Answer six(const Integrate& integrate) {
  Answer all{Six{}, 0, 0};
  for (std::size_t k = 0; k < 6; ++k) {
    const Integral one = integrate(k);
    all.value[k] = one.value;
    all.evaluations += one.evaluations;
    const bool larger = !(one.error_estimate <= all.error_estimate);
    if (larger) all.error_estimate = one.error_estimate;
    if (all.reached()) all.ending = one.ending, all.message = one.message;
  }
  return all;
}

/// Points of the box around the lamina, those outside the lamina counting as empty; the estimate is four
/// standard errors of the worst component, or none for points that are not random.
template <class NextPoint>
Answer hit_or_miss(const Lamina& l, long n, bool random, const NextPoint& next) {
  Six sum{}, squares{};
  Answer all{Six{}, 6 * n};
  for (long i = 0; i < n; ++i) {
    const auto [s, y] = next(i);
    const double x = l.left + (1 - l.left) * s;
    if (x * x > y) continue;
    const Six at = l.at(x, y);
    for (std::size_t k = 0; k < 6; ++k) sum[k] += at[k], squares[k] += at[k] * at[k];
  }
  const double box = 1 - l.left, count = static_cast<double>(n);
  double largest = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    const double mean = sum[k] / count, variance = squares[k] / count - mean * mean;
    all.value[k] = box * mean;
    largest = std::max(largest, variance);
  }
  if (random) all.error_estimate = 4 * box * sqrt(largest / count);
  return all;
}

/// The digits of i in the base, mirrored at the point (van der Corput's sequence).
double mirrored(long i, int base) {
  double x = 0;
  for (double digit = 1.0 / base; i > 0; i /= base, digit /= base) x += digit * static_cast<double>(i % base);
  return x;
}

Quantity inertia(const Parameters& p, const Lamina& l, std::string name, std::string says,
                 const Reference& truth) {
  Quantity all = quantity(std::move(name), "", std::move(says), truth("02_13_lamina", {l.left, l.z, l.rho}),
                          {1e-10 * l.rho, "ten decimals for a unit density"});
  const auto component = [l](std::size_t k) { return [l, k](double x, double y) { return l.at(x, y)[k]; }; };
  const auto by_columns = [=](const Rule& rule) {
    return six([&](std::size_t k) { return columns(rule, component(k), l.left); });
  };
  const auto by_rows = [=](const Rule& rule) {
    return six([&](std::size_t k) { return rows(rule, component(k), l.left, false); });
  };
  const auto by_root = [=](const Rule& rule) {
    return six([&](std::size_t k) { return rows(rule, component(k), l.left, true); });
  };
  const auto by_boundary = [=](const Rule& rule) {
    return six([&](std::size_t k) { return boundary(rule, l, k); });
  };
  const auto gauss = [](double n) {
    return Rule(
        [n](FunctionOfOne f, double a, double b) { return gauss_legendre(f, a, b, static_cast<int>(n)); });
  };
  const auto thirds = [](double n) {
    return Rule([n](FunctionOfOne f, double a, double b) { return simpson(f, a, b, static_cast<int>(n)); });
  };
  const auto adaptive = [](auto solver) {
    return [solver](double e) {
      return Rule([=](FunctionOfOne f, double a, double b) { return solver(f, a, b, e); });
    };
  };
  const Knob points = doubling("points", 1, 5), panels = doubling("panels", 2, 7);
  const auto add = [&](const std::string& model, const auto& by, const std::string& algorithm,
                       const Knob& knob, const auto& rule, Outcome expected = Outcome::ok,
                       const std::string& why = "") {
    all.add({model, algorithm, knob, [=](double setting) { return by(rule(setting)); }, expected, why});
  };
  const std::string low = "Simpson's error shrinks as h^4: too slow for ten decimals at 128 panels";
  const std::string root = "the row's width 2 sqrt(y) is not smooth at the vertex";
  add("columns", by_columns, "QAGS", tolerances(), adaptive(qags));
  add("columns", by_columns, "CQUAD", tolerances(), adaptive(cquad));
  add("columns", by_columns, "Gauss-Legendre", points, gauss);
  add("columns", by_columns, "Simpson", panels, thirds, Outcome::inaccurate, low);
  add("rows", by_rows, "QAGS", tolerances(), adaptive(qags));
  add("rows", by_rows, "CQUAD", tolerances(), adaptive(cquad));
  add("rows", by_rows, "Gauss-Legendre", points, gauss, Outcome::inaccurate, root);
  add("rows", by_rows, "Simpson", panels, thirds, Outcome::inaccurate, root);
  add("rows by sqrt(y)", by_root, "Gauss-Legendre", points, gauss);
  add("boundary", by_boundary, "QAGS", tolerances(), adaptive(qags));
  add("boundary", by_boundary, "Gauss-Legendre", points, gauss);
  add("boundary", by_boundary, "Simpson", panels, thirds, Outcome::inaccurate, low);

  const Knob samples{"samples", {256, 1024, 4096, 16384, 65536}};
  const double seed = p["seed"];
  all.add({"box around it", "Monte Carlo", samples,
           [=](double n) {
             Random random(seed);
             return hit_or_miss(l, static_cast<long>(n), true, [&](long) {
               const double s = random.unit();
               return std::array{s, random.unit()};
             });
           },
           Outcome::inaccurate, "the error shrinks as the root of the number of samples"});
  all.add({"box around it", "Halton points", samples,
           [=](double n) {
             return hit_or_miss(l, static_cast<long>(n), false, [](long i) {
               return std::array{mirrored(i + 1, 2), mirrored(i + 1, 3)};
             });
           },
           Outcome::inaccurate, "the edge of the lamina cuts through the box of samples"});
  all.add({"box around it", "square cells", samples,
           [=](double n) {
             const long side = std::lround(sqrt(n));
             const double h = 1 / static_cast<double>(side);
             return hit_or_miss(l, side * side, false, [=](long i) {
               return std::array{(static_cast<double>(i % side) + 0.5) * h,
                                 (static_cast<double>(i / side) + 0.5) * h};
             });
           },
           Outcome::inaccurate, "the edge of the lamina is a staircase of cells"});
  all.add(
      Breakdown{"Taken by rows, the same rule that is exact for columns never gets ten decimals: the width "
                "of a row, 2 sqrt(y), has no derivative at the vertex. Over u = sqrt(y) the integrand is a "
                "polynomial again, and four points are exact.",
                "rows, Gauss-Legendre", 16, Outcome::inaccurate, "rows by sqrt(y), Gauss-Legendre", 4});
  return all;
}

// ---- the claims -------------------------------------------------------------------------------------------

/// A rational number in lowest terms, its denominator positive.
struct Rational {
  long top = 0, bottom = 1;
  friend Rational operator+(Rational a, Rational b) {
    const long top = a.top * b.bottom + b.top * a.bottom, bottom = a.bottom * b.bottom;
    const long common = std::gcd(top, bottom);
    return {top / common, bottom / common};
  }
  operator Value() const { return {static_cast<double>(top), static_cast<double>(bottom)}; }
};

/// The integral of x^p y^q over the lamina, by rows: that of x^p dx is 2 y^((p+1)/2) / (p+1) for p even.
Rational moment(long p, long q) {
  return p % 2 == 0 ? Rational{} + Rational{4, (p + 1) * (p + 2 * q + 3)} : Rational{};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Component k from the definition of the angular momentum, at a point of unit density.
double by_definition(std::size_t k, const Vector& r) {
  constexpr std::size_t turned[] = {0, 1, 2, 1, 2, 2}, seen[] = {0, 1, 2, 0, 0, 1};
  Vector axis{};
  axis[turned[k]] = 1;
  return (k < 3 ? 1 : -1) * cross(r, cross(axis, r))[seen[k]];
}

const Rule sixteen = [](FunctionOfOne f, double a, double b) { return gauss_legendre(f, a, b, 16); };

using InSpace = std::function<double(double x, double y, double z)>;

/// A printed integrand by columns against component k from the definition by rows, over random laminas.
Check integrand_check(std::size_t k, const std::string& as, const InSpace& integrand, double seed,
                      double height = 1) {
  Worst worst(std::string(names[k]) + " of random laminas", "by columns of " + as,
              "r x (w x r) by rows over sqrt(y)");
  Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const double left = random.between(-1, 0.8), z = height * random.magnitude(0.1, 3);
    const double right = rows(
                             sixteen,
                             [=](double x, double y) {
                               return by_definition(k, {x, y, z});
                             },
                             left, true)
                             .value;
    worst.see(columns(
                  sixteen, [&](double x, double y) { return integrand(x, y, z); }, left)
                  .value,
              right, (1 + z * z) * (1 - left), "left = " + shortest(left) + ", z = " + shortest(z));
  }
  return worst.check();
}

Claim integrand_claim(std::size_t k, int line, const std::string& printed, const InSpace& f,
                      const std::string& near_text, const InSpace& near, double seed) {
  const std::string name(names[k]);
  std::string slug = name;
  slug[0] = 'i';
  Claim claim{"2.13-" + slug + "_integrand", line,
              name + " is the integral of " + printed + " over the region"};
  claim.printed = {printed, {integrand_check(k, printed, f, seed)}};
  claim.near_misses = {{near_text, {integrand_check(k, near_text, near, seed)}}};
  return claim;
}

Claim value_claim(std::size_t k, int line, Rational printed, Rational exact_value, Rational near) {
  const std::string name(names[k]);
  std::string slug = name;
  slug[0] = 'i';
  const auto text = [&](Rational r) {
    return name + " = " + std::to_string(r.top) + "/" + std::to_string(r.bottom);
  };
  const Integral numeric = rows(
      sixteen,
      [&](double x, double y) {
        return by_definition(k, {x, y, 0});
      },
      -1, true);
  const double size = rows(
                          sixteen,
                          [&](double x, double y) {
                            return abs(by_definition(k, {x, y, 0}));
                          },
                          -1, true)
                          .value;
  const auto reading = [&](Rational r) {
    Check rational{name, {"as printed", r}, {"by rows in rational numbers", exact_value}, exact()};
    Check quadrature{name,
                     {"as printed", static_cast<double>(r.top) / static_cast<double>(r.bottom)},
                     {"Gauss-Legendre by rows", numeric.value},
                     rounding(std::max(size, 0.1)),
                     std::max(size, 0.1)};
    return Reading{text(r), {rational, quadrature}};
  };
  Claim claim{"2.13-" + slug, line, text(printed)};
  claim.printed = reading(printed);
  claim.near_misses = {reading(near)};
  return claim;
}

Claim region(double seed) {
  Claim claim{"2.13-region", 667,
              "the points with x^2 <= y <= 1 are those with -1 <= x <= 1 and y from x^2 to 1"};
  const auto outside = [=](double bound) {
    Random random(seed);
    long samples = 0, violations = 0;
    while (samples < 1000) {
      const double x = random.between(-2, 2), y = random.between(-1, 2);
      if (x * x > y || y > 1) continue;
      ++samples;
      violations += !(abs(x) <= bound);
    }
    return never("a point of the region with |x| > " + shortest(bound), violations, samples);
  };
  const auto area = [](double bound) {
    const auto one = [](double, double) { return 1.0; };
    return Check{"area",
                 {"by columns, |x| <= " + shortest(bound),
                  nested(
                      sixteen, one, -bound, bound, [](double x) { return x * x; }, [](double) { return 1.0; })
                      .value},
                 {"4/3, by rows", 4.0 / 3},
                 rounding(4.0 / 3)};
  };
  claim.printed = {"-1 <= x <= 1", {outside(1), area(1)}};
  claim.near_misses = {{"|x| <= 0.9", {outside(0.9)}}, {"|x| <= 1.1", {area(1.1)}}};
  return claim;
}

/// The lines that lead to Ixx, one claim each.
std::vector<Claim> steps(double seed) {
  const auto y_squared = [](double, double y, double) { return y * y; };
  Claim flat{"2.13-ixx_without_z", 677, "with z = 0 the integrand of Ixx is y^2"};
  flat.printed = {"y^2, z = 0", {integrand_check(0, "y^2", y_squared, seed, 0)}};
  flat.near_misses = {{"y^2 at another height", {integrand_check(0, "y^2", y_squared, seed)}}};

  const auto slice = [](double x) {
    return gauss_legendre([](double y) { return y * y; }, x * x, 1, 8).value;
  };
  const auto inner_check = [=](double divisor) {
    Worst worst("inner integral at random x", "y^3/" + shortest(divisor) + " from x^2 to 1",
                "Gauss-Legendre of y^2");
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
      const double x = random.between(-1, 1), low = x * x;
      worst.see(1 / divisor - low * low * low / divisor, slice(x), 1, "x = " + shortest(x));
    }
    return worst.check();
  };
  Claim inner{"2.13-ixx_inner", 681, "the inner integral is y^3/3 between x^2 and 1"};
  inner.printed = {"y^3/3", {inner_check(3)}};
  inner.near_misses = {{"y^3/2", {inner_check(2)}}};

  const auto outer_check = [=](int power, double divisor) {
    const std::string as = "(1 - x^" + std::to_string(power) + ")/" + shortest(divisor);
    Worst worst("outer integrand at random x", as, "Gauss-Legendre of y^2 from x^2 to 1");
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
      const double x = random.between(-1, 1);
      worst.see((1 - std::pow(x, power)) / divisor, slice(x), 1, "x = " + shortest(x));
    }
    return worst.check();
  };
  Claim outer{"2.13-ixx_outer", 689, "the outer integrand is (1 - x^6)/3"};
  outer.printed = {"(1 - x^6)/3", {outer_check(6, 3)}};
  outer.near_misses = {{"(1 - x^5)/3", {outer_check(5, 3)}}, {"1 - x^6", {outer_check(6, 1)}}};

  const auto primitive_reading = [=](double divisor) {
    const auto primitive = [=](const auto& x) { return (x - x * x * x * x * x * x * x / divisor) / 3.0; };
    const std::string as = "(x - x^7/" + shortest(divisor) + ")/3";
    Worst slope("its derivative at random x", as, "Gauss-Legendre of y^2 from x^2 to 1");
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
      const double x = random.between(-1, 1);
      slope.see(derivative(primitive, x), slice(x), 1, "x = " + shortest(x));
    }
    const Check between{"Ixx",
                        {as + " between -1 and 1", primitive(1.0) - primitive(-1.0)},
                        {"4/7, by rows", 4.0 / 7},
                        rounding(1)};
    return Reading{as, {slope.check(), between}};
  };
  Claim last{"2.13-ixx_antiderivative", 695, "its antiderivative is (x - x^7/7)/3, between -1 and 1"};
  last.printed = primitive_reading(7);
  last.near_misses = {primitive_reading(6)};
  return {flat, inner, outer, last};
}

Claim similar() {
  Claim claim{"2.13-similar", 701,
              "the other components come from the same two nested integrals, dy then dx"};
  const auto by = [](const std::string& as, const Bound& low) {
    const Lamina book{-1, 0, 1};
    const auto all = six([&](std::size_t k) {
      return nested(
          sixteen, [=](double x, double y) { return book.at(x, y)[k]; }, -1, 1, low,
          [](double) { return 1.0; });
    });
    return Check{"(Ixx, ..., Iyz)",
                 {as, all.value},
                 {"by rows in rational numbers", {4.0 / 7, 4.0 / 15, 88.0 / 105, 0, 0, 0}},
                 rounding(1)};
  };
  claim.printed = {"y from x^2 to 1", {by("y from x^2 to 1", [](double x) { return x * x; })}};
  claim.near_misses = {{"y from |x| to 1", {by("y from |x| to 1", [](double x) { return abs(x); })}}};
  return claim;
}

std::vector<Claim> claims(double seed) {
  using D = double;
  std::vector<Claim> all{region(seed)};
  all.push_back(integrand_claim(
      0, 669, "y^2 + z^2", [](D, D y, D z) { return y * y + z * z; }, "y^2 - z^2",
      [](D, D y, D z) { return y * y - z * z; }, seed));
  for (const Claim& claim : steps(seed)) all.push_back(claim);
  all.push_back(value_claim(0, 699, {4, 7}, moment(0, 2), {2, 7}));
  all.push_back(similar());
  all.push_back(integrand_claim(
      1, 703, "x^2 + z^2", [](D x, D, D z) { return x * x + z * z; }, "y^2 + z^2",
      [](D, D y, D z) { return y * y + z * z; }, seed));
  all.push_back(value_claim(1, 707, {4, 15}, moment(2, 0), {4, 5}));
  all.push_back(integrand_claim(
      2, 711, "x^2 + y^2", [](D x, D y, D) { return x * x + y * y; }, "x^2 + y^2 + z^2",
      [](D x, D y, D z) { return x * x + y * y + z * z; }, seed));
  all.push_back(value_claim(2, 715, {88, 105}, moment(2, 0) + moment(0, 2), {32, 105}));
  all.push_back(integrand_claim(
      3, 719, "xy", [](D x, D y, D) { return x * y; }, "-xy", [](D x, D y, D) { return -x * y; }, seed));
  all.push_back(value_claim(3, 723, {0, 1}, moment(1, 1), {1, 6}));
  all.push_back(integrand_claim(
      4, 727, "xz", [](D x, D, D z) { return x * z; }, "yz", [](D, D y, D z) { return y * z; }, seed));
  all.push_back(value_claim(4, 731, {0, 1}, {0, 1}, {1, 4}));
  all.push_back(integrand_claim(
      5, 735, "yz", [](D, D y, D z) { return y * z; }, "xz", [](D x, D, D z) { return x * z; }, seed));
  all.push_back(value_claim(5, 735, {0, 1}, {0, 1}, {4, 5}));
  return all;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Lamina lamina{p["left"], p["z"], p["rho"]};
  return {claims(p["seed"]),
          {inertia(p, lamina, "inertia", "Ixx, Iyy, Izz, Ixy, Ixz, Iyz", truth),
           inertia(p, {-0.625, 1.5, 1}, "cut_inertia",
                   "the same for the lamina cut off at x = -0.625, at z = 1.5", truth)}};
}

}  // namespace

Exercise exercise_2_13() {
  return {"Inertia of a parabolic lamina",
          "Find $I_{xx}, I_{yy}, I_{zz}, I_{xy}, I_{xz}, I_{yz}$ of the flat region $x^2\\le y\\le 1$, "
          "$z=0$, with "
          "unit density.",
          parameters, false, study};
}

}  // namespace oddity
