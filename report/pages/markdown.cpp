#include "report/pages/markdown.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>
#include <utility>

#include "reference/text.hpp"
#include "report/pages/markup.hpp"
#include "report/pages/readable.hpp"
#include "report/pages/text_view.hpp"

namespace oddity {

namespace {

// ---- counting ---------------------------------------------------------------------------------------------

using Counts = std::map<Verdict, int>;
constexpr std::array verdicts{Verdict::confirmed, Verdict::misprint, Verdict::erratum, Verdict::not_checkable,
                              Verdict::unsettled};

void count(const ExerciseResult& e, Counts& counts) {
  for (const JudgedClaim& c : e.claims) ++counts[c.verdict];
}

std::string plural(int n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string sentence(Counts counts) {
  return std::to_string(counts[Verdict::confirmed]) + " confirmed, " +
         plural(counts[Verdict::misprint], "misprint", "misprints") + ", " +
         plural(counts[Verdict::erratum], "erratum", "errata") + ", " +
         std::to_string(counts[Verdict::not_checkable]) + " not checkable, " +
         std::to_string(counts[Verdict::unsettled]) + " unsettled";
}

std::vector<const ExerciseResult*> of_chapter(const Results& results, int chapter) {
  std::vector<const ExerciseResult*> found;
  for (const ExerciseResult& e : results.exercises)
    if (e.number.chapter == chapter) found.push_back(&e);
  return found;
}

bool has_page(const Results& results, const Chapter& chapter) {
  return chapter.last_odd > 0 || !of_chapter(results, chapter.number).empty();
}

std::string own_mark(Number number) { return of_the_book(number) ? "" : " (own)"; }

std::vector<Number> not_encoded(const Chapter& chapter) {
  std::vector<Number> missing;
  for (int index = 1; index <= chapter.last_odd; index += 2) {
    const Number number{chapter.number, index};
    if (std::ranges::none_of(registry(), [&](const Entry& e) { return e.number == number; }))
      missing.push_back(number);
  }
  return missing;
}

std::string listed(const std::vector<Number>& numbers) {
  std::string text;
  for (Number n : numbers) text += (text.empty() ? "" : ", ") + to_string(n);
  return text;
}

/// GitHub's anchor of an exercise's heading.
std::string anchor(const ExerciseResult& e) {
  std::string text;
  for (char c : to_string(e.number) + " " + e.title) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ' || c == '-')
      text += '-';
    else if (c == '_' || static_cast<unsigned char>(c) >= 0x80)
      text += c;
  }
  return text;
}

// ---- claims -----------------------------------------------------------------------------------------------

const Reading& deciding(const JudgedClaim& judged) {
  switch (judged.verdict) {
    case Verdict::misprint:
      return judged.claim.meant;
    case Verdict::erratum:
      return judged.claim.corrected;
    default:
      return judged.claim.printed;
  }
}

/// Of a claim that holds for every sample or fails: `left` counts the samples that violate it.
bool counts_violations(const Check& c) {
  return c.right.by == "none" && c.left.by.starts_with("violations in ");
}

double scale_of(const Check& c) {
  return c.scale > 0 ? c.scale : std::max(size_of(c.left.value), size_of(c.right.value));
}

std::string difference_of(const Check& c) {
  const double difference = c.difference();
  if (c.tolerance.allowed == 0) return difference == 0 ? "equal" : "differ by " + shown_error(difference);
  const std::string scale = scale_of(c) > 0 ? " at a scale of " + rounded(scale_of(c), 3) : "";
  return (std::isfinite(difference) ? "differ by " + shown_error(difference) + scale : "cannot be compared") +
         ", allowed " + shown_error(c.tolerance.allowed);
}

/// "no violations in 200 samples", "1 violation in 200 samples".
std::string violations(const Check& c) {
  const std::string n = c.left.value[0] == 0 ? "no" : rounded(c.left.value[0], 12);
  return n + (n == "1" ? " violation" : " violations") + c.left.by.substr(std::string("violations").size());
}

/// What was compared with what, and how the comparison ended.
std::string comparison(const Check& c) {
  if (counts_violations(c)) return c.quantity + ": " + violations(c);
  return c.quantity + ": " + c.left.by + " against " + c.right.by + ": " + difference_of(c);
}

/// How much of its tolerance a check uses up; one that fails comes before all that hold.
double tightness(const Check& c) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double used = c.tolerance.allowed > 0 ? c.difference() / c.tolerance.allowed : 0;
  return c.holds() ? std::min(used, 1.0) : std::isfinite(used) && used > 1 ? used : infinity;
}

const Check& tightest(const Reading& reading) {
  return *std::ranges::max_element(reading.checks, {}, tightness);
}

/// The numbers behind a verdict in a few words: what holds, or by how much the print is off.
std::string evidence(const JudgedClaim& judged) {
  if (judged.verdict == Verdict::not_checkable) return escaped(judged.claim.not_checkable);
  const Reading& printed = judged.claim.printed;
  const Reading& shown_reading = printed.checks.empty() ? deciding(judged) : printed;
  if (shown_reading.checks.empty()) return "";
  std::string text = with_powers(escaped(with_short_numbers(comparison(tightest(shown_reading)))));
  if (shown_reading.checks.size() > 1)
    text += " (tightest of " + std::to_string(shown_reading.checks.size()) + " checks)";
  return text;
}

std::vector<std::string> check_row(const std::string& reading, const Check& c) {
  const auto words = [](const std::string& text) { return with_powers(escaped(with_short_numbers(text))); };
  const std::string compared = words(c.quantity) + (c.where.empty() ? "" : "<br>" + words(c.where));
  if (counts_violations(c)) return {reading, compared, violations(c), "none allowed", "", ""};
  return {reading,
          compared,
          value_cell(c.left.value, 7) + "<br>" + words(c.left.by),
          value_cell(c.right.value, 7) + "<br>" + words(c.right.by),
          error_cell(c.difference()),
          error_cell(c.tolerance.allowed) + "<br>" + words(c.tolerance.reason)};
}

/// Where the links to a claim lead: its id, but for what an anchor cannot hold.
std::string anchor_of(const Claim& claim) {
  std::string anchor;
  for (char c : claim.id)
    anchor += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_' ? c : '-';
  return anchor;
}

std::string claim_anchor(const Claim& claim) { return "<a id=\"" + anchor_of(claim) + "\"></a>"; }

/// What is wrong, what is right, and how it shows.
std::string finding(const JudgedClaim& judged) {
  const Claim& claim = judged.claim;
  const std::string kind = judged.verdict == Verdict::erratum    ? "Erratum"
                           : judged.verdict == Verdict::misprint ? "Misprint"
                                                                 : "Unsettled";
  const std::string fault = claim.kind == Fault::none ? "" : ", " + std::string(name_of(claim.kind));
  std::string text = claim_anchor(claim) + "\n\n**" + kind + " " + code(claim.id) + "**" + fault + ", line " +
                     std::to_string(claim.line) + ". *The solution says:* " + escaped(claim.says, false) +
                     ".\n\n" + prose(claim.why) + "\n\n";
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& name, const Reading& reading) {
    const bool told = claim.says.find(reading.text) != std::string::npos;
    if (!reading.checks.empty())
      rows.push_back(check_row(told ? name : name + ": " + escaped(reading.text), tightest(reading)));
  };
  add("printed", claim.printed);
  add("meant", claim.meant);
  add("corrected", claim.corrected);
  return text + table({"reading", "compared", "one route", "another", "differ by", "allowed"}, rows);
}

