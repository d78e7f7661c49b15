#include <tbb/global_control.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/verdicts.hpp"
#include "report/charts/chart.hpp"
#include "report/charts/stability_map.hpp"
#include "report/pages/catalog_page.hpp"
#include "report/pages/claims.hpp"
#include "report/pages/markdown.hpp"
#include "report/pages/quantities.hpp"
#include "report/pages/text_view.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/perturb_results.hpp"
#include "report/study/run.hpp"
#include "report/study/stability.hpp"
#include "report/text/svg.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/run_of_all.hpp"
#include "tests/sample_results.hpp"

using namespace oddity;

namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

std::string page_of(const Results& results) { return exercise_page_text(results, results.exercises[0]); }

/// Plain $formulas$ of a Markdown page in which Markdown would remove a backslash, and lines with unclosed
/// formulas in GitHub's form.
std::vector<std::string> spoilt_formulas(const std::string& page) {
  std::vector<std::string> spoilt;
  std::istringstream lines(page);
  bool fenced = false;
  for (std::string line; std::getline(lines, line);) {
    const auto begins = line.find_first_not_of(' ');
    const bool fence_line = begins != std::string::npos && line.compare(begins, 3, "```") == 0;
    if (fence_line) fenced = !fenced;
    if (fence_line || fenced) continue;
    for (std::size_t at = 0; (at = line.find_first_of("\\$`", at)) != std::string::npos;) {
      const bool math = line[at] == '$', github = math && line.compare(at, 2, "$`") == 0;
      if (line[at] == '\\') {
        at += 2;
        continue;
      }
      const std::size_t fence = math ? 1 : std::min(line.find_first_not_of('`', at), line.size()) - at;
      const std::string close = github ? "`$" : math ? "$" : std::string(fence, '`');
      const std::size_t begin = at + close.size(), end = line.find(close, begin);
      if (end == std::string::npos) {
        spoilt.push_back(line);
        break;
      }
      const std::string inside = line.substr(begin, end - begin);
      for (std::size_t i = 0; math && !github && i + 1 < inside.size(); ++i)
        if (inside[i] == '\\' && std::ispunct(static_cast<unsigned char>(inside[i + 1])) != 0)
          spoilt.push_back(inside);
      at = end + close.size();
    }
  }
  return spoilt;
}

}  // namespace

TEST_CASE("results survive conversion to JSON and back", "[report]") {
  const Results results = sample();
  const std::string json = to_json(results);
  CHECK(to_json(results_from_json(json, "here")) == json);
  for (const char* key :
       {"\"number\": \"3.5\"", "\"claims\"", "\"verdict\": \"confirmed\"", "\"reference_error\"",
        "\"trials\"", "\"evaluations\": 42", "\"seconds\"", "\"outcome\": \"ok\"", "\"resolution\": 0.5",
        "\"trajectory\"", "\"printed\": \"y = 1\"", "\"reading\": \"meant\"",
        "\"readings\": {}"})  // for a claim that is not checkable: none without a comparison
    CHECK(json.find(key) != std::string::npos);
}

TEST_CASE("numbers that are not finite become null and come back as NaN", "[report]") {
  Results results = sample();
  results.exercises[0].quantities[0].methods[0].trials[0].error_estimate =
      std::numeric_limits<double>::infinity();
  const Results read = results_from_json(to_json(results), "here");
  CHECK(std::isnan(read.exercises[0].quantities[0].methods[0].trials[0].error_estimate));
}

TEST_CASE("a model's error at a border survives conversion: none, NaN and infinite", "[report]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Results results = sample();
  BreakEven border{"one angle", "a", "rad", {0, 1}, {{0, 0.5}}};
  border.holding = {std::numeric_limits<double>::quiet_NaN()};
  border.failing = {1.5, infinity};
  results.exercises[0].cheapest_models = CheapestModels{{"rad"}, {{"1 degree", {0.1}, {}}}, {border}, {}};
  const Results read = results_from_json(to_json(results), "here");
  REQUIRE(read.exercises[0].cheapest_models);
  const BreakEven& back = read.exercises[0].cheapest_models->break_evens.at(0);
  REQUIRE(back.enough.size() == 1);
  CHECK(back.enough[0].to == 0.5);
  REQUIRE(back.holding.size() == 1);
  CHECK(std::isnan(back.holding[0]));
  CHECK(back.failing == border.failing);
}

TEST_CASE("a file that is no results file is refused with the place of the fault", "[report]") {
  CHECK_THROWS_AS(results_from_json("{}", "here"), BadInput);
  CHECK_THROWS_AS(results_from_json("{\"format\": 1, \"exercises\": [{}]}", "here"), BadInput);
  CHECK_THROWS_AS(results_from_json("not JSON", "here"), BadInput);
}

TEST_CASE("a results file that would lead to nonsense is refused", "[report]") {
  const auto refused = [](const auto& spoil) {
    Results results = sample();
    spoil(results.exercises[0]);
    return complaint([&] { results_from_json(to_json(results), "here"); });
  };
  using E = ExerciseResult;
  CHECK(refused([](E&) {}) == "nothing");
  CHECK(refused([](E& e) { e.quantities[0].methods[0].trials.clear(); }).find("no trials") !=
        std::string::npos);
  CHECK(refused([](E& e) { e.quantities[0].trajectory->times.clear(); }).find("times") != std::string::npos);
  CHECK(refused([](E& e) { e.quantities[0].trajectory->judged_at.clear(); }).find("times") !=
        std::string::npos);
  CHECK(refused([](E& e) {
          e.quantities[0].trajectory->judged_at = {1, 2, 3};
        }).find("times") != std::string::npos);
  CHECK(refused([](E& e) {
          e.quantities[0].trajectory->paths[0].value = {1, 2, 3};
        }).find("path") != std::string::npos);
  CHECK(refused([](E& e) {
          e.quantities[0].trajectory->paths[0].value = Value(std::vector<double>());
        }).find("path") != std::string::npos);
  CHECK(refused([](E& e) { e.stability->steps.clear(); }).find("map") != std::string::npos);
  CHECK(refused([](E& e) { e.stability->map[0].outcomes.pop_back(); }).find("map") != std::string::npos);
  CHECK(refused([](E& e) { e.stability->map[0].fragile.pop_back(); }).find("map") != std::string::npos);
}

