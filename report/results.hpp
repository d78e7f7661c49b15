#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "chapters/contents.hpp"

/// What comes of a run, as plain values: everything that a view, a judge or a file needs, and nothing that
/// runs.
namespace oddity {

struct JudgedClaim {
  Claim claim;
  Verdict verdict = Verdict::unsettled;
};

/// How long something takes: the median of several batches, and half the distance of their quartiles.
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
};

/// A method's trials from coarse to fine, and how the finest is expected to end.
struct MethodResult {
  std::string model, algorithm;
  Outcome expected = Outcome::ok;
  std::string why;
  std::vector<TimedTrial> trials;

  bool as_expected() const { return !trials.empty() && trials.back().outcome == expected; }
};

/// A breakdown's two rows as they were run.
struct BreakdownResult {
  std::string says;
  Outcome expected = Outcome::ok;
  TimedTrial broken, cured;

  bool as_expected() const { return broken.outcome == expected && cured.outcome == Outcome::ok; }
};

struct QuantityResult {
  std::string name, unit, says;
  Route reference;
  double reference_error = 0;
  Tolerance need;
  std::vector<MethodResult> methods;
  std::vector<BreakdownResult> breakdowns;
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
};

struct Results {
  std::vector<ExerciseResult> exercises;  ///< in the book's order
};

/// Results as JSON text and back. Numbers that are not finite are written as null and read as NaN.
std::string to_json(const Results&);
/// Throws BadInput naming `place` when the text is not results of this version.
Results results_from_json(const std::string& text, const std::string& place);

/// Throws BadInput when the file cannot be read.
Results read_results(const std::filesystem::path& file);
/// Throws BadInput when the file could not be written, so that no run is lost for it; makes its folder.
void require_writable(const std::filesystem::path& file);
/// Writes the whole file or none of it. Throws BadInput when it cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace oddity
