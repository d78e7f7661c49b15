(* Products in a turned frame. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/frames.v".

Ltac in_turned_frame r f H :=
  let e0 := fresh in pose proof (in_frame r 0 f H ltac:(lia)) as e0;
  let e1 := fresh in pose proof (in_frame r 1 f H ltac:(lia)) as e1;
  let e2 := fresh in pose proof (in_frame r 2 f H ltac:(lia)) as e2;
  unfold dot, sum in e0, e1, e2; revert e0 e1 e2;
  generalize (r 0%nat 0%nat * f 0%nat + r 0%nat 1%nat * f 1%nat + r 0%nat 2%nat * f 2%nat),
    (r 1%nat 0%nat * f 0%nat + r 1%nat 1%nat * f 1%nat + r 1%nat 2%nat * f 2%nat),
    (r 2%nat 0%nat * f 0%nat + r 2%nat 1%nat * f 1%nat + r 2%nat 2%nat * f 2%nat);
  intros ? ? ? <- <- <-; ring.
