// Exercise 5.9: curl grad phi = 0.
// Left side: the curl of the gradient by nested dual numbers along a randomly rotated frame. Right side: the
// published components. Each printed second derivative is compared with the slope of the gradient along the
// rotated frame, and the pattern of indices with the curl of any field. The condition that the solution
// states is tried on Peano's function.

#include "chapters/05_fluids_and_gases/09_curl_of_gradient/curl_of_gradient.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "solvers/counted_calls.hpp"

namespace oddity {

namespace ex05_09 {

using namespace fields;

Quantity mixed_derivatives(const At& at, const Known& six) {
  const auto phi = at.phi();
  const Point x = at.x;
  const Value truth{six.value[0], six.value[2], six.value[4]};
  Quantity q{
      "mixed_derivatives",
      "1/m^2",
      R"($\varphi_{,12}$, $\varphi_{,20}$, $\varphi_{,01}$ at $\mathbf x$, for a field of wave number $w$)",
      {six.source, truth},
      six.error,
      nine_digits(truth),
      {},
      {}};
  const auto all = [](const auto& second_by) {
    return Value{second_by(1u, 2u), second_by(2u, 0u), second_by(0u, 1u)};
  };
  q.add({"phi", "nested dual numbers", no_resolution(), [=](double) {
           const auto second = [&](std::size_t i, std::size_t j) {
             return along(partial(phi, i), x, axes[j]);
           };
           long calls = 0;
           const auto counted = counted_calls(second, calls);
           const Value mixed = all(counted);
           return Answer{mixed, calls};
         }});
  const auto of_slopes = [=](auto way) {
    const Value value =
        all([&](std::size_t i, std::size_t j) { return way.along(partial(phi, i), x, axes[j]); });
    return Answer{value, way.calls};
  };
  const auto of_values = [=](auto way) {
    auto outer = way;
    const Value value = all([&](std::size_t i, std::size_t j) {
      return outer.along([&](const Point& y) { return way.along(phi, y, axes[i]); }, x, axes[j]);
    });
    return Answer{value, way.calls};
  };
  const std::string once = "rounding grows as $1/h$", twice = "rounding grows as $1/h^2$";
  q.add({"slopes by dual numbers", "central differences 2", steps(),
         [=](double h) { return of_slopes(ByDifferences<2>{h}); }, Outcome::inaccurate, once});
  q.add({"slopes by dual numbers", "central differences 4", steps(),
         [=](double h) { return of_slopes(ByDifferences<4>{h}); }, Outcome::inaccurate, once});
  q.add({"phi", "central differences 2", steps(25), [=](double h) { return of_values(ByDifferences<2>{h}); },
         Outcome::inaccurate,
         twice + R"(: even the best step, near $\varepsilon^{1/4}/w$, is far from a rounding)"});
  q.add({"phi", "central differences 4", steps(25), [=](double h) { return of_values(ByDifferences<4>{h}); },
         Outcome::inaccurate, twice});
  q.add(Breakdown{
      R"(Differences of differences lose $\varepsilon/h^2$: their best step is near )"
      R"($\varepsilon^{1/4}/w$ for order 2, and keeps @1 digits. With one of the two taken by dual )"
      "numbers, @2 are right.",
      "phi, central differences 2",
      step_near(best_power(4, at.waves.w)),
      Outcome::inaccurate,
      "slopes by dual numbers, central differences 2",
      step_near(best_power(3, at.waves.w)),
      {digits_of(Side::broken), digits_of(Side::cured)}});
  q.add(Breakdown{R"(Order 4 keeps @2, near $\varepsilon^{1/6}/w$, and not at a fine step.)",
                  "phi, central differences 4",
                  0x1p-25,
                  Outcome::inaccurate,
                  "phi, central differences 4",
                  step_near(best_power(6, at.waves.w)),
                  {digits_of(Side::cured)}});
  return q;
}

Quantity peano_curl() {
  Quantity q{
      "peano_curl",
      "1",
      R"(component 2 of $\nabla\times\nabla p$ at the origin, for Peano's $p$)",
      {R"($1-(-1)$: the slopes $\partial p/\partial y=x$ on the $x$ axis and $\partial p/\partial x=-y$ on )"
       R"(the $y$ axis)",
       2.0},
      0,
      {1e-9, "nine digits"},
      {},
      {}};
  q.add({"p", "nested dual numbers", no_resolution(),
         [](double) {
           long calls = 0;
           const double twist = curl(gradient(counted_calls(peano, calls)))(Point{})[2];
           return Answer{twist, calls};
         },
         Outcome::non_finite, "$p$ is $0/0$ at the origin, and dual numbers take no limits"});
  q.add({"slopes by dual numbers", "central differences 2", steps(15), [](double h) {
           ByDifferences<2> way{h};
           const double one = way.along(partial(peano, 1), Point{}, axes[0]);
           return Answer{one - way.along(partial(peano, 0), Point{}, axes[1]), way.calls};
         }});
  const auto nested = [](double h, double k) {
    ByDifferences<2> outer{h}, inner{k};
    const auto slope = [&](std::size_t j) {
      return [&inner, j](const Point& y) { return inner.along(peano, y, axes[j]); };
    };
    const double one = outer.along(slope(1), Point{}, axes[0]);
    return Answer{one - outer.along(slope(0), Point{}, axes[1]), inner.calls};
  };
  q.add({"p", "equal steps h", steps(15), [=](double h) { return nested(h, h); }, Outcome::inaccurate,
         R"($p$ is zero at all four corners $(\pm h,\pm h)$, so that the difference of differences is zero )"
         R"(for every $h$)"});
  q.add({"p", "inner step h 2^-20", steps(15), [=](double h) { return nested(h, h * 0x1p-20); }});
  q.add(Breakdown{
      "A symmetric second difference with equal steps shows a curl of zero at every step, as if the order "
      "did not matter. The iterated limit needs an inner step much finer than the outer one.",
      "p, equal steps h", 0x1p-15, Outcome::inaccurate, "p, inner step h 2^-20", 0x1p-15});
  q.add(Breakdown{
      "Dual numbers cannot pass through $0/0$ at the origin. Their slopes near it can be differenced.",
      "p, nested dual numbers", 0, Outcome::non_finite, "slopes by dual numbers, central differences 2",
      0x1p-3});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  const At at(p);
  const Known mixed = truth("05_09_mixed", at.inputs());
  return {claims(Random(p["seed"]), mixed), {mixed_derivatives(at, mixed), peano_curl()}};
}

}  // namespace ex05_09

Exercise exercise_5_9() {
  using namespace ex05_09;
  return {"Curl of a gradient",
          "Show that $\\nabla\\times\\nabla\\varphi = 0$. Below $\\varphi_{,12}$ is the derivative of "
          "$\\varphi$ by $x_1$, then by $x_2$.",
          field_parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
