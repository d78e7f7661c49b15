// Tables of numbers in problems' files: the curve is GSL's, and a motion driven by it is that of the formula
// behind the rows.

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>

#include "chapters/random.hpp"
#include "chapters/scene.hpp"
#include "problem/expression.hpp"
#include "problem/model.hpp"
#include "problem/scene.hpp"
#include "problem/table.hpp"
#include "problem/truth.hpp"
#include "reference/text.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"

using namespace oddity;
using namespace oddity::problem;

namespace {

/// A mass pushed by a table: y'' = push(t), from rest.
std::string pushed(const std::string& table, const std::string& more = "[need]\nhorizon = \"1 s\"\n",
                   const std::string& force = "push(t)") {
  return "title = \"x\"\n[parameters]\nm = \"1 kg\"\n[tables]\npush = " + table +
         "\n[model.one]\nequations = [\"m y'' = " + force +
         "\"]\nstart = { y = \"0 m\", \"y'\" = \"0 m/s\" }\n[observe]\ny = \"m\"\n" + more;
}
std::string refusal(const std::string& text) {
  const std::string said = complaint([&] {
    const Entry& entry = entry_of_text("test.toml", text);
    motion(*entry.exercise.scene, Parameters(entry.exercise.parameters),
           Reference(std::filesystem::path(ODDITY_SOURCE) / "reference"));
  });
  return said.substr(0, said.find('\n'));
}

}  // namespace

TEST_CASE("A table's curve and its slope are those of GSL", "[problem][tables]") {
  Random random(7);
  for (const auto& [spline, type] : {std::pair{Spline::linear, gsl_interp_linear},
                                     {Spline::cubic, gsl_interp_cspline},
                                     {Spline::monotone, gsl_interp_steffen}}) {
    std::vector<double> x{-1.3}, y{0.4};
    for (int i = 0; i < 23; ++i)
      x.push_back(x.back() + random.between(0.05, 2)), y.push_back(random.normal());
    Table table{"f", {}, {}, true, pieces_of(spline, x, y), x.back()};
    gsl_spline* through = gsl_spline_alloc(type, x.size());
    gsl_spline_init(through, x.data(), y.data(), x.size());
    Graph graph;
    const Expression at = input(graph, 1), value = value_at(table, at),
                     slope = slopes(std::span(&value, 1), {{1, 1}})[0];
    const std::vector<int> keys{1};
    const Program both(std::vector<Expression>{value, slope}, keys);
    for (int i = 0; i < 2000; ++i) {
      const double here =
          i < 24 ? x[static_cast<std::size_t>(i)] + 1e-12 : random.between(x.front(), x.back());
      if (here > x.back()) continue;
      std::array<double, 2> seen{};
      both.run(&here, here, seen.data());
      CHECK(near(seen[0], gsl_spline_eval(through, here, nullptr), 1e-11));
      CHECK(near(seen[1], gsl_spline_eval_deriv(through, here, nullptr), 1e-9));
    }
    for (const double here : {x.front() - 5, x.back() + 5}) {
      std::array<double, 2> seen{};
      both.run(&here, here, seen.data());
      CHECK(near(seen[0], here < 0 ? y.front() : y.back(), 1e-12));
      CHECK(seen[1] == 0);
    }
    gsl_spline_free(through);
  }
}

TEST_CASE("Both routes to a true motion restart at a table's knots", "[problem][tables]") {
  // A force of 0, 1, -1 N at 0, 0.3, 1 s, linear between: the place is a cubic on each piece.
  const std::string text =
      pushed(R"({ x = "s", y = "N", spline = "linear", rows = [[0, 0], [0.3, 1], [1, -1]] })");
  const auto file = read("test.toml", text);
  const Numbers numbers = Model(*file, file->models[0]).with({1});
  std::vector<double> times;
  for (int i = 0; i <= 20; ++i) times.push_back(0.05 * i);
  for (const auto route : {by_series, by_extrapolation}) {
    const TrueMotion motion = route(numbers, times);
    REQUIRE(motion.trouble.empty());
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double t = times[i], s = t - 0.3;
      const double y = s < 0 ? t * t * t / 0.3 / 6 : 0.015 + 0.15 * s + s * s / 2 - s * s * s * (2 / 0.7) / 6;
      CHECK(near(static_cast<double>(motion.states[i][0]), y, 1e-15));
    }
  }
}

