// Files that somebody has changed. Redundant values are computed again; the others are under a seal.

#include <cctype>
#include <functional>
#include <nlohmann/json.hpp>

#include "reference/files.hpp"
#include "report/study/earlier_results.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/program.hpp"
#include "tests/sample_results.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace program;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

/// The JSON with a valid seal, as a forger who knows this program would write it.
std::string sealed(Json json) {
  json.erase("seal");
  json["seal"] = checksum(json.dump(1, ' ', false, Json::error_handler_t::replace));
  return json.dump(1) + "\n";
}

/// Every value of a key, wherever it is.
void for_each_of(Json& json, const std::string& key, const std::function<void(Json&)>& change) {
  if (json.is_object() && json.contains(key)) change(json[key]);
  if (json.is_structured())
    for (Json& part : json) for_each_of(part, key, change);
}

/// The trials of every quantity of the first exercise.
void for_each_trial(Json& json, const std::function<void(Json&)>& change) {
  for (Json& q : json["exercises"][0]["quantities"])
    for (Json& t : q["trials"]) change(t);
}

struct Forgery {
  const char* says;
  std::function<void(Json&)> change;
};

const Json::json_pointer first_quantity("/exercises/0/quantities/0");

/// Forgeries that the results alone reveal.
const std::vector<Forgery> contradictions{
    {"checks that do not hold",
     [](Json& j) { for_each_of(j, "holds", [](Json& x) { x = !x.get<bool>(); }); }},
    {"a check's difference", [](Json& j) { for_each_of(j, "difference", [](Json& x) { x = 0.5; }); }},
    {"a wider tolerance", [](Json& j) { for_each_of(j, "allowed", [](Json& x) { x = 1e9; }); }},
    {"checks that have gone", [](Json& j) { for_each_of(j, "checks", [](Json& x) { x = Json::array(); }); }},
    {"readings that have gone",
     [](Json& j) { for_each_of(j, "readings", [](Json& x) { x = Json::object(); }); }},
    {"turned verdicts",
     [](Json& j) {
       for_each_of(j, "verdict", [](Json& x) { x = x == "confirmed" ? "erratum" : "confirmed"; });
     }},
    {"trials' values of 42", [](Json& j) { for_each_trial(j, [](Json& t) { t["value"] = 42; }); }},
    {"a reference of 42", [](Json& j) { j[first_quantity / "reference"] = 42; }},
    {"errors of none", [](Json& j) { for_each_trial(j, [](Json& t) { t["error"] = 0; }); }},
    {"final errors of none", [](Json& j) { for_each_trial(j, [](Json& t) { t["final_error"] = 1e9; }); }},
    {"outcomes that are ok",
     [](Json& j) {
       for_each_trial(j, [](Json& t) { t["outcome"] = t["outcome"] == "ok" ? "inaccurate" : "ok"; });
     }},
    {"nothing as expected",
     [](Json& j) { for_each_of(j, "as_expected", [](Json& x) { x = !x.get<bool>(); }); }},
    {"a trial more", [](Json& j) {
       Json& trials = j[first_quantity / "trials"];
       trials.push_back(Json(trials[0]));
     }}};

/// Forgeries that only the exercises reveal.
const std::vector<Forgery> of_a_scene{
    {"no trajectory", [](Json& j) { for_each_of(j, "trajectory", [](Json& x) { x = nullptr; }); }},
    {"no motion", [](Json& j) { j["exercises"][0]["quantities"] = Json::array(); }},
    {"no scene", [](Json& j) { j["exercises"][0]["scene"] = false; }},
    {"another parameter", [](Json& j) { j["exercises"][0]["parameters"][0]["value"] = 1.5; }},
    {"another title", [](Json& j) { j["exercises"][0]["title"] = "Another"; }},
    {"a path of no trial", [](Json& j) { for_each_of(j, "paths", [](Json& x) { x[0]["error"] = 1e-30; }); }},
    {"limits", [](Json& j) {
       for (Json& limit : j["exercises"][0]["stability"]["limits"]) limit["step"] = 42;
     }}};

}  // namespace

TEST_CASE("results that contradict themselves are refused, even with a valid seal", "[forged]") {
  const Json whole = Json::parse(to_json(sample()));
  CHECK(complaint([&] { results_from_json(whole.dump(), "here"); }) == "nothing");
  for (const Forgery& forgery : contradictions) {
    Json forged = whole;
    forgery.change(forged);
    INFO(forgery.says);
    REQUIRE(forged != whole);
    CHECK(has(complaint([&] { results_from_json(forged.dump(), "here"); }), "here: not a results file: "));
  }
}

TEST_CASE("least models that do not exist, or hold with an error above the requested one, are refused",
          "[forged]") {
  const Json whole = Json::parse(to_json(sample()));
  const auto said = [&](const std::string& place, const Json& value) {
    Json forged = whole;
    forged[Json::json_pointer("/exercises/0/cheapest_models" + place)] = value;
    return complaint([&] { results_from_json(forged.dump(), "here"); });
  };
  CHECK(has(said("/least", Json::array()), "there are no least models"));
  CHECK(has(said("/least/0/least/error_in_needs", 1.5), "its error exceeds the need"));
}

