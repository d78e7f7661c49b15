#pragma once

#include <map>
#include <memory>

#include "chapters/05_fluids_and_gases/shared/fields.hpp"
#include "chapters/claims.hpp"
#include "formula/reader.hpp"

/// Published lines of index calculus, evaluated as printed: `f2,1` is the derivative of f2 by x1, `phi,12`
/// the derivative by x1, then by x2. The report shows the same lines that are computed. Every single sign and
/// index of a line is changed to check that it matters.
namespace oddity::fields {

inline std::string digit(std::size_t i) { return std::string(1, static_cast<char>('0' + i)); }

// ---- samples ----------------------------------------------------------------------------------------------

/// Symbols with their values at one point, and the size of the field that each belongs to.
struct Sample {
  std::string where;
  std::vector<std::string> names = {};
  std::vector<double> values = {}, sizes = {};
  mutable std::shared_ptr<const formula::PlainReader> reader = nullptr;  ///< parser for lines in these names

  void put(std::string name, double value, double size);
  void put(std::string name, double value);
  /// v0, v1, v2.
  void put(const std::string& name, const Point& v);
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

/// Random fields, point, rotated frame and matrix; sizes and wave numbers of the fields range over orders of
/// magnitude.
struct Drawn {
  ScalarField phi;
  VectorField f, g;
  Point x;
  Frame frame;
  Matrix<double> m;
};

/// Calls `fill(sample, drawn)` for 64 draws.
std::vector<Sample> sampled(Random random, const std::function<void(Sample&, const Drawn&)>& fill);

// ---- lines ------------------------------------------------------------------------------------------------

/// A signed product of symbols, given by their indices in a sample.
struct Term {
  double sign = 1;
  std::vector<std::size_t> factors = {};
};
using Terms = std::vector<Term>;

/// Reads a line such as "phi (f2,1 - f1,2) + phi,1 f2" as a sum of products.
Terms read_terms(std::string_view line, const Sample& symbols);

// ---- claims -----------------------------------------------------------------------------------------------

/// The left side that a published line is claimed to equal, and the line.
struct Row {
  std::string left, right;
};

/// A published line with the slug of its claim.
struct Line {
  std::string slug;
  std::vector<Row> rows;
  std::string reading = "printed";
};

/// A row for each component, with `#` replaced by its index.
std::vector<Row> each_component(const std::string& left, const std::string& right);

/// TeX for names of more than one letter: "curl_f" of `curl_f2`, "e0" of `e01`.
using Names = std::map<std::string, std::string>;

/// A line such as "phi (f2,1 - f1,2)" in TeX, without the dollars.
std::string typeset(std::string_view line, const Names& names);

/// The lines of one exercise, and the claims made from them.
class Proof {
 public:
  Proof(const std::string& exercise, std::vector<Sample> at, Names in_tex)
      : claims(exercise), samples(std::move(at)), names(std::move(in_tex)) {}

  Claims claims;
  const std::vector<Sample> samples;
  const Names names;
  std::vector<Line> lines = {};  ///< the confirmed lines

  /// All rows as one vector, at every sample, compared with the left sides, which are computed `by` this
  /// method.
  Reading reading(const std::vector<Row>& rows, const std::string& by) const;
  /// The changed signs and the changed indices of the rows: of each kind, the change that is hardest to
  /// detect.
  std::vector<Reading> single_changes(const std::vector<Row>& rows, const std::string& by) const;

  /// Claims that the line holds. The near misses change each single sign and index. A single line is shown in
  /// full.
  void line(const std::string& slug, int at, std::string says, const std::vector<Row>& rows,
            const std::string& by);
  /// Claims that the line holds, with the given lines as near misses.
  void line(const std::string& slug, int at, std::string says, const std::vector<Row>& rows,
            const std::string& by, const std::vector<std::vector<Row>>& near_misses);
};

}  // namespace oddity::fields
