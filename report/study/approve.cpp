#include "report/study/approve.hpp"

#include <fstream>
#include <functional>
#include <map>
#include <set>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/own.hpp"
#include "report/study/errors.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace {

using RowTexts = std::vector<std::string>;

/// A file of records: its head up to the names of the columns, and the rows of each exercise.
struct Record {
  std::string head;
  std::map<Number, RowTexts> rows;
};

/// Where there is no file, one without rows, its head that of `like`.
Record read_record(const std::filesystem::path& file, const std::filesystem::path& like) {
  std::ifstream in(file);
  if (!in && file != like) return {read_record(like, like).head, {}};
  if (!in) throw BadInput("cannot read " + file.string());
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

/// None where there is no file yet.
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

/// Of the exercises whose records are in `folder`; `like` has all files.
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
