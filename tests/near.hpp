#pragma once

#include <cmath>
#include <ostream>

#include "reference/text.hpp"

/// got == expected within `allowed`, for CHECK: a failure prints both numbers with every digit. Fails for
/// NaN.
struct Near {
  double got, expected, allowed;
  explicit operator bool() const { return std::abs(got - expected) <= allowed; }
};

inline std::ostream& operator<<(std::ostream& out, const Near& near) {
  return out << oddity::format_shortest(near.got) << " near " << oddity::format_shortest(near.expected)
             << " within " << oddity::format_significant(near.allowed, 3) << " (off by "
             << oddity::format_significant(near.got - near.expected, 3) << ")";
}

inline Near near(double got, double expected, double allowed) { return {got, expected, allowed}; }

/// Within `ulps` units in the last place of the expected number.
inline Near near_ulps(double got, double expected, double ulps) {
  return {got, expected, ulps * std::abs(expected) * 0x1p-52};
}

/// Within this part of the expected number.
inline Near near_part(double got, double expected, double part) {
  return {got, expected, part * std::abs(expected)};
}

/// low <= got <= high, for CHECK: a failure prints the number.
struct Within {
  double got, low, high;
  explicit operator bool() const { return low <= got && got <= high; }
};

inline std::ostream& operator<<(std::ostream& out, const Within& within) {
  return out << oddity::format_shortest(within.got) << " within " << oddity::format_shortest(within.low)
             << " and " << oddity::format_shortest(within.high);
}

inline Within within(double got, double low, double high) { return {got, low, high}; }
