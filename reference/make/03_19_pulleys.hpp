#pragma once

#include <array>

#include "reference/truth.hpp"

/// The two pulleys of exercise 3.19; their inputs begin with m2, m3, I1, I2, R1, R2, c1, c2.
namespace oddity::truth::pulleys {

struct Matrices {
  Number m22, m23, m33;  ///< kinetic energy
  Number k22, k23, k33;  ///< energy of the springs
};

inline Matrices matrices(const std::vector<double>& in) {
  const Number turn1 = Number(in[2]) / (Number(in[4]) * in[4]),
               turn2 = Number(in[3]) / (Number(in[5]) * in[5]), c1 = in[6], c2 = in[7];
  return {in[0] + turn1 + turn2, -turn2, in[1] + turn2, c1 + 4 * c2, -2 * c2, c2};
}

/// The squares of the two angular frequencies, smaller first: det(K - s M) = 0. The smaller root comes from
/// the product, with det K = c1 c2.
inline Numbers squares(const std::vector<double>& in) {
  const Matrices a = matrices(in);
  const Number A = a.m22 * a.m33 - a.m23 * a.m23, C = Number(in[6]) * in[7],
               B = a.m22 * a.k33 + a.m33 * a.k22 - 2 * a.m23 * a.k23;
  const Number larger = (B + sqrt(Number(abs(B * B - 4 * A * C)))) / (2 * A);
  return {C / (A * larger), larger};
}

/// Newton's laws for the pulleys and the mass. The ropes have the tensions T1 and T2 on the far sides of the
/// pulleys, and the springs' pulls are F1 and F2:
///   m2 y2'' + T1 - T2 = m2 g + F2,   I1/R1^2 y2'' - T1 = -F1,
///   m3 y3'' + T2 = m3 g,             I2/R2^2 (y3'' - y2'') - T2 = -F2.
/// y2'' and y3'' for each of the four right-hand sides, in the order m2, m3, I1, I2, being one and the others
/// zero.
inline std::array<std::array<Number, 4>, 2> accelerations(const std::vector<double>& in) {
  const Number turn1 = Number(in[2]) / (Number(in[4]) * in[4]),
               turn2 = Number(in[3]) / (Number(in[5]) * in[5]);
  constexpr std::size_t n = 4;
  std::array<std::array<Number, 2 * n>, n> rows{{{in[0], 0, 1, -1, 1, 0, 0, 0},
                                                 {0, in[1], 0, 1, 0, 1, 0, 0},
                                                 {turn1, 0, -1, 0, 0, 0, 1, 0},
                                                 {-turn2, turn2, 0, -1, 0, 0, 0, 1}}};
  for (std::size_t pivot = 0; pivot < n; ++pivot)
    for (std::size_t i = 0; i < n; ++i) {
      const Number factor =
          i == pivot ? Number(1 - 1 / rows[pivot][pivot]) : Number(rows[i][pivot] / rows[pivot][pivot]);
      const auto from = rows[pivot];
      for (std::size_t k = 0; k < 2 * n; ++k) rows[i][k] -= factor * from[k];
    }
  std::array<std::array<Number, n>, 2> found;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < n; ++k) found[i][k] = rows[i][n + k];
  return found;
}

}  // namespace oddity::truth::pulleys
