#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "formula/parse.hpp"

namespace oddity::formula {

class Vocabulary;

/// Reads many texts in the same letters, by parse_plain(). Prepares the letters' names once.
class PlainReader {
 public:
  explicit PlainReader(const Names&);
  std::size_t letters() const;  ///< number of letters
  Tree operator()(std::string_view text) const;

 private:
  std::shared_ptr<const Vocabulary> letters_;
};

}  // namespace oddity::formula
