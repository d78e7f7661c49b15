#include "chapters/typeset.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "reference/text.hpp"

namespace oddity {

namespace {

/// The formula is none that is known here.
struct Unread {};

// ---- tokens: a command, a number, or a sign ---------------------------------------------------------------

using Tokens = std::vector<std::string>;

bool among(std::string_view token, std::initializer_list<std::string_view> all) {
  return std::ranges::find(all, token) != all.end();
}
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::size_t length_of_command(std::string_view text) {
  std::size_t n = 1;
  while (n < text.size() && is_letter(text[n])) ++n;
  return std::max<std::size_t>(n, 2);
}

/// What only moves or stretches is left out, but for the space that ends a function's argument.
bool says_nothing(std::string_view token) {
  return among(token, {R"(\left)", R"(\right)", R"(\bigl)", R"(\bigr)", R"(\Bigl)", R"(\Bigr)", R"(\big)",
                       R"(\Big)", R"(\!)", R"(\ )", R"(\;)", R"(\quad)"});
}

/// {x} as x.
void without_single_groups(Tokens& tokens) {
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i)
    if (tokens[i] == "{" && tokens[i + 2] == "}" && tokens[i + 1] != "}") {
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 2);
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// A number is one token only at the top: x_12 is x with the index 1, and 2.
Tokens tokens_of(std::string_view text) {
  Tokens tokens;
  while (!text.empty()) {
    std::size_t n = 1;
    if (text[0] == '\\')
      n = length_of_command(text);
    else if (is_digit(text[0]) &&
             (tokens.empty() || !among(tokens.back(), {"_", "^", R"(\frac)", R"(\sqrt)"})))
      while (n < text.size() &&
             (is_digit(text[n]) || (text[n] == '.' && n + 1 < text.size() && is_digit(text[n + 1]))))
        ++n;
    std::string token(text.substr(0, n));
    text.remove_prefix(n);
    if (token == R"(\tfrac)" || token == R"(\dfrac)") token = R"(\frac)";
    if (token != " " && token != "$" && !says_nothing(token)) tokens.push_back(std::move(token));
  }
  without_single_groups(tokens);
  return tokens;
}

// ---- values -----------------------------------------------------------------------------------------------

double number(const Value& x) {
  if (x.size() != 1) throw Unread();
  return x[0];
}
Value scaled(const Value& x, double factor) {
  Value y = x;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] *= factor;
  return y;
}
bool is_zero(const Value& x) { return x.size() == 1 && x[0] == 0; }
/// A lone 0 is zero of any kind.
Value sum(const Value& a, const Value& b, double sign) {
  if (is_zero(a)) return scaled(b, sign);
  if (is_zero(b)) return a;
  if (a.size() != b.size()) throw Unread();
  Value y = a;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += sign * b[i];
  return y;
}
std::optional<Value> difference(const std::optional<Value>& a, const std::optional<Value>& b) {
  if (!a || !b || (a->size() != b->size() && !is_zero(*a) && !is_zero(*b))) return std::nullopt;
  return sum(*a, *b, -1);
}
Value product(const Value& a, const Value& b) {
  return a.size() == 1 ? scaled(b, a[0]) : scaled(a, number(b));
}
double dot(const Value& a, const Value& b) {
  if (a.size() != b.size()) throw Unread();
  double total = 0;
  for (std::size_t i = 0; i < a.size(); ++i) total += a[i] * b[i];
  return total;
}
Value cross(const Value& a, const Value& b) {
  if (a.size() == 1 && b.size() == 1) return {a[0] * b[0]};
  if (a.size() != 3 || b.size() != 3) throw Unread();
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

using Function = double (*)(double);
struct Named {
  std::string_view name;
  Function function, inverse;
};
constexpr std::array functions{
    Named{R"(\sin)", std::sin, std::asin},    Named{R"(\cos)", std::cos, std::acos},
    Named{R"(\tan)", std::tan, std::atan},    Named{R"(\arcsin)", std::asin, std::sin},
    Named{R"(\arccos)", std::acos, std::cos}, Named{R"(\arctan)", std::atan, std::tan},
    Named{R"(\sinh)", std::sinh, std::asinh}, Named{R"(\cosh)", std::cosh, std::acosh},
    Named{R"(\exp)", std::exp, std::log},     Named{R"(\ln)", std::log, std::exp}};

// ---- the grammar ------------------------------------------------------------------------------------------

class Reader {
 public:
  Reader(Tokens tokens, const TypesetLetters& letters) : tokens_(std::move(tokens)) {
    for (const auto& [written, value] : letters) letters_.emplace_back(tokens_of(written), value);
    std::ranges::stable_sort(letters_, std::ranges::greater(), [](const auto& l) { return l.first.size(); });
  }

  Value all() {
    Value x = sum_of_terms();
    if (at_ < tokens_.size()) throw Unread();
    return x;
  }

 private:
  const std::string& next(std::size_t ahead = 0) const {
    static const std::string end;
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : end;
  }
  bool take(std::string_view token) {
    if (next() != token) return false;
    ++at_;
    return true;
  }
  void expect(std::string_view token) {
    if (!take(token)) throw Unread();
  }

  Value sum_of_terms() {
    while (take(R"(\,)")) continue;
    const bool negative = take("-");
    if (!negative) take("+");
    Value total = dot_products();
    if (negative) total = scaled(total, -1);
    while (true) {
      if (take("+"))
        total = sum(total, dot_products(), 1);
      else if (take("-"))
        total = sum(total, dot_products(), -1);
      else
        return total;
    }
  }

  /// u . v x w is that of u and v x w.
  Value dot_products() {
    Value x = cross_products();
    while (take(R"(\cdot)")) {
      const Value y = cross_products();
      x = x.size() == 1 || y.size() == 1 ? product(x, y) : Value(dot(x, y));
    }
    return x;
  }
  Value cross_products() {
    Value x = factors();
    while (take(R"(\times)")) x = cross(x, factors());
    return x;
  }
  Value factors() {
    Value x = power();
    while (true) {
      if (take(R"(\,)")) continue;
      if (take("/"))
        x = scaled(x, 1 / number(power()));
      else if (begins_factor())
        x = product(x, power());
      else
        return x;
    }
  }

  bool begins_factor() const {
    const std::string& token = next();
    return !token.empty() &&
           !among(token, {"+", "-", ")", "]", "}", ",", "/", "=", R"(\cdot)", R"(\times)", R"(\,)"}) &&
           (token != "|" || !inside_bars_);
  }

  Value power() {
    if (const Named* f = function()) return of_function(*f);
    const bool is_e = next() == "e" && next(1) == "^" && !letter_here();
    if (is_e) {
      at_ += 2;
      return {std::exp(number(argument()))};
    }
    Value x = base();
    while (take("^")) x = {std::pow(number(x), number(argument()))};
    return x;
  }

  const Named* function() const {
    const auto found = std::ranges::find(functions, next(), &Named::name);
    return found == functions.end() ? nullptr : &*found;
  }
  /// \sin^2 x is (\sin x)^2, and \sin^{-1} x the inverse function's.
  Value of_function(const Named& f) {
    ++at_;
    const double exponent = take("^") ? number(argument()) : 1;
    const double x = number(next() == "(" || next() == "{" ? base() : argument_of_function());
    return {exponent == -1 ? f.inverse(x) : std::pow(f.function(x), exponent)};
  }
  /// \sin\omega t, and up to where something else begins.
  Value argument_of_function() {
    Value x = power();
    while (begins_factor() && !function() && next() != "(" && next() != R"(\dot)" && next() != R"(\ddot)" &&
           next() != R"(\mathbf)")
      x = product(x, power());
    return x;
  }

  /// What stands behind \frac, \sqrt and ^: a group, or one token.
  Value argument() {
    if (next() == "{") return base();
    if (!next().empty() && is_digit(next()[0])) return {static_cast<double>(first_digit())};
    return base();
  }
  int first_digit() {
    std::string& token = tokens_[at_];
    const int digit = token[0] - '0';
    if (token.size() > 1)
      token.erase(0, 1);
    else
      ++at_;
    return digit;
  }

  Value base() {
    if (take(R"(\frac)")) {
      const Value above = argument();
      return scaled(above, 1 / number(argument()));
    }
    if (take(R"(\sqrt)")) return {std::sqrt(number(argument()))};
    if (take("{")) return closed_by("}");
    if (take("(")) return closed_by(")");
    if (take("[")) return closed_by("]");
    if (take("|")) return {between_bars()};
    if (const auto* letter = letter_here()) {
      at_ += letter->first.size();
      return letter->second;
    }
    if (take(R"(\pi)")) return {std::numbers::pi};
    return {numeral()};
  }
  double numeral() {
    const std::string& token = next();
    double x = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), x);
    if (token.empty() || error != std::errc{} || end != token.data() + token.size()) throw Unread();
    ++at_;
    return x;
  }
  double between_bars() {
    const bool outside = std::exchange(inside_bars_, true);
    const Value x = sum_of_terms();
    inside_bars_ = outside;
    expect("|");
    return std::sqrt(dot(x, x));
  }
  /// A sum, or several with commas between them: a tuple.
  Value closed_by(std::string_view end) {
    const bool outside = std::exchange(inside_bars_, false);
    const Value first = sum_of_terms();
    std::vector<double> all(first.begin(), first.end());
    if (next() == ",") number(first);
    while (take(",")) all.push_back(number(sum_of_terms()));
    inside_bars_ = outside;
    expect(end);
    return all;
  }

