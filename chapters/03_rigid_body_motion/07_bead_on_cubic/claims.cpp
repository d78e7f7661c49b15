// The claims of exercise 3.7. The equations are compared with Lagrange's, whose Lagrangian is differentiated
// by dual numbers from the curve alone, and with the wire's forces in Cartesian coordinates. Statements about
// the motion are compared with the book's own run.

#include "chapters/provable_claims.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/03_rigid_body_motion/07_bead_on_cubic/bead_on_cubic.hpp"
#include "chapters/03_rigid_body_motion/shared/book_runge_kutta_4.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"

namespace oddity::ex03_07 {

using namespace bead_on_cubic;
using std::abs, std::pow, std::sqrt;

// ---- the Lagrangian ---------------------------------------------------------------------------------------

/// The bead's velocity for q' = v.
template <class T>
std::array<T, 3> velocity(const T& q, const std::type_identity_t<T>& v) {
  const auto x = curve(Dual<T>(q, v));
  return {x[0].slope, x[1].slope, x[2].slope};
}

template <class M>
struct KineticEnergy {
  M m;
  template <class T>
  T operator()(const T& q, const T& v, const T&) const {
    const auto u = velocity(q, v);
    return 0.5 * m * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  }
};

template <class M>
struct Lagrangian {
  M m, g;
  template <class T>
  T operator()(const T& q, const T& v, const T& t) const {
    return KineticEnergy<M>{m}(q, v, t) - m * g * curve(q)[2];
  }
};

/// A bead at any point of the curve, and any q''.
template <class T>
struct SampleOf {
  T m, g, q, v, a;
  SampleOf() = default;
  explicit SampleOf(Random& random)
      : m(abs(random.magnitude(0.1, 10))),
        g(abs(random.magnitude(0.1, 10))),
        q(random.magnitude(0.01, 2)),
        v(random.magnitude(0.01, 3)),
        a(random.magnitude(0.01, 3)) {}
  std::array<T*, 5> letters() { return {&m, &g, &q, &v, &a}; }
  TypesetIn<T> typeset() const {
    return {{"m", m}, {"g", g}, {"q", q}, {R"(\dot q)", v}, {R"(\ddot q)", a}, {R"(\dot x)", velocity(q, v)}};
  }
  std::string where() const { return listed(typeset(), 5); }
  KineticEnergy<T> kinetic() const { return {m}; }
  Lagrangian<T> lagrangian() const { return {m, g}; }
  T bend() const { return 2 * q + 9 * q * q * q; }
  /// x'' by Lagrange's equation.
  std::array<T, 3> acceleration() const {
    const Dual<T> along(q, v), speed(v, lagrange_acceleration(lagrangian(), q, v));
    const auto u = velocity(along, speed);
    return {u[0].slope, u[1].slope, u[2].slope};
  }
  /// The power of the force on the bead, with `of` applied to each of its terms.
  template <class Of>
  T power(const Of& of) const {
    const auto x = acceleration(), u = velocity(q, v);
    return m * (of(u[0] * x[0]) + of(u[1] * x[1]) + of(u[2] * x[2]));
  }
  T work() const {
    return power([](const T& x) { return x; });
  }
  T work_of_gravity() const { return -m * g * velocity(q, v)[2]; }
  T by_lagrange() const { return lagrange_acceleration(lagrangian(), q, v); }
  /// q'' by the exercise's equation.
  T published() const {
    std::array<T, 2> rate;
    OneCoordinate<T>{{q, g}}(std::array{q, v}, rate, T(0));
    return rate[1];
  }
  /// x'' = q'' from gravity and the wire's two forces.
  T by_forces() const {
    const auto x = curve(q), u = velocity(q, v);
    const std::array state{x[0], x[1], x[2], u[0], u[1], u[2]};
    auto rate = state;
    CartesianWithConstraints<T>{{q, g}}(state, rate, T(0));
    return rate[3];
  }
};
using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;

void energies(Table& table, const std::vector<Sample>& samples) {
  const ProvableFormula<SampleOf> energy{R"($\frac m2|\dot x|^2$, $\dot x$ by dual numbers)",
                                         [](const auto& s) { return s.kinetic()(s.q, s.v, s.v); }};

  table.formula("tangent", 1375, "The $q$-derivative is $dx/dq=(1,2q,3q^2)$.", samples,
                {.truth = {"the curve by dual numbers", [](const auto& s) { return velocity(s.q, 1); }},
                 .printed = {"$(1,2q,3q^2)$"}});
  table.formula("velocity", 1375, R"(The $t$-derivative is $\dot x=(dx/dq)\,\dot q$.)", samples,
                {.truth = {"the curve by dual numbers", [](const auto& s) { return velocity(s.q, s.v); }},
                 .printed = {R"($\dot q\,(1,2q,3q^2)$)"}});
  table.formula(
      "kinetic_energy_by_speed", 1379, R"(The kinetic energy is $T=\frac m2|\dot x|$.)", samples,
      {.truth = energy,
       .printed = {R"($\frac m2|\dot x|$)"},
       .meant = {R"($\frac m2|\dot x|^2$)"},
       .kind = Fault::formula,
       .why = filled(
           R"(The speed's exponent is missing; the next form of the line, with $\dot q^2$, comes from the )"
           R"(square. A bead twice as fast has @1 times the energy, and by the printed form @1 times.)",
           {pow(2, 2), pow(2, 1)})});
  table.formula("kinetic_energy", 1381, R"($T=\frac m2(1+4q^2+9q^4)\dot q^2$)", samples,
                {.truth = energy,
                 .printed = {R"($\frac m2(1+4q^2+9q^4)\dot q^2$)"},
                 .near_misses = {{R"($\frac m2(1+4q^2+9q^2)\dot q^2$)"}}});
  table.formula("dT_dq", 1385, R"($\partial T/\partial q=2m(2q+9q^3)\dot q^2$)", samples,
                {.truth = {"$T$ by dual numbers", [](const auto& s) { return df_dq(s.kinetic(), s.q, s.v); }},
                 .printed = {R"($2m(2q+9q^3)\dot q^2$)"}});
  table.formula("dT_dqdot", 1387, R"($\partial T/\partial\dot q=m(1+4q^2+9q^4)\dot q$)", samples,
                {.truth = {"$T$ by dual numbers", [](const auto& s) { return df_dv(s.kinetic(), s.q, s.v); }},
                 .printed = {R"($m(1+4q^2+9q^4)\dot q$)"}});
  table.formula("momentum_rate", 1393,
                R"($\frac d{dt}\,\partial T/\partial\dot q=m(1+4q^2+9q^4)\ddot q+4m(2q+9q^3)\dot q^2$)",
                samples,
                {.truth = {"$T$ by nested dual numbers",
                           [](const auto& s) { return rate_of_df_dv(s.kinetic(), s.q, s.v, s.a); }},
                 .printed = {R"($m(1+4q^2+9q^4)\ddot q+4m(2q+9q^3)\dot q^2$)"}});
  table.formula("force", 1395, R"(The generalized force is $F_q=-mg(0,0,1)\cdot(1,2q,3q^2)=-3mgq^2$.)",
                samples,
                {.truth = {R"($\partial L/\partial q$ at rest by dual numbers)",
                           [](const auto& s) { return df_dq(s.lagrangian(), s.q, 0); }},
                 .printed = {"$-3mgq^2$"}});
  table.formula(
      "lagrange_equation", 1407, R"($m(1+4q^2+9q^4)\ddot q+4m(2q+9q^3)\dot q^2-2m(2q+9q^3)\dot q^2=-3mgq^2$)",
      samples,
      {.truth = {R"($\frac d{dt}\,\partial L/\partial\dot q-\partial L/\partial q$ by nested dual numbers)",
                 [](const auto& s) {
                   return rate_of_df_dv(s.lagrangian(), s.q, s.v, s.a) - df_dq(s.lagrangian(), s.q, s.v);
                 }},
       .printed = {R"($m(1+4q^2+9q^4)\ddot q+(4m-2m)(2q+9q^3)\dot q^2+3mgq^2$)"}});
}

void accelerations(Claims& claims, const std::vector<Sample>& samples) {
  const Formula<Sample> solved{R"($-(3gq^2+2q(2+9q^2)\dot q^2)/(1+4q^2+9q^4)$)", &Sample::published},
      lagrange{R"(Lagrange's equation by nested dual numbers, at any mass)", &Sample::by_lagrange},
      forces{"gravity and the wire's two forces in Cartesian coordinates", &Sample::by_forces};
  const auto solved_by = [&](const std::string& text) -> Reading {
    const Formula<Sample> formula = computed(Formula<Sample>{text});
    return {text,
            {compare(R"($\ddot q$)", formula, lagrange, samples)},
            is_as_typeset(compare_typeset(formula, samples))};
  };
  claims.add(
      "equation_of_motion", 1411,
      R"($\ddot q=-\frac{3gq^2+2q(2+9q^2)\dot q^2}{1+4q^2+9q^4}$ (the minus sign is read as that of the whole fraction))",
      {.printed = {solved.text,
                   {compare(R"($\ddot q$)", solved, lagrange, samples),
                    compare(R"($\ddot q=\ddot x_1$)", solved, forces, samples)},
                   is_as_typeset(compare_typeset(solved, samples))},
       .near_misses = {solved_by(R"($(-3gq^2+2q(2+9q^2)\dot q^2)/(1+4q^2+9q^4)$)"),
                       solved_by(R"($-(3gq^2+q(2+9q^2)\dot q^2)/(1+4q^2+9q^4)$)")}});

  const Formula<Sample> falls{R"($\ddot x=(0,0,-g)$)", [](const Sample& s) { return values(0, 0, -s.g); }};
  const Formula<Sample> work{R"($m\ddot x\cdot\dot x$ by Lagrange's equation)", &Sample::work,
                             [](const Sample& s) { return s.power([](double x) { return abs(x); }); }};
  const auto power = [&](std::string text, double factor) -> Reading {
    const Formula<Sample> formula{std::move(text),
                                  [=](const Sample& s) { return factor * s.work_of_gravity(); }};
    return {formula.text, {compare("power of the force on the bead", formula, work, samples)}};
  };
  claims.add(
      "only_gravity", 1415,
      "Only gravity acts on the bead (our reading: of all that does work; the wire pushes as well, at right "
      "angles to its curve).",
      {.printed = power(R"(gravity alone does work: $m\ddot x\cdot\dot x=-mg\dot x_3$)", 1),
       .near_misses = {power(R"(the wire does as much: $m\ddot x\cdot\dot x=-2mg\dot x_3$)", 2),
                       {falls.text,
                        {compare<Sample>("the bead's acceleration", falls,
                                         {"Lagrange's equation", &Sample::acceleration}, samples)},
                        is_as_typeset(compare_typeset(falls, samples))}}});
}

// ---- the book's run ---------------------------------------------------------------------------------------

using State = OneCoordinate<double>::State;
constexpr double book_step = 0.001;
constexpr int book_steps = 2500;

/// The states (q, q') of the book's run.
std::vector<State> book_run() {
  const OneCoordinate<double> bead{{1, 1}};
  std::vector<State> run{bead.start()};
  double t = 0;
  for (int i = 0; i < book_steps; ++i) {
    auto state = run.back();
    listed_step(bead, state, t, book_step);
    run.push_back(state);
  }
  return run;
}

/// A step of the book's run.
struct Step {
  int number;
  State from, to;
  TypesetLetters typeset() const;
  std::string where() const {
    return "step " + std::to_string(number) + ", to $q$ = " + format_significant(to[0], 6);
  }
};

/// q'' of the book's bead.
double force(const State& x) { return lagrange_acceleration(Lagrangian<double>{1, 1}, x[0], x[1]); }
TypesetLetters Step::typeset() const { return {{"q", from[0]}, {R"(\ddot q)", force(from)}}; }

/// The book's bead at a whole second.
struct Second {
  std::size_t number;
  State at;
  std::string where() const { return "$t$ = " + std::to_string(number); }
};

constexpr int last_second = 1000;

/// The seconds from `first` to the last one.
std::vector<Second> seconds(std::size_t first) {
  const OneCoordinate<double> bead{{1, 1}};
  const auto run = ode::integrate<ode::DormandPrince54>(bead, bead.start(),
                                                        Horizon{last_second, last_second}.times(), 1e-10)
                       .value;
  std::vector<Second> all;
  for (std::size_t i = first; i < run.size(); ++i) all.push_back({i, run[i]});
  return all;
}

void run_down(Claims& claims, const std::vector<State>& run) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i + 1 < run.size(); ++i)
    steps.push_back({static_cast<int>(i) + 1, run[i], run[i + 1]});
  const auto everywhere = [&](const std::string& text, const std::function<bool(const Step&)>& holds) {
    return in_all(text, steps, holds);
  };

  const auto start_at = [](std::string text, double q) -> Reading {
    const auto x = curve(q), v = velocity(q, 0.0);
    return {std::move(text),
            {{"position and velocity",
              {"at rest at (1, 1, 1)", {1, 1, 1, 0, 0, 0}},
              {"the curve and its tangent", {x[0], x[1], x[2], v[0], v[1], v[2]}},
              exact()}}};
  };
  claims.add("start", 1375,
             R"(The initial position is $(1,1,1)$, the initial velocity $(0,0,0)$: $q(0)=1$, $\dot q(0)=0$.)",
             {.printed = start_at(R"($q=1$, $\dot q=0$)", 1),
              .near_misses = {start_at(R"($q=-1$, $\dot q=0$)", -1)}});

  const auto positive_after = std::ranges::count_if(steps, [](const Step& s) { return force(s.to) > 0; });
  const Statement<Step> negative{R"($\ddot q<0$)", [](const Step& s) { return force(s.from) < 0; }};
  claims.add(
      "rhs_negative", 1415, R"(The right-hand side, $\ddot q$, is always negative.)",
      {.printed = {negative.text,
                   {everywhere(negative.text, negative.holds)},
                   is_as_typeset(compare_typeset(negative, steps))},
       .corrected = {R"($\ddot q<0$ as long as $q>0$, $\ddot q=0$ at $q=0$, $\ddot q>0$ after it)",
                     {everywhere(R"($q\ddot q<0$)",
                                 [](const Step& s) { return s.from[0] * force(s.from) < 0; }),
                      {R"($\ddot q$ at $q=0$)",
                       {"Lagrange's equation", force({0, -1})},
                       {"zero", 0.0},
                       rounding(1),
                       1}}},
       .near_misses = {{R"($\ddot q<0$ as long as $q>-0.01$, and no longer)",
                        {everywhere(
                            R"($\ddot q<0$ exactly where $q>-0.01$)",
                            [](const Step& s) { return (force(s.from) < 0) == (s.from[0] > -0.01); })}}},
       .why = filled(
           R"(The second term has the sign of $-q$, and at $q=0$ the first is zero as well. There $\ddot )"
           R"(q=0$, and beyond it $\ddot q$ is positive, in the book's own run after each of the last )"
           "@4 of its @4 steps. (The samples are the beginnings of its steps, and the first of these ends "
           "beyond the origin.)",
           {static_cast<double>(positive_after), book_steps}),
       .kind = Fault::counterexample,
       .root = "beyond the origin"});

  const auto at_origin = event_of<ode::Fehlberg78>(OneCoordinate<double>{{1, 1}}, 1e-12).value.after;
  const auto turns_at = [&](double q) {
    return everywhere(R"($\dot q$ decreases, then increases)", [q](const Step& s) {
      return s.from[0] > q && s.to[0] < q ? true : (s.to[1] < s.from[1]) == (s.from[0] > q);
    });
  };
  claims.add(
      "velocity_decreases", 1415, R"($\dot q$ is a decreasing function of time.)",
      {.printed = {R"($\dot q$ decreases)",
                   {everywhere(R"($\dot q$ decreases)", [](const Step& s) { return s.to[1] < s.from[1]; })}},
       .corrected =
           {R"($\dot q$ decreases until $q=0$, where it is $-\sqrt{2g}$, and increases from then on)",
            {turns_at(0),
             {R"($\dot q$ at $q=0$)",
              {"Fehlberg 7(8) and its event", at_origin[1]},
              {R"($-\sqrt{2gq_0^3}$, the energy)", -sqrt(2.0)},
              {1e-10, "a hundred tolerances of the integration"}}}},
       .near_misses = {{R"($\dot q$ decreases until $q=-0.01$, and increases from then on)",
                        {turns_at(-0.01)}}},
       .why = filled(
           R"($\dot q$ is least at the origin, $-\sqrt{2g}$, and rises towards zero afterwards. The two rows )"
           R"(printed show it, computed again: $\dot q=@9$ at $t=@4$ and $@9$ at $t=@4$.)",
           {run[2240][1], 2240 * book_step, run[2241][1], 2241 * book_step}),
       .kind = Fault::counterexample,
       .root = "beyond the origin"});

  const auto moves = [](std::size_t first) {
    return in_all<Second>(filled(R"($\dot q<0$ at whole seconds up to @4)", {last_second}), seconds(first),
                          [](const Second& s) { return s.at[1] < 0; });
  };
  claims.add(
      "velocity_negative", 1415,
      filled(R"($\dot q(t)<0$ for all times $t>0$ (our check: at whole seconds up to @4).)", {last_second}),
      {.printed = {R"($\dot q<0$ for $t>0$)",
                   {moves(1), everywhere(R"($\dot q<0$ at the end of each step)",
                                         [](const Step& s) { return s.to[1] < 0; })}},
       .near_misses = {{R"($\dot q<0$ for $t\ge0$)", {moves(0)}},
                       {R"($\ddot q<0$ for $t>0$)",
                        {everywhere(R"($\ddot q<0$ at the end of each step)",
                                    [](const Step& s) { return force(s.to) < 0; })}}}});

  const auto falls = [&](const std::string& text, std::size_t i) {
    return everywhere(text, [i](const Step& s) { return curve(s.to[0])[i] < curve(s.from[0])[i]; });
  };
  claims.add(
      "slides_down", 1415, "$q$ is a decreasing function of time: the bead slides down the curve.",
      {.printed = {"$q$ and $x_3$ decrease", {falls("$q=x_1$ decreases", 0), falls("$x_3$ decreases", 2)}},
       .near_misses = {{"$x_2$ decreases", {falls("$x_2$ decreases", 1)}}}});
}

