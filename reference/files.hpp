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
/// Writes the whole file or none of it: under a name of chance, until it is whole and takes its own. Nothing
/// is written through what was there: a link of this name is replaced, one that another user made on the way
/// to it is refused. Throws BadInput when it cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// Makes the folder, for this user alone, where it is not there. Throws BadInput where it is another's, or
/// where others can write to it, or have what has the name in it.
void require_private(const std::filesystem::path& folder, const std::string& name);

/// Takes a folder for files of this program alone, which is made and marked. Throws BadInput where it holds
/// others and has no mark, unless these may be written over.
void take_folder(const std::filesystem::path& folder, bool over_others);

/// A folder of the system's temporary ones, gone with this. Throws BadInput when none can be made.
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

/// The most that is read of one file [bytes]: many times the largest that the program writes and reads again.
constexpr std::size_t most_read = 200'000'000;
/// All of a regular file. Throws BadInput where it is none, larger or unreadable, and waits for no pipe and
/// no device.
std::string read_whole(const std::filesystem::path& file, std::size_t most = most_read);

/// Of a text, for files that this program alone reads again.
std::string checksum(std::string_view text);
/// Writes the text's lines and, in one more, their checksum. Throws BadInput when it cannot be written.
void write_sealed(const std::filesystem::path& file, const std::string& text);
/// The same, of what can be made again: where the file cannot be written nothing is kept.
void keep_sealed(const std::filesystem::path& file, const std::string& text);
enum class Whose { ours, anybodys };
/// What was kept in the file; nothing when it is not there, or is not what was written, is a link, or is not
/// of this user and should be.
std::optional<std::string> read_sealed(const std::filesystem::path& file, Whose whose = Whose::ours);

/// Whether the path is there and one of the system's, as /dev/stdout is.
bool is_device(const std::filesystem::path& path);
/// Throws BadInput when the device does not take all of the text.
void write_to_device(const std::filesystem::path& path, const std::string& text);

}  // namespace oddity
