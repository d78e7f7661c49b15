#pragma once

#include <string_view>

namespace oddity {

/// A file of this project that is embedded in the program.
struct EmbeddedFile {
  std::string_view path, text;
};

}  // namespace oddity