/// What is wrong in full; what is confirmed, folded up.
std::string claims_text(const ExerciseResult& e) {
  std::string text;
  for (Verdict verdict : {Verdict::erratum, Verdict::misprint, Verdict::unsettled})
    for (const JudgedClaim& c : e.claims)
      if (c.verdict == verdict) text += finding(c);
  std::vector<std::vector<std::string>> rows;
  for (const JudgedClaim& c : e.claims)
    if (c.verdict == Verdict::confirmed)
      rows.push_back({code(c.claim.id), std::to_string(c.claim.line), escaped(c.claim.says), evidence(c)});
  if (rows.empty()) return text;
  return text + "<details><summary>" +
         plural(static_cast<int>(rows.size()), "confirmed claim", "confirmed claims") + "</summary>\n\n" +
         table({"claim", "line", "the solution says", "evidence"}, rows, "1") + "</details>\n\n";
}

// ---- methods ----------------------------------------------------------------------------------------------

/// The cheapest trial that is ok, or none.
const TimedTrial* cheapest_ok(const MethodResult& m) {
  const TimedTrial* best = nullptr;
  for (const TimedTrial& t : m.trials)
    if (t.outcome == Outcome::ok && (!best || t.evaluations < best->evaluations)) best = &t;
  return best;
}

