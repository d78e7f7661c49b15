#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/choose_view.hpp"
#include "report/study/choose.hpp"
#include "report/text/numbers.hpp"
#include "report/text/table_text.hpp"

namespace oddity {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t first_rows = 5;

std::string times_as(double factor) { return format_significant(factor, 2) + " times"; }

std::string described(const Candidate& candidate, const Need& need) {
  const std::string setting = shown_setting(candidate, need);
  return candidate.model + " by " + candidate.algorithm + (setting == "-" ? "" : ", " + setting);
}

/// The unit in which the need was stated, otherwise the motion's.
ShownUnit shown_unit(const std::string& unit, const Choice& choice) {
  const auto shown = choice.need.shown.find(unit);
  return shown == choice.need.shown.end() ? ShownUnit{unit, 1} : shown->second;
}

/// "0.35 cm, 0.002 rad".
std::string errors_of(const std::vector<double>& errors, const Choice& choice) {
  std::string text;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const ShownUnit unit = shown_unit(choice.units[i], choice);
    text += (i == 0 ? "" : ", ") + (std::isfinite(errors[i]) ? shown_error(errors[i] / unit.size) : "-");
    if (std::isfinite(errors[i]) && !unit.symbol.empty() && unit.symbol != "1") text += " " + unit.symbol;
  }
  return text;
}

/// The unit for distances from a constraint.
ShownUnit length_unit(const Choice& choice) { return shown_unit("m", choice); }

std::string off_constraint(double off, const Choice& choice) {
  const ShownUnit unit = length_unit(choice);
  return shown_error(off / unit.size) + " " + unit.symbol;
}

/// The error by one criterion, in its unit; infinite if it was not judged.
double own_error(const Candidate& candidate, Criterion criterion) {
  const auto found = candidate.by.find(criterion);
  return found == candidate.by.end() ? std::numeric_limits<double>::infinity() : found->second;
}

/// Whether the constraint holds up to rounding.
bool is_held(const Candidate& candidate, const Choice& choice) {
  return own_error(candidate, Criterion::constraint) <= choice.rounding;
}

/// The error by one criterion: the path's in its units, energy and period as fractions, constraints as a
/// length.
std::string error_by(Criterion criterion, const Candidate& candidate, const Choice& choice) {
  if (criterion == Criterion::path) return errors_of(candidate.errors, choice);
  const double own = own_error(candidate, criterion);
  if (!std::isfinite(own)) return "-";
  switch (criterion) {
    case Criterion::constraint:
      return is_held(candidate, choice) ? "held by construction" : off_constraint(own, choice);
    case Criterion::bounded:
      return own <= 1 ? "bounded" : "not bounded";
    default:
      return percent(own);
  }
}

/// The errors by all criteria asked for.
std::string error_of(const Candidate& candidate, const Choice& choice) {
  std::string text = error_by(choice.need.criterion, candidate, choice);
  for (const auto& [criterion, error] : choice.need.also)
    text += ", " + std::string(criterion_names[static_cast<std::size_t>(criterion)]) + " " +
            error_by(criterion, candidate, choice);
  return text;
}

std::string cost_of(const Candidate& candidate) {
  const std::string evaluations = format_significant(candidate.evaluations_per_frame, 3);
  return shown_time(candidate.seconds_per_frame) + " per frame (" + evaluations +
         (evaluations == "1" ? " evaluation)" : " evaluations)");
}

std::string failing_of(const Candidate& candidate, const Choice& choice) {
  return described(candidate, choice.need) + ", " + cost_of(candidate) + ": " +
         std::string(name_of(candidate.outcome)) +
         (std::isfinite(candidate.error) ? ", error " + error_of(candidate, choice) : "") + " at " +
         candidate.where + (candidate.why.empty() ? "" : ", as " + candidate.why);
}

/// "with its period right to 1 %".
std::string holds_by(Criterion criterion, const Choice& choice, const std::string& when) {
  switch (criterion) {
    case Criterion::path:
      return "within " + errors_of(choice.needs, choice) + " " + when;
    case Criterion::energy:
      return "with its energy right to " + percent(choice.need.error_by(criterion)) +
             " (relative to its moving part), " + when;
    case Criterion::period:
      return "with its period right to " + percent(choice.need.error_by(criterion));
    case Criterion::constraint:
      return "with its constraints off by " + off_constraint(choice.need.error_by(criterion), choice) +
             " at most, " + when;
    case Criterion::bounded:
      break;
  }
  return "bounded";
}

