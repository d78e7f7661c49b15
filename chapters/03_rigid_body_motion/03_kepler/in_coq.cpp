#include "chapters/03_rigid_body_motion/03_kepler/kepler.hpp"

namespace oddity::kepler {

/// Replaces the distance by a letter and the angle's cosine and sine by quotients, and the rate on a circle
/// by another.
const char* const by_distance = R"(
  rename H1 into off_center;
  rewrite ?(cos_atan2 y x off_center), ?(sin_atan2 y x off_center);
  pose proof (sqrt_lt_R0 _ off_center) as far;
  assert (root : sqrt (x * x + y * y) * sqrt (x * x + y * y) = x * x + y * y) by (apply sqrt_sqrt; lra);
  remember (sqrt (x * x + y * y)) as r eqn:is_r;
  replace (r * (x / r)) with x by (field; lra); replace (r * (y / r)) with y by (field; lra);
  rewrite <- ?is_r; clear is_r;
  assert (up : y * y = r * r - x * x) by lra;
  assert (pull : G * M > 0 /\ r * r * r > 0) by (split; repeat apply Rmult_lt_0_compat; lra);
  try (match goal with |- context [sqrt ?q] =>
    assert (turns : q > 0) by (first [apply Rdiv_lt_0_compat | apply Rmult_lt_0_compat]; lra);
    pose proof (sqrt_lt_R0 _ turns); pose proof (sqrt_sqrt _ (Rlt_le _ _ turns)) as square;
    set (w := sqrt q) in *; clearbody w;
    first [replace G with (w * w * (r * r * r) / M) by (rewrite square; field; lra)
          | replace G with (w * w / (M * r)) by (rewrite square; field; lra)] end);
  field [up]; repeat split; nra)";

const char* const by_factors = R"([ nra
  | intuition; assert (E : (b - 1) * (b + 1) = 0) by nra; destruct (Rmult_integral _ _ E); lra
  | intuition; subst; lra | intuition; subst; lra ])";

const char* const by_circle = R"(
  match goal with |- context [sqrt ?x] => replace x with 0 by (rewrite H2, H3; ring) end; rewrite sqrt_0;
  try reflexivity;
  match goal with |- context [Rabs ?w] =>
    assert (k : Rabs w * Rabs w = w * w) by (rewrite <- Rabs_mult; apply Rabs_right, Rle_ge, Rle_0_sqr) end;
  replace (r0 * r0 * Rabs w0 * (r0 * r0 * Rabs w0)) with (r0 * (r0 * r0 * r0 * w0 * w0)) by ring [k];
  rewrite H3; field; repeat split; lra)";

const char* const by_bounds = "rewrite ?cos_atan2, ?sin_atan2 by interval; interval";

const char* const orbits_in_coq = R"(
From Coquelicot Require Import AutoDerive.

(* a path (x, y) with the velocity (u, v) under the pull mu/r^2 *)
Definition distance (x y : R -> R) t := sqrt (x t * x t + y t * y t).
Definition newton mu (x y u v : R -> R) := forall t, x t * x t + y t * y t > 0 /\
  is_derive x t (u t) /\ is_derive y t (v t) /\
  is_derive u t (- mu * x t / distance x y t ^ 3) /\ is_derive v t (- mu * y t / distance x y t ^ 3).
Definition at_angle (x y : R -> R) t th := x t = distance x y t * cos th /\ y t = distance x y t * sin th.

Lemma constant : forall f : R -> R, (forall t, is_derive f t 0) -> forall t, f t = f 0.
Proof.
  intros f D t. destruct (Rtotal_order t 0) as [L | [-> | L]]; trivial.
  - now apply (eq_is_derive f).
  - symmetry. now apply (eq_is_derive f).
Qed.

