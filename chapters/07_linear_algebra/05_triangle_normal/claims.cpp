#include <cmath>
#include <functional>
#include <string>

#include "chapters/07_linear_algebra/05_triangle_normal/triangle_normal.hpp"
#include "chapters/07_linear_algebra/shared/vectors.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"

namespace oddity::ex07_05 {

namespace {

using namespace vectors;

Expressions expressions(const Expression& x) { return {x}; }
template <class Range>
Expressions expressions(const Range& all) {
  return {all.begin(), all.end()};
}

/// A formula in the letters of a sample that is generic in its number type: computed in double, and recorded
/// for proofs.
template <template <class> class Sample>
struct Recorded {
  std::string text;
  std::function<Value(const Sample<double>&)> of;
  std::function<Expressions(const Sample<Expression>&)> recorded;
  std::function<double(const Sample<double>&)> terms = {};

  operator Formula<Sample<double>>() const { return {text, of, terms}; }
};

/// Whole numbers of 128 bits.
__extension__ typedef __int128 Whole;

}  // namespace

template <class T>
T gram_determinant(const Vector3<T>& a, const Vector3<T>& b) {
  return dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
}

/// Three corners of a triangle and three vectors, in whole numbers. The vectors are its edges if their sum is
/// zero.
template <class T>
struct EdgesOf {
  static constexpr bool whole = true;
  Vector3<T> u, v, w, p, q, r;

