#include <array>
#include <filesystem>
#include <fstream>

#include "report/verify/catch.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

namespace fs = std::filesystem;
using namespace program;

namespace {

/// A copy of the reference tables, to be damaged.
fs::path tables(const ScratchFolder& scratch) {
  for (const char* room : {"tables", "approved"})
    fs::copy(fs::path(ODDITY_SOURCE) / "reference" / room, scratch.path() / room,
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  return scratch.path();
}

void replace_in(const fs::path& file, const std::string& old, const std::string& fresh) {
  std::ifstream in(file);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto at = text.find(old);
  REQUIRE(at != std::string::npos);
  text.replace(at, old.size(), fresh);
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("list shows exercises with their parameters", "[commands]") {
  const Ran ran = run("list");
  CHECK(ran.status == 0);
  CHECK(says(ran, "3.5  Pendulum"));
  CHECK(says(ran, "a = 0.5235987755982988 rad  angle at release (0.001 to 3.14)"));
  CHECK(says(ran, "n = 40  size of the triangular matrix (whole, 2 to 100)"));
  CHECK(says(ran, "h = 0.25  distance"));  // without a unit
  const Ran one = run("list 3.5");
  CHECK(says(one, "3.5  Pendulum"));
  CHECK_FALSE(says(one, "3.7"));
  const Ran about = run("list 2.1 pendulum");
  CHECK(says(about, "2.1  Curve"));
  CHECK(says(about, "3.17  Foucault pendulum"));
  CHECK_FALSE(says(about, "3.7"));
}

TEST_CASE("list finds exercises by the usual names of things", "[commands][about]") {
  const std::vector<std::array<std::string, 2>> cases{{"cone", "3.17"},
                                                      {"free", "3.33"},
                                                      {"bounc", "6.3"},
                                                      {"bouncing", "6.3"},
                                                      {"bounce", "6.5"},
                                                      {"top", "3.33"},
                                                      {"gyroscope", "3.33"},
                                                      {"gyro", "3.35"},
                                                      {"spring", "3.9"},
                                                      {"springs", "3.19"},
                                                      {"kepler", "3.3"},
                                                      {"planet", "3.3"},
                                                      {"orbit", "3.27"},
                                                      {"double pendulum", "3.25"},
                                                      {"pendullum", "3.5"},
                                                      {"Pendulums", "3.17"},
                                                      {"rope", "3.25"},
                                                      {"friction", "3.31"},
                                                      {"crate", "3.31"},
                                                      {"collision", "6.3"},
                                                      {"matrix determinant", "7.9"},
                                                      {"oscillator", "3.9"},
                                                      {"latitude", "3.17"},
                                                      {"closest point", "9.1"},
                                                      {"cone", "3.17"},
                                                      {"bounce", "6.3"},
                                                      {"free", "3.11"},
                                                      {"top", "3.33"}};
  for (const auto& [words, number] : cases) {
    const Ran ran = run("list '" + words + "'");
    INFO(words << "\n" << ran.output);
    CHECK(ran.status == 0);
    CHECK(says(ran, number + "  "));
  }
  for (const char* word : {"bounc", "bounce"})
    CHECK(says(run(std::string("list ") + word), "oddity engines 'bouncing ball'"));
  CHECK(run("list gyroscope").output.starts_with("3.21  "));
  const Ran none = run("list pandulamo");
  CHECK(none.status == 2);
  CHECK(says(none, "did you mean 'pendulum'? './oddity list' shows all"));
  CHECK(run("list zzzz").status == 2);
}

TEST_CASE("list and stability come as CSV and as JSON", "[commands]") {
  CHECK(says(run("list 3.5 --csv"),
             "exercise,title,scene,parameter,value,unit,least,most,whole,says\n"
             "3.5,Pendulum from 30 degrees,1,a,0.5235987755982988,rad,0.001,3.14,0,angle"));
  CHECK(says(run("list 3.5 --json"), "\"parameter\": \"a\",\n  \"value\": 0.5235987755982988"));
  CHECK(says(run("stability 3.5 --csv"), "\n3.5,one angle,velocity Verlet,0.67"));
  CHECK(says(run("stability 3.5 --json"), "\"algorithm\": \"velocity Verlet\""));
}

TEST_CASE("a repeated question gets the same answer, with the source of its times", "[commands]") {
  const std::string question = "choose 3.5 --error 1deg --horizon 1 --all";
  const Ran anew = printed(question + " --measure");
  CHECK(anew.status == 0);
  CHECK(says(anew, "\ntimes: measured in this run on this machine"));
  const Ran kept = printed(question);
  CHECK(says(kept, "\ntimes: those of an earlier run of this program on this machine; --measure"));
  CHECK(kept.output.substr(0, kept.output.find("\ntimes: ")) ==
        anew.output.substr(0, anew.output.find("\ntimes: ")));
  for (int i = 0; i < 3; ++i) CHECK(printed(question).output == kept.output);
}

TEST_CASE("choose takes no method with a history when none is wanted", "[commands]") {
  const std::string asked = "choose 3.5 --error 1e-9 --all --csv";
  for (const char* multistep : {"Adams-Bashforth", "Adams-Bashforth-Moulton", "GSL msadams", "GSL msbdf"}) {
    INFO(multistep);
    CHECK(says(printed(asked), multistep));
    CHECK_FALSE(says(printed(asked + " --one-step"), multistep));
  }
}

TEST_CASE("choose asks for a constraint's error as a length", "[commands]") {
  const Ran ran = run("choose 3.5 --criterion constraint --error 1mm --horizon 1 --only Cartesian");
  CHECK(ran.status == 0);
  CHECK(says(ran, "swing with its constraints off by 1 mm at most, at every frame"));
  const Ran free = run("choose 3.27 --criterion constraint --error 1mm --horizon 1");
  CHECK(free.status == 2);
  CHECK(says(free, "no model here has a constraint"));
}

TEST_CASE("every command has help with an example", "[commands]") {
  for (const std::string verb : {"list", "verify", "solve", "chart", "report", "site", "stability", "choose",
                                 "bench", "engines", "sweep", "prove", "trust", "new"}) {
    const Ran ran = run(verb + " --help");
    INFO(ran.output);
    CHECK(ran.status == 0);
    CHECK(says(ran, "Example"));
    CHECK(run("help " + verb).output == ran.output);
  }
  CHECK(run("help").output == run("--help").output);
  CHECK(says(run("--help"), "\nStart with:\n  oddity list\n"));
  CHECK(says(run("choose --help"), "\nScenes: 2.7, "));
  CHECK(run("-v").output == run("--version").output);
}

TEST_CASE("solve accepts parameters and names the source of its reference", "[commands]") {
  const Ran tabulated = run("solve 3.5");
  CHECK(tabulated.status == 0);
  CHECK(says(tabulated, "table 03_05_quarter_period.csv"));
  const Ran own = run("solve 3.5 a=2.4");
  CHECK(own.status == 0);
  CHECK(says(own, "computed on the spot"));
  const Ran json = printed("solve 3.5 a=2.4 --json");
  CHECK(json.status == 0);
  CHECK(json.output.front() == '{');
  CHECK(says(json, "\"number\": \"3.5\""));
}

TEST_CASE("stability shows the limits and draws the maps", "[commands]") {
  const ScratchFolder scratch;
  const Ran ran = run("stability 3.5 --out " + scratch.path().string());
  CHECK(ran.status == 0);
  CHECK(says(ran, "explicit Euler"));
  CHECK(says(ran, "unstable in theory"));
  CHECK(fs::file_size(scratch.path() / "charts" / "3.5_stability.svg") > 10'000);
  const Ran rows = run("stability 3.5 --rows");
  CHECK(says(rows, "3.5,one angle,velocity Verlet,0.676,0.639,from 0.639,,,0.99,0.0521,diverged,"));
}

TEST_CASE("bad input is named and ends with exit code 2", "[commands]") {
  const std::vector<std::array<std::string, 2>> cases{
      {"solve 3.6", "no exercise '3.6'; chapter 3 has 3.1, 3.3"},
      {"solve 3.50", "no exercise '3.50'; chapter 3 has 3.1, 3.3"},
      {"solve 3.50", "; did you mean 3.5 (Pendulum from 30 degrees)?"},
      {"solve 1.1", "no exercise '1.1'; chapter 1 has none; './oddity list' shows all"},
      {"solve '3.5 '", "did you mean 3.5 (Pendulum from 30 degrees)?"},
      {"solve pendulum", "3.5 (Pendulum from 30 degrees) or 3.17"},
      {"solve Pendelum", "3.5 (Pendulum from 30 degrees)"},
      {"solve three", "no exercise 'three'"},
      {"solve", "exercise is required; './oddity solve --help' shows more"},
      {"solve 3.5 b=1", "no parameter 'b'; the parameters are: a, L, g"},
      {"solve 3.5 l=1", "did you mean L (length)?"},
      {"solve 3.5 angle=1", "did you mean a (angle at release)?"},
      {"solve 3.5 a=x", "'x' is not a number"},
      {"solve 3.5 a=30kg",
       "parameter a: '30kg' has a unit that does not fit; units that fit: rad, mrad, deg"},
      {"solve 3.5 a=1 a=2", "parameter a is given twice"},
      {"solve 3.5 a", "'a' is not name=value: write it without blanks, as in a=30deg"},
      {"solve 3.5 = 1", "'=' is not name=value: write it without blanks, as in a=30deg"},
      {"solve 3.5 a= 1", "parameter a: '' is not a number"},
      {"solve 3.5 =1", "'=1' is not name=value"},
      {"solve 3.5 3.7", "'3.7' is not name=value, and one exercise is asked for at a time"},
      {"solve 3.5 a=30degg",
       "parameter a: '30degg' is not a number, nor one with a unit; units that fit: rad"},
      {"solve 3.5 a=4", "out of its range"},
      {"solve 3.5 a=nan", "out of its range"},
      {"solve 7.11 n=40.7", "parameter n = 40.7 is not a whole number"},
      {"solve 7.11 seed=1.5", "parameter seed = 1.5 is not a whole number"},
      {"solve 3.5 --jsn", "solve does not take '--jsn'; did you mean '--json'?"},
      {"list 3.5 qwx", "no exercise 'qwx'; './oddity list' shows all"},
      {"site 3.5", "for an exercise, --single 3.5 writes the page"},
      {"report --chapter 15", "--chapter must be a whole number from 1 to 14, and is '15'"},
      {"report --chapter x", "--chapter must be a whole number from 1 to 14, and is 'x'"},
      {"report --chapter 1", "chapter 1 has no exercises; those that have some are: 2, 3, "},
      {"report --out ''", "--out: it needs a path"},
      {"chart --out ''", "--out: it needs a path"},
      {"chart 3.4", "no exercise '3.4'"},
      {"chart 2.13 --fps 30", "exercise 2.13 has no motion"},
      {"chart 3.5 --frame-seed 2", "--frame-seed is of --jitter or --drop"},
      {"chart 3.5 --horizon 1ms", "the horizon is shorter than a frame"},
      {"stability 3.6", "no exercise '3.6'"},
      {"stability 9.1", "exercise 9.1 has no motion; those that have one are: "},
      {"stability 3.5 --rows --out /tmp/x", "--rows and --out do not go together"},
      {"stability 3.5 --csv --json", "do not go together; './oddity stability --help' shows more"},
      {"chart 3.5 --csv --out /tmp/x", "--csv and --out do not go together"},
      {"choose 9.1 --error 1", "exercise 9.1 has no motion; those that have one are: "},
      {"choose 3.5", "choose needs --error or --digits"},
      {"choose 3.5 --error nan", "--error must be positive and finite, and is nan"},
      {"choose 3.5 --error inf", "--error must be positive and finite, and is inf"},
      {"choose 3.5 --error 0", "--error must be positive and finite, and is 0"},
      {"choose 3.5 --error=-1", "--error must be positive and finite, and is -1"},
      {"choose 3.5 --error 1cm", "units that fit: rad, mrad, deg"},
      {"choose 3.5 --error 1,0.01", "'1' in '1,0.01' has no unit: give one number for all"},
      {"choose 3.5 --error 1 --budget ''", "--budget: it needs a value"},
      {"engines 3.55 --kept", "engines have no scene '3.55'"},
      {"engines 3.5 --kept --hz 60,100",
       "--hz: engines are tried at 60 Hz, 120, 240 and so on, and not at 100"},
      {"verify '[scene]' --shard 1/2", "--shard takes its share of all exercises"},
      {"verify --shard ''", "--shard: it needs a value"},
      {"choose 3.31 --error 1cm", "--error: the observables are in m, rad, and none is given in rad"},
      {"choose 3.5 --digits 16", "--digits must be a whole number from 1 to 15, and is '16'"},
      {"choose 3.5 --error 1 --digits 3", "--error and --digits do not go together"},
      {"choose 3.5 --error 1 --fps 1e12",
       "asks for 1e+13 frames, of at most a million: --fps may be 100000 over"},
      {"choose 3.5 --error 1 --fps nan", "--fps must be positive and finite, and is nan"},
      {"choose 3.5 --error 1 --horizon 1e9",
       "asks for 6e+10 frames, of at most a million: --horizon may be 16666.6 s at"},
      {"choose 3.5 --error 1 --horizon 1m", "'1m' has a unit that does not fit; units that fit: s, ms"},
      {"choose 3.5 --error 1 --horizon 1ms", "the horizon is shorter than a frame"},
      {"choose 3.5 --error 1 --code --json", "--json and --code do not go together"},
      {"choose 3.5 --error 1 --horizon 1 --only Fehlberg --code",
       "there is no code to print for the algorithm Fehlberg 7(8); there is for: closed form; explicit "
       "Euler; "},
      {"choose 3.5 --error 1 cm",
       "'cm' is not name=value: a unit follows its number without a blank, as in 1cm"},
      {"choose 3.5 --error 1 --only Runge-Kuta",
       "--only: no model and no algorithm of 3.5 has 'Runge-Kuta' in its name; did you mean 'Runge-Kutta'?"},
      {"choose 3.5 --error 1 --only verlet", "did you mean 'Verlet'?"},
      {"choose 3.5 --error 1 --only 'Cartesian with constrain t'",
       "did you mean 'Cartesian with constraint'?"},
      {"choose 3.5 --error 1 --exclude Eulr", "did you mean 'Euler'?"},
      {"choose 3.5 --error 1 --exclude zzz", "the models are: small angle; amplitude-corrected; "},
      {"choose 3.5 --error 1 --precision flot",
       "--precision 'flot' is not one of float, double, any; did you mean float?"},
      {"choose 3.5 --error 1 --criterion enrgy", "did you mean energy?"},
      {"choose 3.5 --error 1 --budget 5", "--budget needs a unit, such as 5us"},
      {"choose 3.5 --error 1 --budget 0",
       "--budget must be positive, and have a unit, such as 5us, and is 0"},
      {"choose 3.5 --error 1 --horizon 16666.7", "--horizon may be 16666.6 s at that rate"},
      {"choose 3.5 --error 1 --budget 5US", "'5US' is not a number, nor one with a unit"},
      {"sovle 3.5", "no verb 'sovle'; the verbs are: "},
      {"sovle 3.5", "did you mean 'solve'?"},
      {"help sovle", "did you mean 'solve'?"},
      {"3.5", "no verb '3.5'; did you mean 'solve 3.5'?"},
      {"nonsense", "no verb 'nonsense'; the verbs are: list, verify, "},
      {"--refrence x list", "oddity does not take '--refrence'; did you mean '--reference'?"},
      {"chart --out", "--out needs a value"},
      {"--json", "oddity does not take '--json'"},
      {"--reference '' list", "--reference: it needs a path"},
      {"verify --results ''", "--results: it needs a path"},
      {"verify 3.5", "'[3.5]'"},
      {"verify '[9.1]' -o /proc/no/file", "cannot make the folder /proc/no: "},
      {"verify '[9.1]' -o /tmp", "cannot write /tmp: it is a folder"},
      {"verify --no-such-option", "Catch2 does not take these arguments"},
      {"verify '[3.99]'", "no test case matches"},
      {"verify '[wrongg]'",
       "no test case matches '[wrongg]'; --list-tests shows them all; did you mean "
       "'[wrong]'?"},
      {"verify '[3.5]' --json --csv", "do not go together"}};
  for (const auto& [arguments, message] : cases) {
    const Ran ran = run(arguments);
    INFO("oddity " << arguments << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, message));
    CHECK(says(ran, "oddity: "));
    CHECK_FALSE(says(ran, "internal"));
  }
}

TEST_CASE("numbers accept units everywhere", "[commands]") {
  CHECK(says(run("solve 3.5 a=30deg L=50cm g=981cm/s^2"), "a = 0.5235987755982988 rad"));
  CHECK(says(run("solve 3.5 a=30deg L=50cm"), "L = 0.5 m"));
  const Ran chosen = run("choose 3.5 --error 1deg --horizon 2000ms --fps 60Hz --budget 5µs");
  CHECK(chosen.status != 2);
  CHECK(says(chosen,
             "within 1 deg at every frame, over 2 s at 60 frames per second, for at most 5 us per frame"));
}

TEST_CASE("lost output is an error", "[commands]") {
  for (const char* lost :
       {"$oddity list > /dev/full", "$oddity list >&-", "$oddity solve 3.5 --json > /dev/full",
        "$oddity --help > /dev/full", "$oddity stability 3.5 --rows > /dev/full"}) {
    const Ran ran = shell(lost);
    INFO(lost << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, "oddity: cannot write to standard output"));
  }
  const ScratchFolder scratch;
  const std::string folder = scratch.path().string();
  const Ran full = shell("ulimit -f 8; $oddity chart 9.1 --out " + folder);
  CHECK(full.status == 2);
  CHECK(says(full, "oddity: "));
  for (const auto& file : fs::recursive_directory_iterator(scratch.path()))
    CHECK(file.path().extension() != ".part");
  CHECK(shell("$oddity verify '[9.1]' --results " + folder + "/r.json >&-").status == 2);
}

TEST_CASE("output of the suite that a file cannot take is an error", "[commands]") {
  const ScratchFolder scratch;
  const std::string file = scratch.file("out", "before").string();
  for (const std::string reporter : {"console -s", "junit", "markdown"}) {
    const Ran device = run("verify '[9.1]' -o /dev/full -r " + reporter);
    INFO(device.output);
    CHECK(device.status == 2);
    CHECK(says(device, "oddity: cannot write /dev/full: No space left on device"));
    const Ran full = shell("ulimit -f 0; $oddity verify '[9.1]' -o " + file + " -r " + reporter);
    INFO(full.output);
    CHECK(full.status == 2);
    CHECK(says(full, "oddity: cannot write " + file));
    CHECK(shell("cat " + file).output == "before");
  }
  CHECK(says(run("verify '[9.1]' -o /dev/stdout"), "All tests passed"));
  CHECK(run("verify '[9.1]' -o /dev/null").status == 0);
}

TEST_CASE("an interrupted run leaves only complete files", "[commands]") {
  for (const auto& [signal, code] :
       std::array<std::array<std::string, 2>, 3>{{{"INT", "130"}, {"TERM", "143"}, {"HUP", "129"}}}) {
    const ScratchFolder scratch;
    const std::string folder = scratch.path().string();
    // On a busy machine the run may end before it is interrupted: then it is repeated.
    const Ran ran = shell(
        "for time in 1 2 3; do rm -rf " + folder +
        "/charts; env --default-signal=INT nice -n 19 $oddity chart --out " + folder + " & until ls " +
        folder + "/charts >/dev/null 2>&1; do sleep 0.01; done; kill -" + signal +
        " $!; wait $!; code=$?; [ $code -eq 0 ] || break; done; echo ended with $code; sleep 0.5; find " +
        folder + " -name '*.part'");
    INFO(ran.output);
    CHECK(says(ran, "ended with " + code));
    CHECK(says(ran, "oddity: interrupted; every file that was written is whole") == (signal == "INT"));
    CHECK_FALSE(says(ran, ".part"));
  }
}

TEST_CASE("nothing in an option is executed", "[commands]") {
  const ScratchFolder scratch;
  for (const std::string out : {"|touch canary", "$(touch canary)", "`touch canary`", "it'\\''s"}) {
    const Ran ran = shell("cd " + scratch.path().string() + " && $oddity chart 9.1 9.1 --out '" + out + "'");
    INFO(ran.output);
    CHECK(ran.status == 0);
    CHECK_FALSE(fs::exists(scratch.path() / "canary"));
  }
}

TEST_CASE("no command overwrites files of others, unless requested", "[commands]") {
  const ScratchFolder scratch;
  const std::string swept =
      " 3.5 --model 'one angle' --algorithm 'Runge-Kutta 4' --over a=1..2:2 --setting 0.1 --looks 4";
  for (const auto& [words, file] :
       std::vector<std::array<std::string, 2>>{{"report --out DIR", "README.md"},
                                               {"site --out DIR", "index.html"},
                                               {"chart 9.1 --out DIR", "9.1.md"},
                                               {"stability 3.5 --out DIR", "charts/3.5_map.svg"},
                                               {"prove 7.1 --out DIR", "7.1-excess.v"},
                                               {"sweep plan DIR" + swept, "plan.json"}}) {
    const std::string folder = words.substr(0, words.find(' '));
    const fs::path mine = scratch.file(folder + "/" + file, "mine");
    std::string command = words;
    command.replace(words.find("DIR"), 3, (scratch.path() / folder).string());
    const Ran ran = run(command);
    INFO(command << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, "--overwrite"));
    CHECK(text_of(mine) == "mine");
  }
  const fs::path chart = scratch.path() / "chart";
  CHECK(run("chart 9.1 --overwrite --out " + chart.string()).status == 0);
  CHECK(text_of(chart / "9.1.md") != "mine");
  CHECK(run("chart 9.1 --out " + chart.string()).status == 0);  // its own files now
}

TEST_CASE("anything but a regular file is refused at once", "[commands]") {
  const ScratchFolder scratch;
  const std::string pipe = (scratch.path() / "pipe").string();
  REQUIRE(shell("mkfifo " + pipe).status == 0);
  for (const std::string& words :
       {"verify -f " + pipe, "verify --input-file " + pipe, "verify -sf " + pipe, "verify --from " + pipe,
        std::string("verify -f /dev/zero"), std::string("verify --from /dev/zero"),
        std::string("verify --from /proc/kmsg")}) {
    const Ran ran = shell("timeout 60 $oddity " + words);
    INFO(words << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, "cannot read "));
  }
}

