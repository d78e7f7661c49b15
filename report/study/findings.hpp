#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "report/study/results.hpp"

/// Errors of the book, in the order in which the report and the site show them.
namespace oddity {

/// Errata of one root: a single finding. An erratum without a root is a finding by itself.
struct Finding {
  const ExerciseResult* exercise;
  const Root* root;  ///< null: the results name none
  std::vector<const JudgedClaim*> claims;

  std::string title() const;  ///< the root's name, as a title
  std::string shows() const;  ///< its visible effect; empty: not stated
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
/// One sentence on which parts of the solution are right and which are not: the author's, or one made from
/// the verdicts. Throws std::logic_error if the author's contradicts them: it names something that is no
/// finding, leaves out something wrong, or leaves out something incomplete without counting it as the
/// {{rest}}.
std::string verdict_of(const ExerciseResult&, const InMarkup& = {});
/// The errata of all exercises by root, the worst first. First the worst of each scene whose published motion
/// goes wrong, by its error (`broken_by`), then those of other scenes. Then by kind, from a wrong listing or
/// formula to a missing case; then by the number of claims.
std::vector<Finding> errata_worst_first(const Results&);
/// Error of a scene's published motion, in a game's tolerances; 0: within it, or no motion.
double broken_by(const ExerciseResult&);
/// The claims of one verdict.
std::vector<const JudgedClaim*> claims_of(const ExerciseResult&, Verdict);
/// The claims that are wrong or incomplete.
std::vector<const JudgedClaim*> errata_of(const ExerciseResult&);

/// A verdict's name in counts: "2 misprints".
struct VerdictNoun {
  Verdict verdict;
  std::string_view one, many;
};
/// The order of every list: wrong claims first, correct ones last.
inline constexpr std::array verdict_nouns{
    VerdictNoun{Verdict::wrong, "wrong", "wrong"},
    VerdictNoun{Verdict::incomplete, "incomplete", "incomplete"},
    VerdictNoun{Verdict::misprint, "misprint", "misprints"},
    VerdictNoun{Verdict::unsettled, "unsettled", "unsettled"},
    VerdictNoun{Verdict::lost, "lost in our copy", "lost in our copy"},
    VerdictNoun{Verdict::not_checkable, "not checkable", "not checkable"},
    VerdictNoun{Verdict::confirmed, "confirmed", "confirmed"}};

/// Number of claims with each verdict.
using Counts = std::map<Verdict, int>;
Counts counts_of(const ExerciseResult&);
Counts counts_of(const Results&);
int sum_of(const Counts&);
/// Calls f(noun, count) for each verdict that occurs, in order.
template <class F>
void for_each_count(const Counts& counts, const F& f);

/// The intended meaning is plain, and right.
constexpr bool was_meant(Verdict v) { return v == Verdict::misprint || v == Verdict::lost; }
/// The reading that decides a claim: the intended one, the right one, or else the printed one.
const Reading& right_reading(const JudgedClaim&);

/// The claim holds for every sample or fails: `left` counts the samples that violate it.
bool counts_violations(const Check&);

/// Place of the claim: "equation (7), line 1073".
std::string place_of(const Claim&);

/// The claim's own words include the printed text.
bool shows_printed(const Claim&);
/// The claim's own words include the printed text, or each form if the text is a row of several.
bool shows_each_form(const Claim&);

/// The model has the book's own equations, judged by its name.
bool is_published(std::string_view model);
/// The published version of a scene among its recorded motions, and the truest. Null if the book has no
/// motion.
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
