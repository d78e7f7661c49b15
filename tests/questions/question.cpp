#include "tests/questions/question.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>

namespace questions {

namespace {

/// Base unit and size in it, by unit.
const std::map<std::string, std::pair<std::string, double>, std::less<>> units{
    {"", {"", 1}},
    {"m", {"m", 1}},
    {"cm", {"m", 0.01}},
    {"mm", {"m", 0.001}},
    {"km", {"m", 1000}},
    {"rad", {"rad", 1}},
    {"deg", {"rad", std::numbers::pi / 180}},
    {"AU", {"AU", 1}},
    {"%", {"", 0.01}},
    {"s", {"s", 1}},
    {"ms", {"s", 0.001}},
    {"h", {"s", 3600}},
    {"min", {"s", 60}},
    {"Hz", {"1/s", 1}},
    {"us", {"s", 1e-6}},
    {"ns", {"s", 1e-9}},
    {"yr", {"yr", 1}}};

struct Given {
  double value;
  std::string unit;  ///< base
};
Given read(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const auto unit = units.find(std::string(end));
  if (end == text.c_str() || unit == units.end()) throw std::runtime_error("what is " + text + "?");
  return {number * unit->second.second, unit->second.first};
}

std::string shortest(double x) {
  std::array<char, 40> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}
/// With so few digits that a reader can retype it.
double rounded(double x, int digits) {
  std::array<char, 40> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size() - 1, x, std::chars_format::general, digits);
  *end.ptr = 0;
  return std::strtod(text.data(), nullptr);
}

std::vector<std::string> parts(const std::string& text, char by) {
  std::vector<std::string> all(1);
  for (char c : text)
    if (c == by)
      all.emplace_back();
    else
      all.back() += c;
  return all;
}

}  // namespace

Ranges ranges_of(const Json& list) {
  Ranges ranges;
  for (const Json& row : list.items)
    if (row["scene"].value == 1 && !row["parameter"].words.empty())
      ranges[row["exercise"].words].push_back({row["parameter"].words, row["value"].value, row["least"].value,
                                               row["most"].value, row["whole"].value == 1});
  return ranges;
}

std::string Question::text() const {
  std::string all = "choose";
  for (const std::string& word : words)
    all += " " + (word.find_first_of(" ();&$") == std::string::npos ? word : "'" + word + "'");
  return all;
}

std::vector<double> Question::times() const {
  std::vector<double> all(static_cast<std::size_t>(std::round(horizon * rate)));
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<double>(k + 1) / rate;
  return all;
}

double Question::error_in(const std::string& unit) const {
  const auto named = errors.find(unit), other = errors.find("");
  return named != errors.end() ? named->second : other != errors.end() ? other->second : NAN;
}

Question question_of(const std::vector<std::string>& words, const Ranges& ranges) {
  Question q{.words = words, .scene = nullptr, .parameters = {}};
  for (const Scene& scene : scenes())
    if (!words.empty() && scene.number == words[0]) q.scene = &scene;
  if (!q.scene) throw std::runtime_error("no scene");
  for (const Range& p : ranges.at(q.scene->number)) q.parameters[p.name] = static_cast<Real>(p.usual);
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (const auto is = word.find('='); is != std::string::npos && !word.starts_with("-")) {
      q.parameters[word.substr(0, is)] = static_cast<Real>(read(word.substr(is + 1)).value);
      continue;
    }
    if (word == "--cheapest" || word == "--measure") continue;
    if (word == "--one-step") {
      q.one_step = true;
      continue;
    }
    if (i + 1 == words.size()) throw std::runtime_error("what is " + word + "?");
    const std::string& value = words[++i];
    if (word == "--error")
      for (const std::string& part : parts(value, ',')) {
        const Given given = read(part);
        q.errors[given.unit] = given.value;
      }
    else if (word == "--digits")
      q.digits = read(value).value;
    else if (word == "--energy" || word == "--period" || word == "--constraint")
      q.also[word.substr(2)] = read(value).value;
    else if (word == "--horizon")
      q.horizon = read(value).value;
    else if (word == "--fps")
      q.rate = read(value).value;
    else if (word == "--criterion")
      q.criterion = value;
    else if (word == "--time-limit")
      q.limit = read(value).value;
    else if (word == "--precision")
      q.float_allowed = value != "double", q.double_allowed = value != "float";
    else if (word == "--only")
      q.only.push_back(value);
    else if (word == "--exclude")
      q.exclude.push_back(value);
    else if (word == "--starts")
      q.asked_alone = value == "1";
    else if (word == "--jitter")
      q.jitter = read(value).value;
    else if (word == "--drop")
      q.drop = read(value).value;
    else if (word == "--max-frame")
      q.longest_frame = read(value).value;
    else if (word != "--budget" && word != "--bodies" && word != "--restart-every" && word != "--frame-seed")
      throw std::runtime_error("what is " + word + "?");
  }
  return q;
}

std::uint64_t Random::bits() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

double Random::by_size(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }

