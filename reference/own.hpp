#pragma once

#include <filesystem>
#include <string_view>

namespace oddity {

/// The folder of tables and records of an exercise from outside the tree, given the full path of its file:
/// the folder `reference` next to `chapters`. Empty for a path within the tree.
inline std::filesystem::path own_reference_folder(std::string_view exercise_file) {
  const std::filesystem::path file(exercise_file);
  if (!file.is_absolute()) return {};
  return file.parent_path().parent_path().parent_path().parent_path() / "reference";
}

}  // namespace oddity
