#pragma once

#include <filesystem>
#include <string>

/// Where things are, unless the command line says otherwise. A program that runs from its build has its
/// tree's, and keeps its own in the tree's folder `build`; one that is installed has its prefix's, and keeps
/// its own in the user's cache, which is nobody else's: what would be there throws BadInput where others
/// could have written it. Without a home nothing is kept after the run.
namespace oddity {

std::filesystem::path source_folder();     ///< the tree; empty where the program is installed
std::filesystem::path reference_folder();  ///< the tables
std::filesystem::path results_file();      ///< the last run's results
std::filesystem::path report_folder();     ///< the last report; empty without a home, as these four
std::filesystem::path site_folder();       ///< the last report that runs
std::filesystem::path chart_folder();      ///< the last charts
std::filesystem::path proofs_folder();     ///< Coq files, and which of them are proved
std::filesystem::path motions_folder();    ///< true motions made on the spot, kept
std::filesystem::path prices_folder();     ///< what methods cost on this machine, kept
std::filesystem::path engines_file();      ///< what other people's engines did last
std::filesystem::path module_file();       ///< the scenes' models, compiled for the page
std::string version();
double seconds_running();  ///< since this program began

/// The folder that is asked for. Throws BadInput where none is and there is no home, or the cache it is in is
/// not this user's alone.
std::filesystem::path to_write_to(const std::filesystem::path& folder);
/// The same for a folder of many files: those of others are written over only where that is asked for.
void take_to_write(const std::filesystem::path& folder, bool overwrite);

}  // namespace oddity
