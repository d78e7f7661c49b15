#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// Splits a command line into words, and reports its errors in the program's own words.
namespace oddity {

/// The words without the program's name; "help solve" becomes "solve --help".
std::vector<std::string> words_of(int argc, char** argv);
/// Requires a verb, or a verb and its subcommand, after "help". Throws BadInput.
void require_verbs_alone(const CLI::App&, int argc, char** argv);
/// Requires each option at most once, unless it may be repeated, and flags without a value. Throws BadInput.
void require_each_once(const CLI::App&, const std::vector<std::string>& words);
/// "a, b, c".
std::string joined(const std::vector<std::string>& texts, const std::string& between = ", ");
/// A word quoted for a shell if necessary.
std::string for_shell(const std::string& word);
/// The command line for a shell: the program's name and the words.
std::string typed(const std::vector<std::string>& words);
/// Requires the first word that is no global option to be a verb. Throws BadInput.
void require_a_verb(const CLI::App&, const std::vector<std::string>& words);
/// CLI11's error message in our words.
std::string complaint_of(const CLI::App&, const CLI::ParseError&);

// ---- options ----------------------------------------------------------------------------------------------

/// Refuses an empty value, such as "$SHARD" without such a variable.
inline auto not_empty(const std::string& what) {
  return [what](const std::string& given) { return given.empty() ? "it needs " + what : std::string(); };
}
/// Adds a path option. Refuses an empty path, which would mean the current folder.
CLI::Option* add_path(CLI::App&, const std::string& name, std::string& path, const std::string& says);
template <class T>
CLI::Option* add_value(CLI::App& verb, const std::string& name, T& value, const std::string& type,
                       const std::string& says) {
  return verb.add_option(name, value, says)->type_name(type)->check(not_empty("a value"));
}
/// A whole number within these bounds, in digits.
CLI::Option* add_count(CLI::App&, const std::string& name, int& value, int least, int most,
                       const std::string& says);

}  // namespace oddity
