#pragma once

#include <memory>

#include "chapters/in_float.hpp"
#include "problem/model.hpp"

namespace oddity::problem {

/// A model of a file for a scene's methods. The compiler does not know its number of unknowns.
struct AnyModel {
  std::shared_ptr<const ModelInterface> model;
};
AnyModel interpreted(std::shared_ptr<const Numbers>);
/// The model in float; `rounded` has the parameters rounded to float.
std::shared_ptr<const ModelInFloat> interpreted_in_float(const Horizon&, std::shared_ptr<const Numbers> exact,
                                                         const std::shared_ptr<const Numbers>& rounded);

/// Found by argument-dependent lookup where a scene's methods are made.
inline std::shared_ptr<const ModelInterface> type_erased(const AnyModel& any) { return any.model; }

}  // namespace oddity::problem
