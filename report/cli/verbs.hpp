#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/charts/chart.hpp"
#include "report/cli/asked.hpp"
#include "report/cli/extras.hpp"
#include "report/cli/needs.hpp"
#include "report/cli/new_exercise.hpp"
#include "report/cli/verb.hpp"
#include "report/pages/markdown.hpp"

/// What the program's verbs do. Each takes the folder of the reference tables, prints what is asked on
/// standard output, and throws BadInput.
namespace oddity::verbs {

namespace fs = std::filesystem;

/// By number or by words of their titles; all of them when there are none.
void list(const std::vector<std::string>& exercises, Format, const OtherEngines&);
/// `overrides` are "name=value". As JSON everything; as CSV the trials.
void solve(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           bool enclosed, Format);

/// 0 when something meets the need, else 1. `command` is the command line, for the code's comment;
/// `engine` one of others to be tried beside, unless empty.
int choose(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           const AskedNeed&, Format, bool all_rows, const std::string& engine, const std::string& command,
           const Extras&);
/// Of all chapters when the text is empty.
void report(const fs::path& folder, const std::string& chapter, Edition, const fs::path& out, bool overwrite);
/// What is proved, enclosed, witnessed and survived, and what that rests on.
void trust(const fs::path& folder, Format);
/// The report that runs, of all exercises.
void site(const fs::path& folder, const fs::path& out, bool overwrite);
/// A page of a problem's file, in a folder of its own.
void site_of_file(const fs::path& folder, const std::string& file, const fs::path& out, bool overwrite);
/// The page of one exercise, or of a problem's file, as a file.
void single(const fs::path& folder, const std::string& exercise, const fs::path& out, bool overwrite);
/// The compiler of its models.
Needs needs_of_site();
/// Throws BadInput when the report, the site or the results could not be written, before a run.
void require_room_for_all(const fs::path& report_out, const fs::path& site_out);
/// The report and the site of the last results, and the screen that a whole run ends with.
void publish(const fs::path& folder, const fs::path& report_out, const fs::path& site_out, bool as_on_record,
             const std::function<double()>& seconds);
/// Of all exercises when there are none.
void chart(const fs::path& folder, const std::vector<std::string>& exercises, const AskedNeed&, Curves,
           const fs::path& out, bool overwrite, const OtherEngines&);
/// The trials that the charts show, with nothing drawn.
void chart_table(const fs::path& folder, const std::vector<std::string>& exercises, const AskedNeed&, Format);
struct AskedStability {
  std::vector<std::string> words;  ///< scenes by number, one of them with other parameters; none: all
  std::string horizon;             ///< empty: the scenes' own
  AskedNeed need;                  ///< its errors and criteria, of exercises that are named
};
/// As text, with the maps drawn.
void stability(const fs::path& folder, const AskedStability&, const fs::path& out, bool overwrite);
/// The same as a table of limits, with nothing drawn.
void stability_table(const fs::path& folder, const AskedStability&, Format);
/// Of scenes as they are, as the rows that would put the limits and maps on record.
void stability_rows(const fs::path& folder, const AskedStability&);
/// The claims of a problem's file, and 1 where one has another verdict than the file itself expects.
int judge(const std::string& file, Format);
/// Writes a problem's file to begin with, or a scene of the book as one. Throws BadInput where one is there.
void create_problem(const fs::path& file, const std::string& from_exercise);
/// Writes the files of a new exercise, and says what to do next.
void create(NewExercise);

}  // namespace oddity::verbs
