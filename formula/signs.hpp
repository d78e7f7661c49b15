#pragma once

#include <string>
#include <string_view>

namespace oddity::formula {

enum class Role { letter, relation, sign, opening, closing, large, accent, font, function };

/// A command of TeX, or a sign that represents itself.
struct Sign {
  std::string_view tex;
  std::string_view shown;  ///< in Unicode; for a font, its capital A
  Role role;
};

/// Null for an unknown command of TeX.
const Sign* sign_of(std::string_view tex);
bool has_role(std::string_view tex, Role role);

/// The code point of a UTF-8 character, and the reverse.
char32_t code_point(std::string_view character);
std::string character(char32_t code_point);

}  // namespace oddity::formula
