#include <algorithm>
#include <cmath>

#include "chapters/03_rigid_body_motion/25_chain/chain.hpp"
#include "chapters/03_rigid_body_motion/25_chain/links.hpp"
#include "report/study/fit.hpp"
#include "report/verify/catch.hpp"
#include "solvers/counted.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

long most_bytes = 0, bytes = 0;

/// Allocator that counts the bytes in use.
template <class T>
struct Counting {
  using value_type = T;
  Counting() = default;
  template <class U>
  explicit Counting(const Counting<U>&) {}
  T* allocate(std::size_t n) {
    most_bytes = std::max(most_bytes, bytes += static_cast<long>(n * sizeof(T)));
    return std::allocator<T>().allocate(n);
  }
  void deallocate(T* at, std::size_t n) {
    bytes -= static_cast<long>(n * sizeof(T));
    std::allocator<T>().deallocate(at, n);
  }
  bool operator==(const Counting&) const = default;
};

/// Operations of the accelerations of n links, by the tensions or by the dense matrix filled in and
/// eliminated, and the largest number of bytes in use.
struct Work {
  double operations, bytes;
};

Work by_tensions_of(int n) {
  using Number = Counted<double>;
  using Numbers = std::vector<Number, Counting<Number>>;
  const ex03_25::Pattern p(n);
  const auto counted = [](const std::vector<double>& x) { return Numbers(x.begin(), x.end()); };
  bytes = most_bytes = 0;
  const Numbers m = counted(p.m), r = counted(p.r), theta = counted(p.theta), omega = counted(p.omega);
  Numbers alpha = theta;
  const Operations all = operations_of([&] {
    chain::by_tensions(m, r, 9.81, theta, omega, alpha);
    return alpha[0];
  });
  return {static_cast<double>(all.additions + all.all_but_additions()), static_cast<double>(most_bytes)};
}

template <std::size_t n>
Work by_mass_matrix_of() {
  using Number = Counted<double>;
  using Numbers = std::array<Number, n>;
  const ex03_25::Pattern p(n);
  const auto counted = [](const std::vector<double>& x) {
    Numbers all;
    std::ranges::copy(x, all.begin());
    return all;
  };
  Numbers alpha{};
  const Operations all = operations_of([&] {
    chain::by_mass_matrix(counted(ex03_25::mass_from_here_on(p.m)), counted(p.r), Number(9.81),
                          counted(p.theta), counted(p.omega), alpha);
    return alpha[0];
  });
  return {static_cast<double>(all.additions + all.all_but_additions()),
          static_cast<double>(n * (n + 1) * sizeof(double))};
}

}  // namespace

TEST_CASE("the work and the memory of a chain of up to 10,000 links are proportional to their number",
          "[chain]") {
  std::vector<double> links, operations, held;
  for (int n : {10, 30, 100, 300, 1000, 3000, 10'000}) {
    const Work work = by_tensions_of(n);
    links.push_back(n);
    operations.push_back(work.operations);
    held.push_back(work.bytes);
    CHECK(work.bytes == 9 * 8.0 * n);
  }
  CHECK(near(power_law(links, operations).exponent, 1, 0.05));
  CHECK(near(power_law(links, held).exponent, 1, 0.001));

  const std::vector<double> few{16, 32, 64};
  const std::vector<double> dense{by_mass_matrix_of<16>().operations, by_mass_matrix_of<32>().operations,
                                  by_mass_matrix_of<64>().operations};
  CHECK(within(power_law(few, dense).exponent, 2.2, 3));
  CHECK(by_mass_matrix_of<16>().operations > 5 * by_tensions_of(16).operations);
}

TEST_CASE("a chain has the same motion by its tensions and by the dense matrix", "[chain]") {
  const ex03_25::Pattern p(24);
  std::array<double, 24> mu{}, r{}, theta{}, omega{}, dense{};
  std::ranges::copy(ex03_25::mass_from_here_on(p.m), mu.begin());
  std::ranges::copy(p.r, r.begin());
  std::ranges::copy(p.theta, theta.begin());
  std::ranges::copy(p.omega, omega.begin());
  std::vector<double> alpha(24);
  chain::by_tensions(p.m, p.r, 9.81, p.theta, p.omega, alpha);
  chain::by_mass_matrix(mu, r, 9.81, theta, omega, dense);
  for (std::size_t k = 0; k < 24; ++k) CHECK(near(alpha[k], dense[k], 1e-10 * std::abs(dense[k]) + 1e-10));
}

TEST_CASE("the zeros of Laguerre's polynomials are the squares of a chain's frequencies", "[chain]") {
  CHECK(near(chain::largest_laguerre_zero(1), 1, 1e-12));
  CHECK(near(chain::largest_laguerre_zero(2), 2 + std::sqrt(2.0), 1e-12));
  CHECK(near(chain::largest_laguerre_zero(3), 6.2899450829374794, 1e-12));
  // (sqrt(4 n + 2) - 2^(-1/3) 2.33810741 (4 n + 2)^(-1/6))^2, the zero of Airy's function
  for (int n : {100, 1000, 10'000}) {
    const double v = 4.0 * n + 2;
    const double root = std::sqrt(v) - std::cbrt(0.5) * 2.338107410459767 * std::pow(v, -1.0 / 6);
    CHECK(near(chain::largest_laguerre_zero(n) / (root * root), 1, 2 / v));
  }
}

TEST_CASE("a chain's largest stable step falls with the root of the number of links, as in theory",
          "[chain]") {
  constexpr double g = 9.81, r = 0.25;
  for (int n : {1, 2, 3, 10, 30, 100, 300}) {
    INFO(n << " links");
    const double step = chain::stable_step_of_links(n, g, r);
    CHECK(chain::growth_of_links(n, g, r, 0.99 * step, 1000) < 2);
    CHECK(chain::growth_of_links(n, g, r, 1.01 * step, 1000) > 1e3);
  }
  CHECK(near(chain::stable_step_of_links(10'000, g, r) / std::sqrt(2 * r / (10'000 * g)), 1, 0.005));
}

TEST_CASE("a chain's accelerations cost the same for each link after the first", "[chain]") {
  const auto cost = [](int n) {
    const ex03_25::Pattern p(n);
    const auto counted = [](const std::vector<double>& x) {
      return std::vector<Counted<double>>(x.begin(), x.end());
    };
    auto alpha = counted(p.theta);
    return operations_of([&] {
      chain::by_tensions(counted(p.m), counted(p.r), 9.81, counted(p.theta), counted(p.omega), alpha);
      return alpha[0];
    });
  };
  const Operations ten = cost(10), eleven = cost(11);
  CHECK(eleven.multiplications - ten.multiplications == 9);
  CHECK(eleven.divisions - ten.divisions == 4);
  CHECK(eleven.functions - ten.functions == 2);
}
