#pragma once

#include <cmath>
#include <concepts>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "solvers/dual.hpp"

/// Formulas as operations, each of which is computed once. Evaluating a formula (formula/) in Expression
/// records it in a graph; a program runs a graph's operations in any number type.
namespace oddity::problem {

enum class Op : unsigned char {
  input,     ///< a is its key
  constant,  //
  add,
  subtract,
  multiply,
  divide,
  square_root,
  sine,
  cosine,
  sine_and_cosine,  ///< only in a program: the cosine is in the next register
  exponential,
  logarithm,
  arc,     ///< the angle of (b, a); c is a a + b b
  choice,  ///< b if a is positive, otherwise c
};

struct Operation {
  Op op;
  int a = -1, b = -1, c = -1;
  long double value = 0;  ///< value of a constant

  /// NaN has no order among numbers.
  auto key() const { return std::tuple(op, a, b, c, value != value, value != value ? 0 : value); }
};

class Graph {
 public:
  /// Place of the operation; of the existing one if it is there already.
  int put(const Operation& operation);
  const std::vector<Operation>& operations() const { return operations_; }

 private:
  std::vector<Operation> operations_;
  std::map<decltype(Operation{}.key()), int> places_;
};

/// A place in a graph, or a number.
class Expression {
 public:
  Expression() = default;
  template <class U>
  requires std::is_arithmetic_v<U> Expression(U number) : value_(static_cast<long double>(number)) {}
  Expression(Graph& graph, int place) : graph_(&graph), place_(place) {}

  bool is_number() const { return place_ < 0; }
  long double number() const { return value_; }
  Graph* graph() const { return graph_; }
  bool is(int x) const { return is_number() && value_ == x; }
  /// x if this is 0 - x.
  std::optional<Expression> opposite() const;
  /// Its place in the graph; adds a number to the graph.
  int in(Graph& graph) const;

  friend Expression operator+(const Expression& a, const Expression& b);
  friend Expression operator-(const Expression& a, const Expression& b);
  friend Expression operator-(const Expression& a) { return Expression(0) - a; }
  friend Expression operator*(const Expression& a, const Expression& b);
  friend Expression operator/(const Expression& a, const Expression& b);
  friend Expression sqrt(const Expression& x);
  friend Expression sin(const Expression& x);
  friend Expression cos(const Expression& x);
  friend Expression exp(const Expression& x);
  friend Expression log(const Expression& x);
  friend Expression atan2(const Expression& y, const Expression& x);
  /// `yes` if the condition is positive, otherwise `no`.
  friend Expression choose_by(const Expression& condition, const Expression& yes, const Expression& no);

  friend Expression atan(const Expression& x) { return atan2(x, Expression(1)); }
  friend Expression asin(const Expression& x) { return atan2(x, sqrt(Expression(1) - x * x)); }
  friend Expression acos(const Expression& x) { return atan2(sqrt(Expression(1) - x * x), x); }
  friend Expression asinh(const Expression& x) { return log(x + sqrt(x * x + Expression(1))); }
  friend Expression acosh(const Expression& x) { return log(x + sqrt(x * x - Expression(1))); }
  friend Expression atanh(const Expression& x) {
    return log((Expression(1) + x) / (Expression(1) - x)) / Expression(2);
  }

 private:
  std::optional<Expression> antilogarithm() const;
  std::optional<Expression> power() const;
  static Expression made(Op op, const Expression& a, const Expression& b, const Expression& c);
  static Expression made(Op op, const Expression& a, const Expression& b) { return made(op, a, b, a); }
  static Expression made(Op op, const Expression& a) { return made(op, a, a, a); }

  Graph* graph_ = nullptr;
  int place_ = -1;
  long double value_ = 0;
};

Expression input(Graph& graph, int key);

inline Dual<Expression> choose_by(const Dual<Expression>& condition, const Dual<Expression>& yes,
                                  const Dual<Expression>& no) {
  return {choose_by(condition.value, yes.value, no.value), choose_by(condition.value, yes.slope, no.slope)};
}
template <class T>
requires requires(const T& x) { x > T(0.0); }
T choose_by(const T& condition, const T& yes, const T& no) { return condition > T(0.0) ? yes : no; }

/// A graph's operations that these outputs need, in their order. They are run in another order, in which
/// those of one kind follow each other. So the kind is asked once for a row of them. Its registers are the
/// constants, the inputs and then the results.
class Program {
 public:
  struct Instruction {
    Op op;
    int result, a, b, c;
  };

  Program() = default;
  /// `inputs` are keys, in the order in which run() takes them.
  Program(std::span<const Expression> outputs, std::span<const int> inputs);

