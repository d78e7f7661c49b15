#pragma once

#include <string>
#include <vector>

#include "chapters/expression.hpp"

/// Definite integrals of a recording number, proved in Coq from antiderivatives.
namespace oddity {

/// Integral of f over the letter t, or over t' if f itself contains an integral over t.
template <class F>
Shortened recorded_integral(const F& f, const Shortened& from, const Shortened& to) {
  const auto integrand = [&](const Expression& t) { return Shortened(f(Shortened(t))).expression(); };
  std::string name = "t";
  while (integrand(Expression::letter(name)).coq().find("(fun " + name + " =>") != std::string::npos)
    name += "'";
  return integral(integrand, from.expression(), to.expression(), name);
}

/// Overload under the name that formula::Evaluation finds by argument-dependent lookup.
template <class F>
Shortened integral_over(const F& f, const Shortened& from, const Shortened& to) {
  return recorded_integral(f, from, to);
}

/// The tactic `integrate F` evaluates the first integral whose integrand has the antiderivative F.
inline constexpr const char* integrals_in_coq = R"(
From Coquelicot Require Import Continuity AutoDerive RInt_analysis.

Lemma RInt_by : forall F f a b,
  (forall t, is_derive F t (f t)) -> (forall t, continuous f t) -> RInt f a b = F b - F a.
Proof. intros F f a b D C. apply is_RInt_unique, (is_RInt_derive F f); auto. Qed.

Ltac integrate F :=
  rewrite (RInt_by F);
    [| intro; auto_derive; solve [repeat split; trivial | field; trivial | field]
     | intro; apply @ex_derive_continuous; auto_derive; solve [repeat split; trivial]];
  match goal with |- ?x = ?y => change (@eq R x y) end.
)";

}  // namespace oddity
