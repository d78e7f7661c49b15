#include "solvers/linear.hpp"

#include "chapters/random.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;
using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr Factorization all[] = {Factorization::partial_pivot_lu, Factorization::full_pivot_lu,
                                 Factorization::householder_qr, Factorization::cholesky};

MatrixXd matrix(int columns, std::initializer_list<double> by_rows) {
  MatrixXd a(static_cast<long>(by_rows.size()) / columns, columns);
  long i = 0;
  for (double x : by_rows) a(i / columns, i % columns) = x, ++i;
  return a;
}

MatrixXd random_matrix(int rows, int columns, double seed) {
  Random random(seed);
  MatrixXd a(rows, columns);
  for (double& x : a.reshaped()) x = random.between(-1, 1);
  return a;
}

MatrixXd hilbert(int n) {
  MatrixXd a(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = 1.0 / (i + j + 1);
  return a;
}

double distance(const VectorXd& a, const VectorXd& b) { return (a - b).cwiseAbs().maxCoeff(); }

}  // namespace

TEST_CASE("every factorization solves a system with a known solution", "[solvers]") {
  for (int n : {1, 2, 3, 5, 10, 20}) {
    const MatrixXd square = random_matrix(n, n, 1);
    const MatrixXd definite = square * square.transpose() + MatrixXd::Identity(n, n);
    const VectorXd x = random_matrix(n, 1, 2);
    for (Factorization how : all) {
      const MatrixXd& a = how == Factorization::cholesky ? definite : square;
      INFO("factorization " << static_cast<int>(how) << ", n = " << n);
      const auto solved = solve(how, a, a * x);
      CHECK(solved.reached());
      CHECK(distance(solved.value, x) <= 1e-15 * n * condition(a));
    }
  }
}

TEST_CASE("pivoting solves a matrix whose first pivot is zero", "[solvers]") {
  const MatrixXd a = matrix(2, {0, 1, 1, 0});
  const VectorXd b = VectorXd::LinSpaced(2, 3, 4);
  for (Factorization how :
       {Factorization::partial_pivot_lu, Factorization::full_pivot_lu, Factorization::householder_qr})
    CHECK(distance(solve(how, a, b).value, VectorXd::LinSpaced(2, 4, 3)) < 1e-15);
  CHECK(solve(Factorization::cholesky, a, b).ending == Ending::raised);
}

TEST_CASE("QR of a tall matrix is least squares: the line through three points", "[solvers]") {
  const MatrixXd a = matrix(2, {1, 0, 1, 1, 1, 2});
  VectorXd b(3);
  b << 1, -2, 3;
  const auto line = solve(Factorization::householder_qr, a, b);
  CHECK(line.reached());
  CHECK(near(line.value(0), -1.0 / 3, 4e-15));
  CHECK(near(line.value(1), 1, 4e-15));
}

TEST_CASE("a pivot of zero raises", "[solvers]") {
  const VectorXd b = VectorXd::Ones(2);
  for (Factorization how : all) {
    INFO("factorization " << static_cast<int>(how));
    CHECK(solve(how, MatrixXd::Zero(2, 2), b).ending == Ending::raised);
    if (how != Factorization::householder_qr)
      CHECK(solve(how, matrix(2, {1, 2, 2, 4}), b).ending == Ending::raised);
  }
}

