(* Double integrals. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../integrals.v".

(* F is the antiderivative by y of f, and G by x of what F makes of the ends. *)
Lemma nested_by : forall (F f : R -> R -> R) G lo hi a b,
  (forall x y, is_derive (F x) y (f x y)) -> (forall x y, continuous (f x) y) ->
  (forall x, is_derive G x (F x (hi x) - F x (lo x))) ->
  (forall x, continuous (fun x => F x (hi x) - F x (lo x)) x) ->
  RInt (fun x => RInt (fun y => f x y) (lo x) (hi x)) a b = G b - G a.
Proof.
  intros F f G lo hi a b D C E K. rewrite <- (RInt_by G (fun x => F x (hi x) - F x (lo x))); auto.
  apply RInt_ext. intros x _. apply (RInt_by (F x)); auto.
Qed.

Ltac derived := intros; auto_derive; solve [repeat split; trivial | field].
Ltac nest F G :=
  match goal with |- RInt (fun x => RInt (fun y => @?f x y) _ _) _ _ = _ =>
    rewrite (nested_by F f G (fun x => x ^ 2) (fun _ => 1));
      [| derived | intros; apply @ex_derive_continuous; auto_derive; solve [repeat split; trivial]
       | derived | intros; apply @ex_derive_continuous; auto_derive; solve [repeat split; trivial]] end;
  match goal with |- ?x = ?y => change (@eq R x y) end; field.
