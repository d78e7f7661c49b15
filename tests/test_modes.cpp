// Normal modes in plain C++, compared with the library's.

#include "chapters/modes.hpp"
#include "chapters/random.hpp"
#include "report/verify/catch.hpp"
#include "solvers/linear.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

template <std::size_t n>
using Rows = std::array<std::array<double, n>, n>;

template <std::size_t n>
Eigen::MatrixXd as_eigen(const Rows<n>& rows) {
  Eigen::MatrixXd whole(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) whole(static_cast<int>(i), static_cast<int>(j)) = rows[i][j];
  return whole;
}

/// A symmetric matrix, diagonally dominant.
template <std::size_t n>
Rows<n> definite(Random& random) {
  Rows<n> a{};
  for (std::size_t i = 0; i < n; ++i) {
    a[i][i] += n;
    for (std::size_t j = 0; j < i; ++j) a[i][j] = a[j][i] = random.between(-1, 1);
  }
  return a;
}

template <std::size_t n>
void check(Random& random) {
  const Rows<n> K = definite<n>(random), M = definite<n>(random);
  std::array<double, n> x, v;
  for (double& one : x) one = random.between(-1, 1);
  for (double& one : v) one = random.between(-1, 1);
  const Modes all = modes(as_eigen(K), as_eigen(M));
  const NormalModes<double, n> ours(K, M, x, v);
  for (const double t : {0.0, 0.5, 3.0, 40.0}) {
    Eigen::VectorXd truth = Eigen::VectorXd::Zero(n);
    for (int k = 0; k < static_cast<int>(n); ++k) {
      const double w = std::sqrt(all.squares(k));
      const Eigen::VectorXd to_mode = as_eigen(M) * all.shapes.col(k);
      const double cosine = to_mode.dot(Eigen::Map<const Eigen::VectorXd>(x.data(), n)),
                   sine = to_mode.dot(Eigen::Map<const Eigen::VectorXd>(v.data(), n)) / w;
      truth += (cosine * std::cos(w * t) + sine * std::sin(w * t)) * all.shapes.col(k);
    }
    for (std::size_t i = 0; i < n; ++i) CHECK(near(ours.at(t)[i], truth(static_cast<int>(i)), 1e-12));
  }
}

}  // namespace

TEST_CASE("normal modes in plain C++ agree with the library's", "[modes]") {
  Random random(1);
  for (int i = 0; i < 50; ++i) check<1>(random), check<2>(random), check<3>(random), check<5>(random);
}

TEST_CASE("modes of diagonal matrices, and of a double frequency", "[modes]") {
  const NormalModes<double, 2> apart({{{4, 0}, {0, 9}}}, {{{1, 0}, {0, 1}}}, {1, 2}, {2, 3});
  CHECK(near(apart.at(0.5)[0], std::cos(1.0) + std::sin(1.0), 1e-14));
  CHECK(near(apart.at(0.5)[1], 2 * std::cos(1.5) + std::sin(1.5), 1e-14));
  const NormalModes<double, 2> twice({{{2, 1}, {1, 2}}}, {{{2, 1}, {1, 2}}}, {1, 2}, {0, 0});
  CHECK(near(twice.at(0.5)[0], std::cos(0.5), 1e-14));
  CHECK(near(twice.at(0.5)[1], 2 * std::cos(0.5), 1e-14));
}
