(* Moments of a wire about any point. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../../integrals.v".

From Coquelicot Require Import RInt_analysis Continuity AutoDerive.
Local Open Scope R_scope.

(* by the mass and the moment mu2, the center of mass being at zero *)
Lemma moments : forall (b0 b1 delta : R -> R) L,
  (forall s, continuous b0 s) -> (forall s, continuous b1 s) -> (forall s, continuous delta s) ->
  RInt (fun s => b0 s * delta s) 0 L = 0 -> RInt (fun s => b1 s * delta s) 0 L = 0 ->
  forall a0 a1 a2 a3 f, (forall s, f s = a0 + a1 * b0 s + a2 * b1 s + a3 * (b0 s * b0 s + b1 s * b1 s)) ->
  RInt (fun s => f s * delta s) 0 L
  = a0 * RInt (fun s => 1 * delta s) 0 L + a3 * RInt (fun s => (b0 s * b0 s + b1 s * b1 s) * delta s) 0 L.
Proof.
  intros b0 b1 delta L c0 c1 cd z0 z1 a0 a1 a2 a3 f e.
  assert (i : forall g : R -> R, (forall s, continuous g s) ->
    is_RInt (fun s => g s * delta s) 0 L (RInt (fun s => g s * delta s) 0 L)).
  { intros g cg.
    apply (RInt_correct (V := R_CompleteNormedModule)), (ex_RInt_continuous (V := R_CompleteNormedModule)). intros s _. now apply (continuous_mult g delta). }
  assert (i1 := i (fun _ => 1) (fun s => continuous_const 1 s)).
  assert (ib := i b0 c0). assert (ic := i b1 c1).
  assert (i2 := i (fun s => b0 s * b0 s + b1 s * b1 s) (fun s => continuous_plus _ _ s
    (continuous_mult b0 b0 s (c0 s) (c0 s)) (continuous_mult b1 b1 s (c1 s) (c1 s)))).
  rewrite z0 in ib. rewrite z1 in ic. apply is_RInt_unique.
  replace (a0 * RInt (fun s => 1 * delta s) 0 L
      + a3 * RInt (fun s => (b0 s * b0 s + b1 s * b1 s) * delta s) 0 L)
    with (plus (plus (scal a0 (RInt (fun s => 1 * delta s) 0 L)) (scal a1 0)) (plus (scal a2 0)
      (scal a3 (RInt (fun s => (b0 s * b0 s + b1 s * b1 s) * delta s) 0 L))))
    by (unfold plus, scal; simpl; unfold mult; simpl; ring).
  eapply is_RInt_ext; [| exact (is_RInt_plus _ _ _ _ _ _
    (is_RInt_plus _ _ _ _ _ _ (is_RInt_scal _ _ _ a0 _ i1) (is_RInt_scal _ _ _ a1 _ ib))
    (is_RInt_plus _ _ _ _ _ _ (is_RInt_scal _ _ _ a2 _ ic) (is_RInt_scal _ _ _ a3 _ i2)))].
  intros s _. rewrite e. unfold plus, scal; simpl; unfold mult; simpl. ring.
Qed.
Lemma circle : forall t, sin t * sin t = 1 - cos t * cos t.
Proof. intro t. assert (e := sin2_cos2 t). unfold Rsqr in e. lra. Qed.
Ltac in_reals := match goal with |- ?x = ?y => change (@eq R x y) end.

(* The energy's integral i as a sum of moments; the rest vanishes. *)
Ltac by_moments b0 b1 delta L c0 c1 cd z0 z1 theta vx vy w :=
  match goal with |- _ = _ * ?i =>
    let e := fresh in
    assert (e : i = (vx * vx + vy * vy) * RInt (fun s => 1 * delta s) 0 L
        + w * w * RInt (fun s => (b0 s * b0 s + b1 s * b1 s) * delta s) 0 L)
      by (refine (moments b0 b1 delta L c0 c1 cd z0 z1 _ (2 * w * (vy * cos theta - vx * sin theta))
            (- 2 * w * (vx * cos theta + vy * sin theta)) _ (fun s => _) _); intro; ring [(circle theta)]);
    rewrite e; clear e
  end.
Ltac by_rod b0 b1 delta L theta vx vy w :=
  let m0 := fresh "m0" in let m2 := fresh "m2" in let l := fresh "l" in
  let square := fresh "square" in let above := fresh "above" in let of_rod := fresh "of_rod" in
  set (m0 := RInt (fun s => 1 * delta s) 0 L) in *;
  set (m2 := RInt (fun s => (b0 s * b0 s + b1 s * b1 s) * delta s) 0 L) in *;
  assert (0 < 12 * m2 / m0) by (apply Rdiv_lt_0_compat; lra);
  assert (square := sqrt_sqrt (12 * m2 / m0) ltac:(lra)); assert (above := sqrt_lt_R0 (12 * m2 / m0) ltac:(lra));
  set (l := sqrt (12 * m2 / m0)) in *;
  assert (of_rod : m0 * (l * l) / 12 = m2) by (rewrite square; field; lra);
  clearbody l; clearbody m2; clearbody m0; clear square; subst m2;
  rewrite (RInt_by (fun t => m0 / l * ((vx * vx + vy * vy) * t + (vy * cos theta - vx * sin theta) * w * (t * t)
    + w * w * (t * t * t) / 3) / 2));
    [in_reals; field; lra
    | intro; auto_derive; [repeat split; trivial; lra | field [(circle theta)]; lra]
    | intro; apply @ex_derive_continuous; auto_derive; repeat split; trivial; lra].
(* The integral of the potential's slopes exists. *)
Ltac by_slope b0 b1 theta x y integrable :=
  match goal with |- _ = - ?i => change (- i) with (opp i) end;
  rewrite <- (RInt_opp _ _ _ integrable); apply RInt_ext;
  let t := fresh in intros t _; match goal with |- ?a = opp ?b => change (@eq R a (- b)) end;
  replace (x + (cos theta * b0 t - sin theta * b1 t)) with (x + cos theta * b0 t - sin theta * b1 t) by ring;
  replace (y + (cos theta * b1 t + sin theta * b0 t)) with (y + sin theta * b0 t + cos theta * b1 t) by ring;
  ring.
(* The moment of a weight. *)
Ltac no_moment b0 b1 delta L c0 c1 cd z0 z1 theta :=
  match goal with |- _ * ?i = 0 =>
    let e := fresh in
    assert (e : i = 0 * RInt (fun s => 1 * delta s) 0 L
        + 0 * RInt (fun s => (b0 s * b0 s + b1 s * b1 s) * delta s) 0 L)
      by (refine (moments b0 b1 delta L c0 c1 cd z0 z1 _ (cos theta) (- sin theta) _ (fun s => _) _); intro; ring);
    rewrite e; ring
  end.
