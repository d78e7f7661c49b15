#include "chapters/exercise.hpp"

#include <exception>
#include <new>

#include "chapters/contents.hpp"
#include "chapters/judge.hpp"
#include "chapters/no_event.hpp"
#include "chapters/places_kept.hpp"
#include "reference/bad_input.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::string names_of(std::span<const Parameter> parameters) {
  std::string names;
  for (const Parameter& p : parameters) names += (names.empty() ? "" : ", ") + std::string(p.name);
  return names.empty() ? "none" : names;
}

/// "exercise 3.5 (its file): ", from the exercise that declares these parameters; empty if none does.
std::string owner_of(std::span<const Parameter> parameters) {
  for (const Entry& entry : registry())
    if (!parameters.empty() && entry.exercise.parameters.data() == parameters.data())
      return "exercise " + to_string(entry.number) + " (" + std::string(entry.file) + "): ";
  return "";
}

}  // namespace

// ---- parameters -------------------------------------------------------------------------------------------

Parameters::Parameters(std::span<const Parameter> declared) : declared_(declared) {
  for (const Parameter& p : declared) values_.push_back(p.value);
}

std::size_t Parameters::index(std::string_view name) const {
  const auto found = std::ranges::find(declared_, name, &Parameter::name);
  if (found == declared_.end())
    throw BadInput(owner_of(declared_) + "no parameter '" + std::string(name) +
                   "'; the parameters are: " + names_of(declared_));
  return static_cast<std::size_t>(found - declared_.begin());
}

double Parameters::operator[](std::string_view name) const { return values_[index(name)]; }

void Parameters::set(std::string_view name, double value) {
  const std::size_t i = index(name);
  const Parameter& p = declared_[i];
  if (!(std::isfinite(value) && p.least <= value && value <= p.most))
    throw BadInput("parameter " + std::string(name) + " = " + format_shortest(value) +
                   " is out of its range: " + format_shortest(p.least) + " to " + format_shortest(p.most) +
                   (p.unit.empty() || p.unit == "1" ? "" : " " + std::string(p.unit)));
  if (p.whole && value != std::round(value))
    throw BadInput("parameter " + std::string(name) + " = " + format_shortest(value) +
                   " is not a whole number");
  values_[i] = value;
}

// ---- methods ----------------------------------------------------------------------------------------------

Resolution no_resolution() { return {"", {0}}; }

Resolution tolerances(int first, int last, int stride) {
  Resolution resolution{"tolerance", {}};
  for (int digits = first; digits <= last; digits += stride)
    resolution.settings.push_back(*parse_number("1e-" + std::to_string(digits)));
  return resolution;
}

Resolution doubling(std::string name, double first, int count) {
  Resolution resolution{std::move(name), {}};
  for (int i = 0; i < count; ++i) resolution.settings.push_back(std::ldexp(first, i));
  return resolution;
}

Resolution halving(std::string name, double first, int count) {
  Resolution resolution{std::move(name), {}};
  for (int i = 0; i < count; ++i) resolution.settings.push_back(std::ldexp(first, -i));
  return resolution;
}

namespace {

/// "4/3" if the number is this fraction to within roundings, with a small denominator, and its digits would
/// not show it; otherwise empty.
std::string simple_fraction(double x, int digits, bool in_formula) {
  constexpr double largest = 20;
  const double size = std::abs(x);
  const auto is = [size](double y) { return std::abs(size - y) <= 16 * epsilon * size; };
  if (is(*parse_number(format_significant(size, digits)))) return "";
  for (int denominator = 2; denominator <= 12; ++denominator) {
    const double numerator = std::round(size * denominator);
    if (numerator < 1 || numerator > largest || !is(numerator / denominator)) continue;
    const std::string above = format_significant(numerator, 2), below = std::to_string(denominator);
    return (x < 0 ? "-" : "") + (in_formula ? R"(\frac{)" + above + "}{" + below + "}" : above + "/" + below);
  }
  return "";
}

/// The number as text. In a formula, with its exponent as a power of ten.
std::string number_in_text(double x, int digits, bool in_formula) {
  if (const std::string fraction = simple_fraction(x, digits, in_formula); !fraction.empty()) return fraction;
  const std::string written = format_significant(x, digits);
  const auto e = written.find('e');
  if (!in_formula || e == std::string::npos) return written;
  const std::string mantissa = written.substr(0, e);
  const std::string power = "10^{" + std::to_string(std::stoi(written.substr(e + 1))) + "}";
  if (mantissa == "1" || mantissa == "-1") return mantissa.substr(0, mantissa.size() - 1) + power;
  return mantissa + "\\cdot" + power;
}

thread_local bool places_kept = false;

}  // namespace

PlacesKept::PlacesKept() { places_kept = true; }
PlacesKept::~PlacesKept() { places_kept = false; }