TEST_CASE("a perturbed result that a check does not notice is named", "[report]") {
  CHECK(unnoticed_perturbations(judged(one_against_one(1e-9))).empty());
  CHECK(unnoticed_perturbations(judged(one_against_one(0))).empty());
  CHECK(unnoticed_perturbations(judged(one_against_one(1.5))) ==
        std::vector<std::string>{"9.9-x, x: a factor of two"});
  const Check zero{"x", {"a", 0}, {"b", 0}, {1e-9, "a test"}};
  CHECK(unnoticed_perturbations(judged(zero)).size() == 2);
  const Check scaled_zero{"x", {"a", 0}, {"b", 0}, {1e-9, "a test"}, 1};
  CHECK(unnoticed_perturbations(judged(scaled_zero)).empty());
  Check rounded_zero = scaled_zero;
  rounded_zero.right.value = Value{1e-16};
  CHECK(unnoticed_perturbations(judged(rounded_zero)).empty());
  const Check large_zero{"x", {"a", 0}, {"b", 1e-8}, {1e-3, "a test"}, 1e6};  // except for roundings as well
  CHECK(unnoticed_perturbations(judged(large_zero)).empty());
}

TEST_CASE("a page escapes everything that Markdown would take for markup, except mathematics", "[report]") {
  Results results = sample();
  results.exercises[0].claims[0].claim.says = "a_1 * |b| with $a_1 * b$";
  const std::string page = page_of(results);
  CHECK(page.find("a\\_1 \\* |b| with $`a_1 * b`$") != std::string::npos);
}

TEST_CASE("the page of errata lists claims whose routes never differ although they might", "[report]") {
  Results results = sample();
  JudgedClaim& claim = results.exercises[0].claims[0];
  const std::string says = "1 claim equal to the last bit";
  CHECK(count(errata_page_text(results), says) == 1);
  claim.claim.printed.checks[0].right.value = Value(1 + 1e-12);
  CHECK(count(errata_page_text(results), says) == 0);
  claim.claim.printed.checks[0] = one_against_one(0);
  CHECK(count(errata_page_text(results), says) == 0);
}

TEST_CASE("pages contain no times, except the page of times", "[report]") {
  Results slow = sample(), fast = sample();
  fast.exercises[0].quantities[0].methods[0].trials[0].time.seconds = 1e-9;
  CHECK(index_page(slow) == index_page(fast));
  CHECK(page_of(slow) == page_of(fast));
  CHECK(times_page(slow) != times_page(fast));
}

TEST_CASE("a scene's chart of time shows the overhead of a call as a line", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  for (TimedTrial& t : q.methods[0].trials) t.time = {20e-9 * static_cast<double>(t.evaluations), 0};
  q.methods[0].trials.back().evaluations *= 4;
  q.methods[0].trials.back().error /= 4;
  const auto chart = [&](Across across, double seam) {
    return chart_svg(q, "title", across, Curves::few, seam);
  };
  CHECK(count(chart(Across::time, 15e-9), "type-erased calls alone, 15 ns a call") == 1);
  CHECK(count(chart(Across::time, NAN), "type-erased") == 0);
  CHECK(count(chart(Across::evaluations, 15e-9), "type-erased") == 0);
  q.trajectory.reset();
  CHECK(count(chart(Across::time, 15e-9), "type-erased") == 0);
}

TEST_CASE("a chart names its unit of work, and errors without a unit", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  CHECK(count(chart_svg(q, "title", Across::evaluations), ">evaluations of the right-hand side</text>") == 1);
  q.in_operations = true;
  q.unit = "1";
  const std::string svg = chart_svg(q, "title", Across::evaluations);
  CHECK(count(svg, ">multiplications, divisions and functions</text>") == 1);
  CHECK(count(svg, ">error (dimensionless)</text>") == 1);
}

TEST_CASE("charts contain no times, except the charts of time", "[report]") {
  Results slow = sample(), fast = sample();
  fast.exercises[0].quantities[0].methods[0].trials[0].time = {1e-9, 1e-10};
  const auto chart = [](const Results& results, Across across) {
    return chart_svg(results.exercises[0].quantities[0], "title", across);
  };
  CHECK(chart(slow, Across::evaluations) == chart(fast, Across::evaluations));
  CHECK(chart(slow, Across::setting) == chart(fast, Across::setting));
  CHECK(chart(slow, Across::time) != chart(fast, Across::time));
}

namespace {

std::string chart_of(const QuantityResult& q, Across across = Across::evaluations,
                     Curves curves = Curves::few) {
  return chart_svg(q, "title", across, curves);
}

/// A method whose trials take 100, 200, 400 evaluations, with halved errors.
MethodResult method(const std::string& model, const std::string& algorithm, double error) {
  MethodResult m{model, algorithm, Outcome::ok, "", {}};
  for (int k = 0; k < 3; ++k) {
    TimedTrial t;
    t.model = model, t.algorithm = algorithm, t.resolution = "step";
    t.setting = std::ldexp(1.0, -k);
    t.value = Value{1, 2};
    t.error = t.final_error = error;
    t.evaluations = 100L << k;
    t.outcome = error <= 0.3 ? Outcome::ok : Outcome::inaccurate;
    m.trials.push_back(t);
    error /= 2;
  }
  return m;
}

}  // namespace

