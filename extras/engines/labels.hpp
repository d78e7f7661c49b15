#pragma once

#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// How what engines do is written.
namespace oddity {

/// "3.4 cm, 0.12 deg": of errors in the motion's units, what a reader can picture.
std::string pictured(const std::vector<double>& errors, const std::vector<std::string>& units);
/// Two digits of a part of a whole; "0" below a millionth, empty where there is none.
std::string in_percent(double part);
/// "Bullet, 100 iterations"; with a star for what is behind WebAssembly.
std::string full_name(const EngineSeries&);

}  // namespace oddity
