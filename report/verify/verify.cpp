#include "report/verify/verify.hpp"

#include <algorithm>
#include <iostream>
#include <set>
#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/own.hpp"
#include "reference/quantity_text.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "reference/to_write.hpp"
#include "reference/verdicts.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/markdown.hpp"
#include "report/pages/tables.hpp"
#include "report/study/approve.hpp"
#include "report/study/earlier_results.hpp"
#include "report/study/errors.hpp"
#include "report/study/kept_results.hpp"
#include "report/study/letters.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/perturb_results.hpp"
#include "report/study/progress.hpp"
#include "report/study/run.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"
#include "report/study/stability.hpp"
#include "report/text/readable.hpp"
#include "report/text/screen.hpp"
#include "report/verify/catch.hpp"
#include "report/verify/catch_main.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// Input of the test cases; global, because Catch2's test functions take no arguments.
struct Judged {
  fs::path tables;
  Results results;
  Verdicts approved;
  Limits limits;
  Maps maps;
  std::vector<ErrorsOnRecord> errors;
};
Judged* suite = nullptr;

constexpr std::string_view register_name = "the register of exercises";

const ExerciseResult& result_of(Number number) {
  for (const ExerciseResult& e : suite->results.exercises)
    if (e.number == number) return e;
  throw std::logic_error("exercise " + to_string(number) + " was not run");
}

/// A path relative to the source tree, if it is inside.
std::string without_tree(std::string path) {
  const std::string tree = source_folder().string() + "/";
  return tree.size() > 1 && path.starts_with(tree) ? path.substr(tree.size()) : path;
}

/// Collects an exercise's failures into one report, by kind, with the first few of each.
class Complaints {
 public:
  /// One assertion; calls `says` for the message if it fails.
  template <class Says>
  void expect(bool holds, const std::string& kind, const Says& says) {
    if (holds)
      CHECK(true);
    else
      add(kind, says());
  }
  void add(const std::string& kind, const std::string& sentence) {
    const auto known = std::ranges::find(kinds_, kind, &Kind::name);
    (known == kinds_.end() ? kinds_.emplace_back(Kind{kind, {}}) : *known).sentences.push_back(sentence);
  }
  /// Wraps the text, as Catch2 would break longer lines anywhere, even within numbers.
  void report() const {
    if (kinds_.empty()) return;
    std::string text;
    for (const Kind& kind : kinds_) text += (text.empty() ? "" : "\n") + text_of(kind);
    FAIL_CHECK(wrapped(text, {74}, 4));
  }

 private:
  struct Kind {
    std::string name;
    std::vector<std::string> sentences;
  };
  static std::string text_of(const Kind& kind) {
    constexpr std::size_t shown = 3;
    const std::size_t all = kind.sentences.size();
    std::string text =
        kind.name + (all > shown ? " (" + std::to_string(all) + "; the first are shown)" : "") + ":";
    for (std::size_t i = 0; i < std::min(all, shown); ++i) text += "\n  " + kind.sentences[i];
    return text;
  }
  std::vector<Kind> kinds_;
};

void verify_claim(const JudgedClaim& judged, Complaints& complaints) {
  const Claim& claim = judged.claim;
  const auto approved = suite->approved.find(claim.id);
  const std::string found(name_of(judged.verdict));
  if (approved != suite->approved.end() || judged.verdict == Verdict::unsettled)
    complaints.expect(approved != suite->approved.end() && found == approved->second,
                      "claims whose verdict differs from the approved one", [&] {
                        return claim.id + ": " + found + ", approved: " +
                               (approved == suite->approved.end() ? "nothing" : approved->second) + "\n" +
                               claims_evidence(judged);
                      });
  complaints.expect(judged.verdict == Verdict::not_checkable || !claim.near_misses.empty(),
                    "claims without a near miss", [&] { return claim.id + " is " + found; });
  complaints.expect((judged.verdict == Verdict::not_checkable) == !claim.not_checkable.empty(),
                    "claims with neither readings nor a reason for their absence, or with both",
                    [&] { return claim.id; });
  for (const std::string& unnoticed : unnoticed_perturbations(judged))
    complaints.add("numbers of claims that could be others", unnoticed);
}

