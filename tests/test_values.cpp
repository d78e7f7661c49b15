#include "chapters/exercise.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_CASE("NaN, infinity and different sizes never compare", "[values]") {
  CHECK(std::isnan(distance(Value{1, no_number}, {1, 2})));
  CHECK(std::isnan(distance({infinity}, {infinity})));
  CHECK(std::isnan(distance({1, 2}, {1})));
  CHECK(std::isnan(distance(Value(), Value())));
  CHECK(distance({1, 2}, {1, 4}) == 2);
}

TEST_CASE("a check holds within its tolerance, and never for NaN, infinity or an empty value", "[values]") {
  const auto check = [](Value left, Value right, double allowed) {
    return Check{"x", {"a", std::move(left)}, {"b", std::move(right)}, {allowed, "a test"}}.holds();
  };
  CHECK(check(1, 1.5, 0.5));
  CHECK_FALSE(check(1, 1.5, 0.49));
  CHECK_FALSE(check(1, 1.5, no_number));
  CHECK_FALSE(check(no_number, no_number, 1));
  CHECK_FALSE(check(infinity, infinity, infinity));
  CHECK_FALSE(check(infinity, 1, infinity));
  CHECK_FALSE(check(Value(), Value(), 1));
}

TEST_CASE("statements without samples do not hold", "[values]") {
  CHECK(no_violations("bad", 0, 10).holds());
  CHECK_FALSE(no_violations("bad", 1, 10).holds());
  CHECK_FALSE(no_violations("bad", 0, 0).holds());
  CHECK_FALSE(WorstSample("x", "a", "b").check().holds());
}

TEST_CASE("among samples with equal errors the first is kept, whatever the roundings", "[values]") {
  WorstSample worst("x", "a", "b");
  worst.add(1.0, 2.0, 1.0, "first");
  worst.add(1.0, 2.0 + 1e-12, 1.0, "off by a rounding more");
  CHECK(worst.check().where == "worst of 2: first");
  worst.add(1.0, 2.0 + 1e-5, 1.0, "off by more");
  CHECK(worst.check().where == "worst of 3: off by more");
}

TEST_CASE("a sample beyond its tolerance is not hidden by one barely within", "[values]") {
  WorstSample worst("x", "a", "b");
  worst.add(0.0, 1.0, {1, "a test"}, 1, "within");
  CHECK(worst.check().holds());
  worst.add(0.0, 1 + 1e-9, {1, "a test"}, 1, "beyond");
  CHECK_FALSE(worst.check().holds());
}

TEST_CASE("the worst sample is kept, and NaN is the worst of all", "[values]") {
  WorstSample worst("x", "a", "b");
  worst.add(1, 1, {0.1, "a test"}, 1, "first");
  worst.add(1, 1.3, {0.1, "a test"}, 1, "second");
  worst.add(1, 1.2, {0.1, "a test"}, 1, "third");
  CHECK(worst.check().where == "worst of 3: second");
  worst.add(no_number, 1, {0.1, "a test"}, 1, "fourth");
  CHECK(worst.check().where == "worst of 4: fourth");
  CHECK_FALSE(worst.check().holds());
}

TEST_CASE("the first reading that holds decides; a near miss that holds unsettles", "[values]") {
  const Reading yes{"", {{"x", {"a", 1}, {"b", 1}, exact()}}}, no{"", {{"x", {"a", 1}, {"b", 2}, exact()}}},
      none;
  const auto judged = [](Reading printed, Reading meant, Reading corrected, std::vector<Reading> near = {}) {
    return verdict({.printed = std::move(printed),
                    .meant = std::move(meant),
                    .corrected = std::move(corrected),
                    .near_misses = std::move(near)});
  };
  CHECK(judged(yes, yes, yes) == Verdict::confirmed);
  CHECK(judged(no, yes, yes) == Verdict::misprint);
  CHECK(judged(no, no, yes) == Verdict::wrong);
  CHECK(judged(no, none, none) == Verdict::unsettled);
  CHECK(judged(none, none, none) == Verdict::unsettled);
  CHECK(judged(yes, none, none, {no}) == Verdict::confirmed);
  CHECK(judged(yes, none, none, {no, yes}) == Verdict::unsettled);
}

TEST_CASE("text lost in our copy is no misprint, and a claim that holds in the considered cases is not wrong",
          "[values]") {
  const Reading yes{"", {{"x", {"a", 1}, {"b", 1}, exact()}}}, no{"", {{"x", {"a", 1}, {"b", 2}, exact()}}};
  Claim claim{.printed = no, .meant = yes, .kind = Fault::lost_typography};
  CHECK(verdict(claim) == Verdict::lost);
  claim.kind = Fault::formula;
  CHECK(verdict(claim) == Verdict::misprint);
  claim = {.printed = no, .corrected = yes, .in_view = yes};
  CHECK(verdict(claim) == Verdict::incomplete);
  claim.in_view = no;
  CHECK(verdict(claim) == Verdict::wrong);
  claim.kind = Fault::left_out;
  CHECK(verdict(claim) == Verdict::wrong);
  claim.in_view = {};
  CHECK(verdict(claim) == Verdict::incomplete);
  claim.kind = Fault::none;
  CHECK(verdict(claim) == Verdict::wrong);
  claim.in_view = yes;
  claim.printed = yes;
  CHECK(verdict(claim) == Verdict::confirmed);
}

