// Compares typeset formulas with the values computed for them.

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "chapters/typeset.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace {

std::string written(const Value& x) {
  std::string all;
  for (const double component : x) all += (all.empty() ? "" : ", ") + format_shortest(component);
  return "(" + all + ")";
}

bool is_zero(const Value& x) { return x.size() == 1 && x[0] == 0; }

/// a - b; a single 0 is a zero of any size.
std::optional<Value> difference(const std::optional<Value>& a, const std::optional<Value>& b) {
  if (!a || !b) return std::nullopt;
  if (is_zero(*b)) return a;
  Value y = is_zero(*a) ? Value(std::vector<double>(b->size())) : *a;
  if (y.size() != b->size()) return std::nullopt;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] -= (*b)[i];
  return y;
}

using Values = std::vector<std::optional<Value>>;

/// Possible values of a formula or an equation.
struct Meanings {
  Values sides;   ///< one for each side, except a single letter on the left that names the rest
  Values others;  ///< differences of two sides, and several sides in a row

  Values all() const {
    Values both = sides;
    both.insert(both.end(), others.begin(), others.end());
    return both;
  }
};

std::optional<Value> in_a_row(const Values& sides, std::size_t first, std::size_t end) {
  std::vector<double> all;
  for (std::size_t i = first; i < end; ++i) {
    if (!sides[i]) return std::nullopt;
    all.insert(all.end(), sides[i]->begin(), sides[i]->end());
  }
  return all;
}

/// The sides of an equation or another relation, parsed once for all samples that have these letters.
class Sides {
 public:
  Sides(const std::string& formula, formula::Names names)
      : names_(std::move(names)), split_(formula::sides_of(formula)) {
    for (const std::string& side : split_.sides) trees_.push_back(typeset_tree(side, names_));
  }
  bool are_in(const TypesetLetters& letters) const {
    return std::ranges::equal(names_, letters, {}, {}, &TypesetLetters::value_type::first);
  }

  const std::vector<std::string>& relations() const { return split_.relations; }
  Values values(const TypesetLetters& letters) const {
    const auto known = values_of(letters);
    Values all;
    for (const auto& tree : trees_) all.push_back(tree ? typeset_value(*tree, known) : std::nullopt);
    return all;
  }
  std::optional<Value> value(std::size_t side, const TypesetLetters& letters) const {
    const auto& tree = trees_[side];
    return tree ? typeset_value(*tree, values_of(letters)) : std::nullopt;
  }

  /// For equations only.
  Meanings meanings(const TypesetLetters& letters) const {
    Values all = values(letters);
    const std::size_t n = all.size();
    if (n < 2) return {all, {}};
    Values others{in_a_row(all, 0, n)};
    if (n == 2)
      others.push_back(difference(all[0], all[1]));
    else
      others.insert(others.end(), {in_a_row(all, 1, n), in_a_row(all, 0, n - 1)});
    if (std::ranges::find(names_, split_.sides[0]) != names_.end()) all.erase(all.begin());
    return {all, others};
  }

 private:
  formula::Names names_;
  formula::Sides split_;
  std::vector<std::optional<formula::Tree>> trees_;
};

/// Caches the parsed sides of an equation, for samples that have the same letters.
class InLetters {
 public:
  explicit InLetters(std::string formula) : formula_(std::move(formula)) {}
  const Sides& operator()(const TypesetLetters& letters) {
    if (!sides_ || !sides_->are_in(letters)) sides_.emplace(formula_, names_of(letters));
    return *sides_;
  }

 private:
  std::string formula_;
  std::optional<Sides> sides_;
};

/// Size of the terms that are added up: the change of a value per relative change of its letters.
template <class F>
double size_of_terms(const F& value_in, const TypesetLetters& letters) {
  constexpr double change = 0x1p-20;
  const Value value = *value_in(letters);
  double size = 0;
  TypesetLetters moved = letters;
  for (auto& [letter, x] : moved)
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double before = std::exchange(x[i], x[i] * (1 + change));
      if (const auto now = value_in(moved)) size += distance(*now, value) / change;
      x[i] = before;
    }
  return size;
}

enum class Match { same, unread, other };

/// A single number if all components are equal, as they are if a number is computed several times.
Value once(const Value& computed, double allowed) {
  const Value repeated(std::vector<double>(computed.size(), computed[0]));
  return distance(computed, repeated) <= allowed ? Value(computed[0]) : computed;
}

Match match(const std::optional<Value>& typeset, const Value& computed, double allowed) {
  const auto off = difference(typeset, computed);
  return !off ? Match::unread : size_of(*off) <= allowed ? Match::same : Match::other;
}

}  // namespace

