// Splines are GSL's, which the page does without.

#include "problem/table.hpp"

#include "reference/bad_input.hpp"

namespace oddity::problem {

std::size_t fewest_rows(Spline) { return 2; }

std::vector<Table::Piece> pieces_of(Spline, const std::vector<double>&, const std::vector<double>&) {
  throw BadInput("a file with [tables] does not run in the page yet: oddity takes it on a command line");
}

}  // namespace oddity::problem
