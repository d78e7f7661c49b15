#include "report/site/claims_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "chapters/typeset.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/text_view.hpp"
#include "report/site/page.hpp"
#include "report/study/findings.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;

std::string number_text(double x, int digits) {
  return std::isfinite(x) ? with_powers(format_significant(x, digits))
         : std::isnan(x)  ? "not a number"
                          : "infinite";
}

std::string value_text(const Value& value) { return in_xml(with_powers(shown(value, 7))); }
std::string words(const std::string& text) { return html::text(with_powers(with_short_numbers(text))); }

/// "holds in all 200 samples", "fails in 24 of 5760 samples".
std::string count_text(const Check& c) {
  const std::string of = c.left.by.substr(std::string("violations in ").size());
  if (c.left.value[0] != 0)
    return in_xml("fails in " + format_significant(c.left.value[0], 12) + " of " + of);
  return in_xml(of.starts_with("1 ") ? "holds in its one" + of.substr(1) : "holds in all " + of);
}

/// The share of its tolerance that a check uses; failing checks rank before all that pass.
double use_of(const Check& c) {
  const double used = c.tolerance.allowed > 0 ? c.difference() / c.tolerance.allowed
                      : c.difference() == 0   ? 0
                                              : INFINITY;
  return std::isnan(used) ? INFINITY : used;
}

const Check& hardest(const Reading& reading) { return *std::ranges::max_element(reading.checks, {}, use_of); }

std::string difference_text(const Check& c) {
  const double difference = c.difference();
  if (difference == 0) return "equal";
  if (!std::isfinite(difference)) return "not to be compared";
  return "off by " + number_text(difference, 2) +
         (c.tolerance.allowed == 0 ? " where nothing is allowed"
                                   : ", allowed " + number_text(c.tolerance.allowed, 2));
}

/// "all 200 samples" of "worst of 200: a=1"; empty: it is not over samples.
std::string samples_of(const Check& c) {
  const std::string_view over = "worst of ";
  if (!c.where.starts_with(over)) return "";
  const std::string count = c.where.substr(over.size(), c.where.find(':') - over.size());
  return count == "1" ? "its one sample" : "all " + count + " samples";
}
/// Its letters: "a=1, b=2".
std::string sample_of(const Check& c) {
  const auto colon = c.where.find(": ");
  return samples_of(c).empty() || colon == c.where.npos ? "" : c.where.substr(colon + 2);
}

std::string hardest_text(const Reading& reading) {
  return reading.checks.size() > 1 ? "; hardest of " + std::to_string(reading.checks.size()) + " checks" : "";
}

/// Text on the hardest check of a reading: the other route, and the difference.
std::string comparison_of(const Reading& reading, bool with_values) {
  const Check& c = hardest(reading);
  if (counts_violations(c)) return count_text(c);
  const std::string of = samples_of(c).empty() ? "" : ", in " + samples_of(c), sample = sample_of(c);
  if (!with_values)
    return "against " + words(c.right.by) + ": " + difference_text(c) + of + hardest_text(reading);
  return element("b", "", value_text(c.left.value)) + " against " +
         element("b", "", value_text(c.right.value)) + ", " + words(c.right.by) + ": " + difference_text(c) +
         (sample.empty() ? of : ", the most" + of + ", at " + words(sample)) + hardest_text(reading);
}

/// Text on a reading next to one compared with `before`. Omits the other route if both share it. At samples,
/// this reading's value is known only by its largest difference.
std::string comparison_next_to(const Reading& reading, const Check& before) {
  const Check& c = hardest(reading);
  if (counts_violations(c) || before.right.by != c.right.by) return comparison_of(reading, true);
  if (samples_of(c).empty() || !c.holds())
    return element("b", "", value_text(c.left.value)) + ": " + difference_text(c);
  return element("b", "", value_text(before.right.value)) + " there: " + difference_text(c) + ", in " +
         samples_of(c) + hardest_text(reading);
}

