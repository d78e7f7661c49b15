// Exercise 3.13: the motion of a ball in a cylindrical chute of radius R whose axis falls by H over its
// length L.
//   cylinder  (X - P)^T (I - D D^T) (X - P) = R^2, D = (-cos(theta), 0, sin(theta)), sin(theta) = H/L
//   height    x3 = (L R - H x1 - L sqrt(R^2 - x2^2)) / (L cos(theta))
//   motion    x'' = -(x'^T (Hessian of h) x' + g) / (1 + |grad h|^2) grad h
// The cylinder's formulas are tried on points made by walking along the axis and turning about it; partial
// derivatives are taken by dual numbers; the equations of motion are Lagrange's, the Lagrangian
// differentiated by nested dual numbers, in the plane's coordinates and in those of the cylinder, s along its
// axis and phi about it.

#include "chapters/03_rigid_body_motion/13_tilted_chute/tilted_chute_geometry.hpp"
#include "reference/bad_input.hpp"

namespace oddity {

namespace ex03_13 {

using namespace tilted_chute;

constexpr Parameter parameters[] = {
    {"R", 1, "m", "radius", 0.2, 10},
    {"L", 5, "m", "length of the chute", 1, 100},
    {"H", 3, "m", "fall over the length, less than L", 0.01, 99},
    {"g", 9.81, "m/s^2", "gravity", 0.1, 100},
    {"phi", 1, "rad", "start: the angle about the axis, from the lowest line", 0.05, 1.5},
    {"u", -1, "m/s", "start: the speed down the chute", -20, 20},
    {"seed", 313, "", "seed of the random samples", 0, 1e9, whole_number},
};

using S = const OnChute&;
using V = Version<OnChute>;

// ---- the height's derivatives -----------------------------------------------------------------------------

double root(S s) { return std::sqrt(s.chute.R * s.chute.R - s.x2 * s.x2); }

/// d^2 h / dx_i dx_j by nested dual numbers.
double second(S s, int i, int j) {
  using D = Dual<double>;
  using DD = Dual<D>;
  const auto x = [&](int k, double value) {
    return DD(D(value, i == k ? 1.0 : 0.0), D(j == k ? 1.0 : 0.0, 0.0));
  };
  return s.chute.height(x(1, s.x1), x(2, s.x2)).slope.slope;
}

Claim misprinted(const std::string& id, int line, const std::string& says, double seed, const V& printed,
                 const V& meant, const V& truth, const V& near, const std::string& why) {
  Claim claim = formula_claim<OnChute>(id, line, says, seed, printed, truth, {near});
  claim.says = says + " is " + printed.text;
  claim.meant = {meant.text, {compare(says, meant, truth, seed)}};
  claim.why = why;
  return claim;
}

std::vector<Claim> derivatives(double seed) {
  const V h1{"dual numbers", [](S s) {
               return values(
                   derivative([&](const auto& x) { return s.chute.height(x, decltype(x + x)(s.x2)); }, s.x1));
             }};
  const V h2{"dual numbers", [](S s) {
               return values(
                   derivative([&](const auto& x) { return s.chute.height(decltype(x + x)(s.x1), x); }, s.x2));
             }};
  Claim zero{"3.13-h11_h12", 1679, "h_x1x1 = h_x1x2 = 0"};
  const auto vanishing = [&](const std::string& what, int i, int j) {
    Worst worst(what, "nested dual numbers", "zero");
    Random random(seed);
    for (int k = 0; k < 200; ++k) {
      const OnChute s(random);
      worst.see(second(s, i, j), 0, std::abs(second(s, 2, 2)), s.where());
    }
    return worst.check();
  };
  zero.printed = {"0", {vanishing("h_x1x1", 1, 1), vanishing("h_x1x2", 1, 2)}};
  zero.near_misses = {{"h_x2x2 = 0", {vanishing("h_x2x2", 2, 2)}}};
  const V h22{"nested dual numbers", [](S s) { return values(second(s, 2, 2)); }};
  Claim bend = formula_claim<OnChute>(
      "3.13-h22", 1681, "h_x2x2", seed,
      {"R^2/((R^2 - x2^2)^(3/2) cos(theta))",
       [](S s) { return values(s.chute.R * s.chute.R / (std::pow(root(s), 3) * s.cosine())); }},
      h22,
      {{"x2^2 for R^2", [](S s) { return values(s.x2 * s.x2 / (std::pow(root(s), 3) * s.cosine())); }},
       {"power 1/2", [](S s) { return values(s.chute.R * s.chute.R / (root(s) * s.cosine())); }}});
  bend.says = "h_x2x2 is R^2/((R^2 - x2^2)^(3/2) cos(theta))";
  const std::string bar = "The fraction's bar is lost: ";
  return {
      misprinted("3.13-h1", 1673, "h_x1", seed,
                 {"-H L cos(theta)", [](S s) { return values(-s.chute.H * s.chute.L * s.cosine()); }},
                 {"-H/(L cos(theta))", [](S s) { return values(-s.chute.H / (s.chute.L * s.cosine())); }}, h1,
                 {"+H/(L cos(theta))", [](S s) { return values(s.chute.H / (s.chute.L * s.cosine())); }},
                 bar + "$h_{x_1} = -H/(L\\cos\\theta)$. For the default chute that is $-0.75$, and the "
                       "product $-12$."),
      misprinted(
          "3.13-h2", 1677, "h_x2", seed,
          {"x2 (R^2 - x2^2)^(1/2) cos(theta)", [](S s) { return values(s.x2 * root(s) * s.cosine()); }},
          {"x2/((R^2 - x2^2)^(1/2) cos(theta))", [](S s) { return values(s.x2 / (root(s) * s.cosine())); }},
          h2, {"-x2/(...)", [](S s) { return values(-s.x2 / (root(s) * s.cosine())); }},
          bar +
              "$h_{x_2} = x_2/\\big((R^2-x_2^2)^{1/2}\\cos\\theta\\big)$. Towards the rim this slope becomes "
              "infinite, and the product zero."),
      zero, bend};
}

// ---- the equations of motion ------------------------------------------------------------------------------

/// `square` stands for x2'^2 and `slope` for h_x1.
Value published(S s, double square, double slope, double gravity = 1) {
  const double R2 = s.chute.R * s.chute.R, c = s.cosine(), r = root(s), t = s.chute.H / (s.chute.L * c);
  const double above = R2 * square / (r * r * r * c) + gravity * s.g;
  const double factor = -above / (1 + t * t + s.x2 * s.x2 / (r * r * c * c));
  return values(factor * slope, factor * s.x2 / (r * c));
}

std::vector<Claim> motion(double seed) {
  const V lagrange{"Lagrange's equations by nested dual numbers", [](S s) { return s.accelerations(); }};
  const auto slope = [](S s) { return -s.chute.H / (s.chute.L * s.cosine()); };
  const V meant{"R^2 x2'^2 above, -H/(L cos(theta)) in the vector",
                [=](S s) { return published(s, s.v2 * s.v2, slope(s)); }};
  Claim equations = misprinted(
      "3.13-equations", 1691, "(x1'', x2'')", seed,
      {"R^2 x2^2 above, -H L cos(theta) in the vector",
       [](S s) { return published(s, s.x2 * s.x2, -s.chute.H * s.chute.L * s.cosine()); }},
      meant, lagrange, {"gravity upwards", [=](S s) { return published(s, s.v2 * s.v2, slope(s), -1); }},
      "A dot and two bars are lost: above stands $R^2\\dot x_2^2$, and the vector is the gradient "
      "$(-H/(L\\cos"
      "\\theta),\\, x_2/((R^2-x_2^2)^{1/2}\\cos\\theta))$. So read, it is what Lagrange's equations give, in "
      "the "
      "coordinates of the plane and in those of the cylinder.");
  equations.says = "(x1'', x2'') has R^2 x2^2 above and -H L cos(theta) in the vector";
  equations.meant.checks.push_back(
      compare<OnChute>("(x1'', x2'')", meant,
                       {"Lagrange's equations along and about the axis, mapped by dual numbers",
                        [](S s) { return s.accelerations_about_axis(); }},
                       seed));

  const auto on_center = [](S s) {
    OnChute there = s;
    there.x2 = there.v2 = 0;
    return there;
  };
  const auto acceleration = [=](S s) { return on_center(s).accelerations(); };
  const V truth{"Lagrange's equations at x2 = x2' = 0", [=](S s) { return values(acceleration(s)[0]); }};
  const V ratio{"g t/(1 + t^2), t = H/(L cos(theta))", [](S s) {
                  const double t = s.chute.H / (s.chute.L * s.cosine());
                  return values(s.g * t / (1 + t * t));
                }};
  const V tangent{"g tan(theta)/(1 + tan(theta)^2)", [](S s) {
                    const double t = std::tan(s.theta());
                    return values(s.g * t / (1 + t * t));
                  }};
  Claim center = formula_claim<OnChute>(
      "3.13-center_acceleration", 1717, "x1'' on the center line", seed,
      {"(g/2) sin(2 theta)", [](S s) { return values(s.g / 2 * std::sin(2 * s.theta())); }}, truth,
      {{"g sin(theta)", [](S s) { return values(s.g * std::sin(s.theta())); }},
       {"g sin(2 theta)", [](S s) { return values(s.g * std::sin(2 * s.theta())); }}});
  center.says = "x1'' on the center line is (g/2) sin(2 theta)";
  for (const V& form : {ratio, tangent})
    center.printed.checks.push_back(compare("x1'' on the center line", form, truth, seed));

  Claim position{"3.13-center_motion", 1735, "x1(t) = x1(0) + x1'(0) t + (g sin(2 theta)/4) t^2"};
  const auto moves = [&](double quarter) {
    const auto x = [quarter](S s) {
      return [&s, quarter](const auto& t) {
        return s.x1 + s.v1 * t + (s.g * std::sin(2 * s.theta()) * quarter) * t * t;
      };
    };
    return compare<OnChute>(
        "(x1(0), x1'(0), x1'')",
        {"the published x1(t), differentiated by dual numbers",
         [=](S s) { return values(x(s)(0.0), derivative(x(s), 0.0), second_derivative(x(s), 1.5)); }},
        {"as started, and Lagrange's equations", [=](S s) { return values(s.x1, s.v1, acceleration(s)[0]); }},
        seed);
  };
  position.printed = {"as stated", {moves(0.25)}};
  position.near_misses = {{"g sin(2 theta)/2", {moves(0.5)}}};
  return {equations, center, position};
}

// ---- what is said about it --------------------------------------------------------------------------------

template <class Holds>
Check in_all(const std::string& says, double seed, const Holds& holds) {
  Random random(seed);
  long violations = 0;
  std::string where;
  for (int i = 0; i < 200; ++i) {
    const OnChute sample(random);
    if (holds(sample)) continue;
    if (violations++ == 0) where = "the first: " + sample.where();
  }
  return never(says, violations, 200, where);
}

/// x2'' at x2 = `x2` and x2' = 0, with a side wind, friction k and the speed v1, against zero.
Check at_rest_across(const std::string& what, double seed, double x2, double wind, bool friction) {
  Worst worst(what, "Lagrange's equations", "zero");
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    OnChute s(random);
    s.x2 = x2;
    s.v2 = 0;
    const Value a = s.accelerations(friction ? s.k : 0, wind);
    worst.see(a[1], 0, size_of(a), s.where());
  }
  return worst.check();
}

std::vector<Claim> statements(double seed) {
  Claim solution{"3.13-x2_zero", 1715, "x2 = 0 for all time solves the second equation"};
  solution.printed = {"x2'' = 0 at x2 = x2' = 0", {at_rest_across("x2''", seed, 0, 0, false)}};
  solution.near_misses = {{"x2 = 0.05 for all time", {at_rest_across("x2''", seed, 0.05, 0, false)}}};

  Claim stays{"3.13-stays_in_center", 1715, "from the center without speed across, it stays in the center"};
  const auto staying = [&](double across) {
    Worst worst("x2 after 1 s", "Fehlberg 7(8) on the height field", "zero");
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
      const OnChute s(random);
      const InPlane<double> ball{s.chute, s.g, {s.x1, 0, s.v1, across}};
      worst.see(ode::integrate<ode::Fehlberg78>(ball, ball.start(), 0, 1, 1e-10).value[1], 0, s.chute.R,
                s.where());
    }
    return worst.check();
  };
  stays.printed = {"x2 = 0", {staying(0)}};
  stays.near_misses = {{"with speed across as well", {staying(0.01)}}};

