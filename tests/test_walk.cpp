// The walks of CONTRIBUTING.md and of extras/engines/README.md, with the texts that these pages fill in. They
// go from the files written by `new` to green exercises, and to how a user's exercise is shown. The files
// written by `new` are compiled unchanged into the same program.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "report/verify/catch.hpp"
#include "tests/near.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

namespace fs = std::filesystem;
using program::Ran, program::says, program::shell;

namespace {

/// The tables and records, without those of 4.1, in case somebody has taken the walk.
void copy_tables(const fs::path& folder) {
  const fs::path source = fs::path(ODDITY_SOURCE) / "reference";
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    if (entry.path().extension() != ".csv" || entry.path().stem() == "04_01_spring") continue;
    const fs::path copy = folder / fs::relative(entry.path(), source);
    fs::create_directories(copy.parent_path());
    std::ifstream in(entry.path());
    std::ofstream out(copy);
    for (std::string line; std::getline(in, line);)
      if (!line.starts_with("4.1,") && !line.starts_with("4.1-")) out << line << "\n";
  }
}

/// The number of the first line of the file that contains the words.
std::string line_of(const std::string& file, const std::string& words) {
  std::ifstream in(fs::path(ODDITY_SOURCE) / file);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
    if (line.find(words) != std::string::npos) return std::to_string(number);
  return "?";
}

}  // namespace

TEST_CASE("the walks of CONTRIBUTING.md end green", "[walk]") {
  const ScratchFolder scratch;
  copy_tables(scratch.path());
  const std::string folder = scratch.path().string();
  const auto oddity = [&](const std::string& words) {
    return shell(std::string(ODDITY_WALK) + " --reference " + folder + " " + words);
  };
  const auto rows = [&](const std::string& file) { return text_of(scratch.path() / file); };

  const Ran without_table = oddity("solve 4.1");
  CHECK(without_table.status == 0);
  CHECK(says(without_table, "computed on the spot: Taylor series of the equation of motion; and the cosine"));
  const Ran made = shell(std::string(ODDITY_WALK_MAKER) + " " + folder + " 04_01_spring");
  INFO(made.output);
  REQUIRE(made.status == 0);
  CHECK(says(oddity("solve 4.1"), "table 04_01_spring.csv"));

  CHECK(says(oddity("list"), "4.1  Spring (scene) (own)\n"));
  CHECK(says(oddity("list"), "9.2  Law of cosines (own)\n"));
  CHECK(oddity("solve 4.1 c=41").status == 0);

  const std::string others = rows("approved/verdicts.csv");
  const Ran red = oddity("verify '[4.1],[9.2]'");
  CHECK(red.status == 1);
  CHECK(says(red, "\n+ 4.1-period,confirmed\n"));
  CHECK(says(red, "\n+ 9.2-first,confirmed\n"));
  CHECK(says(red, "\n+ 4.1,mass on a spring,Runge-Kutta 4,"));
  CHECK_FALSE(says(red, "raised"));
  std::size_t blocks = 0;
  for (std::size_t at = 0; (at = red.output.find("FAILED:", at)) != std::string::npos; ++at) ++blocks;
  CHECK(blocks == 2);  // one per exercise
  CHECK(says(red, "    limits.csv lacks 1 of 1\n"));
  CHECK_FALSE(says(red, "write it in"));
  CHECK(rows("approved/verdicts.csv") == others);

  const Ran approved = oddity("verify --approve '[4.1],[9.2]'");
  INFO(approved.output);
  CHECK(approved.status == 0);
  CHECK(says(approved, "\n+ 4.1-period,confirmed\n"));
  CHECK(says(approved, "Look at the differences"));
  std::string now = rows("approved/verdicts.csv");
  for (const std::string row : {"4.1-period,confirmed\n", "9.2-first,confirmed\n"}) {
    const auto added = now.find(row);
    REQUIRE(added != std::string::npos);
    now.erase(added, row.size());
  }
  CHECK(now == others);
  CHECK(rows("approved/verdicts.csv").find("\n5.1-") > rows("approved/verdicts.csv").find("4.1-period"));

  const Ran green = oddity("verify '[4.1],[9.2]'");
  CHECK(green.status == 0);
  CHECK_FALSE(says(green, "+ 4.1"));
  CHECK(says(oddity("verify --approve '[4.1]'"), "every row was approved already"));
  CHECK(oddity("verify '[own]~[ch99]'").status == 0);
  CHECK(says(oddity("choose 4.1 --criterion energy --error 0.01 --horizon 1"), "Take "));
  const Ran beside = oddity("choose 4.1 --engine euler");
  INFO(beside.output);
  CHECK(
      says(beside, "on Euler 1, defaults (double): at 60 Hz it errs by 1 cm; 2 steps a frame bring 0.42 cm"));
  CHECK(says(oddity("choose 4.1 --engine euler --json"), "\"engine\": \"Euler\""));
  const Ran page = oddity("verify '[4.1]' -r markdown");
  CHECK(says(page, "0 exercises and 1 of one's own, 1 claim"));
  CHECK(says(page, "[4.1 Spring](#41-spring) (own)"));
  CHECK_FALSE(says(page, "The solutions have no exercises in this chapter"));
}

