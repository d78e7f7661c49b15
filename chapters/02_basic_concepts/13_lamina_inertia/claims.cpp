// The claims of exercise 2.13: the text's integrals by columns, against the definition by rows.

#include "chapters/claims.hpp"
#include "chapters/integral_proofs.hpp"
#include "chapters/provable.hpp"

#include <string>
#include <vector>

#include "chapters/02_basic_concepts/13_lamina_inertia/lamina_inertia.hpp"
#include "solvers/dual.hpp"

namespace oddity::lamina_inertia {

namespace {

using Fraction = std::array<long, 2>;
using InSpace = double (*)(double x, double y, double z);

const Rule sixteen = gauss_rule(16);

/// The integral of x^p y^q over the lamina, that over a row being 2 y^(q+(p+1)/2) / (p+1) for p even; both
/// factors are odd then, and the fraction is in lowest terms.
Fraction moment(long p, long q) {
  return p % 2 == 0 ? Fraction{4, (p + 1) * (p + 2 * q + 3)} : Fraction{0, 1};
}
/// In lowest terms where the denominators have no factor in common.
Fraction sum(Fraction a, Fraction b) { return {a[0] * b[1] + b[0] * a[1], a[1] * b[1]}; }

/// The components xx, yy, zz, xy, xz, yz of the lamina, where z = 0; by rows.
std::array<Fraction, 6> in_rationals() {
  const Fraction of_y2 = moment(0, 2), of_x2 = moment(2, 0), none{0, 1};
  return {of_y2, of_x2, sum(of_x2, of_y2), moment(1, 1), none, none};
}

/// The lamina cut off at x = left, at the height z.
struct Cut {
  double left, z;
  std::array<double*, 2> letters() { return {&left, &z}; }
  std::string where() const { return "left = " + format_shortest(left) + ", $z$ = " + format_shortest(z); }
};
std::vector<Cut> cuts(double seed, double up = 1) {
  Random random(seed);
  std::vector<Cut> all;
  for (int i = 0; i < 20; ++i) {
    const double left = random.between(-1, 0.8);
    all.push_back({left, up * random.magnitude(0.1, 3)});
  }
  return all;
}
Formula<Cut> by_columns(const std::string& text, InSpace f) {
  return {text + ", by columns", [=](const Cut& c) {
            return columns(
                       sixteen, [&](double x, double y) { return f(x, y, c.z); }, c.left)
                .value;
          }};
}
Formula<Cut> by_definition(std::size_t k) {
  return {R"($\mathbf r\times(\mathbf w\times\mathbf r)$ by rows over $\sqrt y$)",
          [=](const Cut& c) {
            const auto at = [&](double x, double y) { return inertia_by_definition(k, {x, y, c.z}); };
            return rows(sixteen, at, c.left, true).value;
          },
          [](const Cut& c) { return (1 + c.z * c.z) * (1 - c.left); }};
}

/// A component with its printed integrand and value, and a near miss of each; `exact`: by rows, in rational
/// numbers.
struct Component {
  std::string letters;
  int integrand_line, value_line;
  std::string integrand;
  InSpace printed;
  std::string near_integrand;
  InSpace near;
  Fraction value, near_value, exact;
};

Reading value_of(const Component& c, std::size_t k, const Fraction& value) {
  const double size = 4.0 / 3;  // the area
  const auto definition = [=](double x, double y) { return inertia_by_definition(k, {x, y, 0}); };
  const auto pair = [](const Fraction& r) {
    return Value{static_cast<double>(r[0]), static_cast<double>(r[1])};
  };
  const std::string over = std::to_string(value[0]), under = std::to_string(value[1]),
                    text = "$" + (value[1] == 1 ? over : R"(\tfrac{)" + over + "}{" + under + "}") + "$",
                    name = "$I_{" + c.letters + "}$";
  const double decimal = static_cast<double>(value[0]) / static_cast<double>(value[1]);
  return {text,
          {{name + " as a fraction", {text, pair(value)}, {"by rows, in rationals", pair(c.exact)}, exact()},
           {name,
            {text, decimal},
            {"Gauss-Legendre by rows", rows(sixteen, definition, -1, true).value},
            rounding(size),
            size}},
          is_as_typeset(compare_typeset(text, {{TypesetLetters{}, Value(decimal)}}))};
}

void component(Claims& claims, const Component& c, std::size_t k, double seed) {
  const std::string slug = "i" + c.letters, name = "I_{" + c.letters + "}";
  claims.formula(slug + "_integrand", c.integrand_line,
                 "$" + name + R"(=\int_{-1}^1\int_{x^2}^1()" + c.integrand.substr(1, c.integrand.size() - 2) +
                     R"()\,dy\,dx$)",
                 cuts(seed),
                 {.quantity = "$" + name + "$ of random laminas",
                  .truth = by_definition(k),
                  .printed = by_columns(c.integrand, c.printed),
                  .near_misses = {by_columns(c.near_integrand, c.near)}});
  const Reading value = value_of(c, k, c.value), near = value_of(c, k, c.near_value);
  if (k > 0) {
    claims.add(slug, c.value_line, "$" + name + "=" + value.text.substr(1),
               {.printed = value, .near_misses = {near}});
    return;
  }
  const double mass = gauss_legendre([](double x) { return 1 - x * x; }, -1, 1, 2).value;
  claims.add(
      slug, c.value_line, "$" + name + "=47$",
      {.printed = value_of(c, k, {47, 1}),
       .meant = value,
       .near_misses = {near},
       .why = filled(
           R"(The fraction bar is lost in the text at hand: $\tfrac47$. The lamina has the mass @4 and )"
           R"(lies within 1 of the axis, so that no moment can be above @4.)",
           {mass, mass}),
       .kind = Fault::lost_typography});
}

template <class T>
struct ColumnOf {
  T x;
};
struct Column : ColumnOf<double> {
  explicit Column(Random& random) : ColumnOf{random.between(-1, 1)} {}
  std::array<double*, 1> letters() { return {&x}; }
  TypesetLetters typeset() const { return {{"x", x}}; }
  std::string where() const { return "$x$ = " + format_shortest(x); }
};
const Formula<Column> inner_integral{"Gauss-Legendre of $y^2$ from $x^2$ to 1", [](const Column& c) {
                                       return sixteen([](double y) { return y * y; }, c.x * c.x, 1).value;
                                     }};

/// The inner integral, and the antiderivative of what it makes.
constexpr auto between = [](const auto& c, double divisor) {
  using std::pow;
  return (1 - pow(c.x * c.x, 3)) / divisor;
};
constexpr auto power = [](const auto& c, int n) {
  using std::pow;
  return (1 - pow(c.x, n)) / 3;
};
constexpr auto antiderivative = [](const auto& x, double seventh, double over) {
  return (x - x * x * x * x * x * x * x / seventh) / over;
};

/// What the components integrate by the text.
constexpr auto y_squared = [](auto, auto y, auto) { return y * y; };
constexpr auto xx = [](auto x, auto, auto z) { return x * x + z * z; };
constexpr auto yy = [](auto, auto y, auto z) { return y * y + z * z; };
constexpr auto zz = [](auto x, auto y, auto) { return x * x + y * y; };
constexpr auto xy = [](auto x, auto y, auto) { return x * y; };
constexpr auto xz = [](auto x, auto, auto z) { return x * z; };
constexpr auto yz = [](auto, auto y, auto z) { return y * z; };

/// The lines that lead to Ixx.
void steps(Claims& claims, double seed) {
  const auto columns_of = draw<Column>(50, seed);
  const auto flat = [&](const std::string& text, double up) {
    return Reading{text,
                   {compare("$I_{xx}$ of random laminas", by_columns("$y^2$", y_squared), by_definition(0),
                            cuts(seed, up))}};
  };
  claims.add("ixx_without_z", 677, R"(With $z=0$: $I_{xx}=\int_{-1}^1\int_{x^2}^1y^2\,dy\,dx$)",
             {.printed = flat("$y^2$ at $z=0$", 0), .near_misses = {flat("$y^2$ at another height", 1)}});
  const auto cube = [](double divisor) { return [=](const Column& c) { return between(c, divisor); }; };
  claims.formula("ixx_inner", 681, "The inner integral of $I_{xx}$ is $y^3/3$ between $x^2$ and 1.",
                 columns_of,
                 {.quantity = "the inner integral",
                  .truth = inner_integral,
                  .printed = {"$y^3/3$ between $x^2$ and 1", cube(3)},
                  .near_misses = {{"$y^3/2$ between $x^2$ and 1", cube(2)}}});
  claims.formula("ixx_outer", 689, R"($I_{xx}=\int_{-1}^1\frac{1-x^6}3\,dx$)", columns_of,
                 {.quantity = "the inner integral", .truth = inner_integral, .printed = {"$(1-x^6)/3$"}});

  const double by_rows = nested(
                             sixteen, [](double, double y) { return y * y; }, -1, 1, parabola, top)
                             .value;
  const auto primitive = [&](const std::string& text, double seventh, double over) {
    const auto f = [=](const auto& x) { return antiderivative(x, seventh, over); };
    return Reading{
        text,
        {compare("the inner integral",
                 {"the derivative of " + text, [=](const Column& c) { return derivative(f, c.x); }},
                 inner_integral, columns_of),
         {"$I_{xx}$",
          {text + " between $-1$ and 1", f(1.0) - f(-1.0)},
          {"Gauss-Legendre by rows", by_rows},
          rounding(1)}},
        is_as_typeset(
            compare_typeset(Formula<Column>{text, [=](const Column& c) { return f(c.x); }}, columns_of))};
  };
  claims.add(
      "ixx_antiderivative", 695, "$I_{xx}$ is $x-x^7/73$ between $-1$ and 1.",
      {.printed = primitive("$x-x^7/73$", 73, 1),
       .meant = primitive("$(x-x^7/7)/3$", 7, 3),
       .near_misses = {primitive("$(x-x^7/6)/3$", 6, 3)},
       .why = filled(
           "The bar above the 3 is lost in the text at hand: $(x-x^7/7)/3$, whose difference is @4, the integral. "
           "As it stands it is @4.",
           {by_rows, antiderivative(1.0, 73, 1) - antiderivative(-1.0, 73, 1)}),
       .kind = Fault::lost_typography});
}

struct Point {
  double x, y;
  explicit Point(Random& random) : x(random.between(-2, 2)), y(random.between(-1, 2)) {}
  std::string where() const { return "$(x,y)$ = (" + format_shortest(x) + ", " + format_shortest(y) + ")"; }
  /// The point is in the lamina and in |x| <= bound, low(x) <= y <= 1, or in neither.
  bool alike(double bound, double (*low)(double)) const {
    return (x * x <= y && y <= 1) == (abs(x) <= bound && low(x) <= y && y <= 1);
  }
};
double wedge(double x) { return abs(x); }

void region_and_order(Claims& claims, double seed) {
  const auto in = [](double bound, double (*low)(double)) {
    return [=](const Point& p) { return p.alike(bound, low); };
  };
  claims.statement<Point>(
      "region", 667, R"(The region is $x^2\le y\le1$, $-1\le x\le1$.)", draw<Point>(4000, seed),
      {.printed = {R"(a point is in the lamina where $|x|\le1$, $x^2\le y\le1$)", in(1, parabola)},
       .near_misses = {{R"(where $|x|\le0.9$, $x^2\le y\le1$)", in(0.9, parabola)},
                       {R"(where $|x|\le y\le1$)", in(1, wedge)}}});
  std::vector<double> by_rows;
  for (const Fraction& f : in_rationals())
    by_rows.push_back(static_cast<double>(f[0]) / static_cast<double>(f[1]));
  const auto from = [&](const std::string& text, double (*low)(double)) {
    const auto all = all_of(6, [&](std::size_t k) {
      const auto at = [=](double x, double y) { return Lamina{-1, 0, 1}.at(x, y)[k]; };
      return nested(sixteen, at, -1, 1, low, top);
    });
    return Reading{text,
                   {{"the six components",
                     {"columns, $y$ " + text, all.value},
                     {"by rows, in rationals", by_rows},
                     rounding(1)}}};
  };
  claims.add(
      "similar", 701,
      "The constructions are similar for the other components: the same two integrals, $dy$ then $dx$.",
      {.printed = from("from $x^2$ to 1", parabola), .near_misses = {from("from $|x|$ to 1", wedge)}});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const InSpace minus_xy = [](double x, double y, double) { return -x * y; };
  const auto by_rows = in_rationals();
  const Component all[] = {
      {"xx", 669, 699, "$y^2+z^2$", yy, "$x^2+z^2$", xx, {4, 7}, {2, 7}, by_rows[0]},
      {"yy", 703, 707, "$x^2+z^2$", xx, "$x^2+y^2$", zz, {4, 15}, {4, 5}, by_rows[1]},
      {"zz", 711, 715, "$x^2+y^2$", zz, "$y^2+z^2$", yy, {88, 105}, {32, 105}, by_rows[2]},
      {"xy", 719, 723, "$xy$", xy, "$-xy$", minus_xy, {0, 1}, {1, 6}, by_rows[3]},
      {"xz", 727, 731, "$xz$", xz, "$yz$", yz, {0, 1}, {1, 4}, by_rows[4]},
      {"yz", 735, 735, "$yz$", yz, "$xz$", xz, {0, 1}, {4, 5}, by_rows[5]},
  };
  Claims claims("2.13");
  region_and_order(claims, seed);
  for (std::size_t k = 0; k < 6; ++k) component(claims, all[k], k, seed);
  steps(claims, seed);
  return claims.in_order();
}

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

constexpr const char* nested_in_coq = R"(
(* F is the antiderivative by y of f, and G by x of what F makes of the ends. *)
Lemma nested_by : forall (F f : R -> R -> R) G lo hi a b,
  (forall x y, is_derive (F x) y (f x y)) -> (forall x y, continuous (f x) y) ->
  (forall x, is_derive G x (F x (hi x) - F x (lo x))) ->
  (forall x, continuous (fun x => F x (hi x) - F x (lo x)) x) ->
  RInt (fun x => RInt (fun y => f x y) (lo x) (hi x)) a b = G b - G a.
Proof.
  intros F f G lo hi a b D C E K. rewrite <- (RInt_by G (fun x => F x (hi x) - F x (lo x))); auto.
  apply RInt_ext. intros x _. apply (RInt_by (F x)); auto.
Qed.

Ltac derived := intros; auto_derive; solve [repeat split; trivial | field].
Ltac nest F G :=
  match goal with |- RInt (fun x => RInt (fun y => @?f x y) _ _) _ _ = _ =>
    rewrite (nested_by F f G (fun x => x * x) (fun _ => 1));
      [| derived | intros; apply @ex_derive_continuous; auto_derive; solve [repeat split; trivial]
       | derived | intros; apply @ex_derive_continuous; auto_derive; solve [repeat split; trivial]] end;
  match goal with |- ?x = ?y => change (@eq R x y) end; field.
)";

/// The antiderivatives by y and, of what they make of the ends, by x.
constexpr const char* antiderivatives[] = {
    "nest (fun x y : R => y ^ 3 / 3) (fun x : R => (x - x ^ 7 / 7) / 3)",
    "nest (fun x y : R => x ^ 2 * y) (fun x : R => x ^ 3 / 3 - x ^ 5 / 5)",
    "nest (fun x y : R => x ^ 2 * y + y ^ 3 / 3) (fun x : R => x ^ 3 / 3 - x ^ 5 / 5 + (x - x ^ 7 / 7) / 3)",
    "nest (fun x y : R => x * y ^ 2 / 2) (fun x : R => (x ^ 2 / 2 - x ^ 6 / 6) / 2)",
    "nest (fun x y : R => 0 * x * y) (fun x : R => 0 * x)",
    "nest (fun x y : R => 0 * x * y) (fun x : R => 0 * x)"};

/// The component's integral over the lamina by its definition.
Expression component_integral(std::size_t k) {
  const auto letter = [](const char* name) { return Shortened::letter(name); };
  const std::array<Shortened, 3> r{letter("x"), letter("y"), Shortened(0.0)};
  const std::string integrand = inertia_component(k, r).expression().coq();
  return Expression::letter("(RInt (fun x => RInt (fun y => " + integrand + ") (x * x) 1) (-1) 1)");
}
Proposition is_integral(std::size_t k, const Fraction& value) {
  return component_integral(k) ==
         Expression(static_cast<double>(value[0])) / Expression(static_cast<double>(value[1]));
}

/// One is the other at every point, and so are their integrals over a lamina that is cut off anywhere.
std::vector<Lemma> integrates(const Shortened& printed, const Shortened& definition) {
  const auto over_lamina = [](const Shortened& f) {
    return Expression::letter("RInt (fun x => RInt (fun y => " + f.expression().coq() +
                              ") (x * x) 1) left 1");
  };
  return {{"integrand", "(x y z : R)", {}, {printed.expression() == definition.expression()}, "ring"},
          {"integral",
           "(left z : R)",
           {},
           {over_lamina(printed) == over_lamina(definition)},
           "apply RInt_ext; intros; apply RInt_ext; intros; cbv beta;\n"
           "  match goal with |- ?x = ?y => change (@eq R x y) end; ring"}};
}

}  // namespace

