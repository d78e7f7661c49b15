#pragma once

#include <mutex>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

/// Text from a file, an argument or another program may contain control characters, which a terminal obeys.
/// They are shown, and never sent.
namespace oddity {

/// The text with control characters (except newline and tab) and bytes that are not UTF-8 as "\x1b".
std::string visible(std::string_view text);

/// During its lifetime, makes control characters written to the stream visible. Lets the characters in `also`
/// pass, and changes of colour if `colours`.
class VisibleOutput : private std::streambuf {
 public:
  VisibleOutput(std::ostream&, bool colours, std::string_view also = "");
  ~VisibleOutput() override;
  VisibleOutput(const VisibleOutput&) = delete;
  VisibleOutput& operator=(const VisibleOutput&) = delete;

 private:
  int_type overflow(int_type) override;
  std::streamsize xsputn(const char*, std::streamsize) override;
  int sync() override;
  bool send(std::size_t size);

  std::ostream& stream_;
  std::streambuf* to_;
  bool colours_;
  std::string_view also_;
  std::string line_;  ///< buffered until the line is complete
  std::mutex mutex_;  ///< a separate thread shows progress
};

}  // namespace oddity
