#pragma once

#include <span>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"

/// The algorithms of this build as data, and the defects found in their libraries.
///
///   for (const CatalogEntry& a : catalog())
///     if (a.kind == Kind::fixed) std::cout << a.name << " " << a.order << " " << a.imaginary_limit << "\n";
namespace oddity::ode {

/// An algorithm of the catalog as plain data.
struct CatalogEntry : Facts {
  std::string_view name;
  Kind kind;
  int order;  ///< 0: chosen at run time
};

/// A defect found in a library, and our remedy. tests/libraries/<shown_by>.cpp is a small program that
/// demonstrates it with the library alone, and checks each number that `found` states.
struct Finding {
  std::string_view library, version;  ///< the version in which it was found
  std::string_view in;                ///< the library's own name for it
  std::string_view shown_by;
  std::string_view found, done;
};

std::span<const Finding> findings();

/// All algorithms of this build, simplest first.
std::span<const CatalogEntry> catalog();

/// Meaning of "evaluations" for an algorithm that makes none.
inline constexpr std::string_view work_of_series =
    "Taylor series evaluate nothing: the right-hand side is recorded once, and its operations are made on series. Their "
    "evaluations are the operations made, over those of the right-hand side written by hand. An addition or a "
    "multiplication counts as 1, a division or a root as 4, a sine or an exponential as 8, as the Livermore loops "
    "weigh them.";

/// The algorithms not available in this build, and why; empty if all are.
std::string_view not_in_catalog();

}  // namespace oddity::ode
