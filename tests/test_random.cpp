// The random samples of chapters/random.hpp: the same on every machine, in their ranges, with their moments.

#include "chapters/random.hpp"

#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

constexpr int many = 100'000;

/// Mean and variance of `many` samples.
template <class Draw>
std::array<double, 2> moments(const Draw& draw) {
  double sum = 0, squares = 0;
  for (int i = 0; i < many; ++i) {
    const double x = draw();
    sum += x, squares += x * x;
  }
  const double mean = sum / many;
  return {mean, squares / many - mean * mean};
}

}  // namespace

TEST_CASE("the first samples are those of SplitMix64", "[solvers]") {
  Random zero(0);
  CHECK(zero.bits() == 0xe220a8397b1dcdafu);
  CHECK(zero.bits() == 0x6e789e6aa1b965f4u);
  CHECK(zero.bits() == 0x06c45d188009454fu);
  Random other(1234567);
  CHECK(other.bits() == 6457827717110365317u);
  CHECK(other.bits() == 3203168211198807973u);
}

TEST_CASE("the first numbers of a seed are fixed", "[solvers]") {
  Random random(1);
  CHECK(random.unit() == 0x1.22145bd91204bp-1);
  CHECK(random.below(1000) == 745);
  CHECK(random.between(-3, 5) == 0x1.312745ddf664ap+2);
  // These pass through the platform's exp, log and cos.
  CHECK(near_ulps(random.normal(), -1.0182986524741382, 8));
  CHECK(near_ulps(random.magnitude(1e-3, 1e3), 37.78908283744275, 8));
  const auto [x, y, z] = random.direction();
  CHECK(near_ulps(x, -0.2210257169629562, 8));
  CHECK(near_ulps(z, 0.04613435970196278, 8));
  CHECK(near(x * x + y * y + z * z, 1, 1e-15));
}

TEST_CASE("samples stay in their ranges", "[solvers]") {
  Random random(7);
  std::array<int, 6> faces{};
  for (int i = 0; i < many; ++i) {
    const double unit = random.unit(), size = random.magnitude(1e-3, 1e3);
    if (!(unit >= 0 && unit < 1)) FAIL("unit: " << unit);
    if (!(std::abs(size) >= 0.999e-3 && std::abs(size) <= 1.001e3)) FAIL("magnitude: " << size);
    for (double x : random.point(2))
      if (!(std::abs(x) <= 2)) FAIL("point: " << x);
    const auto [x, y, z] = random.direction();
    if (!(std::abs(x * x + y * y + z * z - 1) < 1e-14)) FAIL("direction: " << x << " " << y << " " << z);
    ++faces.at(static_cast<std::size_t>(random.below(6)));
  }
  for (int count : faces) CHECK(within(count, many / 6.0 - 600, many / 6.0 + 600));
}

TEST_CASE("samples have the mean and the variance of their distribution", "[solvers]") {
  Random random(3);
  const auto [unit_mean, unit_variance] = moments([&] { return random.unit(); });
  CHECK(near(unit_mean, 1.0 / 2, 0.004));
  CHECK(near(unit_variance, 1.0 / 12, 0.001));
  const auto [normal_mean, normal_variance] = moments([&] { return random.normal(); });
  CHECK(near(normal_mean, 0, 0.013));
  CHECK(near(normal_variance, 1, 0.018));
  const auto [size_mean, size_variance] =
      moments([&] { return std::log(std::abs(random.magnitude(0.1, 10))); });
  CHECK(near(size_mean, 0, 0.017));
  CHECK(near(size_variance, std::pow(std::log(100.0), 2) / 12, 0.02));
  const auto [sign, square] = moments([&] { return random.magnitude(1, 1); });
  CHECK(near(sign, 0, 0.013));
  CHECK(near(square, 1, 0.001));
}

TEST_CASE("directions favour no axis", "[solvers]") {
  Random random(5);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [mean, variance] = moments([&] { return random.direction()[axis]; });
    CHECK(near(mean, 0, 0.008));
    CHECK(near(variance, 1.0 / 3, 0.004));
  }
}
