// Exercise 6.3: left open by the published solutions, which only state that there are many ways. Following
// 6.1, the question here is which of n moving spheres overlap in each frame, found with bins whose contents
// follow the motion, or without bins. Centers and velocities are multiples of 1/64, so the reference tests
// every pair in exact integers.

#include "chapters/06_physics_engines/03_moving_spheres/moving_spheres.hpp"
#include "chapters/inputs.hpp"

namespace oddity {

namespace ex06_03 {

using namespace bins;

constexpr auto parameters =
    together(std::array{Parameter{"n", 96, "", "spheres, next to fifteen edge cases", 2, 400, whole_number},
                        Parameter{"frames", 16, "", "frames", 6, 64, whole_number},
                        Parameter{"radius", 0.75, "", "largest radius, the world's side being 16", 0.05, 4},
                        Parameter{"speed", 0.25, "", "largest speed along an axis, per frame", 0, 2},
                        Parameter{"seed", 1, "", "seed of the random spheres", 0, 1e9, whole_number}},
             numbers<3>({"c1x", "c1y", "c1z"}, {-5, 1, 0}, "",
                        "center of the first of two spheres that you choose", 1e6),
             numbers<3>({"v1x", "v1y", "v1z"}, {0.6, 0, 0}, "", "its velocity per frame", 1e4),
             numbers<3>({"c2x", "c2y", "c2z"}, {5, 0, 0.5}, "", "center of the second", 1e6),
             numbers<3>({"v2x", "v2y", "v2z"}, {-0.25, 0.03125, 0}, "", "its velocity per frame", 1e4),
             std::array{Parameter{"r1", 1, "", "radius of the first", 1e-6, 1e6},
                        Parameter{"r2", 0.75, "", "radius of the second", 1e-6, 1e6}});

constexpr double world = 16;

Grid grid_of(double across) { return {world / across, static_cast<int>(across) / 2}; }

/// Spheres that meet from afar, are tangent in passing or at rest, nearly tangent, inside another, points, on
/// boundaries, outside, or around all others.
const std::vector<Mover> edge_cases{
    {{-300, 100, 100}, {50, 0, 0}, 10},   {{-100, 100, 100}, {0, 0, 0}, 10},
    {{-80, 0, 0}, {5, 0, 0}, 20},         {{0, 0, 0}, {0, 0, 0}, 20},
    {{200, 200, 200}, {0, 0, 0}, 6},      {{203, 204, 212}, {0, 0, 0}, 7},
    {{197, 196, 188}, {0, 0, 0}, 6},      {{-320, -256, 64}, {0, 0, 0}, 0},
    {{-256, -256, 64}, {-1, 0, 0}, 64},   {{-320, -256, 64}, {0, 0, 0}, 0},
    {{700, 30, -10}, {9, 0, 0}, 10},      {{715, 30, -10}, {9, 0, 0}, 10},
    {{500, -500, -500}, {7, -7, -7}, 30}, {{540, -540, -500}, {7, -7, -7}, 30},
    {{0, 0, 0}, {0, 0, 0}, 800}};

/// All except the last: with its radius all bins would be searched for centers.
const std::vector<Mover> edge_cases_of_a_size(edge_cases.begin(), edge_cases.end() - 1);

std::vector<Mover> movers(const Parameters& p, std::vector<Mover> all = edge_cases) {
  Random random(p["seed"]);
  const auto whole = [&](double size) { return std::llround(random.between(-size, size) * unit); };
  for (int n = 0; n < static_cast<int>(p["n"]); ++n) {
    const std::array<long long, 3> c{whole(world / 2), whole(world / 2), whole(world / 2)},
        v{whole(p["speed"]), whole(p["speed"]), whole(p["speed"])};
    all.push_back({c, v, std::llround(random.between(0, p["radius"]) * unit)});
  }
  return all;
}

std::vector<Frame> frames_of(const std::vector<Mover>& all, int count) {
  std::vector<Frame> frames(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    for (const Mover& m : all) frames[static_cast<std::size_t>(k)].push_back(m.at(k).sphere());
  return frames;
}

/// Tests every pair of every frame in integers.
std::vector<double> exact_pairs(const std::vector<Mover>& all, int count) {
  Pairs found;
  for (int k = 0; k < count; ++k) {
    found.begin();
    for (std::size_t j = 0; j < all.size(); ++j)
      for (std::size_t i = 0; i < j; ++i) {
        const Lattice a = all[i].at(k), b = all[j].at(k);
        long long squared = 0;
        for (std::size_t x = 0; x < 3; ++x) squared += (a.c[x] - b.c[x]) * (a.c[x] - b.c[x]);
        if (squared <= (a.r + b.r) * (a.r + b.r))
          found.put(static_cast<int>(i), static_cast<int>(j), all.size());
      }
  }
  return found.value;
}

Quantity pairs(const Parameters& p) {
  const auto all = movers(p);
  const int count = static_cast<int>(p["frames"]);
  const auto frames = frames_of(all, count);
  Quantity q{
      "pairs",
      "pairs",
      "overlapping pairs in each frame, their number and a checksum; the work is pairs tested, bin entries "
      "written and comparisons made",
      {"every pair in exact integers", exact_pairs(all, count)},
      0,
      {0.5 * Pairs::checksum_unit(all.size()), "whole pairs"},
      {},
      {}};
  const auto add = [&](const char* model, const char* algorithm, const Resolution& resolution,
                       const auto& find, Outcome expected = Outcome::ok, const char* why = "") {
    q.add({model, algorithm, resolution,
           [=](double setting) {
             const Pairs found = find(setting);
             return Answer{Value(found.value), found.tested + found.upkeep};
           },
           expected, why});
  };
  const Resolution across = doubling("bins an axis", 2, 4);
  const Outcome wrong = Outcome::inaccurate;
  const auto bins_by = [=](Follow how) { return [=](double n) { return by_bins(frames, grid_of(n), how); }; };
  add("no order", "all pairs", no_resolution(), [=](double) { return by_all_pairs(frames); });
  add("bins of boxes", "rebuilt every frame", across, bins_by(Follow::rebuilt));
  add("bins of boxes", "updated", across, bins_by(Follow::updated));
  add("bins of centers", "all within reach", across,
      [=](double n) { return by_center_bins(frames, grid_of(n), false); });
  add("sweep along x", "sorted every frame", no_resolution(),
      [=](double) { return by_sweep(frames, false); });
  add("sweep along x", "order kept", no_resolution(), [=](double) { return by_sweep(frames, true); });
  add("bins of boxes", "never updated", across, bins_by(Follow::never), wrong, "the spheres have moved on");
  add(
      "bins of centers", "own bin alone", across,
      [=](double n) { return by_center_bins(frames, grid_of(n), true); }, wrong,
      "neighbours across a boundary are not looked at");
  add(
      "bins of boxes", "outside left out", across,
      [=](double n) { return by_bins(frames, grid_of(n), Follow::rebuilt_inside); }, wrong,
      "spheres that have left the grid meet there too");
  q.add(
      Breakdown{"Bins that do not follow the motion find the pairs of the first frame and lose others later.",
                "bins of boxes, never updated", 16, wrong, "bins of boxes, updated", 16});
  q.add(Breakdown{"A sphere listed by its center alone is not found from the next bin.",
                  "bins of centers, own bin alone", 16, wrong, "bins of centers, all within reach", 16});
  q.add(Breakdown{"Spheres beyond the grid are lost, unless the bins of the border take them in.",
                  "bins of boxes, outside left out", 16, wrong, "bins of boxes, rebuilt every frame", 16});
  return q;
}

Findings study(const Parameters& p, const Reference&) {
  std::vector<Quantity> all{pairs(p)};
  if (auto contact = first_contact(p)) all.push_back(std::move(*contact));
  return {claims(p),
          std::move(all),
          {},
          "The solution leaves the exercise open, and its one statement is right."};
}

}  // namespace ex06_03

Exercise exercise_6_3() {
  using namespace ex06_03;
  return {"Moving spheres",
          "The published solutions leave this one open: no answer is required, and there are many ways. "
          "Ours: find the "
          "overlapping pairs among $n$ moving spheres without testing all $n(n-1)/2$ in every frame.",
          parameters,
          {},
          study};
}

}  // namespace oddity
