(* Replaces the root of 1 + t^2, also within other roots, by the letter q. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/root.v".
Load "../shared/atan2.v".

Ltac helix t q circle square inside :=
  assert (above : 0 < 1 + t * t) by nra;
  pose proof (sqrt_lt_R0 _ above) as positive;
  assert (root : sqrt (1 + t * t) * sqrt (1 + t * t) = 1 + t * t) by (apply sqrt_sqrt; lra);
  set (q := sqrt (1 + t * t)) in *; clearbody q;
  assert (square : t * t = q * q - 1) by lra; rewrite <- ?root; clear root above;
  assert (inside : -1 <= t / q <= 1)
    by (split; apply Rmult_le_reg_r with q; trivial; replace (t / q * q) with t by (field; lra); nra);
  assert (inverse : 0 < / q) by (apply Rinv_0_lt_compat; lra);
  try (assert (0 < t / q) by (apply Rmult_lt_0_compat; lra));
  assert (circle : sin t * sin t = 1 - cos t * cos t)
    by (pose proof (sin2_cos2 t) as all; unfold Rsqr in all; lra).

Ltac helix_roots t q circle square :=
  repeat match goal with |- context [sqrt ?x] =>
    lazymatch x with
    | context [sqrt _] => fail
    | _ =>
        let is y := rewrite (root_is x y) by (try lra; field [circle square]; repeat split; lra) in
        first [is constr:(1) | is constr:(q) | is constr:(/ q) | is constr:(t / q)]
    end
  end.

Ltac helix_angles t q circle square inside :=
  rewrite ?cos_acos, ?sin_acos by exact inside; unfold Rsqr;
  repeat match goal with |- context [atan2 ?y ?x] =>
    let positive := fresh in
    assert (positive : x * x + y * y > 0)
      by first [ replace (x * x + y * y) with 1 by (field [circle square]; lra); lra
               | replace (x * x + y * y) with (/ q * / q) by (field [circle square]; lra); nra ];
    progress rewrite ?(cos_atan2 y x positive), ?(sin_atan2 y x positive);
    clear positive
  end;
  helix_roots t q circle square;
  try (unfold atan2; destruct (Rle_dec 0 (/ q)); [| exfalso; lra]; f_equal;
       helix_roots t q circle square; field; lra).

Ltac by_helix t :=
  let q := fresh "q" in let circle := fresh "circle" in
  let square := fresh "square" in let inside := fresh "inside" in
  rewrite <- ?(Rsqr_pow2 t); unfold Rsqr; helix t q circle square inside; helix_roots t q circle square;
  helix_angles t q circle square inside; field [circle square]; repeat split; nra.
(* Beyond t = 1/eps, 1/q is below eps. *)
Ltac by_distance :=
  let q := fresh "q" in let circle := fresh "circle" in
  let square := fresh "square" in let inside := fresh "inside" in
  intros; match goal with small : ?eps > 0 |- _ =>
    exists (/ eps); intros t far; assert (early : 0 < / eps) by (apply Rinv_0_lt_compat; lra);
    helix t q circle square inside; assert (longer : t < q) by nra;
    assert (close : / q < eps)
      by (rewrite <- (Rinv_inv eps); apply Rinv_lt_contravar; [apply Rmult_lt_0_compat |]; lra);
    helix_roots t q circle square;
    first
      [ rewrite Rminus_0_r, Rabs_pos_eq; lra
      | assert (1 - t / q < / q)
          by (apply Rmult_lt_reg_r with q; trivial; replace ((1 - t / q) * q) with (q - t) by (field; lra);
              rewrite Rinv_l by lra; nra);
        rewrite Rabs_left1; lra ]
  end.
(* Rewrites the angles of an example with functions for which `interval` has bounds. *)
Ltac by_bounds :=
  rewrite ?cos_atan2, ?sin_atan2 by interval;
  try (unfold atan2; destruct (Rle_dec _ _) as [| below]; [| contradict below; apply sqrt_pos];
       rewrite !acos_atan by interval);
  interval.
