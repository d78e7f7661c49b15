// The recorded tape and its series: the recorded operations, the coefficients compared with known series, the
// counted work, and the motion by steps of chosen order and length.

#include "solvers/taylor/motion.hpp"

#include <numbers>

#include "report/verify/catch.hpp"
#include "solvers/counted.hpp"
#include "solvers/ode/all.hpp"
#include "solvers/ode/events.hpp"
#include "tests/near.hpp"
#include "tests/ode_problems.hpp"

using namespace oddity;
using namespace oddity::taylor;

namespace {

/// The coefficients of x in the initial value problem x' = rhs(x, t), x(t0) = x0, with one unknown.
template <class Rhs>
std::vector<double> series_of(const Rhs& rhs, double x0, double t0, int order) {
  Series series{Program(record<1>([&](const auto& x, auto& dxdt, const auto& t) { dxdt = {rhs(x[0], t)}; }))};
  series.expand(&x0, t0, order);
  std::vector<double> all;
  for (int k = 0; k <= order; ++k) all.push_back(series.coefficient(0, k));
  return all;
}

/// The state after steps of one order and one length.
problems::State after_steps(const problems::Problem& problem, double from, double to, int steps, int order) {
  Series series{Program(record<2>(problem.system))};
  problems::State x = problem.exact(from);
  const double h = (to - from) / steps;
  for (int i = 0; i < steps; ++i) {
    series.expand(x.data(), from + i * h, order);
    series.at(h, x.data());
  }
  return x;
}

double order_measured(const problems::Problem& problem, double from, double to, int order) {
  const double span = std::abs(to - from);
  const int steps = static_cast<int>(span * (order <= 2 ? 200 : order <= 4 ? 50 : order <= 8 ? 10 : 3.8));
  const auto error = [&](int n) {
    return problems::distance(after_steps(problem, from, to, n, order), problem.exact(to));
  };
  return std::log2(error(steps) / error(2 * steps));
}

const auto swing = [](const auto& x, auto& dxdt, const auto&) {
  using std::sin;
  dxdt = {x[1], -9.81 * sin(x[0])};
};

}  // namespace

// ---- the tape ---------------------------------------------------------------------------------------------

TEST_CASE("repeated operations are recorded once, constants are computed, and unused operations are left out",
          "[taylor]") {
  const Program twice(record<1>([](const auto& x, auto& dxdt, const auto&) {
    [[maybe_unused]] const auto nobodys = exp(x[0]) * x[0];
    dxdt = {sin(x[0]) * sin(x[0]) + (2 * (3 * x[0]) - x[0] / 0.5)};
  }));
  const Program once(record<1>([](const auto& x, auto& dxdt, const auto&) {
    const auto s = sin(x[0]);
    dxdt = {s * s + 4 * x[0]};
  }));
  CHECK(twice.cost_by_hand() == 8 + 1 + 2);
  CHECK(once.cost_by_hand() == 8 + 1 + 2);
  CHECK(twice.cost(12) == once.cost(12));
}

TEST_CASE("sums of multiples are folded, and a mass's pull is one operation", "[taylor]") {
  const Program folded(record<1>([](const auto& x, auto& dxdt, const auto&) {
    dxdt = {-(-(3 * (2 * x[0] + 1)) + 1) + x[0] - x[0]};  // 6 x + 2
  }));
  CHECK(folded.cost_by_hand() == 2);
  const Program pull(record<1>([](const auto& x, auto& dxdt, const auto&) {
    const auto square = x[0] * x[0];
    dxdt = {-5.0 / (square * sqrt(square))};
  }));
  CHECK(pull.cost_by_hand() == 1 + 4 + 1 + 4);
}

TEST_CASE("factors and terms cost no operation until another one needs them", "[taylor]") {
  const auto cost = [](const auto& rhs) {
    return Program(record<1>([&](const auto& x, auto& dxdt, const auto&) { dxdt = {rhs(x[0])}; }))
        .cost_by_hand();
  };
  CHECK(cost([](const auto& x) { return (2 * x) * (-x / 2); }) == 1);                      // -(x x)
  CHECK(cost([](const auto& x) { return (2 * x) * (3 * x); }) == 1 + 1);                   // 6 (x x)
  CHECK(cost([](const auto& x) { return (x / 2 - 0.5) * (x / 4 - 0.25); }) == 1 + 1 + 1);  // (x - 1)^2 / 8
  CHECK(cost([](const auto& x) { return sqrt(4 * x + 1); }) == 1 + 1 + 4);
  CHECK(cost([](const auto& x) { return 3 / (2 * x) + 1; }) == 4 + 1);
  const auto sum = [](const auto& x) { return x * x - x; };
  CHECK(cost([&](const auto& x) { return 3 * sum(x) / (2 * sum(x)); }) == 1 + 1 + 4 + 1);
  // x' = (x - 1)^2 / 8 from 9: 1 + 8 / (1 - t)
  const auto c =
      series_of([](const auto& x, const auto&) { return (x / 2 - 0.5) * (x / 4 - 0.25); }, 9, 0, 12);
  CHECK(c == std::vector<double>{9, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8});
}

