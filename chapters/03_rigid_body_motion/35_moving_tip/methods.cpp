// The quantities of exercise 3.35: the top whose tip is at (A sin(lambda t), 0, 0).

#include <cmath>
#include <numbers>

#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/moving_tip.hpp"
#include "chapters/scene.hpp"

namespace oddity::ex03_35 {

using namespace moving_tip;

namespace {

/// Discriminant of the quadratic equation for the rate of steady precession at the tilt of the start;
/// negative if there is no such rate.
double discriminant(const Top& t) { return t.a() * t.a() - 4 * t.alpha() * std::cos(t.phi); }

}  // namespace

double nutation_frequency(const Top& t) {
  const double u = std::cos(t.phi), inside = discriminant(t);
  if (inside < 0) return 2 * std::numbers::pi * ex03_33::nods_a_second(t);
  const double slow = 2 * t.alpha() / (t.a() + std::copysign(std::sqrt(inside), t.a()));
  const double rate = std::abs(slow) + std::hypot(t.a() - 2 * slow * u, slow * std::sin(t.phi));
  return std::round(64 * rate) / 64;
}

std::string at_nutation(const Top& t) {
  return discriminant(t) < 0 ? "at the frequency of its nutation on a fixed tip"
                             : "at about the frequency of nutation and precession together";
}

namespace {

std::vector<double> inputs(const Top& top) {
  return {top.m,   top.l,      top.mu1,  top.mu3,  top.g, top.theta, top.phi,
          top.psi, top.dtheta, top.dphi, top.dpsi, top.A, top.lambda};
}

constexpr const char* fixed_tip = "fixed tip, as proposed";
constexpr const char* separate = "the accelerated tip turns the top";

Resolution shaken_steps() { return halving("step", 0.03125, 8); }

Quantity shaken_axis(const std::string& name, const std::string& says, const Top& top, const Horizon& horizon,
                     const Reference& truth) {
  const std::string tilted = "Euler angles", quaternion = "rigid body, quaternion",
                    momentum = "axis and angular momentum", first = "first order in A",
                    order = "its order is too low for this need at this step",
                    squares = "terms of order $A^2$ are left out";
  const AxisAndMomentum<double> proposed{with_fixed_tip(top)}, full{top};
  const FirstOrderInA<double> linear{top};
  constexpr Outcome off = Outcome::inaccurate;
  Quantity q = quantity(name, "1", says, trajectory(truth, "03_35_axis", inputs(top), horizon),
                        {1e-7, "a fiftieth of a second of arc"});
  SceneMethods(q, horizon, shaken_steps(), tolerances(3, 11))
      .by<ode::ExplicitEuler>(fixed_tip, proposed, off, separate)
      .by<ode::RungeKutta4>(fixed_tip, proposed, off, separate)
      .by<ode::DormandPrince54>(fixed_tip, proposed, off, separate)
      .by<ode::Fehlberg78>(fixed_tip, proposed, off, separate)
      .closed_form("small tilt", SmallTilt<double>{top}, off, "the tilt is not small")
      .by<ode::ExplicitEuler>(first, linear, off, squares)
      .by<ode::RungeKutta4>(first, linear, off, squares)
      .by<ode::DormandPrince54>(first, linear, off, squares)
      .by<ode::Fehlberg78>(first, linear, off, squares)
      .by_engine_integrators(tilted, EulerAngles<double>{top})
      .by_engine_integrators(quaternion, RigidBody<double>{top}, Outcome::drifted)
      .by<ode::ExplicitEuler>(momentum, full, off, order)
      .by<ode::RungeKutta4>(momentum, full)
      .by<ode::DormandPrince54>(momentum, full)
      .by<ode::Fehlberg78>(momentum, full);
  return q.add(Breakdown{
      R"(The motion about a fixed tip, carried along with the tip, is another motion: to the axis the )"
      R"(tip's acceleration is a second gravity, which swings. The torque of $-m\ddot{\mathbf p}$ about )"
      R"(the tip puts it right.)",
      std::string(fixed_tip) + ", Fehlberg 7(8)", 1e-11, Outcome::inaccurate,
      "rigid body, quaternion, Fehlberg 7(8)", 1e-11});
}

Quantity nearly_upright(Top top, const Reference& truth) {
  top.phi = 0.015625;
  top.dtheta = top.dphi = 0;
  top.A /= 16;
  const Horizon horizon{ex03_33::duration};
  Quantity q =
      quantity("nearly_upright", "1",
               filled("axis of the same top let go @2 degrees off the vertical, A / 16", {top.phi / degree}),
               trajectory(truth, "03_35_axis", inputs(top), horizon),
               {1e-4, "twenty seconds of arc: nothing that is seen"});
  SceneMethods(q, horizon, halving("step", 0.03125, 8), tolerances(3, 9))
      .by<ode::Fehlberg78>(fixed_tip, AxisAndMomentum<double>{with_fixed_tip(top)}, Outcome::inaccurate,
                           separate)
      .closed_form("small tilt", SmallTilt<double>{top})
      .by<ode::Fehlberg78>("first order in A", FirstOrderInA<double>{top})
      .by<ode::Fehlberg78>("Euler angles", EulerAngles<double>{top})
      .by<ode::RungeKutta4>("rigid body, quaternion", RigidBody<double>{top})
      .by<ode::Fehlberg78>("axis and angular momentum", AxisAndMomentum<double>{top});
  return q;
}

// ---- error of the fixed-tip motion ------------------------------------------------------------------------

/// (A, lambda), (A/8, lambda), (A, 2 lambda), and A at the nutation's frequency.
std::array<Top, 4> shakings(const Top& top) {
  std::array<Top, 4> all{top, top, top, top};
  all[1].A /= 8;
  all[2].lambda *= 2;
  all[3].lambda = nutation_frequency(top);
  return all;
}

double angle_between(const Vector<double>& a, const Vector<double>& b) {
  const Vector<double> normal = cross(a, b);
  return std::atan2(std::sqrt(dot(normal, normal)), dot(a, b));
}

/// The largest angle between two motions of an axis at the same times.
double largest_angle(const Answer& some, const Answer& other) {
  if (!some.reached() || !other.reached()) return NAN;
  const Value &x = some.value, &y = other.value;
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); i += 3)
    largest = std::max(largest, angle_between({x[i], x[i + 1], x[i + 2]}, {y[i], y[i + 1], y[i + 2]}));
  return largest;
}

