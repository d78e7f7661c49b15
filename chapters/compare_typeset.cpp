// What is typeset beside what is computed under it.

#include <algorithm>
#include <array>
#include <cctype>
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

/// A lone 0 is zero of any kind.
std::optional<Value> difference(const std::optional<Value>& a, const std::optional<Value>& b) {
  if (!a || !b) return std::nullopt;
  if (is_zero(*b)) return a;
  Value y = is_zero(*a) ? Value(std::vector<double>(b->size())) : *a;
  if (y.size() != b->size()) return std::nullopt;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] -= (*b)[i];
  return y;
}

using Values = std::vector<std::optional<Value>>;

/// What a formula or an equation may stand for.
struct Meanings {
  Values sides;   ///< each, but not the letter that it is called by on the left
  Values others;  ///< what two sides differ by, and sides in a row

  Values all() const {
    Values both = sides;
    both.insert(both.end(), others.begin(), others.end());
    return both;
  }
};

bool is_lone_letter(const std::string& side, const TypesetLetters& letters) {
  return std::ranges::find(letters, side, &TypesetLetters::value_type::first) != letters.end();
}

std::optional<Value> in_a_row(const Values& sides, std::size_t first, std::size_t end) {
  std::vector<double> all;
  for (std::size_t i = first; i < end; ++i) {
    if (!sides[i]) return std::nullopt;
    all.insert(all.end(), sides[i]->begin(), sides[i]->end());
  }
  return all;
}

/// At its equals signs, or where it tends to something.
std::vector<std::string> sides_of(std::string formula) {
  std::vector<std::string> sides;
  if (const std::size_t limit = formula.find(R"(\to)");
      limit < formula.size() && std::isalpha(static_cast<unsigned char>(formula[limit + 3])) == 0)
    formula.replace(limit, 3, "=");
  for (std::size_t begin = 0; begin <= formula.size();) {
    const std::size_t end = std::min(formula.find('=', begin), formula.size());
    if (end > begin) sides.push_back(formula.substr(begin, end - begin));
    begin = end + 1;
  }
  return sides;
}

Meanings meanings(const std::string& formula, const TypesetLetters& letters) {
  const std::vector<std::string> sides = sides_of(formula);
  Values all;
  for (const std::string& side : sides) all.push_back(typeset_value(side, letters));
  const std::size_t n = all.size();
  if (n < 2) return {all, {}};
  Values others{in_a_row(all, 0, n)};
  if (n == 2)
    others.push_back(difference(all[0], all[1]));
  else
    others.insert(others.end(), {in_a_row(all, 1, n), in_a_row(all, 0, n - 1)});
  if (is_lone_letter(sides[0], letters)) all.erase(all.begin());
  return {all, others};
}

/// The size of the terms that are added up, in each of the meanings: how much it changes with the letters'
/// relative change.
double size_of_terms(const std::string& formula, const TypesetLetters& letters, std::size_t meaning) {
  constexpr double change = 0x1p-20;
  const Value value = *meanings(formula, letters).all()[meaning];
  double size = 0;
  TypesetLetters moved = letters;
  for (auto& [letter, x] : moved)
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double before = std::exchange(x[i], x[i] * (1 + change));
      if (const auto now = meanings(formula, moved).all()[meaning]) size += distance(*now, value) / change;
      x[i] = before;
    }
  return size;
}

enum class Match { same, unread, other };

/// A number that is computed several times over is one number.
Value once(const Value& computed, double allowed) {
  const Value repeated(std::vector<double>(computed.size(), computed[0]));
  return distance(computed, repeated) <= allowed ? Value(computed[0]) : computed;
}

Match match(const std::optional<Value>& typeset, const Value& computed, double allowed) {
  const auto off = difference(typeset, computed);
  return !off ? Match::unread : size_of(*off) <= allowed ? Match::same : Match::other;
}

}  // namespace

std::string told(const TypesetLetters& letters, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < std::min(count, letters.size()); ++i) {
    const auto& [letter, value] = letters[i];
    all += (all.empty() ? "$" : ", $") + letter +
           "$ = " + (value.size() == 1 ? format_shortest(value[0]) : written(value));
  }
  return all;
}

