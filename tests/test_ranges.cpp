// Every parameter may be at either end of its range: choosing there gives an answer, or a refusal with its
// reason.

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "report/study/choose.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

/// The reason of a refusal; any other exception is not a refusal.
std::string refusal(const Task& task) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Need need = game_need();
  need.horizon = 0.1;
  need.frames_per_second = 30;
  need.time_limit = 2;
  need.starts = 1;
  const Price by_work = [](const Method& method, double setting) {
    return Time{1e-9 * static_cast<double>(method.run(setting).evaluations), 0};
  };
  try {
    choose(task, need, truth, by_work);
    return "";
  } catch (const BadInput& error) {
    return error.what();
  }
}

void check_ends(const Entry& entry) {
  int answered = 0;
  for (const Parameter& p : entry.exercise.parameters)
    for (double end : {p.least, p.most}) {
      if (p.whole || !std::isfinite(end)) continue;
      Task task(entry);
      task.parameters.set(p.name, end);
      std::string reason;
      INFO(p.name << " = " << end);
      REQUIRE_NOTHROW(reason = refusal(task));
      INFO(reason);
      CHECK((reason.empty() || reason.size() > 20));
      answered += reason.empty();
    }
  CHECK(answered > 0);
}

[[maybe_unused]] const bool ranges_registered = [] {
  for (const Entry& entry : registry())
    if (entry.exercise.scene && of_the_book(entry.number))
      register_test([&entry] { check_ends(entry); },
                    to_string(entry.number) + ": at the ends of its ranges it is answered or refused",
                    "[ranges][" + to_string(entry.number) + "]");
  return true;
}();

}  // namespace
