#pragma once

#include <limits>
#include <string>

#include "chapters/claims.hpp"
#include "reference/to_write.hpp"

/// Placeholder for a claim's independent route until it is written. `to_write()` converts to any kind of
/// route, has the value NaN, and names its file and line.
namespace oddity {

class ToWrite {
 public:
  ToWrite(const char* file, int line) : by_(to_write_at(file, line)) {}

  /// Lists the ingredients that the route can be written from.
  template <class... Ingredients>
  const ToWrite& from(const Ingredients&...) const {
    return *this;
  }

  operator Route() const { return {by_, nothing}; }
  template <class Sample>
  operator Formula<Sample>() const {
    return {by_, [](const Sample&) { return Value(nothing); }};
  }

 private:
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::string by_;
};

inline ToWrite to_write(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  return {file, line};
}

}  // namespace oddity
