#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "formula/matrix.hpp"
#include "formula/tree.hpp"

/// Whether a formula's numbers and vectors fit each other.
namespace oddity::problem {

/// As many ones as there are components.
using Shape = formula::Matrix<double>;

struct Size {
  std::size_t rows = 1, columns = 1;

  std::size_t entries() const { return rows * columns; }
  bool is_matrix() const { return columns > 1; }
  bool operator==(const Size&) const = default;
};
template <class T>
Size extent(const formula::Matrix<T>& x) {
  return {x.rows(), x.columns};
}

/// "a number", "a vector of 3", "a matrix of 2 by 3".
std::string name_of(Size);
template <class T>
std::string name_of(const formula::Matrix<T>& x) {
  return name_of(extent(x));
}
/// Index of the component that formulas call r_2 or R_12, by the number in its name; empty for any other
/// number.
std::optional<std::size_t> index_of_component(std::size_t number, Size);

/// The reason why a formula has no value for letters of these shapes, and the letters in the part at fault.
struct Misfit {
  std::string says;
  std::vector<std::size_t> letters = {};
};
/// `says`: the reason if no part of the formula is without a value by itself.
Misfit misfit(const formula::Tree&, const std::vector<Shape>& letters, const std::string& says);
/// The reason why a formula is refused that has a value in formula/. There a vector of 4 and a matrix of 2 by
/// 2 have a sum and a dot product.
std::optional<Misfit> uneven(const formula::Tree&, const std::vector<Shape>& letters);

}  // namespace oddity::problem
