(* Rings of points around an axis: lemmas and tactics for the assumption H : top l mass ell mu1 mu3. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require Import List.
Local Open Scope R_scope.

Fixpoint upto (n : nat) (f : nat -> R) : R := match n with O => 0 | S k => upto k f + f k end.
(* n points of the mass m at the distance r from the axis and the height h, the first at the angle a *)
Definition around n (m r h a : R) (f : R -> R -> R -> R -> R) : R :=
  upto n (fun i => f m (r * cos (a + INR i * (2 * PI / INR n))) (r * sin (a + INR i * (2 * PI / INR n))) h).
Definition total (l : list (nat * R * R * R * R)) (f : R -> R -> R -> R -> R) : R :=
  fold_right (fun p s => match p with (n, m, r, h, a) => around n m r h a f + s end) 0 l.
(* rings of at least three points, or of points on the axis *)
Definition symmetric (l : list (nat * R * R * R * R)) : Prop :=
  Forall (fun p => match p with (n, m, r, h, a) => (3 <= n)%nat \/ r = 0 end) l.
(* its mass, the height of its center, its moments across the axis and about it *)
Definition top l mass ell mu1 mu3 : Prop := symmetric l /\
  total l (fun m x y z => m) = mass /\ total l (fun m x y z => m * z) = mass * ell /\
  total l (fun m x y z => m * (y * y + z * z)) = mu1 /\ total l (fun m x y z => m * (x * x + y * y)) = mu3.

Lemma upto_ext : forall n f g, (forall i, f i = g i) -> upto n f = upto n g.
Proof. intros n f g e. induction n as [|n h]; cbn; [trivial | now rewrite h, e]. Qed.
Lemma upto_of_two : forall n a b f g, upto n (fun i => a * f i + b * g i) = a * upto n f + b * upto n g.
Proof. intros. induction n as [|n h]; cbn [upto]; [|rewrite h]; ring. Qed.

Lemma cosines : forall n d k b, sin (d / 2) <> 0 -> INR n * d = 2 * INR k * PI ->
  upto n (fun i => cos (b + INR i * d)) = 0.
Proof.
  intros n d k b s e. apply (Rmult_eq_reg_l (2 * sin (d / 2))); [|lra].
  transitivity (sin (b - d / 2 + INR n * d) - sin (b - d / 2)).
  - clear e. induction n as [|n h]; [cbn [upto INR]; rewrite Rmult_0_l, Rplus_0_r; ring |].
    cbn [upto]. rewrite Rmult_plus_distr_l, h, S_INR.
    replace (b - d / 2 + (INR n + 1) * d) with (b + INR n * d + d / 2) by lra.
    replace (b - d / 2 + INR n * d) with (b + INR n * d - d / 2) by lra.
    rewrite sin_plus, (sin_minus (b + INR n * d)). ring.
  - rewrite e, sin_period. ring.
Qed.
Lemma sines : forall n d k b, sin (d / 2) <> 0 -> INR n * d = 2 * INR k * PI ->
  upto n (fun i => sin (b + INR i * d)) = 0.
Proof.
  intros n d k b s e. rewrite <- (cosines n d k (b - PI / 2) s e). apply upto_ext. intro i.
  replace (b - PI / 2 + INR i * d) with (- (PI / 2 - (b + INR i * d))) by ring. now rewrite cos_neg, cos_shift.
Qed.

(* sums around a ring of what is at most quadratic *)
Lemma around_is : forall n m r h a q0 q1 q2 q3 q4 q5 q6 q7 q8 q9, (3 <= n)%nat \/ r = 0 ->
  around n m r h a (fun m x y z => m * (q0 + q1 * x + q2 * y + q3 * z + q4 * (x * x) + q5 * (y * y)
    + q6 * (z * z) + q7 * (x * y) + q8 * (x * z) + q9 * (y * z)))
  = INR n * m * (q0 + q3 * h + (q4 + q5) / 2 * (r * r) + q6 * (h * h)).
Proof.
  intros n m r h a q0 q1 q2 q3 q4 q5 q6 q7 q8 q9 [w | ->].
  - assert (p := PI_RGT_0). assert (v : 3 <= INR n) by (now apply (le_INR 3) in w; cbn [INR] in w; lra).
    pose (d := 2 * PI / INR n). assert (e : INR n * d = 2 * INR 1 * PI) by (unfold d; cbn [INR]; field; lra).
    assert (e2 : INR n * (2 * d) = 2 * INR 2 * PI) by (cbn [INR] in *; lra).
    assert (0 < d / 2) by (unfold d; apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra | lra]).
    assert (2 * d / 2 < PI)
      by (assert (3 * d <= INR n * d) by (apply Rmult_le_compat_r; lra); cbn [INR] in e; lra).
    assert (s : sin (d / 2) <> 0) by (apply Rgt_not_eq, sin_gt_0; lra).
    assert (s2 : sin (2 * d / 2) <> 0) by (apply Rgt_not_eq, sin_gt_0; lra).
    assert (c1 := fun b => cosines n d 1 b s e). assert (s1 := fun b => sines n d 1 b s e).
    assert (c2 := fun b => cosines n (2 * d) 2 b s2 e2). assert (s3 := fun b => sines n (2 * d) 2 b s2 e2).
    unfold around. fold d.
    transitivity (upto n (fun i => (m * r * (q1 + q8 * h)) * cos (a + INR i * d)
      + 1 * ((m * r * (q2 + q9 * h)) * sin (a + INR i * d)
      + 1 * ((m * r * r * (q4 - q5) / 2) * cos (2 * a + INR i * (2 * d))
      + 1 * ((m * r * r * q7 / 2) * sin (2 * a + INR i * (2 * d))
      + (m * (q0 + q3 * h + (q4 + q5) / 2 * (r * r) + q6 * (h * h))) * 1))))).
    + apply upto_ext. intro i. replace (2 * a + INR i * (2 * d)) with (2 * (a + INR i * d)) by ring.
      rewrite cos_2a, sin_2a. set (t := a + INR i * d). assert (z := sin2_cos2 t). unfold Rsqr in z.
      replace (m * (q0 + q3 * h + (q4 + q5) / 2 * (r * r) + q6 * (h * h)) * 1)
        with (m * (q0 + q3 * h + (q4 + q5) / 2 * (r * r) * (sin t * sin t + cos t * cos t) + q6 * (h * h)))
        by (rewrite z; ring). field.
    + rewrite 4!upto_of_two, c1, s1, c2, s3.
      assert (u : upto n (fun _ => 1) = INR n)
        by (clear; induction n as [|n h]; [trivial | cbn [upto]; now rewrite h, S_INR]).
      rewrite u. field.
  - unfold around. induction n as [|n k]; [cbn; ring |].
    rewrite S_INR. transitivity (INR n * m * (q0 + q3 * h + (q4 + q5) / 2 * (0 * 0) + q6 * (h * h))
      + m * (q0 + q3 * h + q6 * (h * h))); [|ring].
    assert (o : forall n f c, (forall i : nat, f i = c) -> upto n f = INR n * c).
    { clear. intros n f c e. induction n as [|n h]; [cbn; ring | cbn [upto]; rewrite h, e, S_INR; ring]. }
    rewrite (o (S n) _ (m * (q0 + q3 * h + q6 * (h * h)))) by (intros; ring). rewrite S_INR. field.
