(* A vector is determined by its dot products with all edges. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma other_factor : forall d x, d <> 0 -> d * x = 0 -> x = 0.
Proof. intros d x D H. destruct (Rmult_integral _ _ H); [contradiction | assumption]. Qed.

Ltac no_other x0 y0 z0 x1 y1 z1 x2 y2 z2 x3 y3 z3 px py pz d1 d2 d3 :=
  generalize dependent (x1 - x0); generalize dependent (y1 - y0); generalize dependent (z1 - z0);
  generalize dependent (x2 - x0); generalize dependent (y2 - y0); generalize dependent (z2 - z0);
  generalize dependent (x3 - x0); generalize dependent (y3 - y0); generalize dependent (z3 - z0);
  generalize dependent (px - x0); generalize dependent (py - y0); generalize dependent (pz - z0);
  intros w v u c3 b3 a3 c2 b2 a2 c1 b1 a1 D e1 e2 e3;
  assert (solved : forall x y z, a1 * x + b1 * y + c1 * z = 0 -> a2 * x + b2 * y + c2 * z = 0 ->
      a3 * x + b3 * y + c3 * z = 0 -> x = 0 /\ y = 0 /\ z = 0)
    by (clear -D; intros x y z h1 h2 h3; repeat split; apply (other_factor _ _ D);
        [transitivity ((b2 * c3 - c2 * b3) * (a1 * x + b1 * y + c1 * z)
           + (b3 * c1 - c3 * b1) * (a2 * x + b2 * y + c2 * z)
           + (b1 * c2 - c1 * b2) * (a3 * x + b3 * y + c3 * z))
        |transitivity ((c2 * a3 - a2 * c3) * (a1 * x + b1 * y + c1 * z)
           + (c3 * a1 - a3 * c1) * (a2 * x + b2 * y + c2 * z)
           + (c1 * a2 - a1 * c2) * (a3 * x + b3 * y + c3 * z))
        |transitivity ((a2 * b3 - b2 * a3) * (a1 * x + b1 * y + c1 * z)
           + (a3 * b1 - b3 * a1) * (a2 * x + b2 * y + c2 * z)
           + (a1 * b2 - b1 * a2) * (a3 * x + b3 * y + c3 * z))];
        solve [ring | rewrite h1, h2, h3; ring]);
  destruct (solved (a1 * d1 + a2 * d2 + a3 * d3 - u) (b1 * d1 + b2 * d2 + b3 * d3 - v)
                   (c1 * d1 + c2 * d2 + c3 * d3 - w)) as [su [sv sw]]; try lra;
  replace u with (a1 * d1 + a2 * d2 + a3 * d3) by lra; replace v with (b1 * d1 + b2 * d2 + b3 * d3) by lra;
  replace w with (c1 * d1 + c2 * d2 + c3 * d3) by lra; field; exact D.
