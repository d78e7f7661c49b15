// The claims of exercise 3.5. The published integral and its listing are compared with the
// arithmetic-geometric mean, and with quadrature after psi = a - s^2.

#include <cmath>
#include <numbers>

#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/03_rigid_body_motion/05_pendulum/pendulum.hpp"
#include "chapters/claims.hpp"
#include "chapters/provable.hpp"
#include "chapters/scene.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_05 {

namespace {

using std::cos, std::sin, std::sqrt, std::numbers::pi;

/// The remainder of the integral beyond a - epsilon.
template <class T>
T to_leading_order(const T& a) {
  return 2 * sqrt(book_epsilon / sin(a));
}

const std::string to_epsilon = R"(\int_0^{a-\epsilon}\frac{d\psi}{\sqrt{\cos\psi-\cos a}})";

/// The integral's tolerance in QAG.
constexpr double by_qag = 1e-13;

/// The integral from a - to until a - from, by psi = a - s^2, with the difference of the cosines as a
/// product.
double part_of_integral(double from, double to) {
  const double a = book_angle;
  const auto smooth = [a](double s) {
    return s == 0 ? 2 / sqrt(sin(a)) : 2 * s / sqrt(2 * sin(a - s * s / 2) * sin(s * s / 2));
  };
  return qag(smooth, sqrt(from), sqrt(to), by_qag).value;
}

/// Error of the remainder from a few roundings of the arc sine's argument, which is nearly 1.
double roundings_of_remainder(double epsilon) {
  constexpr double roundings = 4, unit = 0x1p-53;
  const double slope = 1 / sqrt(2 * epsilon * cos(book_angle) / sin(book_angle));
  return sqrt(2 / cos(book_angle)) * slope * roundings * unit;
}

/// A point that splits the integral, with the integral up to it.
struct Cut {
  double epsilon, first_part;
  explicit Cut(double at) : epsilon(at), first_part(part_of_integral(at, book_angle)) {}
  TypesetLetters typeset() const {
    return {{R"(\epsilon)", epsilon}, {"a", book_angle}, {to_epsilon, first_part}};
  }
  Tolerance tolerance(double) const {
    const double next_term = std::pow(epsilon, 2.5) / (30 * sqrt(sin(book_angle)));
    constexpr double quadratures = 10 * by_qag;
    return {
        2 * next_term + quadratures + roundings_of_remainder(epsilon),
        R"(twice the first term left out, $\epsilon^{5/2}/(30\sqrt{\sin a})$, with the quadrature's error )"
        R"(and roundings under the arc sine's root)"};
  }
  std::string where() const { return R"($\epsilon$ = )" + format_shortest(epsilon); }
};

/// A node of the listing's sum.
struct Node {
  double psi;
  TypesetLetters typeset() const { return {{R"(\psi)", psi}}; }
  std::string where() const { return R"($\psi$ = )" + format_shortest(psi); }
};

std::vector<Node> nodes() {
  std::vector<Node> all;
  for (int i = 1; i < book_panels; ++i) all.push_back({i * (book_angle - book_epsilon) / book_panels});
  return all;
}

}  // namespace

