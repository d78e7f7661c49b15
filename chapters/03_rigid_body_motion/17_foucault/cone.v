(* Integrals over the cone. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../integrals.v".

From Coquelicot Require Import ElemFct.

Ltac in_reals := match goal with |- ?x = ?y => change (@eq R x y) end.

(* from the height `low` on, in cylindrical coordinates *)
Definition over_cone (rho : R -> R) (low h : R) (f : R -> R -> R -> R) : R :=
  RInt (fun z => RInt (fun t => RInt (fun s => s * f (s * cos t) (s * sin t) z) 0 (rho z)) 0 (2 * PI)) low h.

Definition quadratic (f : R -> R -> R -> R) := forall x y z,
  f x y z = f 0 0 0 + x * (f 1 0 0 - f (-1) 0 0) / 2 + y * (f 0 1 0 - f 0 (-1) 0) / 2 + z * (f 0 0 1 - f 0 0 (-1)) / 2
    + x * x * ((f 1 0 0 + f (-1) 0 0) / 2 - f 0 0 0) + y * y * ((f 0 1 0 + f 0 (-1) 0) / 2 - f 0 0 0)
    + z * z * ((f 0 0 1 + f 0 0 (-1)) / 2 - f 0 0 0)
    + x * y * (f 1 1 0 - f 1 0 0 - f 0 1 0 + f 0 0 0) + x * z * (f 1 0 1 - f 1 0 0 - f 0 0 1 + f 0 0 0)
    + y * z * (f 0 1 1 - f 0 1 0 - f 0 0 1 + f 0 0 0).

Definition affine (f : R -> R -> R -> R) := forall x y z,
  f x y z = f 0 0 0 + x * (f 1 0 0 - f 0 0 0) + y * (f 0 1 0 - f 0 0 0) + z * (f 0 0 1 - f 0 0 0).
Lemma half_square_is_quadratic : forall a b c, affine a -> affine b -> affine c ->
  quadratic (fun x y z => (a x y z * a x y z + b x y z * b x y z + c x y z * c x y z) / 2).
Proof.
  intros a b c A B C x y z.
  rewrite (A x y z), (B x y z), (C x y z), (A 1 1 0), (B 1 1 0), (C 1 1 0), (A 1 0 1), (B 1 0 1), (C 1 0 1),
    (A 0 1 1), (B 0 1 1), (C 0 1 1), (A (-1) 0 0), (B (-1) 0 0), (C (-1) 0 0), (A 0 (-1) 0), (B 0 (-1) 0),
    (C 0 (-1) 0), (A 0 0 (-1)), (B 0 0 (-1)), (C 0 0 (-1)). field.
Qed.
Ltac is_quadratic :=
  try match goal with |- quadratic (fun x y z => (@?a x y z * _ + @?b x y z * _ + @?c x y z * _) / 2) =>
    apply (half_square_is_quadratic a b c); unfold affine end;
  unfold quadratic; intros; field.

Lemma over_cone_is : forall r h low f, h <> 0 -> quadratic f ->
  let u := 1 - low / h in
  over_cone (fun z => r * (1 - z / h)) low h f =
    PI * r ^ 2 * h * (f 0 0 0 * u ^ 3 / 3 + (f 0 0 1 - f 0 0 (-1)) / 2 * h * (u ^ 3 / 3 - u ^ 4 / 4)
      + ((f 0 0 1 + f 0 0 (-1)) / 2 - f 0 0 0) * h ^ 2 * (u ^ 3 / 3 - u ^ 4 / 2 + u ^ 5 / 5)
      + ((f 1 0 0 + f (-1) 0 0) / 2 + (f 0 1 0 + f 0 (-1) 0) / 2 - 2 * f 0 0 0) * r ^ 2 * u ^ 5 / 20).
Proof.
  intros r h low f nonzero by_values u.
  set (c := f 0 0 0). set (cz := (f 0 0 1 - f 0 0 (-1)) / 2).
  set (cx := (f 1 0 0 - f (-1) 0 0) / 2). set (cy := (f 0 1 0 - f 0 (-1) 0) / 2).
  set (xx := (f 1 0 0 + f (-1) 0 0) / 2 - f 0 0 0). set (yy := (f 0 1 0 + f 0 (-1) 0) / 2 - f 0 0 0).
  set (zz := (f 0 0 1 + f 0 0 (-1)) / 2 - f 0 0 0).
  set (xy := f 1 1 0 - f 1 0 0 - f 0 1 0 + f 0 0 0). set (xz := f 1 0 1 - f 1 0 0 - f 0 0 1 + f 0 0 0).
  set (yz := f 0 1 1 - f 0 1 0 - f 0 0 1 + f 0 0 0).
  assert (is : forall x y z, f x y z = c + cx * x + cy * y + cz * z + xx * x ^ 2 + yy * y ^ 2 + zz * z ^ 2
                                      + xy * x * y + xz * x * z + yz * y * z)
    by (intros; rewrite by_values; unfold c, cx, cy, cz, xx, yy, zz, xy, xz, yz; field).
  transitivity (PI * r ^ 2 * h * (c * u ^ 3 / 3 + cz * h * (u ^ 3 / 3 - u ^ 4 / 4)
      + zz * h ^ 2 * (u ^ 3 / 3 - u ^ 4 / 2 + u ^ 5 / 5) + (xx + yy) * r ^ 2 * u ^ 5 / 20));
    [| unfold xx, yy, zz, c, cz; field].
  unfold over_cone.
  rewrite (RInt_ext _ (fun z => 2 * PI * ((c + cz * z + zz * z ^ 2) * (r * (1 - z / h)) ^ 2 / 2
     + (xx + yy) * (r * (1 - z / h)) ^ 4 / 8))).
  2: { intros z _. set (p := r * (1 - z / h)).
    rewrite (RInt_ext _ (fun t => (c + cz * z + zz * z ^ 2) * p ^ 2 / 2
      + (cx + xz * z) * p ^ 3 / 3 * cos t + (cy + yz * z) * p ^ 3 / 3 * sin t
      + p ^ 4 / 4 * (xx * cos t ^ 2 + yy * sin t ^ 2 + xy * cos t * sin t))).
    2: { intros t _.
      rewrite (RInt_ext _ (fun s => s * (c + cx * (s * cos t) + cy * (s * sin t) + cz * z + xx * (s * cos t) ^ 2
         + yy * (s * sin t) ^ 2 + zz * z ^ 2 + xy * (s * cos t) * (s * sin t) + xz * (s * cos t) * z
         + yz * (s * sin t) * z))) by (intros; rewrite is; reflexivity).
      integrate (fun s => (c + cz * z + zz * z ^ 2) * s ^ 2 / 2
        + (cx + xz * z) * s ^ 3 / 3 * cos t + (cy + yz * z) * s ^ 3 / 3 * sin t
        + s ^ 4 / 4 * (xx * cos t ^ 2 + yy * sin t ^ 2 + xy * cos t * sin t)). field. }
    rewrite (RInt_by (fun t => (c + cz * z + zz * z ^ 2) * p ^ 2 / 2 * t
      + (cx + xz * z) * p ^ 3 / 3 * sin t - (cy + yz * z) * p ^ 3 / 3 * cos t
      + p ^ 4 / 8 * (xx * (t + sin t * cos t) + yy * (t - sin t * cos t) + xy * (sin t) ^ 2))).
    - rewrite cos_2PI, sin_2PI, cos_0, sin_0. in_reals. field.
    - intro t. assert (circle : sin t * sin t = 1 - cos t * cos t)
        by (pose proof (sin2_cos2 t) as all; unfold Rsqr in all; lra).
      auto_derive; trivial. field [circle].
    - intro. apply @ex_derive_continuous; auto_derive; trivial. }
  set (F := fun z => - h * PI * (r ^ 2 * (c * (1 - z / h) ^ 3 / 3
    + cz * h * ((1 - z / h) ^ 3 / 3 - (1 - z / h) ^ 4 / 4)
    + zz * h ^ 2 * ((1 - z / h) ^ 3 / 3 - (1 - z / h) ^ 4 / 2 + (1 - z / h) ^ 5 / 5))
    + (xx + yy) * r ^ 4 * (1 - z / h) ^ 5 / 20)).
  rewrite (RInt_by F); unfold F.
  - in_reals. unfold u. field. trivial.
  - intro z. auto_derive; [repeat split; trivial | field; trivial].
  - intro. apply @ex_derive_continuous; auto_derive; repeat split; trivial.
Qed.

Lemma over_chord : forall p a b, 0 <= p ->
  RInt (fun y => (a + b * (y * y)) * sqrt (p * p - y * y)) (- p) p = PI * (a * p ^ 2 / 2 + b * p ^ 4 / 8).
Proof.
  intros p a b P. pose proof PI_RGT_0 as half.
  assert (ends : forall f : R -> R, RInt f (- p) p = RInt f (p * sin (- (PI / 2))) (p * sin (PI / 2)) :> R)
    by (intro; f_equal; rewrite ?sin_neg, sin_PI2; ring).
  rewrite ends; clear ends.
  rewrite <- (RInt_comp (fun y => (a + b * (y * y)) * sqrt (p * p - y * y)) (fun u => p * sin u)
    (fun u => p * cos u)).
  - rewrite (RInt_ext _ (fun u => p ^ 2 * (a + b * p ^ 2 * sin u ^ 2) * cos u ^ 2)).
    + rewrite (RInt_by (fun u => p ^ 2 * (a / 2 * (u + sin u * cos u)
        + b * p ^ 2 * (u / 8 + sin u * cos u * (2 * sin u ^ 2 - 1) / 8)))).
      * in_reals. rewrite cos_neg, sin_neg, sin_PI2, cos_PI2. field.
      * intro u. assert (circle : sin u * sin u = 1 - cos u * cos u)
          by (pose proof (sin2_cos2 u) as all; unfold Rsqr in all; lra).
        auto_derive; trivial. field [circle].
      * intro. apply @ex_derive_continuous; auto_derive; trivial.
    + intros u. rewrite Rmin_left, Rmax_right by lra. intros B.
      assert (0 <= cos u) by (apply cos_ge_0; lra).
      replace (p * p - p * sin u * (p * sin u)) with ((p * cos u) * (p * cos u))
        by (pose proof (sin2_cos2 u) as all; unfold Rsqr in all; nra).
      rewrite sqrt_square by (apply Rmult_le_pos; lra).
      change (scal (p * cos u) ?x) with (p * cos u * x). in_reals. ring.
  - intros u _. apply (continuous_mult (K := R_AbsRing)).
    + apply @ex_derive_continuous; auto_derive; trivial.
    + apply continuous_comp; [apply @ex_derive_continuous; auto_derive; trivial | apply continuous_sqrt].
  - intros u _. split.
    + auto_derive; trivial. ring.
    + apply @ex_derive_continuous; auto_derive; trivial.
Qed.

Lemma above_zero : forall r h z, r > 0 -> h > 0 -> Rmin 0 h < z < Rmax 0 h -> 0 <= r * (1 - z / h).
Proof.
  intros r h z P H. rewrite Rmin_left, Rmax_right by lra. intros B.
  apply Rmult_le_pos; [lra |]. apply Rmult_le_reg_r with h; trivial. field_simplify; lra.
Qed.

Lemma by_y : forall B C r h (F : R -> R -> R), r > 0 -> h > 0 ->
  (forall z y, F z y = (B * (y * y) + C * (z * z)) * sqrt (r * (1 - z / h) * (r * (1 - z / h)) - y * y)) ->
  RInt (fun z => RInt (F z) (- (r * (1 - z / h))) (r * (1 - z / h))) 0 h
    = PI * r ^ 2 * h * (B * r ^ 2 / 40 + C * h ^ 2 / 60).
Proof.
  intros B C r h F P H is. assert (h <> 0) by lra.
  rewrite (RInt_ext _ (fun z => PI * (C * z ^ 2 * (r * (1 - z / h)) ^ 2 / 2 + B * (r * (1 - z / h)) ^ 4 / 8))).
  - integrate (fun z => PI * (- B * r ^ 4 * h * (1 - z / h) ^ 5 / 40
      + C * r ^ 2 / 2 * (z ^ 3 / 3 - z ^ 4 / (2 * h) + z ^ 5 / (5 * h ^ 2)))). field. lra.
  - intros z within. rewrite (RInt_ext _ (fun y => (C * (z * z) + B * (y * y))
      * sqrt (r * (1 - z / h) * (r * (1 - z / h)) - y * y))) by (intros y _; rewrite is; in_reals; ring).
    rewrite over_chord by now apply above_zero. in_reals. field. lra.
Qed.

(* the same from the base on, in x, y and z *)
Definition within_limits (rho : R -> R) (h : R) (f : R -> R -> R -> R) : R :=
  RInt (fun z => RInt (fun y => RInt (fun x => f x y z)
    (- sqrt (rho z * rho z - y * y)) (sqrt (rho z * rho z - y * y))) (- rho z) (rho z)) 0 h.

Lemma by_limits : forall A B C r h f, r > 0 -> h > 0 ->
  (forall x y z, f x y z = A * (x * x) + B * (y * y) + C * (z * z)) ->
  within_limits (fun z => r * (1 - z / h)) h f = PI * r ^ 2 * h * ((A + B) * r ^ 2 / 20 + C * h ^ 2 / 30).
Proof.
  intros A B C r h f P H is. assert (h <> 0) by lra. unfold within_limits.
  rewrite (RInt_ext _ (fun z => PI * (C * z ^ 2 * (r * (1 - z / h)) ^ 2 + (A + B) * (r * (1 - z / h)) ^ 4 / 4))).
  - integrate (fun z => PI * (- (A + B) * r ^ 4 * h * (1 - z / h) ^ 5 / 20
      + C * r ^ 2 * (z ^ 3 / 3 - z ^ 4 / (2 * h) + z ^ 5 / (5 * h ^ 2)))). field. lra.
  - intros z within. apply (above_zero r h z P H) in within. set (p := r * (1 - z / h)) in *.
    rewrite (RInt_ext _ (fun y => (2 * (C * (z * z)) + 2 / 3 * A * (p * p) + (2 * B - 2 / 3 * A) * (y * y))
      * sqrt (p * p - y * y))).
    + rewrite over_chord by trivial. in_reals. field.
    + intros y. rewrite Rmin_left, Rmax_right by lra. intros Y. set (w := sqrt (p * p - y * y)).
      assert (square : w * w = p * p - y * y) by (apply sqrt_sqrt; nra).
      rewrite (RInt_ext _ (fun x => A * (x * x) + B * (y * y) + C * (z * z))) by (intros; apply is).
      integrate (fun x => A * x ^ 3 / 3 + (B * (y * y) + C * (z * z)) * x). field [square].
Qed.

Lemma by_slices : forall F h, h <> 0 ->
  (forall z, F z = F 0 * (1 - z / h) ^ 4 + (16 * F (h / 2) - F 0) / h ^ 2 * z ^ 2 * (1 - z / h) ^ 2) ->
  RInt F 0 h = F 0 * h / 5 + (16 * F (h / 2) - F 0) * h / 30.
Proof.
  intros F h H is. set (A := F 0). set (B := (16 * F (h / 2) - F 0) / h ^ 2).
  replace (16 * F (h / 2) - A) with (B * h ^ 2) by (unfold A, B; field; trivial).
  rewrite (RInt_ext _ (fun z => A * (1 - z / h) ^ 4 + B * z ^ 2 * (1 - z / h) ^ 2)) by (intros z _; apply is).
  integrate (fun z => - A * h * (1 - z / h) ^ 5 / 5 + B * (z ^ 3 / 3 - z ^ 4 / (2 * h) + z ^ 5 / (5 * h ^ 2))).
  field. trivial.
Qed.

Lemma of_cubes : forall p, RInt (fun s => s ^ 3) 0 p = p ^ 4 / 4.
Proof. intro p. integrate (fun s : R => s ^ 4 / 4). field. Qed.

Lemma cube_root : Rpower 2 (1 / 3) ^ 3 = 2.
Proof.
  rewrite <- Rpower_pow by apply exp_pos. rewrite Rpower_mult.
  replace (1 / 3 * INR 3) with 1 by (simpl; lra). apply Rpower_1. lra.
Qed.

Ltac over_cones :=
  repeat match goal with |- context [over_cone (fun z => ?r * (1 - z / ?h)) ?low ?h ?f] =>
    match f with context [over_cone] => fail 1 | _ =>
      rewrite (over_cone_is r h low f) by first [lra | is_quadratic] end end.
Ltac above_center :=
  repeat match goal with |- context [over_cone ?rho 0 ?h ?f / over_cone ?rho 0 ?h ?g] =>
    replace (over_cone rho 0 h f / over_cone rho 0 h g) with (h / 4)
      by (over_cones; field; repeat split; solve [lra | apply PI_neq0]) end.
Ltac slices :=
  repeat match goal with
  | |- context [within_limits (fun z => ?r * (1 - z / ?h)) ?h ?f] =>
    first [rewrite (by_limits 0 1 1 r h f) by first [lra | intros; ring]
      | rewrite (by_limits 1 1 0 r h f) by first [lra | intros; ring]]
  | |- context [RInt (fun z => RInt (@?F z) (- (?r * (1 - z / ?h))) _) 0 ?h] =>
    first [rewrite (by_y 2 2 r h F) by first [lra | intros; ring]
      | rewrite (by_y 2 1 r h F) by first [lra | intros; ring]]
  | |- context [RInt ?F 0 ?h] => rewrite (by_slices F h) by first [lra | intros; rewrite ?of_cubes; field; lra]
  end; rewrite ?of_cubes.
Ltac no_integrals := above_center; over_cones; slices; cbv beta; try in_reals.

Ltac by_cube_root :=
  pose proof cube_root as cube; assert (Rpower 2 (1 / 3) > 0) by apply exp_pos;
  set (c := Rpower 2 (1 / 3)) in *; clearbody c; field [cube]; repeat split; lra.
