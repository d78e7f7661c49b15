#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

/// Taylor series of a right-hand side by recording it once: each operation becomes a node, and the
/// coefficients of order k of all nodes follow, in their order, from those of lower order [Moore, Interval
/// Analysis, 1966, chapter 11; Jorba and Zou, Experimental Mathematics 14 (2005), 99-117].
namespace oddity::taylor {

enum class Operation { variable, add, subtract, multiply, divide, square_root, sine, cosine, exponential };

/// What a node takes: another node, or where there is none a constant.
template <class T>
struct Operand {
  int node = -1;
  T constant{};
};

template <class T>
class Tape {
 public:
  int variable() { return put(Operation::variable, {}, {}); }
  int put(Operation operation, Operand<T> a, Operand<T> b) {
    nodes_.push_back({operation, a, b, {}});
    return static_cast<int>(nodes_.size()) - 1;
  }
  /// The sine's node; the cosine's is the next.
  int sine_and_cosine(int of) {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].operation == Operation::sine && nodes_[i].a.node == of) return static_cast<int>(i);
    const int sine = put(Operation::sine, {of}, {static_cast<int>(nodes_.size()) + 1});
    put(Operation::cosine, {of}, {sine});
    return sine;
  }
  /// Room for the coefficients up to this order.
  void resize(int order) {
    for (Node& node : nodes_) node.series.resize(static_cast<std::size_t>(order) + 1);
  }
  /// Coefficient k of every node but the variables, those of lower order being known.
  void advance(int k) {
    for (Node& node : nodes_)
      if (node.operation != Operation::variable)
        node.series[static_cast<std::size_t>(k)] = coefficient(node, k);
  }
  T& at(int node, int k) {
    return nodes_[static_cast<std::size_t>(node)].series[static_cast<std::size_t>(k)];
  }
  const std::vector<T>& series(int node) const { return nodes_[static_cast<std::size_t>(node)].series; }
  T at(const Operand<T>& a, int k) const {
    if (a.node >= 0) return nodes_[static_cast<std::size_t>(a.node)].series[static_cast<std::size_t>(k)];
    return k == 0 ? a.constant : T(0);
  }

 private:
  struct Node {
    Operation operation;
    Operand<T> a, b;  ///< of a sine or a cosine b is the other of the two
    std::vector<T> series;
  };

  T own(const Node& node, int k) const { return node.series[static_cast<std::size_t>(k)]; }

  /// sum over j = 1..k of j a_j b_(k-j), over k: the derivative of an inner function times an outer one.
  T chained(const Operand<T>& a, const Operand<T>& b, int k) const {
    T sum(0);
    for (int j = 1; j <= k; ++j) sum += T(j) * at(a, j) * at(b, k - j);
    return sum / T(k);
  }

  T coefficient(const Node& node, int k) const {
    using std::cos, std::exp, std::sin, std::sqrt;
    const auto& [operation, a, b, series] = node;
    switch (operation) {
      case Operation::add:
        return at(a, k) + at(b, k);
      case Operation::subtract:
        return at(a, k) - at(b, k);
      case Operation::multiply:
        return product(a, b, k);
      case Operation::divide: {
        T rest = at(a, k);
        for (int j = 1; j <= k; ++j) rest -= at(b, j) * own(node, k - j);
        return rest / at(b, 0);
      }
      case Operation::square_root: {
        if (k == 0) return sqrt(at(a, 0));
        T rest = at(a, k);
        for (int j = 1; j < k; ++j) rest -= own(node, j) * own(node, k - j);
        return rest / (T(2) * own(node, 0));
      }
      case Operation::sine:
        return k == 0 ? sin(at(a, 0)) : chained(a, b, k);
      case Operation::cosine:
        return k == 0 ? cos(at(a, 0)) : -chained(a, b, k);
      case Operation::exponential: {
        if (k == 0) return exp(at(a, 0));
        T sum(0);
        for (int j = 1; j <= k; ++j) sum += T(j) * at(a, j) * own(node, k - j);
        return sum / T(k);
      }
      case Operation::variable:
        break;
    }
    return own(node, k);
  }
  T product(const Operand<T>& a, const Operand<T>& b, int k) const {
    if (a.node < 0) return a.constant * at(b, k);
    if (b.node < 0) return at(a, k) * b.constant;
    T sum(0);
    for (int j = 0; j <= k; ++j) sum += at(a, j) * at(b, k - j);
    return sum;
  }

  std::vector<Node> nodes_;
};

/// A number on a tape, or a constant beside it.
template <class T>
class Recorded {
 public:
  Recorded() = default;
  Recorded(const T& constant) : at_{-1, constant} {}
  template <class U>
  requires(std::is_arithmetic_v<U> && !std::is_same_v<U, T>) Recorded(U constant)
      : at_{-1, static_cast<T>(constant)} {}
  Recorded(Tape<T>& tape, int node) : tape_(&tape), at_{node, T(0)} {}

