#pragma once

#include <array>
#include <string>
#include <vector>

#include "chapters/expression.hpp"
#include "solvers/dual.hpp"

/// Tops made of any number of rings of points, and facts about sums over their points for Coq.
namespace oddity::top {

/// The sum over the points (m, x, y, z) of the expression for one point.
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

/// Proves equations of sums over the points and of sines and cosines of these angles.
std::string by_points(const std::vector<std::string>& angles);

/// Proves consequences of equations, which are assumed after `first` others: their sum with these factors,
/// where A + C and 2 A are the moments across and about the axis.
std::string by_equations(const std::vector<std::string>& angles, const std::vector<std::string>& factors,
                         std::size_t first);
/// As by_equations, for goals that may not need the equations.
std::string by_equations_if_need_be(const std::vector<std::string>& angles,
                                    const std::vector<std::string>& factors, std::size_t first);

}  // namespace oddity::top