TEST_CASE("a constant right-hand side has a cost, and its motion is a line", "[taylor]") {
  const auto c = series_of([](const auto&, const auto&) { return 3.0; }, 2, 5, 6);
  CHECK(c == std::vector<double>{2, 3, 0, 0, 0, 0, 0});
}

// ---- coefficients -----------------------------------------------------------------------------------------

TEST_CASE("every operation has the coefficients of a known series", "[taylor]") {
  constexpr int order = 30;
  const auto check = [](const std::vector<double>& got, const auto& expected, double tolerance) {
    for (int k = 0; k <= order; ++k) {
      INFO("k = " << k << ": " << got[static_cast<std::size_t>(k)] << " for " << expected(k));
      const double right = expected(k);
      CHECK(near(got[static_cast<std::size_t>(k)], right, tolerance * std::max(1.0, std::abs(right))));
    }
  };
  // x' = x^2 and x' = x (2 x): 1/(1 - t)
  check(
      series_of([](const auto& x, const auto&) { return x * x; }, 1, 0, order), [](int) { return 1; }, 1e-14);
  check(
      series_of([](const auto& x, const auto&) { return x * (2 * x); }, 1, 0, order),
      [](int k) { return std::pow(2.0, k); }, 1e-13);
  // x' = 1/x: sqrt(1 + 2 t); x' = x/(1 + t): 1 + t; x' = sqrt(x): (1 + t/2)^2
  const auto binomial = [](double power, double scale) {
    return [=](int k) {
      double c = 1;
      for (int i = 0; i < k; ++i) c *= (power - i) / (i + 1) * scale;
      return c;
    };
  };
  check(series_of([](const auto& x, const auto&) { return 1 / x; }, 1, 0, order), binomial(0.5, 2), 1e-13);
  check(series_of([](const auto& x, const auto& t) { return x / (1 + t); }, 1, 0, order), binomial(1, 1),
        1e-15);
  check(series_of([](const auto& x, const auto&) { return sqrt(x); }, 1, 0, order), binomial(2, 0.5), 1e-15);
  // x' = x^(-3/2): (1 + 5 t/2)^(2/5)
  check(series_of([](const auto& x, const auto&) { return 1 / (x * sqrt(x)); }, 1, 0, order),
        binomial(0.4, 2.5), 1e-12);
  check(series_of([](const auto& x, const auto&) { return 1 / (sqrt(x) * x); }, 1, 0, order),
        binomial(0.4, 2.5), 1e-12);
  // x' = x + 3: 4 exp(t) - 3
  check(
      series_of([](const auto& x, const auto&) { return x + 3; }, 1, 0, order),
      [](int k) { return k == 0 ? 1 : 4 / std::tgamma(k + 1.0); }, 1e-15);
  // x' = (x + 3)^2 from -2: 1/(1 - t) - 3; the constant is part of the factors
  check(
      series_of([](const auto& x, const auto&) { return (x + 3) * (x + 3); }, -2, 0, order),
      [](int k) { return k == 0 ? -2.0 : 1.0; }, 1e-14);
  // x' = exp(-x): log(1 + t)
  check(
      series_of([](const auto& x, const auto&) { return exp(-x); }, 0, 0, order),
      [](int k) { return k == 0 ? 0 : (k % 2 ? 1.0 : -1.0) / k; }, 1e-14);
  // x' = cos t: sin t, about 1; x' = -sin t: cos t
  check(
      series_of([](const auto&, const auto& t) { return cos(t); }, std::sin(1), 1, order),
      [](int k) { return std::sin(1 + k * std::numbers::pi / 2) / std::tgamma(k + 1.0); }, 1e-15);
  check(
      series_of([](const auto&, const auto& t) { return -sin(t); }, std::cos(1), 1, order),
      [](int k) { return std::cos(1 + k * std::numbers::pi / 2) / std::tgamma(k + 1.0); }, 1e-15);
}

