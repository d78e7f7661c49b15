#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "chapters/contents.hpp"
#include "report/study/need.hpp"

/// Results of a run as plain values: everything that a view, a judge or a file needs, and no code to run.
namespace oddity {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct JudgedClaim {
  Claim claim;
  Verdict verdict = Verdict::unsettled;
};

/// Calls `f` with each reading of a claim and its name; near misses are numbered.
template <class C, class F>
void for_each_reading(C& claim, const F& f) {
  f("printed", claim.printed);
  f("meant", claim.meant);
  f("corrected", claim.corrected);
  f("in view", claim.in_view);
  for (std::size_t i = 0; i < claim.near_misses.size(); ++i)
    f("near miss " + std::to_string(i + 1), claim.near_misses[i]);
}

/// Time of an operation: the median of several batches, and half their interquartile range.
struct Time {
  double seconds = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not timed
  double spread = std::numeric_limits<double>::quiet_NaN();
};

struct TimedTrial {
  std::string model, algorithm, resolution;
  double setting = 0;
  Value value;
  double error = 0;           ///< the largest over all components and times
  double final_error = 0;     ///< at the last time only
  double error_estimate = 0;  ///< NaN: the method gives none
  double drift = 0;
  long evaluations = 0;
  Outcome outcome = Outcome::raised;
  std::string message;
  Time time = {};
  Precision precision = Precision::in_double;
  double roundings = 0;     ///< in float: bound on the error added to that of the trial in double
  bool comes_back = false;  ///< the drift oscillates
};

/// A method's trials from coarse to fine, and the expected outcome of the finest. If that is not `asserted`,
/// the parameters are not those that the method was chosen for, and it may end otherwise.
struct MethodResult {
  std::string model, algorithm;
  Outcome expected = Outcome::ok;
  std::string why;
  std::vector<TimedTrial> trials;
  bool asserted = true;

  bool as_expected() const { return !trials.empty() && trials.back().outcome == expected; }
  /// Whether it is seen to fail in the way for which `why` is the reason.
  bool fails_as_expected() const { return !why.empty() && expected != Outcome::ok && as_expected(); }
};

/// A method in float, with trials at the settings of the same method in double.
struct FloatResult {
  std::string model, algorithm;
  std::size_t in_double = 0;  ///< index of that one among the quantity's methods
  std::vector<TimedTrial> trials;
};

/// Whether a trial in float errs by at most twice the error of the same trial in double plus the possible
/// roundings. True for a motion that double cannot follow.
bool as_accurate_as_roundings_allow(const TimedTrial& in_float, const TimedTrial& in_double);

/// The results of a breakdown's two rows.
struct BreakdownResult {
  std::string says;
  Outcome expected = Outcome::ok;
  TimedTrial broken, cured;

  bool as_expected() const { return broken.outcome == expected && cured.outcome == Outcome::ok; }
};

/// One model's motion, for drawing.
struct Path {
  std::string model, algorithm, resolution;
  double setting = 0;
  double error = 0;  ///< at the times where the reference is known
  Outcome outcome = Outcome::raised;
  Value value;  ///< the observables, time after time; incomplete if the motion broke off
};

/// A scene's motion by each of its models.
struct Trajectory {
  std::vector<std::string> observables;  ///< their names, if they have any
  std::string time_unit;
  std::vector<double> judged_at;  ///< the times of the quantity's reference
  std::vector<double> times;      ///< times of the paths
  std::vector<Path> paths;
  std::size_t truest = 0;  ///< the path nearest to the reference
  double close = 0;        ///< a game's tolerance, in the observables' unit
};

struct QuantityResult {
  std::string name, unit, says;
  Route reference;
  double reference_error = 0;
  Tolerance need;
  std::vector<MethodResult> methods;
  std::vector<BreakdownResult> breakdowns;
  std::optional<Trajectory> trajectory = {};  ///< for a scene's motion
  int samples = 1;                            ///< number of times at which a motion is judged
  std::vector<FloatResult> in_float = {};
  /// Components of a motion, at one time, that form a point or an angle; empty: judged by the largest
  /// component.
  std::vector<std::vector<std::size_t>> norms = {};
  bool in_operations = false;  ///< work is counted in multiplications, divisions and functions
};

/// "judged at these 4 times alone" for a motion; otherwise empty.
std::string instants(const QuantityResult&);

/// A method at one setting, over several starts.
struct Candidate {
  std::string model, algorithm, resolution;
  double setting = 0;
  double error = 0;                     ///< the largest over the starts that it was chosen on, in needs
  std::vector<double> errors = {};      ///< largest in each of the motion's units
  std::map<Criterion, double> by = {};  ///< largest by each requested criterion except path, in its unit
  Outcome outcome = Outcome::ok;
  std::string where = {};  ///< the start with this outcome, unless ok
  std::string why = {};    ///< a reason beyond the error, such as that its swing grows
  double evaluations_per_frame = 0;
  double seconds_per_frame = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not timed
  double spread = 0;                                                    ///< spread of the seconds
  double unseen_error = std::numeric_limits<double>::quiet_NaN();  ///< over the starts it was not chosen on
  double unbounded_error = 0;  ///< without the bound by the motion's size, as far as it can be estimated
  Precision precision = Precision::in_double;
  std::size_t state_size = 0;  ///< numbers in the state; 0 for a closed form

