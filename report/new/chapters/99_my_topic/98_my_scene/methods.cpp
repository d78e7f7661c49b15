// The motion of exercise 99.98 by all its methods.

#include "chapters/99_my_topic/98_my_scene/models.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace ex99_98 {

Quantity swing(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const MassOnSpring<double> mass{{p["c"], p["m"], p["x0"]}};
  Quantity x = quantity("swing", "m", "stretch at " + times_up_to(horizon),
                        trajectory(truth, "99_98_my_scene", {p["c"], p["m"], p["x0"]}, horizon),
                        {1e-5, "a hundredth of a millimetre"});
  SceneMethods(x, horizon, halving("step", 0.125, 9), tolerances())
      .by<ode::RungeKutta4>("mass on a spring", mass)
      .by<ode::Fehlberg78>("mass on a spring", mass);
  return x;
}

}  // namespace ex99_98

}  // namespace oddity
