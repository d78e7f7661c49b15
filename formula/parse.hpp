#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formula/tree.hpp"
#include "formula/unreadable.hpp"

namespace oddity::formula {

/// Names of the letters in TeX: "m_2", R"(\dot\theta)", R"(\partial L/\partial y)". The longest match is
/// taken. Evaluation takes a value for each.
using Names = std::vector<std::string>;

/// Reads TeX: m_2g-c_1(S_1-L_1). Throws Unreadable. Reads numbers, letters, sums, products, fractions,
/// powers, roots, elementary functions, absolute values, \max and \min, tuples, matrices, dot and cross
/// products, and
/// - \sum_i m_ix_i, \sum m_ix_i     over all values of the index in the letters; takes the next product
/// - e_{ijk}g_jf_k                  index notation over 0, 1, 2; f_i alone is a vector, a_{rc} a matrix
/// - \frac{d}{dt}(m\dot x)          by the letters' rates \dot x, \ddot x; takes the next factor
/// - \int_0^T f\,dt                 the bounds are numbers
/// - \int f\,ds                     along a curve, by nodes: ds and others have at least ten numbers
/// - \sum_\sigma a_{\sigma(1)1}     over permutations, with the sign \varepsilon_\sigma
/// - x\pm y, x\mp y                 \pm is a letter with the value 1 or -1
///
/// A quotient's bar / takes the one factor that follows. The argument of a function without parentheses ends
/// at \,, a sign, another function, or a letter with a dot.
Tree parse_tex(std::string_view text, const Names&);

/// Reads typed text: -g/L sin(theta), m y''. The same grammar, with letters by their plain_name(). Factors
/// may be joined by * or a space; the bar / takes the one factor that follows.
Tree parse_plain(std::string_view text, const Names&);

/// The sides of x<0\le y and the relations between them, except those in braces. A limit \to is an equals
/// sign.
struct Sides {
  std::vector<std::string> sides{""};
  std::vector<std::string> relations = {};  ///< = < > \le \ge \ne
};
Sides sides_of(std::string_view text);

/// A relation, or a lone formula, with all its sides.
struct Relation {
  std::vector<Tree> sides;
  std::vector<std::string> relations;
};
Relation parse_tex_relation(std::string_view text, const Names&);
Relation parse_plain_relation(std::string_view text, const Names&);

/// Whether the whole text is one formula, between dollars.
bool is_formula(std::string_view text);

}  // namespace oddity::formula
