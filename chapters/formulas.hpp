#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/letters.hpp"
#include "chapters/near_misses.hpp"
#include "chapters/typeset.hpp"

/// Formulas in the letters of samples, each written next to the code that computes it, or as its text alone,
/// and their comparison over the samples. A sample is a struct of the exercise's letters:
/// - table() -> Letters<double>             its independent letters (letters.hpp): changing each a little
/// gives
///                                          the size of a formula's terms
/// - Sample(Random&)                        draws one, if the table() does not
/// - letters() -> array of double*          without a table(): the independent letters
/// - where() const -> std::string           lists its values, if the first letters are not enough
/// - size() const -> double                 size of the terms that cancel in a quantity that should be zero
/// - conditioning() const -> double         without letters(): the terms' size relative to the largest value
/// - whole                                  a static constant, if all values are whole numbers that a double
///                                          represents exactly: they must be equal
/// - typeset() -> TypesetLetters            letters besides those of the table() as a page shows them: a
///                                          reading that is a formula of these must agree with the code
/// - tolerance(double size) -> Tolerance    allowed difference for terms of this size, if the numbers have a
///                                          less accurate source such as a quadrature
namespace oddity {

/// The sample's letters: where(), or the first four of typeset().
template <class Sample>
std::string where_of(const Sample& sample) {
  if constexpr (requires { sample.where(); })
    return sample.where();
  else
    return listed(typeset_of(sample), 4);
}

/// The numbers as one value.
template <class... Numbers>
Value values(Numbers... x) {
  return {static_cast<double>(x)...};
}

/// A quantity written as a formula in the letters of a sample. Without `of`, its value is that of its text,
/// "$m_2g-c_1(S_1-L_1)$", in the sample's typeset() letters. `terms` is the size of those terms that cancel
/// for any letters, if there are such.
template <class Sample>
struct Formula {
  std::string text;
  std::function<Value(const Sample&)> of = {};
  std::function<double(const Sample&)> terms = {};
};

/// Whether the formula is a text alone, computed as it is typeset in the letters of a sample's typeset().
template <class Sample>
bool is_text(const Formula<Sample>& formula) {
  return !formula.of && !formula.text.empty();
}

/// The formula with its `of`; by default this evaluates the text.
template <class Sample>
Formula<Sample> computed(Formula<Sample> formula) {
  if (!is_text(formula)) return formula;
  if constexpr (Typeset<Sample>) {
    const TypesetFormula typeset(formula.text);
    formula.of = [typeset](const Sample& s) { return typeset(typeset_of(s)); };
    formula.terms = [typeset](const Sample& s) { return typeset.cancelling(typeset_of(s)); };
  } else {
    throw std::logic_error("'" + formula.text + "' is not computed, and its samples have no typeset letters");
  }
  return formula;
}

/// Relative change of a letter that shows the size of a formula's terms.
inline constexpr double small_change = 0x1p-20;

/// Size of a formula's terms at a sample: the sum over its letters of the change of its value per relative
/// change of the letter. Terms that cancel in the value do not cancel here. `value` is its value there.
template <class Sample>
double size_of_terms(const Formula<Sample>& formula, const Sample& sample, const Value& value) {
  double size = size_of(value) + (formula.terms ? formula.terms(sample) : 0);
  Sample moved = sample;
  for (auto* letter : oddity::letters_of(moved)) {
    const double x = std::exchange(*letter, *letter * (1 + small_change));
    size += distance(formula.of(moved), value) / small_change;
    *letter = x;
  }
  return size;
}

template <class Sample>
double size_of_terms(const Formula<Sample>& formula, const Sample& sample) {
  return size_of_terms(formula, sample, formula.of(sample));
}

/// Size of the terms of a function of an array of letters.
template <std::size_t n, class F>
double size_of_terms(const F& f, const std::array<double, n>& letters) {
  const Value value = f(letters);
  double size = size_of(value);
  for (std::size_t i = 0; i < n; ++i) {
    auto moved = letters;
    moved[i] *= 1 + small_change;
    size += distance(Value(f(moved)), value) / small_change;
  }
  return size;
}

/// Adds two functions of the same letters at one sample, with the size of their terms.
template <std::size_t n, class Left, class Right>
void see(WorstSample& worst, const Left& left, const Right& right, const std::array<double, n>& letters,
         const std::string& where) {
  worst.add(left(letters), right(letters),
            std::max(size_of_terms(left, letters), size_of_terms(right, letters)), where);
}

/// The typeset letters' values at samples, and there with each of the sample's own letters a little changed.
/// Each is computed once, as the texts of a table's claims and their changes need them all.
template <class Sample>
class LettersAtSamples {
 public:
  explicit LettersAtSamples(const std::vector<Sample>& samples) : all_(samples.size()), samples_(samples) {}

