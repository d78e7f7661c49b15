#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "chapters/exercise.hpp"
#include "reference/text.hpp"

/// What the exercises of this chapter share: an identity over many samples, and a limit at zero.
namespace oddity::identities {

/// Both sides of an identity at one sample. `scale`: the size of the terms that were added up; 0: the larger
/// side.
struct Sides {
  Value left, right;
  double scale = 0;
};

/// A lambda passed for it is no obstacle to deducing Sample.
template <class... Arguments>
using SidesOf = std::type_identity_t<std::function<Sides(Arguments...)>>;

/// The identity sides(sample) over all samples, each of which says where() it is.
template <class Sample>
Check compare(std::string quantity, std::string left, std::string right, const std::vector<Sample>& samples,
              const SidesOf<const Sample&>& sides, double ulps = 64) {
  Worst worst(std::move(quantity), std::move(left), std::move(right), ulps);
  for (const Sample& sample : samples) {
    const Sides both = sides(sample);
    const double larger = std::max(size_of(both.left), size_of(both.right));
    worst.see(both.left, both.right, both.scale > 0 ? both.scale : larger, sample.where());
  }
  return worst.check();
}

/// What the text says, sides(sample).left, against another route, sides(sample).right.
template <class Sample>
Reading reading(std::string text, std::string quantity, std::string route, const std::vector<Sample>& samples,
                const SidesOf<const Sample&>& sides) {
  quantity += ", against " + route;
  return {std::move(text), {compare(std::move(quantity), "the text", std::move(route), samples, sides)}};
}

/// A claim with its printed reading and the near misses alone.
inline Claim claim(std::string id, int line, std::string says, Reading printed,
                   std::vector<Reading> near_misses) {
  return {std::move(id), line, std::move(says), std::move(printed), {}, {}, std::move(near_misses)};
}

/// A formula with a number k in it, sides(sample, k), as a claim: `k` as printed, `near` in the near miss.
template <class Sample>
Claim formula(std::string id, int line, std::string says, const std::string& quantity,
              const std::string& route, const std::vector<Sample>& samples, double k, double near,
              const SidesOf<const Sample&, double>& sides) {
  const auto with = [&](std::string text, double number) {
    return reading(std::move(text), quantity, route, samples,
                   [&](const Sample& sample) { return sides(sample, number); });
  };
  const std::string miss = near == -k  ? "a sign flipped"
                           : near == 0 ? "a term dropped"
                                       : shortest(near) + " in the place of " + shortest(k);
  return claim(std::move(id), line, std::move(says), with("as printed", k), {with(miss, near)});
}

/// All numbers in a row.
template <class... Parts>
Value joined(const Parts&... parts) {
  std::vector<double> all;
  const auto append = [&](const Value& part) { all.insert(all.end(), part.begin(), part.end()); };
  (append(Value(parts)), ...);
  return Value(std::move(all));
}

/// The limit of f(h), h -> 0, from f(h), f(h/2), ..., by Richardson's extrapolation in all powers of h.
/// `error_estimate` is the last change, and the roundings that the extrapolation's weights (sum of sizes
/// below 9) let through.
template <class F>
Solved<Value> limit_at_zero(const F& f, double h, int halvings) {
  Solved<Value> limit;
  std::vector<Value> row;
  for (int k = 0; k <= halvings; ++k) {
    std::vector<Value> next{f(std::ldexp(h, -k))};
    ++limit.evaluations;
    for (int j = 1; j <= k; ++j) {
      Value better = next.back();
      for (std::size_t i = 0; i < better.size(); ++i)
        better[i] += (better[i] - row[static_cast<std::size_t>(j - 1)][i]) / (std::ldexp(1.0, j) - 1);
      next.push_back(std::move(better));
    }
    if (k > 0)
      limit.error_estimate = distance(next.back(), row.back()) + 9 * 8 * 0x1p-52 * size_of(next.front());
    row = std::move(next);
  }
  limit.value = row.back();
  return limit;
}

/// What the text says is the limit of f(h), h -> 0, against Richardson's extrapolation from the distance h.
template <class F>
Check limit(std::string what, const Value& said, double h, const F& f) {
  const auto found = limit_at_zero([&](double x) { return Value(f(x)); }, h, 10);
  return {std::move(what),
          {"Richardson's extrapolation", found.value},
          {"the text", said},
          {found.error_estimate + 1e-15, "the extrapolation's error estimate, and one rounding"},
          1};
}

}  // namespace oddity::identities
