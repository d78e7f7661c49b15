#pragma once

#include <string>

#include "chapters/contents.hpp"
#include "problem/formula.hpp"
#include "reference/verdicts.hpp"

/// A problem's file as an exercise with a scene, for the rest of the program.
namespace oddity::problem {

/// Whether this word of the command line names a file and not an exercise: "suspension.toml", or "-" for
/// standard input.
bool is_file(const std::string& word);

/// "suspension" of "cars/suspension.toml": a name for files about it. "input" for "-" and "...toml".
std::string stem_of(const std::string& path);

/// The exercise of a file, for the rest of the program's life. Throws BadInput, or WrongFile.
const Entry& entry_of_file(const std::string& path);
/// The exercise of a text, with its name for error messages; made once for each text.
const Entry& entry_of_text(const std::string& name, const std::string& text);
/// The text that it was read from.
const Source& source_of(const Entry& entry);

/// The verdicts that the file expects of its claims.
const Verdicts& stated_by(const Entry& entry);

/// Defaults for `choose` where the command line gives none.
struct Asked {
  std::string error, horizon, frames_per_second;
  std::string error_reason = {}, horizon_reason = {};  ///< the reason, if the file does not give them
};
Asked asked_by(const Entry& entry);

}  // namespace oddity::problem
