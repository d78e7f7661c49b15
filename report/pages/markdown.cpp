#include "report/pages/markdown.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/claims.hpp"
#include "report/pages/pictures.hpp"
#include "report/pages/quantities.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

// ---- the book ---------------------------------------------------------------------------------------------

std::vector<const ExerciseResult*> of_chapter(const Results& results, int chapter) {
  std::vector<const ExerciseResult*> found;
  for (const ExerciseResult& e : results.exercises)
    if (e.number.chapter == chapter) found.push_back(&e);
  return found;
}

std::string own_mark(Number number) { return of_the_book(number) ? "" : " (own)"; }

/// Exercises of the book that are not encoded, in the chapters of the results.
std::string not_encoded(const Results& results) {
  std::string missing;
  for (const Chapter& chapter : chapters())
    for (int index = 1; index <= chapter.last_odd && !of_chapter(results, chapter.number).empty();
         index += 2) {
      const Number number{chapter.number, index};
      if (std::ranges::none_of(registry(), [&](const Entry& e) { return e.number == number; }))
        missing += (missing.empty() ? "" : ", ") + to_string(number);
    }
  return missing;
}

/// "48 exercises", "48 exercises and 1 of one's own".
std::string exercises_counted(const Results& results) {
  const auto book = static_cast<int>(std::ranges::count_if(
      results.exercises, [](const ExerciseResult& e) { return of_the_book(e.number); }));
  const int own = static_cast<int>(results.exercises.size()) - book;
  return counted(book, "exercise", "exercises") +
         (own > 0 ? " and " + std::to_string(own) + " of one's own" : "");
}

std::string name_of(const ExerciseResult& e) { return to_string(e.number) + " " + escaped(e.title); }

