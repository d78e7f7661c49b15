#pragma once

#include <stdexcept>

namespace oddity {

/// What was given cannot be used, or the result cannot be put where it was asked for: the message says what,
/// where, and what would be right. Exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The time that the user gave is over.
struct OutOfTime : BadInput {
  using BadInput::BadInput;
};

}  // namespace oddity
