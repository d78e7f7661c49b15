#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "chapters/06_physics_engines/03_moving_spheres/moving_spheres.hpp"

namespace oddity::ex06_03 {

using namespace bins;

Pairs by_all_pairs(const std::vector<Frame>& frames) {
  Pairs found;
  for (const Frame& s : frames) {
    found.begin();
    for (int i = 0; i < static_cast<int>(s.size()); ++i)
      for (int j = 0; j < i; ++j) found.test(s, i, j);
  }
  return found;
}

// ---- bins -------------------------------------------------------------------------------------------------

namespace {

/// The bins that a sphere occupies; spheres outside the grid belong to the bins at the border.
struct Block {
  Index low, high;

  Block(const Sphere& s, const Grid& grid, double margin = 0) {
    const auto inside = [&](double x) {
      return static_cast<int>(std::clamp<double>(x, -grid.half, grid.half - 1));
    };
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = inside(std::ceil((s.c[a] - s.r - margin) / grid.h) - 1);
      high[a] = inside(std::floor((s.c[a] + s.r + margin) / grid.h));
    }
  }
  bool operator==(const Block&) const = default;

  template <class F>
  void each(const F& f) const {
    for (int i = low[0]; i <= high[0]; ++i)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int k = low[2]; k <= high[2]; ++k) f(Index{i, j, k});
  }
};

class Lists {
 public:
  Lists(const Grid& grid, Pairs& found)
      : grid_(grid), found_(found), bins_(static_cast<std::size_t>(grid.count())) {}

  void insert(int n, const Block& block) {
    block.each([&](const Index& i) { ++found_.upkeep, at(i).push_back(n); });
  }
  void remove(int n, const Block& block) {
    block.each([&](const Index& i) { ++found_.upkeep, std::erase(at(i), n); });
  }
  void clear() {
    for (auto& bin : bins_) bin.clear();
  }
  void test(const Frame& s, const std::vector<Block>& blocks) {
    Block(Sphere{{}, std::numeric_limits<double>::infinity()}, grid_).each([&](const Index& i) {
      const std::vector<int>& bin = at(i);
      for (std::size_t a = 0; a < bin.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
          if (least(blocks[static_cast<std::size_t>(bin[a])], blocks[static_cast<std::size_t>(bin[b])]) == i)
            found_.test(s, bin[a], bin[b]);
    });
  }

 private:
  static Index least(const Block& a, const Block& b) {
    return {std::max(a.low[0], b.low[0]), std::max(a.low[1], b.low[1]), std::max(a.low[2], b.low[2])};
  }
  std::vector<int>& at(const Index& i) { return bins_[static_cast<std::size_t>(grid_.id(i))]; }

  Grid grid_;
  Pairs& found_;
  std::vector<std::vector<int>> bins_;
};

std::vector<Block> blocks_of(const Frame& s, const Grid& grid) {
  std::vector<Block> blocks;
  for (const Sphere& sphere : s) blocks.emplace_back(sphere, grid);
  return blocks;
}

bool is_outside(const Sphere& s, const Grid& grid) {
  return std::ranges::any_of(s.c, [&](double x) { return std::abs(x) > grid.half * grid.h; });
}

}  // namespace

Pairs by_bins(const std::vector<Frame>& frames, const Grid& grid, Follow how) {
  Pairs found;
  Lists lists(grid, found);
  std::vector<Block> blocks;
  for (const Frame& s : frames) {
    found.begin();
    std::vector<Block> now = blocks_of(s, grid);
    const bool first = blocks.empty(), rebuilt = how == Follow::rebuilt || how == Follow::rebuilt_inside;
    if (rebuilt) lists.clear();
    for (std::size_t n = 0; n < now.size(); ++n) {
      if (!first && how == Follow::updated && !(now[n] == blocks[n])) {
        lists.remove(static_cast<int>(n), blocks[n]);
        lists.insert(static_cast<int>(n), now[n]);
      }
      if (how == Follow::rebuilt_inside && is_outside(s[n], grid)) continue;
      if (first || rebuilt) lists.insert(static_cast<int>(n), now[n]);
    }
    if (first || how != Follow::never) blocks = std::move(now);
    lists.test(s, blocks);
  }
  return found;
}

Pairs by_center_bins(const std::vector<Frame>& frames, const Grid& grid, bool own_bin_alone) {
  Pairs found;
  for (const Frame& s : frames) {
    found.begin();
    double largest = 0;
    std::vector<std::vector<int>> bins(static_cast<std::size_t>(grid.count()));
    const auto at = [&](const Index& i) -> std::vector<int>& {
      return bins[static_cast<std::size_t>(grid.id(i))];
    };
    for (std::size_t n = 0; n < s.size(); ++n) {
      largest = std::max(largest, s[n].r);
      at(Block({s[n].c, 0}, grid).high).push_back(static_cast<int>(n));
      ++found.upkeep;
    }
    for (std::size_t n = 0; n < s.size(); ++n) {
      Block near(s[n], grid, largest);
      if (own_bin_alone) near.low = near.high = Block({s[n].c, 0}, grid).high;
      near.each([&](const Index& i) {
        for (int other : at(i))
          if (other < static_cast<int>(n)) found.test(s, static_cast<int>(n), other);
      });
    }
  }
  return found;
}

// ---- sweep ------------------------------------------------------------------------------------------------

Pairs by_sweep(const std::vector<Frame>& frames, bool keep_order) {
  Pairs found;
  std::vector<int> order;
  for (const Frame& s : frames) {
    found.begin();
    const auto least = [&](int n) {
      return s[static_cast<std::size_t>(n)].c[0] - s[static_cast<std::size_t>(n)].r;
    };
    const auto before = [&](int a, int b) { return ++found.upkeep, least(a) < least(b); };
    if (order.empty() || !keep_order) {
      order.clear();
      for (std::size_t n = 0; n < s.size(); ++n) order.push_back(static_cast<int>(n));
      std::sort(order.begin(), order.end(), before);
    } else {
      for (std::size_t n = 1; n < order.size(); ++n)
        for (std::size_t k = n; k > 0 && before(order[k], order[k - 1]); --k)
          std::swap(order[k], order[k - 1]);
    }
    std::vector<int> open;
    for (int n : order) {
      std::erase_if(open, [&](int m) {
        ++found.upkeep;
        return s[static_cast<std::size_t>(m)].c[0] + s[static_cast<std::size_t>(m)].r < least(n);
      });
      for (int m : open) found.test(s, n, m);
      open.push_back(n);
    }
  }
  return found;
}

}  // namespace oddity::ex06_03
