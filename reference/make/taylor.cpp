#include "reference/make/taylor.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "reference/text.hpp"

namespace oddity::truth {

namespace {

using Op = Tape::Op;

Jet binary(Op op, Jet a, Jet b) { return {a.tape, a.tape->put({op, a.node, b.node})}; }
Jet unary(Op op, Jet a) { return {a.tape, a.tape->put({op, a.node})}; }
Jet scaled(Jet a, const Number& factor) { return {a.tape, a.tape->put({Op::scale, a.node, -1, factor})}; }
Jet constant(Tape* tape, const Number& x) { return {tape, tape->put({Op::constant, -1, -1, x})}; }

/// Sine and cosine need each other's series, so both are put, the sine first.
int sine_node(Jet a) {
  const int sine = a.tape->put({Op::sine, a.node});
  a.tape->put({Op::cosine, a.node, sine});
  return sine;
}

#ifdef ODDITY_LONG_DOUBLE
Number convolution(const Numbers& a, const Numbers& b, int k, int from, int to) {
  Number sum = 0;
  for (int j = from; j <= to; ++j) sum += a[static_cast<std::size_t>(j)] * b[static_cast<std::size_t>(k - j)];
  return sum;
}
#else
/// MPFR's own calls: with a new number for every product this would take twice the time.
Number convolution(const Numbers& a, const Numbers& b, int k, int from, int to) {
  Number sum = 0, product;
  for (int j = from; j <= to; ++j) {
    mpfr_mul(product.backend().data(), a[static_cast<std::size_t>(j)].backend().data(),
             b[static_cast<std::size_t>(k - j)].backend().data(), MPFR_RNDN);
    mpfr_add(sum.backend().data(), sum.backend().data(), product.backend().data(), MPFR_RNDN);
  }
  return sum;
}
#endif

/// (1/k) sum of j a_j b_(k-j): coefficient k of the integral of a' b.
Number integrated_product(const Numbers& a, const Numbers& b, int k) {
  Number sum = 0;
  for (int j = 1; j <= k; ++j) sum += j * a[static_cast<std::size_t>(j)] * b[static_cast<std::size_t>(k - j)];
  return sum / k;
}

}  // namespace

int Tape::put(Node node) {
  nodes_.push_back(std::move(node));
  return static_cast<int>(nodes_.size()) - 1;
}

void Tape::resize(int order) {
  const auto terms = static_cast<std::size_t>(order) + 1;
  // Series of the same length are written over: every term is, before it is read.
  if (series_.size() == nodes_.size() && !series_.empty() && series_.front().size() == terms) return;
  series_.assign(nodes_.size(), Numbers(terms));
}

void Tape::advance(int k) {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].op != Op::variable) series_[i][static_cast<std::size_t>(k)] = coefficient(i, k);
}

Number Tape::coefficient(std::size_t i, int k) const {
  const Node& node = nodes_[i];
  const auto at = [&](int n) -> const Numbers& { return series_[static_cast<std::size_t>(n)]; };
  const auto index = static_cast<std::size_t>(k);
  const Numbers& self = series_[i];
  switch (node.op) {
    case Op::constant:
      return k == 0 ? node.constant : Number(0);
    case Op::add:
      return at(node.a)[index] + at(node.b)[index];
    case Op::subtract:
      return at(node.a)[index] - at(node.b)[index];
    case Op::scale:
      return node.constant * at(node.a)[index];
    case Op::multiply:
      return convolution(at(node.a), at(node.b), k, 0, k);
    case Op::divide:
      return (at(node.a)[index] - convolution(at(node.b), self, k, 1, k)) / at(node.b)[0];
    case Op::square_root:
      return k == 0 ? sqrt(at(node.a)[0])
                    : Number((at(node.a)[index] - convolution(self, self, k, 1, k - 1)) / (2 * self[0]));
    case Op::exponential:
      return k == 0 ? exp(at(node.a)[0]) : integrated_product(at(node.a), self, k);
    case Op::sine:
      return k == 0 ? sin(at(node.a)[0]) : integrated_product(at(node.a), series_[i + 1], k);
    case Op::cosine:
      return k == 0 ? cos(at(node.a)[0]) : Number(-integrated_product(at(node.a), at(node.b), k));
    case Op::variable:
      break;
  }
  return self[index];
}

