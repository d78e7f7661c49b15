#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/study/choose.hpp"

/// The choice of `choose` as a short program: the model's recorded operations, written by the printers of
/// formula/, and the algorithm's loop.
namespace oddity {

enum class Language { cpp, c_sharp, javascript };
inline constexpr std::string_view language_names[] = {"C++", "C#", "JavaScript"};
/// Finds a language by its name or short name: cpp, cs, js. Throws BadInput for other names.
Language language_of(std::string_view name);
/// Throws BadInput where no choice for this need has code in the language.
void require_language(Language, const Task&, const Need&);

/// Writes the program, headed by a comment about it. Throws BadInput with the reason if it cannot be written.
std::string program_in(Language, const Task&, const Candidate&, const Need&, const std::string& about);

/// A part of the model that a program has as a separate function. Its lines of code include its tables.
struct PrintedHelper {
  std::string name;
  long lines;
};
std::vector<PrintedHelper> helpers_in(const std::string& program);

}  // namespace oddity
