// Exercise 3.35: the heavy symmetric top of exercise 3.33 whose tip is moved: p(t) = (A sin(lambda t), 0, 0).
// (A is the book's alpha, which in 3.33 is m g l/mu1.) About the tip, with F = -m g k - m p'':
//   L' = l d x F,   mu1 w1' = (mu1 - mu3) w2 w3 - l F2,   mu1 w2' = (mu3 - mu1) w3 w1 + l F1,   w3' = 0
// Judged against tops made of point masses, whose Lagrangian with a moving tip is differentiated by nested
// dual numbers. The models are those of top_models.hpp; top_moving_tip.hpp has the quantities.

#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/moving_tip.hpp"
#include "chapters/03_rigid_body_motion/shared/top_of_points.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace ex03_35 {

using namespace top;
using std::cos, std::sin;

constexpr Parameter parameters[] = {
    {"m", 1, "kg", "mass", 0.1, 10},
    {"l", 0.25, "m", "from the tip to the center of mass", 0.01, 1},
    {"mu1", 0.125, "kg m^2", "moment across the axis, about the tip", 0.01, 10},
    {"mu3", 0.0625, "kg m^2", "moment about the axis", 0.001, 10},
    {"g", 9.81, "m/s^2", "gravity", 0.1, 30},
    {"theta", 0.25, "rad", "precession angle at the start", -10, 10},
    {"phi", 0.5, "rad", "tilt at the start", 0.1, 3},
    {"psi", 0.75, "rad", "spin angle at the start", -10, 10},
    {"dtheta", 0.5, "rad/s", "its rate", -10, 10},
    {"dphi", 0.25, "rad/s", "its rate", -10, 10},
    {"dpsi", 30, "rad/s", "its rate", 1, 100},
    {"A", 0.0625, "m", "amplitude of the tip, the book's alpha", 1e-4, 1},
    {"lambda", 3, "rad/s", "its frequency", 0.1, 30},
    {"seed", 335, "", "seed of the random samples", 0, 1e9, whole_number},
};

using S = const Sample&;
using V = Judge::Version;

// ---- the points' motion along Lagrange's accelerations ----------------------------------------------------

struct Moving {
  Vector<double> x, v, a;
};

/// Position, velocity and acceleration of a body point.
Moving motion(S s, const Vector<double>& body_point) {
  using D = Dual<Dual<double>>;
  const auto angle = [&](std::size_t i) {
    return D(Dual<double>(s.q[i], s.v[i]), Dual<double>(s.v[i], s.truth[i]));
  };
  const auto r = rotation(angle(0), angle(1), angle(2));
  const auto x = s.body.position(Point{1, body_point}, r, D(Dual<double>(s.t, 1), Dual<double>(1)));
  Moving moving;
  for (std::size_t i = 0; i < 3; ++i) {
    moving.x[i] = x[i].value.value;
    moving.v[i] = x[i].value.slope;
    moving.a[i] = x[i].slope.slope;
  }
  return moving;
}

