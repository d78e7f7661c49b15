#include "formula/shown.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "formula/parser.hpp"
#include "formula/print.hpp"
#include "formula/signs.hpp"
#include "formula/tokens.hpp"

namespace oddity::formula {

namespace {

bool is_letter(const std::string& token) {
  const auto c = static_cast<unsigned char>(token.empty() ? ' ' : token[0]);
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c >= 0x80 || has_role(token, Role::letter);
}
bool is_bar(const std::string& token) {
  return token == "|" || token == R"(\vert)" || token == R"(\Vert)" || token == R"(\|)";
}

const Vocabulary& no_letters() {
  static const Vocabulary none({}, false);
  return none;
}

class ShownParser : public Parser {
 public:
  explicit ShownParser(std::string_view text) : Parser(text, tex_tokens(text), no_letters(), false) {}

  Tree whole() {
    Tree tree = line();
    if (at_ == tokens_.size()) return tree;
    std::vector<Tree> parts = tree.kind() == Kind::line ? tree->children : std::vector<Tree>{tree};
    while (has_role(next(), Role::closing)) {
      parts.push_back(made(Kind::sign, {}, next()));
      ++at_;
      if (at_ < tokens_.size()) parts.push_back(line());
    }
    if (at_ < tokens_.size()) fail("this closes a bracket that nothing opens");
    return made(Kind::line, std::move(parts));
  }

 private:
  /// Reads sides, relations and commas, up to a closing token.
  Tree line() {
    limit(++depth_);
    std::vector<Tree> parts;
    while (!ends())
      if (separates() || next() == "+")
        parts.push_back(sign_here());
      else
        parts.push_back(sum_of_terms());
    --depth_;
    if (parts.empty()) return made(Kind::nothing, {});
    return parts.size() == 1 ? parts[0] : made(Kind::line, std::move(parts));
  }
  bool ends() const {
    const std::string& token = next();
    return token.empty() || token == "}" || token == "&" || token == R"(\\)" || token == R"(\end)" ||
           has_role(token, Role::closing) || (inside_bars_ && is_bar(token));
  }
  bool separates() const { return has_role(next(), Role::relation) || next() == "," || next() == ";"; }
  Tree sign_here() {
    std::string text = next();
    ++at_;
    if (text == "," && space_before()) text += " ";
    return made(Kind::sign, {}, std::move(text));
  }
  /// Whether TeX prints a space there.
  bool space_before() const {
    if (at_ == 0 || at_ >= tokens_.size()) return false;
    const std::size_t begin = tokens_[at_ - 1].end;
    const std::string_view between = text_.substr(begin, tokens_[at_].begin - begin);
    return next() == R"(\,)" || between.find(R"(\ )") < between.size() ||
           between.find(R"(\;)") < between.size() || between.find(R"(\quad)") < between.size();
  }

  char sign() override {
    if (take("+")) return '+';
    if (take("-")) return '-';
    return take(R"(\pm)") ? 'p' : take(R"(\mp)") ? 'm' : '\0';
  }
  char joint() override {
    bool space = space_before();
    while (take(R"(\,)")) space = true;
    if (take("/")) return '/';
    return !begins_factor() ? '\0' : space ? ' ' : '*';
  }
  bool begins_factor() const override {
    return !ends() && !separates() && (next() == "*" || !has_role(next(), Role::sign)) && next() != R"(\,)" &&
           next() != "/";
  }
  bool begins_function() const override {
    const bool limits = (next() == R"(\max)" || next() == R"(\min)") && next(1) == "_";
    return is_function(next()) || (has_role(next(), Role::function) && !limits);
  }

  Tree base_with_powers() override {
    Tree tree = begins_function() ? of_function() : base();
    for (std::size_t n = 0;; limit(++n))
      if (take("^"))
        tree = made(Kind::power, {tree, argument()});
      else if (next() == "_")
        tree = made(Kind::indexed, {tree}, text_to(end_of_scripts(at_)));
      else if (next() == "'" || next() == "!")
        tree = made(Kind::indexed, {tree}, text_to(at_ + 1));
      else
        return tree;
  }
  std::string text_to(std::size_t end) {
    if (end > tokens_.size()) fail("expected the end of a group");
    const std::size_t from = tokens_[std::exchange(at_, end)].begin;
    return std::string(text_.substr(from, tokens_[end - 1].end - from));
  }

