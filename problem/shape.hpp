#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "formula/matrix.hpp"
#include "formula/tree.hpp"

/// Whether a formula's numbers and vectors fit each other.
namespace oddity::problem {

/// As many ones as there are components.
using Shape = formula::Matrix<double>;

/// "a number", "a vector of 3", "a matrix of 2 by 3".
std::string name_of(std::size_t rows, std::size_t columns);
template <class T>
std::string name_of(const formula::Matrix<T>& x) {
  return name_of(x.rows(), x.columns);
}

/// The reason why a formula has no value for letters of these shapes, and the letters in the part at fault.
struct Misfit {
  std::string says;
  std::vector<std::size_t> letters = {};
};
/// `says`: the reason if no part of the formula is without a value by itself.
Misfit misfit(const formula::Tree&, const std::vector<Shape>& letters, const std::string& says);

}  // namespace oddity::problem
