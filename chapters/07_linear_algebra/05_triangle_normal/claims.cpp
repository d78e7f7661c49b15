#include <cmath>
#include <string>

#include "chapters/07_linear_algebra/05_triangle_normal/triangle_normal.hpp"
#include "chapters/07_linear_algebra/shared/vectors.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"

namespace oddity::ex07_05 {

using namespace vectors;

template <class T>
T gram_determinant(const Vector3<T>& a, const Vector3<T>& b) {
  return dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
}

/// Three corners of a triangle and three vectors, in whole numbers that a double represents exactly, with the
/// squares of their products. The vectors are its edges if their sum is zero.
template <class T>
struct EdgesOf {
  static constexpr bool whole = true;
  Vector3<T> u, v, w, p, q, r;

  Vector3<T> normal() const { return cross(u, v); }
  bool independent() const { return gram_determinant(u, v) != 0; }
  double size() const { return 1 + dot(u, u) + dot(v, v) + dot(w, w); }
  std::array<T*, 18> quantities() {
    std::array<T*, 18> all{};
    std::size_t i = 0;
    for (Vector3<T>* vector : {&u, &v, &w, &p, &q, &r})
      for (T& x : *vector) all[i++] = &x;
    return all;
  }
  TypesetIn<T> typeset() const { return {{"u", u}, {"v", v}, {"w", w}, {"P", p}, {"Q", q}, {"R", r}}; }
  std::string where() const { return listed(typeset(), 3); }
};

namespace {

using Edges = EdgesOf<double>;

/// Samples of all sizes up to a thousand, with every tenth v nearly parallel to u; w is the third edge or
/// random.
std::vector<Edges> samples(Random random, bool closed) {
  std::vector<Edges> all;
  const auto vector = [&] {
    const double size = std::round(std::abs(random.magnitude(1, 1e3)));
    Vector3<double> x;
    for (double& component : x) component = std::round(random.between(-size, size));
    return x;
  };
  for (int i = 0; i < 300; ++i) {
    Edges s;
    s.p = vector(), s.q = vector(), s.r = vector();
    if (i % 10 == 9) s.r = s.p + Vector3<double>{1, 0, 2};
    s.u = s.q - s.p, s.v = s.r - s.q, s.w = closed ? s.p - s.r : vector();
    all.push_back(s);
  }
  return all;
}

/// Puts every tenth sample on a line, or sets v to zero: triples without a normal.
std::vector<Edges> some_on_a_line(std::vector<Edges> all) {
  for (std::size_t i = 0; i < all.size(); i += 10) {
    Edges& s = all[i];
    s.v = (i % 20 == 0 ? 2.0 : 0.0) * s.u, s.r = s.q + s.v, s.w = s.p - s.r;
  }
  return all;
}

using Vectors = ProvableFormula<EdgesOf>;
using Table = ProvableClaims<EdgesOf>;

void lines(Table& of_any, Table& of_closed, const std::vector<Edges>& open,
           const std::vector<Edges>& closed) {
  const auto any = of_any.over(open), of_edges = of_closed.over(closed);
  const Vectors zero{"$0$", [](const auto&s) { return decltype(s.normal()){}; }},
      uv{R"($u\times v$)", [](const auto&s) { return s.normal(); }};
  const std::string of_zero = "a multiple of zero is zero";
  any("zero", 3839, R"($u\times0=0$)",
      {R"($u\times0$)", [](const auto& s) { return cross(s.u, decltype(s.u){}); }}, "$(0,0,0)$", "", of_zero);
  of_edges(
      "inserted", 3841, R"($u\times0=u\times(u+v+w)$, printed with a cross before $v$)",
      {.truth = zero,
       .printed = R"($u\times(u\times v+w)$)",
       .meant = R"($u\times(u+v+w)$)",
       .changes_that_hold = of_zero,
       .kind = Fault::formula,
       .why = filled(
           R"(There is a stray cross between the plus and $v$ inside the bracket; the next line expands )"
           R"($u\times(u+v+w)$. Read without the plus, as $u\times(u\times v+w)$, with $u=(1,0,0)$, )"
           R"($v=(0,1,0)$ and $w=(-1,-1,0)$ it is $(@1,@1,@1)$ and not 0.)",
           [] {
             const Vector3<double> u{1, 0, 0}, v{0, 1, 0}, w{-1, -1, 0};
             return cross(u, cross(u, v) + w);
           }())});
  any.equation("expanded", 3843, R"($u\times(u+v+w)=u\times u+u\times v+u\times w$)",
               {R"($u\times(u+v+w)$)", [](const auto& s) { return cross(s.u, s.u + s.v + s.w); }},
               R"($u\times u=0$)");
  any("reduced", 3845, R"($u\times u+u\times v+u\times w=0+u\times v-w\times v$)",
      {.truth = {R"($u\times u+u\times v+u\times w$)",
                 [](const auto& s) { return cross(s.u, s.u) + cross(s.u, s.v) + cross(s.u, s.w); }},
       .printed = R"($0+u\times v-w\times v$)",
       .meant = R"($0+u\times v-w\times u$)",
       .kind = Fault::formula,
       .why = R"($u\times w=-w\times u$, not $-w\times v$: with $u+v+w=0$ the printed line is )"
              R"($2\,u\times v$, and not zero. The next line has $w\times u$.)"});
  of_edges.equation("first_pair", 3847, R"($u\times v=w\times u$)", uv);
  of_edges.equation("second_pair", 3851, R"($u\times v=v\times w$)", uv);
  any.equation("with_v", 3849, R"($v\times(u+v+w)=-u\times v+0+v\times w$)",
               {R"($v\times(u+v+w)$)", [](const auto& s) { return cross(s.v, s.u + s.v + s.w); }});
  of_edges(
      "closed_walk", 3853,
      "as $u+v+w=0$, a walk along the edges ends at the vertex where it starts: the net distance traveled "
      "(our reading: the displacement) is zero",
      zero, "$(P+u+v+w)-P$", "from a corner $P$ to the end of the walk $u$, $v$, $w$", of_zero);
  of_edges("plane", 3853, "the three vectors lie in a plane",
           {.quantity = R"($u\cdot v\times w$)",
            .truth = {"$0$", [](const auto& s) { return 0 * s.u[0]; }},
            .printed = R"($u\cdot v\times w=0$)",
            .near_misses = {R"($u\cdot v\times P=0$)"},
            .changes_that_hold = "a multiple of zero, or a product with two equal vectors, is zero"});
  of_edges(
      "any_two_edges", 3853,
      R"(any two of the edges give the same normal vector, $u\times v$, $v\times w$ or $w\times u$ (our )"
      R"(condition: taken in the order of the walk))",
      {R"($u\times v$, twice)",
       [](const auto& s) {
         const auto n = s.normal();
         return values(n[0], n[1], n[2], n[0], n[1], n[2]);
       }},
      R"($(v\times w,\ w\times u)$)", "the other two products");
  of_edges("same_length", 3853,
           R"(the normal vector always has the same length: $|u\times v|=|v\times w|=|w\times u|$)",
           {R"($|u\times v|^2$)", [](const auto& s) { return dot(s.normal(), s.normal()); }},
           R"($((v\times w)\cdot(v\times w),\ (w\times u)\cdot(w\times u))$)",
           "the other two squared lengths");
  of_edges("twice_area", 3853, R"($|u\times v|$ is twice the triangle's area)",
           {"Heron's formula, from the distances of the corners",
            [](const auto& s) {
              const auto square = [](const auto& x) { return dot(x, x); };
              const auto a = square(s.q - s.p), b = square(s.r - s.q), c = square(s.p - s.r);
              return 2 * (a * b + b * c + c * a) - a * a - b * b - c * c;
            }},
           R"($4(u\times v)\cdot(u\times v)$)", R"($16\,\text{area}^2$)");
}

void geometry(Claims& claims, const std::vector<Edges>& closed) {
  claims.statement<Edges>(
      "triangle", 3853,
      R"(vectors with the sum zero may be viewed as edges of a triangle (our reading: of one that has the )"
      R"(normal vector $u\times v$))",
      some_on_a_line(closed),
      {.printed = {R"($|u\times v|>0$)"},
       .corrected = {"$u+v+w=0$, $u$ and $v$ not parallel",
                     [](const Edges& s) { return !s.independent() || s.normal() != Vector3<double>{}; }},
       .in_view = {"for $u$ and $v$ not parallel", &Edges::independent},
       .near_misses = {{"$u+v+w=0$, none of them zero",
                        [](const Edges& s) {
                          const Vector3<double> none{};
                          return s.u == none || s.v == none || s.w == none || s.normal() != none;
                        }}},
       .root = "edges on one line",
       .why = filled(
           R"(Three vectors on one line, $u=(1,0,0)$, $v=(2,0,0)$, $w=(-3,0,0)$, have the sum zero as )"
           R"(well: all three products are @1. The triangle is flat, lies in many planes, and its unit )"
           R"(normal is $0/0$. The author has triangles with an area in view, of which the statement is )"
           R"(right. The products are equal, and as long as twice the area, of a flat one too.)",
           {size_of(cross(Vector3<double>{1, 0, 0}, Vector3<double>{2, 0, 0}))})});
}

}  // namespace

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

constexpr const char* any_edges = "(u0 u1 u2 v0 v1 v2 w0 w1 w2 p0 p1 p2 : R)";

/// Vectors on one line have no normal; if the Gram determinant is not zero, there is one.
Provable proof_of_triangle(const EdgesOf<Shortened>& s) {
  const EdgesOf<Expression> on_a_line{{1, 0, 0}, {2, 0, 0}, {-3, 0, 0}, {}, {}, {}};
  return {
      "7.5-triangle",
      "three vectors on one line with the sum zero have the product zero; of two that are independent it is not",
      {{"printed_fails",
        any_edges,
        {},
        equal(detail::recorded_value(on_a_line.normal()), Expressions(3, Expression(0.0))),
        "ring"},
       {"corrected",
        any_edges,
        {not_zero(gram_determinant(s.u, s.v).expression())},
        {not_zero(dot(s.normal(), s.normal()).expression())},
        "match goal with H : _ <> 0 |- _ => contradict H; etransitivity; [| exact H]; ring end"}}};
}

}  // namespace

