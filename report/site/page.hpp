#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Pieces of HTML shared by the site's pages.
namespace oddity::html {

/// A text with $formulas$ and `code`. Formulas become MathML.
std::string text(std::string_view text);
/// A text with $formulas$, `code` and *emphasis*.
std::string prose(std::string_view text);
/// Two texts. If each is one formula, their differences are marked.
std::pair<std::string, std::string> texts_that_differ(std::string_view, std::string_view);
/// A formula with each operand in brackets, to show how it was read.
std::string in_all_brackets(std::string_view text);
/// A text as an id for links: anything but letters, digits, dots, dashes and underscores becomes a dash.
std::string anchor(std::string_view text);

/// <p class="shows">content</p> of "p", " class=\"shows\"", "content".
std::string element(std::string_view name, std::string_view attributes, std::string_view content);
std::string link(std::string_view to, std::string_view content);
/// Content that is folded under a summary.
std::string folded(std::string_view summary, std::string_view content);

struct Table {
  std::string caption;                 ///< for readers who cannot see the table's heading
  std::vector<std::string> head;       ///< names of columns
  std::vector<std::string> rows = {};  ///< made by row()
};
/// A row's cells; the first names the row. Those whose index is among the digits of `numbers` are
/// right-aligned.
std::string row(const std::vector<std::string>& cells, std::string_view numbers = {});
std::string table(const Table&);

struct Page {
  std::string title;
  std::string body;                       ///< content of <main>
  std::vector<std::string> scripts = {};  ///< besides the common ones, in the order of dependencies
  std::string kind = {};                  ///< the class of the page's body
};
/// The whole page, with the common head and navigation.
std::string whole(const Page&);

/// Adds a notice to a page: the parts that this copy of the site lacks, and the command that makes a complete
/// one.
void note_missing(std::string& page, const std::vector<std::string>& lacks, const std::string& command);

}  // namespace oddity::html
