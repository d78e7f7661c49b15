(* The real and the imaginary part of the square root of a number, one of which is zero. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Lemma parts : forall d, let x := sqrt ((Rabs d + d) / 2) in let y := sqrt ((Rabs d - d) / 2) in
  x * x = d + y * y /\ x * y = 0 /\ 0 <= x /\ 0 <= y /\ (d >= 0 -> y = 0) /\ (d < 0 -> x = 0).
Proof.
  intros d x y. unfold x, y. unfold Rabs. destruct (Rcase_abs d).
  - replace ((- d + d) / 2) with 0 by field. replace ((- d - d) / 2) with (- d) by field.
    rewrite sqrt_0, sqrt_sqrt by lra. pose proof (sqrt_pos (- d)). repeat split; lra.
  - replace ((d + d) / 2) with d by field. replace ((d - d) / 2) with 0 by field.
    rewrite sqrt_0, sqrt_sqrt by lra. pose proof (sqrt_pos d). repeat split; lra.
Qed.
Ltac by_parts_of_the_root m c a :=
  destruct (parts (a * a - 4 * m * c)) as [square [product _]];
  set (x := sqrt ((Rabs (a * a - 4 * m * c) + (a * a - 4 * m * c)) / 2)) in *;
  set (y := sqrt ((Rabs (a * a - 4 * m * c) - (a * a - 4 * m * c)) / 2)) in *; clearbody x y;
  field [square product]; first [lra | split; [lra | apply Rgt_not_eq, exp_pos] | apply Rgt_not_eq, exp_pos].
Ltac signs_of_the_parts m c a :=
  destruct (parts (a * a - 4 * m * c)) as [square [product [above_x [above_y [real complex]]]]];
  set (x := sqrt ((Rabs (a * a - 4 * m * c) + (a * a - 4 * m * c)) / 2)) in *;
  set (y := sqrt ((Rabs (a * a - 4 * m * c) - (a * a - 4 * m * c)) / 2)) in *; clearbody x y;
  assert (p : m * c > 0) by nra;
  match goal with
  | D : _ >= 0 |- _ => rewrite (real ltac:(lra)) in *; assert (x < a) by nra
  | |- _ => rewrite (complex ltac:(lra)) in *; assert (y > 0) by nra; assert (0 < y / (2 * m)) by (apply Rdiv_lt_0_compat; lra)
  end;
  match goal with
  | |- _ = 0 => field; lra
  | |- - ?z > 0 => let w := fresh in
      assert (w : - z * (2 * m) > 0) by (field_simplify; lra); nra
  | |- ?z <> 0 => first [lra | replace z with (- (y / (2 * m))) by (field; lra); lra]
  end.
