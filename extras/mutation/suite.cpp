#include "extras/mutation/suite.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <regex>
#include <set>
#include <sstream>

#include "extras/mutation/mutant.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/proofs.hpp"
#include "report/study/parallel.hpp"
#include "report/study/run_program.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t memory = std::size_t{8} << 30;

/// The unit tests, except those about the sources' text, third-party libraries or printed output, and those
/// that take minutes.
constexpr const char* judges =
    "~[slow]~[.]~[properties]~[libraries]~[lanes]~[site]~[module]~[sweep]~[commands]~[code]~[rooms]~[readable]"
    "~[new]~[walk]~[terminal]~[hostile]~[bench]~[witness]~[proofs]~[mutation]";
constexpr double longest_unit_test = 20;  ///< s of CPU time; longer tests are not used

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The program of the unit tests next to oddity, if it is compiled.
fs::path tests_of(const fs::path& program) { return program.parent_path() / "tests/oddity_tests"; }

/// "3.5" for chapters/03_rigid_body_motion/05_pendulum/models.hpp, "3." for other files of its chapter,
/// "table 03_05_swing" for its generator, "table " for shared code of generators, else "".
std::string home_of(const std::string& file) {
  static const std::regex chapter("chapters/0?([0-9]+)_[^/]*/(0?([0-9]+)_)?.*");
  static const std::regex generator("reference/make/([0-9]+_[0-9]+_[^/]*)\\.cpp");
  std::smatch found;
  if (std::regex_match(file, found, chapter)) return found[1].str() + "." + found[3].str();
  if (std::regex_match(file, found, generator)) return "table " + found[1].str();
  return file.starts_with("reference/make/") ? "table " : "";
}

/// Whether a mutant with this home may be reached by the test case. One of no chapter and no table, or of the
/// generators' shared code, may be reached by every exercise and unit test.
bool may_reach(const std::string& home, const std::string& tag) {
  const bool of_a_table = tag.starts_with("table "), of_an_exercise = tag.starts_with("unit [");
  if (home.empty() || (home == "table " && !of_a_table)) return !of_a_table && !of_an_exercise;
  const std::string about = of_an_exercise ? tag.substr(6, tag.size() - 7) : tag;
  return home.ends_with('.') || home == "table " ? about.starts_with(home) : about == home;
}

/// Catch2's test specification for the test of this name, or for those of a tag, "[3.5]".
std::string spec_of(const std::string& test) {
  if (test.starts_with('[')) return test;
  return std::regex_replace(test, std::regex(R"([\\,\[\]"*])"), R"(\$&)");
}

/// The names of the unit tests used, by Catch2 2 or 3.
std::vector<std::string> unit_tests(const fs::path& program) {
  Ended listed = run_program({program.string(), judges, "--list-test-names-only"}, "", 600s);
  if (listed.output.empty())
    listed = run_program({program.string(), judges, "--list-tests", "--verbosity", "quiet"}, "", 600s);
  std::vector<std::string> names;
  std::istringstream lines(listed.output);
  for (std::string name; std::getline(lines, name);)
    if (!name.empty()) names.push_back("unit " + name);
  return names;
}

/// `oddity verify` of one exercise, and of the register, which reports missing claims; or a unit test; or a
/// table made again; or proofs written, which nothing checks without Coq.
std::vector<std::string> command_of(const fs::path& program, const std::string& tag, const fs::path& proofs) {
  if (tag == "proofs") return {"env", "PATH=", program.string(), "prove", "--out", proofs.string()};
  if (tag.starts_with("unit ")) return {tests_of(program).string(), spec_of(tag.substr(5))};
  if (!tag.starts_with("table ")) return {program.string(), "verify", "[" + tag + "],[register]"};
  return {(program.parent_path() / "make_reference").string(), "--again", ODDITY_SOURCE "/reference",
          tag.substr(6)};
}

/// Whether the files, CLAIM.v, are those that Coq has checked.
bool as_on_record(const fs::path& proofs) {
  static const ProvedClaims record = read_proofs(fs::path(ODDITY_SOURCE) / "reference/approved");
  return fs::exists(proofs) && std::ranges::all_of(record, [&](const auto& proved) {
           return proof_hash(read(proofs / (proved.first + ".v"))) == proved.second.hash;
         });
}

