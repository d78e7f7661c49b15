#include "report/cli/new_exercise.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/cli/words.hpp"
#include "report/study/embedded.hpp"
#include "report/study/settings.hpp"

namespace oddity {

namespace {

namespace fs = std::filesystem;

std::string two_digits(int n) { return (n < 10 ? "0" : "") + std::to_string(n); }

Number number_of(const std::string& text) {
  const auto number = exercise_number(text);
  const auto in_range = [](int n) { return 1 <= n && n <= 99; };
  if (!number || !in_range(number->chapter) || !in_range(number->index))
    throw BadInput("'" + text + "' is no number of an exercise: that is N.M, such as 3.2, each from 1 to 99");
  return *number;
}

bool is_letter(char c) { return 'a' <= c && c <= 'z'; }
bool is_of_names(char c) { return is_letter(c) || ('0' <= c && c <= '9') || c == '_'; }

/// The nearest valid name: "Spring pendulum" gives "spring_pendulum".
std::string as_name(std::string_view text) {
  std::string name;
  for (char c : text) {
    const char small = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (is_of_names(small))
      name += small;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  name.erase(0, std::min(name.size(), name.find_first_not_of("0123456789_")));
  while (name.ends_with('_')) name.pop_back();
  return name;
}

void require_name(const std::string& what, const std::string& text) {
  if (!text.empty() && is_letter(text.front()) && std::ranges::all_of(text, is_of_names)) return;
  const std::string name = as_name(text);
  throw BadInput(what + " '" + text +
                 "' is no name of a folder: small letters, digits and _, a letter first" +
                 (name.empty() ? "" : "; did you mean '" + name + "'?"));
}

/// The subfolder whose name begins with the two digits and _; empty if no folder does.
std::string folder_of(const fs::path& folder, int number) {
  if (!fs::is_directory(folder)) return "";
  for (const auto& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string();
        entry.is_directory() && name.starts_with(two_digits(number) + "_"))
      return name;
  return "";
}

/// "03_rigid_body_motion".
std::string chapter_folder(const NewExercise& asked, Number number, const fs::path& home) {
  std::string there;
  for (const fs::path& tree : {home, source_folder()})
    if (there.empty() && !tree.empty()) there = folder_of(tree / "chapters", number.chapter);
  if (!asked.topic.empty()) require_name("topic", asked.topic);
  const std::string wanted = two_digits(number.chapter) + "_" + asked.topic;
  if (there.empty() && !asked.topic.empty()) return wanted;
  if (!there.empty() && !asked.topic.empty() && there != wanted)
    throw BadInput("chapter " + std::to_string(number.chapter) + " is in chapters/" + there +
                   ": --topic is for a chapter that has no folder");
  if (!there.empty()) return there;
  const auto known = std::ranges::find(chapters(), number.chapter, &Chapter::number);
  return wanted + (known == chapters().end() ? "own" : as_name(known->title));
}

/// "3.2, 3.4, 3.6".
std::string some_free(int chapter) {
  std::string free;
  for (int index = 1, count = 0; index <= 99 && count < 3; ++index) {
    const Number number{chapter, index};
    if (of_the_book(number) || std::ranges::find(registry(), number, &Entry::number) != registry().end())
      continue;
    free += (count++ == 0 ? "" : ", ") + to_string(number);
  }
  return free;
}

[[noreturn]] void refuse(Number number, const std::string& what) {
  throw BadInput("exercise " + to_string(number) + " is there already: " + what +
                 "; nothing was written. Free are " + some_free(number.chapter) + " and more");
}

/// Whether an interrupted run of `new` left these files: the last ones are missing, and the others are as it
/// writes them.
bool left_unfinished(const std::vector<NewFile>& files) {
  const auto is_there = [](const NewFile& file) { return fs::exists(file.path); };
  const auto missing = std::ranges::find_if_not(files, is_there);
  return missing != files.end() && std::none_of(missing, files.end(), is_there) &&
         std::all_of(files.begin(), missing,
                     [](const NewFile& file) { return read_whole(file.path) == file.text; });
}

/// Replaces each pattern in the text by its word; the first pattern that matches counts.
std::string with_words(std::string_view text,
                       std::span<const std::pair<std::string_view, std::string>> words) {
  std::string made;
  while (!text.empty()) {
    const auto fits = std::ranges::find_if(words, [&](const auto& w) { return text.starts_with(w.first); });
    made += fits == words.end() ? std::string(text.substr(0, 1)) : fits->second;
    text.remove_prefix(fits == words.end() ? 1 : fits->first.size());
  }
  return made;
}

/// "Spring pendulum" for spring_pendulum.
std::string title_of(std::string slug) {
  std::ranges::replace(slug, '_', ' ');
  slug.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(slug.front())));
  return slug;
}

}  // namespace

