#pragma once

#include <string_view>

namespace oddity {

/// The message of a motion that has come to its end without any of its model's events.
inline constexpr std::string_view no_event =
    "no event has happened: none of the model's guards has fallen through zero";

}  // namespace oddity
