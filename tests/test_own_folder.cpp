// A user's exercises outside the tree: cases that the build refuses instead of leaving them out.

#include <filesystem>
#include <fstream>

#include "report/verify/catch.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

namespace fs = std::filesystem;
using program::Ran, program::says, program::shell;

namespace {

const std::string cmake_files = std::string(ODDITY_SOURCE) + "/cmake/";

/// CMake's messages in a project without languages, on one line.
Ran configured(const ScratchFolder& scratch, const std::string& text) {
  scratch.file("project/CMakeLists.txt",
               "cmake_minimum_required(VERSION 3.25)\nproject(found NONE)\ninclude(" + cmake_files +
                   "found.cmake)\n" + text);
  const std::string folder = (scratch.path() / "project").string();
  return shell("cmake -G Ninja -S " + folder + " -B " + folder + "/built 2>&1 | tr '\\n' ' ' | tr -s ' '");
}

Ran found_in(const ScratchFolder& scratch, const std::string& home) {
  const std::string folder = "[==[" + (scratch.path() / home).string() + "]==]";
  return configured(scratch, "require_own(" + folder + ")\nfind_own(" + folder +
                                 ")\nmessage(STATUS \"found ${own_exercises} and ${own_generators}\")\n");
}

}  // namespace

TEST_CASE("the contents of an own folder are found, for any name", "[own]") {
  const ScratchFolder scratch;
  const std::string home = "it's (a) #folder & é";
  scratch.file(home + "/chapters/20_own/02_ball/exercise.cpp", "");
  scratch.file(home + "/chapters/20_own/02_ball/methods.cpp", "");
  scratch.file(home + "/reference/make/20_02_ball.cpp", "");
  const Ran ran = found_in(scratch, home);
  INFO(ran.output);
  CHECK(says(ran, home + "/chapters/20_own/02_ball/exercise.cpp and "));
  CHECK(says(ran, home + "/reference/make/20_02_ball.cpp"));
}

TEST_CASE("an own folder that would be left out is refused by name", "[own]") {
  const ScratchFolder scratch;
  const auto refuses = [&](const std::string& home, const std::string& reason) {
    const Ran ran = found_in(scratch, home);
    INFO(home << "\n" << ran.output);
    CHECK(says(ran, "CMake Error"));
    CHECK(says(ran, reason));
  };
  refuses("none", "none is no folder");
  for (const char* odd : {"a[b", "a]b", "a*", "a?", "a$ENV{HOME}", "a\"b", "a\\b", "a,b", "a|b", "a\nb"}) {
    fs::create_directories(scratch.path() / odd);
    refuses(odd, "rename it, or name a link to it");
  }
  scratch.file("a/chapters/20_own/02_ball/exercize.cpp", "");
  refuses("a",
          "/chapters/20_own/02_ball: an exercise is defined in its folder's exercise.cpp, and this has "
          "exercize.cpp alone");
  scratch.file("b/chapters/02_ball/exercise.cpp", "");
  refuses("b", "/chapters/02_ball/exercise.cpp is not compiled");
  scratch.file("c/chapters/20_own/02_ball/exercise.cpp", "");
  for (const char* inside : {"c/chapters", "c/chapters/20_own", "c/chapters/20_own/02_ball"})
    refuses(inside, "ODDITY_OWN names FOLDER");
}

TEST_CASE("the entry refuses an own folder that CMake would read as more than a name", "[own]") {
  for (const char* odd : {"a[b", "a*", "${HOME}", "a\"b", "a\\b", "a;b", "a\nb"}) {
    const ScratchFolder scratch;
    // Only the function of the folder: nothing is to be built.
    const Ran ran = shell("odd=$(cat <<'END'\n" + std::string(odd) +
                          "\nEND\n); ODDITY_OWN=$odd bash -c 'eval \"$(sed -n \"/^own_folders() {/,/^}/p\" " +
                          ODDITY_SOURCE + "/oddity)\"; own_folders'");
    INFO(odd << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK(says(ran, "oddity: ODDITY_OWN has a character"));
  }
}

TEST_CASE("a file without the function that its name promises is named", "[own]") {
  const ScratchFolder scratch;
  const auto checked = [&](const std::string& file, const std::string& text) {
    const fs::path listed = scratch.file("listed.txt", scratch.file(file, text).string());
    return shell("cmake -DFILES=" + listed.string() + " -DOUT=" + (scratch.path() / "out").string() + " -P " +
                 cmake_files + "promised.cmake 2>&1 | tr '\\n' ' ' | tr -s ' '");
  };
  const std::string exercise = "chapters/20_own/02_ball/exercise.cpp", generator = "make/20_02_ball.cpp";
  CHECK(checked(exercise, "Exercise exercise_20_2() {").output.empty());
  CHECK(checked(generator, "Truth truth_20_02_ball() {").output.empty());
  CHECK(says(checked(exercise, "Exercise exercise_20_3() {"),
             "/exercise.cpp: it must define Exercise exercise_20_2(), as its name promises"));
  CHECK(says(checked(generator, "Truth truth_20_02_bal() {"), "it must define Truth truth_20_02_ball()"));
}

TEST_CASE("an algorithm's line that CMake does not understand is an error, and no other line is lost",
          "[own]") {
  const ScratchFolder scratch;
  const auto listed = [&](const std::string& text) {
    const std::string header = scratch.file("algorithms.hpp", "#define ALL(F) \\\n" + text + "\n").string();
    return configured(scratch, "list_algorithms(all " + header + ")\nmessage(STATUS \"listed ${all}\")\n");
  };
  CHECK(says(listed("  F(One, one) \\\n   F(Two, two)\\\n\tF(Three, three)"),
             "listed F(One, one);F(Two, two);F(Three, three)"));
  CHECK(says(listed("  F(One, one) \\\n  F(Two two)"),
             "algorithms.hpp:3: an algorithm is F(Algorithm, header)"));
  CHECK(says(listed("  F(One, one) F(Two, two)"), "algorithms.hpp:2: "));
}