TEST_CASE("a folder that cannot be written is named and ends with exit code 2", "[commands]") {
  const Ran ran = run("report --out /proc/no/such/folder");
  CHECK(ran.status == 2);
  CHECK(says(ran, "/proc/no/such/folder"));
  CHECK(run("site --out /proc/no").status == 2);
  const Ran refused = run("verify '[3.5]' --results /proc/no/results.json");
  CHECK(refused.status == 2);
  CHECK_FALSE(says(refused, "assertions"));  // before the run
}

TEST_CASE("chart draws both charts of a quantity and writes their page", "[commands]") {
  const ScratchFolder scratch;
  const Ran ran = run("chart 9.1 --out " + scratch.path().string());
  CHECK(ran.status == 0);
  CHECK(says(ran, (scratch.path() / "9.1.md").string()));
  for (const char* file : {"9.1.md", "charts/9.1_distance.svg", "charts/9.1_distance_time.svg"})
    CHECK(fs::file_size(scratch.path() / file) > 1000);
}

TEST_CASE("a broken table is named with its line and ends with exit code 2", "[commands]") {
  const ScratchFolder scratch;
  const fs::path folder = tables(scratch);
  replace_in(folder / "tables/03_05_quarter_period.csv", "1,I,2.3687", "1,I,x2.3687");
  const Ran broken = run("--reference " + folder.string() + " verify '[3.5]'");
  CHECK(broken.status == 2);
  CHECK(says(broken, "03_05_quarter_period.csv:12: 'x2.3687"));
  fs::remove(folder / "tables/03_05_quarter_period.csv");
  const Ran missing = run("--reference " + folder.string() + " verify '[3.5]'");
  CHECK(missing.status == 2);
  CHECK(says(missing, "03_05_quarter_period.csv"));
}

