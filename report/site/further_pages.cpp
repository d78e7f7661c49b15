#include "report/site/further_pages.hpp"

#include <cmath>

#include "reference/text.hpp"
#include "report/site/claims_section.hpp"
#include "report/site/example.hpp"
#include "report/site/page.hpp"
#include "report/site/script.hpp"
#include "report/study/findings.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/markup.hpp"
#include "report/text/readable.hpp"
#include "report/text/screen.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

namespace {

using html::element;

std::string limit_text(double limit) {
  if (std::isnan(limit)) return "-";
  return std::isinf(limit) ? "all" : limit == 0 ? "none" : format_significant(limit, 5);
}

html::Table catalog_table() {
  html::Table table{"The catalog of algorithms",
                    {"algorithm", "library", "set by", "order", "evaluations per step", "real limit",
                     "imaginary limit", "theory"}};
  for (const ode::CatalogEntry& a : ode::catalog())
    table.rows.push_back(html::row(
        {element("span", " id=\"" + html::anchor(a.name) + "\"", in_xml(a.name)), in_xml(a.library),
         ode::has_tolerance(a.kind) ? "tolerance" : "step", a.order == 0 ? "varies" : std::to_string(a.order),
         (a.evaluations == 0 ? "varies" : std::to_string(a.evaluations)) + (a.jacobian ? " + Jacobian" : ""),
         limit_text(a.real_limit), limit_text(a.imaginary_limit), html::text(a.theory)},
        "356"));
  return table;
}

std::string library_findings() {
  std::string items;
  for (const ode::Finding& f : ode::findings())
    items += element("li", "",
                     "<b>" + in_xml(f.library) + " " + in_xml(f.version) + "</b>, " +
                         element("code", "", in_xml(f.in)) + ": " + html::text(f.found) + " <em>Here:</em> " +
                         html::text(f.done) + " <small>" +
                         element("code", "", "tests/libraries/" + in_xml(f.shown_by) + ".cpp") + "</small>") +
             "\n";
  return element("ul", " class=\"found\"", items);
}

/// One line, in letters that can be typed.
std::string searchable(std::string_view text) {
  std::string made = typed(text);
  std::erase(made, '\n');
  return made;
}

std::string to_example() { return html::link(example_name + std::string(".html"), "bouncing ball"); }

}  // namespace

std::string chooser_page(const Results& results, const SiteParts& parts) {
  const std::string choose = program_as_typed() + " choose";
  std::string scenes;
  for (const ExerciseResult& e : results.exercises)
    if (e.scene)
      scenes += element(
          "li", "", html::link(to_string(e.number) + ".html", to_string(e.number) + " " + in_xml(e.title)));
  return html::whole(
      {"Chooser - oddity",
       "<header class=\"title\">\n<h1>What to use for a scene</h1>\n<p class=\"asks\">Find the model, algorithm and "
       "step that hold for your start, error, frame rate and budget. " +
           std::string(parts.models
                           ? "The answer is computed in this page, by the models that were tested; <code>" +
                                 choose + "</code> judges it against references."
                           : "This copy of the page has no models: <code>" + choose + "</code> answers.") +
           "</p>\n</header>\n<div class=\"chooser\"><noscript><p>The chooser needs scripts. On a terminal: <code>" +
           choose +
           " 3.5 --error 1deg</code>.</p></noscript></div>\n<section>\n<h2>The scenes</h2>\n<ul class=\"scenes\">" +
           scenes + "</ul>\n<p>With events, and no exercise of the book: the " + to_example() +
           ".</p>\n</section>\n",
       {"assets/engine.js", "assets/models.js", "assets/findings.js", "assets/marks.js", "assets/diagrams.js",
        "assets/chart.js", "assets/typed.js", "assets/asking.js", "assets/searching.js", "assets/advice.js",
        "assets/chooser.js", "data/scenes.js"},
       "choose"});
}

