// Exercise 7.5: u + v + w = 0 implies u x v = v x w = w x u, the triangle's normal, whose length is twice its
// area. The lines of the proof are checked exactly in whole numbers, each for the most general vectors that
// it allows. The area is computed from the lengths of the sides alone, without a cross product, by Heron's
// formula. It is 16 area^2 = 2(a^2 b^2 + b^2 c^2 + c^2 a^2) - a^4 - b^4 - c^4. Kahan, Miscalculating area and
// angles of a needle-like triangle.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "chapters/07_linear_algebra/05_triangle_normal/triangle_normal.hpp"
#include "chapters/07_linear_algebra/shared/double_double.hpp"
#include "chapters/07_linear_algebra/shared/vectors.hpp"
#include "chapters/inputs.hpp"
#include "reference/reference.hpp"
#include "solvers/counted.hpp"

namespace oddity {

namespace ex07_05 {

using namespace vectors;

constexpr auto parameters = together(
    std::array{Parameter{"d", 1e8, "", "distance of the flat triangle from the origin", 0, 1e10},
               Parameter{"h", 1e-3, "", "height of the flat triangle over a base of about one", 1e-8, 1},
               Parameter{"s", 1e-10, "", "short side of the needle, the others about one", 1e-15, 1},
               Parameter{"seed", 1, "", "seed of the random vectors", 0, 1e9, whole_number}},
    numbers<3>({"px", "py", "pz"}, {0, 0, 0}, "", "vertex $P$ of a triangle that you choose", 1e100),
    numbers<3>({"qx", "qy", "qz"}, {1.08231, 0.73914, -0.31277}, "", "vertex $Q$", 1e100),
    numbers<3>({"rx", "ry", "rz"}, {1.08231 + 1e-3, 0.73914 - 2 * 1e-3, -0.31277 + 1e-3 / 3}, "",
               "vertex $R$", 1e100));

// ---- the methods ------------------------------------------------------------------------------------------

struct Triangle {
  Vector3<double> p, q, r;
  std::vector<double> inputs() const { return {p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]}; }
};

/// A triangle with a height of about h over a base of about 1, at the distance d.
Triangle flat(double d, double h) {
  return {{d, d / 3, -d / 7},
          {d + 1.1, d / 3 + 0.7, -d / 7 - 0.3},
          {d + 0.66, d / 3 + 0.42 + h, -d / 7 - 0.18 + h}};
}

/// Two sides of about 1, the third of about s.
Triangle needle(double s) {
  return {{0, 0, 0}, {1.08231, 0.73914, -0.31277}, {1.08231 + s, 0.73914 - 2 * s, -0.31277 + s / 3}};
}

/// Count of multiplications, divisions and roots of f, with the vertices of t as arguments.
long work_of(const Triangle& t, const auto& f) {
  using Number = Counted<double>;
  return operations_of([&] { return f(cast<Number>(t.p), cast<Number>(t.q), cast<Number>(t.r)); })
      .all_but_additions();
}

/// A formula for the normal from p, q, r, in 53 and in 106 bits.
Method formula(std::string model, std::string algorithm, const Triangle& t, const auto& f) {
  return {
      std::move(model),
      std::move(algorithm),
      {"significant bits", {53, 106}},
      [=, work = work_of(t, f)](double bits) {
        if (bits == 53) return Answer{Value(f(t.p, t.q, t.r)), work};
        return Answer{
            Value(cast<double>(f(cast<DoubleDouble>(t.p), cast<DoubleDouble>(t.q), cast<DoubleDouble>(t.r)))),
            work};
      }};
}

Quantity normal_of(std::string name, std::string says, const Triangle& t, const Reference& truth) {
  const Known known = truth("07_05_normal", t.inputs());
  Quantity q = quantity(std::move(name), "", std::move(says), known,
                        {1e-9 * size_of(known.value), "nine digits of the largest component"});
  q.add(formula("edges", "u x v", t,
                [](const auto& a, const auto& b, const auto& c) { return cross(b - a, c - b); }));
  q.add(formula("edges", "v x w", t,
                [](const auto& a, const auto& b, const auto& c) { return cross(c - b, a - c); }));
  q.add(formula("edges", "w x u", t,
                [](const auto& a, const auto& b, const auto& c) { return cross(a - c, b - a); }));
  q.add(formula("vertices", "P x Q + Q x R + R x P", t, [](const auto& a, const auto& b, const auto& c) {
    return cross(a, b) + cross(b, c) + cross(c, a);
  }));
  return q;
}

template <class T>
T length(const Vector3<T>& x) {
  using std::sqrt;
  return sqrt(dot(x, x));
}

/// The lengths of the sides, largest first.
template <class T>
Vector3<T> sides(const Vector3<T>& p, const Vector3<T>& q, const Vector3<T>& r) {
  Vector3<T> abc{length(q - p), length(r - q), length(p - r)};
  std::sort(abc.rbegin(), abc.rend());
  return abc;
}

Quantity twice_area(const Triangle& t, const Reference& truth) {
  const Known known = truth("07_05_normal", t.inputs());
  const double area = length(Vector3<double>{known.value[0], known.value[1], known.value[2]});
  Quantity q{"twice_area",
             "",
             "twice the area of a triangle some $10^{-6}$ high over a base of about one",
             {known.source + ", its length", area},
             4e-16 * area,
             {1e-9 * area, "nine digits"},
             {},
             {}};
  const std::string lengths =
      "the height changes the lengths by its square at most, of which they keep few digits";
  const auto add = [&](const char* model, const char* algorithm, const auto& f,
                       Outcome expected = Outcome::ok, const std::string& why = "") {
    const long work = work_of(t, f);
    q.add({model, algorithm, no_resolution(),
           [=](double) {
             return Answer{f(t.p, t.q, t.r), work};
           },
           expected, why});
  };
  add("edges", "|u x v|",
      [](const auto& a, const auto& b, const auto& c) { return length(cross(b - a, c - b)); });
  add(
      "lengths", "Heron",
      []<class T>(const Vector3<T>& v0, const Vector3<T>& v1, const Vector3<T>& v2) {
        using std::sqrt;
        const auto [a, b, c] = sides(v0, v1, v2);
        const T s = (a + b + c) / T(2.0);
        return T(2.0) * sqrt(s * (s - a) * (s - b) * (s - c));
      },
      Outcome::inaccurate, lengths);
  add(
      "lengths", "Heron, Kahan's order",
      []<class T>(const Vector3<T>& v0, const Vector3<T>& v1, const Vector3<T>& v2) {
        using std::sqrt;
        const auto [a, b, c] = sides(v0, v1, v2);
        return sqrt((a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))) / T(2.0);
      },
      Outcome::inaccurate, lengths);
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  Quantity far = normal_of("flat_far_away", "normal of a flat triangle far from the origin",
                           flat(p["d"], p["h"]), truth);
  far.add(Breakdown{
      R"($P\times Q+Q\times R+R\times P$ cancels terms of size $d^2$ down to $h$. The differences of the )"
      R"(vertices are exact, and their product is as good as the vertices.)",
      "vertices, P x Q + Q x R + R x P", 53, Outcome::diverged, "edges, u x v", 53});
  Quantity thin = normal_of("needle", "normal of a triangle with one short side", needle(p["s"]), truth);
  thin.add(Breakdown{
      "The three products are equal, but not equally good: that of the two long sides cancels terms of size "
      "one down to $s$. Take the short side.",
      "edges, w x u", 53, Outcome::inaccurate, "edges, v x w", 53});
  const Quantity own = normal_of("normal", "normal of the triangle $PQR$",
                                 {point_of(p, "p"), point_of(p, "q"), point_of(p, "r")}, truth);
  return {
      claims(Random(p["seed"])), in_operations({far, thin, twice_area(flat(1, 1e-6), truth), own}), roots(),
      R"(The identity is right; {{edges on one line|such vectors are edges of a triangle only if two of them are not parallel}}.)"};
}

}  // namespace ex07_05

Exercise exercise_7_5() {
  using namespace ex07_05;
  return {"Three equal cross products",
          "Show that $u+v+w=0$ implies $u\\times v=v\\times w=w\\times u$, and say what this means for a "
          "triangle with these edges.",
          parameters,
          {},
          study,
          proofs,
          Expected::in_whole_ranges};
}

}  // namespace oddity
