#include "problem/shape.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "formula/evaluate.hpp"

namespace oddity::problem {

namespace {

using formula::Kind, formula::Tree;

class Search {
 public:
  explicit Search(const std::vector<Shape>& letters) : letters_(letters) {}

  /// The smallest part that has no value; nothing if all have one.
  const Tree* smallest(const Tree& x) const {
    if (shape(x)) return nullptr;
    if (!has_indices(x))
      for (const Tree& child : x->children)
        if (const Tree* part = smallest(child)) return part;
    return &x;
  }
  /// The smallest sum or dot product of different rows and columns; nothing if all are of the same.
  const Tree* uneven(const Tree& x) const {
    if (has_indices(x) || x.kind() == Kind::time_derivative || !has_several(x)) return nullptr;
    for (const Tree& child : x->children)
      if (const Tree* part = uneven(child)) return part;
    return is_uneven(x) ? &x : nullptr;
  }
  /// The reason why this part has no value although its own parts have one.
  Misfit reason(const Tree& x, const std::string& otherwise) const {
    switch (x.kind()) {
      case Kind::sum:
        return of_sum(x);
      case Kind::product:
        return of_product(x);
      case Kind::fraction:
        return at(x.child(1), "divide by a number: this is " + name(x.child(1)));
      case Kind::dot:
        return at(x, "dot takes two vectors of one length, and not " + name(x.child(0)) + " and " +
                         name(x.child(1)));
      case Kind::cross:
        return at(x,
                  "cross takes two vectors of 3, and not " + name(x.child(0)) + " and " + name(x.child(1)));
      case Kind::power:
        return at(
            x, "a power is of a number, and this is " + name(x.child(0)) +
                   (shape(x.child(0))->columns > 1 ? ": write a product" : ": write dot(v, v) or abs(v)^2"));
      case Kind::function:
      case Kind::root:
        return at(x, (x.kind() == Kind::root ? "sqrt" : x->text.substr(1)) + " takes a number, and this is " +
                         name(x.child(0)));
      default:
        return at(x, otherwise);
    }
  }

 private:
  static Misfit at(const Tree& x, std::string says) {
    Misfit found{std::move(says)};
    add_letters(x, found.letters);
    return found;
  }
  static void add_letters(const Tree& x, std::vector<std::size_t>& all) {
    if (x.kind() == Kind::letter)
      for (const auto& entry : x->entries) all.push_back(static_cast<std::size_t>(entry.rates[0]));
    for (const Tree& child : x->children) add_letters(child, all);
  }

  static bool has_indices(const Tree& x) {
    return x.kind() == Kind::sum_over || x.kind() == Kind::permutations || x.kind() == Kind::components ||
           x.kind() == Kind::integral || x.kind() == Kind::along_curve;
  }
  bool has_several(const Tree& x) const {
    if (x.kind() == Kind::tuple || x.kind() == Kind::matrix) return true;
    if (x.kind() == Kind::letter)
      return std::ranges::any_of(x->entries, [&](const formula::Entry& entry) {
        return !letters_[static_cast<std::size_t>(entry.rates[0])].is_number();
      });
    return std::ranges::any_of(x->children, [&](const Tree& child) { return has_several(child); });
  }
  bool is_uneven(const Tree& x) const {
    if (x.kind() == Kind::dot) return shape(x.child(0))->columns != shape(x.child(1))->columns;
    if (x.kind() != Kind::sum) return false;
    std::optional<std::size_t> columns;
    for (const Tree& term : x->children) {
      if (is_number(term, "0")) continue;
      const std::size_t its = shape(term)->columns;
      if (columns && *columns != its) return true;
      columns = its;
    }
    return false;
  }

  std::optional<Shape> shape(const Tree& x) const {
    try {
      return formula::evaluate<double>(x, letters_);
    } catch (const formula::NoValue&) {
      return std::nullopt;
    }
  }
  std::string name(const Tree& x) const { return name_of(*shape(x)); }

  Misfit of_sum(const Tree& x) const {
    std::optional<Shape> first;
    for (const Tree& term : x->children) {
      if (is_number(term, "0")) continue;
      const Shape its = *shape(term);
      if (!first) first = its;
      if (extent(its) != extent(*first))
        return at(term, name_of(*first) + " and " + name_of(its) + " do not add up");
    }
    return at(x, "these do not add up");
  }
  Misfit of_product(const Tree& x) const {
    Shape all = *shape(x.child(0));
    for (std::size_t i = 1; i < x->children.size(); ++i) {
      const Tree& factor = x.child(i);
      const Shape next = *shape(factor);
      if (x->marks[i] == '/' && !next.is_number())
        return at(factor, "divide by a number: this is " + name_of(next));
      if (x->marks[i] == '/') continue;
      const bool several = !all.is_number() && !next.is_number();
      if (several && all.columns == 1 && next.columns == 1)
        return at(factor, "two vectors have several products: write dot(a, b) or cross(a, b)");
      if (several && all.columns != next.rows())
        return at(factor,
                  name_of(all) + " and " + name_of(next) + " have no product" +
                      (all.columns == 1 && next.columns == all.rows() ? ": write the matrix first" : ""));
      all = product_of(all, next);
    }
    return at(x, "these have no product");
  }

  const std::vector<Shape>& letters_;
};

}  // namespace

std::string name_of(Size size) {
  if (size == Size()) return "a number";
  if (!size.is_matrix()) return "a vector of " + std::to_string(size.rows);
  return "a matrix of " + std::to_string(size.rows) + " by " + std::to_string(size.columns);
}

std::optional<std::size_t> index_of_component(std::size_t number, Size size) {
  if (size == Size()) return std::nullopt;
  const std::size_t row = size.is_matrix() ? number / 10 : number,
                    column = size.is_matrix() ? number % 10 : 1;
  if (row < 1 || row > size.rows || column < 1 || column > size.columns) return std::nullopt;
  return (row - 1) * size.columns + column - 1;
}

Misfit misfit(const Tree& x, const std::vector<Shape>& letters, const std::string& says) {
  const Search search(letters);
  const Tree* part = search.smallest(x);
  return part ? search.reason(*part, says) : Misfit{says};
}

std::optional<Misfit> uneven(const Tree& x, const std::vector<Shape>& letters) {
  const Search search(letters);
  const Tree* part = search.uneven(x);
  return part ? std::optional(search.reason(*part, "these do not fit")) : std::nullopt;
}

}  // namespace oddity::problem
