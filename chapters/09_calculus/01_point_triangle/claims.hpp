#pragma once

#include "chapters/09_calculus/01_point_triangle/point_triangle.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"

/// What the book says about the squared distance, on random triangles and points.
namespace oddity::triangles {

struct Sample {
  Triangle<double> w;
  double s, t, above;  ///< P's coordinates: V(s, t) + above * unit normal
  Vec<double> p;

  double size() const { return length(p - w.v[0]) + length(w.v[1] - w.v[0]) + length(w.v[2] - w.v[0]); }
  std::string where() const { return "s, t = " + rounded(s, 6) + ", " + rounded(t, 6); }
  /// The region by the coordinates that P was made of.
  int region() const {
    if (s + t <= 1) return s < 0 ? (t < 0 ? 4 : 3) : t < 0 ? 5 : 0;
    return s < 0 ? 2 : t < 0 ? 6 : 1;
  }
};

/// Fair triangles of sizes 0.01 to 100: the sine squared between the edges is above a twentieth.
inline std::vector<Sample> samples(double seed) {
  Random random(seed);
  std::vector<Sample> all;
  while (all.size() < 700) {
    const double size = std::abs(random.magnitude(0.01, 100));
    const Triangle<double> w{{random.point(size), random.point(size), random.point(size)}};
    const Vec<double> e1 = w.v[1] - w.v[0], e2 = w.v[2] - w.v[0], n = cross(e1, e2);
    if (dot(n, n) < 0.05 * dot(e1, e1) * dot(e2, e2)) continue;
    const double s = random.between(-2, 3), t = random.between(-2, 3), above = random.between(-size, size);
    all.push_back({w, s, t, above, w.at(s, t) + (above / length(n)) * n});
  }
  return all;
}

/// V0 + s E1 + t E2 against sums of vertices with weights in the given order.
inline Check points(const std::vector<Sample>& all, const std::array<std::size_t, 3>& order) {
  Worst worst("V(s, t), V0 + s E1 + t E2 against weighted vertices", "V0 + s E1 + t E2",
              "sum of the vertices with weights 1 - s - t, s, t");
  for (const Sample& x : all) {
    const auto& v = x.w.v;
    const Vec<double> sum = (1 - x.s - x.t) * v[order[0]] + x.s * v[order[1]] + x.t * v[order[2]];
    worst.see(x.w.at(x.s, x.t), sum, 12 * (length(v[0]) + length(v[1]) + length(v[2])), x.where());
  }
  return worst.check();
}

/// The signed areas that a point of the plane makes with the edges, over the triangle's.
inline Vec<double> areas(const Triangle<double>& w, const Vec<double>& x) {
  const auto& v = w.v;
  const Vec<double> n = cross(v[1] - v[0], v[2] - v[0]);
  const auto area = [&](std::size_t j, std::size_t k) {
    return dot(n, cross(v[j] - x, v[k] - x)) / dot(n, n);
  };
  return {area(1, 2), area(2, 0), area(0, 1)};
}

inline Check domain(const std::vector<Sample>& all, double most) {
  long wrong = 0;
  for (const Sample& x : all) {
    const Vec<double> a = areas(x.w, x.w.at(x.s, x.t));
    wrong += (a[0] >= 0 && a[1] >= 0 && a[2] >= 0) != (x.s >= 0 && x.t >= 0 && x.s + x.t <= most);
  }
  return never("points in the domain and not in the triangle by signed areas, or the reverse", wrong,
               static_cast<long>(all.size()));
}

inline Claim parametrization(const std::vector<Sample>& all) {
  return {"9.1-parametrization",
          4041,
          "the triangle is V0 + s E1 + t E2 with s, t >= 0 and s + t <= 1",
          {"as printed", {points(all, {0, 1, 2}), domain(all, 1)}},
          {},
          {},
          {{"s + t <= 2", {domain(all, 2)}}, {"E1 and E2 exchanged", {points(all, {0, 2, 1})}}}};
}

inline Claim barycentric(const std::vector<Sample>& all) {
  const auto check = [&](bool shifted) {
    Worst worst("barycentric coordinates of V(s, t), against signed areas",
                shifted ? "s, t, 1 - s - t" : "1 - s - t, s, t", "signed areas over the triangle's", 1024);
    for (const Sample& x : all) {
      const Value weights = shifted ? Value{x.s, x.t, 1 - x.s - x.t} : Value{1 - x.s - x.t, x.s, x.t};
      const double offset = length(x.w.v[0]) / length(x.w.v[1] - x.w.v[0]) + 1;
      worst.see(weights, areas(x.w, x.w.at(x.s, x.t)), 20 * offset, x.where());
    }
    return worst.check();
  };
  return {"9.1-barycentric",
          4043,
          "the barycentric coordinates are 1 - s - t, s and t",
          {"1 - s - t, s, t at V0, V1, V2", {check(false)}},
          {},
          {},
          {{"s, t, 1 - s - t", {check(true)}}}};
}

template <class T>
T squared_distance(const Sample& x, const T& s, const T& t) {
  Triangle<T> w;
  Vec<T> p;
  for (std::size_t a = 0; a < 3; ++a) {
    p[a] = T(x.p[a]);
    for (std::size_t i = 0; i < 3; ++i) w.v[i][a] = T(x.w.v[i][a]);
  }
  const Vec<T> d = w.at(s, t) - p;
  return dot(d, d);
}

/// |s E1 + t E2 + D|^2, and the same multiplied out, against |V(s, t) - P|^2.
inline Check expanded(const std::vector<Sample>& all, bool multiplied_out, double sign_of_d,
                      double cross_term) {
  Worst worst("f(s, t), against |V(s, t) - P|^2", multiplied_out ? "sum of six terms" : "|s E1 + t E2 + D|^2",
              "|V(s, t) - P|^2");
  for (const Sample& x : all) {
    const Vec<double> e1 = x.w.v[1] - x.w.v[0], e2 = x.w.v[2] - x.w.v[0], d = sign_of_d * (x.w.v[0] - x.p);
    const double s = 3 - x.t, t = x.s - 1;  // somewhere else than below P
    const Vec<double> sum = s * e1 + t * e2 + d;
    const double terms = dot(e1, e1) * s * s + cross_term * dot(e1, e2) * s * t + dot(e2, e2) * t * t +
                         2 * dot(e1, d) * s + 2 * dot(e2, d) * t + dot(d, d);
    const double size = 5 * x.size();
    worst.see(multiplied_out ? terms : dot(sum, sum), squared_distance(x, s, t), size * size, x.where());
  }
  return worst.check();
}

inline Claim expansion(const std::vector<Sample>& all) {
  return {"9.1-expansion",
          4045,
          "with D = V0 - P the squared distance is |s E1 + t E2 + D|^2 and its six terms",
          {"as printed", {expanded(all, false, 1, 2), expanded(all, true, 1, 2)}},
          {},
          {},
          {{"D = P - V0", {expanded(all, false, -1, 2)}},
           {"E1 . E2 without its 2", {expanded(all, true, 1, 1)}}}};
}

/// (a00, a01, a11, b0, b1, c) as half the derivatives of |V(s, t) - P|^2 at s = t = 0.
inline Value by_differentiation(const Sample& x) {
  using D = Dual<double>;
  using DD = Dual<D>;
  const D zero(0.0), one(1.0), moving(0.0, 1.0);
  const DD still(zero, zero), inner(moving, zero), outer(zero, one), both(moving, one);
  const auto second = [&](const DD& s, const DD& t) { return squared_distance(x, s, t).slope.slope / 2; };
  const auto first = [&](const D& s, const D& t) { return squared_distance(x, s, t).slope / 2; };
  return {second(both, still), second(inner, outer), second(still, both),
          first(moving, zero), first(zero, moving),  squared_distance(x, 0.0, 0.0)};
}

inline Claim coefficients(const std::vector<Sample>& all) {
  const auto check = [&](double a, double b) {
    Worst worst("(a00, a01, a11, b0, b1, c), against half the derivatives", "dot products of E1, E2, D",
                "half the derivatives, by dual numbers");
    for (const Sample& x : all) {
      const Quadratic<double> q(x.w, x.p);
      worst.see({q.a00, a * q.a01, q.a11, b * q.b0, b * q.b1, q.c}, by_differentiation(x),
                x.size() * x.size(), x.where());
    }
    return worst.check();
  };
  return {"9.1-coefficients",
          4051,
          "f = a00 s^2 + 2 a01 s t + a11 t^2 + 2 b0 s + 2 b1 t + c",
          {"a01 = E1 . E2, b0 = E1 . D, b1 = E2 . D, halves of the derivatives", {check(1, 1)}},
          {},
          {},
          {{"a01 = 2 E1 . E2", {check(2, 1)}}, {"b0 and b1 of the other sign", {check(1, -1)}}}};
}

/// Random points of the triangle that are closer than `distance` says.
template <class F>
Check none_closer(const std::vector<Sample>& all, const F& distance) {
  Random random(7);
  long closer = 0, count = 0;
  for (const Sample& x : all)
    for (int n = 0; n < 20; ++n, ++count) {
      double s = random.unit(), t = random.unit();
      if (s + t > 1) s = 1 - s, t = 1 - t;
      closer += length(x.w.at(s, t) - x.p) < distance(x.w, x.p) * (1 - 1e-12);
    }
  return never("points of the triangle closer than the minimum", closer, count);
}

template <class F>
Check same_distance(const std::vector<Sample>& all, std::string by, const F& distance) {
  Worst worst("distance, against the perpendicular or the nearest edge", std::move(by),
              "perpendicular to the plane, or nearest edge");
  for (const Sample& x : all)
    worst.see(distance(x.w, x.p), plane_distance(x.w, x.p), 20 * x.size(),
              "region " + std::to_string(x.region()) + ", " + x.where());
  return worst.check();
}

inline Claim minimum(const std::vector<Sample>& all) {
  const auto regions = [](const auto& w, const auto& p) { return region_distance(w, p); };
  const auto edges = [](const auto& w, const auto& p) { return edges_distance(w, p); };
  const auto unconstrained = [](const auto& w, const auto& p) {
    const Vec<double> n = cross(w.v[1] - w.v[0], w.v[2] - w.v[0]);
    return std::abs(dot(n, p - w.v[0])) / length(n);
  };
  return {"9.1-minimum",
          4043,
          "the distance is where the squared distance is least among s, t >= 0, s + t <= 1",
          {"minimum over the triangle",
           {same_distance(all, "least squared distance", regions), none_closer(all, regions)}},
          {},
          {},
          {{"minimum over all s and t", {same_distance(all, "distance to the plane", unconstrained)}},
           {"minimum over the edges", {none_closer(all, edges)}}}};
}

/// Samples by region, the region found against the one that P was put into.
inline Claim seven_regions(const std::vector<Sample>& all) {
  std::vector<double> put(7, 0), found(7, 0), square, area;
  Worst form("a00 a11 - a01^2", "coefficients", "|E1 x E2|^2");
  long wrong = 0, empty = 0;
  for (const Sample& x : all) {
    const Quadratic<double> q(x.w, x.p);
    const int region = by_regions(q).region;
    ++put[static_cast<std::size_t>(x.region())], ++found[static_cast<std::size_t>(region)];
    wrong += region != x.region();
    const Vec<double> n = cross(x.w.v[1] - x.w.v[0], x.w.v[2] - x.w.v[0]);
    form.see(q.a00 * q.a11 - q.a01 * q.a01, dot(n, n), q.a00 * q.a11, x.where());
  }
  for (double n : put) empty += n == 0;
  const auto check = [&](bool with_sub_cases) {
    return same_distance(all, with_sub_cases ? "seven regions" : "corners for the corner regions",
                         [=](const auto& w, const auto& p) {
                           const Quadratic<double> q(w, p);
                           const auto place =
                               with_sub_cases ? by_regions(q) : by_regions_without_sub_cases(q);
                           return length(w.at(place.s, place.t) - p);
                         });
  };
  return {"9.1-seven_regions",
          4055,
          "it is the quadratic that the seven regions around the triangle minimize",
          {"seven regions, the corner ones with sub-cases",
           {check(true),
            {"samples in regions 0 to 6", {"found", found}, {"by the P that was made", put}, exact()},
            never("P in another region than it was put", wrong, static_cast<long>(all.size())),
            never("regions without a sample", empty, 7),
            form.check()}},
          {},
          {},
          {{"the corner regions are nearest to the corners", {check(false)}}}};
}

inline std::vector<Claim> claims(double seed) {
  const auto all = samples(seed);
  return {parametrization(all), barycentric(all), expansion(all),
          coefficients(all),    minimum(all),     seven_regions(all)};
}

}  // namespace oddity::triangles
