// oddity_mutate: whether the tests notice a wrong formula, constant or condition.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "chapters/random.hpp"
#include "extras/mutation/compiled.hpp"
#include "extras/mutation/record.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/interrupted.hpp"
#include "report/study/parallel.hpp"

using namespace oddity;
using namespace oddity::mutation;
namespace fs = std::filesystem;

namespace {

struct Request {
  std::vector<std::string> paths{"chapters", "solvers", "report/study"};
  std::string in;      ///< "": anywhere
  int sample = 0;      ///< 0: all
  int each = 0;        ///< number per room; 0: all
  double minutes = 0;  ///< time limit; 0: none
  std::string seed = "HEAD";
  std::string program;
  bool list = false, record = false, again = false;
};

const fs::path tree = ODDITY_SOURCE, built = ODDITY_BUILT, home = tree / "build/mutate";
const fs::path scores_file = tree / "reference/trust/mutation.csv",
               survivors_file = tree / "extras/mutation/survivors.csv";

/// Whether the path is the file, or a folder that contains it.
bool within(const std::string& file, const std::string& path) {
  return file == path || file.starts_with(path.ends_with('/') ? path : path + "/");
}

/// The sources of the rooms, except those that the tests do not run: drawings are for the page.
bool wanted(const Request& request, const std::string& file) {
  if (file.ends_with("drawing.hpp") || file == "reference/make/main.cpp") return false;
  return std::ranges::any_of(request.paths, [&](const std::string& path) { return within(file, path); });
}

/// Orders mutants by a hash of the seed and the mutant's name. So the draw of one does not depend on the
/// others, and the mutants tried by an interrupted run are a fair sample too.
std::vector<Mutant> in_order(std::vector<Mutant> all, const Request& request, const Survivors& known) {
  if (!request.in.empty()) std::erase_if(all, [&](const Mutant& m) { return !within(m.file, request.in); });
  if (all.empty())
    throw BadInput("--in " + request.in + ": no mutants there; a path is within " + tree.string());
  if (request.again) std::erase_if(all, [&](const Mutant& m) { return !known.contains(m.id()); });
  std::map<int, std::uint64_t> rank;
  for (const Mutant& m : all)
    rank[m.number] = Random(static_cast<double>(number_of(request.seed + m.id()) >> 11)).bits();
  std::ranges::sort(all, {}, [&](const Mutant& m) { return rank[m.number]; });
  return all;
}

/// The first mutants, as many as requested.
std::vector<Mutant> drawn_of(std::vector<Mutant> all, const Request& request) {
  std::map<std::string, int> of_room;
  if (request.each > 0)
    std::erase_if(all, [&](const Mutant& m) { return ++of_room[m.room()] > request.each; });
  if (request.sample > 0) all.resize(std::min(all.size(), static_cast<std::size_t>(request.sample)));
  return all;
}

std::string commit() {
  FILE* git = popen(("git -C '" + tree.string() + "' rev-parse HEAD").c_str(), "r");
  char text[64] = "";
  if (git && !fgets(text, sizeof text, git)) text[0] = '\0';
  if (git) pclose(git);
  return std::string(text).substr(0, 40);
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

Request request_of(int argc, char** argv) {
  Request request;
  CLI::App app("Whether the suite notices when a formula, a constant or a condition is wrong",
               "oddity_mutate");
  app.add_option("paths", request.paths, "Files and folders of the tree that are mutated")
      ->capture_default_str();
  app.add_option("--in", request.in, "Try those of this file or folder alone, of all that are compiled");
  app.add_option("--sample", request.sample, "As many mutants, drawn at random; without it all")
      ->check(CLI::PositiveNumber);
  app.add_option("--each", request.each, "As many mutants of each room, drawn at random")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", request.seed, "Which sample, by any word; HEAD is the commit's name")
      ->capture_default_str();
  app.add_option("--minutes", request.minutes,
                 "Begin no other mutant after so long; compiling is not counted")
      ->check(CLI::PositiveNumber);
  app.add_option("--program", request.program, "The mutated tree's program, compiled already")
      ->check(CLI::ExistingFile);
  app.add_flag("--again", request.again, "Only the recorded survivors: whether they still survive");
  app.add_flag("--list", request.list, "Write the mutated tree, show its mutants, and end");
  app.add_flag("--record", request.record, "Write scores and survivors to their records");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    std::exit(app.exit(e) == 0 ? 0 : 2);
  }
  if (request.seed == "HEAD") request.seed = commit();
  return request;
}

void list(const std::vector<Mutant>& drawn) {
  for (const Mutant& m : drawn)
    std::cout << m.number << " " << m.file << ":" << m.at << ": " << m.mutation << "\n";
}

/// Tries the drawn mutants that have no outcome yet, several at once. Returns all that have one now: the
/// first of those drawn.
std::vector<Mutant> try_all(const std::vector<Mutant>& drawn, const Request& request, const Suite& suite,
                            Outcomes& outcomes) {
  const auto begin = std::chrono::steady_clock::now();
  const std::chrono::duration<double, std::ratio<60>> box(request.minutes);
  const auto over = [&] { return request.minutes > 0 && std::chrono::steady_clock::now() - begin > box; };
  std::mutex mutex;
  std::size_t next = 0, tried = 0;
  in_parallel(std::thread::hardware_concurrency(), [&](std::size_t) {
    for (std::unique_lock lock(mutex); next < drawn.size();) {
      const Mutant& m = drawn[next];
      if (!outcomes.of(m)) {
        if (over()) return;
        ++next;
        lock.unlock();
        const Judgement judgement = suite.judge(m);
        lock.lock();
        outcomes.add(m, judgement);
      } else {
        ++next;
      }
      const Judgement& judgement = *outcomes.of(m);
      std::cout << ++tried << "/" << drawn.size() << " " << m.number << " " << m.file << ":" << m.at << ": "
                << m.mutation << ": " << name_of(judgement.fate)
                << (judgement.by.empty() ? "" : " by " + judgement.by) << std::endl;
    }
  });
  if (next < drawn.size()) std::cout << "ended after " << request.minutes << " minutes\n";
  return {drawn.begin(), drawn.begin() + static_cast<std::ptrdiff_t>(next)};
}

/// Rows of rooms that this run did not try stay as they are. If only survivors were tried again, the score is
/// updated.
void record(const Request& request, const std::vector<Mutable>& files, const std::vector<Mutant>& all,
            const std::vector<Mutant>& tried, const Outcomes& outcomes, const Survivors& known) {
  const Survivors survivors = updated(known, all, tried, outcomes);
  Scores scores = read_scores(scores_file);
  std::set<std::string> killed;
  for (const Mutant& m : tried)
    if (outcomes.of(m)->fate == Fate::killed) killed.insert(m.id());
  for (auto [room, score] : scores_of(all, tried, outcomes, survivors)) {
    if (request.again) {
      scores[room] = after_again(scores[room], room, known, survivors, killed);
      continue;
    }
    score.date = today();
    score.commit = commit();
    for (const Mutable& file : files)
      if (room_of(file.file) == room) score.free += file.free;
    scores[room] = score;
  }
  write_whole(survivors_file, csv_of(survivors));
  write_whole(scores_file, csv_of(scores));
}

void show_unknown(const std::vector<Mutant>& tried, const Outcomes& outcomes, const Survivors& known) {
  std::vector<Mutant> unknown;
  for (const Mutant& m : tried)
    if (outcomes.of(m)->fate != Fate::killed && !known.contains(m.id())) unknown.push_back(m);
  if (unknown.empty()) return;
  std::cout
      << "\nThese survive and are not in extras/mutation/survivors.csv. Mend the tests that should have "
         "failed, or record these mutants by --record, each with its reason:\n";
  for (const Mutant& m : unknown) std::cout << m.id() << " " << m.name() << "\n";
}

int mutate(const Request& request) {
  std::string paths;
  for (const std::string& path : request.paths) paths += path + "\n";
  std::vector<Mutable> files = mutable_files(
      tree, built, [&](const std::string& file) { return wanted(request, file); },
      home / "points" / (std::to_string(number_of(paths)) + ".json"));
  number_files(files, home / "numbers");
  const std::vector<Mutant> all = mutants_of(files);
  if (all.empty()) throw BadInput("nothing can be mutated in these files");
  const bool changed = write_schemata(tree, files, home / "tree");
  const Survivors known = read_survivors(survivors_file);
  std::vector<Mutant> candidates = in_order(all, request, known);
  if (request.list) {
    list(drawn_of(std::move(candidates), request));
    return 0;
  }
  const fs::path program = request.program.empty()
                               ? compiled_program({home / "tree", home / "build", built}, all)
                               : fs::path(request.program);
  // Earlier findings hold only for the sources and tests of their time.
  const auto stale = [&](const fs::path& found) {
    return changed || (fs::exists(found) && fs::last_write_time(found) < fs::last_write_time(program));
  };
  if (stale(home / "reached")) fs::remove_all(home / "reached");
  Suite suite(program, home / "reached",
              static_cast<std::size_t>(std::ranges::max(all, {}, &Mutant::number).number));
  Outcomes outcomes(home / "outcomes.csv", stale(home / "outcomes.csv"));
  suite.measure(candidates);
  std::erase_if(candidates, [&](const Mutant& m) { return suite.is_absent(m); });
  const std::vector<Mutant> drawn = drawn_of(std::move(candidates), request);
  const std::vector<Mutant> tried = try_all(drawn, request, suite, outcomes);
  const Scores scores = scores_of(all, tried, outcomes, known);
  const std::vector<std::string> less =
      request.again ? std::vector<std::string>() : noticed_less(scores, read_scores(scores_file));
  std::cout << "\n" << text_of(scores);
  if (request.record) record(request, files, all, tried, outcomes, known);
  show_unknown(tried, outcomes, known);
  for (const std::string& room : less)
    std::cout << room << ": the suite kills a smaller share than recorded in reference/trust/mutation.csv\n";
  return less.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  tidy_when_interrupted();
  try {
    return mutate(request_of(argc, argv));
  } catch (const BadInput& error) {
    std::cerr << "oddity_mutate: " << error.what() << "\n";
    return 2;
  }
}
