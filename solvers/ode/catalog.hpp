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
};

/// What was found in a library, and what is done about it here. tests/libraries/<shown_by>.cpp is a small
/// program that shows it by the library alone, and checks each number that `found` states.
struct Finding {
  std::string_view library, version;  ///< the version that it was found in
  std::string_view in;                ///< the library's own name for it
  std::string_view shown_by;
  std::string_view found, done;
};

std::span<const Finding> findings();

/// All algorithms of this build, from the plainest on.
std::span<const CatalogEntry> catalog();

/// The algorithms that this build does without, and why; empty when there are none.
std::string_view not_in_catalog();

}  // namespace oddity::ode