  const std::vector<Sample>& samples() const { return samples_; }
  /// Whether these are the samples, by all letters that are known.
  bool are_of(const std::vector<Sample>& samples) const {
    bool are = all_.size() == samples.size();
    if constexpr (Typeset<Sample>)
      for (std::size_t i = 0; are && i < all_.size(); ++i) {
        if (all_[i].empty() || all_[i][0].empty()) continue;
        const TypesetLetters letters = typeset_of(samples[i]);
        are = (!names_ || names_->empty() || names_of(letters) == *names_) &&
              std::ranges::equal(values_of(letters), all_[i][0], {}, &formula::Matrix<double>::entries,
                                 &formula::Matrix<double>::entries);
      }
    return are;
  }
  const TypesetFormula::Values& at(std::size_t i) const { return of(i, 0); }
  std::size_t count(std::size_t i) const {
    if constexpr (Lettered<Sample>) {
      Sample sample = samples_[i];
      return oddity::letters_of(sample).size();
    } else {
      return 0;
    }
  }
  const TypesetFormula::Values& moved(std::size_t i, std::size_t letter) const { return of(i, letter + 1); }
  /// Names of the letters; empty if they differ between samples.
  const formula::Names& names() const {
    if constexpr (Typeset<Sample>)
      if (!names_ && !samples_.empty()) {
        names_ = names_of(typeset_of(samples_[0]));
        const auto is_same = [&](const Sample& s) {
          return std::ranges::equal(typeset_of(s), *names_, {}, &TypesetLetters::value_type::first);
        };
        if (!std::ranges::all_of(samples_, is_same)) names_.emplace();
      }
    return names_ ? *names_ : names_.emplace();
  }

 private:
  const TypesetFormula::Values& of(std::size_t i, std::size_t which) const {
    auto& known = all_[i];
    if (known.empty()) known.resize(count(i) + 1);
    if constexpr (Typeset<Sample>)
      if (known[which].empty()) known[which] = values_of(typeset_of(changed(samples_[i], which)));
    return known[which];
  }
  static Sample changed(Sample sample, std::size_t which) {
    if constexpr (Lettered<Sample>)
      if (which > 0) *oddity::letters_of(sample)[which - 1] *= 1 + small_change;
    return sample;
  }

  mutable std::vector<std::vector<TypesetFormula::Values>> all_;
  mutable std::optional<formula::Names> names_ = {};
  const std::vector<Sample>& samples_;
};

/// A formula's values and the sizes of its terms at some samples, each computed once.
template <class Sample>
class AtSamples {
 public:
  AtSamples(Formula<Sample> formula, const std::vector<Sample>& samples)
      : formula_(std::move(formula)), samples_(samples) {}
  /// By sides in the letters of the first sample.
  AtSamples(std::string text, std::vector<formula::Tree> sides, const LettersAtSamples<Sample>& letters)
      : formula_{std::move(text)},
        samples_(letters.samples()),
        letters_(&letters),
        sides_(std::move(sides)) {}

  const std::string& text() const { return formula_.text; }
  const std::vector<Sample>& samples() const { return samples_; }

  const Value& value(std::size_t i) const {
    while (values_.size() <= i) values_.push_back(value_at(values_.size()));
    return values_[i];
  }
  /// By the sample's letters.
  double size(std::size_t i) const {
    while (sizes_.size() <= i) sizes_.push_back(size_at(sizes_.size()));
    return sizes_[i];
  }
  /// Size of the terms that cancel for any letters.
  double terms(std::size_t i) const {
    if (letters_) return TypesetFormula::cancelling(sides_, letters_->at(i));
    return formula_.terms ? formula_.terms(samples_[i]) : 0;
  }

