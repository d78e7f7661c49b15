#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "chapters/contents.hpp"
#include "report/study/need.hpp"

/// What comes of a run, as plain values: everything that a view, a judge or a file needs, and nothing that
/// runs.
namespace oddity {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct JudgedClaim {
  Claim claim;
  Verdict verdict = Verdict::unsettled;
};

/// The readings of a claim under their names; near misses are numbered.
template <class C, class F>
void for_each_reading(C& claim, const F& f) {
  f("printed", claim.printed);
  f("meant", claim.meant);
  f("corrected", claim.corrected);
  f("in view", claim.in_view);
  for (std::size_t i = 0; i < claim.near_misses.size(); ++i)
    f("near miss " + std::to_string(i + 1), claim.near_misses[i]);
}

/// How long something takes: the median of several batches, and half their interquartile range.
struct Time {
  double seconds = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not timed
  double spread = std::numeric_limits<double>::quiet_NaN();
};

struct TimedTrial {
  std::string model, algorithm, knob;
  double setting = 0;
  Value value;
  double error = 0;           ///< the largest of all components
  double final_error = 0;     ///< at the last time alone
  double error_estimate = 0;  ///< NaN: the method has none
  double drift = 0;
  long evaluations = 0;
  Outcome outcome = Outcome::raised;
  std::string message;
  Time time = {};
  Precision precision = Precision::in_double;
  double roundings = 0;  ///< in float: what roundings may add to the error that the like trial in double has
  bool comes_back = false;  ///< the drift is to and fro
};

/// A method's trials from coarse to fine, and how the finest is expected to end.
struct MethodResult {
  std::string model, algorithm;
  Outcome expected = Outcome::ok;
  std::string why;
  std::vector<TimedTrial> trials;

  bool as_expected() const { return !trials.empty() && trials.back().outcome == expected; }
};

/// A method in float, its trials at the settings of the like one in double.
struct FloatResult {
  std::string model, algorithm;
  std::size_t in_double = 0;  ///< the place of that one among the quantity's methods
  std::vector<TimedTrial> trials;
};

/// Whether a trial in float errs by no more than twice the error of the like one in double and what roundings
/// may add. Of a motion that double does not follow, nothing is asked.
bool as_accurate_as_roundings_allow(const TimedTrial& in_float, const TimedTrial& in_double);

/// A breakdown's two rows as they were run.
struct BreakdownResult {
  std::string says;
  Outcome expected = Outcome::ok;
  TimedTrial broken, cured;

  bool as_expected() const { return broken.outcome == expected && cured.outcome == Outcome::ok; }
};

/// One model's motion as it is drawn.
struct Path {
  std::string model, algorithm, knob;
  double setting = 0;
  double error = 0;  ///< at the times where the reference is known
  Outcome outcome = Outcome::raised;
  Value value;  ///< the observables of one time after the other; not all of them where the motion broke off
};

/// A scene's motion, by each of its models.
struct Trajectory {
  std::vector<std::string> observables;  ///< their names, if they have any
  std::string time_unit;
  std::vector<double> judged_at;  ///< the times of the quantity's reference
  std::vector<double> times;      ///< of the paths
  std::vector<Path> paths;
  std::size_t truest = 0;  ///< the path that is closest to the reference
  double close = 0;        ///< the error that a game allows, in the observables' unit
};

struct QuantityResult {
  std::string name, unit, says;
  Route reference;
  double reference_error = 0;
  Tolerance need;
  std::vector<MethodResult> methods;
  std::vector<BreakdownResult> breakdowns;
  std::optional<Trajectory> trajectory = {};  ///< of a scene's motion
  int samples = 1;                            ///< of a motion: the times at which it is judged
  std::vector<FloatResult> in_float = {};
  /// Of a motion: the components of one time that make a point or an angle; none: judged by the largest one.
  std::vector<std::vector<std::size_t>> norms = {};
  bool in_operations = false;  ///< work is counted in multiplications, divisions and functions
};

/// "judged at these 4 times alone" of a motion; empty for what is no motion.
std::string instants(const QuantityResult&);

/// A method at one setting, over several starts.
struct Candidate {
  std::string model, algorithm, knob;
  double setting = 0;
  double error = 0;  ///< the largest over the starts it was chosen on, in units of what was asked
  std::vector<double> errors = {};      ///< the same in each of the motion's units
  std::map<Criterion, double> by = {};  ///< the same by each criterion asked for but path, in its own unit
  Outcome outcome = Outcome::ok;
  std::string where = {};  ///< the start on which it ended so, unless ok
  std::string why = {};    ///< what the error does not say of that, as that its swing grows
  double evaluations_per_frame = 0;
  double seconds_per_frame = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not timed
  double spread = 0;                                                    ///< of the seconds
  double unseen_error = std::numeric_limits<double>::quiet_NaN();  ///< over the starts it was not chosen on
  double unbounded_error = 0;  ///< were it not bounded by the motion's size, as far as that can be told
  Precision precision = Precision::in_double;
  std::size_t state_size = 0;  ///< numbers; 0: a closed form keeps none

