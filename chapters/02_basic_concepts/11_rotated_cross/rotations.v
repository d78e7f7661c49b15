(* Products of vectors that a unit quaternion rotates. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/orthonormal.v".

(* Rotated by the quaternion (C, S w), vectors keep their products. *)
Section Rotated.
Variables S C w0 w1 w2 : R.
Hypothesis circle : C * C = 1 - S * S.
Hypothesis unit_axis : w2 * w2 = 1 - w0 * w0 - w1 * w1.
Definition rotated0 p0 p1 p2 := p0 + C * (2 * (S * w1 * p2 - S * w2 * p1))
  + (S * w1 * (2 * (S * w0 * p1 - S * w1 * p0)) - S * w2 * (2 * (S * w2 * p0 - S * w0 * p2))).
Definition rotated1 p0 p1 p2 := p1 + C * (2 * (S * w2 * p0 - S * w0 * p2))
  + (S * w2 * (2 * (S * w1 * p2 - S * w2 * p1)) - S * w0 * (2 * (S * w0 * p1 - S * w1 * p0))).
Definition rotated2 p0 p1 p2 := p2 + C * (2 * (S * w0 * p1 - S * w1 * p0))
  + (S * w0 * (2 * (S * w2 * p0 - S * w0 * p2)) - S * w1 * (2 * (S * w1 * p2 - S * w2 * p1))).
Lemma keeps_dot : forall p0 p1 p2 q0 q1 q2,
  rotated0 p0 p1 p2 * rotated0 q0 q1 q2 + rotated1 p0 p1 p2 * rotated1 q0 q1 q2 + rotated2 p0 p1 p2 * rotated2
      q0 q1 q2
    = p0 * q0 + p1 * q1 + p2 * q2.
Proof. intros. unfold rotated0, rotated1, rotated2. ring [circle unit_axis]. Qed.
Lemma keeps_cross : forall p0 p1 p2 q0 q1 q2,
  let r0 := p1 * q2 - p2 * q1 in let r1 := p2 * q0 - p0 * q2 in let r2 := p0 * q1 - p1 * q0 in
  rotated1 p0 p1 p2 * rotated2 q0 q1 q2 - rotated2 p0 p1 p2 * rotated1 q0 q1 q2 = rotated0 r0 r1 r2 /\
  rotated2 p0 p1 p2 * rotated0 q0 q1 q2 - rotated0 p0 p1 p2 * rotated2 q0 q1 q2 = rotated1 r0 r1 r2 /\
  rotated0 p0 p1 p2 * rotated1 q0 q1 q2 - rotated1 p0 p1 p2 * rotated0 q0 q1 q2 = rotated2 r0 r1 r2.
Proof. intros. unfold r0, r1, r2, rotated0, rotated1, rotated2. repeat split; ring [circle unit_axis]. Qed.
Lemma keeps_volume : forall p0 p1 p2 q0 q1 q2,
  let r0 := p1 * q2 - p2 * q1 in let r1 := p2 * q0 - p0 * q2 in let r2 := p0 * q1 - p1 * q0 in
  (rotated1 p0 p1 p2 * rotated2 q0 q1 q2 - rotated2 p0 p1 p2 * rotated1 q0 q1 q2) * rotated0 r0 r1 r2
    + (rotated2 p0 p1 p2 * rotated0 q0 q1 q2 - rotated0 p0 p1 p2 * rotated2 q0 q1 q2) * rotated1 r0 r1 r2
    + (rotated0 p0 p1 p2 * rotated1 q0 q1 q2 - rotated1 p0 p1 p2 * rotated0 q0 q1 q2) * rotated2 r0 r1 r2
    = r0 * r0 + r1 * r1 + r2 * r2.
Proof.
  intros. destruct (keeps_cross p0 p1 p2 q0 q1 q2) as [E0 [E1 E2]]. rewrite E0, E1, E2. apply keeps_dot.
Qed.
End Rotated.
Ltac by_rotation a0 a1 a2 b0 b1 b2 :=
  lazymatch goal with u : ?u0 * ?u0 + ?u1 * ?u1 + ?u2 * ?u2 = 1, v : ?v0 * ?v0 + ?v1 * ?v1 + ?v2 * ?v2 = 1,
    W0 : ?u1 * ?v2 - ?u2 * ?v1 = ?w0, W1 : _ = ?w1, W2 : ?u0 * ?v1 - ?u1 * ?v0 = ?w2, across : ?u0 * ?v0 + _ +
        _ = 0
  |- context [sin (?theta / 2)] =>
    assert (circle : cos (theta / 2) * cos (theta / 2) = 1 - sin (theta / 2) * sin (theta / 2))
      by (pose proof (sin2_cos2 (theta / 2)) as one; unfold Rsqr in one; lra);
    destruct (orthonormal u0 u1 u2 v0 v1 v2 u v across) as [[w_w _] _]; rewrite W0, W1, W2 in w_w;
    assert (unit_axis : w2 * w2 = 1 - w0 * w0 - w1 * w1) by lra;
    set (S := sin (theta / 2)) in *; set (C := cos (theta / 2)) in *; clearbody S C
  end;
  lazymatch goal with circle : ?C * ?C = _, unit_axis : _ = 1 - ?w0 * ?w0 - ?w1 * ?w1 |- _ =>
    set (d0 := 1 / sqrt (a0 * a0 + a1 * a1 + a2 * a2) * a0); set (d1 := 1 / sqrt (a0 * a0 + a1 * a1 + a2 * a2)
        * a1);
    set (d2 := 1 / sqrt (a0 * a0 + a1 * a1 + a2 * a2) * a2); set (e0 := 1 / sqrt (b0 * b0 + b1 * b1 + b2 * b2)
        * b0);
    set (e1 := 1 / sqrt (b0 * b0 + b1 * b1 + b2 * b2) * b1); set (e2 := 1 / sqrt (b0 * b0 + b1 * b1 + b2 * b2)
        * b2);
    clearbody d0 d1 d2 e0 e1 e2;
    pose proof (keeps_dot _ _ _ _ _ circle unit_axis) as K;
    first [ exact (K d0 d1 d2 d0 d1 d2) | exact (K d0 d1 d2 e0 e1 e2) | exact (K e0 e1 e2 e0 e1 e2)
          | exact (K d0 d1 d2 (d1 * e2 - d2 * e1) (d2 * e0 - d0 * e2) (d0 * e1 - d1 * e0))
          | exact (K e0 e1 e2 (d1 * e2 - d2 * e1) (d2 * e0 - d0 * e2) (d0 * e1 - d1 * e0))
          | exact (K (d1 * e2 - d2 * e1) (d2 * e0 - d0 * e2) (d0 * e1 - d1 * e0) (d1 * e2 - d2 * e1) (d2 * e0
              - d0 * e2) (d0 * e1 - d1 * e0))
          | exact (keeps_volume _ _ _ _ _ circle unit_axis d0 d1 d2 e0 e1 e2) ]
  end.
