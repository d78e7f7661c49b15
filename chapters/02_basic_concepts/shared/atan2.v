(* The angle in [-pi, pi] of a point, with its cosine and sine. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Definition atan2 y x :=
  if Rle_dec 0 y then acos (x / sqrt (x * x + y * y)) else - acos (x / sqrt (x * x + y * y)).

Lemma on_circle : forall y x, x * x + y * y > 0 ->
  let r := sqrt (x * x + y * y) in r > 0 /\ r * r = x * x + y * y /\ -1 <= x / r <= 1.
Proof.
  intros y x H r. assert (r > 0) by (apply sqrt_lt_R0; lra).
  assert (r * r = x * x + y * y) by (apply sqrt_sqrt; lra).
  repeat split; trivial; apply Rmult_le_reg_r with r; trivial; replace (x / r * r) with x by (field; lra); nra.
Qed.
Lemma cos_atan2 : forall y x, x * x + y * y > 0 -> cos (atan2 y x) = x / sqrt (x * x + y * y).
Proof.
  intros y x H. destruct (on_circle y x H) as [_ [_ B]].
  unfold atan2. destruct (Rle_dec 0 y); rewrite ?cos_neg; now apply cos_acos.
Qed.
Lemma sin_atan2 : forall y x, x * x + y * y > 0 -> sin (atan2 y x) = y / sqrt (x * x + y * y).
Proof.
  intros y x H. destruct (on_circle y x H) as [P [S B]]. unfold atan2.
  set (r := sqrt (x * x + y * y)) in *. rewrite ?sin_neg.
  destruct (Rle_dec 0 y); rewrite ?sin_neg, sin_acos by exact B;
    replace (1 - Rsqr (x / r)) with (Rsqr (y / r))
      by (unfold Rsqr; apply Rmult_eq_reg_r with (r * r); [field_simplify; nra | nra]).
  - rewrite sqrt_Rsqr; trivial. apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra].
  - rewrite sqrt_Rsqr_abs, Rabs_left; [lra |]. unfold Rdiv. assert (0 < / r) by (apply Rinv_0_lt_compat; lra). nra.
Qed.
