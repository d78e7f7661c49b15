(* For orthonormal r and u and their product b: their mutual products, and any vector in their frame. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require Import Nsatz.
Local Open Scope R_scope.

Lemma orthonormal : forall r0 r1 r2 u0 u1 u2 : R,
  r0 * r0 + r1 * r1 + r2 * r2 = 1 -> u0 * u0 + u1 * u1 + u2 * u2 = 1 -> r0 * u0 + r1 * u1 + r2 * u2 = 0 ->
  let b0 := r1 * u2 - r2 * u1 in let b1 := r2 * u0 - r0 * u2 in let b2 := r0 * u1 - r1 * u0 in
  (b0 * b0 + b1 * b1 + b2 * b2 = 1 /\ r0 * b0 + r1 * b1 + r2 * b2 = 0 /\ u0 * b0 + u1 * b1 + u2 * b2 = 0) /\
  (r1 * u2 = b0 + r2 * u1 /\ r2 * u0 = b1 + r0 * u2 /\ r0 * u1 = b2 + r1 * u0) /\
  (u1 * b2 = r0 + u2 * b1 /\ u2 * b0 = r1 + u0 * b2 /\ u0 * b1 = r2 + u1 * b0) /\
  (b1 * r2 = u0 + b2 * r1 /\ b2 * r0 = u1 + b0 * r2 /\ b0 * r1 = u2 + b1 * r0) /\
  forall a0 a1 a2,
  let a := r0 * a0 + r1 * a1 + r2 * a2 in let b := u0 * a0 + u1 * a1 + u2 * a2 in
  let c := b0 * a0 + b1 * a1 + b2 * a2 in
  a0 = a * r0 + b * u0 + c * b0 /\ a1 = a * r1 + b * u1 + c * b1 /\ a2 = a * r2 + b * u2 + c * b2.
Proof. intros. unfold b0, b1, b2. repeat split; intros; try ring; nsatz. Qed.
