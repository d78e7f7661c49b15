// Calls MuJoCo's compiler, which reads files [manual: mujoco.readthedocs.io, Virtual file system].

#include "extras/engines/adapters/mujoco_model.hpp"

#include <algorithm>
#include <memory>

#include "extras/engines/adapters/mujoco_xml.hpp"
#include "extras/engines/adapters/simulation.hpp"

namespace oddity::engines {

namespace {

/// Options that the manual's chapter on solver settings recommends against slip.
std::string options(const std::string& variant) {
  if (variant == "defaults") return "";
  return "integrator='" + variant + "' cone='elliptic' impratio='10' tolerance='1e-12'";
}

}  // namespace

mjModel* mujoco_model(const World& world, const std::string& variant) {
  if (world.restitution != 0 && world.floor != Vector{})
    throw NotExpressible("no coefficient of restitution: contacts are springs with dampers");
  const std::vector<std::string> sources = mujoco_xml(world, options(variant));
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    mj_makeEmptyFileVFS(files.get(), std::to_string(i).c_str(), static_cast<int>(sources[i].size()));
    std::ranges::copy(sources[i], static_cast<char*>(files->filedata[i]));
  }
  char error[500];
  mjModel* const model =
      mj_loadXML(std::to_string(sources.size() - 1).c_str(), files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (!model) throw NotExpressible(error);
  return model;
}

}  // namespace oddity::engines
