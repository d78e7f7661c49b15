(* Limits at zero of quotients of roots. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/root.v".
Load "../shared/limit_at_zero.v".

Ltac roots_at_zero :=
  repeat match goal with |- context [sqrt ?x] =>
    lazymatch x with context [sqrt _] => fail | _ => rewrite (root_is x 1) by lra end
  end.

Ltac tends :=
  lazymatch goal with
  | |- exists near, near > 0 /\ (forall t, _ -> Rabs (@?f near t - ?l) < ?eps) =>
      let f := eval cbv beta in (f 0) in
      let all := fresh in
      let like g :=
        assert (all : exists near, near > 0 /\ forall t, Rabs t < near -> t <> 0 -> Rabs (f t - l) < eps)
          by (apply (limit_at_zero f g l);
              [ auto_derive; repeat split; roots_at_zero; try (apply Rgt_not_eq, sqrt_lt_R0); lra
              | roots_at_zero; first [lra | f_equal; lra]
              | intros; first [reflexivity | field; assumption]
              | assumption ]) in
      first [like f | like (fun _ : R => l) | like (fun t => t * t) | like (fun t => 3 * t)];
      destruct all as [near [positive close]];
      exists near; split; [exact positive |]; intros t [low high];
      apply (close t); [apply Rabs_def1; lra | lra]
  end.
