// Exercise 3.7: when is a bead, let go at rest at q = 1 on the frictionless curve (q, q^2, q^3), at the
// origin?
//   one coordinate   (1 + 4q^2 + 9q^4) q'' = -(3g q^2 + 2q (2 + 9q^2) q'^2)
//   energy           (1 + 4q^2 + 9q^4) q'^2 = 2g (q0^3 - q^3)
// The equations judged are compared with Lagrange's equation, whose Lagrangian is differentiated by dual
// numbers from the curve alone, and with the wire's forces in Cartesian coordinates. On the energy's level
// q = q0 for ever is a solution too, and the time's integrand is infinite at q0; with q = q0 (1 - u^2)
// neither is so.

#include <algorithm>

#include "chapters/03_rigid_body_motion/07_bead_on_cubic/bead_on_cubic.hpp"

namespace oddity {

namespace ex03_07 {

using namespace bead_on_cubic;
using std::abs, std::sqrt;

constexpr Parameter parameters[] = {
    {"q0", 1, "m", "release", 0.05, 10},
    {"g", 1, "m/s^2", "gravity", 1e-3, 1e3},
    {"seed", 7, "", "seed of the random samples", 0, 1e9, whole_number},
};

Quantity position(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return slide({p["q0"], p["g"]}, horizon, truth);
}

Scene scene() {
  return {position,
          4,
          centimeter,
          "q0",
          {0.25, 0.5, 1, 1.5, 2},
          {"q0"},
          {{"x", "y", "z"}, "s", {{"m", {0, 1, 2}}}},
          {{"chapters/03_rigid_body_motion/07_bead_on_cubic/models.hpp"},
           {{"straight tangent", "bead_on_cubic::StraightTangent<double>{{q0, g}}"},
            {"energy in q", "bead_on_cubic::EnergyInQ<double>{{q0, g}}"},
            {"energy in u", "bead_on_cubic::EnergyInU<double>{{q0, g}}"},
            {"one coordinate", "bead_on_cubic::OneCoordinate<double>{{q0, g}}"},
            {"Cartesian with constraints", "bead_on_cubic::CartesianWithConstraints<double>{{q0, g}}"}}}};
}

// ---- the claims: formulas ---------------------------------------------------------------------------------

using S = const Sample&;
double bend(S s) { return 2 * s.q + 9 * s.q * s.q * s.q; }
using Versions = std::vector<Version<Sample>>;

std::vector<Claim> formulas(double seed) {
  std::vector<Claim> all;
  const auto says = [&](const char* id, int line, const char* what, const Version<Sample>& printed,
                        const Version<Sample>& truth, const Versions& near) {
    all.push_back(formula_claim(std::string("3.7-") + id, line, what, seed, printed, truth, near));
    all.back().says = std::string(what) + " is " + printed.text;
  };
  says("tangent", 1375, "dx/dq", {"(1, 2q, 3q^2)", [](S s) { return values(1, 2 * s.q, 3 * s.q * s.q); }},
       {"dual numbers", [](S s) { return velocity(s.q, 1.0); }},
       {{"(1, 2q, 2q^2)", [](S s) { return values(1, 2 * s.q, 2 * s.q * s.q); }}});
  says("velocity", 1375, "x'",
       {"q' (1, 2q, 3q^2)", [](S s) { return values(s.v, 2 * s.q * s.v, 3 * s.q * s.q * s.v); }},
       {"dual numbers", [](S s) { return velocity(s.q, s.v); }},
       {{"dx/dq alone", [](S s) { return values(1, 2 * s.q, 3 * s.q * s.q); }}});
  says("kinetic_energy", 1381, "T as a function of q and q'",
       {"(m/2) (1 + 4q^2 + 9q^4) q'^2", [](S s) { return s.m / 2 * metric(s.q) * s.v * s.v; }},
       {"(m/2) |x'|^2, x' by dual numbers", [](S s) { return s.T()(s.q, s.v, 0.0); }},
       {{"9q^2 for 9q^4", [](S s) { return s.m / 2 * (1 + 13 * s.q * s.q) * s.v * s.v; }}});
  const Version<Sample> by_definition{"(m/2) x'.x', x' by dual numbers",
                                      [](S s) { return s.T()(s.q, s.v, 0.0); }};
  const auto by_speed = [seed, by_definition](const std::string& text, double factor, double power) {
    const Version<Sample> version{text, [=](S s) {
                                    const auto v = velocity(s.q, s.v);
                                    const double speed = std::hypot(v[0], v[1], v[2]);
                                    return factor * s.m * std::pow(speed, power);
                                  }};
    return Reading{text, {compare<Sample>("T by the speed", version, by_definition, seed)}};
  };
  Claim speed{"3.7-kinetic_energy_by_speed", 1379, "T = (m/2) |x'|"};
  speed.printed = by_speed("(m/2) |x'|", 0.5, 1);
  speed.meant = by_speed("(m/2) |x'|^2", 0.5, 2);
  speed.near_misses = {by_speed("m |x'|^2", 1, 2)};
  speed.why =
      "The speed's exponent is missing; the next form of the line, with $\\dot q^2$, comes from the square. "
      "A "
      "bead twice as fast has four times the energy, and by the printed form twice.";
  all.push_back(speed);
  says("dT_dq", 1385, "the derivative of T by q",
       {"2m (2q + 9q^3) q'^2", [](S s) { return 2 * s.m * bend(s) * s.v * s.v; }},
       {"dual numbers", [](S s) { return d_dq(s.T(), s.q, s.v); }},
       {{"m (2q + 9q^3) q'^2", [](S s) { return s.m * bend(s) * s.v * s.v; }}});
  says("dT_dqdot", 1387, "the derivative of T by q'",
       {"m (1 + 4q^2 + 9q^4) q'", [](S s) { return s.m * metric(s.q) * s.v; }},
       {"dual numbers", [](S s) { return d_dv(s.T(), s.q, s.v); }},
       {{"half of it", [](S s) { return s.m / 2 * metric(s.q) * s.v; }}});
  says("momentum_rate", 1393, "the time derivative of dT/dq'",
       {"m (1 + 4q^2 + 9q^4) q'' + 4m (2q + 9q^3) q'^2",
        [](S s) { return s.m * (metric(s.q) * s.a + 4 * bend(s) * s.v * s.v); }},
       {"nested dual numbers", [](S s) { return momentum_rate(s.T(), s.q, s.v, s.a); }},
       {{"2m for 4m", [](S s) { return s.m * (metric(s.q) * s.a + 2 * bend(s) * s.v * s.v); }}});
  says("force", 1395, "the generalized force of gravity",
       {"-3 m g q^2", [](S s) { return -3 * s.m * s.g * s.q * s.q; }},
       {"dL/dq at rest by dual numbers", [](S s) { return d_dq(s.L(), s.q, 0); }},
       {{"+3 m g q^2", [](S s) { return 3 * s.m * s.g * s.q * s.q; }}});
  says("lagrange_equation", 1407, "the difference of the sides of Lagrange's equation",
       {"m (1 + 4q^2 + 9q^4) q'' + (4m - 2m) (2q + 9q^3) q'^2 + 3 m g q^2",
        [](S s) { return s.m * (metric(s.q) * s.a + (4 - 2) * bend(s) * s.v * s.v + 3 * s.g * s.q * s.q); }},
       {"d/dt dL/dq' - dL/dq by nested dual numbers",
        [](S s) { return momentum_rate(s.L(), s.q, s.v, s.a) - d_dq(s.L(), s.q, s.v); }},
       {{"4m + 2m", [](S s) {
           return s.m * (metric(s.q) * s.a + (4 + 2) * bend(s) * s.v * s.v + 3 * s.g * s.q * s.q);
         }}});
  const Version<Sample> solved{"-(3g q^2 + 2q (2 + 9q^2) q'^2) / (1 + 4q^2 + 9q^4)", [](S s) {
                                 std::array<double, 2> rate;
                                 OneCoordinate<double>{{s.q, s.g}}(std::array{s.q, s.v}, rate, 0.0);
                                 return rate[1];
                               }};
  says("equation_of_motion", 1411, "q'' (the minus sign being read as that of the whole fraction)", solved,
       {"Lagrange's equation by nested dual numbers, the mass at random",
        [](S s) { return lagrange_acceleration(s.L(), s.q, s.v); }},
       {{"minus before the first term alone",
         [](S s) { return (2 * bend(s) * s.v * s.v - 3 * s.g * s.q * s.q) / metric(s.q); }},
        {"q (2 + 9q^2) for 2q (2 + 9q^2)",
         [](S s) { return -(bend(s) * s.v * s.v + 3 * s.g * s.q * s.q) / metric(s.q); }}});
  all.back().printed.checks.push_back(compare<Sample>("q'' in Cartesian coordinates", solved,
                                                      {"the wire's two forces", &Sample::by_forces}, seed));
  says("only_gravity", 1415, "the bead's acceleration",
       {"x'' = -g k", [](S s) { return values(0, 0, -s.g); }}, {"Lagrange's equation", &Sample::acceleration},
       {});
  const auto power = [seed](const std::string& text, const std::function<double(S)>& of) {
    return Reading{text,
                   {compare<Sample>("power of the force on the bead", {text, of},
                                    {"m x''.x' by Lagrange's equation",
                                     [](S s) {
                                       const auto a = s.acceleration(), v = velocity(s.q, s.v);
                                       return s.m * (v[0] * a[0] + v[1] * a[1] + v[2] * a[2]);
                                     },
                                     [](S s) {
                                       const auto a = s.acceleration(), v = velocity(s.q, s.v);
                                       return s.m * (abs(v[0] * a[0]) + abs(v[1] * a[1]) + abs(v[2] * a[2]));
                                     }},
                                    seed)}};
  };
  all.back().corrected =
      power("gravity alone does work", [](S s) { return -s.m * s.g * velocity(s.q, s.v)[2]; });
  all.back().near_misses = {power("twice gravity's work, as if the wire did as much",
                                  [](S s) { return -2 * s.m * s.g * velocity(s.q, s.v)[2]; })};
  all.back().says = "gravity alone acts on the bead";
  all.back().why =
      "The wire pushes as well: at the release with $\\sqrt{70}/14 = 0.598$ of the bead's weight. With "
      "gravity "
      "alone the bead would leave the curve and be at the height of the origin after $\\sqrt{2/g}=1.41$ s, "
      "not "
      "2.24 s. The wire's force is normal to the curve and does no work, so that the conclusion stands.";
  return all;
}

// ---- the claims: the motion -------------------------------------------------------------------------------

struct Row {
  int step;
  double q, v;
  std::array<double, 3> position;
};

Reading row_reading(const std::string& text, const Row& row,
                    const std::vector<OneCoordinate<double>::State>& run, const Reference& truth) {
  const auto& state = run[static_cast<std::size_t>(row.step)];
  const double t = row.step / 1000.0;
  return {
      text,
      {{"q, q'", {"as printed", {row.q, row.v}}, {"the book's run", state}, printed_decimals(8)},
       {"position", {"as printed", row.position}, {"the book's run", curve(state[0])}, printed_decimals(4)},
       {"q",
        {"as printed", row.q},
        {"table", truth("03_07_slide", {1, 1, t}).value[0]},
        printed_decimals(8)}}};
}

/// How many of the book's steps violate a statement about a state and its successor.
template <class Holds>
Check over_run(const std::string& what, const std::vector<OneCoordinate<double>::State>& run,
               const Holds& holds) {
  long violations = 0;
  for (std::size_t i = 0; i + 1 < run.size(); ++i) violations += !holds(run[i], run[i + 1]);
  return never(what, violations, book_steps);
}

std::vector<Claim> run_down(const std::vector<OneCoordinate<double>::State>& run) {
  using State = OneCoordinate<double>::State;
  const auto force = [](const State& x) { return lagrange_acceleration(Lagrangian{1, 1}, x[0], x[1]); };
  const auto at_origin = event_of<ode::Fehlberg78>(OneCoordinate<double>{{1, 1}}, 1e-12).value.state;

  Claim start{"3.7-start", 1375, "the bead at rest at (1, 1, 1) is q = 1, q' = 0"};
  const auto start_at = [](double q) {
    const auto x = curve(q), v = velocity(q, 0.0);
    return Check{"position and velocity",
                 {"as printed", {1, 1, 1, 0, 0, 0}},
                 {"the curve", {x[0], x[1], x[2], v[0], v[1], v[2]}},
                 exact()};
  };
  start.printed = {"q = 1, q' = 0", {start_at(1)}};
  start.near_misses = {{"q = -1, q' = 0", {start_at(-1)}}};

  const auto positive_after =
      std::ranges::count_if(run.begin() + 1, run.end(), [&](const State& x) { return force(x) > 0; });
  Claim negative{"3.7-rhs_negative", 1415, "q'' is always negative"};
  negative.printed = {"q'' < 0",
                      {over_run("q'' < 0", run, [&](const State& x, const State&) { return force(x) < 0; })}};
  negative.corrected = {
      "q'' < 0 as long as q > 0, q'' = 0 at q = 0, q'' > 0 after it",
      {over_run("q q'' < 0", run, [&](const State& x, const State&) { return x[0] * force(x) < 0; }),
       {"q'' at q = 0", {"Lagrange's equation", force({0, -1})}, {"zero", 0.0}, rounding(1), 1}}};
  negative.near_misses = {
      {"q'' < 0 as long as q > -0.01",
       {over_run("q'' < 0 exactly where q > -0.01", run,
                 [&](const State& x, const State&) { return (force(x) < 0) == (x[0] > -0.01); })}}};
  negative.why =
      "The second term has the sign of $-q$, and at $q=0$ the first is zero as well: there $q''=0$, and "
      "beyond "
      "it $q''$ is positive: in the book's own run after each of the last " +
      std::to_string(positive_after) + " of its " + std::to_string(book_steps) +
      " steps. A program that stops when $q''$ is no longer negative "
      "takes the origin for the end of the curve.";

  Claim slower{"3.7-velocity_decreases", 1415, "q' is a decreasing function of time"};
  slower.printed = {
      "q' decreases",
      {over_run("q' decreases", run, [](const State& a, const State& b) { return b[1] < a[1]; })}};
  slower.corrected = {"q' decreases until q = 0, where it is -sqrt(2g), and increases from then on",
                      {over_run("q' decreases, then increases", run,
                                [](const State& a, const State& b) {
                                  return a[0] > 0 && b[0] < 0 ? true : (b[1] < a[1]) == (a[0] > 0);
                                }),
                       {"q' at q = 0",
                        {"Fehlberg 7(8) and its event", at_origin[1]},
                        {"-sqrt(2 g q0^3), the energy", -sqrt(2.0)},
                        {1e-10, "a hundred tolerances of the integration"}}}};
  slower.near_misses = {{"q' decreases until q = -0.01",
                         {over_run("q' decreases, then increases", run, [](const State& a, const State& b) {
                           return a[0] > -0.01 && b[0] < -0.01 ? true : (b[1] < a[1]) == (a[0] > -0.01);
                         })}}};
  slower.why =
      "$q'$ is least at the origin, $-\\sqrt{2g}$, and rises towards zero afterwards. The two rows printed "
      "show it: -1.41421347 at 2.240 and -1.41420923 at 2.241.";

  Claim moving{"3.7-velocity_negative", 1415, "q' < 0 for all t > 0"};
  const auto later = long_run();
  const auto not_negative = [&](std::size_t first) {
    long violations = 0;
    for (std::size_t i = first; i < later.size(); ++i) violations += !(later[i][1] < 0);
    return never("q' < 0 at t = " + std::to_string(first) + ", ..., 1000", violations,
                 static_cast<long>(later.size() - first));
  };
  moving.printed = {"q' < 0 for t > 0",
                    {not_negative(1), over_run("q' < 0 at the end of each step", run,
                                               [](const State&, const State& b) { return b[1] < 0; })}};
  moving.near_misses = {{"q' < 0 for t >= 0", {not_negative(0)}},
                        {"q'' < 0 for t > 0",
                         {over_run("q'' < 0 at the end of each step", run,
                                   [&](const State&, const State& b) { return force(b) < 0; })}}};

  Claim down{"3.7-slides_down", 1415, "q decreases all the time, and the bead goes down"};
  down.printed = {"q and z decrease",
                  {over_run("q decreases", run, [](const State& a, const State& b) { return b[0] < a[0]; }),
                   over_run("z decreases", run,
                            [](const State& a, const State& b) { return curve(b[0])[2] < curve(a[0])[2]; })}};
  down.near_misses = {{"y decreases", {over_run("y decreases", run, [](const State& a, const State& b) {
                         return curve(b[0])[1] < curve(a[0])[1];
                       })}}};
  return {start, negative, slower, moving, down};
}

std::vector<Claim> arrival_claims(const std::vector<OneCoordinate<double>::State>& run,
                                  const Reference& truth) {
  const Known T = truth("03_07_arrival", {1, 1});
  const auto event = event_of<ode::Fehlberg78>(CartesianWithConstraints<double>{{1, 1}}, 1e-12).value;
  const Tolerance integrated{1e-10, "a hundred tolerances of the integration"};

  Claim gravity{"3.7-needs_g", 1417, "the time depends on g"};
  const auto ratio = [&](double r) {
    return Check{"T at 4g over T at g",
                 {"as stated", r},
                 {"table", truth("03_07_arrival", {1, 4}).value[0] / T.value[0]},
                 rounding(1)};
  };
  gravity.printed = {"T is 1/sqrt(g) times a number", {ratio(0.5)}};
  gravity.near_misses = {{"T does not depend on g", {ratio(1)}}, {"T is 1/g times a number", {ratio(0.25)}}};

  Claim origin{"3.7-at_the_origin", 1417, "the bead is at (0, 0, 0) when q = 0"};
  const auto from_origin = [&](const std::string& by, const Value& x) {
    return Check{"position", {by, x}, {"the origin", {0, 0, 0}}, integrated, 1};
  };
  origin.printed = {
      "x(T) = 0",
      {from_origin("Cartesian, at its event", Value{event.state[0], event.state[1], event.state[2]})}};
  origin.near_misses = {
      {"x(2.24) = 0", {from_origin("table at 2.24", truth("03_07_slide", {1, 1, 2.24}).value)}}};

  Claim numbers{
      "3.7-by_numbers", 1417,
      "a numerical method gives the time (that q(t) has no closed form, and that there is no other hope, is "
      "not judged)"};
  const auto time = [&](const std::string& by, double t) {
    return Check{"T", {by, t}, {"table, by energy quadrature", T.value}, integrated};
  };
  numbers.printed = {"by integration", {time("Cartesian, at its event", event.time)}};
  const auto by_interpolation = [&](std::size_t step, double fraction) {
    const auto &from = run[step], &to = run[step + 1];
    return book_step * (static_cast<double>(step) + fraction * from[0] / (from[0] - to[0]));
  };
  numbers.near_misses = {{"the book's run, its last row above zero", {time("row 2240", 2240 * book_step)}},
                         {"the book's run, half of the way to the zero between its rows",
                          {time("interpolated", by_interpolation(2240, 0.5))}}};

  const Row first{2240, 0.00017622, -1.41421347, {0.0002, 0, 0}},
      second{2241, -0.00123799, -1.41420923, {-0.0012, 0, 0}};
  const auto row_claim = [&](const std::string& id, int line, const Row& row) {
    Claim claim{"3.7-" + id, line, "the output at t = " + shortest(row.step / 1000.0)};
    claim.printed = row_reading("as printed", row, run, truth);
    Row other_q = row, other_v = row;
    other_q.q += 1e-8;
    other_v.v += 1e-8;
    claim.near_misses = {row_reading("last digit of q one up", other_q, run, truth),
                         row_reading("last digit of q' one up", other_v, run, truth)};
    return claim;
  };

  Claim between{"3.7-between", 1425, "q is zero between 2.24 and 2.241"};
  const auto within = [&](double middle) {
    return Check{"T", {"middle of the interval", middle}, {"table", T.value}, {0.0005, "half the interval"}};
  };
  between.printed = {"2.24 < T < 2.241", {within(2.2405)}};
  between.near_misses = {{"2.241 < T < 2.242", {within(2.2415)}}, {"2.239 < T < 2.24", {within(2.2395)}}};

  Claim near{"3.7-near_the_origin", 1425, "the position is about zero in both rows"};
  const auto about_zero = [&](std::size_t step) {
    return Check{"position after step " + std::to_string(step),
                 {"the book's run", curve(run[step][0])},
                 {"the origin", {0, 0, 0}},
                 {sqrt(2.0) * book_step, "the way of one step"},
                 1};
  };
  near.printed = {"|x| below the way of one step", {about_zero(2240), about_zero(2241)}};
  near.near_misses = {{"so one step later", {about_zero(2242)}}};
  return {gravity, origin, numbers, row_claim("row_2240", 1421, first), row_claim("row_2241", 1423, second),
          between, near};
}

Findings study(const Parameters& p, const Reference& truth) {
  const auto run = book_run();
  std::vector<Claim> claims = formulas(p["seed"]);
  for (const auto& more : {run_down(run), arrival_claims(run, truth)})
    claims.insert(claims.end(), more.begin(), more.end());
  std::ranges::stable_sort(claims, {}, &Claim::line);
  return {claims, {arrival({p["q0"], p["g"]}, truth), motion(scene(), p, truth)}};
}

}  // namespace ex03_07

Exercise exercise_3_7() {
  using namespace ex03_07;
  return {
      "Bead on a cubic curve",
      "A bead slides without friction on the curve $(q,q^2,q^3)$ under gravity $-g\\,k$, let go at rest at "
      "$q=1$. Does $q$ decrease all the time, and when is the bead at the origin?",
      parameters, scene(), study};
}

}  // namespace oddity
