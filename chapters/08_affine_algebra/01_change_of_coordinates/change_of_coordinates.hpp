#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "chapters/exercise.hpp"

namespace oddity::ex08_01 {

using Eigen::Matrix2d, Eigen::Vector2d;

inline Matrix2d rows(double a, double b, double c, double d) {
  Matrix2d m;
  m << a, b, c, d;
  return m;
}

inline const Matrix2d printed = rows(1, 1, -1, 1) / std::sqrt(2.0);

template <class T>
using Vector2 = Eigen::Matrix<T, 2, 1>;
template <class T>
using Matrix2 = Eigen::Matrix<T, 2, 2>;

std::vector<Claim> claims(double seed);
Provables proofs();

}  // namespace oddity::ex08_01
