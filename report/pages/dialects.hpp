#pragma once

#include <cstddef>
#include <string>

#include "report/pages/program.hpp"

namespace oddity {

/// A program is put together in one dialect: C# with State, Half and Seen for its arrays, Array3 for three
/// numbers, copy(x) and size(x).
struct Dialect {
  std::size_t unknowns, observables;

  std::string in(Language, const std::string& code) const;
};

}  // namespace oddity
