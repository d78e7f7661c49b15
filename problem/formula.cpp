#include "problem/formula.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "formula/differentiate.hpp"
#include "formula/evaluate.hpp"
#include "formula/parse.hpp"
#include "formula/tokens.hpp"
#include "problem/quaternion.hpp"
#include "reference/quantity_text.hpp"
#include "reference/similar.hpp"

namespace oddity::problem {

namespace {

constexpr std::array<std::string_view, 22> functions{
    "sin",  "cos",   "tan",   "asin",  "acos", "atan", "arcsin", "arccos", "arctan", "sinh",  "cosh",
    "tanh", "asinh", "acosh", "atanh", "exp",  "log",  "ln",     "sqrt",   "dot",    "cross", "pi"};
constexpr std::array<std::string_view, 10> calls{"if",    "abs",    "max",      "min",       "sign",
                                                 "atan2", "turned", "composed", "conjugate", "transposed"};
constexpr std::array<std::string_view, 4> of_one{"abs", "sign", "conjugate", "transposed"};

bool among(std::string_view word, const auto& all) { return std::ranges::find(all, word) != all.end(); }
using formula::is_digit;
bool begins_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool in_name(char c) { return begins_name(c) || is_digit(c); }

std::size_t end_of_name(std::string_view text, std::size_t at) {
  while (at < text.size() && in_name(text[at])) ++at;
  while (at < text.size() && text[at] == '\'') ++at;
  return at;
}

std::size_t end_of_numeral(std::string_view text, std::size_t at) {
  const auto digits = [&] {
    while (at < text.size() && is_digit(text[at])) ++at;
  };
  digits();
  if (at + 1 < text.size() && text[at] == '.' && is_digit(text[at + 1])) ++at, digits();
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t power = at + 1;
    if (power < text.size() && (text[power] == '-' || text[power] == '+')) ++power;
    if (power < text.size() && is_digit(text[power])) at = power, digits();
  }
  return at;
}

/// End of the unit that begins behind a numeral, blanks aside; `numeral` without a unit.
std::size_t end_of_unit(std::string_view text, std::size_t numeral) {
  std::size_t at = numeral, longest = numeral;
  const auto blanks = [&] {
    while (at < text.size() && text[at] == ' ') ++at;
  };
  blanks();
  const std::size_t begin = at;
  if (text.substr(at).starts_with("1/") && at > numeral) at += 2;
  while (at < text.size()) {
    const std::size_t name = at;
    while (at < text.size() && (begins_name(text[at]) || text[at] == '%' || (text[at] & 0x80))) ++at;
    if (at == name || (at < text.size() && (is_digit(text[at]) || text[at] == '\''))) break;
    if (at < text.size() && text[at] == '^') {
      std::size_t power = at + 1;
      if (power < text.size() && text[power] == '-') ++power;
      const std::size_t first = power;
      while (power < text.size() && is_digit(text[power])) ++power;
      if (power > first) at = power;
    }
    if (unit_of(text.substr(begin, at - begin))) longest = at;
    blanks();
    if (at < text.size() && text[at] == '/') ++at, blanks();
  }
  return longest;
}

/// Whether the numeral is an exponent.
bool is_exponent(std::string_view text, std::size_t at) {
  const auto before = [&] {
    while (at > 0 && text[at - 1] == ' ') --at;
    return at > 0 ? text[at - 1] : ' ';
  };
  if (before() == '-') --at;
  return before() == '^';
}

/// Names by number, of a length that no formula has: the parser finds letters' positions by them.
std::string code_of(std::size_t number, std::size_t length) {
  constexpr std::string_view first = "abcdfghijklmnopqrstuvwxyzABCDFGHIJKLMNOPQRSTUVWXYZ",
                             second = "0123456789_";
  std::string code(1, first[number % first.size()]);
  number /= first.size();
  if (length > 1) {
    code += second[number % second.size()];
    number /= second.size();
  }
  while (code.size() < length) {
    code += static_cast<char>('0' + number % 10);
    number /= 10;
  }
  return number == 0 ? code : "";
}

/// "m g" for mg, if these are letters.
std::string as_product(std::string_view name, const std::vector<std::string>& letters) {
  for (const std::string& letter : letters) {
    if (name == letter) return letter;
    if (!name.starts_with(letter)) continue;
    const std::string rest = as_product(name.substr(letter.size()), letters);
    if (!rest.empty()) return letter + " " + rest;
  }
  return "";
}

/// A formula's text with a code for each letter.
class Reader {
 public:
  Reader(const Source& source, const Quoted& text, const Letters& known)
      : source_(source), quoted_(text), text_(text.text), known_(known) {}

