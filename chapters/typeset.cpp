#include "chapters/typeset.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

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

/// {x} as x, but {15}, of which a fraction would take the 1.
void without_single_groups(Tokens& tokens) {
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i)
    if (tokens[i] == "{" && tokens[i + 2] == "}" && tokens[i + 1] != "}" &&
        (tokens[i + 1].size() == 1 || !is_digit(tokens[i + 1][0]))) {
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 2);
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// A number is one token only at the top: x_12 is x with the index 1, and 2.
Tokens tokens_of(std::string_view text) {
  Tokens tokens;
  bool in_indices = false;
  while (!text.empty()) {
    std::size_t n = 1;
    if (text[0] == '\\')
      n = length_of_command(text);
    else if (is_digit(text[0]) && !in_indices &&
             (tokens.empty() || !among(tokens.back(), {"_", "^", R"(\frac)", R"(\sqrt)"})))
      while (n < text.size() &&
             (is_digit(text[n]) || (text[n] == '.' && n + 1 < text.size() && is_digit(text[n + 1]))))
        ++n;
    std::string token(text.substr(0, n));
    text.remove_prefix(n);
    if (token == R"(\tfrac)" || token == R"(\dfrac)") token = R"(\frac)";
    in_indices = token == "{" ? !tokens.empty() && tokens.back() == "_" : in_indices && token != "}";
    if (token != " " && token != "$" && !says_nothing(token)) tokens.push_back(std::move(token));
  }
  without_single_groups(tokens);
  return tokens;
}

// ---- values -----------------------------------------------------------------------------------------------

/// A number, a column, a row (as x^T) or a matrix.
struct Matrix {
  Value entries;  ///< row by row
  std::size_t columns = 1;
  std::size_t rows() const { return entries.size() / columns; }
};

/// Four or nine numbers of a letter are a square matrix.
Matrix of_letter(const Value& x) { return {x, x.size() == 4 ? 2u : x.size() == 9 ? 3u : 1u}; }