/// Whether a method gives the reference in every bit at every setting: it may be the source of the reference.
bool equals_reference(const MethodResult& m, const QuantityResult& q) {
  return std::ranges::all_of(
      m.trials, [&](const TimedTrial& t) { return std::ranges::equal(t.value, q.reference.value); });
}

/// Whether the reference cannot come from a method: tables have two routes, and exact values are whole
/// numbers.
bool independent_by_nature(const QuantityResult& q) {
  return q.reference.by.find("table ") != std::string::npos || q.reference_error == 0;
}

/// At every setting the error in float is at most that in double plus roundings.
void verify_in_float(const QuantityResult& q, const FloatResult& m, Complaints& complaints) {
  const std::vector<TimedTrial>& in_double = q.methods[m.in_double].trials;
  for (std::size_t i = 0; i < m.trials.size(); ++i)
    complaints.expect(as_accurate_as_roundings_allow(m.trials[i], in_double[i]),
                      "methods in float that err by more than double and roundings", [&] {
                        return m.model + ", " + m.algorithm + ", " + shown_resolution(m.trials[i]) +
                               ": error " + shown_error(m.trials[i].error) + ", in double " +
                               shown_error(in_double[i].error) + ", roundings " +
                               shown_error(m.trials[i].roundings) + "; " + m.trials[i].message;
                      });
}

bool fails_in_float(const QuantityResult& q) {
  const auto richest = std::ranges::find(q.in_float.rbegin(), q.in_float.rend(), in_float("Runge-Kutta 4"),
                                         &FloatResult::algorithm);
  return richest != q.in_float.rend() && richest->trials.back().outcome != Outcome::ok &&
         q.methods[richest->in_double].trials.back().outcome == Outcome::ok;
}

/// "ended as ok, expected as inaccurate: error 1e-7, needed 1e-6; the method's message"
std::string ended(const TimedTrial& t, Outcome expected, const QuantityResult& q) {
  return "ended as " + std::string(name_of(t.outcome)) + ", expected as " + std::string(name_of(expected)) +
         ": error " + shown_error(t.error) + ", needed " + shown_error(q.need.allowed) +
         (t.message.empty() ? "" : "; " + t.message);
}

void verify_quantity(const QuantityResult& q, Complaints& complaints) {
  const std::string from = "; the reference is from: " + readable(q.reference.by);
  complaints.expect(finite(q.reference.value), "quantities without a truth", [&] { return q.name + from; });
  if (!finite(q.reference.value)) return;  // and so nothing can be right
  complaints.expect(q.reference_error <= q.need.allowed / 2, "quantities whose truth is too uncertain", [&] {
    return q.name + ": known to " + shown_error(q.reference_error) + ", needed to half of " +
           shown_error(q.need.allowed) + from;
  });
  for (const MethodResult& m : q.methods) {
    const std::string name = q.name + ", " + m.model + ", " + m.algorithm;
    complaints.expect(m.as_expected(), "methods that do not end as expected at their finest setting",
                      [&] { return name + ": " + ended(m.trials.back(), m.expected, q); });
    complaints.expect(independent_by_nature(q) || !equals_reference(m, q),
                      "methods that give the reference in every bit", [&] { return name + from; });
  }
  for (const FloatResult& m : q.in_float) verify_in_float(q, m, complaints);
  complaints.expect(fails_in_float(q) == std::ranges::any_of(q.breakdowns,
                                                             [](const BreakdownResult& b) {
                                                               return b.broken.precision ==
                                                                      Precision::in_float;
                                                             }),
                    "breakdowns in float", [&] {
                      return q.name +
                             ": where the richest model fails in float by Runge-Kutta 4 and holds in "
                             "double, that is a breakdown";
                    });
  for (const BreakdownResult& b : q.breakdowns) {
    complaints.expect(b.broken.outcome == b.expected, "breakdowns that do not break as expected",
                      [&] { return readable(b.says) + ": " + ended(b.broken, b.expected, q); });
    complaints.expect(b.cured.outcome == Outcome::ok, "breakdowns without a cure",
                      [&] { return readable(b.says) + ": " + ended(b.cured, Outcome::ok, q); });
  }
}