/// Warns if a criterion that ignores the path accepts one that is off by more than a tenth of the motion.
std::string strays_text(const Choice& choice) {
  constexpr double part = 0.1;
  const Criterion criterion = choice.need.criterion;
  if (criterion == Criterion::path || criterion == Criterion::bounded) return "";
  const std::vector<double>& errors = choice.chosen->errors;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (!(errors[i] <= part * choice.sizes[i]))
      return "By " + std::string(criterion_names[static_cast<std::size_t>(criterion)]) +
             " alone this motion holds, but its path is off by " + errors_of(errors, choice) +
             ", where the true one goes " + errors_of(choice.sizes, choice) +
             " from its start: ask for the path too, as in --error with --energy, --period or "
             "--constraint.\n";
  return "";
}

std::string listed(const std::vector<std::string>& all, const std::string& between = "; ") {
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : between) + one;
  return text;
}

std::size_t bytes_of_state(const Candidate& candidate) {
  return candidate.state_size * (candidate.precision == Precision::in_float ? sizeof(float) : sizeof(double));
}

/// How several bodies are computed.
std::string bodies_text(const Choice& choice) {
  if (choice.need.bodies == 1) return "";
  const Candidate& best = *choice.chosen;
  return "  " + std::to_string(choice.need.bodies) + " bodies: " +
         (choice.registers.empty() ? "one after the other, as lanes do not have this method"
                                   : "side by side in lanes of " + choice.registers) +
         ", " + shown_time(best.seconds_per_frame / static_cast<double>(choice.need.bodies)) + " and " +
         (best.state_size == 0 ? "no state" : std::to_string(bytes_of_state(best)) + " bytes of state") +
         " each.\n";
}

/// Whether a margin can be measured: not for bounded motions, nor for constraints that hold by construction.
bool is_measured(const Choice& choice) {
  return choice.need.criterion != Criterion::bounded &&
         (choice.need.criterion != Criterion::constraint || !choice.need.also.empty() ||
          !is_held(*choice.chosen, choice));
}

/// Result of the chosen method on other starts, where it need not hold.
std::string nearby_text(const Choice& choice) {
  const std::string others = std::to_string(choice.unseen.size()) + " others up to a tenth off";
  if (choice.failing_nearby == 0) return "; it holds on " + others + ", too";
  return "; of " + others + " it fails on " + std::to_string(choice.failing_nearby);
}

/// The rule that picked the chosen method.
std::string rule_text(const Choice& choice) {
  const bool simple = choice.need.objective == Objective::simple && choice.by_objective;
  return std::string("  rule: least time on this machine of ") +
         (simple ? "the closed forms and one-step methods of fixed step that hold with a margin of three"
                 : "all that hold") +
         (choice.seen.size() == 1 ? " on the start asked for" : " on all starts it is chosen on") +
         "; the most accurate of those within a quarter of it.\n";
}

/// Share of starts on which the method holds in chaos, where a margin on a few starts means little.
std::string share_text(const Choice& choice) {
  const auto [least, most] = choice.share_in_chaos();
  return "  in chaos: it holds on " + std::to_string(choice.holding_in_chaos) + " of " +
         std::to_string(choice.tried_in_chaos) +
         " starts up to a tenth off that it was not chosen on; of all such it holds on " +
         format_significant(100 * least, 2) + " to " + format_significant(100 * most, 2) +
         " % (confidence 95 %).\n";
}

std::string margin_text(const Choice& choice) {
  if (choice.tried_in_chaos > 0) return share_text(choice);
  const double unseen = choice.chosen->unseen_error;
  if (!is_measured(choice))
    return std::string("  margin: none is measured; on starts that it was not chosen on ") +
           (choice.need.criterion == Criterion::bounded ? "it is bounded, too.\n"
                                                        : "it holds by construction, too.\n");
  if (choice.need.starts < Need{}.starts)
    return "  margin: on " + std::string(choice.seen.size() == 1 ? "the start asked for" : "those starts") +
           " alone it is " + (unseen > 0 ? times_as(choice.margin()) + " better than asked" : "exact") +
           (choice.unseen.empty() ? "" : nearby_text(choice)) + ".\n";
  return "  margin: on starts that it was not chosen on it is " +
         (unseen > 0 ? times_as(choice.margin()) + " better than asked.\n" : "exact.\n");
}

