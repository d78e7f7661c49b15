// Every part of an argument is used or refused.

#include <array>
#include <limits>
#include <vector>

#include "reference/quantity_text.hpp"
#include "report/cli/asked.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using program::says;

namespace {

std::string refused(const std::string& exercise, const AskedNeed& asked) {
  return complaint([&] { need_of(task_of(exercise, {}), asked); });
}

struct Case {
  std::string arguments, message;
};

void check_refused(const std::vector<Case>& cases) {
  for (const auto& [arguments, message] : cases) {
    const program::Ran ran = program::run(arguments);
    INFO("oddity " << arguments << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, message));
    CHECK_FALSE(says(ran, "internal"));
  }
}

}  // namespace

TEST_CASE("an error is one number, or one with its unit for each unit of the motion", "[arguments]") {
  const auto of = [](const std::string& exercise, const std::string& error) {
    return refused(exercise, {.error = error});
  };
  for (const char* error : {"1", "1deg", "+1deg", "0.001 rad"}) CHECK(of("3.5", error) == "nothing");
  for (const char* error : {"1", "1cm,1deg", "1deg,1cm"}) CHECK(of("3.31", error) == "nothing");
  CHECK(
      of("3.5", "1,5deg") ==
      "--error: '1' in '1,5deg' has no unit: give one number for all, or one with its unit for each of rad. "
      "A number has a point, as in 1.5deg");
  CHECK(of("3.5", "0.001,5deg").find("'0.001' in '0.001,5deg' has no unit") != std::string::npos);
  CHECK(of("3.5", "1deg,1e9").find("'1e9' in '1deg,1e9' has no unit") != std::string::npos);
  CHECK(of("3.5", "1deg,") == "--error: '1deg,' has nothing behind its last comma");
  CHECK(of("3.5", ",1deg") == "--error: ',1deg' has nothing before a comma");
  CHECK(of("3.5", "1deg,2deg") == "--error: '1deg,2deg' has two errors in rad");
  CHECK(of("3.31", "1cm,5deg,7").find("'7' in '1cm,5deg,7' has no unit") != std::string::npos);
  CHECK(of("3.31", "1,1cm,1deg").find("'1' in '1,1cm,1deg' has no unit") != std::string::npos);
  CHECK(need_of(task_of("3.5", {}), {.error = "+1deg"}).shown.at("rad").symbol == "deg");
  // a number without a unit has the quantity's unit
  CHECK(need_of(task_of("3.7", {}), {.error = "1e-3", .constraint = "0.001"}).shown.at("m").symbol == "m");
}

TEST_CASE("a count is written in digits", "[arguments]") {
  CHECK(parse_count("0") == 0);
  CHECK(parse_count("40") == 40);
  for (const char* none : {"", "010", "0x10", "1e2", "1.0", "+1", "-1", " 1", "1 ", "2147483648"})
    CHECK_FALSE(parse_count(none));
  CHECK(count_of("--n", "10", 1, 10) == 10);
  CHECK(complaint([] { count_of("--n", "1e1", 1, 10); }) ==
        "--n must be a whole number from 1 to 10, and is '1e1': write it in digits alone");
  CHECK(complaint([] { count_of("--n", "11", 1, 10); }) ==
        "--n must be a whole number from 1 to 10, and is '11'");
  for (const char* part : {"1.0/2e0", "+1/+2", "1/02", "1/2/3", "0/2", "3/2", "1/", "/2"})
    CHECK(complaint([&] { shard_of(part); }).find("--shard is a part of the whole") == 0);
  CHECK(shard_of("2/7").of == 7);
}

TEST_CASE("an exercise has one number", "[arguments]") {
  CHECK(exercise_number("3.5") == Number{3, 5});
  for (const char* none : {"3.05", "003.005", "03.5", "+3.5", "3.+5", "3.-5", "3.5.", "3", ".5", "3."})
    CHECK_FALSE(exercise_number(none));
}

TEST_CASE("a unit has no meaningless part", "[arguments]") {
  for (const char* wrong : {"1deg1", "1deg^1", "1rad0", "2 1", "21 1", "5 1 1"})
    CHECK(complaint([&] { in_unit(wrong, "rad"); }).find("is not a number, nor one with a unit") !=
          std::string::npos);
  for (const char* wrong : {"10/1s", "10/1/s", "10 1s", "+-10s"})
    CHECK(complaint([&] { in_unit(wrong, "s"); }) != "nothing");
  CHECK(in_unit("60 1/s", "1/s") == 60);
  CHECK(in_unit("9.81m/s2", "m/s^2") == 9.81);
  CHECK(in_unit("3", "1") == 3);
}

