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

/// A bead at any point of the curve, and any q''.
template <class T>
struct SampleOf {
  T m, g, q, v, a;
  Letters<T> table() {
    return {{"m", m, positive_size(0.1, 10)},
            {"g", g, positive_size(0.1, 10)},
            {"q", q, either_sign(0.01, 2)},
            {R"(\dot q)", v, either_sign(0.01, 3), "v"},
            {R"(\ddot q)", a, either_sign(0.01, 3), "a"}};
  }
  TypesetIn<T> typeset() const {
    const auto u = velocity(q, v);
    return {{R"(\dot x)", u}, {R"(\dot x_3)", u[2]}, {R"(\ddot x)", acceleration()}};
  }
  std::string where() const { return listed(typeset_of(*this), 5); }
  auto kinetic() const {
    return [m = m]<class X>(const X& along, const X& speed, const X&) {
      const auto u = velocity(along, speed);
      return X(0.5 * m * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
    };
  }
  auto lagrangian() const {
    return [*this](const auto& along, const auto& speed, const auto& t) {
      return kinetic()(along, speed, t) - m * g * curve(along)[2];
    };
  }
  /// x'' by Lagrange's equation.
  std::array<T, 3> acceleration() const {
    const auto u = velocity(Dual<T>(q, v), Dual<T>(v, by_lagrange()));
    return {u[0].slope, u[1].slope, u[2].slope};
  }
  T by_lagrange() const { return lagrange_acceleration(lagrangian(), q, v); }
  /// q'' by the model.
  T by_model() const {
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
  const auto claim = table.over(samples);
  claim("tangent", 1375, "The $q$-derivative is $dx/dq=(1,2q,3q^2)$.",
        {"the curve by dual numbers", [](const auto& s) { return velocity(s.q, 1); }}, "$(1,2q,3q^2)$");
  claim("velocity", 1375, R"(The $t$-derivative is $\dot x=(dx/dq)\,\dot q$.)",
        {"the curve by dual numbers", [](const auto& s) { return velocity(s.q, s.v); }},
        R"($\dot q\,(1,2q,3q^2)$)");
  claim(
      "kinetic_energy_by_speed", 1379, R"(The kinetic energy is $T=\frac m2|\dot x|$.)",
      {.truth = energy,
       .printed = R"($\frac m2|\dot x|$)",
       .meant = R"($\frac m2|\dot x|^2$)",
       .kind = Fault::formula,
       .why = filled(
           R"(The speed's exponent is missing; the next form of the line has $\dot q^2$. A bead twice as fast )"
           "has @1 times the energy, and by the printed form @1 times.",
           {pow(2, 2), pow(2, 1)})});
  claim.equation("kinetic_energy", 1381, R"($T=\frac m2(1+4q^2+9q^4)\dot q^2$)", energy);
  claim.equation("dT_dq", 1385, R"($\partial T/\partial q=2m(2q+9q^3)\dot q^2$)",
                 {"$T$ by dual numbers", [](const auto& s) { return df_dq(s.kinetic(), s.q, s.v); }});
  claim.equation("dT_dqdot", 1387, R"($\partial T/\partial\dot q=m(1+4q^2+9q^4)\dot q$)",
                 {"$T$ by dual numbers", [](const auto& s) { return df_dv(s.kinetic(), s.q, s.v); }});
  claim.equation("momentum_rate", 1393,
                 R"($\frac d{dt}\,\partial T/\partial\dot q=m(1+4q^2+9q^4)\ddot q+4m(2q+9q^3)\dot q^2$)",
                 {"$T$ by nested dual numbers",
                  [](const auto& s) { return rate_of_df_dv(s.kinetic(), s.q, s.v, s.a); }});
  claim("force", 1395, R"(The generalized force is $F_q=-mg(0,0,1)\cdot(1,2q,3q^2)=-3mgq^2$.)",
        {R"($\partial L/\partial q$ at rest by dual numbers)",
         [](const auto& s) { return df_dq(s.lagrangian(), s.q, 0); }},
        "$-3mgq^2$");
  claim("lagrange_equation", 1407,
        R"($m(1+4q^2+9q^4)\ddot q+4m(2q+9q^3)\dot q^2-2m(2q+9q^3)\dot q^2=-3mgq^2$)",
        {R"($\frac d{dt}\,\partial L/\partial\dot q-\partial L/\partial q$ by nested dual numbers)",
         [](const auto& s) {
           return rate_of_df_dv(s.lagrangian(), s.q, s.v, s.a) - df_dq(s.lagrangian(), s.q, s.v);
         }},
        R"($m(1+4q^2+9q^4)\ddot q+(4m-2m)(2q+9q^3)\dot q^2+3mgq^2$)");
}

const std::string solved = R"($-(3gq^2+2q(2+9q^2)\dot q^2)/(1+4q^2+9q^4)$)",
                  power = R"($m\ddot x\cdot\dot x=-mg\dot x_3$)";

void accelerations(Claims& claims, const std::vector<Sample>& samples) {
  const auto claim = claims.over(samples);
  claim(
      "equation_of_motion", 1411,
      R"($\ddot q=-\frac{3gq^2+2q(2+9q^2)\dot q^2}{1+4q^2+9q^4}$ (the minus sign is read as that of the whole fraction))",
      {.quantity = R"($\ddot q$)",
       .truth = {R"(Lagrange's equation by nested dual numbers, at any mass)", &Sample::by_lagrange},
       .other_routes = {{R"($\ddot x_1$ by gravity and the wire's two forces in Cartesian coordinates)",
                         &Sample::by_forces},
                        {"the model that is run", &Sample::by_model}},
       .printed = {solved}});
  claim(
      "only_gravity", 1415,
      "Only gravity acts on the bead (our reading: of all that does work; the wire pushes as well, at right "
      "angles to its curve).",
      {"$0$"}, {power},
      R"(the power of the force on the bead less that of gravity, $\ddot x$ by Lagrange's equation)");
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

/// q'' of the book's bead.
double force(const State& x) { return Sample{1, 1, x[0], x[1], 0}.by_lagrange(); }

/// A step of the book's run. The changes in a step are from its beginning to its end.
struct Step {
  State from, to;
  TypesetLetters typeset() const {
    const auto begin = curve(from[0]), end = curve(to[0]);
    return {{"q", from[0]},
            {R"(\ddot q)", force(from)},
            {R"(\Delta q)", to[0] - from[0]},
            {R"(\Delta x_2)", end[1] - begin[1]},
            {R"(\Delta x_3)", end[2] - begin[2]}};
  }
};

/// The book's bead at a time.
struct At {
  double t;
  State state;
  TypesetLetters typeset() const {
    return {{"t", t}, {R"(\dot q)", state[1]}, {R"(\ddot q)", force(state)}, {"x", curve(state[0])}};
  }
};

constexpr int last_second = 1000;

/// The bead at each whole second but the first, and after each step of the book's run.
std::vector<At> later(const std::vector<State>& run) {
  const OneCoordinate<double> bead{{1, 1}};
  const auto at_seconds = ode::integrate<ode::DormandPrince54>(
                              bead, bead.start(), Horizon{last_second, last_second}.times(), 1e-10)
                              .value;
  std::vector<At> all;
  for (std::size_t i = 1; i < at_seconds.size(); ++i) all.push_back({static_cast<double>(i), at_seconds[i]});
  for (std::size_t i = 1; i < run.size(); ++i) all.push_back({static_cast<double>(i) * book_step, run[i]});
  return all;
}

void run_down(Claims& claims, const std::vector<State>& run) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i + 1 < run.size(); ++i) steps.push_back({run[i], run[i + 1]});
  claims.over(std::vector<Sample>{{1, 1, 1, 0, 0}})(
      "start", 1375,
      R"(The initial position is $(1,1,1)$, the initial velocity $(0,0,0)$: $q(0)=1$, $\dot q(0)=0$.)",
      {R"(the curve and its tangent at $q=1$, $\dot q=0$)",
       [](const Sample& s) {
         const auto x = curve(s.q), u = velocity(s.q, s.v);
         return values(x[0], x[1], x[2], u[0], u[1], u[2]);
       }},
      {R"($(1,\ 1,\ 1,\ 0,\ 0,\ 0)$)"}, "position and velocity");

  const auto positive_after = std::ranges::count_if(steps, [](const Step& s) { return force(s.to) > 0; });
  claims.statement<Step>(
      "rhs_negative", 1415, R"(The right-hand side, $\ddot q$, is always negative.)", steps,
      {.printed = {R"($\ddot q<0$)"},
       .corrected = {R"($q\ddot q<0$)"},
       .near_misses = {{R"($(q+0.01)\ddot q<0$)"}},
       .kind = Fault::counterexample,
       .root = "beyond the origin",
       .why = filled(
           R"(The second term has the sign of $-q$. At $q=0$ $\ddot q=@1$, and beyond it $\ddot q$ is positive, )"
           "in the book's own run after each of the last @4 of its @4 steps. (The samples are the beginnings of "
           "its steps, and the first of these ends beyond the origin.)",
           {force({0, -1}), static_cast<double>(positive_after), book_steps})});

  const auto at_origin = event_of<ode::Fehlberg78>(OneCoordinate<double>{{1, 1}}, 1e-12).value.after;
  const auto turns_at = [&](double q) {
    return in_all<Step>(R"($\dot q$ decreases, then increases)", steps, [q](const Step& s) {
      return (s.from[0] > q && s.to[0] < q) || (s.to[1] < s.from[1]) == (s.from[0] > q);
    });
  };
  claims.add(
      "velocity_decreases", 1415, R"($\dot q$ is a decreasing function of time.)",
      {.printed = {R"($\dot q$ decreases)",
                   {in_all<Step>(R"($\dot q$ decreases)", steps,
                                 [](const Step& s) { return s.to[1] < s.from[1]; })}},
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
           R"($\dot q$ rises towards zero beyond the origin. The two rows printed show it, computed again: )"
           R"($\dot q=@9$ at $t=@4$ and $@9$ at $t=@4$.)",
           {run[2240][1], 2240 * book_step, run[2241][1], 2241 * book_step}),
       .kind = Fault::counterexample,
       .root = "beyond the origin"});

