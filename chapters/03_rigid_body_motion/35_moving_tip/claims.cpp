// The claims of exercise 3.35, checked on tops made of point masses, whose Lagrangian with a moving tip is
// differentiated by nested dual numbers.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "chapters/02_basic_concepts/shared/vectors.hpp"
#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/moving_tip.hpp"
#include "chapters/03_rigid_body_motion/shared/top_of_points.hpp"
#include "chapters/provable_claims.hpp"
#include "chapters/scene.hpp"

namespace oddity::ex03_35 {

using namespace top;
using basic_vectors::operator+, basic_vectors::operator-, basic_vectors::operator*;
using heavy_top::EulerAngles, heavy_top::RigidBody;
using std::cos, std::sin;

namespace {

// ---- the points' motion along Lagrange's accelerations ----------------------------------------------------

template <class T>
struct Moving {
  Vector<T> x, a;
};

/// Position and acceleration of a body point.
template <class T>
Moving<T> motion_of(const SampleOf<T>& s, const Vector<T>& body_point) {
  using D = Dual<Dual<T>>;
  const auto angle = [&](std::size_t i) { return D(Dual<T>(s.q[i], s.v[i]), Dual<T>(s.v[i], s.truth[i])); };
  const auto r = rotation(angle(0), angle(1), angle(2));
  const auto x = s.body.position(PointOf<T>{T(1), body_point}, r, D(Dual<T>(s.t, T(1)), Dual<T>(T(1))));
  return {{x[0].value.value, x[1].value.value, x[2].value.value},
          {x[0].slope.slope, x[1].slope.slope, x[2].slope.slope}};
}

/// The rate of the angular momentum about, and relative to, a point on the axis at this height.
template <class T>
Vector<T> momentum_rate(const SampleOf<T>& s, const T& height) {
  const Moving<T> center = motion_of<T>(s, {T(0), T(0), height});
  return s.body.template sum<Vector<T>>([&](Vector<T>& sum, const PointOf<T>& p) {
    const Moving<T> point = motion_of(s, p.x);
    sum = sum + p.m * cross(point.x - center.x, point.a - center.a);
  });
}

template <class T>
Vector<T> tip(const SampleOf<T>& s) {
  return {s.body.A * sin(s.body.lambda * s.t), T(0), T(0)};
}

/// The torque about the center of mass of the force on the tip. This force is mass times the acceleration of
/// the center of mass, minus the weight.
template <class T>
Vector<T> torque_of_tip(const SampleOf<T>& s) {
  Moving<T> c = motion_of<T>(s, {T(0), T(0), s.l});
  c.a[2] += s.body.g;
  return cross(tip(s) - c.x, s.m * c.a);
}

/// The last three rates of a model's state at its initial condition: (theta'', phi'', psi'') from the
/// equations of the angles, (w1', w2', w3') from Euler's equations.
template <template <class> class Model, class T>
Vector<T> rates_of(const heavy_top::Top<T>& top, const T& t) {
  const Model<T> model{top};
  typename Model<T>::State rates;
  model(model.start(), rates, t);
  Vector<T> last;
  std::copy(rates.end() - 3, rates.end(), last.begin());
  return last;
}

/// (w1', w2', w3') along Lagrange's accelerations.
template <class T>
Vector<T> body_rates_change(const SampleOf<T>& s) {
  const auto q = moving(s.q, s.v), v = moving(s.v, s.truth);
  return {(v[1] * cos(q[2]) + v[0] * sin(q[1]) * sin(q[2])).slope,
          (v[0] * sin(q[1]) * cos(q[2]) - v[1] * sin(q[2])).slope, (v[2] + v[0] * cos(q[1])).slope};
}

/// Top with the same angles and rates, and its tip at rest.
template <class T>
SampleOf<T> with_fixed_tip(SampleOf<T> s) {
  s.body.A = T(0);
  s.truth = rates_of<EulerAngles>(s.top(), s.t);
  return s;
}

/// With the letters of this exercise, where the shared ones have 3.33's alpha.
struct Driven : Sample {
  TypesetLetters typeset() const {
    return {{"m", m},
            {R"(\ell)", l},
            {R"(\alpha)", body.A},
            {R"(\lambda)", body.lambda},
            {"t", t},
            {R"(\theta)", q[0]},
            {R"(\phi)", q[1]},
            {R"(\ddot\psi)", truth[2]},
            {R"(\mathbf p)", tip(*this)},
            {R"(\boldsymbol\xi_3)", top().axis()}};
  }
};

using Reader = ProvableFormula<SampleOf>;

const Reader zero{"zero", []<class T>(const SampleOf<T>&) { return T(0); }},
    none{"no torque", []<class T>(const SampleOf<T>&) { return Vector<T>{}; }};

const std::string rate_of_momentum =
    R"($\sum m(\mathbf x-\mathbf r)\times(\ddot{\mathbf x}-\ddot{\mathbf r})$ over the points)";
const Reader added{
    rate_of_momentum + ", less that of the same top with its tip fixed",
    [](const auto&s) { return momentum_rate(s, s.l) - momentum_rate(with_fixed_tip(s), s.l); }},
    unexplained{rate_of_momentum + ", less the torque",
                [](const auto&s) { return momentum_rate(s, s.l) - torque_of_tip(s); }};

const Reader change{R"($\dot{\mathbf w}$ along Lagrange's accelerations, tip moving)",
                    [](const auto&s) { return body_rates_change(s); }},
    spin_change{change.text, [](const auto&s) { return body_rates_change(s)[2]; }},
    vertical{"rate of the vertical angular momentum along Lagrange's accelerations, tip moving",
             [](const auto&s) {
               return rate_of(s, s.truth, [&](const auto& q, const auto& v) {
                 return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + s.mu3 * (v[2] + v[0] * cos(q[1])) * cos(q[1]);
               });
             }},
    drive{R"($m\ell\alpha\lambda^2\sin\lambda t\cos\theta\sin\phi$)",
          [](const auto&s) {
            const auto& b = s.body;
            return s.m * s.l * b.A * b.lambda * b.lambda * sin(b.lambda * s.t) * cos(s.q[0]) * sin(s.q[1]);
          }},
    euler{R"(Euler's equations with the torque of $-mg\mathbf k-m\ddot{\mathbf p}$)",
          [](const auto&s) { return rates_of<RigidBody>(s.top(), s.t); }};

const Reader lagrange{"nested dual numbers on the points' $T-V$, tip moving",
                      [](const auto&s) { return s.truth; }},
    angles_of_fixed{"equations of the angles, the tip fixed",
                    [](const auto&s) { return with_fixed_tip(s).truth; }},
    angles_of_moved{R"(equations of the angles with the torque of $-m\ddot{\mathbf p}$)",
                    [](const auto&s) { return rates_of<EulerAngles>(s.top(), s.t); }},
    torque_about_tip{R"($\ell\,\boldsymbol\xi_3\times(-mg\mathbf k-m\ddot{\mathbf p})$)",
                     [](const auto&s) {
                       const auto top = s.top();
                       return top.l * cross(top.axis(), top.force(s.t));
                     }},
    about_tip{R"($\sum m(\mathbf x-\mathbf p)\times(\ddot{\mathbf x}-\ddot{\mathbf p})$ over the points)",
              []<class T>(const SampleOf<T>&s) { return momentum_rate(s, T(0)); }};

const std::string no_torque = "no torque of the force on the tip";

// ---- proofs -----------------------------------------------------------------------------------------------

/// Euler's equations with the torque by the rotation matrix; the model uses a quaternion instead.
template <class T>
Vector<T> euler_by_matrix(const SampleOf<T>& s) {
  const auto r = rotation(s.q[0], s.q[1], s.q[2]);
  const auto w = s.top().body_rates(), F = s.top().force(s.t);
  Vector<T> f{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) f[i] += r[k][i] * F[k];
  return {((s.mu1 - s.mu3) * w[1] * w[2] - s.l * f[1]) / s.mu1,
          ((s.mu3 - s.mu1) * w[2] * w[0] + s.l * f[0]) / s.mu1, T(0)};
}

/// Lagrange's accelerations if all angles are at rest.
template <class T>
Vector<T> accelerations_from_rest(const SampleOf<T>& s) {
  const T S = sin(s.q[1]),
          push = s.m * s.l / s.mu1 * s.body.A * s.body.lambda * s.body.lambda * sin(s.body.lambda * s.t);
  const T turning = push * cos(s.q[0]) / S;
  return {turning, s.m * s.l / s.mu1 * s.body.g * S + push * sin(s.q[0]) * cos(s.q[1]),
          -turning * cos(s.q[1])};
}

const std::vector<std::string> all_angles{"theta", "phi", "psi", "lambda * t"};
/// Factors of Lagrange's equations of theta, phi and psi.
using Factors = std::array<std::string, 3>;
using OfVector = std::array<Factors, 3>;

/// For the rate of the angular momentum about the tip minus the torque.
const OfVector torques{{{"- sin theta * cos phi / sin phi", "cos theta", "sin theta / sin phi"},
                        {"cos theta * cos phi / sin phi", "sin theta", "- cos theta / sin phi"},
                        {"1", "", ""}}};
struct MovingTip {
  AnyTop all = any_top(true);
  const SampleOf<Shortened>& any = all.top;

