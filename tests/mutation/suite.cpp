#include "tests/mutation/suite.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/proofs.hpp"
#include "report/study/run_program.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t memory = std::size_t{8} << 30;

/// The processor time of all programs run so far.
double processor_seconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "3.5" of chapters/03_rigid_body_motion/05_pendulum/models.hpp, "3." of its chapter's other files, "table
/// 03_05_swing" of its maker, "table " of what makers share, else "".
std::string home_of(const std::string& file) {
  static const std::regex chapter("chapters/0?([0-9]+)_[^/]*/(0?([0-9]+)_)?.*");
  static const std::regex maker("reference/make/([0-9]+_[0-9]+_[^/]*)\\.cpp");
  std::smatch found;
  if (std::regex_match(file, found, chapter)) return found[1].str() + "." + found[3].str();
  if (std::regex_match(file, found, maker)) return "table " + found[1].str();
  return file.starts_with("reference/make/") ? "table " : "";
}

/// Whether a mutant at home there may be reached by the test case: one of no chapter and no table by every
/// exercise.
bool may_reach(const std::string& home, const std::string& tag) {
  if (home.ends_with('.') || home == "table ") return tag.starts_with(home);
  return home.empty() ? !tag.starts_with("table ") : tag == home;
}

/// `oddity verify` of one exercise, and of the register, which misses claims; or a table made again; or
/// proofs written, which nothing checks as there is no Coq.
std::vector<std::string> command_of(const fs::path& program, const std::string& tag, const fs::path& proofs) {
  if (tag == "proofs") return {"env", "PATH=", program.string(), "prove", "--out", proofs.string()};
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

/// The test case with a mutant, 0 for none. A limit of the processor's time, unlike one of the clock's, does
/// not depend on what else the machine does.
Ended tried(const fs::path& program, const std::string& tag, int mutant, const fs::path& reached,
            double seconds) {
  setenv("ODDITY_MUTANT", std::to_string(mutant).c_str(), 1);
  setenv("ODDITY_MUTANTS_REACHED", reached.c_str(), 1);
  const long most = std::lround(std::ceil(seconds));
  std::vector<std::string> command{"prlimit", "--core=0",
                                   "--cpu=" + std::to_string(most) + ":" + std::to_string(most + 1)};
  const fs::path proofs = reached.parent_path() / "written";
  fs::remove_all(proofs);
  for (std::string& word : command_of(program, tag, proofs)) command.push_back(std::move(word));
  Ended ended = run_program(command, "", std::chrono::seconds(60 * most), memory);
  if (tag == "proofs") ended.ok = ended.how == "status 2" && as_on_record(proofs);
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
}

const Suite::TestCase& Suite::known(const std::string& tag) {
  const auto at = known_.find(tag);
  if (at != known_.end()) return at->second;
  const fs::path file = kept_ / tag, time = kept_ / (tag + ".seconds");
  if (!fs::exists(time) || fs::file_size(file) != last_ + 1) {
    write_whole(file, std::string(last_ + 1, '\0'));
    const double before = processor_seconds();
    const Ended ended = tried(program_, tag, 0, file, 3600);
    if (!ended.ok)
      throw BadInput(tag + " is red without a mutant: " + ended.how + "\n" + ended.output + ended.words);
    write_whole(time, std::to_string(processor_seconds() - before));
  }
  return known_[tag] = {tag, std::stod(read(time)), read(file)};
}

std::vector<std::string> Suite::candidates(const Mutant& m) {
  const std::string home = home_of(m.file);
  std::vector<std::string> tags;
  for (const std::string& tag : tags_)
    if (may_reach(home, tag)) tags.push_back(tag);
  std::ranges::stable_sort(tags, {}, [&](const std::string& tag) { return known(tag).seconds; });
  if (!home.starts_with("table ")) tags.emplace_back("proofs");
  return tags;
}

Judgement Suite::judge(const Mutant& m) {
  Judgement judgement;
  const fs::path noted = kept_ / "mutant";
  for (const std::string& tag : candidates(m)) {
    const TestCase& t = known(tag);
    if (!t.reached[static_cast<std::size_t>(m.number)]) continue;
    const Ended ended = tried(program_, tag, m.number, noted, 5 + 4 * t.seconds);
    if (!ended.ok) return {Fate::killed, tag + ", " + ended.how};
    judgement = {Fate::survived, ""};
  }
  return judgement;
}

}  // namespace oddity::mutation