TEST_CASE("a claim that cannot be judged has a reason and no readings", "[values]") {
  Claim claim{.id = "id", .line = 1, .says = "says"};
  CHECK(verdict(claim) == Verdict::unsettled);
  claim.not_checkable = "the program is not at hand";
  CHECK(verdict(claim) == Verdict::not_checkable);
  claim.printed = {"x", {{"x", {"a", 1}, {"b", 1}, exact()}}};
  CHECK(verdict(claim) == Verdict::unsettled);
}

namespace {

Outcome outcome_of(const Answer& answer, Value reference = 1, double need = 1e-3) {
  Quantity q{"q", "1", "", {"truth", std::move(reference)}, 0, {need, "a test"}};
  q.add({"model", "algorithm", no_resolution(), [=](double) { return answer; }});
  return run(q, q.methods[0], 0).outcome;
}

Answer ended(Ending ending) {
  Answer answer{1};
  answer.ending = ending;
  return answer;
}

}  // namespace

TEST_CASE("outcomes are computed from value, estimate, drift and ending", "[values]") {
  CHECK(outcome_of({1.0005}) == Outcome::ok);
  CHECK(outcome_of({1.002}) == Outcome::inaccurate);
  CHECK(outcome_of({12}) == Outcome::diverged);
  CHECK(outcome_of({no_number}) == Outcome::non_finite);
  CHECK(outcome_of({infinity}) == Outcome::non_finite);
  CHECK(outcome_of({Value{1, 1}}) == Outcome::non_finite);
  CHECK(outcome_of({1.0005, 1, 1e-4}) == Outcome::deceived);
  CHECK(outcome_of({1.0005, 1, 1e-3}) == Outcome::ok);
  CHECK(outcome_of({1.0005, 1, no_number, 2e-3}) == Outcome::ok);
  CHECK(outcome_of({1.0005, 1, no_number, 0.02}) == Outcome::drifted);
  CHECK(outcome_of({1.1, 1, no_number, 2e-3}) == Outcome::inaccurate);
  CHECK(outcome_of({1.1, 1, no_number, 0.02}) == Outcome::drifted);
  CHECK(outcome_of({1, 1, no_number, no_number}) == Outcome::drifted);
  CHECK(outcome_of(ended(Ending::raised)) == Outcome::raised);
  CHECK(outcome_of(ended(Ending::stalled)) == Outcome::stalled);
  CHECK(outcome_of(ended(Ending::non_finite)) == Outcome::non_finite);
  CHECK(outcome_of(ended(Ending::chattering)) == Outcome::chattering);
  CHECK(outcome_of(ended(Ending::grazing)) == Outcome::grazing);
}

TEST_CASE("a motion that grows has diverged, and one that does not come back has drifted", "[values]") {
  const auto looked_at = [](std::vector<double> seen, std::vector<double> truth) {
    Quantity q{"q", "1", "", {"truth", Value(std::move(truth))}, 0, {1e-3, "a test"}};
    q.samples = 4;
    q.add({"model", "algorithm", no_resolution(), [=](double) { return Answer{Value(seen), 1}; }});
    return run(q, q.methods[0], 0).outcome;
  };
  CHECK(looked_at({1, 10, 100, 1000}, {1, 1, 1, 1}) == Outcome::diverged);
  CHECK(looked_at({-1, 10, -10, 20}, {1, 1, 1, 1}) == Outcome::diverged);
  CHECK(looked_at({0.2, 0.04, 0.008, 0.0016}, {0.001, 1e-6, 1e-9, 1e-12}) == Outcome::inaccurate);
  CHECK(looked_at({20, -20, 20, -20}, {1, 1, 1, 1}) == Outcome::inaccurate);
  CHECK(looked_at({20, 20, 20, 20}, {1, 1, 1, 1}) == Outcome::inaccurate);
  Answer to_and_fro{1.1, 1, no_number, 0.02};
  to_and_fro.comes_back = true;
  CHECK(outcome_of(to_and_fro) == Outcome::inaccurate);
  to_and_fro.value = 1.0005;
  CHECK(outcome_of(to_and_fro) == Outcome::ok);
}

TEST_CASE("a method that throws has the outcome raised", "[values]") {
  Quantity q{"q", "1", "", {"truth", 1}, 0, {1, "a test"}};
  q.add({"model", "algorithm", no_resolution(), [](double) -> Answer { throw std::runtime_error("no"); }});
  const Trial trial = run(q, q.methods[0], 0);
  CHECK(trial.outcome == Outcome::raised);
  CHECK(trial.answer.message == "no");
}
