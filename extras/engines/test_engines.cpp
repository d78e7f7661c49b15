#include <sys/stat.h>

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "extras/engines/chart.hpp"
#include "extras/engines/contest.hpp"
#include "extras/engines/page.hpp"
#include "extras/engines/view.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/verify/catch.hpp"
#include "solvers/turns.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

Need need_of(double horizon, double frames_per_second) {
  return {.error = degree,
          .horizon = horizon,
          .frames_per_second = frames_per_second,
          .errors = {{"m", centimeter}, {"rad", degree}}};
}

/// An engine that answers --about and a request with these shell commands.
std::vector<EngineProgram> engines_that(const std::filesystem::path& folder, const std::string& about,
                                        const std::string& command) {
  const std::filesystem::path program = folder / "engine_fake";
  std::ofstream(program) << "#!/bin/sh\nif [ \"$1\" = --about ]; then\n"
                         << about << "\nexit\nfi\n"
                         << command << "\n";
  chmod(program.c_str(), 0755);
  return engines_found(folder, folder);
}

/// An engine that answers a request with this shell command.
EngineProgram engine_that(const std::filesystem::path& folder, const std::string& command) {
  const auto found = engines_that(folder,
                                  R"(echo '{"name": "Fake", "version": "1", "precision": "double",
         "variants": [{"name": "defaults", "says": "", "order": 1, "defaults": true}]}')",
                                  command);
  REQUIRE(found.size() == 1);
  return found.front();
}

EngineTrial trial_of(const std::string& command, double limit = 60) {
  const ScratchFolder scratch;
  const EngineProgram engine = engine_that(scratch.path(), command);
  const EngineScene scene = further_engine_scene("free body", need_of(0.1, 60));
  return run(engine, engine.variants.front(), scene, 1, {.limit = limit});
}

}  // namespace

TEST_CASE("the bouncing ball's reference falls freely before it is returned", "[engines]") {
  const EngineScene scene = further_engine_scene("bouncing ball", need_of(0.1, 60));
  const Value& x = scene.motion.reference.value;
  for (std::size_t i = 3; i < 6; ++i)  // second differences of a fall
    CHECK(near_part((x[i] - 2 * x[i - 1] + x[i - 2]) * 3600, -9.81, 1e-9));
}

TEST_CASE("a crash of an engine is an outcome", "[engines]") {
  const EngineTrial aborted = trial_of("kill -ABRT $$");
  CHECK(aborted.outcome == Outcome::raised);
  CHECK(aborted.message.find("signal 6") != std::string::npos);

  const EngineTrial hanging = trial_of("sleep 100", 0.2);
  CHECK(hanging.outcome == Outcome::stalled);

  const EngineTrial failing = trial_of("echo out of luck >&2; exit 3");
  CHECK(failing.outcome == Outcome::raised);
  CHECK(failing.message == "status 3: out of luck\n");

  const EngineTrial babbling = trial_of("echo hello");
  CHECK(babbling.outcome == Outcome::raised);
  CHECK(babbling.message.find("no reply") != std::string::npos);
}

TEST_CASE("an engine without a valid description is bad input that names it", "[engines]") {
  const ScratchFolder scratch;
  for (const auto& [about, why] : {std::pair("echo I am an engine", "description is not valid"),
                                   std::pair(R"(echo '{"name": "Fake"}')", "'version' not found"),
                                   std::pair(R"(echo '{"name": 7, "version": "1"}')", "must be string"),
                                   std::pair("echo no license >&2; exit 2", "status 2 no license")}) {
    const std::string words = complaint([&] { engines_that(scratch.path(), about, "exit"); });
    INFO(words);
    CHECK(words.find("engine_fake --about: ") != std::string::npos);
    CHECK(words.find(why) != std::string::npos);
  }
}

TEST_CASE("an engine that has been removed is an outcome", "[engines]") {
  const ScratchFolder scratch;
  const EngineProgram engine = engine_that(scratch.path(), "exit");
  std::filesystem::remove(engine.command.front());
  const EngineScene scene = further_engine_scene("free body", need_of(0.1, 60));
  const EngineTrial trial = run(engine, engine.variants.front(), scene, 1, {});
  CHECK(trial.outcome == Outcome::raised);
  CHECK(trial.message.starts_with("not started"));
}

