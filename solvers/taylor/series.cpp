#include "solvers/taylor/series.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace oddity::taylor {

namespace {

/// What a node's value costs by hand.
long by_hand(const Node& node) {
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
    case Operation::unknown:
      break;
  }
  return 0;
}

int row_of(int node, const std::vector<int>& rows) {
  return node < 0 ? -1 : rows[static_cast<std::size_t>(node)];
}
Node in_rows(Node node, const std::vector<int>& rows) {
  node.a = row_of(node.a, rows);
  node.b = row_of(node.b, rows);
  return node;
}

/// Whether two rows are interleaved with each other, in this order.
bool beside(int row, int next) { return row >= 0 && row % 2 == 0 && next == row + 1; }

/// Whether two products can be had at once.
Products at_once(const Node& x, const Node& y) {
  if (y.a < 0 || y.b < 0 || (x.a == x.b) != (y.a == y.b)) return Products::one;
  if (beside(x.a, y.a) && beside(x.b, y.b)) return Products::of_both;
  if (x.a == y.a && beside(x.b, y.b)) return Products::of_first_with_both;
  if (x.b == y.b && beside(x.a, y.a)) return Products::of_both_with_second;
  return Products::one;
}

/// The nodes that others need.
std::vector<bool> needed_of(const Recording& recording) {
  const std::vector<Node>& nodes = recording.tape.nodes();
  std::vector<bool> all(nodes.size());
  const auto need = [&](int node) {
    if (node >= 0) all[static_cast<std::size_t>(node)] = true;
  };
  for (const Recorded& derivative : recording.derivatives) need(derivative.node());
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (all[i]) need(nodes[i].a), need(nodes[i].b);
  return all;
}

/// The nodes that are a factor of several products.
std::vector<bool> factors_of(const std::vector<Node>& nodes, const std::vector<bool>& needed) {
  std::vector<int> products(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (needed[i] && nodes[i].operation == Operation::multiply)
      for (int factor : {nodes[i].a, nodes[i].b}) ++products[static_cast<std::size_t>(factor)];
  std::vector<bool> all(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) all[i] = products[i] >= 2;
  return all;
}

}  // namespace

long cost_of(const Node& node, int k) {
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
    case Operation::exponential:
      if (k == 0) return Weights::function;
      return 1 + (k == 1 ? 2 : 3 + inside);
    case Operation::unknown:
    case Operation::cosine:
      break;
  }
  return 0;
}

/// A program on its way from a recording.
struct Program::Making {
  const std::vector<Node>& nodes;
  std::vector<bool> needed, factors;
  std::vector<int> rows;             ///< of the nodes that have been put; else -1
  std::vector<bool> doubled_rows{};  ///< as many as are known

  bool is_doubled(int row) const {
    const auto i = static_cast<std::size_t>(row);
    return i < doubled_rows.size() && doubled_rows[i];
  }
};

Program::Program(const Recording& recording) {
  const std::vector<Node>& nodes = recording.tape.nodes();
  const std::vector<bool> needed = needed_of(recording);
  Making making{nodes, needed, factors_of(nodes, needed), std::vector<int>(nodes.size(), -1)};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (needed[i]) by_hand_ += by_hand(node);
    const bool for_cosine = node.operation == Operation::sine && needed[i + 1];
    if (making.rows[i] >= 0 || (node.operation != Operation::unknown && !needed[i] && !for_cosine)) continue;
    if (node.operation == Operation::unknown)
      making.rows[i] = rows_++;
    else if (node.operation == Operation::sine)
      put_sine(making, i);
    else if (node.operation != Operation::multiply || !put_two(making, i))
      put_one(making, i);
  }
  for (const Recorded& derivative : recording.derivatives)
    derivatives_.push_back({row_of(derivative.node(), making.rows), derivative.constant()});
  by_hand_ = std::max(by_hand_, 1L);
  price();
}

/// Two rows that are interleaved, of which this is the first.
int Program::two_rows() {
  rows_ += rows_ % 2;
  return std::exchange(rows_, rows_ + 2);
}

