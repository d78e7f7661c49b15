// Results in the texts of breakdowns come from their trials: no measured number is typed into a sentence.

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <set>

#include "chapters/contents.hpp"
#include "chapters/places_kept.hpp"
#include "reference/reference.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

/// Typed numbers that are allowed, with the reason: none of them is measured.
struct Stays {
  std::string_view words, because;
};
constexpr std::string_view counted = "it counts things that the sentence or the exercise names",
                           by_name = "it belongs to a name", by_theory = "theory gives it",
                           example = "it is given as an example, not found",
                           in_radix = "it is the radix of a power that is filled in";
constexpr Stays stays[] = {
    {"(4) and (5)", by_name},
    {"(7)", by_name},
    {"Equation (2)", by_name},
    {"four evaluations per step", by_theory},
    {"half-way between", by_theory},
    {"half a turn", by_theory},
    {"half disc", by_name},
    {"half circle", by_name},
    {"a product of two twice over", by_theory},
    {"twice the digits", by_name},
    {"the two exponentials", counted},
    {"The two equations of motion", counted},
    {"the two angles", counted},
    {"The two sides", counted},
    {"two nearly equal", counted},
    {"of two doubles", counted},
    {"the two long sides", counted},
    {"from two conditions", counted},
    {"Two neighbours", counted},
    {"Two changes are a quarter turn", by_theory},
    {"one of the two", counted},
    {"power of two", by_name},
    {"three coordinates", counted},
    {"The three products", counted},
    {"three vertices of one line", counted},
    {"the seven regions", counted},
    {"six terms of size 1", by_theory},
    {"The 24 terms", by_theory},
    {"cancel to 1;", by_theory},
    {"order 2", by_name},
    {"Order 4", by_name},
    {"order 4", by_name},
    {"Runge-Kutta 4", by_name},
    {"-0.2 and 0.2 both become 0", example},
    {"ceil - 1", by_theory},
    {"the products of four lengths are 0", by_theory},
    {"the determinant is 0", by_theory},
    {"A segment of length 0", by_theory},
    {"$(10^8,1)$ and $(10^8+1,1)$", example},
    {"$10^{", in_radix},
};

/// The text without placeholders, code and allowed numbers.
std::string without_what_stays(std::string text, std::set<std::string_view>& seen) {
  text = std::regex_replace(text, std::regex("@[1-9]|`[^`]*`"), "");
  // The longest first, as some contain others.
  std::vector<Stays> all(std::begin(stays), std::end(stays));
  std::ranges::stable_sort(all, std::greater{}, [](const Stays& s) { return s.words.size(); });
  for (const Stays& s : all)
    for (std::size_t at; (at = text.find(s.words)) != std::string::npos;) {
      seen.insert(s.words);
      text.replace(at, s.words.size(), s.words.front() == '$' && s.words.back() != '$' ? "$" : "");
    }
  return text;
}

/// The first number that is no coefficient, index or exponent of one digit in a formula. A small number in
/// words counts things named in the sentence, unless a unit of measurement follows.
std::string number_in(const std::string& text) {
  const std::regex in_formula(R"(\d[\d.]+|\\cdot\s*10)"),
      in_words(
          R"(\d[\d.]*|\b(half|third|quarter|twice|tenth|hundredth|thousandth|\w+fold|per cent|)"
          R"((two|three|four|five|six|seven|eight|nine|ten|eleven|twelve|dozen|sixteen|twenty|thirty|sixty|)"
          R"(hundred|thousand|million)( \w+)? (times|steps|points|panels|evaluations|iterations|digits|)"
          R"(decimals|degrees|turns|seconds|minutes|hours|days|months|years|metres?|kilometres?))\b)",
          std::regex::icase);
  bool is_formula = false;
  for (std::size_t from = 0; from <= text.size(); is_formula = !is_formula) {
    const std::size_t to = std::min(text.find('$', from), text.size());
    const std::string part = text.substr(from, to - from);
    if (std::smatch found; std::regex_search(part, found, is_formula ? in_formula : in_words))
      return found.str();
    from = to + 1;
  }
  return "";
}

std::vector<Breakdown> breakdowns() {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  std::vector<Breakdown> all;
  for (const Entry& entry : registry())
    for (const Quantity& q : entry.exercise.study(Parameters(entry.exercise.parameters), truth).quantities)
      all.insert(all.end(), q.breakdowns.begin(), q.breakdowns.end());
  return all;
}

/// Texts of an exercise apart from its claims' readings, with placeholders.
struct Said {
  std::string where, text;
};