std::string near_misses_of(const Claim& claim) {
  const auto n = static_cast<long>(claim.near_misses.size());
  return n == 0 ? ""
                : " " + counted(n, "wrong variant", "wrong variants") + ", tried as well, " +
                      (n == 1 ? "fails, as it must." : "fail, as they must.");
}

std::string sentence(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text + ".";
}

/// How a wrong formula was read, as it has no other transcription.
std::string how_it_is_read(const JudgedClaim& judged) {
  const Reading& printed = judged.claim.printed;
  const bool wrong = is_erratum(judged.verdict) || judged.verdict == Verdict::misprint;
  return wrong && printed.as_typeset ? " The print was read as " + html::in_all_brackets(printed.text) + "."
                                     : "";
}

/// The evidence for a verdict.
std::string evidence_of(const JudgedClaim& judged) {
  const Claim& claim = judged.claim;
  if (!claim.not_checkable.empty()) return html::text(claim.not_checkable);
  std::string text;
  const Check* before = nullptr;
  if (judged.verdict == Verdict::confirmed && !claim.printed.checks.empty())
    text = sentence(comparison_of(claim.printed, false));
  else
    for (const auto& [name, reading] :
         {std::pair{"Printed", &claim.printed}, {"Meant", &claim.meant}, {"Right", &claim.corrected}})
      if (!reading->checks.empty()) {
        text += (text.empty() ? "" : " ") + std::string(name) + ": " +
                (before ? comparison_next_to(*reading, *before) : comparison_of(*reading, true)) + ".";
        before = &hardest(*reading);
      }
  return text + near_misses_of(claim) + how_it_is_read(judged);
}

std::string id_attribute(const Claim& claim) { return " id=\"" + claim_anchor_of(claim) + "\""; }

/// Replaces a formula in a text by its markup.
std::string within(const std::string& text, const std::string& formula, const std::string& shown) {
  const std::size_t at = text.find(formula);
  const bool is_whole = at != std::string::npos && formula.starts_with('$');
  if (!is_whole) return html::text(text);
  return html::text(text.substr(0, at)) + shown + html::text(text.substr(at + formula.size()));
}

std::string sides(const JudgedClaim& judged) {
  const Reading& right = right_reading(judged);
  const Claim& claim = judged.claim;
  auto [as_printed, as_is_right] = html::texts_that_differ(claim.printed.text, right.text);
  if (shows_printed(claim)) as_printed = within(claim.says, claim.printed.text, as_printed);
  std::string text = element("div", " class=\"printed\"",
                             (judged.verdict == Verdict::lost ? "<dt>in our copy</dt>" : "<dt>printed</dt>") +
                                 element("dd", "", as_printed));
  if (&right != &judged.claim.printed)
    text += element("div", " class=\"corrected\"",
                    std::string(was_meant(judged.verdict) ? "<dt>meant</dt>" : "<dt>right</dt>") +
                        element("dd", "", as_is_right));
  return element("dl", " class=\"sides\"", text);
}

/// The mark of a claim proved by Coq. A summary contains no link, which would be confused with its own.
std::string mark_of(const Claim& claim, const ProvedClaims& proved, bool links = true) {
  return !proved.contains(claim.id) ? "" : links ? ", " + html::link("trust.html", "proved") : ", proved";
}

std::string finding_text(const JudgedClaim& judged, const ProvedClaims& proved) {
  const Claim& claim = judged.claim;
  const std::string kind = name_of(claim.kind).empty()
                               ? ""
                               : element("span", " class=\"kind\"", in_xml(name_of(claim.kind))) + ", ";
  return element("article", id_attribute(claim) + " class=\"" + class_of(judged.verdict) + "\"",
                 "<p class=\"meta\"><b>" + std::string(name_of(judged.verdict)) + "</b> " + kind +
                     html::text(place_of(claim)) + mark_of(claim, proved) + " " +
                     html::link("#" + claim_anchor_of(claim), in_xml(claim.id)) + "</p>" +
                     (shows_printed(claim)
                          ? ""
                          : element("p", "", "The solution states: " + html::text(as_sentence(claim.says)))) +
                     sides(judged) + element("p", "", html::prose(claim.why)) +
                     html::folded("Evidence", element("p", "", evidence_of(judged)))) +
         "\n";
}