  Vector3<T> normal() const { return cross(u, v); }
  /// Whether u and v are independent, in whole numbers.
  bool independent() const { return gram_determinant(cast<Whole>(u), cast<Whole>(v)) != 0; }
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

/// Samples of all sizes up to a million, with every tenth v nearly parallel to u; w is the third edge or
/// random.
std::vector<Edges> samples(Random random, bool closed) {
  std::vector<Edges> all;
  const auto vector = [&] {
    const double size = std::round(std::abs(random.magnitude(1, 1e6)));
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
using Line = Recorded<EdgesOf>;

void lines(Table& of_any, Table& of_closed, const std::vector<Edges>& open,
           const std::vector<Edges>& closed) {
  const Vectors zero{"$0$", [](const auto&s) { return decltype(s.normal()){}; }},
      uv{R"($u\times v$)", [](const auto&s) { return s.normal(); }};
  const std::string of_zero = "a multiple of zero is zero";
  of_any.formula("zero", 3839, R"($u\times0=0$)", open,
                 {.truth = {R"($u\times0$)", [](const auto& s) { return cross(s.u, decltype(s.u){}); }},
                  .printed = "$(0,0,0)$",
                  .changes_that_hold = of_zero});
  of_closed.formula(
      "inserted", 3841, R"($u\times0=u\times(u+v+w)$, printed with a cross before $v$)", closed,
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
  of_any.formula("expanded", 3843, R"($u\times(u+v+w)=u\times u+u\times v+u\times w$)", open,
                 {.truth = {R"($u\times(u+v+w)$)", [](const auto& s) { return cross(s.u, s.u + s.v + s.w); }},
                  .printed = R"($u\times u+u\times v+u\times w$)",
                  .changes_that_hold = R"($u\times u=0$)"});
  of_any.formula(
      "reduced", 3845, R"($u\times u+u\times v+u\times w=0+u\times v-w\times v$)", open,
      {.truth = {R"($u\times u+u\times v+u\times w$)",
                 [](const auto& s) { return cross(s.u, s.u) + cross(s.u, s.v) + cross(s.u, s.w); }},
       .printed = R"($0+u\times v-w\times v$)",
       .meant = R"($0+u\times v-w\times u$)",
       .kind = Fault::formula,
       .why = R"($u\times w=-w\times u$, not $-w\times v$: with $u+v+w=0$ the printed line is )"
              R"($2\,u\times v$, and not zero. The next line has $w\times u$.)"});
  of_closed.formula("first_pair", 3847, R"($u\times v=w\times u$)", closed,
                    {.truth = uv, .printed = R"($w\times u$)"});
  of_closed.formula("second_pair", 3851, R"($u\times v=v\times w$)", closed,
                    {.truth = uv, .printed = R"($v\times w$)"});
  of_any.formula("with_v", 3849, R"($v\times(u+v+w)=-u\times v+0+v\times w$)", open,
                 {.truth = {R"($v\times(u+v+w)$)", [](const auto& s) { return cross(s.v, s.u + s.v + s.w); }},
                  .printed = R"($-u\times v+0+v\times w$)"});
  of_closed.formula(
      "closed_walk", 3853,
      "as $u+v+w=0$, a walk along the edges ends at the vertex where it starts: the net distance traveled "
      "(our reading: the displacement) is zero",
      closed,
      {.quantity = "from a corner $P$ to the end of the walk $u$, $v$, $w$",
       .truth = zero,
       .printed = "$(P+u+v+w)-P$",
       .near_misses = {"$(|u|+|v|+|w|,0,0)$"},
       .changes_that_hold = of_zero});
}

std::vector<Whole> listed(const Whole& x) { return {x}; }
template <std::size_t n>
std::vector<Whole> listed(const std::array<Whole, n>& all) {
  return {all.begin(), all.end()};
}

/// Formulas in 128-bit integers, each as two halves of 52 bits.
Line in_whole(std::string text, const auto& of) {
  return {std::move(text),
          [=](const Edges& s) {
            constexpr Whole base = Whole{1} << 52;
            const auto whole = [](const Vector3<double>& x) { return cast<Whole>(x); };
            std::vector<double> halves;
            for (const Whole x : listed(of(
                     EdgesOf<Whole>{whole(s.u), whole(s.v), whole(s.w), whole(s.p), whole(s.q), whole(s.r)})))
              halves.insert(halves.end(), {static_cast<double>(x / base), static_cast<double>(x % base)});
            return Value(halves);
          },
          [=](const EdgesOf<Expression>& s) { return expressions(of(s)); }};
}

Line times_length(int factor) {
  return in_whole("$" + std::to_string(factor) + R"(|u\times v|^2$ in whole numbers)",
                  [=](const auto& s) { return factor * dot(s.normal(), s.normal()); });
}

template <class T>
T square_of(const Vector3<T>& x) {
  return dot(x, x);
}

const Line nothing = in_whole("$0$", [](const auto&s) { return 0 * s.u[0]; }),
           squared = in_whole(R"($|u\times v|^2$)", [](const auto&s) { return dot(s.normal(), s.normal()); }),
           volume = in_whole(R"($u\cdot v\times w$)", [](const auto&s) { return triple(s.u, s.v, s.w); }),
           leaning =
               in_whole(R"($n\cdot u$, $n\cdot v$ and $n\cdot w$, for $n$ each of the three products)",
                        [](const auto&s) {
                          const auto a = s.normal(), b = cross(s.v, s.w), c = cross(s.w, s.u);
                          return std::array{dot(a, s.u), dot(a, s.v), dot(a, s.w), dot(b, s.u), dot(b, s.v),
                                            dot(b, s.w), dot(c, s.u), dot(c, s.v), dot(c, s.w)};
                        }),
           upright = in_whole("$0$, nine times",
                              [](const auto&s) { return std::array<std::decay_t<decltype(s.u[0])>, 9>{}; }),
           directions = in_whole(
               R"($n\cdot(v\times w)$ and $n\cdot(w\times u)$, $n=u\times v$)",
               [](const auto&s) {
                 return std::array{dot(s.normal(), cross(s.v, s.w)), dot(s.normal(), cross(s.w, s.u))};
               }),
           reversed = in_whole(
               R"($n\cdot(w\times v)$ and $n\cdot(u\times w)$, $n=u\times v$)",
               [](const auto&s) {
                 return std::array{dot(s.normal(), cross(s.w, s.v)), dot(s.normal(), cross(s.u, s.w))};
               }),
           lengths = in_whole(R"($|v\times w|^2$ and $|w\times u|^2$)",
                              [](const auto&s) {
                                const auto b = cross(s.v, s.w), c = cross(s.w, s.u);
                                return std::array{dot(b, b), dot(c, c)};
                              }),
           length_twice = in_whole(R"($|u\times v|^2$, twice)",
                                   [](const auto&s) {
                                     const auto square = dot(s.normal(), s.normal());
                                     return std::array{square, square};
                                   }),
           heron = in_whole(
               "$16\\,\\text{area}^2$ by Heron, from the distances of the corners", [](const auto&s) {
                 const auto a = square_of(s.q - s.p), b = square_of(s.r - s.q), c = square_of(s.p - s.r);
                 return 2 * (a * b + b * c + c * a) - a * a - b * b - c * c;
               });

void geometry(Claims& claims, const std::vector<Edges>& open, const std::vector<Edges>& closed) {
  const auto in_plane = [&](const std::vector<Edges>& samples) {
    return compare<Edges>(R"($u\cdot v\times w$, in halves of 52 bits)", volume, nothing, samples);
  };
  const Statement<Edges> flat{R"($u\cdot v\times w=0$)",
                              [](const Edges& s) { return size_of(volume.of(s)) == 0; }};
  const auto perpendicular = [&](const std::vector<Edges>& samples) {
    return compare<Edges>("dot product of each product with each edge, in halves of 52 bits", leaning,
                          upright, samples);
  };
  const auto along_first = [&](const Line& others) {
    return compare<Edges>("dot products of the other two products with the first, in halves of 52 bits",
                          others, length_twice, closed);
  };
  const auto same_length = [&](std::string text, const std::vector<Edges>& samples) {
    return Reading{std::move(text),
                   {compare<Edges>("the other two squared lengths, in halves of 52 bits", lengths,
                                   length_twice, samples)}};
  };
  claims
      .add("plane", 3853, "the three vectors lie in a plane",
           {.printed = {flat.text, {in_plane(closed)}, is_as_typeset(compare_typeset<Edges>(flat, closed))},
            .near_misses = {{"for any $u$, $v$, $w$", {in_plane(open)}}}})
      .add(
          "any_two_edges", 3853,
          R"(any two of the edges give the same normal vector, $u\times v$, $v\times w$ or $w\times u$ (our )"
          R"(condition: taken in the order of the walk))",
          {.printed = {"each is perpendicular to every edge, and points to the side of $u\\times v$",
                       {perpendicular(closed), along_first(directions)}},
           .near_misses = {{"for any $u$, $v$, $w$", {perpendicular(open)}},
                           {"in either order", {along_first(reversed)}}}})
      .add("same_length", 3853,
           R"(the normal vector always has the same length: $|u\times v|=|v\times w|=|w\times u|$)",
           {.printed = same_length("for every two edges", closed),
            .near_misses = {same_length("for any $u$, $v$, $w$", open)}})
      .formula<Edges>("twice_area", 3853, R"($|u\times v|$ is twice the triangle's area)", closed,
                      {.quantity = R"($16\,\text{area}^2$, in halves of 52 bits)",
                       .truth = heron,
                       .printed = times_length(4),
                       .near_misses = {times_length(16)}})
      .statement<Edges>(
          "triangle", 3853,
          R"(vectors with the sum zero may be viewed as edges of a triangle (our reading: of one that has the )"
          R"(normal vector $u\times v$))",
          some_on_a_line(closed),
          {.printed = {"wherever $u+v+w=0$", [](const Edges& s) { return s.normal() != Vector3<double>{}; }},
           .corrected = {"$u+v+w=0$, $u$ and $v$ not parallel",
                         [](const Edges& s) { return !s.independent() || s.normal() != Vector3<double>{}; }},
           .in_view = {"for $u$ and $v$ not parallel", &Edges::independent},
           .near_misses = {{"$u+v+w=0$, none of them zero",
                            [](const Edges& s) {
                              const Vector3<double> none{};
                              return s.u == none || s.v == none || s.w == none || s.normal() != none;
                            }}},
           .kind = Fault::left_out,
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

using Letters = EdgesOf<Expression>;

Letters any_closed() {
  const auto letters = [](const std::string& name) {
    return Vector3<Expression>{Expression::letter(name + "0"), Expression::letter(name + "1"),
                               Expression::letter(name + "2")};
  };
  Letters s{letters("u"), letters("v"), {}, letters("p"), {}, {}};
  s.w = -(s.u + s.v);
  s.q = s.p + s.u, s.r = s.q + s.v;
  return s;
}

Lemma holds(std::string name, std::vector<Proposition> follows) {
  return {.name = std::move(name),
          .letters = "(u0 u1 u2 v0 v1 v2 w0 w1 w2 p0 p1 p2 : R)",
          .follows = std::move(follows),
          .tactic = "ring"};
}
Lemma holds(std::string name, const Line& left, const Line& right) {
  const Letters s = any_closed();
  return holds(std::move(name), equal(left.recorded(s), right.recorded(s)));
}

/// Vectors on one line have no normal; if the Gram determinant is not zero, there is one.
Provable proof_of_triangle() {
  const Letters on_a_line{{1, 0, 0}, {2, 0, 0}, {-3, 0, 0}, {}, {}, {}}, s = any_closed();
  Lemma normal = holds("corrected", {not_zero(squared.recorded(s)[0])});
  normal.given = {not_zero(gram_determinant(s.u, s.v))};
  normal.tactic = "match goal with H : _ <> 0 |- _ => contradict H; etransitivity; [| exact H]; ring end";
  return {
      "7.5-triangle",
      "three vectors on one line with the sum zero have the product zero; of two that are independent it is not",
      {holds("printed_fails", equal(expressions(on_a_line.normal()), Expressions(3, Expression(0.0)))),
       normal}};
}

}  // namespace

Provables proofs() {
  const std::string sum = "it holds for any three whose sum is zero";
  const std::vector<std::string> names{"u0", "u1", "u2", "v0", "v1", "v2", "w0", "w1", "w2",
                                       "p0", "p1", "p2", "q0", "q1", "q2", "r0", "r1", "r2"};
  Claims claims("7.5");
  Table of_any(claims), of_closed(claims);
  lines(of_any, of_closed, {}, {});
  ForAll<EdgesOf> all{.any = lettered<EdgesOf>(names),
                      .letters = quantified(names),
                      .tactic = "ring",
                      .says = "it holds for any three vectors",
                      .example = {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}, {}, {}, {}}};
  Provables proved = of_any.proofs("7.5", all);
  all.any.w = -(all.any.u + all.any.v);
  all.says = sum;
  std::ranges::move(of_closed.proofs("7.5", all), std::back_inserter(proved));
  const Provables more{
      {"7.5-zero",
       "it holds for any three vectors",
       {holds("printed", equal(expressions(cross(any_closed().u, Vector3<Expression>{})),
                               Expressions(3, Expression(0.0))))}},
      {"7.5-plane", sum, {holds("printed", volume, nothing)}},
      {"7.5-any_two_edges",
       sum,
       {holds("perpendicular", leaning, upright), holds("directions", directions, length_twice)}},
      {"7.5-same_length", sum, {holds("printed", lengths, length_twice)}},
      {"7.5-twice_area", sum, {holds("printed", times_length(4), heron)}},
      proof_of_triangle()};
  proved.insert(proved.end(), more.begin(), more.end());
  return proved;
}

std::vector<Claim> claims(const Random& random) {
  const auto open = samples(random, false), closed = samples(random, true);
  Claims claims("7.5");
  Table of_any(claims), of_closed(claims);
  lines(of_any, of_closed, open, closed);
  geometry(claims, open, closed);
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

namespace oddity {

Provables proofs_7_5() { return ex07_05::proofs(); }

}  // namespace oddity
