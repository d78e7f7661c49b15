#include "chapters/claims.hpp"

#include <Eigen/Geometry>

#include "chapters/06_physics_engines/05_two_point_contact/two_point_contact.hpp"
#include "chapters/integral_proofs.hpp"
#include "chapters/provable_claims.hpp"
#include "solvers/quadrature.hpp"

namespace Eigen {

template <>
struct NumTraits<oddity::Shortened> : GenericNumTraits<oddity::Shortened> {
  enum { RequireInitialization = 1 };
};

}  // namespace Eigen

/// The displayed lines of the two-point contact, and the book's conclusions from them, on random bodies.
namespace oddity::ex06_05 {

template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;

template <class T>
using Matrix = Eigen::Matrix<T, 3, 3>;

// Recorded, a body has the inverse of its inertia.
inline Matrix<Shortened> inverse(const Matrix<Shortened>& recorded) { return recorded; }
inline Vector<Shortened> turned(const Matrix<Shortened>& recorded, const Vector<Shortened>& momentum) {
  return recorded * momentum;
}

namespace {

Vector3d vector(const std::array<double, 3>& a) { return Vector3d(a.data()); }

/// A box of constant density at a random position and orientation, by a random unit quaternion.
Body random_box(Random& random) {
  const double mass = random.between(0.5, 2);
  Eigen::Vector4d q;
  for (int i = 4; i-- > 0;) q[i] = random.normal();
  const Matrix3d r = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  const double c = random.between(0.5, 2), b = random.between(0.5, 2), a = random.between(0.5, 2);
  return {mass, r * box_inertia(mass, a, b, c) * r.transpose(), vector(random.point()),
          vector(random.point()), vector(random.point())};
}

/// Eight unequal masses: a body of very uneven density.
Body random_masses(Random& random) {
  const auto about_origin = [](double m, const Vector3d& x) -> Matrix3d {
    return m * (x.squaredNorm() * Matrix3d::Identity() - x * x.transpose());
  };
  Body body{0, Matrix3d::Zero(), Vector3d::Zero(), vector(random.point()), vector(random.point())};
  for (int i = 0; i < 8; ++i) {
    const Vector3d x = vector(random.point(2));
    const double m = random.between(0.02, 0.5);
    body.mass += m;
    body.center += m * x;
    body.inertia += about_origin(m, x);
  }
  body.center /= body.mass;
  body.inertia -= about_origin(body.mass, body.center);
  return body;
}

/// A smooth function of the place.
constexpr auto G = [](const auto& x) {
  using std::cos, std::exp;
  return exp(0.5 * x[0]) * cos(x[1]) + x[2] * x[2] * x[0];
};

/// A body, the impulse f N and its two points.
template <class T>
struct SampleOf {
  BodyOf<T> body;
  Vector<T> p0, p1, normal;
  T f;
  Tolerance (*allowed)(const SampleOf<double>&) = nullptr;

  Vector<T> arm(const Vector<T>& p) const { return p - body.center; }
  Vector<T> torque(const Vector<T>& p) const { return arm(p).cross(f * normal); }
  /// Bound for the change of v by the impulse.
  double kick() const { return std::abs(f) / body.mass; }
  Tolerance tolerance(double terms) const { return allowed ? allowed(*this) : rounding(terms); }