TEST_CASE("an engine whose finite numbers end before the motion does is judged non-finite", "[engines]") {
  const EngineTrial trial = trial_of(
      R"(echo '{"frames": [[{"position": [0,0,0], "orientation": [1,0,0,0], "velocity": [0,0,0], "spin": [1.7,0,1]}]],
                "seconds": [0.1], "same_bits": true, "restored": "", "cannot": ""}')");
  CHECK(trial.outcome == Outcome::non_finite);
  CHECK(std::isnan(trial.in_needs));
}

TEST_CASE("an engine whose start is not finite is judged non-finite", "[engines]") {
  const EngineTrial trial =
      trial_of(R"(echo '{"frames": [], "seconds": [], "same_bits": true, "restored": "", "cannot": ""}')");
  CHECK(trial.outcome == Outcome::non_finite);
  CHECK(std::isnan(trial.in_needs));
}

TEST_CASE("an engine that cannot build a scene gives the reason", "[engines]") {
  const ScratchFolder scratch;
  const EngineProgram engine = engine_that(
      scratch.path(),
      R"(echo '{"frames": [], "seconds": [], "same_bits": true, "restored": "", "cannot": "no spin"}')");
  const EngineContest contest = run({engine}, further_engine_scene("free body", need_of(0.1, 60)), {});
  REQUIRE(contest.series.size() == 1);
  CHECK(contest.series.front().cannot == "no spin");
  CHECK(contest.series.front().trials.empty());
}

namespace {

const Reference& truth() {
  static const Reference tables(std::filesystem::path(ODDITY_SOURCE) / "reference");
  return tables;
}

/// Parameters a tenth larger, and a tenth instead of zero, where that is in range.
Parameters a_tenth_more(const Entry& entry) {
  Parameters p = Task(entry).parameters;
  for (const Parameter& declared : p.declared())
    if (const double value = p[declared.name], more = value == 0 ? 0.1 : 1.1 * value;
        !declared.whole && more <= declared.most && more >= declared.least)
      p.set(declared.name, more);
  return p;
}

/// Extrapolated with the velocities.
engines::State moved(engines::State s, double seconds) {
  using engines::operator+, engines::operator*;
  const double spin = std::hypot(s.spin[0], s.spin[1], s.spin[2]);
  s.position = s.position + seconds * s.velocity;
  if (spin > 0)
    s.orientation = engines::product(engines::about((1 / spin) * s.spin, spin * seconds), s.orientation);
  return s;
}

/// Checks a scene at two frames, a millisecond apart.
void check_its_first_milliseconds(const EngineScene& scene) {
  INFO(scene.scene);
  const Value& all = scene.motion.reference.value;
  const std::size_t numbers = all.size() / 2;
  for (std::size_t look : {1u, 2u}) {
    const double t = 1e-3 * static_cast<double>(look);
    std::vector<engines::State> after;
    for (const auto& body : scene.staging.world.bodies) after.push_back(moved(body.start, t));
    const auto truth = all.begin() + static_cast<std::ptrdiff_t>((look - 1) * numbers);
    // Tolerance: the effect of accelerations of 200 m/s^2 or rad/s^2.
    CHECK(distance(Value(scene.staging.observe(after, t)),
                   Value(std::vector(truth, truth + static_cast<std::ptrdiff_t>(numbers)))) < 100 * t * t);
  }
}

[[maybe_unused]] const bool registered = [] {
  for (const Entry& entry : registry()) {
    if (!has_engine_scene(entry)) continue;
    const auto check = [&entry] {
      Task other(entry);
      other.parameters = a_tenth_more(entry);
      for (const Task& task : {Task(entry), other})
        check_its_first_milliseconds(engine_scene(task, need_of(2e-3, 1e3), truth()));
    };
    register_test(check, to_string(entry.number) + " starts in engines where and as fast as in the book",
                  "[engines][" + to_string(entry.number) + "]");
  }
  return true;
}();

}  // namespace

TEST_CASE("further scenes have the same initial positions and speeds in engines and here", "[engines]") {
  for (const std::string& name : further_engine_scenes())
    check_its_first_milliseconds(further_engine_scene(name, need_of(2e-3, 1e3)));
}

