#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The scenes' models as a WebAssembly module, for the players in the page.
namespace oddity {

/// C++ files, so many, that together define scenes() of report/site/module/scene.hpp: made of the listings of
/// all scenes, which name the headers and the expressions that construct the models.
std::vector<std::string> module_source(std::size_t files);

/// Whether the modules have been built.
bool has_module();
/// assets/models.js: oddity.module("the compiled module, packed by gzip, in base64"), or oddity.module(null)
/// where it has not been built. It comes after assets/engine.js.
std::string module_script();
/// assets/own.js: the same of the module that reads and runs problems' files.
std::string own_script();

}  // namespace oddity
