#pragma once

#include <string>

#include "chapters/contents.hpp"
#include "problem/formula.hpp"
#include "reference/verdicts.hpp"

/// A problem's file as an exercise with a scene, which the rest of the program takes like one of its own.
namespace oddity::problem {

/// Whether this word of the command line names a file, and no exercise: "suspension.toml", or "-" for
/// standard input.
bool is_file(const std::string& word);

/// What the file asks; it stays as long as the program runs. Throws BadInput, or WrongFile.
const Entry& entry_of_file(const std::string& path);
/// The same of a text, whose name errors have; once for each text.
const Entry& entry_of_text(const std::string& name, const std::string& text);
/// What it was read from.
const Source& source_of(const Entry& entry);

/// The verdicts that a file's claims have where all is as the file says.
const Verdicts& stated_by(const Entry& entry);

/// What `choose` is asked where the command line does not say.
struct Asked {
  std::string error, horizon, frames_per_second;
  std::string error_says = {}, horizon_says = {};  ///< why, where the file asks nothing
};
Asked asked_by(const Entry& entry);

}  // namespace oddity::problem
