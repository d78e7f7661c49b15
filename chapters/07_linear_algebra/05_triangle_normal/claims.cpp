#include <cmath>

#include "chapters/07_linear_algebra/05_triangle_normal/triangle_normal.hpp"
#include "chapters/07_linear_algebra/shared/vectors.hpp"
#include "chapters/claims.hpp"
#include "chapters/recorded.hpp"
#include "reference/text.hpp"

namespace oddity::ex07_05 {

namespace {

using namespace vectors;

/// Whole numbers of 128 bits.
__extension__ typedef __int128 Whole;

}  // namespace

template <class T>
T gram_determinant(const Vector3<T>& a, const Vector3<T>& b) {
  return dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
}

/// Three vectors of whole numbers.
template <class T>
struct EdgesOf {
  static constexpr bool whole = true;
  Vector3<T> u, v, w;

  Vector3<T> normal() const { return cross(u, v); }
  /// u and v, in whole numbers.
  bool independent() const { return gram_determinant(cast<Whole>(u), cast<Whole>(v)) != 0; }
  double size() const { return 1 + dot(u, u) + dot(v, v) + dot(w, w); }
  /// They are a triangle's edges, or its corners.
  TypesetLetters typeset() const { return {{"u", u}, {"v", v}, {"w", w}, {"P", u}, {"Q", v}, {"R", w}}; }
  std::string where() const { return told(typeset(), 3); }
};

namespace {

using Edges = EdgesOf<double>;

/// Of all sizes up to a million, every tenth v nearly parallel to u; w closes the triangle or is random.
std::vector<Edges> samples(Random random, bool closed) {
  std::vector<Edges> all;
  const auto vector = [&] {
    const double size = std::round(std::abs(random.magnitude(1, 1e6)));
    Vector3<double> x;
    for (double& component : x) component = std::round(random.between(-size, size));
    return x;
  };
  for (int i = 0; i < 300; ++i) {
    Edges s{vector(), vector(), vector()};
    if (i % 10 == 9) s.v = Vector3<double>{1 - s.u[0], -s.u[1], 2 - s.u[2]};
    if (closed) s.w = -(s.u + s.v);
    all.push_back(s);
  }
  return all;
}

/// The same with every tenth on a line, or v even zero: triples without a normal.
std::vector<Edges> some_on_a_line(std::vector<Edges> all) {
  for (std::size_t i = 0; i < all.size(); i += 10) {
    Edges& s = all[i];
    s.v = (i % 20 == 0 ? 2.0 : 0.0) * s.u, s.w = -(s.u + s.v);
  }
  return all;
}

using Vectors = Formula<Edges>;
using Line = Recorded<EdgesOf>;

Line line(std::string text, const auto& of) { return recorded<EdgesOf>(std::move(text), of); }

const Line zero = line("$0$", [](const auto&s) { return decltype(s.normal()){}; }),
           times_zero = line(R"($u\times0$)", [](const auto&s) { return cross(s.u, decltype(s.u){}); }),
           bracket = line(R"($u\times(u+v+w)$)", [](const auto&s) { return cross(s.u, s.u + s.v + s.w); }),
           three = line(R"($u\times u+u\times v+u\times w$)",
                        [](const auto&s) { return cross(s.u, s.u) + cross(s.u, s.v) + cross(s.u, s.w); }),
           uv = line(R"($u\times v$)", [](const auto&s) { return s.normal(); }),
           stray_cross = line(R"($u\times(u+{\times}v+w)$, with a cross and no plus: $u\times(u\times v+w)$)",
                              [](const auto&s) { return cross(s.u, cross(s.u, s.v) + s.w); }),
           wrong_letter = line(R"($0+u\times v-w\times v$)",
                               [](const auto&s) { return cross(s.u, s.v) - cross(s.w, s.v); }),
           two = line(R"($0+u\times v-w\times u$)",
                      [](const auto&s) { return cross(s.u, s.v) - cross(s.w, s.u); }),
           wu = line(R"($w\times u$)", [](const auto&s) { return cross(s.w, s.u); }),
           vw = line(R"($v\times w$)", [](const auto&s) { return cross(s.v, s.w); }),
           // The three vectors as the vertices P, Q, R of a triangle.
    walk =
        line("$(Q-P)+(R-Q)+(P-R)$", [](const auto&s) { return ((s.v - s.u) + (s.w - s.v)) + (s.u - s.w); });

void lines(Claims& claims, const std::vector<Edges>& open, const std::vector<Edges>& closed) {
  claims
      .formula<Edges>("zero", 3839, R"($u\times0=0$)", open,
                      {.truth = times_zero,
                       .printed = zero,
                       .near_misses = {{"$u$", [](const Edges& s) { return s.u; }}}})
      .formula<Edges>(
          "inserted", 3841, R"($u\times0$ is the product of $u$ with the sum of the three)", closed,
          {.truth = zero,
           .printed = stray_cross,
           .meant = bracket,
           .near_misses = {{R"($u\times(u+v-w)$)",
                            [](const Edges& s) { return cross(s.u, s.u + s.v - s.w); }}},
           .kind = Fault::formula,
           .why = R"(A stray cross stands before $v$ inside the bracket; the next line expands )"
                  R"($u\times(u+v+w)$. Read as it stands, with $u=(1,0,0)$, $v=(0,1,0)$ and $w=(-1,-1,0)$, )"
                  R"(it is $(0,-1,-1)$ and not 0.)"})
      .formula<Edges>("expanded", 3843, R"($u\times(u+v+w)$ multiplied out)", open,
                      {.truth = bracket,
                       .printed = three,
                       .near_misses = {{R"($u\times u+u\times v+w\times u$)",
                                        [](const Edges& s) { return cross(s.u, s.v) + cross(s.w, s.u); }}}})
      .formula<Edges>(
          "reduced", 3845, R"($u\times u+u\times v+u\times w$ without what is zero)", open,
          {.truth = three,
           .printed = wrong_letter,
           .meant = two,
           .near_misses = {{R"($0+u\times v+w\times u$)",
                            [](const Edges& s) { return cross(s.u, s.v) + cross(s.w, s.u); }}},
           .kind = Fault::formula,
           .why = R"($u\times w=-w\times u$, not $-w\times v$: with $u+v+w=0$ the printed line is )"
                  R"($2\,u\times v$, and not zero. The next line has $w\times u$.)"})
      .formula<Edges>("first_pair", 3847, R"($u\times v=w\times u$)", closed,
                      {.truth = uv,
                       .printed = wu,
                       .near_misses = {{R"($u\times w$)", [](const Edges& s) { return cross(s.u, s.w); }}}})
      .formula<Edges>("second_pair", 3851, R"($u\times v=v\times w$)", closed,
                      {.truth = uv,
                       .printed = vw,
                       .near_misses = {{R"($w\times v$)", [](const Edges& s) { return cross(s.w, s.v); }}}})
      .formula<Edges>(
          "closed_walk", 3853,
          "once around a triangle $PQR$ the net distance traveled, that is the displacement, is zero", open,
          {.truth = zero,
           .printed = walk,
           .near_misses = {{"$(Q-P)+(R-Q)+(R-P)$, the last edge backwards",
                            [](const Edges& s) { return ((s.v - s.u) + (s.w - s.v)) + (s.w - s.u); }},
                           {"$|Q-P|+|R-Q|+|P-R|$, the distance that is walked", [](const Edges& s) {
                              double walked = 0;
                              for (const auto& edge : {s.v - s.u, s.w - s.v, s.u - s.w})
                                walked += std::sqrt(dot(edge, edge));
                              return Value{walked, 0, 0};
                            }}}});
}

/// A formula in whole numbers of 128 bits, as two halves of 52 bits.
Line in_whole(std::string text, const auto& of) {
  return {std::move(text),
          [=](const Edges& s) {
            constexpr Whole base = Whole{1} << 52;
            const Whole x = of(EdgesOf<Whole>{cast<Whole>(s.u), cast<Whole>(s.v), cast<Whole>(s.w)});
            return values(x / base, x % base);
          },
          [=](const EdgesOf<Expression>& s) { return expressions(of(s)); }};
}

Line times_length(int factor) {
  return in_whole("$" + std::to_string(factor) + R"(|u\times v|^2$ in whole numbers)",
                  [=](const auto& s) { return factor * dot(s.normal(), s.normal()); });
}

const Line nothing = in_whole("$0$", [](const auto&s) { return 0 * s.u[0]; }),
           squared = in_whole(R"($|u\times v|^2$)", [](const auto&s) { return dot(s.normal(), s.normal()); }),
           volume = in_whole(R"($u\cdot v\times w$)", [](const auto&s) { return triple(s.u, s.v, s.w); }),
           leaning = in_whole(R"($(n\cdot u)^2+(n\cdot v)^2+(n\cdot w)^2$, $n=u\times v$)",
                              [](const auto&s) {
                                const auto n = s.normal();
                                return dot(n, s.u) * dot(n, s.u) + dot(n, s.v) * dot(n, s.v) +
                                       dot(n, s.w) * dot(n, s.w);
                              }),
           pairs = in_whole(R"($(w\times v)\cdot(v\times w)+(u\times w)\cdot(w\times u)+3|u\times v|^2$)",
                            [](const auto&s) {
                              return dot(cross(s.w, s.v), cross(s.v, s.w)) +
                                     dot(cross(s.u, s.w), cross(s.w, s.u)) + 3 * dot(s.normal(), s.normal());
                            }),
           heron =
               in_whole("$16\\,\\text{area}^2$ by Heron, from the lengths of the sides", [](const auto&s) {
                 const auto a = dot(s.u, s.u), b = dot(s.v, s.v), c = dot(s.w, s.w);
                 return 2 * (a * b + b * c + c * a) - a * a - b * b - c * c;
               });

void geometry(Claims& claims, const std::vector<Edges>& open, const std::vector<Edges>& closed) {
  const auto in_plane = [&](const std::vector<Edges>& samples) {
    return compare<Edges>(R"($u\cdot v\times w$, in halves of 52 bits)", volume, nothing, samples);
  };
  const Statement<Edges> flat{R"($u\cdot v\times w=0$)",
                              [](const Edges& s) { return size_of(volume.of(s)) == 0; }};
  const auto perpendicular = [&](const std::vector<Edges>& samples) {
    return compare<Edges>(R"(what $u\times v$ has along the edges, in halves of 52 bits)", leaning, nothing,
                          samples);
  };
  claims
      .add("plane", 3853, "the three vectors lie in a plane",
           {.printed = {flat.text, {in_plane(closed)}, is_as_typeset(compare_typeset<Edges>(flat, closed))},
            .near_misses = {{"for any $u$, $v$, $w$", {in_plane(open)}}}})
      .add("any_two_edges", 3853,
           "any two of the edges give a normal vector, of the same length (in the order of the walk)",
           {.printed = {"perpendicular to all edges, the same length by every two",
                        {perpendicular(closed),
                         compare<Edges>("the squared length by every two edges, in halves of 52 bits", pairs,
                                        squared, closed)}},
            .near_misses = {{"for any $u$, $v$, $w$", {perpendicular(open)}},
                            {"in either order the same vector",
                             {compare<Edges>(
                                 "the product of two edges", {R"($u\times v$)", &Edges::normal},
                                 {R"($v\times u$)", [](const Edges& s) { return cross(s.v, s.u); }},
                                 closed)}}}})
      .formula<Edges>("twice_area", 3853, "the normal is twice as long as the triangle's area", closed,
                      {.quantity = R"($16\,\text{area}^2$, in halves of 52 bits)",
                       .truth = heron,
                       .printed = times_length(4),
                       .near_misses = {times_length(16)}})
      .statement<Edges>(
          "triangle", 3853,
          R"(vectors with the sum zero are edges of a triangle, and $u\times v$ is its normal vector)",
          some_on_a_line(closed),
          {.printed = {"wherever $u+v+w=0$", [](const Edges& s) { return s.normal() != Vector3<double>{}; }},
           .corrected = {"$u+v+w=0$, $u$ and $v$ not parallel",
                         [](const Edges& s) { return !s.independent() || s.normal() != Vector3<double>{}; }},
           .near_misses = {{"$u+v+w=0$, none of them zero",
                            [](const Edges& s) {
                              const Vector3<double> none{};
                              return s.u == none || s.v == none || s.w == none || s.normal() != none;
                            }}},
           .kind = Fault::left_out,
           .root = "edges on one line",
           .why =
               R"(Three vectors on one line, $u=(1,0,0)$, $v=(2,0,0)$, $w=(-3,0,0)$, have the sum zero as )"
               R"(well: all three products are 0. The triangle is flat, lies in many planes, and its unit )"
               R"(normal is $0/0$. That the products are equal, and their length twice the area, holds )"
               R"(there too.)"});
}

}  // namespace

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

using Letters = EdgesOf<Expression>;

Letters any_letters(bool closed) {
  const auto letters = [](const std::string& name) {
    return Vector3<Expression>{Expression::letter(name + "0"), Expression::letter(name + "1"),
                               Expression::letter(name + "2")};
  };
  Letters s{letters("u"), letters("v"), letters("w")};
  if (closed) s.w = -(s.u + s.v);
  return s;
}

Lemma holds(std::string name, std::vector<Proposition> follows) {
  return {.name = std::move(name),
          .letters = "(u0 u1 u2 v0 v1 v2 w0 w1 w2 : R)",
          .follows = std::move(follows),
          .tactic = "ring"};
}
Lemma holds(std::string name, const Line& left, const Line& right, bool closed) {
  const Letters s = any_letters(closed);
  return holds(std::move(name), equal(left.recorded(s), right.recorded(s)));
}

/// By 1 or more in the last component, where u and v are the first unit vectors and w closes the triangle.
Lemma differs(const Line& printed, const Line& truth) {
  const Letters s{{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  return {.name = "printed_differs",
          .follows = {apart(printed.recorded(s)[2], truth.recorded(s)[2], 1)},
          .tactic = by_arithmetic};
}

/// Vectors on one line have no normal; where the Gram determinant is not zero, there is one.
Provable proof_of_triangle() {
  const Letters on_a_line{{1, 0, 0}, {2, 0, 0}, {-3, 0, 0}}, s = any_letters(true);
  Lemma normal = holds("corrected", {not_zero(squared.recorded(s)[0])});
  normal.given = {not_zero(gram_determinant(s.u, s.v))};
  normal.tactic = "match goal with H : _ <> 0 |- _ => contradict H; etransitivity; [| exact H]; ring end";
  return {
      "7.5-triangle",
      "three vectors on one line with the sum zero have the product zero; of two that are independent it is not",
      {holds("printed_fails", equal(uv.recorded(on_a_line), zero.recorded(on_a_line))), normal}};
}

}  // namespace

Provables proofs() {
  const std::string any = "it holds for any three vectors", sum = "it holds for any three whose sum is zero",
                    off = "; of the unit vectors the printed line is off by one";
  return {{"7.5-zero", any, {holds("printed", times_zero, zero, false)}},
          {"7.5-inserted",
           "as meant " + sum + off,
           {holds("meant", bracket, zero, true), differs(stray_cross, zero)},
           1},
          {"7.5-expanded", any, {holds("printed", three, bracket, false)}},
          {"7.5-reduced",
           "as meant " + any + off,
           {holds("meant", two, three, false), differs(wrong_letter, three)},
           1},
          {"7.5-first_pair", sum, {holds("printed", wu, uv, true)}},
          {"7.5-second_pair", sum, {holds("printed", vw, uv, true)}},
          {"7.5-closed_walk", any, {holds("printed", walk, zero, false)}},
          {"7.5-plane", sum, {holds("printed", volume, nothing, true)}},
          {"7.5-any_two_edges",
           sum,
           {holds("perpendicular", leaning, nothing, true), holds("lengths", pairs, squared, true)}},
          {"7.5-twice_area", sum, {holds("printed", times_length(4), heron, true)}},
          proof_of_triangle()};
}

std::vector<Claim> claims(const Random& random) {
  const auto open = samples(random, false), closed = samples(random, true);
  Claims claims("7.5");
  lines(claims, open, closed);
  geometry(claims, open, closed);
  return claims.in_order();
}

std::vector<Root> roots() {
  return {{"edges on one line",
           R"(Of the 84 triples of vertices of a $3\times3$ grid 8 lie on a line: a face on one of them has )"
           R"(the unit normal $0/0$, and is lit with NaN.)"}};
}

}  // namespace oddity::ex07_05

namespace oddity {

Provables proofs_7_5() { return ex07_05::proofs(); }

}  // namespace oddity
