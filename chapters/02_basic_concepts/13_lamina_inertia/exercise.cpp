// Exercise 2.13: the six inertia components of the lamina x^2 <= y <= 1, z = 0, of density 1.
//   J w = int r x (w x r) dm;  Ixx = ex . J ex, ..., Ixy = -ex . J ey, ...   the definition
//   int x^p y^q over the lamina = 4 / ((p+1)(p+2q+3)) for p even, 0 for p odd   by rows of constant y
// The text integrates columns (dy dx). The other routes integrate rows (dx dy), where no formula of the text
// occurs: exactly in rational numbers, or numerically from the definition. For the integrands the lamina is
// also cut off at x = left and moved to the height z, so that no component vanishes.

#include <numeric>
#include <utility>

#include "chapters/02_basic_concepts/13_lamina_inertia/parabolic_lamina.hpp"
#include "solvers/dual.hpp"

namespace oddity {

namespace ex02_13 {

using namespace lamina;
using InSpace = std::function<double(double x, double y, double z)>;

constexpr Parameter parameters[] = {
    {"left", -1, "", "left end of the lamina; the whole parabola begins at -1", -1, 0.9},
    {"z", 0, "", "height of the lamina's plane", -10, 10},
    {"rho", 1, "", "mass of a unit area", 1e-3, 1e3},
    {"seed", 13, "", "of the random samples", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

const Rule sixteen = gauss_rule(16);

/// A component with its printed integrand and value, and a near miss of each; `exact`: by rows, in rational
/// numbers.
struct Component {
  std::string name;
  int integrand_line, value_line;
  std::string integrand;
  InSpace printed;
  std::string near_integrand;
  InSpace near;
  std::array<long, 2> value, near_value, exact;
};

/// The integral of x^p y^q over the lamina, that over a row being 2 y^(q+(p+1)/2) / (p+1) for p even.
std::array<long, 2> moment(long p, long q) {
  const long bottom = (p + 1) * (p + 2 * q + 3), common = std::gcd(4L, bottom);
  return p % 2 == 0 ? std::array{4 / common, bottom / common} : std::array{0L, 1L};
}

std::array<long, 2> sum(std::array<long, 2> a, std::array<long, 2> b) {
  const long over = a[0] * b[1] + b[0] * a[1], under = a[1] * b[1], common = std::gcd(over, under);
  return {over / common, under / common};
}

/// A printed integrand by columns against component k from the definition by rows, over random laminas.
Check integrand_check(std::size_t k, const std::string& as, const InSpace& f, double seed, double up = 1) {
  Worst worst("the component of random laminas, " + as + " by columns against r x (w x r) by rows",
              "by columns of " + as, "r x (w x r) by rows over sqrt(y)");
  Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const double left = random.between(-1, 0.8), z = up * random.magnitude(0.1, 3);
    const auto definition = [=](double x, double y) { return inertia_by_definition(k, {x, y, z}); };
    worst.see(columns(
                  sixteen, [&](double x, double y) { return f(x, y, z); }, left)
                  .value,
              rows(sixteen, definition, left, true).value, (1 + z * z) * (1 - left),
              "left = " + shortest(left) + ", z = " + shortest(z));
  }
  return worst.check();
}

Reading value_reading(const Component& c, std::size_t k, const std::array<long, 2>& value) {
  const double size = 4.0 / 3;  // the area
  const auto definition = [=](double x, double y) { return inertia_by_definition(k, {x, y, 0}); };
  const auto pair = [](const std::array<long, 2>& r) {
    return Value{static_cast<double>(r[0]), static_cast<double>(r[1])};
  };
  const std::string text = value[0] == 0 ? "0" : std::to_string(value[0]) + "/" + std::to_string(value[1]);
  const double decimal = static_cast<double>(value[0]) / static_cast<double>(value[1]);
  return {
      c.name + " = " + text,
      {{c.name + " as a fraction", {text, pair(value)}, {"by rows, in rationals", pair(c.exact)}, exact()},
       {c.name,
        {text, decimal},
        {"Gauss-Legendre by rows", rows(sixteen, definition, -1, true).value},
        rounding(size),
        size}}};
}

std::vector<Claim> component_claims(const Component& c, std::size_t k, double seed) {
  const std::string id = "2.13-i" + c.name.substr(1);
  Claim integrand{id + "_integrand", c.integrand_line, c.name + " integrates " + c.integrand};
  integrand.printed = {c.integrand, {integrand_check(k, c.integrand, c.printed, seed)}};
  integrand.near_misses = {{c.near_integrand, {integrand_check(k, c.near_integrand, c.near, seed)}}};
  Claim value{id, c.value_line, ""};
  value.printed = value_reading(c, k, c.value);
  value.near_misses = {value_reading(c, k, c.near_value)};
  value.says = value.printed.text;
  if (k == 0) {
    value.says = "Ixx = 47";
    value.meant = std::exchange(value.printed, value_reading(c, k, {47, 1}));
    value.why =
        "The fraction bar is lost in the text at hand: $\\tfrac47$. The lamina has the mass $\\tfrac43$ and "
        "lies within 1 of the axis, so that no moment can be above $\\tfrac43$.";
  }
  return {integrand, value};
}

/// A function of x against the inner integral of y^2 from x^2 to 1, at random x.
template <class F>
Check against_inner(const std::string& as, const F& f, double seed) {
  Worst worst("inner integral at random x, against Gauss-Legendre", as,
              "Gauss-Legendre of y^2 from x^2 to 1");
  Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const double x = random.between(-1, 1);
    worst.see(f(x), sixteen([](double y) { return y * y; }, x * x, 1).value, 1, "x = " + shortest(x));
  }
  return worst.check();
}

/// The lines that lead to Ixx.
std::vector<Claim> steps(double seed) {
  const auto squared = [](double, double y, double) { return y * y; };
  Claim flat{"2.13-ixx_without_z", 677, "with z = 0 the integrand of Ixx is y^2"};
  flat.printed = {"y^2, z = 0", {integrand_check(0, "y^2", squared, seed, 0)}};
  flat.near_misses = {{"y^2 at another height", {integrand_check(0, "y^2", squared, seed)}}};

  const auto between = [](double divisor) {
    return [=](double x) { return (1 - std::pow(x * x, 3)) / divisor; };
  };
  Claim inner{"2.13-ixx_inner", 681, "the inner integral is y^3/3 between x^2 and 1"};
  inner.printed = {"y^3/3", {against_inner("y^3/3 between x^2 and 1", between(3), seed)}};
  inner.near_misses = {{"y^3/2", {against_inner("y^3/2 between x^2 and 1", between(2), seed)}}};

  const auto power = [](int n) { return [=](double x) { return (1 - std::pow(x, n)) / 3; }; };
  Claim outer{"2.13-ixx_outer", 689, "the outer integrand is (1 - x^6)/3"};
  outer.printed = {"(1 - x^6)/3", {against_inner("(1 - x^6)/3", power(6), seed)}};
  outer.near_misses = {{"(1 - x^5)/3", {against_inner("(1 - x^5)/3", power(5), seed)}}};

  const double by_rows = nested(
                             sixteen, [](double, double y) { return y * y; }, -1, 1, parabola, top)
                             .value;
  const auto primitive = [=](double divisor) {
    const auto f = [=](const auto& x) { return (x - x * x * x * x * x * x * x / divisor) / 3.0; };
    const std::string as = "(x - x^7/" + shortest(divisor) + ")/3";
    const Check ends{"Ixx",
                     {as + " between -1 and 1", f(1.0) - f(-1.0)},
                     {"Gauss-Legendre by rows", by_rows},
                     rounding(1)};
    return Reading{as,
                   {against_inner(
                        "derivative of " + as, [=](double x) { return derivative(f, x); }, seed),
                    ends}};
  };
  const auto as_it_stands = [=] {
    const auto f = [](const auto& x) { return x - x * x * x * x * x * x * x / 73.0; };
    return Reading{"x - x^7/73",
                   {against_inner(
                       "derivative of x - x^7/73", [=](double x) { return derivative(f, x); }, seed)}};
  };
  Claim last{"2.13-ixx_antiderivative", 695, "the antiderivative, between -1 and 1, is x - x^7/73"};
  last.printed = as_it_stands();
  last.meant = primitive(7);
  last.near_misses = {primitive(6)};
  last.why =
      "The bar above the 3 is lost in the text at hand: $(x-x^7/7)/3$, whose difference is $\\tfrac47$. As "
      "it "
      "stands it is $\\tfrac{144}{73}$.";
  return {flat, inner, outer, last};
}

Claim region(double seed) {
  Claim claim{"2.13-region", 667, "the region is -1 <= x <= 1 with y from x^2 to 1"};
  const auto check = [=](const std::string& as, double bound, const Bound& low) {
    Random random(seed);
    long samples = 0, wrong = 0;
    for (; samples < 4000; ++samples) {
      const double x = random.between(-2, 2), y = random.between(-1, 2);
      wrong += (x * x <= y && y <= 1) != (abs(x) <= bound && low(x) <= y && y <= 1);
    }
    return Reading{as, {never("points in one set and not in the other", wrong, samples)}};
  };
  claim.printed = check("|x| <= 1, x^2 <= y <= 1", 1, parabola);
  claim.near_misses = {check("|x| <= 0.9", 0.9, parabola),
                       check("|x| <= y <= 1", 1, [](double x) { return abs(x); })};
  return claim;
}

Claim similar() {
  Claim claim{"2.13-similar", 701, "the other components come from the same two integrals, dy then dx"};
  const auto check = [](const std::string& as, const Bound& low) {
    const auto all = all_of(6, [&](std::size_t k) {
      const auto at = [=](double x, double y) { return Lamina{-1, 0, 1}.at(x, y)[k]; };
      return nested(sixteen, at, -1, 1, low, top);
    });
    return Reading{as,
                   {{"the six components, by columns against rows in rationals",
                     {"y from " + as + " to 1", all.value},
                     {"by rows, in rationals", {4.0 / 7, 4.0 / 15, 88.0 / 105, 0, 0, 0}},
                     rounding(1)}}};
  };
  claim.printed = check("x^2", parabola);
  claim.near_misses = {check("|x|", [](double x) { return abs(x); })};
  return claim;
}

std::vector<Claim> claims(double seed) {
  using D = double;
  const auto xx = [](D x, D, D z) { return x * x + z * z; };
  const auto yy = [](D, D y, D z) { return y * y + z * z; };
  const auto zz = [](D x, D y, D) { return x * x + y * y; };
  const auto xy = [](D x, D y, D) { return x * y; };
  const auto minus_xy = [](D x, D y, D) { return -x * y; };
  const auto xz = [](D x, D, D z) { return x * z; };
  const auto yz = [](D, D y, D z) { return y * z; };
  const auto polar = sum(moment(0, 2), moment(2, 0));
  const Component all[] = {
      {"Ixx", 669, 699, "y^2 + z^2", yy, "x^2 + z^2", xx, {4, 7}, {2, 7}, moment(0, 2)},
      {"Iyy", 703, 707, "x^2 + z^2", xx, "x^2 + y^2", zz, {4, 15}, {4, 5}, moment(2, 0)},
      {"Izz", 711, 715, "x^2 + y^2", zz, "y^2 + z^2", yy, {88, 105}, {32, 105}, polar},
      {"Ixy", 719, 723, "xy", xy, "-xy", minus_xy, {0, 1}, {1, 6}, moment(1, 1)},
      {"Ixz", 727, 731, "xz", xz, "yz", yz, {0, 1}, {1, 4}, {0, 1}},
      {"Iyz", 735, 735, "yz", yz, "xz", xz, {0, 1}, {4, 5}, {0, 1}},
  };
  std::vector<Claim> claims{region(seed), similar()};
  for (std::size_t k = 0; k < 6; ++k)
    for (Claim& claim : component_claims(all[k], k, seed)) claims.push_back(std::move(claim));
  for (Claim& claim : steps(seed)) claims.push_back(std::move(claim));
  std::ranges::stable_sort(claims, {}, &Claim::line);
  return claims;
}

Findings study(const Parameters& p, const Reference& truth) {
  Quantity whole =
      inertia("inertia", "Ixx, Iyy, Izz, Ixy, Ixz, Iyz", {p["left"], p["z"], p["rho"]}, p["seed"], truth);
  Quantity cut = inertia("cut_inertia", "the same of the lamina cut off at x = -0.625, at z = 1.5",
                         {-0.625, 1.5, 1}, p["seed"], truth);
  cut.add(
      Breakdown{"Sixteen Gauss points, exact for the columns, give four decimals by rows: the width of a "
                "row, 2 sqrt(y), has no derivative at the vertex. Over u = sqrt(y) the integrand is a "
                "polynomial again, and four points are exact.",
                "rows, Gauss-Legendre", 16, Outcome::inaccurate, "rows by sqrt(y), Gauss-Legendre", 4});
  return {claims(p["seed"]), {whole, cut}};
}

}  // namespace ex02_13

Exercise exercise_2_13() {
  using namespace ex02_13;
  return {"Inertia of a parabolic lamina",
          "Find $I_{xx}, I_{yy}, I_{zz}, I_{xy}, I_{xz}, I_{yz}$ of the flat region $x^2\\le y\\le 1$, "
          "$z=0$, with unit density.",
          parameters,
          {},
          study};
}

}  // namespace oddity
