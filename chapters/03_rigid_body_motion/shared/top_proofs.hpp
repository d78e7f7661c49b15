#pragma once

#include <array>
#include <string>
#include <vector>

#include "chapters/expression.hpp"
#include "solvers/dual.hpp"

/// Tops that are made of rings of points, however many, and what Coq has to know of sums over their points.
namespace oddity::top {

/// The sum over the points (m, x, y, z) of what is recorded of one.
inline Shortened total(const Shortened& one) {
  if (one.expression().coq() == "0") return one;
  return Expression::letter("(total l (fun m x y z => " + one.expression().coq() + "))");
}
template <class T>
Dual<T> total(const Dual<T>& one) {
  return {total(one.value), total(one.slope)};
}
template <class T, std::size_t n>
std::array<T, n> total(std::array<T, n> one) {
  for (T& component : one) component = total(component);
  return one;
}

/// Definitions and lemmas: H : top l mass ell mu1 mu3, first of what is given.
extern const char* const tops_in_coq;

/// Equations of sums over the points and of sines and cosines of these angles.
std::string by_points(const std::vector<std::string>& angles);

/// The same of what follows from equations, which are given after `first` others: their sum with these
/// factors, in which A + C and 2 A are the moments across and about the axis.
std::string by_equations(const std::vector<std::string>& angles, const std::vector<std::string>& factors,
                         std::size_t first);
/// The same where some of what is to be shown may not need them.
std::string by_equations_if_need_be(const std::vector<std::string>& angles,
                                    const std::vector<std::string>& factors, std::size_t first);

}  // namespace oddity::top
