// Exercise 3.31: a box slides and turns on a rough plane. The text names a program and tells two things about
// its friction. The program is not at hand; what is judged is what these two things entail.
//   F = -mu p int n dA,  moment = -mu p int rho x n dA,  n = (V + w k x rho)/|V + w k x rho|, p = m g/(4ab)
// The integrals have closed forms about the instantaneous centre, judged against nested quadrature. At rest n
// has no direction: friction at full speed only makes the box tremble, and on a slope creep. A uniform
// pressure is assumed; the box is too low to be tilted by its friction.

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wuninitialized"  // Odeint copies steppers before their scratch is written
#endif

#include "chapters/03_rigid_body_motion/rough_box_motion.hpp"
#include "chapters/random.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

namespace oddity {

namespace ex03_31 {

using namespace rough_box;
using std::abs, std::cos, std::hypot, std::sin, std::tan;

constexpr Parameter parameters[] = {
    {"a", 0.3, "m", "half the box's length", 0.1, 0.5},
    {"b", 0.2, "m", "half the box's width", 0.1, 0.5},
    {"mu", 0.3, "", "coefficient of friction", 0.2, 1},
    {"g", 9.81, "m/s^2", "gravity", 1, 30},
    {"u0", 2, "m/s", "velocity at the start, along the length", 0.1, 3},
    {"v0", 0.5, "m/s", "velocity at the start, across", 0, 3},
    {"w0", 10, "rad/s", "angular velocity at the start", 0, 20},
    {"seed", 31, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the claims: friction over the contact ----------------------------------------------------------------

/// How a point of the foot at (x, y), moving with (vx, vy), is held back.
using Law = Three<double> (*)(double vx, double vy);

/// The mean of the law and of its moment by nested quadrature, the foot cut at the instantaneous centre.
Value by_quadrature(const Contact& foot, double u, double v, double w, Law law) {
  const auto cut = [](double c, double half) { return std::clamp(c, -half, half); };
  const double cx = cut(-v / w, foot.a), cy = cut(u / w, foot.b);
  const Rule rule = [](FunctionOfOne f, double from, double to) {
    return from == to ? Integral{} : qags(f, from, to, 1e-9);
  };
  Value mean{0, 0, 0};
  for (int component = 0; component < 3; ++component) {
    const auto f = [&](double x, double y) {
      const auto n = law(u - w * y, v + w * x);
      return component < 2 ? n[static_cast<std::size_t>(component)] : x * n[1] - y * n[0];
    };
    for (const auto& [x1, x2] : {std::pair(-foot.a, cx), std::pair(cx, foot.a)})
      for (const auto& [y1, y2] : {std::pair(-foot.b, cy), std::pair(cy, foot.b)})
        mean[static_cast<std::size_t>(component)] +=
            nested(
                rule, f, x1, x2, [&, y = y1](double) { return y; }, [&, y = y2](double) { return y; })
                .value /
            (4 * foot.a * foot.b);
  }
  return mean;
}

Check contact_friction(const std::string& by, Law law, double seed) {
  Random random(seed);
  Worst worst("means of n and rho x n", "closed form about the instantaneous centre", by);
  for (int i = 0; i < 12; ++i) {
    const Contact foot{random.between(0.2, 1), random.between(0.2, 1)};
    const double w = random.magnitude(0.5, 5), u = random.between(-2, 2), v = random.between(-2, 2);
    worst.see(foot.means(u, v, w), by_quadrature(foot, u, v, w, law),
              {1e-6, "a thousand tolerances of the nested quadrature"}, 1,
              "a, b, u, v, w = " + rounded(foot.a, 4) + ", " + rounded(foot.b, 4) + ", " + rounded(u, 4) +
                  ", " + rounded(v, 4) + ", " + rounded(w, 4));
  }
  return worst.check();
}

Three<double> coulomb(double vx, double vy) {
  const double size = hypot(vx, vy);
  return size == 0 ? Three<double>{} : Three<double>{vx / size, vy / size};
}
Three<double> viscous(double vx, double vy) { return {vx, vy}; }

/// Rest after pure sliding and pure spinning, by integration, against the closed forms of each.
Check alone(const std::string& what, double u, double w, double factor) {
  const Box box{{0.3, 0.2}, 0.3, 9.81, u, 0, w};
  const auto rest = in_stretched_time<ode::Fehlberg78>(box, 1e-12).value;
  const auto apart = uncoupled(box);
  return {what,
          {"stretched time, Fehlberg 7(8)", {rest[0], rest[1], rest[3]}},
          {"V/(mu g), V^2/(2 mu g); w/alpha, w^2/(2 alpha)",
           {factor * apart[0], factor * apart[1], factor * apart[3]}},
          {1e-9, "a thousand tolerances of the integration"}};
}

Claim rough_friction(double seed) {
  Claim claim{"3.31-rough_friction", 2951, "the program has rough friction between the box and the plane"};
  claim.printed = {"mu p against the velocity of every point of the foot",
                   {contact_friction("n = v/|v|, by nested QAGS", coulomb, seed),
                    alone("t, x, theta at rest, sliding alone", 2, 0, 1),
                    alone("t, x, theta at rest, spinning alone", 0, 10, 1)}};
  claim.near_misses = {{"viscous friction", {contact_friction("n = v, by nested QAGS", viscous, seed)}},
                       {"a way of V^2/(mu g)", {alone("t, x, theta at rest, sliding alone", 2, 0, 2)}}};
  return claim;
}

// ---- the claims: friction at rest -------------------------------------------------------------------------

/// A box on the slope alpha, let go at rest, in steps of h.
struct Slope {
  double alpha, mu, g, h;

  double drive() const { return g * sin(alpha); }
  double friction() const { return mu * g * cos(alpha); }
  /// Friction against the velocity, and none at rest.
  double kinetic(double v) const {
    return v + h * (drive() - (v > 0 ? friction() : v < 0 ? -friction() : 0.0));
  }
  /// The modification: what friction can hold within a step is held.
  double with_static(double v) const {
    const double free = v + h * drive();
    return abs(free) <= h * friction() ? 0 : free - std::copysign(h * friction(), free);
  }
};

struct Creep {
  long moving = 0;
  double way = 0;
};

template <class Step>
Creep creep(const Slope& slope, const Step& step, int steps) {
  Creep seen;
  double v = 0;
  for (int i = 0; i < steps; ++i) {
    v = (slope.*step)(v);
    seen.way += slope.h * v;
    seen.moving += v != 0;
  }
  return seen;
}

Slope gentle(Random& random) {
  const double mu = random.between(0.1, 1);
  return {std::atan(mu) * random.between(0.05, 0.9), mu, random.between(1, 20), 0x1p-8};
}

Claim no_static_friction(double seed) {
  constexpr int slopes = 100, steps = 1000;
  Random random(seed);
  long held = 0, moved = 0;
  Worst tremble("speed after the first step over g h", "friction at full speed only", "sin(alpha)");
  for (int i = 0; i < slopes; ++i) {
    const Slope slope = gentle(random);
    const Creep without = creep(slope, &Slope::kinetic, steps),
                with = creep(slope, &Slope::with_static, steps);
    held += !(without.moving > steps / 2 && without.way > 0);
    moved += !(with.moving > steps / 2 && with.way > 0);
    tremble.see(slope.kinetic(0) / (slope.g * slope.h), sin(slope.alpha), 1,
                "alpha = " + rounded(slope.alpha, 4));
  }
  Claim claim{"3.31-no_static_friction", 2951, "the program leaves static friction out"};
  claim.printed = {"on slopes with tan(alpha) < mu the box, let go at rest, trembles and creeps down",
                   {never("the box stays", held, slopes), tremble.check()}};
  claim.near_misses = {{"so with static friction", {never("the box stays", moved, slopes)}}};
  return claim;
}

/// How many random slopes contradict: the box stays exactly when `holds`.
template <class Step, class Holds>
Check stays_when(const std::string& what, double seed, const Step& step, const Holds& holds) {
  Random random(seed + 1);
  long violations = 0;
  for (int i = 0; i < 300; ++i) {
    const Slope slope{random.between(0.01, 1.5), random.between(0.05, 2), random.between(1, 20), 0x1p-8};
    violations += (creep(slope, step, 20).way == 0) != holds(slope);
  }
  return never(what, violations, 300);
}

/// Speed after a second on slopes too steep to be held.
Check slides_down(double seed, double sign) {
  Random random(seed + 2);
  Worst worst("speed after 1 s", "steps with static friction", "g (sin(alpha) - mu cos(alpha))", 1024);
  for (int i = 0; i < 100; ++i) {
    const double mu = random.between(0.05, 1), alpha = std::atan(mu) + random.between(0.05, 0.5);
    const Slope slope{alpha, mu, random.between(1, 20), 0x1p-8};
    double v = 0;
    for (int step = 0; step < 256; ++step) v = slope.with_static(v);
    worst.see(v, slope.g * (sin(alpha) - sign * mu * cos(alpha)), slope.g, "alpha = " + rounded(alpha, 4));
  }
  return worst.check();
}

Claim easily_modified(double seed) {
  const std::string what = "the box stays exactly when ";
  const auto with = &Slope::with_static, without = &Slope::kinetic;
  const auto below_angle = [](const Slope& s) { return tan(s.alpha) < s.mu; };
  Claim claim{"3.31-easily_modified", 2951, "the program is easily changed to have static friction"};
  claim.printed = {"one test a step: what friction can stop within the step rests",
                   {stays_when(what + "tan(alpha) < mu", seed, with, below_angle), slides_down(seed, 1)}};
  claim.near_misses = {
      {"without the test", {stays_when(what + "tan(alpha) < mu", seed, without, below_angle)}},
      {"the weight for the normal force",
       {stays_when(what + "sin(alpha) < mu", seed, with,
                   [](const Slope& s) { return sin(s.alpha) < s.mu; })}},
      {"friction that drives", {slides_down(seed, -1)}}};
  return claim;
}

Box asked(const Parameters& p) { return {{p["a"], p["b"]}, p["mu"], p["g"], p["u0"], p["v0"], p["w0"]}; }

Quantity slide_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return slide(asked(p), horizon, truth);
}

Scene scene() {
  return {
      slide_of, 1.25, centimeter, "mu", {0.2, 0.3, 0.5, 0.7, 1}, {"u0", "v0", "w0"}, {{"x", "y", "theta"}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Box box = asked(p);
  Quantity end = rest(box, truth);
  end.add(
      Breakdown{"Friction that has full strength at any speed reverses at every step once the box should "
                "rest: it trembles and wanders. A test whether friction can stop the box within the step "
                "lets it rest.",
                in_time + ", Runge-Kutta 4", 0x1p-8, Outcome::inaccurate, sticks + ", " + midpoint, 0x1p-12});
  end.add(
      Breakdown{"Regularized friction is stiff at rest: its rate is mu g / softness, and a fixed explicit "
                "step ends by trembling. An implicit method takes its steps from the motion.",
                soft + ", Runge-Kutta 4, step 1/256", 0.0001, Outcome::inaccurate,
                soft + ", Rosenbrock 4, tolerance 1e-9", 0.0001});
  return {{rough_friction(p["seed"]), no_static_friction(p["seed"]), easily_modified(p["seed"])},
          {time_to_rest(box, truth), end, motion(scene(), p, truth)}};
}

}  // namespace ex03_31

Exercise exercise_3_31() {
  using namespace ex03_31;
  return {"Box on a rough plane",
          "A box slides and turns on a plane of friction $\\mu$. Where does it come to rest, and what does "
          "friction do at rest?",
          parameters, scene(), study};
}

}  // namespace oddity
