(* Sums over any number of particles in a plane. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require Import List Nsatz.
Import ListNotations.
Local Open Scope R_scope.

(* over particles of the mass m at (x, y), however many *)
Definition total (l : list (R * R * R)) (f : R -> R -> R -> R) : R :=
  fold_right (fun p s => match p with (m, x, y) => f m x y end + s) 0 l.

Lemma total_ext : forall l f g, (forall m x y, f m x y = g m x y) -> total l f = total l g.
Proof.
  intros l f g e. unfold total. induction l as [|[[m x] y] l h]; simpl; [reflexivity | now rewrite h, e].
Qed.
Lemma total_of_two : forall l a b f g,
  total l (fun m x y => a * f m x y + b * g m x y) = a * total l f + b * total l g.
Proof. intros. unfold total. induction l as [|[[m x] y] l h]; simpl; [|rewrite h]; ring. Qed.
