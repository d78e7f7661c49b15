#pragma once

// The quantities of exercise 3.35: the top whose tip is at (A sin(lambda t), 0, 0).

#include "chapters/03_rigid_body_motion/shared/top.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/models.hpp"

namespace oddity::top {

inline std::vector<double> shaken_inputs(const Top& top) {
  auto in = top.inputs();
  in.insert(in.end(), {top.A, top.lambda});
  return in;
}

inline constexpr const char* fixed_tip = "fixed tip, as proposed";
inline constexpr const char* separate = "the accelerated tip turns the top";

inline Knob shaken_steps() { return halving("step", 0.03125, 8); }

inline Quantity shaken_axis(const std::string& name, const std::string& says, const Top& top,
                            const Horizon& horizon, const Reference& truth) {
  const std::string tilted = "Euler angles", quaternion = "rigid body, quaternion",
                    momentum = "axis and angular momentum", first = "first order in A",
                    order = "its order is too low for this need at this step",
                    squares = "terms of order A^2 are left out";
  const AxisAndMomentum proposed{with_fixed_tip(top)}, full{top};
  const FirstOrderInA linear{top};
  constexpr Outcome off = Outcome::inaccurate;
  Quantity q = quantity(name, "1", says, trajectory(truth, "03_35_axis", shaken_inputs(top), horizon),
                        {1e-7, "a fiftieth of a second of arc"});
  Ladder(q, horizon, shaken_steps(), tolerances(3, 11))
      .by<ode::ExplicitEuler>(fixed_tip, proposed, off, separate)
      .by<ode::RungeKutta4>(fixed_tip, proposed, off, separate)
      .by<ode::DormandPrince54>(fixed_tip, proposed, off, separate)
      .by<ode::Fehlberg78>(fixed_tip, proposed, off, separate)
      .closed_form("small tilt", SmallTilt{top}, off, "the tilt is not small")
      .by<ode::ExplicitEuler>(first, linear, off, squares)
      .by<ode::RungeKutta4>(first, linear, off, squares)
      .by<ode::DormandPrince54>(first, linear, off, squares)
      .by<ode::Fehlberg78>(first, linear, off, squares)
      .by_common(tilted, EulerAngles{top})
      .by_common(quaternion, RigidBody{top}, Outcome::drifted)
      .by<ode::ExplicitEuler>(momentum, full, off, order)
      .by<ode::RungeKutta4>(momentum, full)
      .by<ode::DormandPrince54>(momentum, full)
      .by<ode::Fehlberg78>(momentum, full);
  return q.add(Breakdown{
      "The motion about a fixed tip, carried along with the tip, is another motion: to the axis the tip's "
      "acceleration is a second gravity, which swings. The torque of -m p'' about the tip puts it right.",
      std::string(fixed_tip) + ", Fehlberg 7(8)", 1e-11, Outcome::inaccurate,
      "rigid body, quaternion, Fehlberg 7(8)", 1e-11});
}

inline Quantity nearly_upright(Top top, const Reference& truth) {
  top.phi = 0.015625;
  top.dtheta = top.dphi = 0;
  top.A /= 16;
  const Horizon horizon{duration};
  Quantity q =
      quantity("nearly_upright", "1", "axis of the same top let go one degree off the vertical, A / 16",
               trajectory(truth, "03_35_axis", shaken_inputs(top), horizon),
               {1e-4, "twenty seconds of arc: nothing that is seen"});
  Ladder(q, horizon, halving("step", 0.03125, 8), tolerances(3, 9))
      .by<ode::Fehlberg78>(fixed_tip, AxisAndMomentum{with_fixed_tip(top)}, Outcome::inaccurate, separate)
      .closed_form("small tilt", SmallTilt{top})
      .by<ode::Fehlberg78>("first order in A", FirstOrderInA{top})
      .by<ode::Fehlberg78>("Euler angles", EulerAngles{top})
      .by<ode::RungeKutta4>("rigid body, quaternion", RigidBody{top})
      .by<ode::Fehlberg78>("axis and angular momentum", AxisAndMomentum{top});
  return q;
}

// ---- how far the fixed-tip motion is from the truth -------------------------------------------------------

/// The frequency at which a top nutates about its steady precession, seen from the world, to a 64th.
inline double nutation_frequency(const Top& t) {
  const double u = std::cos(t.phi), inside = t.a() * t.a() - 4 * t.alpha() * u;
  if (inside < 0) return t.a();
  const double slow = 2 * t.alpha() / (t.a() + std::sqrt(inside));
  const double rate = slow + std::hypot(t.a() - 2 * slow * u, slow * std::sin(t.phi));
  return std::round(64 * rate) / 64;
}

/// (A, lambda), (A/8, lambda), (A, 2 lambda), and A at the nutation's frequency.
inline std::array<Top, 4> shakings(const Top& top) {
  std::array<Top, 4> all{top, top, top, top};
  all[1].A /= 8;
  all[2].lambda *= 2;
  all[3].lambda = nutation_frequency(top);
  return all;
}

inline double angle_between(const Vector& a, const Vector& b) {
  const Vector normal = cross(a, b);
  return std::atan2(std::sqrt(dot(normal, normal)), dot(a, b));
}

inline constexpr double observed_after = 4;

template <class Algorithm, class Model>
Answer followed_deviation(const Top& top, double tolerance) {
  Answer answer;
  std::vector<double> angles;
  const Horizon horizon{observed_after, 1};
  const auto still = observe_integrated<Algorithm>(Model{with_fixed_tip(top)}, horizon, tolerance);
  answer.evaluations = still.evaluations;
  for (const Top& shaken : shakings(top)) {
    const auto moved = observe_integrated<Algorithm>(Model{shaken}, horizon, tolerance);
    answer.evaluations += moved.evaluations;
    if (moved.ending != Ending::reached) answer.ending = moved.ending;
    const Value &x = still.value, &y = moved.value;
    angles.push_back(angle_between({x[0], x[1], x[2]}, {y[0], y[1], y[2]}));
  }
  answer.value = Value(std::move(angles));
  return answer;
}

inline Quantity deviation(const Top& top, const Reference& truth) {
  const auto axis_at = [&](const Top& t) {
    auto in = shaken_inputs(t);
    in.push_back(observed_after);
    return truth("03_35_axis", in);
  };
  Known known = axis_at(with_fixed_tip(top));
  const Vector still{known.value[0], known.value[1], known.value[2]};
  known.value.clear();
  known.error = 1e-15;
  for (const Top& shaken : shakings(top)) {
    const auto x = axis_at(shaken).value;
    known.value.push_back(angle_between(still, {x[0], x[1], x[2]}));
  }
  Quantity q =
      quantity("deviation", "rad",
               "angle after 4 s between the axis and that of the same top with its tip fixed, for (A, "
               "lambda), (A/8, lambda), (A, 2 lambda) and A at the nutation's frequency",
               known, {1e-6, "a fifth of a second of arc"});
  q.add({fixed_tip, "no difference", no_knob(),
         [](double) {
           return Answer{{0, 0, 0, 0}, 0};
         },
         Outcome::inaccurate, separate});
  q.add({"first order in A", "Fehlberg 7(8)", tolerances(3, 11),
         [=](double e) { return followed_deviation<ode::Fehlberg78, FirstOrderInA>(top, e); },
         Outcome::inaccurate, "terms of order A^2 are left out"});
  q.add({"Euler angles", "Fehlberg 7(8)", tolerances(3, 11),
         [=](double e) { return followed_deviation<ode::Fehlberg78, EulerAngles>(top, e); }});
  q.add({"rigid body, quaternion", "Fehlberg 7(8)", tolerances(3, 11),
         [=](double e) { return followed_deviation<ode::Fehlberg78, RigidBody>(top, e); }});
  q.add({"axis and angular momentum", "Fehlberg 7(8)", tolerances(3, 11),
         [=](double e) { return followed_deviation<ode::Fehlberg78, AxisAndMomentum>(top, e); }});
  return q;
}

inline std::vector<Quantity> moving_tip_quantities(const Top& top, const Reference& truth) {
  Top resonant = top, strong = top;
  resonant.A /= 8;
  resonant.lambda = nutation_frequency(top);
  strong.A *= 4;
  strong.lambda += 5;
  const Horizon horizon{duration};
  return {shaken_axis("near_resonance", "the same with A / 8 at the nutation's frequency", resonant, horizon,
                      truth),
          shaken_axis("strong_shaking", "the same with 4 A, 5 rad/s faster", strong, horizon, truth),
          nearly_upright(top, truth), deviation(top, truth)};
}

}  // namespace oddity::top