Jet operator+(Jet a, Jet b) { return binary(Op::add, a, b); }
Jet operator-(Jet a, Jet b) { return binary(Op::subtract, a, b); }
Jet operator*(Jet a, Jet b) { return binary(Op::multiply, a, b); }
Jet operator/(Jet a, Jet b) { return binary(Op::divide, a, b); }
Jet operator+(Jet a, const Number& x) { return a + constant(a.tape, x); }
Jet operator+(const Number& x, Jet a) { return a + x; }
Jet operator-(Jet a, const Number& x) { return a + Number(-x); }
Jet operator-(const Number& x, Jet a) { return constant(a.tape, x) - a; }
Jet operator*(Jet a, const Number& x) { return scaled(a, x); }
Jet operator*(const Number& x, Jet a) { return scaled(a, x); }
Jet operator/(Jet a, const Number& x) { return scaled(a, 1 / x); }
Jet operator/(const Number& x, Jet a) { return constant(a.tape, x) / a; }
Jet operator-(Jet a) { return scaled(a, -1); }
Jet sqrt(Jet a) { return unary(Op::square_root, a); }
Jet exp(Jet a) { return unary(Op::exponential, a); }
Jet sin(Jet a) { return {a.tape, sine_node(a)}; }
Jet cos(Jet a) { return {a.tape, sine_node(a) + 1}; }

/// Fills the tape with the series about (x, t); returns the step that its last quarter of terms allows: of
/// fewer all may vanish, as of exp(t^5) about zero.
Number TaylorProblem::expand(const Numbers& x, const Number& t, int order, const Number& tolerance) {
  tape_.resize(order);
  for (std::size_t i = 0; i < x.size(); ++i) tape_.set(unknowns_[i], 0, x[i]);
  tape_.set(time_, 0, t);
  tape_.set(time_, 1, 1);
  for (int k = 0; k < order; ++k) {
    tape_.advance(k);
    for (std::size_t i = 0; i < x.size(); ++i)
      tape_.set(unknowns_[i], k + 1, tape_.get(derivatives_[i], k) / (k + 1));
  }
  double growth = 0;  // of the coefficients, from order to order
  for (int k = order - order / 4; k <= order; ++k) {
    Number largest = 0;
    for (int unknown : unknowns_) largest = std::max<Number>(largest, abs(tape_.get(unknown, k)));
    if (largest > 0) growth = std::max(growth, static_cast<double>(exp(log(largest) / k)));
  }
  return Number(0.9 * static_cast<double>(exp(log(tolerance) / order)) / growth);
}

TaylorProblem::Step TaylorProblem::step(const Numbers& x, const Number& t, const Number& t1, int digits) {
  const int order = digits + digits / 4 + 4;
  Step step{t, expand(x, t, order, pow(Number(10), -digits - 4)), {}};
  if (step.length < abs(Number(t1 - t)) * pow(Number(10), -20))
    throw std::runtime_error("Taylor series: the step became too small");
  for (int unknown : unknowns_) step.series.push_back(tape_.series(unknown));
  return step;
}

Numbers TaylorProblem::Step::at(const Number& t) const {
  const Number h = t - t0;
  Numbers x;
  for (const Numbers& c : series) {
    Number sum = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;) sum = sum * h + c[k];
    x.push_back(sum);
  }
  return x;
}

namespace {

void require_budget(long spent, long budget, const Number& t, const Number& t1) {
  if (spent >= budget)
    throw BudgetSpent("Taylor series: the budget of " + std::to_string(budget) +
                      " expansions of the right-hand side is spent at t = " +
                      rounded(static_cast<double>(t), 6) + " of " + rounded(static_cast<double>(t1), 6));
}

}  // namespace

Numbers TaylorProblem::solve(Numbers x, Number t0, const Number& t1, int digits, long budget) {
  for (long spent = 0; t0 != t1; ++spent) {
    require_budget(spent, budget, t0, t1);
    const Step next = step(x, t0, t1, digits);
    const Number left = t1 - t0;
    const bool last = abs(left) <= next.length;
    const Number end = last ? t1 : left > 0 ? Number(t0 + next.length) : Number(t0 - next.length);
    x = next.at(end);
    t0 = end;
  }
  return x;
}

Numbers TaylorPath::at(const Number& t, const Motions& request) {
  const Number start = steps_.empty() ? t_ : steps_.front().t0;
  while (steps_.empty() || abs(t - start) > abs(t_ - start)) {
    request.tick();
    require_budget(static_cast<long>(steps_.size()), most_expansions * request.allowance(), t_, t);
    steps_.push_back(problem_.step(x_, t_, t, digits_));
    const Number& length = steps_.back().length;
    t_ = t > start ? Number(t_ + length) : Number(t_ - length);
    x_ = steps_.back().at(t_);
  }
  const auto begins_before = [&](const TaylorProblem::Step& step) {
    return abs(step.t0 - start) <= abs(t - start);
  };
  return std::prev(std::ranges::partition_point(steps_, begins_before))->at(t);
}

}  // namespace oddity::truth
