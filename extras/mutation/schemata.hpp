#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "extras/mutation/points.hpp"

namespace oddity::mutation {

/// One mutant. Its name does not change when other lines do: file, function, text of the line, mutation, and
/// its index among equal ones.
struct Mutant {
  int number = 0;  ///< in the tree of this run
  std::string file, function, line, mutation;
  int occurrence = 1;
  int at = 0;                 ///< number of its line
  bool in_near_miss = false;  ///< in a formula that has to be wrong

  std::string name() const;
  std::string change() const;  ///< its name without the file
  std::string id() const;      ///< a hash of its name, as in the records
  std::string room() const;    ///< the room of its file
};

/// A file's folder, two levels deep at most.
std::string room_of(const std::string& file);

/// A hash of a text, the same on every machine (FNV-1a).
std::uint64_t number_of(const std::string& text);

/// Numbers the mutants of the files. A file that an earlier run has numbered keeps its numbers as long as
/// they suffice. So a change of one file, or more files, does not change the others' numbers, and these need
/// not be compiled again. `kept` is the file that stores them.
void number_files(std::vector<Mutable>& files, const std::filesystem::path& kept);

/// All mutants of the files, in their order.
std::vector<Mutant> mutants_of(const std::vector<Mutable>& files);

/// A file's text with all of its mutants.
std::string schema(const Mutable& file);

/// Writes a copy of the tree in which the files have their mutants. Files that are equal already are not
/// touched, so that little is compiled again. Returns whether any file was written that the results depend
/// on.
bool write_schemata(const std::filesystem::path& tree, const std::vector<Mutable>& files,
                    const std::filesystem::path& copy);

}  // namespace oddity::mutation
