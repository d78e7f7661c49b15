#include "chapters/contents.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "reference/book.hpp"

namespace oddity {

std::string to_string(Number n) { return std::to_string(n.chapter) + "." + std::to_string(n.index); }

std::optional<Number> exercise_number(std::string_view text) {
  Number n;
  const char* end = text.data() + text.size();
  const auto [dot, error] = std::from_chars(text.data(), end, n.chapter);
  if (error != std::errc{} || dot == end || *dot != '.') return std::nullopt;
  const auto [stop, wrong] = std::from_chars(dot + 1, end, n.index);
  if (wrong != std::errc{} || stop != end) return std::nullopt;
  return n;
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
