(* Fields that are smooth up to the n-th derivatives: derivatives d by the coordinates and along vectors. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require FunctionalExtensionality.
From Coq Require Import Lia Nsatz.
From Coquelicot Require Import Rcomplements Continuity Derive_2d AutoDerive.
Local Open Scope R_scope.

Definition equal_everywhere {A B : Type} := @FunctionalExtensionality.functional_extensionality A B.

Definition field := R -> R -> R -> R.
(* by x_j *)
Definition d (j : nat) (f : field) : field := fun x0 x1 x2 =>
  match j with
  | O => Derive (fun t => f t x1 x2) x0
  | 1%nat => Derive (fun t => f x0 t x2) x1
  | _ => Derive (fun t => f x0 x1 t) x2
  end.
Arguments d : simpl never.
Definition along (a : nat -> R) (f : field) : field := fun x0 x1 x2 =>
  Derive (fun t => f (x0 + t * a 0%nat) (x1 + t * a 1%nat) (x2 + t * a 2%nat)) 0.

Definition is_continuous (f : field) := forall x0 x1 x2,
  continuous (fun p : R * R * R => f (fst (fst p)) (snd (fst p)) (snd p)) (x0, x1, x2).
Definition has_slopes (f : field) := forall x0 x1 x2 : R,
  ex_derive (fun t : R => f t x1 x2) x0 /\ ex_derive (fun t : R => f x0 t x2) x1 /\
  ex_derive (fun t : R => f x0 x1 t) x2.
(* All derivatives up to the n-th exist and are continuous. *)
Fixpoint smooth (n : nat) (f : field) : Prop :=
  is_continuous f /\
  match n with
  | O => True
  | S m => has_slopes f /\ forall j, smooth m (d j f)
  end.

Lemma smooth_less n : forall f, smooth (S n) f -> smooth n f.
Proof.
  induction n as [|n h]; intros f (c & s & m); split; auto.
Qed.
Lemma smooth_0 n f : smooth n f -> is_continuous f.
Proof. destruct n; intros [c _]; exact c. Qed.
Lemma smooth_1 n : forall f, smooth (S n) f -> smooth 1 f.
Proof. induction n as [|n h]; intros f s; [exact s | apply h, smooth_less, s]. Qed.

(* on curves and surfaces *)
Lemma continuous_through {U : UniformSpace} f (a b c : U -> R) u : is_continuous f ->
  continuous a u -> continuous b u -> continuous c u -> continuous (fun v => f (a v) (b v) (c v)) u.
Proof.
  intros k ka kb kc.
  apply (continuous_comp (fun v => (a v, b v, c v))
    (fun p : R * R * R => f (fst (fst p)) (snd (fst p)) (snd p))); [|apply k].
  apply (continuous_comp_2 (fun v => (a v, b v)) c (fun p q => (p, q))); auto.
  - apply (continuous_comp_2 a b (fun p q => (p, q))); auto.
    apply continuous_ext with (fun p : R * R => p); [now intros [? ?] | apply continuous_id].
  - apply continuous_ext with (fun p : R * R * R => p); [now intros [? ?] | apply continuous_id].
Qed.

(* The derivative along the diagonal. *)
Lemma is_derive_diagonal (f gx gy : R -> R -> R) t :
  (forall x y, is_derive (fun z => f z y) x (gx x y)) ->
  (forall x y, is_derive (fun z => f x z) y (gy x y)) ->
  continuous (fun p : R * R => gx (fst p) (snd p)) (t, t) -> is_derive (fun z => f z z) t (gx t t + gy t t).
Proof.
  intros dx dy c.
  apply filterdiff_ext_lin with (fun y => plus (scal y (gx t t)) (scal y (gy t t)));
    [|intros y; unfold plus, scal; simpl; unfold mult; simpl; ring].
  apply (filterdiff_comp'_2 (fun z => z) (fun z => z) f t (fun z => z) (fun z => z)
    (fun u v => plus (scal u (gx t t)) (scal v (gy t t)))); [apply filterdiff_id | apply filterdiff_id |].
  apply (is_derive_filterdiff f t t gx (gy t t)); [|apply dy | exact c].
  apply filter_forall. intros [u v]. apply dx.
Qed.


Lemma is_derive_affine k l z : is_derive (fun s => k + s * l) z l.
Proof. auto_derive; [exact I | ring]. Qed.
Lemma continuous_affine k l z : continuous (fun s : R => k + s * l) z.
Proof. apply @ex_derive_continuous. exists l. apply is_derive_affine. Qed.
Lemma continuous_fst_affine k l (u : R * R) : continuous (fun v : R * R => k + fst v * l) u.
Proof.
  apply (continuous_comp fst (fun z => k + z * l)); [apply continuous_fst | apply continuous_affine].
Qed.
Lemma continuous_snd_affine k l (u : R * R) : continuous (fun v : R * R => k + snd v * l) u.
Proof.
  apply (continuous_comp snd (fun z => k + z * l)); [apply continuous_snd | apply continuous_affine].
Qed.
Lemma is_derive_in_affine (g : R -> R) k l z : ex_derive g (k + z * l) ->
  is_derive (fun s => g (k + s * l)) z (l * Derive g (k + z * l)).
Proof.
  intros e. apply (is_derive_comp g (fun s => k + s * l));
    [apply Derive_correct, e | apply is_derive_affine].
Qed.

Lemma is_derive_along f p q r a b c t : smooth 1 f ->
  is_derive (fun s => f (p + s * a) (q + s * b) (r + s * c)) t
    (a * d 0 f (p + t * a) (q + t * b) (r + t * c) + b * d 1 f (p + t * a) (q + t * b) (r + t * c)
     + c * d 2 f (p + t * a) (q + t * b) (r + t * c)).
Proof.
  intros (_ & s & m).
  assert (k : forall j, is_continuous (d j f)) by (intros j; exact (proj1 (m j))).
  apply (is_derive_diagonal (fun u v => f (p + u * a) (q + u * b) (r + v * c))
    (fun u v => a * d 0 f (p + u * a) (q + u * b) (r + v * c)
      + b * d 1 f (p + u * a) (q + u * b) (r + v * c))
    (fun u v => c * d 2 f (p + u * a) (q + u * b) (r + v * c))).
  - intros u v. apply (is_derive_diagonal (fun u w => f (p + u * a) (q + w * b) (r + v * c))
      (fun u w => a * d 0 f (p + u * a) (q + w * b) (r + v * c))
      (fun u w => b * d 1 f (p + u * a) (q + w * b) (r + v * c))).
    + intros x y.
      exact (is_derive_in_affine (fun z => f z (q + y * b) (r + v * c)) p a x (proj1 (s _ _ _))).
    + intros x y.
      exact (is_derive_in_affine (fun z => f (p + x * a) z (r + v * c)) q b y (proj1 (proj2 (s _ _ _)))).
    + apply (continuous_scal_r a (fun z : R * R => d 0 f (p + fst z * a) (q + snd z * b) (r + v * c))).
      apply (continuous_through (d 0 f));
        [apply k | apply continuous_fst_affine | apply continuous_snd_affine | apply continuous_const].
  - intros x y.
    exact (is_derive_in_affine (fun z => f (p + x * a) (q + x * b) z) r c y (proj2 (proj2 (s _ _ _)))).
  - apply (continuous_plus (V := R_NormedModule)).
    + apply (continuous_scal_r a (fun z : R * R => d 0 f (p + fst z * a) (q + fst z * b) (r + snd z * c))).
      apply (continuous_through (d 0 f));
        [apply k | apply continuous_fst_affine | apply continuous_fst_affine | apply continuous_snd_affine].
    + apply (continuous_scal_r b (fun z : R * R => d 1 f (p + fst z * a) (q + fst z * b) (r + snd z * c))).
      apply (continuous_through (d 1 f));
        [apply k | apply continuous_fst_affine | apply continuous_fst_affine | apply continuous_snd_affine].
Qed.

(* ---- rules *)
Ltac at_any_point := do 3 (apply equal_everywhere; intro).

Definition plus_times (f : field) (c : R) (g : field) : field := fun x0 x1 x2 =>
  f x0 x1 x2 + c * g x0 x1 x2.
Lemma has_slope n f : smooth (S n) f -> has_slopes f.
Proof. intros (_ & s & _). exact s. Qed.
Lemma d_smooth n f j : smooth (S n) f -> smooth n (d j f).
Proof. intros (_ & _ & s). apply s. Qed.
Lemma is_derive_plus_times (f g : R -> R) c x : ex_derive f x -> ex_derive g x ->
  is_derive (fun t => f t + c * g t) x (Derive f x + c * Derive g x).
Proof.
  intros ef eg. apply (is_derive_plus f (fun t => c * g t)); [now apply Derive_correct|].
  apply (is_derive_scal g x c), Derive_correct, eg.
Qed.
Lemma d_plus_times f c g j : has_slopes f -> has_slopes g ->
  d j (plus_times f c g) = plus_times (d j f) c (d j g).
Proof.
  intros sf sg. at_any_point. destruct (sf x x0 x1) as (f0 & f1 & f2), (sg x x0 x1) as (g0 & g1 & g2).
  destruct j as [|[|j]]; apply is_derive_unique.
  - exact (is_derive_plus_times (fun t => f t x0 x1) (fun t => g t x0 x1) c x f0 g0).
  - exact (is_derive_plus_times (fun t => f x t x1) (fun t => g x t x1) c x0 f1 g1).
  - exact (is_derive_plus_times (fun t => f x x0 t) (fun t => g x x0 t) c x1 f2 g2).
Qed.
Lemma smooth_plus_times n : forall f c g, smooth n f -> smooth n g -> smooth n (plus_times f c g).
Proof.
  assert (k : forall f c g, is_continuous f -> is_continuous g -> is_continuous (plus_times f c g)).
  { intros f c g kf kg x0 x1 x2. apply (continuous_plus (V := R_NormedModule)); [apply kf|].
    apply (continuous_scal_r c (fun p : R * R * R => g (fst (fst p)) (snd (fst p)) (snd p))), kg. }
  induction n as [|n h]; intros f c g sf sg.
  - split; [apply k; [exact (proj1 sf) | exact (proj1 sg)] | exact I].
  - pose proof (has_slope n f sf) as ef. pose proof (has_slope n g sg) as eg.
    split; [apply k; [exact (proj1 sf) | exact (proj1 sg)] | split].
    + intros x0 x1 x2. destruct (ef x0 x1 x2) as (f0 & f1 & f2), (eg x0 x1 x2) as (g0 & g1 & g2).
      repeat split; eexists.
      * exact (is_derive_plus_times (fun t => f t x1 x2) (fun t => g t x1 x2) c x0 f0 g0).
      * exact (is_derive_plus_times (fun t => f x0 t x2) (fun t => g x0 t x2) c x1 f1 g1).
      * exact (is_derive_plus_times (fun t => f x0 x1 t) (fun t => g x0 x1 t) c x2 f2 g2).
    + intros j. rewrite (d_plus_times f c g j ef eg). apply h; apply d_smooth; assumption.
Qed.

(* The order of derivatives: Schwarz in each plane. *)
Lemma continuous_in_plane f (a b c : R -> R -> R) x y : is_continuous f ->
  (forall u, continuous (fun v : R * R => a (fst v) (snd v)) u) ->
  (forall u, continuous (fun v : R * R => b (fst v) (snd v)) u) ->
  (forall u, continuous (fun v : R * R => c (fst v) (snd v)) u) ->
  continuity_2d_pt (fun u v => f (a u v) (b u v) (c u v)) x y.
Proof.
  intros k ka kb kc. apply continuity_2d_pt_filterlim.
  apply (continuous_through f (fun v : R * R => a (fst v) (snd v)) (fun v => b (fst v) (snd v))
    (fun v => c (fst v) (snd v)) (x, y)); auto.
Qed.
Lemma d_swap f i j : smooth 2 f -> d i (d j f) = d j (d i f).
Proof.
  intros s. pose proof (has_slope 1 f s) as e.
  assert (es : forall k, has_slopes (d k f)) by (intros k; apply (has_slope 0), d_smooth, s).
  assert (k : forall i j, is_continuous (d i (d j f)))
    by (intros k l; exact (proj1 (d_smooth 0 (d l f) k (d_smooth 1 f l s)))).
  assert (d01 : d 0 (d 1 f) = d 1 (d 0 f)).
  { at_any_point. apply (Schwarz (fun u v => f u v x1) x x0).
    - exists (mkposreal 1 Rlt_0_1). intros u v _ _.
      exact (conj (proj1 (e u v x1)) (conj (proj1 (proj2 (e u v x1)))
        (conj (proj1 (es 1%nat u v x1)) (proj1 (proj2 (es 0%nat u v x1)))))).
    - apply (continuous_in_plane (d 0 (d 1 f)) (fun u v => u) (fun u v => v) (fun u v => x1)); auto; intros;
        [apply continuous_fst | apply continuous_snd | apply continuous_const].
    - apply (continuous_in_plane (d 1 (d 0 f)) (fun u v => u) (fun u v => v) (fun u v => x1)); auto; intros;
        [apply continuous_fst | apply continuous_snd | apply continuous_const]. }
  assert (d02 : d 0 (d 2 f) = d 2 (d 0 f)).
  { at_any_point. apply (Schwarz (fun u v => f u x0 v) x x1).
    - exists (mkposreal 1 Rlt_0_1). intros u v _ _.
      exact (conj (proj1 (e u x0 v)) (conj (proj2 (proj2 (e u x0 v)))
        (conj (proj1 (es 2%nat u x0 v)) (proj2 (proj2 (es 0%nat u x0 v)))))).
    - apply (continuous_in_plane (d 0 (d 2 f)) (fun u v => u) (fun u v => x0) (fun u v => v)); auto; intros;
        [apply continuous_fst | apply continuous_const | apply continuous_snd].
    - apply (continuous_in_plane (d 2 (d 0 f)) (fun u v => u) (fun u v => x0) (fun u v => v)); auto; intros;
        [apply continuous_fst | apply continuous_const | apply continuous_snd]. }
  assert (d12 : d 1 (d 2 f) = d 2 (d 1 f)).
  { at_any_point. apply (Schwarz (fun u v => f x u v) x0 x1).
    - exists (mkposreal 1 Rlt_0_1). intros u v _ _.
      exact (conj (proj1 (proj2 (e x u v))) (conj (proj2 (proj2 (e x u v)))
        (conj (proj1 (proj2 (es 2%nat x u v))) (proj2 (proj2 (es 1%nat x u v)))))).
    - apply (continuous_in_plane (d 1 (d 2 f)) (fun u v => x) (fun u v => u) (fun u v => v)); auto; intros;
        [apply continuous_const | apply continuous_fst | apply continuous_snd].
    - apply (continuous_in_plane (d 2 (d 1 f)) (fun u v => x) (fun u v => u) (fun u v => v)); auto; intros;
        [apply continuous_const | apply continuous_fst | apply continuous_snd]. }
  destruct i as [|[|i]], j as [|[|j]]; try reflexivity; try assumption; symmetry; assumption.
Qed.
