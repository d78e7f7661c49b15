#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A formula as a tree. It is read once from text (parse.hpp), evaluated in any number type (evaluate.hpp),
/// differentiated, changed (mutants.hpp) and printed (print.hpp, code.hpp). shown.hpp reads formulas in any
/// letters for display only.
namespace oddity::formula {

enum class Kind {
  number,            ///< text: the digits
  pi,                //
  letter,            ///< text: its name in TeX
  variable,          ///< an integral's; text: its name, slots: its place
  index,             ///< a sum's index as a number; slots: its place
  permutation_sign,  //
  sum,               ///< marks: + - p m (plus or minus, minus or plus) of each child
  product,           ///< marks: * / of each child, from left to right; if shown, a space before some
  dot,               ///< two children
  cross,             ///< two children
  fraction,          ///< two children
  power,             ///< two children
  transposed,        ///< x^T; for a number x: the power, if there is a second child
  function,          ///< text: \sin; if shown, a second child is an exponent
  root,              ///< if shown, a second child is its degree
  bars,              ///< an absolute value, or a vector's length
  tuple,             ///< marks: , or ; before each child: rows of a matrix
  row,               //
  matrix,            ///< children: rows
  diagonal,
  skew,
  unskew,
  sum_over,         ///< sum of the first child, up to the second, if any; slots: the index; range: its values
  permutations,     ///< slots: the permuted places; text: their letter
  components,       ///< slots: the free indices; range: their values
  integral,         ///< from, to, integrand; slots: the variable; text: its name
  along_curve,      ///< the integrand, and the letter of the weights
  time_derivative,  ///< first child: the argument; second: its derivative
  largest,
  smallest,
  // Only in shown formulas (shown.hpp):
  nothing,  ///< a missing factor: on the left of \times f
  group,    ///< in brackets; text: the opening one, a space and the closing one
  indexed,  ///< text: the index or the primes behind it
  line,     ///< sides, relations and commas
  sign,     ///< text: =, \le or ,
  large,    ///< text: \sum, \int or \max; children: the lower limit, and the upper one if any
  words,    ///< upright; text: the words, or a child
  marked    ///< text: "sign" if only the sign before it is marked
};

struct Node;

/// Nodes are immutable and shared.
class Tree {
 public:
  explicit Tree(Node node);

  const Node& operator*() const { return *node_; }
  const Node* operator->() const { return node_.get(); }
  const Tree& child(std::size_t i) const;
  Kind kind() const;

  /// This node with child i replaced.
  Tree with_child(std::size_t i, Tree child) const;

 private:
  std::shared_ptr<const Node> node_;
};

/// A letter's number in the list of letters, for these values of the indices in its name.
struct Entry {
  std::vector<int> indices;
  std::vector<int> rates;  ///< its own number, those of its rate, its second rate ...
  int along = -1;          ///< number of a second letter of this name, which holds the nodes of a curve
};

struct Node {
  Kind kind = Kind::number;
  std::string text = {};
  std::vector<Tree> children = {};
  std::string marks = {};
  std::vector<std::size_t> slots = {};
  std::vector<Entry> entries = {};
  std::size_t order = 0;  ///< order of the rate: 1 if the letter represents its rate
  std::vector<int> range = {};
};

inline const Tree& Tree::child(std::size_t i) const { return node_->children.at(i); }
inline Kind Tree::kind() const { return node_->kind; }

Tree number(std::string digits);
Tree number(int);
/// A sum or a product; if it has only one child that is added, or a factor, the child itself.
Tree sum(std::vector<Tree> terms, std::string marks);
/// The sum with other terms, whose marks may come from either sign.
Tree with_terms(const Tree& sum, std::vector<Tree> terms, std::string marks);
Tree product(std::vector<Tree> factors, std::string marks);
Tree made(Kind kind, std::vector<Tree> children, std::string text = {});
Tree negative(const Tree&);

bool is_number(const Tree&, std::string_view digits);
/// The value of an integer, with its sign. Returns false for anything else.
bool is_whole(const Tree&, int& value);

/// The inverse of a function: \arcsin for \sin; empty if it has none.
std::string_view inverse_of(std::string_view function);
bool is_function(std::string_view);

/// The letter's rate: \dot x for x, \ddot x for \dot x. Plain names take one more prime.
std::string rate_name(std::string_view letter);

}  // namespace oddity::formula
