#include "report/cli/settings.hpp"

#include <cstdlib>

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The tables that were installed with this program, beside it; empty for one that was not installed.
fs::path installed_tables() {
  std::error_code unreadable;
  const fs::path program = fs::read_symlink("/proc/self/exe", unreadable);
  const fs::path tables = (program.parent_path() / ODDITY_INSTALLED_TABLES).lexically_normal();
  return !unreadable && fs::is_directory(tables) ? tables : fs::path();
}

/// Where the user's programs keep what they can make again.
fs::path cache() {
  if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder && *folder) return folder;
  const char* home = std::getenv("HOME");
  return home && *home ? fs::path(home) / ".cache" : fs::temp_directory_path();
}

/// Where results and what is made of them are kept.
fs::path kept() {
  return installed_tables().empty() ? fs::path(ODDITY_SOURCE) / "build" : cache() / "oddity";
}

}  // namespace

fs::path source_folder() { return ODDITY_SOURCE; }
fs::path reference_folder() {
  const fs::path installed = installed_tables();
  return installed.empty() ? source_folder() / "reference" : installed;
}
fs::path records_folder() { return reference_folder().parent_path() / "tests"; }
fs::path results_file() { return kept() / "results.json"; }
fs::path report_folder() { return kept() / "report"; }
fs::path site_folder() { return kept() / "site"; }
fs::path chart_folder() { return kept() / "charts"; }
fs::path motions_folder() { return kept() / "motions"; }
fs::path proofs_folder() { return kept() / "proofs"; }
fs::path prices_folder() { return kept() / "prices"; }
fs::path engines_folder() { return fs::read_symlink("/proc/self/exe").parent_path() / "engines"; }
fs::path engines_file() { return kept() / "engines.json"; }
fs::path module_file() {
  const fs::path installed = installed_tables();
  return installed.empty() ? fs::path(ODDITY_MODULE) : installed.parent_path() / "models.js";
}
std::string version() { return ODDITY_VERSION; }

}  // namespace oddity
