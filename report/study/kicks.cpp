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

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

/// The parts between these, without blanks around them.
std::vector<std::string> split(const std::string& text, char between) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
    end = text.find(between, begin);
    parts.push_back(trimmed(text.substr(begin, end == text.npos ? end : end - begin)));
  }
  return parts;
}

/// The change that a value asks for, which loses its sign. A value in parentheses has its sign for itself.
Kick::Change change_of(std::string& value) {
  if (value.starts_with('(') && value.ends_with(')')) {
    value = trimmed(value.substr(1, value.size() - 2));
    return Kick::Change::sets;
  }
  const char first = value.front();
  if (first == '*' || first == '+') value = trimmed(value.substr(1));
  if (first == '-') value = "-" + trimmed(value.substr(1));
  return first == '*'                   ? Kick::Change::scales
         : first == '+' || first == '-' ? Kick::Change::adds
                                        : Kick::Change::sets;
}

/// The text of kicks of a scene's observables.
class Text {
 public:
  Text(const Scene& scene, const Quantity& seen, double horizon)
      : scene_(scene), units_(names().size(), seen.unit), horizon_(horizon) {
    for (const Norm& norm : seen.norms)
      for (const std::size_t i : norm.components) units_.at(i) = norm.unit;
  }

  void add_to(Kicks& kicks, const std::string& text) const {
    const std::vector<std::string> parts = split(text, ',');
    const auto [t, when] = assignment(parts.front());
    if (t != "t") refuse("has '" + text + "', which begins with no time");
    if (parts.size() < 2) refuse("has '" + text + "', which changes nothing");
    const double time = number_in(when, time_unit());
    if (!(time > 0 && time < horizon_))
      refuse("is at " + format_shortest(time) + " " + time_unit() + ", which is not within the horizon of " +
             format_shortest(horizon_) + " " + time_unit() + ", its ends excluded");
    for (std::size_t i = 1; i < parts.size(); ++i) add_to(kicks, time, parts[i]);
  }

 private:
  /// Adds the change of one observable or of all speeds.
  void add_to(Kicks& kicks, double time, const std::string& text) const {
    auto [name, value] = assignment(text);
    const Kick::Change change = change_of(value);
    const bool is_factor = change == Kick::Change::scales;
    if (name == "speed'") refuse("has '" + text + "': speed is a rate already, as in speed=*0.5");
    if (name == speed && !is_factor) refuse("has '" + text + "': speed takes a factor, as in speed=*0.5");
    const bool of_rate = name == speed || name.ends_with("'");
    if (name.ends_with("'")) name.pop_back();
    const std::size_t first = name == speed ? 0 : find(name),
                      last = name == speed ? names().size() : first + 1;
    for (std::size_t i = first; i < last; ++i)
      kicks.push_back({time, i, of_rate, change, number_in(value, is_factor ? "" : unit(i, of_rate))});
  }

  std::pair<std::string, std::string> assignment(const std::string& text) const {
    const std::vector<std::string> sides = split(text, '=');
    if (sides.size() != 2 || sides[0].empty() || sides[1].empty())
      refuse("has '" + text + "', which is not name=value");
    return {sides[0], sides[1]};
  }

  double number_in(const std::string& text, const std::string& unit) const {
    try {
      const double value = in_unit(text, unit);
      if (std::isfinite(value)) return value;
    } catch (const BadInput& error) {
      refuse("has '" + text + "': " + error.what());
    }
    refuse("has '" + text + "', which is not finite");
  }

  std::size_t find(const std::string& name) const {
    const auto found = std::ranges::find(names(), name);
    if (found != names().end()) return static_cast<std::size_t>(found - names().begin());
    std::string all;
    for (const std::string_view one : names()) all += std::string(one) + ", " + std::string(one) + "', ";
    refuse("knows no '" + name + "' here: the names are " + all + "and " + std::string(speed));
  }

  std::string unit(std::size_t i, bool of_rate) const {
    const bool is_number = units_[i].empty() || units_[i] == "1";
    if (!of_rate) return is_number ? "" : units_[i];
    const std::string per = "/" + time_unit();
    if (is_number) return "1" + per;
    return units_[i].ends_with("/s") && per == "/s" ? units_[i] + "^2" : units_[i] + per;
  }

  [[noreturn]] void refuse(const std::string& why) const {
    const std::string rate = unit(0, true);
    throw BadInput("--kick " + why + "; a kick is a time and what changes, as in \"t=" +
                   format_significant(horizon_ / 2, 2) + time_unit() + "," + std::string(names().front()) +
                   "'=+2" + (rate.starts_with("1/") ? "" : rate) + "\"");
  }

