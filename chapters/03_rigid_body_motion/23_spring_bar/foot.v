(* The bar's end never touches the spring's foot. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma above_foot : forall s h t, s > 0 -> h > 0 ->
  0 < (s * cos t - s) * (s * cos t - s) + (s * sin t + h) * (s * sin t + h).
Proof.
  intros s h t S H. destruct (Req_dec (cos t) 1) as [level | turned].
  - assert (zero : sin t = 0)
      by (apply Rsqr_0_uniq; pose proof (sin2_cos2 t) as all; rewrite level in all; unfold Rsqr in *; lra).
    rewrite zero, level. nra.
  - assert (away : s * (cos t - 1) <> 0) by (apply Rmult_integral_contrapositive; split; lra).
    pose proof (Rsqr_pos_lt _ away). pose proof (Rle_0_sqr (s * sin t + h)). unfold Rsqr in *. lra.
Qed.