Provables proofs() {
  Claims claims("7.5");
  Table of_any(claims), of_closed(claims);
  lines(of_any, of_closed, {}, {});
  const std::vector<std::string> names{"u0", "u1", "u2", "v0", "v1", "v2", "w0", "w1", "w2",
                                       "p0", "p1", "p2", "q0", "q1", "q2", "r0", "r1", "r2"};
  auto all = for_all<EdgesOf>(names, "ring", "it holds for any three vectors", {1, 0, 0, 0, 1, 0, -1, -1, 0});
  Provables proved = of_any.proofs("7.5", all);
  const Vector3<Expression> u{Expression::letter("u0"), Expression::letter("u1"), Expression::letter("u2")};
  proved.push_back(
      {"7.5-zero",
       all.says,
       {{"printed",
         any_edges,
         {},
         equal(detail::recorded_value(cross(u, Vector3<Expression>{})), Expressions(3, Expression(0.0))),
         "ring"}}});
  all.any.w = -(all.any.u + all.any.v);
  all.any.q = all.any.p + all.any.u, all.any.r = all.any.q + all.any.v;
  all.says = "it holds for any three whose sum is zero";
  append(proved, of_closed.proofs("7.5", all));
  proved.push_back(proof_of_triangle(all.any));
  return proved;
}

std::vector<Claim> claims(const Random& random) {
  const auto open = samples(random, false), closed = samples(random, true);
  Claims claims("7.5");
  Table of_any(claims), of_closed(claims);
  lines(of_any, of_closed, open, closed);
  geometry(claims, closed);
  return claims.in_order();
}

std::vector<Root> roots() {
  std::vector<Vector3<double>> grid;
  for (double x = 0; x < 3; ++x)
    for (double y = 0; y < 3; ++y) grid.push_back({x, y, 0});
  int triples = 0, on_a_line = 0;
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k, ++triples)
        if (cross(grid[j] - grid[i], grid[k] - grid[j]) == Vector3<double>{}) ++on_a_line;
  return {
      {"edges on one line",
       filled(
           R"(A $3\times3$ grid has @2 triples of vertices, and @1 of them lie on a line. A face on one of )"
           R"(these has the unit normal $0/0$, and is lit with NaN.)",
           {static_cast<double>(triples), static_cast<double>(on_a_line)})}};
}

}  // namespace oddity::ex07_05
