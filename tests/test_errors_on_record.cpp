#include <cmath>

#include "reference/errors.hpp"
#include "report/study/errors.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

ErrorsOnRecord row(std::vector<std::optional<double>> errors, std::vector<std::optional<double>> work,
                   std::string at = "step 0.5 0.25") {
  return {"3.5", "swing: one angle, Runge-Kutta 4", std::move(at), std::move(errors), std::move(work)};
}

/// A claim, rounded to a thousandth. A quantity of 1 by a method of two trials, one off by a tenth and one by
/// roundings only, and a breakdown of them.
ExerciseResult an_exercise() {
  TimedTrial coarse, fine;
  coarse.model = fine.model = "model";
  coarse.algorithm = fine.algorithm = "algorithm";
  coarse.resolution = fine.resolution = "step";
  coarse.setting = 0.5, coarse.error = 0.1, coarse.evaluations = 3;
  fine.setting = 0.25, fine.error = 1e-15, fine.evaluations = 6;
  QuantityResult q;
  q.name = "swing";
  q.reference.value = Value{1.0};
  q.need = {1e-6, ""};
  q.methods.push_back({"model", "algorithm", Outcome::ok, "", {coarse, fine}});
  q.breakdowns.push_back({"it breaks", Outcome::inaccurate, coarse, fine});
  Check wrong;
  wrong.left.value = Value{3.0};
  wrong.right.value = Value{1.0};
  wrong.tolerance = {1e-3, ""};
  JudgedClaim claim;
  claim.claim.id = "3.5-value";
  claim.claim.line = 7;
  claim.verdict = Verdict::confirmed;
  claim.claim.near_misses.push_back({"wrong", {wrong}});
  Check within = wrong;
  within.left.value = Value{0.9995};
  claim.claim.printed = {"rounded", {within}};
  ExerciseResult e;
  e.number = {3, 5};
  e.claims.push_back(claim);
  e.quantities.push_back(q);
  return e;
}

std::vector<std::string> texts_of(const ExerciseResult& e) {
  std::vector<std::string> texts;
  for (const ErrorsOnRecord& r : errors_of(e)) texts.push_back(text_of(r));
  return texts;
}

}  // namespace

TEST_CASE("wrong readings, wide tolerances, needs, trials and breakdowns have a row of errors each",
          "[errors]") {
  const std::vector<std::string> rows{"3.5,claim value,7,2,", "3.5,claim value: tolerances,,0.001,",
                                      "3.5,swing: need,,1e-06,",
                                      "3.5,\"swing: model, algorithm\",step 0.5 0.25,0.1 0,3 6",
                                      "3.5,swing: breakdown 1,step 0.5 0.25,0.1 0,3 6"};
  CHECK(texts_of(an_exercise()) == rows);
  CHECK(error_rows(an_exercise(), {}) == rows);
  ExerciseResult unsettled = an_exercise();
  unsettled.claims[0].verdict = Verdict::unsettled;
  CHECK(texts_of(unsettled) == std::vector(rows.begin() + 2, rows.end()));
}

TEST_CASE("the last bits may decide whether there is a row at all", "[errors]") {
  ErrorsOnRecord narrow = row({std::nullopt}, {}, "");
  narrow.of = "claim value: tolerances";
  CHECK(is_left_to_last_bits(narrow));
  CHECK_FALSE(is_left_to_last_bits(row({}, {})));
  CHECK_FALSE(is_left_to_last_bits(row({std::nullopt, 0.1}, {})));
  CHECK_FALSE(is_left_to_last_bits(row({std::nullopt}, {3})));
  ExerciseResult e = an_exercise();
  const std::string kept = "3.5,claim value: tolerances,,~,";
  CHECK(error_rows(e, {narrow})[1] == kept);
  e.claims[0].claim.printed.checks[0].tolerance.allowed = 1e-12;  // only roundings
  e.claims[0].claim.printed.checks[0].left.value = Value{1};
  CHECK(texts_of(e).size() == 4);
  CHECK(error_rows(e, {narrow}).back() == kept);
  CHECK(error_rows(e, {}).size() == 4);
}

TEST_CASE("errors agree within 2 %, work exactly or within 10 % for a tolerance, last bits always",
          "[errors]") {
  const ErrorsOnRecord kept = row({0.1, std::nullopt}, {10, 20});
  CHECK(agree(row({0.1019, 7}, {10, 20}), kept));
  CHECK_FALSE(agree(row({0.1021, 7}, {10, 20}), kept));
  CHECK_FALSE(agree(row({-0.1, 7}, {10, 20}), kept));
  CHECK_FALSE(agree(row({NAN, 7}, {10, 20}), kept));
  CHECK_FALSE(agree(row({0.1, 7}, {10, 21}), kept));
  CHECK_FALSE(agree(row({0.1}, {10, 20}), kept));
  CHECK_FALSE(agree(row({0.1, 7}, {10, 20}, "step 0.5 0.125"), kept));
  CHECK(agree(row({0, INFINITY}, {10, 20}), row({0, INFINITY}, {10, 20})));
  CHECK_FALSE(agree(row({0, 1e-3}, {10, 20}), row({1e-9, 1e-3}, {10, 20})));
  const ErrorsOnRecord by_tolerance = row({0.1}, {100}, "tolerance 1e-3");
  CHECK(agree(row({0.1}, {109}, "tolerance 1e-3"), by_tolerance));
  CHECK_FALSE(agree(row({0.1}, {111}, "tolerance 1e-3"), by_tolerance));
}

TEST_CASE("a new record keeps rows that agree, and those that last bits decide", "[errors]") {
  const ExerciseResult e = an_exercise();
  std::vector<ErrorsOnRecord> kept = errors_of(e);
  kept[3].errors = {0.1011, std::nullopt};
  CHECK(error_rows(e, kept)[3] == "3.5,\"swing: model, algorithm\",step 0.5 0.25,0.101 ~,3 6");
  kept[3].errors = {0.3, std::nullopt};
  CHECK(error_rows(e, kept)[3] == "3.5,\"swing: model, algorithm\",step 0.5 0.25,0.1 ~,3 6");
}

TEST_CASE("recorded errors are read, broken ones named by line", "[errors]") {
  const ScratchFolder folder;
  const std::string head = "exercise,of,at,errors,work\n";
  const std::string file =
      folder.file("errors.csv", head + "3.5,\"swing: a, b\",step 0.5 0.25,nan ~,80 160\n").string();
  const std::vector<ErrorsOnRecord> read = read_errors(folder.path());
  REQUIRE(read.size() == 1);
  CHECK(read[0].of == "swing: a, b");
  CHECK(text_of(read[0]) == "3.5,\"swing: a, b\",step 0.5 0.25,nan ~,80 160");
  CHECK(read[0].place == file + ":2");
  const auto said = [&](const std::string& text) {
    folder.file("errors.csv", text);
    const std::string all = complaint([&] { read_errors(folder.path()); });
    return all.starts_with(file) ? all.substr(file.size()) : all;
  };
  CHECK(said(head + "3.5,a,1,0.1 x,\n") == ":2: 'x' is neither a number nor ~");
  CHECK(said(head + "3.5,a,1,1,\n3.5,a,2,1,\n") == ":3: a second row for 3.5, a");
  CHECK(said("exercise,of\n3.5,a\n") == ":1: the columns must be exercise,of,at,errors,work");
}
