(* For known roots: sqrt x = y. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma root_is : forall x y, 0 <= y -> x = y * y -> sqrt x = y.
Proof. intros x y H ->. exact (sqrt_square y H). Qed.
