#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "reference/truth.hpp"

/// Right-hand sides recorded once on a tape. Its nodes then give the coefficients of their Taylor series,
/// order by order.
namespace oddity::truth {

/// The record of a right-hand side.
class Tape {
 public:
  enum class Op {
    constant,
    variable,
    add,
    subtract,
    multiply,
    divide,
    scale,
    square_root,
    sine,
    cosine,
    exponential
  };
  struct Node {
    Op op;
    int a = -1;  ///< operand
    int b = -1;  ///< second operand; for sine and cosine, the other of the pair
    Number constant = 0;
  };

  /// Index of the node. Without a constant, returns an earlier node with the same operands if there is one.
  int put(Node node);
  /// Computes coefficient k of every node from those below k.
  void advance(int k);
  void set(int node, int k, Number x) {
    series_[static_cast<std::size_t>(node)][static_cast<std::size_t>(k)] = std::move(x);
  }
  const Number& get(int node, int k) const {
    return series_[static_cast<std::size_t>(node)][static_cast<std::size_t>(k)];
  }
  const Numbers& series(int node) const { return series_[static_cast<std::size_t>(node)]; }
  void resize(int order);
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  Number coefficient(std::size_t node, int k) const;
  std::vector<Node> nodes_;
  std::map<std::tuple<Op, int, int>, int> computed_;  ///< indices of nodes without a constant
  std::vector<Numbers> series_;
};

/// A number on a tape; right-hand sides are generic in their number type and accept it as well as Number.
struct Jet {
  Tape* tape = nullptr;
  int node = -1;
};

Jet operator+(Jet, Jet);
Jet operator-(Jet, Jet);
Jet operator*(Jet, Jet);
Jet operator/(Jet, Jet);
Jet operator+(Jet, const Number&);
Jet operator+(const Number&, Jet);
Jet operator-(Jet, const Number&);
Jet operator-(const Number&, Jet);
Jet operator*(Jet, const Number&);
Jet operator*(const Number&, Jet);
Jet operator/(Jet, const Number&);
Jet operator/(const Number&, Jet);
Jet operator-(Jet);
Jet sqrt(Jet);
Jet sin(Jet);
Jet cos(Jet);
Jet exp(Jet);

}  // namespace oddity::truth
