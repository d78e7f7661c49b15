(* An ellipse and the time of its turn. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "orbits.v".

From Coquelicot Require Import Continuity RInt_analysis.

(* The time of a turn, by the eccentric anomaly: its antiderivative has no jump. *)
Section Turn.
Variables p q : R.
Hypothesis inside : p * p + q * q < 1.
Local Notation s := (sqrt (1 - (p * p + q * q))).
Local Notation slow t := (1 + p * cos t + q * sin t).
Local Notation slant t := (p * sin t - q * cos t).
Lemma root_in_ellipse : 0 < s <= 1 /\ s * s = 1 - (p * p + q * q).
Proof.
  assert (s * s = 1 - (p * p + q * q)) by (apply sqrt_sqrt; lra).
  assert (0 < s) by (apply sqrt_lt_R0; lra). repeat split; trivial. nra.
Qed.
Lemma slow_positive : forall t, slow t > 0.
Proof. intro t. pose proof (unit_circle t). pose proof (Rle_0_sqr (p * sin t - q * cos t)) as S. unfold Rsqr
    in S.
  assert ((p * cos t + q * sin t) * (p * cos t + q * sin t) < 1) by nra. nra. Qed.
Definition anomaly t := (t - 2 * atan (slant t / (s + slow t)) - s * slant t / slow t) / s ^ 3.
Lemma anomaly_rate : forall t, is_derive anomaly t (1 / slow t ^ 2).
Proof.
  intro t. destruct root_in_ellipse as [B S]. pose proof (slow_positive t) as P. pose proof (unit_circle t) as
      C.
  unfold anomaly. auto_derive; [repeat split; lra|].
  match goal with |- ?x = ?y => change (@eq R x y) end.
  assert (N2 : slant t * slant t = 1 - s * s - (slow t - 1) * (slow t - 1)) by (rewrite S; ring [C]).
  unfold Rsqr. set (r := s) in *. clearbody r.
  set (c := cos t) in *. set (d := sin t) in *. clearbody c d.
  set (D := 1 + p * c + q * d) in *. set (N := p * d - q * c) in *.
  transitivity ((1 - 2 * ((((D - 1) * (r + D) + N * N) / ((r + D) * (r + D))) / (1 + N / (r + D) * (N / (r +
      D)))) - r * ((D - 1) * D + N * N) / (D * D)) / r ^ 3).
  - unfold D, N in *. field. repeat split; first [lra | apply Rgt_not_eq; pose proof (Rle_0_sqr (p * d - q *
      c)) as Q; unfold Rsqr in Q; assert (0 < (r + (1 + p * c + q * d)) * (r + (1 + p * c + q * d))) by (apply
      Rmult_lt_0_compat; lra); lra].
  - clearbody D N.
    assert (Q : 1 + N / (r + D) * (N / (r + D)) = 2 * D * (1 + r) / ((r + D) * (r + D))).
    { replace (N / (r + D) * (N / (r + D))) with (N * N / ((r + D) * (r + D))) by (field; lra). rewrite N2.
        field. lra. }
    rewrite Q, N2. field. repeat split; lra.
Qed.
Lemma turn_time : is_RInt (fun t => 1 / slow t ^ 2) 0 (2 * PI) (2 * PI / s ^ 3).
Proof.
  destruct root_in_ellipse as [B _].
  replace (2 * PI / s ^ 3) with (minus (anomaly (2 * PI)) (anomaly 0))
    by (unfold minus, plus, opp, anomaly; simpl; rewrite sin_2PI, cos_2PI, sin_0, cos_0; unfold Rdiv; ring).
  apply (is_RInt_derive anomaly (fun t => 1 / slow t ^ 2)); intros t _; [apply anomaly_rate |].
  pose proof (slow_positive t) as P. apply @ex_derive_continuous; auto_derive.
  repeat split; trivial; apply Rgt_not_eq; simpl; rewrite Rmult_1_r; now apply Rmult_lt_0_compat.
Qed.
End Turn.

Lemma eccentricity : forall mu r0 rd w0, r0 > 0 -> w0 <> 0 ->
  0 <= (r0 * r0 * r0 * w0 * w0 - mu) ^ 2 + r0 * r0 * rd * w0 * (r0 * r0 * rd * w0) /\
  (rd * rd + r0 * r0 * w0 * w0) / 2 - mu / r0 =
    ((r0 * r0 * r0 * w0 * w0 - mu) ^ 2 + r0 * r0 * rd * w0 * (r0 * r0 * rd * w0) - mu * mu) / (2 * (r0 * r0 *
        w0) ^ 2).
Proof.
  intros mu r0 rd w0 far turns. split; [| field; lra].
  apply Rplus_le_le_0_compat; [apply pow2_ge_0 | apply Rle_0_sqr].
Qed.

Section Ellipse.
Variables mu r0 rd th0 w0 : R.
Variables x y u v : R -> R.
Hypothesis pulled : mu > 0.
Hypothesis far : r0 > 0.
Hypothesis turns : w0 <> 0.
Hypothesis path : newton mu x y u v.
Hypothesis x0 : x 0 = r0 * cos th0.
Hypothesis y0 : y 0 = r0 * sin th0.
Hypothesis u0 : u 0 = rd * cos th0 - r0 * w0 * sin th0.
Hypothesis v0 : v 0 = rd * sin th0 + r0 * w0 * cos th0.
Local Notation square := ((r0 * r0 * r0 * w0 * w0 - mu) ^ 2 + r0 * r0 * rd * w0 * (r0 * r0 * rd * w0)).
Local Notation h := (r0 * r0 * w0).
Local Notation ax := (along_x mu r0 rd th0 w0).
Local Notation ay := (along_y mu r0 rd th0 w0).

Lemma no_stop : h <> 0.
Proof. repeat apply Rmult_integral_contrapositive_currified; lra. Qed.
Lemma length_of_vector : ax * ax + ay * ay = square.
Proof. pose proof (unit_circle th0) as circle. unfold along_x, along_y. ring [circle]. Qed.
Lemma energy_later : forall t th, at_angle x y t th ->
  ((u t) ^ 2 + (v t) ^ 2) / 2 - mu / distance x y t = (square - mu * mu) / (2 * h ^ 2).
Proof.
  intros t th on. destruct (on_orbit _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ on) as [D0 [is_r [is_u
      is_v]]].
  rewrite is_r, is_u, is_v, <- length_of_vector. pose proof (unit_circle th) as circle. pose proof no_stop.
  replace (mu / (h ^ 2 / pull_over_V mu r0 rd th0 w0 th)) with (mu * pull_over_V mu r0 rd th0 w0 th / h ^ 2)
      by (field; repeat split; lra).
  unfold pull_over_V. set (p := ax) in *. set (q := ay) in *. field [circle]. split; lra.
Qed.

Variables c0 c1 g : R.
Hypothesis is_c0 : c0 = - mu * ay / h ^ 2.
Hypothesis is_c1 : c1 = - mu * ax / h ^ 2.
Hypothesis g0 : g > 0.
Hypothesis is_g : g * g = square.
Hypothesis bound : g < mu.
Local Notation s := (sqrt (1 - (g / mu) ^ 2)).

Lemma flattening : s > 0 /\ s * s = 1 - (g / mu) ^ 2.
Proof.
  assert (g / mu < 1) by (apply Rmult_lt_reg_r with mu; [| replace (g / mu * mu) with g by (field; lra)];
      lra).
  assert (g / mu > 0) by (apply Rdiv_lt_0_compat; lra).
  assert (0 < 1 - (g / mu) ^ 2) by (replace ((g / mu) ^ 2) with (g / mu * (g / mu)) by ring; nra).
  split; [now apply sqrt_lt_R0 | apply sqrt_sqrt; lra].
Qed.
Lemma turn_is :
  RInt (fun t => (- mu / (c0 * sin t + c1 * cos t - (mu / h) ^ 2)) ^ 2 / Rabs h) 0 (2 * PI)
    = 2 * PI * h ^ 4 / (Rabs h * mu ^ 2 * s ^ 3).
Proof.
  pose proof no_stop as N. pose proof (Rabs_no_R0 _ N). destruct flattening as [S0 S].
  assert (e : ax / mu * (ax / mu) + ay / mu * (ay / mu) = (g / mu) ^ 2)
    by (transitivity ((ax * ax + ay * ay) / mu ^ 2); [field; lra | rewrite length_of_vector, <- is_g; field;
        lra]).
  assert (inside : ax / mu * (ax / mu) + ay / mu * (ay / mu) < 1) by nra.
  pose proof (turn_time _ _ inside) as T. rewrite e in T.
  apply is_RInt_unique.
  replace (2 * PI * h ^ 4 / (Rabs h * mu ^ 2 * s ^ 3)) with (h ^ 4 / (Rabs h * mu ^ 2) * (2 * PI / s ^ 3))
    by (field; repeat split; first [assumption | lra]).
  apply is_RInt_ext with (fun t => h ^ 4 / (Rabs h * mu ^ 2) * (1 / (1 + ax / mu * cos t + ay / mu * sin t) ^
      2)).
  - intros t _. pose proof (slow_positive _ _ inside t) as P.
    rewrite is_c0, is_c1.
    replace (- mu * ay / h ^ 2 * sin t + - mu * ax / h ^ 2 * cos t - (mu / h) ^ 2)
      with (- (mu / h) ^ 2 * (1 + ax / mu * cos t + ay / mu * sin t))
      by (field; repeat split; first [assumption | lra]).
    set (d := 1 + _ + _) in *. in_reals. field. repeat split; first [assumption | lra].
  - exact (is_RInt_scal _ _ _ _ _ T).
Qed.
End Ellipse.

(* With the distance at the angle th by the vector's parts along R0 and P0. *)
Lemma toward : forall mu r0 rd th0 w0 th,
  pull_over_V mu r0 rd th0 w0 th = mu + (r0 * r0 * r0 * w0 * w0 - mu) * cos (th - th0) - r0 * r0 * rd * w0 *
      sin (th - th0).
Proof. intros. unfold pull_over_V, along_x, along_y. rewrite cos_minus, sin_minus. ring. Qed.

Lemma bounded : forall mu q h g, mu > 0 -> h <> 0 -> g > 0 -> g * g = q -> - ((q - mu * mu) / (2 * h ^ 2)) > 0
    -> g < mu.
Proof.
  intros mu q h g pulled N g0 is_g B. assert (S : h ^ 2 > 0) by (replace (h ^ 2) with (Rsqr h) by (unfold
      Rsqr; ring); now apply Rsqr_pos_lt).
  assert (E : mu * mu - q = - ((q - mu * mu) / (2 * h ^ 2)) * (2 * h ^ 2)) by (field; lra).
  assert (- ((q - mu * mu) / (2 * h ^ 2)) * (2 * h ^ 2) > 0) by (apply Rmult_gt_0_compat; lra). nra.
Qed.

Lemma axis : forall m g h, m > 0 -> g > 0 -> h <> 0 ->
  (m - g) * (2 * h ^ 2) + (m + g) * (2 * h ^ 2) <> 0 /\ (m + g) * (2 * h ^ 2) + (m - g) * (2 * h ^ 2) <> 0 /\
  (m + g) * (2 * h ^ 2) - (m - g) * (2 * h ^ 2) <> 0.
Proof.
  intros m g h M P N. assert (4 * m * (h * h) <> 0) by (repeat apply Rmult_integral_contrapositive_currified;
      lra).
  assert (4 * g * (h * h) <> 0) by (repeat apply Rmult_integral_contrapositive_currified; lra).
  repeat split; first [replace (_ + _) with (4 * m * (h * h)) by ring | replace (_ - _) with (4 * g * (h * h))
      by ring]; trivial.
Qed.

(* g is the length of c1, k that of the angular velocity. *)
Ltac known := first [assumption | lra | apply Rgt_not_eq; lra].
Ltac by_axes :=
  lazymatch goal with
  | path : newton (?G * ?M) ?x ?y ?u ?v, G0 : ?G > 0, M0 : ?M > 0, far : ?r0 > 0, turns : ?w0 <> 0,
    x0 : ?x 0 = ?r0 * cos ?th0, y0 : ?y 0 = _, u0 : ?u 0 = _, v0 : ?v 0 = ?rd * sin ?th0 + ?r0 * ?w0 * cos
        ?th0,
    apart : sin (?th1 - ?th2) <> 0, on1 : at_angle ?x ?y ?t1 ?th1, on2 : at_angle ?x ?y ?t2 ?th2,
    on0 : at_angle ?x ?y ?t ?th, fit1 : _ = ?c0 * sin ?th1 + ?c1 * cos ?th1,
    fit2 : _ = ?c0 * sin ?th2 + ?c1 * cos ?th2, bound : - (_ - _) > 0, long : sqrt ?square > 0 |- _ =>
    assert (pulled : G * M > 0) by (apply Rmult_lt_0_compat; lra);
    destruct (on_orbit _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ on0) as [D0 [is_r [is_u is_v]]];
    destruct (constants _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ _ _ _ _ on1 on2 apart fit1 fit2)
      as [is_c0 is_c1];
    pose proof (energy_later _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ on0) as is_E;
    rewrite ?(momentum _ _ _ _ _ _ _ _ _ path x0 y0 u0 v0 t);
    change (sqrt (x t * x t + y t * y t)) with (distance x y t); rewrite ?is_E;
    destruct (eccentricity (G * M) r0 rd w0 far turns) as [positive is_E0]; rewrite is_E0 in bound;
    pose proof (sqrt_sqrt _ positive) as is_g; pose proof (no_stop r0 w0 far turns) as no_stop;
    pose proof (bounded _ _ _ _ pulled no_stop long is_g bound) as below;
    try rewrite (turn_is _ _ _ _ _ pulled far turns _ _ _ is_c0 is_c1 long is_g below);
    destruct (flattening _ pulled _ long below) as [narrow is_s];
    rewrite ?(Rabs_mult (r0 * r0) w0), ?(Rabs_right (r0 * r0)) by (apply Rgt_ge, Rmult_gt_0_compat; lra);
    assert (is_k : Rabs w0 * Rabs w0 = w0 * w0) by (rewrite <- Rabs_mult; apply Rabs_right, Rle_ge,
        Rle_0_sqr);
    pose proof (Rabs_pos_lt w0 turns) as sense;
    clear - pulled far turns no_stop long below is_g narrow is_s is_k sense;
    remember (sqrt square) as g; remember (sqrt (1 - (g / (G * M)) ^ 2)) as s; remember (Rabs w0) as k;
    rewrite <- ?is_g; clear is_g; remember (G * M) as m;
    repeat match goal with E : _ = sqrt _ |- _ => clear E | E : _ = Rabs _ |- _ => clear E | E : _ = G * M |-
        _ => clear E end;
    assert (is_E : g * g = m * m * (1 - s * s)) by (rewrite is_s; field; lra);
    try replace (sqrt (m * m + 2 * ((g * g - m * m) / (2 * (r0 * r0 * w0) ^ 2)) * (r0 * r0 * w0) * (r0 * r0 *
        w0))) with g
      by (symmetry; apply root_is; [lra | field; repeat split; known]);
    replace (g * g - m * m) with (- (m * m * (s * s))) by (rewrite is_E; ring);
    try replace (1 - (g / m) ^ 2) with (s * s) by (rewrite is_s; field; lra);
    assert (rm : sqrt m > 0) by (now apply sqrt_lt_R0);
    assert (is_m : sqrt m * sqrt m = m) by (apply sqrt_sqrt; lra);
    try match goal with |- context [sqrt ((?a + ?b) / 2)] =>
      replace (sqrt ((a + b) / 2)) with (r0 * r0 * k / (sqrt m * s))
        by (symmetry; apply root_is; [apply Rlt_le, Rdiv_lt_0_compat; repeat apply Rmult_lt_0_compat; lra |
          field [is_k is_m]; repeat split; known]) end;
    remember (sqrt m) as n eqn:def_n; clear def_n; pose proof PI_RGT_0;
    destruct (axis m g _ pulled long no_stop) as [? [? ?]]; field [is_k is_m is_E]; repeat split; known
  end.
Ltac by_orbit :=
  lazymatch goal with
  | path : newton (?G * ?M) ?x ?y ?u ?v, G0 : ?G > 0, M0 : ?M > 0, far : ?r0 > 0, turns : ?w0 <> 0,
    x0 : ?x 0 = ?r0 * cos ?th0, y0 : ?y 0 = _, u0 : ?u 0 = _, v0 : ?v 0 = ?rd * sin ?th0 + ?r0 * ?w0 * cos
        ?th0,
    apart : sin (?th1 - ?th2) <> 0, on1 : at_angle ?x ?y ?t1 ?th1, on2 : at_angle ?x ?y ?t2 ?th2,
    on0 : at_angle ?x ?y ?t ?th, long : sqrt ((?A) ^ 2 + ?B * ?B) > 0 |- _ =>
    assert (pulled : G * M > 0) by (apply Rmult_lt_0_compat; lra);
    destruct (on_orbit _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ on0) as [D0 [is_r _]];
    change (sqrt (x t * x t + y t * y t)) with (distance x y t); rewrite is_r;
    rewrite toward in D0 |- *;
    replace (A ^ 2) with (A * A) in * by ring;
    assert (off : A * A + B * B > 0)
      by (destruct (Rle_lt_dec (A * A + B * B) 0) as [N | N]; [rewrite sqrt_neg_0 in long by exact N; lra |
          exact N]);
    replace (th - (th0 - atan2 B A)) with (th - th0 + atan2 B A) by ring;
    rewrite cos_plus, cos_atan2, sin_atan2 by exact off;
    assert (is_k : Rabs w0 * Rabs w0 = w0 * w0) by (rewrite <- Rabs_mult; apply Rabs_right, Rle_ge,
        Rle_0_sqr);
    clear - pulled far long D0 is_k;
    remember (sqrt (A * A + B * B)) as g eqn:is_g; clear is_g; remember (G * M) as m eqn:is_m; clear is_m;
    remember (Rabs w0) as k eqn:def_k; clear def_k; remember (cos (th - th0)) as C eqn:is_C; clear is_C;
    remember (sin (th - th0)) as S eqn:is_S; clear is_S;
    replace (1 + g / m * (C * (A / g) - S * (B / g))) with ((m + A * C - B * S) / m) by (field; split; lra);
    remember (m + A * C - B * S) as P eqn:is_P; clear is_P; field [is_k]; repeat split; known
  end.
Ltac by_ellipse := match goal with |- context [atan2] => by_orbit | _ => by_axes end.