TEST_CASE("every number of a need has limits", "[arguments]") {
  const auto with = [](auto AskedNeed::*member, const char* text) {
    AskedNeed asked{.error = "1deg"};
    asked.*member = text;
    return refused("3.5", asked);
  };
  for (auto member : {&AskedNeed::error, &AskedNeed::horizon, &AskedNeed::frames_per_second,
                      &AskedNeed::budget, &AskedNeed::restart_every, &AskedNeed::time_limit,
                      &AskedNeed::bodies, &AskedNeed::jitter, &AskedNeed::drop, &AskedNeed::longest_frame})
    for (const char* far : {"1e-320", "5e-324", "1e-300", "1e300", "1e400", "0", "-1", "inf", "nan", ""}) {
      if (*far == 0 &&
          (member == &AskedNeed::budget || member == &AskedNeed::restart_every ||
           member == &AskedNeed::jitter || member == &AskedNeed::drop || member == &AskedNeed::longest_frame))
        continue;
      INFO(far);
      CHECK(with(member, far) != "nothing");
    }
  CHECK(with(&AskedNeed::restart_every, "1e-300") ==
        "--restart-every goes from 3.255e-05 to 1.667e+04 s, and is 1e-300");
  for (const char* every : {"1ms", "20s", "1h"}) CHECK(with(&AskedNeed::restart_every, every) == "nothing");
}

TEST_CASE("frames are as recorded, or random by a seed", "[arguments][frames]") {
  const ScratchFolder scratch;
  scratch.file("trace", "# ms\n10ms\r\n\n30ms\n");
  scratch.file("broken", "10ms\nsoon\n");
  scratch.file("none", "# nothing\n");
  const auto with = [&](const std::string& trace) {
    AskedNeed asked{.error = "1deg"};
    asked.trace = (scratch.path() / trace).string();
    return asked;
  };
  const Need need = need_of(task_of("3.5", {}), with("trace"));
  REQUIRE(need.frame_times);
  CHECK(near(need.frame_times->at[2], 0.05, 1e-15));
  CHECK(near(need.frames_per_second, 50, 0.1));
  CHECK(refused("3.5", with("broken")).find("broken:2") != std::string::npos);
  CHECK(refused("3.5", with("none")).find("has no frames") != std::string::npos);
  CHECK(refused("3.5", with("absent")).find("cannot read") != std::string::npos);
  AskedNeed seed{.error = "1deg"};
  seed.frame_seed = "2";
  CHECK(refused("3.5", seed) == "--frame-seed is of --jitter or --drop, and neither is asked for");
  seed.jitter = "20%";
  CHECK(refused("3.5", seed) == "nothing");
  seed.bodies = "2";
  CHECK(refused("3.5", seed) == "frames of different lengths are judged for one body");
}

TEST_CASE("the time limit of an answer is a minute by default", "[arguments]") {
  const auto limit = [](AskedNeed asked) {
    asked.error = "1deg";
    return need_of(task_of("3.5", {}), asked).time_limit;
  };
  CHECK(limit({}) == 60);
  CHECK(limit({.time_limit = "2min"}) == 120);
  CHECK(limit({.time_limit = "none"}) == std::numeric_limits<double>::infinity());
  CHECK(says(program::run("choose --help"), "--time-limit TIME=60s"));
}

