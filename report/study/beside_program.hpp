#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace oddity {

/// A library in the program's folder, or in the one above it, as tests have it; where it is.
std::optional<std::filesystem::path> beside_program(const std::string& name);

/// The library's function of that name, loaded for as long as the program runs. Throws BadInput where the
/// file is no library, or has no such function.
void* function_in(const std::filesystem::path& library, const std::string& name);

template <class Function>
Function* function_of(const std::filesystem::path& library, const std::string& name) {
  return reinterpret_cast<Function*>(function_in(library, name));
}

}  // namespace oddity
