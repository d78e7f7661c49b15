#include <sstream>

#include "reference/text.hpp"
#include "reference/truth.hpp"

namespace oddity::truth {

namespace {

std::string digits_of(const Number& x, int digits) {
  return x == 0 ? "0" : x.str(digits, std::ios_base::fmtflags(0));
}

}  // namespace

std::string heading(const std::string& name, const Truth& truth) {
  std::ostringstream out;
  out << "# " << truth.quantity << "\n"
      << "# formula: " << truth.formula << "\n"
      << "# made by: reference/make/" << name << ".cpp, working with " << working_digits << " digits (MPFR)\n"
      << "# first route: " << truth.first_route << "\n"
      << "# second route: " << truth.second_route << "\n"
      << "# error: bounds the disagreement of the two routes, rounded up to a power of ten\n"
      << "# inputs: the double nearest to the decimal shown, taken as exact\n";
  for (const std::string& input : truth.inputs) out << input << ",";
  out << "component,value,error,unit\n";
  return out.str();
}

std::string table(const std::string& name, const Truth& truth) {
  std::ostringstream out;
  out << heading(name, truth);
  for (const std::vector<double>& row : truth.rows) {
    const Made made = make_row(truth, row, table_digits);
    for (std::size_t i = 0; i < made.value.size(); ++i) {
      for (double input : row) out << shortest(input) << ",";
      out << truth.components[i].name << "," << digits_of(made.value[i], 40) << ","
          << digits_of(made.error, 2) << "," << truth.components[i].unit << "\n";
    }
  }
  return out.str();
}

}  // namespace oddity::truth
