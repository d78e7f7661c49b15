#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Pieces of HTML that the site's pages share.
namespace oddity::html {

/// Text as it stands: & < > " ' become references.
std::string escaped(std::string_view text);
/// A text of ours, in which $formulas$, `code` and *emphasis* are meant. Formulas are marked for
/// `typeset` (formulas.hpp).
std::string prose(std::string_view text);

struct Page {
  std::string title;
  std::string body;
  std::vector<std::string> scripts = {};  ///< "assets/chart.js", "data/3.5.js", in the order they need
};
/// The whole page, with the head and navigation that all have.
std::string whole(const Page&);

}  // namespace oddity::html
