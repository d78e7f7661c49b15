(* For claims about distances and the angle. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../02_basic_concepts/shared/atan2.v".

(* r > 0 on the orbit, and below the farthest. *)
Lemma on_orbit : forall e rho x y, e > 0 -> 1 - e > 0 -> rho > 0 ->
  y * y = (e * rho - e * x) * (e * rho - e * x) - x * x -> e * rho - e * x > 0 /\ (1 - e) * (e * rho - e * x) <= e * rho.
Proof.
  intros e rho x y E U P C. set (r := e * rho - e * x) in *.
  assert (M : e * rho > 0) by (apply Rmult_lt_0_compat; lra). assert (R : r + e * x = e * rho) by (unfold r; ring).
  assert (B : x * x <= r * r) by nra. clearbody r.
  assert (far : r > 0).
  { destruct (Rlt_le_dec 0 r) as [|N]; trivial. assert (0 < x) by nra. assert (- r < x) by nra. nra. }
  split; trivial. assert (- r <= x) by (destruct (Rle_lt_dec (- r) x) as [|N]; trivial; nra). nra.
Qed.
(* From the orbit's other focus, the only root there is. *)
Ltac other_distance e rho x C :=
  let d := constr:(e * rho / (1 + e) + e * rho / (1 - e) - (e * rho - e * x)) in
  match goal with |- context [sqrt ?q] =>
    replace q with (d * d) by (field [C]; repeat split; lra);
    rewrite sqrt_square by (apply Rmult_le_reg_r with (1 - e); [lra |];
      assert (e * rho / (1 + e) > 0) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra);
      replace (d * (1 - e)) with (e * rho / (1 + e) * (1 - e) + (e * rho - (1 - e) * (e * rho - e * x)))
        by (field; lra); nra) end.
Ltac by_distance :=
  match goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, C : ?y * ?y = _ - ?x * ?x |- _ =>
    try replace (x ^ 2 + y ^ 2) with (x * x + y * y) by ring;
    try replace (1 - e ^ 2) with ((1 - e) * (1 + e)) by ring;
    destruct (on_orbit e rho x y E U P C) as [far below];
    assert (square : x * x + y * y = (e * rho - e * x) * (e * rho - e * x)) by lra;
    try rewrite cos_atan2 by (rewrite square; apply Rmult_lt_0_compat; lra);
    rewrite ?square, ?sqrt_square by lra;
    try other_distance e rho x C;
    field; repeat split; lra end.
Ltac by_mirrored_distance :=
  match goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, C : ?y * ?y = _ - ?x * ?x |- _ =>
    replace (1 - e ^ 2) with ((1 - e) * (1 + e)) by ring;
    assert (M : y * y = (e * rho - e * - x) * (e * rho - e * - x) - - x * - x) by (rewrite C; ring);
    destruct (on_orbit e rho (- x) y E U P M) as [far below];
    other_distance e rho (- x) M; field; repeat split; lra end.
(* By the squares of y and of the root of 1 - e^2. *)
Ltac by_squares :=
  match goal with E : ?e > 0, U : 1 - ?e > 0, C : ?y * ?y = _ - ?x * ?x |- _ =>
    try replace (1 - e ^ 2) with ((1 - e) * (1 + e)) by ring;
    assert (root : sqrt ((1 - e) * (1 + e)) * sqrt ((1 - e) * (1 + e)) = (1 - e) * (1 + e))
      by (apply sqrt_sqrt, Rlt_le, Rmult_lt_0_compat; lra);
    assert (sqrt ((1 - e) * (1 + e)) <> 0) by (apply Rgt_not_eq, sqrt_lt_R0, Rmult_lt_0_compat; lra);
    field [C root]; repeat split; lra end.