std::string root_text(const Finding& finding, const ProvedClaims& proved) {
  std::string text = element("h3", "", html::text(finding.title())) + "\n";
  if (!finding.shows().empty()) text += element("p", " class=\"shows\"", html::prose(finding.shows())) + "\n";
  for (const JudgedClaim* c : finding.claims) text += finding_text(*c, proved);
  return element("section", " class=\"root\"", text) + "\n";
}

std::string others_text(const ExerciseResult& e, Verdict verdict, const std::string& title,
                        const ProvedClaims& proved) {
  std::string text;
  for (const JudgedClaim* c : claims_of(e, verdict)) text += finding_text(*c, proved);
  return text.empty() ? ""
                      : element("section", " class=\"root\"", element("h3", "", title) + "\n" + text) + "\n";
}

bool is_finding(Verdict verdict) {
  return verdict != Verdict::confirmed && verdict != Verdict::not_checkable;
}

/// The formula that the claim's text names but does not show.
std::string formula_of(const Claim& claim) {
  if (!is_formula(claim.printed.text) || shows_each_form(claim)) return "";
  return ": " + html::text(claim.printed.text);
}

std::string claim_text(const JudgedClaim& judged, const ProvedClaims& proved) {
  const Claim& claim = judged.claim;
  return element(
             "details",
             id_attribute(claim) +
                 (judged.verdict == Verdict::confirmed ? "" : " class=\"" + class_of(judged.verdict) + "\""),
             element("summary", "",
                     html::text(claim.says) + formula_of(claim) + " <small>" + html::text(place_of(claim)) +
                         mark_of(claim, proved, false) + "</small>") +
                 element("p", "", evidence_of(judged))) +
         "\n";
}

}  // namespace

std::string class_of(Verdict verdict) { return html::anchor(name_of(verdict)); }
std::string claim_anchor_of(const Claim& claim) { return html::anchor(claim.id); }

std::string findings_section(const ExerciseResult& e, const ProvedClaims& proved) {
  std::string text;
  for (const Finding& finding : findings_of(e)) text += root_text(finding, proved);
  text += others_text(e, Verdict::misprint, "Misprints", proved) +
          others_text(e, Verdict::unsettled, "Unsettled", proved);
  if (!text.empty())
    text = "<section id=\"findings\">\n<h2>What is wrong</h2>\n<div class=\"filter\"></div>\n" + text +
           "</section>\n";
  const std::string lost = others_text(e, Verdict::lost, "Fraction bars, exponents and signs", proved);
  if (!lost.empty())
    text +=
        "<section id=\"lost\">\n<h2>What our copy has lost</h2>\n<p>The solutions were read as plain text, "
        "which has lost these. The manual may have them, and the claims are right as they were meant.</p>\n" +
        lost + "</section>\n";
  return text;
}

std::string claims_section(const ExerciseResult& e, const ProvedClaims& proved) {
  std::string text;
  long confirmed = 0;
  for (const JudgedClaim& c : e.claims)
    if (!is_finding(c.verdict)) text += claim_text(c, proved), confirmed += c.verdict == Verdict::confirmed;
  if (text.empty()) return "";
  const bool marks = text.find(", proved</small>") != std::string::npos;
  return "<section id=\"claims\">\n<h2>" +
         std::string(confirmed == 0 ? "Claims that cannot be checked" : "Confirmed claims") + "</h2>\n<p>" +
         (confirmed == 0
              ? std::string("Open a claim to see why.")
              : counted(confirmed, "claim of the solution", "claims of the solution") +
                    ", each with its line" +
                    (marks ? ", and <em>proved</em> where " +
                                 html::link("trust.html", "the proof assistant Coq") + " has checked a proof"
                           : "") +
                    ". Open one to see its comparison.") +
         "</p>\n<div class=\"claims\">\n" + text + "</div>\n</section>\n";
}

}  // namespace oddity