  bool holds() const { return outcome == Outcome::ok; }
};

/// The first model of the ladder, from the least on, that holds for a need by any algorithm, with the least
/// work.
struct CheapestModel {
  std::string says;  ///< "1 degree", "10 digits"
  Need need;
  std::optional<Candidate> least;          ///< none: nothing here holds
  std::optional<Candidate> in_float = {};  ///< the same in float; none: it is in double only
};

/// Values of a parameter between which a model is enough.
struct Interval {
  double from, to;
};

/// Where a model is enough for what a game asks, solved exactly, along one parameter.
struct BreakEven {
  std::string model, parameter, parameter_unit;
  Interval looked;               ///< the parameter's values that were looked through
  std::vector<Interval> enough;  ///< ascending, apart; each end inside to one in a thousand
  /// The model's error in needs at the ends inside, on the side that holds and on the one that fails, by the
  /// reference; not a number where that could not be had.
  std::vector<double> holding = {}, failing = {};
  bool coarse = false;  ///< an end is not known to one in a thousand, as no motion is known near it
  /// Why the model has no motion beyond an end, where it has none: there it fails at once, not by degrees.
  std::string why = {};
};

struct CheapestModels {
  std::vector<std::string> units;    ///< each once, those of a candidate's errors
  std::vector<CheapestModel> least;  ///< over 10 s at 60 frames per second: for a game, and for 10 digits
  std::vector<BreakEven> break_evens;
  std::vector<std::string> never;  ///< models that are not enough for a game wherever it was looked
};

/// The least and the most of a limit.
struct Between {
  double least, most;
};

/// Up to which step a method of fixed step is stable, how far it is from the truth there, how it breaks
/// beyond, and what cures it.
struct Limit {
  std::string model, algorithm;
  std::vector<ode::Tongue> tongues;  ///< the steps at which it is unstable by linear theory
  double stable = 0;                 ///< measured: up to here every step tried is stable; 0: none is
  double unstable = 0;               ///< measured: the shortest unstable step; 0: none up to `longest`
  double longest = 0;                ///< the longest step that the measurement may try
  double lost = 0;                   ///< the time at which the motion is lost at that step
  bool outgrown = false;  ///< lost, as it is twice as large as the true one; else neighbours have parted
  double watched = 0;     ///< the time for which neighbouring motions are watched
  bool goes_on = false;   ///< the motion goes on alike: `watched` is not the horizon shown
  /// Where the limit is not sharp: between which it lies for observers who watch half or twice as long, or
  /// count a motion of 1.5 or 4 times the true size as too large, and not of twice. They differ by over 5 %.
  std::optional<Between> soft;
  std::optional<TimedTrial> at;  ///< the motion by the longest step that is stable and divides its interval
  std::optional<TimedTrial> broken;  ///< and by the next longer one that is unstable
  std::optional<TimedTrial> within;  ///< by the largest step below which all are within the scene's need
  std::optional<TimedTrial> cure;    ///< what is within the need at the step of `broken`
  std::string why;                   ///< where theory and measurement differ by more than a quarter
  std::string evidence;              ///< what was computed for that, in numbers

  /// Where linear theory's first tongue begins; 0: every step is unstable; infinity: none is.
  double theory() const;
  /// The largest stable step; 0: none; infinity: every step, which takes that theory proves it.
  double step() const;
};

/// How a method ends at one value of a scene's parameter, step by step.
struct MapRow {
  std::string model, algorithm;
  double value = 0;
  double theory = 0;  ///< infinity: every step is stable
  std::vector<Outcome> outcomes;
  std::vector<bool> fragile;  ///< whether it ends otherwise from a start that is a few roundings off
};

/// Where the methods of a scene break: over the step, and over the parameter that makes the scene hard.
struct Stability {
  std::string quantity, unit;
  std::string time_unit;  ///< of the horizon and of every step and limit
  double horizon = 0;
  double close = 0;  ///< the need, in the unit
  std::vector<Limit> limits;
  std::string parameter, parameter_unit;
  std::vector<double> steps;  ///< of the map, from coarse to fine
  std::vector<MapRow> map;    ///< method by method, each from the easiest value to the hardest
};

struct ParameterValue {
  std::string name;
  double value = 0;
  std::string unit, says;
};

struct ExerciseResult {
  Number number;
  std::string title, asks;
  bool scene = false;
  std::vector<ParameterValue> parameters;
  std::vector<JudgedClaim> claims;
  std::vector<QuantityResult> quantities;
  std::string failure;  ///< an exception that ended the study; empty: none
  std::optional<CheapestModels> cheapest_models = {};
  std::optional<Stability> stability = {};
  std::vector<Root> roots = {};  ///< of the errata
  std::string verdict = {};      ///< in one sentence, as `Findings` has it
  /// Checksums of the code, tables and ledger that they are made from, of a run whose results are kept.
  std::string made_from = {};
};

struct Results {
  std::vector<ExerciseResult> exercises;  ///< in the book's order
  /// s, what a call of a right-hand side takes through the seam between algorithms and models, at least; NaN
  /// in a run without times.
  double seam = std::numeric_limits<double>::quiet_NaN();
  std::string made_by = {};  ///< the program and the tables, by their fingerprints; empty: not said
};

/// Results as JSON text and back. Numbers that are not finite are written as null and read as NaN. The text
/// has a seal, the checksum of all else in it.
std::string to_json(const Results&);
/// Throws BadInput naming `place` when the text is not results of this version, or contradicts itself: what
/// follows from other values, such as a verdict from its checks and an outcome from its error, is computed
/// again. The seal is not looked at.
Results results_from_json(const std::string& text, const std::string& place);

/// Throws BadInput when the file cannot be read, or has another seal than its content. A seal has no key: it
/// shows damage and edits, and not the forgery of someone who computes it anew.
Results read_results(const std::filesystem::path& file);

}  // namespace oddity