TEST_CASE("a verdict that differs from the approved one makes the suite red", "[commands]") {
  const ScratchFolder scratch;
  const fs::path folder = tables(scratch);
  replace_in(folder / "approved/verdicts.csv", "3.5-value,wrong", "3.5-value,confirmed");
  const Ran red = run("--reference " + folder.string() + " verify '[3.5]'");
  CHECK(red.status == 1);
  CHECK(says(red, "3.5-value: wrong"));
}

TEST_CASE("a limit that moves, and a method that no longer breaks down as approved, make the suite red",
          "[commands]") {
  for (const auto& [old, fresh] : std::array<std::array<std::string, 2>, 4>{
           {{"velocity Verlet,0.676", "velocity Verlet,0.72"},
            {"velocity Verlet,0.676", "velocity Verlet,inf"},
            {"0.0521,diverged", "0.0521,non-finite"},
            {"3.5,one angle,velocity Verlet", "3.5,one angle,leapfrog"}}}) {
    const ScratchFolder scratch;
    const fs::path folder = tables(scratch);
    replace_in(folder / "approved/limits.csv", old, fresh);
    const Ran red = run("--reference " + folder.string() + " verify '[3.5]'");
    CHECK(red.status == 1);
    CHECK(says(red, "3.5,one angle,velocity Verlet,0.676"));
  }
}

