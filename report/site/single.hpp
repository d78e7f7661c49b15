#pragma once

#include <functional>
#include <string>

namespace oddity {

/// A page of the site as one self-contained file. Includes its scripts and styles, and omits the rest of the
/// site; links lead only to places on the page. `file` returns the content of an address such as
/// "assets/page.js".
std::string in_one_file(std::string page, const std::function<std::string(const std::string&)>& file);

}  // namespace oddity
