#pragma once

#include <string>

/// Numbers as text for readers.
namespace oddity {

/// Two significant digits; whole numbers from 100 to a million have no exponent: "0.12", "350".
std::string two_digits(double);
/// A fraction as a percentage: "12 %".
std::string percent(double part);

}  // namespace oddity
