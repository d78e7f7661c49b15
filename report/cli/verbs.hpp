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

/// Implementations of the verbs. Each takes the folder of the reference tables, prints its output on standard
/// output, and throws BadInput.
namespace oddity::verbs {

namespace fs = std::filesystem;

/// Finds exercises by number or by words of their titles; all if none is given.
void list(const std::vector<std::string>& exercises, Format, const OtherEngines&);
/// `overrides` are "name=value". JSON has everything; CSV only the trials.
void solve(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           bool enclosed, Format);

/// Returns 0 if something meets the need, otherwise 1. `command` is the command line, for the code's comment;
/// `engine` is a third-party engine to compare, unless empty.
int choose(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           const AskedNeed&, Format, bool all_rows, const std::string& engine, const std::string& command,
           const std::string& language, const Extras&);
/// Writes the report of one chapter; of all if `chapter` is empty.
void report(const fs::path& folder, const std::string& chapter, Edition, const fs::path& out, bool overwrite);
/// Shows the proofs, enclosures, witnesses and surviving mutants, and their basis.
void trust(const fs::path& folder, Format);
/// Writes the site of all exercises.
void site(const fs::path& folder, const fs::path& out, bool overwrite);
/// Writes the page of a problem's file into a separate folder.
void site_of_file(const fs::path& folder, const std::string& file, const fs::path& out, bool overwrite);
/// Writes the page of one exercise, or of a problem's file, as a file.
void single(const fs::path& folder, const std::string& exercise, const fs::path& out, bool overwrite);
/// Requirements for compiling the models to WebAssembly.
Needs needs_of_site();
/// Throws BadInput before a run when the report, the site or the results could not be written.
void require_room_for_all(const fs::path& report_out, const fs::path& site_out);
/// Writes the report and the site of the last results, and prints the summary of a whole run.
void publish(const fs::path& folder, const fs::path& report_out, const fs::path& site_out, bool as_on_record,
             const std::function<double()>& seconds);
/// Draws charts of these exercises; of all if none is given.
void chart(const fs::path& folder, const std::vector<std::string>& exercises, const AskedNeed&, Curves,
           const fs::path& out, bool overwrite, const OtherEngines&);
/// Prints the trials that the charts show, without drawing.
void chart_table(const fs::path& folder, const std::vector<std::string>& exercises, const AskedNeed&, Format);
struct AskedStability {
  std::vector<std::string> words;  ///< scenes by number, one of them with other parameters; empty: all
  std::string horizon;             ///< empty: the scenes' own
  AskedNeed need;                  ///< errors and criteria, for the named exercises
};
/// Prints text, and draws the maps.
void stability(const fs::path& folder, const AskedStability&, const fs::path& out, bool overwrite);
/// Prints a table of limits, without drawing.
void stability_table(const fs::path& folder, const AskedStability&, Format);
/// Prints the rows that would approve the limits and maps of unchanged scenes.
void stability_rows(const fs::path& folder, const AskedStability&);
/// Judges the claims of a problem's file. Returns 1 if a verdict differs from the one that the file expects.
int judge(const std::string& file, Format);
/// Writes a commented problem's file, or a scene of the book as one. Throws BadInput if the file exists.
void create_problem(const fs::path& file, const std::string& from_exercise);
/// Writes the files of a new exercise, and shows the next steps.
void create(NewExercise);

}  // namespace oddity::verbs
