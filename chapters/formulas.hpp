#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
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
/// - table() -> Letters<double>             its independent letters (letters.hpp); small changes of each give
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

// ---- samples of any type ----------------------------------------------------------------------------------

/// Samples by their numbers, for code that is the same for all types of samples and is compiled once.
class AnySamples {
 public:
  virtual ~AnySamples() = default;
  virtual const void* type() const = 0;  ///< equal for the same type
  virtual const void* address() const = 0;
  virtual std::size_t count() const = 0;
  virtual std::string where(std::size_t i) const = 0;
  virtual bool is_typeset() const = 0;
  virtual bool is_lettered() const = 0;
  /// The number of independent letters.
  virtual std::size_t letters(std::size_t i) const = 0;
  /// The letters on a page, with the independent letter `changed` a little changed; 0 for none, 1 for the
  /// first.
  virtual TypesetLetters typeset(std::size_t i, std::size_t changed) const = 0;
  virtual std::optional<double> size(std::size_t i) const = 0;
  virtual double conditioning(std::size_t i) const = 0;
  /// The sample's own for terms of this size.
  virtual std::optional<Tolerance> tolerance(std::size_t i, double size) const = 0;
};

template <class Sample>
class SamplesOf final : public AnySamples {
 public:
  explicit SamplesOf(const std::vector<Sample>& samples) : samples_(samples) {}

  const void* type() const override { return &type_; }
  const void* address() const override { return &samples_; }
  std::size_t count() const override { return samples_.size(); }
  std::string where(std::size_t i) const override { return where_of(samples_[i]); }
  bool is_typeset() const override { return Typeset<Sample>; }
  bool is_lettered() const override { return Lettered<Sample>; }
  std::size_t letters(std::size_t i) const override {
    if constexpr (Lettered<Sample>) {
      Sample sample = samples_[i];
      return oddity::letters_of(sample).size();
    }
    return 0;
  }
  TypesetLetters typeset(std::size_t i, std::size_t changed) const override {
    if constexpr (Typeset<Sample>) {
      if constexpr (Lettered<Sample>)
        if (changed > 0) {
          Sample sample = samples_[i];
          *oddity::letters_of(sample)[changed - 1] *= 1 + small_change;
          return typeset_of(sample);
        }
      return typeset_of(samples_[i]);
    }
    return {};
  }
  std::optional<double> size(std::size_t i) const override {
    if constexpr (requires { samples_[i].size(); }) return samples_[i].size();
    return {};
  }
  double conditioning(std::size_t i) const override {
    if constexpr (requires { samples_[i].conditioning(); }) return samples_[i].conditioning();
    return 1;
  }
  std::optional<Tolerance> tolerance(std::size_t i, double size) const override {
    if constexpr (requires { Sample::whole; })
      return exact();
    else if constexpr (requires { samples_[i].tolerance(size); })
      return samples_[i].tolerance(size);
    return {};
  }

 private:
  static constexpr char type_ = 0;  ///< its address names the type
  const std::vector<Sample>& samples_;
};

/// The code of a formula at samples.
class AnyCode {
 public:
  virtual ~AnyCode() = default;
  virtual Value value(std::size_t i) const = 0;
  /// Size of the terms that cancel for any letters.
  virtual double terms(std::size_t i) const = 0;
  /// Size of the terms, from the independent letters.
  virtual double size(std::size_t i, const Value& value) const = 0;
};

template <class Sample>
class CodeOf final : public AnyCode {
 public:
  CodeOf(const Formula<Sample>& formula, const std::vector<Sample>& samples)
      : formula_(formula), samples_(samples) {}

  Value value(std::size_t i) const override { return formula_.of(samples_[i]); }
  double terms(std::size_t i) const override { return formula_.terms ? formula_.terms(samples_[i]) : 0; }
  double size(std::size_t i, const Value& value) const override {
    if constexpr (Lettered<Sample>) return size_of_terms(formula_, samples_[i], value);
    return size_of(value) + terms(i);
  }

 private:
  const Formula<Sample>& formula_;
  const std::vector<Sample>& samples_;
};

/// A formula at samples of any type: its text, and its code unless it is a text alone.
struct AnyFormula {
  std::string text;
  std::shared_ptr<const AnyCode> code = nullptr;

  bool is_text() const { return !code && !text.empty(); }
  bool is_missing() const { return !code && text.empty(); }
};
/// Refers to the formula and the samples.
template <class Sample>
AnyFormula any_formula(const Formula<Sample>& formula, const std::vector<Sample>& samples) {
  AnyFormula any{formula.text};
  if (formula.of) any.code = std::unique_ptr<const AnyCode>(new CodeOf<Sample>(formula, samples));
  return any;
}

/// The typeset letters' values at samples, and there with each of the sample's own letters a little changed.
/// Each is computed once, as the texts of a table's claims and their changes need them all.
class LettersAtSamples {
 public:
  explicit LettersAtSamples(std::unique_ptr<const AnySamples>);