bool is_formula(std::string_view text) {
  return text.size() > 2 && text.front() == '$' && text.find('$', 1) == text.size() - 1;
}

Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, Value>>& computed) {
  if (!is_formula(text)) return {};
  double largest = 0;
  for (const auto& [letters, value] : computed)
    if (finite(value)) largest = std::max(largest, size_of(value));
  // What is added up in another order differs by roundings of terms that may cancel; another formula by far
  // more.
  constexpr double precision = 1e-9;
  const double allowed = precision * largest;
  const std::string formula = text.substr(1, text.size() - 2);

  std::vector<Match> matches;
  std::size_t sides = 0;
  std::string seen, unequal;
  for (const auto& [letters, numbers] : computed) {
    if (!finite(numbers)) continue;
    const Meanings may_be = meanings(formula, letters);
    const Values all = may_be.all();
    sides = may_be.sides.size();
    const bool is_number = sides == 1 && all[0] && all[0]->size() == 1;
    const Value value = is_number ? once(numbers, allowed) : numbers;
    matches.resize(all.size(), Match::same);
    for (std::size_t i = 0; i < all.size(); ++i) {
      Match found = match(all[i], value, allowed);
      if (found == Match::other)
        found = match(all[i], value, allowed + precision * size_of_terms(formula, letters, i));
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

constexpr std::array<std::string_view, 6> relations{R"(\le)", R"(\ge)", R"(\ne)", "=", "<", ">"};

/// x<0<y: what stands between the relations, and these; \left is none.
struct Sentence {
  std::vector<std::string> sides{""}, relations;
};

Sentence sentence_of(std::string_view formula) {
  Sentence sentence;
  while (!formula.empty()) {
    const auto begins = [&](std::string_view relation) {
      const bool goes_on = relation.size() > 1 && relation.size() < formula.size() &&
                           std::isalpha(static_cast<unsigned char>(formula[relation.size()])) != 0;
      return formula.starts_with(relation) && !goes_on;
    };
    const auto relation = std::ranges::find_if(relations, begins);
    if (relation == relations.end()) {
      sentence.sides.back() += formula.front();
      formula.remove_prefix(1);
    } else {
      sentence.relations.emplace_back(*relation);
      sentence.sides.emplace_back();
      formula.remove_prefix(relation->size());
    }
  }
  return sentence;
}

bool holds(const Value& left, const std::string& relation, const Value& right,
           const std::function<double()>& terms) {
  constexpr double precision = 1e-9;
  const std::optional<Value> off = difference(left, right);
  if (relation == "=" || relation == R"(\ne)")
    return (size_of(*off) <= precision * terms()) == (relation == "=");
  return std::ranges::all_of(*off, [&](double x) {
    return relation == "<" ? x < 0 : relation == ">" ? x > 0 : relation == R"(\le)" ? x <= 0 : x >= 0;
  });
}

}  // namespace

std::optional<bool> typeset_relation(std::string_view formula, const TypesetLetters& letters) {
  const Sentence sentence = sentence_of(formula);
  const std::size_t n = sentence.relations.size();
  Values sides;
  for (const std::string& side : sentence.sides) sides.push_back(typeset_value(side, letters));
  bool so = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (!difference(sides[i], sides[i + 1])) return std::nullopt;
    const auto terms = [&] {
      return size_of_terms(sentence.sides[i], letters, 0) + size_of_terms(sentence.sides[i + 1], letters, 0);
    };
    so = so && holds(*sides[i], sentence.relations[i], *sides[i + 1], terms);
  }
  return n == 0 ? std::nullopt : std::optional(so);
}

Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, bool>>& said) {
  if (!is_formula(text)) return {};
  for (const auto& [letters, so] : said) {
    const std::optional<bool> typeset = typeset_relation(text.substr(1, text.size() - 2), letters);
    if (!typeset) return {};
    if (*typeset != so)
      return {false, text + " is typeset, which is " + (so ? "not so" : "so") + " at " + told(letters, 4),
              ""};
  }
  return {!said.empty(), "", ""};
}

bool is_as_typeset(const Typesetting& typesetting) {
  if (!typesetting.difference.empty()) throw std::logic_error(typesetting.difference);
  return typesetting.read;
}

}  // namespace oddity
