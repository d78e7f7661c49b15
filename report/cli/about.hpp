#pragma once

#include <string>
#include <vector>

#include "chapters/contents.hpp"

/// Finds exercises by topic.
namespace oddity {

/// Exercises with all of the text's words, or words that begin so. Searches titles, other names, parameters
/// and models, and questions, in this order. If none has all words, returns those with any; if none has any,
/// those with words that differ by a typing error or two.
std::vector<const Entry*> exercises_about(const std::string& text);

/// The known search word most like one of the text's: "; did you mean 'pendulum'?"; empty if no word is
/// similar.
std::string near_words(const std::string& text);

/// Whether a word of the name begins like one of the text's.
bool is_about(const std::string& name, const std::string& text);

}  // namespace oddity