  const AnySamples& samples() const { return *samples_; }
  /// Whether these are the samples, by all letters that are known.
  bool are_of(const AnySamples&) const;
  const TypesetFormula::Values& at(std::size_t i) const { return of(i, 0); }
  std::size_t count(std::size_t i) const { return samples_->letters(i); }
  const TypesetFormula::Values& moved(std::size_t i, std::size_t letter) const { return of(i, letter + 1); }
  /// Names of the letters; empty if they differ between samples.
  const formula::Names& names() const;

 private:
  const TypesetFormula::Values& of(std::size_t i, std::size_t which) const;

  std::unique_ptr<const AnySamples> samples_;
  mutable std::vector<std::vector<TypesetFormula::Values>> all_;
  mutable std::optional<formula::Names> names_ = {};
};

/// A formula's values and the sizes of its terms at some samples, each computed once.
class AtSamples {
 public:
  /// Throws std::logic_error for a text alone if the samples have no typeset letters.
  AtSamples(AnyFormula, const AnySamples&);
  /// By sides in the letters of the first sample.
  AtSamples(std::string text, std::vector<formula::Tree> sides, const LettersAtSamples&);

  const std::string& text() const { return text_; }
  const AnySamples& samples() const { return samples_; }
  const Value& value(std::size_t i) const;
  /// By the sample's letters.
  double size(std::size_t i) const;
  /// Size of the terms that cancel for any letters.
  double terms(std::size_t i) const;

 private:
  const AnyCode& code() const;
  double size_at(std::size_t i) const;

  std::string text_;
  const AnySamples& samples_;
  std::shared_ptr<const AnyCode> code_ = nullptr;
  const LettersAtSamples* letters_ = nullptr;
  std::vector<formula::Tree> sides_ = {};
  mutable std::vector<std::optional<Value>> values_;
  mutable std::vector<std::optional<double>> sizes_;
};

/// The formula at the samples, whose typeset letters are `letters`. Names of letters may differ between
/// samples; then a text is read for each.
AtSamples at_samples(const AnyFormula&, const LettersAtSamples& letters);

/// Compares two formulas over the samples of these numbers and keeps the worst. A single number is compared
/// with each of several. If one side is zero throughout, the scale is the sample's size(), if it has one.
/// Otherwise it is the size of the terms, found from the sample's letters(). Without letters() it is the
/// largest value, times the sample's conditioning() if it has one.
Check compare(std::string quantity, const AtSamples& left, const AtSamples& right,
              const std::vector<std::size_t>& numbers);
/// Over all samples.
Check compare(std::string quantity, const AtSamples& left, const AtSamples& right);
template <class Sample>
Check compare(std::string quantity, const Formula<Sample>& left, const Formula<Sample>& right,
              const std::vector<Sample>& samples) {
  const SamplesOf<Sample> any(samples);
  return compare(std::move(quantity), AtSamples(any_formula(left, samples), any),
                 AtSamples(any_formula(right, samples), any));
}

/// Compares the formula's text with the values it computes.
Typesetting compare_typeset(const AnyFormula&, const AnySamples&);
template <class Sample>
Typesetting compare_typeset(const Formula<Sample>& formula, const std::vector<Sample>& samples) {
  return compare_typeset(any_formula(formula, samples), SamplesOf<Sample>(samples));
}

/// Cases that the author of a claim had in mind, in words, and whether a sample is one of them.
template <class Sample>
struct InView {
  std::string text;  ///< "for $n\ge2$"
  std::function<bool(const Sample&)> is;
};
/// Such cases of samples of any type, by their numbers.
struct AnyInView {
  std::string text;
  std::vector<std::size_t> seen;
};
/// Throws std::logic_error if there are samples and none is such a case.
template <class Sample>
AnyInView any_in_view(const InView<Sample>& in_view, const std::vector<Sample>& samples) {
  AnyInView any{in_view.text, {}};
  if (!in_view.is) return any;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (in_view.is(samples[i])) any.seen.push_back(i);
  if (any.seen.empty() && !samples.empty()) throw std::logic_error("no sample is a case '" + any.text + "'");
  return any;
}

/// Single changes of a right formula, each as a near miss: the one that is hardest to detect, and all those
/// that hold as well. `known` is the reason why some may hold; then these are only counted.
std::vector<Reading> single_changes(const std::string& quantity, const std::string& right,
                                    const AtSamples& truth, const LettersAtSamples& letters,
                                    const std::string& known, std::size_t exact = exact_ones);
template <class Sample>
std::vector<Reading> single_changes(const std::string& quantity, const Formula<Sample>& right,
                                    const Formula<Sample>& truth, const std::vector<Sample>& samples,
                                    const std::string& known) {
  const LettersAtSamples letters(std::make_unique<SamplesOf<Sample>>(samples));
  return single_changes(quantity, right.text, AtSamples(any_formula(truth, samples), letters.samples()),
                        letters, known);
}

}  // namespace oddity