  MovingTip() { all.given.push_back(above(sin(any.q[1].expression()), 0)); }
  /// A lemma for each component, as a sum of Lagrange's equations.
  std::vector<Lemma> follow(const std::string& name, const Reader& formula, const Reader& truth,
                            const OfVector& factors, const std::string& begin = {}) const {
    const Expressions left = formula.recorded(any), right = truth.recorded(any);
    std::vector<Lemma> lemmas;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const std::string number = left.size() == 1 ? "" : "_" + std::to_string(k + 1);
      Lemma lemma{name + number, all.letters, all.given, {left[k] == right.at(k)}};
      lemma.tactic = begin + by_equations(all_angles, assume_equations(lemma, any, factors[k]), 5);
      lemmas.push_back(std::move(lemma));
    }
    return lemmas;
  }
  /// Lemmas at the example, whose accelerations satisfy Lagrange's equations.
  std::vector<Lemma> off(const Reader& printed, const Reader& truth, double& margin) const {
    Sample numbers = four_points(3, 2, 3);
    numbers.t = 1, numbers.truth = accelerations_from_rest(numbers);
    SampleOf<Shortened> s = numbers.recorded();
    s.truth = accelerations_from_rest(s);
    Value difference = printed.of(numbers);
    const Value right = truth.of(numbers);
    for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= right[k];
    Lemma moves{.name = "example", .tactic = "at_example"};
    for (const Shortened& left : s.left_side(s.truth, true)) moves.follows.push_back(left.expression() == 0);
    return {moves, off_at(printed.recorded(s), truth.recorded(s), difference, margin)};
  }
  /// For a vector that contains the model's Euler equations: replaces them by those of euler_by_matrix().
  std::string by_matrix() const {
    const Expressions model = euler.recorded(any);
    std::string replaced;
    for (std::size_t k = 0; k < 2; ++k)
      replaced += "try replace (" + model[k].coq() + ") with (" +
                  Shortened(euler_by_matrix(any)[k]).expression().coq() +
                  ")\n    by (by_half_angles theta phi psi);\n  ";
    return replaced;
  }
};

Provable proved(const std::string& slug, const std::string& says,
                const std::vector<std::vector<Lemma>>& parts, double margin = 0) {
  Provable p{"3.35-" + slug, says, {}, margin, coq_source({"half_angles"})};
  for (const std::vector<Lemma>& part : parts) p.lemmas.insert(p.lemmas.end(), part.begin(), part.end());
  return p;
}

}  // namespace

