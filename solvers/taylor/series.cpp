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
std::vector<bool> needed(const Recording& recording) {
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

Program::Program(const Recording& recording) {
  const std::vector<Node>& nodes = recording.tape.nodes();
  const std::vector<bool> is_needed = needed(recording);
  std::vector<int> rows(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (is_needed[i]) by_hand_ += by_hand(node);
    const bool for_cosine = node.operation == Operation::sine && is_needed[i + 1];
    if (rows[i] >= 0 || (node.operation != Operation::unknown && !is_needed[i] && !for_cosine)) continue;
    if (node.operation == Operation::multiply)
      multiply(nodes, is_needed, i, rows);
    else
      put(node, i, rows);
  }
  for (const Recorded& derivative : recording.derivatives)
    derivatives_.push_back({row_of(derivative.node(), rows), derivative.constant()});
  by_hand_ = std::max(by_hand_, 1L);
  price();
}

/// An operation, or an unknown, with rows of its own.
void Program::put(const Node& node, std::size_t i, std::vector<int>& rows) {
  if (node.operation == Operation::sine) rows_ += rows_ % 2;
  rows[i] = rows_++;
  if (node.operation == Operation::unknown) return;
  Instruction instruction{in_rows(node, rows), rows[i]};
  if (node.operation == Operation::sine) instruction.second = rows[i + 1] = rows_++;
  if (node.operation != Operation::linear) instruction.spare = rows_++;
  instructions_.push_back(instruction);
}

/// A product, at once with one of the next operations where that one's operands are there and lie beside its
/// own.
void Program::multiply(const std::vector<Node>& nodes, const std::vector<bool>& is_needed, std::size_t i,
                       std::vector<int>& rows) {
  constexpr std::size_t next = 16;
  const Node first = in_rows(nodes[i], rows);
  for (std::size_t j = i + 1; j < std::min(i + 1 + next, nodes.size()); ++j) {
    if (nodes[j].operation != Operation::multiply || !is_needed[j] || rows[j] >= 0) continue;
    const Node other = in_rows(nodes[j], rows);
    const bool comes_first = at_once(first, other) != Products::one;
    const auto& [x, y] = comes_first ? std::tie(first, other) : std::tie(other, first);
    const Products both = at_once(x, y);
    if (both == Products::one) continue;
    rows_ += rows_ % 2;
    instructions_.push_back({.node = x, .result = rows_, .products = both});
    rows[comes_first ? i : j] = rows_++;
    rows[comes_first ? j : i] = rows_++;
    return;
  }
  rows[i] = rows_++;
  instructions_.push_back({.node = first, .result = rows[i]});
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

using Kernel = void (*)(const Node&, const Rows<double>&);

template <Operation operation, int k>
void one(const Node& node, const Rows<double>& rows) {
  compute<k>(operation, node, rows);
}
template <int k>
void plain_sum(const Node&, const Rows<double>& rows) {
  rows.result[k] = rows.a[k] + rows.b[k];
}
template <int k>
void sine(const Node&, const Rows<double>& rows) {
  sine_with_cosine<k>(rows);
}
template <int k>
void two_squares(const Node&, const Rows<double>& rows) {
  Both{rows.result.first}.put(k, square<k>(Both{rows.a.first}));
}
template <class A, class B, int k>
void two_products(const Node&, const Rows<double>& rows) {
  Both{rows.result.first}.put(k, product<k>(A{rows.a.first}, B{rows.b.first}));
}

/// How coefficient k is computed, by operation.
template <int k>
constexpr std::array<Kernel, 11> kernels{plain_sum<k>,
                                         one<Operation::multiply, k>,
                                         one<Operation::divide, k>,
                                         one<Operation::inverse_cube, k>,
                                         one<Operation::square_root, k>,
                                         sine<k>,
                                         one<Operation::exponential, k>,
                                         two_squares<k>,
                                         two_products<Both, Both, k>,
                                         two_products<Twice, Both, k>,
                                         two_products<Both, Twice, k>};

/// Not among the kernels: a call would take as long.
constexpr std::size_t linear_sum = kernels<0>.size();

std::size_t kernel_of(const Node& node, Products products) {
  constexpr std::array single{Operation::multiply,    Operation::divide, Operation::inverse_cube,
                              Operation::square_root, Operation::sine,   Operation::exponential};
  if (node.operation == Operation::linear)
    return node.b >= 0 && node.alpha == 1 && node.beta == 1 && node.gamma == 0 ? 0 : linear_sum;
  switch (products) {
    case Products::one:
      return 1 + static_cast<std::size_t>(std::ranges::find(single, node.operation) - single.begin());
    case Products::of_both:
      return single.size() + (node.a == node.b ? 1 : 2);
    case Products::of_first_with_both:
      return single.size() + 3;
    case Products::of_both_with_second:
      return single.size() + 4;
  }
  return 0;
}

}  // namespace

constexpr std::array<void (*)(Series&), most_orders> Series::advance_by_order =
    []<int... k>(std::integer_sequence<int, k...>)->std::array<void (*)(Series&), most_orders> {
  return {&advance<k>...};
}
(std::make_integer_sequence<int, most_orders>());

Series::Series(Program program) : program_(std::move(program)) {
  memory_.resize(start(program_.rows_ + program_.rows_ % 2));
  const auto rows = [this](int i) { return i < 0 ? Row<double>() : row(i); };
  for (const auto& [node, result, second, spare, products] : program_.instructions_)
    steps_.push_back({kernel_of(node, products),
                      node,
                      {rows(node.a), rows(node.b), row(result), rows(second), rows(spare)}});
  const auto& all = program_.derivatives_;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool two = i % 2 == 0 && i + 1 < all.size() && beside(all[i].row, all[i + 1].row);
    slopes_.push_back({rows(all[i].row), row(static_cast<int>(i)), all[i].constant, two});
    if (two) ++i;
  }
}

void Series::expand(const double* x, double t, int order) {
  order_ = order;
  for (std::size_t i = 0; i < program_.unknowns(); ++i) row(static_cast<int>(i))[0] = x[i];
  const Row<double> time = row(static_cast<int>(program_.unknowns()));
  time[0] = t;
  time[1] = 1;
  for (int k = 0; k < order; ++k) advance_by_order[static_cast<std::size_t>(k)](*this);
}

/// Coefficient k of all operations, and k + 1 of the unknowns.
template <int k>
void Series::advance(Series& series) {
  for (const auto& [kernel, node, rows] : series.steps_) {
    if (kernel == linear_sum)
      linear<k>(node, rows);
    else
      kernels<k>[kernel](node, rows);
  }
  constexpr double share = 1.0 / (k + 1);
  for (const auto& [from, to, constant, two] : series.slopes_) {
    if (two)
      Both{to.first}.put(k + 1, Both{from.first}[k] * share);
    else
      to[k + 1] = from.first ? from[k] * share : k == 0 ? constant : 0;
  }
}

void Series::at(double h, double* x) const {
  const double square = h * h;
  for (std::size_t i = 0; i < program_.unknowns(); ++i) {
    const Row<const double> c = row(static_cast<int>(i));
    double even = 0, odd = 0;
    for (int k = order_ - order_ % 2; k >= 0; k -= 2) even = even * square + c[k];
    for (int k = order_ - 1 + order_ % 2; k > 0; k -= 2) odd = odd * square + c[k];
    x[i] = even + h * odd;
  }
}

}  // namespace oddity::taylor
