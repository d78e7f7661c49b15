// Formulas in TeX, read and evaluated.

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "chapters/typeset.hpp"
#include "report/verify/catch.hpp"
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

TEST_CASE("a formula in TeX has its usual meaning", "[typeset]") {
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
  CHECK(number(R"(\tfrac{4}{16}+2^{10})") == 1024.25);
  CHECK(number(R"(\pi)") == std::numbers::pi);
}

TEST_CASE("a function applies to the factors after it", "[typeset]") {
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

TEST_CASE("matrices are letters of four or nine numbers", "[typeset]") {
  const TypesetLetters all{
      {"R", {0, -1, 1, 0}}, {"I", {1, 0, 0, 0, 1, 0, 0, 0, 1}}, {"b", {2, 3}}, {"D", {1, 2, 3}}, {"x", 2}};
  const auto is = [&](const char* formula, const Value& value) {
    const auto typeset = typeset_value(formula, all);
    return typeset && distance(*typeset, value) == 0;
  };
  CHECK(is("Rb", {-3, 2}));
  CHECK(is("R^Tb", {3, -2}));
  CHECK(is("xRRb", {-4, -6}));
  CHECK(is("D^TD", 14));
  CHECK(is("D^T(I-DD^T)D", 14 - 196));
  CHECK(is("DD^T", {1, 2, 3, 2, 4, 6, 3, 6, 9}));
  CHECK(is("(0,-1;\\ 1,0)b", {-3, 2}));
  CHECK(is("(Rb,x)", {-3, 2, 2}));
  CHECK(is(R"(\mathrm{Diag}(1,x,3)D)", {1, 4, 9}));
  CHECK(is(R"(\mathrm{Skew}(D)(0,0,1))", {2, -1, 0}));
  CHECK(is(R"(\begin{pmatrix}0&-1\\1&0\end{pmatrix}b+b)", {-1, 5}));
  CHECK(is(R"(\begin{pmatrix}b&xb\end{pmatrix}(1,-1))", {-2, -3}));
  CHECK(is(R"(\mathrm{Unskew}(-\mathrm{Skew}(D)))", {-1, -2, -3}));
  CHECK_FALSE(typeset_value(R"(\begin{pmatrix}1&2\\3\end{pmatrix})", all));
  for (const char* formula : {"Db", "RD", "R^2", "|R|", "(0,1;2)"}) CHECK_FALSE(typeset_value(formula, all));
}

TEST_CASE("a sum runs over all values of its index", "[typeset]") {
  TypesetLetters all{{"c", 10}};
  for (int i = 1; i <= 12; ++i) all.emplace_back("m_{" + std::to_string(i) + "}", i);
  all.insert(all.end(), {{"y_1'", 2}, {"y_2'", 3}, {"a_{11}", 1}, {"a_{21}", 5}, {"n_2", 2}});
  const auto is = [&](const char* formula, double value) {
    const auto typeset = typeset_value(formula, all);
    return typeset && distance(*typeset, value) == 0;
  };
  CHECK(is(R"(\sum m_i)", 78));
  CHECK(is(R"(\sum_nm_n+c)", 88));
  CHECK(is(R"(c\sum m_iy_i'^2)", 220));
  CHECK(is(R"(\sum m_i(y_i'+c))", 12 + 26));
  CHECK(is(R"(\sum_{k\le 3}m_k)", 6));
  CHECK(is(R"(\sum_ka_{k1}m_k)", 11));
  for (const char* formula : {R"(\sum c)", R"(\sum_kz_k)", R"(\sum_k)", R"(\sum_{k}m_j)"})
    CHECK_FALSE(typeset_value(formula, all));
}

TEST_CASE("indices without a sum are free, or summed if they occur twice in a product", "[typeset]") {
  const TypesetLetters all{{"f_0", 1},     {"f_1", 2},     {"f_2", 3},      {"g_0", 4},
                           {"g_1", 5},     {"g_2", 6},     {"h_{0,0}", 1},  {"h_{0,1}", 2},
                           {"h_{0,2}", 3}, {"h_{1,0}", 4}, {"h_{1,1}", 5},  {"h_{1,2}", 6},
                           {"h_{2,0}", 7}, {"h_{2,1}", 8}, {"h_{2,2}", 10}, {"c", 2}};
  CHECK(distance(*typeset_value("cf_i-1", all), {1, 3, 5}) == 0);
  CHECK(distance(*typeset_value("f_jg_jf_i", all), {32, 64, 96}) == 0);
  CHECK(distance(*typeset_value("h_{i,j_1}g_{j_1}", all), {32, 77, 128}) == 0);
  CHECK(distance(*typeset_value("h_{k,k}f_m", all), {16, 32, 48}) == 0);
  const TypesetLetters matrices{{"a_{11}", 1}, {"a_{12}", 2}, {"a_{21}", 3}, {"a_{22}", 4}, {"b_{11}", 1},
                                {"b_{12}", 0}, {"b_{21}", 5}, {"b_{22}", 1}, {"v_1", 7},    {"v_2", 8}};
  CHECK(distance(*typeset_value("a_{rc}", matrices), {1, 2, 3, 4}) == 0);
  CHECK(distance(*typeset_value("a_{cr}", matrices), {1, 3, 2, 4}) == 0);
  CHECK(distance(*typeset_value(R"(\sum_ka_{rk}b_{kc})", matrices), {11, 2, 23, 4}) == 0);
  CHECK(distance(*typeset_value(R"(\sum_ka_{ik}v_k)", matrices), {23, 53}) == 0);
  for (const char* formula : {"f_ig_j", "f_jg_j", "f_jg_j+f_i", "f_jg_jf_jf_i"})
    CHECK_FALSE(typeset_value(formula, all));
}

TEST_CASE("derivatives use the letters' rates, integrals run between their bounds", "[typeset]") {
  const TypesetLetters all{{R"(\theta)", 0.7}, {R"(\dot\theta)", 3}, {R"(\ddot\theta)", -2}, {"m", 5},
                           {"T", 2},           {R"(\pm)", -1}};
  const auto near = [&](const char* formula, double value) {
    const auto typeset = typeset_value(formula, all);
    return typeset && std::abs((*typeset)[0] - value) <= 1e-11 * std::abs(value);
  };
  CHECK(near(R"(\frac{d}{dt}(m\sin\theta))", 15 * std::cos(0.7)));
  CHECK(near(R"(2\frac d{dt}(\dot\theta\cos\theta))", 2 * (-2 * std::cos(0.7) - 9 * std::sin(0.7))));
  CHECK(near(R"(\int_0^Tm t^2\,dt)", 40.0 / 3));
  CHECK(near(R"(-\int_1^{T/2+2}\cos\theta t\,dt+1)", 1 - (std::sin(2.1) - std::sin(0.7)) / 0.7));
  CHECK(near(R"(m\pm T\mp1)", 4));
  for (const char* formula : {R"(\int m\,dt)", R"(\int_0^Tm)", R"(\frac{d}{dt}q)"})
    CHECK_FALSE(typeset_value(formula, all));
}

TEST_CASE("an integral along a curve is over the nodes of its letters", "[typeset]") {
  // x = s from 0 to 2 at 20 midpoints, on which F is (1, s)
  std::vector<double> ds, delta, F;
  for (int i = 0; i < 20; ++i) {
    const double s = (i + 0.5) / 10;
    ds.push_back(0.1), delta.push_back(3 + s);
    F.insert(F.end(), {1, s});
  }
  const TypesetLetters all{{"F", {7, 7}},        {"F", F},      {"ds", ds},
                           {R"(\delta)", delta}, {"n", {0, 2}}, {"m", 5}};
  const auto near = [&](const char* formula, double value) {
    const auto typeset = typeset_value(formula, all);
    return typeset && std::abs((*typeset)[0] - value) <= 1e-13 * std::abs(value);
  };
  CHECK(near(R"(\int ds)", 2));
  CHECK(near(R"(m\int\delta\,ds+1)", 41));
  CHECK(near(R"(\int F\cdot n\,ds)", 4));
  CHECK(near(R"(F\cdot n+\int m\,ds)", 24));  // outside it is another letter
  for (const char* formula : {R"(\int\delta)", R"(\int q\,ds)", R"(\int F\,ds)"})
    CHECK_FALSE(typeset_value(formula, all));
  CHECK_FALSE(typeset_value(R"(\int ds)", {{"ds", 1}}));
}

TEST_CASE("a sum over permutations has their signs", "[typeset]") {
  const TypesetLetters all{{"a_{11}", 1}, {"a_{12}", 2}, {"a_{21}", 3}, {"a_{22}", 4}};
  const auto value = [&](const char* formula) { return (*typeset_value(formula, all))[0]; };
  CHECK(value(R"(\sum_\sigma\varepsilon_\sigma a_{\sigma(1)1}a_{\sigma(2)2})") == -2);
  CHECK(value(R"(\sum_\sigma a_{\sigma(1)1}a_{\sigma(2)2})") == 10);
  for (const char* formula : {R"(\sum_\sigma a_{11})", R"(\sum_\sigma a_{\sigma(3)1})",
                              R"(\sum_\sigma\varepsilon_\sigma)", R"(\sum_\sigma a_{\sigma(1)3})"})
    CHECK_FALSE(typeset_value(formula, all));
}

TEST_CASE("a relation between formulas is true or false", "[typeset]") {
  const TypesetLetters all{{"x", -2}, {"y", 3}, {"z", {1, -1}}, {"o", {0, 0}}, {"u", 1e8}, {"v", 1e-9}};
  const auto so = [&](const char* formula) { return *typeset_relation(formula, all); };
  for (const char* formula : {"x<0", "0<y", "y>x", R"(x\le-2)", R"(y\ge3)", R"(x\ne y)", "x+y=1", "o=0",
                              "x<0<y", "x+y=y+x=1", R"(|x|<y^2)", "o=(0,0)", "u+v-u=0"})
    CHECK(so(formula));
  for (const char* formula : {"x>0", "y<0", R"(x\ge0)", R"(y\le2)", R"(x\ne-2)", "x=y", "z=0", "z<0", "z>0",
                              "x<y<2", "v=0", "x+y=1=2"})
    CHECK_FALSE(so(formula));
  for (const char* formula : {"x", "q<0", "x<q", "z=(1,2,3)", "", "x<", R"(\left(x\right))"})
    CHECK_FALSE(typeset_relation(formula, all));

  using Said = std::vector<std::pair<TypesetLetters, bool>>;
  CHECK(compare_typeset("$x<0$", Said{{all, true}}).read);
  CHECK(compare_typeset("$x>0$", Said{{all, false}}).read);
  CHECK(compare_typeset("$x>0$", Said{{all, true}}).difference ==
        "$x>0$ is typeset, which is not so at $x$ = -2, $y$ = 3, $z$ = (1, -1), $o$ = (0, 0)");
  CHECK_FALSE(compare_typeset("$x<0$", Said{{all, true}, {all, false}}).difference.empty());
  CHECK_FALSE(compare_typeset("$x<0$, always", Said{{all, true}}).read);
  CHECK_FALSE(compare_typeset("$x<0$", Said{}).read);
}

TEST_CASE("text with another meaning is not read", "[typeset]") {
  for (const char* formula :
       {"q", "m_1", "m'", "I_x", R"(\sum m)", "m>0", "(m", "m)", "", "m^T", R"(\frac m)"})
    CHECK(unread(formula));
}

TEST_CASE("a typeset formula must equal the computed one", "[typeset]") {
  const auto typeset = [](const char* text, double computed) {
    return compare_typeset(text, {{letters, Value(computed)}});
  };
  CHECK(typeset("$m+1$", 3).read);
  CHECK_FALSE(typeset("$m+1$", 3.001).read);
  CHECK(typeset("$m+1$", 3.001).difference == "$m+1$ is typeset, which is (3), and (3.001) is computed");
  CHECK(typeset("$m_2=m+1$", 3).read);
  CHECK(typeset("$m_2=m$", 1).read);  // difference of the sides
  CHECK_FALSE(typeset("$m_2=m$", 4).difference.empty());
  CHECK(typeset("$q=m$", 2).read);
  for (const char* text : {"$q=m$", "the mass $m$", "$q$"}) {
    CHECK_FALSE(typeset(text, 4).read);
    CHECK(typeset(text, 4).difference.empty());
  }
  CHECK_FALSE(typeset("$m_2=m+2$", 3).difference.empty());  // not the letter on the left
  CHECK_FALSE(typeset("$m_2=q$", 3).read);
  CHECK(typeset(R"($m\to2$)", 2).read);
  CHECK_FALSE(typeset(R"($m\to3$)", 2).read);
  CHECK_FALSE(compare_typeset("$m$", std::vector<std::pair<TypesetLetters, Value>>{}).read);
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(typeset("$m$", none).read);  // there is nothing to compare with
  CHECK_FALSE(compare_typeset("$m/x$", {{{{"m", 2}, {"x", 0}}, Value(2)}}).difference.empty());
  CHECK(compare_typeset("$m$", {{letters, Value(none)}, {letters, Value(2)}}).read);
}

TEST_CASE("an equation with one computed side must have no other value on the other side", "[typeset]") {
  const auto unequal = [](const char* text, const Value& computed) {
    const Typesetting typeset = compare_typeset(text, {{letters, computed}});
    CHECK(typeset.read);
    return !typeset.unequal.empty();
  };
  CHECK(unequal("$m+1=m_2+1$", 3));
  CHECK(unequal("$m+1=m_2=m_2+1$", 3));
  CHECK_FALSE(unequal("$m+1=m_2$", 3));
  CHECK_FALSE(unequal("$m+1=q$", 3));  // not read
  CHECK_FALSE(unequal("$m+1=0$", 3));  // it may hold on some motion
  CHECK_FALSE(unequal("$m=m_2$", 3));  // the letter that names it
  CHECK_FALSE(unequal("$m_2=m$", 1));  // difference of the sides
  CHECK_FALSE(unequal("$m+1=m_2+1$", {3, 4}));
}

TEST_CASE("several numbers are the sides of an equation in a row, or one number repeated", "[typeset]") {
  const auto typeset = [](const char* text, const Value& computed) {
    return compare_typeset(text, {{letters, computed}});
  };
  CHECK(typeset("$m+1=m_2$", {3, 3}).read);
  CHECK(typeset("$q=m+1=2m_2$", {3, 6}).difference.empty());
  CHECK(typeset("$m=m+1=2m_2$", {3, 6}).read);
  CHECK(typeset("$m=m+1=2m_2$", {2, 3}).read);
  CHECK_FALSE(typeset("$m=m+1=2m_2$", {3, 7}).read);
  CHECK(typeset("$m+1$", {3, 3, 3}).read);
  CHECK_FALSE(typeset("$q+1=m+1$", {3, 3}).read);  // both are computed, and one cannot be read
  CHECK_FALSE(typeset("$m+1$", {4, 4}).difference.empty());
  CHECK_FALSE(typeset("$m+1$", {3, 4}).read);
}

TEST_CASE("terms that cancel are compared by their size", "[typeset]") {
  const auto typeset = [](const char* text, double computed) {
    return compare_typeset(text, {{{{"x", 3e5}, {"y", 1e5}}, Value(computed)}});
  };
  CHECK(typeset("$x-3y$", 1e-10).read);
  CHECK_FALSE(typeset("$x-3y$", 1).difference.empty());
  CHECK(typeset("$x-3y=0$", 1e-10).read);
}

TEST_CASE("a check that a formula is as typeset reports the actual formula", "[typeset]") {
  CHECK(is_as_typeset({true, "", ""}));
  CHECK_FALSE(is_as_typeset({false, "", ""}));
  CHECK_THROWS_AS(is_as_typeset({false, "another", ""}), std::logic_error);
}

TEST_CASE("letters are listed as they are typeset", "[typeset]") {
  CHECK(listed(letters, 3) == "$m$ = 2, $m_2$ = 3, $I_{xx}$ = 5");
  CHECK(listed({{"u", {1, 0.5, -2}}}, 1) == "$u$ = (1, 0.5, -2)");
}
