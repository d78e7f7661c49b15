#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "report/text/screen.hpp"

namespace oddity {

/// Help in the screen's width: what an option takes, and what it is for.
std::shared_ptr<CLI::FormatterBase> help_for(const Screen&);

}  // namespace oddity
