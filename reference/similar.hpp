#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace oddity {

/// Number of letters to add, drop, change or swap with their neighbours to turn one word into the other,
/// ignoring case (the optimal string alignment distance).
int typing_errors(std::string_view a, std::string_view b);

/// Whether the words differ by at most this many typing errors.
bool nearly_same(std::string_view a, std::string_view b, int most);

/// The candidates that were most likely meant by `word`, if any: with the fewest typing errors, at most one
/// for each three letters.
std::vector<std::string> similar(std::string_view word, std::span<const std::string> candidates);

/// "; did you mean 'solve'?", or empty.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace oddity
