#include "chapters/formulas.hpp"

#include <algorithm>
#include <numeric>

namespace oddity {

namespace {

/// A text alone, at samples whose letters have other names at each.
class TextCode final : public AnyCode {
 public:
  TextCode(std::string text, const AnySamples& samples) : typeset_(std::move(text)), samples_(samples) {}

  Value value(std::size_t i) const override { return typeset_(samples_.typeset(i, 0)); }
  double terms(std::size_t i) const override { return typeset_.cancelling(samples_.typeset(i, 0)); }
  double size(std::size_t i, const Value& value) const override {
    double size = size_of(value) + terms(i);
    const std::size_t letters = samples_.letters(i);
    for (std::size_t k = 1; k <= letters; ++k)
      size += distance(typeset_(samples_.typeset(i, k)), value) / small_change;
    return size;
  }

 private:
  TypesetFormula typeset_;
  const AnySamples& samples_;
};

}  // namespace

// ---- the letters ------------------------------------------------------------------------------------------

LettersAtSamples::LettersAtSamples(std::unique_ptr<const AnySamples> samples)
    : samples_(std::move(samples)), all_(samples_->count()) {}

bool LettersAtSamples::are_of(const AnySamples& samples) const {
  bool are = all_.size() == samples.count();
  if (!samples_->is_typeset()) return are;
  for (std::size_t i = 0; are && i < all_.size(); ++i) {
    if (all_[i].empty() || all_[i][0].empty()) continue;
    const TypesetLetters letters = samples.typeset(i, 0);
    are = (!names_ || names_->empty() || names_of(letters) == *names_) &&
          std::ranges::equal(values_of(letters), all_[i][0], {}, &formula::Matrix<double>::entries,
                             &formula::Matrix<double>::entries);
  }
  return are;
}

const formula::Names& LettersAtSamples::names() const {
  if (samples_->is_typeset() && !names_ && !all_.empty()) {
    names_ = names_of(samples_->typeset(0, 0));
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (!std::ranges::equal(samples_->typeset(i, 0), *names_, {}, &TypesetLetters::value_type::first)) {
        names_.emplace();
        break;
      }
  }
  return names_ ? *names_ : names_.emplace();
}

const TypesetFormula::Values& LettersAtSamples::of(std::size_t i, std::size_t which) const {
  auto& known = all_[i];
  if (known.empty()) known.resize(count(i) + 1);
  if (samples_->is_typeset() && known[which].empty()) known[which] = values_of(samples_->typeset(i, which));
  return known[which];
}

// ---- a formula --------------------------------------------------------------------------------------------

AtSamples::AtSamples(AnyFormula formula, const AnySamples& samples)
    : text_(std::move(formula.text)),
      samples_(samples),
      code_(std::move(formula.code)),
      values_(samples.count()),
      sizes_(samples.count()) {
  if (code_ || text_.empty()) return;
  if (!samples.is_typeset())
    throw std::logic_error("'" + text_ + "' is not computed, and its samples have no typeset letters");
  code_ = std::make_shared<TextCode>(text_, samples);
}

AtSamples::AtSamples(std::string text, std::vector<formula::Tree> sides, const LettersAtSamples& letters)
    : text_(std::move(text)),
      samples_(letters.samples()),
      letters_(&letters),
      sides_(std::move(sides)),
      values_(samples_.count()),
      sizes_(samples_.count()) {}

const Value& AtSamples::value(std::size_t i) const {
  auto& known = values_[i];
  if (!known) known = letters_ ? TypesetFormula::value(sides_, letters_->at(i)) : code().value(i);
  return *known;
}

double AtSamples::size(std::size_t i) const {
  auto& known = sizes_[i];
  if (!known) known = size_at(i);
  return *known;
}

double AtSamples::terms(std::size_t i) const {
  return letters_ ? TypesetFormula::cancelling(sides_, letters_->at(i)) : code().terms(i);
}

const AnyCode& AtSamples::code() const {
  if (!code_) throw std::logic_error("a formula without text and code has no value");
  return *code_;
}

double AtSamples::size_at(std::size_t i) const {
  if (!letters_) return code().size(i, value(i));
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

AtSamples at_samples(const AnyFormula& formula, const LettersAtSamples& letters) {
  if (formula.is_text())
    if (const formula::Names& names = letters.names(); !names.empty())
      return {formula.text, TypesetFormula(formula.text).sides(names), letters};
  return {formula, letters.samples()};
}

// ---- comparison -------------------------------------------------------------------------------------------

Check compare(std::string quantity, const AtSamples& left, const AtSamples& right,
              const std::vector<std::size_t>& numbers) {
  const AnySamples& samples = right.samples();
  std::vector<Value> lefts, rights;
  double largest = 0;
  bool left_is_zero = true, right_is_zero = true;
  for (const std::size_t i : numbers) {
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
    if (with_zero)
      if (const auto own = samples.size(i)) return *own;
    if (samples.is_lettered()) return std::max(left.size(i), right.size(i));
    return std::max(left.terms(i), right.terms(i)) + largest * samples.conditioning(i);
  };
  WorstSample worst(std::move(quantity), left.text(), right.text());
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const std::size_t i = numbers[n];
    const double scale = size(i);
    if (const auto own = samples.tolerance(i, scale))
      worst.add(lefts[n], rights[n], *own, scale, samples.where(i));
    else
      worst.add(lefts[n], rights[n], scale, samples.where(i));
  }
  return worst.check();
}

static std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

Check compare(std::string quantity, const AtSamples& left, const AtSamples& right) {
  return compare(std::move(quantity), left, right, first(right.samples().count()));
}

Typesetting compare_typeset(const AnyFormula& formula, const AnySamples& samples) {
  if (!samples.is_typeset()) return {};
  constexpr std::size_t enough = 8;
  const AtSamples at(formula, samples);
  std::vector<std::pair<TypesetLetters, Value>> computed;
  for (std::size_t i = 0; i < std::min(enough, samples.count()); ++i)
    if (const TypesetLetters letters = samples.typeset(i, 0); !letters.empty())
      computed.emplace_back(letters, at.value(i));
  return compare_typeset(formula.text, computed);
}

std::vector<Reading> single_changes(const std::string& quantity, const std::string& right,
                                    const AtSamples& truth, const LettersAtSamples& letters,
                                    const std::string& known, std::size_t exact) {
  std::vector<Reading> readings;
  const AnySamples& samples = truth.samples();
  if (!samples.is_typeset()) return readings;
  constexpr std::size_t enough = 16;
  const std::vector<std::size_t> some = first(std::min(enough, samples.count()));
  std::vector<TypesetSample> typeset;
  for (const std::size_t i : some) typeset.push_back({samples.typeset(i, 0), truth.value(i)});
  const Changes changes = changes_of(TypesetFormula(right), typeset, exact);
  const std::size_t count = changes.hardest_first.size();
  std::size_t holding = 0, beyond = 0;
  for (const ChangedFormula& changed : changes.hardest_first) {
    if (!readings.empty() && changed.roundings > clear) break;
    if (changed.roundings > clear && ++beyond > exact)
      return single_changes(quantity, right, truth, letters, known, std::string::npos);
    const AtSamples formula(
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
  return readings;
}

}  // namespace oddity