  std::vector<T*> letters() {
    std::vector<T*> all{&body.mass, &f};
    for (Vector<T>* x : {&body.center, &body.v, &body.w, &p0, &p1, &normal})
      for (T& each : *x) all.push_back(&each);
    for (int i = 0; i < 9; ++i) all.push_back(&body.inertia(i / 3, i % 3));
    return all;
  }
  TypesetIn<T> typeset() const {
    const auto all = [](const auto& x) {
      std::vector<T> by_rows;
      for (int i = 0; i < x.size(); ++i) by_rows.push_back(x(i / x.cols(), i % x.cols()));
      return by_rows;
    };
    TypesetIn<T> letters{
        {"f", f}, {"m", body.mass}, {"v^-", all(body.v)}, {"w^-", all(body.w)}, {"N", all(normal)}};
    letters.emplace_back("J^{-1}", all(inverse(body.inertia)));
    for (const auto& [name, x] :
         {std::pair<std::string, Vector<T>>{"(P_0)", p0}, {"(P_1)", p1}, {"(M)", (p0 + p1) / 2.0}}) {
      letters.emplace_back("r" + name, all(arm(x)));
      letters.emplace_back("G" + name, G(x));
    }
    return letters;
  }
};
using Sample = SampleOf<double>;
using Samples = std::vector<Sample>;
using Form = ProvableFormula<SampleOf>;
using Table = ProvableClaims<SampleOf>;

/// Bound of the coordinates of the points of contact.
constexpr double reach = 2;

Samples draw_bodies(double seed, Body (*make_body)(Random&)) {
  Random random(seed);
  Samples all;
  for (int n = 0; n < 40; ++n) {
    const Body body = make_body(random);
    const Vector3d normal = vector(random.direction());
    const double f = random.magnitude(0.1, 3);
    all.push_back({body, vector(random.point(reach)), vector(random.point(reach)), normal, f});
  }
  return all;
}
Samples judged_by(Tolerance (*allowed)(const Sample&), Samples all) {
  for (Sample& s : all) s.allowed = allowed;
  return all;
}

// ---- the delta function -----------------------------------------------------------------------------------

/// By default over the unit interval.
template <class T, class F>
T integral_of(const F& f, const T& from = 0.0, const T& to = 1.0) {
  if constexpr (std::same_as<T, Shortened>)
    return recorded_integral(f, from, to);
  else
    return gauss_legendre(f, from, to, 4).value;
}

constexpr double width = 1e-3;

/// The mean of g over a cube about p: an approximate delta function. Recorded, the half side is any h.
template <class T, class F>
T near_point(const F& g, const Vector<T>& p) {
  T h = width;
  if constexpr (std::same_as<T, Shortened>) h = T::letter("h");
  const auto along = [&](int i, const auto& f) { return integral_of<T>(f, p[i] - h, p[i] + h); };
  const T all = along(0, [&](const T& x) {
    return along(1,
                 [&](const T& y) { return along(2, [&](const T& z) { return T(g(Vector<T>(x, y, z))); }); });
  });
  return all / (8.0 * h * h * h);
}

/// The integral of g times `weight` delta functions at each point.
template <class T, class F>
T sifted(const SampleOf<T>& s, double weight, const F& g) {
  return weight * near_point(g, s.p0) + weight * near_point(g, s.p1);
}

/// The error of means over cubes is a sixth of the Laplacian, -3/4 exp(x/2) cos y + 2x.
Tolerance of_G(const Sample&) {
  const double curving = 0.75 * std::exp(0.5 * reach) + 2 * reach;
  return {width * width / 6 * curving,
          filled("the cube's half side squared times a sixth of $G$'s Laplacian, at most @2", {curving})};
}

// ---- the velocities ---------------------------------------------------------------------------------------

constexpr double pulse = 1e-6;

/// Error of the pulse's integral by 128 steps, from the first term of Simpson's error at the half steps. At
/// its ends 630 t^4 (1 - t)^4 has the fifth derivatives -+302400.
constexpr double steps_leave = 604800 / 1512.0 * 0x1p-48;
constexpr double rounded_ends = 64 * 0x1p-52 / width;
constexpr double roundings = 16;

/// A pulse does not rotate v: the error is that of its integral, and the rounded bounds of the narrow cubes.
Tolerance of_v(const Sample& s) {
  return {
      (steps_leave + rounded_ends) * s.kick() + roundings * 0x1p-52 * s.body.v.norm(),
      filled("$@2$ of the impulse by the steps of the pulse, $@2$ by the rounded ends of the cubes, and @2 "
             "roundings of $v^-$",
             {steps_leave, rounded_ends, roundings})};
}

/// During the pulse the body turns at most by the pulse's length times |w| plus the impulse's change of it.
/// Arms and inertia turn with the body.
Tolerance of_w(const Sample& s) {
  const double impulse = std::abs(s.f) * std::max(s.arm(s.p0).norm(), s.arm(s.p1).norm()),
               yielding = inverse(s.body.inertia).cwiseAbs().sum(), twist = yielding * impulse,
               turn = pulse * (s.body.w.norm() + twist),
               momentum = (s.body.inertia * s.body.w).norm() + impulse;
  return {
      2 * turn * yielding * momentum + (steps_leave + rounded_ends) * twist +
          roundings * 0x1p-52 * s.body.w.norm(),
      filled("in a pulse of $@1$ s the body, its arms and its inertia turn by no more than that times $|w|$ "
             "and its change, plus the error allowed for $v^+$",
             {pulse})};
}

/// Rounding of the means over narrow cubes.
Tolerance of_mean(const Sample& s) { return rounding((s.body.v.norm() + 2 * s.kick()) / width, 16); }

/// v+ or w+, by the sum or integral of impulses or torques over the points of contact.
template <class T, class F>
Vector<T> after(bool turning, const SampleOf<T>& s, const F& over_points) {
  Vector<T> all;
  for (int k = 0; k < 3; ++k)
    all[k] = over_points([&](const Vector<T>& x) { return turning ? T(s.torque(x)[k]) : s.f * s.normal[k]; });
  if (turning) return s.body.w + turned(s.body.inertia, all);
  return s.body.v + all / s.body.mass;
}

/// After a pulse shared by the two points, which move with the body. Recorded, its integral has the arms at
/// its begin.
Form motion(bool turning, double first = 0.5) {
  const std::string text =
      first == 0.5 ? "half the pulse at either point" : "three quarters of the pulse at $P_0$";
  return {"motion under " + text, [=]<class T>(const SampleOf<T>& s) -> Vector<T> {
            if constexpr (std::same_as<T, double>)
              return Vector3d(
                  &after_pulse(s.body, {s.p0, s.p1, s.f * s.normal, first}, pulse).value[turning ? 3 : 0]);
            else
              return after(turning, s, [&](const auto& g) {
                return integral_of<T>([&](const T& t) {
                  const T bump = t * t * (1.0 - t) * (1.0 - t);
                  return 630.0 * bump * bump * (0.5 * g(s.p0) + 0.5 * g(s.p1));
                });
              });
          }};
}

/// The double integral of the first lines, with narrow delta functions.
Form impulses(bool turning, double weight) {
  return {
      std::string(turning ? R"($w^-+J^{-1}\int r\times fN)" : R"($v^-+\frac1m\int fN)") +
          R"(\,\delta\,dX$ over two narrow delta functions, their )" + (weight == 1 ? "sum" : "mean"),
      [=](const auto& s) { return after(turning, s, [&](const auto& g) { return sifted(s, weight, g); }); }};
}

const Form mean_torque{"half the impulse at either point", [](const auto& s) {
                         return after(true, s, [&](const auto& g) { return 0.5 * g(s.p0) + 0.5 * g(s.p1); });
                       }};

const std::string factor_of_one = "a factor of one may be left out";

void velocities(Table& table, const Samples& all) {
  const Samples by_v = judged_by(of_v, all), by_w = judged_by(of_w, all), by_mean = judged_by(of_mean, all);
  const auto v = table.over(by_v), w = table.over(by_w), claim = table.over(all);
  v("linear_integral", 3753, R"($v^+=v^-+\frac1m\int\int fN\,\delta(t-t_0)\,\delta(X,S)\,dt\,dX$)",
    {.quantity = "$v^+$",
     .truth = motion(false),
     .printed = impulses(false, 0.5),
     .near_misses = {impulses(false, 1)}});
  table.over(by_mean)("linear_mean", 3757,
                      R"($v^+=v^-+\frac1m\frac{fN+fN}2$, the integral being the mean of the two impulses)",
                      impulses(false, 0.5), R"($v^-+\frac1m\frac{fN+fN}2$)", "$v^+$");
  v.equation("linear_result", 3761, "$v^+=v^-+fN/m$", motion(false));
  w("angular_integral", 3767,
    R"($w^+=w^-+J^{-1}\int\int r(X,t)\times fN\,\delta(t-t_0)\,\delta(X,S)\,dt\,dX$)",
    {.quantity = "$w^+$",
     .truth = motion(true),
     .printed = impulses(true, 0.5),
     .near_misses = {impulses(true, 1)}});
  w.equation("angular_mean", 3771, R"($w^+=w^-+\frac12J^{-1}(r(P_0)\times fN+r(P_1)\times fN)$)",
             motion(true), factor_of_one);
  claim.equation("angular_mean_arm", 3777, R"($w^+=w^-+J^{-1}(\frac{r(P_0)+r(P_1)}2\times fN)$)",
                 mean_torque);
  claim("angular_midpoint", 3783, R"($w^+=w^-+J^{-1}(r(M)\times fN)$ with the midpoint $M=(P_0+P_1)/2$)",
        {.quantity = "$w^+$",
         .truth = mean_torque,
         .printed = R"($w^-+J^{-1}(r(M)\times fN)$)",
         .near_misses = {motion(true, 0.75)}});
}

// ---- segments, faces and densities ------------------------------------------------------------------------

/// w+ for the impulse spread along P0 P1 with density 1 + slope (2u - 1) at the fraction u.
Form along_segment(const std::string& text, double slope) {
  return {text, [=]<class T>(const SampleOf<T>& s) {
            return after(true, s, [&](const auto& g) {
              return integral_of<T>(
                  [&](const T& u) { return (1 + slope * (2 * u - 1)) * g((1 - u) * s.p0 + u * s.p1); });
            });
          }};
}
const Form even_segment = along_segment("even pressure along the segment", 0);

void segment(Table& table, const Samples& bodies) {
  table.over(bodies)(
      "segment", 3785,
      "two points give exactly the result of the line segment (our reading, as that is not in the solutions: "
      "evenly pressed)",
      {.quantity = "$w^+$",
       .truth = mean_torque,
       .printed = even_segment,
       .near_misses = {along_segment("pressure growing by half along the segment", 0.2)}});
}

/// A trapezoid at P0 with the parallel sides e = P1 - P0 and `ratio` times e, and the side a. A ratio of 0
/// gives a triangle.
template <class T>
struct Trapezoid {
  Vector<T> p0, e, a;
  T ratio;

