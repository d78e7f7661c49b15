#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reference/reference.hpp"
#include "reference/truth.hpp"

namespace oddity {

/// The rows of a table of true values, each with all of its components in their order. Throws BadInput, with
/// the line, when it is not what the maker writes.
std::map<std::vector<double>, Known> read_table(const std::filesystem::path& file, const truth::Truth& truth);

/// The checksum of all that the tables of a reference folder, and those of one's own exercises, say; or of
/// those alone whose makers are wanted.
std::string checksum_of_tables(const std::filesystem::path& folder,
                               const std::function<bool(const truth::Entry&)>& wanted = {});

}  // namespace oddity