Vector<double> less(const Vector<double>& a, const Vector<double>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The rate of the angular momentum about a point moving with the body, as seen from it.
Vector<double> momentum_rate_about(S s, const Vector<double>& body_point) {
  const Moving center = motion(s, body_point);
  Vector<double> sum{};
  for (const Point& p : s.body.points) {
    const Moving point = motion(s, p.x);
    const Vector<double> moment = cross(less(point.x, center.x), less(point.a, center.a));
    for (std::size_t i = 0; i < 3; ++i) sum[i] += p.m * moment[i];
  }
  return sum;
}

/// The force on the tip: mass times the acceleration of the center of mass, less the weight.
Vector<double> tip_force(S s) {
  const Moving center = motion(s, {0, 0, s.l});
  return {s.m * center.a[0], s.m * center.a[1], s.m * (center.a[2] + s.body.g)};
}

Vector<double> tip(S s) { return {s.body.A * sin(s.body.lambda * s.t), 0, 0}; }

/// The rates of change (theta'', phi'', psi'') of the model with Euler angles.
Value model_accelerations(const Top& top, S s) {
  heavy_top::EulerAngles<double>::State rates;
  const heavy_top::EulerAngles<double> model{top};
  model(model.start(), rates, s.t);
  return {rates[3], rates[4], rates[5]};
}

/// (w1', w2', w3') along Lagrange's accelerations.
Value body_rates_change(S s) {
  const auto w = [&](std::size_t k) {
    return rate_of(s, s.truth, [k](const auto& q, const auto& v) {
      if (k == 0) return v[1] * cos(q[2]) + v[0] * sin(q[1]) * sin(q[2]);
      if (k == 1) return v[0] * sin(q[1]) * cos(q[2]) - v[1] * sin(q[2]);
      return v[2] + v[0] * cos(q[1]);
    });
  };
  return {w(0), w(1), w(2)};
}

Value euler_equations(const Top& top, S s) {
  heavy_top::RigidBody<double>::State rates;
  const heavy_top::RigidBody<double> model{top};
  model(model.start(), rates, s.t);
  return {rates[4], rates[5], rates[6]};
}

double vertical_momentum_rate(S s) {
  return rate_of(s, s.truth, [&](const auto& q, const auto& v) {
    return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + s.mu3 * (v[2] + v[0] * cos(q[1])) * cos(q[1]);
  });
}

Top at_rest(S s) { return moving_tip::with_fixed_tip(s.top()); }

// ---- the claims -------------------------------------------------------------------------------------------

std::vector<Claim> claims(const Judge& judge) {
  const V zero{"0", [](S) { return values(0); }};
  const V none{"(0, 0, 0)", [](S) { return values(0, 0, 0); }};

  const V about_center{"sum of m (x - r) x (x'' - r'') over the points", [](S s) {
                         return momentum_rate_about(s, {0, 0, s.l});
                       }};
  Claim force = judge.claim("force_at_center", 3089,
                            "what moves the tip is a force on the center of mass: it has no torque about it",
                            about_center, none, {});
  // The accelerations are those of Lagrange's equations: what cancels is larger than the two sides.
  const auto left_by = [&](const char* text, double sign) {
    const V rest{"sum of m (x - r) x (x'' - r'') over the points, less the torque", [=](S s) {
                   const Vector<double> rate = momentum_rate_about(s, {0, 0, s.l}),
                                        torque = cross(less(tip(s), motion(s, {0, 0, s.l}).x), tip_force(s));
                   return values(rate[0] - sign * torque[0], rate[1] - sign * torque[1],
                                 rate[2] - sign * torque[2]);
                 }};
    return Reading{text,
                   {judge.compare("rate of the angular momentum about the center of mass, less the "
                                  "torque of N = m (r'' + g k) at the tip",
                                  rest, none)}};
  };
  force.corrected = left_by("a force on the tip, with the torque (p - r) x N about the center of mass", 1);
  force.near_misses = {left_by("the torque (r - p) x N", -1)};
  force.why =
      "A force on the center of mass has no torque about it, and the angular momentum about the center would "
      "stay as it is. The tip is moved by what holds it: a force $\\mathbf N=m(\\ddot{\\mathbf r}+g\\mathbf "
      "k)$ at the tip, whose torque about the center of mass is $(\\mathbf p-\\mathbf r)\\times\\mathbf N$. "
      "What does act at the center of mass is the inertial force $-m\\ddot{\\mathbf p}$ in the tip's frame; "
      "it has a torque about the tip.";

  Claim about_axis =
      judge.claim("euler_about_axis", 3089, "Euler's equation for the motion about the axis still applies",
                  {"w3' along Lagrange's accelerations", [](S s) { return body_rates_change(s)[2]; }}, zero,
                  {{"psi''", [](S s) { return s.truth[2]; }}});

  const V change{"along Lagrange's accelerations, tip moving", body_rates_change};
  const V vertical{"its rate along Lagrange's accelerations, tip moving", vertical_momentum_rate};
  Claim about_vertical = judge.claim("euler_about_vertical", 3089,
                                     "Euler's equations with the torque of gravity alone still apply about "
                                     "the vertical: mu1 theta' sin^2 phi + c mu3 cos phi is a constant",
                                     vertical, zero, {});
  about_vertical.corrected = {"its rate is m l A lambda^2 sin(lambda t) cos theta sin phi",
                              {judge.compare("rate of the vertical angular momentum", vertical,
                                             {"m l A lambda^2 sin(lambda t) cos theta sin phi",
                                              [](S s) {
                                                const Points& b = s.body;
                                                return s.m * s.l * b.A * b.lambda * b.lambda *
                                                       sin(b.lambda * s.t) * cos(s.q[0]) * sin(s.q[1]);
                                              }}),
                               judge.compare("w' in body coordinates", change,
                                             {"Euler's equations with the torque of -m g k - m p''",
                                              [](S s) { return euler_equations(s.top(), s); }})}};
  about_vertical.near_misses = {
      {"Euler's equations with gravity alone",
       {judge.compare("w' in body coordinates", change,
                      {"torque of -m g k alone", [](S s) { return euler_equations(at_rest(s), s); }})}}};
  about_vertical.why =
      "With the tip as origin the frame is accelerated, and $-m\\ddot{\\mathbf p}$ acts at the center of "
      "mass beside gravity. Its torque about the tip has the vertical component $m\\ell\\,\\alpha\\lambda^2"
      "\\sin\\lambda t\\,\\cos\\theta\\sin\\phi$: the vertical angular momentum is not conserved, nor is the "
      "tilting moment gravity's alone. Only the spin $c$ stays constant.";

  const V lagrange{"nested dual numbers on the points' T - V, tip moving", [](S s) { return s.truth; }};
  Claim apart = judge.claim(
      "handled_separately", 3091,
      "the motion of the tip may be handled apart from that of the top: the angles "
      "move as with a fixed tip",
      {"(theta'', phi'', psi'') of the fixed tip", [](S s) { return model_accelerations(at_rest(s), s); }},
      lagrange, {});
  apart.corrected = {"with the torque of -m p'' at the center of mass",
                     {judge.compare("(theta'', phi'', psi'')",
                                    {"equations of the angles with the torque of -m p''",
                                     [](S s) { return model_accelerations(s.top(), s); }},
                                    lagrange),
                      judge.compare("rate of the angular momentum about the tip",
                                    {"l d x (-m g k - m p'')",
                                     [](S s) {
                                       Vector<double> rate = cross(s.top().axis(), s.top().force(s.t));
                                       for (double& x : rate) x *= s.l;
                                       return rate;
                                     }},
                                    {"sum of m (x - p) x (x'' - p'') over the points", [](S s) {
                                       return momentum_rate_about(s, {0, 0, 0});
                                     }})}};
  apart.near_misses = {{"with +m p''",
                        {judge.compare("(theta'', phi'', psi'')",
                                       {"the tip's acceleration with the other sign",
                                        [](S s) {
                                          Top other = s.top();
                                          other.A = -other.A;
                                          return model_accelerations(other, s);
                                        }},
                                       lagrange)}}};
  apart.why =
      "That is so only where $\\ddot{\\mathbf p}=0$. The accelerated tip adds to gravity a horizontal "
      "acceleration $\\alpha\\lambda^2\\sin\\lambda t$ that turns the top about its tip. With the values "
      "here its axis is 0.016 rad from that of the fixed top after 4 s, 0.043 rad at twice the frequency, "
      "and "
      "0.73 rad at 14.17 rad/s, the frequency of the nutation.";

  const V summed{"sum of m x/m over the points", [](S s) {
                   Vector<double> sum{};
                   for (const Point& p : s.body.points) {
                     const Vector<double> x = motion(s, p.x).x;
                     for (std::size_t i = 0; i < 3; ++i) sum[i] += p.m * x[i] / s.m;
                   }
                   return sum;
                 }};
  const auto along_axis = [](const char* text, double by) {
    return V{text, [by](S s) {
               const Vector<double> d = s.top().axis(), p = tip(s);
               return values(p[0] + by * s.l * d[0], p[1] + by * s.l * d[1], by * s.l * d[2]);
             }};
  };
  const V beyond = along_axis("p + l d", 1);
  Claim center = judge.claim("tip_is_center", 3091, "the tip is the center of mass", {"p(t)", tip}, summed,
                             {along_axis("p - l d", -1)});
  center.corrected = {"the center of mass is p + l d, d the unit vector along the axis",
                      {judge.compare("center of mass", beyond, summed)}};
  center.why =
      "The two are $\\ell$ apart, always: the center of mass is at $\\mathbf p+\\ell\\boldsymbol\\xi_3$ and "
      "has the acceleration $\\ddot{\\mathbf p}+\\ell\\ddot{\\boldsymbol\\xi}_3$. It is the tip that the "
      "exercise moves.";

  const auto of_center = [](S s) {
    // From the center of mass back to the tip: a + w' x (-l d) + w x (w x (-l d)).
    const Moving c = motion(s, {0, 0, s.l});
    const auto r = rotation(s.q[0], s.q[1], s.q[2]);
    const Value body = s.body_rates(), rate = euler_equations(s.top(), s);
    Vector<double> w{}, dw{}, arm{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        w[i] += r[i][k] * body[k];
        dw[i] += r[i][k] * rate[k];
      }
      arm[i] = -s.l * r[i][2];
    }
    const Vector<double> swing = cross(dw, arm), pull = cross(w, cross(w, arm));
    return values(c.a[0] + swing[0] + pull[0], c.a[1] + swing[1] + pull[1], c.a[2] + swing[2] + pull[2]);
  };
  const auto shaken = [](double sign) {
    return [sign](S s) {
      const double l = s.body.lambda;
      return values(-sign * s.body.A * l * l * sin(l * s.t), 0, 0);
    };
  };
  Claim given = judge.claim("tip_path", 3091, "the tip is at (A sin(lambda t), 0, 0): its acceleration",
                            {"-A lambda^2 sin(lambda t) along x", shaken(1)},
                            {"from the forces on the center of mass and Euler's equations", of_center},
                            {{"+A lambda^2 sin(lambda t)", shaken(-1)}});

  return {force, about_axis, about_vertical, apart, center, given};
}