TEST_CASE("unused parts of the command line are refused", "[arguments]") {
  check_refused({
      {"choose 3.5 --error 1 --error 2", "--error is given twice"},
      {"choose 3.5 --error 1deg --json --json", "--json is given twice"},
      {"choose 3.5 --error=1 --cheapest=false", "--cheapest takes no value"},
      {"list --json=0", "--json takes no value"},
      {"sweep status /tmp/x --csv --csv", "--csv is given twice"},
      {"verify --shard 1/2 --shard 2/2", "--shard is given twice"},
      {"verify '[3.5]' -r junit -r console", "-r is given twice"},
      {"solve 3.5 ''", "an argument is empty"},
      {"help choose extra", "help of 'choose' has no 'extra'"},
      {"help sweep plane", "its verbs are: plan, run"},
      {"report --chapter 3.0", "--chapter must be a whole number from 1 to 14, and is '3.0'"},
      {"verify --shard 1.0/2e0", "--shard is a part of the whole"},
      {"solve 3.05", "no exercise '3.05'"},
      {"solve 003.005", "no exercise '003.005'"},
      {"engines 3.5 --kept --finest 0x10", "--finest must be a whole number from 1 to 4096, and is '0x10'"},
      {"engines 3.5 --kept --hz 60,", "--hz: '60,' has nothing behind its last comma"},
      {"engines 3.5 --kept --hz 0x3C", "--hz: '0x3C' is not a number"},
      {"sweep run /tmp/x --threads 010", "--threads must be a whole number"},
      {"sweep run /tmp/x --slurm 5 --threads 3", "do not go together"},
      {"sweep run ''", "folder: it needs a path"},
      {"choose 3.5 --error 1deg --bodies 1e3",
       "--bodies must be a whole number from 1 to 1000000, and is '1e3'"},
      {"choose 3.5 --error 1deg --only Adams --restart-every 1e-320", "--restart-every goes from"},
  });
  CHECK(says(program::run("help sweep plan"), "--looks"));
}

TEST_CASE("a sweep's plan uses all of its arguments", "[arguments]") {
  const ScratchFolder scratch;
  const std::string plan = "sweep plan " + scratch.path().string() +
                           " 3.5 --model 'one angle' --algorithm 'Runge-Kutta 4' --over a=1deg..179deg:10 ";
  check_refused({
      {plan + "--setting 0.1 --looks 010", "--looks must be a whole number from 1 to 1000000, and is '010'"},
      {plan + "--setting 0.1 --looks 0x10", "and is '0x10'"},
      {plan + "--setting 0.1 --error 1deg,1e9", "'1e9' in '1deg,1e9' has no unit"},
      {plan + "--over g=9..9.000000000000002:1000000 --setting 0.1", "too narrow for double precision"},
      {"sweep plan " + scratch.path().string() +
           " 3.5 --model 'one angle' --algorithm 'Fehlberg 7(8)' --over a=1deg..179deg:10 --setting 1s",
       "--setting: '1s' has a unit that does not fit: this one has no unit"},
  });
}

TEST_CASE("a part of a test specification that selects nothing is refused", "[arguments]") {
  check_refused({
      {"verify '[3.5],[99.9]'", "no test case matches '[99.9]'"},
      {"verify '[3.5]~[99.9]'", "no test case matches '[99.9]'"},
      {"verify '[3.5],[erratumm]'", "did you mean '[erratum]'?"},
      {"verify '[9.1],nonsense*'", "no test case matches 'nonsense*'"},
      {"verify '[3.5'", "has no ']' for its '['"},
      {"verify '~'", "excludes nothing behind its '~'"},
      {"verify '[9.1]~'", "excludes nothing behind its '~'"},
      {"verify ','", "has an empty part next to a comma"},
      {"verify '[9.1],'", "has an empty part next to a comma"},
      {"verify '\\'", "ends with a backslash"},
      {"verify '[]'", "has an empty tag"},
      {"verify '[7.1]' ''", "an argument is empty"},
      {"verify '\"9.1'", "has no '\"' for its '\"'"},
  });
  CHECK(program::run("verify '[9.1]~[scene]'").status == 0);
  CHECK(program::run("verify '9.1*'").status == 0);
}

TEST_CASE("a tag with a changed meaning has a hint at the tags that select the rest", "[arguments]") {
  const auto selected = [](const std::string& specification) {
    return program::run("verify --list-tests '" + specification + "'");
  };
  const std::string lost = "[lost] selects losses in our copy";
  for (const char* specification : {"[misprint]", "[Misprint]", "[3.5][misprint]", "[3.5],[misprint]"}) {
    INFO(specification);
    CHECK(says(selected(specification), lost));
  }
  CHECK(says(selected("[erratum]"), "[erratum] selects both [wrong] and [incomplete]"));
  CHECK_FALSE(says(selected("[lost]"), lost));
  CHECK_FALSE(says(selected("[erratum]"), lost));
}

