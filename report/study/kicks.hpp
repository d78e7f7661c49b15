#pragma once

#include <memory>
#include <string>
#include <utility>

#include "chapters/kicks.hpp"
#include "chapters/scene.hpp"

/// Kicks: an observable or its rate is changed from outside, at a time, for every model in its own state.
namespace oddity {

/// Reads kicks of a scene's observables, "t=1s,theta'=+2", separated by semicolons. Returns them and the text
/// that shows them. A value with a sign is added, one with a star multiplies, any other is set. "speed" is
/// the rate of every observable. Throws BadInput.
std::pair<std::shared_ptr<const Kicks>, std::string> kicks_of(const Scene&, const Quantity& seen,
                                                              const std::string& text, double horizon);

/// The method with the kicks. It is `raised` where it takes none.
Method with_kicks(Method, const std::shared_ptr<const Kicks>&);

/// The kicks, with the methods that have the true motion where nothing kicks it. Each such model has two
/// algorithms. Models that may drift off their constraints come first, richer models later. The quantity is
/// the motion without kicks.
std::shared_ptr<const Kicks> with_ways(const std::shared_ptr<const Kicks>&, const Quantity& without);

/// The motion with the kicks, without its methods in float. Its truth is that of the last of the ways; the
/// bound is four times as far as the others are from it. Throws BadInput if fewer than two come to the end,
/// or one finds that the observables do not determine the kick.
Quantity kicked_motion(Quantity without, const std::shared_ptr<const Kicks>&);

}  // namespace oddity
