// Exercise 6.5: two bodies touch at the points P0, P1 with the same normal N. The book spreads the impulse f
// N over both by the average of two delta functions:
//   v+ = v- + f N / m,   w+ = w- + J^-1 r(M) x f N,   M = (P0 + P1)/2.
// The independent route is the motion itself, by Runge-Kutta, under half a short pulse of force at each of
// the two material points. The box of the tables is balanced on an edge, rotated by theta about it; l0, l1
// are the ends of the contact on the edge, measured from its middle. (6.88), (6.89) and (6.91) are the book's
// equations.

#include "chapters/06_physics_engines/05_two_point_contact/two_point_contact.hpp"
#include "reference/reference.hpp"
#include "solvers/quadrature.hpp"

namespace oddity {

namespace ex06_05 {

constexpr Parameter parameters[] = {
    {"a", 1, "m", "side of the box along the edge", 0.01, 100},
    {"b", 0.5, "m", "another side", 0.01, 100},
    {"c", 0.75, "m", "the third side", 0.01, 100},
    {"m", 2, "kg", "mass", 0.01, 1e4},
    {"theta", 0.5, "rad", "angle about the edge", 0.05, 1.5},
    {"l0", -0.125, "m", "one end of the contact", -50, 0},
    {"l1", 0.5, "m", "the other end", 0.001, 50},
    {"f", 3, "N s", "impulse", 1e-3, 1e4},
    {"speed", 2, "m/s", "at which the box falls on the edge", 0.01, 100},
    {"e", 0.5, "", "coefficient of restitution", 0, 1},
    {"seed", 1, "", "seed of the random bodies", 0, 1e9, whole_number},
};

const Vector3d up(0, 0, 1);

/// A tolerance for a spin: one turn in many years.
Tolerance slow_turn(double spin) {
  return {spin, filled("a turn in @3 years", {2 * std::numbers::pi / spin / (86400 * 365.25)})};
}

struct Box {
  Body body;
  Vector3d edge;  ///< the edge's middle, relative to the center
  double l0, l1, f;

