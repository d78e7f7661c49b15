#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "chapters/07_linear_algebra/01_cost_of_elimination/elimination.hpp"
#include "chapters/exercise.hpp"
#include "reference/text.hpp"

/// Formulas for costs against counted costs, as claims.
namespace oddity::elimination {

using Table = std::vector<Counts>;

/// Every size to 64, and some beyond; the largest first.
inline Table counted_sizes() {
  Table table;
  for (std::size_t n : {200u, 150u, 100u}) table.push_back(count(n));
  for (std::size_t n = 64; n > 0; --n) table.push_back(count(n));
  return table;
}

struct Formula {
  std::string text;
  std::function<Cost(double n)> cost;
};

/// A cost and what it should be: the formula as printed, what is true if that is not, else a near miss.
struct Law {
  std::string id;
  int line;
  std::string says, left;
  std::function<Cost(const Counts&)> cost;
  Formula printed, corrected, near_miss;
  std::string why = {};
};

inline Reading reading(const Table& table, const Law& law, const Formula& formula) {
  if (!formula.cost) return {};
  Worst worst("coefficients of mu, alpha and delta, against those of " + law.left, law.left, formula.text);
  for (const Counts& c : table) {
    const Cost left = law.cost(c), right = formula.cost(c.n);
    if (c.n > 1)
      worst.see({left.mu, left.alpha, left.delta}, {right.mu, right.alpha, right.delta}, exact(),
                c.n * c.n * c.n, "n = " + shortest(c.n));
  }
  return {formula.text, {worst.check()}};
}

inline Claim claim(const Table& table, const Law& law) {
  Claim claim{law.id, law.line, law.says};
  claim.printed = reading(table, law, law.printed);
  claim.corrected = reading(table, law, law.corrected);
  if (law.near_miss.cost) claim.near_misses = {reading(table, law, law.near_miss)};
  claim.why = law.why;
  return claim;
}

}  // namespace oddity::elimination
