#pragma once

#include <cstddef>
#include <vector>

#include "chapters/03_rigid_body_motion/25_chain/models.hpp"
#include "chapters/exercise.hpp"

/// Exercise 3.25's methods and claims.
namespace oddity::ex03_25 {

using Triple = chain::Given<double>;

template <class Lengths>
Lengths mass_from_here_on(Lengths m) {
  for (std::size_t k = m.size() - 1; k-- > 0;) m[k] += m[k + 1];
  return m;
}

/// n links with masses, lengths, angles and speeds in dyadic patterns.
struct Pattern {
  std::vector<double> m, r, theta, omega;

  explicit Pattern(int n) {
    for (int k = 0; k < n; ++k) {
      m.push_back(1 + k % 4 / 4.0);
      r.push_back(1 + k % 3 / 4.0);
      theta.push_back(k * 37 % 64 / 32.0 - 1);
      omega.push_back(k * 29 % 64 / 32.0 - 1);
    }
  }
};

Quantity hanging(const Triple&, const Horizon&, const Reference&);
std::vector<Quantity> quantities(const Triple&, const Reference&);
std::vector<Claim> claims(double seed);
Provables proofs();

}  // namespace oddity::ex03_25
