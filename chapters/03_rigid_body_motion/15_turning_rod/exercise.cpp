// Exercise 3.15: a mass slides on a rod from the origin to (a, 0, a) that turns about the x3-axis; a spring
// joins it to (c, 0, 0). Where does it arrive in the (x2, x3)-plane?
//   s'' = w^2 s / 2 - (K/m) (1 - ell/r) (s - p),  p = c cos(w t) / sqrt(2),  r^2 = s^2 - 2 p s + c^2
// The book's lambda is s here, and its constant angular speed, pi/4, is w. Every formula of the text is
// compared with the Lagrangian, which is built from Rodrigues' rotation and the spring's energy and
// differentiated by dual numbers. Energy is not conserved, the rod being driven: the balance with the work
// done is what is watched. The cosine in the last line printed is that of the x87's FCOS, whose pi has 66
// bits
//   [Intel 64 and IA-32 Architectures Software Developer's Manual, vol. 1, 8.3.8].

#include <algorithm>

#include "chapters/03_rigid_body_motion/15_turning_rod/turning_rod_formulas.hpp"

namespace oddity {

namespace ex03_15 {

using namespace turning_rod;

const Rod<double> book{{1, 1, 10, quarter, 2}};

constexpr Parameter parameters[] = {
    {"m", 1, "kg", "mass", 0.1, 100},
    {"c", 1, "m", "where the spring is fixed on the x1-axis", 0, 10},
    {"K", 10, "N/m", "stiffness of the spring", 0.1, 1000},
    {"w", quarter, "rad/s", "angular speed of the rod", 0.01, 10},
    {"s", 2, "m", "start, by its distance from the origin", 0.1, 10},
    {"stiff", 1e4, "N/m", "stiffness of the stiff spring", 100, 2e4},
    {"r", 1.5, "", "speed of the runaway over sqrt(2K/m)", 1.1, 5},
    {"seed", 15, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the claims: the motion -------------------------------------------------------------------------------

const Tolerance integrated{1e-10, "a hundred tolerances of the integration"};

/// The force's direction: how many random states violate a statement about it and the stretch.
template <class Holds>
Check pulls(const std::string& what, double seed, const Holds& holds) {
  Random random(seed);
  long violations = 0;
  for (int i = 0; i < 200; ++i) {
    const Sample s(random);
    const std::array to_end{s.c - s.x()[0], -s.x()[1], -s.x()[2]};
    violations += !holds(dot(force_of(s.spring(), s.x()), to_end) > 0, length(to_end) > s.ell);
  }
  return never(what, violations, 200);
}

/// How many states of the motion up to t = 2 from lambda = s are not on the segment of length 4.
Check stays_on(const std::string& start, double s, double K, double w = quarter) {
  const AlongTheRod<double> rod{{{book.m, book.c, K, w, s}}};
  const auto states =
      ode::integrate<ode::DormandPrince54>(rod, rod.start(), Horizon{2, 200}.times(), 1e-10).value;
  long violations = 0;
  for (const auto& x : states) violations += !(0 <= x[0] && x[0] <= 4);
  return never("0 <= lambda <= L " + start, violations, static_cast<long>(states.size()));
}

/// An end of the segment is passed at the time named.
Check passes(double end, double s, double K, double time) {
  const AlongTheRod<double> rod{{{book.m, book.c, K, quarter, s}}};
  const auto beyond = [=](const AlongTheRod<double>::State& x, double) { return x[0] - end; };
  const double found = ode::find_event<ode::Fehlberg78>(rod, rod.start(), 0, 3, 1e-12, beyond).value.time;
  return {"time at which lambda = " + shortest(end) + ", from lambda = " + shortest(s) +
              " with K = " + shortest(K),
          {"as told", time},
          {"the equation of motion and its event", found},
          printed_decimals(3)};
}

Claim on_the_segment() {
  Claim claim{"3.15-on_the_segment", 1755,
              "0 <= lambda(t) <= L, whatever L, c, m, K and the start are selected"};
  const Check middle = stays_on("from the middle with K = 10, as in the listing", 2, 10);
  claim.printed = {"at any time, from any start",
                   {middle, stays_on("from 3/4 of the segment with K = 1", 3, 1),
                    stays_on("from 1/4 of the segment with K = 20", 1, 20)}};
  claim.corrected = {"in the listing's motion; the equations themselves know no end of the segment",
                     {middle, passes(4, 3, 1, 1.700), passes(0, 1, 20, 1.892)}};
  claim.near_misses = {{"at any speed, such as 1.5 sqrt(2K/m)",
                        {stays_on("from the middle at w = 1.5 sqrt(2K/m)", 2, 10, 1.5 * sqrt(20.0))}}};
  claim.why =
      "Nothing in the equation of motion stops the mass at $0$ or at $L$. With the listing's $L=4$, $c=m=1$ "
      "a "
      "weak spring, $K=1$, lets it slide off the upper end after 1.70 s when it starts at three quarters of "
      "the segment, and $\\lambda(2)=4.23$; a stiff one, $K=20$, draws it through the lower end after 1.89 s "
      "when it starts at a quarter, and $\\lambda(2)=-0.14$. A game has to look for both events, or its mass "
      "goes on along a rod that is not there.";
  return claim;
}

std::vector<Claim> motion(double seed, const Value& end) {
  const CartesianWithConstraints<double> cartesian{book};

  Claim towards{"3.15-force_towards", 1819, "the force is towards (c, 0, 0)"};
  towards.printed = {"always", {pulls("F . (c i - x) > 0", seed, [](bool pull, bool) { return pull; })}};
  towards.corrected = {"when the spring is stretched, and away from it when it is compressed",
                       {pulls("F . (c i - x) > 0 exactly when r > ell", seed,
                              [](bool pull, bool stretched) { return pull == stretched; })}};
  towards.near_misses = {{"when the spring is compressed",
                          {pulls("F . (c i - x) > 0 exactly when r < ell", seed,
                                 [](bool pull, bool stretched) { return pull != stretched; })}}};
  towards.why =
      "A compressed spring pushes. It does so at the end of this very motion, where $r=1.410$ is less than "
      "$\\ell=1.474$. The formula (1821) has it right; a game that takes the sentence and lets the spring "
      "always "
      "pull has the mass 3.5 mm off at $t=2$.";

  Claim arrives{"3.15-arrival_time", 1849, "the mass arrives in the (x2, x3)-plane at t = 2"};
  const auto x1 = [](const CartesianWithConstraints<double>::State& x, double) { return x[0]; };
  const double arrival =
      ode::find_event<ode::Fehlberg78>(cartesian, cartesian.start(), 0, 5, 1e-12, x1).value.time;
  const auto at = [&](double t) {
    return Check{"time", {"as stated", t}, {"Cartesian motion, its first x1 = 0", arrival}, integrated};
  };
  arrives.printed = {"t = 2", {at(2)}};
  arrives.near_misses = {{"t = 4, half a turn", {at(4)}}, {"t = 1", {at(1)}}};

  Claim numbers{
      "3.15-by_numbers", 1847,
      "a numerical method gives the position at t = 2 (that there is no closed form is not judged)"};
  const auto place = [&](const std::string& by, const Value& x) {
    return Check{"x(2)", {by, x}, {"table", end}, integrated};
  };
  const auto by_time = [&](double t) {
    const auto state = ode::integrate<ode::Fehlberg78>(cartesian, cartesian.start(), 0, t, 1e-12).value;
    return place("Cartesian, Fehlberg 7(8)", cartesian.observe(state, t));
  };
  numbers.printed = {"by integration", {by_time(2)}};
  numbers.near_misses = {
      {"by integration up to a step of the listing before", {by_time(1.99)}},
      {"by 16 steps of Runge-Kutta 4",
       {place("Cartesian, Runge-Kutta 4",
              cartesian.observe(
                  ode::integrate<ode::RungeKutta4>(cartesian, cartesian.start(), 0, 2, 0.125).value, 2))}}};

  // lambda(2), the segment's length being of no account but for the start b
  Claim select{"3.15-parameters", 1867, "the parameters to select are L, c, m and K"};
  const auto end_of = [](double b, double m, double K) {
    const AlongTheRod<double> rod{{{m, book.c, K, quarter, sqrt2 * b}}};
    return ode::integrate<ode::Fehlberg78>(rod, rod.start(), 0, 2, 1e-14).value[0];
  };
  const double half = book.s0 / sqrt2;
  const auto same = [&](const std::string& one, double x, const std::string& another, double y) {
    return Check{"lambda(2), c being 1 in both",
                 {one, x},
                 {another, y},
                 {1e-12, "a hundred tolerances of the integration"}};
  };
  const std::string book_values = "L = 4, m = 1, K = 10, b = sqrt(2)";
  select.printed = {"L, c, m, K",
                    {same(book_values, end_of(half, 1, 10), "L = 4, m = 1, K = 10, b = 1/sqrt(2)",
                          end_of(half / 2, 1, 10))}};
  select.corrected = {
      "b, c and K/m",
      {same(book_values, end_of(half, 1, 10), "L = 8, m = 3, K = 30, b = sqrt(2)", end_of(half, 3, 30))}};
  select.near_misses = {
      {"b, c and K",
       {same(book_values, end_of(half, 1, 10), "L = 8, m = 3, K = 10, b = sqrt(2)", end_of(half, 3, 10))}}};
  select.why =
      "The start $b$ is missing, on which $\\lambda(0)=bL/a=\\sqrt2\\,b$ and $\\ell$ depend. From a quarter "
      "of the "
      "segment instead of its middle, with the same $L$, $c$, $m$ and $K$, $\\lambda(2)$ is 0.252 and not "
      "0.994. "
      "The length $L$ decides nothing else, and $m$ and $K$ only by $K/m$. The listing has $b$ as the "
      "initial "
      "`lambda`.";
  return {towards, arrives, on_the_segment(), numbers, select};
}

// ---- the claims: the listing and its output ---------------------------------------------------------------

struct Run {
  std::vector<double> lambda;
  double time;
};

/// The listing's 200 steps.
Run listing(double factor) {
  const AsListed<double> rod{book, factor};
  auto state = rod.start();
  Run run{{state[0]}, 0};
  for (int i = 0; i < 200; ++i) {
    listed_step(rod, state, run.time, 0.01);
    run.lambda.push_back(state[0]);
  }
  return run;
}

/// lambda and x2 = x3 as printed, against a route's lambda.
std::vector<Check> line(double lambda, double d, const std::string& by, double s) {
  return {{"lambda", {"as printed", lambda}, {by, s}, printed_decimals(5)},
          {"x2", {"as printed", d}, {by, root_half<double> * s}, printed_decimals(6)}};
}

/// The cosine of x next to pi/2 as FCOS gives it: the distance from its own pi/2, which has 66 bits.
double fcos_near_half_pi(double x) { return 0x234Cp-67 - (x - pi / 2); }

std::vector<Claim> listed(const Run& run, const Run& mended) {
  const double s = run.lambda.back();
  const std::string code = "the listing's arithmetic";

  Claim first{"3.15-first_line", 2177, "the output begins with lambda = 2, x1 = x3 = 1.41421, x2 = 0"};
  const auto middle = position(2.0, 0.0, quarter);
  const auto starts = [&](double x) {
    return Check{"lambda, x1, x2, x3",
                 {"as printed", {2, x, 0, x}},
                 {"the middle of the segment of length 4", {4 / 2, middle[0], middle[1], middle[2]}},
                 printed_decimals(5)};
  };
  first.printed = {"as printed", {starts(1.41421)}};
  first.near_misses = {{"last digit one up", {starts(1.41422)}}};

  Claim last{"3.15-listing_output", 2179, "the listing ends with lambda = 1.15214, x2 = x3 = 0.814683"};
  last.printed = {"as printed", line(1.15214, 0.814683, code, s)};
  last.near_misses = {{"last digit of lambda one up", line(1.15215, 0.814683, code, s)},
                      {"last digit of x2 one up", line(1.15214, 0.814684, code, s)},
                      {"the listing with aux[1]", line(1.15214, 0.814683, "mended", mended.lambda.back())}};

  Claim x1{"3.15-listing_x1", 2179, "the listing ends with x1 = -8.54596e-16"};
  const double angle = quarter * run.time;
  const auto digits = [&](const std::string& by, double cosine) {
    return Check{"x1",
                 {"as printed", -8.54596e-16},
                 {by, root_half<double> * s * cosine},
                 {0.5e-21, "half a unit of the sixth digit, the last one printed"}};
  };
  x1.printed = {"with FCOS", {digits("cosine with a pi of 66 bits", fcos_near_half_pi(angle))}};
  x1.near_misses = {{"with the true cosine", {digits("cosine", cos(angle))}},
                    {"with a clock that does not round", {digits("cosine at t = 2", cos(quarter * 2))}}};

  Claim plane{"3.15-in_the_plane", 2181, "x1 is effectively zero at the end"};
  const auto x1_after = [&](int steps) {
    return Check{"x1 after step " + std::to_string(steps),
                 {"listing", root_half<double> * s * cos(angle * steps / 200)},
                 {"zero", 0.0},
                 {200 * 0x1p-53 * 2, "the rounding of a clock that adds 200 steps"},
                 1};
  };
  Claim clock{"3.15-initial_time", 1995, "Initialize(time, ...) starts at the time that it is given"};
  const auto starts_at = [&](const std::string& by, double t) {
    const auto x = position(2.0, t, quarter);
    return Check{"position after Initialize(1, 0.01, 2, 0)",
                 {by, book.place(2, 1)},
                 {"at the time of the listing", {x[0], x[1], x[2]}},
                 rounding(2)};
  };
  clock.printed = {"mTime = 0.0", {starts_at("lambda = 2 at t = 1", 0)}};
  clock.corrected = {"mTime = time", {starts_at("lambda = 2 at t = 1", 1)}};
  clock.near_misses = {{"mTime = deltaTime", {starts_at("lambda = 2 at t = 1", 0.01)}}};
  clock.why =
      "The argument `time` is not used: the clock is set to `mTime = 0.0`. The main program passes 0, and "
      "its "
      "output is not touched. Whoever resumes a saved motion at $t=1$ finds the segment turned back by "
      "$45^\\circ$, and the mass 1.08 m from its place. (With `mTime = time` the rest length must be kept as "
      "well: "
      "`mAux[6]` takes the spring's length at that moment, 1.73 for 1.47.)";

  plane.printed = {"zero but for the clock's rounding", {x1_after(200)}};
  plane.near_misses = {{"so one step before", {x1_after(199)}}};
  return {first, last, x1, plane, clock};
}

std::vector<Claim> conclusions(const Run& run, const Run& mended, const Value& end) {
  const double lambda = length({end[0], end[1], end[2]}), d = end[1];

  Claim value{"3.15-lambda_value", 2179, "lambda(2) = 1.15214"};
  const auto is_lambda = [&](const std::string& as, double x) {
    return Check{"lambda(2)", {as, x}, {"table", lambda}, printed_decimals(5)};
  };
  value.printed = {"1.15214", {is_lambda("as printed", 1.15214)}};
  value.corrected = {"0.99421",
                     {is_lambda("corrected", 0.99421),
                      {"lambda(2) by the listing with aux[1]",
                       {"corrected", 0.99421},
                       {"200 steps of Runge-Kutta 4", mended.lambda.back()},
                       printed_decimals(5)}}};
  value.near_misses = {{"0.99422", {is_lambda("last digit one up", 0.99422)}}};
  value.why =
      "The output belongs to the slip of the listing, `aux[0]*time` for `aux[1]*time` (2079), not to the "
      "equation of the text, whose $\\lambda(2)$ is 0.994210: what is printed is 16 percent too large.";

  Claim arrival{"3.15-d_value", 2181, "d = 0.814683"};
  const auto is_d = [&](const std::string& as, double x, const Tolerance& tolerance) {
    return Check{"d, the mass arriving at (0, d, d)", {as, x}, {"table", d}, tolerance};
  };
  arrival.printed = {"0.814683", {is_d("as printed", 0.814683, printed_decimals(6))}};
  arrival.corrected = {"0.703013", {is_d("corrected", 0.703013, printed_decimals(6))}};
  arrival.near_misses = {{"0.703014", {is_d("last digit one up", 0.703014, printed_decimals(6))}}};
  arrival.why =
      "It comes from the slip of the listing (2079); the mass arrives at $(0,d,d)$ with $d=0.703013$, 0.16 m "
      "nearer "
      "to the origin along the segment.";

  Claim meaning{"3.15-d_is_lambda", 1849, "d is lambda(2)"};
  meaning.printed = {"d = lambda(2)", {is_d("|x(2)|", lambda, rounding(1))}};
  meaning.meant = {"d = lambda(2)/sqrt(2)", {is_d("|x(2)|/sqrt(2)", lambda / sqrt2, rounding(1))}};
  meaning.near_misses = {{"d = lambda(2)/2", {is_d("|x(2)|/2", lambda / 2, rounding(1))}}};
  meaning.why =
      "$\\lambda$ is a distance along the segment and $d$ a coordinate: $d=\\lambda(2)/\\sqrt2$, as in the "
      "output's own 1.15214 and 0.814683. Taken at its word it places the mass 0.41 m too far along the "
      "segment. The "
      "line is repeated in the summary (1869).";

  Claim down{"3.15-slipped", 2181, "lambda has decreased"};
  down.printed = {"lambda(2) < lambda(0)",
                  {never("lambda(2) < 2 by the listing, by the mended one, by the table",
                         !(run.lambda.back() < 2) + !(mended.lambda.back() < 2) + !(lambda < 2), 3)}};
  long rises = 0;
  for (std::size_t i = 1; i < mended.lambda.size(); ++i) rises += !(mended.lambda[i] < mended.lambda[i - 1]);
  down.near_misses = {{"lambda decreases all the time", {never("lambda decreases in a step", rises, 200)}}};
  return {value, arrival, meaning, down};
}

Given<double> asked(const Parameters& p) { return {p["m"], p["c"], p["K"], p["w"], p["s"]}; }

Quantity sliding(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return slide(asked(p), horizon, truth);
}

/// The horizon is a quarter turn at the book's speed. From w = sqrt(2K/m) = 4.47 on the mass runs away.
Scene scene() {
  return {
      sliding,
      2,
      centimeter,
      "w",
      {0.25, 0.75, 1.5, 3, 4.25},
      {"s", "c"},
      {{"x1", "x2", "x3"}, "s", {{"m", {0, 1, 2}}}},
      {{"chapters/03_rigid_body_motion/15_turning_rod/models.hpp"},
       {{"no spring", "turning_rod::NoSpring<double>{{{m, c, K, w, s}}}"},
        {"spring's end on the axis", "turning_rod::EndOnTheAxis<double>{{{m, c, K, w, s}}}"},
        {"rigid spring", "turning_rod::RigidSpring<double>{{{m, c, K, w, s}}}"},
        {"listing as printed", "turning_rod::AsListed<double>{{{m, c, K, w, s}}}"},
        {"listing with the other rest length",
         "turning_rod::listed_with_other_rest_length<double>({m, c, K, w, s})"},
        {"along the rod", "turning_rod::AlongTheRod<double>{{{m, c, K, w, s}}}"},
        {"along the rod, with the work", "turning_rod::AlongTheRodWithWork<double>{{{m, c, K, w, s}}}"},
        {"in the turning plane", "turning_rod::InTheTurningPlane<double>{{{m, c, K, w, s}}}"},
        {"Cartesian with constraints", "turning_rod::CartesianWithConstraints<double>{{{m, c, K, w, s}}}"}}}};
}

Findings study(const Parameters& given, const Reference& truth) {
  const Horizon horizon{scene().horizon};
  const Given<double> rod = asked(given);
  const Given<double> stiff{rod.m, rod.c, given["stiff"], rod.w, rod.s0};
  const Given<double> fast{rod.m, rod.c, rod.K, given["r"] * sqrt(2 * rod.K / rod.m), rod.s0};
  const double seed = given["seed"];
  const Run run = listing(root_half<double>), mended = listing(quarter);
  auto at_2 = inputs(book);
  at_2.push_back(2);
  const Value end = truth("03_15_slide", at_2).value;
  std::vector<Claim> claims;
  for (const auto& more : {geometry(seed), dynamics(seed), slips(seed), motion(seed, end),
                           listed(run, mended), conclusions(run, mended, end)})
    claims.insert(claims.end(), more.begin(), more.end());
  std::ranges::stable_sort(claims, {}, &Claim::line);
  return {claims, {motion(scene(), given, truth), stiff_spring(stiff, horizon, truth), runaway(fast)}};
}

}  // namespace ex03_15

Exercise exercise_3_15() {
  using namespace ex03_15;
  return {"Mass with a spring on a turning rod",
          "A mass slides without friction on a segment from the origin to $(a,0,a)$ that turns about the "
          "$x_3$-axis at $\\pi/4$ a second; a spring joins it to $(c,0,0)$. Where does it arrive in the "
          "$(x_2,x_3)$-plane?",
          parameters, scene(), study};
}

}  // namespace oddity
