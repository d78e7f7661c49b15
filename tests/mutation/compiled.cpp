#include "tests/mutation/compiled.hpp"

#include <cstdlib>
#include <regex>
#include <set>

#include "reference/bad_input.hpp"
#include "report/study/run_program.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

void shell(const std::string& command) {
  if (std::system(command.c_str()) != 0) throw BadInput("this failed: " + command);
}

/// Configures the mutated tree, at a level that costs the compiler little, and with the bounds of arrays
/// checked. GCC 12 at -O1 takes a variable for unchanged that a lambda changes which has it by reference, by
/// its analysis of memory that functions reach.
void configure(const Folders& folders, const std::string& rooms) {
  const std::string flags =
      "-O1 -fno-ipa-modref -fconcepts -w -D_GLIBCXX_ASSERTIONS -fsanitize=bounds "
      "-fsanitize-undefined-trap-on-error";
  shell("cmake -S '" + folders.tree.string() + "' -B '" + folders.build.string() +
        "' -G Ninja -DCMAKE_BUILD_TYPE=Mutated '-DCMAKE_CXX_FLAGS_MUTATED=" + flags + "' '-DODDITY_MUTATED=" +
        rooms + "' -DODDITY_FAST_BUILD=ON -DODDITY_TESTS=OFF -DODDITY_MODULE=OFF >&2");
}

void build_targets(const fs::path& build, const std::string& targets) {
  shell("cmake --build '" + build.string() + "' --target " + targets + " >&2");
}

/// The command that links the program of the build anew as `output`, with these objects before all others.
std::string linking(const fs::path& built, const std::string& program, const std::string& objects,
                    const fs::path& output) {
  const Ended told = run_program({"ninja", "-C", built.string(), "-t", "commands", program}, "", 600s);
  const auto last = told.output.rfind("\n: && ");
  std::smatch parts;
  const std::string line = last == std::string::npos ? "" : told.output.substr(last + 1);
  static const std::regex link(R"(: && (\S+) (.*) -o \S+ (.*) && :\s*)");
  if (!std::regex_match(line, parts, link))
    throw BadInput(built.string() + ": Ninja does not say how it links " + program + ": " + told.words);
  return "cd '" + built.string() + "' && " + parts[1].str() + " -Wl,--allow-multiple-definition " + objects +
         " " + parts[2].str() + " -o '" + output.string() + "' " + parts[3].str();
}

std::string joined(const std::set<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// Whose sources are compiled where the room is mutated: of the solvers all, as most is in headers.
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
  const auto objects = [&](const std::string& of) {
    return "'@" + (folders.build / ("mutated_" + of + ".objects")).string() + "' ";
  };
  const std::string makers = objects("makers"),
                    all = objects("solvers") + makers + objects("chapters") + objects("report");
  for (const std::string& program : programs)
    shell(linking(folders.beside, program, program == "make_reference" ? makers : all,
                  folders.build / (program == "oddity_tests" ? "tests" : "") / program));
  return folders.build / "oddity";
}

}  // namespace oddity::mutation