  Claim positive{
      "3.13-positive", 1733,
      "x1'' on the center line is a positive constant (the chute being neither level nor vertical)"};
  const auto constant = [&](const std::string& what, double moved) {
    return compare<OnChute>(what,
                            {"at one place and speed",
                             [](S s) {
                               OnChute a = s;
                               a.x2 = a.v2 = 0;
                               return values(a.accelerations()[0], a.accelerations()[0] > 0);
                             }},
                            {"at another, and true",
                             [=](S s) {
                               OnChute a = s;
                               a.x1 = 1 - s.x1;
                               a.v1 = 2 - s.v1;
                               a.x2 = moved * s.x2;
                               a.v2 = 0;
                               return values(a.accelerations()[0], 1);
                             }},
                            seed);
  };
  positive.printed = {"constant and positive", {constant("(x1'', positive)", 0)}};
  positive.near_misses = {{"the same beside the center line", {constant("(x1'', positive)", 1)}},
                          {"in a level chute as well", {in_all("x1'' <= 0 in a level chute", seed, [](S s) {
                             OnChute level = s;
                             level.chute.H = level.x2 = level.v2 = 0;
                             return level.accelerations()[0] > 0;
                           })}}};

  Claim always{"3.13-always_positive", 1733, "the acceleration along x1 is always positive"};
  always.printed = {"x1'' > 0", {in_all("x1'' <= 0", seed, [](S s) { return s.accelerations()[0] > 0; })}};
  always.near_misses = {
      {"x2'' > 0", {in_all("x2'' <= 0", seed, [](S s) { return s.accelerations()[1] > 0; })}}};

