#include "solvers/taylor/series.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace oddity::taylor {

namespace {

int row_of(int node, const std::vector<int>& rows) {
  return node < 0 ? -1 : rows[static_cast<std::size_t>(node)];
}
Node in_rows(Node node, const std::vector<int>& rows) {
  node.a = row_of(node.a, rows);
  node.b = row_of(node.b, rows);
  return node;
}

/// Whether the two rows are interleaved, in this order.
bool beside(int row, int next) { return row >= 0 && row % 2 == 0 && next == row + 1; }

/// How two products can be computed together; `one` if they cannot.
Products at_once(const Node& x, const Node& y) {
  if (y.a < 0 || y.b < 0 || (x.a == x.b) != (y.a == y.b)) return Products::one;
  if (beside(x.a, y.a) && beside(x.b, y.b)) return Products::of_both;
  if (x.a == y.a && beside(x.b, y.b)) return Products::of_first_with_both;
  if (x.b == y.b && beside(x.a, y.a)) return Products::of_both_with_second;
  return Products::one;
}

/// The recording's nodes, with `turning` in place of each sine of a linear function of time. Time is the node
/// after the unknowns.
std::vector<Node> with_turning(const Recording& recording) {
  std::vector<Node> nodes = recording.tape.nodes();
  const auto time = static_cast<int>(recording.derivatives.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].operation != Operation::sine) continue;
    const Node angle = nodes[static_cast<std::size_t>(nodes[i].a)];
    const bool is_time = nodes[i].a == time;
    if (!is_time && (angle.operation != Operation::linear || angle.a != time || angle.b >= 0)) continue;
    nodes[i] = {Operation::turning, time, -1, is_time ? 1 : angle.alpha, 0, is_time ? 0 : angle.gamma};
    nodes[i + 1].a = time;  // its cosine
  }
  return nodes;
}
bool is_sine(const Node& node) {
  return node.operation == Operation::sine || node.operation == Operation::turning;
}

/// The nodes that the derivatives need.
std::vector<bool> needed_of(const Recording& recording, const std::vector<Node>& nodes) {
  std::vector<bool> all(nodes.size());
  const auto need = [&](int node) {
    if (node >= 0) all[static_cast<std::size_t>(node)] = true;
  };
  for (const Recorded& derivative : recording.derivatives) need(derivative.node());
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (all[i]) need(nodes[i].a), need(nodes[i].b);
  return all;
}

/// Cost of the right-hand side written by hand, without repeated operations and constants.
long cost_of_all_by_hand(const Recording& recording) {
  const std::vector<Node>& nodes = recording.tape.nodes();
  const std::vector<bool> needed = needed_of(recording, nodes);
  long sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (needed[i]) sum += by_hand(nodes[i]);
  for (const Recorded& derivative : recording.derivatives)
    if (derivative.node() >= 0 && std::abs(derivative.factor()) != 1) sum += Weights::multiplication;
  return std::max(sum, 1L);
}

/// The nodes that are factors of several products.
std::vector<bool> factors_of(const std::vector<Node>& nodes, const std::vector<bool>& needed) {
  std::vector<int> products(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (needed[i] && nodes[i].operation == Operation::multiply)
      for (int factor : {nodes[i].a, nodes[i].b}) ++products[static_cast<std::size_t>(factor)];
  std::vector<bool> all(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) all[i] = products[i] >= 2;
  return all;
}

/// One operation of each kind, and its total cost below each order.
constexpr std::array<Node, 9> one_of_kind{{{Operation::multiply, 0, 1},
                                           {Operation::multiply, 0, 0},
                                           {Operation::divide, 0, 1},
                                           {Operation::divide, -1, 1},
                                           {Operation::inverse_cube},
                                           {Operation::square_root},
                                           {Operation::sine},
                                           {Operation::turning},
                                           {Operation::exponential}}};
constexpr auto costs_of_kind = [] {
  std::array<std::array<long, most_orders + 1>, one_of_kind.size()> all{};
  for (std::size_t kind = 0; kind < all.size(); ++kind)
    for (int k = 0; k < most_orders; ++k) {
      const auto order = static_cast<std::size_t>(k);
      all[kind][order + 1] = all[kind][order] + cost_of(one_of_kind[kind], k);
    }
  return all;
}();

std::size_t kind_of(const Node& node) {
  const auto same = std::ranges::find_if(one_of_kind, [&](const Node& one) {
    return one.operation == node.operation &&
           (one.operation != Operation::multiply || (one.a == one.b) == (node.a == node.b)) &&
           (one.operation != Operation::divide || (one.a < 0) == (node.a < 0));
  });
  return static_cast<std::size_t>(same - one_of_kind.begin());
}

}  // namespace

