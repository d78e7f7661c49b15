#pragma once

#include <memory>
#include <span>

#include "problem/model.hpp"
#include "report/site/module/scene.hpp"

namespace oddity::module {

/// A file's model for the page. If it cannot start with these parameters, each motion gives the reason.
std::unique_ptr<const Model> played(const problem::Model&, std::span<const double> parameters);

}  // namespace oddity::module
