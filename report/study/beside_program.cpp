#include "report/study/beside_program.hpp"

#include <dlfcn.h>

#include "reference/bad_input.hpp"

namespace oddity {

namespace fs = std::filesystem;

std::optional<fs::path> beside_program(const std::string& name) {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& file : {folder / name, folder.parent_path() / name})
    if (fs::exists(file)) return file;
  return std::nullopt;
}

void* function_in(const fs::path& library, const std::string& name) {
  void* loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!loaded) throw BadInput(library.string() + " cannot be loaded: " + dlerror());
  void* function = dlsym(loaded, name.c_str());
  if (!function) throw BadInput(library.string() + " is not of this program: it has no " + name);
  return function;
}

}  // namespace oddity
