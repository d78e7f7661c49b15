#pragma once

#include "reference/truth.hpp"

/// Tools that several tables are made with.
namespace oddity::truth {

Number pi();

/// The complete elliptic integral of the first kind, K(k), by the arithmetic-geometric mean [DLMF 19.8.5].
/// Throws std::domain_error unless |k| < 1.
Number elliptic_k(const Number& k);

/// The integral of f over [a, b] by double-exponential quadrature; f is never called at a or b, and may be
/// infinite there.
Number integral(const std::function<Number(const Number&)>& f, const Number& a, const Number& b, int digits);

}  // namespace oddity::truth
