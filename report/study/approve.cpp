#include "report/study/approve.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/own.hpp"
#include "reference/text.hpp"
#include "report/study/errors.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace {

using RowTexts = std::vector<std::string>;

/// A file of records: its head up to the column names, and the rows of each exercise.
struct Record {
  std::string head;
  std::map<Number, RowTexts> rows;
};

/// A missing file gives a record without rows, with the head of `like`.
Record read_record(const std::filesystem::path& file, const std::filesystem::path& like) {
  if (file != like && !std::filesystem::exists(file)) return {read_record(like, like).head, {}};
  std::istringstream in(read_whole(file));
  Record record;
  bool in_head = true;
  Number number;
  for (std::string line; std::getline(in, line);) {
    if (in_head) {
      record.head += line + "\n";
      in_head = line.empty() || line.starts_with('#');
      continue;
    }
    if (const auto found = exercise_number(line.substr(0, line.find_first_of("-,")))) number = *found;
    record.rows[number].push_back(line);
  }
  return record;
}

std::string text_of(const Record& record) {
  std::string text = record.head;
  for (const auto& [number, rows] : record.rows)
    for (const std::string& row : rows) text += row + "\n";
  return text;
}

RowTexts lines_of(const std::string& text) {
  RowTexts lines;
  for (std::size_t from = 0, end; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
    lines.push_back(text.substr(from, end - from));
  return lines;
}

RowTexts verdict_rows(const ExerciseResult& e) {
  RowTexts rows;
  for (const JudgedClaim& c : e.claims)
    if (c.verdict != Verdict::unsettled) rows.push_back(c.claim.id + "," + std::string(name_of(c.verdict)));
  return rows;
}

bool approvable(const ExerciseResult& e) {
  return e.failure.empty() &&
         std::ranges::all_of(e.quantities, [](const QuantityResult& q) { return finite(q.reference.value); });
}

/// Empty if there is no file yet.
std::vector<ErrorsOnRecord> errors_on_record(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "errors.csv")) return {};
  return read_errors(folder);
}

/// The rows of `of` that `in` lacks.
RowTexts missing(const RowTexts& of, const RowTexts& in) {
  const std::set<std::string> known(in.begin(), in.end());
  RowTexts rows;
  std::ranges::copy_if(of, std::back_inserter(rows), [&](const auto& row) { return !known.contains(row); });
  return rows;
}

/// Approvals of the exercises whose records are in `folder`; `like` contains all files.
std::vector<Approval> approvals_in(const std::filesystem::path& folder, const std::filesystem::path& like,
                                   const std::vector<const ExerciseResult*>& exercises) {
  const auto of_stability = [](std::string (*text)(const Results&)) {
    return [text](const ExerciseResult& e) { return lines_of(text(Results{{e}})); };
  };
  const std::vector<ErrorsOnRecord> errors = errors_on_record(folder / "approved");
  const std::vector<std::pair<std::string, std::function<RowTexts(const ExerciseResult&)>>> files{
      {"verdicts.csv", verdict_rows},
      {"limits.csv", of_stability(limit_rows)},
      {"stability_maps.csv", of_stability(map_rows)},
      {"errors.csv", [&](const ExerciseResult& e) { return error_rows(e, errors); }}};
  std::vector<Approval> all;
  for (const auto& [name, rows_of] : files) {
    Approval approval{folder / "approved" / name, {}, {}, {}};
    Record record = read_record(approval.file, like / "approved" / name);
    const std::string before = text_of(record);
    for (const ExerciseResult* e : exercises) {
      if (!approvable(*e)) continue;
      RowTexts& rows = record.rows[e->number];
      const RowTexts now = rows_of(*e), added = missing(now, rows), removed = missing(rows, now);
      approval.added.insert(approval.added.end(), added.begin(), added.end());
      approval.removed.insert(approval.removed.end(), removed.begin(), removed.end());
      if (!added.empty() || !removed.empty()) rows = now;
    }
    approval.text = text_of(record);
    if (approval.text != before) all.push_back(std::move(approval));
  }
  return all;
}

}  // namespace

std::vector<Approval> approvals(const Results& results, const std::filesystem::path& folder) {
  std::map<std::filesystem::path, std::vector<const ExerciseResult*>> by_folder;
  for (const ExerciseResult& e : results.exercises) {
    const auto entry = std::ranges::find(registry(), e.number, &Entry::number);
    const auto own = entry == registry().end() ? "" : own_reference_folder(entry->file);
    by_folder[own.empty() ? folder : own].push_back(&e);
  }
  std::vector<Approval> all;
  for (const auto& [records, exercises] : by_folder)
    for (Approval& approval : approvals_in(records, folder, exercises)) all.push_back(std::move(approval));
  return all;
}

namespace {

/// A limit matches the approved one within 5 %; an infinite or zero one matches only its like.
bool same_limit(double measured, double on_record) {
  if (std::isinf(on_record)) return measured == on_record;
  return std::abs(measured - on_record) <= 0.05 * on_record;
}

/// Errors match within a quarter. A missing one matches a missing one, and NaN (the motion did not finish)
/// matches NaN.
bool same_error(const std::optional<TimedTrial>& t, const std::optional<double>& on_record) {
  if (!t || !on_record) return !t && !on_record;
  if (std::isnan(t->error) || std::isnan(*on_record)) return std::isnan(t->error) && std::isnan(*on_record);
  return t->error <= 1.25 * *on_record && *on_record <= 1.25 * t->error;
}

bool same_needed(const std::optional<TimedTrial>& t, const std::optional<double>& on_record) {
  return t && on_record ? same_limit(t->setting, *on_record) : !t && !on_record;
}

std::string shown(const std::optional<double>& number) { return number ? format_shortest(*number) : "none"; }

}  // namespace

std::string difference(const Limit& limit, const ApprovedLimit& approved) {
  std::string all;
  const auto column = [&](const std::string& name, bool same, const std::string& on_record) {
    if (!same) all += (all.empty() ? "" : ", ") + name + " " + (on_record.empty() ? "none" : on_record);
  };
  column("step", same_limit(limit.step(), approved.step), format_shortest(approved.step));
  const bool singular = limit.theory() < 1e-3 * limit.step();  // so its limit counts as zero
  column("theory",
         singular ? approved.theory < 1e-3 * limit.step() : same_limit(limit.theory(), approved.theory),
         format_shortest(approved.theory));
  column("unstable", singular || shown_tongues(limit) == approved.unstable, approved.unstable);
  column("watched", (limit.goes_on || std::isinf(limit.step())) != approved.watched.has_value(),
         shown(approved.watched));
  column("soft", limit.soft.has_value() == !approved.soft.empty(), approved.soft);
  column("error", same_error(limit.at, approved.error), shown(approved.error));
  column("needed", same_needed(limit.within, approved.needed), shown(approved.needed));
  column("beyond", beyond(limit) == approved.beyond, approved.beyond);
  column("why", limit.why == approved.why, approved.why);
  return all;
}

std::string text_of(const std::vector<Approval>& approvals) {
  std::string text;
  for (const Approval& a : approvals) {
    text += a.file.string() + ":\n";
    for (const std::string& row : a.removed) text += "- " + row + "\n";
    for (const std::string& row : a.added) text += "+ " + row + "\n";
  }
  return text;
}

}  // namespace oddity
