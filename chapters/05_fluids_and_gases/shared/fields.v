(* Sums of fields, and gradients and curls along a frame. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/derivatives.v".
Load "../shared/frames.v".

(* ---- sums of fields *)
Definition zero : field := fun _ _ _ => 0.
Lemma d_zero j : d j zero = zero.
Proof. at_any_point. destruct j as [|[|j]]; apply (Derive_const 0). Qed.
Lemma zero_smooth n : smooth n zero.
Proof.
  induction n as [|n h]; (split; [intros ? ? ?; apply continuous_const|]); [exact I|]. split.
  - intros x0 x1 x2.
    exact (conj (ex_derive_const 0 x0) (conj (ex_derive_const 0 x1) (ex_derive_const 0 x2))).
  - intros j. rewrite d_zero. exact h.
Qed.
(* Components from the fourth on play no part. *)
Definition vector := nat -> field.
Definition smooth_vector n (f : vector) := forall i, smooth n (f i).
Definition dot_field (a : nat -> R) (g : vector) : field := fun x0 x1 x2 => dot a (fun j => g j x0 x1 x2).
Lemma dot_field_is a g :
  dot_field a g
  = plus_times (plus_times (plus_times zero (a 0%nat) (g 0%nat)) (a 1%nat) (g 1%nat)) (a 2%nat) (g 2%nat).
Proof. at_any_point. unfold dot_field, dot, sum, plus_times, zero. ring. Qed.
Lemma dot_field_smooth n a g : smooth_vector n g -> smooth n (dot_field a g).
Proof. intros s. rewrite dot_field_is. repeat apply smooth_plus_times; try apply s. apply zero_smooth. Qed.
Lemma d_dot_field a g j : smooth_vector 1 g -> d j (dot_field a g) = dot_field a (fun i => d j (g i)).
Proof.
  intros s. rewrite !dot_field_is.
  assert (z := zero_smooth 1). pose proof (smooth_plus_times 1 _ (a 0%nat) _ z (s 0%nat)) as s0.
  pose proof (smooth_plus_times 1 _ (a 1%nat) _ s0 (s 1%nat)) as s1.
  rewrite (d_plus_times _ _ _ j (has_slope 0 _ s1) (has_slope 0 _ (s 2%nat))).
  rewrite (d_plus_times _ _ _ j (has_slope 0 _ s0) (has_slope 0 _ (s 1%nat))).
  rewrite (d_plus_times _ _ _ j (has_slope 0 _ z) (has_slope 0 _ (s 0%nat))), d_zero. reflexivity.
Qed.
Lemma along_field a f : smooth 1 f -> along a f = dot_field a (fun j => d j f).
Proof.
  intros s. at_any_point. unfold along.
  pose proof (is_derive_along f x x0 x1 (a 0%nat) (a 1%nat) (a 2%nat) 0 s) as D.
  rewrite !Rmult_0_l, !Rplus_0_r in D. exact (is_derive_unique _ _ _ D).
Qed.
Lemma along_smooth n a f : smooth (S n) f -> smooth n (along a f).
Proof.
  intros s. rewrite (along_field a f (smooth_1 n f s)). apply dot_field_smooth. intros j. apply d_smooth, s.
Qed.
Lemma along_twice a b f : smooth 2 f ->
  along b (along a f) = dot_field b (fun l => dot_field a (fun j => d l (d j f))).
Proof.
  intros s. rewrite (along_field b) by (apply along_smooth, s). f_equal.
  apply equal_everywhere. intros l. rewrite along_field by (apply smooth_less, s).
  apply d_dot_field. intros j. apply d_smooth, s.
Qed.
Lemma along_thrice a b c f : smooth 3 f ->
  along c (along b (along a f))
  = dot_field c (fun m => dot_field b (fun l => dot_field a (fun j => d m (d l (d j f))))).
Proof.
  intros s. rewrite (along_twice b c) by (apply along_smooth, s). f_equal.
  apply equal_everywhere. intros m. f_equal. apply equal_everywhere. intros l.
  rewrite along_field by (apply (smooth_1 2), s).
  rewrite d_dot_field by (intros j; apply smooth_less, d_smooth, s).
  apply d_dot_field. intros j. apply d_smooth, d_smooth, s.
Qed.

(* ---- operators along a frame *)
Definition gradient (r : nat -> nat -> R) (f : field) : vector := fun i x0 x1 x2 =>
  sum (fun k => r k i * along (r k) f x0 x1 x2).
Definition curl (r : nat -> nat -> R) (f : vector) : vector := fun i x0 x1 x2 =>
  sum (fun k => cross (r k) (fun m => along (r k) (f m) x0 x1 x2) i).
Fixpoint curls (n : nat) (r : nat -> nat -> R) (f : vector) : vector :=
  match n with O => f | S m => curl r (curls m r f) end.

Definition axis_curl (f : vector) : vector := fun i => match i with
  | O => plus_times (d 1 (f 2%nat)) (-1) (d 2 (f 1%nat))
  | 1%nat => plus_times (d 2 (f 0%nat)) (-1) (d 0 (f 2%nat))
  | _ => plus_times (d 0 (f 1%nat)) (-1) (d 1 (f 0%nat))
  end.
Fixpoint axis_curls (n : nat) (f : vector) : vector :=
  match n with O => f | S m => axis_curl (axis_curls m f) end.

Lemma gradient_is r f i : frame r -> smooth 1 f -> (i < 3)%nat -> gradient r f i = d i f.
Proof.
  intros H s l. at_any_point. unfold gradient, sum. rewrite !(along_field _ f s).
  exact (in_frame r i (fun j => d j f x x0 x1) H l).
Qed.
Lemma gradient_smooth n r f : smooth (S n) f -> smooth_vector n (gradient r f).
Proof.
  intros s i. apply (dot_field_smooth n (fun k => r k i) (fun k => along (r k) f)).
  intros k. apply along_smooth, s.
Qed.
Lemma curl_is r f : frame r -> smooth_vector 1 f -> curl r f = axis_curl f.
Proof.
  intros H s. apply equal_everywhere; intros i. at_any_point.
  assert (twice : forall i j m n, (i < 3)%nat -> (j < 3)%nat ->
    sum (fun k => r k i * along (r k) (f m) x x0 x1 - r k j * along (r k) (f n) x x0 x1)
    = plus_times (d i (f m)) (-1) (d j (f n)) x x0 x1).
  { intros j l m n lj ll. unfold sum, plus_times. rewrite !(along_field _ _ (s _)). unfold dot_field.
    rewrite <- (in_frame r j (fun j => d j (f m) x x0 x1) H lj).
    rewrite <- (in_frame r l (fun j => d j (f n) x x0 x1) H ll). unfold sum. ring. }
  unfold curl. destruct i as [|[|i]]; apply twice; lia.
Qed.
Lemma axis_curl_smooth n f : smooth_vector (S n) f -> smooth_vector n (axis_curl f).
Proof. intros s [|[|i]]; apply smooth_plus_times; apply d_smooth, s. Qed.
Lemma axis_curls_smooth n m : forall f, smooth_vector (n + m) f -> smooth_vector n (axis_curls m f).
Proof.
  revert n. induction m as [|m h]; intros n f s; simpl; [now rewrite <- plus_n_O in s|].
  apply axis_curl_smooth, h. now rewrite <- plus_n_Sm in s.
Qed.
Lemma curls_are r n : forall f, frame r -> smooth_vector n f -> curls n r f = axis_curls n f.
Proof.
  induction n as [|n h]; intros f H s; [reflexivity|]. simpl.
  rewrite h; [|assumption | intros i; apply smooth_less, s].
  apply curl_is; [assumption|]. now apply (axis_curls_smooth 1 n).
Qed.
