#include "report/site/parts.hpp"

#include "report/site/players.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

SiteParts parts_at_hand() { return {has_module()}; }

std::vector<std::string> packages_of_models() {
  return {"clang", "lld", "libc++-dev-wasm32", "libclang-rt-dev-wasm32"};
}

std::vector<std::string> lacks(const SiteParts& parts) {
  std::vector<std::string> all;
  if (!parts.models)
    all.emplace_back(
        "the compiled models: its players show recorded motions, as curves, and its chooser tries nothing");
  return all;
}

std::string command_for(const SiteParts& parts) {
  std::string packages;
  if (!parts.models)
    for (const std::string& name : packages_of_models()) packages += " " + name;
  return "apt-get install" + packages + " && " + program_as_typed() + " site";
}

}  // namespace oddity
