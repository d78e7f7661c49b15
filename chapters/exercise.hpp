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

/// The vocabulary of oddity: what the book says (exercise, claim, reading, check, verdict) and how a thing is
/// computed (quantity, method, knob, trial, outcome).
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

/// All components finite, and at least one of them.
bool finite(const Value&);
/// The largest absolute component; NaN when one is NaN.
double size_of(const Value&);
/// The largest absolute difference of components; NaN when the two are not comparable (sizes differ, or NaN).
double distance(const Value&, const Value&);

// ---- parameters -------------------------------------------------------------------------------------------

/// A named letter of an exercise. `least` and `most` bound what a user may ask for, both included; a `whole`
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
  /// Throws BadInput for an unknown name or a value that is not finite, outside the declared range, or not
  /// whole where it has to be.
  void set(std::string_view name, double value);

 private:
  std::size_t index(std::string_view name) const;
  std::span<const Parameter> declared_;
  std::vector<double> values_;
};

// ---- the book's side --------------------------------------------------------------------------------------

/// A text with its numbers filled in: "@3" is the next of them to three digits. So no number in a sentence is
/// typed. In a formula a number like 5e-11 becomes $5\cdot10^{-11}$. Throws std::logic_error when there are
/// not as many as places.
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
/// `ulps` roundings of a term of the given size.
Tolerance rounding(double scale, double ulps = 64);

/// One quantity by two independent routes.
struct Check {
  std::string quantity;
  Route left, right;
  Tolerance tolerance = {};
  double scale = 0;        ///< size of the terms compared; 0: the larger of the two sides
  std::string where = {};  ///< the inputs of the sample shown, and of how many it is the worst

  double difference() const { return distance(left.value, right.value); }
  bool holds() const;
};

/// A statement about every sample: how many of them violate it, against none.
Check no_violations(std::string what, long violations, long samples, std::string where = "");

/// Of differences in tolerances: by more than a millionth, as roundings would decide else which of equals is
/// the worst; or beyond the tolerance where the other is within.
bool is_worse(double tolerances, double than);

/// Compares two routes over many samples, and keeps the worst as a check.
class WorstSample {
 public:
  WorstSample(std::string quantity, std::string left, std::string right, double ulps = 64);

  /// One sample: allowed to differ by the class's ulps of `scale`, the size of the terms that were added up.
  void add(const Value& left, const Value& right, double scale, const std::string& where);
  /// One sample with a tolerance of its own.
  void add(const Value& left, const Value& right, const Tolerance& tolerance, double scale,
           const std::string& where);
  Check check() const;

 private:
  Check worst_;
  double ulps_;
  double ratio_ = -1;
  long samples_ = 0;
};

/// One way to read a claim: the formula or number it stands for, and the checks that all must hold.
struct Reading {
  std::string text;
  std::vector<Check> checks;
  bool as_typeset = false;  ///< the text, a formula, has been read and computed, and is what the checks have

  bool holds() const;  ///< false when there is no check
};

/// `wrong` and `incomplete` are the two weights of an erratum: what is printed is false, or it holds in the
/// cases that its author had in view, and leaves out a case or a condition. `lost` is no fault of the book:
/// the copy at hand has lost what was meant.
enum class Verdict { confirmed, misprint, lost, incomplete, wrong, not_checkable, unsettled };

constexpr bool is_erratum(Verdict v) { return v == Verdict::wrong || v == Verdict::incomplete; }

/// What is wrong with a claim that is not right as it stands.
enum class Fault {
  none,
  number,           ///< a figure
  formula,          ///< a letter, sign, factor or index of it
  left_out,         ///< a case that the claim does not mention
  counterexample,   ///< a statement that is not true of everything it speaks of
  term,             ///< the wrong word
  listing,          ///< a program's line
  lost_typography,  ///< what the text at hand has lost on its way: fraction bars, exponents
};

/// One thing that the published solution says.
struct Claim {
  std::string id = {};     ///< "3.5-listing_value"
  int line = 0;            ///< where it is in the solutions text
  std::string place = {};  ///< where a reader of the manual finds it: "equation (7)", "second paragraph"
  std::string says = {};   ///< the claim in our words
  Reading printed = {};
  Reading meant = {};      ///< what it plainly meant, when print or extraction got in the way
  Reading corrected = {};  ///< what is true instead
  Reading in_view = {};  ///< what is printed, in the cases that its author had in view: where it holds there,
                         ///< the claim is incomplete, else wrong
  std::vector<Reading> near_misses =
      {};                          ///< what must not hold: a flipped sign, a dropped term, another digit
  std::string why = {};            ///< unless confirmed: what is wrong, what is right, how it shows
  std::string not_checkable = {};  ///< why nothing at hand can judge it; it has no readings then
  Fault kind = Fault::none;        ///< unless confirmed
  /// Of an erratum: the name of what it comes from, which it may share with others of its exercise; empty: it
  /// stands alone.
  std::string root = {};
};

