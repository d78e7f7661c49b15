#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/ode/stability.hpp"
#include "solvers/solved.hpp"

/// The vocabulary of oddity: the book's side (exercise, claim, reading, check, verdict) and the computation
/// (quantity, method, resolution, trial, outcome).
namespace oddity {

class Drawing;
namespace engines {
struct Staging;
}
class Reference;
struct Known;

/// One or more numbers: a scalar, a vector, a state, or several of them in a row.
class Value {
 public:
  Value() = default;
  Value(double x) : components_{x} {}
  Value(std::initializer_list<double> xs) : components_(xs) {}
  Value(std::vector<double> xs) : components_(std::move(xs)) {}
  template <class Range>
  requires requires(const Range& r) {
    { *r.begin() } -> std::convertible_to<double>;
    r.end();
  } &&(!std::same_as<Range, Value>)Value(const Range& range) : components_(range.begin(), range.end()) {
  }

  std::size_t size() const { return components_.size(); }
  double operator[](std::size_t i) const { return components_[i]; }
  double& operator[](std::size_t i) { return components_[i]; }
  auto begin() const { return components_.begin(); }
  auto end() const { return components_.end(); }

 private:
  std::vector<double> components_;
};

/// Whether there are components and all of them are finite.
bool finite(const Value&);
/// The largest absolute component; NaN if one is NaN.
double size_of(const Value&);
/// The largest absolute difference of components; NaN if the two are not comparable (sizes differ, or NaN).
double distance(const Value&, const Value&);

// ---- parameters -------------------------------------------------------------------------------------------

/// A named letter of an exercise. Users may set values from `least` to `most`, both included. A `whole`
/// parameter takes whole numbers only.
struct Parameter {
  std::string_view name;
  double value;
  std::string_view unit;
  std::string_view says;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool whole = false;
};
inline constexpr bool whole_number = true;  ///< for `Parameter::whole`

/// The values of an exercise's parameters in one run: its defaults, some of them overridden.
class Parameters {
 public:
  explicit Parameters(std::span<const Parameter> declared);

  double operator[](std::string_view name) const;
  std::span<const Parameter> declared() const { return declared_; }
  /// Throws BadInput for an unknown name, or for a value that is not finite, outside the declared range, or
  /// not whole for a `whole` parameter.
  void set(std::string_view name, double value);

 private:
  std::size_t index(std::string_view name) const;
  std::span<const Parameter> declared_;
  std::vector<double> values_;
};

// ---- the book's side --------------------------------------------------------------------------------------

/// A text with its numbers filled in, so that no number in a sentence is typed. "@3" is the next number to
/// three digits. In a formula a number like 5e-11 becomes $5\cdot10^{-11}$. Throws std::logic_error if the
/// count of numbers differs from the count of places.
std::string filled(std::string_view text, std::span<const double> numbers);
std::string filled(std::string_view text, std::initializer_list<double> numbers);

/// A value, and how it was obtained.
struct Route {
  std::string by;
  Value value;
};

/// The largest difference that a check allows, and the reason why it is no larger.
struct Tolerance {
  double allowed = 0;
  std::string reason;
};

Tolerance exact();
/// Half a unit of the last of `decimals` printed decimals.
Tolerance printed_decimals(int decimals);
/// `ulps` roundings of a term of this size.
Tolerance rounding(double scale, double ulps = 64);

/// One quantity by two independent routes.
struct Check {
  std::string quantity;
  Route left, right;
  Tolerance tolerance = {};
  double scale = 0;        ///< size of the compared terms; 0: the larger of the two sides
  std::string where = {};  ///< inputs of the worst sample, and the number of samples

  double difference() const { return distance(left.value, right.value); }
  bool holds() const;
};

/// Checks that no sample violates a statement.
Check no_violations(std::string what, long violations, long samples, std::string where = "");

/// Whether a difference, in units of its tolerance, is worse than another. It must be larger by more than a
/// millionth, since otherwise roundings would choose among equals, or be beyond the tolerance where the other
/// is within.
bool is_worse(double tolerances, double than);

/// Compares two routes over many samples and keeps the worst as a check.
class WorstSample {
 public:
  WorstSample(std::string quantity, std::string left, std::string right, double ulps = 64);

