#include "chapters/near_misses.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <string>

#include "chapters/random.hpp"
#include "formula/magnitude.hpp"
#include "formula/mutants.hpp"
#include "formula/print.hpp"

namespace oddity {

namespace {

using Sides = std::vector<formula::Tree>;
using LetterValues = std::vector<formula::Matrix<double>>;

double magnitude_of(const Sides& sides, const LetterValues& letters) {
  double size = 0;
  for (const formula::Tree& side : sides) size += formula::magnitude(side, letters);
  return size;
}

/// The largest difference, in roundings; infinite if a value is undefined. Beyond `enough` the first one that
/// is larger.
double roundings(const Sides& sides, const std::vector<LetterValues>& letters,
                 const std::vector<Value>& values, const std::vector<double>& sizes, double enough) {
  double largest = 0;
  for (std::size_t i = 0; i < letters.size() && largest <= enough; ++i) {
    try {
      Value value = TypesetFormula::value(sides, letters[i]), truth = values[i];
      in_a_row(value, truth);
      const double off = distance(value, truth);
      if (!(std::isfinite(off))) return std::numeric_limits<double>::infinity();
      const double size = std::max(sizes[i], std::numeric_limits<double>::min());
      largest = std::max(largest, off / (std::numeric_limits<double>::epsilon() * size));
    } catch (const formula::NoValue&) {
      return std::numeric_limits<double>::infinity();
    }
  }
  return largest;
}

/// LetterValues of any size and sign, independent of each other, unlike those of a sample.
std::vector<LetterValues> at_random(const LetterValues& letters) {
  Random random(7);
  std::vector<LetterValues> all;
  for (int n = 0; n < 16; ++n) {
    all.push_back(letters);
    for (auto& letter : all.back())
      for (double& x : letter.entries) x = n % 2 == 0 ? random.magnitude(0.3, 3) : random.between(0.3, 3);
  }
  return all;
}

/// Whether two rows have the same components.
bool are_in_another_order(const formula::Tree& a, const formula::Tree& b) {
  if (a.kind() != formula::Kind::tuple || b.kind() != formula::Kind::tuple) return false;
  const auto texts = [](const formula::Tree& tuple) {
    std::multiset<std::string> all;
    for (const formula::Tree& one : tuple->children) all.insert(formula::tex(one));
    return all;
  };
  return texts(a) == texts(b);
}

}  // namespace

std::string ChangedFormula::text() const {
  std::string text;
  for (const formula::Tree& side : sides) text += (text.empty() ? "" : "=") + formula::tex(side);
  return "$" + text + "$";
}

Changes changes_of(const TypesetFormula& formula, const std::vector<TypesetSample>& samples,
                   std::size_t exact) {
  Changes changes;
  if (samples.empty()) return changes;
  const Sides right = formula.sides(names_of(samples[0].letters));
  std::vector<LetterValues> letters;
  std::vector<Value> truth;
  std::vector<double> sizes;
  for (const TypesetSample& sample : samples) {
    letters.push_back(values_of(sample.letters));
    truth.push_back(sample.truth);
    sizes.push_back(std::max(magnitude_of(right, letters.back()), size_of(sample.truth)));
  }
  // Only where the formula is defined: roots are not for all letters.
  std::vector<LetterValues> any;
  std::vector<Value> right_at_any;
  std::vector<double> sizes_at_any;
  for (LetterValues& one : at_random(letters[0])) {
    Value value = TypesetFormula::value(right, one);
    if (!finite(value)) continue;
    right_at_any.push_back(std::move(value));
    sizes_at_any.push_back(magnitude_of(right, one));
    any.push_back(std::move(one));
  }
  constexpr double is_rounding = 1e4, infinite = std::numeric_limits<double>::infinity();
  std::multiset<double> hardest;  // beyond `clear`
  for (std::size_t i = 0; i < right.size(); ++i)
    for (const formula::Mutant& mutant : formula::mutants(right[i])) {
      Sides sides = right;
      sides[i] = mutant.tree;
      const double off =
          roundings(sides, letters, truth, sizes, hardest.size() < exact ? infinite : *hardest.rbegin());
      // The forms of one quantity in a row are equal.
      const bool is_row = truth[0].size() == 1 && are_in_another_order(right[i], mutant.tree);
      if (mutant.change == "components exchanged" && (is_row || off < is_rounding))
        ++changes.equal;
      else if (off < is_rounding && !any.empty() &&
               roundings(sides, any, right_at_any, sizes_at_any, is_rounding) < is_rounding)
        ++changes.equal;
      else {
        if (off > clear) hardest.insert(off);
        if (hardest.size() > exact) hardest.erase(std::prev(hardest.end()));
        changes.hardest_first.push_back({mutant.change, std::move(sides), off});
      }
    }
  std::ranges::stable_sort(changes.hardest_first, {}, &ChangedFormula::roundings);
  return changes;
}

}  // namespace oddity