std::string in_float_text(const Choice& choice) {
  if (choice.chosen->precision == Precision::in_float) return "";
  if (choice.need.kicks) return "";
  if (!choice.in_float) return "  in float: oddity has this method in double only.\n";
  const Candidate& single = *choice.in_float;
  if (single.holds()) return "  in float: error " + error_of(single, choice) + ", holds.\n";
  return "  in float: " + std::string(name_of(single.outcome)) +
         (std::isfinite(single.error) ? ", error " + error_of(single, choice) : "") + " at " + single.where +
         ": fails.\n";
}

/// Methods left out because they have no program in lockstep, by name if they are few.
std::string left_out_of_lockstep(const InLockstep& lockstep) {
  std::string text;
  for (const auto& [why, names] : lockstep.left_out)
    text += (text.empty() ? "  left out: any method that " : "; any that ") + why + " (" +
            (names.size() < 3 ? listed(names, ", ") : std::to_string(names.size()) + " algorithms") + ")";
  return text.empty() ? "" : text + ".\n";
}

/// How the program gets the same bits everywhere, and its cost.
std::string lockstep_text(const Choice& choice) {
  if (!choice.lockstep) return "";
  const InLockstep& lockstep = *choice.lockstep;
  return "  lockstep: its program has the same bits by every compiler and on every processor, of +, -, *, /, "
         "square roots" +
         (lockstep.functions.empty() ? "" : " and its own " + listed(lockstep.functions, ", ")) + "; " +
         (lockstep.times_usual ? "a frame takes " + times_as(*lockstep.times_usual) +
                                     " as long as in the usual program (" + lockstep.measured + ")"
                               : lockstep.measured) +
         ". It is judged by the usual functions, from which these differ by a few units in the last place.\n" +
         left_out_of_lockstep(lockstep);
}

std::string ties_text(const Choice& choice) {
  std::string text;
  std::set<std::string> seen;
  for (const Candidate& t : choice.ties) {
    const std::string one = described(t, choice.need);
    if (seen.insert(one).second)
      text += (text.empty() ? "  costs the same, within a quarter or the spread: " : "; ") + one + " (" +
              shown_time(t.seconds_per_frame) + ", error " + error_of(t, choice) + ")";
  }
  return text.empty() ? "" : text + ".\n";
}

/// Describes a method that holds on the requested start, but not on starts near it.
std::string on_asked_text(const Choice& choice) {
  if (!choice.on_asked || !choice.next_to_asked) return "";
  const Candidate &there = *choice.on_asked, &beside = *choice.next_to_asked;
  return "  on the start asked for " + described(there, choice.need) + ", " + cost_of(there) +
         ", holds: error " + error_of(there, choice) +
         ". A choice has to hold on nearby starts, too, and this one is " +
         std::string(name_of(beside.outcome)) + " at " + beside.where +
         (std::isfinite(beside.error) ? ": error " + error_of(beside, choice) : "") + ".\n";
}

/// Frames that a rollback game typically computes again when inputs arrive late.
constexpr int frames_again = 8;

/// Seconds to compute these frames with the chosen method from a saved state.
double rollback_seconds(const Choice& choice) {
  const Candidate& best = *choice.chosen;
  const double restart = best.evaluations_per_frame > 0
                             ? choice.restart / best.evaluations_per_frame
                             : 0;  // only methods with a history have a cost to restart
  return best.seconds_per_frame * (best.state_size == 0 ? 1 : frames_again + restart);
}

std::string rollback_text(const Choice& choice) {
  const Candidate& best = *choice.chosen;
  if (best.state_size == 0)
    return "  rollback: there is no state to save, and any frame is computed at once.\n";
  const auto bytes = bytes_of_state(best) * static_cast<std::size_t>(choice.need.bodies);
  return "  rollback: " + std::to_string(bytes) + " bytes of state to save; from there " +
         std::to_string(frames_again) + " frames again take " + shown_time(rollback_seconds(choice)) + ".\n";
}

