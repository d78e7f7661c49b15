// The tools for generating the reference tables, on problems with solutions known to 40 digits.

#include <set>
#include <string>

#include "reference/bad_input.hpp"
#include "reference/make/extrapolation.hpp"
#include "reference/make/recorded.hpp"
#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"
#include "reference/make/universal_kepler.hpp"
#include "reference/reference.hpp"
#include "report/verify/catch.hpp"

namespace oddity::truth {

namespace {

constexpr int digits = 40;

/// got == expected to `digits` digits; a failure prints how many agree.
struct Agree {
  Number got, expected;
  explicit operator bool() const {
    return abs(got - expected) <= pow(Number(10), 2 - digits) * std::max<Number>(abs(expected), 1);
  }
};
std::ostream& operator<<(std::ostream& out, const Agree& a) {
  return out << a.got.str(digits) << " and " << a.expected.str(digits) << " (off by "
             << Number(a.got - a.expected).str(3) << ")";
}
Agree agree(const Number& got, const Number& expected) { return {got, expected}; }

/// Solves by both routes and compares the first unknown with its known value.
template <class Rhs>
void check_solution(const Rhs& rhs, const Numbers& start, const Number& t0, const Number& t1,
                    const Number& expected) {
  CHECK(agree(solve_taylor(rhs, start, t0, t1, digits)[0], expected));
  CHECK(agree(solve_extrapolation(rhs, start, t0, t1, digits)[0], expected));
}

}  // namespace

TEST_CASE("Taylor and extrapolation: the exponential, forward, backward and over no time", "[reference]") {
  const auto rhs = [](const auto& x, const auto&) { return std::vector{x[0]}; };
  check_solution(rhs, {1}, 0, 1, exp(Number(1)));
  check_solution(rhs, {1}, 0, -2, exp(Number(-2)));
  check_solution(rhs, {1}, 5, 5, 1);
  check_solution(rhs, {1}, 0, 20, exp(Number(20)));
}

TEST_CASE("Taylor and extrapolation: an oscillator for ten radians", "[reference]") {
  const auto rhs = [](const auto& x, const auto&) { return std::vector{x[1], -x[0]}; };
  check_solution(rhs, {1, 0}, 0, 10, cos(Number(10)));
  check_solution(rhs, {0, 1}, 0, -10, sin(Number(-10)));
}

TEST_CASE("Taylor and extrapolation: sine and cosine of the state, a pendulum on its separatrix",
          "[reference]") {
  const auto pendulum = [](const auto& x, const auto&) { return std::vector{x[1], -sin(x[0])}; };
  check_solution(pendulum, {0, 2}, 0, 1, 2 * asin(tanh(Number(1))));
  // x' = cos^2 x: tan x = t.
  const auto angle = [](const auto& x, const auto&) { return std::vector{cos(x[0]) * cos(x[0])}; };
  check_solution(angle, {0}, 0, 2, atan(Number(2)));
}

TEST_CASE("Taylor and extrapolation: up to a pole, and not through it", "[reference]") {
  const auto rhs = [](const auto& x, const auto&) { return std::vector{x[0] * x[0]}; };
  check_solution(rhs, {1}, 0, Number(9) / 10, 10);
  check_solution(rhs, {1}, 0, -9, Number(1) / 10);
  CHECK_THROWS_AS(solve_taylor(rhs, {1}, 0, 2, digits), std::runtime_error);
  CHECK_THROWS_AS(solve_extrapolation(rhs, {1}, 0, 2, digits), std::runtime_error);
}

TEST_CASE("extrapolation stops when its budget is spent, and reports where", "[reference]") {
  const auto fast = [](const Numbers& x, const Number&) {
    return Numbers{1000000 * x[1], Number(-1000000 * x[0])};
  };
  try {
    solve_extrapolation(fast, {1, 0}, 0, 100, 6, 10000);
    FAIL("100 million radians were solved");
  } catch (const std::runtime_error& error) {
    CHECK(std::string(error.what()).find("the budget of 10000 right-hand sides is spent at t = ") !=
          std::string::npos);
  }
}

TEST_CASE("Taylor stops when its budget of expansions is spent, and reports where", "[reference]") {
  const auto fast = [](const auto& x, const auto&) { return std::vector{1000000 * x[1], -1000000 * x[0]}; };
  const auto spent_by = [](const auto& solve) -> std::string {
    try {
      solve();
    } catch (const BudgetSpent& error) {
      return error.what();
    }
    return "nothing";
  };
  const std::string alone = spent_by([&] { TaylorProblem(fast, 2).solve({1, 0}, 0, 100, 6, 100); });
  CHECK(alone.find("the budget of 100 expansions of the right-hand side is spent at t = ") !=
        std::string::npos);
  // A motion has one budget for all its times, and a larger one if it is watched.
  for (bool watched : {false, true}) {
    const long allowed = most_expansions * (watched ? 50 : 1);
    long ticks = 0;
    Motions motion(watched ? Tick([&](double) {
      if (++ticks > 2 * most_expansions) throw std::logic_error("long enough");
    })
                           : Tick());
    const auto follow = [&] {
      for (int k = 1; k <= 1000; ++k) solve_taylor(fast, {1, 0}, 0, Number(k) / 20, {2, &motion});
    };
    if (watched)
      CHECK_THROWS_AS(follow(), std::logic_error);
    else
      CHECK(spent_by(follow).find("the budget of " + std::to_string(allowed)) != std::string::npos);
  }
}

TEST_CASE("extrapolation has one budget for all times of a motion", "[reference][slow]") {
  const std::function<Numbers(const Numbers&, const Number&)> fast = [](const Numbers& x, const Number&) {
    return Numbers{1000 * x[1], Number(-1000 * x[0])};
  };
  Motions motion;
  CHECK_THROWS_AS(
      [&] {
        for (int k = 1; k <= 10000; ++k) solve_extrapolation(fast, {1, 0}, 0, Number(k), {2, &motion});
      }(),
      BudgetSpent);
}

TEST_CASE("a motion that takes too long is refused with its exercise, table and parameters",
          "[reference][slow]") {
  const Reference stored(std::string(ODDITY_SOURCE) + "/reference");
  const std::vector<double> stiff{0.3, 0.4, 1.5, 900000, 2, 9.81, 2, 0.8, -2};
  std::string says = "nothing";
  try {
    stored.motion("03_23_swing", stiff, std::vector{0.5, 1.0, 1.5, 2.0});
  } catch (const BadInput& error) {
    says = error.what();
  }
  CHECK(says.find(
            "exercise 3.23: the truth of its table 03_23_swing takes too long to make at m = 0.3, r = ") ==
        0);
  CHECK(says.find(" is spent at t = ") != std::string::npos);
  CHECK(says.find("Ask for ") != std::string::npos);
}

TEST_CASE("a bar that turns over repeatedly on a strong spring keeps its constraint", "[reference]") {
  const std::vector<double> start{0.3, 0.4, 1.5, 900, 2, 9.81, 0.5, 0.8, -2, 1};
  for (const Entry& entry : registry())
    if (entry.name == "03_23_swing") CHECK(make_row(entry.make(), start, 12).error < 1e-11);
}

TEST_CASE("Taylor and extrapolation: explicit time", "[reference]") {
  const auto rhs = [](const auto& x, const auto& t) { return std::vector{x[0] * cos(t)}; };
  check_solution(rhs, {1}, 0, 3, exp(sin(Number(3))));
  check_solution(rhs, {exp(sin(Number(1)))}, 1, -2, exp(sin(Number(-2))));
  const auto time = [](const auto&, const auto& t) { return std::vector{t}; };
  check_solution(time, {0}, 0, 3, Number(9) / 2);
}

TEST_CASE("Taylor and extrapolation: a series with gaps, exp(t^5) about zero", "[reference]") {
  const auto rhs = [](const auto& x, const auto& t) {
    const auto square = t * t;
    return std::vector{5 * square * square * x[0]};
  };
  check_solution(rhs, {1}, 0, 1, exp(Number(1)));
  check_solution(rhs, {1}, 0, Number("1.3"), exp(pow(Number("1.3"), 5)));
}

TEST_CASE("Taylor and extrapolation: square roots, quotients and exponentials", "[reference]") {
  const auto root = [](const auto& x, const auto&) { return std::vector{sqrt(x[0])}; };
  check_solution(root, {1}, 0, 3, Number(25) / 4);
  const auto quotient = [](const auto& x, const auto& t) { return std::vector{x[0] / (1 + t)}; };
  check_solution(quotient, {1}, 0, 4, 5);
  const auto inverse = [](const auto& x, const auto&) { return std::vector{1 / (2 * x[0])}; };
  check_solution(inverse, {1}, 0, 3, 2);
  const auto decay = [](const auto& x, const auto&) { return std::vector{exp(-x[0])}; };
  check_solution(decay, {0}, 0, 3, log(Number(4)));
}

TEST_CASE("Taylor and extrapolation: squares", "[reference]") {
  const auto rhs = [](const auto& x, const auto&) { return std::vector{1 + x[0] * x[0]}; };
  check_solution(rhs, {0}, 0, 1, tan(Number(1)));
}

TEST_CASE("a tape computes no sum, product, quotient or function twice", "[reference]") {
  Recorded recorded;
  const Jet x = recorded.variable(), y = recorded.variable();
  const auto nodes = [&] { return recorded.tape.nodes().size(); };
  const Jet product = x * y, sine = sin(x);
  CHECK(nodes() == 5);  // the cosine next to the sine
  CHECK((x * y).node == product.node);
  CHECK(sin(x).node == sine.node);
  CHECK(cos(x).node == sine.node + 1);
  CHECK(nodes() == 5);
  CHECK((x + y).node != product.node);  // another operation,
  CHECK((y * x).node != product.node);  // another order, another factor
  CHECK((x * Number(2)).node != (x * Number(3)).node);
  CHECK(nodes() == 9);
}

TEST_CASE("Taylor: numbers on either side of every operator", "[reference]") {
  // x' = (2 - (x - 1))/1 + 0 x - ... uses each form once; x' = 3 - x: x = 3 - 2 exp(-t).
  const auto rhs = [](const auto& x, const auto&) {
    const Number one = 1, two = 2;
    return std::vector{(two - (x[0] - one)) / one + (x[0] * two - two * x[0]) + (one + x[0]) - (x[0] + one)};
  };
  CHECK(agree(solve_taylor(rhs, {1}, 0, 2, digits)[0], 3 - 2 * exp(Number(-2))));
}

TEST_CASE("Taylor: a problem can be solved from more than one start", "[reference]") {
  TaylorProblem problem([](const auto& x, const auto&) { return std::vector{x[0]}; }, 1);
  CHECK(agree(problem.solve({1}, 0, 1, digits)[0], exp(Number(1))));
  CHECK(agree(problem.solve({2}, 1, 0, digits)[0], 2 * exp(Number(-1))));
}

TEST_CASE("the result has the requested number of digits", "[reference]") {
  const auto rhs = [](const auto& x, const auto& t) { return std::vector{x[0] * cos(t)}; };
  for (int asked : {10, 20, 30, 42}) {
    const Number allowed = pow(Number(10), 2 - asked), exact = exp(sin(Number(3)));
    CHECK(abs(solve_taylor(rhs, {1}, 0, 3, asked)[0] - exact) < allowed);
    CHECK(abs(solve_extrapolation(rhs, {1}, 0, 3, asked)[0] - exact) < allowed);
  }
}

TEST_CASE("the elliptic integral K: known digits, its limit and its end", "[reference]") {
  CHECK(agree(elliptic_k(0), pi() / 2));
  // K(1/sqrt 2) = Gamma(1/4)^2 / (4 sqrt pi) [DLMF 23.5.4 with 22.2.2]
  CHECK(agree(elliptic_k(1 / sqrt(Number(2))),
              Number("1.854074677301371918433850347195260046217598823521766905586")));
  CHECK(agree(elliptic_k(Number(1) / 2),
              Number("1.685750354812596042871203657799076989500800894141089044119948")));
  // K(k) is near log(4/k') for k' small [DLMF 19.12.1].
  const Number complement = pow(Number(10), -25), k = sqrt(1 - complement * complement);
  CHECK(agree(elliptic_k(k), log(4 / sqrt((1 - k) * (1 + k)))));
  for (const Number& bad : {Number(1), Number(-1), Number(2), std::numeric_limits<Number>::quiet_NaN()})
    CHECK_THROWS_AS(elliptic_k(bad), std::domain_error);
}

TEST_CASE("Stumpff's functions: near zero, where they are series, and beyond", "[reference]") {
  CHECK(agree(Stumpff(0).c2, Number(1) / 2));
  CHECK(agree(Stumpff(0).c3, Number(1) / 6));
  for (const char* text : {"0.3", "1", "2.5", "-0.7", "-1", "-4"}) {
    INFO(text);
    const Number z(text), w = sqrt(abs(z));
    const Number sine = z > 0 ? Number(sin(w)) : Number(sinh(w)),
                 cosine = z > 0 ? Number(cos(w)) : Number(cosh(w));
    CHECK(agree(Stumpff(z).c2, (1 - cosine) / z));
    CHECK(agree(Stumpff(z).c3, (w - sine) / (z * w)));
  }
}

TEST_CASE("double-exponential quadrature: smooth and singular integrands", "[reference]") {
  const auto over_unit = [](const auto& f) { return integral(f, 0, 1, digits); };
  CHECK(agree(over_unit([](const Number& x) -> Number { return exp(x); }), exp(Number(1)) - 1));
  CHECK(agree(over_unit([](const Number& x) -> Number { return 1 / sqrt(x); }), 2));
  CHECK(agree(over_unit([](const Number& x) -> Number { return log(x); }), -1));
  CHECK(agree(integral([](const Number& x) -> Number { return 1 / (1 + x * x); }, -1, 1, digits), pi() / 2));
}

namespace {

/// Name of a route's algorithm, if it integrates a differential equation; otherwise "".
std::string integrator(const std::string& route) {
  for (const char* name : {"Taylor", "extrapolated midpoint"})
    if (route.find(name) != std::string::npos) return name;
  return "";
}

}  // namespace

TEST_CASE("the two routes of a table integrate by different algorithms", "[reference]") {
  // Friction of the sliding box has no Taylor series where its instantaneous centre crosses an edge.
  const std::set<std::string_view> same_algorithm{"03_31_rest", "03_31_slide"};
  for (const Entry& entry : registry()) {
    const Truth truth = entry.make();
    INFO(entry.name << ": " << truth.first_route << "; " << truth.second_route);
    const std::string first = integrator(truth.first_route), second = integrator(truth.second_route);
    CHECK((!first.empty() && first == second) == (same_algorithm.count(entry.name) > 0));
    CHECK(truth.first_route != truth.second_route);
  }
}

}  // namespace oddity::truth
