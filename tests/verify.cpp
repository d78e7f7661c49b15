#include "tests/verify.hpp"

#include <algorithm>
#include <iostream>
#include <set>
#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/own.hpp"
#include "reference/similar.hpp"
#include "reference/to_write.hpp"
#include "reference/verdicts.hpp"
#include "report/cli/settings.hpp"
#include "report/pages/markdown.hpp"
#include "report/pages/readable.hpp"
#include "report/pages/tables.hpp"
#include "report/pages/text_view.hpp"
#include "report/study/approve.hpp"
#include "report/study/errors.hpp"
#include "report/study/perturb_results.hpp"
#include "report/study/progress.hpp"
#include "report/study/run.hpp"
#include "report/study/stability.hpp"
#include "tests/catch.hpp"
#include "tests/catch_main.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// What the test cases judge. Catch2's test functions take no arguments, so it stands here.
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

void verify_claim(const JudgedClaim& judged) {
  const Claim& claim = judged.claim;
  const auto approved = suite->approved.find(claim.id);
  const std::string on_record =
      approved == suite->approved.end() ? "missing from verdicts.csv" : approved->second;
  INFO(claims_evidence(judged));
  CHECK(claim.id + ": " + std::string(name_of(judged.verdict)) == claim.id + ": " + on_record);
  INFO(claim.id << " is " << name_of(judged.verdict) << " and has no near miss");
  CHECK((judged.verdict == Verdict::not_checkable || !claim.near_misses.empty()));
  INFO(claim.id << " has readings, or says why it cannot be judged");
  CHECK((judged.verdict == Verdict::not_checkable) == !claim.not_checkable.empty());
}

/// Whether a method gives the reference in every bit at every setting: it may be where the reference is from.
bool equals_reference(const MethodResult& m, const QuantityResult& q) {
  return std::ranges::all_of(
      m.trials, [&](const TimedTrial& t) { return std::ranges::equal(t.value, q.reference.value); });
}

/// A table is made by two routes of its own, and what is known without an error is a matter of whole numbers.
bool independent_by_nature(const QuantityResult& q) {
  return q.reference.by.find("table ") != std::string::npos || q.reference_error == 0;
}

/// In float a method errs by what double does and by roundings, at every setting.
void verify_in_float(const QuantityResult& q, const FloatResult& m) {
  const std::vector<TimedTrial>& in_double = q.methods[m.in_double].trials;
  for (std::size_t i = 0; i < m.trials.size(); ++i) {
    INFO(m.model << ", " << m.algorithm << ", " << shown_knob(m.trials[i]) << ": error "
                 << shown_error(m.trials[i].error) << ", in double " << shown_error(in_double[i].error)
                 << ", roundings " << shown_error(m.trials[i].roundings) << "; " << m.trials[i].message);
    CHECK(as_accurate_as_roundings_allow(m.trials[i], in_double[i]));
  }
}

bool fails_in_float(const QuantityResult& q) {
  const auto richest = std::ranges::find(q.in_float.rbegin(), q.in_float.rend(), in_float("Runge-Kutta 4"),
                                         &FloatResult::algorithm);
  return richest != q.in_float.rend() && richest->trials.back().outcome != Outcome::ok &&
         q.methods[richest->in_double].trials.back().outcome == Outcome::ok;
}

void verify_quantity(const QuantityResult& q) {
  INFO("quantity " << q.name << ": " << readable(q.says) << "; reference: " << readable(q.reference.by));
  CHECK(finite(q.reference.value));
  CHECK(q.reference_error <= q.need.allowed / 2);
  for (const MethodResult& m : q.methods) {
    INFO(m.model << ", " << m.algorithm << " at its finest setting: error "
                 << shown_error(m.trials.back().error) << ", needed " << shown_error(q.need.allowed) << "; "
                 << m.trials.back().message);
    CHECK(name_of(m.trials.back().outcome) == name_of(m.expected));
    INFO("the reference is from: " << readable(q.reference.by));
    CHECK((independent_by_nature(q) || !equals_reference(m, q)));
  }
  for (const FloatResult& m : q.in_float) verify_in_float(q, m);
  INFO("where the richest model fails in float by Runge-Kutta 4 and holds in double, that is a breakdown");
  CHECK(fails_in_float(q) == std::ranges::any_of(q.breakdowns, [](const BreakdownResult& b) {
          return b.broken.precision == Precision::in_float;
        }));
  for (const BreakdownResult& b : q.breakdowns) {
    INFO(readable(b.says));
    INFO("cured: error " << shown_error(b.cured.error) << ", " << name_of(b.cured.outcome));
    CHECK(name_of(b.broken.outcome) == name_of(b.expected));
    CHECK(b.cured.outcome == Outcome::ok);
  }
}

