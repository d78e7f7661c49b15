#pragma once

#include <cstdint>
#include <filesystem>
#include <map>

#include "extras/mutation/points.hpp"

namespace oddity::mutation {

/// What runs before have read, so that a unit is read again only when it has changed, or a file of the tree
/// that it includes, or this program.
class KeptPoints {
 public:
  struct Unit {
    std::uint64_t text = 0;                         ///< a number of it
    std::map<std::string, std::uint64_t> included;  ///< the tree's files that it is made of
    std::vector<Mutable> shown;                     ///< what no unit before has shown
  };

  /// Of this file, which need not be there.
  explicit KeptPoints(std::filesystem::path file);

  /// The unit, if that and what it includes is as it was.
  const Unit* of(const std::string& unit, const std::string& text);
  void add(const std::string& unit, const std::string& text, const std::vector<std::string>& included,
           std::vector<Mutable> shown);
  void write() const;

 private:
  std::uint64_t now(const std::string& file);

  std::filesystem::path file_;
  std::map<std::string, Unit> units_;
  std::map<std::string, std::uint64_t> now_;
};

}  // namespace oddity::mutation
