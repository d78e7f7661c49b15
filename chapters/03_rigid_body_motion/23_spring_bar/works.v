(* The works of weight and spring. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../integrals.v".
Load "foot.v".

Ltac by_works m r s c h g ell :=
  let positive := fresh "positive" in let root := fresh "root" in
  assert (positive : forall t, 0 < (s * cos t - s) * (s * cos t - s) + (s * sin t + h) * (s * sin t + h))
    by (intro t; apply above_foot; assumption);
  assert (root : forall t, sqrt ((s * cos t - s) * (s * cos t - s) + (s * sin t + h) * (s * sin t + h)) <> 0)
    by (intro t; apply Rgt_not_eq, sqrt_lt_R0, positive);
  unfold Rminus in *;
  try integrate (fun t => - m * g * r * sin t);
  try integrate (fun t => - c / 2 *
    ((sqrt ((s * cos t + - s) * (s * cos t + - s) + (s * sin t + h) * (s * sin t + h)) + - ell) *
     (sqrt ((s * cos t + - s) * (s * cos t + - s) + (s * sin t + h) * (s * sin t + h)) + - ell))).
