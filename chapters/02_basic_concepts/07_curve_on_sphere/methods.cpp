// The quantities of exercise 2.7: w at a time, and integration of an orientation along the curve's frame.

#include "chapters/02_basic_concepts/07_curve_on_sphere/curve_on_sphere.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "chapters/stops.hpp"
#include "solvers/counted_calls.hpp"
#include "solvers/ode/steps_in.hpp"

namespace oddity::curve_on_sphere {

using namespace space;

namespace {

// ---- orientation as a scene -------------------------------------------------------------------------------

/// Orthonormalizes R by Gram-Schmidt, first column first.
void repair(std::array<double, 9>& x) {
  const Matrix3 R{x};
  const Vector3 r = unit(R.column(0)), u = unit(R.column(1) - dot(R.column(1), r) * r);
  x = Matrix3::columns(r, u, cross(r, u)).e;
}
void repair(Quaternion<double>& q) {
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& x : q) x /= size;
}

/// Steps through the horizon with advance(x, t, h) -> evaluations and observes.
template <class Model, class State, class Step>
Answer observe_steps(const Model& model, State x, const Horizon& horizon, double step, const Step& advance) {
  Answer answer;
  std::vector<double> seen;
  const auto steps = [&](double from, double to) {
    const double n = ode::steps_in(from, to, step), h = (to - from) / n;
    for (double k = 0; k < n && answer.evaluations <= ode::most_evaluations; ++k)
      answer.evaluations += advance(x, from + k * h, h);
    if (answer.evaluations <= ode::most_evaluations) return true;
    answer.ending = Ending::stalled;
    answer.message = "the budget of evaluations is spent";
    return false;
  };
  through_times(horizon, steps, [&](double t) {
    for (double component : model.observe(x, t)) seen.push_back(component);
    answer.drift = std::max(answer.drift, model.conserved(x, t)[0].value);
  });
  answer.value = Value(std::move(seen));
  return answer;
}

/// Integrates by a fixed step, and repairs the orientation after each.
template <class Algorithm, class Model>
Answer observe_repaired(const Model& model, const Horizon& horizon, double step) {
  return observe_steps(model, model.start(), horizon, step, [&](auto& x, double t, double h) {
    const auto one = ode::integrate<Algorithm>(model, x, t, t + h, h);
    x = one.value;
    repair(x);
    return one.evaluations;
  });
}

/// R(t + h) = exp(Skew(W)) R(t). Order 2: W = h w at the middle; order 4: from w at two Gauss points, with
/// the commutator [Iserles and Norsett, Phil. Trans. R. Soc. A 357 (1999) 983]. A rotation to rounding.
Answer observe_exponentials(const AsMatrix<double>& model, const Horizon& horizon, double step, int order) {
  return observe_steps(model, model.start(), horizon, step, [&](auto& x, double t, double h) {
    const auto velocity = [&](double at) { return model.w(at); };
    long calls = 0;
    const auto w = counted_calls(velocity, calls);
    const double off = std::sqrt(3.0) / 6 * h, middle = t + h / 2;
    Vector3 turn;
    if (order == 4) {
      const Vector3 a = w(middle - off), b = w(middle + off);
      turn = h / 2 * (a + b) - h * off / 2 * cross(a, b);
    } else {
      turn = h * w(middle);
    }
    x = (exponential(turn) * Matrix3{x}).e;
    return calls;
  });
}

/// The frame at the horizon's times.
Known true_orientation(double pace, const Horizon& horizon, const Reference& truth) {
  std::vector<double> times = horizon.times();
  times.erase(times.begin());
  for (double& t : times) t *= pace;
  return truth.motion("02_07_orientation", {}, times);
}

}  // namespace

// ---- the quantities ---------------------------------------------------------------------------------------

Quantity angular_velocity_at(double t, const Reference& truth) {
  Quantity w = quantity("angular_velocity", "1", R"($\mathbf w$ in $x$, $y$, $z$ at $t$)",
                        truth("02_07_angular_velocity", {t}), {1e-10, "ten decimals"});
  const auto motion = [=] { return motion_of(position, t); };
  const Vector3 listed = listed_w(motion(), listed_u_dot(motion(), false));
  const bool wrong = distance(listed, w.reference.value) > w.need.allowed;
  const Resolution steps{"h", {0x1p-4, 0x1p-7, 0x1p-10, 0x1p-13, 0x1p-16, 0x1p-19, 0x1p-22, 0x1p-25}};
  w.add({"listing as printed", "closed form", no_resolution(),
         [=](double) {
           return Answer{listed_w(motion(), listed_u_dot(motion(), false)), 1};
         },
         wrong ? Outcome::inaccurate : Outcome::ok,
         R"(`UDot` is not perpendicular to $\mathbf u$, and $\dot RR^T$ not skew)"});
  w.add({"listing with A.Dot(U)", "closed form", no_resolution(), [=](double) {
           return Answer{listed_w(motion(), listed_u_dot(motion(), true)), 1};
         }});
  w.add({"along r and r x u", "closed form", no_resolution(), [=](double) {
           return Answer{angular_velocity(motion()), 1};
         }});
  w.add({"Unskew(R' R^T)", "dual numbers", no_resolution(), [=](double) {
           const Matrix<Dual<double>> R = frame(Dual<double>(t, 1));
           return Answer{unskew(slope_of(R) * transpose(value_of(R))), 1};
         }});
  w.add({"rotation from t - h to t + h", "its vector over 2h", steps,
         [=](double h) {
           long calls = 0;
           const auto at = [](double time) { return frame(time); };
           const auto counted = counted_calls(at, calls);
           const Matrix3 turned = counted(t + h) * transpose(counted(t - h));
           return Answer{0.5 / h * rotation_vector(turned), calls};
         },
         Outcome::inaccurate, "rounding grows as $1/h$ when the step $h$ is halved on"});
  if (wrong)
    w.add(Breakdown{
        "The listing multiplies `U` by `R.Dot(U)`, which is zero, where the formula above it has the "
        "acceleration's component `A.Dot(U)`.",
        "listing as printed, closed form", 0, Outcome::inaccurate, "listing with A.Dot(U), closed form", 0});
  return w;
}