bool is_faulted(const Candidate& t, const Choice& choice) {
  return std::ranges::find(choice.faulted, t.model) != choice.faulted.end();
}

/// A method that would meet the need, but whose model is shown to be wrong.
std::string faulted_text(const Choice& choice) {
  for (const Candidate& t : choice.candidates)
    if (t.holds() && is_faulted(t, choice) && !(t.seconds_per_frame > choice.need.budget))
      return "  " + described(t, choice.need) + " holds here, but the scene's page shows that it is wrong.\n";
  return "";
}

std::string miss_text(const Choice& choice, const Screen& screen) {
  const std::string text =
      screen.styled(Style::bad, "Nothing here meets that.") + "\n" + faulted_text(choice);
  if (!choice.nearest_miss) return text;
  const Candidate& miss = *choice.nearest_miss;
  const double budgets = miss.seconds_per_frame / choice.need.budget;
  if (!miss.holds())
    return text + "  nearest miss: " + failing_of(miss, choice) + ".\n" + on_asked_text(choice);
  if (!(budgets > 1)) return text + on_asked_text(choice);
  return text + "  nearest miss: " + described(miss, choice.need) + " is as accurate, but costs " +
         cost_of(miss) + ", " + times_as(budgets) + " the budget.\n" + on_asked_text(choice);
}

/// The next cheaper method tried, and why it was rejected.
std::string next_cheaper_text(const Choice& choice) {
  if (!choice.next_cheaper) return "";
  const Candidate& t = *choice.next_cheaper;
  const std::string text = "  the next cheaper one that was tried: ";
  if (!t.holds()) return text + failing_of(t, choice) + ".\n";
  if (is_faulted(t, choice))
    return text + described(t, choice.need) + ", " + cost_of(t) +
           ": holds here, but the scene's page shows that it is wrong.\n";
  const bool closely = t.error * choice.need.margin() > 1;
  return text + described(t, choice.need) + ", " + cost_of(t) + ": holds, " +
         (closely ? "but with a margin of " + format_significant(1 / t.error, 2) + " instead of " +
                        format_shortest(choice.need.margin())
                  : "but is no one-step method of fixed step and no closed form") +
         ", error " + error_of(t, choice) + ".\n";
}

/// Whether even long double loses the chaotic path.
bool is_beyond_double(const Choice& choice) { return choice.explanation.truth_until && choice.predictable; }

/// Why some methods were not tried at finer settings.
std::string_view why_left(const Choice& choice) {
  return is_beyond_double(choice) ? "as none can hold" : "as they cost too much already";
}

/// Describes the table's rows.
std::string rows_text(const Choice& choice) {
  std::string text = "\nEach method at its cheapest setting that holds";
  if (choice.need.margin() > 1) text += " with a margin of three, else at its cheapest that holds";
  text += ", else at the best that was tried; the error of a failing method is that on the start named";
  if (choice.left.empty()) return text + ":\n";
  return text + "; not all are followed to finer settings, " + std::string(why_left(choice)) + ":\n";
}

std::string unknown_text(const Choice& choice) {
  const std::optional<double>& until = choice.explanation.truth_until;
  if (!until) return "";
  const std::string known =
      "  the true motion is known up to " + format_significant(*until, 3) + " " + choice.time_unit;
  if (!is_beyond_double(choice))
    return known + ": errors of methods that fail earlier are measured up to that time.\n";
  return known +
         ": there even long double loses it, whose roundings are 2,048 times smaller than double's. Errors are "
         "measured up to that time.\n";
}

std::string chaos_text(const Choice& choice) {
  if (!choice.predictable) return "";
  const std::string until = std::isfinite(*choice.predictable)
                                ? "is off by the error asked for after " +
                                      format_significant(*choice.predictable, 3) + " " + choice.time_unit
                                : "is still within the error asked for at the end";
  return "  the motion is chaotic: one from a start that differs by a thousand-millionth " + until +
         ". A game may do better to ask for --criterion energy or bounded.\n";
}

