#pragma once

#include <cctype>
#include <stdexcept>

#include "chapters/05_fluids_and_gases/fields.hpp"
#include "chapters/exercise.hpp"
#include "reference/text.hpp"

/// Published lines of index calculus, evaluated as they are written: `f2,1` is the derivative of f2 by x1,
/// `phi,12` the derivative by x1, then x2. What a report shows is what was computed, and every single sign
/// and index of a line can be changed to see that it matters.
namespace oddity::fields {

/// Where a sample is: which field, and the point.
inline std::string place(int n, const Point& x) {
  return "field " + std::to_string(n) + " at (" + shortest(x[0]) + ", " + shortest(x[1]) + ", " +
         shortest(x[2]) + ")";
}

/// Symbols with their values at one point, and the size of the field that they belong to.
class Sample {
 public:
  explicit Sample(std::string at) : where(std::move(at)) {}

  void put(std::string name, double value, double size) {
    names.push_back(std::move(name));
    values.push_back(value);
    sizes.push_back(size);
  }
  void put(const std::string& name, const Point& v) {
    for (std::size_t i = 0; i < 3; ++i) put(name + digit(i), v[i], size_of(v));
  }
  /// phi, phi,0 ...
  template <class Field>
  void put_scalar(const std::string& name, const Field& phi, const Point& x) {
    const Point slope = gradient(phi)(x);
    put(name, phi(x), std::abs(phi(x)));
    for (std::size_t j = 0; j < 3; ++j) put(name + "," + digit(j), slope[j], size_of(slope));
  }
  /// f0, f0,0 ...
  template <class Field>
  void put_vector(const std::string& name, const Field& f, const Point& x) {
    put(name, f(x));
    const Matrix<double> slope = jacobian(f, x);
    const double size = std::max({size_of(slope[0]), size_of(slope[1]), size_of(slope[2])});
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) put(name + digit(i) + "," + digit(j), slope[i][j], size);
  }

  std::string where;
  std::vector<std::string> names;
  std::vector<double> values, sizes;

 private:
  static std::string digit(std::size_t i) { return std::string(1, static_cast<char>('0' + i)); }
  static double size_of(const Point& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }
};

/// A sum of products of symbols, read from a line such as "phi (f2,1 - f1,2) + phi,1 f2".
class Line {
 public:
  Line(std::string_view text, const Sample& symbols) : text_(text), symbols_(symbols) {
    terms_ = sum();
    if (at_ != text_.size()) fail();
  }

  double value(const Sample& s) const {
    double total = 0;
    for (const Term& t : terms_) {
      double product = t.sign;
      for (std::size_t k : t.factors) product *= s.values[k];
      total += product;
    }
    return total;
  }
  /// The size of the terms that are added up.
  double size(const Sample& s) const {
    double total = 0;
    for (const Term& t : terms_) {
      double product = 1;
      for (std::size_t k : t.factors) product *= s.sizes[k];
      total += product;
    }
    return total;
  }

 private:
  struct Term {
    double sign = 1;
    std::vector<std::size_t> factors = {};
  };
  using Terms = std::vector<Term>;

  Terms sum() {
    double sign = take('-') ? -1 : (take('+'), 1);
    Terms all;
    while (true) {
      for (Term& t : product()) all.push_back({sign * t.sign, std::move(t.factors)});
      if (take('+'))
        sign = 1;
      else if (take('-'))
        sign = -1;
      else
        return all;
    }
  }
  Terms product() {
    Terms all = factor();
    while (next() == '(' || std::isalpha(next())) {
      const Terms more = factor();
      Terms expanded;
      for (const Term& a : all)
        for (const Term& b : more) {
          expanded.push_back({a.sign * b.sign, a.factors});
          expanded.back().factors.insert(expanded.back().factors.end(), b.factors.begin(), b.factors.end());
        }
      all = std::move(expanded);
    }
    return all;
  }
  Terms factor() {
    if (take('(')) {
      Terms inside = sum();
      if (!take(')')) fail();
      return inside;
    }
    next();
    const std::size_t start = at_;
    while (at_ < text_.size() && (std::isalnum(text_[at_]) || text_[at_] == '_' || text_[at_] == ',')) ++at_;
    const auto found = std::ranges::find(symbols_.names, text_.substr(start, at_ - start));
    if (found == symbols_.names.end()) fail();
    return {{1, {static_cast<std::size_t>(found - symbols_.names.begin())}}};
  }
  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail() const {
    throw std::logic_error("cannot read '" + std::string(text_) + "' at " + std::to_string(at_));
  }

