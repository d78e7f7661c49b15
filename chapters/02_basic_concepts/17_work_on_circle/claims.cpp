// The claims of exercise 2.17, at random r and w of either sign or away from 1, so that a wrong power of w is
// detected. The text's formulas are checked by quadrature of F . v and dual numbers, which use the path
// alone. Its maxima and minima are checked by a scan of the power, or by comparing works.

#include "chapters/02_basic_concepts/17_work_on_circle/work_on_circle.hpp"
#include "chapters/02_basic_concepts/shared/recorded_functions.hpp"
#include "chapters/integral_proofs.hpp"
#include "chapters/provable_claims.hpp"
#include "solvers/roots.hpp"

namespace oddity::work_on_circle {

/// A motion, another time t, and the index of one of its times.
template <class G>
struct SampleOf : MotionOf<G> {
  G t = {};
  int k = 0;
  Letters<G> table() { return {{"r", this->r}, {R"(\omega)", this->w, {}, "w"}, {"T", this->T}, {"t", t}}; }
  std::string where() const { return listed(typeset_of(*this), 3); }
  double size() const { return abs(this->r) * (10 + abs(this->x())); }  // the work of a turn
  TypesetIn<G> typeset() const {
    return {{R"(\dot t)", 1.0}, {"h", std::pow(2.0, -k)}, {"x", this->x()}, {"n", static_cast<double>(k)}};
  }
};

namespace {

using std::hypot, std::numbers::sqrt2;
using M = const Motion&;
using Sample = SampleOf<double>;
using S = const Sample&;
using Form = ProvableFormula<SampleOf>;
using Table = ProvableClaims<SampleOf>;

/// A sample at a maximum of the growing force's work.
struct AtMaximum : Sample {
  double size() const { return Sample::size() / w; }
};

/// Motions with x = omega T up to 12. `any` have r and omega of either sign. `forward` have both positive and
/// omega away from 1; `cases` are these with k = 0, ..., 11. `maxima` are at x = pi/4 + 2 n pi, n = 0,
/// ..., 3.
struct Samples {
  std::vector<Sample> any, forward, cases;
  std::vector<AtMaximum> maxima;