  claims.statement<At>(
      "velocity_negative", 1415,
      filled(R"($\dot q(t)<0$ for all times $t>0$ (our check: at whole seconds up to @4).)", {last_second}),
      later(run), {.printed = {R"($\dot q<0$)"}, .near_misses = {{R"($\ddot q<0$)"}}});

  claims.statement<Step>(
      "slides_down", 1415, "$q$ is a decreasing function of time: the bead slides down the curve.", steps,
      {.printed = {R"($(\Delta q,\ \Delta x_3)<(0,\ 0)$)"}, .near_misses = {{R"($\Delta x_2<0$)"}}});
}

// ---- the arrival ------------------------------------------------------------------------------------------

/// The time to the origin at g, and at g = 1.
struct Fall {
  double g, T, T1;
  TypesetLetters typeset() const { return {{"g", g}, {"T_1", T1}, {"T", T}}; }
};

void arrivals(Claims& claims, const std::vector<State>& run, const Reference& truth) {
  const Known T = truth("03_07_arrival", {1, 1});
  const auto event = event_of<ode::Fehlberg78>(CartesianWithConstraints<double>{{1, 1}}, 1e-12).value;
  const Tolerance integrated{1e-10, "a hundred tolerances of the integration"};

  const auto time_at = [&](double g) { return truth("03_07_arrival", {1, g}).value[0]; };
  claims.over(std::vector<Fall>{{1, time_at(1), time_at(1)}, {4, time_at(4), time_at(1)}})(
      "needs_g", 1417, "To find the time to the origin one has to select $g$.",
      {"table", [](const Fall& s) { return s.T; }}, {R"($T_1/\sqrt g$)"},
      "the time to the origin at $g$, $T_1$ being that at $g=1$");

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

  const auto output = [&](std::size_t step, const std::string& q, const std::string& v,
                          const std::string& x) -> Reading {
    return {"$q=" + q + R"($, $\dot q=)" + v + "$, position $(" + x + ",0,0)$",
            {as_written("$q$", q, {"the book's run", run[step][0]}),
             as_written(R"($\dot q$)", v, {"the book's run", run[step][1]}),
             {"position",
              {"as printed", {std::stod(x), 0, 0}},
              {"the book's run", curve(run[step][0])},
              printed_decimals(4)},
             as_written("$q$", q,
                        {"table", truth("03_07_slide", {1, 1, static_cast<double>(step) / 1000}).value[0]})}};
  };
  const auto row = [&](int line, std::size_t step, const std::string& q, const std::string& v,
                       const std::string& x, const std::string& other_q, const std::string& other_v) {
    const Reading printed = output(step, q, v, x);
    claims.add(
        "row_" + std::to_string(step), line,
        "At $t=" + format_shortest(static_cast<double>(step) / 1000) + "$ the output has " + printed.text +
            ".",
        {.printed = printed, .near_misses = {output(step, other_q, v, x), output(step, q, other_v, x)}});
  };
  row(1421, 2240, "0.00017622", "-1.41421347", "0.0002", "0.00017623", "-1.41421346");
  row(1423, 2241, "-0.00123799", "-1.41420923", "-0.0012", "-0.00123798", "-1.41420922");

  claims.statement<Fall>(
      "between", 1425, "$q$ reaches zero somewhere between 2.24 and 2.241.", {{1, time_at(1), time_at(1)}},
      {.printed = {"$2.24<T<2.241$"}, .near_misses = {{"$2.241<T<2.242$"}, {"$2.239<T<2.24$"}}});
  // The way of one step is 0.001 times the speed at the origin.
  claims.statement<At>("near_the_origin", 1425, "In both rows the position is approximately the zero vector.",
                       {{2240 * book_step, run[2240]}, {2241 * book_step, run[2241]}},
                       {.printed = {R"($|x|<0.001\sqrt2$)"}, .near_misses = {{R"($|x|<0.0005\sqrt2$)"}}});
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
  const auto all =
      for_all<SampleOf>("try rewrite pow2_sqrt by nra; field",
                        "it holds for every bead in any motion on the curve", {0.5, 1, 1.5, 2, 2.5});
  Provables proved = table.proofs("3.7", all);
  const auto& s = all.any;
  const auto lemma = [&](const char* name, const std::string& text, const Shortened& right) -> Lemma {
    const auto is = equal(recorded_text(text, typeset_of(s)), {right.expression()});
    return {name, all.letters, positive({s.m}), is, by_positive_metric};
  };
  proved.push_back(
      {"3.7-equation_of_motion",
       "it is Lagrange's equation, and that of gravity and the wire's force, in any motion on the curve",
       {lemma("lagrange", solved, s.by_lagrange()), lemma("forces", solved, s.by_forces())}});
  const SampleOf<Shortened> still{1.0, 1.0, 1.0, 0.0, 0.0};
  proved.push_back(
      {"3.7-only_gravity",
       "gravity's power is that of the whole force, in any motion on the curve; without the wire the bead would "
       "set off otherwise",
       {lemma("printed", power, 0),
        {"the_wire_pushes", "", {}, {apart(0, still.acceleration()[0].expression(), 0.2)}, "interval"}},
       0.2});
  const auto place = curve(s.q), u = velocity(s.q, s.v);
  const auto is = [](const std::array<Shortened, 3>& a, const char* b) {
    std::string all_three;
    for (const Shortened& component : a)
      all_three += (all_three.empty() ? "" : " /\\ ") + component.expression().coq() + " = " + b;
    return all_three;
  };
  const std::string tactic = "intuition (subst; lra)",
                    rests = "(" + is(place, "1") + " /\\ " + is(u, "0") + ") <-> (q = 1 /\\ v = 0)";
  proved.push_back({"3.7-start",
                    "q = 1 and q' = 0 is being at rest at (1, 1, 1), and nothing else is",
                    {{"printed", "(q v : R)", {}, {{rests}}, tactic}}});
  proved.push_back({"3.7-at_the_origin",
                    "q = 0 is being at the origin, and nothing else is",
                    {{"printed", "(q : R)", {}, {{"(" + is(place, "0") + ") <-> q = 0"}}, tactic}}});
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
