#include "report/site/errata.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "chapters/contents.hpp"
#include "report/site/claims_section.hpp"
#include "report/site/page.hpp"
#include "report/study/findings.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;
using List = nlohmann::ordered_json;

/// Version of errata.json. Version 2 separates wrong and incomplete claims, and losses in our copy;
/// version 1 called them errata and misprints.
constexpr int errata_version = 2;

List finite_or_null(double x) { return std::isfinite(x) ? List(x) : List(nullptr); }

/// The error of the printed version in the check that it fails worst.
List margin_of(const Claim& claim) {
  const Check* worst = nullptr;
  const auto excess = [](const Check& c) { return c.difference() / c.tolerance.allowed; };
  for (const Check& c : claim.printed.checks)
    if (!c.holds() && (!worst || excess(c) > excess(*worst))) worst = &c;
  if (!worst) return nullptr;
  return {{"differs_by", finite_or_null(worst->difference())},
          {"allowed", finite_or_null(worst->tolerance.allowed)}};
}

const Root* root_of(const ExerciseResult& e, const Claim& claim) {
  for (const Root& root : e.roots)
    if (root.name == claim.root) return &root;
  return nullptr;
}

List entry_of(const ExerciseResult& e, const JudgedClaim& judged) {
  const Claim& claim = judged.claim;
  const Root* root = root_of(e, claim);
  return {{"id", claim.id},
          {"exercise", to_string(e.number)},
          {"verdict", name_of(judged.verdict)},
          {"kind", name_of(claim.kind)},
          {"root", claim.root},
          {"line", claim.line},
          {"place", claim.place},
          {"says", claim.says},
          {"printed", claim.printed.text},
          {"right", right_reading(judged).text},
          {"why", claim.why},
          {"consequence", root ? root->shows : ""},
          {"margin", margin_of(claim)},
          {"command", "oddity verify '[" + to_string(e.number) + "]'"},
          {"page", to_string(e.number) + ".html#" + claim_anchor_of(claim)}};
}

bool is_listed(const JudgedClaim& c) { return is_erratum(c.verdict) || c.verdict == Verdict::misprint; }
bool is_lost(const JudgedClaim& c) { return c.verdict == Verdict::lost; }

/// The claims, one per line.
std::string list_of(const Results& results, bool (*is)(const JudgedClaim&)) {
  std::string all;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims)
      if (is(c))
        all += (all.empty() ? "\n" : ",\n") +
               entry_of(e, c).dump(-1, ' ', false, List::error_handler_t::replace);
  return "[" + all + "\n]";
}

/// The solution's statement, with the wrong printed part where that is not obvious.
std::string printed_text(const Claim& claim, const std::string& as_printed) {
  return html::text(claim.says) + (shows_printed(claim) ? "" : " <b>" + as_printed + "</b>");
}

std::string sheet_row(const JudgedClaim& judged, const ExerciseResult& e) {
  const std::string to = to_string(e.number) + ".html#" + claim_anchor_of(judged.claim);
  const auto [as_printed, as_is_right] =
      html::texts_that_differ(judged.claim.printed.text, right_reading(judged).text);
  return "<tr class=\"" + class_of(judged.verdict) + "\">" +
         element("th", " scope=\"row\"",
                 html::link(to, judged.claim.place.empty() ? std::to_string(judged.claim.line)
                                                           : in_xml(judged.claim.place))) +
         element("td", "", printed_text(judged.claim, as_printed)) + element("td", "", as_is_right) +
         "</tr>\n";
}

std::string sheet_of(const ExerciseResult& e) {
  std::string rows;
  for (const JudgedClaim& c : e.claims)
    if (is_listed(c)) rows += sheet_row(c, e);
  if (rows.empty()) return "";
  return "<tbody>\n<tr class=\"exercise\"><th colspan=\"3\" scope=\"rowgroup\">" + to_string(e.number) + " " +
         in_xml(e.title) + "</th></tr>\n" + rows + "</tbody>\n";
}

}  // namespace

std::string errata_json(const Results& results) {
  return "{\"$schema\": \"errata.schema.json\",\n\"version\": " + std::to_string(errata_version) +
         ",\n\"book\": \"Game Physics, 2nd edition: the solutions manual\",\n\"errata\": " +
         list_of(results, is_listed) + ",\n\"lost_in_our_copy\": " + list_of(results, is_lost) + "}\n";
}

