#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "extras/mutation/points.hpp"

namespace oddity::mutation {

/// One mutant. What it is called by stays as it is when other lines change: file, function, text of the line,
/// mutation, and which of those alike it is.
struct Mutant {
  int number = 0;  ///< in the tree of this run
  std::string file, function, line, mutation;
  int occurrence = 1;
  int at = 0;                 ///< its line's number
  bool in_near_miss = false;  ///< of a formula that has to be wrong

  std::string name() const;
  std::string change() const;  ///< its name within the file
  std::string id() const;      ///< a number of its name, as records have it
  std::string room() const;    ///< that of its file
};

/// A file's folder, two levels deep at most.
std::string room_of(const std::string& file);

/// A number of a text, the same on every machine (FNV-1a).
std::uint64_t number_of(const std::string& text);

/// Numbers the mutants of the files. A file that the run before has numbered keeps its numbers as long as
/// they suffice, so that a change in one, or more files, leave others as they are: they need not be compiled
/// again. `kept` is the file that holds them from run to run.
void number_files(std::vector<Mutable>& files, const std::filesystem::path& kept);

/// All mutants of the files, in their order.
std::vector<Mutant> mutants_of(const std::vector<Mutable>& files);

/// A file's text with all of its mutants in it.
std::string schema(const Mutable& file);

/// Writes a copy of the tree in which the files have their mutants. What is there already and is the same is
/// not touched, so that little is compiled again. Whether anything was that the suite computes with.
bool write_schemata(const std::filesystem::path& tree, const std::vector<Mutable>& files,
                    const std::filesystem::path& copy);

}  // namespace oddity::mutation