  std::string_view text_;
  const Sample& symbols_;
  std::size_t at_ = 0;
  Terms terms_;
};

/// A symbol and the published line that it is said to equal.
struct Row {
  std::string left, right;
};

/// All rows, as one vector, at every sample.
inline Check compare(const std::vector<Sample>& samples, const std::vector<Row>& rows,
                     const std::string& by) {
  std::vector<std::pair<Line, Line>> lines;
  std::string quantity;
  for (const Row& row : rows) {
    quantity += (quantity.empty() ? "" : "; ") + row.left;
    lines.emplace_back(Line(row.left, samples[0]), Line(row.right, samples[0]));
  }
  Worst worst(quantity, by, "the line as it is written");
  for (const Sample& s : samples) {
    Value left = std::vector<double>(rows.size()), right = left;
    double size = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      left[i] = lines[i].first.value(s);
      right[i] = lines[i].second.value(s);
      size = std::max(size, lines[i].second.size(s));
    }
    worst.see(left, right, size, s.where);
  }
  return worst.check();
}

inline std::string written(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) text += (text.empty() ? "" : "; ") + row.right;
  return text;
}

/// Every line that differs from this one by a single sign.
inline std::vector<std::string> signs_flipped(const std::string& line) {
  std::vector<std::string> all;
  if (line[0] != '-') all.push_back("- " + line);
  for (std::size_t i = 0; i < line.size(); ++i)
    if (line[i] == '+' || line[i] == '-') (all.emplace_back(line))[i] = line[i] == '+' ? '-' : '+';
  return all;
}
/// Every line that differs from this one by a single index.
inline std::vector<std::string> indices_changed(const std::string& line) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < line.size(); ++i)
    for (char other : {'0', '1', '2'})
      if (std::isdigit(line[i]) && line[i] != other) (all.emplace_back(line))[i] = other;
  return all;
}

/// Of all the changes to one row, the one that is hardest to see.
inline Reading hardest_to_see(const std::string& kind, const std::vector<Sample>& samples,
                              const std::vector<Row>& rows, const std::string& by,
                              std::vector<std::string> (*changes)(const std::string&)) {
  Reading hardest;
  double least = std::numeric_limits<double>::infinity();
  int count = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const std::string& changed : changes(rows[i].right)) {
      std::vector<Row> changed_rows = rows;
      changed_rows[i].right = changed;
      const Check check = compare(samples, changed_rows, by);
      const double ratio = check.difference() / check.tolerance.allowed;
      ++count;
      if (hardest.checks.empty() || !(ratio >= least))
        least = ratio, hardest = {written(changed_rows), {check}};
    }
  hardest.text = kind + ", the hardest to see of " + std::to_string(count) + ": " + hardest.text;
  return hardest;
}

/// The claim that published lines hold; its near misses change each single sign and index.
inline Claim published(std::string id, int line, std::string says, const std::vector<Sample>& samples,
                       const std::vector<Row>& rows, const std::string& by) {
  Claim claim{std::move(id), line, std::move(says)};
  claim.printed = {written(rows), {compare(samples, rows, by)}};
  claim.near_misses = {hardest_to_see("a sign flipped", samples, rows, by, signs_flipped),
                       hardest_to_see("an index changed", samples, rows, by, indices_changed)};
  return claim;
}

}  // namespace oddity::fields
