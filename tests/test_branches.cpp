#include "chapters/branches.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

template <class T>
T larger(const T& a, const T& b) {
  return a < b ? b : a;
}

Branching letter(const char* name, Way& way) { return {Expression::letter(name), way}; }

}  // namespace

TEST_CASE("a function with comparisons is recorded as a tree of all its branches", "[branches]") {
  const auto of_two = [](Way& way) { return larger(letter("x", way), letter("y", way)).expression().coq(); };
  CHECK(tree_of(of_two) == "(if Rlt_dec (x) (y)\n  then y else x)");
  const auto of_three = [](Way& way) {
    return larger(larger(letter("x", way), letter("y", way)), letter("z", way)).expression().coq();
  };
  CHECK(tree_of(of_three) ==
        "(if Rlt_dec (x) (y)\n  then (if Rlt_dec (y) (z)\n  then z else y) else "
        "(if Rlt_dec (x) (z)\n  then z else x))");
}

TEST_CASE("a function without comparisons is a leaf", "[branches]") {
  CHECK(tree_of([](Way& way) { return (letter("x", way) + 1).expression().coq(); }) == "x + 1");
}
