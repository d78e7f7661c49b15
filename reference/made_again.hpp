#pragma once

#include <istream>
#include <string>
#include <vector>

#include "reference/truth.hpp"

namespace oddity::truth {

/// A value is read as a double, of 16 digits. Computed again with 18 by two independent routes, a wrong one
/// differs by more than the errors. 42 digits take several times as long.
constexpr int digits_again = 18;

/// A table's rows computed again, by both routes.
class MadeAgain {
 public:
  explicit MadeAgain(const Entry&);

  std::size_t rows() const { return made_.size(); }
  void make(std::size_t row);

  /// Differences from the table's text, once every row is computed; empty: none.
  std::vector<std::string> differences(std::istream& stored) const;

 private:
  std::vector<std::string> row_differences(const std::vector<std::string>& cells, std::size_t row,
                                           std::size_t component) const;

  std::string name_;
  Truth truth_;
  std::vector<Made> made_;
  std::vector<std::string> failures_;  ///< one per row; empty: success
};

}  // namespace oddity::truth
