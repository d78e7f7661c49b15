#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formula/tree.hpp"
#include "problem/expression.hpp"
#include "problem/measure.hpp"
#include "problem/shape.hpp"
#include "problem/table.hpp"
#include "reference/bad_input.hpp"

/// Formulas of a problem's file: the plain text of formula/, with units behind numerals, if, abs, max, min
/// and atan2, and declared letters.
namespace oddity::problem {

/// Place of a text in a file. Lines and columns begin with 1.
struct Place {
  std::size_t line = 0, column = 0;
};

/// An error in a file, with its line and column, and a caret below.
class WrongFile : public BadInput {
 public:
  WrongFile(const std::string& file, const std::string& text, Place place, const std::string& reason);

  Place place() const { return place_; }
  const std::string& reason() const { return reason_; }

 private:
  Place place_;
  std::string reason_;
};

/// A file's text, for error messages. It must outlive everything read from it.
struct Source {
  std::string name, text;

  [[noreturn]] void fail(Place place, const std::string& reason) const {
    throw WrongFile(name, text, place, reason);
  }
};

/// A piece of a file's text.
struct Quoted {
  std::string text;
  Place place;
  bool is_translated = false;      ///< the file has other words there
  std::vector<Quoted> parts = {};  ///< parts of a list, whose text is (a, b), or (a, b; c, d)
  std::size_t columns = 1;         ///< columns of this list

  Size size() const { return {std::max<std::size_t>(parts.size() / columns, 1), columns}; }
  Place at(std::size_t offset) const {
    return is_translated ? place : Place{place.line, place.column + offset};
  }
};

/// The letters that formulas may use: parameters, unknowns with their rates, abbreviations.
struct Letters {
  std::vector<std::string> parameters, unknowns, given;
  std::vector<std::shared_ptr<const Table>> tables = {};  ///< called like functions
};

/// Names with a meaning in every formula: the time, pi, and the functions.
std::vector<std::string> names_with_meaning();

struct Letter;

class Formula {
 public:
  /// Throws WrongFile.
  Formula(const Source&, Quoted, const Letters&);

  /// The value of a formula of numbers; `of` gives the value of each letter except calls.
  Expression value(const std::function<Expression(const Letter&)>& of) const;
  /// Throws WrongFile if units do not fit.
  Measure measure(const std::function<Measure(const Letter&)>& of) const;

  /// Values where letters may be vectors; `of` gives a whole one also for its component.
  template <class T>
  using Of = std::function<formula::Matrix<T>(const Letter&)>;
  formula::Matrix<Expression> values(const Of<Expression>& of) const { return evaluated(of); }
  formula::Matrix<Measure> measures(const Of<Measure>& of) const { return evaluated(of); }
  Shape shape(const Of<double>& of) const { return evaluated(of); }
  /// Its only entry. Throws WrongFile if there are several.
  template <class T>
  const T& number(const formula::Matrix<T>& value) const {
    if (!value.is_number()) fail({}, "a number is needed here, and this is " + name_of(value));
    return value.entries[0];
  }
  /// The formula of one entry; of a number, the number.
  Formula component(std::size_t i) const;
  bool is_zero() const;

  /// Whether the formula or one of its calls has such a letter.
  bool any(const std::function<bool(const Letter&)>& is) const;

  /// A tree of formula/ in letters of these names: each letter's own, and for a quantity such as 5 cm the
  /// unit's. Throws WrongFile for calls that such trees do not have.
  formula::Tree tree(const std::function<std::string(const Letter&)>& name,
                     const std::function<std::string(const std::string& unit)>& unit_name) const;

  const Quoted& quoted() const { return text_; }
  /// Hint if a unit may have been meant as a letter of the same name: "; write 2*m for the letter".
  std::string meant() const;
  [[noreturn]] void fail(const Span& span, const std::string& reason) const;

 private:
  template <class T>
  formula::Matrix<T> evaluated(const Of<T>& of) const;
  template <class T>
  formula::Matrix<T> called(const Letter& call, const Of<T>& of) const;
  [[noreturn]] void fail(const Misfit&) const;

  const Source* source_;
  Quoted text_;
  std::optional<std::size_t> component_ = {};  ///< the entry of its value that it is
  std::vector<Letter> letters_;
  std::vector<formula::Tree> tree_;  ///< one, or none if it could not be read
};

/// A letter of a formula.
struct Letter {
  enum class Is { quantity, parameter, time, unknown, given, call };
  Is is = Is::time;
  std::size_t index = 0, order = 0;  ///< its index, and the order of its rate
  std::size_t component = 0;         ///< number in the name of an abbreviation's component; 0: all
  long double value = 0;             ///< value of a quantity such as 5 cm
  Measure measure = {};              ///< measure of a quantity such as 5 cm
  std::string function = {};         ///< name of a called function; for a quantity, another possible meaning
  std::vector<Formula> arguments = {};
  Span span = {};
  std::shared_ptr<const Table> table = {};  ///< the table that is called
};

/// An equation's two sides.
struct Equation {
  Formula left, right;
};
Equation equation(const Source&, const Quoted&, const Letters&);

}  // namespace oddity::problem
