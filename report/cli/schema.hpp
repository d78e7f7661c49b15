#pragma once

#include <string>

namespace oddity {

/// The JSON schema of a problem's file, made from the reader's own table of keys. Editors complete and check
/// with it.
std::string schema_of_problems();

}  // namespace oddity
