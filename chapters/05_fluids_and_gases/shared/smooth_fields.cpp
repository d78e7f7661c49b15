#include "chapters/05_fluids_and_gases/shared/smooth_fields.hpp"

namespace oddity::fields {

namespace {

const std::string derivatives_in_coq = R"(
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

)";

const std::string operators_in_coq = R"((* ---- sums of fields *)
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
)";

}  // namespace

std::string frames_in_coq() {
  return R"((* ---- frames *)
Definition sum (g : nat -> R) := g 0%nat + g 1%nat + g 2%nat.
Definition dot (a b : nat -> R) := sum (fun i => a i * b i).
Definition cross (a b : nat -> R) (i : nat) := match i with
  | O => a 1%nat * b 2%nat - a 2%nat * b 1%nat
  | 1%nat => a 2%nat * b 0%nat - a 0%nat * b 2%nat
  | _ => a 0%nat * b 1%nat - a 1%nat * b 0%nat
  end.
(* three vectors of unit length at right angles, right-handed *)
Definition frame (r : nat -> nat -> R) :=
  dot (r 0%nat) (r 0%nat) = 1 /\ dot (r 1%nat) (r 1%nat) = 1 /\ dot (r 0%nat) (r 1%nat) = 0 /\
  r 2%nat = cross (r 0%nat) (r 1%nat).

Lemma orthonormal a0 a1 a2 b0 b1 b2 :
  a0 * a0 + a1 * a1 + a2 * a2 = 1 -> b0 * b0 + b1 * b1 + b2 * b2 = 1 -> a0 * b0 + a1 * b1 + a2 * b2 = 0 ->
  let c0 := a1 * b2 - a2 * b1 in let c1 := a2 * b0 - a0 * b2 in let c2 := a0 * b1 - a1 * b0 in
  (a0 * a0 + b0 * b0 + c0 * c0 = 1 /\ a1 * a1 + b1 * b1 + c1 * c1 = 1 /\ a2 * a2 + b2 * b2 + c2 * c2 = 1) /\
  (a0 * a1 + b0 * b1 + c0 * c1 = 0 /\ a0 * a2 + b0 * b2 + c0 * c2 = 0 /\ a1 * a2 + b1 * b2 + c1 * c2 = 0) /\
  (b1 * c2 - b2 * c1 = a0 /\ b2 * c0 - b0 * c2 = a1 /\ b0 * c1 - b1 * c0 = a2) /\
  (c1 * a2 - c2 * a1 = b0 /\ c2 * a0 - c0 * a2 = b1 /\ c0 * a1 - c1 * a0 = b2).
Proof. intros. unfold c0, c1, c2. repeat split; nsatz. Qed.
Lemma orthonormal_frame r : frame r ->
  (forall i j, (i < 3)%nat -> (j < 3)%nat -> sum (fun k => r k i * r k j) = if Nat.eqb i j then 1 else 0) /\
  (forall i, cross (r 1%nat) (r 2%nat) i = r 0%nat (min i 2) /\
    cross (r 2%nat) (r 0%nat) i = r 1%nat (min i 2) /\ cross (r 0%nat) (r 1%nat) i = r 2%nat (min i 2)).
Proof.
  intros (aa & bb & ab & c). unfold dot, sum in *.
  destruct (orthonormal _ _ _ _ _ _ aa bb ab)
    as ((c00 & c11 & c22) & (c01 & c02 & c12) & (a0 & a1 & a2) & (b0 & b1 & b2)).
  split; rewrite c.
  - intros i j l m. assert (i = 0 \/ i = 1 \/ i = 2)%nat as [-> | [-> | ->]] by lia;
      assert (j = 0 \/ j = 1 \/ j = 2)%nat as [-> | [-> | ->]] by lia; simpl; lra.
  - intros [|[|i]]; simpl; rewrite ?Nat.min_0_r; repeat split; simpl; auto.
Qed.
Lemma in_frame r i (x : nat -> R) : frame r -> (i < 3)%nat -> sum (fun k => r k i * dot (r k) x) = x i.
Proof.
  intros H l. destruct (orthonormal_frame r H) as [c _].
  transitivity (sum (fun j => sum (fun k => r k i * r k j) * x j)); [unfold dot, sum; ring|].
  unfold sum at 1. rewrite !c by lia.
  assert (i = 0 \/ i = 1 \/ i = 2)%nat as [-> | [-> | ->]] by lia; simpl; ring.
Qed.


)";
}

std::string smooth_fields_in_coq() { return derivatives_in_coq + frames_in_coq() + operators_in_coq; }

std::string repeated_curls_in_coq() {
  return R"(
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
)";
}

}  // namespace oddity::fields