TEST_CASE("engines have at least ten scenes of the book", "[engines]") {
  CHECK(std::ranges::count_if(registry(), has_engine_scene) >= 10);
}

namespace {

/// Where the box of 3.31 comes to rest on points that share its weight, with Coulomb's friction at each.
/// Friction `h` below the center adds loads that are linear over the foot.
std::array<double, 3> rest_on(const std::vector<std::array<double, 2>>& points, double h) {
  constexpr double mu = 0.3, g = 9.81, inertia = (0.3 * 0.3 + 0.2 * 0.2) / 3, dt = 1e-4;
  using Box = std::array<double, 6>;
  const auto derivative = [&](const Box& s) {
    const double c = std::cos(s[2]), i = std::sin(s[2]), count = static_cast<double>(points.size());
    double fx = 0, fy = 0, moment = 0, px = 0, py = 0;
    for (int pass = 0; pass < (h > 0 ? 8 : 1); ++pass) {
      double xx = 0, xy = 0, yy = 0, new_fx = 0, new_fy = 0;
      moment = 0;
      for (const auto& [a, b] : points) {
        const double x = c * a - i * b, y = i * a + c * b;
        const double u = s[3] - s[5] * y, v = s[4] + s[5] * x, speed = std::hypot(u, v) + 1e-12;
        const double along = -mu * (g / count + px * x + py * y) / speed;
        new_fx += along * u, new_fy += along * v, moment += along * (x * v - y * u);
        xx += x * x, xy += x * y, yy += y * y;
      }
      fx = new_fx, fy = new_fy;
      const double det = xx * yy - xy * xy;
      px = -h * (fx * yy - fy * xy) / det, py = -h * (fy * xx - fx * xy) / det;
    }
    return Box{s[3], s[4], s[5], fx, fy, moment / inertia};
  };
  Box s{0, 0, 0, 2, 0.5, 10};
  while (std::hypot(s[3], s[4], 0.3 * s[5]) > 4 * mu * g * dt) {
    Box half = derivative(s);
    for (std::size_t k = 0; k < 6; ++k) half[k] = s[k] + dt / 2 * half[k];
    const Box change = derivative(half);
    for (std::size_t k = 0; k < 6; ++k) s[k] += dt * change[k];
  }
  return {s[0], s[1], s[2]};
}

std::vector<double> at_its_end(const EngineScene& scene) {
  const Value& all = scene.motion.reference.value;
  return {all[all.size() - 3], all[all.size() - 2], all[all.size() - 1]};
}

}  // namespace

TEST_CASE("a box turns by 320 degrees on its whole foot, and by 176 on four corners", "[engines]") {
  const auto entry =
      std::ranges::find_if(registry(), [](const Entry& e) { return to_string(e.number) == "3.31"; });
  const Need need = need_of(3, 10);
  const auto whole = at_its_end(engine_scene(Task(*entry), need, truth()));
  const auto corners = at_its_end(further_engine_scene("box on corners", need));
  CHECK(near(whole[2] / degree, 320.06, 0.05));
  CHECK(near(corners[2] / degree, 176.0, 0.1));

  std::vector<std::array<double, 2>> foot;
  constexpr int n = 10;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      foot.push_back({0.3 * ((2 * i + 1.0) / n - 1), 0.2 * ((2 * j + 1.0) / n - 1)});
  const auto on_foot = rest_on(foot, 0);  // the midpoints' mean lever is short by 1/(2 n^2) of it
  CHECK(near_part(on_foot[2], whole[2], 1.0 / (2 * n * n)));
  CHECK(std::hypot(on_foot[0] - whole[0], on_foot[1] - whole[1]) < 5e-3);

  const auto on_corners = rest_on({{0.3, 0.2}, {0.3, -0.2}, {-0.3, 0.2}, {-0.3, -0.2}}, 0.02);
  for (std::size_t k = 0; k < 3; ++k) CHECK(near(on_corners[k], corners[k], 1e-3));
}

