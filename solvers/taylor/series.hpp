#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "solvers/taylor/coefficients.hpp"
#include "solvers/taylor/tape.hpp"

/// The Taylor series of a motion, from a recorded right-hand side.
namespace oddity::taylor {

/// Costs of operations in additions: the weights of the Livermore loops [McMahon, UCRL-53745, 1986].
struct Weights {
  static constexpr long addition = 1, multiplication = 1, division = 4, root = 4, function = 8;
};

inline constexpr int most_orders = 32;

/// Cost of an operation written by hand, and cost of its coefficient k.
constexpr long by_hand(const Node& node) {
  const auto times = [](double scale) { return scale == 1 || scale == -1 ? 0 : Weights::multiplication; };
  switch (node.operation) {
    case Operation::linear:
      return times(node.alpha) + (node.b >= 0 ? times(node.beta) + Weights::addition : 0) +
             (node.gamma != 0 ? Weights::addition : 0);
    case Operation::multiply:
      return Weights::multiplication;
    case Operation::divide:
      return Weights::division;
    case Operation::inverse_cube:
      return Weights::division + Weights::multiplication + Weights::root;
    case Operation::square_root:
      return Weights::root;
    case Operation::sine:
    case Operation::cosine:
    case Operation::exponential:
      return Weights::function;
    case Operation::turning:
    case Operation::unknown:
      break;
  }
  return 0;
}
constexpr long cost_of(const Node& node, int k) {
  const long inside = 2 * (k - 1) - 1, square = k == 2 ? 1 : k - k % 2;
  switch (node.operation) {
    case Operation::linear:
      return by_hand(node) - (k > 0 && node.gamma != 0 ? Weights::addition : 0);
    case Operation::multiply:
      if (k == 0) return Weights::multiplication;
      if (node.a == node.b) return k == 1 ? 2 : 3 + square;
      return k == 1 ? 3 : 4 + inside;
    case Operation::divide:
      if (k == 0) return Weights::division + Weights::multiplication;
      return (node.a >= 0) + (k == 1 ? 2 : 3 + inside);
    case Operation::inverse_cube:
      return k == 0 ? by_hand(node) + Weights::division : 3L * k;
    case Operation::square_root:
      if (k == 0) return Weights::root + Weights::division;
      return k == 1 ? 1 : 2 + square;
    case Operation::sine:
      if (k == 0) return 2 * Weights::function;
      return 1 + 2 * (k == 1 ? 2 : 3 + inside);
    case Operation::turning:
      return k == 0 ? Weights::multiplication + Weights::addition + 2 * Weights::function
                    : 4 * Weights::multiplication;
    case Operation::exponential:
      if (k == 0) return Weights::function;
      return 1 + (k == 1 ? 2 : 3 + inside);
    case Operation::unknown:
    case Operation::cosine:
      break;
  }
  return 0;
}

/// A product, or two at once of interleaved rows: with two other such rows, or with a single row.
enum class Products { one, of_both, of_first_with_both, of_both_with_second };

/// The needed operations of a recording, in the order of computation.
class Program {
 public:
  explicit Program(const Recording&);

  std::size_t unknowns() const { return derivatives_.size(); }
  /// Cost of the right-hand side written by hand, without repeated operations and constants.
  long cost_by_hand() const { return by_hand_; }
  /// Cost of the series up to an order.
  long cost(int order) const;
  /// Cost of getting from operation to operation, in additions as well. Used only for the choice of the
  /// order.
  long overhead(int order) const { return 20L * order * operations_; }

 private:
  friend class Series;
  struct Instruction {
    Node node;
    int result, second = -1, spare = -1;  ///< rows
    Products products = Products::one;
    bool is_doubled = false;  ///< the row next to the result has the same coefficients
  };
  /// An unknown's derivative: a multiple of a row, or else a constant.
  struct Derivative {
    int row;
    double factor, constant;
  };

  struct Making;
  int two_rows();
  void put_sine_and_cosine(Making&, std::size_t i);
  void put_one(Making&, std::size_t i);
  bool put_two(Making&, std::size_t i);
  void count(const Node& node);

  std::vector<Instruction> instructions_;  ///< operands of their nodes are rows
  std::vector<Derivative> derivatives_;
  /// Operations of one kind have equal costs, except linear ones.
  static constexpr std::size_t kinds = 9;
  std::array<long, kinds> of_kind_{};
  long linear_at_0_ = 0, linear_later_ = 0;  ///< costs of linear operations
  long operations_ = 0;
  int rows_ = 0;  ///< the first are the unknowns', the next is the time's
  long by_hand_ = 0;
};

/// Source of the newest coefficient of an operand, or of two: its row, or the value handed over by the step
/// before, which arrives sooner.
enum class From { row, first, second, both };

/// By k, the factor from a derivative's coefficient k to its unknown's coefficient k + 1; for two unknowns.
using Shares = std::array<Two, most_orders>;

/// An operation, or the next coefficients of unknowns from their derivatives. Each kernel calls that of the
/// next step.
struct Step {
  using Kernel = void (*)(const Step&, Two newest);

  const Kernel* kernels = nullptr;  ///< by k
  Rows<double> rows = {};
  Row<double> unknown =
      {};  ///< its derivative is a multiple of the result; with two results, the first of two unknowns
  const Two* shares = nullptr;  ///< from the result's coefficients to the unknown's next ones, by k
  Row<double> sum = {};         ///< sum of two results, or none
  From a = From::row, b = From::row;
  bool is_doubled = false;
  Node node = {};
};

/// The series of a motion about one of its points. All coefficients are in one block of memory.
class Series {
 public:
  explicit Series(Program program);
  Series(const Series&) = delete;
  Series(Series&&) = default;

  const Program& program() const { return program_; }
  /// Computes the coefficients of x up to `order` about the state x at t.
  void expand(const double* x, double t, int order);
  int order() const { return order_; }
  double time() const { return row(static_cast<int>(program_.unknowns()))[0]; }
  double coefficient(std::size_t unknown, int k) const { return row(static_cast<int>(unknown))[k]; }
  /// Whether the state and the last coefficients are finite.
  bool is_finite() const;
  /// The largest coefficient of order k, each multiplied by its unknown's scale.
  double largest(int k, const double* scale) const {
    double most = 0;
    for (std::size_t i = 0, n = program_.unknowns(); i < n; i += 2) {
      const Two c = both(i)[k];
      most = std::max(most, scale[i] * std::abs(c[0]));
      if (i + 1 < n) most = std::max(most, scale[i + 1] * std::abs(c[1]));
    }
    return most;
  }
  /// The state after h.
  void at(double h, double* x) const;

 private:
  /// Size of two interleaved rows.
  static constexpr std::size_t stride = 2UL * (most_orders + 1);

  struct Making;

  static std::size_t start(int row) {
    const auto i = static_cast<std::size_t>(row);
    return i / 2 * stride + i % 2;
  }
  Row<double> row(int i) { return Row<double>::from(memory_.get() + start(i)); }
  Row<const double> row(int i) const { return Row<const double>::from(memory_.get() + start(i)); }
  /// Rows of an unknown and of the next one, or of the time.
  Pairs<const double> both(std::size_t i) const {
    return Pairs<const double>::from(memory_.get() + i / 2 * stride);
  }

  Program program_;
  std::vector<Step> steps_;
  std::vector<Shares> shares_;  ///< for derivatives that are multiples
  int order_ = 0;
  /// Only the time's row is initialized; other rows are written before they are read.
  std::unique_ptr<double[]> memory_;
};

}  // namespace oddity::taylor