  std::string time_unit() const { return std::string(scene_.axes.time); }
  const std::vector<std::string_view>& names() const { return scene_.axes.observables; }

  const Scene& scene_;
  std::vector<std::string> units_;
  double horizon_;
};

constexpr double fine = 1e-13;

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

/// Whether a motion is the true one, as long as that is known so well.
bool is_true(const Quantity& motion, const Answer& answer) {
  constexpr double as_good = 1e-6;  // relative to the motion's size and its need
  if (!answer.reached() || !finite(answer.value)) return false;
  const double allowed = std::min(as_good * size_of(motion.reference.value), 0.1 * motion.need.allowed);
  const std::vector<double> apart = apart_until(answer.value, motion.reference.value, motion.samples);
  const auto& known = motion.reference_error_until;
  for (std::size_t k = 0; k < apart.size(); ++k) {
    const double known_to = known.empty() ? motion.reference_error : known[k];
    if (k > 0 && known_to > allowed) return true;
    if (apart[k] > allowed + known_to) return false;
  }
  return true;
}

using Way = std::pair<std::string, std::string>;

std::string described(const Way& way) { return way.first + " by " + way.second; }

/// By all ways that come to the end with the kicks, of which there have to be two.
void set_truth(Quantity& motion, std::vector<Way> ways) {
  std::vector<Value> paths;
  std::string trouble;
  std::erase_if(ways, [&](const Way& way) {
    const Method* method = method_of(motion, way.first, way.second);
    const Answer answer = method ? run(motion, *method, fine).answer : Answer{.ending = Ending::raised};
    if (answer.message == is_undetermined)
      throw BadInput("--kick: " + answer.message + "; a scene that shows every freedom takes it");
    if (answer.reached())
      paths.push_back(answer.value);
    else if (method)
      trouble = ": " + described(way) + " does not come to its end" +
                (answer.message.empty() ? "" : ", as " + answer.message);
    return !answer.reached();
  });
  if (paths.size() < 2)
    throw BadInput("the motion after the kick is not known, as fewer than two ways follow it" + trouble);
  const double rounding = 2e-16 * size_of(paths.back());
  std::vector<double> until(static_cast<std::size_t>(motion.samples), rounding);
  for (std::size_t i = 0; i + 1 < paths.size(); ++i) {
    const std::vector<double> apart = apart_until(paths[i], paths.back(), motion.samples);
    for (std::size_t k = 0; k < until.size(); ++k) until[k] = std::max(until[k], rounding + 4 * apart[k]);
  }
  motion.reference = {described(ways.back()) + ", compared with " + described(ways.front()), paths.back()};
  motion.reference_error = until.back();
  motion.reference_error_until = std::move(until);
}

}  // namespace

std::pair<std::shared_ptr<const Kicks>, std::string> kicks_of(const Scene& scene, const Quantity& seen,
                                                              const std::string& text, double horizon) {
  const Text kick(scene, seen, horizon);
  auto kicks = std::make_shared<Kicks>();
  for (const std::string& one : split(text, ';'))
    if (!one.empty() || kicks->empty()) kick.add_to(*kicks, one);
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

std::shared_ptr<const Kicks> with_ways(const std::shared_ptr<const Kicks>& kicks, const Quantity& without) {
  constexpr double most_work = 2000;  // evaluations a frame: a model that never comes to rest takes more
  constexpr std::array algorithms = {"Fehlberg 7(8)", "GSL rk8pd", "Dormand-Prince 5(4)"};
  const ode::EvaluationLimit limited(most_work * without.samples);
  std::vector<Way> held, free;
  std::string wrong;  // solved so finely, its other algorithms show the same motion
  for (const Method& method : without.methods) {
    std::vector<Way>& ways = method.off_constraint ? held : free;
    if (std::ranges::find(algorithms, method.algorithm) == algorithms.end() || method.model == wrong ||
        std::ranges::count(ways, method.model, &Way::first) >= 2)
      continue;
    if (is_true(without, method.run(fine)))
      ways.emplace_back(method.model, method.algorithm);
    else
      wrong = method.model;
  }
  auto followed = std::make_shared<Kicks>(*kicks);
  followed->ways = std::move(held);
  followed->ways.insert(followed->ways.end(), free.begin(), free.end());
  return followed;
}

Quantity kicked_motion(Quantity without, const std::shared_ptr<const Kicks>& kicks) {
  Quantity kicked = without;
  for (Method& method : kicked.methods) method = with_kicks(std::move(method), kicks);
  kicked.methods_in_float.clear();
  kicked.breakdowns.clear();
  if (finite(without.reference.value))
    set_truth(kicked, (kicks->ways.empty() ? with_ways(kicks, without) : kicks)->ways);
  return kicked;
}

}  // namespace oddity