Ltac in_reals := match goal with |- ?x = ?y => change (@eq R x y) end.
Ltac along_path N x y u v t :=
  destruct (N t) as [off [dx [dy [du dv]]]];
  assert (far : sqrt (x t * x t + y t * y t) > 0) by (apply sqrt_lt_R0; lra);
  assert (root : sqrt (x t * x t + y t * y t) * sqrt (x t * x t + y t * y t) = x t * x t + y t * y t)
    by (apply sqrt_sqrt; lra);
  auto_derive; [repeat split; try lra; eexists; eassumption |];
  repeat match goal with
  | |- context [Derive ?f t] => first
    [ replace (Derive f t) with (u t) by (symmetry; exact (is_derive_unique x t _ dx))
    | replace (Derive f t) with (v t) by (symmetry; exact (is_derive_unique y t _ dy))
    | rewrite (is_derive_unique f t _ du) | rewrite (is_derive_unique f t _ dv) ] end; unfold distance;
  remember (sqrt (x t * x t + y t * y t)) as r eqn:is_r; clear is_r;
  assert (up : y t * y t = r * r - x t * x t) by lra; in_reals; field [up]; lra.

Lemma areas : forall mu x y u v, newton mu x y u v -> forall t, x t * v t - y t * u t = x 0 * v 0 - y 0 * u 0.
Proof.
  intros mu x y u v N. apply (constant (fun t => x t * v t - y t * u t)). intro t. along_path N x y u v t.
Qed.
Lemma laplace : forall mu x y u v, newton mu x y u v -> forall t,
  v t * (x t * v t - y t * u t) - mu / distance x y t * x t
    = v 0 * (x 0 * v 0 - y 0 * u 0) - mu / distance x y 0 * x 0 /\
  - u t * (x t * v t - y t * u t) - mu / distance x y t * y t
    = - u 0 * (x 0 * v 0 - y 0 * u 0) - mu / distance x y 0 * y 0.
Proof.
  intros mu x y u v N t. unfold distance. split.
  - apply (constant (fun t => v t * (x t * v t - y t * u t) - mu / sqrt (x t * x t + y t * y t) * x t)).
    intro s. along_path N x y u v s.
  - apply (constant (fun t => - u t * (x t * v t - y t * u t) - mu / sqrt (x t * x t + y t * y t) * y t)).
    intro s. along_path N x y u v s.
Qed.

Lemma unit_circle : forall th, sin th * sin th = 1 - cos th * cos th.
Proof. intro th. pose proof (sin2_cos2 th) as all. unfold Rsqr in all. lra. Qed.

(* The vector c1 = v x c0 - mu R of a start is A along R0 and B along P0. *)
Section Start.
Variables mu r0 rd th0 w0 : R.
Local Notation h := (r0 * r0 * w0).
Local Notation A := (r0 * w0 * h - mu).
Local Notation B := (- rd * h).
Definition along_x := A * cos th0 - B * sin th0.
Definition along_y := A * sin th0 + B * cos th0.
Definition pull_over_V th := mu + along_x * cos th + along_y * sin th.

Variables x y u v : R -> R.
Hypothesis far : r0 > 0.
Hypothesis turns : w0 <> 0.
Hypothesis path : newton mu x y u v.
Hypothesis x0 : x 0 = r0 * cos th0.
Hypothesis y0 : y 0 = r0 * sin th0.
Hypothesis u0 : u 0 = rd * cos th0 - r0 * w0 * sin th0.
Hypothesis v0 : v 0 = rd * sin th0 + r0 * w0 * cos th0.

Lemma distance_at_start : distance x y 0 = r0.
Proof.
  unfold distance. rewrite x0, y0. pose proof (unit_circle th0) as circle. replace (r0 * cos th0 * (r0 * cos th0) + r0 * sin th0 * (r0 * sin th0)) with (r0 * r0) by ring [circle].
  apply sqrt_square. lra.
Qed.
Lemma momentum : forall t, x t * v t - y t * u t = h.
Proof. intro t. rewrite (areas mu x y u v path t), x0, y0, u0, v0. pose proof (unit_circle th0) as circle. ring [circle]. Qed.
Lemma vector : forall t, v t * h - mu / distance x y t * x t = along_x /\
  - u t * h - mu / distance x y t * y t = along_y.
Proof.
  intro t. destruct (laplace mu x y u v path t) as [L1 L2]. rewrite !momentum, distance_at_start in L1, L2.
  rewrite L1, L2, x0, y0, u0, v0. unfold along_x, along_y. split; field; lra.
