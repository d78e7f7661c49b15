#include "report/cli/help.hpp"

#include <string>
#include <string_view>

namespace oddity {

namespace {

constexpr std::size_t widest_help = 100, names_column = 24;

/// A footer's examples, which are its end, and the notes before them.
struct Footer {
  explicit Footer(const std::string& text)
      : notes(text.substr(0, text.find(head))), examples(text.substr(notes.size())) {}
  static constexpr std::string_view head = "Examples:\n";
  std::string notes, examples;
};

/// The examples come before the options.
class Help : public CLI::Formatter {
 public:
  explicit Help(const Screen& screen)
      : screen_{screen.width == 0 ? widest_help : std::min(widest_help, screen.width), screen.colour} {
    column_width(names_column);
    label("SUBCOMMAND", "VERB ...");
    label("OPTIONS", "options");
  }

  std::string make_description(const CLI::App* app) const override {
    return wrapped(app->get_description(), screen_) + "\n";
  }
  std::string make_usage(const CLI::App* app, std::string name) const override {
    const std::string usage = wrapped(CLI::Formatter::make_usage(app, std::move(name)), screen_, 2);
    const std::string examples = Footer(app->get_footer()).examples;
    return examples.empty() ? usage : usage + "\n" + wrapped(examples, screen_, 2) + "\n";
  }
  std::string make_footer(const CLI::App* app) const override {
    return wrapped(Footer(app->get_footer()).notes, screen_, 2) + "\n";
  }
  std::string make_group(std::string group, bool positional,
                         std::vector<const CLI::Option*> options) const override {
    std::string text = "\n" + screen_.styled(Style::heading, group + ":") + "\n";
    for (const CLI::Option* option : options) text += make_option(option, positional);
    return text;
  }
  std::string make_subcommand(const CLI::App* verb) const override {
    return row(verb->get_name(), verb->get_description());
  }
  std::string make_option(const CLI::Option* option, bool positional) const override {
    return row(make_option_name(option, positional) + taken_by(*option), option->get_description());
  }

 private:
  /// " FOLDER=/tmp" for an option that takes a value.
  static std::string taken_by(const CLI::Option& option) {
    if (option.get_type_size() == 0 || option.get_positional()) return "";
    const std::string usual = option.get_default_str();
    return " " + option.get_type_name() + (usual.empty() ? "" : "=" + usual);
  }

  std::string row(const std::string& name, const std::string& says) const {
    const std::string begin = "  " + name;
    const std::size_t least = names_column + 20;
    const Screen screen{std::max(screen_.width, least), false};
    const bool beside = begin.size() + 2 <= names_column;
    const std::string gap =
        beside ? std::string(names_column - begin.size(), ' ') : "\n" + std::string(names_column, ' ');
    const std::string text = wrapped(std::string(names_column, ' ') + says, screen, names_column);
    return begin + gap + text.substr(names_column) + "\n";
  }

  Screen screen_;
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_for(const Screen& screen) { return std::make_shared<Help>(screen); }

}  // namespace oddity
