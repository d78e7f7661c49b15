#pragma once

#include <memory>

#include "chapters/in_float.hpp"
#include "problem/model.hpp"

namespace oddity::problem {

/// A model of a file, as a scene's methods take it: its number of unknowns is not known to the compiler.
struct AnyModel {
  std::shared_ptr<const ModelInterface> model;
};
AnyModel interpreted(std::shared_ptr<const Numbers>);
/// The same in float; `rounded` has the parameters rounded to float.
std::shared_ptr<const ModelInFloat> interpreted_in_float(const Horizon&, std::shared_ptr<const Numbers> exact,
                                                         const std::shared_ptr<const Numbers>& rounded);

/// Found by its argument where a scene's methods are made.
inline std::shared_ptr<const ModelInterface> type_erased(const AnyModel& any) { return any.model; }

}  // namespace oddity::problem
