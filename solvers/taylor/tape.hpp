#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

/// Taylor series of a right-hand side by recording it once. Each operation becomes a node. The coefficients
/// of order k of all nodes follow, in their order, from those of lower order. See [Moore, Interval Analysis,
/// 1966, chapter 11; Jorba and Zou, Experimental Mathematics 14 (2005), 99-117].
namespace oddity::taylor {

enum class Operation {
  unknown,
  linear,        ///< alpha a + beta b + gamma; b may be none
  multiply,      ///< a b
  divide,        ///< a / b; gamma / b without an a
  inverse_cube,  ///< gamma / (a sqrt(a)): a mass's pull, with a the distance squared
  square_root,
  sine,     ///< sine of a; the next node is its cosine
  cosine,   ///< cosine of a; the node before is its sine
  turning,  ///< sine of alpha a + gamma, with a the time; in programs only, not on tapes
  exponential
};

/// a and b are other nodes; none: -1.
struct Node {
  Operation operation;
  int a = -1, b = -1;
  double alpha = 0, beta = 0, gamma = 0;

  bool operator==(const Node&) const = default;
};

/// The operations of a right-hand side in their order, without repeats, constants computed.
class Tape {
 public:
  /// The node's index; adds the node if it is new.
  int put(const Node& node);
  /// Adds an unknown's node.
  int unknown();
  /// Adds both; returns the sine's node, which the cosine's follows.
  int sine_and_cosine(int of);
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  std::vector<Node> nodes_;
};

/// A multiple of a node plus a term, which become operations only when another operation needs them; or a
/// constant.
class Recorded {
 public:
  Recorded() = default;
  template <class U>
  requires(std::is_arithmetic_v<U>) Recorded(U constant) : term_(static_cast<double>(constant)) {}
  Recorded(Tape& tape, int node, double factor = 1) : tape_(&tape), node_(node), factor_(factor) {}

  int node() const { return node_; }  ///< -1: a constant
  double factor() const { return factor_; }
  double term() const { return term_; }
  /// This number without a term: a multiple of a node, or a constant.
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
  /// The node of factor * node + term.
  int node_of(double factor, double term) const;
  /// The node of the whole number.
  int whole() const { return node_of(factor_, term_); }
  Recorded under(Operation operation) const { return {*tape_, tape_->put({operation, whole()})}; }

  static Recorded sum(const Recorded& a, const Recorded& b);
  static Recorded product(const Recorded& a, const Recorded& b);
  static Recorded quotient(const Recorded& a, const Recorded& b);

  Tape* tape_ = nullptr;
  int node_ = -1;
  double factor_ = 0, term_ = 0;
};

/// A recorded right-hand side: the tape's first nodes are its unknowns, the next is time.
struct Recording {
  Tape tape;
  std::vector<Recorded> derivatives;  ///< multiples of nodes, or constants
};

/// Records rhs(x, dxdt, t) of n unknowns, which is generic in its number type.
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