/// Why methods are expected to fail, those with the same reason together.
std::string expected_failures(const QuantityResult& q) {
  std::vector<std::pair<std::string, std::string>> reasons;
  for (const MethodResult& m : q.methods) {
    if (m.why.empty() || m.expected == Outcome::ok) continue;
    const std::string reason = "*" + std::string(name_of(m.expected)) + "*: " + escaped(m.why, false);
    const std::string name = escaped(m.model + ", " + m.algorithm, false);
    const auto same = std::ranges::find(reasons, reason, &std::pair<std::string, std::string>::first);
    if (same == reasons.end())
      reasons.emplace_back(reason, name);
    else
      same->second += "; " + name;
  }
  std::string text;
  for (const auto& [reason, names] : reasons) text += "- " + names + " - " + reason + ".\n";
  return text.empty() ? "" : "Expected to fail at the finest setting:\n\n" + text + "\n";
}

std::string methods_table(const QuantityResult& q) {
  std::vector<std::vector<std::string>> rows;
  for (const MethodResult& m : q.methods) {
    const TimedTrial* ok = cheapest_ok(m);
    const TimedTrial& finest = m.trials.back();
    const std::string outcome(name_of(finest.outcome));
    rows.push_back(
        {escaped(m.model), escaped(m.algorithm), ok ? knob_cell(*ok) : "never",
         ok ? std::to_string(ok->evaluations) : "", ok ? error_cell(ok->error) : "", knob_cell(finest),
         std::to_string(finest.evaluations), error_cell(finest.error), escaped(shown_fit(m, fit(q, m))),
         m.as_expected() ? outcome
                         : "**" + outcome + "** (expected " + std::string(name_of(m.expected)) + ")"});
  }
  return table({"model", "algorithm", "cheapest that is ok", "evaluations", "error", "finest tried",
                "evaluations", "error", "fit", "outcome"},
               rows, "3467") +
         expected_failures(q);
}

std::string breakdown_text(const BreakdownResult& b) {
  const auto row = [](const std::string& what, const TimedTrial& t) {
    return std::vector<std::string>{what,
                                    escaped(t.model + ", " + t.algorithm),
                                    knob_cell(t),
                                    value_cell(t.value, 7),
                                    error_cell(t.error),
                                    std::to_string(t.evaluations),
                                    std::string(name_of(t.outcome))};
  };
  return "**Where it breaks.** " + prose(b.says) + "\n\n" +
         table({"", "method", "knob", "value", "error", "evaluations", "outcome"},
               {row("breaks", b.broken), row("cure", b.cured)}, "45");
}

/// The trial in float with the least error of all that the model's algorithms have, and the like one in
/// double.
struct LeastInFloat {
  const TimedTrial *in_float, *in_double;
};

std::vector<LeastInFloat> least_in_float(const QuantityResult& q) {
  std::vector<LeastInFloat> least;
  for (const FloatResult& m : q.in_float)
    for (std::size_t i = 0; i < m.trials.size(); ++i) {
      const TimedTrial& t = m.trials[i];
      if (!std::isfinite(t.error)) continue;
      if (least.empty() || least.back().in_float->model != t.model)
        least.push_back({&t, &q.methods[m.in_double].trials[i]});
      else if (t.error < least.back().in_float->error)
        least.back() = {&t, &q.methods[m.in_double].trials[i]};
    }
  return least;
}

