(* A function has the limit of a function that is continuous there, if both are equal elsewhere. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

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