Qed.
Lemma on_orbit : forall t th, at_angle x y t th ->
  pull_over_V th > 0 /\ distance x y t = h ^ 2 / pull_over_V th /\
  u t = - (along_y + mu * sin th) / h /\ v t = (along_x + mu * cos th) / h.
Proof.
  intros t th [X Y]. destruct (vector t) as [L1 L2]. pose proof (momentum t) as C.
  assert (P : distance x y t > 0) by (apply sqrt_lt_R0; destruct (path t); lra).
  assert (N : h <> 0) by (repeat apply Rmult_integral_contrapositive_currified; lra).
  rewrite X in L1, C. rewrite Y in L2, C.
  replace (mu / distance x y t * (distance x y t * cos th)) with (mu * cos th) in L1 by (field; lra).
  replace (mu / distance x y t * (distance x y t * sin th)) with (mu * sin th) in L2 by (field; lra).
  assert (U : u t = - (along_y + mu * sin th) / h) by (apply (Rmult_eq_reg_r h); [field_simplify; lra | trivial]).
  assert (V : v t = (along_x + mu * cos th) / h) by (apply (Rmult_eq_reg_r h); [field_simplify; lra | trivial]).
  rewrite U, V in C. pose proof (unit_circle th) as circle.
  assert (E : distance x y t * pull_over_V th = h ^ 2)
    by (apply (f_equal (fun z => z * h)) in C; cbv beta in C; replace (h ^ 2) with (h * h) by ring; rewrite <- C;
      unfold pull_over_V; field [circle]; repeat split; first [assumption | lra]).
  assert (S : h ^ 2 > 0) by (replace (h ^ 2) with (Rsqr h) by (unfold Rsqr; ring); now apply Rsqr_pos_lt).
  assert (Q : pull_over_V th > 0) by nra.
  repeat split; trivial. apply (Rmult_eq_reg_r (pull_over_V th)); [| lra]. rewrite E. field. lra.
Qed.
Lemma constants : forall t1 th1 t2 th2 c0 c1, at_angle x y t1 th1 -> at_angle x y t2 th2 -> sin (th1 - th2) <> 0 ->
  - mu / distance x y t1 + (mu / h) ^ 2 = c0 * sin th1 + c1 * cos th1 ->
  - mu / distance x y t2 + (mu / h) ^ 2 = c0 * sin th2 + c1 * cos th2 ->
  c0 = - mu * along_y / h ^ 2 /\ c1 = - mu * along_x / h ^ 2.
Proof.
  intros t1 th1 t2 th2 c0 c1 O1 O2 apart E1 E2. rewrite sin_minus in apart.
  destruct (on_orbit t1 th1 O1) as [P1 [D1 _]]. destruct (on_orbit t2 th2 O2) as [P2 [D2 _]].
  assert (N : h <> 0) by (repeat apply Rmult_integral_contrapositive_currified; lra).
  rewrite D1 in E1. rewrite D2 in E2.
  replace (- mu / (h ^ 2 / pull_over_V th1)) with (- mu / h ^ 2 * pull_over_V th1) in E1 by (field; split; lra).
  replace (- mu / (h ^ 2 / pull_over_V th2)) with (- mu / h ^ 2 * pull_over_V th2) in E2 by (field; split; lra).
  unfold pull_over_V in E1, E2.
  set (p := c0 + mu * along_y / h ^ 2). set (q := c1 + mu * along_x / h ^ 2).
  assert (F1 : p * sin th1 + q * cos th1 = 0)
    by (transitivity (c0 * sin th1 + c1 * cos th1 + mu / h ^ 2 * (along_y * sin th1 + along_x * cos th1));
      [unfold p, q | rewrite <- E1]; field; repeat split; first [assumption | lra]).
  assert (F2 : p * sin th2 + q * cos th2 = 0)
    by (transitivity (c0 * sin th2 + c1 * cos th2 + mu / h ^ 2 * (along_y * sin th2 + along_x * cos th2));
      [unfold p, q | rewrite <- E2]; field; repeat split; first [assumption | lra]).
  set (det := sin th1 * cos th2 - cos th1 * sin th2) in *.
  assert (p * det = 0) by (unfold det; transitivity ((p * sin th1 + q * cos th1) * cos th2
    - (p * sin th2 + q * cos th2) * cos th1); [ring | rewrite F1, F2; ring]).
  assert (q * det = 0) by (unfold det; transitivity ((p * sin th2 + q * cos th2) * sin th1
    - (p * sin th1 + q * cos th1) * sin th2); [ring | rewrite F1, F2; ring]).
  assert (p = 0) by (apply (Rmult_eq_reg_r det); lra). assert (q = 0) by (apply (Rmult_eq_reg_r det); lra).
  split; [replace c0 with (p - mu * along_y / h ^ 2) by (unfold p; ring)
    | replace c1 with (q - mu * along_x / h ^ 2) by (unfold q; ring)]; unfold Rdiv; lra.
