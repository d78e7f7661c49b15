#include "report/study/sibling_program.hpp"

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "reference/bad_input.hpp"

namespace oddity {

namespace fs = std::filesystem;

fs::path program_file() {
  std::error_code unreadable;
  fs::path file = fs::read_symlink("/proc/self/exe", unreadable);
  if (unreadable) throw BadInput("/proc is not mounted here, by which a program knows its own file");
  return file;
}

namespace {

fs::path program_folder() { return program_file().parent_path(); }

/// Compares names only, as the kernel reports them: a build path made by somebody else has no effect.
bool in_its_build() {
  const fs::path build = ODDITY_BUILD, here = program_folder();
  return std::mismatch(build.begin(), build.end(), here.begin(), here.end()).first == build.end();
}

fs::path own_prefix() { return program_folder().parent_path(); }

/// A link made by root or by the same user leads to a target that is checked as well. In a folder with the
/// sticky bit, such as /tmp, nobody can replace another user's file.
void require_unwritable(const fs::path& file, mode_t others = S_IWGRP | S_IWOTH) {
  struct stat program {
  }, status{};
  const bool known = stat("/proc/self/exe", &program) == 0 && lstat(file.c_str(), &status) == 0;
  const bool ours = status.st_uid == 0 || status.st_uid == geteuid() || status.st_uid == program.st_uid;
  const bool keeps = S_ISLNK(status.st_mode) || (S_ISDIR(status.st_mode) && (status.st_mode & S_ISVTX));
  if (!known || !ours || (!keeps && (status.st_mode & others)))
    throw BadInput(file.string() +
                   " is not loaded or run: others than root, you and who installed this program " +
                   (ours ? "can write to it" : "own it") + "; install the program again");
}

}  // namespace

fs::path own_tree() { return in_its_build() ? fs::path(ODDITY_SOURCE) : fs::path(); }
fs::path own_data() { return own_prefix() / ODDITY_INSTALLED_DATA; }
fs::path own_code() { return in_its_build() ? fs::path(ODDITY_BUILD) : own_prefix() / ODDITY_INSTALLED_CODE; }

std::string program_as_typed() { return in_its_build() ? "./oddity" : "oddity"; }
std::string where_to_build() { return in_its_build() ? "" : "in a clone of oddity's sources "; }

void require_own(const fs::path& code) {
  if (in_its_build()) return;
  const fs::path folder = code.parent_path();
  require_unwritable(code);
  require_unwritable(folder);
  // Further up, group write is allowed: the group may be the user's own or the administrators'.
  for (fs::path at = folder; at != own_prefix();) require_unwritable(at = at.parent_path(), S_IWOTH);
  if (fs::is_directory(fs::symlink_status(code)))
    for (const auto& entry : fs::recursive_directory_iterator(code)) require_unwritable(entry);
}

std::optional<fs::path> own_library(const std::string& name) {
  const fs::path file = own_code() / name;
  if (!fs::exists(file)) return std::nullopt;
  require_own(file);
  return file;
}

void* function_in(const fs::path& library, const std::string& name) {
  void* loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!loaded) throw BadInput(library.string() + " cannot be loaded: " + dlerror());
  void* function = dlsym(loaded, name.c_str());
  if (!function) throw BadInput(library.string() + " is not of this program: it has no " + name);
  return function;
}

}  // namespace oddity
