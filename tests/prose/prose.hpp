#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A linter of English prose: comments and texts of sources, and Markdown.
///   const auto rules = prose::rules_of(text_of("tests/prose/words.txt"));
///   for (const auto& passage : prose::passages_in("a.hpp", "/// Of the next setting.\n"))
///     for (const auto& fault : prose::faults_in(passage, rules)) report(fault.line, fault.kind,
///     fault.remedy);
namespace oddity::prose {

/// Paragraph of a file, without comment signs and without line breaks.
struct Passage {
  std::string text;
  std::size_t line;  ///< line of its first word, from 1
};

/// Comments, and texts of four words or more, of a C++, JavaScript or CSS file; comments of a shell or CMake
/// file; paragraphs of a Markdown file without its blocks of code. Nothing for other extensions.
std::vector<Passage> passages_in(const std::filesystem::path& file, std::string_view text);

/// Words in a row that a better wording replaces. Each place has its alternatives; `at_start` ties the first
/// to the start of a passage.
struct Rule {
  std::string kind;
  std::vector<std::vector<std::string>> words;
  bool at_start;
  std::string remedy;
};

/// Reads lines "kind: word word|other -> remedy"; '^' before the words is the passage's start, '#' begins a
/// comment.
/// @throws std::invalid_argument with the first line that is not a rule
std::vector<Rule> rules_of(std::string_view text);

struct Fault {
  std::size_t line;
  std::string kind, found, remedy;
};

/// A place that stays as it is: its file, the kind of fault, and the words that it begins with. Without
/// words: every fault of that kind in the file.
struct Accepted {
  std::string file, kind, words;
};

/// Reads lines "file: kind: words -> reason"; '#' begins a comment.
/// @throws std::invalid_argument with the line that is none
std::vector<Accepted> accepted_in(std::string_view text);

/// Longest sentence, in words, that needs no second reading.
inline constexpr std::size_t longest_sentence = 30;

/// Every place where a rule applies, questions left out, and every longer sentence.
std::vector<Fault> faults_in(const Passage& passage, const std::vector<Rule>& rules);

}  // namespace oddity::prose
