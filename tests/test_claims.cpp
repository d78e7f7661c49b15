#include <cmath>
#include <limits>

#include "chapters/contents.hpp"
#include "chapters/typeset.hpp"
#include "reference/reference.hpp"
#include "reference/verdicts.hpp"
#include "report/study/results.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

const std::filesystem::path tables = std::filesystem::path(ODDITY_SOURCE) / "reference";

Findings studied(const Entry& entry, std::initializer_list<std::pair<std::string_view, double>> values) {
  Parameters p(entry.exercise.parameters);
  for (const auto& [name, value] : values) p.set(name, value);
  return entry.exercise.study(p, Reference(tables));
}

const Entry& entry_of(Number number) { return *std::ranges::find(registry(), number, &Entry::number); }

bool is_random(const Entry& entry) {
  return std::ranges::find(entry.exercise.parameters, "seed", &Parameter::name) !=
         entry.exercise.parameters.end();
}

const Quantity& quantity_of(const Findings& findings, std::string_view name) {
  return *std::ranges::find(findings.quantities, name, &Quantity::name);
}

/// The reading that decides the verdict.
const Reading& deciding(const Claim& claim) {
  const Verdict v = verdict(claim);
  return v == Verdict::misprint || v == Verdict::lost ? claim.meant
         : is_erratum(v)                              ? claim.corrected
                                                      : claim.printed;
}

/// Resolution of doubles for the terms that a check compares.
double resolution(const Check& check) {
  const double larger = std::max(size_of(check.left.value), size_of(check.right.value));
  return std::numeric_limits<double>::epsilon() * (check.scale > 0 ? check.scale : larger);
}

/// No tolerance may be ten thousand times wider than the observed difference, or than rounding.
void check_tolerances(const Claim& claim) {
  for (const Check& check : deciding(claim).checks) {
    INFO(claim.id << ", " << check.quantity << ": " << check.tolerance.reason);
    CHECK(check.difference() <= check.tolerance.allowed);
    CHECK(check.tolerance.allowed <= 1e4 * std::max(check.difference(), resolution(check)));
  }
}

/// A reading that is one formula is read from the page, and equals the computed one; no other reading claims
/// that.
void check_readings(const Claim& claim) {
  for_each_reading(claim, [&](const std::string& name, const Reading& reading) {
    INFO(claim.id << ", " << name << ": " << reading.text);
    CHECK(reading.as_typeset == is_formula(reading.text));
  });
}

/// A near miss must fail by a thousand tolerances, except where the printed digits are no finer.
void check_near_misses(const Claim& claim) {
  const auto as_printed = [](const Tolerance& t) {
    return t.reason.starts_with("half ") || t.reason == "the way of one step";
  };
  for (const Reading& near : claim.near_misses) {
    double most = 0;  // in tolerances
    for (const Check& check : near.checks)
      if (as_printed(check.tolerance) || !std::isfinite(check.difference()))
        most = std::numeric_limits<double>::infinity();
      else if (check.difference() > 0)
        most = std::max(most, check.difference() / check.tolerance.allowed);
    INFO(claim.id << ": " << near.text);
    CHECK(most > 1000);
  }
}

/// A finding's kind must fit its verdict. An erratum has a root, which is described with a number, and a root
/// has errata.
void check_roots(const Findings& findings) {
  for (const Claim& claim : findings.claims) {
    const Verdict v = verdict(claim);
    if (v == Verdict::confirmed || v == Verdict::not_checkable || v == Verdict::unsettled) continue;
    INFO(claim.id << ", root '" << claim.root << "'");
    CHECK(claim.kind != Fault::none);
    CHECK((v == Verdict::lost) == (claim.kind == Fault::lost_typography));
    if (!is_erratum(v)) continue;
    CHECK((v == Verdict::incomplete) == (claim.kind == Fault::left_out));
    const auto root = std::ranges::find(findings.roots, claim.root, &Root::name);
    REQUIRE(root != findings.roots.end());
    CHECK(root->shows.find_first_of("0123456789") != std::string::npos);
  }
  for (const Root& root : findings.roots) {
    INFO(root.name);
    CHECK(std::ranges::count(findings.claims, root.name, &Claim::root) > 0);
  }
}

void check_claims(const Entry& entry) {
  const Findings findings = studied(entry, {});
  for (const Claim& claim : findings.claims) {
    check_tolerances(claim);
    check_readings(claim);
    check_near_misses(claim);
  }
  check_roots(findings);
}

[[maybe_unused]] const bool registered = [] {
  for (const Entry& entry : registry())
    register_test([&entry] { check_claims(entry); },
                  to_string(entry.number) + ": its claims are no weaker than they look",
                  "[claims][" + to_string(entry.number) + "]");
  return true;
}();

}  // namespace

TEST_CASE("no verdict depends on the seed of the samples", "[claims][slow]") {
  const Verdicts approved = read_verdicts(tables / "approved");
  for (const Entry& entry : registry()) {
    if (!is_random(entry)) continue;
    for (double seed = 101; seed < 106; ++seed)
      for (const Claim& claim : studied(entry, {{"seed", seed}}).claims) {
        INFO(claim.id << " with the seed " << seed);
        CHECK(name_of(verdict(claim)) == approved.at(claim.id));
      }
  }
}

TEST_CASE("6.5: a reference that is computed in doubles states its own rounding error", "[claims][6.5]") {
  const Findings findings = studied(entry_of({6, 5}), {{"b", 0.3}, {"c", 0.7}, {"theta", 0.31}});
  CHECK(quantity_of(findings, "rebound").reference_error > 1e-15);
  CHECK(quantity_of(findings, "patch").reference_error > 1e-15);
}

TEST_CASE("6.5: segments, triangles and parallelograms are compared separately", "[claims][6.5]") {
  const Findings findings = studied(entry_of({6, 5}), {});
  const Claim& claim = *std::ranges::find(findings.claims, "6.5-finite_set", &Claim::id);
  const std::vector<Check>& shapes = claim.corrected.checks;
  REQUIRE(shapes.size() == 3);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(distance(shapes[i].left.value, shapes[(i + 1) % 3].left.value) > 1e-9);
}

TEST_CASE("8.5: a reference that is computed in doubles states its own rounding error", "[claims][8.5]") {
  const auto error = [](double c1, double height) {
    return quantity_of(studied(entry_of({8, 5}), {{"c1", c1}, {"height", height}}), "value").reference_error;
  };
  CHECK(within(error(0.3, 0.3), 1e-15, 1e-13));
  CHECK(within(error(0.3, 1), 1e-15, 1e-13));  // only the first of five points is rounded
}
