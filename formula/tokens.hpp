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

/// Of TeX. A number is one token only at the top: x_12 is x with the index 1, and 2. What only moves or
/// stretches is left out, and braces around a single token.
Tokens tex_tokens(std::string_view text);

/// Of text as one types it, in TeX's commands: sin as \sin, * and ** and <= as well. A name is one token,
/// with its primes. A known name may have commas in it, f2,1: `length_of_name` is that of the one that begins
/// a text, or zero.
Tokens plain_tokens(std::string_view text,
                    const std::function<std::size_t(std::string_view)>& length_of_name);

/// A letter's name as one types it: theta'' for \ddot\theta, y_2' for \dot y_2, r for \mathbf r.
std::string plain_name(std::string_view tex);
/// The other way about, for names that are Greek or have primes: \ddot\theta for theta''. Others stay.
std::string tex_name(std::string_view plain);

}  // namespace oddity::formula
