(* The time by the angle. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "orbits.v".

From Coquelicot Require Import Continuity RInt_analysis.

(* Where the angle is a function of the time. *)
Section Time.
Variables mu r0 rd th0 w0 : R.
Variables x y u v angle : R -> R.
Hypothesis pulled : mu > 0.
Hypothesis far : r0 > 0.
Hypothesis turns : w0 <> 0.
Hypothesis path : newton mu x y u v.
Hypothesis x0 : x 0 = r0 * cos th0.
Hypothesis y0 : y 0 = r0 * sin th0.
Hypothesis u0 : u 0 = rd * cos th0 - r0 * w0 * sin th0.
Hypothesis v0 : v 0 = rd * sin th0 + r0 * w0 * cos th0.
Hypothesis there : forall s, at_angle x y s (angle s) /\ ex_derive angle s.
Local Notation h := (r0 * r0 * w0).
Local Notation square s := (x s * x s + y s * y s).

Lemma never_stops : h <> 0.
Proof. repeat apply Rmult_integral_contrapositive_currified; lra. Qed.
Lemma angle_rate : forall s, is_derive angle s (h / square s).
Proof.
  intro s. destruct (there s) as [[is_x is_y] [w is_w]]. destruct (path s) as [off [dx [dy _]]].
  replace (h / square s) with w; trivial.
  assert (still : is_derive (fun s => y s * cos (angle s) - x s * sin (angle s)) s 0).
  { apply is_derive_ext with (fun _ => 0); [| apply @is_derive_const].
    intro z. destruct (there z) as [[X Y] _]. rewrite X, Y. in_reals. ring. }
  assert (moving : is_derive (fun s => y s * cos (angle s) - x s * sin (angle s)) s
    (v s * cos (angle s) - u s * sin (angle s) - w * (y s * sin (angle s) + x s * cos (angle s)))).
  { auto_derive; [repeat split; eexists; eassumption |].
    repeat match goal with |- context [Derive ?f s] => first
      [ replace (Derive f s) with (u s) by (symmetry; exact (is_derive_unique x s _ dx))
      | replace (Derive f s) with (v s) by (symmetry; exact (is_derive_unique y s _ dy))
      | replace (Derive f s) with w by (symmetry; exact (is_derive_unique angle s _ is_w)) ] end.
    in_reals. ring. }
  pose proof (is_derive_unique _ _ _ still) as S. rewrite (is_derive_unique _ _ _ moving) in S.
  assert (R : distance x y s > 0) by (apply sqrt_lt_R0; lra).
  assert (D : distance x y s * distance x y s = square s) by (apply sqrt_sqrt; lra).
  pose proof (momentum mu r0 rd th0 w0 x y u v path x0 y0 u0 v0 s) as A.
  pose proof (unit_circle (angle s)) as circle.
  apply Rmult_eq_reg_r with (square s); [| lra].
  replace (h / square s * square s) with h by (field; lra). rewrite <- A, <- D.
  set (r := distance x y s) in *. rewrite is_x, is_y in S |- *.
  set (c := cos (angle s)) in *. set (d := sin (angle s)) in *. clearbody c d r.
  assert (E : v s * c - u s * d = w * r) by (replace (w * r) with (w * (r * d * d + r * c * c)) by ring
      [circle]; lra).
  replace (r * c * v s - r * d * u s) with (r * (v s * c - u s * d)) by ring. rewrite E. ring.
Qed.

Variables c0 c1 : R.
Hypothesis is_c0 : c0 = - mu * along_y mu r0 rd th0 w0 / h ^ 2.
Hypothesis is_c1 : c1 = - mu * along_x mu r0 rd th0 w0 / h ^ 2.

Lemma slowness : forall s, c0 * sin (angle s) + c1 * cos (angle s) - (mu / h) ^ 2 <> 0 /\
  - mu / (c0 * sin (angle s) + c1 * cos (angle s) - (mu / h) ^ 2) = distance x y s /\
  distance x y s ^ 2 = square s.
Proof.
  intro s. destruct (there s) as [on _]. destruct (path s) as [off _].
  destruct (on_orbit _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ on) as [P [is_r _]].
  assert (D : distance x y s * distance x y s = square s) by (apply sqrt_sqrt; lra).
  assert (R : distance x y s > 0) by (apply sqrt_lt_R0; lra).
  pose proof never_stops as N.
  assert (E : c0 * sin (angle s) + c1 * cos (angle s) - (mu / h) ^ 2 = - mu / distance x y s).
  { rewrite is_c0, is_c1, is_r. unfold pull_over_V in *. field. repeat split; lra. }
  rewrite E, <- D. split; [| split; [field; split | ring]; lra].
  apply Rlt_not_eq. unfold Rdiv. rewrite Ropp_mult_distr_l_reverse. apply Ropp_lt_gt_0_contravar. now apply
      Rdiv_lt_0_compat.
Qed.
Lemma time_is : forall t,
  RInt (fun p => (- mu / (c0 * sin p + c1 * cos p - (mu / h) ^ 2)) ^ 2 / h) (angle 0) (angle t) = t.
Proof.
  intro t. pose proof never_stops as N.
  set (f := fun p => (- mu / (c0 * sin p + c1 * cos p - (mu / h) ^ 2)) ^ 2 / h).
  assert (I : is_RInt (fun s => scal (h / square s) (f (angle s))) 0 t (RInt f (angle 0) (angle t))).
  { apply (is_RInt_comp f angle (fun s => h / square s) 0 t); intros s _.
    - apply @ex_derive_continuous. unfold f. auto_derive. destruct (slowness s). repeat split; trivial.
    - split; [apply angle_rate |]. destruct (path s) as [off [dx [dy _]]].
      apply @ex_derive_continuous. auto_derive. repeat split; try lra; eexists; eassumption. }
  apply (is_RInt_ext _ (fun _ => 1)) in I.
  2:{ intros s _. unfold f. destruct (slowness s) as [_ [S D]]. rewrite S, D. destruct (path s) as [off _].
      change (h / square s * (square s / h) = 1). field. repeat split; (first [assumption | lra]). }
  pose proof (is_RInt_unique (fun _ => 1) 0 t _ I) as at_all. pose proof (is_RInt_unique (fun _ => 1) 0 t _
      (is_RInt_const 0 t 1)) as K.
  fold f. rewrite <- at_all, K. change ((t - 0) * 1 = t). ring.
Qed.
End Time.
Ltac by_time :=
  lazymatch goal with
  | path : newton (?G * ?M) ?x ?y ?u ?v, G0 : ?G > 0, M0 : ?M > 0, far : ?r0 > 0, turns : ?w0 <> 0,
    x0 : ?x 0 = ?r0 * cos ?th0, y0 : ?y 0 = _, u0 : ?u 0 = _, v0 : ?v 0 = ?rd * sin ?th0 + ?r0 * ?w0 * cos
        ?th0,
    apart : sin (?th1 - ?th2) <> 0, on1 : at_angle ?x ?y ?t1 ?th1, on2 : at_angle ?x ?y ?t2 ?th2,
    fit1 : _ = ?c0 * sin ?th1 + ?c1 * cos ?th1, fit2 : _ = ?c0 * sin ?th2 + ?c1 * cos ?th2,
    first : ?angle 0 = ?th0, there : forall s, _ /\ _ |- _ =>
    assert (pulled : G * M > 0) by (apply Rmult_lt_0_compat; lra);
    destruct (constants _ _ _ _ _ _ _ _ _ far turns path x0 y0 u0 v0 _ _ _ _ _ _ on1 on2 apart fit1 fit2)
      as [is_c0 is_c1];
    lazymatch goal with
    | |- RInt _ _ _ = _ =>
      rewrite <- first; exact (time_is _ _ _ _ _ _ _ _ _ _ pulled far turns path x0 y0 u0 v0 there _ _ is_c0
          is_c1 _)
    | |- _ = sqrt (?x ?t * _ + _) =>
      destruct (slowness _ _ _ _ _ _ _ _ _ _ pulled far turns path x0 y0 u0 v0 there _ _ is_c0 is_c1 t) as [_
          [is_r _]];
      exact is_r
    end
  end.
