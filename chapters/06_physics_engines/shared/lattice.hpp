#pragma once

#include <string>

#include "chapters/06_physics_engines/shared/bins.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

/// Spheres whose centers and radii are whole 64ths of a bin: every bin is decided in exact integers.
namespace oddity::bins {

__extension__ typedef __int128 Wide;
constexpr long long unit = 64;  ///< parts of a bin

/// A sphere in 64ths of a bin.
struct Lattice {
  std::array<long long, 3> c;
  long long r;

  static constexpr bool whole = true;  // in a claim: what is counted of it
  std::string where() const {
    return "c = (" + std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " + std::to_string(c[2]) +
           ")/64, r = " + std::to_string(r) + "/64";
  }
  Sphere sphere(double h = 1) const {
    const auto part = [h](long long k) { return static_cast<double>(k) * h / unit; };
    return {{part(c[0]), part(c[1]), part(c[2])}, part(r)};
  }
};

inline Wide squared_gap(long long x, int i) {
  const long long low = i * unit, gap = std::max({low - x, 0LL, x - low - unit});
  return static_cast<Wide>(gap) * gap;
}

inline bool hit_exactly(const Lattice& s, const Index& i) {
  return squared_gap(s.c[0], i[0]) + squared_gap(s.c[1], i[1]) + squared_gap(s.c[2], i[2]) <=
         static_cast<Wide>(s.r) * s.r;
}

inline bool box_hit_exactly(const Lattice& s, const Index& i) {
  for (std::size_t a = 0; a < 3; ++a)
    if (s.c[a] + s.r < i[a] * unit || s.c[a] - s.r > (i[a] + 1) * unit) return false;
  return true;
}

template <class Test>
std::vector<long> exact_ids(const Lattice& s, const Grid& grid, const Test& test) {
  std::vector<long> ids;
  for (int i = -grid.half; i < grid.half; ++i)
    for (int j = -grid.half; j < grid.half; ++j)
      for (int k = -grid.half; k < grid.half; ++k)
        if (test(s, Index{i, j, k})) ids.push_back(grid.id({i, j, k}));
  return ids;
}

inline std::vector<Lattice> random_spheres(double seed, int count, int half, double largest) {
  Random random(seed);
  std::vector<Lattice> all;
  for (int n = 0; n < count; ++n) {
    const Point c = random.point(1.2 * half * unit);
    all.push_back({{std::llround(c[0]), std::llround(c[1]), std::llround(c[2])},
                   std::llround(random.between(0, largest * unit))});
  }
  return all;
}

/// Tangent to corners, edges and faces, on boundaries, outside, of negative coordinates, a point, huge.
inline std::vector<Lattice> edge_cases(int half) {
  const long long end = half * unit, huge = 1LL << 40;
  std::vector<Lattice> all{{{3, 4, 12}, 13},
                           {{-3, -4, -12}, 13},
                           {{-3, 4, -12}, 12},
                           {{32, 32, 32}, 32},
                           {{-32, -32, -32}, 32},
                           {{0, 0, 0}, 0},
                           {{64, -64, 32}, 0},
                           {{0, 32, 32}, 1},
                           {{-20, -84, 20}, 8},
                           {{-1, -1, -1}, 0},
                           {{-63, -65, -127}, 1},
                           {{-100, 20, -20}, 36},
                           {{end + 13, 5, 7}, 13},
                           {{end + 13, 5, 7}, 12},
                           {{-end - 5, -end - 12, 9}, 13},
                           {{end + 9, end + 9, end + 9}, 12},
                           {{-end - 64, 0, 0}, 64},
                           {{0, 0, 0}, huge},
                           {{huge, huge, huge}, huge}};
  return all;
}

/// The edge cases and some random spheres.
inline std::vector<Lattice> test_spheres(const Parameters& p) {
  const int half = static_cast<int>(p["half"]);
  std::vector<Lattice> all = edge_cases(half);
  for (const Lattice& s : random_spheres(p["seed"], 40, half, 2 * p["ratio"])) all.push_back(s);
  return all;
}

}  // namespace oddity::bins
