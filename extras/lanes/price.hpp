#pragma once

#include <optional>

#include "extras/lanes/batch.hpp"
#include "report/cli/extras.hpp"

namespace oddity::lanes {

/// The registers that a method's bodies go side by side in on this machine; none where it is no method of
/// lanes: those have the models without events, by the algorithms of `Fixed` and by Dormand and Prince's.
std::optional<Registers> registers_of(std::string_view scene, std::string_view model,
                                      std::string_view algorithm);

/// The library of the scenes' models in lanes.
extern const Needs needs_of_lanes;

/// What the need's bodies cost over the horizon, each frame of all of them after the one before: in lanes
/// where there are such, else one body as often.
Price price_of_all(const Task&, const Need&);

/// Bodies in lanes, for `choose --bodies`.
ManyBodies bodies_in_lanes();

}  // namespace oddity::lanes
