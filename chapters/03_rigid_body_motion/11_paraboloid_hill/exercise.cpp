// Exercise 3.11: when does a particle, sliding without friction on a paraboloid hill, follow (v1 t, v2 t)?
//   hill       x3 = -x1^2/a1^2 - x2^2/a2^2 (lengths over the metre), K = v1^2/a1^2 + v2^2/a2^2
//   equations  x_i'' + (4 x_i/a_i^2) ((x1 x1'' + x1'^2)/a1^2 + (x2 x2'' + x2'^2)/a2^2) - 2 g x_i/a_i^2 = 0
// The text's equations are compared with Lagrange's left side, the Lagrangian differentiated by nested dual
// numbers from the hill's height alone; its statements about paths are tried on integrated motions. Along a
// straight path x3'' = -2K: at K = g/2 it is a free fall, and the hill pushes with g - 2K = 0.

#include "chapters/03_rigid_body_motion/11_paraboloid_hill/paraboloid_hill.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex03_11 {

using namespace paraboloid_hill;

constexpr Parameter parameters[] = {
    {"a1", 1, "m", "half axis of the section one metre below the top", 0.2, 10},
    {"a2", 2, "m", "the other half axis", 0.2, 10},
    {"g", 10, "m/s^2", "gravity", 0.1, 100},
    {"v1", 2, "m/s", "direction of the straight path; its speed follows from the condition", 0.1, 10},
    {"v2", 2, "m/s", "direction of the straight path", 0.1, 10},
    {"factor", 0.75, "", "speed of the neighbouring path over that of the straight one", 0.2, 0.99},
    {"offset", 0.25, "m", "start of another neighbour beside the top", 0.01, 1},
    {"seed", 311, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the equations ----------------------------------------------------------------------------------------

/// The velocity along v with which the line is straight.
Pair right_speed(const Hill<double>& hill, double g, const Pair& v) {
  return from_the_top<double>({hill.a1, hill.a2, g, v[0], v[1], 1}).v;
}

struct Sample {
  Hill<double> hill;
  double g, t;
  Pair x, v, a;

  explicit Sample(Random& random)
      : hill{random.between(0.5, 3), random.between(0.5, 3)},
        g(random.between(0.5, 20)),
        t(random.magnitude(0.1, 3)),
        x{random.magnitude(0.1, 3), random.magnitude(0.1, 3)},
        v{random.magnitude(0.1, 3), random.magnitude(0.1, 3)},
        a{random.magnitude(0.1, 3), random.magnitude(0.1, 3)} {}
  std::array<double*, 10> letters() {
    return {&hill.a1, &hill.a2, &g, &t, &x[0], &x[1], &v[0], &v[1], &a[0], &a[1]};
  }
  std::string where() const {
    return "a = (" + rounded(hill.a1, 4) + ", " + rounded(hill.a2, 4) + "), v = (" + rounded(v[0], 4) + ", " +
           rounded(v[1], 4) + "), t = " + rounded(t, 4);
  }
  Pair left_side(const Pair& at, const Pair& acceleration) const {
    return lagrange_left_side(height_field::Lagrangian<Hill<double>>{hill, g}, at, v, acceleration);
  }
};

using S = const Sample&;
using V = Version<Sample>;

/// The first equation's left side; `factor` is what stands before the bracket, for 4 x1/a1^2.
double published(S s, double factor, double squares = 1) {
  const double A1 = s.hill.a1 * s.hill.a1, A2 = s.hill.a2 * s.hill.a2;
  return s.a[0] +
         factor * ((s.x[0] * s.a[0] + squares * s.v[0] * s.v[0]) / A1 +
                   (s.x[1] * s.a[1] + squares * s.v[1] * s.v[1]) / A2) -
         2 * s.g * s.x[0] / A1;
}

double along_line(S s, double gravity) {
  const double A1 = s.hill.a1 * s.hill.a1, A2 = s.hill.a2 * s.hill.a2;
  return 0 + 4 * s.v[0] * s.t / A1 * (s.v[0] * s.v[0] / A1 + s.v[1] * s.v[1] / A2) -
         gravity * s.g * s.v[0] * s.t / A1;
}

std::vector<Claim> equations(double seed) {
  const auto line_of = [](S s) {
    return [&s](std::size_t i) { return [&s, i](const auto& t) { return s.v[i] * t; }; };
  };
  Claim derivatives = formula_claim<Sample>(
      "3.11-derivatives", 1543, "the first two derivatives of (v1 t, v2 t)", seed,
      {"(v1, v2), (0, 0)", [](S s) { return values(s.v[0], s.v[1], 0, 0); }},
      {"dual numbers",
       [=](S s) {
         const auto x = line_of(s);
         return values(derivative(x(0), s.t), derivative(x(1), s.t), second_derivative(x(0), s.t),
                       second_derivative(x(1), s.t));
       }},
      {{"(v1 t, v2 t), (v1, v2)", [](S s) { return values(s.v[0] * s.t, s.v[1] * s.t, s.v[0], s.v[1]); }}});

  const V lagrange{"Lagrange's left side by nested dual numbers",
                   [](S s) { return values(s.left_side(s.x, s.a)[0]); }};
  const auto reading = [&](const std::string& text, const std::function<Value(S)>& of) {
    return Reading{text, {compare<Sample>("left side of the first equation", {text, of}, lagrange, seed)}};
  };
  Claim first{"3.11-first_equation", 1545,
              "the first equation of motion is 0 = x1'' + (4 x1/a1) (...) - 2 g x1/a1^2"};
  first.printed = reading("x1'' + (4 x1/a1) (...) - 2 g x1/a1^2",
                          [](S s) { return values(published(s, 4 * s.x[0] / s.hill.a1)); });
  const auto factor = [](S s) { return 4 * s.x[0] / (s.hill.a1 * s.hill.a1); };
  first.meant =
      reading("x1'' + (4 x1/a1^2) (...) - 2 g x1/a1^2", [=](S s) { return values(published(s, factor(s))); });
  first.near_misses = {
      reading("-4 x1/a1^2 before the bracket", [=](S s) { return values(published(s, -factor(s))); }),
      reading("without the squares of the speeds", [=](S s) { return values(published(s, factor(s), 0)); })};
  first.why =
      "The factor before the bracket is $4x_1/a_1^2$, as the next line has it; with the hill $x_3 = "
      "-x_1^2/a_1^2 - x_2^2/a_2^2$ this is Lagrange's equation to the last digit. On a hill with $a_1=2$ the "
      "printed factor is twice too large.";

  Claim substituted = formula_claim<Sample>(
      "3.11-substituted", 1563, "the first equation's right side on (v1 t, v2 t)", seed,
      {"0 + (4 v1 t/a1^2) K - 2 g v1 t/a1^2", [](S s) { return values(along_line(s, 2)); }},
      {"Lagrange's left side by nested dual numbers",
       [](S s) {
         return values(s.left_side({s.v[0] * s.t, s.v[1] * s.t}, {0, 0})[0]);
       }},
      {{"g for 2 g", [](S s) { return values(along_line(s, 1)); }},
       {"plus 2 g", [](S s) { return values(along_line(s, -2)); }}});
  bars_lost<Sample>(
      substituted,
      "on (v1 t, v2 t) the first equation's right side is 0 + 4 v1 t a1^2 (v1^2 a1^2 + v2^2 a2^2) - 2 g "
      "v1 t/a1^2",
      seed,
      {"4 v1 t a1^2 (v1^2 a1^2 + v2^2 a2^2), as products",
       [](S s) {
         const double A1 = s.hill.a1 * s.hill.a1, A2 = s.hill.a2 * s.hill.a2;
         return values(4 * s.v[0] * s.t * A1 * (s.v[0] * s.v[0] * A1 + s.v[1] * s.v[1] * A2) -
                       2 * s.g * s.v[0] * s.t / A1);
       }},
      {"Lagrange's left side by nested dual numbers",
       [](S s) {
         return values(s.left_side({s.v[0] * s.t, s.v[1] * s.t}, {0, 0})[0]);
       }},
      "The bars of the first term's three fractions are lost in the text at hand; the last term has "
      "its own. As products the terms cannot be added: on a hill twice as wide, $a_1$ and $a_2$ "
      "doubled, the first one should shrink to a sixteenth, and grows sixteenfold.");
  derivatives.says = "the first two derivatives of (v1 t, v2 t) are (v1, v2) and (0, 0)";
  return {derivatives, first, substituted};
}

// ---- what follows from them -------------------------------------------------------------------------------

/// Starts from the top: any direction, along either axis, or at rest; at the condition or off it.
struct FromTop : Sample {
  explicit FromTop(Random& random) : Sample(random) {
    const int kind = random.below(4);
    if (kind == 1 || kind == 3) v[0] = 0;
    if (kind == 2 || kind == 3) v[1] = 0;
    if (kind == 0 && random.unit() < 0.5) v = right_speed(hill, g, v);
  }
  /// v1^2/a1^2 + v2^2/a2^2 against g/2, or what the products make of it.
  bool equal(double left) const { return std::abs(left - g / 2) <= rounding(left + g / 2).allowed; }
  bool condition() const { return equal(steepening(hill, v)); }
  /// Whether (v1 t, v2 t) satisfies equation i.
  bool satisfied(std::size_t i) const {
    const auto left = [&](const std::array<double, 6>& letters) {
      const auto [a1, a2, gravity, time, v1, v2] = letters;
      Sample moved = *this;
      moved.hill = {a1, a2};
      moved.g = gravity;
      return Value(moved.left_side({v1 * time, v2 * time}, {0, 0})[i]);
    };
    const std::array letters{hill.a1, hill.a2, g, t, v[0], v[1]};
    return size_of(left(letters)) <= rounding(size_of_terms(left, letters)).allowed;
  }
};

template <class Holds>
Check in_all(const std::string& says, double seed, const Holds& holds) {
  Random random(seed);
  long violations = 0;
  std::string where;
  for (int i = 0; i < 400; ++i) {
    const FromTop sample(random);
    if (holds(sample)) continue;
    ++violations;
    where = "one of them: " + sample.where();
  }
  return never(says, violations, 400, where);
}

std::vector<Claim> conditions(double seed) {
  using F = const FromTop&;
  const std::string half = "v1^2/a1^2 + v2^2/a2^2 = g/2";
  Claim algebra{"3.11-condition", 1573,
                "from the first equation follows v1^2 a1^2 + v2^2 a2^2 = g/2, where v1 is not zero"};
  algebra.printed = {"v1^2 a1^2 + v2^2 a2^2 = g/2 for v1 != 0",
                     {in_all("the first equation holds with v1 != 0 unlike this condition", seed, [](F s) {
                       const double a = s.hill.a1 * s.v[0], b = s.hill.a2 * s.v[1];
                       return s.v[0] == 0 || s.satisfied(0) == s.equal(a * a + b * b);
                     })}};
  algebra.why =
      "The bars of the left side's fractions are lost in the text at hand: $v_1^2/a_1^2+v_2^2/a_2^2=g/2$. On "
      "the default hill, $a_1=1$, $a_2=2$, $g=10$, that is 2 m/s in each direction for $v_1=v_2$, and with "
      "the products 1 m/s, at which the particle does not keep to a uniform motion.";
  algebra.meant = {half + " for v1 != 0",
                   {in_all("the first equation holds with v1 != 0 unlike the condition", seed,
                           [](F s) { return s.v[0] == 0 || s.satisfied(0) == s.condition(); })}};
  algebra.near_misses = {{half + " for v1 = 0 as well",
                          {in_all("the first equation holds, but not the condition", seed,
                                  [](F s) { return !s.satisfied(0) || s.condition(); })}}};

  Claim second{"3.11-second_equation", 1581,
               "the second equation gives the same condition, where v2 is not zero"};
  second.printed = {half + " for v2 != 0",
                    {in_all("the second equation holds with v2 != 0 unlike the condition", seed,
                            [](F s) { return s.v[1] == 0 || s.satisfied(1) == s.condition(); })}};
  second.near_misses = {{half + " for v2 = 0 as well",
                         {in_all("the second equation holds, but not the condition", seed,
                                 [](F s) { return !s.satisfied(1) || s.condition(); })}}};

  Claim only{"3.11-only_way", 1581, "(v1 t, v2 t) is a solution only if " + half};
  only.printed = {half, {in_all("both equations hold, but not the condition", seed, [](F s) {
                    return !(s.satisfied(0) && s.satisfied(1)) || s.condition();
                  })}};
  only.near_misses = {{half + ", or v1 = 0", {in_all("both equations hold unlike this", seed, [](F s) {
                         return (s.satisfied(0) && s.satisfied(1)) == (s.condition() || s.v[0] == 0);
                       })}}};
  Worst push("the hill's vertical force over the mass on (v1 t, v2 t)", "g + x3'' by dual numbers", "none");
  Random random(seed);
  long buried = 0;
  for (int i = 0; i < 200; ++i) {
    const Sample s(random);
    const Pair v = right_speed(s.hill, s.g, s.v);
    const auto x3 = [&](const auto& t) { return s.hill.height(v[0] * t, v[1] * t); };
    push.see(s.g + second_derivative(x3, s.t), 0, s.g, s.where());
    const double faster = random.between(1.01, 2);
    buried += !(-s.g * s.t * s.t / 2 > s.hill.height(faster * v[0] * s.t, faster * v[1] * s.t));
  }
  only.corrected = {half + ", or the particle is at rest on the top",
                    {in_all("both equations hold unlike this", seed,
                            [](F s) {
                              const bool at_rest = s.v[0] == 0 && s.v[1] == 0;
                              return (s.satisfied(0) && s.satisfied(1)) == (s.condition() || at_rest);
                            }),
                     push.check(), never("faster than that, the free fall meets the hill", buried, 200)}};
  only.why =
      "The algebra divides by $v_1t$ and by $v_2t$. With $v_1=0$ the first equation reads $0=0$, and the "
      "second "
      "decides; with $v_1=v_2=0$ neither does: a particle at rest on the top stays there. All other motions "
      "$(v_1t,v_2t)$ need the condition, and they are free falls: the hill does not push. A faster particle "
      "flies off, over the same line and as uniformly. A game that keeps it on the hill by these equations "
      "has to "
      "pull it down: at twice the speed, on the top, with three times its weight.";
  return {algebra, second, only};
}

/// How far the path from the top strays from the line of its first velocity, over its length.
double stray(S s, const Pair& v) {
  const auto path = ode::integrate<ode::Fehlberg78>(in_plane<double>({s.hill, s.g, {0, 0}, v}),
                                                    std::array{0.0, 0.0, v[0], v[1]}, 0, 2, 1e-12);
  if (!path.reached()) return std::numeric_limits<double>::quiet_NaN();
  const auto& x = path.value;
  return std::abs(x[0] * v[1] - x[1] * v[0]) / (std::hypot(x[0], x[1]) * std::hypot(v[0], v[1]));
}

Claim not_straight(double seed) {
  Claim claim{"3.11-not_straight", 1581,
              "unless v1^2/a1^2 + v2^2/a2^2 = g/2 the path is not a straight line"};
  Random random(seed);
  long straight = 0, bent_axis = 0, bent_circle = 0, straight_others = 0, bent_at_condition = 0;
  for (int i = 0; i < 50; ++i) {
    Sample s(random);
    const double off = random.between(0.3, 0.9);
    const Pair right = right_speed(s.hill, s.g, s.v);
    Pair slow = {right[0] * off, right[1] * off};
    bent_at_condition += !(stray(s, right) < 1e-9);
    if (std::abs(s.hill.a1 - s.hill.a2) > 0.1 && std::min(std::abs(slow[0]), std::abs(slow[1])) > 0.05)
      straight_others += !(stray(s, slow) > 1e-6);
    straight += stray(s, {slow[0], 0}) < 1e-9;
    bent_axis += !(stray(s, {slow[0], 0}) < 1e-9) + !(stray(s, {0, slow[1]}) < 1e-9);
    s.hill.a2 = s.hill.a1;
    straight += stray(s, slow) < 1e-9;
    bent_circle += !(stray(s, slow) < 1e-9);
  }
  claim.printed = {"bent whenever v1^2/a1^2 + v2^2/a2^2 is not g/2",
                   {never("the path is straight: along an axis, or on a round hill", straight, 100)}};
  claim.corrected = {
      "straight if v1^2/a1^2 + v2^2/a2^2 = g/2, along an axis, or on a round hill; else not",
      {never("bent though the condition holds", bent_at_condition, 50),
       never("bent along an axis", bent_axis, 100), never("bent on a round hill", bent_circle, 50),
       never("straight in any other case", straight_others, 50)}};
  claim.why =
      "A particle sent off along an axis stays above it at any speed, and on a round hill, $a_1=a_2$, every "
      "path through the top is straight; only its speed is not constant. A game that takes the sentence for "
      "a test "
      "bends the path of a ball that rolls straight down a ridge. What fails without the condition is the "
      "motion "
      "$(v_1t,v_2t)$, not the line: for a point on the line $x_1'x_2''-x_2'x_1''$ is proportional to "
      "$(g-2K)\\,v_1v_2\\,(a_1^{-2}-a_2^{-2})$ with $K=v_1^2/a_1^2+v_2^2/a_2^2$.";
  claim.near_misses = {{"straight if the condition holds or on a round hill; else not",
                        {never("straight along an axis", 100 - bent_axis, 100)}}};
  return claim;
}

/// From the top at this part of the straight path's speed.
Case<double> asked(const Parameters& p, double factor) {
  return from_the_top<double>({p["a1"], p["a2"], p["g"], p["v1"], p["v2"], factor});
}

constexpr auto low_order = "its order is too low for this need at this step";

Quantity slower(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const Case<double> c = asked(p, p["factor"]);
  Quantity position =
      path("slower",
           "position at " + times_up_to(horizon) + ", from the top at a part of the straight path's speed", c,
           false, horizon, truth);
  Ladder(position, horizon, halving("step", 0.125, 9), tolerances(3, 11))
      .by_others(plane, in_plane(c),
                 {{"modified midpoint", Outcome::inaccurate, low_order},
                  {"linearly implicit Euler", Outcome::inaccurate, low_order}});
  return position;
}

Scene scene() {
  return {
      slower,
      2,
      centimeter,
      "factor",
      {0.99, 0.9, 0.75, 0.5, 0.2},
      {"v1", "v2"},
      {{"x1", "x2", "x3"}, "s", {{"m", {0, 1, 2}}}},
      {{"chapters/03_rigid_body_motion/11_paraboloid_hill/models.hpp"},
       {{"straight line",
         "paraboloid_hill::StraightLine<double>{paraboloid_hill::from_the_top<double>({a1, a2, g, v1, v2, factor})}"},
        {"height field",
         "paraboloid_hill::in_plane(paraboloid_hill::from_the_top<double>({a1, a2, g, v1, v2, factor}))"},
        {"Cartesian with constraint",
         "paraboloid_hill::InSpace<double>{paraboloid_hill::from_the_top<double>({a1, a2, g, v1, v2, factor})}"},
        {"momenta",
         "paraboloid_hill::in_momenta(paraboloid_hill::from_the_top<double>({a1, a2, g, v1, v2, factor}))"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Horizon horizon{scene().horizon};
  const Case<double> right = asked(p, 1);
  std::vector<Claim> claims = equations(p["seed"]);
  for (const Claim& claim : conditions(p["seed"])) claims.push_back(claim);
  claims.push_back(not_straight(p["seed"]));
  Quantity bent = motion(scene(), p, truth);
  bent.add(Breakdown{
      "With three quarters of the speed the hill pushes, and not along the line: the closed form is "
      "off by metres after two seconds. The two equations of motion follow the path.",
      line + ", closed form", 0, Outcome::inaccurate, plane + ", Runge-Kutta 4", 0.0009765625});
  return {claims,
          {path("straight", "position at " + times_up_to(horizon) + ", at the speed of the straight path",
                right, true, horizon, truth),
           bent,
           path("faster", "the same at twice that, the hill holding the particle back",
                asked(p, 2 * p["factor"]), false, horizon, truth),
           path("beside", "in the same free fall from a start beside the top: straight as well",
                beside(right, p["offset"]), true, horizon, truth)}};
}

}  // namespace ex03_11

Exercise exercise_3_11() {
  using namespace ex03_11;
  return {"Straight paths on a paraboloid hill",
          "A particle slides without friction from the top of the hill $x_3 = -x_1^2/a_1^2 - x_2^2/a_2^2$. "
          "For which velocities is its motion over the plane $(v_1t, v_2t)$?",
          parameters, scene(), study};
}

}  // namespace oddity
