// Exercise 8.3: affine subspaces A1 = P1 + V1 and A2 = P2 + V2 are parallel when V1 contains V2 or V2
// contains V1, that is when rank [V1 V2] = max(rank V1, rank V2). The book's are lines with the directions of
// the x-axis and of the y-axis. The reference for random ones is how they were made; exact ranks are by
// elimination in integers.

#include <algorithm>

#include "chapters/08_affine_algebra/03_parallel_subspaces/subspaces.hpp"
#include "chapters/exercise.hpp"
#include "reference/text.hpp"
#include "solvers/counted_calls.hpp"

namespace oddity {

namespace ex08_03 {

using namespace subspaces;

constexpr Parameter parameters[] = {
    {"pairs", 60, "", "random pairs of subspaces", 1, 500, whole_number},
    {"seed", 1, "", "of the random pairs", 0, 1e9, whole_number},
};

MatrixXd column(std::initializer_list<double> xs) {
  MatrixXd m(static_cast<long>(xs.size()), 1);
  long i = 0;
  for (double x : xs) m(i++, 0) = x;
  return m;
}

const Pair axes{column({1, 0}), column({0, 1}), false};

// ---- claims -----------------------------------------------------------------------------------------------

/// The vectors that carry points of the line `normal . x = constant` into points of it, against the span of a
/// direction, by exact rank.
Check carriers(double seed, const std::string& axis, const MatrixXd& normal, const MatrixXd& direction) {
  Random random(seed);
  long differing = 0;
  for (int n = 0; n < 400; ++n) {
    const MatrixXd v = whole(random, 2, 1);
    const bool stays = (normal.transpose() * v)(0, 0) == 0;
    differing += stays != (exact_rank(Pair{v, direction, true}.both()) == 1);
  }
  return never("vectors that keep points on the line and are not on the " + axis + ", or the reverse",
               differing, 400);
}

Check contained(const char* what, const MatrixXd& inner, const MatrixXd& outer, double ranks) {
  return {std::string("rank of the columns of ") + what,
          {"exact elimination", static_cast<double>(exact_rank(Pair{inner, outer, true}.both()))},
          {ranks == 2 ? "2: not contained" : "1: contained", ranks},
          exact(),
          1};
}

/// Translates of A1 = P1 + V1: how far from A2 are the points P1 + t d1? Parallel lines: all equally far.
Check distances(bool constant) {
  std::vector<double> far, expected;
  for (double t : {-3.0, 0.0, 2.0, 5.0}) {
    const MatrixXd x = column({1, 4}) + t * axes.first - column({-2, 7});
    const auto along = solve(Factorization::householder_qr, axes.second, x.col(0));
    far.push_back((x - axes.second * along.value).norm());
    expected.push_back(constant ? 3 : std::abs(3 + t));
  }
  return {"distances of (1 + t, 4) from the line x = -2, t = -3, 0, 2, 5",
          {"least squares", far},
          {constant ? "constant" : "|3 + t|: they meet at t = -3", expected},
          rounding(8)};
}

/// Points of the smaller at equal distances from the larger, by least squares: parallel to the eye.
bool equally_far(const Pair& pair, Random& random) {
  const MatrixXd apart = whole(random, pair.first.rows(), 1);
  std::vector<double> far;
  for (int n = 0; n < 6; ++n) {
    const VectorXd x = apart + pair.smaller() * whole(random, pair.smaller().cols(), 1);
    const auto nearest = solve(Factorization::householder_qr, pair.larger(), x);
    far.push_back((x - pair.larger() * nearest.value).norm());
  }
  const auto [least, most] = std::ranges::minmax(far);
  return most - least < 1e-9;
}

Check criterion(double seed, const char* by, bool (*parallel)(const Pair&)) {
  Random random(seed);
  long wrong = 0, count = 0;
  for (const Pair& pair : random_pairs(seed, 300)) {
    ++count;
    wrong += parallel(pair) != equally_far(pair, random);
  }
  return never(std::string("pairs judged otherwise than by equal distances, by ") + by, wrong, count);
}

bool either_contains(const Pair& pair) { return by_rank(pair, exact_rank); }
bool both_equal(const Pair& pair) {
  return pair.first.cols() == pair.second.cols() && exact_rank(pair.both()) == pair.first.cols();
}
bool common_direction(const Pair& pair) {
  return exact_rank(pair.both()) < pair.first.cols() + pair.second.cols();
}

std::vector<Claim> claims(double seed) {
  // The lines y = const and x = const by their equations.
  const auto vectors = [&](const char* axis, const MatrixXd& normal, const MatrixXd& direction) {
    return carriers(seed, axis, normal, direction);
  };
  return {{"8.3-directions",
           3999,
           "the vectors of A1 are those on the x-axis, the vectors of A2 those on the y-axis (A1 and A2 "
           "themselves are not in "
           "the solutions: any lines in these directions)",
           {"x-axis and y-axis",
            {vectors("x-axis", axes.second, axes.first), vectors("y-axis", axes.first, axes.second)}},
           {},
           {},
           {{"exchanged", {vectors("y-axis", axes.second, axes.second)}}}},
          {"8.3-neither",
           3999,
           "neither V1 is in V2 nor V2 in V1",
           {"rank 2 both ways",
            {contained("V1 and V2", axes.first, axes.second, 2),
             contained("V2 and V1", axes.second, axes.first, 2)}},
           {},
           {},
           {{"V1 in V2", {contained("V1 and V2", axes.first, axes.second, 1)}}}},
          {"8.3-not_parallel",
           3999,
           "the affine subspaces are not parallel",
           {"their distance changes along the line", {distances(false)}},
           {},
           {},
           {{"their distance is constant", {distances(true)}}}},
          {"8.3-criterion",
           3999,
           "what decides is whether one vector space contains the other",
           {"V1 in V2 or V2 in V1", {criterion(seed, "containment, exact ranks", either_contains)}},
           {},
           {},
           {{"V1 = V2", {criterion(seed, "equality, exact ranks", both_equal)}},
            {"a common direction", {criterion(seed, "a common direction, exact ranks", common_direction)}}}}};
}

// ---- methods ----------------------------------------------------------------------------------------------

/// 1 for parallel, 0 for not, pair by pair. A rank or a projection is one evaluation.
template <class Judge>
Answer judged(const std::vector<Pair>& pairs, const Judge& judge) {
  Answer answer;
  std::vector<double> verdicts;
  for (const Pair& pair : pairs) {
    verdicts.push_back(judge(pair, answer.evaluations));
  }
  answer.value = Value(std::move(verdicts));
  return answer;
}

Quantity parallel(std::string name, std::string says, std::string because, const std::vector<Pair>& pairs,
                  Outcome in_integers, Outcome in_doubles, const std::string& why) {
  std::vector<double> truth;
  for (const Pair& pair : pairs) truth.push_back(pair.parallel);
  Quantity q{
      std::move(name), "1", std::move(says), {std::move(because), truth}, 0, {0.5, "whole numbers"}, {}, {}};
  const auto add = [&](const char* model, const char* algorithm, const Knob& knob, Outcome expected,
                       const auto& judge) {
    q.add({model, algorithm, knob,
           [=](double e) {
             return judged(pairs, [=](const Pair& pair, long& calls) { return judge(pair, e, calls); });
           },
           expected, expected == Outcome::ok ? "" : why});
  };
  const Knob knob = tolerances(2, 12, 5);
  const auto ranks = [&](const char* algorithm, const Knob& settings, Outcome expected, const auto& rank_of) {
    add("ranks", algorithm, settings, expected, [rank_of](const Pair& pair, double e, long& calls) {
      const auto of = [&](const MatrixXd& m) { return rank_of(m, e); };
      return by_rank(pair, counted_calls(of, calls));
    });
  };
  ranks("elimination in integers", no_knob(), in_integers,
        [](const MatrixXd& m, double) { return exact_rank(m); });
  ranks("singular values", knob, in_doubles, [](const MatrixXd& m, double e) { return rank(m, e); });
  ranks("elimination, complete pivoting", knob, in_doubles,
        [](const MatrixXd& m, double e) { return eliminated_rank(m, e); });
  add("projection", "Householder QR", knob, in_doubles,
      [](const Pair& pair, double e, long& calls) { return by_projection(pair, e, calls); });
  return q;
}

/// Directions (10^k, 1), once with (10^k + 1, 1), once with three times itself.
std::vector<Pair> nearly_parallel() {
  std::vector<Pair> all;
  for (int k = 1; k <= 12; ++k) {
    const double large = std::round(std::pow(10, k));
    all.push_back({column({large, 1}), column({large + 1, 1}), false});
    all.push_back({column({large, 1}), column({3 * large, 3}), true});
  }
  return all;
}

/// Directions and their multiples by factors that round, in 2^-52 as unit, so that they are whole numbers.
std::vector<Pair> rounded_multiples(double seed) {
  Random random(seed);
  std::vector<Pair> all;
  for (int n = 0; n < 12; ++n) {
    const double x = random.between(1, 2), y = random.between(1, 2), factor = random.between(1, 2);
    all.push_back({0x1p52 * column({x, y}), 0x1p52 * column({factor * x, factor * y}), true});
    all.push_back({0x1p52 * column({x, y}), 0x1p52 * column({factor * x, 1.25 * factor * y}), false});
  }
  return all;
}

Findings study(const Parameters& p, const Reference&) {
  const Outcome ok = Outcome::ok, wrong = Outcome::inaccurate;
  Quantity random = parallel("random_pairs", "are they parallel? 1 or 0", "as they were made",
                             random_pairs(p["seed"], static_cast<int>(p["pairs"])), ok, ok, "");
  Quantity nearly =
      parallel("nearly_parallel", "are (10^k, 1) and (10^k + 1, 1) parallel? (10^k, 1) and (3 10^k, 3)?",
               "the determinants -1 and 0", nearly_parallel(), ok, wrong,
               "an angle of 10^-2k, below any tolerance that rounding allows");
  nearly.add(Breakdown{
      "(10^8, 1) and (10^8 + 1, 1) have the determinant -1 and the sine 1e-16: to singular values, at any "
      "tolerance, they are parallel. Whole numbers are decided in whole numbers.",
      "ranks, singular values", 1e-12, wrong, "ranks, elimination in integers", 0});
  Quantity rounded =
      parallel("rounded_multiples", "are v and its rounded multiple parallel?", "as they were made",
               rounded_multiples(p["seed"]), wrong, ok, "the multiple is rounded, and exactness is no help");
  rounded.add(Breakdown{
      "Exact arithmetic on rounded numbers judges the rounding. Where the data are measured or computed, "
      "only a tolerance above their error makes sense.",
      "ranks, elimination in integers", 0, wrong, "ranks, singular values", 1e-12});
  return {claims(p["seed"]), {random, nearly, rounded}};
}

}  // namespace ex08_03

Exercise exercise_8_3() {
  using namespace ex08_03;
  return {"Parallel affine subspaces",
          "Two affine subspaces $A_i=P_i+V_i$: are they parallel, that is, does one of the vector spaces "
          "$V_1$, $V_2$ "
          "contain the other?",
          parameters,
          {},
          study};
}

}  // namespace oddity
