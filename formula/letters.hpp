#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "formula/tokens.hpp"
#include "formula/tree.hpp"

namespace oddity::formula {

/// An index that may replace digits in a name: i, j_2, or \sigma(1).
struct Index {
  std::vector<std::string> tokens;
  std::size_t slot = 0;
};

/// The letters known to a parser, by their tokens.
class Vocabulary {
 public:
  Vocabulary(const std::vector<std::string>& names, bool plain);

  struct Found {
    std::size_t length = 0;  ///< in tokens
    std::vector<std::size_t> slots = {};
    std::vector<Entry> entries = {};
  };
  /// The longest letter that begins there and is not part of a longer one: R does not match the start of R_1.
  std::optional<Found> at(const Tokens&, std::size_t begin, const std::vector<Index>&) const;
  bool has(const std::vector<std::string>& tokens) const;
  /// A letter's original name.
  const std::string& name(int i) const { return names_[static_cast<std::size_t>(i)]; }

  std::size_t size() const { return names_.size(); }
  /// In plain text, the length of the longest name at the beginning of the text that is not followed by more
  /// of a name.
  std::size_t length_of_name(std::string_view text) const;

  /// Names that were possibly meant, nearest first, at most three.
  std::vector<std::string> similar_to(const std::string& name) const;

 private:
  struct Letter {
    std::string name;
    std::vector<std::string> tokens;
    Entry entry;
  };
  std::vector<std::string> names_;
  std::vector<Letter> letters_;
  std::unordered_map<std::string, std::vector<std::size_t>> by_first_token_;
};

}  // namespace oddity::formula