  Vector<T> point(const T& u, const T& v) const { return p0 + u * e + v * (a + u * (ratio - 1) * e); }
  /// The area element per du dv as a vector, and as a fraction of that of the sides e and a.
  Vector<T> element(const T& u, const T& v) const {
    return Vector<T>(e + v * (ratio - 1) * e).cross(Vector<T>(a + u * (ratio - 1) * e));
  }
  T fraction(const T& v) const { return 1.0 + v * (ratio - 1); }
};

/// w+ for the impulse spread evenly over the area.
template <class T>
Vector<T> over_area(const SampleOf<T>& s, const Trapezoid<T>& area) {
  const auto integral = [&](const auto& g) {
    return integral_of<T>([&](const T& u) {
      return integral_of<T>([&](const T& v) {
        if constexpr (std::same_as<T, double>)
          return area.element(u, v).norm() * g(area.point(u, v));
        else
          return area.fraction(v) * g(area.point(u, v));
      });
    });
  };
  return after(true, s, [&](const auto& g) {
    return integral(g) / integral([](const Vector<T>&) { return T(1.0); });
  });
}

/// w+ by equal impulses at the corners.
template <class T>
Vector<T> at_corners(const SampleOf<T>& s, const Trapezoid<T>& area, int corners) {
  return after(true, s, [&](const auto& g) {
    const T three = g(area.p0) + g(area.p0 + area.e) + g(area.p0 + area.a);
    return T(corners == 3 ? three / 3.0 : (three + g(area.point(1.0, 1.0))) / 4.0);
  });
}

/// Compares equal impulses at the corners with an even impulse over the area.
Check as_area(const Samples& all, const std::string& shape, double ratio) {
  const auto area = [=](const Sample& s) -> Trapezoid<double> {
    const Vector3d e = s.p1 - s.p0;
    return {s.p0, e, Vector3d(e[1], e[2], e[0]) + 0.5 * e, ratio};
  };
  return compare<Sample>(
      "$w^+$, " + shape,
      {"equal impulses at the corners",
       [=](const Sample& s) { return at_corners(s, area(s), ratio == 0 ? 3 : 4); }},
      {"spread evenly over the area", [=](const Sample& s) { return over_area(s, area(s)); }}, all);
}

void finite_set(Claims& claims, const Samples& bodies, const Samples& boxes) {
  // For a trapezoid with the parallel sides 2 and 1, over its height.
  const double mean = (0 + 0 + 1 + 1) / 4.0,
               centroid = integral_of<double>([](double v) { return v * (2 - v); }) /
                          integral_of<double>([](double v) { return 2 - v; });
  const Check segment =
                  compare<Sample>("$w^+$ of boxes and unequal masses", mean_torque, even_segment, bodies),
              triangles = as_area(boxes, "triangles", 0),
              parallelograms = as_area(boxes, "parallelograms", 1);
  claims.add(
      "finite_set", 3785,
      "the assumption of only finitely many contact points is no approximation, at least for bodies of "
      "constant density (our reading: equal impulses at the contact's corners replace an even one)",
      {.printed = {"for any contact: segments, triangles, parallelograms and trapezoids",
                   {segment, triangles, parallelograms, as_area(boxes, R"(trapezoids, $1:\frac12$)", 0.5)}},
       .corrected = {"for segments, and where the corners' mean is the area's centroid: triangles, "
                     "parallelograms",
                     {segment, triangles, parallelograms}},
       .near_misses = {{"trapezoids alone, $1:0.9$", {as_area(boxes, "trapezoids, $1:0.9$", 0.9)}}},
       .why = filled(
           "Two points do replace an evenly pressed segment, but the mean of a trapezoid's corners is not its "
           "centroid. With parallel sides 2 and 1 it lies at @1 of the height, and the centroid at @3. The "
           "torque about the long side is then @3 times the right one. Corners weighted by area (a third of "
           "each triangle's share) give the face's result exactly.",
           {mean, centroid, mean / centroid}),
       .kind = Fault::counterexample,
       .root = "corners for a face"});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const auto all = draw_bodies(seed, random_masses), boxes = draw_bodies(seed, random_box);
  Samples bodies = boxes;
  bodies.insert(bodies.end(), all.begin(), all.end());
  Claims claims("6.5");
  Table table(claims);
  claims.over(judged_by(of_G, all))(
      "delta", 3743,
      R"($\int G(X)\,\delta(X,S)\,dX=\frac12(G(P_0)+G(P_1))$ for the average of two delta functions)",
      {.quantity = R"($\int G(X)\,\delta(X,S)\,dX$)",
       .truth = {"narrow cubes about both points, weight 0.5 each",
                 [](const Sample& s) { return sifted(s, 0.5, G); }},
       .printed = {R"($\frac12(G(P_0)+G(P_1))$)"},
       .near_misses = {{"$G(M)$"}},
       .changes_that_hold = factor_of_one});
  velocities(table, all);
  segment(table, bodies);
  finite_set(claims, bodies, boxes);
  return claims.in_order();
}

std::vector<Root> roots(const Parameters& p, const Quantity& patch) {
  return {
      {"corners for a face",
       filled(
           R"(A box of $@3\times@3\times@3$ m and @3 kg, hit from below with @3 N s spread evenly over a )"
           R"(trapezoid, starts tipping over its long side at @2 rad/s. Equal impulses at the four corners )"
           "do not tip it over that side at all.",
           {p["a"], p["b"], p["c"], p["m"], p["f"], std::abs(patch.reference.value[0])})}};
}

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

/// Proves that impulses at the corners of triangles and parallelograms, as at the ends of a segment, replace
/// the whole; those of a trapezoid do not.
Provable proof_of_finite_set(const ForAll<SampleOf>& all, Lemma segment) {
  const auto letter = Shortened::letter;
  const auto& s = all.any;
  const Shortened u = letter("u"), v = letter("v");
  Trapezoid<Shortened> area{s.p0, s.p1 - s.p0, {letter("a0"), letter("a1"), letter("a2")}, letter("ratio")};
  std::string with_side = all.letters;
  with_side.insert(1, "a0 a1 a2 ratio u v ");
  const auto lemma = [&](const char* name, const Vector<Shortened>& x, const Vector<Shortened>& y,
                         const char* tactic) -> Lemma {
    return {name, with_side, {}, equal(detail::recorded_value(x), detail::recorded_value(y)), tactic};
  };
  segment.name = "corrected_segment";
  Provable proof{
      "6.5-finite_set",
      "as corrected it holds for any segment, triangle and parallelogram; a trapezoid's corners are "
      "off at an example",
      {segment, lemma("element", area.element(u, v), area.fraction(v) * area.e.cross(area.a), "ring")},
      0.05};
  for (const auto& [shape, ratio] :
       {std::pair("corrected_triangle", 0.0), {"corrected_parallelogram", 1.0}}) {
    area.ratio = ratio;
    proof.lemmas.push_back(lemma(shape, at_corners(s, area, ratio == 0 ? 3 : 4), over_area(s, area),
                                 "over_squares; field; lra"));
  }
  SampleOf<Shortened> example;
  example.f = example.body.mass = example.p1[0] = example.normal[2] = 1.0;
  example.body.inertia.setIdentity();
  area = {example.p0, example.p1, Vector<Shortened>::Unit(1), 0.5};
  const auto off = apart(at_corners(example, area, 4)[0].expression(),
                         over_area(example, area)[0].expression(), proof.margin);
  proof.lemmas.push_back({"printed_differs", "", {}, {off}, "over_squares; interval"});
  return proof;
}

}  // namespace

Provables proofs() {
  Claims claims("6.5");
  Table table(claims);
  velocities(table, {});
  segment(table, {});
  std::vector<std::string> names{"m", "f"};
  for (const char* name : {"c", "v", "w", "p", "q", "n", "k0", "k1", "k2"})
    for (const char* i : {"0", "1", "2"}) names.push_back(std::string(name) + i);
  auto all = for_all<SampleOf>(names, "over_cubes; over_lines; field; auto",
                               "it holds for any body, points, normal and impulse");
  all.letters.insert(1, "h ");
  all.given = {not_zero(Expression::letter("h")), not_zero(Expression::letter("m"))};
  Provables proved = table.proofs("6.5", all);
  for (const char* claim : {"6.5-linear_integral", "6.5-linear_mean", "6.5-angular_integral"})
    proof_of(proved, claim).says += ", the delta functions as wide as one likes";
  for (const char* claim : {"6.5-angular_integral", "6.5-angular_mean"})
    proof_of(proved, claim).says += ", the arms being those at the pulse's begin";
  proved.push_back(proof_of_finite_set(all, proof_of(proved, "6.5-segment").lemmas[0]));
  for (Provable& p : proved) p.preamble = coq_source({"means"});
  return proved;
}

}  // namespace oddity::ex06_05