/// A program under construction from a recording.
struct Program::Making {
  const std::vector<Node>& nodes;
  std::vector<bool> needed, factors;
  std::vector<int> rows;             ///< row of each finished node; else -1
  std::vector<bool> doubled_rows{};  ///< may be shorter than the number of rows

  bool is_doubled(int row) const {
    const auto i = static_cast<std::size_t>(row);
    return i < doubled_rows.size() && doubled_rows[i];
  }
};

Program::Program(const Recording& recording) {
  const std::vector<Node> nodes = with_turning(recording);
  std::vector<bool> all = needed_of(recording, nodes);
  std::vector<bool> factors = factors_of(nodes, all);
  Making making{nodes, std::move(all), std::move(factors), std::vector<int>(nodes.size(), -1)};
  const std::vector<bool>& needed = making.needed;
  instructions_.reserve(nodes.size());
  derivatives_.reserve(recording.derivatives.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    const bool for_cosine = is_sine(node) && needed[i + 1];
    if (making.rows[i] >= 0 || (node.operation != Operation::unknown && !needed[i] && !for_cosine)) continue;
    if (node.operation == Operation::unknown)
      making.rows[i] = rows_++;
    else if (is_sine(node))
      put_sine_and_cosine(making, i);
    else if (node.operation != Operation::multiply || !put_two(making, i))
      put_one(making, i);
  }
  by_hand_ = cost_of_all_by_hand(recording);
  for (const Recorded& derivative : recording.derivatives)
    derivatives_.push_back({row_of(derivative.node(), making.rows), derivative.factor(), derivative.term()});
  for (const Instruction& instruction : instructions_)
    for (int i = 0; i < (instruction.products == Products::one ? 1 : 2); ++i) count(instruction.node);
}

/// Adds two interleaved rows and returns the first.
int Program::two_rows() {
  rows_ += rows_ % 2;
  return std::exchange(rows_, rows_ + 2);
}

void Program::put_sine_and_cosine(Making& making, std::size_t i) {
  const int both = two_rows();
  instructions_.push_back({.node = in_rows(making.nodes[i], making.rows),
                           .result = both,
                           .second = both + 1,
                           .spare = two_rows()});
  making.rows[i] = both;
  making.rows[i + 1] = both + 1;
}

/// Adds an operation with its own row, filled twice if it is multiplied with pairs.
void Program::put_one(Making& making, std::size_t i) {
  const bool is_doubled = making.factors[i];
  Instruction instruction{.node = in_rows(making.nodes[i], making.rows),
                          .result = is_doubled ? two_rows() : rows_++,
                          .is_doubled = is_doubled};
  const Operation operation = instruction.node.operation;
  if (operation == Operation::inverse_cube)
    instruction.spare = two_rows(), instruction.second = two_rows();
  else if (operation != Operation::linear && operation != Operation::multiply)
    instruction.spare = rows_++;
  making.rows[i] = instruction.result;
  if (is_doubled) {
    making.doubled_rows.resize(static_cast<std::size_t>(rows_));
    making.doubled_rows[static_cast<std::size_t>(instruction.result)] = true;
  }
  instructions_.push_back(instruction);
}

