#pragma once

#include "report/study/choose.hpp"

/// Choices whose bits are the same by every compiler and on every processor.
namespace oddity {

/// The need, such that only methods are taken that have a program in lockstep. Throws BadInput, with what the
/// others call, where none of those that it allows has. The task must outlive the result.
Need in_lockstep(Need, const Task&);

/// What the choice's program has of its own, what its steps take in those of the usual program, and what was
/// left out. Both programs are compiled and run here; where no compiler is, or these seconds are not enough,
/// it says so.
InLockstep lockstep_of(const Task&, const Choice&, double seconds);

}  // namespace oddity
