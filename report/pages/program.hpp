#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "report/study/choose.hpp"

/// What `choose` has chosen as a short program: the model's operations as they were recorded, written by the
/// printers of formula/, and the algorithm's loop.
namespace oddity {

enum class Language { cpp, c_sharp, javascript };
inline constexpr std::string_view language_names[] = {"C++", "C#", "JavaScript"};
/// Throws BadInput where there is no such language.
Language language_of(std::string_view name);

/// Each line as a comment of one line.
std::string as_comment(const std::string& text);

/// Headed by a comment about it. Throws BadInput where the choice cannot be written so, and says why.
std::string program_in(Language, const Task&, const Candidate&, const Need&, const std::string& about);

}  // namespace oddity
