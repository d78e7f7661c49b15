#pragma once

#include <span>

#include "chapters/embedded_file.hpp"

namespace oddity {

/// The headers of the models and of the plain algorithms, and the project's headers that they include.
std::span<const EmbeddedFile> embedded_headers();

}  // namespace oddity
