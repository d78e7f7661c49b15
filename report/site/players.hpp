#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The scenes' models as a WebAssembly module, for the page's players.
namespace oddity {

/// The texts of `files` C++ files that together define scenes() of report/site/module/scene.hpp. They are
/// made from the listings of all scenes, which name the headers and the expressions that construct the
/// models.
std::vector<std::string> module_source(std::size_t files);

/// Whether the modules have been built.
bool has_module();
/// assets/models.js: oddity.module("the compiled module, packed by gzip, in base64"), or oddity.module(null)
/// if it was not built. Loaded after assets/engine.js.
std::string module_script();
/// assets/own.js: the same for the module that reads and runs problems' files.
std::string own_script();

}  // namespace oddity