std::string filled(std::string_view text, std::span<const double> numbers) {
  if (places_kept) return std::string(text);
  std::string all;
  auto next = numbers.begin();
  bool in_formula = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '@') {
      in_formula = in_formula != (text[i] == '$');
      all += text[i];
      continue;
    }
    const char digits = ++i < text.size() ? text[i] : ' ';
    if (digits < '1' || digits > '9' || next == numbers.end())
      throw std::logic_error("'" + std::string(text) + "' has a place without digits or without a number");
    all += number_in_text(*next++, digits - '0', in_formula);
  }
  if (next != numbers.end()) throw std::logic_error("'" + std::string(text) + "' has no place for a number");
  return all;
}

std::string filled(std::string_view text, std::initializer_list<double> numbers) {
  return filled(text, std::span(numbers.begin(), numbers.size()));
}

Quantity& Quantity::add(Method method) {
  (method.precision == Precision::in_float ? methods_in_float : methods).push_back(std::move(method));
  return *this;
}

Quantity& Quantity::add(Breakdown breakdown) {
  breakdowns.push_back(std::move(breakdown));
  return *this;
}

namespace {

const Trial& of(Side side, const Trial& broken, const Trial& cured) {
  return side == Side::broken ? broken : cured;
}

template <class F>
Told seen_in(Side side, const F& f) {
  return Told::Seen([=](const Quantity& quantity, const Trial& broken, const Trial& cured) {
    return static_cast<double>(f(of(side, broken, cured), quantity));
  });
}

}  // namespace

Told setting_of(Side side) {
  return seen_in(side, [](const Trial& t, const Quantity&) { return t.setting; });
}

Told steps_in_one(Side side) {
  return seen_in(side, [](const Trial& t, const Quantity&) { return 1 / t.setting; });
}

Told power_of_two_of(Side side) {
  return seen_in(side, [](const Trial& t, const Quantity&) { return std::log2(t.setting); });
}

Told error_of(Side side) {
  return seen_in(side, [](const Trial& t, const Quantity&) { return t.error; });
}

Told digits_of(Side side) {
  return seen_in(side, [](const Trial& t, const Quantity& q) {
    return std::max(0.0, std::floor(-std::log10(t.error / size_of(q.reference.value))));
  });
}

std::string text_of(const Breakdown& breakdown, const Quantity& quantity, const Trial& broken,
                    const Trial& cured) {
  std::vector<double> numbers;
  for (const Told& told : breakdown.numbers) numbers.push_back(told.number(quantity, broken, cured));
  return filled(breakdown.says, numbers);
}

Quantity quantity(std::string name, std::string unit, std::string says, const Known& known, Tolerance need) {
  Quantity made{std::move(name), std::move(unit), std::move(says), {known.source, known.value},
                known.error,     std::move(need)};
  made.reference_error_until = known.error_until;
  return made;
}

std::vector<Quantity> in_operations(std::vector<Quantity> quantities) {
  for (Quantity& q : quantities) q.in_operations = true;
  return quantities;
}

namespace {

/// A result is off the scale if its error is ten times the size of the true value.
constexpr double far_away = 10;

/// Whether the error of a motion grows: its maximum over the later half of the sample times exceeds that over
/// the earlier half. True for a single time.
bool grows(const Quantity& quantity, const Value& value) {
  const auto looks = static_cast<std::size_t>(quantity.samples);
  const Value& truth = quantity.reference.value;
  if (looks < 2 || value.size() != truth.size() || value.size() % looks != 0) return true;
  const std::size_t parts = value.size() / looks, later = looks / 2 * parts;
  double before = 0, after = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    double& most = i < later ? before : after;
    most = std::max(most, std::abs(value[i] - truth[i]));
  }
  return after > before;
}

bool is_another_motion(const Answer& answer) {
  return !(answer.drift <= another_motion) && !answer.comes_back;
}

}  // namespace

Value last_of(const Value& value, int samples) {
  const std::size_t part = value.size() / static_cast<std::size_t>(samples);
  return Value(std::vector<double>(value.end() - static_cast<std::ptrdiff_t>(part), value.end()));
}

double largest(const std::vector<double>& errors) {
  double largest = 0;
  for (double e : errors) {
    if (std::isnan(e)) return e;
    largest = std::max(largest, e);
  }
  return largest;
}

/// Without a reference no answer is accurate, and the only fault of a finite answer that can be detected is
/// its drift.
Outcome judge(const Quantity& quantity, const Answer& answer, double error, double in_needs) {
  switch (answer.ending) {
    case Ending::raised:
      return Outcome::raised;
    case Ending::stalled:
      return Outcome::stalled;
    case Ending::non_finite:
      return Outcome::non_finite;
    case Ending::chattering:
      return Outcome::chattering;
    case Ending::grazing:
      return Outcome::grazing;
    case Ending::reached:
      break;
  }
  if (!finite(answer.value)) return Outcome::non_finite;
  if (!finite(quantity.reference.value))
    return is_another_motion(answer) ? Outcome::drifted : Outcome::inaccurate;
  if (!std::isfinite(error)) return Outcome::non_finite;
  const bool accurate = in_needs <= 1;
  if (accurate && std::isnan(answer.error_estimate))
    return is_another_motion(answer) ? Outcome::drifted : Outcome::ok;
  const double scale =
      largest(quantity.errors(Value(std::vector<double>(quantity.reference.value.size(), 0.0))));
  const double known_to = quantity.reference_error + 16 * epsilon * scale;
  if (!accurate && error > far_away * scale && scale > 0 && grows(quantity, answer.value))
    return Outcome::diverged;
  if (answer.error_estimate < error - known_to) return Outcome::deceived;
  if (is_another_motion(answer)) return Outcome::drifted;
  return accurate ? Outcome::ok : Outcome::inaccurate;
}

