#pragma once

#include "chapters/provable.hpp"

/// Limits in Coq of a function that is recorded with the letter t.
namespace oddity {

inline Proposition tends_at_infinity(const Expression& f, const Expression& limit) {
  return {"(forall eps, eps > 0 -> exists far, forall t, t > far -> " + abs(f - limit).coq() + " < eps)"};
}

/// As t goes to 0 from the given side.
inline Proposition tends_at_zero(const Expression& f, int side, const Expression& limit) {
  const std::string within = side < 0 ? "- near < t < 0" : "0 < t < near";
  return {"(forall eps, eps > 0 -> exists near, near > 0 /\\ forall t, " + within + " -> " +
          abs(f - limit).coq() + " < eps)"};
}

/// A function has the limit of a function that is continuous there, if both are equal elsewhere.
inline constexpr const char* limit_at_zero_in_coq = R"(
From Coquelicot Require Import AutoDerive.

Lemma limit_at_zero : forall (f g : R -> R) (l : R),
  ex_derive g 0 -> g 0 = l -> (forall t, t <> 0 -> f t = g t) -> forall eps, eps > 0 ->
  exists near, near > 0 /\ forall t, Rabs t < near -> t <> 0 -> Rabs (f t - l) < eps.
Proof.
  intros f g l D <- same eps positive.
  destruct (ex_derive_continuous g 0 D (fun y => Rabs (y - g 0) < eps)) as [near close].
  { exists (mkposreal eps positive). intros y H. exact H. }
  exists near. split; [exact (cond_pos near) |]. intros t small away. rewrite (same t away).
  apply close. change (Rabs (t - 0) < near). now rewrite Rminus_0_r.
Qed.
)";

}  // namespace oddity
