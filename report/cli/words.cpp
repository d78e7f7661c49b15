#include "report/cli/words.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/similar.hpp"
#include "report/cli/asked.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

namespace {

std::vector<std::string> names_of_verbs(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands({})) names.push_back(one->get_name());
  return names;
}

void require_verb(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> names = names_of_verbs(app);
  if (std::ranges::find(names, word) != names.end()) return;
  if (exercise_number(word)) throw BadInput("no verb '" + word + "'; did you mean 'solve " + word + "'?");
  throw BadInput("no verb '" + word + "'; the verbs are: " + joined(names) + did_you_mean(word, names));
}

/// "sweep plan ", with its parent verbs; empty for the program itself.
std::string typed_before_options(const CLI::App& app) {
  return app.get_parent() ? typed_before_options(*app.get_parent()) + app.get_name() + " " : "";
}

std::string help_of(const CLI::App& app) {
  return "'" + program_as_typed() + " " + typed_before_options(app) + "--help' shows more";
}

/// The verb that was used, or its subcommand.
const CLI::App& innermost(const CLI::App& app) {
  const auto used = app.get_subcommands();
  return used.empty() ? app : innermost(*used.front());
}

std::string refusal(const CLI::App& app, const std::string& word) {
  std::vector<std::string> options;
  for (const CLI::Option* option : app.get_options()) options.push_back(option->get_name());
  const std::string meant =
      word.starts_with('-') ? did_you_mean(word.substr(0, word.find('=')), options) : "";
  return app.get_name() + " does not take '" + word + "'" + meant + (meant.empty() ? "; " : " ") +
         help_of(app);
}

}  // namespace

std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.push_back("--help");
  }
  return words;
}

void require_verbs_alone(const CLI::App& app, int argc, char** argv) {
  const CLI::App* verb = &app;
  if (argc < 2 || std::string_view(argv[1]) != "help") return;
  for (int i = 2; i < argc; ++i) {
    if (std::string_view(argv[i]).starts_with("-")) continue;
    const std::vector<std::string> within = names_of_verbs(*verb);
    if (verb == &app) require_verb(app, argv[i]);
    if (std::ranges::find(within, argv[i]) == within.end())
      throw BadInput("help of '" + verb->get_name() + "' has no '" + argv[i] + "'" +
                     (within.empty() ? "; '" + program_as_typed() + " help " + verb->get_name() + "' says all"
                                     : "; its verbs are: " + joined(within)));
    verb = verb->get_subcommand(argv[i]);
  }
}

void require_each_once(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* verb = &app;
  std::set<const CLI::Option*> given;
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    if (!name.starts_with('-')) {
      const auto within = names_of_verbs(*verb);
      if (std::ranges::find(within, words[i]) != within.end()) verb = verb->get_subcommand(words[i]);
      continue;
    }
    const CLI::Option* option = verb->get_option_no_throw(name);
    if (!option) continue;
    const bool is_flag = option->get_items_expected_max() == 0, has_value = name != words[i];
    if (is_flag && has_value) throw BadInput(name + " takes no value; " + help_of(*verb));
    if (!given.insert(option).second && option->get_items_expected_max() <= 1)
      throw BadInput(name + " is given twice");
    if (!is_flag && !has_value && i + 1 < words.size() && !words[i + 1].starts_with('-')) ++i;
  }
}

std::string joined(const std::vector<std::string>& texts, const std::string& between) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : between) + text;
  return all;
}

std::string for_shell(const std::string& word) {
  std::string quoted;
  for (char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  const bool plain = std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) || c >= 0x80 ||
           std::string_view("-_=.,:/+%@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  return plain && !word.empty() ? word : "'" + quoted + "'";
}

std::string typed(const std::vector<std::string>& words) {
  std::string all = program_as_typed();
  for (const std::string& word : words) all += " " + for_shell(word);
  return all;
}

void require_a_verb(const CLI::App& app, const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with('-')) return require_verb(app, words[i]);
    if (!app.get_option_no_throw(words[i].substr(0, words[i].find('='))))
      throw BadInput(refusal(app, words[i]));
    if (words[i] == "--reference") ++i;
  }
}

std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& verb = innermost(app);
  const std::vector<std::string> unknown = verb.remaining(), within = names_of_verbs(verb);
  if (verb.get_parent() && !within.empty())
    return verb.get_name() + " needs one of its verbs: " + joined(within) +
           (unknown.empty() ? "" : did_you_mean(unknown.front(), within)) + "; " + help_of(verb);
  if (!unknown.empty() && !verb.get_allow_extras()) return refusal(verb, unknown.front());
  const std::string says = error.what();
  if (error.get_name() == "ArgumentMismatch")
    return says.substr(0, says.find(':')) + " needs a value; " + help_of(verb);
  if (const auto at = says.find(" excludes "); at != std::string::npos)
    return says.substr(0, at) + " and " + says.substr(at + 10) + " do not go together; " + help_of(verb);
  return says + "; " + help_of(verb);
}

CLI::Option* add_path(CLI::App& verb, const std::string& name, std::string& path, const std::string& says) {
  return verb.add_option(name, path, says)
      ->type_name("PATH")
      ->capture_default_str()
      ->check(not_empty("a path"));
}

CLI::Option* add_count(CLI::App& verb, const std::string& name, int& value, int least, int most,
                       const std::string& says) {
  return verb
      .add_option_function<std::string>(
          name, [=, &value](const std::string& text) { value = count_of(name, text, least, most); }, says)
      ->type_name("N")
      ->default_str(value >= least ? std::to_string(value) : "");
}

}  // namespace oddity
