#include "formula/parse.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>

#include "formula/differentiate.hpp"
#include "formula/letters.hpp"
#include "formula/parser.hpp"
#include "formula/reader.hpp"
#include "formula/tokens.hpp"

namespace oddity::formula {

namespace {

constexpr std::size_t longest_text = 20'000, deepest = 60;

bool among(std::string_view token, std::initializer_list<std::string_view> all) {
  return std::ranges::find(all, token) != all.end();
}

/// The index that begins there in index notation, i or j_2; else empty.
std::vector<std::string> index_at(const Tokens& tokens, std::size_t at) {
  const std::string& letter = tokens[at].text;
  if (!among(letter, {"i", "j", "k", "l", "m", "r", "c"})) return {};
  const bool numbered =
      at + 2 < tokens.size() && tokens[at + 1].text == "_" && is_digit(tokens[at + 2].text[0]);
  if (numbered) return {letter, "_", tokens[at + 2].text};
  return {letter};
}

/// Counts each index in _{...} or behind _, except those of a \sum.
std::map<std::vector<std::string>, int> indices_in(const Tokens& tokens) {
  std::map<std::vector<std::string>, int> counts;
  bool inside = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool behind = i > 0 && tokens[i - 1].text == "_";
    inside = tokens[i].text == "{" ? behind : inside && tokens[i].text != "}";
    if (!inside && !behind) continue;
    if (const auto index = index_at(tokens, i); !index.empty()) {
      ++counts[index];
      i += index.size() - 1;
    }
  }
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i)
    if (tokens[i].text == R"(\sum)" && tokens[i + 1].text == "_") counts.erase({tokens[i + 2].text});
  return counts;
}

/// Adds the values of an index for which the letters below have entries; false if no letter has this index.
bool values_of_index(const Tree& tree, std::size_t slot, std::optional<std::set<int>>& all) {
  const auto place = std::ranges::find(tree->slots, slot);
  bool uses = tree.kind() == Kind::index && place != tree->slots.end();
  if (tree.kind() == Kind::letter && place != tree->slots.end()) {
    uses = true;
    std::set<int> own;
    for (const Entry& entry : tree->entries)
      own.insert(entry.indices[static_cast<std::size_t>(place - tree->slots.begin())]);
    if (all) {
      std::set<int> both;
      std::ranges::set_intersection(*all, own, std::inserter(both, both.end()));
      own = both;
    }
    all = std::move(own);
  }
  const std::size_t n = tree.kind() == Kind::time_derivative ? 1 : tree->children.size();
  for (std::size_t i = 0; i < n; ++i) uses = values_of_index(tree.child(i), slot, all) || uses;
  return uses;
}

/// The first value and those that follow it without a gap.
std::vector<int> run_of(const std::set<int>& values) {
  std::vector<int> run;
  for (const int value : values)
    if (run.empty() || value == run.back() + 1)
      run.push_back(value);
    else
      break;
  return run;
}

}  // namespace

Tree Parser::all() {
  Tree tree = sum_of_terms();
  if (at_ < tokens_.size()) fail(next() == "=" ? "another side" : "the formula ends before this");
  return tree;
}

Tree Parser::in_index_notation() {
  const bool is_product = std::ranges::none_of(tokens_, [](const Token& token) {
    return among(token.text, {"+", "-", R"(\pm)", R"(\mp)"});
  });
  std::vector<std::vector<std::string>> free, summed;
  for (const auto& [index, count] : indices_in(tokens_))
    if (count == 1)
      free.insert(free.begin(), index);
    else if (count == 2 && is_product)
      summed.push_back(index);
    else
      fail("an index occurs once, or twice in a product");
  const bool rows_and_columns = free == std::vector<std::vector<std::string>>{{"r"}, {"c"}};
  if (free.size() != 1 && !rows_and_columns) fail("one free index, or r and c");
  std::vector<std::size_t> free_slots, summed_slots;
  for (const auto& index : free) free_slots.push_back(bind(index));
  for (const auto& index : summed) summed_slots.push_back(bind(index));
  Tree tree = all();
  std::vector<int> range{0, 1, 2};
  for (const std::size_t slot : summed_slots)
    tree = Tree({.kind = Kind::sum_over, .children = {tree}, .slots = {slot}, .range = range});
  if (summed.empty()) {
    std::optional<std::set<int>> values;
    for (const std::size_t slot : free_slots) values_of_index(tree, slot, values);
    range = run_of(values.value_or(std::set<int>{}));
  }
  if (range.empty()) fail("letters with an index");
  return Tree({.kind = Kind::components, .children = {tree}, .slots = free_slots, .range = range});
}

