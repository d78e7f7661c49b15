#include "chapters/claims.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "reference/text.hpp"

namespace oddity {

namespace {

struct Written {
  double number;
  int decimals;
};

Written read(const std::string& written) {
  std::string digits = written;
  std::erase(digits, '$');
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size())
    throw std::logic_error("'" + written + "' is no number");
  const auto point = digits.find('.'), power = digits.find_first_of("eE");
  int decimals =
      point == std::string::npos ? 0 : static_cast<int>(std::min(power, digits.size()) - point) - 1;
  if (power != std::string::npos) decimals -= std::stoi(digits.substr(power + 1));
  return {number, decimals};
}

}  // namespace

Check as_written(std::string quantity, const std::string& written, const Route& truth) {
  const Written x = read(written);
  return {std::move(quantity), {"as written, " + written, x.number}, truth, printed_decimals(x.decimals)};
}

Check as_cut_off(std::string quantity, const std::string& written, const Route& truth) {
  const Written x = read(written);
  const double half = std::copysign(0.5 * std::pow(10.0, -x.decimals), x.number);
  return {std::move(quantity),
          {"the middle of the numbers that begin with " + written, x.number + half},
          truth,
          printed_decimals(x.decimals)};
}

std::pair<std::string, std::string> sides_of_equation(const std::string& text) {
  std::vector<std::string> sides;
  const std::string first = text.substr(0, text.find('$', 1) + 1);
  if (is_formula(first)) sides = formula::sides_of(first.substr(1, first.size() - 2)).sides;
  if (sides.size() < 2) throw std::logic_error(text + " is no equation $a=b$");
  std::string right = sides[1];
  for (std::size_t i = 2; i < sides.size(); ++i) right += ",\\ " + sides[i];
  return {"$" + sides[0] + "$", sides.size() == 2 ? "$" + right + "$" : "$(" + right + ")$"};
}

template <class Parts, class Read>
Claims& Claims::judged(std::string_view slug, int line, std::string says, const Parts& parts, Reading in_view,
                       const Read& read) {
  Claim claim{.printed = read(parts.printed),
              .meant = read(parts.meant),
              .corrected = read(parts.corrected),
              .in_view = std::move(in_view),
              .why = parts.why,
              .kind = parts.kind,
              .root = parts.root};
  for (const auto& near : parts.near_misses) claim.near_misses.push_back(read(near));
  return add(slug, line, std::move(says), std::move(claim));
}

const LettersAtSamples& Claims::letters_of(std::unique_ptr<const AnySamples> samples) {
  auto& known = letters_[{samples->address(), samples->type()}];
  if (!known || !known->are_of(*samples)) known = std::make_unique<LettersAtSamples>(std::move(samples));
  return *known;
}

Claims& Claims::formula(std::string_view slug, int line, std::string says,
                        std::unique_ptr<const AnySamples> samples, const AnyFormulaClaim& parts) {
  const std::string quantity = parts.quantity.empty() ? says : parts.quantity;
  const LettersAtSamples& letters = letters_of(std::move(samples));
  const AtSamples truth = at_samples(parts.truth, letters);
  std::vector<AtSamples> other_routes;
  for (const AnyFormula& route : parts.other_routes) other_routes.push_back(at_samples(route, letters));
  Reading in_view;
  if (!parts.in_view.seen.empty())
    in_view = {parts.in_view.text,
               {compare(quantity, at_samples(parts.printed, letters), truth, parts.in_view.seen)}};
  judged(slug, line, std::move(says), parts, in_view, [&](const AnyFormula& formula) -> Reading {
    if (formula.is_missing()) return {};
    // A text alone is its own code, but an equation's sides may have values in the letters.
    const bool is_own = formula.is_text() && is_formula(formula.text) &&
                        formula::sides_of(formula.text.substr(1, formula.text.size() - 2)).relations.empty();
    const AtSamples here = at_samples(formula, letters);
    const Typesetting typeset =
        is_own ? Typesetting{true, "", ""} : compare_typeset(formula, letters.samples());
    Reading reading{formula.text, {compare(quantity, here, truth)}, typeset.read};
    for (const AtSamples& route : other_routes) reading.checks.push_back(compare(quantity, here, route));
    for (const std::string& seen : {typeset.difference, reading.holds() ? typeset.unequal : ""})
      if (!seen.empty()) differences_.push_back(std::string(slug) + ": " + seen);
    return reading;
  });
  const AnyFormula& right = !parts.meant.text.empty()       ? parts.meant
                            : !parts.corrected.text.empty() ? parts.corrected
                                                            : parts.printed;
  if (right.is_text())
    for (Reading& one : single_changes(quantity, right.text, truth, letters, parts.changes_that_hold))
      claims_.back().near_misses.push_back(std::move(one));
  return *this;
}