  explicit Box(const Parameters& p) : l0(p["l0"]), l1(p["l1"]), f(p["f"]) {
    const double s = std::sin(p["theta"]), c = std::cos(p["theta"]);
    Matrix3d r;
    r << 1, 0, 0, 0, c, -s, 0, s, c;
    edge = r * Vector3d(0, p["b"] / 2, -p["c"] / 2);
    body = {p["m"], r * box_inertia(p["m"], p["a"], p["b"], p["c"]) * r.transpose(), Vector3d::Zero(),
            Vector3d::Zero(), Vector3d::Zero()};
  }
  Vector3d at(double x) const { return edge + Vector3d(x, 0, 0); }
  Vector3d torque(double x) const { return cross(at(x), f * up); }
  Answer turned_by(const Vector3d& momentum, long torques) const {
    return {Value(turned(body.inertia, momentum)), torques};
  }
};

/// Integrates torques per unit length along the contact, component by component.
Answer along_edge(const Box& box, const Rule& rule) {
  Vector3d momentum;
  long torques = 0;
  for (long k = 0; k < 3; ++k) {
    const auto part = rule([&](double x) { return box.torque(x)[k] / (box.l1 - box.l0); }, box.l0, box.l1);
    momentum[k] = part.value;
    torques = part.evaluations;
  }
  return box.turned_by(momentum, torques);
}

Quantity spin(const Parameters& p, const Reference& truth) {
  const Box box(p);
  const double m = (box.l0 + box.l1) / 2;
  Quantity q =
      quantity("spin", "rad/s", "angular velocity after an impulse spread evenly over the contact",
               truth("06_05_spin", {p["a"], p["b"], p["c"], p["m"], p["theta"], p["l0"], p["l1"], p["f"]}),
               slow_turn(1e-9));
  q.add({"midpoint", "one torque", no_resolution(), [=](double) { return box.turned_by(box.torque(m), 1); }});
  q.add({"both ends", "mean torque", no_resolution(),
         [=](double) { return box.turned_by((box.torque(box.l0) + box.torque(box.l1)) / 2, 2); }});
  q.add({"one end", "one torque", no_resolution(),
         [=](double) { return box.turned_by(box.torque(box.l1), 1); }, Outcome::inaccurate,
         "the arm is the end's, not the midpoint's"});
  const auto rule = [&](const char* name, const char* resolution, double first, auto formula) {
    q.add({"segment", name, doubling(resolution, first, 3), [=](double n) {
             return along_edge(box, [=](FunctionOfOne g, double low, double high) {
               return formula(g, low, high, static_cast<int>(n));
             });
           }});
  };
  rule("Gauss-Legendre", "points", 1, gauss_legendre);
  rule("trapezoid", "panels", 1, trapezoid);
  rule("Simpson", "panels", 2, simpson);
  q.add({"pulse at both ends",
         "Runge-Kutta 4",
         {"pulse", {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}},
         [=](double length) {
           const auto after = after_pulse(box.body, {box.at(box.l0), box.at(box.l1), box.f * up}, length);
           return answer(after, [](const auto& x) { return Value{x[3], x[4], x[5]}; });
         }});
  q.add(
      Breakdown{"While a force acts the box turns, and its arms with it: the impulse is the limit of a "
                "short pulse, and a pulse of @1 s is not short.",
                "pulse at both ends, Runge-Kutta 4",
                1e-2,
                Outcome::inaccurate,
                "midpoint, one torque",
                0,
                {setting_of(Side::broken)}});
  return q;
}

/// Upward velocity of the point at y after a unit impulse at x.
double response(const Box& box, double x, double y) {
  return 1 / box.body.mass + cross(turned(box.body.inertia, cross(box.at(x), up)), box.at(y)).dot(up);
}

/// The box falls without rotation, and both ends should rebound at e times its speed. Then the whole edge
/// rebounds: the box rotates about the edge's direction alone, as under one impulse F at the edge's middle.
Quantity rebound(const Parameters& p) {
  const Box box(p);
  const double gain = (1 + p["e"]) * p["speed"], y = box.edge[1];
  const double jx = p["m"] * (p["b"] * p["b"] + p["c"] * p["c"]) / 12;
  const double middle = gain / (1 / p["m"] + y * y / jx);
  Quantity q{"rebound",
             "rad/s",
             "angular velocity after a fall on the edge, both ends rebounding by $e$",
             {"$Fy/J_x$, the edge staying level", Value{middle * y / jx, 0, 0}},
             16 * 0x1p-52 * std::abs(middle * y / jx),  // 16 roundings in total
             slow_turn(1e-9),
             {},
             {}};
  const auto hit = [=](double f0, double f1, long torques) {
    return box.turned_by(cross(box.at(box.l0), f0 * up) + cross(box.at(box.l1), f1 * up), torques);
  };
  const double k00 = response(box, box.l0, box.l0), k01 = response(box, box.l0, box.l1),
               k11 = response(box, box.l1, box.l1);
  q.add({"an impulse at each end", "2x2 system", no_resolution(), [=](double) {
           const double det = k00 * k11 - k01 * k01;
           return hit(gain * (k11 - k01) / det, gain * (k00 - k01) / det, 2);
         }});
  q.add({"an impulse at each end", "one after the other", doubling("sweeps", 8, 6), [=](double sweeps) {
           double f0 = 0, f1 = 0;
           for (int n = 0; n < static_cast<int>(sweeps); ++n) {
             f0 = (gain - k01 * f1) / k00;
             f1 = (gain - k01 * f0) / k11;
           }
           return hit(f0, f1, 2 * static_cast<long>(sweeps));
         }});
  const double m = (box.l0 + box.l1) / 2;
  q.add({"one impulse at the midpoint", "division", no_resolution(),
         [=](double) {
           const double f = gain / response(box, m, m);
           return hit(f / 2, f / 2, 2);
         },
         Outcome::inaccurate, "equal impulses at unequal distances from the center let the edge tilt"});
  q.add(Breakdown{
      "Equal impulses are an assumption, not a law. Where the midpoint is not the edge's middle, its "
      "impulse tilts the edge, and neither end rebounds by $e$. An impulse for each end, from two "
      "conditions, does not.",
      "one impulse at the midpoint, division", 0, Outcome::inaccurate, "an impulse at each end, 2x2 system",
      0});
  return q;
}

/// A box that lies flat on a trapezoid with parallel sides a and a/2 and depth b, at a corner.
Quantity patch(const Parameters& p) {
  const double w = p["a"], h = p["b"], f = p["f"];
  const Matrix3d inertia = box_inertia(p["m"], p["a"], p["b"], p["c"]);
  const Vector3d corner(-w / 2, -h / 2, -p["c"] / 2);
  const std::array<Vector3d, 4> v{corner, corner + Vector3d(w, 0, 0), corner + Vector3d(0.5 * w, h, 0),
                                  corner + Vector3d(0, h, 0)};
  // The centroid of a right trapezoid of sides 1 and 1/2: ((1 + 1/2 + 1/4)/(3 (1 + 1/2)), (1 + 2/2)/(3 (1 +
  // 1/2))).
  const double x = corner[0] + 7.0 / 18 * w, y = corner[1] + 4.0 / 9 * h;
  Quantity q{
      "patch",
      "rad/s",
      "angular velocity after an impulse spread evenly over a trapezoid",
      {"the trapezoid's centroid in closed form", Value{y * f / inertia(0, 0), -x * f / inertia(1, 1), 0}},
      8 * 0x1p-52 * f * std::max(h / inertia(0, 0), w / inertia(1, 1)),  // roundings of half the sides
      slow_turn(1e-9),
      {},
      {}};
  const auto add = [&](const char* algorithm, long torques, const Vector3d& arm,
                       Outcome expected = Outcome::ok, const char* why = "") {
    q.add({"points", algorithm, no_resolution(),
           [=](double) {
             return Answer{Value(turned(inertia, cross(arm, f * up))), torques};
           },
           expected, why});
  };
  add("equal impulses at the corners", 4, (v[0] + v[1] + v[2] + v[3]) / 4, Outcome::inaccurate,
      "the corners' mean is not the centroid");
  add("corners weighted by triangles", 4, (2 * (v[0] + v[1] + v[2]) / 3 + (v[0] + v[2] + v[3]) / 3) / 3);
  q.add({"area", "Gauss-Legendre", doubling("points", 1, 3), [=](double n) {
           const Rule rule = [n](FunctionOfOne g, double low, double high) {
             return gauss_legendre(g, low, high, static_cast<int>(n));
           };
           const auto end = [=](double yy) { return w * (1 - 0.5 * yy / h); };
           const auto part = [&](int k) {
             return nested(
                 rule, [&](double yy, double xx) { return k == 0   ? 1.0
                                                          : k == 1 ? xx
                                                                   : yy; }, 0, h,
                 [](double) { return 0.0; }, end);
           };
           const auto area = part(0), mx = part(1), my = part(2);
           const Vector3d arm = corner + Vector3d(mx.value, my.value, 0) / area.value;
           return Answer{Value(turned(inertia, cross(arm, f * up))), area.evaluations};
         }});
  q.add(Breakdown{
      "Equal impulses at a trapezoid's corners are not the face's: weigh each triangle of the face by its "
      "area.",
      "points, equal impulses at the corners", 0, Outcome::inaccurate,
      "points, corners weighted by triangles", 0});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Quantity face = patch(p);
  return {
      claims(p["seed"]),
      {spin(p, truth), rebound(p), face},
      roots(p, face),
      R"(The velocities after the impulse are right; {{corners for a face|a few points are not exact for every contact}}.)"};
}

}  // namespace ex06_05

Exercise exercise_6_5() {
  using namespace ex06_05;
  return {"Contact at two points",
          "Two bodies touch at two points $P_0$, $P_1$. Find the delta function of the set and with it the "
          "velocities $v^+$, $w^+$ after the impulse; compare with contact along the segment $P_0P_1$. "
          "Below $fN$ is the impulse, $m$ and $J$ are the mass and the inertia tensor, and $r(P)$ is the "
          "arm of $P$ from the center of mass.",
          parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
