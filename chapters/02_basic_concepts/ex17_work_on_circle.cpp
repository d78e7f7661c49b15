// Exercise 2.17: the work of the forces (1, 1, 1) and (t, t, 1) on a particle at (r cos wt, r sin wt, 0).
//   W(T) = r (cos x + sin x - 1)  and  r/w (x (cos x + sin x) + cos x - sin x - 1),  x = w T
//   both are stationary at x = pi/4 + k pi, the second at T = 0 as well
// The other route knows the path alone: its velocity by dual numbers, the work by Gauss-Legendre quadrature
// of F . v. Every formula is compared at random r and w, of either sign or away from 1, so that no factor of
// w can hide.

#include "chapters/02_basic_concepts/circle_work.hpp"
#include "chapters/random.hpp"

namespace oddity {

namespace {

using namespace circle;
using std::numbers::sqrt2;
using M = const Motion&;

constexpr Parameter parameters[] = {
    {"r", 1, "m", "radius", 1e-3, 1e3},
    {"omega", 1, "rad/s", "angular speed", 1e-2, 10},
    {"T", 10, "s", "time", 1e-6, 100},
    {"turn", 0, "", "whole turns before the maximum", 0, 15},
    {"seed", 17, "", "of the random samples", 0, 1e9},
};

// ---- samples ----------------------------------------------------------------------------------------------

struct Form {
  std::string text;
  std::function<Value(M)> value;
};

/// The size of the terms that were added up, the rounding of x = omega T in the sine included.
using Size = double (*)(M);
double of_power(M m) { return abs(m.r * m.w) * (1 + abs(m.x())); }
double of_growing_power(M m) { return of_power(m) * (1 + abs(m.T)); }
double of_work(M m) { return abs(m.r) * (1 + abs(m.x())); }
double of_growing_work(M m) { return of_work(m) * (abs(m.T) + 1 / abs(m.w)); }
double of_turns(M m) { return abs(m.r) * (10 + abs(m.x())) * (1 + m.w * m.w); }
double of_maxima(M m) { return abs(m.r) * 400 * (m.w + 1 / m.w); }  // omega T up to 20 max(omega, 1)

enum class Ways { both, forward };

/// A motion with x = omega T up to 12: r and omega of either sign, or positive and away from omega = 1.
Motion any(Ways ways, Random& random) {
  const double r = random.magnitude(0.2, 5), x = random.between(0, 12);
  if (ways == Ways::forward) {
    const double w = random.unit() < 0.5 ? random.between(0.2, 0.8) : random.between(1.25, 4);
    return {abs(r), w, x / w};
  }
  const double w = random.magnitude(0.2, 5);
  return {r, w, (random.unit() < 0.5 ? x : -x) / w};
}

/// The samples of one claim.
struct Samples {
  double seed;
  std::string quantity;
  Form truth;
  Size size;
  Ways ways = Ways::both;

  Reading of(const Form& form) const {
    Worst worst(quantity, form.text, truth.text);
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
      const Motion m = any(ways, random);
      worst.see(form.value(m), truth.value(m), size(m),
                "r = " + shortest(m.r) + ", omega = " + shortest(m.w) + ", T = " + shortest(m.T));
    }
    return {form.text, {worst.check()}};
  }
};

/// How many of 50 forward motions and of k = 0, ..., 11 satisfy what none should.
Reading none(const std::string& text, double seed, const std::function<bool(M, int k)>& violates) {
  long wrong = 0, samples = 0;
  Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const Motion m = any(Ways::forward, random);
    for (int k = 0; k < 12; ++k, ++samples) wrong += violates(m, k);
  }
  return {text, {never("violation of: " + text, wrong, samples)}};
}

// ---- formulas ---------------------------------------------------------------------------------------------

double c(M m) { return cos(m.x()); }
double s(M m) { return sin(m.x()); }

