#pragma once

namespace oddity {

/// Moves the code of the program and of the libraries beside it to other pages of memory, at the addresses
/// that it has; for as long as no other thread runs. On one machine a loop in one of 400 took three times
/// its time for the pages that its file happened to lie on, and its usual time from any copy of the file:
/// what is timed in rounds should lie elsewhere in each. Where the system does not allow it, code stays.
void move_code_to_fresh_pages();

}  // namespace oddity