/// GitHub's anchor of an exercise's heading, on a page with several.
std::string heading_anchor(const ExerciseResult& e) {
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

std::string link_to(const ExerciseResult& e, Links links) {
  return "[" + name_of(e) + "](" +
         (links == Links::apart ? exercise_file(e.number) : "#" + heading_anchor(e)) + ")";
}

// ---- an exercise ------------------------------------------------------------------------------------------

/// The parameters and their values, except the seed of random samples.
std::string parameters_text(const ExerciseResult& e) {
  std::string text;
  for (const ParameterValue& p : e.parameters)
    if (p.name != "seed")
      text += (text.empty() ? "" : "; ") +
              code(p.name + "=" + format_significant(p.value, 6) +
                   (p.unit.empty() || p.unit == "1" ? "" : " " + typeset_unit(p.unit))) +
              " " + escaped(p.says, false);
  return text.empty() ? "" : "Parameters: " + text + ".\n\n";
}

/// The model that is enough for a game, in a sentence.
std::string for_games(const ExerciseResult& e) {
  if (!e.cheapest_models || e.cheapest_models->least.empty()) return "";
  const CheapestModel& row = e.cheapest_models->least.front();
  const std::string places = " ([models](models.md#" + heading_anchor(e) + ")" +
                             (e.stability ? ", [stability](stability.md#" + heading_anchor(e) + ")" : "") +
                             ").\n\n";
  return "To " + escaped(row.says, false) + ", as games need it, " +
         (row.least ? "*" + escaped(row.least->model, false) + "* by " +
                          escaped(row.least->algorithm, false) + " is enough"
                    : "nothing here is enough") +
         places;
}

std::string question(const ExerciseResult& e) {
  return (of_the_book(e.number) ? "" : "*An exercise of one's own, not of the book.*\n\n") + prose(e.asks) +
         "\n\n" + parameters_text(e);
}

/// Everything below an exercise's question; `level` is that of the headings.
std::string body(const ExerciseResult& e, const std::string& level, bool pages, const ProvedClaims& proved) {
  if (!e.failure.empty()) return "**The study failed:** " + escaped(e.failure, false) + "\n\n";
  std::string text;
  if (!e.claims.empty()) text += level + " The answer\n\n" + answer(e);
  if (pages) text += for_games(e);
  if (const std::string wrong = wrong_claims(e, proved); !wrong.empty())
    text += level + " What is wrong, and why\n\n" + wrong;
  text += other_claims(e, proved);
  if (!e.quantities.empty()) text += level + " What is computed\n\n";
  for (const QuantityResult& q : e.quantities) text += quantity_text(e, q, pages);
  return text + expected_failures(e);
}

/// Links to the previous exercise, the index and the next exercise.
std::string ways(const Results& results, const ExerciseResult& e) {
  const auto& all = results.exercises;
  const auto here =
      static_cast<std::size_t>(std::ranges::find(all, e.number, &ExerciseResult::number) - all.begin());
  const auto link = [](const ExerciseResult& other, const std::string& before, const std::string& after) {
    return "[" + before + to_string(other.number) + after + "](" + exercise_file(other.number) + ")";
  };
  return (here > 0 ? link(all[here - 1], "← ", "") + " " : "") + "[index](README.md)" +
         (here + 1 < all.size() ? " " + link(all[here + 1], "", " →") : "") + "\n";
}

// ---- the front page ---------------------------------------------------------------------------------------

std::string legend() {
  return "A claim is one statement of the published solution. It is **confirmed** when independent "
         "numbers agree with it as printed. It is a **misprint** when they agree with the evident meaning, "
         "as another line of the text shows. It is **lost in our copy** when the plain text that was read "
         "lacks the meaning, such as a fraction bar or an exponent, and the manual may be right. Our copy "
         "also lacks the dots of all time derivatives, and the marks that distinguish a center's coordinates "
         "from others. Where a line makes sense only with them, they are restored, and its place is marked "
         "*dots restored* or *marks restored*. Where it makes another, false statement without them, it is "
         "lost in our copy. A claim is **wrong** when a formula, a number, a line of code or a sentence is "
         "false and only a corrected one agrees. It is **incomplete** when it holds in the cases that its "
         "author had in mind, and a case or a condition is left out. It is **not checkable** when it is "
         "about something that neither the text nor this program contains, and **unsettled** when nothing "
         "agrees. Verdicts are computed: each check compares two routes that share nothing, within a "
         "tolerance that has a reason. Near misses of each claim (another sign, a dropped term, another "
         "digit) have to fail the same comparison. Line numbers are those of the solutions document as plain "
         "text.\n\n"
         "A method is a model solved by an algorithm; a trial runs it at one setting (step, "
         "tolerance, points). Its cost is counted in evaluations of the integrand or right-hand side. A trial "
         "is *ok* when its error is within the need. Otherwise it is *inaccurate*, *drifted* (a conserved "
         "quantity changed and does not come back) or *diverged* (off the scale, and farther with time). Or "
         "it is *non-finite*, *stalled* (out of steps) or *raised* (the library reported an error). It is "
         "*deceived* when the method's own error estimate is below its true error. It is *chattering* when "
         "events follow without end while the time does not move, like the bounces of a ball that comes to "
         "rest. It is *grazing* when the algorithm's error decides whether an event happens. A motion is "
         "judged at a few named times, and may err more between them. The cheapest models, and `oddity "
         "choose`, judge every frame.\n\n"
         "A page shows at most eight methods of a quantity; `oddity site` has all trials, and `oddity chart` draws "
         "them. Claims marked † or *proved* are proved by Coq.\n";
}

std::string unfold(const std::string& summary, const std::string& text) {
  return "<details><summary>" + summary + "</summary>\n\n" + text + "</details>\n\n";
}

std::string exercises_table(const std::vector<const ExerciseResult*>& exercises, Links links) {
  const auto cell = [](int count) { return count > 0 ? std::to_string(count) : ""; };
  std::vector<std::vector<std::string>> rows;
  for (const ExerciseResult* e : exercises) {
    Counts counts = counts_of(*e);
    std::string confirmed = cell(counts[Verdict::confirmed]);
    if (const int others = counts[Verdict::not_checkable]; others > 0)
      confirmed += (confirmed.empty() ? "" : ", ") + std::to_string(others) + " not checkable";
    rows.push_back({link_to(*e, links) + own_mark(e->number), cell(counts[Verdict::wrong]),
                    cell(counts[Verdict::incomplete]), cell(counts[Verdict::misprint]),
                    cell(counts[Verdict::lost]), confirmed, std::to_string(e->quantities.size())});
  }
  return table(
      {"exercise", "wrong", "incomplete", "misprints", "lost in our copy", "confirmed", "quantities"}, rows,
      "123456");
}

/// A row per exercise, folded up by chapter.
std::string by_chapter(const Results& results, Links links) {
  std::string text;
  for (const Chapter& chapter : chapters()) {
    const auto exercises = of_chapter(results, chapter.number);
    if (exercises.empty()) continue;
    Counts counts;
    for (const ExerciseResult* e : exercises)
      for (const auto& [verdict, n] : counts_of(*e)) counts[verdict] += n;
    const std::string title = std::to_string(chapter.number) + ". " + std::string(chapter.title);
    text += unfold("<b>" + title +
                       "</b>: " + counted(static_cast<int>(exercises.size()), "exercise", "exercises") +
                       ", " + sentence(counts),
                   exercises_table(exercises, links));
  }
  return text;
}

/// The worst errata, one per row.
std::string worst_errata(const Results& results, Links links) {
  constexpr std::size_t most = 8;
  std::vector<std::vector<std::string>> rows;
  for (const Finding& f : errata_worst_first(results)) {
    if (rows.size() == most) break;
    rows.push_back({"[" + escaped(to_string(f.exercise->number) + " " + f.title()) + "](" +
                        address_of(*f.exercise, f.claims.front()->claim, links) + ")",
                    escaped(f.shows())});
  }
  return rows.empty() ? "" : table({"erratum", "visible effect"}, rows);
}

/// The model that is enough for a game, a row per scene.
std::string scenes_table(const Results& results, Links links) {
  std::vector<std::vector<std::string>> rows;
  for (const ExerciseResult& e : results.exercises) {
    if (!e.cheapest_models || e.cheapest_models->least.empty()) continue;
    const CheapestModel& row = e.cheapest_models->least.front();
    rows.push_back({link_to(e, links), row.least ? escaped(row.least->model) : "*none here*",
                    row.least ? escaped(row.least->algorithm) : "",
                    row.least ? format_significant(row.least->evaluations_per_frame, 3) : ""});
  }
  if (rows.empty()) return "";
  return unfold("<b>For games</b>: the simplest model that is enough, a row a scene",
                table({"scene", "model", "algorithm", "evaluations per frame"}, rows, "3"));
}

/// Counts the roots with a wrong claim, and those whose claims are all incomplete.
std::string causes_of_errata(const Results& results) {
  int wrong = 0, incomplete = 0;
  for (const ExerciseResult& e : results.exercises)
    for (const Finding& f : findings_of(e)) ++(is_wrong(f) ? wrong : incomplete);
  return counted(wrong, "cause of wrong claims", "causes of wrong claims") + " and " +
         counted(incomplete, "cause of incomplete claims", "causes of incomplete claims");
}

bool has_scenes(const Results& results) {
  return std::ranges::any_of(results.exercises,
                             [](const ExerciseResult& e) { return e.stability.has_value(); });
}

bool has_cheapest_models(const Results& results) {
  return std::ranges::any_of(results.exercises,
                             [](const ExerciseResult& e) { return e.cheapest_models.has_value(); });
}

std::string other_pages(const Results& results, Edition edition) {
  std::string text = "[All errata](errata.md)";
  if (has_cheapest_models(results)) text += " · [which model is enough](models.md)";
  if (has_scenes(results)) text += " · [which steps are stable](stability.md)";
  text += " · [the algorithms and their libraries](algorithms.md) · [the basis of the results](trust.md)";
  if (edition == Edition::whole) text += " · [times](times.md)";
  return text + "\n\n";
}

std::string head(const Results& results) {
  Counts all = counts_of(results);
  int total = 0;
  for (const auto& [verdict, n] : all) total += n;
  const std::string missing = not_encoded(results);
  return "# The solutions of *Game Physics*, checked by machine\n\n" + exercises_counted(results) + ", " +
         counted(total, "claim", "claims") + ": " + sentence(all) + "." +
         (all[Verdict::wrong] + all[Verdict::incomplete] > 0 ? " There are " + causes_of_errata(results) + "."
                                                             : "") +
         (all[Verdict::confirmed] > 0
              ? " Confirmed claims are listed under the second route that they agree with, after their lines."
              : "") +
         (missing.empty() ? "" : " Not yet encoded: " + missing + ".") + "\n\n";
}

}  // namespace