void Parser::fail(std::string reason) const {
  throw Unreadable(text_, at_ < tokens_.size() ? tokens_[at_].begin : text_.size(), std::move(reason));
}

void Parser::limit(std::size_t levels) const {
  if (levels > deepest) fail("at most 60 levels, one within another");
}

const std::string& Parser::next(std::size_t ahead) const {
  static const std::string end;
  return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead].text : end;
}

bool Parser::take(std::string_view token) {
  if (next() != token) return false;
  ++at_;
  return true;
}

bool Parser::take_all(std::initializer_list<std::string_view> tokens) {
  std::size_t n = 0;
  for (const std::string_view token : tokens)
    if (next(n++) != token) return false;
  at_ += n;
  return true;
}

void Parser::expect(std::string_view token) {
  if (!take(token)) fail("expected " + std::string(token));
}

std::size_t Parser::bind(std::vector<std::string> tokens) {
  // Longest first: j_2 is not j.
  const std::size_t slot = slots_++;
  if (slot > 40) fail("too many indices");
  const auto place =
      std::ranges::find_if(indices_, [&](const Index& one) { return one.tokens.size() <= tokens.size(); });
  indices_.insert(place, {std::move(tokens), slot});
  return slot;
}

void Parser::unbind(std::size_t slot) {
  std::erase_if(indices_, [&](const Index& one) { return one.slot == slot; });
}

Tree Parser::sum_of_terms() {
  limit(++depth_);
  while (take(R"(\,)")) continue;
  std::vector<Tree> terms;
  std::string marks;
  const char first = sign();
  marks += first == 0 ? '+' : first;
  terms.push_back(dot_products());
  for (char one = sign(); one != 0; one = sign()) {
    marks += one;
    terms.push_back(dot_products());
  }
  --depth_;
  if (marks.find_first_of("pm") == std::string::npos) return sum(std::move(terms), std::move(marks));
  const auto either = letters_.at({{R"(\pm)"}}, 0, {});
  return Tree({.kind = Kind::sum,
               .children = std::move(terms),
               .marks = std::move(marks),
               .entries = either ? either->entries : std::vector<Entry>{}});
}

char Parser::sign() {
  if (take("+")) return '+';
  if (take("-")) return '-';
  const bool lower = next() == R"(\mp)";
  if ((!lower && next() != R"(\pm)") || !letters_.has({R"(\pm)"})) return 0;
  ++at_;
  return lower ? 'm' : 'p';
}

Tree Parser::dot_products() {
  Tree tree = cross_products();
  for (std::size_t n = 0; take(R"(\cdot)"); limit(++n)) tree = made(Kind::dot, {tree, cross_products()});
  return tree;
}

Tree Parser::cross_products() {
  Tree tree = factors();
  for (std::size_t n = 0; take(R"(\times)"); limit(++n)) tree = made(Kind::cross, {tree, factors()});
  return tree;
}

Tree Parser::factors() {
  std::vector<Tree> all;
  std::string marks = "*";
  all.push_back(power());
  while (const char mark = joint()) {
    marks += mark;
    all.push_back(power());
  }
  return product(std::move(all), std::move(marks));
}

char Parser::joint() {
  while (take(R"(\,)")) continue;
  if (take("/")) return '/';
  return take("*") || begins_factor() ? '*' : '\0';
}

bool Parser::begins_function() const { return is_function(next()); }

bool Parser::begins_factor() const {
  const std::string& token = next();
  return !token.empty() &&
         !among(token, {"+", "-",     R"(\pm)",  R"(\mp)",   ")",         "]",     "}", ",", ";", "/", "=",
                        "&", R"(\\)", R"(\end)", R"(\cdot)", R"(\times)", R"(\,)", "*", "^", "_", "'"}) &&
         (token != "|" || !inside_bars_);
}