/// How many settings hold in double, and how many of these do not in float.
std::string lost_in_float(const QuantityResult& q) {
  int held = 0, lost = 0;
  for (const FloatResult& m : q.in_float)
    for (std::size_t i = 0; i < m.trials.size(); ++i) {
      if (q.methods[m.in_double].trials[i].outcome != Outcome::ok) continue;
      ++held;
      lost += m.trials[i].outcome != Outcome::ok;
    }
  if (held == 0) return "None of these methods is within the need in double.";
  const std::string all = plural(held, "setting", "settings") + " within the need in double";
  return lost == 0 ? "Of " + all + ", none is outside it in float."
                   : "Of " + all + ", " + std::to_string(lost) + (lost == 1 ? " is" : " are") +
                         " outside it in float.";
}

/// Where float's floor lies.
std::string in_float_text(const QuantityResult& q) {
  if (q.in_float.empty()) return "";
  std::vector<std::vector<std::string>> rows;
  for (const auto& [single, like] : least_in_float(q)) {
    const bool ok = single->outcome == Outcome::ok;
    rows.push_back({escaped(single->model), escaped(like->algorithm), error_cell(single->error),
                    knob_cell(*single), error_cell(like->error),
                    ok ? "yes" : std::string(name_of(single->outcome)),
                    !q.trajectory                          ? ""
                    : single->error <= q.trajectory->close ? "yes"
                                                           : "no"});
  }
  return "**In float**, as games compute, the least error that each model reaches, and what double errs by at "
         "the same setting. " +
         lost_in_float(q) + "\n\n" +
         table({"model", "algorithm", "least error in float", "at", "error in double", "within the need",
                "enough for a game"},
               rows, "24");
}

std::string picture_file(const ExerciseResult& e, const QuantityResult& q, const std::string& kind) {
  return "charts/" + to_string(e.number) + "_" + file_name(q.name) + kind + ".svg";
}

std::string trajectory_link(const ExerciseResult& e, const QuantityResult& q) {
  return q.trajectory ? "![" + escaped(q.name, false) + ": the motion](" + trajectory_file(e, q) + ")\n\n"
                      : "";
}

std::string shown_axis(const QuantityResult& q, Across across) {
  return across == Across::time          ? "time"
         : across == Across::evaluations ? "evaluations"
         : q.trajectory                  ? "step"
                                         : "setting";
}

/// The charts of a quantity, but for those over time or those alone.
std::string chart_links(const ExerciseResult& e, const QuantityResult& q, bool by_time) {
  std::string text;
  for (Across across : charts_of(q))
    if ((across == Across::time) == by_time)
      text += "![" + escaped(q.name, false) + ": error against " + shown_axis(q, across) + "](" +
              chart_file(e, q, across) + ")\n\n";
  return text;
}

/// Beneath the last of a series, its chart.
std::string series_link(const ExerciseResult& e, const QuantityResult& q) {
  for (const auto& series : series_of(e))
    if (series.back() == &q) return "![work over size](" + series_file(e, *series.front()) + ")\n\n";
  return "";
}

/// What is computed, its true value and how well it is needed.
std::string quantity_head(const QuantityResult& q) {
  return "### " + code(q.name) + ": " + escaped(q.says, false) +
         "\n\nReference: " + value_cell(q.reference.value, 16) +
         (q.unit == "1" ? "" : " " + escaped(q.unit, false)) + ", known to " + error_cell(q.reference_error) +
         " (" + escaped(q.reference.by, false) + "). Needed to " + error_cell(q.need.allowed) + ": " +
         escaped(q.need.reason, false) + (q.samples > 1 ? "; " + instants(q) : "") + ".\n\n";
}

std::string quantity_text(const ExerciseResult& e, const QuantityResult& q, bool charts) {
  std::string text = quantity_head(q);
  if (charts) text += trajectory_link(e, q) + chart_links(e, q, false) + series_link(e, q);
  text += methods_table(q) + in_float_text(q);
  for (const BreakdownResult& b : q.breakdowns) text += breakdown_text(b);
  return text;
}

