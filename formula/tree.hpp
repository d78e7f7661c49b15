#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A formula as a tree. It is read once from text (parse.hpp), evaluated in any number (evaluate.hpp),
/// differentiated, changed (mutants.hpp) and printed (print.hpp, code.hpp). Text in any letters is read to be
/// shown (shown.hpp).
namespace oddity::formula {

enum class Kind {
  number,            ///< text: its digits
  pi,                //
  letter,            ///< text: as the page has it
  variable,          ///< an integral's; text: its name, slots: its place
  index,             ///< a sum's index as a number; slots: its place
  permutation_sign,  //
  sum,               ///< marks: + - p m (plus or minus, minus or plus) of each child
  product,           ///< marks: * / of each child, from left to right; as shown, a space before some
  dot,               ///< of two
  cross,             ///< of two
  fraction,          ///< of two
  power,             ///< of two
  transposed,        ///< x^T; where x is a number: the power, if there is a second child
  function,          ///< text: \sin; as shown, a second child is an exponent
  root,              ///< as shown, a second child is its degree
  bars,              ///< an absolute value, or a vector's length
  tuple,             ///< marks: , or ; before each child: rows of a matrix
  row,               //
  matrix,            ///< of rows
  diagonal,
  skew,
  unskew,
  sum_over,         ///< of the first child, up to the second, if any; slots: the index; range: its values
  permutations,     ///< slots: the places that are permuted; text: their letter
  components,       ///< slots: the free indices; range: their values
  integral,         ///< from, to, integrand; slots: the variable; text: its name
  along_curve,      ///< the integrand, and the letter of the weights
  time_derivative,  ///< of the first child; the second is the derivative
  largest,
  smallest,
  // Of what is only shown (shown.hpp):
  nothing,  ///< where a factor would stand: on the left of \times f
  group,    ///< in brackets; text: the opening one, a space and the closing one
  indexed,  ///< text: the index or the primes behind it
  line,     ///< sides, relations and commas
  sign,     ///< text: =, \le or ,
  large,    ///< text: \sum, \int or \max; below it, and above it if there is a second child
  words,    ///< upright; text: what they say, or a child
  marked    ///< text: "sign" where only the sign before it is
};

struct Node;

/// Nodes are never changed, and shared.
class Tree {
 public:
  explicit Tree(Node node);

  const Node& operator*() const { return *node_; }
  const Node* operator->() const { return node_.get(); }
  const Tree& child(std::size_t i) const;
  Kind kind() const;

  /// The same node with another child.
  Tree with_child(std::size_t i, Tree child) const;

 private:
  std::shared_ptr<const Node> node_;
};

/// A letter's number in the list of letters, at these values of the indices in its name.
struct Entry {
  std::vector<int> indices;
  std::vector<int> rates;  ///< its own number, that of its rate, of the rate's rate ...
  int along = -1;          ///< of a second letter of this name, whose numbers are nodes of a curve
};

struct Node {
  Kind kind = Kind::number;
  std::string text = {};
  std::vector<Tree> children = {};
  std::string marks = {};
  std::vector<std::size_t> slots = {};
  std::vector<Entry> entries = {};
  std::size_t order = 0;  ///< of the rate: 1 where a letter stands for its rate
  std::vector<int> range = {};
};

inline const Tree& Tree::child(std::size_t i) const { return node_->children.at(i); }
inline Kind Tree::kind() const { return node_->kind; }

Tree number(std::string digits);
Tree number(int);
/// A sum or a product; of one child that is added, or a factor, the child itself.
Tree sum(std::vector<Tree> terms, std::string marks);
/// The sum with other terms, whose marks may be those of either sign.
Tree with_terms(const Tree& sum, std::vector<Tree> terms, std::string marks);
Tree product(std::vector<Tree> factors, std::string marks);
Tree made(Kind kind, std::vector<Tree> children, std::string text = {});
Tree negative(const Tree&);

bool is_number(const Tree&, std::string_view digits);
/// The value of a whole number, with its sign. Returns false where it is none.
bool is_whole(const Tree&, int& value);

/// The inverse of a function: \arcsin of \sin. Empty where there is none.
std::string_view inverse_of(std::string_view function);
bool is_function(std::string_view);

/// The letter's rate: \dot x of x, \ddot x of \dot x. Plain names take a prime more.
std::string rate_name(std::string_view letter);

}  // namespace oddity::formula
