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
(* All square roots are the spring's length, which is h for the level bar. *)
Ltac by_one_root q s h r :=
  let circle := fresh "circle" in let far := fresh "far" in let arm := fresh "arm" in
  assert (circle : sin q * sin q = 1 - cos q * cos q)
    by (let all := fresh in pose proof (sin2_cos2 q) as all; unfold Rsqr in all; lra);
  assert (far : 0 < (s * cos q - s) * (s * cos q - s) + (s * sin q + h) * (s * sin q + h))
    by (apply above_foot; assumption);
  assert (arm : r * r > 0) by nra;
  rewrite ?cos_0, ?sin_0;
  repeat (match goal with |- context [sqrt ?x] =>
    first [ let level := fresh in
            assert (level : sqrt x = h) by (replace x with (h * h) by ring; apply sqrt_square; lra);
            rewrite !level; clear level
          | match goal with |- context [sqrt ?y] =>
              assert_fails (constr_eq x y);
              let same := fresh in
              assert (same : sqrt y = sqrt x) by (f_equal; ring); rewrite !same; clear same end ] end);
  try (match goal with |- context [sqrt ?x] =>
    let d := fresh "d" in
    assert (sqrt x > 0) by (apply sqrt_lt_R0; nra); set (d := sqrt x) in *; clearbody d end);
  field [circle]; repeat split; apply Rgt_not_eq; nra.