Provables proofs() {
  const MovingTip tops;
  const std::string follows = "it follows from Lagrange's equations of any top of rings of points";
  const auto wrong = [&](const std::string& slug, const Reader& printed, const Reader& truth,
                         std::vector<std::vector<Lemma>> parts) {
    double margin = 0;
    parts.push_back(tops.off(printed, truth, margin));
    return proved(slug, "as corrected " + follows + "; as printed it is off at an example", parts, margin);
  };
  const OfVector spin{{{"", "", "1 / (2 * A)"}}};
  const OfVector body_rates{
      {{"sin psi / sin phi / (A + C)", "cos psi / (A + C)", "- sin psi * cos phi / sin phi / (A + C)"},
       {"cos psi / sin phi / (A + C)", "- sin psi / (A + C)", "- cos psi * cos phi / sin phi / (A + C)"},
       {"", "", "1 / (2 * A)"}}};
  const Factors turning{"- 1 / ((A + C) * sin phi ^ 2)", "", "cos phi / ((A + C) * sin phi ^ 2)"};
  auto by_angles = tops.follow("corrected", angles_of_moved, lagrange,
                               {{turning, {"", "- 1 / (A + C)", ""}, {"1", "", "1"}}});
  // The third equation contains the first.
  by_angles[2].tactic = "assert (turning : " + angles_of_moved.recorded(tops.any)[0].coq() +
                        " = ddtheta) by (" + by_equations(all_angles, {turning[0], turning[2]}, 5) +
                        ");\n  rewrite turning; " + by_equations(all_angles, {"- 1 / (2 * A)"}, 6);
  return {wrong("force_at_center", added, none, {tops.follow("corrected", unexplained, none, torques)}),
          proved("euler_about_axis", follows, {tops.follow("printed", spin_change, zero, spin)}),
          wrong("euler_about_vertical", vertical, zero,
                {tops.follow("corrected", vertical, drive, {{{"1", "", ""}}}),
                 tops.follow("euler", change, euler, body_rates, tops.by_matrix())}),
          wrong("handled_separately", angles_of_fixed, lagrange,
                {by_angles, tops.follow("torque", about_tip, torque_about_tip, torques)})};
}

