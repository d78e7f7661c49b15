#include "report/study/kicks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "reference/bad_input.hpp"
#include "reference/quantity_text.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "report/study/run.hpp"

namespace oddity {

namespace {

constexpr std::string_view speed = "speed", knows_no_kick = "it knows no kick";

/// What stands between these.
std::vector<std::string> split(const std::string& text, char between) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
    end = text.find(between, begin);
    parts.push_back(text.substr(begin, end == text.npos ? end : end - begin));
  }
  return parts;
}

[[noreturn]] void refuse(const std::string& why) {
  throw BadInput("--kick " + why + "; a kick is a time and what changes, as in \"t=1s,theta'=+2rad/s\"");
}

std::pair<std::string, std::string> assignment(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == text.npos || equals == 0 || equals + 1 == text.size())
    refuse("has '" + text + "', which is not name=value");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

double number_in(const std::string& text, const std::string& unit) {
  try {
    const double value = in_unit(text, unit);
    if (std::isfinite(value)) return value;
  } catch (const BadInput& error) {
    refuse("has '" + text + "': " + error.what());
  }
  refuse("has '" + text + "', which is not finite");
}

/// One of the scene's observables as the kick's text has it.
class Observables {
 public:
  Observables(const Scene& scene, const Quantity& seen) : scene_(scene), units_(names().size(), seen.unit) {
    for (const Norm& norm : seen.norms)
      for (const std::size_t i : norm.components) units_.at(i) = norm.unit;
  }

  std::size_t find(const std::string& name) const {
    const auto found = std::ranges::find(names(), name);
    if (found != names().end()) return static_cast<std::size_t>(found - names().begin());
    std::string all;
    for (const std::string_view one : names()) all += std::string(one) + ", " + std::string(one) + "', ";
    refuse("knows no '" + name + "' here: what is seen is " + all + "and " + std::string(speed));
  }
  std::size_t count() const { return names().size(); }
  std::string unit(std::size_t i, bool of_rate) const {
    if (!of_rate) return units_[i] == "1" ? "" : units_[i];
    const std::string per = "/" + std::string(scene_.axes.time);
    if (units_[i].empty() || units_[i] == "1") return "1" + per;
    return units_[i].ends_with("/s") && per == "/s" ? units_[i] + "^2" : units_[i] + per;
  }

 private:
  const std::vector<std::string_view>& names() const { return scene_.axes.observables; }

  const Scene& scene_;
  std::vector<std::string> units_;
};

Kick::Change change_of(std::string& value) {
  if (value.front() == '*') return value.erase(0, 1), Kick::Change::scales;
  if (value.front() == '+') return value.erase(0, 1), Kick::Change::adds;
  return value.front() == '-' ? Kick::Change::adds : Kick::Change::sets;
}

/// One change at a time, of one observable or of all speeds.
void add(Kicks& kicks, const Observables& observables, double time, const std::string& text) {
  auto [name, value] = assignment(text);
  const Kick::Change change = change_of(value);
  if (name == speed && change != Kick::Change::scales)
    refuse("has '" + text + "': speed takes a factor, as in speed=*0.5");
  const bool of_rate = name == speed || name.ends_with("'");
  if (name.ends_with("'")) name.pop_back();
  const std::size_t first = name == speed ? 0 : observables.find(name),
                    last = name == speed ? observables.count() : first + 1;
  for (std::size_t i = first; i < last; ++i)
    kicks.push_back({time, i, of_rate, change,
                     number_in(value, change == Kick::Change::scales ? "" : observables.unit(i, of_rate))});
}

void add(Kicks& kicks, const Observables& observables, const std::string& time_unit, double horizon,
         const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  const auto [t, when] = assignment(parts.front());
  if (t != "t" || parts.size() < 2)
    refuse("has '" + text + "', which begins with no time, or changes nothing");
  const double time = number_in(when, time_unit);
  if (!(time > 0 && time < horizon))
    refuse("is at " + when + ", which is not within the horizon of " + format_shortest(horizon) + " " +
           time_unit);
  for (std::size_t i = 1; i < parts.size(); ++i) add(kicks, observables, time, parts[i]);
}

/// A way to follow the motion closely.
struct Close {
  std::string model, algorithm;
};

constexpr double fine = 1e-13;

