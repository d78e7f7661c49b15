// Exercise 2.15: the inertia components about any origin from those about the center of mass c.
//   Ixx = Ixx' + m (cy^2 + cz^2),  Ixy = Ixy' + m cx cy,  with ' about the center of mass
// The other route is the definition, J w = sum of m r x (w x r), which no formula of the text enters. The
// lines up to the last are algebra about any point: there they are checked about a random one, where no term
// is zero. The solid is a tetrahedron, with moments m/20 (sum of the vertices' + 16 times the center's).

#include "chapters/02_basic_concepts/15_transfer_theorem/tetrahedron.hpp"

namespace oddity {

namespace ex02_15 {

using namespace solid;

constexpr Parameter parameters[] = {
    {"a", 1, "m", "leg of the tetrahedron along x", 0.125, 8},
    {"b", 1.5, "m", "leg along y", 0.125, 8},
    {"c", 0.75, "m", "leg along z", 0.125, 8},
    {"x", 2, "m", "x of the corner where the legs meet", -10, 10},
    {"y", -1, "m", "y of that corner", -10, 10},
    {"z", 0.5, "m", "z of that corner", -10, 10},
    {"rho", 1, "kg/m^3", "density", 1e-3, 1e3},
    {"far", 0x1p20, "m", "distance of the corner in the far system", 0, 1e7},
    {"seed", 15, "", "of the random systems", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

/// A value of a system, its positions being given relative to a point A.
using Formula = std::function<Value(const System& relative, const Vector& A)>;

template <class F>
double sum(const System& system, const F& f) {
  double all = 0;
  for (const Particle& p : system) all += p.m * f(p.r[0], p.r[1], p.r[2]);
  return all;
}
const auto x_of = [](double x, double, double) { return x; };
const auto y_of = [](double, double y, double) { return y; };
const auto z_of = [](double, double, double z) { return z; };
const auto xy_of = [](double x, double y, double) { return x * y; };
const auto yz_squared = [](double, double y, double z) { return y * y + z * z; };

/// Components from the definition, about the origin.
Formula definition(std::vector<std::size_t> which) {
  return [which](const System& relative, const Vector& A) {
    std::vector<double> all;
    for (std::size_t k : which) {
      all.push_back(0);
      for (const Particle& p : relative) all.back() += p.m * inertia_by_definition(k, p.r + A);
    }
    return Value(all);
  };
}

enum class About { center, any_point };

System random_system(Random& random) {
  System system;
  const Vector offset = random.point(20);
  for (int i = 2 + random.below(10); i > 0; --i)
    system.push_back({std::abs(random.magnitude(0.05, 20)), offset + random.point(5)});
  return system;
}

/// Random systems: a formula against a route, about the center of mass or about any point.
struct Samples {
  double seed;
  std::string quantity;
  Formula truth;
  std::string by = "sum of m r x (w x r)";
  About about = About::any_point;
  int power = 2;  ///< the terms are m r^power

  Reading of(const std::string& text, const Formula& formula) const {
    Worst worst(quantity + ", against " + by, text, by);
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      System system = random_system(random);
      const Vector A = center_of(system) + (about == About::center ? 0.0 : 1.0) * random.point(10);
      double size = 0;
      for (Particle& p : system) {
        size += p.m * std::pow(length(p.r) + 2 * length(A), power);
        p.r = p.r - A;
      }
      worst.see(formula(system, A), truth(system, A), size,
                "system " + std::to_string(i) + " of " + std::to_string(system.size()));
    }
    return {text, {worst.check()}};
  }
  Claim claim(const std::string& id, int line, const std::string& says, const Formula& printed,
              const std::string& near_text, const Formula& near) const {
    return {"2.15-" + id, line, says, of(says, printed), {}, {}, {of(near_text, near)}};
  }
};

std::vector<Claim> moments_of_inertia(double seed) {
  using S = const System&;
  using V = const Vector&;
  const Samples lines{seed, "Ixx", definition({0})};
  Samples center = lines;
  center.about = About::center;
  const auto direct = [](auto f) {
    return [f](S s, V A) {
      return sum(s, [&](double x, double y, double z) { return f(x + A[0], y + A[1], z + A[2]); });
    };
  };
  const auto shifted = [](double sign) {
    return [=](S s, V A) {
      return sum(s, [&](double, double y, double z) {
        return std::pow(y + sign * A[1], 2) + std::pow(z + sign * A[2], 2);
      });
    };
  };
  const auto split = [](double two) {
    return [=](S s, V A) {
      return sum(s, yz_squared) + sum(s, [&](double, double y, double z) {
               return two * y * A[1] + A[1] * A[1] + two * z * A[2] + A[2] * A[2];
             });
    };
  };
  const auto collected = [](double sign) {
    return [=](S s, V A) {
      return sum(s, yz_squared) + sign * 2 * A[1] * sum(s, y_of) + 2 * A[2] * sum(s, z_of) +
             (A[1] * A[1] + A[2] * A[2]) * mass_of(s);
    };
  };
  const auto transfer = [](double sign) {
    return [=](S s, V A) { return sum(s, yz_squared) + sign * mass_of(s) * (A[1] * A[1] + A[2] * A[2]); };
  };
  return {
      lines.claim("ixx", 747, "Ixx = sum of m (y^2 + z^2)", direct(yz_squared), "sum of m x y",
                  direct(xy_of)),
      lines.claim("ixx_shifted", 751, "= sum of m ((y' + cy)^2 + (z' + cz)^2)", shifted(1),
                  "sum of m ((y' - cy)^2 + (z' - cz)^2)", shifted(-1)),
      lines.claim("ixx_split", 753, "= sum of m (y'^2 + z'^2) + sum of m (2 y' cy + cy^2 + 2 z' cz + cz^2)",
                  split(2), "without the factors 2", split(1)),
      lines.claim("ixx_collected", 759,
                  "= Ixx' + 2 cy sum of m y' + 2 cz sum of m z' + (cy^2 + cz^2) sum of m", collected(1),
                  "- 2 cy sum of m y'", collected(-1)),
      center.claim("ixx_transfer", 769, "= Ixx' + m (cy^2 + cz^2)", transfer(1), "Ixx' - m (cy^2 + cz^2)",
                   transfer(-1)),
  };
}

std::vector<Claim> products_of_inertia(double seed) {
  using S = const System&;
  using V = const Vector&;
  const Samples lines{seed, "Ixy", definition({3})};
  Samples center = lines;
  center.about = About::center;
  const auto direct = [](double sign) {
    return [=](S s, V A) {
      return sign * sum(s, [&](double x, double y, double) { return (x + A[0]) * (y + A[1]); });
    };
  };
  const auto shifted = [](double sign) {
    return [=](S s, V A) {
      return sum(s, [&](double x, double y, double) { return (x + sign * A[0]) * (y + A[1]); });
    };
  };
  const auto first = [](S s, bool massless) {
    double all = 0;
    for (const Particle& p : s) all += (massless ? 1 : p.m) * p.r[0] * p.r[1];
    return all;
  };
  const auto split = [=](bool massless, double sign = 1) {
    return [=](S s, V A) {
      return first(s, massless) +
             sum(s, [&](double x, double y, double) { return A[0] * y + sign * A[1] * x + A[0] * A[1]; });
    };
  };
  const auto collected = [=](bool massless, double sign = 1) {
    return [=](S s, V A) {
      return first(s, massless) + A[0] * sum(s, y_of) + sign * A[1] * sum(s, x_of) + A[0] * A[1] * mass_of(s);
    };
  };
  const auto transfer = [](double sign) {
    return [=](S s, V A) { return sum(s, xy_of) + sign * mass_of(s) * A[0] * A[1]; };
  };
  const std::string why =
      "The mass $m_i$ is left out of the first sum, $\\sum m_i\\,x'_iy'_i$, of lines 783 and 787; the lines "
      "around the two, 781 and 795, have it. As it stands the sum has another unit, and is right only when "
      "every mass is 1: for two masses of 2 kg at $\\pm(1,1)$ m it is 2, where $I_{xy}$ is 4 kg m$^2$.";
  Claim split_claim = lines.claim("ixy_split", 783, "= sum of x' y' + sum of m (cx y' + cy x' + cx cy)",
                                  split(true), "with m, and - cy x'", split(false, -1));
  split_claim.meant = lines.of("sum of m x' y' + sum of m (cx y' + cy x' + cx cy)", split(false));
  split_claim.kind = Fault::formula;
  split_claim.why = why;
  Claim collected_claim =
      lines.claim("ixy_collected", 787, "= sum of x' y' + cx sum of m y' + cy sum of m x' + cx cy sum of m",
                  collected(true), "with m, and - cy sum of m x'", collected(false, -1));
  collected_claim.meant =
      lines.of("sum of m x' y' + cx sum of m y' + cy sum of m x' + cx cy sum of m", collected(false));
  collected_claim.kind = Fault::formula;
  collected_claim.why = why;
  return {lines.claim("ixy", 779, "Ixy = sum of m x y, the tensor's component with its sign changed",
                      direct(1), "Ixy = - sum of m x y", direct(-1)),
          lines.claim("ixy_shifted", 781, "= sum of m (x' + cx)(y' + cy)", shifted(1),
                      "sum of m (x' - cx)(y' + cy)", shifted(-1)),
          split_claim, collected_claim,
          center.claim("ixy_transfer", 795, "= Ixy' + m cx cy", transfer(1), "Ixy' - m cx cy", transfer(-1))};
}

std::vector<Claim> statements(double seed) {
  using S = const System&;
  using V = const Vector&;
  const auto nothing = [](std::size_t n) { return [n](S, V) { return Value(std::vector<double>(n)); }; };
  const Samples zero{seed, "first moments", nothing(3), "zero", About::center, 1};
  const Samples elsewhere{seed, "first moments", nothing(3), "zero", About::any_point, 1};
  const auto moments = [](S s, V) { return Value{sum(s, x_of), sum(s, y_of), sum(s, z_of)}; };
  Claim first = zero.claim("first_moments", 771, "the first moments about the center of mass are zero",
                           moments, "", moments);
  first.near_misses = {elsewhere.of("about another point", moments)};

  const auto middle = [](S s, V A) {
    return Value{2 * A[1] * sum(s, y_of), 2 * A[2] * sum(s, z_of), A[0] * sum(s, y_of), A[1] * sum(s, x_of)};
  };
  const Samples terms{seed, "middle terms of Ixx and Ixy", nothing(4), "zero", About::center};
  const Samples terms_elsewhere{seed, "middle terms of Ixx and Ixy", nothing(4), "zero"};
  Claim again = terms.claim("middle_terms", 797, "the middle terms are zero because of these moments", middle,
                            "", middle);
  again.near_misses = {terms_elsewhere.of("about another point", middle)};

  const auto positions = [](double sign) {
    return [=](S s, V A) {
      const Vector moved{3, -5, 7};
      return Value(s[0].m * ((s[0].r + A + moved) - sign * (A + moved)));
    };
  };
  const Samples relative{seed,
                         "m (x', y', z') of a particle",
                         [](S s, V) { return Value(s[0].m * s[0].r); },
                         "from the center, whatever the origin",
                         About::center,
                         1};
  const Claim position = relative.claim("relative_position", 743, "(x', y', z') = (x, y, z) - (cx, cy, cz)",
                                        positions(1), "(x, y, z) + (cx, cy, cz)", positions(-1));

  const Samples rest{seed, "Iyy, Izz, Ixz, Iyz", definition({1, 2, 4, 5}), "sum of m r x (w x r)",
                     About::center};
  const auto transfer = [](double sign) {
    return [=](S s, V A) {
      const Six central = inertia_about(s, {}), moved = inertia_of(mass_of(s), A);
      const auto both = [&](std::size_t k) { return central[k] + (k < 3 ? 1 : sign) * moved[k]; };
      return Value{both(1), both(2), both(4), both(5)};
    };
  };
  const Claim others = rest.claim("others", 799, "the other components transfer in the same manner",
                                  transfer(1), "the products with - m cx cz", transfer(-1));
  return {position, first, again, others};
}

Findings study(const Parameters& p, const Reference& truth) {
  std::vector<Claim> claims;
  for (const auto& part :
       {statements(p["seed"]), moments_of_inertia(p["seed"]), products_of_inertia(p["seed"])})
    claims.insert(claims.end(), part.begin(), part.end());
  std::ranges::stable_sort(claims, {}, &Claim::line);
  const Tetrahedron t{{p["a"], p["b"], p["c"]}, {p["x"], p["y"], p["z"]}, p["rho"]};
  return {claims, {about_origin(t, p["seed"], truth), about_center(t, p["far"], truth)}};
}

}  // namespace ex02_15

Exercise exercise_2_15() {
  using namespace ex02_15;
  return {"Transfer theorem",
          "Express the inertia components of particles about the origin, $I_{xx}=\\sum m_i(y_i^2+z_i^2)$, "
          "$I_{xy}=\\sum m_ix_iy_i$, ..., through those about their center of mass $c$. Below "
          "a prime marks what is taken relative to $c$.",
          parameters,
          {},
          study};
}

}  // namespace oddity
