#pragma once

#include <optional>

#include "extras/lanes/batch.hpp"
#include "report/cli/extras.hpp"

namespace oddity::lanes {

/// The registers for a method's bodies on this machine; none if the method has no lanes. Models without
/// events have them, by the algorithms of `Fixed` and by Dormand and Prince's.
std::optional<Registers> registers_of(std::string_view scene, std::string_view model,
                                      std::string_view algorithm);

/// The library of the scenes' models in lanes.
extern const Needs needs_of_lanes;

/// Cost of all bodies over the horizon, frame after frame: in lanes if there are any, otherwise that of one
/// body times their number.
Price price_of_all(const Task&, const Need&);

/// Bodies in lanes, for `choose --bodies`.
ManyBodies bodies_in_lanes();

}  // namespace oddity::lanes
