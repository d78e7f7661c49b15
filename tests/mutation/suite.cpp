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

/// "3.5" of chapters/03_rigid_body_motion/05_pendulum/models.hpp, "3." of its chapter's other files, else "".
std::string home_of(const std::string& file) {
  static const std::regex chapter("chapters/0?([0-9]+)_[^/]*/(0?([0-9]+)_)?.*");
  std::smatch found;
  if (!std::regex_match(file, found, chapter)) return "";
  return found[1].str() + "." + found[3].str();
}

/// `oddity verify` of one exercise, and of the register, which misses claims, with a mutant, 0 for none. A
/// limit of the processor's time, unlike one of the clock's, does not depend on what else the machine does.
Ended verify(const fs::path& program, const std::string& tag, int mutant, const fs::path& reached,
             double seconds) {
  setenv("ODDITY_MUTANT", std::to_string(mutant).c_str(), 1);
  setenv("ODDITY_MUTANTS_REACHED", reached.c_str(), 1);
  const long most = std::lround(std::ceil(seconds));
  return run_program({"prlimit", "--core=0", "--cpu=" + std::to_string(most) + ":" + std::to_string(most + 1),
                      program.string(), "verify", "[" + tag + "],[register]"},
                     "", std::chrono::seconds(60 * most), memory);
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

Suite::Suite(fs::path program, fs::path kept, std::size_t count)
    : program_(std::move(program)), kept_(std::move(kept)), count_(count) {
  const Ended listed = run_program({program_.string(), "verify", "--list-tests"}, "", 600s);
  static const std::regex tag("\\[([0-9]+\\.[0-9]+)\\]");
  for (std::sregex_iterator at(listed.output.begin(), listed.output.end(), tag), end; at != end; ++at)
    tags_.push_back((*at)[1]);
  if (tags_.empty())
    throw BadInput(program_.string() + " verify --list-tests names no exercises: " + listed.how + "; " +
                   listed.words);
}

const Suite::TestCase& Suite::known(const std::string& tag) {
  const auto at = known_.find(tag);
  if (at != known_.end()) return at->second;
  const fs::path file = kept_ / tag, time = kept_ / (tag + ".seconds");
  if (!fs::exists(time) || fs::file_size(file) != count_ + 1) {
    write_whole(file, std::string(count_ + 1, '\0'));
    const double before = processor_seconds();
    const Ended ended = verify(program_, tag, 0, file, 3600);
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
    if (tag == home || (home.ends_with('.') && tag.starts_with(home)) || home.empty()) tags.push_back(tag);
  std::ranges::stable_sort(tags, {}, [&](const std::string& tag) { return known(tag).seconds; });
  return tags;
}

Judgement Suite::judge(const Mutant& m) {
  Judgement judgement;
  const fs::path noted = kept_ / "mutant";
  for (const std::string& tag : candidates(m)) {
    const TestCase& t = known(tag);
    if (!t.reached[static_cast<std::size_t>(m.number)]) continue;
    const Ended ended = verify(program_, tag, m.number, noted, 5 + 4 * t.seconds);
    if (!ended.ok) return {Fate::killed, tag + ", " + ended.how};
    judgement = {Fate::survived, ""};
  }
  return judgement;
}

}  // namespace oddity::mutation
