#pragma once

#include <memory>
#include <string>
#include <utility>

#include "chapters/kicks.hpp"
#include "chapters/scene.hpp"

/// Kicks: an observable or its rate is changed from outside, at a time, for every model in its own state.
namespace oddity {

/// "t=1s,theta'=+2" of a scene's observables, several with a semicolon between, and how they are shown. A
/// value with a sign is added, one with a star times what is there, any other is set; "speed" is the rate of
/// every observable. Throws BadInput.
std::pair<std::shared_ptr<const Kicks>, std::string> kicks_of(const Scene&, const Quantity& seen,
                                                              const std::string& text, double horizon);

/// The method with the kicks. It is `raised` where it takes none.
Method with_kicks(Method, const std::shared_ptr<const Kicks>&);

/// The motion with the kicks, without its methods in float. Its truth is followed by the models that have the
/// true motion where nothing kicks it, each by two algorithms; the bound is four times as far as these are
/// apart.
Quantity kicked_motion(Quantity without, const std::shared_ptr<const Kicks>&);

}  // namespace oddity
