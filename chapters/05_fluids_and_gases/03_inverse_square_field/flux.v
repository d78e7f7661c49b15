(* The flux through a sphere. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "slopes.v".
Load "../../integrals.v".

Ltac in_reals := match goal with |- ?x = ?y => change (@eq R x y) end.
Ltac flux_is a theta phi p :=
  transitivity (RInt (fun _ => 2) 0 (2 * PI));
  [apply RInt_ext; intros phi _; transitivity (RInt sin 0 PI);
    [apply RInt_ext; intros theta _; in_reals;
     assert (circle : sin theta * sin theta = 1 - cos theta * cos theta)
       by (pose proof (sin2_cos2 theta) as all; unfold Rsqr in all; lra);
     assert (around : sin phi * sin phi = 1 - cos phi * cos phi)
       by (pose proof (sin2_cos2 phi) as all; unfold Rsqr in all; lra);
     match goal with |- context [sqrt ?t] =>
       replace (sqrt t) with a by (replace t with (a * a) by ring [circle around]; symmetry; apply sqrt_square; lra)
     end;
     transitivity (sin theta * (sin theta * sin theta * (cos phi * cos phi + sin phi * sin phi)
       + cos theta * cos theta)); [field; lra | ring [circle around]]
    | rewrite (RInt_by (fun t => - cos t));
        [in_reals; rewrite cos_PI, cos_0; ring
        | intros; auto_derive; [exact I | in_reals; ring]
        | intros; apply @ex_derive_continuous; auto_derive; exact I]]
  | rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; ring].