TEST_CASE("a map that changes makes the suite red", "[commands]") {
  const ScratchFolder scratch;
  const fs::path folder = tables(scratch);
  replace_in(folder / "approved/stability_maps.csv", "velocity Verlet,0.125,ii", "velocity Verlet,0.125,di");
  CHECK(run("--reference " + folder.string() + " verify '[3.5]'").status == 1);
}

TEST_CASE("an error, a count, a line or a near miss that differs from the approved one makes the suite red",
          "[commands]") {
  for (const auto& [old, fresh] :
       std::array<std::array<std::string, 2>, 5>{{{"swing: one angle, explicit Euler\",step 0.125 0.0625",
                                                   "swing: one angle, explicit Euler\",step 0.125 0.06"},
                                                  {"0.0077,80 160 320 640", "0.0077,80 160 320 641"},
                                                  {"claim value,1373,1.46", "claim value,1374,1.46"},
                                                  {"claim value,1373,1.46", "claim value,1373,1.56"},
                                                  {"swing: breakdown 1", "swing: breakdown 9"}}}) {
    const ScratchFolder scratch;
    const fs::path folder = tables(scratch);
    replace_in(folder / "approved/errors.csv", old, fresh);
    const Ran red = run("--reference " + folder.string() + " verify '[3.5]'");
    CHECK(red.status == 1);
    CHECK(says(red, "verify --approve would write"));
  }
}

