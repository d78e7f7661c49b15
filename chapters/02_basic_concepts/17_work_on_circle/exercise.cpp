// Exercise 2.17: the work of the forces (1, 1, 1) and (t, t, 1) on a particle at (r cos wt, r sin wt, 0).
//   W(T) = r (cos x + sin x - 1)  and  r/w (x (cos x + sin x) + cos x - sin x - 1),  x = w T
//   both are stationary at x = pi/4 + k pi, the second at T = 0 as well
// The other route knows the path alone: its velocity by dual numbers, the work by Gauss-Legendre quadrature
// of F . v. Every formula is compared at random r and w, of either sign or away from 1, so that no factor of
// w can hide.

#include "chapters/02_basic_concepts/17_work_on_circle/circle_extrema.hpp"

namespace oddity {

namespace ex02_17 {

using namespace circle;

constexpr Parameter parameters[] = {
    {"r", 1, "m", "radius", 1e-3, 1e3},
    {"omega", 1, "rad/s", "angular speed", 1e-2, 10},
    {"T", 10, "s", "time", 1e-6, 100},
    {"turn", 0, "", "whole turns before the maximum", 0, 15, whole_number},
    {"seed", 17, "", "of the random samples", 0, 1e9, whole_number},
};

// ---- formulas ---------------------------------------------------------------------------------------------

double c(M m) { return cos(m.x()); }
double s(M m) { return sin(m.x()); }

/// r w^i T^j (a cos + b sin + d).
Formula wave(int i, int j, double a, double b, double d = 0) {
  return [=](M m) { return m.r * std::pow(m.w, i) * std::pow(m.T, j) * (a * c(m) + b * s(m) + d); };
}

/// A velocity (r w^i a sin, r w^i cos, 0).
Formula circling(int i, double a) {
  return [=](M m) {
    const double speed = m.r * std::pow(m.w, i);
    return Value{speed * a * s(m), speed * c(m), 0};
  };
}

const Form velocity{"(r cos wt, r sin wt, 0)' by dual numbers", [](M m) { return Value(m.velocity(m.T)); }};
const Form gain{"gain of x + y along the path", [](M m) {
                  const Vector moved = m.position(m.T) - m.position(0.0);
                  return moved[0] + moved[1];
                }};
const Form gain_t{"T times the end's x + y, less its integral over time", [](M m) {
                    const auto height = [&](double t) { return m.position(t)[0] + m.position(t)[1]; };
                    return m.T * height(m.T) - gauss_legendre(height, 0, m.T, 64).value;
                  }};
const Form power_1{"(1, 1, 1) . v by dual numbers", [](M m) { return power(Force::constant, m, m.T); }};
const Form power_t{"(t, t, 1) . v by dual numbers", [](M m) { return power(Force::growing, m, m.T); }};
const Form work_1{"quadrature of F . v", [](M m) { return work(Force::constant, m); }};
const Form work_t{"quadrature of F . v", [](M m) { return work(Force::growing, m); }};
const Form slope_1{"dW/dT of the quadrature", [](M m) { return work_slope(Force::constant, m); }};
const Form slope_t{"dW/dT of the quadrature", [](M m) { return work_slope(Force::growing, m); }};
const Form force_t{"length of (T, T, 1)", [](M m) { return std::hypot(m.T, m.T, 1); }};

template <class F>
double integral(M m, const F& f) {
  return gauss_legendre(f, 0, m.T, 64).value;
}

std::vector<Claim> formulas(double seed) {
  const auto primitive = [](double sign) {
    return [=](M m) {
      return derivative([&](const auto& t) { return m.r * (cos(m.w * t) + sign * sin(m.w * t)); }, m.T);
    };
  };
  const auto parts = [](double sign) {
    return [=](M m) {
      const auto f = [&](double t) { return m.r * (cos(m.w * t) + sin(m.w * t)); };
      return m.T * f(m.T) + sign * integral(m, f);
    };
  };
  const auto of_printed = [](double sign, Force force) {
    return [=](M m) {
      const auto f = [&](double t) {
        return (force == Force::constant ? 1 : t) * m.r * m.w * (cos(m.w * t) - sin(m.w * t));
      };
      return sign * integral(m, f);
    };
  };
  std::vector<Claim> all;
  const auto add = [&](const std::string& id, int line, const Form& printed, const Form& truth, Size size,
                       const std::vector<Form>& near) {
    const Samples samples{seed, "the formula", truth, size};
    Claim claim{"2.17-" + id, line, printed.text, samples.of(printed)};
    for (const Form& each : near) claim.near_misses.push_back(samples.of(each));
    all.push_back(std::move(claim));
  };
  add("velocity", 805, {"v = (-r w sin, r w cos, 0)", circling(1, -1)}, velocity, of_power,
      {{"(r w sin, r w cos, 0)", circling(1, 1)}, {"(-r sin, r cos, 0)", circling(0, -1)}});
  add("work_integral", 809, {"W = int (1, 1, 1) . (-r w sin, r w cos, 0) dt", of_printed(1, Force::constant)},
      gain, of_work, {{"- int", of_printed(-1, Force::constant)}});
  add("power", 813, {"(1, 1, 1) . v = r w (cos - sin)", wave(1, 0, 1, -1)}, power_1, of_power,
      {{"r w (cos + sin)", wave(1, 0, 1, 1)}, {"r (cos - sin)", wave(0, 0, 1, -1)}});
  add("antiderivative", 815, {"r (cos + sin) has the derivative F . v", primitive(1)}, power_1, of_power,
      {{"r (cos - sin)", primitive(-1)}});
  add("work", 815, {"W(T) = r (cos + sin - 1)", wave(0, 0, 1, 1, -1)}, work_1, of_work,
      {{"r (cos + sin)", wave(0, 0, 1, 1)}, {"r w (cos + sin - 1)", wave(1, 0, 1, 1, -1)}});
  add("growing_power", 835, {"(t, t, 1) . v = r w t (cos - sin)", wave(1, 1, 1, -1)}, power_t,
      of_growing_power, {{"r w (cos - sin)", wave(1, 0, 1, -1)}, {"r w t (cos + sin)", wave(1, 1, 1, 1)}});
  add("growing_integral", 829,
      {"W = int (t, t, 1) . (-r w sin, r w cos, 0) dt", of_printed(1, Force::growing)}, gain_t,
      of_growing_work,
      {{"- int", of_printed(-1, Force::growing)}, {"int (1, 1, 1) . v dt", of_printed(1, Force::constant)}});
  add("by_parts", 839, {"W = T r (cos + sin) - int r (cos + sin) dt, by parts", parts(-1)}, work_t,
      of_growing_work, {{"+ int", parts(1)}});
  add("growing_derivative", 841, {"W'(T) = r w T (cos - sin) for (t, t, 1)", wave(1, 1, 1, -1)}, slope_t,
      of_growing_power, {{"r T (cos - sin)", wave(0, 1, 1, -1)}});
  add("magnitude", 849, {"|(t, t, 1)| = sqrt(2 t^2 + 1)", [](M m) { return sqrt(2 * m.T * m.T + 1); }},
      force_t, [](M m) { return 1 + abs(m.T); },
      {{"sqrt(t^2 + 1)", [](M m) { return sqrt(m.T * m.T + 1); }}});
  return all;
}

std::vector<Claim> misprints(double seed) {
  Claim slope{"2.17-derivative", 821, "W'(T) for (1, 1, 1)"};
  const Samples slopes{seed, slope.says, slope_1, of_power};
  slope.printed = slopes.of(
      {"r w (-sin wT + cos wt), t = T + 1", [](M m) { return m.r * m.w * (-s(m) + cos(m.w * (m.T + 1))); }});
  slope.meant = slopes.of({"r w (-sin wT + cos wT)", wave(1, 0, 1, -1)});
  slope.near_misses = {slopes.of({"r w (sin wT + cos wT)", wave(1, 0, 1, 1)})};
  slope.kind = Fault::formula;
  slope.why =
      "The cosine keeps the variable of integration $t$, which has no value once the integral is done; both "
      "times are $T$, as the next line takes them. (The check puts $t=T+1$.)";

  Claim work{"2.17-growing_work", 837, "W(T) for (t, t, 1)"};
  const Samples works{seed, work.says, work_t, of_growing_work};
  const auto form = [](double power, bool whole) {
    return [=](M m) {
      const double factor = m.r * std::pow(m.w, power);
      return factor * (-1 + c(m) - s(m)) + (whole ? factor : 1) * m.x() * (c(m) + s(m));
    };
  };
  work.printed = works.of({"r w ((-1 + cos - sin) + T w (cos + sin))", form(1, true)});
  work.meant = works.of({"r/w ((-1 + cos - sin) + T w (cos + sin))", form(-1, true)});
  work.near_misses = {works.of({"r w (-1 + cos - sin) + T w (cos + sin)", form(1, false)}),
                      works.of({"r (-1 + cos - sin + T w (cos + sin))", form(0, true)})};
  work.kind = Fault::lost_typography;
  work.why =
      "A fraction bar and a parenthesis are lost: the factor is $r/\\omega$, not $r\\omega$, and stands "
      "before the whole. The two differ by $\\omega^2$ and agree at $\\omega=1$ alone.";

  Claim turn{"2.17-full_turn", 817, "after one turn the work is zero"};
  const auto until = [&](const std::string& text, double (*T)(double)) {
    const Form until_T{text, [T](M m) { return circle::work(Force::constant, m.at(T(m.w))); }};
    return Samples{seed, "work of (1, 1, 1)", zero, of_turns, Ways::forward}.of(until_T);
  };
  turn.printed = until("W(2 pi omega) = 0", [](double w) { return 2 * pi * w; });
  turn.meant = until("W(2 pi / omega) = 0", [](double w) { return 2 * pi / w; });
  turn.near_misses = {until("W(pi / omega) = 0", [](double w) { return pi / w; })};
  turn.kind = Fault::lost_typography;
  turn.why =
      "The fraction bar is lost: a turn takes $2\\pi/\\omega$. At $2\\pi\\omega$ the particle has turned "
      "by $2\\pi\\omega^2$ and the work is zero by chance only, as for $\\omega=1$; for "
      "$\\omega=1/\\sqrt2$ it is $-2r$.";
  return {slope, work, turn};
}

// ---- statements -------------------------------------------------------------------------------------------

/// The work of a field of positions from the path's start to its end; `detour` leaves the circle by a loop.
template <class Field>
Form along(const std::string& text, double detour, const Field& field) {
  return {text, [=](M m) {
            const auto curve = [&](const auto& u) {
              auto at = m.position(m.T * u);
              const auto loop = detour * sin(2 * pi * u);
              return std::array{at[0] + loop, at[1] - 2.0 * loop * u, at[2] + m.w * loop};
            };
            const auto rate = [&](double u) {
              const auto moved = curve(Dual<double>(u, 1));
              return dot(field(curve(u)), {moved[0].slope, moved[1].slope, moved[2].slope});
            };
            return gauss_legendre(rate, 0, 1, 64).value;
          }};
}

std::vector<Claim> conservation(double seed) {
  const auto one = [](const Vector&) { return Vector{1, 1, 1}; };
  const auto swirl = [](const Vector& at) { return Vector{1 - at[1], 1 + at[0], 1}; };
  Claim field{"2.17-conservative", 817, "the field (1, 1, 1) is conservative"};
  const auto size = [](M m) { return 20 * (1 + abs(m.r)) * (1 + abs(m.x())) * (1 + abs(m.w)); };
  field.printed = Samples{seed, "work between the same ends", along("along the circle", 0, one), size}.of(
      along("along a detour", 1, one));
  field.near_misses = {Samples{seed, "work of (1 - y, 1 + x, 1) between the same ends",
                               along("along the circle", 0, swirl), size}
                           .of(along("along a detour, in the field (1 - y, 1 + x, 1)", 1, swirl))};

  Claim trip{"2.17-round_trip", 817, "so once around the circle, from any start, the net work is zero"};
  const auto turn = [&](const std::string& text, Force force) {
    const Form form{text, [force](M m) { return work(force, m.at(m.T + 2 * pi / m.w), m.T); }};
    return Samples{seed, "work of a turn from a random start", zero, of_turns, Ways::forward}.of(form);
  };
  trip.printed = turn("(1, 1, 1)", Force::constant);
  trip.near_misses = {turn("(t, t, 1)", Force::growing)};
  return {field, trip};
}

Findings study(const Parameters& p, const Reference& truth) {
  const double seed = p["seed"];
  std::vector<Claim> claims{maxima_value(seed)};
  for (const auto& part : {formulas(seed), misprints(seed), conservation(seed), extrema(seed), growth(seed)})
    claims.insert(claims.end(), part.begin(), part.end());
  std::ranges::stable_sort(claims, {}, &Claim::line);

  const Motion m{p["r"], p["omega"], p["T"]};
  Quantity late = work_quantity(
      "late_work", "both works after 32 turns: r = 1.5 m, omega = 2.5 rad/s, T = 80 s", {1.5, 2.5, 80}, truth,
      {Outcome::raised, Outcome::stalled, "1e-12 is less than the rounding of 32 turns leaves"});
  late.add(Breakdown{"The printed factor r omega is right at omega = 1 alone; here it is wrong by omega^2.",
                     "closed form, factor r omega, as printed", 0, Outcome::inaccurate,
                     "closed form, factor r / omega", 0});
  late.add(Breakdown{"64 points are two a turn over 32 turns, too few to see the oscillation.",
                     "power, Gauss-Legendre", 64, Outcome::inaccurate, "power, Gauss-Legendre", 256});
  return {
      claims,
      {work_quantity("work", "works of (1, 1, 1) and of (t, t, 1) until T", m, truth), late,
       early_work(truth), maximum(m, p["turn"], truth)},
      {{"stationary for maximal",
        R"(With $r=\omega=1$ the work at $T=5\pi/4$ is $-2.414$, stationary and the least there is, where the )"
        R"(first maximum has 0.414.)"},
       {"the start is stationary too",
        R"(A search for the first maximum that starts at $T=0$ ends there, with no work for 0.1107 )"
        R"(($r=\omega=1$).)"},
       {"a term dropped at the maxima",
        R"(With $r=\omega=1$ the first maximum is 0.1107 and the printed formula says 1.1107: ten times the )"
        R"(work that the force does.)"}}};
}

}  // namespace ex02_17

Exercise exercise_2_17() {
  using namespace ex02_17;
  return {
      "Work around a circle",
      "A particle is at $(r\\cos\\omega t, r\\sin\\omega t, 0)$. What work do $F=(1,1,1)$ and $F=(t,t,1)$ do "
      "until the time $T$, and when is it extremal?",
      parameters,
      {},
      study};
}

}  // namespace oddity
