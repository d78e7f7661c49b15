#include "report/site/front_page.hpp"

#include <algorithm>

#include "chapters/contents.hpp"
#include "report/site/claims_section.hpp"
#include "report/site/doors.hpp"
#include "report/site/moving_picture.hpp"
#include "report/site/page.hpp"
#include "report/study/findings.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;

std::string exercise_link(const ExerciseResult& e) {
  return html::link(to_string(e.number) + ".html", "<b>" + to_string(e.number) + "</b> " + in_xml(e.title));
}

// ---- results ----------------------------------------------------------------------------------------------

/// A bar of the verdicts, with widths in proportion to their numbers.
std::string verdict_bar(const Counts& all) {
  std::string bar, legend;
  int before = 0;
  for_each_count(all, [&](const VerdictNoun& noun, int n) {
    const std::string kind = class_of(noun.verdict), count = std::to_string(n);
    bar += "<rect class=\"" + kind + "\" x=\"" + std::to_string(before) + "\" width=\"" + count +
           "\" height=\"1\"/>";
    before += n;
    legend += element("li", " class=\"" + kind + "\"",
                      "<b>" + count + "</b> " + std::string(n == 1 ? noun.one : noun.many));
  });
  return "<svg class=\"bar\" viewBox=\"0 0 " + std::to_string(std::max(before, 1)) +
         " 1\" preserveAspectRatio=\"none\" aria-hidden=\"true\">" + bar + "</svg>\n" +
         element("ul", " class=\"verdicts\"", legend) + "\n";
}

long trials_of(const Results& results) {
  long all = 0;
  for (const ExerciseResult& e : results.exercises)
    for (const QuantityResult& q : e.quantities) {
      for (const MethodResult& m : q.methods) all += static_cast<long>(m.trials.size());
      for (const FloatResult& m : q.in_float) all += static_cast<long>(m.trials.size());
    }
  return all;
}

std::string title() {
  return "<header class=\"title\">\n<h1>The solutions of <cite>Game Physics</cite>, checked by machine</h1>\n"
         "<p class=\"asks\">For students and teachers who use the solutions manual of the book’s second edition, and for "
         "game programmers who need to know what moves a scene correctly.</p>\n</header>\n";
}

std::string what_was_done(const Results& results, const SiteParts& parts) {
  const Counts all = counts_of(results);
  long quantities = 0, breakdowns = 0, scenes = 0;
  for (const ExerciseResult& e : results.exercises) {
    quantities += static_cast<long>(e.quantities.size());
    scenes += e.scene;
    for (const QuantityResult& q : e.quantities) breakdowns += static_cast<long>(q.breakdowns.size());
  }
  return "<section class=\"done\">\n" + verdict_bar(all) +
         "<p class=\"sum\">Every odd exercise of the book is computed here, and each statement of its published "
         "solution is judged against numbers that were found another way: " +
         counted(static_cast<long>(results.exercises.size()), "exercise", "exercises") + ", " +
         counted(sum_of(all), "claim", "claims") + ". " +
         counted(quantities, "quantity was", "quantities were") + " computed in " +
         counted(trials_of(results), "trial", "trials") + ", with " +
         counted(breakdowns, "breakdown", "breakdowns") + " and their cures. " +
         (scenes == 0
              ? ""
              : counted(scenes, "scene moves", "scenes move") + " in these pages, " +
                    (parts.models ? "run by the very C++ that was tested." : "as they were recorded.")) +
         "</p>\n</section>\n";
}

// ---- errors -----------------------------------------------------------------------------------------------

std::string wrong_item(const Finding& finding) {
  const JudgedClaim& first = *finding.claims.front();
  const std::string to = to_string(finding.exercise->number) + ".html#" + claim_anchor_of(first.claim);
  const auto [as_printed, as_is_right] =
      html::texts_that_differ(first.claim.printed.text, right_reading(first).text);
  std::string text = element("h4", "", html::link(to, html::text(finding.title()))) +
                     "<dl class=\"sides\"><div class=\"printed\"><dt>printed</dt>" +
                     element("dd", "", as_printed) + "</div><div class=\"corrected\"><dt>right</dt>" +
                     element("dd", "", as_is_right) + "</div></dl>";
  if (!finding.shows().empty()) text += element("p", " class=\"shows\"", html::prose(finding.shows()));
  return element("li", "", text) + "\n";
}

