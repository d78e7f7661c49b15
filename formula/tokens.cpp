#include "formula/tokens.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace oddity::formula {

namespace {

bool among(std::string_view token, std::initializer_list<std::string_view> all) {
  return std::ranges::find(all, token) != all.end();
}
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::size_t length_of_command(std::string_view text) {
  std::size_t n = 1;
  while (n < text.size() && is_letter(text[n])) ++n;
  return std::min(text.size(), std::max<std::size_t>(n, 2));
}

/// Digits, with a point only between them.
std::size_t length_of_number(std::string_view text) {
  std::size_t n = 1;
  while (n < text.size() &&
         (is_digit(text[n]) || (text[n] == '.' && n + 1 < text.size() && is_digit(text[n + 1]))))
    ++n;
  return n;
}

/// Commands that only move or stretch, except the space that ends a function's argument.
bool is_layout(std::string_view token) {
  return among(token, {R"(\left)",  R"(\right)", R"(\bigl)",         R"(\bigr)",   R"(\Bigl)",  R"(\Bigr)",
                       R"(\big)",   R"(\Big)",   R"(\bigg)",         R"(\Bigg)",   R"(\biggl)", R"(\biggr)",
                       R"(\Biggl)", R"(\Biggr)", R"(\displaystyle)", R"(\limits)", R"(\!)",     R"(\ )",
                       R"(\;)",     R"(\:)",     R"(\quad)",         R"(\qquad)"});
}

/// Replaces {x} by x, but not {15}, of which a fraction would take only the 1.
Tokens without_single_groups(const Tokens& tokens) {
  Tokens kept;
  for (const Token& token : tokens) {
    const std::size_t n = kept.size();
    const bool single = token.text == "}" && n >= 2 && kept[n - 2].text == "{" && kept[n - 1].text != "{" &&
                        (kept[n - 1].text.size() == 1 || !is_digit(kept[n - 1].text[0]));
    if (single) {
      kept[n - 2] = {kept[n - 1].text, kept[n - 2].begin, token.end};
      kept.pop_back();
    } else {
      kept.push_back(token);
    }
  }
  return kept;
}

constexpr std::pair<std::string_view, std::string_view> words[]{
    {"sin", R"(\sin)"},       {"cos", R"(\cos)"},        {"tan", R"(\tan)"},
    {"asin", R"(\arcsin)"},   {"acos", R"(\arccos)"},    {"atan", R"(\arctan)"},
    {"arcsin", R"(\arcsin)"}, {"arccos", R"(\arccos)"},  {"arctan", R"(\arctan)"},
    {"sinh", R"(\sinh)"},     {"cosh", R"(\cosh)"},      {"tanh", R"(\tanh)"},
    {"asinh", R"(\arsinh)"},  {"acosh", R"(\arcosh)"},   {"atanh", R"(\artanh)"},
    {"exp", R"(\exp)"},       {"log", R"(\ln)"},         {"ln", R"(\ln)"},
    {"sqrt", R"(\sqrt)"},     {"abs", R"(\abs)"},        {"max", R"(\max)"},
    {"min", R"(\min)"},       {"dot", R"(\dotproduct)"}, {"cross", R"(\crossproduct)"},
    {"<=", R"(\le)"},         {">=", R"(\ge)"}};

std::size_t length_of_plain(std::string_view text) {
  const char c = text[0];
  std::size_t n = 1;
  if (is_letter(c) || (static_cast<unsigned char>(c) >= 0x80)) {
    while (n < text.size() && (is_letter(text[n]) || is_digit(text[n]) || text[n] == '_' ||
                               static_cast<unsigned char>(text[n]) >= 0x80))
      ++n;
    while (n < text.size() && text[n] == '\'') ++n;
  } else if (is_digit(c) || (c == '.' && text.size() > 1 && is_digit(text[1]))) {
    n = length_of_number(text);
    std::size_t power = n + 1;
    if (n < text.size() && (text[n] == 'e' || text[n] == 'E')) {
      if (power < text.size() && (text[power] == '-' || text[power] == '+')) ++power;
      if (power < text.size() && is_digit(text[power])) n = power + length_of_number(text.substr(power));
    }
  } else if (text.starts_with("**") || text.starts_with("<=") || text.starts_with(">=") ||
             text.starts_with("!=")) {
    n = 2;
  }
  return n;
}

constexpr std::array<std::string_view, 33> greek{
    "alpha", "beta",  "gamma", "delta",  "epsilon", "zeta",  "eta",   "theta", "iota", "kappa", "lambda",
    "mu",    "nu",    "xi",    "pi",     "rho",     "sigma", "tau",   "phi",   "chi",  "psi",   "omega",
    "Gamma", "Delta", "Theta", "Lambda", "Xi",      "Pi",    "Sigma", "Phi",   "Psi",  "Omega", "varphi"};

}  // namespace

