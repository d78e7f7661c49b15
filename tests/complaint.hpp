#pragma once

#include <string>

#include "reference/bad_input.hpp"

/// What the call complains of; "nothing" when it does not.
template <class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const oddity::BadInput& error) {
    return error.what();
  }
  return "nothing";
}