Top asked(const Parameters& p) {
  return {p["m"],   p["l"],      p["mu1"],  p["mu3"],  p["g"], p["theta"], p["phi"],
          p["psi"], p["dtheta"], p["dphi"], p["dpsi"], p["A"], p["lambda"]};
}

Quantity axis_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return axis(asked(p), horizon, truth);
}

Scene scene() {
  return {
      axis_of,
      ex03_33::duration,
      degree,
      "lambda",
      {0.5, 1.5, 3, 6, 10, 14},
      {"phi", "dtheta", "dpsi"},
      {{"x", "y", "z"}, "s", {{"rad", {0, 1, 2}}}},
      {{"chapters/03_rigid_body_motion/35_moving_tip/models.hpp"},
       {{"fixed tip, as proposed",
         "moving_tip::AxisAndMomentum<double>{moving_tip::with_fixed_tip<double>({m, l, mu1, mu3, g, theta, phi, psi, "
         "dtheta, dphi, dpsi, A, lambda})}"},
        {"small tilt",
         "moving_tip::SmallTilt<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"},
        {"first order in A",
         "moving_tip::FirstOrderInA<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"},
        {"Euler angles",
         "moving_tip::EulerAngles<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"},
        {"rigid body, quaternion",
         "moving_tip::RigidBody<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"},
        {"axis and angular momentum",
         "moving_tip::AxisAndMomentum<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  std::vector<Quantity> all = quantities(asked(p), truth);
  all.insert(all.begin(), motion(scene(), p, truth));
  return {claims(Judge("3.35", p["seed"], 1)), all};
}

}  // namespace ex03_35

Exercise exercise_3_35() {
  using namespace ex03_35;
  return {
      "Heavy top on a moving tip",
      "The tip of the heavy symmetric top moves to and fro as $(\\alpha\\sin\\lambda t,0,0)$. What becomes "
      "of its motion?",
      parameters, scene(), study};
}

}  // namespace oddity
