#pragma once

#include "chapters/02_basic_concepts/vectors.hpp"
#include "chapters/exercise.hpp"

/// Rotations by the angle theta about a unit axis w, and what comes close to one.
namespace oddity::rotation {

using Map = std::function<Vector(const Vector&)>;

/// c r + s w x r + (1 - c) w (w . r).
inline Map rodrigues(const Vector& w, double theta) {
  return [w, c = std::cos(theta), s = std::sin(theta)](const Vector& r) {
    return c * r + s * cross(w, r) + (1 - c) * dot(w, r) * w;
  };
}

/// q r q*, q = (cos theta/2, sin theta/2 w).
inline Map quaternion(const Vector& w, double theta) {
  return [q0 = std::cos(theta / 2), q = std::sin(theta / 2) * w](const Vector& r) {
    const Vector once = 2.0 * cross(q, r);
    return r + q0 * once + cross(q, once);
  };
}

/// n steps of r + h w x r: no rotation, lengths grow by sqrt(1 + h^2) a step.
inline Map euler_steps(const Vector& w, double theta, int n) {
  return [=](Vector r) {
    for (int i = 0; i < n; ++i) r = r + theta / n * cross(w, r);
    return r;
  };
}

/// n steps of Cayley's transform, (1 - k)^-1 (1 + k) with k = h/2 w x: rotations by 2 atan(h/2).
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
  Knob knob;
  std::function<Map(int setting)> map;
  bool rotates = true, by_theta = true;  ///< at the finest setting: by any angle, and by the right one
};

inline std::vector<Way> ways(const Vector& w, double theta) {
  const Knob steps = doubling("steps", 4, 9), terms = doubling("terms", 4, 5);
  return {
      {"Rodrigues' formula", no_knob(), [=](int) { return rodrigues(w, theta); }},
      {"quaternion", no_knob(), [=](int) { return quaternion(w, theta); }},
      {"exponential series", terms, [=](int n) { return series(w, theta, n); }},
      {"Cayley steps", steps, [=](int n) { return cayley_steps(w, theta, n); }, true, false},
      {"Euler steps", steps, [=](int n) { return euler_steps(w, theta, n); }, false, false},
      {"single precision", no_knob(), [=](int) { return single_precision(rodrigues(w, theta)); }, false,
       false},
      {"rotation and mirror", no_knob(), [=](int) { return mirrored(rodrigues(w, theta)); }, false, false}};
}

}  // namespace oddity::rotation