Qed.

Definition quadratic q0 q1 q2 q3 q4 q5 q6 q7 q8 q9 (m x y z : R) : R :=
  m * (q0 + q1 * x + q2 * y + q3 * z + q4 * (x * x) + q5 * (y * y) + q6 * (z * z) + q7 * (x * y)
    + q8 * (x * z) + q9 * (y * z)).
Lemma total_ext : forall l f g, (forall m x y z, f m x y z = g m x y z) -> total l f = total l g.
Proof.
  intros l f g e. unfold total, around. induction l as [|[[[[n m] r] h] a] l k]; cbn [fold_right]; [trivial |].
  rewrite k. f_equal. now apply upto_ext.
Qed.
Lemma total_of_two : forall l a b f g,
  total l (fun m x y z => a * f m x y z + b * g m x y z) = a * total l f + b * total l g.
Proof.
  intros. unfold total, around. induction l as [|[[[[n m] r] h] c] l k]; cbn [fold_right]; [ring |].
  rewrite k, upto_of_two. ring.
Qed.
Lemma total_is : forall l mass ell mu1 mu3 q0 q1 q2 q3 q4 q5 q6 q7 q8 q9, top l mass ell mu1 mu3 ->
  total l (quadratic q0 q1 q2 q3 q4 q5 q6 q7 q8 q9)
  = mass * q0 + mass * ell * q3 + mu3 / 2 * (q4 + q5) + (mu1 - mu3 / 2) * q6.