  /// Adds a sample. Its tolerance is the class's ulps of `scale`, the size of the terms that were added up.
  void add(const Value& left, const Value& right, double scale, const std::string& where);
  /// Adds a sample with its own tolerance.
  void add(const Value& left, const Value& right, const Tolerance& tolerance, double scale,
           const std::string& where);
  Check check() const;

 private:
  Check worst_;
  double ulps_;
  double ratio_ = -1;
  long samples_ = 0;
};

/// One way to read a claim: its formula or number, and the checks that all must pass.
struct Reading {
  std::string text;
  std::vector<Check> checks;
  bool as_typeset = false;  ///< the text is a formula that has been parsed and agrees with the checked values

  bool holds() const;  ///< false if there is no check
};

/// `wrong` and `incomplete` are the two degrees of an erratum. The printed claim is false; or it holds in the
/// cases that its author had in mind, and omits a case or a condition. `lost` is not the book's fault: the
/// copy at hand has lost the meaning.
enum class Verdict { confirmed, misprint, lost, incomplete, wrong, not_checkable, unsettled };

constexpr bool is_erratum(Verdict v) { return v == Verdict::wrong || v == Verdict::incomplete; }

/// The kind of fault of a claim that is not right as printed.
enum class Fault {
  none,
  number,           ///< a figure
  formula,          ///< a letter, sign, factor or index in it
  left_out,         ///< a case that the claim does not mention
  counterexample,   ///< a statement with exceptions
  term,             ///< the wrong word
  listing,          ///< a line of a program
  lost_typography,  ///< lost in the text at hand: fraction bars, exponents
};

/// One claim of the published solution.
struct Claim {
  std::string id = {};     ///< "3.5-listing_value"
  int line = 0;            ///< in the text of the solutions
  std::string place = {};  ///< its place in the manual: "equation (7)", "second paragraph"
  std::string says = {};   ///< the claim in our words
  Reading printed = {};
  Reading meant = {};      ///< the evident meaning, if print or extraction has damaged the text
  Reading corrected = {};  ///< the right version
  Reading in_view = {};    ///< the printed claim in the cases that its author had in mind; if it holds there,
                           ///< the claim is incomplete, otherwise wrong
  std::vector<Reading> near_misses =
      {};                          ///< readings that must fail: a flipped sign, a dropped term, another digit
  std::string why = {};            ///< unless confirmed: the fault, the right version, and how it shows
  std::string not_checkable = {};  ///< why it cannot be judged; it has no readings then
  Fault kind = Fault::none;        ///< unless confirmed
  /// Name of an erratum's root cause, which it may share with others of its exercise; empty: it
  /// shares none.
  std::string root = {};
};

/// Computed, never assigned. The first reading that holds decides, together with the kind of the fault. A
/// near miss that holds makes the verdict unsettled. A claim without readings is not checkable if it gives
/// the reason.
Verdict verdict(const Claim&);

// ---- methods and trials -----------------------------------------------------------------------------------

/// How steps of one length meet the frames of a motion.
enum class Stepping {
  divided,       ///< each frame is divided into equal steps, none longer than the setting
  last_step,     ///< steps of the setting; the state at the last one before a frame is drawn
  interpolated,  ///< as last_step, but interpolated between the last two states, one step late
  extrapolated,  ///< as last_step, but extrapolated from the last state along its rates
};

/// When a motion is looked at: at `samples` times, evenly spaced, the last at `end`; with a frame rate, at
/// every frame; with frames, at the first `samples` of these. Every method has to be there.
struct Horizon {
  double end;
  int samples = 4;
  double frames_per_second = 0;
  std::shared_ptr<const std::vector<double>> frames = {};  ///< ascending times, after 0
  Stepping stepping = Stepping::divided;

