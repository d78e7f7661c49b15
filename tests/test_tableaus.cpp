// Tableaus of Runge-Kutta methods: the condition of every rooted tree (Butcher), and the estimates of the
// error.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "report/verify/catch.hpp"
#include "solvers/ode/dormand_prince_853.hpp"
#include "solvers/ode/verner_98.hpp"
#include "tests/near.hpp"
#include "tests/ode_problems.hpp"

using namespace oddity::ode;

namespace {

/// A rooted tree: its branches are earlier trees of the list of all.
struct Tree {
  int order = 1;
  std::vector<std::size_t> branches;
};

/// All rooted trees of up to `most` nodes, by their order.
std::vector<Tree> rooted_trees(int most) {
  std::vector<Tree> all(1);
  const auto add = [&](const auto& self, const Tree& tree, std::size_t earlier, int order) -> void {
    if (tree.order == order) return all.push_back(tree);
    for (std::size_t i = 0; i < earlier; ++i) {
      if (tree.order + all[i].order > order) continue;
      Tree larger = tree;
      larger.order += all[i].order;
      larger.branches.push_back(i);
      self(self, larger, i + 1, order);
    }
  };
  for (int order = 2; order <= most; ++order) add(add, {}, all.size(), order);
  return all;
}

/// The weights of each stage.
template <std::size_t stages>
using Stages = std::array<oddity::ode::detail::Weights<stages>, stages>;
template <class Tableau>
constexpr auto stages_of() {
  return std::to_array(Tableau::a);
}

/// Sums over a tableau for a tree, at each stage: the elementary weight, and the same of absolute values.
template <std::size_t stages>
struct Sums {
  std::array<long double, stages> weight, absolute;
  long double density;
};

template <std::size_t stages>
std::vector<Sums<stages>> sums_of(const Stages<stages>& weights_of, const std::vector<Tree>& trees) {
  std::vector<Sums<stages>> all;
  for (const Tree& tree : trees) {
    Sums<stages> sums{{}, {}, static_cast<long double>(tree.order)};
    sums.weight.fill(1);
    sums.absolute.fill(1);
    for (std::size_t branch : tree.branches) {
      sums.density *= all[branch].density;
      for (std::size_t i = 0; i < stages; ++i) {
        long double weight = 0, absolute = 0;
        for (std::size_t j = 0; j < i; ++j) {
          const long double a = weights_of[i][j];
          weight += a * all[branch].weight[j];
          absolute += std::abs(a) * all[branch].absolute[j];
        }
        sums.weight[i] *= weight;
        sums.absolute[i] *= absolute;
      }
    }
    all.push_back(sums);
  }
  return all;
}

/// The highest order up to which the weights meet every tree's condition, as far as there are trees. The
/// tolerance is the rounding of the tableau's numbers, of which each term has as many as the tree has nodes.
template <std::size_t stages>
int order_of(const oddity::ode::detail::Weights<stages>& weights, const std::vector<Sums<stages>>& sums,
             const std::vector<Tree>& trees) {
  for (std::size_t tree = 0; tree < trees.size(); ++tree) {
    long double sum = 0, absolute = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      sum += weights[i] * sums[tree].weight[i];
      absolute += std::abs(weights[i]) * sums[tree].absolute[i];
    }
    const double rounding = trees[tree].order * std::numeric_limits<double>::epsilon();
    if (std::abs(sum - 1 / sums[tree].density) > rounding * absolute) return trees[tree].order - 1;
  }
  return trees.back().order;
}

/// Whether the weights of a stage add up to its time.
template <std::size_t stages>
bool add_up(const oddity::ode::detail::Weights<stages>& weights, double time) {
  long double sum = 0, absolute = 0;
  for (double weight : weights) sum += weight, absolute += std::abs(weight);
  return std::abs(sum - time) <= std::numeric_limits<double>::epsilon() * absolute;
}

template <class Tableau>
int order_of(const oddity::ode::detail::Weights<std::size(Tableau::a)>& weights) {
  const auto trees = rooted_trees(Tableau::order + 1);
  return order_of(weights, sums_of(stages_of<Tableau>(), trees), trees);
}

}  // namespace

