#pragma once

#include <string>
#include <string_view>

#include "report/study/choose.hpp"

/// What `choose` has chosen as a short program: the model's operations as they were recorded, written by the
/// printers of formula/, and the algorithm's loop.
namespace oddity {

enum class Language { cpp, c_sharp, javascript };
inline constexpr std::string_view language_names[] = {"C++", "C#", "JavaScript"};
/// Also by its short name: cpp, cs, js. Throws BadInput where there is no such language.
Language language_of(std::string_view name);
/// Throws BadInput where no choice for this need has code in the language.
void require_language(Language, const Task&, const Need&);

/// Headed by a comment about it. Throws BadInput where the choice cannot be written so, and says why.
std::string program_in(Language, const Task&, const Candidate&, const Need&, const std::string& about);

}  // namespace oddity
