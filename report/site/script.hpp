#pragma once

#include <string>
#include <string_view>

namespace oddity {

/// JSON as it may stand in a script, inside a page or not: nothing in its strings ends a script or a line.
inline std::string as_script(std::string_view json) {
  std::string safe;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] == '<')
      safe += "\\u003c";
    else if (json.substr(i, 3) == "\u2028")
      safe += "\\u2028", i += 2;
    else if (json.substr(i, 3) == "\u2029")
      safe += "\\u2029", i += 2;
    else
      safe += json[i];
  }
  return safe;
}

}  // namespace oddity
