// The quantities of exercise 2.3: the motion by several routes, the colatitude and the helix's ends.

#include "chapters/02_basic_concepts/03_spherical_helix/spherical_helix.hpp"
#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/counted_calls.hpp"

namespace oddity::spherical_helix {

namespace {

using std::sqrt, std::pow, std::numbers::pi, limits::joined, limits::limit_at_zero;

/// v and a by the text's formulas; `corrected`: with the right components along Q.
Answer by_the_text(double t, bool corrected) {
  const double d = 1 + t * t;
  return {{1 / sqrt(d), corrected ? 1 / d : -1 / d, 0, -2 * t / pow(d, 1.5),
           corrected ? t * (t * t - 1) / (d * d) : -t / d, -(2 + t * t) / (d * d)},
          1};
}
/// v and a from positions at distances h and 2h: differences of order 2 or 4.
Answer by_differences(double t, double h, int order) {
  const auto second = [&](double s) { return (helix(t + s) - 2.0 * helix(t) + helix(t - s)) / (s * s); };
  const auto first = [&](double s) { return (helix(t + s) - helix(t - s)) / (2 * s); };
  const auto mixed = [&](auto f) { return order == 2 ? f(h) : (4.0 * f(h) - f(2 * h)) / 3.0; };
  const Vector3 r = helix(t);
  return {joined(in_frame(r, mixed(first)), in_frame(r, mixed(second))), order + 1};
}

/// Distance from the axis and height at t = +1/s and -1/s.
Answer ends(double s, bool hypot) {
  const auto point = [&](double t) {
    const double root = hypot ? std::hypot(1, t) : sqrt(1 + t * t);
    return Value{1 / root, t / root};
  };
  Answer both;
  const auto at = counted_calls(point, both.evaluations);
  both.value = joined(at(1 / s), at(-1 / s));
  return both;
}

}  // namespace

Quantity motion(double t, const Reference& truth) {
  Known known = truth("02_03_motion", {t});
  known.value.erase(known.value.begin());
  Quantity q =
      quantity("motion", "1", R"(velocity and acceleration along $\mathbf P$, $\mathbf Q$, $\mathbf R$)",
               known, {1e-10, "ten decimals"});
  const std::string too_small = "halving on, rounding takes over: it grows as $1/h^2$";
  const Resolution steps = halving("h", 0x1p-4, 12);
  q.add({"components as printed", "closed form", no_resolution(),
         [=](double) { return by_the_text(t, false); }, Outcome::inaccurate,
         R"(along $\mathbf Q$ the velocity has the wrong sign, and the acceleration lacks a square)"});
  q.add({"components, corrected", "closed form", no_resolution(),
         [=](double) { return by_the_text(t, true); }});
  q.add({"spherical angles", "dual numbers", no_resolution(), [=](double) {
           const Vector3 phi = At(t).phi;
           const double s = std::sin(phi[0]), c = std::cos(phi[0]), w = phi[1];
           return Answer{{s, -w, 0, 2 * w * c, s * c - phi[2], -w * w - s * s}, 1};
         }});
  q.add({"Cartesian", "dual numbers", no_resolution(), [=](double) {
           const auto m = space::motion_of(helix, t);
           return Answer{joined(in_frame(m.r, m.v), in_frame(m.r, m.a)), 1};
         }});
  for (int order : {2, 4})
    q.add({"Cartesian", "differences of order " + std::to_string(order), steps,
           [=](double h) { return by_differences(t, h, order); }, Outcome::inaccurate, too_small});
  constexpr double finest = 0x1p-15;
  q.add(
      Breakdown{R"(A difference of step $2^{@2}$ carries rounding errors of $4\epsilon/h^2\approx@1$. Dual )"
                "numbers have no step.",
                "Cartesian, differences of order 4",
                finest,
                Outcome::inaccurate,
                "Cartesian, dual numbers",
                0,
                {power_of_two_of(Side::broken), 4 * 0x1p-52 / (finest * finest)}});
  return q;
}

Quantity colatitude(const std::string& name, double t, const Reference& truth) {
  Known known = truth("02_03_motion", {t});
  known.value.resize(1);
  Quantity q = quantity(name, "rad", R"(the angle $\phi$ from the pole, $t$ = )" + format_shortest(t), known,
                        {1e-12 * known.value[0], "twelve digits"});
  const bool north = t > 1e4, south = t < -1e4;
  q.add({"t/sqrt(1 + t^2)", "acos", no_resolution(),
         [=](double) {
           return Answer{std::acos(t / sqrt(1 + t * t)), 1};
         },
         north || south ? Outcome::inaccurate : Outcome::ok, "the cosine rounds to 1 near a pole"});
  q.add({"1/sqrt(1 + t^2)", "asin", no_resolution(),
         [=](double) {
           return Answer{std::asin(1 / sqrt(1 + t * t)), 1};
         },
         t < 0 ? Outcome::inaccurate : Outcome::ok, "the sine is the same north and south"});
  q.add({"latitude", "pi/2 - atan", no_resolution(),
         [=](double) {
           return Answer{pi / 2 - std::atan(t), 1};
         },
         north ? Outcome::inaccurate : Outcome::ok, "two right angles cancel"});
  q.add({"(1, t)", "atan2", no_resolution(), [=](double) { return Answer{std::atan2(1, t), 1}; }});
  if (north || south)
    q.add(
        Breakdown{R"(At $|t|=@1$ the cosine $t/\sqrt{1+t^2}$ rounds to $\pm1$, and the arc cosine puts the )"
                  "point on the pole. Both coordinates of the meridian together, `atan2(1, t)`, keep every "
                  "digit.",
                  "t/sqrt(1 + t^2), acos",
                  0,
                  Outcome::inaccurate,
                  "(1, t), atan2",
                  0,
                  {std::abs(t)}});
  return q;
}

Quantity limits_at_infinity() {
  Quantity q{"limits_at_infinity",
             "1",
             R"(distance from the axis and height as $t\to\infty$, then as $t\to-\infty$)",
             {"closed form: the poles", {0, 1, 0, -1}},
             0,
             {1e-10, "ten decimals"}};
  const Resolution times{"t", {1e2, 1e4, 1e8, 1e12, 1e200}};
  q.add({"sqrt(1 + t^2)", "value at t", times, [](double t) { return ends(1 / t, false); },
         Outcome::inaccurate, "$t^2$ overflows and the height becomes 0"});
  q.add({"hypot(1, t)", "value at t", times, [](double t) { return ends(1 / t, true); }});
  q.add({"sqrt(1 + t^2)", "Richardson in 1/t", Resolution{"halvings", {2, 4, 6, 8, 10}}, [](double n) {
           return limit_at_zero([](double s) { return ends(s, false).value; }, 0.5, static_cast<int>(n));
         }});
  q.add(Breakdown{
      R"(From $|t|\approx@2$ on $t^2$ is infinite and the helix falls to the sphere's center. hypot )"
      "scales.",
      "sqrt(1 + t^2), value at t",
      1e200,
      Outcome::inaccurate,
      "hypot(1, t), value at t",
      1e200,
      {std::sqrt(std::numeric_limits<double>::max())}});
  return q;
}

}  // namespace oddity::spherical_helix