  int node() const { return at_.node; }
  const Operand<T>& operand() const { return at_; }

  friend Recorded operator+(const Recorded& a, const Recorded& b) {
    return a.constant() && b.constant() ? Recorded(a.at_.constant + b.at_.constant)
                                        : put(Operation::add, a, b);
  }
  friend Recorded operator-(const Recorded& a, const Recorded& b) {
    return a.constant() && b.constant() ? Recorded(a.at_.constant - b.at_.constant)
                                        : put(Operation::subtract, a, b);
  }
  friend Recorded operator*(const Recorded& a, const Recorded& b) {
    return a.constant() && b.constant() ? Recorded(a.at_.constant * b.at_.constant)
                                        : put(Operation::multiply, a, b);
  }
  friend Recorded operator/(const Recorded& a, const Recorded& b) {
    return a.constant() && b.constant() ? Recorded(a.at_.constant / b.at_.constant)
                                        : put(Operation::divide, a, b);
  }
  friend Recorded operator-(const Recorded& a) { return Recorded(T(0)) - a; }
  Recorded& operator+=(const Recorded& b) { return *this = *this + b; }
  Recorded& operator-=(const Recorded& b) { return *this = *this - b; }
  Recorded& operator*=(const Recorded& b) { return *this = *this * b; }
  Recorded& operator/=(const Recorded& b) { return *this = *this / b; }

  friend Recorded sqrt(const Recorded& a) {
    using std::sqrt;
    return a.constant() ? Recorded(T(sqrt(a.at_.constant))) : put(Operation::square_root, a, Recorded());
  }
  friend Recorded exp(const Recorded& a) {
    using std::exp;
    return a.constant() ? Recorded(T(exp(a.at_.constant))) : put(Operation::exponential, a, Recorded());
  }
  friend Recorded sin(const Recorded& a) {
    using std::sin;
    return a.constant() ? Recorded(T(sin(a.at_.constant)))
                        : Recorded(*a.tape_, a.tape_->sine_and_cosine(a.at_.node));
  }
  friend Recorded cos(const Recorded& a) {
    using std::cos;
    return a.constant() ? Recorded(T(cos(a.at_.constant)))
                        : Recorded(*a.tape_, a.tape_->sine_and_cosine(a.at_.node) + 1);
  }
  friend Recorded hypot(const Recorded& x, const Recorded& y) { return sqrt(x * x + y * y); }

 private:
  bool constant() const { return at_.node < 0; }
  static Recorded put(Operation operation, const Recorded& a, const Recorded& b) {
    Tape<T>& tape = *(a.tape_ ? a.tape_ : b.tape_);
    return {tape, tape.put(operation, a.at_, b.at_)};
  }

  Tape<T>* tape_ = nullptr;
  Operand<T> at_{};
};

/// The series of a motion dxdt = rhs(x, t) of n unknowns, in numbers of type T.
template <class T, std::size_t n>
class Series {
 public:
  /// Records rhs(x, dxdt, t), which is generic in its number type.
  template <class Rhs>
  explicit Series(const Rhs& rhs) {
    std::array<Recorded<T>, n> x;
    for (std::size_t i = 0; i < n; ++i) x[i] = {tape_, unknowns_[i] = tape_.variable()};
    time_ = tape_.variable();
    std::array<Recorded<T>, n> dxdt;
    rhs(x, dxdt, Recorded<T>(tape_, time_));
    for (std::size_t i = 0; i < n; ++i) derivatives_[i] = dxdt[i].operand();
  }

  /// The coefficients from order 0 to `order` about (x, t).
  std::array<std::vector<T>, n> about(const std::array<T, n>& x, const T& t, int order) {
    tape_.resize(order);
    for (std::size_t i = 0; i < n; ++i) tape_.at(unknowns_[i], 0) = x[i];
    for (int k = 0; k <= order; ++k) tape_.at(time_, k) = k == 0 ? t : T(k == 1 ? 1 : 0);
    for (int k = 0; k < order; ++k) {
      tape_.advance(k);
      for (std::size_t i = 0; i < n; ++i)
        tape_.at(unknowns_[i], k + 1) = tape_.at(derivatives_[i], k) / T(k + 1);
    }
    std::array<std::vector<T>, n> all;
    for (std::size_t i = 0; i < n; ++i) all[i] = tape_.series(unknowns_[i]);
    return all;
  }

 private:
  Tape<T> tape_;
  std::array<int, n> unknowns_{};
  std::array<Operand<T>, n> derivatives_{};
  int time_ = -1;
};

/// The polynomial of these coefficients at h.
template <class T>
T polynomial(const std::vector<T>& series, const T& h) {
  T sum(0);
  for (std::size_t k = series.size(); k-- > 0;) sum = sum * h + series[k];
  return sum;
}

}  // namespace oddity::taylor
