(* A function with zero derivative is constant. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coquelicot Require Import AutoDerive.

Lemma constant : forall f : R -> R, (forall t, is_derive f t 0) -> forall t, f t = f 0.
Proof.
  intros f D t. destruct (Rtotal_order t 0) as [l | [-> | l]]; trivial;
    [| symmetry]; apply (eq_is_derive f); trivial; intros; apply D.
Qed.
