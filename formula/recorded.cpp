#include "formula/recorded.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <regex>
#include <stdexcept>

namespace oddity::formula {

namespace {

/// Sums and products of two numbers have the same bits in either order.
bool has_same_operands(const Operation& a, const Operation& b) {
  const bool commutes = a.what == "+" || a.what == "*";
  return a.of == b.of || (commutes && a.of[0] == b.of[1] && a.of[1] == b.of[0]);
}

bool is_same(const Operation& a, const Operation& b) {
  return a.what == b.what && has_same_operands(a, b) && a.text == b.text && a.component == b.component &&
         (a.what != "number" ||
          std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value));
}

double computed(std::string_view name, const std::vector<double>& x);

std::string letter_of(const Loop& loop, std::size_t column) {
  return loop.row + "[" + std::to_string(column) + "]";
}

Record& record_of(const Recorded& a, const Recorded& b) { return *(a.record() ? a.record() : b.record()); }

Recorded of_one(std::string_view name, const Recorded& x) {
  const double value = computed(name, {x.value()});
  if (x.is_known()) return value;
  return {*x.record(), x.record()->put({name, {x.at()}, value})};
}
Recorded of_two(std::string_view name, const Recorded& x, const Recorded& y) {
  const double value = computed(name, {x.value(), y.value()});
  if (x.is_known() && y.is_known()) return value;
  Record& record = record_of(x, y);
  return {record, record.put({name, {x.in(record), y.in(record)}, value})};
}
Asked asked(std::string_view name, const Recorded& a, const Recorded& b) {
  const double yes = computed(name, {a.value(), b.value()});
  if (a.is_known() && b.is_known()) return yes != 0;
  Record& record = record_of(a, b);
  return {record, record.put({name, {a.in(record), b.in(record)}, yes})};
}

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);
const std::map<std::string_view, OfOne> of_one_number{{"negative", [](double x) { return -x; }},
                                                      {"abs", std::fabs},
                                                      {"sqrt", std::sqrt},
                                                      {"exp", std::exp},
                                                      {"expm1", std::expm1},
                                                      {"log", std::log},
                                                      {"sin", std::sin},
                                                      {"cos", std::cos},
                                                      {"tan", std::tan},
                                                      {"asin", std::asin},
                                                      {"acos", std::acos},
                                                      {"sinh", std::sinh},
                                                      {"cosh", std::cosh},
                                                      {"asinh", std::asinh}};
const std::map<std::string_view, OfTwo> of_two_numbers{
    {"+", [](double x, double y) { return x + y; }},
    {"-", [](double x, double y) { return x - y; }},
    {"*", [](double x, double y) { return x * y; }},
    {"/", [](double x, double y) { return x / y; }},
    {"<", [](double x, double y) { return x < y ? 1.0 : 0.0; }},
    {">", [](double x, double y) { return x > y ? 1.0 : 0.0; }},
    {"<=", [](double x, double y) { return x <= y ? 1.0 : 0.0; }},
    {">=", [](double x, double y) { return x >= y ? 1.0 : 0.0; }},
    {"==", [](double x, double y) { return x == y ? 1.0 : 0.0; }},
    {"atan2", std::atan2},
    {"hypot", std::hypot},
    {"copysign", std::copysign},
    {"remainder", std::remainder},
    {"pow", std::pow}};

double computed(std::string_view name, const std::vector<double>& x) {
  if (x.size() == 1) return of_one_number.at(name)(x[0]);
  return x.size() == 2 ? of_two_numbers.at(name)(x[0], x[1]) : x[0] != 0 ? x[1] : x[2];
}

}  // namespace

std::vector<double> Record::values(const Letters& letters) const {
  std::vector<double> all(operations_.size());
  evaluate(0, all.size(), letters, all);
  return all;
}

void Record::evaluate(std::size_t from, std::size_t to, const Letters& letters,
                      std::vector<double>& values) const {
  for (std::size_t at = from; at < to; ++at) {
    const Operation& operation = operations_[at];
    std::vector<double> of;
    for (const int i : operation.of) of.push_back(values[static_cast<std::size_t>(i)]);
    const auto letter = letters.find(operation.text);
    values[at] = operation.what == "sum"    ? sum(operation, letters, values)
                 : operation.what == "call" ? call(operation, letters, values)
                 : !of.empty()              ? computed(operation.what, of)
                 : letter != letters.end()  ? letter->second
                                            : operation.value;
  }
}

double Record::sum(const Operation& sum, Letters letters, std::vector<double> values) const {
  const Loop& loop = *std::ranges::find(loops_, sum.text, &Loop::row);
  const auto first = std::ranges::find(operations_, letter_of(loop, 0), &Operation::text);
  const auto from = static_cast<std::size_t>(first - operations_.begin());
  const auto term = static_cast<std::size_t>(sum.of[0]);
  double all = 0;
  for (const std::vector<double>& row : tables_[loop.table]) {
    for (std::size_t i = 0; i < row.size(); ++i) letters[letter_of(loop, i)] = row[i];
    evaluate(from, term + 1, letters, values);
    all += values[term];
  }
  return all;
}

double Record::call(const Operation& call, Letters letters, std::vector<double> values) const {
  const Function& function = *find_function(call.text);
  for (std::size_t i = 0; i < function.arguments.size(); ++i)
    letters[function.arguments[i]] = values[static_cast<std::size_t>(call.of[i])];
  const auto first = std::ranges::find(operations_, function.arguments.front(), &Operation::text);
  const auto result = static_cast<std::size_t>(function.results[call.component]);
  evaluate(static_cast<std::size_t>(first - operations_.begin()), result + 1, letters, values);
  return values[result];
}

