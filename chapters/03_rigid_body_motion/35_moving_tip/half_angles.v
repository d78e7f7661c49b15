(* The model uses half angles; theta, phi and psi are sums of these. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/tops.v".

Ltac by_half_angles theta phi psi :=
  let u := fresh "u" in let s := fresh "s" in let d := fresh "d" in
  pose (u := phi / 2); pose (s := (theta + psi) / 2); pose (d := (theta - psi) / 2); fold u; fold s; fold d;
  let p := fresh in assert (p : phi = 2 * u) by (unfold u; field);
  let t := fresh in assert (t : theta = s + d) by (unfold s, d; field);
  let q := fresh in assert (q : psi = s - d) by (unfold s, d; field);
  clearbody u; clearbody s; clearbody d; rewrite ?p, ?t, ?q;
  rewrite ?cos_plus, ?sin_plus, ?cos_minus, ?sin_minus, ?cos_2a, ?sin_2a;
  field [(circle u) (circle s) (circle d)]; positive.

(* Where the angles are 1/2, 1 and 1/4. *)
Ltac at_example :=
  assert (sin 1 <> 0) by interval; field [(circle (5 / 10)) (circle 1) (circle (25 / 100))]; trivial.
