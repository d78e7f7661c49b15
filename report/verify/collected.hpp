#pragma once

#include <filesystem>
#include <future>
#include <string>

namespace oddity {

/// What another's stream, which does not notice a full disk, writes to a file: collected in memory, and then
/// written whole.
class Collected {
 public:
  /// Throws BadInput when the file could not be written.
  explicit Collected(std::filesystem::path file);
  Collected(Collected&& other) noexcept;
  Collected& operator=(Collected&&) = delete;
  /// The stream must be closed.
  ~Collected();
  /// The path to write to in place of the file.
  std::string collector() const;
  /// Writes the file once the stream is closed. Throws BadInput when it cannot be written.
  void deliver();

 private:
  void close_our_end();

  std::filesystem::path file_;
  int pipe_ = -1;  ///< where the stream writes
  std::future<std::string> text_;
};

}  // namespace oddity
