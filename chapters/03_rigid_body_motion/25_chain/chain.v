(* Identities of the angles of the chain. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Ltac circle x :=
  let e := fresh in
  assert (e : sin x * sin x = 1 - cos x * cos x) by (pose proof (sin2_cos2 x) as e; unfold Rsqr in e; lra);
  generalize dependent (sin x); intro; generalize dependent (cos x); intros.
Ltac hanging a b c :=
  rewrite ?cos_minus, ?sin_minus, ?cos_PI2, ?sin_PI2;
  circle a; circle b; circle c;
  match goal with A : _ = 1 - _, B : _ = 1 - _, C : _ = 1 - _ |- _ => field [A B C] end; lra.
