#pragma once

#include <cctype>
#include <stdexcept>

#include "chapters/05_fluids_and_gases/fields.hpp"
#include "chapters/exercise.hpp"
#include "reference/text.hpp"

/// Published lines of index calculus, evaluated as they are written: `f2,1` is the derivative of f2 by x1,
/// `phi,12` the derivative by x1, then by x2. What a report shows is what was computed, and every single sign
/// and index of a line is changed to see that it matters.
namespace oddity::fields {

inline std::string digit(std::size_t i) { return std::string(1, static_cast<char>('0' + i)); }

// ---- samples ----------------------------------------------------------------------------------------------

/// Symbols with their values at one point, and the size of the field that each belongs to.
struct Sample {
  std::string where;
  std::vector<std::string> names = {};
  std::vector<double> values = {}, sizes = {};

  void put(std::string name, double value, double size) {
    names.push_back(std::move(name));
    values.push_back(value);
    sizes.push_back(size);
  }
  void put(std::string name, double value) { put(std::move(name), value, std::abs(value)); }
  /// v0, v1, v2.
  void put(const std::string& name, const Point& v) {
    for (std::size_t i = 0; i < 3; ++i) put(name + digit(i), v[i], size_of(Value(v)));
  }
  /// The value and the slopes: phi, phi,0 ...
  template <class Field>
  void put_scalar(const std::string& name, const Field& phi, const Point& x) {
    const Point slope = gradient(phi)(x);
    put(name, phi(x), std::abs(phi(x)));
    for (std::size_t j = 0; j < 3; ++j) put(name + "," + digit(j), slope[j], size_of(Value(slope)));
  }
  /// The values and the slopes: f0, ..., f0,0 ...
  template <class Field>
  void put_vector(const std::string& name, const Field& f, const Point& x) {
    put(name, f(x));
    const Matrix<double> slope = jacobian(f, x);
    double size = 0;
    for (const Point& row : slope) size = std::max(size, size_of(Value(row)));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) put(name + digit(i) + "," + digit(j), slope[i][j], size);
  }
};

/// Fields, a point, a turned frame and a matrix, all at random; sizes and wave numbers of the fields over
/// orders of magnitude.
struct Drawn {
  ScalarField phi;
  VectorField f, g;
  Point x;
  Frame frame;
  Matrix<double> m;
};

/// `fill(sample, drawn)` at 64 draws.
template <class Fill>
std::vector<Sample> sampled(Random random, const Fill& fill) {
  std::vector<Sample> all;
  for (int n = 0; n < 64; ++n) {
    const auto size = [&] { return random.magnitude(1e-6, 1e6); };
    const auto rate = [&] { return random.magnitude(0.01, 10); };
    Drawn drawn{{random, size(), rate()}, {random, size(), rate()}, {random, size(), rate()}, {}, {}, {}};
    drawn.x = random.point();
    drawn.frame = random_frame(random);
    drawn.m = {random.point(), random.point(), random.point()};
    all.push_back({"draw " + std::to_string(n) + " at (" + shortest(drawn.x[0]) + ", " +
                   shortest(drawn.x[1]) + ", " + shortest(drawn.x[2]) + ")"});
    fill(all.back(), drawn);
  }
  return all;
}

// ---- lines ------------------------------------------------------------------------------------------------

/// A signed product of symbols, by their places in a sample.
struct Term {
  double sign = 1;
  std::vector<std::size_t> factors = {};
};
using Terms = std::vector<Term>;

/// Reads a line such as "phi (f2,1 - f1,2) + phi,1 f2" as a sum of products.
class Reader {
 public:
  Reader(std::string_view line, const Sample& symbols) : line_(line), symbols_(symbols) {}

  Terms read() {
    Terms all = sum();
    if (next() != '\0') fail();
    return all;
  }

