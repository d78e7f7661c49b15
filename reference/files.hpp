#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "reference/interrupted.hpp"

/// Files that are there whole or not at all, whatever interrupts the run.
namespace oddity {

/// A file under its name with ".part", until it is whole and takes its name; gone if it never is, also when
/// the run is interrupted (reference/interrupted.hpp).
class PartFile {
 public:
  /// Makes its folder. Throws BadInput when that cannot be, or when something else than a file has the name.
  explicit PartFile(std::filesystem::path file);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  /// Where to write until it is whole.
  const std::filesystem::path& path() const { return part_; }
  /// It is whole. Throws BadInput when it cannot take its name.
  void keep();

 private:
  std::filesystem::path file_, part_;
  Unfinished unfinished_;
};

/// Throws BadInput when the file could not be written, so that no run is lost for it; makes its folder.
void require_writable(const std::filesystem::path& file);
/// The same for files in a folder, which is made.
void require_writable_folder(const std::filesystem::path& folder);
/// Writes the whole file or none of it. Throws BadInput when it cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// Of a text, for files that this program alone reads again.
std::string checksum(std::string_view text);
/// Writes the text's lines and, in one more, their checksum. Throws BadInput when it cannot be written.
void write_sealed(const std::filesystem::path& file, const std::string& text);
/// The same, of what can be made again: where the file cannot be written nothing is kept.
void keep_sealed(const std::filesystem::path& file, const std::string& text);
/// What was kept in the file; nothing when it is not there, or is not what was written.
std::optional<std::string> read_sealed(const std::filesystem::path& file);

/// Whether the path is there and neither a regular file nor a folder, as /dev/stdout is.
bool is_device(const std::filesystem::path& path);
/// Throws BadInput when the device does not take all of the text.
void write_to_device(const std::filesystem::path& path, const std::string& text);

}  // namespace oddity
