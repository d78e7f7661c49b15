// Exercise 8.1: two frames of the plane with the same origin, the axes of the second rotated by pi/4. The
// book's formula is
//   b = R^T a,   R^T = 1/sqrt(2) (1 1; -1 1),   R the counterclockwise rotation by pi/4.
// The independent route is the frames themselves: P = O + a1 u1 + a2 u2 = O + b1 v1 + b2 v2. Here v1 and v2
// are exp(i pi/4) and i exp(i pi/4), and b is found by elimination. Example 8.1 itself, with c = (c1, c2), is
// not in the solutions.

#include <Eigen/Core>
#include <complex>
#include <numbers>

#include "chapters/numbers.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"
#include "solvers/linear.hpp"

namespace oddity {

namespace ex08_01 {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Complex = std::complex<double>;

constexpr Parameter parameters[] = {
    {"a1", 2, "m", "first coordinate", -1e6, 1e6},
    {"a2", 0.5, "m", "second coordinate", -1e6, 1e6},
    {"seed", 1, "", "seed of the random points", 0, 1e9, whole_number},
};

constexpr double four_decimals = 0.7071;  ///< precision of the printed 1/sqrt(2)
constexpr double quarter = std::numbers::pi / 4;

Matrix2d rows(double a, double b, double c, double d) {
  Matrix2d m;
  m << a, b, c, d;
  return m;
}

const Matrix2d printed = rows(1, 1, -1, 1) / std::sqrt(2.0);

/// Coordinates of a vector on axes rotated by `angle`, by elimination.
Solved<Eigen::VectorXd> elimination_on_turned_axes(const Vector2d& vector, double angle) {
  const Complex v1 = std::polar(1.0, angle), v2 = v1 * Complex(0, 1);
  return solve(Factorization::partial_pivot_lu, rows(v1.real(), v2.real(), v1.imag(), v2.imag()), vector);
}

// ---- claims -----------------------------------------------------------------------------------------------

template <class T>
using Vector2 = Eigen::Matrix<T, 2, 1>;
template <class T>
using Matrix2 = Eigen::Matrix<T, 2, 2>;

/// The printed matrix as it is meant.
template <class T>
Matrix2<T> printed_matrix() {
  Matrix2<T> m;
  m << T(1.0), T(1.0), T(-1.0), T(1.0);
  return m / sqrt(T(2.0));
}

/// Columns are the axes: 1 and i rotated by `share` times pi.
template <class T>
Matrix2<T> turned_axes(double share) {
  const T angle = pi_of<T>() * share, c = cos(angle), s = sin(angle);
  Matrix2<T> axes;
  axes << c, -s, s, c;
  return axes;
}
/// By elimination; the first axis must not be along the second coordinate.
template <class T>
Vector2<T> on_axes(const Matrix2<T>& axes, const Vector2<T>& vector) {
  const T multiple = axes(1, 0) / axes(0, 0);
  const T second = (vector[1] - multiple * vector[0]) / (axes(1, 1) - multiple * axes(0, 1));
  return {(vector[0] - axes(0, 1) * second) / axes(0, 0), second};
}

/// A point, and two frames whose origins differ by a multiple of `offset` that each claim sets.
template <class T>
struct FramesOf {
  double largest = 0;
  Vector2<T> origin, offset, a;

  FramesOf() = default;
  explicit FramesOf(Random& random) : largest(std::abs(random.magnitude(1e-3, 1e3))) {
    for (T* x : letters()) *x = random.between(-largest, largest);
  }
  std::array<T*, 6> letters() { return {&origin[0], &origin[1], &offset[0], &offset[1], &a[0], &a[1]}; }
  double size() const { return largest; }
  std::string where() const { return "size " + format_significant(largest, 3); }
};

/// Coordinates of the first frame's origin on the axes of the second. The origins differ by apart * offset.
ProvableFormula<FramesOf> constants(std::string text, double apart) {
  return {std::move(text), [=]<class T>(const FramesOf<T>& f) {
            const Vector2<T> second = f.origin + T(apart) * f.offset;
            return Vector2<T>(on_axes<T>(turned_axes<T>(0.25), f.origin + f.a - second) -
                              printed_matrix<T>() * f.a);
          }};
}

/// Coordinates on the first frame's axes.
template <class T>
struct PointOf {
  T a1, a2;

