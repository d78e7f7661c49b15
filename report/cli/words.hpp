#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// A command line as words, and what is wrong with it in the program's own.
namespace oddity {

/// Without the program; "help solve" is "solve --help".
std::vector<std::string> words_of(int argc, char** argv);
/// Behind "help" stands a verb, or one and another within it. Throws BadInput.
void require_verbs_alone(const CLI::App&, int argc, char** argv);
/// No option stands twice, unless it is one of those that may, and no flag has a value. Throws BadInput.
void require_each_once(const CLI::App&, const std::vector<std::string>& words);
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

// ---- options ----------------------------------------------------------------------------------------------

/// For what is asked for and would be nothing, as "$SHARD" without such a variable.
inline auto not_empty(const std::string& what) {
  return [what](const std::string& given) { return given.empty() ? "it needs " + what : std::string(); };
}
/// A path that is asked for is not empty, which would be the current folder.
CLI::Option* add_path(CLI::App&, const std::string& name, std::string& path, const std::string& says);
template <class T>
CLI::Option* add_value(CLI::App& verb, const std::string& name, T& value, const std::string& type,
                       const std::string& says) {
  return verb.add_option(name, value, says)->type_name(type)->check(not_empty("a value"));
}
/// A whole number between these, in digits.
CLI::Option* add_count(CLI::App&, const std::string& name, int& value, int least, int most,
                       const std::string& says);

}  // namespace oddity