std::string parameters_text(const ExerciseResult& e) {
  if (e.parameters.empty()) return "";
  std::string text = "Parameters: ";
  for (const ParameterValue& p : e.parameters)
    text +=
        (&p == &e.parameters.front() ? "" : "; ") +
        code(p.name + " = " + rounded(p.value, 6) + (p.unit.empty() || p.unit == "1" ? "" : " " + p.unit)) +
        " " + escaped(p.says, false);
  return text + ".\n\n";
}

std::string exercise_text(const ExerciseResult& e, bool charts) {
  std::string text = "## " + to_string(e.number) + " " + escaped(e.title, false) + "\n\n" +
                     (of_the_book(e.number) ? "" : "*An exercise of one's own, not of the book.*\n\n") +
                     prose(e.asks) + "\n\n" + parameters_text(e);
  if (!e.failure.empty()) return text + "**The study failed:** " + escaped(e.failure, false) + "\n\n";
  Counts counts;
  count(e, counts);
  if (!e.claims.empty()) text += "### What the solution says: " + sentence(counts) + "\n\n" + claims_text(e);
  for (const QuantityResult& q : e.quantities) text += quantity_text(e, q, charts);
  return text;
}

// ---- the tables behind the charts -------------------------------------------------------------------------

std::string about_charts() {
  return "Each point is a trial: a method at one setting of its knob. Times are the median of several "
         "batches "
         "measured alone, with half the interquartile range. A trial is on the *Pareto front* by evaluations "
         "(E) or by time (T) when no other is both cheaper and more accurate.\n\n";
}

/// Every trial with all that the charts show of it.
std::string trials_table(const QuantityResult& q) {
  const std::vector<bool> by_evaluations = pareto_front(q, Cost::evaluations),
                          by_time = pareto_front(q, Cost::time);
  std::vector<std::vector<std::string>> rows;
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials) {
      const std::string front =
          std::string(by_evaluations[rows.size()] ? "E" : "") + (by_time[rows.size()] ? "T" : "");
      rows.push_back(
          {escaped(t.model), escaped(t.algorithm), knob_cell(t), error_cell(t.error),
           error_cell(t.final_error), std::to_string(t.evaluations), shown_time(t.time.seconds),
           shown_time(t.time.spread),
           t.evaluations > 0 ? shown_time(t.time.seconds / static_cast<double>(t.evaluations)) : "-",
           std::string(name_of(t.outcome)), front});
    }
  return table({"model", "algorithm", "knob", "error", "final error", "evaluations", "time", "spread",
                "per evaluation", "outcome", "front"},
               rows, "345678");
}

/// The power laws that methods follow, and where.
std::string fits_table(const QuantityResult& q) {
  std::vector<std::vector<std::string>> rows;
  for (const MethodResult& m : q.methods)
    if (const auto f = fit(q, m))
      rows.push_back(
          {escaped(m.model), escaped(m.algorithm), escaped(shown_fit(m, f)), error_cell(f->factor),
           knob_cell(m.trials[f->first]) + " to " + with_powers(rounded(m.trials[f->last].setting, 4))});
  if (rows.empty()) return "";
  return "Fitted: error = factor × knob^exponent, for a knob that counts, factor × (1/knob)^exponent.\n\n" +
         table({"model", "algorithm", "fit", "factor", "over"}, rows, "3");
}

// ---- pages ------------------------------------------------------------------------------------------------

std::string chapter_text(const Results& results, const Chapter& chapter, bool charts) {
  std::string text =
      "# Chapter " + std::to_string(chapter.number) + ": " + std::string(chapter.title) + "\n\n";
  if (!has_page(results, chapter)) return text + "The solutions have no exercises in this chapter.\n\n";
  const auto exercises = of_chapter(results, chapter.number);
  Counts counts;
  for (const ExerciseResult* e : exercises) count(*e, counts);
  text +=
      plural(static_cast<int>(exercises.size()), "exercise", "exercises") + ": " + sentence(counts) + ".\n\n";
  if (const auto missing = not_encoded(chapter); !missing.empty())
    text += "Not yet encoded (" + std::to_string(missing.size()) + "): " + listed(missing) + ".\n\n";
  for (const ExerciseResult* e : exercises) text += exercise_text(*e, charts);
  return text;
}