 private:
  Value value_at(std::size_t i) const {
    return letters_ ? TypesetFormula::value(sides_, letters_->at(i)) : formula_.of(samples_[i]);
  }
  double size_at(std::size_t i) const {
    if (!letters_) return size_of_terms(formula_, samples_[i], value(i));
    double size = size_of(value(i)) + terms(i);
    const TypesetFormula::Values& here = letters_->at(i);
    const std::vector<bool> used = TypesetFormula::used(sides_, here.size());
    const std::size_t count = letters_->count(i);
    for (std::size_t k = 0; k < count; ++k) {
      const TypesetFormula::Values& moved = letters_->moved(i, k);
      bool is_moved = false;
      for (std::size_t j = 0; j < here.size() && !is_moved; ++j)
        is_moved = used[j] && moved[j].entries != here[j].entries;
      if (is_moved) size += distance(TypesetFormula::value(sides_, moved), value(i)) / small_change;
    }
    return size;
  }

  Formula<Sample> formula_;
  const std::vector<Sample>& samples_;
  const LettersAtSamples<Sample>* letters_ = nullptr;
  std::vector<formula::Tree> sides_ = {};
  mutable std::vector<Value> values_;
  mutable std::vector<double> sizes_;
};

/// The formula at the samples, whose typeset letters are `letters`. Names of letters may differ between
/// samples; then a text is read for each.
template <class Sample>
AtSamples<Sample> at_samples(const Formula<Sample>& formula, const LettersAtSamples<Sample>& letters) {
  if (is_text(formula))
    if (const formula::Names& names = letters.names(); !names.empty())
      return {formula.text, TypesetFormula(formula.text).sides(names), letters};
  return {computed(formula), letters.samples()};
}

/// Compares two formulas over the first samples and keeps the worst. A single number is compared with each of
/// several. If one side is zero throughout, the scale is the sample's size(), if it has one. Otherwise it is
/// the size of the terms, found from the sample's letters(). Without letters() it is the largest value, times
/// the sample's conditioning() if it has one.
template <class Sample>
Check compare(std::string quantity, const AtSamples<Sample>& left, const AtSamples<Sample>& right,
              std::size_t count) {
  const std::vector<Sample>& samples = right.samples();
  std::vector<Value> lefts, rights;
  double largest = 0;
  bool left_is_zero = true, right_is_zero = true;
  for (std::size_t i = 0; i < count; ++i) {
    lefts.push_back(left.value(i));
    rights.push_back(right.value(i));
    in_a_row(lefts.back(), rights.back());
    for (const Value* value : {&lefts.back(), &rights.back()})
      if (finite(*value)) largest = std::max(largest, size_of(*value));
    left_is_zero = left_is_zero && size_of(lefts.back()) == 0;
    right_is_zero = right_is_zero && size_of(rights.back()) == 0;
  }
  const bool with_zero = left_is_zero || right_is_zero;
  const auto size = [&](std::size_t i) {
    const Sample& sample = samples[i];
    if constexpr (requires { sample.size(); })
      if (with_zero) return sample.size();
    if constexpr (Lettered<Sample>) return std::max(left.size(i), right.size(i));
    const double given = std::max(left.terms(i), right.terms(i));
    if constexpr (requires { sample.conditioning(); })
      return given + largest * sample.conditioning();
    else
      return given + largest;
  };
  WorstSample worst(std::move(quantity), left.text(), right.text());
  for (std::size_t i = 0; i < count; ++i)
    if constexpr (requires { Sample::whole; })
      worst.add(lefts[i], rights[i], exact(), size(i), where_of(samples[i]));
    else if constexpr (requires(double terms) { samples[i].tolerance(terms); })
      worst.add(lefts[i], rights[i], samples[i].tolerance(size(i)), size(i), where_of(samples[i]));
    else
      worst.add(lefts[i], rights[i], size(i), where_of(samples[i]));
  return worst.check();
}
/// Over all samples.
template <class Sample>
Check compare(std::string quantity, const AtSamples<Sample>& left, const AtSamples<Sample>& right) {
  return compare(std::move(quantity), left, right, right.samples().size());
}
template <class Sample>
Check compare(std::string quantity, const Formula<Sample>& left, const Formula<Sample>& right,
              const std::vector<Sample>& samples) {
  return compare(std::move(quantity), AtSamples<Sample>(left, samples), AtSamples<Sample>(right, samples));
}

/// Compares the formula's text with the values it computes.
template <class Sample>
Typesetting compare_typeset(const Formula<Sample>& formula, const std::vector<Sample>& samples) {
  if constexpr (Typeset<Sample>) {
    constexpr std::size_t enough = 8;
    std::vector<std::pair<TypesetLetters, Value>> computed;
    for (std::size_t i = 0; i < std::min(enough, samples.size()); ++i)
      if (const TypesetLetters letters = typeset_of(samples[i]); !letters.empty())
        computed.emplace_back(letters, formula.of(samples[i]));
    return compare_typeset(formula.text, computed);
  }
  return {};
}

/// Cases that the author of a claim had in mind, in words, and whether a sample is one of them.
template <class Sample>
struct InView {
  std::string text;  ///< "for $n\ge2$"
  std::function<bool(const Sample&)> is;