TEST_CASE("the reason why an engine does not converge to a scene is given where the trials show it",
          "[engines]") {
  const auto series = [](const std::string& variant, std::vector<double> errors) {
    EngineSeries s{"Fake", "1", "float", variant, ""};
    int steps = 1;
    for (double error : errors) {
      EngineTrial trial{steps};
      trial.in_needs = error;
      trial.outcome = error <= 1 ? Outcome::ok : Outcome::inaccurate;
      s.trials.push_back(trial);
      steps *= 2;
    }
    summarize(s);
    return s;
  };
  EngineContest contest;
  const EngineSeries falling = series("a", {16, 8, 4, 2}), rising = series("a", {5, 3, 4, 9}),
                     level = series("a", {9, 9, 9, 9}), good = series("b", {2, 1, 0.5, 0.2});
  EngineSeries damped = level;
  damped.lasting = "damping";

  CHECK(why_never(contest, falling).empty());
  EngineSeries slow = rising;
  slow.trials.back().outcome = Outcome::stalled;
  CHECK(why_never(contest, slow).empty());
  CHECK(why_never(contest, rising) == "rounding in float");
  CHECK(why_never(contest, level) == "not explained");
  CHECK(why_never(contest, series("a", {9})).empty());
  CHECK(why_never(contest, damped) == "damping");  // no variant without it
  contest.series = {damped, level};
  CHECK(why_never(contest, damped) == "not explained");  // without it, it is no better
  contest.series = {damped, good};
  CHECK(why_never(contest, damped) == "damping");
  contest.differs = "more friction";
  CHECK(why_never(contest, damped) == "not the same scene");
}

TEST_CASE("an engine's order is reported in its asymptotic range only", "[engines]") {
  const auto order = [](const std::vector<double>& errors) {
    EngineSeries s{"Fake", "1", "double", "defaults", ""};
    int steps = 1;
    for (double error : errors) {
      s.trials.push_back({steps});
      s.trials.back().in_needs = error;
      steps *= 2;
    }
    summarize(s);
    return s.law ? s.law->exponent : 0;
  };
  CHECK(near_ulps(order({8, 4, 2, 1, 0.5}), 1, 64));
  CHECK(order({3.6, 3.3, 2.7, 0.81, 0.2, 0.048}) == 0);  // ODE on 3.33: 2 on the way to 1
  CHECK(near_ulps(order({90, 60, 16, 4, 1, 0.25}), 2, 64));
}

TEST_CASE("the free body's closed form is the solution of Euler's equations", "[engines]") {
  const EngineScene scene = further_engine_scene("free body", need_of(10, 10));
  namespace odeint = boost::numeric::odeint;
  using Spin = std::array<double, 3>;
  const auto euler = [](const Spin& w, Spin& dwdt, double) {
    dwdt = {-1.0 * w[1] * w[2], 2.0 / 2 * w[2] * w[0], -1.0 / 3 * w[0] * w[1]};
  };
  Spin w{1.7, 0, 1};
  const double L = std::hypot(1.7, 3.0);
  auto stepper = odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_fehlberg78<Spin>());
  for (std::size_t frame = 0; frame < 100; ++frame) {
    odeint::integrate_adaptive(stepper, euler, w, 0.0, 0.1, 0.01);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(near(scene.motion.reference.value[3 * frame + i], double(i + 1) * w[i] / L, 1e-10));
  }
}

TEST_CASE("a scene that is not set up for engines is refused with a list of those that are", "[engines]") {
  const auto entry = std::ranges::find_if_not(registry(), has_engine_scene);
  const std::string says = complaint([&] { require_engine_scene(*entry); });
  CHECK(says.find("is not set up for engines; 3.5, ") != std::string::npos);
  CHECK(complaint([] {
          further_engine_scene("fre body", need_of(1, 60));
        }).find("did you mean 'free body'?") != std::string::npos);
}

