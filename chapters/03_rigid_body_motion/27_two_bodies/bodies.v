(* The distance of two bodies, by sin^2 + cos^2 of both angles. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.

Ltac by_distance m1 m2 r theta phi :=
  let sine_theta := fresh "sine_theta" in let sine_phi := fresh "sine_phi" in
  assert (sine_theta : sin theta ^ 2 = 1 - cos theta ^ 2)
    by (pose proof (sin2_cos2 theta) as e; unfold Rsqr in e; lra);
  assert (sine_phi : sin phi ^ 2 = 1 - cos phi ^ 2)
    by (pose proof (sin2_cos2 phi) as e; unfold Rsqr in e; lra);
  repeat match goal with |- context [sqrt ?x] =>
    replace (sqrt x) with r by
      (symmetry; replace x with (r * r) by (field [sine_theta sine_phi]; lra); apply sqrt_square; lra) end;
  try match goal with |- _ = _ / ?mass => first
    [ replace mass with (m1 * m2 / (m1 + m2)) by (field [sine_theta sine_phi]; lra)
    | replace mass with ((m1 * m2 / (m1 + m2)) ^ 3 * r ^ 4 * sin phi ^ 2)
        by (field [sine_theta sine_phi]; lra) ] end;
  field [sine_theta sine_phi]; repeat split; first [assumption | nra].
