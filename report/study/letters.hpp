#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/study/run.hpp"

/// Finds errors that the compiler misses: values are passed by position, and without units.
namespace oddity {

/// Letters of `struct Given` in the text of a models.hpp that name these parameters (arrays numbered) and
/// come in another order: "L2 before L1"; otherwise empty.
std::string exchanged_letters(std::string_view models, std::span<const Parameter>);

/// Letters of the exercise's models.hpp in another order; empty without such a file.
std::string exchanged_letters(const Entry&);

/// The parameters that neither the scene's motion nor a claim nor a quantity depends on.
std::vector<std::string> unused_parameters(const Entry&, const Reference&);

/// The quantities whose unit measures the same as their table's by other numbers: "height is in cm, its table
/// 20_02_ball in m".
std::vector<std::string> other_units(const Entry&, const Findings&);

}  // namespace oddity
