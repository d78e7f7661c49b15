#include "report/verify/collected.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"

namespace oddity {

namespace {

std::string read_to_the_end(int pipe) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  for (ssize_t n; (n = read(pipe, buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), static_cast<std::size_t>(n));
  close(pipe);
  return text;
}

}  // namespace

Collected::Collected(std::filesystem::path file) : file_(std::move(file)) {
  if (!is_device(file_)) require_writable(file_);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw BadInput("cannot collect the output to " + file_.string());
  pipe_ = ends[1];
  text_ = std::async(std::launch::async, read_to_the_end, ends[0]);
}

Collected::Collected(Collected&& other) noexcept
    : file_(std::move(other.file_)), pipe_(std::exchange(other.pipe_, -1)), text_(std::move(other.text_)) {}

Collected::~Collected() { close_our_end(); }

void Collected::close_our_end() {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
}

std::string Collected::collector() const { return "/proc/self/fd/" + std::to_string(pipe_); }

void Collected::deliver() {
  close_our_end();
  const std::string text = text_.get();
  if (is_device(file_))
    write_to_device(file_, text);
  else
    write_whole(file_, text);
}

}  // namespace oddity
