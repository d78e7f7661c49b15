#pragma once

#include "chapters/06_physics_engines/05_two_point_contact/claims.hpp"

/// What the book concludes from two points: segments, faces and densities.
namespace oddity::contact {

/// w+ for the impulse spread along P0 P1 with density 1 + slope (2u - 1) at the fraction u.
inline Vector3d along_segment(const Sample& s, double slope) {
  Vector3d momentum;
  for (long k = 0; k < 3; ++k)
    momentum[k] = gauss_legendre(
                      [&](double u) {
                        const Vector3d x = (1 - u) * s.hit.p0 + u * s.hit.p1;
                        return (1 + slope * (2 * u - 1)) * cross(s.arm(x), s.f * s.normal)[k];
                      },
                      0, 1, 4)
                      .value;
  return s.body.w + turned(s.body.inertia, momentum);
}

inline Check as_segment(const std::vector<Sample>& all, const std::string& bodies, double slope) {
  return compare(
      all, "w+ of " + bodies, "two points",
      slope == 0 ? "an even impulse along the segment" : "one that grows along it",
      [](const Sample& s) { return angular_mean(s); },
      [=](const Sample& s) { return along_segment(s, slope); });
}

/// w+ for the impulse spread evenly over the plane quadrilateral P0, P1, P1 + b, P0 + a.
inline Vector3d over_area(const Sample& s, const Vector3d& a, const Vector3d& b) {
  const Vector3d e = s.hit.p1 - s.hit.p0;
  const Rule rule = [](FunctionOfOne f, double low, double high) { return gauss_legendre(f, low, high, 4); };
  const auto integral = [&](const auto& g) {
    const auto element = [&](double u, double v) {
      const Vector3d x = s.hit.p0 + u * e + v * ((1 - u) * a + u * b);
      return g(x) * cross(e + v * (b - a), (1 - u) * a + u * b).norm();
    };
    return nested(
               rule, element, 0, 1, [](double) { return 0.0; }, [](double) { return 1.0; })
        .value;
  };
  Vector3d momentum;
  for (long k = 0; k < 3; ++k)
    momentum[k] = integral([&](const Vector3d& x) { return cross(s.arm(x), s.f * s.normal)[k]; });
  return s.body.w + turned(s.body.inertia, momentum / integral([](const Vector3d&) { return 1.0; }));
}

/// Equal impulses at the corners against the area's even one. The side opposite to P0 P1 is parallel to it
/// and `ratio` as long; 0 makes a triangle.
inline Check as_area(const std::vector<Sample>& all, const std::string& shape, double ratio) {
  const auto side = [](const Sample& s) {
    const Vector3d e = s.hit.p1 - s.hit.p0;
    return Vector3d(Vector3d(e[1], e[2], e[0]) + 0.5 * e);
  };
  return compare(
      all, "w+, " + shape, "equal impulses at the corners", "spread evenly over the area",
      [=](const Sample& s) {
        const Vector3d e = s.hit.p1 - s.hit.p0, third = s.hit.p0 + side(s), fourth = third + ratio * e;
        const Vector3d three = (s.hit.p0 + s.hit.p1 + third) / 3,
                       four = (s.hit.p0 + s.hit.p1 + third + fourth) / 4;
        return at(s, s.arm(ratio == 0 ? three : four));
      },
      [=](const Sample& s) { return over_area(s, side(s), side(s) + (ratio - 1) * (s.hit.p1 - s.hit.p0)); });
}

inline std::vector<Claim> what_follows(double seed) {
  const auto boxes = samples(seed, 40, random_box), masses = samples(seed, 40, random_masses);
  const auto differs = [&](const std::vector<Sample>& all) {
    long same = 0;
    for (const Sample& s : all) same += (angular_mean(s) - along_segment(s, 0)).norm() <= 1e-12 * s.scale();
    return never("two points and the segment agree, eight unequal masses", same,
                 static_cast<long>(all.size()));
  };
  Claim finite{"6.5-finite_set", 3785, "to consider only a finite set of contact points is no approximation"};
  finite.printed = {"for segments, triangles, parallelograms and trapezoids",
                    {as_segment(boxes, "boxes", 0), as_area(boxes, "triangles", 0),
                     as_area(boxes, "parallelograms", 1), as_area(boxes, "trapezoids, 1 : 1/2", 0.5)}};
  finite.corrected = {
      "for segments, and where the corners' mean is the area's centroid: triangles, parallelograms",
      {as_segment(boxes, "boxes", 0), as_area(boxes, "triangles", 0), as_area(boxes, "parallelograms", 1)}};
  finite.near_misses = {{"trapezoids alone, 1 : 0.9", {as_area(boxes, "trapezoids, 1 : 0.9", 0.9)}}};
  finite.why =
      "Two points do replace an evenly pressed segment; that corners replace a face does not follow. The "
      "mean of a "
      "trapezoid's corners is not its centroid: with parallel sides 2 and 1 it lies at 1/2 of the height, "
      "the "
      "centroid at 4/9, and the torque about the long side is an eighth too large. Corners weighted by area "
      "(a third of each "
      "triangle's share) give the face's result exactly.";
  return {{"6.5-segment",
           3785,
           "two points give exactly what an evenly pressed segment gives",
           {"even pressure", {as_segment(boxes, "boxes", 0)}},
           {},
           {},
           {{"pressure growing by half along the segment", {as_segment(boxes, "boxes", 0.2)}}}},
          {"6.5-constant_density",
           3785,
           "they agree for bodies of constant density (and, by the same check, for any other: the condition "
           "is on "
           "the pressure along the segment, not on the mass)",
           {"boxes of constant density; eight unequal masses",
            {as_segment(boxes, "boxes", 0), as_segment(masses, "eight unequal masses", 0)}},
           {},
           {},
           {{"only for constant density", {differs(masses)}}}},
          finite};
}

inline std::vector<Claim> claims(double seed) {
  const auto all = samples(seed, 40, random_masses);
  std::vector<Claim> every{delta(all)};
  for (const auto& group : {linear_lines(all), angular_lines(all), what_follows(seed)})
    every.insert(every.end(), group.begin(), group.end());
  return every;
}

}  // namespace oddity::contact
