// Results kept from run to run: an exercise runs again if its inputs have changed, and no other does.

#include "report/study/kept_results.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "reference/files.hpp"
#include "report/verify/catch.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

using Numbers = std::vector<Number>;

const fs::path reference = fs::path(ODDITY_SOURCE) / "reference";

std::vector<Task> tasks_of(const Numbers& numbers) {
  std::vector<Task> tasks;
  for (const Entry& entry : registry())
    if (std::ranges::find(numbers, entry.number) != numbers.end()) tasks.emplace_back(entry);
  return tasks;
}

Numbers numbers_of(const Results& results) {
  Numbers numbers;
  for (const ExerciseResult& e : results.exercises) numbers.push_back(e.number);
  return numbers;
}

bool is_made(const ExerciseResult& e) { return !e.made_from.empty(); }

/// The exercises that both contain, with different values.
template <class Key>
std::vector<Key> changed(const std::map<Key, std::string>& before, const std::map<Key, std::string>& after) {
  std::vector<Key> keys;
  REQUIRE(before.size() == after.size());
  for (const auto& [key, text] : before)
    if (after.at(key) != text) keys.push_back(key);
  return keys;
}

}  // namespace

TEST_CASE("only exercises without results are run, all at once", "[kept]") {
  const std::vector<Task> tasks = tasks_of({{5, 1}, {5, 3}, {5, 7}, {9, 1}});
  Results kept;
  for (Number number : Numbers{{9, 1}, {5, 3}, {5, 7}}) {
    ExerciseResult& e = kept.exercises.emplace_back();
    e.number = number;
    e.made_from = number == Number{5, 7} ? "" : "as before";
    e.title = "kept";
  }
  kept.seam = 2;
  std::vector<Numbers> asked;
  const auto make = [&](Results some, std::span<const Task> lacking) {
    Numbers numbers;
    for (const Task& task : lacking) numbers.push_back(task.entry->number);
    CHECK(numbers == numbers_of(some));
    asked.push_back(numbers);
    for (ExerciseResult& e : some.exercises) {
      e.title += "made";
      e.made_from = "here";
    }
    some.seam = 3;
    return some;
  };
  const Results all = completed(kept, tasks, is_made, make);
  CHECK(asked == std::vector<Numbers>{{{5, 1}, {5, 7}}});
  CHECK(numbers_of(all) == Numbers{{5, 1}, {5, 3}, {5, 7}, {9, 1}});
  CHECK(all.exercises[0].title == "made");
  CHECK(all.exercises[1].title == "kept");
  CHECK(all.exercises[2].title == "keptmade");
  CHECK(all.exercises[3].title == "kept");
  CHECK(all.seam == 3);
  const Results again = completed(all, tasks, is_made, make);
  CHECK(asked.size() == 1);
  CHECK(numbers_of(again) == numbers_of(all));
}

TEST_CASE("results are kept if their inputs are the same, and nothing failed", "[kept]") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / "results.json";
  const std::vector<Task> tasks = tasks_of({{5, 1}, {5, 3}, {5, 7}});
  const MadeFrom here = made_from(std::string(), "a program", reference);
  const Results results = noted(run(tasks, Reference(reference), false), here);
  const auto kept = [&](const Results& written, const MadeFrom& now) {
    write_whole(file, to_json(written));
    return numbers_of(kept_results(file, now));
  };
  CHECK(kept(results, here) == Numbers{{5, 1}, {5, 3}, {5, 7}});
  MadeFrom other = here;
  other[{5, 3}] += " ";
  CHECK(kept(results, other) == Numbers{{5, 1}, {5, 7}});
  other.erase({5, 1});
  CHECK(kept(results, other) == Numbers{{5, 7}});
  Results odd = results;
  odd.exercises[0].failure = "it raised";
  odd.exercises[1].title = "another";
  CHECK(kept(odd, here) == Numbers{{5, 7}});
  odd.exercises[2].made_from = "";
  CHECK(kept(odd, here).empty());
  std::ofstream(file, std::ios::app) << "x";
  CHECK(kept_results(file, here).exercises.empty());
  fs::remove(file);
  CHECK(kept_results(file, here).exercises.empty());
}

