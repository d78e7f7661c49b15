#include "problem/expression.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <utility>

#include "formula/evaluate.hpp"

namespace oddity::problem {

int Graph::put(const Operation& operation) {
  const auto [found, is_new] = places_.emplace(operation.key(), static_cast<int>(operations_.size()));
  if (is_new) operations_.push_back(operation);
  return found->second;
}

int Expression::in(Graph& graph) const {
  return is_number() ? graph.put({Op::constant, -1, -1, -1, value_}) : place_;
}

Expression Expression::made(Op op, const Expression& a, const Expression& b, const Expression& c) {
  Graph* graph = a.graph_ ? a.graph_ : b.graph_ ? b.graph_ : c.graph_;
  const int operands = op == Op::choice || op == Op::arc ? 3 : op >= Op::add && op <= Op::divide ? 2 : 1;
  Operation operation{op, a.in(*graph)};
  if (operands > 1) operation.b = b.in(*graph);
  if (operands > 2) operation.c = c.in(*graph);
  if ((op == Op::add || op == Op::multiply) && operation.b < operation.a) std::swap(operation.a, operation.b);
  return {*graph, graph->put(operation)};
}

std::optional<Expression> Expression::opposite() const {
  if (is_number()) return {};
  const auto& all = graph_->operations();
  const Operation& one = all[static_cast<std::size_t>(place_)];
  if (one.op != Op::subtract) return {};
  const Operation& from = all[static_cast<std::size_t>(one.a)];
  return from.op == Op::constant && from.value == 0 ? std::optional(Expression(*graph_, one.b))
                                                    : std::nullopt;
}

Expression operator+(const Expression& a, const Expression& b) {
  if (a.is_number() && b.is_number()) return a.value_ + b.value_;
  if (const auto x = b.opposite()) return a - *x;
  if (const auto x = a.opposite()) return b - *x;
  if (a.is(0)) return b;
  return b.is(0) ? a : Expression::made(Op::add, a, b);
}
Expression operator-(const Expression& a, const Expression& b) {
  if (a.is_number() && b.is_number()) return a.value_ - b.value_;
  if (!a.is_number() && !b.is_number() && a.place_ == b.place_) return 0;
  if (const auto x = b.opposite()) return a + *x;
  return b.is(0) ? a : Expression::made(Op::subtract, a, b);
}
Expression operator*(const Expression& a, const Expression& b) {
  if (a.is_number() && b.is_number()) return a.value_ * b.value_;
  if (a.is(0) || b.is(0)) return 0;
  if (a.is(1)) return b;
  if (a.is(-1)) return -b;
  if (b.is(-1)) return -a;
  return b.is(1) ? a : Expression::made(Op::multiply, a, b);
}
Expression operator/(const Expression& a, const Expression& b) {
  if (a.is_number() && b.is_number()) return a.value_ / b.value_;
  if (a.is(0) || b.is(1)) return a;
  return Expression::made(Op::divide, a, b);
}
Expression sqrt(const Expression& x) {
  return x.is_number() ? Expression(std::sqrt(x.value_)) : Expression::made(Op::square_root, x);
}
Expression sin(const Expression& x) {
  return x.is_number() ? Expression(std::sin(x.value_)) : Expression::made(Op::sine, x);
}
Expression cos(const Expression& x) {
  return x.is_number() ? Expression(std::cos(x.value_)) : Expression::made(Op::cosine, x);
}
/// a if x is the logarithm of a.
std::optional<Expression> Expression::antilogarithm() const {
  if (is_number()) return {};
  const Operation& one = graph_->operations()[static_cast<std::size_t>(place_)];
  return one.op == Op::logarithm ? std::optional(Expression(*graph_, one.a)) : std::nullopt;
}
/// A power with a whole or half exponent, by products and a root. It then has its Taylor series and, if the
/// exponent is whole, values for negative numbers.
std::optional<Expression> Expression::power() const {
  if (is_number()) return {};
  const Operation& one = graph_->operations()[static_cast<std::size_t>(place_)];
  if (one.op != Op::multiply) return {};
  for (const auto& [number, of] : {std::pair(one.a, one.b), std::pair(one.b, one.a)}) {
    const Operation& factor = graph_->operations()[static_cast<std::size_t>(number)];
    const auto a = Expression(*graph_, of).antilogarithm();
    if (factor.op != Op::constant || !a || std::abs(factor.value) > 32 ||
        2 * factor.value != std::floor(2 * factor.value))
      continue;
    const int whole = static_cast<int>(std::floor(std::abs(factor.value)));
    Expression all = formula::detail::whole_power(*a, whole);
    if (static_cast<long double>(whole) != std::abs(factor.value)) all = all * sqrt(*a);
    return factor.value < 0 ? Expression(1) / all : all;
  }
  return {};
}
Expression exp(const Expression& x) {
  if (const auto power = x.power()) return *power;
  return x.is_number() ? Expression(std::exp(x.value_)) : Expression::made(Op::exponential, x);
}
Expression log(const Expression& x) {
  return x.is_number() ? Expression(std::log(x.value_)) : Expression::made(Op::logarithm, x);
}
Expression atan2(const Expression& y, const Expression& x) {
  if (y.is_number() && x.is_number()) return std::atan2(y.value_, x.value_);
  return Expression::made(Op::arc, y, x, y * y + x * x);
}
Expression choose_by(const Expression& condition, const Expression& yes, const Expression& no) {
  if (condition.is_number()) return condition.value_ > 0 ? yes : no;
  if (yes.is_number() && no.is_number() && yes.value_ == no.value_) return yes;
  return Expression::made(Op::choice, condition, yes, no);
}

Expression input(Graph& graph, int key) { return {graph, graph.put({Op::input, key})}; }

namespace {

Graph* graph_of(std::span<const Expression> all, std::vector<int>& places) {
  // Numbers without another graph go into a graph for numbers.
  static thread_local Graph numbers;
  Graph* graph = &numbers;
  for (const Expression& one : all)
    if (Graph* its = one.graph()) graph = its;
  for (const Expression& one : all) places.push_back(one.in(*graph));
  return graph;
}

int operands_of(const Operation& one) {
  switch (one.op) {
    case Op::input:
    case Op::constant:
      return 0;
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
      return 2;
    case Op::arc:
    case Op::choice:
      return 3;
    default:
      return 1;
  }
}

/// Marks the operations that the places need. Operations of a graph come after their operands.
std::vector<bool> needed(const Graph& graph, const std::vector<int>& places) {
  std::vector<bool> all(graph.operations().size(), false);
  for (const int place : places) all[static_cast<std::size_t>(place)] = true;
  for (std::size_t i = all.size(); i-- > 0;) {
    const Operation& one = graph.operations()[i];
    const int operands[]{one.a, one.b, one.c};
    for (int k = 0; all[i] && k < operands_of(one); ++k) all[static_cast<std::size_t>(operands[k])] = true;
  }
  return all;
}

/// The registers that it reads; of a function of one number the same thrice.
std::array<int, 3> operands_of(const Program::Instruction& one) {
  const bool three = one.op == Op::arc || one.op == Op::choice;
  const bool two = three || (one.op >= Op::add && one.op <= Op::divide);
  return {one.a, two ? one.b : one.a, three ? one.c : one.a};
}

/// Sorts the code into rows: next come all instructions of the kind of which most can be computed.
std::vector<Program::Instruction> in_rows(const std::vector<Program::Instruction>& code,
                                          std::size_t registers) {
  constexpr int none = -1;
  std::vector<int> made_by(registers, none), waits_for(code.size(), 0);
  std::vector<std::vector<std::size_t>> wanted_by(code.size());
  std::map<Op, std::vector<std::size_t>> ready;
  for (std::size_t i = 0; i < code.size(); ++i) {
    for (const int from : operands_of(code[i]))
      if (const int producer = made_by[static_cast<std::size_t>(from)]; producer != none)
        ++waits_for[i], wanted_by[static_cast<std::size_t>(producer)].push_back(i);
    if (waits_for[i] == 0) ready[code[i].op].push_back(i);
    const auto result = static_cast<std::size_t>(code[i].result);
    made_by[result] = static_cast<int>(i);
    if (code[i].op == Op::sine_and_cosine) made_by[result + 1] = static_cast<int>(i);
  }
  std::vector<Program::Instruction> rows;
  while (rows.size() < code.size()) {
    const auto most = std::max_element(ready.begin(), ready.end(), [](const auto& a, const auto& b) {
      return a.second.size() < b.second.size();
    });
    for (const std::size_t i : std::exchange(most->second, {})) {
      rows.push_back(code[i]);
      for (const std::size_t user : wanted_by[i])
        if (--waits_for[user] == 0) ready[code[user].op].push_back(user);
    }
  }
  rows.push_back({Op::constant, 0, 0, 0, 0});
  return rows;
}

}  // namespace

Program::Program(std::span<const Expression> outputs, std::span<const int> inputs) : inputs_(inputs.size()) {
  std::vector<int> places;
  const Graph& graph = *graph_of(outputs, places);
  const auto& operations = graph.operations();
  const std::vector<bool> is_needed = needed(graph, places);
  std::vector<int> registers(operations.size(), -1);
  for (std::size_t i = 0; i < operations.size(); ++i)
    if (is_needed[i] && operations[i].op == Op::constant) {
      registers[i] = static_cast<int>(constants_.size());
      constants_.push_back(operations[i].value);
    }
  in_double_.assign(constants_.begin(), constants_.end());
  int next = static_cast<int>(constants_.size() + inputs_);
  std::map<int, int> sines;  // argument to place of its sine, for a cosine of the same argument
  for (std::size_t i = 0; i < operations.size(); ++i) {
    const Operation& one = operations[i];
    if (!is_needed[i] || one.op == Op::constant) continue;
    if (one.op == Op::input) {
      const auto found = std::ranges::find(inputs, one.a);
      if (found == inputs.end()) throw std::logic_error("a program lacks an input");
      registers[i] = static_cast<int>(constants_.size()) + static_cast<int>(found - inputs.begin());
      continue;
    }
    const auto in = [&](int operand) {
      return operand < 0 ? 0 : registers[static_cast<std::size_t>(operand)];
    };
    if (one.op == Op::sine || one.op == Op::cosine) {
      const auto [found, is_new] = sines.emplace(one.a, next);
      if (is_new) {
        code_.push_back({Op::sine_and_cosine, next, in(one.a), 0, 0});
        next += 2;
      }
      registers[i] = found->second + (one.op == Op::cosine ? 1 : 0);
      continue;
    }
    registers[i] = next;
    code_.push_back({one.op, next++, in(one.a), in(one.b), in(one.c)});
  }
  for (const int place : places) outputs_.push_back(registers[static_cast<std::size_t>(place)]);
  registers_ = static_cast<std::size_t>(next) + 1;
  rows_ = in_rows(code_, registers_);
}

bool Program::has(Op op) const {
  return std::ranges::any_of(code_, [&](const Instruction& one) { return one.op == op; });
}

bool Program::depends(std::size_t output, std::size_t input) const {
  std::vector<bool> is(registers_, false);
  is[constants_.size() + input] = true;
  for (const Instruction& one : code_) {
    bool does = false;
    for (const int from : operands_of(one)) does = does || is[static_cast<std::size_t>(from)];
    is[static_cast<std::size_t>(one.result)] = does;
    if (one.op == Op::sine_and_cosine) is[static_cast<std::size_t>(one.result) + 1] = does;
  }
  return is[static_cast<std::size_t>(outputs_[output])];
}

std::vector<int> keys_of(std::span<const Expression> outputs) {
  std::vector<int> places, keys;
  const Graph& graph = *graph_of(outputs, places);
  const std::vector<bool> is_needed = needed(graph, places);
  for (std::size_t i = 0; i < is_needed.size(); ++i)
    if (is_needed[i] && graph.operations()[i].op == Op::input) keys.push_back(graph.operations()[i].a);
  return keys;
}

namespace {

template <class T>
std::vector<T> run_again(std::span<const Expression> outputs, const std::vector<int>& keys,
                         const std::vector<T>& values) {
  std::vector<T> results(outputs.size());
  Program(outputs, keys).run(values.data(), values.back(), results.data());
  return results;
}

/// The graph of these expressions, in which inputs can be made.
Graph* graph_of(std::span<const Expression> all) {
  std::vector<int> places;
  return graph_of(all, places);
}

}  // namespace

std::vector<Expression> replaced(std::span<const Expression> outputs,
                                 const std::map<int, Expression>& inputs) {
  std::vector<int> keys = keys_of(outputs);
  if (keys.empty()) return {outputs.begin(), outputs.end()};
  std::vector<Expression> values;
  Graph* graph = graph_of(outputs);
  for (const int key : keys) {
    const auto found = inputs.find(key);
    values.push_back(found == inputs.end() ? input(*graph, key) : found->second);
  }
  return run_again(outputs, keys, values);
}

std::vector<Expression> slopes(std::span<const Expression> outputs, const std::map<int, Expression>& along) {
  std::vector<int> keys = keys_of(outputs);
  std::vector<Expression> all(outputs.size());
  if (keys.empty()) return all;
  Graph* graph = graph_of(outputs);
  std::vector<Dual<Expression>> values;
  for (const int key : keys) {
    const auto found = along.find(key);
    values.emplace_back(input(*graph, key), found == along.end() ? Expression(0) : found->second);
  }
  const auto both = run_again(outputs, keys, values);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = both[i].slope;
  return all;
}

}  // namespace oddity::problem
