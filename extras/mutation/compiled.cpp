#include "extras/mutation/compiled.hpp"

#include <cstdlib>
#include <fstream>
#include <set>
#include <string_view>

#include "reference/bad_input.hpp"
#include "report/study/run_program.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

void shell(const std::string& command) {
  if (std::system(command.c_str()) != 0) throw BadInput("this failed: " + command);
}

/// Configures the mutated tree, with cheap optimization and checked array bounds. GCC 12 at -O1 with its
/// analysis of memory that functions reach takes a variable for unchanged although a lambda changes it by
/// reference.
void configure(const Folders& folders, const std::string& rooms) {
  const std::string flags =
      "-O1 -fno-ipa-modref -fconcepts -w -D_GLIBCXX_ASSERTIONS -fsanitize=bounds "
      "-fsanitize-undefined-trap-on-error";
  shell("cmake -S '" + folders.tree.string() + "' -B '" + folders.build.string() +
        "' -G Ninja -DCMAKE_BUILD_TYPE=Mutated '-DCMAKE_CXX_FLAGS_MUTATED=" + flags + "' '-DODDITY_MUTATED=" +
        rooms + "' -DODDITY_FAST_BUILD=ON -DODDITY_TESTS=ON -DODDITY_MODULE=OFF >&2");
}

void build_targets(const fs::path& build, const std::string& targets) {
  shell("cmake --build '" + build.string() + "' --target " + targets + " >&2");
}

/// The build's command for linking the program.
std::string linking(const fs::path& built, const std::string& program) {
  const Ended told = run_program({"ninja", "-C", built.string(), "-t", "commands", program}, "", 600s);
  const std::string_view before = ": && ", after = " && :";
  const auto last = told.output.rfind("\n" + std::string(before)), end = told.output.rfind(after);
  if (last == std::string::npos || end == std::string::npos || end < last)
    throw BadInput(built.string() + ": Ninja lists no command that links " + program + ": " + told.words);
  return told.output.substr(last + 1 + before.size(), end - last - 1 - before.size());
}

/// The text with `that`, which must occur once, replaced.
std::string replaced(std::string text, const std::string& that, const std::string& by) {
  const auto at = text.find(that);
  if (at == std::string::npos) throw BadInput("there is no " + that + "in this: " + text);
  return text.replace(at, that.size(), by);
}

std::vector<fs::path> objects_in(const fs::path& list) {
  std::ifstream in(list);
  std::vector<fs::path> all;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) all.push_back(fs::path(line).lexically_normal());
  return all;
}

/// Links the program again. Objects of the lists, which belong to libraries, come before all others; mutated
/// tests replace the build's. Of several copies of an inline function the linker takes the first.
void link(const Folders& folders, const std::string& program, const std::vector<std::string>& lists) {
  const std::string tests = "tests/CMakeFiles/", in_build = " " + tests + "oddity_tests.dir/";
  fs::path output = program;
  std::string line = linking(folders.beside, program), mutated_tests;
  if (program == "oddity_tests") {
    output = "tests/oddity_tests";
    for (const fs::path& object : objects_in(folders.build / "mutated_tests.objects")) {
      const std::string name =
          object.lexically_relative(folders.build / tests / "mutated_tests.dir").string();
      line = replaced(line, in_build + name + " ", " ");
      mutated_tests += " '" + object.string() + "'";
    }
  }
  std::string first = " -Wl,--allow-multiple-definition";
  for (const std::string& list : lists)
    first += " '@" + (folders.build / ("mutated_" + list + ".objects")).string() + "'";
  first += mutated_tests;
  line = replaced(line, " -o " + output.string() + " ", " -o '" + (folders.build / output).string() + "' ");
  shell("cd '" + folders.beside.string() + "' && " + line.insert(line.find(' '), first));
}

/// Lanes are not mutated, but some answers that tests request contain them.
void bring_lanes(const Folders& folders) {
  const fs::path lanes = folders.beside / "liboddity_lanes.so", here = folders.build / lanes.filename();
  if (fs::exists(lanes) && !fs::exists(here)) fs::create_symlink(lanes, here);
}

std::string joined(const std::set<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// The sources that are compiled with a mutated room: all of the solvers, as most of them is in headers.
std::string compiled_with(const std::string& room) { return room.starts_with("solvers") ? "solvers" : room; }

}  // namespace

fs::path compiled_program(const Folders& folders, const std::vector<Mutant>& mutants) {
  std::set<std::string> rooms, programs{"oddity", "oddity_tests"};
  for (const Mutant& m : mutants) rooms.insert(compiled_with(m.room()));
  if (rooms.contains("reference/make")) programs.insert("make_reference");
  configure(folders, joined(rooms, "|"));
  build_targets(folders.build, "mutated");
  build_targets(folders.beside, joined(programs, " "));
  fs::create_directories(folders.build / "tests");
  for (const std::string& program : programs)
    link(folders, program,
         program == "make_reference"
             ? std::vector<std::string>{"generators"}
             : std::vector<std::string>{"formula", "solvers", "ublas", "generators", "chapters", "report"});
  bring_lanes(folders);
  return folders.build / "oddity";
}

}  // namespace oddity::mutation