  Claim speed{"3.13-speed_increases", 1733, "the speed and the position x1 increase"};
  const auto center = [](S s, double t) {
    const double a = s.g * s.chute.s() * s.cosine();
    return Pair{s.x1 + s.v1 * t + a * t * t / 2, s.v1 + a * t};
  };
  speed.printed = {"|x1'| and x1 increase", {in_all("|x1'| or x1 falls within 1 ms", seed, [=](S s) {
                     const Pair then = center(s, 1e-3);
                     return std::abs(then[1]) > std::abs(s.v1) && then[0] > s.x1;
                   })}};
  speed.corrected = {"x1' increases; |x1'| and x1 do once x1' >= 0",
                     {in_all("x1' falls within 1 ms", seed, [=](S s) { return center(s, 1e-3)[1] > s.v1; }),
                      in_all("x1' >= 0, and |x1'| or x1 falls within 1 ms", seed, [=](S s) {
                        const Pair then = center(s, 1e-3);
                        return s.v1 < 0 || (std::abs(then[1]) > std::abs(s.v1) && then[0] > s.x1);
                      })}};
  speed.near_misses = {{"x1 increases", {in_all("x1 falls within 1 ms", seed, [=](S s) {
                          return center(s, 1e-3)[0] > s.x1;
                        })}}};
  speed.why =
      "The next formula admits any $\\dot x_1(0)$. A ball sent up the chute first slows down, and its $x_1$ "
      "decreases, until $t = -2\\dot x_1(0)/(g\\sin2\\theta)$: the default ball below, with $\\dot x_1(0) = "
      "-0.8$, climbs for 0.17 s, 7 cm along $x_1$, and is back at its start after 0.34 s. What increases "
      "from the start is the velocity $\\dot x_1$.";

