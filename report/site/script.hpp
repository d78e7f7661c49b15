#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace oddity {

/// Text as the base64 of its gzip, which a browser unpacks, as does `base64 -d | gunzip`.
std::string packed(const std::string& text);

/// A script that passes these data, packed, to the page: oddity.function("...");
std::string packed_call(std::string_view function, const nlohmann::ordered_json& data);

/// Bytes in base64.
std::string in_base64(const std::string& bytes);

/// Appends the lowest `count` bytes, least significant first.
void append(std::string& bytes, std::uint32_t bits, int count);

}  // namespace oddity