// ---- the arrival ------------------------------------------------------------------------------------------

/// A row of the book's output: q, q' and x1; x2 and x3 are 0.0000.
struct Row {
  int step;
  std::string q, v, x;
};

void arrivals(Claims& claims, const std::vector<State>& run, const Reference& truth) {
  const Known T = truth("03_07_arrival", {1, 1});
  const auto event = event_of<ode::Fehlberg78>(CartesianWithConstraints<double>{{1, 1}}, 1e-12).value;
  const Tolerance integrated{1e-10, "a hundred tolerances of the integration"};

  const auto ratio = [&](std::string text, double r) -> Reading {
    return {std::move(text),
            {{"the time at $4g$ over that at $g$",
              {"as stated", r},
              {"table", truth("03_07_arrival", {1, 4}).value[0] / T.value[0]},
              rounding(1)}}};
  };
  claims.add(
      "needs_g", 1417, "To find the time to the origin one has to select $g$.",
      {.printed = ratio(R"(it is $1/\sqrt g$ times a number)", 0.5),
       .near_misses = {ratio("it does not depend on $g$", 1), ratio("it is $1/g$ times a number", 0.25)}});

  const auto from_origin = [&](std::string text, const Route& position) -> Reading {
    return {std::move(text), {{"position", position, {"the origin", {0, 0, 0}}, integrated, 1}}};
  };
  claims.add(
      "at_the_origin", 1417, "At the time with $q(T)=0$ the position is $x(T)=(0,0,0)$.",
      {.printed = from_origin("at the event $q=0$",
                              {"Cartesian, at its event", {event.after[0], event.after[1], event.after[2]}}),
       .near_misses = {
           from_origin("at $t=2.24$", {"table at 2.24", truth("03_07_slide", {1, 1, 2.24}).value})}});

  const auto time = [&](std::string text, double t) -> Reading {
    return {text, {{"time to the origin", {text, t}, {"table, by energy quadrature", T.value}, integrated}}};
  };
  const auto &above = run[2240], &below = run[2241];
  claims.add("by_numbers", 1417, "A numerical method gives the time $T$.",
             {.printed = time("Cartesian integration to its event", event.time),
              .near_misses = {time("the book's run, its last row above zero", 2240 * book_step),
                              time("the book's run, half of the way to the zero between its rows",
                                   book_step * (2240 + 0.5 * above[0] / (above[0] - below[0])))}});

  const auto row_reading = [&](const Row& row) -> Reading {
    const double q = run[static_cast<std::size_t>(row.step)][0],
                 v = run[static_cast<std::size_t>(row.step)][1];
    return {"$q=" + row.q + R"($, $\dot q=)" + row.v + "$, position $(" + row.x + ",0,0)$",
            {as_written("$q$", row.q, {"the book's run", q}),
             as_written(R"($\dot q$)", row.v, {"the book's run", v}),
             {"position",
              {"as printed", {std::stod(row.x), 0, 0}},
              {"the book's run", curve(q)},
              printed_decimals(4)},
             as_written("$q$", row.q, {"table", truth("03_07_slide", {1, 1, row.step / 1000.0}).value[0]})}};
  };
  const auto row = [&](std::string_view slug, int line, const Row& printed, const std::string& q_up,
                       const std::string& v_up) {
    Row other_q = printed, other_v = printed;
    other_q.q = q_up;
    other_v.v = v_up;
    claims.add(
        slug, line,
        "At $t=" + format_shortest(printed.step / 1000.0) + "$ the output has " + row_reading(printed).text +
            ".",
        {.printed = row_reading(printed), .near_misses = {row_reading(other_q), row_reading(other_v)}});
  };
  row("row_2240", 1421, {2240, "0.00017622", "-1.41421347", "0.0002"}, "0.00017623", "-1.41421346");
  row("row_2241", 1423, {2241, "-0.00123799", "-1.41420923", "-0.0012"}, "-0.00123798", "-1.41420922");

  const auto within = [&](std::string text, double middle) -> Reading {
    return {std::move(text),
            {{"time to the origin",
              {"middle of the interval", middle},
              {"table", T.value},
              {0.0005, "half the interval"}}}};
  };
  claims.add(
      "between", 1425, "$q$ reaches zero somewhere between 2.24 and 2.241.",
      {.printed = within("between 2.24 and 2.241", 2.2405),
       .near_misses = {within("between 2.241 and 2.242", 2.2415), within("between 2.239 and 2.24", 2.2395)}});

  const auto about_zero = [&](std::size_t step) {
    return Check{"position after step " + std::to_string(step),
                 {"the book's run", curve(run[step][0])},
                 {"the origin", {0, 0, 0}},
                 {sqrt(2.0) * book_step, "the way of one step"},
                 1};
  };
  claims.add(
      "near_the_origin", 1425, "In both rows the position is approximately the zero vector.",
      {.printed = {"closer to the origin than the way of one step", {about_zero(2240), about_zero(2241)}},
       .near_misses = {{"so one step later", {about_zero(2242)}}}});
}