TEST_CASE("a user's method is judged at its step", "[arguments][is_enough]") {
  const std::string ask = "choose 3.5 --error 1deg --horizon 4 ";
  const program::Ran good = program::printed(ask + "--method RK4@60Hz --model 'one angle'");
  INFO(good.output);
  CHECK(good.status == 0);
  CHECK(says(good, "Good enough: Runge-Kutta 4 at 60 Hz, judged 60 times a second on 6 starts."));
  CHECK(says(good, "one angle: holds, error "));
  CHECK(says(good, "its error "));
  CHECK(says(good, " of the longest stable one, "));
  CHECK(says(good, "Take "));
  const program::Ran bad = program::printed(ask + "--method 'Euler@1/60' --model 'one angle'");
  INFO(bad.output);
  CHECK(bad.status == 1);
  CHECK(says(bad, "Not good enough: explicit Euler at 60 Hz"));
  CHECK(says(bad, "its error grows"));
  CHECK(says(bad, "fails on 6 of 6 starts"));
  const program::Ran rows = program::printed(ask + "--method 'Euler Cromer@16ms' --starts 1 --csv");
  INFO(rows.output);
  CHECK(says(
      rows,
      "exercise,model,algorithm,resolution,setting,holds,outcome,where,error_in_needs,starts,failing,growth,"));
  CHECK(says(rows, ",step,0.016,"));
}

TEST_CASE("a user's method needs a name, a model and a step that exist", "[arguments][is_enough]") {
  const std::string ask = "choose 3.5 --error 1deg ";
  check_refused({
      {ask + "--method 'Runge-Kuta 4@60Hz'", "did you mean 'Runge-Kutta 4'?"},
      {ask + "--method RK4@60", "a step needs its unit, as in @60Hz or @16ms"},
      {ask + "--method RK4@", "a step needs its unit"},
      {ask + "--method RK4@1kg", "--method: '1kg' has a unit that does not fit"},
      {ask + "--method RK4@1/0", "--method must be positive and finite"},
      {ask + "--method RK4@60Hz --model zzz", "no model of 3.5 has 'zzz' in its name and Runge-Kutta 4"},
      {ask + "--method 'Dormand-Prince 5(4)'", "--method: the tolerance of Dormand-Prince 5(4)"},
      {ask + "--model 'one angle'", "--method"},
      {ask + "--starts 0", "--starts must be a whole number from 1 to 100"},
  });
  const auto step = [](const char* text) {
    const Task task = task_of("3.5", {});
    const AskedNeed asked{.error = "1deg", .method = text};
    return method_of(task, asked, need_of(task, asked)).setting;
  };
  for (const char* sixtieth : {"RK4@60Hz", "RK4@1/60", "rk4@60/s", "RK4", "Runge-Kutta 4@1/60s"})
    CHECK(near_ulps(step(sixtieth), 1.0 / 60, 64));
  CHECK(step("Verlet@5ms") == 0.005);
}

TEST_CASE("the requested start may be judged alone", "[arguments]") {
  const program::Ran ran = program::printed(
      "choose 3.3 r0=1 r0_dot=0 theta0=0 theta0_dot=7.5 --error 0.01 --only Kepler --starts 1");
  INFO(ran.output);
  CHECK(ran.status == 0);
  CHECK(says(ran, "on the start asked for alone it is "));
}

TEST_CASE("an hour of chaos is answered, up to the time until which the motion is known",
          "[arguments][choose]") {
  const program::Ran ran = program::run("choose 3.25 theta1=1.5 --error 1cm --horizon 1h");
  INFO(ran.output);
  CHECK(ran.status == 1);
  CHECK(says(ran, "the true motion is known up to "));
}

TEST_CASE("a horizon whose first part has no two periods is judged as well", "[arguments][choose]") {
  CHECK(program::run("choose 3.5 --criterion period --error 1% --horizon 20 --fps 1000").status == 0);
}