  /// Throws std::logic_error if there are samples and none is such a case.
  std::vector<Sample> of(const std::vector<Sample>& samples) const {
    std::vector<Sample> seen;
    std::ranges::copy_if(samples, std::back_inserter(seen), is);
    if (seen.empty() && !samples.empty()) throw std::logic_error("no sample is a case '" + text + "'");
    return seen;
  }
};

/// Single changes of a right formula, each as a near miss: the one that is hardest to detect, and all those
/// that hold as well. `known` is the reason why some may hold; then these are only counted.
template <class Sample>
std::vector<Reading> single_changes(const std::string& quantity, const Formula<Sample>& right,
                                    const AtSamples<Sample>& truth, const LettersAtSamples<Sample>& letters,
                                    const std::string& known, std::size_t exact = exact_ones) {
  std::vector<Reading> readings;
  if constexpr (Typeset<Sample>) {
    constexpr std::size_t enough = 16;
    const std::size_t some = std::min(enough, truth.samples().size());
    std::vector<TypesetSample> typeset;
    for (std::size_t i = 0; i < some; ++i)
      typeset.push_back({typeset_of(truth.samples()[i]), truth.value(i)});
    const Changes changes = changes_of(TypesetFormula(right.text), typeset, exact);
    const std::size_t count = changes.hardest_first.size();
    std::size_t holding = 0, beyond = 0;
    for (const ChangedFormula& changed : changes.hardest_first) {
      if (!readings.empty() && changed.roundings > clear) break;
      if (changed.roundings > clear && ++beyond > exact)
        return single_changes(quantity, right, truth, letters, known, std::string::npos);
      const AtSamples<Sample> formula(
          changed.change + ", the hardest to see of " + std::to_string(count) + " changes: " + changed.text(),
          changed.sides, letters);
      Reading reading{formula.text(), {compare(quantity, formula, truth, some)}};
      if (reading.holds()) reading.checks = {compare(quantity, formula, truth)};
      if (reading.holds() && !known.empty())
        ++holding;
      else if (reading.holds() || readings.empty() || readings.front().holds())
        readings.push_back(std::move(reading));
    }
    if (holding > 0 && !readings.empty())
      readings.front().text += "; " + std::to_string(holding) + " others hold: " + known;
  }
  return readings;
}
template <class Sample>
std::vector<Reading> single_changes(const std::string& quantity, const Formula<Sample>& right,
                                    const Formula<Sample>& truth, const std::vector<Sample>& samples,
                                    const std::string& known) {
  return single_changes(quantity, right, AtSamples<Sample>(truth, samples), LettersAtSamples<Sample>(samples),
                        known);
}

}  // namespace oddity
