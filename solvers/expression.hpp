#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <vector>

/// A number type that records how a value is computed, so that the text of a formula is printed from the very
/// code that computes it.
namespace oddity {

class Expression {
 public:
  /// A whole number, or a double of few binary places: exactly. Throws std::logic_error where the double is
  /// none of these, since it may stand for another number that was rounded.
  template <class T>
  requires std::integral<T> || std::floating_point<T> Expression(T value)
      : Expression(exact(static_cast<double>(value))) {}

  static Expression letter(const std::string& name);
  static Expression pi();
  /// A number as it is written, such as "0.800275". Throws std::logic_error where it is no decimal of at most
  /// 15 digits.
  static Expression decimal(const std::string& written);

  friend Expression operator+(const Expression& a, const Expression& b) { return {"+", {a, b}}; }
  friend Expression operator-(const Expression& a, const Expression& b) { return {"-", {a, b}}; }
  friend Expression operator*(const Expression& a, const Expression& b) { return {"*", {a, b}}; }
  friend Expression operator/(const Expression& a, const Expression& b) { return {"/", {a, b}}; }
  friend Expression operator-(const Expression& a) { return Expression(0) - a; }
  friend Expression abs(const Expression& a) { return {"abs", {a}}; }
  friend Expression cbrt(const Expression& a) { return {"cbrt", {a}}; }
  friend Expression sqrt(const Expression& a) { return {"sqrt", {a}}; }
  friend Expression sin(const Expression& a) { return {"sin", {a}}; }
  friend Expression cos(const Expression& a) { return {"cos", {a}}; }
  friend Expression exp(const Expression& a) { return {"exp", {a}}; }
  friend Expression log(const Expression& a) { return {"log", {a}}; }
  friend Expression atan(const Expression& a) { return {"atan", {a}}; }

  /// The integral of body(x) over x from a to b. Throws std::logic_error where the body has an integral
  /// itself: their letters could be the same.
  template <class Body>
  friend Expression integral(const Body& body, const Expression& a, const Expression& b) {
    const Expression x = letter("x" + std::to_string(a.depth() + b.depth()));
    const Expression inside = body(x);
    inside.require_no_integral();
    return {"integral", {x, inside, a, b}};
  }

  std::string coq() const;   ///< over the reals, with Coquelicot's RInt
  std::string pari() const;  ///< for PARI/GP

 private:
  struct Node {
    std::string what;  ///< the operation, or a letter
    std::vector<Expression> of;
    bool leaf() const { return of.empty(); }
  };
  Expression(std::string what, std::vector<Expression> of);

  static Expression exact(double);
  static Expression whole(const std::string& digits);
  std::size_t depth() const;
  void require_no_integral() const;
  std::string infix(std::string (Expression::*text)() const) const;
  bool is_infix() const {
    return !node_->leaf() && std::string("+-*/").find(node_->what) != std::string::npos;
  }

  std::shared_ptr<const Node> node_;
};

}  // namespace oddity
