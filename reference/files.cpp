#include "reference/files.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <system_error>

#include "reference/bad_input.hpp"
#include "reference/interrupted.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// What the system says of its last failure.
std::string last_failure() { return std::error_code(errno, std::generic_category()).message(); }

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw BadInput("cannot write " + file.string() + ": " + why);
}

void require(bool written, const fs::path& file) {
  if (!written) refuse(file, last_failure());
}

void make_folder_of(const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throw BadInput("cannot make the folder " + file.parent_path().string() + ": " + error.message());
}

/// Makes its folder, and throws BadInput when that cannot be, or when something else than a file has the
/// name.
void require_place(const fs::path& file) {
  make_folder_of(file);
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) refuse(file, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse(file, "it is not a regular file");
}

std::string part_of(const fs::path& file) { return file.string() + ".part"; }

bool took_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
  const int other = dup(descriptor);  // a disk on the net may say only as a file is closed that it is full
  return other >= 0 && close(other) == 0;
}

}  // namespace

void require_writable(const fs::path& file) {
  require_place(file);
  require(Unfinished(part_of(file)).descriptor() >= 0, file);
}

void require_writable_folder(const fs::path& folder) {
  const fs::path file = folder / "is_it_writable";
  require_place(file);
  if (Unfinished(part_of(file)).descriptor() < 0)
    throw BadInput("cannot write in the folder " + folder.string() + ": " + last_failure());
}

void write_whole(const fs::path& file, const std::string& text) {
  require_place(file);
  Unfinished part(part_of(file));
  require(part.descriptor() >= 0, file);
  require(ftruncate(part.descriptor(), 0) == 0 && took_all(part.descriptor(), text), file);
  require(part.rename(file.string()), file);
}

std::string checksum(std::string_view text) {
  std::ostringstream hex;
  hex << std::hex << std::hash<std::string_view>()(text);
  return hex.str();
}

void write_sealed(const fs::path& file, const std::string& text) {
  write_whole(file, text + checksum(text) + "\n");
}

void keep_sealed(const fs::path& file, const std::string& text) {
  try {
    write_sealed(file, text);
  } catch (const BadInput&) {  // it will be made again
  }
}

std::optional<std::string> read_sealed(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string all(std::istreambuf_iterator<char>(in), {});
  if (all.size() < 2 || all.back() != '\n') return {};
  const std::size_t seal = all.rfind('\n', all.size() - 2) + 1;  // 0 where there is one line alone
  const std::string text = all.substr(0, seal);
  if (all.substr(seal) != checksum(text) + "\n") return {};
  return text;
}

bool is_device(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_to_device(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  require(out.is_open(), path);
  out << text;
  out.close();
  require(!out.fail(), path);
}

PassingFolder::PassingFolder() {
  std::string name = (fs::temp_directory_path() / "oddity_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), name);
  path_ = name;
}

PassingFolder::~PassingFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace oddity
