#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "tests/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

/// Every real parameter a quarter larger, or smaller where its range ends; a seed is left alone.
Parameters off_defaults(const Entry& entry) {
  Parameters p(entry.exercise.parameters);
  for (const Parameter& letter : p.declared()) {
    if (letter.whole || letter.name == "seed") continue;
    const double more = 1.25 * letter.value, less = 0.8 * letter.value;
    const auto allowed = [&](double x) { return letter.least <= x && x <= letter.most; };
    if (allowed(more) || allowed(less)) p.set(letter.name, allowed(more) ? more : less);
  }
  return p;
}

void ok_there(const Entry& entry) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  for (const Quantity& q : entry.exercise.study(off_defaults(entry), truth).quantities)
    for (const Method& m : q.methods) {
      if (m.expected != Outcome::ok) continue;
      const Trial trial = run(q, m, m.knob.settings.back());
      INFO(q.name << ", " << m.model << ", " << m.algorithm << ": error " << trial.error << ", needed "
                  << q.need.allowed << "; reference: " << q.reference.by);
      CHECK(name_of(trial.outcome) == "ok");
    }
}

/// At a parameter of 1 nobody sees whether a formula has it, its square or its inverse. Motions are left out:
/// the properties have them at random parameters.
const bool registered = [] {
  for (const Entry& entry : registry())
    if (!entry.exercise.scene)
      register_test([&entry] { ok_there(entry); }, to_string(entry.number) + " off its defaults",
                    "[off_defaults][" + to_string(entry.number) + "]");
  return true;
}();

}  // namespace

TEST_CASE("7.11: the logarithm of a determinant in range is found by every method", "[off_defaults][7.11]") {
  const Entry& entry = *std::ranges::find(registry(), Number{7, 11}, &Entry::number);
  Parameters p(entry.exercise.parameters);
  p.set("e", 1);
  const Findings found = entry.exercise.study(p, Reference::nothing());
  const Quantity& q = *std::ranges::find(found.quantities, "log_determinant", &Quantity::name);
  const double first = q.methods.front().run(0).value[0];
  CHECK(first > 1);
  for (const Method& m : q.methods) {
    INFO(m.model << ", " << m.algorithm);
    CHECK(near(m.run(0).value[0], first, 1e-12 * first));
  }
}
