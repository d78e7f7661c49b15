#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace oddity {

/// A whole number of a file that may hold anything: the library's own conversions cut off, or are undefined,
/// where the number does not fit. Throws std::runtime_error.
template <class Int>
Int whole(const nlohmann::ordered_json& json) {
  if (json.is_number_unsigned() && std::in_range<Int>(json.get<std::uint64_t>()))
    return static_cast<Int>(json.get<std::uint64_t>());
  if (json.is_number_integer() && !json.is_number_unsigned() && std::in_range<Int>(json.get<std::int64_t>()))
    return static_cast<Int>(json.get<std::int64_t>());
  throw std::runtime_error("no whole number that fits: " + json.dump());
}

}  // namespace oddity
