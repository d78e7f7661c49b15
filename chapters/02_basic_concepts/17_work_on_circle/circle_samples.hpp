#pragma once

#include "chapters/02_basic_concepts/17_work_on_circle/circle_work.hpp"
#include "chapters/random.hpp"

/// Claims about a circular motion, judged at random radii, angular speeds and times.
namespace oddity::circle {

using M = const Motion&;

using Formula = std::function<Value(M)>;

struct Form {
  std::string text;
  Formula value;
};

/// The size of the terms that were added up, the rounding of x = omega T in the sine included.
using Size = double (*)(M);
inline double of_power(M m) { return abs(m.r * m.w) * (1 + abs(m.x())); }
inline double of_growing_power(M m) { return of_power(m) * (1 + abs(m.T)); }
inline double of_work(M m) { return abs(m.r) * (1 + abs(m.x())); }
inline double of_growing_work(M m) { return of_work(m) * (abs(m.T) + 1 / abs(m.w)); }
inline double of_turns(M m) { return abs(m.r) * (10 + abs(m.x())) * (1 + m.w * m.w); }
inline double of_maxima(M m) { return abs(m.r) * 400 * (m.w + 1 / m.w); }  // omega T up to 20 max(omega, 1)

enum class Ways { both, forward };

/// A motion with x = omega T up to 12: r and omega of either sign, or positive and away from omega = 1.
inline Motion any(Ways ways, Random& random) {
  const double r = random.magnitude(0.2, 5), x = random.between(0, 12);
  if (ways == Ways::forward) {
    const double w = random.unit() < 0.5 ? random.between(0.2, 0.8) : random.between(1.25, 4);
    return {abs(r), w, x / w};
  }
  const double w = random.magnitude(0.2, 5);
  return {r, w, (random.unit() < 0.5 ? x : -x) / w};
}

/// The samples of one claim.
struct Samples {
  double seed;
  std::string quantity;
  Form truth;
  Size size;
  Ways ways = Ways::both;

  Reading of(const Form& form) const {
    Worst worst(quantity + ", against " + truth.text, form.text, truth.text);
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
      const Motion m = any(ways, random);
      worst.see(form.value(m), truth.value(m), size(m),
                "r = " + shortest(m.r) + ", omega = " + shortest(m.w) + ", T = " + shortest(m.T));
    }
    return {form.text, {worst.check()}};
  }
};

/// How many of 50 forward motions and of k = 0, ..., 11 satisfy what none should.
inline Reading none(const std::string& text, double seed, const std::function<bool(M, int k)>& violates) {
  long wrong = 0, samples = 0;
  Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const Motion m = any(Ways::forward, random);
    for (int k = 0; k < 12; ++k, ++samples) wrong += violates(m, k);
  }
  return {text, {never(text + ", cases against it", wrong, samples)}};
}

const Form zero{"zero", [](M) { return 0.0; }};

}  // namespace oddity::circle
