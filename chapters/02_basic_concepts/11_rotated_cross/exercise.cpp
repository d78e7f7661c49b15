// Exercise 2.11: R (a x b) = (R a) x (R b) for every rotation R.
//   R r = c r + s w x r + (1 - c) w (w . r),  c = cos theta, s = sin theta, |w| = 1   (Rodrigues)
// The text computes in an orthonormal frame {u, v, w} along the axis. The other route is the quaternion
// product q r q* in world coordinates, which has the half angle and no frame. Frames, angles and vectors are
// random.

#include <numbers>

#include "chapters/02_basic_concepts/shared/rotations.hpp"
#include "chapters/random.hpp"
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

  double c() const { return std::cos(theta); }
  double s() const { return std::sin(theta); }
  Vector rotated(const Vector& r) const { return quaternion(w, theta)(r); }
  /// Components along the frame, and back.
  Vector in(const Vector& r) const { return {dot(u, r), dot(v, r), dot(w, r)}; }
  Vector out(const Vector& x) const { return x[0] * u + x[1] * v + x[2] * w; }
  Vector alpha() const { return in(a); }
  Vector beta() const { return in(b); }
  Vector gamma() const { return in(cross(a, b)); }
};
using S = const Sample&;
using Formula = std::function<Value(S)>;

/// The first ones turn by 0, 90, 180 and 270 degrees.
Sample random_sample(Random& random, int i) {
  const Vector w = random.direction(), u = unit(cross(w, random.direction()));
  const double large = std::abs(random.magnitude(0.1, 100)), small = std::abs(random.magnitude(0.1, 100));
  return {u,
          cross(w, u),
          w,
          i < 4 ? i * std::numbers::pi / 2 : random.between(-7, 7),
          random.point(large),
          random.point(small)};
}

double one(S) { return 1; }
double of_vectors(S m) { return length(m.a) + length(m.b); }
double of_product(S m) { return 1 + length(m.a) * length(m.b); }

Reading compare(const std::string& text, const std::string& by, double (*size)(S), double seed,
                const Formula& formula, const Formula& truth) {
  Worst worst("against " + by, text, by);
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const Sample m = random_sample(random, i);
    worst.see(formula(m), truth(m), size(m), "theta = " + rounded(m.theta, 6) + ", w = " + shown(m.w));
  }
  return {text, {worst.check()}};
}

/// Both sides stacked: three vectors as one value.
Value stacked(const Vector& a, const Vector& b, const Vector& c) {
  return {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]};
}

/// The printed expansion of the product of the rotated vectors; `sign` belongs before the first s.
Value expanded(S m, double sign) {
  const auto [a0, a1, a2] = m.alpha();
  const auto [b0, b1, b2] = m.beta();
  const double first = a1 * b2 - a2 * b1, second = a2 * b0 - a0 * b2;
  return Vector{m.c() * first - sign * m.s() * second, m.c() * second + m.s() * first, a0 * b1 - a1 * b0};
}

/// (c x0 - s x1, s x0 + c x1, x2).
Vector turned(S m, const Vector& x, double sign = 1) {
  return {m.c() * x[0] - sign * m.s() * x[1], sign * m.s() * x[0] + m.c() * x[1], x[2]};
}

struct Row {
  std::string id;
  int line;
  std::string text, by;
  double (*size)(S);
  Formula printed, truth;
  std::string near_text;
  Formula near;
};