std::vector<Claim> claims(const Reference& truth) {
  Claims claims("3.5");
  const double a = book_angle, listed = listed_integral(a, a, book_panels);

  const auto split = [](const std::string& factor, const std::string& quarter) {
    return "$" + to_epsilon + "+" + factor + R"(\left()" + quarter +
           R"(-\sin^{-1}\left(1-\frac{\epsilon\cos a}{\sin a}\right)\right)$)";
  };
  const std::string root = R"(\sqrt{\frac2{\cos a}})";
  claims.formula<Cut>(
      "split_formula", 1273, R"($T\approx)" + split(root, "2").substr(1) + R"(, $a=\pi/6$)",
      {Cut(1e-2), Cut(1e-3), Cut(book_epsilon)},
      {.quantity = R"($I(a)$, cut at $a-\epsilon$)",
       .truth = {R"($\sqrt2\,K$ by the arithmetic-geometric mean)",
                 [whole = truth("03_05_quarter_period", {a}).value](const Cut&) { return whole; }},
       .printed = {split(root, "2")},
       .meant = {split(root, R"(\frac\pi2)")},
       .near_misses = {{split(R"(\frac{\sqrt2}{\cos a})", R"(\frac\pi2)")}},
       .why = filled(
           R"(The $\pi$ of $\pi/2$ and the fraction bars are lost: without them, the remainder does not )"
           R"(vanish with $\epsilon$, and the time is @2 too long. The listing has `HALF_PI`, and )"
           R"($\sqrt{2/\cos a}$.)",
           {sqrt(2 / cos(a)) * (2 - pi / 2)})});

  const auto shifted = [](double psi) { return 1 / sqrt(cos(psi) - book_angle); };
  const auto by_rule = [&](const std::string& rule, const Solved<double>& sum) {
    return Reading{rule,
                   {{"the listing's sum, weights 4 and 2 in turn,",
                     {"in the listing's arithmetic", listed},
                     {rule + " for the same integrand", sum.value},
                     rounding(listed, book_panels)}}};
  };
  claims.add(
      "simpson", 1307, R"(The listing integrates over $[0,\pi/6-\epsilon]$ by Simpson's rule.)",
      {.printed = by_rule("Simpson's rule", simpson(shifted, 0, a - book_epsilon, book_panels)),
       .near_misses = {by_rule("the trapezoid rule", trapezoid(shifted, 0, a - book_epsilon, book_panels)),
                       by_rule(R"(Simpson's rule over $[0,\pi/6]$)", simpson(shifted, 0, a, book_panels))}});

  const auto argument = [](const std::string& text, double subtracted) {
    return Formula<Node>{text, [=](const Node& n) { return cos(n.psi) - subtracted; }};
  };
  claims.formula<Node>(
      "listing_integrand", 1331,
      R"(The listing's `arg = Mathd::Cos(angle) - initialAngle` is the text's $\cos\psi-\cos(\pi/6)$.)",
      nodes(),
      {.quantity = "the root's argument at a node",
       .truth = {R"(the difference as a product, $2\sin\frac{\pi/6+\psi}2\sin\frac{\pi/6-\psi}2$)",
                 [a](const Node& n) { return 2 * sin((a + n.psi) / 2) * sin((a - n.psi) / 2); }},
       .printed = argument("`Mathd::Cos(angle) - initialAngle`", a),
       .corrected = argument("`Mathd::Cos(angle) - Mathd::Cos(initialAngle)`", cos(a)),
       .near_misses = {argument("`Mathd::Cos(angle) - Mathd::Sin(initialAngle)`", sin(a))},
       .kind = Fault::listing,
       .root = "angle for its cosine",
       .why = filled(R"(`initialAngle` is $\pi/6=@3$, but $\cos(\pi/6)=@3$ belongs there. `fmin` and )"
                     R"(`fmax` (lines 1315, 1317) have the same slip.)",
                     {a, cos(a)})});

  claims.statement<Node>(
      "positive_root", 1333, "The argument of the root is positive at every node.", nodes(),
      {.printed = {R"($\cos\psi-\pi/6>0$)"}, .near_misses = {{R"($\cos\psi-\cos(\pi/12)>0$)"}}});

  const auto last = [&](const std::string& text, double from) {
    return Reading{
        text,
        {{"the listing's `remainder`",
          {R"($\sqrt{2/\cos a}\,(\pi/2-\arcsin(1-\epsilon\cos a/\sin a))$)", remainder(a, book_epsilon)},
          {"QAG of the text's integrand, $\\psi=a-s^2$", part_of_integral(0, from)},
          {roundings_of_remainder(book_epsilon),
           "the roundings of $1-\\epsilon\\cos a/\\sin a$ under the arc sine's root"}}}};
  };
  claims.add("remainder_interval", 1357,
             R"(The remainder is the term of $[\pi/6-\epsilon,\pi/6]$, for the text's integrand.)",
             {.printed = last(R"(from $\pi/6-\epsilon$ on)", book_epsilon),
              .near_misses = {last(R"(from $\pi/6-1.001\,\epsilon$ on)", 1.001 * book_epsilon)}});

  claims.number("listing_output", 1373, "The listing computes `pendulumTime` = 0.800275.",
                {.truth = {"the listing's arithmetic", listed + remainder(a, book_epsilon)},
                 .printed = "0.800275",
                 .near_misses = {"0.800276"}});

  claims.number(
      "value", 1373,
      R"(The value of `pendulumTime` (our reading: of the integral from $30^\circ$) is 0.800275.)",
      {.truth = {R"($\sqrt2\,K(\sin\frac{\pi}{12})$ by the arithmetic-geometric mean)",
                 truth("03_05_quarter_period", {a}).value},
       .printed = "0.800275",
       .corrected = "2.260114",
       .near_misses = {"2.260115"},
       .kind = Fault::listing,
       .root = "angle for its cosine",
       .why = R"(The listing subtracts `initialAngle` where the text's integrand has $\cos(\pi/6)$. It )"
              R"(integrates $1/\sqrt{\cos\psi-\pi/6}$, which is finite on all of $[0,\pi/6]$, and adds a )"
              R"(remainder for a singularity that is not there. To replace the one term is not enough: )"
              R"(Simpson's rule then takes the integrand next to its singularity (see the methods below).)"});

  const Route tail{R"($2\sqrt{\epsilon/\sin a}$, the remainder to leading order)", to_leading_order(a)};
  claims.add(
      "remainder", 1373, "The value of the remainder is 0.000282.",
      {.printed = {"0.000282", {as_written("the remainder", "0.000282", tail)}},
       .meant = {"0.000282..., cut off", {as_cut_off("the remainder", "0.000282", tail)}},
       .near_misses = {{"0.000281..., cut off", {as_cut_off("the remainder", "0.000281", tail)}},
                       {"0.000284", {as_written("the remainder", "0.000284", tail)}}},
       .why = filled(
           "The remainder is @5...: the digits printed are cut off, not rounded. Those of the time, @7, "
           "are the same either way. The listing adds the unrounded remainder; its time is not "
           "affected.",
           {tail.value[0], listed + remainder(a, book_epsilon)}),
       .kind = Fault::number});
  return claims.in_order();
}

