#include "report/site/script.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/beast/zlib/deflate_stream.hpp>
#include <boost/crc.hpp>
#include <stdexcept>

namespace oddity {

namespace {

/// Deflated as by zlib at its best compression.
std::string deflated(const std::string& text) {
  namespace zlib = boost::beast::zlib;
  zlib::deflate_stream stream;
  stream.reset(9, 15, 9, zlib::Strategy::normal);
  std::string bytes(stream.upper_bound(text.size()) + 64, '\0');
  zlib::z_params room;
  room.next_in = text.data();
  room.avail_in = text.size();
  room.next_out = bytes.data();
  room.avail_out = bytes.size();
  boost::system::error_code end;
  stream.write(room, zlib::Flush::finish, end);
  if (end != zlib::error::end_of_stream) throw std::logic_error("data cannot be packed: " + end.message());
  bytes.resize(room.total_out);
  return bytes;
}

}  // namespace

std::string in_base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Letters(bytes.begin()), Letters(bytes.end()));
  return text.append((4 - text.size() % 4) % 4, '=');
}

void append(std::string& bytes, std::uint32_t bits, int count) {
  for (int byte = 0; byte < count; ++byte) bytes += static_cast<char>(bits >> 8 * byte & 0xff);
}

std::string packed(const std::string& text) {
  boost::crc_32_type sum;
  sum.process_bytes(text.data(), text.size());
  std::string bytes("\x1f\x8b\x08\0\0\0\0\0\x02\xff",
                    10);  // gzip's head: deflated, without time and system
  bytes += deflated(text);
  append(bytes, sum.checksum(), 4);
  append(bytes, static_cast<std::uint32_t>(text.size()), 4);
  return in_base64(bytes);
}

std::string packed_call(std::string_view function, const nlohmann::ordered_json& data) {
  using Json = nlohmann::ordered_json;
  return "oddity." + std::string(function) + "(\"" +
         packed(data.dump(-1, ' ', false, Json::error_handler_t::replace)) + "\");\n";
}

}  // namespace oddity
