#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/text/visible.hpp"

namespace oddity {

/// A whole number from an untrusted file. The library's own conversions truncate, or are undefined, if the
/// number does not fit. Throws std::runtime_error.
template <class Int>
Int whole(const nlohmann::ordered_json& json) {
  if (json.is_number_unsigned() && std::in_range<Int>(json.get<std::uint64_t>()))
    return static_cast<Int>(json.get<std::uint64_t>());
  if (json.is_number_integer() && !json.is_number_unsigned() && std::in_range<Int>(json.get<std::int64_t>()))
    return static_cast<Int>(json.get<std::int64_t>());
  throw std::runtime_error("no whole number that fits: " + json.dump());
}

/// The message without the library's exception name and number: "[json.exception.out_of_range.403] key ...".
inline std::string without_exception_name(std::string_view says) {
  const auto end = says.starts_with("[json.exception.") ? says.find("] ") : says.npos;
  return std::string(end == says.npos ? says : says.substr(end + 2));
}

/// Makes control characters in all texts of a file visible, so that none reaches a terminal.
inline void show_controls(nlohmann::ordered_json& json) {
  for (std::vector<nlohmann::ordered_json*> left{&json}; !left.empty();) {
    nlohmann::ordered_json& one = *left.back();
    left.pop_back();
    if (one.is_string()) one = visible(one.get_ref<const std::string&>());
    if (one.is_structured())
      for (nlohmann::ordered_json& part : one) left.push_back(&part);
  }
}

}  // namespace oddity
