#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/pages/code.hpp"
#include "report/study/embedded.hpp"

/// An exercise of one's own, begun.
namespace oddity {

/// What `oddity new` is asked for, as it is written.
struct NewExercise {
  std::string number, slug;
  std::string topic = {};         ///< of the chapter's folder; empty: as the book has it
  std::filesystem::path in = {};  ///< a folder outside the tree; empty: the tree
  bool scene = true;              ///< else an identity
};

/// A file to write: its path within the folder, and its text.
struct NewFile {
  std::filesystem::path path;
  std::string text;
};

/// The files of report/new, from which the new ones are made.
std::span<const EmbeddedFile> embedded_templates();

/// The book's scenes as problems' files, each with its path in the tree.
std::span<const EmbeddedFile> embedded_scenes();
/// That of an exercise. Throws BadInput, with those that there are, where it has none.
std::string_view scene_as_file(const std::string& exercise);

/// What would be written. Throws BadInput when the number or a name is none, or the exercise is there
/// already.
std::vector<NewFile> new_files(const NewExercise&);

}  // namespace oddity