/// Whether a limit is the one on record: within 5 %, or infinite or zero as that is.
bool same_limit(double measured, double on_record) {
  if (std::isinf(on_record)) return measured == on_record;
  return std::abs(measured - on_record) <= 0.05 * on_record;
}

/// Whether a trial has as large an error as is on record, within a quarter; none is like none.
bool same_error(const std::optional<TimedTrial>& t, const std::optional<double>& on_record) {
  if (!t || !on_record) return !t && !on_record;
  return t->error <= 1.25 * *on_record && *on_record <= 1.25 * t->error;
}

bool same_needed(const std::optional<TimedTrial>& t, const std::optional<double>& on_record) {
  return t && on_record ? same_limit(t->setting, *on_record) : !t && !on_record;
}

void verify_limit(const ExerciseResult& e, const Limit& limit) {
  const auto approved = std::ranges::find_if(suite->limits, [&](const ApprovedLimit& a) {
    return a.exercise == to_string(e.number) && a.model == limit.model && a.algorithm == limit.algorithm;
  });
  INFO(limit.model << ", " << limit.algorithm << ": stable to " << shown_step(limit) << ", in theory to "
                   << limit.theory() << "; beyond: " << beyond(limit));
  if (approved == suite->limits.end()) {
    FAIL_CHECK("limits.csv has no row for this method");
    return;
  }
  CHECK(same_limit(limit.step(), approved->step));
  const bool singular = limit.theory() < 1e-3 * limit.step();  // and so its limit is as good as zero
  if (singular) {
    CHECK(approved->theory < 1e-3 * limit.step());
  } else {
    CHECK(same_limit(limit.theory(), approved->theory));
    CHECK(shown_tongues(limit) == approved->unstable);
  }
  CHECK(same_error(limit.at, approved->error));
  CHECK(same_needed(limit.within, approved->needed));
  CHECK(beyond(limit) == approved->beyond);
  CHECK((!limit.broken || limit.cure));
  CHECK(limit.why == approved->why);
  CHECK(limit.soft.has_value() == !approved->soft.empty());
  CHECK((limit.goes_on || std::isinf(limit.step())) != approved->watched.has_value());
}

/// A letter may differ from its record where that hangs on the last bits: where it did when it was recorded,
/// and is marked so, or where it does here.
void verify_map(const ExerciseResult& e, const MapRow& row) {
  const auto approved = std::ranges::find_if(suite->maps, [&](const ApprovedMap& a) {
    return a.exercise == to_string(e.number) && a.model == row.model && a.algorithm == row.algorithm &&
           a.value == row.value;
  });
  INFO(row.model << ", " << row.algorithm << " at " << row.value);
  if (approved == suite->maps.end()) {
    FAIL_CHECK("stability_maps.csv has no row for this method");
    return;
  }
  if (letters(row) == approved->outcomes) return;
  INFO("letter by letter it is " << letters(row) << ", on record " << approved->outcomes);
  REQUIRE(row.outcomes.size() == approved->outcomes.size());
  const Task task(*std::ranges::find(registry(), e.number, &Entry::number));
  for (std::size_t k = 0; k < row.outcomes.size(); ++k) {
    const auto on_record = outcome_of(approved->outcomes[k]);
    const bool marked = !approved->fragile.empty() && approved->fragile[k] == '*';
    if (marked || on_record == row.outcomes[k]) continue;
    INFO("letter " << k + 1 << " would be as on record if a few roundings at the start decided");
    CHECK((on_record && ends_so_within_roundings(task, row, k, *on_record, Reference(suite->tables))));
  }
}