const Function* Record::find_function(std::string_view name) const {
  const auto found = std::ranges::find(functions_, name, &Function::name);
  return found == functions_.end() ? nullptr : &*found;
}

Loop Record::loop_over(const Table& table) {
  const auto found = std::ranges::find(tables_, table);
  const Loop loop{"row" + std::to_string(loops_.size() + 1),
                  static_cast<std::size_t>(found - tables_.begin())};
  if (found == tables_.end()) tables_.push_back(table);
  loops_.push_back(loop);
  return loop;
}

std::vector<Recorded> row_letters(Record& record, const Loop& loop) {
  std::vector<Recorded> all;
  for (const double x : record.tables()[loop.table].front())
    all.push_back(Recorded::letter(record, letter_of(loop, all.size()), x));
  return all;
}

Recorded sum_of(Record& record, const Loop& loop, const Recorded& term) {
  if (term.is_known()) return term.value() * static_cast<double>(record.tables()[loop.table].size());
  Operation sum{"sum", {term.at()}, 0, loop.row};
  sum.value = record.sum(sum, {}, record.values({}));
  return {record, record.put(sum)};
}

std::string free_name(std::string name, std::set<std::string>& taken) {
  while (!taken.insert(name).second) name += '_';
  return name;
}

Record* record_of(std::span<const Recorded> numbers) {
  for (const Recorded& one : numbers)
    if (!one.is_known()) return one.record();
  return nullptr;
}

Function function_of(const Record& record, std::string_view head) {
  static const std::regex word(R"(\w+)");
  const std::string text(head);
  std::sregex_iterator found(text.begin(), text.end(), word);
  Function function{found->str(), {}};
  std::set<std::string> taken;
  for (const Operation& operation : record.operations())
    if (operation.what == "letter") taken.insert(operation.text);
  while (++found != std::sregex_iterator()) function.arguments.push_back(free_name(found->str(), taken));
  return function;
}

Recorded call_of(Record& record, const Function& function, std::span<const Recorded> arguments,
                 std::size_t component, double value) {
  Operation call{"call", {}, value, function.name, component};
  for (const Recorded& one : arguments) call.of.push_back(one.in(record));
  const double called = record.call(call, {}, record.values({}));
  if (called != value && !(std::isnan(called) && std::isnan(value)))
    throw std::logic_error("the function '" + function.name +
                           "' depends on more than its arguments and the parameters");
  return {record, record.put(call)};
}

int Record::put(Operation operation) {
  const auto found =
      std::ranges::find_if(operations_, [&](const Operation& known) { return is_same(known, operation); });
  if (found != operations_.end()) return static_cast<int>(found - operations_.begin());
  operations_.push_back(std::move(operation));
  return static_cast<int>(operations_.size()) - 1;
}

Recorded operator+(const Recorded& a, const Recorded& b) {
  if (a.is(0)) return b;
  return b.is(0) ? a : of_two("+", a, b);
}
Recorded operator-(const Recorded& a, const Recorded& b) {
  if (a.is(0)) return -b;
  return b.is(0) ? a : of_two("-", a, b);
}
Recorded operator*(const Recorded& a, const Recorded& b) {
  if (a.is(0) || b.is(1)) return a;
  if (b.is(0) || a.is(1)) return b;
  return of_two("*", a, b);
}
Recorded operator/(const Recorded& a, const Recorded& b) {
  return a.is(0) || b.is(1) ? a : of_two("/", a, b);
}
Recorded operator-(const Recorded& a) { return of_one("negative", a); }

Asked operator<(const Recorded& a, const Recorded& b) { return asked("<", a, b); }
Asked operator>(const Recorded& a, const Recorded& b) { return asked(">", a, b); }
Asked operator<=(const Recorded& a, const Recorded& b) { return asked("<=", a, b); }
Asked operator>=(const Recorded& a, const Recorded& b) { return asked(">=", a, b); }
Asked operator==(const Recorded& a, const Recorded& b) { return asked("==", a, b); }

#define ODDITY_RECORDED(f) \
  Recorded f(const Recorded& x) { return of_one(#f, x); }
ODDITY_RECORDED(abs)
ODDITY_RECORDED(sqrt)
ODDITY_RECORDED(exp)
ODDITY_RECORDED(expm1)
ODDITY_RECORDED(log)
ODDITY_RECORDED(sin)
ODDITY_RECORDED(cos)
ODDITY_RECORDED(tan)
ODDITY_RECORDED(asin)
ODDITY_RECORDED(acos)
ODDITY_RECORDED(sinh)
ODDITY_RECORDED(cosh)
ODDITY_RECORDED(asinh)
#undef ODDITY_RECORDED
#define ODDITY_RECORDED(f) \
  Recorded f(const Recorded& x, const Recorded& y) { return of_two(#f, x, y); }
ODDITY_RECORDED(atan2)
ODDITY_RECORDED(hypot)
ODDITY_RECORDED(copysign)
ODDITY_RECORDED(remainder)
ODDITY_RECORDED(pow)
#undef ODDITY_RECORDED

Recorded hypot(const Recorded& x, const Recorded& y, const Recorded& z) {
  return sqrt(x * x + y * y + z * z);
}

Recorded select(const Asked& condition, const Recorded& yes, const Recorded& no) {
  if (condition.is_known()) return static_cast<bool>(condition) ? yes : no;
  Record& record = *condition.record();
  const bool is = record.operations()[static_cast<std::size_t>(condition.at())].value != 0;
  return {
      record,
      record.put({"select", {condition.at(), yes.in(record), no.in(record)}, is ? yes.value() : no.value()})};
}

}  // namespace oddity::formula
