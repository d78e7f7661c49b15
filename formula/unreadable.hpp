#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace oddity::formula {

/// A text that is not a formula in the given letters. Its message is the text with a caret under the place.
class Unreadable : public std::invalid_argument {
 public:
  Unreadable(std::string_view text, std::size_t place, std::string reason);

  std::size_t place() const { return place_; }  ///< byte offset
  const std::string& reason() const { return reason_; }

 private:
  std::size_t place_;
  std::string reason_;
};

/// A formula without a value: shapes that do not fit, or a number type that lacks a function.
class NoValue : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

}  // namespace oddity::formula
