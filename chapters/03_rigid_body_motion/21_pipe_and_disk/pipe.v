(* Identities of the angles on the pipe. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma circle : forall x, sin x * sin x = 1 - cos x * cos x.
Proof. intro x. pose proof (sin2_cos2 x) as H. unfold Rsqr in H. lra. Qed.
Lemma circle_of_sine : forall x, cos x * cos x = 1 - sin x * sin x.
Proof. intro x. pose proof (sin2_cos2 x) as H. unfold Rsqr in H. lra. Qed.
Ltac on_pipe phi theta psi :=
  rewrite ?cos_0, ?sin_0;
  let e1 := fresh in let e2 := fresh in let e3 := fresh in
  pose proof (circle_of_sine phi) as e1; pose proof (circle theta) as e2; pose proof (circle psi) as e3;
  generalize dependent (sin phi); intro; generalize dependent (cos phi); intros;
  generalize dependent (sin theta); intro; generalize dependent (cos theta); intros;
  generalize dependent (sin psi); intro; generalize dependent (cos psi); intros;
  field [e1 e2 e3]; repeat split; apply Rgt_not_eq; ring_simplify [e1 e2 e3];
  repeat apply Rplus_lt_0_compat; repeat apply Rmult_lt_0_compat; try apply pow_lt; lra.