std::string algorithms_page() {
  const std::string missing(ode::not_in_catalog());
  return html::whole(
      {"Algorithms - oddity",
       "<header class=\"title\">\n<h1>The algorithms</h1>\n<p class=\"asks\">Every algorithm that integrates a motion here "
       "has a certificate in the tests: its order is measured from both sides, its evaluations are counted, and its "
       "limits of stability are measured beside the theory that this table gives.</p>\n</header>\n<section>\n<h2>The "
       "catalog</h2>\n" +
           element("p", "",
                   html::text(
                       "A limit is the largest $h|\\lambda|$ at which $y'=\\lambda y$ does not grow, on the "
                       "negative real axis and on the imaginary axis.") +
                       (missing.empty() ? "" : " Not in this build: " + in_xml(missing) + ".")) +
           html::table(catalog_table()) + element("p", "", std::string(ode::work_of_series)) +
           element(
               "p", "",
               "Their behaviour at events, such as landings, is on the page of the " + to_example() + ".") +
           "</section>\n<section>\n<h2>What was found in the libraries</h2>\n<p>A small test of the library alone shows "
           "each finding, in the version that is named. What is wrong is repaired from outside.</p>\n" +
           library_findings() + "\n</section>\n",
       {}});
}

namespace {

using IndexRows = nlohmann::ordered_json;

void add_methods(IndexRows& all) {
  for (const ode::CatalogEntry& a : ode::catalog())
    all.push_back({"algorithms.html#" + html::anchor(a.name), "method", std::string(a.name),
                   std::string(a.library) +
                       (a.order == 0 ? ", varying order" : ", order " + std::to_string(a.order)) +
                       (ode::has_tolerance(a.kind) ? ", set by a tolerance" : ", set by a step")});
}

void add_pages(IndexRows& all) {
  const auto add = [&](const std::string& to, const std::string& title, const std::string& text) {
    all.push_back({to, "page", title, text});
  };
  add("lesson.html", "Why does Euler fail?",
      "A lesson: why explicit Euler fails and adds energy; symplectic Euler, Verlet and Runge-Kutta 4");
  add("recipes.html", "What do I use?",
      "For each scene the least model and algorithm in a game, and a matrix of scenes by methods");
  add("chooser.html", "Chooser", "The method for your own start, error, frame rate and budget");
  add("own.html", "Your own", "Type the equations of your own motion, and see which method is enough");
  add("algorithms.html", "Algorithms",
      "The catalog of integrators with their orders and limits of stability");
  add("trust.html", "Trust", "How the verdicts are checked: proofs by Coq, references, mutants, fuzzing");
  add("stability.html", "Stability", "Up to which step each method is stable, on every scene");
  add("engines.html", "Engines", "How Box2D, Bullet, MuJoCo and other physics engines do on the scenes");
  add("errata.html", "Errata sheet", "Everything that is wrong in the book, to print");
}

}  // namespace

/// Rows of [place, kind, title, text]; a claim's title is its place on the page.
std::string search_index(const Results& results) {
  IndexRows all = IndexRows::array();
  for (const ExerciseResult& e : results.exercises) {
    const std::string number = to_string(e.number), page = number + ".html";
    all.push_back({page, "exercise", number + " " + e.title, cut_at_word(searchable(e.asks), 140)});
    for (const Finding& finding : findings_of(e))
      if (finding.root)
        all.push_back({page + "#" + claim_anchor_of(finding.claims.front()->claim),
                       is_wrong(finding) ? "wrong" : "incomplete", number + " " + searchable(finding.title()),
                       searchable(finding.shows())});
    for (const JudgedClaim& c : e.claims)
      all.push_back(
          {page + "#" + claim_anchor_of(c.claim), name_of(c.verdict), "", searchable(c.claim.says)});
    for (const QuantityResult& q : e.quantities)
      all.push_back(
          {page + "#q-" + html::anchor(q.name), "quantity", number + " " + q.name, searchable(q.says)});
  }
  add_methods(all);
  add_pages(all);
  all.push_back({example_name + std::string(".html"), "example", std::string(example().exercise.title),
                 searchable(example().exercise.asks).substr(0, 140)});
  return packed_call("index", all);
}

}  // namespace oddity
