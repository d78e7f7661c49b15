#include "solvers/taylor/tape.hpp"

#include <algorithm>
#include <utility>

namespace oddity::taylor {

namespace {

/// scale * node + shift, of a node that is itself such a multiple of another.
struct Multiple {
  int node;
  double scale, shift;
};

Multiple multiple(const Tape& tape, int node, double scale) {
  const Node& n = tape.nodes()[static_cast<std::size_t>(node)];
  if (n.operation != Operation::linear || n.b >= 0) return {node, scale, 0};
  return {n.a, scale * n.alpha, scale * n.gamma};
}

const Node* operation(const Tape& tape, int node, Operation operation) {
  const Node& n = tape.nodes()[static_cast<std::size_t>(node)];
  return n.operation == operation ? &n : nullptr;
}

/// Of a node that is c sqrt(c), the node c; else none.
int under_three_halves(const Tape& tape, int node) {
  const Node* product = operation(tape, node, Operation::multiply);
  if (!product) return -1;
  for (const auto& [root, other] : {std::pair{product->a, product->b}, std::pair{product->b, product->a}})
    if (const Node* n = operation(tape, root, Operation::square_root); n && n->a == other) return other;
  return -1;
}

}  // namespace

int Tape::unknown() {
  nodes_.push_back({Operation::unknown});
  return static_cast<int>(nodes_.size()) - 1;
}

int Tape::put(const Node& node) {
  const auto same = std::ranges::find(nodes_, node);
  if (same != nodes_.end()) return static_cast<int>(same - nodes_.begin());
  nodes_.push_back(node);
  return static_cast<int>(nodes_.size()) - 1;
}

int Tape::sine_and_cosine(int of) {
  const int sine = put({Operation::sine, of});
  put({Operation::cosine, of});
  return sine;
}

Recorded Recorded::sum(double alpha, const Recorded& a, double beta, const Recorded& b) {
  if (a.is_constant() && b.is_constant()) return alpha * a.constant_ + beta * b.constant_;
  if (a.is_constant()) return sum(beta, b, alpha, a);
  Tape& tape = *a.tape_;
  Multiple first = multiple(tape, a.node_, alpha);
  Multiple second{-1, 0, beta * b.constant_};
  if (!b.is_constant()) second = multiple(tape, b.node_, beta);
  if (first.node == second.node) first.scale += std::exchange(second, {-1, 0, second.shift}).scale;
  const double shift = first.shift + second.shift;
  if (first.scale == 0 && second.node >= 0) std::swap(first, second);
  if (second.scale == 0) second.node = -1;
  if (first.scale == 0) return shift;
  if (second.node < 0 && first.scale == 1 && shift == 0) return {tape, first.node};
  return {tape, tape.put({Operation::linear, first.node, second.node, first.scale, second.scale, shift})};
}

Recorded Recorded::product(const Recorded& a, const Recorded& b) {
  if (a.is_constant()) return sum(a.constant_, b, 0, 0);
  if (b.is_constant()) return sum(b.constant_, a, 0, 0);
  const auto [low, high] = std::minmax(a.node_, b.node_);
  return {*a.tape_, a.tape_->put({Operation::multiply, low, high})};
}

Recorded Recorded::quotient(const Recorded& a, const Recorded& b) {
  if (b.is_constant()) return a.is_constant() ? a.constant_ / b.constant_ : sum(1 / b.constant_, a, 0, 0);
  Tape& tape = *b.tape_;
  if (!a.is_constant()) return {tape, tape.put({Operation::divide, a.node_, b.node_})};
  if (a.constant_ == 0) return 0;
  if (const int c = under_three_halves(tape, b.node_); c >= 0)
    return {tape, tape.put({Operation::inverse_cube, c, -1, 0, 0, a.constant_})};
  return {tape, tape.put({Operation::divide, -1, b.node_, 0, 0, a.constant_})};
}

}  // namespace oddity::taylor
