#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// Shared code of the engines' views: a scene's table and the texts around it.
namespace oddity {

/// By all requested criteria: "3.4 cm, 0.12 deg and 29 % in energy".
std::string error_text(const std::vector<double>& errors, const std::map<Criterion, double>& by,
                       const EngineContest&);

/// The first row names the columns. Each engine has a row for its defaults, and one for its best variant
/// where that is better; or all variants are listed.
std::vector<std::vector<std::string>> rows_of(const EngineContest&, const std::vector<double>& rates,
                                              bool all);
std::string need_text(const EngineContest&);
/// Empty where `choose` has nothing.
std::string least_text(const EngineContest&);
/// "ODE: no joint that ...; Box2D, Chipmunk: ...".
std::string cannot_text(const EngineContest&);

}  // namespace oddity
