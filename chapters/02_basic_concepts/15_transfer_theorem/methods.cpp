// The quantities of exercise 2.15: the inertia of a solid tetrahedron about the origin, and about its center
// of mass far from the origin.

#include "chapters/02_basic_concepts/15_transfer_theorem/transfer_theorem.hpp"
#include "chapters/foreseen.hpp"
#include "reference/reference.hpp"

namespace oddity::transfer_theorem {

namespace {

struct Tetrahedron {
  Vector legs, corner;
  double rho;

  explicit Tetrahedron(const Parameters& p)
      : legs{p["a"], p["b"], p["c"]}, corner{p["x"], p["y"], p["z"]}, rho(p["rho"]) {}
  double mass() const { return rho * legs[0] * legs[1] * legs[2] / 6; }
  Vector center() const { return corner + 0.25 * legs; }
  /// Five particles with the solid's mass, center and inertia.
  System particles() const {
    System all{{0.8 * mass(), center()}, {mass() / 20, corner}};
    for (std::size_t k = 0; k < 3; ++k) {
      Vector vertex = corner;
      vertex[k] += legs[k];
      all.push_back({mass() / 20, vertex});
    }
    return all;
  }
  /// The six components about the origin.
  Answer integrated(const Rule& rule) const {
    const double X = corner[0], Y = corner[1], Z = corner[2], a = legs[0], b = legs[1], c = legs[2];
    return all_of(6, [&](std::size_t k) {
      return nested(
          rule,
          [&](double x, double y, double z) {
            return inertia_of(rho, {x, y, z})[k];
          },
          X, X + a, [&](double) { return Y; }, [&](double x) { return Y + b * (1 - (x - X) / a); },
          [&](double, double) { return Z; },
          [&](double x, double y) { return Z + c * (1 - (x - X) / a - (y - Y) / b); });
    });
  }
};

Known tetrahedron_truth(const Tetrahedron& t, const Reference& truth) {
  const auto [a, b, c] = t.legs;
  const auto [x, y, z] = t.corner;
  return truth("02_15_tetrahedron", {a, b, c, x, y, z, t.rho});
}

/// Sums about the origin, compensated for the rounding of each addition (Neumaier).
Six compensated_about_origin(const System& system) {
  Six sum{}, lost{};
  for (const Particle& p : system) {
    const Six term = inertia_of(p.m, p.r);
    for (std::size_t k = 0; k < 6; ++k) {
      const double next = sum[k] + term[k];
      lost[k] +=
          std::abs(sum[k]) >= std::abs(term[k]) ? (sum[k] - next) + term[k] : (term[k] - next) + sum[k];
      sum[k] = next;
    }
  }
  return sum + lost;
}

/// One pass: mass, center and inertia about it, updated by each particle's transfer.
Six running(const System& system) {
  double mass = 0;
  Vector center{};
  Six central{};
  for (const Particle& p : system) {
    const Vector step = p.r - center;
    const double next = mass + p.m;
    central = central + inertia_of(mass * p.m / next, step);
    center = center + p.m / next * step;
    mass = next;
  }
  return central;
}

}  // namespace

Quantity about_origin(const Parameters& p, const Reference& truth) {
  const Tetrahedron t(p);
  const Known known = tetrahedron_truth(t, truth);
  Quantity q = quantity("about_origin", "kg m^2", "six components of the tetrahedron about the origin", known,
                        {1e-12 * (t.mass() + size_of(known.value)), "twelve digits of the largest"});
  const std::string transferred = "about the center, transferred", solid = "about the origin";
  q.add({transferred, "closed form", no_resolution(), [t](double) {
           const auto [a, b, c] = t.legs;
           const double m = t.mass() / 80;
           const Six central{3 * m * (b * b + c * c),
                             3 * m * (a * a + c * c),
                             3 * m * (a * a + b * b),
                             -m * a * b,
                             -m * a * c,
                             -m * b * c};
           return Answer{central + inertia_of(t.mass(), t.center()), 1};
         }});
  q.add({transferred, "five particles", no_resolution(), [t](double) {
           const System all = t.particles();
           return Answer{inertia_about(all, t.center()) + inertia_of(t.mass(), t.center()),
                         static_cast<long>(all.size())};
         }});
  q.add({solid, "five particles", no_resolution(), [t](double) {
           const System all = t.particles();
           return Answer{inertia_about(all, {}), static_cast<long>(all.size())};
         }});
  const auto add = [&](const std::string& name, const Resolution& resolution, Rule (*rule)(double)) {
    q.add({solid, name, resolution, [=](double setting) { return t.integrated(rule(setting)); }});
  };
  add("QAGS", tolerances(4, 12, 4), qags_rule);
  add("Gauss-Legendre", doubling("points", 1, 4), gauss_rule);
  const Resolution panels = doubling("panels", 2, 5);
  q.add({solid, "Simpson", panels, [=](double n) { return t.integrated(simpson_rule(n)); },
         Outcome::inaccurate,
         filled("its error shrinks as $h^4$: too slow for twelve digits at @2 panels",
                {panels.settings.back()})});
  add_box_methods<3>(q, {512, 4096, 32768}, p["seed"], [t](const Vector& u) {
    const double box = t.legs[0] * t.legs[1] * t.legs[2];
    if (u[0] + u[1] + u[2] > 1) return Six{};
    return inertia_of(t.rho * box, {t.corner[0] + t.legs[0] * u[0], t.corner[1] + t.legs[1] * u[1],
                                    t.corner[2] + t.legs[2] * u[2]});
  });
  return q;
}

Quantity about_center(const Parameters& p, const Reference& truth) {
  const double far = p["far"];
  Tetrahedron centered(p), t = centered;
  centered.corner = -0.25 * t.legs;
  t.corner = {far, 2 * far, -far};
  const Known known = tetrahedron_truth(centered, truth);
  Quantity q = quantity("about_center", "kg m^2",
                        "six components about the center of mass, far from the origin", known,
                        {1e-8 * t.mass() * (1 + dot(t.legs, t.legs)),
                         filled("eight digits: at $@1$ m the positions themselves are rounded to $@1$ m",
                                {far, far * 0x1p-52})});
  const std::string back = "about the origin, transferred back", cancels = "the digits cancel in $I-mc^2$";
  // Sums round their terms, and the integrals' bounds the edges.
  constexpr double epsilon = 0x1p-52, known_to = 16;
  const double terms = epsilon * size_of(inertia_of(t.mass(), t.center())),
               in_legs = size_of(t.center()) / *std::ranges::min_element(t.legs);
  const Foreseen by_sums = foreseen(within_factor(known_to, terms), q.need.allowed),
                 by_bounds = foreseen(within_factor(known_to, terms * (1 + in_legs / 8)), q.need.allowed,
                                      size_of(known.value));
  const auto by_particles = [&](const std::string& algorithm, Six (*about_origin)(const System&),
                                const std::string& why) {
    q.add(expecting(by_sums, why, {back, algorithm, no_resolution(), [=](double) {
                                     const System all = t.particles();
                                     const Six center = inertia_of(mass_of(all), center_of(all));
                                     return Answer{about_origin(all) - center, static_cast<long>(all.size())};
                                   }}));
  };
  by_particles(
      "five particles", [](const System& all) { return inertia_about(all, {}); }, cancels);
  by_particles("compensated sum", compensated_about_origin,
               cancels + ": each square was rounded before it was added");
  q.add(expecting(by_bounds, cancels + ", and the bounds are rounded",
                  {back, "Gauss-Legendre", doubling("points", 2, 3), [t](double n) {
                     Answer answer = t.integrated(gauss_rule(n));
                     const Six moved = inertia_of(t.mass(), t.center());
                     for (std::size_t k = 0; k < 6; ++k) answer.value[k] -= moved[k];
                     return answer;
                   }}));
  q.add(
      {"center first", "five particles", no_resolution(), [t](double) {
         const System all = t.particles();
         return Answer{inertia_about(all, center_of(all)), 2 * static_cast<long>(all.size())};  // two passes
       }});
  q.add({"about a particle, transferred back", "five particles", no_resolution(), [t](double) {
           System all = t.particles();
           const Vector first = all[0].r;
           for (Particle& each : all) each.r = each.r - first;
           return Answer{inertia_about(all, {}) - inertia_of(mass_of(all), center_of(all)),
                         static_cast<long>(all.size())};
         }});
  q.add({"running center", "five particles", no_resolution(), [t](double) {
           const System all = t.particles();
           return Answer{running(all), static_cast<long>(all.size())};
         }});
  if (by_sums.outcome == Outcome::ok) return q;
  q.add(
      Breakdown{R"(Both terms of $I-mc^2$ are as large as $@1$ and leave $@1$, with )"
                "no more than @1 digits right. Positions relative to the center of mass, which is computed "
                "first, lose none.",
                back + ", five particles",
                0,
                Outcome::inaccurate,
                "center first, five particles",
                0,
                {size_of(inertia_of(t.mass(), t.center())), size_of(known.value), digits_of(Side::broken)}});
  q.add(
      Breakdown{"Adding more carefully does not help, since every square is rounded already; shifting the "
                "origin to any particle of the system does.",
                back + ", compensated sum", 0, Outcome::inaccurate,
                "about a particle, transferred back, five particles", 0});
  return q;
}

}  // namespace oddity::transfer_theorem