TEST_CASE("results of engines are read as they were written", "[engines]") {
  EngineSeries series{"Fake", "1", "float", "defaults", "nothing set"};
  for (int steps = 1; steps <= 16; steps *= 2) {
    EngineTrial trial{steps};
    trial.errors = {0.5 / steps};
    trial.in_needs = 5.0 / steps;
    trial.outcome = trial.in_needs <= 1 ? Outcome::ok : Outcome::inaccurate;
    trial.energy = std::nan("");
    trial.momentum = 0.25;
    series.trials.push_back(trial);
  }
  EngineContest contest{"3.5", "Pendulum", {"rad"},  {0.1},
                        10,    60,         {series}, Instead{"one angle", {0.01}, 1e-8}};
  const ScratchFolder scratch;
  const auto file = scratch.path() / "engines.json";
  write({contest}, file);
  const auto read = read_engines(file);
  REQUIRE(read.size() == 1);
  REQUIRE(read[0].series.size() == 1);
  const EngineSeries& again = read[0].series[0];
  CHECK(again.trials.size() == 5);
  CHECK(std::isnan(again.trials[0].energy));
  CHECK(again.trials[0].momentum == 0.25);
  REQUIRE(again.law);
  CHECK(near_ulps(again.law->exponent, 1, 64));
  REQUIRE(again.first_enough());
  CHECK(again.first_enough()->steps_per_frame == 8);
  CHECK(read[0].least->says == "one angle");

  auto without = nlohmann::json::parse(std::ifstream(file));
  for (auto& trial : without[0]["series"][0]["trials"]) trial.erase("momentum");
  std::ofstream(file) << without;
  CHECK(std::isnan(read_engines(file)[0].series[0].trials[0].momentum));

  const auto refused = [&](const char* key, double value, const char* why) {
    write({contest}, file);
    auto forged = nlohmann::json::parse(std::ifstream(file));
    forged[0]["series"][0]["trials"][3][key] = value;
    std::ofstream(file) << forged;
    CHECK(complaint([&] { read_engines(file); }).find(why) != std::string::npos);
  };
  refused("in_needs", 0.1, "its errors and its error in needs contradict each other");
  refused("in_needs", 1.5, "is ok with an error above the need");
  write({contest}, file);
  auto turned = nlohmann::json::parse(std::ifstream(file));
  turned[0]["series"][0]["trials"][4]["outcome"] = "inaccurate";
  std::ofstream(file) << turned;
  CHECK(complaint([&] { read_engines(file); }).find("is inaccurate with an error within the need") !=
        std::string::npos);

  std::ofstream(file) << "[{\"scene\": 1}]";
  CHECK(complaint([&] { read_engines(file); }).find("json.exception") == std::string::npos);
  CHECK(complaint([&] { read_engines(file); }).find("not written by './oddity engines'") !=
        std::string::npos);
}

namespace {

EngineSeries series_of(const std::string& engine, const std::vector<double>& errors) {
  EngineSeries s{engine, "1", "double", "defaults", "nothing set"};
  int steps = 1;
  for (double error : errors) {
    EngineTrial trial{steps};
    trial.in_needs = error;
    trial.errors = {error * degree};
    trial.outcome = error <= 1 ? Outcome::ok : Outcome::inaccurate;
    s.trials.push_back(trial);
    steps *= 2;
  }
  summarize(s);
  return s;
}

}  // namespace

TEST_CASE("engines with similar errors share a curve, and eight curves at most are drawn", "[engines]") {
  EngineContest contest{"3.5", "Pendulum", {"rad"}, {degree}, 10, 60, {}};
  contest.series = {series_of("First", {2, 1, 0.5}), series_of("Second", {2.05, 1.02, 0.51}),
                    series_of("Third", {4, 2, 1})};
  const std::string svg = engine_rates_svg(contest, {});
  CHECK(svg.find("First, Second") != std::string::npos);
  CHECK(svg.find("At 60 Hz 0 of 3 engines are within 1 deg") != std::string::npos);
  for (int i = 0; i < 8; ++i) {
    const double more = 10 + 5 * i;
    contest.series.push_back(series_of("Worse " + std::to_string(i), {more, more, more}));
  }
  const std::string full = engine_rates_svg(contest, {});
  for (int i = 0; i < 8; ++i)
    CHECK((full.find("Worse " + std::to_string(i)) != std::string::npos) == (i < 6));
}

