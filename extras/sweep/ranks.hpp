#pragma once

#include <cstddef>
#include <functional>
#include <optional>

/// Work dealt out among the ranks of MPI. What knows MPI is a library of its own, which is loaded only where
/// mpirun has started the program.
namespace oddity::sweep {

/// Whether mpirun has started this program.
bool under_mpirun();

/// The first rank asks `next` for pieces and deals them out to all that ask, itself included; every rank
/// calls `work` with what it gets, until nothing is left. What `work` throws ends all ranks, with its
/// message. Returns whether this is the first rank. Throws BadInput where the program is built without MPI.
bool dealt_by_mpi(const std::function<std::optional<std::size_t>()>& next,
                  const std::function<void(std::size_t)>& work);

}  // namespace oddity::sweep
