#include "report/site/players.hpp"

namespace oddity {

std::string module_source() { return {}; }

std::optional<std::string> module_script() { return {}; }

}  // namespace oddity
