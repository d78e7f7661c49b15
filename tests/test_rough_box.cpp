#include <algorithm>
#include <cmath>

#include "chapters/03_rigid_body_motion/31_rough_box/models.hpp"
#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/quadrature.hpp"
#include "tests/near.hpp"

using namespace oddity;
using namespace oddity::rough_box;

namespace {

/// The mean of v/|v| and of its moment by nested quadrature, with the foot cut at the instantaneous centre.
std::array<double, 3> by_quadrature(const Contact<double>& foot, double u, double v, double w) {
  const double cx = std::clamp(-v / w, -foot.a, foot.a), cy = std::clamp(u / w, -foot.b, foot.b);
  const Rule rule = [](FunctionOfOne f, double from, double to) {
    return from == to ? Integral{} : qags(f, from, to, 1e-9);
  };
  std::array<double, 3> mean{};
  for (std::size_t component = 0; component < 3; ++component) {
    const auto f = [&](double x, double y) {
      const double vx = u - w * y, vy = v + w * x, speed = std::hypot(vx, vy);
      const double moment = x * vy - y * vx;
      return speed == 0 ? 0 : (component == 0 ? vx : component == 1 ? vy : moment) / speed;
    };
    for (const auto& [x1, x2] : {std::pair(-foot.a, cx), std::pair(cx, foot.a)})
      for (const auto& [y1, y2] : {std::pair(-foot.b, cy), std::pair(cy, foot.b)}) {
        const double low = y1, high = y2;
        const auto part = nested(
            rule, f, x1, x2, [=](double) { return low; }, [=](double) { return high; });
        mean[component] += part.value / (4 * foot.a * foot.b);
      }
  }
  return mean;
}

}  // namespace

TEST_CASE("friction over the foot in closed form agrees with the integral over its points", "[rough box]") {
  Random random(31);
  for (int i = 0; i < 12; ++i) {
    const Contact<double> foot{random.between(0.2, 1), random.between(0.2, 1)};
    const double w = random.magnitude(0.5, 5), u = random.between(-2, 2), v = random.between(-2, 2);
    const auto closed = foot.means(u, v, w), summed = by_quadrature(foot, u, v, w);
    for (std::size_t k = 0; k < 3; ++k) CHECK(near(closed[k], summed[k], 1e-8));
  }
}

TEST_CASE("pure sliding and pure spinning end at the times and places of uniform deceleration",
          "[rough box]") {
  for (const auto& [u, w] : {std::pair(2.0, 0.0), std::pair(0.0, 10.0)}) {
    const Given<double> box{{0.3, 0.2}, 0.3, 9.81, u, 0, w};
    const Stretched<double> model{box};
    const auto [x, y, theta, vx, vy, spin, time] =
        ode::integrate<ode::Fehlberg78>(model, model.start(), 0, model.end(), 1e-12).value;
    const double slowing = 0.3 * 9.81,
                 spin_slowing = slowing / box.J() * std::abs(by_quadrature(box.foot, 0, 0, 1)[2]);
    CHECK(near(time, u / slowing + w / spin_slowing, 1e-7));
    CHECK(near(x, u * u / (2 * slowing), 1e-7));
    CHECK(near(theta, w * w / (2 * spin_slowing), 1e-6));
  }
}

TEST_CASE("the truth of a box that hardly turns is known as well as that of one that does", "[rough box]") {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const std::vector<double> times{0.2, 0.4, 0.6};
  const Known known = truth.motion("03_31_slide", {0.1, 0.1, 0.3, 9.81, 2, 0.05, 0.05}, times);
  CHECK(known.error < 1e-12);
  CHECK(near(known.value[0], 2 * 0.2 - 0.3 * 9.81 * 0.2 * 0.2 / 2, 1e-3));  // as it would slide alone
}
