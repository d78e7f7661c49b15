// The quantities of exercise 3.33: the axis in time, its bounds, steady precession and the sleeping top.

#include <cmath>
#include <numbers>

#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/expect_failure.hpp"
#include "chapters/scene.hpp"
#include "solvers/dual.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/roots.hpp"

namespace oddity::ex03_33 {

using namespace heavy_top;

namespace {

constexpr const char* rigid_body = "rigid body, quaternion";
constexpr const char* euler_angles = "Euler angles";
constexpr const char* momentum_model = "axis and angular momentum";
constexpr const char* low_order = "its order is too low for this need at this step";
constexpr const char* divides = R"(it divides by $\sin\phi$)";

std::vector<double> inputs(const Top& t) {
  return {t.m, t.l, t.mu1, t.mu3, t.g, t.theta, t.phi, t.psi, t.dtheta, t.dphi, t.dpsi};
}

Known true_axis(const Top& top, const Horizon& horizon, const Reference& truth) {
  return trajectory(truth, "03_33_axis", inputs(top), horizon);
}

// ---- the height of the axis: one degree of freedom --------------------------------------------------------

/// f(u) = (e - 2 alpha u)(1 - u^2) - (b - a u)^2, the square of u'.
struct HeightCubic {
  double alpha, a, b, e, u0;

  explicit HeightCubic(const Top& t)
      : alpha(t.alpha()), a(t.a()), b(t.b()), e(HeightAlone<double>{t}.e), u0(std::cos(t.phi)) {}
  double operator()(double u) const { return (e - 2 * alpha * u) * (1 - u * u) - (b - a * u) * (b - a * u); }
  /// The three roots of f in ascending order, the last one beyond 1, by Viete's angles.
  Vector<double> roots() const {
    const double lead = 2 * alpha, third = -(e + a * a) / lead / 3, p1 = (2 * a * b - lead) / lead,
                 p0 = (e - b * b) / lead;
    const double q = third * third - p1 / 3, r = third * third * third - third * p1 / 2 + p0 / 2;
    const double angle = std::acos(std::clamp(r / (q * std::sqrt(q)), -1.0, 1.0)), size = -2 * std::sqrt(q);
    const auto root = [&](double turn) { return size * std::cos((angle + turn) / 3) - third; };
    return {root(0), root(-2 * std::numbers::pi), root(2 * std::numbers::pi)};
  }
};

/// sn(x, k) by descending Landen steps [DLMF 22.20.2].
double jacobi_sn(double x, double k) {
  std::array<double, 12> a{1}, c{k};
  double b = std::sqrt(1 - k * k);
  std::size_t n = 0;
  while (std::abs(c[n]) > 1e-17 && n + 1 < a.size()) {
    a[n + 1] = (a[n] + b) / 2;
    c[n + 1] = (a[n] - b) / 2;
    b = std::sqrt(a[n] * b);
    ++n;
  }
  double angle = std::ldexp(a[n] * x, static_cast<int>(n));
  for (; n > 0; --n) angle = (angle + std::asin(c[n] / a[n] * std::sin(angle))) / 2;
  return std::sin(angle);
}

/// u = u1 + (u2 - u1) sn^2(s t + F0), s^2 = alpha (u3 - u1)/2, k^2 = (u2 - u1)/(u3 - u1).
struct HeightByJacobi {
  double low, range, k, rate, phase;