Quantity orientation(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const double pace = p["pace"];
  const Resolution steps = halving("step", 0.125, 8);
  constexpr double need = 1e-8;
  Quantity q = quantity("orientation", "1", "$R$ at four times, carried on from $t=0$",
                        true_orientation(pace, horizon, truth),
                        {need, filled("@1 seconds of arc", {3600 * 180 / std::numbers::pi * need})});
  const AsMatrix<double> as_matrix{{{pace}}}, as_listed{{{pace}, true}};
  const AsQuaternion<double> as_quaternion{{{pace}}};
  SceneMethods(q, horizon, steps, tolerances())
      .closed_form("frame", Frame<double>{{pace}})
      .by_engine_integrators("matrix", as_matrix, Outcome::drifted)
      .by_engine_integrators("quaternion", as_quaternion, Outcome::drifted)
      .by_remaining_integrators(
          "quaternion", as_quaternion,
          {{"modified midpoint", Outcome::inaccurate, "its order is too low for this need at this step"},
           {"linearly implicit Euler", Outcome::drifted, "its order is 1, and the quaternion shrinks"}})
      .by<ode::RungeKutta4>("matrix, w of the printed listing", as_listed, Outcome::inaccurate,
                            "a rotation, but the wrong one");
  const auto repaired = [&]<class Algorithm>(const std::string& name, const auto& model, Outcome expected) {
    q.add({name, std::string(ode::info<Algorithm>().name), steps,
           [=](double h) { return observe_repaired<Algorithm>(model, horizon, h); }, expected,
           expected == Outcome::ok ? "" : "repaired it is a rotation, but not the right one"});
  };
  const std::string orthonormal = "matrix, orthonormalized", normal = "quaternion, normalized";
  repaired.template operator()<ode::ExplicitEuler>(orthonormal, as_matrix, Outcome::inaccurate);
  repaired.template operator()<ode::RungeKutta4>(orthonormal, as_matrix, Outcome::ok);
  repaired.template operator()<ode::ExplicitEuler>(normal, as_quaternion, Outcome::inaccurate);
  repaired.template operator()<ode::RungeKutta4>(normal, as_quaternion, Outcome::ok);
  q.add({"rotation vector", "exponential midpoint", steps,
         [=](double h) { return observe_exponentials(as_matrix, horizon, h, 2); }, Outcome::inaccurate,
         "its order is too low for this need at this step"});
  q.add({"rotation vector", "Magnus 4", steps,
         [=](double h) { return observe_exponentials(as_matrix, horizon, h, 4); }});
  return with_float(std::move(q), horizon, Given<double>{pace},
                    {"matrix, w of the printed listing", "frame", "matrix", "quaternion"});
}

Quantity orthogonality(const Quantity& orientation) {
  Quantity q{"orthogonality",
             "1",
             "$R^TR$ at $T$, whatever the orientation",
             {"the unit matrix", identity()},
             0,
             {1e-10, "ten decimals"}};
  for (const Method& method : orientation.methods) {
    if (is_other_algorithm(method.algorithm)) continue;
    Method asked = method;
    asked.run = [run = method.run](double setting) {
      Answer answer = run(setting);
      if (!answer.reached()) return answer;
      Matrix3 R;
      const std::size_t first = answer.value.size() - 9;
      for (std::size_t i = 0; i < 9; ++i) R.e[i] = answer.value[first + i];
      answer.value = transpose(R) * R;
      return answer;
    };
    if (method.expected == Outcome::inaccurate) {
      asked.expected = Outcome::ok;
      asked.why.clear();
    }
    q.add(std::move(asked));
  }
  constexpr double coarse = 0x1p-4, fine = 0x1p-10;
  q.add(
      Breakdown{"At @2 steps a unit of time $R^TR$ is off by $@1$. Gram and Schmidt's orthonormalization "
                "after each step keeps it a rotation.",
                "matrix, Runge-Kutta 4",
                coarse,
                Outcome::inaccurate,
                "matrix, orthonormalized, Runge-Kutta 4",
                coarse,
                {steps_in_one(Side::broken), error_of(Side::broken)}});
  q.add(
      Breakdown{"The quaternion loses its unit length, and $R^TR$ is off by $@1$. Normalizing it after "
                "each step costs one root.",
                "quaternion, Runge-Kutta 4",
                coarse,
                Outcome::inaccurate,
                "quaternion, normalized, Runge-Kutta 4",
                coarse,
                {error_of(Side::broken)}});
  q.add(
      Breakdown{"Euler's step along the tangent leaves the rotations outward, always: @4 steps a unit of "
                R"(time are not enough. A rotation by the vector $h\mathbf w$ stays on them at any step.)",
                "matrix, explicit Euler",
                fine,
                Outcome::drifted,
                "rotation vector, exponential midpoint",
                0.125,
                {steps_in_one(Side::broken)}});
  return q;
}

}  // namespace oddity::curve_on_sphere
