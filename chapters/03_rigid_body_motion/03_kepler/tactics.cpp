#include "chapters/03_rigid_body_motion/03_kepler/kepler.hpp"

namespace oddity::kepler {

/// Replaces the distance by a letter and the angle's cosine and sine by quotients, and the rate on a circle
/// by another.
const char* const by_distance = R"(
  rename H1 into off_center;
  rewrite ?(cos_atan2 y x off_center), ?(sin_atan2 y x off_center);
  pose proof (sqrt_lt_R0 _ off_center) as far;
  assert (root : sqrt (x * x + y * y) * sqrt (x * x + y * y) = x * x + y * y) by (apply sqrt_sqrt; lra);
  remember (sqrt (x * x + y * y)) as r eqn:is_r;
  replace (r * (x / r)) with x by (field; lra); replace (r * (y / r)) with y by (field; lra);
  rewrite <- ?is_r; clear is_r;
  assert (up : y * y = r * r - x * x) by lra;
  assert (pull : G * M > 0 /\ r * r * r > 0) by (split; repeat apply Rmult_lt_0_compat; lra);
  try (match goal with |- context [sqrt ?q] =>
    assert (turns : q > 0) by (first [apply Rdiv_lt_0_compat | apply Rmult_lt_0_compat]; lra);
    pose proof (sqrt_lt_R0 _ turns); pose proof (sqrt_sqrt _ (Rlt_le _ _ turns)) as square;
    set (w := sqrt q) in *; clearbody w;
    first [replace G with (w * w * (r * r * r) / M) by (rewrite square; field; lra)
          | replace G with (w * w / (M * r)) by (rewrite square; field; lra)] end);
  field [up]; repeat split; nra)";

const char* const by_factors = R"([ nra
  | intuition; assert (E : (b - 1) * (b + 1) = 0) by nra; destruct (Rmult_integral _ _ E); lra
  | intuition; subst; lra | intuition; subst; lra ])";

const char* const by_circle = R"(
  match goal with |- context [sqrt ?x] => replace x with 0 by (rewrite H2, H3; ring) end; rewrite sqrt_0;
  try reflexivity;
  match goal with |- context [Rabs ?w] =>
    assert (k : Rabs w * Rabs w = w * w) by (rewrite <- Rabs_mult; apply Rabs_right, Rle_ge, Rle_0_sqr) end;
  replace (r0 * r0 * Rabs w0 * (r0 * r0 * Rabs w0)) with (r0 * (r0 * r0 * r0 * w0 * w0)) by ring [k];
  rewrite H3; field; repeat split; lra)";

const char* const by_bounds = "rewrite ?cos_atan2, ?sin_atan2 by interval; interval";

}  // namespace oddity::kepler
