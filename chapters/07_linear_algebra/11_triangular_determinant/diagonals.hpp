#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "solvers/linear.hpp"

/// Products of many numbers that leave the range of a double on the way, and ways to keep them in it.
namespace oddity::diagonals {

/// s_k m_k 2^e in the first half, s_k m_k 2^f in the second; m_k from 1 to 2, s_k = -1 for every third k.
inline std::vector<double> diagonal(int n, int e, int f) {
  std::vector<double> u;
  for (int k = 1; k <= n; ++k)
    u.push_back(std::ldexp((k % 3 == 0 ? -1 : 1) * (64 + 37 * k % 64) / 64.0, 2 * k <= n ? e : f));
  return u;
}

inline double product(const std::vector<double>& u) {
  double all = 1;
  for (double x : u) all *= x;
  return all;
}

/// A number as mantissa and power of two, so that no product leaves the range.
struct Scaled {
  double mantissa = 1;
  long exponent = 0;
};

inline Scaled scaled_product(const std::vector<double>& u) {
  Scaled all;
  for (double x : u) {
    int of_factor = 0, of_product = 0;
    all.mantissa = std::frexp(all.mantissa * std::frexp(x, &of_factor), &of_product);
    all.exponent += of_factor + of_product;
  }
  return all;
}

inline double sum_of_logarithms(const std::vector<double>& u) {
  double sum = 0;
  for (double x : u) sum += std::log(std::abs(x));
  return sum;
}

inline double sign_of(const std::vector<double>& u) {
  return std::ranges::count_if(u, [](double x) { return x < 0; }) % 2 == 0 ? 1 : -1;
}

/// The largest with the smallest, the second largest with the second smallest, ...
inline std::vector<double> paired(std::vector<double> u) {
  std::ranges::sort(u, {}, [](double x) { return std::abs(x); });
  std::vector<double> all;
  for (std::size_t i = 0, j = u.size(); i < j;) {
    all.push_back(u[--j]);
    if (i < j) all.push_back(u[i++]);
  }
  return all;
}

inline Answer finite_answer(double x, long work) {
  if (std::isfinite(x)) return {x, work};
  return {x,
          work,
          std::numeric_limits<double>::quiet_NaN(),
          0,
          Ending::non_finite,
          "out of the range of a double"};
}

inline Quantity determinant_of(int n, int e, const Reference& truth) {
  const std::vector<double> u = diagonal(n, e, -e), last_first(u.rbegin(), u.rend());
  const Known known = truth("07_11_determinant", {double(n), double(e)});
  Quantity q = quantity("determinant", "",
                        "determinant of a triangular matrix, the large entries of its diagonal first", known,
                        {1e-12 * std::abs(known.value[0]), "twelve digits"});
  q.add({"product", "as printed, the last first", no_knob(),
         [=](double) { return finite_answer(product(last_first), n); }, Outcome::inaccurate,
         "the small entries underflow to zero before the large ones come"});
  q.add({"product", "the first first", no_knob(), [=](double) { return finite_answer(product(u), n); },
         Outcome::non_finite, "the large entries overflow before the small ones come"});
  q.add(
      {"product", "large by small", no_knob(), [=](double) { return finite_answer(product(paired(u)), n); }});
  q.add({"mantissas and exponents", "the first first", no_knob(), [=](double) {
           const Scaled s = scaled_product(u);
           return finite_answer(std::ldexp(s.mantissa, static_cast<int>(s.exponent)), n);
         }});
  q.add({"logarithms", "exponential of the sum", no_knob(),
         [=](double) { return finite_answer(sign_of(u) * std::exp(sum_of_logarithms(u)), n + 1); }});
  q.add(
      Breakdown{"The determinant is a moderate number, but not the products on the way to it: in the printed "
                "order they fall below 2^-1074.",
                "product, as printed, the last first", 0, Outcome::inaccurate,
                "mantissas and exponents, the first first", 0});
  q.add(Breakdown{"In the other order they rise above 2^1024.", "product, the first first", 0,
                  Outcome::non_finite, "logarithms, exponential of the sum", 0});
  return q;
}

/// The diagonal under random entries, as a full matrix.
inline Eigen::MatrixXd triangular(const std::vector<double>& u, Random random) {
  const auto n = static_cast<Eigen::Index>(u.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index c = r; c < n; ++c)
      m(r, c) = r == c ? u[static_cast<std::size_t>(r)] : random.between(-1, 1);
  return m;
}

inline Quantity log_determinant(int n, int e, const Reference& truth, const Random& random) {
  const std::vector<double> u = diagonal(n, e, e), last_first(u.rbegin(), u.rend());
  const Eigen::MatrixXd m = triangular(u, random);
  const Known known = truth("07_11_log_determinant", {double(n), double(e)});
  Quantity q = quantity("log_determinant", "", "log |det U| with large entries all along the diagonal", known,
                        {1e-12 * known.value[0], "twelve digits"});
  const std::string overflows = "the determinant itself is out of the range of a double";
  q.add({"logarithm of the product", "as printed, the last first", no_knob(),
         [=](double) { return finite_answer(std::log(std::abs(product(last_first))), n + 1); },
         Outcome::non_finite, overflows});
  q.add({"logarithm of the product", "LU, rows exchanged", no_knob(),
         [=](double) {
           Solved<double> solved = determinant(m);
           solved.value = std::log(std::abs(solved.value));
           return answer(solved);
         },
         Outcome::non_finite, overflows});
  q.add({"logarithms", "sum", no_knob(), [=](double) { return finite_answer(sum_of_logarithms(u), n); }});
  q.add({"mantissas and exponents", "logarithm of the mantissa", no_knob(), [=](double) {
           const Scaled s = scaled_product(u);
           return finite_answer(
               std::log(std::abs(s.mantissa)) + static_cast<double>(s.exponent) * std::numbers::ln2, n + 2);
         }});
  q.add(Breakdown{
      "No order of the product helps against a determinant of 10^729. Its logarithm is a sum, and needs no "
      "determinant.",
      "logarithm of the product, LU, rows exchanged", 0, Outcome::non_finite, "logarithms, sum", 0});
  return q;
}

}  // namespace oddity::diagonals
