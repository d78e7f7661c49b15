// The claims of exercise 8.3: ranks by elimination in integers, and distances by least squares.

#include <algorithm>

#include "chapters/08_affine_algebra/03_parallel_subspaces/parallel_subspaces.hpp"
#include "chapters/claims.hpp"
#include "solvers/linear.hpp"

namespace oddity::ex08_03 {

namespace {

const Pair axes{column({1, 0}), column({0, 1}), false};

Reading ranks(std::string text, double rank) {
  const auto check = [&](const char* what, const MatrixXd& one, const MatrixXd& other) {
    return Check{what,
                 {"exact elimination", static_cast<double>(exact_rank(Pair{one, other, true}.both()))},
                 {text, rank},
                 exact()};
  };
  return {text,
          {check("rank of the columns of $V_1$ and $V_2$", axes.first, axes.second),
           check("rank of the columns of $V_2$ and $V_1$", axes.second, axes.first)}};
}

/// A point (1 + t, 4) of A1 = (1, 4) + V1; A2 is the line x = -2.
struct Walker {
  double t;
  TypesetLetters typeset() const { return {{"t", t}}; }
  double distance() const {
    const MatrixXd x = column({1, 4}) + t * axes.first - column({-2, 7});
    const auto along = solve(Factorization::householder_qr, axes.second, x.col(0));
    return (x - axes.second * along.value).norm();
  }
};

/// A pair of vector spaces, and whether points of the smaller are equally far from the larger by least
/// squares, so that they look parallel.
struct Judged {
  Pair pair;
  bool equally_far;
  std::string where() const {
    return "dimensions " + std::to_string(pair.first.cols()) + " and " + std::to_string(pair.second.cols()) +
           " of " + std::to_string(pair.first.rows());
  }
};

std::vector<Judged> judged_pairs(double seed) {
  Random random(seed);
  std::vector<Judged> all;
  for (const Pair& pair : random_pairs(seed, 300)) {
    const MatrixXd apart = whole(random, pair.first.rows(), 1);
    std::vector<double> far;
    for (int n = 0; n < 6; ++n) {
      const VectorXd x = apart + pair.smaller() * whole(random, pair.smaller().cols(), 1);
      const auto nearest = solve(Factorization::householder_qr, pair.larger(), x);
      far.push_back((x - pair.larger() * nearest.value).norm());
    }
    const auto [least, most] = std::ranges::minmax(far);
    all.push_back({pair, most - least < 1e-9});
  }
  return all;
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("8.3");
  claims.add("directions", 3999, "the vector space of $A_1$ is the $x$-axis, that of $A_2$ the $y$-axis",
             {.not_checkable = "neither $A_1$ nor $A_2$ is in the solutions"});
  claims.add(
      "neither", 3999, R"(neither $V_1\subseteq V_2$ nor $V_2\subseteq V_1$)",
      {.printed = ranks("rank 2 both ways", 2), .near_misses = {ranks("rank 1, one in the other", 1)}});
  const std::vector<Walker> walk{{-5}, {-3}, {0}, {2}, {5}};
  const std::string quantity = "distance of $(1+t,4)$ from the line $x=-2$, which changes with $t$";
  const Formula<Walker> stated = computed(Formula<Walker>{"$|3+t|$"}),
                        truth{"least squares", &Walker::distance};
  const auto pairs = judged_pairs(seed);
  const auto just_when = [&](const std::string& when, const std::function<bool(const Judged&)>& contained) {
    return in_all<Judged>("points are equally far just when " + when, pairs,
                          [=](const Judged& j) { return contained(j) == j.equally_far; });
  };
  Claim not_parallel{.printed = {stated.text,
                                 {compare(quantity, stated, truth, walk),
                                  just_when(R"($V_1\subseteq V_2$ or $V_2\subseteq V_1$)",
                                            [](const Judged& j) { return by_rank(j.pair, exact_rank); })},
                                 is_as_typeset(compare_typeset(stated, walk))},
                     .near_misses = single_changes(quantity, stated, truth, walk, "")};
  const auto near_miss = [&](const std::string& when, const auto& contained) {
    not_parallel.near_misses.push_back({"parallel just when " + when, {just_when(when, contained)}});
  };
  near_miss("$V_1=V_2$", [](const Judged& j) {
    const long dimension = j.pair.first.cols();
    return dimension == j.pair.second.cols() && exact_rank(j.pair.both()) == dimension;
  });
  near_miss("they have a direction in common", [](const Judged& j) {
    return exact_rank(j.pair.both()) < j.pair.first.cols() + j.pair.second.cols();
  });
  claims.add("not_parallel", 3999,
             "the affine subspaces are not parallel (our reading, as they are not in the solutions: lines in "
             "these directions, through points that we choose)",
             std::move(not_parallel));
  return claims.in_order();
}

}  // namespace oddity::ex08_03
