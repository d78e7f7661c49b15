#pragma once

#include <memory>
#include <span>

#include "problem/model.hpp"
#include "report/site/module/scene.hpp"

namespace oddity::module {

/// A file's model as the page runs it. Where it cannot start with these parameters, each motion says why.
std::unique_ptr<const Model> played(const problem::Model&, std::span<const double> parameters);

}  // namespace oddity::module
