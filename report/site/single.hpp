#pragma once

#include <functional>
#include <string>

namespace oddity {

/// A page of the site as one file that stands alone: its scripts and styles are within it, the rest of the
/// site is left out, and links lead to places in the page alone. `file` gives what an address such as
/// "assets/page.js" has.
std::string in_one_file(std::string page, const std::function<std::string(const std::string&)>& file);

}  // namespace oddity