std::vector<Claim> claims(double seed) {
  const auto rotated_product = [](S m) { return Value(m.rotated(cross(m.a, m.b))); };
  const auto product_of_rotated = [](S m) { return Value(m.in(cross(m.rotated(m.a), m.rotated(m.b)))); };
  const auto by_gram = [](S m, const Map& R) {
    const Vector a = unit(m.a), b = unit(m.b), p = R(a), q = R(b), r = R(cross(a, b));
    return Value{dot(p, p), dot(p, q), dot(q, q), dot(p, r), dot(q, r), dot(r, r), dot(cross(p, q), r)};
  };
  const auto combined = [](Vector (Sample::*x)() const, double sign = 1) {
    return [=](S m) {
      const Vector k = (m.*x)();
      return Value(k[0] * m.rotated(m.u) + sign * k[1] * m.rotated(m.v) + k[2] * m.rotated(m.w));
    };
  };
  const auto in_frame = [](Vector (Sample::*x)() const, double sign = 1) {
    return [=](S m) { return Value(m.out(turned(m, (m.*x)(), sign))); };
  };
  const std::string q = "quaternion q r q*";
  const Row rows[] = {
      {"rigid", 623, "a rotation preserves the relationships of a, b and a x b",
       "their dot products before the rotation", one,
       [=](S m) { return by_gram(m, quaternion(m.w, m.theta)); },
       [=](S m) { return by_gram(m, [](const Vector& r) { return r; }); }, "so does a reflection",
       [=](S m) { return by_gram(m, mirrored(quaternion(m.w, m.theta))); }},
      {"identity", 623, "R (a x b) = (R a) x (R b)", "R by " + q, of_product, rotated_product,
       [](S m) { return Value(cross(m.rotated(m.a), m.rotated(m.b))); },
       "for a rotation and a mirror as well", [](S m) { return Value(-1.0 * m.rotated(cross(m.a, m.b))); }},
      {"frame", 627, "u = v x w, v = w x u, w = u x v", "random right-handed orthonormal frames", one,
       [](S m) { return stacked(cross(m.v, m.w), cross(m.w, m.u), cross(m.u, m.v)); },
       [](S m) { return stacked(m.u, m.v, m.w); }, "in left-handed frames",
       [](S m) { return stacked(cross(m.w, m.v), cross(m.u, m.w), cross(m.v, m.u)); }},
      {"rotated_frame", 629, "R u = c u + s v, R v = -s u + c v, R w = w", q, one,
       [](S m) { return stacked(m.c() * m.u + m.s() * m.v, m.c() * m.v - m.s() * m.u, m.w); },
       [](S m) { return stacked(m.rotated(m.u), m.rotated(m.v), m.rotated(m.w)); },
       "R u = c u - s v, R v = s u + c v",
       [](S m) { return stacked(m.c() * m.u - m.s() * m.v, m.c() * m.v + m.s() * m.u, m.w); }},
      {"components", 635, "a, b, a x b are sums of their components along u, v, w", "the vectors", of_product,
       [](S m) { return stacked(m.out(m.alpha()), m.out(m.beta()), m.out(m.gamma())); },
       [](S m) { return stacked(m.a, m.b, cross(m.a, m.b)); }, "with the first two exchanged",
       [](S m) {
         return stacked(m.out({m.alpha()[1], m.alpha()[0], m.alpha()[2]}), m.b, cross(m.a, m.b));
       }},
      {"product_components", 641, "gamma is the product of alpha and beta", "components of a x b", of_product,
       [](S m) { return Value(cross(m.alpha(), m.beta())); }, [](S m) { return Value(m.gamma()); },
       "the product of beta and alpha", [](S m) { return Value(cross(m.beta(), m.alpha())); }},
      {"rotated_a", 645, "R a = (c a0 - s a1) u + (s a0 + c a1) v + a2 w", q, of_vectors,
       in_frame(&Sample::alpha), [](S m) { return Value(m.rotated(m.a)); },
       "(c a0 + s a1) u + (-s a0 + c a1) v", in_frame(&Sample::alpha, -1)},
      {"linear_a", 645, "R a = a0 R u + a1 R v + a2 R w", q, of_vectors, combined(&Sample::alpha),
       [](S m) { return Value(m.rotated(m.a)); }, "a0 R u - a1 R v + a2 R w", combined(&Sample::alpha, -1)},
      {"rotated_b", 647, "R b = (c b0 - s b1) u + (s b0 + c b1) v + b2 w", q, of_vectors,
       in_frame(&Sample::beta), [](S m) { return Value(m.rotated(m.b)); },
       "(c b0 + s b1) u + (-s b0 + c b1) v", in_frame(&Sample::beta, -1)},
      {"linear_b", 647, "R b = b0 R u + b1 R v + b2 R w", q, of_vectors, combined(&Sample::beta),
       [](S m) { return Value(m.rotated(m.b)); }, "b0 R u - b1 R v + b2 R w", combined(&Sample::beta, -1)},
      {"rotated_product", 649, "R (a x b) = (c g0 - s g1) u + (s g0 + c g1) v + g2 w", q, of_product,
       in_frame(&Sample::gamma), rotated_product, "(c g0 + s g1) u + (-s g0 + c g1) v",
       in_frame(&Sample::gamma, -1)},
      {"linear_product", 649, "R (a x b) = g0 R u + g1 R v + g2 R w", q, of_product, combined(&Sample::gamma),
       rotated_product, "g0 R u - g1 R v + g2 R w", combined(&Sample::gamma, -1)},
      {"coordinates", 653, "(R a) x (R b) in the frame is the product of the two triples",
       "components by " + q, of_product,
       [](S m) { return Value(cross(turned(m, m.alpha()), turned(m, m.beta()))); }, product_of_rotated,
       "of triples with the second sign flipped",
       [](S m) { return Value(cross(turned(m, m.alpha()), turned(m, m.beta(), -1))); }},
      {"expanded", 655, "(R a) x (R b), multiplied out", "components by " + q, of_product,
       [](S m) { return expanded(m, 1); }, product_of_rotated, "+ s (a2 b0 - a0 b2) in the first component",
       [](S m) { return expanded(m, -1); }},
      {"turned_gamma", 659, "R (a x b) = (c g0 - s g1, s g0 + c g1, g2)", "components by " + q, of_product,
       [](S m) { return Value(turned(m, m.gamma())); },
       [](S m) { return Value(m.in(m.rotated(cross(m.a, m.b)))); }, "(c g0 + s g1, -s g0 + c g1, g2)",
       [](S m) { return Value(turned(m, m.gamma(), -1)); }},
      {"product_expanded", 661, "R (a x b), with gamma put in", "components by " + q, of_product,
       [](S m) { return expanded(m, 1); }, [](S m) { return Value(m.in(m.rotated(cross(m.a, m.b)))); },
       "+ s (a2 b0 - a0 b2) in the first component", [](S m) { return expanded(m, -1); }},
      {"equal", 663, "the two expansions are equal", "the product of alpha and beta, turned", of_product,
       [](S m) { return expanded(m, 1); }, [](S m) { return Value(turned(m, cross(m.alpha(), m.beta()))); },
       "equal but for a sign", [](S m) { return Value(-1.0 * turned(m, cross(m.alpha(), m.beta()))); }},
  };
  std::vector<Claim> all;
  for (const Row& row : rows)
    all.push_back({"2.11-" + row.id,
                   row.line,
                   row.text,
                   compare(row.text, row.by, row.size, seed, row.printed, row.truth),
                   {},
                   {},
                   {compare(row.near_text, row.by, row.size, seed, row.near, row.truth)}});
  return all;
}