std::string engine_text(const Choice& choice) {
  if (choice.engine.empty())
    return "As an engine does today: no model of this scene is one that semi-implicit Euler fits.\n";
  std::string text =
      "As an engine does today, semi-implicit Euler on the model \"" + choice.engine.front().model + "\":\n";
  for (const Candidate& t : choice.engine)
    text += "  at " + format_significant(1 / t.setting, 4) + " Hz: error " + error_of(t, choice) +
            (t.holds() ? ", holds\n" : ", " + std::string(name_of(t.outcome)) + "\n");
  return text;
}

std::string verdict_of(const Candidate& candidate, const Choice& choice) {
  if (choice.chosen && candidate.model == choice.chosen->model &&
      candidate.algorithm == choice.chosen->algorithm)
    return "chosen";
  if (!candidate.holds())
    return std::string(name_of(candidate.outcome)) + " at " + candidate.where +
           (candidate.why.empty() ? "" : ": " + candidate.why) +
           (choice.was_followed(candidate) ? "" : "; not followed");
  if (is_faulted(candidate, choice)) return "holds here; its page shows it wrong";
  return candidate.seconds_per_frame > choice.need.budget ? "over the budget" : "holds";
}

/// Starts that were drawn but are not comparable.
std::string left_out_text(const Choice& choice) {
  std::string text;
  for (const auto& [kind, count] : choice.left_out)
    text += "\nleft out: " + std::to_string(count) + (count == 1 ? " start" : " starts") +
            " nearby whose motion is " + kind + ", unlike that of the start asked for";
  return text;
}

/// The most useful rows: first methods that hold, with the chosen one among them.
std::vector<Candidate> rows_of(const Choice& choice, bool all_rows) {
  if (all_rows) return choice.candidates;
  std::vector<Candidate> rows;
  for (const Candidate& t : choice.candidates)
    if (t.holds() && rows.size() < first_rows) rows.push_back(t);
  const auto is_chosen = [&](const Candidate& t) { return verdict_of(t, choice) == "chosen"; };
  if (choice.chosen && std::ranges::none_of(rows, is_chosen))
    rows.back() = *std::ranges::find_if(choice.candidates, is_chosen);
  for (const Candidate& t : choice.candidates)
    if (!t.holds() && rows.size() < first_rows) rows.push_back(t);
  return rows;
}

Json from(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

/// Errors in the need's units: a number if there is one unit, otherwise an object by unit.
Json from(const std::vector<double>& errors, const Choice& choice) {
  Json json = Json::object();
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const ShownUnit unit = shown_unit(choice.units[i], choice);
    json[unit.symbol] = from(errors[i] / unit.size);
  }
  return json.size() == 1 ? json.begin().value() : json;
}

Json units_of(const Choice& choice) {
  Json json = Json::array();
  for (const std::string& unit : choice.units) json.push_back(shown_unit(unit, choice).symbol);
  return json;
}

Json base_of(const Candidate& t, const Choice& choice) {
  return {
      {"model", t.model},
      {"algorithm", t.algorithm},
      {"precision", name_of(t.precision)},
      {"setting", shown_setting(t, choice.need)},
      {t.resolution.empty() ? "value" : t.resolution, t.resolution.empty() ? Json(nullptr) : Json(t.setting)},
      {"error", from(t.errors, choice)},
      {"error_in_needs", from(t.error)},
      {"holds", t.holds()},
      {"outcome", name_of(t.outcome)},
      {"evaluations_per_frame", t.evaluations_per_frame},
      {"state_bytes", bytes_of_state(t)},
      {"seconds_per_frame", from(t.seconds_per_frame)},
      {"spread", from(t.spread)}};
}

/// Errors by criteria other than the path are fractions, or lengths in m.
Json from(const Candidate& t, const Choice& choice) {
  const Criterion criterion = choice.need.criterion;
  Json json = base_of(t, choice);
  if (criterion != Criterion::path) {
    json["error"] = from(own_error(t, criterion));
    json["path"] = from(t.errors, choice);
  }
  for (const auto& [also, error] : choice.need.also)
    json["also"][criterion_names[static_cast<std::size_t>(also)]] = from(own_error(t, also));
  if (!t.why.empty()) json["why"] = t.why;
  return json;
}

Json from(const std::vector<Candidate>& all, const Choice& choice) {
  Json json = Json::array();
  for (const Candidate& t : all) json.push_back(from(t, choice));
  return json;
}