struct Row {
  std::string id;
  int line;
  Form printed;
  const Form& truth;
  Size size;
  std::vector<Form> near;
};

const Form velocity{"(r cos wt, r sin wt, 0)' by dual numbers", [](M m) { return Value(m.velocity(m.T)); }};
const Form gain{"gain of x + y along the path", [](M m) {
                  const Vector moved = m.position(m.T) - m.position(0.0);
                  return moved[0] + moved[1];
                }};
const Form power_1{"(1, 1, 1) . v by dual numbers", [](M m) { return power(Force::constant, m, m.T); }};
const Form power_t{"(t, t, 1) . v by dual numbers", [](M m) { return power(Force::growing, m, m.T); }};
const Form work_1{"quadrature of F . v", [](M m) { return work(Force::constant, m); }};
const Form work_t{"quadrature of F . v", [](M m) { return work(Force::growing, m); }};
const Form slope_1{"dW/dT of the quadrature", [](M m) { return work_slope(Force::constant, m); }};
const Form slope_t{"dW/dT of the quadrature", [](M m) { return work_slope(Force::growing, m); }};
const Form force_t{"length of (T, T, 1)", [](M m) { return length({m.T, m.T, 1}); }};
const Form zero{"zero", [](M) { return 0.0; }};

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
  const auto of_slope = [](M m) {
    const auto f = [&](double t) { return m.r * m.w * (cos(m.w * t) - sin(m.w * t)); };
    return integral(m, f);
  };
  const Row rows[] = {
      {"velocity",
       805,
       {"v = (-r w sin, r w cos, 0)",
        [](M m) {
          return Value{-m.r * m.w * s(m), m.r * m.w * c(m), 0};
        }},
       velocity,
       of_power,
       {{"(r w sin, r w cos, 0)",
         [](M m) {
           return Value{m.r * m.w * s(m), m.r * m.w * c(m), 0};
         }},
        {"(-r sin, r cos, 0)",
         [](M m) {
           return Value{-m.r * s(m), m.r * c(m), 0};
         }}}},
      {"work_integral",
       809,
       {"W = int (1, 1, 1) . (-r w sin, r w cos, 0) dt", of_slope},
       gain,
       of_work,
       {{"- int", [=](M m) { return -of_slope(m); }}}},
      {"power",
       813,
       {"(1, 1, 1) . v = r w (cos - sin)", [](M m) { return m.r * m.w * (c(m) - s(m)); }},
       power_1,
       of_power,
       {{"r w (cos + sin)", [](M m) { return m.r * m.w * (c(m) + s(m)); }},
        {"r (cos - sin)", [](M m) { return m.r * (c(m) - s(m)); }}}},
      {"antiderivative",
       815,
       {"r (cos + sin) has the derivative F . v", primitive(1)},
       power_1,
       of_power,
       {{"r (cos - sin)", primitive(-1)}}},
      {"work",
       815,
       {"W(T) = r (cos + sin - 1)", [](M m) { return m.r * (c(m) + s(m) - 1); }},
       work_1,
       of_work,
       {{"r (cos + sin)", [](M m) { return m.r * (c(m) + s(m)); }},
        {"r w (cos + sin - 1)", [](M m) { return m.r * m.w * (c(m) + s(m) - 1); }}}},
      {"growing_power",
       835,
       {"(t, t, 1) . v = r w t (cos - sin)", [](M m) { return m.r * m.w * m.T * (c(m) - s(m)); }},
       power_t,
       of_growing_power,
       {{"r w (cos - sin)", [](M m) { return m.r * m.w * (c(m) - s(m)); }},
        {"r w t (cos - sin) + 1", [](M m) { return m.r * m.w * m.T * (c(m) - s(m)) + 1; }}}},
      {"by_parts",
       839,
       {"W = T r (cos + sin) - int r (cos + sin) dt, by parts", parts(-1)},
       work_t,
       of_growing_work,
       {{"+ int", parts(1)}}},
      {"growing_derivative",
       841,
       {"W'(T) = r w T (cos - sin) for (t, t, 1)", [](M m) { return m.r * m.w * m.T * (c(m) - s(m)); }},
       slope_t,
       of_growing_power,
       {{"r T (cos - sin)", [](M m) { return m.r * m.T * (c(m) - s(m)); }}}},
      {"magnitude",
       849,
       {"|(t, t, 1)| = sqrt(2 t^2 + 1)", [](M m) { return sqrt(2 * m.T * m.T + 1); }},
       force_t,
       [](M m) { return 1 + abs(m.T); },
       {{"sqrt(t^2 + 1)", [](M m) { return sqrt(m.T * m.T + 1); }}}},
  };
  std::vector<Claim> claims;
  for (const Row& row : rows) {
    const Samples samples{seed, row.printed.text, row.truth, row.size};
    Claim claim{"2.17-" + row.id, row.line, row.printed.text, samples.of(row.printed)};
    for (const Form& near : row.near) claim.near_misses.push_back(samples.of(near));
    claims.push_back(std::move(claim));
  }
  return claims;
}