/// The models that have the true motion, each by two algorithms that adapt their steps. Richer ones come
/// last.
std::vector<Close> followed_closely(const Quantity& motion) {
  constexpr double as_good = 1e-6;  // of the motion's size, and of its need
  constexpr std::array algorithms = {"Fehlberg 7(8)", "GSL rk8pd", "Dormand-Prince 5(4)"};
  const double allowed =
      std::min(as_good * size_of(motion.reference.value), 0.1 * motion.need.allowed) + motion.reference_error;
  std::vector<Close> all;
  for (const Method& method : motion.methods) {
    if (std::ranges::find(algorithms, method.algorithm) == algorithms.end()) continue;
    const bool is_enough = std::ranges::count(all, method.model, &Close::model) >= 2;
    if (!is_enough && run(motion, method, fine).error <= allowed)
      all.push_back({method.model, method.algorithm});
  }
  return all;
}

/// By how much two motions are apart, at most, up to each time.
std::vector<double> apart_until(const Value& a, const Value& b, int samples) {
  std::vector<double> until;
  const std::size_t parts = a.size() / static_cast<std::size_t>(samples);
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    if ((i + 1) % parts == 0) until.push_back(most);
  }
  return until;
}

/// By all ways that come to the end with the kicks, of which there have to be two.
void set_truth(Quantity& motion, std::vector<Close> ways) {
  std::vector<Value> paths;
  std::string trouble;
  std::erase_if(ways, [&](const Close& way) {
    const Trial trial = run(motion, *method_of(motion, way.model, way.algorithm), fine);
    if (trial.answer.reached())
      paths.push_back(trial.answer.value);
    else
      trouble = ": " + way.model + " by " + way.algorithm + " does not come to its end" +
                (trial.answer.message.empty() ? "" : ", as " + trial.answer.message);
    return !trial.answer.reached();
  });
  if (paths.size() < 2)
    throw BadInput("the motion after the kick is not known, as fewer than two ways follow it" + trouble);
  const double rounding = 2e-16 * size_of(paths.back());
  std::vector<double> until(static_cast<std::size_t>(motion.samples), rounding);
  for (std::size_t i = 0; i + 1 < paths.size(); ++i) {
    const std::vector<double> apart = apart_until(paths[i], paths.back(), motion.samples);
    for (std::size_t k = 0; k < until.size(); ++k) until[k] = std::max(until[k], rounding + 4 * apart[k]);
  }
  motion.reference = {ways.back().model + " by " + ways.back().algorithm + ", compared with " +
                          ways.front().model + " by " + ways.front().algorithm,
                      paths.back()};
  motion.reference_error = until.back();
  motion.reference_error_until = std::move(until);
}

}  // namespace

std::pair<std::shared_ptr<const Kicks>, std::string> kicks_of(const Scene& scene, const Quantity& seen,
                                                              const std::string& text, double horizon) {
  const Observables observables(scene, seen);
  auto kicks = std::make_shared<Kicks>();
  for (const std::string& one : split(text, ';'))
    add(*kicks, observables, std::string(scene.axes.time), horizon, one);
  std::ranges::stable_sort(*kicks, {}, &Kick::time);
  std::string shown = text;
  for (std::size_t at = 0; (at = shown.find(';', at)) != shown.npos; at += 2) shown.replace(at, 1, "; ");
  return {kicks, shown};
}

Method with_kicks(Method method, const std::shared_ptr<const Kicks>& kicks) {
  method.run = [run = std::move(method.run), kicks](double setting) {
    const KicksHere here(*kicks);
    Answer answer = run(setting);
    if (here.are_taken()) return answer;
    return Answer{.ending = Ending::raised, .message = std::string(knows_no_kick)};
  };
  if (method.off_constraint)
    method.off_constraint = [off = std::move(method.off_constraint), kicks](double setting) {
      const KicksHere here(*kicks);
      return off(setting);
    };
  if (method.places_and_rates)
    method.places_and_rates = [seen = std::move(method.places_and_rates), kicks](double setting) {
      const KicksHere here(*kicks);
      return seen(setting);
    };
  return method;
}

Quantity kicked_motion(Quantity without, const std::shared_ptr<const Kicks>& kicks) {
  Quantity kicked = without;
  for (Method& method : kicked.methods) method = with_kicks(std::move(method), kicks);
  kicked.methods_in_float.clear();
  kicked.breakdowns.clear();
  if (!finite(without.reference.value)) return kicked;
  set_truth(kicked, followed_closely(without));
  return kicked;
}

}  // namespace oddity
