#pragma once

#include "report/study/results.hpp"

/// Made-up results, without a run.
namespace oddity {

inline JudgedClaim judged(Check check) {
  Claim claim{.id = "9.9-x", .line = 1, .says = "x is 1"};
  claim.printed = {"x = 1", {std::move(check)}};
  return {claim, verdict(claim)};
}

inline Check one_against_one(double allowed, double scale = 0) {
  return {"x", {"a", 1}, {"b", 1}, {allowed, "a test"}, scale};
}

/// Contains every kind of value in results.
inline Results sample() {
  ExerciseResult e;
  e.number = {3, 5};
  e.title = "A title";
  e.asks = "What is $x$?";
  e.parameters = {{"a", 0.1, "rad", "angle"}};
  JudgedClaim claim = judged(one_against_one(1e-9));
  claim.claim.near_misses = {{"x = 2", {{"x", {"a", 2}, {"b", 1}, exact(), 1, "worst of 3"}}}};
  claim.claim.why = "a | bar";
  Claim wrong{.id = "9.9-y", .line = 2, .says = "y is 1"};
  wrong.printed = {"y = 1", {{"y", {"a", 1}, {"b", 2}, exact(), 1, "a place"}}};
  wrong.meant = {"y = 3", {{"y", {"a", 3}, {"b", 2}, exact(), 1, "a place"}}};
  wrong.corrected = {"y = 2", {one_against_one(0)}};
  wrong.why = "It is two.";
  Claim not_at_hand{.id = "9.9-z", .line = 3, .says = "z"};
  not_at_hand.not_checkable = "no listing";
  e.claims = {claim, {wrong, verdict(wrong)}, {not_at_hand, verdict(not_at_hand)}};
  TimedTrial trial{"model", "algorithm", "step",      0.5, Value{1, 2.25}, 0.25, 0.25, 0.5,
                   0,       42,          Outcome::ok, "",  {1e-6, 1e-8}};
  QuantityResult q{"q", "m", "a length", {"table x.csv", Value{1, 2}}, 1e-16, {0.3, "a reason"}, {}, {}};
  q.methods = {{"model", "algorithm", Outcome::ok, "", {trial, trial}}};
  q.breakdowns = {{"it breaks", Outcome::ok, trial, trial}};
  q.trajectory = Trajectory{
      {"x", "y"}, "s", {1}, {0.5, 1}, {{"model", "algorithm", "step", 0.5, 0.25, Outcome::ok, {1, 2, 3, 4}}},
      0};
  e.quantities = {q};
  q.name = "another";
  q.trajectory->observables = {"theta", "phi"};
  e.quantities.push_back(q);
  e.scene = true;
  e.made_from = "code 1, tables 2, ledger 3";
  e.cheapest_models = CheapestModels{
      {"m"},
      {{"1 degree", {0.1}, Candidate{"model", "algorithm", "step", 0.5, 0.25}}, {"10 digits", {1e-9}, {}}},
      {{"model", "a", "rad", {1, 4}, {{1, 2}, {3, 3.5}}, {0.9, 0.8}, {1.1, 1.2}}},
      {"another model"}};
  TimedTrial broken = trial;
  broken.outcome = Outcome::drifted;
  broken.message = "";
  TimedTrial told = broken;
  told.message = "a message";
  e.stability = Stability{
      "q",
      "m",
      "s",
      10,
      0.1,
      {{"model",
        "algorithm",
        {{1, 2}},
        0.9,
        1.1,
        4,
        7,
        true,
        8,
        true,
        Between{0.9, 1.2},
        trial,
        broken,
        trial,
        trial,
        "a reason",
        "x = 1"},
       {"model", "other", {{2, 3}}, 2, 2.1, 4, 7, false, 8, false, {}, trial, told, {}, trial, "", ""}},
      "a",
      "rad",
      {1, 0.5},
      {{"model", "algorithm", 0.1, 0.7, {Outcome::drifted, Outcome::ok}, {true, false}}}};
  return {{e}};
}

}  // namespace oddity
