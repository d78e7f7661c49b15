#include "report/site/page.hpp"

#include "report/site/formulas.hpp"

namespace oddity::html {

std::string escaped(std::string_view text) {
  std::string safe;
  for (char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string prose(std::string_view text) {
  std::string made;
  while (!text.empty()) {
    const char c = text.front();
    const auto end = c == '$' || c == '`' || c == '*' ? text.find(c, 1) : std::string_view::npos;
    if (end == std::string_view::npos) {
      made += escaped(text.substr(0, 1));
      text.remove_prefix(1);
      continue;
    }
    const std::string_view inside = text.substr(1, end - 1);
    made += c == '$'   ? marked(inside)
            : c == '`' ? "<code>" + escaped(inside) + "</code>"
                       : "<em>" + prose(inside) + "</em>";
    text.remove_prefix(end + 1);
  }
  return made;
}

std::string whole(const Page& page) {
  std::string text =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(page.title) +
      "</title>\n<link rel=\"icon\" href=\"data:,\">\n<link rel=\"stylesheet\" href=\"assets/oddity.css\">\n"
      "</head>\n<body>\n<header><a href=\"index.html\">oddity</a></header>\n<main>\n" +
      page.body + "</main>\n";
  for (const std::string& script : page.scripts) text += "<script src=\"" + script + "\"></script>\n";
  return text + "</body>\n</html>\n";
}

}  // namespace oddity::html
