(* Sums over any number of particles in space. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require Import List.
Local Open Scope R_scope.

(* over particles of the mass m at (x, y, z), however many *)
Definition total (l : list (R * R * R * R)) (f : R -> R -> R -> R -> R) : R :=
  fold_right (fun p s => match p with (m, x, y, z) => f m x y z end + s) 0 l.

Ltac by_particles l :=
  unfold total; induction l as [|[[[m x] y] z] l h]; cbn [fold_right]; [ring |];
  first [rewrite <- h; ring | rewrite h; ring].