/// Adds a product together with one of the next operations, whose operands must be ready and next to its own;
/// false if it finds no such operation.
bool Program::put_two(Making& making, std::size_t i) {
  constexpr std::size_t next = 16;
  const auto& [nodes, needed, factors, rows, doubled_rows] = making;
  const Node first = in_rows(nodes[i], rows);
  for (std::size_t j = i + 1; j < std::min(i + 1 + next, nodes.size()); ++j) {
    if (nodes[j].operation != Operation::multiply || !needed[j] || rows[j] >= 0) continue;
    const Node other = in_rows(nodes[j], rows);
    const bool comes_first = at_once(first, other) != Products::one;
    const auto& [x, y] = comes_first ? std::tie(first, other) : std::tie(other, first);
    Products both = at_once(x, y);
    if (both == Products::one) continue;
    const bool is_doubled = (both == Products::of_first_with_both && making.is_doubled(x.a)) ||
                            (both == Products::of_both_with_second && making.is_doubled(x.b));
    const int result = two_rows();
    instructions_.push_back({.node = x, .result = result, .products = is_doubled ? Products::of_both : both});
    making.rows[i] = comes_first ? result : result + 1;
    making.rows[j] = comes_first ? result + 1 : result;
    return true;
  }
  return false;
}

void Program::count(const Node& node) {
  static_assert(one_of_kind.size() == kinds);
  ++operations_;
  if (node.operation == Operation::linear)
    linear_at_0_ += cost_of(node, 0), linear_later_ += cost_of(node, 1);
  else
    ++of_kind_[kind_of(node)];
}

long Program::cost(int order) const {
  if (order <= 0) return 0;
  long sum = order * static_cast<long>(unknowns()) * Weights::multiplication + linear_at_0_ +
             (order - 1) * linear_later_;
  for (std::size_t kind = 0; kind < kinds; ++kind)
    sum += of_kind_[kind] * costs_of_kind[kind][static_cast<std::size_t>(order)];
  return sum;
}