TEST_CASE("stability shows the largest step at which a requested criterion holds", "[arguments][stability]") {
  using program::printed;
  const std::string energy = "stability 3.5 --horizon 5s --criterion energy --error 5%";
  const program::Ran csv = printed(energy + " --csv"), json = printed(energy + " --json");
  INFO(csv.output.substr(0, 1500));
  CHECK(csv.status == 0);
  CHECK(says(csv, ",how,cure,holds_to\n"));
  CHECK(says(json, "\"holds_to\""));
  CHECK_FALSE(says(printed("stability 3.5 --horizon 5s --csv"), "holds_to"));
  CHECK(says(printed("stability 3.5 --horizon 5s --criterion path --csv"), "holds_to"));
  const ScratchFolder out;
  const program::Ran text = printed(energy + " --out " + out.path().string());
  CHECK(says(text, "holds to [s]"));
  CHECK(says(text, "with its energy right to 5 % (relative to its moving part), at the end of every step"));
  check_refused({
      {"stability --criterion energy --error 1%", "--error is of an exercise: name one, such as 3.5"},
      {"stability 3.5 --criterion energy", "--criterion energy needs --error"},
      {"stability 3.5 --error 1deg --horizon 1e-12", "--error takes a --horizon from 4.1e-09 on"},
      {"stability 3.5 --criterion bounded --error 1", "--criterion bounded takes no --error"},
      {"stability 3.5 --criterion heat", "heat"},
      {"stability 3.5 --criterion energy --error 1% --energy 1%",
       "--energy: --criterion selects this measure already"},
      {"stability 3.5 --error 1cm", "--error"},
      {"stability 3.5 --period 1% --rows", "do not go together"},
      {"stability 3.9 a=0 --criterion constraint --error 1mm", "has a constraint to be off"},
      {"stability 3.31 --period 1%", "two periods"},
      {"stability 3.25 theta1=1.5 --error 1cm --horizon 30s", "not known to a tenth of the requested error"},
      {"stability 3.5 --csv --time-limit 1ms", "no answer within the time limit"},
      {"stability 3.5 --csv --time-limit -1s", "--time-limit must be positive"},
      {"chart 3.5 --csv --time-limit 1ms", "no answer within the time limit"},
  });
}

TEST_CASE("stability has all columns of its table, at other parameters and over another horizon",
          "[arguments]") {
  const program::Ran csv = program::printed("stability 3.5 a=1 L=2 --horizon 5s --csv");
  INFO(csv.output.substr(0, 400));
  CHECK(csv.status == 0);
  CHECK(says(csv,
             "why,unstable_in_theory,error_there,needed_to,not_sharp_from,not_sharp_to,watched,how,cure\n"));
  CHECK(csv.output != program::printed("stability 3.5 --csv").output);
  CHECK(says(program::printed("stability 3.5 --json"), "\"needed_to\""));
  check_refused({
      {"stability 3.5 3.7 a=1", "'a=1' is of one exercise, and 2 are named"},
      {"stability a=1", "'a=1' is of one exercise, and none is named"},
      {"stability 3.5 zeta=1", "no parameter 'zeta'"},
      {"stability 3.5 a=1 --rows", "leave 'a=1' out"},
      {"stability 3.5 --horizon 1kg", "--horizon: '1kg' has a unit that does not fit"},
      {"stability 3.5 --horizon 5s --rows", "do not go together"},
      {"engines 3.5 a=1 --kept", "leave 'a=1' out"},
      {"engines 'free body' --horizon 5s", "--horizon is of an exercise"},
      {"engines --criterion energy --error 1%", "--error is of an exercise"},
      {"engines 'chain of 10' --constraint 1mm", "--constraint is of an exercise"},
      {"engines 3.5 --energy 1% --kept", "leave '--energy' out"},
      {"engines 3.5 --criterion energy", "--criterion energy needs --error"},
      {"engines 3.5 --criterion heat --error 1%", "heat"},
      {"engines 3.5 --error 1cm", "has a unit that does not fit"},
  });
}

TEST_CASE("moments of inertia that no body can have are refused", "[arguments]") {
  check_refused({{"choose 3.33 mu3=0.126 --error 1deg",
                  "no body has these moments: mu1 - m l^2, which is 0.0625 kg m^2"},
                 {"choose 3.33 m=2 --error 1deg", "must be positive, and half of mu3 at least"},
                 {"solve 3.35 l=0.4", "no body has these moments"},
                 {"solve 3.33 mu1=0.07", "no body has these moments"}});
}

TEST_CASE("a sweep of choices accepts a criterion", "[arguments]") {
  const ScratchFolder scratch;
  const std::string map = scratch.path().string();
  const program::Ran plan = program::run(
      "sweep plan " + map + " 3.5 --over a=10deg..30deg:2 --criterion energy --error 0.01 --horizon 1");
  INFO(plan.output);
  CHECK(plan.status == 0);
  CHECK(says(program::shell("cat " + map + "/plan.json"), "\"criterion\": \"energy\""));
  CHECK(program::run("sweep run " + map).status == 0);
  check_refused(
      {{"sweep plan " + map +
            "/x 3.5 --model 'one angle' --algorithm 'Runge-Kutta 4' --over a=10deg..30deg:2 "
            "--setting 0.01 --criterion energy --error 0.01",
        "applies to the method chosen at each cell"},
       {"sweep plan " + map + "/x 3.5 --over a=10deg..30deg:2 --criterion energy", "needs --error"}});
}
