#include <sstream>

#include "reference/text.hpp"
#include "reference/truth.hpp"

namespace oddity::truth {

namespace {

std::string digits_of(const Number& x, int digits) {
  return x == 0 ? "0" : x.str(digits, std::ios_base::fmtflags(0));
}

/// A component in the table.
struct Cell {
  std::string value, error, bound;
};

/// The errors are distances from the enclosure if there is one, or else the disagreement of the routes, and
/// at least the rounding of the largest component.
std::vector<Cell> cells(const Truth& truth, const std::vector<double>& row, const Distances& distances) {
  const Made made = make_row(truth, row, table_digits);
  std::vector<Cell> all;
  std::vector<std::string> decimals;
  for (const Number& x : made.value) {
    decimals.push_back(digits_of(x, 40));
    all.push_back({decimals.back(), digits_of(made.error, 2), "agreement"});
  }
  const auto enclosed = distances ? distances(row, decimals) : std::nullopt;
  if (!enclosed) return all;
  const Number least = size_of(made.value) * pow(Number(10), -table_digits);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Number error = power_of_ten_above(std::max(least, Number((*enclosed)[i])));
    all[i].error = digits_of(error, 2);
    all[i].bound = "enclosure";
  }
  return all;
}

}  // namespace

std::string heading(const std::string& name, const Truth& truth) {
  std::ostringstream out;
  out << "# " << truth.quantity << "\n"
      << "# formula: " << truth.formula << "\n"
      << "# made by: reference/make/" << name << ".cpp, working with " << working_digits << " digits (MPFR)\n"
      << "# first route: " << truth.first_route << "\n"
      << "# second route: " << truth.second_route << "\n"
      << (truth.enclosed ? "# enclosure: " + truth.enclosure + ", in balls (Arb)\n" : "")
      << "# error: bounds "
      << (truth.enclosed ? "the distance from all numbers in the enclosure"
                         : "the disagreement of the two routes")
      << ", rounded up to a power of ten\n"
      << "# inputs: the double nearest to the decimal shown, taken as exact\n";
  for (const std::string& input : truth.inputs) out << input << ",";
  out << "component,value,error,bound,unit\n";
  return out.str();
}

std::string table(const std::string& name, const Truth& truth, const Distances& distances) {
  std::ostringstream out;
  out << heading(name, truth);
  for (const std::vector<double>& row : truth.rows) {
    const std::vector<Cell> all = cells(truth, row, distances);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (double input : row) out << format_shortest(input) << ",";
      out << truth.components[i].name << "," << all[i].value << "," << all[i].error << "," << all[i].bound
          << "," << truth.components[i].unit << "\n";
    }
  }
  return out.str();
}

}  // namespace oddity::truth