Tree Parser::power() {
  limit(++depth_);
  Tree tree = base_with_powers();
  --depth_;
  return tree;
}

Tree Parser::base_with_powers() {
  if (next() == R"(\sum)") return sum_over_index();
  if (begins_function()) {
    Tree tree = of_function();
    if (plain_ && take("^")) tree = made(Kind::power, {tree, argument()});
    return tree;
  }
  if (next() == "e" && next(1) == "^" && !letter_here()) {
    at_ += 2;
    return made(Kind::function, {argument()}, R"(\exp)");
  }
  Tree tree = base();
  for (std::size_t n = 0; take("^"); limit(++n)) {
    if (!plain_ && next() == "T") {
      const auto exponent = letter_here() ? std::optional(argument()) : std::nullopt;
      if (!exponent) ++at_;
      tree = made(Kind::transposed, exponent ? std::vector{tree, *exponent} : std::vector{tree});
    } else {
      tree = made(Kind::power, {tree, argument()});
    }
  }
  return tree;
}

Tree Parser::of_function() {
  std::string name = next();
  ++at_;
  const auto exponent = take("^") ? std::optional(argument()) : std::nullopt;
  Tree x = next() == "(" || next() == "{" ? base() : argument_of_function();
  int whole = 0;
  const bool inverse = exponent && is_whole(*exponent, whole) && whole == -1;
  if (inverse) name = inverse_of(name);
  Tree tree = made(Kind::function, {x}, name);
  return exponent && !inverse ? made(Kind::power, {tree, *exponent}) : tree;
}

Tree Parser::argument_of_function() {
  std::vector<Tree> all{power()};
  std::string marks = "*";
  while (begins_factor() && !begins_function() &&
         !among(next(), {"(", R"(\dot)", R"(\ddot)", R"(\mathbf)"})) {
    all.push_back(power());
    marks += '*';
  }
  return product(std::move(all), std::move(marks));
}

Tree Parser::sum_over_index() {
  const std::size_t begin = at_;
  expect(R"(\sum)");
  if (take_all({"_", R"(\sigma)"})) return sum_over_permutations();
  std::string index;
  std::optional<Tree> last;
  if (take_all({"_", "{"})) {
    index = next();
    ++at_;
    expect(R"(\le)");
    last = base();
    int whole = 0;
    if (!is_whole(*last, whole) && last->kind() != Kind::index)
      fail("a whole number or an index before this");
    expect("}");
  } else if (take("_")) {
    index = next();
    ++at_;
  } else {
    index = first_index();
  }
  if (index.empty()) fail("expected an index");
  const std::size_t slot = bind({index});
  Tree body = dot_products();
  unbind(slot);
  std::optional<std::set<int>> values;
  const bool uses = values_of_index(body, slot, values);
  if (!values && last) {
    values.emplace();
    for (int i = 0; i < 100; ++i) values->insert(i);
  }
  if (!uses || !values || values->empty()) {
    at_ = begin;
    fail("the sum has no letters with its index");
  }
  return Tree({.kind = Kind::sum_over,
               .text = index,
               .children = last ? std::vector{body, *last} : std::vector{body},
               .slots = {slot},
               .range = run_of(*values)});
}

std::string Parser::first_index() const {
  for (std::size_t i = at_; i + 1 < tokens_.size(); ++i)
    if (tokens_[i].text == "_" && among(tokens_[i + 1].text, {"i", "j", "k", "n"}))
      return tokens_[i + 1].text;
  fail("the sum has no index");
}

Tree Parser::sum_over_permutations() {
  std::set<int> places;
  for (std::size_t i = at_; i + 3 < tokens_.size(); ++i)
    if (tokens_[i].text == R"(\sigma)" && tokens_[i + 1].text == "(" && tokens_[i + 3].text == ")" &&
        is_digit(tokens_[i + 2].text[0]) && tokens_[i + 2].text.size() == 1)
      places.insert(tokens_[i + 2].text[0] - '0');
  const std::vector<int> run = run_of(places);
  if (run.empty() || run.size() != places.size() || run.front() != 1 || run.back() > 6)
    fail(R"(expected \sigma(1), \sigma(2) ... up to six)");
  std::vector<std::size_t> slots;
  for (const int k : run) slots.push_back(bind({R"(\sigma)", "(", std::to_string(k), ")"}));
  Tree body = sum_of_terms();
  for (const std::size_t slot : slots) {
    unbind(slot);
    std::optional<std::set<int>> values;
    values_of_index(body, slot, values);
    for (const int k : run)
      if (!values || !values->contains(k)) fail("letters for every permutation");
  }
  return Tree({.kind = Kind::permutations, .text = R"(\sigma)", .children = {body}, .slots = slots});
}

