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
/// {R"(\mathbf r)", {1, 2, 0}}, {"dV/dr", 2}, {"m_{12}", 3}. The longest that fits is taken. Four or nine
/// numbers are a square matrix, by rows.
using TypesetLetters = std::vector<std::pair<std::string, Value>>;

/// The first of these letters, "$m_2$ = 1.25, $g$ = 9.81", with all digits.
std::string told(const TypesetLetters&, std::size_t count);

/// What a formula of TeX is: m_2g-c_1(S_1-L_1). Nothing where it is anything else than numbers, these
/// letters, sums, products, fractions, powers, roots, elementary functions, absolute values, tuples,
/// matrices, the dot and cross products of these, and
///   \sum_i m_ix_i, \sum m_ix_i     over all indices that there are letters of, of the product that follows
///   e_{ijk}g_jf_k                  in index notation, over 0, 1, 2; f_i alone is a vector, a_{rc} a matrix
///   \frac{d}{dt}(m\dot x)          along the letters' rates \dot x, \ddot x, of the factor that follows
///   \int_0^T f\,dt                between numbers, by Gauss's rule
///   \int f\,ds                     along a curve, by nodes: ds and others are ten numbers or more
///   \sum_\sigma a_{\sigma(1)1}     over permutations, of the sign \varepsilon_\sigma
///   x\pm y, x\mp y                 where \pm is a letter, 1 or -1
/// A quotient's bar / is over the one factor that follows; a function without parentheses is of what follows
/// it up to \,, a sign, another function, or a letter with a dot.
std::optional<Value> typeset_value(std::string_view formula, const TypesetLetters&);

/// Whether it is so, \ddot q<0 or x_1=x_2=0, and for tuples in every component; equal is to a billionth of
/// the terms that are added up. Nothing where a side is none that is known, or there is but one.
std::optional<bool> typeset_relation(std::string_view formula, const TypesetLetters&);

/// Whether all of the text is one formula.
bool is_formula(std::string_view text);

/// A text beside what is computed under it.
struct Typesetting {
  bool read = false;            ///< it is a formula of the letters that are known, and what is computed
  std::string difference = {};  ///< what it is instead
  /// Where it is one side of an equation that is computed: what another side is instead. An equation that is
  /// not true has this too.
  std::string unequal = {};
};

/// A text, some samples' letters, and what is computed at each. An equation may stand for one of its sides,
/// but not for the lone letter on its left, for several of them in a row, or for what two differ by.
Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, Value>>& computed);

/// A text, some samples' letters, and whether it is said to be so of each.
Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, bool>>& said);

/// Whether it has been read. Throws std::logic_error where it is something else.
bool is_as_typeset(const Typesetting&);

}  // namespace oddity
