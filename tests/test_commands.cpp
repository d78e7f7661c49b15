#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/catch.hpp"

namespace fs = std::filesystem;

namespace {

struct Ran {
  int status;
  std::string output;  ///< standard output and standard error together
};

/// Runs the program with these arguments, as a user would.
Ran run(const std::string& arguments) {
  std::FILE* pipe = popen((std::string(ODDITY_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
  Ran ran{-1, ""};
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    ran.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return ran;
}

bool says(const Ran& ran, const std::string& text) { return ran.output.find(text) != std::string::npos; }

/// A folder of its own that goes when the test ends.
struct Scratch {
  fs::path path = fs::temp_directory_path() / ("oddity_test_" + std::to_string(getpid()));
  Scratch() { fs::create_directories(path); }
  ~Scratch() { fs::remove_all(path); }
};

/// A copy of the reference tables to break.
fs::path tables(const Scratch& scratch) {
  for (const auto& entry : fs::directory_iterator(fs::path(ODDITY_SOURCE) / "reference"))
    if (entry.path().extension() == ".csv")
      fs::copy(entry, scratch.path, fs::copy_options::overwrite_existing);
  return scratch.path;
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
  CHECK(says(ran, "a = 0.5235987755982988 rad"));
}

TEST_CASE("every verb has help with an example", "[commands]") {
  for (const std::string verb : {"list", "verify", "solve", "chart", "report", "stability", "choose"}) {
    const Ran ran = run(verb + " --help");
    INFO(ran.output);
    CHECK(ran.status == 0);
    CHECK(says(ran, "Example"));
  }
}

TEST_CASE("solve takes parameters and says where its reference comes from", "[commands]") {
  const Ran tabulated = run("solve 3.5");
  CHECK(tabulated.status == 0);
  CHECK(says(tabulated, "table 03_05_quarter_period.csv"));
  const Ran own = run("solve 3.5 a=2.4");
  CHECK(own.status == 0);
  CHECK(says(own, "computed on the spot"));
  const Ran json = run("solve 3.5 a=2.4 --json");
  CHECK(json.status == 0);
  CHECK(json.output.front() == '{');
  CHECK(says(json, "\"number\": \"3.5\""));
}

TEST_CASE("stability shows the limits and draws the maps", "[commands]") {
  const Scratch scratch;
  const Ran ran = run("stability 3.5 --out " + scratch.path.string());
  CHECK(ran.status == 0);
  CHECK(says(ran, "explicit Euler"));
  CHECK(says(ran, "unstable in theory"));
  CHECK(fs::file_size(scratch.path / "charts" / "3.5_stability.svg") > 10'000);
  const Ran rows = run("stability 3.5 --rows");
  CHECK(says(rows, "3.5,one angle,velocity Verlet,0.676,0.639,from 0.639,0.83,0.0625,diverged,"));
}

TEST_CASE("bad input is named and ends with 2", "[commands]") {
  const std::array<std::array<std::string, 2>, 14> cases{
      {{"solve 3.6", "no exercise '3.6'"},
       {"solve three", "no exercise 'three'"},
       {"solve", "exercise is required"},
       {"solve 3.5 b=1", "no parameter 'b'; the parameters are: a, L, g"},
       {"solve 3.5 a=x", "'x' is not a number"},
       {"solve 3.5 a", "'a' is not name=value"},
       {"solve 3.5 a=4", "out of its range"},
       {"solve 3.5 a=nan", "out of its range"},
       {"report --chapter 15", "no chapter 15"},
       {"chart 3.4", "no exercise '3.4'"},
       {"stability 3.6", "no exercise '3.6'"},
       {"stability 9.1", "exercise 9.1 has no motion; those that have one are: "},
       {"choose 3.5", "choose needs --error"},
       {"verify '[3.99]'", "no test case matches"}}};
  for (const auto& [arguments, message] : cases) {
    const Ran ran = run(arguments);
    INFO("oddity " << arguments << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, message));
  }
  CHECK(run("nonsense").status == 2);
  CHECK(run("verify --no-such-option").status == 2);
}

TEST_CASE("a folder that cannot be written is named and ends with 2", "[commands]") {
  const Ran ran = run("report --out /proc/no/such/folder");
  CHECK(ran.status == 2);
  CHECK(says(ran, "/proc/no/such/folder"));
  const Ran refused = run("verify '[3.5]' --results /proc/no/results.json");
  CHECK(refused.status == 2);
  CHECK_FALSE(says(refused, "assertions"));  // before the run
}

TEST_CASE("chart draws both charts of a quantity and writes their page", "[commands]") {
  const Scratch scratch;
  const Ran ran = run("chart 9.1 --out " + scratch.path.string());
  CHECK(ran.status == 0);
  CHECK(says(ran, (scratch.path / "9.1.md").string()));
  for (const char* file : {"9.1.md", "charts/9.1_distance.svg", "charts/9.1_distance_time.svg"})
    CHECK(fs::file_size(scratch.path / file) > 1000);
}

TEST_CASE("a broken table is named with its line and ends with 2", "[commands]") {
  const Scratch scratch;
  const fs::path folder = tables(scratch);
  replace_in(folder / "03_05_quarter_period.csv", "1,I,2.3687", "1,I,x2.3687");
  const Ran broken = run("--reference " + folder.string() + " verify '[3.5]'");
  CHECK(broken.status == 2);
  CHECK(says(broken, "03_05_quarter_period.csv:11: 'x2.3687"));
  fs::remove(folder / "03_05_quarter_period.csv");
  const Ran missing = run("--reference " + folder.string() + " verify '[3.5]'");
  CHECK(missing.status == 2);
  CHECK(says(missing, "03_05_quarter_period.csv"));
}

TEST_CASE("a verdict that differs from the one on record makes the suite red", "[commands]") {
  const Scratch scratch;
  const fs::path folder = tables(scratch);
  replace_in(folder / "verdicts.csv", "3.5-value,erratum", "3.5-value,confirmed");
  const Ran red = run("--reference " + folder.string() + " verify '[3.5]'");
  CHECK(red.status == 1);
  CHECK(says(red, "3.5-value: erratum"));
}

TEST_CASE("a limit that moves, and a method that no longer breaks as on record, make the suite red",
          "[commands]") {
  for (const auto& [old, fresh] : std::array<std::array<std::string, 2>, 4>{
           {{"velocity Verlet,0.676", "velocity Verlet,0.72"},
            {"velocity Verlet,0.676", "velocity Verlet,inf"},
            {"0.0625,diverged", "0.0625,non-finite"},
            {"3.5,one angle,velocity Verlet", "3.5,one angle,leapfrog"}}}) {
    const Scratch scratch;
    const fs::path folder = tables(scratch);
    replace_in(folder / "limits.csv", old, fresh);
    const Ran red = run("--reference " + folder.string() + " verify '[3.5]'");
    CHECK(red.status == 1);
    CHECK(says(red, "the row of limits.csv to approve: 3.5,one angle,velocity"));
  }
}

TEST_CASE("a map that changes makes the suite red", "[commands]") {
  const Scratch scratch;
  const fs::path folder = tables(scratch);
  replace_in(folder / "stability_maps.csv", "velocity Verlet,0.125,XX", "velocity Verlet,0.125,Xd");
  CHECK(run("--reference " + folder.string() + " verify '[3.5]'").status == 1);
}

TEST_CASE("a true value that changes makes the suite red", "[commands]") {
  const Scratch scratch;
  const fs::path folder = tables(scratch);
  replace_in(folder / "03_05_quarter_period.csv", "I,2.2601140", "I,2.2601240");
  CHECK(run("--reference " + folder.string() + " verify '[3.5]'").status == 1);
}

TEST_CASE("the suite's Markdown, JUnit and results come out whole", "[commands]") {
  const Scratch scratch;
  const std::string file = (scratch.path / "out").string();
  CHECK(run("verify '[3.5]' -r markdown -o " + file).status == 0);
  CHECK(fs::file_size(file) > 1000);
  CHECK(says(run("verify '[3.5]' -r junit"), "<testsuites"));
  CHECK(run("verify '[3.5]' --results " + file).status == 0);
  CHECK(fs::file_size(file) > 1000);
  CHECK_FALSE(fs::exists(file + ".part"));
}