std::vector<Claim> claims(double seed, const Top& top, const Deviation& off) {
  const std::vector<Sample> tops = random_tops(seed, 1);
  Claims claims("3.35");
  const std::vector<Driven> driven(tops.begin(), tops.end());

  const auto with_torque = [&](const std::string& text, double sign) -> Formula<Sample> {
    return {text,
            [=](const Sample& s) { return sign * (torque_of_tip(s) - torque_of_tip(with_fixed_tip(s))); },
            &Sample::size};
  };
  claims.over(tops)(
      "force_at_center", 3089,
      "the tip moves about the plane only because some force is applied to the center of mass (our "
      "reading: the force moving the tip adds no torque about this center)",
      {.quantity =
           "rate of the angular momentum about the center of mass due to the force that moves the tip",
       .truth = added,
       .printed = {"as we read it, the force that moves the tip adds no torque about the center of mass",
                   none.of},
       .corrected = with_torque(
           R"(the rate of the angular momentum about $\mathbf r$ is $(\mathbf p-\mathbf r)\times\mathbf N$ with )"
           R"($\mathbf N=m(\ddot{\mathbf r}+g\mathbf k)$, to which the force that moves the tip adds )"
           R"($(\mathbf p-\mathbf r)\times(\mathbf N-\mathbf N_0)$, $\mathbf N_0$ the force on a fixed tip)",
           1),
       .near_misses = {with_torque(R"(it adds $(\mathbf r-\mathbf p)\times(\mathbf N-\mathbf N_0)$)", -1)},
       .kind = Fault::counterexample,
       .root = no_torque,
       .why =
           R"(A force on the center of mass $\mathbf r$ has no torque about it. A tip that is driven along )"
           R"($\mathbf p(t)$, as in this exercise, is moved by its support with a force $\mathbf )"
           R"(N=m(\ddot{\mathbf r}+g\mathbf k)$ at the tip. Its torque about the center of mass is )"
           R"($(\mathbf p-\mathbf r)\times\mathbf N$. In the tip's frame, the inertial force )"
           R"($-m\ddot{\mathbf p}$ acts at the center of mass besides the weight; it has a torque about the )"
           R"(tip, and does not move the tip. A tip that slides freely on the plane is another problem. A )"
           R"(push on the center of mass moves it without a torque, but such a top turns about its center )"
           R"(of mass, with the moment $\mu_1-m\ell^2$ across the axis.)"});

  const auto claim_driven = claims.over(driven);
  claim_driven(
      "euler_about_axis", 3089,
      "the Euler equations of example 3.19 still apply to the motion about the axis (our reading, by "
      R"(lines 3077 and 3081 on 3.33: $\dot w_3=0$))",
      {.quantity = R"($\dot w_3$)",
       .truth = {spin_change.text, spin_change.of},
       .printed = {R"($\dot w_3=0$)"},
       .near_misses = {{R"($\dot w_3=\ddot\psi$)"}},
       .changes_that_hold = "a multiple of zero is zero"});

  const std::string in_body = R"($\dot{\mathbf w}$ in body coordinates)";
  const std::string constant = R"($\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi$)";
  const Formula<Driven> rate{vertical.text, vertical.of}, by_drive = computed(Formula<Driven>{drive.text});
  const std::string rate_of_vertical = "rate of the vertical angular momentum";
  claims.add(
      "euler_about_vertical", 3089,
      "the Euler equations of example 3.19 still apply to the motion about the world vertical axis through "
      "the tip (our reading, by lines 3077 and 3081: gravity's torque alone)",
      {.printed = {constant + " is a constant, by Euler's equations with gravity alone",
                   {compare("rate of " + constant + ", $c$ the spin", zero, vertical, tops),
                    compare(
                        in_body,
                        {R"(Euler's equations with the torque of $-mg\mathbf k$ alone)",
                         [](const Sample& s) { return rates_of<RigidBody>(with_fixed_tip(s).top(), s.t); }},
                        change, tops)}},
       .corrected = {"the vertical angular momentum changes at the rate " + drive.text,
                     {compare(rate_of_vertical, by_drive, rate, driven),
                      compare(in_body, euler, change, tops)}},
       .near_misses = single_changes(rate_of_vertical, by_drive, rate, driven, ""),
       .why =
           R"(With the tip as origin the frame is accelerated, and $-m\ddot{\mathbf p}$ acts at the center of )"
           R"(mass besides gravity. Its torque about the tip has the vertical component )"
           R"($m\ell\alpha\lambda^2\sin\lambda t\cos\theta\sin\phi$: the vertical angular momentum is not )"
           R"(conserved, nor is the tilting moment gravity's alone. Only the spin $c$ stays constant. It is the )"
           R"(moving tip that the exercise is about.)",
       .kind = Fault::counterexample,
       .root = no_torque});

  const std::string accelerations = R"($(\ddot\theta,\ddot\phi,\ddot\psi)$)",
                    about_the_tip = "rate of the angular momentum about the tip";
  claims.add(
      "handled_separately", 3091,
      "the motion of the tip may be handled separately (our reading: and the top turns about it as about a fixed "
      "tip)",
      {.printed = {"as we read it, the angles move as with a fixed tip",
                   {compare(accelerations, angles_of_fixed, lagrange, tops)}},
       .corrected = {R"(the angles move with the torque of $-m\ddot{\mathbf p}$ at the center of mass)",
                     {compare(accelerations, angles_of_moved, lagrange, tops),
                      compare(about_the_tip, torque_about_tip, about_tip, tops)}},
       .near_misses = {{R"(with the torque of $+m\ddot{\mathbf p}$)",
                        {compare(accelerations,
                                 {"equations of the angles, the tip's acceleration with the other sign",
                                  [](Sample s) {
                                    s.body.A = -s.body.A;
                                    return rates_of<EulerAngles>(s.top(), s.t);
                                  }},
                                 lagrange, tops)}}},
       .why = filled(
           R"($\mathbf p(t)$ is given, so the tip needs no top; the top does need the tip's acceleration, unless )"
           R"(the tip is at rest or in uniform motion. The accelerated tip adds to gravity a horizontal )"
           R"(acceleration $\alpha\lambda^2\sin\lambda t$ that turns the top about its tip. With the values here )"
           R"(its axis gets up to @2 rad from that of the fixed top within @1 s, and up to @2 rad at twice the )"
           R"(frequency. With the tip shaken )" +
               at_nutation(top) + R"(, @4 rad/s, it gets up to @2 rad.)",
           {off.as_asked, ex03_33::duration, off.twice_the_frequency, nutation_frequency(top),
            off.at_nutation}),
       .kind = Fault::counterexample,
       .root = no_torque});

  claim_driven(
      "tip_is_center", 3091,
      R"(the tip is the center of mass (our reading of the parenthesis: $\mathbf r=\mathbf p$; line 2953 places it at )"
      R"($\ell\boldsymbol\xi_3$))",
      {.quantity = "center of mass",
       .truth = {R"($\sum m\mathbf x/m$ over the points)",
                 [](const Driven& s) {
                   return s.body.sum<Vector<double>>([&](Vector<double>& sum, const PointOf<double>& p) {
                     sum = sum + p.m / s.m * motion_of<double>(s, p.x).x;
                   });
                 }},
       .printed = {R"($\mathbf r=\mathbf p$)"},
       .corrected = {R"($\mathbf r=\mathbf p+\ell\,\boldsymbol\xi_3$)"},
       .kind = Fault::term,
       .root = "tip for center of mass",
       .why =
           R"(The two are $\ell$ apart, always: the center of mass is at $\mathbf p+\ell\boldsymbol\xi_3$, )"
           R"($\boldsymbol\xi_3$ the unit vector along the axis, and has the acceleration $\ddot{\mathbf p}+\ell\ddot{\boldsymbol\xi}_3$. It is the tip that the exercise )"
           R"(moves.)"});
  return claims.in_order();
}

std::vector<Root> roots(const Top& top, const Deviation& off) {
  return {
      {no_torque,
       filled(
           R"(Shaken by @3 cm )" + at_nutation(top) +
               R"(, @4 rad/s, the top has its axis up to @2 rad (@3 degrees) from that of the same top )"
               R"(with its tip fixed, within @1 s. At @2 rad/s it is up to @2 rad. A game that carries the )"
               R"(motion about a fixed tip along with the tip shows none of it.)",
           {100 * top.A, nutation_frequency(top), off.at_nutation, off.at_nutation / degree,
            ex03_33::duration, top.lambda, off.as_asked})},
      {"tip for center of mass",
       filled(
           R"(A top drawn with its center of mass at $\mathbf p$ is moved back along its axis by $\ell$: its )"
           R"(tip is @2 cm from where it should be.)",
           {100 * top.l})}};
}

}  // namespace oddity::ex03_35
