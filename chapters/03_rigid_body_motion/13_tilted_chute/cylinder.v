(* Points on a cylinder. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require Import Nsatz.
Local Open Scope R_scope.
Lemma length_across : forall y1 y2 u1 u2 u3 v1 v2 v3 : R,
  u1 * u1 + u2 * u2 + u3 * u3 = 1 -> v1 * v1 + v2 * v2 + v3 * v3 = 1 -> u1 * v1 + u2 * v2 + u3 * v3 = 0 ->
  y1 * y1 + y2 * y2 = (y1 * u1 + y2 * v1) * (y1 * u1 + y2 * v1) + (y1 * u2 + y2 * v2) * (y1 * u2 + y2 * v2) +
    (y1 * u3 + y2 * v3) * (y1 * u3 + y2 * v3).
Proof. intros. nsatz. Qed.
Ltac on_cylinder := first [apply length_across; nsatz | nsatz].
