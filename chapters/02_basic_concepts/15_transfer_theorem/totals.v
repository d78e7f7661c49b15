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

(* about the center of mass, where a component about the origin exceeds its transfer by a multiple of the first moments *)
Ltac by_center l c0 c1 c2 center_x center_y center_z :=
  assert (f0 : total l (fun m x y z => m * (x - c0)) = 0)
    by (transitivity (total l (fun m x y z => m * x) - c0 * total l (fun m x y z => m));
        [clear -l; by_particles l | rewrite center_x; ring]);
  assert (f1 : total l (fun m x y z => m * (y - c1)) = 0)
    by (transitivity (total l (fun m x y z => m * y) - c1 * total l (fun m x y z => m));
        [clear -l; by_particles l | rewrite center_y; ring]);
  assert (f2 : total l (fun m x y z => m * (z - c2)) = 0)
    by (transitivity (total l (fun m x y z => m * z) - c2 * total l (fun m x y z => m));
        [clear -l; by_particles l | rewrite center_z; ring]);
  pose (t0 := total l (fun m x y z => m * (x - c0)));
  pose (t1 := total l (fun m x y z => m * (y - c1)));
  pose (t2 := total l (fun m x y z => m * (z - c2)));
  let exceeds_by rest := match goal with |- ?right = ?left =>
    replace left with (right + rest) by (unfold t0, t1, t2; clear -l; by_particles l);
    unfold t0, t1, t2; rewrite ?f0, ?f1, ?f2; ring end in
  first [ rewrite ?f0, ?f1, ?f2; ring
        | exceeds_by (2 * c1 * t1 + 2 * c2 * t2) | exceeds_by (2 * c0 * t0 + 2 * c2 * t2)
        | exceeds_by (2 * c0 * t0 + 2 * c1 * t1) | exceeds_by (c1 * t0 + c0 * t1)
        | exceeds_by (c2 * t0 + c0 * t2) | exceeds_by (c2 * t1 + c1 * t2) ].
