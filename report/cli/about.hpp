#pragma once

#include <string>
#include <vector>

#include "chapters/contents.hpp"

/// Exercises by what people call what they are about.
namespace oddity {

/// Those that have all of the text's words, or words that begin so, in their titles, in what else they are
/// called, in their parameters and models, or in what they ask: in this order. Where none has all, those that
/// have any; where none has any, those with words that differ by a typing error or two.
std::vector<const Entry*> exercises_about(const std::string& text);

/// The word most like one of the text's, of those that exercises are known by: "; did you mean 'pendulum'?",
/// or nothing.
std::string near_words(const std::string& text);

/// Whether the name has a word that begins as one of the text's.
bool is_about(const std::string& name, const std::string& text);

}  // namespace oddity
