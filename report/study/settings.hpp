#pragma once

#include <filesystem>
#include <string>

/// Default places of files. A program that runs from its build uses its tree, and keeps its files in the
/// tree's folder `build`. An installed one uses its prefix, and keeps its files in the user's private cache.
/// Throws BadInput if others could have written a file there. Without a home nothing is kept after the run.
namespace oddity {

std::filesystem::path source_folder();     ///< the tree; empty where the program is installed
std::filesystem::path reference_folder();  ///< the tables
std::filesystem::path results_file();      ///< the last run's results
std::filesystem::path report_folder();     ///< the last report; empty without a home, as the next three
std::filesystem::path site_folder();       ///< the last site
std::filesystem::path chart_folder();      ///< the last charts
std::filesystem::path proofs_folder();     ///< Coq files, and which of them are proved
std::filesystem::path motions_folder();    ///< true motions made at run time, kept
std::filesystem::path prices_folder();     ///< costs of methods on this machine, kept
std::filesystem::path engines_file();      ///< the last results of third-party engines
std::filesystem::path module_file();       ///< the scenes' models, compiled for the page
std::string version();
double seconds_running();  ///< since the program began

/// The requested folder, or the default. Throws BadInput if none is given and there is no home, or if the
/// cache is not private to this user.
std::filesystem::path to_write_to(const std::filesystem::path& folder);
/// Takes a folder for many files; overwrites foreign files only if `overwrite`.
void take_to_write(const std::filesystem::path& folder, bool overwrite);

}  // namespace oddity