std::vector<Claim> misprints(double seed) {
  Claim slope{"2.17-derivative", 821, "W'(T) for (1, 1, 1)"};
  const Samples slopes{seed, slope.says, slope_1, of_power};
  slope.printed = slopes.of(
      {"r w (-sin wT + cos wt), t = T + 1", [](M m) { return m.r * m.w * (-s(m) + cos(m.w * (m.T + 1))); }});
  slope.meant = slopes.of({"r w (-sin wT + cos wT)", [](M m) { return m.r * m.w * (-s(m) + c(m)); }});
  slope.near_misses = {slopes.of({"r w (sin wT + cos wT)", [](M m) { return m.r * m.w * (s(m) + c(m)); }})};
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
  work.why =
      "A fraction bar and a parenthesis are lost: the factor is $r/\\omega$, not $r\\omega$, and stands "
      "before "
      "the whole. The two differ by $\\omega^2$ and agree at $\\omega=1$ alone.";

  Claim turn{"2.17-full_turn", 817, "after one turn the work is zero"};
  const auto until = [&](const std::string& text, double (*T)(double)) {
    const Form until_T{text, [T](M m) { return circle::work(Force::constant, m.at(T(m.w))); }};
    return Samples{seed, "work of (1, 1, 1)", zero, of_turns, Ways::forward}.of(until_T);
  };
  turn.printed = until("W(2 pi omega) = 0", [](double w) { return 2 * pi * w; });
  turn.meant = until("W(2 pi / omega) = 0", [](double w) { return 2 * pi / w; });
  turn.near_misses = {until("W(pi / omega) = 0", [](double w) { return pi / w; })};
  turn.why =
      "The fraction bar is lost: a turn takes $2\\pi/\\omega$. At $2\\pi\\omega$ the particle has turned by "
      "$2\\pi\\omega^2$ and the work is zero by chance only, as for $\\omega=1$; for $\\omega=1/\\sqrt2$ it "
      "is "
      "$-2r$.";
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
                           .of(along("along a detour", 1, swirl))};

  Claim trip{"2.17-round_trip", 817, "so once around the circle, from any start, the net work is zero"};
  const auto turn = [&](const std::string& text, Force force) {
    const Form form{text, [force](M m) { return work(force, m.at(m.T + 2 * pi / m.w), m.T); }};
    return Samples{seed, "work of a turn from a random start", zero, of_turns, Ways::forward}.of(form);
  };
  trip.printed = turn("(1, 1, 1)", Force::constant);
  trip.near_misses = {turn("(t, t, 1)", Force::growing)};
  return {field, trip};
}

