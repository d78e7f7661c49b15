#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Numbers that record the operations on them, to be printed as a program (program.hpp).
namespace oddity::formula {

/// One operation: "+", "sin", "<", "select"; "letter", whose name is its text; "number"; "sum" of the term
/// before it, over the rows of the loop that its text names. Also "call": its text names the function.
struct Operation {
  std::string_view what;
  std::vector<int> of = {};  ///< the operations before it that it takes
  double value = 0;          ///< for the letters' values
  std::string text = {};
  std::size_t component = 0;  ///< the result of a call
};

/// A loop over the rows of a table. The terms of its sums have the row's numbers as letters: "row[0]".
struct Loop {
  std::string row;
  std::size_t table;
};
using Table = std::vector<std::vector<double>>;

/// A function that is recorded once and called by operations after it.
struct Function {
  std::string name;
  std::vector<std::string> arguments;  ///< letters, which nothing else has
  std::vector<int> results = {};       ///< operations
};

/// Operations in their order, each that is repeated once.
class Record {
 public:
  using Letters = std::map<std::string, double>;

  int put(Operation operation);
  /// Begins a loop whose row has the next name.
  Loop loop_over(const Table&);
  const std::vector<Loop>& loops() const { return loops_; }
  const std::vector<Table>& tables() const { return tables_; }
  void add(Function function) { functions_.push_back(std::move(function)); }
  /// Null if no function has this name.
  const Function* find_function(std::string_view name) const;
  /// In their order: each calls only those before it.
  const std::vector<Function>& functions() const { return functions_; }
  const std::vector<Operation>& operations() const { return operations_; }
  /// Their values for other values of these letters.
  std::vector<double> values(const Letters&) const;
  /// That of a sum or a call, where those of all operations are known.
  double sum(const Operation&, Letters, std::vector<double> values) const;
  double call(const Operation&, Letters, std::vector<double> values) const;
  /// A condition was asked for its truth: other values of the letters may go another way.
  bool has_branched = false;

 private:
  void evaluate(std::size_t from, std::size_t to, const Letters&, std::vector<double>& values) const;

  std::vector<Operation> operations_;
  std::vector<Loop> loops_;
  std::vector<Table> tables_;
  std::vector<Function> functions_;
};

/// A condition: known, or an operation.
class Asked {
 public:
  Asked(bool yes) : yes_(yes) {}
  Asked(Record& record, int at) : record_(&record), at_(at), yes_(record.operations()[index()].value != 0) {}

  bool is_known() const { return record_ == nullptr; }
  Record* record() const { return record_; }
  int at() const { return at_; }
  explicit operator bool() const {
    if (record_) record_->has_branched = true;
    return yes_;
  }
  friend bool any_of(const Asked& a) { return static_cast<bool>(a); }

 private:
  std::size_t index() const { return static_cast<std::size_t>(at_); }

  Record* record_ = nullptr;
  int at_ = -1;
  bool yes_;
};

/// A number: known, or an operation.
class Recorded {
 public:
  Recorded() = default;
  template <class A>
  requires(std::is_arithmetic_v<A>) Recorded(A value) : value_(static_cast<double>(value)) {}
  Recorded(Record& record, int at)
      : record_(&record), at_(at), value_(record.operations()[static_cast<std::size_t>(at)].value) {}
  static Recorded letter(Record& record, const std::string& name, double value) {
    return {record, record.put({"letter", {}, value, name})};
  }

  bool is_known() const { return record_ == nullptr; }
  Record* record() const { return record_; }
  double value() const { return value_; }
  int at() const { return at_; }
  /// Its operation in a record, into which a known number is put.
  int in(Record& record) const { return is_known() ? record.put({"number", {}, value_}) : at_; }

  friend Recorded operator+(const Recorded& a, const Recorded& b);
  friend Recorded operator-(const Recorded& a, const Recorded& b);
  friend Recorded operator*(const Recorded& a, const Recorded& b);
  friend Recorded operator/(const Recorded& a, const Recorded& b);
  friend Recorded operator-(const Recorded& a);
  friend Recorded operator+(const Recorded& a) { return a; }
  Recorded& operator+=(const Recorded& b) { return *this = *this + b; }
  Recorded& operator-=(const Recorded& b) { return *this = *this - b; }
  Recorded& operator*=(const Recorded& b) { return *this = *this * b; }
  Recorded& operator/=(const Recorded& b) { return *this = *this / b; }

