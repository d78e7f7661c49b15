// Exercise 2.11: R (a x b) = (R a) x (R b) for every rotation R.
//   R r = c r + s w x r + (1 - c) w (w . r),  c = cos theta, s = sin theta, |w| = 1   (Rodrigues)
// The text computes in an orthonormal frame {u, v, w} along the axis. The other route is the quaternion
// product q r q* in world coordinates, which has the half angle and no frame. Frames, angles and vectors are
// random.

#include <numbers>

#include "chapters/02_basic_concepts/shared/rotations.hpp"
#include "chapters/claims.hpp"
#include "reference/reference.hpp"

namespace oddity {

namespace ex02_11 {

using namespace rotation;

constexpr Parameter parameters[] = {
    {"theta", 2, "rad", "angle of the rotation", -6.5, 6.5},
    {"gap", 1, "", "distance of the triangle's two edge vectors", 0x1p-20, 1},
    {"seed", 11, "", "of the random samples", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

/// A rotation about the third axis of a right-handed frame, and two vectors.
struct Sample {
  Vector u, v, w;
  double theta;
  Vector a, b;

  /// The first ones turn by 0, 90, 180 and 270 degrees.
  Sample(Random& random, int i) : w(random.direction()) {
    u = unit(cross(w, random.direction())), v = cross(w, u);
    const double large = std::abs(random.magnitude(0.1, 100)), small = std::abs(random.magnitude(0.1, 100));
    theta = i < 4 ? i * std::numbers::pi / 2 : random.between(-7, 7);
    a = random.point(large), b = random.point(small);
  }
  std::array<double*, 7> letters() { return {&theta, &a[0], &a[1], &a[2], &b[0], &b[1], &b[2]}; }
  std::string where() const {
    return R"($\theta$ = )" + format_significant(theta, 6) + R"(, $\mathbf w$ = )" + shown(w);
  }

  double c() const { return std::cos(theta); }
  double s() const { return std::sin(theta); }
  Vector rotated(const Vector& r) const { return quaternion(w, theta)(r); }
  /// Components along the frame, and back.
  Vector in(const Vector& r) const { return {dot(u, r), dot(v, r), dot(w, r)}; }
  Vector out(const Vector& x) const { return x[0] * u + x[1] * v + x[2] * w; }
  Vector alpha() const { return in(a); }
  Vector beta() const { return in(b); }
  Vector gamma() const { return in(cross(a, b)); }
  /// (c x0 - s x1, s x0 + c x1, x2).
  Vector turned(const Vector& x, double sign = 1) const {
    return {c() * x[0] - sign * s() * x[1], sign * s() * x[0] + c() * x[1], x[2]};
  }
  /// The printed expansion of the product of the rotated vectors; `sign` belongs before the first s.
  Vector expanded(double sign) const {
    const auto [a0, a1, a2] = alpha();
    const auto [b0, b1, b2] = beta();
    const double first = a1 * b2 - a2 * b1, second = a2 * b0 - a0 * b2;
    return {c() * first - sign * s() * second, c() * second + s() * first, a0 * b1 - a1 * b0};
  }
  /// The dot products of a, b and a x b, of unit length, and their volume, after the map.
  Value gram(const Map& R) const {
    const Vector p = R(unit(a)), q = R(unit(b)), r = R(cross(unit(a), unit(b)));
    return {dot(p, p), dot(p, q), dot(q, q), dot(p, r), dot(q, r), dot(r, r), dot(cross(p, q), r)};
  }
};
using Rotated = Formula<Sample>;

/// Three vectors as one value.
Value stacked(const Vector& a, const Vector& b, const Vector& c) {
  return {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
}

/// A vector by its components in the frame, turned, and by the turned frame.
void sums(Claims& claims, const std::vector<Sample>& all, int line, const std::string& slug,
          const std::string& vector, const std::string& x, Vector (Sample::*components)() const,
          const Rotated& truth) {
  using S = const Sample&;
  const auto turned = [=](double sign) {
    return [=](S m) { return Value(m.out(m.turned((m.*components)(), sign))); };
  };
  const auto combined = [=](double sign) {
    return [=](S m) {
      const Vector k = (m.*components)();
      return Value(k[0] * m.rotated(m.u) + sign * k[1] * m.rotated(m.v) + k[2] * m.rotated(m.w));
    };
  };
  const auto by_frame = [&](const char* first, const char* second) {
    return "$(c" + x + "_0" + first + "s" + x + R"(_1)\mathbf u+()" + second + "s" + x + "_0+c" + x +
           R"(_1)\mathbf v+)" + x + R"(_2\mathbf w$)";
  };
  const auto by_rotated = [&](const char* sign) {
    return "$" + x + R"(_0R\mathbf u)" + sign + x + R"(_1R\mathbf v+)" + x + R"(_2R\mathbf w$)";
  };
  const std::string R = "$R" + vector + "$";
  claims.formula("rotated_" + slug, line, R + " is " + by_frame("-", ""), all,
                 {.quantity = R,
                  .truth = truth,
                  .printed = {by_frame("-", ""), turned(1)},
                  .near_misses = {{by_frame("+", "-"), turned(-1)}}});
  claims.formula("linear_" + slug, line, R + " is " + by_rotated("+"), all,
                 {.quantity = R,
                  .truth = truth,
                  .printed = {by_rotated("+"), combined(1)},
                  .near_misses = {{by_rotated("-"), combined(-1)}}});
}

void proof(Claims& claims, const std::vector<Sample>& all) {
  using S = const Sample&;
  const std::string by_quaternion = "by the quaternion product $q\\mathbf r q^*$";
  const std::string product = R"($R(\mathbf a\times\mathbf b)$)",
                    of_rotated = R"($(R\mathbf a)\times(R\mathbf b)$)";
  claims.formula(
      "rigid", 623,
      R"(a rotation preserves the relationships of $\mathbf a$, $\mathbf b$ and $\mathbf a\times\mathbf b$)",
      all,
      {.quantity = "their dot products and their volume",
       .truth = {"before the rotation", [](S m) { return m.gram([](const Vector& r) { return r; }); }},
       .printed = {"after a rotation", [](S m) { return m.gram(quaternion(m.w, m.theta)); }},
       .near_misses = {{"after a rotation and a reflection",
                        [](S m) { return m.gram(mirrored(quaternion(m.w, m.theta))); }}}});
  const Rotated rotated_product{by_quaternion, [](S m) { return Value(m.rotated(cross(m.a, m.b))); }};
  claims.formula("identity", 623, R"($R(\mathbf a\times\mathbf b)=(R\mathbf a)\times(R\mathbf b)$)", all,
                 {.truth = {of_rotated + " " + by_quaternion,
                            [](S m) { return Value(cross(m.rotated(m.a), m.rotated(m.b))); }},
                  .printed = {product + " for a rotation", rotated_product.of},
                  .near_misses = {{product + " for a rotation and a mirror",
                                   [](S m) { return Value(-1.0 * m.rotated(cross(m.a, m.b))); }}}});
  claims.formula(
      "frame", 627,
      R"($\mathbf u=\mathbf v\times\mathbf w$, $\mathbf v=\mathbf w\times\mathbf u$, $\mathbf w=\mathbf u\times\mathbf v$)",
      all,
      {.quantity = R"($\mathbf u$, $\mathbf v$ and $\mathbf w$)",
       .truth = {"random right-handed orthonormal frames", [](S m) { return stacked(m.u, m.v, m.w); }},
       .printed = {"the three products",
                   [](S m) { return stacked(cross(m.v, m.w), cross(m.w, m.u), cross(m.u, m.v)); }},
       .near_misses = {{"the products of a left-handed frame",
                        [](S m) { return stacked(cross(m.w, m.v), cross(m.u, m.w), cross(m.v, m.u)); }}}});
  const auto turned_frame = [](double sign) {
    return
        [=](S m) { return stacked(m.c() * m.u + sign * m.s() * m.v, m.c() * m.v - sign * m.s() * m.u, m.w); };
  };
  claims.formula(
      "rotated_frame", 629,
      R"($R\mathbf u=c\mathbf u+s\mathbf v$, $R\mathbf v=-s\mathbf u+c\mathbf v$, $R\mathbf w=\mathbf w$)",
      all,
      {.quantity = R"($R\mathbf u$, $R\mathbf v$ and $R\mathbf w$)",
       .truth = {by_quaternion, [](S m) { return stacked(m.rotated(m.u), m.rotated(m.v), m.rotated(m.w)); }},
       .printed = {"the three sums", turned_frame(1)},
       .near_misses = {{R"(the sums with $-s$ for $s$)", turned_frame(-1)}}});
  claims.formula(
      "components", 635,
      R"($\mathbf a$, $\mathbf b$ and $\mathbf a\times\mathbf b$ are sums of their components along $\mathbf u$, $\mathbf v$, $\mathbf w$)",
      all,
      {.truth = {"the vectors", [](S m) { return stacked(m.a, m.b, cross(m.a, m.b)); }},
       .printed = {"the sums",
                   [](S m) { return stacked(m.out(m.alpha()), m.out(m.beta()), m.out(m.gamma())); }},
       .near_misses = {
           {R"(the sums with $a_0$ and $a_1$ exchanged)", [](S m) {
              return stacked(m.out({m.alpha()[1], m.alpha()[0], m.alpha()[2]}), m.b, cross(m.a, m.b));
            }}}});
  claims.formula(
      "product_components", 641, R"($(g_0,g_1,g_2)=(a_0,a_1,a_2)\times(b_0,b_1,b_2)$)", all,
      {.truth = {R"(the components of $\mathbf a\times\mathbf b$)", [](S m) { return Value(m.gamma()); }},
       .printed = {R"(the product of the triples of $\mathbf a$ and $\mathbf b$)",
                   [](S m) { return Value(cross(m.alpha(), m.beta())); }},
       .near_misses = {{R"(the product of those of $\mathbf b$ and $\mathbf a$)",
                        [](S m) { return Value(cross(m.beta(), m.alpha())); }}}});
  sums(claims, all, 645, "a", R"(\mathbf a)", "a", &Sample::alpha,
       {by_quaternion, [](S m) { return Value(m.rotated(m.a)); }});
  sums(claims, all, 647, "b", R"(\mathbf b)", "b", &Sample::beta,
       {by_quaternion, [](S m) { return Value(m.rotated(m.b)); }});
  sums(claims, all, 649, "product", R"((\mathbf a\times\mathbf b))", "g", &Sample::gamma, rotated_product);

  const Rotated product_of_rotated{by_quaternion,
                                   [](S m) { return Value(m.in(cross(m.rotated(m.a), m.rotated(m.b)))); }};
  const Rotated in_frame{by_quaternion, [](S m) { return Value(m.in(m.rotated(cross(m.a, m.b)))); }};
  const auto triples = [](double sign) {
    return [=](S m) { return Value(cross(m.turned(m.alpha()), m.turned(m.beta(), sign))); };
  };
  claims.formula("coordinates", 653, of_rotated + " in the frame is the product of the two triples", all,
                 {.quantity = "components of " + of_rotated,
                  .truth = product_of_rotated,
                  .printed = {"the product of the turned triples", triples(1)},
                  .near_misses = {{"the product with the second turned back", triples(-1)}}});
  const Rotated expansion{
      R"($(c(a_1b_2-a_2b_1)-s(a_2b_0-a_0b_2),\;s(a_1b_2-a_2b_1)+c(a_2b_0-a_0b_2),\;a_0b_1-a_1b_0)$)",
      [](S m) { return Value(m.expanded(1)); }};
  const Rotated flipped{R"(the same with $+s(a_2b_0-a_0b_2)$ in the first)",
                        [](S m) { return Value(m.expanded(-1)); }};
  const auto expanded = [&](std::string_view slug, int line, const std::string& says, const std::string& what,
                            const Rotated& truth) {
    claims.formula(slug, line, says, all,
                   {.quantity = "components of " + what,
                    .truth = truth,
                    .printed = expansion,
                    .near_misses = {flipped}});
  };
  expanded("expanded", 655, of_rotated + " multiplied out", of_rotated, product_of_rotated);
  const auto turned = [](double sign) { return [=](S m) { return Value(m.turned(m.gamma(), sign)); }; };
  claims.formula("turned_gamma", 659, R"($R(\mathbf a\times\mathbf b)=(cg_0-sg_1,sg_0+cg_1,g_2)$)", all,
                 {.quantity = "components of " + product,
                  .truth = in_frame,
                  .printed = {R"($(cg_0-sg_1,sg_0+cg_1,g_2)$)", turned(1)},
                  .near_misses = {{R"($(cg_0+sg_1,-sg_0+cg_1,g_2)$)", turned(-1)}}});
  expanded("product_expanded", 661, product + R"(, with $(g_0,g_1,g_2)$ put in)", product, in_frame);
  claims.formula("equal", 663, "the two expansions are equal", all,
                 {.truth = {R"(the product of the triples of $\mathbf a$ and $\mathbf b$, turned)",
                            [](S m) { return Value(m.turned(cross(m.alpha(), m.beta()))); }},
                  .printed = expansion,
                  .near_misses = {{"its negative", [](S m) { return Value(-1.0 * m.expanded(1)); }}}});
}

/// Two unit vectors, or a vector and minus its double.
struct Edges {
  Vector a, b;
  bool parallel;

  std::string where() const { return R"($\mathbf a$ = )" + shown(a) + R"(, $\mathbf b$ = )" + shown(b); }
  /// The determinant of a, b and a x b, which is |a x b|^2.
  bool independent() const {
    const Vector n = cross(a, b);
    return a[0] * (b[1] * n[2] - b[2] * n[1]) - a[1] * (b[0] * n[2] - b[2] * n[0]) +
               a[2] * (b[0] * n[1] - b[1] * n[0]) >
           1e-12;
  }
};

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
      R"($\mathbf a$, $\mathbf b$ and $\mathbf a\times\mathbf b$ form a coordinate frame, for any $\mathbf a$ and $\mathbf b$)",
      edges,
      {.printed =
           {R"(any $\mathbf a$, $\mathbf b$ are independent of each other and of $\mathbf a\times\mathbf b$)",
            [](const Edges& e) { return e.independent(); }},
       .corrected = {R"($\mathbf a$ and $\mathbf b$ are, where they are not parallel)",
                     [](const Edges& e) { return e.parallel || e.independent(); }},
       .near_misses = {{R"($\mathbf a$ and $\mathbf b$ are, where they are parallel)",
                        [](const Edges& e) { return !e.parallel || e.independent(); }}},
       .kind = Fault::counterexample,
       .root = "parallel vectors",
       .why =
           R"(Vectors that are parallel, $\mathbf b=-2\mathbf a$ or $\mathbf b=0$, have the product 0, and span a )"
           R"(line with it and not space. The picture fails there and the identity does not: both sides are 0. The )"
           R"(proof, which uses another frame, covers the case.)"});
  proof(claims, all);
  return claims.in_order();
}

std::vector<Root> roots() {
  return {
      {"parallel vectors",
       R"(Axes made of the edges $\mathbf a$ and $-2\mathbf a$ have volume 0: the third has length 0, and made a )"
       R"(unit vector it is NaN.)"}};
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(p["seed"]),
          {rotated_normal(p["theta"], p["gap"], truth), identity_gap(p["theta"]), sliver_normal(truth)},
          roots()};
}

}  // namespace ex02_11

Exercise exercise_2_11() {
  using namespace ex02_11;
  return {
      "Rotation of a cross product",
      R"(Show that $R(\mathbf a\times\mathbf b)=(R\mathbf a)\times(R\mathbf b)$ for every rotation $R$. Below )"
      R"($c$ and $s$ are cosine and sine of its angle, $\mathbf u$, $\mathbf v$, $\mathbf w$ an orthonormal frame )"
      R"(with $\mathbf w$ along its axis, and $a_i$, $b_i$, $g_i$ the components of $\mathbf a$, $\mathbf b$ and )"
      R"($\mathbf a\times\mathbf b$ in that frame.)",
      parameters,
      {},
      study};
}

}  // namespace oddity
