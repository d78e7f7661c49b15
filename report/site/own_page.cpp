#include "report/site/own_page.hpp"

#include "problem/file.hpp"
#include "report/site/page.hpp"
#include "report/site/script.hpp"
#include "report/site/site.hpp"
#include "report/study/beside_program.hpp"

namespace oddity {

std::string own_page(const SiteParts& parts) {
  const std::string program = program_as_typed();
  std::string body =
      "<header class=\"title\">\n<h1>Equations of your own</h1>\n<p class=\"asks\">Type a motion’s equations, or its "
      "Lagrangian, with units: the page moves it, shows what each method errs, and finds the cheapest that is "
      "enough. Nothing leaves the page. A file that works here works on a command line: <code>" +
      program + " choose FILE</code>.</p>\n</header>\n";
  if (!parts.models)
    return html::whole({"Your own - oddity",
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
      "<code>[given]</code>.</li>\n"
      "<li>A model has <code>equations</code> or a <code>lagrangian</code>, and a <code>start</code>. Of several the last is "
      "taken for true.</li>\n"
      "<li><code>[observe]</code> says what is seen, <code>[need]</code> which error is allowed, and for how long.</li>\n"
      "</ul>\n<p><code>" +
      program +
      " new my.toml</code> writes a commented file. Tables of numbers, and the claims of a file, are for the "
      "command line.</p>\n</section>\n";
  return html::whole({"Your own - oddity",
                      body,
                      {"assets/engine.js",   "assets/own.js",     "assets/typed.js",     "assets/frames.js",
                       "assets/scale.js",    "assets/slider.js",  "assets/stage.js",     "assets/lines.js",
                       "assets/portrait.js", "assets/clock.js",   "assets/picture.js",   "assets/rows.js",
                       "assets/breaking.js", "assets/motions.js", "assets/permalink.js", "assets/player.js",
                       "assets/problem.js",  "assets/enough.js",  "assets/file_link.js", "assets/typing.js",
                       "data/problems.js"},
                      "yours"});
}

std::string own_examples() {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const EmbeddedFile& file : embedded_problems()) {
    const auto read = problem::read(std::string(file.path), std::string(file.text));
    if (!read->models.empty() && read->tables.empty())
      all.push_back({{"title", read->title}, {"text", std::string(file.text)}});
  }
  return packed_call("problems", all);
}

}  // namespace oddity