  Claim angle{"3.13-steeper_is_faster", 1737, "the larger the angle, the larger the acceleration"};
  const auto at_angle = [](S s, double theta) {
    OnChute a = s;
    a.chute.H = a.chute.L * std::sin(theta);
    a.x2 = a.v2 = 0;
    return a.accelerations();
  };
  const auto steeper = [=](const std::string& says, const auto& expected) {
    return in_all(says, seed, [=](S s) {
      const double theta = s.theta(), more = theta + 0.2 * (std::numbers::pi / 2 - theta);
      return expected(s, theta, more);
    });
  };
  angle.printed = {"x1'' increases with theta",
                   {steeper("a steeper chute with smaller x1''", [=](S s, double theta, double more) {
                     return at_angle(s, more)[0] > at_angle(s, theta)[0];
                   })}};
  angle.corrected = {
      "x1'' increases up to 45 degrees and decreases beyond; the acceleration along the chute increases",
      {steeper("x1'' not so",
               [=](S s, double theta, double more) {
                 const double change = at_angle(s, more)[0] - at_angle(s, theta)[0];
                 const double quarter = std::numbers::pi / 4;
                 return theta >= quarter ? change < 0 : more > quarter || change > 0;
               }),
       steeper("the acceleration along the chute falls", [=](S s, double theta, double more) {
         return at_angle(s, more)[0] / std::cos(more) > at_angle(s, theta)[0] / std::cos(theta);
       })}};
  angle.near_misses = {
      {"x1'' increases up to 60 degrees", {steeper("x1'' not so", [=](S s, double theta, double more) {
         return theta >= std::numbers::pi / 3 || more > std::numbers::pi / 3 ||
                at_angle(s, more)[0] > at_angle(s, theta)[0];
       })}}};
  angle.why =
      "$\\ddot x_1 = \\frac g2\\sin2\\theta$ is largest at $45^\\circ$, $g/2$, and falls to zero at "
      "$90^\\circ$: "
      "in free fall nothing moves sideways. What grows with the angle is the acceleration along the chute, "
      "$g\\sin\\theta$, of which $\\ddot x_1$ is the horizontal part. Seen from above, as on a map of a "
      "game's level, "
      "the ball in a chute of $75^\\circ$ looks as slow as that in one of $15^\\circ$: both cover 1.23 m in "
      "the first second.";