  formula::Tree tree(std::vector<Letter>& letters) {
    letters_ = &letters;
    if (text_.size() > 20'000) fail(0, "a formula has at most 20,000 characters");
    if (text_.find('\\') != text_.npos) return from_tex();
    coded_ = text_;
    for (std::size_t at = 0; at < text_.size();) at = next(at);
    try {
      return formula::parse_plain(coded_, names_);
    } catch (const formula::Unreadable& error) {
      fail(error.place(), error.reason());
    }
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    source_.fail(quoted_.at(at), reason);
  }

  std::size_t next(std::size_t at) {
    const char c = text_[at];
    if (begins_name(c)) return name(at);
    if (is_digit(c) || (c == '.' && at + 1 < text_.size() && is_digit(text_[at + 1]))) return numeral(at);
    if (c == '|') fail(at, "write abs(x)");
    if (c & 0x80) fail(at, "letters are written out: theta");
    return at + 1;
  }

  std::size_t numeral(std::size_t at) {
    const std::size_t end = end_of_numeral(text_, at), unit = end_of_unit(text_, end);
    if (unit == end || is_exponent(text_, at)) return end;
    std::string symbol(text_.substr(end, unit - end));
    symbol.erase(0, symbol.find_first_not_of(' '));
    Letter letter{Letter::Is::quantity};
    try {
      letter.value = formula::detail::of_digits<long double>(std::string(text_.substr(at, end - at))) *
                     unit_of(symbol)->size;
    } catch (const formula::NoValue& error) {
      fail(at, error.what());
    }
    letter.measure = *measure_of(symbol);
    const std::string first = symbol.substr(0, symbol.find_first_of(" /^"));
    if (among(first, all_names()))
      letter.function = std::string(text_.substr(at, end - at)) + " " + first + " has the unit " + first +
                        ", as a unit follows a numeral: write " + std::string(text_.substr(at, end - at)) +
                        "*" + first + " for the letter";
    put(std::move(letter), at, unit);
    return unit;
  }

  std::vector<std::string> all_names() const {
    std::vector<std::string> all{known_.unknowns};
    all.insert(all.end(), known_.parameters.begin(), known_.parameters.end());
    all.insert(all.end(), known_.given.begin(), known_.given.end());
    all.emplace_back("t");
    return all;
  }

  std::size_t name(std::size_t at) {
    const std::size_t end = end_of_name(text_, at);
    const std::string_view whole = text_.substr(at, end - at), base = whole.substr(0, whole.find('\''));
    Letter letter;
    letter.order = whole.size() - base.size();
    const auto find = [&](const std::vector<std::string>& all, Letter::Is is, std::string_view called) {
      const auto found = std::ranges::find(all, called);
      if (found == all.end()) return false;
      letter.is = is;
      letter.index = static_cast<std::size_t>(found - all.begin());
      return true;
    };
    bool is_known = find(known_.unknowns, Letter::Is::unknown, base) ||
                    find(known_.given, Letter::Is::given, base) ||
                    find(known_.parameters, Letter::Is::parameter, base);
    if (!is_known && among(whole, functions)) return end;
    if (!is_known && (among(whole, calls) || table(whole))) return call(at, end);
    if (!is_known && base != "t") {
      const auto [stem, component] = component_in(base);
      letter.component = component;
      is_known = component > 0 && find(known_.given, Letter::Is::given, stem);
      if (!is_known) unknown(at, base);
    }
    if (letter.order > 0 && (letter.is == Letter::Is::parameter || letter.is == Letter::Is::time))
      fail(at, std::string(base) + " is no unknown, and has no rate");
    if (letter.order > 4) fail(at, "at most four primes");
    put(std::move(letter), at, end);
    return end;
  }

  /// "r" and 2 for r_2; 0 if this is no name of a component.
  static std::pair<std::string_view, std::size_t> component_in(std::string_view name) {
    const std::size_t bar = name.rfind('_');
    const std::string_view digits = bar == name.npos ? "" : name.substr(bar + 1);
    if (digits.empty() || digits.size() > 2 || !std::ranges::all_of(digits, is_digit)) return {name, 0};
    std::size_t component = 0;
    for (const char c : digits) component = 10 * component + static_cast<std::size_t>(c - '0');
    return {name.substr(0, bar), component};
  }

  [[noreturn]] void unknown(std::size_t at, std::string_view name) const {
    const auto all = all_names();
    const std::string product = name.size() > 1 && name.size() < 12 ? as_product(name, all) : "";
    if (!product.empty()) fail(at, "no letter " + std::string(name) + "; did you mean " + product + "?");
    std::vector<std::string> words(all);
    words.insert(words.end(), functions.begin(), functions.end());
    words.insert(words.end(), calls.begin(), calls.end());
    for (const auto& one : known_.tables) words.push_back(one->name);
    std::string listed;
    for (const std::string& one : all) listed += (listed.empty() ? "" : ", ") + one;
    const std::string near = did_you_mean(name, words);
    fail(at, "no letter " + std::string(name) + (near.empty() ? "; the letters are " + listed : near));
  }

  std::shared_ptr<const Table> table(std::string_view name) const {
    const auto found = std::ranges::find(known_.tables, name, [](const auto& one) { return one->name; });
    return found == known_.tables.end() ? nullptr : *found;
  }

  /// if(x < y, a, b); abs(x); a table's name.
  std::size_t call(std::size_t at, std::size_t open) {
    const std::string name(text_.substr(at, open - at));
    while (open < text_.size() && text_[open] == ' ') ++open;
    if (open == text_.size() || text_[open] != '(') fail(open, "expected ( behind " + name);
    std::vector<std::size_t> bounds{open};
    std::size_t end = open + 1;
    for (int depth = 1; depth > 0; ++end) {
      if (end == text_.size()) fail(open, "this parenthesis is not closed");
      const char c = text_[end];
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if ((depth == 1 && c == ',') || depth == 0) bounds.push_back(end);
    }
    const std::size_t wanted = name == "if" ? 3 : among(name, of_one) || table(name) ? 1 : 2;
    if (bounds.size() != wanted + 1)
      fail(at, name + " takes " + std::to_string(wanted) + (name == "if" ? ": if(x < y, a, b)" : ""));
    const Deeper deeper;
    if (deeper.calls > 30) fail(at, "at most 30 calls, one within another");
    Letter letter{Letter::Is::call};
    letter.function = name;
    letter.table = table(name);
    for (std::size_t k = 0; k < wanted; ++k)
      if (name == "if" && k == 0)
        condition(letter, bounds[0] + 1, bounds[1]);
      else
        letter.arguments.push_back(part(bounds[k] + 1, bounds[k + 1]));
    put(std::move(letter), at, end);
    return end;
  }
  Formula part(std::size_t begin, std::size_t end) const {
    return {source_, {std::string(text_.substr(begin, end - begin)), quoted_.at(begin)}, known_};
  }
  /// Two formulas; the condition is that the first is the greater.
  void condition(Letter& letter, std::size_t begin, std::size_t end) const {
    std::size_t sign = begin;
    for (int depth = 0; sign < end && (depth > 0 || (text_[sign] != '<' && text_[sign] != '>')); ++sign)
      depth += text_[sign] == '(' ? 1 : text_[sign] == ')' ? -1 : 0;
    if (sign >= end) fail(begin, "expected a condition such as x < y");
    const std::size_t behind = sign + (sign + 1 < end && text_[sign + 1] == '=' ? 2 : 1);
    Formula left = part(begin, sign), right = part(behind, end);
    if (text_[sign] == '<') std::swap(left, right);
    letter.arguments.push_back(std::move(left));
    letter.arguments.push_back(std::move(right));
  }

  void put(Letter letter, std::size_t begin, std::size_t end) {
    letter.span = {begin, end};
    const std::string own = text_of(begin, end);
    std::size_t& used = used_[end - begin];
    std::string code = code_of(used, end - begin);
    if (!code.empty()) {
      ++used;
      names_.push_back(code);
      originals_.push_back(own);
      letters_->push_back(std::move(letter));
    } else {  // All codes of this length are used: one that means the same.
      const auto same = std::ranges::find(originals_, own);
      if (same == originals_.end()) fail(begin, "a formula of too many letters");
      code = names_[static_cast<std::size_t>(same - originals_.begin())];
    }
    coded_.replace(begin, end - begin, code);
  }
  std::string text_of(std::size_t begin, std::size_t end) const {
    return std::string(text_.substr(begin, end - begin));
  }

  /// TeX's letters have no places.
  formula::Tree from_tex() {
    const auto add = [&](const std::string& name, Letter letter) {
      names_.push_back(formula::tex_name(name));
      letters_->push_back(std::move(letter));
    };
    for (std::size_t i = 0; i < known_.parameters.size(); ++i)
      add(known_.parameters[i], {Letter::Is::parameter, i});
    for (std::size_t order = 0; order < 3; ++order) {
      for (std::size_t i = 0; i < known_.unknowns.size(); ++i)
        add(known_.unknowns[i] + std::string(order, '\''), {Letter::Is::unknown, i, order});
      for (std::size_t i = 0; i < known_.given.size(); ++i)
        add(known_.given[i] + std::string(order, '\''), {Letter::Is::given, i, order});
    }
    if (!among("t", known_.parameters)) add("t", {Letter::Is::time});
    try {
      formula::Tree tree = formula::parse_tex(text_, names_);
      std::vector<bool> is_there(letters_->size(), false);
      see_letters(tree, is_there);
      for (std::size_t i = 0; i < is_there.size(); ++i)
        if (!is_there[i]) (*letters_)[i] = {Letter::Is::quantity};
      return tree;
    } catch (const formula::Unreadable& error) {
      fail(error.place(), error.reason());
    }
  }
  static void see_letters(const formula::Tree& x, std::vector<bool>& is_there) {
    if (x.kind() == formula::Kind::letter)
      for (const auto& entry : x->entries) is_there[static_cast<std::size_t>(entry.rates[0])] = true;
    for (const formula::Tree& child : x->children) see_letters(child, is_there);
  }

  /// Counts nested calls, each with its own reader.
  struct Deeper {
    static inline thread_local int calls = 0;
    Deeper() { ++calls; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    ~Deeper() { --calls; }
  };

  const Source& source_;
  const Quoted& quoted_;
  std::string_view text_;
  const Letters& known_;
  std::string coded_;
  formula::Names names_;
  std::vector<std::string> originals_;
  std::vector<Letter>* letters_ = nullptr;
  std::map<std::size_t, std::size_t> used_;  ///< number of codes used, by length
};

Measure choose_by(const Measure&, const Measure& yes, const Measure& no) { return yes + no; }

Measure looked_up(const Table& table, const Measure& x) {
  if (!fit(x, table.x))
    throw Mismatch(table.name + " is a table of " + name_of(table.x) + ", and this is " + name_of(x), x.span);
  return table.y;
}
Expression looked_up(const Table& table, const Expression& x) { return value_at(table, x); }

// Calls of shapes, in which all numbers are one.
double choose_by(double, double yes, double) { return yes; }
double looked_up(const Table&, double x) { return x; }

/// A call with numbers.
template <class T>
T called_with(const Letter& letter, const std::vector<T>& x) {
  using std::atan2;
  const std::string& function = letter.function;
  if (letter.table) return looked_up(*letter.table, x[0]);
  if (function == "abs") return choose_by(x[0], x[0], -x[0]);
  if (function == "max") return choose_by(x[0] - x[1], x[0], x[1]);
  if (function == "min") return choose_by(x[1] - x[0], x[0], x[1]);
  if (function == "sign") return choose_by(x[0], T(1), choose_by(-x[0], T(-1), T(0)));
  return atan2(x[0], x[1]);
}

/// The line, and a caret below the column.
std::string shown(const std::string& text, Place place) {
  std::size_t begin = 0;
  for (std::size_t line = 1; line < place.line && begin < text.size(); ++line) {
    const std::size_t end = text.find('\n', begin);
    begin = end == text.npos ? text.size() : end + 1;
  }
  std::string line = text.substr(begin, text.find('\n', begin) - begin);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  constexpr std::size_t before = 60, after = 40;
  const std::size_t column = std::min(place.column > 0 ? place.column - 1 : 0, line.size());
  const std::size_t from = column > before ? column - before : 0;
  return "\n  " + line.substr(from, before + after) + "\n  " + std::string(column - from, ' ') + "^";
}

}  // namespace

std::vector<std::string> names_with_meaning() {
  std::vector<std::string> names{"t"};
  names.insert(names.end(), functions.begin(), functions.end());
  names.insert(names.end(), calls.begin(), calls.end());
  return names;
}

WrongFile::WrongFile(const std::string& file, const std::string& text, Place place, const std::string& reason)
    : BadInput(file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + reason +
               shown(text, place)),
      place_(place),
      reason_(reason) {}

Formula::Formula(const Source& source, Quoted text, const Letters& known)
    : source_(&source), text_(std::move(text)) {
  tree_.push_back(Reader(source, text_, known).tree(letters_));
}

void Formula::fail(const Span& span, const std::string& reason) const {
  source_->fail(
      text_.at(span.is_known() ? span.begin : std::min(text_.text.find_first_not_of(' '), text_.text.size())),
      reason);
}

template <class T>
formula::Matrix<T> Formula::called(const Letter& call, const Of<T>& of) const {
  std::vector<formula::Matrix<T>> all;
  for (const Formula& one : call.arguments) all.push_back(one.evaluated(of));
  const auto number_at = [&](std::size_t i) { return call.arguments[i].number(all[i]); };
  const auto sized = [&](std::size_t i, std::size_t count) -> const formula::Matrix<T>& {
    if (const Size size{count, 1}; extent(all[i]) != size)
      call.arguments[i].fail(
          {}, call.function + " takes " + name_of(size) + " here, and this is " + name_of(all[i]));
    return all[i];
  };
  if (call.function == "turned") return turned(sized(0, 4), sized(1, 3));
  if (call.function == "composed") return composed(sized(0, 4), sized(1, 4));
  if (call.function == "conjugate") return conjugate(sized(0, 4));
  if (call.function == "transposed") {
    if (all[0].is_number()) call.arguments[0].fail({}, "a number is not transposed");
    return transposed(all[0]);
  }
  using std::sqrt;
  if (call.function == "abs" && !all[0].is_number()) {
    if (all[0].columns > 1)
      call.arguments[0].fail({}, "abs takes a number or a vector, and this is " + name_of(all[0]));
    return {{sqrt(dot_of(all[0], all[0]))}};
  }
  if (call.function == "if") {
    if (call.arguments[2].is_zero()) all[2] = scaled(all[3], T(0));
    if (call.arguments[3].is_zero()) all[3] = scaled(all[2], T(0));
    if (extent(all[2]) != extent(all[3]))
      call.arguments[3].fail({}, "this is " + name_of(all[3]) + ", and otherwise " + name_of(all[2]));
    const T condition = number_at(0) - number_at(1);
    for (std::size_t i = 0; i < all[2].entries.size(); ++i)
      all[2].entries[i] = choose_by(condition, all[2].entries[i], all[3].entries[i]);
    return all[2];
  }
  std::vector<T> numbers;
  for (std::size_t i = 0; i < all.size(); ++i) numbers.push_back(number_at(i));
  return {{called_with(call, numbers)}};
}

template <class T>
formula::Matrix<T> Formula::evaluated(const Of<T>& of) const {
  std::vector<formula::Matrix<T>> values;
  for (const Letter& letter : letters_) {
    formula::Matrix<T>& value = values.emplace_back();
    try {
      value = letter.is == Letter::Is::call ? called(letter, of) : of(letter);
    } catch (const Mismatch& error) {
      fail(letter.span, error.what());
    } catch (const formula::NoValue& error) {
      fail(letter.span, error.what());
    }
    if (letter.component > 0) {
      const auto index = index_of_component(letter.component, extent(value));
      if (!index)
        fail(letter.span, name_of(value) + " has no component " + std::to_string(letter.component) +
                              (value.columns > 1 ? ": 12 is that of row 1 and column 2" : ""));
      value = {{value.entries[*index]}};
    }
    if constexpr (std::same_as<T, Measure>)
      for (T& one : value.entries) one.span = letter.span;
  }
  const auto shapes = [&] {
    std::vector<Shape> all;
    for (const auto& one : values) all.push_back({std::vector(one.entries.size(), 1.0), one.columns});
    return all;
  };
  try {
    formula::Matrix<T> all = formula::evaluate<T>(tree_[0], values);
    if constexpr (!std::same_as<T, Expression>)  // measures and shapes are taken of every formula
      if (const auto found = uneven(tree_[0], shapes())) fail(*found);
    if (component_ && !all.is_number()) all = {{all.entries.at(*component_)}};
    return all;
  } catch (const formula::NoValue& error) {
    fail(misfit(tree_[0], shapes(), error.what()));
  } catch (const Mismatch& error) {
    fail(error.span, error.what() + meant());
  }
}

void Formula::fail(const Misfit& found) const {
  Span span;
  for (const std::size_t i : found.letters) span = span | letters_[i].span;
  fail(span, found.says);
}

template formula::Matrix<Expression> Formula::evaluated(const Of<Expression>&) const;
template formula::Matrix<Measure> Formula::evaluated(const Of<Measure>&) const;
template Shape Formula::evaluated(const Of<double>&) const;

Expression Formula::value(const std::function<Expression(const Letter&)>& of) const {
  return number(values([&](const Letter& letter) { return formula::Matrix<Expression>{{of(letter)}}; }));
}
Measure Formula::measure(const std::function<Measure(const Letter&)>& of) const {
  return number(measures([&](const Letter& letter) { return formula::Matrix<Measure>{{of(letter)}}; }));
}

Formula Formula::component(std::size_t i) const {
  Formula one = *this;
  one.component_ = i;
  return one;
}
bool Formula::is_zero() const { return is_number(tree_[0], "0"); }

formula::Tree Formula::tree(const std::function<std::string(const Letter&)>& name,
                            const std::function<std::string(const std::string& unit)>& unit_name) const {
  using formula::Kind, formula::made, formula::Tree;
  return formula::substitute(tree_[0], [&](const Tree& x) -> std::optional<Tree> {
    if (x->entries.empty() || !x->slots.empty()) return std::nullopt;
    const Letter& letter = letters_[static_cast<std::size_t>(x->entries[0].rates[0])];
    if (letter.is == Letter::Is::call) {
      std::vector<Tree> arguments;
      for (const Formula& one : letter.arguments) arguments.push_back(one.tree(name, unit_name));
      if (letter.function == "abs") return made(Kind::bars, arguments);
      if (letter.function == "max") return made(Kind::largest, arguments);
      if (letter.function == "min") return made(Kind::smallest, arguments);
      fail(letter.span, letter.function + " has no place in a claim: state each case as a separate claim");
    }
    if (letter.is != Letter::Is::quantity) return made(Kind::letter, {}, name(letter));
    const std::string quantity = text_.text.substr(letter.span.begin, letter.span.end - letter.span.begin);
    const std::size_t digits = end_of_numeral(quantity, 0);
    std::string unit = quantity.substr(digits);
    unit.erase(0, unit.find_first_not_of(' '));
    return formula::product(
        {formula::number(quantity.substr(0, digits)), made(Kind::letter, {}, unit_name(unit))}, "**");
  });
}

std::string Formula::meant() const {
  std::string all;
  for (const Letter& letter : letters_)
    if (letter.is == Letter::Is::quantity && !letter.function.empty()) all += "; " + letter.function;
  return all;
}

bool Formula::any(const std::function<bool(const Letter&)>& is) const {
  return std::ranges::any_of(letters_, [&](const Letter& letter) {
    return is(letter) ||
           std::ranges::any_of(letter.arguments, [&](const Formula& one) { return one.any(is); });
  });
}

Equation equation(const Source& source, const Quoted& text, const Letters& known) {
  const auto next = [&](std::size_t at) {
    at = text.text.find('=', at);
    while (at != std::string::npos && at > 0 && (text.text[at - 1] == '<' || text.text[at - 1] == '>'))
      at = text.text.find('=', at + 1);
    return at;
  };
  const std::size_t sign = next(0);
  if (sign == std::string::npos) source.fail(text.place, "expected an equation, with =");
  if (next(sign + 1) != std::string::npos) source.fail(text.at(next(sign + 1)), "an equation has two sides");
  return {Formula(source, {text.text.substr(0, sign), text.place}, known),
          Formula(source, {text.text.substr(sign + 1), text.at(sign + 1)}, known)};
}

}  // namespace oddity::problem
