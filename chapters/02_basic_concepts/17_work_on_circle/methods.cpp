// The quantities of exercise 2.17: both works in a long, a late and a short time, and their maximum.

#include "chapters/02_basic_concepts/17_work_on_circle/work_on_circle.hpp"
#include "reference/reference.hpp"
#include "solvers/counted_calls.hpp"
#include "solvers/roots.hpp"

namespace oddity::work_on_circle {

namespace {

/// The antiderivatives. That of the growing force has the factor r/w, which the book prints as r w.
double closed_form(Force force, const Motion& m, double factor) {
  const double c = cos(m.x()), s = sin(m.x());
  return force == Force::constant ? m.r * (c + s - 1) : factor * (-1 + c - s + m.x() * (c + s));
}

/// The sum of F at mid-time times the chord.
Integral by_chords(Force force, const Motion& m, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double t0 = m.T * i / n, t1 = m.T * (i + 1) / n;
    const Vector chord = m.position(t1) - m.position(t0);
    sum += (force == Force::constant ? 1 : (t0 + t1) / 2) * (chord[0] + chord[1]) + chord[2];
  }
  return {sum, n};
}

/// The works of both forces as one answer.
template <class F>
Answer both_works(const F& one) {
  return all_of(2, [&](std::size_t k) { return one(static_cast<Force>(k)); });
}

/// Expected outcomes of GSL's adaptive rules at a tolerance of 1e-12.
struct AtTwelveDigits {
  Outcome qags = Outcome::ok, cquad = Outcome::ok;
  std::string why = {};
};

Quantity work_quantity(std::string name, std::string says, const Motion& m, const Reference& truth,
                       const AtTwelveDigits& strict = {}) {
  Quantity q = quantity(std::move(name), "J", std::move(says), truth("02_17_work", {m.r, m.w, m.T}),
                        {1e-10 * m.r * (1 + m.T), "ten digits of the most that the forces could do"});
  const auto add = [&](const std::string& algorithm, const Resolution& resolution, Rule (*rule)(double),
                       Outcome expected = Outcome::ok, const std::string& why = "") {
    q.add({"power", algorithm, resolution,
           [=](double setting) {
             return both_works([&](Force force) {
               return rule(setting)([&](double t) { return power(force, m, t); }, 0, m.T);
             });
           },
           expected, why});
  };
  const auto closed = [m](double factor) {
    return [m, factor](double) {
      return both_works([&](Force force) { return Integral{closed_form(force, m, factor), 1}; });
    };
  };
  const Resolution panels{"panels", {64, 256, 1024, 4096, 16384}};
  const std::string low = "second order is too low for ten digits at this step";
  q.add({"closed form", "factor r / omega", no_resolution(), closed(m.r / m.w)});
  if (m.w != 1)
    q.add({"closed form", "factor r omega, as printed", no_resolution(), closed(m.r * m.w),
           Outcome::inaccurate, R"(it is $r/\omega$; the two agree at $\omega=1$)"});
  add("QAGS", tolerances(), qags_rule, strict.qags, strict.why);
  add("CQUAD", tolerances(), cquad_rule, strict.cquad, strict.why);
  add("Gauss-Legendre", doubling("points", 4, 7), gauss_rule);
  add("Simpson", panels, simpson_rule);
  add("trapezoid", panels, trapezoid_rule, Outcome::inaccurate, low);
  q.add({"force times chord", "midpoint", Resolution{"chords", panels.settings},
         [m](double n) { return both_works([&](Force f) { return by_chords(f, m, static_cast<int>(n)); }); },
         Outcome::inaccurate, low});
  return q;
}

/// A maximum of f in [a, b] by golden section search down to the width `tolerance`.
template <class F>
Solved<double> golden_section(const F& of, double a, double b, double tolerance) {
  long evaluations = 0;
  const auto f = counted_calls(of, evaluations);
  const double golden = (sqrt(5.0) - 1) / 2;
  double left = b - golden * (b - a), right = a + golden * (b - a), at_left = f(left), at_right = f(right);
  while (b - a > tolerance && evaluations < 200) {
    if (at_left > at_right) {
      b = right, right = left, at_right = at_left;
      at_left = f(left = b - golden * (b - a));
    } else {
      a = left, left = right, at_left = at_right;
      at_right = f(right = a + golden * (b - a));
    }
  }
  return {(a + b) / 2, evaluations};
}

}  // namespace

Quantity work(const Motion& m, const Reference& truth) {
  return work_quantity("work", "works of $(1,1,1)$ and of $(t,t,1)$ until $T$", m, truth);
}

Quantity late_work(const Reference& truth) {
  constexpr Motion late_motion{1.5, 2.5, 80};
  constexpr double points = 64, turns = late_motion.w * late_motion.T / (2 * pi);
  Quantity late = work_quantity(
      "late_work",
      filled(R"(both works after @2 turns: $r=@2$ m, $\omega=@2$ rad/s, $T=@2$ s)",
             {turns, late_motion.r, late_motion.w, late_motion.T}),
      late_motion, truth,
      {Outcome::raised, Outcome::stalled,
       filled("$@1$ is less than the rounding of @2 turns leaves", {tolerances().settings.back(), turns})});
  late.add(Breakdown{
      R"(The printed factor $r\omega$ is $\omega^2$ times the right one, and right at $\omega=1$ alone.)",
      "closed form, factor r omega, as printed", 0, Outcome::inaccurate, "closed form, factor r / omega", 0});
  late.add(Breakdown{"@2 points are @1 a turn over @2 turns, too few to see the oscillation.",
                     "power, Gauss-Legendre",
                     points,
                     Outcome::inaccurate,
                     "power, Gauss-Legendre",
                     256,
                     {setting_of(Side::broken), points / turns, turns}});
  return late;
}