TEST_CASE("only full pivoting detects a singular matrix whose pivots are nonzero by rounding", "[solvers]") {
  const MatrixXd a = matrix(3, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  const VectorXd b = a * VectorXd::Ones(3);
  CHECK(solve(Factorization::full_pivot_lu, a, b).ending == Ending::raised);
  CHECK(solve(Factorization::partial_pivot_lu, a, b).reached());
  CHECK(solve(Factorization::householder_qr, a, b).reached());
  CHECK(rank(a) == 2);
  CHECK(condition(a) > 1e15);
}

TEST_CASE("Cholesky refuses a matrix that is not symmetric and positive definite", "[solvers]") {
  const VectorXd b = VectorXd::Ones(2);
  CHECK(solve(Factorization::cholesky, matrix(2, {2, 1, 1, 2}), b).reached());
  CHECK(solve(Factorization::cholesky, matrix(2, {2, 1, 0, 2}), b).ending == Ending::raised);
  CHECK(solve(Factorization::cholesky, matrix(2, {1, 2, 2, 1}), b).ending == Ending::raised);
  CHECK(solve(Factorization::cholesky, matrix(2, {-1, 0, 0, -1}), b).ending == Ending::raised);
}

TEST_CASE("shapes that do not fit raise", "[solvers]") {
  for (Factorization how : all) {
    INFO("factorization " << static_cast<int>(how));
    CHECK(solve(how, MatrixXd::Identity(2, 2), VectorXd::Ones(3)).ending == Ending::raised);
    CHECK(solve(how, MatrixXd::Ones(2, 3), VectorXd::Ones(2)).ending == Ending::raised);
    CHECK(solve(how, MatrixXd(0, 0), VectorXd(0)).ending == Ending::raised);
    if (how != Factorization::householder_qr)
      CHECK(solve(how, matrix(2, {1, 0, 1, 1, 1, 2}), VectorXd::Ones(3)).ending == Ending::raised);
  }
  CHECK(determinant(MatrixXd::Ones(2, 3)).ending == Ending::raised);
  CHECK(determinant(MatrixXd(0, 0)).ending == Ending::raised);
}

TEST_CASE("NaN and infinity end non_finite", "[solvers]") {
  for (double bad : {no_number, infinity}) {
    const MatrixXd a = matrix(2, {bad, 1, 1, 1});
    VectorXd b = VectorXd::Ones(2);
    for (Factorization how : all) {
      CHECK(solve(how, a, b).ending == Ending::non_finite);
      CHECK(solve(how, a, b).message == "the matrix or the right-hand side is not finite");
    }
    b(1) = bad;
    for (Factorization how : all) CHECK(solve(how, MatrixXd::Identity(2, 2), b).ending == Ending::non_finite);
    CHECK(determinant(a).ending == Ending::non_finite);
    CHECK(determinant(a).message == "the matrix is not finite");
    CHECK(std::isnan(condition(a)));
    CHECK(rank(a) == 0);
  }
  CHECK(solve(Factorization::partial_pivot_lu, 1e-300 * MatrixXd::Identity(2, 2), 1e300 * VectorXd::Ones(2))
            .ending == Ending::non_finite);
}

TEST_CASE("the counted work is the published number of multiplications", "[solvers]") {
  const MatrixXd a = MatrixXd::Identity(6, 6);
  const VectorXd b = VectorXd::Ones(6);
  CHECK(solve(Factorization::partial_pivot_lu, a, b).evaluations == 6 * 35 / 3 + 36);
  CHECK(solve(Factorization::full_pivot_lu, a, b).evaluations == 6 * 35 / 3 + 36);
  CHECK(solve(Factorization::householder_qr, a, b).evaluations == 30 + 24 + (2 * 91 - 21) + 21);
  CHECK(solve(Factorization::cholesky, a, b).evaluations == 15 + 35 + 15 + 36);
  CHECK(determinant(a).evaluations == 6 * 35 / 3 + 5);
  CHECK(solve(Factorization::partial_pivot_lu, MatrixXd::Identity(1, 1), VectorXd::Ones(1)).evaluations == 1);
}

TEST_CASE("determinants of whole numbers", "[solvers]") {
  CHECK(near(determinant(matrix(1, {7})).value, 7, 0));
  CHECK(near(determinant(matrix(2, {3, 8, 4, 6})).value, -14, 1e-14));
  CHECK(near(determinant(matrix(3, {6, 1, 1, 4, -2, 5, 2, 8, 7})).value, -306, 1e-12));
  CHECK(near(determinant(matrix(3, {1, 2, 3, 4, 5, 6, 7, 8, 9})).value, 0, 1e-14));
  CHECK(determinant(matrix(2, {1, 2, 2, 4})).value == 0);
  CHECK(determinant(MatrixXd::Identity(9, 9)).value == 1);
  CHECK(determinant(1e200 * MatrixXd::Identity(2, 2)).ending == Ending::non_finite);
}

TEST_CASE("the condition and the rank of Hilbert's matrices", "[solvers]") {
  // Condition numbers [Todd, NBS Appl. Math. Ser. 39, 1954].
  CHECK(near(condition(hilbert(2)), (4 + std::sqrt(13)) / (4 - std::sqrt(13)), 1e-13));
  CHECK(near(condition(hilbert(3)), 524.0568, 1e-4));
  CHECK(near(condition(hilbert(5)), 4.76607e5, 1));
  CHECK(near(condition(hilbert(8)), 1.52576e10, 1e5));
  CHECK(rank(hilbert(8)) == 8);
  CHECK(rank(hilbert(12)) == 10);
  CHECK(rank(hilbert(12), 1e-4) == 5);
  CHECK(near_ulps(determinant(hilbert(3)).value, 1.0 / 2160, 32));
}

TEST_CASE("the pseudo-inverse meets its four conditions, also without full rank", "[solvers]") {
  const auto is_near = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff() < 1e-12;
  };
  Eigen::MatrixXd tall(4, 3);
  tall << 1, 2, 3, 2, 4, 6, 1, 0, 1, 0, 5, 5;  // the third column is the sum of the others
  for (const Eigen::MatrixXd& a :
       {tall, Eigen::MatrixXd(tall.transpose()), Eigen::MatrixXd(tall.leftCols(2))}) {
    const Eigen::MatrixXd b = pseudo_inverse(a);
    CHECK(is_near(a * b * a, a));
    CHECK(is_near(b * a * b, b));
    CHECK(is_near(a * b, (a * b).transpose()));
    CHECK(is_near(b * a, (b * a).transpose()));
  }
  CHECK(pseudo_inverse(Eigen::MatrixXd::Zero(2, 3)).isZero());
}

