(* The frame of a curve on the unit sphere. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/orthonormal.v".
Load "../shared/root.v".
Load "../shared/atan2.v".

From Coquelicot Require Import AutoDerive.

(* writes l for the speed, l u for the velocity, and the acceleration in the frame of r, u and b *)
Ltac by_frame r0 r1 r2 v0 v1 v2 a0 a1 a2 rr rv va vv :=
  pose proof (sqrt_lt_R0 _ vv) as positive;
  assert (square : sqrt (v0 * v0 + v1 * v1 + v2 * v2) * sqrt (v0 * v0 + v1 * v1 + v2 * v2) =
      v0 * v0 + v1 * v1 + v2 * v2) by (apply sqrt_sqrt; lra);
  revert positive square; generalize (sqrt (v0 * v0 + v1 * v1 + v2 * v2)) as l; intros l positive square;
  rewrite <- ?square; rewrite <- square in va;
  set (u0 := v0 / l); set (u1 := v1 / l); set (u2 := v2 / l);
  assert (w0 : v0 = l * u0) by (unfold u0; field; lra);
  assert (w1 : v1 = l * u1) by (unfold u1; field; lra);
  assert (w2 : v2 = l * u2) by (unfold u2; field; lra);
  clearbody u0 u1 u2; subst v0 v1 v2;
  assert (uu : u0 * u0 + u1 * u1 + u2 * u2 = 1) by (apply Rmult_eq_reg_l with (l * l); [lra | nra]);
  assert (ru : r0 * u0 + r1 * u1 + r2 * u2 = 0) by (apply Rmult_eq_reg_l with l; [lra | lra]);
  destruct (orthonormal _ _ _ _ _ _ rr uu ru) as
    ((bb & rb & ub) & (x0 & x1 & x2) & (y0 & y1 & y2) & (z0 & z1 & z2) & in_frame);
  destruct (in_frame a0 a1 a2) as (f0 & f1 & f2);
  destruct (in_frame 0 0 1) as (k20 & k21 & _); destruct (in_frame 0 1 0) as (k10 & _); clear in_frame;
  replace (r0 * a0 + r1 * a1 + r2 * a2) with (- (l * l)) in f0, f1, f2 by lra;
  set (b0 := r1 * u2 - r2 * u1) in *; set (b1 := r2 * u0 - r0 * u2) in *; set (b2 := r0 * u1 - r1 * u0) in *;
  set (b := u0 * a0 + u1 * a1 + u2 * a2) in *; set (c := b0 * a0 + b1 * a1 + b2 * a2) in *;
  repeat match goal with
  | |- context [?x / (2 * l)] => replace (x / (2 * l)) with b by (unfold b; field; lra)
  | |- context [?x / (l * l)] => replace (x / (l * l)) with (c / l) by (unfold c, b0, b1, b2; field; lra)
  end;
  try replace (a0 * u0 + a1 * u1 + a2 * u2) with b by (unfold b; ring);
  try replace (l * u0 * a0 + l * u1 * a1 + l * u2 * a2) with (l * b) by (unfold b; ring);
  clearbody b c; clearbody b0 b1 b2; subst a0 a1 a2;
  repeat match goal with
  | |- context [(- (l * l) * ?r + b * ?u + c * ?n - ?x) / l] =>
    replace ((- (l * l) * r + b * u + c * n - x) / l) with (c / l * n - l * r) by (field; lra)
  end;
  try replace (r1 * (c / l * b2 - l * r2) - r2 * (c / l * b1 - l * r1)) with (- (c / l) * u0) by (field [z0]; lra);
  try replace (l * u1 * u2 + r1 * (c / l * b2 - l * r2) - (l * u2 * u1 + r2 * (c / l * b1 - l * r1))) with (- (c / l) * u0) by (field [z0]; lra);
  try replace (r2 * (c / l * b0 - l * r0) - r0 * (c / l * b2 - l * r2)) with (- (c / l) * u1) by (field [z1]; lra);
  try replace (l * u2 * u0 + r2 * (c / l * b0 - l * r0) - (l * u0 * u2 + r0 * (c / l * b2 - l * r2))) with (- (c / l) * u1) by (field [z1]; lra);
  try replace (r0 * (c / l * b1 - l * r1) - r1 * (c / l * b0 - l * r0)) with (- (c / l) * u2) by (field [z2]; lra);
  try replace (l * u0 * u1 + r0 * (c / l * b1 - l * r1) - (l * u1 * u0 + r1 * (c / l * b0 - l * r0))) with (- (c / l) * u2) by (field [z2]; lra);
  try rewrite ru;
  repeat match goal with
  | |- context [(- (l * l) * ?r + b * ?u + c * ?n - 0 * ?u) / l] =>
    replace ((- (l * l) * r + b * u + c * n - 0 * u) / l) with (b / l * u + c / l * n - l * r)
      by (field; lra)
  end;
  try replace (r1 * (b / l * u2 + c / l * b2 - l * r2) - r2 * (b / l * u1 + c / l * b1 - l * r1)) with (b / l * b0 - c / l * u0)
    by (field [x0 z0]; lra);
  try replace (r2 * (b / l * u0 + c / l * b0 - l * r0) - r0 * (b / l * u2 + c / l * b2 - l * r2)) with (b / l * b1 - c / l * u1)
    by (field [x1 z1]; lra);
  try replace (r0 * (b / l * u1 + c / l * b1 - l * r1) - r1 * (b / l * u0 + c / l * b0 - l * r0)) with (b / l * b2 - c / l * u2)
    by (field [x2 z2]; lra);
  assert (bb12 : b1 * b2 = - r1 * r2 - u1 * u2) by lra;
  assert (bb02 : b0 * b2 = - r0 * r2 - u0 * u2) by lra;
  assert (bb01 : b0 * b1 = - r0 * r1 - u0 * u1) by lra;
  assert (rr0 : r0 * r0 = 1 - r1 * r1 - r2 * r2) by lra;
  assert (uu0 : u0 * u0 = 1 - u1 * u1 - u2 * u2) by lra;
  assert (bb0 : b0 * b0 = 1 - b1 * b1 - b2 * b2) by lra;
  assert (ru0 : r0 * u0 = - r1 * u1 - r2 * u2) by lra;
  assert (rb0 : r0 * b0 = - r1 * b1 - r2 * b2) by lra;
  assert (ub0 : u0 * b0 = - u1 * b1 - u2 * b2) by lra;
  first
    [ lra | field; lra | field [z0 z1 z2 y0 y1 y2 x0 x1 x2]; lra | field [y0 y1 y2 rr0]; lra | field [x0 y0 bb12]; lra | field [x1 y1 bb02]; lra | field [x2 y2 bb01]; lra
     | field [rr0 uu0 bb0 ru0 rb0 ub0]; lra ].

(* r.r is constant, and half its derivative is zero *)
Ltac by_constant x y z t dx dy dz norm :=
  assert (still : x t * dx + y t * dy + z t * dz = 0)
    by (assert (changes : is_derive (fun s => x s * x s + y s * y s + z s * z s) t
                            (2 * (x t * dx + y t * dy + z t * dz)))
          by (auto_derive;
              [ repeat split; eexists; eassumption
              | change (fun s => x s) with x; change (fun s => y s) with y; change (fun s => z s) with z;
                rewrite (is_derive_unique x t dx), (is_derive_unique y t dy), (is_derive_unique z t dz)
                  by assumption; ring ]);
        assert (stays : is_derive (fun s => x s * x s + y s * y s + z s * z s) t 0)
          by (apply (is_derive_ext (fun _ => 1)); [intros; symmetry; apply norm | apply @is_derive_const]);
        apply is_derive_unique in changes; apply is_derive_unique in stays; lra);
  specialize (norm t); generalize dependent (x t); intros x'; generalize dependent (y t); intros y';
  generalize dependent (z t); intros z' *; nsatz.

(* the root is not zero *)
Ltac by_length t :=
  replace ((1 - t ^ 2) ^ 2 + t ^ 4) with (t * t * (t * t) + (1 - t * t) * (1 - t * t)) by ring;
  assert (positive : 0 < t * t * (t * t) + (1 - t * t) * (1 - t * t)) by nra;
  rewrite ?cos_atan2, ?sin_atan2 by lra;
  replace ((1 - t * t) * (1 - t * t) + t * t * (t * t)) with (t * t * (t * t) + (1 - t * t) * (1 - t * t))
    by ring;
  pose proof (sqrt_lt_R0 _ positive) as longer;
  assert (square : sqrt (t * t * (t * t) + (1 - t * t) * (1 - t * t)) *
                     sqrt (t * t * (t * t) + (1 - t * t) * (1 - t * t)) =
                   t * t * (t * t) + (1 - t * t) * (1 - t * t)) by (apply sqrt_sqrt; lra);
  set (q := sqrt (t * t * (t * t) + (1 - t * t) * (1 - t * t))) in *; clearbody q;
  assert (circle : sin (PI * t) * sin (PI * t) = 1 - cos (PI * t) * cos (PI * t))
    by (pose proof (sin2_cos2 (PI * t)) as all; unfold Rsqr in all; lra);
  try match goal with |- context [sqrt ?x] => rewrite (root_is x 1) by (try lra; field [circle square]; lra) end;
  first [reflexivity | field; lra].
