(* Newton's law with the rods' tensions, and the difference of two solutions of Lagrange's equations. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

(* Elimination in the rods' tensions, which are positive definite. *)
Lemma quotient : forall d n, d > 0 -> d * (n / d) = n.
Proof. intros. field. lra. Qed.
Lemma elimination : forall i1 i2 i3 k1 k2 t1 t2 t3 T1 T2 T3, i1 > 0 -> i2 > 0 -> i3 > 0 ->
  k1 * k1 <= i1 * i1 -> k2 * k2 <= i2 * i2 ->
  let d2 := i2 + i1 - k1 / i1 * k1 in let u2 := t2 + k1 / i1 * t1 in
  T1 = (t1 + k1 * T2) / i1 -> T2 = (u2 + k2 * T3) / d2 -> T3 = (t3 + k2 / d2 * u2) / (i3 + i2 - k2 / d2 * k2)
      ->
  t1 = i1 * T1 - k1 * T2 /\ t2 = (i2 + i1) * T2 - k1 * T1 - k2 * T3 /\ t3 = (i3 + i2) * T3 - k2 * T2.
Proof.
  intros i1 i2 i3 k1 k2 t1 t2 t3 T1 T2 T3 P1 P2 P3 K1 K2 d2 u2 E1 E2 E3.
  assert (B2 : d2 >= i2).
  { unfold d2. assert (k1 / i1 * k1 <= i1); [| lra]. replace (k1 / i1 * k1) with (k1 * k1 / i1) by (field;
      lra).
    apply Rmult_le_reg_r with i1; [lra |]. replace (k1 * k1 / i1 * i1) with (k1 * k1) by (field; lra). lra. }
  assert (B3 : i3 + i2 - k2 / d2 * k2 > 0).
  { assert (k2 / d2 * k2 <= i2); [| lra]. replace (k2 / d2 * k2) with (k2 * k2 / d2) by (field; lra).
    apply Rmult_le_reg_r with d2; [lra |]. replace (k2 * k2 / d2 * d2) with (k2 * k2) by (field; lra). nra. }
  assert (F1 : i1 * T1 = t1 + k1 * T2) by (rewrite E1; apply quotient; lra).
  assert (F2 : d2 * T2 = u2 + k2 * T3) by (rewrite E2; apply quotient; lra).
  assert (F3 : (i3 + i2 - k2 / d2 * k2) * T3 = t3 + k2 / d2 * u2) by (rewrite E3; apply quotient; lra).
  clear E1 E2 E3. repeat split.
  - lra.
  - assert (k1 * T1 = k1 / i1 * t1 + k1 / i1 * k1 * T2) by (transitivity (k1 / i1 * (i1 * T1)); [field; lra |
      rewrite F1; ring]).
    unfold d2, u2 in F2. lra.
  - assert (k2 * T2 = k2 / d2 * u2 + k2 / d2 * k2 * T3) by (transitivity (k2 / d2 * (d2 * T2)); [field; lra |
      rewrite F2; ring]).
    lra.
Qed.

(* The acceleration of a mass from the one before, by the tensions of the rods about it. *)
Lemma turned : forall a b, cos a * sin (b - a) + sin a * cos (b - a) = sin b /\
  cos a * cos (b - a) - sin a * sin (b - a) = cos b /\
  cos b * sin (b - a) - sin b * cos (b - a) = - sin a /\ cos b * cos (b - a) + sin b * sin (b - a) = cos a.
Proof.
  intros a b. repeat split.
  - rewrite <- (Rplus_comm (sin a * _)), <- sin_plus. f_equal. ring.
  - rewrite <- cos_plus. f_equal. ring.
  - replace (- sin a) with (sin (b - a - b)) by (rewrite <- sin_neg; f_equal; ring). rewrite (sin_minus (b -
      a) b). ring.
  - replace (cos a) with (cos (b - (b - a))) by (f_equal; ring). rewrite (cos_minus b (b - a)). ring.
Qed.
Lemma below_one : forall i x, i > 0 -> (i * cos x) * (i * cos x) <= i * i.
Proof. intros i x P. pose proof (COS_bound x). assert (cos x * cos x <= 1) by nra. nra. Qed.

Section Links.
Variables m1 m2 m3 r1 r2 r3 a1 a2 a3 w1 w2 w3 g T1 T2 T3 b1 b2 b3 : R.
Hypothesis P1 : m1 > 0.
Hypothesis P2 : m2 > 0.
Hypothesis P3 : m3 > 0.
Hypothesis L1 : r1 > 0.
Hypothesis L2 : r2 > 0.
Hypothesis L3 : r3 > 0.
Hypothesis E1 : b1 = (- g * sin a1 + T2 * (1 / m1 * sin (a2 - a1))) / r1.
Hypothesis E2 : b2 = (- T1 * (1 / m1 * sin (a2 - a1)) + T3 * (1 / m2 * sin (a3 - a2))) / r2.
Hypothesis E3 : b3 = - T2 * (1 / m2 * sin (a3 - a2)) / r3.
Hypothesis F1 : r1 * w1 * w1 + g * cos a1 = 1 / m1 * T1 - 1 / m1 * cos (a2 - a1) * T2.
Hypothesis F2 : r2 * w2 * w2 = (1 / m2 + 1 / m1) * T2 - 1 / m1 * cos (a2 - a1) * T1 - 1 / m2 * cos (a3 - a2) *
    T3.
Hypothesis F3 : r3 * w3 * w3 = (1 / m3 + 1 / m2) * T3 - 1 / m2 * cos (a3 - a2) * T2.
Local Notation X1 := (r1 * (cos a1 * b1 - sin a1 * w1 * w1)).
Local Notation Y1 := (r1 * (sin a1 * b1 + cos a1 * w1 * w1)).
Local Notation X2 := (X1 + r2 * (cos a2 * b2 - sin a2 * w2 * w2)).
Local Notation Y2 := (Y1 + r2 * (sin a2 * b2 + cos a2 * w2 * w2)).
Local Notation X3 := (X2 + r3 * (cos a3 * b3 - sin a3 * w3 * w3)).
Local Notation Y3 := (Y2 + r3 * (sin a3 * b3 + cos a3 * w3 * w3)).
Lemma first_mass : m1 * X1 = T2 * sin a2 - T1 * sin a1 /\ m1 * (Y1 + g) = T1 * cos a1 - T2 * cos a2.
Proof.
  destruct (turned a1 a2) as [A [B _]].
  replace (r1 * (cos a1 * b1 - sin a1 * w1 * w1)) with (cos a1 * (r1 * b1) - sin a1 * (r1 * w1 * w1)) by ring.
  replace (r1 * (sin a1 * b1 + cos a1 * w1 * w1)) with (sin a1 * (r1 * b1) + cos a1 * (r1 * w1 * w1)) by ring.
  replace (r1 * b1) with (- g * sin a1 + T2 * (1 / m1 * sin (a2 - a1))) by (rewrite E1; field; lra).
  replace (r1 * w1 * w1) with (1 / m1 * T1 - 1 / m1 * cos (a2 - a1) * T2 - g * cos a1) by lra.
  rewrite <- A, <- B. pose proof (sin2_cos2 a1) as circle. unfold Rsqr in circle.
  assert (S : sin a1 * sin a1 = 1 - cos a1 * cos a1) by lra. split; field [S]; lra.
Qed.
Lemma second_mass : m2 * X2 = T3 * sin a3 - T2 * sin a2 /\ m2 * (Y2 + g) = T2 * cos a2 - T3 * cos a3.
Proof.
  destruct first_mass as [G1 H1]. destruct (turned a1 a2) as [_ [_ [A B]]]. destruct (turned a2 a3) as [C [D
      _]].
  replace X1 with ((T2 * sin a2 - T1 * sin a1) / m1) by (rewrite <- G1; field; lra).
  replace (Y1 + r2 * (sin a2 * b2 + cos a2 * w2 * w2) + g) with ((Y1 + g) + r2 * (sin a2 * b2 + cos a2 * w2 *
      w2)) by ring.
  replace (Y1 + g) with ((T1 * cos a1 - T2 * cos a2) / m1) by (rewrite <- H1; field; lra).
  replace (r2 * (cos a2 * b2 - sin a2 * w2 * w2)) with (cos a2 * (r2 * b2) - sin a2 * (r2 * w2 * w2)) by ring.
  replace (r2 * (sin a2 * b2 + cos a2 * w2 * w2)) with (sin a2 * (r2 * b2) + cos a2 * (r2 * w2 * w2)) by ring.
  replace (r2 * b2) with (- T1 * (1 / m1 * sin (a2 - a1)) + T3 * (1 / m2 * sin (a3 - a2))) by (rewrite E2;
      field; lra).
  rewrite F2, <- C, <- D. replace (sin a1) with (- (cos a2 * sin (a2 - a1) - sin a2 * cos (a2 - a1))) by lra.
  rewrite <- B. split; field; lra.
Qed.
Lemma third_mass : m3 * X3 = - T3 * sin a3 /\ m3 * (Y3 + g) = T3 * cos a3.
Proof.
  destruct second_mass as [G2 H2]. destruct (turned a2 a3) as [_ [_ [A B]]].
  replace X2 with ((T3 * sin a3 - T2 * sin a2) / m2) by (rewrite <- G2; field; lra).
  replace (Y3 + g) with ((Y2 + g) + r3 * (sin a3 * b3 + cos a3 * w3 * w3)) by ring.
  replace (Y2 + g) with ((T2 * cos a2 - T3 * cos a3) / m2) by (rewrite <- H2; field; lra).
  replace (r3 * (cos a3 * b3 - sin a3 * w3 * w3)) with (cos a3 * (r3 * b3) - sin a3 * (r3 * w3 * w3)) by ring.
  replace (r3 * (sin a3 * b3 + cos a3 * w3 * w3)) with (sin a3 * (r3 * b3) + cos a3 * (r3 * w3 * w3)) by ring.
  replace (r3 * b3) with (- T2 * (1 / m2 * sin (a3 - a2))) by (rewrite E3; field; lra).
  rewrite F3. replace (sin a2) with (- (cos a3 * sin (a3 - a2) - sin a3 * cos (a3 - a2))) by lra.
  rewrite <- B. split; field; lra.
Qed.
Lemma masses : (m1 * X1 = T2 * sin a2 - T1 * sin a1 /\ m1 * (Y1 + g) = T1 * cos a1 - T2 * cos a2) /\
  (m2 * X2 = T3 * sin a3 - T2 * sin a2 /\ m2 * (Y2 + g) = T2 * cos a2 - T3 * cos a3) /\
  (m3 * X3 = - T3 * sin a3 /\ m3 * (Y3 + g) = T3 * cos a3).
Proof. exact (conj first_mass (conj second_mass third_mass)). Qed.
End Links.
Ltac by_tensions :=
  let T1 := fresh "T1" in let T2 := fresh "T2" in let T3 := fresh "T3" in
  let D1 := fresh "D1" in let D2 := fresh "D2" in let D3 := fresh "D3" in
  lazymatch goal with E3 : _ = - ((_ + _ * ?y) / _) * _ / _ |- _ => remember y as T3 eqn:D3 in * end;
  lazymatch goal with E3 : _ = - ?x * _ / _ |- _ => remember x as T2 eqn:D2 in * end;
  lazymatch goal with E2 : _ = (- ?z * _ + T3 * _) / _ |- _ => remember z as T1 eqn:D1 in * end;
  lazymatch goal with
  | P1 : ?m1 > 0, P2 : ?m2 > 0, P3 : ?m3 > 0, L1 : ?r1 > 0, L2 : ?r2 > 0, L3 : ?r3 > 0,
    E1 : _ = (- _ * sin ?a1 + _) / ?r1, E2 : _ = _ / ?r2, E3 : _ = - _ * (1 / ?m2 * sin (?a3 - ?a2)) / ?r3,
    D : _ = _ / (1 / ?m3 + 1 / ?m2 - _), S : _ = _ / (1 / ?m1) |- _ =>
    assert (I1 : 1 / m1 > 0) by (apply Rdiv_lt_0_compat; lra);
    assert (I2 : 1 / m2 > 0) by (apply Rdiv_lt_0_compat; lra);
    assert (I3 : 1 / m3 > 0) by (apply Rdiv_lt_0_compat; lra);
    destruct (elimination _ _ _ _ _ _ _ _ T1 T2 T3 I1 I2 I3 (below_one _ (a2 - a1) I1) (below_one _ (a3 - a2)
        I2) D1 D2 D3)
      as [F1 [F2 F3]];
    destruct (masses _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P1 P2 P3 L1 L2 L3 E1 E2 E3 F1 F2 F3) as [[X1 Y1]
        [[X2 Y2] [X3 Y3]]]
  end;
  lazymatch goal with
  | X1 : ?x1 = T2 * _ - T1 * _, Y1 : ?y1 = T1 * _ - T2 * _, X2 : ?x2 = T3 * _ - T2 * _, Y2 : ?y2 = T2 * _ - T3
      * _,
    X3 : ?x3 = - T3 * sin ?a3, Y3 : ?y3 = T3 * _, E1 : _ = (- _ * sin ?a1 + _) / ?r1, E2 : _ = _ / ?r2,
    E3 : _ = - _ * (1 / _ * sin (?a3 - ?a2)) / ?r3 |- ?l = 0 =>
    clear - X1 X2 X3 Y1 Y2 Y3;
    first [ replace l with (r1 * (cos a1 * (x1 + x2 + x3) + sin a1 * (y1 + y2 + y3))) by field
          | replace l with (r2 * (cos a2 * (x2 + x3) + sin a2 * (y2 + y3))) by field
          | replace l with (r3 * (cos a3 * x3 + sin a3 * y3)) by field ];
    rewrite ?X1, ?X2, ?X3, ?Y1, ?Y2, ?Y3; ring
  end.

(* What two solutions differ by has no energy. *)
Lemma no_speed : forall r x t, r > 0 -> r * cos t * x = 0 -> r * sin t * x = 0 -> x = 0.
Proof.
  intros r x t P C S. pose proof (sin2_cos2 t) as circle. unfold Rsqr in circle.
  apply (Rmult_eq_reg_l r); [| lra].
  transitivity (r * x * (sin t * sin t + cos t * cos t)); [rewrite circle; ring |].
  transitivity (sin t * (r * sin t * x) + cos t * (r * cos t * x)); [ring | rewrite C, S; ring].
Qed.
Lemma no_energy : forall m1 m2 m3 x1 y1 x2 y2 x3 y3, m1 > 0 -> m2 > 0 -> m3 > 0 ->
  m1 * (x1 * x1 + y1 * y1) + m2 * (x2 * x2 + y2 * y2) + m3 * (x3 * x3 + y3 * y3) = 0 ->
  x1 = 0 /\ y1 = 0 /\ x2 = 0 /\ y2 = 0 /\ x3 = 0 /\ y3 = 0.
Proof.
  assert (squares : forall m x y, m > 0 -> 0 <= m * (x * x + y * y)) by (intros; apply Rmult_le_pos; nra).
  assert (zero : forall m x y, m > 0 -> m * (x * x + y * y) = 0 -> x = 0 /\ y = 0).
  { intros m x y P E. assert (x * x + y * y = 0) by (apply (Rmult_eq_reg_l m); lra). split; nra. }
  intros m1 m2 m3 x1 y1 x2 y2 x3 y3 P1 P2 P3 E.
  pose proof (squares m1 x1 y1 P1). pose proof (squares m2 x2 y2 P2). pose proof (squares m3 x3 y3 P3).
  destruct (zero m1 x1 y1 P1); [lra |]. destruct (zero m2 x2 y2 P2); [lra |]. destruct (zero m3 x3 y3 P3);
      [lra |].
  tauto.
Qed.
(* By positive masses m and lengths r, and the equations' left sides l and k for b and c. *)
Ltac by_energy M1 M2 M3 R1 R2 R3 L1 K1 L2 K2 L3 K3 a1 a2 a3 b1 b2 b3 c1 c2 c3 :=
  lazymatch type of M1 with ?m1 > 0 => lazymatch type of M2 with ?m2 > 0 => lazymatch type of M3 with ?m3 > 0 =>
  lazymatch type of R1 with ?r1 > 0 => lazymatch type of R2 with ?r2 > 0 => lazymatch type of R3 with ?r3 > 0 =>
  lazymatch type of L1 with ?l1 = 0 => lazymatch type of K1 with ?k1 = 0 =>
  lazymatch type of L2 with ?l2 = 0 => lazymatch type of K2 with ?k2 = 0 =>
  lazymatch type of L3 with ?l3 = 0 => lazymatch type of K3 with ?k3 = 0 =>
    set (x1 := r1 * cos a1 * (b1 - c1)); set (y1 := r1 * sin a1 * (b1 - c1));
    set (x2 := r2 * cos a2 * (b2 - c2)); set (y2 := r2 * sin a2 * (b2 - c2));
    set (x3 := r3 * cos a3 * (b3 - c3)); set (y3 := r3 * sin a3 * (b3 - c3));
    assert (E : m1 * (x1 * x1 + y1 * y1) + m2 * ((x1 + x2) * (x1 + x2) + (y1 + y2) * (y1 + y2))
      + m3 * ((x1 + x2 + x3) * (x1 + x2 + x3) + (y1 + y2 + y3) * (y1 + y2 + y3)) = 0)
      by (transitivity ((b1 - c1) * (l1 - k1) + (b2 - c2) * (l2 - k2) + (b3 - c3) * (l3 - k3));
        [unfold x1, y1, x2, y2, x3, y3; field | rewrite L1, K1, L2, K2, L3, K3; ring]);
    destruct (no_energy _ _ _ _ _ _ _ _ _ M1 M2 M3 E) as [X1 [Y1 [X2 [Y2 [X3 Y3]]]]];
    assert (D1 : b1 - c1 = 0) by exact (no_speed r1 _ a1 R1 X1 Y1);
    assert (D2 : b2 - c2 = 0) by (apply (no_speed r2 _ a2 R2); fold x2; fold y2; lra);
    assert (D3 : b3 - c3 = 0) by (apply (no_speed r3 _ a3 R3); fold x3; fold y3; lra);
    rewrite D1, D2, D3; ring
  end end end end end end end end end end end end.
