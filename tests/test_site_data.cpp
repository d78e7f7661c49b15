// The data of the site's pages, read back and compared with the results that they come from.

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "chapters/contents.hpp"
#include "report/pages/stability_view.hpp"
#include "report/site/data.hpp"
#include "report/site/example.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/run.hpp"
#include "report/study/stability.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"
#include "tests/packed.hpp"
#include "tests/sample_results.hpp"

using namespace oddity;
using nlohmann::json;

namespace {

const Reference& known() {
  static const Reference all(std::filesystem::path(ODDITY_SOURCE) / "reference");
  return all;
}

/// The pendulum, run, with a made-up map of stability, and an exercise without a scene.
const Results& results() {
  static const Results all = [] {
    const auto entry = [](Number number) { return *std::ranges::find(registry(), number, &Entry::number); };
    Results some = run(std::vector{Task(entry({3, 5})), Task(entry({6, 1}))}, known(), false);
    some.exercises.front().stability = sample().exercises.front().stability;
    return some;
  }();
  return all;
}

const ExerciseResult& pendulum() { return results().exercises.front(); }
const QuantityResult& swing() { return pendulum().quantities.back(); }

json written(const ExerciseResult& e) {
  return argument("exercise", exercise_data(e, known(), Styles(results()), true));
}

std::vector<float> floats(const json& text) {
  const std::string bytes = bytes_of(text);
  std::vector<float> numbers;
  for (std::size_t at = 0; at < bytes.size(); at += 4)
    numbers.push_back(std::bit_cast<float>(number_at(bytes, at, 4)));
  return numbers;
}

}  // namespace

TEST_CASE("The data of a page contain every trial, in double and in float", "[site]") {
  const json q = written(pendulum())["quantities"].back();
  REQUIRE(q["methods"].size() == swing().methods.size() + swing().in_float.size());
  REQUIRE(swing().methods.size() > 20);
  REQUIRE(!swing().in_float.empty());
  const auto same = [&](const json& shown, const std::vector<TimedTrial>& trials) {
    const json& settings = q["resolutions"][shown[2].get<std::size_t>()]["settings"];
    REQUIRE(shown[4].size() == trials.size());
    REQUIRE(settings.size() == trials.size());
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const json& row = shown[4][i];
      CHECK(settings[i].get<double>() == trials[i].setting);
      if (std::isfinite(trials[i].error))
        CHECK(std::abs(row[0].get<double>() / trials[i].error - 1) < 0.006);
      else
        CHECK(row[0].is_null());
      CHECK(row[1].get<long>() == trials[i].evaluations);
      CHECK(row[4].get<std::string>() == std::string(1, letter_of(trials[i].outcome)));
    }
  };
  for (std::size_t i = 0; i < swing().methods.size(); ++i) {
    const MethodResult& m = swing().methods[i];
    CAPTURE(m.model, m.algorithm);
    CHECK(q["models"][q["methods"][i][0].get<std::size_t>()] == m.model);
    CHECK(q["algorithms"][q["methods"][i][1].get<std::size_t>()] == m.algorithm);
    CHECK(q["methods"][i][3] == 0);
    same(q["methods"][i], m.trials);
  }
  for (std::size_t i = 0; i < swing().in_float.size(); ++i) {
    const FloatResult& m = swing().in_float[i];
    const json& shown = q["methods"][swing().methods.size() + i];
    CHECK(q["algorithms"][shown[1].get<std::size_t>()] == swing().methods[m.in_double].algorithm);
    CHECK(shown[3] == 1);
    same(shown, m.trials);
  }
}

TEST_CASE("The data of a page contain every name's style and every outcome's letter", "[site]") {
  const json data = written(pendulum());
  for (const json& q : data["quantities"]) {
    for (const json& model : q["models"]) CHECK(data["styles"]["colours"].contains(model));
    for (const json& algorithm : q["algorithms"]) CHECK(data["styles"]["marks"].contains(algorithm));
    for (const json& m : q["methods"])
      for (const json& row : m[4]) CHECK(data["outcomes"].contains(row[4]));
  }
  CHECK(data["styles"]["families"]["velocity Verlet"] == "partitioned");
}

TEST_CASE("The true motion starts where the book's does and ends where the reference's does", "[site]") {
  const json truth = written(pendulum())["scene"]["truth"];
  const std::vector<float> angles = floats(truth["values"]);
  REQUIRE(truth["frames"] == 600);
  REQUIRE(angles.size() == 601);
  CHECK(angles.front() == static_cast<float>(std::numbers::pi / 6));
  CHECK(near_part(angles.back(), swing().reference.value[3], 1e-6));
  CHECK(near_part(angles[150], swing().reference.value[0], 1e-6));
}

TEST_CASE("A recorded motion equals the computed one to one part in 65535 of its range", "[site]") {
  const json paths = written(pendulum())["scene"]["paths"];
  REQUIRE(paths.size() == swing().trajectory->paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Value& run = swing().trajectory->paths[i].value;
    const std::string bytes = bytes_of(paths[i]["values"]);
    const double least = paths[i]["least"][0], most = paths[i]["most"][0];
    REQUIRE(bytes.size() == 2 * run.size());
    std::uint32_t now = 0;
    for (std::size_t k = 0; k < run.size(); ++k) {
      now = (now + number_at(bytes, k, 1) + 256 * number_at(bytes, run.size() + k, 1)) % 65536;
      CHECK(std::abs(least + (most - least) * now / 65535 - run[k]) < (most - least) / 65535);
    }
  }
}