namespace {

constexpr Shares shares_of_one = [] {
  Shares all{};
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = twice(1.0 / static_cast<double>(k + 1));
  return all;
}();

/// The operand's newest coefficient.
[[gnu::always_inline]] inline double newest_of(From from, const Row<double>& row, int k, Two handed) {
  return from == From::row ? row[k] : from == From::second ? handed[1] : handed[0];
}
template <class Pair>
[[gnu::always_inline]] inline Two newest_of(From from, const Pair& pair, int k, Two handed) {
  return from == From::row    ? pair[k]
         : from == From::both ? handed
                              : twice(handed[from == From::second ? 1 : 0]);
}

/// Jumps to the next operation's kernel. Each kernel has its own jump, which the processor can predict.
template <int k>
[[gnu::always_inline]] inline void go_on(const Step& step, Two newest) {
  const Step& next = (&step)[1];
  next.kernels[k](next, newest);
}

/// Stores the newest coefficient of one number, or of two, and goes on.
template <int k>
[[gnu::always_inline]] inline void finish(const Step& step, double newest) {
  const Two both = twice(newest);
  if (step.is_doubled)
    Both{step.rows.result.eighth}.put(k, both);
  else
    step.rows.result[k] = newest;
  if (step.unknown.eighth) step.unknown[k + 1] = newest * step.shares[k][0];
  go_on<k>(step, both);
}
template <int k>
[[gnu::always_inline]] inline void finish(const Step& step, Two newest) {
  Both{step.rows.result.eighth}.put(k, newest);
  if (step.unknown.eighth) Both{step.unknown.eighth}.put(k + 1, newest * step.shares[k]);
  if (step.sum.eighth) newest = twice(step.sum[k] = newest[0] + newest[1]);
  go_on<k>(step, newest);
}

template <Operation operation>
struct One {
  template <int k>
  static void compute(const Step& step, Two handed) {
    using Operand = Newest<k, Row<double>, double>;
    const auto& [a, b, result, second, spare] = step.rows;
    const Rows<double, Operand, Operand> rows{
        {a, newest_of(step.a, a, k, handed)}, {b, newest_of(step.b, b, k, handed)}, result, second, spare};
    finish<k>(step, taylor::compute<k>(operation, step.node, rows));
  }
};
struct InverseCube {
  template <int k>
  static void compute(const Step& step, Two handed) {
    using Operand = Newest<k, Row<double>, double>;
    const auto& [a, b, result, second, spare] = step.rows;
    const Rows<double, Operand> rows{{a, newest_of(step.a, a, k, handed)}, b, result, second, spare};
    finish<k>(step, inverse_cube_by_pairs<k>(step.node, rows, Both{spare.eighth}, Both{second.eighth}));
  }
};
/// Linear operations of one operand and of two. Multiplying by a scale of 1 is faster than a test.
struct Multiple {
  template <int k>
  static void compute(const Step& step, Two handed) {
    const double multiple = step.node.alpha * newest_of(step.a, step.rows.a, k, handed);
    finish<k>(step, k == 0 ? multiple + step.node.gamma : multiple);
  }
};
struct Sum {
  template <int k>
  static void compute(const Step& step, Two handed) {
    const double sum = step.node.alpha * newest_of(step.a, step.rows.a, k, handed) +
                       step.node.beta * newest_of(step.b, step.rows.b, k, handed);
    finish<k>(step, k == 0 ? sum + step.node.gamma : sum);
  }
};
struct PlainSum {
  template <int k>
  static void compute(const Step& step, Two handed) {
    const auto& [a, b, result, second, spare] = step.rows;
    finish<k>(step, newest_of(step.a, a, k, handed) + newest_of(step.b, b, k, handed));
  }
};
struct Sine {
  template <int k>
  static void compute(const Step& step, Two handed) {
    const auto& [a, b, result, second, spare] = step.rows;
    const Newest<k, Row<double>, double> of{a, newest_of(step.a, a, k, handed)};
    finish<k>(step, sine_with_cosine<k>(of, Both{result.eighth}, Both{spare.eighth}));
  }
};
struct Turning {
  template <int k>
  static void compute(const Step& step, Two) {
    finish<k>(step, turn_both<k>(step.node, step.rows.a, Both{step.rows.result.eighth}));
  }
};
struct TwoSquares {
  template <int k>
  static void compute(const Step& step, Two handed) {
    const Both a{step.rows.a.eighth};
    finish<k>(step, square<k>(Newest<k, Both, Two>{a, newest_of(step.a, a, k, handed)}));
  }
};
template <class A, class B>
struct TwoProducts {
  template <int k>
  static void compute(const Step& step, Two handed) {
    const A a{step.rows.a.eighth};
    const B b{step.rows.b.eighth};
    finish<k>(step, product<k>(Newest<k, A, Two>{a, newest_of(step.a, a, k, handed)},
                               Newest<k, B, Two>{b, newest_of(step.b, b, k, handed)}));
  }
};
/// The next coefficient of an unknown, or of two, whose derivative no operation stores.
struct Next {
  template <int k>
  static void compute(const Step& step, Two handed) {
    step.unknown[k + 1] = newest_of(step.a, step.rows.a, k, handed) * step.shares[k][0];
    go_on<k>(step, handed);
  }
};
struct NextTwo {
  template <int k>
  static void compute(const Step& step, Two handed) {
    Both{step.unknown.eighth}.put(k + 1, Both{step.rows.a.eighth}[k] * step.shares[k]);
    go_on<k>(step, handed);
  }
};
struct NextOfConstant {
  template <int k>
  static void compute(const Step& step, Two handed) {
    step.unknown[k + 1] = k == 0 ? step.node.gamma : 0;
    go_on<k>(step, handed);
  }
};
struct End {
  template <int>
  static void compute(const Step&, Two) {}
};

/// A kernel for every order.
template <class Kernel>
constexpr auto kernels = []<int... k>(std::integer_sequence<int, k...>) {
  return std::array<Step::Kernel, most_orders>{&Kernel::template compute<k>...};
}
(std::make_integer_sequence<int, most_orders>());

bool is_plain_sum(const Node& node) {
  return node.operation == Operation::linear && node.b >= 0 && node.alpha == 1 && node.beta == 1 &&
         node.gamma == 0;
}

const Step::Kernel* kernels_of(const Node& node, Products products) {
  switch (products) {
    case Products::one:
      break;
    case Products::of_both:
      return node.a == node.b ? kernels<TwoSquares>.data() : kernels<TwoProducts<Both, Both>>.data();
    case Products::of_first_with_both:
      return kernels<TwoProducts<Twice, Both>>.data();
    case Products::of_both_with_second:
      return kernels<TwoProducts<Both, Twice>>.data();
  }
  switch (node.operation) {
    case Operation::linear:
      return is_plain_sum(node) ? kernels<PlainSum>.data()
             : node.b >= 0      ? kernels<Sum>.data()
                                : kernels<Multiple>.data();
    case Operation::multiply:
      return kernels<One<Operation::multiply>>.data();
    case Operation::divide:
      return kernels<One<Operation::divide>>.data();
    case Operation::inverse_cube:
      return kernels<InverseCube>.data();
    case Operation::square_root:
      return kernels<One<Operation::square_root>>.data();
    case Operation::sine:
      return kernels<Sine>.data();
    case Operation::turning:
      return kernels<Turning>.data();
    case Operation::exponential:
      return kernels<One<Operation::exponential>>.data();
    case Operation::unknown:
    case Operation::cosine:
      break;
  }
  return nullptr;
}

/// The rows that a step hands over: one, or two.
struct Handed {
  int row = -1;
  bool two = false, is_doubled = false;

