#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// What the views of engines share: a scene's table, and what stands around it.
namespace oddity {

/// By all criteria asked for: "3.4 cm, 0.12 deg and 29 % of its energy".
std::string error_text(const std::vector<double>& errors, const std::map<Criterion, double>& by,
                       const EngineContest&);

/// The first row names the columns. Of each engine stand its defaults, and what is best beside them where
/// that is better; or all variants.
std::vector<std::vector<std::string>> rows_of(const EngineContest&, const std::vector<double>& rates,
                                              bool all);
std::string need_text(const EngineContest&);
/// Empty where `choose` has nothing.
std::string least_text(const EngineContest&);
/// "ODE: no joint that ...; Box2D, Chipmunk: ...".
std::string cannot_text(const EngineContest&);

}  // namespace oddity