TEST_CASE("there are as many rooted trees as Cayley counted", "[solvers]") {
  const auto trees = rooted_trees(10);
  for (const auto& [order, count] :
       {std::pair(1, 1), {2, 1}, {3, 2}, {4, 4}, {5, 9}, {6, 20}, {7, 48}, {8, 115}, {9, 286}, {10, 719}})
    CHECK(std::ranges::count(trees, order, &Tree::order) == count);
}

TEST_CASE("the weights of every stage add up to its time", "[solvers]") {
  const auto check = []<class Tableau>() {
    for (std::size_t i = 0; i < Tableau::c.size(); ++i) CHECK(add_up(Tableau::a[i], Tableau::c[i]));
  };
  check.operator()<DormandPrince853::Tableau>();
  check.operator()<Verner98::Tableau>();
}

TEST_CASE("weights meet the condition of every rooted tree up to their order, and not beyond", "[solvers]") {
  using Dop = DormandPrince853::Tableau;
  CHECK(order_of<Dop>(Dop::b) == 8);
  CHECK(order_of<Dop>(oddity::ode::detail::difference(Dop::b, Dop::estimates[0])) == 5);
  CHECK(order_of<Dop>(Dop::third_order) == 3);
  CHECK(order_of<Verner98::Tableau>(Verner98::Tableau::b) == 9);
  CHECK(order_of<Verner98::Tableau>(Verner98::Tableau::eighth_order) == 8);
}

TEST_CASE("a wrong digit of any weight is found by the conditions", "[solvers]") {
  const auto check = []<class Tableau>(const auto& lower, int lower_order) {
    const auto trees = rooted_trees(Tableau::order);
    const auto right = sums_of(stages_of<Tableau>(), trees);
    const auto is_found = [&](const auto& b, const auto& embedded, const auto& sums) {
      return order_of(b, sums, trees) < Tableau::order || order_of(embedded, sums, trees) < lower_order;
    };
    CHECK_FALSE(is_found(Tableau::b, lower, right));
    for (std::size_t i = 0; i < right[0].weight.size(); ++i) {
      auto wrong = Tableau::b;
      wrong[i] += 1e-12;
      CHECK(is_found(wrong, lower, right));
      auto wrong_lower = lower;
      wrong_lower[i] += 1e-12;
      CHECK(is_found(Tableau::b, wrong_lower, right));
      for (std::size_t j = 0; j < i; ++j) {
        if (Tableau::a[i][j] == 0) continue;
        auto stages = stages_of<Tableau>();
        stages[i][j] += 1e-12;
        INFO("stage " << i << ", weight " << j);
        CHECK((!add_up(stages[i], Tableau::c[i]) || is_found(Tableau::b, lower, sums_of(stages, trees))));
      }
    }
  };
  using Dop = DormandPrince853::Tableau;
  check.operator()<Dop>(oddity::ode::detail::difference(Dop::b, Dop::estimates[0]), 5);
  check.operator()<Verner98::Tableau>(Verner98::Tableau::eighth_order, 8);
}

TEST_CASE("the error estimate of one step shrinks with the order of the method", "[solvers]") {
  const auto order = []<class Algorithm>() {
    const auto estimate = [](double h) {
      typename Algorithm::template Plain<problems::State> stepper;
      auto x = problems::separatrix.exact(0.5);
      problems::State error{};
      stepper.do_step(problems::separatrix.system, x, 0.5, h, error);
      return std::hypot(error[0], error[1]);
    };
    return std::log2(estimate(0.4) / estimate(0.2));
  };
  CHECK(near(order.operator()<DormandPrince853>(), 8, 0.3));
  CHECK(near(order.operator()<Verner98>(), 9, 0.3));
}

TEST_CASE("DOP853 counts as much of its first estimate as Hairer's program", "[solvers]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto part = DormandPrince853::Tableau::part;
  CHECK(near_ulps(part(3 * 3, 40 * 40), 3 / 5.0, 4));  // 3 / sqrt(3^2 + (40 / 10)^2)
  CHECK(part(2, 0) == 1);
  CHECK(part(0, 0) == 1);
  CHECK(part(0, 1) == 1);
  CHECK(part(infinity, infinity) == 1);
  CHECK(part(1, infinity) == 1);
  CHECK(part(std::nan(""), 1) == 1);
}