  std::vector<double> times() const;  ///< zero and the sample times
  int count() const;                  ///< number of sample times
};

/// The resolution of a method, which trades cost for accuracy: its settings from coarse to fine.
struct Resolution {
  std::string name;
  std::vector<double> settings;
};

Resolution no_resolution();
/// 10^-first, 10^-(first+stride), ..., 10^-last.
Resolution tolerances(int first = 2, int last = 12, int stride = 2);
/// first, 2 first, 4 first, ...: `count` settings.
Resolution doubling(std::string name, double first, int count);
/// first, first/2, first/4, ...: `count` settings.
Resolution halving(std::string name, double first, int count);

/// Outcome of a trial, computed from the answer, the reference and the quantity's tolerance.
enum class Outcome {
  ok,
  inaccurate,  ///< the error is above the tolerance
  drifted,     ///< a conserved quantity changed by 1 % of its moving part, and does not come back
  diverged,    ///< the error is ten times the size of the true value, and grows
  non_finite,
  stalled,     ///< out of steps, evaluations or iterations
  deceived,    ///< the method's own error estimate is below its true error
  raised,      ///< the library reported an error
  chattering,  ///< endless events while the time does not advance
  grazing,     ///< the algorithm's error decides whether an event happens
};

using Answer = Solved<Value>;

/// Converts a solver's result to a method's answer, with `see` applied to its value.
template <class T, class See = std::identity>
Answer answer(const Solved<T>& solved, const See& see = {}) {
  return {Value(see(solved.value)), solved.evaluations, solved.error_estimate, solved.drift, solved.ending,
          solved.message,           solved.comes_back};
}

/// Drift above which a trial shows another motion: a conserved quantity has changed by a hundredth of its
/// moving part and does not come back.
inline constexpr double another_motion = 0.01;

/// How a fixed-step method treats small disturbances of the motion, measured with the method itself. A
/// disturbance is lost when two motions that start close together have separated much further than in truth.
struct Disturbances {
  double span = 0;       ///< s, time span of the judgement; the horizon shown unless goes_on
  double watched = 0;    ///< s, twice the span if goes_on, otherwise the span
  double fastest = 0;    ///< rad/s, of the fastest mode, averaged over the motion
  bool goes_on = false;  ///< the motion continues in the same way after the horizon shown
  /// s, the times at which disturbances are lost; infinity: not while watched.
  std::function<ode::Loss(double step)> lost;
  /// ln of the growth of a disturbance in the span according to theory, beyond the allowed growth, summed
  /// along the true motion.
  std::function<double(double step)> added_growth;
  /// s, the largest stable step in theory, along the method's own motion at this step until this time.
  std::function<double(double step, double until)> own_theory;
  /// s, the time at which a disturbance is lost if the method steps the disturbance alone, along the true
  /// motion.
  std::function<double(double step)> lost_along_truth;
  /// Turns of the method's own motion in one step.
  std::function<double(double step)> turns_in_a_step;
};

/// The number type that a method computes in.
enum class Precision { in_double, in_float };

/// A model solved by an algorithm in a precision. The pair of model and algorithm is unique in a quantity: in
/// float the algorithm is named "Runge-Kutta 4 in float".
struct Method {
  std::string model;
  std::string algorithm;
  Resolution resolution;
  std::function<Answer(double setting)> run;
  /// At the finest setting; the suite fails on any other outcome. Holds at all parameters in range, unless
  /// it is for the exercise's own.
  Outcome expected = Outcome::ok;
  std::string why = {};  ///< why it is expected to fail
  // For fixed-step methods only:
  /// The steps at which linear theory predicts instability, with the model's Jacobian frozen along the
  /// motion.
  std::function<std::vector<ode::Tongue>()> unstable_steps = {};
  std::function<Disturbances(const ode::Criteria&)> disturbances = {};
  // For models in redundant coordinates only:
  /// m, the largest violation of the constraint at the sample times.
  std::function<double(double setting)> off_constraint = {};
  Precision precision = Precision::in_double;
  // For methods in float only:
  /// Bound on the error that roundings add to that of the same method in double, in the quantity's largest
  /// unit.
  std::function<double(double setting)> roundings = {};
  /// Count of numbers in a body's state; 0 for a closed form, which keeps none.
  std::size_t state_size = 0;
  /// The motion's places at each sample time, each followed by their rates. The places are the observables,
  /// or other coordinates if the scene's laws need them.
  std::function<Value(double setting)> places_and_rates = {};
  /// Whether the expected outcome is for the exercise's own parameters alone: at others roundings or chance
  /// decide.
  bool for_own_parameters = false;
};

/// Name of an algorithm in float.
std::string in_float(std::string_view algorithm);

/// An energy, with its kinetic part.
struct Energy {
  double whole, kinetic;
};

struct Quantity;
struct Trial;

/// A number in a breakdown's text: known beforehand, or measured in its two trials.
class Told {
 public:
  using Seen = std::function<double(const Quantity&, const Trial& broken, const Trial& cured)>;

