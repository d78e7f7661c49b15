#pragma once

#include <algorithm>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/beast/zlib/inflate_stream.hpp>
#include <boost/crc.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "report/verify/catch.hpp"

/// Unpacks scripts packed by report/site/script.hpp.
namespace oddity {

inline std::string bytes_of(std::string base64) {
  using namespace boost::archive::iterators;
  using Bytes = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
  const auto padding = static_cast<std::size_t>(std::ranges::count(base64, '='));
  std::ranges::replace(base64, '=', 'A');
  std::string bytes(Bytes(base64.cbegin()), Bytes(base64.cend()));
  return bytes.substr(0, bytes.size() - padding);
}

/// The whole number of `count` bytes, least first.
inline std::uint32_t number_at(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint32_t bits = 0;
  for (std::size_t i = count; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[at + i]);
  return bits;
}

/// RFC 1952: a head, the deflated text, its checksum and its size.
inline std::string unpacked(const std::string& base64) {
  namespace zlib = boost::beast::zlib;
  constexpr std::size_t head = 10, tail = 8;
  const std::string bytes = bytes_of(base64);
  REQUIRE(bytes.size() > head + tail);
  REQUIRE(bytes.starts_with("\x1f\x8b\x08"));
  const std::size_t size = number_at(bytes, bytes.size() - 4, 4);
  std::string text(size, '\0');
  zlib::z_params room;
  room.next_in = bytes.data() + head;
  room.avail_in = bytes.size() - head;  // Beast looks a little beyond the end
  room.next_out = text.data();
  room.avail_out = text.size();
  boost::system::error_code end;
  zlib::inflate_stream().write(room, zlib::Flush::finish, end);
  REQUIRE(end == zlib::error::end_of_stream);
  REQUIRE(room.total_out == size);
  boost::crc_32_type sum;
  sum.process_bytes(text.data(), text.size());
  CHECK(sum.checksum() == number_at(bytes, bytes.size() - tail, 4));
  return text;
}

/// The argument of a script's only call.
inline nlohmann::json argument(const std::string& function, const std::string& script) {
  const std::string before = "oddity." + function + "(\"", after = "\");\n";
  REQUIRE(script.starts_with(before));
  REQUIRE(script.ends_with(after));
  const std::string base64 = script.substr(before.size(), script.size() - before.size() - after.size());
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";  // nothing that ends a script
  REQUIRE(base64.find_first_not_of(letters) == std::string::npos);
  return nlohmann::json::parse(unpacked(base64));
}

}  // namespace oddity
