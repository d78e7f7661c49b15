#include "reference/made_again.hpp"

#include <algorithm>
#include <sstream>

#include "reference/text.hpp"

namespace oddity::truth {

namespace {

struct TableText {
  std::string heading;
  std::vector<std::vector<std::string>> rows;  ///< inputs, component, value, error, bound, unit
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream parts(line);
  for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
  return cells;
}

TableText parsed(std::istream& in) {
  TableText table;
  bool columns = false;
  for (std::string line; std::getline(in, line);) {
    if (columns) {
      table.rows.push_back(cells_of(line));
      continue;
    }
    table.heading += line + "\n";
    columns = !line.starts_with('#');
  }
  return table;
}

template <class A, class B>
std::string unlike(const A& stored, const B& made) {
  std::ostringstream text;
  text.precision(digits_again);
  text << "stored is " << stored << ", made " << made;
  return text.str();
}

/// Texts from the generator: the inputs, component and unit.
std::vector<std::string> words_of(const Truth& truth, std::size_t row, std::size_t component) {
  std::vector<std::string> words;
  for (const double input : truth.rows[row]) words.push_back(format_shortest(input));
  words.push_back(truth.components[component].name);
  words.push_back(truth.components[component].unit);
  return words;
}

/// Largest distance of two correct routes: the rounding to `digits_again` digits, or more if the table's
/// routes differ by more than its digits. That distance grows by one power of ten for each digit less. In
/// chaos this is no bound; there the limit is ten times the table's distance, or 1e-10 of the size. The
/// chaotic chain's last row has 3e-12.
Number most_apart(const Number& stored, const Number& size) {
  const Number ten = 10, in_chaos = std::max<Number>(ten * stored, size * pow(ten, -10));
  return std::max<Number>(size * pow(ten, 2 - digits_again),
                          std::min<Number>(stored * pow(ten, 1 + table_digits - digits_again), in_chaos));
}

}  // namespace

MadeAgain::MadeAgain(const Entry& entry)
    : name_(entry.name), truth_(entry.make()), made_(truth_.rows.size()), failures_(truth_.rows.size()) {}

void MadeAgain::make(std::size_t row) {
  try {
    made_[row] = make_row(truth_, truth_.rows[row], digits_again);
  } catch (const std::exception& error) {
    failures_[row] = error.what();
  }
}

/// Checks that the stored value agrees with the new one within both errors, and that the stored error is not
/// the larger one. The two routes must agree as far as fewer digits allow.
std::vector<std::string> MadeAgain::row_differences(const std::vector<std::string>& cells, std::size_t row,
                                                    std::size_t component) const {
  std::vector<std::string> all;
  const std::size_t inputs = truth_.inputs.size();
  if (cells.size() != inputs + 5) return {"a row has " + std::to_string(cells.size()) + " cells"};
  std::vector<std::string> words(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(inputs) + 1);
  words.push_back(cells.back());
  const std::vector<std::string> expected = words_of(truth_, row, component);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] != expected[i]) all.push_back(unlike(words[i], expected[i]));
  const Number value(cells[inputs + 1]), error(cells[inputs + 2]), made = made_[row].value[component];
  if (!(abs(value - made) <= error + made_[row].error)) all.push_back(unlike(value, made));
  if (!(error > 0 && error <= made_[row].error))
    all.push_back("its error: " + unlike(error, made_[row].error));
  if (!(made_[row].error <= most_apart(error, size_of(made_[row].value))))
    all.push_back("how far its routes are apart: " + unlike(error, made_[row].error));
  return all;
}

std::vector<std::string> MadeAgain::differences(std::istream& in) const {
  const TableText stored = parsed(in);
  std::vector<std::string> all;
  for (const std::string& failure : failures_)
    if (!failure.empty()) all.push_back(failure);
  if (!all.empty()) return all;
  if (const std::string heading = truth::heading(name_, truth_); stored.heading != heading)
    all.push_back(unlike(stored.heading, heading));
  const std::size_t components = truth_.components.size();
  if (stored.rows.size() != made_.size() * components)
    return {unlike(stored.rows.size(), made_.size() * components)};
  for (std::size_t i = 0; i < stored.rows.size(); ++i)
    for (std::string& difference : row_differences(stored.rows[i], i / components, i % components))
      all.push_back(truth_.components[i % components].name + ", row " + std::to_string(i / components + 1) +
                    ": " + std::move(difference));
  return all;
}

}  // namespace oddity::truth
