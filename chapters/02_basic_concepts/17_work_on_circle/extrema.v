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

Ltac by_antiderivatives r w T :=
  repeat first
    [ integrate (fun t => r * (cos (w * t) + sin (w * t)))
    | integrate (fun t => r * t * (cos (w * t) + sin (w * t)) - r / w * (sin (w * t) - cos (w * t)))
    | integrate (fun t => r / w * (sin (w * t) - cos (w * t)))
    | integrate (fun u => r * w * u * (cos (w * (T * u)) - sin (w * (T * u))))
    | integrate (fun u => r * w * u * (T * u) * (cos (w * (T * u)) - sin (w * (T * u)))) ];
  try replace (w * (2 * PI / w)) with (2 * PI) by (field; trivial);
  try replace (w * (T + 2 * PI / w)) with (w * T + 2 * PI) by (field; trivial);
  rewrite ?cos_plus, ?sin_plus, ?cos_2PI, ?sin_2PI, ?Rmult_0_r, ?Rmult_1_r, ?cos_0, ?sin_0;
  first [ring | field; trivial | f_equal; ring].

Ltac zeros r w T :=
  let is := fresh in intro is; first
  [apply (alike_at (w * T)), (Rmult_eq_reg_l (r * w));
    [rewrite Rmult_0_r, <- is; ring | now apply Rmult_integral_contrapositive]
  |apply (alike_at (w * T)) in is; transitivity (r * w * (cos (w * T) - sin (w * T)));
    [ring | rewrite is; ring]].
Ltac in_closed_form r w :=
  integrate (fun t => r * (cos (w * t) + sin (w * t))); rewrite ?Rmult_0_r, ?cos_0, ?sin_0.
Ltac highest r w :=
  in_closed_form r w; replace (w * (PI / 4 / w)) with (PI / 4) by (field; lra); rewrite cos_PI4, sin_PI4;
  pose proof (sqrt_lt_R0 2 ltac:(lra)); pose proof (sqrt_sqrt 2 ltac:(lra)) as two; field [two]; lra.
Ltac nowhere_larger r w T :=
  match goal with |- RInt ?f ?a ?b <= _ =>
    assert (is : RInt f a b = r * (cos (w * T) + sin (w * T)) - r) by (in_closed_form r w; ring); rewrite is end;
  pose proof (Rmult_le_compat_l r _ _ ltac:(lra) (at_most_root (w * T))); lra.
(* along any path of derivatives that are known and continuous *)
Ltac of_potential x y z known continuous :=
  apply (RInt_by (fun t => x t + y t + z t));
  (let t := fresh in intro t; destruct (known t) as [? [? ?]]; destruct (continuous t) as [? [? ?]]);
  [repeat apply @is_derive_plus | repeat apply @continuous_plus]; assumption.