/// Whether W is larger at T than a little before and after; with `sign` -1, smaller.
bool is_peak(Force force, M m, double T, double sign = 1) {
  const double h = 0.01 / m.w;
  return sign * work(force, m.at(T), T - h) > 0 && sign * work(force, m.at(T + h), T) < 0;
}

double stationary(M m, int k) { return (pi / 4 + k * pi) / m.w; }

/// All zeros of the power with |x| < 12.5 but the growing one's at 0, by Brent's method over a scan.
Form zeros_of(Force force) {
  return {"Brent's method over a scan", [=](M m) {
            std::vector<double> found;
            for (double x = -12.45; x < 12.5; x += 0.1)
              if (const auto root =
                      brent([&](double t) { return power(force, m, t); }, x / m.w, (x + 0.1) / m.w, 1e-15);
                  root.reached() && (force == Force::constant || abs(x) > 0.1))
                found.push_back(m.w * root.value);
            return Value(found);
          }};
}

Form spaced(const std::string& text, double first, double step) {
  std::vector<double> all;
  for (double x = first - 4 * pi; x < 12.5; x += step) all.push_back(x);
  return {text, [all](M) { return Value(all); }};
}

std::vector<Claim> extrema(double seed) {
  const auto constant = Force::constant, growing = Force::growing;
  Claim maximum{"2.17-maximum_where_stationary", 819, "the net work is a maximum when W' = 0"};
  maximum.printed = none("where W' = 0 there is a maximum", seed,
                         [=](M m, int k) { return !is_peak(constant, m, stationary(m, k)); });
  maximum.meant = none("where there is a maximum W' = 0", seed, [=](M m, int k) {
    const double T = m.T + 0.5 * k / m.w;
    return abs(power(constant, m, T)) > 0.1 * m.r * m.w && is_peak(constant, m, T);
  });
  maximum.near_misses = {none("where W' = 0 there is a minimum", seed,
                              [=](M m, int k) { return !is_peak(constant, m, stationary(m, k), -1); })};
  maximum.why =
      "$W'=0$ is necessary and not sufficient: every other such time, $\\omega T=5\\pi/4, 13\\pi/4,\\ldots$, "
      "is "
      "a minimum, $W=-r(\\sqrt2+1)$. The text itself says so two sentences on.";

  const auto twenty = [](M) { return 20.0; };
  const double first = pi / 4;
  Claim zeros{"2.17-zeros", 823, "W' = 0 where tan wT = 1: at wT = pi/4 + k pi, k any integer"};
  const Samples roots{seed, "all zeros of W', as wT", zeros_of(constant), twenty, Ways::forward};
  zeros.printed = roots.of(spaced("pi/4 + k pi", first, pi));
  const Form tangents{"tan wT at the zeros", [=](M m) {
                        Value all = zeros_of(constant).value(m);
                        for (std::size_t k = 0; k < all.size(); ++k) all[k] = std::tan(all[k]);
                        return all;
                      }};
  const Form ones{"1", [](M) { return Value(std::vector<double>(8, 1)); }};
  zeros.printed.checks.push_back(
      Samples{seed, "tan wT at the zeros", tangents, twenty, Ways::forward}.of(ones).checks[0]);
  zeros.near_misses = {roots.of(spaced("pi/4 + 2 k pi", first, 2 * pi)),
                       roots.of(spaced("3 pi/4 + k pi", 3 * first, pi))};

  Claim halves{"2.17-halves", 823, "half of these times are minima, the other half maxima"};
  const auto alternate = [=](const std::string& text, int even) {
    return none(text, seed, [=](M m, int k) {
      return !is_peak(constant, m, stationary(m, k - 6), k % 2 == 0 ? even : -even);
    });
  };
  halves.printed = alternate("even k: maximum, odd k: minimum", 1);
  halves.near_misses = {alternate("odd k: maximum, even k: minimum", -1)};

  Claim highest{"2.17-first_maximum", 825, "at T = pi/(4 w) W has its maximum, r (sqrt 2 - 1)"};
  const Form at_first{"quadrature of F . v",
                      [](M m) { return work(Force::constant, m.at(stationary(m, 0))); }};
  const Samples values{seed, "W(pi/(4 w))", at_first, of_work, Ways::forward};
  highest.printed = values.of({"r (sqrt 2 - 1)", [](M m) { return m.r * (sqrt2 - 1); }});
  highest.printed.checks.push_back(none("W is nowhere larger", seed, [=](M m, int k) {
                                     const double rounds = 1e-12 * m.r;
                                     return work(constant, m.at(m.T + k / m.w)) > m.r * (sqrt2 - 1) + rounds;
                                   }).checks[0]);
  highest.near_misses = {values.of({"r sqrt 2", [](M m) { return m.r * sqrt2; }}),
                         values.of({"r/w (sqrt 2 - 1)", [](M m) { return m.r / m.w * (sqrt2 - 1); }})};

  Claim growing_zeros{"2.17-growing_zeros", 843,
                      "for (t, t, 1), W' = 0 at wT = pi/4 + k pi (and at T = 0, which is not named)"};
  const Samples growing_roots{seed, "zeros of W' but T = 0, as wT", zeros_of(growing), twenty, Ways::forward};
  growing_zeros.printed = growing_roots.of(spaced("pi/4 + k pi", first, pi));
  growing_zeros.near_misses = {growing_roots.of(spaced("pi/4 + k pi/2", first, pi / 2))};

  Claim local{"2.17-local_maxima", 843, "those with even k are local maxima (k >= 0)"};
  const auto all_peaks = [=](const std::string& text, int odd) {
    return none(text, seed, [=](M m, int n) { return !is_peak(growing, m, stationary(m, 2 * n + odd)); });
  };
  local.printed = all_peaks("even k: maximum", 0);
  local.near_misses = {all_peaks("odd k: maximum", 1)};
  return {maximum, zeros, halves, highest, growing_zeros, local};
}

