#pragma once

#include "reference/truth.hpp"

/// Tools shared by several tables.
namespace oddity::truth {

Number pi();

/// The complete elliptic integral of the first kind, K(k), by the arithmetic-geometric mean [DLMF 19.8.5].
/// Throws std::domain_error unless |k| < 1.
Number elliptic_k(const Number& k);

/// Jacobi's elliptic function cd(u, k).
Number jacobi_cd(const Number& k, const Number& u);

/// cos(pi x) and sin(pi x).
Number cos_pi(const Number& x);
Number sin_pi(const Number& x);

#ifndef ODDITY_BALLS
/// A sum whose omitted terms are at most `rest`; a ball is widened by it.
inline Number within(const Number& sum, const Number& rest) {
  static_cast<void>(rest);
  return sum;
}
/// A root that lies between the two; as a ball, everything between them.
inline Number between(const Number& low, const Number& high) { return (low + high) / 2; }
#endif

/// The integral of f over [a, b] by double-exponential quadrature; f is never called at a or b, and may be
/// infinite there.
Number integral(const std::function<Number(const Number&)>& f, const Number& a, const Number& b, int digits);

}  // namespace oddity::truth
