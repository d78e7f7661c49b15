(* Motions on the pipe: a function with zero derivative is constant. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "pipe.v".

From Coquelicot Require Import AutoDerive.

Lemma constant : forall f : R -> R, (forall t, is_derive f t 0) -> forall t, f t = f 0.
Proof.
  intros f D t. destruct (Rtotal_order t 0) as [l | [-> | l]]; trivial;
    [| symmetry]; apply (eq_is_derive f); trivial; intros; apply D.
Qed.
Ltac keeps_speed phi theta psi motion t :=
  revert t; apply constant; let s := fresh in intro s; let D := fresh in let E := fresh in
  destruct (motion s) as [_ [_ [D E]]]; clear motion;
  let still d := match type of d with is_derive _ _ ?x =>
    replace 0 with x; [exact d | clear D E; on_pipe phi (theta s) (psi s)] end in
  first [still D | still E].
Ltac turns_at_one phi :=
  exists (fun t => t), (fun _ => 0), (fun _ => 1), (fun _ => 0); split;
  [let t := fresh in intro t; split; [|split; [|split]]; [auto_derive; trivial .. | |];
    match goal with |- is_derive _ _ ?x =>
      replace x with 0; [auto_derive; trivial | symmetry; on_pipe phi t 0] end
  |rewrite Rabs_right; lra].