TEST_CASE("An engine's motion by its defaults is a recorded motion, at twenty times a second",
          "[site][engines]") {
  EngineSeries series;
  series.engine = "Some";
  series.version = "1.2";
  series.trials.resize(1);
  series.trials.back().errors = {0.5};
  for (int frame = 1; frame <= 450; ++frame) series.trials.back().path.push_back(frame / 450.0);
  EngineSeries tuned = series;
  tuned.defaults = false;
  EngineContest contest;
  EngineSeries in_double = series;
  in_double.engine += " in double";
  contest.series = {series, tuned, in_double};
  const auto paths_of = [&](const std::string& scene) {
    contest.scene = scene;
    const json data = argument(
        "exercise", exercise_data(pendulum(), known(), Styles(results()), false, std::span(&contest, 1)));
    std::vector<json> paths;
    for (const json& path : data["scene"]["paths"])
      if (path["model"] == "physics engine, as it comes") paths.push_back(path);
    return paths;
  };
  const std::vector<json> paths = paths_of("3.5");
  REQUIRE(paths.size() == 1);
  CHECK(paths[0]["frames"] == 200);
  CHECK(paths[0]["setting"] == 1 / 60.0);
  CHECK(paths[0]["error"] == 0.5);
  CHECK(near_part(paths[0]["least"][0], 3 / 450.0, 1e-5));
  CHECK(paths[0]["most"][0] == 1);
  CHECK(bytes_of(paths[0]["values"]).size() == 2 * 150);  // as far as it came
  CHECK(paths_of("3.7").empty());
}

TEST_CASE("Without models every recorded motion is there", "[site]") {
  const auto paths = [](bool recorded) {
    return argument("exercise",
                    exercise_data(pendulum(), known(), Styles(results()), recorded))["scene"]["paths"]
        .size();
  };
  CHECK(paths(true) == swing().trajectory->paths.size());
  CHECK(paths(false) < paths(true));
}

TEST_CASE("A map has a list of letters for each value of the parameter", "[site]") {
  const json stability = written(pendulum())["stability"];
  const Stability& s = *pendulum().stability;
  std::size_t rows = 0;
  for (const json& method : stability["map"])
    for (const json& row : method["rows"]) {
      CHECK(method["algorithm"] == s.map[rows].algorithm);
      CHECK(row[0] == s.map[rows].value);
      CHECK(row[2] == letters(s.map[rows]));
      CHECK(row[3] == fragile_cells(s.map[rows]));
      ++rows;
    }
  CHECK(rows == s.map.size());
  CHECK(stability["limits"][0]["shown"] == shown_step(s.limits[0]));
}

TEST_CASE("No text ends the script that contains it", "[site]") {
  ExerciseResult e = results().exercises.back();
  e.title = "</script><script>alert(1)</script><!--<script>\u2028\u2029\"'\\\n";
  const std::string script = exercise_data(e, known(), Styles(results()), true);
  const json data = argument("exercise", script);
  CHECK(data["title"] == e.title);
  CHECK(data["scene"].is_null());
}

TEST_CASE("The example is a scene with its reference and the player's initial rows", "[site]") {
  const json data = argument("exercise", example_data(example_result(), true));
  CHECK(data["example"]["truth"]["model"] == "flights");
  REQUIRE(data["example"]["opening"].size() == 3);
  for (const json& row : data["example"]["opening"]) {
    const auto of = [&](const json& m) {
      const json& q = data["quantities"][0];
      return q["models"][m[0].get<std::size_t>()] == row["model"] &&
             q["algorithms"][m[1].get<std::size_t>()] == row["algorithm"];
    };
    CHECK(std::ranges::any_of(data["quantities"][0]["methods"], of));
  }
  const std::vector<float> heights = floats(data["scene"]["truth"]["values"]);
  REQUIRE(heights.size() == 241);
  CHECK(heights[0] == 1);
  CHECK(heights[150] > 0);
  CHECK(heights[240] == 0);  // it rests from 2.56 s on
}

TEST_CASE("The errors of a page use the norms of its table", "[site]") {
  for (const bool by_norms : {true, false}) {
    ExerciseResult e = pendulum();
    for (QuantityResult& q : e.quantities)
      if (!by_norms) q.norms.clear();
    CHECK(written(e)["scene"]["norms"] == json::parse(R"([{"unit": "rad", "components": [0]}])"));
  }
  CHECK_FALSE(swing().norms.empty());
}

TEST_CASE("The chooser knows the parameters, units and exact models of each scene", "[site]") {
  const json scenes = argument("scenes", scenes_data(results(), Styles(results())));
  REQUIRE(scenes.size() == 1);
  CHECK(scenes[0]["number"] == "3.5");
  CHECK(scenes[0]["parameters"][0]["name"] == "a");
  CHECK(near_ulps(scenes[0]["close"]["rad"], std::numbers::pi / 180, 64));
  CHECK(scenes[0]["norms"][0]["components"] == json::array({0}));
  CHECK(scenes[0]["exact"] ==
        json::array({"Jacobi's function by its Fourier series", "one angle", "Cartesian with constraint"}));
  CHECK(scenes[0]["faulted"] == json::array());
  CHECK(scenes[0]["resolutions"]["step"][0] == 0.125);
}
