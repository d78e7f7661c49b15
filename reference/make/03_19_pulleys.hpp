#pragma once

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

}  // namespace oddity::truth::pulleys