  Samples() = default;
  explicit Samples(double seed) {
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
      const double r = random.magnitude(0.2, 5), w = random.magnitude(0.2, 5), x = random.between(-12, 12);
      any.push_back({{r, w, x / w}, x / w + 1});
      const double away = random.unit() < 0.5 ? random.between(0.2, 0.8) : random.between(1.25, 4);
      const double T = abs(x) / away;
      forward.push_back({{abs(r), away, T}, T + 1});
      for (int k = 0; k < 12; ++k) cases.push_back({{forward.back()}, T + 1, k});
      for (int n = 0; n < 4; ++n) maxima.push_back({{{abs(r), away, (pi / 4 + 2 * n * pi) / away}, 0, n}});
    }
  }
};

// ---- works by quadrature ----------------------------------------------------------------------------------

template <class G, class F>
G integral(const F& f, const std::type_identity_t<G>& start, const G& end) {
  if constexpr (std::same_as<G, Shortened>)
    return recorded_integral(f, start, end);
  else
    return gauss_legendre(f, start, end, 64).value;
}

/// The work from `start` to T.
template <class G>
G work_of(Force force, const MotionOf<G>& m, const std::type_identity_t<G>& start = 0) {
  return integral([&](const G& t) { return power(force, m, t); }, start, m.T);
}
/// Size of the terms that cancel in the work if T is small.
double of_work(const Sample& m) { return abs(m.r); }
double of_growing_work(const Sample& m) { return abs(m.r) * (abs(m.T) + 1 / abs(m.w)); }

/// x + y on the path.
template <class G>
G height(const MotionOf<G>& m, const std::type_identity_t<G>& t) {
  return m.position(t)[0] + m.position(t)[1];
}

const Form gain{"gain of $x+y$ along the path", [](const auto& m) { return height(m, m.T) - height(m, 0); },
                of_work};
const Form gain_t{"$T$ times the end's $x+y$, less its integral over time",
                  []<class G>(const SampleOf<G>& m) {
                    return m.T * height(m, m.T) - integral([&](const G& t) { return height(m, t); }, 0, m.T);
                  },
                  of_growing_work};
const Form power_1{R"($(1,1,1)\cdot v$ by dual numbers)",
                   [](const auto& m) { return power(Force::constant, m, m.t); }};
const Form power_t{R"($(t,t,1)\cdot v$ by dual numbers)",
                   [](const auto& m) { return power(Force::growing, m, m.t); }};
const Form work_1{R"(quadrature of $F\cdot v$)", [](const auto& m) { return work_of(Force::constant, m); },
                  of_work};
const Form work_t{R"(quadrature of $F\cdot v$)", [](const auto& m) { return work_of(Force::growing, m); },
                  of_growing_work};
const Form zero{"zero", [](const auto&) { return 0.0; }};

/// dW/dT, through W = int_0^1 T P(T u) du.
Form slope(Force force) {
  return {"$dW/dT$ of the quadrature", [=]<class G>(const SampleOf<G>& m) {
            const auto rate = [&](const G& u) {
              return derivative([&](const auto& T) { return T * power(force, m, T * u); }, m.T);
            };
            return integral(rate, 0, G(1.0));
          }};
}

// ---- formulas ---------------------------------------------------------------------------------------------

void formulas(Table& table, const Samples& samples) {
  const auto claim = table.over(samples.any);
  const auto line = [&](std::string_view slug, int number, const Form& truth, const std::string& printed,
                        const std::string& says = {}) {
    claim(slug, number, says.empty() ? printed : says, truth, printed);
  };
  line("velocity", 805,
       {R"($\frac{d}{dt}(r\cos\omega t,\,r\sin\omega t,\,0)$ by dual numbers)",
        [](const auto& m) { return m.velocity(m.t); }},
       R"($v=(-r\omega\sin\omega t,\,r\omega\cos\omega t,\,0)$)");
  line("work_integral", 809, gain,
       R"($W=\int_0^T(1,1,1)\cdot(-r\omega\sin\omega t,\,r\omega\cos\omega t,\,0)\,dt$)");
  claim.equation("power", 813, R"($(1,1,1)\cdot v=r\omega(\cos\omega t-\sin\omega t)$)", power_1);
  line("antiderivative", 815, power_1, R"($\frac{d}{dt}(r(\cos\omega t+\sin\omega t))$)",
       R"($r(\cos\omega t+\sin\omega t)$ has the derivative $F\cdot v$)");
  line("work", 815, work_1, R"($W(T)=r(\cos\omega T+\sin\omega T-1)$)");
  line("growing_integral", 831, gain_t,
       R"($W=\int_0^T(t,t,1)\cdot(-r\omega\sin\omega t,\,r\omega\cos\omega t,\,0)\,dt$)");
  claim.equation("growing_power", 835, R"($(t,t,1)\cdot v=r\omega t(\cos\omega t-\sin\omega t)$)", power_t);
  const std::string parts = R"($W=Tr(\cos\omega T+\sin\omega T)-\int_0^Tr(\cos\omega t+\sin\omega t)\,dt$)";
  line("by_parts", 839, work_t, parts, "The integration may be performed by parts (our formula): " + parts);
  line("growing_derivative", 841, slope(Force::growing), R"($r\omega T(\cos\omega T-\sin\omega T)$)",
       R"($W'(T)=r\omega T(\cos\omega T-\sin\omega T)$ for $(t,t,1)$)");
  claim.equation(
      "magnitude", 849, R"($|(t,t,1)|=\sqrt{2t^2+1}$)",
      {"length of $(t,t,1)$", []<class G>(const SampleOf<G>& m) { return hypot(m.t, m.t, G(1.0)); }});
}

const std::string of_zero = "a multiple of zero is zero";

/// A relation of the work of (1, 1, 1) or (t, t, 1).
std::string work(const std::string& from, const std::string& to, const std::string& force,
                 const std::string& relation = "=0") {
  return R"($\int_)" + from + "^" + to + "(" + force + "," + force +
         R"(,1)\cdot(-r\omega\sin\omega t,\,r\omega\cos\omega t,\,0)\,dt)" + relation + "$";
}

void misprints(Table& table, const Samples& samples) {
  const auto claim = table.over(samples.any);
  const auto turns = table.over(samples.forward);
  claim(
      "derivative", 821, R"(For $(1,1,1)$ $W'(T)=r\omega(-\sin\omega T+\cos\omega t)$.)",
      {.truth = slope(Force::constant),
       .printed = R"($r\omega(-\sin\omega T+\cos\omega t)$)",
       .meant = R"($r\omega(-\sin\omega T+\cos\omega T)$)",
       .kind = Fault::formula,
       .why = "The cosine keeps the variable of integration $t$; both times are $T$, as the next line takes "
              "them. (The check puts $t=T+1$.)"});
  claim("growing_work", 837,
        R"(For $(t,t,1)$ $W(T)=r\omega\,(-1+\cos\omega T-\sin\omega T)+T\omega(\cos\omega )"
        R"(T+\sin\omega T))$ (our reading: the last parenthesis closes one that is lost after )"
        R"($r\omega$).)",
        {.truth = work_t,
         .printed =
             R"($r\omega\bigl((-1+\cos\omega T-\sin\omega T)+\omega T(\cos\omega T+\sin\omega T)\bigr)$)",
         .meant = R"($\frac r\omega\bigl((-1+\cos\omega T-\sin\omega T))"
                  R"(+\omega T(\cos\omega T+\sin\omega T)\bigr)$)",
         .why =
             R"(A fraction bar and a parenthesis are lost: the factor $r/\omega$ precedes the whole. It and )"
             R"($r\omega$ agree at $\omega=1$ alone.)"});
  turns(
      "full_turn", 817, R"(After one turn, at $T=2\pi\omega$, the work is zero: $W(2\pi\omega)=0$.)",
      {.quantity = "work of $(1,1,1)$",
       .truth = zero,
       .printed = work("0", R"({2\pi\omega})", "1"),
       .meant = work("0", R"({2\pi/\omega})", "1"),
       .changes_that_hold = of_zero,
       .why = filled(
           R"(The fraction bar is lost: a turn takes $2\pi/\omega$. At $2\pi\omega$ the work is zero by chance )"
           R"(only, as for $\omega=1$; for $\omega=1/\sqrt2$ it is $@1r$.)",
           {work_of(Force::constant, Motion{1, 1 / sqrt2, sqrt2 * pi})})});
}

// ---- conservation -----------------------------------------------------------------------------------------

/// The work of a field of positions from the path's start to its end; `detour` adds a loop off the circle.
template <class Field>
Form along(const std::string& text, double detour, const Field& field) {
  const auto rate = [=](M m, double u) {
    const auto curve = [&](const auto& v) {
      auto at = m.position(m.T * v);
      const auto loop = detour * sin(2 * pi * v);
      return std::array{at[0] + loop, at[1] - 2.0 * loop * v, at[2] + m.w * loop};
    };
    const auto moved = curve(Dual<double>(u, 1));
    return dot(field(curve(u)), std::array{moved[0].slope, moved[1].slope, moved[2].slope});
  };
  return {text, [=](M m) { return integral([&](double u) { return rate(m, u); }, 0, 1.0); },
          [=](const Sample& m) { return of_work(m) + 20 * detour * (1 + abs(m.w)); }};
}

/// The field (1, 1, 1).
constexpr auto ones = []<class T>(const std::array<T, 3>&) { return std::array<T, 3>{1.0, 1.0, 1.0}; };

void conservation(Claims& claims, Table& table, const Samples& samples) {
  const auto swirl = [](const Vector& at) { return Vector{1 - at[1], 1 + at[0], 1}; };
  const auto both_ways = [&](const std::string& of, const std::string& in, const auto& field) {
    return Reading{"along a detour" + in,
                   {compare("work" + of + " between the same ends", along("along a detour" + in, 1, field),
                            along("along the circle", 0, field), samples.any)}};
  };
  claims.add("conservative", 817, "The field $(1,1,1)$ is conservative.",
             {.printed = both_ways("", "", ones),
              .near_misses = {both_ways(" of $(1-y,1+x,1)$", ", in the field $(1-y,1+x,1)$", swirl)}});
  table.over(samples.forward)("round_trip", 817,
                              "Once around the circle, back to where it started, the net work is zero.",
                              {.quantity = "work of a turn from a random start",
                               .truth = zero,
                               .printed = work("T", R"({T+2\pi/\omega})", "1"),
                               .near_misses = {work("T", R"({T+2\pi/\omega})", "t")},
                               .changes_that_hold = of_zero});
}

// ---- maxima and minima ------------------------------------------------------------------------------------

/// Whether W is larger at T than shortly before and after; with `sign` -1, smaller.
bool is_peak(Force force, M m, double T, int sign = 1) {
  const double h = 0.01 / m.w;
  return sign * work_of(force, m.at(T), T - h) > 0 && sign * work_of(force, m.at(T + h), T) < 0;
}
double stationary(M m, int k) { return (pi / 4 + k * pi) / m.w; }

/// All zeros of the power with |x| < 12.5.
std::vector<double> zeros(Force force, M m) {
  std::vector<double> found;
  for (double x = -12.45; x < 12.5; x += 0.1)
    if (const auto root =
            brent([&](double t) { return power(force, m, t); }, x / m.w, (x + 0.1) / m.w, 1e-15);
        root.reached())
      found.push_back(m.w * root.value);
  return found;
}
const std::string by_scan = "Brent's method over a scan";
Form list(const std::string& text, const std::vector<double>& numbers) {
  return {text, [=](M) { return Value(numbers); }};
}
std::vector<double> spaced(double first, double step) {
  std::vector<double> all;
  for (double x = first - 4 * pi; x < 12.5; x += step) all.push_back(x);
  return all;
}
std::vector<double> and_zero(std::vector<double> all) {
  all.insert(std::ranges::lower_bound(all, 0.0), 0.0);
  return all;
}
/// The first three above x, so that lists of different lengths can be compared.
std::vector<double> three_above(double x, const std::vector<double>& all) {
  const auto first = std::ranges::upper_bound(all, x);
  return {first, first + 3};
}

void zeros_of_the_power(Claims& claims, const Samples& samples) {
  const double first = pi / 4;
  const std::string at = R"(at $\pi/4+k\pi$)";
  const auto roots = [&](Force force, const Form& form) {
    const Form found{by_scan, [=](M m) { return Value(zeros(force, m)); }};
    return Reading{form.text, {compare(R"(all zeros of $W'$, as $\omega T$)", form, found, samples.forward)}};
  };
  const Form tangents{R"($\tan\omega T$ at the zeros)",
                      [](M m) {
                        std::vector<double> all = zeros(Force::constant, m);
                        for (double& x : all) x = std::tan(x);
                        return all;
                      },
                      [](const Sample&) { return 2 * 12.5; }};
  Reading printed = roots(Force::constant, list(at, spaced(first, pi)));
  printed.checks.push_back(compare(R"($\tan\omega T$ at the zeros)", list("1", std::vector<double>(8, 1)),
                                   tangents, samples.forward));
  claims.add("zeros", 823, R"($W'=0$ where $\tan\omega T=1$: at $\omega T=\pi/4+k\pi$, $k$ any integer)",
             {.printed = printed,
              .near_misses = {roots(Force::constant, list(R"(at $\pi/4+2k\pi$)", spaced(first, 2 * pi))),
                              roots(Force::constant, list(R"(at $3\pi/4+k\pi$)", spaced(3 * first, pi)))}});
  const auto three = [&](const std::string& which, double x) {
    const Form found{by_scan, [=](M m) { return Value(three_above(x, zeros(Force::growing, m))); }};
    return compare("the first three zeros of $W'$ " + which, list(at, three_above(x, spaced(first, pi))),
                   found, samples.forward);
  };
  claims.add(
      "growing_zeros", 843, R"(For $(t,t,1)$ $W'$ is zero when $\omega T=\pi/4+k\pi$, $k$ any integer.)",
      {.printed = {at, {three(R"(from $\omega T=-3$ on)", -3)}},
       .corrected = roots(Force::growing, list(at + ", and 0", and_zero(spaced(first, pi)))),
       .in_view = {"for $T>0$, once the work has begun", {three(R"(with $\omega T>0$)", 0.1)}},
       .near_misses = {roots(Force::growing,
                             list(R"(at $3\pi/4+k\pi$, and 0)", and_zero(spaced(3 * first, pi))))},
       .why =
           R"($W'=r\omega T(\cos\omega T-\sin\omega T)$ has the factor $T$: it is zero at $T=0$ as well, a )"
           R"(minimum, $W\approx r\omega T^2/2$, and no $\pi/4+k\pi$.)",
       .root = "the start is stationary too"});
}

void extrema(Claims& claims, const Samples& samples) {
  const auto constant = Force::constant;
  // At the stationary times `first` + `step` k; the last two are 1 for maxima, -1 for minima.
  const auto peaks = [](const std::string& text, Force force, int first, int step, int even, int odd) {
    return Statement<Sample>{
        text,
        [=](S m) { return is_peak(force, m, stationary(m, first + step * m.k), m.k % 2 == 0 ? even : odd); }};
  };
  claims.statement<Sample>(
      "maximum_where_stationary", 819, "The net work is a maximum when $W'=0$.", samples.cases,
      {.printed = peaks("where $W'=0$ there is a maximum", constant, 0, 1, 1, 1),
       .meant = {"where there is a maximum $W'=0$",
                 [](S m) {
                   const auto holds_at = [&](double T) {
                     return abs(power(constant, m, T)) <= 0.1 * m.r * m.w || !is_peak(constant, m, T);
                   };
                   return holds_at(m.T + 0.5 * m.k / m.w) && holds_at(stationary(m, m.k));
                 }},
       .near_misses = {peaks("where $W'=0$ there is a minimum", constant, 0, 1, -1, -1)},
       .kind = Fault::counterexample,
       .why = filled(R"(Every other such time, $\omega T=5\pi/4,13\pi/4,\ldots$, is a minimum, )"
                     R"($W=-r(\sqrt2+1)=@3\,r$. Two sentences later half of these times are minima.)",
                     {work_of(constant, Motion{1, 1, 5 * pi / 4})})});
  claims.statement<Sample>(
      "halves", 823, "Half of these times lead to a minimum, the other half to a maximum.", samples.cases,
      {.printed = peaks("even $k$: maximum, odd $k$: minimum", constant, -6, 1, 1, -1),
       .near_misses = {peaks("odd $k$: maximum, even $k$: minimum", constant, -6, 1, -1, 1)}});
  const std::string highest = R"($W(\pi/(4\omega))$)";
  const Formula<Sample> printed{R"($r(\sqrt2-1)$)"},
      truth{R"(quadrature of $F\cdot v$)", [](M m) { return work_of(constant, m.at(stationary(m, 0))); }};
  claims.add("first_maximum", 825, R"(At $T=\pi/(4\omega)$ $W$ has its maximum, $r(\sqrt2-1)$.)",
             {.printed = {printed.text,
                          {compare(highest, computed(printed), truth, samples.forward),
                           in_all<Sample>("$W$ is nowhere larger", samples.cases,
                                          [](S m) {
                                            return work_of(constant, m.at(m.T + m.k / m.w)) <=
                                                   m.r * (sqrt2 - 1 + 1e-12);
                                          })},
                          true},
              .near_misses = single_changes(highest, printed, truth, samples.forward, "")});
  claims.statement<Sample>(
      "local_maxima", 843,
      R"(Where $k$ is even you have local maxima ($k\ge0$ is our condition, for the interval $[0,T]$ of the text).)",
      samples.cases,
      {.printed = peaks("even $k$: maximum", Force::growing, 0, 2, 1, 1),
       .near_misses = {peaks("odd $k$: maximum", Force::growing, 1, 2, 1, 1)}});
}

void values_at_maxima(Claims& claims, const Samples& samples) {
  claims.over(samples.maxima)(
      "maxima_value", 845,
      R"(At its maxima the work of $(t,t,1)$ is $W(\pi/4+2n\pi)=r\omega(\pi/4+2n\pi)\sqrt2$.)",
      {.quantity = R"($W$ at $x=\pi/4+2n\pi$ less its value)",
       .truth = {"zero", [](M) { return 0.0; }},
       .printed = {work("0", "x", "t", R"(=r\omega x\sqrt2)")},
       .meant = {work("0", R"({x/\omega})", "t", R"(=\frac r\omega x\sqrt2)")},
       .corrected = {work("0", R"({x/\omega})", "t", R"(=\frac r\omega(x\sqrt2-1))")},
       .kind = Fault::formula,
       .root = "a term dropped at the maxima",
       .why = R"(The $-1$ of the closed form is dropped: with $x=\pi/4+2n\pi$ the work is )"
              R"($\frac r\omega(\sqrt2\,x-1)$ at $T=x/\omega$. Besides, the argument should be a time, )"
              R"($x/\omega$, and the factor is $r/\omega$.)"});
}

void growth(Claims& claims, const Samples& samples) {
  // The growth of W to the next n.
  const auto to_next = [](const std::string& first, const std::string& relation) {
    return work("{(" + first + R"(+2n\pi)/\omega})", "{(" + first + R"(+2(n+1)\pi)/\omega})", "t", relation);
  };
  const std::string maxima_grow = to_next(R"(\pi/4)", ">0"), minima_grow = to_next(R"(5\pi/4)", ">0"),
                    minima_sink = to_next(R"(5\pi/4)", "<0");
  const auto later_by = [](double w) {  // for r = 1
    return work_of(Force::growing, Motion{1, w, pi / 4 + 2 * pi}, pi / 4);
  };
  claims.statement<AtMaximum>(
      "maxima_grow", 849, R"(As $n$ grows, so does the net work $W(\pi/4+2n\pi)$.)", samples.maxima,
      {.printed = {work(R"({\pi/4+2n\pi})", R"({\pi/4+2(n+1)\pi})", "t", ">0")},
       .meant = {maxima_grow},
       .near_misses = {{minima_grow}},
       .why =
           filled(R"(The maxima are at $\omega T=\pi/4+2n\pi$, where $W$ grows by $2\sqrt2\,\pi r/\omega$ )"
                  R"(each time. At $T=\pi/4+2n\pi$, as printed, it depends on $\omega$: for $\omega=2$ each )"
                  R"($W$ is $@3r$ more than the last, for $\omega=4$ it is $@3r$ less.)",
                  {later_by(2), -later_by(4)})});
  claims.statement<Sample>(
      "magnitude_grows", 851, "The force's magnitude always grows with time ($t>0$, as on $[0,T]$).",
      samples.cases,
      {.printed = {"$|(t+h,t+h,1)|>|(t,t,1)|$"}, .near_misses = {{"$|(t+h,t+h,1)|<|(t,t,1)|$"}}});
  const Check always = in_all<Sample>("$W$ grows all the time", samples.cases, [](S m) {
    const double start = m.T + 0.5 * m.k / m.w;
    return work_of(Force::growing, m.at(start + 0.1 / m.w), start) > 0;
  });
  const auto at_each = [&](const std::string& text) {
    return in_all(text, samples.maxima, computed(Statement<AtMaximum>{text}).holds);
  };
  claims.add(
      "work_keeps_growing", 851,
      "The force gets stronger, so the net work keeps growing: its maxima, of which the paragraph "
      "speaks (between them it falls, and deeper every time).",
      {.printed = {maxima_grow, {at_each(maxima_grow), at_each(minima_sink)}, true},
       .near_misses = {{minima_grow, {at_each(minima_grow)}, true}, {"$W$ grows all the time", {always}}}});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const Samples samples(seed);
  Claims claims("2.17");
  Table table(claims);
  formulas(table, samples);
  misprints(table, samples);
  conservation(claims, table, samples);
  for (auto* section : {zeros_of_the_power, extrema, values_at_maxima, growth}) section(claims, samples);
  return claims.in_order();
}

/// For (1, 1, 1): the zeros of its power, the maximum of its work, and its potential.
Provables about_extrema(const ForAll<SampleOf>& all) {
  const auto& any = all.any;
  const auto coq = [](const Shortened& x) { return x.expression().coq(); };
  const Shortened first = work_of(Force::constant, any.at(pi_of<Shortened>() / 4 / any.w)),
                  highest = any.r * (sqrt(Shortened(2.0)) - 1);
  const auto letter = Shortened::letter;
  const std::array<Shortened, 3> at{letter("(x t)"), letter("(y t)"), letter("(z t)")},
      rate{letter("(u t)"), letter("(v t)"), letter("(w t)")};
  const std::string of_power = coq(power(Force::constant, any, any.T)), of_path = coq(dot(ones(at), rate));
  const std::vector<Proposition>
      forward = positive({any.r, any.w}),
      moving{not_zero(any.r.expression()), not_zero(any.w.expression())},
      path{{"(forall t, is_derive x t (u t) /\\ is_derive y t (v t) /\\ is_derive z t (w t))"},
           {"(forall t, continuous u t /\\ continuous v t /\\ continuous w t)"}},
      alike{{"(" + of_power + " = 0 <-> exists k : Z, w * T = PI / 4 + IZR k * PI)"}},
      is_highest{first.expression() == highest.expression()},
      nowhere_larger{{coq(work_of(Force::constant, any)) + " <= " + coq(highest)}},
      difference{{"RInt (fun t => " + of_path + ") a b = x b + y b + z b - (x a + y a + z a)"}};
  return {{"2.17-zeros",
           "for any radius and speed the power is zero there, and nowhere else",
           {{"printed", all.letters, moving, alike, "zeros r w T"}}},
          {"2.17-first_maximum",
           "for any radius and speed the work has this value at that time, and no larger one at any other",
           {{"value", all.letters, forward, is_highest, "highest r w"},
            {"nowhere_larger", all.letters, forward, nowhere_larger, "nowhere_larger r w T"}}},
          {"2.17-conservative",
           "the work along any path is the difference of x + y + z at its ends",
           {{"printed", "(x y z u v w : R -> R) (a b : R)", path, difference, "of_potential x y z H H0"}}}};
}

Provables proofs() {
  const Samples none;
  Claims claims("2.17");
  Table table(claims);
  formulas(table, none);
  misprints(table, none);
  conservation(claims, table, none);
  auto all = for_all<SampleOf>("by_antiderivatives r w T",
                               "it holds for every radius and speed, at every time", {0.5, 0.75, 2, 3});
  all.given = {not_zero(all.any.w.expression())};
  Provables proved = table.proofs("2.17", all);
  for (Provable& claim : proved)
    for (Lemma& lemma : claim.lemmas)
      if (lemma.tactic == "interval") lemma.tactic = "integral";
  append(proved, about_extrema(all));
  for (Provable& claim : proved) claim.preamble = coq_source({"extrema"});
  return proved;
}

std::vector<Root> roots() {
  const double most = work_of(Force::growing, Motion{1, 1, pi / 4}), printed = pi / 4 * sqrt2;
  return {
      {"the start is stationary too",
       filled(R"(A search for the first maximum that starts at $T=0$ ends there, with no work for @4 )"
              R"(($r=\omega=1$).)",
              {most})},
      {"a term dropped at the maxima",
       filled(R"(With $r=\omega=1$ the first maximum is @4 and the printed formula gives @5: @2 times the )"
              R"(work that the force does.)",
              {most, printed, printed / most})}};
}

}  // namespace oddity::work_on_circle