/// Computed, never assigned: the first reading that holds decides, and of what kind the fault is; a near miss
/// that holds unsettles all. A claim without any reading is not checkable when it says why.
Verdict verdict(const Claim&);

// ---- the method's side ------------------------------------------------------------------------------------

/// How steps of one length meet the frames of a motion.
enum class Stepping {
  divided,       ///< each frame is divided into equal steps, none longer than the setting
  last_step,     ///< steps of the setting; the last one before a frame is drawn
  interpolated,  ///< the same; drawn is what lies between the last two, so that it is a step late
  extrapolated,  ///< the same; drawn is the last one, moved on along its rates
};

/// When a motion is looked at: at `samples` times, evenly spaced, the last at `end`; with a frame rate, at
/// every frame; with frames, at the first `samples` of these. Every method has to be there.
struct Horizon {
  double end;
  int samples = 4;
  double frames_per_second = 0;
  std::shared_ptr<const std::vector<double>> frames = {};  ///< ascending times, after 0
  Stepping stepping = Stepping::divided;

  std::vector<double> times() const;  ///< zero and the times looked at
  int count() const;                  ///< of the times looked at
};

/// The one thing about a method that trades cost for accuracy, with its settings from coarse to fine.
struct Knob {
  std::string name;
  std::vector<double> settings;
};

Knob no_knob();
/// 10^-first, 10^-(first+stride), ..., 10^-last.
Knob tolerances(int first = 2, int last = 12, int stride = 2);
/// first, 2 first, 4 first, ...: `count` settings.
Knob doubling(std::string name, double first, int count);
/// first, first/2, first/4, ...: `count` settings.
Knob halving(std::string name, double first, int count);

/// How a trial ended. Computed from the answer, the reference and the quantity's need.
enum class Outcome {
  ok,
  inaccurate,  ///< the error is above the need
  drifted,     ///< a conserved quantity changed by 1 % of what moves in it, and does not come back
  diverged,    ///< the error is ten times the true value's size, and grows
  non_finite,
  stalled,     ///< out of steps, evaluations or iterations
  deceived,    ///< the method's own error estimate is below its true error
  raised,      ///< the library reported an error
  chattering,  ///< events without end while the time does not move
  grazing,     ///< whether an event happens is below the algorithm's error
};

using Answer = Solved<Value>;

/// A solver's result as a method's answer, its value seen through `see`.
template <class T, class See = std::identity>
Answer answer(const Solved<T>& solved, const See& see = {}) {
  return {Value(see(solved.value)), solved.evaluations, solved.error_estimate, solved.drift, solved.ending,
          solved.message,           solved.comes_back};
}

/// A conserved quantity that has changed by a hundredth of what moves in it makes another motion, unless it
/// comes back.
inline constexpr double another_motion = 0.01;

/// How a method of fixed step treats small disturbances of the motion, measured with the method itself: when
/// two motions that start close together have parted much further than in truth.
struct Disturbances {
  double span = 0;     ///< s, in which they are judged: not the horizon shown where the motion goes on alike
  double watched = 0;  ///< s, twice the span where the motion goes on alike, else the span
  double fastest = 0;  ///< rad/s, of the fastest mode, averaged over the motion
  bool goes_on = false;  ///< the motion goes on alike: the span is not the horizon shown
  /// s, the times at which they have; infinity: not while watched.
  std::function<ode::Loss(double step)> lost;
  /// ln of what theory has a disturbance grow in the span, beyond what it may, added up along the true
  /// motion.
  std::function<double(double step)> added_growth;
  /// s, theory's limit along the motion that the method itself makes at this step until this time.
  std::function<double(double step, double until)> own_theory;
  /// s, the time at which a disturbance of the true motion is lost when the method makes its steps alone.
  std::function<double(double step)> lost_along_truth;
  /// How often the method's own motion turns in a step.
  std::function<double(double step)> turns_in_a_step;
};

/// The number type that a method computes in.
enum class Precision { in_double, in_float };

