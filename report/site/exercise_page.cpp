#include "report/site/exercise_page.hpp"

#include <algorithm>
#include <utility>

#include "chapters/contents.hpp"
#include "reference/text.hpp"
#include "report/charts/drawing.hpp"
#include "report/site/claims_section.hpp"
#include "report/site/example.hpp"
#include "report/site/page.hpp"
#include "report/site/quantity_section.hpp"
#include "report/site/recipes.hpp"
#include "report/study/findings.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;

std::string page_of(const ExerciseResult& e) { return to_string(e.number) + ".html"; }

std::string setup_drawing(const ExerciseResult& e) {
  const Entry* entry = entry_of(e.number);
  std::string svg = entry ? setup_svg(*entry) : "";
  const std::size_t style = svg.find("<style>"), end = svg.find("</style>");
  if (end != std::string::npos) svg.erase(style, end + 9 - style);  // the page has its own style
  return svg.empty() ? "" : element("figure", " class=\"setup\"", svg.substr(svg.find("<svg"))) + "\n";
}

std::string chapter_line(const ExerciseResult& e) {
  for (const Chapter& chapter : chapters())
    if (chapter.number == e.number.chapter)
      return "Chapter " + std::to_string(chapter.number) + ", " + in_xml(chapter.title) +
             (of_the_book(e.number) ? "" : ", an exercise of one’s own");
  return "An exercise of one’s own";
}

/// The exercises before and after this one.
std::string neighbours(const Results& results, const ExerciseResult& e, const std::string& label) {
  const auto here = std::ranges::find(results.exercises, e.number, &ExerciseResult::number);
  const auto step = [](const ExerciseResult& to, const std::string& rel, const std::string& name) {
    return "<a rel=\"" + rel + "\" href=\"" + page_of(to) + "\">" + name + "</a>";
  };
  const auto named = [](const ExerciseResult& to) {
    return to_string(to.number) + " <span>" + in_xml(to.title) + "</span>";
  };
  std::string text;
  if (here != results.exercises.begin()) text += step(*(here - 1), "prev", "← " + named(*(here - 1)));
  if (here != results.exercises.end() && here + 1 != results.exercises.end())
    text += step(*(here + 1), "next", named(*(here + 1)) + " →");
  return element("nav", " class=\"neighbours\" aria-label=\"" + label + "\"", text) + "\n";
}

std::string counts_line(const ExerciseResult& e) {
  std::string text;
  for_each_count(counts_of(e), [&](const VerdictNoun& noun, int n) {
    text += "<span class=\"badge " + class_of(noun.verdict) + "\">" + counted(n, noun.one, noun.many) +
            "</span> ";
  });
  return element("p", " class=\"counts\"", text);
}

/// The right and the wrong parts of the solution, each finding as a link.
std::string verdict_line(const ExerciseResult& e) {
  const std::string text =
      verdict_of(e, {[](const Finding& f, const std::string& words) {
                       return html::link("#" + claim_anchor_of(f.claims.front()->claim), html::text(words));
                     },
                     [](const std::string& words) { return html::text(words); }});
  return text.empty() ? "" : element("p", " class=\"verdict\"", text) + "\n";
}

std::string letter_of(const ParameterValue& p) {
  return "<var>" + in_xml(p.name) + "</var> = " + format_significant(p.value, 6) +
         (p.unit.empty() || p.unit == "1" ? "" : " " + in_xml(typeset_unit(p.unit)));
}

/// The parameters. Several in a row with the same meaning share a line.
std::string letters_of(const ExerciseResult& e) {
  if (e.parameters.empty()) return "";
  std::string text;
  for (std::size_t i = 0, next = 0; i < e.parameters.size(); i = next) {
    const ParameterValue& first = e.parameters[i];
    std::string letters = letter_of(first);
    for (next = i + 1; next < e.parameters.size() && e.parameters[next].says == first.says; ++next)
      letters += ", " + letter_of(e.parameters[next]);
    text += "<div>" + element("dt", "", letters) + element("dd", "", html::text(first.says)) + "</div>";
  }
  return element("dl", " class=\"letters\"", text) + "\n";
}