/// Every limit and every row of the map is the one on record, and none on record is missing.
void verify_stability(const ExerciseResult& e) {
  const std::string number = to_string(e.number);
  const std::size_t limits = e.stability ? e.stability->limits.size() : 0;
  const std::size_t rows = e.stability ? e.stability->map.size() : 0;
  INFO("rows of " << number << " in limits.csv and in stability_maps.csv");
  CHECK(std::ranges::count(suite->limits, number, &ApprovedLimit::exercise) ==
        static_cast<std::ptrdiff_t>(limits));
  CHECK(std::ranges::count(suite->maps, number, &ApprovedMap::exercise) == static_cast<std::ptrdiff_t>(rows));
  if (!e.stability) return;
  const std::vector<double>& steps = e.stability->steps;
  for (std::size_t k = 1; k < steps.size(); ++k) CHECK(steps[k] == steps[k - 1] / 2);
  for (const Limit& limit : e.stability->limits) verify_limit(e, limit);
  for (const MapRow& row : e.stability->map) verify_map(e, row);
}

/// Everything is as far off as is on record, and nothing is on record that is not there. Of one's own
/// exercises only what is on record is asked.
void verify_errors(const ExerciseResult& e) {
  const std::string number = to_string(e.number);
  std::set<std::string> seen;
  for (const ErrorsOnRecord& row : errors_of(e)) {
    seen.insert(row.of);
    const auto on_record = std::ranges::find_if(
        suite->errors, [&](const ErrorsOnRecord& r) { return r.exercise == number && r.of == row.of; });
    INFO("errors.csv would have: " << text_of(row));
    if (on_record != suite->errors.end()) {
      INFO("on record is:          " << text_of(*on_record));
      CHECK(agree(row, *on_record));
    } else if (of_the_book(e.number)) {
      FAIL_CHECK("errors.csv has no such row");
    }
  }
  for (const ErrorsOnRecord& row : suite->errors)
    if (row.exercise == number && !seen.contains(row.of) && !is_left_to_last_bits(row))
      FAIL_CHECK(row.place << ": there is nothing that this row is about: " << row.of);
}

/// A path as it is within the tree, if it is.
std::string without_tree(std::string path) {
  const std::string tree = source_folder().string() + "/";
  return path.starts_with(tree) ? path.substr(tree.size()) : path;
}

/// "file:line" of what is still to be written, as a route says; else nothing.
std::optional<std::string> place_to_write(const std::string& by) {
  if (!by.starts_with(to_write_mark)) return {};
  return without_tree(by.substr(to_write_mark.size()));
}

/// What is still to be written before the exercise can be judged, and where.
std::vector<std::string> still_to_write(const ExerciseResult& e) {
  const std::string number = to_string(e.number);
  std::vector<std::string> all;
  const Entry& entry = *std::ranges::find(registry(), e.number, &Entry::number);
  if (entry.exercise.asks.starts_with(to_write_mark))
    all.push_back(number + ": it does not say yet what is asked: write it in " +
                  without_tree(std::string(entry.file)));
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

void verify_exercise(Number number) {
  const ExerciseResult& e = result_of(number);
  if (!e.failure.empty()) FAIL("exercise " << to_string(number) << " raised: " << e.failure);
  if (const auto missing = still_to_write(e); !missing.empty()) {
    for (const std::string& sentence : missing) FAIL_CHECK(sentence);
    return;
  }
  CHECK_FALSE((e.claims.empty() && (of_the_book(number) || e.quantities.empty())));
  for (const JudgedClaim& claim : e.claims) {
    CHECK(claim.claim.id.starts_with(to_string(number) + "-"));
    CHECK((claim.claim.line > 0 || !of_the_book(number)));
    verify_claim(claim);
    CHECK(unnoticed_perturbations(claim) == std::vector<std::string>());
  }
  for (const QuantityResult& q : e.quantities) verify_quantity(q);
  verify_stability(e);
  verify_errors(e);
}

/// Every odd exercise of the book is encoded, and every verdict on record belongs to a claim.
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
  for (const std::string verdict : {"erratum", "misprint"})
    if (std::ranges::any_of(approved, [&](const auto& row) {
          return row.second == verdict && row.first.starts_with(to_string(e.number) + "-");
        }))
      tags += "[" + verdict + "]";
  return tags;
}