Json need_of(const Choice& choice) {
  static constexpr const char* criteria[] = {"path", "energy", "period", "bounded", "constraint"};
  const Json error =
      choice.need.criterion == Criterion::path ? from(choice.needs, choice) : from(choice.need.error);
  Json also = Json::object();
  for (const auto& [criterion, asked] : choice.need.also)
    also[criterion_names[static_cast<std::size_t>(criterion)]] = asked;
  return {{"exercise", choice.exercise},
          {"criterion", criteria[static_cast<int>(choice.need.criterion)]},
          {"error", error},
          {"also", also},
          {"unit", choice.need.criterion == Criterion::constraint ? Json("m") : units_of(choice)},
          {"horizon", choice.asked_horizon.value_or(choice.need.horizon)},
          {"judged_over", choice.need.horizon},
          {"frames", choice.need.frames()},
          {"time_unit", choice.time_unit},
          {"frames_per_second", choice.need.frames_per_second},
          {"frame_lengths", choice.need.frame_times ? Json(choice.need.frame_times->says) : Json()},
          {"kicks", choice.need.kicks ? Json(choice.need.kicked) : Json()},
          {"budget", from(choice.need.budget)},
          {"bodies", choice.need.bodies},
          {"restart_every", from(choice.need.restart_every)},
          {"objective", choice.need.objective == Objective::simple ? "simple" : "cheapest"}};
}

