#include "report/text/used_code.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <regex>
#include <set>
#include <utility>
#include <vector>

namespace oddity {

namespace {

using Words = std::set<std::string, std::less<>>;

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The code with comments and literals replaced by spaces.
std::string blanked(std::string_view code) {
  std::string plain(code);
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, plain.size()); ++i)
      if (plain[i] != '\n') plain[i] = ' ';
  };
  for (std::size_t at = 0; at < code.size();) {
    std::size_t end = at + 1;
    if (code.substr(at, 2) == "//") {
      end = std::min(code.find('\n', at), code.size());
      blank(at, end);
    } else if (code[at] == '"' || (code[at] == '\'' && (at == 0 || !in_word(code[at - 1])))) {
      while (end < code.size() && code[end] != code[at]) end += code[end] == '\\' ? 2 : 1;
      blank(at, ++end);
    }
    at = end;
  }
  return plain;
}

Words words_of(std::string_view plain) {
  Words words;
  for (std::size_t at = 0; at < plain.size();) {
    std::size_t end = at;
    while (end < plain.size() && in_word(plain[end])) ++end;
    if (end > at && !std::isdigit(static_cast<unsigned char>(plain[at])))
      words.emplace(plain.substr(at, end - at));
    at = std::max(end, at + 1);
  }
  return words;
}

bool shares(const Words& a, const Words& b) {
  return std::ranges::any_of(a, [&](const std::string& word) { return b.contains(word); });
}

/// A declaration and the text before it.
struct Declaration {
  enum class Is { leaf, type, name_space };
  Is is = Is::leaf;
  std::string before, head, after;  ///< after: text behind the members of a type or a namespace
  std::vector<Declaration> members = {};
  bool stays = false;  ///< kept whenever the enclosing declaration is
  Words names = {}, mentions = {};
  bool is_kept = false;
};

/// A declaration's head without the text inside <> and parentheses.
std::string outline(std::string_view head) {
  std::string text;
  int angles = 0, parentheses = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    const char c = head[i];
    const bool is_bracket = i > 0 && (in_word(head[i - 1]) || head[i - 1] == ' ') && parentheses == 0;
    if (c == '<' && (is_bracket || angles > 0)) ++angles;
    if (angles == 0) {
      if (c == ')') --parentheses;
      if (parentheses == 0) text += c;
      if (c == '(') ++parentheses;
    }
    if (c == '>' && angles > 0) --angles;
  }
  return text;
}

/// Finds the names that a declaration introduces; sets `stays` if it cannot be selected by name.
void name(Declaration& piece, const std::string& plain, const std::string& type_around) {
  static const std::regex type(R"(\b(?:struct|class|enum|concept|union)\s+(?:class\s+)?(\w+))"),
      alias(R"(\busing\s+(\w+)\s*=)"), called(R"((\w+)\s*\()"),
      variable(R"((\w+)\s*(?:\[[^\]]*\]\s*)*(?:[=;{,]|$))");
  const std::string line = outline(plain);
  std::smatch found;
  if (line.find("operator") != line.npos || line.find("virtual") != line.npos ||
      line.find("override") != line.npos || line.find("friend") != line.npos ||
      line.find("static_assert") != line.npos) {
    piece.stays = true;
  } else if (std::regex_search(line, found, alias) || std::regex_search(line, found, type)) {
    piece.names = {found[1].str()};
  } else if (line.find("using ") != line.npos) {
    piece.names = words_of(plain.substr(plain.find("using ") + 6));
    piece.names.erase("std");
    piece.stays = plain.find("typename") != plain.npos || plain.find("namespace") != plain.npos;
  } else {
    std::string rest = line.substr(0, line.find('='));
    const std::regex guard(R"(\b(requires|decltype|noexcept|alignas)\s*\(\))");
    rest = std::regex_replace(rest, guard, "");
    if (std::regex_search(rest, found, called)) {
      piece.names = {found[1].str()};
      piece.stays = found[1].str() == type_around;
    } else if (std::regex_search(rest += ';', found, variable)) {
      piece.names = {found[1].str()};
      piece.stays = !type_around.empty() && line.find("static") == line.npos;
    } else {
      piece.stays = true;
    }
  }
}

