// The words of a command line: an exercise, its parameters, a tolerance, a share. The first line is the
// exercise, or @ and a letter for its place. The first letter of each further line selects its kind.
#include <sstream>

#include "extras/fuzz/fuzz.hpp"
#include "report/cli/asked.hpp"

namespace {

struct Words {
  std::string exercise = {}, chapter = {}, shard = {};
  std::vector<std::string> overrides = {}, titles = {};
  oddity::AskedNeed need = {};
};

const oddity::Entry& entry_at(std::size_t place) {
  return oddity::registry()[place % oddity::registry().size()];
}

Words words_in(std::string_view input) {
  Words all;
  std::istringstream lines{std::string(input)};
  std::getline(lines, all.exercise);
  if (all.exercise.size() == 2 && all.exercise[0] == '@')
    all.exercise = to_string(entry_at(static_cast<unsigned char>(all.exercise[1])).number);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    const std::string word = line.substr(1);
    switch (line.front()) {
      case 'p':
        all.overrides.push_back(word);
        break;
      case 'e':
        all.need.error = word;
        break;
      case 'd':
        all.need.digits = word;
        break;
      case 'h':
        all.need.horizon = word;
        break;
      case 'f':
        all.need.frames_per_second = word;
        break;
      case 'b':
        all.need.budget = word;
        break;
      case 'n':
        all.need.bodies = word;
        break;
      case 'j':
        all.need.jitter = word;
        break;
      case 'D':
        all.need.drop = word;
        break;
      case 'l':
        all.need.longest_frame = word;
        break;
      case 'S':
        all.need.frame_seed = word;
        break;
      case 'c':
        all.need.criterion = word;
        break;
      case 't':
        all.need.time_limit = word;
        break;
      case 'o':
        all.need.only.push_back(word);
        break;
      case 'x':
        all.need.exclude.push_back(word);
        break;
      case 'P':
        all.need.precision = word;
        break;
      case 's':
        all.shard = word;
        break;
      case 'C':
        all.chapter = word;
        break;
      default:
        all.titles.push_back(line);
    }
  }
  return all;
}

}  // namespace

void fuzz::read(std::string_view input) {
  const Words words = words_in(input);
  if (!words.shard.empty()) refused_or_read([&] { oddity::shard_of(words.shard); });
  if (!words.chapter.empty()) refused_or_read([&] { oddity::chapter_of(words.chapter); });
  if (!words.titles.empty()) refused_or_read([&] { oddity::tasks_about(words.titles); });
  const oddity::Task task = oddity::task_of(words.exercise, words.overrides);
  if (!words.need.error.empty() || !words.need.digits.empty()) oddity::need_of(task, words.need);
}
