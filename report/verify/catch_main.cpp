// Catch2's implementation, which version 2 has in its header, and the code that needs a whole session.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_RUNNER
#endif
#include "report/verify/catch_main.hpp"

#include <unistd.h>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/text/screen.hpp"
#include "report/verify/catch.hpp"

namespace oddity {

namespace {

/// Requires that a file of test names can be read: -f FILE, -sf FILE, --input-file FILE, or with = or :
/// instead of the blank.
void require_readable_names(const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t end = words[i].find_first_of("=:");
    const std::string option = words[i].substr(0, end);
    if (option != "--input-file" &&
        !(option.size() > 1 && option[0] == '-' && option[1] != '-' && option.back() == 'f'))
      continue;
    if (end != std::string::npos)
      read_whole(words[i].substr(end + 1));
    else if (i + 1 < words.size())
      read_whole(words[i + 1]);
  }
}

/// The filter as it was typed: Catch2 3.7 puts names into quotes.
std::string without_quotes(const std::string& filter) {
  return filter.size() > 1 && filter.front() == '"' && filter.back() == '"'
             ? filter.substr(1, filter.size() - 2)
             : filter;
}

/// Whether the '~' at this place negates the next part, and does not belong to a name.
bool negates(const std::string& text, std::size_t at) {
  const auto before = text.find_last_not_of(' ', at == 0 ? text.npos : at - 1);
  return at == 0 || before == text.npos ||
         std::string_view("],\"~").find(text[before]) != std::string_view::npos;
}

/// The tags of a test specification, "[ch3]~[scene],name*". Throws BadInput for empty or incomplete parts,
/// which Catch2 would ignore.
std::vector<std::string> tags_in(const std::string& specification) {
  const auto refuse = [&](const std::string& why) {
    throw BadInput("the test specification '" + specification + "' " + why);
  };
  std::vector<std::string> tags;
  bool is_nothing = true, is_negated = false;
  const auto end_part = [&] {
    if (is_negated) refuse("excludes nothing behind its '~'");
    if (is_nothing) refuse("has an empty part next to a comma");
    is_nothing = true;
  };
  for (std::size_t i = 0; i < specification.size(); ++i) {
    const char c = specification[i];
    if (c == ' ') continue;
    if (c == ',') {
      end_part();
      continue;
    }
    if (c == '~' && negates(specification, i)) {
      if (is_negated) refuse("has two '~' together");
      is_negated = true;
      continue;
    }
    is_nothing = is_negated = false;
    if (c == '\\' && ++i == specification.size()) refuse("ends with a backslash");
    if (c != '[' && c != '"') continue;
    const auto end = specification.find(c == '[' ? ']' : '"', i + 1);
    if (end == specification.npos)
      refuse(std::string("has no '") + (c == '[' ? "]" : "\"") + "' for its '" + c + "'");
    if (end == i + 1) refuse("has an empty " + std::string(c == '[' ? "tag" : "name"));
    if (c == '[') tags.push_back(specification.substr(i, end + 1 - i));
    i = end;
  }
  end_part();
  return tags;
}

}  // namespace

struct CatchSession::Session {
  Catch::Session catch2;
  bool accepted = false;

  /// Catch2 opens its output here.
  Catch::Config& configured() try { return catch2.config(); } catch (const std::exception& error) {
    throw BadInput("Catch2: " + std::string(error.what()));
  }
};

CatchSession::CatchSession(const std::vector<std::string>& arguments)
    : session_(std::make_unique<Session>()) {
  std::vector<const char*> words{"oddity"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  require_readable_names(arguments);
  use_colour(session_->catch2.configData(), screen_of(STDOUT_FILENO).colour);
  session_->accepted = session_->catch2.applyCommandLine(static_cast<int>(words.size()), words.data()) == 0;
  if (accepted())
    redirect_outputs(session_->catch2.configData(),
                     [this](const std::string& file) { return outputs_.emplace_back(file).collector(); });
}

CatchSession::~CatchSession() = default;

bool CatchSession::accepted() const { return session_->accepted; }

bool CatchSession::only_lists() const {
  const Catch::ConfigData& data = session_->catch2.configData();
  return data.showHelp || data.listTests || data.listTags || data.listReporters;
}

std::vector<std::string> CatchSession::tags() const {
  std::string all;
  for (const std::string& word : session_->catch2.configData().testsOrTags)
    all += (all.empty() ? "" : " ") + word;
  return all.empty() ? std::vector<std::string>() : tags_in(all);
}

std::vector<std::string> CatchSession::selected() const {
  Catch::Config& config = session_->configured();
  const auto& all = Catch::getAllTestCasesSorted(config);
  std::vector<std::string> names;
  for (const auto& filter : config.testSpec().matchesByFilter(all, config))
    if (filter.tests.empty())
      throw BadInput("no test case matches '" + without_quotes(filter.name) +
                     "'; --list-tests shows them all");
  for (const auto& test : config.hasTestFilters() ? Catch::filterTests(all, config.testSpec(), config) : all)
    names.push_back(name_of(test));
  return names;
}

int CatchSession::run() {
  const int failed = session_->catch2.run();
  session_.reset();  // flushes its output
  for (Collected& output : outputs_) output.deliver();
  return failed;
}

}  // namespace oddity
