#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reference/reference.hpp"
#include "reference/truth.hpp"

namespace oddity {

/// The rows of a table of true values, each with all of its components in order. Throws BadInput, with the
/// line, if the file differs from the generator's format.
std::map<std::vector<double>, Known> read_table(const std::filesystem::path& file, const truth::Truth& truth);

/// Checksum of all tables of a reference folder, and those of exercises outside the tree; or only of those
/// whose generators are wanted.
std::string checksum_of_tables(const std::filesystem::path& folder,
                               const std::function<bool(const truth::Entry&)>& wanted = {});

}  // namespace oddity
