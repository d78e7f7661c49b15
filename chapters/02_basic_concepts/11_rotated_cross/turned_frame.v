(* Vectors are p u + q v + s w; S and C are sine and cosine of half the angle. Products and rotations of such vectors have this form again. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Hierarchy Derive RInt.
From Interval Require Import Tactic.
Local Open Scope R_scope.
Load "../shared/orthonormal.v".

Ltac product ui vi wi uj vj wj uk vk wk S C x y z :=
  match goal with
  | |- context [S * wj * (?p * uk + ?q * vk + ?s * wk) - S * wk * (?p * uj + ?q * vj + ?s * wj)] =>
    replace (S * wj * (p * uk + q * vk + s * wk) - S * wk * (p * uj + q * vj + s * wj))
      with (S * (p * vi - q * ui)) by ring [x y z]
  | |- context [S * wj * (2 * (S * (?p * vk - ?q * uk))) - S * wk * (2 * (S * (?p * vj - ?q * uj)))] =>
    replace (S * wj * (2 * (S * (p * vk - q * uk))) - S * wk * (2 * (S * (p * vj - q * uj))))
      with (- (2 * (S * S)) * (p * ui + q * vi)) by ring [x y z]
  | |- context [?p * ui + ?q * vi + ?s * wi + C * (2 * (S * (?p * vi - ?q * ui))) + - (2 * (S * S)) * (?p * ui + ?q * vi)] =>
    replace (p * ui + q * vi + s * wi + C * (2 * (S * (p * vi - q * ui))) + - (2 * (S * S)) * (p * ui + q * vi))
      with ((p * (1 - 2 * (S * S)) - q * (2 * (C * S))) * ui +
            (p * (2 * (C * S)) + q * (1 - 2 * (S * S))) * vi + s * wi) by ring
  | |- context [(?p * uj + ?q * vj + ?s * wj) * (?p1 * uk + ?q1 * vk + ?s1 * wk) - (?p * uk + ?q * vk + ?s * wk) * (?p1 * uj + ?q1 * vj + ?s1 * wj)] =>
    replace ((p * uj + q * vj + s * wj) * (p1 * uk + q1 * vk + s1 * wk) - (p * uk + q * vk + s * wk) * (p1 * uj + q1 * vj + s1 * wj))
      with ((q * s1 - s * q1) * ui + (s * p1 - p * s1) * vi + (p * q1 - q * p1) * wi) by ring [x y z]
  | |- context [S * wj * uk - S * wk * uj] =>
    replace (S * wj * uk - S * wk * uj)
      with (S * vi) by ring [x y z]
  | |- context [S * wj * vk - S * wk * vj] =>
    replace (S * wj * vk - S * wk * vj)
      with (- (S * ui)) by ring [x y z]
  | |- context [S * wj * wk - S * wk * wj] =>
    replace (S * wj * wk - S * wk * wj)
      with (0) by ring
  | |- context [S * wj * (2 * (S * vk)) - S * wk * (2 * (S * vj))] =>
    replace (S * wj * (2 * (S * vk)) - S * wk * (2 * (S * vj)))
      with (- (2 * (S * S)) * ui) by ring [x y z]
  | |- context [S * wj * (2 * - (S * uk)) - S * wk * (2 * - (S * uj))] =>
    replace (S * wj * (2 * - (S * uk)) - S * wk * (2 * - (S * uj)))
      with (- (2 * (S * S)) * vi) by ring [x y z]
  end.

Ltac dot u0 u1 u2 v0 v1 v2 w0 w1 w2 uu vv ww uv uw vw :=
  match goal with
  | |- context [u0 * (?p * u0 + ?q * v0 + ?s * w0) + u1 * (?p * u1 + ?q * v1 + ?s * w1) +
                  u2 * (?p * u2 + ?q * v2 + ?s * w2)] =>
    replace (u0 * (p * u0 + q * v0 + s * w0) + u1 * (p * u1 + q * v1 + s * w1) +
                  u2 * (p * u2 + q * v2 + s * w2))
      with (p) by
        (transitivity (p * (u0 * u0 + u1 * u1 + u2 * u2) + q * (u0 * v0 + u1 * v1 + u2 * v2) + s * (u0 * w0 + u1 * w1 + u2 * w2));
         [rewrite uu, uv, uw; ring | ring])
  | |- context [v0 * (?p * u0 + ?q * v0 + ?s * w0) + v1 * (?p * u1 + ?q * v1 + ?s * w1) +
                  v2 * (?p * u2 + ?q * v2 + ?s * w2)] =>
    replace (v0 * (p * u0 + q * v0 + s * w0) + v1 * (p * u1 + q * v1 + s * w1) +
                  v2 * (p * u2 + q * v2 + s * w2))
      with (q) by
        (transitivity (p * (u0 * v0 + u1 * v1 + u2 * v2) + q * (v0 * v0 + v1 * v1 + v2 * v2) + s * (v0 * w0 + v1 * w1 + v2 * w2));
         [rewrite uv, vv, vw; ring | ring])
  | |- context [w0 * (?p * u0 + ?q * v0 + ?s * w0) + w1 * (?p * u1 + ?q * v1 + ?s * w1) +
                  w2 * (?p * u2 + ?q * v2 + ?s * w2)] =>
    replace (w0 * (p * u0 + q * v0 + s * w0) + w1 * (p * u1 + q * v1 + s * w1) +
                  w2 * (p * u2 + q * v2 + s * w2))
      with (s) by
        (transitivity (p * (u0 * w0 + u1 * w1 + u2 * w2) + q * (v0 * w0 + v1 * w1 + v2 * w2) + s * (w0 * w0 + w1 * w1 + w2 * w2));
         [rewrite uw, vw, ww; ring | ring])
  | |- context [(?p * u0 + ?q * v0 + ?s * w0) * (?p1 * u0 + ?q1 * v0 + ?s1 * w0) +
                  (?p * u1 + ?q * v1 + ?s * w1) * (?p1 * u1 + ?q1 * v1 + ?s1 * w1) +
                  (?p * u2 + ?q * v2 + ?s * w2) * (?p1 * u2 + ?q1 * v2 + ?s1 * w2)] =>
    replace ((p * u0 + q * v0 + s * w0) * (p1 * u0 + q1 * v0 + s1 * w0) +
                  (p * u1 + q * v1 + s * w1) * (p1 * u1 + q1 * v1 + s1 * w1) +
                  (p * u2 + q * v2 + s * w2) * (p1 * u2 + q1 * v2 + s1 * w2))
      with (p * p1 + q * q1 + s * s1) by
        (transitivity (p * p1 * (u0 * u0 + u1 * u1 + u2 * u2) + q * q1 * (v0 * v0 + v1 * v1 + v2 * v2) +
          s * s1 * (w0 * w0 + w1 * w1 + w2 * w2) + (p * q1 + q * p1) * (u0 * v0 + u1 * v1 + u2 * v2) +
          (p * s1 + s * p1) * (u0 * w0 + u1 * w1 + u2 * w2) + (q * s1 + s * q1) * (v0 * w0 + v1 * w1 + v2 * w2));
         [rewrite uu, vv, ww, uv, uw, vw; ring | ring])
  end.