void Program::put_sine(Making& making, std::size_t i) {
  const int both = two_rows();
  instructions_.push_back({.node = in_rows(making.nodes[i], making.rows),
                           .result = both,
                           .second = both + 1,
                           .spare = two_rows()});
  making.rows[i] = both;
  making.rows[i + 1] = both + 1;
}

/// An operation with a row of its own, which it fills twice where it is to be multiplied with pairs.
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
  making.doubled_rows.resize(static_cast<std::size_t>(rows_));
  making.doubled_rows[static_cast<std::size_t>(instruction.result)] = is_doubled;
  instructions_.push_back(instruction);
}

/// A product, at once with one of the next operations where that one's operands are there and lie beside its
/// own; whether there is such a one.
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

/// Operations of one kind cost alike, but for the scales of a linear one, which are the same at all orders
/// but 0.
void Program::price() {
  struct Kind {
    Node node;
    long count;
  };
  std::vector<Kind> kinds;
  long linear_at_0 = 0, linear_later = 0;
  for (const Instruction& instruction : instructions_) {
    const Node& node = instruction.node;
    const long times = instruction.products == Products::one ? 1 : 2;
    operations_ += times;
    if (node.operation == Operation::linear) {
      linear_at_0 += cost_of(node, 0);
      linear_later += cost_of(node, 1);
      continue;
    }
    const auto same = std::ranges::find_if(kinds, [&](const Kind& kind) {
      const Node& other = kind.node;
      return other.operation == node.operation && (other.a < 0) == (node.a < 0) &&
             (other.a == other.b) == (node.a == node.b);
    });
    if (same == kinds.end())
      kinds.push_back({node, times});
    else
      same->count += times;
  }
  for (int k = 0; k < most_orders; ++k) {
    long sum =
        static_cast<long>(unknowns()) * Weights::multiplication + (k == 0 ? linear_at_0 : linear_later);
    for (const Kind& kind : kinds) sum += kind.count * cost_of(kind.node, k);
    const auto order = static_cast<std::size_t>(k);
    costs_[order + 1] = costs_[order] + sum;
  }
}

namespace {

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

/// Goes on with the next operation: a jump in each kernel's own place, which the processor foresees.
template <int k>
[[gnu::always_inline]] inline void go_on(const Step& step, Two newest) {
  const Step& next = (&step)[1];
  next.kernels[k](next, newest);
}

/// What is left to do with a number's newest coefficient, and with those of two.
template <int k>
[[gnu::always_inline]] inline void finish(const Step& step, double newest) {
  const Two both = twice(newest);
  if (step.is_doubled)
    Both{step.rows.result.first}.put(k, both);
  else
    step.rows.result[k] = newest;
  if (step.unknown.first) step.unknown[k + 1] = newest * (1.0 / (k + 1));
  go_on<k>(step, both);
}
template <int k>
[[gnu::always_inline]] inline void finish(const Step& step, Two newest) {
  Both{step.rows.result.first}.put(k, newest);
  if (step.unknown.first) Both{step.unknown.first}.put(k + 1, newest * (1.0 / (k + 1)));
  if (step.sum.first) newest = twice(step.sum[k] = newest[0] + newest[1]);
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
    finish<k>(step, inverse_cube_by_pairs<k>(step.node, rows, Both{spare.first}, Both{second.first}));
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
    finish<k>(step, sine_with_cosine<k>(of, Both{result.first}, Both{spare.first}));
  }
};
struct TwoSquares {
  template <int k>
  static void compute(const Step& step, Two handed) {
    const Both a{step.rows.a.first};
    finish<k>(step, square<k>(Newest<k, Both, Two>{a, newest_of(step.a, a, k, handed)}));
  }
};
template <class A, class B>
struct TwoProducts {
  template <int k>
  static void compute(const Step& step, Two handed) {
    const A a{step.rows.a.first};
    const B b{step.rows.b.first};
    finish<k>(step, product<k>(Newest<k, A, Two>{a, newest_of(step.a, a, k, handed)},
                               Newest<k, B, Two>{b, newest_of(step.b, b, k, handed)}));
  }
};
/// An unknown's next coefficient, and those of two, where the derivatives are no operation's.
struct Next {
  template <int k>
  static void compute(const Step& step, Two handed) {
    step.unknown[k + 1] = newest_of(step.a, step.rows.a, k, handed) * (1.0 / (k + 1));
    go_on<k>(step, handed);
  }
};
struct NextTwo {
  template <int k>
  static void compute(const Step& step, Two handed) {
    Both{step.unknown.first}.put(k + 1, Both{step.rows.a.first}[k] * (1.0 / (k + 1)));
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

/// A kernel of every order.
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
      return is_plain_sum(node) ? kernels<PlainSum>.data() : kernels<One<Operation::linear>>.data();
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
    case Operation::exponential:
      return kernels<One<Operation::exponential>>.data();
    case Operation::unknown:
    case Operation::cosine:
      break;
  }
  return nullptr;
}

