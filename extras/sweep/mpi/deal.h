#pragma once

/// Interface between the program and the library that uses MPI.
extern "C" {

/// Returns this process's rank. `next` is called only on the first rank and returns the next piece, or -1
/// after the last. `work` does a piece, and returns 0, or the exit code that ends all ranks.
int oddity_deal(long (*next)(void* it), int (*work)(void* it, long piece), void* it);
}
