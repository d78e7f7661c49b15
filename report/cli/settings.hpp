#pragma once

#include <filesystem>
#include <string>

/// Where things are, unless the command line says otherwise. Set by CMake.
namespace oddity {

std::filesystem::path source_folder();     ///< the tree
std::filesystem::path reference_folder();  ///< the tables
std::filesystem::path records_folder();    ///< what came of the tests that take long
std::filesystem::path results_file();      ///< the last run's results
std::filesystem::path report_folder();     ///< the last report
std::filesystem::path site_folder();       ///< the last report that runs
std::filesystem::path chart_folder();      ///< the last charts
std::filesystem::path motions_folder();    ///< true motions made on the spot, kept
std::filesystem::path proofs_folder();     ///< Coq files, and which of them are proved
std::filesystem::path prices_folder();     ///< what methods cost on this machine, kept
std::filesystem::path engines_folder();    ///< the programs of other people's engines
std::filesystem::path engines_file();      ///< what these did last
std::filesystem::path module_file();       ///< the scenes' models, compiled for the page
std::string version();

}  // namespace oddity