std::string link_to(const ExerciseResult& e, const Claim& claim, bool links) {
  const std::string id = escaped(claim.id);
  return links ? "[" + id + "](" + chapter_file(e.number.chapter) + "#" + anchor_of(claim) + ")" : id;
}

/// The errata by what they come from: those with one root are one finding.
std::string errata(const Results& results, bool links) {
  std::vector<std::vector<std::string>> rows;
  for (const ExerciseResult& e : results.exercises) {
    std::map<std::string, std::size_t> row_of;
    for (const JudgedClaim& c : e.claims) {
      if (c.verdict != Verdict::erratum) continue;
      const Claim& claim = c.claim;
      const auto known = row_of.find(claim.root);
      if (known != row_of.end() && !claim.root.empty()) {
        rows[known->second][0] += ", " + link_to(e, claim, links);
        continue;
      }
      row_of[claim.root] = rows.size();
      const auto root = std::ranges::find(e.roots, claim.root, &Root::name);
      rows.push_back({link_to(e, claim, links), std::string(name_of(claim.kind)), escaped(claim.says),
                      escaped(claim.printed.text), escaped(claim.corrected.text),
                      root == e.roots.end() ? "" : escaped(root->shows)});
    }
  }
  return table({"claims", "kind", "the solution says", "as printed", "what is right", "what one would see"},
               rows);
}

/// The claims of one verdict, each beside what is right.
std::string list_of(const Results& results, Verdict verdict, bool links) {
  std::vector<std::vector<std::string>> rows;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims) {
      if (c.verdict != verdict) continue;
      const Claim& claim = c.claim;
      rows.push_back({link_to(e, claim, links), std::to_string(claim.line), escaped(claim.says),
                      escaped(claim.printed.text),
                      escaped((verdict == Verdict::misprint ? claim.meant : claim.corrected).text)});
    }
  return table({"claim", "line", "the solution says", "as printed",
                verdict == Verdict::misprint ? "what is meant" : "what is right"},
               rows, "1");
}

/// What cannot be judged, and why.
std::string not_checkable_table(const Results& results) {
  std::vector<std::vector<std::string>> rows;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims)
      if (c.verdict == Verdict::not_checkable)
        rows.push_back({escaped(c.claim.id), std::to_string(c.claim.line), escaped(c.claim.says),
                        escaped(c.claim.not_checkable)});
  return table({"claim", "line", "the solution says", "why it cannot be checked"}, rows, "1");
}

std::string whats_wrong(const Results& results, Counts counts, bool links) {
  std::string text;
  for (const auto& [verdict, title] : {std::pair{Verdict::erratum, "Errata"},
                                       {Verdict::misprint, "Misprints"},
                                       {Verdict::unsettled, "Unsettled"}})
    if (counts[verdict] > 0)
      text += "### " + std::string(title) + " (" + std::to_string(counts[verdict]) + ")\n\n" +
              (verdict == Verdict::erratum ? errata(results, links) : list_of(results, verdict, links));
  if (counts[Verdict::not_checkable] > 0) text += "### Not checkable\n\n" + not_checkable_table(results);
  return text.empty() ? "Nothing in this run.\n\n" : text;
}

std::string legend() {
  return "A claim is one thing that the published solution says. It is **confirmed** when independent "
         "numbers agree with it as it is "
         "printed; a **misprint** when they agree with what the text plainly meant; an **erratum** when only "
         "a corrected statement "
         "agrees; **not checkable** when it speaks of something that neither the text nor this program has; "
         "**unsettled** when nothing does. Verdicts are computed: each check compares two routes "
         "that share nothing, within a "
         "tolerance that has a reason; and near misses of each claim (another sign, a dropped term, another "
         "digit) have to fail the same comparison. Line numbers are those of the solutions document as plain "
         "text.\n\n"
         "A method is a model solved by an algorithm; a trial runs it at one setting of its knob (step, "
         "tolerance, points). Its cost is "
         "counted in evaluations of the integrand or right-hand side. A trial is *ok* when its error is "
         "within the need; *inaccurate*, "
         "*drifted* (a conserved quantity changed), *diverged*, *non-finite*, *stalled* (out of steps), "
         "*deceived* (the method's own "
         "error estimate is below its true error), *raised* (the library reported an error), *chattering* "
         "(events without end while the time does not move, as the bounces of a ball that comes to rest) or "
         "*grazing* (whether an event happens is below the algorithm's error) otherwise. A motion is "
         "judged at the few times that are named with it, and may err more between them; the cheapest "
         "models, and `oddity choose`, judge every frame.\n\n";
}

