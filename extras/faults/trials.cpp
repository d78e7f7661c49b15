#include "extras/faults/trials.hpp"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <memory>
#include <set>
#include <thread>

#include "chapters/random.hpp"
#include "reference/files.hpp"
#include "tests/scratch_folder.hpp"

namespace faults {

namespace fs = std::filesystem;

namespace {

bool says(const Ended& ended, const std::string& text) {
  return ended.output.find(text) != std::string::npos;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// For files that contain times, whose text differs from run to run.
bool ends_like(const std::string& text, const std::string& other) {
  if (other.ends_with("</svg>\n")) return text.ends_with("</svg>\n");
  return text.ends_with('\n') && std::ranges::count(text, '\n') == std::ranges::count(other, '\n');
}

class Trials {
 public:
  Trials(const Verb& verb, const Installed& program, const Count& count, unsigned seed);

  bool can_be_run() const { return clean_.status == 0 || !says(clean_, "built without"); }
  std::vector<Cell> all();

 private:
  using Disturbed = std::function<Ended(Command)>;

  /// Resets the folder to its state before the command, or after one whole run of it.
  void reset(bool done);
  Command command(const std::string& fault = "", long at = 0) const;
  /// Number of writes of the last run that came to its end.
  long writes() const;
  /// Faults found in the folder; only a kill may leave parts of files.
  std::vector<std::string> wrong(bool parts_allowed, bool complete) const;
  bool is_whole(const std::string& path, const std::string& text) const;
  /// Notes the faults found after a run, and in how it ended.
  void judge(Cell& cell, const std::string& when, const Ended& ended, const std::set<int>& statuses,
             bool parts_allowed);
  /// Checks that the command continues from the files left, and finishes.
  void goes_on(Cell& cell, const std::string& when);
  void note(Cell& cell, const std::string& when, const Ended& ended, std::vector<std::string> what);
  std::vector<long> some_writes() const;

  Cell killed_at_random();
  Cell killed_at_writes();
  Cell full_disk();
  Cell read_only();
  Cell interrupted(int signal, const std::string& name);
  Cell out_of_memory();
  Cell two_at_once();
  Cell jumping_clock();
  Cell lost_output();

  const Verb& verb_;
  const Installed& program_;
  Count count_;
  oddity::Random random_;
  ScratchFolder scratch_;
  fs::path counted_ = scratch_.path() / "count", folder_ = scratch_.path() / "at_work",
           before_ = scratch_.path() / "before", after_ = scratch_.path() / "after";
  Ended clean_;
  Files texts_before_, texts_after_;
  long writes_ = 0;
};

Trials::Trials(const Verb& verb, const Installed& program, const Count& count, unsigned seed)
    : verb_(verb), program_(program), count_(count), random_(seed) {
  fs::create_directories(before_);
  fs::create_directories(folder_);
  if (verb.prepare) verb.prepare(folder_);
  fs::remove_all(before_);
  fs::copy(folder_, before_, fs::copy_options::recursive);
  clean_ = run(command());
  writes_ = writes();
  fs::copy(folder_, after_, fs::copy_options::recursive);
  texts_before_ = files_in(before_);
  texts_after_ = files_in(after_);
}

void Trials::reset(bool done) {
  fs::remove_all(folder_);
  fs::copy(done && !verb_.once ? after_ : before_, folder_, fs::copy_options::recursive);
}

Command Trials::command(const std::string& fault, long at) const {
  Command command = program_.command(verb_, folder_);
  command.environment["LD_PRELOAD"] = ODDITY_FAULTY_DISK;
  command.environment["ODDITY_FAULT"] = fault;
  command.environment["ODDITY_FAULT_AT"] = std::to_string(at);
  command.environment["ODDITY_FAULT_COUNT"] = counted_.string();
  return command;
}

long Trials::writes() const {
  long number = 0;
  std::ifstream(counted_) >> number;
  return number;
}

bool Trials::is_whole(const std::string& path, const std::string& text) const {
  const auto before = texts_before_.find(path), after = texts_after_.find(path);
  if (before != texts_before_.end() && text == before->second) return true;
  if (after == texts_after_.end()) return false;
  return text == after->second || (verb_.keeps && oddity::read_sealed(folder_ / path)) ||
         (verb_.timed && !verb_.keeps && ends_like(text, after->second));
}

std::vector<std::string> Trials::wrong(bool parts_allowed, bool complete) const {
  std::vector<std::string> all;
  const Files files = files_in(folder_);
  for (const auto& [path, text] : files) {
    const bool part = path.ends_with(".part");
    if (part && !parts_allowed) all.push_back(path + " is left");
    if (!part && !is_whole(path, text)) all.push_back(path + " is not whole");
  }
  for (const auto& [path, text] : complete ? texts_after_ : texts_before_)
    if (!files.contains(path)) all.push_back(path + " is lost");
  return all;
}

void Trials::note(Cell& cell, const std::string& when, const Ended& ended, std::vector<std::string> what) {
  if (what.empty()) return;
  std::string sentence = when + ": ended with " + std::to_string(ended.status);
  for (std::size_t i = 0; i < std::min<std::size_t>(what.size(), 4); ++i) sentence += "; " + what[i];
  cell.broken.push_back(sentence + (ended.output.empty() ? "" : " [" + first_line(ended.output) + "]"));
}

void Trials::judge(Cell& cell, const std::string& when, const Ended& ended, const std::set<int>& statuses,
                   bool parts_allowed) {
  ++cell.runs;
  auto what = wrong(parts_allowed, ended.status == 0 && !verb_.keeps);
  if (!statuses.contains(ended.status)) what.push_back("that is not its exit code");
  if (ended.status == 2 && !says(ended, "oddity: ") && verb_.program == "oddity")
    what.push_back("it gives no reason");
  if (says(ended, "internal error") || says(ended, "terminate called"))
    what.push_back("its message is for developers only");
  note(cell, when, ended, what);
}

void Trials::goes_on(Cell& cell, const std::string& when) {
  for (const auto& entry : fs::recursive_directory_iterator(folder_))  // pretends that days have passed
    if (entry.path().extension() == ".part")
      fs::last_write_time(entry, fs::last_write_time(entry) - std::chrono::hours(48));
  const Ended ended = run(command());
  judge(cell, when + ", and then undisturbed", ended, {0, verb_.once ? 2 : 0}, false);
  if (ended.status == 0) note(cell, when + ", and then undisturbed", ended, wrong(false, true));
}

std::vector<long> Trials::some_writes() const {
  std::set<long> some;
  for (int i = 0; i < count_.writes; ++i)
    some.insert(1 + i * std::max(0L, writes_ - 1) / std::max(1, count_.writes - 1));
  return {some.begin(), some.end()};
}

Cell Trials::killed_at_random() {
  Cell cell{verb_.name, "killed at a random moment"};
  for (int i = 0; i < count_.random; ++i) {
    if (i % 5 == 0) reset(i % 10 == 5);
    const double seconds = random_.between(0, 1.1 * clean_.seconds);
    const std::string when = "killed after " + std::to_string(seconds) + " s";
    judge(cell, when, run_until(command(), seconds, SIGKILL), {0, verb_.once ? 2 : 0, 128 + SIGKILL}, true);
    if (i % 5 == 4) goes_on(cell, when);
  }
  return cell;
}

Cell Trials::killed_at_writes() {
  Cell cell{verb_.name, "killed at a write"};
  for (long at : some_writes()) {
    const std::string when = "killed at write " + std::to_string(at);
    reset(at % 2 == 0);
    judge(cell, when, run(command("kill", at)), {0, 128 + SIGKILL}, true);
    goes_on(cell, when);
  }
  return cell;
}

Cell Trials::full_disk() {
  Cell cell{verb_.name, "disk full"};
  for (long at : some_writes()) {
    const std::string when = "full from write " + std::to_string(at) + " on";
    reset(at % 2 == 0);
    const Ended ended = run(command("full", at));
    judge(cell, when, ended, {verb_.keeps || writes() < at ? 0 : 2}, false);
    if (ended.status == 2 && !says(ended, "No space left on device"))
      note(cell, when, ended, {"it gives no reason"});
    goes_on(cell, when);
  }
  return cell;
}

Cell Trials::read_only() {
  Cell cell{verb_.name, "read-only"};
  for (bool done : {false, true}) {
    reset(done);
    const Ended ended = run(command("readonly", 1));
    const bool nothing_to_write = done && writes() == 0;  // everything is there already
    judge(cell, "read-only", ended, {verb_.keeps || nothing_to_write ? 0 : 2}, false);
    if (ended.status == 2 && !says(ended, "Read-only file system"))
      note(cell, "read-only", ended, {"it gives no reason"});
  }
  return cell;
}

Cell Trials::interrupted(int signal, const std::string& name) {
  Cell cell{verb_.name, name};
  for (int i = 0; i < std::max(2, count_.random / 4); ++i) {
    reset(i % 2 == 1);
    const double seconds = random_.between(0, 1.1 * clean_.seconds);
    const std::string when = name + " after " + std::to_string(seconds) + " s";
    const Ended ended = run_until(command(), seconds, signal);
    judge(cell, when, ended, {0, 128 + signal}, false);
    const bool begun = files_in(folder_) != (i % 2 == 1 && !verb_.once ? texts_after_ : texts_before_);
    if (ended.status == 128 + SIGINT && begun &&
        !says(ended, "interrupted; every file that was written is whole"))
      note(cell, when, ended, {"it does not report the interruption"});
  }
  goes_on(cell, name);
  return cell;
}

Cell Trials::out_of_memory() {
  Cell cell{verb_.name, "out of memory"};
  for (std::size_t megabytes : {40u, 50u, 60u, 70u, 80u, 100u, 120u, 150u, 200u, 250u, 300u, 400u, 600u}) {
    reset(megabytes % 20 == 0);
    Command little = command();
    little.memory = megabytes << 20;
    // 127: the program cannot start. Exit code 1 would be a verdict.
    judge(cell, std::to_string(megabytes) + " MB", run(little), {0, 2, 127}, false);
  }
  goes_on(cell, "out of memory");
  return cell;
}

Cell Trials::two_at_once() {
  Cell cell{verb_.name, "two at once"};
  for (int i = 0; i < std::max(3, count_.random / 4); ++i) {
    reset(i % 2 == 1);
    Process one(command());
    std::this_thread::sleep_for(
        std::chrono::duration<double>(i % 3 == 0 ? 0 : random_.between(0, clean_.seconds)));
    Process other(command());
    const Ended first = one.wait(), second = other.wait();
    judge(cell, "the first of two", first, {0, verb_.once ? 2 : 0}, false);
    judge(cell, "the second of two", second, {0, verb_.once ? 2 : 0}, false);
  }
  return cell;
}

Cell Trials::jumping_clock() {
  Cell cell{verb_.name, "clock that jumps"};
  for (bool done : {false, true}) {
    reset(done);
    judge(cell, "clock", run(command("clock")), {0}, false);
  }
  return cell;
}

Cell Trials::lost_output() {
  Cell cell{verb_.name, "standard output full"};
  reset(false);
  Command full = command();
  full.output = "/dev/full";
  const Ended ended = run(full);
  const bool loses = !clean_.output.empty();  // a command without output loses nothing
  judge(cell, "> /dev/full", ended, {loses ? 2 : 0}, false);
  if (loses && !says(ended, "cannot write to standard output"))
    note(cell, "> /dev/full", ended, {"it gives no reason"});
  return cell;
}

std::vector<Cell> Trials::all() {
  if (clean_.status != 0)
    return {{verb_.name,
             "undisturbed",
             1,
             {"ended with " + std::to_string(clean_.status) + " [" + clean_.output + "]"}}};
  return {killed_at_random(),
          killed_at_writes(),
          full_disk(),
          read_only(),
          interrupted(SIGINT, "SIGINT"),
          interrupted(SIGTERM, "SIGTERM"),
          interrupted(SIGHUP, "SIGHUP"),
          out_of_memory(),
          two_at_once(),
          jumping_clock(),
          lost_output()};
}

}  // namespace

std::vector<Cell> try_faults(const Verb& verb, const Installed& program, const Count& count, unsigned seed) {
  Trials trials(verb, program, count, seed);
  return trials.can_be_run() ? trials.all() : std::vector<Cell>();
}

}  // namespace faults
