#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

/// Solid spheres and a cube of cubic bins. Bin (i, j, k) is the closed box [i h, (i+1) h] x [j h, (j+1) h] x
/// ..., -half <= i, j, k < half. Touching counts as a hit. Spheres whose centers and radii are multiples of
/// 1/64 of a bin are decided in exact integers.
namespace oddity::bins {

using Point = std::array<double, 3>;
using Index = std::array<int, 3>;

struct Sphere {
  Point c;
  double r;
};

struct Grid {
  double h;
  int half;

  long across() const { return 2L * half; }
  long count() const { return across() * across() * across(); }
  long id(const Index& i) const { return ((i[0] + half) * across() + i[1] + half) * across() + i[2] + half; }
};

/// Indices on one axis, both ends included; empty when low > high.
struct Span {
  int low, high;
  long count() const { return std::max(0, high - low + 1); }
};

inline Span all_of(const Grid& grid) { return {-grid.half, grid.half - 1}; }

/// Clamped before the conversion to int, so that it always fits.
inline Span clamped(double low, double high, const Grid& grid) {
  const double n = grid.half;
  return {static_cast<int>(std::clamp(low, -n, n)), static_cast<int>(std::clamp(high, -n - 1, n - 1))};
}

/// The bins that [x - r, x + r] meets, in any number type.
template <class T>
Span reach_of(const T& x, const T& r, const Grid& grid) {
  using std::ceil, std::floor;
  const T side = grid.h;
  return clamped(static_cast<double>(ceil((x - r) / side)) - 1, static_cast<double>(floor((x + r) / side)),
                 grid);
}
inline Span reach(double x, double r, const Grid& grid) { return reach_of(x, r, grid); }

/// A wrong range: floor at both ends misses a bin that ends where the interval begins.
inline Span reach_by_floor(double x, double r, const Grid& grid) {
  return clamped(std::floor((x - r) / grid.h), std::floor((x + r) / grid.h), grid);
}

/// Truncation merges the two bins next to zero, and rounds every negative coordinate the wrong way.
inline Span reach_by_truncation(double x, double r, const Grid& grid) {
  return clamped(std::trunc((x - r) / grid.h), std::trunc((x + r) / grid.h), grid);
}

/// Converted to 32 bits before clamping, as on x86: a value that does not fit becomes the lowest int.
inline Span reach_converted_first(double x, double r, const Grid& grid) {
  const auto convert = [](double y) { return std::abs(y) < 0x1p31 ? y : -0x1p31; };
  return clamped(convert(std::ceil((x - r) / grid.h) - 1), convert(std::floor((x + r) / grid.h)), grid);
}

/// One bin wider on both sides: safe if (i h) / h rounds to less than i.
inline Span reach_widened(double x, double r, const Grid& grid) {
  return clamped(std::ceil((x - r) / grid.h) - 2, std::floor((x + r) / grid.h) + 1, grid);
}

/// The distance from x to bin i on one axis.
inline double gap(double x, int i, double h) { return std::max({i * h - x, 0.0, x - (i + 1) * h}); }

/// Whether the squared distance to the box is at most r^2 (Arvo, Graphics Gems, 1990, p. 335).
inline bool touches(const Sphere& s, const Index& i, double h) {
  double squared = 0;
  for (std::size_t a = 0; a < 3; ++a) squared += gap(s.c[a], i[a], h) * gap(s.c[a], i[a], h);
  return squared <= s.r * s.r;
}

/// An equivalent test with the largest gap moved to the other side: r^2 - d^2 = (r - d)(r + d) does not
/// cancel.
inline bool touches_factored(const Sphere& s, const Index& i, double h) {
  std::array<double, 3> d;
  for (std::size_t a = 0; a < 3; ++a) d[a] = gap(s.c[a], i[a], h);
  std::ranges::sort(d);
  return d[0] * d[0] + d[1] * d[1] <= (s.r - d[2]) * (s.r + d[2]);
}

inline bool always(const Sphere&, const Index&, double) { return true; }

struct Candidates {
  std::vector<long> ids = {};  ///< ascending
  long tests = 0;              ///< sphere-box tests
};

/// Tests every bin of the range.
template <class BroadPhaseRange, class Test>
Candidates hits(const Sphere& s, const Grid& grid, const BroadPhaseRange& range, const Test& test) {
  Candidates found;
  const Span x = range(s.c[0], s.r, grid), y = range(s.c[1], s.r, grid), z = range(s.c[2], s.r, grid);
  for (int i = x.low; i <= x.high; ++i)
    for (int j = y.low; j <= y.high; ++j)
      for (int k = z.low; k <= z.high; ++k) {
        ++found.tests;
        if (test(s, Index{i, j, k}, grid.h)) found.ids.push_back(grid.id({i, j, k}));
      }
  return found;
}

inline Span every_bin(double, double, const Grid& grid) { return all_of(grid); }

/// Row by row, the interval of bins within the sphere, without tests of bins; `tests` counts the rows.
inline Candidates hits_by_rows(const Sphere& s, const Grid& grid) {
  Candidates found;
  const Span x = reach(s.c[0], s.r, grid), y = reach(s.c[1], s.r, grid);
  for (int i = x.low; i <= x.high; ++i)
    for (int j = y.low; j <= y.high; ++j) {
      ++found.tests;
      const double dx = gap(s.c[0], i, grid.h), dy = gap(s.c[1], j, grid.h);
      const double left = s.r * s.r - (dx * dx + dy * dy);
      if (left < 0) continue;
      const Span z = reach(s.c[2], std::sqrt(left), grid);
      for (int k = z.low; k <= z.high; ++k) found.ids.push_back(grid.id({i, j, k}));
    }
  return found;
}

// ---- exact ------------------------------------------------------------------------------------------------

__extension__ typedef __int128 Wide;
constexpr long long unit = 64;  ///< units per bin

/// A sphere in 64ths of a bin.
struct Lattice {
  std::array<long long, 3> c;
  long long r;

  static constexpr bool whole = true;  // the counts of a claim are whole numbers
  std::string where() const {
    return "$c$ = (" + std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " + std::to_string(c[2]) +
           ")/64, $r$ = " + std::to_string(r) + "/64";
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

/// Tangent to corners, edges and faces, on boundaries, outside, with negative coordinates, a point, huge.
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
