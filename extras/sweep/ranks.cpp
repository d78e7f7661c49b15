#include "extras/sweep/ranks.hpp"

#include <cstdlib>
#include <iostream>

#include "extras/sweep/mpi/deal.h"
#include "reference/bad_input.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity::sweep {

namespace {

struct Work {
  const std::function<std::optional<std::size_t>()>& next;
  const std::function<void(std::size_t)>& work;
};

long next_of(void* it) {
  const auto piece = static_cast<Work*>(it)->next();
  return piece ? static_cast<long>(*piece) : -1;
}

int work_of(void* it, long piece) {
  try {
    static_cast<Work*>(it)->work(static_cast<std::size_t>(piece));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "oddity: " << error.what() << "\n";
    return dynamic_cast<const BadInput*>(&error) ? 2 : 1;
  }
}

}  // namespace

bool under_mpirun() { return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE"); }

bool dealt_by_mpi(const std::function<std::optional<std::size_t>()>& next,
                  const std::function<void(std::size_t)>& work) {
  const auto library = own_library("liboddity_mpi.so");
  if (!library)
    throw BadInput("this program is built without MPI: " + where_to_build() +
                   "'./oddity packages libopenmpi-dev openmpi-bin' installs it, and the next "
                   "'./oddity sweep' is built with it; or have each machine take its share by --shard");
  const auto deal = function_of<decltype(oddity_deal)>(*library, "oddity_deal");
  Work all{next, work};
  return deal(next_of, work_of, &all) == 0;
}

}  // namespace oddity::sweep
