// The quantities of exercise 3.13.

#include <string>

#include "chapters/03_rigid_body_motion/13_tilted_chute/tilted_chute.hpp"

namespace oddity::ex03_13 {

using namespace tilted_chute;

const std::string center = "center line", small = "small angle", exact_angle = "elliptic angle",
                  about = "angle about the axis", plane = "height field", space = "Cartesian with constraint";

Quantity slide(const std::string& name, const std::string& says, const Given<double>& c,
               const Horizon& horizon, const Reference& truth) {
  Quantity position = quantity(
      name, "m", says, trajectory(truth, "03_13_chute", {c.R, c.L, c.H, c.g, c.phi, c.u}, horizon), {});
  position.need = {1e-8 * size_of(position.reference.value), "eight digits of the farthest coordinate"};
  return position;
}

/// Adds all methods except those in the height field, which differ between the quantities.
SceneMethods swinging(Quantity& position, const Given<double>& c, const Horizon& horizon) {
  SceneMethods methods(position, horizon, halving("step", 0.125, 10), tolerances(3, 11));
  methods.closed_form(center, CenterLine<double>{c}, Outcome::inaccurate, "the ball is off the center line")
      .closed_form(small, SmallAngle<double>{c}, Outcome::inaccurate, "the period grows with the amplitude")
      .closed_form(exact_angle, EllipticAngle<double>(c))
      .by_engine_integrators(about, Angle<double>{c})
      .by_engine_integrators(space, InSpace<double>{c});
  return methods;
}

const std::string low_order = "its order is too low for this need at this step";

Quantity swing(const Given<double>& c, const Horizon& horizon, const Reference& truth) {
  Quantity position =
      slide("swing", "position of a ball released off the center line, at " + times_up_to(horizon), c,
            horizon, truth);
  swinging(position, c, horizon)
      .by_engine_integrators(plane, in_plane(c))
      .by_remaining_integrators(
          about, Angle<double>{c},
          {{"linearly implicit Euler", Outcome::inaccurate, "a first-order method that damps every swing"}});
  return position;
}

Quantity below_rim(const Given<double>& c, const Horizon& horizon, const Reference& truth) {
  Quantity position =
      slide("steep", R"(position from a start at $\phi=1.5$, just below the rim)", c, horizon, truth);
  swinging(position, c, horizon)
      .by<ode::ExplicitEuler>(plane, in_plane(c), Outcome::inaccurate, low_order)
      .by<ode::RungeKutta4>(plane, in_plane(c))
      .by<ode::CashKarp54>(plane, in_plane(c))
      .by<ode::DormandPrince54>(plane, in_plane(c))
      .by<ode::Fehlberg78>(plane, in_plane(c))
      .by<ode::BulirschStoer>(plane, in_plane(c), Outcome::non_finite,
                              "its long trial steps leave the chute, $|x_2|>R$");
  return position.add(Breakdown{
      "Near the rim the coarse first substeps of a long trial step leave the chute, where the height has no "
      "value. The step is taken as if all were well. In the angle there is nothing to leave.",
      plane + ", Bulirsch-Stoer", 1e-11, Outcome::non_finite, about + ", Bulirsch-Stoer", 1e-11});
}

Quantity on_center(const Given<double>& c, const Horizon& horizon, const Reference& truth) {
  Quantity position = slide("center", "position from a start on the center line", c, horizon, truth);
  SceneMethods(position, horizon, halving("step", 0.125, 10), tolerances(3, 11))
      .closed_form(center, CenterLine<double>{c})
      .closed_form(small, SmallAngle<double>{c})
      .closed_form(exact_angle, EllipticAngle<double>(c))
      .by<ode::ExplicitEuler>(plane, in_plane(c), Outcome::inaccurate, low_order)
      .by<ode::RungeKutta4>(plane, in_plane(c))
      .by<ode::DormandPrince54>(plane, in_plane(c))
      .by<ode::RungeKutta4>(space, InSpace<double>{c})
      .by<ode::DormandPrince54>(space, InSpace<double>{c});
  return position;
}

Quantity from_rim(const Given<double>& c, const Horizon& horizon, const Reference& truth) {
  const std::string why = "at $|x_2|=R$ the height's slope is infinite";
  Quantity position = slide("rim", "position from a start on the rim, $x_2=R$", c, horizon, truth);
  SceneMethods(position, horizon, halving("step", 0.125, 10), tolerances(3, 11))
      .closed_form(small, SmallAngle<double>{c}, Outcome::inaccurate, "the period grows with the amplitude")
      .closed_form(exact_angle, EllipticAngle<double>(c))
      .by<ode::RungeKutta4>(about, Angle<double>{c})
      .by<ode::DormandPrince54>(about, Angle<double>{c})
      .by<ode::RungeKutta4>(plane, in_plane(c), Outcome::non_finite, why)
      .by<ode::DormandPrince54>(plane, in_plane(c), Outcome::non_finite, why)
      .by<ode::RungeKutta4>(space, InSpace<double>{c})
      .by<ode::DormandPrince54>(space, InSpace<double>{c});
  return position.add(Breakdown{
      "On the rim the height field has no slope: the ball let go there never gets a state that is "
      "a number. For the angle about the axis the rim is a point like any other.",
      plane + ", Runge-Kutta 4", 0.0009765625, Outcome::non_finite, about + ", Runge-Kutta 4", 0.0009765625});
}

}  // namespace oddity::ex03_13
