// At parameters that nobody chose, a method must succeed if it does in its record at the book's parameters.
// Where a parameter is 1, many a wrong formula is right. A method that is barely accurate enough there may
// have a larger error here, up to 2.4 tolerances as observed. The error of a wrong formula is far more than
// three.

#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/integrate.hpp"

using namespace oddity;

namespace {

/// Each parameter times another factor, kept in its range; whole numbers and seeds stay the same.
Parameters others(const Exercise& exercise) {
  Parameters all(exercise.parameters);
  double factor = 1.05;
  for (const Parameter& p : exercise.parameters) {
    if (p.whole || p.name == "seed") continue;
    const double more = p.value * factor, less = p.value / factor;
    const auto is_within = [&](double x) { return p.least <= x && x <= p.most; };
    if (is_within(more))
      all.set(p.name, more);
    else if (is_within(less))
      all.set(p.name, less);
    factor += 0.02;
  }
  return all;
}

void check_methods(const Entry& entry) {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Findings found = entry.exercise.study(others(entry.exercise), truth);
  int checked = 0;
  for (const Quantity& quantity : found.quantities)
    for (const Method& method : quantity.methods) {
      if (method.expected != Outcome::ok) continue;
      ++checked;
      const Trial trial = run(quantity, method, method.resolution.settings.back());
      INFO(quantity.name << ": " << method.model << ", " << method.algorithm << " at " << trial.setting
                         << ": " << name_of(trial.outcome) << ", off by " << trial.error);
      CHECK(trial.in_needs <= 3);
    }
  CHECK(checked > 0);
}

void reports_spent_budget(const Entry& entry) {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Findings found = entry.exercise.study(Parameters(entry.exercise.parameters), truth);
  const ode::EvaluationLimit few(1);
  for (const Quantity& quantity : found.quantities)
    for (const Method& method : quantity.methods) {
      const Answer answer = method.run(method.resolution.settings.front());
      INFO(quantity.name << ": " << method.model << ", " << method.algorithm);
      if (answer.ending == Ending::stalled) CHECK_FALSE(answer.message.empty());
    }
}

[[maybe_unused]] const bool registered = [] {
  for (const Entry& entry : registry())
    register_test([&entry] { reports_spent_budget(entry); },
                  to_string(entry.number) + ": a stopped method reports the cause",
                  "[endings][" + to_string(entry.number) + "]");
  for (const Entry& entry : registry())
    if (of_the_book(entry.number))
      register_test([&entry] { check_methods(entry); },
                    to_string(entry.number) + " at other parameters: its methods succeed as at the book's",
                    "[others][" + to_string(entry.number) + "]");
  return true;
}();

}  // namespace