/// A model solved by an algorithm, in a precision. In float its algorithm is named so, "Runge-Kutta 4 in
/// float": model and algorithm name a method of a quantity.
struct Method {
  std::string model;
  std::string algorithm;
  Knob knob;
  std::function<Answer(double setting)> run;
  Outcome expected = Outcome::ok;  ///< at the finest setting; the suite is red when it ends otherwise
  std::string why = {};            ///< why it is expected to fail
  // Of a method of fixed step only:
  /// The steps at which linear theory calls it unstable, with the model's Jacobian frozen along the motion.
  std::function<std::vector<ode::Tongue>()> unstable_steps = {};
  std::function<Disturbances(const ode::Criteria&)> disturbances = {};
  // Of a model in redundant coordinates only:
  /// m, how far the motion is off its constraint at most, at the times looked at.
  std::function<double(double setting)> off_constraint = {};
  Precision precision = Precision::in_double;
  // Of a method in float only:
  /// What roundings may add to the error that the like method in double has, in the quantity's largest unit.
  std::function<double(double setting)> roundings = {};
  /// Numbers that a body's state has; 0: a closed form keeps none.
  std::size_t state_size = 0;
  /// The motion's places at each time looked at, each time's followed by their rates. The places are the
  /// observables, or what the scene's laws need beside these.
  std::function<Value(double setting)> places_and_rates = {};
};

/// The name in float of an algorithm.
std::string in_float(std::string_view algorithm);

/// An energy, and its kinetic part.
struct Energy {
  double whole, kinetic;
};

struct Quantity;
struct Trial;

/// A number in a breakdown's text: known beforehand, or seen in its two trials.
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

/// Which of a breakdown's two trials.
enum class Side { broken, cured };

Told setting_of(Side);
Told steps_in_one(Side);     ///< in a unit of time: one over the setting
Told power_of_two_of(Side);  ///< the logarithm of the setting to base 2
Told error_of(Side);         ///< the largest, in the quantity's units
Told digits_of(Side);        ///< that are right, counted from the first of the true value's largest component

/// A known failure and its cure: two rows of the table of trials, both asserted.
struct Breakdown {
  std::string says;    ///< with a place for each of `numbers`, as `filled` takes it
  std::string method;  ///< "model, algorithm"
  double setting;
  Outcome outcome;
  std::string cure;  ///< "model, algorithm"
  double cure_setting;
  std::vector<Told> numbers = {};
};

/// Components of a value that make one point, or one angle: its error is their distance from the truth.
struct Norm {
  std::string_view unit;
  std::vector<std::size_t> components;
};

/// What is computed, with its true value and every way to compute it.
struct Quantity {
  std::string name;
  std::string unit;
  std::string says;
  Route reference;  ///< `by` names the source
  double reference_error = 0;
  Tolerance need;                    ///< the error that still counts as ok
  std::vector<Method> methods = {};  ///< in double
  std::vector<Breakdown> breakdowns = {};
  int samples = 1;               ///< times of a motion; the value has the observables of one after the other
  std::vector<Norm> norms = {};  ///< of one time; none: the largest component
  /// The need in each of `units()`; empty: `need` in all of them.
  std::vector<double> needs = {};
  std::vector<double> reference_error_until = {};  ///< at each time, up to there; empty: not known by times
  std::vector<Method> methods_in_float = {};       ///< each has a like one in double: its model and knob
  /// The methods' work is counted in multiplications, divisions and functions, not in evaluations.
  bool in_operations = false;
  // Of a scene's motion whose laws have them:
  /// The energy of one time's places and rates.
  std::function<Energy(std::span<const double> places_and_rates)> energy = {};
  /// m, how far the observables at the k-th time are off what holds them.
  std::function<double(std::span<const double> observed, int k)> off = {};

  /// The distinct units of the norms, in their order; without norms the quantity's.
  std::vector<std::string_view> units() const;
  /// The largest error in each of `units()` over all times; NaN where the value is not comparable.
  std::vector<double> errors(const Value& value) const { return errors(value, reference.value); }
  std::vector<double> errors(const Value& value, const Value& truth) const;
  /// The largest error in needs: up to 1 is enough.
  double in_needs(const std::vector<double>& errors) const;

  Quantity& add(Method method);  ///< to those of its precision
  Quantity& add(Breakdown breakdown);
};

/// A quantity whose truth is a reference value.
Quantity quantity(std::string name, std::string unit, std::string says, const Known& known, Tolerance need);

/// The same quantities, their work counted in operations.
std::vector<Quantity> in_operations(std::vector<Quantity>);

/// A method run at one setting of its knob.
struct Trial {
  std::string model, algorithm, knob;
  double setting = 0;
  Answer answer;
  std::vector<double> errors;  ///< the largest in each of the quantity's units
  double error;                ///< the largest of these
  double final_error;          ///< at the last time alone
  double in_needs;             ///< the error in needs, each unit by its own
  Outcome outcome;
  Precision precision = Precision::in_double;
};