int Horizon::count() const {
  return frames_per_second > 0 ? static_cast<int>(std::lround(end * frames_per_second)) : samples;
}

std::vector<double> Horizon::times() const {
  std::vector<double> all{0};
  all.reserve(1 + static_cast<std::size_t>(count()));
  for (int k = 1, last = count(); k <= last; ++k)
    all.push_back(frames                  ? (*frames)[static_cast<std::size_t>(k) - 1]
                  : frames_per_second > 0 ? k / frames_per_second
                                          : end * k / samples);
  return all;
}

std::vector<std::string_view> Quantity::units() const {
  std::vector<std::string_view> all;
  for (const Norm& norm : norms)
    if (std::ranges::find(all, norm.unit) == all.end()) all.push_back(norm.unit);
  if (all.empty()) all.push_back(unit);
  return all;
}

namespace {

/// The distance of two points in some of their components.
template <class Point>
double distance_in(const std::vector<std::size_t>& components, const Point& x, const Point& y) {
  const auto apart = [&](std::size_t i) {
    return x[static_cast<std::ptrdiff_t>(i)] - y[static_cast<std::ptrdiff_t>(i)];
  };
  if (components.size() == 1) return std::abs(apart(components[0]));
  double square = 0;
  for (const std::size_t i : components) square += apart(i) * apart(i);
  if (square > 1e-200 && square < 1e300) return std::sqrt(square);
  double far = 0;  // squares may over- or underflow
  for (const std::size_t i : components) far = std::hypot(far, apart(i));
  return far;
}

}  // namespace

std::vector<double> Quantity::errors(const Value& value, const Value& truth) const {
  if (norms.empty()) return {distance(value, truth)};
  const auto all = units();
  const std::size_t parts = truth.size() / static_cast<std::size_t>(samples);
  if (value.size() != truth.size() || parts == 0 || !finite(value) || !finite(truth))
    return std::vector<double>(all.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<double> errors(all.size(), 0);
  const auto step = static_cast<std::ptrdiff_t>(parts);
  for (const Norm& norm : norms) {
    double& error = errors[static_cast<std::size_t>(std::ranges::find(all, norm.unit) - all.begin())];
    auto at = value.begin(), true_at = truth.begin();
    for (; true_at < truth.end(); at += step, true_at += step)
      error = std::max(error, distance_in(norm.components, at, true_at));
  }
  return errors;
}

double Quantity::in_needs(const std::vector<double>& errors) const {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double allowed = i < needs.size() ? needs[i] : need.allowed;
    ratios.push_back(errors[i] == 0 ? 0 : errors[i] / allowed);
  }
  return largest(ratios);
}

std::string in_float(std::string_view algorithm) { return std::string(algorithm) + " in float"; }

Trial run(const Quantity& quantity, const Method& method, double setting) {
  Trial trial{method.model,    method.algorithm, method.resolution.name, setting, {}, {}, 0, 0, 0,
              Outcome::raised, method.precision};
  try {
    trial.answer = method.run(setting);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& exception) {
    trial.answer.ending = Ending::raised;
    trial.answer.message = exception.what();
  }
  trial.errors = quantity.errors(trial.answer.value);
  trial.error = largest(trial.errors);
  trial.final_error = distance(last_of(trial.answer.value, quantity.samples),
                               last_of(quantity.reference.value, quantity.samples));
  trial.in_needs = quantity.in_needs(trial.errors);
  trial.outcome = judge(quantity, trial.answer, trial.error, trial.in_needs);
  std::string& message = trial.answer.message;
  if (message == no_event && trial.outcome != Outcome::diverged) message.clear();
  if (message.empty() && trial.answer.reached() && !finite(quantity.reference.value))
    message = "nothing is known to judge it by";
  return trial;
}

std::string_view name_of(Precision precision) {
  return precision == Precision::in_float ? "float" : "double";
}

std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::ok:
      return "ok";
    case Outcome::inaccurate:
      return "inaccurate";
    case Outcome::drifted:
      return "drifted";
    case Outcome::diverged:
      return "diverged";
    case Outcome::non_finite:
      return "non-finite";
    case Outcome::stalled:
      return "stalled";
    case Outcome::deceived:
      return "deceived";
    case Outcome::raised:
      return "raised";
    case Outcome::chattering:
      return "chattering";
    case Outcome::grazing:
      return "grazing";
  }
  return "?";
}

}  // namespace oddity