std::vector<NewFile> new_files(const NewExercise& asked) {
  const Number number = number_of(asked.number);
  require_name("slug", asked.slug);
  const fs::path home = asked.in.empty() ? source_folder() : asked.in;
  if (home.empty())
    throw BadInput("an installed program has no tree to begin an exercise in: name a folder by --in");
  if (const auto found = std::ranges::find(registry(), number, &Entry::number); found != registry().end())
    refuse(number, std::string(found->exercise.title) + ", " + std::string(found->file));
  const std::string chapter = chapter_folder(asked, number, home),
                    there = folder_of(home / "chapters" / chapter, number.index);
  const std::string nn = two_digits(number.chapter), mm = two_digits(number.index);
  const std::string short_number = std::to_string(number.chapter) + "_" + std::to_string(number.index);
  using Words = std::vector<std::pair<std::string_view, std::string>>;
  const Words words = asked.scene ? Words{{"exercise_99_98", "exercise_" + short_number},
                                          {"99_98", nn + "_" + mm},
                                          {"99.98", to_string(number)},
                                          {"99_my_topic", chapter},
                                          {"98_my_scene", mm + "_" + asked.slug},
                                          {"my_scene", asked.slug},
                                          {"My scene", title_of(asked.slug)}}
                                  : Words{{"exercise_99_97", "exercise_" + short_number},
                                          {"99_97", nn + "_" + mm},
                                          {"99.97", to_string(number)},
                                          {"99_my_topic", chapter},
                                          {"97_my_identity", mm + "_" + asked.slug},
                                          {"My identity", title_of(asked.slug)}};
  std::vector<NewFile> files;
  for (const EmbeddedFile& file : embedded_templates()) {
    if ((file.path.find("my_scene") != std::string_view::npos) != asked.scene) continue;
    files.push_back({home / with_words(file.path, words), with_words(file.text, words)});
  }
  const bool unfinished = left_unfinished(files);
  if (!there.empty() && !(unfinished && there == mm + "_" + asked.slug))
    refuse(number, (home / "chapters" / chapter / there).string());
  for (const NewFile& file : files)
    if (!unfinished && fs::exists(file.path)) refuse(number, file.path.string());
  return files;
}

std::string_view scene_as_file(const std::string& exercise) {
  const Number number = number_of(exercise);
  std::vector<std::string> there;
  for (const Entry& entry : registry()) {
    const std::string chapter = "chapters/" + two_digits(entry.number.chapter) + "_",
                      folder = "/" + two_digits(entry.number.index) + "_";
    for (const EmbeddedFile& file : embedded_scenes()) {
      if (!file.path.starts_with(chapter) || file.path.find(folder, chapter.size()) == std::string_view::npos)
        continue;
      if (entry.number == number) return file.text;
      there.push_back(to_string(entry.number));
    }
  }
  throw BadInput("there is no file of exercise " + to_string(number) + "; there is one of: " + joined(there));
}

}  // namespace oddity