/// A row of the records without its newline.
std::string line(std::string row) {
  while (row.ends_with('\n')) row.pop_back();
  return row;
}

void verify_limit(const ExerciseResult& e, const Limit& limit, Complaints& complaints) {
  complaints.expect(!limit.broken || limit.cure, "limits beyond which nothing is a cure",
                    [&] { return limit.model + ", " + limit.algorithm; });
  const auto approved = std::ranges::find_if(suite->limits, [&](const ApprovedLimit& a) {
    return a.exercise == to_string(e.number) && a.model == limit.model && a.algorithm == limit.algorithm;
  });
  if (approved == suite->limits.end()) return;
  const std::string others = difference(limit, *approved);
  complaints.expect(others.empty(), "limits that differ from the approved ones", [&] {
    return line(limit_row(e, limit)) + "\n  approved: " + others + " (" + without_tree(approved->place) + ")";
  });
}

/// An outcome may differ from the approved one only if rounding errors decide it: if the record marks it so,
/// or if a start perturbed by roundings ends as approved.
void verify_map(const ExerciseResult& e, const MapRow& row, Complaints& complaints) {
  const auto approved = std::ranges::find_if(suite->maps, [&](const ApprovedMap& a) {
    return a.exercise == to_string(e.number) && a.model == row.model && a.algorithm == row.algorithm &&
           a.value == row.value;
  });
  if (approved == suite->maps.end()) return;
  bool same = row.outcomes.size() == approved->outcomes.size();
  if (letters(row) != approved->outcomes) {
    const Task task(*std::ranges::find(registry(), e.number, &Entry::number));
    for (std::size_t k = 0; same && k < row.outcomes.size(); ++k) {
      const auto on_record = outcome_of(approved->outcomes[k]);
      const bool marked = !approved->fragile.empty() && approved->fragile[k] == '*';
      same = marked || on_record == row.outcomes[k] ||
             (on_record && ends_so_within_roundings(task, row, k, *on_record, Reference(suite->tables)));
    }
  }
  complaints.expect(same, "rows of the map that differ from the approved ones", [&] {
    return line(map_row(e, row)) + "\n  approved: " + approved->outcomes + " (" +
           without_tree(approved->place) + ")";
  });
}

/// Compares limits and map with the approved records, and finds records without a method.
void verify_stability(const ExerciseResult& e, Complaints& complaints) {
  const std::string number = to_string(e.number);
  const auto is_ours = [&](const auto& row) { return row.exercise == number; };
  const auto no_such = [&](const auto& row) {
    complaints.add("approved rows without such a method",
                   without_tree(row.place) + ": " + row.model + ", " + row.algorithm);
  };
  const auto is_method = [](const auto& row) {
    return [&row](const auto& one) { return one.model == row.model && one.algorithm == row.algorithm; };
  };
  for (const ApprovedLimit& row : suite->limits)
    if (is_ours(row) && !(e.stability && std::ranges::any_of(e.stability->limits, is_method(row))))
      no_such(row);
  for (const ApprovedMap& row : suite->maps)
    if (is_ours(row) && !(e.stability && std::ranges::any_of(e.stability->map, [&](const MapRow& one) {
                            return is_method(row)(one) && one.value == row.value;
                          })))
      no_such(row);
  if (!e.stability) return;
  const std::vector<double>& steps = e.stability->steps;
  for (std::size_t k = 1; k < steps.size(); ++k)
    complaints.expect(steps[k] == steps[k - 1] / 2, "steps of the map that are not halved",
                      [&] { return format_shortest(steps[k]); });
  for (const Limit& limit : e.stability->limits) verify_limit(e, limit, complaints);
  for (const MapRow& row : e.stability->map) verify_map(e, row, complaints);
}