  explicit HeightByJacobi(const Top& t) {
    const HeightCubic f(t);
    const auto [u1, u2, u3] = f.roots();
    low = u1;
    range = u2 - u1;
    k = std::sqrt(range / (u3 - u1));
    rate = std::sqrt(t.alpha() * (u3 - u1) / 2);
    const double slope = -std::sin(t.phi) * t.dphi / (range * std::sqrt(t.alpha() * (u3 - f.u0) / 2));
    phase = std::ellint_1(k, std::atan2(slope, 1 - 2 * (f.u0 - u1) / range) / 2);
  }
  std::array<double, 1> at(double t) const {
    const double sn = jacobi_sn(rate * t + phase, k);
    return {low + range * sn * sn};
  }
};

}  // namespace

double nods_a_second(const Top& top) {
  const HeightByJacobi height(top);
  return height.rate / (2 * std::comp_ellint_1(height.k));
}

namespace {

Quantity height(const Top& top, const Reference& truth) {
  const Horizon horizon{duration};
  Known known = true_axis(top, horizon, truth);
  known.value = {known.value[2], known.value[5], known.value[8], known.value[11]};
  Quantity q = quantity("height", "1", R"($\cos\phi$ after 1, 2, 3 and 4 s)", known,
                        {1e-7, "a fiftieth of a second of arc"});
  SceneMethods(q, horizon, halving("step", 0.03125, 8), tolerances(3, 11))
      .closed_form("Jacobi's sn", HeightByJacobi(top))
      .by<ode::SymplecticEuler>("one angle", Nutation<double>{top}, Outcome::inaccurate, low_order)
      .by<ode::VelocityVerlet>("one angle", Nutation<double>{top}, Outcome::inaccurate, low_order)
      .by<ode::RungeKutta4>("one angle", Nutation<double>{top})
      .by<ode::Fehlberg78>("one angle", Nutation<double>{top})
      .by<ode::RungeKutta4>("height alone", HeightAlone<double>{top})
      .by<ode::Fehlberg78>("height alone", HeightAlone<double>{top});
  return q;
}

/// The minimum and maximum height, from the first two turning points of a motion.
Answer followed_turns(const Top& top, double tolerance) {
  const AxisAndMomentum<double> model{{top}};
  const auto climbing = [&](const AxisAndMomentum<double>::State& x, double) {
    return x[3] * x[1] - x[4] * x[0];
  };
  Answer bounds{{0, 0}};
  auto state = model.start();
  double t = 0;
  for (int turn = 0; turn < 2; ++turn) {
    const auto event = ode::find_event<ode::Fehlberg78>(model, state, t, t + 10, tolerance, climbing);
    bounds.evaluations += event.evaluations;
    bounds.ending = event.ending;
    bounds.message = event.message;
    if (!event.reached()) return bounds;
    bounds.value[static_cast<std::size_t>(turn)] = event.value.state[2];
    // Half a millisecond further, so that the same turning point is not found again.
    const double on = event.value.time + 5e-4;
    const auto next =
        ode::integrate<ode::Fehlberg78>(model, event.value.state, event.value.time, on, tolerance);
    bounds.evaluations += next.evaluations;
    state = next.value;
    t = on;
  }
  if (bounds.value[0] > bounds.value[1]) std::swap(bounds.value[0], bounds.value[1]);
  return bounds;
}

Quantity nutation_bounds(const Top& top, const Reference& truth) {
  Quantity q = quantity(
      "nutation_bounds", "1", R"(least and greatest height $\cos\phi$ of the axis)",
      truth("03_33_bounds", {top.m, top.l, top.mu1, top.mu3, top.g, top.phi, top.dtheta, top.dphi, top.dpsi}),
      {1e-10, "ten decimals"});
  q.add({"cubic of the height", "Viete's angles", no_resolution(), [top](double) {
           const auto [u1, u2, u3] = HeightCubic(top).roots();
           return Answer{{u1, u2}, 1};
         }});
  q.add({"cubic of the height", "Brent", tolerances(4, 14), [top](double e) {
           const HeightCubic f(top);
           const auto low = brent(f, -1, f.u0, e), high = brent(f, f.u0, 1, e);
           return Answer{{low.value, high.value},
                         low.evaluations + high.evaluations,
                         std::max(low.error_estimate, high.error_estimate),
                         0,
                         low.reached() ? high.ending : low.ending,
                         low.message + high.message};
         }});
  q.add({momentum_model, "Fehlberg 7(8), event", tolerances(4, 12),
         [top](double e) { return followed_turns(top, e); }});
  return q;
}

// ---- steady precession ------------------------------------------------------------------------------------

bool has_steady_precession(const Top& t, double c) {
  const double u = std::cos(t.phi);  // below the tip both rates exist at any spin, the fast one backward
  return std::abs(u) > 1e-6 && std::pow(t.mu3 * c, 2) > 4 * t.mu1 * t.m * t.g * t.l * u;
}

/// The precession rate of the rigid body, measured over about one radian, started at the given rate.
Answer followed_precession(Top top, double c, double rate, double tolerance) {
  top.theta = top.psi = top.dphi = 0;
  top.dtheta = rate;
  top.dpsi = c - rate * std::cos(top.phi);
  const RigidBody<double> model{{top}};
  const double time = 1 / std::abs(rate);
  const auto end = ode::integrate<ode::Fehlberg78>(model, model.start(), 0, time, tolerance);
  const Vector<double> d = model.observe(end.value, time);
  return answer(end, [&](const auto&) { return std::array{std::atan2(d[0], -d[1]) / time}; });
}

enum class Rate { slow, fast };

/// A rate of steady precession at the initial tilt, with the total spin c.
Quantity steady_precession(const std::string& name, const std::string& says, const Top& top, double c,
                           Rate which, const Reference& truth) {
  const bool slow = which == Rate::slow;
  Quantity q = quantity(name, "rad/s", says,
                        truth("03_33_steady", {top.m, top.l, top.mu1, top.mu3, top.g, top.phi, c}), {});
  q.reference.value = Value{q.reference.value[slow ? 0 : 1]};
  q.reference_error = 0x1p-53 * size_of(q.reference.value);  // the table has many more decimals
  q.need = {1e-9 * size_of(q.reference.value), "nine digits"};
  const double across = top.mu1 * std::cos(top.phi), momentum = top.mu3 * c, weight = top.m * top.g * top.l;
  const double root = std::sqrt(momentum * momentum - 4 * across * weight);
  const bool of_fast_top = c > 1e5;
  const double limit = slow ? weight / momentum : momentum / across;
  const double taught = (slow ? momentum - root : momentum + root) / (2 * across);
  const double stable = slow ? 2 * weight / (momentum + root) : taught;
  q.add({"limit of a fast top", "closed form", no_resolution(),
         [=](double) {
           return Answer{limit, 1};
         },
         of_fast_top ? Outcome::ok : Outcome::inaccurate, of_fast_top ? "" : "the spin is not fast enough"});
  q.add({"quadratic", "as it is taught", no_resolution(),
         [=](double) {
           return Answer{taught, 1};
         },
         of_fast_top ? Outcome::inaccurate : Outcome::ok,
         of_fast_top ? "two nearly equal numbers are subtracted" : ""});
  if (slow)
    q.add({"quadratic", "without cancellation", no_resolution(), [=](double) { return Answer{stable, 1}; }});
  q.add({"balance of torques", "Brent", tolerances(6, 14), [=](double e) {
           const auto miss = [&](double rate) { return rate * (momentum - across * rate) - weight; };
           const double vertex = momentum / (2 * across), first = weight / momentum;
           const auto [low, high] =
               across < 0 ? slow ? std::pair(0.0, first) : std::pair(2 * vertex - first, 2 * vertex)
               : slow ? std::pair(0.0, std::min(vertex, 2 * first))
                          : std::pair(vertex, 2 * vertex);
           return answer(brent(miss, low, high, e * (high - low)));
         }});
  if (!of_fast_top)
    q.add({rigid_body, "Fehlberg 7(8), one radian", tolerances(4, 12),
           [=](double e) { return followed_precession(top, c, stable, e); }});
  return q;
}

// ---- the sleeping top -------------------------------------------------------------------------------------

/// The lowest spin at which a top, released a millionth off the vertical, stays there for the given time: its
/// tilt does not grow with the time. By bisection.
Answer observed_threshold(Top top, double seconds) {
  constexpr double tilt = 1e-6, step = 0.045;  // the step in units of 1/sqrt(alpha)
  top.phi = tilt;
  top.theta = top.psi = top.dtheta = top.dphi = 0;
  const double fall = std::sqrt(top.alpha()), limit = tilt * fall * seconds / 2;
  Answer threshold{0};
  double low = 0, high = 10 * top.mu1 / top.mu3 * fall;
  while (high - low > 1e-7 * high) {
    top.dpsi = (low + high) / 2;
    bool fell = false;
    const auto watch = [&](double, const RigidBody<double>::State&, double,
                           const RigidBody<double>::State& x) {
      return fell = 4 * (x[1] * x[1] + x[2] * x[2]) > limit * limit;
    };
    const RigidBody<double> model{{top}};
    const std::array times{0.0, seconds};
    const auto run = ode::integrate<ode::RungeKutta4>(model, model.start(), std::span<const double>(times),
                                                      step / fall, watch);
    threshold.evaluations += run.evaluations;
    (fell ? low : high) = top.dpsi;
  }
  threshold.value = high;
  return threshold;
}

Quantity sleeping_threshold(const Top& top) {
  const double exact = 2 * std::sqrt(top.mu1 * top.m * top.g * top.l) / top.mu3;
  Quantity q{"sleeping_threshold",
             "rad/s",
             "least spin of an upright top that stays upright",
             {R"($c^2\mu_3^2=4\mu_1mg\ell$)", exact},
             1e-15 * exact,
             {1e-4 * exact, "a ten-thousandth of the spin"}};
  q.add({"effective potential", "Brent on its curvature by dual numbers", tolerances(4, 12), [=](double e) {
           const auto curvature = [&](double c) {
             const double a = top.mu3 * c / top.mu1;
             return second_derivative(
                 [&](const auto& tilt) {
                   const auto half = tan(0.5 * tilt);
                   return 0.5 * a * a * half * half + top.alpha() * cos(tilt);
                 },
                 0.0);
           };
           return answer(brent(curvature, 0, 10 * exact, e * exact));
         }});
  q.add({rigid_body, "Runge-Kutta 4, bisected", doubling("falls", 25, 4),
         [=](double times) { return observed_threshold(top, times / std::sqrt(top.alpha())); }});
  return q;
}

// ---- at and near the vertical -----------------------------------------------------------------------------

Quantity struck_upright(const Top& top, const Reference& truth) {
  Top upright = top;
  upright.theta = upright.phi = upright.psi = upright.dtheta = 0;
  upright.dphi = 0.5;
  upright.dpsi = 16;
  const Horizon horizon{4};
  Quantity q =
      quantity("struck_upright", "1",
               filled("axis of the same top struck while upright with a spin of @2 rad/s", {upright.dpsi}),
               true_axis(upright, horizon, truth), {1e-7, "a fiftieth of a second of arc"});
  SceneMethods(q, horizon, halving("step", 0.03125, 8), tolerances(3, 11))
      .by<ode::RungeKutta4>(euler_angles, EulerAngles<double>{{upright}}, Outcome::non_finite, divides)
      .by<ode::DormandPrince54>(euler_angles, EulerAngles<double>{{upright}}, Outcome::non_finite, divides)
      .by<ode::RungeKutta4>(rigid_body, RigidBody<double>{{upright}})
      .by<ode::DormandPrince54>(rigid_body, RigidBody<double>{{upright}})
      .by<ode::Fehlberg78>(momentum_model, AxisAndMomentum<double>{{upright}});
  return q.add(Breakdown{
      R"(Upright, the precession and the spin are turns about one line, and the Euler angles' equations )"
      R"(divide by $\sin\phi=0$. The quaternion has no such place.)",
      "Euler angles, Runge-Kutta 4", 0.00048828125, Outcome::non_finite,
      "rigid body, quaternion, Runge-Kutta 4", 0.00048828125});
}

Quantity past_the_vertical(const Top& top, const Reference& truth) {
  Top grazing = top;
  grazing.dtheta = 6.4;
  grazing.dphi = -0.5;
  grazing.dpsi = 18;
  const Horizon horizon{4};
  Quantity q = quantity("past_the_vertical", "1", "axis of the same top that passes close to the vertical",
                        true_axis(grazing, horizon, truth), {1e-7, "a fiftieth of a second of arc"});
  SceneMethods(q, horizon, halving("step", 0.03125, 8), tolerances(3, 11))
      .by<ode::RungeKutta4>(euler_angles, EulerAngles<double>{{grazing}})
      .by<ode::Fehlberg78>(euler_angles, EulerAngles<double>{{grazing}})
      .by<ode::RungeKutta4>(rigid_body, RigidBody<double>{{grazing}})
      .by<ode::Fehlberg78>(rigid_body, RigidBody<double>{{grazing}})
      .by<ode::Fehlberg78>(momentum_model, AxisAndMomentum<double>{{grazing}});
  return q.add(Breakdown{
      "Where the axis passes @2 rad from the vertical, the rate of precession peaks as "
      R"($1/\sin^2\phi$. Equal steps that serve the quaternion to @1 digits leave @1 with )"
      "Euler angles.",
      "Euler angles, Runge-Kutta 4",
      0.00048828125,
      Outcome::inaccurate,
      "rigid body, quaternion, Runge-Kutta 4",
      0.00048828125,
      {std::acos(HeightCubic(grazing).roots()[1]), digits_of(Side::cured), digits_of(Side::broken)}});
}

Quantity looping(const Top& top, const Reference& truth) {
  Top hanging = top;
  hanging.theta = hanging.psi = 0;
  hanging.phi = 2;
  hanging.dtheta = hanging.dphi = 1;
  hanging.dpsi = 5;
  const Horizon horizon{4};
  Quantity q = quantity("looping", "1", "axis of the same top hanging below its tip, its spin slow",
                        true_axis(hanging, horizon, truth), {1e-7, "a fiftieth of a second of arc"});
  SceneMethods(q, horizon, halving("step", 0.03125, 8), tolerances(3, 11))
      .by<ode::Fehlberg78>("one angle, precession by quadrature", OneAngle<double>{hanging})
      .by<ode::RungeKutta4>(euler_angles, EulerAngles<double>{{hanging}})
      .by<ode::Fehlberg78>(euler_angles, EulerAngles<double>{{hanging}})
      .by<ode::RungeKutta4>(rigid_body, RigidBody<double>{{hanging}})
      .by<ode::Fehlberg78>(rigid_body, RigidBody<double>{{hanging}})
      .by<ode::Fehlberg78>(momentum_model, AxisAndMomentum<double>{{hanging}});
  return q;
}

}  // namespace

Quantity axis(const Top& top, const Horizon& horizon, const Reference& truth) {
  Quantity q = quantity("axis", "1", "unit vector along the axis at four times",
                        true_axis(top, horizon, truth), {1e-7, "a fiftieth of a second of arc"});
  SceneMethods(q, horizon, halving("step", 0.03125, 8), tolerances(3, 11))
      .closed_form("mean precession of a fast top", MeanPrecession<double>{top}, Outcome::inaccurate,
                   R"(the axis nods, and its mean rate is $mg\ell/(\mu_3c)$ in the limit of fast spin only)")
      .by_engine_integrators("one angle, precession by quadrature", OneAngle<double>{top}, Outcome::drifted)
      .by_remaining_integrators(
          "one angle, precession by quadrature", OneAngle<double>{top},
          {{"modified midpoint", Outcome::inaccurate, low_order},
           {"linearly implicit Euler", Outcome::drifted, "a first-order method that damps the nodding"}})
      .by_engine_integrators(euler_angles, EulerAngles<double>{{top}})
      .by_engine_integrators(rigid_body, RigidBody<double>{{top}}, Outcome::drifted)
      .by<ode::ExplicitEuler>(momentum_model, AxisAndMomentum<double>{{top}}, Outcome::inaccurate, low_order)
      .by<ode::RungeKutta4>(momentum_model, AxisAndMomentum<double>{{top}})
      .by<ode::DormandPrince54>(momentum_model, AxisAndMomentum<double>{{top}})
      .by<ode::Fehlberg78>(momentum_model, AxisAndMomentum<double>{{top}});
  expect_failure(q, "one angle, precession by quadrature", "semi-implicit Euler", Outcome::inaccurate,
                 "first-order; its energy error stays bounded");
  expect_failure(q, euler_angles, "semi-implicit Euler", Outcome::drifted,
                 "first-order, and not symplectic where forces depend on the velocity");
  return q;
}

std::vector<Quantity> quantities(const Top& top, const Reference& truth) {
  std::vector<Quantity> all{height(top, truth), nutation_bounds(top, truth), sleeping_threshold(top)};
  if (has_steady_precession(top, top.dpsi)) {
    const std::string says = "rate at the start's tilt and total spin dpsi";
    all.push_back(steady_precession("steady_slow", "slow " + says, top, top.dpsi, Rate::slow, truth));
    all.push_back(steady_precession("steady_fast", "fast " + says, top, top.dpsi, Rate::fast, truth));
  }
  Top hanging = top;
  hanging.phi = 2;
  const std::string of_hanging =
      filled(" rate of the same top at a tilt of @2 rad, below its tip, total spin dpsi", {hanging.phi});
  for (Rate root : {Rate::slow, Rate::fast}) {
    const std::string name = root == Rate::slow ? "slow" : "fast";
    all.push_back(
        steady_precession("steady_" + name + "_hanging", name + of_hanging, hanging, top.dpsi, root, truth));
  }
  if (has_steady_precession(top, 0x1p20))
    all.push_back(
        steady_precession("steady_slow_of_fast_top", "slow rate at a spin of $2^{20}$ rad/s", top, 0x1p20,
                          Rate::slow, truth)
            .add(Breakdown{"The slow rate is the difference of two nearly equal numbers and keeps @1 digits; "
                           "multiplied out by the other root, it is a sum.",
                           "quadratic, as it is taught",
                           0,
                           Outcome::inaccurate,
                           "quadratic, without cancellation",
                           0,
                           {digits_of(Side::broken)}}));
  all.push_back(struck_upright(top, truth));
  all.push_back(past_the_vertical(top, truth));
  all.push_back(looping(top, truth));
  return all;
}

}  // namespace oddity::ex03_33
