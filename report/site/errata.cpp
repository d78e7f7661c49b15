#include "report/site/errata.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "chapters/contents.hpp"
#include "report/pages/markup.hpp"
#include "report/site/claims_section.hpp"
#include "report/site/page.hpp"
#include "report/study/findings.hpp"

namespace oddity {

namespace {

using html::element;
using List = nlohmann::ordered_json;

List finite_or_null(double x) { return std::isfinite(x) ? List(x) : List(nullptr); }

/// How far the printed version is off in the check that it fails worst.
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
          {"says", claim.says},
          {"printed", claim.printed.text},
          {"right", right_reading(judged).text},
          {"why", claim.why},
          {"consequence", root ? root->shows : ""},
          {"margin", margin_of(claim)},
          {"command", "oddity verify '[" + to_string(e.number) + "]'"},
          {"page", to_string(e.number) + ".html#" + claim_anchor_of(claim)}};
}

bool is_listed(const JudgedClaim& c) {
  return c.verdict == Verdict::erratum || c.verdict == Verdict::misprint;
}

/// What the solution says, and what of it is wrong as printed where that is not plain.
std::string printed_text(const Claim& claim) {
  return html::text(claim.says) +
         (says_what_is_printed(claim) ? "" : " <b>" + html::text(claim.printed.text) + "</b>");
}

std::string sheet_row(const JudgedClaim& judged, const ExerciseResult& e) {
  const std::string to = to_string(e.number) + ".html#" + claim_anchor_of(judged.claim);
  return "<tr class=\"" + std::string(name_of(judged.verdict)) + "\">" +
         element("th", " scope=\"row\"", html::link(to, std::to_string(judged.claim.line))) +
         element("td", "", printed_text(judged.claim)) +
         element("td", "", html::text(right_reading(judged).text)) + "</tr>\n";
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
  std::string all;  // one a line
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims)
      if (is_listed(c))
        all += (all.empty() ? "\n" : ",\n") +
               entry_of(e, c).dump(-1, ' ', false, List::error_handler_t::replace);
  return "{\"$schema\": \"errata.schema.json\",\n\"book\": \"Game Physics, 2nd edition: the solutions manual\",\n"
         "\"errata\": [" +
         all + "\n]}\n";
}

std::string errata_schema() {
  List kinds = List::array({""});
  for (Fault kind : {Fault::number, Fault::formula, Fault::left_out, Fault::counterexample, Fault::term,
                     Fault::listing, Fault::lost_typography})
    kinds.push_back(name_of(kind));
  const List string{{"type", "string"}}, said{{"type", "string"}, {"minLength", 1}},
      number{{"type", {"number", "null"}}};
  const auto told = [](List schema, const char* description) {
    schema["description"] = description;
    return schema;
  };
  const auto matching = [](const char* pattern) { return List{{"type", "string"}, {"pattern", pattern}}; };
  const List properties{
      {"id", told(matching("^[0-9]+\\.[0-9]+-"), "the claim, which keeps this name")},
      {"exercise", matching("^[0-9]+\\.[0-9]+$")},
      {"verdict",
       told({{"enum", {"erratum", "misprint"}}},
            "misprint: what was meant is plain and right; erratum: only a corrected statement is")},
      {"kind", told({{"enum", kinds}}, "what is at fault")},
      {"root", told(string, "what it comes from, shared by errata of one cause; empty: it stands alone")},
      {"line", told({{"type", "integer"}, {"minimum", 0}}, "in the solutions document as plain text")},
      {"says", told(said, "the claim in our words; TeX between dollars, code between backquotes")},
      {"printed", said},
      {"right", said},
      {"why", said},
      {"consequence", told(string, "of the root: what one would see of it; empty: nothing is said")},
      {"margin",
       {{"type", {"object", "null"}},
        {"description", "by how much the printed version is off where it is worst, and what is allowed"},
        {"required", {"differs_by", "allowed"}},
        {"properties", {{"differs_by", number}, {"allowed", number}}},
        {"additionalProperties", false}}},
      {"command", told(matching("^oddity "), "judges it again")},
      {"page", told(matching("^[0-9]+\\.[0-9]+\\.html#"), "where the site tells more")}};
  List required = List::array();
  for (const auto& [name, schema] : properties.items()) required.push_back(name);
  return List{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "What is wrong in the solutions manual of Game Physics"},
              {"type", "object"},
              {"required", {"book", "errata"}},
              {"properties",
               {{"$schema", string},
                {"book", said},
                {"errata",
                 {{"type", "array"},
                  {"items",
                   {{"type", "object"},
                    {"required", required},
                    {"properties", properties},
                    {"additionalProperties", false}}}}}}},
              {"additionalProperties", false}}
             .dump(1) +
         "\n";
}

std::string errata_page(const Results& results) {
  Tally all;
  std::string chapters_text;
  for (const ExerciseResult& e : results.exercises) all.count(e);
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
        "<thead><tr><th scope=\"col\">line</th><th scope=\"col\">the solution says</th><th scope=\"col\">right</th></tr></thead>\n" +
        groups + "</table></div>\n</section>\n";
  }
  return html::whole(
      {"Errata sheet - oddity",
       "<header class=\"title\">\n<h1>Errata of the solutions manual</h1>\n<p class=\"asks\"><cite>Game Physics</cite>, "
       "2nd edition, odd exercises: " +
           counted(all.errata, "erratum", "errata") + " and " +
           counted(all.misprints, "misprint", "misprints") +
           ", by chapter and line of the solutions document as plain text. Of a misprint, set in italics here, what "
           "was meant is plain, and right.</p>\n<p class=\"screen\">This page prints as a sheet to lay into the book. "
           "For programs: <a href=\"errata.json\">errata.json</a>, with its <a "
           "href=\"errata.schema.json\">schema</a>.</p>\n</header>\n" +
           chapters_text,
       {},
       "errata"});
}

}  // namespace oddity
