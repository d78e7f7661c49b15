#include "solvers/taylor/series.hpp"

#include <algorithm>
#include <array>
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
      return k == 0 ? by_hand(node) + Weights::division : 3 * k;
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
  const auto row_of = [&](int node) { return node < 0 ? -1 : rows[static_cast<std::size_t>(node)]; };
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Node node = nodes[i];
    if (is_needed[i]) by_hand_ += by_hand(node);
    const bool with_sine = node.operation == Operation::cosine;
    const bool for_cosine = node.operation == Operation::sine && is_needed[i + 1];
    if (with_sine && rows[i] >= 0) continue;
    if (node.operation != Operation::unknown && !is_needed[i] && !for_cosine) continue;
    rows[i] = rows_++;
    if (node.operation == Operation::unknown) continue;
    node.a = row_of(node.a);
    node.b = row_of(node.b);
    Instruction instruction{node, rows[i]};
    if (node.operation == Operation::sine) instruction.second = rows[i + 1] = rows_++;
    if (node.operation != Operation::linear && node.operation != Operation::multiply)
      instruction.spare = rows_++;
    instructions_.push_back(instruction);
  }
  for (const Recorded& derivative : recording.derivatives)
    derivatives_.push_back({row_of(derivative.node()), derivative.constant()});
  by_hand_ = std::max(by_hand_, 1L);
  price();
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
      kinds.push_back({node, 1});
    else
      ++same->count;
  }
  for (int k = 0; k < most_orders; ++k) {
    long sum =
        static_cast<long>(unknowns()) * Weights::multiplication + (k == 0 ? linear_at_0 : linear_later);
    for (const Kind& kind : kinds) sum += kind.count * cost_of(kind.node, k);
    costs_[static_cast<std::size_t>(k + 1)] = costs_[static_cast<std::size_t>(k)] + sum;
  }
}

constexpr std::array<void (*)(Series&), most_orders> Series::advance_by_order =
    []<int... k>(std::integer_sequence<int, k...>)->std::array<void (*)(Series&), most_orders> {
  return {&advance<k>...};
}
(std::make_integer_sequence<int, most_orders>());

Series::Series(Program program) : program_(std::move(program)) {
  memory_.resize(static_cast<std::size_t>(program_.rows_ * stride));
  const auto rows = [this](int i) { return i < 0 ? nullptr : row(i); };
  for (const auto& [node, result, second, spare] : program_.instructions_)
    steps_.push_back({node, {rows(node.a), rows(node.b), row(result), rows(second), rows(spare)}});
}

void Series::expand(const double* x, double t, int order) {
  order_ = order;
  for (std::size_t i = 0; i < program_.unknowns(); ++i) row(static_cast<int>(i))[0] = x[i];
  const int time = static_cast<int>(program_.unknowns());
  row(time)[0] = t;
  row(time)[1] = 1;
  for (int k = 0; k < order; ++k) advance_by_order[static_cast<std::size_t>(k)](*this);
}

/// Coefficient k of all operations, and k + 1 of the unknowns.
template <int k>
void Series::advance(Series& series) {
  double* const memory = series.memory_.data();
  for (const auto& [node, rows] : series.steps_) compute<k>(node, rows);
  double* next = memory + k + 1;
  for (const auto& [from, constant] : series.program_.derivatives_) {
    *next = from >= 0 ? memory[from * stride + k] * (1.0 / (k + 1)) : k == 0 ? constant : 0;
    next += stride;
  }
}

void Series::at(double h, double* x) const {
  const double square = h * h;
  for (std::size_t i = 0; i < program_.unknowns(); ++i) {
    const double* c = row(static_cast<int>(i));
    double even = 0, odd = 0;
    for (int k = order_ - order_ % 2; k >= 0; k -= 2) even = even * square + c[k];
    for (int k = order_ - 1 + order_ % 2; k > 0; k -= 2) odd = odd * square + c[k];
    x[i] = even + h * odd;
  }
}

}  // namespace oddity::taylor
