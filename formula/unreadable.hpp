#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace oddity::formula {

/// A text that is no formula of the letters given. what() shows the text and, by a caret, the place.
class Unreadable : public std::invalid_argument {
 public:
  Unreadable(std::string_view text, std::size_t place, std::string reason);

  std::size_t place() const { return place_; }  ///< in bytes from the beginning
  const std::string& reason() const { return reason_; }

 private:
  std::size_t place_;
  std::string reason_;
};

/// A formula that has no value: shapes that do not fit, or a number type that lacks a function.
class NoValue : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

}  // namespace oddity::formula
