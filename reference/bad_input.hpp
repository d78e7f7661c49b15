#pragma once

#include <stdexcept>

namespace oddity {

/// Input that cannot be used, or a result that cannot be written to the given place. The message states the
/// problem, its place, and the remedy. Exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The user's time limit has passed.
struct OutOfTime : BadInput {
  using BadInput::BadInput;
};

}  // namespace oddity