Tokens tex_tokens(std::string_view text) {
  Tokens tokens;
  bool in_indices = false;
  const auto last_is = [&](std::initializer_list<std::string_view> all) {
    return !tokens.empty() && among(tokens.back().text, all);
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    std::size_t n = 1;
    if (rest[0] == '\\')
      n = length_of_command(rest);
    else if (is_digit(rest[0]) && !in_indices && !last_is({"_", "^", R"(\frac)", R"(\sqrt)"}))
      n = length_of_number(rest);
    else if (static_cast<unsigned char>(rest[0]) >= 0xC0)
      while (n < rest.size() && (static_cast<unsigned char>(rest[n]) & 0xC0U) == 0x80) ++n;
    Token token{std::string(rest.substr(0, n)), at, at + n};
    at += n;
    if (among(token.text, {R"(\tfrac)", R"(\dfrac)"})) token.text = R"(\frac)";
    in_indices = token.text == "{" ? last_is({"_"}) : in_indices && token.text != "}";
    if (!among(token.text, {" ", "$", "\n", "\t"}) && !is_layout(token.text))
      tokens.push_back(std::move(token));
  }
  return without_single_groups(tokens);
}

Tokens plain_tokens(std::string_view text,
                    const std::function<std::size_t(std::string_view)>& length_of_name) {
  Tokens tokens;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t n = length_of_plain(text.substr(at));
    if (is_letter(text[at])) n = std::max(n, length_of_name(text.substr(at)));
    Token token{std::string(text.substr(at, n)), at, at + n};
    at += n;
    if (among(token.text, {" ", "\t", "\n"})) continue;
    const auto* word =
        std::ranges::find(words, token.text, &std::pair<std::string_view, std::string_view>::first);
    if (word != std::end(words))
      token.text = word->second;
    else if (token.text == "**")
      token.text = "^";
    else if (token.text == "!=")
      token.text = R"(\ne)";
    tokens.push_back(std::move(token));
  }
  return tokens;
}

std::string plain_name(std::string_view tex) {
  std::size_t primes = 0;
  std::string name;
  for (const Token& token : tex_tokens(tex)) {
    if (among(token.text, {R"(\dot)", R"(\ddot)"}))
      primes += token.text == R"(\dot)" ? 1 : 2;
    else if (token.text == "'")
      ++primes;
    else if (token.text.starts_with('\\') &&
             !among(token.text, {R"(\mathbf)", R"(\mathrm)", R"(\boldsymbol)"}))
      name += token.text.substr(1);
    else if (token.text.size() > 1 || is_letter(token.text[0]) || is_digit(token.text[0]) ||
             among(token.text, {"_", ","}))
      name += token.text.starts_with('\\') ? "" : token.text;
    else if (token.text == "/")
      name += "_by_";
  }
  return name + std::string(primes, '\'');
}

std::string tex_name(std::string_view plain) {
  const std::size_t primes = plain.find('\''), end = std::min(primes, plain.size());
  if (plain.find_first_of("\\{} /") < plain.size() || plain.find_first_not_of('\'', end) < plain.size())
    return std::string(plain);
  const std::string_view all = plain.substr(0, end);
  const std::size_t stem_end = std::min(all.find_first_of("_0123456789"), all.size());
  const std::string_view stem = all.substr(0, stem_end);
  std::string_view index = all.substr(stem_end);
  if (index.starts_with('_')) index.remove_prefix(1);
  const bool is_greek = std::ranges::find(greek, stem) != greek.end();
  if (!is_greek && end == plain.size()) return std::string(plain);
  std::string name = is_greek ? "\\" + std::string(stem) : std::string(stem);
  if (index.size() == 1) name += "_" + std::string(index);
  if (index.size() > 1) name += "_{" + std::string(index) + "}";
  const std::string dots = plain.size() - end == 1 ? R"(\dot)" : plain.size() - end == 2 ? R"(\ddot)" : "";
  if (dots.empty()) return name + std::string(plain.substr(end));
  return dots + (name[0] == '\\' ? "" : " ") + name;
}

}  // namespace oddity::formula
