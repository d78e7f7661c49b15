(* Replaces the angle by its half, and products of the letters of an axis and its rate, as needed for rewriting (Groebner bases, d2 > e2 > d1 > e1 > d0 > e0). *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

From Coq Require Import Nsatz.
Local Open Scope R_scope.

Lemma halves : forall x, let h := 5 / 10 * x in
  sin x = 2 * sin h * cos h /\ cos x = 1 - 2 * (sin h * sin h) /\ cos h * cos h = 1 - sin h * sin h.
Proof.
  intros x h. pose proof (sin_2a h) as s. pose proof (cos_2a h) as c. pose proof (sin2_cos2 h) as all.
  replace (2 * h) with x in * by (unfold h; field). unfold Rsqr in all. repeat split; lra.
Qed.

Section Turning.
Variables d0 d1 d2 e0 e1 e2 : R.
Hypothesis axis : d0 * d0 + d1 * d1 + d2 * d2 = 1.
Hypothesis across : d0 * e0 + d1 * e1 + d2 * e2 = 0.
Lemma axis_squared : d2 * d2 = 1 - d0 * d0 - d1 * d1.
Proof. lra. Qed.
Lemma axis_by_rate : d2 * e2 = - (d0 * e0 + d1 * e1).
Proof. lra. Qed.
Lemma axis_twice : d1 * d1 * e2 = e2 + d0 * d2 * e0 + d1 * d2 * e1 - d0 * d0 * e2.
Proof. nsatz. Qed.
End Turning.

(* as nsatz reads them *)
Ltac products :=
  repeat match goal with
         | |- context [?x ^ 2] => replace (x ^ 2) with (x * x) by ring
         | |- context [?x ^ 3] => replace (x ^ 3) with (x * x * x) by ring
         | |- context [?x ^ 4] => replace (x ^ 4) with (x * x * x * x) by ring
         end.

(* `one`: the axis has length one; `across`: it is perpendicular to its rate. *)
Ltac by_halves theta one across :=
  destruct (halves theta) as (sine & cosine & circle); rewrite ?sine, ?cosine;
  pose proof (axis_squared _ _ _ one) as a; pose proof (axis_by_rate _ _ _ _ _ _ across) as b;
  pose proof (axis_twice _ _ _ _ _ _ one across) as c; field [circle a b c].
Ltac by_halves_and_rate theta one across :=
  destruct (halves theta) as (sine & cosine & circle); rewrite ?sine, ?cosine; clear sine cosine;
  pose proof (axis_squared _ _ _ one) as a; pose proof (axis_by_rate _ _ _ _ _ _ across) as b;
  field_simplify_eq [circle a b]; try ring; clear a b circle;
  generalize (cos (5 / 10 * theta)) (sin (5 / 10 * theta)); intros; products; nsatz.

(* `moves`: the rate is not zero. *)
Ltac by_length moves :=
  match type of moves with ?square > 0 =>
    pose proof (sqrt_lt_R0 _ moves) as far;
    assert (long : sqrt square * sqrt square = square) by (apply sqrt_sqrt; lra);
    set (r := sqrt square) in *; clearbody r;
    assert (unit : / r * / r * square = 1) by (rewrite <- long; field; lra);
    unfold Rdiv; set (q := / r) in *; clearbody q; clear far long moves; nsatz
  end.