std::vector<Said> unfilled_texts() {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  const PlacesKept kept;
  std::vector<Said> all;
  const auto add = [&](const std::string& where, const std::string& text) {
    if (!text.empty()) all.push_back({where, text});
  };
  for (const Entry& entry : registry()) {
    const Findings findings = entry.exercise.study(Parameters(entry.exercise.parameters), truth);
    const std::string number = to_string(entry.number);
    for (const Claim& c : findings.claims) {
      add(c.id + ": why", c.why);
      add(c.id + ": not checkable", c.not_checkable);
      for (const Reading* r : {&c.printed, &c.meant, &c.corrected, &c.in_view})
        for (const Check& check : r->checks) add(c.id + ": tolerance", check.tolerance.reason);
    }
    for (const Root& r : findings.roots) add(number + " " + r.name + ": shows", r.shows);
    for (const Quantity& q : findings.quantities) {
      // The text begins with the tolerance, which is set and not measured.
      const std::size_t set = std::min(q.need.reason.find_first_of(":;"), q.need.reason.size());
      add(number + " " + q.name + ": need", q.need.reason.substr(set));
      for (const auto* methods : {&q.methods, &q.methods_in_float})
        for (const Method& m : *methods)
          add(number + " " + q.name + ", " + m.model + ", " + m.algorithm, m.why);
    }
  }
  return all;
}

}  // namespace

/// Allowed typed numbers in explanations, roots' consequences, needs and tolerances, with the reason.
struct Pattern {
  const char* words;
  std::string_view because;
};
constexpr std::string_view in_book = "it is printed in the solution or in one of its displays",
                           given = "it states an example, a need or a tolerance",
                           coefficient = "it is a coefficient, an index or an order of a formula",
                           zero_or_one = "it is zero, a unit, or a number that overflows";
constexpr Pattern patterns[] = {
    {R"(\b[Ll]ines? \d+(?:(?:, and|,| and| to) \d+)*|\b\d{3,4} and \d{3,4}\b|\(\d+(?:\.\d)?\)|\bCase \d)",
     in_book},
    {R"(\b[Ee]xercise \d\.\d+|\bsolution of \d\.\d+|above the 3\b|over [61]0\b|factor 2 of the line)",
     in_book},
    {R"(half of these times|half of it was meant|half the axis|\bthird one of the three|second and the third term)",
     in_book},
    {R"(^half a unit of decimal \d+.*|^[\d.e+a-z]+ roundings of terms of size .*|and 64 roundings|half the interval)",
     given},
    {R"((?:\\rho|\\alpha|\\phi|\\lambda|[A-Za-z](?:_\d)?)=-?\d[\d.]*)", given},
    {R"(half a year|half a radian per second|a hundredth of its way|a tenth of the radius|15\^)", given},
    {R"(25 N\b|\b2 kg\b|\b200 steps|at 0\.01 s|sides 2 and)", given},
    {R"(twice (?:as (?:fast|far|wide)|its distance|the speed|the frequency|the unit vectors)|\\cdot0\.7\)/0\.7)",
     given},
    {R"(a ten-thousandth of a millionth|half a bin|parallel sides 2|(?:slow|low) for \w+ (?:digits|decimals))",
     given},
    {R"(Runge-Kutta 4|\\t?frac\s?\d\d|_\{\d\d\}|\border \d|\\cdot10\^\{45\}|\+4r\^2\)/80|\(30\\sqrt|13\\pi/4|2\^\{3/2\})",
     coefficient},
    {R"(27/64|0\.75\\,h|\b45\^\\circ|\b90\^\\circ|2\.8 times|half as large|twice the area|\b3h/4|of 8,)",
     by_theory},
    {R"(a third of each|a sixth of|half side squared|twice the first term|twice the pull|the plain one twice)",
     by_theory},
    {R"(10\^\{-8\}|less than 3 by)", given},
    {R"(10\^\{-2k\}|half a turn|condition below \$10\^5\$|[Tt]wo points|32 bits|four decimals of)",
     by_theory},
    {R"(\b[01]\b(?!\.\d))", zero_or_one}};

std::string without_patterns(std::string text, std::set<std::string_view>& seen) {
  text = std::regex_replace(text, std::regex("@[1-9]|`[^`]*`"), "@");
  for (const Pattern& each : patterns) {
    const std::string left = std::regex_replace(text, std::regex(each.words), "");
    if (left != text) seen.insert(each.words);
    text = left;
  }
  return text;
}

TEST_CASE("a measured number in a text is found", "[claims]") {
  for (const std::string typed : {"at eight steps a second", "where it is 14142", "off by $7\\cdot10^{-4}$",
                                  "near $2.83/\\omega$", "a thousandfold", "Sixteen points"})
    CHECK_FALSE(number_in(typed).empty());
  for (const std::string none :
       {"near $\\varepsilon^{1/4}$, and $1-e^2$ is lost", "at @2 steps a second", ""})
    CHECK(number_in(std::regex_replace(none, std::regex("@[1-9]"), "")).empty());
}