Provables proofs() {
  const std::string preamble = std::string(integrals_in_coq) + nested_in_coq;
  const auto by_rows = in_rationals();
  constexpr const char* names[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
  Provables proved;
  std::vector<Lemma> similar;
  for (std::size_t k = 0; k < 6; ++k) {
    similar.push_back({names[k], "", {}, {is_integral(k, by_rows[k])}, antiderivatives[k]});
    proved.push_back({"2.13-i" + std::string(names[k]),
                      "the integral of its definition is this value",
                      {similar.back()},
                      0,
                      preamble});
  }
  const auto off = [&](const Expression& printed, double margin) {
    const std::string is =
        "match goal with |- context [RInt ?f ?a ?b] => "
        "let is := fresh in assert (is : RInt f a b = 4 / 7) by (";
    return Lemma{"printed_differs",
                 "",
                 {},
                 {apart(printed, component_integral(0), margin)},
                 is + antiderivatives[0] + "); rewrite is end; " + by_arithmetic};
  };
  proved.front().lemmas.push_back(off(47.0, 46.4));
  proved.front().margin = 46.4;
  proved.front().says = "as meant it is the integral of its definition; as printed it is off";
  proved.push_back({"2.13-similar", "the six components are these two integrals of their definitions",
                    similar, 0, preamble});

  const Shortened x = Shortened::letter("x"), y = Shortened::letter("y"), z = Shortened::letter("z");
  const std::array integrands{yy(x, y, z), xx(x, y, z), zz(x, y, z), xy(x, y, z), xz(x, y, z), yz(x, y, z)};
  for (std::size_t k = 0; k < 6; ++k)
    proved.push_back({"2.13-i" + std::string(names[k]) + "_integrand",
                      "it is that of the definition, everywhere and so over any lamina",
                      integrates(integrands[k], inertia_component(k, std::array{x, y, z})), 0, preamble});
  proved.push_back(
      {"2.13-ixx_without_z", "it is that of the definition at z = 0, everywhere and so over any lamina",
       integrates(y_squared(x, y, z), inertia_component(0, std::array{x, y, Shortened(0.0)})), 0, preamble});

  const ColumnOf<Shortened> at{x};
  const Expression inner = Expression::letter("(RInt (fun y => y * y) (x * x) 1)");
  const std::string by_cube = "integrate (fun y : R => y ^ 3 / 3); field";
  for (const auto& [slug, printed] : {std::pair("ixx_inner", between(at, 3)), {"ixx_outer", power(at, 6)}})
    proved.push_back({"2.13-" + std::string(slug),
                      "it is the integral of a column, wherever it is",
                      {{"printed", "(x : R)", {}, {printed.expression() == inner}, "symmetry; " + by_cube}},
                      0,
                      preamble});
  const auto f = [](const Shortened& at_x, double seventh, double over) {
    return antiderivative(at_x, seventh, over).expression();
  };
  const Expression ends = f(1.0, 7, 3) - f(-1.0, 7, 3), printed_ends = f(1.0, 73, 1) - f(-1.0, 73, 1);
  proved.push_back(
      {"2.13-ixx_antiderivative",
       "as meant its derivative is the integral of a column, and its ends make the whole; as printed they do not",
       {{"meant_derivative",
         "(x : R)",
         {},
         {Expression::letter("(Derive (fun x => " + f(at.x, 7, 3).coq() + ") x)") == inner},
         "replace (RInt (fun y => y * y) (x * x) 1) with ((1 - x ^ 6) / 3) by (symmetry; " + by_cube +
             "); apply is_derive_unique; auto_derive; solve [trivial | field]"},
        {"meant_ends", "", {}, {component_integral(0) == ends}, antiderivatives[0]},
        off(printed_ends, 1.4)},
       1.4,
       preamble});
  return proved;
}

}  // namespace oddity::lamina_inertia

namespace oddity {

Provables proofs_2_13() { return lamina_inertia::proofs(); }

}  // namespace oddity
