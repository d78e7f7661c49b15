#include "reference/files.hpp"

#include <cerrno>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include "reference/bad_input.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// What the system says of its last failure.
std::string last_failure() { return std::error_code(errno, std::generic_category()).message(); }

void make_folder_of(const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throw BadInput("cannot make the folder " + file.parent_path().string() + ": " + error.message());
}

void require(bool written, const fs::path& file) {
  if (!written) throw BadInput("cannot write " + file.string() + ": " + last_failure());
}

}  // namespace

PartFile::PartFile(fs::path file)
    : file_(std::move(file)), part_(file_.string() + ".part"), unfinished_(part_.string()) {
  make_folder_of(file_);
  std::error_code error;
  const fs::file_status status = fs::status(file_, error);
  if (fs::is_directory(status)) throw BadInput("cannot write " + file_.string() + ": it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw BadInput("cannot write " + file_.string() + ": it is not a regular file");
}

PartFile::~PartFile() {
  std::error_code ignored;
  if (!part_.empty()) fs::remove(part_, ignored);
}

void PartFile::keep() {
  std::error_code error;
  fs::rename(part_, file_, error);
  if (error) throw BadInput("cannot write " + file_.string() + ": " + error.message());
  part_.clear();
}

void require_writable(const fs::path& file) {
  const PartFile part(file);
  require(std::ofstream(part.path()).is_open(), file);
}

void require_writable_folder(const fs::path& folder) {
  const PartFile part(folder / "is_it_writable");
  if (!std::ofstream(part.path()).is_open())
    throw BadInput("cannot write in the folder " + folder.string() + ": " + last_failure());
}

void write_whole(const fs::path& file, const std::string& text) {
  PartFile part(file);
  std::ofstream out(part.path(), std::ios::binary);
  require(out.is_open(), file);
  out << text;
  out.close();
  require(!out.fail(), file);
  part.keep();
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

}  // namespace oddity
