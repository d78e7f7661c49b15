#include "problem/ode_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "formula/tokens.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"

namespace oddity::problem {

namespace {

constexpr std::size_t most_statements = 20'000, most_of_a_formula = 20'000;
constexpr int deepest = 100;
constexpr long most_work = 1'000'000;

using formula::is_digit;
bool begins_name(char c) { return (c >= 'a' && c <= 'z') || c == '_'; }
bool in_name(char c) { return begins_name(c) || is_digit(c); }
bool among(std::string_view word, const auto& all) { return std::ranges::find(all, word) != std::end(all); }

/// A statement in lower case: a line of the file, with its continuation lines.
struct Statement {
  std::string text;
  std::vector<std::pair<std::size_t, Place>> pieces;  ///< start within the text, and place in the file

  Place at(std::size_t offset) const {
    auto piece = pieces.begin();
    while (piece + 1 != pieces.end() && (piece + 1)->first <= offset) ++piece;
    return {piece->second.line, piece->second.column + offset - piece->first};
  }
};

std::vector<Statement> statements_of(const std::string& text) {
  std::vector<Statement> all;
  bool goes_on = false;
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string one = text.substr(begin, end - begin);
    begin = end + 1;
    for (char& c : one)
      c = c == '\r' || c == '\t' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const bool is_comment = !goes_on && one.starts_with('#');
    if (!goes_on) all.emplace_back();
    all.back().pieces.emplace_back(all.back().text.size(), Place{line, 1});
    const std::size_t last = one.find_last_not_of(' ');
    goes_on = last != one.npos && one[last] == '\\' && !is_comment;
    all.back().text += goes_on ? one.substr(0, last) : one;
  }
  return all;
}

// ---- formulas as they are written ------------------------------------------------------------------------

struct Node {
  enum class Is { number, name, call, negative, operation, choice, sum };
  Is is = Is::number;
  std::string text;  ///< a numeral, a name, an operator
  std::vector<Node> parts = {};
  Place place = {};
};

struct Function {
  std::string_view name;
  std::size_t arguments;
};
// clang-format off
constexpr Function functions[]{
    {"sin", 1}, {"cos", 1}, {"tan", 1}, {"asin", 1}, {"acos", 1}, {"atan", 1}, {"sinh", 1}, {"cosh", 1}, {"tanh", 1},
    {"exp", 1}, {"ln", 1}, {"log", 1}, {"log10", 1}, {"sqrt", 1}, {"abs", 1}, {"heav", 1}, {"sign", 1}, {"flr", 1},
    {"ceil", 1}, {"not", 1}, {"atan2", 2}, {"max", 2}, {"min", 2}, {"mod", 2}, {"shift", 2}};
/// Unsupported functions, and the reason.
constexpr std::pair<std::string_view, std::string_view> not_here[]{
    {"delay", "delays"}, {"del_shft", "delays"}, {"ran", "random numbers"}, {"normal", "random numbers"},
    {"poisson", "random numbers"}, {"int", "integral equations"}, {"hom_bcs", "boundary values"},
    {"besselj", "Bessel functions"}, {"bessely", "Bessel functions"}, {"besseli", "Bessel functions"},
    {"erf", "the error function"}, {"erfc", "the error function"}, {"lgamma", "the gamma function"}};
// clang-format on
constexpr const char *maps = "there are no maps here, whose time goes in steps",
                     *other_files = "other files are not opened";
std::string none_here(std::string_view what) { return "there are no " + std::string(what) + " here"; }

/// Reads pieces of a statement, for one value of its index j.
class Reader {
 public:
  Reader(const Source& source, const Statement& statement, std::optional<long> j)
      : source_(source), statement_(statement), text_(statement.text), j_(j) {}

  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    source_.fail(statement_.at(at), reason);
  }
  [[noreturn]] void fail(const std::string& reason) const { fail(std::min(at_, text_.size()), reason); }
  const std::string& text() const { return text_; }
  std::size_t at() const { return at_; }
  Place place() const { return statement_.at(at_); }
  void go_to(std::size_t at) { at_ = at; }
  void blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool is_done() {
    blanks();
    return at_ == text_.size();
  }
  char next() {
    blanks();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(std::string_view token) {
    blanks();
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }
  void expect(std::string_view token) {
    if (!take(token)) fail("expected " + std::string(token));
  }
  void end() {
    if (!is_done()) fail("the statement ends before this");
  }

  /// "x", "x[j-1]": the number is appended to the name.
  std::string name() {
    blanks();
    const std::size_t begin = at_;
    std::string name;
    while (at_ < text_.size() && (in_name(text_[at_]) || text_[at_] == '[')) {
      if (text_[at_] == '[') {
        const std::size_t at = at_;
        const long i = index();
        if (i < 0) fail(at, "the index is below zero");
        name += std::to_string(i);
      } else
        name += text_[at_++];
    }
    if (name.empty() || !begins_name(name[0])) fail(begin, "expected a name");
    return name;
  }
  /// [j], [j+1], [3], and the range in [1..9], which means j.
  long index() {
    const std::size_t begin = at_;
    expect("[");
    const std::size_t close = text_.find(']', at_);
    if (close == text_.npos) fail(begin, "this bracket is not closed");
    if (text_.substr(at_, close - at_).find("..") != std::string::npos) {
      if (!j_) fail(begin, "a range is of whole numbers of at most five digits, such as [1..9]");
      at_ = close + 1;
      return *j_;
    }
    long value = 0;
    if (take("j")) {
      if (!j_) fail(begin, "no range is given for j, such as x[1..9]'");
      value = *j_;
      if (const char sign = next(); sign == '+' || sign == '-' || sign == '*') {
        ++at_;
        const long by = whole();
        value = sign == '+' ? value + by : sign == '-' ? value - by : value * by;
      }
    } else {
      value = whole();
    }
    expect("]");
    return value;
  }
  long whole() {
    blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    if (at_ == begin || at_ - begin > 6) fail(begin, "expected a whole number of at most six digits");
    return std::stol(text_.substr(begin, at_ - begin));
  }

  /// "-1.5e-3", "[j]".
  double value() {
    blanks();
    const std::size_t begin = at_;
    const bool minus = take("-");
    if (!minus) take("+");
    const double x = next() == '[' ? static_cast<double>(index()) : number();
    if (at_ < text_.size() && text_[at_] != ' ' && text_[at_] != ',' && text_[at_] != ';' &&
        text_[at_] != '}')
      fail(begin, "expected a number, and no formula: !name=formula is a derived one");
    return minus ? -x : x;
  }
  double number() {
    const std::size_t begin = at_;
    const auto x = parse_number(numeral());
    if (!x || !std::isfinite(*x)) fail(begin, "expected a number");
    return *x;
  }
  /// ".5", "2." and "1.e3" as 0.5, 2 and 1e3.
  std::string numeral() {
    blanks();
    const std::size_t begin = at_;
    const auto digits = [&] {
      std::string all;
      while (at_ < text_.size() && is_digit(text_[at_])) all += text_[at_++];
      return all;
    };
    std::string whole = digits(), decimals, power;
    if (at_ < text_.size() && text_[at_] == '.') ++at_, decimals = digits();
    if (whole.empty() && decimals.empty()) fail(begin, "expected a number");
    if (at_ < text_.size() && text_[at_] == 'e') {
      const std::size_t e = at_++;
      const bool minus = at_ < text_.size() && text_[at_] == '-';
      if (minus || (at_ < text_.size() && text_[at_] == '+')) ++at_;
      power = digits();
      if (power.empty())
        at_ = e;
      else
        power = (minus ? "e-" : "e") + power;
    }
    if (power.size() > 5) fail(begin, "a number that is too large or too small");
    return (whole.empty() ? "0" : whole) + (decimals.empty() ? "" : "." + decimals) + power;
  }

  /// XPPAUT's order: ^ and comparisons, then * / &, then + - |, each from the left.
  Node formula() {
    if (++depth_ > deepest) fail("at most 100 levels, one within another");
    Node left = term(true);
    while (const auto sign = one_of({"+", "-", "|"})) left = joined(*sign, std::move(left), term(false));
    --depth_;
    return left;
  }

 private:
  std::optional<std::string> one_of(std::initializer_list<std::string_view> all) {
    for (const std::string_view one : all)
      if (take(one)) return std::string(one);
    return {};
  }
  static Node joined(std::string sign, Node left, Node right) {
    const Place place = left.place;
    if (sign == "**") sign = "^";
    return {Node::Is::operation, std::move(sign), {std::move(left), std::move(right)}, place};
  }
  Node term(bool may_be_negative) {
    const Place begin = place();
    Node left;
    if (may_be_negative && take("-"))
      left = {Node::Is::negative, "-", {factor()}, begin};
    else
      left = factor();
    while (true) {
      if (text_.compare(at_, 2, "**") == 0) break;
      const auto sign = one_of({"*", "/", "&"});
      if (!sign) return left;
      left = joined(*sign, std::move(left), factor());
    }
    return left;
  }
  Node factor() {
    Node left = atom();
    while (const auto sign = one_of({"^", "**", "<=", ">=", "==", "!=", "<", ">"}))
      left = joined(*sign, std::move(left), atom());
    return left;
  }
  Node in_parentheses() {
    expect("(");
    Node inside = formula();
    expect(")");
    return inside;
  }
  Node atom() {
    const char c = next();
    const Place begin = place();
    if (c == '(') return in_parentheses();
    if (c == '[') {
      const long i = index();
      const Node number{Node::Is::number, std::to_string(std::abs(i)), {}, begin};
      return i < 0 ? Node{Node::Is::negative, "-", {number}, begin} : number;
    }
    if (is_digit(c) || c == '.') return {Node::Is::number, numeral(), {}, begin};
    if (c == '-' || c == '+') fail("a sign follows an operator: put it in parentheses with its operand");
    if (!begins_name(c)) fail(c == '\0' ? "the formula ends too early" : "expected a number, a name or (");
    const std::size_t at = at_;
    if (text_.compare(at, 4, "int[") == 0) fail(none_here("integral equations"));
    const std::string word = name();
    for (const auto& [function, what] : not_here)
      if (word == function && (next() == '(' || next() == '{')) fail(at, none_here(what));
    if (word == "if") {
      Node all{Node::Is::choice, word, {in_parentheses()}, begin};
      expect("then");
      all.parts.push_back(in_parentheses());
      expect("else");
      all.parts.push_back(in_parentheses());
      return all;
    }
    if (word == "sum") {
      Node all{Node::Is::sum, word, arguments(), begin};
      if (all.parts.size() != 2) fail(at, "sum takes two bounds: sum(0,9)of(...)");
      expect("of");
      all.parts.push_back(in_parentheses());
      return all;
    }
    if (word == "i" && text_.compare(at_, 1, "'") == 0) {
      ++at_;
      return {Node::Is::name, "i'", {}, begin};
    }
    if (next() != '(') return {Node::Is::name, word, {}, begin};
    return {Node::Is::call, word, arguments(), begin};
  }
  std::vector<Node> arguments() {
    std::vector<Node> all;
    expect("(");
    do all.push_back(formula());
    while (take(","));
    expect(")");
    return all;
  }

  const Source& source_;
  const Statement& statement_;
  const std::string& text_;
  std::optional<long> j_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

// ---- in the notation of formula/ -------------------------------------------------------------------------

/// Text, and the binding strength of its operator: 1 a sum, 2 a product, 3 a power, 4 anything whole.
struct Piece {
  std::string text;
  int binds = 4;

  std::string at_least(int strength) const { return binds < strength ? "(" + text + ")" : text; }
};

enum class Role { parameter, constant, fixed, variable };

struct OwnFunction {
  std::vector<std::string> arguments;
  Node body;
};

/// The names of a file.
struct Names {
  std::map<std::string, Role> roles;
  std::vector<std::string> in_order[4];  ///< by role
  std::map<std::string, OwnFunction> functions;
  double begins = 0;  ///< start time

  const std::vector<std::string>& all(Role role) const { return in_order[static_cast<int>(role)]; }
};

/// Texts to put for names in a function or a sum.
using Meanings = std::map<std::string, Piece>;

class Writer {
 public:
  Writer(const Source& source, const Names& names) : source_(source), names_(names) {}

  Piece written(const Node& node, const Meanings& meanings = {}) { return piece(node, meanings); }
  /// Sets the name's value from here on, as in an event whose parts follow each other.
  void set(const std::string& name, const Piece& value) { changed_.insert_or_assign(name, value); }
  void reset() { changed_.clear(); }

 private:
  [[noreturn]] void fail(const Node& node, const std::string& reason) const {
    source_.fail(node.place, reason);
  }

  Piece piece(const Node& node, const Meanings& meanings) {
    if (++work_ > most_work)
      fail(node, "this file's formulas are too long when functions and sums are written out");
    if (++depth_ > 2 * deepest)
      fail(node, "at most 200 levels, one within another; a function cannot call itself");
    Piece made = piece_of(node, meanings);
    --depth_;
    if (made.text.size() > most_of_a_formula)
      fail(node, "a formula has at most 20,000 characters when functions and sums are written out");
    return made;
  }
  Piece piece_of(const Node& node, const Meanings& meanings) {
    const auto part = [&](std::size_t i) { return piece(node.parts[i], meanings); };
    switch (node.is) {
      case Node::Is::number:
        return {node.text};
      case Node::Is::name:
        return of_name(node, meanings);
      case Node::Is::negative:
        return {"-" + part(0).at_least(2), 1};
      case Node::Is::choice:
        return branch(node.parts[0], part(1), part(2), meanings);
      case Node::Is::sum:
        return sum(node, meanings);
      case Node::Is::call:
        return call(node, meanings);
      case Node::Is::operation:
        break;
    }
    const char sign = node.text[0];
    if (is_condition(node)) return branch(node, {"1"}, {"0"}, meanings);
    const int binds = sign == '^' ? 3 : sign == '*' || sign == '/' ? 2 : 1;
    const Piece left = part(0), right = part(1);
    return {left.at_least(sign == '^' ? 4 : binds) + sign + right.at_least(binds + 1), binds};
  }

  Piece of_name(const Node& node, const Meanings& meanings) {
    if (const auto found = meanings.find(node.text); found != meanings.end()) return found->second;
    if (const auto found = changed_.find(node.text); found != changed_.end()) return found->second;
    if (node.text == "t")
      return names_.begins == 0 ? Piece{"t"} : Piece{"t+" + format_shortest(names_.begins), 1};
    if (node.text == "pi" || names_.roles.contains(node.text)) return {node.text};
    if (node.text == "i'") fail(node, "i' is the index of a sum, and this is in none");
    std::vector<std::string> known{"t", "pi"};
    for (const auto& [name, role] : names_.roles) known.push_back(name);
    fail(node, "no letter " + node.text + did_you_mean(node.text, known));
  }

  static bool is_condition(const Node& node) {
    return node.is == Node::Is::operation &&
           among(node.text, std::array<std::string_view, 8>{"<", ">", "<=", ">=", "==", "!=", "&", "|"});
  }
  /// `yes` if the condition is not zero, otherwise `no`.
  Piece branch(const Node& condition, const Piece& yes, const Piece& no, const Meanings& meanings) {
    const auto of = [&](const std::string& what, bool is_so) {
      return Piece{"if(" + what + "," + (is_so ? yes : no).text + "," + (is_so ? no : yes).text + ")"};
    };
    if (condition.is == Node::Is::call && condition.text == "not" && condition.parts.size() == 1)
      return branch(condition.parts[0], no, yes, meanings);
    if (!is_condition(condition)) return of("abs(" + piece(condition, meanings).text + ") > 0", true);
    const Node &left = condition.parts[0], &right = condition.parts[1];
    if (condition.text == "&") return branch(left, branch(right, yes, no, meanings), no, meanings);
    if (condition.text == "|") return branch(left, yes, branch(right, yes, no, meanings), meanings);
    const Piece a = piece(left, meanings), b = piece(right, meanings);
    if (condition.text == "<" || condition.text == ">=")
      return of(a.text + " < " + b.text, condition.text == "<");
    if (condition.text == ">" || condition.text == "<=")
      return of(a.text + " > " + b.text, condition.text == ">");
    return of("abs(" + a.text + "-" + b.at_least(2) + ") > 0", condition.text == "!=");
  }

  Piece sum(const Node& node, const Meanings& meanings) {
    const long first = whole(node.parts[0], meanings), last = whole(node.parts[1], meanings);
    if (last < first || last - first > 1000) fail(node, "a sum goes up, over at most 1,000");
    Meanings inside = meanings;
    std::string all;
    for (long i = first; i <= last; ++i) {
      inside.insert_or_assign("i'", Piece{std::to_string(i), i < 0 ? 1 : 4});
      all += (all.empty() ? "" : "+") + piece(node.parts[2], inside).at_least(2);
      if (all.size() > most_of_a_formula) break;
    }
    return {all, 1};
  }
  /// A constant number.
  long whole(const Node& node, const Meanings& meanings) {
    if (node.is == Node::Is::number && node.text.size() < 7)
      if (const auto x = parse_number(node.text); x && *x == std::floor(*x)) return static_cast<long>(*x);
    if (node.is == Node::Is::negative) return -whole(node.parts[0], meanings);
    if (node.is == Node::Is::name)
      if (const auto found = meanings.find(node.text);
          found != meanings.end() && found->second.text.size() < 7)
        if (const auto x = parse_number(found->second.text); x && *x == std::floor(*x))
          return static_cast<long>(*x);
    if (node.is == Node::Is::operation && (node.text == "+" || node.text == "-")) {
      const long a = whole(node.parts[0], meanings), b = whole(node.parts[1], meanings);
      return node.text == "+" ? a + b : a - b;
    }
    fail(node, "expected a whole number here, or i'");
  }

  Piece call(const Node& node, const Meanings& meanings) {
    const auto require = [&](std::size_t wanted) {
      if (node.parts.size() != wanted)
        fail(node, node.text + " takes " + std::to_string(wanted) + ", and has " +
                       std::to_string(node.parts.size()));
    };
    if (const auto own = names_.functions.find(node.text); own != names_.functions.end()) {
      const OwnFunction& f = own->second;
      require(f.arguments.size());
      Meanings inside;
      for (std::size_t k = 0; k < f.arguments.size(); ++k)
        inside.insert_or_assign(f.arguments[k], piece(node.parts[k], meanings));
      return piece(f.body, inside);
    }
    const auto* f = std::ranges::find(functions, node.text, &Function::name);
    if (f == std::end(functions)) unknown_function(node);
    require(f->arguments);
    if (node.text == "shift") return shift(node, meanings);
    if (node.text == "not") return branch(node.parts[0], {"0"}, {"1"}, meanings);
    std::string x = piece(node.parts[0], meanings).text;
    if (node.text == "heav") return {"if(0 > " + x + ",0,1)"};
    if (node.text == "log") return {"ln(" + x + ")"};
    if (node.text == "log10") return {"ln(" + x + ")/ln(10)", 2};
    if (node.text == "flr") return {x + "-" + beyond_whole(x), 1};
    if (node.text == "ceil") return {x + "+" + beyond_whole("-(" + x + ")"), 1};
    if (f->arguments == 1) return {node.text + "(" + x + ")"};
    const Piece y = piece(node.parts[1], meanings);
    if (node.text == "mod") return {y.at_least(2) + "*" + beyond_whole("(" + x + ")/" + y.at_least(3)), 2};
    return {node.text + "(" + x + "," + y.text + ")"};
  }
  /// Fractional part of x, by an arc that jumps only where x is whole.
  static std::string beyond_whole(const std::string& x) {
    const std::string sine = "sin(pi*(" + x + "))", cosine = "cos(pi*(" + x + "))";
    return "(0.5+if(0 > " + sine + ",atan2(" + cosine + ",-" + sine + "),atan2(-" + cosine + "," + sine +
           "))/pi)";
  }
  /// The name so many places later, in the order in which names of its kind are defined.
  Piece shift(const Node& node, const Meanings& meanings) {
    const Node& from = node.parts[0];
    const auto role = names_.roles.find(from.text);
    if (from.is != Node::Is::name || role == names_.roles.end())
      fail(from, "shift takes a name, and how far");
    const auto& all = names_.all(role->second);
    const long place = std::ranges::find(all, from.text) - all.begin() + whole(node.parts[1], meanings);
    if (place < 0 || place >= static_cast<long>(all.size()))
      fail(node, "nothing is defined so far from " + from.text);
    return of_name({Node::Is::name, all[static_cast<std::size_t>(place)], {}, from.place}, meanings);
  }
  [[noreturn]] void unknown_function(const Node& node) const {
    if (names_.roles.contains(node.text))
      fail(node, node.text + " is no function: write " + node.text + "*(...)");
    std::vector<std::string> known;
    for (const Function& f : functions) known.emplace_back(f.name);
    for (const auto& [name, f] : names_.functions) known.push_back(name);
    fail(node, "no function " + node.text + did_you_mean(node.text, known));
  }

  const Source& source_;
  const Names& names_;
  Meanings changed_;
  long work_ = 0;
  int depth_ = 0;
};

// ---- statements ------------------------------------------------------------------------------------------

enum class Keyword {
  parameters,
  constants,
  starts,
  found,
  aux,
  event,
  boundary,
  ends,
  ignored,
  refused,
  files
};

struct Word {
  std::string_view word;
  Keyword is;
  std::string_view missing = {};
};
constexpr std::string_view random_numbers = "random numbers", tables = "tables",
                           integrals = "integral equations";
// clang-format off
constexpr Word words[]{
    {"p", Keyword::parameters}, {"par", Keyword::parameters}, {"param", Keyword::parameters}, {"params", Keyword::parameters},
    {"parameter", Keyword::parameters}, {"parameters", Keyword::parameters},
    {"num", Keyword::constants}, {"number", Keyword::constants}, {"numbers", Keyword::constants},
    {"i", Keyword::starts}, {"init", Keyword::starts}, {"initial", Keyword::starts},
    {"a", Keyword::aux}, {"aux", Keyword::aux}, {"g", Keyword::event}, {"global", Keyword::event},
    {"b", Keyword::boundary}, {"bc", Keyword::boundary}, {"bdry", Keyword::boundary}, {"bndry", Keyword::boundary},
    {"d", Keyword::ends}, {"done", Keyword::ends}, {"set", Keyword::ignored}, {"only", Keyword::ignored},
    {"w", Keyword::refused, random_numbers}, {"wiener", Keyword::refused, random_numbers},
    {"m", Keyword::refused, random_numbers}, {"markov", Keyword::refused, random_numbers},
    {"t", Keyword::refused, tables}, {"tab", Keyword::refused, tables}, {"table", Keyword::refused, tables},
    {"tabular", Keyword::refused, tables}, {"special", Keyword::refused, "sums over tables and networks"},
    {"v", Keyword::refused, integrals}, {"volt", Keyword::refused, integrals}, {"volterra", Keyword::refused, integrals},
    {"solv", Keyword::found}, {"solve", Keyword::found},
    {"export", Keyword::files}, {"o", Keyword::files}, {"option", Keyword::files}, {"options", Keyword::files}};
// clang-format on

/// Makes a File from a file's statements.
class Making {
 public:
  Making(const Source& source, File& file) : source_(source), file_(file) {}

  void read(const std::vector<Statement>& all) {
    for (std::size_t i = 0; i < all.size() && !is_done_; ++i) {
      const std::size_t begin = all[i].text.find_first_not_of(' ');
      if (begin == std::string::npos || all[i].text[begin] != '%') {
        read(all[i], {});
        continue;
      }
      const auto range = range_in(all[i]);
      if (!range) source_.fail(all[i].at(begin), "expected a range, such as %[1..9], and % behind its lines");
      std::size_t end = i + 1;
      while (end < all.size() && !all[end].text.starts_with('%')) ++end;
      for (long j = range->first; j <= range->second; ++j)
        for (std::size_t k = i + 1; k < end; ++k) read(all[k], j);
      i = end;
    }
  }

  void make() {
    if (equations_.empty()) source_.fail({1, 1}, "no equation: add one such as x' = -x");
    if (conditions_.size() != found_.size())
      source_.fail(conditions_.empty() ? equations_.front().place : conditions_.back().place,
                   "conditions (0 = ...) are " + std::to_string(conditions_.size()) +
                       ", and the unknowns that solve names for them " + std::to_string(found_.size()));
    names_.begins = begins_;
    Writer writer(source_, names_);
    ModelText& model = file_.models.emplace_back();
    model.name = {"as written", equations_.front().place, true};
    const auto text = [&](const Defined& one, const std::string& head) {
      return Quoted{head + writer.written(one.formula).text, one.place, true};
    };
    for (const Defined& one : equations_) model.equations.push_back(text(one, one.name + "' = "));
    for (const Defined& one : conditions_) model.conditions.push_back(text(one, ""));
    model.found = found_;
    for (const Event& one : events_) model.events.push_back(written(one, writer));
    std::map<std::string, Quoted> fixed;
    for (const Defined& one : fixed_) fixed.emplace(one.name, text(one, ""));
    for (const Defined& one : unused_) writer.written(one.formula);
    for (const auto& [name, f] : names_.functions) {
      Meanings own;
      for (const std::string& argument : f.arguments) own.insert({argument, {"0"}});
      writer.written(f.body, own);
    }
    add_used(model, fixed);
    add_parameters(model);
    for (const std::string& name : names_.all(Role::variable))
      file_.observables.push_back(
          {name, "", "", {name, equations_.front().place, true}, equations_.front().place});
    file_.end = total_;
    file_.horizon = format_shortest(total_);
    file_.frames_per_second = format_shortest(1 / (step_ * rows_));
  }

 private:
  struct Defined {
    std::string name;
    Node formula;
    Place place;
  };
  struct Event {
    Node when;
    Direction direction;
    std::vector<Defined> then;
    Place place;
  };

  static std::optional<std::pair<long, long>> range_in(const Statement& statement) {
    const std::string& text = statement.text;
    const std::size_t dots = text.find("..");
    if (dots == text.npos || dots == 0) return {};
    std::size_t begin = dots, end = dots + 2;
    while (begin > 0 && is_digit(text[begin - 1])) --begin;
    while (end < text.size() && is_digit(text[end])) ++end;
    const std::size_t most = 5;
    if (begin == dots || end == dots + 2 || dots - begin > most || end - dots - 2 > most || begin == 0 ||
        text[begin - 1] != '[')
      return {};
    return std::pair(std::stol(text.substr(begin, dots - begin)),
                     std::stol(text.substr(dots + 2, end - dots - 2)));
  }

  void read(const Statement& statement, std::optional<long> j) {
    const std::size_t begin = statement.text.find_first_not_of(' ');
    if (begin == std::string::npos || is_done_) return;
    const char first = statement.text[begin];
    if (first == '"') return;
    if (first == '#') return comment(statement, begin);
    const auto range = first == '@' ? std::nullopt : range_in(statement);
    if (!range) return once(statement, begin, j);
    if (range->second < range->first) source_.fail(statement.at(begin), "a range goes up: [1..9]");
    for (long i = range->first; i <= range->second; ++i) once(statement, begin, i);
  }
  void comment(const Statement& statement, std::size_t begin) {
    const std::string text = statement.text.substr(begin + 1);
    if (text.starts_with("include")) source_.fail(statement.at(begin), other_files);
  }

  void once(const Statement& statement, std::size_t begin, std::optional<long> j) {
    if (++statements_ > most_statements)
      source_.fail(statement.at(begin),
                   "a file has at most 20,000 statements, those of ranges counted singly");
    Reader r(source_, statement, j);
    r.go_to(begin);
    if (r.take("@")) return options(r);
    if (r.take("!")) return define(r, r.name(), Role::constant, statement.at(begin));
    std::size_t end = begin;
    while (end < statement.text.size() && in_name(statement.text[end])) ++end;
    const std::string word = statement.text.substr(begin, end - begin);
    const auto* keyword = std::ranges::find(words, word, &Word::word);
    r.go_to(end);
    const char next = r.next();
    const bool defines = next == '=' || next == '\'' || (next == '(' && word.size() == 1);
    if (keyword != std::end(words) && (next == '\0' || (r.at() > end && !defines)))
      return keyword_statement(*keyword, statement.at(begin), r);
    r.go_to(begin);
    definition(r);
  }
  void keyword_statement(const Word& keyword, Place place, Reader& r) {
    switch (keyword.is) {
      case Keyword::parameters:
        return list(r, [&](const std::string& name, double value, Place at) {
          add(name, Role::parameter, at);
          parameters_.emplace_back(name, value);
        });
      case Keyword::constants:
        return list(r, [&](const std::string& name, double value, Place at) {
          add(name, Role::constant, at);
          fixed_.push_back(
              {name,
               {value < 0 ? Node::Is::negative : Node::Is::number, format_shortest(value), {}, at},
               at});
          if (value < 0) fixed_.back().formula.parts = {{Node::Is::number, format_shortest(-value), {}, at}};
        });
      case Keyword::starts:
        return list(r, [&](const std::string& name, double value, Place at) { start(name, value, at); });
      case Keyword::found:
        return list(r, [&](const std::string& name, double value, Place at) {
          add(name, Role::variable, at);
          found_.push_back(name);
          start(name, value, at);
        });
      case Keyword::aux: {
        while (r.next() != '=' && r.next() != '\0') r.go_to(r.at() + 1);
        r.expect("=");
        return unused_.push_back({"", r.formula(), place}), r.end();
      }
      case Keyword::event:
        return event(r, place);
      case Keyword::boundary:
        return boundary(r, place);
      case Keyword::ends:
        is_done_ = true;
        return;
      case Keyword::ignored:
        return;
      case Keyword::files:
        source_.fail(place, other_files);
      case Keyword::refused:
        refuse(place, keyword.missing);
    }
  }
  [[noreturn]] void refuse(Place place, std::string_view missing) const {
    source_.fail(place, none_here(missing));
  }

  /// a=1, b=2 c=3; a name without a value gets 0.
  void list(Reader& r, const auto& each) {
    while (!r.is_done()) {
      const Place at = r.place();
      const std::string name = r.name();
      each(name, r.take("=") ? r.value() : 0, at);
      if (!r.take(",")) r.take(";");
    }
  }

  void add(const std::string& name, Role role, Place at) {
    static const std::set<std::string_view> taken{"t",     "pi",    "if",     "sum",    "asinh",
                                                  "acosh", "atanh", "arcsin", "arccos", "arctan"};
    const bool is_function = std::ranges::find(functions, name, &Function::name) != std::end(functions);
    if (is_function || taken.contains(name))
      source_.fail(at, name + " has a meaning already; take another name");
    if (!names_.roles.emplace(name, role).second) source_.fail(at, name + " is there twice");
    names_.in_order[static_cast<int>(role)].push_back(name);
  }
  void start(const std::string& name, double value, Place at) {
    starts_.insert_or_assign(name, std::pair(value, at));
  }

  void define(Reader& r, const std::string& name, Role role, Place place) {
    r.expect("=");
    add(name, role, place);
    Node formula = r.formula();
    r.end();
    (role == Role::variable ? equations_ : fixed_).push_back({name, std::move(formula), place});
  }

  /// x'=..., dx/dt=..., x(0)=..., f(x,y)=..., q=...
  void definition(Reader& r) {
    const std::size_t begin = r.at();
    const Place place = r.place();
    if (r.take("0")) {
      r.expect("=");
      conditions_.push_back({"", r.formula(), place});
      return r.end();
    }
    if (r.take("d") && begins_name(r.next())) {
      const std::string name = r.name();
      if (r.take("/") && r.take("dt")) return define(r, name, Role::variable, place);
    }
    r.go_to(begin);
    const std::string name = r.name();
    if (r.take("'")) return define(r, name, Role::variable, place);
    if (r.next() == '=') return define(r, name, Role::fixed, place);
    if (!r.take("(")) {
      std::vector<std::string> known;
      for (const Word& word : words)
        if (word.word.size() > 2) known.emplace_back(word.word);
      source_.fail(place, "expected x' = ..., x(0) = ..., f(x) = ..., q = ..., or a statement such as par" +
                              did_you_mean(name, known));
    }
    const std::size_t inside = r.at();
    if (r.take("0") && r.take(")")) {
      r.expect("=");
      const double value = r.value();
      r.end();
      return start(name, value, place);
    }
    r.go_to(inside);
    if (r.take("t") && r.take("+")) source_.fail(place, maps);
    r.go_to(inside);
    OwnFunction f;
    do f.arguments.push_back(r.name());
    while (r.take(","));
    r.expect(")");
    r.expect("=");
    f.body = r.formula();
    r.end();
    if (!names_.functions.emplace(name, std::move(f)).second) source_.fail(place, name + " is there twice");
  }

  /// global 1 {x-1} {x=0;y=y+1}
  void event(Reader& r, Place place) {
    const int sign = r.take("-1") ? -1 : r.take("+1") || r.take("1") ? 1 : 0;
    if (sign == 0) r.fail("expected 1 or -1, where the formula rises or falls through zero");
    const bool braces = r.take("{");
    Event one{r.formula(), sign > 0 ? Direction::rising : Direction::falling, {}, place};
    if (braces) r.expect("}");
    r.expect("{");
    while (!r.take("}")) {
      const Place at = r.place();
      const std::string name = r.name();
      r.expect("=");
      one.then.push_back({name, r.formula(), at});
      if (!r.take(";")) r.take(",");
    }
    r.end();
    events_.push_back(std::move(one));
  }
  EventText written(const Event& one, Writer& writer) const {
    EventText text{{writer.written(one.when).text, one.place, true}, one.direction};
    std::map<std::string, Quoted> then;
    for (const Defined& part : one.then) {
      const Piece after = writer.written(part.formula);
      if (part.name == "arret") {
        text.ends = true;
        continue;
      }
      if (part.name == "out_put") continue;
      const auto role = names_.roles.find(part.name);
      if (role == names_.roles.end() || role->second != Role::variable)
        source_.fail(part.place, "an event changes variables here, and " + part.name + " is none");
      then.insert_or_assign(part.name, Quoted{after.text, part.place, true});
      writer.set(part.name, after);
    }
    writer.reset();
    for (const auto& [name, formula] : then) text.then.push_back({{name, formula.place, true}, formula});
    return text;
  }

  /// x-x' asks for a period of the same motion; ignored, as in xppaut when it integrates.
  void boundary(Reader& r, Place place) {
    const std::size_t begin = r.at();
    if (begins_name(r.next())) {
      const std::string name = r.name();
      if (r.take("-") && begins_name(r.next()) && r.name() == name && r.take("'") && r.is_done()) return;
    }
    r.go_to(begin);
    refuse(place, "boundary values");
  }

  void options(Reader& r) {
    const std::string& text = r.text();
    while (!r.is_done()) {
      const std::size_t begin = r.at(), sign = text.find('=', begin);
      if (sign == text.npos) r.fail("expected an option, such as total=40");
      std::string name = text.substr(begin, sign - begin);
      while (name.ends_with(' ')) name.pop_back();
      r.go_to(sign + 1);
      if (r.next() == '\0') r.fail("expected a value");
      const std::size_t value = r.at();
      if (name == "total" || name == "dt" || name == "t0" || name == "nout" || name == "njmp") {
        option(r, name);
      } else if ((name == "meth" || name == "method") && text.compare(value, 4, "disc") == 0) {
        r.fail(maps);
      }
      r.go_to(std::min(text.find_first_of(", ", value), text.size()));
      r.take(",");
    }
  }
  void option(Reader& r, const std::string& name) {
    const std::size_t at = r.at();
    const double x = r.value();
    if (name == "t0") {
      begins_ = x;
      return;
    }
    if (!(x > 0 && x <= 1e9)) r.fail(at, name + " is positive, and at most 1e9");
    if (name == "total") total_ = x;
    if (name == "dt") step_ = x;
    if (name == "nout" || name == "njmp") rows_ = x;
  }

  /// Adds the fixed quantities and constants that the model uses.
  void add_used(const ModelText& model, const std::map<std::string, Quoted>& fixed) {
    std::set<std::string> used;
    std::vector<const Quoted*> left;
    for (const Quoted& one : model.equations) left.push_back(&one);
    for (const Quoted& one : model.conditions) left.push_back(&one);
    for (const EventText& event : model.events) {
      left.push_back(&event.when);
      for (const auto& [name, formula] : event.then) left.push_back(&formula);
    }
    while (!left.empty()) {
      const std::string& text = left.back()->text;
      left.pop_back();
      for (std::size_t at = 0; at < text.size(); ++at) {
        std::size_t end = at;
        while (end < text.size() && in_name(text[end])) ++end;
        if (end == at) continue;
        const auto found = fixed.find(text.substr(at, end - at));
        if (found != fixed.end() && used.insert(found->first).second) left.push_back(&found->second);
        at = end;
      }
    }
    for (const Defined& one : fixed_)
      if (used.contains(one.name)) file_.given.push_back({{one.name, one.place, true}, fixed.at(one.name)});
  }

  /// Adds the file's parameters, and one for each variable's start.
  void add_parameters(ModelText& model) {
    const double none = std::numeric_limits<double>::infinity();
    const auto parameter = [&](const std::string& name, const std::string& says, double value) {
      file_.parameters.push_back({name, "", says, value, -none, none});
    };
    for (const auto& [name, value] : parameters_) parameter(name, name, value);
    std::vector<std::string> moved, all;
    for (const std::string& name : names_.all(Role::variable)) {
      std::string letter = name + "_0";
      while (names_.roles.contains(letter)) letter += '_';
      const auto start = starts_.find(name);
      const double value = start == starts_.end() ? 0 : start->second.first;
      const bool is_found = std::ranges::find(found_, name) != found_.end();
      parameter(letter, is_found ? "near which " + name + " is at the start" : name + " at the start", value);
      model.start.push_back({{name, model.name.place, true}, {letter, model.name.place, true}});
      if (value != 0 && !is_found) moved.push_back(letter);
    }
    for (const auto& [name, start] : starts_)
      if (const auto role = names_.roles.find(name);
          role == names_.roles.end() || role->second != Role::variable)
        source_.fail(start.second, "no variable " + name + did_you_mean(name, names_.all(Role::variable)) +
                                       "; a start is of one");
    // Starts that are not zero vary from start to start; without any, parameters that are not zero.
    for (const auto& [name, value] : parameters_) {
      if (value == 0) continue;
      all.push_back(name);
      if (file_.sweep.empty()) file_.sweep = name;
    }
    file_.vary = moved.empty() ? all : moved;
    if (file_.sweep.empty() && !moved.empty()) file_.sweep = moved.front();
  }

  const Source& source_;
  File& file_;
  Names names_;
  std::vector<std::pair<std::string, double>> parameters_;
  std::map<std::string, std::pair<double, Place>> starts_;
  std::vector<Defined> equations_, conditions_, fixed_, unused_;
  std::vector<std::string> found_;  ///< unknowns that conditions determine
  std::vector<Event> events_;
  double total_ = 20, step_ = 0.05, rows_ = 1, begins_ = 0;
  std::size_t statements_ = 0;
  bool is_done_ = false;
};

/// The first comment with text, otherwise the file's name.
std::string title_of(const std::string& name, const std::string& text) {
  const std::size_t slash = name.rfind('/');
  const std::string stem = slash == name.npos ? name : name.substr(slash + 1);
  for (std::size_t begin = 0; begin < text.size() && text[begin] == '#';) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string title;
    for (const char c : text.substr(begin, end - begin))
      if (c >= ' ' && c < 127 && (c != '#' || !title.empty()) && (c != ' ' || !title.empty())) title += c;
    while (title.ends_with(' ')) title.pop_back();
    if (title.size() > 3) return title.substr(0, 80);
    begin = end + 1;
  }
  return stem;
}

}  // namespace

bool is_ode_file(const std::string& name) { return name.ends_with(".ode"); }

std::unique_ptr<File> read_ode(const std::string& name, const std::string& text) {
  if (text.size() > most_of_a_file) throw BadInput(name + ": a problem's file has at most a megabyte");
  auto file = std::make_unique<File>();
  file->source = {name, text};
  file->title = title_of(name, text);
  file->is_plain = true;
  Making making(file->source, *file);
  making.read(statements_of(text));
  making.make();
  return file;
}

}  // namespace oddity::problem
