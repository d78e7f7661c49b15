// Catch2's implementation, where version 2 has it in its header, and all that needs to see a whole session.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_RUNNER
#endif
#include "tests/catch_main.hpp"

#include <unistd.h>

#include "reference/bad_input.hpp"
#include "report/pages/screen.hpp"
#include "tests/catch.hpp"

namespace oddity {

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

std::vector<std::string> CatchSession::selected() const {
  Catch::Config& config = session_->configured();
  const auto& all = Catch::getAllTestCasesSorted(config);
  std::vector<std::string> names;
  for (const auto& test : config.hasTestFilters() ? Catch::filterTests(all, config.testSpec(), config) : all)
    names.push_back(name_of(test));
  return names;
}

int CatchSession::run() {
  const int failed = session_->catch2.run();
  session_.reset();  // which flushes what it has to write
  for (Collected& output : outputs_) output.deliver();
  return failed;
}

}  // namespace oddity
