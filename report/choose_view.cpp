#include <cmath>

#include "reference/text.hpp"
#include "report/choose.hpp"
#include "report/text_view.hpp"

namespace oddity {

namespace {

std::string times_as(double factor) { return rounded(factor, 2) + " times"; }

std::string described(const Tried& tried, const Need& need) {
  const std::string setting = shown_setting(tried, need);
  return tried.model + " by " + tried.algorithm + (setting == "-" ? "" : ", " + setting);
}

std::string error_of(double in_needs, const Choice& choice) {
  if (!std::isfinite(in_needs)) return "-";
  return shown_error(in_needs * choice.need.error) + (choice.need.relative ? " of the motion"
                                                      : choice.unit == "1" ? ""
                                                                           : " " + choice.unit);
}

std::string cost_of(const Tried& tried) {
  const std::string evaluations = rounded(tried.evaluations_a_frame, 3);
  return shown_time(tried.seconds_a_frame) + " a frame (" + evaluations +
         (evaluations == "1" ? " evaluation)" : " evaluations)");
}

std::string failing_of(const Tried& tried, const Choice& choice) {
  return described(tried, choice.need) + ", " + cost_of(tried) + ": " + std::string(name_of(tried.outcome)) +
         (std::isfinite(tried.error) ? ", error " + error_of(tried.error, choice) : "") + " at " +
         tried.where;
}

std::string asked(const Choice& choice) {
  const Need& need = choice.need;
  return choice.quantity + " within " + error_of(1, choice) + " over " + shortest(need.horizon) + " " +
         choice.time_unit + " at " + shortest(need.frames_a_second) + " frames a " +
         (choice.time_unit == "s" ? "second" : choice.time_unit) +
         (std::isfinite(need.budget) ? ", for at most " + shown_time(need.budget) + " a frame" : "");
}

std::string listed(const std::vector<std::string>& starts) {
  std::string text;
  for (const std::string& start : starts) text += (text.empty() ? "" : "; ") + start;
  return text;
}

std::string answer_text(const Choice& choice) {
  const Tried& best = *choice.chosen;
  std::string text = "Take " + described(best, choice.need) + ": " + cost_of(best);
  if (std::isfinite(choice.need.budget))
    text += ", " + rounded(100 * best.seconds_a_frame / choice.need.budget, 2) + " % of the budget";
  text += ".\n  margin: on starts that it was not chosen on its error is " +
          error_of(best.unseen_error, choice) +
          (best.unseen_error > 0 ? ", " + times_as(choice.margin()) + " less than asked.\n" : ".\n");
  if (choice.next_cheaper) text += "  next cheaper: " + failing_of(*choice.next_cheaper, choice) + ".\n";
  if (const auto& richer = choice.next_richer)
    text += "  next richer: " + described(*richer, choice.need) + ", " + cost_of(*richer) + ": " +
            times_as(richer->seconds_a_frame / best.seconds_a_frame) + " the cost for an error of " +
            error_of(richer->error, choice) + ".\n";
  return text;
}

std::string miss_text(const Choice& choice) {
  std::string text = "Nothing here meets that.\n";
  if (!choice.nearest_miss) return text;
  const Tried& miss = *choice.nearest_miss;
  if (!miss.holds()) return text + "  nearest miss: " + failing_of(miss, choice) + ".\n";
  return text + "  nearest miss: " + described(miss, choice.need) + " is as accurate, but costs " +
         cost_of(miss) + ", " + times_as(miss.seconds_a_frame / choice.need.budget) + " the budget.\n";
}

std::string verdict_of(const Tried& tried, const Choice& choice) {
  if (choice.chosen && tried.model == choice.chosen->model && tried.algorithm == choice.chosen->algorithm)
    return "chosen";
  if (!tried.holds()) return std::string(name_of(tried.outcome)) + " at " + tried.where;
  return tried.seconds_a_frame > choice.need.budget ? "over the budget" : "holds";
}

}  // namespace

std::string choice_text(const Choice& choice) {
  std::vector<std::vector<std::string>> rows{
      {"model", "algorithm", "setting", "error", "evaluations a frame", "time a frame", ""}};
  for (const Tried& tried : choice.tried)
    rows.push_back({tried.model, tried.algorithm, shown_setting(tried, choice.need),
                    error_of(tried.error, choice), rounded(tried.evaluations_a_frame, 3),
                    shown_time(tried.seconds_a_frame), verdict_of(tried, choice)});
  return asked(choice) + "\n\n" + (choice.chosen ? answer_text(choice) : miss_text(choice)) +
         "\nEach method at its cheapest setting that holds, or else at its best:\n" + aligned(rows) +
         "\nchosen on: " + listed(choice.seen) +
         (choice.unseen.empty() ? "" : "\ntested on: " + listed(choice.unseen)) + "\n";
}

}  // namespace oddity