  From of_one(int operand) const {
    return operand < 0 || operand == row ? From::first : two && operand == row + 1 ? From::second : From::row;
  }
  From of_two(int operand) const { return operand == row && (two || is_doubled) ? From::both : From::row; }
};

}  // namespace

/// The steps of a series under construction.
struct Series::Making {
  Series& series;
  std::vector<bool> has_next{};  ///< whether an unknown's derivative is placed
  Handed handed{};

  Row<double> row(int i) { return i < 0 ? Row<double>() : series.row(i); }

  /// factors / (k + 1), by k.
  const Two* shares(Two factors) {
    if (factors[0] == 1 && factors[1] == 1) return shares_of_one.data();
    Shares& made = series.shares_.emplace_back();
    for (std::size_t k = 0; k < made.size(); ++k) made[k] = factors * shares_of_one[k];
    return made.data();
  }
  /// Lets the step also compute an unknown whose derivative is a multiple of this row, or two for this row
  /// and the next. False if no unknown has such a derivative.
  bool take_unknown(Step& step, int from, bool two) {
    const auto& all = series.program_.derivatives_;
    const std::size_t n = two ? 2 : 1;
    for (std::size_t i = 0; i + n <= all.size(); i += n) {
      if (has_next[i] || all[i].row != from || (two && (has_next[i + 1] || all[i + 1].row != from + 1)))
        continue;
      for (std::size_t j = i; j < i + n; ++j) has_next[j] = true;
      step.unknown = row(static_cast<int>(i));
      step.shares = shares(Two{all[i].factor, all[i + n - 1].factor});
      return true;
    }
    return false;
  }
  void put_next(int from, bool two) {
    for (Step step; take_unknown(step, from, two);) {
      step.kernels = two ? kernels<NextTwo>.data() : kernels<Next>.data();
      step.rows.a = row(from);
      step.a = handed.of_one(from);
      series.steps_.push_back(step);
    }
  }
  void put_next_of_constants() {
    const auto& all = series.program_.derivatives_;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].row >= 0) continue;
      Step& step = series.steps_.emplace_back();
      step.kernels = kernels<NextOfConstant>.data();
      step.unknown = row(static_cast<int>(i));
      step.node.gamma = all[i].constant;
    }
  }
  /// Adds the operation, including the plain sum of its two results if that is the next operation; true in
  /// that case.
  bool put(const Program::Instruction& instruction, const Program::Instruction* next) {
    const auto& [node, result, second, spare, products, is_doubled] = instruction;
    const bool two = products != Products::one || is_sine(node);
    const bool with_sum = two && next && is_plain_sum(next->node) && !next->is_doubled &&
                          std::min(next->node.a, next->node.b) == result &&
                          std::max(next->node.a, next->node.b) == result + 1;
    Step& step = series.steps_.emplace_back();
    step.kernels = kernels_of(node, products);
    step.rows = {row(node.a), row(node.b), row(result), row(second), row(spare)};
    step.a = products == Products::of_both || products == Products::of_both_with_second
                 ? handed.of_two(node.a)
                 : handed.of_one(node.a);
    step.b = products == Products::of_both || products == Products::of_first_with_both
                 ? handed.of_two(node.b)
                 : handed.of_one(node.b);
    take_unknown(step, result, two);
    if (with_sum) step.sum = row(next->result);
    step.is_doubled = is_doubled;
    step.node = node;
    handed = with_sum ? Handed{next->result} : Handed{result, two, is_doubled};
    if (two) put_next(result, true);
    for (int i = result; i <= result + two; ++i) put_next(i, false);
    if (with_sum) put_next(next->result, false);
    return with_sum;
  }
  void put_all() {
    series.shares_.reserve(series.program_.unknowns());
    series.steps_.reserve(series.program_.instructions_.size() + 2 * series.program_.unknowns() + 1);
    const auto unknowns = static_cast<int>(series.program_.unknowns());
    has_next.resize(series.program_.unknowns());
    put_next_of_constants();
    for (int i = 0; i < unknowns; i += 2) put_next(i, true);
    for (int i = 0; i <= unknowns; ++i) put_next(i, false);
    const auto& all = series.program_.instructions_;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (put(all[i], i + 1 < all.size() ? &all[i + 1] : nullptr)) ++i;
    series.steps_.emplace_back().kernels = kernels<End>.data();
  }
};

