#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Files that are complete or absent, even after an interruption.
namespace oddity {

/// Throws BadInput if the file could not be written, before a run spends its time; creates its folder.
void require_writable(const std::filesystem::path& file);
/// Checks the same for files in a folder, which is created.
void require_writable_folder(const std::filesystem::path& folder);
/// Writes the whole file or none of it: under a random name, which it changes for its own when complete.
/// Nothing is written through existing files: a link of this name is replaced, and a link in the path that
/// another user made is refused. Throws BadInput if it cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// Creates the folder, for this user alone, if it is missing. Throws BadInput if it belongs to somebody else,
/// if others can write to it, or if they own the file `name` in it.
void require_private(const std::filesystem::path& folder, const std::string& name);

/// Takes a folder for files of this program only; creates and marks it. Throws BadInput if it contains other
/// files and has no mark, unless these may be overwritten.
void take_folder(const std::filesystem::path& folder, bool over_others);

/// A temporary folder of the system, removed by the destructor. Throws BadInput if none can be created.
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

/// Largest file that is read [bytes]: many times the largest that the program writes and reads again.
constexpr std::size_t most_read = 200'000'000;
/// The whole content of a regular file. Throws BadInput for anything else and if the file is larger or
/// unreadable; never waits for a pipe or a device.
std::string read_whole(const std::filesystem::path& file, std::size_t most = most_read);

/// Checksum of a text, for files that only this program reads again.
std::string checksum(std::string_view text);
/// Writes the text's lines and, in one more line, their checksum. Throws BadInput if it cannot be written.
void write_sealed(const std::filesystem::path& file, const std::string& text);
/// Writes text that can be computed again: if the file cannot be written nothing is kept.
void keep_sealed(const std::filesystem::path& file, const std::string& text);
enum class Whose { ours, anybodys };
/// The text kept in the file; empty if the file is missing or changed, is a link, or should belong to this
/// user and does not.
std::optional<std::string> read_sealed(const std::filesystem::path& file, Whose whose = Whose::ours);

/// Whether the path is an existing device of the system, such as /dev/stdout.
bool is_device(const std::filesystem::path& path);
/// Throws BadInput if the device does not accept the whole text.
void write_to_device(const std::filesystem::path& path, const std::string& text);

}  // namespace oddity