Qed.
End Start.

(* Everything later by the start and the angle th; th1 and th2 are the places of c0 and c1. *)
Ltac by_start :=
  match goal with
  | path : newton (?G * ?M) ?x ?y ?u ?v, G0 : ?G > 0, M0 : ?M > 0, far : ?r0 > 0, turns : ?w0 <> 0,
    x0 : ?x 0 = ?r0 * cos ?th0, y0 : ?y 0 = _, u0 : ?u 0 = _, v0 : ?v 0 = ?rd * sin ?th0 + ?r0 * ?w0 * cos ?th0,
    on0 : at_angle ?x ?y ?t ?th, on1 : at_angle ?x ?y ?t1 ?th1, on2 : at_angle ?x ?y ?t2 ?th2,
    apart : sin (?th1 - ?th2) <> 0 , fit1 : _ = ?c0 * sin ?th1 + ?c1 * cos ?th1,
    fit2 : _ = ?c0 * sin ?th2 + ?c1 * cos ?th2 |- _ =>
    destruct (on_orbit _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ on0) as [D0 [is_r [is_u is_v]]];
    destruct (constants _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ _ _ _ _ on1 on2 apart fit1 fit2)
      as [is_c0 is_c1];
    rewrite ?(momentum _ _ _ _ _ _ _ _ _ path x0 y0 u0 v0 t);
    change (sqrt (x t * x t + y t * y t)) with (distance x y t);
    try replace (x t * x t + y t * y t) with (distance x y t * distance x y t)
      by (unfold distance; rewrite sqrt_sqrt; [reflexivity | destruct (path t); lra]);
    destruct on0 as [is_x is_y];
    pose proof (unit_circle th0) as circle0;
    try replace (r0 * cos th0 * (r0 * cos th0) + r0 * sin th0 * (r0 * sin th0)) with (r0 * r0) by ring [circle0];
      try replace (r0 * cos th0 * (rd * sin th0 + r0 * w0 * cos th0) - r0 * sin th0 * (rd * cos th0 - r0 * w0 * sin th0))
      with (r0 * r0 * w0) by ring [circle0];
    rewrite ?(sqrt_square r0) by lra;
    pose proof (unit_circle th) as circle; rewrite ?is_x, ?is_y, ?is_u, ?is_v, ?is_r, ?is_c0, ?is_c1;
    rewrite ?Rabs_mult, ?(Rabs_right r0) by lra; rewrite ?cos_minus, ?sin_minus;
    clear - G0 M0 far turns D0 circle circle0;
    remember (pull_over_V (G * M) r0 rd th0 w0 th) as V eqn:is_V;
    unfold pull_over_V in is_V; unfold along_x, along_y in *;
    let equation := (field [is_V circle circle0]; repeat split; first [assumption | lra | apply Rgt_not_eq; lra]) in
    first [reflexivity | equation | f_equal; equation] end.
)";

/// Hypotheses of a section about a path.
static const std::string from_a_start = R"(Hypothesis pulled : mu > 0.
Hypothesis far : r0 > 0.
Hypothesis turns : w0 <> 0.
Hypothesis path : newton mu x y u v.
Hypothesis x0 : x 0 = r0 * cos th0.
Hypothesis y0 : y 0 = r0 * sin th0.
Hypothesis u0 : u 0 = rd * cos th0 - r0 * w0 * sin th0.
Hypothesis v0 : v 0 = rd * sin th0 + r0 * w0 * cos th0.
)";

