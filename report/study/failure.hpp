#pragma once

#include <new>
#include <string>

#include "reference/bad_input.hpp"

namespace oddity {

/// What an exception says that ends the work, which is some exercise's own; empty: none does. BadInput and
/// what is lacking of memory are thrown on.
template <class Work>
std::string failure_of(const Work& work) try {
  work();
  return "";
} catch (const BadInput&) {
  throw;
} catch (const std::bad_alloc&) {
  throw;
} catch (const std::exception& error) {
  return error.what();
}

}  // namespace oddity
