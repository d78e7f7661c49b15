#include "report/cli/settings.hpp"

namespace oddity {

namespace fs = std::filesystem;

fs::path source_folder() { return ODDITY_SOURCE; }
fs::path reference_folder() { return source_folder() / "reference"; }
fs::path results_file() { return fs::path(ODDITY_SOURCE) / "build" / "results.json"; }
fs::path report_folder() { return fs::path(ODDITY_SOURCE) / "build" / "report"; }
fs::path chart_folder() { return fs::path(ODDITY_SOURCE) / "build" / "charts"; }
fs::path motions_folder() { return fs::path(ODDITY_SOURCE) / "build" / "motions"; }
fs::path prices_folder() { return fs::path(ODDITY_SOURCE) / "build" / "prices"; }
std::string gnuplot() { return ODDITY_GNUPLOT; }
std::string version() { return ODDITY_VERSION; }

}  // namespace oddity
