#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "extras/faults/process.hpp"

/// Files that the program writes, command by command.
namespace faults {

struct Verb {
  std::string name;
  std::vector<std::string> words;  ///< {} is the folder
  /// Its files contain times, so that no two runs write the same.
  bool timed = false;
  /// It keeps files that it can make again. If it cannot, nothing is lost.
  bool keeps = false;
  /// It refuses to replace its complete results.
  bool once = false;
  std::string program = "oddity";
  std::function<void(const std::filesystem::path&)> prepare = {};
};

/// An installed program, which keeps its results in a folder's cache.
class Installed {
 public:
  explicit Installed(std::filesystem::path root);

  Command command(const Verb&, const std::filesystem::path& folder) const;
  /// Runs the program with only these words.
  Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder) const;
  std::filesystem::path tables() const { return root_ / "share/oddity/reference"; }
  /// Puts the results of a whole run into the folder's cache. Makes them if the tree has no fresh ones.
  void put_results(const std::filesystem::path& folder) const;

 private:
  std::filesystem::path root_;
};

std::vector<Verb> verbs(const Installed&);

/// The texts of the folder's files by their relative paths.
using Files = std::map<std::string, std::string>;
Files files_in(const std::filesystem::path& folder);

}  // namespace faults
