#pragma once

#include <filesystem>
#include <string>

/// Files that are there whole or not at all, whatever interrupts the run.
namespace oddity {

/// Throws BadInput when the file could not be written, so that no run is lost for it; makes its folder.
void require_writable(const std::filesystem::path& file);
/// Writes the whole file or none of it. Throws BadInput when it cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace oddity