/// Reads a sequence of declarations; nullopt if braces do not match.
class DeclarationReader {
 public:
  DeclarationReader(std::string_view code, std::string_view plain, std::string type)
      : code_(code), plain_(plain), type_(std::move(type)) {}

  std::optional<std::vector<Declaration>> read(std::string& rest) {
    std::vector<Declaration> all;
    while (true) {
      const std::size_t before = at_;
      while (at_ < plain_.size() && std::isspace(static_cast<unsigned char>(plain_[at_]))) ++at_;
      if (at_ == plain_.size()) {
        rest = code_.substr(before);
        return all;
      }
      auto piece = one(before);
      if (!piece) return {};
      all.push_back(std::move(*piece));
    }
  }

 private:
  std::optional<Declaration> one(std::size_t before) {
    Declaration piece;
    piece.before = code_.substr(before, at_ - before);
    const std::size_t begin = at_;
    static const std::regex access(R"(^(public|private|protected):)");
    const std::string line(plain_.substr(at_, plain_.find('\n', at_) - at_));
    if (std::regex_search(line, access)) {
      at_ += line.size();
      piece.head = line;
      piece.stays = true;
      return piece;
    }
    std::size_t inside = 0;
    int depth = 0, parentheses = 0;
    for (;; ++at_) {
      if (at_ >= plain_.size()) return {};
      const char c = plain_[at_];
      if (c == '(') ++parentheses;
      if (c == ')') --parentheses;
      if (c == '{' && depth++ == 0 && parentheses == 0 && inside == 0) inside = at_ + 1;
      if (c == '}' && --depth < 0) return {};
      if (depth > 0 || parentheses > 0) continue;
      if (c == ';' || (c == '}' && ends_here())) break;
    }
    const std::size_t end = ++at_;
    // a comment on the same line
    if (const auto newline = std::min(plain_.find('\n', at_), plain_.size());
        plain_.substr(at_, newline - at_).find_first_not_of(' ') == std::string_view::npos)
      at_ = newline;
    const std::string head(plain_.substr(begin, (inside ? inside - 1 : end) - begin));
    static const std::regex space(R"(^\s*namespace\b)"),
        type(R"(^\s*(?:template\s*<[^{]*>\s*)?(?:requires[^{]*\s)?(?:struct|class)\s+(\w+)[^(;=]*$)");
    std::smatch found;
    if (inside && std::regex_search(head, space)) {
      piece.is = Declaration::Is::name_space;
      return with_members(piece, begin, inside, end, "");
    }
    name(piece, std::string(plain_.substr(begin, (inside ? inside : end) - begin)), type_);
    if (inside && std::regex_search(head, found, type)) {
      piece.is = Declaration::Is::type;
      piece.names = {found[1].str()};
      piece.stays = false;
      piece.mentions = words_of(head);
      return with_members(piece, begin, inside, end, found[1].str());
    }
    piece.head = code_.substr(begin, at_ - begin);
    piece.mentions = words_of(plain_.substr(begin, end - begin));
    return piece;
  }

  /// Whether a closing brace ends the declaration.
  bool ends_here() const {
    std::size_t next = at_ + 1;
    while (next < plain_.size() && std::isspace(static_cast<unsigned char>(plain_[next]))) ++next;
    return next >= plain_.size() || std::string_view(";(,){").find(plain_[next]) == std::string_view::npos;
  }

  std::optional<Declaration> with_members(Declaration piece, std::size_t begin, std::size_t inside,
                                          std::size_t end, const std::string& type) {
    const std::size_t close = plain_.rfind('}', end - 1);
    piece.head = code_.substr(begin, inside - begin);
    std::string rest;
    auto members =
        DeclarationReader(code_.substr(inside, close - inside), plain_.substr(inside, close - inside), type)
            .read(rest);
    if (!members) return {};
    piece.members = std::move(*members);
    piece.after = rest + std::string(code_.substr(close, at_ - close));
    return piece;
  }

