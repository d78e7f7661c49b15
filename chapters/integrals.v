(* The tactic `integrate F` evaluates the first integral whose integrand has the antiderivative F. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coquelicot Require Import Continuity AutoDerive RInt_analysis.

Lemma RInt_by : forall F f a b,
  (forall t, is_derive F t (f t)) -> (forall t, continuous f t) -> RInt f a b = F b - F a.
Proof. intros F f a b D C. apply is_RInt_unique, (is_RInt_derive F f); auto. Qed.

Ltac integrate F :=
  rewrite (RInt_by F);
    [| intro; auto_derive; solve [repeat split; trivial | field; trivial | field]
     | intro; apply @ex_derive_continuous; auto_derive; solve [repeat split; trivial]];
  match goal with |- ?x = ?y => change (@eq R x y) end.
