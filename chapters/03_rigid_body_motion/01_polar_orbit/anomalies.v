(* Points of an ellipse by their eccentric anomaly. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../02_basic_concepts/shared/atan2.v".

(* The ellipse's points by the cosine k and the sine l of their eccentric anomaly. *)
Ltac by_anomaly :=
  lazymatch goal with E : ?e > 0, U : 1 - ?e > 0, P : ?rho > 0, far : ?r > 0, C : ?y * ?y = _ - ?x * ?x |- _
      =>
    assert (is_q : (1 - e) * (1 + e) > 0) by (apply Rmult_lt_0_compat; lra);
    pose proof (sqrt_sqrt _ (Rlt_le _ _ is_q)) as root;
    assert (near : x <= r) by nra;
    assert (positive : e * rho / ((1 - e) * (1 + e)) * (1 - e * (x / r)) > 0)
      by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra |
        assert (x / r <= 1) by (apply Rmult_le_reg_r with r; [| replace (x / r * r) with x by (field; lra)];
            lra); nra]);
    match goal with |- context [atan2 ?v ?u] =>
      assert (square : u * u + v * v = e * rho / ((1 - e) * (1 + e)) * (1 - e * (x / r)) * (e * rho / ((1 - e)
          * (1 + e)) * (1 - e * (x / r))))
        by (remember (sqrt ((1 - e) * (1 + e))) as s eqn:is_s; clear is_s; field [root C]; repeat split; lra);
      assert (off : u * u + v * v > 0) by (rewrite square; now apply Rmult_lt_0_compat);
      rewrite (cos_atan2 v u off), square, sqrt_square by (apply Rlt_le, positive);
      assert (sum : e * rho / ((1 - e) * (1 + e)) * (1 - e * (x / r)) + e * u = e * rho) by (field; repeat
          split; lra);
      remember (e * rho / ((1 - e) * (1 + e)) * (1 - e * (x / r))) as d eqn:is_d; clear is_d square off;
      replace (1 + e * (u / d)) with ((d + e * u) / d) by (generalize u; intro; field; lra); rewrite sum end;
    field; repeat split; lra
  end.
