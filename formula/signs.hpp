#pragma once

#include <string>
#include <string_view>

namespace oddity::formula {

enum class Role { letter, relation, sign, opening, closing, large, accent, font, function };

/// A command of TeX, or a sign that stands for itself.
struct Sign {
  std::string_view tex;
  std::string_view shown;  ///< in Unicode; of a font, where its capital A stands
  Role role;
};

/// Null where TeX's command is none that is known.
const Sign* sign_of(std::string_view tex);
bool has_role(std::string_view tex, Role role);

/// The number of a character of UTF-8, and the other way about.
char32_t code_point(std::string_view character);
std::string character(char32_t code_point);

}  // namespace oddity::formula
