#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace oddity {

/// How many letters have to be added, left out, changed or swapped with their neighbours to make one word of
/// the other; capitals count as their small letters (the optimal string alignment distance).
int typing_errors(std::string_view a, std::string_view b);

/// Whether there are no more than so many of these.
bool nearly_same(std::string_view a, std::string_view b, int most);

/// The candidates that someone who wrote `word` is most likely to have meant, if any: with the fewest typing
/// errors, at most one for each three letters.
std::vector<std::string> similar(std::string_view word, std::span<const std::string> candidates);

/// "; did you mean 'solve'?", or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace oddity
