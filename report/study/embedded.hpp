#pragma once

#include <span>
#include <string_view>

namespace oddity {

/// A file of this project that is embedded in the program.
struct EmbeddedFile {
  std::string_view path, text;
};
/// The headers of the models and of the plain algorithms, and the project's headers that they include.
std::span<const EmbeddedFile> embedded_headers();

}  // namespace oddity