TEST_CASE("a chart shows every trial, also those without a number, and names each kind of failure once",
          "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.methods = {method("a", "x", 0.1), method("a", "y", 0.2)};
  for (MethodResult& m : q.methods) {
    m.trials[0].outcome = Outcome::non_finite;
    m.trials[0].error = std::numeric_limits<double>::quiet_NaN();
  }
  const std::string svg = chart_of(q);
  CHECK(count(svg, ">N</text>") == 2);
  CHECK(count(svg, "N non-finite") == 1);
  CHECK(count(svg, "off the scale") == 1);
  CHECK(count(svg, "class=\"hollow c") == 2);
}

TEST_CASE("no two of a chart's eight curves share a colour and a mark, and a family keeps its own",
          "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.methods.clear();
  for (const char* name : {"Runge-Kutta 4", "explicit Euler", "velocity Verlet", "Bulirsch-Stoer",
                           "GSL msadams", "Rosenbrock 4", "own", "another"})
    q.methods.push_back(method("a", name, 0.1 / static_cast<double>(q.methods.size() + 1)));
  const std::string svg = chart_of(q);
  for (int slot = 0; slot < svg_slots; ++slot)
    CHECK(count(svg, "class=\"curve " + colour_class(slot) + "\"") == 1);
  QuantityResult alone = q;
  alone.methods = {q.methods[2], q.methods[0]};
  const auto colour = [](const std::string& text, const std::string& name) {
    const auto label = text.rfind(">" + name);
    return text.substr(text.rfind("class=\"mark ", label), 15);
  };
  CHECK(colour(svg, "velocity Verlet") == colour(chart_of(alone), "velocity Verlet"));
}

TEST_CASE("at most eight of many methods are drawn: from the front, of each model and family; all on request",
          "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.methods = {method("a", "best", 1e-3)};
  for (int i = 0; i < 9; ++i) q.methods.push_back(method("a", "worse " + std::to_string(i), 0.1));
  q.methods.push_back(method("b", "alone", 0.2));
  CHECK(worth_seeing(q, Across::evaluations) == std::vector<std::size_t>{0, 10});
  const std::string svg = chart_of(q);
  CHECK(count(svg, "9 methods are not drawn") == 1);
  CHECK(count(svg, "worse ") == 0);
  CHECK(count(svg, "alone") == 1);
  CHECK(count(chart_of(q, Across::evaluations, Curves::all), "worse ") == 17);  // and eight are on the first
  for (int i = 0; i < 12; ++i) q.methods.push_back(method("model " + std::to_string(i), "x", 0.2));
  CHECK(worth_seeing(q, Across::evaluations).size() == 8);
}

TEST_CASE("a curve that coincides with another is labelled so", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.methods = {method("a", "first", 0.1), method("a", "second", 0.1), method("a", "third", 0.2)};
  const std::string svg = chart_of(q);
  CHECK(count(svg, "second: as first") == 1);
  CHECK(count(svg, ": as ") == 1);
}

TEST_CASE("labels keep their order and do not overlap", "[report]") {
  CHECK(spread({10, 12, 50}, 5, 0, 100) == std::vector<double>{10, 15, 50});
  CHECK(spread({12, 10, 50}, 5, 0, 100) == std::vector<double>{15, 10, 50});
  CHECK(spread({98, 99}, 5, 0, 100) == std::vector<double>{95, 100});
  CHECK(spread({}, 5, 0, 100).empty());
}

TEST_CASE("a line keeps the points that the eye would miss, and no others", "[report]") {
  Svg svg(100, 100, "title");
  svg.curve({{0, 0}, {1, 1}, {2, 2}, {3, 9}, {NAN, NAN}, {5, 5}, {6, 5}}, "curve");
  CHECK(count(svg.str(), "d=\"M0 0l2 2 1 7M5 5l1 0\"") == 1);
}

TEST_CASE("a picture follows the page from light to dark", "[report]") {
  const std::string svg = Svg(100, 100, "a < b").str();
  CHECK(count(svg, "prefers-color-scheme:dark") == 1);
  CHECK(count(svg, "<title>a &lt; b</title>") == 1);
}

TEST_CASE("a chart's title states the result of the trials", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.methods = {method("a", "cheap", 2), method("b", "dear", 0.01)};
  q.methods[1].trials[0].evaluations = 12'345;
  CHECK(finding(q, Across::evaluations) == "dear (b) reaches 0.3 m with the least work: 200 evaluations");
  q.methods[1].trials[1].evaluations = q.methods[1].trials[2].evaluations = 1'234'567;
  CHECK(finding(q, Across::evaluations) == "dear (b) reaches 0.3 m with the least work: 12,345 evaluations");
  q.need.allowed = 1e-9;
  for (MethodResult& m : q.methods)
    for (TimedTrial& t : m.trials) t.outcome = Outcome::inaccurate;
  CHECK(finding(q, Across::evaluations) == "No method reaches 1×10⁻⁹ m; the closest is dear (b): 0.0025 m");
  CHECK(finding(q, Across::setting) ==
        "dear (b) is the most accurate of the methods with a step: 0.0025 m at step 0.25");
}

TEST_CASE("there is no chart of single points or of answers that are right or wrong", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.trajectory.reset();
  q.methods = {method("a", "x", 0.1), method("a", "y", 0.3)};
  CHECK(has_chart(q));
  QuantityResult whole = q, points = q;
  for (MethodResult& m : whole.methods)
    for (TimedTrial& t : m.trials) t.error = std::round(10 * t.error);
  CHECK_FALSE(has_chart(whole));
  for (MethodResult& m : points.methods) m.trials.resize(1);
  CHECK_FALSE(has_chart(points));
  CHECK(charts_of(points).empty());
}