std::string wrong_card(const ExerciseResult& e, const std::vector<Finding>& worst_first, bool shown_above) {
  const std::string picture = shown_above ? "" : moving_picture(e);
  std::string items;
  for (const Finding& finding : worst_first)
    if (finding.exercise == &e) items += wrong_item(finding);
  return "<section class=\"card" + std::string(picture.empty() ? "" : " moving") + "\">\n" +
         element("h3", "", exercise_link(e)) + "\n" + picture + element("ul", " class=\"roots\"", items) +
         "\n</section>\n";
}

std::string what_is_wrong(const Results& results) {
  const std::vector<Finding> worst_first = errata_worst_first(results);
  if (worst_first.empty()) return "";
  const ExerciseResult* const above = exercise_in_motion(results);
  std::vector<const ExerciseResult*> shown;
  std::string breaking, others;
  for (const Finding& f : worst_first) {
    if (std::ranges::find(shown, f.exercise) != shown.end()) continue;
    shown.push_back(f.exercise);
    (broken_by(*f.exercise) > 0 ? breaking : others) +=
        wrong_card(*f.exercise, worst_first, f.exercise == above);
  }
  Counts all = counts_of(results);
  const auto wrong = std::ranges::count_if(worst_first, is_wrong);
  return "<section id=\"wrong\">\n<h2>What is wrong in the book</h2>\n<p>" +
         counted(all[Verdict::wrong], "claim is wrong", "claims are wrong") + ", from " +
         counted(wrong, "root", "roots") + ", and " +
         counted(all[Verdict::incomplete], "is incomplete", "are incomplete") + ", from " +
         counted(std::ssize(worst_first) - wrong, "more", "more") +
         "; scenes whose published motion leaves the true one come first. " +
         counted(all[Verdict::misprint], "misprint is shown with its exercise",
                 "misprints are shown with their exercises") +
         ". Losses in our plain-text copy of the manual (" + std::to_string(all[Verdict::lost]) +
         " claims) are counted separately: they are no fault of the book. The <a href=\"errata.html\">errata sheet</a> has all of them, to print and lay into the book, and <a "
         "href=\"errata.json\">errata.json</a> has them for programs.</p>\n<div class=\"cards\">\n" +
         breaking + "</div>\n<div class=\"cards\">\n" + others + "</div>\n</section>\n";
}

// ---- all exercises ----------------------------------------------------------------------------------------

std::string exercise_item(const ExerciseResult& e) {
  std::string counts;
  for_each_count(counts_of(e), [&](const VerdictNoun& noun, int n) {
    counts += "<span class=\"count " + class_of(noun.verdict) + "\">" + std::to_string(n) +
              "<span class=\"unseen\"> " + std::string(noun.many) + "</span></span>";
  });
  return element("li", "", exercise_link(e) + " <span class=\"counts\">" + counts + "</span>") + "\n";
}

std::string all_exercises(const Results& results) {
  std::string text;
  for (const Chapter& chapter : chapters()) {
    std::string items;
    for (const ExerciseResult& e : results.exercises)
      if (e.number.chapter == chapter.number) items += exercise_item(e);
    if (!items.empty())
      text += element("section", "",
                      element("h3", "", std::to_string(chapter.number) + ". " + in_xml(chapter.title)) +
                          "\n<ul>\n" + items + "</ul>\n");
  }
  std::string legend;
  for_each_count(counts_of(results), [&](const VerdictNoun& noun, int) {
    legend += "<span class=\"count " + class_of(noun.verdict) + "\">1</span> " + std::string(noun.many) + " ";
  });
  return "<section id=\"exercises\">\n<h2>All exercises</h2>\n<p class=\"legend\">" + legend +
         "</p>\n<div class=\"chapters\">\n" + text + "</div>\n</section>\n";
}

}  // namespace

std::string front_page(const Results& results, const SiteParts& parts) {
  return html::whole({"oddity: the solutions of Game Physics, checked by machine",
                      title() + doors(results) + what_was_done(results, parts) + what_is_wrong(results) +
                          all_exercises(results),
                      {"assets/doors.js"},
                      "front"});
}

}  // namespace oddity