TEST_CASE("every command about an exercise accepts a user's exercise", "[walk]") {
  const ScratchFolder scratch;
  copy_tables(scratch.path());
  const std::string out = " --out " + (scratch.path() / "out").string();
  const auto takes = [&](const std::string& words, const std::string& text) {
    const Ran ran = shell(std::string(ODDITY_WALK) + " --reference " + scratch.path().string() + " " + words);
    INFO(words << "\n" << ran.output);
    CHECK(ran.status == 0);
    CHECK(says(ran, text));
  };
  const std::string with_need = "choose 4.1 --error 1cm --horizon 1";
  takes("list 4.1", "c = 40 N/m  spring constant (1 to 10000)");
  takes("solve 4.1 c=4N/cm", "c = 400 N/m");
  takes("solve 4.1 --csv", "\n4.1,swing,m,mass on a spring,Runge-Kutta 4,double,step,0.125,");
  takes("solve 4.1 --json", "\"mass on a spring\"");
  takes("chart 4.1" + out, "4.1.md");
  takes("chart 4.1 --csv", "\n4.1,swing,m,");
  takes("stability 4.1" + out, "mass on a spring");
  takes("stability 4.1 --csv", "\n4.1,mass on a spring,Runge-Kutta 4,");
  takes("stability 4.1 --rows", "\n4.1,mass on a spring,Runge-Kutta 4,");
  takes(with_need, "Take ");
  takes(with_need + " --csv", "mass on a spring,Runge-Kutta 4,");
  takes(with_need + " --json", "\"mass on a spring\"");
  // --code prints headers that are put into the program when it is built with ODDITY_OWN, which this one is
  // not.
  const std::string map = (scratch.path() / "map").string();
  takes("sweep plan " + map +
            " 4.1 --model 'mass on a spring' --algorithm 'Runge-Kutta 4' --over c=10..640:4 --setting 0.01",
        map);
  takes("sweep run " + map, "");
  takes("sweep merge " + map + " --out " + map + ".csv", "");
  takes("sweep draw " + map, "");
  const auto has_none = [&](const std::string& words, const std::string& reason) {
    const Ran ran = shell(std::string(ODDITY_WALK) + " " + words);
    INFO(words << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, reason));
  };
  has_none("prove 4.1", "4.1");
  has_none("choose 9.2 --error 1cm", "9.2");
  has_none("engines 9.2", "9.2");
}

TEST_CASE("the engine of extras/engines/README.md throws as on its page", "[walk]") {
  const std::string engine = std::string(ODDITY_WALK_FOLDER) + "/engines/engine_walked";
  const ScratchFolder scratch;
  const std::string page = text_of(fs::path(ODDITY_SOURCE) / "extras/engines/README.md");
  const auto begin = page.find("{\"variant\": \"defaults\""), end = page.find("```", begin);
  REQUIRE(begin < end);
  std::string request = page.substr(begin, end - begin);
  std::ranges::replace(request, '\n', ' ');
  std::ofstream(scratch.path() / "throw.json") << request << "\n";
  CHECK(says(shell(engine + " --about"), "\"name\":\"Euler\""));
  const Ran thrown = shell(engine + " < " + (scratch.path() / "throw.json").string());
  INFO(thrown.output);
  REQUIRE(thrown.status == 0);
  const auto last = nlohmann::json::parse(thrown.output)["frames"].back()[0]["position"];
  CHECK(near(last[0].get<double>(), 4, 1e-12));
  CHECK(near(last[1].get<double>(), 2.095 - 0.0204375, 1e-12));
}

