#include <algorithm>
#include <utility>

#include "reference/truth.hpp"

namespace oddity::truth {

namespace determinant_07_09 {

Numbers by_elimination(const std::vector<double>& in, int) {
  Numbers a(in.begin(), in.end());
  const auto at = [&](std::size_t i, std::size_t j) -> Number& { return a[4 * i + j]; };
  Number determinant = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 4; ++i)
      if (abs(at(i, k)) > abs(at(pivot, k))) pivot = i;
    if (at(pivot, k) == 0) return {0};
    if (pivot != k) {
      determinant = -determinant;
      for (std::size_t j = 0; j < 4; ++j) std::swap(at(k, j), at(pivot, j));
    }
    determinant *= at(k, k);
    for (std::size_t i = k + 1; i < 4; ++i) {
      const Number ratio = at(i, k) / at(k, k);
      for (std::size_t j = k; j < 4; ++j) at(i, j) -= ratio * at(k, j);
    }
  }
  return {determinant};
}

/// The determinant of the rows from `row` on and the columns in `columns`, along its first row.
Number minor_of(const std::vector<double>& a, std::size_t row, const std::vector<std::size_t>& columns) {
  if (columns.empty()) return 1;
  Number sum = 0;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::vector<std::size_t> others = columns;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const Number term = a[4 * row + columns[k]] * minor_of(a, row + 1, others);
    sum += k % 2 == 0 ? term : Number(-term);
  }
  return sum;
}

Numbers by_cofactors(const std::vector<double>& in, int) { return {minor_of(in, 0, {0, 1, 2, 3})}; }

std::vector<double> hilbert(double shift) {
  std::vector<double> a;
  for (int i = 1; i <= 4; ++i)
    for (int j = 1; j <= 4; ++j) a.push_back(1 / (i + j - 1 + shift));
  return a;
}

}  // namespace determinant_07_09

Truth truth_07_09_determinant() {
  using namespace determinant_07_09;
  std::vector<std::string> names;
  for (const char* i : {"1", "2", "3", "4"})
    for (const char* j : {"1", "2", "3", "4"}) names.push_back(std::string("a") + i + j);
  return {
      "determinant of a 4 x 4 matrix; the first rows are Hilbert matrices 1/(i+j-1+s), s = 0, 1, 4, 8, 20",
      "det A",
      names,
      {{"det", "1"}},
      {hilbert(0),
       hilbert(1),
       hilbert(4),
       hilbert(8),
       hilbert(20),
       {4, 1, -2, 2, 1, 2, 0, 1, -2, 0, 3, -2, 2, 1, -2, -1},
       {3, -1, 0.5, 2, 0, -0.25, 4, 1, 0, 0, 7, -2, 0, 0, 0, 0.125},
       {4, 1, -2, 0, 1, 2, 1, 0, -2, 1, 3, 0, 0, 0, 0, 1},
       {1, 1, -2, 0, 3, 2, 1, 0, 4, 1, 3, 0, 0, 0, 0, 1},
       {4, 1, -2, 0, 1, 3, 1, 0, -2, 4, 3, 0, 0, 0, 0, 1},
       {4, 1, 1, 0, 1, 2, 3, 0, -2, 1, 4, 0, 0, 0, 0, 1},
       {1, 0x1p-10, 0x1p-20, 0x1p-30, 1, 1, 0x1p-10, 0x1p-20, 1, 1, 1, 0x1p-10, 1, 1, 1, 1}},
      "elimination with exchange of rows",
      by_elimination,
      "expansion by cofactors of the first row",
      by_cofactors,
      "the second route",
      by_cofactors};
}

}  // namespace oddity::truth
