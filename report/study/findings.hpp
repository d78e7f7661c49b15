#pragma once

#include <string>
#include <vector>

#include "report/study/results.hpp"

/// What is wrong in the book, in the order in which the pages of the report and of the site show it.
namespace oddity {

/// Errata of one root, which are one finding. An erratum that stands alone has a group of its own.
struct Finding {
  const ExerciseResult* exercise;
  const Root* root;  ///< null: the results name none
  std::vector<const JudgedClaim*> claims;

  std::string title() const;  ///< the root's name, as a title
  std::string shows() const;  ///< what one would see of it; empty: nothing is said
};

/// An exercise's errata by root, in the order of its roots.
std::vector<Finding> findings_of(const ExerciseResult&);
/// The errata of all exercises by root, the worst first: the worst of each scene whose published motion goes
/// wrong, by how far it does (`broken_by`); then those of other scenes; then by kind, from a wrong listing or
/// formula to a case left out; then by how many claims come from it.
std::vector<Finding> errata_worst_first(const Results&);
/// How far a scene's published motion is off, in what a game allows; 0: no further than that, or no motion.
double broken_by(const ExerciseResult&);
/// Its claims of one verdict.
std::vector<const JudgedClaim*> claims_of(const ExerciseResult&, Verdict);

/// How many claims have each verdict.
struct Tally {
  int confirmed = 0, misprints = 0, errata = 0, not_checkable = 0, unsettled = 0;
  int all() const { return confirmed + misprints + errata + not_checkable + unsettled; }
  int wrong() const { return misprints + errata + unsettled; }
  void count(const ExerciseResult&);
};

/// What the decision about a claim rests on: what was meant by a misprint, what is right for an erratum.
const Reading& right_reading(const JudgedClaim&);

/// Of a claim that holds for every sample or fails: `left` counts the samples that violate it.
bool counts_violations(const Check&);

/// What is printed stands in the claim's own words.
bool says_what_is_printed(const Claim&);

/// The published version of a scene among its recorded motions, and the truest; none where the book has no
/// motion of its own.
const Path* published_path(const ExerciseResult&);
const Path& true_path(const Trajectory&);
const Trajectory* trajectory_of(const ExerciseResult&);

/// "1 erratum", "2 errata".
std::string counted(long n, const std::string& one, const std::string& many);

}  // namespace oddity
