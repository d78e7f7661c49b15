(* Right-handed orthonormal frames. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require Import Lia Nsatz.
Local Open Scope R_scope.

(* ---- frames *)
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