std::vector<Claim> claims(double seed, const Reference& truth) {
  Claims all("3.7");
  const auto run = book_run();
  const auto samples = draw<Sample>(200, seed);
  Table table(all);
  energies(table, samples);
  accelerations(all, samples);
  run_down(all, run);
  arrivals(all, run, truth);
  all.add("no_closed_form", 1417, "It is not possible to obtain a closed form of $q(t)$.",
          {.not_checkable = "numbers do not show that there is no formula"});
  all.add("only_hope", 1417, "A numerical method is the only hope of estimating $T$.",
          {.not_checkable = "numbers do not show that there is no other way (the energy gives the time as an "
                            "integral, which the table takes by quadrature: a numerical method as well)"});
  all.add("bead_slide", 1417, "The program `BeadSlide` is an implementation of this.",
          {.not_checkable =
               "the program is on the book's CD-ROM; the text's statements on its run are separate claims"});
  return all.in_order();
}

/// Divisors are 1 + 4 q^2 + 9 q^4, or m times it.
constexpr const char* by_positive_metric = R"(
  assert (0 <= q * q) by (apply Rle_0_sqr); assert (0 <= q * q * (q * q)) by (apply Rle_0_sqr);
  field; repeat split; lra)";

Provables proofs() {
  Claims claims("3.7");
  Table table(claims);
  energies(table, {});
  const std::vector<std::string> names{"m", "g", "q", "v", "a"};
  ForAll<SampleOf> all{.any = lettered<SampleOf>(names),
                       .letters = quantified(names),
                       .tactic = "try rewrite pow2_sqrt by nra; field",
                       .says = "it holds for every bead in any motion on the curve"};
  double x = 0;
  for (double* letter : all.example.letters()) *letter = x += 0.5;
  Provables proved = table.proofs("3.7", all);
  const auto& s = all.any;
  const std::vector<Proposition> heavy{above(s.m.expression(), 0)};
  proved.push_back(
      {"3.7-equation_of_motion",
       "it is Lagrange's equation, and that of gravity and the wire's force, in any motion on the curve",
       {{"lagrange",
         all.letters,
         heavy,
         {s.published().expression() == s.by_lagrange().expression()},
         by_positive_metric},
        {"forces",
         all.letters,
         heavy,
         {s.published().expression() == s.by_forces().expression()},
         by_positive_metric}}});
  SampleOf<Shortened> still;
  still.m = still.g = still.q = 1.0;
  proved.push_back(
      {"3.7-only_gravity",
       "gravity's power is that of the whole force, in any motion on the curve; without the wire the bead would "
       "set off otherwise",
       {{"printed",
         all.letters,
         heavy,
         {s.work_of_gravity().expression() == s.work().expression()},
         by_positive_metric},
        {"the_wire_pushes", "", {}, {apart(0, still.acceleration()[0].expression(), 0.2)}, "interval"}},
       0.2});
  const auto place = curve(s.q), u = velocity(s.q, s.v);
  const auto is = [](const std::array<Shortened, 3>& a, const char* b) {
    std::string all_three;
    for (const Shortened& component : a)
      all_three += (all_three.empty() ? "" : " /\\ ") + component.expression().coq() + " = " + b;
    return all_three;
  };
  proved.push_back({"3.7-start",
                    "q = 1 and q' = 0 is being at rest at (1, 1, 1), and nothing else is",
                    {{"printed",
                      "(q v : R)",
                      {},
                      {{"(" + is(place, "1") + " /\\ " + is(u, "0") + ") <-> (q = 1 /\\ v = 0)"}},
                      "intuition (subst; lra)"}}});
  proved.push_back(
      {"3.7-at_the_origin",
       "q = 0 is being at the origin, and nothing else is",
       {{"printed", "(q : R)", {}, {{"(" + is(place, "0") + ") <-> q = 0"}}, "intuition (subst; lra)"}}});
  return proved;
}

std::vector<Root> roots() {
  const auto event = event_of<ode::Fehlberg78>(OneCoordinate<double>{{1, 1}}, 1e-12).value;
  const double end = book_steps * book_step;
  return {
      {"beyond the origin",
       filled(
           R"(An animation that takes $\ddot q$ for negative lets $|\dot q|$ grow beyond the origin. It )"
           R"(stays above the @4 that it has there; the true bead's is down to @4 at $t=@2$ s, @2 s later.)",
           {abs(event.after[1]), abs(book_run().back()[1]), end, end - event.time})}};
}

}  // namespace oddity::ex03_07

namespace oddity {

Provables proofs_3_7() { return ex03_07::proofs(); }

}  // namespace oddity
