#pragma once

#include <filesystem>
#include <future>
#include <string>

namespace oddity {

/// Output of a stream that does not notice a full disk: collected in memory, then written whole.
class Collected {
 public:
  /// Throws BadInput if the file cannot be written.
  explicit Collected(std::filesystem::path file);
  Collected(Collected&& other) noexcept;
  Collected& operator=(Collected&&) = delete;
  /// Requires that the stream is closed.
  ~Collected();
  /// The path to write to instead of the file.
  std::string collector() const;
  /// Writes the file after the stream is closed. Throws BadInput if it cannot be written.
  void deliver();

 private:
  void close_our_end();

  std::filesystem::path file_;
  int pipe_ = -1;  ///< where the stream writes
  std::future<std::string> text_;
};

}  // namespace oddity
