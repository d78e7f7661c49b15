#include "formula/name_writer.hpp"

#include <algorithm>
#include <utility>

#include "formula/signs.hpp"

namespace oddity::formula {

std::string NameWriter::of(const std::string& name) {
  tokens_ = tex_tokens(name);
  at_ = 0;
  return all();
}

std::string NameWriter::behind(const std::string& base, const std::string& text) {
  tokens_ = tex_tokens(text);
  at_ = 0;
  const std::string first = scripts(base);
  return first + all();
}

std::string NameWriter::all() {
  std::string row;
  while (at_ < tokens_.size() && tokens_[at_].text != "}") row += scripts(one(""));
  return row;
}

std::string NameWriter::scripts(std::string base) {
  std::string below;
  std::size_t primes = 0;
  for (; at_ < tokens_.size(); ++at_)
    if (tokens_[at_].text == "'")
      ++primes;
    else if (tokens_[at_].text == "_" && at_ + 1 < tokens_.size())
      ++at_, below += one(""), --at_;
    else
      break;
  return below.empty() && primes == 0 ? base : with_scripts(base, below, primes);
}

std::string NameWriter::one(const std::string& font) {
  if (at_ >= tokens_.size()) return "";
  const std::string token = tokens_[at_++].text;
  if (token == "{") {
    std::string inside;
    while (at_ < tokens_.size() && tokens_[at_].text != "}") inside += scripts(one(font));
    ++at_;
    return group(inside);
  }
  if (has_role(token, Role::font) || token == R"(\mathrm)" || token == R"(\text)") return one(token);
  if (has_role(token, Role::accent)) {
    const std::string base = one(font);
    return accented(base, token);
  }
  return token == "_" || token == "'" ? scripts("") : atom(token, font);
}

}  // namespace oddity::formula