/// f(x) at x = pi/4 + 2 n pi, n = 0, ..., 3.
template <class F>
Form at_maxima(const std::string& text, const F& f) {
  return {text, [=](M m) {
            std::vector<double> all;
            for (int n = 0; n < 4; ++n) all.push_back(f(m, pi / 4 + 2 * n * pi));
            return Value(all);
          }};
}

Claim maxima_value(double seed) {
  Claim claim{"2.17-maxima_value", 845, "the work of (t, t, 1) at its local maxima"};
  const auto at_T =
      at_maxima("W at T = x by quadrature", [](M m, double x) { return work(Force::growing, m.at(x)); });
  const auto at_wT = at_maxima("W at w T = x by quadrature",
                               [](M m, double x) { return work(Force::growing, m.at(x / m.w)); });
  const Samples literal{seed, "W at x = pi/4 + 2 n pi", at_T, of_maxima, Ways::forward};
  const Samples turned{seed, "W at x = pi/4 + 2 n pi", at_wT, of_maxima, Ways::forward};
  claim.printed =
      literal.of(at_maxima("W(x) = r w x sqrt 2", [](M m, double x) { return m.r * m.w * x * sqrt2; }));
  claim.meant =
      turned.of(at_maxima("W(x/w) = r/w x sqrt 2", [](M m, double x) { return m.r / m.w * x * sqrt2; }));
  claim.corrected = turned.of(
      at_maxima("W(x/w) = r/w (x sqrt 2 - 1)", [](M m, double x) { return m.r / m.w * (x * sqrt2 - 1); }));
  claim.near_misses = {turned.of(
      at_maxima("W(x/w) = r/w (x sqrt 2 + 1)", [](M m, double x) { return m.r / m.w * (x * sqrt2 + 1); }))};
  claim.why =
      "The $-1$ of the closed form is dropped: with $x=\\pi/4+2n\\pi$ the work is "
      "$\\frac r\\omega(\\sqrt2\\,x-1)$ at $T=x/\\omega$. For $r=\\omega=1$ the first maximum is $0.1107$, "
      "not "
      "$1.1107$. Besides, the argument should be a time, $x/\\omega$, and the factor is $r/\\omega$.";
  return claim;
}

