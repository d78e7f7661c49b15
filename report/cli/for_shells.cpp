#include "report/cli/for_shells.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "chapters/contents.hpp"
#include "report/cli/words.hpp"

namespace oddity {

namespace {

using Verbs = std::vector<const CLI::App*>;

/// Omits verbs without a group, which are hidden.
Verbs verbs_of(const CLI::App& app) {
  Verbs verbs = app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
  return verbs;
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

// ---- completion -------------------------------------------------------------------------------------------

std::string names_of(const Verbs& verbs) {
  std::vector<std::string> names;
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  return joined(names, " ");
}

std::string options_in_words(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options_of(app))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return joined(names, " ");
}

/// The lines of the script's table for a verb and its subcommands.
std::string table_of(const CLI::App& app, const std::string& path) {
  const Verbs within = verbs_of(app);
  std::string text =
      "    '" + path + "') verbs='" + names_of(within) + "' options='" + options_in_words(app) + "' ;;\n";
  for (const CLI::App* verb : within) text += table_of(*verb, path + "/" + verb->get_name());
  return text;
}

// ---- the manual page --------------------------------------------------------------------------------------

std::string in_troff(std::string_view text) {
  std::string made;
  for (char c : text) made += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return made.starts_with('.') || made.starts_with('\'') ? "\\&" + made : made;
}

/// Leaves lines that begin with a blank unchanged.
std::string paragraphs(const std::string& text) {
  std::istringstream lines(text);
  std::string made;
  for (std::string line; std::getline(lines, line);)
    made += line.starts_with(' ') ? ".nf\n" + in_troff(line) + "\n.fi\n" : ".PP\n" + in_troff(line) + "\n";
  return made;
}

std::string option_in_troff(const CLI::Option& option) {
  const bool takes = !option.get_type_name().empty() && !option.get_positional();
  const std::string usual = option.get_default_str();
  const bool has_usual = takes && !usual.empty() && option.get_type_name() != "PATH";
  return ".TP\n.B " + in_troff(option.get_name(option.get_positional(), true)) +
         (takes ? " " + in_troff(option.get_type_name() + (has_usual ? "=" + usual : "")) : "") + "\n" +
         in_troff(option.get_description()) + "\n";
}

std::string verb_in_troff(const CLI::App& verb, const std::string& name) {
  std::string text = ".SS " + in_troff(name) + "\n" + in_troff(verb.get_description()) + "\n";
  for (const CLI::Option* option : options_of(verb)) text += option_in_troff(*option);
  text += paragraphs(verb.get_footer());
  for (const CLI::App* within : verbs_of(verb))
    text += verb_in_troff(*within, name + " " + within->get_name());
  return text;
}

}  // namespace

std::string completion_of(const CLI::App& app) {
  std::vector<std::string> numbers;
  for (const Entry& entry : registry()) numbers.push_back(to_string(entry.number));
  return R"(# Completion of oddity's verbs, options and exercises, as `oddity --completion` writes it. It runs nothing.
_oddity_words() {
  case $1 in
)" + table_of(app, "") +
         R"(    *) return 1 ;;
  esac
}
_oddity() {
  local word=${COMP_WORDS[COMP_CWORD]} path= verbs options i
  for ((i = 1; i < COMP_CWORD; i++)); do
    [[ ${COMP_WORDS[i]} != [a-z]* ]] || ! _oddity_words "$path/${COMP_WORDS[i]}" || path+=/${COMP_WORDS[i]}
  done
  [ "$path" != /help ] || path=
  _oddity_words "$path"
  [[ $word != -* ]] || verbs=$options
  COMPREPLY=($(compgen -W "${verbs:-)" +
         joined(numbers, " ") + R"(}" -- "$word"))
  [ ${#COMPREPLY[@]} -gt 0 ] || COMPREPLY=($(compgen -f -- "$word"))
}
complete -F _oddity oddity
)";
}

std::string manual_of(const CLI::App& app, const std::string& version) {
  std::string text =
      ".TH ODDITY 1 \"\" \"oddity " + version +
      "\"\n.SH NAME\noddity \\- the solutions of Game Physics, checked by machine\n.SH SYNOPSIS\n.B oddity\n[options] "
      "[verb ...]\n.SH DESCRIPTION\n" +
      in_troff(app.get_description()) + "\n.SH OPTIONS\n";
  for (const CLI::Option* option : options_of(app)) text += option_in_troff(*option);
  text += ".SH VERBS\n";
  for (const CLI::App* verb : verbs_of(app))
    if (verb->get_name() != "help") text += verb_in_troff(*verb, verb->get_name());
  return text + ".SH NOTES\n" + paragraphs(app.get_footer());
}

}  // namespace oddity
