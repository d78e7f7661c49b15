#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "extras/sweep/chunks.hpp"
#include "report/text/table_text.hpp"

namespace oddity::sweep {

/// All cells of a sweep, row after row from below.
struct Map {
  Asked asked;
  std::string fingerprint;
  int width = 0, height = 0;
  std::vector<std::string> endings;        ///< in the alphabet's order
  std::vector<std::uint16_t> ended;        ///< index of each cell's ending
  std::vector<double> error, evaluations;  ///< NaN: not computed
  std::vector<std::uint8_t> looked;
  long checked = 0, otherwise = 0;

  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// Merges the chunks of these folders. Each must be in exactly one of them. Throws BadInput, with its name,
/// for a missing folder, a missing or duplicate chunk, and a chunk of another sweep.
Map merged(const Plan&, const std::vector<std::filesystem::path>& folders);

/// "1,000,000 cells, 1.6 % of them looked at; 3 of 985 checked between them ended otherwise".
std::string summary(const Map&);
/// A row for each cell.
Table cells_table(const Map&);
/// An HDF5 file: /ended, /error, /evaluations and /looked by row and column, the endings' names, the axes'
/// numbers, and the question. Throws BadInput if the program is built without HDF5.
void write_hdf5(const Map&, const std::filesystem::path& file);

enum class Shown { outcome, error, cost };
/// A picture as SVG text: the first axis across, the second upward.
std::string picture(const Map&, Shown);

}  // namespace oddity::sweep
