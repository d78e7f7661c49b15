#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Files that are there whole or not at all, whatever interrupts the run.
namespace oddity {

/// Throws BadInput when the file could not be written, so that no run is lost for it; makes its folder.
void require_writable(const std::filesystem::path& file);
/// The same for files in a folder, which is made.
void require_writable_folder(const std::filesystem::path& folder);
/// Writes the whole file or none of it: under its name with ".part", until it is whole and takes its name.
/// Where two runs write it at once, one is after the other. Throws BadInput when it cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// A folder of the system's temporary ones, gone with this. Throws std::system_error when none can be made.
class PassingFolder {
 public:
  PassingFolder();
  ~PassingFolder();
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;

  /// The path of a file in it.
  std::string operator/(std::string_view name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

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
