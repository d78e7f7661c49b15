#include "reference/similar.hpp"

#include <algorithm>
#include <cctype>

namespace oddity {

int typing_errors(std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  std::vector<int> all((a.size() + 1) * (b.size() + 1));
  const auto errors = [&](std::size_t i, std::size_t j) -> int& { return all[i * (b.size() + 1) + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      int& e = errors(i, j);
      if (i == 0 || j == 0) {
        e = static_cast<int>(i + j);
        continue;
      }
      e = std::min({errors(i - 1, j) + 1, errors(i, j - 1) + 1,
                    errors(i - 1, j - 1) + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
      if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
        e = std::min(e, errors(i - 2, j - 2) + 1);
    }
  return errors(a.size(), b.size());
}

bool nearly_same(std::string_view a, std::string_view b, int most) {
  const std::size_t longer = std::max(a.size(), b.size()), shorter = std::min(a.size(), b.size());
  return static_cast<int>(longer - shorter) <= most && typing_errors(a, b) <= most;
}

std::vector<std::string> similar(std::string_view word, std::span<const std::string> candidates) {
  int fewest = static_cast<int>(word.size() + 1) / 3;
  std::vector<std::string> found;
  for (const std::string& candidate : candidates) {
    if (!nearly_same(word, candidate, fewest)) continue;
    const int errors = typing_errors(word, candidate);
    if (errors < fewest) found.clear();
    found.push_back(candidate);
    fewest = errors;
  }
  return found;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  std::string names;
  for (const std::string& name : similar(word, candidates))
    names += (names.empty() ? "'" : " or '") + name + "'";
  return names.empty() ? "" : "; did you mean " + names + "?";
}

}  // namespace oddity