  PointOf() = default;
  explicit PointOf(Random& random) : a1(random.magnitude(1e-3, 1e3)), a2(random.magnitude(1e-3, 1e3)) {}
  std::array<T*, 2> letters() { return {&a1, &a2}; }
  Vector2<T> a() const { return {a1, a2}; }
  TypesetIn<T> typeset() const { return {{"a", {a1, a2}}}; }
  std::string where() const {
    return "$a$ = (" + format_significant(a1, 4) + ", " + format_significant(a2, 4) + ")";
  }
};

struct Tables {
  ProvableClaims<FramesOf> frames;
  ProvableClaims<PointOf> points;
  explicit Tables(Claims& claims) : frames(claims), points(claims) {}
};

void formulas(Tables& tables, const std::vector<FramesOf<double>>& frames,
              const std::vector<PointOf<double>>& points) {
  tables.frames.formula(
      "origin", 3977,
      "with equal origins $(c_1,c_2)=(0,0)$, and nothing else changes in example 8.1 (our reading, as that is not "
      "in the solutions: in $b=R^Ta+(c_1,c_2)$)",
      frames,
      {.quantity = R"($(c_1,c_2)=b-R^Ta$ for a random point, $b$ by elimination)",
       .truth = {"$(0,0)$", []<class T>(const FramesOf<T>&) { return Vector2<T>(T(0.0), T(0.0)); }},
       .printed = constants("equal origins", 0),
       .near_misses = {constants("origins a thousandth apart", 1e-3)}});
  const std::string transposed = R"($\frac1{\sqrt2}\begin{pmatrix}1&1\\-1&1\end{pmatrix}a$)",
                    clockwise = R"($\frac1{\sqrt2}\begin{pmatrix}1&-1\\1&1\end{pmatrix}a$)";
  tables.points.formula(
      "matrix", 3981,
      R"($b=\frac1{\sqrt2}\begin{pmatrix}1&1\\-1&1\end{pmatrix}a$, the fraction bar lost (our reading, as )"
      R"(example 8.1 is not in the solutions: of axes that are turned counterclockwise by $\pi/4$))",
      points,
      {.quantity = "$(b_1,b_2)$",
       .truth = {R"(elimination on axes turned by $\pi/4$)",
                 []<class T>(const PointOf<T>& p) { return on_axes<T>(turned_axes<T>(0.25), p.a()); }},
       .printed = R"($1\,\sqrt2\begin{pmatrix}1&1\\-1&1\end{pmatrix}a$)",
       .meant = transposed,
       .near_misses = {clockwise},
       .why = filled(
           R"(The fraction bar is lost in the text at hand: $\tfrac1{\sqrt2}$. With the product the matrix )"
           R"(is no rotation, and every point is @1 times as far from the origin.)",
           {(2 * printed * Vector2d(1, 0)).norm()})});
  tables.points.formula(
      "transpose", 3991,
      R"($\frac1{\sqrt2}\begin{pmatrix}1&1\\-1&1\end{pmatrix}=R^T$, $R$ the counterclockwise rotation by $\pi/4$)",
      points,
      {.quantity = "$R^Ta$ for a random $a$",
       .truth = {R"(dot products with the columns of $R$, the axes turned by $\pi/4$)",
                 []<class T>(const PointOf<T>& p) {
                   const Matrix2<T> axes = turned_axes<T>(0.25);
                   return values(axes(0, 0) * p.a1 + axes(1, 0) * p.a2,
                                 axes(0, 1) * p.a1 + axes(1, 1) * p.a2);
                 }},
       .printed = transposed,
       .near_misses = {clockwise, R"($\begin{pmatrix}0&1\\-1&0\end{pmatrix}a$)"}});
}

std::vector<Claim> claims(double seed) {
  Claims claims("8.1");
  Tables tables(claims);
  formulas(tables, draw<FramesOf<double>>(100, seed), draw<PointOf<double>>(100, seed));
  return claims.in_order();
}

/// Sine and cosine of pi/4 through the square root of two, a letter with a known square.
constexpr const char* by_root =
    R"(replace (PI * (25 / 100)) with (PI / 4) by field; rewrite ?cos_PI4, ?sin_PI4;
  pose proof (sqrt_lt_R0 2 ltac:(lra)); pose proof (sqrt_sqrt 2 ltac:(lra)) as square;
  set (root := sqrt 2) in *; clearbody root; field [square]; lra)";

Provables proofs() {
  Claims claims("8.1");
  Tables tables(claims);
  formulas(tables, {}, {});
  const std::vector<std::string> of_frames{"o1", "o2", "d1", "d2", "a1", "a2"}, of_point{"a1", "a2"};
  Provables proved = tables.frames.proofs("8.1", {.any = lettered<FramesOf>(of_frames),
                                                  .letters = quantified(of_frames),
                                                  .tactic = by_root,
                                                  .says = "it holds of any point and any origin"});
  ForAll<PointOf> at_any{.any = lettered<PointOf>(of_point),
                         .letters = quantified(of_point),
                         .tactic = by_root,
                         .says = "it holds of any point"};
  at_any.example.a1 = at_any.example.a2 = 1;
  for (Provable& p : tables.points.proofs("8.1", at_any)) proved.push_back(std::move(p));
  return proved;
}

// ---- methods ----------------------------------------------------------------------------------------------

template <class T>
Vector2<T> polar(const Vector2<T>& a, const T& radius) {
  using std::atan2, std::cos, std::sin;
  const T angle = atan2(a[1], a[0]) - T(quarter);
  return {radius * cos(angle), radius * sin(angle)};
}

template <class T>
Vector2<T> by_entries(const Vector2<T>& x, double entry) {
  return {T(entry) * x[0] + T(entry) * x[1], T(entry) * x[1] - T(entry) * x[0]};
}

/// Whether the square of the vector's length overflows.
bool squares_overflow(const Vector2d& x) { return !std::isfinite(x[0] * x[0] + x[1] * x[1]); }

Quantity coordinates_of(const Vector2d& a, int exponent, const Reference& truth) {
  const Known known = truth("08_01_coordinates", {a[0], a[1]});
  const double scale = std::ldexp(1.0, exponent), need = 1e-14 * std::max(1.0, a.norm());
  Quantity q = quantity(
      exponent == 0 ? "coordinates" : "huge_coordinates",
      exponent == 0 ? "m" : "2^" + std::to_string(exponent) + " m",
      exponent == 0 ? "$(b_1,b_2)$" : "$(b_1,b_2)$, $a$ times $2^{" + std::to_string(exponent) + "}$", known,
      {need, "a few dozen roundings"});
  const auto add = [&](const char* model, const char* algorithm, const auto& find,
                       Outcome expected = Outcome::ok, const char* why = "") {
    using Number = Counted<double>;
    const long work =
        operations_of([&] { return find(Vector2<Number>(scale * a[0], scale * a[1])); }).all_but_additions();
    q.add({model, algorithm, no_resolution(),
           [=](double) {
             return Answer{Value(Vector2d(find(Vector2d(scale * a)) / scale)), work};
           },
           expected, expected == Outcome::ok ? "" : why});
  };
  const double off_by_decimals =
      (printed(0, 0) - four_decimals) * std::max(std::abs(a[0] + a[1]), std::abs(a[1] - a[0]));
  add("matrix", "entries 1/sqrt(2)", [](const auto& x) { return by_entries(x, printed(0, 0)); });
  add("matrix", "sums over sqrt(2)", []<class T>(const Vector2<T>& x) {
    const T root = std::sqrt(0.5);
    return Vector2<T>((x[0] + x[1]) * root, (x[1] - x[0]) * root);
  });
  add(
      "matrix", "entries 0.7071", [](const auto& x) { return by_entries(x, four_decimals); },
      off_by_decimals > need ? Outcome::inaccurate : Outcome::ok, R"(four decimals of $1/\sqrt2$)");
  q.add({"frames", "elimination", no_resolution(), [=](double) {
           Answer b = answer(elimination_on_turned_axes(scale * a, quarter));
           for (std::size_t i = 0; i < 2; ++i) b.value[i] /= scale;
           return b;
         }});
  add("complex number", "times exp(-i pi/4)", []<class T>(const Vector2<T>& x) {
    const T c = std::cos(quarter), s = std::sin(quarter);
    return Vector2<T>(c * x[0] + s * x[1], c * x[1] - s * x[0]);
  });
  add("polar coordinates", "radius by hypot", []<class T>(const Vector2<T>& x) {
    using std::hypot;
    return polar<T>(x, hypot(x[0], x[1]));
  });
  add(
      "polar coordinates", "radius by squares",
      []<class T>(const Vector2<T>& x) {
        using std::sqrt;
        return polar<T>(x, sqrt(x[0] * x[0] + x[1] * x[1]));
      },
      squares_overflow(scale * a) ? Outcome::non_finite : Outcome::ok, "the squares overflow");
  return q;
}

/// Eight changes by pi/4 give the identity; two more, a quarter turn, show that changes were made at all. The
/// point is one for which roundings do not fall into a cycle, as they do for many, such as (2, 1/2).
Quantity full_turns() {
  const Vector2d a(1234.567, -0.3333), in_a_cycle(2, 0.5);
  constexpr long quarter_turn = 2;
  Quantity q{
      "full_turns",
      "m",
      filled(
          "coordinates of $(@7,@4)$ after full turns of eight changes each, and a quarter turn of two more",
          {a[0], a[1]}),
      {"$(a_2,-a_1)$", Value{a[1], -a[0]}},
      0,
      {1e-12 * a.norm(), "a few thousand roundings"},
      {},
      {}};
  const Resolution changes{"changes", {8, 256, 8192, 262144}};
  const auto add = [&](const char* model, const char* algorithm, const auto& step, Outcome expected,
                       const std::string& why) {
    using Number = Counted<double>;
    const long each = operations_of([&] { return step(Vector2<Number>(a[0], a[1])); }).all_but_additions();
    q.add({model, algorithm, changes,
           [=](double n) {
             Vector2d x = a;
             const long count = static_cast<long>(n) + quarter_turn;
             for (long i = 0; i < count; ++i) x = step(x);
             return Answer{Value(x), each * count};
           },
           expected, why});
  };
  const double length = a.norm();
  add(
      "matrix", "entries 1/sqrt(2)", [](const auto& x) { return by_entries(x, printed(0, 0)); },
      Outcome::inaccurate, R"($1/\sqrt2$ is rounded, and the length shrinks with every change)");
  add(
      "matrix", "entries 0.7071", [](const auto& x) { return by_entries(x, four_decimals); },
      Outcome::inaccurate,
      filled("each change shortens by $@1$ of the length", {1 - four_decimals * std::sqrt(2.0)}));
  add(
      "matrix", "length restored",
      [=]<class T>(const Vector2<T>& x) {
        using std::sqrt;
        const Vector2<T> y = by_entries(x, printed(0, 0));
        const T factor = T(length) / sqrt(y[0] * y[0] + y[1] * y[1]);
        return Vector2<T>(factor * y[0], factor * y[1]);
      },
      Outcome::ok, "");
  q.add({"two changes at once", "(b1, b2) = (a2, -a1)", changes, [=](double n) {
           Vector2d x = a;
           for (long i = 0; i < static_cast<long>(n) + quarter_turn; i += 2) x = Vector2d(x[1], -x[0]);
           return Answer{Value(x), 0};
         }});
  const double entry = printed(0, 0);
  const auto shrinkage = [&](const Vector2d& from) {
    Vector2d p = from;
    for (double n = 0; n < changes.settings.back(); ++n) p = by_entries(p, entry);
    return std::abs(1 - p.norm() / from.norm());
  };
  q.add(Breakdown{R"(The square of the double $1/\sqrt2$ is $@1$ too small. The length shrinks in every )"
                  R"(change, unless the roundings fall into a cycle that hides it. That of $(@1,@1)$ has )"
                  "changed by $@1$ of itself after @6 changes, that of this point by $@1$. Two changes are "
                  "a quarter turn, which rounds nothing.",
                  "matrix, entries 1/sqrt(2)",
                  262144,
                  Outcome::inaccurate,
                  "two changes at once, (b1, b2) = (a2, -a1)",
                  262144,
                  {std::fma(-entry, entry, 0.5), in_a_cycle[0], in_a_cycle[1], shrinkage(in_a_cycle),
                   changes.settings.back(), shrinkage(a)}});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Vector2d a(p["a1"], p["a2"]);
  constexpr int exponent = 600;
  Quantity huge = coordinates_of(a, exponent, truth);
  if (squares_overflow(std::ldexp(1.0, exponent) * a))
    huge.add(Breakdown{"A radius by squares overflows at $@1$; the matrix squares nothing.",
                       "polar coordinates, radius by squares",
                       0,
                       Outcome::non_finite,
                       "matrix, entries 1/sqrt(2)",
                       0,
                       {std::sqrt(std::numeric_limits<double>::max())}});
  return {claims(p["seed"]), in_operations({coordinates_of(a, 0, truth), huge, full_turns()})};
}

}  // namespace ex08_01

Exercise exercise_8_1() {
  using namespace ex08_01;
  return {
      "Change of coordinates",
      "Two coordinate systems of the plane share their origin, and the axes of one are the other's turned by "
      "$\\pi/4$. How do the coordinates $b$ of a point follow from its coordinates $a$?",
      parameters,
      {},
      study,
      proofs,
      Expected::in_whole_ranges};
}

}  // namespace oddity
