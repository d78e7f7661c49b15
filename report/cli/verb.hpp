#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <initializer_list>
#include <string>

#include "report/cli/asked.hpp"
#include "report/cli/needs.hpp"
#include "report/cli/words.hpp"
#include "report/text/screen.hpp"
#include "report/text/table_text.hpp"

/// Shared parts of the command line's verbs, including those of extras/.
namespace oddity {

namespace verbs {

enum class Format { text, json, csv, code };

/// The screen for standard output.
Screen output();
/// Prints a table as JSON or CSV.
void print(const Table&, Format);

}  // namespace verbs

/// Options that select a format.
struct Formats {
  bool json = false, csv = false, code = false;

  verbs::Format format() const {
    return json   ? verbs::Format::json
           : csv  ? verbs::Format::csv
           : code ? verbs::Format::code
                  : verbs::Format::text;
  }
};

/// Adds a verb. `shows_needs`: if needs are asked for, it prints them and does nothing; other verbs need
/// nothing.
CLI::App* add_verb(CLI::App&, const std::string& name, const std::string& says, const std::string& footer,
                   const std::function<void()>& act, bool shows_needs = false);
void add_formats(CLI::App& verb, Formats&, const std::string& what);
/// `of`: the purpose of the limit, if it is not for the answer.
void add_time_limit(CLI::App& verb, std::string& limit, const std::string& of = "");
/// Options for the criterion and its error.
void add_criteria(CLI::App& verb, AskedNeed&);
/// Options for frames of varying length, at any rate.
void add_varied_frames(CLI::App& verb, AskedNeed&);
/// Options for frames of varying length, for a verb with --fps.
void add_frames(CLI::App& verb, AskedNeed&);
void add_kick(CLI::App& verb, AskedNeed&);
/// The option does not go together with the others.
void set_apart(CLI::App& verb, CLI::Option*, std::initializer_list<const char*> others);

}  // namespace oddity