void register_tests(const Verdicts& approved) {
  for (const Entry& e : registry())
    register_test([number = e.number] { verify_exercise(number); }, name_of_test(e), tags_of(e, approved));
  register_test(verify_register, std::string(register_name), "[register]");
}

/// The exercises whose test cases are selected.
std::vector<Task> tasks_of(const std::vector<std::string>& test_names) {
  std::vector<Task> tasks;
  for (const Entry& entry : registry())
    if (std::ranges::find(test_names, name_of_test(entry)) != test_names.end()) tasks.emplace_back(entry);
  return tasks;
}

/// Prints nothing of Catch2's events: when the run ends it writes the finished results as one Markdown page.
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

/// The same with the claims as a table.
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

/// Adds the records of exercises from outside the tree, those that have some.
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

/// Writes what agrees with the results into the files of records, and says what that changed.
void approve(const Results& results, const fs::path& folder) {
  const auto changes = approvals(results, folder);
  for (const Approval& change : changes) write_whole(change.file, change.text);
  std::cout << text_of(changes)
            << (changes.empty() ? "every row was on record already\n"
                                : "Look at the differences (git diff) before you commit them.\n")
            << std::flush;
}

/// What could be done about a red suite: what is still to be written, and the rows of its records, each in
/// one line, to be pasted.
void suggest(const Results& results, const fs::path& folder) {
  const auto changes = approvals(results, folder);
  for (const ExerciseResult& e : results.exercises)
    for (const std::string& sentence : still_to_write(e)) std::cerr << sentence << "\n";
  if (!changes.empty())
    std::cerr << "The records differ from this run; oddity verify --approve would write:\n"
              << text_of(changes);
}

/// The tags most like one of the words, where no test case has that.
std::string meant_tags(const std::vector<std::string>& words, const Verdicts& approved) {
  std::vector<std::string> tags;
  for (const Entry& e : registry()) {
    std::istringstream all(tags_of(e, approved));
    for (std::string tag; std::getline(all, tag, ']');)
      if (std::ranges::find(tags, tag + "]") == tags.end()) tags.push_back(tag + "]");
  }
  for (const std::string& word : words)
    if (word.starts_with('[') && std::ranges::find(tags, word) == tags.end())
      if (const auto near = similar(word, tags); near.size() == 1) return "; did you mean '" + near[0] + "'?";
  return "";
}

/// Of a run, or of the files that are to be judged instead.
Results results_of(const SuiteRequest& request, const std::vector<Task>& tasks) {
  if (!request.from.empty()) {
    std::vector<Number> numbers;
    for (const Task& task : tasks) numbers.push_back(task.entry->number);
    return merged_results(request.from, numbers);
  }
  const Reference truth(request.reference_folder);
  return with_progress([&](const Progress& progress) {
    return with_stability(run(tasks, truth, !request.results_file.empty(), progress), tasks, truth, progress);
  });
}

}  // namespace

int verify(const SuiteRequest& request) {
  const fs::path& folder = request.reference_folder;
  Judged judged = on_record(folder);
  register_tests(judged.approved);
  CatchSession session(request.catch_arguments);
  if (!session.accepted())
    throw BadInput("Catch2 does not take these arguments; oddity verify -? shows what it takes");
  if (session.only_lists()) return session.run(), 0;
  const auto selected = session.selected();
  if (selected.empty())
    throw BadInput("no test case matches; 'oddity verify --list-tests' shows them all" +
                   meant_tags(request.catch_arguments, judged.approved));

  if (!request.results_file.empty()) require_writable(request.results_file);
  Results results = results_of(request, tasks_of(selected));
  if (request.approve) {
    approve(results, folder);
    judged = on_record(folder);
  }
  judged.results = std::move(results);
  suite = &judged;
  const int failed = session.run();
  suite = nullptr;
  if (!request.results_file.empty()) write_whole(request.results_file, to_json(judged.results));
  if (failed > 0) suggest(judged.results, folder);
  return failed == 0 ? 0 : 1;
}

}  // namespace oddity