/// Runs the test case with a mutant, 0 for none. Mutants reached are noted in this file, if it exists. A
/// limit of CPU time, unlike one of wall time, does not depend on the machine's load.
Ended tried(const fs::path& program, const std::string& tag, int mutant, const fs::path& reached,
            double seconds) {
  const long most = std::lround(std::ceil(seconds));
  std::vector<std::string> command{"prlimit",
                                   "--core=0",
                                   "--cpu=" + std::to_string(most) + ":" + std::to_string(most + 1),
                                   "env",
                                   "ODDITY_MUTANT=" + std::to_string(mutant),
                                   "ODDITY_MUTANTS_REACHED=" + reached.string()};
  const fs::path proofs = reached.string() + ".written";
  for (std::string& word : command_of(program, tag, proofs)) command.push_back(std::move(word));
  Ended ended = run_program(command, "", std::chrono::seconds(60 * most), memory);
  if (tag == "proofs") ended.ok = ended.how == "status 2" && as_on_record(proofs);
  fs::remove_all(proofs);
  return ended;
}

}  // namespace

std::string_view name_of(Fate f) {
  switch (f) {
    case Fate::killed:
      return "killed";
    case Fate::survived:
      return "survived";
    case Fate::not_reached:
      return "not reached";
  }
  return "";
}

Suite::Suite(fs::path program, fs::path kept, std::size_t last)
    : program_(std::move(program)), kept_(std::move(kept)), last_(last) {
  const Ended listed = run_program({program_.string(), "verify", "--list-tests"}, "", 600s);
  static const std::regex tag("\\[([0-9]+\\.[0-9]+)\\]");
  for (std::sregex_iterator at(listed.output.begin(), listed.output.end(), tag), end; at != end; ++at)
    tags_.push_back((*at)[1]);
  if (tags_.empty())
    throw BadInput(program_.string() + " verify --list-tests names no exercises: " + listed.how + "; " +
                   listed.words);
  for (const auto& table : fs::directory_iterator(fs::path(ODDITY_SOURCE) / "reference/tables"))
    tags_.push_back("table " + table.path().stem().string());
  if (!fs::exists(tests_of(program_))) return;
  for (std::size_t i = 0, exercises = tags_.size(); i < exercises; ++i)
    if (!tags_[i].starts_with("table ")) tags_.push_back("unit [" + tags_[i] + "]");
  for (std::string& test : unit_tests(tests_of(program_))) tags_.push_back(std::move(test));
}

Suite::TestCase Suite::measured(const std::string& tag) const {
  const fs::path file = kept_ / tag, time = kept_ / (tag + ".seconds");
  if (!fs::exists(time) || fs::file_size(file) != last_ + 1) {
    write_whole(file, std::string(last_ + 1, '\0'));
    const bool may_be_left_out = tag.starts_with("unit ");
    const Ended ended = tried(program_, tag, 0, file, may_be_left_out ? longest_unit_test : 3600);
    if (!ended.ok && !may_be_left_out)
      throw BadInput(tag + " is red without a mutant: " + ended.how + "\n" + ended.output + ended.words);
    if (!ended.ok) {
      std::cout << (tag + " judges nothing: without a mutant it ends with " + ended.how + "\n") << std::flush;
      write_whole(file, std::string(last_ + 1, '\0'));
    }
    write_whole(time, std::to_string(ended.cpu_seconds));
  }
  return {tag, std::stod(read(time)), read(file)};
}

void Suite::measure(const std::vector<Mutant>& mutants) {
  std::set<std::string> homes;
  for (const Mutant& m : mutants) homes.insert(home_of(m.file));
  for (const std::string& tag : tags_)
    if (std::ranges::any_of(homes, [&](const std::string& home) { return may_reach(home, tag); }))
      known_.push_back({tag, 0, ""});
  parallel_for_each(known_, [&](TestCase& t) { t = measured(t.tag); });
  std::ranges::stable_sort(known_, {}, &TestCase::seconds);
  known_.push_back(measured("proofs"));
}

bool Suite::is_absent(const Mutant& m) const {
  const auto found = [&](Seen how) {
    return std::ranges::any_of(known_, [&](const TestCase& t) {
      return t.reached[static_cast<std::size_t>(m.number)] == static_cast<char>(how);
    });
  };
  return !found(seen) && found(seen_without_it);
}

Judgement Suite::judge(const Mutant& m) const {
  Judgement judgement;
  const std::string home = home_of(m.file);
  for (const TestCase& t : known_) {
    const bool asked = t.tag == "proofs" ? !home.starts_with("table ") : may_reach(home, t.tag);
    if (!asked || t.reached[static_cast<std::size_t>(m.number)] != static_cast<char>(seen)) continue;
    const fs::path none = kept_ / ("mutant " + std::to_string(m.number));
    const Ended ended = tried(program_, t.tag, m.number, none, 5 + 4 * t.seconds);
    if (!ended.ok) return {Fate::killed, t.tag + ", " + ended.how};
    judgement = {Fate::survived, ""};
  }
  return judgement;
}

}  // namespace oddity::mutation
