(* Lemmas for claims about the highest point, at the angle `top`. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma on_orbits : forall e t, e > 0 -> 1 - e > 0 ->
  1 + e * cos t > 0 /\ sin t * sin t = 1 - cos t * cos t.
Proof.
  intros e t E U. pose proof (COS_bound t). pose proof (sin2_cos2 t) as C. unfold Rsqr in C. split; nra.
Qed.
Ltac by_height :=
  lazymatch goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, T : ?top > 0, B : PI - ?top > 0, F : _ = 0 |-
      _ =>
    try replace (1 - e ^ 2) with ((1 - e) * (1 + e)) by ring;
    destruct (on_orbits e top E U) as [D C]; assert (S : sin top > 0) by (apply sin_gt_0; lra);
    remember (cos top) as c eqn:is_c; remember (sin top) as s eqn:is_s; clear is_c is_s T B top;
    apply (f_equal (fun z => z * ((1 + e * c) * (1 + e * c) / (e * rho)))) in F; cbv beta in F; rewrite
        Rmult_0_l in F;
    match type of F with ?l = _ => replace l with (c + e * (c * c + s * s)) in F by (field; repeat split; lra)
        end;
    assert (is_c : c = - e) by (replace (c * c + s * s) with 1 in F by (rewrite C; ring); lra); subst c; clear
        F;
    assert (sine : s * s = (1 - e) * (1 + e)) by (rewrite C; ring);
    assert (root : sqrt ((1 - e) * (1 + e)) = s) by (apply sqrt_lem_1; [rewrite <- sine; apply Rle_0_sqr | lra
        | exact sine]);
    try rewrite root; try (replace (1 / ((1 - e) * (1 + e))) with (1 / (s * s)) by (rewrite C; f_equal;
        ring));
    field [sine]; repeat split; lra end.
Ltac by_top :=
  lazymatch goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0 |- _ =>
    assert (C : cos (acos (- e)) = - e) by (apply cos_acos; lra);
    assert (B : 0 < acos (- e) < PI) by (apply acos_bound_lt; lra);
    try lra;
    assert (S : sin (acos (- e)) > 0) by (apply sin_gt_0; lra);
    destruct (on_orbits e (acos (- e)) E U) as [_ Q]; rewrite C in *;
    remember (sin (acos (- e))) as s eqn:is_s; clear is_s B C;
    match goal with
    | |- _ = 0 => field [Q]; nra
    | |- context [cos ?t] =>
      destruct (on_orbits e t E U) as [D R]; remember (cos t) as c eqn:is_c; remember (sin t) as d eqn:is_d;
          clear is_c is_d;
      assert (q : 1 - e * e > 0) by nra;
      assert (L : d * (1 - e * e) <= s * (1 + e * c)) by (apply Rsqr_incr_0_var; [unfold Rsqr;
        replace (s * (1 + e * c) * (s * (1 + e * c))) with (s * s * ((1 + e * c) * (1 + e * c))) by ring;
            rewrite Q;
        replace (d * (1 - e * e) * (d * (1 - e * e))) with (d * d * ((1 - e * e) * (1 - e * e))) by ring;
            rewrite R;
        pose proof (Rle_0_sqr (c + e)) as N; unfold Rsqr in N;
        assert (0 <= (1 - e * e) * ((c + e) * (c + e))) by (apply Rmult_le_pos; lra); lra | apply Rlt_le,
            Rmult_lt_0_compat; lra]);
      assert (w : 0 < e * rho / ((1 + e * c) * (1 - e * e)))
        by (apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra);
      replace (e * rho / (1 + e * c) * d) with (e * rho / ((1 + e * c) * (1 - e * e)) * (d * (1 - e * e)))
        by (field; split; lra);
      replace (e * rho / (1 + e * - e) * s) with (e * rho / ((1 + e * c) * (1 - e * e)) * (s * (1 + e * c)))
        by (field; repeat split; lra);
      apply Rmult_le_compat_l; lra
    end end.