  Tree of_function() override {
    std::string name = next();
    ++at_;
    std::vector<Tree> children;
    if (take("^")) children.push_back(argument());
    const bool bracket = has_role(next(), Role::opening) || next() == "{";
    children.insert(children.begin(), bracket           ? base()
                                      : begins_factor() ? argument_of_function()
                                                        : made(Kind::nothing, {}));
    return made(Kind::function, std::move(children), std::move(name));
  }
  /// Reads a group, a number's first digit, or one letter without its scripts.
  Tree argument() override {
    const std::string token = next();
    if (take("{")) return closed_by("}");
    if (!token.empty() && is_digit(token[0])) return number(first_digit());
    if (has_role(token, Role::sign)) return sign_here();
    const std::size_t end = end_of_atom(at_);
    // {x} is one token.
    if (end == at_ + 1) return ++at_, made(Kind::letter, {}, token);
    if (end > at_) return made(Kind::letter, {}, text_to(end));
    if (token.empty() || ends()) fail("expected a letter, a number or a group");
    return base();
  }

  /// End of a letter, an accent with its base, or a group; else `at` itself.
  std::size_t end_of_atom(std::size_t at) const {
    if (at >= tokens_.size()) return at;
    const std::string& token = tokens_[at].text;
    if (token == "{") {
      std::size_t depth = 0;
      for (std::size_t i = at; i < tokens_.size(); ++i) {
        depth += tokens_[i].text == "{" ? 1 : 0;
        if (tokens_[i].text == "}" && --depth == 0) return i + 1;
      }
      return tokens_.size() + 1;
    }
    if (has_role(token, Role::accent) || has_role(token, Role::font)) {
      const std::size_t end = end_of_atom(at + 1);
      return end == at + 1 ? at : end;
    }
    return is_letter(token) ? at + 1 : at;
  }
  std::size_t end_of_scripts(std::size_t at) const {
    while (at < tokens_.size() && (tokens_[at].text == "_" || tokens_[at].text == "'"))
      if (tokens_[at].text == "'")
        ++at;
      else if (const bool upright = at + 1 < tokens_.size() && (tokens_[at + 1].text == R"(\mathrm)" ||
                                                                tokens_[at + 1].text == R"(\text)");
               upright)
        at = std::max(end_of_atom(at + 2), at + 3);
      else
        at = std::max(end_of_atom(at + 1), at + 2);
    return at;
  }
  std::optional<Tree> letter_here() const override {
    const std::size_t end = next() == "{" ? at_ : end_of_atom(at_);
    if (end == at_) return std::nullopt;
    length_ = end_of_scripts(end) - at_;
    if (at_ + length_ > tokens_.size()) fail("expected the end of a group");
    const std::size_t from = tokens_[at_].begin;
    return made(Kind::letter, {}, std::string(text_.substr(from, tokens_[at_ + length_ - 1].end - from)));
  }

  Tree base() override {
    if (ends() || separates() || (next() != "*" && has_role(next(), Role::sign)) || next() == "/" ||
        next() == "^" || next() == "_" || next() == "'" || next() == R"(\,)")
      return made(Kind::nothing, {});
    if (auto letter = letter_here()) {
      at_ += length_;
      return *letter;
    }
    const std::string token = next();
    if (is_digit(token[0]) || (token[0] == '.' && token.size() > 1)) return numeral();
    if (token == "*") return sign_here();
    if (token == R"(\begin)") return rows_and_columns();
    if (has_role(token, Role::large) || has_role(token, Role::function)) return large();
    ++at_;
    if (token == R"(\frac)") {
      Tree above = argument();
      return made(Kind::fraction, {above, argument()});
    }
    if (token == R"(\sqrt)") return root();
    if (token == R"(\mathrm)" || token == R"(\operatorname)") return upright();
    if (token == R"(\text)") return words();
    if (token == "{") {
      Tree inside = closed_by("}");
      const bool is_one = inside.kind() != Kind::sum && inside.kind() != Kind::line;
      return is_one ? inside : made(Kind::group, {inside}, " ");
    }
    if (has_role(token, Role::opening)) return group(token);
    if (is_bar(token)) return bars(token);
    --at_;
    fail(token.starts_with('\\') ? "no command " + token + " is known" : "no formula has this sign");
  }

