#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formula/letters.hpp"
#include "formula/tokens.hpp"
#include "formula/tree.hpp"

namespace oddity::formula {

/// The grammar of parse.hpp, by recursive descent. shown.cpp reads letters in a different way.
class Parser {
 public:
  Parser(std::string_view text, Tokens tokens, const Vocabulary& letters, bool plain)
      : text_(text), tokens_(std::move(tokens)), letters_(letters), plain_(plain) {}
  virtual ~Parser() = default;

  Tree all();

  /// f_i is a vector over the one index that occurs once, or a matrix over r and c. In a product
  /// e_{ijk}g_jf_k, indices that occur twice are summed over 0, 1, 2.
  Tree in_index_notation();

 protected:
  [[noreturn]] void fail(std::string reason) const;
  /// Limits the height of trees, so that recursion over them is safe.
  void limit(std::size_t levels) const;
  const std::string& next(std::size_t ahead = 0) const;
  bool take(std::string_view token);
  bool take_all(std::initializer_list<std::string_view> tokens);
  void expect(std::string_view token);
  std::size_t bind(std::vector<std::string> tokens);
  void unbind(std::size_t slot);

  Tree sum_of_terms();
  /// The sign here, or zero. For \pm, a letter chooses.
  virtual char sign();

  /// u . v x w is the product of u and v x w.
  Tree dot_products();
  Tree cross_products();
  Tree factors();
  /// The sign that joins a factor to the one before it, * or /; zero without a factor.
  virtual char joint();
  virtual bool begins_factor() const;
  virtual bool begins_function() const;

  Tree power();
  virtual Tree base_with_powers();

  /// \sin^2 x is (\sin x)^2, and \sin^{-1} x is the inverse function.
  virtual Tree of_function();
  /// Reads the argument of \sin\omega t, up to the next term, function or other end.
  Tree argument_of_function();

  /// Reads \sum_i m_ix_i, or \sum m_ix_i: over all values that the letters have, of one product.
  Tree sum_over_index();
  std::string first_index() const;
  /// Reads a sum over permutations, of all factors that follow. \sigma(k) is the k-th element, and
  /// \varepsilon_\sigma is -1 if an odd number of pairs is out of order.
  Tree sum_over_permutations();

  /// The argument of \frac, \sqrt or ^: a group, or one token.
  virtual Tree argument();
  std::string first_digit();

  virtual std::optional<Tree> letter_here() const;
  std::optional<Tree> variable_here();
  std::optional<Tree> index_here();

  virtual Tree base();
  Tree numeral();
  /// Throws with the unknown letter and similar known ones.
  [[noreturn]] void unknown() const;
  Tree between_bars();
  /// A sum, or a tuple of sums with commas between them, and semicolons between rows.
  virtual Tree closed_by(std::string_view end);
  /// \max(a,b), and in plain text dot(a, b).
  Tree of_all(Kind kind);

  /// Reads up to \end{pmatrix}: numbers, columns or matrices.
  Tree matrix();
  Tree row();

  /// The time derivative of the next factor, along the rates of its letters.
  Tree time_derivative();

  /// Reads \int_0^T f\,dt.
  Tree integral();
  /// The \, before the differential, skipping integrals within this one.
  std::size_t end_of_integrand() const;
  /// Reads the sum that ends there.
  Tree up_to(std::size_t end);
  /// Reads \int f\,ds, over the nodes for which ds has weights.
  Tree along_curve();

  std::string_view text_;
  Tokens tokens_;
  const Vocabulary& letters_;
  bool plain_;
  std::size_t at_ = 0, depth_ = 0, slots_ = 0;
  bool inside_bars_ = false;
  std::vector<Index> indices_;
  std::vector<std::pair<std::string, std::size_t>> variables_;
  mutable std::size_t length_ = 0;
};

}  // namespace oddity::formula
