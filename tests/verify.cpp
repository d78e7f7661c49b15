#include "tests/verify.hpp"

#include <deque>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/verdicts.hpp"
#include "report/disturb.hpp"
#include "report/markdown.hpp"
#include "report/progress.hpp"
#include "report/run.hpp"
#include "report/stability.hpp"
#include "report/text_view.hpp"
#include "tests/catch.hpp"
#include "tests/catch_main.hpp"

namespace oddity {

namespace {

/// What the test cases judge. Catch2's test functions take no arguments, so it stands here.
struct Judged {
  Results results;
  Verdicts approved;
  Limits limits;
  Maps maps;
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
  INFO(claim.id << " is confirmed and has no near miss");
  CHECK((judged.verdict != Verdict::confirmed || !claim.near_misses.empty()));
}

void verify_quantity(const QuantityResult& q) {
  INFO("quantity " << q.name << ": " << q.says);
  CHECK(finite(q.reference.value));
  CHECK(q.reference_error <= q.need.allowed / 2);
  for (const MethodResult& m : q.methods) {
    INFO(m.model << ", " << m.algorithm << " at its finest setting: error "
                 << shown_error(m.trials.back().error) << ", needed " << shown_error(q.need.allowed) << "; "
                 << m.trials.back().message);
    CHECK(name_of(m.trials.back().outcome) == name_of(m.expected));
  }
  for (const BreakdownResult& b : q.breakdowns) {
    INFO(b.says);
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

/// Whether theory and measurement differ by more than a quarter, which takes a reason.
bool takes_a_reason(const Limit& limit) { return !(agreement(limit) >= 0.8 && agreement(limit) <= 1.25); }

/// Whether a trial has as large an error as is on record, within a quarter; none is like none.
bool same_error(const std::optional<TimedTrial>& t, const std::optional<double>& on_record) {
  if (!t || !on_record) return !t && !on_record;
  return t->error <= 1.25 * *on_record && *on_record <= 1.25 * t->error;
}

bool same_needed(const std::optional<TimedTrial>& t, const std::optional<double>& on_record) {
  return t && on_record ? same_limit(t->setting, *on_record) : !t && !on_record;
}

void verify_limit(const ExerciseResult& e, const Limit& limit) {
  const std::string row = limit_row(e, limit);
  const auto approved = std::ranges::find_if(suite->limits, [&](const ApprovedLimit& a) {
    return a.exercise == to_string(e.number) && a.model == limit.model && a.algorithm == limit.algorithm;
  });
  INFO(limit.model << ", " << limit.algorithm << ": stable to " << shown_step(limit) << ", in theory to "
                   << limit.theory() << "; beyond: " << beyond(limit)
                   << "\nthe row of limits.csv to approve: " << row);
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
  INFO("a reason is on record where theory and measurement differ by more than a quarter, and nowhere else");
  CHECK(takes_a_reason(limit) != approved->why.empty());
}

void verify_map(const ExerciseResult& e, const MapRow& row) {
  const auto approved = std::ranges::find_if(suite->maps, [&](const ApprovedMap& a) {
    return a.exercise == to_string(e.number) && a.model == row.model && a.algorithm == row.algorithm &&
           a.value == row.value;
  });
  INFO("the row of stability_maps.csv to approve: " << map_row(e, row));
  if (approved == suite->maps.end()) {
    FAIL_CHECK("stability_maps.csv has no row for this method");
    return;
  }
  CHECK(letters(row) == approved->outcomes);
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
  for (const Limit& limit : e.stability->limits) verify_limit(e, limit);
  for (const MapRow& row : e.stability->map) verify_map(e, row);
}

void verify_exercise(Number number) {
  const ExerciseResult& e = result_of(number);
  INFO("exercise " << to_string(number) << " raised: " << e.failure);
  REQUIRE(e.failure.empty());
  REQUIRE_FALSE(e.claims.empty());
  for (const JudgedClaim& claim : e.claims) {
    CHECK(claim.claim.id.starts_with(to_string(number) + "-"));
    CHECK(claim.claim.line > 0);
    verify_claim(claim);
    CHECK(unnoticed_disturbances(claim) == std::vector<std::string>());
  }
  for (const QuantityResult& q : e.quantities) verify_quantity(q);
  verify_stability(e);
}

/// Every odd exercise is encoded or on record as not yet encoded, and every verdict on record belongs to a
/// claim.
void verify_register() {
  for (const Chapter& chapter : chapters())
    for (int index = 1; index <= chapter.last_odd; index += 2) {
      const Number number{chapter.number, index};
      const bool encoded =
          std::ranges::any_of(registry(), [&](const Entry& e) { return e.number == number; });
      const auto row = suite->approved.find(to_string(number));
      const bool missing_on_record = row != suite->approved.end() && row->second == not_yet_encoded;
      INFO("exercise " << to_string(number)
                       << (encoded ? " is encoded but on record as not yet encoded"
                                   : " is neither encoded nor on record as not yet encoded"));
      CHECK(encoded != missing_on_record);
    }
  for (const auto& row : suite->approved) {
    const std::string &id = row.first, &verdict = row.second;
    const auto number = exercise_number(id.substr(0, id.find('-')));
    INFO("verdicts.csv: " << id);
    REQUIRE(number);
    for (const ExerciseResult& e : suite->results.exercises)
      if (e.number == *number && verdict != not_yet_encoded)
        CHECK(std::ranges::any_of(e.claims, [&](const JudgedClaim& c) { return c.claim.id == id; }));
  }
}

/// A test function for the exercise at each place of the registry: Catch2 wants plain functions.
constexpr std::size_t most_exercises = 48;
template <std::size_t I>
void verify_registered() {
  verify_exercise(registry()[I].number);
}
template <std::size_t... I>
constexpr auto test_functions(std::index_sequence<I...>) {
  return std::array{&verify_registered<I>...};
}

std::string name_of_test(const Entry& e) { return to_string(e.number) + " " + std::string(e.exercise.title); }

std::string tags_of(const Entry& e, const Verdicts& approved) {
  std::string tags = "[ch" + std::to_string(e.number.chapter) + "][" + to_string(e.number) + "]";
  if (e.exercise.scene) tags += "[scene]";
  for (const std::string verdict : {"erratum", "misprint"})
    if (std::ranges::any_of(approved, [&](const auto& row) {
          return row.second == verdict && row.first.starts_with(to_string(e.number) + "-");
        }))
      tags += "[" + verdict + "]";
  return tags;
}

void register_tests(const Verdicts& approved) {
  static constexpr auto functions = test_functions(std::make_index_sequence<most_exercises>());
  static std::deque<std::string> texts;  // Catch2 keeps views of these
  for (std::size_t i = 0; i < registry().size(); ++i) {
    const std::string& name = texts.emplace_back(name_of_test(registry()[i]));
    const std::string& tags = texts.emplace_back(tags_of(registry()[i], approved));
    REGISTER_TEST_CASE(functions.at(i), name, tags);
  }
  REGISTER_TEST_CASE(verify_register, std::string(register_name), "[register]");
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

}  // namespace

int verify(const SuiteRequest& request) {
  Judged judged{{},
                read_verdicts(request.reference_folder),
                read_limits(request.reference_folder),
                read_maps(request.reference_folder)};
  register_tests(judged.approved);
  CatchSession session(request.catch_arguments);
  if (!session.accepted())
    throw BadInput("Catch2 does not take these arguments; oddity verify -? shows what it takes");
  if (session.only_lists()) return session.run(), 0;
  const auto selected = session.selected();
  if (selected.empty()) throw BadInput("no test case matches; oddity verify --list-tests shows them all");

  if (!request.results_file.empty()) require_writable(request.results_file);
  const Reference truth(request.reference_folder);
  ProgressBar bar;
  const std::vector<Task> tasks = tasks_of(selected);
  judged.results = with_stability(run(tasks, truth, !request.results_file.empty(), bar.callback()), tasks,
                                  truth, judged.limits, bar.callback());
  suite = &judged;
  const int failed = session.run();
  suite = nullptr;
  if (!request.results_file.empty()) write_whole(request.results_file, to_json(judged.results));
  return failed == 0 ? 0 : 1;
}

}  // namespace oddity