namespace {

/// Near the usual value, within a decade of it, or anywhere in the range: a scene with only extreme
/// parameters mostly has a motion that nobody can compute.
double random_value(const Range& p, Random& random) {
  if (random.chance(0.03)) return random.chance(0.5) ? p.least : p.most;
  const double size = p.usual == 0 ? 1 : std::abs(p.usual);
  const auto within = [&](double least, double most) {
    const double from = std::max(least, p.least), to = std::min(most, p.most);
    return p.least > 0 && to / from > 20 ? random.by_size(from, to) : random.between(from, to);
  };
  const double kind = random.part();
  if (kind < 0.4) return within(p.usual - size / 2, p.usual + size / 2);
  if (kind < 0.75) return p.least > 0 ? within(size / 10, size * 10) : within(-10 * size, 10 * size);
  return within(p.least, p.most);
}

}  // namespace

Question random_question(Random& random, const Ranges& ranges, const Asks& asks) {
  const Scene& scene = scenes()[random.bits() % scenes().size()];
  std::vector<std::string> words{scene.number};
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back(option);
    words.push_back(value);
  };
  const double touched = random.one_of<double>({0, 0.3, 0.6, 1});
  for (const Range& p : ranges.at(scene.number)) {
    if (p.whole || !random.chance(touched)) continue;
    double x = random_value(p, random);
    x = rounded(x, random.chance(0.5) ? 3 : 6);
    if (x >= p.least && x <= p.most) words.push_back(p.name + "=" + shortest(x));
  }
  const std::string time = scene.number == "3.3" ? "yr" : "s";
  const double rate = random.chance(0.5) ? random.one_of<double>({24, 30, 60, 60, 120, 144, 240, 1000})
                                         : rounded(random.by_size(2, 500), 3);
  double horizon =
      random.chance(0.6) ? rounded(random.by_size(0.3, 30), 2) : rounded(random.by_size(1, 3600), 3);
  horizon = std::max(std::min(horizon, rounded(asks.most_frames / rate, 2)), 2 / rate);
  if (random.chance(0.9)) add("--horizon", shortest(horizon) + (random.chance(0.3) ? time : ""));
  if (random.chance(0.9)) add("--fps", shortest(rate));
  const std::string criterion = random.one_of<std::string>(
      {"path", "path", "path", "path", "energy", "energy", "period", "bounded", "constraint"});
  if (criterion != "path" || random.chance(0.1)) add("--criterion", criterion);
  const double error = rounded(random.by_size(1e-7, 0.1), 2);
  if (criterion == "bounded") {
    if (random.chance(0.03)) add("--error", shortest(error));  // it accepts none
  } else if (criterion == "path" && random.chance(0.1)) {
    add("--digits", std::to_string(1 + random.bits() % 9));
  } else if (criterion == "path" && random.chance(0.3)) {
    std::string text;
    for (const Norm& norm : scene.norms)
      if (text.find(norm.unit) == std::string::npos)
        text += (text.empty() ? "" : ",") + shortest(rounded(random.by_size(1e-6, 1), 2)) +
                (norm.unit == "rad" ? random.one_of<std::string>({"rad", "deg"})
                 : norm.unit == "m" ? random.one_of<std::string>({"m", "cm", "mm"})
                                    : norm.unit);
    add("--error", text);
  } else {
    add("--error", shortest(error));
  }
  if (asks.also && criterion == "path")
    for (const char* option : {"--energy", "--period", "--constraint"})
      if (random.chance(0.07)) add(option, shortest(rounded(random.by_size(1e-6, 0.1), 2)));
  if (random.chance(0.25)) add("--precision", random.one_of<std::string>({"float", "double", "any"}));
  if (random.chance(0.2)) words.push_back("--cheapest");
  if (random.chance(0.15)) words.push_back("--one-step");
  if (random.chance(0.15)) add("--bodies", std::to_string(1 + static_cast<long>(random.by_size(1, 1e5))));
  if (random.chance(0.15)) add("--restart-every", shortest(rounded(random.by_size(0.05, 10), 2)));
  if (random.chance(0.15)) add("--budget", shortest(rounded(random.by_size(0.05, 1000), 2)) + "us");
  const std::vector<std::string> some =  // the last are not in every scene
      random.chance(0.9) ? std::vector<std::string>{"Euler", "Runge", "Dormand", "Fehlberg"}
                         : std::vector<std::string>{"Verlet", "Cartesian", "angle", "closed", "CVODE"};
  if (random.chance(0.1)) add("--only", random.one_of(some));
  while (random.chance(0.25)) add("--exclude", random.one_of(some));
  if (asks.starts && random.chance(0.5)) add("--starts", "1");
  // Frames of different lengths are allowed only for questions that are judged frame by frame, for one body.
  const auto has = [&](const char* option) { return std::ranges::find(words, option) != words.end(); };
  if (asks.frames && random.chance(0.3) && criterion != "period" && criterion != "energy" &&
      !has("--energy") && !has("--period") && !has("--bodies")) {
    if (random.chance(0.7)) add("--jitter", shortest(rounded(random.by_size(1, 90), 2)) + "%");
    if (random.chance(0.5)) add("--drop", shortest(rounded(random.by_size(0.2, 50), 2)) + "%");
    if (random.chance(0.3)) add("--max-frame", shortest(rounded(random.between(0.5, 3) / rate, 3)));
    if (has("--jitter") || has("--drop")) add("--frame-seed", std::to_string(random.bits() % 1000));
  }
  add("--time-limit", shortest(asks.limit) + "s");
  Question question = question_of(words, ranges);
  question.beside = random.one_of<std::string>({"--csv", "", "-", "-"});
  return question;
}

}  // namespace questions
