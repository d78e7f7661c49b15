#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

/// The cells of a part of a map. Only cells that determine the others' outcomes are computed.
namespace oddity::sweep {

/// Outcome of a cell, or the chosen method, with its error in tolerances and its evaluations.
struct Ended {
  std::string as;
  double error = std::numeric_limits<double>::quiet_NaN();
  double evaluations = std::numeric_limits<double>::quiet_NaN();
};

/// Cells from the first to the last, both included.
struct Cells {
  int first_x, first_y, last_x, last_y;

  int width() const { return last_x - first_x + 1; }
  int height() const { return last_y - first_y + 1; }
};

struct Tile {
  Cells cells;
  std::vector<Ended> ended;  ///< row after row, from below
  std::vector<bool> looked;  ///< computed; the others are between corners with equal outcomes, which they
                             ///< share
  long checked = 0;          ///< one in a thousand of these others, computed nevertheless
  long otherwise = 0;        ///< checked cells with another outcome: the cells around them are then divided
                             ///< further

  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y - cells.first_y) * static_cast<std::size_t>(cells.width()) +
           static_cast<std::size_t>(x - cells.first_x);
  }
};

using Look = std::function<Ended(int x, int y)>;

/// Computes every cell.
Tile all_looked_at(const Cells&, const Look&);
/// Divides into quarters until a quarter's corners have the same outcome, or are next to each other.
Tile quartered(const Cells&, const Look&);

}  // namespace oddity::sweep
