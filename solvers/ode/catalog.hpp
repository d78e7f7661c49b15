#pragma once

#include <span>
#include <string_view>

#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

/// An algorithm of the catalog as plain data. The tests measure its order, its evaluations and its limits.
struct CatalogEntry {
  std::string_view name;
  Kind kind;
  int order;  ///< 0: it chooses its order as it goes
  std::string_view library;
  int evaluations;  ///< of the right-hand side, or of the forces, a step; 0: it depends
  bool jacobian;    ///< and a Jacobian, in each step or now and then
  /// The largest h |lambda| at which y' = lambda y does not grow, on the negative real and on the imaginary
  /// axis, by theory: 0: none; infinity: all; NaN: it has no fixed step, or, partitioned, no damping.
  double real_limit, imaginary_limit;
  std::string_view theory;  ///< where the limits come from
  std::string_view remark;  ///< what was found in the library, and how it is repaired
};

/// All algorithms of this build, from the plainest on.
std::span<const CatalogEntry> catalog();

/// The algorithms that this build does without, and why; empty when there are none.
std::string_view not_in_catalog();

}  // namespace oddity::ode
