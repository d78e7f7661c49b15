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

/// The grammar of parse.hpp, by recursive descent. shown.cpp has another reading of its letters.
class Parser {
 public:
  Parser(std::string_view text, Tokens tokens, const Vocabulary& letters, bool plain)
      : text_(text), tokens_(std::move(tokens)), letters_(letters), plain_(plain) {}
  virtual ~Parser() = default;

  Tree all();

  /// f_i is a vector by the one index that occurs once, or a matrix by r and c. Of a product e_{ijk}g_jf_k
  /// each index that occurs twice is summed over 0, 1, 2.
  Tree in_index_notation();

 protected:
  [[noreturn]] void fail(std::string reason) const;
  /// Keeps trees so low that recursion over them is safe.
  void limit(std::size_t levels) const;
  const std::string& next(std::size_t ahead = 0) const;
  bool take(std::string_view token);
  bool take_all(std::initializer_list<std::string_view> tokens);
  void expect(std::string_view token);
  std::size_t bind(std::vector<std::string> tokens);
  void unbind(std::size_t slot);

  Tree sum_of_terms();
  /// Zero where there is none. Where both are written a letter says which.
  virtual char sign();

  /// u . v x w is that of u and v x w.
  Tree dot_products();
  Tree cross_products();
  Tree factors();
  /// What joins a factor to the one before it: * or /, or zero where there is none.
  virtual char joint();
  virtual bool begins_factor() const;
  virtual bool begins_function() const;

  Tree power();
  virtual Tree base_with_powers();

  /// \sin^2 x is (\sin x)^2, and \sin^{-1} x the inverse function's.
  virtual Tree of_function();
  /// \sin\omega t, and up to where something else begins.
  Tree argument_of_function();

  /// \sum_i m_ix_i, or \sum m_ix_i, is over all that there are letters of, and of one product.
  Tree sum_over_index();
  std::string first_index() const;
  /// Of all that follows. \sigma(k) is the k-th, and \varepsilon_\sigma -1 where an odd number of pairs is
  /// out of order.
  Tree sum_over_permutations();

  /// What stands behind \frac, \sqrt and ^: a group, or one token.
  virtual Tree argument();
  std::string first_digit();

  virtual std::optional<Tree> letter_here() const;
  std::optional<Tree> variable_here();
  std::optional<Tree> index_here();

  virtual Tree base();
  Tree numeral();
  /// Names the letter, and others that are known.
  [[noreturn]] void unknown() const;
  Tree between_bars();
  /// A sum, or several with commas between them: a tuple; with semicolons between rows.
  virtual Tree closed_by(std::string_view end);
  /// \max(a,b), and in plain text dot(a, b).
  Tree of_all(Kind kind);

  /// Up to \end{pmatrix}, of numbers, columns or matrices.
  Tree matrix();
  Tree row();

  /// Of what follows, along the rates of its letters.
  Tree time_derivative();

  /// \int_0^T f\,dt.
  Tree integral();
  /// The \, before the differential, but of integrals within this one.
  std::size_t end_of_integrand() const;
  /// The sum that ends there.
  Tree up_to(std::size_t end);
  /// \int f\,ds, by the nodes that ds has weights of.
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