TEST_CASE("if the work does not depend on the setting, the error is drawn over the setting", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.methods = {method("a", "x", 0.1), method("a", "y", 0.3)};
  CHECK(charts_of(q) == std::vector{Across::evaluations, Across::setting, Across::time});
  q.trajectory.reset();
  CHECK(charts_of(q) == std::vector{Across::evaluations, Across::time});
  for (MethodResult& m : q.methods)
    for (TimedTrial& t : m.trials) t.evaluations = 5;
  CHECK(charts_of(q) == std::vector{Across::setting});
  q.methods.push_back(method("a", "z", 0.2));
  CHECK(charts_of(q) == std::vector{Across::setting});  // one of three
  q.methods.push_back(method("a", "w", 0.2));
  CHECK(charts_of(q) == std::vector{Across::evaluations, Across::time});
}

TEST_CASE("a scene's charts have a line for the accuracy of a game", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.methods = {method("a", "x", 0.1), method("a", "y", 0.3)};
  q.trajectory->close = 0.05;
  CHECK(count(chart_of(q), "enough for a game: 0.05 m") == 1);
}

TEST_CASE("a motion that is off between the reference's times is off", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.trajectory->close = 0.3;
  q.trajectory->paths.push_back({"other", "algorithm", "step", 0.5, 0, Outcome::ok, {1.5, 2, 3, 4}});
  q.methods.push_back({"other", "algorithm", Outcome::ok, "", q.methods[0].trials});
  CHECK(motion_finding(q) ==
        "1 of 2 models follow the truth within 0.3 m for 1 s; 'other': off by up to 0.5 m");
  CHECK(count(trajectory_svg(q, "title"), "off by up to 0.5") ==
        3);  // in the title, the headline, the legend
  q.trajectory->close = 1;
  CHECK(motion_finding(q) == "All 2 models follow the truth within 1 m for 1 s");
}

TEST_CASE("motions that look the same name each other; flat ones are not drawn to scale", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.trajectory->paths.push_back({"b", "algorithm", "step", 0.5, 0.26, Outcome::ok, {1.001, 2, 3, 4}});
  q.trajectory->paths.push_back({"c", "algorithm", "step", 0.5, 0.27, Outcome::ok, {1.001, 2.001, 3, 4}});
  q.methods.push_back({"b", "algorithm", Outcome::ok, "", q.methods[0].trials});
  q.methods.push_back({"c", "algorithm", Outcome::ok, "", q.methods[0].trials});
  CHECK(count(trajectory_svg(q, "title"), "hidden by 'c'") == 1);
  CHECK(count(trajectory_svg(q, "title"), "not to the scale of y") == 0);
  q.trajectory->paths[0].value = {1, 2, 1.1, 4};
  CHECK(count(trajectory_svg(q, "title"), "not to the scale of y") == 1);
}

TEST_CASE("a motion of many observables is drawn as its distance from the reference", "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  Trajectory& t = *q.trajectory;
  t.observables = {};
  q.reference.value = Value(std::vector<double>(7, 1));
  t.paths[0].value = Value(std::vector<double>(14, 1));
  CHECK(count(trajectory_svg(q, "title"), "largest error of 7 components") == 1);
}

TEST_CASE("a map is as wide as a page, and its letters are legible", "[report]") {
  ExerciseResult e = sample().exercises[0];
  Stability& s = e.stability.emplace();
  s.steps = {1, 0.5};
  s.parameter = "a";
  s.time_unit = "s";
  for (int i = 0; i < 30; ++i)
    for (double value : {0.1, 0.2, 0.3})
      s.map.push_back({"model",
                       "algorithm " + std::to_string(i),
                       value,
                       0.7,
                       {Outcome::diverged, Outcome::ok},
                       {false, false}});
  s.map.back().outcomes = {Outcome::ok, Outcome::inaccurate};
  CHECK(count(map_svg(e), "roundings decide") == 0);
  s.map.back().fragile = {false, true};
  const std::string svg = map_svg(e);
  CHECK(count(svg, "roundings decide") == 1);
  CHECK(count(svg, "<path class=\"on-i\"") == 2);  // the corner of the cell, and of the legend's
  CHECK(count(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\"") == 1);
  CHECK(count(svg, "algorithm 0 (model) is ok at every a up to the longest step, 0.5 s</text>") == 1);
  CHECK(count(svg, ">X</text>") == 29 * 3 + 2 + 1);  // the last in the legend
  for (auto at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) {
    const std::string tag = svg.substr(at, svg.find('>', at) - at);
    const auto x = tag.find(" x=\"") + 4;
    INFO(tag << " has one place: some viewers take the first of several for all letters");
    CHECK((x < 4 || tag.substr(x, tag.find('"', x) - x).find(' ') == std::string::npos));
  }
  for (auto at = svg.find("font-size:"); at != std::string::npos; at = svg.find("font-size:", at + 1))
    CHECK(std::stoi(svg.substr(at + 10)) >= 9);
}

TEST_CASE("quantities of growing size share one chart", "[report]") {
  ExerciseResult e = sample().exercises[0];
  QuantityResult q = e.quantities[0];
  e.quantities.clear();
  for (int n : {100, 10, 1000}) {
    q.name = "chain_of_" + std::to_string(n);
    q.methods = {method("a", "x", 0.1)};
    q.methods[0].trials.resize(1);
    q.methods[0].trials[0].evaluations = 5L * n * n;
    e.quantities.push_back(q);
  }
  const auto series = series_of(e);
  REQUIRE(series.size() == 1);
  CHECK(series[0][0]->name == "chain_of_10");
  const std::string svg = series_svg(series[0], "title");
  CHECK(count(svg, "work ~ n^2") == 1);
  CHECK(count(svg, "5,000,000 for n = 1000</text>") == 1);
  e.quantities.pop_back();
  CHECK(series_of(e).empty());
}