std::string errata_schema() {
  List kinds = List::array({""});
  for (Fault kind : {Fault::number, Fault::formula, Fault::left_out, Fault::counterexample, Fault::term,
                     Fault::listing, Fault::lost_typography})
    kinds.push_back(name_of(kind));
  const List string{{"type", "string"}}, said{{"type", "string"}, {"minLength", 1}},
      number{{"type", {"number", "null"}}};
  const auto described = [](List schema, const char* description) {
    schema["description"] = description;
    return schema;
  };
  const auto matching = [](const char* pattern) { return List{{"type", "string"}, {"pattern", pattern}}; };
  const List properties{
      {"id", described(matching("^[0-9]+\\.[0-9]+-"), "the claim, which keeps this name")},
      {"exercise", matching("^[0-9]+\\.[0-9]+$")},
      {"verdict",
       described({{"enum", {"wrong", "incomplete", "misprint", "lost in our copy"}}},
                 "wrong: the printed text is false; incomplete: it lacks a case or condition; misprint: the "
                 "intended text is plain and right; lost in our copy: the copy lacks a part")},
      {"kind", described({{"enum", kinds}}, "kind of fault")},
      {"root", described(string, "its cause, shared by errata of one cause; empty: a separate cause")},
      {"line", described({{"type", "integer"}, {"minimum", 0}}, "in the solutions document as plain text")},
      {"place",
       described(string,
                 "where a reader of the manual finds it: an equation's number, a paragraph, a listing")},
      {"says", described(said, "the claim in our words; TeX between dollars, code between backquotes")},
      {"printed", said},
      {"right", said},
      {"why", said},
      {"consequence", described(string, "visible effect of the root; empty: not stated")},
      {"margin",
       {{"type", {"object", "null"}},
        {"description", "largest error of the printed version, and the allowed one"},
        {"required", {"differs_by", "allowed"}},
        {"properties", {{"differs_by", number}, {"allowed", number}}},
        {"additionalProperties", false}}},
      {"command", described(matching("^oddity "), "judges it again")},
      {"page", described(matching("^[0-9]+\\.[0-9]+\\.html#"), "its section on the site")}};
  List required = List::array();
  for (const auto& [name, schema] : properties.items()) required.push_back(name);
  const List entries{{"type", "array"},
                     {"items",
                      {{"type", "object"},
                       {"required", required},
                       {"properties", properties},
                       {"additionalProperties", false}}}};
  return List{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Errors in the solutions manual of Game Physics"},
              {"type", "object"},
              {"required", {"version", "book", "errata", "lost_in_our_copy"}},
              {"properties",
               {{"$schema", string},
                {"version", {{"const", errata_version}}},
                {"book", said},
                {"errata", entries},
                {"lost_in_our_copy", entries}}},
              {"additionalProperties", false}}
             .dump(1) +
         "\n";
}

std::string errata_page(const Results& results) {
  Counts all = counts_of(results);
  std::string chapters_text;
  for (const Chapter& chapter : chapters()) {
    std::string groups;
    for (const ExerciseResult& e : results.exercises)
      if (e.number.chapter == chapter.number) groups += sheet_of(e);
    if (groups.empty()) continue;
    const std::string title = std::to_string(chapter.number) + ". " + in_xml(chapter.title);
    chapters_text +=
        "<section>\n" + element("h2", "", title) +
        "\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + title +
        "\"><table class=\"sheet\">" + element("caption", "", title) +
        "<thead><tr><th scope=\"col\">where</th><th scope=\"col\">the solution says</th><th scope=\"col\">right</th></tr></thead>\n" +
        groups + "</table></div>\n</section>\n";
  }
  return html::whole(
      {"Errata sheet - oddity",
       "<header class=\"title\">\n<h1>Errata of the solutions manual</h1>\n<p class=\"asks\"><cite>Game Physics</cite>, "
       "2nd edition, odd exercises: " +
           counted(all[Verdict::wrong], "claim that is wrong", "claims that are wrong") + ", " +
           std::to_string(all[Verdict::incomplete]) +
           " that leave out a case or a condition (marked ◦), and " +
           counted(all[Verdict::misprint], "misprint", "misprints") +
           " (marked ·), whose intended text is plain. Lines are those of the solutions document as plain text. "
           "Losses in that text are no fault of the manual and are not listed.</p>\n<p class=\"screen\">This page prints as a sheet to lay into the book. "
           "For programs: <a href=\"errata.json\">errata.json</a>, with its <a "
           "href=\"errata.schema.json\">schema</a>.</p>\n</header>\n" +
           chapters_text,
       {},
       "errata"});
}

}  // namespace oddity