  std::string_view code_, plain_;
  std::string type_;  ///< enclosing type; empty outside of types
  std::size_t at_ = 0;
};

/// Keeps declarations whose names are needed; returns whether it kept more than before.
bool keep(std::vector<Declaration>& all, Words& needed) {
  bool more = false;
  for (Declaration& piece : all) {
    if (!piece.is_kept && piece.is != Declaration::Is::name_space &&
        (piece.stays || shares(piece.names, needed))) {
      piece.is_kept = more = true;
      needed.insert(piece.mentions.begin(), piece.mentions.end());
    }
    if (piece.is_kept || piece.is == Declaration::Is::name_space) more |= keep(piece.members, needed);
    if (piece.is == Declaration::Is::name_space)
      piece.is_kept = std::ranges::any_of(piece.members, &Declaration::is_kept);
  }
  return more;
}

void write(const std::vector<Declaration>& all, Declaration::Is around, std::string& code) {
  bool is_first = true;
  for (const Declaration& piece : all) {
    if (!piece.is_kept) continue;
    std::string before = piece.before;
    if (is_first) {  // spaced as the first declaration of its scope
      const std::string_view line = around == Declaration::Is::type ? "\n" : "\n\n";
      before = std::string(line) + before.substr(std::min(before.find_first_not_of('\n'), before.size()));
    }
    is_first = false;
    code += before + piece.head;
    write(piece.members, piece.is, code);
    code += piece.after;
  }
}

}  // namespace

std::string used_code(std::string_view code, std::string_view words) {
  const std::string plain = blanked(code);
  std::string rest, used;
  auto all = DeclarationReader(code, plain, "").read(rest);
  if (!all) return std::string(code);
  Words needed = words_of(blanked(words));
  while (keep(*all, needed)) {
  }
  write(*all, Declaration::Is::name_space, used);
  return used + rest;
}

bool needs_standard(std::string_view name, std::string_view code) {
  static const std::pair<std::string_view, std::regex> known[] = {
      {"array", std::regex(R"(std::array\b)")},
      {"cmath",
       std::regex(
           R"(\b(f?abs|sqrt|cbrt|hypot|exp2?|expm1|log|log2|log10|log1p|sinh?|cosh?|tanh?|asinh?|acosh?|atanh?|atan2|pow|floor|ceil|trunc|l?l?round|rint|fmax|fmin|fma|fmod|remainder|copysign|isfinite|isnan|isinf|signbit|ldexp|nextafter)\b)")},
      {"concepts", std::regex(R"(std::(same_as|convertible_to|floating_point|integral)\b)")},
      {"cstddef", std::regex(R"(\bsize_t\b)")},
      {"functional", std::regex(R"(std::(function|invoke|plus|minus|less|greater|multiplies)\b)")},
      {"numbers", std::regex(R"(std::numbers\b)")},
      {"string_view", std::regex(R"(std::string_view\b)")},
      {"tuple", std::regex(R"(std::(tuple\w*|tie|get|make_tuple)\b)")},
      {"limits", std::regex(R"(std::numeric_limits\b)")},
      {"algorithm", std::regex(R"(std::(min|max|clamp|copy|copy_n|fill|transform|any_of|all_of|ranges)\b)")},
      {"utility", std::regex(R"(std::(pair|move|swap|exchange|forward|declval)\b)")},
      {"type_traits", std::regex(R"(std::(\w+_v|is_\w+|remove_\w+|conditional_t|decay_t)\b)")},
  };
  const auto* found = std::ranges::find(known, name, &std::pair<std::string_view, std::regex>::first);
  return found == std::end(known) || std::regex_search(code.begin(), code.end(), found->second);
}

}  // namespace oddity
