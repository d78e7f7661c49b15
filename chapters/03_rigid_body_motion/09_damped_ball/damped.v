(* Damped motions and their arrivals. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Local Open Scope R_scope.
Lemma root_of : forall x, x > 0 -> sqrt x > 0 /\ sqrt x * sqrt x = x.
Proof. intros x P. split; [now apply sqrt_lt_R0 | apply sqrt_sqrt; lra]. Qed.
Ltac damped :=
  rewrite ?exp_0, ?cos_0, ?sin_0;
  match goal with P : ?d > 0 |- context [sqrt ?d] =>
    let Q := fresh in let e := fresh in let r := fresh in
    destruct (root_of d P) as [Q e]; generalize dependent (sqrt d); intros r Q e;
    field [e]; repeat split; nra
  end.
Ltac circling :=
  match goal with |- context [sin ?z] =>
    let f := fresh in
    assert (f : sin z * sin z = 1 - cos z * cos z)
      by (pose proof (sin2_cos2 z) as f; unfold Rsqr in f; lra);
    generalize dependent (sin z); intro; generalize (cos z); intros;
    match goal with P : _ > 0 |- context [sqrt ?d] =>
      assert (sqrt d > 0) by (apply sqrt_lt_R0; lra); field [f]; repeat split; lra
    end
  end.
Ltac turning :=
  match goal with |- exp ?y * _ = exp ?x * (_ * cos ?z + _) * _ - _ =>
    let e := fresh in
    assert (e : exp y = exp x * exp x) by (rewrite <- exp_plus; f_equal; field; lra); rewrite e; clear e;
    circling
  end.
Ltac any_motion := first [turning | damped | circling | field; repeat split; apply Rgt_not_eq; nra].
Ltac twice :=
  rewrite ?exp_0;
  match goal with P : ?m > 0, Q : ?a * ?a = 4 * ?m * ?c |- _ =>
    assert (c = a * a / (4 * m)) by (rewrite Q; field; lra); subst c; field; lra
  end.
Ltac pairing :=
  match goal with Z : exp ?y * _ = 0 |- _ =>
    pose proof (exp_pos y); apply Rmult_integral in Z; destruct Z as [Z | Z]; first [exact Z | lra]
  end.
Ltac turned_pair alpha beta p v t :=
  match goal with Z : exp ?y * _ = 0 |- _ =>
    pose proof (exp_pos y); apply Rmult_integral in Z; destruct Z as [Z | Z]; [lra |];
    assert (C : sin (beta * t) * sin (beta * t) = 1 - cos (beta * t) * cos (beta * t))
      by (pose proof (sin2_cos2 (beta * t)) as f; unfold Rsqr in f; lra);
    set (k := (v - alpha * p) / beta) in *; set (s := sin (beta * t)) in *; set (c := cos (beta * t)) in *;
    set (e := exp y) in *; clearbody k s c e;
    assert (S : k * s = - (p * c)) by lra; assert (P : p * c = - (k * s)) by lra;
    first [field [S C] | field [P C]]; split; first [assumption | lra]
  end.
Ltac arriving beta :=
  match goal with |- context [?b * (PI / 2 + atan ?q)] =>
    destruct (atan_bound q);
    match goal with
    | |- _ = 0 =>
      replace (beta * (b * (PI / 2 + atan q))) with (PI / 2 + atan q) by (field; lra);
      rewrite cos_plus, sin_plus, cos_PI2, sin_PI2, sin_atan, cos_atan;
      let R := fresh in
      assert (R : sqrt (1 + Rsqr q) > 0) by (apply sqrt_lt_R0; pose proof (Rle_0_sqr q); lra);
      generalize dependent (sqrt (1 + Rsqr q)); intros; field; repeat split; nra
    | |- _ => set (z := atan q) in *; clearbody z; first
      [ replace (PI / beta - b * (PI / 2 + z)) with ((PI / 2 - z) / beta) by (field; lra);
        apply Rdiv_lt_0_compat; lra
      | replace (b * (PI / 2 + z)) with ((PI / 2 + z) / beta) by (field; lra);
        apply Rdiv_lt_0_compat; lra ]
    end
  end.
