#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formula/tree.hpp"
#include "formula/unreadable.hpp"

namespace oddity::formula {

/// Names of the letters, as a page has them: "m_2", R"(\dot\theta)", R"(\partial L/\partial y)". The longest
/// that fits is taken. Evaluation takes a value for each.
using Names = std::vector<std::string>;

/// Reads TeX: m_2g-c_1(S_1-L_1). Throws Unreadable. Reads numbers, letters, sums, products, fractions,
/// powers, roots, elementary functions, absolute values, \max and \min, tuples, matrices, dot and cross
/// products, and
///   \sum_i m_ix_i, \sum m_ix_i     over all indices that there are letters of, of the product that follows
///   e_{ijk}g_jf_k                  in index notation, over 0, 1, 2; f_i alone is a vector, a_{rc} a matrix
///   \frac{d}{dt}(m\dot x)          along the letters' rates \dot x, \ddot x, of the factor that follows
///   \int_0^T f\,dt                 between numbers
///   \int f\,ds                     along a curve, by nodes: ds and others are ten numbers or more
///   \sum_\sigma a_{\sigma(1)1}     over permutations, of the sign \varepsilon_\sigma
///   x\pm y, x\mp y                 where \pm is a letter, 1 or -1
/// A quotient's bar / is over the one factor that follows; a function without parentheses is of what follows
/// it up to \,, a sign, another function, or a letter with a dot.
Tree parse_tex(std::string_view text, const Names&);

/// Reads text as one types it: -g/L sin(theta), m y''. The same grammar, with letters by their plain_name().
/// A factor may be joined by * or a space; the bar / is over the one factor that follows.
Tree parse_plain(std::string_view text, const Names&);

/// What stands between the relations of x<0\le y, and these, but for those in braces. A limit \to is an
/// equals sign.
struct Sides {
  std::vector<std::string> sides{""};
  std::vector<std::string> relations = {};  ///< = < > \le \ge \ne
};
Sides sides_of(std::string_view text);

/// A relation, or a lone formula, of which all sides are read.
struct Relation {
  std::vector<Tree> sides;
  std::vector<std::string> relations;
};
Relation parse_tex_relation(std::string_view text, const Names&);
Relation parse_plain_relation(std::string_view text, const Names&);

/// Whether all of the text is one formula, between dollars.
bool is_formula(std::string_view text);

}  // namespace oddity::formula