/// Compares errors with the approved records, and finds records without an error.
void verify_errors(const ExerciseResult& e, Complaints& complaints) {
  const std::string number = to_string(e.number);
  std::set<std::string> seen;
  for (const ErrorsOnRecord& row : errors_of(e)) {
    seen.insert(row.of);
    const auto on_record = std::ranges::find_if(
        suite->errors, [&](const ErrorsOnRecord& r) { return r.exercise == number && r.of == row.of; });
    if (on_record != suite->errors.end())
      complaints.expect(agree(row, *on_record), "errors that differ from the approved ones",
                        [&] { return text_of(row) + "\n  approved: " + text_of(*on_record); });
  }
  for (const ErrorsOnRecord& row : suite->errors)
    if (row.exercise == number && !seen.contains(row.of) && !is_left_to_last_bits(row))
      complaints.add("approved rows without such an error", without_tree(row.place) + ": " + row.of);
}

/// Requires that the records have all rows of the exercise; exercises outside the book need none for errors.
void verify_records(const ExerciseResult& e, Complaints& complaints) {
  const std::string number = to_string(e.number);
  const std::string kind = "rows that are not approved yet; " + program_as_typed() + " verify --approve '[" +
                           number + "]' adds them";
  const auto missing = [&](const std::string& file, const auto& rows, const auto& is_on_record) {
    const auto all = std::ranges::ssize(rows), lacking = all - std::ranges::count_if(rows, is_on_record);
    complaints.expect(lacking == 0, kind, [&] {
      return file + " lacks " + std::to_string(lacking) + " of " + std::to_string(all);
    });
  };
  missing("verdicts.csv", e.claims, [&](const JudgedClaim& c) {
    return c.verdict == Verdict::unsettled || suite->approved.contains(c.claim.id);
  });
  const auto is_method = [&](const auto& one) {
    return [&](const auto& row) {
      return row.exercise == number && row.model == one.model && row.algorithm == one.algorithm;
    };
  };
  if (e.stability) {
    missing("limits.csv", e.stability->limits,
            [&](const Limit& one) { return std::ranges::any_of(suite->limits, is_method(one)); });
    missing("stability_maps.csv", e.stability->map, [&](const MapRow& one) {
      return std::ranges::any_of(
          suite->maps, [&](const ApprovedMap& row) { return is_method(one)(row) && row.value == one.value; });
    });
  }
  if (of_the_book(e.number))
    missing("errors.csv", errors_of(e), [&](const ErrorsOnRecord& one) {
      return std::ranges::any_of(suite->errors, [&](const ErrorsOnRecord& row) {
        return row.exercise == number && row.of == one.of;
      });
    });
}

/// The place still to be written, "file:line", if the route is marked so.
std::optional<std::string> place_to_write(const std::string& by) {
  if (!by.starts_with(to_write_mark)) return {};
  return without_tree(by.substr(to_write_mark.size()));
}

/// Everything that must be written before the exercise can be judged, with its place.
std::vector<std::string> still_to_write(const ExerciseResult& e) {
  const std::string number = to_string(e.number);
  std::vector<std::string> all;
  const Entry& entry = *std::ranges::find(registry(), e.number, &Entry::number);
  if (entry.exercise.asks.starts_with(to_write_mark))
    all.push_back(number + ": the question is missing: write it in " + without_tree(std::string(entry.file)));
  for (const QuantityResult& q : e.quantities)
    if (const auto place = place_to_write(q.reference.by))
      all.push_back(number + ": the quantity '" + q.name +
                    "' has no second route to its truth yet: write it in " + *place);
  for (const JudgedClaim& c : e.claims) {
    const auto missing = [&] {
      for (const Reading* reading : {&c.claim.printed, &c.claim.meant, &c.claim.corrected})
        for (const Check& check : reading->checks)
          for (const Route* route : {&check.left, &check.right})
            if (const auto place = place_to_write(route->by)) return place;
      return std::optional<std::string>();
    };
    if (const auto place = missing())
      all.push_back(number + ": the claim '" + c.claim.id.substr(number.size() + 1) +
                    "' has no independent route yet: write it in " + *place);
  }
  return all;
}

