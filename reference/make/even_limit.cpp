#include "reference/make/even_limit.hpp"

#include <algorithm>
#include <stdexcept>

namespace oddity::truth {

Numbers even_limit(const std::function<Numbers(const Number& h)>& f, int digits) {
  constexpr int columns = 16;
  const Number tolerance = pow(Number(10), -digits - 1);
  std::vector<Numbers> row;
  for (int k = 0; k < columns; ++k) {
    std::vector<Numbers> next{f(Number(ldexp(Number(1), -5 - k)))};
    for (int j = 1; j <= k; ++j) {
      Numbers better = next.back();
      for (std::size_t i = 0; i < better.size(); ++i)
        better[i] += (better[i] - row[static_cast<std::size_t>(j - 1)][i]) / (ldexp(Number(1), 2 * j) - 1);
      next.push_back(std::move(better));
    }
    if (k > 2) {
      Number change = 0;
      for (std::size_t i = 0; i < next.back().size(); ++i)
        change = std::max<Number>(change, abs(next.back()[i] - row.back()[i]));
      if (change <= tolerance) return next.back();
    }
    row = std::move(next);
  }
  throw std::runtime_error("the extrapolation of a difference does not settle");
}

}  // namespace oddity::truth
