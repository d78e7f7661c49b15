(* Replaces the root of 1 + t^2, also within other roots, by the letter q. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/root.v".
Load "../shared/atan2.v".

Ltac helix t :=
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