void judge(const ExerciseResult& e, Complaints& complaints) {
  const Entry& entry = *std::ranges::find(registry(), e.number, &Entry::number);
  complaints.expect(!e.claims.empty() || (!of_the_book(e.number) && !e.quantities.empty()),
                    "nothing to be judged", [&] { return without_tree(std::string(entry.file)); });
  for (const Parameter& p : entry.exercise.parameters)
    complaints.expect(is_unit(p.unit), "parameters with an unknown unit", [&] {
      return std::string(p.name) + ": '" + std::string(p.unit) + "', in " +
             without_tree(std::string(entry.file));
    });
  if (!of_the_book(e.number)) {  // a unit test checks the book's
    const std::string exchanged = exchanged_letters(entry);
    complaints.expect(exchanged.empty(), "letters of Given in another order than the parameters",
                      [&] { return exchanged; });
    const Reference truth(suite->tables);
    for (const std::string& unused : unused_parameters(entry, truth))
      complaints.add("parameters that nothing uses", unused);
    if (e.failure.empty())
      for (const std::string& unit :
           other_units(entry, entry.exercise.study(Parameters(entry.exercise.parameters), truth)))
        complaints.add("quantities in another unit than their table", unit);
  }
  for (const JudgedClaim& claim : e.claims) {
    complaints.expect(claim.claim.id.starts_with(to_string(e.number) + "-"), "claims of another number",
                      [&] { return claim.claim.id; });
    complaints.expect(claim.claim.line > 0 || !of_the_book(e.number), "claims without a line of the text",
                      [&] { return claim.claim.id; });
    verify_claim(claim, complaints);
  }
  for (const QuantityResult& q : e.quantities) verify_quantity(q, complaints);
  // Without a truth there are no limits to compare.
  if (!std::ranges::all_of(e.quantities, [](const QuantityResult& q) { return finite(q.reference.value); }))
    return;
  verify_records(e, complaints);
  verify_stability(e, complaints);
  verify_errors(e, complaints);
}

void verify_exercise(Number number) {
  const ExerciseResult& e = result_of(number);
  Complaints complaints;
  if (const auto missing = still_to_write(e); !missing.empty())
    for (const std::string& sentence : missing) complaints.add("still to be written", sentence);
  else if (!e.failure.empty())
    complaints.add("exercise " + to_string(number) + " raised", e.failure);
  else
    judge(e, complaints);
  complaints.report();
}

/// Requires that every odd exercise of the book is encoded, and that every approved verdict belongs to a
/// claim.
void verify_register() {
  for (const Chapter& chapter : chapters())
    for (int index = 1; index <= chapter.last_odd; index += 2) {
      const Number number{chapter.number, index};
      INFO("exercise " << to_string(number) << " is not encoded");
      CHECK(std::ranges::any_of(registry(), [&](const Entry& e) { return e.number == number; }));
    }
  for (const auto& [id, verdict] : suite->approved) {
    const auto number = exercise_number(id.substr(0, id.find('-')));
    INFO("verdicts.csv: " << id << " has no claim");
    REQUIRE(number);
    CHECK(std::ranges::any_of(registry(), [&](const Entry& e) { return e.number == *number; }));
    for (const ExerciseResult& e : suite->results.exercises)
      if (e.number == *number)
        CHECK(std::ranges::count(e.claims, id, [](const JudgedClaim& c) { return c.claim.id; }) == 1);
  }
}

std::string name_of_test(const Entry& e) { return to_string(e.number) + " " + std::string(e.exercise.title); }

std::string tags_of(const Entry& e, const Verdicts& approved) {
  std::string tags = "[ch" + std::to_string(e.number.chapter) + "][" + to_string(e.number) + "]";
  if (!of_the_book(e.number)) tags += "[own]";
  if (e.exercise.scene) tags += "[scene]";
  const auto has = [&](std::string_view verdict) {
    return std::ranges::any_of(approved, [&](const auto& row) {
      return row.second == verdict && row.first.starts_with(to_string(e.number) + "-");
    });
  };
  for (const auto& [verdict, tag] : {std::pair{"wrong", "[wrong][erratum]"},
                                     {"incomplete", "[incomplete][erratum]"},
                                     {"misprint", "[misprint]"},
                                     {"lost in our copy", "[lost]"}})
    if (has(verdict)) tags += tag;
  return tags;
}

