#pragma once

#include <optional>
#include <string>

/// The scenes' models as a WebAssembly module, for the players in the page.
namespace oddity {

/// C++ with a function for each thing that the page asks of the models (report/site/module/module.hpp): made
/// of the listings of all scenes, which name the headers and the expressions that construct the models.
std::string module_source();

/// assets/models.js: the compiled module as a script; none where it has not been built.
std::optional<std::string> module_script();

}  // namespace oddity
