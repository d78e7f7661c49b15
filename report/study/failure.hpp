#pragma once

#include <new>
#include <string>

#include "reference/bad_input.hpp"

namespace oddity {

/// Message of an exception that ends the work and concerns only one exercise; empty: none. Rethrows BadInput
/// and failures for lack of memory.
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
