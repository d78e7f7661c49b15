// Printed code contains only the parts that it needs.

#include <string>

#include "report/text/used_code.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

const std::string code = R"(
/// Of all.
namespace oddity {

using std::sin, std::cos;

/// A number.
constexpr double half = 0.5;  // of one

template <class T>
T square(const T& x) {
  return x * x;
}
template <class T, std::size_t n>
requires(n > 1) std::array<T, n> square(std::array<T, n> x) {
  for (auto& one : x) one = square(one);  // not a call of unused()
  return x;
}

/// Says "unused(".
inline const char* unused() { return "Model { square("; }

template <class T>
struct Given {
  T a, b{};
  Given(const T& x) : a{x}, b(x) {}
  T sum() const { return a + b; }
  static constexpr bool is_new = true;

 private:
  int twice() const { return 2; }
  int count_ = twice();
};

template <class T>
struct Model {
  Given<T> p;
  using State = std::array<T, 2>;
  State start() const { return {p.sum(), T(0)}; }
  T other() const { return half * cos(p.a); }
};

enum class Way { one, other };

}  // namespace oddity

namespace oddity::apart {

struct Alone {};

}  // namespace oddity::apart
)";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("code that a program mentions stays, with everything that it mentions in turn", "[code]") {
  const std::string used = used_code(code, "Model<double> model; model.start();");
  INFO(used);
  for (const char* part :
       {"struct Model {", "State start()", "using State", "struct Given {", "T sum()", "T a, b{};",
        "Given(const T& x) : a{x}, b(x) {}", " private:", "int count_ = twice();", "int twice()",
        "/// Of all.\nnamespace oddity {\n\ntemplate <class T>\nstruct Given {\n  T a"})
    CHECK(has(used, part));
  for (const char* part :
       {"other()", "half", "square", "unused", "is_new", "std::sin", "Way", "Alone", "apart"})
    CHECK_FALSE(has(used, part));
}

TEST_CASE("overloads stay together, and comments and literals mention nothing", "[code]") {
  const std::string used = used_code(code, "square(2) /* */ + half; // unused");
  CHECK(has(used, "T square(const T& x)"));
  CHECK(has(used, "requires(n > 1) std::array<T, n> square("));
  CHECK(has(used, "constexpr double half = 0.5;  // of one\n"));
  CHECK_FALSE(has(used, "unused()\""));
  CHECK_FALSE(has(used, "const char* unused"));
  CHECK_FALSE(has(used, "struct"));
  CHECK(has(used_code(code, "Way::one"), "enum class Way { one, other };"));
}

TEST_CASE("text that does not parse as declarations is unchanged", "[code]") {
  for (const std::string text : {"struct A {", "}", "struct A {}; }", "int x", "namespace a {\nint y;"})
    CHECK(used_code(text, "") == text);
  CHECK(used_code("", "A").empty());
}

TEST_CASE("standard headers stay if something of them is mentioned", "[code]") {
  CHECK(needs_standard("array", "std::array<int, 2> a;"));
  CHECK_FALSE(needs_standard("array", "int array;"));
  CHECK(needs_standard("cmath", "x = sqrt(2);"));
  CHECK(needs_standard("cmath", "std::fmax(1, std::ceil(x))"));
  CHECK_FALSE(needs_standard("tuple", "int a;"));
  CHECK_FALSE(needs_standard("functional", "int function;"));
  CHECK(needs_standard("valarray", ""));  // one that is not known
}
