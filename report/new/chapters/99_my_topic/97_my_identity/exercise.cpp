// Exercise 99.97: replace this by the question in one sentence, the reason why the other route is
// independent, and the sources with page. The law of cosines is an example, to be replaced:
//   c^2 = a^2 + b^2 - 2 a b cos gamma

#include "chapters/claims.hpp"
#include "chapters/to_write.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex99_97 {

using std::cos, std::sin;

constexpr Parameter parameters[] = {{"seed", 1, "1", "of the samples", 0, 1e6, whole_number}};

/// Two sides and the angle between them.
struct Sample {
  double a, b, gamma;

  explicit Sample(Random& random)
      : a(random.between(0.1, 10)), b(random.between(0.1, 10)), gamma(random.between(0.1, 3)) {}
  std::string where() const {
    return "a = " + format_shortest(a) + ", b = " + format_shortest(b) +
           ", gamma = " + format_shortest(gamma);
  }
  std::array<double*, 3> letters() { return {&a, &b, &gamma}; }
};

std::vector<Claim> claims(const Parameters& p) {
  return Claims("99.97")
      .formula<Sample>("first", 1, "the square of the third side, $c^2$", draw<Sample>(1000, p["seed"]),
                       {.truth = to_write(),
                        .printed = {R"($a^2+b^2-2ab\cos\gamma$)",
                                    [](const Sample& s) {
                                      return Value(s.a * s.a + s.b * s.b - 2 * s.a * s.b * cos(s.gamma));
                                    }},
                        .near_misses = {{R"($a^2+b^2+2ab\cos\gamma$)",
                                         [](const Sample& s) {
                                           return Value(s.a * s.a + s.b * s.b + 2 * s.a * s.b * cos(s.gamma));
                                         }}}})
      .in_order();
}

Findings study(const Parameters& p, const Reference&) { return {claims(p), {}}; }

}  // namespace ex99_97

Exercise exercise_99_97() {
  using namespace ex99_97;
  return {"My identity", "still to be written: the identity to show", parameters, {}, study};
}

}  // namespace oddity
