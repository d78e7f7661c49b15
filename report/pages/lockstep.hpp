#pragma once

#include "report/study/choose.hpp"

/// Choices with the same bits for every compiler and processor.
namespace oddity {

/// The need, restricted to methods that have a program in lockstep. Throws BadInput with the reasons if none
/// has. The task must outlive the result.
Need in_lockstep(Need, const Task&);

/// The program's elementary functions, its time relative to the usual program, and the methods left out.
/// Compiles and runs both programs; `measured` gives the reason if that was not possible.
InLockstep lockstep_of(const Task&, const Choice&, double seconds);

}  // namespace oddity
