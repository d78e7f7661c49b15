#pragma once

#include "chapters/02_basic_concepts/shared/vectors.hpp"
#include "chapters/exercise.hpp"
#include "reference/reference.hpp"

/// Rotations by the angle theta about a unit axis w, and approximations.
namespace oddity::rotation {

using namespace basic_vectors;

using Map = std::function<Vector(const Vector&)>;

/// c r + s w x r + (1 - c) w (w . r).
inline Map rodrigues(const Vector& w, double theta) {
  return [w, c = std::cos(theta), s = std::sin(theta)](const Vector& r) {
    return c * r + s * cross(w, r) + (1 - c) * dot(w, r) * w;
  };
}

/// q r q*, q = (cos theta/2, sin theta/2 w).
template <class T>
auto quaternion(const std::array<T, 3>& w, const std::type_identity_t<T>& theta) {
  return [q0 = cos(theta / 2), q = sin(theta / 2) * w](const std::array<T, 3>& r) {
    const std::array<T, 3> once = 2.0 * cross(q, r);
    return r + q0 * once + cross(q, once);
  };
}
inline Map quaternion(const Vector& w, double theta) { return quaternion<double>(w, theta); }

/// n steps of r + h w x r: not a rotation, as lengths across w grow by sqrt(1 + h^2) a step.
inline Map euler_steps(const Vector& w, double theta, int n) {
  return [=](Vector r) {
    for (int i = 0; i < n; ++i) r = r + theta / n * cross(w, r);
    return r;
  };
}

/// n Cayley transforms, (1 - k)^-1 (1 + k) with k = h/2 w x: rotations by 2 atan(h/2).
inline Map cayley_steps(const Vector& w, double theta, int n) {
  return [=](Vector r) {
    const double k = theta / n / 2;
    for (int i = 0; i < n; ++i) {
      const Vector turned = k * cross(w, r);
      r = r + 2 / (1 + k * k) * (turned + k * cross(w, turned));
    }
    return r;
  };
}

/// The first terms of r + theta w x r + theta^2/2 w x (w x r) + ...
inline Map series(const Vector& w, double theta, int terms) {
  return [=](const Vector& r) {
    Vector sum = r, term = r;
    for (int k = 1; k < terms; ++k) {
      term = theta / k * cross(w, term);
      sum = sum + term;
    }
    return sum;
  };
}

inline Map single_precision(const Map& map) {
  return [map](const Vector& r) {
    Vector x = map(r);
    for (double& each : x) each = static_cast<double>(static_cast<float>(each));
    return x;
  };
}

inline Map mirrored(const Map& map) {
  return [map](const Vector& r) { return -1.0 * map(r); };
}

struct Way {
  std::string name;
  Resolution resolution;
  std::function<Map(int setting)> map;
  bool rotates = true, by_theta = true;  ///< at the finest setting: a rotation, by the right angle
  std::string why = {};                  ///< unless both are true
};

inline std::vector<Way> ways(const Vector& w, double theta) {
  const Resolution steps = doubling("steps", 4, 9), terms = doubling("terms", 4, 5);
  return {{"Rodrigues' formula", no_resolution(), [=](int) { return rodrigues(w, theta); }},
          {"quaternion", no_resolution(), [=](int) { return quaternion(w, theta); }},
          {"exponential series", terms, [=](int n) { return series(w, theta, n); }},
          {"Cayley steps", steps, [=](int n) { return cayley_steps(w, theta, n); }, true, false,
           R"(a step turns by $2\arctan(h/2)$, not by $h$)"},
          {"Euler steps", steps, [=](int n) { return euler_steps(w, theta, n); }, false, false,
           R"(a step makes $\mathbf r$ longer, and turns by $\arctan h$)"},
          {"single precision", no_resolution(), [=](int) { return single_precision(rodrigues(w, theta)); },
           false, false, filled("the result is rounded to @1 digits", {std::floor(-std::log10(0x1p-24))})},
          {"rotation and mirror", no_resolution(), [=](int) { return mirrored(rodrigues(w, theta)); }, false,
           false, "a mirror turns a product of two vectors another way than a vector"}};
}

const Vector axis{1.0 / 3, 2.0 / 3, 2.0 / 3};

/// The smallest gap of the triangle's edges that a user may set.
constexpr double least_gap = 0x1p-20;

/// The edges of a triangle; for gap = 2^-k, k <= 30, b is exact.
struct Triangle {
  Vector a{47436513 * 0x1p-25, 25959777 * 0x1p-25, -12996065 * 0x1p-25}, d;
  explicit Triangle(double gap) : d(gap * Vector{-0.5, 1, 0.75}) {}
  Vector b() const { return a + d; }
};

/// The value of f for the map. Work is the count of mapped vectors times the steps or terms of each.
template <class F>
Answer mapped(const F& f, const Map& map, double setting = 0) {
  long vectors = 0;
  const Map counting = [&](const Vector& r) { return ++vectors, map(r); };
  const Vector value = f(counting);
  return {value, vectors * std::max(1L, static_cast<long>(setting))};
}

template <class T>
std::array<T, 3> unit(const std::array<T, 3>& a) {
  return 1 / length(a) * a;
}

inline Quantity rotated_normal(double theta, double gap, const Reference& truth) {
  Quantity q = quantity(
      "rotated_normal", "", R"(unit normal of a rotated triangle with edges $\mathbf a$, $\mathbf b$)",
      truth("02_11_rotated_normal", {theta, gap}),
      {1e-9, filled("nine digits: edges $2^{@2}$ apart, the closest, have no more", {std::log2(least_gap)})});
  const Triangle t(gap);
  for (const Way& way : ways(axis, theta)) {
    const bool mirror = way.name == "rotation and mirror";
    const auto add = [&](const std::string& name, bool right, const auto& normal) {
      q.add({way.name, name, way.resolution,
             [=](double n) {
               return mapped([&](const Map& R) { return unit(normal(R)); }, way.map(static_cast<int>(n)), n);
             },
             right ? Outcome::ok : Outcome::inaccurate, right ? "" : way.why});
    };
    add("a x b, then rotated", way.rotates && way.by_theta,
        [t](const Map& R) { return R(cross(t.a, t.b())); });
    add("a, b rotated, then product", (way.rotates && way.by_theta) || mirror,
        [t](const Map& R) { return cross(R(t.a), R(t.b())); });
  }
  return q;
}

inline Quantity identity_gap(double theta) {
  constexpr double need = 1e-12;
  const Triangle t(1);
  Quantity q{"identity",
             "",
             R"($R\mathbf a\times R\mathbf b-R(\mathbf a\times\mathbf b)$ for the triangle with gap 1)",
             {"zero, for every rotation", Vector{}},
             0,
             {need, filled(R"(@4 roundings of $|\mathbf a||\mathbf b|$)",
                           {need / (0x1p-52 * length(t.a) * length(t.b()))})},
             {},
             {}};
  for (const Way& way : ways(axis, theta))
    q.add({way.name, "both ways", way.resolution,
           [=](double n) {
             const auto gap = [t](const Map& R) { return cross(R(t.a), R(t.b())) - R(cross(t.a, t.b())); };
             return mapped(gap, way.map(static_cast<int>(n)), n);
           },
           way.rotates ? Outcome::ok : Outcome::inaccurate, way.rotates ? "" : way.why});
  q.add(
      Breakdown{"Euler's steps lengthen vectors, and a product of two twice over; Cayley's steps turn by "
                "the wrong angle, but they turn, and the identity holds from the first step on.",
                "Euler steps, both ways", 1024, Outcome::inaccurate, "Cayley steps, both ways", 4});
  return q;
}

inline Quantity sliver_normal(const Reference& truth) {
  constexpr double theta = 2, gap = 0x1p-30;
  Quantity q = quantity("sliver_normal", "",
                        filled("the same, edges $2^{@2}$ apart, rotated by @2 rad", {std::log2(gap), theta}),
                        truth("02_11_rotated_normal", {theta, gap}), {1e-12, "twelve digits"});
  const Triangle t(gap);
  const auto add = [&](const std::string& model, const std::string& algorithm, const auto& normal,
                       const std::string& why = "") {
    q.add({model, algorithm, no_resolution(),
           [=, f = rodrigues(axis, theta)](double) {
             return mapped([&](const Map& R) { return unit(normal(R)); }, f);
           },
           why.empty() ? Outcome::ok : Outcome::inaccurate, why});
  };
  const std::string cancels =
      filled(R"(@1 digits of $\mathbf a\times\mathbf b$ cancel)", {std::round(-std::log10(gap))});
  add(
      "edges a, b", "rotated, then product", [=](const Map& R) { return cross(R(t.a), R(t.b())); }, cancels);
  add(
      "edges a, b", "product, then rotated", [=](const Map& R) { return R(cross(t.a, t.b())); }, cancels);
  add(
      "edges a, b", "rotated, subtracted, then product",
      [=](const Map& R) { return cross(R(t.a), R(t.b()) - R(t.a)); },
      R"($R\mathbf b-R\mathbf a$ has the rounding of both)");
  add("edges a, b - a", "rotated, then product", [=](const Map& R) { return cross(R(t.a), R(t.b() - t.a)); });
  add("edges a, b - a", "product, then rotated", [=](const Map& R) { return R(cross(t.a, t.b() - t.a)); });
  q.add(
      Breakdown{"The product of two nearly equal edges keeps @1 digits, whether it is rotated or they are. "
                R"($\mathbf a\times(\mathbf b-\mathbf a)$ is the same product and keeps them all, if )"
                R"($\mathbf b-\mathbf a$ is formed before the rotation.)",
                "edges a, b, rotated, then product",
                0,
                Outcome::inaccurate,
                "edges a, b - a, rotated, then product",
                0,
                {digits_of(Side::broken)}});
  return q;
}

}  // namespace oddity::rotation