  Told(double known) : known_(known) {}
  template <class F>
  requires std::invocable<const F&, const Quantity&, const Trial&, const Trial&> Told(F seen)
      : seen_(std::move(seen)) {}

  double number(const Quantity& quantity, const Trial& broken, const Trial& cured) const {
    return seen_ ? seen_(quantity, broken, cured) : known_;
  }

 private:
  double known_ = 0;
  Seen seen_ = {};
};

/// One of a breakdown's two trials.
enum class Side { broken, cured };

Told setting_of(Side);
Told steps_in_one(Side);     ///< per unit of time: one over the setting
Told power_of_two_of(Side);  ///< base-2 logarithm of the setting
Told error_of(Side);         ///< the largest, in the quantity's units
Told digits_of(Side);        ///< right digits, from the first digit of the true value's largest component

/// A known failure and its cure: two rows of the table of trials, both asserted.
struct Breakdown {
  std::string says;    ///< with a place for each of `numbers`, as in `filled`
  std::string method;  ///< "model, algorithm"
  double setting;
  Outcome outcome;
  std::string cure;  ///< "model, algorithm"
  double cure_setting;
  std::vector<Told> numbers = {};
};

/// Components of a value that form one point, or one angle: its error is their distance from the truth.
struct Norm {
  std::string_view unit;
  std::vector<std::size_t> components;
};

/// A quantity to compute, with its true value and all methods for it.
struct Quantity {
  std::string name;
  std::string unit;
  std::string says;
  Route reference;  ///< `by` names the source
  double reference_error = 0;
  Tolerance need;                    ///< the largest error that is still ok
  std::vector<Method> methods = {};  ///< in double
  std::vector<Breakdown> breakdowns = {};
  int samples = 1;               ///< times of a motion; the value lists the observables time by time
  std::vector<Norm> norms = {};  ///< for one time; none: the largest component
  /// The tolerance in each of `units()`; empty: `need` in all of them.
  std::vector<double> needs = {};
  std::vector<double> reference_error_until = {};  ///< maximum up to each time; empty: not known per time
  std::vector<Method> methods_in_float = {};       ///< each has a counterpart in double
  /// Work is counted in multiplications, divisions and functions instead of evaluations.
  bool in_operations = false;
  /// Whether the expected outcomes are for the exercise's own parameters alone, as those of a motion, whose
  /// steps and tolerances suit these.
  bool for_own_parameters = false;
  // For a scene's motion whose laws define them:
  /// The energy from one time's places and rates.
  std::function<Energy(std::span<const double> places_and_rates)> energy = {};
  /// m, the violation of the constraints by the observables at the k-th time.
  std::function<double(std::span<const double> observed, int k)> off = {};

  /// The distinct units of the norms, in their order; without norms the quantity's unit.
  std::vector<std::string_view> units() const;
  /// The largest error in each of `units()` over all times; NaN if the value is not comparable.
  std::vector<double> errors(const Value& value) const { return errors(value, reference.value); }
  std::vector<double> errors(const Value& value, const Value& truth) const;
  /// The largest error in units of its tolerance; at most 1 passes.
  double in_needs(const std::vector<double>& errors) const;

