#include "reference/make/tape.hpp"

namespace oddity::truth {

namespace {

using Op = Tape::Op;

Jet binary(Op op, Jet a, Jet b) { return {a.tape, a.tape->put({op, a.node, b.node})}; }
Jet unary(Op op, Jet a) { return {a.tape, a.tape->put({op, a.node})}; }
Jet scaled(Jet a, const Number& factor) { return {a.tape, a.tape->put({Op::scale, a.node, -1, factor})}; }
Jet constant(Tape* tape, const Number& x) { return {tape, tape->put({Op::constant, -1, -1, x})}; }

/// Adds sine and cosine, which need each other's series, the sine first.
int sine_node(Jet a) {
  const int sine = a.tape->put({Op::sine, a.node});
  a.tape->put({Op::cosine, a.node, sine});
  return sine;
}

#if defined(ODDITY_NUMBER)
Number convolution(const Numbers& a, const Numbers& b, int k, int from, int to) {
  Number sum = 0;
  for (int j = from; j <= to; ++j) sum += a[static_cast<std::size_t>(j)] * b[static_cast<std::size_t>(k - j)];
  return sum;
}
#elif defined(ODDITY_BALLS)
/// Arb's own dot product, which takes a third of the time.
Number convolution(const Numbers& a, const Numbers& b, int k, int from, int to) {
  if (from > to) return 0;
  return Ball::made([&](arb_ptr sum) {
    arb_dot(sum, nullptr, 0, a[static_cast<std::size_t>(from)].data(), 1,
            b[static_cast<std::size_t>(k - from)].data(), -1, to - from + 1, Ball::bits);
  });
}
#else
/// Direct MPFR calls: a new number for every product would take twice the time.
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

/// Coefficient k of a square, where each product of two different coefficients occurs twice.
Number square(const Numbers& a, int k) {
  const Number twice = 2 * convolution(a, a, k, 0, (k + 1) / 2 - 1);
  const Number& middle = a[static_cast<std::size_t>(k / 2)];
  return k % 2 == 0 ? Number(twice + middle * middle) : twice;
}

/// (1/k) sum of j a_j b_(k-j): coefficient k of the integral of a' b.
#ifdef ODDITY_BALLS
Number integrated_product(const Numbers& a, const Numbers& b, int k) {
  Numbers slope(static_cast<std::size_t>(k) + 1);
  for (int j = 1; j <= k; ++j)
    arb_mul_si(slope[static_cast<std::size_t>(j)].data(), a[static_cast<std::size_t>(j)].data(), j,
               Ball::bits);
  return convolution(slope, b, k, 1, k) / k;
}
#else
Number integrated_product(const Numbers& a, const Numbers& b, int k) {
  Number sum = 0;
  for (int j = 1; j <= k; ++j) sum += j * a[static_cast<std::size_t>(j)] * b[static_cast<std::size_t>(k - j)];
  return sum / k;
}
#endif

}  // namespace

int Tape::put(Node node) {
  const int place = static_cast<int>(nodes_.size());
  const bool is_computed = node.op != Op::variable && node.op != Op::constant && node.op != Op::scale;
  if (is_computed) {
    const auto [before, is_new] = computed_.try_emplace({node.op, node.a, node.b}, place);
    if (!is_new) return before->second;
  }
  nodes_.push_back(std::move(node));
  return place;
}

void Tape::resize(int order) {
  const auto terms = static_cast<std::size_t>(order) + 1;
  // Series of the same length are overwritten: every term is written before it is read.
  if (!series_.empty() && series_.front().size() == terms) return;
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
      return node.a == node.b ? square(at(node.a), k) : convolution(at(node.a), at(node.b), k, 0, k);
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

}  // namespace oddity::truth
