#include "chapters/contents.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <mutex>
#include <vector>

#include "chapters/asked_file.hpp"
#include "reference/book.hpp"
#include "reference/quantity_text.hpp"

namespace oddity {

namespace {

/// Names of the problems' files, in place of exercise numbers.
struct Names {
  std::mutex mutex;
  std::deque<std::string> all;
};
Names& names() {
  static Names kept;
  return kept;
}

}  // namespace

Number number_of_file(std::string name) {
  const std::lock_guard lock(names().mutex);
  names().all.push_back(std::move(name));
  return {0, static_cast<int>(names().all.size())};
}

std::string to_string(Number n) {
  if (n.chapter == 0 && n.index > 0) {
    const std::lock_guard lock(names().mutex);
    if (static_cast<std::size_t>(n.index) <= names().all.size())
      return names().all[static_cast<std::size_t>(n.index) - 1];
  }
  return std::to_string(n.chapter) + "." + std::to_string(n.index);
}

std::optional<Number> exercise_number(std::string_view text) {
  const auto dot = text.find('.');
  if (dot == text.npos) return std::nullopt;
  const auto chapter = parse_count(text.substr(0, dot)), index = parse_count(text.substr(dot + 1));
  return chapter && index ? std::optional(Number{*chapter, *index}) : std::nullopt;
}

namespace {

constexpr std::array<std::string_view, last_odd_exercises.size()> titles{
    "Introduction",
    "Basic concepts from physics",
    "Rigid body motion",
    "Deformable bodies",
    "Fluids and gases",
    "Physics engines",
    "Linear algebra",
    "Affine algebra",
    "Calculus",
    "Quaternions",
    "Differential equations",
    "Ordinary difference equations",
    "Numerical methods",
    "Linear complementarity and mathematical programming",
};

std::vector<Chapter> with_own_chapters() {
  std::vector<Chapter> all;
  for (std::size_t i = 0; i < titles.size(); ++i)
    all.push_back({static_cast<int>(i) + 1, titles[i], last_odd_exercises[i]});
  for (const Entry& e : registry())
    if (std::ranges::find(all, e.number.chapter, &Chapter::number) == all.end())
      all.push_back({e.number.chapter, "Exercises of one's own", 0});
  std::ranges::sort(all, {}, &Chapter::number);
  return all;
}

}  // namespace

std::span<const Chapter> chapters() {
  static const std::vector<Chapter> all = with_own_chapters();
  return all;
}

bool of_the_book(Number n) { return is_published(n.chapter, n.index); }

}  // namespace oddity
