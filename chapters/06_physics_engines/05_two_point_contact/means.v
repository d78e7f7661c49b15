(* Means over lines, faces and boxes. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../integrals.v".

Lemma over_line (h k l p : R) : RInt (fun y => k + y * l) (p - h) (p + h) = 2 * h * (k + p * l).
Proof.
  integrate (fun y => k * y + y * y * l / 2). field.
Qed.
(* of what is linear in the coordinates *)
Lemma over_cube (g : R -> R -> R -> R) h p q r :
  (forall x y z, g x y z
    = g 0 0 0 + x * (g 1 0 0 - g 0 0 0) + y * (g 0 1 0 - g 0 0 0) + z * (g 0 0 1 - g 0 0 0)) ->
  RInt (fun x => RInt (fun y => RInt (fun z => g x y z) (r - h) (r + h)) (q - h) (q + h)) (p - h) (p + h)
  = 8 * h * h * h * g p q r.
Proof.
  intros e. set (k := g 0 0 0) in *. set (a := g 1 0 0 - k) in *. set (b := g 0 1 0 - k) in *.
  set (c := g 0 0 1 - k) in *. rewrite e.
  rewrite (RInt_ext _ (fun x => 4 * h * h * (k + q * b + r * c) + x * (4 * h * h * a))).
  - rewrite over_line. match goal with |- ?x = ?y => change (@eq R x y) end. ring.
  - intros x _. rewrite (RInt_ext _ (fun y => 2 * h * (k + x * a + r * c) + y * (2 * h * b))).
    + rewrite over_line. match goal with |- ?x = ?y => change (@eq R x y) end. ring.
    + intros y _. rewrite (RInt_ext _ (fun z => (k + x * a + y * b) + z * c)) by (intros z _; apply e).
      rewrite over_line. match goal with |- ?x = ?y => change (@eq R x y) end. ring.
Qed.
Lemma on_segment (g : R -> R) : (forall u, g u = g 0 + u * (g 1 - g 0)) -> RInt g 0 1 = (g 0 + g 1) / 2.
Proof.
  intros e. rewrite (RInt_ext _ (fun u => g 0 + u * (g 1 - g 0))) by (intros u _; apply e).
  integrate (fun u => g 0 * u + u * u * (g 1 - g 0) / 2). field.
Qed.
(* of a force that rises and falls *)
Lemma of_pulse (g : R -> R) c : (forall t, g t = 630 * (t ^ 4 * (1 - t) ^ 4) * c) -> RInt g 0 1 = c.
Proof.
  intros e. rewrite (RInt_ext _ (fun t => 630 * (t ^ 4 * (1 - t) ^ 4) * c)) by (intros u _; apply e).
  integrate (fun t => (126 * t ^ 5 - 420 * t ^ 6 + 540 * t ^ 7 - 315 * t ^ 8 + 70 * t ^ 9) * c). ring.
Qed.
Ltac over_cubes := repeat match goal with |- context [RInt (fun x => RInt (fun y => RInt (fun z => @?g x y z) ?rl ?rh)
    ?ql ?qh) (?p - ?h) ?ph] =>
  match rl with ?r - _ => match ql with ?q - _ => rewrite (over_cube g h p q r) by (intros; ring) end end end.
Ltac over_lines := repeat match goal with |- context [RInt ?g 0 1] =>
  first [rewrite (on_segment g) by (intros; ring)
        | rewrite (of_pulse g (g (1 / 2) * 256 / 630)) by (intros; field; assumption)] end.
(* of what is linear in u and quadratic in v *)
Lemma over_square (g : R -> R -> R) :
  (forall u v, g u v = g u 0 + v * (4 * g u (1 / 2) - 3 * g u 0 - g u 1)
    + v * v * (2 * g u 0 - 4 * g u (1 / 2) + 2 * g u 1)) ->
  (forall u v, g u v = g 0 v + u * (g 1 v - g 0 v)) ->
  RInt (fun u => RInt (fun v => g u v) 0 1) 0 1
  = (g 0 0 + 4 * g 0 (1 / 2) + g 0 1 + (g 1 0 + 4 * g 1 (1 / 2) + g 1 1)) / 12.
Proof.
  intros q l. set (s := fun u => (g u 0 + 4 * g u (1 / 2) + g u 1) / 6).
  rewrite (RInt_ext _ (fun u => s 0 + u * (s 1 - s 0))).
  - rewrite on_segment by (intros; ring).
    match goal with |- ?x = ?y => change (@eq R x y) end. unfold s. field.
  - intros u _. rewrite (RInt_ext _ (fun v => g u 0 + v * (4 * g u (1 / 2) - 3 * g u 0 - g u 1)
      + v * v * (2 * g u 0 - 4 * g u (1 / 2) + 2 * g u 1))) by (intros v _; apply q).
    set (b := 4 * g u (1 / 2) - 3 * g u 0 - g u 1). set (c := 2 * g u 0 - 4 * g u (1 / 2) + 2 * g u 1).
    integrate (fun v => g u 0 * v + v * v / 2 * b + v * v * v / 3 * c).
    unfold b, c, s. rewrite (l u 0), (l u (1 / 2)), (l u 1). field.
Qed.
Ltac over_squares := repeat match goal with |- context [RInt (fun u => RInt (fun v => @?g u v) 0 1) 0 1] =>
  rewrite (over_square g) by (intros; field) end; cbv beta.
