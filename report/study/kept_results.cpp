#include "report/study/kept_results.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/own.hpp"
#include "reference/table.hpp"
#include "report/study/earlier_results.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

bool is_own(const Entry& entry) { return !own_reference_folder(entry.file).empty(); }

/// The table belongs to an exercise outside the tree, by the number that its name begins with.
bool is_for_own(const truth::Entry& generator) {
  return !generator.home.empty() && std::ranges::any_of(registry(), [&](const Entry& entry) {
    const auto two_digits = [](int n) { return (n < 10 ? "0" : "") + std::to_string(n) + "_"; };
    return is_own(entry) &&
           generator.name.starts_with(two_digits(entry.number.chapter) + two_digits(entry.number.index));
  });
}

/// Empty if it cannot be read.
std::string text_in(const fs::path& file) {
  std::error_code unknown;
  return fs::exists(file, unknown) ? read_whole(file) : "";
}

/// Adds checksums of the tables and ledgers in the folder. Tables of exercises outside the tree count only
/// for these.
MadeFrom with_reference(MadeFrom code, const fs::path& folder) {
  const std::string all = checksum_of_tables(folder),
                    of_tree = checksum_of_tables(folder, [](const auto&m) { return !is_for_own(m); });
  for (const Entry& entry : registry()) {
    const fs::path ledger = folder / "ledger" / (to_string(entry.number) + ".csv");
    code[entry.number] = "code " + code[entry.number] + ", tables " + (is_own(entry) ? all : of_tree) +
                         ", ledger " + checksum(text_in(ledger));
  }
  return code;
}

}  // namespace

MadeFrom made_from(const std::string& of_build, const std::string& program, const fs::path& folder) {
  MadeFrom code;
  for (const Entry& entry : registry()) code[entry.number] = program;
  std::istringstream lines(of_build);
  for (std::string number, hash; lines >> number >> hash;)
    if (const auto known = exercise_number(number); known && hash.size() == 64) code[*known] = hash;
  return with_reference(std::move(code), folder);
}

MadeFrom made_from(const fs::path& folder) {
  const fs::path program = program_file();
  return made_from(text_in(program.string() + ".made_from"), checksum_of_program(), folder);
}

Results noted(Results results, const MadeFrom& made_from) {
  for (ExerciseResult& e : results.exercises) e.made_from = made_from.at(e.number);
  return results;
}

Results kept_results(const fs::path& file, const MadeFrom& made_from) try {
  Results results = read_results(file);
  std::erase_if(results.exercises, [&](const ExerciseResult& e) {
    const auto here = made_from.find(e.number);
    return here == made_from.end() || e.made_from != here->second || !e.failure.empty() ||
           !undeclared(e).empty();
  });
  return results;
} catch (const BadInput&) {
  return {};
}

Results completed(Results results, std::span<const Task> tasks,
                  const std::function<bool(const ExerciseResult&)>& is_whole, const MakeResults& make) {
  std::map<Number, ExerciseResult> all;
  for (ExerciseResult& e : results.exercises) all[e.number] = std::move(e);
  results.exercises.clear();
  std::vector<Task> lacking;
  Results made = results;
  for (const Task& task : tasks) {
    const auto found = all.find(task.entry->number);
    if (found != all.end() && is_whole(found->second)) continue;
    lacking.push_back(task);
    ExerciseResult& e = made.exercises.emplace_back();
    e.number = task.entry->number;
    if (found != all.end()) e = std::move(found->second);
  }
  if (!lacking.empty()) {
    made = make(std::move(made), lacking);
    if (std::isfinite(made.seam)) results.seam = made.seam;
    for (ExerciseResult& e : made.exercises) all[e.number] = std::move(e);
  }
  for (const Task& task : tasks) results.exercises.push_back(std::move(all.at(task.entry->number)));
  return results;
}

}  // namespace oddity
