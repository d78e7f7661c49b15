#pragma once

#include <cstdint>
#include <filesystem>
#include <map>

#include "extras/mutation/points.hpp"

namespace oddity::mutation {

/// Points read by earlier runs. A unit is read again only if it, a file of the tree that it includes, or this
/// program has changed.
class KeptPoints {
 public:
  struct Unit {
    std::uint64_t text = 0;                         ///< a hash of it
    std::map<std::string, std::uint64_t> included;  ///< the tree's files that it includes
    std::vector<Mutable> shown;                     ///< not shown by any unit before
  };

  /// Kept in this file, which may be missing.
  explicit KeptPoints(std::filesystem::path file);

  /// The unit, if it and its includes have not changed.
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
