#pragma once

#include "chapters/05_fluids_and_gases/shared/proof.hpp"
#include "chapters/provable.hpp"

/// What published lines say of any fields, for Coq: the same lines that are computed at samples.
namespace oddity::fields {

/// A field, which Coq has as a function of three coordinates: its value at any point, as an expression.
struct CoqField {
  std::function<Expression(const std::array<std::string, 3>&)> at;
};
using CoqVector = std::array<CoqField, 3>;

CoqField operator+(const CoqField&, const CoqField&);
CoqField operator-(const CoqField&, const CoqField&);
CoqField operator*(const CoqField&, const CoqField&);
CoqField partial(const CoqField&, std::size_t by);

CoqField divergence(const CoqVector&);
CoqVector curl(const CoqVector&);
CoqVector gradient(const CoqField&);
CoqField dot(const CoqVector&, const CoqVector&);
CoqVector cross(const CoqVector&, const CoqVector&);
CoqVector times(const CoqField&, const CoqVector&);
/// (f.grad) g.
CoqVector advected(const CoqVector& f, const CoqVector& g);

/// What lemmas about lines have in common.
struct Stated {
  std::string letters;
  std::vector<Proposition> given;
  std::string tactic, says, preamble;
};

/// What the symbols of lines stand for at a point, in terms of differentiable fields.
class Meanings {
 public:
  /// A field that may be any.
  CoqField any_scalar(const std::string& name);
  CoqVector any_vector(const std::string& name);
  CoqVector any_numbers(const std::string& name);
  static CoqVector position();

  void put(const std::string& name, const Expression& at_the_point) { meanings_[name] = at_the_point; }
  void put(const std::string& name, const CoqField&);
  void put(const std::string& name, const CoqVector&);
  /// With the slopes, as Sample has them.
  void put_scalar(const std::string& name, const CoqField&);
  void put_vector(const std::string& name, const CoqVector&);

  /// A lemma for each line whose symbols all have a meaning. Where all sides of a line are the same by their
  /// definitions nothing is to be proved, and it has none.
  Provables proofs(const std::string& exercise, const Proof&) const;
  Provables proofs(const std::string& exercise, const Proof&, const Stated&) const;

 private:
  bool known(const Terms&, const Sample& symbols) const;
  Expression expression(const Terms&, const Sample& symbols) const;

  std::map<std::string, Expression> meanings_;
  std::vector<std::string> fields_, numbers_;
};

}  // namespace oddity::fields
