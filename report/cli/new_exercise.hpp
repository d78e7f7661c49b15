#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/pages/code.hpp"
#include "report/study/embedded.hpp"

/// Starts a user's exercise.
namespace oddity {

/// Arguments of `oddity new`, as written.
struct NewExercise {
  std::string number, slug;
  std::string topic = {};         ///< name of the chapter's folder; empty: as in the book
  std::filesystem::path in = {};  ///< a folder outside the tree; empty: the tree
  bool scene = true;              ///< otherwise an identity
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
/// The scene of an exercise. Throws BadInput with a list of the available ones if it has none.
std::string_view scene_as_file(const std::string& exercise);

/// The files to write. Throws BadInput when the number or a name is invalid, or the exercise exists already.
std::vector<NewFile> new_files(const NewExercise&);

}  // namespace oddity
