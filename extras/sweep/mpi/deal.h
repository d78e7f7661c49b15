#pragma once

/// Between the program and the library that knows MPI.
extern "C" {

/// Returns this process's rank. `next` is called on the first rank alone: the next piece, or -1 when there is
/// none; `work` does a piece, and returns 0, or the exit code that ends all ranks.
int oddity_deal(long (*next)(void* it), int (*work)(void* it, long piece), void* it);
}
