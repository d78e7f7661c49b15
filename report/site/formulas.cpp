#include "report/site/formulas.hpp"

namespace oddity::html {

std::string marked(std::string_view tex) { return "\x02" + std::string(tex) + "\x03"; }

bool typeset(std::map<std::string, std::string>& pages) {
  for (auto& [name, text] : pages)
    for (auto& c : text)
      if (c == '\x02' || c == '\x03') c = '$';
  return false;
}

}  // namespace oddity::html