TEST_CASE("the engines' page has each engine's error and rate, and the surprises", "[engines]") {
  const auto found = surprises_in(std::filesystem::path(ODDITY_SOURCE) / "extras/engines/adapters/found");
  for (const Surprise& s : found) {
    INFO(s.file);
    CHECK(s.says.size() > 20);
    CHECK(s.says.ends_with("."));
  }
  EngineContest contest{"3.5", "Pendulum", {"rad"}, {degree}, 10, 60, {}};
  contest.series = {series_of("First", {9, 9, 9}), series_of("Second", {16, 8, 4}),
                    series_of("Third", {4, 0.5, 0.25})};
  contest.series[0].lasting = "damping";
  for (EngineSeries& s : contest.series) s.trials.front().energy = 0.0123, s.trials.front().momentum = 5e-4;
  const std::string page = engines_page({contest}, found, "../extras/engines/adapters/found");
  CHECK(page.find(std::to_string(found.size()) + " things") != std::string::npos);
  CHECK(page.find("| First | 9/never |") != std::string::npos);
  CHECK(page.find("| Second | 16/finer |") != std::string::npos);
  CHECK(page.find("| Third | 4/120 |") != std::string::npos);
  CHECK(page.find("| First, Second, Third | 1.2/0.05 |") != std::string::npos);
  CHECK(page.find("(engines/3.5.svg)") != std::string::npos);
  CHECK(engine_pictures({contest}, {}).count("engines/3.5.svg") == 1);
  CHECK(engine_trials({contest}).at("engines/3.5.csv").find("Third,1,double,defaults") != std::string::npos);
}

TEST_CASE("an engine's adapter is a hundred lines at most", "[engines]") {
  const std::filesystem::path folder = std::filesystem::path(ODDITY_SOURCE) / "extras/engines/adapters";
  std::ifstream variants(folder / "variants.json");
  const auto adapters = nlohmann::json::parse(variants);
  for (const auto& [adapter, _] : adapters.items()) {
    INFO(adapter);
    CHECK(std::ranges::count(text_of(folder / adapter), '\n') <= 100);
  }
}

TEST_CASE("engines are judged and shown by the requested criteria", "[engines]") {
  EngineContest contest{"3.5", "Pendulum", {"rad"}, {degree}, 10, 60, {series_of("First", {4, 0.5})}};
  contest.criteria = {{Criterion::energy, 0.05}, {Criterion::constraint, 1e-3}};
  contest.series[0].trials[0].by = {{Criterion::energy, 0.29}, {Criterion::constraint, 5e-4}};
  contest.series[0].trials[1].by = {{Criterion::energy, 0.046}, {Criterion::constraint, 0.25}};
  contest.least =
      Instead{"one angle", {degree}, 1e-8, {{Criterion::energy, 0.01}, {Criterion::constraint, 0}}};
  const std::string text = engines_text({contest}, {60, 120}, false, {});
  INFO(text);
  for (const char* said : {"enough is 5 % in energy and 0.001 m in the constraint",
                           "29 % in energy and 0.0005 m in the constraint", "4.6 % in energy",
                           "errs by 1 % in energy and 0 m in the constraint"})
    CHECK(text.find(said) != std::string::npos);
  const std::string csv = to_csv(engines_table({contest}));
  CHECK(csv.find("restored,off_energy,off_constraint\n") != std::string::npos);
  CHECK(csv.find(",0.046,0.25\n") != std::string::npos);
  contest.criteria = {{Criterion::path, 1}};
  CHECK(to_csv(engines_table({contest})).find("restored\n") != std::string::npos);
}

TEST_CASE("an engine's result is put into words, also where it gave no answer", "[engines]") {
  EngineContest contest{"3.5", "Pendulum", {"rad"}, {degree}, 10, 60, {}};
  contest.series = {series_of("First", {4, 0.5})};
  CHECK(engine_answer(contest, {}).find("it errs by 4 deg; 2 steps a frame bring 0.5 deg") !=
        std::string::npos);
  EngineTrial& trial = contest.series[0].trials[0];
  trial.outcome = Outcome::non_finite;
  trial.errors = {std::nan("")};
  CHECK(engine_answer(contest, {}).find("its numbers are infinite or none") != std::string::npos);
  trial.outcome = Outcome::raised;
  trial.message = "signal 6";
  CHECK(engine_answer(contest, {}).find("it gives no answer: signal 6") != std::string::npos);
}
