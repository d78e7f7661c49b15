#include "extras/sweep/tile.hpp"

#include <cstdint>
#include <numeric>

namespace oddity::sweep {

namespace {

Tile blank(const Cells& cells) {
  const auto count = static_cast<std::size_t>(cells.width()) * static_cast<std::size_t>(cells.height());
  return {cells, std::vector<Ended>(count), std::vector<bool>(count)};
}

/// One cell in a thousand, the same ones for every caller [Steele, Lea and Flood's mixing of bits, 2014].
bool is_checked(int x, int y) {
  std::uint64_t bits = static_cast<std::uint64_t>(x) << 32 | static_cast<std::uint32_t>(y);
  bits = (bits + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return (bits ^ (bits >> 31)) % 1000 == 0;
}

class Quartering {
 public:
  Quartering(const Cells& cells, const Look& look)
      : tile_(blank(cells)), look_(look), taken_for_granted_(tile_.ended.size()) {
    refine(cells, false);
  }

  Tile tile() && { return std::move(tile_); }

 private:
  const std::string& look_at(int x, int y) {
    const std::size_t place = tile_.place(x, y);
    if (!tile_.looked[place]) {
      tile_.ended[place] = look_(x, y);
      tile_.looked[place] = true;
    }
    return tile_.ended[place].as;
  }

  /// Outcome of a corner; `closely`: computed even if it has been guessed.
  std::string ending(int x, int y, bool closely) {
    const std::size_t place = tile_.place(x, y);
    return taken_for_granted_[place] && !closely ? tile_.ended[place].as : look_at(x, y);
  }

  /// Guesses that the middle of a short line ends like the line's ends, if these are equal.
  void take_for_granted(int x, int y, const std::string& one_end, const std::string& other_end, int length) {
    constexpr int short_line = 4;
    const std::size_t place = tile_.place(x, y);
    if (length > short_line || one_end != other_end || tile_.looked[place]) return;
    tile_.ended[place].as = one_end;
    taken_for_granted_[place] = true;
  }

  void refine(const Cells& c, bool closely) {
    const std::string lower_left = ending(c.first_x, c.first_y, closely),
                      lower_right = ending(c.last_x, c.first_y, closely),
                      upper_left = ending(c.first_x, c.last_y, closely),
                      upper_right = ending(c.last_x, c.last_y, closely);
    if (c.width() <= 2 && c.height() <= 2) return;
    if (lower_left == lower_right && lower_left == upper_left && lower_left == upper_right) {
      if (all_end(c, lower_left)) return;
      closely = true;
    }
    const int x = std::midpoint(c.first_x, c.last_x), y = std::midpoint(c.first_y, c.last_y);
    if (!closely) {
      take_for_granted(x, c.first_y, lower_left, lower_right, c.width() - 1);
      take_for_granted(x, c.last_y, upper_left, upper_right, c.width() - 1);
      take_for_granted(c.first_x, y, lower_left, upper_left, c.height() - 1);
      take_for_granted(c.last_x, y, lower_right, upper_right, c.height() - 1);
    }
    quarter(c, x, y, closely);
  }

  /// Refines the quarters, which share the lines between them.
  void quarter(const Cells& c, int x, int y, bool closely) {
    const bool across = c.width() > 2, upward = c.height() > 2;
    const int last_x = across ? x : c.last_x, last_y = upward ? y : c.last_y;
    refine({c.first_x, c.first_y, last_x, last_y}, closely);
    if (across) refine({x, c.first_y, c.last_x, last_y}, closely);
    if (upward) refine({c.first_x, y, last_x, c.last_y}, closely);
    if (across && upward) refine({x, y, c.last_x, c.last_y}, closely);
  }

  /// Gives all cells between this outcome; false if a known one has another.
  bool all_end(const Cells& c, const std::string& as) {
    for (int y = c.first_y; y <= c.last_y; ++y)
      for (int x = c.first_x; x <= c.last_x; ++x) {
        const std::size_t place = tile_.place(x, y);
        if (tile_.looked[place]) {
          if (tile_.ended[place].as != as) return false;
          continue;
        }
        tile_.ended[place].as = as;
        if (!is_checked(x, y)) continue;
        ++tile_.checked;
        if (look_at(x, y) == as) continue;
        ++tile_.otherwise;
        return false;
      }
    return true;
  }

  Tile tile_;
  const Look& look_;
  std::vector<bool> taken_for_granted_;
};

}  // namespace

Tile all_looked_at(const Cells& cells, const Look& look) {
  Tile tile = blank(cells);
  for (int y = cells.first_y; y <= cells.last_y; ++y)
    for (int x = cells.first_x; x <= cells.last_x; ++x) {
      tile.ended[tile.place(x, y)] = look(x, y);
      tile.looked[tile.place(x, y)] = true;
    }
  return tile;
}

Tile quartered(const Cells& cells, const Look& look) { return Quartering(cells, look).tile(); }

}  // namespace oddity::sweep
