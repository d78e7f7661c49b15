// Examples at the heads of public headers: each is compiled and run here, word for word.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>

#include "chapters/contents.hpp"
#include "chapters/examples/bouncing_ball/models.hpp"
#include "reference/reference.hpp"
#include "report/study/choose.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"
#include "solvers/dual.hpp"
#include "solvers/linear.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/catalog.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/quadrature.hpp"
#include "solvers/roots.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::ode;

namespace {

/// Text written to standard output during the lifetime of this.
class Output {
 public:
  Output() : before_(std::cout.rdbuf(written_.rdbuf())) {}
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() { std::cout.rdbuf(before_); }

  bool has(const std::string& text) const { return written_.str().find(text) != std::string::npos; }

 private:
  std::ostringstream written_;
  std::streambuf* before_;
};

}  // namespace

TEST_CASE("a motion and its events run as in the examples of their headers", "[texts]") {
  const Output output;
  const auto swing = [](const auto& x, auto& dxdt, const auto&) { dxdt = {x[1], -x[0]}; };
  const std::array times{0.0, 1.0, 2.0};
  const auto path = integrate<RungeKutta4>(swing, std::array{1.0, 0.0}, times, 0.01);
  if (path.reached()) std::cout << path.value.back()[0];  // cos(2)
  CHECK(output.has("-0.416147"));

  const bouncing_ball::Ball<double> ball{{1, 9.81, 0.7}};  // has guards() and at_event().
  const auto motion = integrate_with_events<RungeKutta4>(ball, ball.start(), times, 0.01);
  for (const auto& event : motion.events) std::cout << event.time << "\n";
  CHECK(output.has("0.451524\n1.08366\n"));

  for (const CatalogEntry& a : catalog())
    if (a.kind == Kind::fixed) std::cout << a.name << " " << a.order << " " << a.imaginary_limit << "\n";
  CHECK(output.has("\nRunge-Kutta 4 4 2.82843\n"));
}

TEST_CASE("integrals, roots, slopes and equations run as in the examples of their headers", "[texts]") {
  const Output output;
  const Integral area = qags([](double x) { return 1 / std::sqrt(x); }, 0, 1, 1e-10);
  if (area.reached()) std::cout << area.value << " +- " << area.error_estimate;  // 2
  CHECK(output.has("2 +- "));

  const Solved<double> root = brent([](double x) { return std::cos(x) - x; }, 0, 1, 1e-12);
  if (root.reached()) std::cout << root.value;  // 0.739085
  CHECK(output.has("0.739085"));

  const Dual<double> x(2, 1);
  std::cout << (x * sqrt(x)).slope;  // 3/2 sqrt(2)
  CHECK(output.has("2.12132"));

  const Eigen::MatrixXd a{{2, 1}, {1, 3}};
  const Eigen::VectorXd b{{1, 2}};
  const auto solved = solve(Factorization::partial_pivot_lu, a, b);
  if (solved.reached()) std::cout << solved.value.transpose() << " by " << solved.evaluations;
  CHECK(output.has("0.2 0.6 by "));
}

TEST_CASE("a reference value, a run and a choice run as in the examples of their headers", "[texts]") {
  const Output output;
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Known quarter = truth("03_05_quarter_period", {1.5});
  std::cout << quarter.value[0] << " +- " << quarter.error << ", " << quarter.source;
  CHECK(std::abs(quarter.value[0] - std::sqrt(2) * std::comp_ellint_1(std::sin(0.75))) < 1e-14);
  CHECK(output.has(", computed on the spot: "));

  {
    const Task task(registry()[0]);
    const Results results = run(std::span(&task, 1), truth, false);
    for (const auto& judged : results.exercises[0].claims)
      std::cout << judged.claim.id << " " << name_of(judged.verdict) << "\n";
    CHECK(output.has("velocity confirmed\n"));
  }

  const auto pendulum = std::ranges::find(registry(), Number{3, 5}, &Entry::number);
  const Task task(*pendulum);
  Need need{.error = 0.01, .horizon = 2};
  const Choice choice = choose(task, need, truth);
  if (choice.chosen) std::cout << choice.chosen->model << " by " << choice.chosen->algorithm;
  CHECK(output.has(" by closed form"));
}

TEST_CASE("the examples at the heads of headers are those that run here", "[texts]") {
  const std::filesystem::path tree = ODDITY_SOURCE;
  std::istringstream here(text_of(tree / "tests/test_heads.cpp"));
  std::set<std::string> lines;
  const auto without_margin = [](const std::string& line) {
    return line.substr(std::min(line.size(), line.find_first_not_of(' ')));
  };
  for (std::string line; std::getline(here, line);) lines.insert(without_margin(line));
  for (const char* header :
       {"solvers/ode/integrate.hpp", "solvers/ode/events.hpp", "solvers/ode/catalog.hpp",
        "solvers/quadrature.hpp", "solvers/roots.hpp", "solvers/dual.hpp", "solvers/linear.hpp",
        "reference/reference.hpp", "report/study/run.hpp", "report/study/choose.hpp"}) {
    std::istringstream head(text_of(tree / header));
    int uses = 0;
    for (std::string line; std::getline(head, line) && !line.starts_with("namespace ");)
      if (line.starts_with("///   ")) {
        INFO(header << ": " << line);
        ++uses;
        // The folder's path depends on the user.
        CHECK((lines.contains(without_margin(line.substr(3))) ||
               line.find("truth(\"reference\")") != line.npos));
      }
    INFO(header);
    CHECK(uses > 0);
  }
}