void register_tests(const Verdicts& approved) {
  for (const Entry& e : registry())
    register_test([number = e.number] { verify_exercise(number); }, name_of_test(e), tags_of(e, approved));
  register_test(verify_register, std::string(register_name), "[register]");
}

/// Exercises whose test cases are selected.
std::vector<Task> tasks_of(const std::vector<std::string>& test_names) {
  std::vector<Task> tasks;
  for (const Entry& entry : registry())
    if (std::ranges::find(test_names, name_of_test(entry)) != test_names.end()) tasks.emplace_back(entry);
  return tasks;
}

/// Ignores Catch2's events; when the run ends, writes the results as one Markdown page.
class MarkdownReporter : public MarkdownReporterBase {
 public:
  using MarkdownReporterBase::MarkdownReporterBase;
  static std::string getDescription() { return "The report of the run as one Markdown page"; }
  void testRunEnded(const Catch::TestRunStats& stats) override {
    if (suite) out() << single_page(suite->results);
    MarkdownReporterBase::testRunEnded(stats);
  }
};

CATCH_REGISTER_REPORTER("markdown", MarkdownReporter)

/// Writes the claims as a table when the run ends.
template <std::string (*Text)(const Table&)>
class ClaimsReporter : public MarkdownReporterBase {
 public:
  using MarkdownReporterBase::MarkdownReporterBase;
  static std::string getDescription() { return "The claims of the run and their verdicts, as a table"; }
  void testRunEnded(const Catch::TestRunStats& stats) override {
    if (suite) out() << Text(claims_table(suite->results, suite->approved));
    MarkdownReporterBase::testRunEnded(stats);
  }
};
using ClaimsCsv = ClaimsReporter<to_csv>;
using ClaimsJson = ClaimsReporter<to_json>;

CATCH_REGISTER_REPORTER("claims-csv", ClaimsCsv)
CATCH_REGISTER_REPORTER("claims-json", ClaimsJson)

}  // namespace