/// Runs and judges; an exception out of the method is the outcome `raised`.
Trial run(const Quantity&, const Method&, double setting);

/// The breakdown's text with its numbers filled in. Throws std::logic_error as `filled` does.
std::string text_of(const Breakdown&, const Quantity&, const Trial& broken, const Trial& cured);

// ---- the exercise -----------------------------------------------------------------------------------------

/// What errata come from, and what one would see of it: in a game, or in a table.
struct Root {
  std::string name;
  std::string shows;  ///< with a number
};

struct Findings {
  std::vector<Claim> claims;
  std::vector<Quantity> quantities;
  std::vector<Root> roots = {};
  /// What of the solution stands and what does not, in one sentence, where something is wrong or incomplete.
  /// {{name of a root|words}} names a finding; {{rest}} counts those that are not named,
  /// of which none is wrong.
  std::string verdict = {};
};

/// The observables of one time: by name ("x" and "y" alone are drawn as a path in the plane), over time in
/// this unit, and which of them make a point or an angle.
struct Axes {
  std::vector<std::string_view> observables;
  std::string_view time = "s";
  std::vector<Norm> norms = {};
};

/// The code of a scene's models: the headers, which stand alone (they include only the standard library,
/// chapters/numbers.hpp and other such headers), and for each model of its methods the expression that
/// constructs it, within namespace oddity, from variables named as the exercise's parameters. A closed form
/// with an algorithm of its own stands as "model, algorithm".
struct Listing {
  std::vector<std::string_view> headers;
  std::vector<std::pair<std::string_view, std::string_view>> models;
  /// The other models, and why they cannot be printed: "which needs ...".
  std::vector<std::pair<std::string_view, std::string_view>> not_printable = {};
  /// Those of them that have events, with their expressions: the page's players search for these.
  std::vector<std::pair<std::string_view, std::string_view>> with_events = {};
  /// Those that take their steps by themselves (`step`), each as "model, algorithm".
  std::vector<std::pair<std::string_view, std::string_view>> with_own_steps = {};
  /// The model of this name in C++, with these parameters, where it is in no header. Its numbers are the
  /// program's but for roundings. Null: all are in headers.
  std::string (*text)(const Parameters&, std::string_view model) = nullptr;
};

/// What is true of a scene's motion as it is seen, whatever model made it.
struct Laws {
  /// The energy of the places and their rates, which follow one another; null: none is judged.
  Energy (*energy)(const Parameters&, std::span<const double> places_and_rates) = nullptr;
  /// m, how far the observables at the time t are off what holds them; null: nothing seen is held.
  double (*off)(const Parameters&, std::span<const double> observed, double t) = nullptr;
};

/// The motion of an exercise that has one: what the views of stability, choice and models look at.
struct Scene {
  Quantity (*motion)(const Parameters&, const Horizon&, const Reference&);
  double horizon;                                      ///< s; where the book's motion is looked at last
  double game_tolerance;                               ///< 1 cm or 1 degree, in the observables' unit
  std::string_view sweep_parameter;                    ///< the one that makes it hard
  std::vector<double> sweep_values;                    ///< from easy to hard
  std::vector<std::string_view> perturbed_parameters;  ///< those that differ from start to start
  Axes axes = {};
  Listing listing = {};
  /// How it looks where these are the observables at the time t (chapters/drawing.hpp).
  void (*draw)(const Parameters&, double t, std::span<const double> observed, Drawing&) = nullptr;
  /// The same for other people's engines (solvers/world.hpp); null where these cannot have it.
  engines::Staging (*staging)(const Parameters&) = nullptr;
  Laws laws = {};
  /// Models that the scene's own page shows to be wrong: these are shown, and never chosen.
  std::vector<std::string_view> faulted = {};
  /// The kind of the motion from these parameters, where starts differ in it: "an ellipse". Null: one kind.
  std::string_view (*kind)(const Parameters&) = nullptr;
  bool is_linear = false;  ///< neighbouring motions part as those of linear equations do: it is no chaos
};

struct Exercise {
  std::string_view title;
  std::string_view asks;  ///< what the book asks, in our words (Markdown with $math$)
  std::span<const Parameter> parameters;
  std::optional<Scene> scene;
  Findings (*study)(const Parameters&, const Reference&);
};

std::string_view name_of(Verdict);
std::string_view name_of(Fault);  ///< empty for none
std::string_view name_of(Outcome);
std::string_view name_of(Precision);  ///< "float", "double"

}  // namespace oddity
