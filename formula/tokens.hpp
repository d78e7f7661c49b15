#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace oddity::formula {

/// A command, a name, a number or a sign, and its place in the text.
struct Token {
  std::string text;
  std::size_t begin = 0, end = 0;
};
using Tokens = std::vector<Token>;

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Tokens of TeX. A number is one token only at the top level: x_12 is x with the index 1, and 2. Omits
/// commands that only move or stretch, and braces around a single token.
Tokens tex_tokens(std::string_view text);

/// Tokens of typed text, as TeX's commands: sin as \sin; also *, ** and <=. A name is one token, with its
/// primes. A known name may contain commas, f2,1: `length_of_name` returns the length of the name that begins
/// a text, or zero.
Tokens plain_tokens(std::string_view text,
                    const std::function<std::size_t(std::string_view)>& length_of_name);

/// A letter's name as it is typed: theta'' for \ddot\theta, y_2' for \dot y_2, r for \mathbf r.
std::string plain_name(std::string_view tex);
/// The reverse for names that are Greek or have primes: \ddot\theta for theta''. Others stay.
std::string tex_name(std::string_view plain);

}  // namespace oddity::formula