  Claim form{"3.13-friction_form", 1739, "with viscous friction still x2'' = S x2, S a scalar"};
  Worst at_center("x2'' at x2 = 0, x2' not 0", "Lagrange's equations with friction", "S x2 = 0");
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    OnChute s(random);
    s.x2 = 0;
    const Value a = s.accelerations(s.k);
    at_center.see(a[1], 0, size_of(a), s.where());
  }
  form.printed = {"x2'' = S x2", {at_center.check()}};
  form.corrected = {
      "x2'' = S x2 - k x2', k the friction over the mass",
      {compare<OnChute>(
          "(x1'', x2'')",
          {"without friction, less k x'",
           [=](S s) {
             const Value a = published(s, s.v2 * s.v2, -s.chute.H / (s.chute.L * s.cosine()));
             return values(a[0] - s.k * s.v1, a[1] - s.k * s.v2);
           }},
          {"Lagrange's equations, friction -k x' in space", [](S s) { return s.accelerations(s.k); }},
          seed)}};
  form.near_misses = {
      {"x2'' = S x2 - 2 k x2'",
       {compare<OnChute>(
           "(x1'', x2'')",
           {"without friction, less k x1' and 2 k x2'",
            [=](S s) {
              const Value a = published(s, s.v2 * s.v2, -s.chute.H / (s.chute.L * s.cosine()));
              return values(a[0] - s.k * s.v1, a[1] - 2 * s.k * s.v2);
            }},
           {"Lagrange's equations, friction -k x' in space", [](S s) { return s.accelerations(s.k); }},
           seed)}}};
  form.why =
      "Friction adds $-k\\dot x_2$: where the ball crosses the center line, $x_2 = 0$, the form says $\\ddot "
      "x_2 "
      "= 0$, but friction slows it. The equation is $\\ddot x_2 = S x_2 - k\\dot x_2$, with the $S$ of "
      "before.";

  Claim still{"3.13-friction_center", 1739, "with viscous friction x2 = 0 for all time is still a solution"};
  still.printed = {"x2'' = 0 at x2 = x2' = 0", {at_rest_across("x2'' with friction", seed, 0, 0, true)}};
  still.near_misses = {{"with a wind across", {at_rest_across("x2'' with a wind", seed, 0, 0.1, true)}}};
  return {solution, stays, positive, always, speed, angle, form, still};
}