/// What a step hands over: a row, or two.
struct Handed {
  int row = -1;
  bool two = false, is_doubled = false;

  From of_one(int operand) const {
    return operand < 0 || operand == row ? From::first : two && operand == row + 1 ? From::second : From::row;
  }
  From of_two(int operand) const { return operand == row && (two || is_doubled) ? From::both : From::row; }
};

}  // namespace

/// The steps of a series in the making.
struct Series::Making {
  Series& series;
  std::vector<bool> has_next{};  ///< of the unknowns
  Handed handed{};

  Row<double> row(int i) { return i < 0 ? Row<double>() : series.row(i); }

  /// An unknown whose derivative this row is, or two whose derivatives it and the next are; or none.
  Row<double> take_unknown(int from, bool two) {
    const auto& all = series.program_.derivatives_;
    const std::size_t n = two ? 2 : 1;
    for (std::size_t i = 0; i + n <= all.size(); i += n) {
      if (has_next[i] || all[i].row != from || (two && (has_next[i + 1] || all[i + 1].row != from + 1)))
        continue;
      for (std::size_t j = i; j < i + n; ++j) has_next[j] = true;
      return row(static_cast<int>(i));
    }
    return {};
  }
  void put_next(int from, bool two) {
    while (const auto unknown = take_unknown(from, two).first) {
      Step& step = series.steps_.emplace_back();
      step.kernels = two ? kernels<NextTwo>.data() : kernels<Next>.data();
      step.rows.a = row(from);
      step.a = handed.of_one(from);
      step.unknown = {unknown};
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
  /// The operation, with the plain sum of its two results where that comes next.
  bool put(const Program::Instruction& instruction, const Program::Instruction* next) {
    const auto& [node, result, second, spare, products, is_doubled] = instruction;
    const bool two = products != Products::one || node.operation == Operation::sine;
    const bool with_sum = two && next && is_plain_sum(next->node) && !next->is_doubled &&
                          next->node.a == result && next->node.b == result + 1;
    Step& step = series.steps_.emplace_back();
    step.kernels = kernels_of(node, products);
    step.rows = {row(node.a), row(node.b), row(result), row(second), row(spare)};
    step.a = products == Products::of_both || products == Products::of_both_with_second
                 ? handed.of_two(node.a)
                 : handed.of_one(node.a);
    step.b = products == Products::of_both || products == Products::of_first_with_both
                 ? handed.of_two(node.b)
                 : handed.of_one(node.b);
    step.unknown = take_unknown(result, two);
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
  memory_.resize(start(program_.rows_ + program_.rows_ % 2));
  Making{*this}.put_all();
}

void Series::expand(const double* x, double t, int order) {
  order_ = order;
  const std::size_t n = program_.unknowns();
  for (std::size_t i = 0; i < n; i += 2)
    Both{row(static_cast<int>(i)).first}.put(0, Two{x[i], i + 1 < n ? x[i + 1] : t});
  const Row<double> time = row(static_cast<int>(n));
  time[0] = t;
  time[1] = 1;
  const Step& first = steps_.front();
  [&]<int... k>(std::integer_sequence<int, k...>) {
    ((k < order ? first.kernels[k](first, Two{}) : void()), ...);
  }
  (std::make_integer_sequence<int, most_orders>());
}

/// In even powers and odd ones.
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