TEST_CASE("colour-blind readers can distinguish any two outcomes of a map", "[report]") {
  using Three = std::array<double, 3>;
  // Machado, Oliveira and Fernandes (2009), severity 1.
  const std::array<std::array<Three, 3>, 3> eyes{
      {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
       {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
       {{{0.152286, 1.052583, -0.204868},
         {0.114503, 0.786281, 0.099216},
         {-0.003882, -0.048116, 1.051998}}}}};
  const auto times = [](const std::array<Three, 3>& m, const Three& x) {
    Three y{};
    for (std::size_t i = 0; i < 3; ++i) y[i] = m[i][0] * x[0] + m[i][1] * x[1] + m[i][2] * x[2];
    return y;
  };
  const auto lab = [&](std::string_view colour, const std::array<Three, 3>& eye) {
    Three rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double c = std::stoi(std::string(colour.substr(1 + 2 * i, 2)), nullptr, 16) / 255.0;
      rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    rgb = times(eye, rgb);
    for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
    Three xyz = times({{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}}, rgb);
    const Three white{0.95047, 1, 1.08883};
    for (std::size_t i = 0; i < 3; ++i) {
      const double t = xyz[i] / white[i];
      xyz[i] = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
    }
    return Three{116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
  };
  for (const auto& eye : eyes)
    for (Outcome a : outcomes_of_a_map)
      for (Outcome b : outcomes_of_a_map) {
        if (a == b) continue;
        const Three p = lab(colour_of(a), eye), q = lab(colour_of(b), eye);
        INFO(name_of(a) << " and " << name_of(b));
        CHECK(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) > 20);
      }
}

TEST_CASE("the failing check is shown, NaN before all", "[report]") {
  JudgedClaim claim = judged(one_against_one(1e-9));
  const Check nan{"x", {"a", NAN}, {"the one that decides", 1}, {1e-9, "a test"}};
  const Check off{"x", {"a", 2}, {"the one that is off", 1}, {1e-9, "a test"}};
  Results results = sample();
  const auto page = [&](std::vector<Check> checks) {
    claim.claim.printed.checks = std::move(checks);
    claim.claim.corrected = {"x = 1", {one_against_one(1e-9)}};
    claim.verdict = verdict(claim.claim);
    CHECK(claim.verdict == Verdict::wrong);
    results.exercises[0].claims = {claim};
    return page_of(results);
  };
  const Check tight = one_against_one(0.1);
  CHECK(count(page({tight, nan, tight}), "the one that decides") == 1);
  CHECK(count(page({tight, off, nan}), "the one that decides") == 1);
  CHECK(count(page({tight, off}), "the one that is off") == 1);
}

TEST_CASE("a finding names its comparison and the result", "[report]") {
  Results results = sample();
  const auto page = [&](const Check& printed) {
    JudgedClaim wrong = judged(printed);
    wrong.claim.corrected = {"x = 1", {one_against_one(1e-9)}};
    wrong.verdict = verdict(wrong.claim);
    results.exercises[0].claims = {wrong};
    return page_of(results);
  };
  CHECK(count(page({"squared", {"by hand", 2.5}, {"by sums", 1}, {1e-9, "a test"}}),
              "*by sums* (1): print off by 1.5, correction equal.") == 1);
  CHECK(count(page({"squared", {"by hand", 2.5}, {"by sums", 1}, {1e-9, "a test"}, 0, "worst of 3"}),
              "*by sums*: print off by 1.5, correction equal.") == 1);
  CHECK(count(page(no_violations("the sign is right", 49, 200)), "It fails in 49 of 200 samples.") == 1);
}

TEST_CASE("confirmed claims are a line each below their comparison", "[report]") {
  Results results = sample();
  JudgedClaim one = judged(one_against_one(1e-9)), other = one;
  other.claim.says = "x is still 1";
  results.exercises[0].claims = {one, judged(no_violations("the sign is right", 0, 200)), other};
  const std::string page = page_of(results);
  CHECK(count(page,
              "<summary>3 confirmed claims</summary>\n\n"
              "*b:*<br>1:&nbsp;x is 1<br>1:&nbsp;x is still 1\n") == 1);
  CHECK(count(page, "*In 200 samples:*<br>1:&nbsp;x is 1\n") == 1);
}

TEST_CASE("a claim lost in our copy is shown with its evidence from other lines", "[report][claims]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const std::regex lines("[Ll]ines? ([0-9]+)(?: and ([0-9]+))?");
  int seen = 0;
  for (const Entry& entry : registry())
    for (const Claim& claim : entry.exercise.study(Parameters(entry.exercise.parameters), truth).claims) {
      if (verdict(claim) != Verdict::lost) continue;
      ExerciseResult alone;
      alone.claims = {{claim, Verdict::lost}};
      const std::string shown = wrong_claims(alone, {});
      INFO(claim.id << ": " << claim.why);
      for (std::sregex_iterator at(claim.why.begin(), claim.why.end(), lines), end; at != end; ++at, ++seen)
        CHECK(shown.find(at->str()) != std::string::npos);
    }
  CHECK(seen > 10);
}

TEST_CASE("a row of forms is not shown again next to a claim that states each of them", "[report]") {
  Claim claim{.says = "$v=r(1+ex)=r+exr$", .printed = {R"($(r(1+ex),\ r+exr)$)", {}}};
  CHECK(shows_each_form(claim));
  CHECK_FALSE(shows_printed(claim));
  for (const char* other : {R"($(r(1+ex),\ r+ex)r$)", R"($(r(1+ex),\ r-exr)$)", "$(r,v)$"}) {
    claim.printed.text = other;
    CHECK_FALSE(shows_each_form(claim));
  }
}

TEST_CASE("long decimals of a sample are shortened as long as they identify it", "[report]") {
  CHECK(with_short_numbers("t = -0.0020877287373640423, n = 5760") == "t = -0.00208773, n = 5760");
  CHECK(with_short_numbers("x = 1.25, 123456789012 of 2.480000000001e+03") ==
        "x = 1.25, 123456789012 of 2480");
  CHECK(with_short_numbers("") == "");
}

TEST_CASE("errata come first, each with an anchor, and confirmed claims are folded up", "[report]") {
  Results results = sample();
  JudgedClaim wrong = judged(one_against_one(1e-9)), misprint = wrong;
  wrong.claim.id = "3.5-wrong";
  wrong.claim.why = "It is not so.";
  wrong.claim.printed = {"x = 2", {{"x", {"a", 2}, {"b", 1}, {1e-9, "a test"}}}};
  misprint.claim = wrong.claim;
  wrong.claim.corrected = misprint.claim.meant = {"x = 1", {one_against_one(1e-9)}};
  misprint.claim.id = "3.5-lost_bar";
  wrong.verdict = verdict(wrong.claim);
  wrong.claim.kind = Fault::number;
  wrong.claim.root = "a slip";
  JudgedClaim follows = wrong;
  follows.claim.id = "3.5-follows";
  results.exercises[0].roots = {{"a slip", "1 m too far"}};
  misprint.verdict = verdict(misprint.claim);
  results.exercises[0].claims.push_back(misprint);
  results.exercises[0].claims.push_back(wrong);
  results.exercises[0].claims.push_back(follows);
  const std::string page = page_of(results), index = index_page(results);
  const auto erratum = page.find("<a id=\"3.5-wrong\"></a>"), bar = page.find("<a id=\"3.5-lost_bar\"></a>"),
             folded = page.find("<details><summary>1 confirmed claim</summary>");
  REQUIRE(erratum != std::string::npos);
  REQUIRE(folded != std::string::npos);
  CHECK(erratum < bar);
  CHECK(bar < folded);
  const std::string errata = errata_page_text(results);
  CHECK(count(index, "Errata of the solutions manual") == 1);
  CHECK(count(index, "| [3.5 A slip](3.5.md#3.5-wrong) | 1 m too far |") == 1);
  CHECK(count(page, "| [A slip](#3.5-wrong) | x = 2 | x = 1 | 1 m too far |") == 1);
  CHECK(count(errata,
              "[3.5-wrong](3.5.md#3.5-wrong), [3.5-follows](3.5.md#3.5-follows) | "
              "x = 2 | x = 1 | 1 m too far |") == 1);
  CHECK(count(errata, "## Misprints (1)") == 1);
  wrong.claim.says = "It ends in a full stop.";
  results.exercises[0].claims.push_back(wrong);
  CHECK(count(page_of(results), "It ends in a full stop. *") +
            count(page_of(results), "It ends in a full stop.\n") ==
        1);
  CHECK(count(errata, "[3.5-lost\\_bar](3.5.md#3.5-lost_bar)") == 1);
}

TEST_CASE("errata that break a scene come first, and among these wrong formulas before missing cases",
          "[report]") {
  Results results = sample();
  ExerciseResult& scene = results.exercises[0];
  JudgedClaim wrong = judged({"x", {"a", 2}, {"b", 1}, {1e-9, "a test"}});
  wrong.claim.corrected = {"x = 1", {one_against_one(1e-9)}};
  wrong.verdict = verdict(wrong.claim);
  const auto erratum = [&](const std::string& root, Fault kind) {
    wrong.claim.id = root;
    wrong.claim.root = root;
    wrong.claim.kind = kind;
    return wrong;
  };
  scene.claims = {erratum("left out", Fault::left_out), erratum("formula", Fault::formula),
                  erratum("twice", Fault::formula), erratum("twice", Fault::term)};
  scene.roots = {{"left out", ""}, {"formula", ""}, {"twice", ""}, {"elsewhere", ""}};
  results.exercises.push_back(results.exercises[0]);
  results.exercises[1].scene = false;
  results.exercises[1].claims = {erratum("elsewhere", Fault::formula)};
  std::vector<std::string> names;
  for (const Finding& f : errata_worst_first(results)) names.push_back(f.title());
  CHECK(names == std::vector<std::string>{"Twice", "Formula", "Left out", "Elsewhere"});
}

TEST_CASE("an exercise's verdict is a sentence that agrees with its findings", "[report]") {
  ExerciseResult e = sample().exercises[0];
  JudgedClaim wrong = judged({"x", {"a", 2}, {"b", 1}, {1e-9, "a test"}});
  wrong.claim.corrected = {"x = 1", {one_against_one(1e-9)}};
  wrong.verdict = verdict(wrong.claim);
  e.claims.clear();
  for (const char* root : {"a sign", "a factor", "a term"}) {
    wrong.claim.root = root;
    e.claims.push_back(wrong);
    e.roots.push_back({root, ""});
  }
  const InMarkup links{
      [](const Finding& f, const std::string& words) { return "[" + words + "](" + f.title() + ")"; },
      [](const std::string& words) { return words; }};
  const auto said = [&](const std::string& verdict) {
    e.verdict = verdict;
    return verdict_of(e, links);
  };
  std::vector<JudgedClaim> all_wrong = e.claims;
  for (std::size_t i : {1u, 2u}) {
    e.claims[i].claim.in_view = {"for x > 1", {one_against_one(1e-9)}};
    e.claims[i].verdict = verdict(e.claims[i].claim);
    REQUIRE(e.claims[i].verdict == Verdict::incomplete);
  }
  CHECK(said("The orbit is right; {{a sign|one sign}} is wrong, and {{rest}} are small.") ==
        "The orbit is right; [one sign](A sign) is wrong, and 2 more findings are small.");
  e.claims.swap(all_wrong);
  CHECK(said("{{a sign}}, {{a factor}} and {{a term}}.") ==
        "[a sign](A sign), [a factor](A factor) and [a term](A term).");
  CHECK(said("") == "Wrong or incomplete: [A sign](A sign); [A factor](A factor); [A term](A term).");
  for (const std::string false_one :
       {"{{a sign}} and {{a factor}}.", "{{a sign}}, {{a factor}} and {{rest}}.",
        "{{a sign}}, {{a digit}} and {{rest}}.", "{{a sign}}, {{a factor}}, {{a term}} and {{rest}}.",
        "All of it is right.", "{{a sign"}) {
    INFO(false_one);
    CHECK_THROWS_AS(said(false_one), std::logic_error);
  }
  e.claims.clear();
  CHECK_THROWS_AS(said("{{a sign}} is wrong."), std::logic_error);
}

TEST_CASE("the errata whose motions have the largest errors come first of all", "[report]") {
  Results results = sample();
  JudgedClaim wrong = judged({"x", {"a", 2}, {"b", 1}, {1e-9, "a test"}});
  wrong.claim.corrected = {"x = 1", {one_against_one(1e-9)}};
  wrong.verdict = verdict(wrong.claim);
  const auto erratum = [&](const std::string& root, Fault kind) {
    wrong.claim.root = root;
    wrong.claim.kind = kind;
    return wrong;
  };
  const auto scene = [&](const std::string& root, double published_error) {
    ExerciseResult e = sample().exercises[0];
    e.claims = {erratum(root, Fault::left_out), erratum("beside " + root, Fault::left_out)};
    e.roots = {{root, ""}, {"beside " + root, ""}};
    e.quantities[0].trajectory->close = 0.01;
    e.quantities[0].trajectory->paths[0].model = "as published";
    e.quantities[0].trajectory->paths[0].error = published_error;
    return e;
  };
  results.exercises = {scene("enough", 0.009), scene("off", 0.02), scene("gone", NAN), scene("far off", 2)};
  CHECK(broken_by(results.exercises[0]) == 0);
  CHECK(broken_by(results.exercises[1]) == 2);
  CHECK(broken_by(results.exercises[2]) == INFINITY);
  std::vector<std::string> names;
  for (const Finding& f : errata_worst_first(results)) names.push_back(f.title());
  CHECK(names == std::vector<std::string>{"Gone", "Far off", "Off", "Enough", "Beside enough", "Beside off",
                                          "Beside gone", "Beside far off"});
}

TEST_CASE("a reason for failing is given only where a method is seen to fail as expected", "[report]") {
  Results results = sample();
  MethodResult& m = results.exercises[0].quantities[0].methods[0];
  m.why = "it is too coarse";
  CHECK(count(page_of(results), "it is too coarse") == 0);
  m.expected = Outcome::inaccurate;
  CHECK(count(page_of(results), "it is too coarse") == 0);
  CHECK(count(page_of(results), "- model, algorithm ends **ok** (expected inaccurate).") == 1);
  m.asserted = false;
  CHECK(count(page_of(results), "- model, algorithm ends **ok** at these parameters (usually inaccurate).") ==
        1);
  m.trials.back().outcome = Outcome::inaccurate;
  CHECK(count(page_of(results), "- model, algorithm: it is too coarse.") == 1);
  CHECK(count(page_of(results), " ends **") == 0);
}

TEST_CASE("a breakdown that does not break at these parameters is shown so", "[report]") {
  Results results = sample();
  CHECK(count(page_of(results), "**Breaks.** it breaks") == 2);
  results.exercises[0].quantities[0].breakdowns[0].expected = Outcome::drifted;
  CHECK(count(page_of(results), "**Breaks.** it breaks") == 1);
  CHECK(count(page_of(results), "**Does not break so here.** it breaks") == 1);
}

TEST_CASE(
    "outcomes of motions are asserted at an exercise's own parameters, declared ones in the whole ranges",
    "[report]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const auto asserted = [&](Number number, const char* parameter, double value, const char* quantity) {
    Task task(*std::ranges::find(registry(), number, &Entry::number));
    task.parameters.set(parameter, value);
    const Results results = run(std::span(&task, 1), truth, false);
    const auto& all = results.exercises[0].quantities;
    return std::ranges::all_of(std::ranges::find(all, quantity, &QuantityResult::name)->methods,
                               &MethodResult::asserted);
  };
  CHECK(asserted({3, 5}, "L", 1, "swing"));
  CHECK_FALSE(asserted({3, 5}, "L", 2, "swing"));
  CHECK(asserted({8, 1}, "a1", 3, "coordinates"));
  const Entry& of_3_19 = *std::ranges::find(registry(), Number{3, 19}, &Entry::number);
  CHECK(of_3_19.exercise.expected == Expected::at_own_parameters);
}

