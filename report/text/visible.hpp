#pragma once

#include <mutex>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

/// What comes from a file, an argument or another program may hold control characters, by which a terminal is
/// told what to do: they are shown, and never sent.
namespace oddity {

/// The text with each control character but a line's end and a tab as "\x1b", and each byte that is not
/// UTF-8.
std::string visible(std::string_view text);

/// While it lives, what goes to the stream goes there visibly. Colours pass where there are some, and the
/// characters in `also`.
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
  std::string line_;  ///< as far as it has come
  std::mutex mutex_;  ///< progress is shown by a thread of its own
};

}  // namespace oddity
