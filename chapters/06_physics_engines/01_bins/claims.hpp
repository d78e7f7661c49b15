#pragma once

#include "chapters/06_physics_engines/shared/lattice.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"
#include "solvers/roots.hpp"

/// What the book says about bins: each by counting, or in exact integers.
namespace oddity::bins {

using Reach = Span (*)(double, double, const Grid&);

/// A small sphere in every bin in turn, only each `stride`-th bin being tested: the spheres not found.
inline Check one_in_every_bin(int stride) {
  const Grid grid{1, 2};
  long lost = 0, samples = 0;
  for (int i = -2; i < 2; ++i)
    for (int j = -2; j < 2; ++j)
      for (int k = -2; k < 2; ++k, ++samples) {
        const Lattice s{{i * unit + unit / 2, j * unit + unit / 2, k * unit + unit / 2}, unit / 4};
        std::vector<long> found;
        for (long id : hits(s.sphere(), grid, every_bin, touches).ids)
          if (id % stride == 0) found.push_back(id);
        lost += found != exact_ids(s, grid, hit_exactly);
      }
  return never("spheres not found, one in each of 64 bins", lost, samples);
}

inline Claim naive_needs_n() {
  return {"6.1-naive_needs_n",
          3735,
          "testing bin after bin takes n tests a sphere: none can be left out",
          {"n tests", {one_in_every_bin(1)}},
          {},
          {},
          {{"every second bin", {one_in_every_bin(2)}}}};
}

/// The ends of the projection: where the plane x = const ceases to meet the sphere.
inline Check projection_ends(const Parameters& p, double stretch) {
  Worst worst("ends of the three projections", "c -+ " + shortest(stretch) + " r",
              "planes that just meet the sphere, by bisection of r^2 - (x - c)^2");
  Random random(p["seed"]);
  for (int n = 0; n < 30; ++n) {
    const Point c = random.point(10);
    const double r = std::abs(random.magnitude(1e-3, 1e3));
    std::vector<double> ends, planes;
    for (double x : c)
      for (double side : {-1, 1}) {
        ends.push_back(x + side * stretch * r);
        const auto left = [&](double offset) { return r * r - offset * offset; };
        planes.push_back(x + side * brent(left, 0, 3 * r, 1e-15 * r).value);
      }
    worst.see(ends, planes, 10 + r, "r = " + shortest(r));
  }
  return worst.check();
}

inline Claim projections(const Parameters& p) {
  return {"6.1-projections",
          3737,
          "the projections on the axes are [c - r, c + r]",
          {"c -+ r", {projection_ends(p, 1)}},
          {},
          {},
          {{"the inscribed box, c -+ r/sqrt(3)", {projection_ends(p, 1 / std::sqrt(3.0))}},
           {"c -+ 2r", {projection_ends(p, 2)}}}};
}

/// Bins of the range that the box does not meet, and bins of the box that the range forgets.
inline Check range_is_box(const Parameters& p, Reach range) {
  const Grid grid{1, static_cast<int>(p["half"])};
  long wrong = 0, samples = 0;
  std::string first;
  for (const Lattice& s : test_spheres(p)) {
    ++samples;
    if (hits(s.sphere(), grid, range, always).ids == exact_ids(s, grid, box_hit_exactly)) continue;
    if (wrong++ == 0) first = where(s);
  }
  return never("spheres whose range is not exactly the bins that meet their box", wrong, samples, first);
}

inline Check same_answer(const Parameters& p, Reach range) {
  const Grid grid{1, static_cast<int>(p["half"])};
  long wrong = 0, samples = 0;
  std::string first;
  for (const Lattice& s : test_spheres(p)) {
    ++samples;
    if (hits(s.sphere(), grid, range, touches).ids == hits(s.sphere(), grid, every_bin, touches).ids)
      continue;
    if (wrong++ == 0) first = where(s);
  }
  return never("spheres for which tests in the range find other bins than n tests", wrong, samples, first);
}

inline Claim subset(const Parameters& p) {
  return {
      "6.1-subset",
      3737,
      "least and greatest index on each axis give the bins that meet the sphere's box, and no hit is lost",
      {"ceil((x - r)/h) - 1 to floor((x + r)/h)", {range_is_box(p, reach), same_answer(p, reach)}},
      {},
      {},
      {{"floor at both ends", {range_is_box(p, reach_by_floor), same_answer(p, reach_by_floor)}},
       {"truncation at both ends",
        {range_is_box(p, reach_by_truncation), same_answer(p, reach_by_truncation)}},
       {"converted to 32 bits, then clamped",
        {range_is_box(p, reach_converted_first), same_answer(p, reach_converted_first)}}}};
}

inline Claim few_computations() {
  const auto counted = [](const char* by, double said) {
    std::vector<double> divisions;
    for (int half : {1, 4, 12}) {
      const Operations operations = operations_of([&] {
        for (double x : {0.3, -0.2, 0.7}) static_cast<void>(reach_of<Counted<double>>(x, 0.9, {1, half}));
      });
      divisions.push_back(static_cast<double>(operations.divisions));
      divisions.push_back(static_cast<double>(operations.functions));
    }
    return Check{"divisions and roundings for a sphere's range in grids of 2, 8, 24 bins an axis",
                 {"counted", divisions},
                 {by, std::vector<double>(divisions.size(), said)},
                 exact()};
  };
  return {"6.1-few_computations",
          3737,
          "the indices take few computations, however many bins there are",
          {"six divisions and roundings", {counted("two on each axis", 6)}},
          {},
          {},
          {{"three", {counted("one on each axis", 3)}}}};
}

/// The mean number of bins in the range, over centers evenly spread over an axis of the grid, cubed.
inline double mean_tests(double ratio, int half) {
  const Grid grid{1, half};
  const int samples = 64 * half;
  double sum = 0;
  for (int n = 0; n < samples; ++n)
    sum += static_cast<double>(reach((n + 0.5) / 32 - half, ratio, grid).count());
  return std::pow(sum / samples, 3);
}

/// In an endless grid 1 + 2 ratio on an axis; bin number i from the border misses the centers outside.
inline double mean_in_closed_form(double ratio, int half) {
  double lost = 0;
  for (int i = 0; i < 2 * half; ++i) lost += 2 * std::max(0.0, ratio - i);
  return std::pow(1 + 2 * ratio - lost / (2 * half), 3);
}

/// In a grid of 16 bins an axis: spheres whose range is more than a fiftieth of all bins.
inline Check small_subset(const Parameters& p, double largest) {
  const Grid grid{1, 8};
  long large = 0;
  const auto spheres = random_spheres(p["seed"], 400, 8, largest);
  for (const Lattice& s : spheres) large += 50 * hits(s.sphere(), grid, reach, always).tests > grid.count();
  return never("spheres whose range is above a fiftieth of 4096 bins, r up to " + shortest(largest) + " bins",
               large, 400);
}

inline Claim typically_less(const Parameters& p) {
  const auto mean = [](const std::string& by, double per_radius) {
    std::vector<double> counted, formula;
    for (double ratio : {0.25, 0.5, 1.0, 2.0}) {
      counted.push_back(mean_tests(ratio, 32));
      formula.push_back(std::pow(std::cbrt(mean_in_closed_form(ratio, 32)) + (per_radius - 2) * ratio, 3));
    }
    return Check{
        "mean size of the range at r/h = 1/4, 1/2, 1, 2", {"counted", counted}, {by, formula}, rounding(125)};
  };
  return {"6.1-typically_less",
          3737,
          "the range is typically far smaller than the grid",
          {"below a fiftieth while r <= h; (1 + 2r/h)^3 less what the border cuts off",
           {small_subset(p, 1), mean("closed form", 2)}},
          {},
          {},
          {{"for spheres of up to 8 bins' radius too", {small_subset(p, 8)}},
           {"(1 + r/h)^3", {mean("closed form with r for 2r", 1)}}}};
}

inline Check range_is_everything(const Parameters& p, double radius_over_width) {
  const Grid grid{1, 8};
  Random random(p["seed"]);
  long less = 0;
  for (int n = 0; n < 400; ++n)
    less += hits({random.point(8), radius_over_width * 16}, grid, reach, always).tests < grid.count();
  return never(
      "spheres of r = " + shortest(radius_over_width) + " widths whose range is smaller than the grid", less,
      400);
}

inline Claim unless_large(const Parameters& p) {
  return {"6.1-unless_large",
          3737,
          "for a really large sphere the range is the grid, and nothing is gained",
          {"every bin for r = the grid's width", {range_is_everything(p, 1)}},
          {},
          {},
          {{"for r = half the width", {range_is_everything(p, 0.5)}}}};
}

/// One sphere of radius 4 in a world of 16, the bins' side from 1/4 to 4: `of` the range in one grid.
inline Check growing_bins(const Parameters& p, bool as_fraction) {
  Random random(p["seed"]);
  long rises = 0, samples = 0;
  for (int n = 0; n < 100; ++n) {
    const Sphere s{random.point(8), 4};
    double before = std::numeric_limits<double>::infinity();
    for (int half = 32; half >= 2; half /= 2, ++samples) {
      const Grid grid{8.0 / half, half};
      const double tests = static_cast<double>(
          reach(s.c[0], 4, grid).count() * reach(s.c[1], 4, grid).count() * reach(s.c[2], 4, grid).count());
      const double now = as_fraction ? tests / static_cast<double>(grid.count()) : tests;
      rises += now > before;
      before = now;
    }
  }
  return never(as_fraction ? "grids in which the range is a larger fraction than in the next finer one"
                           : "grids that take more tests than the next finer one",
               rises, samples);
}

inline Claim bins_too_small(const Parameters& p) {
  return {"6.1-bins_too_small",
          3737,
          "where the range is large the bins are too small: larger ones need fewer tests",
          {"tests never rise when the bins' side is doubled", {growing_bins(p, false)}},
          {},
          {},
          {{"the fraction of the grid never rises either", {growing_bins(p, true)}}}};
}

inline Claim cost_ratio(const Parameters& p) {
  const Grid grid{1, static_cast<int>(p["half"])};
  Worst box("cost of the range over cost of the grid", "tests counted by both",
            "bins that meet the box over n, in exact integers", 4);
  Worst ball = Worst("cost of the range over cost of the grid", "tests counted by both",
                     "bins that meet the sphere over n", 4);
  for (const Lattice& s : test_spheres(p)) {
    const double cost = static_cast<double>(hits(s.sphere(), grid, reach, touches).tests) /
                        static_cast<double>(hits(s.sphere(), grid, every_bin, touches).tests);
    const auto over_n = [&](const auto& test) {
      return static_cast<double>(exact_ids(s, grid, test).size()) / static_cast<double>(grid.count());
    };
    box.see(cost, over_n(box_hit_exactly), 1, where(s));
    ball.see(cost, over_n(hit_exactly), 1, where(s));
  }
  const Check ratio_alone{"tests at r = width/16, in grids of 8 and of 32 bins an axis",
                          {"8", mean_tests(0.5, 4)},
                          {"32", mean_tests(2, 16)},
                          rounding(125)};
  return {"6.1-cost_ratio",
          3737,
          "the cost, in units of the n tests, is the range's share of the bins",
          {"range over n", {box.check()}},
          {},
          {},
          {{"the share that the sphere itself meets", {ball.check()}},
           {"the ratio of radius and grid decides the number of tests", {ratio_alone}}}};
}

inline Claim constant_cost() {
  std::vector<double> counted, closed, constant, linear, slack;
  for (int half : {4, 8, 16, 32}) {
    counted.push_back(mean_tests(0.5, half));
    closed.push_back(mean_in_closed_form(0.5, half));
    constant.push_back(8);
    linear.push_back(counted.front() * std::pow(half / 4.0, 3));
  }
  const auto tests = [&](std::string by, const std::vector<double>& value, Tolerance tolerance) {
    return Check{"mean tests a sphere at r = h/2, n = 8^3, 16^3, 32^3, 64^3",
                 {"counted", counted},
                 {std::move(by), value},
                 std::move(tolerance)};
  };
  return {"6.1-constant_cost",
          3737,
          "with bins of a good size the number of tests is about constant, O(1) for O(n)",
          {"8 less what the border cuts off, at r = h/2",
           {tests("(2 - 1/N)^3 for N bins an axis", closed, rounding(8)),
            tests("constant", constant, {8 * 3 / 16.0, "the border cuts off 3/(2N), N = 8"})}},
          {},
          {},
          {{"proportional to n", {tests("proportional to n", linear, {1.5, "as above"})}}}};
}

inline std::vector<Claim> claims(const Parameters& p) {
  return {naive_needs_n(), projections(p),    subset(p),     few_computations(), typically_less(p),
          unless_large(p), bins_too_small(p), cost_ratio(p), constant_cost()};
}

}  // namespace oddity::bins
