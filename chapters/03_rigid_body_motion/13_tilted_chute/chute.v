(* Roots and angles of a chute's slope and of a position in it, and zero second derivatives. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require Import Ratan.
From Coquelicot Require Import AutoDerive.
Local Open Scope R_scope.

Lemma root_is : forall x y, 0 < y -> x = y * y -> sqrt x = y.
Proof. intros x y P ->. apply sqrt_square. lra. Qed.
Lemma root_of : forall x, x > 0 -> sqrt x > 0 /\ sqrt x * sqrt x = x.
Proof. intros x P. split; [now apply sqrt_lt_R0 | apply sqrt_sqrt; lra]. Qed.
Lemma angle_of : forall L H, L > 0 -> L * L - H * H > 0 ->
  sin (asin (H / L)) = H / L /\ cos (asin (H / L)) = sqrt (L * L - H * H) / L.
Proof.
  intros L H P Q. assert (-1 <= H / L <= 1).
  { split; apply Rmult_le_reg_r with L; try lra; replace (H / L * L) with H by (field; lra); nra. }
  split; [now apply sin_asin |]. rewrite cos_asin by assumption.
  apply root_is.
  - apply Rdiv_lt_0_compat; [apply sqrt_lt_R0; nra | lra].
  - assert (sqrt (L * L - H * H) * sqrt (L * L - H * H) = L * L - H * H) as S by (apply sqrt_sqrt; nra).
    unfold Rsqr. field [S]. lra.
Qed.
Ltac steep :=
  match goal with P : ?H > 0, S : ?L - ?H > 0 |- context [sin (atan _)] =>
    replace ((L - H) * (L + H)) with (L * L - H * H) by ring; rewrite sin_atan;
    let Q := fresh in let e := fresh in let f := fresh in
    destruct (root_of (L * L - H * H)) as [Q e]; [nra |];
    generalize dependent (sqrt (L * L - H * H)); intros c Q e;
    assert (sqrt (1 + Rsqr (H / c)) = L / c) as f
      by (apply root_is; [apply Rdiv_lt_0_compat; lra | unfold Rsqr; field_simplify_eq; lra]);
    rewrite f; field; lra
  end.
Ltac not_zero e f :=
  first [nra | apply Rgt_not_eq; first [ring_simplify [e f] | ring_simplify [e] | idtac];
    repeat apply Rmult_lt_0_compat; try apply pow_lt; lra].
Ltac on_slope :=
  rewrite ?neg_sin, ?neg_cos, ?sin_2a; unfold tan;
  match goal with
    P : ?R > 0, Q : ?H > 0, S : ?L - ?H > 0, D : ?R * ?R - ?x2 * ?x2 > 0, C : cos ?phi > 0 |- _ =>
    let e := fresh in let f := fresh in let o := fresh in
    destruct (angle_of L H) as [e f]; [lra | nra | rewrite ?e, ?f; clear e f];
    destruct (angle_of R x2) as [e f]; [lra | nra | rewrite ?e, ?f; clear e f];
    replace ((L - H) * (L + H)) with (L * L - H * H) by ring;
    assert (o : sin phi * sin phi = 1 - cos phi * cos phi)
      by (pose proof (sin2_cos2 phi) as o; unfold Rsqr in o; lra);
    assert (f : sqrt (R * R - R * sin phi * (R * sin phi)) = R * cos phi)
      by (apply root_is; [nra | ring [o]]);
    rewrite ?f; clear f;
    assert (f : sqrt (R * R - R * - sin phi * (R * - sin phi)) = R * cos phi)
      by (apply root_is; [nra | ring [o]]);
    rewrite ?f; clear f;
    let c := fresh "c" in let d := fresh "d" in let e' := fresh in let f' := fresh in let pc := fresh in let pd := fresh in
    destruct (root_of (L * L - H * H)) as [pc e]; [nra |];
    destruct (root_of (R * R - x2 * x2) D) as [pd f];
    generalize dependent (sqrt (R * R - x2 * x2)); intros d pd f;
    generalize dependent (sqrt (L * L - H * H)); intros c pc e;
    try (apply root_is; [lra |]);
    try (replace (- c * - c + H * H) with (L * L) by (ring [e]); rewrite sqrt_square by lra);
    assert (H * H = L * L - c * c) as e' by lra; assert (x2 * x2 = R * R - d * d) as f' by lra;
    first [field [e' f' o] | field [e' o]]; repeat split; not_zero e' f'
  end.

Ltac on_chute := first [steep | on_slope].
Ltac slides_down :=
  match goal with P : ?g > 0, Q : ?H > 0, S : ?L - ?H > 0 |- ?a > 0 =>
    replace a with (g * (H / L) * (sqrt (L * L - H * H) / L)) by on_chute;
    apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [lra |] |]; apply Rdiv_lt_0_compat; try lra;
    apply sqrt_lt_R0; nra
  end.
Lemma no_bend : forall (h : R -> R -> R) (m : R), (forall x y, is_derive (fun z => h z y) x m) ->
  forall x y,
    Derive (fun z => h z y) x = m /\
    Derive (fun z => Derive (fun w => h w y) z) x = 0 /\ Derive (fun z => Derive (fun w => h w z) x) y = 0.
Proof.
  intros h m P x y. split; [apply is_derive_unique, P |].
  split; rewrite (Derive_ext _ (fun _ => m)); try apply Derive_const; intro; apply is_derive_unique, P.
Qed.
Ltac level_slope :=
  match goal with P : ?H > 0, S : ?L - ?H > 0 |- _ =>
    intros x y; replace ((L - H) * (L + H)) with (L * L - H * H) by ring;
    assert (sqrt (L * L - H * H) > 0) by (apply sqrt_lt_R0; nra);
    generalize dependent (sqrt (L * L - H * H)); intros c Q;
    match goal with |- context [sqrt (?z - y * y)] => generalize (sqrt (z - y * y)) end;
    intro; auto_derive; [exact I | field; repeat split; lra]
  end.
Ltac bends_of h m x1 x2 :=
  let P := fresh in assert (P : forall x y, is_derive (fun z => h z y) x m) by (cbv beta; level_slope);
  destruct (no_bend h m P x1 x2) as (? & ? & ?); clear P; cbv beta in *;
  match goal with P : ?it |- ?it => exact P end.
