#include "solvers/ode/in_float.hpp"

#include <stdexcept>

#include "solvers/ode/all.hpp"
#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode {

namespace {

template <class Algorithm, std::size_t n>
Trajectory<std::array<float, n>> integrate_in_float(const AnySystem<n, float>& system,
                                                    const std::array<float, n>& start,
                                                    std::span<const double> times, double step) {
  if constexpr (Algorithm::kind == Kind::partitioned && n % 2 == 1)
    throw std::logic_error("an odd number of unknowns cannot be partitioned");
  else
    return integrate_inlined<Algorithm>(system, start, times, step);
}

}  // namespace

template <std::size_t n>
IntegrateInFloat<n>* in_float(std::string_view algorithm) {
  IntegrateInFloat<n>* found = nullptr;
  for_each_algorithm([&]<class Algorithm>() {
    if constexpr (Algorithm::facts.in_float)
      if (Algorithm::name == algorithm) found = &integrate_in_float<Algorithm, n>;
  });
  return found;
}

#define ODDITY_IN_FLOAT(n, type) template type<n>* in_float<n>(std::string_view);
ODDITY_FOR_UNKNOWNS(ODDITY_IN_FLOAT, IntegrateInFloat)

}  // namespace oddity::ode
