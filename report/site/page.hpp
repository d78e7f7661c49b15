#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Pieces of HTML that the site's pages share.
namespace oddity::html {

/// A text in which $formulas$ and `code` are meant. Formulas are MathML.
std::string text(std::string_view text);
/// The same with *emphasis*.
std::string prose(std::string_view text);
/// Two texts. Where each is one formula, the places in which they differ are marked.
std::pair<std::string, std::string> texts_that_differ(std::string_view, std::string_view);
/// A formula as it is read, each operand in brackets.
std::string in_all_brackets(std::string_view text);
/// A text as an id that a link can lead to: what is no letter, digit, dot, dash or underscore becomes a dash.
std::string anchor(std::string_view text);

/// <p class="shows">content</p> of "p", " class=\"shows\"", "content".
std::string element(std::string_view name, std::string_view attributes, std::string_view content);
std::string link(std::string_view to, std::string_view content);
/// What is folded up under a line.
std::string folded(std::string_view summary, std::string_view content);

struct Table {
  std::string caption;                 ///< for who cannot see what the table stands under
  std::vector<std::string> head;       ///< names of columns
  std::vector<std::string> rows = {};  ///< of `row`
};
/// A row's cells; the first names the row. Those whose place is among the digits of `numbers` are set to the
/// right.
std::string row(const std::vector<std::string>& cells, std::string_view numbers = {});
std::string table(const Table&);

struct Page {
  std::string title;
  std::string body;                       ///< what is in <main>
  std::vector<std::string> scripts = {};  ///< beside those that all pages have, in the order they need
  std::string kind = {};                  ///< the class of the page's body
};
/// The whole page, with the head and navigation that all have.
std::string whole(const Page&);

/// Has a whole page say first what its copy of the site lacks, and by which command one is made that does
/// not.
void tell(std::string& page, const std::vector<std::string>& lacks, const std::string& command);

}  // namespace oddity::html
