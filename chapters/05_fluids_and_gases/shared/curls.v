(* Vector fields in the coordinates of a rotated frame, and curls as sums over the permutation tensor. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/fields.v".

(* ---- in the coordinates y of a turned frame *)
Definition seen_from (r : nat -> nat -> R) (f : field) : field := fun y0 y1 y2 =>
  f (r 0%nat 0%nat * y0 + r 1%nat 0%nat * y1 + r 2%nat 0%nat * y2)
    (r 0%nat 1%nat * y0 + r 1%nat 1%nat * y1 + r 2%nat 1%nat * y2)
    (r 0%nat 2%nat * y0 + r 1%nat 2%nat * y1 + r 2%nat 2%nat * y2).
Definition turned (r : nat -> nat -> R) (f : vector) : vector := fun i =>
  dot_field (r i) (fun n => seen_from r (f n)).

Lemma is_derive_seen (f : field) (g : R -> R) a p0 p1 p2 t : smooth 1 f ->
  (forall s, g s = f (p0 + (s - t) * a 0%nat) (p1 + (s - t) * a 1%nat) (p2 + (s - t) * a 2%nat)) ->
  is_derive g t (along a f p0 p1 p2).
Proof.
  intros s e. set (q0 := p0 - t * a 0%nat). set (q1 := p1 - t * a 1%nat). set (q2 := p2 - t * a 2%nat).
  apply is_derive_ext with (fun s => f (q0 + s * a 0%nat) (q1 + s * a 1%nat) (q2 + s * a 2%nat)).
  { intros u. rewrite e. unfold q0, q1, q2. f_equal; ring. }
  pose proof (is_derive_along f q0 q1 q2 (a 0%nat) (a 1%nat) (a 2%nat) t s) as D.
  rewrite along_field by exact s. unfold q0, q1, q2 in *.
  replace (p0 - t * a 0%nat + t * a 0%nat) with p0 in D by ring.
  replace (p1 - t * a 1%nat + t * a 1%nat) with p1 in D by ring.
  replace (p2 - t * a 2%nat + t * a 2%nat) with p2 in D by ring. exact D.
Qed.
Lemma seen_slopes r f : smooth 1 f -> forall y0 y1 y2,
  is_derive (fun t => seen_from r f t y1 y2) y0 (seen_from r (along (r 0%nat) f) y0 y1 y2) /\
  is_derive (fun t => seen_from r f y0 t y2) y1 (seen_from r (along (r 1%nat) f) y0 y1 y2) /\
  is_derive (fun t => seen_from r f y0 y1 t) y2 (seen_from r (along (r 2%nat) f) y0 y1 y2).
Proof.
  intros s y0 y1 y2.
  split; [|split]; (apply is_derive_seen; [exact s | intros t; unfold seen_from; f_equal; ring]).
Qed.
Lemma d_seen r f j : smooth 1 f -> d j (seen_from r f) = seen_from r (along (r (min j 2)) f).
Proof.
  intros s. at_any_point. destruct (seen_slopes r f s x x0 x1) as (s0 & s1 & s2).
  destruct j as [|[|j]]; simpl min; [| |rewrite ?Nat.min_0_r]; apply is_derive_unique; assumption.
Qed.
Lemma seen_smooth r n : forall f, smooth n f -> smooth n (seen_from r f).
Proof.
  assert (k : forall f, is_continuous f -> is_continuous (seen_from r f)).
  { intros f k x0 x1 x2.
    assert (c : forall a b c,
      continuous (fun p : R * R * R => a * fst (fst p) + b * snd (fst p) + c * snd p) (x0, x1, x2)).
    { intros a b c.
      apply (continuous_plus (V := R_NormedModule)); [apply (continuous_plus (V := R_NormedModule))|].
      - apply (continuous_scal_r a (fun p : R * R * R => fst (fst p))), (continuous_comp fst fst);
          apply continuous_fst.
      - apply (continuous_scal_r b (fun p : R * R * R => snd (fst p))), (continuous_comp fst snd);
          [apply continuous_fst | apply continuous_snd].
      - apply (continuous_scal_r c (fun p : R * R * R => snd p)), continuous_snd. }
    exact (continuous_through f _ _ _ (x0, x1, x2) k (c _ _ _) (c _ _ _) (c _ _ _)). }
  induction n as [|n h]; intros f s.
  - split; [apply k, s | exact I].
  - split; [apply k, (smooth_0 _ _ s) | split].
    + intros y0 y1 y2. destruct (seen_slopes r f (smooth_1 n f s) y0 y1 y2) as (s0 & s1 & s2).
      split; [|split]; eexists; eassumption.
    + intros j. rewrite d_seen by exact (smooth_1 n f s). apply h, along_smooth, s.
Qed.
Lemma turned_smooth n r f : smooth_vector n f -> smooth_vector n (turned r f).
Proof. intros s i. apply dot_field_smooth. intros m. apply seen_smooth, s. Qed.
Lemma d_turned r f i j : smooth_vector 1 f -> (j < 3)%nat ->
  d j (turned r f i) = dot_field (r i) (fun m => seen_from r (dot_field (r j) (fun l => d l (f m)))).
Proof.
  intros s l. unfold turned. rewrite d_dot_field by (intros m; apply seen_smooth, s).
  f_equal. apply equal_everywhere. intros m. rewrite d_seen by apply s.
  replace (min j 2) with j by lia. now rewrite along_field by apply s.
Qed.
Lemma axis_curl_turned r f : frame r -> smooth_vector 1 f -> forall i, (i < 3)%nat ->
  axis_curl (turned r f) i = turned r (axis_curl f) i.
Proof.
  intros H s i l. destruct (orthonormal_frame r H) as [_ c].
  destruct (c 0%nat) as (a0 & b0 & c0), (c 1%nat) as (a1 & b1 & c1), (c 2%nat) as (a2 & b2 & c2).
  simpl in *. assert (i = 0 \/ i = 1 \/ i = 2)%nat as [-> | [-> | ->]] by lia; simpl;
    rewrite !d_turned by (assumption || lia);
    at_any_point; unfold turned, dot_field, plus_times, seen_from, dot, sum; simpl;
    generalize (r 0%nat 0%nat * x + r 1%nat 0%nat * x0 + r 2%nat 0%nat * x1),
      (r 0%nat 1%nat * x + r 1%nat 1%nat * x0 + r 2%nat 1%nat * x1),
      (r 0%nat 2%nat * x + r 1%nat 2%nat * x0 + r 2%nat 2%nat * x1); intros p0 p1 p2;
    [rewrite <- a0, <- a1, <- a2 | rewrite <- b0, <- b1, <- b2 | rewrite <- c0, <- c1, <- c2];
    unfold plus_times; ring.
Qed.
Lemma axis_curls_turned r n : forall f, frame r -> smooth_vector n f -> forall i, (i < 3)%nat ->
  axis_curls n (turned r f) i = turned r (axis_curls n f) i.
Proof.
  induction n as [|n h]; intros f H s i l; [reflexivity|]. simpl.
  assert (m : smooth_vector n f) by (intros j; apply smooth_less, s).
  rewrite <- (axis_curl_turned r (axis_curls n f) H (axis_curls_smooth 1 n f s) i l).
  destruct i as [|[|i]]; simpl; rewrite !h by (assumption || lia); reflexivity.
Qed.

(* ---- the curls as sums of derivatives *)
(* f_{i,j1 ... jn}, j1 coming first *)
Definition derivative (js : list nat) (f : field) : field := List.fold_left (fun g j => d j g) js f.
(* one sign of the permutation tensor after the other, those that are zero left out *)
Fixpoint expanded (f : vector) (n i : nat) (js : list nat) x0 x1 x2 : R :=
  match n with
  | O => derivative js (f i) x0 x1 x2
  | S m => match i with
    | O => expanded f m 2 (1 :: js)%nat x0 x1 x2 - expanded f m 1 (2 :: js)%nat x0 x1 x2
    | 1%nat => expanded f m 0 (2 :: js)%nat x0 x1 x2 - expanded f m 2 (0 :: js)%nat x0 x1 x2
    | _ => expanded f m 1 (0 :: js)%nat x0 x1 x2 - expanded f m 0 (1 :: js)%nat x0 x1 x2
    end
  end.
Lemma derivative_plus_times js : forall f c g, smooth (length js) f -> smooth (length js) g ->
  derivative js (plus_times f c g) = plus_times (derivative js f) c (derivative js g).
Proof.
  induction js as [|j js h]; intros f c g sf sg; simpl in *; [reflexivity|].
  rewrite d_plus_times by (apply (has_slope (length js)); assumption).
  apply h; apply d_smooth; assumption.
Qed.
Lemma expand n : forall f i js x0 x1 x2, smooth_vector (length js + n) f ->
  derivative js (axis_curls n f i) x0 x1 x2 = expanded f n i js x0 x1 x2.
Proof.
  induction n as [|n h]; intros f i js x0 x1 x2 s; [reflexivity|].
  assert (t : forall k, smooth (S (length js)) (axis_curls n f k))
    by (apply axis_curls_smooth; simpl; now rewrite plus_n_Sm).
  destruct i as [|[|i]]; simpl; rewrite derivative_plus_times by (apply d_smooth, t);
    unfold plus_times; rewrite <- !h by (simpl; now rewrite plus_n_Sm); simpl; ring.
Qed.
Lemma curls_expanded r n f i x0 x1 x2 : frame r -> smooth_vector n f ->
  curls n r f i x0 x1 x2 = expanded f n i nil x0 x1 x2.
Proof. intros H s. rewrite curls_are by assumption. now apply (expand n f i nil). Qed.

(* by the inversions of (i j k) *)
Definition e (i j k : nat) : R :=
  if orb (Nat.eqb i j) (orb (Nat.eqb j k) (Nat.eqb i k)) then 0
  else if xorb (Nat.ltb j i) (xorb (Nat.ltb k j) (Nat.ltb k i)) then -1 else 1.
(* e(i jn kn) e(kn j(n-1) k(n-1)) ... e(k2 j1 k1) f(k1, j1 ... jn), summed over j1, k1, ..., jn, kn *)
Fixpoint tensors (f : vector) (n i : nat) (signs : R) (js : list nat) x0 x1 x2 : R :=
  match n with
  | O => signs * derivative js (f i) x0 x1 x2
  | S m => sum (fun j => sum (fun k => tensors f m k (signs * e i j k) (j :: js)%list x0 x1 x2))
  end.
Lemma tensors_expanded n : forall f i signs js x0 x1 x2, (i < 3)%nat ->
  tensors f n i signs js x0 x1 x2 = signs * expanded f n i js x0 x1 x2.
Proof.
  induction n as [|n h]; intros f i signs js x0 x1 x2 l; [reflexivity|].
  cbn [tensors]. unfold sum. rewrite !h by lia.
  assert (i = 0 \/ i = 1 \/ i = 2)%nat as [-> | [-> | ->]] by lia; simpl; unfold e; simpl; ring.
Qed.
Lemma twice_turned r f i x0 x1 x2 : frame r -> smooth_vector 2 f -> (i < 3)%nat ->
  dot (r i) (fun m => curls 2 r f m x0 x1 x2) = expanded (turned r f) 2 i nil
    (r 0%nat 0%nat * x0 + r 0%nat 1%nat * x1 + r 0%nat 2%nat * x2)
    (r 1%nat 0%nat * x0 + r 1%nat 1%nat * x1 + r 1%nat 2%nat * x2)
    (r 2%nat 0%nat * x0 + r 2%nat 1%nat * x1 + r 2%nat 2%nat * x2).
Proof.
  intros H s l. rewrite <- (expand 2 (turned r f) i nil) by (apply turned_smooth, s).
  unfold derivative, List.fold_left.
  rewrite (axis_curls_turned r 2 f H s i l), (curls_are r 2 f H s).
  unfold turned, dot_field, seen_from. f_equal. apply equal_everywhere. intros m.
  pose proof (fun k => in_frame r k (fun j => match j with O => x0 | 1%nat => x1 | _ => x2 end) H) as x.
  unfold dot, sum in x. f_equal; symmetry; [apply (x 0%nat) | apply (x 1%nat) | apply (x 2%nat)]; lia.
Qed.
