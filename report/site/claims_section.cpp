#include "report/site/claims_section.hpp"

#include <cmath>

#include "reference/text.hpp"
#include "report/pages/markup.hpp"
#include "report/pages/text_view.hpp"
#include "report/site/findings.hpp"
#include "report/site/page.hpp"

namespace oddity {

namespace {

using html::element;

std::string number_text(double x, int digits) {
  return std::isfinite(x) ? with_powers(rounded(x, digits)) : std::isnan(x) ? "not a number" : "infinite";
}

std::string value_text(const Value& value) { return html::escaped(with_powers(shown(value, 7))); }
std::string words(const std::string& text) { return html::text(with_powers(with_short_numbers(text))); }

std::string class_of(Verdict verdict) { return html::anchor(name_of(verdict)); }

std::string badge(Verdict verdict) {
  return element("span", " class=\"badge " + class_of(verdict) + "\"", name_of(verdict));
}

/// "3 of 200 samples are against it".
std::string violations_text(const Check& c) {
  const std::string of = c.left.by.substr(std::string("violations in ").size());
  return c.left.value[0] == 0 ? "none of " + of + " is against it"
                              : rounded(c.left.value[0], 12) + " of " + of +
                                    (c.left.value[0] == 1 ? " is against it" : " are against it");
}

bool is_count(const Check& c) { return c.right.by == "none" && c.left.by.starts_with("violations in "); }

std::string difference_text(const Check& c) {
  const double difference = c.difference();
  if (!std::isfinite(difference)) return "they cannot be compared";
  if (difference == 0) return "they are equal";
  return "they differ by " + number_text(difference, 2) +
         (c.tolerance.allowed == 0 ? ", and must not"
                                   : ", and may by " + number_text(c.tolerance.allowed, 2) + " (" +
                                         words(c.tolerance.reason) + ")");
}

/// What was compared with what, and how it came out.
std::string check_text(const Check& c, const std::string& told, const std::string& reading) {
  const std::string mark = c.holds() ? "<b class=\"holds\">holds</b> " : "<b class=\"fails\">fails</b> ";
  const std::string what = c.quantity == told ? "" : words(c.quantity) + ": ";
  const std::string where = c.where.empty() ? "" : " <small>" + words(c.where) + "</small>";
  if (is_count(c)) return element("li", "", mark + what + html::escaped(violations_text(c)) + where);
  const std::string left = c.left.by == reading ? "so" : words(c.left.by);
  return element("li", "",
                 mark + what + left + ", <b>" + value_text(c.left.value) + "</b>; " + words(c.right.by) +
                     ", <b>" + value_text(c.right.value) + "</b>; " + difference_text(c) + "." + where);
}

std::string reading_text(const std::string& name, const Reading& reading, const std::string& told) {
  if (reading.checks.empty()) return "";
  std::string checks;
  for (const Check& c : reading.checks) checks += check_text(c, told, reading.text);
  return element("p", "", name + ": " + words(reading.text)) + element("ul", "", checks);
}

std::string evidence_of(const Claim& claim) {
  if (!claim.not_checkable.empty()) return element("p", "", html::text(claim.not_checkable));
  std::string text = reading_text("As printed", claim.printed, claim.says) +
                     reading_text("As meant", claim.meant, claim.says) +
                     reading_text("Corrected", claim.corrected, claim.says);
  std::string near;
  for (const Reading& reading : claim.near_misses) near += (near.empty() ? "" : "; ") + words(reading.text);
  if (!near.empty()) text += element("p", " class=\"near\"", "The same comparison refuses: " + near + ".");
  return text;
}

std::string id_attribute(const Claim& claim) { return " id=\"" + claim_anchor_of(claim) + "\""; }

std::string sides(const JudgedClaim& judged) {
  const Reading& right = right_reading(judged);
  std::string text = element("div", " class=\"printed\"",
                             "<dt>printed</dt>" + element("dd", "", html::text(judged.claim.printed.text)));
  if (&right != &judged.claim.printed)
    text += element("div", " class=\"corrected\"",
                    std::string(judged.verdict == Verdict::misprint ? "<dt>meant</dt>" : "<dt>right</dt>") +
                        element("dd", "", html::text(right.text)));
  return element("dl", " class=\"sides\"", text);
}

std::string finding_text(const JudgedClaim& judged) {
  const Claim& claim = judged.claim;
  const std::string kind = claim.kind == Fault::none ? "" : std::string(name_of(claim.kind)) + ", ";
  return element("article", id_attribute(claim) + " class=\"finding " + class_of(judged.verdict) + "\"",
                 "<p class=\"meta\">" + badge(judged.verdict) + " " + kind + "line " +
                     std::to_string(claim.line) + " " +
                     html::link("#" + claim_anchor_of(claim), html::escaped(claim.id)) + "</p>" +
                     element("p", " class=\"says\"", "The solution says: " + html::text(claim.says) + ".") +
                     sides(judged) + element("p", "", html::prose(claim.why))) +
         "\n";
}

std::string root_text(const Finding& finding) {
  std::string text = element("h3", "", html::text(finding.title())) + "\n";
  if (!finding.shows().empty()) text += element("p", " class=\"shows\"", html::prose(finding.shows())) + "\n";
  for (const JudgedClaim* c : finding.claims) text += finding_text(*c);
  return element("section", " class=\"root\"", text) + "\n";
}

std::string others_text(const ExerciseResult& e, Verdict verdict, const std::string& title) {
  std::string text;
  for (const JudgedClaim* c : claims_of(e, verdict)) text += finding_text(*c);
  return text.empty() ? ""
                      : element("section", " class=\"root\"", element("h3", "", title) + "\n" + text) + "\n";
}

bool has_finding(Verdict verdict) {
  return verdict == Verdict::erratum || verdict == Verdict::misprint || verdict == Verdict::unsettled;
}

std::string claim_text(const JudgedClaim& judged) {
  const Claim& claim = judged.claim;
  const bool above = has_finding(judged.verdict);
  const std::string attributes =
      (above ? std::string() : id_attribute(claim)) + " class=\"claim\" data-verdict=\"" +
      class_of(judged.verdict) + "\"" +
      (claim.kind == Fault::none ? "" : " data-kind=\"" + std::string(name_of(claim.kind)) + "\"");
  const std::string summary = badge(judged.verdict) + "<span>" + html::text(claim.says) +
                              "</span><small>line " + std::to_string(claim.line) + "</small>";
  const std::string finding =
      above ? element("p", "", html::link("#" + claim_anchor_of(claim), "What is wrong with it")) : "";
  return element("details", attributes, element("summary", "", summary) + finding + evidence_of(claim)) +
         "\n";
}

}  // namespace

std::string claim_anchor_of(const Claim& claim) { return html::anchor(claim.id); }

std::string findings_section(const ExerciseResult& e) {
  std::string text;
  for (const Finding& finding : findings_of(e)) text += root_text(finding);
  text += others_text(e, Verdict::misprint, "Misprints") + others_text(e, Verdict::unsettled, "Unsettled");
  if (text.empty()) return "";
  return "<section id=\"findings\">\n<h2>What is wrong</h2>\n" + text + "</section>\n";
}

std::string claims_section(const ExerciseResult& e) {
  if (e.claims.empty()) return "";
  std::string text;
  for (const JudgedClaim& c : e.claims) text += claim_text(c);
  return "<section id=\"claims\">\n<h2>What the solution says</h2>\n<p>" +
         counted(static_cast<long>(e.claims.size()), "claim", "claims") +
         ", in the order of the solution’s lines. Each opens to what was compared with what.</p>\n"
         "<div class=\"filter\" data-of=\"claim\"></div>\n<div class=\"claims\">\n" +
         text + "</div>\n</section>\n";
}

}  // namespace oddity
