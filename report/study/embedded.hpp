#pragma once

#include <span>
#include <string_view>

namespace oddity {

/// A file of this project as the program carries it.
struct EmbeddedFile {
  std::string_view path, text;
};
/// Those of the models and of the plain algorithms, and what they include of the project.
std::span<const EmbeddedFile> embedded_headers();

}  // namespace oddity