/// A chapter's rows in the table of contents: one an exercise, and one for those not yet encoded.
void add_chapter(const Results& results, const Chapter& chapter, bool links,
                 std::vector<std::vector<std::string>>& rows) {
  const std::string title = std::to_string(chapter.number) + ". " + std::string(chapter.title);
  std::string first =
      links && has_page(results, chapter) ? "[" + title + "](" + chapter_file(chapter.number) + ")" : title;
  const auto add = [&](std::vector<std::string> cells) {
    cells.insert(cells.begin(), std::exchange(first, ""));
    cells.resize(8);
    rows.push_back(std::move(cells));
  };
  for (const ExerciseResult* e : of_chapter(results, chapter.number)) {
    Counts counts;
    count(*e, counts);
    const std::string name = to_string(e->number) + " " + escaped(e->title);
    std::vector<std::string> cells{
        (links ? "[" + name + "](" + chapter_file(chapter.number) + "#" + anchor(*e) + ")" : name) +
        own_mark(e->number)};
    for (Verdict verdict : verdicts) cells.push_back(counts[verdict] ? std::to_string(counts[verdict]) : "");
    cells.push_back(std::to_string(e->quantities.size()));
    add(std::move(cells));
  }
  if (const auto missing = not_encoded(chapter); !missing.empty())
    add({"*not yet encoded (" + std::to_string(missing.size()) + "):* " + listed(missing)});
}

std::string chapters_without_exercises() {
  std::string text;
  for (const Chapter& chapter : chapters())
    if (chapter.last_odd == 0 && chapter.number <= 14)
      text += (text.empty() ? "" : ", ") + std::to_string(chapter.number);
  return text;
}

/// "48 exercises", "48 exercises and 1 of one's own".
std::string exercises_counted(const Results& results) {
  const auto book = static_cast<int>(std::ranges::count_if(
      results.exercises, [](const ExerciseResult& e) { return of_the_book(e.number); }));
  const int own = static_cast<int>(results.exercises.size()) - book;
  return plural(book, "exercise", "exercises") +
         (own > 0 ? " and " + std::to_string(own) + " of one's own" : "");
}

/// The routes of all its checks give the same doubles in every sample, though roundings are allowed.
bool bit_equal(const JudgedClaim& judged) {
  const auto& checks = deciding(judged).checks;
  return !checks.empty() && std::ranges::all_of(checks, [](const Check& c) {
    return c.tolerance.allowed > 0 && c.difference() == 0;
  });
}

/// What a reader may doubt: two routes that never differ may be one.
std::string bit_equal_text(const Results& results, bool links) {
  std::string list;
  int count = 0;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims)
      if (c.verdict == Verdict::confirmed && bit_equal(c))
        list += (count++ == 0 ? "" : ", ") + link_to(e, c.claim, links);
  if (count == 0) return "";
  return "## Equal to the last bit (" + std::to_string(count) +
         ")\n\nThe two routes of these confirmed claims never differ, though their tolerance leaves room for roundings: "
         "they do the same arithmetic in the end, or their numbers are short. Their near misses fail like all "
         "others.\n\n" +
         list + "\n\n";
}

