#pragma once

#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// What the views of engines share: a scene's table, and what stands around it.
namespace oddity {

/// Two digits, without an exponent where people do without one: "0.12", "350".
std::string two_digits(double);
/// "3.4 cm, 0.12 deg": of errors in the motion's units, what a reader can picture.
std::string pictured(const std::vector<double>& errors, const std::vector<std::string>& units);
/// Two digits of a part of a whole; "0" below a millionth, empty where there is none.
std::string in_percent(double part);
/// "Bullet, 100 iterations"; with a star for what is behind WebAssembly.
std::string full_name(const EngineSeries&);

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