namespace {

/// Whether the statement holds for each sample; by default this evaluates its relation.
std::function<bool(std::size_t)> decided(const AnyStatement& statement, const AnySamples& samples) {
  if (statement.holds) return statement.holds;
  if (!samples.is_typeset() || !is_formula(statement.text))
    throw std::logic_error("nothing decides '" + statement.text + "'");
  return [text = statement.text, &samples,
          relation = TypesetRelation(statement.text.substr(1, statement.text.size() - 2))](std::size_t i) {
    const auto so = relation(samples.typeset(i, 0));
    if (!so) throw std::logic_error(text + " is no relation of the sample's letters");
    return *so;
  };
}

Check in_these(const std::string& text, const AnySamples& samples, const std::vector<std::size_t>& numbers,
               const std::function<bool(std::size_t)>& holds) {
  long violations = 0;
  std::string where;
  for (const std::size_t i : numbers) {
    if (holds(i)) continue;
    if (++violations == 1) where = "one of them: " + samples.where(i);
  }
  return no_violations(text + ": cases against it", violations, std::ssize(numbers), where);
}

/// Compares the sentence, if it is an inequality or an equation, with `holds` over the samples.
Typesetting compare_typeset_statement(const std::string& text, const AnySamples& samples,
                                      const std::function<bool(std::size_t)>& holds) {
  if (!samples.is_typeset()) return {};
  constexpr std::size_t enough = 64;
  std::vector<std::pair<TypesetLetters, bool>> said;
  for (std::size_t i = 0; i < std::min(enough, samples.count()); ++i)
    said.emplace_back(samples.typeset(i, 0), holds(i));
  return compare_typeset(text, said);
}

}  // namespace

Claims& Claims::statement(std::string_view slug, int line, std::string says, const AnySamples& samples,
                          const AnyStatementClaim& parts) {
  std::vector<std::size_t> all(samples.count());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Reading in_view;
  if (!parts.in_view.seen.empty())
    in_view = {parts.in_view.text,
               {in_these(parts.printed.text, samples, parts.in_view.seen, decided(parts.printed, samples))}};
  return judged(slug, line, std::move(says), parts, in_view, [&](const AnyStatement& statement) -> Reading {
    if (!statement.holds && statement.text.empty()) return {};
    const auto holds = decided(statement, samples);
    const Typesetting typeset = compare_typeset_statement(statement.text, samples, holds);
    if (!typeset.difference.empty()) differences_.push_back(std::string(slug) + ": " + typeset.difference);
    return {statement.text, {in_these(statement.text, samples, all, holds)}, typeset.read};
  });
}

Claims& Claims::number(std::string_view slug, int line, std::string says, const NumberClaim& parts) {
  const std::string quantity = parts.quantity.empty() ? says : parts.quantity;
  return judged(slug, line, std::move(says), parts, {}, [&](const std::string& written) -> Reading {
    if (written.empty()) return {};
    return {written, {as_written(quantity, written, parts.truth)}};
  });
}

Claims& Claims::add(std::string_view slug, int line, std::string says, Claim parts) {
  parts.id = exercise_ + "-" + std::string(slug);
  parts.line = line;
  parts.says = std::move(says);
  if (parts.kind == Fault::none && !parts.meant.text.empty()) parts.kind = Fault::lost_typography;
  if (parts.kind == Fault::none && !parts.corrected.text.empty())
    parts.kind = parts.in_view.text.empty() ? Fault::formula : Fault::left_out;
  claims_.push_back(std::move(parts));
  return *this;
}

std::vector<Claim> Claims::in_order() const {
  std::string differences;
  for (const std::string& one : differences_) differences += (differences.empty() ? "" : "; ") + one;
  if (!differences.empty()) throw std::logic_error(differences);
  std::vector<Claim> sorted = claims_;
  std::ranges::stable_sort(sorted, {}, &Claim::line);
  return sorted;
}

}  // namespace oddity