Proof.
  intros l mass ell mu1 mu3 q0 q1 q2 q3 q4 q5 q6 q7 q8 q9 [s [<- [<- [<- <-]]]].
  rewrite (total_ext l (fun m x y z => m) (quadratic 1 0 0 0 0 0 0 0 0 0)),
    (total_ext l (fun m x y z => m * z) (quadratic 0 0 0 1 0 0 0 0 0 0)),
    (total_ext l (fun m x y z => m * (y * y + z * z)) (quadratic 0 0 0 0 0 1 1 0 0 0)),
    (total_ext l (fun m x y z => m * (x * x + y * y)) (quadratic 0 0 0 0 1 1 0 0 0 0))
    by (intros; unfold quadratic; ring).
  unfold total, quadratic. induction s as [|[[[[n m] r] h] a] l w s k]; cbn [fold_right]; [field |].
  rewrite !around_is by exact w. rewrite k. field.
Qed.

Definition linear (f : R -> R -> R -> R) a b c d := forall x y z, f x y z = a + b * x + c * y + d * z.
Lemma lin_const : forall a, linear (fun x y z => a) a 0 0 0. Proof. intros a x y z. ring. Qed.
Lemma lin_x : forall b, linear (fun x y z => b * x) 0 b 0 0. Proof. intros a x y z. ring. Qed.
Lemma lin_y : forall b, linear (fun x y z => b * y) 0 0 b 0. Proof. intros a x y z. ring. Qed.
Lemma lin_z : forall b, linear (fun x y z => b * z) 0 0 0 b. Proof. intros a x y z. ring. Qed.
Lemma lin_only_x : linear (fun x y z => x) 0 1 0 0. Proof. intros x y z. ring. Qed.
Lemma lin_only_y : linear (fun x y z => y) 0 0 1 0. Proof. intros x y z. ring. Qed.
Lemma lin_only_z : linear (fun x y z => z) 0 0 0 1. Proof. intros x y z. ring. Qed.
Lemma lin_plus : forall f g a b c d p q r s, linear f a b c d -> linear g p q r s ->
  linear (fun x y z => f x y z + g x y z) (a + p) (b + q) (c + r) (d + s).
Proof. intros f g a b c d p q r s F G x y z. rewrite F, G. ring. Qed.
Lemma lin_minus : forall f g a b c d p q r s, linear f a b c d -> linear g p q r s ->
  linear (fun x y z => f x y z - g x y z) (a - p) (b - q) (c - r) (d - s).
Proof. intros f g a b c d p q r s F G x y z. rewrite F, G. ring. Qed.

