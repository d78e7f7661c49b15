// Exercise 6.1: which bins of a regular grid does a sphere hit? The book tests all n bins, or only those with
// indices in the sphere's projections, i = ceil((x - r)/h) - 1, ..., floor((x + r)/h) on each axis. Centers
// and radii are multiples of 1/64 of a bin, so the independent route decides every bin in exact integers. It
// compares the squared distance to the box with r^2. The mean length of an index range is 1 + 2r/h, as an
// interval of length 2r at a random place contains 2r/h bin boundaries.

#include <bit>
#include <cmath>

#include "chapters/06_physics_engines/01_bins/bins.hpp"
#include "chapters/06_physics_engines/shared/bins.hpp"

namespace oddity {

namespace ex06_01 {

using namespace bins;

constexpr Parameter parameters[] = {
    {"ratio", 1, "bins", "a sphere's radius over the bin's side", 0.03125, 3},
    {"half", 8, "bins", "half the number of bins on an axis", 2, 12, whole_number},
    {"seed", 1, "", "seed of the random spheres and objects", 0, 1e9, whole_number},
};

// ---- quantities -------------------------------------------------------------------------------------------

/// The weight of a bin's id in the checksum: a power of two, so that sums are exact.
double checksum_unit(const Grid& grid) {
  return 1 / static_cast<double>(std::bit_ceil(static_cast<unsigned long>(grid.count())));
}

/// Appends a list of bins as two numbers: their count, and a checksum of their ids.
void put(std::vector<double>& value, const std::vector<long>& ids, const Grid& grid) {
  double sum = 0;
  for (long id : ids) sum += static_cast<double>(id) * checksum_unit(grid);
  value.push_back(static_cast<double>(ids.size()));
  value.push_back(sum);
}
Tolerance whole_bins(const Grid& grid) { return {0.5 * checksum_unit(grid), "whole bins"}; }

Quantity bins_of(std::string name, std::string says, const std::vector<Lattice>& spheres, const Grid& grid) {
  std::vector<double> value;
  for (const Lattice& s : spheres) put(value, exact_ids(s, grid, hit_exactly), grid);
  return {std::move(name),
          "bins",
          std::move(says),
          {"every bin in exact integers", value},
          0,
          whole_bins(grid),
          {},
          {}};
}

template <class Find>
Answer answer_for(const std::vector<Sphere>& spheres, const Grid& grid, const Find& find) {
  std::vector<double> value;
  long tests = 0;
  for (const Sphere& s : spheres) {
    const Candidates found = find(s);
    put(value, found.ids, grid);
    tests += found.tests;
  }
  return {Value(std::move(value)), tests};
}

template <class BroadPhaseRange, class Test>
Method by(std::string model, std::string algorithm, const std::vector<Sphere>& spheres, const Grid& grid,
          BroadPhaseRange range, Test test, Outcome expected = Outcome::ok, std::string why = {}) {
  return {std::move(model),
          std::move(algorithm),
          no_resolution(),
          [=](double) {
            return answer_for(spheres, grid, [&](const Sphere& s) { return hits(s, grid, range, test); });
          },
          expected,
          std::move(why)};
}

std::vector<Sphere> real(const std::vector<Lattice>& lattice) {
  std::vector<Sphere> spheres;
  for (const Lattice& s : lattice) spheres.push_back(s.sphere());
  return spheres;
}

Quantity all_cases(const Parameters& p) {
  const Grid grid{1, static_cast<int>(p["half"])};
  const auto lattice = test_spheres(p);
  const auto spheres = real(lattice);
  Quantity q = bins_of("bins", "bins hit by each sphere: their number and a checksum", lattice, grid);
  const std::string test = "sphere-box test";
  const Outcome wrong = Outcome::inaccurate;
  q.add(by("all bins", test, spheres, grid, every_bin, touches));
  q.add(by("index range", test, spheres, grid, reach, touches));
  q.add(by("index range", "no test", spheres, grid, reach, always, wrong,
           "the box has corners, a sphere none"));
  q.add({"index range of each row", "no test", no_resolution(), [=](double) {
           return answer_for(spheres, grid, [&](const Sphere& s) { return hits_by_rows(s, grid); });
         }});
  q.add(by("index range by floor alone", test, spheres, grid, reach_by_floor, touches, wrong,
           "a bin that ends where the interval begins is touched, and left out"));
  q.add(by("index range by truncation", test, spheres, grid, reach_by_truncation, touches, wrong,
           "negative coordinates are rounded towards zero"));
  const auto largest = std::ranges::max_element(spheres, {}, &Sphere::r);
  q.add(by("index range converted, then clamped", test, spheres, grid, reach_converted_first, touches, wrong,
           filled("$2^{@2}$ bins do not fit in 32 bits", {std::log2(largest->r / grid.h)})));
  const auto cured = [&](std::string says, std::string method) {
    q.add(Breakdown{std::move(says), method + ", sphere-box test", 0, wrong, "index range, sphere-box test",
                    0});
  };
  cured("Truncation instead of floor loses bins at negative coordinates: -0.2 and 0.2 both become 0.",
        "index range by truncation");
  cured(
      "Floor at the lower end too: a sphere tangent to a bin from above does not find it. "
      "ceil - 1 does.",
      "index range by floor alone");
  cured(
      "A huge sphere's index overflows an int, the upper one becomes the least of all, and the sphere that "
      "holds the grid hits nothing. Clamp first.",
      "index range converted, then clamped");
  return q;
}

/// A sphere so large that in double precision its surface is a plane.
Quantity huge_tangent() {
  const Grid grid{1, 8};
  const Lattice s{{8 * unit + (1LL << 36), 32, 32}, 1LL << 36};
  const std::vector<Sphere> one{s.sphere()};
  Quantity q = bins_of("huge_tangent",
                       filled("bins hit by a sphere of $2^{@2}$ bins' radius that touches the grid's face",
                              {std::log2(one[0].r / grid.h)}),
                       {s}, grid);
  q.add(by("all bins", "squared distance", one, grid, every_bin, touches, Outcome::diverged,
           filled("the gap of half a bin is lost when its square is added to $2^{@2}$",
                  {2 * std::log2(one[0].r)})));
  q.add(by("index range", "squared distance", one, grid, reach, touches, Outcome::diverged, "the same sum"));
  q.add(by("all bins", "factored", one, grid, every_bin, touches_factored));
  q.add(by("index range", "factored", one, grid, reach, touches_factored));
  q.add(Breakdown{
      "The squared distance to every bin of the layer rounds to $r^2$, and all of them are hit. With the "
      "largest gap $d$ on the other side, as $(r-d)(r+d)$, only the one bin is.",
      "index range, squared distance", 0, Outcome::diverged, "index range, factored", 0});
  return q;
}

/// A known answer: exactly the bins in `hit`.
Quantity by_hand(std::string name, std::string says, std::string because, const Grid& grid,
                 const std::vector<Index>& hit) {
  std::vector<double> value;
  std::vector<long> ids;
  for (const Index& i : hit) ids.push_back(grid.id(i));
  put(value, ids, grid);
  return {std::move(name), "bins", std::move(says), {std::move(because), value}, 0, whole_bins(grid), {}, {}};
}

Quantity tiny_sphere() {
  const Grid grid{1, 4};
  constexpr double below = 1e-190, radius = 1e-200;
  const std::vector<Sphere> one{{{-below, 0.5, 0.5}, radius}};
  Quantity q = by_hand(
      "tiny_sphere", filled("bins hit by a sphere of radius $@1$ at $@1$ below a boundary", {radius, below}),
      filled("the boundary is $@1$ radii away", {below / radius}), grid, {{-1, 0, 0}});
  q.add(by("all bins", "sphere-box test", one, grid, every_bin, touches, Outcome::inaccurate,
           R"(both squares underflow to 0, and $0\le0$)"));
  q.add(by("index range", "sphere-box test", one, grid, reach, touches));
  q.add(
      Breakdown{"Squares underflow; differences do not: the index range is not only cheaper, it is right "
                "where the test is wrong.",
                "all bins, sphere-box test", 0, Outcome::inaccurate, "index range, sphere-box test", 0});
  return q;
}

Quantity rounded_boundary() {
  const Grid grid{0.7, 4};
  const std::vector<Sphere> one{{{3 * 0.7, 0.35, 0.35}, 0}};
  Quantity q = by_hand("rounded_boundary", R"(bins that hold the double $3\cdot0.7$, side 0.7)",
                       "it is the common end of bins 2 and 3", grid, {{2, 0, 0}, {3, 0, 0}});
  q.add(by("all bins", "sphere-box test", one, grid, every_bin, touches));
  q.add(by("index range", "sphere-box test", one, grid, reach, touches, Outcome::inaccurate,
           filled(R"($(3\cdot0.7)/0.7$ is less than 3 by $@2$)", {3 - 3 * 0.7 / 0.7})));
  q.add(by("index range widened by a bin", "sphere-box test", one, grid, reach_widened, touches));
  q.add(
      Breakdown{"Where the side is no power of two, index by division and boundary by multiplication round "
                "differently. One more bin on either side, and the test decides.",
                "index range, sphere-box test", 0, Outcome::inaccurate,
                "index range widened by a bin, sphere-box test", 0});
  return q;
}

// ---- queries of objects -----------------------------------------------------------------------------------

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

bool inside(const Sphere& s, const Point& x) {
  double squared = 0;
  for (std::size_t a = 0; a < 3; ++a) squared += (x[a] - s.c[a]) * (x[a] - s.c[a]);
  return squared <= s.r * s.r;
}

/// Counts the objects in each sphere. Tests of bins and of objects have the same cost.
template <class Find>
Answer query(const std::vector<Lattice>& all, const std::vector<Sphere>& spheres, int across,
             const Find& find) {
  const Filled filled(all, across);
  Answer counts;
  std::vector<double> value;
  for (const Sphere& s : spheres) {
    const Candidates found = find(s, filled.grid);
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

constexpr int objects = 512, questions = 8;

Quantity objects_held(const Parameters& p) {
  Random random(p["seed"]);
  std::vector<Lattice> all, queries;
  const auto coordinate = [&] {
    return static_cast<long long>(random.below(world * unit)) - world * unit / 2;
  };
  const long long r = std::llround(p["ratio"] * unit);
  for (int n = 0; n < objects; ++n) all.push_back({{coordinate(), coordinate(), coordinate()}, 0});
  for (int n = 0; n < questions; ++n) queries.push_back({{coordinate(), coordinate(), coordinate()}, r});
  all.front().c = queries.front().c;  // so that the first query finds an object
  std::vector<double> held;
  for (const Lattice& s : queries) {
    int count = 0;
    for (const Lattice& x : all) {
      long long squared = 0;
      for (std::size_t a = 0; a < 3; ++a) squared += (x.c[a] - s.c[a]) * (x.c[a] - s.c[a]);
      count += squared <= r * r;
    }
    held.push_back(count);
  }
  const auto spheres = real(queries);
  Quantity q{"objects_held",
             "objects",
             filled("objects inside each of @1 spheres, @3 objects in a world of side @2",
                    {questions, objects, world}),
             {"every object in exact integers", held},
             0,
             {0.5, "whole objects"},
             {},
             {}};
  const Resolution across = doubling("bins an axis", 2, 5);
  const auto add = [&](std::string model, std::string algorithm, const auto& find) {
    q.add({std::move(model), std::move(algorithm), across,
           [=](double n) { return query(all, spheres, static_cast<int>(n), find); }});
  };
  const auto with = [](const auto& range, const auto& test) {
    return [=](const Sphere& s, const Grid& grid) { return hits(s, grid, range, test); };
  };
  q.add({"all objects", "distance", no_resolution(), [=](double) {
           Answer counts = query(all, spheres, 2, with(every_bin, always));
           counts.evaluations = objects * static_cast<long>(spheres.size());
           return counts;
         }});
  add("all bins", "sphere-box test", with(every_bin, touches));
  add("index range", "no test", with(reach, always));
  add("index range", "sphere-box test", with(reach, touches));
  add("index range of each row", "no test",
      [](const Sphere& s, const Grid& grid) { return hits_by_rows(s, grid); });
  return q;
}

// ---- the exercise --------------------------------------------------------------------------------------

Findings study(const Parameters& p, const Reference&) {
  return {claims(p), {all_cases(p), objects_held(p), huge_tangent(), tiny_sphere(), rounded_boundary()}};
}

}  // namespace ex06_01

Exercise exercise_6_1() {
  using namespace ex06_01;
  return {
      "Spheres in a grid of bins",
      "Which of the $n$ bins of a rectangular grid does a sphere of center $c$ and radius $r$ meet? Find a "
      "way that does not test every bin, and state its cost.",
      parameters,
      {},
      study,
      nullptr,
      Expected::in_whole_ranges};
}

}  // namespace oddity