Series::Series(Program program) : program_(std::move(program)) {
  memory_ = std::make_unique_for_overwrite<double[]>(start(program_.rows_ + program_.rows_ % 2));
  for (int k = 0; k <= most_orders; ++k) row(static_cast<int>(program_.unknowns()))[k] = k == 1;
  Making{*this}.put_all();
}

void Series::expand(const double* x, double t, int order) {
  order_ = order;
  const std::size_t n = program_.unknowns();
  for (std::size_t i = 0; i < n; i += 2)
    Both{row(static_cast<int>(i)).eighth}.put(0, Two{x[i], i + 1 < n ? x[i + 1] : t});
  row(static_cast<int>(n))[0] = t;
  const Step& first = steps_.front();
  [&]<int... k>(std::integer_sequence<int, k...>) {
    ((k < order ? first.kernels[k](first, Two{}) : void()), ...);
  }
  (std::make_integer_sequence<int, most_orders>());
}

/// Sums even and odd powers separately.
void Series::at(double h, double* x) const {
  const Two square = twice(h * h);
  const std::size_t n = program_.unknowns();
  for (std::size_t i = 0; i < n; i += 2) {
    const auto c = both(i);
    Two even{}, odd{};
    for (int k = order_ - order_ % 2; k >= 0; k -= 2) even = even * square + c[k];
    for (int k = order_ - 1 + order_ % 2; k > 0; k -= 2) odd = odd * square + c[k];
    const Two sum = even + h * odd;
    x[i] = sum[0];
    if (i + 1 < n) x[i + 1] = sum[1];
  }
}

bool Series::is_finite() const {
  Two zero{};
  for (std::size_t i = 0; i < program_.unknowns(); i += 2) zero += (both(i)[0] + both(i)[order_]) * 0.0;
  return zero[0] == 0 && zero[1] == 0;
}

}  // namespace oddity::taylor
