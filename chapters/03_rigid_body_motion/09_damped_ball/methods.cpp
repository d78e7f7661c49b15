// The quantities of exercise 3.9.

#include <cmath>

#include "chapters/03_rigid_body_motion/09_damped_ball/damped_ball.hpp"
#include "solvers/ode/events.hpp"

namespace oddity::ex03_09 {

using namespace damped_ball;

Known true_path(const Ball& b, const Horizon& horizon, const Reference& truth) {
  return trajectory(truth, "03_09_ball", {b.m, b.c, b.a, b.p1, b.p2, b.v1, b.v2}, horizon);
}

Quantity path(const std::string& name, const std::string& says, const Ball& b, const Horizon& horizon,
              const Reference& truth) {
  Quantity q = quantity(name, "m", says, true_path(b, horizon, truth), {1e-8, "a hundredth of a micrometre"});
  const double d = b.a * b.a - 4 * b.m * b.c;
  SceneMethods(q, horizon, halving("step", 0.125, 11), tolerances(3, 11))
      .closed_form("closed form, one for all regimes", OneForm<double>{b})
      .closed_form("two exponentials", TwoExponentials<double>{b}, d > 0 ? Outcome::ok : Outcome::non_finite,
                   d > 0 ? "" : "there are no two real roots")
      .by_engine_integrators("plane", Plane<double>{b}, Outcome::inaccurate, Outcome::inaccurate)
      .by_remaining_integrators("plane", Plane<double>{b},
                                {{"linearly implicit Euler", Outcome::inaccurate,
                                  "its order is too low for this need at this step"}})
      .by_core_integrators("plane, with the work", PlaneWithWork<double>{b}, Outcome::inaccurate,
                           Outcome::inaccurate)
      .by<ode::Rosenbrock4>("plane, with the work", PlaneWithWork<double>{b});
  return q;
}

Quantity first_arrival(const Ball& at_rest) {
  const double h = at_rest.a / (2 * at_rest.m), beta = std::sqrt(at_rest.c / at_rest.m - h * h);
  const double arrival = std::atan2(beta, -h) / beta;
  const Outcome printed = at_rest.p1 == 0 ? Outcome::non_finite : Outcome::inaccurate;
  Quantity time{"first_arrival",
                "s",
                "time at which the ball, let go at rest, is at the origin first",
                {R"(the angle of $(-h,\beta)$ over $\beta$, $h=a/(2m)$)", arrival},
                4e-16 * arrival,
                {1e-9, "nine decimals"}};
  time.add({"the text's formula", "atan(-beta p1/(v1 - alpha p1))/beta", no_resolution(),
            [=](double) {
              const double v1 = 0, alpha = -h;
              return Answer{std::atan(-beta * at_rest.p1 / (v1 - alpha * at_rest.p1)) / beta, 1};
            },
            printed,
            at_rest.p1 == 0 ? "the quotient is 0/0"
                            : "the principal value is negative: it lies before the start"});
  time.add({"plane", "Fehlberg 7(8)", tolerances(), [=](double tolerance) {
              const Plane<double> plane{at_rest};
              const auto along = [&](const Plane<double>::State& x, double) {
                return x[0] * at_rest.p1 + x[1] * at_rest.p2;
              };
              return answer(
                  ode::find_event<ode::Fehlberg78>(plane, plane.start(), 0, 2 * arrival, tolerance, along),
                  [](const auto& event) { return event.time; });
            }});
  return time.add(Breakdown{
      at_rest.p1 == 0 ? "A game that schedules the hit by the printed time gets no number for it. The "
                        "arrival found along the motion is right."
                      : "A game that schedules the hit by the printed time puts it into the past: the "
                        "event never fires. The arrival found along the motion is right.",
      "the text's formula, atan(-beta p1/(v1 - alpha p1))/beta", 0, printed, "plane, Fehlberg 7(8)", 1e-12});
}

Quantity near_critical_path(const Ball& b, const Horizon& horizon, const Reference& truth) {
  Quantity q =
      quantity("near_critical", "m",
               filled("position with friction above critical by the fraction $@1$", {above_critical}),
               true_path(b, horizon, truth), {1e-12, "twelve decimals"});
  SceneMethods(q, horizon, no_resolution(), no_resolution())
      .closed_form("one form for all regimes", OneForm<double>{b})
      .closed_form("two exponentials", TwoExponentials<double>{b}, Outcome::inaccurate,
                   "its two terms nearly cancel where the roots nearly meet");
  // The larger of x = K1 e^(r1 t) + K2 e^(r2 t) over both coordinates, with r1 - r2 = 2 w.
  const double h = b.a / (2 * b.m), w = std::sqrt(h * h - b.c / b.m),
               factor = std::max(std::abs(b.v1 + h * b.p1), std::abs(b.v2 + h * b.p2)) / (2 * w);
  return q.add(Breakdown{
      "Where the roots nearly meet, the two exponentials have factors of $@1$ and of opposite "
      R"(sign: @2 digits are right. One form for all regimes, with $\sinh(wt)/w$ as one function, loses )"
      "none.",
      "two exponentials, closed form",
      0,
      Outcome::inaccurate,
      "one form for all regimes, closed form",
      0,
      {factor, digits_of(Side::broken)}});
}

/// The largest step at which the algorithm keeps a decaying motion bounded over a thousand steps, by
/// bisection.
template <class Algorithm>
Answer largest_stable_step(const Ball& ball) {
  const auto fast = [&](const std::array<double, 2>& x, std::array<double, 2>& dxdt, double) {
    dxdt = {x[1], (-ball.c * x[0] - ball.a * x[1]) / ball.m};
  };
  Answer limit{0};
  double low = 0, high = 10 * ball.m / ball.a;
  while (high - low > 1e-6 * high) {
    const double h = (low + high) / 2;
    const auto end = ode::integrate<Algorithm>(fast, std::array{1.0, -ball.a / ball.m}, 0, 1000 * h, h);
    limit.evaluations += end.evaluations;
    (end.reached() && std::abs(end.value[1]) <= ball.a / ball.m ? low : high) = h;
  }
  limit.value = low;
  return limit;
}

Quantity stability_limit(const Ball& ball) {
  const double fastest = (ball.a + std::sqrt(ball.a * ball.a - 4 * ball.m * ball.c)) / (2 * ball.m);
  Quantity q{"stability_limit",
             "s",
             "largest stable step of explicit Euler where friction is strong: $2/|r_2|$",
             {"$2/|r_2|$ from the characteristic polynomial", 2 / fastest},
             1e-16,
             {1e-3 * 2 / fastest, "a thousandth of the limit"}};
  q.add({"stiff", "explicit Euler, bisected", no_resolution(),
         [=](double) { return largest_stable_step<ode::ExplicitEuler>(ball); }});
  q.add({"stiff", "Runge-Kutta 4, bisected, by 2/2.785294", no_resolution(), [=](double) {
           Answer limit = largest_stable_step<ode::RungeKutta4>(ball);
           limit.value = limit.value[0] * 2 / 2.785293563405282;
           return limit;
         }});
  return q;
}

}  // namespace oddity::ex03_09
