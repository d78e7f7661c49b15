// Exercise 99.97: replace this by the question in one sentence, the reason why the other route is
// independent, and the sources with page. The law of cosines is an example, to be replaced:
//   c^2 = a^2 + b^2 - 2 a b cos gamma

#include "chapters/claims.hpp"
#include "chapters/to_write.hpp"

namespace oddity {

namespace ex99_97 {

using std::cos, std::sin;

constexpr Parameter parameters[] = {{"seed", 1, "1", "of the samples", 0, 1e6, whole_number}};

/// Two sides and the angle between them.
struct Sample {
  double a, b, gamma;

  Letters<double> table() {
    return {{"a", a, {0.1, 10}}, {"b", b, {0.1, 10}}, {R"(\gamma)", gamma, {0.1, 3}}};
  }
};

std::vector<Claim> claims(const Parameters& p) {
  const auto samples = draw<Sample>(1000, p["seed"]);
  Claims all("99.97");
  const auto claim = all.over(samples);
  claim("first", 1, "the square of the third side, $c^2$", to_write(), {R"($a^2+b^2-2ab\cos\gamma$)"});
  return all.in_order();
}

Findings study(const Parameters& p, const Reference&) { return {claims(p), {}}; }

}  // namespace ex99_97

Exercise exercise_99_97() {
  using namespace ex99_97;
  return {"My identity", "still to be written: the identity to show", parameters, {}, study};
}

}  // namespace oddity