/// a, b and a x b are independent when a and b are.
Claim coordinate_frame(double seed) {
  // The determinant of a, b and a x b is |a x b|^2.
  const auto dependent = [=](const std::string& text, int parallel) {
    Random random(seed);
    long wrong = 0, samples = 0;
    for (; samples < 100; ++samples) {
      const Sample m = random_sample(random, 4);
      const Vector a = unit(m.a), b = samples < parallel ? -2.0 * a : unit(m.b);
      const Vector n = cross(a, b);
      const double determinant = a[0] * (b[1] * n[2] - b[2] * n[1]) - a[1] * (b[0] * n[2] - b[2] * n[0]) +
                                 a[2] * (b[0] * n[1] - b[1] * n[0]);
      wrong += !(determinant > 1e-12);
    }
    return Reading{text, {never("samples with a, b, a x b not independent", wrong, samples)}};
  };
  Claim claim{"2.11-coordinate_frame", 623, "a, b and a x b form a coordinate frame, for any a and b"};
  claim.printed = dependent("any a and b, a tenth of them parallel", 10);
  claim.corrected = dependent("a and b not parallel", 0);
  claim.near_misses = {dependent("a and b parallel", 100)};
  claim.why =
      "Vectors that are parallel, $b=-2a$ or $b=0$, have the product 0, and span a line with it and not "
      "space. The picture fails there and the identity does not: both sides are 0. The proof, which uses "
      "another frame, covers the case.";
  return claim;
}

Findings study(const Parameters& p, const Reference& truth) {
  std::vector<Claim> all = claims(p["seed"]);
  all.insert(all.begin(), coordinate_frame(p["seed"]));
  return {all, {rotated_normal(p["theta"], p["gap"], truth), identity_gap(p["theta"]), sliver_normal(truth)}};
}

}  // namespace ex02_11

Exercise exercise_2_11() {
  using namespace ex02_11;
  return {"Rotation of a cross product",
          "Show that $R(a\\times b)=(Ra)\\times(Rb)$ for every rotation $R$. Below `c` and `s` are cosine "
          "and sine "
          "of its angle, `u`, `v`, `w` an orthonormal frame with `w` along its axis, and `a0`, `b0`, `g0`, "
          "... the "
          "components of $a$, $b$ and $a\\times b$ in that frame.",
          parameters,
          {},
          study};
}

}  // namespace oddity
