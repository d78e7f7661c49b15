#include "report/study/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "reference/csv.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace {

using Numbers = std::vector<std::optional<double>>;

std::string with_blank(const std::string& text) { return text.empty() ? "" : text + " "; }

// Rounding decides an error below 1e-10 of the size. Results files have only one kind of error that is not
// finite.
double recorded(double error, double size) {
  if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
  return error <= 1e-10 * size ? 0 : error;
}

ErrorsOnRecord wrong_readings(const Claim& claim, const std::string& number) {
  ErrorsOnRecord row{
      number, "claim " + claim.id.substr(number.size() + 1), std::to_string(claim.line), {}, {}};
  const auto add = [&](const Reading& reading) {
    for (const Check& check : reading.checks)
      if (!check.holds()) row.errors.push_back(recorded(check.difference(), 0));
  };
  for (const Reading* reading : {&claim.printed, &claim.meant, &claim.corrected}) add(*reading);
  std::ranges::for_each(claim.near_misses, add);
  return row;
}

/// Tolerances of the passing checks, relative to their terms, where they exceed roundings.
ErrorsOnRecord tolerances(const Claim& claim, const std::string& number) {
  ErrorsOnRecord row{number, "claim " + claim.id.substr(number.size() + 1) + ": tolerances", "", {}, {}};
  for (const Reading* reading : {&claim.printed, &claim.meant, &claim.corrected})
    for (const Check& check : reading->checks) {
      if (!check.holds()) continue;
      const double sides = std::max(size_of(check.left.value), size_of(check.right.value));
      const double size = check.scale > 0 ? check.scale : sides > 0 ? sides : 1;
      const double allowed = recorded(check.tolerance.allowed, size) / size;
      if (allowed > 0) row.errors.push_back(allowed);
    }
  return row;
}

void add(ErrorsOnRecord& row, const TimedTrial& t, const QuantityResult& q) {
  const bool same_resolution = row.at.find(t.resolution + " ") != std::string::npos;
  row.at = with_blank(row.at) + (same_resolution ? "" : with_blank(t.resolution)) +
           format_significant(t.setting, 6);
  row.errors.push_back(recorded(t.error, size_of(q.reference.value)));
  row.work.push_back(static_cast<double>(t.evaluations));
}

bool same(std::optional<double> x, std::optional<double> on_record, double tolerance) {
  if (!x || !on_record || *x == *on_record) return true;
  return std::abs(*x - *on_record) <= tolerance * std::abs(*on_record);
}

bool all_same(const Numbers& run, const Numbers& on_record, double tolerance) {
  return std::ranges::equal(run, on_record, [&](auto x, auto y) { return same(x, y, tolerance); });
}

std::string text_of(const Numbers& numbers, int digits) {
  std::string text;
  for (const auto& x : numbers)
    text = with_blank(text) + (x ? format_significant(*x, digits) : std::string(by_last_bits));
  return text;
}

void leave_to_last_bits(Numbers& numbers, const Numbers& on_record) {
  if (numbers.size() != on_record.size()) return;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!on_record[i]) numbers[i] = {};
}

}  // namespace

std::vector<ErrorsOnRecord> errors_of(const ExerciseResult& e) {
  const std::string number = to_string(e.number);
  std::vector<ErrorsOnRecord> rows;
  for (const JudgedClaim& c : e.claims) {
    if (c.verdict == Verdict::unsettled) continue;
    rows.push_back(wrong_readings(c.claim, number));
    const ErrorsOnRecord allowed = tolerances(c.claim, number);
    if (!allowed.errors.empty()) rows.push_back(allowed);
  }
  for (const QuantityResult& q : e.quantities) {
    rows.push_back({number, q.name + ": need", "", {q.need.allowed}, {}});
    for (const MethodResult& m : q.methods) {
      ErrorsOnRecord& row =
          rows.emplace_back(ErrorsOnRecord{number, q.name + ": " + m.model + ", " + m.algorithm});
      for (const TimedTrial& t : m.trials) add(row, t, q);
    }
    for (std::size_t i = 0; i < q.breakdowns.size(); ++i) {
      ErrorsOnRecord& row =
          rows.emplace_back(ErrorsOnRecord{number, q.name + ": breakdown " + std::to_string(i + 1)});
      add(row, q.breakdowns[i].broken, q);
      add(row, q.breakdowns[i].cured, q);
    }
  }
  return rows;
}

bool agree(const ErrorsOnRecord& run, const ErrorsOnRecord& on_record) {
  const bool steps_are_chosen = run.at.find("tolerance ") != std::string::npos;
  return run.at == on_record.at && all_same(run.errors, on_record.errors, 0.02) &&
         all_same(run.work, on_record.work, steps_are_chosen ? 0.1 : 0);
}

bool is_left_to_last_bits(const ErrorsOnRecord& row) {
  return !row.errors.empty() && std::ranges::none_of(row.errors, &std::optional<double>::has_value) &&
         row.work.empty();
}

std::string text_of(const ErrorsOnRecord& row) {
  return row.exercise + "," + csv_cell(row.of) + "," + row.at + "," + text_of(row.errors, 3) + "," +
         text_of(row.work, 15);
}

std::vector<std::string> error_rows(const ExerciseResult& e, const std::vector<ErrorsOnRecord>& on_record) {
  std::vector<std::string> rows;
  std::set<std::string> seen;
  for (ErrorsOnRecord& row : errors_of(e)) {
    const auto known = std::ranges::find_if(
        on_record, [&](const ErrorsOnRecord& r) { return r.exercise == row.exercise && r.of == row.of; });
    if (known != on_record.end()) {
      leave_to_last_bits(row.errors, known->errors);
      leave_to_last_bits(row.work, known->work);
    }
    rows.push_back(text_of(known != on_record.end() && agree(row, *known) ? *known : row));
    seen.insert(row.of);
  }
  for (const ErrorsOnRecord& row : on_record)
    if (row.exercise == to_string(e.number) && !seen.contains(row.of) && is_left_to_last_bits(row))
      rows.push_back(text_of(row));
  return rows;
}

}  // namespace oddity
