#include "report/sweep/ranks.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "reference/bad_input.hpp"
#include "report/sweep/mpi/deal.h"

namespace oddity::sweep {

namespace {

/// Beside the program.
std::filesystem::path library() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "liboddity_mpi.so";
}

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
  if (!std::filesystem::exists(library()))
    throw BadInput(
        "this program is built without MPI: './oddity sweep' installs it and builds with it, or have "
        "each machine take its share by --shard");
  void* loaded = dlopen(library().c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!loaded) throw BadInput("MPI cannot be used: " + std::string(dlerror()));
  const auto deal = reinterpret_cast<decltype(&oddity_deal)>(dlsym(loaded, "oddity_deal"));
  if (!deal) throw BadInput(library().string() + " is not of this program");
  Work all{next, work};
  return deal(next_of, work_of, &all) == 0;
}

}  // namespace oddity::sweep