TEST_CASE("an ill-conditioned matrix loses as many digits as its condition number has", "[solvers]") {
  for (int n : {5, 8, 10}) {
    const VectorXd x = VectorXd::Ones(n);
    for (Factorization how : all) {
      const auto solved = solve(how, hilbert(n), hilbert(n) * x);
      CHECK(solved.reached());
      CHECK(within(distance(solved.value, x) / condition(hilbert(n)), 1e-20, 1e-15));
    }
  }
}

TEST_CASE("condition and rank of matrices without a size or a scale", "[solvers]") {
  CHECK(std::isnan(condition(MatrixXd(0, 0))));
  CHECK(rank(MatrixXd(0, 0)) == 0);
  CHECK(condition(MatrixXd::Zero(2, 2)) == infinity);
  CHECK(rank(MatrixXd::Zero(2, 2)) == 0);
  CHECK(condition(1e-200 * MatrixXd::Identity(3, 3)) == 1);
  CHECK(rank(random_matrix(5, 3, 1)) == 3);
  CHECK(rank(random_matrix(3, 5, 1)) == 3);
}

TEST_CASE("modes of a system that is no oscillator raise, with NaN for all numbers", "[solvers]") {
  const MatrixXd one = MatrixXd::Identity(2, 2), indefinite = matrix(2, {1, 2, 2, 1}),
                 lopsided = matrix(2, {2, 1, 0, 2}), tall = MatrixXd::Ones(3, 2);
  const auto why = [](const Modes& m) {
    CHECK(m.ending == Ending::raised);
    CHECK(m.squares.array().isNaN().all());
    CHECK(m.shapes.array().isNaN().all());
    return m.message;
  };
  CHECK(why(modes(one, indefinite)) == "the mass matrix is not positive definite");
  CHECK(why(modes(one, MatrixXd::Zero(2, 2))) == "the mass matrix is not positive definite");
  CHECK(why(modes(lopsided, one)) == "a matrix is not symmetric");
  CHECK(why(modes(one, lopsided)) == "a matrix is not symmetric");
  CHECK(why(modes(tall, one)) == "the shapes do not fit");
  CHECK(why(modes(one, MatrixXd::Identity(3, 3))) == "the shapes do not fit");
  CHECK(why(modes(MatrixXd(), MatrixXd())) == "the shapes do not fit");
  CHECK(why(modes(one, matrix(2, {1, 0, 0, no_number}))) == "a matrix is not finite");
  CHECK(modes(one, one).ending == Ending::reached);
}

TEST_CASE("QR of a singular matrix gives no number", "[solvers]") {
  for (const MatrixXd& a : {MatrixXd(MatrixXd::Zero(2, 2)), matrix(2, {0, 1, 0, 2, 0, 3})}) {
    const auto solved = solve(Factorization::householder_qr, a, VectorXd::Ones(a.rows()));
    CHECK(solved.ending == Ending::raised);
    CHECK(solved.value.array().isNaN().all());
  }
}
