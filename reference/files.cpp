#include "reference/files.hpp"

#include <fstream>

#include "reference/bad_input.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The file that is written first, open and its folder made.
std::ofstream open_part(const fs::path& file, const fs::path& part) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throw BadInput("cannot make the folder " + file.parent_path().string() + ": " + error.message());
  std::ofstream out(part, std::ios::binary);
  if (!out) throw BadInput("cannot write " + file.string() + ": the folder is not writable");
  return out;
}

fs::path part_of(const fs::path& file) { return file.string() + ".part"; }

}  // namespace

void require_writable(const fs::path& file) {
  if (fs::is_directory(file)) throw BadInput("cannot write " + file.string() + ": it is a folder");
  open_part(file, part_of(file)).close();
  fs::remove(part_of(file));
}

void write_whole(const fs::path& file, const std::string& text) {
  const fs::path part = part_of(file);
  std::ofstream out = open_part(file, part);
  out << text << std::flush;
  if (!out) throw BadInput("cannot write " + file.string() + ": the disk may be full");
  out.close();
  std::error_code error;
  fs::rename(part, file, error);
  if (error) throw BadInput("cannot write " + file.string() + ": " + error.message());
}

}  // namespace oddity
