#pragma once

#include <string>

namespace oddity {

/// The JSON schema of a problem's file, from the reader's own table of keys: editors complete and check by
/// it.
std::string schema_of_problems();

}  // namespace oddity
