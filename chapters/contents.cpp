#include "chapters/contents.hpp"

#include <array>
#include <charconv>

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

std::span<const Chapter> chapters() {
  static constexpr std::array<Chapter, 14> all{{
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
  return all;
}

}  // namespace oddity
