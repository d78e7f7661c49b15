#pragma once

#include <string>

#include "reference/bad_input.hpp"

/// The message of the call's exception; "nothing" without one.
template <class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const oddity::BadInput& error) {
    return error.what();
  }
  return "nothing";
}
