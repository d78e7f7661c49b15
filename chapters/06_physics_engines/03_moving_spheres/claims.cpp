// The claim of exercise 6.3: each way to find overlapping pairs is compared with a test of all in integers.

#include "chapters/claims.hpp"
#include "chapters/06_physics_engines/03_moving_spheres/moving_spheres.hpp"
#include "chapters/inputs.hpp"
#include "chapters/random.hpp"

namespace oddity::ex06_03 {

namespace {

/// Ten frames of random spheres, with the overlapping pairs from integer tests of all pairs.
struct Filmed {
  std::vector<Frame> frames;
  std::vector<double> pairs;
  std::string where() const { return std::to_string(frames[0].size()) + " spheres"; }
};

std::vector<Filmed> films(const Parameters& p) {
  Random random(p["seed"]);
  std::vector<Filmed> all;
  for (int scene = 0; scene < 4; ++scene) {
    Parameters other = p;
    other.set("seed", random.below(1000000));
    other.set("n", 2 + random.below(60));
    other.set("frames", 10);
    other.set("speed", random.between(0.1, 2));
    const auto spheres = movers(other, edge_cases_of_a_size);
    all.push_back({frames_of(spheres, 10), exact_pairs(spheres, 10)});
  }
  return all;
}

}  // namespace

std::vector<Claim> claims(const Parameters& p) {
  const auto all = films(p);
  const auto agrees = [&](const std::string& by,
                          const std::function<Pairs(const std::vector<Frame>&)>& find) {
    return in_all<Filmed>(by + ": in ten frames the pairs of an exact test of all, by fewer tests", all,
                          [&](const Filmed& f) {
                            const Pairs found = find(f.frames);
                            return found.value == f.pairs && found.tested < by_all_pairs(f.frames).tested;
                          });
  };
  const auto with = [](double across, Follow how) {
    return [=](const auto& frames) { return by_bins(frames, grid_of(across), how); };
  };
  Claims claims("6.3");
  claims.add("many_ways", 3739,
             "There are many ways to implement such an algorithm. (Our reading: at least five find the "
             "overlapping pairs of moving spheres without testing all.)",
             {.printed = {"at least five ways",
                          {agrees("bins rebuilt", with(8, Follow::rebuilt)),
                           agrees("bins updated", with(16, Follow::updated)),
                           agrees("bins of centers",
                                  [](const auto& f) { return by_center_bins(f, grid_of(8), false); }),
                           agrees("sweep, sorted", [](const auto& f) { return by_sweep(f, false); }),
                           agrees("sweep, order kept", [](const auto& f) { return by_sweep(f, true); })}},
              .near_misses = {{"bins need no update", {agrees("bins never updated", with(8, Follow::never))}},
                              {"a center's own bin is enough", {agrees("own bin", [](const auto& f) {
                                 return by_center_bins(f, grid_of(8), true);
                               })}}}});
  return claims.in_order();
}

}  // namespace oddity::ex06_03