double number(const Matrix& x) {
  if (x.entries.size() != 1) throw Unread();
  return x.entries[0];
}
bool is_number(const Matrix& x) { return x.entries.size() == 1; }
Matrix scaled(const Matrix& x, double factor) {
  Matrix y = x;
  for (std::size_t i = 0; i < y.entries.size(); ++i) y.entries[i] *= factor;
  return y;
}
bool is_zero(const Value& x) { return x.size() == 1 && x[0] == 0; }
/// A lone 0 is zero of any kind.
Matrix sum(const Matrix& a, const Matrix& b, double sign) {
  if (is_zero(a.entries)) return scaled(b, sign);
  if (is_zero(b.entries)) return a;
  if (a.entries.size() != b.entries.size()) throw Unread();
  Matrix y{a.entries, std::max(a.columns, b.columns)};
  for (std::size_t i = 0; i < y.entries.size(); ++i) y.entries[i] += sign * b.entries[i];
  return y;
}
Matrix product(const Matrix& a, const Matrix& b) {
  if (is_number(a)) return scaled(b, number(a));
  if (is_number(b)) return scaled(a, number(b));
  if (a.columns != b.rows()) throw Unread();
  Matrix y{std::vector<double>(a.rows() * b.columns), b.columns};
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t k = 0; k < a.columns; ++k)
      for (std::size_t j = 0; j < b.columns; ++j)
        y.entries[i * b.columns + j] += a.entries[i * a.columns + k] * b.entries[k * b.columns + j];
  return y;
}
Matrix transposed(const Matrix& x) {
  Matrix y{x.entries, x.rows()};
  for (std::size_t i = 0; i < x.rows(); ++i)
    for (std::size_t j = 0; j < x.columns; ++j) y.entries[j * y.columns + i] = x.entries[i * x.columns + j];
  return y;
}
double dot(const Matrix& a, const Matrix& b) {
  if (a.entries.size() != b.entries.size() || (a.columns > 1 && a.rows() > 1)) throw Unread();
  double total = 0;
  for (std::size_t i = 0; i < a.entries.size(); ++i) total += a.entries[i] * b.entries[i];
  return total;
}
Matrix cross(const Matrix& x, const Matrix& y) {
  const Value &a = x.entries, &b = y.entries;
  if (a.size() == 1 && b.size() == 1) return {{a[0] * b[0]}};
  if (a.size() != 3 || b.size() != 3) throw Unread();
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

Matrix joined(const Matrix& a, const Matrix& b) {
  std::vector<double> all(a.entries.begin(), a.entries.end());
  all.insert(all.end(), b.entries.begin(), b.entries.end());
  return {all};
}
Matrix diagonal(const Value& x) {
  Matrix y{std::vector<double>(x.size() * x.size()), x.size()};
  for (std::size_t i = 0; i < x.size(); ++i) y.entries[i * (x.size() + 1)] = x[i];
  return y;
}
/// That of x times.
Matrix skew(const Value& x) {
  if (x.size() != 3) throw Unread();
  return {{0, -x[2], x[1], x[2], 0, -x[0], -x[1], x[0], 0}, 3};
}

Matrix unskew(const Matrix& x) {
  if (x.rows() != 3 || x.columns != 3) throw Unread();
  return {{x.entries[7], x.entries[2], x.entries[3]}};
}
Matrix beside(const Matrix& a, const Matrix& b) {
  if (a.rows() != b.rows()) throw Unread();
  return transposed({joined(transposed(a), transposed(b)).entries, a.rows()});
}
Matrix above(const Matrix& a, const Matrix& b) {
  if (a.columns != b.columns) throw Unread();
  return {joined(a, b).entries, a.columns};
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

using Letters = std::vector<std::pair<Tokens, Matrix>>;

/// The longest first.
Letters letters_of(const TypesetLetters& all) {
  Letters letters;
  for (const auto& [written, value] : all) letters.emplace_back(tokens_of(written), of_letter(value));
  std::ranges::stable_sort(letters, std::ranges::greater(), [](const auto& l) { return l.first.size(); });
  return letters;
}

const Matrix* value_of(const Letters& letters, const Tokens& letter) {
  const auto found = std::ranges::find(letters, letter, &Letters::value_type::first);
  return found == letters.end() ? nullptr : &found->second;
}

/// x as \dot x, \dot x as \ddot x.
Tokens rate_of(Tokens letter) {
  if (letter.front() == R"(\dot)")
    letter.front() = R"(\ddot)";
  else
    letter.insert(letter.begin(), R"(\dot)");
  return letter;
}

/// All that have a rate, after a time.
Letters later(const Letters& letters, double time) {
  Letters moved = letters;
  for (auto& [letter, value] : moved)
    if (const Matrix* rate = value_of(letters, rate_of(letter))) value = sum(value, *rate, time);
  return moved;
}

class Reader {
 public:
  Reader(Tokens tokens, const Letters& letters) : tokens_(std::move(tokens)), letters_(letters) {}

  Matrix all() {
    Matrix x = sum_of_terms();
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
  bool take_all(std::initializer_list<std::string_view> tokens) {
    std::size_t n = 0;
    for (const std::string_view token : tokens)
      if (next(n++) != token) return false;
    at_ += n;
    return true;
  }
  void expect(std::string_view token) {
    if (!take(token)) throw Unread();
  }
  Tokens from(std::size_t begin, std::size_t end) const {
    return {tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
            tokens_.begin() + static_cast<std::ptrdiff_t>(end)};
  }

  Matrix sum_of_terms() {
    while (take(R"(\,)")) continue;
    const double first = sign();
    Matrix total = dot_products();
    if (first != 0) total = scaled(total, first);
    for (double next_one = sign(); next_one != 0; next_one = sign())
      total = sum(total, dot_products(), next_one);
    return total;
  }
  /// Zero where there is none. Where both are written a letter says which.
  double sign() {
    if (take("+")) return 1;
    if (take("-")) return -1;
    const bool lower = next() == R"(\mp)";
    const Matrix* either = lower || next() == R"(\pm)" ? value_of(letters_, {R"(\pm)"}) : nullptr;
    if (!either) return 0;
    ++at_;
    return lower ? -number(*either) : number(*either);
  }

  /// u . v x w is that of u and v x w.
  Matrix dot_products() {
    Matrix x = cross_products();
    while (take(R"(\cdot)")) {
      const Matrix y = cross_products();
      x = is_number(x) || is_number(y) ? product(x, y) : Matrix{{dot(x, y)}};
    }
    return x;
  }
  Matrix cross_products() {
    Matrix x = factors();
    while (take(R"(\times)")) x = cross(x, factors());
    return x;
  }
  Matrix factors() {
    Matrix x = power();
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
           !among(token, {"+", "-", R"(\pm)", R"(\mp)", ")", "]", "}", ",", ";", "/", "=", "&", R"(\\)",
                          R"(\end)", R"(\cdot)", R"(\times)", R"(\,)"}) &&
           (token != "|" || !inside_bars_);
  }

  Matrix power() {
    if (next() == R"(\sum)") return sum_over_index();
    if (const Named* f = function()) return of_function(*f);
    const bool is_e = next() == "e" && next(1) == "^" && !letter_here();
    if (is_e) {
      at_ += 2;
      return {{std::exp(number(argument()))}};
    }
    Matrix x = base();
    while (take("^")) {
      if (!is_number(x) && take("T"))
        x = transposed(x);
      else
        x = {{std::pow(number(x), number(argument()))}};
    }
    return x;
  }

  const Named* function() const {
    const auto found = std::ranges::find(functions, next(), &Named::name);
    return found == functions.end() ? nullptr : &*found;
  }
  /// \sin^2 x is (\sin x)^2, and \sin^{-1} x the inverse function's.
  Matrix of_function(const Named& f) {
    ++at_;
    const double exponent = take("^") ? number(argument()) : 1;
    const double x = number(next() == "(" || next() == "{" ? base() : argument_of_function());
    return {{exponent == -1 ? f.inverse(x) : std::pow(f.function(x), exponent)}};
  }
  /// \sin\omega t, and up to where something else begins.
  Matrix argument_of_function() {
    Matrix x = power();
    while (begins_factor() && !function() && next() != "(" && next() != R"(\dot)" && next() != R"(\ddot)" &&
           next() != R"(\mathbf)")
      x = product(x, power());
    return x;
  }

  /// \sum_i m_ix_i, or \sum m_ix_i, is over all that there are letters of, and of one product.
  Matrix sum_over_index() {
    expect(R"(\sum)");
    if (take_all({"_", R"(\sigma)"})) return sum_over_permutations();
    std::string index;
    double last = 99;
    if (take_all({"_", "{"})) {
      index = next();
      ++at_;
      expect(R"(\le)");
      last = number(base());
      expect("}");
    } else if (take("_")) {
      index = next();
      ++at_;
    } else {
      index = first_index();
    }
    return sum_over(index, static_cast<int>(last));
  }
  /// Of all that follows.
  Matrix sum_over_permutations() {
    const Tokens term = from(std::exchange(at_, tokens_.size()), tokens_.size());
    std::vector<int> order(static_cast<std::size_t>(std::ranges::count(term, R"(\sigma)")));
    if (std::ranges::count(term, R"(\varepsilon)") > 0 && !order.empty()) order.pop_back();  // the sign's own
    if (order.empty() || order.size() > 6) throw Unread();
    std::iota(order.begin(), order.end(), 1);
    double total = 0;
    do total += number(Reader(permuted(term, order), letters_).all());
    while (std::ranges::next_permutation(order).found);
    return {{total}};
  }
  /// \sigma(k) is the k-th, and \varepsilon_\sigma -1 where an odd number of pairs is out of order.
  static Tokens permuted(const Tokens& term, const std::vector<int>& order) {
    int inversions = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t k = i + 1; k < order.size(); ++k) inversions += order[i] > order[k];
    Tokens all;
    for (std::size_t i = 0; i < term.size(); ++i)
      if (term[i] == R"(\varepsilon)" && i + 2 < term.size() && term[i + 2] == R"(\sigma)") {
        if (inversions % 2 != 0) all.insert(all.end(), {"(", "-", "1", ")"});
        i += 2;
      } else if (term[i] == R"(\sigma)" && i + 3 < term.size() && term[i + 1] == "(" && term[i + 3] == ")" &&
                 term[i + 2].size() == 1 && is_digit(term[i + 2][0])) {
        const auto k = static_cast<std::size_t>(term[i + 2][0] - '1');
        if (k >= order.size()) throw Unread();
        all.push_back(std::to_string(order[k]));
        i += 3;
      } else {
        all.push_back(term[i]);
      }
    return all;
  }
  std::string first_index() const {
    for (std::size_t i = at_; i + 1 < tokens_.size(); ++i)
      if (tokens_[i] == "_" && among(tokens_[i + 1], {"i", "j", "k", "n"})) return tokens_[i + 1];
    throw Unread();
  }
  Matrix sum_over(const std::string& index, int last) {
    const Tokens term = from(at_, tokens_.size());
    std::optional<Matrix> total;
    std::size_t length = 0;
    for (int i = 0; i <= last; ++i) {
      Reader reader(with_index(term, index, i), letters_);
      reader.inside_bars_ = inside_bars_;
      try {
        const Matrix value = reader.dot_products();
        total = total ? sum(*total, value, 1) : value;
        if (i < 10) length = reader.at_;
      } catch (const Unread&) {
        if (total) break;
        if (i > 0) throw;
      }
    }
    const Tokens summed = from(at_, at_ + length);
    if (!total || std::ranges::find(summed, index) == summed.end()) throw Unread();
    at_ += length;
    return *total;
  }
  /// m_i as m_3, or m_{12}.
  static Tokens with_index(const Tokens& term, const std::string& index, int i) {
    Tokens all;
    for (const std::string& token : term)
      if (token != index)
        all.push_back(token);
      else if (i < 10)
        all.push_back(std::to_string(i));
      else
        all.insert(all.end(), {"{", std::to_string(i / 10), std::to_string(i % 10), "}"});
    return all;
  }

  /// What stands behind \frac, \sqrt and ^: a group, or one token.
  Matrix argument() {
    if (next() == "{") return base();
    if (!next().empty() && is_digit(next()[0])) return {{static_cast<double>(first_digit())}};
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

  Matrix base() {
    if (const auto* letter = letter_here()) {
      at_ += letter->first.size();
      return letter->second;
    }
    if (take_all({R"(\frac)", "d", "{", "d", "t", "}"})) return time_derivative();
    if (take_all({R"(\int)", "_"})) return integral();
    if (take(R"(\int)")) return along_curve();
    if (take_all({R"(\begin)", "{", "p", "m", "a", "t", "r", "i", "x", "}"})) return matrix();
    if (take(R"(\frac)")) {
      const Matrix above = argument();
      return scaled(above, 1 / number(argument()));
    }
    if (take_all({R"(\mathrm)", "{", "D", "i", "a", "g", "}", "("})) return diagonal(closed_by(")").entries);
    if (take_all({R"(\mathrm)", "{", "S", "k", "e", "w", "}", "("})) return skew(closed_by(")").entries);
    if (take_all({R"(\mathrm)", "{", "U", "n", "s", "k", "e", "w", "}", "("})) return unskew(closed_by(")"));
    if (take(R"(\sqrt)")) return {{std::sqrt(number(argument()))}};
    if (take("{")) return closed_by("}");
    if (take("(")) return closed_by(")");
    if (take("[")) return closed_by("]");
    if (take("|")) return {{between_bars()}};
    if (take(R"(\pi)")) return {{std::numbers::pi}};
    return {{numeral()}};
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
    const Matrix x = sum_of_terms();
    inside_bars_ = outside;
    expect("|");
    return std::sqrt(dot(x, x));
  }
  /// A sum, or several with commas between them: a tuple; with semicolons between rows.
  Matrix closed_by(std::string_view end) {
    const bool outside = std::exchange(inside_bars_, false);
    Matrix all = sum_of_terms();
    std::size_t columns = 1;
    while (next() == "," || next() == ";") {
      if (take(";") && columns == 1) columns = all.entries.size();
      take(",");
      all = joined(all, sum_of_terms());
    }
    inside_bars_ = outside;
    expect(end);
    if (all.entries.size() % columns != 0) throw Unread();
    return columns == 1 ? all : Matrix{all.entries, columns};
  }

  /// Up to \end{pmatrix}, of numbers, columns or matrices.
  Matrix matrix() {
    Matrix all = row();
    while (take(R"(\\)")) all = above(all, row());
    if (!take_all({R"(\end)", "{", "p", "m", "a", "t", "r", "i", "x", "}"})) throw Unread();
    return all;
  }
  Matrix row() {
    Matrix all = sum_of_terms();
    while (take("&")) all = beside(all, sum_of_terms());
    return all;
  }

  /// Of what follows, along the rates of its letters: by differences of eighth order.
  Matrix time_derivative() {
    constexpr double step = 0x1p-7;
    constexpr std::array weights{4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    const std::size_t begin = at_;
    Matrix slope = scaled(power(), 0);
    const Tokens changing = from(begin, at_);
    for (std::size_t i = 0; i < weights.size(); ++i)
      for (const double sign : {1.0, -1.0})
        slope = sum(slope, Reader(changing, later(letters_, sign * step * static_cast<double>(i + 1))).all(),
                    sign * weights[i] / step);
    return slope;
  }

  /// \int_0^T f\,dt, by Gauss's rule.
  Matrix integral() {
    const double low = number(argument());
    expect("^");
    const double high = number(argument());
    std::size_t end = at_;
    while (end + 2 < tokens_.size() && !(tokens_[end] == R"(\,)" && tokens_[end + 1] == "d")) ++end;
    if (end + 2 >= tokens_.size()) throw Unread();
    const Tokens integrand = from(at_, end);
    const std::string& variable = tokens_[end + 2];
    at_ = end + 3;
    const auto f = [&](double x) {
      Letters letters{{{variable}, {{x}}}};
      letters.insert(letters.end(), letters_.begin(), letters_.end());
      return number(Reader(integrand, letters).all());
    };
    return {{gauss_legendre(f, low, high, 64).value}};
  }

  /// \int f\,ds, by the nodes that ds has weights of: other letters of as many numbers or pairs are at these.
  Matrix along_curve() {
    const Tokens ds{"d", "s"};
    const auto here = tokens_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto end = std::search(here, tokens_.end(), ds.begin(), ds.end());
    const Matrix* weights = value_of(letters_, ds);
    if (end == tokens_.end() || !weights || weights->entries.size() < 10) throw Unread();
    Tokens integrand(here, end);
    if (integrand.empty()) integrand = {"1"};
    at_ += static_cast<std::size_t>(end - here) + ds.size();
    const std::size_t n = weights->entries.size();
    double total = 0;
    for (std::size_t i = 0; i < n; ++i)
      total += weights->entries[i] * number(Reader(integrand, at_node(i, n)).all());
    return {{total}};
  }
  Letters at_node(std::size_t i, std::size_t n) const {
    Letters all;
    for (const auto& [letter, value] : letters_)
      if (const std::size_t size = value.entries.size(); size >= n && size % n == 0) {
        const auto first = value.entries.begin() + static_cast<std::ptrdiff_t>(i * (size / n));
        const auto end = first + static_cast<std::ptrdiff_t>(size / n);
        all.push_back({letter, {std::vector<double>(first, end)}});
      }
    all.insert(all.end(), letters_.begin(), letters_.end());
    std::ranges::stable_sort(all, std::ranges::greater(), [](const auto& l) { return l.first.size(); });
    return all;
  }

  /// The longest that fits and is not part of a longer one: R is not the beginning of R_1.
  const Letters::value_type* letter_here() const {
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
  const Letters& letters_;
  std::size_t at_ = 0;
  bool inside_bars_ = false;
};

// ---- index notation ---------------------------------------------------------------------------------------

/// An index: i, or j_2.
using Index = Tokens;

/// The index that begins here, if one does.
Index index_at(const Tokens& tokens, std::size_t at) {
  const std::string& letter = tokens[at];
  if (!among(letter, {"i", "j", "k", "l", "m", "r", "c"})) return {};
  const bool numbered = at + 2 < tokens.size() && tokens[at + 1] == "_" && is_digit(tokens[at + 2][0]);
  return numbered ? Index{letter, "_", tokens[at + 2]} : Index{letter};
}

/// What `see` makes of each index in _{...} or behind _, in their place.
Tokens with_indices(const Tokens& tokens, const std::function<Tokens(const Index&)>& see) {
  Tokens all;
  bool inside = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool behind = i > 0 && tokens[i - 1] == "_";
    inside = tokens[i] == "{" ? behind : inside && tokens[i] != "}";
    const Index index = inside || behind ? index_at(tokens, i) : Index{};
    const Tokens seen = index.empty() ? Tokens{tokens[i]} : see(index);
    all.insert(all.end(), seen.begin(), seen.end());
    if (!index.empty()) i += index.size() - 1;
  }
  without_single_groups(all);
  return all;
}

/// f_i is a vector by the one index that occurs once, or a matrix by r and c. Of a product e_{ijk}g_jf_k each
/// index that occurs twice is summed over 0, 1, 2.
class IndexNotation {
 public:
  IndexNotation(const Tokens& tokens, const Letters& letters) : tokens_(tokens), letters_(letters) {
    const bool is_product = std::ranges::none_of(tokens, [](const std::string& token) {
      return among(token, {"+", "-", R"(\pm)", R"(\mp)"});
    });
    for (const auto& [index, count] : counts())
      if (count == 1)
        free_.insert(free_.begin(), index);
      else if (count == 2 && is_product)
        summed_.push_back(index);
      else
        throw Unread();
    const bool rows_and_columns = free_ == std::vector<Index>{{"r"}, {"c"}};
    if (free_.size() != 1 && !rows_and_columns) throw Unread();
    if (summed_.empty()) range_ = known();
  }

  Value all() {
    std::vector<double> all;
    for (const int first : range_) {
      values_[free_[0]] = first;
      if (free_.size() == 1) all.push_back(sum_from(0));
      for (std::size_t k = 0; free_.size() > 1 && k < range_.size(); ++k) {
        values_[free_[1]] = range_[k];
        all.push_back(sum_from(0));
      }
    }
    return all;
  }

 private:
  /// Without those that a \sum has.
  std::map<Index, int> counts() const {
    std::map<Index, int> all;
    with_indices(tokens_, [&](const Index& index) {
      ++all[index];
      return index;
    });
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i)
      if (tokens_[i] == R"(\sum)" && tokens_[i + 1] == "_") all.erase({tokens_[i + 2]});
    return all;
  }
  /// The digits that there are letters of.
  std::vector<int> known() {
    std::vector<int> all;
    for (int i = 0; i < 10; ++i) try {
        for (const Index& index : free_) values_[index] = i;
        here();
        all.push_back(i);
      } catch (const Unread&) {
        if (!all.empty()) break;
      }
    if (all.empty()) throw Unread();
    return all;
  }
  double sum_from(std::size_t k) {
    if (k == summed_.size()) return here();
    double sum = 0;
    for (const int i : range_) {
      values_[summed_[k]] = i;
      sum += sum_from(k + 1);
    }
    return sum;
  }
  double here() const {
    const Tokens at = with_indices(tokens_, [&](const Index& index) {
      const auto value = values_.find(index);
      return value == values_.end() ? index : Tokens{std::to_string(value->second)};
    });
    return number(Reader(at, letters_).all());
  }

  const Tokens& tokens_;
  const Letters& letters_;
  std::vector<Index> free_, summed_;
  std::vector<int> range_{0, 1, 2};
  std::map<Index, int> values_;
};

}  // namespace

std::optional<Value> typeset_value(std::string_view formula, const TypesetLetters& letters) {
  const Tokens tokens = tokens_of(formula);
  const Letters all = letters_of(letters);
  const auto read = [](const auto& by) -> std::optional<Value> {
    try {
      return by();
    } catch (const Unread&) {
      return std::nullopt;
    }
  };
  const auto as_it_stands = read([&] { return Reader(tokens, all).all().entries; });
  return as_it_stands ? as_it_stands : read([&] { return IndexNotation(tokens, all).all(); });
}

}  // namespace oddity