std::string sections_of(const std::string& body) {
  const std::pair<const char*, const char*> all[] = {{"play", "Play"},      {"recipe", "What to use"},
                                                     {"events", "Events"},  {"findings", "What is wrong"},
                                                     {"claims", "Claims"},  {"quantities", "Computing it"},
                                                     {"stability", "Steps"}};
  std::string text;
  for (const auto& [id, name] : all)
    if (body.find("<section id=\"" + std::string(id) + "\"") != std::string::npos)
      text += html::link("#" + std::string(id), name);
  return element("nav", " class=\"sections\" aria-label=\"On this page\"", text) + "\n";
}

std::string player_section(const ExerciseResult& e) {
  if (!e.scene) return "";
  const std::string command =
      " The motion as numbers: <code>" + program_as_typed() + " solve " + to_string(e.number) + "</code>.";
  return "<section id=\"play\" class=\"player\" aria-label=\"Player\"><noscript><p>The player needs scripts." +
         (e.number == example().number ? "" : command) + "</p></noscript></section>\n";
}

/// In the order of their dependencies.
std::vector<std::string> scripts_of(const ExerciseResult& e, const std::string& name) {
  std::vector<std::string> scripts{"data/" + name + ".js"};
  const auto add = [&](std::initializer_list<std::string_view> names) {
    for (std::string_view asset : names) scripts.push_back("assets/" + std::string(asset) + ".js");
  };
  if (e.scene)
    add({"typed", "engine", "models", "stage", "scale", "frames", "permalink", "motions", "slider", "lines",
         "portrait", "rows", "breaking", "clock", "picture", "player"});
  if (!e.quantities.empty()) add({"findings", "marks", "diagrams", "chart", "trials"});
  if (e.stability) add({"map"});
  return scripts;
}

constexpr std::string_view of_events =
    R"(<section id="events">
<h2>Events</h2>
<p>A model defines its events: when its guard, here the height, falls through zero, the ball goes on upward with the
part <var>e</var> of its speed. A method finds that time by shorter steps inside its step, so that the landing is as
accurate as the method.</p>
<ul>
<li><b>ball</b>: each landing comes sooner than the last, until numbers cannot separate their times. There the motion
ends as <em>chattering</em>, at the time at which the true ball comes to rest. Explicit Euler does not get there: each
of its flights is a step too long, so its ball goes on hopping.</li>
<li><b>ball, at rest below 1 cm/s</b>: as in engines. A ball that comes up so slowly stays on the floor, at most 5 µm
from the truth, and the motion goes on.</li>
</ul>
</section>
)";

}  // namespace

std::string exercise_page(const Results& results, const ExerciseResult& e, const ProvedClaims& proved,
                          std::span<const EngineContest> contests) {
  const std::string number = to_string(e.number), drawing = setup_drawing(e);
  const std::string sections = player_section(e) + recipe_section(e, contests) + findings_section(e, proved) +
                               claims_section(e, proved) + quantities_section(e) + stability_section(e);
  std::string head = element("p", " class=\"where\"", chapter_line(e)) + "\n<h1><span>" + number +
                     "</span> " + in_xml(e.title) + "</h1>\n" + counts_line(e) + "\n" +
                     element("p", " class=\"asks\"", html::prose(e.asks)) + "\n";
  if (e.failure.empty())
    head += verdict_line(e);
  else
    head += element("p", " class=\"failure\"", "The study failed: " + in_xml(e.failure));
  return html::whole(
      {number + " " + e.title + " - oddity",
       neighbours(results, e, "The exercises before and after") +
           element("header", " class=\"title\"", "<div>" + head + letters_of(e) + "</div>\n" + drawing) +
           "\n" + sections_of(sections) + sections + neighbours(results, e, "Go on"),
       scripts_of(e, number), "exercise"});
}

std::string example_page(const ExerciseResult& e) {
  const std::string sections = player_section(e) + std::string(of_events) + quantities_section(e);
  const std::string head = "<p class=\"where\">An example, and no exercise of the book</p>\n" +
                           element("h1", "", in_xml(e.title)) + "\n" +
                           element("p", " class=\"asks\"", html::prose(e.asks)) + "\n";
  return html::whole(
      {e.title + " - oddity",
       element("header", " class=\"title\"", "<div>" + head + letters_of(e) + "</div>\n" + setup_drawing(e)) +
           "\n" + sections_of(sections) + sections,
       scripts_of(e, example_name), "exercise"});
}

}  // namespace oddity
