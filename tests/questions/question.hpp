#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/questions/json.hpp"
#include "tests/questions/scenes.hpp"

namespace questions {

/// A parameter, from `oddity list --json`.
struct Range {
  std::string name;
  double usual, least, most;
  bool whole;
};
using Ranges = std::map<std::string, std::vector<Range>, std::less<>>;  ///< by scene
Ranges ranges_of(const Json& list);

/// A question to `oddity choose`.
struct Question {
  std::vector<std::string> words;  ///< after `choose`, without a format
  const Scene* scene;
  Parameters parameters;
  double horizon = 10, rate = 60;
  std::string criterion = "path";
  std::map<std::string, double> errors = {};  ///< by base unit; "": in all others
  std::optional<double> digits = {};
  std::map<std::string, double> also = {};  ///< further criteria that have to hold
  double limit = 60;                        ///< s
  bool float_allowed = false, double_allowed = true, one_step = false, asked_alone = false;
  double jitter = 0, drop = 0, longest_frame = INFINITY;  ///< frames of different lengths
  std::vector<std::string> only = {}, exclude = {};
  std::string beside =
      "-";  ///< a format whose answer has to be the same: --csv, or none for text; "-": not asked

  std::string text() const;
  std::vector<double> times() const;  ///< for frames of one length
  bool frames_differ() const { return jitter > 0 || drop > 0 || longest_frame < INFINITY; }
  double error_in(const std::string& unit) const;
};

/// The words of a command line. Throws std::runtime_error for a word that this program does not know.
Question question_of(const std::vector<std::string>& words, const Ranges&);

/// Numbers that are the same on every machine (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  double part() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< in [0, 1)
  double between(double a, double b) { return a + (b - a) * part(); }
  double by_size(double a, double b);  ///< its logarithm is uniform
  bool chance(double p) { return part() < p; }
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[bits() % all.size()];
  }

 private:
  std::uint64_t state_;
};

/// Options that the program under test supports.
struct Asks {
  bool starts = false, also = false, frames = false;  ///< --starts 1; --energy and its like; --jitter
  double limit = 3;                                   ///< s per question
  double most_frames = 2e4;
};

Question random_question(Random&, const Ranges&, const Asks&);

}  // namespace questions
