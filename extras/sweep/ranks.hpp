#pragma once

#include <cstddef>
#include <functional>
#include <optional>

/// Work dealt out among the ranks of MPI. A separate library uses MPI; it is loaded only if mpirun has
/// started the program.
namespace oddity::sweep {

/// Whether mpirun has started this program.
bool under_mpirun();

/// The first rank takes pieces from `next` and deals them out to all ranks, itself included. Every rank calls
/// `work` with its pieces until none is left. An exception of `work` ends all ranks, with its message.
/// Returns whether this is the first rank. Throws BadInput if the program is built without MPI.
bool dealt_by_mpi(const std::function<std::optional<std::size_t>()>& next,
                  const std::function<void(std::size_t)>& work);

}  // namespace oddity::sweep
