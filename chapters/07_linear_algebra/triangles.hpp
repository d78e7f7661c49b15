#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "chapters/07_linear_algebra/double_double.hpp"
#include "chapters/07_linear_algebra/vectors.hpp"
#include "chapters/exercise.hpp"
#include "reference/reference.hpp"

/// The normal and the area of flat and of needle-like triangles.
namespace oddity::triangles {

using namespace vectors;

using Vector = Vector3<double>;

struct Triangle {
  Vector p, q, r;
  std::vector<double> inputs() const { return {p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]}; }
};

/// Height about h over a base of about 1, at the distance d.
inline Triangle flat(double d, double h) {
  return {{d, d / 3, -d / 7},
          {d + 1.1, d / 3 + 0.7, -d / 7 - 0.3},
          {d + 0.66, d / 3 + 0.42 + h, -d / 7 - 0.18 + h}};
}

/// Two sides of about 1, the third of about s.
inline Triangle needle(double s) {
  return {{0, 0, 0}, {1.08231, 0.73914, -0.31277}, {1.08231 + s, 0.73914 - 2 * s, -0.31277 + s / 3}};
}

/// A formula for the normal in p, q, r, in 53 and in 106 bits.
inline Method formula(std::string model, std::string algorithm, const Triangle& t, long multiplications,
                      const auto& f, Outcome expected = Outcome::ok, std::string why = {}) {
  return {
      std::move(model),
      std::move(algorithm),
      {"significant bits", {53, 106}},
      [=](double bits) {
        if (bits == 53) return Answer{Value(f(t.p, t.q, t.r)), multiplications};
        return Answer{
            Value(cast<double>(f(cast<DoubleDouble>(t.p), cast<DoubleDouble>(t.q), cast<DoubleDouble>(t.r)))),
            multiplications};
      },
      expected,
      std::move(why)};
}

inline Quantity normal_of(std::string name, std::string says, const Triangle& t, const Reference& truth) {
  const Known known = truth("07_05_normal", t.inputs());
  Quantity q = quantity(std::move(name), "", std::move(says), known,
                        {1e-9 * size_of(known.value), "nine digits of the largest component"});
  q.add(formula("edges", "u x v", t, 6,
                [](const auto& a, const auto& b, const auto& c) { return cross(b - a, c - b); }));
  q.add(formula("edges", "v x w", t, 6,
                [](const auto& a, const auto& b, const auto& c) { return cross(c - b, a - c); }));
  q.add(formula("edges", "w x u", t, 6,
                [](const auto& a, const auto& b, const auto& c) { return cross(a - c, b - a); }));
  q.add(formula("vertices", "P x Q + Q x R + R x P", t, 18, [](const auto& a, const auto& b, const auto& c) {
    return cross(a, b) + cross(b, c) + cross(c, a);
  }));
  return q;
}

inline double length(const Vector& x) { return std::sqrt(dot(x, x)); }

/// The lengths of the sides, the largest first.
inline Vector sides(const Triangle& t) {
  Vector abc{length(t.q - t.p), length(t.r - t.q), length(t.p - t.r)};
  std::sort(abc.rbegin(), abc.rend());
  return abc;
}

inline Quantity twice_area(const Triangle& t, const Reference& truth) {
  const Known known = truth("07_05_normal", t.inputs());
  const double area = length({known.value[0], known.value[1], known.value[2]});
  Quantity q{"twice_area",
             "",
             "twice the area of a triangle of height 1e-6 over a base of about one",
             {known.source + ", its length", area},
             4e-16 * area,
             {1e-9 * area, "nine digits"},
             {},
             {}};
  const std::string lengths = "the height changes the lengths by no more than h^2, which they round away";
  q.add({"edges", "|u x v|", no_knob(), [=](double) {
           return Answer{length(cross(t.q - t.p, t.r - t.q)), 10};
         }});
  q.add({"lengths", "Heron", no_knob(),
         [=](double) {
           const auto [a, b, c] = sides(t);
           const double s = (a + b + c) / 2;
           return Answer{2 * std::sqrt(s * (s - a) * (s - b) * (s - c)), 17};
         },
         Outcome::inaccurate, lengths});
  q.add({"lengths", "Heron, Kahan's order", no_knob(),
         [=](double) {
           const auto [a, b, c] = sides(t);
           return Answer{std::sqrt((a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))) / 2, 17};
         },
         Outcome::inaccurate, lengths});
  return q;
}

}  // namespace oddity::triangles