Tree Parser::argument() {
  if (plain_ && next() == "-") {
    ++at_;
    return negative(power());
  }
  if (next() != "{" && !plain_ && !next().empty() && is_digit(next()[0])) return number(first_digit());
  return base();
}

std::string Parser::first_digit() {
  std::string& token = tokens_[at_].text;
  std::string digit(1, token[0]);
  if (token.size() > 1) {
    token.erase(0, 1);
    ++tokens_[at_].begin;
  } else {
    ++at_;
  }
  return digit;
}

std::optional<Tree> Parser::letter_here() const {
  const auto found = letters_.at(tokens_, at_, indices_);
  if (!found) return std::nullopt;
  const std::size_t begin = tokens_[at_].begin, end = tokens_[at_ + found->length - 1].end;
  length_ = found->length;
  return Tree({.kind = Kind::letter,
               .text = plain_ ? tex_name(letters_.name(found->entries[0].rates[0]))
                              : std::string(text_.substr(begin, end - begin)),
               .slots = found->slots,
               .entries = found->entries});
}

std::optional<Tree> Parser::variable_here() {
  for (const auto& [name, slot] : variables_)
    if (next() == name && next(1) != "_" && next(1) != "'") {
      ++at_;
      return Tree({.kind = Kind::variable, .text = name, .slots = {slot}});
    }
  return std::nullopt;
}

std::optional<Tree> Parser::index_here() {
  for (const Index& index : indices_)
    if (index.tokens.size() == 1 && next() == index.tokens[0]) {
      ++at_;
      return Tree({.kind = Kind::index, .text = index.tokens[0], .slots = {index.slot}});
    }
  return std::nullopt;
}

Tree Parser::base() {
  if (at_ >= tokens_.size()) fail("expected a factor");
  if (auto variable = variable_here()) return *variable;
  if (auto letter = letter_here()) {
    at_ += length_;
    return *letter;
  }
  if (auto index = index_here()) return *index;
  if (take_all({R"(\varepsilon)", "_", R"(\sigma)"})) return Tree({.kind = Kind::permutation_sign});
  if (take_all({R"(\frac)", "d", "{", "d", "t", "}"})) return time_derivative();
  if (take_all({R"(\int)", "_"})) return integral();
  if (take(R"(\int)")) return along_curve();
  if (take_all({R"(\begin)", "{", "p", "m", "a", "t", "r", "i", "x", "}"})) return matrix();
  if (take(R"(\frac)")) {
    Tree above = argument();
    return made(Kind::fraction, {above, argument()});
  }
  if (take_all({R"(\mathrm)", "{", "D", "i", "a", "g", "}", "("}))
    return made(Kind::diagonal, {closed_by(")")});
  if (take_all({R"(\mathrm)", "{", "S", "k", "e", "w", "}", "("})) return made(Kind::skew, {closed_by(")")});
  if (take_all({R"(\mathrm)", "{", "U", "n", "s", "k", "e", "w", "}", "("}))
    return made(Kind::unskew, {closed_by(")")});
  if (take(R"(\sqrt)")) return made(Kind::root, {argument()});
  if (take(R"(\abs)")) return made(Kind::bars, {argument()});
  if (among(next(), {R"(\max)", R"(\min)"}))
    return of_all(next() == R"(\max)" ? Kind::largest : Kind::smallest);
  if (among(next(), {R"(\dotproduct)", R"(\crossproduct)"}))
    return of_all(next() == R"(\dotproduct)" ? Kind::dot : Kind::cross);
  if (take("{")) return closed_by("}");
  if (take("(")) return closed_by(")");
  if (take("[")) return closed_by("]");
  if (take("|")) return between_bars();
  if (take(R"(\pi)") || (plain_ && take("pi"))) return Tree({.kind = Kind::pi});
  return numeral();
}

