#pragma once

#include <string_view>

#include "chapters/exercise.hpp"

/// How algorithms and outcomes look in charts and maps.
namespace oddity {

/// Of algorithms that integrate a motion; a chart shows the best of each.
enum class Family {
  none,
  closed_form,
  explicit_steps,
  partitioned,
  step_control,
  extrapolation,
  multistep,
  implicit
};
Family family_of(std::string_view algorithm);

/// The cells of a map: "#009E73". Colour-blind readers can tell any two apart.
std::string_view colour_of(Outcome);
/// Black or white, whichever is legible on the outcome's colour.
std::string_view colour_on(Outcome);

}  // namespace oddity