Provables proofs() {
  const Expression whole = integral(legendre_integrand(pi_in_coq() / 6), 0, pi_in_coq() / 2, "u"),
                   tail = to_leading_order(pi_in_coq() / 6);
  return {
      {"3.5-value",
       "Legendre's integral from 30 degrees is the corrected value to its last digit, and 1.4 above the printed one",
       {{.name = "corrected", .follows = {near(whole, 2.260114, 5e-7)}, .tactic = "integral"},
        {.name = "printed_differs", .follows = {apart(whole, 0.800275, 1.4)}, .tactic = "integral"}},
       1.4},
      {"3.5-remainder",
       "the remainder to leading order begins with 0.000282, and is 0.00000084 above that",
       {{.name = "meant", .follows = {near(tail, 0.0002825, 5e-7)}, .tactic = "interval"},
        {.name = "printed_differs", .follows = {apart(tail, 0.000282, 8.4e-7)}, .tactic = "interval"}},
       8.4e-7}};
}

std::vector<Root> roots() {
  constexpr double length = 1, g = 9.81;
  const double a = book_angle, unit = sqrt(length / (2 * g)),
               quarter = std::numbers::sqrt2 * std::comp_ellint_1(sin(a / 2)),
               published = listed_integral(a, a, book_panels) + remainder(a, book_epsilon);
  const double come = a - pendulum::FourierSeries<double>({a, length, g}).at(unit * published)[0];
  return {
      {"angle for its cosine",
       filled(
           R"(A pendulum of @1 m takes @3 s to its lowest point, $\sqrt2\,K(\sin@2^\circ)=@7$ units of )"
           R"($\sqrt{L/2g}$, not @3 s: an engine that takes the published number as its cue strikes when the bob )"
           R"(has come @2 of its @2 degrees.)",
           {length, unit * quarter, a / 2 / degree, quarter, unit * published, come / degree, a / degree})}};
}

}  // namespace oddity::ex03_05