std::string exercise_file(Number number) { return to_string(number) + ".md"; }

std::string index_page(const Results& results, Edition edition) {
  const std::string worst = worst_errata(results, Links::apart);
  return head(results) + other_pages(results, edition) +
         (worst.empty() ? "" : "## Errata of the solutions manual\n\n" + worst) + "## Exercises\n\n" +
         by_chapter(results, Links::apart) + scenes_table(results, Links::apart) +
         unfold("<b>How to read this</b>", legend() + "\n");
}

std::string exercise_page_text(const Results& results, const ExerciseResult& e, const ProvedClaims& proved) {
  return "# " + to_string(e.number) + " " + escaped(e.title, false) + "\n\n" + ways(results, e) + "\n" +
         question(e) + picture_links(e) + body(e, "##", true, proved);
}

std::string errata_page_text(const Results& results) {
  Counts counts = counts_of(results);
  std::string text = "# Errata of the solutions manual\n\n";
  const auto section = [&](Verdict verdict, const std::string& title, const std::string& rows) {
    if (counts[verdict] > 0) text += "## " + title + " (" + std::to_string(counts[verdict]) + ")\n\n" + rows;
  };
  section(Verdict::wrong, "Wrong",
          "A row for each root; those by which a published motion goes wrong come first.\n\n" +
              errata_table(results, Links::apart, Verdict::wrong));
  section(
      Verdict::incomplete, "Incomplete",
      "A case is left out, or a condition.\n\n" + errata_table(results, Links::apart, Verdict::incomplete));
  section(Verdict::misprint, "Misprints", list_of(results, Verdict::misprint, Links::apart));
  section(Verdict::unsettled, "Unsettled", list_of(results, Verdict::unsettled, Links::apart));
  section(
      Verdict::lost, "Lost in our copy",
      "No fault of the manual as far as can be known: the plain text that was read here has lost it.\n\n" +
          list_of(results, Verdict::lost, Links::apart));
  return text + bit_equal_text(results) + "[All exercises](README.md)\n";
}

