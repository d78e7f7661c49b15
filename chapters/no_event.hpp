#pragma once

#include <string_view>

namespace oddity {

/// Message for a motion that has reached its end without any event of its model.
inline constexpr std::string_view no_event =
    "no event has happened: none of the model's guards has fallen through zero";

}  // namespace oddity
