#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
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

/// One of its claims is wrong, not only incomplete.
bool is_wrong(const Finding&);

/// An exercise's errata by root, in the order of its roots.
std::vector<Finding> findings_of(const ExerciseResult&);
/// Writes the words that name a finding, as a link for example, and all other words.
struct InMarkup {
  std::function<std::string(const Finding&, const std::string& words)> named =
      [](const Finding&, const std::string& words) { return words; };
  std::function<std::string(const std::string& words)> text = [](const std::string& words) { return words; };
};
/// What of the solution stands and what does not, in one sentence: the author's, or one made of the
/// verdicts. Throws std::logic_error where the author's does not agree with them: it names what is no
/// finding, does not name what is wrong, or leaves out what is incomplete and does not count it as the
/// {{rest}}.
std::string verdict_of(const ExerciseResult&, const InMarkup& = {});
/// The errata of all exercises by root, the worst first: the worst of each scene whose published motion goes
/// wrong, by how far it does (`broken_by`); then those of other scenes; then by kind, from a wrong listing or
/// formula to a case left out; then by how many claims come from it.
std::vector<Finding> errata_worst_first(const Results&);
/// How far a scene's published motion is off, in what a game allows; 0: no further than that, or no motion.
double broken_by(const ExerciseResult&);
/// Its claims of one verdict.
std::vector<const JudgedClaim*> claims_of(const ExerciseResult&, Verdict);
/// Those that are wrong or incomplete.
std::vector<const JudgedClaim*> errata_of(const ExerciseResult&);

/// How a verdict is counted: "2 misprints".
struct VerdictNoun {
  Verdict verdict;
  std::string_view one, many;
};
/// In the order in which every list has them: what is wrong first, what is right last.
inline constexpr std::array verdict_nouns{
    VerdictNoun{Verdict::wrong, "wrong", "wrong"},
    VerdictNoun{Verdict::incomplete, "incomplete", "incomplete"},
    VerdictNoun{Verdict::misprint, "misprint", "misprints"},
    VerdictNoun{Verdict::unsettled, "unsettled", "unsettled"},
    VerdictNoun{Verdict::lost, "lost in our copy", "lost in our copy"},
    VerdictNoun{Verdict::not_checkable, "not checkable", "not checkable"},
    VerdictNoun{Verdict::confirmed, "confirmed", "confirmed"}};

/// How many claims have each verdict.
using Counts = std::map<Verdict, int>;
Counts counts_of(const ExerciseResult&);
Counts counts_of(const Results&);
int sum_of(const Counts&);
/// Calls f(noun, count) for each verdict that there is, in order.
template <class F>
void for_each_count(const Counts& counts, const F& f);

/// What was meant is plain, and right.
constexpr bool was_meant(Verdict v) { return v == Verdict::misprint || v == Verdict::lost; }
/// What the decision about a claim rests on: what was meant, what is right, or else what is printed.
const Reading& right_reading(const JudgedClaim&);

/// Of a claim that holds for every sample or fails: `left` counts the samples that violate it.
bool counts_violations(const Check&);

/// Where it is: "equation (7), line 1073".
std::string place_of(const Claim&);

/// What is printed stands in the claim's own words.
bool says_what_is_printed(const Claim&);
/// The same, or of several forms in a row, each of them does.
bool says_each_form(const Claim&);

/// The model has the book's own equations, by its name.
bool is_published(std::string_view model);
/// The published version of a scene among its recorded motions, and the truest; none where the book has no
/// motion of its own.
const Path* published_path(const ExerciseResult&);
const Path& true_path(const Trajectory&);
const Trajectory* trajectory_of(const ExerciseResult&);

/// "1 misprint", "2 misprints".
std::string counted(long n, std::string_view one, std::string_view many);

template <class F>
void for_each_count(const Counts& counts, const F& f) {
  for (const VerdictNoun& noun : verdict_nouns)
    if (const auto found = counts.find(noun.verdict); found != counts.end() && found->second > 0)
      f(noun, found->second);
}

}  // namespace oddity
