#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "extras/faults/process.hpp"

/// What the program writes, verb by verb.
namespace faults {

struct Verb {
  std::string name;
  std::vector<std::string> words;  ///< in which {} is the folder
  /// Times stand in its files, so that no two runs write the same.
  bool timed = false;
  /// It keeps what it can make again, and where it cannot, nothing is lost.
  bool keeps = false;
  /// What it has made whole it refuses to make again.
  bool once = false;
  std::string program = "oddity";
  std::function<void(const std::filesystem::path&)> prepare = {};
};

/// A program as it is installed, which keeps its results in a folder's cache.
class Installed {
 public:
  explicit Installed(std::filesystem::path root);

  Command command(const Verb&, const std::filesystem::path& folder) const;
  /// The program alone with these words.
  Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder) const;
  std::filesystem::path tables() const { return root_ / "share/oddity/reference"; }
  /// Puts the results of a whole run into the folder's cache; makes them where the tree has none that are
  /// fresh.
  void put_results(const std::filesystem::path& folder) const;

 private:
  std::filesystem::path root_;
};

std::vector<Verb> verbs(const Installed&);

/// The texts of the folder's files by their paths within.
using Files = std::map<std::string, std::string>;
Files files_in(const std::filesystem::path& folder);

}  // namespace faults