constexpr double observed_after = ex03_33::duration;

template <class Algorithm, class Model>
Answer followed_deviation(const Top& top, double tolerance) {
  Answer answer;
  std::vector<double> angles;
  const Horizon horizon{observed_after, 1};
  const auto still = observe_integrated<Algorithm>(Model{with_fixed_tip(top)}, horizon, tolerance);
  if (!still.reached()) return still;
  answer.evaluations = still.evaluations;
  for (const Top& shaken : shakings(top)) {
    const auto moved = observe_integrated<Algorithm>(Model{shaken}, horizon, tolerance);
    answer.evaluations += moved.evaluations;
    if (!moved.reached()) {
      answer.ending = moved.ending;
      answer.message = moved.message;
      return answer;
    }
    const Value &x = still.value, &y = moved.value;
    angles.push_back(angle_between({x[0], x[1], x[2]}, {y[0], y[1], y[2]}));
  }
  answer.value = Value(std::move(angles));
  return answer;
}

Quantity deviation(const Top& top, const Reference& truth) {
  const auto axis_at = [&](const Top& t) {
    auto in = inputs(t);
    in.push_back(observed_after);
    return truth("03_35_axis", in);
  };
  Known known = axis_at(with_fixed_tip(top));
  const Vector<double> still{known.value[0], known.value[1], known.value[2]};
  known.value.clear();
  known.error = 1e-15;
  for (const Top& shaken : shakings(top)) {
    const auto x = axis_at(shaken).value;
    known.value.push_back(angle_between(still, {x[0], x[1], x[2]}));
  }
  Quantity q =
      quantity("deviation", "rad",
               filled(R"(angle after @1 s between the axis and that of the same top with its tip fixed, for )"
                      R"($(A,\lambda)$, $(A/8,\lambda)$, $(A,2\lambda)$ and $A$ )" +
                          at_nutation(top),
                      {observed_after}),
               known, {1e-6, "a fifth of a second of arc"});
  q.add({fixed_tip, "no difference", no_resolution(),
         [](double) {
           return Answer{{0, 0, 0, 0}, 0};
         },
         Outcome::inaccurate, separate});
  q.add({"first order in A", "Fehlberg 7(8)", tolerances(3, 11),
         [=](double e) { return followed_deviation<ode::Fehlberg78, FirstOrderInA<double>>(top, e); },
         Outcome::inaccurate, "terms of order $A^2$ are left out"});
  q.add({"Euler angles", "Fehlberg 7(8)", tolerances(3, 11),
         [=](double e) { return followed_deviation<ode::Fehlberg78, EulerAngles<double>>(top, e); }});
  q.add({"rigid body, quaternion", "Fehlberg 7(8)", tolerances(3, 11),
         [=](double e) { return followed_deviation<ode::Fehlberg78, RigidBody<double>>(top, e); }});
  q.add({"axis and angular momentum", "Fehlberg 7(8)", tolerances(3, 11),
         [=](double e) { return followed_deviation<ode::Fehlberg78, AxisAndMomentum<double>>(top, e); }});
  return q;
}

}  // namespace

Quantity axis(const Top& top, const Horizon& horizon, const Reference& truth) {
  Quantity q = shaken_axis("axis", "unit vector along the axis at four times", top, horizon, truth);
  SceneMethods(q, horizon, shaken_steps(), tolerances(3, 11))
      .by_remaining_integrators(
          "axis and angular momentum", AxisAndMomentum<double>{top},
          {{"modified midpoint", Outcome::inaccurate, "its order is too low for this need at this step"},
           {"linearly implicit Euler", Outcome::inaccurate, "a first-order method that damps the nodding"}});
  return q;
}

Deviation::Deviation(const Top& top) {
  const Horizon many_times{ex03_33::duration, 240};
  const auto motion_of = [&](const Top& t) {
    return observe_integrated<ode::Fehlberg78>(AxisAndMomentum<double>{t}, many_times, 1e-9);
  };
  const Answer still = motion_of(with_fixed_tip(top));
  const auto shaken = shakings(top);
  as_asked = largest_angle(still, motion_of(shaken[0]));
  twice_the_frequency = largest_angle(still, motion_of(shaken[2]));
  at_nutation = largest_angle(still, motion_of(shaken[3]));
}

std::vector<Quantity> quantities(const Top& top, const Reference& truth) {
  Top resonant = top, strong = top;
  resonant.A /= 8;
  resonant.lambda = nutation_frequency(top);
  strong.A *= 4;
  strong.lambda += 5;
  const Horizon horizon{ex03_33::duration};
  return {shaken_axis("near_resonance", "axis with the tip shaken by A / 8 " + at_nutation(top), resonant,
                      horizon, truth),
          shaken_axis("strong_shaking", "axis with the tip shaken by $4A$, 5 rad/s faster", strong, horizon,
                      truth),
          nearly_upright(top, truth), deviation(top, truth)};
}

}  // namespace oddity::ex03_35
