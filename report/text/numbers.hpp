#pragma once

#include <string>

/// Numbers as a reader takes them in.
namespace oddity {

/// Without an exponent where people do without one: "0.12", "350".
std::string two_digits(double);
/// A part of a whole: "12 %".
std::string percent(double part);

}  // namespace oddity
