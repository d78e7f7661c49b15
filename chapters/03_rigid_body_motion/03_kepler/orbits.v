(* Motion by Newton's law, and the constants of its path. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../02_basic_concepts/shared/root.v".
Load "../../02_basic_concepts/shared/atan2.v".

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