TEST_CASE("no measured number is typed into a breakdown's text", "[claims][texts]") {
  std::set<std::string_view> seen;
  for (const Breakdown& b : breakdowns()) {
    INFO(b.says);
    CHECK(number_in(without_what_stays(b.says, seen)) == "");
  }
  for (const Stays& s : stays) {
    INFO(s.words << " occurs nowhere: " << s.because);
    CHECK(seen.contains(s.words));
  }
}

TEST_CASE("no measured number is typed into a why, a consequence, or the reason of a need or a tolerance",
          "[claims][texts]") {
  std::set<std::string_view> seen;
  for (const Said& s : unfilled_texts()) {
    INFO(s.where << ": " << s.text);
    CHECK(number_in(without_patterns(s.text, seen)) == "");
  }
  for (const Pattern& each : patterns) {
    INFO(each.words << " occurs nowhere: " << each.because);
    CHECK(seen.contains(each.words));
  }
}

namespace {

/// "a fiftieth of a second of arc", "ten decimals: ..." in the quantity's unit; NaN where it begins
/// otherwise.
double worth(const std::string& need) {
  const std::map<std::string, double> units{
      {"centimetre", 1e-2},           {"millimetre", 1e-3},
      {"micrometre", 1e-6},           {"nanometre", 1e-9},
      {"microsecond", 1e-6},          {"seconds? of arc", std::numbers::pi / 648'000},
      {"thousandth per second", 1e-3}},
      parts{{"a", 1},       {"a fifth of a", 0.2},     {"a tenth of a", 0.1}, {"a fiftieth of a", 0.02},
            {"twenty", 20}, {"a hundredth of a", 0.01}},
      decimals{{"nine", 1e-9}, {"ten", 1e-10}, {"twelve", 1e-12}};
  for (const auto& [number, value] : decimals)
    if (need.starts_with(number + " decimals")) return value;
  for (const auto& [part, of] : parts)
    for (const auto& [unit, value] : units)
      if (std::regex_search(need, std::regex("^" + part + " " + unit + "\\b"))) return of * value;
  return NAN;
}

}  // namespace

TEST_CASE("a need in words is its number", "[claims][texts]") {
  const std::regex in_units("metre|microsecond|of arc|per second|^[a-z]+ decimals$"), filled_in("^@|^\\d");
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  int needs = 0;
  for (const Entry& entry : registry())
    for (const Quantity& q : entry.exercise.study(Parameters(entry.exercise.parameters), truth).quantities) {
      const std::string words = q.need.reason.substr(0, q.need.reason.find_first_of(",:;"));
      if (!std::regex_search(words, in_units) || std::regex_search(words, filled_in)) continue;
      INFO(to_string(entry.number) << " " << q.name << ": " << words << ", " << q.need.allowed);
      CHECK(std::abs(q.need.allowed / worth(words) - 1) < 0.05);
      ++needs;
    }
  CHECK(needs > 30);
}

TEST_CASE("a breakdown's numbers come from its trials", "[claims]") {
  Quantity q{"x", "m", "a length", {"known", 2.0}, 0, {}};
  Trial coarse{}, fine{};
  coarse.setting = 0.125, coarse.error = 0.021;
  fine.setting = 0x1p-10, fine.error = 5e-11;
  Breakdown b{"@1 steps, off by @1, @2 digits; $2^{@2}$ is off by $@1$ after @1 s",
              "",
              0.125,
              Outcome::inaccurate,
              "",
              0x1p-10,
              {steps_in_one(Side::broken), error_of(Side::broken), digits_of(Side::broken),
               power_of_two_of(Side::cured), error_of(Side::cured), 4}};
  CHECK(text_of(b, q, coarse, fine) ==
        "8 steps, off by 0.02, 1 digits; $2^{-10}$ is off by $5\\cdot10^{-11}$ after 4 s");
  b.numbers.pop_back();
  CHECK_THROWS_AS(text_of(b, q, coarse, fine), std::logic_error);
}

TEST_CASE("a breakdown reports the requested parameters", "[claims]") {
  const auto pendulum =
      std::ranges::find_if(registry(), [](const Entry& e) { return to_string(e.number) == "3.5"; });
  Task task(*pendulum);
  task.parameters.set("a", 1.0);
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  std::string all;
  for (const ExerciseResult& e : run(std::span(&task, 1), truth, false).exercises)
    for (const QuantityResult& q : e.quantities)
      for (const BreakdownResult& b : q.breakdowns) all += b.says;
  CHECK(all.find("let go at 57.3 degrees") != std::string::npos);
  CHECK(all.find('@') == std::string::npos);
}
