#include "report/site/page.hpp"

#include <algorithm>
#include <cctype>

#include "chapters/typeset.hpp"
#include "report/site/formulas.hpp"
#include "report/site/site.hpp"
#include "report/study/embedded.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/markup.hpp"

namespace oddity::html {

namespace {

std::string marked_up(std::string_view text, bool emphasis) {
  std::string made;
  while (!text.empty()) {
    const char c = text.front();
    const bool opens = c == '$' || c == '`' || (c == '*' && emphasis);
    const auto end = opens ? text.find(c, 1) : std::string_view::npos;
    if (end == std::string_view::npos || end == 1) {
      made += in_xml(text.substr(0, 1));
      text.remove_prefix(1);
      continue;
    }
    const std::string_view inside = text.substr(1, end - 1);
    made += c == '$'   ? formula(inside)
            : c == '`' ? element("code", "", in_xml(inside))
                       : element("em", "", marked_up(inside, false));
    text.remove_prefix(end + 1);
  }
  return made;
}

/// Allows only the site's own files; engine.js compiles the models.
constexpr std::string_view policy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src data:; base-uri 'none'; "
    "form-action 'none'";

std::string head_of(const Page& page) {
  std::string head =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
      std::string(policy) +
      "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
      in_xml(page.title) + "</title>\n<link rel=\"icon\" href=\"data:,\">\n";
  for (const EmbeddedFile& file : embedded_assets())
    if (file.path.ends_with(".css"))
      head += "<link rel=\"stylesheet\" href=\"assets/" + std::string(file.path) + "\">\n";
  return head + "<link rel=\"stylesheet\" href=\"assets/drawing.css\">\n</head>\n";
}

constexpr std::string_view main_begins = "<main id=\"main\">\n";
constexpr std::string_view banner =
    R"(<a class="skip" href="#main">To the content</a>
<header class="banner">
<a class="home" href="index.html">oddity</a>
<nav aria-label="The site"><a href="index.html#wrong">What is wrong</a><a href="index.html#exercises">Exercises</a><a href="lesson.html">Why Euler fails</a><a href="recipes.html">What to use</a><a href="chooser.html">Chooser</a><a href="own.html">Your own</a><a href="algorithms.html">Algorithms</a><a href="errata.html">Errata sheet</a></nav>
</header>
)";

}  // namespace

std::string text(std::string_view text) { return marked_up(text, false); }
std::string prose(std::string_view text) { return marked_up(text, true); }

std::pair<std::string, std::string> texts_that_differ(std::string_view a, std::string_view b) {
  if (a == b || !is_formula(a) || !is_formula(b)) return {text(a), text(b)};
  return formulas_that_differ(a.substr(1, a.size() - 2), b.substr(1, b.size() - 2));
}

std::string in_all_brackets(std::string_view text) {
  return is_formula(text) ? formula_in_all_brackets(text.substr(1, text.size() - 2)) : marked_up(text, false);
}

std::string anchor(std::string_view text) {
  std::string id;
  for (char c : text)
    id += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_' ? c : '-';
  return id;
}

std::string element(std::string_view name, std::string_view attributes, std::string_view content) {
  std::string made;
  for (std::string_view part : {std::string_view("<"), name, attributes, std::string_view(">"), content,
                                std::string_view("</"), name, std::string_view(">")})
    made += part;
  return made;
}

std::string link(std::string_view to, std::string_view content) {
  return element("a", " href=\"" + in_xml(to) + "\"", content);
}

std::string folded(std::string_view summary, std::string_view content) {
  return element("details", "", element("summary", "", summary) + std::string(content)) + "\n";
}

std::string row(const std::vector<std::string>& cells, std::string_view numbers) {
  std::string made;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool number = i < 10 && numbers.find(static_cast<char>('0' + i)) != std::string_view::npos;
    made += i == 0 ? element("th", " scope=\"row\"", cells[i])
                   : element("td", number ? " class=\"n\"" : "", cells[i]);
  }
  return element("tr", "", made) + "\n";
}

std::string table(const Table& table) {
  std::string head, body;
  for (const std::string& name : table.head) head += element("th", " scope=\"col\"", name);
  for (const std::string& row : table.rows) body += row;
  return element(
             "div",
             " class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + in_xml(table.caption) + "\"",
             element("table", "",
                     element("caption", "", in_xml(table.caption)) +
                         element("thead", "", element("tr", "", head)) + "\n" + element("tbody", "", body))) +
         "\n";
}

std::string whole(const Page& page) {
  const std::string program = program_as_typed();
  std::string text = head_of(page) + "<body" + (page.kind.empty() ? "" : " class=\"" + page.kind + "\"") +
                     " data-program=\"" + program + "\">\n" + std::string(banner) + std::string(main_begins) +
                     page.body + "</main>\n<footer class=\"foot\"><p>Written by <code>" + program +
                     " site</code> from the results of a run. Every number can be made again: <code>" +
                     program +
                     " verify</code>.</p><p>More: <a href=\"trust.html\">how it is checked</a>, "
                     "<a href=\"stability.html\">which steps are stable</a>, "
                     "<a href=\"engines.html\">what engines do</a>.</p></footer>\n";
  std::vector<std::string> scripts{"assets/page.js", "assets/search.js"};
  scripts.insert(scripts.end(), page.scripts.begin(), page.scripts.end());
  for (const std::string& script : scripts) text += "<script src=\"" + script + "\"></script>\n";
  return text + "</body>\n</html>\n";
}

void note_missing(std::string& page, const std::vector<std::string>& lacks, const std::string& command) {
  std::string text;
  for (const std::string& one : lacks) text += (text.empty() ? "" : "; and ") + in_xml(one);
  page.insert(page.find(main_begins) + main_begins.size(),
              element("p", " class=\"lacks\"",
                      "This copy of the site lacks " + text + ". A whole one is made by <code>" +
                          in_xml(command) + "</code>.") +
                  "\n");
}

}  // namespace oddity::html
