#pragma once

#include "chapters/06_physics_engines/shared/lattice.hpp"

/// What the bins are for: the objects near a sphere, without a look at all of them.
namespace oddity::bins {

constexpr int world = 16;  ///< the world's side

/// Objects sorted into bins.
struct Filled {
  Grid grid;
  std::vector<std::vector<int>> contents;

  Filled(const std::vector<Lattice>& all, int across)
      : grid{static_cast<double>(world) / across, across / 2} {
    contents.resize(static_cast<std::size_t>(grid.count()));
    for (std::size_t n = 0; n < all.size(); ++n) {
      Index i;
      for (std::size_t a = 0; a < 3; ++a)
        i[a] = static_cast<int>(std::floor(static_cast<double>(all[n].c[a]) / unit / grid.h));
      contents[static_cast<std::size_t>(grid.id(i))].push_back(static_cast<int>(n));
    }
  }
};

inline bool inside(const Sphere& s, const Point& x) {
  double squared = 0;
  for (std::size_t a = 0; a < 3; ++a) squared += (x[a] - s.c[a]) * (x[a] - s.c[a]);
  return squared <= s.r * s.r;
}

/// How many objects each sphere holds; tests of bins and of objects count alike.
template <class Find>
Answer query(const std::vector<Lattice>& all, const std::vector<Sphere>& spheres, int across,
             const Find& find) {
  const Filled filled(all, across);
  Answer counts;
  std::vector<double> value;
  for (const Sphere& s : spheres) {
    const Hits found = find(s, filled.grid);
    counts.evaluations += found.tests;
    int held = 0;
    for (long id : found.ids)
      for (int n : filled.contents[static_cast<std::size_t>(id)]) {
        ++counts.evaluations;
        held += inside(s, all[static_cast<std::size_t>(n)].sphere().c);
      }
    value.push_back(held);
  }
  counts.value = Value(std::move(value));
  return counts;
}

}  // namespace oddity::bins
