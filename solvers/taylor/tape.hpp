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

enum class Operation {
  unknown,
  linear,        ///< alpha a + beta b + gamma; b may be none
  multiply,      ///< a b
  divide,        ///< a / b; where a is none, gamma / b
  inverse_cube,  ///< gamma / (a sqrt(a)), a mass's pull where a is the distance's square
  square_root,
  sine,     ///< of a; the next node is its cosine
  cosine,   ///< of a; the node before is its sine
  turning,  ///< the sine of alpha a + gamma, where a is the time; a program has it, no tape
  exponential
};

/// a and b are other nodes; none: -1.
struct Node {
  Operation operation;
  int a = -1, b = -1;
  double alpha = 0, beta = 0, gamma = 0;

  bool operator==(const Node&) const = default;
};

/// The operations of a right-hand side in their order, each that is repeated once, constants computed.
class Tape {
 public:
  /// The node, or the one that is there already.
  int put(const Node& node);
  /// A new unknown's.
  int unknown();
  /// The sine's node; the cosine's is the next.
  int sine_and_cosine(int of);
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  std::vector<Node> nodes_;
};

/// A multiple of a number on a tape, and a term beside it, neither of which takes an operation before another
/// needs it; or a constant.
class Recorded {
 public:
  Recorded() = default;
  template <class U>
  requires(std::is_arithmetic_v<U>) Recorded(U constant) : term_(static_cast<double>(constant)) {}
  Recorded(Tape& tape, int node, double factor = 1) : tape_(&tape), node_(node), factor_(factor) {}

  int node() const { return node_; }  ///< -1: a constant
  double factor() const { return factor_; }
  double term() const { return term_; }
  /// The same as a multiple, or as a constant.
  Recorded multiple() const;

  friend Recorded operator+(const Recorded& a, const Recorded& b) { return sum(a, b); }
  friend Recorded operator-(const Recorded& a, const Recorded& b) { return sum(a, -b); }
  friend Recorded operator-(const Recorded& a) { return a.times(-1); }
  friend Recorded operator*(const Recorded& a, const Recorded& b) { return product(a, b); }
  friend Recorded operator/(const Recorded& a, const Recorded& b) { return quotient(a, b); }
  Recorded& operator+=(const Recorded& b) { return *this = *this + b; }
  Recorded& operator-=(const Recorded& b) { return *this = *this - b; }
  Recorded& operator*=(const Recorded& b) { return *this = *this * b; }
  Recorded& operator/=(const Recorded& b) { return *this = *this / b; }

  friend Recorded sqrt(const Recorded& a) {
    return a.is_constant() ? std::sqrt(a.term_) : a.under(Operation::square_root);
  }
  friend Recorded exp(const Recorded& a) {
    return a.is_constant() ? std::exp(a.term_) : a.under(Operation::exponential);
  }
  friend Recorded sin(const Recorded& a) {
    return a.is_constant() ? std::sin(a.term_) : Recorded(*a.tape_, a.tape_->sine_and_cosine(a.whole()));
  }
  friend Recorded cos(const Recorded& a) {
    return a.is_constant() ? std::cos(a.term_) : Recorded(*a.tape_, a.tape_->sine_and_cosine(a.whole()) + 1);
  }
  friend Recorded hypot(const Recorded& x, const Recorded& y) { return sqrt(x * x + y * y); }

 private:
  bool is_constant() const { return node_ < 0; }
  Recorded times(double scale) const;
  Recorded plus(double term) const;
  /// The node of factor * it + term.
  int node_of(double factor, double term) const;
  /// The node of all of it.
  int whole() const { return node_of(factor_, term_); }
  Recorded under(Operation operation) const { return {*tape_, tape_->put({operation, whole()})}; }

  static Recorded sum(const Recorded& a, const Recorded& b);
  static Recorded product(const Recorded& a, const Recorded& b);
  static Recorded quotient(const Recorded& a, const Recorded& b);

  Tape* tape_ = nullptr;
  int node_ = -1;
  double factor_ = 0, term_ = 0;
};

/// A right-hand side as it was recorded: its unknowns are the tape's first nodes, time the next.
struct Recording {
  Tape tape;
  std::vector<Recorded> derivatives;  ///< multiples of nodes, or constants
};

/// rhs(x, dxdt, t) of n unknowns, which is generic in its number type.
template <std::size_t n, class Rhs>
Recording record(const Rhs& rhs) {
  Recording made;
  std::array<Recorded, n> x, dxdt;
  for (Recorded& one : x) one = {made.tape, made.tape.unknown()};
  const Recorded time(made.tape, made.tape.unknown());
  rhs(x, dxdt, time);
  made.derivatives.reserve(n);
  for (const Recorded& one : dxdt) made.derivatives.push_back(one.multiple());
  return made;
}

}  // namespace oddity::taylor
