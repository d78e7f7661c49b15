(* The matrix of the dot products has positive leading minors, and elimination divides only by their quotients. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma some_length : forall x y z, ~ (x = 0 /\ y = 0 /\ z = 0) -> x * x + y * y + z * z > 0.
Proof. intros x y z H. apply Rnot_le_gt; intro; apply H; repeat split; nra. Qed.

Ltac minors_of_edges x0 y0 z0 x1 y1 z1 x2 y2 z2 x3 y3 z3 :=
  generalize dependent (x1 - x0); generalize dependent (y1 - y0); generalize dependent (z1 - z0);
  generalize dependent (x2 - x0); generalize dependent (y2 - y0); generalize dependent (z2 - z0);
  generalize dependent (x3 - x0); generalize dependent (y3 - y0); generalize dependent (z3 - z0);
  intros c3 b3 a3 c2 b2 a2 c1 b1 a1 D;
  first
  [ replace (a1 * _ + _) with (a1 * a1 + b1 * b1 + c1 * c1) by ring; apply some_length;
    intros [h [k l]]; apply D; rewrite h, k, l; ring
  | match goal with |- ?x > 0 => replace x with
      ((b1 * c2 - c1 * b2) * (b1 * c2 - c1 * b2) + (c1 * a2 - a1 * c2) * (c1 * a2 - a1 * c2)
       + (a1 * b2 - b1 * a2) * (a1 * b2 - b1 * a2)) by ring end; apply some_length;
    intros [h [k l]]; apply D;
    transitivity (a3 * (b1 * c2 - c1 * b2) + b3 * (c1 * a2 - a1 * c2) + c3 * (a1 * b2 - b1 * a2));
    [ring | rewrite h, k, l; ring]
  | match type of D with ?d <> 0 => match goal with |- ?x > 0 => replace x with (Rsqr d) by (unfold Rsqr; ring) end end;
    apply Rsqr_pos_lt, D ].
Ltac quotient n d :=
  match goal with |- ?x > 0 => replace x with (n / d) by (field; lra) end; apply Rdiv_lt_0_compat; lra.
Ltac pivots := match goal with P : ?p > 0, Q : ?q > 0, S : ?s > 0 |- _ => solve [lra | quotient q p | quotient s q] end.