TEST_CASE("a change of code or of a ledger changes the inputs of its exercise only", "[kept]") {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "reference";
  fs::create_directories(folder);
  for (const char* part : {"tables", "ledger"})
    fs::copy(reference / part, folder / part, fs::copy_options::recursive);
  const std::string a(64, 'a'), b(64, 'b');
  const auto now = [&](const std::string& of_build, const std::string& program = "p") {
    return made_from(of_build, program, folder);
  };
  const MadeFrom before = now("3.5 " + a + "\n5.7 " + a + "\n");
  CHECK(before.size() == registry().size());
  CHECK(before == made_from("3.5 " + a + "\n5.7 " + a + "\n", "p", reference));
  CHECK(changed(before, now("3.5 " + a + "\n5.7 " + b + "\n")) == Numbers{{5, 7}});
  CHECK(changed(before, now("3.5 " + a + "\n")) == Numbers{{5, 7}});
  CHECK(changed(before, now("3.5 " + a + "\n5.7 " + a + "\n", "q")).size() == registry().size() - 2);
  std::ofstream(folder / "ledger/3.5.csv", std::ios::app) << "\n";
  CHECK(changed(before, now("3.5 " + a + "\n5.7 " + a + "\n")) == Numbers{{3, 5}});
  std::ofstream(folder / "tables/03_05_quarter_period.csv", std::ios::app) << "\n";
  CHECK(changed(before, now("3.5 " + a + "\n5.7 " + a + "\n")).size() == registry().size());
}

namespace {

/// A tree and a home folder with sources, and their compiled objects.
class Built {
 public:
  void source(const std::string& file, const std::string& text) { scratch_.file(file, text); }
  void object(const std::string& file, const std::string& text) {
    const bool is_own = file.starts_with("own/");
    const std::string source = is_own ? (scratch_.path() / file).string() : "/" + file;
    scratch_.file("build/CMakeFiles/oddity_room.dir" + source + ".o", text);
    // Named as by CMake.
    objects_.insert((scratch_.path() / "build/CMakeFiles/oddity_room.dir/.").string() + source + ".o");
  }
  /// A unity source of these files, and its object with this text.
  void together(const std::string& name, const std::vector<std::string>& files, const std::string& text) {
    const std::string unity = "build/CMakeFiles/oddity_room.dir/Unity/unity_" + name + "_cxx.cxx";
    std::string includes = "/* generated by CMake */\n";
    for (const std::string& file : files)
      includes += "\n#include \"" + (scratch_.path() / "tree" / file).string() + "\"\n";
    scratch_.file(unity, includes);
    objects_.insert(scratch_.file(unity + ".o", text).string());
  }

  std::map<std::string, std::string> made_from() const {
    const std::string folder = scratch_.path().string();
    std::string list;
    for (const std::string& object : objects_) list += (list.empty() ? "" : ";") + object;
    std::ofstream(scratch_.path() / "objects.txt") << list;
    const program::Ran ran = program::shell("cmake -DOBJECTS=" + folder + "/objects.txt -DTREE=" + folder +
                                            "/tree -DHOMES=" + folder + "/own -DOUT=" + folder +
                                            "/made_from -P " + ODDITY_SOURCE + "/cmake/made_from.cmake 2>&1");
    INFO(ran.output);
    REQUIRE(ran.status == 0);
    std::istringstream lines(read_whole(scratch_.path() / "made_from"));
    std::map<std::string, std::string> all;
    for (std::string number, hash; lines >> number >> hash;) all[number] = hash;
    return all;
  }

 private:
  ScratchFolder scratch_;
  std::set<std::string> objects_;
};

}  // namespace

