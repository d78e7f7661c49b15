#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/study/run.hpp"

/// What the compiler does not see: values are handed on by their places, and without their units.
namespace oddity {

/// The letters of `struct Given` in the text of a models.hpp that are names of these parameters, those of
/// arrays numbered, and stand in another order: "L2 before L1"; empty where there are none.
std::string exchanged_letters(std::string_view models, std::span<const Parameter>);

/// The same of the exercise's models.hpp, if it has one.
std::string exchanged_letters(const Entry&);

/// The parameters on which nothing hangs: neither the scene's motion nor a claim nor a quantity.
std::vector<std::string> unused_parameters(const Entry&, const Reference&);

/// The quantities whose unit measures what their table's does, by other numbers: "height is in cm, its table
/// 20_02_ball in m".
std::vector<std::string> other_units(const Entry&, const Findings&);

}  // namespace oddity