(* a sum over a top's points by its mass, its first moment, and those of x^2 and z^2 *)
Definition sums l f v :=
  forall mass ell A C, top l mass ell (A + C) (2 * A) -> total l f = v mass (mass * ell) A C.
Lemma sums_of_two : forall l a b f g v w, sums l f v -> sums l g w ->
  sums l (fun m x y z => a * f m x y z + b * g m x y z) (fun p q r s => a * v p q r s + b * w p q r s).
Proof.
  intros l a b f g v w F G ? ? ? ? t. rewrite total_of_two. now rewrite (F _ _ _ _ t), (G _ _ _ _ t).
Qed.
Lemma sums_same : forall l f g v w, (forall m x y z, f m x y z = g m x y z) ->
  (forall p q r s, v p q r s = w p q r s) -> sums l g w -> sums l f v.
Proof. intros l f g v w e k G ? ? ? ? t. now rewrite (total_ext l f g e), (G _ _ _ _ t), k. Qed.
Ltac of_two a b F G :=
  eapply sums_same; [| | exact (sums_of_two _ a b _ _ _ _ F G)]; intros; cbv beta; field; trivial.
Lemma sums_plus : forall l f g v w, sums l f v -> sums l g w ->
  sums l (fun m x y z => f m x y z + g m x y z) (fun p q r s => v p q r s + w p q r s).
Proof. intros l f g v w F G. of_two 1 1 F G. Qed.
Lemma sums_inside : forall l f g v w,
  sums l (fun m x y z => m * f x y z) v -> sums l (fun m x y z => m * g x y z) w ->
  sums l (fun m x y z => m * (f x y z + g x y z)) (fun p q r s => v p q r s + w p q r s).
Proof. intros l f g v w F G. of_two 1 1 F G. Qed.
Lemma sums_inside_minus : forall l f g v w,
  sums l (fun m x y z => m * f x y z) v -> sums l (fun m x y z => m * g x y z) w ->
  sums l (fun m x y z => m * (f x y z - g x y z)) (fun p q r s => v p q r s - w p q r s).
Proof. intros l f g v w F G. of_two 1 (-1) F G. Qed.
Lemma sums_inside_opp : forall l f v, sums l (fun m x y z => m * f x y z) v ->
  sums l (fun m x y z => m * - f x y z) (fun p q r s => - v p q r s).
Proof. intros l f v F. of_two (-1) 0 F F. Qed.
Lemma sums_opp : forall l f v, sums l f v -> sums l (fun m x y z => - f m x y z) (fun p q r s => - v p q r s).
Proof. intros l f v F. of_two (-1) 0 F F. Qed.
Lemma sums_quotient : forall l c f v, sums l f v ->
  sums l (fun m x y z => f m x y z / c) (fun p q r s => v p q r s / c).
Proof.
  intros l c f v F. eapply sums_same; [| | exact (sums_of_two _ (/ c) 0 _ _ _ _ F F)];
    intros; unfold Rdiv; ring.
Qed.
Lemma sums_product : forall l f g a b c d p q r s, linear f a b c d -> linear g p q r s ->
  sums l (fun m x y z => m * f x y z * g x y z)
    (fun mass ell A C => mass * (a * p) + ell * (a * s + d * p) + A * (b * q + c * r) + C * (d * s)).
Proof.
  intros l f g a b c d p q r s F G mass ell A C t.
  rewrite (total_ext l _ (quadratic (a * p) (a * q + b * p) (a * r + c * p) (a * s + d * p) (b * q) (c * r)
    (d * s) (b * r + c * q) (b * s + d * q) (c * s + d * r))) by (intros; unfold quadratic; rewrite F, G; ring).
  rewrite (total_is _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ t). field.
Qed.
Lemma sums_inside_product : forall l f g v, sums l (fun m x y z => m * f x y z * g x y z) v ->
  sums l (fun m x y z => m * (f x y z * g x y z)) v.
Proof. intros l f g v F. eapply sums_same; [| | exact F]; intros; cbv beta; [ring | trivial]. Qed.
Lemma sums_linear : forall l f a b c d, linear f a b c d ->
  sums l (fun m x y z => m * f x y z) (fun mass ell A C => mass * a + ell * d).
Proof.
  intros l f a b c d F. eapply sums_same; [| | exact (sums_product l f _ _ _ _ _ _ _ _ _ F (lin_const 1))];
    intros; cbv beta; ring.
Qed.

Ltac find_linear := first [apply lin_const | apply lin_x | apply lin_y | apply lin_z
  | eapply lin_plus; find_linear | eapply lin_minus; find_linear | apply lin_only_x | apply lin_only_y | apply lin_only_z].
Ltac find_sum := first [eapply sums_product; find_linear | eapply sums_linear; find_linear
  | eapply sums_plus; find_sum | eapply sums_inside_product; find_sum | eapply sums_inside; find_sum
  | eapply sums_inside_minus; find_sum | eapply sums_inside_opp; find_sum | eapply sums_opp; find_sum
  | eapply sums_quotient; find_sum].
Lemma halves : forall mu1 mu3, exists A C, mu1 = A + C /\ mu3 = 2 * A.
Proof. intros. exists (mu3 / 2), (mu1 - mu3 / 2). split; field. Qed.
Ltac sum_up t := repeat match goal with |- context [total ?l ?f] =>
  let e := fresh in eassert (e : sums l f _) by find_sum; rewrite (e _ _ _ _ t); clear e end; cbv beta.
Ltac sum_up_in e t := repeat match type of e with context [total ?l ?f] =>
  let s := fresh in eassert (s : sums l f _) by find_sum; rewrite (s _ _ _ _ t) in e; clear s end; cbv beta in e.
(* t : top l mass ell mu1 mu3; of the moments are left A and C *)
Ltac by_points t := match type of t with top _ _ _ ?mu1 ?mu3 =>
  destruct (halves mu1 mu3) as [A [C [-> ->]]] end; sum_up t.

Lemma circle : forall t, sin t * sin t = 1 - cos t * cos t.
Proof. intro t. assert (e := sin2_cos2 t). unfold Rsqr in e. lra. Qed.
Ltac positive := repeat split; apply Rgt_not_eq; lra.
