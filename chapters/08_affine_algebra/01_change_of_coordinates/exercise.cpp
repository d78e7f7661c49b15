// Exercise 8.1: two frames of the plane with the same origin, the axes of the second rotated by pi/4. The
// book's formula is
//   b = R^T a,   R^T = 1/sqrt(2) (1 1; -1 1),   R the counterclockwise rotation by pi/4.
// The independent route is the frames themselves: P = O + a1 u1 + a2 u2 = O + b1 v1 + b2 v2. Here v1 and v2
// are exp(i pi/4) and i exp(i pi/4), and b is found by elimination. Example 8.1 itself, with c = (c1, c2), is
// not in the solutions.

#include <complex>
#include <numbers>

#include "chapters/08_affine_algebra/01_change_of_coordinates/change_of_coordinates.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"
#include "solvers/linear.hpp"

namespace oddity {

namespace ex08_01 {

using Complex = std::complex<double>;

constexpr Parameter parameters[] = {
    {"a1", 2, "m", "first coordinate", -1e6, 1e6},
    {"a2", 0.5, "m", "second coordinate", -1e6, 1e6},
    {"seed", 1, "", "seed of the random points", 0, 1e9, whole_number},
};

constexpr double four_decimals = 0.7071;  ///< precision of the printed 1/sqrt(2)
constexpr double quarter = std::numbers::pi / 4;

/// Coordinates of a vector on axes rotated by `angle`, by elimination.
Solved<Eigen::VectorXd> elimination_on_turned_axes(const Vector2d& vector, double angle) {
  const Complex v1 = std::polar(1.0, angle), v2 = v1 * Complex(0, 1);
  return solve(Factorization::partial_pivot_lu, rows(v1.real(), v2.real(), v1.imag(), v2.imag()), vector);
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