Quantity early_work(const Reference& truth) {
  const Motion m{1, 1, 1e-5};
  Known known = truth("02_17_work", {m.r, m.w, m.T});
  known.value = {known.value[1]};
  known.error = known.value[0] * 0x1p-52;
  Quantity q =
      quantity("early_work", "J", R"(work of $(t,t,1)$ until $T=10^{-5}$ s, $r=1$ m, $\omega=1$ rad/s)",
               known, {1e-10 * known.value[0], "ten digits"});
  q.add({"closed form", "factor r / omega", no_resolution(),
         [m](double) {
           return Answer{closed_form(Force::growing, m, m.r / m.w), 1};
         },
         Outcome::inaccurate, R"($(\omega T)^2/2$ is what is left of terms of size 1)"});
  q.add({"closed form", "x cos x - sin x by its series", no_resolution(), [m](double) {
           const double x = m.x(), half = sin(x / 2);  // the second term is 1e-16 of the whole
           return Answer{m.r / m.w * (x * sin(x) - 2 * half * half - x * x * x / 3), 1};
         }});
  q.add({"power", "Gauss-Legendre", doubling("points", 1, 4), [m](double n) {
           return answer(gauss_rule(n)([&](double t) { return power(Force::growing, m, t); }, 0, m.T));
         }});
  q.add(
      Breakdown{"In a short time $@1$ is left of $1-1$ and the closed form loses its digits; integrating "
                "the power, or collecting the terms before they cancel, loses none.",
                "closed form, factor r / omega",
                0,
                Outcome::inaccurate,
                "power, Gauss-Legendre",
                4,
                {m.x() * m.x() / 2}});
  return q;
}

Quantity maximum(const Motion& m, double turn, const Reference& truth) {
  const double start = 2 * pi * turn / m.w, T = (pi / 4 + 2 * pi * turn) / m.w;
  Known known = truth("02_17_work", {m.r, m.w, T});
  known.value.insert(known.value.begin(), T);
  known.error += T * 0x1p-52;
  Quantity q = quantity("maximum", "s, J, J", "time of the maximum, and both works then", known,
                        {1e-10 * (1 + T) * (1 + m.r), "ten digits"});
  const auto with_works = [m](const Solved<double>& time) {
    Answer a = answer(time);
    const Motion then = m.at(time.value);
    a.value = {time.value, closed_form(Force::constant, then, 0),
               closed_form(Force::growing, then, m.r / m.w)};
    a.error_estimate *= 1 + m.r * m.w;
    return a;
  };
  q.add({"closed form", "omega T = pi/4 + 2 pi n", no_resolution(), [=](double) {
           return with_works({T, 1});
         }});
  q.add({"closed form", "as printed, W = r omega x sqrt 2", no_resolution(),
         [=](double) {
           Answer a = with_works({T, 1});
           a.value[2] = m.r * m.w * (m.w * T) * sqrt(2.0);
           return a;
         },
         Outcome::inaccurate, R"(the $-1$ is dropped, and the factor is $r/\omega$)"});
  q.add(Breakdown{
      R"(The printed maximum of the growing force's work leaves out the $-1$ and has $r\omega$ for )"
      R"($r/\omega$: here it is @3 times the true one.)",
      "closed form, as printed, W = r omega x sqrt 2",
      0,
      Outcome::inaccurate,
      "closed form, omega T = pi/4 + 2 pi n",
      0,
      {[](const Quantity& of, const Trial& broken, const Trial&) {
        const Value& found = broken.answer.value;
        return (found.size() > 2 ? found[2] : std::nan("")) / of.reference.value[2];
      }}});
  const auto root = [=](Force force) {
    return [=](double e) {
      return with_works(brent([&](double t) { return power(force, m, t); }, start, start + pi / m.w, e));
    };
  };
  q.add({"power of (1, 1, 1) is zero", "Brent", tolerances(), root(Force::constant)});
  q.add({"power of (t, t, 1) is zero", "Brent", tolerances(), root(Force::growing),
         turn == 0 ? Outcome::deceived : Outcome::ok,
         "it is zero at $T=0$ too, and the bracket begins there"});
  q.add({"work is largest", "golden section", tolerances(),
         [=](double e) {
           const auto W = [&](double t) { return closed_form(Force::constant, m.at(t), 0); };
           return with_works(golden_section(W, start, start + pi / m.w, e));
         },
         Outcome::inaccurate, "a maximum is flat: $W$ resolves times only to the root of its rounding"});
  q.add(
      Breakdown{"Comparing values of $W$ finds the time of its maximum to @2 digits only, because $W$ is "
                "flat there; a zero of the power has all its digits.",
                "work is largest, golden section",
                1e-12,
                Outcome::inaccurate,
                "power of (1, 1, 1) is zero, Brent",
                1e-12,
                {digits_of(Side::broken)}});
  if (turn == 0)
    q.add(Breakdown{
        "For the growing force $T=0$ is stationary as well: a search from there ends where it began.",
        "power of (t, t, 1) is zero, Brent", 1e-12, Outcome::deceived, "power of (1, 1, 1) is zero, Brent",
        1e-12});
  return q;
}

}  // namespace oddity::work_on_circle
