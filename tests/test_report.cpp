#include <fstream>
#include <sstream>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/verdicts.hpp"
#include "report/catalog_page.hpp"
#include "report/chart.hpp"
#include "report/disturb.hpp"
#include "report/markdown.hpp"
#include "report/run.hpp"
#include "tests/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/sample_results.hpp"

using namespace oddity;

namespace {

/// A run of all exercises, once for all tests.
const Results& run_of_all() {
  static const Results results = run(std::vector<Task>(registry().begin(), registry().end()),
                                     Reference(std::filesystem::path(ODDITY_SOURCE) / "reference"), false);
  return results;
}

/// Plain $formulas$ of a Markdown page in which it would take a backslash away, and lines whose formulas in
/// GitHub's form are not closed.
std::vector<std::string> spoilt_formulas(const std::string& page) {
  std::vector<std::string> spoilt;
  std::istringstream lines(page);
  bool fenced = false;
  for (std::string line; std::getline(lines, line);) {
    const bool fence_line = line.starts_with("```");
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
  CHECK(refused([](E& e) {
          e.quantities[0].trajectory->judged_at = {1, 2, 3};
        }).find("times") != std::string::npos);
  CHECK(refused([](E& e) {
          e.quantities[0].trajectory->paths[0].value = {1, 2, 3};
        }).find("path") != std::string::npos);
  CHECK(refused([](E& e) { e.stability->steps.clear(); }).find("map") != std::string::npos);
  CHECK(refused([](E& e) { e.stability->map[0].outcomes.pop_back(); }).find("map") != std::string::npos);
  CHECK(refused([](E& e) { e.stability->limits[0].broken.reset(); }).find("limit") != std::string::npos);
}

TEST_CASE("a disturbance that a check does not notice is named", "[report]") {
  CHECK(unnoticed_disturbances(judged(one_against_one(1e-9))).empty());
  CHECK(unnoticed_disturbances(judged(one_against_one(0))).empty());
  CHECK(unnoticed_disturbances(judged(one_against_one(1.5))) ==
        std::vector<std::string>{"9.9-x, x: a factor of two"});
  const Check zero{"x", {"a", 0}, {"b", 0}, {1e-9, "a test"}};
  CHECK(unnoticed_disturbances(judged(zero)).size() == 2);
  const Check scaled_zero{"x", {"a", 0}, {"b", 0}, {1e-9, "a test"}, 1};
  CHECK(unnoticed_disturbances(judged(scaled_zero)).empty());
}

TEST_CASE("a page escapes what Markdown would take for markup, but not mathematics", "[report]") {
  Results results = sample();
  results.exercises[0].claims[0].claim.says = "a_1 * |b| with $a_1 * b$";
  const std::string page = chapter_page(results, 3);
  CHECK(page.find("a\\_1 \\* \\|b\\| with $`a_1 * b`$") != std::string::npos);
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
  CHECK(count("title 'non-finite'") == 1);
  CHECK(count("off the scale") == 1);
}

TEST_CASE("a run does not depend on the number of threads, and repeats itself", "[report]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const std::string together = to_json(run_of_all());
  Results one_by_one;
  for (const Task& task : std::vector<Task>(registry().begin(), registry().end()))
    one_by_one.exercises.push_back(run(std::span(&task, 1), truth, false).exercises.front());
  CHECK((together == to_json(one_by_one)));
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

TEST_CASE("Markdown takes nothing away from a formula", "[report]") {
  using Lines = std::vector<std::string>;
  CHECK(spoilt_formulas("$a\\,b$ and $`a\\,b`$ and `$a\\,b$`") == Lines{"a\\,b"});
  CHECK(spoilt_formulas("$`a\\,b$").size() == 1);
  CHECK(spoilt_formulas(index_page(run_of_all())) == Lines());
  CHECK(spoilt_formulas(single_page(run_of_all())) == Lines());
  CHECK(spoilt_formulas(catalog_page()) == Lines());
  for (const Chapter& chapter : chapters())
    CHECK(spoilt_formulas(chapter_page(run_of_all(), chapter.number)) == Lines());
  for (const auto& file : std::filesystem::directory_iterator(ODDITY_SOURCE))
    if (file.path().extension() == ".md") {
      INFO(file.path());
      std::ifstream in(file.path());
      CHECK(spoilt_formulas({std::istreambuf_iterator<char>(in), {}}) == Lines());
    }
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
}
