#include "report/site/single.hpp"

#include <stdexcept>
#include <string_view>

#include "reference/proofs.hpp"

namespace oddity {

namespace {

using Contents = std::function<std::string(const std::string&)>;

/// Removes each passage from `begins` up to and including `ends`.
void take_out(std::string& page, std::string_view begins, std::string_view ends) {
  for (std::size_t at = 0; (at = page.find(begins, at)) != std::string::npos;)
    page.erase(at, page.find(ends, at) + ends.size() - at);
}

/// The text between the two, from `from` on.
std::string between(const std::string& page, std::size_t from, std::string_view before,
                    std::string_view after) {
  const std::size_t begin = page.find(before, from) + before.size();
  return page.substr(begin, page.find(after, begin) - begin);
}

/// Puts the files in place of the elements that load them.
void inlined(std::string& page, std::string_view begins, std::string_view ends, std::string_view address,
             const std::string& element, const std::string& nonce, const Contents& file) {
  for (std::size_t at = 0; (at = page.find(begins, at)) != std::string::npos;) {
    const std::string text = file(between(page, at, address, "\""));
    if (text.find("</" + element) != std::string::npos)
      throw std::logic_error("a file that ends its own element cannot be put into a page");
    const std::string whole = "<" + element + " nonce=\"" + nonce + "\">\n" + text + "</" + element + ">";
    page.replace(at, page.find(ends, at) + ends.size() - at, whole);
    at += whole.size();
  }
}

/// Replaces links to other pages by their text.
void unlink_elsewhere(std::string& page) {
  const std::string_view begins = "<a ";
  for (std::size_t at = 0; (at = page.find(begins, at)) != std::string::npos; ++at) {
    const std::size_t ends = page.find('>', at), closes = page.find("</a>", at);
    const std::string_view tag(page.data() + at, ends - at);
    if (tag.find("href=\"#") != std::string_view::npos || tag.find("href=\"http") != std::string_view::npos)
      continue;
    page.replace(closes, 4, "</span>");
    page.replace(at, ends - at, "<span");
  }
}

void replace(std::string& page, std::string_view what, const std::string& by) {
  const std::size_t at = page.find(what);
  if (at == std::string::npos) throw std::logic_error("the page has no " + std::string(what));
  page.replace(at, what.size(), by);
}

}  // namespace

std::string in_one_file(std::string page, const Contents& file) {
  take_out(page, "<script src=\"assets/search.js\">", "</script>\n");
  take_out(page, "<header class=\"banner\">", "</header>\n");
  take_out(page, "<nav class=\"neighbours\"", "</nav>\n");
  unlink_elsewhere(page);
  const std::string nonce = proof_hash(page), own = "'nonce-" + nonce + "'";
  replace(page, "script-src 'self'", "script-src " + own);
  replace(page, "style-src 'self'", "style-src " + own);
  inlined(page, "<link rel=\"stylesheet\"", ">", "href=\"", "style", nonce, file);
  inlined(page, "<script src=", "</script>", "src=\"", "script", nonce, file);
  return page;
}

}  // namespace oddity