std::string turns_in_coq() {
  return R"(
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
)" + from_a_start +
         R"(Local Notation square := ((r0 * r0 * r0 * w0 * w0 - mu) ^ 2 + r0 * r0 * rd * w0 * (r0 * r0 * rd * w0)).
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
)";
}

std::string times_in_coq() {
  return R"(
From Coquelicot Require Import Continuity RInt_analysis.

(* Where the angle is a function of the time. *)
Section Time.
Variables mu r0 rd th0 w0 : R.
Variables x y u v angle : R -> R.
)" + from_a_start +
         R"(Hypothesis there : forall s, at_angle x y s (angle s) /\ ex_derive angle s.
Local Notation h := (r0 * r0 * w0).
Local Notation square s := (x s * x s + y s * y s).

Lemma never_stops : h <> 0.
Proof. repeat apply Rmult_integral_contrapositive_currified; lra. Qed.
Lemma angle_rate : forall s, is_derive angle s (h / square s).
Proof.
  intro s. destruct (there s) as [[is_x is_y] [w is_w]]. destruct (path s) as [off [dx [dy _]]].
  replace (h / square s) with w; trivial.
  assert (still : is_derive (fun s => y s * cos (angle s) - x s * sin (angle s)) s 0).
  { apply is_derive_ext with (fun _ => 0); [| apply @is_derive_const].
    intro z. destruct (there z) as [[X Y] _]. rewrite X, Y. in_reals. ring. }
  assert (moving : is_derive (fun s => y s * cos (angle s) - x s * sin (angle s)) s
    (v s * cos (angle s) - u s * sin (angle s) - w * (y s * sin (angle s) + x s * cos (angle s)))).
  { auto_derive; [repeat split; eexists; eassumption |].
    repeat match goal with |- context [Derive ?f s] => first
      [ replace (Derive f s) with (u s) by (symmetry; exact (is_derive_unique x s _ dx))
      | replace (Derive f s) with (v s) by (symmetry; exact (is_derive_unique y s _ dy))
      | replace (Derive f s) with w by (symmetry; exact (is_derive_unique angle s _ is_w)) ] end.
    in_reals. ring. }
  pose proof (is_derive_unique _ _ _ still) as S. rewrite (is_derive_unique _ _ _ moving) in S.
  assert (R : distance x y s > 0) by (apply sqrt_lt_R0; lra).
  assert (D : distance x y s * distance x y s = square s) by (apply sqrt_sqrt; lra).
  pose proof (momentum mu r0 rd th0 w0 x y u v path x0 y0 u0 v0 s) as A.
  pose proof (unit_circle (angle s)) as circle.
  apply Rmult_eq_reg_r with (square s); [| lra].
  replace (h / square s * square s) with h by (field; lra). rewrite <- A, <- D.
  set (r := distance x y s) in *. rewrite is_x, is_y in S |- *.
  set (c := cos (angle s)) in *. set (d := sin (angle s)) in *. clearbody c d r.
  assert (E : v s * c - u s * d = w * r) by (replace (w * r) with (w * (r * d * d + r * c * c)) by ring
      [circle]; lra).
  replace (r * c * v s - r * d * u s) with (r * (v s * c - u s * d)) by ring. rewrite E. ring.
Qed.

Variables c0 c1 : R.
Hypothesis is_c0 : c0 = - mu * along_y mu r0 rd th0 w0 / h ^ 2.
Hypothesis is_c1 : c1 = - mu * along_x mu r0 rd th0 w0 / h ^ 2.

Lemma slowness : forall s, c0 * sin (angle s) + c1 * cos (angle s) - (mu / h) ^ 2 <> 0 /\
  - mu / (c0 * sin (angle s) + c1 * cos (angle s) - (mu / h) ^ 2) = distance x y s /\
  distance x y s ^ 2 = square s.