std::vector<Claim> growth(double seed) {
  const auto steps = [=](const std::string& text, double sign, double (*T)(M, double x), double x0) {
    return none(text, seed, [=](M m, int k) {
      const double x = x0 + 2 * (k % 4) * pi;
      return !(sign * work(Force::growing, m.at(T(m, x + 2 * pi)), T(m, x)) > 0);
    });
  };
  const auto as_time = [](M, double x) { return x; };
  const auto as_angle = [](M m, double x) { return x / m.w; };
  const double maxima_at = pi / 4, minima_at = 5 * pi / 4;
  Claim maxima{"2.17-maxima_grow", 849, "as n grows, so does the net work at the maxima"};
  maxima.printed = steps("W(pi/4 + 2 n pi) grows", 1, as_time, maxima_at);
  maxima.meant = steps("W at w T = pi/4 + 2 n pi grows", 1, as_angle, maxima_at);
  maxima.near_misses = {steps("W at w T = 5 pi/4 + 2 n pi grows", 1, as_angle, minima_at)};
  maxima.why =
      "The maxima are at $\\omega T=\\pi/4+2n\\pi$, where $W$ grows by $2\\sqrt2\\,\\pi r/\\omega$ each "
      "time. At "
      "$T=\\pi/4+2n\\pi$, as printed, and $\\omega\\ne1$ it goes up and down.";

  Claim stronger{"2.17-magnitude_grows", 851, "the force's magnitude always grows with time"};
  const auto lengths = [=](const std::string& text, double sign) {
    return none(text, seed, [=](M m, int k) {
      const double h = std::pow(2.0, -k);
      return !(sign * (length({m.T + h, m.T + h, 1}) - length({m.T, m.T, 1})) > 0);
    });
  };
  stronger.printed = lengths("|F(t + h)| > |F(t)| for t > 0", 1);
  stronger.near_misses = {lengths("|F(t + h)| < |F(t)| for t > 0", -1)};

  Claim keeps{"2.17-work_keeps_growing", 851, "the force gets stronger, so the net work keeps growing"};
  keeps.printed = none("W grows", seed, [](M m, int k) {
    const double start = m.T + 0.5 * k / m.w;
    return !(work(Force::growing, m.at(start + 0.1 / m.w), start) > 0);
  });
  keeps.corrected = steps("the maxima grow", 1, as_angle, maxima_at);
  keeps.corrected.checks.push_back(steps("the minima sink", -1, as_angle, minima_at).checks[0]);
  keeps.near_misses = {steps("the minima grow", 1, as_angle, minima_at)};
  keeps.why =
      "A stronger force swings the work more widely: the maxima rise by $2\\sqrt2\\,\\pi r/\\omega$ a turn, "
      "and "
      "the minima, at $\\omega T=5\\pi/4+2n\\pi$, sink by as much. $W$ falls half of the time; for "
      "$r=\\omega=1$ from $0.11$ at $T=\\pi/4$ to $-6.55$ at $5\\pi/4$.";
  return {maxima, stronger, keeps};
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
  return {claims,
          {work_quantity("work", "works of (1, 1, 1) and of (t, t, 1) until T", m, truth), late,
           early_work(truth), maximum(m, p["turn"], truth)}};
}

}  // namespace

Exercise exercise_2_17() {
  return {
      "Work around a circle",
      "A particle is at $(r\\cos\\omega t, r\\sin\\omega t, 0)$. What work do $F=(1,1,1)$ and $F=(t,t,1)$ do "
      "until the time $T$, and when is it extremal?",
      parameters, false, study};
}

}  // namespace oddity
