#include "solvers/taylor/tape.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace oddity::taylor {

namespace {

const Node* operation(const Tape& tape, int node, Operation operation) {
  const Node& n = tape.nodes()[static_cast<std::size_t>(node)];
  return n.operation == operation ? &n : nullptr;
}

/// The node c, if the given node is c sqrt(c); else -1.
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

Recorded Recorded::times(double scale) const {
  if (is_constant() || scale == 0) return scale * term_;
  Recorded scaled(*tape_, node_, scale * factor_);
  scaled.term_ = scale * term_;
  return scaled;
}

Recorded Recorded::plus(double term) const {
  Recorded moved = *this;
  moved.term_ += term;
  return moved;
}

int Recorded::node_of(double factor, double term) const {
  if (factor == 1 && term == 0) return node_;
  const Node& n = tape_->nodes()[static_cast<std::size_t>(node_)];
  if (n.operation != Operation::linear) return tape_->put({Operation::linear, node_, -1, factor, 0, term});
  return tape_->put(
      {Operation::linear, n.a, n.b, factor * n.alpha, factor * n.beta, factor * n.gamma + term});
}

/// Combines the term with the node for a unit factor, which other numbers may share.
Recorded Recorded::multiple() const {
  if (is_constant() || term_ == 0) return *this;
  const double of_one = term_ / factor_;
  return std::isfinite(of_one) ? Recorded(*tape_, node_of(1, of_one), factor_) : Recorded(*tape_, whole());
}

/// The lower node comes first, and factors of equal size are taken out of the sum, so that a repeated sum is
/// found.
Recorded Recorded::sum(const Recorded& a, const Recorded& b) {
  if (a.is_constant()) return b.plus(a.term_);
  if (b.is_constant()) return a.plus(b.term_);
  const double term = a.term_ + b.term_;
  if (a.node_ == b.node_) {
    const double factor = a.factor_ + b.factor_;
    return factor == 0 ? Recorded(term) : Recorded(*a.tape_, a.node_, factor).plus(term);
  }
  const auto& [low, high] = a.node_ < b.node_ ? std::tie(a, b) : std::tie(b, a);
  const bool alike = std::abs(low.factor_) == std::abs(high.factor_) && low.factor_ != 0;
  const double factor = alike ? low.factor_ : 1;
  const Node node{Operation::linear, low.node_, high.node_, low.factor_ / factor, high.factor_ / factor, 0};
  return Recorded(*a.tape_, a.tape_->put(node), factor).plus(term);
}

Recorded Recorded::product(const Recorded& a, const Recorded& b) {
  if (a.is_constant()) return b.times(a.term_);
  if (b.is_constant()) return a.times(b.term_);
  const Recorded of_a = a.multiple(), of_b = b.multiple();
  const auto [low, high] = std::minmax(of_a.node_, of_b.node_);
  return {*a.tape_, a.tape_->put({Operation::multiply, low, high}), of_a.factor_ * of_b.factor_};
}

Recorded Recorded::quotient(const Recorded& a, const Recorded& b) {
  if (b.is_constant()) return a.is_constant() ? Recorded(a.term_ / b.term_) : a.times(1 / b.term_);
  Tape& tape = *b.tape_;
  const Recorded of_b = b.multiple();
  if (!a.is_constant()) {
    const Recorded of_a = a.multiple();
    return {tape, tape.put({Operation::divide, of_a.node_, of_b.node_}), of_a.factor_ / of_b.factor_};
  }
  if (a.term_ == 0) return 0;
  const double over = a.term_ / of_b.factor_;
  if (const int c = under_three_halves(tape, of_b.node_); c >= 0)
    return {tape, tape.put({Operation::inverse_cube, c, -1, 0, 0, over})};
  return {tape, tape.put({Operation::divide, -1, of_b.node_, 0, 0, over})};
}

}  // namespace oddity::taylor