  /// The longest that fits and is not part of a longer one: R is not the beginning of R_1.
  const std::pair<Tokens, Value>* letter_here() const {
    for (const auto& letter : letters_) {
      const std::size_t n = letter.first.size();
      if (at_ + n > tokens_.size()) continue;
      if (!std::equal(letter.first.begin(), letter.first.end(),
                      tokens_.begin() + static_cast<std::ptrdiff_t>(at_)))
        continue;
      if (!among(next(n), {"_", "'"})) return &letter;
    }
    return nullptr;
  }

  Tokens tokens_;
  std::vector<std::pair<Tokens, Value>> letters_;
  std::size_t at_ = 0;
  bool inside_bars_ = false;
};

std::string written(const Value& x) {
  std::string all;
  for (const double component : x) all += (all.empty() ? "" : ", ") + format_shortest(component);
  return "(" + all + ")";
}

}  // namespace

std::string told(const TypesetLetters& letters, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < std::min(count, letters.size()); ++i) {
    const auto& [letter, value] = letters[i];
    all += (all.empty() ? "$" : ", $") + letter +
           "$ = " + (value.size() == 1 ? format_shortest(value[0]) : written(value));
  }
  return all;
}

std::optional<Value> typeset_value(std::string_view formula, const TypesetLetters& letters) {
  try {
    return Reader(tokens_of(formula), letters).all();
  } catch (const Unread&) {
    return std::nullopt;
  }
}

