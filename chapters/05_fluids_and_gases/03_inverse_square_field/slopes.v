(* Derivatives of x / |x|^3. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/frames.v".

From Coquelicot Require Import Continuity AutoDerive.

(* of x / |x|^3 *)
Ltac at_distance p := let q := fresh "q" in pose proof (sqrt_lt_R0 _ p) as q;
  let square := fresh "square" in pose proof (sqrt_sqrt _ (Rlt_le _ _ p)) as square;
  apply is_derive_unique; auto_derive; rewrite ?Rmult_0_l, ?Rplus_0_r;
  [repeat split; try exact p; apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; exact q |];
  match type of q with 0 < ?s => set (r := s) in *; clearbody r end;
  rewrite <- ?square; field; apply Rgt_not_eq, q.
Lemma slope_along x y z a b c u e : x * x + y * y + z * z > 0 ->
  Derive (fun t => (u + t * e)
    / (sqrt ((x + t * a) * (x + t * a) + (y + t * b) * (y + t * b) + (z + t * c) * (z + t * c))
     * sqrt ((x + t * a) * (x + t * a) + (y + t * b) * (y + t * b) + (z + t * c) * (z + t * c))
     * sqrt ((x + t * a) * (x + t * a) + (y + t * b) * (y + t * b) + (z + t * c) * (z + t * c)))) 0
  = ((x * x + y * y + z * z) * e - 3 * u * (x * a + y * b + z * c)) / sqrt (x * x + y * y + z * z) ^ 5.
Proof. intros p. at_distance p. Qed.
Lemma slope_0 x y z : x * x + y * y + z * z > 0 ->
  Derive (fun t => t / (sqrt (t * t + y * y + z * z) * sqrt (t * t + y * y + z * z)
    * sqrt (t * t + y * y + z * z))) x
  = ((x * x + y * y + z * z) - 3 * x * x) / sqrt (x * x + y * y + z * z) ^ 5.
Proof. intros p. at_distance p. Qed.
Lemma slope_1 x y z : x * x + y * y + z * z > 0 ->
  Derive (fun t => t / (sqrt (x * x + t * t + z * z) * sqrt (x * x + t * t + z * z)
    * sqrt (x * x + t * t + z * z))) y
  = ((x * x + y * y + z * z) - 3 * y * y) / sqrt (x * x + y * y + z * z) ^ 5.
Proof. intros p. at_distance p. Qed.
Lemma slope_2 x y z : x * x + y * y + z * z > 0 ->
  Derive (fun t => t / (sqrt (x * x + y * y + t * t) * sqrt (x * x + y * y + t * t)
    * sqrt (x * x + y * y + t * t))) z
  = ((x * x + y * y + z * z) - 3 * z * z) / sqrt (x * x + y * y + z * z) ^ 5.
Proof. intros p. at_distance p. Qed.
(* the component that is u there *)
Lemma slope_beside x y z u : x * x + y * y + z * z > 0 ->
  Derive (fun t => u / (sqrt (t * t + y * y + z * z) * sqrt (t * t + y * y + z * z)
    * sqrt (t * t + y * y + z * z))) x
  = - 3 * u * x / sqrt (x * x + y * y + z * z) ^ 5.
Proof. intros p. at_distance p. Qed.

Ltac divergence_is_zero r x0 x1 x2 H p :=
  rewrite !slope_along by exact p;
  let e := fresh "e" in
  pose proof (fun i l => in_frame r i (fun j => match j with O => x0 | 1%nat => x1 | _ => x2 end) H l) as e;
  let e0 := fresh "e0" in pose proof (e 0%nat ltac:(lia)) as e0;
  let e1 := fresh "e1" in pose proof (e 1%nat ltac:(lia)) as e1;
  let e2 := fresh "e2" in pose proof (e 2%nat ltac:(lia)) as e2; clear e;
  let c := fresh "c" in destruct (orthonormal_frame r H) as [c _];
  let c0 := fresh "c0" in pose proof (c 0 0 ltac:(lia) ltac:(lia))%nat as c0;
  let c1 := fresh "c1" in pose proof (c 1 1 ltac:(lia) ltac:(lia))%nat as c1;
  let c2 := fresh "c2" in pose proof (c 2 2 ltac:(lia) ltac:(lia))%nat as c2; clear c;
  unfold dot, sum in e0, e1, e2, c0, c1, c2; simpl in e0, e1, e2, c0, c1, c2;
  let q := fresh "q" in pose proof (sqrt_lt_R0 _ p) as q;
  let d := fresh "distance" in match type of q with 0 < ?s => set (d := s) in *; clearbody d end;
  match type of e0 with ?e0 = _ => match type of e1 with ?e1 = _ => match type of e2 with ?e2 = _ =>
  match type of c0 with ?c0 = _ => match type of c1 with ?c1 = _ => match type of c2 with ?c2 = _ =>
    transitivity (((x0 * x0 + x1 * x1 + x2 * x2) * (c0 + c1 + c2) - 3 * (x0 * e0 + x1 * e1 + x2 * e2)) / d ^ 5)
  end end end end end end; [field; apply Rgt_not_eq, q|];
  rewrite e0, e1, e2, c0, c1, c2; field; apply Rgt_not_eq, q.
