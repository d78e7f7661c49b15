// The claims of exercise 2.11. The text computes in an orthonormal frame {u, v, w} along the axis. The
// independent route is the quaternion product q r q* in world coordinates. All samples are random.

#include <numbers>

#include "chapters/02_basic_concepts/11_rotated_cross/rotated_cross.hpp"
#include "chapters/02_basic_concepts/shared/rotations.hpp"
#include "chapters/provable_claims.hpp"

namespace oddity::ex02_11 {

namespace {

using namespace rotation;

/// Determinant of three columns, expanded along the first.
double determinant(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// A rotation about the third axis of a right-handed frame, and two vectors.
template <class T>
struct SampleOf {
  using Vector = std::array<T, 3>;
  Vector u, v, w;
  T theta{};
  Vector a, b;

  SampleOf() = default;
  /// The first four angles are 0, 90, 180 and 270 degrees.
  SampleOf(Random& random, int i) : w(random.direction()) {
    // Gram-Schmidt without a cross product, which is the claim to be checked.
    const auto across = [](Vector r, const auto&... others) {
      for (int twice = 0; twice < 2; ++twice) {
        r = unit(r);
        ((r = r - dot(r, others) * others), ...);
      }
      return unit(r);
    };
    u = across(random.direction(), w), v = across(random.direction(), w, u);
    if (determinant(u, v, w) < 0) v = -1.0 * v;
    const double large = std::abs(random.magnitude(0.1, 100)), small = std::abs(random.magnitude(0.1, 100));
    theta = i < 4 ? i * std::numbers::pi / 2 : random.between(-7, 7);
    a = random.point(large), b = random.point(small);
  }
  std::array<T*, 7> letters() { return {&theta, &a[0], &a[1], &a[2], &b[0], &b[1], &b[2]}; }
  std::string where() const {
    return R"($\theta$ = )" + format_significant(theta, 6) + R"(, $\mathbf w$ = )" + shown(w);
  }

  TypesetIn<T> typeset() const {
    TypesetIn<T> all{{"c", c()},
                     {"s", s()},
                     {R"(\mathbf u)", u},
                     {R"(\mathbf v)", v},
                     {R"(\mathbf w)", w},
                     {R"(R\mathbf u)", rotated(u)},
                     {R"(R\mathbf v)", rotated(v)},
                     {R"(R\mathbf w)", rotated(w)},
                     {R"(R\mathbf a)", rotated(a)},
                     {R"(R\mathbf b)", rotated(b)}};
    for (const auto& [letter, of] : {std::pair{"a_", in(a)}, {"b_", in(b)}, {"g_", in(cross(a, b))}})
      for (std::size_t i = 0; i < 3; ++i) all.emplace_back(letter + std::to_string(i), of[i]);
    return all;
  }
  T c() const { return cos(theta); }
  T s() const { return sin(theta); }
  Vector rotated(const Vector& r) const { return quaternion(w, theta)(r); }
  /// Components along the frame.
  Vector in(const Vector& r) const { return {dot(u, r), dot(v, r), dot(w, r)}; }
  /// The dot products of the images of a, b and a x b, normalized, and their volume.
  template <class Rotation>
  std::array<T, 7> gram(const Rotation& R) const {
    const Vector p = R(unit(a)), q = R(unit(b)), r = R(cross(unit(a), unit(b)));
    return {dot(p, p), dot(p, q), dot(q, q), dot(p, r), dot(q, r), dot(r, r), dot(cross(p, q), r)};
  }
};
using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;
using Rotated = ProvableFormula<SampleOf>;

/// Three vectors as one value.
template <class T>
std::array<T, 9> stacked(const std::array<T, 3>& a, const std::array<T, 3>& b, const std::array<T, 3>& c) {
  return {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
}

/// Claims the image of a vector from its components, rotated, and from the rotated frame.
void sums(Table& table, const std::vector<Sample>& all, int line, const std::string& slug,
          const std::string& vector, const std::string& x, const Rotated& truth) {
  const auto is = [&](const std::string& way, const std::string& text) {
    table.formula(way + "_" + slug, line, "$R" + vector + "=" + text.substr(1), all,
                  {.quantity = "$R" + vector + "$", .truth = truth, .printed = text});
  };
  is("rotated", "$(c" + x + "_0-s" + x + R"(_1)\mathbf u+(s)" + x + "_0+c" + x + R"(_1)\mathbf v+)" + x +
                    R"(_2\mathbf w$)");
  is("linear", "$" + x + R"(_0R\mathbf u+)" + x + R"(_1R\mathbf v+)" + x + R"(_2R\mathbf w$)");
}

void proof(Table& table, const std::vector<Sample>& all) {
  const std::string by_quaternion = "by the quaternion product $q\\mathbf r q^*$";
  const std::string product = R"($R(\mathbf a\times\mathbf b)$)",
                    of_rotated = R"($(R\mathbf a)\times(R\mathbf b)$)";
  table.formula(
      "rigid", 623,
      R"(A rotation preserves all the relationships among $\mathbf a$, $\mathbf b$ and $\mathbf a\times\mathbf b$ (our )"
      R"(reading: their dot products and their volume).)",
      all,
      {.quantity = "their dot products and their volume",
       .truth = {"before the rotation",
                 [](const auto& m) { return m.gram([](const auto& r) { return r; }); }},
       .printed = {"after a rotation", [](const auto& m) { return m.gram(quaternion(m.w, m.theta)); }},
       .near_misses = {{"after a rotation and a reflection",
                        [](const Sample& m) { return m.gram(mirrored(quaternion(m.w, m.theta))); }}}});
  const Rotated rotated_product{by_quaternion, [](const auto& m) { return m.rotated(cross(m.a, m.b)); }};
  table.formula("identity", 623, R"($R(\mathbf a\times\mathbf b)=(R\mathbf a)\times(R\mathbf b)$)", all,
                {.quantity = product, .truth = rotated_product, .printed = of_rotated});
  table.formula(
      "frame", 627,
      R"($\mathbf u=\mathbf v\times\mathbf w$, $\mathbf v=\mathbf w\times\mathbf u$, $\mathbf w=\mathbf u\times\mathbf v$)",
      all,
      {.quantity = R"($\mathbf u$, $\mathbf v$ and $\mathbf w$)",
       .truth = {"random right-handed orthonormal frames",
                 [](const auto& m) { return stacked(m.u, m.v, m.w); }},
       .printed = R"($(\mathbf v\times\mathbf w,\ \mathbf w\times\mathbf u,\ \mathbf u\times\mathbf v)$)"});
  table.formula(
      "rotated_frame", 629,
      R"($R\mathbf u=c\mathbf u+s\mathbf v$, $R\mathbf v=-s\mathbf u+c\mathbf v$, $R\mathbf w=\mathbf w$)",
      all,
      {.quantity = R"($R\mathbf u$, $R\mathbf v$ and $R\mathbf w$)",
       .truth = {by_quaternion,
                 [](const auto& m) { return stacked(m.rotated(m.u), m.rotated(m.v), m.rotated(m.w)); }},
       .printed = R"($(c\mathbf u+s\mathbf v,\ -s\mathbf u+c\mathbf v,\ \mathbf w)$)"});
  const auto components = [&](const std::string& slug, int number, const std::string& vector,
                              const std::string& x, const Rotated& truth) {
    const std::string sum = x + R"(_0\mathbf u+)" + x + R"(_1\mathbf v+)" + x + R"(_2\mathbf w$)";
    table.formula("components_of_" + slug, number, "$" + vector + "=" + sum, all,
                  {.quantity = "$" + vector + "$", .truth = truth, .printed = "$" + sum});
  };
  components("a", 635, R"(\mathbf a)", "a", {"the vector", [](const auto& m) { return m.a; }});
  components("b", 637, R"(\mathbf b)", "b", {"the vector", [](const auto& m) { return m.b; }});
  components("product", 639, R"(\mathbf a\times\mathbf b)", "g",
             {"in world coordinates", [](const auto& m) { return cross(m.a, m.b); }});
  table.formula(
      "product_components", 641, R"($(g_0,g_1,g_2)=(a_1b_2-a_2b_1,a_2b_0-a_0b_2,a_0b_1-a_1b_0)$)", all,
      {.quantity = R"(the components of $\mathbf a\times\mathbf b$)",
       .truth =
           {R"($\mathbf a\times\mathbf b$ in world coordinates, times $\mathbf u$, $\mathbf v$, $\mathbf w$)",
            [](const auto& m) { return m.in(cross(m.a, m.b)); }},
       .printed = "$(a_1b_2-a_2b_1,a_2b_0-a_0b_2,a_0b_1-a_1b_0)$"});
  sums(table, all, 645, "a", R"(\mathbf a)", "a",
       {by_quaternion, [](const auto& m) { return m.rotated(m.a); }});
  sums(table, all, 647, "b", R"(\mathbf b)", "b",
       {by_quaternion, [](const auto& m) { return m.rotated(m.b); }});
  sums(table, all, 649, "product", R"((\mathbf a\times\mathbf b))", "g", rotated_product);

  const auto line = [&](const std::string& slug, int number, const std::string& what, const std::string& text,
                        const Rotated& truth, const std::string& in_words = "") {
    table.formula(slug, number, what.substr(0, what.size() - 1) + "=" + text.substr(1) + in_words, all,
                  {.quantity = "components of " + what, .truth = truth, .printed = text});
  };
  const Rotated product_of_rotated{by_quaternion,
                                   [](const auto& m) { return m.in(cross(m.rotated(m.a), m.rotated(m.b))); }};
  const Rotated in_frame{by_quaternion, [](const auto& m) { return m.in(m.rotated(cross(m.a, m.b))); }};
  const std::string turned = R"($(ca_0-sa_1,sa_0+ca_1,a_2)\times(cb_0-sb_1,sb_0+cb_1,b_2)$)";
  const std::string expansion =
      R"($(c(a_1b_2-a_2b_1)-s(a_2b_0-a_0b_2),\;s(a_1b_2-a_2b_1)+c(a_2b_0-a_0b_2),\;a_0b_1-a_1b_0)$)";
  line("coordinates", 653, of_rotated, turned, product_of_rotated, " in the frame");
  line("expanded", 655, of_rotated, expansion, product_of_rotated);
  line("turned_gamma", 659, product, "$(cg_0-sg_1,sg_0+cg_1,g_2)$", in_frame);
  line("product_expanded", 661, product, expansion, in_frame);
  table.formula("equal", 663, "The two expressions are equal.", all,
                {.quantity = "components of " + of_rotated + ", by those of " + product,
                 .truth = product_of_rotated,
                 .printed = "$(cg_0-sg_1,sg_0+cg_1,g_2)$"});
}

/// Two unit vectors, or a vector and -2 times it.
struct Edges {
  Vector a, b;
  bool parallel;

  std::string where() const { return R"($\mathbf a$ = )" + shown(a) + R"(, $\mathbf b$ = )" + shown(b); }
  /// The determinant of a, b and a x b, which is |a x b|^2.
  bool independent() const { return determinant(a, b, cross(a, b)) > 1e-12; }
};

constexpr const char* by_frame = R"(
  pose proof (orthonormal u0 u1 u2 v0 v1 v2) as all; cbv zeta in all; rewrite H2, H3, H4 in all;
  destruct (all H H0 H1) as
    ((w_w & u_w & v_w) & (x0 & x1 & x2) & (y0 & y1 & y2) & (z0 & z1 & z2) & in_frame); clear all H2 H3 H4;
  set (S := sin (theta / 2)); set (C := cos (theta / 2));
  assert (circle : C * C = 1 - S * S)
    by (unfold S, C; pose proof (sin2_cos2 (theta / 2)) as one; unfold Rsqr in one; lra);
  assert (sine : sin theta = 2 * (C * S))
    by (replace theta with (2 * (theta / 2)) at 1 by field; rewrite sin_2a; unfold S, C; ring);
  assert (cosine : cos theta = 1 - 2 * (S * S))
    by (replace theta with (2 * (theta / 2)) at 1 by field; rewrite cos_2a_sin; unfold S; ring);
  rewrite ?sine, ?cosine; clear sine cosine; clearbody S C;
  set (d0 := 1 / sqrt (a0 * a0 + a1 * a1 + a2 * a2) * a0);
  set (d1 := 1 / sqrt (a0 * a0 + a1 * a1 + a2 * a2) * a1);
  set (d2 := 1 / sqrt (a0 * a0 + a1 * a1 + a2 * a2) * a2);
  set (e0 := 1 / sqrt (b0 * b0 + b1 * b1 + b2 * b2) * b0);
  set (e1 := 1 / sqrt (b0 * b0 + b1 * b1 + b2 * b2) * b1);
  set (e2 := 1 / sqrt (b0 * b0 + b1 * b1 + b2 * b2) * b2);
  clearbody d0 d1 d2 e0 e1 e2;
  pose proof (in_frame a0 a1 a2) as fa; pose proof (in_frame b0 b1 b2) as fb;
  pose proof (in_frame d0 d1 d2) as fd; pose proof (in_frame e0 e1 e2) as fe; clear in_frame;
  cbv zeta in fa, fb, fd, fe;
  set (pa := u0 * a0 + _ + _) in *; set (qa := v0 * a0 + _ + _) in *; set (sa := w0 * a0 + _ + _) in *;
  set (pb := u0 * b0 + _ + _) in *; set (qb := v0 * b0 + _ + _) in *; set (sb := w0 * b0 + _ + _) in *;
  set (pd := u0 * d0 + _ + _) in *; set (qd := v0 * d0 + _ + _) in *; set (sd := w0 * d0 + _ + _) in *;
  set (pe := u0 * e0 + _ + _) in *; set (qe := v0 * e0 + _ + _) in *; set (se := w0 * e0 + _ + _) in *;
  clearbody pa qa sa pb qb sb pd qd sd pe qe se;
  destruct fa as (? & ? & ?); destruct fb as (? & ? & ?); destruct fd as (? & ? & ?);
  destruct fe as (? & ? & ?); subst a0 a1 a2 b0 b1 b2 d0 d1 d2 e0 e1 e2;
  repeat first [ product u0 v0 w0 u1 v1 w1 u2 v2 w2 S C x0 y0 z0
               | product u1 v1 w1 u2 v2 w2 u0 v0 w0 S C x1 y1 z1
               | product u2 v2 w2 u0 v0 w0 u1 v1 w1 S C x2 y2 z2
               | dot u0 u1 u2 v0 v1 v2 w0 w1 w2 H H0 w_w H1 u_w v_w ];
  first [ reflexivity | ring [circle] | ring [circle z0 z1 z2 y0 y1 y2 x0 x1 x2] | lra ])";

}  // namespace

std::vector<Claim> claims(double seed) {
  std::vector<Sample> all;
  std::vector<Edges> edges;
  Random random(seed), again(seed);
  for (int i = 0; i < 100; ++i) {
    all.emplace_back(random, i);
    const Sample m(again, 4);
    edges.push_back({unit(m.a), unit(m.b), false});
    if (i < 10) edges.push_back({unit(m.a), -2.0 * unit(m.a), true});
  }
  Claims claims("2.11");
  claims.statement<Edges>(
      "coordinate_frame", 623,
      R"(One can imagine $\mathbf a$, $\mathbf b$ and $\mathbf a\times\mathbf b$ as a coordinate frame (our condition: $\mathbf a$ and $\mathbf b$ are not parallel).)",
      edges,
      {.printed =
           {R"($\mathbf a$, $\mathbf b$ and $\mathbf a\times\mathbf b$ are independent where $\mathbf a$ and $\mathbf b$ are)",
            [](const Edges& e) { return e.parallel || e.independent(); }},
       .near_misses = {{R"(they are where $\mathbf a$ and $\mathbf b$ are parallel)",
                        [](const Edges& e) { return !e.parallel || e.independent(); }},
                       {R"(they are for any $\mathbf a$ and $\mathbf b$)",
                        [](const Edges& e) { return e.independent(); }}}});
  Table table(claims);
  proof(table, all);
  return claims.in_order();
}

Provables proofs() {
  Claims claims("2.11");
  Table table(claims);
  proof(table, {});
  const auto lettered = [](const std::string& name) {
    return std::array{Shortened::letter(name + "0"), Shortened::letter(name + "1"),
                      Shortened::letter(name + "2")};
  };
  SampleOf<Shortened> any;
  any.u = lettered("u"), any.v = lettered("v"), any.w = lettered("w");
  any.theta = Shortened::letter("theta");
  any.a = lettered("a"), any.b = lettered("b");
  const auto& [u, v, w, theta, a, b] = any;
  std::vector<Proposition> given{dot(u, u).expression() == 1, dot(v, v).expression() == 1,
                                 dot(u, v).expression() == 0};
  for (std::size_t i = 0; i < 3; ++i) given.push_back(cross(u, v)[i].expression() == w[i].expression());
  Provables proved = table.proofs(
      "2.11", {.any = any,
               .letters = "(u0 u1 u2 v0 v1 v2 w0 w1 w2 theta a0 a1 a2 b0 b1 b2 : R)",
               .given = given,
               .tactic = by_frame,
               .says = "it holds for any angle and any two vectors in any right-handed orthonormal frame"});
  for (Provable& p : proved) {
    const bool rigid = p.claim == "2.11-rigid";
    if (rigid) p.lemmas[0].tactic = "by_rotation a0 a1 a2 b0 b1 b2";
    p.preamble = coq_source({rigid ? "rotations" : "turned_frame"});
  }
  return proved;
}

}  // namespace oddity::ex02_11
