(* Why the minimum found in each region is one: a convex quadratic has its minimum where no direction into the domain leads down. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma least : forall a b c d e f s t u v, a > 0 -> a * c - b * b > 0 ->
  (a * s + b * t + d) * (u - s) + (b * s + c * t + e) * (v - t) >= 0 ->
  (a * s + d + d) * s + (c * t + e + e) * t + (b + b) * s * t + f <=
  (a * u + d + d) * u + (c * v + e + e) * v + (b + b) * u * v + f.
Proof.
  intros a b c d e f s t u v A D G.
  assert (Q : 0 <= a * (a * (u - s) * (u - s) + 2 * b * (u - s) * (v - t) + c * (v - t) * (v - t))).
  { replace (a * _) with (Rsqr (a * (u - s) + b * (v - t)) + (a * c - b * b) * Rsqr (v - t)) by (unfold Rsqr; ring).
    apply Rplus_le_le_0_compat; [apply Rle_0_sqr | apply Rmult_le_pos; [lra | apply Rle_0_sqr]]. }
  rewrite <- (Rmult_0_r a) in Q. apply Rmult_le_reg_l in Q; lra.
Qed.
Lemma sum_of_products : forall p q u v, p >= 0 -> q >= 0 -> u >= 0 -> v >= 0 -> p * u + q * v >= 0.
Proof. intros. nra. Qed.
Lemma above_zero : forall n d u, n >= 0 -> d > 0 -> u >= 0 -> n / d * u >= 0.
Proof.
  intros. apply Rle_ge, Rmult_le_pos; [apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat] |]; lra.
Qed.

Ltac ways := repeat match goal with |- context [if ?d then _ else _] => destruct d; try (exfalso; lra) end.
Ltac quotients := repeat match goal with |- context [?n / ?d] =>
  let r := fresh "r" in assert (d * (n / d) = n) by (field; lra); set (r := n / d) in *; clearbody r;
  assert (0 <= r) by nra end.
Ltac sign a b c :=
  first [lra | nra | destruct (Rle_or_lt 0 b); nra | destruct (Rle_or_lt c b); nra | destruct (Rle_or_lt a b); nra].
Ltac corner a b c p q u v :=
  match goal with |- ?x >= 0 => replace x with (p * u + q * v) by ring end;
  apply sum_of_products; [sign a b c | sign a b c | lra | lra].
Ltac edge n d u :=
  match goal with |- ?x >= 0 => replace x with (n / d * u) by (field; lra) end; apply above_zero; lra.
Ltac slope a b c d e :=
  match goal with
  | |- (a * 0 + b * 0 + d) * (?u - 0) + _ * (?v - 0) >= 0 => corner a b c d e u v
  | |- (a * 1 + b * _ + d) * (?u - 1) + _ * (?v - _) >= 0 =>
    corner a b c (- (a + d)) (b + e - a - d) (1 - u - v) v
  | |- (a * 0 + b * (- e / c) + d) * (?u - 0) + _ * (?v - _) >= 0 => edge (c * d - b * e) c u
  | |- (a * 0 + b * _ + d) * (?u - 0) + _ * (?v - _) >= 0 =>
    corner a b c (- (c + e)) (b + d - c - e) (1 - u - v) u
  | |- (a * (- d / a) + b * 0 + d) * (?u - _) + _ * (?v - 0) >= 0 => edge (a * e - b * d) a v
  | |- (a * (_ / (a - b - b + c)) + _ + d) * (?u - _) + _ * (?v - _) >= 0 =>
    edge (b * e - c * d + (b * d - a * e) - (a * c - b * b)) (a - b - b + c) (1 - u - v)
  | |- ?x >= 0 => replace x with 0 by (field; lra); lra
  end.
Ltac least_by_regions a b c d e :=
  assert (c > 0) by (apply (Rmult_lt_reg_l a); [| pose proof (Rle_0_sqr b); unfold Rsqr in *]; lra);
  assert (a - b - b + c > 0)
    by (apply (Rmult_lt_reg_l a); [| pose proof (Rle_0_sqr (a - b)); unfold Rsqr in *]; lra);
  ways; (split; [quotients; repeat split; first [lra | nra]
               | intros u v [U [V W]]; apply least; trivial; slope a b c d e]).
Ltac alike D x y :=
  destruct (Rle_dec (x + y) 1); [assert (D * x + D * y <= D) by nra | assert (D * x + D * y > D) by nra];
  (destruct (Rlt_dec x 0); [assert (D * x < 0) by nra | assert (D * x >= 0) by nra]);
  (destruct (Rlt_dec y 0); [assert (D * y < 0) by nra | assert (D * y >= 0) by nra]); ways; reflexivity.
Ltac of_edges x0 y0 z0 x1 y1 z1 x2 y2 z2 :=
  generalize dependent (x1 - x0); generalize dependent (y1 - y0); generalize dependent (z1 - z0);
  generalize dependent (x2 - x0); generalize dependent (y2 - y0); generalize dependent (z2 - z0);
  intros c2 b2 a2 c1 b1 a1 area;
  match type of area with ?n <> 0 =>
    assert (n > 0) by (pose proof (Rle_0_sqr (b1 * c2 - c1 * b2)); pose proof (Rle_0_sqr (c1 * a2 - a1 * c2));
                       pose proof (Rle_0_sqr (a1 * b2 - b1 * a2)); unfold Rsqr in *; lra);
    first [ring | match goal with |- ?x > 0 => replace x with n by ring; assumption end
          | apply Rnot_le_gt; intro;
            assert (a1 = 0) by nra; assert (b1 = 0) by nra; assert (c1 = 0) by nra; subst; apply area; ring] end.
