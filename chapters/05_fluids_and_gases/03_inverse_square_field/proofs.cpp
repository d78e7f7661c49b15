// Proofs of the field's slopes anywhere but at the origin, its divergence along any frame, and its flux
// through spheres.
#include "chapters/05_fluids_and_gases/03_inverse_square_field/inverse_square_field.hpp"
#include "chapters/05_fluids_and_gases/shared/smooth_fields.hpp"
#include "chapters/integral_proofs.hpp"
#include "chapters/provable.hpp"

namespace oddity::ex05_03 {

namespace {

using namespace fields;
using Letters = Triple<Shortened>;

constexpr const char* slopes_in_coq = R"(
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
)";

constexpr const char* flux_in_coq = R"(
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
)";

Shortened letter(const char* name) { return Shortened::letter(name); }
Shortened derivative_in_coq(const Shortened& f, const Shortened& at) {
  return Shortened::letter("(Derive (fun t => " + f.expression().coq() + ") (" + at.expression().coq() +
                           "))");
}

/// The derivative of component i by x_j.
Shortened slope(const Letters& x, std::size_t i, std::size_t j) {
  Letters varied = x;
  varied[j] = letter("t");
  return derivative_in_coq(inverse_square(varied)[i], x[j]);
}
Expressions own_slopes(const Letters& x) {
  Expressions all;
  for (std::size_t i = 0; i < 3; ++i) all.push_back(slope(x, i, i).expression());
  return all;
}

/// The sum over the frame r of each vector's dot product with the derivative along it.
Expression divergence_in_frame(const Letters& x) {
  Shortened sum;
  for (const Letters& u : {numbers("r 0%nat"), numbers("r 1%nat"), numbers("r 2%nat")}) {
    const Shortened t = letter("t");
    const Letters along = inverse_square(Letters{x[0] + t * u[0], x[1] + t * u[1], x[2] + t * u[2]});
    sum += dot(u, Letters{derivative_in_coq(along[0], 0.0), derivative_in_coq(along[1], 0.0),
                          derivative_in_coq(along[2], 0.0)});
  }
  return sum.expression();
}

/// The flux through the sphere of this radius around the origin, integrated over both angles.
Expression flux(const Shortened& radius) {
  const Shortened theta = letter("theta"), phi = letter("phi");
  const Letters n{sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)};
  const Shortened density = radius * radius * sin(theta) *
                            dot(inverse_square(Letters{radius * n[0], radius * n[1], radius * n[2]}), n);
  const Expression circle =
      integral([&](const Expression&) { return density.expression(); }, 0, pi_in_coq(), "theta");
  return integral([&](const Expression&) { return circle; }, 0, 2 * pi_in_coq(), "phi");
}

}  // namespace

Provables proofs() {
  const Letters x{letter("x0"), letter("x1"), letter("x2")};
  const Shortened s = dot(x, x);
  const std::string coordinates = "(x0 x1 x2 : R)", of_frame = "(r : nat -> nat -> R) (x0 x1 x2 : R)";
  const Proposition away = above(s.expression(), 0), right_handed{"frame r"};
  const std::string preamble =
      "From Coq Require Import Lia Nsatz.\nFrom Coquelicot Require Import Continuity AutoDerive.\n"
      "Local Open Scope R_scope.\n\n" +
      frames_in_coq() + slopes_in_coq;
  const auto all = [](const Letters& v) {
    return Expressions{v[0].expression(), v[1].expression(), v[2].expression()};
  };
  const auto each_by = [&](Shortened (*of)(Shortened, Shortened)) {
    return all({of(s, x[0]), of(s, x[1]), of(s, x[2])});
  };
  Provables proved;
  const auto add = [&](const std::string& slug, const std::string& says, const std::vector<Lemma>& lemmas) {
    proved.push_back({"5.3-" + slug, says, lemmas, 0, preamble});
  };
  const auto slopes = [&](const std::string& slug, const Expressions& printed) {
    add(slug, "they are the derivatives at every point but the origin",
        {{"printed", coordinates, {away}, equal(printed, own_slopes(x)), "symmetry; at_distance H"}});
  };
  slopes("quotient_rule", each_by(quotient));
  slopes("simplified", each_by(simplified));
  slopes("common_denominator", all(brackets(x)));

  const Expressions own = own_slopes(x);
  const Letters example{0.3, -0.7, 0.9};
  add("divergence",
      "as meant it is the divergence along any frame at every point but the origin; as printed it is off at an "
      "example",
      {{"meant",
        of_frame,
        {right_handed, away},
        {divergence_in_frame(x) == own[0] + own[1] + own[2]},
        "transitivity 0; [divergence_is_zero r x0 x1 x2 H H0 |];\n"
        "  rewrite slope_0, slope_1, slope_2 by exact H0; field; apply Rgt_not_eq, sqrt_lt_R0, H0"},
       {"printed_differs",
        "",
        {},
        {apart(slope(example, 1, 0).expression(), slope(example, 0, 0).expression(), 0.2)},
        "rewrite ?slope_beside, ?slope_0 by lra; interval"}});
  proved.back().margin = 0.2;

  add("numerator", "it holds for all coordinates",
      {{"printed", coordinates, {}, {sum_of_brackets(x, Shortened(3.0)).expression() == 0}, "ring"}});
  const Lemma zero{"printed",
                   of_frame,
                   {right_handed, away},
                   {divergence_in_frame(x) == 0},
                   "divergence_is_zero r x0 x1 x2 H H0"};
  add("zero", "it holds along any frame at every point but the origin", {zero});

  const std::string by_angles = "flux_is a theta phi H";
  const Lemma around{"corrected_flux",
                     "(a : R)",
                     {above(letter("a").expression(), 0)},
                     {flux(letter("a")) == 4 * pi_in_coq()},
                     by_angles};
  Lemma away_from_it = zero;
  away_from_it.name = "corrected_away";
  add("origin",
      "as corrected the divergence is zero but at the origin, and the flux through every sphere around it is "
      "four pi; as printed it is off",
      {away_from_it,
       around,
       {"printed_differs",
        "(a : R)",
        {above(letter("a").expression(), 0)},
        {apart(0, flux(letter("a")), 12.5)},
        "match goal with |- context [RInt ?f ?low ?high] => let is := fresh in\n"
        "    assert (is : RInt f low high = 4 * PI) by (" +
            by_angles + "); rewrite is end; interval"}});
  proved.back().margin = 12.5;
  proved.back().preamble += std::string(integrals_in_coq) + flux_in_coq;
  return proved;
}

}  // namespace oddity::ex05_03

namespace oddity {

Provables proofs_5_3() { return ex05_03::proofs(); }

}  // namespace oddity
