#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

/// The cells of a part of a map, of which those are looked at that tell how the others end.
namespace oddity::sweep {

/// How a cell ends: an outcome, or the method that is chosen; with its error in needs and its evaluations.
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
  std::vector<bool> looked;  ///< at; the others lie between corners that end alike, and end so too
  long checked = 0;          ///< of those between: one in a thousand is looked at all the same
  long otherwise = 0;        ///< of those checked: what is around them is then divided further

  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y - cells.first_y) * static_cast<std::size_t>(cells.width()) +
           static_cast<std::size_t>(x - cells.first_x);
  }
};

using Look = std::function<Ended(int x, int y)>;

/// Every cell looked at.
Tile all_looked_at(const Cells&, const Look&);
/// Quartered until the corners of a quarter end alike, or are next to each other.
Tile quartered(const Cells&, const Look&);

}  // namespace oddity::sweep
