#pragma once

#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// Texts about engines.
namespace oddity {

/// "3.4 cm, 0.12 deg": errors in units that a reader can picture.
std::string pictured(const std::vector<double>& errors, const std::vector<std::string>& units);
/// Two digits of a part of a whole; "0" below a millionth, empty for NaN.
std::string in_percent(double part);
/// "Bullet, 100 iterations"; with a star for an engine in WebAssembly.
std::string full_name(const EngineSeries&);

}  // namespace oddity
