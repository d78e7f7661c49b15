#include "chapters/contents.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

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

constexpr std::array<Chapter, 14> book{{
    {1, "Introduction", 0},
    {2, "Basic concepts from physics", 17},
    {3, "Rigid body motion", 35},
    {4, "Deformable bodies", 0},
    {5, "Fluids and gases", 15},
    {6, "Physics engines", 5},
    {7, "Linear algebra", 11},
    {8, "Affine algebra", 5},
    {9, "Calculus", 1},
    {10, "Quaternions", 0},
    {11, "Differential equations", 0},
    {12, "Ordinary difference equations", 0},
    {13, "Numerical methods", 0},
    {14, "Linear complementarity and mathematical programming", 0},
}};

std::vector<Chapter> with_own_chapters() {
  std::vector<Chapter> all(book.begin(), book.end());
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

bool of_the_book(Number n) {
  return std::ranges::any_of(book, [&](const Chapter& c) {
    return c.number == n.chapter && n.index % 2 == 1 && n.index <= c.last_odd;
  });
}

}  // namespace oddity
