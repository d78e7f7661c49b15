#pragma once

#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "chapters/06_physics_engines/shared/bins.hpp"
#include "chapters/exercise.hpp"

/// Which spheres overlap while all of them move: several methods to find the pairs, frame by frame.
namespace oddity::ex06_03 {

using bins::Grid, bins::Lattice, bins::Sphere;

/// A sphere in 64ths of a unit with velocity v per frame.
struct Mover {
  std::array<long long, 3> c, v;
  long long r;

  Lattice at(int frame) const { return {{c[0] + frame * v[0], c[1] + frame * v[1], c[2] + frame * v[2]}, r}; }
};

using Frame = std::vector<Sphere>;

/// The pairs of every frame as two numbers: their count, and the sum of i n + j, scaled to below one per
/// pair. Also the work: pairs tested, and bin entries or comparisons to find them.
struct Pairs {
  std::vector<double> value = {};
  long tested = 0, upkeep = 0;

  void begin() { value.insert(value.end(), {0.0, 0.0}); }
  void test(const Frame& s, int i, int j) {
    ++tested;
    if (i > j) std::swap(i, j);
    const Sphere &a = s[static_cast<std::size_t>(i)], &b = s[static_cast<std::size_t>(j)];
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) squared += (a.c[k] - b.c[k]) * (a.c[k] - b.c[k]);
    if (squared <= (a.r + b.r) * (a.r + b.r)) put(i, j, s.size());
  }
  void put(int i, int j, std::size_t n) {
    value[value.size() - 2] += 1;
    value.back() += (i * static_cast<double>(n) + j) * checksum_unit(n);
  }
  /// The weight of a pair's number in the checksum: a power of two, so that sums are exact.
  static double checksum_unit(std::size_t n) { return 1 / static_cast<double>(std::bit_ceil(n * n)); }
};

Pairs by_all_pairs(const std::vector<Frame>&);

/// How the bins follow the motion; `rebuilt_inside` omits spheres whose centers are outside the grid.
enum class Follow { rebuilt, rebuilt_inside, updated, never };

/// Bins that list every sphere whose box they meet. A pair is tested in the lowest bin that contains both.
Pairs by_bins(const std::vector<Frame>&, const Grid&, Follow);

/// Bins that list centers. For each sphere all bins within its radius plus the largest are searched, or,
/// wrongly, only its own bin.
Pairs by_center_bins(const std::vector<Frame>&, const Grid&, bool own_bin_alone);

/// Sweep along x: spheres are ordered by their minimum x, and each is tested with those that have not ended
/// before it begins. The order is sorted again in every frame, or updated by insertion from the previous
/// frame.
Pairs by_sweep(const std::vector<Frame>&, bool keep_order);

/// Random spheres from the parameters, after these.
std::vector<Mover> movers(const Parameters&, std::vector<Mover>);
/// Edge cases without the one whose radius makes all bins be searched for centers.
extern const std::vector<Mover> edge_cases_of_a_size;
std::vector<Frame> frames_of(const std::vector<Mover>&, int count);
/// Tests every pair of every frame in integers.
std::vector<double> exact_pairs(const std::vector<Mover>&, int count);
/// Bins of the world, so many along an axis.
Grid grid_of(double across);

/// The time when the user's two spheres first touch; nullopt if they touch from the start, or never.
std::optional<Quantity> first_contact(const Parameters&);

std::vector<Claim> claims(const Parameters&);

}  // namespace oddity::ex06_03