TEST_CASE("A motion driven by a table is that of the formula behind its numbers", "[problem][tables]") {
  // A cubic spline through a straight line is that line, in its units.
  const std::string line = R"(""" 0, 100
 50; 200
100	300
 """)";
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const auto last = [&](const std::string& text) {
    const Entry& entry = entry_of_text("test.toml", text);
    return motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), {1, 1}, truth);
  };
  const Quantity one = last(pushed("{ x = \"cs\", y = \"cN\", rows = " + line + " }"));
  CHECK(near(one.reference.value[0], 0.5 + 2.0 / 6, 1e-14));
  // A heading, as spreadsheets have one, is no row.
  const Quantity headed =
      last(pushed("{ x = \"cs\", y = \"cN\", rows = \"\"\"\nt, force\n0, 100\n50, 200\n100, 300\n\"\"\" }"));
  CHECK(distance(headed.reference.value, one.reference.value) == 0);
  CHECK(one.reference_error < 1e-14);
  for (const std::string heading : {"\u00b5s,m", "(s),m", "# a,b", "\"t [s]\";\"F [N]\"", "t,F\n(s),(N)\n"})
    CHECK(distance(last(pushed("{ x = \"cs\", y = \"cN\", rows = '''\n" + heading +
                               "\n0, 100\n\"50\",\"200\"\n100, 300\n''' }"))
                       .reference.value,
                   one.reference.value) == 0);
  // Its argument may be an unknown, and its rate follows.
  const Quantity other =
      last(pushed(R"({ x = "m", y = "N", outside = "hold", rows = [[-9, 9], [0, 0], [9, -9]] })",
                  "[need]\nhorizon = \"1 s\"\n", "push(y) + 1 N"));
  CHECK(near(other.reference.value[0], 1 - std::cos(1), 1e-13));
}

TEST_CASE("An error in a table is reported with its place", "[problem][tables]") {
  CHECK(refusal(pushed(R"({ x = "s", y = "N", rows = [[0, 0], [1, 1], [2, 0]] })")) == "nothing");
  CHECK(
      refusal(pushed(R"({ x = "s", y = "N", rows = [[0, 0], [0.5, 1], [0.9, 0]] })")) ==
      "table push is known from 0 to 0.9 (in s), and at t = 1 s it is asked for 1: add rows, or outside = \"hold\"");
  CHECK(refusal(pushed(R"({ x = "s", y = "N", rows = [[0, 0], [1, 1], [1, 0]] })")) ==
        "test.toml:5:52: x goes up from row to row");
  CHECK(refusal(pushed(R"({ x = "s", y = "N", rows = [[0, 0], [1, 1]] })")).find("takes at least 3 rows") !=
        std::string::npos);
  CHECK(
      refusal(pushed(R"({ x = "s", y = "N", rows = [[0, 0], [1, 1, 1]] })")).find("a row has two numbers") !=
      std::string::npos);
  CHECK(refusal(pushed("{ x = \"s\", y = \"N\", rows = \"\"\"\n0, 0\n1, one\n2, 0\"\"\" }")) ==
        "test.toml:7:1: expected two numbers, as 0.1, 5");
  for (const std::string row : {"nan, 5", "5, inf", "1", "t, 5", "1, 2, 3"})
    CHECK(refusal(pushed("{ x = \"s\", y = \"N\", rows = \"\"\"\n" + row + "\n0, 0\n1, 1\n2, 0\"\"\" }"))
              .starts_with("test.toml:6:1: "));
  CHECK(refusal(pushed("{ x = \"s\", y = \"N\", rows = \"\"\"\n0, 0\ns, N\n1, 1\n2, 0\"\"\" }")) ==
        "test.toml:7:1: expected two numbers, as 0.1, 5");
  for (const std::string spline : {"linear", "cubic", "monotone"})
    CHECK(refusal(pushed("{ x = \"s\", y = \"N\", spline = \"" + spline +
                         "\", rows = [[0, 0],\n[1e-320, 1],\n[2, 0], [3, 0]] }")) ==
          "test.toml:6:1: this row is too close to the one before for a curve through both: leave one out");
  CHECK(refusal(pushed(R"({ x = "s", y = "N", file = "push.csv" })")).find("no key file in table push") !=
        std::string::npos);
  CHECK(refusal(pushed(R"({ x = "s", y = "m", rows = [[0, 0], [1, 1], [2, 0]] })"))
            .find("the left side is N, and the right side m") != std::string::npos);
  CHECK(refusal(pushed(R"({ x = "m", y = "N", rows = [[0, 0], [1, 1], [2, 0]] })"))
            .find("push is a table of m, and this is s") != std::string::npos);
  CHECK(refusal(pushed(R"({ x = "s", y = "N", spline = "quintic", rows = [[0, 0], [1, 1], [2, 0]] })"))
            .find("spline is one of: linear, cubic, monotone") != std::string::npos);
  CHECK(refusal(pushed(R"({ x = "s", y = "N", rows = [[0, 0], [1, nan], [2, 0]] })"))
            .find("no finite number") != std::string::npos);
  CHECK(refusal(pushed(R"({ x = "s", y = "N", rows = [[0, 0], [1, 1], [2, 0]] })", "", "push"))
            .find("expected ( behind push") != std::string::npos);
  std::string many;
  for (int i = 0; i < 300; ++i) many += (i > 0 ? ", [" : "[") + std::to_string(i) + ", 0]";
  CHECK(refusal(pushed("{ x = \"s\", y = \"N\", rows = [" + many + "] }")).find("at most 200 rows") !=
        std::string::npos);
}

TEST_CASE("Two hundred rows are answered within a second of CPU time", "[problem][tables]") {
  std::string rows;
  for (int i = 0; i < 200; ++i)
    rows += (i > 0 ? ", [" : "[") + std::to_string(i) + "e-2, " + format_shortest(std::sin(i * 0.1)) + "]";
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const Entry& entry = entry_of_text("test.toml", pushed("{ x = \"s\", y = \"N\", rows = [" + rows + "] }"));
  const Quantity seen =
      motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), {1, 1, 60}, truth);
  // The spline's distance from the sine is of fourth order in its knots.
  CHECK(near(seen.reference.value[seen.reference.value.size() - 1], 0.1 * (1 - std::sin(10.0) / 10), 1e-6));
}
