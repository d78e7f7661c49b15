#include "reference/similar.hpp"

#include <algorithm>

namespace oddity {

namespace {

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Like typing_errors, but most + 1 if there are more.
std::size_t errors_up_to(std::size_t most, std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) { return small(x) == small(y); };
  // errors(i, j): between the first i letters of a and the first j of b. Keeps the last three rows, for i and
  // j that differ by at most `most`.
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> rows(3 * columns, most + 1);
  const auto errors = [&](std::size_t i, std::size_t j) -> std::size_t& { return rows[i % 3 * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) {
    const std::size_t first = i > most ? i - most : 0;
    if (first > 0) errors(i, first - 1) = most + 1;
    for (std::size_t j = first; j <= std::min(b.size(), i + most); ++j) {
      std::size_t& e = errors(i, j);
      if (i == 0 || j == 0) {
        e = i + j;
        continue;
      }
      e = std::min({errors(i - 1, j) + 1, errors(i, j - 1) + 1,
                    errors(i - 1, j - 1) + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
      if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
        e = std::min(e, errors(i - 2, j - 2) + 1);
    }
  }
  return std::min(errors(a.size(), b.size()), most + 1);
}

}  // namespace

int typing_errors(std::string_view a, std::string_view b) {
  return static_cast<int>(errors_up_to(std::max(a.size(), b.size()), a, b));
}

bool nearly_same(std::string_view a, std::string_view b, int most) {
  const auto allowed = static_cast<std::size_t>(most);
  const std::size_t longer = std::max(a.size(), b.size()), shorter = std::min(a.size(), b.size());
  return longer - shorter <= allowed && errors_up_to(allowed, a, b) <= allowed;
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
