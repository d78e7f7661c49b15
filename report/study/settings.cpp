#include "report/study/settings.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

const auto began = std::chrono::steady_clock::now();

/// The folder that a variable names. Ignores a relative one, which would depend on the working directory.
fs::path named_by(const char* variable) {
  const char* text = std::getenv(variable);
  const fs::path folder = text ? text : "";
  return folder.is_absolute() ? folder : fs::path();
}

/// Folder for reproducible files of an installed program; empty without a home.
fs::path cache() {
  if (const fs::path caches = named_by("XDG_CACHE_HOME"); !caches.empty()) return caches / "oddity";
  const fs::path home = named_by("HOME");
  return home.empty() ? home : home / ".cache" / "oddity";
}

/// Folder or file that lasts beyond the run; empty without a home.
fs::path lasting(const std::string& name) {
  const fs::path folder = own_tree().empty() ? cache() : own_tree() / "build";
  return folder.empty() ? folder : folder / name;
}

fs::path kept(const std::string& name) {
  const fs::path file = lasting(name);
  if (file.empty()) {
    static const PassingFolder of_this_run;
    return of_this_run / name;
  }
  if (own_tree().empty()) require_private(file.parent_path(), file.filename());
  return file;
}

/// Whether it is one of the program's default folders.
bool is_usual(const fs::path& folder) {
  const std::array own{report_folder(), site_folder(), chart_folder(), proofs_folder()};
  return std::ranges::find(own, folder) != own.end();
}

}  // namespace

fs::path source_folder() { return own_tree(); }
fs::path reference_folder() { return (own_tree().empty() ? own_data() : own_tree()) / "reference"; }
fs::path results_file() { return kept("results.json"); }
fs::path report_folder() { return lasting("report"); }
fs::path site_folder() { return lasting("site"); }
fs::path chart_folder() { return lasting("charts"); }
fs::path proofs_folder() { return lasting("proofs"); }
fs::path motions_folder() { return kept("motions"); }
fs::path prices_folder() { return kept("prices"); }
fs::path engines_file() { return kept("engines.json"); }
fs::path module_file() { return (own_tree().empty() ? own_data() : own_code()) / "models.js"; }
double seconds_running() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}
std::string version() { return ODDITY_VERSION; }

fs::path to_write_to(const fs::path& folder) {
  if (folder.empty())
    throw BadInput("there is no folder to write to, as HOME names none; --out names another");
  if (is_usual(folder)) kept(folder.filename());
  return folder;
}

void take_to_write(const fs::path& folder, bool overwrite) {
  if (!is_usual(to_write_to(folder))) take_folder(folder, overwrite);
}

}  // namespace oddity