std::string listed(const TypesetLetters& letters, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < std::min(count, letters.size()); ++i) {
    const auto& [letter, value] = letters[i];
    all += (all.empty() ? "$" : ", $") + letter +
           "$ = " + (value.size() == 1 ? format_shortest(value[0]) : written(value));
  }
  return all;
}

Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, Value>>& computed) {
  if (!is_formula(text)) return {};
  double largest = 0;
  for (const auto& [letters, value] : computed)
    if (finite(value)) largest = std::max(largest, size_of(value));
  // Terms added in another order differ by roundings, which may be larger than the sum. Another formula
  // differs by far more.
  constexpr double precision = 1e-9;
  const double allowed = precision * largest;
  std::string formula = text.substr(1, text.size() - 2);
  while (formula.starts_with('=')) formula.erase(0, 1);

  InLetters in_letters(formula);
  std::vector<Match> matches;
  std::size_t sides = 0;
  std::string seen, unequal;
  for (const auto& [letters, numbers] : computed) {
    if (!finite(numbers)) continue;
    const Sides& equation = in_letters(letters);
    if (std::ranges::count(equation.relations(), "=") < std::ssize(equation.relations())) return {};
    const Meanings may_be = equation.meanings(letters);
    const Values all = may_be.all();
    sides = may_be.sides.size();
    const bool is_number = sides == 1 && all[0] && all[0]->size() == 1;
    const Value value = is_number ? once(numbers, allowed) : numbers;
    matches.resize(all.size(), Match::same);
    for (std::size_t i = 0; i < all.size(); ++i) {
      Match found = match(all[i], value, allowed);
      const auto meaning = [&](const TypesetLetters& moved) { return equation.meanings(moved).all()[i]; };
      if (found == Match::other)
        found = match(all[i], value, allowed + precision * size_of_terms(meaning, letters));
      if (found == Match::other && i < sides) {
        seen = written(*all[i]) + ", and " + written(value) + " is computed";
        if (size_of(*all[i]) > 0)
          unequal = text + " is typeset, and one side is " + seen;  // = 0 is for motions
      }
      if (matches[i] == Match::same) matches[i] = found;
    }
  }
  const bool is_it = std::ranges::count(matches, Match::same) > 0;
  matches.resize(sides);
  const bool is_a_side = std::ranges::count(matches, Match::same) > 0;
  if (is_it) return {true, "", is_a_side ? unequal : ""};
  if (matches.empty() || std::ranges::count(matches, Match::unread) > 0) return {};
  return {false, text + " is typeset, which is " + seen, ""};
}

namespace {

bool holds(const Value& left, const std::string& relation, const Value& right,
           const std::function<double()>& terms) {
  constexpr double precision = 1e-9;
  const std::optional<Value> off = difference(left, right);
  if (relation == "=" || relation == R"(\ne)")
    return (size_of(*off) == 0 || size_of(*off) <= precision * terms()) == (relation == "=");
  return std::ranges::all_of(*off, [&](double x) {
    return relation == "<" ? x < 0 : relation == ">" ? x > 0 : relation == R"(\le)" ? x <= 0 : x >= 0;
  });
}

}  // namespace

namespace {

std::optional<bool> is_so(const Sides& relation, const TypesetLetters& letters) {
  const std::size_t n = relation.relations().size();
  const Values sides = relation.values(letters);
  bool so = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (!difference(sides[i], sides[i + 1])) return std::nullopt;
    const auto terms = [&] {
      double size = 0;
      for (const std::size_t side : {i, i + 1})
        size +=
            size_of_terms([&](const TypesetLetters& moved) { return relation.value(side, moved); }, letters);
      return size;
    };
    so = so && holds(*sides[i], relation.relations()[i], *sides[i + 1], terms);
  }
  return n == 0 ? std::nullopt : std::optional(so);
}

}  // namespace

struct TypesetRelation::Read {
  InLetters sides;
};

TypesetRelation::TypesetRelation(std::string_view text)
    : read_(std::make_shared<Read>(Read{InLetters(std::string(text))})) {}

std::optional<bool> TypesetRelation::operator()(const TypesetLetters& letters) const {
  return is_so(read_->sides(letters), letters);
}

Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, bool>>& said) {
  if (!is_formula(text)) return {};
  InLetters in_letters(text.substr(1, text.size() - 2));
  for (const auto& [letters, so] : said) {
    const std::optional<bool> typeset = is_so(in_letters(letters), letters);
    if (!typeset) return {};
    if (*typeset != so)
      return {false, text + " is typeset, which is " + (so ? "not so" : "so") + " at " + listed(letters, 4),
              ""};
  }
  return {!said.empty(), "", ""};
}

bool is_as_typeset(const Typesetting& typesetting) {
  if (!typesetting.difference.empty()) throw std::logic_error(typesetting.difference);
  return typesetting.read;
}

}  // namespace oddity
