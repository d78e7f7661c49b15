(* Curls expanded to derivatives in one order. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/curls.v".

Ltac in_one_order s := repeat (match goal with
  | |- context [d 1 (d 0 ?g)] => rewrite (d_swap g 1 0) by (apply s)
  | |- context [d 2 (d 0 ?g)] => rewrite (d_swap g 2 0) by (apply s)
  | |- context [d 2 (d 1 ?g)] => rewrite (d_swap g 2 1) by (apply s)
  end).
Ltac expanded_curls H s :=
  rewrite ?(curls_expanded _ _ _ _ _ _ _ H s); cbn [expanded derivative List.fold_left].

(* A curl that is differentiated once more. *)
Ltac is_curl f g n i H s :=
  replace g with (axis_curls n f i)
    by (apply equal_everywhere; intros y0; apply equal_everywhere; intros y1; apply equal_everywhere; intros y2;
        change (axis_curls n f i y0 y1 y2) with (derivative nil (axis_curls n f i) y0 y1 y2);
        rewrite (expand n f i nil) by (exact s); cbn [expanded derivative List.fold_left]; ring).
Ltac nested_curls n H s :=
  match type of s with smooth_vector _ ?f =>
    rewrite (curls_are _ _ _ H s);
    pose proof (fun i => smooth_less n (f i) (s i)) as less;
    repeat (match goal with |- context [d ?j ?g] => lazymatch g with axis_curls _ _ _ => fail | d _ _ => fail
      | _ => first [is_curl f g n 0%nat H less | is_curl f g n 1%nat H less | is_curl f g n 2%nat H less] end end);
    cbn [axis_curls axis_curl]; unfold plus_times; ring
  end.
Ltac turned_products H := let c := fresh in
  destruct (orthonormal_frame _ H) as [_ c];
  destruct (c 0%nat) as (a0 & b0 & c0), (c 1%nat) as (a1 & b1 & c1), (c 2%nat) as (a2 & b2 & c2); simpl in *;
  first [rewrite <- a0, <- a1, <- a2; ring | rewrite <- b0, <- b1, <- b2; ring
       | rewrite <- c0, <- c1, <- c2; ring].
Ltac turned_curls r f x0 x1 x2 H s :=
  first [etransitivity; [exact (twice_turned r f 0 x0 x1 x2 H s ltac:(lia))|]
       | etransitivity; [exact (twice_turned r f 1 x0 x1 x2 H s ltac:(lia))|]
       | etransitivity; [exact (twice_turned r f 2 x0 x1 x2 H s ltac:(lia))|]];
  pose proof (turned_smooth 2 r f s) as t;
  repeat (match goal with |- context [d ?l (d ?j ?g)] => lazymatch g with turned _ _ _ => fail
    | _ => first [change g with (turned r f 0%nat) | change g with (turned r f 1%nat)
         | change g with (turned r f 2%nat)] end end);
  cbn [expanded derivative List.fold_left]; in_one_order t; ring.