TEST_CASE("a series is finite if each of its unknowns is", "[taylor]") {
  Series series{Program(record<3>([](const auto& x, auto& dxdt, const auto&) {
    dxdt = {1 / x[0], 1 / x[1], 1 / x[2]};
  }))};
  for (const auto& [x, finite] : {std::pair(std::array{1.0, 1.0, 1.0}, true),
                                  {{0.0, 1.0, 1.0}, false},
                                  {{1.0, 0.0, 1.0}, false},
                                  {{1.0, 1.0, 0.0}, false}}) {
    series.expand(x.data(), 0, 6);
    CHECK(series.is_finite() == finite);
  }
}

TEST_CASE("a motion of zero, with products of zeros, has the series zero", "[taylor]") {
  for (double c : series_of([](const auto&x, const auto&) { return x * sin(x) + x * x * x; }, 0, 0, 12))
    CHECK(c == 0);
}

TEST_CASE("products that are computed in pairs have the same bits as alone", "[taylor]") {
  const auto slopes = [](const auto& x, const auto& y, const auto& u, const auto& v) {
    const auto xx = x * x, yy = y * y, pull = -1.0 / ((xx + yy) * sqrt(xx + yy));
    const auto xu = x * u, yv = y * v, before = pull * xu, and_after = pull * yv;
    return std::array{u, v, x * pull + 0.1 * before, y * pull - 0.2 * and_after};
  };
  Series two{Program(
      record<4>([&](const auto& s, auto& dsdt, const auto&) { dsdt = slopes(s[0], s[1], s[2], s[3]); }))};
  // No two of these have interleaved rows, because of another unknown between them.
  Series one{Program(record<5>([&](const auto& s, auto& dsdt, const auto&) {
    const auto [x, y, u, v] = slopes(s[0], s[2], s[3], s[4]);
    dsdt = {x, 0, y, u, v};
  }))};
  constexpr int order = 30;
  two.expand(std::array{0.9, -0.3, 0.4, 1.1}.data(), 0, order);
  one.expand(std::array{0.9, 0.0, -0.3, 0.4, 1.1}.data(), 0, order);
  for (int k = 0; k <= order; ++k)
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(two.coefficient(i, k) == one.coefficient(i == 0 ? 0 : i + 1, k));
}

TEST_CASE("a sum and a quotient are not changed by a product of the rows next to theirs", "[taylor]") {
  const auto slopes = [](const auto& x, const auto& y, const auto& u, const auto& v) {
    const auto sum = x + 2.0 * u, of_sum = y * v, quotient = u / x, of_quotient = v * y;
    return std::array{sum * 0.1, of_sum * 0.1, quotient * 0.1, of_quotient * 0.1};
  };
  Series beside{Program(
      record<4>([&](const auto& s, auto& dsdt, const auto&) { dsdt = slopes(s[0], s[1], s[2], s[3]); }))};
  Series apart{Program(record<7>([&](const auto& s, auto& dsdt, const auto&) {
    const auto [x, y, u, v] = slopes(s[0], s[2], s[4], s[6]);
    dsdt = {x, 0, y, 0, u, 0, v};
  }))};
  constexpr int order = 30;
  beside.expand(std::array{0.9, -0.3, 0.4, 1.1}.data(), 0, order);
  apart.expand(std::array{0.9, 0.0, -0.3, 0.0, 0.4, 0.0, 1.1}.data(), 0, order);
  for (int k = 0; k <= order; ++k)
    for (std::size_t i = 0; i < 4; ++i) CHECK(beside.coefficient(i, k) == apart.coefficient(2 * i, k));
}

TEST_CASE("operations that are computed in pairs have the same bits as alone", "[taylor]") {
  constexpr int order = 30;
  const auto alone = [](Operation operation, double x0) {
    std::vector<double> x(80, 0.0), result(80), second(80), spare(80);
    const auto row = Row<double>::from;
    const Rows<double> rows{row(x.data()), {}, row(result.data()), row(second.data()), row(spare.data())};
    const Node node{operation, 0, -1, 0, 0, 1};
    rows.a[0] = x0;
    [&]<int... k>(std::integer_sequence<int, k...>) {
      ((rows.a[k + 1] = compute<k>(operation, node, rows) * (1.0 / (k + 1))), ...);
    }
    (std::make_integer_sequence<int, order>());
    std::vector<double> all;
    for (int k = 0; k <= order; ++k) all.push_back(rows.a[k]);
    return all;
  };
  CHECK(series_of([](const auto& x, const auto&) { return 1 / (x * sqrt(x)); }, 1.3, 0, order) ==
        alone(Operation::inverse_cube, 1.3));
  CHECK(series_of([](const auto& x, const auto&) { return sin(x); }, 1.3, 0, order) ==
        alone(Operation::sine, 1.3));
}

