#pragma once

#include <filesystem>
#include <string>

namespace oddity {

/// What bounds the errors of the reference tables in `folder`/tables, in Markdown: how many values are
/// enclosed, and how narrowly, and which are not. Throws BadInput when a table is broken.
std::string true_values(const std::filesystem::path& folder);

}  // namespace oddity