TEST_CASE("the inputs of an exercise are its own code, its includes, and the code common to all", "[kept]") {
  using Names = std::vector<std::string>;
  const std::string own = "chapters/20_own/", book = "chapters/03_motion/", exercise = "/exercise.cpp";
  Built built;
  for (const char* name : {"01_orbit", "03_kepler", "05_pendulum", "07_bead"})
    built.source("tree/" + book + name + exercise, "");
  built.source("tree/" + book + "shared/lagrange.hpp", "");
  built.source("tree/" + book + "05_pendulum/swing.hpp", "#include \"" + book + "shared/lagrange.hpp\"");
  built.source("tree/" + book + "07_bead/exercise.cpp", "#include \"" + book + "05_pendulum/swing.hpp\"");
  built.source("tree/report/study/scenes.cpp", "#include \"" + book + "05_pendulum/models.hpp\"");
  built.source("own/" + own + "02_ball/ball.hpp", "");
  built.source("own/" + own + "02_ball/exercise.cpp", "");
  built.source("own/" + own + "04_box/exercise.cpp", "#  include \"../06_rod/rod.hpp\"");
  built.source("own/" + own + "06_rod/rod.hpp", "#include \"common.hpp\"");
  built.source("own/" + own + "06_rod/exercise.cpp", "");
  built.source("own/common.hpp", "#include <" + own + "08_top/top.hpp>");
  built.source("own/" + own + "08_top/top.hpp", "");
  built.source("own/" + own + "08_top/exercise.cpp", "");
  built.together("3_0", {book + "01_orbit/exercise.cpp", book + "03_kepler/exercise.cpp"}, "1");
  for (const char* name : {"05_pendulum", "07_bead"}) built.object(book + name + exercise, "1");
  built.object(book + "shared/lagrange.cpp", "1");
  for (const char* name : {"02_ball", "04_box", "06_rod", "08_top"}) {
    built.object("own/" + own + name + exercise, "1");
  }
  for (const char* generator : {"20_02_ball", "03_05_swing", "common"})
    built.source("own/reference/make/" + std::string(generator) + ".cpp", "");
  for (const char* file :
       {"own/reference/make/20_02_ball.cpp", "own/reference/make/common.cpp", "solvers/ode/euler.cpp",
        "chapters/scene.cpp", "registry.cpp", "report/study/run.cpp", "report/pages/page.cpp"})
    built.object(file, "1");

  auto before = built.made_from();
  CHECK(before.size() == 8);
  const Names everyone{"20.2", "20.4", "20.6", "20.8", "3.1", "3.3", "3.5", "3.7"};
  const Names all_own{"20.2", "20.4", "20.6", "20.8"};
  const auto changes = [&](const std::string& file) {
    built.object(file, "2");
    auto after = built.made_from();
    const Names names = changed(before, after);
    before = std::move(after);
    return names;
  };
  CHECK(changed(before, built.made_from()).empty());
  CHECK(changes("own/" + own + "02_ball/exercise.cpp") == Names{"20.2"});
  CHECK(changes("own/" + own + "04_box/exercise.cpp") == Names{"20.4"});
  CHECK(changes("own/" + own + "06_rod/exercise.cpp") == Names{"20.4", "20.6"});
  CHECK(changes("own/" + own + "08_top/exercise.cpp") == Names{"20.4", "20.6", "20.8"});
  CHECK(changes(book + "05_pendulum/exercise.cpp") == Names{"3.5", "3.7"});
  CHECK(changes(book + "shared/lagrange.cpp") == Names{"3.5", "3.7"});
  CHECK(changes("own/reference/make/20_02_ball.cpp") == all_own);
  CHECK(changes("own/reference/make/common.cpp") == all_own);
  CHECK(changes("solvers/ode/euler.cpp") == everyone);
  CHECK(changes("chapters/scene.cpp") == everyone);
  CHECK(changes("report/study/run.cpp") == everyone);
  CHECK(changes("report/pages/page.cpp").empty());
  CHECK(changes("registry.cpp").empty());
  built.together("3_0", {book + "01_orbit/exercise.cpp", book + "03_kepler/exercise.cpp"}, "2");
  CHECK(changed(before, built.made_from()) == Names{"3.1", "3.3"});
  before = built.made_from();
  CHECK(changes("own/reference/make/03_05_swing.cpp") == everyone);  // it is a generator of the tree
}

}  // namespace oddity