 private:
  Terms sum() {
    Terms all;
    double sign = next() == '-' ? -1 : 1;
    if (!take('-')) take('+');
    do {
      for (Term& t : product()) all.push_back({sign * t.sign, std::move(t.factors)});
      sign = next() == '-' ? -1 : 1;
    } while (take('+') || take('-'));
    return all;
  }
  Terms product() {
    Terms all = factor();
    while (next() == '(' || std::isalpha(next())) {
      const Terms more = factor();
      Terms expanded;
      for (const Term& a : all)
        for (const Term& b : more) {
          Term ab{a.sign * b.sign, a.factors};
          ab.factors.insert(ab.factors.end(), b.factors.begin(), b.factors.end());
          expanded.push_back(std::move(ab));
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
    while (at_ < line_.size() && (std::isalnum(line_[at_]) || line_[at_] == '_' || line_[at_] == ',')) ++at_;
    const auto found = std::ranges::find(symbols_.names, line_.substr(start, at_ - start));
    if (found == symbols_.names.end()) fail();
    return {{1, {static_cast<std::size_t>(found - symbols_.names.begin())}}};
  }
  char next() {
    while (at_ < line_.size() && line_[at_] == ' ') ++at_;
    return at_ < line_.size() ? line_[at_] : '\0';
  }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail() const {
    throw std::logic_error("cannot read '" + std::string(line_) + "' at " + std::to_string(at_));
  }

  std::string_view line_;
  const Sample& symbols_;
  std::size_t at_ = 0;
};

inline double value_of(const Terms& terms, const Sample& s) {
  double sum = 0;
  for (const Term& t : terms) {
    double product = t.sign;
    for (std::size_t k : t.factors) product *= s.values[k];
    sum += product;
  }
  return sum;
}
/// The size of the terms that are added up.
inline double size_of(const Terms& terms, const Sample& s) {
  double sum = 0;
  for (const Term& t : terms) {
    double product = 1;
    for (std::size_t k : t.factors) product *= s.sizes[k];
    sum += product;
  }
  return sum;
}

// ---- claims -----------------------------------------------------------------------------------------------

/// What a published line is said to equal, and the line.
struct Row {
  std::string left, right;
};

inline std::string written(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) text += (text.empty() ? "" : "; ") + row.left + " = " + row.right;
  return text;
}

/// All rows, as one vector, at every sample.
inline Check compare(const std::vector<Sample>& samples, const std::vector<Row>& rows,
                     const std::string& by) {
  std::vector<std::pair<Terms, Terms>> lines;
  std::string quantity;
  for (const Row& row : rows) {
    quantity += (quantity.empty() ? "" : "; ") + row.left;
    lines.emplace_back(Reader(row.left, samples[0]).read(), Reader(row.right, samples[0]).read());
  }
  Worst worst(quantity, by, "the line as it is written");
  for (const Sample& s : samples) {
    std::vector<double> left, right;
    double size = 0;
    for (const auto& [l, r] : lines) {
      left.push_back(value_of(l, s));
      right.push_back(value_of(r, s));
      size = std::max(size, size_of(r, s));
    }
    worst.see(left, right, size, s.where);
  }
  return worst.check();
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

/// Of all single changes to one row, the one that is hardest to see.
inline Reading hardest_to_see(const std::string& kind, const std::vector<Sample>& samples,
                              const std::vector<Row>& rows, const std::string& by,
                              std::vector<std::string> (*changes)(const std::string&)) {
  Reading hardest;
  double least = 0;
  int count = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const std::string& changed : changes(rows[i].right)) {
      std::vector<Row> changed_rows = rows;
      changed_rows[i].right = changed;
      const Check check = compare(samples, changed_rows, by);
      const double tolerances = check.difference() / check.tolerance.allowed;
      if (count++ > 0 && tolerances >= least) continue;
      least = tolerances;
      hardest = {written(changed_rows), {check}};
    }
  hardest.text = kind + ", the hardest to see of " + std::to_string(count) + ": " + hardest.text;
  return hardest;
}

/// The lines of one exercise, and the claims that come of them.
class Proof {
 public:
  Proof(std::string number, std::vector<Sample> at) : samples(std::move(at)), exercise(std::move(number)) {}

  std::vector<Sample> samples;
  std::vector<Claim> claims;

  /// Published lines hold; the near misses change each single sign and index.
  Claim& line(const std::string& slug, int at, std::string says, const std::vector<Row>& rows,
              const std::string& by) {
    claims.push_back({exercise + "-" + slug, at, std::move(says), {written(rows), {}}});
    return also(rows, by);
  }
  /// A further comparison for the claim made last, with its near misses.
  Claim& also(const std::vector<Row>& rows, const std::string& by) {
    Claim& claim = claims.back();
    claim.printed.checks.push_back(compare(samples, rows, by));
    claim.near_misses.push_back(hardest_to_see("a sign flipped", samples, rows, by, signs_flipped));
    claim.near_misses.push_back(hardest_to_see("an index changed", samples, rows, by, indices_changed));
    return claim;
  }
  /// Published lines hold; the near misses are the lines given.
  Claim& line(const std::string& slug, int at, std::string says, const std::vector<Row>& rows,
              const std::string& by, const std::vector<std::vector<Row>>& near_misses) {
    claims.push_back(
        {exercise + "-" + slug, at, std::move(says), {written(rows), {compare(samples, rows, by)}}});
    for (const auto& near : near_misses)
      claims.back().near_misses.push_back({written(near), {compare(samples, near, by)}});
    return claims.back();
  }

 private:
  std::string exercise;
};

}  // namespace oddity::fields
