#include "chapters/formulas.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

struct TwoLetters {
  double x, y;
  explicit TwoLetters(Random& random) : x(random.between(1, 2)), y(random.between(1, 2)) {}
  TwoLetters(double x_, double y_) : x(x_), y(y_) {}
  std::array<double*, 2> letters() { return {&x, &y}; }
  std::string where() const { return ""; }
};

using V = Formula<TwoLetters>;

}  // namespace

TEST_CASE("the size of a formula's terms does not shrink when they cancel", "[claims]") {
  const V difference{"x - y", [](const TwoLetters& s) { return Value(s.x - s.y); }};
  CHECK(std::abs(size_of_terms(difference, TwoLetters(1000, 1000)) - 2000) < 1);
  const V small{"x y", [](const TwoLetters& s) { return Value(s.x * s.y); }};
  CHECK(std::abs(size_of_terms(small, TwoLetters(1e-3, 1)) - 3e-3) < 1e-6);
}

TEST_CASE("terms that always cancel have a size if one is given", "[claims]") {
  const auto zero = [](const TwoLetters& s) { return Value(s.x - s.x); };
  CHECK(size_of_terms(V{"x - x", zero}, TwoLetters(5, 1)) == 0);
  CHECK(size_of_terms(V{"x - x", zero, [](const TwoLetters& s) { return s.x; }}, TwoLetters(5, 1)) == 5);
}

TEST_CASE("a comparison allows roundings of its terms, not of the exercise's largest", "[claims]") {
  const V one{"x", [](const TwoLetters& s) { return Value(s.x); }};
  const V off{"x (1 + 1e-12)", [](const TwoLetters& s) { return Value(s.x * (1 + 1e-12)); }};
  const auto samples = draw<TwoLetters>(200, 1);
  CHECK(compare("x", one, one, samples).holds());
  CHECK_FALSE(compare("x", off, one, samples).holds());
}