Given<double> asked(const Parameters& p) {
  if (!(p["H"] < p["L"])) throw BadInput("the chute's fall H must be less than its length L");
  return {p["R"], p["L"], p["H"], p["g"], p["phi"], p["u"]};
}

Quantity swinging_ball(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return swing(asked(p), horizon, truth);
}

Scene scene() {
  return {swinging_ball,
          4,
          centimeter,
          "phi",
          {0.1, 0.5, 1, 1.35, 1.5},
          {"phi", "u"},
          {{"x1", "x2", "x3"}, "s", {{"m", {0, 1, 2}}}},
          {{"chapters/03_rigid_body_motion/13_tilted_chute/models.hpp"},
           {{"center line", "tilted_chute::CenterLine<double>{{R, L, H, g, phi, u}}"},
            {"small angle", "tilted_chute::SmallAngle<double>{{R, L, H, g, phi, u}}"},
            {"elliptic angle", "tilted_chute::EllipticAngle<double>({R, L, H, g, phi, u})"},
            {"angle about the axis", "tilted_chute::Angle<double>{{R, L, H, g, phi, u}}"},
            {"height field", "tilted_chute::in_plane<double>({R, L, H, g, phi, u})"},
            {"Cartesian with constraint", "tilted_chute::InSpace<double>{{R, L, H, g, phi, u}}"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const double seed = p["seed"];
  const Horizon horizon{scene().horizon};
  const Given<double> ball = asked(p);
  Given<double> center = ball, steep = ball, rim = ball;
  center.phi = 0;
  steep.phi = 1.5;
  rim.phi = std::numbers::pi / 2;
  std::vector<Claim> claims = cylinder(seed);
  for (const auto& more : {axis(seed), solved(seed), derivatives(seed), motion(seed), statements(seed)})
    claims.insert(claims.end(), more.begin(), more.end());
  return {claims,
          {motion(scene(), p, truth), on_center(center, horizon, truth), below_rim(steep, horizon, truth),
           from_rim(rim, horizon, truth)}};
}

}  // namespace ex03_13

Exercise exercise_3_13() {
  using namespace ex03_13;
  return {
      "Ball in a tilted chute",
      "A ball slides in a chute, the lower half of a cylinder of radius $R$ whose axis falls by $H$ over its "
      "length $L$. Write the chute as a height field and find the ball's equations of motion; how does it "
      "move on the center line?",
      parameters, scene(), study};
}

}  // namespace oddity
