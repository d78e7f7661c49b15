#pragma once

#include "chapters/02_basic_concepts/17_work_on_circle/circle_samples.hpp"

/// Exercise 2.17, the claims about maxima and minima of the work. The other route finds them by scanning the
/// power or compares works by quadrature.
namespace oddity::circle {

using std::numbers::sqrt2;

/// Whether W is larger at T than a little before and after; with `sign` -1, smaller.
inline bool is_peak(Force force, M m, double T, double sign = 1) {
  const double h = 0.01 / m.w;
  return sign * work(force, m.at(T), T - h) > 0 && sign * work(force, m.at(T + h), T) < 0;
}

inline double stationary(M m, int k) { return (pi / 4 + k * pi) / m.w; }

/// All zeros of the power with |x| < 12.5, by Brent's method over a scan.
inline Form zeros_of(Force force) {
  return {"Brent's method over a scan", [=](M m) {
            std::vector<double> found;
            for (double x = -12.45; x < 12.5; x += 0.1)
              if (const auto root =
                      brent([&](double t) { return power(force, m, t); }, x / m.w, (x + 0.1) / m.w, 1e-15);
                  root.reached())
                found.push_back(m.w * root.value);
            return Value(found);
          }};
}

inline Form spaced(const std::string& text, double first, double step) {
  std::vector<double> all;
  for (double x = first - 4 * pi; x < 12.5; x += step) all.push_back(x);
  return {text, [all](M) { return Value(all); }};
}

inline std::vector<Claim> extrema(double seed) {
  const auto constant = Force::constant, growing = Force::growing;
  Claim maximum{"2.17-maximum_where_stationary", 819, "the net work is a maximum when W' = 0"};
  maximum.printed = none("where W' = 0 there is a maximum", seed,
                         [=](M m, int k) { return !is_peak(constant, m, stationary(m, k)); });
  maximum.corrected = none("where there is a maximum W' = 0", seed, [=](M m, int k) {
    const double T = m.T + 0.5 * k / m.w;
    return abs(power(constant, m, T)) > 0.1 * m.r * m.w && is_peak(constant, m, T);
  });
  maximum.near_misses = {none("where W' = 0 there is a minimum", seed,
                              [=](M m, int k) { return !is_peak(constant, m, stationary(m, k), -1); })};
  maximum.kind = Fault::counterexample;
  maximum.root = "stationary for maximal";
  maximum.why =
      "$W'=0$ is necessary and not sufficient: every other such time, $\\omega T=5\\pi/4, "
      "13\\pi/4,\\ldots$, is a minimum, $W=-r(\\sqrt2+1)$, as the text itself says two sentences on.";

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

  Claim growing_zeros{"2.17-growing_zeros", 843, "for (t, t, 1), W' = 0 at wT = pi/4 + k pi"};
  const Samples growing_roots{seed, "all zeros of W', as wT", zeros_of(growing), twenty, Ways::forward};
  const auto and_zero = [](const Form& form) {
    return Form{form.text + ", and 0", [=](M m) {
                  const Value without = form.value(m);
                  std::vector<double> all(without.begin(), without.end());
                  all.insert(std::ranges::lower_bound(all, 0.0), 0.0);
                  return Value(all);
                }};
  };
  // The first three from x = -3 on, so that lists of different lengths can be compared.
  const auto three = [](const Form& form) {
    return Form{form.text, [=](M m) {
                  std::vector<double> found;
                  for (double x : Value(form.value(m)))
                    if (x > -3 && found.size() < 3) found.push_back(x);
                  return Value(found);
                }};
  };
  const Samples nearest{seed, "the first three zeros of W' from wT = -3 on", three(zeros_of(growing)), twenty,
                        Ways::forward};
  const Form printed_zeros = spaced("pi/4 + k pi", first, pi);
  growing_zeros.printed = nearest.of(three(printed_zeros));
  growing_zeros.corrected = growing_roots.of(and_zero(printed_zeros));
  growing_zeros.near_misses = {growing_roots.of(and_zero(spaced("3 pi/4 + k pi", 3 * first, pi)))};
  growing_zeros.kind = Fault::left_out;
  growing_zeros.root = "the start is stationary too";
  growing_zeros.why =
      "$W'=r\\omega T(\\cos\\omega T-\\sin\\omega T)$ has the factor $T$: it is zero at $T=0$ as well, a "
      "minimum, "
      "$W\\approx r\\omega T^2/2$, and no $\\pi/4+k\\pi$. A search for the first maximum that starts at "
      "$T=0$ "
      "ends there, with $W=0$ for $0.1107$ ($r=\\omega=1$).";

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
inline Form at_maxima(const std::string& text, const F& f) {
  return {text, [=](M m) {
            std::vector<double> all;
            for (int n = 0; n < 4; ++n) all.push_back(f(m, pi / 4 + 2 * n * pi));
            return Value(all);
          }};
}

inline Claim maxima_value(double seed) {
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
  claim.kind = Fault::formula;
  claim.root = "a term dropped at the maxima";
  claim.why =
      "The $-1$ of the closed form is dropped: with $x=\\pi/4+2n\\pi$ the work is $\\frac "
      "r\\omega(\\sqrt2\\,x-1)$ at $T=x/\\omega$. For $r=\\omega=1$ the first maximum is $0.1107$, not "
      "$1.1107$. Besides, the argument should be a time, $x/\\omega$, and the factor is $r/\\omega$.";
  return claim;
}

inline std::vector<Claim> growth(double seed) {
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
  maxima.kind = Fault::lost_typography;
  maxima.why =
      "The maxima are at $\\omega T=\\pi/4+2n\\pi$, where $W$ grows by $2\\sqrt2\\,\\pi r/\\omega$ each "
      "time. At $T=\\pi/4+2n\\pi$, as printed, and $\\omega\\ne1$ it goes up and down.";

  Claim stronger{"2.17-magnitude_grows", 851, "the force's magnitude always grows with time"};
  const auto lengths = [=](const std::string& text, double sign) {
    return none(text, seed, [=](M m, int k) {
      const double h = std::pow(2.0, -k);
      return !(sign * (length({m.T + h, m.T + h, 1}) - length({m.T, m.T, 1})) > 0);
    });
  };
  stronger.printed = lengths("|F(t + h)| > |F(t)| for t > 0", 1);
  stronger.near_misses = {lengths("|F(t + h)| < |F(t)| for t > 0", -1)};

  Claim keeps{"2.17-work_keeps_growing", 851,
              "as the force gets stronger the net work, that is its maxima of which the paragraph speaks, "
              "keeps growing (between them it falls, and deeper every time)"};
  keeps.printed = steps("the maxima grow", 1, as_angle, maxima_at);
  keeps.printed.checks.push_back(steps("the minima sink", -1, as_angle, minima_at).checks[0]);
  keeps.near_misses = {steps("the minima grow", 1, as_angle, minima_at),
                       none("W grows all the time", seed, [](M m, int k) {
                         const double start = m.T + 0.5 * k / m.w;
                         return !(work(Force::growing, m.at(start + 0.1 / m.w), start) > 0);
                       })};
  return {maxima, stronger, keeps};
}

}  // namespace oddity::circle