TEST_CASE(
    "the sine of a multiple of the time has the same bits as that of an unknown growing like the time, at less cost",
    "[taylor]") {
  const auto slope = [](const auto& x, const auto& t) {
    return cos(1.7 * t + 0.3) * x - sin(t) * sin(1.7 * t + 0.3);
  };
  Series turning{
      Program(record<1>([&](const auto& x, auto& dxdt, const auto& t) { dxdt = {slope(x[0], t)}; }))};
  Series growing{Program(record<2>([&](const auto& x, auto& dxdt, const auto&) {
    dxdt = {slope(x[0], x[1]), 1};
  }))};
  constexpr int order = 30;
  turning.expand(std::array{0.9}.data(), 0.4, order);
  growing.expand(std::array{0.9, 0.4}.data(), 0, order);
  for (int k = 0; k <= order; ++k) CHECK(turning.coefficient(0, k) == growing.coefficient(0, k));
  CHECK(turning.program().cost_by_hand() == growing.program().cost_by_hand());
  CHECK(turning.program().cost(order) < growing.program().cost(order) / 2);
}

TEST_CASE("the stated cost is the number of operations", "[taylor]") {
  using Number = Counted<double>;
  const auto made = [](Operation operation, int k, bool has_a, bool square) {
    std::vector<Number> a(80, 1.25), b(80, 0.75), result(80, 1.0), second(80, 0.5), spare(80, 0.25);
    const auto row = [](std::vector<Number>& all) { return Row<Number>::from(all.data()); };
    const Rows<Number> rows{has_a ? row(a) : Row<Number>{}, row(square ? a : b), row(result), row(second),
                            row(spare)};
    const Node node{operation, has_a ? 0 : -1, square ? 0 : 1, 2, 3, 0};
    const auto count = operations_of([&] {
      [&]<int... order>(std::integer_sequence<int, order...>) {
        ((order == k ? static_cast<void>(compute<order>(operation, node, rows)) : void()), ...);
      }
      (std::make_integer_sequence<int, most_orders>());
      return 0;
    });
    return std::pair{node, count};
  };
  for (int k = 0; k < most_orders; ++k)
    for (bool has_a : {true, false})
      for (bool square : {true, false})
        for (Operation operation :
             {Operation::multiply, Operation::divide, Operation::inverse_cube, Operation::square_root,
              Operation::sine, Operation::turning, Operation::exponential}) {
          if (!has_a && operation != Operation::divide) continue;
          if (square && operation != Operation::multiply) continue;
          const auto [node, count] = made(operation, k, has_a, square);
          const bool root = operation == Operation::square_root || operation == Operation::inverse_cube;
          const long cost = count.additions + count.multiplications + Weights::division * count.divisions +
                            (root ? Weights::root : Weights::function) * count.functions;
          INFO("operation " << static_cast<int>(operation) << " at order " << k);
          CHECK(cost_of(node, k) == cost);
        }
}

// ---- steps ------------------------------------------------------------------------------------------------

TEST_CASE("steps of one order have that order, with and without explicit time, forward and backward",
          "[taylor]") {
  for (int order : {1, 2, 3, 4, 6, 8, 12}) {
    INFO("order " << order);
    for (const auto& [from, to] : {std::pair{-1.5, 1.3}, std::pair{1.5, -1.3}})
      CHECK(near(order_measured(problems::separatrix, from, to, order), order, 0.25));
    for (const auto& [from, to] : {std::pair{0.0, 2.0}, std::pair{0.0, -2.0}})
      CHECK(near(order_measured(problems::driven, from, to, order), order, 0.25));
  }
}

TEST_CASE("the order grows with the requested digits, and is the cheapest", "[taylor]") {
  const Program program(record<2>(swing));
  int before = 0;
  for (double tolerance : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const int order = best_order(program, tolerance);
    CHECK(order > before);
    before = order;
  }
  CHECK(within(best_order(program, 1e-12), 14, 24));
}