std::string index_text(const Results& results, bool links) {
  Counts all;
  for (const ExerciseResult& e : results.exercises) count(e, all);
  int total = 0;
  for (const auto& [verdict, n] : all) total += n;
  std::size_t missing = 0;
  std::vector<std::vector<std::string>> rows;
  for (const Chapter& chapter : chapters()) {
    missing += not_encoded(chapter).size();
    add_chapter(results, chapter, links, rows);
  }
  std::string text = "# The solutions of *Game Physics*, checked by machine\n\n" +
                     exercises_counted(results) + ", " + plural(total, "claim", "claims") + ": " +
                     sentence(all) + ".";
  if (missing > 0) text += " Not yet encoded: " + std::to_string(missing) + " of 48 exercises.";
  if (links)
    text +=
        "\n\nFor games: [the cheapest model that is enough for each scene](models.md), "
        "[where methods break, and what cures it](stability.md), "
        "[the algorithms and what was found in their libraries](algorithms.md), "
        "[how long each method took](times.md).";
  return text + "\n\n## What is wrong in the solutions manual\n\n" + whats_wrong(results, all, links) +
         "## By chapter\n\n" +
         table({"chapter", "exercise", "confirmed", "misprint", "erratum", "not checkable", "unsettled",
                "quantities"},
               rows, "234567") +
         "The solutions have no exercises in chapters " + chapters_without_exercises() + ".\n\n" +
         bit_equal_text(results, links) + "## How to read this\n\n" + legend();
}

}  // namespace

std::string chapter_file(int chapter) {
  return "chapter_" + std::string(chapter < 10 ? "0" : "") + std::to_string(chapter) + ".md";
}

std::string chart_file(const ExerciseResult& e, const QuantityResult& q, Across across) {
  const bool beside = across == Across::setting && charts_of(q).size() > 1;
  return picture_file(e, q, across == Across::time ? "_time" : beside ? "_over_step" : "");
}

std::string trajectory_file(const ExerciseResult& e, const QuantityResult& q) {
  return picture_file(e, q, "_motion");
}

std::string series_file(const ExerciseResult& e, const QuantityResult& first) {
  return picture_file(e, first, "_series");
}

std::string claims_evidence(const JudgedClaim& judged) {
  std::string text =
      judged.claim.id + " (line " + std::to_string(judged.claim.line) + "): " + judged.claim.says + "\n";
  const auto add = [&](const std::string& name, const Reading& reading) {
    for (const Check& c : reading.checks)
      text += "  " + name + (c.holds() ? " holds: " : " FAILS: ") + c.quantity + ": " +
              shown(c.left.value, 17) + " (" + c.left.by + ") against " + shown(c.right.value, 17) + " (" +
              c.right.by + "), " + difference_of(c) + " (" + c.tolerance.reason + ")" +
              (c.where.empty() ? "" : ", " + c.where) + "\n";
  };
  add("printed", judged.claim.printed);
  add("meant", judged.claim.meant);
  add("corrected", judged.claim.corrected);
  for (const Reading& near : judged.claim.near_misses) add("near miss '" + near.text + "'", near);
  return readable(text);
}

std::string index_page(const Results& results) { return index_text(results, true); }

std::string chapter_page(const Results& results, int number) {
  for (const Chapter& chapter : chapters())
    if (chapter.number == number) return chapter_text(results, chapter, true) + "[All chapters](README.md)\n";
  return "";
}

std::string times_page(const Results& results) {
  std::string text =
      "# Times\n\nEach time is the median of several batches in the run that made this report, each method "
      "measured alone; the spread is half the interquartile range. Times differ from run to run and from "
      "machine to machine; the counted work in the chapters does not.\n\n";
  for (const ExerciseResult& e : results.exercises)
    for (const QuantityResult& q : e.quantities)
      text += "## " + to_string(e.number) + " " + escaped(e.title, false) + ": " + code(q.name) + "\n\n" +
              chart_links(e, q, true) + trials_table(q);
  return text;
}

std::string charts_page(const ExerciseResult& e) {
  std::string text = "# " + to_string(e.number) + " " + escaped(e.title, false) + "\n\n" + prose(e.asks) +
                     "\n\n" + parameters_text(e) + about_charts();
  for (const QuantityResult& q : e.quantities)
    if (has_chart(q))
      text += quantity_head(q) + trajectory_link(e, q) + chart_links(e, q, false) + chart_links(e, q, true) +
              fits_table(q) + trials_table(q);
  return text;
}

std::string single_page(const Results& results) {
  std::string text = index_text(results, false) + "\n";
  for (const Chapter& chapter : chapters())
    if (!of_chapter(results, chapter.number).empty()) text += chapter_text(results, chapter, false);
  return text;
}

}  // namespace oddity