TEST_CASE("a results file is read as it was written, and refused if a figure or a word of it is changed",
          "[forged]") {
  const ScratchFolder scratch;
  const std::string whole = to_json(sample());
  const auto said = [&](const std::string& text) {
    return complaint([&] { read_results(scratch.file("results.json", text)); });
  };
  REQUIRE(said(whole) == "nothing");
  int changes = 0;
  for (std::size_t at = 0; at < whole.size(); at += 11) {
    if (std::isalnum(static_cast<unsigned char>(whole[at])) == 0) continue;
    std::string changed = whole;
    changed[at] = whole[at] == '7' ? '3' : '7';
    ++changes;
    INFO(changed.substr(at - std::min<std::size_t>(at, 30), 60));
    CHECK(has(said(changed), "results.json: not a results file: "));
  }
  CHECK(changes > 300);
  CHECK(has(said(whole.substr(0, whole.size() / 2)), "not a results file"));
  Json without = Json::parse(whole);
  without.erase("seal");
  CHECK(has(said(without.dump()), "results.json: not a results file: key 'seal' not found"));
}

TEST_CASE("a results file sends no control characters to its reader", "[forged]") {
  Results results = sample();
  results.exercises[0].claims[0].claim.says = "x\x1b]52;c;AAAA\x07 is 1";
  const ScratchFolder scratch;
  const Results read = read_results(scratch.file("results.json", to_json(results)));
  CHECK(read.exercises[0].claims[0].claim.says == "x\\x1b]52;c;AAAA\\x07 is 1");
}

TEST_CASE("results are judged by the program, the tables and the parameters that made them", "[forged]") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "swing.json", forged = scratch.path() / "forged.json";
  REQUIRE(run("verify '[3.5]' --results " + quoted(file)).status == 0);
  const Ran judged = run("verify '[3.5]' --from " + quoted(file));
  INFO(judged.output);
  REQUIRE(judged.status == 0);
  const Json whole = Json::parse(text_of(file));
  REQUIRE(sealed(whole) == text_of(file));
  const auto refused = [&](const std::string& text, const char* why) {
    scratch.file("forged.json", text);
    const Ran ran = run("verify '[3.5]' --from " + quoted(forged));
    INFO(ran.output.substr(0, 2000));
    CHECK(ran.status == 2);
    CHECK(says(ran, "forged.json: "));
    CHECK(says(ran, why));
    return ran;
  };
  for (const auto* forgeries : {&contradictions, &of_a_scene})
    for (const Forgery& forgery : *forgeries) {
      INFO(forgery.says);
      Json changed = whole;
      forgery.change(changed);
      REQUIRE(changed != whole);
      refused(sealed(changed), "");
    }
  Json changed = whole;
  changed["exercises"][0]["claims"][0]["says"] = "something else";
  refused(changed.dump(1), "it is not as it was written");
  changed = whole;
  changed["made_by"] = "program 0, tables 0";
  refused(sealed(changed), "made by (program 0, tables 0), and here is (program ");
  const Ran solved = run("solve 3.5 a=1 --json >" + quoted(forged));
  CHECK(solved.status == 0);
  CHECK(run("verify '[3.5]' --from " + quoted(forged)).status == 2);
}

TEST_CASE("results of other tables are not used, however new they are", "[forged]") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "one.json", other = scratch.path() / "reference";
  const fs::path here = fs::path(ODDITY_SOURCE) / "reference";
  for (const char* folder : {"tables", "approved"}) {
    fs::create_directories(other);
    fs::copy(here / folder, other / folder, fs::copy_options::recursive);
  }
  REQUIRE(run("verify '[5.7]' --results " + quoted(file)).status == 0);
  const std::string from = "--reference " + quoted(other) + " verify '[5.7]' --from " + quoted(file);
  CHECK(run(from).status == 0);  // a copy gives the same
  const fs::path table = other / "tables/09_01_distance.csv";
  std::string text = text_of(table);
  const std::size_t digit = text.find_first_of("123456789", text.find('\n'));
  REQUIRE(digit != std::string::npos);
  text[digit] = text[digit] == '7' ? '3' : '7';
  std::ofstream(table) << text;
  fs::last_write_time(table, fs::last_write_time(file) - std::chrono::hours(24 * 365 * 20));
  const Ran ran = run(from);
  INFO(ran.output);
  CHECK(ran.status == 2);
  CHECK(says(ran, "one.json: made by (program "));
  CHECK(made_by(here) != made_by(other));
  const Results results = read_results(file);
  CHECK(complaint([&] { earlier_results(file, results.made_by); }) == "nothing");
  CHECK(has(complaint([&] { earlier_results(file, made_by(other)); }), "made by"));
}