  friend Asked operator<(const Recorded& a, const Recorded& b);
  friend Asked operator>(const Recorded& a, const Recorded& b);
  friend Asked operator<=(const Recorded& a, const Recorded& b);
  friend Asked operator>=(const Recorded& a, const Recorded& b);
  friend Asked operator==(const Recorded& a, const Recorded& b);

 private:
  bool is(double x) const { return is_known() && value_ == x; }

  Record* record_ = nullptr;
  int at_ = -1;
  double value_ = 0;
};

Recorded abs(const Recorded&);
Recorded sqrt(const Recorded&);
Recorded exp(const Recorded&);
Recorded expm1(const Recorded&);
Recorded log(const Recorded&);
Recorded sin(const Recorded&);
Recorded cos(const Recorded&);
Recorded tan(const Recorded&);
Recorded asin(const Recorded&);
Recorded acos(const Recorded&);
Recorded sinh(const Recorded&);
Recorded cosh(const Recorded&);
Recorded asinh(const Recorded&);
Recorded atan2(const Recorded& y, const Recorded& x);
Recorded hypot(const Recorded& x, const Recorded& y);
Recorded hypot(const Recorded& x, const Recorded& y, const Recorded& z);
Recorded copysign(const Recorded& size, const Recorded& sign);
Recorded remainder(const Recorded& x, const Recorded& y);
Recorded pow(const Recorded& x, const Recorded& y);
Recorded select(const Asked& condition, const Recorded& yes, const Recorded& no);

/// The letters of a loop's row, and the sum of a term that was made of them.
std::vector<Recorded> row_letters(Record&, const Loop&);
Recorded sum_of(Record&, const Loop&, const Recorded& term);

/// The sum of term(row) over a table's rows, component by component: a loop of the record that `any` is in.
template <std::size_t columns, std::size_t rows, class Term>
auto sum_over(const Recorded& any, const std::array<std::array<double, columns>, rows>& table,
              const Term& term) {
  const auto term_of = [&](const auto& numbers) {
    std::array<Recorded, columns> row;
    std::ranges::copy(numbers, row.begin());
    return term(row);
  };
  if (any.is_known()) {
    auto sum = term_of(table[0]);
    for (std::size_t i = 1; i < rows; ++i)
      std::ranges::transform(sum, term_of(table[i]), sum.begin(), std::plus<>());
    return sum;
  }
  Table numbers;
  for (const auto& row : table) numbers.emplace_back(row.begin(), row.end());
  const Loop loop = any.record()->loop_over(numbers);
  auto sum = term_of(row_letters(*any.record(), loop));
  for (Recorded& one : sum) one = sum_of(*any.record(), loop, one);
  return sum;
}

/// The name, with a suffix where it is taken. Takes it.
std::string free_name(std::string name, std::set<std::string>& taken);

/// The record of any of these numbers; null if all are known.
Record* record_of(std::span<const Recorded>);
/// The function with this head: "friction(u, v, w)". Its letters get suffixes where the record has them.
Function function_of(const Record&, std::string_view head);
/// A component of the function's results for these arguments, whose value must be the one given.
Recorded call_of(Record&, const Function&, std::span<const Recorded> arguments, std::size_t component,
                 double value);

/// f(arguments) as calls of a function of the record.
template <std::size_t n, class F>
auto as_function(const char* head, const std::array<Recorded, n>& arguments, const F& f) {
  Record* const record = record_of(arguments);
  if (!record) return f(arguments);
  Function function = function_of(*record, head);
  if (!record->find_function(function.name)) {
    std::array<Recorded, n> letters;
    for (std::size_t i = 0; i < n; ++i)
      letters[i] = Recorded::letter(*record, function.arguments.at(i), arguments[i].value());
    for (const Recorded& result : f(letters)) function.results.push_back(result.in(*record));
    record->add(function);
  }
  const Record before = *record;
  auto results = f(arguments);
  *record = before;
  for (std::size_t i = 0; i < results.size(); ++i)
    results[i] = call_of(*record, *record->find_function(function.name), arguments, i, results[i].value());
  return results;
}

}  // namespace oddity::formula
