#include "chapters/typeset.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "formula/evaluate.hpp"
#include "formula/magnitude.hpp"
#include "formula/tokens.hpp"

namespace oddity {

formula::Names names_of(const TypesetLetters& letters) {
  formula::Names names;
  for (const auto& [name, value] : letters) names.push_back(name);
  return names;
}

std::vector<formula::Matrix<double>> values_of(const TypesetLetters& letters) {
  std::vector<formula::Matrix<double>> values;
  for (const auto& [name, value] : letters)
    values.push_back(formula::of_letter(std::vector<double>(value.begin(), value.end())));
  return values;
}

std::optional<formula::Tree> typeset_tree(std::string_view formula, const formula::Names& names) {
  try {
    return formula::parse_tex(formula, names);
  } catch (const formula::Unreadable&) {
    return std::nullopt;
  }
}

std::optional<Value> typeset_value(const formula::Tree& tree,
                                   const std::vector<formula::Matrix<double>>& letters) {
  try {
    return Value(formula::evaluate(tree, letters).entries);
  } catch (const formula::NoValue&) {
    return std::nullopt;
  }
}

std::optional<Value> typeset_value(std::string_view formula, const TypesetLetters& letters) {
  const auto tree = typeset_tree(formula, names_of(letters));
  return tree ? typeset_value(*tree, values_of(letters)) : std::nullopt;
}

void in_a_row(Value& a, Value& b) {
  Value& lone = a.size() == 1 ? a : b;
  const std::size_t n = std::max(a.size(), b.size());
  if (lone.size() == 1 && n > 1) lone = std::vector<double>(n, lone[0]);
}

namespace {

/// Whether a side is only a name: v, \ddot q_1, I_{xx}', W(T), \mathrm{period}.
bool is_name(const std::string& side) {
  const formula::Tokens tokens = formula::tex_tokens(side);
  std::size_t at = 0;
  const auto next = [&](std::size_t ahead = 0) -> std::string {
    return at + ahead < tokens.size() ? tokens[at + ahead].text : "";
  };
  const auto is_letter = [](const std::string& token) {
    return !token.empty() && std::isalpha(static_cast<unsigned char>(token.back())) != 0;
  };
  while (next() == R"(\dot)" || next() == R"(\ddot)" || next() == R"(\mathbf)") ++at;
  if (next() == R"(\mathrm)" && next(1) == "{") {
    while (at < tokens.size() && next() != "}") ++at;
    return at + 1 == tokens.size();
  }
  if (!is_letter(next())) return false;
  ++at;
  if (next() == "_") {
    at += 2;
    if (at <= tokens.size() && tokens[at - 1].text == "{")
      while (at < tokens.size() && tokens[at - 1].text != "}") ++at;
  }
  while (next() == "'") ++at;
  if (next() == "(" && is_letter(next(1)) && next(2) == ")") at += 3;
  return at == tokens.size();
}

void mark_used(const formula::Tree& tree, std::vector<bool>& used) {
  for (const formula::Entry& entry : tree->entries) {
    for (const int letter : entry.rates) used[static_cast<std::size_t>(letter)] = true;
    if (entry.along >= 0) used[static_cast<std::size_t>(entry.along)] = true;
  }
  for (const formula::Tree& child : tree->children) mark_used(child, used);
}

}  // namespace

std::vector<formula::Tree> TypesetFormula::sides(const formula::Names& names) const {
  if (!is_formula(text_))
    throw std::logic_error("'" + text_ + "' is not a formula, and has no code for its value");
  const formula::Sides split = formula::sides_of(text_.substr(1, text_.size() - 2));
  if (std::ranges::count(split.relations, "=") < std::ssize(split.relations) || split.sides.size() > 2)
    throw std::logic_error(text_ + " is neither one formula nor one equation");
  std::vector<formula::Tree> sides;
  const bool called = split.sides.size() == 2 && (split.sides[0].empty() || is_name(split.sides[0]));
  for (std::size_t i = called ? 1 : 0; i < split.sides.size(); ++i)
    sides.push_back(formula::parse_tex(split.sides[i], names));
  if (sides.size() == 2 && formula::is_number(sides[0], "0")) std::swap(sides[0], sides[1]);
  return sides;
}

Value TypesetFormula::value(const std::vector<formula::Tree>& sides, const Values& letters) {
  formula::Matrix<double> value = formula::evaluate(sides.at(0), letters);
  if (sides.size() > 1 && !formula::is_number(sides[1], "0"))
    value = formula::added(std::move(value), formula::evaluate(sides[1], letters), true);
  return Value(std::move(value.entries));
}

std::vector<bool> TypesetFormula::used(const std::vector<formula::Tree>& sides, std::size_t letters) {
  std::vector<bool> used(letters);
  for (const formula::Tree& side : sides) mark_used(side, used);
  return used;
}

const TypesetFormula::Read& TypesetFormula::read(const TypesetLetters& letters) const {
  if (!read_ || !std::ranges::equal(read_->names, letters, {}, {}, &TypesetLetters::value_type::first)) {
    Read read{names_of(letters), {}, {}};
    read.sides = sides(read.names);
    read.used = used(read.sides, letters.size());
    read_ = std::make_shared<const Read>(std::move(read));
  }
  return *read_;
}

double TypesetFormula::cancelling(const std::vector<formula::Tree>& sides, const Values& letters) {
  double size = 0;
  if (sides.size() > 1)
    for (const formula::Tree& side : sides) size += formula::magnitude(side, letters);
  return size;
}

double TypesetFormula::cancelling(const TypesetLetters& letters) const {
  return cancelling(read(letters).sides, values_of(letters));
}

Value TypesetFormula::operator()(const TypesetLetters& letters) const {
  const Read& known = read(letters);
  // Only used letters: a sample has many, and this is called often.
  std::vector<formula::Matrix<double>> values(letters.size());
  for (std::size_t i = 0; i < letters.size(); ++i)
    if (known.used[i])
      values[i] = formula::of_letter(std::vector<double>(letters[i].second.begin(), letters[i].second.end()));
  try {
    return value(known.sides, values);
  } catch (const formula::NoValue& reason) {
    throw std::logic_error(text_ + " has no value: " + reason.what());
  }
}

}  // namespace oddity