  /// Computes the outputs from inputs in two parts: all but the last, and the last.
  template <class T>
  void run(const T* inputs, const T& last, T* outputs) const {
    const auto by_sign = [](const Instruction&, const T& condition, const T& yes, const T& no) -> T {
      if constexpr (requires { T(choose_by(condition, yes, no)); })
        return choose_by(condition, yes, no);
      else
        return no;
    };
    if constexpr (std::same_as<T, double> || std::same_as<T, float>) {
      constexpr std::size_t few = 192;
      if (registers_ <= few) {
        T r[few];
        return run_in(r, inputs, last, outputs, by_sign);
      }
    }
    std::vector<T> r(registers_);
    run_in(r.data(), inputs, last, outputs, by_sign);
  }
  /// As `run`, in these registers, with choices by choose(instruction, condition, yes, no).
  template <class T, class Choose>
  void run_in(T* r, const T* inputs, const T& last, T* outputs, const Choose& choose) const;

  const std::vector<Instruction>& code() const { return code_; }
  const std::vector<long double>& constants() const { return constants_; }
  const std::vector<int>& outputs() const { return outputs_; }
  std::size_t inputs() const { return inputs_; }
  std::size_t registers() const { return registers_; }
  bool has(Op op) const;
  /// Whether the output depends on the input.
  bool depends(std::size_t output, std::size_t input) const;

 private:
  std::vector<long double> constants_;
  std::vector<double> in_double_;
  std::vector<Instruction> code_;
  std::vector<Instruction> rows_ = {
      {Op::constant, 0, 0, 0, 0}};  ///< the code as run_in takes it, with an end
  std::vector<int> outputs_;        ///< registers
  std::size_t inputs_ = 0, registers_ = 0;
};

template <class T, class Choose>
void Program::run_in(T* r, const T* inputs, const T& last, T* outputs, const Choose& choose) const {
  using std::sqrt, std::sin, std::cos, std::exp, std::log, std::atan2;
  if constexpr (std::same_as<T, double>)
    for (std::size_t i = 0; i < in_double_.size(); ++i) r[i] = in_double_[i];
  else
    for (std::size_t i = 0; i < constants_.size(); ++i) {
      if constexpr (std::same_as<T, long double> || std::same_as<T, Expression>)
        r[i] = T(constants_[i]);
      else if constexpr (std::same_as<T, Dual<Expression>>)
        r[i] = T(Expression(constants_[i]));
      else
        r[i] = T(static_cast<double>(constants_[i]));
    }
  T* const first = r + constants_.size();
  for (std::size_t i = 0; i + 1 < inputs_; ++i) first[i] = inputs[i];
  first[inputs_ - 1] = last;
  const Instruction* one = rows_.data();
  const auto row = [&](const auto& does) {
    const Op op = one->op;
    do does(r[one->result], r[one->a]);
    while ((++one)->op == op);
  };
  while (one->op != Op::constant) {
    switch (one->op) {
      case Op::add:
        row([&](T& result, const T& a) { result = a + r[one->b]; });
        break;
      case Op::subtract:
        row([&](T& result, const T& a) { result = a - r[one->b]; });
        break;
      case Op::multiply:
        row([&](T& result, const T& a) { result = a * r[one->b]; });
        break;
      case Op::divide:
        row([&](T& result, const T& a) { result = a / r[one->b]; });
        break;
      case Op::square_root:
        row([&](T& result, const T& a) { result = sqrt(a); });
        break;
      case Op::sine:
        row([&](T& result, const T& a) { result = sin(a); });
        break;
      case Op::cosine:
        row([&](T& result, const T& a) { result = cos(a); });
        break;
      case Op::sine_and_cosine:
        row([&](T& result, const T& a) {
          const T cosine = cos(a), sine = sin(a);  // by one call, where the compiler knows one
          result = sine;
          r[one->result + 1] = cosine;
        });
        break;
      case Op::exponential:
        row([&](T& result, const T& a) { result = exp(a); });
        break;
      case Op::logarithm:
        row([&]([[maybe_unused]] T& result, const T& a) {
          if constexpr (requires { T(log(a)); }) result = log(a);
        });
        break;
      case Op::arc:
        row([&]([[maybe_unused]] T& result, const T& a) {
          if constexpr (requires { T(atan2(a, a)); }) result = atan2(a, r[one->b]);
        });
        break;
      case Op::choice:
        row([&](T& result, const T& a) { result = choose(*one, a, r[one->b], r[one->c]); });
        break;
      case Op::input:
      case Op::constant:
        ++one;
        break;
    }
  }
  for (std::size_t i = 0; i < outputs_.size(); ++i) outputs[i] = r[outputs_[i]];
}

/// Replaces inputs of the outputs, given by key, with other expressions.
std::vector<Expression> replaced(std::span<const Expression> outputs,
                                 const std::map<int, Expression>& inputs);

/// Rates of the outputs for these rates of the inputs, by key; an input without one is constant.
std::vector<Expression> slopes(std::span<const Expression> outputs, const std::map<int, Expression>& along);

/// Keys of the inputs that the outputs need.
std::vector<int> keys_of(std::span<const Expression> outputs);

}  // namespace oddity::problem
