(* Roots, angles and the spring's length, for a mass at the distance s on a rod that turns. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

(* uses the root of 2, the circle's equation and a letter for the spring's length, then solves by field *)
Ltac by_rod a b c w s t :=
  assert (two : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra);
  assert (sqrt 2 > 0) by (apply sqrt_lt_R0; lra);
  try replace (PI * t / 4) with (PI / 4 * t) by field;
  assert (circle_w : sin (w * t) * sin (w * t) = 1 - cos (w * t) * cos (w * t))
    by (pose proof (sin2_cos2 (w * t)) as all; unfold Rsqr in all; lra);
  assert (circle : sin (PI / 4 * t) * sin (PI / 4 * t) = 1 - cos (PI / 4 * t) * cos (PI / 4 * t))
    by (pose proof (sin2_cos2 (PI / 4 * t)) as all; unfold Rsqr in all; lra);
  rewrite ?cos_0, ?sin_0, ?cos_PI2, ?sin_PI2;
  try (replace (sqrt (a * a + a * a)) with (a * sqrt 2)
         by (rewrite <- (sqrt_square (a * sqrt 2)) by (apply Rmult_le_pos; lra);
             f_equal; ring [two]));
  assert (far : forall C S, S * S = 1 - C * C -> s * s - 2 * (c * C / sqrt 2) * s + c * c > 0)
    by (intros C S circle_C;
        assert (c * c * (1 + S * S) > 0) by (apply Rmult_gt_0_compat; nra);
        pose proof (pow2_ge_0 (s - c * C / sqrt 2));
        replace (s * s - 2 * (c * C / sqrt 2) * s + c * c)
          with ((s - c * C / sqrt 2) ^ 2 + c * c * (1 + S * S) / 2)
          by (field [two circle_C]; lra);
        lra);
  let angle := lazymatch goal with
    | |- context [cos (PI / 4 * ?x)] => constr:(PI / 4 * x)
    | _ => constr:(w * t)
    end in
  set (r2 := s * s - 2 * (c * cos angle / sqrt 2) * s + c * c);
  repeat match goal with
    | |- context [sqrt ?x] =>
        lazymatch x with
        | IZR _ => fail
        | _ => tryif is_var x then fail else replace x with r2 by (unfold r2; field [two circle_w circle]; lra)
        end
    end;
  assert (r2 > 0) by (unfold r2; first [apply (far _ _ circle_w) | apply (far _ _ circle)]);
  pose proof (sqrt_lt_R0 r2) as positive;
  assert (root : sqrt r2 * sqrt r2 = r2) by (apply sqrt_sqrt; lra);
  try rewrite root; unfold r2 in root;
  try (assert (0 < sqrt ((b - c) * (b - c) + b * b)) by (apply sqrt_lt_R0; nra));
  first [field [two circle_w circle] | unfold r2; field [two circle_w circle]];
  repeat split; try lra; try (apply Rgt_not_eq; unfold r2 in *; lra).

(* the spring at the start, when the rod has not turned yet *)
Ltac by_start :=
  assert (two : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra);
  rewrite ?cos_0, ?sin_0; f_equal; field [two].

(* a spring at its rest length does not pull *)
Ltac by_rest :=
  assert (two : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra);
  rewrite ?cos_0, ?sin_0;
  match goal with |- _ * (sqrt ?x - sqrt ?y) = _ => replace x with y by (field [two]) end; ring.

Ltac by_half_right_angle a :=
  replace (a / sqrt (a * a + a * a)) with (cos (PI / 4));
  [rewrite acos_cos; [reflexivity | pose proof PI_RGT_0; lra]
  |rewrite cos_PI4; replace (a * a + a * a) with (2 * (a * a)) by ring;
   rewrite (sqrt_mult_alt 2), (sqrt_square a) by lra; field; repeat split; first [lra | apply Rgt_not_eq, sqrt_lt_R0; lra]].

(* as by_rod, with a letter for each root, angle and rate before solving an equation of fractions *)
Ltac by_rate c s t :=
  rewrite <- ?Rsqr_pow2; unfold Rsqr;
  replace (PI * t / 4) with (PI / 4 * t) by field;
  assert (circle : sin (PI / 4 * t) * sin (PI / 4 * t) = 1 - cos (PI / 4 * t) * cos (PI / 4 * t))
    by (pose proof (sin2_cos2 (PI / 4 * t)) as all; unfold Rsqr in all; lra);
  assert (two : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra);
  assert (over : forall x, x / sqrt 2 = x * sqrt 2 / 2)
    by (intros; field [two]; apply Rgt_not_eq, sqrt_lt_R0; lra);
  rewrite !over; set (k := sqrt 2) in *; clearbody k;
  set (q := PI / 4) in *; replace (PI * PI / 32) with (q * q / 2) by (unfold q; field);
  set (C := cos (q * t)) in *; set (S := sin (q * t)) in *; clearbody C S q;
  set (r2 := s * s - 2 * s * C * c * k / 2 + c * c);
  repeat match goal with |- context [sqrt ?x] =>
    lazymatch x with r2 => fail | _ => replace x with r2 by (unfold r2; field [two circle]) end end;
  assert (r2 > 0)
    by (assert (c * c * (1 + S * S) > 0) by (apply Rmult_gt_0_compat; nra);
        pose proof (Rle_0_sqr (s - c * C * k / 2)); unfold Rsqr, r2 in *;
        replace (s * s - 2 * s * C * c * k / 2 + c * c)
          with ((s - c * C * k / 2) * (s - c * C * k / 2) + c * c * (1 + S * S) / 2) by (field [two circle]); lra);
  pose proof (sqrt_lt_R0 r2 ltac:(assumption));
  assert (root : sqrt r2 * sqrt r2 = r2) by (apply sqrt_sqrt; lra);
  set (r := sqrt r2) in *; clearbody r; field [two circle]; repeat split; try lra;
  match goal with |- ?x <> 0 => replace x with 8 by (ring [two circle]); lra end.
