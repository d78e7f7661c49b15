#include "reference/make/recorded.hpp"

namespace oddity::truth {

void Recorded::expand(const Numbers& x, const Number& t, int order) {
  tape.resize(order);
  for (std::size_t i = 0; i < x.size(); ++i) tape.set(unknowns[i], 0, x[i]);
  tape.set(time, 0, t);
  tape.set(time, 1, 1);
  for (int k = 0; k < order; ++k) {
    tape.advance(k);
    for (std::size_t i = 0; i < x.size(); ++i)
      tape.set(unknowns[i], k + 1, tape.get(derivatives[i], k) / (k + 1));
  }
}

std::vector<Numbers> Recorded::series() const {
  std::vector<Numbers> all;
  for (int unknown : unknowns) all.push_back(tape.series(unknown));
  return all;
}

}  // namespace oddity::truth