Proof.
  intro s. destruct (there s) as [on _]. destruct (path s) as [off _].
  destruct (on_orbit _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ on) as [P [is_r _]].
  assert (D : distance x y s * distance x y s = square s) by (apply sqrt_sqrt; lra).
  assert (R : distance x y s > 0) by (apply sqrt_lt_R0; lra).
  pose proof never_stops as N.
  assert (E : c0 * sin (angle s) + c1 * cos (angle s) - (mu / h) ^ 2 = - mu / distance x y s).
  { rewrite is_c0, is_c1, is_r. unfold pull_over_V in *. field. repeat split; lra. }
  rewrite E, <- D. split; [| split; [field; split | ring]; lra].
  apply Rlt_not_eq. unfold Rdiv. rewrite Ropp_mult_distr_l_reverse. apply Ropp_lt_gt_0_contravar. now apply
      Rdiv_lt_0_compat.
Qed.
Lemma time_is : forall t,
  RInt (fun p => (- mu / (c0 * sin p + c1 * cos p - (mu / h) ^ 2)) ^ 2 / h) (angle 0) (angle t) = t.
Proof.
  intro t. pose proof never_stops as N.
  set (f := fun p => (- mu / (c0 * sin p + c1 * cos p - (mu / h) ^ 2)) ^ 2 / h).
  assert (I : is_RInt (fun s => scal (h / square s) (f (angle s))) 0 t (RInt f (angle 0) (angle t))).
  { apply (is_RInt_comp f angle (fun s => h / square s) 0 t); intros s _.
    - apply @ex_derive_continuous. unfold f. auto_derive. destruct (slowness s). repeat split; trivial.
    - split; [apply angle_rate |]. destruct (path s) as [off [dx [dy _]]].
      apply @ex_derive_continuous. auto_derive. repeat split; try lra; eexists; eassumption. }
  apply (is_RInt_ext _ (fun _ => 1)) in I.
  2:{ intros s _. unfold f. destruct (slowness s) as [_ [S D]]. rewrite S, D. destruct (path s) as [off _].
      change (h / square s * (square s / h) = 1). field. repeat split; (first [assumption | lra]). }
  pose proof (is_RInt_unique (fun _ => 1) 0 t _ I) as at_all. pose proof (is_RInt_unique (fun _ => 1) 0 t _
      (is_RInt_const 0 t 1)) as K.
  fold f. rewrite <- at_all, K. change ((t - 0) * 1 = t). ring.
Qed.
End Time.
Ltac by_time :=
  lazymatch goal with
  | path : newton (?G * ?M) ?x ?y ?u ?v, G0 : ?G > 0, M0 : ?M > 0, far : ?r0 > 0, turns : ?w0 <> 0,
    x0 : ?x 0 = ?r0 * cos ?th0, y0 : ?y 0 = _, u0 : ?u 0 = _, v0 : ?v 0 = ?rd * sin ?th0 + ?r0 * ?w0 * cos
        ?th0,
    apart : sin (?th1 - ?th2) <> 0, on1 : at_angle ?x ?y ?t1 ?th1, on2 : at_angle ?x ?y ?t2 ?th2,
    fit1 : _ = ?c0 * sin ?th1 + ?c1 * cos ?th1, fit2 : _ = ?c0 * sin ?th2 + ?c1 * cos ?th2,
    first : ?angle 0 = ?th0, there : forall s, _ /\ _ |- _ =>
    assert (pulled : G * M > 0) by (apply Rmult_lt_0_compat; lra);
    destruct (constants _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ _ _ _ _ on1 on2 apart fit1 fit2)
      as [is_c0 is_c1];
    lazymatch goal with
    | |- RInt _ _ _ = _ =>
      rewrite <- first; exact (time_is _ _ _ _ _ _ _ _ _ _ pulled far turns path x0 y0 u0 v0 there _ _ is_c0
          is_c1 _)
    | |- _ = sqrt (?x ?t * _ + _) =>
      destruct (slowness _ _ _ _ _ _ _ _ _ _ pulled far turns path x0 y0 u0 v0 there _ _ is_c0 is_c1 t) as [_
          [is_r _]];
      exact is_r
    end
  end.
)";
}

}  // namespace oddity::kepler