Json lockstep_json(const Choice& choice) {
  if (!choice.lockstep) return nullptr;
  const InLockstep& lockstep = *choice.lockstep;
  return {{"functions", lockstep.functions},
          {"times_usual", lockstep.times_usual ? Json(*lockstep.times_usual) : Json(nullptr)},
          {"measured", lockstep.measured},
          {"left_out", lockstep.left_out}};
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string what_holds(const Choice& choice, const std::string& when) {
  std::string text = choice.quantity + " " + holds_by(choice.need.criterion, choice, when);
  for (const auto& [criterion, error] : choice.need.also) text += "; " + holds_by(criterion, choice, when);
  return text;
}

std::string asked_text(const Choice& choice) {
  const Need& need = choice.need;
  return what_holds(choice) + ", over " + shown_span(choice.need, choice.time_unit) +
         (need.bodies == 1 ? "" : ", " + std::to_string(need.bodies) + " bodies") +
         (std::isfinite(need.restart_every)
              ? ", restarted every " + format_shortest(need.restart_every) + " " + choice.time_unit
              : "") +
         (std::isfinite(need.budget) ? ", for at most " + shown_time(need.budget) + " per frame" : "");
}

std::string part_text(const Choice& choice) {
  if (!choice.asked_horizon) return "";
  const auto time = [&](double t) { return format_significant(t, 6) + " " + choice.time_unit; };
  const std::string first = time(choice.need.horizon), all = time(*choice.asked_horizon);
  if (choice.is_decided_by_part)
    return "Over the first " + first + " of " + all + " nothing holds, and so nothing does over all of it.\n";
  return "This is judged over the first " + first + " of " + all +
         ": the time limit left no more. --time-limit allows more.\n";
}

std::string answer_text(const Choice& choice, const Screen& screen) {
  const Candidate& best = *choice.chosen;
  std::string text = strays_text(choice) + "Take " +
                     screen.styled(Style::heading, described(best, choice.need)) + ": " + cost_of(best);
  if (std::isfinite(choice.need.budget))
    text += ", " + percent(best.seconds_per_frame / choice.need.budget) + " of the budget";
  text += ".\n" + rule_text(choice) + bodies_text(choice) + margin_text(choice) + lockstep_text(choice) +
          in_float_text(choice) + ties_text(choice);
  if (!choice.by_objective)
    text +=
        "  no one-step method of fixed step and no closed form holds with a margin of three: this is the "
        "cheapest "
        "that holds.\n";
  if (choice.restart > 0.5)
    text += "  every restart, as after a contact, costs it " + format_significant(choice.restart, 3) +
            " evaluations more" +
            (std::isfinite(choice.need.restart_every) ? ", which its time includes" : "") + ".\n";
  text += next_cheaper_text(choice);
  if (const auto& richer = choice.next_richer)
    text += "  next richer: " + described(*richer, choice.need) + ", " + cost_of(*richer) + ": " +
            times_as(richer->seconds_per_frame / best.seconds_per_frame) + " the cost, error " +
            error_of(*richer, choice) + ".\n";
  return text + rollback_text(choice);
}

std::string choice_text(const Choice& choice, bool all_rows, const Screen& screen) {
  const std::vector<Candidate> shown_rows = rows_of(choice, all_rows);
  std::vector<std::vector<std::string>> rows{
      {"model", "algorithm", "setting", "error", "evaluations per frame", "time per frame", ""}};
  for (const Candidate& candidate : shown_rows)
    rows.push_back(
        {candidate.model, candidate.algorithm, shown_setting(candidate, choice.need),
         error_of(candidate, choice), format_significant(candidate.evaluations_per_frame, 3),
         shown_time(candidate.seconds_per_frame),
         screen.styled(candidate.holds() ? Style::good : Style::bad, verdict_of(candidate, choice))});
  const std::size_t hidden = choice.candidates.size() - shown_rows.size();
  const std::string answer = choice.chosen ? answer_text(choice, screen) : miss_text(choice, screen);
  const std::string grounds = engine_text(choice) + "\nchosen on: " + listed(choice.seen) +
                              left_out_text(choice) +
                              (choice.unseen.empty() ? "" : "\ntested on: " + listed(choice.unseen)) +
                              (choice.prices_are.empty() ? "" : "\ntimes: " + choice.prices_are) + "\n";
  return wrapped(asked_text(choice) + "\n" + part_text(choice) + "\n" + answer + chaos_text(choice) +
                     unknown_text(choice) + rows_text(choice),
                 screen, 4) +
         aligned(
             rows, screen,
             {{"model", "algorithm", ""}, {"evaluations per frame", "setting", "error", "time per frame"}}) +
         (hidden > 0 ? "  and " + std::to_string(hidden) + " more: --all\n" : "") + "\n" +
         wrapped(grounds, screen, 4);
}

std::string truth_text(const Choice& choice, const Screen& screen) {
  const Explanation& e = choice.explanation;
  return wrapped("truth: known to the requested error times " + format_significant(e.truth_error, 2) + "; " +
                     e.truth_by + "\n",
                 screen, 4);
}

std::string explanation_text(const Choice& choice) {
  const Explanation& e = choice.explanation;
  const auto part = [](const std::string& name, double seconds, const std::string& what) {
    return "  " + name + ": " + shown_time(seconds) + "; " + what + ".\n";
  };
  const auto counted = [](long count, const std::string& one) {
    return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
  };
  const Criterion criterion = choice.need.criterion;
  const bool is_of_the_motion = criterion == Criterion::path || criterion == Criterion::period;
  return "How it was found, in " + shown_time(e.truths + e.search + e.timing + e.tests + e.rest) + ":\n" +
         part("true motions", e.truths,
              counted(e.starts, "start") +
                  (is_of_the_motion
                       ? ", known to the requested error times " + format_significant(e.truth_error, 2)
                       : "") +
                  ": " + e.truth_by) +
         part("search", e.search,
              counted(e.methods, "method") + " at " + counted(e.settings, "setting") + ", " +
                  counted(e.evaluations, "evaluation") + " on the start asked for; " +
                  std::to_string(e.left) + " not followed to finer settings, " +
                  std::string(why_left(choice))) +
         part("times", e.timing, counted(e.timed, "method") + " and settings, " + choice.prices_are) +
         part("tests on other starts", e.tests, counted(e.rounds, "round")) +
         part("comparisons", e.rest, "an engine's step, float, restarts, chaos");
}

std::string shown_errors(const Candidate& candidate, const Choice& choice) {
  return error_of(candidate, choice);
}

std::string choice_json(const Choice& choice, const std::string& engines) {
  Json json{{"need", need_of(choice)}, {"chosen", nullptr}};
  if (choice.chosen) {
    json["chosen"] = from(*choice.chosen, choice);
    json["chosen"]["margin"] = is_measured(choice) ? from(choice.margin()) : Json(nullptr);
    json["chosen"]["restart_evaluations"] = choice.restart;
    json["chosen"]["by_objective"] = choice.by_objective;
    json["chosen"]["rollback"] = {{"frames", frames_again}, {"seconds", from(rollback_seconds(choice))}};
    json["chosen"]["lanes"] = choice.registers.empty() ? Json(nullptr) : Json(choice.registers);
  }
  json["in_float"] = choice.in_float ? from(*choice.in_float, choice) : Json(nullptr);
  json["ties"] = from(choice.ties, choice);
  json["candidates"] = from(choice.candidates, choice);
  for (std::size_t i = 0; i < choice.candidates.size(); ++i)
    json["candidates"][i]["followed"] = choice.was_followed(choice.candidates[i]);
  json["on_asked"] = choice.on_asked ? from(*choice.on_asked, choice) : Json(nullptr);
  json["engine"] = from(choice.engine, choice);
  json["predictable"] = choice.predictable ? from(*choice.predictable) : Json(nullptr);
  json["chosen_on"] = choice.seen;
  json["tested_on"] = choice.unseen;
  json["failing_nearby"] = choice.failing_nearby;
  json["left_out"] = choice.left_out;
  if (choice.tried_in_chaos > 0)
    json["in_chaos"] = {{"tried", choice.tried_in_chaos},
                        {"holding", choice.holding_in_chaos},
                        {"least", choice.share_in_chaos().first},
                        {"most", choice.share_in_chaos().second}};
  json["lockstep"] = lockstep_json(choice);
  if (!engines.empty()) json["engines"] = Json::parse(engines);
  json["times"] = choice.prices_are;
  const Explanation& e = choice.explanation;
  json["explanation"] = {{"truths",
                          {{"seconds", e.truths},
                           {"starts", e.starts},
                           {"error_in_needs", from(e.truth_error)},
                           {"until", e.truth_until ? from(*e.truth_until) : Json(nullptr)},
                           {"by", e.truth_by}}},
                         {"search",
                          {{"seconds", e.search},
                           {"methods", e.methods},
                           {"settings", e.settings},
                           {"evaluations", e.evaluations},
                           {"left", e.left}}},
                         {"times", {{"seconds", e.timing}, {"timed", e.timed}}},
                         {"tests", {{"seconds", e.tests}, {"rounds", e.rounds}}},
                         {"rest", {{"seconds", e.rest}}}};
  return json.dump(2) + "\n";
}

std::string choice_csv(const Choice& choice) {
  std::string text = "model,algorithm,precision,setting";
  const Criterion asked = choice.need.criterion;
  const auto column = [&](const std::string& name, Criterion criterion) {
    const bool is_length = criterion == Criterion::constraint;
    return "," + name + " [" + (is_length ? length_unit(choice).symbol : "1") + "]";
  };
  if (asked != Criterion::path) text += column("error", asked);
  for (const std::string& unit : choice.units)
    text += (asked == Criterion::path ? ",error [" : ",path [") + shown_unit(unit, choice).symbol + "]";
  for (const auto& [criterion, error] : choice.need.also)
    text += column(criterion_names[static_cast<std::size_t>(criterion)], criterion);
  text += ",holds,outcome,evaluations per frame,seconds per frame,chosen\n";
  for (const Candidate& t : choice.candidates) {
    text += csv_cell(t.model) + "," + csv_cell(t.algorithm) + "," + std::string(name_of(t.precision)) + "," +
            csv_cell(shown_setting(t, choice.need));
    const auto cell = [&](Criterion criterion) {
      const double size = criterion == Criterion::constraint ? length_unit(choice).size : 1;
      return "," + format_shortest(own_error(t, criterion) / size);
    };
    if (asked != Criterion::path) text += cell(asked);
    for (std::size_t i = 0; i < t.errors.size(); ++i)
      text += "," + format_shortest(t.errors[i] / shown_unit(choice.units[i], choice).size);
    for (const auto& [criterion, error] : choice.need.also) text += cell(criterion);
    text += std::string(t.holds() ? ",1," : ",0,") + std::string(name_of(t.outcome)) + "," +
            format_shortest(t.evaluations_per_frame) + "," + format_shortest(t.seconds_per_frame) +
            (verdict_of(t, choice) == "chosen" ? ",1\n" : ",0\n");
  }
  return text;
}

}  // namespace oddity
