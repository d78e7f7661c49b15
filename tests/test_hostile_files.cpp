// Fuzzers' findings in files and words, each in its smallest form: refused with the right message, and
// nothing worse.

#include <limits>

#include "extras/sweep/chunks.hpp"
#include "reference/files.hpp"
#include "reference/quantity_text.hpp"
#include "report/study/engines.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/sample_results.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  const auto at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), fresh);
}

sweep::Plan small_plan() {
  sweep::Asked asked;
  asked.exercise = "3.5";
  asked.model = "one angle";
  asked.algorithm = "velocity Verlet";
  asked.axes = {{"a", "rad", 0.5, 1, 7}, {"L", "m", 1, 2, 5}};
  return {asked, {0, 1}, {1}, "fingerprint"};
}

/// The message for a chunk of the small plan with these lines, sealed.
std::string complaint_of_chunk(const std::string& lines) {
  const ScratchFolder scratch;
  write_sealed(sweep::chunk_file(scratch.path(), 0), "fingerprint\nchunk 0\n" + lines);
  return complaint([&] { kept(scratch.path(), small_plan(), 0); });
}

}  // namespace

TEST_CASE("a unit of a hundred thousand parentheses, or of powers of powers, is refused", "[hostile]") {
  CHECK(has(complaint([] { in_unit("1" + std::string(100'000, '('), "m"); }), "nor one with a unit"));
  std::string powers = "m";
  for (int i = 0; i < 12; ++i) powers = "(" + powers + "^9)";
  CHECK(has(complaint([&] { in_unit("1" + powers, "m"); }), "nor one with a unit"));
  CHECK(in_unit("1 ((m))", "m") == 1);
  CHECK(has(complaint([] { in_unit("1e308km", "m"); }), "is outside the range of numbers"));
}

TEST_CASE("a plan whose numbers do not fit is refused", "[hostile]") {
  const std::string plan = to_json(small_plan());
  CHECK(to_json(sweep::plan_from_json(plan, "plan")) == plan);
  for (const auto& changed : {std::pair{"\"count\": 7", "\"count\": 1e300"},
                              {"\"count\": 7", "\"count\": 7.5"},
                              {"\"count\": 7", "\"count\": -7"},
                              {"\"count\": 7", "\"count\": 4294967303"},
                              {"\"looks\": 0", "\"looks\": 1e99"},
                              {"\"looks\": 0", "\"looks\": -1"}})
    CHECK(has(complaint([&] { sweep::plan_from_json(replaced(plan, changed.first, changed.second), "it"); }),
              "it is no plan of a sweep: "));
  sweep::Plan without = small_plan();
  without.asked.axes.clear();
  CHECK(has(complaint([&] { sweep::plan_from_json(to_json(without), "it"); }), "it is no plan of a sweep: "));
}

TEST_CASE("a plan for an impossible sweep is refused in one sentence, whoever wrote it",
          "[hostile][forged]") {
  const auto said = [](const auto& change) {
    sweep::Plan plan = small_plan();
    change(plan);
    return complaint([&] { sweep::plan_from_json(to_json(plan), "it"); });
  };
  using sweep::Plan;
  CHECK(said([](Plan&) {}) == "nothing");
  for (const char* exercise : {"7.1", "2.3"})
    CHECK(has(said([&](Plan& p) { p.asked.exercise = exercise; }), "has no motion to sweep over"));
  for (double x : {1e300, -60.0, 0.0, 1e-300, 1e9}) {
    const std::string why = "is not from one look at the motion to a million";
    CHECK(has(said([&](Plan& p) { p.asked.need.frames_per_second = x; }), why));
    CHECK(has(said([&](Plan& p) { p.asked.need.horizon = x; }), why));
  }
  CHECK(has(said([](Plan& p) { p.asked.looks = 2'000'000; }), "is not from one look at the motion"));
  CHECK(has(said([](Plan& p) { p.asked.need.error = -1; }), "must be positive"));
  CHECK(has(said([](Plan& p) { p.asked.need.errors["rad"] = 0; }), "must be positive"));
  CHECK(has(said([](Plan& p) { p.asked.setting = -1; }), "must be positive"));
  for (int count : {1'000'000, 2'147'483'647})
    CHECK(has(said([&](Plan& p) {
                for (sweep::Axis& axis : p.asked.axes) axis.count = count;
                const long tiles = (count + 63L) / 64;
                p.first_tile = {0, tiles * tiles};
              }),
              " cells is too large: "));
  CHECK(has(said([](Plan& p) { p.seconds[0] = -1; }), "takes no time that can be"));
  CHECK(has(said([](Plan& p) {
              p.asked.model = p.asked.algorithm = "";
              p.asked.looks = 4;
            }),
            "--looks is of a method"));
}

TEST_CASE("a plan's frames have the limits of the command line", "[hostile][forged]") {
  const auto said = [](const auto& change) {
    sweep::Plan plan = small_plan();
    plan.asked.frames = {.jitter = 0.2, .drop = 0.01};
    change(plan.asked.frames);
    return complaint([&] { sweep::plan_from_json(to_json(plan), "it"); });
  };
  CHECK(said([](FramesAsked&) {}) == "nothing");
  for (const auto& change : std::initializer_list<std::function<void(FramesAsked&)>>{
           [](FramesAsked& frames) { frames.drop = 0.999; },
           [](FramesAsked& frames) { frames.jitter = 0.999; },
           [](FramesAsked& frames) { frames.jitter = 1e-300; },
           [](FramesAsked& frames) { frames.trace = {1e-300}; },
           [](FramesAsked& frames) { frames.longest = 1e-300; },
           [](FramesAsked& frames) { frames.seed = -1; }, [](FramesAsked& frames) { frames.seed = 2e9; }})
    CHECK(has(said(change), "it is no plan of a sweep: its frames are not valid"));
  sweep::Plan plan = small_plan();
  plan.asked.frames = {.drop = 0.01};
  CHECK(has(complaint([&] {
              sweep::plan_from_json(replaced(to_json(plan), "\"seed\": 1", "\"seed\": 1.5"), "it");
            }),
            "no whole number that fits"));
}

TEST_CASE("a foreign plan is known by its fingerprint, before its frames are made", "[hostile][forged]") {
  const ScratchFolder scratch;
  sweep::Plan plan = small_plan();
  plan.asked.frames = {.drop = 0.99, .trace = {1e-9}};
  plan.fingerprint = "another program's";
  const std::filesystem::path file = scratch.path() / "plan.json";
  write_whole(file, to_json(plan));
  const std::string why =
      complaint([&] { sweep::read_plan(file, std::filesystem::path(ODDITY_SOURCE) / "reference"); });
  CHECK(has(why, "is the plan of another program"));
}

TEST_CASE("a chunk whose lines are not those of its cells is refused", "[hostile]") {
  CHECK(complaint_of_chunk("tile 0 0\n35 - - ok\n") == "nothing");
  for (const char* lines :
       {"", "tile\n", "tile x 0\n35 - - ok\n", "tile 1e99 0\n35 - - ok\n", "tile 0 0\n36 - - ok\n",
        "tile 0 0\n1e18 - - ok\n", "tile 0 0\n-1 - - ok\n", "tile 0 0\n34 - - ok\n", "tile 0 0\n1 x 1 ok\n"})
    CHECK(has(complaint_of_chunk(lines), ": no chunk as a sweep writes it: "));
}

TEST_CASE("a chunk with a value that no cell can have is refused with its line", "[hostile][forged]") {
  CHECK(complaint_of_chunk("tile 3 1\n1 0.5 12 ok\n30 - - inaccurate\n4 - - truth not known\n") == "nothing");
  CHECK(complaint_of_chunk("tile 0 0\n1 nan 12 raised\n34 - - ok\n") == "nothing");
  const std::string megabytes(10'000'000, 'x');
  for (const auto& [line, lines] : std::vector<std::pair<int, std::string>>{
           {4, "tile 0 0\n1 nan 12 ok\n34 - - ok\n"},
           {4, "tile 0 0\n1 1.5 12 ok\n34 - - ok\n"},
           {4, "tile 0 0\n1 0.5 12 inaccurate\n34 - - ok\n"},
           {4, "tile 0 0\n1 0.5 -12 ok\n34 - - ok\n"},
           {4, "tile 0 0\n1 -5 12 ok\n34 - - ok\n"},
           {4, "tile 0 0\n2 0.5 12 ok\n33 - - ok\n"},
           {5, "tile 0 0\n1 0.5 12 ok\n34 - - =HYPERLINK(\"http://x\")\n"},
           {4, "tile 0 0\n35 - - \x1b]52;c;x\x07\n"},
           {4, "tile 0 0\n35 - - " + megabytes + "\n"},
           {4, "tile 0 0\n" + megabytes + " - - ok\n"},
           {4, "tile 0 0\n1 " + megabytes + " 12 ok\n"},
           {4, "tile 0 0\n0 - - ok\n35 - - ok\n"},
           {3, "tile 1 2\n35 - - ok\n"},
           {3, "sea 0 0\n35 - - ok\n"},
           {5, "tile 0 0\n35 - - ok\nmore\n"},
           {5, "tile 0 0\n35 - - ok\n\n"}}) {
    const std::string said = complaint_of_chunk(lines);
    INFO(lines.substr(0, 100) << "\n" << said.substr(0, 300));
    CHECK(has(said, "000000.txt:" + std::to_string(line) + ": no chunk as a sweep writes it: "));
    CHECK(said.size() < 300);
  }
}

TEST_CASE("a chunk of choices contains names of methods, and no formula of a spreadsheet",
          "[hostile][forged]") {
  sweep::Plan plan = small_plan();
  plan.asked.model = plan.asked.algorithm = "";
  const auto said = [&](const std::string& as) {
    const ScratchFolder scratch;
    write_sealed(sweep::chunk_file(scratch.path(), 0),
                 "fingerprint\nchunk 0\ntile 0 0\n1 0.3 8 " + as + "\n15 - - nothing holds\n");
    return complaint([&] { kept(scratch.path(), plan, 0); });
  };
  CHECK(said("one angle, Runge-Kutta 4") == "nothing");
  for (const std::string as : {"=1+1, x", "+1, x", "@SUM(1), x", "-1, x", "ok", "a\x1b[31m, b", ""}) {
    INFO(as);
    CHECK(has(said(as), "000000.txt:4: no chunk"));
  }
  CHECK(has(said("a, " + std::string(1'000'000, 'b')), "000000.txt:4: no chunk"));
}

TEST_CASE("results whose whole numbers do not fit are refused", "[hostile]") {
  const std::string results = to_json(sample());
  CHECK(to_json(results_from_json(results, "it")) == results);
  const auto at = results.find("\"samples\": ");
  REQUIRE(at != std::string::npos);
  const std::string samples = results.substr(at, results.find(',', at) - at);
  for (const char* number : {"1e300", "0", "-1", "1.5", "99999999999", "true"})
    CHECK(has(complaint([&] {
                results_from_json(replaced(results, samples, "\"samples\": " + std::string(number)), "it");
              }),
              "it: not a results file: "));
}

TEST_CASE("results of engines are refused if an error has no unit", "[hostile]") {
  const ScratchFolder scratch;
  const std::string trial =
      R"({"steps_per_frame": 1, "outcome": "ok", "message": "", "errors": [1], "in_needs": 1,
    "energy": null, "momentum": null, "off_joint": 0, "seconds_per_frame": 1e-6, "spread": 0, "same_bits": true, "restored": ""})";
  const std::string kept =
      R"([{"scene": "free body", "title": "", "units": ["m"], "needs": [1], "horizon": 10,
    "frames_per_second": 60, "least": null, "series": [{"engine": "E", "version": "1", "precision": "double",
    "variant": "v", "says": "", "defaults": true, "webassembly": false, "stated_order": 1, "cannot": "", "trials": [)" +
      trial + "]}]}]";
  const auto said = [&](const std::string& text) {
    return complaint([&] { read_engines(scratch.file("engines.json", text)); });
  };
  CHECK(said(kept) == "nothing");
  CHECK(said("[]") == "nothing");
  using Changed = std::vector<std::pair<std::string, std::string>>;
  for (const auto& [old, fresh] : Changed{{"\"errors\": [1]", "\"errors\": [1, 2]"},
                                          {"\"needs\": [1]", "\"needs\": []"},
                                          {"\"steps_per_frame\": 1", "\"steps_per_frame\": 0"},
                                          {"\"steps_per_frame\": 1", "\"steps_per_frame\": 1e300"},
                                          {"\"stated_order\": 1", "\"stated_order\": 1e300"},
                                          {trial, ""},
                                          {"\"horizon\": 10", "\"horizon\": 1e300"},
                                          {"\"frames_per_second\": 60", "\"frames_per_second\": 0"},
                                          {"\"needs\": [1]", "\"needs\": [-1]"},
                                          {"\"in_needs\": 1", "\"in_needs\": null"},
                                          {"\"in_needs\": 1", "\"in_needs\": 1.5"},
                                          {"\"seconds_per_frame\": 1e-6", "\"seconds_per_frame\": -1"},
                                          {"\"errors\": [1]", "\"errors\": [-1]"},
                                          {"\"errors\": [1]", "\"errors\": [], \"path\": [1]"},
                                          {trial, trial + "," + trial},
                                          {kept, ""},
                                          {kept, "{}"},
                                          {kept, "null"},
                                          {kept, "[[]]"}})
    CHECK(has(said(replaced(kept, old, fresh)), "not written by './oddity engines': "));
}