  Tree closed_by(std::string_view end) override {
    const bool outside = std::exchange(inside_bars_, false);
    Tree inside = line();
    inside_bars_ = outside;
    expect(end);
    return inside;
  }
  Tree group(const std::string& opening) {
    const bool outside = std::exchange(inside_bars_, false);
    Tree inside = line();
    inside_bars_ = outside;
    if (!has_role(next(), Role::closing)) return made(Kind::line, {made(Kind::sign, {}, opening), inside});
    return made(Kind::group, {inside}, opening + " " + tokens_[at_++].text);
  }
  Tree bars(const std::string& bar) {
    const bool outside = std::exchange(inside_bars_, true);
    Tree inside = line();
    inside_bars_ = outside;
    if (!is_bar(next())) fail("expected the other bar");
    ++at_;
    return made(Kind::bars, {inside}, bar == R"(\Vert)" || bar == R"(\|)" ? R"(\|)" : "");
  }
  Tree root() {
    if (next() != "[") return made(Kind::root, {argument()});
    ++at_;
    Tree degree = line();
    expect("]");
    return made(Kind::root, {argument(), degree});
  }
  /// Reads \sum_{k\le n}^m.
  Tree large() {
    std::string name = next();
    ++at_;
    std::vector<Tree> limits{made(Kind::nothing, {})};
    while (next() == "_" || next() == "^") {
      const bool below = take("_");
      if (!below) take("^");
      if (below)
        limits[0] = argument();
      else if (limits.size() == 1)
        limits.push_back(argument());
      else
        fail("it has a limit above");
    }
    return made(Kind::large, std::move(limits), std::move(name));
  }
  /// Reads a name, or a unit such as kg m^2/s.
  Tree upright() {
    if (next() != "{") {
      std::string text = next();
      if (!is_letter(text)) fail("expected letters");
      ++at_;
      return made(Kind::words, {}, std::move(text));
    }
    ++at_;
    std::string text;
    std::size_t end = at_;
    for (; end < tokens_.size() && is_letter(tokens_[end].text); ++end) text += tokens_[end].text;
    if (end < tokens_.size() && tokens_[end].text == "}") {
      at_ = end + 1;
      return made(Kind::words, {}, std::move(text));
    }
    return made(Kind::words, {closed_by("}")});
  }
  /// Reads words with their spaces.
  Tree words() {
    if (next() != "{") return made(Kind::words, {argument()});
    const std::size_t begin = tokens_[at_].end, end = end_of_atom(at_);
    if (end > tokens_.size()) fail("expected the end of the words");
    at_ = end;
    return made(Kind::words, {}, std::string(text_.substr(begin, tokens_[end - 1].begin - begin)));
  }
  Tree rows_and_columns() {
    const std::string name = environment();
    std::vector<Tree> rows;
    do {
      std::vector<Tree> cells{line()};
      while (take("&")) cells.push_back(line());
      rows.push_back(made(Kind::row, std::move(cells)));
    } while (take(R"(\\)"));
    if (next() != R"(\end)" || environment() != name) fail("expected the end of " + name);
    return made(Kind::matrix, std::move(rows), name == "pmatrix" ? "" : name);
  }
  std::string environment() {
    ++at_;
    expect("{");
    std::string name;
    for (; is_letter(next()); ++at_) name += next();
    expect("}");
    return name;
  }
};

// ---- differences ----

using Pair = std::pair<Tree, Tree>;

Tree marked(Tree x, std::string what = "") { return made(Kind::marked, {std::move(x)}, std::move(what)); }

/// A list's children, or a single one. The sign that joins a factor to the one before it belongs to it.
struct Items {
  Items(const Tree& x, Kind kind) {
    const bool whole = x.kind() == kind;
    trees = whole ? x->children : std::vector<Tree>{x};
    marks = whole ? x->marks : kind == Kind::line ? "" : kind == Kind::sum ? "+" : "*";
    for (std::size_t i = 0; i < trees.size(); ++i)
      texts.push_back((kind == Kind::product && marks[i] == '/' ? "/" : "") + tex(trees[i]));
  }
  Tree list(Kind kind) const {
    if (trees.size() == 1 && (marks.empty() || marks == "+" || marks == "*")) return trees[0];
    return Tree({.kind = kind, .children = trees, .marks = marks});
  }
  std::vector<Tree> trees;
  std::string marks;
  std::vector<std::string> texts;
};

Pair compared(const Tree& a, const Tree& b);

/// Marks the signs of two terms if they differ.
void compare_signs(Items& a, std::size_t i, Items& b, std::size_t j, Kind kind) {
  if (kind != Kind::sum || a.marks[i] == b.marks[j]) return;
  a.trees[i] = marked(a.trees[i], "sign");
  b.trees[j] = marked(b.trees[j], "sign");
}
void mark_between(Items& a, std::size_t begin, std::size_t end, Kind kind) {
  for (std::size_t i = begin; i < end; ++i)
    a.trees[i] = kind == Kind::sum ? marked(marked(a.trees[i]), "sign") : marked(a.trees[i]);
}
void compare_between(Items& a, std::size_t a0, std::size_t a1, Items& b, std::size_t b0, std::size_t b1,
                     Kind kind) {
  if (a1 - a0 != b1 - b0) return mark_between(a, a0, a1, kind), mark_between(b, b0, b1, kind);
  for (; a0 < a1; ++a0, ++b0) {
    std::tie(a.trees[a0], b.trees[b0]) = compared(a.trees[a0], b.trees[b0]);
    compare_signs(a, a0, b, b0, kind);
    if (kind == Kind::product && (a.marks[a0] == '/') != (b.marks[b0] == '/')) {
      a.trees[a0] = marked(a.trees[a0]);
      b.trees[b0] = marked(b.trees[b0]);
    }
  }
}

/// Does not mark the longest common subsequence.
Pair compared_lists(const Tree& left, const Tree& right, Kind kind) {
  Items a(left, kind), b(right, kind);
  const std::size_t n = a.trees.size(), m = b.trees.size();
  std::vector<std::vector<std::size_t>> common(n + 1, std::vector<std::size_t>(m + 1));
  for (std::size_t i = n; i-- > 0;)
    for (std::size_t j = m; j-- > 0;)
      common[i][j] =
          a.texts[i] == b.texts[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
  std::size_t i = 0, j = 0, i0 = 0, j0 = 0;
  while (i < n && j < m)
    if (a.texts[i] == b.texts[j]) {
      compare_between(a, i0, i, b, j0, j, kind);
      compare_signs(a, i, b, j, kind);
      i0 = ++i, j0 = ++j;
    } else {
      ++(common[i + 1][j] >= common[i][j + 1] ? i : j);
    }
  compare_between(a, i0, n, b, j0, m, kind);
  return {a.list(kind), b.list(kind)};
}

Pair compared(const Tree& a, const Tree& b) {
  if (tex(a) == tex(b)) return {a, b};
  for (const Kind kind : {Kind::line, Kind::sum, Kind::product})
    if (a.kind() == kind || b.kind() == kind) return compared_lists(a, b, kind);
  if (a.kind() != b.kind() || a->text != b->text || a->children.empty() ||
      a->children.size() != b->children.size() || a.kind() == Kind::words)
    return {marked(a), marked(b)};
  Tree left = a, right = b;
  for (std::size_t i = 0; i < a->children.size(); ++i) {
    auto [x, y] = compared(a.child(i), b.child(i));
    left = left.with_child(i, std::move(x));
    right = right.with_child(i, std::move(y));
  }
  return {left, right};
}

}  // namespace

Tree parse_shown(std::string_view text) {
  if (text.size() > 20'000) throw Unreadable(text, 20'000, "at most 20,000 characters");
  return ShownParser(text).whole();
}

std::pair<Tree, Tree> with_differences_marked(const Tree& a, const Tree& b) { return compared(a, b); }

}  // namespace oddity::formula