Tree Parser::numeral() {
  const std::string& token = next();
  if (token.empty() || (!is_digit(token[0]) && !(token[0] == '.' && token.size() > 1))) unknown();
  ++at_;
  return number(token);
}

void Parser::unknown() const {
  std::string name = next();
  if (among(name, {"", ")", "]", "}", "+", "-", "*", "/", "^", "_", "'", ",", ";", ":", "=", "&", "|"}))
    fail("expected a number, a letter or (");
  std::size_t end = at_ + (among(name, {R"(\dot)", R"(\ddot)", R"(\mathbf)"}) ? 2 : 1);
  if (end + 1 < tokens_.size() && tokens_[end].text == "_") {
    end += 2;
    while (tokens_[end - 1].text != "}" && tokens_[at_ + (end - at_ > 2 ? 2 : 0)].text == "{" &&
           end < tokens_.size())
      ++end;
  }
  end = std::min(end, tokens_.size());
  name = text_.substr(tokens_[at_].begin, tokens_[end - 1].end - tokens_[at_].begin);
  std::string reason = "no letter " + name + " here";
  const auto similar = letters_.similar_to(name);
  for (std::size_t i = 0; i < similar.size(); ++i) reason += (i == 0 ? "; " : ", ") + similar[i];
  fail(reason + (similar.empty() ? "" : "?"));
}

Tree Parser::between_bars() {
  const bool outside = std::exchange(inside_bars_, true);
  Tree x = sum_of_terms();
  inside_bars_ = outside;
  expect("|");
  return made(Kind::bars, {x});
}

Tree Parser::closed_by(std::string_view end) {
  const bool outside = std::exchange(inside_bars_, false);
  std::vector<Tree> all{sum_of_terms()};
  std::string marks = ",";
  while (next() == "," || next() == ";") {
    const bool row = take(";");
    if (!row) take(",");
    marks += row ? ';' : ',';
    all.push_back(sum_of_terms());
  }
  inside_bars_ = outside;
  expect(end);
  if (all.size() == 1) return all[0];
  return Tree({.kind = Kind::tuple, .children = std::move(all), .marks = std::move(marks)});
}

Tree Parser::of_all(Kind kind) {
  ++at_;
  const bool braces = next() == "{";
  if (!braces && next() != "(") fail("expected (");
  ++at_;
  const Tree all = closed_by(braces ? "}" : ")");
  if (all.kind() != Kind::tuple || all->children.size() != 2) fail("two of them in parentheses before this");
  return made(kind, all->children);
}

Tree Parser::matrix() {
  std::vector<Tree> rows{row()};
  while (take(R"(\\)")) rows.push_back(row());
  if (!take_all({R"(\end)", "{", "p", "m", "a", "t", "r", "i", "x", "}"})) fail("expected the matrix's end");
  return made(Kind::matrix, std::move(rows));
}

Tree Parser::row() {
  std::vector<Tree> all{sum_of_terms()};
  while (take("&")) all.push_back(sum_of_terms());
  return made(Kind::row, std::move(all));
}

Tree Parser::time_derivative() {
  const std::size_t begin = at_;
  Tree changing = power();
  try {
    return time_derivative_of(changing);
  } catch (const NoValue& reason) {
    at_ = begin;
    fail(reason.what());
  }
}

Tree Parser::integral() {
  Tree from = argument();
  expect("^");
  Tree to = argument();
  const std::size_t end = end_of_integrand();
  if (end + 2 >= tokens_.size()) fail("expected an integrand, \\,d and its variable");
  const std::string variable = tokens_[end + 2].text;
  const std::size_t slot = slots_++;
  variables_.insert(variables_.begin(), {variable, slot});
  Tree integrand = up_to(end);
  variables_.erase(variables_.begin());
  at_ = end + 3;
  return Tree({.kind = Kind::integral, .text = variable, .children = {from, to, integrand}, .slots = {slot}});
}

std::size_t Parser::end_of_integrand() const {
  std::size_t end = at_, inner = 0;
  for (; end + 2 < tokens_.size(); ++end)
    if (tokens_[end].text == R"(\int)" && tokens_[end + 1].text == "_")
      ++inner;
    else if (tokens_[end].text == R"(\,)" && tokens_[end + 1].text == "d" && inner-- == 0)
      break;
  return end;
}

