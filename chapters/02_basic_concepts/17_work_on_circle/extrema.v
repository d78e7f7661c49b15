(* Antiderivatives of the powers and of the terms of their integrals, by t or by a fraction u of the time. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../integrals.v".

Lemma sum_of_shifted : forall x, cos x - sin x = sqrt 2 * sin (PI / 4 - x).
Proof.
  intro x. rewrite sin_minus, sin_PI4, cos_PI4. pose proof (sqrt_lt_R0 2 ltac:(lra)). field. lra.
Qed.
Lemma alike_at : forall x, cos x - sin x = 0 <-> exists k : Z, x = PI / 4 + IZR k * PI.
Proof.
  intro x. rewrite sum_of_shifted. pose proof (sqrt_lt_R0 2 ltac:(lra)). split.
  - intro none. apply Rmult_integral in none. destruct none as [none | none]; [lra |].
    destruct (sin_eq_0_0 _ none) as [k K]. exists (- k)%Z. rewrite opp_IZR. lra.
  - intros [k K]. rewrite (sin_eq_0_1 (PI / 4 - x)); [ring |]. exists (- k)%Z. rewrite opp_IZR. lra.
Qed.
Lemma at_most_root : forall x, cos x + sin x <= sqrt 2.
Proof.
  intro x. pose proof (sin2_cos2 x) as all. unfold Rsqr in all.
  apply Rsqr_incr_0_var; [unfold Rsqr; rewrite sqrt_sqrt by lra; pose proof (Rle_0_sqr (cos x - sin x)) | apply sqrt_pos].
  unfold Rsqr in *. lra.
Qed.