  Quantity& add(Method method);  ///< to the list for its precision
  Quantity& add(Breakdown breakdown);
};

/// A quantity whose true value is a reference value.
Quantity quantity(std::string name, std::string unit, std::string says, const Known& known, Tolerance need);

/// The quantities, with their work counted in operations.
std::vector<Quantity> in_operations(std::vector<Quantity>);

/// A run of a method at one setting.
struct Trial {
  std::string model, algorithm, resolution;
  double setting = 0;
  Answer answer;
  std::vector<double> errors;  ///< the largest in each of the quantity's units
  double error;                ///< the largest of these
  double final_error;          ///< at the last time alone
  double in_needs;             ///< the largest error, in units of the tolerances
  Outcome outcome;
  Precision precision = Precision::in_double;
};

/// Runs and judges. An exception from the method gives the outcome `raised`.
Trial run(const Quantity&, const Method&, double setting);

/// The breakdown's text with its numbers filled in. Throws std::logic_error as `filled` does.
std::string text_of(const Breakdown&, const Quantity&, const Trial& broken, const Trial& cured);

// ---- the exercise -----------------------------------------------------------------------------------------

/// A root cause of errata, and its visible effect in a game or a table.
struct Root {
  std::string name;
  std::string shows;  ///< with a number
};

struct Findings {
  std::vector<Claim> claims;
  std::vector<Quantity> quantities;
  std::vector<Root> roots = {};
  /// One sentence on which parts of the solution are right and which are not, if something is wrong or
  /// incomplete. {{name of a root|words}} names a finding. {{rest}} counts the unnamed findings, none of
  /// which is wrong.
  std::string verdict = {};
};

/// Names of the observables of one time, the unit of time, and the observables that form a point or an angle.
/// "x" and "y" alone are drawn as a path in the plane.
struct Axes {
  std::vector<std::string_view> observables;
  std::string_view time = "s";
  std::vector<Norm> norms = {};
};

/// The code of a scene's models. The headers are self-contained: they include only the standard library,
/// chapters/numbers.hpp and other such headers. For each model of its methods there is an expression that
/// constructs it, within namespace oddity, from variables named as the exercise's parameters. A closed form
/// with its own algorithm is listed as "model, algorithm".
struct Listing {
  std::vector<std::string_view> headers;
  std::vector<std::pair<std::string_view, std::string_view>> models;
  /// The other models, and why they cannot be printed: "which needs ...".
  std::vector<std::pair<std::string_view, std::string_view>> not_printable = {};
  /// Those of the other models that have events, with their expressions. The page's players can find events.
  std::vector<std::pair<std::string_view, std::string_view>> with_events = {};
  /// Models that make their own steps (`step`), each as "model, algorithm".
  std::vector<std::pair<std::string_view, std::string_view>> with_own_steps = {};
  /// C++ text of the model of this name with these parameters, for models that are in no header. Its numbers
  /// equal the program's except for roundings. Null: all are in headers.
  std::string (*text)(const Parameters&, std::string_view model) = nullptr;
};

/// Laws of a scene's observed motion, for any model.
struct Laws {
  /// The energy, from the places followed by their rates; null: no energy is judged.
  Energy (*energy)(const Parameters&, std::span<const double> places_and_rates) = nullptr;
  /// m, the violation of the constraints by the observables at time t; null: no constraints.
  double (*off)(const Parameters&, std::span<const double> observed, double t) = nullptr;
};

/// The motion of an exercise, for the views of stability, choice and models.
struct Scene {
  Quantity (*motion)(const Parameters&, const Horizon&, const Reference&);
  double horizon;                                      ///< s; the last sample time of the book's motion
  double game_tolerance;                               ///< 1 cm or 1 degree, in the observables' unit
  std::string_view sweep_parameter;                    ///< the parameter that makes the scene hard
  std::vector<double> sweep_values;                    ///< from easy to hard
  std::vector<std::string_view> perturbed_parameters;  ///< parameters that differ between initial conditions
  Axes axes = {};
  Listing listing = {};
  /// Draws the scene with these observables at time t (chapters/drawing.hpp).
  void (*draw)(const Parameters&, double t, std::span<const double> observed, Drawing&) = nullptr;
  /// Builds the scene for third-party engines (solvers/world.hpp); null if they cannot represent it.
  engines::Staging (*staging)(const Parameters&) = nullptr;
  Laws laws = {};
  /// Models that the scene's own page shows to be wrong. They are shown and never chosen.
  std::vector<std::string_view> faulted = {};
  /// The kind of motion from these parameters, if it depends on them: "an ellipse". Null: there is one kind.
  std::string_view (*kind)(const Parameters&) = nullptr;
  bool is_linear = false;  ///< neighbouring motions separate as in linear equations, so there is no chaos
};

/// Where the expected outcomes hold. A test tries the ends of the ranges for those that hold in them.
enum class Expected { at_own_parameters, in_whole_ranges };

struct Provable;
using Provables = std::vector<Provable>;

struct Exercise {
  std::string_view title;
  std::string_view asks;  ///< the book's question, in our words (Markdown with $math$)
  std::span<const Parameter> parameters;
  std::optional<Scene> scene;
  Findings (*study)(const Parameters&, const Reference&);
  Provables (*proofs)() = nullptr;  ///< proofs of its claims (provable.hpp); null: none
  Expected expected = Expected::at_own_parameters;
};

std::string_view name_of(Verdict);
std::string_view name_of(Fault);  ///< empty for none
std::string_view name_of(Outcome);
std::string_view name_of(Precision);  ///< "float", "double"

}  // namespace oddity