  bool holds() const { return outcome == Outcome::ok; }
};

/// The first model of the ladder, from the simplest on, that any algorithm passes with, at the least work.
struct CheapestModel {
  std::string says;  ///< "1 degree", "10 digits"
  Need need;
  std::optional<Candidate> least;          ///< empty: nothing here passes
  std::optional<Candidate> in_float = {};  ///< `least` in float; empty: it exists only in double
};

/// Values of a parameter between which a model is enough.
struct Interval {
  double from, to;
};

/// Where a model, solved exactly, is enough for a game, along one parameter.
struct BreakEven {
  std::string model, parameter, parameter_unit;
  Interval looked;               ///< the values searched
  std::vector<Interval> enough;  ///< ascending, disjoint; each end on the passing side, to one in a thousand
  /// The model's error in needs at the inner ends, on the passing and on the failing side, by the reference;
  /// NaN if unknown.
  std::vector<double> holding = {}, failing = {};
  bool coarse = false;  ///< an end is less exact than that, as no motion is known near it
  /// Why the model has no motion beyond an end, where it fails at once and not by degrees.
  std::string why = {};
};

struct CheapestModels {
  std::vector<std::string> units;    ///< each once, those of a candidate's errors
  std::vector<CheapestModel> least;  ///< over 10 s at 60 frames per second: for a game, and for 10 digits
  std::vector<BreakEven> break_evens;
  std::vector<std::string> never;  ///< models that are not enough for a game at any value searched
  CheapestModel recipe = {};       ///< for a game: by `choose`, each evaluation at the same cost
};

/// Bounds of a limit.
struct Between {
  double least, most;
};

/// The steps up to which a method of fixed step is stable, its error there, how it breaks beyond, and a cure.
struct Limit {
  std::string model, algorithm;
  std::vector<ode::Tongue> tongues;  ///< unstable steps by linear theory
  double stable = 0;                 ///< measured: all steps tried up to here are stable; 0: none is
  double unstable = 0;               ///< measured: the shortest unstable step; 0: none up to `longest`
  double longest = 0;                ///< the longest step that the measurement may try
  double lost = 0;                   ///< the time at which the motion is lost at that step
  bool outgrown = false;  ///< lost by growing to twice the true size; otherwise neighbours have separated
  double watched = 0;     ///< how long neighbouring motions are watched
  bool goes_on = false;   ///< the motion continues in the same way: `watched` is not the horizon shown
  /// Range of a limit that is not sharp. Covers observers who watch half or twice as long, or for whom a
  /// motion is too large at 1.5 or 4 times the true size instead of twice. They differ by over 5 %.
  std::optional<Between> soft;
  std::optional<TimedTrial> at;      ///< the motion by the longest stable step that divides its interval
  std::optional<TimedTrial> broken;  ///< the motion by the next longer, unstable step
  std::optional<TimedTrial> within;  ///< the motion by the largest step below which all meet the scene's need
  std::optional<TimedTrial> cure;    ///< a method that meets the need at the step of `broken`
  std::string why;                   ///< why theory and measurement differ by more than a quarter
  std::string evidence;              ///< the numbers computed for that

  /// The start of linear theory's first tongue; 0: every step is unstable; infinity: none is.
  double theory() const;
  /// The largest stable step; 0: none; infinity: every step, if theory proves it.
  double step() const;
};

/// Outcomes of a method at one value of a scene's parameter, step by step.
struct MapRow {
  std::string model, algorithm;
  double value = 0;
  double theory = 0;  ///< infinity: every step is stable
  std::vector<Outcome> outcomes;
  std::vector<bool> fragile;  ///< whether a start that is a few roundings off changes the outcome
};

/// Where the methods of a scene break, over the step and the parameter that makes the scene hard.
struct Stability {
  std::string quantity, unit;
  std::string time_unit;  ///< unit of the horizon and of every step and limit
  double horizon = 0;
  double close = 0;  ///< the need, in the unit
  std::vector<Limit> limits;
  std::string parameter, parameter_unit;
  std::vector<double> steps;  ///< steps of the map, from coarse to fine
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
  std::vector<Root> roots = {};  ///< roots of the errata
  std::string verdict = {};      ///< one sentence, as in `Findings`
  /// Checksums of the code, tables and ledger that kept results were made from.
  std::string made_from = {};
};

struct Results {
  std::vector<ExerciseResult> exercises;  ///< in the book's order
  /// s, a lower bound for a call of a right-hand side through the type-erased interface between algorithms
  /// and models; NaN in a run without times.
  double seam = std::numeric_limits<double>::quiet_NaN();
  std::string made_by = {};  ///< fingerprints of the program and the tables; empty: unknown
};

/// Results as JSON text. Numbers that are not finite are written as null and read as NaN. The text has a
/// seal, a checksum of the rest.
std::string to_json(const Results&);
/// Throws BadInput naming `place` when the text is not results of this version, or contradicts itself. Values
/// that follow from others, such as a verdict from its checks and an outcome from its error, are computed
/// again. Does not check the seal.
Results results_from_json(const std::string& text, const std::string& place);

/// Throws BadInput when the file cannot be read, or has another seal than its content. A seal has no key: it
/// detects damage and edits, but not a forger who recomputes it.
Results read_results(const std::filesystem::path& file);

}  // namespace oddity