namespace {

/// Adds the records of exercises outside the tree, if they have any.
void add_own(Judged& judged) {
  std::set<fs::path> folders;
  for (const Entry& e : registry()) folders.insert(own_reference_folder(e.file));
  for (const fs::path& folder : folders) {
    if (folder.empty()) continue;
    const fs::path own = folder / "approved";
    if (fs::exists(own / "verdicts.csv")) judged.approved.merge(read_verdicts(own));
    if (fs::exists(own / "limits.csv"))
      std::ranges::move(read_limits(own), std::back_inserter(judged.limits));
    if (fs::exists(own / "stability_maps.csv"))
      std::ranges::move(read_maps(own), std::back_inserter(judged.maps));
    if (fs::exists(own / "errors.csv"))
      std::ranges::move(read_errors(own), std::back_inserter(judged.errors));
  }
}

Judged on_record(const fs::path& folder) {
  const fs::path approved = folder / "approved";
  Judged judged{
      folder, {}, read_verdicts(approved), read_limits(approved), read_maps(approved), read_errors(approved)};
  add_own(judged);
  return judged;
}

/// Updates the approved records to the results, and prints the changes.
void approve(const Results& results, const fs::path& folder) {
  const auto changes = approvals(results, folder);
  for (const Approval& change : changes) write_whole(change.file, change.text);
  std::cout << text_of(changes)
            << (changes.empty() ? "every row was approved already\n"
                                : "Look at the differences (git diff) before you commit them.\n")
            << std::flush;
}

/// Prints possible remedies for failures: parts still to be written, and rows of the records to paste.
void suggest(const Results& results, const fs::path& folder) {
  const auto changes = approvals(results, folder);
  for (const ExerciseResult& e : results.exercises)
    for (const std::string& sentence : still_to_write(e)) std::cerr << sentence << "\n";
  if (!changes.empty())
    std::cerr << "The records differ from this run; " << program_as_typed()
              << " verify --approve would write:\n"
              << text_of(changes);
}

/// Tags whose meaning has changed, each with a hint.
constexpr std::pair<std::string_view, std::string_view> changed_tags[]{
    {"[erratum]", "selects both [wrong] and [incomplete]"},
    {"[misprint]", "selects misprints of the manual; [lost] selects losses in our copy"}};

void hint_at_changes(const std::vector<std::string>& named) {
  for (const auto& [tag, hint] : changed_tags)
    if (std::ranges::any_of(named, [&](const std::string& one) { return nearly_same(one, tag, 0); }))
      std::cerr << "oddity verify: " << tag << " " << hint << "\n";
}

/// Throws BadInput for a tag that no test case can have.
void require_known(const std::vector<std::string>& named, const Verdicts& approved) {
  std::vector<std::string> tags{"[own]", "[register]", "[erratum]", "[misprint]"};
  for (const Entry& e : registry()) {
    std::istringstream all(tags_of(e, approved));
    for (std::string tag; std::getline(all, tag, ']');)
      if (std::ranges::find(tags, tag + "]") == tags.end()) tags.push_back(tag + "]");
  }
  for (const std::string& tag : named) {
    const auto is_it = [&](const std::string& known) { return nearly_same(tag, known, 0); };
    if (tag.starts_with("[#") || std::ranges::any_of(tags, is_it)) continue;
    const auto near = similar(tag, tags);
    throw BadInput("no test case matches '" + tag + "'; --list-tests shows them all" +
                   (near.size() == 1 ? "; did you mean '" + near[0] + "'?" : ""));
  }
}

/// Whether nothing but the comparison with the records is asked for.
bool only_compares(const SuiteRequest& request) {
  return !request.thorough && !request.approve && request.results_file.empty() &&
         std::ranges::none_of(request.catch_arguments, [](const std::string& word) {
           return word.find("markdown") != std::string::npos;
         });
}

/// Results of a run, or of the files that were given instead.
Results results_of(const SuiteRequest& request, const std::vector<Task>& tasks, const Limits& approved) {
  if (!request.from.empty()) {
    std::vector<Number> numbers;
    for (const Task& task : tasks) numbers.push_back(task.entry->number);
    return merged_results(request.from, numbers, made_by(request.reference_folder));
  }
  const Reference truth(request.reference_folder);
  return with_progress([&](const Progress& progress) {
    Results results = run(tasks, truth, !request.results_file.empty(), progress);
    if (!request.results_file.empty()) {
      results.made_by = made_by(request.reference_folder);
      results = noted(std::move(results), made_from(request.reference_folder));
    }
    return with_stability(std::move(results), tasks, truth, progress, {},
                          only_compares(request) ? &approved : nullptr);
  });
}

}  // namespace

int verify(const SuiteRequest& request) {
  const fs::path& folder = request.reference_folder;
  Judged judged = on_record(folder);
  register_tests(judged.approved);
  CatchSession session(request.catch_arguments);
  if (!session.accepted())
    throw BadInput("Catch2 does not take these arguments; '" + program_as_typed() +
                   " verify -?' lists its arguments");
  require_known(session.tags(), judged.approved);
  hint_at_changes(session.tags());
  if (session.only_lists()) return session.run(), 0;
  const auto selected = session.selected();
  if (selected.empty()) throw BadInput("no test case matches; --list-tests shows them all");

  if (!request.results_file.empty()) require_writable(request.results_file);
  Results results = results_of(request, tasks_of(selected), judged.limits);
  if (request.approve) {
    approve(results, folder);
    judged = on_record(folder);
  }
  judged.results = std::move(results);
  suite = &judged;
  const int failed = session.run();
  suite = nullptr;
  if (!request.results_file.empty()) write_whole(request.results_file, to_json(judged.results));
  if (failed > 0)
    suggest(only_compares(request) && request.from.empty() ? with_progress([&](const Progress& progress) {
              return with_stability(std::move(judged.results), tasks_of(selected), Reference(folder),
                                    progress);
            })
                                                           : judged.results,
            folder);
  return failed == 0 ? 0 : 1;
}

}  // namespace oddity