TEST_CASE(
    "the files written by new run unchanged, from outside the tree, and list the parts still to be written",
    "[walk]") {
  const auto oddity = [&](const std::string& words) { return shell(std::string(ODDITY_WALK) + " " + words); };
  const std::string folder = "chapters/99_my_topic/";
  CHECK(says(oddity("list 99.97"), "99.97  My identity (own)\n"));
  const Ran solved = oddity("solve 99.98");
  CHECK(solved.status == 0);
  CHECK(says(solved, "still to be written: "));
  CHECK(says(solved, "Runge-Kutta 4"));

  const Ran identity = oddity("verify '[99.97]'");
  CHECK(identity.status == 1);
  const std::string its_file = folder + "97_my_identity/exercise.cpp";
  CHECK(says(identity, "99.97: the question is missing: write it in report/new/" + its_file));
  CHECK(says(identity, "99.97: the claim 'first' has no independent route yet: write it in report/new/" +
                           its_file + ":" + line_of("report/new/" + its_file, "to_write()")));
  CHECK_FALSE(says(identity, "+ 99.97"));

  const Ran scene = oddity("verify '[99.98]'");
  CHECK(scene.status == 1);
  const std::string claims = "report/new/" + folder + "98_my_scene/claims.cpp",
                    generator = "report/new/reference/make/99_98_my_scene.cpp";
  CHECK(says(scene, "99.98: the claim 'period' has no independent route yet: write it in " + claims + ":" +
                        line_of(claims, "to_write()")));
  CHECK(says(scene, "99.98: the quantity 'swing' has no second route to its truth yet: write it in " +
                        generator + ":" + line_of(generator, "throw StillToWrite")));
  CHECK_FALSE(says(scene, "limits.csv"));
  const Ran choice = oddity("choose 99.98 --error 1cm");
  CHECK(choice.status == 2);
  CHECK(says(choice, "exercise 99.98 has no truth to judge by: still to be written: "));
}

TEST_CASE("new writes the files of the walks, without the texts to fill in", "[walk][new]") {
  const ScratchFolder scratch;
  const auto begin = [&](const std::string& words) {
    return program::run("new " + words + " --in " + scratch.path().string());
  };
  const Ran scene = begin("44.2 spring");
  INFO(scene.output);
  CHECK(scene.status == 0);
  CHECK(begin("99.98 my_scene --topic my_topic").status == 0);
  CHECK(begin("99.97 my_identity --identity").status == 0);
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ODDITY_SOURCE) / "report/new")) {
    if (!entry.is_regular_file()) continue;
    const fs::path file = fs::relative(entry.path(), fs::path(ODDITY_SOURCE) / "report/new");
    INFO(file);
    CHECK(text_of(scratch.path() / file) == text_of(entry.path()));
  }
  std::string expected =
      text_of(fs::path(ODDITY_WALK_FOLDER) / "chapters/04_deformable_bodies/01_spring/methods.cpp");
  for (const auto& [old, fresh] :
       {std::pair("04_deformable_bodies/01_spring", "44_own/02_spring"), {"04_01", "44_02"}, {"4.1", "44.2"}})
    for (std::size_t at; (at = expected.find(old)) != std::string::npos;)
      expected.replace(at, std::string(old).size(), fresh);
  CHECK(text_of(scratch.path() / "chapters/44_own/02_spring/methods.cpp") == expected);
  CHECK(says(scene, "\nODDITY_OWN=" + scratch.path().string() + " ./oddity verify '[44.2]'"));
}

TEST_CASE("new refuses invalid names, and overwrites nothing", "[new]") {
  const ScratchFolder scratch;
  const auto begin = [&](const std::string& words) {
    return program::run("new " + words + " --in " + scratch.path().string());
  };
  const auto refuses = [&](const std::string& words, const std::string& reason) {
    const Ran ran = begin(words);
    INFO(words << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, reason));
  };
  refuses("3.5 pendulum",
          "exercise 3.5 is there already: Pendulum from 30 degrees, "
          "chapters/03_rigid_body_motion/05_pendulum/exercise.cpp");
  refuses("3.5 pendulum", "Free are 3.2, 3.4, 3.6 and more");
  refuses("3 pendulum", "'3' is no number of an exercise: that is N.M, such as 3.2");
  refuses("3.100 pendulum", "each from 1 to 99");
  refuses("0.2 pendulum", "each from 1 to 99");
  refuses("3.2 'Spring pendulum'", "did you mean 'spring_pendulum'?");
  refuses("3.2 ../x", "is no name of a folder");
  refuses("3.2 2nd", "a letter first; did you mean 'nd'?");
  refuses("3.2 x --topic statics", "chapter 3 is in chapters/03_rigid_body_motion");
  refuses("3.2 x --scene --identity", "--scene and --identity do not go together");
  refuses("3.2 x --topik y", "did you mean '--topic'?");
  CHECK(fs::is_empty(scratch.path()));
  CHECK(says(program::run("nwe 3.2 x"), "did you mean 'new'?"));

  CHECK(begin("3.2 spring_pendulum").status == 0);
  const fs::path file = scratch.path() / "chapters/03_rigid_body_motion/02_spring_pendulum/exercise.cpp";
  std::ofstream(file, std::ios::app) << "// mine\n";
  refuses("3.2 spring_pendulum", "exercise 3.2 is there already: " + file.parent_path().string());
  refuses("3.2 another", "nothing was written");
  CHECK(text_of(file).ends_with("// mine\n"));
  fs::remove_all(scratch.path() / "chapters");
  refuses("3.2 spring_pendulum", "reference/make/03_02_spring_pendulum.cpp; nothing was written");
  CHECK_FALSE(fs::exists(scratch.path() / "chapters"));
}
