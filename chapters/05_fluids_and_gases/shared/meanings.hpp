#pragma once

#include "chapters/05_fluids_and_gases/shared/proof.hpp"
#include "chapters/provable.hpp"

/// Statements of published lines for any fields, in Coq, from the same lines that are computed at samples.
namespace oddity::fields {

/// A field, which is a function of three coordinates in Coq: its value at any point, as an expression.
struct CoqField {
  std::function<Expression(const std::array<std::string, 3>&)> at;
};
using CoqVector = std::array<CoqField, 3>;

CoqField operator+(const CoqField&, const CoqField&);
CoqField operator-(const CoqField&, const CoqField&);
CoqField operator*(const CoqField&, const CoqField&);
CoqField partial(const CoqField&, std::size_t by);

using oddity::cross, oddity::dot;  // for vectors of numbers, next to those for fields
CoqField divergence(const CoqVector&);
CoqVector curl(const CoqVector&);
CoqVector gradient(const CoqField&);
CoqField dot(const CoqVector&, const CoqVector&);
CoqVector cross(const CoqVector&, const CoqVector&);
CoqVector times(const CoqField&, const CoqVector&);
/// (f.grad) g.
CoqVector advected(const CoqVector& f, const CoqVector& g);

/// Common data of lemmas about lines.
struct Stated {
  std::string letters;
  std::vector<Proposition> given;
  std::string tactic, says, preamble;
};

/// The values of the lines' symbols at a point, in terms of differentiable fields.
class Meanings {
 public:
  /// An arbitrary field.
  CoqField any_scalar(const std::string& name);
  CoqVector any_vector(const std::string& name);
  CoqVector any_numbers(const std::string& name);
  static CoqVector position();

  void put(const std::string& name, const Expression& at_the_point) { meanings_[name] = at_the_point; }
  void put(const std::string& name, const CoqField&);
  void put(const std::string& name, const CoqVector&);
  /// Also sets the slopes, as Sample does.
  void put_scalar(const std::string& name, const CoqField&);
  void put_vector(const std::string& name, const CoqVector&);

  /// A lemma for each line whose symbols all have a meaning. A line whose sides are all equal by definition
  /// has none, as there is nothing to prove.
  Provables proofs(const std::string& exercise, const Proof&) const;
  Provables proofs(const std::string& exercise, const Proof&, const Stated&) const;

 private:
  bool known(const Terms&, const Sample& symbols) const;
  Expression expression(const Terms&, const Sample& symbols) const;

  std::map<std::string, Expression> meanings_;
  std::vector<std::string> fields_, numbers_;
};

}  // namespace oddity::fields
