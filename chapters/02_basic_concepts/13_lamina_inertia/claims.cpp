// The claims of exercise 2.13: the text's integrals by columns, checked by the definition by rows.

#include "chapters/integral_proofs.hpp"
#include "chapters/provable_claims.hpp"

#include <string>
#include <utility>
#include <vector>

#include "chapters/02_basic_concepts/13_lamina_inertia/lamina_inertia.hpp"

namespace oddity::lamina_inertia {

namespace {

using Fraction = std::array<long, 2>;

const Rule sixteen = gauss_rule(16);

/// The integral of x^p y^q over the lamina. That over a row is 2 y^(q+(p+1)/2) / (p+1) for even p. Both
/// factors of the denominator are odd then, so the fraction is in lowest terms.
Fraction moment(long p, long q) {
  return p % 2 == 0 ? Fraction{4, (p + 1) * (p + 2 * q + 3)} : Fraction{0, 1};
}
/// In lowest terms if the denominators have no common factor.
Fraction sum(Fraction a, Fraction b) { return {a[0] * b[1] + b[0] * a[1], a[1] * b[1]}; }

/// The components xx, yy, zz, xy, xz, yz of the lamina, where z = 0; by rows.
std::array<Fraction, 6> in_rationals() {
  const Fraction of_y2 = moment(0, 2), of_x2 = moment(2, 0), none{0, 1};
  return {of_y2, of_x2, sum(of_x2, of_y2), moment(1, 1), none, none};
}

/// The lamina cut off at x = left, at the height z.
template <class T>
struct CutOf {
  T left, z;
  Letters<T> table() { return {{"a", left, {-1, 0.8}, "left"}, {"z", z, either_sign(0.1, 3)}}; }
};
using Cut = CutOf<double>;

/// Component k by its definition: by rows, or as a statement in Coq.
template <class T>
T by_definition(std::size_t k, const CutOf<T>& c) {
  if constexpr (std::same_as<T, Shortened>) {
    using Point = std::array<T, 3>;
    const auto column = [&](const T& x) {
      const auto at = [&](const T& y) { return inertia_component(k, Point{x, y, c.z}); };
      return recorded_integral(at, pow(x, 2), 1);
    };
    return recorded_integral(column, c.left, 1);
  } else {
    const auto at = [&](double x, double y) { return inertia_by_definition(k, {x, y, c.z}); };
    return rows(sixteen, at, c.left, true).value;
  }
}
ProvableFormula<CutOf> definition(std::size_t k) {
  return {R"($\mathbf r\times(\mathbf w\times\mathbf r)$ by rows over $\sqrt y$)",
          [=](const auto& c) { return by_definition(k, c); },
          [](const Cut& c) { return (1 + c.z * c.z) * (1 - c.left); }};
}

/// A component with its printed integrand and value. `exact` is by rows, in rational numbers.
struct Component {
  std::string letters;
  int integrand_line, value_line;
  std::string integrand, value;
  Fraction exact;
};
std::array<Component, 6> components() {
  const auto by_rows = in_rationals();
  return {{{"xx", 669, 699, "(y^2+z^2)", R"(\tfrac{4}{7})", by_rows[0]},
           {"yy", 703, 707, "(x^2+z^2)", R"(\tfrac{4}{15})", by_rows[1]},
           {"zz", 711, 715, "(x^2+y^2)", R"(\tfrac{88}{105})", by_rows[2]},
           {"xy", 719, 723, "(xy)", "0", by_rows[3]},
           {"xz", 725, 729, "(xz)", "0", by_rows[4]},
           {"yz", 731, 735, "(yz)", "0", by_rows[5]}}};
}
double decimal(const Fraction& f) { return static_cast<double>(f[0]) / static_cast<double>(f[1]); }

/// The integral of `integrand` over the lamina for x >= `left`.
std::string over_lamina(const std::string& left, const std::string& integrand) {
  return R"(\int_)" + left + R"(^1\int_{x^2}^1)" + integrand + R"(\,dy\,dx$)";
}
void integral(ProvableClaims<CutOf>& table, const std::string& slug, int line, const std::string& says,
              const std::string& integrand, std::size_t k, const std::vector<Cut>& samples) {
  table.over(samples)(slug, line, says + over_lamina("{-1}", integrand), definition(k),
                      "$" + over_lamina("a", integrand),
                      "$I_{" + components()[k].letters + "}$ of laminas from $x=a$ on");
}
void integrands(ProvableClaims<CutOf>& table, const std::vector<Cut>& samples) {
  for (std::size_t k = 0; const Component& c : components())
    integral(table, "i" + c.letters + "_integrand", c.integrand_line, "$I_{" + c.letters + "}=", c.integrand,
             k++, samples);
}
void without_z(ProvableClaims<CutOf>& table, const std::vector<Cut>& samples) {
  integral(table, "ixx_without_z", 675, "With $z=0$: $I_{xx}=", "y^2", 0, samples);
}

/// The whole lamina, at z = 0.
struct Whole {
  double z = 0, area = 4.0 / 3;
  TypesetLetters typeset() const { return {{"z", z}}; }
  double size() const { return area; }
  Tolerance tolerance(double) const { return rounding(area); }
};
void value(Claims& claims, const Component& c, std::size_t k) {
  const std::string name = "$I_{" + c.letters + "}", right = name + "=" + c.value + "$";
  FormulaClaim<Whole> claim{
      .quantity = name + "$",
      .truth = {"Gauss-Legendre by rows",
                [=](const Whole& w) {
                  const auto at = [&](double x, double y) { return inertia_by_definition(k, {x, y, w.z}); };
                  return rows(sixteen, at, -1, true).value;
                }},
      .other_routes = {{"by rows, in rationals", [=](const Whole&) { return decimal(c.exact); }}},
      .printed = {right}};
  if (k == 0) {
    const double mass = gauss_legendre([](double x) { return 1 - x * x; }, -1, 1, 2).value;
    claim.meant = std::exchange(claim.printed, {name + "=47$"});
    claim.kind = Fault::lost_typography;
    claim.why = filled(
        R"(The fraction bar is lost: $\tfrac47$. The lamina lies within 1 of the axis, so that no moment )"
        R"(can be above its mass, @4.)",
        {mass});
  }
  claims.formula<Whole>("i" + c.letters, c.value_line, claim.printed.text, {{}}, claim);
}

template <class T>
struct ColumnOf {
  T x;
  Letters<T> table() { return {{"x", x, {-1, 1}}}; }
  /// The integral of y^2 from x^2 to 1.
  T inner() const {
    const auto square = [](const auto& y) { return y * y; };
    if constexpr (std::same_as<T, Shortened>)
      return recorded_integral(square, pow(x, 2), 1);
    else
      return sixteen(square, x * x, 1).value;
  }
  /// The integral of inner() over the columns from 0 to x.
  T up_to_here() const {
    if constexpr (std::same_as<T, Shortened>)
      return recorded_integral([](const T& at) { return ColumnOf{at}.inner(); }, 0, x);
    else
      return sixteen([](double at) { return ColumnOf{at}.inner(); }, 0, x).value;
  }
};
using Column = ColumnOf<double>;
using OfColumn = ProvableFormula<ColumnOf>;

/// Claims the lines that lead to Ixx.
void inner_integral(ProvableClaims<ColumnOf>& table, const std::vector<Column>& columns) {
  const auto claim = table.over(columns);
  const OfColumn truth{"Gauss-Legendre of $y^2$ from $x^2$ to 1", [](const auto& c) { return c.inner(); }};
  claim("ixx_inner", 681, "The inner integral of $I_{xx}$ is $y^3/3$ between $x^2$ and 1.", truth,
        "$1^3/3-(x^2)^3/3$", "the inner integral");
  claim("ixx_outer", 689, R"($I_{xx}=\int_{-1}^1\frac{1-x^6}3\,dx$)", truth, "$(1-x^6)/3$",
        "the inner integral");
}
const OfColumn from_columns{"Gauss-Legendre, nested", [](const auto&c) { return c.up_to_here(); }},
    printed = "$x-x^7/73$", meant = "$(x-x^7/7)/3$";
template <class T>
auto between_ends(const OfColumn& f) {
  if constexpr (std::same_as<T, Shortened>)
    return f.recorded({1.0})[0] - f.recorded({-1.0})[0];
  else
    return computed<Column>(f).of({1})[0] - computed<Column>(f).of({-1})[0];
}
void antiderivative(ProvableClaims<ColumnOf>& table, const std::vector<Column>& columns) {
  table.over(columns)(
      "ixx_antiderivative", 695, "$I_{xx}$ is $x-x^7/73$ between $-1$ and 1.",
      {.quantity = "the inner integral's integral from 0 to $x$",
       .truth = from_columns,
       .printed = printed,
       .meant = meant,
       .why = filled(
           "The bar above the 3 is lost: the difference of $(x-x^7/7)/3$ is @4, the integral. As printed it is @4.",
           {between_ends<double>(meant), between_ends<double>(printed)})});
}

struct Point {
  double x, y;
  Letters<double> table() { return {{"x", x, {-2, 2}}, {"y", y, {-1, 2}}}; }
};
double wedge(double x) { return abs(x); }

void region_and_order(Claims& claims, double seed) {
  // whether the lamina and the region |x| <= bound, low(x) <= y <= 1 both contain the point, or neither
  const auto in = [](double bound, double (*low)(double)) {
    return [=](const Point& p) {
      return (p.x * p.x <= p.y && p.y <= 1) == (abs(p.x) <= bound && low(p.x) <= p.y && p.y <= 1);
    };
  };
  claims.statement<Point>(
      "region", 667, R"(The region is $x^2\le y\le1$, $-1\le x\le1$.)", draw<Point>(4000, seed),
      {.printed = {R"(a point is in the lamina where $|x|\le1$, $x^2\le y\le1$)", in(1, parabola)},
       .near_misses = {{R"(where $|x|\le0.9$, $x^2\le y\le1$)", in(0.9, parabola)},
                       {R"(where $|x|\le y\le1$)", in(1, wedge)}}});
  std::vector<double> by_rows;
  for (const Fraction& f : in_rationals()) by_rows.push_back(decimal(f));
  const auto from = [&](const std::string& text, double (*low)(double)) {
    const auto all = all_of(6, [&](std::size_t k) {
      const auto at = [=](double x, double y) { return Lamina{-1, 0, 1}.at(x, y)[k]; };
      return nested(sixteen, at, -1, 1, low, top);
    });
    const Route by_columns{"columns, $y$ " + text, all.value};
    return Reading{text,
                   {{"the six components", by_columns, {"by rows, in rationals", by_rows}, rounding(1)}}};
  };
  claims.add(
      "similar", 701,
      "The constructions are similar for the other components (our reading: the same two integrals, $dy$ then "
      "$dx$).",
      {.printed = from("from $x^2$ to 1", parabola), .near_misses = {from("from $|x|$ to 1", wedge)}});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("2.13");
  region_and_order(claims, seed);
  ProvableClaims<CutOf> of_cuts(claims);
  auto cuts = draw<Cut>(4, seed);
  integrands(of_cuts, cuts);
  for (Cut& cut : cuts) cut.z = 0;
  without_z(of_cuts, cuts);
  for (std::size_t k = 0; const Component& c : components()) value(claims, c, k++);
  auto columns = draw<Column>(50, seed);
  columns.insert(columns.begin(), {{-1}, {1}});
  ProvableClaims<ColumnOf> of_columns(claims);
  inner_integral(of_columns, columns);
  antiderivative(of_columns, columns);
  return claims.in_order();
}

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

/// The antiderivatives by y, and those by x of their differences.
constexpr const char* antiderivatives[] = {
    "nest (fun x y : R => y ^ 3 / 3) (fun x : R => (x - x ^ 7 / 7) / 3)",
    "nest (fun x y : R => x ^ 2 * y) (fun x : R => x ^ 3 / 3 - x ^ 5 / 5)",
    "nest (fun x y : R => x ^ 2 * y + y ^ 3 / 3) (fun x : R => x ^ 3 / 3 - x ^ 5 / 5 + (x - x ^ 7 / 7) / 3)",
    "nest (fun x y : R => x * y ^ 2 / 2) (fun x : R => (x ^ 2 / 2 - x ^ 6 / 6) / 2)",
    "nest (fun x y : R => 0 * x * y) (fun x : R => 0 * x)",
    "nest (fun x y : R => 0 * x * y) (fun x : R => 0 * x)"};

/// The component's integral over the whole lamina.
Expression component_integral(std::size_t k) { return by_definition<Shortened>(k, {-1.0, 0.0}).expression(); }

}  // namespace

Provables proofs() {
  Provables proved;
  std::vector<Lemma> similar;
  for (std::size_t k = 0; const Component& c : components()) {
    const auto [over, under] = c.exact;
    const Expression value = Expression(static_cast<double>(over)) / Expression(static_cast<double>(under));
    similar.push_back({c.letters, "", {}, {component_integral(k) == value}, antiderivatives[k]});
    proved.push_back(
        {"2.13-i" + c.letters, "the integral of its definition is this value", {similar.back()}});
    ++k;
  }
  const auto off = [&](const Expression& printed, double margin) {
    const std::string is =
        "match goal with |- context [RInt ?f ?a ?b] => "
        "let is := fresh in assert (is : RInt f a b = 4 / 7) by (";
    const Proposition differ = apart(printed, component_integral(0), margin);
    const std::string tactic = is + antiderivatives[0] + "); rewrite is end; " + by_arithmetic;
    return Lemma{"printed_differs", "", {}, {differ}, tactic};
  };
  proved.front().lemmas.push_back(off(47.0, 46.4));
  proved.front().margin = 46.4;
  proved.front().says = "as meant it is the integral of its definition; as printed it is off";
  proved.push_back(
      {"2.13-similar", "the six components are these two integrals of their definitions", similar});

  const std::string by_column =
      "apply RInt_ext; intros; apply RInt_ext; intros; cbv beta;\n"
      "  match goal with |- ?x = ?y => change (@eq R x y) end; ring";
  const std::string by_cube = "symmetry; integrate (fun y : R => y ^ 3 / 3); field";
  Claims claims("2.13");
  ProvableClaims<CutOf> of_cuts(claims), flat(claims);
  integrands(of_cuts, {});
  without_z(flat, {});
  append(proved,
         of_cuts.proofs("2.13", for_all<CutOf>(by_column, "it is that of the definition over any lamina")));
  append(proved, flat.proofs("2.13", {.any = {Shortened::letter("left"), 0.0},
                                      .letters = "(left : R)",
                                      .tactic = by_column,
                                      .says = "it is that of the definition at z = 0 over any lamina"}));
  ProvableClaims<ColumnOf> of_columns(claims);
  inner_integral(of_columns, {});
  const auto column = for_all<ColumnOf>(by_cube, "it is the integral of a column, wherever it is");
  const auto is_integral = equal(meant.recorded(column.any), from_columns.recorded(column.any));
  append(proved, of_columns.proofs("2.13", column));
  proved.push_back(
      {"2.13-ixx_antiderivative",
       "as meant it is the integral up to any column, and its ends make the whole; as printed they do not",
       {{"meant", column.letters, {}, is_integral, "symmetry; " + std::string(antiderivatives[0])},
        {"meant_ends", "", {}, {component_integral(0) == between_ends<Shortened>(meant)}, antiderivatives[0]},
        off(between_ends<Shortened>(printed), 1.4)},
       1.4});
  for (Provable& one : proved) one.preamble = coq_source({"nested"});
  return proved;
}

}  // namespace oddity::lamina_inertia