Tree Parser::up_to(std::size_t end) {
  const Tokens after(tokens_.begin() + static_cast<std::ptrdiff_t>(end), tokens_.end());
  tokens_.resize(end);
  Tree tree = sum_of_terms();
  if (at_ < end) fail("the integrand ends before this");
  tokens_.insert(tokens_.end(), after.begin(), after.end());
  return tree;
}

Tree Parser::along_curve() {
  std::size_t end = at_;
  while (end + 1 < tokens_.size() && !(tokens_[end].text == "d" && tokens_[end + 1].text == "s")) ++end;
  if (end + 1 >= tokens_.size()) fail("expected an integrand and \\,ds");
  Tree integrand = end == at_ ? number("1") : up_to(end);
  const auto weights = letter_here();
  if (!weights || length_ != 2) fail("no letter ds here");
  at_ += length_;
  return made(Kind::along_curve, {integrand, *weights});
}

namespace {

Tree parsed(std::string_view text, const Vocabulary& letters, bool plain) {
  if (text.size() > longest_text) throw Unreadable(text, longest_text, "at most 20,000 characters");
  const auto length_of_name = [&](std::string_view rest) { return letters.length_of_name(rest); };
  const Tokens tokens = plain ? plain_tokens(text, length_of_name) : tex_tokens(text);
  try {
    return Parser(text, tokens, letters, plain).all();
  } catch (const Unreadable&) {
    if (plain || indices_in(tokens).empty()) throw;
    try {
      return Parser(text, tokens, letters, plain).in_index_notation();
    } catch (const Unreadable&) {
    }
    throw;
  }
}

}  // namespace

Tree parse_tex(std::string_view text, const Names& names) {
  return parsed(text, Vocabulary(names, false), false);
}
Tree parse_plain(std::string_view text, const Names& names) {
  return parsed(text, Vocabulary(names, true), true);
}

PlainReader::PlainReader(const Names& names) : letters_(std::make_shared<const Vocabulary>(names, true)) {}
std::size_t PlainReader::letters() const { return letters_->size(); }
Tree PlainReader::operator()(std::string_view text) const { return parsed(text, *letters_, true); }

Sides sides_of(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> relations[]{
      {R"(\le)", R"(\le)"}, {R"(\ge)", R"(\ge)"}, {R"(\ne)", R"(\ne)"}, {R"(\to)", "="}, {"<=", R"(\le)"},
      {">=", R"(\ge)"},     {"!=", R"(\ne)"},     {"=", "="},           {"<", "<"},      {">", ">"}};
  Sides found;
  int depth = 0;
  while (!text.empty()) {
    depth += text.front() == '{' ? 1 : text.front() == '}' ? -1 : 0;
    const auto* one = std::ranges::find_if(relations, [&](const auto& relation) {
      const std::size_t n = relation.first.size();
      const bool goes_on = relation.first[0] == '\\' && n < text.size() &&
                           std::isalpha(static_cast<unsigned char>(text[n])) != 0;
      return depth == 0 && text.starts_with(relation.first) && !goes_on;
    });
    if (one == std::end(relations)) {
      found.sides.back() += text.front();
      text.remove_prefix(1);
    } else {
      found.relations.emplace_back(one->second);
      found.sides.emplace_back();
      text.remove_prefix(one->first.size());
    }
  }
  return found;
}

namespace {

Relation relation_of(std::string_view text, Tree (*parse)(std::string_view, const Names&),
                     const Names& names) {
  Sides sides = sides_of(text);
  Relation relation{{}, std::move(sides.relations)};
  for (const std::string& side : sides.sides) relation.sides.push_back(parse(side, names));
  return relation;
}

}  // namespace

Relation parse_tex_relation(std::string_view text, const Names& names) {
  return relation_of(text, parse_tex, names);
}
Relation parse_plain_relation(std::string_view text, const Names& names) {
  return relation_of(text, parse_plain, names);
}

bool is_formula(std::string_view text) {
  return text.size() > 2 && text.front() == '$' && text.find('$', 1) == text.size() - 1;
}

}  // namespace oddity::formula