bool is_formula(std::string_view text) {
  return text.size() > 2 && text.front() == '$' && text.find('$', 1) == text.size() - 1;
}

namespace {

/// What a formula or an equation may stand for: itself, each side, and what two sides differ by.
std::vector<std::optional<Value>> meanings(std::string_view formula, const TypesetLetters& letters) {
  std::vector<std::optional<Value>> all;
  for (std::size_t begin = 0; begin <= formula.size();) {
    const std::size_t end = std::min(formula.find('=', begin), formula.size());
    if (end > begin) all.push_back(typeset_value(formula.substr(begin, end - begin), letters));
    begin = end + 1;
  }
  if (all.size() == 2) all.push_back(difference(all[0], all[1]));
  return all;
}

enum class Match { same, unread, other };

Match match(const std::optional<Value>& typeset, const Value& computed, double allowed) {
  const auto off = difference(typeset, computed);
  return !off ? Match::unread : size_of(*off) <= allowed ? Match::same : Match::other;
}

}  // namespace

Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, Value>>& computed) {
  if (!is_formula(text)) return {};
  double largest = 0;
  for (const auto& [letters, value] : computed)
    if (finite(value)) largest = std::max(largest, size_of(value));
  // What is added up in another order differs by roundings of terms that may cancel; another formula by far
  // more.
  const double allowed = 1e-9 * largest;

  std::vector<Match> matches;
  std::string seen;
  for (const auto& [letters, value] : computed) {
    if (!finite(value)) continue;
    const auto all = meanings(std::string_view(text).substr(1, text.size() - 2), letters);
    matches.resize(all.size(), Match::same);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Match found = match(all[i], value, allowed);
      if (found == Match::other) seen = written(*all[i]) + ", and " + written(value) + " is computed";
      if (matches[i] == Match::same) matches[i] = found;
    }
  }
  const auto any = [&](Match m) { return std::ranges::find(matches, m) != matches.end(); };
  if (matches.empty() || any(Match::same)) return {!matches.empty()};
  return any(Match::unread) ? Typesetting{} : Typesetting{false, text + " is typeset, which is " + seen};
}

}  // namespace oddity
