#include <stdexcept>
#include <string>

#include "solvers/ode/all.hpp"

namespace oddity::ode {

template <std::size_t n>
Integrate<n>& precompiled(std::string_view algorithm) {
  Integrate<n>* found = nullptr;
  for_each_algorithm([&]<class Algorithm>() {
    if (Algorithm::name == algorithm) found = &integrate_precompiled<Algorithm, n>;
  });
  if (!found) throw std::logic_error("there is no algorithm " + std::string(algorithm));
  return *found;
}

#define ODDITY_BY_NAME(n, type) template type<n>& precompiled<n>(std::string_view);
ODDITY_FOR_UNKNOWNS(ODDITY_BY_NAME, Integrate)

}  // namespace oddity::ode
