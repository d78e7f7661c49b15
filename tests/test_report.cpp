#include <tbb/global_control.h>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/verdicts.hpp"
#include "report/chart.hpp"
#include "report/markdown.hpp"
#include "report/perturb_results.hpp"
#include "report/run.hpp"
#include "tests/catch.hpp"

using namespace oddity;

namespace {

JudgedClaim judged(Check check) {
  Claim claim{"9.9-x", 1, "x is 1"};
  claim.printed = {"x = 1", {std::move(check)}};
  return {claim, verdict(claim)};
}

Check one_against_one(double allowed, double scale = 0) {
  return {"x", {"a", 1}, {"b", 1}, {allowed, "a test"}, scale};
}

/// Every kind of value that results can hold.
Results sample() {
  ExerciseResult e;
  e.number = {3, 5};
  e.title = "A title";
  e.asks = "What is $x$?";
  e.parameters = {{"a", 0.1, "rad", "angle"}};
  JudgedClaim claim = judged(one_against_one(1e-9));
  claim.claim.near_misses = {{"x = 2", {{"x", {"a", 2}, {"b", 1}, exact(), 1, "worst of 3"}}}};
  claim.claim.why = "a | bar";
  e.claims = {claim};
  TimedTrial trial{"model", "algorithm", "step", 0.5,         Value{1, 2}, 0.25,        0.25,
                   0.5,     0,           42,     Outcome::ok, "",          {1e-6, 1e-8}};
  QuantityResult q{"q", "m", "a length", {"table x.csv", Value{1, 2}}, 1e-16, {0.3, "a reason"}, {}, {}};
  q.methods = {{"model", "algorithm", Outcome::ok, "", {trial, trial}}};
  q.breakdowns = {{"it breaks", Outcome::ok, trial, trial}};
  q.trajectory = Trajectory{
      {"x", "y"}, "s", {1}, {0.5, 1}, {{"model", "algorithm", "step", 0.5, 0.25, Outcome::ok, {1, 2, 3, 4}}},
      0};
  e.quantities = {q};
  return {{e}};
}

}  // namespace

TEST_CASE("results survive the way to JSON and back", "[report]") {
  const Results results = sample();
  const std::string json = to_json(results);
  CHECK(to_json(results_from_json(json, "here")) == json);
  for (const char* key : {"\"number\": \"3.5\"", "\"claims\"", "\"verdict\": \"confirmed\"",
                          "\"reference_error\"", "\"trials\"", "\"evaluations\": 42", "\"seconds\"",
                          "\"outcome\": \"ok\"", "\"knob\": 0.5", "\"trajectory\""})
    CHECK(json.find(key) != std::string::npos);
}

TEST_CASE("numbers that are not finite become null and come back as NaN", "[report]") {
  Results results = sample();
  results.exercises[0].quantities[0].methods[0].trials[0].error = std::numeric_limits<double>::infinity();
  const Results read = results_from_json(to_json(results), "here");
  CHECK(std::isnan(read.exercises[0].quantities[0].methods[0].trials[0].error));
}

TEST_CASE("what is no results file is refused with its place", "[report]") {
  CHECK_THROWS_AS(results_from_json("{}", "here"), BadInput);
  CHECK_THROWS_AS(results_from_json("{\"format\": 1, \"exercises\": [{}]}", "here"), BadInput);
  CHECK_THROWS_AS(results_from_json("not JSON", "here"), BadInput);
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
}

TEST_CASE("a page escapes what Markdown would take for markup, but not mathematics", "[report]") {
  Results results = sample();
  results.exercises[0].claims[0].claim.says = "a_1 * |b| with $a_1 * b$";
  const std::string page = chapter_page(results, 3);
  CHECK(page.find("a\\_1 \\* \\|b\\| with $a_1 * b$") != std::string::npos);
}

TEST_CASE("pages hold no times but the page of times", "[report]") {
  Results slow = sample(), fast = sample();
  fast.exercises[0].quantities[0].methods[0].trials[0].time.seconds = 1e-9;
  CHECK(index_page(slow) == index_page(fast));
  CHECK(chapter_page(slow, 3) == chapter_page(fast, 3));
  CHECK(times_page(slow) != times_page(fast));
}

TEST_CASE("charts hold no times but the charts of time", "[report]") {
  Results slow = sample(), fast = sample();
  fast.exercises[0].quantities[0].methods[0].trials[0].time = {1e-9, 1e-10};
  const auto chart = [](const Results& results, Cost kind) {
    return chart_script(results.exercises[0].quantities[0], "title", kind, "file.svg");
  };
  CHECK(chart(slow, Cost::evaluations) == chart(fast, Cost::evaluations));
  CHECK(chart(slow, Cost::time) != chart(fast, Cost::time));
}

TEST_CASE("a chart shows every trial, those without a number too, and names each kind of failure once",
          "[report]") {
  QuantityResult q = sample().exercises[0].quantities[0];
  q.methods[0].trials[0].outcome = Outcome::non_finite;
  q.methods[0].trials[0].error = std::numeric_limits<double>::quiet_NaN();
  q.methods[0].trials[0].evaluations = 7;
  q.methods.push_back(q.methods[0]);
  const std::string script = chart_script(q, "title", Cost::evaluations, "file.svg");
  const auto count = [&](const std::string& text) {
    int n = 0;
    for (auto at = script.find(text); at != std::string::npos; at = script.find(text, at + 1)) ++n;
    return n;
  };
  CHECK(count("\n7 ") == 4);
  CHECK(count("\n42 ") == 4);  // both on the front, too
  CHECK(count("title \"non-finite\"") == 1);
  CHECK(count("off the scale") == 1);
}

TEST_CASE("a run does not depend on the number of threads, nor on what runs beside it", "[report]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const std::vector<Task> all(registry().begin(), registry().end());
  const auto by_threads = [&](std::size_t threads) {
    const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
    return to_json(run(all, truth, false));
  };
  const std::string alone = by_threads(1);
  CHECK((alone == by_threads(4)));
  Results one_by_one;
  for (const Task& task : all)
    one_by_one.exercises.push_back(run(std::span(&task, 1), truth, false).exercises.front());
  CHECK((alone == to_json(one_by_one)));
}

TEST_CASE("every scene's motion can be drawn, and its truest path goes through the reference", "[report]") {
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

TEST_CASE("exercise numbers read as they are written", "[report]") {
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