TEST_CASE("a tolerance looser than a tenth counts as a tenth, and a series of order one has a cost",
          "[taylor]") {
  const Program program(record<2>(swing));
  CHECK(program.cost(0) == 0);
  CHECK(program.cost(1) > 0);
  CHECK(program.cost(2) > program.cost(1));
  problems::State one{1, 0}, other{1, 0};
  double t = 0, t_other = 0;
  CHECK(Motion(program, 0.1).advance(one, t, 2) == nullptr);
  CHECK(Motion(program, 0.9).advance(other, t_other, 2) == nullptr);
  CHECK(one == other);
}

TEST_CASE("a polynomial motion takes one step", "[taylor]") {
  Motion motion(Program(record<2>(problems::fall.system)), 1e-9);
  problems::State x = problems::fall.exact(0);
  double t = 0;
  CHECK(motion.advance(x, t, 100) == nullptr);
  CHECK(t == 100);
  CHECK(near(x[0], problems::fall.exact(100)[0], 1e-10));
}

TEST_CASE("coefficients that vanish by symmetry do not lengthen the step", "[taylor]") {
  // At rest the angle's series is even and the rate's odd: of two consecutive orders one contains everything.
  for (double angle = 0.05; angle < 3; angle += 0.05)
    for (double tolerance : {1e-6, 1e-9, 1e-12}) {
      Motion motion(Program(record<2>(swing)), tolerance);
      std::array<double, 2> x{angle, 0};
      double t = 0;
      while (t < 2) REQUIRE(motion.advance(x, t, 2) == nullptr);
      const double energy = x[1] * x[1] / 2 - 9.81 * std::cos(x[0]);
      CHECK(near(energy, -9.81 * std::cos(angle), 100 * tolerance));
    }
}

TEST_CASE("times on the way and back cost points of the same series, not new series", "[taylor]") {
  const auto evaluations = [](int parts) {
    Motion motion(Program(record<2>(swing)), 1e-9);
    std::array<double, 2> x{0.5, 0};
    double t = 0;
    for (int i = 1; i <= parts; ++i)
      while (t != i * 10.0 / parts) REQUIRE(motion.advance(x, t, i * 10.0 / parts) == nullptr);
    return motion.evaluations();
  };
  // A point takes 2 (2 p + 2) + 1 operations, and an evaluation 9.
  CHECK(evaluations(600) - evaluations(1) <= 600 * (4 * 20 + 5) / 9);

  Motion motion(Program(record<2>(swing)), 1e-9);
  std::array<double, 2> x{0.5, 0.25};
  const auto start = x;
  double t = 0;
  REQUIRE(motion.advance(x, t, 0.01) == nullptr);
  const long once = motion.evaluations();
  REQUIRE(motion.advance(x, t, 0) == nullptr);
  CHECK(x == start);
  CHECK(motion.evaluations() - once <= (4 * 20 + 5) / 9 + 1);
}

TEST_CASE("a state that is not on the series is expanded again", "[taylor]") {
  Motion kept(Program(record<2>(swing)), 1e-12);
  std::array<double, 2> x{0.5, 0};
  double t = 0;
  REQUIRE(kept.advance(x, t, 0.01) == nullptr);
  x = {1, -1};
  REQUIRE(kept.advance(x, t, 0.05) == nullptr);
  Motion anew(Program(record<2>(swing)), 1e-12);
  std::array<double, 2> y{1, -1};
  double s = 0.01;
  REQUIRE(anew.advance(y, s, 0.05) == nullptr);
  CHECK(x == y);
}

TEST_CASE("a system that cannot be recorded is refused", "[taylor]") {
  const auto plain = [](const problems::State& x, problems::State& dxdt, double) { dxdt = {x[1], -x[0]}; };
  CHECK_THROWS_WITH(ode::integrate<ode::Taylor>(plain, problems::State{1, 0}, 0, 1, 1e-9),
                    "the system is not generic in its number type, or not analytic");
}

TEST_CASE("the pendulum takes few right-hand sides, and the same number with dense output", "[taylor]") {
  const auto solved = [](std::vector<double> times) {
    return ode::integrate<ode::Taylor>(swing, std::array{std::numbers::pi / 6, 0.0},
                                       std::span<const double>(times), 1e-9);
  };
  const auto straight = solved({0, 10});
  CHECK(straight.reached());
  CHECK(straight.evaluations < 3500);
  const auto exact = ode::integrate<ode::Taylor>(swing, std::array{std::numbers::pi / 6, 0.0}, 0, 10, 1e-14);
  CHECK(near(straight.value.back()[0], exact.value[0], 1e-9));
}
