#include "chapters/claims.hpp"

#include "chapters/06_physics_engines/01_bins/bins.hpp"
#include "chapters/06_physics_engines/shared/bins.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"
#include "solvers/roots.hpp"

/// The book's claims about bins, checked by counting or in exact integers.
namespace oddity::ex06_01 {

namespace {

using namespace bins;

using Range = Span (*)(double, double, const Grid&);

/// A small sphere in the middle of every bin.
std::vector<Lattice> one_in_every_bin(int half) {
  std::vector<Lattice> all;
  for (int i = -half; i < half; ++i)
    for (int j = -half; j < half; ++j)
      for (int k = -half; k < half; ++k)
        all.push_back({{i * unit + unit / 2, j * unit + unit / 2, k * unit + unit / 2}, unit / 4});
  return all;
}

/// A sphere of any center and radius.
struct Solid : Sphere {
  Letters<double> table() {
    return {{"x_c", c[0], {-10, 10}},
            {"y_c", c[1], {-10, 10}},
            {"z_c", c[2], {-10, 10}},
            {"r", r, positive_size(1e-3, 1e3)}};
  }
};

/// A sphere's center in the grid.
struct Center {
  Point c;

  Letters<double> table() { return {{"c", c, {-8, 8}}}; }
  /// Whether, for r = 4 in a world of 16, the cost of the range never rises as the bins' side grows from 1/4
  /// to 4.
  bool never_rises(bool as_fraction) const {
    double before = std::numeric_limits<double>::infinity();
    for (int half = 32; half >= 2; half /= 2) {
      const Grid grid{8.0 / half, half};
      double now = 1;
      for (double x : c) now *= static_cast<double>(reach(x, 4, grid).count());
      if (as_fraction) now /= static_cast<double>(grid.count());
      if (now > before) return false;
      before = now;
    }
    return true;
  }
};

/// A grid with 2 half bins along each axis.
struct Size {
  static constexpr bool whole = true;
  int half;
  TypesetLetters typeset() const { return {{"n", std::pow(2 * half, 3)}}; }
};

void ranges(Claims& claims, const Parameters& p, const std::vector<Lattice>& spheres, const Grid& grid) {
  const auto of_those = [](bool (*tested)(long id)) {
    return [=](const Lattice& s) {
      const Grid small{1, 2};
      std::vector<long> found;
      for (long id : hits(s.sphere(), small, every_bin, touches).ids)
        if (tested(id)) found.push_back(id);
      return !found.empty() && found == exact_ids(s, small, hit_exactly);
    };
  };
  claims.statement<Lattice>(
      "naive_needs_n", 3735, "a naive implementation, which tests every bin, requires $n$ intersection tests",
      one_in_every_bin(2),
      {.printed = {"$n$ tests find a sphere in any of 64 bins", of_those([](long) { return true; })},
       .near_misses = {
           {"tests of all bins but the first find it", of_those([](long id) { return id != 0; })}}});

  claims.over(draw<Solid>(30, p["seed"]))(
      "projections", 3737,
      "the sphere's projections on the axes are $[x_c-r,x_c+r]$, $[y_c-r,y_c+r]$ and $[z_c-r,z_c+r]$",
      {"planes that just meet the sphere, by Brent's method on $r^2-(x-c)^2$",
       [](const Solid& s) {
         const auto left = [&](double offset) { return s.r * s.r - offset * offset; };
         const double d = brent(left, 0, 3 * s.r, 1e-15 * s.r).value;
         return values(s.c[0] - d, s.c[0] + d, s.c[1] - d, s.c[1] + d, s.c[2] - d, s.c[2] + d);
       }},
      {R"($(x_c-r,\ x_c+r,\ y_c-r,\ y_c+r,\ z_c-r,\ z_c+r)$)"}, "ends of the three projections");

  /// The range contains exactly the bins that meet the box, and tests in it find the same bins as n tests.
  const auto by = [&](std::string text, Range range) {
    return Statement<Lattice>{
        std::move(text), [=](const Lattice& s) {
          const Sphere sphere = s.sphere();
          return hits(sphere, grid, range, always).ids == exact_ids(s, grid, box_hit_exactly) &&
                 hits(sphere, grid, range, touches).ids == hits(sphere, grid, every_bin, touches).ids;
        }};
  };
  claims.statement<Lattice>(
      "subset", 3737,
      "the minimum and the maximum index on each axis determine the bins that may meet the sphere's box",
      spheres,
      {.printed = by(R"($\lceil(x-r)/h\rceil-1$ to $\lfloor(x+r)/h\rfloor$, $h$ the bin's side)", reach),
       .near_misses = {by("floor at both ends", reach_by_floor),
                       by("truncation at both ends", reach_by_truncation),
                       by("converted to 32 bits, then clamped", reach_converted_first)}});

  claims.over(std::vector<Size>{{1}, {4}, {12}})(
      "few_computations", 3737,
      R"(the indices require only a few computations (our reading: $(6,\ 6)$ divisions and roundings, for any )"
      "number of bins)",
      {"counted",
       [](const Size& size) {
         const Operations operations = operations_of([&] {
           for (double x : {0.3, -0.2, 0.7})
             static_cast<void>(reach_of<Counted<double>>(x, 0.9, {1, size.half}));
         });
         return values(operations.divisions, operations.functions);
       }},
      {R"($(6,\ 6)$)"}, "divisions and roundings for a sphere's range");
}

/// The mean number of bins in the range for centers evenly spread along an axis of the grid, cubed.
double mean_tests(double ratio, int half) {
  const Grid grid{1, half};
  const int samples = 64 * half;
  double sum = 0;
  for (int n = 0; n < samples; ++n)
    sum += static_cast<double>(reach((n + 0.5) / 32 - half, ratio, grid).count());
  return std::pow(sum / samples, 3);
}

/// In an infinite grid it is 1 + 2 ratio on an axis; bin number i from the border lacks the centers outside.
double mean_in_closed_form(double ratio, int half) {
  double lost = 0;
  for (int i = 0; i < 2 * half; ++i) lost += 2 * std::max(0.0, ratio - i);
  return std::pow(1 + 2 * ratio - lost / (2 * half), 3);
}

/// A sphere's radius divided by the bin's side.
struct Ratio {
  double ratio;
  std::string where() const { return "$r/h$ = " + format_shortest(ratio); }
};

void costs(Claims& claims, const Parameters& p, const std::vector<Lattice>& spheres, const Grid& grid) {
  static constexpr Grid sixteen{1, 8};
  const auto small = [&](double largest) {
    return in_all<Lattice>(
        "the range is at most a fiftieth of 4096 bins, $r$ up to " + format_shortest(largest) + " bins",
        random_spheres(p["seed"], 400, 8, largest), [](const Lattice& s) {
          return 50 * hits(s.sphere(), sixteen, reach, always).tests <= sixteen.count();
        });
  };
  const auto mean = [](const std::string& text, double per_radius) {
    return compare<Ratio>(
        "mean size of the range", {"counted", [](const Ratio& r) { return mean_tests(r.ratio, 32); }},
        {text + " less the part cut off by the border",
         [=](const Ratio& r) {
           return std::pow(std::cbrt(mean_in_closed_form(r.ratio, 32)) + (per_radius - 2) * r.ratio, 3);
         }},
        {{0.25}, {0.5}, {1.0}, {2.0}, {3.0}});
  };
  claims.add(
      "typically_less", 3737,
      "the subset of bins is typically a lot less than the total number (our reading: below a fiftieth "
      "of $16^3$ bins while $r\\le h$)",
      {.printed = {R"(below a fiftieth while $r\le h$; $(1+2r/h)^3$ less what the border cuts off)",
                   {small(1), mean("$(1+2r/h)^3$", 2)}},
       .near_misses = {{"for spheres of up to 8 bins' radius too", {small(8)}},
                       {"$(1+r/h)^3$ less what the border cuts off", {mean("$(1+r/h)^3$", 1)}}}});

  const auto everything = [](double widths) {
    return [=](const Center& center) {
      return hits({center.c, widths * 16}, sixteen, reach, always).tests >= sixteen.count();
    };
  };
  claims
      .statement<Center>("unless_large", 3737,
                         "the subset is not less than the total number where the sphere is really large (our "
                         "reading: $r$ the grid's width)",
                         draw<Center>(400, p["seed"]),
                         {.printed = {"every bin for $r$ the grid's width", everything(1)},
                          .near_misses = {{"every bin for $r$ half the width", everything(0.5)}}})
      .statement<Center>(
          "bins_too_small", 3737,
          "where the subset is large the bins are most likely too small (our reading: larger ones take no more tests)",
          draw<Center>(100, p["seed"]),
          {.printed = {"tests never rise when the bins' side is doubled",
                       [](const Center& c) { return c.never_rises(false); }},
           .near_misses = {{"the fraction of the grid never rises either",
                            [](const Center& c) { return c.never_rises(true); }}}});

  const auto share = [&](std::string text, bool (*hit)(const Lattice&, const Index&)) {
    return compare<Lattice>(
        "tests, and bins in the grid",
        {"tests counted by the range and by the grid",
         [=](const Lattice& s) {
           return values(hits(s.sphere(), grid, reach, touches).tests,
                         hits(s.sphere(), grid, every_bin, touches).tests);
         }},
        {std::move(text),
         [=](const Lattice& s) { return values(exact_ids(s, grid, hit).size(), grid.count()); }},
        spheres);
  };
  claims.add("cost_ratio", 3737,
             "the cost depends on the ratio of the number of bins in the subset to the total number",
             {.printed = {"range over $n$",
                          {share("bins that meet the box, in exact integers, and $n$", box_hit_exactly)}},
              .near_misses = {{"the share that the sphere itself meets",
                               {share("bins that meet the sphere, in exact integers, and $n$", hit_exactly)}},
                              {"the ratio of radius and grid decides the number of tests",
                               {{R"(mean tests at $r=\mathrm{width}/16$)",
                                 {"in a grid of 8 bins an axis", mean_tests(0.5, 4)},
                                 {"in a grid of 32 bins an axis", mean_tests(2, 16)},
                                 rounding(125)}}}}});

  const std::vector<double> constant(4, 8);
  std::vector<double> counted, closed, linear;
  for (int half : {4, 8, 16, 32}) {
    counted.push_back(mean_tests(0.5, half));
    closed.push_back(mean_in_closed_form(0.5, half));
    linear.push_back(counted.front() * std::pow(half / 4.0, 3));
  }
  const auto tests = [&](const char* by, const std::vector<double>& value, const Tolerance& tolerance) {
    const std::string what = "mean tests a sphere at $r=h/2$, $n=8^3,16^3,32^3,64^3$";
    return Check{what, {"counted", counted}, {by, value}, tolerance};
  };
  const Tolerance border{8 * 3 / 16.0, "the border cuts off $3/(2N)$ of 8, $N=8$"};
  claims.add(
      "constant_cost", 3737,
      "with a good choice of bin size (our reading: $h=2r$) the number of tests is about constant, $O(1)$ "
      "instead of $O(n)$",
      {.printed = {"8 less the part cut off by the border, at $r=h/2$",
                   {tests("$(2-1/N)^3$ for $N$ bins an axis", closed, rounding(8)),
                    tests("8, whatever $N$ is", constant, border)}},
       .near_misses = {{"proportional to $n$", {tests("proportional to $n$", linear, border)}}}});
}

}  // namespace

std::vector<Claim> claims(const Parameters& p) {
  const Grid grid{1, static_cast<int>(p["half"])};
  const auto spheres = test_spheres(p);
  Claims claims("6.1");
  ranges(claims, p, spheres, grid);
  costs(claims, p, spheres, grid);
  return claims.in_order();
}

}  // namespace oddity::ex06_01
