#include "report/site/own_page.hpp"

#include "problem/file.hpp"
#include "report/pages/code.hpp"
#include "report/site/page.hpp"
#include "report/site/script.hpp"
#include "report/site/site.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

/// The program's own answer on the file as it was given. It stays while one types.
std::string answered(const OwnFile& of) {
  if (of.answer.empty()) return "";
  return html::element("p", " class=\"own-chosen\"",
                       "For this file as it was given, <code>" + program_as_typed() +
                           " choose</code> reports, by true motions from two routes: " +
                           in_xml(of.answer.substr(0, of.answer.find('\n')))) +
         "\n";
}

}  // namespace

std::string own_page(const SiteParts& parts, const OwnFile& of) {
  const std::string program = program_as_typed();
  const std::string title = of.title.empty() ? "Equations of your own" : of.title;
  std::string body =
      "<header class=\"title\">\n" + html::element("h1", "", in_xml(title)) +
      "\n<p class=\"asks\">Type a motion’s equations, or its "
      "Lagrangian, with units: the page moves it, shows the error of each method, and finds the cheapest that is "
      "enough. It judges claims, too. Nothing leaves the page. A file that works here works on a command line: <code>" +
      program + " choose FILE</code>.</p>\n" + answered(of) + "</header>\n";
  if (!parts.models)
    return html::whole({title + " - oddity",
                        body + "<p>This copy of the page cannot read files: <code>" + program +
                            " new my.toml</code> begins one, and <code>" + program +
                            " choose my.toml</code> answers it.</p>\n",
                        {},
                        "yours"});
  body +=
      "<div class=\"own\"><noscript><p>The page needs scripts. On a terminal: <code>" + program +
      " new my.toml</code>, and <code>" + program +
      " choose my.toml</code>.</p></noscript></div>\n<section>\n<h2>What a file has</h2>\n"
      "<ul>\n<li>A unit follows a numeral, as in <code>5 cm</code>; a product of letters has a blank or a star, as in "
      "<code>m g</code>; a rate in time has a prime, as in <code>y'</code>.</li>\n"
      "<li>Letters are declared in <code>[parameters]</code> with a value, a unit and perhaps a range; abbreviations in "
      "<code>[given]</code>; rows of numbers, for a drive or a force, in <code>[tables]</code>.</li>\n"
      "<li>A model has <code>equations</code> or a <code>lagrangian</code>, and a <code>start</code>. Of several the last is "
      "taken for true. A list makes a vector, as in <code>start = { r = [\"1 m\", 0], ... }</code>.</li>\n"
      "<li><code>[observe]</code> says what is seen, <code>[need]</code> which error is allowed, and for how long.</li>\n"
      "<li>A <code>[[claim]]</code> has what is <code>printed</code>, and its <code>truth</code> by another route.</li>\n"
      "</ul>\n<p><code>" +
      program + " new my.toml</code> writes a commented file.</p>\n</section>\n";
  return html::whole(
      {title + " - oddity",
       body,
       {"assets/engine.js",   "assets/own.js",       "assets/typed.js",     "assets/frames.js",
        "assets/scale.js",    "assets/slider.js",    "assets/stage.js",     "assets/lines.js",
        "assets/portrait.js", "assets/clock.js",     "assets/picture.js",   "assets/rows.js",
        "assets/breaking.js", "assets/motions.js",   "assets/permalink.js", "assets/player.js",
        "assets/problem.js",  "assets/enough.js",    "assets/file_link.js", "assets/claims.js",
        "assets/program.js",  "assets/own_table.js", "assets/typing.js",    "data/problems.js"},
       "yours"});
}

std::string own_examples(const OwnFile& of) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array(), programs;
  if (!of.text.empty()) files.push_back({{"title", of.title}, {"text", of.text}});
  for (const EmbeddedFile& file : embedded_problems()) {
    const auto read = problem::read(std::string(file.path), std::string(file.text));
    files.push_back({{"title", read->title}, {"text", std::string(file.text)}});
  }
  // Leaves out semi-implicit Euler: its loop solves for its unknowns in many lines. Others are as cheap.
  for (const std::string_view algorithm : printable_algorithms())
    if (algorithm != "semi-implicit Euler") programs[std::string(algorithm)] = program_template(algorithm);
  return packed_call("problems",
                     {{"files", files}, {"programs", programs}, {"taken", problem::names_with_meaning()}});
}

}  // namespace oddity
