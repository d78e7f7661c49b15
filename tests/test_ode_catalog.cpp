// The catalog compared with measurements: the stability of every fixed step on both axes, with theory and
// with one step of the library. Also the libraries' multistep methods as repaired here.

#include "solvers/ode/catalog.hpp"

#include <complex>

#include "report/verify/catch.hpp"
#include "solvers/ode/stability.hpp"
#include "tests/near.hpp"
#include "tests/ode_algorithms.hpp"

using namespace oddity::ode;
using namespace problems;

namespace {

using Complex = std::complex<double>;
const Complex real_axis{-1, 0}, imaginary_axis{0, 1};

const CatalogEntry& entry(std::string_view name) {
  return *std::ranges::find(catalog(), name, &CatalogEntry::name);
}

/// The first r at which growth(r) > 0, in steps of 1e-3 and then bisected; infinity beyond 40.
template <class Growth>
double limit(const Growth& growth) {
  const auto stable = [&](double r) { return growth(r) <= 1e-12; };
  double low = 0;
  while (stable(low + 1e-3))
    if ((low += 1e-3) > 40) return std::numeric_limits<double>::infinity();
  double high = low + 1e-3;
  for (int i = 0; i < 40; ++i) (stable((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

/// ln of the spectral radius of one plain step of a linear problem.
template <class Algorithm>
double plain_growth(const Problem& problem, double h) {
  const auto column = [&](State x) {
    typename Algorithm::template Plain<State>().do_step(problem.system, x, 0, h);
    return x;
  };
  const State a = column({1, 0}), b = column({0, 1});
  const double half_trace = (a[0] + b[1]) / 2, determinant = a[0] * b[1] - a[1] * b[0];
  const double discriminant = half_trace * half_trace - determinant;
  return discriminant < 0 ? std::log(determinant) / 2
                          : std::log(std::abs(half_trace) + std::sqrt(discriminant));
}

struct Limits {
  double real, imaginary;
};

template <class Algorithm>
Limits measured() {
  if constexpr (HasPlain<Algorithm>)
    return {limit([](double h) { return plain_growth<Algorithm>(decay, h); }),
            limit([](double h) { return plain_growth<Algorithm>(oscillator, h); })};
  else
    return {limit([](double r) { return growth(Algorithm::name, r * real_axis); }),
            limit([](double r) { return growth(Algorithm::name, r * imaginary_axis); })};
}

/// A growth that begins with the sixth power is noticed late: where the limit is 0 this is measured.
constexpr double as_good_as_none = 0.5;

/// The stability polynomial of a Runge-Kutta method: 1 + z + ... + z^order/order! and higher terms, from sum
/// b A^k 1 of its tableau in exact fractions. The fractions of DOP853 and Verner 9(8) are their decimals.
struct Polynomial {
  std::string_view name;
  int order;
  std::vector<double> beyond;
};
const Polynomial polynomials[] = {
    {"explicit Euler", 1, {}},
    {"modified midpoint", 2, {1.0 / 8}},
    {"Runge-Kutta 4", 4, {}},
    {"Cash-Karp 5(4)", 5, {1.0 / 800}},
    {"Dormand-Prince 5(4)", 5, {1.0 / 600}},
    {"Fehlberg 7(8)", 8, {491.0 / 209018880, 1333.0 / 5643509760, -13.0 / 501645312, -65.0 / 4514807808}},
    {"DOP853",
     8,
     {2.6916922001690856e-06, 2.341345108209780e-07, 1.4947364854591546e-08, 3.6133245781282443e-10}},
    {"Verner 9(8)",
     9,
     {2.8123513286039857e-07, 3.361161047774021e-08, -2.330578686585332e-10, -3.088243751740972e-09,
      2.4836903257690681e-10, 1.2379232040470214e-12}},
    {"GSL rk8pd",
     8,
     {2.7521279901047076e-06, 2.4231996586958736e-07, 2.4389718205443207e-08, -2.0346152896857728e-10}},
    {"ARKODE Zonneveld 4(3)", 4, {}},
    {"ARKODE Verner 6(5)", 6, {1.0 / 5400}},
};

double log_of(const Polynomial& p, Complex z) {
  Complex sum = 1, power = 1;
  double factorial = 1;
  for (int k = 1; k <= p.order; ++k) sum += (power *= z) / (factorial *= k);
  for (double c : p.beyond) sum += c * (power *= z);
  return std::log(std::abs(sum));
}

/// Equal to six decimals, or both infinite; a theory of 0 means no stability at all.
bool agree(double measured, double theory) {
  if (theory == 0) return measured < as_good_as_none;
  return measured == theory || std::abs(measured - theory) < 2e-6;
}

}  // namespace

TEST_CASE("every algorithm is in the catalog once, with its library", "[solvers]") {
  std::size_t count = 0;
  for_each_algorithm([&]<class Algorithm>() {
    ++count;
    CHECK(entry(Algorithm::name).kind == Algorithm::kind);
    CHECK_FALSE(entry(Algorithm::name).library.empty());
  });
  CHECK(catalog().size() == count);
  CHECK(not_in_catalog().empty() == has_sundials);
  if (has_sundials)
    for (std::string_view name : optional_algorithms)
      CHECK(std::ranges::count(catalog(), name, &CatalogEntry::name) == 1);
}

TEST_CASE("the limits of stability in the catalog are those measured", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    if constexpr (!has_tolerance(Algorithm::kind) || HasPlain<Algorithm>) {
      const CatalogEntry& stated = entry(Algorithm::name);
      if (std::isnan(stated.imaginary_limit)) return;
      const Limits limits = measured<Algorithm>();
      INFO(Algorithm::name << ": measured " << limits.real << ", " << limits.imaginary << "; theory "
                           << stated.real_limit << ", " << stated.imaginary_limit);
      CHECK((std::isnan(stated.real_limit) || agree(limits.real, stated.real_limit)));
      CHECK(agree(limits.imaginary, stated.imaginary_limit));
    }
  });
}

TEST_CASE("the limits of stability in the catalog are the roots of the stability polynomials", "[solvers]") {
  for (const Polynomial& p : polynomials) {
    if (!has_sundials && p.name.starts_with("ARKODE")) continue;
    const auto along = [&](Complex axis) { return limit([&](double r) { return log_of(p, r * axis); }); };
    INFO(p.name);
    CHECK(agree(along(real_axis), entry(p.name).real_limit));
    CHECK(agree(along(imaginary_axis), entry(p.name).imaginary_limit));
  }
}

TEST_CASE("a step of each Runge-Kutta method agrees with its stability polynomial", "[solvers]") {
  for (const char* name : {"explicit Euler", "modified midpoint", "Runge-Kutta 4"})
    for (Complex z : {Complex(-0.5, 0), Complex(0, 1), Complex(0.3, 0.7), Complex(-2, 1.5)}) {
      const auto p = std::ranges::find(polynomials, name, &Polynomial::name);
      INFO(name << " at " << z);
      CHECK(near(growth(name, z), log_of(*p, z), 1e-14));
    }
}

TEST_CASE("the stability polynomials agree with the tableaus that the program has", "[solvers]") {
  const auto check = []<class Algorithm>() {
    using Tableau = typename Algorithm::Tableau;
    const Polynomial& p = *std::ranges::find(polynomials, Algorithm::name, &Polynomial::name);
    constexpr std::size_t stages = std::size(Tableau::a);
    std::array<long double, stages> power;  // A^k 1
    power.fill(1);
    long double inverse_factorial = 1;
    for (std::size_t k = 1; k <= stages; ++k) {
      long double coefficient = 0, absolute = 0;
      for (std::size_t i = 0; i < stages; ++i) {
        coefficient += Tableau::b[i] * power[i];
        absolute += std::abs(Tableau::b[i] * power[i]);
      }
      inverse_factorial /= static_cast<long double>(k);
      const std::size_t beyond = k - static_cast<std::size_t>(p.order) - 1;
      const long double listed = k <= static_cast<std::size_t>(p.order) ? inverse_factorial
                                 : beyond < p.beyond.size()             ? p.beyond[beyond]
                                                                        : 0;
      INFO(Algorithm::name << ", z^" << k);
      CHECK(near(static_cast<double>(coefficient), static_cast<double>(listed),
                 1e-14 * static_cast<double>(absolute)));
      for (std::size_t i = stages; i-- > 0;) {
        long double sum = 0;
        for (std::size_t j = 0; j < i; ++j) sum += Tableau::a[i][j] * power[j];
        power[i] = sum;
      }
    }
  };
  check.operator()<DormandPrince853>();
  check.operator()<Verner98>();
}

TEST_CASE("where the imaginary axis is unstable, growth begins with a high power", "[solvers]") {
  const auto power = [](std::string_view name, double r) {
    const auto p = std::ranges::find(polynomials, name, &Polynomial::name);
    return std::log2(log_of(*p, {0, 2 * r}) / log_of(*p, {0, r}));
  };
  CHECK(near(power("explicit Euler", 0.01), 2, 0.01));
  CHECK(near(power("modified midpoint", 0.05), 6, 0.1));
  CHECK(near(power("Cash-Karp 5(4)", 0.1), 6, 0.1));
  CHECK(near(power("GSL rk8pd", 0.25), 10, 0.4));
}

TEST_CASE("half the trace of McLachlan's step reaches -1 at the limit in the catalog", "[solvers]") {
  // Five drifts a h and four kicks b h of q'' = -q.
  const double z = std::sqrt(7.0 / 8) / 3;
  const double a[] = {0.5 - z, -1.0 / 3 + z, 2.0 / 3, -1.0 / 3 + z, 0.5 - z}, b[] = {1, -0.5, -0.5, 1};
  const auto half_trace = [&](double h) {
    double sum = 0;
    for (int column : {0, 1}) {
      double q = column == 0, v = column == 1;
      for (int i = 0; i < 5; ++i) {
        q += a[i] * h * v;
        if (i < 4) v -= b[i] * h * q;
      }
      sum += column == 0 ? q : v;
    }
    return sum / 2;
  };
  const double at = entry("McLachlan 4").imaginary_limit;
  CHECK(std::abs(half_trace(at - 1e-5)) < 1);
  CHECK(std::abs(half_trace(at + 1e-5)) > 1);
}

TEST_CASE("over many steps a multistep method grows like its largest root", "[solvers]") {
  // y' = lambda y in one equation: lambda is real, and the largest root is alone.
  const auto grown = []<class Algorithm>(double z) {
    const auto system = [z](const auto& x, auto& dxdt, double) { dxdt[0] = z * x[0]; };
    const auto after = [&](int n) {
      std::vector<double> times;
      for (int i = 0; i <= n; ++i) times.push_back(i);
      return std::abs(
          integrate<Algorithm>(system, std::array{1.0}, std::span<const double>(times), 1).value.back()[0]);
    };
    return std::log(after(400) / after(200)) / 200;
  };
  for (double z : {-0.1, -0.29, -0.31, -0.4, 0.1}) {
    INFO("z = " << z);
    CHECK(near(grown.operator()<AdamsBashforth4>(z), growth("Adams-Bashforth 4", z), 1e-6));
  }
  for (double z : {-0.1, -0.2, 0.1}) {
    INFO("z = " << z);
    CHECK(near(grown.operator()<AdamsBashforthMoulton6>(z), growth("Adams-Bashforth-Moulton 6", z), 1e-6));
  }
}

TEST_CASE("Adams-Bashforth 4 is stable up to 0.3 on the real axis", "[solvers]") {
  CHECK(near(measured<AdamsBashforth4>().real, 0.3, 1e-9));
}

TEST_CASE(
    "linearly implicit Euler is stable on the left half-plane, and damps fast modes and some growing ones",
    "[solvers]") {
  for (double r : {1e-3, 0.1, 1.0, 10.0, 1e3, 1e6})
    for (double angle : {90.0, 100.0, 135.0, 180.0}) {
      const Complex z = std::polar(r, angle * std::acos(-1) / 180);
      INFO("z = " << z);
      CHECK(growth("linearly implicit Euler", z) < 1e-16);
      CHECK(near(growth("linearly implicit Euler", z), -std::log(std::abs(1.0 - z)), 1e-9));
    }
  CHECK(growth("linearly implicit Euler", -1e6) < std::log(2e-6));
  CHECK(growth("linearly implicit Euler", {1, 0.9}) > 0);  // inside of |1 - z| = 1
  CHECK(growth("linearly implicit Euler", {1, 1.1}) < 0);  // outside
}

// ---- repairs of the libraries
// ------------------------------------------------------------------------------

namespace {

/// The order measured by halving 32 steps of the oscillator.
template <int steps>
double order_of_adams() {
  const auto error = [](int n) {
    auto stepper = detail::AdamsBashforthMoulton<steps>::template stepper<State>();
    State x = oscillator.exact(0);
    double worst = 0;
    for (int i = 0; i < n; ++i) {
      stepper.do_step(oscillator.system, x, i * 5.0 / n, 5.0 / n);
      worst = std::max(worst, distance(x, oscillator.exact((i + 1) * 5.0 / n)));
    }
    return worst;
  };
  return std::log2(error(32) / error(64));
}

}  // namespace

TEST_CASE("started by Fehlberg 7(8), Adams-Bashforth-Moulton has its nominal order", "[solvers]") {
  CHECK(near(order_of_adams<6>(), 6, 0.2));
  CHECK(near(order_of_adams<8>(), 8, 0.6));
}

TEST_CASE("a multistep method restarts when its step changes", "[solvers]") {
  // Ten steps of 0.1 and ten of 0.05: with the old history the change costs digits.
  const auto restarted = [&](auto stepper, bool anew) {
    State x = oscillator.exact(0);
    double t = 0;
    for (int i = 0; i < 20; ++i) {
      const double h = i < 10 ? 0.1 : 0.05;
      if (anew)
        stepper.do_step(oscillator.system, x, t, h);
      else
        stepper.multistep.do_step(oscillator.system, x, t, h);
      t += h;
    }
    return distance(x, oscillator.exact(1.5));
  };
  CHECK(restarted(AdamsBashforthMoulton6::stepper<State>(), true) < 1e-8);
  CHECK(restarted(AdamsBashforthMoulton6::stepper<State>(), false) > 1e-5);
  CHECK(restarted(AdamsBashforth4::stepper<State>(), true) < 5e-5);
  CHECK(restarted(AdamsBashforth4::stepper<State>(), false) > 1e-4);
}
