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

(* The sum of m (x - c) is the sum of m x minus c times the mass. *)
Ltac by_sums d0 d1 :=
  first [ apply total_ext; intros; first [ring | replace (d0 * d0 - d1 * - d1) with 1 by lra; field]
  | rewrite <- ?total_of_two, ?Rmult_0_l, ?Rplus_0_r; first [ring | apply total_ext; intros; ring] ].
Ltac by_center l a0 a1 center0 center1 :=
  let apart := fresh in
  assert (apart : forall c g, total l (fun m x y => m * (g x y - c))
      = total l (fun m x y => m * g x y) - c * total l (fun m x y => m))
    by (intros c g; rewrite (total_ext l _ (fun m x y => 1 * (m * g x y) + (- c) * m)) by (intros; ring);
        rewrite (total_of_two l 1 (- c) (fun m x y => m * g x y) (fun m x y => m)); ring);
  rewrite ?(apart a0 (fun x y => x)), ?(apart a1 (fun x y => y)), ?center0, ?center1; ring.
Ltac of_unit d0 d1 := replace (d0 * d0 - d1 * - d1) with 1 by lra.
(* The distance from a line by an area. *)
Ltac by_area d0 d1 :=
  of_unit d0 d1; let unit := fresh in assert (unit : d1 * d1 = 1 - d0 * d0) by lra;
  rewrite <- sqrt_Rsqr_abs; unfold Rsqr;
  match goal with |- sqrt ?t = sqrt ?a / 7 =>
    replace a with (7 * 7 * t) by field [unit]; rewrite (sqrt_mult_alt (7 * 7)) by lra;
    rewrite (sqrt_square 7) by lra; field
  end.
