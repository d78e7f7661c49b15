#pragma once

#include <string>
#include <vector>

#include "chapters/expression.hpp"

/// Definite integrals of a recording number, proved in Coq from antiderivatives.
namespace oddity {

/// Integral of f over the letter t, or over t' if f itself contains an integral over t.
template <class F>
Shortened recorded_integral(const F& f, const Shortened& from, const Shortened& to) {
  const auto integrand = [&](const Expression& t) { return Shortened(f(Shortened(t))).expression(); };
  std::string name = "t";
  while (integrand(Expression::letter(name)).coq().find("(fun " + name + " =>") != std::string::npos)
    name += "'";
  return integral(integrand, from.expression(), to.expression(), name);
}

/// Overload under the name that formula::Evaluation finds by argument-dependent lookup.
template <class F>
Shortened integral_over(const F& f, const Shortened& from, const Shortened& to) {
  return recorded_integral(f, from, to);
}

}  // namespace oddity
