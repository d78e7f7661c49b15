#pragma once

namespace oddity {

/// Moves the code of the program and of its libraries to other pages of memory, at the same addresses. No
/// other thread may run meanwhile. On one machine a loop in one of 400 took three times as long because of
/// the pages on which its file happened to be. From any copy of the file it took its usual time. So timed
/// code should be on other pages in each round. Does nothing where the system does not allow it.
void move_code_to_fresh_pages();

}  // namespace oddity
