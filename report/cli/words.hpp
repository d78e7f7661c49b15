#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// A command line as words, and what is wrong with it in the program's own.
namespace oddity {

/// Without the program; "help solve" is "solve --help".
std::vector<std::string> words_of(int argc, char** argv);
/// "a, b, c".
std::string joined(const std::vector<std::string>& texts, const std::string& between = ", ");
/// A word as a shell takes it: in quotes where it needs them.
std::string for_shell(const std::string& word);
/// The words as a shell takes them, after the program's name.
std::string typed(const std::vector<std::string>& words);
/// The first word that is no option of the program's own is its verb. Throws BadInput.
void require_a_verb(const CLI::App&, const std::vector<std::string>& words);
/// What CLI11 complains of.
std::string complaint_of(const CLI::App&, const CLI::ParseError&);

}  // namespace oddity
