#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "chapters/exercise.hpp"

/// Formulas as a page has them, computed: so that what is typeset beside a function is what that computes.
namespace oddity {

/// The letters of a sample as they are typeset, with what they are there: {R"(\dot\theta)", 0.3},
/// {R"(\mathbf r)", {1, 2, 0}}, {"dV/dr", 2}. The longest that fits is taken.
using TypesetLetters = std::vector<std::pair<std::string, Value>>;

/// The first of these letters, "$m_2$ = 1.25, $g$ = 9.81", with all digits.
std::string told(const TypesetLetters&, std::size_t count);

/// What a formula of TeX is: m_2g-c_1(S_1-L_1). Nothing where it is anything else than numbers, these
/// letters, sums, products, fractions, powers, roots, elementary functions, absolute values, tuples, and the
/// dot and cross products of these. A quotient's bar / is over the one factor that follows; a function
/// without parentheses is of what follows it up to \,, a sign, another function, or a letter with a dot.
std::optional<Value> typeset_value(std::string_view formula, const TypesetLetters&);

/// Whether all of the text is one formula.
bool is_formula(std::string_view text);

/// A text beside what is computed under it.
struct Typesetting {
  bool read = false;            ///< it is a formula of the letters that are known, and what is computed
  std::string difference = {};  ///< what it is instead
};

/// A text, some samples' letters, and what is computed at each. An equation may stand for one of its sides,
/// or for what they differ by.
Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, Value>>& computed);

/// Whether it has been read. Throws std::logic_error where it is something else.
bool is_as_typeset(const Typesetting&);

}  // namespace oddity