TEST_CASE("a scene's method of low order has a reason only where it is expected to fail", "[report]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    const Parameters parameters(entry.exercise.parameters);
    for (const Quantity& q : entry.exercise.study(parameters, truth).quantities)
      for (const Method& m : q.methods) {
        INFO(to_string(entry.number) << " " << q.name << ": " << m.model << ", " << m.algorithm);
        CHECK_FALSE((m.expected == Outcome::ok && m.why.starts_with("its order is too low")));
      }
  }
}

TEST_CASE("a run does not depend on the number of threads, nor on other runs", "[report]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const std::vector<Task> all(registry().begin(), registry().end());
  const auto by_threads = [&](std::size_t threads) {
    const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
    return to_json(run(all, truth, false));
  };
  const std::string alone = by_threads(1);
  CHECK((alone == by_threads(4)));
  Results one_by_one;
  for (const Task& task : std::vector<Task>(registry().begin(), registry().end()))
    one_by_one.exercises.push_back(run(std::span(&task, 1), truth, false).exercises.front());
  CHECK((alone == to_json(one_by_one)));
}

TEST_CASE("every scene's motion can be drawn, and its most accurate path agrees with the reference",
          "[report]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  std::vector<Task> scenes;
  for (const Entry& entry : registry())
    if (entry.exercise.scene) scenes.emplace_back(entry);
  int drawn = 0;
  for (const ExerciseResult& e : run(scenes, truth, false).exercises)
    for (const QuantityResult& q : e.quantities) {
      if (!q.trajectory) continue;
      ++drawn;
      INFO(to_string(e.number) << " " << q.name);
      const Trajectory& t = *q.trajectory;
      const Value& path = t.paths.at(t.truest).value;
      const std::size_t n = path.size() / t.times.size(), every = t.times.size() / t.judged_at.size();
      CHECK((t.observables.empty() || t.observables.size() == n));
      REQUIRE(q.reference.value.size() == n * t.judged_at.size());
      const double allowed = q.need.allowed + 1e-6 * size_of(q.reference.value);
      for (std::size_t i = 0; i < t.judged_at.size(); ++i)
        for (std::size_t k = 0; k < n; ++k)
          CHECK(std::abs(path[((i + 1) * every - 1) * n + k] - q.reference.value[i * n + k]) <= allowed);
    }
  CHECK(drawn == static_cast<int>(scenes.size()));
}