std::string times_page(const Results& results) {
  std::vector<std::vector<std::string>> rows;
  for (const ExerciseResult& e : results.exercises) {
    std::string fastest;
    for (const QuantityResult& q : e.quantities) {
      const TimedTrial* best = nullptr;
      for (const MethodResult& m : q.methods)
        if (const TimedTrial& t = best_of(m, Cost::time); !best || preferable(t, *best, Cost::time))
          best = &t;
      if (!best || best->outcome != Outcome::ok) continue;
      fastest += (fastest.empty() ? "" : "<br>") + code(q.name) + " " + shown_time(best->time.seconds) +
                 ", " + escaped(best->model + ", " + best->algorithm);
    }
    if (!fastest.empty())
      rows.push_back({"[" + to_string(e.number) + "](" + exercise_file(e.number) + ")", fastest});
  }
  return "# Times\n\nFor each quantity the fastest method within the need. A time is the median of several "
         "batches, measured alone in the run that made this report. "
         "Times differ from run to run and from machine to machine; the counted work on the other pages "
         "does not.\n\n" +
         table({"exercise", "fastest"}, rows) + "[All exercises](README.md)\n";
}

std::string charts_page(const ExerciseResult& e) {
  std::string text =
      "# " + to_string(e.number) + " " + escaped(e.title, false) + "\n\n" + prose(e.asks) + "\n\n" +
      parameters_text(e) +
      "Each point is a trial: a method at one setting. Times are the median of several "
      "batches measured alone, with half the interquartile range. A trial is on the *Pareto front* "
      "by evaluations (E) or by time (T) when no other is both cheaper and more accurate.\n\n";
  for (const QuantityResult& q : e.quantities)
    if (has_chart(q))
      text += quantity_head(q) + motion_link(e, q) + chart_links(e, q) + fits_table(q) + trials_table(q);
  return text;
}

std::string single_page(const Results& results) {
  std::string text = head(results) + by_chapter(results, Links::within);
  Counts counts = counts_of(results);
  for (const auto& [verdict, title] :
       {std::pair{Verdict::wrong, "Wrong"}, {Verdict::incomplete, "Incomplete"}})
    if (counts[verdict] > 0)
      text += "## " + std::string(title) + "\n\n" + errata_table(results, Links::within, verdict);
  for (const ExerciseResult& e : results.exercises)
    text += "## " + to_string(e.number) + " " + escaped(e.title, false) + "\n\n" + question(e) +
            body(e, "###", false, {});
  return text + "## How to read this\n\n" + legend();
}

}  // namespace oddity
