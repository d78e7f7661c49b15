// Formulas of TeX, read and computed.

#include <cmath>
#include <limits>
#include <numbers>

#include "chapters/typeset.hpp"
#include "tests/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

const TypesetLetters letters{
    {"m", 2},           {"m_2", 3},           {"I_{xx}", 5},    {"t", 0.5},
    {R"(\theta)", 0.3}, {R"(\dot\theta)", 7}, {R"(\omega)", 4}, {R"(\mathbf r)", {1, 2, 2}},
    {"u", {1, 0, 0}},   {"v", {0, 1, 0}},     {"w", {0, 0, 6}}};

double number(const char* formula) {
  const auto value = typeset_value(formula, letters);
  REQUIRE(value);
  REQUIRE(value->size() == 1);
  return (*value)[0];
}
bool unread(const char* formula) { return !typeset_value(formula, letters); }

}  // namespace

TEST_CASE("a formula of TeX is what a reader takes it for", "[typeset]") {
  CHECK(number("2m+m_2") == 7);
  CHECK(number("-m^2t") == -2);
  CHECK(near_ulps(number("m/m_2t"), 2.0 / 3 * 0.5, 2));
  CHECK(number(R"(\frac m2\bigl(1+\tfrac12t\bigr))") == 1.25);
  CHECK(number(R"(\frac{m_2}{m+1})") == 1);
  CHECK(number(R"(\sqrt{1+3}-\sqrt4)") == 0);
  CHECK(near_ulps(number("(m+m_2)^{-3/2}"), std::pow(5, -1.5), 2));
  CHECK(near_ulps(number("e^{-t}"), std::exp(-0.5), 2));
  CHECK(number("2.5I_{xx}") == 12.5);
  CHECK(near_ulps(number("4|u-w|^2"), 148, 2));
  CHECK(number(R"(\pi)") == std::numbers::pi);
}

TEST_CASE("a function is of what follows it", "[typeset]") {
  CHECK(near_ulps(number(R"(m\cos\omega t)"), 2 * std::cos(2), 2));
  CHECK(near_ulps(number(R"(\sin\theta\cos\theta)"), std::sin(0.3) * std::cos(0.3), 2));
  CHECK(near_ulps(number(R"(\sin\theta\,m)"), std::sin(0.3) * 2, 2));
  CHECK(near_ulps(number(R"(\sin\theta\dot\theta)"), std::sin(0.3) * 7, 2));
  CHECK(near_ulps(number(R"(\sin\theta/2)"), std::sin(0.3) / 2, 2));
  CHECK(near_ulps(number(R"(\sin^2\theta)"), std::pow(std::sin(0.3), 2), 2));
  CHECK(near_ulps(number(R"(\cos^{-1}(t))"), std::acos(0.5), 2));
  CHECK(near_ulps(number(R"(\sin(\theta+t)m)"), 2 * std::sin(0.8), 2));
}

TEST_CASE("vectors have their own products", "[typeset]") {
  CHECK(number(R"(u\cdot v\times w)") == 6);
  CHECK(number(R"(m\,u\cdot u)") == 2);
  CHECK(number(R"(|\mathbf r|)") == 3);
  CHECK(distance(*typeset_value("(1,m,0)/m", letters), {0.5, 1, 0}) == 0);
  CHECK(distance(*typeset_value(R"((1,\,-m,\ 0))", letters), {1, -2, 0}) == 0);
  CHECK(distance(*typeset_value("2u+v", letters), {2, 1, 0}) == 0);
  CHECK(distance(*typeset_value("0+v", letters), {0, 1, 0}) == 0);
  CHECK(unread("uv"));
  CHECK(unread("u+m"));
}

TEST_CASE("what has another meaning is not read", "[typeset]") {
  for (const char* formula :
       {"q", "m_1", "m'", "I_x", R"(\sum m)", "m>0", "(m", "m)", "", "m^T", R"(\frac m)"})
    CHECK(unread(formula));
}

TEST_CASE("what is typeset has to be what is computed", "[typeset]") {
  const auto typeset = [](const char* text, double computed) {
    return compare_typeset(text, {{letters, Value(computed)}});
  };
  CHECK(typeset("$m+1$", 3).read);
  CHECK_FALSE(typeset("$m+1$", 3.001).read);
  CHECK(typeset("$m+1$", 3.001).difference == "$m+1$ is typeset, which is (3), and (3.001) is computed");
  CHECK(typeset("$m_2=m+1$", 3).read);
  CHECK(typeset("$m_2=m$", 1).read);  // what the sides differ by
  CHECK_FALSE(typeset("$m_2=m$", 4).difference.empty());
  CHECK(typeset("$q=m$", 2).read);
  for (const char* text : {"$q=m$", "the mass $m$", "$q$"}) {
    CHECK_FALSE(typeset(text, 4).read);
    CHECK(typeset(text, 4).difference.empty());
  }
  CHECK_FALSE(compare_typeset("$m$", {}).read);
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(typeset("$m$", none).read);  // there is nothing to compare with
  CHECK_FALSE(compare_typeset("$m/x$", {{{{"m", 2}, {"x", 0}}, Value(2)}}).difference.empty());
  CHECK(compare_typeset("$m$", {{letters, Value(none)}, {letters, Value(2)}}).read);
}

TEST_CASE("letters are told as they are typeset", "[typeset]") {
  CHECK(told(letters, 3) == "$m$ = 2, $m_2$ = 3, $I_{xx}$ = 5");
  CHECK(told({{"u", {1, 0.5, -2}}}, 1) == "$u$ = (1, 0.5, -2)");
}