TEST_CASE("a reference value that changes makes the suite red", "[commands]") {
  const ScratchFolder scratch;
  const fs::path folder = tables(scratch);
  replace_in(folder / "tables/03_05_quarter_period.csv", "I,2.2601140", "I,2.2601240");
  CHECK(run("--reference " + folder.string() + " verify '[3.5]'").status == 1);
}

TEST_CASE("the suite's Markdown, JUnit and results are complete", "[commands]") {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "out").string();
  CHECK(run("verify '[3.5]' -r markdown -o " + file).status == 0);
  CHECK(fs::file_size(file) > 1000);
  CHECK(says(run("verify '[3.5]' -r junit"), "<testsuites"));
  CHECK(run("verify '[3.5]' --results " + file).status == 0);
  CHECK(fs::file_size(file) > 1000);
  CHECK(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("nothing in a table is executed or breaks out of its cell", "[commands]") {
  const std::array<std::array<std::string, 3>, 6> places{
      {{"approved/limits.csv", ",not explained", ",HOSTILE"},
       {"approved/limits.csv", "3.5,one angle,Runge-Kutta 4", "3.5,HOSTILE,Runge-Kutta 4"},
       {"approved/verdicts.csv", "3.5-value,wrong", "3.5-value,HOSTILE"},
       {"approved/verdicts.csv", "3.5-value,", "HOSTILE,"},
       {"approved/stability_maps.csv", "3.5,one angle,velocity Verlet", "3.5,one angle,HOSTILE"},
       {"tables/03_05_quarter_period.csv", "1,I,2.3687", "1,HOSTILE,2.3687"}}};
  for (const auto& [table, old, fresh] : places)
    for (const std::string hostile :
         {"`touch canary`$(touch canary)|'; <script> $x", "\x1b[31mred", "\xff"}) {
      const ScratchFolder scratch;
      const fs::path folder = tables(scratch);
      std::string text = fresh;
      replace_in(folder / table, old, text.replace(text.find("HOSTILE"), 7, hostile));
      const std::string in = "cd " + folder.string() + " && $oddity --reference . ";
      INFO(table << " " << fresh);
      for (const char* verb :
           {"verify '[3.5]' --results out/r.json", "stability 3.5 --out maps", "list 3.5"}) {
        const Ran ran = shell(in + verb);
        INFO(ran.output);
        CHECK(ran.status <= 2);
        CHECK_FALSE(says(ran, "internal error"));
        CHECK_FALSE(says(ran, "\x1b[31m"));
        CHECK_FALSE(fs::exists(folder / "canary"));
      }
    }
}

TEST_CASE("parts of the suite's results are merged and judged as a whole", "[commands]") {
  const ScratchFolder scratch;
  const std::string one = (scratch.path() / "1.json").string(), two = (scratch.path() / "2.json").string(),
                    all = (scratch.path() / "all.json").string(), both = "verify '[2.1],[5.7]'";
  REQUIRE(run("verify '[2.1]' --results " + one).status == 0);
  REQUIRE(run("verify '[5.7]' --results " + two).status == 0);
  const Ran judged = run(both + " --from " + two + " --from " + one + " --results " + all);
  INFO(judged.output);
  CHECK(judged.status == 0);
  const Ran again = run(both + " --from " + all);
  CHECK(again.status == 0);
  CHECK(says(again, "in 2 test cases"));
  CHECK(says(run(both + " --from " + one), "exercise 5.7 is in none of the files"));
  CHECK(says(run(both + " --from " + one + " --from " + all), "exercise 2.1 is there twice"));
  const Ran listed = run("verify --shard 48/48 --list-tests");
  CHECK(says(listed, "9.1"));
  CHECK_FALSE(says(listed, "8.5"));
  CHECK(says(run("verify --shard 49/49 --list-tests"), "there are 48 exercises"));
  CHECK(says(run("verify --shard 3 --list-tests"), "a part of the whole"));
  CHECK(says(run("verify --shard 2/7e87 --list-tests"), "a part of the whole"));  // found by a fuzzer
}

TEST_CASE("without /proc a sentence explains it", "[commands]") {
  const std::string alone = "unshare --user --map-root-user --mount sh -c 'mount -t tmpfs none /proc && ";
  if (program::shell(alone + "true'").status != 0) {
    WARN("not run: /proc cannot be hidden here");
    return;
  }
  const auto ended = program::shell(alone + "exec \"$0\" list' \"$oddity\"");
  CHECK(ended.status == 2);
  CHECK(program::says(ended, "/proc is not mounted here"));
}
