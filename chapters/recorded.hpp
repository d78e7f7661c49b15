#pragma once

#include <functional>
#include <string>
#include <utility>

#include "chapters/claims.hpp"
#include "chapters/provable.hpp"

namespace oddity {

inline Expressions expressions(const Expression& x) { return {x}; }
template <class Range>
Expressions expressions(const Range& all) {
  return {all.begin(), all.end()};
}

/// A formula in the letters of a sample that is generic in its number type: computed in double, and recorded
/// for proofs.
template <template <class> class Sample>
struct Recorded {
  std::string text;
  std::function<Value(const Sample<double>&)> of;
  std::function<Expressions(const Sample<Expression>&)> recorded;
  std::function<double(const Sample<double>&)> terms = {};

  operator Formula<Sample<double>>() const { return {text, of, terms}; }
};

/// Of a function that takes both.
template <template <class> class Sample, class F>
Recorded<Sample> recorded(std::string text, const F& of) {
  return {std::move(text), of, [of](const Sample<Expression>& s) { return expressions(of(s)); }};
}

}  // namespace oddity
