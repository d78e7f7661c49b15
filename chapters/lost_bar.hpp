#pragma once

#include <string>
#include <utility>

#include "chapters/exercise.hpp"

namespace oddity {

/// A claim whose fraction bar the text at hand has lost: what stands there, and what was meant by it.
inline Claim lost_bar(Claim claim, Reading as_it_stands, std::string why) {
  claim.meant = std::move(claim.printed);
  if (claim.meant.text == "as printed") claim.meant.text = "a quotient";
  claim.printed = std::move(as_it_stands);
  claim.why = std::move(why);
  return claim;
}

}  // namespace oddity
