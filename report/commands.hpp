#pragma once

namespace oddity {

/// The command line. Returns the exit code: 0 green, 1 a red suite, 2 bad input.
int command_line(int argc, char** argv);

}  // namespace oddity
