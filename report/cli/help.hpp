#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "report/text/screen.hpp"

namespace oddity {

/// Help for the screen's width: each option's value and purpose.
std::shared_ptr<CLI::FormatterBase> help_for(const Screen&);

}  // namespace oddity
