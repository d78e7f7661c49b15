#pragma once

#include <set>
#include <string>
#include <string_view>

#include "report/pages/program.hpp"
#include "report/study/recorded_model.hpp"

/// Texts of short programs apart from the model, in the dialect of dialects.hpp.
namespace oddity::program_parts {

/// The step of an algorithm, with the functions that it calls; empty for a closed form. Throws BadInput if
/// the model has no such step.
std::string algorithm_text(const std::string& name, const RecordedModel&);

/// A main function in its language, and its parts for stepped motions and for closed forms.
struct Main {
  std::string_view text, start, stepped, at;
};
const Main& main_of(Language);

/// Functions that the code calls and the language's library lacks.
std::string helpers_for(Language, const std::string& code);

/// Names that a program must not give to parameters and constants: of the languages, of C's headers, and of
/// these texts.
const std::set<std::string>& reserved_names();

}  // namespace oddity::program_parts