TEST_CASE("Markdown removes nothing from a formula", "[report]") {
  using Lines = std::vector<std::string>;
  CHECK(spoilt_formulas("$a\\,b$ and $`a\\,b`$ and `$a\\,b$`") == Lines{"a\\,b"});
  CHECK(spoilt_formulas("$`a\\,b$").size() == 1);
  CHECK(spoilt_formulas(index_page(run_of_all())) == Lines());
  CHECK(spoilt_formulas(errata_page_text(run_of_all())) == Lines());
  CHECK(spoilt_formulas(single_page(run_of_all())) == Lines());
  CHECK(spoilt_formulas(catalog_page()) == Lines());
  for (const ExerciseResult& e : run_of_all().exercises)
    CHECK(spoilt_formulas(exercise_page_text(run_of_all(), e)) == Lines());
  for (const auto& file : std::filesystem::directory_iterator(ODDITY_SOURCE))
    if (file.path().extension() == ".md") {
      INFO(file.path());
      std::ifstream in(file.path());
      CHECK(spoilt_formulas({std::istreambuf_iterator<char>(in), {}}) == Lines());
    }
}

TEST_CASE("exercise numbers are read as they are written", "[report]") {
  CHECK(exercise_number("3.5") == Number{3, 5});
  CHECK(exercise_number("13.25") == Number{13, 25});
  for (const char* wrong : {"", "3", "3.", ".5", "3.5x", "x", "3,5", "3.5.1"})
    CHECK_FALSE(exercise_number(wrong));
}

