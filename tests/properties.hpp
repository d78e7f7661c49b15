#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "chapters/contents.hpp"
#include "chapters/random.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/verify/catch.hpp"
#include "tests/in_environment.hpp"

/// Properties that must hold at all usual parameters, tried at random ones. On failure the simplest failing
/// parameters found are printed as a command. ODDITY_SETS is the number of trials, ODDITY_SEED their seed.
namespace oddity::properties {

/// Returns the failure at these parameters; empty if the property holds.
using Property = std::function<std::string(const Parameters&)>;

/// Within a factor of ten of the usual value (up to 2 for a zero), uniform by size. A range ends where a
/// model does, and there roundings may be all that is left of a motion.
inline double random_value(const Parameter& p, Random& random) {
  const double reach = p.value == 0 ? 2 : 10 * std::abs(p.value);
  const double least = std::max(p.least, p.least > 0 ? p.value / 10 : -reach), most = std::min(p.most, reach);
  const double x = least > 0 ? random.magnitude(least, most) : random.between(least, most);
  return std::clamp(p.whole ? std::round(x) : least > 0 ? std::abs(x) : x, least, most);
}

/// Seeds of the checks' own samples stay the same.
inline Parameters random_parameters(const Exercise& exercise, Random& random) {
  Parameters parameters(exercise.parameters);
  for (const Parameter& p : exercise.parameters)
    if (p.name != "seed") parameters.set(p.name, random_value(p, random));
  return parameters;
}

/// Empty for parameters that the exercise refuses as they do not go together: these are counted.
inline std::string wrong_at(const Parameters& parameters, const Property& property, int& refused) {
  try {
    return property(parameters);
  } catch (const BadInput&) {
    ++refused;
    return "";
  }
}

/// Resets each parameter to the book's value, or else to fewer digits, as long as the property fails.
inline Parameters shrunk(Parameters failing, const Property& property) {
  int refused = 0;
  for (const Parameter& p : failing.declared())
    for (const double simpler : {p.value, parse_number(format_significant(failing[p.name], 1)).value(),
                                 parse_number(format_significant(failing[p.name], 2)).value(),
                                 parse_number(format_significant(failing[p.name], 4)).value()}) {
      if (!(p.least <= simpler && simpler <= p.most)) continue;
      Parameters simple = failing;
      simple.set(p.name, simpler);
      if (wrong_at(simple, property, refused).empty()) continue;
      failing = simple;
      break;
    }
  return failing;
}

inline std::string command(const Entry& entry, const Parameters& parameters) {
  std::string words = "oddity solve " + to_string(entry.number);
  for (const Parameter& p : parameters.declared())
    if (parameters[p.name] != p.value)
      words += " " + std::string(p.name) + "=" + format_shortest(parameters[p.name]);
  return words;
}

/// Tries the property at this many parameters, unless the environment gives another number; prints the first
/// failure.
inline void check(const Entry& entry, const std::string& says, int usual, const Property& property) {
  Random random(in_environment("ODDITY_SEED", 1) * 1e4 + entry.number.chapter * 100 + entry.number.index);
  const int sets = in_environment("ODDITY_SETS", usual);
  int refused = 0;
  for (int set = 0; set < sets; ++set) {
    const Parameters parameters = random_parameters(entry.exercise, random);
    if (wrong_at(parameters, property, refused).empty()) continue;
    const Parameters simple = shrunk(parameters, property);
    FAIL_CHECK(to_string(entry.number)
               << ": " << says << ", but not at set " << set << ": " << wrong_at(simple, property, refused)
               << "\n  " << command(entry, simple));
    return;
  }
  if (refused == sets)
    FAIL_CHECK(to_string(entry.number) << ": " << says << ": all " << sets << " sets were refused");
}

inline const Entry& entry_of(std::string_view number) {
  return *std::ranges::find(registry(), exercise_number(number), &Entry::number);
}

}  // namespace oddity::properties