TEST_CASE("the book has 48 odd exercises", "[report]") {
  int odd = 0;
  for (const Chapter& chapter : chapters()) odd += (chapter.last_odd + 1) / 2;
  CHECK(odd == 48);
  for (const Number own : {Number{3, 2}, {3, 37}, {4, 1}, {15, 1}, {2, 19}, {3, -1}})
    CHECK_FALSE(of_the_book(own));
  for (const Number n : {Number{2, 1}, {3, 35}, {9, 1}}) CHECK(of_the_book(n));
}

TEST_CASE("a motion is everywhere reported as judged only at its instants", "[report]") {
  const std::string says = "judged at these 4 times alone";
  Results results = sample();
  const auto count_in = [&](const std::string& text) {
    std::size_t count = 0;
    for (auto at = text.find(says); at != std::string::npos; at = text.find(says, at + 1)) ++count;
    return count;
  };
  ExerciseResult& e = results.exercises[0];
  auto& trials = e.quantities[0].methods[0].trials;  // enough trials for a chart
  for (double error : {0.1, 0.01, 0.001}) {
    trials.push_back(trials.front());
    trials.back().error = error;
  }
  REQUIRE(has_chart(e.quantities[0]));
  const auto everywhere = [&] {
    return std::array{count_in(single_page(results)), count_in(page_of(results)), count_in(charts_page(e)),
                      count_in(text_view(e))};
  };
  CHECK(everywhere() == std::array<std::size_t, 4>{0, 0, 0, 0});
  e.quantities[0].samples = 4;
  CHECK(everywhere() == std::array<std::size_t, 4>{1, 1, 1, 1});
}

TEST_CASE("every motion knows the number of instants at which it is judged", "[report]") {
  int motions = 0;
  for (const ExerciseResult& e : run_of_all().exercises)
    for (const QuantityResult& q : e.quantities) {
      INFO(to_string(e.number) << " " << q.name);
      CHECK(q.reference.value.size() % static_cast<std::size_t>(q.samples) == 0);
      if (!q.trajectory) continue;
      ++motions;
      CHECK(static_cast<std::size_t>(q.samples) == q.trajectory->judged_at.size());
      CHECK(instants(q) != "");
    }
  CHECK(motions >= 18);
}
